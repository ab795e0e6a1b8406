import { WEIGHTS, channelCount, lowerHalf, reflected } from "./example.mjs";

// Adds an even ground of this albedo, one a channel, below the horizon, in place: lit by the sky, before any window.
// Its radiance is albedo E / pi, and E, the irradiance on it, a multiple of the weight l = 1, m = 0.
export function applyGround(weights, albedo) {
  for (let channel = 0; channel < channelCount; ++channel) {
    const start = channel * WEIGHTS, radiance = albedo[channel] * reflected * weights[start + 2];
    lowerHalf.forEach((weight, l) => { weights[start + l * (l + 1)] += radiance * weight; });
  }
  return weights;
}
