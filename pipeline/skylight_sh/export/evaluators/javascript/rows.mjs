import { BANDS, channelCount, columns, lengths, mirrored, rows, width } from "./example.mjs";

// Calls store(channel, l, m, value) for every weight of the first `bands` bands: sums of the table's rows.
export function combine(first, others, bands, store) {
  const sums = new Float64Array(width);
  let row = 0;
  lengths.forEach((length, other) => {
    for (let i = 0; i < length; ++i, row += width) {
      const product = first[i] * others[other];
      for (let k = 0; k < width; ++k) sums[k] += product * rows[row + k];
    }
  });
  const count = columns.length / channelCount;
  for (let l = 0, place = 0; l < BANDS; ++l) {
    for (let m = mirrored ? 0 : -l; m <= l; ++m, ++place) {
      for (let channel = 0; l < bands && channel < channelCount; ++channel) {
        const column = columns[channel * count + place];
        store(channel, l, m, column < 0 ? 0 : sums[column]);
      }
    }
  }
}
