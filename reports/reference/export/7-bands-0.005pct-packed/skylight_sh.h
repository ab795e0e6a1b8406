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
 * Accuracy, as shipped: E_mean 0.0047 %, E_max 0.0182 % of the least luminance of the same sky, at
 * azimuth 0.
 * The expansion rings: the least value it takes, over all directions and measured sets, is -12.7 %
 * of its largest in the same set; the window below tames it.
 * Memory: 4728 bytes of constants, packed into few bytes (a fast table takes more and less time).
 *
 * Provenance
 *   skylight-sh 0.1.0, config preetham 50c449acd9f31f25, table 7-bands-0.005pct-packed
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
#define SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_H 0x577aedd8

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
#define SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_E_MEAN 4.698000e-05
#define SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_E_MAX 1.822000e-04
#define SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_UNPACKED 5128
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

#elif SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_H != 0x577aedd8
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
#define SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_TERMS 183
#define SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_STARTS { 0, 70, 123 }
#define SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_COUNTS { 70, 53, 60 }
#define SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_PLACES { 0, 72, 128 }
#define SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_PRODUCTS_ROOM 192
/* Of each class and product of the other axes' functions: how many
   functions of the first axis it has. */
#define SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_LENGTHS { { 14, 14, 11, 11, 8, 7, 3, 2 }, { 12, 11, \
    10, 9, 6, 3, 2, 0 }, { 14, 12, 11, 9, 6, 6, 2, 0 } }
/* The same: of each that has any, class, place of the first product, how
   many, the other axes' product. */
#define SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_PRODUCTS(PRODUCT) \
    PRODUCT(0, 0, 14, 0) \
    PRODUCT(0, 14, 14, 1) \
    PRODUCT(0, 28, 11, 2) \
    PRODUCT(0, 39, 11, 3) \
    PRODUCT(0, 50, 8, 4) \
    PRODUCT(0, 58, 7, 5) \
    PRODUCT(0, 65, 3, 6) \
    PRODUCT(0, 68, 2, 7) \
    PRODUCT(1, 72, 12, 0) \
    PRODUCT(1, 84, 11, 1) \
    PRODUCT(1, 95, 10, 2) \
    PRODUCT(1, 105, 9, 3) \
    PRODUCT(1, 114, 6, 4) \
    PRODUCT(1, 120, 3, 5) \
    PRODUCT(1, 123, 2, 6) \
    PRODUCT(2, 128, 14, 0) \
    PRODUCT(2, 142, 12, 1) \
    PRODUCT(2, 154, 11, 2) \
    PRODUCT(2, 165, 9, 3) \
    PRODUCT(2, 174, 6, 4) \
    PRODUCT(2, 180, 6, 5) \
    PRODUCT(2, 186, 2, 6)
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
#define SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_RUN_PROFILE { 11, 9, 5, -1, -8, -12, -19, -25 }
#define SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_CLASS_PROFILE { -8, -15, -13 }
#define SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_STEP 1.47521496e-06f

/* Whole numbers as Rice codes. */
static const unsigned char skylight_sh_7_bands_0_005pct_packed_stream[4455] = {
    235, 255, 109, 39, 100, 202, 16, 241, 255, 255, 251, 255, 255, 159, 75, 224, 69, 237, 89, 247,
    207, 136, 147, 113, 66, 18, 97, 49, 243, 255, 223, 255, 179, 211, 190, 151, 67, 104, 232, 112,
    130, 18, 165, 21, 214, 255, 191, 175, 28, 64, 106, 209, 255, 37, 168, 7, 145, 241, 255, 191,
    143, 0, 212, 218, 243, 254, 153, 3, 247, 255, 251, 31, 100, 125, 235, 227, 185, 254, 247, 127,
    176, 134, 244, 251, 159, 107, 251, 247, 255, 63, 206, 83, 216, 53, 77, 64, 76, 125, 130, 242,
    255, 175, 250, 103, 131, 77, 92, 191, 53, 54, 231, 255, 171, 189, 176, 89, 149, 100, 24, 255,
    95, 4, 137, 242, 156, 126, 59, 227, 183, 181, 252, 255, 191, 255, 255, 31, 145, 254, 141, 28,
    167, 172, 207, 5, 98, 229, 118, 42, 247, 255, 127, 63, 142, 188, 251, 122, 228, 232, 222, 213,
    84, 97, 156, 255, 223, 255, 42, 149, 199, 202, 185, 71, 50, 231, 255, 239, 199, 200, 111, 219,
    108, 180, 255, 61, 43, 184, 222, 179, 237, 97, 255, 111, 59, 33, 83, 198, 8, 114, 255, 255, 63,
    132, 132, 95, 167, 26, 108, 246, 233, 8, 125, 73, 98, 100, 17, 251, 255, 89, 15, 191, 40, 218,
    121, 45, 16, 99, 84, 91, 4, 136, 250, 14, 130, 68, 24, 99, 181, 163, 50, 224, 216, 200, 145, 27,
    246, 9, 20, 198, 214, 255, 19, 180, 172, 63, 82, 255, 35, 85, 76, 255, 103, 251, 101, 24, 175,
    43, 231, 65, 46, 116, 1, 140, 250, 22, 97, 101, 150, 117, 30, 96, 48, 237, 53, 37, 10, 26, 9,
    17, 120, 44, 125, 224, 65, 191, 72, 219, 114, 255, 255, 255, 207, 146, 248, 170, 169, 39, 82,
    82, 171, 89, 16, 65, 247, 255, 104, 237, 43, 117, 71, 250, 245, 115, 103, 115, 255, 111, 205,
    116, 171, 190, 110, 28, 186, 177, 50, 168, 156, 69, 251, 225, 10, 204, 179, 122, 126, 255, 15,
    14, 223, 222, 143, 174, 150, 189, 106, 32, 213, 132, 206, 16, 149, 112, 98, 31, 61, 235, 126,
    157, 208, 161, 51, 54, 177, 228, 119, 186, 111, 129, 100, 50, 126, 160, 179, 59, 189, 26, 226,
    193, 141, 17, 57, 106, 117, 86, 77, 127, 240, 218, 88, 146, 194, 31, 207, 119, 155, 69, 3, 141,
    220, 108, 127, 130, 183, 222, 104, 93, 150, 148, 81, 11, 58, 239, 207, 77, 215, 22, 219, 239,
    210, 106, 6, 158, 142, 237, 233, 80, 222, 235, 55, 158, 15, 233, 253, 64, 183, 241, 231, 185,
    126, 112, 237, 177, 183, 60, 202, 241, 43, 195, 30, 8, 126, 66, 101, 210, 251, 210, 210, 253,
    242, 112, 86, 255, 57, 97, 93, 222, 210, 58, 153, 158, 225, 110, 108, 217, 144, 85, 231, 134,
    169, 243, 237, 168, 121, 126, 188, 123, 168, 96, 206, 92, 140, 251, 191, 99, 10, 153, 50, 4, 8,
    32, 52, 49, 230, 119, 8, 244, 9, 27, 240, 65, 157, 176, 153, 197, 172, 94, 213, 251, 225, 137,
    95, 36, 235, 52, 49, 151, 36, 34, 13, 36, 18, 20, 229, 111, 77, 127, 111, 156, 226, 101, 84,
    208, 182, 121, 45, 79, 31, 214, 30, 184, 241, 226, 155, 71, 158, 164, 90, 237, 189, 131, 45,
    119, 31, 167, 191, 247, 122, 204, 80, 199, 126, 92, 216, 200, 236, 107, 199, 111, 131, 15, 159,
    0, 227, 117, 110, 237, 215, 216, 118, 27, 94, 184, 222, 226, 90, 113, 187, 249, 190, 70, 94,
    156, 231, 125, 74, 255, 63, 42, 127, 107, 99, 18, 231, 190, 172, 218, 12, 243, 225, 240, 255,
    243, 242, 47, 3, 230, 87, 37, 54, 197, 160, 186, 214, 47, 34, 126, 78, 185, 20, 20, 187, 206,
    254, 26, 5, 243, 50, 157, 245, 244, 74, 50, 27, 106, 154, 251, 127, 226, 55, 126, 97, 1, 41,
    187, 69, 6, 97, 88, 4, 55, 151, 145, 126, 156, 253, 175, 164, 34, 129, 26, 4, 114, 191, 98, 7,
    137, 187, 182, 241, 92, 48, 189, 162, 199, 245, 132, 133, 212, 240, 110, 18, 41, 65, 164, 19,
    97, 175, 35, 192, 169, 143, 240, 189, 60, 71, 217, 48, 159, 245, 211, 91, 55, 241, 112, 170, 81,
    60, 18, 40, 250, 177, 255, 55, 95, 32, 226, 16, 102, 42, 185, 163, 244, 237, 97, 21, 119, 132,
    118, 63, 218, 183, 68, 134, 202, 31, 253, 58, 244, 241, 222, 59, 30, 183, 121, 159, 250, 72,
    157, 110, 149, 207, 31, 128, 113, 67, 217, 251, 1, 185, 113, 73, 251, 140, 202, 185, 30, 157,
    91, 91, 81, 38, 175, 118, 88, 109, 11, 231, 97, 247, 208, 42, 73, 29, 250, 222, 249, 247, 199,
    178, 180, 158, 94, 77, 84, 20, 87, 0, 39, 108, 233, 115, 241, 76, 66, 89, 136, 118, 135, 10,
    243, 19, 157, 48, 77, 119, 159, 142, 86, 166, 3, 247, 225, 60, 41, 55, 73, 224, 167, 14, 169,
    192, 86, 222, 222, 99, 31, 232, 182, 125, 31, 208, 97, 220, 113, 1, 170, 186, 110, 79, 40, 75,
    75, 44, 64, 31, 50, 11, 136, 60, 254, 100, 213, 122, 84, 133, 126, 90, 231, 207, 143, 125, 96,
    41, 190, 56, 78, 249, 116, 206, 167, 219, 65, 196, 243, 252, 168, 84, 143, 106, 182, 41, 101,
    167, 79, 14, 120, 158, 66, 188, 228, 246, 141, 238, 15, 239, 1, 144, 104, 191, 238, 215, 33,
    205, 78, 121, 194, 58, 193, 202, 190, 139, 152, 252, 216, 29, 144, 105, 203, 80, 186, 57, 39,
    41, 111, 131, 169, 113, 255, 247, 76, 37, 83, 134, 8, 33, 200, 127, 255, 117, 163, 186, 30, 232,
    31, 46, 216, 237, 187, 38, 14, 49, 118, 28, 35, 83, 114, 63, 48, 19, 71, 223, 18, 59, 44, 80,
    246, 152, 110, 6, 106, 138, 226, 130, 87, 24, 79, 179, 201, 202, 210, 119, 203, 200, 224, 235,
    193, 188, 91, 61, 207, 123, 78, 91, 100, 174, 179, 219, 67, 229, 204, 85, 182, 100, 23, 107, 24,
    81, 114, 121, 128, 120, 157, 147, 123, 219, 242, 16, 83, 98, 13, 115, 225, 188, 38, 54, 218, 57,
    93, 160, 42, 102, 94, 177, 248, 201, 55, 200, 208, 197, 83, 199, 117, 82, 89, 65, 27, 48, 14,
    185, 209, 158, 36, 192, 154, 118, 255, 243, 38, 11, 212, 36, 86, 246, 39, 164, 191, 181, 56, 1,
    233, 57, 39, 25, 23, 250, 121, 252, 111, 72, 96, 38, 119, 201, 157, 216, 136, 160, 135, 249, 29,
    196, 164, 127, 217, 251, 30, 212, 38, 188, 172, 116, 118, 196, 14, 29, 186, 201, 239, 25, 62,
    189, 153, 218, 201, 247, 171, 250, 69, 2, 237, 36, 28, 101, 59, 223, 78, 119, 172, 141, 11, 197,
    113, 80, 214, 219, 22, 236, 185, 170, 203, 82, 55, 111, 246, 61, 193, 226, 87, 211, 155, 55,
    197, 33, 196, 232, 81, 71, 183, 183, 83, 84, 167, 178, 35, 197, 218, 100, 119, 191, 183, 62,
    142, 132, 36, 132, 246, 117, 31, 10, 126, 109, 204, 50, 122, 187, 217, 39, 241, 151, 29, 235,
    214, 116, 252, 251, 217, 124, 229, 45, 251, 105, 245, 61, 33, 164, 237, 75, 167, 226, 249, 60,
    49, 140, 227, 104, 242, 82, 21, 87, 174, 218, 99, 10, 176, 88, 223, 181, 105, 65, 224, 79, 142,
    144, 222, 149, 209, 209, 12, 79, 100, 141, 45, 116, 5, 167, 80, 153, 239, 143, 5, 250, 187, 57,
    135, 80, 7, 92, 74, 226, 176, 144, 83, 201, 59, 162, 134, 229, 215, 71, 181, 32, 75, 252, 174,
    156, 134, 12, 239, 166, 214, 161, 48, 54, 134, 105, 155, 2, 157, 128, 165, 94, 185, 170, 152,
    176, 28, 129, 253, 170, 98, 169, 58, 192, 157, 236, 80, 100, 209, 157, 118, 237, 255, 80, 57,
    35, 153, 36, 160, 236, 231, 193, 123, 48, 149, 113, 11, 150, 156, 84, 159, 142, 219, 212, 53,
    240, 8, 90, 63, 198, 221, 88, 145, 236, 199, 23, 61, 187, 73, 129, 208, 113, 144, 194, 150, 167,
    194, 25, 37, 200, 56, 139, 133, 179, 96, 255, 69, 106, 18, 116, 20, 58, 195, 150, 222, 77, 132,
    130, 221, 142, 168, 31, 199, 44, 245, 206, 116, 8, 106, 208, 205, 255, 158, 59, 26, 223, 133,
    53, 45, 75, 41, 165, 4, 144, 105, 39, 160, 167, 117, 24, 127, 105, 75, 104, 248, 231, 109, 193,
    241, 32, 39, 86, 153, 78, 138, 107, 209, 99, 222, 114, 92, 66, 212, 27, 1, 61, 168, 33, 17, 234,
    185, 213, 83, 118, 220, 110, 93, 196, 57, 227, 177, 7, 0, 24, 202, 126, 121, 83, 51, 0, 147,
    232, 66, 166, 160, 129, 99, 206, 15, 249, 135, 36, 55, 207, 157, 124, 62, 183, 241, 109, 79,
    205, 197, 226, 236, 249, 76, 231, 143, 128, 89, 83, 87, 228, 183, 117, 178, 13, 41, 11, 53, 4,
    132, 194, 226, 234, 141, 223, 245, 179, 3, 169, 67, 246, 170, 229, 190, 205, 162, 241, 76, 184,
    129, 55, 3, 187, 79, 65, 31, 119, 97, 201, 179, 193, 83, 39, 75, 16, 93, 24, 247, 127, 207, 85,
    58, 102, 200, 24, 0, 124, 208, 16, 179, 248, 116, 208, 88, 255, 66, 147, 103, 76, 145, 68, 144,
    7, 35, 222, 206, 97, 42, 149, 24, 101, 237, 29, 179, 135, 247, 134, 22, 117, 65, 124, 163, 21,
    184, 70, 149, 209, 19, 232, 106, 117, 206, 36, 0, 140, 200, 75, 102, 24, 55, 158, 28, 158, 127,
    39, 34, 64, 92, 167, 56, 84, 104, 246, 118, 231, 48, 48, 77, 166, 89, 158, 193, 137, 123, 104,
    60, 244, 6, 78, 41, 255, 219, 148, 132, 50, 136, 43, 86, 180, 148, 255, 111, 51, 154, 70, 247,
    49, 153, 241, 226, 241, 42, 49, 236, 163, 194, 247, 75, 163, 55, 100, 49, 212, 73, 243, 217,
    218, 196, 18, 185, 34, 166, 5, 124, 124, 234, 4, 144, 139, 6, 194, 167, 63, 147, 128, 148, 77,
    52, 151, 69, 38, 251, 66, 199, 165, 67, 214, 215, 112, 100, 76, 37, 139, 251, 229, 78, 248, 19,
    125, 250, 242, 0, 205, 12, 51, 180, 92, 152, 132, 29, 245, 134, 5, 30, 43, 225, 189, 225, 25,
    35, 86, 2, 194, 166, 167, 178, 155, 221, 119, 211, 106, 132, 141, 83, 209, 190, 155, 117, 55,
    28, 84, 170, 240, 212, 110, 218, 206, 163, 231, 20, 173, 236, 235, 51, 150, 167, 52, 192, 244,
    244, 250, 190, 177, 92, 247, 196, 202, 34, 59, 41, 213, 151, 40, 207, 165, 141, 21, 106, 43,
    232, 77, 175, 119, 230, 19, 191, 250, 158, 201, 89, 211, 139, 61, 225, 133, 14, 112, 127, 94,
    232, 97, 231, 223, 9, 82, 5, 245, 61, 253, 185, 12, 200, 98, 150, 59, 228, 214, 67, 181, 78, 26,
    123, 118, 181, 182, 84, 54, 247, 150, 21, 96, 231, 179, 169, 24, 134, 125, 209, 201, 96, 222,
    142, 165, 150, 248, 51, 35, 255, 14, 234, 210, 239, 82, 245, 217, 143, 242, 9, 245, 162, 247,
    229, 235, 170, 13, 12, 29, 160, 214, 221, 100, 206, 169, 214, 60, 149, 81, 42, 99, 32, 193, 183,
    56, 235, 140, 131, 110, 173, 205, 132, 141, 85, 236, 86, 105, 19, 113, 175, 69, 109, 88, 87,
    158, 81, 208, 107, 248, 205, 139, 80, 97, 12, 108, 153, 38, 41, 22, 246, 37, 62, 96, 6, 108,
    104, 255, 253, 216, 208, 16, 148, 96, 198, 69, 55, 65, 222, 21, 83, 197, 94, 44, 122, 26, 255,
    194, 99, 188, 27, 95, 197, 210, 152, 150, 158, 215, 67, 77, 92, 220, 203, 18, 68, 112, 146, 15,
    37, 70, 105, 144, 17, 229, 117, 0, 17, 204, 182, 173, 190, 41, 151, 5, 66, 132, 181, 58, 7, 113,
    15, 56, 116, 199, 198, 54, 105, 28, 241, 247, 80, 106, 95, 121, 19, 134, 25, 0, 67, 102, 71, 20,
    29, 62, 202, 202, 243, 189, 47, 120, 56, 106, 248, 68, 201, 76, 36, 32, 12, 111, 147, 76, 66,
    176, 64, 33, 187, 2, 241, 178, 208, 242, 18, 130, 175, 7, 38, 105, 73, 55, 31, 89, 194, 144,
    119, 128, 21, 56, 145, 248, 80, 188, 240, 147, 166, 44, 42, 112, 40, 59, 141, 234, 225, 164, 75,
    45, 196, 12, 192, 159, 211, 109, 153, 8, 133, 155, 51, 232, 206, 176, 5, 48, 80, 27, 55, 210,
    104, 162, 5, 100, 36, 212, 100, 166, 96, 58, 93, 32, 166, 98, 3, 242, 204, 19, 43, 76, 42, 47,
    204, 55, 176, 198, 14, 71, 139, 136, 38, 176, 139, 210, 186, 76, 142, 214, 98, 26, 65, 15, 65,
    252, 155, 106, 71, 219, 221, 140, 85, 42, 20, 165, 12, 211, 112, 102, 42, 255, 188, 143, 59,
    255, 176, 23, 10, 51, 197, 252, 160, 195, 72, 199, 31, 89, 153, 133, 216, 236, 253, 68, 64, 132,
    200, 74, 236, 197, 50, 39, 117, 143, 72, 176, 202, 142, 90, 120, 115, 172, 166, 236, 139, 25,
    134, 55, 70, 75, 214, 216, 67, 44, 161, 14, 192, 34, 3, 161, 106, 18, 120, 90, 51, 16, 40, 100,
    151, 213, 169, 130, 142, 198, 23, 208, 106, 84, 212, 47, 79, 98, 254, 222, 98, 216, 211, 220,
    227, 221, 227, 6, 60, 126, 187, 90, 252, 212, 224, 125, 240, 205, 132, 148, 194, 202, 186, 52,
    35, 15, 123, 36, 126, 2, 109, 213, 141, 203, 206, 64, 56, 227, 40, 209, 125, 156, 114, 92, 168,
    202, 68, 1, 14, 87, 48, 128, 106, 130, 30, 238, 255, 158, 175, 116, 12, 33, 99, 136, 248, 251,
    17, 0, 76, 254, 23, 2, 199, 127, 97, 199, 15, 194, 188, 58, 187, 242, 49, 132, 207, 94, 138,
    233, 164, 28, 75, 111, 174, 28, 157, 255, 45, 100, 199, 115, 146, 134, 212, 24, 168, 80, 29,
    129, 239, 168, 121, 14, 35, 235, 158, 106, 240, 177, 137, 162, 94, 224, 207, 215, 235, 102, 202,
    136, 161, 229, 59, 150, 64, 163, 182, 15, 2, 164, 231, 13, 142, 254, 8, 41, 18, 193, 59, 192,
    138, 83, 221, 229, 139, 49, 91, 76, 44, 189, 35, 24, 212, 22, 124, 219, 7, 187, 106, 144, 160,
    132, 203, 135, 93, 29, 193, 238, 129, 124, 37, 232, 85, 32, 17, 154, 9, 89, 214, 151, 155, 194,
    51, 249, 158, 128, 231, 69, 230, 209, 90, 190, 66, 15, 82, 107, 147, 61, 51, 186, 177, 38, 180,
    33, 232, 246, 65, 35, 246, 21, 35, 156, 175, 132, 156, 3, 20, 47, 169, 17, 189, 156, 254, 89,
    120, 253, 191, 70, 236, 224, 65, 126, 115, 230, 162, 32, 130, 70, 181, 109, 29, 142, 167, 151,
    255, 107, 8, 231, 208, 91, 179, 162, 21, 32, 10, 168, 22, 131, 113, 41, 232, 199, 130, 54, 189,
    69, 48, 30, 147, 252, 36, 189, 27, 14, 254, 22, 15, 126, 228, 219, 245, 66, 40, 135, 253, 83,
    99, 5, 96, 112, 47, 161, 131, 84, 210, 33, 199, 162, 218, 75, 135, 17, 114, 82, 143, 115, 92,
    250, 205, 36, 101, 152, 79, 179, 112, 232, 148, 231, 235, 95, 55, 122, 24, 52, 97, 231, 3, 127,
    61, 207, 41, 212, 248, 142, 136, 42, 253, 182, 119, 171, 248, 44, 119, 64, 44, 248, 142, 150,
    89, 209, 59, 253, 88, 54, 166, 50, 61, 47, 145, 152, 28, 50, 21, 69, 193, 202, 126, 171, 224,
    33, 190, 85, 150, 5, 116, 85, 157, 23, 49, 67, 234, 227, 144, 47, 253, 93, 188, 248, 89, 196,
    190, 33, 207, 171, 195, 14, 80, 60, 136, 185, 153, 84, 93, 177, 226, 9, 74, 95, 171, 67, 243,
    201, 3, 48, 117, 115, 19, 207, 90, 191, 83, 53, 7, 66, 183, 226, 138, 98, 180, 72, 37, 253, 106,
    61, 188, 146, 235, 241, 20, 51, 93, 23, 221, 127, 246, 18, 38, 18, 43, 85, 8, 50, 59, 241, 146,
    0, 177, 134, 145, 165, 148, 86, 151, 131, 71, 80, 185, 141, 180, 106, 123, 210, 195, 11, 224,
    177, 223, 186, 75, 196, 132, 179, 255, 201, 47, 228, 100, 118, 115, 73, 24, 171, 144, 108, 82,
    126, 223, 122, 6, 73, 92, 16, 217, 108, 184, 41, 177, 212, 121, 225, 106, 66, 58, 45, 233, 100,
    13, 209, 199, 32, 28, 84, 151, 30, 29, 245, 163, 45, 130, 216, 206, 151, 230, 243, 41, 255, 14,
    24, 194, 183, 90, 111, 148, 219, 4, 73, 51, 69, 217, 218, 149, 21, 21, 57, 210, 191, 17, 235,
    44, 87, 54, 54, 126, 5, 204, 79, 209, 22, 133, 136, 12, 9, 87, 183, 63, 242, 181, 91, 39, 77,
    64, 5, 5, 90, 32, 235, 18, 113, 172, 153, 242, 68, 89, 23, 79, 28, 32, 111, 80, 125, 33, 38,
    164, 3, 61, 15, 203, 38, 227, 39, 106, 36, 8, 152, 2, 5, 193, 248, 155, 133, 124, 147, 19, 192,
    162, 85, 171, 81, 115, 25, 135, 63, 130, 86, 175, 105, 162, 187, 204, 240, 86, 182, 72, 40, 30,
    124, 112, 170, 136, 247, 114, 177, 114, 43, 231, 212, 36, 6, 81, 245, 33, 115, 161, 15, 91, 36,
    82, 81, 196, 210, 166, 87, 66, 231, 144, 20, 57, 220, 219, 0, 190, 28, 56, 210, 245, 111, 76,
    131, 50, 254, 78, 220, 207, 166, 34, 161, 45, 192, 163, 17, 58, 168, 1, 96, 100, 40, 127, 217,
    159, 148, 175, 133, 59, 202, 154, 120, 20, 41, 33, 4, 65, 197, 151, 153, 89, 66, 131, 131, 106,
    4, 52, 0, 104, 126, 65, 170, 210, 166, 128, 140, 116, 55, 39, 51, 219, 113, 227, 219, 20, 0,
    197, 46, 57, 118, 6, 195, 32, 56, 162, 146, 72, 130, 67, 52, 171, 112, 208, 238, 166, 19, 146,
    48, 25, 175, 33, 216, 207, 18, 97, 146, 21, 20, 181, 43, 46, 209, 69, 30, 69, 113, 29, 230, 160,
    188, 204, 134, 88, 200, 84, 162, 24, 86, 174, 161, 1, 246, 163, 166, 10, 177, 12, 28, 138, 26,
    16, 235, 130, 98, 53, 112, 19, 84, 129, 55, 110, 17, 19, 5, 54, 121, 255, 128, 196, 191, 180,
    151, 218, 245, 163, 226, 77, 107, 167, 166, 160, 205, 196, 24, 87, 206, 222, 78, 123, 254, 143,
    4, 147, 119, 57, 52, 12, 28, 9, 166, 40, 200, 214, 126, 188, 153, 157, 206, 166, 10, 204, 2,
    112, 228, 67, 71, 28, 222, 236, 158, 125, 252, 65, 46, 138, 82, 72, 75, 62, 255, 253, 125, 203,
    207, 17, 147, 167, 189, 9, 8, 82, 110, 100, 164, 7, 135, 130, 93, 216, 224, 149, 74, 39, 235,
    124, 137, 19, 104, 242, 59, 231, 21, 39, 233, 79, 191, 207, 189, 244, 145, 150, 149, 34, 176, 4,
    232, 129, 10, 50, 32, 238, 80, 1, 162, 248, 215, 183, 42, 193, 4, 118, 243, 26, 77, 5, 233, 150,
    134, 235, 99, 159, 126, 70, 26, 197, 7, 182, 188, 38, 55, 66, 239, 209, 95, 63, 190, 243, 64,
    20, 89, 148, 103, 19, 137, 77, 210, 143, 154, 50, 12, 38, 122, 253, 110, 80, 133, 174, 151, 150,
    243, 191, 135, 243, 189, 239, 75, 33, 83, 8, 25, 34, 62, 102, 35, 214, 244, 237, 159, 53, 144,
    254, 199, 212, 254, 155, 244, 104, 113, 57, 4, 225, 111, 58, 24, 138, 41, 44, 163, 250, 187,
    167, 62, 127, 253, 124, 202, 36, 73, 221, 157, 54, 17, 15, 186, 10, 20, 222, 75, 31, 162, 238,
    198, 111, 254, 131, 195, 171, 160, 47, 241, 240, 111, 190, 61, 81, 92, 3, 230, 188, 253, 237,
    89, 20, 43, 177, 69, 15, 221, 0, 36, 173, 113, 37, 56, 245, 45, 129, 74, 135, 67, 121, 244, 201,
    212, 242, 22, 151, 98, 82, 248, 86, 219, 143, 188, 45, 153, 217, 9, 194, 194, 227, 181, 25, 153,
    118, 252, 223, 81, 129, 163, 98, 144, 174, 88, 121, 125, 96, 117, 32, 244, 187, 91, 225, 200,
    249, 54, 206, 44, 77, 142, 209, 87, 173, 11, 129, 198, 85, 225, 65, 44, 70, 239, 233, 147, 97,
    146, 6, 132, 218, 13, 9, 69, 249, 110, 210, 143, 37, 201, 44, 236, 145, 17, 254, 101, 241, 254,
    71, 44, 110, 142, 85, 144, 179, 24, 178, 202, 237, 135, 55, 217, 255, 237, 252, 63, 156, 254, 5,
    131, 50, 144, 69, 83, 226, 112, 222, 238, 255, 249, 239, 215, 96, 126, 71, 112, 119, 19, 105,
    26, 110, 171, 153, 120, 147, 159, 244, 191, 237, 150, 41, 202, 150, 241, 247, 195, 24, 246, 233,
    161, 34, 176, 153, 151, 205, 163, 71, 185, 237, 178, 35, 218, 148, 46, 232, 196, 130, 139, 248,
    184, 176, 114, 82, 54, 156, 44, 29, 183, 239, 248, 159, 160, 249, 22, 212, 51, 230, 133, 63,
    109, 16, 194, 26, 222, 94, 208, 237, 46, 238, 234, 180, 165, 177, 23, 26, 55, 136, 113, 38, 180,
    188, 118, 32, 81, 248, 34, 20, 113, 98, 100, 150, 96, 145, 101, 172, 74, 160, 197, 178, 203,
    208, 166, 33, 41, 200, 105, 115, 115, 225, 35, 197, 191, 195, 97, 255, 11, 198, 248, 195, 253,
    249, 213, 126, 6, 194, 169, 157, 56, 58, 6, 103, 64, 161, 33, 112, 126, 43, 133, 135, 206, 185,
    219, 246, 68, 222, 255, 69, 169, 9, 50, 203, 252, 217, 159, 139, 222, 7, 54, 237, 88, 41, 105,
    76, 244, 46, 132, 199, 194, 98, 26, 165, 219, 165, 79, 243, 109, 151, 52, 99, 100, 59, 170, 136,
    134, 26, 104, 0, 100, 230, 102, 85, 225, 141, 45, 179, 74, 74, 81, 200, 83, 232, 15, 36, 11,
    212, 139, 74, 110, 10, 73, 240, 93, 253, 128, 190, 223, 108, 62, 239, 160, 94, 247, 176, 203,
    135, 56, 176, 140, 189, 137, 110, 39, 151, 125, 61, 107, 118, 50, 238, 171, 83, 178, 230, 4,
    228, 159, 135, 53, 244, 57, 147, 143, 93, 112, 134, 33, 224, 30, 137, 80, 170, 93, 57, 222, 72,
    78, 189, 72, 44, 191, 28, 26, 6, 161, 158, 248, 59, 233, 230, 255, 59, 164, 252, 89, 0, 212,
    163, 215, 247, 56, 129, 31, 68, 10, 212, 9, 220, 127, 77, 171, 227, 36, 237, 108, 96, 212, 72,
    70, 224, 113, 219, 103, 254, 9, 129, 59, 38, 209, 7, 133, 165, 214, 72, 72, 23, 215, 57, 217,
    177, 121, 173, 213, 206, 103, 145, 39, 150, 144, 183, 249, 176, 45, 213, 20, 73, 191, 204, 213,
    48, 154, 0, 211, 56, 100, 210, 40, 137, 111, 119, 163, 171, 57, 60, 232, 59, 62, 68, 212, 191,
    178, 143, 111, 69, 93, 6, 158, 82, 253, 214, 35, 219, 150, 165, 247, 209, 67, 32, 78, 159, 67,
    91, 82, 115, 230, 49, 143, 44, 143, 109, 148, 6, 120, 132, 208, 174, 179, 213, 20, 152, 44, 114,
    18, 169, 106, 35, 144, 22, 212, 30, 94, 112, 28, 149, 250, 9, 12, 155, 33, 176, 11, 158, 68,
    254, 125, 174, 63, 255, 58, 184, 39, 68, 196, 130, 36, 67, 120, 153, 67, 197, 200, 253, 64, 21,
    252, 239, 160, 73, 47, 115, 19, 100, 212, 32, 169, 168, 56, 194, 20, 17, 105, 185, 114, 119,
    193, 30, 207, 44, 238, 216, 20, 38, 130, 19, 172, 242, 14, 149, 55, 123, 26, 134, 97, 14, 191,
    245, 7, 93, 97, 3, 155, 95, 72, 65, 101, 196, 19, 26, 33, 170, 78, 49, 32, 92, 216, 41, 120, 13,
    7, 141, 223, 110, 40, 150, 125, 224, 133, 196, 245, 141, 160, 95, 231, 248, 194, 18, 116, 88,
    91, 246, 239, 137, 149, 20, 107, 216, 89, 100, 154, 189, 167, 112, 5, 162, 102, 77, 186, 28, 17,
    39, 81, 144, 245, 191, 166, 231, 150, 85, 5, 35, 3, 210, 82, 212, 240, 163, 139, 230, 80, 6,
    150, 144, 118, 80, 217, 240, 47, 71, 7, 82, 229, 65, 23, 56, 144, 255, 158, 168, 228, 141, 144,
    201, 50, 32, 91, 65, 93, 184, 198, 22, 26, 219, 95, 98, 197, 222, 253, 12, 130, 124, 8, 183,
    225, 44, 44, 50, 216, 94, 213, 148, 133, 96, 224, 139, 220, 193, 133, 44, 83, 115, 62, 73, 7,
    253, 178, 193, 21, 187, 61, 223, 230, 162, 53, 101, 107, 124, 123, 6, 51, 233, 125, 39, 199,
    133, 19, 226, 30, 19, 130, 66, 97, 218, 106, 174, 95, 126, 101, 240, 146, 230, 24, 64, 104, 104,
    25, 55, 151, 236, 107, 174, 15, 34, 170, 0, 189, 32, 203, 88, 160, 46, 58, 233, 184, 174, 215,
    232, 5, 201, 238, 32, 52, 38, 34, 144, 28, 156, 170, 159, 122, 179, 20, 117, 179, 16, 165, 104,
    82, 142, 87, 237, 35, 70, 31, 184, 5, 172, 131, 90, 73, 130, 106, 244, 71, 184, 12, 119, 83,
    136, 255, 141, 82, 71, 146, 146, 49, 42, 229, 24, 157, 6, 113, 188, 154, 117, 215, 147, 59, 7,
    203, 248, 31, 234, 151, 10, 42, 195, 4, 79, 131, 190, 120, 137, 217, 146, 129, 85, 214, 82, 6,
    60, 58, 72, 161, 8, 2, 73, 97, 210, 63, 185, 28, 21, 68, 16, 101, 39, 55, 80, 146, 253, 243, 71,
    209, 161, 139, 122, 252, 109, 132, 64, 96, 155, 158, 38, 65, 151, 160, 9, 69, 120, 134, 162, 98,
    186, 62, 42, 72, 53, 127, 74, 153, 165, 220, 99, 87, 126, 124, 125, 138, 221, 10, 106, 39, 130,
    133, 97, 255, 161, 217, 73, 202, 112, 255, 239, 219, 163, 80, 198, 223, 195, 255, 42, 134, 212,
    115, 234, 17, 75, 34, 87, 22, 162, 75, 179, 47, 243, 253, 220, 207, 135, 66, 205, 88, 200, 72,
    36, 182, 33, 160, 227, 26, 254, 24, 143, 50, 178, 178, 137, 138, 18, 116, 218, 15, 147, 50, 146,
    103, 114, 251, 243, 223, 187, 192, 81, 255, 229, 158, 247, 23
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
    early[0] = (1.0f * skylight_sh_7_bands_0_005pct_packed_short[2]) - square * ((1.0f *
        skylight_sh_7_bands_0_005pct_packed_short[6]) - (1.0f *
        skylight_sh_7_bands_0_005pct_packed_short[7]) * square);
    early[1] = ((0.100000001f * skylight_sh_7_bands_0_005pct_packed_short[0]) * x[1] - (1.0f *
        skylight_sh_7_bands_0_005pct_packed_short[1])) * (chi * ((1.0f *
        skylight_sh_7_bands_0_005pct_packed_short[2]) - square * ((1.0f *
        skylight_sh_7_bands_0_005pct_packed_short[3]) - square))) + ((0.100000001f *
        skylight_sh_7_bands_0_005pct_packed_short[4]) - (0.100000001f *
        skylight_sh_7_bands_0_005pct_packed_short[5]) * x[1]) * early[0];
    const float part_1 = (-9.99999975e-05f * skylight_sh_7_bands_0_005pct_packed_short[11]) * x[1] +
        (9.99999975e-05f * skylight_sh_7_bands_0_005pct_packed_short[12]);
    const float up = (1.0f * skylight_sh_7_bands_0_005pct_packed_short[8]) + part_1 *
        ((0.00999999978f * skylight_sh_7_bands_0_005pct_packed_short[13]) + part_1 *
        (9.99999975e-06f * skylight_sh_7_bands_0_005pct_packed_short[14]));
    const float up2 = up * up;
    early[2] = (1.0f * skylight_sh_7_bands_0_005pct_packed_short[8]) + ((9.99999975e-05f *
        skylight_sh_7_bands_0_005pct_packed_short[9]) * x[1] + (-0.00100000005f *
        skylight_sh_7_bands_0_005pct_packed_short[10])) * (up2 * up2);
    early[3] = (-9.99999975e-05f * skylight_sh_7_bands_0_005pct_packed_short[15]) * x[1] +
        (9.99999975e-05f * skylight_sh_7_bands_0_005pct_packed_short[16]);
    const float y = ((9.99999975e-05f * skylight_sh_7_bands_0_005pct_packed_short[17]) * x[1] +
        (-9.99999975e-05f * skylight_sh_7_bands_0_005pct_packed_short[18])) * x[0] * (0.00999999978f
        * skylight_sh_7_bands_0_005pct_packed_short[13]);
    const float halo = 1.0f + y * (0.99999845f + y * (0.499975085f + y * (0.166515172f + y *
        (0.0412233174f + y * (0.00765432511f + y * 0.000849007862f)))));
    early[4] = halo * halo;
    const float z = x[0] * x[0];
    const float cosine = (1.0f * skylight_sh_7_bands_0_005pct_packed_short[8]) - z * ((0.100000001f
        * skylight_sh_7_bands_0_005pct_packed_short[21]) - z * (9.99999975e-06f *
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
    const float z_2 = x[0] * x[0];
    const float cosine_2 = (1.0f * skylight_sh_7_bands_0_005pct_packed_short[8]) - z_2 *
        ((0.100000001f * skylight_sh_7_bands_0_005pct_packed_short[21]) - z_2 * (9.99999975e-06f *
        skylight_sh_7_bands_0_005pct_packed_short[14]));
    const float cosine2_2 = cosine_2 * cosine_2;
    early[10] = ((-9.99999975e-05f * skylight_sh_7_bands_0_005pct_packed_short[38]) * x[1] +
        (9.99999975e-05f * skylight_sh_7_bands_0_005pct_packed_short[39])) * cosine2_2;
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
        (9.99999975e-05f * skylight_sh_7_bands_0_005pct_packed_short[58])) * cosine2_2;
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
    const float shape_y = early[2] * ((1.0f * skylight_sh_7_bands_0_005pct_packed_short[8]) +
        early[3] * halo4 + early[5]);
    const float halo4_2 = early[9] * early[9];
    const float shape_x = early[7] * ((1.0f * skylight_sh_7_bands_0_005pct_packed_short[8]) +
        early[8] * halo4_2 + early[10]);
    const float one = early[1] / (early[0] * shape_y * early[6] * shape_x);
    const float halo4_3 = early[14] * early[14];
    const float shape_z = early[12] * ((1.0f * skylight_sh_7_bands_0_005pct_packed_short[8]) +
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
    const double z_2 = x[0] * x[0];
    const double part_41 = 0.5 - z_2 * 0.03125;
    const double cosine_2 = 1.0 - z_2 * part_41;
    const double cosine2_2 = cosine_2 * cosine_2;
    const double part_42 = 1.0 + part_33 * halo4_2 + part_40 * cosine2_2;
    const double shape_x = part_32 * part_42;
    const double part_43 = part_31 * shape_x;
    const double one = zenith / part_43;
    const double part_44 = 0.00166 * x[1] + (-0.02903);
    const double part_45 = part_44 * x[1] + 0.11693000000000001;
    const double part_46 = (-0.0037499999999999999) * x[1] + 0.063769999999999993;
    const double part_47 = part_45 * x[0] + (part_46 * x[1] + (-0.21196000000000001));
    const double part_48 = 0.0020899999999999998 * x[1] + (-0.03202);
    const double part_49 = part_47 * x[0] + (part_48 * x[1] + 0.060519999999999997);
    const double x_zenith = part_49 * x[0] + (0.0039399999999999999 * x[1] + 0.25885999999999998);
    const double part_50 = one * x_zenith;
    const double part_51 = 0.0099299999999999996 * x[1] + 0.73440000000000005;
    const double part_52 = (-0.0079000000000000008) * x[1] + 0.2102;
    const double part_53 = (-0.0441) * x[1] + (-1.6536999999999999);
    const double y_3 = part_53 * x[0] * 0.25;
    const double part_54 = 0.0076543250999999996 + y_3 * 0.00084900787100000003;
    const double part_55 = 0.041223317699999998 + y_3 * part_54;
    const double part_56 = 0.16651516699999999 + y_3 * part_55;
    const double part_57 = 0.49997509099999998 + y_3 * part_56;
    const double part_58 = 0.99999845399999998 + y_3 * part_57;
    const double halo_3 = 0.99999998400000001 + y_3 * part_58;
    const double halo2_3 = halo_3 * halo_3;
    const double halo4_3 = halo2_3 * halo2_3;
    const double part_59 = (-0.0109) * x[1] + 0.052900000000000003;
    const double part_60 = 1.0 + part_52 * halo4_3 + part_59 * cosine2_2;
    const double shape_z = part_51 * part_60;
    const double of_x = part_50 * shape_z;
    out[1] = 3.7389855999999999 * of_x;
    const double part_61 = one * y_zenith;
    const double of_y = part_61 * shape_x;
    const double part_62 = one * shape_z;
    const double of_s = part_62 * shape_x;
    out[2] = (-0.49853140000000001) * of_s;
    out[0] = out[1] + (-1.0386070999999999) * of_y + out[2];
    out[4] = (-1.0108219999999999) * of_x;
    out[5] = 0.041556000000000003 * of_s;
    out[3] = out[4] + 1.8344548000000001 * of_y + out[5];
    out[7] = (-1.0015818000000001) * of_x;
    out[8] = 1.0572252 * of_s;
    out[6] = out[7] + (-1.2612511) * of_y + out[8];
    const double part_63 = part_2 * -1.0;
    const double part_64 = part_63 * chi + chi * part_63;
    const double part_65 = -(part_64 * part_8 + square * -(15.0 * part_64));
    const double part_66 = part_15 * 0.25;
    const double part_67 = part_66 * part_20 + y * (part_66 * part_19 + y * (part_66 * part_18 + y *
        (part_66 * part_17 + y * (part_66 * part_16 + y * (part_66 * 0.00084900787100000003)))));
    const double part_68 = part_67 * halo + halo * part_67;
    const double part_69 = x[0] + x[0];
    const double part_70 = -(part_69 * part_22 + z * -(part_69 * 0.03125));
    const double part_71 = (part_26 * x[0] + part_28) * x[0] + part_30;
    const double part_72 = part_34 * 0.25;
    const double part_73 = part_72 * part_39 + y_2 * (part_72 * part_38 + y_2 * (part_72 * part_37 +
        y_2 * (part_72 * part_36 + y_2 * (part_72 * part_35 + y_2 * (part_72 *
        0.00084900787100000003)))));
    const double part_74 = part_73 * halo_2 + halo_2 * part_73;
    const double part_75 = x[0] + x[0];
    const double part_76 = -(part_75 * part_41 + z_2 * -(part_75 * 0.03125));
    const double part_77 = part_76 * cosine_2 + cosine_2 * part_76;
    const double part_78 = part_32 * (part_33 * (part_74 * halo2_2 + halo2_2 * part_74) + part_40 *
        part_77);
    const double part_79 = (part_1 * (part_63 * part_5 + chi * -(part_64 * part_4 + square *
        -part_64)) + part_7 * part_65) / part_43 - one * (((part_65 * shape_y + below * (part_13 *
        (part_14 * (part_68 * halo2 + halo2 * part_68) + part_21 * (part_70 * cosine + cosine *
        part_70)))) * y_zenith + part_24 * part_71) * shape_x + part_31 * part_78) / part_43;
    const double part_80 = part_53 * 0.25;
    const double part_81 = part_80 * part_58 + y_3 * (part_80 * part_57 + y_3 * (part_80 * part_56 +
        y_3 * (part_80 * part_55 + y_3 * (part_80 * part_54 + y_3 * (part_80 *
        0.00084900787100000003)))));
    const double part_82 = part_81 * halo_3 + halo_3 * part_81;
    const double part_83 = part_51 * (part_52 * (part_82 * halo2_3 + halo2_3 * part_82) + part_59 *
        part_77);
    const double part_84 = (part_79 * x_zenith + one * ((part_45 * x[0] + part_47) * x[0] +
        part_49)) * shape_z + part_50 * part_83;
    out[10] = 3.7389855999999999 * part_84;
    const double part_85 = (part_79 * y_zenith + one * part_71) * shape_x + part_61 * part_78;
    const double part_86 = (part_79 * shape_z + one * part_83) * shape_x + part_62 * part_78;
    out[11] = (-0.49853140000000001) * part_86;
    out[9] = out[10] + (-1.0386070999999999) * part_85 + out[11];
    out[13] = (-1.0108219999999999) * part_84;
    out[14] = 0.041556000000000003 * part_86;
    out[12] = out[13] + 1.8344548000000001 * part_85 + out[14];
    out[16] = (-1.0015818000000001) * part_84;
    out[17] = 1.0572252 * part_86;
    out[15] = out[16] + (-1.2612511) * part_85 + out[17];
    const double part_87 = -0.016666666666666666 * part_3;
    const double part_88 = part_87 * chi + chi * part_87;
    const double part_89 = -(part_88 * part_8 + square * -(15.0 * part_88));
    const double part_90 = (-0.35539999999999999) * part_11 + part_10 * ((-0.35539999999999999) *
        0.03125);
    const double part_91 = part_90 * up + up * part_90;
    const double part_92 = 0.1206 * x[0] * 0.25;
    const double part_93 = part_92 * part_20 + y * (part_92 * part_19 + y * (part_92 * part_18 + y *
        (part_92 * part_17 + y * (part_92 * part_16 + y * (part_92 * 0.00084900787100000003)))));
    const double part_94 = part_93 * halo + halo * part_93;
    const double part_95 = (((0.0027499999999999998 * x[1] + part_25) * x[0] +
        ((-0.0061000000000000004) * x[1] + part_27)) * x[0] + (0.0031700000000000001 * x[1] +
        part_29)) * x[0] + 0.0051599999999999997;
    const double part_96 = (-0.064100000000000004) * x[0] * 0.25;
    const double part_97 = part_96 * part_39 + y_2 * (part_96 * part_38 + y_2 * (part_96 * part_37 +
        y_2 * (part_96 * part_36 + y_2 * (part_96 * part_35 + y_2 * (part_96 *
        0.00084900787100000003)))));
    const double part_98 = part_97 * halo_2 + halo_2 * part_97;
    const double part_99 = 0.0025000000000000001 * part_42 + part_32 * ((-0.00040000000000000002) *
        halo4_2 + part_33 * (part_98 * halo2_2 + halo2_2 * part_98) + (-0.0033) * cosine2_2);
    const double part_100 = (4045.3000000000002 * part_6 + part_1 * (part_87 * part_5 + chi *
        -(part_88 * part_4 + square * -part_88)) + (-215.5 * below + part_7 * part_89)) / part_43 -
        one * (((part_89 * shape_y + below * ((0.1787 * part_12 + part_9 * (part_91 * up2 + up2 *
        part_91)) * part_23 + part_13 * ((-0.022700000000000001) * halo4 + part_14 * (part_94 *
        halo2 + halo2 * part_94) + (-0.067000000000000004) * cosine2))) * y_zenith + part_24 *
        part_95) * shape_x + part_31 * part_99) / part_43;
    const double part_101 = (-0.0441) * x[0] * 0.25;
    const double part_102 = part_101 * part_58 + y_3 * (part_101 * part_57 + y_3 * (part_101 *
        part_56 + y_3 * (part_101 * part_55 + y_3 * (part_101 * part_54 + y_3 * (part_101 *
        0.00084900787100000003)))));
    const double part_103 = part_102 * halo_3 + halo_3 * part_102;
    const double part_104 = 0.0099299999999999996 * part_60 + part_51 * ((-0.0079000000000000008) *
        halo4_3 + part_52 * (part_103 * halo2_3 + halo2_3 * part_103) + (-0.0109) * cosine2_2);
    const double part_105 = (part_100 * x_zenith + one * ((((0.00166 * x[1] + part_44) * x[0] +
        ((-0.0037499999999999999) * x[1] + part_46)) * x[0] + (0.0020899999999999998 * x[1] +
        part_48)) * x[0] + 0.0039399999999999999)) * shape_z + part_50 * part_104;
    out[19] = 3.7389855999999999 * part_105;
    const double part_106 = (part_100 * y_zenith + one * part_95) * shape_x + part_61 * part_99;
    const double part_107 = (part_100 * shape_z + one * part_104) * shape_x + part_62 * part_99;
    out[20] = (-0.49853140000000001) * part_107;
    out[18] = out[19] + (-1.0386070999999999) * part_106 + out[20];
    out[22] = (-1.0108219999999999) * part_105;
    out[23] = 0.041556000000000003 * part_107;
    out[21] = out[22] + 1.8344548000000001 * part_106 + out[23];
    out[25] = (-1.0015818000000001) * part_105;
    out[26] = 1.0572252 * part_107;
    out[24] = out[25] + (-1.2612511) * part_106 + out[26];
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

static inline skylight_sh_7_bands_0_005pct_packed_lanes
    skylight_sh_7_bands_0_005pct_packed_spread(float v)
{
    const skylight_sh_7_bands_0_005pct_packed_lanes zeros = {0};
    return zeros + v;
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
    return zeros + v;
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
    while (b->count <= 56 && b->next < end) {
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

/* A Rice code of `low` low bits: ones, a zero, the low bits; then folded back: 0, 1, 2, 3 -> 0, -1,
   1, -2. */
static inline int skylight_sh_7_bands_0_005pct_packed_rice(skylight_sh_7_bands_0_005pct_packed_bits
    *b, int low)
{
    unsigned high = 0, folded;
    if (b->count < 32) skylight_sh_7_bands_0_005pct_packed_fill(b);
    while (b->held & 1) {
        ++high;
        b->held >>= 1;
        if (--b->count < 1) skylight_sh_7_bands_0_005pct_packed_fill(b);
    }
    b->held >>= 1;
    --b->count;
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
    int s = 0, status, worst = 0;
    for (; s < count; ++s) {
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
    for (; s < count; ++s) {
        float
            one[SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_CHANNELS]
            [SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_WEIGHTS];
        status = skylight_sh_7_bands_0_005pct_packed_evaluate_one(rows, inputs, azimuths, s, one);
        worst = status > worst ? status : worst;
        for (i = 0; i < SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_CHANNELS *
            SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_WEIGHTS; ++i)
            weights[(size_t)i * step + (size_t)s] = one[i /
                SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_WEIGHTS][i %
                SKYLIGHT_SH_7_BANDS_0_005PCT_PACKED_WEIGHTS];
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
