import { axes, fade, real, twilight } from "./example.mjs";

// What `status` returns.
export const OK = 0, CLAMPED = 1, INVALID = 2;

// The status of inputs, one an axis, and an azimuth; where it is not INVALID, `x` holds the values within their
// ranges.
export function clampInputs(inputs, azimuth, x) {
  if (!Number.isFinite(azimuth)) return INVALID;
  let status = OK;
  for (let axis = 0; axis < axes.length; ++axis) {
    const { first, last, low, high } = axes[axis], value = Number(inputs[axis]);
    if (Number.isNaN(value)) return INVALID;
    if (value < first || value > last) status = CLAMPED;
    x[axis] = real(Math.min(Math.max(value, low), high));
  }
  return status;
}

// The share of the horizon's light that a sun below it leaves; 1 without twilight.
export function fadeOf(inputs) {
  if (!twilight) return 1;
  const depth = (inputs[twilight.axis] - axes[twilight.axis].high) / twilight.depth;
  return fade(Math.min(Math.max(depth, 0), 1));
}
