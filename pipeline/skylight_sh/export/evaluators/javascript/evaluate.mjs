import { BANDS, WEIGHTS, channelCount, classCount, degrees, firstCount, mirrored } from "./example.mjs";
import { mixed, otherCount, peak, surroundings, width, windowed } from "./example.mjs";
import { axes, factorsOf, firstFunctions, otherFunctions, sinc, turn, wavesOf } from "./example.mjs";
import { INVALID, clampInputs, fadeOf } from "./inputs.mjs";
import { readTerms } from "./rows.mjs";

// What one evaluation works with, made once.
const x = new Float64Array(axes.length), first = new Float64Array(firstCount), others = new Float64Array(otherCount);
const factors = new Float64Array(mixed ? channelCount * classCount : 1), sums = new Float64Array(classCount * width);
const cosines = new Float64Array(BANDS), sines = new Float64Array(BANDS);
const found = new Float64Array(channelCount * WEIGHTS);

// Fills the first `used` sums of each class: each term's row times its product of functions.
function addTerms(used) {
  const { lengths, rows } = readTerms();
  sums.fill(0);
  for (let k = 0, run = 0, row = 0; k < classCount; ++k) {
    const start = k * width;
    for (let other = 0; other < otherCount; ++other, ++run) {
      for (let i = 0; i < lengths[run]; ++i, row += width) {
        const product = first[i] * others[other];
        for (let column = 0; column < used; ++column) sums[start + column] += product * rows[row + column];
      }
    }
  }
}

// A channel's weight of one column of sums.
function mix(channel, column) {
  if (!mixed) return factors[0] * sums[channel * width + column];
  let value = 0;
  for (let k = 0; k < classCount; ++k) value += factors[channel * classCount + k] * sums[k * width + column];
  return value;
}

// Fills `found` with the weights of the first `bands` bands, turned by the azimuth (Habel et al. 2008, eq. 4).
function turnSums(bands) {
  found.fill(0);
  for (let channel = 0; channel < channelCount; ++channel) {
    let column = 0;
    for (const l of degrees) {
      if (l >= bands) break;
      const middle = channel * WEIGHTS + l * (l + 1), zonal = mirrored ? column : column + l;
      found[middle] = mix(channel, zonal);
      for (let m = 1; m <= l; ++m) {
        const minus = mirrored ? 0 : mix(channel, zonal - m);
        const [plus, partner] = turn(mix(channel, zonal + m), minus, cosines[m], sines[m]);
        found[middle + m] = plus;
        found[middle - m] = partner;
      }
      column = zonal + l + 1;
    }
  }
}

// The scene's surroundings: a linear map, what shines of itself, the ground.
function surround() {
  const { transfer, own, below } = surroundings;
  for (let start = 0; start < found.length; start += WEIGHTS) {
    const before = found.slice(start, start + WEIGHTS);
    const out = before.map((value, i) => {
      if (!transfer.length) return value;
      let sum = 0;
      for (let j = 0; j < WEIGHTS; ++j) sum += transfer[i * WEIGHTS + j] * before[j];
      return sum;
    });
    if (own.length) for (let i = 0; i < WEIGHTS; ++i) out[i] += own[start + i];
    const fallen = out[2];
    if (below.length) for (let i = 0; i < WEIGHTS; ++i) out[i] += below[start + i] * fallen;
    found.set(out, start);
  }
}

// Multiplies the zonal weights of degrees 1 to bands - 1 by factor(l).
export function scaleZonal(weights, bands, factor) {
  for (let start = 0; start < weights.length; start += WEIGHTS) {
    for (let l = 1; l < bands; ++l) weights[start + l * (l + 1)] *= factor(l);
  }
}

// Fills `out` from place `at` on with the first bands, 1 to BANDS, the others 0; returns the status.
export function evaluateTable(inputs, azimuth, asked, out, at = 0) {
  const bands = Math.min(Math.max(Math.trunc(asked), 1), BANDS);
  const status = clampInputs(inputs, azimuth, x);
  out.fill(0, at, at + channelCount * WEIGHTS);
  if (status === INVALID) return status;
  const share = fadeOf(inputs);
  // All bands where surroundings carry light from one to another.
  const read = surroundings ? BANDS : bands;
  const used = degrees.reduce((sum, l) => sum + (l < read ? (mirrored ? l + 1 : 2 * l + 1) : 0), 0);
  firstFunctions(x, first);
  otherFunctions(x, others);
  factorsOf(x, factors);
  for (let k = 0; k < factors.length; ++k) factors[k] *= share;
  wavesOf(azimuth, peak < 0 ? 1 : Math.sin(x[peak]), cosines, sines);
  addTerms(used);
  turnSums(read);
  if (surroundings) surround();
  // The window follows the number of bands.
  if (windowed && bands < BANDS) scaleZonal(found, bands, (l) => sinc(l / bands) / sinc(l / BANDS));
  for (let start = 0; start < found.length; start += WEIGHTS) {
    for (let i = 0; i < bands * bands; ++i) out[at + start + i] = found[start + i];
  }
  return status;
}

// Multiplies weights by an exposure, in place.
export function applyExposure(weights, exposure) {
  for (let i = 0; i < weights.length; ++i) weights[i] *= exposure;
  return weights;
}
