import { BANDS, sinc } from "./example.mjs";
import { scaleZonal } from "./evaluate.mjs";

// Tames the ringing of the horizon in the first `bands` bands, in place, by the zonal window sinc(pi l / bands)
// (Habel et al. 2008, eq. 5).
export function applyWindow(weights, bands = BANDS) {
  scaleZonal(weights, Math.min(bands, BANDS), (l) => sinc(l / bands));
  return weights;
}
