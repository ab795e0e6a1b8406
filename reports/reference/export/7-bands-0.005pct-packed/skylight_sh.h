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
 *   w[SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_CHANNELS][SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_WEIGHTS];
 *   int status = skylight_sh_7_bands_0_005pct_packed_weights(0.785000026f, 0.0f, 4.25f, w);
 * Compile with, for instance
 *   cc -std=c99 -O3 program.c -o program -lm
 * Included plainly, the file is all there is: its functions are static, and the table stands in
 * every unit that includes it. With SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_EXTERN defined before it,
 * it declares only; the one unit that also defines
 * SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_IMPLEMENTATION holds functions and table, for C and C++.
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
 *   Define SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_EXPOSURE before this file (where it holds the table)
 *   to multiply all weights (1 by default).
 *
 * Accuracy, as shipped: E_mean 0.0045 %, E_max 0.0184 % of the least luminance of the same sky, at
 * azimuth 0.
 * The expansion rings: the least value it takes, over all directions and measured sets, is -12.7 %
 * of its largest in the same set; the window below tames it.
 * Memory: 4744 bytes of constants, packed into few bytes (a fast table takes more and less time).
 *
 * Provenance
 *   skylight-sh 0.1.0, config preetham 08540d17388f71b0, table 7-bands-0.005pct-packed
 */
#ifdef __cplusplus
#if __cplusplus < 201103L && !defined(_MSC_VER)
#error "skylight_sh needs C++11 or later: compile with -std=c++11."
#endif
#elif (!defined(__STDC_VERSION__) || __STDC_VERSION__ < 199901L) && !defined(_MSC_VER)
#error "skylight_sh needs C99 or later: compile with -std=c99."
#endif
#if defined(SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_IMPLEMENTATION) && \
    !defined(SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_EXTERN)
#error "Define SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_EXTERN in every unit, \
SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_IMPLEMENTATION beside it in one."
#endif
#if defined(SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_API) && \
    defined(SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_EXTERN) && \
    !defined(SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_DECLARED)
#error "Define SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_EXTERN before this file is included for the \
first time."
#endif
#if defined(SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_DECLARED) && \
    !defined(SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_EXTERN)
#error "Leave SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_EXTERN defined: this file was included with it \
before."
#endif

#ifndef SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_H
#define SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_H 0xfd514b86

#include <math.h>
#include <stdint.h>
#include <string.h>

#ifndef SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_EXTERN
#define SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_API static inline
#else
#define SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_DECLARED
#ifdef __cplusplus
#define SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_API extern "C"
#else
#define SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_API extern
#endif
#endif
#ifndef SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_EXPOSURE
#define SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_EXPOSURE 1
#endif

#define SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_VERSION "0.1.0"
#define SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_BANDS 7
#define SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_WEIGHTS 49
#define SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_CHANNELS 3
#define SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_AXES 2
#define SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_UNIT "cd/m2"
#define SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_E_MEAN 4.496000e-05
#define SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_E_MAX 1.841000e-04
#define SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_UNPACKED 4988
#define SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_SUN_ZENITH_MIN 0.0f
#define SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_SUN_ZENITH_MAX 1.57079637f
#define SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_TURBIDITY_MIN 2.5f
#define SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_TURBIDITY_MAX 6.0f

/* Evaluates all bands. */
SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_API int skylight_sh_7_bands_0_005pct_packed_weights(float
    sun_zenith, float sun_azimuth, float turbidity,
    float
    weights[SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_CHANNELS]
    [SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_WEIGHTS]);
/* Evaluates the first `bands` bands (1 to SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_BANDS, clamped
   likewise) and zeroes the rest. */
SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_API int skylight_sh_7_bands_0_005pct_packed_weights_bands(float
    sun_zenith, float sun_azimuth, float turbidity, int bands,
    float
    weights[SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_CHANNELS]
    [SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_WEIGHTS]);
/* Evaluates `count` suns from arrays; returns the largest status. Unpacks
   the table once, SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_UNPACKED floats on the stack. */
SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_API int skylight_sh_7_bands_0_005pct_packed_weights_batch(int
    count, const float *sun_zenith, const float *sun_azimuth, const float *turbidity,
    float
    (*weights)[SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_CHANNELS]
    [SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_WEIGHTS]);
/* The same with the suns of each weight side by side:
   [SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_CHANNELS][SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_WEIGHTS]
       [count]. */
SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_API int skylight_sh_7_bands_0_005pct_packed_weights_columns(int
    count, const float *sun_zenith, const float *sun_azimuth, const float *turbidity,
    float *weights);
/* Evaluates all bands and their derivatives after each axis (sun_zenith,
   turbidity), per unit of the axis; beyond a range, those at its edge. */
SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_API int
    skylight_sh_7_bands_0_005pct_packed_weights_gradient(float sun_zenith, float sun_azimuth,
    float turbidity, float
    weights[SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_CHANNELS]
    [SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_WEIGHTS],
    float
    gradient[SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_AXES][SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_CHANNELS]
    [SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_WEIGHTS]);
/* Unpacks the table into memory of the caller's, SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_UNPACKED
   floats, for the calls below. */
SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_API void skylight_sh_7_bands_0_005pct_packed_unpack(float
    memory[SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_UNPACKED]);
/* Evaluates all bands of an unpacked table: far faster than of the packed
   one. */
SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_API int
    skylight_sh_7_bands_0_005pct_packed_unpacked_weights(const float
    memory[SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_UNPACKED], float sun_zenith, float sun_azimuth,
    float turbidity, float
    weights[SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_CHANNELS]
    [SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_WEIGHTS]);
/* The same for the first `bands` bands. */
SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_API int
    skylight_sh_7_bands_0_005pct_packed_unpacked_weights_bands(const float
    memory[SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_UNPACKED], float sun_zenith, float sun_azimuth,
    float turbidity, int bands, float
    weights[SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_CHANNELS]
    [SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_WEIGHTS]);
/* The same for `count` suns from arrays; returns the largest status. */
SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_API int
    skylight_sh_7_bands_0_005pct_packed_unpacked_weights_batch(const float
    memory[SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_UNPACKED], int count, const float *sun_zenith,
    const float *sun_azimuth, const float *turbidity,
    float
    (*weights)[SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_CHANNELS]
    [SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_WEIGHTS]);
/* The same as
 * [SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_CHANNELS][SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_WEIGHTS]
 * [count]. */
SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_API int
    skylight_sh_7_bands_0_005pct_packed_unpacked_weights_columns(const float
    memory[SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_UNPACKED], int count, const float *sun_zenith,
    const float *sun_azimuth, const float *turbidity, float *weights);
/* Unit vector of the dominant light. Returns 0, or 1 (and straight up) where there is none. */
#define skylight_sh_7_bands_0_005pct_packed_dominant(weights, direction) \
    skylight_sh_7_bands_0_005pct_packed_dominant_of(&(weights)[0][0], direction)
SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_API int skylight_sh_7_bands_0_005pct_packed_dominant_of(const
    float *weights, float direction[3]);
/* Optional: adds an even ground of this albedo below the horizon, lit by the sky (before any
 * window). */
SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_API void skylight_sh_7_bands_0_005pct_packed_ground(const float
    albedo[SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_CHANNELS],
    float
    weights[SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_CHANNELS]
    [SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_WEIGHTS]);
/* Optional: tames the ringing of the horizon by the zonal window of the first `bands` bands. */
SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_API void skylight_sh_7_bands_0_005pct_packed_window(int bands,
    float
    weights[SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_CHANNELS]
    [SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_WEIGHTS]);

#elif SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_H != 0xfd514b86
#error "Another table has the prefix skylight_sh_7_bands_0_005pct_packed_7_bands_0_005pct_packed \
already: export one of them under a prefix of its own."
#endif /* SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_H */

#if (!defined(SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_EXTERN) || \
    defined(SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_IMPLEMENTATION)) && \
    !defined(SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_DEFINED)
#define SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_DEFINED

typedef float skylight_sh_7_bands_0_005pct_packed_real;

/* Functions of the first axis, in fours; products of the other axes'
   functions. */
#define SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_FIRST 16
#define SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_OTHERS 8
#define SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_SIZES { 14, 8 }
#define SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_MOST 16
#define SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_AZIMUTH 0.0f
/* The axis of the sun's zenith angle. */
#define SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_SUN 0
/* The channels' luminance. */
#define SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_LUMINANCE { 0.212672845f, 0.715152144f, 0.0721749961f }
/* What an even ground reflects of the weight l = 1, m = 0, and its own
   zonal weights. */
#define SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_REFLECTED 0.651470006f
#define SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_LOWER { 1.7724539f, -1.53499007f, 0.0f, 0.586184025f, \
    0.0f, -0.367410272f, 0.0f }

/* Of each axis: the first and last float that counts as inside, and its
   range. */
static const float
    skylight_sh_7_bands_0_005pct_packed_inside[SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_AXES][2] = { {
    -1.57079626e-06f, 1.5707978f }, { 2.49999666f, 6.00000334f } };
static const skylight_sh_7_bands_0_005pct_packed_real
    skylight_sh_7_bands_0_005pct_packed_range[SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_AXES][2] = { {
    0.0f, 1.57079637f }, { 2.5f, 6.0f } };

/* Classes; a row's numbers, one a sum, and those of the first 1, 2, ..
   bands; room for a class's sums. */
#define SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_CLASSES 3
#define SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_OTHER_CLASSES(CLASS) CLASS(1) CLASS(2)
#define SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_FACTORS 9
#define SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_WIDTH 28
#define SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_WIDTHS { 1, 3, 6, 10, 15, 21, 28 }
#define SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_ROOM 32
/* All rows; of each class the first row, how many, and the place of its
   first product. */
#define SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_TERMS 178
#define SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_STARTS { 0, 69, 121 }
#define SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_COUNTS { 69, 52, 57 }
#define SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_PLACES { 0, 72, 124 }
#define SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_PRODUCTS_ROOM 188
/* Of each class and product of the other axes' functions: how many
   functions of the first axis it has. */
#define SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_LENGTHS { { 14, 14, 10, 11, 10, 5, 3, 2 }, { 12, 11, \
    11, 8, 5, 3, 2, 0 }, { 14, 12, 9, 10, 7, 4, 1, 0 } }
/* The same: of each that has any, class, place of the first product, how
   many, the other axes' product. */
#define SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_PRODUCTS(PRODUCT) \
    PRODUCT(0, 0, 14, 0) \
    PRODUCT(0, 14, 14, 1) \
    PRODUCT(0, 28, 10, 2) \
    PRODUCT(0, 38, 11, 3) \
    PRODUCT(0, 49, 10, 4) \
    PRODUCT(0, 59, 5, 5) \
    PRODUCT(0, 64, 3, 6) \
    PRODUCT(0, 67, 2, 7) \
    PRODUCT(1, 72, 12, 0) \
    PRODUCT(1, 84, 11, 1) \
    PRODUCT(1, 95, 11, 2) \
    PRODUCT(1, 106, 8, 3) \
    PRODUCT(1, 114, 5, 4) \
    PRODUCT(1, 119, 3, 5) \
    PRODUCT(1, 122, 2, 6) \
    PRODUCT(2, 124, 14, 0) \
    PRODUCT(2, 138, 12, 1) \
    PRODUCT(2, 150, 9, 2) \
    PRODUCT(2, 159, 10, 3) \
    PRODUCT(2, 169, 7, 4) \
    PRODUCT(2, 176, 4, 5) \
    PRODUCT(2, 180, 1, 6)
/* Where sums go: of each degree, the first column, or -1 where it carries
   nothing. */
#define SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_COLUMNS { 0, 1, 3, 6, 10, 15, 21 }
/* The same for vectors of four: places, two vectors of sums and the numbers
   of both, order. */
#define SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_FOURS 7
#define SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_STORES(BAND, NOTHING, MINUS, PLUS) \
    BAND(0, PLUS(0, 0, 0, 0, 1, 2, 3, 0)) \
    BAND(1, MINUS(1, 0, 0, 2, 1, 0, 0, 1) PLUS(2, 0, 1, 1, 2, 3, 4, 0)) \
    BAND(2, MINUS(4, 0, 1, 5, 4, 3, 2, 2) PLUS(6, 0, 1, 3, 4, 5, 6, 0)) \
    BAND(3, MINUS(9, 1, 2, 5, 4, 3, 2, 3) PLUS(12, 1, 2, 2, 3, 4, 5, 0)) \
    BAND(4, MINUS(16, 2, 3, 6, 5, 4, 3, 4) PLUS(20, 2, 3, 2, 3, 4, 5, 0) PLUS(21, 2, 3, 3, 4, 5, \
        6, 1)) \
    BAND(5, MINUS(25, 4, 5, 4, 3, 2, 1, 5) MINUS(26, 4, 4, 3, 2, 1, 0, 4) PLUS(30, 3, 4, 3, 4, 5, \
        6, 0) PLUS(32, 4, 5, 1, 2, 3, 4, 2)) \
    BAND(6, MINUS(36, 6, 6, 3, 2, 1, 0, 6) MINUS(38, 5, 6, 5, 4, 3, 2, 4) PLUS(42, 5, 6, 1, 2, 3, \
        4, 0) PLUS(45, 6, 6, 0, 1, 2, 3, 3))

/* Runs of numbers, one a product of the other axes' functions, and their
   profiles; what one step is worth. */
#define SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_RUNS 8
#define SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_RUN_PROFILE { 11, 9, 5, 0, -7, -13, -19, -24 }
#define SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_CLASS_PROFILE { -8, -16, -14 }
#define SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_STEP 1.49011612e-06f

/* Whole numbers as Rice codes. */
static const unsigned char skylight_sh_7_bands_0_005pct_packed_stream[4473] = {
    235, 127, 126, 41, 108, 10, 25, 241, 255, 255, 251, 255, 255, 31, 13, 190, 93, 191, 217, 42,
    207, 127, 35, 226, 120, 16, 165, 98, 140, 255, 255, 254, 31, 99, 238, 141, 248, 1, 64, 115, 8,
    146, 24, 53, 180, 254, 255, 189, 215, 30, 155, 69, 250, 253, 223, 14, 2, 13, 255, 255, 30, 232,
    105, 213, 240, 250, 17, 161, 252, 255, 125, 4, 237, 73, 198, 121, 253, 254, 143, 213, 240, 247,
    63, 215, 246, 239, 255, 127, 56, 167, 146, 235, 152, 128, 152, 250, 130, 249, 255, 215, 232, 3,
    193, 2, 46, 95, 58, 157, 207, 255, 235, 187, 148, 217, 147, 100, 122, 252, 191, 4, 18, 242, 153,
    253, 118, 198, 239, 235, 242, 255, 255, 254, 255, 127, 156, 235, 247, 61, 28, 141, 62, 3, 136,
    237, 222, 89, 221, 255, 255, 253, 228, 237, 58, 234, 145, 162, 119, 247, 82, 195, 99, 254, 127,
    255, 11, 78, 0, 43, 230, 26, 209, 115, 252, 191, 159, 30, 191, 54, 179, 208, 255, 61, 42, 56,
    189, 255, 244, 30, 246, 255, 198, 84, 54, 134, 16, 32, 223, 255, 255, 15, 184, 210, 87, 255,
    132, 79, 61, 241, 128, 94, 146, 16, 98, 177, 255, 159, 130, 231, 59, 66, 157, 126, 194, 48, 108,
    234, 10, 0, 132, 244, 166, 251, 188, 22, 85, 213, 78, 46, 224, 176, 134, 139, 176, 176, 73, 28,
    224, 136, 251, 228, 37, 235, 39, 112, 255, 3, 69, 74, 255, 103, 251, 165, 16, 239, 14, 231, 63,
    46, 116, 1, 140, 122, 189, 191, 0, 203, 56, 15, 48, 22, 247, 62, 242, 4, 141, 132, 8, 60, 150,
    58, 112, 160, 95, 164, 239, 202, 253, 255, 255, 159, 167, 252, 173, 69, 15, 142, 148, 86, 178,
    32, 130, 238, 255, 145, 202, 119, 211, 78, 234, 139, 231, 142, 14, 252, 191, 177, 98, 173, 248,
    182, 105, 104, 51, 101, 80, 153, 65, 247, 179, 21, 137, 255, 108, 207, 191, 255, 39, 136, 107,
    101, 58, 55, 145, 174, 15, 0, 42, 159, 3, 96, 5, 65, 176, 79, 205, 115, 209, 72, 20, 208, 28,
    141, 86, 230, 89, 155, 222, 186, 197, 228, 249, 212, 166, 52, 138, 5, 96, 51, 189, 129, 33, 59,
    109, 141, 201, 180, 12, 220, 66, 145, 4, 56, 205, 189, 205, 146, 129, 70, 110, 182, 63, 133, 90,
    80, 20, 46, 77, 170, 184, 1, 156, 247, 103, 147, 203, 136, 133, 119, 97, 45, 249, 199, 185, 61,
    8, 42, 123, 245, 198, 7, 121, 238, 253, 48, 119, 241, 179, 104, 63, 184, 246, 207, 119, 203,
    195, 20, 191, 205, 234, 169, 221, 135, 80, 38, 189, 239, 44, 221, 47, 212, 38, 235, 159, 3, 22,
    229, 21, 173, 147, 233, 60, 204, 205, 42, 203, 177, 231, 220, 48, 219, 142, 182, 161, 230, 96,
    170, 219, 67, 5, 35, 159, 203, 184, 255, 251, 165, 178, 173, 35, 128, 0, 66, 247, 92, 126, 155,
    30, 207, 142, 159, 10, 234, 128, 90, 246, 106, 165, 149, 122, 63, 108, 232, 75, 25, 29, 115,
    229, 146, 67, 162, 60, 34, 131, 128, 121, 88, 3, 214, 251, 162, 112, 25, 20, 149, 109, 189, 99,
    71, 14, 101, 143, 107, 244, 149, 153, 87, 14, 230, 102, 231, 29, 236, 41, 31, 240, 84, 240, 94,
    57, 25, 211, 184, 207, 197, 70, 102, 95, 2, 126, 47, 123, 174, 140, 15, 223, 185, 181, 95, 83,
    27, 109, 108, 225, 251, 197, 181, 225, 114, 243, 123, 61, 242, 226, 220, 250, 190, 210, 255,
    207, 151, 222, 113, 24, 171, 249, 155, 208, 244, 8, 227, 97, 250, 255, 89, 230, 151, 234, 50,
    170, 237, 253, 8, 57, 117, 221, 126, 147, 240, 114, 198, 77, 161, 236, 42, 254, 246, 252, 242,
    194, 142, 245, 240, 74, 50, 59, 215, 152, 251, 63, 241, 252, 191, 9, 112, 88, 219, 66, 127, 16,
    44, 2, 55, 50, 134, 250, 225, 174, 191, 90, 133, 108, 102, 248, 71, 251, 138, 41, 112, 208, 174,
    36, 60, 0, 75, 172, 168, 111, 59, 168, 48, 112, 100, 55, 117, 180, 31, 84, 32, 84, 45, 65, 54,
    106, 71, 184, 111, 128, 162, 73, 48, 250, 193, 165, 171, 111, 0, 213, 167, 30, 8, 200, 126, 204,
    254, 77, 20, 133, 24, 76, 137, 5, 117, 110, 190, 39, 172, 138, 29, 81, 247, 99, 125, 69, 228,
    44, 251, 147, 223, 134, 254, 243, 239, 22, 79, 125, 188, 16, 124, 222, 205, 181, 123, 247, 39,
    96, 52, 31, 221, 230, 207, 132, 239, 102, 155, 168, 156, 104, 30, 147, 11, 219, 241, 16, 47, 59,
    168, 174, 125, 143, 169, 247, 204, 38, 73, 125, 94, 230, 223, 159, 1, 201, 122, 108, 149, 36,
    81, 70, 97, 28, 198, 70, 64, 76, 62, 147, 80, 232, 157, 229, 144, 50, 250, 132, 36, 60, 115,
    205, 87, 71, 182, 62, 156, 138, 143, 228, 137, 185, 64, 9, 54, 97, 195, 41, 164, 53, 183, 118,
    74, 204, 222, 186, 211, 73, 114, 50, 246, 216, 16, 202, 221, 101, 79, 247, 138, 74, 44, 192,
    158, 50, 126, 0, 207, 254, 240, 210, 121, 212, 131, 219, 169, 12, 63, 157, 219, 167, 146, 222,
    75, 35, 125, 16, 158, 207, 39, 219, 64, 52, 68, 253, 168, 53, 255, 185, 205, 111, 247, 200, 86,
    156, 228, 238, 227, 51, 217, 118, 87, 182, 245, 233, 81, 61, 204, 17, 218, 175, 250, 171, 88,
    179, 83, 222, 114, 57, 189, 170, 126, 143, 153, 201, 108, 59, 27, 205, 154, 211, 208, 57, 103,
    25, 206, 179, 141, 251, 191, 231, 42, 219, 66, 70, 8, 65, 254, 251, 239, 34, 207, 245, 240, 254,
    228, 165, 238, 146, 245, 111, 8, 131, 71, 195, 16, 18, 185, 80, 149, 9, 149, 175, 102, 165, 67,
    144, 53, 76, 174, 81, 161, 73, 134, 251, 87, 185, 27, 229, 38, 21, 192, 190, 33, 6, 5, 85, 15,
    101, 151, 58, 198, 146, 178, 242, 52, 234, 217, 237, 161, 146, 87, 97, 145, 93, 169, 17, 67,
    187, 165, 1, 242, 74, 197, 189, 24, 121, 52, 41, 176, 70, 179, 112, 94, 9, 91, 236, 116, 214,
    111, 202, 204, 11, 246, 62, 247, 2, 25, 186, 120, 234, 242, 254, 242, 53, 11, 180, 239, 114,
    143, 91, 235, 1, 10, 232, 89, 247, 63, 207, 176, 205, 12, 95, 61, 127, 58, 237, 107, 73, 7, 28,
    45, 135, 36, 227, 186, 62, 199, 255, 82, 4, 70, 114, 123, 238, 196, 70, 180, 232, 49, 191, 211,
    17, 244, 47, 11, 218, 3, 124, 196, 147, 89, 230, 114, 168, 192, 209, 179, 242, 123, 126, 68,
    239, 36, 117, 32, 250, 94, 189, 68, 50, 27, 4, 7, 68, 187, 210, 206, 45, 44, 122, 251, 68, 18,
    33, 237, 70, 91, 162, 231, 167, 22, 203, 92, 212, 116, 30, 174, 240, 205, 161, 158, 151, 162,
    140, 209, 67, 141, 46, 72, 135, 164, 70, 101, 23, 132, 213, 164, 115, 191, 43, 62, 110, 4, 36,
    68, 237, 117, 7, 129, 223, 13, 51, 140, 94, 222, 246, 9, 252, 69, 167, 186, 53, 29, 255, 122,
    246, 249, 247, 189, 101, 63, 115, 188, 204, 131, 166, 125, 141, 244, 123, 186, 7, 134, 121, 28,
    255, 221, 121, 194, 200, 13, 123, 68, 3, 54, 219, 93, 117, 246, 3, 252, 132, 136, 185, 216, 25,
    27, 205, 0, 5, 54, 190, 133, 174, 224, 52, 174, 201, 253, 209, 158, 126, 117, 208, 224, 231,
    208, 71, 49, 28, 37, 180, 216, 56, 226, 142, 174, 96, 103, 238, 193, 39, 144, 18, 181, 51, 78,
    131, 196, 92, 63, 58, 101, 197, 199, 48, 107, 95, 120, 89, 88, 89, 87, 142, 234, 35, 38, 153,
    144, 151, 73, 75, 38, 57, 216, 126, 178, 67, 145, 69, 119, 172, 180, 203, 195, 226, 116, 164,
    146, 193, 130, 31, 194, 110, 181, 76, 70, 44, 212, 104, 64, 125, 0, 174, 79, 215, 192, 19, 184,
    126, 132, 139, 161, 50, 235, 199, 55, 212, 127, 110, 147, 255, 160, 143, 32, 57, 45, 78, 117,
    171, 35, 160, 145, 190, 2, 89, 96, 254, 254, 52, 25, 52, 162, 136, 25, 181, 212, 110, 34, 20,
    187, 29, 79, 59, 146, 105, 232, 157, 233, 0, 214, 163, 54, 255, 158, 214, 20, 225, 129, 101, 37,
    203, 37, 205, 4, 34, 65, 71, 32, 38, 235, 48, 254, 130, 129, 208, 202, 15, 218, 130, 217, 65,
    143, 101, 138, 86, 106, 113, 125, 117, 248, 89, 222, 75, 159, 108, 148, 139, 154, 115, 71, 67,
    164, 103, 86, 79, 232, 156, 61, 50, 149, 49, 68, 133, 143, 128, 32, 92, 246, 75, 139, 202, 1,
    152, 68, 24, 38, 43, 128, 60, 214, 145, 31, 6, 177, 228, 182, 53, 72, 31, 158, 111, 74, 91, 210,
    123, 143, 196, 161, 59, 195, 249, 19, 112, 180, 169, 108, 242, 219, 207, 216, 84, 148, 108, 74,
    251, 145, 40, 177, 122, 81, 119, 61, 29, 16, 54, 4, 172, 22, 110, 94, 71, 158, 250, 91, 132, 97,
    58, 47, 59, 102, 142, 145, 147, 150, 65, 17, 118, 216, 47, 172, 208, 245, 110, 69, 220, 255, 61,
    87, 233, 152, 50, 130, 0, 240, 225, 35, 140, 175, 211, 241, 64, 253, 75, 35, 30, 6, 101, 17, 64,
    30, 12, 138, 219, 210, 74, 235, 15, 211, 147, 189, 174, 245, 36, 222, 206, 158, 46, 2, 155, 89,
    0, 48, 234, 123, 30, 46, 183, 170, 114, 38, 33, 244, 197, 225, 245, 50, 138, 11, 147, 81, 122,
    27, 60, 0, 112, 61, 23, 135, 10, 205, 222, 238, 32, 4, 142, 201, 49, 75, 51, 182, 94, 143, 244,
    64, 154, 53, 37, 250, 47, 80, 18, 234, 225, 184, 64, 177, 82, 244, 191, 201, 232, 105, 186, 141,
    201, 140, 23, 143, 87, 129, 97, 95, 28, 223, 175, 1, 94, 48, 69, 72, 7, 203, 231, 233, 53, 94,
    42, 53, 30, 218, 171, 39, 166, 82, 224, 248, 53, 249, 33, 253, 81, 130, 162, 92, 98, 185, 107,
    244, 164, 45, 11, 29, 151, 14, 217, 247, 45, 30, 149, 164, 206, 182, 125, 207, 244, 255, 212,
    121, 94, 81, 111, 149, 73, 134, 22, 11, 67, 100, 231, 116, 123, 248, 231, 247, 127, 231, 118,
    154, 136, 148, 128, 208, 146, 57, 234, 230, 221, 221, 111, 26, 83, 163, 84, 180, 175, 48, 221,
    251, 102, 146, 14, 60, 178, 155, 74, 105, 144, 156, 128, 51, 178, 125, 54, 201, 20, 126, 168,
    84, 237, 138, 186, 201, 91, 235, 132, 202, 42, 93, 147, 168, 47, 60, 30, 52, 219, 42, 180, 188,
    112, 230, 214, 27, 242, 33, 95, 124, 79, 206, 91, 209, 107, 61, 224, 133, 14, 113, 123, 44, 238,
    99, 103, 188, 153, 78, 221, 243, 77, 252, 89, 28, 207, 106, 212, 29, 44, 43, 145, 234, 38, 139,
    61, 182, 181, 47, 149, 203, 185, 85, 5, 213, 241, 44, 218, 143, 199, 178, 224, 68, 48, 111, 199,
    114, 59, 252, 217, 225, 223, 201, 25, 250, 125, 30, 62, 84, 77, 234, 160, 85, 212, 189, 127, 83,
    139, 151, 225, 142, 61, 234, 14, 32, 231, 35, 43, 142, 58, 40, 147, 41, 160, 10, 120, 123, 167,
    70, 253, 151, 98, 109, 38, 107, 164, 90, 187, 2, 27, 127, 251, 44, 103, 67, 77, 57, 130, 96,
    167, 201, 117, 127, 71, 168, 16, 3, 75, 166, 5, 74, 129, 93, 73, 47, 15, 74, 133, 241, 223, 98,
    141, 7, 49, 137, 85, 120, 185, 141, 141, 215, 194, 60, 177, 55, 251, 251, 107, 248, 219, 78,
    241, 110, 124, 21, 59, 197, 248, 240, 44, 29, 96, 226, 62, 222, 148, 49, 78, 30, 208, 67, 133,
    241, 25, 100, 68, 105, 205, 126, 68, 113, 197, 173, 175, 249, 150, 4, 34, 100, 45, 95, 51, 132,
    107, 192, 129, 171, 54, 182, 9, 227, 200, 223, 115, 226, 124, 193, 61, 24, 101, 80, 9, 81, 29,
    79, 108, 24, 25, 76, 185, 170, 23, 183, 206, 37, 77, 157, 248, 152, 134, 0, 8, 138, 182, 149,
    37, 145, 215, 158, 208, 92, 123, 104, 89, 236, 89, 9, 182, 215, 2, 142, 72, 198, 42, 31, 178, 4,
    82, 112, 159, 161, 80, 148, 8, 113, 88, 93, 228, 73, 83, 14, 29, 1, 114, 199, 72, 37, 155, 117,
    105, 5, 56, 3, 217, 142, 177, 181, 97, 22, 55, 31, 238, 142, 176, 5, 49, 144, 77, 189, 83, 148,
    191, 98, 49, 130, 102, 42, 211, 174, 50, 114, 34, 83, 97, 1, 108, 166, 135, 165, 101, 54, 51,
    152, 42, 148, 6, 16, 83, 35, 200, 75, 218, 130, 148, 238, 146, 131, 94, 202, 98, 74, 240, 111,
    120, 16, 205, 109, 243, 64, 169, 65, 20, 51, 72, 67, 154, 197, 49, 189, 134, 206, 35, 74, 40,
    154, 20, 240, 3, 255, 226, 30, 157, 244, 180, 148, 134, 115, 228, 195, 245, 184, 37, 3, 82, 76,
    118, 166, 24, 247, 199, 41, 148, 100, 59, 123, 113, 192, 241, 235, 249, 54, 115, 130, 36, 178,
    154, 15, 32, 48, 197, 134, 83, 130, 28, 136, 197, 7, 62, 197, 158, 249, 222, 92, 3, 8, 169, 101,
    99, 42, 13, 193, 127, 124, 255, 221, 203, 96, 229, 25, 44, 129, 158, 191, 255, 62, 25, 196, 57,
    40, 43, 112, 199, 111, 229, 137, 103, 26, 173, 79, 184, 129, 240, 185, 87, 93, 206, 223, 122,
    254, 29, 226, 200, 248, 188, 217, 173, 81, 61, 247, 255, 187, 225, 53, 24, 9, 212, 40, 109, 234,
    243, 61, 160, 14, 1, 200, 84, 183, 71, 43, 112, 189, 91, 184, 255, 123, 190, 20, 58, 165, 16,
    50, 226, 239, 199, 235, 45, 116, 92, 44, 25, 255, 181, 8, 63, 9, 178, 34, 137, 234, 195, 32,
    248, 60, 164, 200, 72, 10, 125, 244, 54, 200, 73, 247, 149, 11, 15, 143, 99, 20, 53, 1, 42, 83,
    71, 219, 43, 41, 141, 108, 70, 229, 30, 85, 200, 177, 131, 98, 174, 31, 47, 93, 189, 250, 34, 8,
    9, 222, 177, 4, 26, 181, 29, 239, 135, 197, 203, 27, 249, 17, 210, 35, 129, 239, 236, 41, 44,
    53, 151, 47, 195, 96, 49, 169, 180, 243, 22, 210, 26, 124, 211, 231, 186, 42, 72, 78, 194, 221,
    67, 253, 234, 4, 118, 143, 240, 21, 141, 215, 117, 68, 98, 134, 96, 79, 223, 107, 8, 207, 116,
    175, 214, 139, 93, 24, 30, 171, 197, 235, 243, 24, 117, 179, 59, 46, 170, 177, 36, 180, 25, 88,
    125, 192, 132, 125, 197, 8, 250, 125, 35, 162, 252, 67, 200, 11, 187, 67, 213, 157, 127, 200,
    77, 255, 239, 19, 154, 253, 199, 118, 204, 184, 112, 24, 4, 242, 72, 178, 173, 242, 240, 220,
    232, 191, 103, 127, 114, 92, 23, 13, 57, 1, 8, 9, 151, 22, 86, 113, 31, 231, 147, 125, 139, 54,
    136, 13, 48, 181, 143, 205, 27, 225, 208, 239, 16, 16, 74, 215, 45, 65, 163, 140, 158, 53, 86,
    0, 6, 247, 242, 54, 232, 36, 24, 18, 44, 169, 189, 108, 22, 33, 5, 85, 56, 135, 161, 95, 68, 82,
    138, 249, 48, 203, 133, 58, 121, 170, 254, 85, 179, 71, 105, 243, 117, 62, 240, 247, 7, 166, 48,
    227, 59, 134, 138, 234, 235, 212, 181, 225, 131, 218, 129, 176, 220, 59, 74, 190, 244, 156, 92,
    236, 24, 227, 152, 157, 55, 8, 76, 102, 44, 70, 1, 20, 172, 236, 119, 138, 29, 145, 194, 146,
    160, 238, 170, 92, 98, 8, 245, 199, 129, 68, 250, 11, 127, 240, 131, 255, 124, 101, 155, 68, 71,
    29, 60, 225, 129, 48, 110, 42, 79, 215, 26, 120, 208, 205, 183, 211, 40, 60, 119, 5, 168, 168,
    147, 11, 15, 31, 191, 203, 52, 238, 241, 214, 112, 131, 133, 212, 198, 148, 235, 43, 245, 224,
    58, 122, 105, 8, 50, 94, 89, 172, 156, 239, 120, 173, 84, 185, 199, 224, 36, 75, 250, 131, 26,
    70, 150, 82, 76, 221, 234, 29, 47, 213, 54, 82, 170, 229, 164, 135, 187, 254, 73, 223, 185, 74,
    196, 9, 103, 253, 131, 95, 72, 102, 118, 115, 41, 155, 87, 16, 61, 82, 86, 95, 111, 166, 71, 88,
    16, 217, 12, 84, 10, 41, 213, 90, 176, 154, 141, 74, 75, 54, 88, 35, 116, 49, 0, 199, 84, 165,
    6, 167, 118, 188, 69, 48, 203, 148, 180, 2, 95, 241, 239, 136, 2, 124, 177, 217, 70, 69, 77,
    131, 244, 81, 140, 205, 56, 107, 0, 23, 36, 33, 255, 38, 79, 179, 204, 213, 100, 243, 141, 45,
    97, 69, 32, 112, 116, 22, 99, 136, 170, 251, 137, 170, 173, 58, 11, 98, 37, 66, 167, 81, 113,
    253, 33, 127, 149, 82, 154, 48, 102, 32, 131, 38, 16, 45, 204, 250, 247, 16, 147, 106, 160, 231,
    94, 153, 99, 228, 68, 139, 0, 1, 67, 164, 33, 248, 126, 67, 16, 108, 242, 1, 89, 214, 119, 55,
    105, 46, 227, 57, 192, 214, 149, 240, 53, 208, 85, 134, 20, 86, 182, 72, 34, 143, 39, 56, 171,
    195, 121, 185, 53, 121, 149, 114, 106, 146, 130, 168, 201, 16, 158, 80, 133, 69, 146, 171, 8,
    78, 109, 207, 165, 76, 207, 19, 113, 97, 213, 26, 134, 123, 55, 116, 168, 181, 25, 212, 193,
    140, 191, 211, 113, 179, 202, 66, 52, 11, 0, 104, 92, 14, 104, 16, 224, 4, 224, 184, 56, 74,
    170, 189, 98, 19, 101, 74, 180, 137, 156, 80, 88, 160, 130, 146, 201, 140, 42, 97, 193, 74, 165,
    129, 135, 137, 152, 36, 23, 124, 234, 107, 14, 184, 20, 163, 153, 144, 5, 17, 96, 107, 128, 3,
    97, 114, 216, 12, 124, 129, 112, 92, 37, 144, 6, 136, 104, 250, 32, 155, 229, 205, 36, 30, 105,
    54, 223, 27, 117, 229, 235, 22, 58, 137, 175, 37, 173, 202, 227, 162, 18, 123, 92, 75, 56, 252,
    46, 140, 97, 23, 18, 245, 104, 101, 141, 235, 93, 64, 251, 140, 169, 61, 20, 163, 198, 162, 138,
    127, 229, 64, 183, 28, 88, 73, 117, 220, 141, 43, 68, 80, 25, 235, 65, 139, 127, 225, 13, 53,
    217, 71, 119, 155, 189, 78, 68, 225, 25, 7, 2, 168, 203, 45, 167, 124, 254, 195, 182, 100, 64,
    14, 20, 3, 50, 194, 44, 110, 2, 214, 102, 180, 25, 91, 148, 208, 148, 68, 5, 254, 248, 142, 41,
    76, 166, 150, 30, 202, 15, 70, 208, 196, 65, 130, 179, 184, 31, 125, 255, 255, 252, 125, 63, 41,
    218, 184, 128, 201, 175, 255, 125, 3, 32, 128, 146, 129, 30, 228, 9, 121, 161, 130, 81, 62, 58,
    87, 188, 72, 137, 53, 89, 158, 228, 186, 67, 251, 159, 255, 251, 185, 23, 53, 102, 146, 21, 199,
    115, 242, 253, 231, 111, 156, 122, 128, 192, 216, 24, 50, 252, 235, 55, 53, 92, 226, 185, 185,
    140, 168, 154, 68, 171, 199, 215, 207, 251, 244, 164, 51, 52, 143, 114, 73, 206, 103, 139, 194,
    209, 125, 118, 224, 201, 48, 6, 148, 7, 17, 211, 252, 126, 212, 148, 81, 80, 65, 61, 223, 226,
    16, 84, 255, 232, 9, 231, 123, 223, 151, 74, 199, 148, 66, 70, 124, 24, 70, 156, 223, 139, 55,
    235, 213, 252, 143, 83, 253, 215, 220, 76, 225, 226, 0, 16, 252, 205, 173, 66, 36, 133, 90, 84,
    67, 247, 128, 230, 175, 150, 225, 102, 145, 24, 93, 35, 211, 238, 56, 171, 240, 224, 13, 244,
    233, 249, 244, 220, 5, 62, 108, 56, 21, 243, 29, 134, 85, 33, 122, 28, 92, 65, 140, 99, 223,
    189, 151, 40, 190, 164, 234, 115, 216, 6, 29, 73, 141, 155, 224, 212, 247, 90, 215, 52, 4, 74,
    162, 207, 100, 171, 182, 217, 248, 74, 161, 91, 107, 63, 240, 47, 133, 153, 156, 32, 44, 60, 94,
    121, 70, 166, 225, 255, 126, 22, 126, 142, 11, 195, 181, 42, 111, 10, 172, 199, 65, 239, 183,
    27, 70, 28, 102, 195, 204, 194, 28, 35, 250, 174, 249, 198, 55, 184, 42, 68, 72, 197, 212, 53,
    125, 36, 76, 206, 130, 212, 181, 33, 163, 40, 247, 55, 244, 163, 200, 177, 238, 122, 98, 123,
    127, 201, 178, 255, 24, 255, 181, 80, 131, 118, 36, 12, 210, 187, 45, 34, 55, 235, 253, 165,
    242, 63, 16, 254, 5, 66, 18, 48, 139, 153, 0, 7, 236, 86, 245, 15, 109, 191, 234, 226, 75, 200,
    57, 149, 66, 6, 224, 134, 26, 135, 215, 56, 200, 105, 110, 51, 96, 15, 180, 203, 59, 74, 161,
    61, 212, 233, 85, 172, 229, 240, 184, 81, 237, 114, 236, 136, 246, 204, 29, 109, 210, 192, 181,
    123, 84, 212, 160, 185, 61, 144, 142, 14, 218, 151, 251, 199, 107, 95, 57, 53, 83, 238, 255, 97,
    9, 82, 88, 195, 251, 2, 205, 246, 21, 105, 117, 88, 210, 211, 223, 36, 110, 144, 226, 122, 78,
    91, 173, 63, 98, 239, 250, 47, 114, 100, 96, 229, 192, 2, 150, 175, 10, 129, 118, 140, 221, 70,
    54, 13, 136, 63, 230, 149, 59, 16, 190, 68, 254, 29, 139, 248, 95, 164, 193, 159, 73, 203, 175,
    246, 50, 155, 77, 234, 200, 129, 3, 129, 17, 48, 130, 27, 77, 230, 123, 235, 63, 191, 203, 85,
    173, 39, 232, 242, 151, 212, 141, 128, 16, 169, 227, 143, 208, 220, 159, 62, 101, 41, 195, 102,
    145, 112, 170, 2, 62, 3, 214, 209, 28, 221, 142, 207, 114, 219, 134, 217, 139, 91, 62, 215, 68,
    34, 131, 22, 117, 100, 106, 22, 21, 219, 216, 42, 166, 164, 20, 77, 114, 213, 253, 184, 177, 49,
    205, 120, 66, 51, 151, 255, 47, 229, 71, 241, 157, 166, 14, 49, 7, 234, 109, 207, 186, 124, 136,
    6, 203, 216, 11, 251, 150, 158, 250, 242, 212, 56, 100, 190, 239, 173, 99, 79, 153, 232, 62,
    244, 170, 222, 131, 37, 29, 239, 65, 153, 6, 162, 60, 143, 248, 105, 91, 197, 88, 54, 239, 196,
    155, 196, 42, 80, 89, 97, 16, 234, 201, 223, 81, 16, 255, 223, 183, 221, 103, 11, 95, 238, 93,
    214, 3, 5, 122, 48, 98, 128, 116, 250, 241, 223, 203, 232, 200, 64, 155, 16, 120, 52, 145, 21,
    48, 240, 17, 91, 46, 254, 168, 252, 5, 143, 128, 131, 194, 94, 29, 37, 130, 154, 234, 209, 216,
    175, 121, 109, 102, 134, 2, 113, 51, 91, 162, 218, 153, 130, 134, 20, 181, 122, 144, 85, 42,
    186, 0, 211, 48, 42, 43, 140, 228, 75, 218, 120, 42, 14, 15, 237, 74, 153, 205, 230, 191, 155,
    15, 108, 61, 109, 128, 78, 169, 126, 235, 145, 109, 75, 233, 125, 116, 72, 43, 61, 210, 181, 65,
    38, 200, 179, 61, 50, 28, 91, 40, 229, 127, 10, 80, 155, 115, 213, 8, 116, 233, 40, 152, 58,
    170, 12, 40, 203, 105, 143, 26, 152, 57, 44, 253, 51, 56, 22, 67, 96, 197, 201, 191, 143, 70,
    230, 95, 86, 241, 188, 124, 96, 143, 244, 8, 247, 146, 139, 64, 10, 33, 197, 66, 222, 65, 130,
    94, 135, 37, 176, 167, 4, 210, 86, 177, 133, 29, 46, 3, 97, 184, 160, 245, 120, 100, 121, 199,
    142, 224, 14, 169, 23, 82, 240, 51, 223, 97, 84, 59, 100, 187, 0, 58, 135, 245, 56, 104, 16, 49,
    100, 59, 124, 143, 85, 220, 50, 98, 181, 5, 47, 85, 40, 38, 132, 14, 46, 72, 152, 94, 70, 124,
    97, 161, 87, 240, 145, 119, 74, 183, 220, 217, 131, 247, 251, 27, 93, 92, 150, 86, 88, 249, 191,
    47, 221, 148, 134, 157, 223, 226, 167, 207, 63, 194, 234, 12, 53, 104, 162, 133, 7, 143, 103,
    26, 28, 123, 220, 17, 184, 87, 213, 192, 200, 100, 16, 116, 46, 124, 41, 14, 95, 96, 201, 215,
    115, 158, 145, 223, 9, 11, 87, 0, 255, 145, 6, 164, 125, 197, 223, 115, 56, 188, 218, 45, 13, 6,
    140, 42, 220, 11, 199, 88, 2, 133, 140, 160, 32, 135, 197, 242, 169, 2, 201, 15, 2, 195, 96,
    120, 248, 208, 4, 235, 78, 211, 15, 58, 129, 56, 242, 5, 15, 58, 11, 234, 231, 14, 204, 87, 171,
    0, 180, 16, 65, 207, 193, 146, 130, 135, 86, 208, 115, 59, 12, 23, 39, 228, 59, 250, 131, 131,
    126, 214, 102, 180, 9, 85, 217, 45, 77, 47, 120, 200, 112, 157, 55, 29, 232, 5, 151, 135, 16,
    85, 64, 151, 99, 23, 11, 52, 21, 253, 248, 187, 99, 21, 169, 192, 211, 229, 131, 200, 90, 0,
    178, 147, 26, 248, 56, 155, 163, 72, 155, 132, 65, 52, 185, 151, 81, 202, 209, 163, 8, 200, 4,
    234, 168, 182, 18, 64, 2, 191, 196, 99, 15, 254, 13, 147, 70, 64, 146, 3, 42, 61, 24, 223, 134,
    128, 148, 147, 97, 193, 209, 125, 241, 106, 252, 67, 253, 114, 67, 5, 167, 32, 88, 0, 32, 47,
    82, 186, 222, 9, 87, 243, 101, 144, 105, 78, 210, 97, 52, 34, 67, 15, 238, 24, 181, 64, 127,
    252, 193, 10, 89, 24, 152, 177, 111, 252, 47, 127, 252, 206, 63, 71, 0, 171, 136, 238, 249, 239,
    191, 219, 136, 64, 224, 244, 4, 9, 81, 194, 38, 0, 161, 24, 133, 59, 52, 132, 210, 40, 144, 186,
    154, 133, 170, 153, 186, 253, 127, 252, 223, 255, 231, 254, 2, 106, 149, 156, 92, 100, 243, 229,
    243, 247, 122, 76, 62, 9, 91, 114, 247, 146, 179, 241, 191, 237, 63, 161, 28, 108, 4, 146, 164,
    21, 5, 116, 109, 254, 203, 241, 117, 250, 201, 80, 226, 12, 124, 36, 67, 124, 220, 234, 159,
    254, 246, 207, 157, 49, 28, 76, 94, 51, 197, 33, 37, 224, 63, 50, 98, 30, 72, 29, 239, 127, 183,
    18, 203, 11, 0
};

/* What all weights share: the closed form preetham_classes. */
static const unsigned short skylight_sh_7_bands_0_005pct_packed_short[60] = { 40453, 4971, 945, 105,
    24192, 2155, 420, 15, 1, 1787, 1463, 3554, 4275, 25, 3125, 227, 53251, 1206, 25771, 67, 3703, 5,
    275, 4214, 15346, 61, 897, 26756, 317, 4153, 667, 516, 26688, 7332, 4, 2125, 641, 8989, 33, 452,
    166, 2903, 11693, 375, 6377, 21196, 209, 3202, 6052, 394, 25886, 993, 7344, 79, 2102, 441,
    16537, 109, 529, 41556 };

#define SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_EARLY 16

static inline void skylight_sh_7_bands_0_005pct_packed_begin_factors(const
    skylight_sh_7_bands_0_005pct_packed_real *x, skylight_sh_7_bands_0_005pct_packed_real *early)
{
    const float chi = (0.888888896f - x[1] * 0.0166666675f) * (1.57079637f - x[0]);
    const float square = chi * chi;
    early[0] =
        ((skylight_sh_7_bands_0_005pct_packed_real)skylight_sh_7_bands_0_005pct_packed_short[2]) -
        square *
        (((skylight_sh_7_bands_0_005pct_packed_real)skylight_sh_7_bands_0_005pct_packed_short[6]) -
        ((skylight_sh_7_bands_0_005pct_packed_real)skylight_sh_7_bands_0_005pct_packed_short[7]) *
        square);
    early[1] = ((0.100000001f * skylight_sh_7_bands_0_005pct_packed_short[0]) * x[1] -
        ((skylight_sh_7_bands_0_005pct_packed_real)skylight_sh_7_bands_0_005pct_packed_short[1])) *
        (chi *
        (((skylight_sh_7_bands_0_005pct_packed_real)skylight_sh_7_bands_0_005pct_packed_short[2]) -
        square *
        (((skylight_sh_7_bands_0_005pct_packed_real)skylight_sh_7_bands_0_005pct_packed_short[3]) -
        square))) + ((0.100000001f * skylight_sh_7_bands_0_005pct_packed_short[4]) - (0.100000001f *
        skylight_sh_7_bands_0_005pct_packed_short[5]) * x[1]) * early[0];
    const float part_1 = (-9.99999975e-05f * skylight_sh_7_bands_0_005pct_packed_short[11]) * x[1] +
        (9.99999975e-05f * skylight_sh_7_bands_0_005pct_packed_short[12]);
    const float up =
        ((skylight_sh_7_bands_0_005pct_packed_real)skylight_sh_7_bands_0_005pct_packed_short[8]) +
        part_1 * ((0.00999999978f * skylight_sh_7_bands_0_005pct_packed_short[13]) + part_1 *
        (9.99999975e-06f * skylight_sh_7_bands_0_005pct_packed_short[14]));
    const float up2 = up * up;
    early[2] =
        ((skylight_sh_7_bands_0_005pct_packed_real)skylight_sh_7_bands_0_005pct_packed_short[8]) +
        ((9.99999975e-05f * skylight_sh_7_bands_0_005pct_packed_short[9]) * x[1] + (-0.00100000005f
        * skylight_sh_7_bands_0_005pct_packed_short[10])) * (up2 * up2);
    early[3] = (-9.99999975e-05f * skylight_sh_7_bands_0_005pct_packed_short[15]) * x[1] +
        (9.99999975e-05f * skylight_sh_7_bands_0_005pct_packed_short[16]);
    const float y = ((9.99999975e-05f * skylight_sh_7_bands_0_005pct_packed_short[17]) * x[1] +
        (-9.99999975e-05f * skylight_sh_7_bands_0_005pct_packed_short[18])) * x[0] * (0.00999999978f
        * skylight_sh_7_bands_0_005pct_packed_short[13]);
    const float halo = 1.0f + y * (0.99999845f + y * (0.499975085f + y * (0.166515172f + y *
        (0.0412233174f + y * (0.00765432511f + y * 0.000849007862f)))));
    early[4] = halo * halo;
    const float z = x[0] * x[0];
    const float cosine =
        ((skylight_sh_7_bands_0_005pct_packed_real)skylight_sh_7_bands_0_005pct_packed_short[8]) - z
        * ((0.100000001f * skylight_sh_7_bands_0_005pct_packed_short[21]) - z * (9.99999975e-06f *
        skylight_sh_7_bands_0_005pct_packed_short[14]));
    const float cosine2 = cosine * cosine;
    early[5] = ((-0.00100000005f * skylight_sh_7_bands_0_005pct_packed_short[19]) * x[1] +
        (9.99999975e-05f * skylight_sh_7_bands_0_005pct_packed_short[20])) * cosine2;
    early[6] = (((((9.99999975e-06f * skylight_sh_7_bands_0_005pct_packed_short[22]) * x[1] +
        (-9.99999975e-06f * skylight_sh_7_bands_0_005pct_packed_short[23])) * x[1] +
        (9.99999975e-06f * skylight_sh_7_bands_0_005pct_packed_short[24])) * x[0] +
        (((-9.99999975e-05f * skylight_sh_7_bands_0_005pct_packed_short[25]) * x[1] +
        (9.99999975e-05f * skylight_sh_7_bands_0_005pct_packed_short[26])) * x[1] +
        (-9.99999975e-06f * skylight_sh_7_bands_0_005pct_packed_short[27]))) * x[0] +
        (((9.99999975e-06f * skylight_sh_7_bands_0_005pct_packed_short[28]) * x[1] +
        (-9.99999975e-06f * skylight_sh_7_bands_0_005pct_packed_short[29])) * x[1] +
        (9.99999975e-05f * skylight_sh_7_bands_0_005pct_packed_short[30]))) * x[0] +
        ((9.99999975e-06f * skylight_sh_7_bands_0_005pct_packed_short[31]) * x[1] + (9.99999975e-06f
        * skylight_sh_7_bands_0_005pct_packed_short[32]));
    early[7] = (9.99999975e-05f * skylight_sh_7_bands_0_005pct_packed_short[13]) * x[1] +
        (9.99999975e-05f * skylight_sh_7_bands_0_005pct_packed_short[33]);
    early[8] = (-9.99999975e-05f * skylight_sh_7_bands_0_005pct_packed_short[34]) * x[1] +
        (9.99999975e-05f * skylight_sh_7_bands_0_005pct_packed_short[35]);
    const float y_2 = ((-9.99999975e-05f * skylight_sh_7_bands_0_005pct_packed_short[36]) * x[1] +
        (-9.99999975e-05f * skylight_sh_7_bands_0_005pct_packed_short[37])) * x[0] * (0.00999999978f
        * skylight_sh_7_bands_0_005pct_packed_short[13]);
    const float halo_2 = 1.0f + y_2 * (0.99999845f + y_2 * (0.499975085f + y_2 * (0.166515172f + y_2
        * (0.0412233174f + y_2 * (0.00765432511f + y_2 * 0.000849007862f)))));
    early[9] = halo_2 * halo_2;
    early[10] = ((-9.99999975e-05f * skylight_sh_7_bands_0_005pct_packed_short[38]) * x[1] +
        (9.99999975e-05f * skylight_sh_7_bands_0_005pct_packed_short[39])) * cosine2;
    early[11] = (((((9.99999975e-06f * skylight_sh_7_bands_0_005pct_packed_short[40]) * x[1] +
        (-9.99999975e-06f * skylight_sh_7_bands_0_005pct_packed_short[41])) * x[1] +
        (9.99999975e-06f * skylight_sh_7_bands_0_005pct_packed_short[42])) * x[0] +
        (((-9.99999975e-06f * skylight_sh_7_bands_0_005pct_packed_short[43]) * x[1] +
        (9.99999975e-06f * skylight_sh_7_bands_0_005pct_packed_short[44])) * x[1] +
        (-9.99999975e-06f * skylight_sh_7_bands_0_005pct_packed_short[45]))) * x[0] +
        (((9.99999975e-06f * skylight_sh_7_bands_0_005pct_packed_short[46]) * x[1] +
        (-9.99999975e-06f * skylight_sh_7_bands_0_005pct_packed_short[47])) * x[1] +
        (9.99999975e-06f * skylight_sh_7_bands_0_005pct_packed_short[48]))) * x[0] +
        ((9.99999975e-06f * skylight_sh_7_bands_0_005pct_packed_short[49]) * x[1] + (9.99999975e-06f
        * skylight_sh_7_bands_0_005pct_packed_short[50]));
    early[12] = (9.99999975e-06f * skylight_sh_7_bands_0_005pct_packed_short[51]) * x[1] +
        (9.99999975e-05f * skylight_sh_7_bands_0_005pct_packed_short[52]);
    early[13] = (-9.99999975e-05f * skylight_sh_7_bands_0_005pct_packed_short[53]) * x[1] +
        (9.99999975e-05f * skylight_sh_7_bands_0_005pct_packed_short[54]);
    const float y_3 = ((-9.99999975e-05f * skylight_sh_7_bands_0_005pct_packed_short[55]) * x[1] +
        (-9.99999975e-05f * skylight_sh_7_bands_0_005pct_packed_short[56])) * x[0] * (0.00999999978f
        * skylight_sh_7_bands_0_005pct_packed_short[13]);
    const float halo_3 = 1.0f + y_3 * (0.99999845f + y_3 * (0.499975085f + y_3 * (0.166515172f + y_3
        * (0.0412233174f + y_3 * (0.00765432511f + y_3 * 0.000849007862f)))));
    early[14] = halo_3 * halo_3;
    early[15] = ((-9.99999975e-05f * skylight_sh_7_bands_0_005pct_packed_short[57]) * x[1] +
        (9.99999975e-05f * skylight_sh_7_bands_0_005pct_packed_short[58])) * cosine2;
    (void)x;
    (void)early;
}

/* The rest of it. */
static inline void skylight_sh_7_bands_0_005pct_packed_end_factors(const
    skylight_sh_7_bands_0_005pct_packed_real *x,
    const skylight_sh_7_bands_0_005pct_packed_real *early,
    skylight_sh_7_bands_0_005pct_packed_real *out)
{
    const float halo4 = early[4] * early[4];
    const float shape_y = early[2] *
        (((skylight_sh_7_bands_0_005pct_packed_real)skylight_sh_7_bands_0_005pct_packed_short[8]) +
        early[3] * halo4 + early[5]);
    const float halo4_2 = early[9] * early[9];
    const float shape_x = early[7] *
        (((skylight_sh_7_bands_0_005pct_packed_real)skylight_sh_7_bands_0_005pct_packed_short[8]) +
        early[8] * halo4_2 + early[10]);
    const float one = early[1] / (early[0] * shape_y * early[6] * shape_x);
    const float halo4_3 = early[14] * early[14];
    const float shape_z = early[12] *
        (((skylight_sh_7_bands_0_005pct_packed_real)skylight_sh_7_bands_0_005pct_packed_short[8]) +
        early[13] * halo4_3 + early[15]);
    const float of_x = one * early[11] * shape_z;
    out[1] = 3.73898554f * of_x;
    const float of_y = one * early[6] * shape_x;
    const float of_s = one * shape_z * shape_x;
    out[2] = (-0.498531401f) * of_s;
    out[0] = out[1] + (-1.03860712f) * of_y + out[2];
    out[4] = (-1.01082206f) * of_x;
    out[5] = (9.99999997e-07f * skylight_sh_7_bands_0_005pct_packed_short[59]) * of_s;
    out[3] = out[4] + 1.83445477f * of_y + out[5];
    out[7] = (-1.00158179f) * of_x;
    out[8] = 1.05722523f * of_s;
    out[6] = out[7] + (-1.26125109f) * of_y + out[8];
    (void)x;
    (void)early;
}

/* The functions of sun_zenith (change of variable: even); 0 where there is
   none. */
static inline void skylight_sh_7_bands_0_005pct_packed_first(const
    skylight_sh_7_bands_0_005pct_packed_real *x, skylight_sh_7_bands_0_005pct_packed_real *out)
{
    out[0] = 1.0f;
    out[1] = (-13.3479729f) * (x[0] * x[0] - 0.0f) / ((-14.0f) - x[0] * x[0]) - 1.0f;
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
    out[12] = 2.0f * out[6] * out[6] - 1.0f;
    out[13] = 2.0f * out[6] * out[7] - out[1];
    out[14] = 0;
    out[15] = 0;
    (void)x;
}

/* All products of the functions of turbidity (change of variable:
   reciprocal). */
static inline void skylight_sh_7_bands_0_005pct_packed_others(const
    skylight_sh_7_bands_0_005pct_packed_real *x, skylight_sh_7_bands_0_005pct_packed_real *out)
{
    out[0] = 1.0f;
    out[1] = (-4.85714293f) * (x[1] - 2.5f) / ((-2.5f) - x[1]) - 1.0f;
    out[2] = 2.0f * out[1] * out[1] - 1.0f;
    out[3] = 2.0f * out[1] * out[2] - out[1];
    out[4] = 2.0f * out[2] * out[2] - 1.0f;
    out[5] = 2.0f * out[2] * out[3] - out[1];
    out[6] = 2.0f * out[3] * out[3] - 1.0f;
    out[7] = 2.0f * out[3] * out[4] - out[1];
    (void)x;
}

/* cos(m azimuth) and sin(m azimuth), m < bands, each times the m-th power
   of `radius`, by doubling. */
static inline void
    skylight_sh_7_bands_0_005pct_packed_waves(skylight_sh_7_bands_0_005pct_packed_real azimuth,
    skylight_sh_7_bands_0_005pct_packed_real radius,
    skylight_sh_7_bands_0_005pct_packed_real *cosines,
    skylight_sh_7_bands_0_005pct_packed_real *sines)
{
    cosines[0] = 1.0f;
    cosines[1] = radius * cosf(azimuth);
    sines[1] = radius * sinf(azimuth);
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

/* The sine of the sun's zenith angle, whose powers the sums of order m
   lack. */
static inline skylight_sh_7_bands_0_005pct_packed_real
    skylight_sh_7_bands_0_005pct_packed_sine(const skylight_sh_7_bands_0_005pct_packed_real *x)
{
    const float part_1 = x[SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_SUN] *
        x[SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_SUN];
    return x[SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_SUN] + x[SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_SUN] *
        (part_1 * ((-0.166666597f) + part_1 * (0.00833306555f + part_1 * ((-0.000198095426f) +
        part_1 * 2.60563934e-06f))));
}

/* The zonal window's factor for the degree `share` * bands (Habel et al.
   2008, eq. 5). */
static inline float skylight_sh_7_bands_0_005pct_packed_sinc(float share)
{
    const float x = 3.14159274f * share;
    return sinf(x) / x;
}

/* Of each axis: where its functions have slopes. */
static const double
    skylight_sh_7_bands_0_005pct_packed_slope_range[SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_AXES][2] = {
    { 0.0, 1.5707963267948966 }, { 2.5, 6.0 } };

/* The functions of an axis at v, and their slopes. */
static inline void skylight_sh_7_bands_0_005pct_packed_functions(int axis, double v, double *out,
    double *slopes)
{
    if (axis == 0) {
        out[0] = 1.0;
        const double part_1 = (-14.0) - v * v;
        const double part_2 = (-13.347972567941833) * (v * v - 0.0) / part_1;
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
        const double part_13 = 2.0 * out[6];
        out[12] = part_13 * out[6] - 1.0;
        const double part_14 = 2.0 * out[6];
        out[13] = part_14 * out[7] - out[1];
        slopes[0] = 0.0;
        slopes[1] = (-13.347972567941833) * (v + v) / part_1 - part_2 * -(v + v) / part_1;
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
        slopes[12] = 2.0 * slopes[6] * out[6] + part_13 * slopes[6];
        slopes[13] = 2.0 * slopes[6] * out[7] + part_14 * slopes[7] - slopes[1];
    }
    if (axis == 1) {
        out[0] = 1.0;
        const double part_1 = (-2.5) - v;
        const double part_2 = (-4.8571428571428568) * (v - 2.5) / part_1;
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
        slopes[1] = (-4.8571428571428568) / part_1 - part_2 * -1.0 / part_1;
        slopes[2] = 2.0 * slopes[1] * out[1] + part_3 * slopes[1];
        slopes[3] = 2.0 * slopes[1] * out[2] + part_4 * slopes[2] - slopes[1];
        slopes[4] = 2.0 * slopes[2] * out[2] + part_5 * slopes[2];
        slopes[5] = 2.0 * slopes[2] * out[3] + part_6 * slopes[3] - slopes[1];
        slopes[6] = 2.0 * slopes[3] * out[3] + part_7 * slopes[3];
        slopes[7] = 2.0 * slopes[3] * out[4] + part_8 * slopes[4] - slopes[1];
    }
    (void)v;
}

/* The factors, then their slopes after each axis. */
static inline void skylight_sh_7_bands_0_005pct_packed_factor_slopes(const double *x, double *out)
{
    const double part_1 = 4045.3000000000002 * x[1] - 4971.0;
    const double part_2 = 0.88888888888888884 - x[1] * 0.016666666666666666;
    const double part_3 = 1.5707963267948966 - x[0];
    const double chi = part_2 * part_3;
    const double square = chi * chi;
    const double part_4 = 105.0 - square;
    const double part_5 = 945.0 - square * part_4;
    const double part_6 = chi * part_5;
    const double part_7 = 2419.1999999999998 - 215.5 * x[1];
    const double part_8 = 420.0 - 15.0 * square;
    const double below = 945.0 - square * part_8;
    const double zenith = part_1 * part_6 + part_7 * below;
    const double part_9 = 0.1787 * x[1] + (-1.4630000000000001);
    const double part_10 = (-0.35539999999999999) * x[1] + 0.42749999999999999;
    const double part_11 = 0.25 + part_10 * 0.03125;
    const double up = 1.0 + part_10 * part_11;
    const double up2 = up * up;
    const double part_12 = up2 * up2;
    const double part_13 = 1.0 + part_9 * part_12;
    const double part_14 = (-0.022700000000000001) * x[1] + 5.3250999999999999;
    const double part_15 = 0.1206 * x[1] + (-2.5771000000000002);
    const double y = part_15 * x[0] * 0.25;
    const double part_16 = 0.0076543250999999996 + y * 0.00084900787100000003;
    const double part_17 = 0.041223317699999998 + y * part_16;
    const double part_18 = 0.16651516699999999 + y * part_17;
    const double part_19 = 0.49997509099999998 + y * part_18;
    const double part_20 = 0.99999845399999998 + y * part_19;
    const double halo = 0.99999998400000001 + y * part_20;
    const double halo2 = halo * halo;
    const double halo4 = halo2 * halo2;
    const double part_21 = (-0.067000000000000004) * x[1] + 0.37030000000000002;
    const double z = x[0] * x[0];
    const double part_22 = 0.5 - z * 0.03125;
    const double cosine = 1.0 - z * part_22;
    const double cosine2 = cosine * cosine;
    const double part_23 = 1.0 + part_14 * halo4 + part_21 * cosine2;
    const double shape_y = part_13 * part_23;
    const double part_24 = below * shape_y;
    const double part_25 = 0.0027499999999999998 * x[1] + (-0.042139999999999997);
    const double part_26 = part_25 * x[1] + 0.15346000000000001;
    const double part_27 = (-0.0061000000000000004) * x[1] + 0.089700000000000002;
    const double part_28 = part_26 * x[0] + (part_27 * x[1] + (-0.26756000000000002));
    const double part_29 = 0.0031700000000000001 * x[1] + (-0.041529999999999997);
    const double part_30 = part_28 * x[0] + (part_29 * x[1] + 0.066699999999999995);
    const double y_zenith = part_30 * x[0] + (0.0051599999999999997 * x[1] + 0.26688000000000001);
    const double part_31 = part_24 * y_zenith;
    const double part_32 = 0.0025000000000000001 * x[1] + 0.73319999999999996;
    const double part_33 = (-0.00040000000000000002) * x[1] + 0.21249999999999999;
    const double part_34 = (-0.064100000000000004) * x[1] + (-0.89890000000000003);
    const double y_2 = part_34 * x[0] * 0.25;
    const double part_35 = 0.0076543250999999996 + y_2 * 0.00084900787100000003;
    const double part_36 = 0.041223317699999998 + y_2 * part_35;
    const double part_37 = 0.16651516699999999 + y_2 * part_36;
    const double part_38 = 0.49997509099999998 + y_2 * part_37;
    const double part_39 = 0.99999845399999998 + y_2 * part_38;
    const double halo_2 = 0.99999998400000001 + y_2 * part_39;
    const double halo2_2 = halo_2 * halo_2;
    const double halo4_2 = halo2_2 * halo2_2;
    const double part_40 = (-0.0033) * x[1] + 0.045199999999999997;
    const double part_41 = 1.0 + part_33 * halo4_2 + part_40 * cosine2;
    const double shape_x = part_32 * part_41;
    const double part_42 = part_31 * shape_x;
    const double one = zenith / part_42;
    const double part_43 = 0.00166 * x[1] + (-0.02903);
    const double part_44 = part_43 * x[1] + 0.11693000000000001;
    const double part_45 = (-0.0037499999999999999) * x[1] + 0.063769999999999993;
    const double part_46 = part_44 * x[0] + (part_45 * x[1] + (-0.21196000000000001));
    const double part_47 = 0.0020899999999999998 * x[1] + (-0.03202);
    const double part_48 = part_46 * x[0] + (part_47 * x[1] + 0.060519999999999997);
    const double x_zenith = part_48 * x[0] + (0.0039399999999999999 * x[1] + 0.25885999999999998);
    const double part_49 = one * x_zenith;
    const double part_50 = 0.0099299999999999996 * x[1] + 0.73440000000000005;
    const double part_51 = (-0.0079000000000000008) * x[1] + 0.2102;
    const double part_52 = (-0.0441) * x[1] + (-1.6536999999999999);
    const double y_3 = part_52 * x[0] * 0.25;
    const double part_53 = 0.0076543250999999996 + y_3 * 0.00084900787100000003;
    const double part_54 = 0.041223317699999998 + y_3 * part_53;
    const double part_55 = 0.16651516699999999 + y_3 * part_54;
    const double part_56 = 0.49997509099999998 + y_3 * part_55;
    const double part_57 = 0.99999845399999998 + y_3 * part_56;
    const double halo_3 = 0.99999998400000001 + y_3 * part_57;
    const double halo2_3 = halo_3 * halo_3;
    const double halo4_3 = halo2_3 * halo2_3;
    const double part_58 = (-0.0109) * x[1] + 0.052900000000000003;
    const double part_59 = 1.0 + part_51 * halo4_3 + part_58 * cosine2;
    const double shape_z = part_50 * part_59;
    const double of_x = part_49 * shape_z;
    out[1] = 3.7389855999999999 * of_x;
    const double part_60 = one * y_zenith;
    const double of_y = part_60 * shape_x;
    const double part_61 = one * shape_z;
    const double of_s = part_61 * shape_x;
    out[2] = (-0.49853140000000001) * of_s;
    out[0] = out[1] + (-1.0386070999999999) * of_y + out[2];
    out[4] = (-1.0108219999999999) * of_x;
    out[5] = 0.041556000000000003 * of_s;
    out[3] = out[4] + 1.8344548000000001 * of_y + out[5];
    out[7] = (-1.0015818000000001) * of_x;
    out[8] = 1.0572252 * of_s;
    out[6] = out[7] + (-1.2612511) * of_y + out[8];
    const double part_62 = part_2 * -1.0;
    const double part_63 = part_62 * chi + chi * part_62;
    const double part_64 = -(part_63 * part_8 + square * -(15.0 * part_63));
    const double part_65 = part_15 * 0.25;
    const double part_66 = part_65 * part_20 + y * (part_65 * part_19 + y * (part_65 * part_18 + y *
        (part_65 * part_17 + y * (part_65 * part_16 + y * (part_65 * 0.00084900787100000003)))));
    const double part_67 = part_66 * halo + halo * part_66;
    const double part_68 = x[0] + x[0];
    const double part_69 = -(part_68 * part_22 + z * -(part_68 * 0.03125));
    const double part_70 = part_69 * cosine + cosine * part_69;
    const double part_71 = (part_26 * x[0] + part_28) * x[0] + part_30;
    const double part_72 = part_34 * 0.25;
    const double part_73 = part_72 * part_39 + y_2 * (part_72 * part_38 + y_2 * (part_72 * part_37 +
        y_2 * (part_72 * part_36 + y_2 * (part_72 * part_35 + y_2 * (part_72 *
        0.00084900787100000003)))));
    const double part_74 = part_73 * halo_2 + halo_2 * part_73;
    const double part_75 = part_32 * (part_33 * (part_74 * halo2_2 + halo2_2 * part_74) + part_40 *
        part_70);
    const double part_76 = (part_1 * (part_62 * part_5 + chi * -(part_63 * part_4 + square *
        -part_63)) + part_7 * part_64) / part_42 - one * (((part_64 * shape_y + below * (part_13 *
        (part_14 * (part_67 * halo2 + halo2 * part_67) + part_21 * part_70))) * y_zenith + part_24 *
        part_71) * shape_x + part_31 * part_75) / part_42;
    const double part_77 = part_52 * 0.25;
    const double part_78 = part_77 * part_57 + y_3 * (part_77 * part_56 + y_3 * (part_77 * part_55 +
        y_3 * (part_77 * part_54 + y_3 * (part_77 * part_53 + y_3 * (part_77 *
        0.00084900787100000003)))));
    const double part_79 = part_78 * halo_3 + halo_3 * part_78;
    const double part_80 = part_50 * (part_51 * (part_79 * halo2_3 + halo2_3 * part_79) + part_58 *
        part_70);
    const double part_81 = (part_76 * x_zenith + one * ((part_44 * x[0] + part_46) * x[0] +
        part_48)) * shape_z + part_49 * part_80;
    out[10] = 3.7389855999999999 * part_81;
    const double part_82 = (part_76 * y_zenith + one * part_71) * shape_x + part_60 * part_75;
    const double part_83 = (part_76 * shape_z + one * part_80) * shape_x + part_61 * part_75;
    out[11] = (-0.49853140000000001) * part_83;
    out[9] = out[10] + (-1.0386070999999999) * part_82 + out[11];
    out[13] = (-1.0108219999999999) * part_81;
    out[14] = 0.041556000000000003 * part_83;
    out[12] = out[13] + 1.8344548000000001 * part_82 + out[14];
    out[16] = (-1.0015818000000001) * part_81;
    out[17] = 1.0572252 * part_83;
    out[15] = out[16] + (-1.2612511) * part_82 + out[17];
    const double part_84 = -0.016666666666666666 * part_3;
    const double part_85 = part_84 * chi + chi * part_84;
    const double part_86 = -(part_85 * part_8 + square * -(15.0 * part_85));
    const double part_87 = (-0.35539999999999999) * part_11 + part_10 * ((-0.35539999999999999) *
        0.03125);
    const double part_88 = part_87 * up + up * part_87;
    const double part_89 = 0.1206 * x[0] * 0.25;
    const double part_90 = part_89 * part_20 + y * (part_89 * part_19 + y * (part_89 * part_18 + y *
        (part_89 * part_17 + y * (part_89 * part_16 + y * (part_89 * 0.00084900787100000003)))));
    const double part_91 = part_90 * halo + halo * part_90;
    const double part_92 = (((0.0027499999999999998 * x[1] + part_25) * x[0] +
        ((-0.0061000000000000004) * x[1] + part_27)) * x[0] + (0.0031700000000000001 * x[1] +
        part_29)) * x[0] + 0.0051599999999999997;
    const double part_93 = (-0.064100000000000004) * x[0] * 0.25;
    const double part_94 = part_93 * part_39 + y_2 * (part_93 * part_38 + y_2 * (part_93 * part_37 +
        y_2 * (part_93 * part_36 + y_2 * (part_93 * part_35 + y_2 * (part_93 *
        0.00084900787100000003)))));
    const double part_95 = part_94 * halo_2 + halo_2 * part_94;
    const double part_96 = 0.0025000000000000001 * part_41 + part_32 * ((-0.00040000000000000002) *
        halo4_2 + part_33 * (part_95 * halo2_2 + halo2_2 * part_95) + (-0.0033) * cosine2);
    const double part_97 = (4045.3000000000002 * part_6 + part_1 * (part_84 * part_5 + chi *
        -(part_85 * part_4 + square * -part_85)) + (-215.5 * below + part_7 * part_86)) / part_42 -
        one * (((part_86 * shape_y + below * ((0.1787 * part_12 + part_9 * (part_88 * up2 + up2 *
        part_88)) * part_23 + part_13 * ((-0.022700000000000001) * halo4 + part_14 * (part_91 *
        halo2 + halo2 * part_91) + (-0.067000000000000004) * cosine2))) * y_zenith + part_24 *
        part_92) * shape_x + part_31 * part_96) / part_42;
    const double part_98 = (-0.0441) * x[0] * 0.25;
    const double part_99 = part_98 * part_57 + y_3 * (part_98 * part_56 + y_3 * (part_98 * part_55 +
        y_3 * (part_98 * part_54 + y_3 * (part_98 * part_53 + y_3 * (part_98 *
        0.00084900787100000003)))));
    const double part_100 = part_99 * halo_3 + halo_3 * part_99;
    const double part_101 = 0.0099299999999999996 * part_59 + part_50 * ((-0.0079000000000000008) *
        halo4_3 + part_51 * (part_100 * halo2_3 + halo2_3 * part_100) + (-0.0109) * cosine2);
    const double part_102 = (part_97 * x_zenith + one * ((((0.00166 * x[1] + part_43) * x[0] +
        ((-0.0037499999999999999) * x[1] + part_45)) * x[0] + (0.0020899999999999998 * x[1] +
        part_47)) * x[0] + 0.0039399999999999999)) * shape_z + part_49 * part_101;
    out[19] = 3.7389855999999999 * part_102;
    const double part_103 = (part_97 * y_zenith + one * part_92) * shape_x + part_60 * part_96;
    const double part_104 = (part_97 * shape_z + one * part_101) * shape_x + part_61 * part_96;
    out[20] = (-0.49853140000000001) * part_104;
    out[18] = out[19] + (-1.0386070999999999) * part_103 + out[20];
    out[22] = (-1.0108219999999999) * part_102;
    out[23] = 0.041556000000000003 * part_104;
    out[21] = out[22] + 1.8344548000000001 * part_103 + out[23];
    out[25] = (-1.0015818000000001) * part_102;
    out[26] = 1.0572252 * part_104;
    out[24] = out[25] + (-1.2612511) * part_103 + out[26];
    (void)x;
}

/* The sine of the sun's zenith angle, then its slope. */
static inline void skylight_sh_7_bands_0_005pct_packed_sine_slope(const double *x, double *out)
{
    out[0] = sin(x[SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_SUN]);
    out[1] = cos(x[SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_SUN]);
}

/* 0 for a finite number, 1 for an infinity, 2 for NaN: by its bits, so that -ffast-math cannot
   remove the test. */
static inline int skylight_sh_7_bands_0_005pct_packed_kind(float v)
{
    uint32_t bits;
    memcpy(&bits, &v, sizeof bits);
    bits &= 0x7fffffffu;
    return (bits >= 0x7f800000u) + (bits > 0x7f800000u);
}

/* A number that is no NaN, finite: an infinity becomes a large number of its sign. */
static inline float skylight_sh_7_bands_0_005pct_packed_finite(float v)
{
    if (skylight_sh_7_bands_0_005pct_packed_kind(v)) {
        uint32_t bits;
        memcpy(&bits, &v, sizeof bits);
        v = bits >> 31 ? -3e38f : 3e38f;
    }
    return v;
}

/* Clamps the axes' inputs into x. Returns the status: 0; 1 where one was not inside; 2, and nothing
   in x, where one is NaN or the azimuth no finite number. */
static inline int skylight_sh_7_bands_0_005pct_packed_inputs(const float
    inputs[SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_AXES], float azimuth,
                                     skylight_sh_7_bands_0_005pct_packed_real
                                         x[SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_AXES])
{
    int axis, status = 0, strange = skylight_sh_7_bands_0_005pct_packed_kind(azimuth) ? 2 : 0;
    for (axis = 0; axis < SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_AXES; ++axis) strange |=
        skylight_sh_7_bands_0_005pct_packed_kind(inputs[axis]);
    if (strange & 2) return 2;
    for (axis = 0; axis < SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_AXES; ++axis) {
        const float v = skylight_sh_7_bands_0_005pct_packed_finite(inputs[axis]);
        const skylight_sh_7_bands_0_005pct_packed_real low =
            skylight_sh_7_bands_0_005pct_packed_range[axis][0],
            high = skylight_sh_7_bands_0_005pct_packed_range[axis][1];
        const skylight_sh_7_bands_0_005pct_packed_real at_least =
            (skylight_sh_7_bands_0_005pct_packed_real)v < low ? low :
            (skylight_sh_7_bands_0_005pct_packed_real)v;
        status |= (v < skylight_sh_7_bands_0_005pct_packed_inside[axis][0]) | (v >
            skylight_sh_7_bands_0_005pct_packed_inside[axis][1]);
        x[axis] = at_least > high ? high : at_least;
    }
    return status;
}

/* Numbers side by side where the compiler has vector types: as many as the processor's registers
   hold, and four. */
#if defined(__GNUC__) && (defined(__SSE__) || defined(__ARM_NEON) || defined(__ALTIVEC__) || \
                          defined(__wasm_simd128__) || defined(__loongarch_sx))
#if defined(__AVX512F__)
#define SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_LANES 16
#elif defined(__AVX__)
#define SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_LANES 8
#else
#define SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_LANES 4
#endif
#endif
/* What is worth its place in every caller. */
#ifdef __GNUC__
#define SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_INLINE static inline __attribute__((always_inline))
#else
#define SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_INLINE static inline
#endif
#ifdef SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_LANES
#ifdef __FMA__
/* One operation for a product and a sum, which standard C may not choose by itself. */
#include <immintrin.h>
#endif
typedef float skylight_sh_7_bands_0_005pct_packed_lanes __attribute__((vector_size(4 *
    SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_LANES)));
typedef float skylight_sh_7_bands_0_005pct_packed_four __attribute__((vector_size(16)));
typedef int skylight_sh_7_bands_0_005pct_packed_order __attribute__((vector_size(16)));

/* The same number in all places: v - 0 is v, which 0 + v need not be. */
static inline skylight_sh_7_bands_0_005pct_packed_lanes
    skylight_sh_7_bands_0_005pct_packed_spread(float v)
{
    const skylight_sh_7_bands_0_005pct_packed_lanes zeros = {0};
    return v - zeros;
}

static inline skylight_sh_7_bands_0_005pct_packed_lanes
    skylight_sh_7_bands_0_005pct_packed_load(const float *from)
{
    skylight_sh_7_bands_0_005pct_packed_lanes v;
    memcpy(&v, from, sizeof v);
    return v;
}

/* a * b + c. */
static inline skylight_sh_7_bands_0_005pct_packed_lanes
    skylight_sh_7_bands_0_005pct_packed_add(skylight_sh_7_bands_0_005pct_packed_lanes a,
    skylight_sh_7_bands_0_005pct_packed_lanes b,
                                                skylight_sh_7_bands_0_005pct_packed_lanes c)
{
#if defined(__FMA__) && SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_LANES == 16
    return _mm512_fmadd_ps(a, b, c);
#elif defined(__FMA__) && SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_LANES == 8
    return _mm256_fmadd_ps(a, b, c);
#else
    return a * b + c;
#endif
}

static inline skylight_sh_7_bands_0_005pct_packed_four
    skylight_sh_7_bands_0_005pct_packed_spread_four(float v)
{
    const skylight_sh_7_bands_0_005pct_packed_four zeros = {0};
    return v - zeros;
}

static inline skylight_sh_7_bands_0_005pct_packed_four
    skylight_sh_7_bands_0_005pct_packed_load_four(const float *from)
{
    skylight_sh_7_bands_0_005pct_packed_four v;
    memcpy(&v, from, sizeof v);
    return v;
}

static inline skylight_sh_7_bands_0_005pct_packed_four
    skylight_sh_7_bands_0_005pct_packed_add_four(skylight_sh_7_bands_0_005pct_packed_four a,
    skylight_sh_7_bands_0_005pct_packed_four b,
                                                    skylight_sh_7_bands_0_005pct_packed_four c)
{
#ifdef __FMA__
    return _mm_fmadd_ps(a, b, c);
#else
    return a * b + c;
#endif
}

static inline void skylight_sh_7_bands_0_005pct_packed_keep(float *to,
    skylight_sh_7_bands_0_005pct_packed_four v)
{
    memcpy(to, &v, sizeof v);
}

/* Four of the eight numbers of two vectors. */
#ifdef __clang__
#define SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_PICK(v, w, a, b, c, d) __builtin_shufflevector(v, w, \
    a, b, c, d)
#else
#define SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_PICK(v, w, a, b, c, d) \
    skylight_sh_7_bands_0_005pct_packed_pick(v, w, a, b, c, d)
static inline skylight_sh_7_bands_0_005pct_packed_four
    skylight_sh_7_bands_0_005pct_packed_pick(skylight_sh_7_bands_0_005pct_packed_four v,
    skylight_sh_7_bands_0_005pct_packed_four w, int a,
                                                int b, int c, int d)
{
    const skylight_sh_7_bands_0_005pct_packed_order order = {a, b, c, d};
    return __builtin_shuffle(v, w, order);
}
#endif
#endif

/* One channel's sums, from those of its classes. */
static inline void skylight_sh_7_bands_0_005pct_packed_mix(skylight_sh_7_bands_0_005pct_packed_real
    sums[SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_CLASSES][SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_ROOM],
                                   int channel,
                                       const skylight_sh_7_bands_0_005pct_packed_real *factors,
                                   skylight_sh_7_bands_0_005pct_packed_real *mixed)
{
    int i;
    int k;
    for (i = 0; i < SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_WIDTH; ++i)
        mixed[i] = factors[channel * SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_CLASSES] * sums[0][i];
    for (k = 1; k < SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_CLASSES; ++k)
        for (i = 0; i < SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_WIDTH; ++i)
            mixed[i] += factors[channel * SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_CLASSES + k] *
                sums[k][i];
}

/* Orders m >= 0 alone are stored: those of a light that is even in y at azimuth 0. */
#define SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_FIRST_ORDER(l) 0

/* Stores one weight of degree l and order m turned by the azimuth. */
static inline void
    skylight_sh_7_bands_0_005pct_packed_place(skylight_sh_7_bands_0_005pct_packed_real value, int l,
    int m,
                                     const skylight_sh_7_bands_0_005pct_packed_real *cosines,
                                         const skylight_sh_7_bands_0_005pct_packed_real *sines,
                                     float *weights)
{
    weights[l * (l + 1) - m] = (float)(value * sines[m]);
    weights[l * (l + 1) + m] = (float)(value * cosines[m]);
}

/* Stores the first `bands` bands of the channels' weights, turned by the azimuth (Habel et al.
 * 2008,
   eq. 4 with nothing for m < 0). */
static inline void skylight_sh_7_bands_0_005pct_packed_store(
    skylight_sh_7_bands_0_005pct_packed_real
        sums[SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_CLASSES][SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_ROOM],
        const skylight_sh_7_bands_0_005pct_packed_real *factors,
    const skylight_sh_7_bands_0_005pct_packed_real *cosines,
        const skylight_sh_7_bands_0_005pct_packed_real *sines, int bands,
    float
        weights[SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_CHANNELS]
        [SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_WEIGHTS])
{
    int channel;
#if defined(SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_LANES) && \
    SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_BANDS > 3
    /* In fours; each overshoot is overwritten by what follows. */
    float plus[SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_BANDS],
        minus[SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_BANDS + 3] = {0};
    int m, q;
    for (m = 0; m < SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_BANDS; ++m) {
        plus[m] = cosines[m];
        minus[SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_BANDS - 1 - m] = sines[m];
    }
    for (channel = 0; channel < SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_CHANNELS; ++channel) {
        float *const w = weights[channel];
        skylight_sh_7_bands_0_005pct_packed_four v[SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_FOURS];
        for (q = 0; q < SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_FOURS; ++q) {
            int k;
            v[q] = factors[channel * SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_CLASSES] *
                skylight_sh_7_bands_0_005pct_packed_load_four(sums[0] + 4 * q);
            for (k = 1; k < SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_CLASSES; ++k)
                v[q] = skylight_sh_7_bands_0_005pct_packed_add_four(
                    skylight_sh_7_bands_0_005pct_packed_spread_four(factors[channel *
                        SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_CLASSES + k]),
                    skylight_sh_7_bands_0_005pct_packed_load_four(sums[k] + 4 * q), v[q]);
        }
#define SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_BAND(l, stores) \
    if (bands > (l)) { stores }
#define SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_NOTHING(place, count) memset(w + (place), 0, \
    sizeof(float) * (count));
#define SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_MINUS(place, q, r, a, b, c, d, order) \
    skylight_sh_7_bands_0_005pct_packed_keep(w + (place), \
                     SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_PICK(v[q], v[r], a, b, c, d) * \
                         skylight_sh_7_bands_0_005pct_packed_load_four(minus + \
                             SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_BANDS - 1 - (order)));
#define SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_PLUS(place, q, r, a, b, c, d, order) \
    skylight_sh_7_bands_0_005pct_packed_keep(w + (place), \
        SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_PICK(v[q], v[r], a, b, c, d) * \
                                      skylight_sh_7_bands_0_005pct_packed_load_four(plus + \
                                          (order)));
        SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_STORES(SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_BAND,
            SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_NOTHING, SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_MINUS,
                           SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_PLUS)
#undef SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_BAND
#undef SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_NOTHING
#undef SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_MINUS
#undef SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_PLUS
    }
#else
    static const short columns[SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_BANDS] =
        SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_COLUMNS;
    for (channel = 0; channel < SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_CHANNELS; ++channel) {
        skylight_sh_7_bands_0_005pct_packed_real v[SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_WIDTH];
        int l, m;
        skylight_sh_7_bands_0_005pct_packed_mix(sums, channel, factors, v);
        for (l = 0; l < bands; ++l) {
            float *const w = weights[channel] + l * (l + 1);
            const int column = columns[l];
            for (m = 1; m <= l; ++m)
                w[-m] = column < 0 ? 0.0f : (float)(v[column + m] * sines[m]);
            for (m = 0; m <= l; ++m)
                w[m] = column < 0 ? 0.0f : (float)(v[column + m] * cosines[m]);
        }
    }
#endif
    (void)cosines;
    (void)sines;
}

#ifdef SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_LANES

/* Vectors that the first `count` numbers of a row take, and those that are summed at once, in
   registers. */
#define SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_VECTORS(count) (((count) + \
    SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_LANES - 1) / SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_LANES)
#define SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_BLOCKS \
    ((SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_VECTORS(SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_WIDTH) + 6) \
    / 7)
#define SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_BLOCK \
    ((SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_VECTORS(SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_WIDTH) + \
        SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_BLOCKS - 1) / \
        SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_BLOCKS)
#endif

/* The products of the functions of all axes, of one class in the order of its rows. */
static inline void skylight_sh_7_bands_0_005pct_packed_multiply(int class_,
    const skylight_sh_7_bands_0_005pct_packed_real *first,
                                        const skylight_sh_7_bands_0_005pct_packed_real *others,
                                            skylight_sh_7_bands_0_005pct_packed_real *products)
{
    int i;
#ifdef SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_LANES
    /* In fours: each overshoot is overwritten by the next line. */
#define SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_PRODUCT(which, place, count, other) \
    for (i = 0; i < (count) && class_ == (which); i += 4) \
        skylight_sh_7_bands_0_005pct_packed_keep(products + (place) + i, \
                         skylight_sh_7_bands_0_005pct_packed_load_four(first + i) * others[other]);
#else
#define SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_PRODUCT(which, place, count, other) \
    for (i = 0; i < (count) && class_ == (which); ++i) products[(place) + i] = first[i] * \
        others[other];
#endif
    SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_PRODUCTS(SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_PRODUCT)
#undef SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_PRODUCT
}
#ifdef SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_LANES

/* Rows whose sums run side by side, so that no sum waits for the one before. */
#define SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_SIDE (SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_BLOCK > 4 ? \
    1 : SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_BLOCK > 2 ? 2 : 4)

/* sums = sum over t of products[t] * row t: SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_BLOCK vectors of
 * each row, which stay in
   registers. */
static inline void skylight_sh_7_bands_0_005pct_packed_sum_block(const
    skylight_sh_7_bands_0_005pct_packed_real *row, int terms,
                                         const skylight_sh_7_bands_0_005pct_packed_real *products,
                                             skylight_sh_7_bands_0_005pct_packed_real *sums)
{
    skylight_sh_7_bands_0_005pct_packed_lanes
        total[SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_SIDE][SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_BLOCK];
    int t, i, k;
    for (i = 0; i < SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_SIDE; ++i)
        for (k = 0; k < SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_BLOCK; ++k) total[i][k] =
            skylight_sh_7_bands_0_005pct_packed_spread(0);
    for (t = 0; t + SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_SIDE <= terms; t +=
        SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_SIDE) {
        for (i = 0; i < SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_SIDE; ++i) {
            const skylight_sh_7_bands_0_005pct_packed_lanes product =
                skylight_sh_7_bands_0_005pct_packed_spread(products[t + i]);
            for (k = 0; k < SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_BLOCK; ++k)
                total[i][k] = skylight_sh_7_bands_0_005pct_packed_add(
                    product, skylight_sh_7_bands_0_005pct_packed_load(row + i *
                        SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_WIDTH + k *
                        SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_LANES),
                    total[i][k]);
        }
        row += SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_SIDE * SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_WIDTH;
    }
    for (; t < terms; ++t) {
        const skylight_sh_7_bands_0_005pct_packed_lanes product =
            skylight_sh_7_bands_0_005pct_packed_spread(products[t]);
        for (k = 0; k < SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_BLOCK; ++k)
            total[0][k] = skylight_sh_7_bands_0_005pct_packed_add(product,
                skylight_sh_7_bands_0_005pct_packed_load(row + k *
                SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_LANES),
                                          total[0][k]);
        row += SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_WIDTH;
    }
    for (k = 0; k < SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_BLOCK; ++k) {
        for (i = 1; i < SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_SIDE; ++i) total[0][k] += total[i][k];
        memcpy(sums + k * SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_LANES, &total[0][k],
            sizeof total[0][k]);
    }
}

/* The same for one vector of each row. */
static inline void skylight_sh_7_bands_0_005pct_packed_sum_vector(const
    skylight_sh_7_bands_0_005pct_packed_real *row, int terms,
                                          const skylight_sh_7_bands_0_005pct_packed_real *products,
                                              skylight_sh_7_bands_0_005pct_packed_real *sums)
{
    skylight_sh_7_bands_0_005pct_packed_lanes total = skylight_sh_7_bands_0_005pct_packed_spread(0),
        other = skylight_sh_7_bands_0_005pct_packed_spread(0);
    int t;
    for (t = 0; t + 2 <= terms; t += 2) {
        total =
            skylight_sh_7_bands_0_005pct_packed_add(skylight_sh_7_bands_0_005pct_packed_spread(
            products[t]), skylight_sh_7_bands_0_005pct_packed_load(row), total);
        other =
            skylight_sh_7_bands_0_005pct_packed_add(skylight_sh_7_bands_0_005pct_packed_spread(
            products[t + 1]),
                                skylight_sh_7_bands_0_005pct_packed_load(row +
                                    SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_WIDTH), other);
        row += 2 * SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_WIDTH;
    }
    if (t < terms)
        total =
            skylight_sh_7_bands_0_005pct_packed_add(skylight_sh_7_bands_0_005pct_packed_spread(
            products[t]), skylight_sh_7_bands_0_005pct_packed_load(row), total);
    total += other;
    memcpy(sums, &total, sizeof total);
}

/* The first `count` numbers of the sum over t of products[t] * row t. */
static inline void skylight_sh_7_bands_0_005pct_packed_sum(const
    skylight_sh_7_bands_0_005pct_packed_real *row, int terms,
                                   const skylight_sh_7_bands_0_005pct_packed_real *products,
                                       int count,
                                   skylight_sh_7_bands_0_005pct_packed_real *sums)
{
    const int vectors = SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_VECTORS(count);
    int k = 0;
    if (vectors >= SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_BLOCK) {
        for (; k + SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_BLOCK <= vectors; k +=
            SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_BLOCK)
            skylight_sh_7_bands_0_005pct_packed_sum_block(row + k *
                SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_LANES, terms, products,
                                  sums + k * SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_LANES);
    }
    for (; k < vectors; ++k)
        skylight_sh_7_bands_0_005pct_packed_sum_vector(row + k *
            SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_LANES, terms, products,
                               sums + k * SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_LANES);
}
#else

/* The first `count` numbers of the sum over t of products[t] * row t, four rows a pass: no
   reduction, so that it vectorises. */
static inline void skylight_sh_7_bands_0_005pct_packed_sum(const
    skylight_sh_7_bands_0_005pct_packed_real *row, int terms,
                                   const skylight_sh_7_bands_0_005pct_packed_real *products,
                                       int count,
                                   skylight_sh_7_bands_0_005pct_packed_real *sums)
{
    int t, k;
    for (k = 0; k < SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_ROOM; ++k) sums[k] = 0;
    for (t = 0; t + 4 <= terms; t += 4) {
        const skylight_sh_7_bands_0_005pct_packed_real a = products[t], b = products[t + 1];
        const skylight_sh_7_bands_0_005pct_packed_real c = products[t + 2], d = products[t + 3];
        for (k = 0; k < count; ++k)
            sums[k] += (a * row[k] + b * row[k + SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_WIDTH]) +
                       (c * row[k + 2 * SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_WIDTH] + d * row[k + 3 *
                           SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_WIDTH]);
        row += 4 * SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_WIDTH;
    }
    for (; t < terms; ++t) {
        for (k = 0; k < count; ++k) sums[k] += products[t] * row[k];
        row += SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_WIDTH;
    }
}
#endif

/* The sums of one class's rows, one a term, for the first `bands` bands. */
static inline void skylight_sh_7_bands_0_005pct_packed_sum_class(const
    skylight_sh_7_bands_0_005pct_packed_real *rows, int class_,
                                         const skylight_sh_7_bands_0_005pct_packed_real *first,
                                         const skylight_sh_7_bands_0_005pct_packed_real *others,
                                             int bands,
                                         skylight_sh_7_bands_0_005pct_packed_real *sums)
{
    static const unsigned short starts[SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_CLASSES] =
        SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_STARTS;
    static const unsigned short counts[SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_CLASSES] =
        SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_COUNTS;
    static const unsigned short places[SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_CLASSES] =
        SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_PLACES;
    static const unsigned short widths[SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_BANDS] =
        SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_WIDTHS;
    const skylight_sh_7_bands_0_005pct_packed_real *const row = rows + (int)starts[class_] *
        SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_WIDTH;
    skylight_sh_7_bands_0_005pct_packed_real
        products[SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_PRODUCTS_ROOM];
    skylight_sh_7_bands_0_005pct_packed_multiply(class_, first, others, products);
    if (bands == SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_BANDS) {
        skylight_sh_7_bands_0_005pct_packed_sum(row, counts[class_], products + places[class_],
            SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_WIDTH, sums);
    } else {
        memset(sums, 0, sizeof *sums * SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_ROOM);
        skylight_sh_7_bands_0_005pct_packed_sum(row, counts[class_], products + places[class_],
            widths[bands - 1], sums);
    }
}

/* The same in double precision, all bands: what derivatives need, whose terms cancel. */
static inline void skylight_sh_7_bands_0_005pct_packed_sum_rows_double(
    const skylight_sh_7_bands_0_005pct_packed_real *rows, const double *first, const double *others,
    double
        sums[SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_CLASSES]
        [SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_WIDTH])
{
    static const unsigned char
        lengths[SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_CLASSES]
        [SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_OTHERS] = SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_LENGTHS;
    int c, i, k, other;
    for (c = 0; c < SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_CLASSES; ++c) {
        for (k = 0; k < SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_WIDTH; ++k) sums[c][k] = 0.0;
        for (other = 0; other < SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_OTHERS; ++other) {
            for (i = 0; i < (int)lengths[c][other]; ++i) {
                const double product = first[i] * others[other];
                for (k = 0; k < SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_WIDTH; ++k) sums[c][k] +=
                    product * (double)rows[k];
                rows += SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_WIDTH;
            }
        }
    }
}

/* Reads the stream: whole numbers as Rice codes, low bit of each byte first. */
typedef struct {
    const unsigned char *next;
    uint64_t held;
    int count;
} skylight_sh_7_bands_0_005pct_packed_bits;

static inline void skylight_sh_7_bands_0_005pct_packed_fill(skylight_sh_7_bands_0_005pct_packed_bits
    *b)
{
    const unsigned char *const end = skylight_sh_7_bands_0_005pct_packed_stream + sizeof
        skylight_sh_7_bands_0_005pct_packed_stream;
    /* At most 63 bits, so that there is a zero above them. */
    while (b->count < 56 && b->next < end) {
        b->held |= (uint64_t)*b->next++ << b->count;
        b->count += 8;
    }
}

/* `width` bits, at most 31, as a number. */
static inline unsigned
    skylight_sh_7_bands_0_005pct_packed_fixed(skylight_sh_7_bands_0_005pct_packed_bits *b,
    int width)
{
    unsigned value;
    if (b->count < 32) skylight_sh_7_bands_0_005pct_packed_fill(b);
    value = (unsigned)(b->held & ((UINT64_C(1) << width) - 1));
    b->held >>= width;
    b->count -= width;
    return value;
}

/* How many ones stand before the first zero, from the low end; what is held has a zero. */
static inline int skylight_sh_7_bands_0_005pct_packed_ones(uint64_t held)
{
#ifdef __GNUC__
    return __builtin_ctzll(~(unsigned long long)held);
#else
    int ones = 0;
    for (; held & 1; held >>= 1) ++ones;
    return ones;
#endif
}

/* A Rice code of `low` low bits: ones, a zero, the low bits; then folded back: 0, 1, 2, 3 -> 0, -1,
   1, -2. */
static inline int skylight_sh_7_bands_0_005pct_packed_rice(skylight_sh_7_bands_0_005pct_packed_bits
    *b, int low)
{
    unsigned high = 0, folded;
    int ones;
    if (b->count < 32) skylight_sh_7_bands_0_005pct_packed_fill(b);
    while ((ones = skylight_sh_7_bands_0_005pct_packed_ones(b->held)) >= b->count) {
        high += (unsigned)b->count;
        b->held = 0;
        b->count = 0;
        skylight_sh_7_bands_0_005pct_packed_fill(b);
    }
    high += (unsigned)ones;
    b->held = b->held >> ones >> 1;
    b->count -= ones + 1;
    folded = (high << low) | skylight_sh_7_bands_0_005pct_packed_fixed(b, low);
    return folded & 1 ? -(int)(folded >> 1) - 1 : (int)(folded >> 1);
}

/* The stream from its start. */
static inline skylight_sh_7_bands_0_005pct_packed_bits
    skylight_sh_7_bands_0_005pct_packed_open(void)
{
    skylight_sh_7_bands_0_005pct_packed_bits b;
    b.next = skylight_sh_7_bands_0_005pct_packed_stream;
    b.held = 0;
    b.count = 0;
    return b;
}

/* The next band's profile: twice the low bits that its numbers have, by their place in a run. */
static inline void
    skylight_sh_7_bands_0_005pct_packed_next_profile(skylight_sh_7_bands_0_005pct_packed_bits *b,
    int profile[32])
{
    const int used = (int)skylight_sh_7_bands_0_005pct_packed_fixed(b, 5);
    int i;
    for (i = 0; i < used; ++i) profile[i] = (int)skylight_sh_7_bands_0_005pct_packed_fixed(b, 5);
}

/* The length of the next run, by that of the same class and product at the weight before. */
static inline int
    skylight_sh_7_bands_0_005pct_packed_next_length(skylight_sh_7_bands_0_005pct_packed_bits *b,
    signed char *length)
{
    const int found = *length + skylight_sh_7_bands_0_005pct_packed_rice(b, 0);
    *length = (signed char)found;
    return found;
}

/* The next number, of `size` half low bits. */
static inline int
    skylight_sh_7_bands_0_005pct_packed_next_number(skylight_sh_7_bands_0_005pct_packed_bits *b,
    int size)
{
    return skylight_sh_7_bands_0_005pct_packed_rice(b, size > 0 ? size >> 1 : 0);
}

static const signed char
    skylight_sh_7_bands_0_005pct_packed_run_profile[SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_RUNS] =
    SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_RUN_PROFILE;
static const signed char
    skylight_sh_7_bands_0_005pct_packed_class_profile[SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_CLASSES] =
    SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_CLASS_PROFILE;

/* Reads the stream once, forward: the sums of the first `bands` bands. */
static inline void skylight_sh_7_bands_0_005pct_packed_sum_stream(
    const skylight_sh_7_bands_0_005pct_packed_real *first,
        const skylight_sh_7_bands_0_005pct_packed_real *others, int bands,
    skylight_sh_7_bands_0_005pct_packed_real
        sums[SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_CLASSES][SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_ROOM])
{
    signed char
        lengths[SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_CLASSES]
        [SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_RUNS];
    int profile[32], i, l, m, c, other, column = 0;
    skylight_sh_7_bands_0_005pct_packed_bits bits = skylight_sh_7_bands_0_005pct_packed_open();
    memset(lengths, 0, sizeof lengths);
    memset(profile, 0, sizeof profile);
    memset(sums, 0, sizeof(skylight_sh_7_bands_0_005pct_packed_real) *
        SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_CLASSES * SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_ROOM);
    for (l = 0; l < bands; ++l) {
        skylight_sh_7_bands_0_005pct_packed_next_profile(&bits, profile);
        for (m = SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_FIRST_ORDER(l); m <= l; ++m, ++column) {
            for (c = 0; c < SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_CLASSES; ++c) {
                skylight_sh_7_bands_0_005pct_packed_real value = 0;
                for (other = 0; other < SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_RUNS; ++other) {
                    const int level = skylight_sh_7_bands_0_005pct_packed_run_profile[other] +
                        skylight_sh_7_bands_0_005pct_packed_class_profile[c];
                    const int length = skylight_sh_7_bands_0_005pct_packed_next_length(&bits,
                        &lengths[c][other]);
                    skylight_sh_7_bands_0_005pct_packed_real sum = 0;
                    for (i = 0; i < length; ++i) {
                        const int number = skylight_sh_7_bands_0_005pct_packed_next_number(&bits,
                            profile[i] + level);
                        sum += first[i] * (skylight_sh_7_bands_0_005pct_packed_real)number;
                    }
                    value += sum * others[other];
                }
                sums[c][column] = value * SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_STEP;
            }
        }
    }
}

/* Reads the stream once, forward, into rows: of each class one for each product of functions. */
static inline void skylight_sh_7_bands_0_005pct_packed_unpack_rows(float *rows)
{
    static const unsigned char
        sizes[SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_CLASSES]
        [SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_OTHERS] = SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_LENGTHS;
    unsigned short
        starts[SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_CLASSES]
        [SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_RUNS];
    signed char
        lengths[SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_CLASSES]
        [SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_RUNS];
    int profile[32], i, l, m, c, other, column = 0, row = 0;
    skylight_sh_7_bands_0_005pct_packed_bits bits = skylight_sh_7_bands_0_005pct_packed_open();
    memset(lengths, 0, sizeof lengths);
    memset(profile, 0, sizeof profile);
    for (c = 0; c < SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_CLASSES; ++c) {
        for (other = 0; other < SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_OTHERS; ++other) {
            if (other < SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_RUNS) starts[c][other] = (unsigned
                short)row;
            row += sizes[c][other];
        }
    }
    for (i = 0; i < SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_UNPACKED; ++i) rows[i] = 0.0f;
    for (l = 0; l < SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_BANDS; ++l) {
        skylight_sh_7_bands_0_005pct_packed_next_profile(&bits, profile);
        for (m = SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_FIRST_ORDER(l); m <= l; ++m, ++column) {
            for (c = 0; c < SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_CLASSES; ++c) {
                for (other = 0; other < SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_RUNS; ++other) {
                    const int level = skylight_sh_7_bands_0_005pct_packed_run_profile[other] +
                        skylight_sh_7_bands_0_005pct_packed_class_profile[c];
                    const int length = skylight_sh_7_bands_0_005pct_packed_next_length(&bits,
                        &lengths[c][other]);
                    float *to = rows + (int)starts[c][other] *
                        SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_WIDTH + column;
                    for (i = 0; i < length; ++i) {
                        const int number = skylight_sh_7_bands_0_005pct_packed_next_number(&bits,
                            profile[i] + level);
                        *to = (float)number * SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_STEP;
                        to += SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_WIDTH;
                    }
                }
            }
        }
    }
}

/* The sums in double precision, all bands: what derivatives need, whose terms cancel. */
static inline void skylight_sh_7_bands_0_005pct_packed_sum_stream_double(
    const double *first, const double *others,
        double
        sums[SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_CLASSES]
        [SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_WIDTH])
{
    signed char
        lengths[SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_CLASSES]
        [SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_RUNS];
    int profile[32], i, l, m, c, other, column = 0;
    skylight_sh_7_bands_0_005pct_packed_bits bits = skylight_sh_7_bands_0_005pct_packed_open();
    memset(lengths, 0, sizeof lengths);
    memset(profile, 0, sizeof profile);
    for (l = 0; l < SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_BANDS; ++l) {
        skylight_sh_7_bands_0_005pct_packed_next_profile(&bits, profile);
        for (m = SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_FIRST_ORDER(l); m <= l; ++m, ++column) {
            for (c = 0; c < SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_CLASSES; ++c) {
                double value = 0.0;
                for (other = 0; other < SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_RUNS; ++other) {
                    const int level = skylight_sh_7_bands_0_005pct_packed_run_profile[other] +
                        skylight_sh_7_bands_0_005pct_packed_class_profile[c];
                    const int length = skylight_sh_7_bands_0_005pct_packed_next_length(&bits,
                        &lengths[c][other]);
                    double sum = 0.0;
                    for (i = 0; i < length; ++i) {
                        const int number = skylight_sh_7_bands_0_005pct_packed_next_number(&bits,
                            profile[i] + level);
                        sum += first[i] * (double)number;
                    }
                    value += sum * others[other];
                }
                sums[c][column] = value * (double)SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_STEP;
            }
        }
    }
}

/* What becomes of the first `bands` bands once they are stored. */
static inline void skylight_sh_7_bands_0_005pct_packed_finish(int bands, int lights,
                                      float
                                          weights[SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_CHANNELS]
                                          [SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_WEIGHTS])
{
    (void)bands;
    (void)lights;
    (void)weights;
}

/* Evaluates the first `bands` bands (1 to SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_BANDS, clamped like
 * an input) and zeroes the
   rest; returns the status. `rows` are the table's; those of a packed table may be missing. */
static inline int skylight_sh_7_bands_0_005pct_packed_evaluate(const
    skylight_sh_7_bands_0_005pct_packed_real *rows,
                                       const float inputs[SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_AXES],
                                           float azimuth,
                                       int bands,
                                       float
                                           weights[SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_CHANNELS]
                                           [SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_WEIGHTS])
{
    skylight_sh_7_bands_0_005pct_packed_real x[SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_AXES],
        first[SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_FIRST],
        others[SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_OTHERS];
    skylight_sh_7_bands_0_005pct_packed_real cosines[SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_BANDS],
        sines[SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_BANDS];
    skylight_sh_7_bands_0_005pct_packed_real
        sums[SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_CLASSES][SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_ROOM];
    skylight_sh_7_bands_0_005pct_packed_real factors[SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_CHANNELS *
        SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_CLASSES];
    skylight_sh_7_bands_0_005pct_packed_real light = SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_EXPOSURE,
        radius = 1;
    skylight_sh_7_bands_0_005pct_packed_real early[SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_EARLY];
    int i, all, status = skylight_sh_7_bands_0_005pct_packed_inputs(inputs, azimuth, x);
    if (status == 2) {
        memset(weights, 0, sizeof(float) * SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_CHANNELS *
            SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_WEIGHTS);
        return 2;
    }
    if (bands < 1 || bands > SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_BANDS) {
        bands = bands < 1 ? 1 : SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_BANDS;
        status = 1;
    }
    /* First what the library computes: calls keep no registers. */
    radius = skylight_sh_7_bands_0_005pct_packed_sine(x);
    skylight_sh_7_bands_0_005pct_packed_waves((skylight_sh_7_bands_0_005pct_packed_real)azimuth,
        radius, cosines, sines);
    skylight_sh_7_bands_0_005pct_packed_first(x, first);
    skylight_sh_7_bands_0_005pct_packed_others(x, others);
    skylight_sh_7_bands_0_005pct_packed_begin_factors(x, early);
    all = bands;
    if (!rows) skylight_sh_7_bands_0_005pct_packed_sum_stream(first, others, all, sums);
    if (rows)
        skylight_sh_7_bands_0_005pct_packed_sum_class(rows, 0, first, others, all, sums[0]);
    /* Between sums: what has begun above waits for itself, and there is more to do meanwhile. */
    skylight_sh_7_bands_0_005pct_packed_end_factors(x, early, factors);
    for (i = 0; i < SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_CHANNELS *
        SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_CLASSES; ++i) factors[i] *= light;
    if (rows)
    {
#define SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_CLASS(k) \
    skylight_sh_7_bands_0_005pct_packed_sum_class(rows, k, first, others, all, sums[k]);
        SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_OTHER_CLASSES(SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_CLASS)
#undef SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_CLASS
    }
    skylight_sh_7_bands_0_005pct_packed_store(sums, factors, cosines, sines, all, weights);
    skylight_sh_7_bands_0_005pct_packed_finish(bands, 1, weights);
    if (bands < SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_BANDS) {
        int channel;
        for (channel = 0; channel < SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_CHANNELS; ++channel)
            for (i = bands * bands; i < SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_WEIGHTS; ++i)
                weights[channel][i] = 0.0f;
    }
    return status;
}

/* One of many suns by itself. */
static inline int skylight_sh_7_bands_0_005pct_packed_evaluate_one(const
    skylight_sh_7_bands_0_005pct_packed_real *rows,
                                           const float *const
                                               inputs[SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_AXES],
                                           const float *azimuths, int sun,
                                           float
                                               weights[SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_CHANNELS]
                                               [SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_WEIGHTS])
{
    float given[SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_AXES];
    int axis;
    for (axis = 0; axis < SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_AXES; ++axis) given[axis] =
        inputs[axis][sun];
    return skylight_sh_7_bands_0_005pct_packed_evaluate(rows, given,
        azimuths ? azimuths[sun] : SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_AZIMUTH,
                                SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_BANDS, weights);
}

/* Evaluates `count` suns from arrays, one an axis, and one of azimuths (or none, where the table
   fixes it); returns the largest status. */
static inline int skylight_sh_7_bands_0_005pct_packed_evaluate_batch(
    const skylight_sh_7_bands_0_005pct_packed_real *rows, int count,
        const float *const inputs[SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_AXES],
    const float *azimuths, float
        (*weights)[SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_CHANNELS]
        [SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_WEIGHTS])
{
    int s, status, worst = 0;
    for (s = 0; s < count; ++s) {
        status = skylight_sh_7_bands_0_005pct_packed_evaluate_one(rows, inputs, azimuths, s,
            weights[s]);
        worst = status > worst ? status : worst;
    }
    return worst;
}

/* The same with the suns of each weight side by side: `weights` is [channels][weights][count]. */
static inline int skylight_sh_7_bands_0_005pct_packed_evaluate_columns(const
    skylight_sh_7_bands_0_005pct_packed_real *rows, int count,
                                               const float *const
                                                   inputs[SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_AXES],
                                               const float *azimuths, float *weights)
{
    const size_t step = count > 0 ? (size_t)count : 0;
    int s = 0, i, status, worst = 0;
    while (s < count) {
        /* Some at once, so that what is written lies together. */
        float
            some[16][SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_CHANNELS]
            [SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_WEIGHTS];
        const int now = count - s < 16 ? count - s : 16;
        int k;
        for (k = 0; k < now; ++k) {
            status = skylight_sh_7_bands_0_005pct_packed_evaluate_one(rows, inputs, azimuths, s + k,
                some[k]);
            worst = status > worst ? status : worst;
        }
        for (i = 0; i < SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_CHANNELS *
            SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_WEIGHTS; ++i)
            for (k = 0; k < now; ++k)
                weights[(size_t)i * step + (size_t)(s + k)] =
                    some[k][i / SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_WEIGHTS][i %
                        SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_WEIGHTS];
        s += now;
    }
    return worst;
}

/* All products of `count` numbers and `size` functions, the functions' place fastest; returns how
   many. */
static inline int skylight_sh_7_bands_0_005pct_packed_multiply_double(double *products, int count,
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

/* The sums of all terms in double, of the axes' functions. */
static inline void skylight_sh_7_bands_0_005pct_packed_sum_double(
    const skylight_sh_7_bands_0_005pct_packed_real *rows,
        double
        functions[SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_AXES]
        [SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_MOST],
    double
        sums[SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_CLASSES]
        [SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_WIDTH])
{
    static const int sizes[SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_AXES] =
        SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_SIZES;
    double others[SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_OTHERS];
    int axis, count = 1;
    others[0] = 1.0;
    for (axis = 1; axis < SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_AXES; ++axis)
        count = skylight_sh_7_bands_0_005pct_packed_multiply_double(others, count, functions[axis],
            sizes[axis]);
    skylight_sh_7_bands_0_005pct_packed_sum_stream_double(functions[0], others, sums);
    (void)rows;
    (void)count;
}

/* One channel's sum in double, at a column. */
static inline double skylight_sh_7_bands_0_005pct_packed_mixed_double(double
    sums[SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_CLASSES][SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_WIDTH],
                                              int channel, int column, const double *factors)
{
    double sum = 0.0;
    int k;
    for (k = 0; k < SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_CLASSES; ++k)
        sum += factors[channel * SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_CLASSES + k] * sums[k][column];
    return sum;
}

/* Evaluates all bands, and their derivatives after each axis by the product rule, in double until
   they are stored: exact inside the ranges, and beyond one those at its edge. */
static inline int skylight_sh_7_bands_0_005pct_packed_evaluate_gradient(
    const skylight_sh_7_bands_0_005pct_packed_real *rows,
        const float inputs[SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_AXES], float azimuth,
    float
        weights[SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_CHANNELS]
        [SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_WEIGHTS],
    float
        gradient[SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_AXES]
        [SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_CHANNELS][SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_WEIGHTS])
{
    static const short columns[SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_BANDS] =
        SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_COLUMNS;
    double x[SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_AXES],
        functions[SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_AXES]
        [SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_MOST];
    double
        slopes[SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_AXES][SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_MOST];
    double factors[1 +
        SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_AXES][SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_FACTORS];
    double
        sums[SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_CLASSES]
        [SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_WIDTH];
    double
        sloped[SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_CLASSES]
        [SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_WIDTH];
    double powers[SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_BANDS],
        power_slopes[SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_BANDS];
    skylight_sh_7_bands_0_005pct_packed_real cosines[SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_BANDS],
        sines[SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_BANDS];
    int axis, channel, i, l, m, sunk = 0;
    const int status =
        skylight_sh_7_bands_0_005pct_packed_evaluate(rows, inputs, azimuth,
            SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_BANDS, weights);
    memset(gradient, 0,
           sizeof(float) * SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_AXES *
               SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_CHANNELS *
               SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_WEIGHTS);
    if (status == 2) return 2;
    for (axis = 0; axis < SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_AXES; ++axis) {
        const double low = skylight_sh_7_bands_0_005pct_packed_slope_range[axis][0];
        const double high = skylight_sh_7_bands_0_005pct_packed_slope_range[axis][1];
        const double v = (double)skylight_sh_7_bands_0_005pct_packed_finite(inputs[axis]);
        x[axis] = v < low ? low : v > high ? high : v;
        skylight_sh_7_bands_0_005pct_packed_functions(axis, x[axis], functions[axis], slopes[axis]);
    }
    skylight_sh_7_bands_0_005pct_packed_factor_slopes(x, &factors[0][0]);
    for (axis = 0; axis < 1 + SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_AXES; ++axis)
        for (i = 0; i < SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_FACTORS; ++i)
            factors[axis][i] *= (double)SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_EXPOSURE;
    for (m = 0; m < SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_BANDS; ++m) {
        powers[m] = 1.0;
        power_slopes[m] = 0.0;
    }
    {
        double sine[2];
        skylight_sh_7_bands_0_005pct_packed_sine_slope(x, sine);
        for (m = 1; m < SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_BANDS; ++m) {
            powers[m] = powers[m - 1] * sine[0];
            power_slopes[m] = (double)m * powers[m - 1] * sine[1];
        }
    }
    skylight_sh_7_bands_0_005pct_packed_waves((skylight_sh_7_bands_0_005pct_packed_real)azimuth, 1,
        cosines, sines);
    skylight_sh_7_bands_0_005pct_packed_sum_double(rows, functions, sums);
    for (axis = 0; axis < SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_AXES; ++axis) {
        double kept[SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_MOST];
        memcpy(kept, functions[axis], sizeof kept);
        memcpy(functions[axis], slopes[axis], sizeof kept);
        skylight_sh_7_bands_0_005pct_packed_sum_double(rows, functions, sloped);
        memcpy(functions[axis], kept, sizeof kept);
        for (channel = 0; channel < SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_CHANNELS; ++channel) {
            float *const w = gradient[axis][channel];
            for (l = 0; l < SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_BANDS; ++l) {
                for (m = SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_FIRST_ORDER(l); m <= l && columns[l] >=
                    0; ++m) {
                    const int order = m < 0 ? -m : m;
                    const int column = columns[l] + m -
                        SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_FIRST_ORDER(l);
                    double value =
                        powers[order] *
                        (skylight_sh_7_bands_0_005pct_packed_mixed_double(sloped, channel, column,
                            factors[0]) +
                         skylight_sh_7_bands_0_005pct_packed_mixed_double(sums, channel, column,
                             factors[1 + axis]));
                    if (axis == SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_SUN && !sunk)
                        value += power_slopes[order] *
                                 skylight_sh_7_bands_0_005pct_packed_mixed_double(sums, channel,
                                     column, factors[0]);
                    skylight_sh_7_bands_0_005pct_packed_place((
                        skylight_sh_7_bands_0_005pct_packed_real)value, l, m, cosines, sines, w);
                }
            }
        }
        skylight_sh_7_bands_0_005pct_packed_finish(SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_BANDS, 0,
            gradient[axis]);
    }
    (void)power_slopes;
    (void)sunk;
    return status;
}

SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_API int skylight_sh_7_bands_0_005pct_packed_weights(float
    sun_zenith, float sun_azimuth, float turbidity,
    float
    weights[SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_CHANNELS]
    [SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_WEIGHTS])
{
    const float skylight_sh_7_bands_0_005pct_packed_given[SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_AXES]
        = { sun_zenith, turbidity };
    return skylight_sh_7_bands_0_005pct_packed_evaluate(NULL,
        skylight_sh_7_bands_0_005pct_packed_given, sun_azimuth,
        SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_BANDS, weights);
}

SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_API int skylight_sh_7_bands_0_005pct_packed_weights_bands(float
    sun_zenith, float sun_azimuth, float turbidity, int bands,
    float
    weights[SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_CHANNELS]
    [SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_WEIGHTS])
{
    const float skylight_sh_7_bands_0_005pct_packed_given[SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_AXES]
        = { sun_zenith, turbidity };
    return skylight_sh_7_bands_0_005pct_packed_evaluate(NULL,
        skylight_sh_7_bands_0_005pct_packed_given, sun_azimuth, bands, weights);
}

SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_API int skylight_sh_7_bands_0_005pct_packed_weights_batch(int
    count, const float *sun_zenith, const float *sun_azimuth, const float *turbidity,
    float
    (*weights)[SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_CHANNELS]
    [SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_WEIGHTS])
{
    const float *const
        skylight_sh_7_bands_0_005pct_packed_given[SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_AXES] = {
        sun_zenith, turbidity };
    float skylight_sh_7_bands_0_005pct_packed_memory[SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_UNPACKED];
    if (count > 1)
        skylight_sh_7_bands_0_005pct_packed_unpack_rows(skylight_sh_7_bands_0_005pct_packed_memory);
    return skylight_sh_7_bands_0_005pct_packed_evaluate_batch(count > 1 ?
        skylight_sh_7_bands_0_005pct_packed_memory : NULL, count,
        skylight_sh_7_bands_0_005pct_packed_given, sun_azimuth, weights);
}

SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_API int skylight_sh_7_bands_0_005pct_packed_weights_columns(int
    count, const float *sun_zenith, const float *sun_azimuth, const float *turbidity,
    float *weights)
{
    const float *const
        skylight_sh_7_bands_0_005pct_packed_given[SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_AXES] = {
        sun_zenith, turbidity };
    float skylight_sh_7_bands_0_005pct_packed_memory[SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_UNPACKED];
    if (count > 1)
        skylight_sh_7_bands_0_005pct_packed_unpack_rows(skylight_sh_7_bands_0_005pct_packed_memory);
    return skylight_sh_7_bands_0_005pct_packed_evaluate_columns(count > 1 ?
        skylight_sh_7_bands_0_005pct_packed_memory : NULL, count,
        skylight_sh_7_bands_0_005pct_packed_given, sun_azimuth, weights);
}

SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_API int
    skylight_sh_7_bands_0_005pct_packed_weights_gradient(float sun_zenith, float sun_azimuth,
    float turbidity, float
    weights[SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_CHANNELS]
    [SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_WEIGHTS],
    float
    gradient[SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_AXES][SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_CHANNELS]
    [SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_WEIGHTS])
{
    const float skylight_sh_7_bands_0_005pct_packed_given[SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_AXES]
        = { sun_zenith, turbidity };
    return skylight_sh_7_bands_0_005pct_packed_evaluate_gradient(NULL,
        skylight_sh_7_bands_0_005pct_packed_given, sun_azimuth, weights, gradient);
}

SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_API void skylight_sh_7_bands_0_005pct_packed_unpack(float
    memory[SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_UNPACKED])
{
    skylight_sh_7_bands_0_005pct_packed_unpack_rows(memory);
}

SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_API int
    skylight_sh_7_bands_0_005pct_packed_unpacked_weights(const float
    memory[SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_UNPACKED], float sun_zenith, float sun_azimuth,
    float turbidity, float
    weights[SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_CHANNELS]
    [SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_WEIGHTS])
{
    const float skylight_sh_7_bands_0_005pct_packed_given[SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_AXES]
        = { sun_zenith, turbidity };
    return skylight_sh_7_bands_0_005pct_packed_evaluate(memory,
        skylight_sh_7_bands_0_005pct_packed_given, sun_azimuth,
        SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_BANDS, weights);
}

SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_API int
    skylight_sh_7_bands_0_005pct_packed_unpacked_weights_bands(const float
    memory[SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_UNPACKED], float sun_zenith, float sun_azimuth,
    float turbidity, int bands, float
    weights[SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_CHANNELS]
    [SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_WEIGHTS])
{
    const float skylight_sh_7_bands_0_005pct_packed_given[SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_AXES]
        = { sun_zenith, turbidity };
    return skylight_sh_7_bands_0_005pct_packed_evaluate(memory,
        skylight_sh_7_bands_0_005pct_packed_given, sun_azimuth, bands, weights);
}

SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_API int
    skylight_sh_7_bands_0_005pct_packed_unpacked_weights_batch(const float
    memory[SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_UNPACKED], int count, const float *sun_zenith,
    const float *sun_azimuth, const float *turbidity,
    float
    (*weights)[SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_CHANNELS]
    [SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_WEIGHTS])
{
    const float *const
        skylight_sh_7_bands_0_005pct_packed_given[SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_AXES] = {
        sun_zenith, turbidity };
    return skylight_sh_7_bands_0_005pct_packed_evaluate_batch(memory, count,
        skylight_sh_7_bands_0_005pct_packed_given, sun_azimuth, weights);
}

SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_API int
    skylight_sh_7_bands_0_005pct_packed_unpacked_weights_columns(const float
    memory[SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_UNPACKED], int count, const float *sun_zenith,
    const float *sun_azimuth, const float *turbidity, float *weights)
{
    const float *const
        skylight_sh_7_bands_0_005pct_packed_given[SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_AXES] = {
        sun_zenith, turbidity };
    return skylight_sh_7_bands_0_005pct_packed_evaluate_columns(memory, count,
        skylight_sh_7_bands_0_005pct_packed_given, sun_azimuth, weights);
}

/* The dominant light's direction, a unit vector: where the linear part of the weights, summed over
   channels by luminance, points. Returns 0, or 1 (and straight up) where it points nowhere. */
SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_API int skylight_sh_7_bands_0_005pct_packed_dominant_of(const
    float *weights, float direction[3])
{
    static const float luminance[SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_CHANNELS] =
        SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_LUMINANCE;
    float x = 0.0f, y = 0.0f, z = 0.0f, length;
    int channel;
    for (channel = 0; channel < SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_CHANNELS; ++channel) {
        const float *const linear = weights + channel * SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_WEIGHTS
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
SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_API void skylight_sh_7_bands_0_005pct_packed_ground(
    const float albedo[SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_CHANNELS],
    float
        weights[SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_CHANNELS]
        [SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_WEIGHTS])
{
    static const float lower[SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_BANDS] =
        SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_LOWER;
    int l, channel;
    for (channel = 0; channel < SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_CHANNELS; ++channel) {
        const float radiance = albedo[channel] * SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_REFLECTED *
            weights[channel][2];
        for (l = 0; l < SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_BANDS; ++l) weights[channel][l * (l +
            1)] += radiance * lower[l];
    }
}

/* Tames the ringing of the horizon in the first `bands` bands by the zonal window sinc(pi l /
   bands) (Habel et al. 2008, eq. 5). */
SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_API void skylight_sh_7_bands_0_005pct_packed_window(
    int bands, float
        weights[SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_CHANNELS]
        [SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_WEIGHTS])
{
    int l, channel;
    for (l = 1; l < bands && l < SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_BANDS; ++l) {
        const float factor = skylight_sh_7_bands_0_005pct_packed_sinc((float)l / (float)bands);
        for (channel = 0; channel < SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_CHANNELS; ++channel)
            weights[channel][l * (l + 1)] *= factor;
    }
}

#endif /* SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_DEFINED */
