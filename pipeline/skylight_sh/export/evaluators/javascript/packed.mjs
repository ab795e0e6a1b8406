import { channelCount, channelProfile, mirrored, runProfile, step, stream } from "./example.mjs";

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

// Calls store(channel, l, m, value) for every weight of the first `bands` bands: reads the stream once, forward.
export function combine(first, others, bands, store) {
  const { fixed, rice } = reader();
  const profile = new Array(32).fill(0);
  const known = channelProfile.map(() => runProfile.map(() => 0));
  for (let l = 0; l < bands; ++l) {
    const used = fixed(5);
    for (let i = 0; i < used; ++i) profile[i] = fixed(5);
    for (let m = mirrored ? 0 : -l; m <= l; ++m) {
      for (let channel = 0; channel < channelCount; ++channel) {
        let value = 0;
        runProfile.forEach((level, other) => {
          known[channel][other] += rice(0);
          let sum = 0;
          for (let i = 0; i < known[channel][other]; ++i) {
            sum += first[i] * rice(Math.max(profile[i] + level + channelProfile[channel], 0) >> 1);
          }
          value += sum * others[other];
        });
        store(channel, l, m, value * step);
      }
    }
  }
}
