// Types of Preetham sky (published constants, srgb). Written by skylight-sh 0.1.0 (CC0-1.0).

/** SH bands. */
export declare const BANDS: 7;
/** Weights a channel. */
export declare const WEIGHTS: 49;
export declare const CHANNELS: readonly ["red", "green", "blue"];
/** Of what the weights expand. */
export declare const UNIT: "cd/m2";
/** Weights, channel by channel: CHANNELS.length * WEIGHTS numbers a sun, index l * (l + 1) + m in a channel. */
export type Weights = Float32Array | Float64Array;
/** An input; angles are radians. */
export interface Axis {
  readonly name: string;
  readonly unit: string;
  readonly min: number;
  readonly max: number;
}
/** The inputs but the azimuth. */
export declare const AXES: readonly Axis[];
/** All inputs inside their ranges. */
export declare const OK: 0;
/** An input outside its range: evaluated at the range's end. */
export declare const CLAMPED: 1;
/** An input that is no number, or an infinite azimuth: all weights are 0. */
export declare const INVALID: 2;
export type Status = typeof OK | typeof CLAMPED | typeof INVALID;

/** Evaluates all bands; fills `weightsOut` where it is given. */
export declare function weights(
  sun_zenith: number, sun_azimuth: number, turbidity: number,
): Float32Array;
export declare function weights<Out extends Weights>(
  sun_zenith: number, sun_azimuth: number, turbidity: number,
  weightsOut: Out,
): Out;
/** Evaluates the first `bandCount` bands, 1 to BANDS; the others are 0. */
export declare function weightsBands(
  sun_zenith: number, sun_azimuth: number, turbidity: number, bandCount: number,
): Float32Array;
export declare function weightsBands<Out extends Weights>(
  sun_zenith: number, sun_azimuth: number, turbidity: number, bandCount: number,
  weightsOut: Out,
): Out;
/** Evaluates many suns: an array an input, all of one length; one sun's weights after another. */
export declare function weightsBatch(
  sun_zenith: ArrayLike<number>, sun_azimuth: ArrayLike<number>, turbidity: ArrayLike<number>,
): Float32Array;
export declare function weightsBatch<Out extends Weights>(
  sun_zenith: ArrayLike<number>, sun_azimuth: ArrayLike<number>, turbidity: ArrayLike<number>,
  weightsOut: Out,
): Out;
/** What an evaluation of these inputs meets. */
export declare function status(sun_zenith: number, sun_azimuth: number, turbidity: number): Status;
/** Multiplies weights by an exposure, in place. */
export declare function applyExposure<Out extends Weights>(weights: Out, exposure: number): Out;
/** Adds an even ground of this albedo, one a channel, below the horizon, in place, before any window. */
export declare function applyGround<Out extends Weights>(weights: Out, albedo: ArrayLike<number>): Out;
/** Tames the ringing of the horizon by the zonal window of the first `bands` bands, in place. */
export declare function applyWindow<Out extends Weights>(weights: Out, bands?: number): Out;
