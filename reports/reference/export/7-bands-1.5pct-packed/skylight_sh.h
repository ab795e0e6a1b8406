/* Preetham sky (published constants, srgb): spherical-harmonics weights, evaluated from
 * polynomials.
 *
 * Written by skylight-sh 0.1.0; the table and this code may be used by anyone for anything
 * (CC0-1.0).
 * C99 and C++11, no allocation, no global written, nothing static but constants: any thread may
 * call it.
 *
 * Usage
 *   float w[SKYLIGHT_SH_7_BANDS_1_5PCT_PACKED_CHANNELS][SKYLIGHT_SH_7_BANDS_1_5PCT_PACKED_WEIGHTS];
 *   int status = skylight_sh_7_bands_1_5pct_packed_weights(0.785000026f, 0.0f, 4.25f, w);
 * Compile with, for instance
 *   cc -std=c99 -O3 program.c -o program -lm
 * Included plainly, the file is all there is: its functions are static, and the table stands in
 * every unit that includes it. With SKYLIGHT_SH_7_BANDS_1_5PCT_PACKED_EXTERN defined before it, it
 * declares only; the one unit that also defines SKYLIGHT_SH_7_BANDS_1_5PCT_PACKED_IMPLEMENTATION
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
 *   Define SKYLIGHT_SH_7_BANDS_1_5PCT_PACKED_EXPOSURE before this file (where it holds the table)
 *   to multiply all weights (1 by default).
 *
 * Accuracy, as shipped: E_mean 1.44 %, E_max 6.13 % of the least luminance of the same sky, at
 * azimuth 0.
 * The expansion rings: the least value it takes, over all directions and measured sets, is -12.8 %
 * of its largest in the same set; the window below tames it.
 * Memory: 1621 bytes of constants, packed into few bytes (a fast table takes more and less time).
 *
 * Provenance
 *   skylight-sh 0.1.0, config preetham 7738be1e848979ca, table 7-bands-1.5pct-packed
 */
#ifdef __cplusplus
#if __cplusplus < 201103L && !defined(_MSC_VER)
#error "skylight_sh needs C++11 or later: compile with -std=c++11."
#endif
#elif (!defined(__STDC_VERSION__) || __STDC_VERSION__ < 199901L) && !defined(_MSC_VER)
#error "skylight_sh needs C99 or later: compile with -std=c99."
#endif
#if defined(SKYLIGHT_SH_7_BANDS_1_5PCT_PACKED_IMPLEMENTATION) && \
    !defined(SKYLIGHT_SH_7_BANDS_1_5PCT_PACKED_EXTERN)
#error "Define SKYLIGHT_SH_7_BANDS_1_5PCT_PACKED_EXTERN in every unit, \
SKYLIGHT_SH_7_BANDS_1_5PCT_PACKED_IMPLEMENTATION beside it in one."
#endif
#if defined(SKYLIGHT_SH_7_BANDS_1_5PCT_PACKED_API) && \
    defined(SKYLIGHT_SH_7_BANDS_1_5PCT_PACKED_EXTERN) && \
    !defined(SKYLIGHT_SH_7_BANDS_1_5PCT_PACKED_DECLARED)
#error "Define SKYLIGHT_SH_7_BANDS_1_5PCT_PACKED_EXTERN before this file is included for the first \
time."
#endif
#if defined(SKYLIGHT_SH_7_BANDS_1_5PCT_PACKED_DECLARED) && \
    !defined(SKYLIGHT_SH_7_BANDS_1_5PCT_PACKED_EXTERN)
#error "Leave SKYLIGHT_SH_7_BANDS_1_5PCT_PACKED_EXTERN defined: this file was included with it \
before."
#endif

#ifndef SKYLIGHT_SH_7_BANDS_1_5PCT_PACKED_H
#define SKYLIGHT_SH_7_BANDS_1_5PCT_PACKED_H 0xc5bbb1de

#include <math.h>
#include <stdint.h>
#include <string.h>

#ifndef SKYLIGHT_SH_7_BANDS_1_5PCT_PACKED_EXTERN
#define SKYLIGHT_SH_7_BANDS_1_5PCT_PACKED_API static inline
#else
#define SKYLIGHT_SH_7_BANDS_1_5PCT_PACKED_DECLARED
#ifdef __cplusplus
#define SKYLIGHT_SH_7_BANDS_1_5PCT_PACKED_API extern "C"
#else
#define SKYLIGHT_SH_7_BANDS_1_5PCT_PACKED_API extern
#endif
#endif
#ifndef SKYLIGHT_SH_7_BANDS_1_5PCT_PACKED_EXPOSURE
#define SKYLIGHT_SH_7_BANDS_1_5PCT_PACKED_EXPOSURE 1
#endif

#define SKYLIGHT_SH_7_BANDS_1_5PCT_PACKED_VERSION "0.1.0"
#define SKYLIGHT_SH_7_BANDS_1_5PCT_PACKED_BANDS 7
#define SKYLIGHT_SH_7_BANDS_1_5PCT_PACKED_WEIGHTS 49
#define SKYLIGHT_SH_7_BANDS_1_5PCT_PACKED_CHANNELS 3
#define SKYLIGHT_SH_7_BANDS_1_5PCT_PACKED_AXES 2
#define SKYLIGHT_SH_7_BANDS_1_5PCT_PACKED_UNIT "cd/m2"
#define SKYLIGHT_SH_7_BANDS_1_5PCT_PACKED_E_MEAN 1.441000e-02
#define SKYLIGHT_SH_7_BANDS_1_5PCT_PACKED_E_MAX 6.126000e-02
#define SKYLIGHT_SH_7_BANDS_1_5PCT_PACKED_SUN_ZENITH_MIN 0.0f
#define SKYLIGHT_SH_7_BANDS_1_5PCT_PACKED_SUN_ZENITH_MAX 1.57079637f
#define SKYLIGHT_SH_7_BANDS_1_5PCT_PACKED_TURBIDITY_MIN 2.5f
#define SKYLIGHT_SH_7_BANDS_1_5PCT_PACKED_TURBIDITY_MAX 6.0f

/* Evaluates all bands. */
SKYLIGHT_SH_7_BANDS_1_5PCT_PACKED_API int skylight_sh_7_bands_1_5pct_packed_weights(float
    sun_zenith, float sun_azimuth, float turbidity,
    float
    weights[SKYLIGHT_SH_7_BANDS_1_5PCT_PACKED_CHANNELS][SKYLIGHT_SH_7_BANDS_1_5PCT_PACKED_WEIGHTS]);
/* Evaluates the first `bands` bands (1 to SKYLIGHT_SH_7_BANDS_1_5PCT_PACKED_BANDS, clamped
   likewise) and zeroes the rest. */
SKYLIGHT_SH_7_BANDS_1_5PCT_PACKED_API int skylight_sh_7_bands_1_5pct_packed_weights_bands(float
    sun_zenith, float sun_azimuth, float turbidity, int bands,
    float
    weights[SKYLIGHT_SH_7_BANDS_1_5PCT_PACKED_CHANNELS][SKYLIGHT_SH_7_BANDS_1_5PCT_PACKED_WEIGHTS]);
/* Evaluates `count` suns from arrays; returns the largest status. No faster
   than single calls. */
SKYLIGHT_SH_7_BANDS_1_5PCT_PACKED_API int skylight_sh_7_bands_1_5pct_packed_weights_batch(int count,
    const float *sun_zenith, const float *sun_azimuth, const float *turbidity,
    float
    (*weights)[SKYLIGHT_SH_7_BANDS_1_5PCT_PACKED_CHANNELS]
    [SKYLIGHT_SH_7_BANDS_1_5PCT_PACKED_WEIGHTS]);
/* Evaluates all bands and their derivatives after each axis (sun_zenith,
   turbidity), per unit of the axis; beyond a range, those at its edge. */
SKYLIGHT_SH_7_BANDS_1_5PCT_PACKED_API int skylight_sh_7_bands_1_5pct_packed_weights_gradient(float
    sun_zenith, float sun_azimuth, float turbidity,
    float
    weights[SKYLIGHT_SH_7_BANDS_1_5PCT_PACKED_CHANNELS][SKYLIGHT_SH_7_BANDS_1_5PCT_PACKED_WEIGHTS],
    float
    gradient[SKYLIGHT_SH_7_BANDS_1_5PCT_PACKED_AXES][SKYLIGHT_SH_7_BANDS_1_5PCT_PACKED_CHANNELS]
    [SKYLIGHT_SH_7_BANDS_1_5PCT_PACKED_WEIGHTS]);
/* Unit vector of the dominant light. Returns 0, or 1 (and straight up) where there is none. */
#define skylight_sh_7_bands_1_5pct_packed_dominant(weights, direction) \
    skylight_sh_7_bands_1_5pct_packed_dominant_of(&(weights)[0][0], direction)
SKYLIGHT_SH_7_BANDS_1_5PCT_PACKED_API int skylight_sh_7_bands_1_5pct_packed_dominant_of(const float
    *weights, float direction[3]);
/* Optional: adds an even ground of this albedo below the horizon, lit by the sky (before any
 * window). */
SKYLIGHT_SH_7_BANDS_1_5PCT_PACKED_API void skylight_sh_7_bands_1_5pct_packed_ground(const float
    albedo[SKYLIGHT_SH_7_BANDS_1_5PCT_PACKED_CHANNELS],
    float
    weights[SKYLIGHT_SH_7_BANDS_1_5PCT_PACKED_CHANNELS][SKYLIGHT_SH_7_BANDS_1_5PCT_PACKED_WEIGHTS]);
/* Optional: tames the ringing of the horizon by the zonal window of the first `bands` bands. */
SKYLIGHT_SH_7_BANDS_1_5PCT_PACKED_API void skylight_sh_7_bands_1_5pct_packed_window(int bands,
    float
    weights[SKYLIGHT_SH_7_BANDS_1_5PCT_PACKED_CHANNELS][SKYLIGHT_SH_7_BANDS_1_5PCT_PACKED_WEIGHTS]);

#elif SKYLIGHT_SH_7_BANDS_1_5PCT_PACKED_H != 0xc5bbb1de
#error "Another table has the prefix skylight_sh_7_bands_1_5pct_packed_7_bands_1_5pct_packed \
already: export one of them under a prefix of its own."
#endif /* SKYLIGHT_SH_7_BANDS_1_5PCT_PACKED_H */

#if (!defined(SKYLIGHT_SH_7_BANDS_1_5PCT_PACKED_EXTERN) || \
    defined(SKYLIGHT_SH_7_BANDS_1_5PCT_PACKED_IMPLEMENTATION)) && \
    !defined(SKYLIGHT_SH_7_BANDS_1_5PCT_PACKED_DEFINED)
#define SKYLIGHT_SH_7_BANDS_1_5PCT_PACKED_DEFINED

typedef float skylight_sh_7_bands_1_5pct_packed_real;

/* Functions of the first axis, in fours; products of the other axes'
   functions. */
#define SKYLIGHT_SH_7_BANDS_1_5PCT_PACKED_FIRST 12
#define SKYLIGHT_SH_7_BANDS_1_5PCT_PACKED_OTHERS 5
#define SKYLIGHT_SH_7_BANDS_1_5PCT_PACKED_SIZES { 10, 5 }
#define SKYLIGHT_SH_7_BANDS_1_5PCT_PACKED_MOST 12
#define SKYLIGHT_SH_7_BANDS_1_5PCT_PACKED_AZIMUTH 0.0f
/* The channels' luminance. */
#define SKYLIGHT_SH_7_BANDS_1_5PCT_PACKED_LUMINANCE { 0.212672845f, 0.715152144f, 0.0721749961f }
/* What an even ground reflects of the weight l = 1, m = 0, and its own
   zonal weights. */
#define SKYLIGHT_SH_7_BANDS_1_5PCT_PACKED_REFLECTED 0.651470006f
#define SKYLIGHT_SH_7_BANDS_1_5PCT_PACKED_LOWER { 1.7724539f, -1.53499007f, 0.0f, 0.586184025f, \
    0.0f, -0.367410272f, 0.0f }

/* Of each axis: the first and last float that counts as inside, and its
   range. */
static const float
    skylight_sh_7_bands_1_5pct_packed_inside[SKYLIGHT_SH_7_BANDS_1_5PCT_PACKED_AXES][2] = { {
    -1.57079626e-06f, 1.5707978f }, { 2.49999666f, 6.00000334f } };
static const skylight_sh_7_bands_1_5pct_packed_real
    skylight_sh_7_bands_1_5pct_packed_range[SKYLIGHT_SH_7_BANDS_1_5PCT_PACKED_AXES][2] = { { 0.0f,
    1.57079637f }, { 2.5f, 6.0f } };

/* Runs of numbers, one a product of the other axes' functions, and their
   profiles; what one step is worth. */
#define SKYLIGHT_SH_7_BANDS_1_5PCT_PACKED_RUNS 5
#define SKYLIGHT_SH_7_BANDS_1_5PCT_PACKED_RUN_PROFILE { 4, 0, -3, -7, -13 }
#define SKYLIGHT_SH_7_BANDS_1_5PCT_PACKED_CHANNEL_PROFILE { -3, -3, -3 }
#define SKYLIGHT_SH_7_BANDS_1_5PCT_PACKED_STEP 0.00129699707f

/* Whole numbers as Rice codes. */
static const unsigned char skylight_sh_7_bands_1_5pct_packed_stream[1429] = {
    167, 70, 199, 86, 49, 255, 47, 0, 7, 64, 199, 238, 224, 255, 13, 7, 209, 234, 46, 252, 159, 2,
    87, 104, 252, 184, 160, 241, 255, 165, 126, 87, 197, 37, 4, 252, 151, 248, 77, 181, 248, 127,
    178, 26, 68, 13, 242, 255, 134, 190, 11, 253, 2, 150, 184, 254, 255, 75, 222, 155, 60, 254, 143,
    175, 157, 255, 183, 198, 248, 25, 239, 247, 63, 128, 189, 207, 153, 241, 45, 85, 136, 81, 43,
    148, 2, 154, 131, 123, 56, 210, 114, 61, 73, 66, 86, 157, 32, 91, 28, 114, 221, 244, 2, 119,
    104, 79, 243, 70, 144, 137, 95, 23, 131, 70, 104, 217, 243, 250, 245, 170, 38, 32, 187, 209,
    243, 251, 126, 241, 127, 248, 215, 121, 94, 120, 244, 36, 174, 199, 70, 127, 179, 40, 27, 129,
    130, 213, 2, 114, 65, 134, 95, 169, 98, 138, 192, 49, 197, 184, 130, 34, 65, 61, 67, 168, 177,
    38, 109, 157, 112, 159, 77, 9, 33, 4, 131, 113, 154, 118, 156, 150, 133, 130, 204, 192, 246, 65,
    255, 125, 121, 137, 147, 234, 8, 41, 40, 190, 183, 82, 25, 227, 122, 241, 138, 201, 77, 115,
    155, 225, 213, 244, 105, 115, 74, 100, 61, 43, 16, 40, 188, 34, 170, 19, 42, 158, 248, 125, 236,
    104, 9, 101, 40, 43, 26, 25, 129, 23, 26, 213, 164, 29, 207, 253, 217, 255, 29, 14, 177, 253,
    89, 91, 126, 174, 228, 110, 63, 108, 116, 134, 176, 157, 16, 212, 118, 146, 169, 23, 13, 162,
    165, 80, 90, 97, 88, 212, 243, 217, 77, 56, 232, 134, 72, 217, 114, 8, 171, 64, 6, 118, 64, 90,
    224, 177, 92, 195, 105, 161, 197, 44, 23, 160, 230, 211, 253, 251, 211, 167, 15, 238, 221, 19,
    34, 75, 227, 65, 40, 93, 131, 33, 75, 146, 220, 81, 231, 164, 89, 20, 41, 25, 201, 203, 237,
    163, 113, 168, 156, 44, 74, 47, 113, 250, 9, 87, 160, 197, 200, 39, 200, 211, 49, 210, 166, 240,
    181, 100, 27, 114, 1, 21, 244, 94, 91, 234, 16, 209, 215, 113, 251, 131, 4, 247, 217, 238, 124,
    247, 35, 243, 59, 247, 96, 98, 160, 237, 189, 253, 77, 15, 153, 179, 132, 137, 180, 118, 24,
    173, 195, 201, 116, 115, 252, 118, 104, 239, 171, 188, 71, 140, 186, 158, 12, 253, 33, 111, 144,
    214, 240, 44, 159, 196, 223, 60, 189, 103, 102, 162, 150, 182, 221, 3, 176, 138, 69, 151, 189,
    240, 145, 44, 146, 112, 113, 22, 200, 74, 93, 233, 116, 169, 202, 13, 211, 172, 63, 232, 245,
    210, 193, 120, 49, 66, 150, 166, 87, 124, 104, 101, 51, 98, 178, 225, 226, 209, 5, 255, 218, 42,
    122, 252, 194, 152, 147, 198, 22, 246, 58, 61, 97, 99, 100, 228, 165, 226, 160, 243, 150, 143,
    204, 211, 217, 197, 154, 118, 10, 142, 104, 211, 92, 235, 155, 137, 254, 20, 34, 197, 133, 29,
    163, 190, 2, 152, 128, 153, 92, 179, 144, 15, 88, 3, 18, 57, 198, 235, 213, 43, 65, 41, 17, 122,
    199, 49, 99, 136, 148, 69, 30, 134, 69, 8, 140, 34, 48, 65, 200, 90, 14, 224, 35, 164, 47, 230,
    177, 121, 68, 92, 70, 85, 210, 164, 240, 159, 212, 90, 91, 9, 21, 1, 222, 17, 185, 6, 107, 216,
    76, 73, 139, 183, 15, 202, 235, 33, 70, 139, 151, 120, 252, 150, 35, 249, 183, 6, 224, 123, 253,
    133, 97, 185, 28, 190, 167, 184, 112, 252, 101, 180, 238, 107, 204, 212, 177, 50, 134, 186, 114,
    229, 0, 105, 199, 238, 127, 230, 87, 62, 253, 57, 174, 174, 252, 77, 185, 158, 210, 110, 227,
    150, 190, 175, 125, 124, 89, 103, 130, 82, 99, 101, 175, 119, 193, 58, 119, 169, 202, 34, 87,
    245, 195, 139, 14, 158, 229, 154, 40, 49, 205, 213, 32, 207, 189, 85, 205, 182, 115, 242, 106,
    190, 205, 185, 193, 65, 222, 79, 178, 76, 204, 22, 107, 158, 57, 85, 74, 67, 194, 102, 56, 239,
    140, 80, 7, 83, 181, 166, 121, 241, 26, 98, 142, 111, 6, 97, 69, 161, 232, 230, 84, 48, 145,
    106, 121, 185, 37, 76, 97, 176, 132, 164, 78, 27, 204, 181, 243, 49, 221, 36, 53, 186, 120, 108,
    27, 204, 23, 155, 28, 166, 134, 148, 60, 94, 9, 127, 130, 41, 156, 146, 65, 146, 213, 146, 194,
    20, 134, 176, 140, 47, 73, 124, 142, 4, 37, 208, 172, 170, 3, 23, 153, 39, 81, 104, 49, 25, 21,
    73, 104, 26, 98, 102, 64, 202, 147, 204, 69, 238, 176, 3, 28, 9, 96, 174, 20, 32, 163, 177, 19,
    114, 84, 210, 52, 138, 147, 101, 198, 148, 212, 214, 90, 9, 21, 34, 246, 207, 249, 83, 166, 237,
    171, 156, 168, 223, 135, 130, 163, 27, 127, 182, 7, 112, 224, 123, 158, 223, 159, 115, 200, 128,
    45, 246, 129, 59, 79, 125, 121, 220, 232, 209, 183, 172, 30, 241, 247, 145, 247, 35, 188, 5,
    182, 7, 57, 169, 149, 253, 173, 139, 63, 13, 151, 188, 155, 231, 158, 233, 239, 199, 65, 157,
    55, 59, 236, 13, 48, 155, 123, 63, 60, 248, 194, 167, 194, 40, 205, 137, 69, 53, 44, 237, 58,
    156, 107, 238, 107, 58, 187, 229, 185, 165, 185, 235, 161, 79, 150, 43, 83, 227, 174, 70, 135,
    53, 240, 202, 143, 234, 224, 219, 134, 199, 107, 253, 88, 142, 69, 126, 187, 122, 54, 186, 231,
    160, 189, 106, 79, 240, 53, 11, 39, 60, 173, 208, 139, 173, 243, 152, 117, 10, 75, 161, 54, 147,
    117, 10, 143, 88, 204, 52, 149, 122, 205, 8, 107, 61, 132, 13, 100, 55, 10, 120, 74, 70, 108,
    102, 54, 137, 236, 90, 202, 27, 49, 165, 4, 216, 163, 201, 157, 40, 96, 130, 233, 218, 130, 75,
    203, 66, 137, 164, 34, 161, 76, 57, 213, 196, 10, 233, 195, 165, 26, 143, 64, 234, 132, 121, 20,
    28, 218, 124, 68, 155, 219, 210, 65, 113, 17, 26, 148, 62, 132, 153, 73, 10, 17, 94, 162, 6,
    177, 129, 136, 5, 12, 121, 103, 72, 136, 192, 26, 27, 13, 53, 75, 66, 12, 149, 107, 176, 200,
    49, 25, 34, 54, 9, 133, 38, 78, 2, 79, 4, 224, 104, 133, 211, 66, 116, 134, 83, 128, 178, 34,
    137, 133, 34, 84, 49, 112, 146, 101, 20, 101, 162, 32, 138, 45, 165, 18, 42, 67, 132, 183, 108,
    157, 180, 28, 25, 175, 202, 126, 4, 134, 247, 112, 222, 215, 75, 92, 188, 128, 78, 110, 61, 49,
    220, 149, 247, 3, 112, 190, 225, 184, 239, 69, 24, 186, 248, 61, 69, 27, 93, 229, 7, 23, 204,
    84, 255, 84, 45, 186, 223, 95, 6, 143, 118, 191, 227, 244, 179, 126, 210, 68, 249, 226, 124,
    220, 123, 112, 114, 134, 215, 199, 249, 30, 134, 49, 110, 198, 67, 206, 204, 54, 238, 156, 12,
    87, 70, 186, 113, 216, 143, 28, 113, 199, 233, 50, 11, 68, 16, 210, 222, 81, 186, 147, 245, 23,
    231, 167, 74, 219, 48, 54, 62, 107, 178, 140, 14, 31, 31, 238, 239, 14, 180, 102, 153, 158, 251,
    254, 132, 41, 207, 193, 177, 76, 12, 151, 23, 39, 72, 47, 245, 228, 245, 52, 30, 238, 73, 39,
    95, 27, 58, 214, 171, 78, 106, 129, 92, 34, 33, 23, 31, 181, 78, 250, 180, 225, 222, 133, 83,
    177, 133, 231, 220, 106, 63, 165, 237, 130, 160, 169, 101, 99, 117, 58, 177, 176, 148, 128, 30,
    176, 89, 52, 162, 12, 32, 94, 125, 128, 235, 97, 184, 148, 111, 69, 56, 74, 34, 202, 33, 69,
    213, 69, 32, 10, 75, 17, 186, 73, 70, 19, 144, 64, 222, 117, 34, 70, 74, 9, 110, 128, 50, 67,
    162, 224, 98, 170, 12, 175, 10, 19, 66, 0, 38, 150, 98, 160, 20, 156, 92, 170, 2, 184, 44, 170,
    13, 201, 68, 138, 10, 42, 149, 24, 122, 8, 40, 96, 230, 32, 17, 73, 37, 147, 131, 166, 147, 46,
    36, 48, 83, 82, 22, 23, 142, 21, 68, 64, 40, 54, 5, 158, 176, 128, 32, 192, 182, 8, 17, 202,
    128, 136, 73, 142, 130, 48, 53, 130, 113, 14, 153, 116, 34, 2
};

/* What all weights share: the closed form preetham_zenith. */
static inline skylight_sh_7_bands_1_5pct_packed_real skylight_sh_7_bands_1_5pct_packed_scale(const
    skylight_sh_7_bands_1_5pct_packed_real *x)
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
static inline void skylight_sh_7_bands_1_5pct_packed_first(const
    skylight_sh_7_bands_1_5pct_packed_real *x, skylight_sh_7_bands_1_5pct_packed_real *out)
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
static inline void skylight_sh_7_bands_1_5pct_packed_others(const
    skylight_sh_7_bands_1_5pct_packed_real *x, skylight_sh_7_bands_1_5pct_packed_real *out)
{
    out[0] = 1.0f;
    out[1] = (-4.57142878f) * (x[1] - 2.5f) / ((-2.0f) - x[1]) - 1.0f;
    out[2] = 2.0f * out[1] * out[1] - 1.0f;
    out[3] = 2.0f * out[1] * out[2] - out[1];
    out[4] = 2.0f * out[2] * out[2] - 1.0f;
    (void)x;
}

/* cos(m azimuth) and sin(m azimuth) for m < bands, by doubling. */
static inline void skylight_sh_7_bands_1_5pct_packed_waves(skylight_sh_7_bands_1_5pct_packed_real
    azimuth, skylight_sh_7_bands_1_5pct_packed_real *cosines,
    skylight_sh_7_bands_1_5pct_packed_real *sines)
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
static inline float skylight_sh_7_bands_1_5pct_packed_sinc(float share)
{
    const float x = 3.14159274f * share;
    return sinf(x) / x;
}

/* Of each axis: where its functions have slopes. */
static const double
    skylight_sh_7_bands_1_5pct_packed_slope_range[SKYLIGHT_SH_7_BANDS_1_5PCT_PACKED_AXES][2] = { {
    0.0, 1.5707963267948966 }, { 2.5, 6.0 } };

/* The functions of an axis at v, and their slopes. */
static inline void skylight_sh_7_bands_1_5pct_packed_functions(int axis, double v, double *out,
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
        slopes[0] = 0.0;
        slopes[1] = (-4.5714285714285712) / part_1 - part_2 * -1.0 / part_1;
        slopes[2] = 2.0 * slopes[1] * out[1] + part_3 * slopes[1];
        slopes[3] = 2.0 * slopes[1] * out[2] + part_4 * slopes[2] - slopes[1];
        slopes[4] = 2.0 * slopes[2] * out[2] + part_5 * slopes[2];
    }
    (void)v;
}

/* What all weights share, then its slopes after the axes. */
static inline void skylight_sh_7_bands_1_5pct_packed_scale_slopes(const double *x, double *out)
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
static inline int skylight_sh_7_bands_1_5pct_packed_kind(float v)
{
    uint32_t bits;
    memcpy(&bits, &v, sizeof bits);
    bits &= 0x7fffffffu;
    return (bits >= 0x7f800000u) + (bits > 0x7f800000u);
}

/* A number that is no NaN, finite: an infinity becomes a large number of its sign. */
static inline float skylight_sh_7_bands_1_5pct_packed_finite(float v)
{
    if (skylight_sh_7_bands_1_5pct_packed_kind(v)) {
        uint32_t bits;
        memcpy(&bits, &v, sizeof bits);
        v = bits >> 31 ? -3e38f : 3e38f;
    }
    return v;
}

/* Clamps the axes' inputs into x. Returns the status: 0; 1 where one was not inside; 2, and nothing
   in x, where one is NaN or the azimuth no finite number. */
static inline int skylight_sh_7_bands_1_5pct_packed_inputs(const float
    inputs[SKYLIGHT_SH_7_BANDS_1_5PCT_PACKED_AXES], float azimuth,
                                     skylight_sh_7_bands_1_5pct_packed_real
                                         x[SKYLIGHT_SH_7_BANDS_1_5PCT_PACKED_AXES])
{
    int axis, status = 0, strange = skylight_sh_7_bands_1_5pct_packed_kind(azimuth) ? 2 : 0;
    for (axis = 0; axis < SKYLIGHT_SH_7_BANDS_1_5PCT_PACKED_AXES; ++axis) strange |=
        skylight_sh_7_bands_1_5pct_packed_kind(inputs[axis]);
    if (strange & 2) return 2;
    for (axis = 0; axis < SKYLIGHT_SH_7_BANDS_1_5PCT_PACKED_AXES; ++axis) {
        const float v = skylight_sh_7_bands_1_5pct_packed_finite(inputs[axis]);
        const skylight_sh_7_bands_1_5pct_packed_real low =
            skylight_sh_7_bands_1_5pct_packed_range[axis][0],
            high = skylight_sh_7_bands_1_5pct_packed_range[axis][1];
        const skylight_sh_7_bands_1_5pct_packed_real at_least =
            (skylight_sh_7_bands_1_5pct_packed_real)v < low ? low :
            (skylight_sh_7_bands_1_5pct_packed_real)v;
        status |= (v < skylight_sh_7_bands_1_5pct_packed_inside[axis][0]) | (v >
            skylight_sh_7_bands_1_5pct_packed_inside[axis][1]);
        x[axis] = at_least > high ? high : at_least;
    }
    return status;
}

/* Orders m >= 0 alone are stored: those of a light that is even in y at azimuth 0. */
#define SKYLIGHT_SH_7_BANDS_1_5PCT_PACKED_FIRST_ORDER(l) 0

/* Stores the weight of degree l and order m turned by the azimuth (Habel et al. 2008, eq. 4). */
static inline void skylight_sh_7_bands_1_5pct_packed_place(skylight_sh_7_bands_1_5pct_packed_real
    value, int l, int m,
                                     const skylight_sh_7_bands_1_5pct_packed_real *cosines,
                                         const skylight_sh_7_bands_1_5pct_packed_real *sines,
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
} skylight_sh_7_bands_1_5pct_packed_bits;

static inline void skylight_sh_7_bands_1_5pct_packed_fill(skylight_sh_7_bands_1_5pct_packed_bits *b)
{
    const unsigned char *const end = skylight_sh_7_bands_1_5pct_packed_stream + sizeof
        skylight_sh_7_bands_1_5pct_packed_stream;
    while (b->count <= 56 && b->next < end) {
        b->held |= (uint64_t)*b->next++ << b->count;
        b->count += 8;
    }
}

/* `width` bits, at most 31, as a number. */
static inline unsigned
    skylight_sh_7_bands_1_5pct_packed_fixed(skylight_sh_7_bands_1_5pct_packed_bits *b, int width)
{
    unsigned value;
    if (b->count < 32) skylight_sh_7_bands_1_5pct_packed_fill(b);
    value = (unsigned)(b->held & ((UINT64_C(1) << width) - 1));
    b->held >>= width;
    b->count -= width;
    return value;
}

/* A Rice code of `low` low bits: ones, a zero, the low bits; then folded back: 0, 1, 2, 3 -> 0, -1,
   1, -2. */
static inline int skylight_sh_7_bands_1_5pct_packed_rice(skylight_sh_7_bands_1_5pct_packed_bits *b,
    int low)
{
    unsigned high = 0, folded;
    if (b->count < 32) skylight_sh_7_bands_1_5pct_packed_fill(b);
    while (b->held & 1) {
        ++high;
        b->held >>= 1;
        if (--b->count < 1) skylight_sh_7_bands_1_5pct_packed_fill(b);
    }
    b->held >>= 1;
    --b->count;
    folded = (high << low) | skylight_sh_7_bands_1_5pct_packed_fixed(b, low);
    return folded & 1 ? -(int)(folded >> 1) - 1 : (int)(folded >> 1);
}

/* The stream from its start. */
static inline skylight_sh_7_bands_1_5pct_packed_bits skylight_sh_7_bands_1_5pct_packed_open(void)
{
    skylight_sh_7_bands_1_5pct_packed_bits b;
    b.next = skylight_sh_7_bands_1_5pct_packed_stream;
    b.held = 0;
    b.count = 0;
    return b;
}

/* The next band's profile: twice the low bits that its numbers have, by their place in a run. */
static inline void
    skylight_sh_7_bands_1_5pct_packed_next_profile(skylight_sh_7_bands_1_5pct_packed_bits *b,
    int profile[32])
{
    const int used = (int)skylight_sh_7_bands_1_5pct_packed_fixed(b, 5);
    int i;
    for (i = 0; i < used; ++i) profile[i] = (int)skylight_sh_7_bands_1_5pct_packed_fixed(b, 5);
}

/* The length of the next run, by that of the same channel and product at the weight before. */
static inline int
    skylight_sh_7_bands_1_5pct_packed_next_length(skylight_sh_7_bands_1_5pct_packed_bits *b,
    signed char *length)
{
    const int found = *length + skylight_sh_7_bands_1_5pct_packed_rice(b, 0);
    *length = (signed char)found;
    return found;
}

/* The next number, of `size` half low bits. */
static inline int
    skylight_sh_7_bands_1_5pct_packed_next_number(skylight_sh_7_bands_1_5pct_packed_bits *b,
    int size)
{
    return skylight_sh_7_bands_1_5pct_packed_rice(b, size > 0 ? size >> 1 : 0);
}

static const signed char
    skylight_sh_7_bands_1_5pct_packed_run_profile[SKYLIGHT_SH_7_BANDS_1_5PCT_PACKED_RUNS] =
    SKYLIGHT_SH_7_BANDS_1_5PCT_PACKED_RUN_PROFILE;
static const signed char
    skylight_sh_7_bands_1_5pct_packed_channel_profile[SKYLIGHT_SH_7_BANDS_1_5PCT_PACKED_CHANNELS] =
    SKYLIGHT_SH_7_BANDS_1_5PCT_PACKED_CHANNEL_PROFILE;

/* Reads the stream once, forward, and stores the first `bands` bands. */
static inline void skylight_sh_7_bands_1_5pct_packed_combine(const
    skylight_sh_7_bands_1_5pct_packed_real *first,
                                       const skylight_sh_7_bands_1_5pct_packed_real *others,
                                       const skylight_sh_7_bands_1_5pct_packed_real *cosines,
                                       const skylight_sh_7_bands_1_5pct_packed_real *sines,
                                           int bands,
                                       float
                                           weights[SKYLIGHT_SH_7_BANDS_1_5PCT_PACKED_CHANNELS]
                                           [SKYLIGHT_SH_7_BANDS_1_5PCT_PACKED_WEIGHTS])
{
    signed char
        lengths[SKYLIGHT_SH_7_BANDS_1_5PCT_PACKED_CHANNELS][SKYLIGHT_SH_7_BANDS_1_5PCT_PACKED_RUNS];
    int profile[32], i, l, m, channel, other;
    skylight_sh_7_bands_1_5pct_packed_bits bits = skylight_sh_7_bands_1_5pct_packed_open();
    memset(lengths, 0, sizeof lengths);
    memset(profile, 0, sizeof profile);
    for (l = 0; l < bands; ++l) {
        skylight_sh_7_bands_1_5pct_packed_next_profile(&bits, profile);
        for (m = SKYLIGHT_SH_7_BANDS_1_5PCT_PACKED_FIRST_ORDER(l); m <= l; ++m) {
            for (channel = 0; channel < SKYLIGHT_SH_7_BANDS_1_5PCT_PACKED_CHANNELS; ++channel) {
                skylight_sh_7_bands_1_5pct_packed_real value = 0;
                for (other = 0; other < SKYLIGHT_SH_7_BANDS_1_5PCT_PACKED_RUNS; ++other) {
                    const int level = skylight_sh_7_bands_1_5pct_packed_run_profile[other] +
                                      skylight_sh_7_bands_1_5pct_packed_channel_profile[channel];
                    const int length = skylight_sh_7_bands_1_5pct_packed_next_length(&bits,
                        &lengths[channel][other]);
                    skylight_sh_7_bands_1_5pct_packed_real sum = 0;
                    for (i = 0; i < length; ++i) {
                        const int number = skylight_sh_7_bands_1_5pct_packed_next_number(&bits,
                            profile[i] + level);
                        sum += first[i] * (skylight_sh_7_bands_1_5pct_packed_real)number;
                    }
                    value += sum * others[other];
                }
                skylight_sh_7_bands_1_5pct_packed_place(value *
                    SKYLIGHT_SH_7_BANDS_1_5PCT_PACKED_STEP, l, m, cosines, sines,
                                  weights[channel]);
            }
        }
    }
}

/* The same in double precision, all bands: what derivatives need, whose terms cancel. */
static inline void skylight_sh_7_bands_1_5pct_packed_combine_double(
    const double *first, const double *others,
        const skylight_sh_7_bands_1_5pct_packed_real *cosines,
    const skylight_sh_7_bands_1_5pct_packed_real *sines,
        float
        weights[SKYLIGHT_SH_7_BANDS_1_5PCT_PACKED_CHANNELS]
        [SKYLIGHT_SH_7_BANDS_1_5PCT_PACKED_WEIGHTS])
{
    signed char
        lengths[SKYLIGHT_SH_7_BANDS_1_5PCT_PACKED_CHANNELS][SKYLIGHT_SH_7_BANDS_1_5PCT_PACKED_RUNS];
    int profile[32], i, l, m, channel, other;
    skylight_sh_7_bands_1_5pct_packed_bits bits = skylight_sh_7_bands_1_5pct_packed_open();
    memset(lengths, 0, sizeof lengths);
    memset(profile, 0, sizeof profile);
    for (l = 0; l < SKYLIGHT_SH_7_BANDS_1_5PCT_PACKED_BANDS; ++l) {
        skylight_sh_7_bands_1_5pct_packed_next_profile(&bits, profile);
        for (m = SKYLIGHT_SH_7_BANDS_1_5PCT_PACKED_FIRST_ORDER(l); m <= l; ++m) {
            for (channel = 0; channel < SKYLIGHT_SH_7_BANDS_1_5PCT_PACKED_CHANNELS; ++channel) {
                double value = 0.0;
                for (other = 0; other < SKYLIGHT_SH_7_BANDS_1_5PCT_PACKED_RUNS; ++other) {
                    const int level = skylight_sh_7_bands_1_5pct_packed_run_profile[other] +
                                      skylight_sh_7_bands_1_5pct_packed_channel_profile[channel];
                    const int length = skylight_sh_7_bands_1_5pct_packed_next_length(&bits,
                        &lengths[channel][other]);
                    double sum = 0.0;
                    for (i = 0; i < length; ++i) {
                        const int number = skylight_sh_7_bands_1_5pct_packed_next_number(&bits,
                            profile[i] + level);
                        sum += first[i] * (double)number;
                    }
                    value += sum * others[other];
                }
                skylight_sh_7_bands_1_5pct_packed_place((skylight_sh_7_bands_1_5pct_packed_real)(
                    value * (double)SKYLIGHT_SH_7_BANDS_1_5PCT_PACKED_STEP), l, m,
                                  cosines, sines, weights[channel]);
            }
        }
    }
}

/* What becomes of the first `bands` bands once they are stored; the others become 0. */
static inline void skylight_sh_7_bands_1_5pct_packed_finish(int bands, int lights,
    const skylight_sh_7_bands_1_5pct_packed_real *cosines,
                                      const skylight_sh_7_bands_1_5pct_packed_real *sines,
                                      float
                                          weights[SKYLIGHT_SH_7_BANDS_1_5PCT_PACKED_CHANNELS]
                                          [SKYLIGHT_SH_7_BANDS_1_5PCT_PACKED_WEIGHTS])
{
    if (bands < SKYLIGHT_SH_7_BANDS_1_5PCT_PACKED_BANDS) {
        int channel, i;
        for (channel = 0; channel < SKYLIGHT_SH_7_BANDS_1_5PCT_PACKED_CHANNELS; ++channel)
            for (i = bands * bands; i < SKYLIGHT_SH_7_BANDS_1_5PCT_PACKED_WEIGHTS; ++i)
                weights[channel][i] = 0.0f;
    }
    (void)lights;
    (void)cosines;
    (void)sines;
}

/* Evaluates the first `bands` bands (1 to SKYLIGHT_SH_7_BANDS_1_5PCT_PACKED_BANDS, clamped like an
 * input) and zeroes the
   rest; returns the status. */
static inline int skylight_sh_7_bands_1_5pct_packed_evaluate(const float
    inputs[SKYLIGHT_SH_7_BANDS_1_5PCT_PACKED_AXES], float azimuth,
                                       int bands,
                                       float
                                           weights[SKYLIGHT_SH_7_BANDS_1_5PCT_PACKED_CHANNELS]
                                           [SKYLIGHT_SH_7_BANDS_1_5PCT_PACKED_WEIGHTS])
{
    skylight_sh_7_bands_1_5pct_packed_real x[SKYLIGHT_SH_7_BANDS_1_5PCT_PACKED_AXES],
        first[SKYLIGHT_SH_7_BANDS_1_5PCT_PACKED_FIRST],
        others[SKYLIGHT_SH_7_BANDS_1_5PCT_PACKED_OTHERS];
    skylight_sh_7_bands_1_5pct_packed_real cosines[SKYLIGHT_SH_7_BANDS_1_5PCT_PACKED_BANDS],
        sines[SKYLIGHT_SH_7_BANDS_1_5PCT_PACKED_BANDS], scale;
    int i, status = skylight_sh_7_bands_1_5pct_packed_inputs(inputs, azimuth, x);
    if (status == 2) {
        memset(weights, 0, sizeof(float) * SKYLIGHT_SH_7_BANDS_1_5PCT_PACKED_CHANNELS *
            SKYLIGHT_SH_7_BANDS_1_5PCT_PACKED_WEIGHTS);
        return 2;
    }
    if (bands < 1 || bands > SKYLIGHT_SH_7_BANDS_1_5PCT_PACKED_BANDS) {
        bands = bands < 1 ? 1 : SKYLIGHT_SH_7_BANDS_1_5PCT_PACKED_BANDS;
        status = 1;
    }
    scale = skylight_sh_7_bands_1_5pct_packed_scale(x) *
        (skylight_sh_7_bands_1_5pct_packed_real)SKYLIGHT_SH_7_BANDS_1_5PCT_PACKED_EXPOSURE;
    skylight_sh_7_bands_1_5pct_packed_first(x, first);
    skylight_sh_7_bands_1_5pct_packed_others(x, others);
    for (i = 0; i < SKYLIGHT_SH_7_BANDS_1_5PCT_PACKED_OTHERS; ++i) others[i] *= scale;
    skylight_sh_7_bands_1_5pct_packed_waves((skylight_sh_7_bands_1_5pct_packed_real)azimuth,
        cosines, sines);
    skylight_sh_7_bands_1_5pct_packed_combine(first, others, cosines, sines, bands, weights);
    skylight_sh_7_bands_1_5pct_packed_finish(bands, 1, cosines, sines, weights);
    return status;
}

/* Evaluates `count` suns from arrays, one an axis, and one of azimuths (or none, where the table
   fixes it); returns the largest status. */
static inline int skylight_sh_7_bands_1_5pct_packed_evaluate_batch(
    int count, const float *const inputs[SKYLIGHT_SH_7_BANDS_1_5PCT_PACKED_AXES],
        const float *azimuths,
    float
        (*weights)[SKYLIGHT_SH_7_BANDS_1_5PCT_PACKED_CHANNELS]
        [SKYLIGHT_SH_7_BANDS_1_5PCT_PACKED_WEIGHTS])
{
    int s, axis, worst = 0;
    for (s = 0; s < count; ++s) {
        const float azimuth = azimuths ? azimuths[s] : SKYLIGHT_SH_7_BANDS_1_5PCT_PACKED_AZIMUTH;
        float sun[SKYLIGHT_SH_7_BANDS_1_5PCT_PACKED_AXES];
        int status;
        for (axis = 0; axis < SKYLIGHT_SH_7_BANDS_1_5PCT_PACKED_AXES; ++axis) sun[axis] =
            inputs[axis][s];
        status = skylight_sh_7_bands_1_5pct_packed_evaluate(sun, azimuth,
            SKYLIGHT_SH_7_BANDS_1_5PCT_PACKED_BANDS, weights[s]);
        worst = status > worst ? status : worst;
    }
    return worst;
}

/* All products of `count` numbers and `size` functions, the functions' place fastest; returns how
   many. */
static inline int skylight_sh_7_bands_1_5pct_packed_multiply(double *products, int count,
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
static inline int skylight_sh_7_bands_1_5pct_packed_evaluate_gradient(
    const float inputs[SKYLIGHT_SH_7_BANDS_1_5PCT_PACKED_AXES], float azimuth,
    float
        weights[SKYLIGHT_SH_7_BANDS_1_5PCT_PACKED_CHANNELS]
        [SKYLIGHT_SH_7_BANDS_1_5PCT_PACKED_WEIGHTS],
    float
        gradient[SKYLIGHT_SH_7_BANDS_1_5PCT_PACKED_AXES][SKYLIGHT_SH_7_BANDS_1_5PCT_PACKED_CHANNELS]
        [SKYLIGHT_SH_7_BANDS_1_5PCT_PACKED_WEIGHTS])
{
    static const int sizes[SKYLIGHT_SH_7_BANDS_1_5PCT_PACKED_AXES] =
        SKYLIGHT_SH_7_BANDS_1_5PCT_PACKED_SIZES;
    double x[SKYLIGHT_SH_7_BANDS_1_5PCT_PACKED_AXES],
        functions[SKYLIGHT_SH_7_BANDS_1_5PCT_PACKED_AXES][SKYLIGHT_SH_7_BANDS_1_5PCT_PACKED_MOST];
    double slopes[SKYLIGHT_SH_7_BANDS_1_5PCT_PACKED_AXES][SKYLIGHT_SH_7_BANDS_1_5PCT_PACKED_MOST],
        scale[1 + SKYLIGHT_SH_7_BANDS_1_5PCT_PACKED_AXES];
    skylight_sh_7_bands_1_5pct_packed_real cosines[SKYLIGHT_SH_7_BANDS_1_5PCT_PACKED_BANDS],
        sines[SKYLIGHT_SH_7_BANDS_1_5PCT_PACKED_BANDS];
    int axis, other, i;
    const int status = skylight_sh_7_bands_1_5pct_packed_evaluate(inputs, azimuth,
        SKYLIGHT_SH_7_BANDS_1_5PCT_PACKED_BANDS, weights);
    if (status == 2) {
        memset(gradient, 0,
               sizeof(float) * SKYLIGHT_SH_7_BANDS_1_5PCT_PACKED_AXES *
                   SKYLIGHT_SH_7_BANDS_1_5PCT_PACKED_CHANNELS *
                   SKYLIGHT_SH_7_BANDS_1_5PCT_PACKED_WEIGHTS);
        return 2;
    }
    for (axis = 0; axis < SKYLIGHT_SH_7_BANDS_1_5PCT_PACKED_AXES; ++axis) {
        const double low = skylight_sh_7_bands_1_5pct_packed_slope_range[axis][0];
        const double high = skylight_sh_7_bands_1_5pct_packed_slope_range[axis][1];
        const double v = (double)skylight_sh_7_bands_1_5pct_packed_finite(inputs[axis]);
        x[axis] = v < low ? low : v > high ? high : v;
        skylight_sh_7_bands_1_5pct_packed_functions(axis, x[axis], functions[axis], slopes[axis]);
    }
    skylight_sh_7_bands_1_5pct_packed_scale_slopes(x, scale);
    for (i = 0; i < 1 + SKYLIGHT_SH_7_BANDS_1_5PCT_PACKED_AXES; ++i) scale[i] *=
        (double)SKYLIGHT_SH_7_BANDS_1_5PCT_PACKED_EXPOSURE;
    skylight_sh_7_bands_1_5pct_packed_waves((skylight_sh_7_bands_1_5pct_packed_real)azimuth,
        cosines, sines);
    for (axis = 0; axis < SKYLIGHT_SH_7_BANDS_1_5PCT_PACKED_AXES; ++axis) {
        double first[SKYLIGHT_SH_7_BANDS_1_5PCT_PACKED_MOST],
            others[SKYLIGHT_SH_7_BANDS_1_5PCT_PACKED_OTHERS];
        int count = 1;
        others[0] = 1.0;
        for (other = 0; other < SKYLIGHT_SH_7_BANDS_1_5PCT_PACKED_AXES; ++other) {
            double one[SKYLIGHT_SH_7_BANDS_1_5PCT_PACKED_MOST];
            for (i = 0; i < sizes[other]; ++i) {
                one[i] = functions[other][i];
                if (other == axis) one[i] = scale[0] * slopes[axis][i] + scale[1 + axis] * one[i];
                if (other == 0) first[i] = one[i];
            }
            if (other) count = skylight_sh_7_bands_1_5pct_packed_multiply(others, count, one,
                sizes[other]);
        }
        skylight_sh_7_bands_1_5pct_packed_combine_double(first, others, cosines, sines,
            gradient[axis]);
        skylight_sh_7_bands_1_5pct_packed_finish(SKYLIGHT_SH_7_BANDS_1_5PCT_PACKED_BANDS, 0,
            cosines, sines, gradient[axis]);
    }
    return status;
}

SKYLIGHT_SH_7_BANDS_1_5PCT_PACKED_API int skylight_sh_7_bands_1_5pct_packed_weights(float
    sun_zenith, float sun_azimuth, float turbidity,
    float
    weights[SKYLIGHT_SH_7_BANDS_1_5PCT_PACKED_CHANNELS][SKYLIGHT_SH_7_BANDS_1_5PCT_PACKED_WEIGHTS])
{
    const float skylight_sh_7_bands_1_5pct_packed_given[SKYLIGHT_SH_7_BANDS_1_5PCT_PACKED_AXES] = {
        sun_zenith, turbidity };
    return skylight_sh_7_bands_1_5pct_packed_evaluate(skylight_sh_7_bands_1_5pct_packed_given,
        sun_azimuth, SKYLIGHT_SH_7_BANDS_1_5PCT_PACKED_BANDS, weights);
}

SKYLIGHT_SH_7_BANDS_1_5PCT_PACKED_API int skylight_sh_7_bands_1_5pct_packed_weights_bands(float
    sun_zenith, float sun_azimuth, float turbidity, int bands,
    float
    weights[SKYLIGHT_SH_7_BANDS_1_5PCT_PACKED_CHANNELS][SKYLIGHT_SH_7_BANDS_1_5PCT_PACKED_WEIGHTS])
{
    const float skylight_sh_7_bands_1_5pct_packed_given[SKYLIGHT_SH_7_BANDS_1_5PCT_PACKED_AXES] = {
        sun_zenith, turbidity };
    return skylight_sh_7_bands_1_5pct_packed_evaluate(skylight_sh_7_bands_1_5pct_packed_given,
        sun_azimuth, bands, weights);
}

SKYLIGHT_SH_7_BANDS_1_5PCT_PACKED_API int skylight_sh_7_bands_1_5pct_packed_weights_batch(int count,
    const float *sun_zenith, const float *sun_azimuth, const float *turbidity,
    float
    (*weights)[SKYLIGHT_SH_7_BANDS_1_5PCT_PACKED_CHANNELS]
    [SKYLIGHT_SH_7_BANDS_1_5PCT_PACKED_WEIGHTS])
{
    const float *const
        skylight_sh_7_bands_1_5pct_packed_given[SKYLIGHT_SH_7_BANDS_1_5PCT_PACKED_AXES] = {
        sun_zenith, turbidity };
    return skylight_sh_7_bands_1_5pct_packed_evaluate_batch(count,
        skylight_sh_7_bands_1_5pct_packed_given, sun_azimuth, weights);
}

SKYLIGHT_SH_7_BANDS_1_5PCT_PACKED_API int skylight_sh_7_bands_1_5pct_packed_weights_gradient(float
    sun_zenith, float sun_azimuth, float turbidity,
    float
    weights[SKYLIGHT_SH_7_BANDS_1_5PCT_PACKED_CHANNELS][SKYLIGHT_SH_7_BANDS_1_5PCT_PACKED_WEIGHTS],
    float
    gradient[SKYLIGHT_SH_7_BANDS_1_5PCT_PACKED_AXES][SKYLIGHT_SH_7_BANDS_1_5PCT_PACKED_CHANNELS]
    [SKYLIGHT_SH_7_BANDS_1_5PCT_PACKED_WEIGHTS])
{
    const float skylight_sh_7_bands_1_5pct_packed_given[SKYLIGHT_SH_7_BANDS_1_5PCT_PACKED_AXES] = {
        sun_zenith, turbidity };
    return
        skylight_sh_7_bands_1_5pct_packed_evaluate_gradient(skylight_sh_7_bands_1_5pct_packed_given,
        sun_azimuth, weights, gradient);
}

/* The dominant light's direction, a unit vector: where the linear part of the weights, summed over
   channels by luminance, points. Returns 0, or 1 (and straight up) where it points nowhere. */
SKYLIGHT_SH_7_BANDS_1_5PCT_PACKED_API int skylight_sh_7_bands_1_5pct_packed_dominant_of(const float
    *weights, float direction[3])
{
    static const float luminance[SKYLIGHT_SH_7_BANDS_1_5PCT_PACKED_CHANNELS] =
        SKYLIGHT_SH_7_BANDS_1_5PCT_PACKED_LUMINANCE;
    float x = 0.0f, y = 0.0f, z = 0.0f, length;
    int channel;
    for (channel = 0; channel < SKYLIGHT_SH_7_BANDS_1_5PCT_PACKED_CHANNELS; ++channel) {
        const float *const linear = weights + channel * SKYLIGHT_SH_7_BANDS_1_5PCT_PACKED_WEIGHTS +
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
SKYLIGHT_SH_7_BANDS_1_5PCT_PACKED_API void skylight_sh_7_bands_1_5pct_packed_ground(
    const float albedo[SKYLIGHT_SH_7_BANDS_1_5PCT_PACKED_CHANNELS],
    float
        weights[SKYLIGHT_SH_7_BANDS_1_5PCT_PACKED_CHANNELS]
        [SKYLIGHT_SH_7_BANDS_1_5PCT_PACKED_WEIGHTS])
{
    static const float lower[SKYLIGHT_SH_7_BANDS_1_5PCT_PACKED_BANDS] =
        SKYLIGHT_SH_7_BANDS_1_5PCT_PACKED_LOWER;
    int l, channel;
    for (channel = 0; channel < SKYLIGHT_SH_7_BANDS_1_5PCT_PACKED_CHANNELS; ++channel) {
        const float radiance = albedo[channel] * SKYLIGHT_SH_7_BANDS_1_5PCT_PACKED_REFLECTED *
            weights[channel][2];
        for (l = 0; l < SKYLIGHT_SH_7_BANDS_1_5PCT_PACKED_BANDS; ++l) weights[channel][l * (l + 1)]
            += radiance * lower[l];
    }
}

/* Tames the ringing of the horizon in the first `bands` bands by the zonal window sinc(pi l /
   bands) (Habel et al. 2008, eq. 5). */
SKYLIGHT_SH_7_BANDS_1_5PCT_PACKED_API void skylight_sh_7_bands_1_5pct_packed_window(
    int bands, float
        weights[SKYLIGHT_SH_7_BANDS_1_5PCT_PACKED_CHANNELS]
        [SKYLIGHT_SH_7_BANDS_1_5PCT_PACKED_WEIGHTS])
{
    int l, channel;
    for (l = 1; l < bands && l < SKYLIGHT_SH_7_BANDS_1_5PCT_PACKED_BANDS; ++l) {
        const float factor = skylight_sh_7_bands_1_5pct_packed_sinc((float)l / (float)bands);
        for (channel = 0; channel < SKYLIGHT_SH_7_BANDS_1_5PCT_PACKED_CHANNELS; ++channel)
            weights[channel][l * (l + 1)] *= factor;
    }
}

#endif /* SKYLIGHT_SH_7_BANDS_1_5PCT_PACKED_DEFINED */
