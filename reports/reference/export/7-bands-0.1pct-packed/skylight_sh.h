/* Preetham sky (published constants, srgb): spherical-harmonics weights, evaluated from
 * polynomials.
 *
 * Written by skylight-sh 0.1.0; the table and this code may be used by anyone for anything
 * (CC0-1.0).
 * C99 and C++11, no allocation, no global written, nothing static but constants: any thread may
 * call it.
 *
 * Usage
 *   float w[SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_CHANNELS][SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_WEIGHTS];
 *   int status = skylight_sh_7_bands_0_1pct_packed_weights(0.785000026f, 0.0f, 4.25f, w);
 * Compile with, for instance
 *   cc -std=c99 -O3 program.c -o program -lm
 * Included plainly, the file is all there is: its functions are static, and the table stands in
 * every unit that includes it. With SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_EXTERN defined before it, it
 * declares only; the one unit that also defines SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_IMPLEMENTATION
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
 *   Define SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_EXPOSURE before this file (where it holds the table)
 *   to multiply all weights (1 by default).
 *
 * Accuracy, as shipped: E_mean 0.0944 %, E_max 0.41 % of the least luminance of the same sky, at
 * azimuth 0.
 * The expansion rings: the least value it takes, over all directions and measured sets, is -12.7 %
 * of its largest in the same set; the window below tames it.
 * Memory: 3253 bytes of constants, packed into few bytes (a fast table takes more and less time).
 *
 * Provenance
 *   skylight-sh 0.1.0, config preetham 7738be1e848979ca, table 7-bands-0.1pct-packed
 */
#ifdef __cplusplus
#if __cplusplus < 201103L && !defined(_MSC_VER)
#error "skylight_sh needs C++11 or later: compile with -std=c++11."
#endif
#elif (!defined(__STDC_VERSION__) || __STDC_VERSION__ < 199901L) && !defined(_MSC_VER)
#error "skylight_sh needs C99 or later: compile with -std=c99."
#endif
#if defined(SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_IMPLEMENTATION) && \
    !defined(SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_EXTERN)
#error "Define SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_EXTERN in every unit, \
SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_IMPLEMENTATION beside it in one."
#endif
#if defined(SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_API) && \
    defined(SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_EXTERN) && \
    !defined(SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_DECLARED)
#error "Define SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_EXTERN before this file is included for the first \
time."
#endif
#if defined(SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_DECLARED) && \
    !defined(SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_EXTERN)
#error "Leave SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_EXTERN defined: this file was included with it \
before."
#endif

#ifndef SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_H
#define SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_H 0x56e6dd43

#include <math.h>
#include <stdint.h>
#include <string.h>

#ifndef SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_EXTERN
#define SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_API static inline
#else
#define SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_DECLARED
#ifdef __cplusplus
#define SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_API extern "C"
#else
#define SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_API extern
#endif
#endif
#ifndef SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_EXPOSURE
#define SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_EXPOSURE 1
#endif

#define SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_VERSION "0.1.0"
#define SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_BANDS 7
#define SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_WEIGHTS 49
#define SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_CHANNELS 3
#define SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_AXES 2
#define SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_UNIT "cd/m2"
#define SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_E_MEAN 9.436000e-04
#define SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_E_MAX 4.100000e-03
#define SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_SUN_ZENITH_MIN 0.0f
#define SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_SUN_ZENITH_MAX 1.57079637f
#define SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_TURBIDITY_MIN 2.5f
#define SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_TURBIDITY_MAX 6.0f

/* Evaluates all bands. */
SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_API int skylight_sh_7_bands_0_1pct_packed_weights(float
    sun_zenith, float sun_azimuth, float turbidity,
    float
    weights[SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_CHANNELS][SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_WEIGHTS]);
/* Evaluates the first `bands` bands (1 to SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_BANDS, clamped
   likewise) and zeroes the rest. */
SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_API int skylight_sh_7_bands_0_1pct_packed_weights_bands(float
    sun_zenith, float sun_azimuth, float turbidity, int bands,
    float
    weights[SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_CHANNELS][SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_WEIGHTS]);
/* Evaluates `count` suns from arrays; returns the largest status. No faster
   than single calls. */
SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_API int skylight_sh_7_bands_0_1pct_packed_weights_batch(int count,
    const float *sun_zenith, const float *sun_azimuth, const float *turbidity,
    float
    (*weights)[SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_CHANNELS]
    [SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_WEIGHTS]);
/* Evaluates all bands and their derivatives after each axis (sun_zenith,
   turbidity), per unit of the axis; beyond a range, those at its edge. */
SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_API int skylight_sh_7_bands_0_1pct_packed_weights_gradient(float
    sun_zenith, float sun_azimuth, float turbidity,
    float
    weights[SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_CHANNELS][SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_WEIGHTS],
    float
    gradient[SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_AXES][SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_CHANNELS]
    [SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_WEIGHTS]);
/* Unit vector of the dominant light. Returns 0, or 1 (and straight up) where there is none. */
#define skylight_sh_7_bands_0_1pct_packed_dominant(weights, direction) \
    skylight_sh_7_bands_0_1pct_packed_dominant_of(&(weights)[0][0], direction)
SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_API int skylight_sh_7_bands_0_1pct_packed_dominant_of(const float
    *weights, float direction[3]);
/* Optional: adds an even ground of this albedo below the horizon, lit by the sky (before any
 * window). */
SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_API void skylight_sh_7_bands_0_1pct_packed_ground(const float
    albedo[SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_CHANNELS],
    float
    weights[SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_CHANNELS][SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_WEIGHTS]);
/* Optional: tames the ringing of the horizon by the zonal window of the first `bands` bands. */
SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_API void skylight_sh_7_bands_0_1pct_packed_window(int bands,
    float
    weights[SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_CHANNELS][SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_WEIGHTS]);

#elif SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_H != 0x56e6dd43
#error "Another table has the prefix skylight_sh_7_bands_0_1pct_packed_7_bands_0_1pct_packed \
already: export one of them under a prefix of its own."
#endif /* SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_H */

#if (!defined(SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_EXTERN) || \
    defined(SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_IMPLEMENTATION)) && \
    !defined(SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_DEFINED)
#define SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_DEFINED

typedef float skylight_sh_7_bands_0_1pct_packed_real;

/* Functions of the first axis, in fours; products of the other axes'
   functions. */
#define SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_FIRST 12
#define SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_OTHERS 7
#define SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_SIZES { 12, 7 }
#define SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_MOST 12
#define SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_AZIMUTH 0.0f
/* The channels' luminance. */
#define SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_LUMINANCE { 0.212672845f, 0.715152144f, 0.0721749961f }
/* What an even ground reflects of the weight l = 1, m = 0, and its own
   zonal weights. */
#define SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_REFLECTED 0.651470006f
#define SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_LOWER { 1.7724539f, -1.53499007f, 0.0f, 0.586184025f, \
    0.0f, -0.367410272f, 0.0f }

/* Of each axis: the first and last float that counts as inside, and its
   range. */
static const float
    skylight_sh_7_bands_0_1pct_packed_inside[SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_AXES][2] = { {
    -1.57079626e-06f, 1.5707978f }, { 2.49999666f, 6.00000334f } };
static const skylight_sh_7_bands_0_1pct_packed_real
    skylight_sh_7_bands_0_1pct_packed_range[SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_AXES][2] = { { 0.0f,
    1.57079637f }, { 2.5f, 6.0f } };

/* Runs of numbers, one a product of the other axes' functions, and their
   profiles; what one step is worth. */
#define SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_RUNS 7
#define SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_RUN_PROFILE { 7, 3, -1, -7, -11, -16, -18 }
#define SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_CHANNEL_PROFILE { -4, -4, -3 }
#define SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_STEP 7.62939453e-05f

/* Whole numbers as Rice codes. */
static const unsigned char skylight_sh_7_bands_0_1pct_packed_stream[3059] = {
    105, 91, 42, 165, 50, 100, 252, 255, 11, 193, 61, 2, 209, 31, 235, 11, 36, 10, 227, 255, 255,
    230, 123, 248, 184, 222, 219, 76, 81, 238, 230, 255, 159, 53, 224, 94, 173, 56, 230, 109, 255,
    35, 127, 114, 39, 242, 195, 166, 126, 41, 227, 255, 191, 17, 58, 26, 55, 139, 247, 10, 12, 200,
    130, 254, 127, 3, 16, 95, 165, 222, 37, 237, 67, 244, 255, 207, 126, 149, 231, 64, 235, 188,
    255, 161, 4, 16, 200, 63, 94, 67, 94, 208, 255, 255, 102, 39, 125, 207, 97, 23, 162, 23, 40,
    188, 134, 100, 249, 255, 127, 65, 200, 23, 182, 153, 249, 156, 46, 131, 255, 249, 220, 255, 127,
    139, 207, 49, 56, 77, 222, 166, 127, 158, 251, 255, 105, 136, 93, 251, 253, 161, 251, 127, 0,
    226, 247, 188, 127, 200, 146, 178, 165, 18, 50, 36, 68, 99, 192, 13, 171, 52, 160, 205, 34, 60,
    199, 99, 189, 14, 238, 187, 247, 169, 106, 197, 216, 37, 162, 149, 87, 204, 239, 172, 24, 227,
    107, 90, 42, 117, 154, 210, 89, 169, 55, 108, 118, 198, 117, 147, 136, 156, 158, 141, 255, 198,
    167, 102, 50, 101, 32, 53, 199, 12, 83, 97, 82, 226, 225, 133, 28, 175, 134, 124, 58, 201, 27,
    165, 77, 18, 39, 82, 188, 48, 26, 160, 167, 198, 95, 176, 231, 195, 201, 127, 25, 1, 135, 174,
    55, 244, 225, 62, 34, 194, 171, 158, 227, 83, 241, 132, 254, 111, 255, 232, 129, 88, 123, 253,
    28, 180, 44, 106, 239, 1, 209, 125, 215, 230, 54, 144, 6, 88, 134, 250, 220, 248, 230, 25, 203,
    152, 189, 132, 9, 192, 249, 245, 20, 237, 30, 251, 105, 191, 96, 129, 185, 22, 73, 90, 201, 48,
    245, 198, 77, 15, 154, 72, 192, 135, 201, 67, 235, 98, 78, 134, 182, 100, 49, 158, 177, 195, 0,
    116, 207, 99, 202, 194, 162, 33, 232, 132, 139, 71, 164, 22, 244, 8, 76, 115, 0, 141, 12, 174,
    137, 129, 233, 102, 212, 255, 221, 143, 62, 210, 51, 17, 167, 229, 92, 75, 63, 14, 9, 82, 93,
    230, 159, 47, 0, 136, 243, 39, 89, 75, 37, 100, 200, 12, 59, 169, 175, 37, 128, 126, 64, 138,
    172, 97, 26, 15, 172, 47, 145, 192, 207, 187, 100, 57, 142, 164, 133, 85, 177, 34, 191, 140,
    119, 149, 50, 68, 35, 66, 206, 64, 197, 155, 197, 152, 54, 74, 138, 196, 2, 24, 255, 179, 227,
    221, 156, 231, 148, 22, 140, 70, 229, 109, 174, 125, 122, 3, 161, 223, 27, 242, 22, 195, 36, 54,
    37, 178, 91, 151, 168, 5, 155, 114, 209, 152, 73, 169, 127, 102, 123, 131, 242, 134, 24, 21,
    157, 202, 95, 102, 171, 63, 147, 162, 180, 100, 227, 219, 237, 55, 30, 8, 21, 243, 107, 99, 184,
    244, 211, 194, 51, 221, 249, 201, 11, 112, 194, 112, 234, 6, 186, 253, 64, 157, 214, 127, 9,
    198, 17, 217, 190, 70, 102, 139, 109, 174, 62, 18, 239, 107, 104, 214, 44, 44, 71, 191, 132, 7,
    17, 73, 212, 171, 237, 16, 32, 177, 7, 173, 122, 126, 101, 205, 75, 122, 190, 30, 219, 211, 22,
    68, 227, 137, 26, 43, 156, 17, 193, 120, 193, 66, 164, 105, 7, 242, 226, 202, 39, 58, 211, 180,
    28, 127, 66, 138, 35, 128, 90, 58, 1, 197, 94, 246, 143, 236, 182, 22, 56, 61, 160, 13, 138, 71,
    31, 111, 38, 42, 115, 55, 255, 252, 5, 136, 121, 226, 128, 233, 252, 167, 120, 173, 47, 214,
    232, 112, 214, 84, 139, 240, 253, 170, 61, 113, 174, 117, 198, 21, 35, 178, 52, 112, 116, 192,
    20, 141, 136, 142, 145, 213, 4, 162, 49, 246, 37, 218, 36, 8, 130, 29, 101, 117, 11, 92, 194,
    70, 181, 128, 82, 195, 230, 149, 60, 12, 4, 154, 71, 149, 81, 185, 40, 85, 95, 228, 124, 65, 65,
    166, 197, 66, 250, 227, 74, 88, 11, 24, 128, 139, 216, 177, 51, 219, 171, 52, 217, 74, 201, 131,
    134, 66, 153, 37, 61, 250, 132, 64, 217, 58, 37, 116, 202, 16, 176, 239, 223, 94, 241, 140, 66,
    169, 189, 34, 172, 96, 14, 119, 111, 127, 183, 60, 106, 71, 240, 86, 188, 9, 11, 98, 70, 158,
    128, 132, 15, 191, 34, 122, 204, 110, 23, 102, 181, 111, 152, 46, 3, 102, 221, 112, 90, 57, 190,
    64, 143, 143, 78, 59, 125, 232, 249, 92, 96, 6, 219, 113, 98, 115, 222, 177, 111, 208, 148, 95,
    155, 107, 101, 116, 91, 212, 180, 77, 169, 50, 242, 49, 26, 97, 247, 4, 156, 9, 100, 73, 71,
    228, 247, 146, 80, 141, 164, 48, 82, 245, 203, 195, 200, 230, 254, 173, 53, 231, 72, 251, 60,
    95, 249, 185, 120, 100, 215, 246, 207, 15, 66, 34, 131, 181, 122, 92, 60, 159, 62, 164, 85, 7,
    181, 229, 121, 253, 189, 79, 31, 165, 201, 86, 126, 206, 44, 21, 232, 206, 4, 171, 87, 217, 79,
    44, 63, 74, 64, 173, 31, 222, 226, 158, 37, 66, 53, 24, 38, 27, 129, 186, 185, 32, 15, 104, 135,
    198, 7, 94, 1, 81, 204, 121, 33, 17, 171, 234, 200, 124, 141, 1, 211, 196, 95, 123, 240, 117,
    118, 166, 211, 103, 95, 82, 196, 236, 50, 159, 30, 46, 112, 128, 43, 230, 120, 242, 107, 63,
    221, 9, 233, 201, 183, 7, 164, 237, 251, 244, 192, 135, 187, 145, 127, 139, 160, 61, 108, 40,
    25, 211, 47, 94, 29, 149, 110, 53, 46, 38, 27, 186, 161, 122, 251, 42, 57, 138, 175, 199, 228,
    222, 44, 51, 66, 101, 26, 136, 130, 162, 60, 2, 177, 57, 65, 224, 180, 80, 89, 55, 240, 34, 109,
    88, 144, 29, 19, 237, 71, 27, 188, 85, 205, 22, 82, 218, 108, 240, 37, 148, 211, 136, 64, 157,
    19, 99, 248, 51, 149, 220, 223, 69, 34, 194, 52, 84, 134, 153, 194, 0, 113, 193, 16, 27, 31,
    157, 179, 231, 75, 69, 228, 62, 24, 197, 38, 124, 220, 64, 72, 217, 226, 81, 7, 64, 72, 79, 211,
    107, 49, 235, 107, 161, 72, 82, 32, 149, 55, 41, 98, 126, 137, 192, 17, 182, 242, 228, 135, 139,
    230, 168, 72, 24, 184, 62, 10, 79, 2, 24, 133, 236, 44, 60, 24, 90, 80, 84, 177, 130, 160, 10,
    34, 64, 42, 170, 245, 50, 199, 136, 154, 17, 12, 49, 17, 35, 56, 8, 21, 245, 4, 85, 131, 32, 94,
    138, 30, 153, 145, 72, 137, 59, 108, 177, 152, 203, 35, 35, 148, 164, 100, 108, 110, 43, 166,
    163, 64, 210, 66, 126, 44, 58, 103, 124, 78, 33, 34, 130, 51, 48, 139, 13, 134, 229, 177, 199,
    49, 147, 253, 96, 95, 223, 143, 163, 171, 245, 206, 39, 132, 235, 242, 134, 148, 228, 162, 85,
    44, 56, 41, 36, 220, 205, 66, 131, 133, 142, 107, 245, 176, 129, 83, 161, 148, 226, 251, 238,
    188, 80, 67, 238, 114, 159, 115, 234, 229, 236, 241, 82, 46, 196, 157, 91, 120, 22, 30, 245,
    148, 221, 155, 98, 37, 194, 218, 51, 191, 117, 205, 90, 101, 14, 163, 11, 178, 182, 189, 90,
    199, 4, 68, 201, 144, 151, 236, 143, 238, 179, 197, 253, 42, 188, 135, 187, 237, 208, 207, 126,
    86, 78, 92, 111, 253, 123, 59, 35, 236, 237, 224, 23, 1, 18, 123, 156, 181, 191, 240, 35, 60,
    227, 22, 239, 183, 75, 187, 159, 200, 245, 246, 254, 0, 239, 132, 0, 117, 202, 162, 168, 227,
    219, 219, 12, 134, 175, 139, 108, 47, 124, 149, 195, 174, 243, 126, 247, 170, 59, 186, 96, 49,
    64, 151, 90, 251, 51, 190, 162, 235, 39, 23, 23, 249, 212, 50, 247, 14, 230, 247, 94, 184, 193,
    54, 104, 34, 133, 156, 218, 36, 1, 243, 132, 191, 149, 222, 14, 174, 106, 113, 49, 237, 248,
    130, 7, 191, 104, 172, 209, 247, 249, 20, 131, 179, 200, 124, 219, 131, 169, 23, 255, 218, 13,
    30, 237, 103, 221, 155, 4, 28, 249, 219, 126, 184, 25, 196, 236, 224, 213, 234, 166, 189, 73,
    243, 98, 127, 99, 28, 252, 130, 98, 206, 147, 130, 83, 43, 6, 250, 26, 11, 139, 32, 140, 106,
    132, 133, 56, 32, 179, 95, 189, 37, 82, 154, 75, 240, 171, 27, 64, 134, 165, 147, 97, 215, 12,
    41, 114, 79, 127, 18, 173, 84, 153, 42, 23, 1, 176, 107, 37, 93, 48, 38, 67, 216, 49, 142, 36,
    103, 113, 157, 194, 166, 161, 210, 18, 62, 6, 190, 102, 221, 169, 156, 161, 246, 194, 0, 110,
    203, 5, 81, 101, 126, 33, 37, 205, 154, 211, 81, 121, 41, 188, 16, 16, 46, 65, 54, 174, 35, 208,
    210, 182, 146, 131, 215, 16, 202, 134, 152, 48, 211, 240, 135, 19, 162, 202, 209, 20, 144, 31,
    187, 73, 51, 4, 5, 94, 25, 21, 234, 104, 9, 110, 32, 149, 174, 79, 245, 174, 20, 43, 161, 40, 7,
    193, 152, 57, 7, 16, 74, 141, 5, 201, 137, 1, 197, 162, 13, 7, 11, 129, 152, 69, 82, 42, 0, 21,
    136, 129, 155, 116, 211, 33, 176, 219, 194, 172, 27, 3, 93, 67, 234, 143, 69, 243, 17, 201, 29,
    138, 200, 80, 108, 64, 0, 11, 74, 70, 180, 243, 79, 131, 23, 158, 158, 29, 12, 77, 80, 65, 12,
    84, 88, 118, 202, 121, 54, 163, 122, 125, 216, 97, 12, 98, 130, 68, 90, 1, 64, 69, 121, 155,
    190, 61, 26, 221, 208, 72, 4, 1, 209, 147, 136, 214, 240, 141, 2, 154, 145, 57, 180, 100, 92,
    36, 239, 88, 71, 21, 123, 44, 69, 155, 102, 158, 172, 96, 161, 182, 22, 226, 16, 228, 20, 129,
    53, 163, 140, 175, 177, 100, 8, 216, 127, 50, 249, 177, 56, 32, 215, 106, 135, 142, 72, 182, 33,
    180, 125, 30, 83, 56, 181, 107, 43, 243, 224, 222, 230, 152, 138, 168, 38, 130, 105, 195, 254,
    249, 127, 88, 4, 254, 34, 101, 255, 96, 49, 131, 166, 200, 186, 242, 252, 128, 202, 248, 7, 250,
    204, 125, 247, 167, 223, 151, 246, 89, 155, 246, 81, 107, 237, 172, 159, 6, 223, 133, 124, 255,
    233, 233, 22, 216, 177, 188, 31, 209, 222, 118, 72, 179, 203, 16, 57, 34, 229, 109, 65, 224,
    253, 157, 190, 178, 167, 33, 211, 245, 210, 90, 7, 243, 158, 124, 90, 205, 169, 153, 183, 193,
    209, 253, 63, 135, 183, 237, 220, 249, 125, 77, 44, 67, 240, 112, 60, 6, 2, 239, 29, 211, 112,
    132, 26, 21, 156, 199, 175, 104, 184, 135, 242, 101, 113, 207, 238, 122, 150, 100, 86, 167, 119,
    64, 150, 96, 38, 44, 169, 106, 24, 178, 232, 107, 26, 102, 224, 107, 66, 112, 246, 98, 145, 164,
    241, 247, 131, 116, 142, 87, 142, 29, 189, 140, 89, 172, 193, 55, 181, 62, 163, 110, 185, 169,
    25, 250, 97, 91, 25, 178, 207, 77, 76, 227, 41, 120, 225, 163, 138, 114, 159, 154, 12, 197, 75,
    180, 113, 102, 173, 135, 56, 222, 62, 228, 109, 130, 7, 46, 183, 244, 199, 138, 237, 121, 238,
    213, 199, 116, 155, 151, 151, 34, 210, 126, 244, 119, 150, 193, 15, 2, 64, 239, 132, 55, 161,
    194, 188, 123, 165, 141, 31, 19, 228, 27, 211, 147, 29, 232, 40, 76, 15, 19, 250, 250, 75, 34,
    164, 16, 106, 89, 95, 23, 186, 29, 154, 232, 236, 63, 15, 190, 70, 41, 67, 83, 122, 114, 50, 27,
    103, 225, 21, 9, 158, 69, 221, 105, 28, 150, 90, 109, 153, 20, 83, 28, 38, 46, 27, 67, 59, 134,
    140, 108, 87, 17, 65, 82, 15, 68, 163, 17, 98, 107, 181, 57, 160, 34, 151, 219, 145, 212, 68,
    214, 43, 160, 231, 221, 62, 45, 203, 12, 64, 23, 3, 33, 89, 139, 235, 153, 123, 243, 36, 170,
    26, 144, 216, 18, 66, 225, 74, 16, 77, 87, 209, 207, 194, 169, 41, 18, 36, 50, 68, 253, 57, 69,
    12, 128, 166, 234, 86, 21, 234, 194, 174, 180, 15, 25, 152, 140, 4, 83, 36, 22, 250, 46, 47,
    149, 25, 115, 198, 137, 250, 60, 59, 41, 73, 20, 12, 97, 45, 71, 204, 25, 120, 73, 171, 200,
    101, 24, 228, 70, 34, 79, 153, 68, 200, 201, 217, 225, 162, 173, 151, 40, 174, 109, 53, 79, 150,
    75, 1, 51, 140, 71, 9, 112, 134, 151, 80, 207, 224, 5, 223, 199, 196, 138, 213, 72, 234, 109,
    33, 64, 132, 46, 35, 73, 57, 151, 103, 57, 122, 44, 129, 233, 40, 140, 4, 127, 245, 232, 156,
    68, 196, 110, 30, 24, 78, 52, 116, 91, 160, 6, 232, 36, 244, 232, 141, 196, 219, 158, 25, 64,
    18, 29, 113, 36, 21, 125, 212, 115, 136, 51, 212, 38, 2, 147, 75, 44, 81, 168, 1, 202, 44, 33,
    57, 119, 115, 12, 106, 213, 6, 108, 12, 149, 99, 32, 174, 12, 124, 128, 248, 90, 86, 46, 84, 4,
    18, 158, 25, 217, 83, 42, 128, 101, 92, 78, 78, 14, 138, 80, 88, 0, 19, 194, 230, 112, 23, 135,
    79, 229, 162, 132, 99, 200, 13, 131, 210, 16, 208, 177, 36, 197, 178, 135, 71, 37, 164, 48, 130,
    32, 0, 48, 96, 209, 34, 107, 49, 67, 145, 128, 74, 72, 43, 175, 216, 80, 165, 178, 202, 16, 231,
    228, 226, 162, 121, 22, 5, 68, 70, 17, 48, 25, 225, 123, 141, 165, 67, 4, 216, 122, 92, 157, 54,
    93, 129, 196, 204, 127, 117, 109, 182, 189, 159, 171, 129, 169, 190, 87, 138, 7, 188, 103, 79,
    125, 111, 168, 247, 227, 94, 53, 200, 57, 245, 208, 251, 25, 94, 62, 52, 46, 117, 23, 35, 28,
    179, 189, 138, 40, 191, 188, 31, 152, 137, 71, 184, 46, 218, 180, 203, 201, 248, 238, 191, 65,
    173, 156, 111, 236, 143, 177, 191, 15, 233, 53, 209, 253, 126, 38, 126, 99, 141, 144, 241, 189,
    226, 232, 79, 163, 90, 202, 92, 97, 252, 9, 179, 143, 17, 109, 96, 200, 175, 56, 226, 215, 236,
    247, 215, 156, 69, 254, 177, 157, 219, 49, 95, 123, 127, 106, 191, 106, 116, 250, 29, 116, 217,
    143, 223, 31, 172, 195, 210, 248, 139, 124, 26, 147, 222, 198, 13, 181, 39, 115, 82, 199, 22,
    249, 2, 79, 59, 244, 53, 127, 90, 72, 68, 159, 138, 246, 58, 220, 31, 255, 225, 218, 33, 194,
    158, 97, 39, 117, 140, 187, 114, 217, 78, 104, 138, 139, 3, 67, 143, 69, 139, 3, 207, 112, 153,
    163, 216, 183, 135, 185, 25, 245, 215, 35, 39, 47, 183, 39, 237, 241, 195, 123, 205, 218, 149,
    120, 153, 13, 92, 112, 107, 69, 79, 16, 232, 171, 66, 121, 209, 135, 91, 27, 195, 131, 246, 102,
    171, 23, 63, 212, 93, 120, 240, 229, 212, 243, 223, 84, 127, 250, 45, 125, 188, 188, 207, 205,
    82, 76, 66, 61, 224, 143, 196, 188, 47, 198, 86, 143, 66, 173, 198, 42, 90, 117, 186, 79, 176,
    199, 69, 143, 179, 203, 72, 201, 108, 180, 3, 65, 71, 86, 32, 12, 210, 18, 120, 228, 50, 48, 67,
    222, 245, 237, 156, 10, 210, 158, 178, 189, 90, 237, 83, 245, 40, 59, 91, 46, 159, 82, 103, 173,
    221, 29, 24, 94, 53, 21, 202, 102, 90, 101, 86, 212, 130, 140, 154, 193, 82, 150, 151, 179, 111,
    47, 66, 133, 162, 203, 110, 98, 162, 96, 160, 215, 244, 220, 145, 207, 111, 251, 206, 244, 201,
    5, 62, 85, 9, 179, 65, 31, 19, 182, 96, 174, 251, 93, 57, 129, 225, 219, 77, 131, 100, 199, 73,
    221, 242, 174, 114, 170, 128, 55, 184, 39, 186, 129, 232, 112, 77, 139, 200, 223, 210, 51, 142,
    21, 208, 198, 109, 242, 224, 167, 99, 49, 146, 225, 162, 199, 178, 193, 177, 78, 16, 180, 102,
    118, 80, 93, 200, 17, 249, 245, 198, 148, 87, 85, 39, 20, 9, 241, 131, 143, 205, 55, 33, 244,
    173, 5, 195, 32, 93, 243, 168, 230, 223, 80, 23, 25, 84, 130, 187, 228, 148, 87, 68, 220, 141,
    198, 41, 120, 205, 242, 58, 16, 248, 145, 56, 218, 237, 70, 3, 16, 92, 132, 189, 44, 160, 9,
    138, 205, 117, 141, 210, 2, 250, 44, 153, 80, 17, 68, 84, 192, 153, 16, 49, 200, 203, 87, 131,
    135, 200, 129, 233, 4, 33, 181, 104, 40, 23, 116, 0, 117, 218, 9, 118, 126, 193, 33, 166, 39,
    50, 204, 36, 161, 35, 26, 131, 140, 201, 193, 97, 223, 153, 83, 40, 238, 2, 4, 16, 3, 3, 61, 45,
    48, 44, 53, 9, 155, 6, 16, 109, 24, 85, 3, 0, 66, 112, 161, 157, 228, 85, 171, 52, 6, 176, 49,
    100, 197, 151, 79, 253, 126, 128, 124, 205, 210, 180, 82, 158, 86, 28, 240, 33, 67, 66, 89, 22,
    81, 101, 43, 26, 47, 116, 45, 100, 72, 104, 68, 200, 59, 32, 82, 84, 131, 117, 149, 228, 131,
    154, 39, 34, 164, 4, 148, 68, 36, 207, 122, 10, 31, 68, 61, 58, 140, 164, 147, 72, 124, 121, 24,
    252, 158, 128, 205, 207, 23, 20, 240, 53, 13, 33, 180, 66, 32, 13, 167, 0, 98, 29, 145, 19, 0,
    20, 4, 91, 192, 142, 222, 22, 60, 202, 72, 50, 29, 4, 18, 70, 66, 132, 112, 201, 144, 81, 12,
    104, 110, 23, 17, 160, 220, 120, 147, 68, 160, 66, 25, 42, 177, 26, 196, 17, 39, 1, 65, 8, 45,
    232, 96, 41, 237, 184, 64, 6, 194, 99, 228, 142, 62, 68, 240, 76, 54, 21, 192, 84, 52, 52, 210,
    145, 128, 71, 200, 4
};

/* What all weights share: the closed form preetham_zenith. */
static inline skylight_sh_7_bands_0_1pct_packed_real skylight_sh_7_bands_0_1pct_packed_scale(const
    skylight_sh_7_bands_0_1pct_packed_real *x)
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
static inline void skylight_sh_7_bands_0_1pct_packed_first(const
    skylight_sh_7_bands_0_1pct_packed_real *x, skylight_sh_7_bands_0_1pct_packed_real *out)
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
static inline void skylight_sh_7_bands_0_1pct_packed_others(const
    skylight_sh_7_bands_0_1pct_packed_real *x, skylight_sh_7_bands_0_1pct_packed_real *out)
{
    out[0] = 1.0f;
    out[1] = (-4.57142878f) * (x[1] - 2.5f) / ((-2.0f) - x[1]) - 1.0f;
    out[2] = 2.0f * out[1] * out[1] - 1.0f;
    out[3] = 2.0f * out[1] * out[2] - out[1];
    out[4] = 2.0f * out[2] * out[2] - 1.0f;
    out[5] = 2.0f * out[2] * out[3] - out[1];
    out[6] = 2.0f * out[3] * out[3] - 1.0f;
    (void)x;
}

/* cos(m azimuth) and sin(m azimuth) for m < bands, by doubling. */
static inline void skylight_sh_7_bands_0_1pct_packed_waves(skylight_sh_7_bands_0_1pct_packed_real
    azimuth, skylight_sh_7_bands_0_1pct_packed_real *cosines,
    skylight_sh_7_bands_0_1pct_packed_real *sines)
{
    cosines[0] = 1.0f;
    cosines[1] = cosf(azimuth);
    sines[1] = sinf(azimuth);
    cosines[2] = cosines[1] * cosines[1] - sines[1] * sines[1];
    sines[2] = sines[1] * cosines[1] + cosines[1] * sines[1];
    cosines[3] = cosines[1] * cosines[2] - sines[1] * sines[2];
    cosines[4] = cosines[2] * cosines[2] - sines[2] * sines[2];
    sines[3] = sines[1] * cosines[2] + cosines[1] * sines[2];
    cosines[5] = cosines[2] * cosines[3] - sines[2] * sines[3];
    cosines[6] = cosines[3] * cosines[3] - sines[3] * sines[3];
    sines[0] = 0.0f;
    sines[4] = sines[2] * cosines[2] + cosines[2] * sines[2];
    sines[5] = sines[2] * cosines[3] + cosines[2] * sines[3];
    sines[6] = sines[3] * cosines[3] + cosines[3] * sines[3];
}

/* The zonal window's factor for the degree `share` * bands (Habel et al.
   2008, eq. 5). */
static inline float skylight_sh_7_bands_0_1pct_packed_sinc(float share)
{
    const float x = 3.14159274f * share;
    return sinf(x) / x;
}

/* Of each axis: where its functions have slopes. */
static const double
    skylight_sh_7_bands_0_1pct_packed_slope_range[SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_AXES][2] = { {
    0.0, 1.5707963267948966 }, { 2.5, 6.0 } };

/* The functions of an axis at v, and their slopes. */
static inline void skylight_sh_7_bands_0_1pct_packed_functions(int axis, double v, double *out,
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
        slopes[0] = 0.0;
        slopes[1] = (-4.5714285714285712) / part_1 - part_2 * -1.0 / part_1;
        slopes[2] = 2.0 * slopes[1] * out[1] + part_3 * slopes[1];
        slopes[3] = 2.0 * slopes[1] * out[2] + part_4 * slopes[2] - slopes[1];
        slopes[4] = 2.0 * slopes[2] * out[2] + part_5 * slopes[2];
        slopes[5] = 2.0 * slopes[2] * out[3] + part_6 * slopes[3] - slopes[1];
        slopes[6] = 2.0 * slopes[3] * out[3] + part_7 * slopes[3];
    }
    (void)v;
}

/* What all weights share, then its slopes after the axes. */
static inline void skylight_sh_7_bands_0_1pct_packed_scale_slopes(const double *x, double *out)
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
static inline int skylight_sh_7_bands_0_1pct_packed_kind(float v)
{
    uint32_t bits;
    memcpy(&bits, &v, sizeof bits);
    bits &= 0x7fffffffu;
    return (bits >= 0x7f800000u) + (bits > 0x7f800000u);
}

/* A number that is no NaN, finite: an infinity becomes a large number of its sign. */
static inline float skylight_sh_7_bands_0_1pct_packed_finite(float v)
{
    if (skylight_sh_7_bands_0_1pct_packed_kind(v)) {
        uint32_t bits;
        memcpy(&bits, &v, sizeof bits);
        v = bits >> 31 ? -3e38f : 3e38f;
    }
    return v;
}

/* Clamps the axes' inputs into x. Returns the status: 0; 1 where one was not inside; 2, and nothing
   in x, where one is NaN or the azimuth no finite number. */
static inline int skylight_sh_7_bands_0_1pct_packed_inputs(const float
    inputs[SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_AXES], float azimuth,
                                     skylight_sh_7_bands_0_1pct_packed_real
                                         x[SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_AXES])
{
    int axis, status = 0, strange = skylight_sh_7_bands_0_1pct_packed_kind(azimuth) ? 2 : 0;
    for (axis = 0; axis < SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_AXES; ++axis) strange |=
        skylight_sh_7_bands_0_1pct_packed_kind(inputs[axis]);
    if (strange & 2) return 2;
    for (axis = 0; axis < SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_AXES; ++axis) {
        const float v = skylight_sh_7_bands_0_1pct_packed_finite(inputs[axis]);
        const skylight_sh_7_bands_0_1pct_packed_real low =
            skylight_sh_7_bands_0_1pct_packed_range[axis][0],
            high = skylight_sh_7_bands_0_1pct_packed_range[axis][1];
        const skylight_sh_7_bands_0_1pct_packed_real at_least =
            (skylight_sh_7_bands_0_1pct_packed_real)v < low ? low :
            (skylight_sh_7_bands_0_1pct_packed_real)v;
        status |= (v < skylight_sh_7_bands_0_1pct_packed_inside[axis][0]) | (v >
            skylight_sh_7_bands_0_1pct_packed_inside[axis][1]);
        x[axis] = at_least > high ? high : at_least;
    }
    return status;
}

/* Orders m >= 0 alone are stored: those of a light that is even in y at azimuth 0. */
#define SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_FIRST_ORDER(l) 0

/* Stores the weight of degree l and order m turned by the azimuth (Habel et al. 2008, eq. 4). */
static inline void skylight_sh_7_bands_0_1pct_packed_place(skylight_sh_7_bands_0_1pct_packed_real
    value, int l, int m,
                                     const skylight_sh_7_bands_0_1pct_packed_real *cosines,
                                         const skylight_sh_7_bands_0_1pct_packed_real *sines,
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
} skylight_sh_7_bands_0_1pct_packed_bits;

static inline void skylight_sh_7_bands_0_1pct_packed_fill(skylight_sh_7_bands_0_1pct_packed_bits *b)
{
    const unsigned char *const end = skylight_sh_7_bands_0_1pct_packed_stream + sizeof
        skylight_sh_7_bands_0_1pct_packed_stream;
    while (b->count <= 56 && b->next < end) {
        b->held |= (uint64_t)*b->next++ << b->count;
        b->count += 8;
    }
}

/* `width` bits, at most 31, as a number. */
static inline unsigned
    skylight_sh_7_bands_0_1pct_packed_fixed(skylight_sh_7_bands_0_1pct_packed_bits *b, int width)
{
    unsigned value;
    if (b->count < 32) skylight_sh_7_bands_0_1pct_packed_fill(b);
    value = (unsigned)(b->held & ((UINT64_C(1) << width) - 1));
    b->held >>= width;
    b->count -= width;
    return value;
}

/* A Rice code of `low` low bits: ones, a zero, the low bits; then folded back: 0, 1, 2, 3 -> 0, -1,
   1, -2. */
static inline int skylight_sh_7_bands_0_1pct_packed_rice(skylight_sh_7_bands_0_1pct_packed_bits *b,
    int low)
{
    unsigned high = 0, folded;
    if (b->count < 32) skylight_sh_7_bands_0_1pct_packed_fill(b);
    while (b->held & 1) {
        ++high;
        b->held >>= 1;
        if (--b->count < 1) skylight_sh_7_bands_0_1pct_packed_fill(b);
    }
    b->held >>= 1;
    --b->count;
    folded = (high << low) | skylight_sh_7_bands_0_1pct_packed_fixed(b, low);
    return folded & 1 ? -(int)(folded >> 1) - 1 : (int)(folded >> 1);
}

/* The stream from its start. */
static inline skylight_sh_7_bands_0_1pct_packed_bits skylight_sh_7_bands_0_1pct_packed_open(void)
{
    skylight_sh_7_bands_0_1pct_packed_bits b;
    b.next = skylight_sh_7_bands_0_1pct_packed_stream;
    b.held = 0;
    b.count = 0;
    return b;
}

/* The next band's profile: twice the low bits that its numbers have, by their place in a run. */
static inline void
    skylight_sh_7_bands_0_1pct_packed_next_profile(skylight_sh_7_bands_0_1pct_packed_bits *b,
    int profile[32])
{
    const int used = (int)skylight_sh_7_bands_0_1pct_packed_fixed(b, 5);
    int i;
    for (i = 0; i < used; ++i) profile[i] = (int)skylight_sh_7_bands_0_1pct_packed_fixed(b, 5);
}

/* The length of the next run, by that of the same channel and product at the weight before. */
static inline int
    skylight_sh_7_bands_0_1pct_packed_next_length(skylight_sh_7_bands_0_1pct_packed_bits *b,
    signed char *length)
{
    const int found = *length + skylight_sh_7_bands_0_1pct_packed_rice(b, 0);
    *length = (signed char)found;
    return found;
}

/* The next number, of `size` half low bits. */
static inline int
    skylight_sh_7_bands_0_1pct_packed_next_number(skylight_sh_7_bands_0_1pct_packed_bits *b,
    int size)
{
    return skylight_sh_7_bands_0_1pct_packed_rice(b, size > 0 ? size >> 1 : 0);
}

static const signed char
    skylight_sh_7_bands_0_1pct_packed_run_profile[SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_RUNS] =
    SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_RUN_PROFILE;
static const signed char
    skylight_sh_7_bands_0_1pct_packed_channel_profile[SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_CHANNELS] =
    SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_CHANNEL_PROFILE;

/* Reads the stream once, forward, and stores the first `bands` bands. */
static inline void skylight_sh_7_bands_0_1pct_packed_combine(const
    skylight_sh_7_bands_0_1pct_packed_real *first,
                                       const skylight_sh_7_bands_0_1pct_packed_real *others,
                                       const skylight_sh_7_bands_0_1pct_packed_real *cosines,
                                       const skylight_sh_7_bands_0_1pct_packed_real *sines,
                                           int bands,
                                       float
                                           weights[SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_CHANNELS]
                                           [SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_WEIGHTS])
{
    signed char
        lengths[SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_CHANNELS][SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_RUNS];
    int profile[32], i, l, m, channel, other;
    skylight_sh_7_bands_0_1pct_packed_bits bits = skylight_sh_7_bands_0_1pct_packed_open();
    memset(lengths, 0, sizeof lengths);
    memset(profile, 0, sizeof profile);
    for (l = 0; l < bands; ++l) {
        skylight_sh_7_bands_0_1pct_packed_next_profile(&bits, profile);
        for (m = SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_FIRST_ORDER(l); m <= l; ++m) {
            for (channel = 0; channel < SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_CHANNELS; ++channel) {
                skylight_sh_7_bands_0_1pct_packed_real value = 0;
                for (other = 0; other < SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_RUNS; ++other) {
                    const int level = skylight_sh_7_bands_0_1pct_packed_run_profile[other] +
                                      skylight_sh_7_bands_0_1pct_packed_channel_profile[channel];
                    const int length = skylight_sh_7_bands_0_1pct_packed_next_length(&bits,
                        &lengths[channel][other]);
                    skylight_sh_7_bands_0_1pct_packed_real sum = 0;
                    for (i = 0; i < length; ++i) {
                        const int number = skylight_sh_7_bands_0_1pct_packed_next_number(&bits,
                            profile[i] + level);
                        sum += first[i] * (skylight_sh_7_bands_0_1pct_packed_real)number;
                    }
                    value += sum * others[other];
                }
                skylight_sh_7_bands_0_1pct_packed_place(value *
                    SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_STEP, l, m, cosines, sines,
                                  weights[channel]);
            }
        }
    }
}

/* The same in double precision, all bands: what derivatives need, whose terms cancel. */
static inline void skylight_sh_7_bands_0_1pct_packed_combine_double(
    const double *first, const double *others,
        const skylight_sh_7_bands_0_1pct_packed_real *cosines,
    const skylight_sh_7_bands_0_1pct_packed_real *sines,
        float
        weights[SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_CHANNELS]
        [SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_WEIGHTS])
{
    signed char
        lengths[SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_CHANNELS][SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_RUNS];
    int profile[32], i, l, m, channel, other;
    skylight_sh_7_bands_0_1pct_packed_bits bits = skylight_sh_7_bands_0_1pct_packed_open();
    memset(lengths, 0, sizeof lengths);
    memset(profile, 0, sizeof profile);
    for (l = 0; l < SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_BANDS; ++l) {
        skylight_sh_7_bands_0_1pct_packed_next_profile(&bits, profile);
        for (m = SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_FIRST_ORDER(l); m <= l; ++m) {
            for (channel = 0; channel < SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_CHANNELS; ++channel) {
                double value = 0.0;
                for (other = 0; other < SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_RUNS; ++other) {
                    const int level = skylight_sh_7_bands_0_1pct_packed_run_profile[other] +
                                      skylight_sh_7_bands_0_1pct_packed_channel_profile[channel];
                    const int length = skylight_sh_7_bands_0_1pct_packed_next_length(&bits,
                        &lengths[channel][other]);
                    double sum = 0.0;
                    for (i = 0; i < length; ++i) {
                        const int number = skylight_sh_7_bands_0_1pct_packed_next_number(&bits,
                            profile[i] + level);
                        sum += first[i] * (double)number;
                    }
                    value += sum * others[other];
                }
                skylight_sh_7_bands_0_1pct_packed_place((skylight_sh_7_bands_0_1pct_packed_real)(
                    value * (double)SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_STEP), l, m,
                                  cosines, sines, weights[channel]);
            }
        }
    }
}

/* What becomes of the first `bands` bands once they are stored; the others become 0. */
static inline void skylight_sh_7_bands_0_1pct_packed_finish(int bands, int lights,
    const skylight_sh_7_bands_0_1pct_packed_real *cosines,
                                      const skylight_sh_7_bands_0_1pct_packed_real *sines,
                                      float
                                          weights[SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_CHANNELS]
                                          [SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_WEIGHTS])
{
    if (bands < SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_BANDS) {
        int channel, i;
        for (channel = 0; channel < SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_CHANNELS; ++channel)
            for (i = bands * bands; i < SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_WEIGHTS; ++i)
                weights[channel][i] = 0.0f;
    }
    (void)lights;
    (void)cosines;
    (void)sines;
}

/* Evaluates the first `bands` bands (1 to SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_BANDS, clamped like an
 * input) and zeroes the
   rest; returns the status. */
static inline int skylight_sh_7_bands_0_1pct_packed_evaluate(const float
    inputs[SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_AXES], float azimuth,
                                       int bands,
                                       float
                                           weights[SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_CHANNELS]
                                           [SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_WEIGHTS])
{
    skylight_sh_7_bands_0_1pct_packed_real x[SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_AXES],
        first[SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_FIRST],
        others[SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_OTHERS];
    skylight_sh_7_bands_0_1pct_packed_real cosines[SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_BANDS],
        sines[SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_BANDS], scale;
    int i, status = skylight_sh_7_bands_0_1pct_packed_inputs(inputs, azimuth, x);
    if (status == 2) {
        memset(weights, 0, sizeof(float) * SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_CHANNELS *
            SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_WEIGHTS);
        return 2;
    }
    if (bands < 1 || bands > SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_BANDS) {
        bands = bands < 1 ? 1 : SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_BANDS;
        status = 1;
    }
    scale = skylight_sh_7_bands_0_1pct_packed_scale(x) *
        (skylight_sh_7_bands_0_1pct_packed_real)SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_EXPOSURE;
    skylight_sh_7_bands_0_1pct_packed_first(x, first);
    skylight_sh_7_bands_0_1pct_packed_others(x, others);
    for (i = 0; i < SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_OTHERS; ++i) others[i] *= scale;
    skylight_sh_7_bands_0_1pct_packed_waves((skylight_sh_7_bands_0_1pct_packed_real)azimuth,
        cosines, sines);
    skylight_sh_7_bands_0_1pct_packed_combine(first, others, cosines, sines, bands, weights);
    skylight_sh_7_bands_0_1pct_packed_finish(bands, 1, cosines, sines, weights);
    return status;
}

/* Evaluates `count` suns from arrays, one an axis, and one of azimuths (or none, where the table
   fixes it); returns the largest status. */
static inline int skylight_sh_7_bands_0_1pct_packed_evaluate_batch(
    int count, const float *const inputs[SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_AXES],
        const float *azimuths,
    float
        (*weights)[SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_CHANNELS]
        [SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_WEIGHTS])
{
    int s, axis, worst = 0;
    for (s = 0; s < count; ++s) {
        const float azimuth = azimuths ? azimuths[s] : SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_AZIMUTH;
        float sun[SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_AXES];
        int status;
        for (axis = 0; axis < SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_AXES; ++axis) sun[axis] =
            inputs[axis][s];
        status = skylight_sh_7_bands_0_1pct_packed_evaluate(sun, azimuth,
            SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_BANDS, weights[s]);
        worst = status > worst ? status : worst;
    }
    return worst;
}

/* All products of `count` numbers and `size` functions, the functions' place fastest; returns how
   many. */
static inline int skylight_sh_7_bands_0_1pct_packed_multiply(double *products, int count,
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
static inline int skylight_sh_7_bands_0_1pct_packed_evaluate_gradient(
    const float inputs[SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_AXES], float azimuth,
    float
        weights[SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_CHANNELS]
        [SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_WEIGHTS],
    float
        gradient[SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_AXES][SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_CHANNELS]
        [SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_WEIGHTS])
{
    static const int sizes[SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_AXES] =
        SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_SIZES;
    double x[SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_AXES],
        functions[SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_AXES][SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_MOST];
    double slopes[SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_AXES][SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_MOST],
        scale[1 + SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_AXES];
    skylight_sh_7_bands_0_1pct_packed_real cosines[SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_BANDS],
        sines[SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_BANDS];
    int axis, other, i;
    const int status = skylight_sh_7_bands_0_1pct_packed_evaluate(inputs, azimuth,
        SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_BANDS, weights);
    if (status == 2) {
        memset(gradient, 0,
               sizeof(float) * SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_AXES *
                   SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_CHANNELS *
                   SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_WEIGHTS);
        return 2;
    }
    for (axis = 0; axis < SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_AXES; ++axis) {
        const double low = skylight_sh_7_bands_0_1pct_packed_slope_range[axis][0];
        const double high = skylight_sh_7_bands_0_1pct_packed_slope_range[axis][1];
        const double v = (double)skylight_sh_7_bands_0_1pct_packed_finite(inputs[axis]);
        x[axis] = v < low ? low : v > high ? high : v;
        skylight_sh_7_bands_0_1pct_packed_functions(axis, x[axis], functions[axis], slopes[axis]);
    }
    skylight_sh_7_bands_0_1pct_packed_scale_slopes(x, scale);
    for (i = 0; i < 1 + SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_AXES; ++i) scale[i] *=
        (double)SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_EXPOSURE;
    skylight_sh_7_bands_0_1pct_packed_waves((skylight_sh_7_bands_0_1pct_packed_real)azimuth,
        cosines, sines);
    for (axis = 0; axis < SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_AXES; ++axis) {
        double first[SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_MOST],
            others[SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_OTHERS];
        int count = 1;
        others[0] = 1.0;
        for (other = 0; other < SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_AXES; ++other) {
            double one[SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_MOST];
            for (i = 0; i < sizes[other]; ++i) {
                one[i] = functions[other][i];
                if (other == axis) one[i] = scale[0] * slopes[axis][i] + scale[1 + axis] * one[i];
                if (other == 0) first[i] = one[i];
            }
            if (other) count = skylight_sh_7_bands_0_1pct_packed_multiply(others, count, one,
                sizes[other]);
        }
        skylight_sh_7_bands_0_1pct_packed_combine_double(first, others, cosines, sines,
            gradient[axis]);
        skylight_sh_7_bands_0_1pct_packed_finish(SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_BANDS, 0,
            cosines, sines, gradient[axis]);
    }
    return status;
}

SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_API int skylight_sh_7_bands_0_1pct_packed_weights(float
    sun_zenith, float sun_azimuth, float turbidity,
    float
    weights[SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_CHANNELS][SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_WEIGHTS])
{
    const float skylight_sh_7_bands_0_1pct_packed_given[SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_AXES] = {
        sun_zenith, turbidity };
    return skylight_sh_7_bands_0_1pct_packed_evaluate(skylight_sh_7_bands_0_1pct_packed_given,
        sun_azimuth, SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_BANDS, weights);
}

SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_API int skylight_sh_7_bands_0_1pct_packed_weights_bands(float
    sun_zenith, float sun_azimuth, float turbidity, int bands,
    float
    weights[SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_CHANNELS][SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_WEIGHTS])
{
    const float skylight_sh_7_bands_0_1pct_packed_given[SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_AXES] = {
        sun_zenith, turbidity };
    return skylight_sh_7_bands_0_1pct_packed_evaluate(skylight_sh_7_bands_0_1pct_packed_given,
        sun_azimuth, bands, weights);
}

SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_API int skylight_sh_7_bands_0_1pct_packed_weights_batch(int count,
    const float *sun_zenith, const float *sun_azimuth, const float *turbidity,
    float
    (*weights)[SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_CHANNELS]
    [SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_WEIGHTS])
{
    const float *const
        skylight_sh_7_bands_0_1pct_packed_given[SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_AXES] = {
        sun_zenith, turbidity };
    return skylight_sh_7_bands_0_1pct_packed_evaluate_batch(count,
        skylight_sh_7_bands_0_1pct_packed_given, sun_azimuth, weights);
}

SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_API int skylight_sh_7_bands_0_1pct_packed_weights_gradient(float
    sun_zenith, float sun_azimuth, float turbidity,
    float
    weights[SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_CHANNELS][SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_WEIGHTS],
    float
    gradient[SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_AXES][SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_CHANNELS]
    [SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_WEIGHTS])
{
    const float skylight_sh_7_bands_0_1pct_packed_given[SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_AXES] = {
        sun_zenith, turbidity };
    return
        skylight_sh_7_bands_0_1pct_packed_evaluate_gradient(skylight_sh_7_bands_0_1pct_packed_given,
        sun_azimuth, weights, gradient);
}

/* The dominant light's direction, a unit vector: where the linear part of the weights, summed over
   channels by luminance, points. Returns 0, or 1 (and straight up) where it points nowhere. */
SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_API int skylight_sh_7_bands_0_1pct_packed_dominant_of(const float
    *weights, float direction[3])
{
    static const float luminance[SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_CHANNELS] =
        SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_LUMINANCE;
    float x = 0.0f, y = 0.0f, z = 0.0f, length;
    int channel;
    for (channel = 0; channel < SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_CHANNELS; ++channel) {
        const float *const linear = weights + channel * SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_WEIGHTS +
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
SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_API void skylight_sh_7_bands_0_1pct_packed_ground(
    const float albedo[SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_CHANNELS],
    float
        weights[SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_CHANNELS]
        [SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_WEIGHTS])
{
    static const float lower[SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_BANDS] =
        SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_LOWER;
    int l, channel;
    for (channel = 0; channel < SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_CHANNELS; ++channel) {
        const float radiance = albedo[channel] * SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_REFLECTED *
            weights[channel][2];
        for (l = 0; l < SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_BANDS; ++l) weights[channel][l * (l + 1)]
            += radiance * lower[l];
    }
}

/* Tames the ringing of the horizon in the first `bands` bands by the zonal window sinc(pi l /
   bands) (Habel et al. 2008, eq. 5). */
SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_API void skylight_sh_7_bands_0_1pct_packed_window(
    int bands, float
        weights[SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_CHANNELS]
        [SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_WEIGHTS])
{
    int l, channel;
    for (l = 1; l < bands && l < SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_BANDS; ++l) {
        const float factor = skylight_sh_7_bands_0_1pct_packed_sinc((float)l / (float)bands);
        for (channel = 0; channel < SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_CHANNELS; ++channel)
            weights[channel][l * (l + 1)] *= factor;
    }
}

#endif /* SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_DEFINED */
