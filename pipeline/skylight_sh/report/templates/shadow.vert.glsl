layout(location = 0) in vec3 position;
uniform mat4 towardsSun;

void main() {
  gl_Position = towardsSun * vec4(position, 1);
}
