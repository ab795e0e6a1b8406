// Tone mapping as render/tone.py has it: Reinhard et al. 2002, eq. 4, on luminance; too bright colours made paler and darker.
const vec3 LUMINANCE = vec3(0.2126729, 0.7151522, 0.0721750);

vec3 display(vec3 linear) {
  vec3 scaled = max(linear, 0.0);
  float luminance = dot(scaled, LUMINANCE), mapped = luminance * (1.0 + luminance / 25.0) / (1.0 + luminance);
  vec3 hue = luminance > 0.0 ? scaled * (mapped / luminance) : vec3(0);
  float grey = min(mapped, 1.0), most = max(hue.r, max(hue.g, hue.b)), room = 1.0 - grey;
  float share = room > 0.0 ? (most - grey) / room : 0.0, over = max(share - 0.6, 0.0);
  float beyond = (min(share, 0.6) + 0.4 * (1.0 - exp(-over / 0.4))) * room;
  vec3 paler = most - grey > 1e-6 ? grey + (hue - grey) * (beyond / (most - grey)) : hue;
  vec3 darker = most > 0.0 ? hue * ((grey + beyond) / most) : hue;
  vec3 shown = clamp(0.5 * (paler + darker), 0.0, 1.0);
  return mix(12.92 * shown, 1.055 * pow(shown, vec3(1.0 / 2.4)) - 0.055, step(0.0031308, shown));
}
