// The sky where no surface is: the Preetham formula, or the SH expansion where the page has no formula; and the sun's disc.
in vec3 along;
uniform vec3 sun, disc, zenith, perez[5], weights[WEIGHTS];   // of Y, x and y: A to E, and the zenith's values over F
uniform mat3 toRgb;
uniform float exposure, halfAngle;
uniform bool exact;
out vec4 colour;

vec3 formula(vec3 d) {
  float angle = acos(clamp(dot(d, sun), -1.0, 1.0)), square = cos(angle) * cos(angle);
  vec3 shape = (1.0 + perez[0] * exp(perez[1] / max(d.z, 1e-4))) * (1.0 + perez[2] * exp(perez[3] * angle) + perez[4] * square);
  vec3 value = zenith * shape;
  return toRgb * vec3(value.y / value.z * value.x, value.x, (1.0 - value.y - value.z) / value.z * value.x);
}

// Sums weights times the basis, order by order, by the recurrence in the degree.
vec3 expansion(vec3 d) {
  vec3 sum = vec3(0);
  float cosine = 1.0, sine = 0.0, start = 0.2820948;
  for (int m = 0; m < BANDS; ++m) {
    float before = 0.0, now = start;
    for (int l = m; l < BANDS; ++l) {
      vec3 both = weights[l * (l + 1) + m] * cosine;
      if (m > 0) both += weights[l * (l + 1) - m] * sine;
      sum += both * now;
      float next = float(l + 1), order = float(m * m), a = sqrt((4.0 * next * next - 1.0) / (next * next - order));
      float b = sqrt((float(l * l) - order) / (4.0 * float(l * l) - 1.0 + float(l == 0)));
      float later = a * (d.z * now - (l > m ? b : 0.0) * before);
      before = now;
      now = later;
    }
    float turned = cosine * d.x - sine * d.y;
    sine = cosine * d.y + sine * d.x;
    cosine = turned;
    start *= sqrt((m == 0 ? 2.0 : 1.0) * (2.0 * float(m) + 3.0) / (2.0 * float(m) + 2.0));
  }
  return sum;
}

void main() {
  vec3 d = normalize(along);
  if (d.z < 0.0) d.z = -d.z;
  vec3 radiance = exact ? formula(d) : expansion(d);
  if (halfAngle > 0.0 && dot(d, sun) > cos(halfAngle)) radiance = disc;
  colour = vec4(display(radiance * exposure), 1);
}
