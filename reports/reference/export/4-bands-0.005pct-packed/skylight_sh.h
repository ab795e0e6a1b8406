/* Preetham sky (published constants, srgb): spherical-harmonics weights, evaluated from
 * polynomials.
 *
 * Written by skylight-sh 0.1.0; the table and this code may be used by anyone for anything
 * (CC0-1.0).
 * C99 and C++11, no allocation, no global written, nothing static but constants: any thread may
 * call it.
 *
 * Usage
 *   float
 *   w[SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_CHANNELS][SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_WEIGHTS];
 *   int status = skylight_sh_4_bands_0_005pct_packed_weights(0.785000026f, 0.0f, 4.25f, w);
 * Compile with, for instance
 *   cc -std=c99 -O3 program.c -o program -lm
 * Included plainly, the file is all there is: its functions are static, and the table stands in
 * every unit that includes it. With SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_EXTERN defined before it,
 * it declares only; the one unit that also defines
 * SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_IMPLEMENTATION holds functions and table, for C and C++.
 *
 * Inputs
 *   sun_zenith: [0, 1.57079633] rad
 *   turbidity: [2.5, 6]
 *   sun_azimuth: any finite angle, rad
 * Output
 *   w[channel][l*(l+1)+m], channels red, green, blue: linear radiance, luminance-scaled cd/m2. Real
 *   orthonormal spherical harmonics without the Condon-Shortley sign, z up, m > 0 cosine, m < 0
 *   sine; the azimuth turns from +x towards +y. Below the horizon: black. Returns 0; 1 where an
 *   input lay outside its range and was clamped; 2 (weights zeroed) where one was NaN or the
 *   azimuth infinite.
 *   The glow about the sun is in the weights, its disc is not: with a disc of your own, add no
 *   halo.
 *   Define SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_EXPOSURE before this file (where it holds the table)
 *   to multiply all weights (1 by default).
 *
 * Accuracy, as shipped: E_mean 0.00452 %, E_max 0.0118 % of the least luminance of the same sky, at
 * azimuth 0.
 * The expansion rings: the least value it takes, over all directions and measured sets, is -12.5 %
 * of its largest in the same set; the window below tames it.
 * Memory: 2278 bytes of constants, packed into few bytes (a fast table takes more and less time).
 *
 * Provenance
 *   skylight-sh 0.1.0, config preetham 7738be1e848979ca, table 4-bands-0.005pct-packed
 */
#ifdef __cplusplus
#if __cplusplus < 201103L && !defined(_MSC_VER)
#error "skylight_sh needs C++11 or later: compile with -std=c++11."
#endif
#elif (!defined(__STDC_VERSION__) || __STDC_VERSION__ < 199901L) && !defined(_MSC_VER)
#error "skylight_sh needs C99 or later: compile with -std=c99."
#endif
#if defined(SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_IMPLEMENTATION) && \
    !defined(SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_EXTERN)
#error "Define SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_EXTERN in every unit, \
SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_IMPLEMENTATION beside it in one."
#endif
#if defined(SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_API) && \
    defined(SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_EXTERN) && \
    !defined(SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_DECLARED)
#error "Define SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_EXTERN before this file is included for the \
first time."
#endif
#if defined(SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_DECLARED) && \
    !defined(SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_EXTERN)
#error "Leave SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_EXTERN defined: this file was included with it \
before."
#endif

#ifndef SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_H
#define SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_H 0x33854719

#include <math.h>
#include <stdint.h>
#include <string.h>

#ifndef SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_EXTERN
#define SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_API static inline
#else
#define SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_DECLARED
#ifdef __cplusplus
#define SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_API extern "C"
#else
#define SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_API extern
#endif
#endif
#ifndef SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_EXPOSURE
#define SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_EXPOSURE 1
#endif

#define SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_VERSION "0.1.0"
#define SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_BANDS 4
#define SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_WEIGHTS 16
#define SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_CHANNELS 3
#define SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_AXES 2
#define SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_UNIT "cd/m2"
#define SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_E_MEAN 4.522000e-05
#define SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_E_MAX 1.180000e-04
#define SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_SUN_ZENITH_MIN 0.0f
#define SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_SUN_ZENITH_MAX 1.57079637f
#define SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_TURBIDITY_MIN 2.5f
#define SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_TURBIDITY_MAX 6.0f

/* Evaluates all bands. */
SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_API int skylight_sh_4_bands_0_005pct_packed_weights(float
    sun_zenith, float sun_azimuth, float turbidity,
    float
    weights[SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_CHANNELS]
    [SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_WEIGHTS]);
/* Evaluates the first `bands` bands (1 to SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_BANDS, clamped
   likewise) and zeroes the rest. */
SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_API int skylight_sh_4_bands_0_005pct_packed_weights_bands(float
    sun_zenith, float sun_azimuth, float turbidity, int bands,
    float
    weights[SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_CHANNELS]
    [SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_WEIGHTS]);
/* Evaluates `count` suns from arrays; returns the largest status. No faster
   than single calls. */
SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_API int skylight_sh_4_bands_0_005pct_packed_weights_batch(int
    count, const float *sun_zenith, const float *sun_azimuth, const float *turbidity,
    float
    (*weights)[SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_CHANNELS]
    [SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_WEIGHTS]);
/* Evaluates all bands and their derivatives after each axis (sun_zenith,
   turbidity), per unit of the axis; beyond a range, those at its edge. */
SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_API int
    skylight_sh_4_bands_0_005pct_packed_weights_gradient(float sun_zenith, float sun_azimuth,
    float turbidity, float
    weights[SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_CHANNELS]
    [SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_WEIGHTS],
    float
    gradient[SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_AXES][SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_CHANNELS]
    [SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_WEIGHTS]);
/* Unit vector of the dominant light. Returns 0, or 1 (and straight up) where there is none. */
#define skylight_sh_4_bands_0_005pct_packed_dominant(weights, direction) \
    skylight_sh_4_bands_0_005pct_packed_dominant_of(&(weights)[0][0], direction)
SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_API int skylight_sh_4_bands_0_005pct_packed_dominant_of(const
    float *weights, float direction[3]);
/* Optional: adds an even ground of this albedo below the horizon, lit by the sky (before any
 * window). */
SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_API void skylight_sh_4_bands_0_005pct_packed_ground(const float
    albedo[SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_CHANNELS],
    float
    weights[SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_CHANNELS]
    [SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_WEIGHTS]);
/* Optional: tames the ringing of the horizon by the zonal window of the first `bands` bands. */
SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_API void skylight_sh_4_bands_0_005pct_packed_window(int bands,
    float
    weights[SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_CHANNELS]
    [SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_WEIGHTS]);

#elif SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_H != 0x33854719
#error "Another table has the prefix skylight_sh_4_bands_0_005pct_packed_4_bands_0_005pct_packed \
already: export one of them under a prefix of its own."
#endif /* SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_H */

#if (!defined(SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_EXTERN) || \
    defined(SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_IMPLEMENTATION)) && \
    !defined(SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_DEFINED)
#define SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_DEFINED

typedef float skylight_sh_4_bands_0_005pct_packed_real;

/* Functions of the first axis, in fours; products of the other axes'
   functions. */
#define SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_FIRST 12
#define SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_OTHERS 8
#define SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_SIZES { 12, 8 }
#define SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_MOST 12
#define SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_AZIMUTH 0.0f
/* The channels' luminance. */
#define SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_LUMINANCE { 0.212672845f, 0.715152144f, 0.0721749961f }
/* What an even ground reflects of the weight l = 1, m = 0, and its own
   zonal weights. */
#define SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_REFLECTED 0.651470006f
#define SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_LOWER { 1.7724539f, -1.53499007f, 0.0f, 0.586184025f }

/* Of each axis: the first and last float that counts as inside, and its
   range. */
static const float
    skylight_sh_4_bands_0_005pct_packed_inside[SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_AXES][2] = { {
    -1.57079626e-06f, 1.5707978f }, { 2.49999666f, 6.00000334f } };
static const skylight_sh_4_bands_0_005pct_packed_real
    skylight_sh_4_bands_0_005pct_packed_range[SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_AXES][2] = { {
    0.0f, 1.57079637f }, { 2.5f, 6.0f } };

/* Runs of numbers, one a product of the other axes' functions, and their
   profiles; what one step is worth. */
#define SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_RUNS 8
#define SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_RUN_PROFILE { 10, 8, 4, -2, -8, -14, -18, -20 }
#define SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_CHANNEL_PROFILE { -9, -9, -6 }
#define SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_STEP 4.17232513e-06f

/* Whole numbers as Rice codes. */
static const unsigned char skylight_sh_4_bands_0_005pct_packed_stream[2083] = {
    236, 255, 174, 53, 133, 78, 145, 0, 254, 255, 127, 255, 255, 17, 2, 204, 194, 205, 29, 105, 185,
    71, 80, 138, 63, 224, 156, 222, 156, 255, 255, 247, 63, 225, 15, 145, 84, 249, 232, 110, 63, 20,
    150, 171, 105, 227, 65, 255, 255, 159, 216, 195, 245, 245, 96, 75, 33, 176, 150, 85, 103, 232,
    255, 127, 79, 172, 9, 208, 49, 49, 43, 48, 159, 239, 255, 223, 79, 149, 108, 27, 6, 71, 191,
    255, 227, 233, 229, 247, 231, 216, 157, 255, 255, 223, 255, 255, 81, 74, 85, 40, 90, 124, 66,
    38, 195, 27, 128, 46, 133, 7, 65, 254, 255, 223, 127, 212, 182, 59, 231, 104, 137, 134, 20, 162,
    196, 135, 18, 0, 145, 255, 127, 55, 216, 220, 65, 28, 74, 120, 45, 234, 5, 232, 255, 191, 249,
    9, 2, 66, 48, 220, 194, 225, 255, 30, 169, 51, 106, 108, 254, 247, 159, 110, 195, 227, 239, 71,
    103, 243, 255, 255, 239, 255, 249, 179, 120, 183, 69, 183, 247, 102, 176, 193, 228, 221, 209,
    152, 69, 55, 248, 142, 250, 255, 255, 119, 98, 147, 59, 56, 140, 196, 55, 17, 181, 119, 197,
    145, 82, 74, 127, 195, 68, 254, 255, 223, 119, 130, 228, 232, 14, 62, 176, 53, 21, 63, 56, 180,
    173, 116, 254, 255, 159, 123, 176, 125, 139, 221, 252, 240, 179, 110, 151, 159, 254, 255, 17,
    224, 210, 229, 77, 83, 191, 237, 239, 255, 133, 189, 246, 151, 211, 223, 255, 0, 116, 231, 31,
    64, 236, 255, 174, 49, 149, 77, 153, 17, 250, 255, 232, 74, 180, 19, 139, 60, 176, 248, 10, 52,
    40, 60, 130, 80, 209, 255, 8, 61, 53, 2, 10, 55, 10, 137, 25, 181, 156, 110, 29, 195, 38, 173,
    17, 185, 21, 230, 46, 59, 84, 23, 67, 12, 59, 211, 47, 67, 123, 137, 101, 178, 252, 124, 247,
    193, 147, 237, 152, 180, 121, 255, 163, 120, 159, 252, 25, 117, 250, 255, 231, 208, 123, 111,
    233, 98, 118, 51, 26, 6, 149, 153, 74, 25, 48, 214, 255, 193, 88, 46, 194, 15, 242, 152, 11,
    246, 47, 156, 92, 80, 208, 174, 70, 193, 58, 244, 202, 31, 206, 34, 33, 133, 96, 145, 141, 70,
    24, 169, 34, 170, 39, 51, 39, 164, 230, 31, 111, 240, 212, 143, 50, 253, 159, 11, 225, 47, 190,
    83, 71, 120, 144, 157, 225, 2, 21, 37, 242, 56, 128, 84, 233, 62, 165, 186, 27, 184, 202, 215,
    50, 163, 104, 9, 139, 39, 217, 175, 83, 28, 238, 203, 2, 167, 209, 36, 187, 201, 82, 73, 31,
    100, 15, 247, 195, 72, 47, 142, 185, 109, 114, 183, 159, 143, 120, 163, 254, 4, 32, 187, 194,
    239, 255, 217, 191, 212, 255, 94, 94, 43, 191, 255, 241, 159, 97, 209, 125, 127, 239, 71, 95,
    252, 20, 192, 95, 143, 104, 245, 65, 125, 132, 93, 58, 120, 208, 144, 217, 9, 148, 71, 199, 186,
    39, 196, 196, 197, 226, 176, 183, 173, 13, 134, 8, 11, 252, 15, 58, 54, 5, 84, 72, 149, 195,
    113, 27, 30, 35, 197, 196, 93, 37, 241, 144, 235, 77, 148, 187, 168, 202, 83, 29, 31, 149, 54,
    50, 159, 83, 207, 57, 43, 188, 100, 26, 91, 132, 95, 73, 5, 166, 11, 72, 27, 89, 129, 181, 120,
    159, 195, 100, 16, 153, 219, 39, 73, 201, 168, 72, 97, 229, 4, 209, 16, 40, 71, 1, 102, 196,
    113, 149, 243, 28, 181, 115, 229, 209, 30, 25, 142, 35, 75, 92, 1, 166, 185, 140, 244, 9, 222,
    93, 215, 2, 198, 190, 29, 116, 96, 0, 108, 156, 30, 5, 163, 3, 174, 103, 117, 64, 90, 40, 53,
    208, 150, 220, 109, 146, 38, 165, 215, 142, 20, 237, 232, 132, 128, 186, 181, 147, 126, 192,
    210, 219, 46, 6, 52, 129, 41, 135, 245, 47, 134, 195, 150, 175, 51, 34, 52, 136, 121, 19, 225,
    245, 251, 3, 4, 219, 18, 129, 216, 255, 125, 99, 42, 157, 50, 67, 216, 221, 233, 23, 197, 28,
    215, 98, 96, 123, 179, 172, 31, 111, 93, 41, 181, 13, 183, 183, 192, 123, 202, 70, 88, 180, 45,
    111, 5, 229, 49, 85, 147, 121, 112, 98, 41, 174, 159, 195, 179, 31, 155, 191, 102, 241, 170, 66,
    119, 164, 232, 94, 177, 15, 6, 201, 144, 188, 12, 104, 25, 87, 192, 0, 227, 107, 139, 137, 210,
    57, 119, 110, 3, 207, 49, 20, 84, 89, 247, 89, 143, 151, 247, 77, 69, 64, 122, 151, 239, 144,
    211, 86, 226, 226, 1, 101, 16, 237, 109, 13, 200, 73, 20, 79, 37, 247, 108, 24, 9, 233, 42, 72,
    23, 246, 161, 134, 19, 170, 2, 102, 218, 96, 194, 224, 182, 246, 57, 238, 206, 48, 98, 245, 89,
    62, 20, 212, 209, 50, 135, 200, 163, 131, 222, 201, 157, 249, 131, 201, 65, 213, 157, 44, 80,
    180, 185, 132, 180, 214, 60, 155, 138, 39, 188, 232, 25, 221, 201, 100, 31, 218, 185, 115, 239,
    157, 0, 48, 162, 105, 150, 203, 197, 51, 55, 120, 160, 139, 109, 124, 236, 107, 188, 94, 0, 112,
    229, 252, 187, 36, 254, 62, 158, 179, 65, 219, 125, 17, 183, 24, 174, 180, 175, 8, 208, 236,
    177, 211, 54, 231, 248, 124, 199, 64, 148, 102, 68, 232, 193, 58, 82, 70, 42, 141, 134, 58, 195,
    197, 170, 141, 42, 232, 138, 115, 124, 197, 82, 32, 202, 210, 14, 48, 9, 220, 111, 148, 192, 61,
    94, 68, 119, 50, 108, 203, 212, 211, 45, 141, 42, 240, 203, 140, 141, 89, 138, 113, 54, 35, 231,
    218, 140, 185, 255, 120, 97, 183, 157, 14, 141, 120, 201, 13, 74, 74, 130, 168, 163, 196, 56,
    204, 223, 44, 188, 94, 220, 120, 86, 128, 192, 234, 28, 52, 37, 24, 83, 251, 241, 113, 66, 128,
    64, 48, 70, 62, 48, 140, 130, 22, 251, 26, 119, 79, 59, 32, 4, 194, 183, 61, 83, 200, 192, 72,
    88, 50, 242, 210, 64, 0, 116, 122, 83, 110, 101, 252, 38, 63, 177, 84, 173, 226, 195, 218, 99,
    136, 44, 243, 109, 29, 74, 41, 200, 82, 116, 251, 197, 243, 146, 23, 0, 99, 70, 237, 83, 60,
    238, 77, 250, 19, 7, 24, 170, 29, 241, 240, 253, 111, 132, 96, 61, 244, 4, 160, 127, 39, 74,
    124, 168, 182, 205, 32, 151, 216, 66, 250, 32, 32, 31, 157, 137, 57, 165, 11, 75, 46, 209, 189,
    85, 206, 24, 12, 34, 42, 191, 59, 202, 57, 130, 66, 28, 109, 2, 26, 235, 24, 156, 244, 81, 163,
    30, 27, 5, 241, 43, 140, 115, 138, 140, 153, 82, 136, 83, 128, 48, 146, 141, 118, 117, 144, 91,
    149, 138, 235, 164, 35, 121, 60, 193, 194, 233, 48, 220, 16, 141, 25, 185, 49, 1, 20, 116, 123,
    164, 31, 162, 66, 189, 196, 148, 167, 246, 84, 221, 188, 38, 188, 48, 24, 2, 19, 12, 153, 82,
    15, 50, 145, 86, 135, 192, 129, 88, 139, 145, 5, 197, 211, 244, 130, 245, 71, 39, 236, 24, 183,
    195, 112, 220, 85, 53, 84, 69, 146, 70, 226, 89, 133, 165, 135, 151, 12, 1, 180, 112, 100, 68,
    111, 214, 145, 146, 207, 35, 195, 166, 19, 31, 129, 39, 35, 13, 197, 42, 199, 44, 196, 34, 47,
    211, 1, 77, 85, 239, 103, 115, 225, 67, 196, 129, 81, 219, 71, 0, 198, 254, 176, 223, 119, 190,
    85, 58, 134, 136, 184, 223, 184, 205, 127, 55, 215, 79, 81, 121, 134, 231, 173, 56, 11, 83, 222,
    40, 69, 110, 81, 154, 239, 90, 255, 188, 194, 97, 220, 251, 61, 9, 39, 200, 89, 128, 137, 109,
    10, 234, 228, 22, 5, 129, 169, 34, 69, 108, 79, 23, 162, 164, 125, 48, 135, 181, 140, 125, 55,
    115, 167, 102, 235, 123, 177, 30, 231, 214, 221, 244, 11, 112, 248, 13, 190, 127, 88, 207, 220,
    254, 119, 152, 105, 54, 38, 43, 229, 72, 228, 44, 247, 80, 157, 255, 98, 71, 119, 184, 49, 6,
    239, 154, 136, 46, 245, 126, 78, 179, 191, 23, 238, 92, 219, 105, 52, 24, 55, 234, 36, 47, 65,
    108, 80, 181, 156, 89, 246, 208, 86, 201, 158, 221, 169, 58, 159, 180, 147, 167, 13, 44, 127,
    232, 192, 188, 201, 87, 127, 179, 177, 116, 162, 187, 88, 182, 129, 165, 44, 72, 167, 114, 41,
    42, 99, 133, 97, 211, 244, 119, 48, 20, 212, 151, 163, 152, 209, 184, 187, 146, 216, 169, 40,
    85, 175, 65, 241, 85, 215, 152, 211, 2, 254, 49, 234, 221, 157, 252, 248, 74, 21, 115, 56, 197,
    241, 245, 112, 143, 130, 198, 115, 255, 130, 152, 39, 153, 236, 251, 103, 127, 253, 254, 127,
    116, 22, 191, 95, 171, 178, 214, 85, 196, 218, 5, 182, 168, 177, 125, 193, 253, 39, 96, 254,
    114, 47, 132, 112, 174, 177, 177, 57, 103, 36, 6, 217, 139, 59, 47, 236, 250, 207, 151, 251, 86,
    10, 213, 8, 72, 51, 81, 236, 216, 3, 162, 73, 8, 106, 17, 175, 57, 54, 42, 121, 111, 144, 240,
    181, 149, 255, 81, 61, 137, 123, 195, 59, 35, 13, 101, 188, 22, 206, 77, 251, 115, 107, 242, 33,
    247, 162, 85, 200, 15, 178, 201, 13, 205, 155, 12, 118, 70, 254, 55, 3, 22, 163, 112, 246, 174,
    60, 112, 57, 154, 139, 132, 4, 110, 238, 67, 137, 75, 236, 0, 162, 33, 198, 176, 125, 33, 1,
    183, 181, 248, 124, 206, 254, 218, 202, 54, 240, 36, 210, 180, 10, 143, 98, 182, 60, 194, 138,
    146, 240, 255, 178, 128, 69, 198, 230, 237, 84, 26, 183, 226, 162, 197, 118, 39, 204, 215, 50,
    14, 76, 132, 168, 219, 210, 211, 101, 182, 144, 155, 130, 165, 143, 203, 124, 239, 243, 241, 65,
    130, 88, 176, 113, 12, 175, 255, 5, 1, 142, 211, 159, 27, 33, 252, 3, 226, 125, 103, 218, 37,
    130, 167, 65, 162, 167, 53, 179, 155, 21, 216, 49, 206, 252, 70, 127, 247, 116, 214, 116, 227,
    138, 80, 89, 48, 173, 81, 55, 131, 58, 44, 68, 102, 39, 197, 195, 134, 35, 138, 5, 116, 114, 69,
    152, 3, 3, 104, 184, 196, 34, 224, 52, 98, 167, 185, 246, 191, 92, 170, 187, 250, 188, 173, 52,
    201, 159, 86, 15, 163, 57, 36, 87, 44, 30, 241, 230, 137, 164, 213, 141, 13, 117, 121, 197, 155,
    198, 115, 54, 38, 255, 122, 146, 138, 68, 38, 251, 0, 17, 138, 121, 79, 56, 108, 63, 57, 55, 70,
    145, 177, 37, 134, 21, 145, 237, 72, 79, 47, 183, 101, 79, 57, 107, 210, 208, 248, 57, 225, 252,
    148, 241, 6, 16, 167, 1, 27, 228, 196, 44, 201, 70, 65, 254, 193, 52, 118, 50, 143, 169, 167,
    54, 1, 68, 140, 45, 74, 126, 96, 109, 189, 41, 96, 130, 85, 138, 45, 1, 245, 160, 250, 203, 99,
    40, 0, 72, 221, 140, 183, 119, 0, 48, 241, 178, 33, 127, 236, 26, 95, 250, 11, 55, 66, 55, 58,
    241, 149, 3, 7, 115, 98, 145, 77, 93, 42, 117, 52, 194, 128, 157, 59, 186, 75, 145, 48, 177, 69,
    37, 81, 26, 246, 92, 114, 101, 96, 137, 198, 41, 162, 1, 180, 208, 178, 83, 106, 6, 30, 79, 132,
    80, 4, 89, 168, 81, 35, 219, 86, 43, 221, 178, 224, 68, 41, 70, 58, 74, 144, 136, 145, 96, 104,
    25, 52, 92, 97, 144, 94, 80, 210, 164, 6, 130, 164, 232, 185, 108, 66, 15, 43, 69, 253, 243, 66,
    198, 5, 102, 160, 216, 57, 201, 129, 99, 229, 86, 130, 132, 8, 99, 206, 80, 89, 162, 242, 84, 0,
    70, 59, 159, 72, 193, 215, 230, 233, 34, 23, 138, 98, 152, 66, 81, 5, 61, 68, 63, 131, 153, 122,
    96, 186, 212, 208, 116, 34, 115, 113, 83, 176, 50, 236, 185, 223, 54, 226, 64, 221, 130, 42,
    112, 98, 150, 111, 140, 68, 102, 215, 99, 193, 196, 1, 64, 176, 1, 128, 8
};

/* What all weights share: the closed form preetham_zenith. */
static inline skylight_sh_4_bands_0_005pct_packed_real
    skylight_sh_4_bands_0_005pct_packed_scale(const skylight_sh_4_bands_0_005pct_packed_real *x)
{
    const float chi = (0.444444448f - x[1] * 0.00833333377f) * (3.14159274f - 2.0f * x[0]);
    const float square = chi * chi;
    const float tan_above = chi * (105.0f - 10.0f * square);
    const float tan_below = 105.0f - square * (45.0f - square);
    const float zenith = (4.04530001f * x[1] - 4.97100019f) * tan_above + (2.41919994f -
        0.215499997f * x[1]) * tan_below;
    const float a = 0.1787f * x[1] + (-1.46300006f);
    const float b = (-0.355399996f) * x[1] + 0.42750001f;
    const float up = 1.0f + b * (0.25f + b * 0.03125f);
    const float up2 = up * up;
    const float up4 = up2 * up2;
    const float c = (-0.0227000006f) * x[1] + 5.32509995f;
    const float d = 0.1206f * x[1] + (-2.57710004f);
    const float y = d * x[0];
    const float halo = 1.0f + y * (0.125f + y * 0.0078125f);
    const float halo2 = halo * halo;
    const float halo4 = halo2 * halo2;
    const float halo8 = halo4 * halo4;
    const float e = (-0.0670000017f) * x[1] + 0.370299995f;
    const float z = x[0] * x[0];
    const float cosine = 1.0f - z * (0.5f - z * (0.0416666679f - z * 0.00138888892f));
    return 1000.0f * zenith / (tan_below * (1.0f + a * up4) * (1.0f + c * halo8 + e * (cosine *
        cosine)));
}

/* The functions of sun_zenith (change of variable: reciprocal); 0 where
   there is none. */
static inline void skylight_sh_4_bands_0_005pct_packed_first(const
    skylight_sh_4_bands_0_005pct_packed_real *x, skylight_sh_4_bands_0_005pct_packed_real *out)
{
    out[0] = 1.0f;
    out[1] = 4.36619759f * (x[0] - 0.0f) / (5.0f - x[0]) - 1.0f;
    out[2] = 2.0f * out[1] * out[1] - 1.0f;
    out[3] = 2.0f * out[1] * out[2] - out[1];
    out[4] = 2.0f * out[2] * out[2] - 1.0f;
    out[5] = 2.0f * out[2] * out[3] - out[1];
    out[6] = 2.0f * out[3] * out[3] - 1.0f;
    out[7] = 2.0f * out[3] * out[4] - out[1];
    out[8] = 2.0f * out[4] * out[4] - 1.0f;
    out[9] = 2.0f * out[4] * out[5] - out[1];
    out[10] = 2.0f * out[5] * out[5] - 1.0f;
    out[11] = 2.0f * out[5] * out[6] - out[1];
    (void)x;
}

/* All products of the functions of turbidity (change of variable:
   reciprocal). */
static inline void skylight_sh_4_bands_0_005pct_packed_others(const
    skylight_sh_4_bands_0_005pct_packed_real *x, skylight_sh_4_bands_0_005pct_packed_real *out)
{
    out[0] = 1.0f;
    out[1] = (-4.57142878f) * (x[1] - 2.5f) / ((-2.0f) - x[1]) - 1.0f;
    out[2] = 2.0f * out[1] * out[1] - 1.0f;
    out[3] = 2.0f * out[1] * out[2] - out[1];
    out[4] = 2.0f * out[2] * out[2] - 1.0f;
    out[5] = 2.0f * out[2] * out[3] - out[1];
    out[6] = 2.0f * out[3] * out[3] - 1.0f;
    out[7] = 2.0f * out[3] * out[4] - out[1];
    (void)x;
}

/* cos(m azimuth) and sin(m azimuth) for m < bands, by doubling. */
static inline void
    skylight_sh_4_bands_0_005pct_packed_waves(skylight_sh_4_bands_0_005pct_packed_real azimuth,
    skylight_sh_4_bands_0_005pct_packed_real *cosines,
    skylight_sh_4_bands_0_005pct_packed_real *sines)
{
    cosines[0] = 1.0f;
    cosines[1] = cosf(azimuth);
    sines[1] = sinf(azimuth);
    cosines[2] = cosines[1] * cosines[1] - sines[1] * sines[1];
    sines[2] = sines[1] * cosines[1] + cosines[1] * sines[1];
    cosines[3] = cosines[1] * cosines[2] - sines[1] * sines[2];
    sines[0] = 0.0f;
    sines[3] = sines[1] * cosines[2] + cosines[1] * sines[2];
}

/* The zonal window's factor for the degree `share` * bands (Habel et al.
   2008, eq. 5). */
static inline float skylight_sh_4_bands_0_005pct_packed_sinc(float share)
{
    const float x = 3.14159274f * share;
    return sinf(x) / x;
}

/* Of each axis: where its functions have slopes. */
static const double
    skylight_sh_4_bands_0_005pct_packed_slope_range[SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_AXES][2] = {
    { 0.0, 1.5707963267948966 }, { 2.5, 6.0 } };

/* The functions of an axis at v, and their slopes. */
static inline void skylight_sh_4_bands_0_005pct_packed_functions(int axis, double v, double *out,
    double *slopes)
{
    if (axis == 0) {
        out[0] = 1.0;
        const double part_1 = 5.0 - v;
        const double part_2 = 4.366197723675814 * (v - 0.0) / part_1;
        out[1] = part_2 - 1.0;
        const double part_3 = 2.0 * out[1];
        out[2] = part_3 * out[1] - 1.0;
        const double part_4 = 2.0 * out[1];
        out[3] = part_4 * out[2] - out[1];
        const double part_5 = 2.0 * out[2];
        out[4] = part_5 * out[2] - 1.0;
        const double part_6 = 2.0 * out[2];
        out[5] = part_6 * out[3] - out[1];
        const double part_7 = 2.0 * out[3];
        out[6] = part_7 * out[3] - 1.0;
        const double part_8 = 2.0 * out[3];
        out[7] = part_8 * out[4] - out[1];
        const double part_9 = 2.0 * out[4];
        out[8] = part_9 * out[4] - 1.0;
        const double part_10 = 2.0 * out[4];
        out[9] = part_10 * out[5] - out[1];
        const double part_11 = 2.0 * out[5];
        out[10] = part_11 * out[5] - 1.0;
        const double part_12 = 2.0 * out[5];
        out[11] = part_12 * out[6] - out[1];
        slopes[0] = 0.0;
        slopes[1] = 4.366197723675814 / part_1 - part_2 * -1.0 / part_1;
        slopes[2] = 2.0 * slopes[1] * out[1] + part_3 * slopes[1];
        slopes[3] = 2.0 * slopes[1] * out[2] + part_4 * slopes[2] - slopes[1];
        slopes[4] = 2.0 * slopes[2] * out[2] + part_5 * slopes[2];
        slopes[5] = 2.0 * slopes[2] * out[3] + part_6 * slopes[3] - slopes[1];
        slopes[6] = 2.0 * slopes[3] * out[3] + part_7 * slopes[3];
        slopes[7] = 2.0 * slopes[3] * out[4] + part_8 * slopes[4] - slopes[1];
        slopes[8] = 2.0 * slopes[4] * out[4] + part_9 * slopes[4];
        slopes[9] = 2.0 * slopes[4] * out[5] + part_10 * slopes[5] - slopes[1];
        slopes[10] = 2.0 * slopes[5] * out[5] + part_11 * slopes[5];
        slopes[11] = 2.0 * slopes[5] * out[6] + part_12 * slopes[6] - slopes[1];
    }
    if (axis == 1) {
        out[0] = 1.0;
        const double part_1 = (-2.0) - v;
        const double part_2 = (-4.5714285714285712) * (v - 2.5) / part_1;
        out[1] = part_2 - 1.0;
        const double part_3 = 2.0 * out[1];
        out[2] = part_3 * out[1] - 1.0;
        const double part_4 = 2.0 * out[1];
        out[3] = part_4 * out[2] - out[1];
        const double part_5 = 2.0 * out[2];
        out[4] = part_5 * out[2] - 1.0;
        const double part_6 = 2.0 * out[2];
        out[5] = part_6 * out[3] - out[1];
        const double part_7 = 2.0 * out[3];
        out[6] = part_7 * out[3] - 1.0;
        const double part_8 = 2.0 * out[3];
        out[7] = part_8 * out[4] - out[1];
        slopes[0] = 0.0;
        slopes[1] = (-4.5714285714285712) / part_1 - part_2 * -1.0 / part_1;
        slopes[2] = 2.0 * slopes[1] * out[1] + part_3 * slopes[1];
        slopes[3] = 2.0 * slopes[1] * out[2] + part_4 * slopes[2] - slopes[1];
        slopes[4] = 2.0 * slopes[2] * out[2] + part_5 * slopes[2];
        slopes[5] = 2.0 * slopes[2] * out[3] + part_6 * slopes[3] - slopes[1];
        slopes[6] = 2.0 * slopes[3] * out[3] + part_7 * slopes[3];
        slopes[7] = 2.0 * slopes[3] * out[4] + part_8 * slopes[4] - slopes[1];
    }
    (void)v;
}

/* What all weights share, then its slopes after the axes. */
static inline void skylight_sh_4_bands_0_005pct_packed_scale_slopes(const double *x, double *out)
{
    const double part_1 = 4.0453000000000001 * x[1] - 4.9710000000000001;
    const double part_2 = 0.44444444444444442 - x[1] * 0.0083333333333333332;
    const double part_3 = 3.1415926535897931 - 2.0 * x[0];
    const double chi = part_2 * part_3;
    const double square = chi * chi;
    const double part_4 = 105.0 - 10.0 * square;
    const double tan_above = chi * part_4;
    const double part_5 = 2.4192 - 0.2155 * x[1];
    const double part_6 = 45.0 - square;
    const double tan_below = 105.0 - square * part_6;
    const double zenith = part_1 * tan_above + part_5 * tan_below;
    const double a = 0.1787 * x[1] + (-1.4630000000000001);
    const double b = (-0.35539999999999999) * x[1] + 0.42749999999999999;
    const double part_7 = 0.25 + b * 0.03125;
    const double up = 1.0 + b * part_7;
    const double up2 = up * up;
    const double up4 = up2 * up2;
    const double part_8 = 1.0 + a * up4;
    const double part_9 = tan_below * part_8;
    const double c = (-0.022700000000000001) * x[1] + 5.3250999999999999;
    const double d = 0.1206 * x[1] + (-2.5771000000000002);
    const double y = d * x[0];
    const double part_10 = 0.125 + y * 0.0078125;
    const double halo = 1.0 + y * part_10;
    const double halo2 = halo * halo;
    const double halo4 = halo2 * halo2;
    const double halo8 = halo4 * halo4;
    const double e = (-0.067000000000000004) * x[1] + 0.37030000000000002;
    const double z = x[0] * x[0];
    const double part_11 = 0.041666666666666664 - z * 0.0013888888888888889;
    const double part_12 = 0.5 - z * part_11;
    const double cosine = 1.0 - z * part_12;
    const double part_13 = cosine * cosine;
    const double part_14 = 1.0 + c * halo8 + e * part_13;
    const double part_15 = part_9 * part_14;
    out[0] = 1000.0 * zenith / part_15;
    const double part_16 = part_2 * -2.0;
    const double part_17 = part_16 * chi + chi * part_16;
    const double part_18 = -(part_17 * part_6 + square * -part_17);
    const double part_19 = d * part_10 + y * (d * 0.0078125);
    const double part_20 = part_19 * halo + halo * part_19;
    const double part_21 = part_20 * halo2 + halo2 * part_20;
    const double part_22 = x[0] + x[0];
    const double part_23 = -(part_22 * part_12 + z * -(part_22 * part_11 + z * -(part_22 *
        0.0013888888888888889)));
    out[1] = 1000.0 * (part_1 * (part_16 * part_4 + chi * -(10.0 * part_17)) + part_5 * part_18) /
        part_15 - out[0] * (part_18 * part_8 * part_14 + part_9 * (c * (part_21 * halo4 + halo4 *
        part_21) + e * (part_23 * cosine + cosine * part_23))) / part_15;
    const double part_24 = -0.0083333333333333332 * part_3;
    const double part_25 = part_24 * chi + chi * part_24;
    const double part_26 = -(part_25 * part_6 + square * -part_25);
    const double part_27 = (-0.35539999999999999) * part_7 + b * ((-0.35539999999999999) * 0.03125);
    const double part_28 = part_27 * up + up * part_27;
    const double part_29 = 0.1206 * x[0];
    const double part_30 = part_29 * part_10 + y * (part_29 * 0.0078125);
    const double part_31 = part_30 * halo + halo * part_30;
    const double part_32 = part_31 * halo2 + halo2 * part_31;
    out[2] = 1000.0 * (4.0453000000000001 * tan_above + part_1 * (part_24 * part_4 + chi * -(10.0 *
        part_25)) + (-0.2155 * tan_below + part_5 * part_26)) / part_15 - out[0] * ((part_26 *
        part_8 + tan_below * (0.1787 * up4 + a * (part_28 * up2 + up2 * part_28))) * part_14 +
        part_9 * ((-0.022700000000000001) * halo8 + c * (part_32 * halo4 + halo4 * part_32) +
        (-0.067000000000000004) * part_13)) / part_15;
    (void)x;
}

/* 0 for a finite number, 1 for an infinity, 2 for NaN: by its bits, so that -ffast-math cannot
   remove the test. */
static inline int skylight_sh_4_bands_0_005pct_packed_kind(float v)
{
    uint32_t bits;
    memcpy(&bits, &v, sizeof bits);
    bits &= 0x7fffffffu;
    return (bits >= 0x7f800000u) + (bits > 0x7f800000u);
}

/* A number that is no NaN, finite: an infinity becomes a large number of its sign. */
static inline float skylight_sh_4_bands_0_005pct_packed_finite(float v)
{
    if (skylight_sh_4_bands_0_005pct_packed_kind(v)) {
        uint32_t bits;
        memcpy(&bits, &v, sizeof bits);
        v = bits >> 31 ? -3e38f : 3e38f;
    }
    return v;
}

/* Clamps the axes' inputs into x. Returns the status: 0; 1 where one was not inside; 2, and nothing
   in x, where one is NaN or the azimuth no finite number. */
static inline int skylight_sh_4_bands_0_005pct_packed_inputs(const float
    inputs[SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_AXES], float azimuth,
                                     skylight_sh_4_bands_0_005pct_packed_real
                                         x[SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_AXES])
{
    int axis, status = 0, strange = skylight_sh_4_bands_0_005pct_packed_kind(azimuth) ? 2 : 0;
    for (axis = 0; axis < SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_AXES; ++axis) strange |=
        skylight_sh_4_bands_0_005pct_packed_kind(inputs[axis]);
    if (strange & 2) return 2;
    for (axis = 0; axis < SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_AXES; ++axis) {
        const float v = skylight_sh_4_bands_0_005pct_packed_finite(inputs[axis]);
        const skylight_sh_4_bands_0_005pct_packed_real low =
            skylight_sh_4_bands_0_005pct_packed_range[axis][0],
            high = skylight_sh_4_bands_0_005pct_packed_range[axis][1];
        const skylight_sh_4_bands_0_005pct_packed_real at_least =
            (skylight_sh_4_bands_0_005pct_packed_real)v < low ? low :
            (skylight_sh_4_bands_0_005pct_packed_real)v;
        status |= (v < skylight_sh_4_bands_0_005pct_packed_inside[axis][0]) | (v >
            skylight_sh_4_bands_0_005pct_packed_inside[axis][1]);
        x[axis] = at_least > high ? high : at_least;
    }
    return status;
}

/* Orders m >= 0 alone are stored: those of a light that is even in y at azimuth 0. */
#define SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_FIRST_ORDER(l) 0

/* Stores the weight of degree l and order m turned by the azimuth (Habel et al. 2008, eq. 4). */
static inline void
    skylight_sh_4_bands_0_005pct_packed_place(skylight_sh_4_bands_0_005pct_packed_real value, int l,
    int m,
                                     const skylight_sh_4_bands_0_005pct_packed_real *cosines,
                                         const skylight_sh_4_bands_0_005pct_packed_real *sines,
                                     float *weights)
{
    weights[l * (l + 1) - m] = (float)(value * sines[m]);
    weights[l * (l + 1) + m] = (float)(value * cosines[m]);
}

/* Reads the stream: whole numbers as Rice codes, low bit of each byte first. */
typedef struct {
    const unsigned char *next;
    uint64_t held;
    int count;
} skylight_sh_4_bands_0_005pct_packed_bits;

static inline void skylight_sh_4_bands_0_005pct_packed_fill(skylight_sh_4_bands_0_005pct_packed_bits
    *b)
{
    const unsigned char *const end = skylight_sh_4_bands_0_005pct_packed_stream + sizeof
        skylight_sh_4_bands_0_005pct_packed_stream;
    while (b->count <= 56 && b->next < end) {
        b->held |= (uint64_t)*b->next++ << b->count;
        b->count += 8;
    }
}

/* `width` bits, at most 31, as a number. */
static inline unsigned
    skylight_sh_4_bands_0_005pct_packed_fixed(skylight_sh_4_bands_0_005pct_packed_bits *b,
    int width)
{
    unsigned value;
    if (b->count < 32) skylight_sh_4_bands_0_005pct_packed_fill(b);
    value = (unsigned)(b->held & ((UINT64_C(1) << width) - 1));
    b->held >>= width;
    b->count -= width;
    return value;
}

/* A Rice code of `low` low bits: ones, a zero, the low bits; then folded back: 0, 1, 2, 3 -> 0, -1,
   1, -2. */
static inline int skylight_sh_4_bands_0_005pct_packed_rice(skylight_sh_4_bands_0_005pct_packed_bits
    *b, int low)
{
    unsigned high = 0, folded;
    if (b->count < 32) skylight_sh_4_bands_0_005pct_packed_fill(b);
    while (b->held & 1) {
        ++high;
        b->held >>= 1;
        if (--b->count < 1) skylight_sh_4_bands_0_005pct_packed_fill(b);
    }
    b->held >>= 1;
    --b->count;
    folded = (high << low) | skylight_sh_4_bands_0_005pct_packed_fixed(b, low);
    return folded & 1 ? -(int)(folded >> 1) - 1 : (int)(folded >> 1);
}

/* The stream from its start. */
static inline skylight_sh_4_bands_0_005pct_packed_bits
    skylight_sh_4_bands_0_005pct_packed_open(void)
{
    skylight_sh_4_bands_0_005pct_packed_bits b;
    b.next = skylight_sh_4_bands_0_005pct_packed_stream;
    b.held = 0;
    b.count = 0;
    return b;
}

/* The next band's profile: twice the low bits that its numbers have, by their place in a run. */
static inline void
    skylight_sh_4_bands_0_005pct_packed_next_profile(skylight_sh_4_bands_0_005pct_packed_bits *b,
    int profile[32])
{
    const int used = (int)skylight_sh_4_bands_0_005pct_packed_fixed(b, 5);
    int i;
    for (i = 0; i < used; ++i) profile[i] = (int)skylight_sh_4_bands_0_005pct_packed_fixed(b, 5);
}

/* The length of the next run, by that of the same channel and product at the weight before. */
static inline int
    skylight_sh_4_bands_0_005pct_packed_next_length(skylight_sh_4_bands_0_005pct_packed_bits *b,
    signed char *length)
{
    const int found = *length + skylight_sh_4_bands_0_005pct_packed_rice(b, 0);
    *length = (signed char)found;
    return found;
}

/* The next number, of `size` half low bits. */
static inline int
    skylight_sh_4_bands_0_005pct_packed_next_number(skylight_sh_4_bands_0_005pct_packed_bits *b,
    int size)
{
    return skylight_sh_4_bands_0_005pct_packed_rice(b, size > 0 ? size >> 1 : 0);
}

static const signed char
    skylight_sh_4_bands_0_005pct_packed_run_profile[SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_RUNS] =
    SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_RUN_PROFILE;
static const signed char
    skylight_sh_4_bands_0_005pct_packed_channel_profile
    [SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_CHANNELS] =
    SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_CHANNEL_PROFILE;

/* Reads the stream once, forward, and stores the first `bands` bands. */
static inline void skylight_sh_4_bands_0_005pct_packed_combine(const
    skylight_sh_4_bands_0_005pct_packed_real *first,
                                       const skylight_sh_4_bands_0_005pct_packed_real *others,
                                       const skylight_sh_4_bands_0_005pct_packed_real *cosines,
                                       const skylight_sh_4_bands_0_005pct_packed_real *sines,
                                           int bands,
                                       float
                                           weights[SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_CHANNELS]
                                           [SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_WEIGHTS])
{
    signed char
        lengths[SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_CHANNELS]
        [SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_RUNS];
    int profile[32], i, l, m, channel, other;
    skylight_sh_4_bands_0_005pct_packed_bits bits = skylight_sh_4_bands_0_005pct_packed_open();
    memset(lengths, 0, sizeof lengths);
    memset(profile, 0, sizeof profile);
    for (l = 0; l < bands; ++l) {
        skylight_sh_4_bands_0_005pct_packed_next_profile(&bits, profile);
        for (m = SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_FIRST_ORDER(l); m <= l; ++m) {
            for (channel = 0; channel < SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_CHANNELS; ++channel) {
                skylight_sh_4_bands_0_005pct_packed_real value = 0;
                for (other = 0; other < SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_RUNS; ++other) {
                    const int level = skylight_sh_4_bands_0_005pct_packed_run_profile[other] +
                                      skylight_sh_4_bands_0_005pct_packed_channel_profile[channel];
                    const int length = skylight_sh_4_bands_0_005pct_packed_next_length(&bits,
                        &lengths[channel][other]);
                    skylight_sh_4_bands_0_005pct_packed_real sum = 0;
                    for (i = 0; i < length; ++i) {
                        const int number = skylight_sh_4_bands_0_005pct_packed_next_number(&bits,
                            profile[i] + level);
                        sum += first[i] * (skylight_sh_4_bands_0_005pct_packed_real)number;
                    }
                    value += sum * others[other];
                }
                skylight_sh_4_bands_0_005pct_packed_place(value *
                    SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_STEP, l, m, cosines, sines,
                                  weights[channel]);
            }
        }
    }
}

/* The same in double precision, all bands: what derivatives need, whose terms cancel. */
static inline void skylight_sh_4_bands_0_005pct_packed_combine_double(
    const double *first, const double *others,
        const skylight_sh_4_bands_0_005pct_packed_real *cosines,
    const skylight_sh_4_bands_0_005pct_packed_real *sines,
        float
        weights[SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_CHANNELS]
        [SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_WEIGHTS])
{
    signed char
        lengths[SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_CHANNELS]
        [SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_RUNS];
    int profile[32], i, l, m, channel, other;
    skylight_sh_4_bands_0_005pct_packed_bits bits = skylight_sh_4_bands_0_005pct_packed_open();
    memset(lengths, 0, sizeof lengths);
    memset(profile, 0, sizeof profile);
    for (l = 0; l < SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_BANDS; ++l) {
        skylight_sh_4_bands_0_005pct_packed_next_profile(&bits, profile);
        for (m = SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_FIRST_ORDER(l); m <= l; ++m) {
            for (channel = 0; channel < SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_CHANNELS; ++channel) {
                double value = 0.0;
                for (other = 0; other < SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_RUNS; ++other) {
                    const int level = skylight_sh_4_bands_0_005pct_packed_run_profile[other] +
                                      skylight_sh_4_bands_0_005pct_packed_channel_profile[channel];
                    const int length = skylight_sh_4_bands_0_005pct_packed_next_length(&bits,
                        &lengths[channel][other]);
                    double sum = 0.0;
                    for (i = 0; i < length; ++i) {
                        const int number = skylight_sh_4_bands_0_005pct_packed_next_number(&bits,
                            profile[i] + level);
                        sum += first[i] * (double)number;
                    }
                    value += sum * others[other];
                }
                skylight_sh_4_bands_0_005pct_packed_place((
                    skylight_sh_4_bands_0_005pct_packed_real)(value *
                    (double)SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_STEP), l, m,
                                  cosines, sines, weights[channel]);
            }
        }
    }
}

/* What becomes of the first `bands` bands once they are stored; the others become 0. */
static inline void skylight_sh_4_bands_0_005pct_packed_finish(int bands, int lights,
    const skylight_sh_4_bands_0_005pct_packed_real *cosines,
                                      const skylight_sh_4_bands_0_005pct_packed_real *sines,
                                      float
                                          weights[SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_CHANNELS]
                                          [SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_WEIGHTS])
{
    if (bands < SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_BANDS) {
        int channel, i;
        for (channel = 0; channel < SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_CHANNELS; ++channel)
            for (i = bands * bands; i < SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_WEIGHTS; ++i)
                weights[channel][i] = 0.0f;
    }
    (void)lights;
    (void)cosines;
    (void)sines;
}

/* Evaluates the first `bands` bands (1 to SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_BANDS, clamped like
 * an input) and zeroes the
   rest; returns the status. */
static inline int skylight_sh_4_bands_0_005pct_packed_evaluate(const float
    inputs[SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_AXES], float azimuth,
                                       int bands,
                                       float
                                           weights[SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_CHANNELS]
                                           [SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_WEIGHTS])
{
    skylight_sh_4_bands_0_005pct_packed_real x[SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_AXES],
        first[SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_FIRST],
        others[SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_OTHERS];
    skylight_sh_4_bands_0_005pct_packed_real cosines[SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_BANDS],
        sines[SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_BANDS], scale;
    int i, status = skylight_sh_4_bands_0_005pct_packed_inputs(inputs, azimuth, x);
    if (status == 2) {
        memset(weights, 0, sizeof(float) * SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_CHANNELS *
            SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_WEIGHTS);
        return 2;
    }
    if (bands < 1 || bands > SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_BANDS) {
        bands = bands < 1 ? 1 : SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_BANDS;
        status = 1;
    }
    scale = skylight_sh_4_bands_0_005pct_packed_scale(x) *
        (skylight_sh_4_bands_0_005pct_packed_real)SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_EXPOSURE;
    skylight_sh_4_bands_0_005pct_packed_first(x, first);
    skylight_sh_4_bands_0_005pct_packed_others(x, others);
    for (i = 0; i < SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_OTHERS; ++i) others[i] *= scale;
    skylight_sh_4_bands_0_005pct_packed_waves((skylight_sh_4_bands_0_005pct_packed_real)azimuth,
        cosines, sines);
    skylight_sh_4_bands_0_005pct_packed_combine(first, others, cosines, sines, bands, weights);
    skylight_sh_4_bands_0_005pct_packed_finish(bands, 1, cosines, sines, weights);
    return status;
}

/* Evaluates `count` suns from arrays, one an axis, and one of azimuths (or none, where the table
   fixes it); returns the largest status. */
static inline int skylight_sh_4_bands_0_005pct_packed_evaluate_batch(
    int count, const float *const inputs[SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_AXES],
        const float *azimuths,
    float
        (*weights)[SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_CHANNELS]
        [SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_WEIGHTS])
{
    int s, axis, worst = 0;
    for (s = 0; s < count; ++s) {
        const float azimuth = azimuths ? azimuths[s] : SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_AZIMUTH;
        float sun[SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_AXES];
        int status;
        for (axis = 0; axis < SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_AXES; ++axis) sun[axis] =
            inputs[axis][s];
        status = skylight_sh_4_bands_0_005pct_packed_evaluate(sun, azimuth,
            SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_BANDS, weights[s]);
        worst = status > worst ? status : worst;
    }
    return worst;
}

/* All products of `count` numbers and `size` functions, the functions' place fastest; returns how
   many. */
static inline int skylight_sh_4_bands_0_005pct_packed_multiply(double *products, int count,
    const double *functions,
                                       int size)
{
    int i, k;
    for (k = count - 1; k >= 0; --k) {
        const double product = products[k];
        for (i = size - 1; i >= 0; --i) products[k * size + i] = product * functions[i];
    }
    return count * size;
}

/* Evaluates all bands, and their derivatives after each axis by the product rule, in double until
   they are stored: exact inside the ranges, and beyond one those at its edge. */
static inline int skylight_sh_4_bands_0_005pct_packed_evaluate_gradient(
    const float inputs[SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_AXES], float azimuth,
    float
        weights[SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_CHANNELS]
        [SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_WEIGHTS],
    float
        gradient[SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_AXES]
        [SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_CHANNELS][SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_WEIGHTS])
{
    static const int sizes[SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_AXES] =
        SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_SIZES;
    double x[SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_AXES],
        functions[SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_AXES]
        [SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_MOST];
    double
        slopes[SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_AXES][SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_MOST],
        scale[1 + SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_AXES];
    skylight_sh_4_bands_0_005pct_packed_real cosines[SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_BANDS],
        sines[SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_BANDS];
    int axis, other, i;
    const int status = skylight_sh_4_bands_0_005pct_packed_evaluate(inputs, azimuth,
        SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_BANDS, weights);
    if (status == 2) {
        memset(gradient, 0,
               sizeof(float) * SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_AXES *
                   SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_CHANNELS *
                   SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_WEIGHTS);
        return 2;
    }
    for (axis = 0; axis < SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_AXES; ++axis) {
        const double low = skylight_sh_4_bands_0_005pct_packed_slope_range[axis][0];
        const double high = skylight_sh_4_bands_0_005pct_packed_slope_range[axis][1];
        const double v = (double)skylight_sh_4_bands_0_005pct_packed_finite(inputs[axis]);
        x[axis] = v < low ? low : v > high ? high : v;
        skylight_sh_4_bands_0_005pct_packed_functions(axis, x[axis], functions[axis], slopes[axis]);
    }
    skylight_sh_4_bands_0_005pct_packed_scale_slopes(x, scale);
    for (i = 0; i < 1 + SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_AXES; ++i) scale[i] *=
        (double)SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_EXPOSURE;
    skylight_sh_4_bands_0_005pct_packed_waves((skylight_sh_4_bands_0_005pct_packed_real)azimuth,
        cosines, sines);
    for (axis = 0; axis < SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_AXES; ++axis) {
        double first[SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_MOST],
            others[SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_OTHERS];
        int count = 1;
        others[0] = 1.0;
        for (other = 0; other < SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_AXES; ++other) {
            double one[SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_MOST];
            for (i = 0; i < sizes[other]; ++i) {
                one[i] = functions[other][i];
                if (other == axis) one[i] = scale[0] * slopes[axis][i] + scale[1 + axis] * one[i];
                if (other == 0) first[i] = one[i];
            }
            if (other) count = skylight_sh_4_bands_0_005pct_packed_multiply(others, count, one,
                sizes[other]);
        }
        skylight_sh_4_bands_0_005pct_packed_combine_double(first, others, cosines, sines,
            gradient[axis]);
        skylight_sh_4_bands_0_005pct_packed_finish(SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_BANDS, 0,
            cosines, sines, gradient[axis]);
    }
    return status;
}

SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_API int skylight_sh_4_bands_0_005pct_packed_weights(float
    sun_zenith, float sun_azimuth, float turbidity,
    float
    weights[SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_CHANNELS]
    [SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_WEIGHTS])
{
    const float skylight_sh_4_bands_0_005pct_packed_given[SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_AXES]
        = { sun_zenith, turbidity };
    return skylight_sh_4_bands_0_005pct_packed_evaluate(skylight_sh_4_bands_0_005pct_packed_given,
        sun_azimuth, SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_BANDS, weights);
}

SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_API int skylight_sh_4_bands_0_005pct_packed_weights_bands(float
    sun_zenith, float sun_azimuth, float turbidity, int bands,
    float
    weights[SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_CHANNELS]
    [SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_WEIGHTS])
{
    const float skylight_sh_4_bands_0_005pct_packed_given[SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_AXES]
        = { sun_zenith, turbidity };
    return skylight_sh_4_bands_0_005pct_packed_evaluate(skylight_sh_4_bands_0_005pct_packed_given,
        sun_azimuth, bands, weights);
}

SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_API int skylight_sh_4_bands_0_005pct_packed_weights_batch(int
    count, const float *sun_zenith, const float *sun_azimuth, const float *turbidity,
    float
    (*weights)[SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_CHANNELS]
    [SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_WEIGHTS])
{
    const float *const
        skylight_sh_4_bands_0_005pct_packed_given[SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_AXES] = {
        sun_zenith, turbidity };
    return skylight_sh_4_bands_0_005pct_packed_evaluate_batch(count,
        skylight_sh_4_bands_0_005pct_packed_given, sun_azimuth, weights);
}

SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_API int
    skylight_sh_4_bands_0_005pct_packed_weights_gradient(float sun_zenith, float sun_azimuth,
    float turbidity, float
    weights[SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_CHANNELS]
    [SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_WEIGHTS],
    float
    gradient[SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_AXES][SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_CHANNELS]
    [SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_WEIGHTS])
{
    const float skylight_sh_4_bands_0_005pct_packed_given[SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_AXES]
        = { sun_zenith, turbidity };
    return
        skylight_sh_4_bands_0_005pct_packed_evaluate_gradient(
        skylight_sh_4_bands_0_005pct_packed_given, sun_azimuth, weights, gradient);
}

/* The dominant light's direction, a unit vector: where the linear part of the weights, summed over
   channels by luminance, points. Returns 0, or 1 (and straight up) where it points nowhere. */
SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_API int skylight_sh_4_bands_0_005pct_packed_dominant_of(const
    float *weights, float direction[3])
{
    static const float luminance[SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_CHANNELS] =
        SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_LUMINANCE;
    float x = 0.0f, y = 0.0f, z = 0.0f, length;
    int channel;
    for (channel = 0; channel < SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_CHANNELS; ++channel) {
        const float *const linear = weights + channel * SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_WEIGHTS
            + 1;
        x += luminance[channel] * linear[2];
        y += luminance[channel] * linear[0];
        z += luminance[channel] * linear[1];
    }
    length = sqrtf(x * x + y * y + z * z);
    direction[0] = length > 0.0f ? x / length : 0.0f;
    direction[1] = length > 0.0f ? y / length : 0.0f;
    direction[2] = length > 0.0f ? z / length : 1.0f;
    return !(length > 0.0f);
}

/* Adds an even ground of this albedo below the horizon, lit by the sky (before any window): its
   radiance is albedo E / pi, and E, the irradiance on it, a multiple of the weight l = 1, m = 0. */
SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_API void skylight_sh_4_bands_0_005pct_packed_ground(
    const float albedo[SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_CHANNELS],
    float
        weights[SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_CHANNELS]
        [SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_WEIGHTS])
{
    static const float lower[SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_BANDS] =
        SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_LOWER;
    int l, channel;
    for (channel = 0; channel < SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_CHANNELS; ++channel) {
        const float radiance = albedo[channel] * SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_REFLECTED *
            weights[channel][2];
        for (l = 0; l < SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_BANDS; ++l) weights[channel][l * (l +
            1)] += radiance * lower[l];
    }
}

/* Tames the ringing of the horizon in the first `bands` bands by the zonal window sinc(pi l /
   bands) (Habel et al. 2008, eq. 5). */
SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_API void skylight_sh_4_bands_0_005pct_packed_window(
    int bands, float
        weights[SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_CHANNELS]
        [SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_WEIGHTS])
{
    int l, channel;
    for (l = 1; l < bands && l < SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_BANDS; ++l) {
        const float factor = skylight_sh_4_bands_0_005pct_packed_sinc((float)l / (float)bands);
        for (channel = 0; channel < SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_CHANNELS; ++channel)
            weights[channel][l * (l + 1)] *= factor;
    }
}

#endif /* SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_DEFINED */
