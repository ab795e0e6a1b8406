import { channelProfile, classCount, firstCount, mirrored, otherCount, runProfile, step } from "./example.mjs";
import { BANDS, stream, width } from "./example.mjs";

// Whole numbers as Rice codes, low bit of each byte first.
function reader() {
  let at = 0;
  const bit = () => (stream[at >> 3] >> (at++ & 7)) & 1;
  const fixed = (size) => {
    let value = 0;
    for (let i = 0; i < size; ++i) value += bit() * 2 ** i;
    return value;
  };
  // Ones, a zero, `low` low bits; then folded back: 0, 1, 2, 3 -> 0, -1, 1, -2.
  const rice = (low) => {
    let high = 0;
    while (bit()) ++high;
    const folded = high * 2 ** low + fixed(low);
    return folded % 2 ? -(folded + 1) / 2 : folded / 2;
  };
  return { fixed, rice };
}

// Reads the stream once: store(run, i, column, number) for every number; a run is a class's of a product.
function decode(store) {
  const { fixed, rice } = reader();
  const profile = new Array(32).fill(0);
  const known = new Array(classCount * otherCount).fill(0);
  for (let l = 0, column = 0; l < BANDS; ++l) {
    const used = fixed(5);
    for (let i = 0; i < used; ++i) profile[i] = fixed(5);
    for (let m = mirrored ? 0 : -l; m <= l; ++m, ++column) {
      for (let k = 0; k < classCount; ++k) {
        runProfile.forEach((level, other) => {
          const run = k * otherCount + other;
          known[run] += rice(0);
          for (let i = 0; i < known[run]; ++i) {
            store(run, i, column, rice(Math.max(profile[i] + level + channelProfile[k], 0) >> 1));
          }
        });
      }
    }
  }
}

// The table's terms: how many each class keeps of each product, and a row of coefficients for each of them.
let terms = null;
export const readTerms = () => (terms ??= unpacked());

function unpacked() {
  const runs = classCount * otherCount;
  const lengths = new Uint8Array(runs), all = new Float64Array(runs * firstCount * width);
  decode((run, i, column, number) => {
    lengths[run] = Math.max(lengths[run], i + 1);
    all[(run * firstCount + i) * width + column] = number * step;
  });
  const rows = new Float64Array(lengths.reduce((sum, length) => sum + length, 0) * width);
  let end = 0;
  lengths.forEach((length, run) => {
    rows.set(all.subarray(run * firstCount * width, (run * firstCount + length) * width), end);
    end += length * width;
  });
  return { lengths, rows };
}

// Unpacks the table; without it the first evaluation does.
export function unpack() {
  readTerms();
}
