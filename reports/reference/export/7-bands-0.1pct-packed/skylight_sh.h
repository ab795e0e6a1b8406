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
 * Accuracy, as shipped: E_mean 0.0963 %, E_max 0.44 % of the least luminance of the same sky, at
 * azimuth 0.
 * The expansion rings: the least value it takes, over all directions and measured sets, is -12.7 %
 * of its largest in the same set; the window below tames it.
 * Memory: 2303 bytes of constants, packed into few bytes (a fast table takes more and less time).
 *
 * Provenance
 *   skylight-sh 0.1.0, config preetham 08540d17388f71b0, table 7-bands-0.1pct-packed
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
#define SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_H 0xcae3049f

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
#define SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_E_MEAN 9.633000e-04
#define SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_E_MAX 4.397000e-03
#define SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_UNPACKED 2692
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
/* Evaluates `count` suns from arrays; returns the largest status. Unpacks
   the table once, SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_UNPACKED floats on the stack. */
SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_API int skylight_sh_7_bands_0_1pct_packed_weights_batch(int count,
    const float *sun_zenith, const float *sun_azimuth, const float *turbidity,
    float
    (*weights)[SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_CHANNELS]
    [SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_WEIGHTS]);
/* The same with the suns of each weight side by side:
   [SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_CHANNELS][SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_WEIGHTS][count].
       */
SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_API int skylight_sh_7_bands_0_1pct_packed_weights_columns(int
    count, const float *sun_zenith, const float *sun_azimuth, const float *turbidity,
    float *weights);
/* Evaluates all bands and their derivatives after each axis (sun_zenith,
   turbidity), per unit of the axis; beyond a range, those at its edge. */
SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_API int skylight_sh_7_bands_0_1pct_packed_weights_gradient(float
    sun_zenith, float sun_azimuth, float turbidity,
    float
    weights[SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_CHANNELS][SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_WEIGHTS],
    float
    gradient[SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_AXES][SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_CHANNELS]
    [SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_WEIGHTS]);
/* Unpacks the table into memory of the caller's, SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_UNPACKED
   floats, for the calls below. */
SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_API void skylight_sh_7_bands_0_1pct_packed_unpack(float
    memory[SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_UNPACKED]);
/* Evaluates all bands of an unpacked table: far faster than of the packed
   one. */
SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_API int skylight_sh_7_bands_0_1pct_packed_unpacked_weights(const
    float memory[SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_UNPACKED], float sun_zenith, float sun_azimuth,
    float turbidity, float
    weights[SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_CHANNELS][SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_WEIGHTS]);
/* The same for the first `bands` bands. */
SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_API int
    skylight_sh_7_bands_0_1pct_packed_unpacked_weights_bands(const float
    memory[SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_UNPACKED], float sun_zenith, float sun_azimuth,
    float turbidity, int bands, float
    weights[SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_CHANNELS][SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_WEIGHTS]);
/* The same for `count` suns from arrays; returns the largest status. */
SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_API int
    skylight_sh_7_bands_0_1pct_packed_unpacked_weights_batch(const float
    memory[SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_UNPACKED], int count, const float *sun_zenith,
    const float *sun_azimuth, const float *turbidity,
    float
    (*weights)[SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_CHANNELS]
    [SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_WEIGHTS]);
/* The same as
 * [SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_CHANNELS][SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_WEIGHTS][count].
 * */
SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_API int
    skylight_sh_7_bands_0_1pct_packed_unpacked_weights_columns(const float
    memory[SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_UNPACKED], int count, const float *sun_zenith,
    const float *sun_azimuth, const float *turbidity, float *weights);
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

#elif SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_H != 0xcae3049f
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
#define SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_SIZES { 11, 7 }
#define SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_MOST 12
#define SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_AZIMUTH 0.0f
/* The axis of the sun's zenith angle. */
#define SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_SUN 0
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

/* Classes; a row's numbers, one a sum, and those of the first 1, 2, ..
   bands; room for a class's sums. */
#define SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_CLASSES 3
#define SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_OTHER_CLASSES(CLASS) CLASS(1) CLASS(2)
#define SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_FACTORS 9
#define SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_WIDTH 28
#define SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_WIDTHS { 1, 3, 6, 10, 15, 21, 28 }
#define SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_ROOM 32
/* All rows; of each class the first row, how many, and the place of its
   first product. */
#define SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_TERMS 96
#define SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_STARTS { 0, 41, 67 }
#define SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_COUNTS { 41, 26, 29 }
#define SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_PLACES { 0, 44, 72 }
#define SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_PRODUCTS_ROOM 108
/* Of each class and product of the other axes' functions: how many
   functions of the first axis it has. */
#define SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_LENGTHS { { 11, 8, 8, 7, 4, 2, 1 }, { 7, 7, 6, 4, 2, 0, \
    0 }, { 9, 8, 6, 4, 2, 0, 0 } }
/* The same: of each that has any, class, place of the first product, how
   many, the other axes' product. */
#define SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_PRODUCTS(PRODUCT) \
    PRODUCT(0, 0, 11, 0) \
    PRODUCT(0, 11, 8, 1) \
    PRODUCT(0, 19, 8, 2) \
    PRODUCT(0, 27, 7, 3) \
    PRODUCT(0, 34, 4, 4) \
    PRODUCT(0, 38, 2, 5) \
    PRODUCT(0, 40, 1, 6) \
    PRODUCT(1, 44, 7, 0) \
    PRODUCT(1, 51, 7, 1) \
    PRODUCT(1, 58, 6, 2) \
    PRODUCT(1, 64, 4, 3) \
    PRODUCT(1, 68, 2, 4) \
    PRODUCT(2, 72, 9, 0) \
    PRODUCT(2, 81, 8, 1) \
    PRODUCT(2, 89, 6, 2) \
    PRODUCT(2, 95, 4, 3) \
    PRODUCT(2, 99, 2, 4)
/* Where sums go: of each degree, the first column, or -1 where it carries
   nothing. */
#define SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_COLUMNS { 0, 1, 3, 6, 10, 15, 21 }
/* The same for vectors of four: places, two vectors of sums and the numbers
   of both, order. */
#define SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_FOURS 7
#define SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_STORES(BAND, NOTHING, MINUS, PLUS) \
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
#define SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_RUNS 7
#define SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_RUN_PROFILE { 5, 3, -1, -7, -14, -17, -20 }
#define SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_CLASS_PROFILE { -5, -12, -10 }
#define SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_STEP 4.10079956e-05f

/* Whole numbers as Rice codes. */
static const unsigned char skylight_sh_7_bands_0_1pct_packed_stream[2033] = {
    199, 227, 250, 86, 42, 255, 191, 243, 101, 111, 40, 23, 120, 129, 112, 148, 255, 191, 188, 236,
    151, 7, 114, 231, 49, 245, 127, 22, 151, 180, 40, 171, 245, 63, 110, 201, 27, 247, 47, 118, 185,
    199, 235, 127, 108, 225, 218, 138, 232, 255, 41, 137, 210, 191, 184, 159, 154, 88, 245, 99, 32,
    254, 127, 7, 76, 95, 241, 121, 60, 138, 213, 255, 64, 255, 46, 50, 183, 247, 255, 186, 151, 169,
    175, 253, 248, 232, 49, 136, 235, 250, 214, 57, 164, 159, 175, 183, 245, 31, 16, 227, 225, 214,
    211, 63, 139, 218, 9, 228, 116, 90, 139, 195, 171, 215, 30, 131, 19, 115, 153, 117, 230, 138,
    90, 24, 167, 155, 224, 196, 95, 229, 10, 99, 175, 143, 0, 36, 96, 232, 159, 40, 110, 136, 249,
    121, 221, 157, 168, 11, 57, 210, 218, 115, 175, 108, 166, 7, 38, 54, 120, 103, 95, 22, 10, 175,
    163, 181, 130, 231, 20, 203, 136, 22, 84, 236, 30, 196, 183, 178, 222, 24, 201, 182, 189, 177,
    68, 94, 238, 27, 86, 22, 182, 161, 99, 185, 140, 113, 191, 153, 41, 166, 238, 218, 183, 44, 21,
    45, 147, 247, 133, 81, 206, 42, 156, 229, 207, 132, 221, 160, 102, 100, 224, 221, 23, 54, 172,
    157, 253, 22, 209, 158, 32, 109, 109, 99, 75, 7, 8, 246, 235, 37, 232, 71, 81, 76, 189, 181,
    230, 208, 126, 213, 49, 12, 175, 233, 134, 224, 177, 236, 168, 156, 153, 219, 25, 213, 63, 10,
    83, 67, 109, 155, 54, 164, 72, 169, 153, 247, 244, 20, 78, 173, 203, 78, 216, 108, 59, 19, 158,
    158, 10, 47, 180, 119, 185, 57, 123, 54, 237, 101, 198, 230, 97, 106, 88, 16, 76, 173, 184, 216,
    72, 63, 131, 127, 191, 23, 254, 18, 70, 3, 233, 137, 193, 54, 43, 67, 137, 26, 190, 181, 16,
    241, 42, 118, 96, 70, 148, 167, 202, 55, 78, 110, 84, 82, 247, 159, 88, 177, 205, 192, 85, 64,
    4, 87, 134, 85, 46, 203, 47, 222, 81, 156, 90, 65, 179, 182, 149, 198, 232, 154, 140, 208, 247,
    51, 35, 136, 5, 200, 2, 133, 103, 228, 61, 111, 166, 40, 183, 158, 194, 96, 209, 32, 227, 240,
    150, 30, 74, 153, 72, 119, 213, 138, 72, 140, 122, 69, 3, 102, 247, 143, 85, 150, 69, 152, 43,
    4, 138, 213, 204, 72, 104, 234, 250, 45, 163, 177, 210, 164, 165, 49, 255, 236, 163, 244, 71,
    83, 221, 16, 1, 75, 14, 127, 29, 71, 178, 70, 201, 240, 206, 43, 36, 173, 173, 116, 233, 0, 113,
    223, 245, 218, 252, 249, 33, 230, 93, 242, 227, 152, 162, 170, 132, 142, 159, 27, 79, 206, 203,
    67, 142, 47, 119, 74, 176, 110, 67, 105, 143, 219, 154, 156, 68, 106, 179, 6, 171, 38, 130, 118,
    246, 232, 5, 178, 170, 236, 209, 234, 109, 254, 20, 201, 178, 3, 152, 222, 113, 156, 239, 131,
    93, 80, 230, 198, 185, 21, 220, 144, 13, 237, 107, 17, 177, 24, 249, 75, 227, 31, 155, 176, 115,
    223, 149, 54, 216, 219, 213, 158, 110, 43, 146, 198, 168, 205, 6, 195, 86, 28, 131, 245, 76, 85,
    156, 12, 167, 102, 164, 236, 77, 116, 23, 7, 237, 139, 63, 53, 202, 144, 150, 159, 228, 197,
    251, 188, 29, 123, 6, 200, 20, 245, 87, 233, 121, 154, 151, 98, 193, 247, 31, 102, 21, 12, 168,
    76, 9, 249, 82, 122, 156, 113, 243, 145, 132, 24, 166, 99, 86, 26, 92, 208, 6, 16, 22, 97, 217,
    234, 8, 33, 27, 122, 115, 146, 225, 109, 193, 153, 10, 163, 249, 16, 23, 209, 50, 71, 222, 151,
    197, 197, 58, 165, 205, 102, 199, 234, 69, 34, 240, 229, 68, 100, 93, 81, 131, 135, 32, 101, 63,
    209, 241, 52, 96, 94, 46, 61, 35, 111, 132, 205, 137, 19, 115, 111, 41, 208, 36, 195, 158, 122,
    18, 56, 4, 97, 69, 25, 27, 104, 224, 92, 18, 13, 141, 232, 135, 25, 99, 208, 27, 0, 163, 152, 6,
    64, 164, 162, 216, 191, 82, 85, 133, 100, 199, 218, 79, 182, 177, 13, 69, 121, 217, 4, 21, 174,
    186, 103, 176, 72, 190, 50, 84, 120, 71, 210, 216, 74, 183, 206, 32, 199, 195, 209, 173, 163,
    246, 127, 195, 158, 62, 199, 122, 161, 186, 51, 145, 191, 135, 79, 173, 107, 201, 130, 84, 227,
    143, 89, 215, 112, 248, 165, 225, 238, 123, 71, 144, 201, 194, 182, 179, 155, 51, 214, 164, 95,
    228, 195, 90, 179, 239, 183, 138, 129, 155, 125, 103, 209, 103, 127, 176, 44, 244, 250, 32, 22,
    120, 247, 32, 44, 195, 189, 138, 183, 204, 164, 254, 221, 252, 63, 169, 125, 133, 221, 65, 76,
    80, 248, 189, 243, 89, 250, 237, 77, 11, 105, 104, 184, 47, 250, 132, 180, 219, 96, 94, 247,
    225, 125, 62, 74, 102, 47, 32, 107, 109, 152, 176, 87, 254, 176, 30, 37, 123, 227, 211, 125,
    243, 235, 9, 197, 191, 193, 53, 92, 245, 81, 92, 242, 59, 215, 210, 62, 85, 19, 148, 224, 121,
    91, 133, 17, 178, 229, 127, 223, 253, 16, 67, 166, 103, 165, 116, 145, 251, 43, 201, 68, 238,
    220, 11, 163, 214, 58, 127, 229, 91, 210, 228, 227, 123, 131, 20, 50, 63, 202, 134, 246, 32, 3,
    249, 21, 102, 101, 121, 73, 175, 31, 20, 175, 188, 197, 178, 53, 107, 56, 222, 233, 249, 73, 14,
    13, 22, 197, 99, 166, 44, 68, 82, 98, 142, 27, 91, 190, 11, 37, 15, 46, 33, 137, 130, 142, 77,
    135, 243, 96, 116, 114, 85, 52, 12, 66, 172, 46, 39, 145, 209, 161, 25, 200, 17, 166, 222, 200,
    52, 91, 234, 85, 101, 138, 89, 254, 154, 139, 98, 31, 57, 31, 140, 84, 85, 141, 147, 147, 61,
    100, 171, 37, 64, 132, 108, 131, 23, 252, 210, 121, 102, 208, 74, 165, 101, 176, 230, 198, 104,
    147, 5, 227, 132, 26, 201, 84, 130, 164, 145, 150, 201, 33, 161, 72, 229, 48, 57, 6, 22, 14, 30,
    195, 36, 23, 60, 189, 187, 78, 9, 162, 134, 194, 170, 72, 113, 252, 211, 72, 186, 211, 136, 42,
    163, 90, 189, 225, 209, 108, 113, 15, 137, 6, 133, 177, 165, 112, 37, 34, 196, 253, 225, 94, 84,
    137, 163, 239, 213, 63, 145, 47, 217, 217, 139, 85, 133, 223, 154, 61, 224, 191, 196, 60, 121,
    165, 244, 53, 202, 237, 57, 123, 50, 183, 199, 251, 221, 75, 64, 25, 134, 143, 136, 84, 199,
    206, 174, 89, 63, 189, 167, 120, 112, 249, 17, 132, 141, 233, 82, 98, 57, 253, 23, 250, 138,
    165, 165, 160, 181, 53, 78, 131, 154, 150, 235, 15, 168, 29, 146, 157, 157, 198, 31, 170, 254,
    10, 57, 192, 9, 8, 253, 214, 248, 71, 227, 235, 240, 116, 235, 34, 246, 18, 116, 189, 167, 43,
    223, 163, 98, 196, 210, 228, 122, 238, 64, 106, 84, 161, 100, 184, 94, 114, 159, 147, 239, 66,
    38, 212, 250, 228, 203, 121, 214, 9, 246, 104, 111, 156, 79, 112, 108, 93, 5, 107, 220, 52, 2,
    220, 18, 97, 152, 172, 169, 145, 49, 236, 251, 183, 2, 127, 152, 93, 145, 22, 57, 18, 55, 190,
    190, 79, 60, 100, 22, 50, 70, 76, 240, 147, 117, 207, 217, 232, 182, 165, 131, 234, 147, 181,
    76, 169, 55, 183, 92, 166, 160, 134, 239, 240, 28, 17, 202, 120, 239, 195, 102, 234, 65, 163,
    149, 169, 229, 52, 154, 139, 3, 204, 170, 35, 102, 88, 85, 108, 195, 169, 82, 129, 216, 89, 223,
    111, 156, 78, 73, 180, 178, 99, 54, 116, 99, 228, 133, 99, 32, 233, 108, 133, 240, 22, 233, 100,
    20, 171, 66, 87, 18, 87, 194, 18, 50, 111, 190, 16, 20, 102, 20, 226, 114, 73, 52, 223, 236,
    155, 99, 99, 5, 67, 115, 226, 188, 212, 247, 96, 214, 78, 72, 170, 198, 108, 36, 242, 66, 44,
    132, 66, 124, 135, 189, 219, 80, 60, 192, 14, 35, 166, 64, 213, 27, 153, 139, 134, 141, 91, 175,
    35, 105, 194, 74, 201, 41, 192, 62, 137, 96, 226, 3, 3, 73, 99, 54, 155, 190, 76, 194, 108, 186,
    46, 185, 44, 180, 42, 12, 102, 37, 226, 21, 37, 229, 194, 100, 148, 1, 46, 176, 9, 11, 142, 127,
    9, 185, 47, 114, 66, 243, 24, 194, 221, 217, 12, 177, 188, 16, 30, 160, 176, 24, 203, 95, 192,
    40, 121, 40, 64, 4, 65, 230, 147, 24, 131, 194, 132, 72, 96, 36, 24, 166, 30, 217, 158, 114,
    154, 68, 97, 125, 215, 148, 49, 61, 148, 58, 127, 56, 169, 36, 197, 160, 48, 25, 104, 72, 176,
    48, 182, 20, 186, 116, 202, 16, 199, 40, 4, 164, 222, 237, 139, 255, 96, 191, 233, 152, 68, 33,
    128, 65, 84, 95, 159, 252, 45, 63, 255, 138, 47, 17, 178, 48, 111, 159, 216, 203, 69, 200, 65,
    159, 250, 160, 171, 93, 134, 90, 16, 148, 199, 216, 82, 212, 229, 62, 215, 47, 42, 184, 246,
    231, 58, 225, 73, 8, 24, 107, 153, 119, 217, 249, 187, 69, 131, 252, 156, 101, 158, 186, 78, 40,
    128, 216, 15, 32, 116, 226, 233, 202, 30, 24, 254, 141, 249, 127, 152, 11, 52, 163, 234, 190,
    118, 204, 189, 150, 127, 236, 11, 67, 228, 15, 106, 75, 122, 164, 95, 193, 79, 89, 105, 139,
    147, 251, 108, 7, 139, 228, 33, 27, 66, 181, 199, 212, 180, 49, 47, 157, 217, 168, 52, 254, 237,
    159, 95, 50, 193, 45, 104, 23, 180, 147, 46, 92, 69, 222, 237, 137, 76, 184, 43, 103, 233, 36,
    207, 235, 196, 12, 51, 161, 87, 22, 255, 152, 245, 215, 204, 97, 241, 97, 241, 232, 174, 247,
    248, 126, 145, 158, 82, 234, 78, 196, 225, 123, 135, 199, 94, 145, 117, 14, 89, 26, 237, 91, 36,
    168, 156, 117, 113, 212, 151, 173, 199, 161, 23, 0, 19, 186, 246, 243, 95, 30, 232, 231, 176,
    254, 169, 184, 215, 225, 78, 150, 110, 145, 112, 94, 40, 155, 44, 65, 1, 137, 66, 175, 64, 22,
    27, 193, 252, 58, 245, 199, 243, 229, 99, 18, 2, 224, 141, 67, 87, 211, 35, 121, 187, 240, 105,
    171, 230, 153, 187, 206, 72, 180, 82, 251, 136, 250, 160, 75, 178, 141, 204, 83, 16, 36, 113,
    147, 67, 20, 176, 224, 251, 31, 54, 99, 15, 142, 223, 97, 220, 114, 129, 25, 62, 149, 9, 111,
    67, 27, 89, 39, 86, 210, 216, 6, 74, 236, 136, 224, 155, 139, 249, 146, 90, 86, 36, 26, 210, 98,
    249, 238, 150, 228, 170, 90, 33, 240, 218, 62, 158, 109, 41, 241, 137, 83, 42, 88, 48, 177, 252,
    188, 4, 42, 132, 189, 21, 150, 229, 27, 126, 101, 102, 172, 96, 30, 14, 171, 155, 198, 150, 154,
    149, 25, 173, 179, 48, 97, 28, 53, 194, 66, 169, 17, 223, 76, 180, 165, 215, 2, 190, 240, 161,
    136, 195, 171, 8, 34, 209, 112, 113, 172, 93, 249, 145, 225, 226, 193, 25, 144, 46, 136, 31,
    196, 200, 13, 41, 30, 141, 89, 72, 71, 157, 2, 241, 102, 154, 138, 82, 24, 117, 29, 204, 64, 76,
    36, 169, 148, 76, 32, 76, 62, 132, 214, 136, 38, 199, 170, 224, 127, 41, 147, 150, 81, 41, 67,
    97, 48, 26, 212, 163, 25, 231, 120, 25, 61, 152, 96, 114, 8, 39, 241, 34, 193, 33, 162, 103,
    225, 150, 178, 235, 41, 56, 204, 3, 17, 30, 129, 48, 204, 172, 126, 108, 205, 11, 72, 238, 240,
    171, 159, 111, 0, 201, 17, 188, 166, 25, 35, 8, 100, 113, 101, 16, 33, 150, 226, 31, 0
};

/* What all weights share: the closed form preetham_classes. */
static const unsigned short skylight_sh_7_bands_0_1pct_packed_short[60] = { 40453, 4971, 945, 105,
    24192, 2155, 420, 15, 1, 1787, 1463, 3554, 4275, 25, 3125, 227, 53251, 1206, 25771, 67, 3703, 5,
    275, 4214, 15346, 61, 897, 26756, 317, 4153, 667, 516, 26688, 7332, 4, 2125, 641, 8989, 33, 452,
    166, 2903, 11693, 375, 6377, 21196, 209, 3202, 6052, 394, 25886, 993, 7344, 79, 2102, 441,
    16537, 109, 529, 41556 };

#define SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_EARLY 16

static inline void skylight_sh_7_bands_0_1pct_packed_begin_factors(const
    skylight_sh_7_bands_0_1pct_packed_real *x, skylight_sh_7_bands_0_1pct_packed_real *early)
{
    const float chi = (0.888888896f - x[1] * 0.0166666675f) * (1.57079637f - x[0]);
    const float square = chi * chi;
    early[0] = ((skylight_sh_7_bands_0_1pct_packed_real)skylight_sh_7_bands_0_1pct_packed_short[2])
        - square *
        (((skylight_sh_7_bands_0_1pct_packed_real)skylight_sh_7_bands_0_1pct_packed_short[6]) -
        ((skylight_sh_7_bands_0_1pct_packed_real)skylight_sh_7_bands_0_1pct_packed_short[7]) *
        square);
    early[1] = ((0.100000001f * skylight_sh_7_bands_0_1pct_packed_short[0]) * x[1] -
        ((skylight_sh_7_bands_0_1pct_packed_real)skylight_sh_7_bands_0_1pct_packed_short[1])) * (chi
        * (((skylight_sh_7_bands_0_1pct_packed_real)skylight_sh_7_bands_0_1pct_packed_short[2]) -
        square *
        (((skylight_sh_7_bands_0_1pct_packed_real)skylight_sh_7_bands_0_1pct_packed_short[3]) -
        square))) + ((0.100000001f * skylight_sh_7_bands_0_1pct_packed_short[4]) - (0.100000001f *
        skylight_sh_7_bands_0_1pct_packed_short[5]) * x[1]) * early[0];
    const float part_1 = (-9.99999975e-05f * skylight_sh_7_bands_0_1pct_packed_short[11]) * x[1] +
        (9.99999975e-05f * skylight_sh_7_bands_0_1pct_packed_short[12]);
    const float up =
        ((skylight_sh_7_bands_0_1pct_packed_real)skylight_sh_7_bands_0_1pct_packed_short[8]) +
        part_1 * ((0.00999999978f * skylight_sh_7_bands_0_1pct_packed_short[13]) + part_1 *
        (9.99999975e-06f * skylight_sh_7_bands_0_1pct_packed_short[14]));
    const float up2 = up * up;
    early[2] = ((skylight_sh_7_bands_0_1pct_packed_real)skylight_sh_7_bands_0_1pct_packed_short[8])
        + ((9.99999975e-05f * skylight_sh_7_bands_0_1pct_packed_short[9]) * x[1] + (-0.00100000005f
        * skylight_sh_7_bands_0_1pct_packed_short[10])) * (up2 * up2);
    early[3] = (-9.99999975e-05f * skylight_sh_7_bands_0_1pct_packed_short[15]) * x[1] +
        (9.99999975e-05f * skylight_sh_7_bands_0_1pct_packed_short[16]);
    const float y = ((9.99999975e-05f * skylight_sh_7_bands_0_1pct_packed_short[17]) * x[1] +
        (-9.99999975e-05f * skylight_sh_7_bands_0_1pct_packed_short[18])) * x[0] * (0.00999999978f *
        skylight_sh_7_bands_0_1pct_packed_short[13]);
    const float halo = 1.0f + y * (0.99999845f + y * (0.499975085f + y * (0.166515172f + y *
        (0.0412233174f + y * (0.00765432511f + y * 0.000849007862f)))));
    early[4] = halo * halo;
    const float z = x[0] * x[0];
    const float cosine =
        ((skylight_sh_7_bands_0_1pct_packed_real)skylight_sh_7_bands_0_1pct_packed_short[8]) - z *
        ((0.100000001f * skylight_sh_7_bands_0_1pct_packed_short[21]) - z * (9.99999975e-06f *
        skylight_sh_7_bands_0_1pct_packed_short[14]));
    const float cosine2 = cosine * cosine;
    early[5] = ((-0.00100000005f * skylight_sh_7_bands_0_1pct_packed_short[19]) * x[1] +
        (9.99999975e-05f * skylight_sh_7_bands_0_1pct_packed_short[20])) * cosine2;
    early[6] = (((((9.99999975e-06f * skylight_sh_7_bands_0_1pct_packed_short[22]) * x[1] +
        (-9.99999975e-06f * skylight_sh_7_bands_0_1pct_packed_short[23])) * x[1] + (9.99999975e-06f
        * skylight_sh_7_bands_0_1pct_packed_short[24])) * x[0] + (((-9.99999975e-05f *
        skylight_sh_7_bands_0_1pct_packed_short[25]) * x[1] + (9.99999975e-05f *
        skylight_sh_7_bands_0_1pct_packed_short[26])) * x[1] + (-9.99999975e-06f *
        skylight_sh_7_bands_0_1pct_packed_short[27]))) * x[0] + (((9.99999975e-06f *
        skylight_sh_7_bands_0_1pct_packed_short[28]) * x[1] + (-9.99999975e-06f *
        skylight_sh_7_bands_0_1pct_packed_short[29])) * x[1] + (9.99999975e-05f *
        skylight_sh_7_bands_0_1pct_packed_short[30]))) * x[0] + ((9.99999975e-06f *
        skylight_sh_7_bands_0_1pct_packed_short[31]) * x[1] + (9.99999975e-06f *
        skylight_sh_7_bands_0_1pct_packed_short[32]));
    early[7] = (9.99999975e-05f * skylight_sh_7_bands_0_1pct_packed_short[13]) * x[1] +
        (9.99999975e-05f * skylight_sh_7_bands_0_1pct_packed_short[33]);
    early[8] = (-9.99999975e-05f * skylight_sh_7_bands_0_1pct_packed_short[34]) * x[1] +
        (9.99999975e-05f * skylight_sh_7_bands_0_1pct_packed_short[35]);
    const float y_2 = ((-9.99999975e-05f * skylight_sh_7_bands_0_1pct_packed_short[36]) * x[1] +
        (-9.99999975e-05f * skylight_sh_7_bands_0_1pct_packed_short[37])) * x[0] * (0.00999999978f *
        skylight_sh_7_bands_0_1pct_packed_short[13]);
    const float halo_2 = 1.0f + y_2 * (0.99999845f + y_2 * (0.499975085f + y_2 * (0.166515172f + y_2
        * (0.0412233174f + y_2 * (0.00765432511f + y_2 * 0.000849007862f)))));
    early[9] = halo_2 * halo_2;
    early[10] = ((-9.99999975e-05f * skylight_sh_7_bands_0_1pct_packed_short[38]) * x[1] +
        (9.99999975e-05f * skylight_sh_7_bands_0_1pct_packed_short[39])) * cosine2;
    early[11] = (((((9.99999975e-06f * skylight_sh_7_bands_0_1pct_packed_short[40]) * x[1] +
        (-9.99999975e-06f * skylight_sh_7_bands_0_1pct_packed_short[41])) * x[1] + (9.99999975e-06f
        * skylight_sh_7_bands_0_1pct_packed_short[42])) * x[0] + (((-9.99999975e-06f *
        skylight_sh_7_bands_0_1pct_packed_short[43]) * x[1] + (9.99999975e-06f *
        skylight_sh_7_bands_0_1pct_packed_short[44])) * x[1] + (-9.99999975e-06f *
        skylight_sh_7_bands_0_1pct_packed_short[45]))) * x[0] + (((9.99999975e-06f *
        skylight_sh_7_bands_0_1pct_packed_short[46]) * x[1] + (-9.99999975e-06f *
        skylight_sh_7_bands_0_1pct_packed_short[47])) * x[1] + (9.99999975e-06f *
        skylight_sh_7_bands_0_1pct_packed_short[48]))) * x[0] + ((9.99999975e-06f *
        skylight_sh_7_bands_0_1pct_packed_short[49]) * x[1] + (9.99999975e-06f *
        skylight_sh_7_bands_0_1pct_packed_short[50]));
    early[12] = (9.99999975e-06f * skylight_sh_7_bands_0_1pct_packed_short[51]) * x[1] +
        (9.99999975e-05f * skylight_sh_7_bands_0_1pct_packed_short[52]);
    early[13] = (-9.99999975e-05f * skylight_sh_7_bands_0_1pct_packed_short[53]) * x[1] +
        (9.99999975e-05f * skylight_sh_7_bands_0_1pct_packed_short[54]);
    const float y_3 = ((-9.99999975e-05f * skylight_sh_7_bands_0_1pct_packed_short[55]) * x[1] +
        (-9.99999975e-05f * skylight_sh_7_bands_0_1pct_packed_short[56])) * x[0] * (0.00999999978f *
        skylight_sh_7_bands_0_1pct_packed_short[13]);
    const float halo_3 = 1.0f + y_3 * (0.99999845f + y_3 * (0.499975085f + y_3 * (0.166515172f + y_3
        * (0.0412233174f + y_3 * (0.00765432511f + y_3 * 0.000849007862f)))));
    early[14] = halo_3 * halo_3;
    early[15] = ((-9.99999975e-05f * skylight_sh_7_bands_0_1pct_packed_short[57]) * x[1] +
        (9.99999975e-05f * skylight_sh_7_bands_0_1pct_packed_short[58])) * cosine2;
    (void)x;
    (void)early;
}

/* The rest of it. */
static inline void skylight_sh_7_bands_0_1pct_packed_end_factors(const
    skylight_sh_7_bands_0_1pct_packed_real *x, const skylight_sh_7_bands_0_1pct_packed_real *early,
    skylight_sh_7_bands_0_1pct_packed_real *out)
{
    const float halo4 = early[4] * early[4];
    const float shape_y = early[2] *
        (((skylight_sh_7_bands_0_1pct_packed_real)skylight_sh_7_bands_0_1pct_packed_short[8]) +
        early[3] * halo4 + early[5]);
    const float halo4_2 = early[9] * early[9];
    const float shape_x = early[7] *
        (((skylight_sh_7_bands_0_1pct_packed_real)skylight_sh_7_bands_0_1pct_packed_short[8]) +
        early[8] * halo4_2 + early[10]);
    const float one = early[1] / (early[0] * shape_y * early[6] * shape_x);
    const float halo4_3 = early[14] * early[14];
    const float shape_z = early[12] *
        (((skylight_sh_7_bands_0_1pct_packed_real)skylight_sh_7_bands_0_1pct_packed_short[8]) +
        early[13] * halo4_3 + early[15]);
    const float of_x = one * early[11] * shape_z;
    out[1] = 3.73898554f * of_x;
    const float of_y = one * early[6] * shape_x;
    const float of_s = one * shape_z * shape_x;
    out[2] = (-0.498531401f) * of_s;
    out[0] = out[1] + (-1.03860712f) * of_y + out[2];
    out[4] = (-1.01082206f) * of_x;
    out[5] = (9.99999997e-07f * skylight_sh_7_bands_0_1pct_packed_short[59]) * of_s;
    out[3] = out[4] + 1.83445477f * of_y + out[5];
    out[7] = (-1.00158179f) * of_x;
    out[8] = 1.05722523f * of_s;
    out[6] = out[7] + (-1.26125109f) * of_y + out[8];
    (void)x;
    (void)early;
}

/* The functions of sun_zenith (change of variable: even); 0 where there is
   none. */
static inline void skylight_sh_7_bands_0_1pct_packed_first(const
    skylight_sh_7_bands_0_1pct_packed_real *x, skylight_sh_7_bands_0_1pct_packed_real *out)
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
    out[11] = 0;
    (void)x;
}

/* All products of the functions of turbidity (change of variable:
   reciprocal). */
static inline void skylight_sh_7_bands_0_1pct_packed_others(const
    skylight_sh_7_bands_0_1pct_packed_real *x, skylight_sh_7_bands_0_1pct_packed_real *out)
{
    out[0] = 1.0f;
    out[1] = (-4.85714293f) * (x[1] - 2.5f) / ((-2.5f) - x[1]) - 1.0f;
    out[2] = 2.0f * out[1] * out[1] - 1.0f;
    out[3] = 2.0f * out[1] * out[2] - out[1];
    out[4] = 2.0f * out[2] * out[2] - 1.0f;
    out[5] = 2.0f * out[2] * out[3] - out[1];
    out[6] = 2.0f * out[3] * out[3] - 1.0f;
    (void)x;
}

/* cos(m azimuth) and sin(m azimuth), m < bands, each times the m-th power
   of `radius`, by doubling. */
static inline void skylight_sh_7_bands_0_1pct_packed_waves(skylight_sh_7_bands_0_1pct_packed_real
    azimuth, skylight_sh_7_bands_0_1pct_packed_real radius,
    skylight_sh_7_bands_0_1pct_packed_real *cosines, skylight_sh_7_bands_0_1pct_packed_real *sines)
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
static inline skylight_sh_7_bands_0_1pct_packed_real skylight_sh_7_bands_0_1pct_packed_sine(const
    skylight_sh_7_bands_0_1pct_packed_real *x)
{
    const float part_1 = x[SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_SUN] *
        x[SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_SUN];
    return x[SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_SUN] + x[SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_SUN] *
        (part_1 * ((-0.166666597f) + part_1 * (0.00833306555f + part_1 * ((-0.000198095426f) +
        part_1 * 2.60563934e-06f))));
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
        slopes[0] = 0.0;
        slopes[1] = (-4.8571428571428568) / part_1 - part_2 * -1.0 / part_1;
        slopes[2] = 2.0 * slopes[1] * out[1] + part_3 * slopes[1];
        slopes[3] = 2.0 * slopes[1] * out[2] + part_4 * slopes[2] - slopes[1];
        slopes[4] = 2.0 * slopes[2] * out[2] + part_5 * slopes[2];
        slopes[5] = 2.0 * slopes[2] * out[3] + part_6 * slopes[3] - slopes[1];
        slopes[6] = 2.0 * slopes[3] * out[3] + part_7 * slopes[3];
    }
    (void)v;
}

/* The factors, then their slopes after each axis. */
static inline void skylight_sh_7_bands_0_1pct_packed_factor_slopes(const double *x, double *out)
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
static inline void skylight_sh_7_bands_0_1pct_packed_sine_slope(const double *x, double *out)
{
    out[0] = sin(x[SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_SUN]);
    out[1] = cos(x[SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_SUN]);
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

/* Numbers side by side where the compiler has vector types: as many as the processor's registers
   hold, and four. */
#if defined(__GNUC__) && (defined(__SSE__) || defined(__ARM_NEON) || defined(__ALTIVEC__) || \
                          defined(__wasm_simd128__) || defined(__loongarch_sx))
#if defined(__AVX512F__)
#define SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_LANES 16
#elif defined(__AVX__)
#define SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_LANES 8
#else
#define SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_LANES 4
#endif
#endif
/* What is worth its place in every caller. */
#ifdef __GNUC__
#define SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_INLINE static inline __attribute__((always_inline))
#else
#define SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_INLINE static inline
#endif
#ifdef SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_LANES
#ifdef __FMA__
/* One operation for a product and a sum, which standard C may not choose by itself. */
#include <immintrin.h>
#endif
typedef float skylight_sh_7_bands_0_1pct_packed_lanes __attribute__((vector_size(4 *
    SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_LANES)));
typedef float skylight_sh_7_bands_0_1pct_packed_four __attribute__((vector_size(16)));
typedef int skylight_sh_7_bands_0_1pct_packed_order __attribute__((vector_size(16)));

/* The same number in all places: v - 0 is v, which 0 + v need not be. */
static inline skylight_sh_7_bands_0_1pct_packed_lanes skylight_sh_7_bands_0_1pct_packed_spread(float
    v)
{
    const skylight_sh_7_bands_0_1pct_packed_lanes zeros = {0};
    return v - zeros;
}

static inline skylight_sh_7_bands_0_1pct_packed_lanes skylight_sh_7_bands_0_1pct_packed_load(const
    float *from)
{
    skylight_sh_7_bands_0_1pct_packed_lanes v;
    memcpy(&v, from, sizeof v);
    return v;
}

/* a * b + c. */
static inline skylight_sh_7_bands_0_1pct_packed_lanes
    skylight_sh_7_bands_0_1pct_packed_add(skylight_sh_7_bands_0_1pct_packed_lanes a,
    skylight_sh_7_bands_0_1pct_packed_lanes b,
                                                skylight_sh_7_bands_0_1pct_packed_lanes c)
{
#if defined(__FMA__) && SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_LANES == 16
    return _mm512_fmadd_ps(a, b, c);
#elif defined(__FMA__) && SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_LANES == 8
    return _mm256_fmadd_ps(a, b, c);
#else
    return a * b + c;
#endif
}

static inline skylight_sh_7_bands_0_1pct_packed_four
    skylight_sh_7_bands_0_1pct_packed_spread_four(float v)
{
    const skylight_sh_7_bands_0_1pct_packed_four zeros = {0};
    return v - zeros;
}

static inline skylight_sh_7_bands_0_1pct_packed_four
    skylight_sh_7_bands_0_1pct_packed_load_four(const float *from)
{
    skylight_sh_7_bands_0_1pct_packed_four v;
    memcpy(&v, from, sizeof v);
    return v;
}

static inline skylight_sh_7_bands_0_1pct_packed_four
    skylight_sh_7_bands_0_1pct_packed_add_four(skylight_sh_7_bands_0_1pct_packed_four a,
    skylight_sh_7_bands_0_1pct_packed_four b,
                                                    skylight_sh_7_bands_0_1pct_packed_four c)
{
#ifdef __FMA__
    return _mm_fmadd_ps(a, b, c);
#else
    return a * b + c;
#endif
}

static inline void skylight_sh_7_bands_0_1pct_packed_keep(float *to,
    skylight_sh_7_bands_0_1pct_packed_four v)
{
    memcpy(to, &v, sizeof v);
}

/* Four of the eight numbers of two vectors. */
#ifdef __clang__
#define SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_PICK(v, w, a, b, c, d) __builtin_shufflevector(v, w, a, \
    b, c, d)
#else
#define SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_PICK(v, w, a, b, c, d) \
    skylight_sh_7_bands_0_1pct_packed_pick(v, w, a, b, c, d)
static inline skylight_sh_7_bands_0_1pct_packed_four
    skylight_sh_7_bands_0_1pct_packed_pick(skylight_sh_7_bands_0_1pct_packed_four v,
    skylight_sh_7_bands_0_1pct_packed_four w, int a,
                                                int b, int c, int d)
{
    const skylight_sh_7_bands_0_1pct_packed_order order = {a, b, c, d};
    return __builtin_shuffle(v, w, order);
}
#endif
#endif

/* One channel's sums, from those of its classes. */
static inline void skylight_sh_7_bands_0_1pct_packed_mix(skylight_sh_7_bands_0_1pct_packed_real
    sums[SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_CLASSES][SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_ROOM],
                                   int channel,
                                       const skylight_sh_7_bands_0_1pct_packed_real *factors,
                                   skylight_sh_7_bands_0_1pct_packed_real *mixed)
{
    int i;
    int k;
    for (i = 0; i < SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_WIDTH; ++i)
        mixed[i] = factors[channel * SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_CLASSES] * sums[0][i];
    for (k = 1; k < SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_CLASSES; ++k)
        for (i = 0; i < SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_WIDTH; ++i)
            mixed[i] += factors[channel * SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_CLASSES + k] *
                sums[k][i];
}

/* Orders m >= 0 alone are stored: those of a light that is even in y at azimuth 0. */
#define SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_FIRST_ORDER(l) 0

/* Stores one weight of degree l and order m turned by the azimuth. */
static inline void skylight_sh_7_bands_0_1pct_packed_place(skylight_sh_7_bands_0_1pct_packed_real
    value, int l, int m,
                                     const skylight_sh_7_bands_0_1pct_packed_real *cosines,
                                         const skylight_sh_7_bands_0_1pct_packed_real *sines,
                                     float *weights)
{
    weights[l * (l + 1) - m] = (float)(value * sines[m]);
    weights[l * (l + 1) + m] = (float)(value * cosines[m]);
}

/* Stores the first `bands` bands of the channels' weights, turned by the azimuth (Habel et al.
 * 2008,
   eq. 4 with nothing for m < 0). */
static inline void skylight_sh_7_bands_0_1pct_packed_store(
    skylight_sh_7_bands_0_1pct_packed_real
        sums[SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_CLASSES][SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_ROOM],
        const skylight_sh_7_bands_0_1pct_packed_real *factors,
    const skylight_sh_7_bands_0_1pct_packed_real *cosines,
        const skylight_sh_7_bands_0_1pct_packed_real *sines, int bands,
    float
        weights[SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_CHANNELS]
        [SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_WEIGHTS])
{
    int channel;
#if defined(SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_LANES) && SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_BANDS > 3
    /* In fours; each overshoot is overwritten by what follows. */
    float plus[SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_BANDS],
        minus[SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_BANDS + 3] = {0};
    int m, q;
    for (m = 0; m < SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_BANDS; ++m) {
        plus[m] = cosines[m];
        minus[SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_BANDS - 1 - m] = sines[m];
    }
    for (channel = 0; channel < SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_CHANNELS; ++channel) {
        float *const w = weights[channel];
        skylight_sh_7_bands_0_1pct_packed_four v[SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_FOURS];
        for (q = 0; q < SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_FOURS; ++q) {
            int k;
            v[q] = factors[channel * SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_CLASSES] *
                skylight_sh_7_bands_0_1pct_packed_load_four(sums[0] + 4 * q);
            for (k = 1; k < SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_CLASSES; ++k)
                v[q] = skylight_sh_7_bands_0_1pct_packed_add_four(
                    skylight_sh_7_bands_0_1pct_packed_spread_four(factors[channel *
                        SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_CLASSES + k]),
                    skylight_sh_7_bands_0_1pct_packed_load_four(sums[k] + 4 * q), v[q]);
        }
#define SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_BAND(l, stores) \
    if (bands > (l)) { stores }
#define SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_NOTHING(place, count) memset(w + (place), 0, \
    sizeof(float) * (count));
#define SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_MINUS(place, q, r, a, b, c, d, order) \
    skylight_sh_7_bands_0_1pct_packed_keep(w + (place), \
                     SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_PICK(v[q], v[r], a, b, c, d) * \
                         skylight_sh_7_bands_0_1pct_packed_load_four(minus + \
                             SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_BANDS - 1 - (order)));
#define SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_PLUS(place, q, r, a, b, c, d, order) \
    skylight_sh_7_bands_0_1pct_packed_keep(w + (place), \
        SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_PICK(v[q], v[r], a, b, c, d) * \
                                      skylight_sh_7_bands_0_1pct_packed_load_four(plus + (order)));
        SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_STORES(SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_BAND,
            SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_NOTHING, SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_MINUS,
                           SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_PLUS)
#undef SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_BAND
#undef SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_NOTHING
#undef SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_MINUS
#undef SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_PLUS
    }
#else
    static const short columns[SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_BANDS] =
        SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_COLUMNS;
    for (channel = 0; channel < SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_CHANNELS; ++channel) {
        skylight_sh_7_bands_0_1pct_packed_real v[SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_WIDTH];
        int l, m;
        skylight_sh_7_bands_0_1pct_packed_mix(sums, channel, factors, v);
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

#ifdef SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_LANES

/* Vectors that the first `count` numbers of a row take, and those that are summed at once, in
   registers. */
#define SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_VECTORS(count) (((count) + \
    SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_LANES - 1) / SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_LANES)
#define SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_BLOCKS \
    ((SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_VECTORS(SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_WIDTH) + 6) / 7)
#define SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_BLOCK \
    ((SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_VECTORS(SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_WIDTH) + \
        SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_BLOCKS - 1) / SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_BLOCKS)
#endif

/* The products of the functions of all axes, of one class in the order of its rows. */
static inline void skylight_sh_7_bands_0_1pct_packed_multiply(int class_,
    const skylight_sh_7_bands_0_1pct_packed_real *first,
                                        const skylight_sh_7_bands_0_1pct_packed_real *others,
                                            skylight_sh_7_bands_0_1pct_packed_real *products)
{
    int i;
#ifdef SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_LANES
    /* In fours: each overshoot is overwritten by the next line. */
#define SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_PRODUCT(which, place, count, other) \
    for (i = 0; i < (count) && class_ == (which); i += 4) \
        skylight_sh_7_bands_0_1pct_packed_keep(products + (place) + i, \
                         skylight_sh_7_bands_0_1pct_packed_load_four(first + i) * others[other]);
#else
#define SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_PRODUCT(which, place, count, other) \
    for (i = 0; i < (count) && class_ == (which); ++i) products[(place) + i] = first[i] * \
        others[other];
#endif
    SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_PRODUCTS(SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_PRODUCT)
#undef SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_PRODUCT
}
#ifdef SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_LANES

/* Rows whose sums run side by side, so that no sum waits for the one before. */
#define SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_SIDE (SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_BLOCK > 4 ? 1 : \
    SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_BLOCK > 2 ? 2 : 4)

/* sums = sum over t of products[t] * row t: SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_BLOCK vectors of each
 * row, which stay in
   registers. */
static inline void skylight_sh_7_bands_0_1pct_packed_sum_block(const
    skylight_sh_7_bands_0_1pct_packed_real *row, int terms,
                                         const skylight_sh_7_bands_0_1pct_packed_real *products,
                                             skylight_sh_7_bands_0_1pct_packed_real *sums)
{
    skylight_sh_7_bands_0_1pct_packed_lanes
        total[SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_SIDE][SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_BLOCK];
    int t, i, k;
    for (i = 0; i < SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_SIDE; ++i)
        for (k = 0; k < SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_BLOCK; ++k) total[i][k] =
            skylight_sh_7_bands_0_1pct_packed_spread(0);
    for (t = 0; t + SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_SIDE <= terms; t +=
        SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_SIDE) {
        for (i = 0; i < SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_SIDE; ++i) {
            const skylight_sh_7_bands_0_1pct_packed_lanes product =
                skylight_sh_7_bands_0_1pct_packed_spread(products[t + i]);
            for (k = 0; k < SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_BLOCK; ++k)
                total[i][k] = skylight_sh_7_bands_0_1pct_packed_add(
                    product, skylight_sh_7_bands_0_1pct_packed_load(row + i *
                        SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_WIDTH + k *
                        SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_LANES),
                    total[i][k]);
        }
        row += SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_SIDE * SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_WIDTH;
    }
    for (; t < terms; ++t) {
        const skylight_sh_7_bands_0_1pct_packed_lanes product =
            skylight_sh_7_bands_0_1pct_packed_spread(products[t]);
        for (k = 0; k < SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_BLOCK; ++k)
            total[0][k] = skylight_sh_7_bands_0_1pct_packed_add(product,
                skylight_sh_7_bands_0_1pct_packed_load(row + k *
                SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_LANES),
                                          total[0][k]);
        row += SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_WIDTH;
    }
    for (k = 0; k < SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_BLOCK; ++k) {
        for (i = 1; i < SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_SIDE; ++i) total[0][k] += total[i][k];
        memcpy(sums + k * SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_LANES, &total[0][k],
            sizeof total[0][k]);
    }
}

/* The same for one vector of each row. */
static inline void skylight_sh_7_bands_0_1pct_packed_sum_vector(const
    skylight_sh_7_bands_0_1pct_packed_real *row, int terms,
                                          const skylight_sh_7_bands_0_1pct_packed_real *products,
                                              skylight_sh_7_bands_0_1pct_packed_real *sums)
{
    skylight_sh_7_bands_0_1pct_packed_lanes total = skylight_sh_7_bands_0_1pct_packed_spread(0),
        other = skylight_sh_7_bands_0_1pct_packed_spread(0);
    int t;
    for (t = 0; t + 2 <= terms; t += 2) {
        total =
            skylight_sh_7_bands_0_1pct_packed_add(skylight_sh_7_bands_0_1pct_packed_spread(products
            [t]), skylight_sh_7_bands_0_1pct_packed_load(row), total);
        other =
            skylight_sh_7_bands_0_1pct_packed_add(skylight_sh_7_bands_0_1pct_packed_spread(products
            [t + 1]),
                                skylight_sh_7_bands_0_1pct_packed_load(row +
                                    SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_WIDTH), other);
        row += 2 * SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_WIDTH;
    }
    if (t < terms)
        total =
            skylight_sh_7_bands_0_1pct_packed_add(skylight_sh_7_bands_0_1pct_packed_spread(products
            [t]), skylight_sh_7_bands_0_1pct_packed_load(row), total);
    total += other;
    memcpy(sums, &total, sizeof total);
}

/* The first `count` numbers of the sum over t of products[t] * row t. */
static inline void skylight_sh_7_bands_0_1pct_packed_sum(const
    skylight_sh_7_bands_0_1pct_packed_real *row, int terms,
                                   const skylight_sh_7_bands_0_1pct_packed_real *products,
                                       int count,
                                   skylight_sh_7_bands_0_1pct_packed_real *sums)
{
    const int vectors = SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_VECTORS(count);
    int k = 0;
    if (vectors >= SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_BLOCK) {
        for (; k + SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_BLOCK <= vectors; k +=
            SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_BLOCK)
            skylight_sh_7_bands_0_1pct_packed_sum_block(row + k *
                SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_LANES, terms, products,
                                  sums + k * SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_LANES);
    }
    for (; k < vectors; ++k)
        skylight_sh_7_bands_0_1pct_packed_sum_vector(row + k *
            SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_LANES, terms, products,
                               sums + k * SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_LANES);
}
#else

/* The first `count` numbers of the sum over t of products[t] * row t, four rows a pass: no
   reduction, so that it vectorises. */
static inline void skylight_sh_7_bands_0_1pct_packed_sum(const
    skylight_sh_7_bands_0_1pct_packed_real *row, int terms,
                                   const skylight_sh_7_bands_0_1pct_packed_real *products,
                                       int count,
                                   skylight_sh_7_bands_0_1pct_packed_real *sums)
{
    int t, k;
    for (k = 0; k < SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_ROOM; ++k) sums[k] = 0;
    for (t = 0; t + 4 <= terms; t += 4) {
        const skylight_sh_7_bands_0_1pct_packed_real a = products[t], b = products[t + 1];
        const skylight_sh_7_bands_0_1pct_packed_real c = products[t + 2], d = products[t + 3];
        for (k = 0; k < count; ++k)
            sums[k] += (a * row[k] + b * row[k + SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_WIDTH]) +
                       (c * row[k + 2 * SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_WIDTH] + d * row[k + 3 *
                           SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_WIDTH]);
        row += 4 * SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_WIDTH;
    }
    for (; t < terms; ++t) {
        for (k = 0; k < count; ++k) sums[k] += products[t] * row[k];
        row += SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_WIDTH;
    }
}
#endif

/* The sums of one class's rows, one a term, for the first `bands` bands. */
static inline void skylight_sh_7_bands_0_1pct_packed_sum_class(const
    skylight_sh_7_bands_0_1pct_packed_real *rows, int class_,
                                         const skylight_sh_7_bands_0_1pct_packed_real *first,
                                         const skylight_sh_7_bands_0_1pct_packed_real *others,
                                             int bands,
                                         skylight_sh_7_bands_0_1pct_packed_real *sums)
{
    static const unsigned short starts[SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_CLASSES] =
        SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_STARTS;
    static const unsigned short counts[SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_CLASSES] =
        SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_COUNTS;
    static const unsigned short places[SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_CLASSES] =
        SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_PLACES;
    static const unsigned short widths[SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_BANDS] =
        SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_WIDTHS;
    const skylight_sh_7_bands_0_1pct_packed_real *const row = rows + (int)starts[class_] *
        SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_WIDTH;
    skylight_sh_7_bands_0_1pct_packed_real
        products[SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_PRODUCTS_ROOM];
    skylight_sh_7_bands_0_1pct_packed_multiply(class_, first, others, products);
    if (bands == SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_BANDS) {
        skylight_sh_7_bands_0_1pct_packed_sum(row, counts[class_], products + places[class_],
            SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_WIDTH, sums);
    } else {
        memset(sums, 0, sizeof *sums * SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_ROOM);
        skylight_sh_7_bands_0_1pct_packed_sum(row, counts[class_], products + places[class_],
            widths[bands - 1], sums);
    }
}

/* The same in double precision, all bands: what derivatives need, whose terms cancel. */
static inline void skylight_sh_7_bands_0_1pct_packed_sum_rows_double(
    const skylight_sh_7_bands_0_1pct_packed_real *rows, const double *first, const double *others,
    double sums[SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_CLASSES][SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_WIDTH])
{
    static const unsigned char
        lengths[SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_CLASSES][SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_OTHERS]
        = SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_LENGTHS;
    int c, i, k, other;
    for (c = 0; c < SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_CLASSES; ++c) {
        for (k = 0; k < SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_WIDTH; ++k) sums[c][k] = 0.0;
        for (other = 0; other < SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_OTHERS; ++other) {
            for (i = 0; i < (int)lengths[c][other]; ++i) {
                const double product = first[i] * others[other];
                for (k = 0; k < SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_WIDTH; ++k) sums[c][k] += product
                    * (double)rows[k];
                rows += SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_WIDTH;
            }
        }
    }
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
    /* At most 63 bits, so that there is a zero above them. */
    while (b->count < 56 && b->next < end) {
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

/* How many ones stand before the first zero, from the low end; what is held has a zero. */
static inline int skylight_sh_7_bands_0_1pct_packed_ones(uint64_t held)
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
static inline int skylight_sh_7_bands_0_1pct_packed_rice(skylight_sh_7_bands_0_1pct_packed_bits *b,
    int low)
{
    unsigned high = 0, folded;
    int ones;
    if (b->count < 32) skylight_sh_7_bands_0_1pct_packed_fill(b);
    while ((ones = skylight_sh_7_bands_0_1pct_packed_ones(b->held)) >= b->count) {
        high += (unsigned)b->count;
        b->held = 0;
        b->count = 0;
        skylight_sh_7_bands_0_1pct_packed_fill(b);
    }
    high += (unsigned)ones;
    b->held = b->held >> ones >> 1;
    b->count -= ones + 1;
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

/* The length of the next run, by that of the same class and product at the weight before. */
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
    skylight_sh_7_bands_0_1pct_packed_class_profile[SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_CLASSES] =
    SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_CLASS_PROFILE;

/* Reads the stream once, forward: the sums of the first `bands` bands. */
static inline void skylight_sh_7_bands_0_1pct_packed_sum_stream(
    const skylight_sh_7_bands_0_1pct_packed_real *first,
        const skylight_sh_7_bands_0_1pct_packed_real *others, int bands,
    skylight_sh_7_bands_0_1pct_packed_real
        sums[SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_CLASSES][SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_ROOM])
{
    signed char
        lengths[SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_CLASSES][SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_RUNS];
    int profile[32], i, l, m, c, other, column = 0;
    skylight_sh_7_bands_0_1pct_packed_bits bits = skylight_sh_7_bands_0_1pct_packed_open();
    memset(lengths, 0, sizeof lengths);
    memset(profile, 0, sizeof profile);
    memset(sums, 0, sizeof(skylight_sh_7_bands_0_1pct_packed_real) *
        SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_CLASSES * SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_ROOM);
    for (l = 0; l < bands; ++l) {
        skylight_sh_7_bands_0_1pct_packed_next_profile(&bits, profile);
        for (m = SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_FIRST_ORDER(l); m <= l; ++m, ++column) {
            for (c = 0; c < SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_CLASSES; ++c) {
                skylight_sh_7_bands_0_1pct_packed_real value = 0;
                for (other = 0; other < SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_RUNS; ++other) {
                    const int level = skylight_sh_7_bands_0_1pct_packed_run_profile[other] +
                        skylight_sh_7_bands_0_1pct_packed_class_profile[c];
                    const int length = skylight_sh_7_bands_0_1pct_packed_next_length(&bits,
                        &lengths[c][other]);
                    skylight_sh_7_bands_0_1pct_packed_real sum = 0;
                    for (i = 0; i < length; ++i) {
                        const int number = skylight_sh_7_bands_0_1pct_packed_next_number(&bits,
                            profile[i] + level);
                        sum += first[i] * (skylight_sh_7_bands_0_1pct_packed_real)number;
                    }
                    value += sum * others[other];
                }
                sums[c][column] = value * SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_STEP;
            }
        }
    }
}

/* Reads the stream once, forward, into rows: of each class one for each product of functions. */
static inline void skylight_sh_7_bands_0_1pct_packed_unpack_rows(float *rows)
{
    static const unsigned char
        sizes[SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_CLASSES][SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_OTHERS] =
        SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_LENGTHS;
    unsigned short
        starts[SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_CLASSES][SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_RUNS];
    signed char
        lengths[SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_CLASSES][SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_RUNS];
    int profile[32], i, l, m, c, other, column = 0, row = 0;
    skylight_sh_7_bands_0_1pct_packed_bits bits = skylight_sh_7_bands_0_1pct_packed_open();
    memset(lengths, 0, sizeof lengths);
    memset(profile, 0, sizeof profile);
    for (c = 0; c < SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_CLASSES; ++c) {
        for (other = 0; other < SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_OTHERS; ++other) {
            if (other < SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_RUNS) starts[c][other] = (unsigned
                short)row;
            row += sizes[c][other];
        }
    }
    for (i = 0; i < SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_UNPACKED; ++i) rows[i] = 0.0f;
    for (l = 0; l < SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_BANDS; ++l) {
        skylight_sh_7_bands_0_1pct_packed_next_profile(&bits, profile);
        for (m = SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_FIRST_ORDER(l); m <= l; ++m, ++column) {
            for (c = 0; c < SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_CLASSES; ++c) {
                for (other = 0; other < SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_RUNS; ++other) {
                    const int level = skylight_sh_7_bands_0_1pct_packed_run_profile[other] +
                        skylight_sh_7_bands_0_1pct_packed_class_profile[c];
                    const int length = skylight_sh_7_bands_0_1pct_packed_next_length(&bits,
                        &lengths[c][other]);
                    float *to = rows + (int)starts[c][other] *
                        SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_WIDTH + column;
                    for (i = 0; i < length; ++i) {
                        const int number = skylight_sh_7_bands_0_1pct_packed_next_number(&bits,
                            profile[i] + level);
                        *to = (float)number * SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_STEP;
                        to += SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_WIDTH;
                    }
                }
            }
        }
    }
}

/* The sums in double precision, all bands: what derivatives need, whose terms cancel. */
static inline void skylight_sh_7_bands_0_1pct_packed_sum_stream_double(
    const double *first, const double *others,
        double
        sums[SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_CLASSES][SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_WIDTH])
{
    signed char
        lengths[SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_CLASSES][SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_RUNS];
    int profile[32], i, l, m, c, other, column = 0;
    skylight_sh_7_bands_0_1pct_packed_bits bits = skylight_sh_7_bands_0_1pct_packed_open();
    memset(lengths, 0, sizeof lengths);
    memset(profile, 0, sizeof profile);
    for (l = 0; l < SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_BANDS; ++l) {
        skylight_sh_7_bands_0_1pct_packed_next_profile(&bits, profile);
        for (m = SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_FIRST_ORDER(l); m <= l; ++m, ++column) {
            for (c = 0; c < SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_CLASSES; ++c) {
                double value = 0.0;
                for (other = 0; other < SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_RUNS; ++other) {
                    const int level = skylight_sh_7_bands_0_1pct_packed_run_profile[other] +
                        skylight_sh_7_bands_0_1pct_packed_class_profile[c];
                    const int length = skylight_sh_7_bands_0_1pct_packed_next_length(&bits,
                        &lengths[c][other]);
                    double sum = 0.0;
                    for (i = 0; i < length; ++i) {
                        const int number = skylight_sh_7_bands_0_1pct_packed_next_number(&bits,
                            profile[i] + level);
                        sum += first[i] * (double)number;
                    }
                    value += sum * others[other];
                }
                sums[c][column] = value * (double)SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_STEP;
            }
        }
    }
}

/* What becomes of the first `bands` bands once they are stored. */
static inline void skylight_sh_7_bands_0_1pct_packed_finish(int bands, int lights,
                                      float
                                          weights[SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_CHANNELS]
                                          [SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_WEIGHTS])
{
    (void)bands;
    (void)lights;
    (void)weights;
}

/* Evaluates the first `bands` bands (1 to SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_BANDS, clamped like an
 * input) and zeroes the
   rest; returns the status. `rows` are the table's; those of a packed table may be missing. */
static inline int skylight_sh_7_bands_0_1pct_packed_evaluate(const
    skylight_sh_7_bands_0_1pct_packed_real *rows,
                                       const float inputs[SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_AXES],
                                           float azimuth,
                                       int bands,
                                       float
                                           weights[SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_CHANNELS]
                                           [SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_WEIGHTS])
{
    skylight_sh_7_bands_0_1pct_packed_real x[SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_AXES],
        first[SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_FIRST],
        others[SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_OTHERS];
    skylight_sh_7_bands_0_1pct_packed_real cosines[SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_BANDS],
        sines[SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_BANDS];
    skylight_sh_7_bands_0_1pct_packed_real
        sums[SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_CLASSES][SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_ROOM];
    skylight_sh_7_bands_0_1pct_packed_real factors[SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_CHANNELS *
        SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_CLASSES];
    skylight_sh_7_bands_0_1pct_packed_real light = SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_EXPOSURE,
        radius = 1;
    skylight_sh_7_bands_0_1pct_packed_real early[SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_EARLY];
    int i, all, status = skylight_sh_7_bands_0_1pct_packed_inputs(inputs, azimuth, x);
    if (status == 2) {
        memset(weights, 0, sizeof(float) * SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_CHANNELS *
            SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_WEIGHTS);
        return 2;
    }
    if (bands < 1 || bands > SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_BANDS) {
        bands = bands < 1 ? 1 : SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_BANDS;
        status = 1;
    }
    /* First what the library computes: calls keep no registers. */
    radius = skylight_sh_7_bands_0_1pct_packed_sine(x);
    skylight_sh_7_bands_0_1pct_packed_waves((skylight_sh_7_bands_0_1pct_packed_real)azimuth, radius,
        cosines, sines);
    skylight_sh_7_bands_0_1pct_packed_first(x, first);
    skylight_sh_7_bands_0_1pct_packed_others(x, others);
    skylight_sh_7_bands_0_1pct_packed_begin_factors(x, early);
    all = bands;
    if (!rows) skylight_sh_7_bands_0_1pct_packed_sum_stream(first, others, all, sums);
    if (rows)
        skylight_sh_7_bands_0_1pct_packed_sum_class(rows, 0, first, others, all, sums[0]);
    /* Between sums: what has begun above waits for itself, and there is more to do meanwhile. */
    skylight_sh_7_bands_0_1pct_packed_end_factors(x, early, factors);
    for (i = 0; i < SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_CHANNELS *
        SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_CLASSES; ++i) factors[i] *= light;
    if (rows)
    {
#define SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_CLASS(k) \
    skylight_sh_7_bands_0_1pct_packed_sum_class(rows, k, first, others, all, sums[k]);
        SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_OTHER_CLASSES(SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_CLASS)
#undef SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_CLASS
    }
    skylight_sh_7_bands_0_1pct_packed_store(sums, factors, cosines, sines, all, weights);
    skylight_sh_7_bands_0_1pct_packed_finish(bands, 1, weights);
    if (bands < SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_BANDS) {
        int channel;
        for (channel = 0; channel < SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_CHANNELS; ++channel)
            for (i = bands * bands; i < SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_WEIGHTS; ++i)
                weights[channel][i] = 0.0f;
    }
    return status;
}

/* One of many suns by itself. */
static inline int skylight_sh_7_bands_0_1pct_packed_evaluate_one(const
    skylight_sh_7_bands_0_1pct_packed_real *rows,
                                           const float *const
                                               inputs[SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_AXES],
                                           const float *azimuths, int sun,
                                           float
                                               weights[SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_CHANNELS]
                                               [SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_WEIGHTS])
{
    float given[SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_AXES];
    int axis;
    for (axis = 0; axis < SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_AXES; ++axis) given[axis] =
        inputs[axis][sun];
    return skylight_sh_7_bands_0_1pct_packed_evaluate(rows, given,
        azimuths ? azimuths[sun] : SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_AZIMUTH,
                                SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_BANDS, weights);
}

/* Evaluates `count` suns from arrays, one an axis, and one of azimuths (or none, where the table
   fixes it); returns the largest status. */
static inline int skylight_sh_7_bands_0_1pct_packed_evaluate_batch(
    const skylight_sh_7_bands_0_1pct_packed_real *rows, int count,
        const float *const inputs[SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_AXES],
    const float *azimuths, float
        (*weights)[SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_CHANNELS]
        [SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_WEIGHTS])
{
    int s, status, worst = 0;
    for (s = 0; s < count; ++s) {
        status = skylight_sh_7_bands_0_1pct_packed_evaluate_one(rows, inputs, azimuths, s,
            weights[s]);
        worst = status > worst ? status : worst;
    }
    return worst;
}

/* The same with the suns of each weight side by side: `weights` is [channels][weights][count]. */
static inline int skylight_sh_7_bands_0_1pct_packed_evaluate_columns(const
    skylight_sh_7_bands_0_1pct_packed_real *rows, int count,
                                               const float *const
                                                   inputs[SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_AXES],
                                               const float *azimuths, float *weights)
{
    const size_t step = count > 0 ? (size_t)count : 0;
    int s = 0, i, status, worst = 0;
    while (s < count) {
        /* Some at once, so that what is written lies together. */
        float
            some[16][SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_CHANNELS]
            [SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_WEIGHTS];
        const int now = count - s < 16 ? count - s : 16;
        int k;
        for (k = 0; k < now; ++k) {
            status = skylight_sh_7_bands_0_1pct_packed_evaluate_one(rows, inputs, azimuths, s + k,
                some[k]);
            worst = status > worst ? status : worst;
        }
        for (i = 0; i < SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_CHANNELS *
            SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_WEIGHTS; ++i)
            for (k = 0; k < now; ++k)
                weights[(size_t)i * step + (size_t)(s + k)] =
                    some[k][i / SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_WEIGHTS][i %
                        SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_WEIGHTS];
        s += now;
    }
    return worst;
}

/* All products of `count` numbers and `size` functions, the functions' place fastest; returns how
   many. */
static inline int skylight_sh_7_bands_0_1pct_packed_multiply_double(double *products, int count,
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
static inline void skylight_sh_7_bands_0_1pct_packed_sum_double(
    const skylight_sh_7_bands_0_1pct_packed_real *rows,
        double
        functions[SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_AXES][SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_MOST],
    double sums[SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_CLASSES][SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_WIDTH])
{
    static const int sizes[SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_AXES] =
        SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_SIZES;
    double others[SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_OTHERS];
    int axis, count = 1;
    others[0] = 1.0;
    for (axis = 1; axis < SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_AXES; ++axis)
        count = skylight_sh_7_bands_0_1pct_packed_multiply_double(others, count, functions[axis],
            sizes[axis]);
    skylight_sh_7_bands_0_1pct_packed_sum_stream_double(functions[0], others, sums);
    (void)rows;
    (void)count;
}

/* One channel's sum in double, at a column. */
static inline double skylight_sh_7_bands_0_1pct_packed_mixed_double(double
    sums[SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_CLASSES][SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_WIDTH],
                                              int channel, int column, const double *factors)
{
    double sum = 0.0;
    int k;
    for (k = 0; k < SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_CLASSES; ++k)
        sum += factors[channel * SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_CLASSES + k] * sums[k][column];
    return sum;
}

/* Evaluates all bands, and their derivatives after each axis by the product rule, in double until
   they are stored: exact inside the ranges, and beyond one those at its edge. */
static inline int skylight_sh_7_bands_0_1pct_packed_evaluate_gradient(
    const skylight_sh_7_bands_0_1pct_packed_real *rows,
        const float inputs[SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_AXES], float azimuth,
    float
        weights[SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_CHANNELS]
        [SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_WEIGHTS],
    float
        gradient[SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_AXES][SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_CHANNELS]
        [SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_WEIGHTS])
{
    static const short columns[SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_BANDS] =
        SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_COLUMNS;
    double x[SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_AXES],
        functions[SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_AXES][SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_MOST];
    double slopes[SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_AXES][SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_MOST];
    double factors[1 +
        SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_AXES][SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_FACTORS];
    double sums[SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_CLASSES][SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_WIDTH];
    double
        sloped[SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_CLASSES][SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_WIDTH];
    double powers[SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_BANDS],
        power_slopes[SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_BANDS];
    skylight_sh_7_bands_0_1pct_packed_real cosines[SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_BANDS],
        sines[SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_BANDS];
    int axis, channel, i, l, m, sunk = 0;
    const int status =
        skylight_sh_7_bands_0_1pct_packed_evaluate(rows, inputs, azimuth,
            SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_BANDS, weights);
    memset(gradient, 0,
           sizeof(float) * SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_AXES *
               SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_CHANNELS *
               SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_WEIGHTS);
    if (status == 2) return 2;
    for (axis = 0; axis < SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_AXES; ++axis) {
        const double low = skylight_sh_7_bands_0_1pct_packed_slope_range[axis][0];
        const double high = skylight_sh_7_bands_0_1pct_packed_slope_range[axis][1];
        const double v = (double)skylight_sh_7_bands_0_1pct_packed_finite(inputs[axis]);
        x[axis] = v < low ? low : v > high ? high : v;
        skylight_sh_7_bands_0_1pct_packed_functions(axis, x[axis], functions[axis], slopes[axis]);
    }
    skylight_sh_7_bands_0_1pct_packed_factor_slopes(x, &factors[0][0]);
    for (axis = 0; axis < 1 + SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_AXES; ++axis)
        for (i = 0; i < SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_FACTORS; ++i)
            factors[axis][i] *= (double)SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_EXPOSURE;
    for (m = 0; m < SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_BANDS; ++m) {
        powers[m] = 1.0;
        power_slopes[m] = 0.0;
    }
    {
        double sine[2];
        skylight_sh_7_bands_0_1pct_packed_sine_slope(x, sine);
        for (m = 1; m < SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_BANDS; ++m) {
            powers[m] = powers[m - 1] * sine[0];
            power_slopes[m] = (double)m * powers[m - 1] * sine[1];
        }
    }
    skylight_sh_7_bands_0_1pct_packed_waves((skylight_sh_7_bands_0_1pct_packed_real)azimuth, 1,
        cosines, sines);
    skylight_sh_7_bands_0_1pct_packed_sum_double(rows, functions, sums);
    for (axis = 0; axis < SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_AXES; ++axis) {
        double kept[SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_MOST];
        memcpy(kept, functions[axis], sizeof kept);
        memcpy(functions[axis], slopes[axis], sizeof kept);
        skylight_sh_7_bands_0_1pct_packed_sum_double(rows, functions, sloped);
        memcpy(functions[axis], kept, sizeof kept);
        for (channel = 0; channel < SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_CHANNELS; ++channel) {
            float *const w = gradient[axis][channel];
            for (l = 0; l < SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_BANDS; ++l) {
                for (m = SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_FIRST_ORDER(l); m <= l && columns[l] >=
                    0; ++m) {
                    const int order = m < 0 ? -m : m;
                    const int column = columns[l] + m -
                        SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_FIRST_ORDER(l);
                    double value =
                        powers[order] *
                        (skylight_sh_7_bands_0_1pct_packed_mixed_double(sloped, channel, column,
                            factors[0]) +
                         skylight_sh_7_bands_0_1pct_packed_mixed_double(sums, channel, column,
                             factors[1 + axis]));
                    if (axis == SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_SUN && !sunk)
                        value += power_slopes[order] *
                                 skylight_sh_7_bands_0_1pct_packed_mixed_double(sums, channel,
                                     column, factors[0]);
                    skylight_sh_7_bands_0_1pct_packed_place((skylight_sh_7_bands_0_1pct_packed_real)
                        value, l, m, cosines, sines, w);
                }
            }
        }
        skylight_sh_7_bands_0_1pct_packed_finish(SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_BANDS, 0,
            gradient[axis]);
    }
    (void)power_slopes;
    (void)sunk;
    return status;
}

SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_API int skylight_sh_7_bands_0_1pct_packed_weights(float
    sun_zenith, float sun_azimuth, float turbidity,
    float
    weights[SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_CHANNELS][SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_WEIGHTS])
{
    const float skylight_sh_7_bands_0_1pct_packed_given[SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_AXES] = {
        sun_zenith, turbidity };
    return skylight_sh_7_bands_0_1pct_packed_evaluate(NULL, skylight_sh_7_bands_0_1pct_packed_given,
        sun_azimuth, SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_BANDS, weights);
}

SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_API int skylight_sh_7_bands_0_1pct_packed_weights_bands(float
    sun_zenith, float sun_azimuth, float turbidity, int bands,
    float
    weights[SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_CHANNELS][SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_WEIGHTS])
{
    const float skylight_sh_7_bands_0_1pct_packed_given[SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_AXES] = {
        sun_zenith, turbidity };
    return skylight_sh_7_bands_0_1pct_packed_evaluate(NULL, skylight_sh_7_bands_0_1pct_packed_given,
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
    float skylight_sh_7_bands_0_1pct_packed_memory[SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_UNPACKED];
    if (count > 1)
        skylight_sh_7_bands_0_1pct_packed_unpack_rows(skylight_sh_7_bands_0_1pct_packed_memory);
    return skylight_sh_7_bands_0_1pct_packed_evaluate_batch(count > 1 ?
        skylight_sh_7_bands_0_1pct_packed_memory : NULL, count,
        skylight_sh_7_bands_0_1pct_packed_given, sun_azimuth, weights);
}

SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_API int skylight_sh_7_bands_0_1pct_packed_weights_columns(int
    count, const float *sun_zenith, const float *sun_azimuth, const float *turbidity,
    float *weights)
{
    const float *const
        skylight_sh_7_bands_0_1pct_packed_given[SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_AXES] = {
        sun_zenith, turbidity };
    float skylight_sh_7_bands_0_1pct_packed_memory[SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_UNPACKED];
    if (count > 1)
        skylight_sh_7_bands_0_1pct_packed_unpack_rows(skylight_sh_7_bands_0_1pct_packed_memory);
    return skylight_sh_7_bands_0_1pct_packed_evaluate_columns(count > 1 ?
        skylight_sh_7_bands_0_1pct_packed_memory : NULL, count,
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
    return skylight_sh_7_bands_0_1pct_packed_evaluate_gradient(NULL,
        skylight_sh_7_bands_0_1pct_packed_given, sun_azimuth, weights, gradient);
}

SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_API void skylight_sh_7_bands_0_1pct_packed_unpack(float
    memory[SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_UNPACKED])
{
    skylight_sh_7_bands_0_1pct_packed_unpack_rows(memory);
}

SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_API int skylight_sh_7_bands_0_1pct_packed_unpacked_weights(const
    float memory[SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_UNPACKED], float sun_zenith, float sun_azimuth,
    float turbidity, float
    weights[SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_CHANNELS][SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_WEIGHTS])
{
    const float skylight_sh_7_bands_0_1pct_packed_given[SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_AXES] = {
        sun_zenith, turbidity };
    return skylight_sh_7_bands_0_1pct_packed_evaluate(memory,
        skylight_sh_7_bands_0_1pct_packed_given, sun_azimuth,
        SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_BANDS, weights);
}

SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_API int
    skylight_sh_7_bands_0_1pct_packed_unpacked_weights_bands(const float
    memory[SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_UNPACKED], float sun_zenith, float sun_azimuth,
    float turbidity, int bands, float
    weights[SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_CHANNELS][SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_WEIGHTS])
{
    const float skylight_sh_7_bands_0_1pct_packed_given[SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_AXES] = {
        sun_zenith, turbidity };
    return skylight_sh_7_bands_0_1pct_packed_evaluate(memory,
        skylight_sh_7_bands_0_1pct_packed_given, sun_azimuth, bands, weights);
}

SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_API int
    skylight_sh_7_bands_0_1pct_packed_unpacked_weights_batch(const float
    memory[SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_UNPACKED], int count, const float *sun_zenith,
    const float *sun_azimuth, const float *turbidity,
    float
    (*weights)[SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_CHANNELS]
    [SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_WEIGHTS])
{
    const float *const
        skylight_sh_7_bands_0_1pct_packed_given[SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_AXES] = {
        sun_zenith, turbidity };
    return skylight_sh_7_bands_0_1pct_packed_evaluate_batch(memory, count,
        skylight_sh_7_bands_0_1pct_packed_given, sun_azimuth, weights);
}

SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_API int
    skylight_sh_7_bands_0_1pct_packed_unpacked_weights_columns(const float
    memory[SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_UNPACKED], int count, const float *sun_zenith,
    const float *sun_azimuth, const float *turbidity, float *weights)
{
    const float *const
        skylight_sh_7_bands_0_1pct_packed_given[SKYLIGHT_SH_7_BANDS_0_1PCT_PACKED_AXES] = {
        sun_zenith, turbidity };
    return skylight_sh_7_bands_0_1pct_packed_evaluate_columns(memory, count,
        skylight_sh_7_bands_0_1pct_packed_given, sun_azimuth, weights);
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
