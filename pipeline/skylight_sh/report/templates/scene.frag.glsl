// A point of a surface: light of everywhere from the vertices, the sun through a soft shadow, the texture.
centroid in vec3 lit, albedo, facing, inShadowMap;
centroid in vec2 place;
flat in int material;
uniform mediump sampler2D paving;
uniform mediump sampler2DArray painted;
uniform highp sampler2DShadow shadows;
uniform vec3 sun, sunlight, ringColour;   // direction; irradiance / pi of a surface that faces it
uniform vec2 rings[5];
uniform float exposure;
out vec4 colour;

float unshaded() {
  if (any(lessThan(inShadowMap, vec3(0))) || any(greaterThan(inShadowMap, vec3(1)))) return 1.0;
  // Eight places of a spiral about the point, turned by a noise that differs from pixel to pixel.
  float turn = 6.2832 * fract(52.9829189 * fract(dot(gl_FragCoord.xy, vec2(0.06711056, 0.00583715))));
  float sum = 0.0;
  for (int i = 0; i < 8; ++i) {
    float angle = turn + 2.39996 * float(i);
    vec2 off = sqrt((float(i) + 0.5) / 8.0) * vec2(cos(angle), sin(angle)) * 1.9 / SHADOW_SIDE;
    sum += texture(shadows, inShadowMap + vec3(off, 0));
  }
  return sum / 8.0;
}

vec3 textured() {
  if (material == 1) return texture(paving, place).rgb;
  if (material < 6) return texture(painted, vec3(place, float(material - 2))).rgb;
  float inside = 0.0, blur = 0.7 * fwidth(place.y);
  for (int i = 0; i < 5; ++i) {
    inside += smoothstep(-blur, blur, place.y - rings[i].x) - smoothstep(-blur, blur, place.y - rings[i].y);
  }
  return mix(vec3(1), ringColour, inside);
}

void main() {
  vec3 sum = max(lit, 0.0);
  float cosine = dot(normalize(facing), sun);
  if (cosine > 0.0 && sunlight.g > 0.0) sum += sunlight * cosine * unshaded();
  vec3 reflected = albedo * sum;
  if (material > 0) reflected *= textured();
  colour = vec4(display(reflected * exposure), 1);
}
