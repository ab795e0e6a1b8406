import { BANDS, WEIGHTS, channelCount, firstCount, mirrored, otherCount, surroundings, windowed } from "./example.mjs";
import { axes, firstFunctions, otherFunctions, scaleOf, sinc, turn, wavesOf } from "./example.mjs";
import { INVALID, clampInputs, fadeOf } from "./inputs.mjs";
import { combine } from "./rows.mjs";

// Turns the weights of all orders by the azimuth (Habel et al. 2008, eq. 4).
function turnAll(weights, bands, cosines, sines) {
  for (let channel = 0; channel < channelCount; ++channel) {
    for (let l = 1; l < bands; ++l) {
      const middle = channel * WEIGHTS + l * (l + 1);
      for (let m = 1; m <= l; ++m) {
        const [plus, minus] = turn(weights[middle + m], weights[middle - m], cosines[m], sines[m]);
        weights[middle + m] = plus;
        weights[middle - m] = minus;
      }
    }
  }
}

// The scene's surroundings: a linear map, what shines of itself, the ground.
function surround(weights) {
  const { transfer, own, below } = surroundings;
  for (let start = 0; start < weights.length; start += WEIGHTS) {
    const found = weights.slice(start, start + WEIGHTS);
    const out = found.map((value, i) => {
      if (!transfer.length) return value;
      let sum = 0;
      for (let j = 0; j < WEIGHTS; ++j) sum += transfer[i * WEIGHTS + j] * found[j];
      return sum;
    });
    if (own.length) for (let i = 0; i < WEIGHTS; ++i) out[i] += own[start + i];
    const fallen = out[2];
    if (below.length) for (let i = 0; i < WEIGHTS; ++i) out[i] += below[start + i] * fallen;
    weights.set(out, start);
  }
}

// Multiplies the zonal weights of degrees 1 to bands - 1 by factor(l).
function scaleZonal(weights, bands, factor) {
  for (let start = 0; start < weights.length; start += WEIGHTS) {
    for (let l = 1; l < bands; ++l) weights[start + l * (l + 1)] *= factor(l);
  }
}

// Fills `out` with the first bands, 1 to BANDS, the others 0; returns the status.
export function evaluateTable(inputs, azimuth, asked, out) {
  const bands = Math.min(Math.max(Math.trunc(asked), 1), BANDS);
  const x = new Float64Array(axes.length), weights = new Float64Array(channelCount * WEIGHTS);
  const status = clampInputs(inputs, azimuth, x);
  out.fill(0);
  if (status === INVALID) return status;
  const first = new Float64Array(firstCount), others = new Float64Array(otherCount);
  const cosines = new Float64Array(BANDS), sines = new Float64Array(BANDS);
  const scale = scaleOf(x) * fadeOf(inputs);
  // All bands where surroundings carry light from one to another.
  const read = surroundings ? BANDS : bands;
  firstFunctions(x, first);
  otherFunctions(x, others);
  wavesOf(azimuth, cosines, sines);
  combine(first, others, read, (channel, l, m, value) => {
    const middle = channel * WEIGHTS + l * (l + 1), scaled = value * scale;
    if (mirrored) weights[middle - m] = scaled * sines[m];
    weights[middle + m] = mirrored ? scaled * cosines[m] : scaled;
  });
  if (!mirrored) turnAll(weights, read, cosines, sines);
  if (surroundings) surround(weights);
  // The window follows the number of bands.
  if (windowed && bands < BANDS) {
    scaleZonal(weights, bands, (l) => sinc(l / bands) / sinc(l / BANDS));
  }
  for (let start = 0; start < weights.length; start += WEIGHTS) {
    out.set(weights.subarray(start, start + bands * bands), start);
  }
  return status;
}

// Tames the ringing of the horizon in the first `bands` bands, in place, by the zonal window sinc(pi l / bands)
// (Habel et al. 2008, eq. 5).
export function applyWindow(weights, bands = BANDS) {
  scaleZonal(weights, Math.min(bands, BANDS), (l) => sinc(l / bands));
  return weights;
}
