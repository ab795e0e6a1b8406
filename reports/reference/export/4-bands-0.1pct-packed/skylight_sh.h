/* Preetham sky (published constants, srgb): spherical-harmonics weights, evaluated from
 * polynomials.
 *
 * Written by skylight-sh 0.1.0; the table and this code may be used by anyone for anything
 * (CC0-1.0).
 * C99 and C++11, no allocation, no global written, nothing static but constants: any thread may
 * call it.
 *
 * Usage
 *   float w[SKYLIGHT_SH_4_BANDS_0_1PCT_PACKED_CHANNELS][SKYLIGHT_SH_4_BANDS_0_1PCT_PACKED_WEIGHTS];
 *   int status = skylight_sh_4_bands_0_1pct_packed_weights(0.785000026f, 0.0f, 4.25f, w);
 * Compile with, for instance
 *   cc -std=c99 -O3 program.c -o program -lm
 * Included plainly, the file is all there is: its functions are static, and the table stands in
 * every unit that includes it. With SKYLIGHT_SH_4_BANDS_0_1PCT_PACKED_EXTERN defined before it, it
 * declares only; the one unit that also defines SKYLIGHT_SH_4_BANDS_0_1PCT_PACKED_IMPLEMENTATION
 * holds functions and table, for C and C++.
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
 *   Define SKYLIGHT_SH_4_BANDS_0_1PCT_PACKED_EXPOSURE before this file (where it holds the table)
 *   to multiply all weights (1 by default).
 *
 * Accuracy, as shipped: E_mean 0.0951 %, E_max 0.272 % of the least luminance of the same sky, at
 * azimuth 0.
 * The expansion rings: the least value it takes, over all directions and measured sets, is -12.5 %
 * of its largest in the same set; the window below tames it.
 * Memory: 1257 bytes of constants, packed into few bytes (a fast table takes more and less time).
 *
 * Provenance
 *   skylight-sh 0.1.0, config preetham 7738be1e848979ca, table 4-bands-0.1pct-packed
 */
#ifdef __cplusplus
#if __cplusplus < 201103L && !defined(_MSC_VER)
#error "skylight_sh needs C++11 or later: compile with -std=c++11."
#endif
#elif (!defined(__STDC_VERSION__) || __STDC_VERSION__ < 199901L) && !defined(_MSC_VER)
#error "skylight_sh needs C99 or later: compile with -std=c99."
#endif
#if defined(SKYLIGHT_SH_4_BANDS_0_1PCT_PACKED_IMPLEMENTATION) && \
    !defined(SKYLIGHT_SH_4_BANDS_0_1PCT_PACKED_EXTERN)
#error "Define SKYLIGHT_SH_4_BANDS_0_1PCT_PACKED_EXTERN in every unit, \
SKYLIGHT_SH_4_BANDS_0_1PCT_PACKED_IMPLEMENTATION beside it in one."
#endif
#if defined(SKYLIGHT_SH_4_BANDS_0_1PCT_PACKED_API) && \
    defined(SKYLIGHT_SH_4_BANDS_0_1PCT_PACKED_EXTERN) && \
    !defined(SKYLIGHT_SH_4_BANDS_0_1PCT_PACKED_DECLARED)
#error "Define SKYLIGHT_SH_4_BANDS_0_1PCT_PACKED_EXTERN before this file is included for the first \
time."
#endif
#if defined(SKYLIGHT_SH_4_BANDS_0_1PCT_PACKED_DECLARED) && \
    !defined(SKYLIGHT_SH_4_BANDS_0_1PCT_PACKED_EXTERN)
#error "Leave SKYLIGHT_SH_4_BANDS_0_1PCT_PACKED_EXTERN defined: this file was included with it \
before."
#endif

#ifndef SKYLIGHT_SH_4_BANDS_0_1PCT_PACKED_H
#define SKYLIGHT_SH_4_BANDS_0_1PCT_PACKED_H 0xb69f9157

#include <math.h>
#include <stdint.h>
#include <string.h>

#ifndef SKYLIGHT_SH_4_BANDS_0_1PCT_PACKED_EXTERN
#define SKYLIGHT_SH_4_BANDS_0_1PCT_PACKED_API static inline
#else
#define SKYLIGHT_SH_4_BANDS_0_1PCT_PACKED_DECLARED
#ifdef __cplusplus
#define SKYLIGHT_SH_4_BANDS_0_1PCT_PACKED_API extern "C"
#else
#define SKYLIGHT_SH_4_BANDS_0_1PCT_PACKED_API extern
#endif
#endif
#ifndef SKYLIGHT_SH_4_BANDS_0_1PCT_PACKED_EXPOSURE
#define SKYLIGHT_SH_4_BANDS_0_1PCT_PACKED_EXPOSURE 1
#endif

#define SKYLIGHT_SH_4_BANDS_0_1PCT_PACKED_VERSION "0.1.0"
#define SKYLIGHT_SH_4_BANDS_0_1PCT_PACKED_BANDS 4
#define SKYLIGHT_SH_4_BANDS_0_1PCT_PACKED_WEIGHTS 16
#define SKYLIGHT_SH_4_BANDS_0_1PCT_PACKED_CHANNELS 3
#define SKYLIGHT_SH_4_BANDS_0_1PCT_PACKED_AXES 2
#define SKYLIGHT_SH_4_BANDS_0_1PCT_PACKED_UNIT "cd/m2"
#define SKYLIGHT_SH_4_BANDS_0_1PCT_PACKED_E_MEAN 9.511000e-04
#define SKYLIGHT_SH_4_BANDS_0_1PCT_PACKED_E_MAX 2.717000e-03
#define SKYLIGHT_SH_4_BANDS_0_1PCT_PACKED_SUN_ZENITH_MIN 0.0f
#define SKYLIGHT_SH_4_BANDS_0_1PCT_PACKED_SUN_ZENITH_MAX 1.57079637f
#define SKYLIGHT_SH_4_BANDS_0_1PCT_PACKED_TURBIDITY_MIN 2.5f
#define SKYLIGHT_SH_4_BANDS_0_1PCT_PACKED_TURBIDITY_MAX 6.0f

/* Evaluates all bands. */
SKYLIGHT_SH_4_BANDS_0_1PCT_PACKED_API int skylight_sh_4_bands_0_1pct_packed_weights(float
    sun_zenith, float sun_azimuth, float turbidity,
    float
    weights[SKYLIGHT_SH_4_BANDS_0_1PCT_PACKED_CHANNELS][SKYLIGHT_SH_4_BANDS_0_1PCT_PACKED_WEIGHTS]);
/* Evaluates the first `bands` bands (1 to SKYLIGHT_SH_4_BANDS_0_1PCT_PACKED_BANDS, clamped
   likewise) and zeroes the rest. */
SKYLIGHT_SH_4_BANDS_0_1PCT_PACKED_API int skylight_sh_4_bands_0_1pct_packed_weights_bands(float
    sun_zenith, float sun_azimuth, float turbidity, int bands,
    float
    weights[SKYLIGHT_SH_4_BANDS_0_1PCT_PACKED_CHANNELS][SKYLIGHT_SH_4_BANDS_0_1PCT_PACKED_WEIGHTS]);
/* Evaluates `count` suns from arrays; returns the largest status. No faster
   than single calls. */
SKYLIGHT_SH_4_BANDS_0_1PCT_PACKED_API int skylight_sh_4_bands_0_1pct_packed_weights_batch(int count,
    const float *sun_zenith, const float *sun_azimuth, const float *turbidity,
    float
    (*weights)[SKYLIGHT_SH_4_BANDS_0_1PCT_PACKED_CHANNELS]
    [SKYLIGHT_SH_4_BANDS_0_1PCT_PACKED_WEIGHTS]);
/* Evaluates all bands and their derivatives after each axis (sun_zenith,
   turbidity), per unit of the axis; beyond a range, those at its edge. */
SKYLIGHT_SH_4_BANDS_0_1PCT_PACKED_API int skylight_sh_4_bands_0_1pct_packed_weights_gradient(float
    sun_zenith, float sun_azimuth, float turbidity,
    float
    weights[SKYLIGHT_SH_4_BANDS_0_1PCT_PACKED_CHANNELS][SKYLIGHT_SH_4_BANDS_0_1PCT_PACKED_WEIGHTS],
    float
    gradient[SKYLIGHT_SH_4_BANDS_0_1PCT_PACKED_AXES][SKYLIGHT_SH_4_BANDS_0_1PCT_PACKED_CHANNELS]
    [SKYLIGHT_SH_4_BANDS_0_1PCT_PACKED_WEIGHTS]);
/* Unit vector of the dominant light. Returns 0, or 1 (and straight up) where there is none. */
#define skylight_sh_4_bands_0_1pct_packed_dominant(weights, direction) \
    skylight_sh_4_bands_0_1pct_packed_dominant_of(&(weights)[0][0], direction)
SKYLIGHT_SH_4_BANDS_0_1PCT_PACKED_API int skylight_sh_4_bands_0_1pct_packed_dominant_of(const float
    *weights, float direction[3]);
/* Optional: adds an even ground of this albedo below the horizon, lit by the sky (before any
 * window). */
SKYLIGHT_SH_4_BANDS_0_1PCT_PACKED_API void skylight_sh_4_bands_0_1pct_packed_ground(const float
    albedo[SKYLIGHT_SH_4_BANDS_0_1PCT_PACKED_CHANNELS],
    float
    weights[SKYLIGHT_SH_4_BANDS_0_1PCT_PACKED_CHANNELS][SKYLIGHT_SH_4_BANDS_0_1PCT_PACKED_WEIGHTS]);
/* Optional: tames the ringing of the horizon by the zonal window of the first `bands` bands. */
SKYLIGHT_SH_4_BANDS_0_1PCT_PACKED_API void skylight_sh_4_bands_0_1pct_packed_window(int bands,
    float
    weights[SKYLIGHT_SH_4_BANDS_0_1PCT_PACKED_CHANNELS][SKYLIGHT_SH_4_BANDS_0_1PCT_PACKED_WEIGHTS]);

#elif SKYLIGHT_SH_4_BANDS_0_1PCT_PACKED_H != 0xb69f9157
#error "Another table has the prefix skylight_sh_4_bands_0_1pct_packed_4_bands_0_1pct_packed \
already: export one of them under a prefix of its own."
#endif /* SKYLIGHT_SH_4_BANDS_0_1PCT_PACKED_H */

#if (!defined(SKYLIGHT_SH_4_BANDS_0_1PCT_PACKED_EXTERN) || \
    defined(SKYLIGHT_SH_4_BANDS_0_1PCT_PACKED_IMPLEMENTATION)) && \
    !defined(SKYLIGHT_SH_4_BANDS_0_1PCT_PACKED_DEFINED)
#define SKYLIGHT_SH_4_BANDS_0_1PCT_PACKED_DEFINED

typedef float skylight_sh_4_bands_0_1pct_packed_real;

/* Functions of the first axis, in fours; products of the other axes'
   functions. */
#define SKYLIGHT_SH_4_BANDS_0_1PCT_PACKED_FIRST 12
#define SKYLIGHT_SH_4_BANDS_0_1PCT_PACKED_OTHERS 6
#define SKYLIGHT_SH_4_BANDS_0_1PCT_PACKED_SIZES { 10, 6 }
#define SKYLIGHT_SH_4_BANDS_0_1PCT_PACKED_MOST 12
#define SKYLIGHT_SH_4_BANDS_0_1PCT_PACKED_AZIMUTH 0.0f
/* The channels' luminance. */
#define SKYLIGHT_SH_4_BANDS_0_1PCT_PACKED_LUMINANCE { 0.212672845f, 0.715152144f, 0.0721749961f }
/* What an even ground reflects of the weight l = 1, m = 0, and its own
   zonal weights. */
#define SKYLIGHT_SH_4_BANDS_0_1PCT_PACKED_REFLECTED 0.651470006f
#define SKYLIGHT_SH_4_BANDS_0_1PCT_PACKED_LOWER { 1.7724539f, -1.53499007f, 0.0f, 0.586184025f }

/* Of each axis: the first and last float that counts as inside, and its
   range. */
static const float
    skylight_sh_4_bands_0_1pct_packed_inside[SKYLIGHT_SH_4_BANDS_0_1PCT_PACKED_AXES][2] = { {
    -1.57079626e-06f, 1.5707978f }, { 2.49999666f, 6.00000334f } };
static const skylight_sh_4_bands_0_1pct_packed_real
    skylight_sh_4_bands_0_1pct_packed_range[SKYLIGHT_SH_4_BANDS_0_1PCT_PACKED_AXES][2] = { { 0.0f,
    1.57079637f }, { 2.5f, 6.0f } };

/* Runs of numbers, one a product of the other axes' functions, and their
   profiles; what one step is worth. */
#define SKYLIGHT_SH_4_BANDS_0_1PCT_PACKED_RUNS 6
#define SKYLIGHT_SH_4_BANDS_0_1PCT_PACKED_RUN_PROFILE { 7, 4, -1, -7, -13, -18 }
#define SKYLIGHT_SH_4_BANDS_0_1PCT_PACKED_CHANNEL_PROFILE { -5, -5, -3 }
#define SKYLIGHT_SH_4_BANDS_0_1PCT_PACKED_STEP 0.000104904175f

/* Whole numbers as Rice codes. */
static const unsigned char skylight_sh_4_bands_0_1pct_packed_stream[1064] = {
    105, 95, 58, 161, 42, 99, 252, 255, 27, 71, 155, 47, 154, 139, 108, 117, 225, 135, 248, 255, 95,
    44, 148, 104, 214, 66, 249, 129, 92, 55, 255, 79, 19, 64, 251, 54, 133, 175, 255, 37, 155, 108,
    69, 191, 193, 216, 151, 251, 255, 157, 47, 81, 41, 216, 171, 63, 72, 64, 202, 255, 47, 0, 184,
    53, 104, 133, 170, 139, 168, 255, 215, 22, 78, 161, 153, 170, 254, 71, 13, 16, 208, 191, 108,
    177, 151, 253, 255, 47, 20, 251, 210, 124, 203, 40, 17, 177, 209, 208, 57, 254, 255, 15, 26,
    217, 110, 6, 121, 196, 46, 223, 125, 154, 245, 255, 175, 134, 206, 204, 64, 17, 151, 125, 124,
    247, 255, 147, 144, 211, 253, 226, 131, 254, 31, 64, 245, 253, 245, 143, 168, 148, 45, 149, 144,
    157, 16, 122, 218, 197, 244, 105, 2, 158, 148, 193, 82, 14, 132, 234, 168, 104, 90, 195, 250,
    110, 207, 33, 234, 27, 20, 142, 116, 187, 204, 137, 222, 57, 219, 241, 185, 169, 77, 159, 44,
    97, 85, 26, 24, 213, 137, 227, 119, 4, 39, 97, 122, 51, 45, 7, 38, 56, 131, 246, 177, 216, 155,
    221, 56, 184, 247, 50, 152, 123, 39, 50, 148, 22, 128, 130, 146, 188, 47, 64, 249, 55, 228, 219,
    231, 78, 173, 27, 112, 156, 7, 6, 182, 237, 144, 211, 99, 76, 237, 253, 71, 195, 176, 127, 255,
    133, 100, 246, 228, 72, 99, 185, 245, 169, 9, 120, 97, 41, 205, 232, 191, 251, 142, 130, 132,
    150, 224, 128, 148, 214, 202, 208, 109, 89, 195, 182, 138, 163, 203, 164, 85, 195, 247, 213, 25,
    22, 224, 112, 224, 199, 76, 185, 191, 157, 105, 2, 234, 210, 243, 213, 209, 80, 0, 85, 247, 112,
    25, 230, 81, 49, 95, 217, 157, 117, 9, 48, 242, 20, 192, 78, 64, 78, 148, 192, 84, 89, 183, 187,
    249, 228, 145, 45, 105, 24, 156, 101, 15, 252, 231, 96, 224, 188, 58, 61, 119, 0, 228, 95, 186,
    150, 74, 199, 208, 8, 171, 96, 47, 97, 49, 54, 186, 27, 145, 208, 44, 81, 94, 187, 65, 155, 197,
    162, 82, 152, 52, 225, 239, 33, 158, 183, 236, 158, 81, 112, 2, 111, 232, 225, 190, 41, 28, 228,
    99, 221, 32, 128, 29, 91, 47, 191, 68, 129, 191, 52, 19, 76, 84, 244, 234, 69, 33, 239, 213,
    168, 149, 89, 164, 165, 26, 251, 201, 217, 1, 133, 247, 214, 89, 74, 176, 35, 136, 203, 136, 40,
    140, 168, 61, 149, 126, 207, 86, 37, 224, 118, 124, 204, 193, 110, 189, 119, 34, 163, 31, 247,
    97, 232, 253, 197, 17, 92, 24, 121, 165, 99, 55, 121, 41, 172, 204, 107, 19, 226, 171, 17, 226,
    76, 117, 157, 9, 66, 200, 95, 193, 105, 87, 52, 111, 218, 230, 232, 102, 82, 143, 234, 175, 109,
    89, 7, 217, 153, 116, 233, 18, 225, 23, 108, 184, 150, 133, 188, 70, 73, 156, 163, 163, 197, 25,
    145, 200, 42, 195, 80, 228, 143, 137, 88, 111, 37, 40, 228, 141, 107, 15, 144, 33, 1, 24, 126,
    94, 182, 91, 247, 3, 111, 37, 4, 231, 48, 218, 109, 166, 231, 223, 52, 60, 100, 247, 120, 190,
    128, 236, 152, 151, 13, 186, 212, 191, 115, 113, 82, 161, 1, 194, 195, 171, 186, 157, 141, 76,
    148, 77, 169, 71, 48, 144, 4, 161, 172, 240, 160, 36, 179, 1, 96, 3, 105, 148, 124, 48, 144,
    128, 21, 6, 146, 159, 212, 24, 185, 84, 93, 51, 121, 34, 106, 77, 32, 152, 201, 54, 216, 144,
    236, 241, 236, 174, 21, 73, 36, 110, 143, 204, 133, 217, 192, 41, 0, 0, 187, 208, 71, 122, 250,
    147, 10, 212, 26, 57, 226, 112, 180, 130, 231, 63, 202, 82, 26, 31, 75, 101, 128, 93, 209, 255,
    146, 146, 73, 71, 246, 54, 248, 72, 229, 150, 243, 95, 196, 99, 51, 153, 171, 176, 41, 68, 44,
    183, 28, 16, 182, 121, 239, 105, 27, 211, 94, 102, 237, 74, 251, 237, 43, 241, 199, 252, 30, 83,
    192, 141, 67, 206, 203, 51, 38, 92, 118, 57, 129, 122, 179, 123, 138, 222, 43, 167, 210, 189,
    122, 90, 233, 180, 235, 163, 213, 96, 11, 146, 20, 56, 1, 110, 1, 241, 188, 194, 185, 9, 248,
    254, 80, 71, 71, 24, 28, 85, 185, 30, 47, 246, 153, 237, 195, 125, 72, 189, 222, 222, 27, 206,
    163, 39, 189, 219, 255, 218, 33, 147, 0, 186, 228, 182, 243, 159, 22, 152, 123, 224, 94, 140,
    109, 203, 21, 121, 16, 30, 183, 233, 156, 65, 32, 204, 173, 144, 187, 90, 21, 247, 124, 69, 154,
    150, 200, 110, 252, 131, 160, 110, 153, 1, 151, 210, 66, 173, 209, 97, 244, 219, 153, 139, 221,
    144, 201, 191, 65, 70, 171, 161, 193, 61, 195, 36, 1, 157, 114, 84, 238, 159, 146, 158, 151, 27,
    57, 240, 101, 10, 45, 84, 87, 140, 74, 194, 156, 186, 215, 99, 57, 247, 144, 223, 4, 76, 245,
    55, 114, 50, 117, 61, 185, 33, 170, 89, 238, 61, 97, 119, 220, 170, 207, 214, 201, 67, 45, 247,
    103, 109, 19, 85, 207, 228, 86, 72, 102, 11, 80, 18, 30, 141, 10, 64, 179, 252, 46, 151, 215,
    216, 62, 76, 90, 218, 12, 2, 86, 56, 58, 135, 48, 215, 154, 73, 45, 238, 144, 56, 116, 133, 51,
    137, 96, 119, 39, 141, 185, 164, 106, 93, 132, 52, 38, 192, 112, 73, 194, 10, 2, 52, 4, 2, 196,
    93, 44, 13, 205, 205, 105, 135, 97, 66, 110, 69, 231, 21, 131, 115, 54, 62, 29, 64, 74, 104, 6,
    87, 81, 90, 87, 117, 212, 16, 71, 241, 156, 90, 91, 7, 98, 210, 57, 57, 90, 68, 168, 178, 113,
    1, 40, 137, 91, 7, 93, 73, 171, 61, 22, 98, 9, 163, 135, 15, 210, 25, 0, 102, 124, 54, 75, 80,
    102, 117, 137, 64, 68, 146, 162, 95, 152, 140, 5, 179, 38, 189, 20, 197, 150, 152, 134, 107,
    176, 2, 33, 144, 38, 49, 243, 212, 49, 3, 144, 217, 145, 51, 8, 227, 20, 204, 7
};

/* What all weights share: the closed form preetham_zenith. */
static inline skylight_sh_4_bands_0_1pct_packed_real skylight_sh_4_bands_0_1pct_packed_scale(const
    skylight_sh_4_bands_0_1pct_packed_real *x)
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
static inline void skylight_sh_4_bands_0_1pct_packed_first(const
    skylight_sh_4_bands_0_1pct_packed_real *x, skylight_sh_4_bands_0_1pct_packed_real *out)
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
    out[10] = 0;
    out[11] = 0;
    (void)x;
}

/* All products of the functions of turbidity (change of variable:
   reciprocal). */
static inline void skylight_sh_4_bands_0_1pct_packed_others(const
    skylight_sh_4_bands_0_1pct_packed_real *x, skylight_sh_4_bands_0_1pct_packed_real *out)
{
    out[0] = 1.0f;
    out[1] = (-4.57142878f) * (x[1] - 2.5f) / ((-2.0f) - x[1]) - 1.0f;
    out[2] = 2.0f * out[1] * out[1] - 1.0f;
    out[3] = 2.0f * out[1] * out[2] - out[1];
    out[4] = 2.0f * out[2] * out[2] - 1.0f;
    out[5] = 2.0f * out[2] * out[3] - out[1];
    (void)x;
}

/* cos(m azimuth) and sin(m azimuth) for m < bands, by doubling. */
static inline void skylight_sh_4_bands_0_1pct_packed_waves(skylight_sh_4_bands_0_1pct_packed_real
    azimuth, skylight_sh_4_bands_0_1pct_packed_real *cosines,
    skylight_sh_4_bands_0_1pct_packed_real *sines)
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
static inline float skylight_sh_4_bands_0_1pct_packed_sinc(float share)
{
    const float x = 3.14159274f * share;
    return sinf(x) / x;
}

/* Of each axis: where its functions have slopes. */
static const double
    skylight_sh_4_bands_0_1pct_packed_slope_range[SKYLIGHT_SH_4_BANDS_0_1PCT_PACKED_AXES][2] = { {
    0.0, 1.5707963267948966 }, { 2.5, 6.0 } };

/* The functions of an axis at v, and their slopes. */
static inline void skylight_sh_4_bands_0_1pct_packed_functions(int axis, double v, double *out,
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
        slopes[0] = 0.0;
        slopes[1] = (-4.5714285714285712) / part_1 - part_2 * -1.0 / part_1;
        slopes[2] = 2.0 * slopes[1] * out[1] + part_3 * slopes[1];
        slopes[3] = 2.0 * slopes[1] * out[2] + part_4 * slopes[2] - slopes[1];
        slopes[4] = 2.0 * slopes[2] * out[2] + part_5 * slopes[2];
        slopes[5] = 2.0 * slopes[2] * out[3] + part_6 * slopes[3] - slopes[1];
    }
    (void)v;
}

/* What all weights share, then its slopes after the axes. */
static inline void skylight_sh_4_bands_0_1pct_packed_scale_slopes(const double *x, double *out)
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
static inline int skylight_sh_4_bands_0_1pct_packed_kind(float v)
{
    uint32_t bits;
    memcpy(&bits, &v, sizeof bits);
    bits &= 0x7fffffffu;
    return (bits >= 0x7f800000u) + (bits > 0x7f800000u);
}

/* A number that is no NaN, finite: an infinity becomes a large number of its sign. */
static inline float skylight_sh_4_bands_0_1pct_packed_finite(float v)
{
    if (skylight_sh_4_bands_0_1pct_packed_kind(v)) {
        uint32_t bits;
        memcpy(&bits, &v, sizeof bits);
        v = bits >> 31 ? -3e38f : 3e38f;
    }
    return v;
}

/* Clamps the axes' inputs into x. Returns the status: 0; 1 where one was not inside; 2, and nothing
   in x, where one is NaN or the azimuth no finite number. */
static inline int skylight_sh_4_bands_0_1pct_packed_inputs(const float
    inputs[SKYLIGHT_SH_4_BANDS_0_1PCT_PACKED_AXES], float azimuth,
                                     skylight_sh_4_bands_0_1pct_packed_real
                                         x[SKYLIGHT_SH_4_BANDS_0_1PCT_PACKED_AXES])
{
    int axis, status = 0, strange = skylight_sh_4_bands_0_1pct_packed_kind(azimuth) ? 2 : 0;
    for (axis = 0; axis < SKYLIGHT_SH_4_BANDS_0_1PCT_PACKED_AXES; ++axis) strange |=
        skylight_sh_4_bands_0_1pct_packed_kind(inputs[axis]);
    if (strange & 2) return 2;
    for (axis = 0; axis < SKYLIGHT_SH_4_BANDS_0_1PCT_PACKED_AXES; ++axis) {
        const float v = skylight_sh_4_bands_0_1pct_packed_finite(inputs[axis]);
        const skylight_sh_4_bands_0_1pct_packed_real low =
            skylight_sh_4_bands_0_1pct_packed_range[axis][0],
            high = skylight_sh_4_bands_0_1pct_packed_range[axis][1];
        const skylight_sh_4_bands_0_1pct_packed_real at_least =
            (skylight_sh_4_bands_0_1pct_packed_real)v < low ? low :
            (skylight_sh_4_bands_0_1pct_packed_real)v;
        status |= (v < skylight_sh_4_bands_0_1pct_packed_inside[axis][0]) | (v >
            skylight_sh_4_bands_0_1pct_packed_inside[axis][1]);
        x[axis] = at_least > high ? high : at_least;
    }
    return status;
}

/* Orders m >= 0 alone are stored: those of a light that is even in y at azimuth 0. */
#define SKYLIGHT_SH_4_BANDS_0_1PCT_PACKED_FIRST_ORDER(l) 0

/* Stores the weight of degree l and order m turned by the azimuth (Habel et al. 2008, eq. 4). */
static inline void skylight_sh_4_bands_0_1pct_packed_place(skylight_sh_4_bands_0_1pct_packed_real
    value, int l, int m,
                                     const skylight_sh_4_bands_0_1pct_packed_real *cosines,
                                         const skylight_sh_4_bands_0_1pct_packed_real *sines,
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
} skylight_sh_4_bands_0_1pct_packed_bits;

static inline void skylight_sh_4_bands_0_1pct_packed_fill(skylight_sh_4_bands_0_1pct_packed_bits *b)
{
    const unsigned char *const end = skylight_sh_4_bands_0_1pct_packed_stream + sizeof
        skylight_sh_4_bands_0_1pct_packed_stream;
    while (b->count <= 56 && b->next < end) {
        b->held |= (uint64_t)*b->next++ << b->count;
        b->count += 8;
    }
}

/* `width` bits, at most 31, as a number. */
static inline unsigned
    skylight_sh_4_bands_0_1pct_packed_fixed(skylight_sh_4_bands_0_1pct_packed_bits *b, int width)
{
    unsigned value;
    if (b->count < 32) skylight_sh_4_bands_0_1pct_packed_fill(b);
    value = (unsigned)(b->held & ((UINT64_C(1) << width) - 1));
    b->held >>= width;
    b->count -= width;
    return value;
}

/* A Rice code of `low` low bits: ones, a zero, the low bits; then folded back: 0, 1, 2, 3 -> 0, -1,
   1, -2. */
static inline int skylight_sh_4_bands_0_1pct_packed_rice(skylight_sh_4_bands_0_1pct_packed_bits *b,
    int low)
{
    unsigned high = 0, folded;
    if (b->count < 32) skylight_sh_4_bands_0_1pct_packed_fill(b);
    while (b->held & 1) {
        ++high;
        b->held >>= 1;
        if (--b->count < 1) skylight_sh_4_bands_0_1pct_packed_fill(b);
    }
    b->held >>= 1;
    --b->count;
    folded = (high << low) | skylight_sh_4_bands_0_1pct_packed_fixed(b, low);
    return folded & 1 ? -(int)(folded >> 1) - 1 : (int)(folded >> 1);
}

/* The stream from its start. */
static inline skylight_sh_4_bands_0_1pct_packed_bits skylight_sh_4_bands_0_1pct_packed_open(void)
{
    skylight_sh_4_bands_0_1pct_packed_bits b;
    b.next = skylight_sh_4_bands_0_1pct_packed_stream;
    b.held = 0;
    b.count = 0;
    return b;
}

/* The next band's profile: twice the low bits that its numbers have, by their place in a run. */
static inline void
    skylight_sh_4_bands_0_1pct_packed_next_profile(skylight_sh_4_bands_0_1pct_packed_bits *b,
    int profile[32])
{
    const int used = (int)skylight_sh_4_bands_0_1pct_packed_fixed(b, 5);
    int i;
    for (i = 0; i < used; ++i) profile[i] = (int)skylight_sh_4_bands_0_1pct_packed_fixed(b, 5);
}

/* The length of the next run, by that of the same channel and product at the weight before. */
static inline int
    skylight_sh_4_bands_0_1pct_packed_next_length(skylight_sh_4_bands_0_1pct_packed_bits *b,
    signed char *length)
{
    const int found = *length + skylight_sh_4_bands_0_1pct_packed_rice(b, 0);
    *length = (signed char)found;
    return found;
}

/* The next number, of `size` half low bits. */
static inline int
    skylight_sh_4_bands_0_1pct_packed_next_number(skylight_sh_4_bands_0_1pct_packed_bits *b,
    int size)
{
    return skylight_sh_4_bands_0_1pct_packed_rice(b, size > 0 ? size >> 1 : 0);
}

static const signed char
    skylight_sh_4_bands_0_1pct_packed_run_profile[SKYLIGHT_SH_4_BANDS_0_1PCT_PACKED_RUNS] =
    SKYLIGHT_SH_4_BANDS_0_1PCT_PACKED_RUN_PROFILE;
static const signed char
    skylight_sh_4_bands_0_1pct_packed_channel_profile[SKYLIGHT_SH_4_BANDS_0_1PCT_PACKED_CHANNELS] =
    SKYLIGHT_SH_4_BANDS_0_1PCT_PACKED_CHANNEL_PROFILE;

/* Reads the stream once, forward, and stores the first `bands` bands. */
static inline void skylight_sh_4_bands_0_1pct_packed_combine(const
    skylight_sh_4_bands_0_1pct_packed_real *first,
                                       const skylight_sh_4_bands_0_1pct_packed_real *others,
                                       const skylight_sh_4_bands_0_1pct_packed_real *cosines,
                                       const skylight_sh_4_bands_0_1pct_packed_real *sines,
                                           int bands,
                                       float
                                           weights[SKYLIGHT_SH_4_BANDS_0_1PCT_PACKED_CHANNELS]
                                           [SKYLIGHT_SH_4_BANDS_0_1PCT_PACKED_WEIGHTS])
{
    signed char
        lengths[SKYLIGHT_SH_4_BANDS_0_1PCT_PACKED_CHANNELS][SKYLIGHT_SH_4_BANDS_0_1PCT_PACKED_RUNS];
    int profile[32], i, l, m, channel, other;
    skylight_sh_4_bands_0_1pct_packed_bits bits = skylight_sh_4_bands_0_1pct_packed_open();
    memset(lengths, 0, sizeof lengths);
    memset(profile, 0, sizeof profile);
    for (l = 0; l < bands; ++l) {
        skylight_sh_4_bands_0_1pct_packed_next_profile(&bits, profile);
        for (m = SKYLIGHT_SH_4_BANDS_0_1PCT_PACKED_FIRST_ORDER(l); m <= l; ++m) {
            for (channel = 0; channel < SKYLIGHT_SH_4_BANDS_0_1PCT_PACKED_CHANNELS; ++channel) {
                skylight_sh_4_bands_0_1pct_packed_real value = 0;
                for (other = 0; other < SKYLIGHT_SH_4_BANDS_0_1PCT_PACKED_RUNS; ++other) {
                    const int level = skylight_sh_4_bands_0_1pct_packed_run_profile[other] +
                                      skylight_sh_4_bands_0_1pct_packed_channel_profile[channel];
                    const int length = skylight_sh_4_bands_0_1pct_packed_next_length(&bits,
                        &lengths[channel][other]);
                    skylight_sh_4_bands_0_1pct_packed_real sum = 0;
                    for (i = 0; i < length; ++i) {
                        const int number = skylight_sh_4_bands_0_1pct_packed_next_number(&bits,
                            profile[i] + level);
                        sum += first[i] * (skylight_sh_4_bands_0_1pct_packed_real)number;
                    }
                    value += sum * others[other];
                }
                skylight_sh_4_bands_0_1pct_packed_place(value *
                    SKYLIGHT_SH_4_BANDS_0_1PCT_PACKED_STEP, l, m, cosines, sines,
                                  weights[channel]);
            }
        }
    }
}

/* The same in double precision, all bands: what derivatives need, whose terms cancel. */
static inline void skylight_sh_4_bands_0_1pct_packed_combine_double(
    const double *first, const double *others,
        const skylight_sh_4_bands_0_1pct_packed_real *cosines,
    const skylight_sh_4_bands_0_1pct_packed_real *sines,
        float
        weights[SKYLIGHT_SH_4_BANDS_0_1PCT_PACKED_CHANNELS]
        [SKYLIGHT_SH_4_BANDS_0_1PCT_PACKED_WEIGHTS])
{
    signed char
        lengths[SKYLIGHT_SH_4_BANDS_0_1PCT_PACKED_CHANNELS][SKYLIGHT_SH_4_BANDS_0_1PCT_PACKED_RUNS];
    int profile[32], i, l, m, channel, other;
    skylight_sh_4_bands_0_1pct_packed_bits bits = skylight_sh_4_bands_0_1pct_packed_open();
    memset(lengths, 0, sizeof lengths);
    memset(profile, 0, sizeof profile);
    for (l = 0; l < SKYLIGHT_SH_4_BANDS_0_1PCT_PACKED_BANDS; ++l) {
        skylight_sh_4_bands_0_1pct_packed_next_profile(&bits, profile);
        for (m = SKYLIGHT_SH_4_BANDS_0_1PCT_PACKED_FIRST_ORDER(l); m <= l; ++m) {
            for (channel = 0; channel < SKYLIGHT_SH_4_BANDS_0_1PCT_PACKED_CHANNELS; ++channel) {
                double value = 0.0;
                for (other = 0; other < SKYLIGHT_SH_4_BANDS_0_1PCT_PACKED_RUNS; ++other) {
                    const int level = skylight_sh_4_bands_0_1pct_packed_run_profile[other] +
                                      skylight_sh_4_bands_0_1pct_packed_channel_profile[channel];
                    const int length = skylight_sh_4_bands_0_1pct_packed_next_length(&bits,
                        &lengths[channel][other]);
                    double sum = 0.0;
                    for (i = 0; i < length; ++i) {
                        const int number = skylight_sh_4_bands_0_1pct_packed_next_number(&bits,
                            profile[i] + level);
                        sum += first[i] * (double)number;
                    }
                    value += sum * others[other];
                }
                skylight_sh_4_bands_0_1pct_packed_place((skylight_sh_4_bands_0_1pct_packed_real)(
                    value * (double)SKYLIGHT_SH_4_BANDS_0_1PCT_PACKED_STEP), l, m,
                                  cosines, sines, weights[channel]);
            }
        }
    }
}

/* What becomes of the first `bands` bands once they are stored; the others become 0. */
static inline void skylight_sh_4_bands_0_1pct_packed_finish(int bands, int lights,
    const skylight_sh_4_bands_0_1pct_packed_real *cosines,
                                      const skylight_sh_4_bands_0_1pct_packed_real *sines,
                                      float
                                          weights[SKYLIGHT_SH_4_BANDS_0_1PCT_PACKED_CHANNELS]
                                          [SKYLIGHT_SH_4_BANDS_0_1PCT_PACKED_WEIGHTS])
{
    if (bands < SKYLIGHT_SH_4_BANDS_0_1PCT_PACKED_BANDS) {
        int channel, i;
        for (channel = 0; channel < SKYLIGHT_SH_4_BANDS_0_1PCT_PACKED_CHANNELS; ++channel)
            for (i = bands * bands; i < SKYLIGHT_SH_4_BANDS_0_1PCT_PACKED_WEIGHTS; ++i)
                weights[channel][i] = 0.0f;
    }
    (void)lights;
    (void)cosines;
    (void)sines;
}

/* Evaluates the first `bands` bands (1 to SKYLIGHT_SH_4_BANDS_0_1PCT_PACKED_BANDS, clamped like an
 * input) and zeroes the
   rest; returns the status. */
static inline int skylight_sh_4_bands_0_1pct_packed_evaluate(const float
    inputs[SKYLIGHT_SH_4_BANDS_0_1PCT_PACKED_AXES], float azimuth,
                                       int bands,
                                       float
                                           weights[SKYLIGHT_SH_4_BANDS_0_1PCT_PACKED_CHANNELS]
                                           [SKYLIGHT_SH_4_BANDS_0_1PCT_PACKED_WEIGHTS])
{
    skylight_sh_4_bands_0_1pct_packed_real x[SKYLIGHT_SH_4_BANDS_0_1PCT_PACKED_AXES],
        first[SKYLIGHT_SH_4_BANDS_0_1PCT_PACKED_FIRST],
        others[SKYLIGHT_SH_4_BANDS_0_1PCT_PACKED_OTHERS];
    skylight_sh_4_bands_0_1pct_packed_real cosines[SKYLIGHT_SH_4_BANDS_0_1PCT_PACKED_BANDS],
        sines[SKYLIGHT_SH_4_BANDS_0_1PCT_PACKED_BANDS], scale;
    int i, status = skylight_sh_4_bands_0_1pct_packed_inputs(inputs, azimuth, x);
    if (status == 2) {
        memset(weights, 0, sizeof(float) * SKYLIGHT_SH_4_BANDS_0_1PCT_PACKED_CHANNELS *
            SKYLIGHT_SH_4_BANDS_0_1PCT_PACKED_WEIGHTS);
        return 2;
    }
    if (bands < 1 || bands > SKYLIGHT_SH_4_BANDS_0_1PCT_PACKED_BANDS) {
        bands = bands < 1 ? 1 : SKYLIGHT_SH_4_BANDS_0_1PCT_PACKED_BANDS;
        status = 1;
    }
    scale = skylight_sh_4_bands_0_1pct_packed_scale(x) *
        (skylight_sh_4_bands_0_1pct_packed_real)SKYLIGHT_SH_4_BANDS_0_1PCT_PACKED_EXPOSURE;
    skylight_sh_4_bands_0_1pct_packed_first(x, first);
    skylight_sh_4_bands_0_1pct_packed_others(x, others);
    for (i = 0; i < SKYLIGHT_SH_4_BANDS_0_1PCT_PACKED_OTHERS; ++i) others[i] *= scale;
    skylight_sh_4_bands_0_1pct_packed_waves((skylight_sh_4_bands_0_1pct_packed_real)azimuth,
        cosines, sines);
    skylight_sh_4_bands_0_1pct_packed_combine(first, others, cosines, sines, bands, weights);
    skylight_sh_4_bands_0_1pct_packed_finish(bands, 1, cosines, sines, weights);
    return status;
}

/* Evaluates `count` suns from arrays, one an axis, and one of azimuths (or none, where the table
   fixes it); returns the largest status. */
static inline int skylight_sh_4_bands_0_1pct_packed_evaluate_batch(
    int count, const float *const inputs[SKYLIGHT_SH_4_BANDS_0_1PCT_PACKED_AXES],
        const float *azimuths,
    float
        (*weights)[SKYLIGHT_SH_4_BANDS_0_1PCT_PACKED_CHANNELS]
        [SKYLIGHT_SH_4_BANDS_0_1PCT_PACKED_WEIGHTS])
{
    int s, axis, worst = 0;
    for (s = 0; s < count; ++s) {
        const float azimuth = azimuths ? azimuths[s] : SKYLIGHT_SH_4_BANDS_0_1PCT_PACKED_AZIMUTH;
        float sun[SKYLIGHT_SH_4_BANDS_0_1PCT_PACKED_AXES];
        int status;
        for (axis = 0; axis < SKYLIGHT_SH_4_BANDS_0_1PCT_PACKED_AXES; ++axis) sun[axis] =
            inputs[axis][s];
        status = skylight_sh_4_bands_0_1pct_packed_evaluate(sun, azimuth,
            SKYLIGHT_SH_4_BANDS_0_1PCT_PACKED_BANDS, weights[s]);
        worst = status > worst ? status : worst;
    }
    return worst;
}

/* All products of `count` numbers and `size` functions, the functions' place fastest; returns how
   many. */
static inline int skylight_sh_4_bands_0_1pct_packed_multiply(double *products, int count,
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
static inline int skylight_sh_4_bands_0_1pct_packed_evaluate_gradient(
    const float inputs[SKYLIGHT_SH_4_BANDS_0_1PCT_PACKED_AXES], float azimuth,
    float
        weights[SKYLIGHT_SH_4_BANDS_0_1PCT_PACKED_CHANNELS]
        [SKYLIGHT_SH_4_BANDS_0_1PCT_PACKED_WEIGHTS],
    float
        gradient[SKYLIGHT_SH_4_BANDS_0_1PCT_PACKED_AXES][SKYLIGHT_SH_4_BANDS_0_1PCT_PACKED_CHANNELS]
        [SKYLIGHT_SH_4_BANDS_0_1PCT_PACKED_WEIGHTS])
{
    static const int sizes[SKYLIGHT_SH_4_BANDS_0_1PCT_PACKED_AXES] =
        SKYLIGHT_SH_4_BANDS_0_1PCT_PACKED_SIZES;
    double x[SKYLIGHT_SH_4_BANDS_0_1PCT_PACKED_AXES],
        functions[SKYLIGHT_SH_4_BANDS_0_1PCT_PACKED_AXES][SKYLIGHT_SH_4_BANDS_0_1PCT_PACKED_MOST];
    double slopes[SKYLIGHT_SH_4_BANDS_0_1PCT_PACKED_AXES][SKYLIGHT_SH_4_BANDS_0_1PCT_PACKED_MOST],
        scale[1 + SKYLIGHT_SH_4_BANDS_0_1PCT_PACKED_AXES];
    skylight_sh_4_bands_0_1pct_packed_real cosines[SKYLIGHT_SH_4_BANDS_0_1PCT_PACKED_BANDS],
        sines[SKYLIGHT_SH_4_BANDS_0_1PCT_PACKED_BANDS];
    int axis, other, i;
    const int status = skylight_sh_4_bands_0_1pct_packed_evaluate(inputs, azimuth,
        SKYLIGHT_SH_4_BANDS_0_1PCT_PACKED_BANDS, weights);
    if (status == 2) {
        memset(gradient, 0,
               sizeof(float) * SKYLIGHT_SH_4_BANDS_0_1PCT_PACKED_AXES *
                   SKYLIGHT_SH_4_BANDS_0_1PCT_PACKED_CHANNELS *
                   SKYLIGHT_SH_4_BANDS_0_1PCT_PACKED_WEIGHTS);
        return 2;
    }
    for (axis = 0; axis < SKYLIGHT_SH_4_BANDS_0_1PCT_PACKED_AXES; ++axis) {
        const double low = skylight_sh_4_bands_0_1pct_packed_slope_range[axis][0];
        const double high = skylight_sh_4_bands_0_1pct_packed_slope_range[axis][1];
        const double v = (double)skylight_sh_4_bands_0_1pct_packed_finite(inputs[axis]);
        x[axis] = v < low ? low : v > high ? high : v;
        skylight_sh_4_bands_0_1pct_packed_functions(axis, x[axis], functions[axis], slopes[axis]);
    }
    skylight_sh_4_bands_0_1pct_packed_scale_slopes(x, scale);
    for (i = 0; i < 1 + SKYLIGHT_SH_4_BANDS_0_1PCT_PACKED_AXES; ++i) scale[i] *=
        (double)SKYLIGHT_SH_4_BANDS_0_1PCT_PACKED_EXPOSURE;
    skylight_sh_4_bands_0_1pct_packed_waves((skylight_sh_4_bands_0_1pct_packed_real)azimuth,
        cosines, sines);
    for (axis = 0; axis < SKYLIGHT_SH_4_BANDS_0_1PCT_PACKED_AXES; ++axis) {
        double first[SKYLIGHT_SH_4_BANDS_0_1PCT_PACKED_MOST],
            others[SKYLIGHT_SH_4_BANDS_0_1PCT_PACKED_OTHERS];
        int count = 1;
        others[0] = 1.0;
        for (other = 0; other < SKYLIGHT_SH_4_BANDS_0_1PCT_PACKED_AXES; ++other) {
            double one[SKYLIGHT_SH_4_BANDS_0_1PCT_PACKED_MOST];
            for (i = 0; i < sizes[other]; ++i) {
                one[i] = functions[other][i];
                if (other == axis) one[i] = scale[0] * slopes[axis][i] + scale[1 + axis] * one[i];
                if (other == 0) first[i] = one[i];
            }
            if (other) count = skylight_sh_4_bands_0_1pct_packed_multiply(others, count, one,
                sizes[other]);
        }
        skylight_sh_4_bands_0_1pct_packed_combine_double(first, others, cosines, sines,
            gradient[axis]);
        skylight_sh_4_bands_0_1pct_packed_finish(SKYLIGHT_SH_4_BANDS_0_1PCT_PACKED_BANDS, 0,
            cosines, sines, gradient[axis]);
    }
    return status;
}

SKYLIGHT_SH_4_BANDS_0_1PCT_PACKED_API int skylight_sh_4_bands_0_1pct_packed_weights(float
    sun_zenith, float sun_azimuth, float turbidity,
    float
    weights[SKYLIGHT_SH_4_BANDS_0_1PCT_PACKED_CHANNELS][SKYLIGHT_SH_4_BANDS_0_1PCT_PACKED_WEIGHTS])
{
    const float skylight_sh_4_bands_0_1pct_packed_given[SKYLIGHT_SH_4_BANDS_0_1PCT_PACKED_AXES] = {
        sun_zenith, turbidity };
    return skylight_sh_4_bands_0_1pct_packed_evaluate(skylight_sh_4_bands_0_1pct_packed_given,
        sun_azimuth, SKYLIGHT_SH_4_BANDS_0_1PCT_PACKED_BANDS, weights);
}

SKYLIGHT_SH_4_BANDS_0_1PCT_PACKED_API int skylight_sh_4_bands_0_1pct_packed_weights_bands(float
    sun_zenith, float sun_azimuth, float turbidity, int bands,
    float
    weights[SKYLIGHT_SH_4_BANDS_0_1PCT_PACKED_CHANNELS][SKYLIGHT_SH_4_BANDS_0_1PCT_PACKED_WEIGHTS])
{
    const float skylight_sh_4_bands_0_1pct_packed_given[SKYLIGHT_SH_4_BANDS_0_1PCT_PACKED_AXES] = {
        sun_zenith, turbidity };
    return skylight_sh_4_bands_0_1pct_packed_evaluate(skylight_sh_4_bands_0_1pct_packed_given,
        sun_azimuth, bands, weights);
}

SKYLIGHT_SH_4_BANDS_0_1PCT_PACKED_API int skylight_sh_4_bands_0_1pct_packed_weights_batch(int count,
    const float *sun_zenith, const float *sun_azimuth, const float *turbidity,
    float
    (*weights)[SKYLIGHT_SH_4_BANDS_0_1PCT_PACKED_CHANNELS]
    [SKYLIGHT_SH_4_BANDS_0_1PCT_PACKED_WEIGHTS])
{
    const float *const
        skylight_sh_4_bands_0_1pct_packed_given[SKYLIGHT_SH_4_BANDS_0_1PCT_PACKED_AXES] = {
        sun_zenith, turbidity };
    return skylight_sh_4_bands_0_1pct_packed_evaluate_batch(count,
        skylight_sh_4_bands_0_1pct_packed_given, sun_azimuth, weights);
}

SKYLIGHT_SH_4_BANDS_0_1PCT_PACKED_API int skylight_sh_4_bands_0_1pct_packed_weights_gradient(float
    sun_zenith, float sun_azimuth, float turbidity,
    float
    weights[SKYLIGHT_SH_4_BANDS_0_1PCT_PACKED_CHANNELS][SKYLIGHT_SH_4_BANDS_0_1PCT_PACKED_WEIGHTS],
    float
    gradient[SKYLIGHT_SH_4_BANDS_0_1PCT_PACKED_AXES][SKYLIGHT_SH_4_BANDS_0_1PCT_PACKED_CHANNELS]
    [SKYLIGHT_SH_4_BANDS_0_1PCT_PACKED_WEIGHTS])
{
    const float skylight_sh_4_bands_0_1pct_packed_given[SKYLIGHT_SH_4_BANDS_0_1PCT_PACKED_AXES] = {
        sun_zenith, turbidity };
    return
        skylight_sh_4_bands_0_1pct_packed_evaluate_gradient(skylight_sh_4_bands_0_1pct_packed_given,
        sun_azimuth, weights, gradient);
}

/* The dominant light's direction, a unit vector: where the linear part of the weights, summed over
   channels by luminance, points. Returns 0, or 1 (and straight up) where it points nowhere. */
SKYLIGHT_SH_4_BANDS_0_1PCT_PACKED_API int skylight_sh_4_bands_0_1pct_packed_dominant_of(const float
    *weights, float direction[3])
{
    static const float luminance[SKYLIGHT_SH_4_BANDS_0_1PCT_PACKED_CHANNELS] =
        SKYLIGHT_SH_4_BANDS_0_1PCT_PACKED_LUMINANCE;
    float x = 0.0f, y = 0.0f, z = 0.0f, length;
    int channel;
    for (channel = 0; channel < SKYLIGHT_SH_4_BANDS_0_1PCT_PACKED_CHANNELS; ++channel) {
        const float *const linear = weights + channel * SKYLIGHT_SH_4_BANDS_0_1PCT_PACKED_WEIGHTS +
            1;
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
SKYLIGHT_SH_4_BANDS_0_1PCT_PACKED_API void skylight_sh_4_bands_0_1pct_packed_ground(
    const float albedo[SKYLIGHT_SH_4_BANDS_0_1PCT_PACKED_CHANNELS],
    float
        weights[SKYLIGHT_SH_4_BANDS_0_1PCT_PACKED_CHANNELS]
        [SKYLIGHT_SH_4_BANDS_0_1PCT_PACKED_WEIGHTS])
{
    static const float lower[SKYLIGHT_SH_4_BANDS_0_1PCT_PACKED_BANDS] =
        SKYLIGHT_SH_4_BANDS_0_1PCT_PACKED_LOWER;
    int l, channel;
    for (channel = 0; channel < SKYLIGHT_SH_4_BANDS_0_1PCT_PACKED_CHANNELS; ++channel) {
        const float radiance = albedo[channel] * SKYLIGHT_SH_4_BANDS_0_1PCT_PACKED_REFLECTED *
            weights[channel][2];
        for (l = 0; l < SKYLIGHT_SH_4_BANDS_0_1PCT_PACKED_BANDS; ++l) weights[channel][l * (l + 1)]
            += radiance * lower[l];
    }
}

/* Tames the ringing of the horizon in the first `bands` bands by the zonal window sinc(pi l /
   bands) (Habel et al. 2008, eq. 5). */
SKYLIGHT_SH_4_BANDS_0_1PCT_PACKED_API void skylight_sh_4_bands_0_1pct_packed_window(
    int bands, float
        weights[SKYLIGHT_SH_4_BANDS_0_1PCT_PACKED_CHANNELS]
        [SKYLIGHT_SH_4_BANDS_0_1PCT_PACKED_WEIGHTS])
{
    int l, channel;
    for (l = 1; l < bands && l < SKYLIGHT_SH_4_BANDS_0_1PCT_PACKED_BANDS; ++l) {
        const float factor = skylight_sh_4_bands_0_1pct_packed_sinc((float)l / (float)bands);
        for (channel = 0; channel < SKYLIGHT_SH_4_BANDS_0_1PCT_PACKED_CHANNELS; ++channel)
            weights[channel][l * (l + 1)] *= factor;
    }
}

#endif /* SKYLIGHT_SH_4_BANDS_0_1PCT_PACKED_DEFINED */
