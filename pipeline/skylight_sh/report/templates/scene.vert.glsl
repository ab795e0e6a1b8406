// A vertex: its components of transfer times the frame's light are irradiance / pi, as compression.lit sums them.
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 2) in vec2 texturePlace;
layout(location = 3) in vec2 kind;        // place in the palette, material
layout(location = 4) in vec3 openLight;   // irradiance / pi where nothing shades, filled for that view alone
layout(location = 5) in vec4 first;       // sixteen components of transfer
layout(location = 6) in vec4 second;
layout(location = 7) in vec4 third;
layout(location = 8) in vec4 fourth;
uniform mat4 camera, towardsSun;
uniform vec3 light[17], palette[16];
uniform float open, texel;
// Within the triangle, or at its edges a steep light would be prolonged to below nothing.
centroid out vec3 lit, albedo, facing, inShadowMap;
centroid out vec2 place;
flat out int material;

vec3 summed(vec4 four, int at) {
  return four.x * light[at] + four.y * light[at + 1] + four.z * light[at + 2] + four.w * light[at + 3];
}

void main() {
  lit = mix(light[0] + summed(first, 1) + summed(second, 5) + summed(third, 9) + summed(fourth, 13), openLight, open);
  albedo = palette[int(kind.x)];
  material = int(kind.y);
  place = texturePlace;
  facing = normal;
  // A little off the surface, or it would shade itself.
  inShadowMap = (towardsSun * vec4(position + 1.5 * texel * normal, 1)).xyz * 0.5 + 0.5;
  gl_Position = camera * vec4(position, 1);
}
