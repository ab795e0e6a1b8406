// Behind everything: one triangle over the whole picture.
uniform vec3 ahead, across, upward;
out vec3 along;

void main() {
  vec2 corner = vec2(gl_VertexID == 1 ? 3 : -1, gl_VertexID == 2 ? 3 : -1);
  along = ahead + corner.x * across + corner.y * upward;
  gl_Position = vec4(corner, 1, 1);
}
