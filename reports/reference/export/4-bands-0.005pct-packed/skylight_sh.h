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
 * Accuracy, as shipped: E_mean 0.00496 %, E_max 0.0142 % of the least luminance of the same sky, at
 * azimuth 0.
 * The expansion rings: the least value it takes, over all directions and measured sets, is -12.5 %
 * of its largest in the same set; the window below tames it.
 * Memory: 1723 bytes of constants, packed into few bytes (a fast table takes more and less time).
 *
 * Provenance
 *   skylight-sh 0.1.0, config preetham 08540d17388f71b0, table 4-bands-0.005pct-packed
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
#define SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_H 0x5d7f6481

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
#define SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_E_MEAN 4.957000e-05
#define SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_E_MAX 1.423000e-04
#define SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_UNPACKED 1476
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
/* Evaluates `count` suns from arrays; returns the largest status. Unpacks
   the table once, SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_UNPACKED floats on the stack. */
SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_API int skylight_sh_4_bands_0_005pct_packed_weights_batch(int
    count, const float *sun_zenith, const float *sun_azimuth, const float *turbidity,
    float
    (*weights)[SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_CHANNELS]
    [SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_WEIGHTS]);
/* The same with the suns of each weight side by side:
   [SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_CHANNELS][SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_WEIGHTS]
       [count]. */
SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_API int skylight_sh_4_bands_0_005pct_packed_weights_columns(int
    count, const float *sun_zenith, const float *sun_azimuth, const float *turbidity,
    float *weights);
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
/* Unpacks the table into memory of the caller's, SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_UNPACKED
   floats, for the calls below. */
SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_API void skylight_sh_4_bands_0_005pct_packed_unpack(float
    memory[SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_UNPACKED]);
/* Evaluates all bands of an unpacked table: far faster than of the packed
   one. */
SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_API int
    skylight_sh_4_bands_0_005pct_packed_unpacked_weights(const float
    memory[SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_UNPACKED], float sun_zenith, float sun_azimuth,
    float turbidity, float
    weights[SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_CHANNELS]
    [SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_WEIGHTS]);
/* The same for the first `bands` bands. */
SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_API int
    skylight_sh_4_bands_0_005pct_packed_unpacked_weights_bands(const float
    memory[SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_UNPACKED], float sun_zenith, float sun_azimuth,
    float turbidity, int bands, float
    weights[SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_CHANNELS]
    [SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_WEIGHTS]);
/* The same for `count` suns from arrays; returns the largest status. */
SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_API int
    skylight_sh_4_bands_0_005pct_packed_unpacked_weights_batch(const float
    memory[SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_UNPACKED], int count, const float *sun_zenith,
    const float *sun_azimuth, const float *turbidity,
    float
    (*weights)[SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_CHANNELS]
    [SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_WEIGHTS]);
/* The same as
 * [SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_CHANNELS][SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_WEIGHTS]
 * [count]. */
SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_API int
    skylight_sh_4_bands_0_005pct_packed_unpacked_weights_columns(const float
    memory[SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_UNPACKED], int count, const float *sun_zenith,
    const float *sun_azimuth, const float *turbidity, float *weights);
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

#elif SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_H != 0x5d7f6481
#error "Another table has the prefix skylight_sh_4_bands_0_005pct_packed_4_bands_0_005pct_packed \
already: export one of them under a prefix of its own."
#endif /* SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_H */

#if (!defined(SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_EXTERN) || \
    defined(SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_IMPLEMENTATION)) && \
    !defined(SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_DEFINED)
#define SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_DEFINED

/* Numbers side by side where the compiler has vector types: as many as the processor's registers
   hold, and four. */
#if defined(__GNUC__) && (defined(__SSE__) || defined(__ARM_NEON) || defined(__ALTIVEC__) || \
                          defined(__wasm_simd128__) || defined(__loongarch_sx))
#if defined(__AVX512F__)
#define SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_LANES 16
#elif defined(__AVX__)
#define SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_LANES 8
#else
#define SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_LANES 4
#endif
#endif
/* What is worth its place in every caller; what lies at the start of a cache line. */
#ifdef __GNUC__
#define SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_INLINE static inline __attribute__((always_inline))
#define SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_ALIGNED __attribute__((aligned(64)))
#else
#define SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_INLINE static inline
#define SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_ALIGNED
#endif
#ifdef SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_LANES
#ifdef __FMA__
/* One operation for a product and a sum, which standard C may not choose by itself. */
#include <immintrin.h>
#endif
typedef float skylight_sh_4_bands_0_005pct_packed_lanes __attribute__((vector_size(4 *
    SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_LANES)));
typedef float skylight_sh_4_bands_0_005pct_packed_four __attribute__((vector_size(16)));
typedef int skylight_sh_4_bands_0_005pct_packed_order __attribute__((vector_size(16)));

/* The same number in all places: v - 0 is v, which 0 + v need not be. */
static inline skylight_sh_4_bands_0_005pct_packed_lanes
    skylight_sh_4_bands_0_005pct_packed_spread(float v)
{
    const skylight_sh_4_bands_0_005pct_packed_lanes zeros = {0};
    return v - zeros;
}

static inline skylight_sh_4_bands_0_005pct_packed_lanes
    skylight_sh_4_bands_0_005pct_packed_load(const float *from)
{
    skylight_sh_4_bands_0_005pct_packed_lanes v;
    memcpy(&v, from, sizeof v);
    return v;
}

/* a * b + c. */
static inline skylight_sh_4_bands_0_005pct_packed_lanes
    skylight_sh_4_bands_0_005pct_packed_add(skylight_sh_4_bands_0_005pct_packed_lanes a,
    skylight_sh_4_bands_0_005pct_packed_lanes b,
                                                skylight_sh_4_bands_0_005pct_packed_lanes c)
{
#if defined(__FMA__) && SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_LANES == 16
    return _mm512_fmadd_ps(a, b, c);
#elif defined(__FMA__) && SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_LANES == 8
    return _mm256_fmadd_ps(a, b, c);
#else
    return a * b + c;
#endif
}

static inline skylight_sh_4_bands_0_005pct_packed_four
    skylight_sh_4_bands_0_005pct_packed_spread_four(float v)
{
    const skylight_sh_4_bands_0_005pct_packed_four zeros = {0};
    return v - zeros;
}

static inline skylight_sh_4_bands_0_005pct_packed_four
    skylight_sh_4_bands_0_005pct_packed_load_four(const float *from)
{
    skylight_sh_4_bands_0_005pct_packed_four v;
    memcpy(&v, from, sizeof v);
    return v;
}

static inline skylight_sh_4_bands_0_005pct_packed_four
    skylight_sh_4_bands_0_005pct_packed_add_four(skylight_sh_4_bands_0_005pct_packed_four a,
    skylight_sh_4_bands_0_005pct_packed_four b,
                                                    skylight_sh_4_bands_0_005pct_packed_four c)
{
#ifdef __FMA__
    return _mm_fmadd_ps(a, b, c);
#else
    return a * b + c;
#endif
}

/* Numbers side by side; where there are fewer than four, the last again. */
static inline skylight_sh_4_bands_0_005pct_packed_four
    skylight_sh_4_bands_0_005pct_packed_quadruple(float a, float b, float c, float d)
{
    const skylight_sh_4_bands_0_005pct_packed_four v = {a, b, c, d};
    return v;
}

static inline skylight_sh_4_bands_0_005pct_packed_four
    skylight_sh_4_bands_0_005pct_packed_triple(float a, float b, float c)
{
    return skylight_sh_4_bands_0_005pct_packed_quadruple(a, b, c, c);
}

static inline skylight_sh_4_bands_0_005pct_packed_four
    skylight_sh_4_bands_0_005pct_packed_pair(float a, float b)
{
    return skylight_sh_4_bands_0_005pct_packed_quadruple(a, b, b, b);
}

static inline void skylight_sh_4_bands_0_005pct_packed_keep(float *to,
    skylight_sh_4_bands_0_005pct_packed_four v)
{
    memcpy(to, &v, sizeof v);
}

/* Four of the eight numbers of two vectors. */
#ifdef __clang__
#define SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_PICK(v, w, a, b, c, d) __builtin_shufflevector(v, w, \
    a, b, c, d)
#else
#define SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_PICK(v, w, a, b, c, d) \
    skylight_sh_4_bands_0_005pct_packed_pick(v, w, a, b, c, d)
static inline skylight_sh_4_bands_0_005pct_packed_four
    skylight_sh_4_bands_0_005pct_packed_pick(skylight_sh_4_bands_0_005pct_packed_four v,
    skylight_sh_4_bands_0_005pct_packed_four w, int a,
                                                int b, int c, int d)
{
    const skylight_sh_4_bands_0_005pct_packed_order order = {a, b, c, d};
    return __builtin_shuffle(v, w, order);
}
#endif
#endif

typedef float skylight_sh_4_bands_0_005pct_packed_real;

/* Functions of the first axis, in fours; products of the other axes'
   functions. */
#define SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_FIRST 16
#define SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_OTHERS 8
#define SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_SIZES { 14, 8 }
#define SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_MOST 16
#define SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_AZIMUTH 0.0f
/* The axis of the sun's zenith angle. */
#define SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_SUN 0
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

/* Classes; a row's numbers, one a sum, and those of the first 1, 2, ..
   bands; room for a class's sums. */
#define SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_CLASSES 3
#define SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_ALL_CLASSES(CLASS) CLASS(0) CLASS(1) CLASS(2)
/* What multiplies the sum of a class for a channel; the channels side by
   side, in fours. */
#define SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_FACTORS 12
#define SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_FACTOR(channel, class_) ((class_) * 4 + (channel))
#define SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_WIDTH 10
#define SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_WIDTHS { 1, 3, 6, 10 }
#define SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_ROOM 16
/* All rows; of each class the first row, how many, and the place of its
   first product. */
#define SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_TERMS 147
#define SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_STARTS { 0, 60, 103 }
#define SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_COUNTS { 60, 43, 44 }
#define SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_PLACES { 0, 60, 104 }
#define SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_PRODUCTS_ROOM 152
/* Of each class and product of the other axes' functions: how many
   functions of the first axis it has. */
#define SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_LENGTHS { { 14, 10, 11, 9, 7, 5, 3, 1 }, { 11, 10, 7, \
    6, 4, 3, 2, 0 }, { 10, 9, 8, 7, 5, 3, 2, 0 } }
/* The same: of each that has any, class, place of the first product, how
   many, the other axes' product. */
#define SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_PRODUCTS(PRODUCT) \
    PRODUCT(0, 0, 14, 0) \
    PRODUCT(0, 14, 10, 1) \
    PRODUCT(0, 24, 11, 2) \
    PRODUCT(0, 35, 9, 3) \
    PRODUCT(0, 44, 7, 4) \
    PRODUCT(0, 51, 5, 5) \
    PRODUCT(0, 56, 3, 6) \
    PRODUCT(0, 59, 1, 7) \
    PRODUCT(1, 60, 11, 0) \
    PRODUCT(1, 71, 10, 1) \
    PRODUCT(1, 81, 7, 2) \
    PRODUCT(1, 88, 6, 3) \
    PRODUCT(1, 94, 4, 4) \
    PRODUCT(1, 98, 3, 5) \
    PRODUCT(1, 101, 2, 6) \
    PRODUCT(2, 104, 10, 0) \
    PRODUCT(2, 114, 9, 1) \
    PRODUCT(2, 123, 8, 2) \
    PRODUCT(2, 131, 7, 3) \
    PRODUCT(2, 138, 5, 4) \
    PRODUCT(2, 143, 3, 5) \
    PRODUCT(2, 146, 2, 6)
/* Where sums go: of each degree, the first column, or -1 where it carries
   nothing. */
#define SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_COLUMNS { 0, 1, 3, 6 }
/* The same for vectors of four: places, two vectors of sums and the numbers
   of both, order. */
#define SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_FOURS 3
#define SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_STORES(BAND, NOTHING, MINUS, PLUS) \
    BAND(0, PLUS(0, 0, 0, 0, 1, 2, 3, 0)) \
    BAND(1, MINUS(1, 0, 0, 2, 1, 0, 0, 1) PLUS(2, 0, 1, 1, 2, 3, 4, 0)) \
    BAND(2, MINUS(4, 0, 1, 5, 4, 3, 2, 2) PLUS(6, 0, 1, 3, 4, 5, 6, 0)) \
    BAND(3, MINUS(9, 1, 2, 5, 4, 3, 2, 3) PLUS(12, 1, 2, 2, 3, 4, 5, 0))

/* Runs of numbers, one a product of the other axes' functions, and their
   profiles; what one step is worth. */
#define SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_RUNS 8
#define SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_RUN_PROFILE { 10, 8, 4, -2, -8, -12, -20, -20 }
#define SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_CLASS_PROFILE { -7, -15, -13 }
#define SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_STEP 2.11596489e-06f

/* Whole numbers as Rice codes. */
static const unsigned char skylight_sh_4_bands_0_005pct_packed_stream[1452] = {
    235, 123, 142, 41, 100, 202, 8, 241, 255, 255, 251, 255, 159, 91, 211, 11, 255, 40, 224, 171,
    59, 145, 34, 201, 224, 56, 76, 254, 255, 251, 167, 96, 255, 86, 235, 84, 56, 0, 204, 12, 115,
    94, 231, 255, 223, 221, 126, 144, 31, 146, 21, 173, 109, 64, 192, 255, 239, 208, 199, 248, 78,
    201, 38, 135, 255, 119, 138, 91, 40, 242, 232, 247, 128, 2, 121, 127, 238, 242, 255, 31, 232,
    86, 19, 232, 26, 23, 118, 42, 240, 255, 95, 71, 70, 183, 189, 83, 152, 46, 127, 204, 255, 107,
    132, 196, 22, 170, 136, 231, 63, 92, 71, 103, 248, 181, 226, 245, 242, 255, 191, 255, 63, 34,
    255, 175, 130, 140, 31, 167, 52, 162, 5, 23, 117, 255, 255, 247, 192, 238, 197, 239, 180, 210,
    131, 189, 188, 97, 236, 255, 247, 55, 153, 128, 239, 71, 189, 200, 156, 255, 247, 32, 97, 91,
    211, 236, 119, 8, 232, 78, 27, 246, 63, 199, 20, 50, 69, 12, 32, 223, 255, 31, 118, 217, 235,
    24, 10, 82, 202, 251, 162, 144, 25, 46, 142, 253, 143, 103, 233, 66, 143, 98, 9, 65, 132, 234,
    244, 0, 16, 118, 209, 31, 137, 90, 240, 136, 93, 4, 20, 45, 227, 1, 111, 59, 41, 66, 84, 207,
    69, 162, 54, 68, 14, 20, 18, 255, 44, 145, 161, 88, 147, 79, 14, 64, 8, 2, 216, 157, 96, 195,
    26, 4, 18, 64, 1, 187, 7, 220, 64, 2, 204, 129, 120, 147, 81, 85, 230, 218, 210, 255, 255, 57,
    146, 247, 217, 158, 12, 72, 169, 32, 45, 161, 251, 231, 184, 111, 110, 204, 193, 229, 53, 205,
    164, 254, 157, 157, 255, 116, 245, 75, 177, 184, 17, 84, 164, 204, 195, 58, 237, 168, 230, 223,
    63, 90, 180, 53, 186, 46, 200, 239, 220, 194, 93, 70, 162, 241, 3, 6, 59, 125, 250, 186, 55,
    233, 112, 180, 31, 63, 98, 43, 204, 245, 42, 135, 127, 129, 109, 31, 151, 226, 8, 121, 41, 14,
    214, 187, 104, 61, 114, 200, 55, 208, 102, 0, 195, 188, 123, 116, 14, 66, 192, 222, 231, 200,
    90, 21, 22, 36, 134, 118, 67, 248, 246, 105, 85, 75, 87, 190, 219, 178, 159, 124, 252, 108, 80,
    87, 211, 42, 92, 211, 243, 61, 215, 58, 238, 144, 122, 180, 117, 244, 150, 199, 86, 188, 189,
    225, 140, 228, 168, 197, 188, 243, 229, 181, 125, 153, 0, 17, 118, 236, 168, 224, 117, 236, 241,
    241, 198, 130, 36, 221, 189, 218, 217, 115, 54, 78, 225, 69, 147, 188, 222, 1, 87, 200, 160,
    198, 253, 207, 49, 133, 76, 33, 3, 4, 16, 73, 80, 253, 110, 122, 126, 162, 78, 190, 165, 60,
    180, 67, 222, 39, 9, 61, 98, 230, 13, 63, 30, 233, 176, 136, 145, 28, 229, 16, 140, 41, 47, 57,
    107, 223, 4, 144, 68, 113, 149, 186, 167, 49, 114, 97, 146, 187, 187, 19, 43, 223, 30, 213, 219,
    113, 28, 202, 17, 180, 17, 118, 217, 143, 27, 194, 2, 101, 72, 186, 255, 126, 53, 240, 201, 16,
    3, 181, 125, 175, 23, 93, 201, 30, 52, 116, 177, 107, 92, 247, 145, 210, 129, 245, 199, 212,
    143, 244, 63, 17, 174, 247, 56, 158, 253, 90, 50, 57, 251, 193, 20, 254, 39, 216, 174, 142, 164,
    239, 182, 159, 49, 187, 174, 122, 53, 210, 80, 62, 227, 41, 183, 250, 134, 28, 38, 176, 109,
    157, 234, 197, 89, 244, 217, 203, 253, 163, 19, 247, 98, 34, 2, 106, 166, 27, 8, 209, 3, 35,
    145, 177, 39, 251, 189, 88, 236, 120, 124, 200, 226, 87, 143, 0, 8, 181, 71, 111, 184, 150, 244,
    104, 40, 45, 1, 28, 78, 101, 190, 205, 128, 25, 225, 86, 16, 80, 156, 51, 29, 44, 4, 66, 232,
    113, 183, 189, 53, 100, 247, 70, 25, 193, 232, 25, 248, 157, 47, 92, 100, 145, 39, 220, 84, 92,
    223, 238, 98, 82, 228, 233, 238, 205, 142, 245, 193, 219, 236, 188, 44, 78, 178, 89, 174, 123,
    210, 166, 191, 77, 116, 9, 102, 49, 254, 142, 217, 156, 183, 136, 222, 241, 137, 211, 42, 8, 45,
    140, 216, 84, 176, 70, 85, 82, 197, 28, 183, 249, 54, 165, 134, 210, 252, 239, 131, 76, 229, 26,
    125, 55, 65, 17, 154, 76, 18, 144, 42, 135, 194, 67, 88, 116, 35, 133, 159, 224, 175, 160, 51,
    143, 76, 86, 152, 255, 118, 30, 240, 93, 209, 170, 36, 43, 16, 133, 1, 52, 216, 97, 191, 202,
    184, 198, 231, 92, 171, 65, 25, 100, 70, 55, 17, 129, 169, 101, 199, 173, 76, 26, 18, 144, 69,
    186, 71, 58, 251, 24, 203, 85, 244, 220, 134, 90, 198, 207, 63, 157, 184, 46, 173, 215, 52, 58,
    59, 115, 55, 111, 232, 105, 233, 112, 179, 210, 192, 102, 200, 129, 220, 201, 147, 208, 166,
    203, 47, 188, 227, 86, 216, 152, 56, 86, 175, 189, 43, 227, 121, 202, 85, 192, 215, 173, 118,
    185, 99, 54, 34, 147, 238, 65, 92, 6, 45, 225, 68, 51, 238, 127, 142, 41, 116, 10, 24, 33, 128,
    248, 239, 151, 37, 112, 137, 114, 255, 168, 127, 95, 167, 209, 78, 18, 81, 161, 102, 110, 204,
    170, 52, 60, 204, 253, 253, 237, 56, 73, 67, 66, 235, 66, 180, 163, 37, 46, 154, 102, 104, 30,
    165, 54, 172, 107, 57, 237, 150, 229, 8, 119, 182, 92, 109, 130, 119, 155, 245, 82, 99, 212, 19,
    19, 204, 92, 22, 157, 196, 151, 32, 35, 102, 205, 62, 173, 211, 63, 177, 151, 39, 217, 120, 182,
    174, 187, 245, 195, 216, 188, 194, 188, 171, 116, 250, 208, 139, 239, 145, 197, 143, 134, 122,
    201, 99, 219, 137, 3, 148, 175, 226, 71, 57, 67, 42, 245, 7, 40, 218, 248, 116, 223, 171, 103,
    220, 237, 181, 145, 72, 67, 113, 78, 177, 177, 198, 250, 59, 145, 21, 237, 175, 223, 105, 110,
    30, 88, 242, 155, 90, 165, 111, 232, 250, 15, 199, 134, 55, 150, 143, 6, 138, 117, 87, 211, 59,
    174, 128, 251, 65, 122, 74, 202, 78, 216, 203, 248, 137, 97, 82, 179, 236, 140, 189, 149, 168,
    53, 70, 66, 151, 155, 194, 159, 67, 123, 63, 174, 120, 175, 55, 122, 100, 155, 216, 182, 20,
    130, 72, 99, 99, 86, 97, 231, 39, 215, 65, 227, 76, 39, 46, 120, 77, 252, 4, 203, 50, 112, 177,
    127, 227, 214, 5, 121, 234, 49, 155, 119, 129, 94, 224, 124, 105, 211, 215, 15, 227, 218, 91,
    246, 248, 108, 103, 50, 243, 255, 229, 214, 207, 137, 195, 231, 157, 13, 144, 214, 64, 179, 198,
    134, 61, 230, 116, 245, 186, 106, 145, 23, 160, 53, 9, 245, 90, 19, 161, 27, 23, 109, 27, 190,
    148, 6, 183, 240, 125, 88, 6, 111, 162, 6, 107, 20, 108, 14, 159, 104, 248, 80, 109, 179, 5, 89,
    31, 68, 46, 33, 157, 49, 169, 83, 3, 232, 109, 21, 100, 192, 161, 24, 169, 23, 57, 112, 150,
    142, 5, 81, 123, 151, 97, 198, 80, 71, 154, 25, 209, 200, 53, 145, 131, 213, 154, 137, 180, 189,
    225, 211, 48, 109, 136, 140, 30, 215, 22, 168, 66, 146, 71, 159, 241, 14, 240, 206, 86, 153, 19,
    70, 61, 207, 94, 216, 180, 30, 111, 216, 225, 38, 109, 129, 233, 118, 34, 41, 182, 37, 180, 26,
    252, 50, 62, 0, 136, 44, 182, 68, 222, 249, 44, 16, 36, 252, 148, 73, 99, 38, 87, 35, 146, 237,
    158, 234, 110, 200, 46, 218, 230, 127, 227, 231, 238, 249, 97, 187, 13, 237, 89, 50, 48, 198,
    153, 70, 218, 67, 70, 245, 215, 121, 44, 4, 136, 156, 146, 74, 162, 154, 251, 138, 14, 64, 127,
    116, 208, 103, 202, 61, 92, 140, 6, 48, 76, 165, 187, 93, 232, 92, 142, 53, 73, 136, 25, 124,
    15, 0, 64, 136, 253, 18, 39, 94, 0, 210, 72, 98, 220, 36, 254, 215, 126, 147, 59, 70, 209, 17,
    43, 241, 39, 79, 252, 171, 244, 183, 90, 81, 166, 252, 44, 173, 170, 144, 22, 27, 20, 179, 230,
    101, 75, 121, 100, 61, 146, 67, 172, 44, 191, 182, 211, 179, 152, 46, 198, 111, 202, 106, 221,
    56, 254, 55, 190, 198, 167, 82, 244, 137, 141, 243, 198, 221, 147, 44, 165, 94, 200, 224, 141,
    2
};

/* What all weights share: the closed form preetham_classes. */
static const unsigned short skylight_sh_4_bands_0_005pct_packed_short[60] = { 40453, 4971, 945, 105,
    24192, 2155, 420, 15, 1, 1787, 1463, 3554, 4275, 25, 3125, 227, 4, 79, 53251, 2125, 2102, 1206,
    641, 441, 25771, 8989, 16537, 67, 33, 109, 3703, 452, 529, 5, 275, 166, 4214, 2903, 15346,
    11693, 61, 375, 897, 6377, 26756, 21196, 317, 209, 4153, 3202, 667, 6052, 516, 394, 26688,
    25886, 7332, 993, 7344, 41556 };

#ifdef SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_LANES
/* Equal formulas of different numbers side by side. */
static inline void skylight_sh_4_bands_0_005pct_packed_factors(const
    skylight_sh_4_bands_0_005pct_packed_real *x, skylight_sh_4_bands_0_005pct_packed_real *out)
{
    const float chi = (0.888888896f - x[1] * 0.0166666675f) * (1.57079637f - x[0]);
    const float square = chi * chi;
    const float below =
        ((skylight_sh_4_bands_0_005pct_packed_real)skylight_sh_4_bands_0_005pct_packed_short[2]) -
        square *
        (((skylight_sh_4_bands_0_005pct_packed_real)skylight_sh_4_bands_0_005pct_packed_short[6]) -
        ((skylight_sh_4_bands_0_005pct_packed_real)skylight_sh_4_bands_0_005pct_packed_short[7]) *
        square);
    const float zenith = ((0.100000001f * skylight_sh_4_bands_0_005pct_packed_short[0]) * x[1] -
        ((skylight_sh_4_bands_0_005pct_packed_real)skylight_sh_4_bands_0_005pct_packed_short[1])) *
        (chi *
        (((skylight_sh_4_bands_0_005pct_packed_real)skylight_sh_4_bands_0_005pct_packed_short[2]) -
        square *
        (((skylight_sh_4_bands_0_005pct_packed_real)skylight_sh_4_bands_0_005pct_packed_short[3]) -
        square))) + ((0.100000001f * skylight_sh_4_bands_0_005pct_packed_short[4]) - (0.100000001f *
        skylight_sh_4_bands_0_005pct_packed_short[5]) * x[1]) * below;
    const float part_1 = (-9.99999975e-05f * skylight_sh_4_bands_0_005pct_packed_short[11]) * x[1] +
        (9.99999975e-05f * skylight_sh_4_bands_0_005pct_packed_short[12]);
    const float up =
        ((skylight_sh_4_bands_0_005pct_packed_real)skylight_sh_4_bands_0_005pct_packed_short[8]) +
        part_1 * ((0.00999999978f * skylight_sh_4_bands_0_005pct_packed_short[13]) + part_1 *
        (9.99999975e-06f * skylight_sh_4_bands_0_005pct_packed_short[14]));
    const float up2 = up * up;
    const skylight_sh_4_bands_0_005pct_packed_four y =
        (skylight_sh_4_bands_0_005pct_packed_triple((9.99999975e-05f *
        skylight_sh_4_bands_0_005pct_packed_short[21]),
        (-9.99999975e-05f * skylight_sh_4_bands_0_005pct_packed_short[22]),
        (-9.99999975e-05f * skylight_sh_4_bands_0_005pct_packed_short[23])) * x[1] +
        skylight_sh_4_bands_0_005pct_packed_triple((-9.99999975e-05f *
        skylight_sh_4_bands_0_005pct_packed_short[24]),
        (-9.99999975e-05f * skylight_sh_4_bands_0_005pct_packed_short[25]),
        (-9.99999975e-05f * skylight_sh_4_bands_0_005pct_packed_short[26]))) * x[0] *
        (0.00999999978f * skylight_sh_4_bands_0_005pct_packed_short[13]);
    const skylight_sh_4_bands_0_005pct_packed_four y2 = y * y;
    const skylight_sh_4_bands_0_005pct_packed_four halo = 1.0f + 0.99999845f * y + y2 *
        (0.499975085f + 0.166515172f * y + y2 * (0.0412233174f + 0.00765432511f * y + y2 *
        0.000849007862f));
    const skylight_sh_4_bands_0_005pct_packed_four halo2 = halo * halo;
    const skylight_sh_4_bands_0_005pct_packed_four halo4 = halo2 * halo2;
    const float z = x[0] * x[0];
    const float cosine =
        ((skylight_sh_4_bands_0_005pct_packed_real)skylight_sh_4_bands_0_005pct_packed_short[8]) - z
        * ((0.100000001f * skylight_sh_4_bands_0_005pct_packed_short[33]) - z * (9.99999975e-06f *
        skylight_sh_4_bands_0_005pct_packed_short[14]));
    const float cosine2 = cosine * cosine;
    const skylight_sh_4_bands_0_005pct_packed_four part_2 =
        ((skylight_sh_4_bands_0_005pct_packed_real)skylight_sh_4_bands_0_005pct_packed_short[8]) +
        (skylight_sh_4_bands_0_005pct_packed_triple((-9.99999975e-05f *
        skylight_sh_4_bands_0_005pct_packed_short[15]),
        (-9.99999975e-05f * skylight_sh_4_bands_0_005pct_packed_short[16]),
        (-9.99999975e-05f * skylight_sh_4_bands_0_005pct_packed_short[17])) * x[1] +
        skylight_sh_4_bands_0_005pct_packed_triple((9.99999975e-05f *
        skylight_sh_4_bands_0_005pct_packed_short[18]),
        (9.99999975e-05f * skylight_sh_4_bands_0_005pct_packed_short[19]),
        (9.99999975e-05f * skylight_sh_4_bands_0_005pct_packed_short[20]))) * halo4 +
        (skylight_sh_4_bands_0_005pct_packed_triple((-0.00100000005f *
        skylight_sh_4_bands_0_005pct_packed_short[27]),
        (-9.99999975e-05f * skylight_sh_4_bands_0_005pct_packed_short[28]),
        (-9.99999975e-05f * skylight_sh_4_bands_0_005pct_packed_short[29])) * x[1] +
        skylight_sh_4_bands_0_005pct_packed_triple((9.99999975e-05f *
        skylight_sh_4_bands_0_005pct_packed_short[30]),
        (9.99999975e-05f * skylight_sh_4_bands_0_005pct_packed_short[31]),
        (9.99999975e-05f * skylight_sh_4_bands_0_005pct_packed_short[32]))) * cosine2;
    const float shape_y =
        (((skylight_sh_4_bands_0_005pct_packed_real)skylight_sh_4_bands_0_005pct_packed_short[8]) +
        ((9.99999975e-05f * skylight_sh_4_bands_0_005pct_packed_short[9]) * x[1] + (-0.00100000005f
        * skylight_sh_4_bands_0_005pct_packed_short[10])) * (up2 * up2)) * part_2[0];
    const skylight_sh_4_bands_0_005pct_packed_four y_zenith =
        ((((skylight_sh_4_bands_0_005pct_packed_pair((9.99999975e-06f *
        skylight_sh_4_bands_0_005pct_packed_short[34]),
        (9.99999975e-06f * skylight_sh_4_bands_0_005pct_packed_short[35])) * x[1] +
        skylight_sh_4_bands_0_005pct_packed_pair((-9.99999975e-06f *
        skylight_sh_4_bands_0_005pct_packed_short[36]),
        (-9.99999975e-06f * skylight_sh_4_bands_0_005pct_packed_short[37]))) * x[1] +
        skylight_sh_4_bands_0_005pct_packed_pair((9.99999975e-06f *
        skylight_sh_4_bands_0_005pct_packed_short[38]),
        (9.99999975e-06f * skylight_sh_4_bands_0_005pct_packed_short[39]))) * x[0] +
        ((skylight_sh_4_bands_0_005pct_packed_pair((-9.99999975e-05f *
        skylight_sh_4_bands_0_005pct_packed_short[40]),
        (-9.99999975e-06f * skylight_sh_4_bands_0_005pct_packed_short[41])) * x[1] +
        skylight_sh_4_bands_0_005pct_packed_pair((9.99999975e-05f *
        skylight_sh_4_bands_0_005pct_packed_short[42]),
        (9.99999975e-06f * skylight_sh_4_bands_0_005pct_packed_short[43]))) * x[1] +
        skylight_sh_4_bands_0_005pct_packed_pair((-9.99999975e-06f *
        skylight_sh_4_bands_0_005pct_packed_short[44]),
        (-9.99999975e-06f * skylight_sh_4_bands_0_005pct_packed_short[45])))) * x[0] +
        ((skylight_sh_4_bands_0_005pct_packed_pair((9.99999975e-06f *
        skylight_sh_4_bands_0_005pct_packed_short[46]),
        (9.99999975e-06f * skylight_sh_4_bands_0_005pct_packed_short[47])) * x[1] +
        skylight_sh_4_bands_0_005pct_packed_pair((-9.99999975e-06f *
        skylight_sh_4_bands_0_005pct_packed_short[48]),
        (-9.99999975e-06f * skylight_sh_4_bands_0_005pct_packed_short[49]))) * x[1] +
        skylight_sh_4_bands_0_005pct_packed_pair((9.99999975e-05f *
        skylight_sh_4_bands_0_005pct_packed_short[50]),
        (9.99999975e-06f * skylight_sh_4_bands_0_005pct_packed_short[51])))) * x[0] +
        (skylight_sh_4_bands_0_005pct_packed_pair((9.99999975e-06f *
        skylight_sh_4_bands_0_005pct_packed_short[52]),
        (9.99999975e-06f * skylight_sh_4_bands_0_005pct_packed_short[53])) * x[1] +
        skylight_sh_4_bands_0_005pct_packed_pair((9.99999975e-06f *
        skylight_sh_4_bands_0_005pct_packed_short[54]),
        (9.99999975e-06f * skylight_sh_4_bands_0_005pct_packed_short[55])));
    const float part_3 = y_zenith[0];
    const float shape_x = ((9.99999975e-05f * skylight_sh_4_bands_0_005pct_packed_short[13]) * x[1]
        + (9.99999975e-05f * skylight_sh_4_bands_0_005pct_packed_short[56])) * part_2[1];
    const float one = zenith / (below * shape_y * part_3 * shape_x);
    const float shape_z = ((9.99999975e-06f * skylight_sh_4_bands_0_005pct_packed_short[57]) * x[1]
        + (9.99999975e-05f * skylight_sh_4_bands_0_005pct_packed_short[58])) * part_2[2];
    const float of_x = one * y_zenith[1] * shape_z;
    const skylight_sh_4_bands_0_005pct_packed_four part_4 =
        skylight_sh_4_bands_0_005pct_packed_triple(3.73898554f, (-1.01082206f),
        (-1.00158179f)) * of_x;
    skylight_sh_4_bands_0_005pct_packed_keep(out + 4, part_4);
    const float of_y = one * part_3 * shape_x;
    const float of_s = one * shape_z * shape_x;
    const skylight_sh_4_bands_0_005pct_packed_four part_5 =
        skylight_sh_4_bands_0_005pct_packed_triple((-0.498531401f),
        (9.99999997e-07f * skylight_sh_4_bands_0_005pct_packed_short[59]), 1.05722523f) * of_s;
    skylight_sh_4_bands_0_005pct_packed_keep(out + 8, part_5);
    const skylight_sh_4_bands_0_005pct_packed_four part_6 = part_4 +
        skylight_sh_4_bands_0_005pct_packed_triple((-1.03860712f), 1.83445477f,
        (-1.26125109f)) * of_y + part_5;
    skylight_sh_4_bands_0_005pct_packed_keep(out + 0, part_6);
    (void)x;
}

#else
static inline void skylight_sh_4_bands_0_005pct_packed_factors(const
    skylight_sh_4_bands_0_005pct_packed_real *x, skylight_sh_4_bands_0_005pct_packed_real *out)
{
    const float chi = (0.888888896f - x[1] * 0.0166666675f) * (1.57079637f - x[0]);
    const float square = chi * chi;
    const float below =
        ((skylight_sh_4_bands_0_005pct_packed_real)skylight_sh_4_bands_0_005pct_packed_short[2]) -
        square *
        (((skylight_sh_4_bands_0_005pct_packed_real)skylight_sh_4_bands_0_005pct_packed_short[6]) -
        ((skylight_sh_4_bands_0_005pct_packed_real)skylight_sh_4_bands_0_005pct_packed_short[7]) *
        square);
    const float zenith = ((0.100000001f * skylight_sh_4_bands_0_005pct_packed_short[0]) * x[1] -
        ((skylight_sh_4_bands_0_005pct_packed_real)skylight_sh_4_bands_0_005pct_packed_short[1])) *
        (chi *
        (((skylight_sh_4_bands_0_005pct_packed_real)skylight_sh_4_bands_0_005pct_packed_short[2]) -
        square *
        (((skylight_sh_4_bands_0_005pct_packed_real)skylight_sh_4_bands_0_005pct_packed_short[3]) -
        square))) + ((0.100000001f * skylight_sh_4_bands_0_005pct_packed_short[4]) - (0.100000001f *
        skylight_sh_4_bands_0_005pct_packed_short[5]) * x[1]) * below;
    const float part_1 = (-9.99999975e-05f * skylight_sh_4_bands_0_005pct_packed_short[11]) * x[1] +
        (9.99999975e-05f * skylight_sh_4_bands_0_005pct_packed_short[12]);
    const float up =
        ((skylight_sh_4_bands_0_005pct_packed_real)skylight_sh_4_bands_0_005pct_packed_short[8]) +
        part_1 * ((0.00999999978f * skylight_sh_4_bands_0_005pct_packed_short[13]) + part_1 *
        (9.99999975e-06f * skylight_sh_4_bands_0_005pct_packed_short[14]));
    const float up2 = up * up;
    const float y = ((9.99999975e-05f * skylight_sh_4_bands_0_005pct_packed_short[21]) * x[1] +
        (-9.99999975e-05f * skylight_sh_4_bands_0_005pct_packed_short[24])) * x[0] * (0.00999999978f
        * skylight_sh_4_bands_0_005pct_packed_short[13]);
    const float y2 = y * y;
    const float halo = 1.0f + 0.99999845f * y + y2 * (0.499975085f + 0.166515172f * y + y2 *
        (0.0412233174f + 0.00765432511f * y + y2 * 0.000849007862f));
    const float halo2 = halo * halo;
    const float halo4 = halo2 * halo2;
    const float z = x[0] * x[0];
    const float cosine =
        ((skylight_sh_4_bands_0_005pct_packed_real)skylight_sh_4_bands_0_005pct_packed_short[8]) - z
        * ((0.100000001f * skylight_sh_4_bands_0_005pct_packed_short[33]) - z * (9.99999975e-06f *
        skylight_sh_4_bands_0_005pct_packed_short[14]));
    const float cosine2 = cosine * cosine;
    const float shape_y =
        (((skylight_sh_4_bands_0_005pct_packed_real)skylight_sh_4_bands_0_005pct_packed_short[8]) +
        ((9.99999975e-05f * skylight_sh_4_bands_0_005pct_packed_short[9]) * x[1] + (-0.00100000005f
        * skylight_sh_4_bands_0_005pct_packed_short[10])) * (up2 * up2)) *
        (((skylight_sh_4_bands_0_005pct_packed_real)skylight_sh_4_bands_0_005pct_packed_short[8]) +
        ((-9.99999975e-05f * skylight_sh_4_bands_0_005pct_packed_short[15]) * x[1] +
        (9.99999975e-05f * skylight_sh_4_bands_0_005pct_packed_short[18])) * halo4 +
        ((-0.00100000005f * skylight_sh_4_bands_0_005pct_packed_short[27]) * x[1] + (9.99999975e-05f
        * skylight_sh_4_bands_0_005pct_packed_short[30])) * cosine2);
    const float y_zenith = (((((9.99999975e-06f * skylight_sh_4_bands_0_005pct_packed_short[34]) *
        x[1] + (-9.99999975e-06f * skylight_sh_4_bands_0_005pct_packed_short[36])) * x[1] +
        (9.99999975e-06f * skylight_sh_4_bands_0_005pct_packed_short[38])) * x[0] +
        (((-9.99999975e-05f * skylight_sh_4_bands_0_005pct_packed_short[40]) * x[1] +
        (9.99999975e-05f * skylight_sh_4_bands_0_005pct_packed_short[42])) * x[1] +
        (-9.99999975e-06f * skylight_sh_4_bands_0_005pct_packed_short[44]))) * x[0] +
        (((9.99999975e-06f * skylight_sh_4_bands_0_005pct_packed_short[46]) * x[1] +
        (-9.99999975e-06f * skylight_sh_4_bands_0_005pct_packed_short[48])) * x[1] +
        (9.99999975e-05f * skylight_sh_4_bands_0_005pct_packed_short[50]))) * x[0] +
        ((9.99999975e-06f * skylight_sh_4_bands_0_005pct_packed_short[52]) * x[1] + (9.99999975e-06f
        * skylight_sh_4_bands_0_005pct_packed_short[54]));
    const float y_2 = ((-9.99999975e-05f * skylight_sh_4_bands_0_005pct_packed_short[22]) * x[1] +
        (-9.99999975e-05f * skylight_sh_4_bands_0_005pct_packed_short[25])) * x[0] * (0.00999999978f
        * skylight_sh_4_bands_0_005pct_packed_short[13]);
    const float y2_2 = y_2 * y_2;
    const float halo_2 = 1.0f + 0.99999845f * y_2 + y2_2 * (0.499975085f + 0.166515172f * y_2 + y2_2
        * (0.0412233174f + 0.00765432511f * y_2 + y2_2 * 0.000849007862f));
    const float halo2_2 = halo_2 * halo_2;
    const float halo4_2 = halo2_2 * halo2_2;
    const float shape_x = ((9.99999975e-05f * skylight_sh_4_bands_0_005pct_packed_short[13]) * x[1]
        + (9.99999975e-05f * skylight_sh_4_bands_0_005pct_packed_short[56])) *
        (((skylight_sh_4_bands_0_005pct_packed_real)skylight_sh_4_bands_0_005pct_packed_short[8]) +
        ((-9.99999975e-05f * skylight_sh_4_bands_0_005pct_packed_short[16]) * x[1] +
        (9.99999975e-05f * skylight_sh_4_bands_0_005pct_packed_short[19])) * halo4_2 +
        ((-9.99999975e-05f * skylight_sh_4_bands_0_005pct_packed_short[28]) * x[1] +
        (9.99999975e-05f * skylight_sh_4_bands_0_005pct_packed_short[31])) * cosine2);
    const float one = zenith / (below * shape_y * y_zenith * shape_x);
    const float x_zenith = (((((9.99999975e-06f * skylight_sh_4_bands_0_005pct_packed_short[35]) *
        x[1] + (-9.99999975e-06f * skylight_sh_4_bands_0_005pct_packed_short[37])) * x[1] +
        (9.99999975e-06f * skylight_sh_4_bands_0_005pct_packed_short[39])) * x[0] +
        (((-9.99999975e-06f * skylight_sh_4_bands_0_005pct_packed_short[41]) * x[1] +
        (9.99999975e-06f * skylight_sh_4_bands_0_005pct_packed_short[43])) * x[1] +
        (-9.99999975e-06f * skylight_sh_4_bands_0_005pct_packed_short[45]))) * x[0] +
        (((9.99999975e-06f * skylight_sh_4_bands_0_005pct_packed_short[47]) * x[1] +
        (-9.99999975e-06f * skylight_sh_4_bands_0_005pct_packed_short[49])) * x[1] +
        (9.99999975e-06f * skylight_sh_4_bands_0_005pct_packed_short[51]))) * x[0] +
        ((9.99999975e-06f * skylight_sh_4_bands_0_005pct_packed_short[53]) * x[1] + (9.99999975e-06f
        * skylight_sh_4_bands_0_005pct_packed_short[55]));
    const float y_3 = ((-9.99999975e-05f * skylight_sh_4_bands_0_005pct_packed_short[23]) * x[1] +
        (-9.99999975e-05f * skylight_sh_4_bands_0_005pct_packed_short[26])) * x[0] * (0.00999999978f
        * skylight_sh_4_bands_0_005pct_packed_short[13]);
    const float y2_3 = y_3 * y_3;
    const float halo_3 = 1.0f + 0.99999845f * y_3 + y2_3 * (0.499975085f + 0.166515172f * y_3 + y2_3
        * (0.0412233174f + 0.00765432511f * y_3 + y2_3 * 0.000849007862f));
    const float halo2_3 = halo_3 * halo_3;
    const float halo4_3 = halo2_3 * halo2_3;
    const float shape_z = ((9.99999975e-06f * skylight_sh_4_bands_0_005pct_packed_short[57]) * x[1]
        + (9.99999975e-05f * skylight_sh_4_bands_0_005pct_packed_short[58])) *
        (((skylight_sh_4_bands_0_005pct_packed_real)skylight_sh_4_bands_0_005pct_packed_short[8]) +
        ((-9.99999975e-05f * skylight_sh_4_bands_0_005pct_packed_short[17]) * x[1] +
        (9.99999975e-05f * skylight_sh_4_bands_0_005pct_packed_short[20])) * halo4_3 +
        ((-9.99999975e-05f * skylight_sh_4_bands_0_005pct_packed_short[29]) * x[1] +
        (9.99999975e-05f * skylight_sh_4_bands_0_005pct_packed_short[32])) * cosine2);
    const float of_x = one * x_zenith * shape_z;
    out[4] = 3.73898554f * of_x;
    const float of_y = one * y_zenith * shape_x;
    const float of_s = one * shape_z * shape_x;
    out[8] = (-0.498531401f) * of_s;
    out[0] = out[4] + (-1.03860712f) * of_y + out[8];
    out[5] = (-1.01082206f) * of_x;
    out[9] = (9.99999997e-07f * skylight_sh_4_bands_0_005pct_packed_short[59]) * of_s;
    out[1] = out[5] + 1.83445477f * of_y + out[9];
    out[6] = (-1.00158179f) * of_x;
    out[10] = 1.05722523f * of_s;
    out[2] = out[6] + (-1.26125109f) * of_y + out[10];
    out[3] = 0;
    out[7] = 0;
    out[11] = 0;
    (void)x;
}

#endif /* SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_LANES */

/* The functions of sun_zenith (change of variable: even); 0 where there is
   none. */
static inline void skylight_sh_4_bands_0_005pct_packed_first(const
    skylight_sh_4_bands_0_005pct_packed_real *x, skylight_sh_4_bands_0_005pct_packed_real *out)
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
static inline void skylight_sh_4_bands_0_005pct_packed_others(const
    skylight_sh_4_bands_0_005pct_packed_real *x, skylight_sh_4_bands_0_005pct_packed_real *out)
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
    skylight_sh_4_bands_0_005pct_packed_waves(skylight_sh_4_bands_0_005pct_packed_real cosine,
    skylight_sh_4_bands_0_005pct_packed_real sine, skylight_sh_4_bands_0_005pct_packed_real radius,
    skylight_sh_4_bands_0_005pct_packed_real *cosines,
    skylight_sh_4_bands_0_005pct_packed_real *sines)
{
    cosines[0] = 1.0f;
    cosines[1] = radius * cosine;
    sines[1] = radius * sine;
    cosines[2] = cosines[1] * cosines[1] - sines[1] * sines[1];
    sines[2] = sines[1] * cosines[1] + cosines[1] * sines[1];
    cosines[3] = cosines[1] * cosines[2] - sines[1] * sines[2];
    sines[0] = 0.0f;
    sines[3] = sines[1] * cosines[2] + cosines[1] * sines[2];
}

/* The sine of the sun's zenith angle, whose powers the sums of order m
   lack. */
static inline skylight_sh_4_bands_0_005pct_packed_real
    skylight_sh_4_bands_0_005pct_packed_sine(const skylight_sh_4_bands_0_005pct_packed_real *x)
{
    const float part_1 = x[SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_SUN] *
        x[SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_SUN];
    return x[SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_SUN] + x[SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_SUN] *
        (part_1 * ((-0.166666597f) + part_1 * (0.00833306555f + part_1 * ((-0.000198095426f) +
        part_1 * 2.60563934e-06f))));
}

/* Cosine and sine of an angle of at most an eighth of a turn. */
static inline void
    skylight_sh_4_bands_0_005pct_packed_quarter(skylight_sh_4_bands_0_005pct_packed_real angle,
    skylight_sh_4_bands_0_005pct_packed_real *out)
{
    const float part_1 = angle * angle;
    out[0] = 1.0f - 0.5f * part_1 + part_1 * part_1 * (0.0416666456f + part_1 * ((-0.00138873665f) +
        part_1 * 2.44383464e-05f));
    out[1] = angle + angle * (part_1 * ((-0.166666552f) + part_1 * (0.0083321603f + part_1 *
        (-0.00019515281f))));
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
static inline void skylight_sh_4_bands_0_005pct_packed_factor_slopes(const double *x, double *out)
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
    const double y2 = y * y;
    const double part_16 = 0.041223317699999998 + 0.0076543250999999996 * y + y2 *
        0.00084900787100000003;
    const double part_17 = 0.49997509099999998 + 0.16651516699999999 * y + y2 * part_16;
    const double halo = 0.99999998400000001 + 0.99999845399999998 * y + y2 * part_17;
    const double halo2 = halo * halo;
    const double halo4 = halo2 * halo2;
    const double part_18 = (-0.067000000000000004) * x[1] + 0.37030000000000002;
    const double z = x[0] * x[0];
    const double part_19 = 0.5 - z * 0.03125;
    const double cosine = 1.0 - z * part_19;
    const double cosine2 = cosine * cosine;
    const double part_20 = 1.0 + part_14 * halo4 + part_18 * cosine2;
    const double shape_y = part_13 * part_20;
    const double part_21 = below * shape_y;
    const double part_22 = 0.0027499999999999998 * x[1] + (-0.042139999999999997);
    const double part_23 = part_22 * x[1] + 0.15346000000000001;
    const double part_24 = (-0.0061000000000000004) * x[1] + 0.089700000000000002;
    const double part_25 = part_23 * x[0] + (part_24 * x[1] + (-0.26756000000000002));
    const double part_26 = 0.0031700000000000001 * x[1] + (-0.041529999999999997);
    const double part_27 = part_25 * x[0] + (part_26 * x[1] + 0.066699999999999995);
    const double y_zenith = part_27 * x[0] + (0.0051599999999999997 * x[1] + 0.26688000000000001);
    const double part_28 = part_21 * y_zenith;
    const double part_29 = 0.0025000000000000001 * x[1] + 0.73319999999999996;
    const double part_30 = (-0.00040000000000000002) * x[1] + 0.21249999999999999;
    const double part_31 = (-0.064100000000000004) * x[1] + (-0.89890000000000003);
    const double y_2 = part_31 * x[0] * 0.25;
    const double y2_2 = y_2 * y_2;
    const double part_32 = 0.041223317699999998 + 0.0076543250999999996 * y_2 + y2_2 *
        0.00084900787100000003;
    const double part_33 = 0.49997509099999998 + 0.16651516699999999 * y_2 + y2_2 * part_32;
    const double halo_2 = 0.99999998400000001 + 0.99999845399999998 * y_2 + y2_2 * part_33;
    const double halo2_2 = halo_2 * halo_2;
    const double halo4_2 = halo2_2 * halo2_2;
    const double part_34 = (-0.0033) * x[1] + 0.045199999999999997;
    const double part_35 = 1.0 + part_30 * halo4_2 + part_34 * cosine2;
    const double shape_x = part_29 * part_35;
    const double part_36 = part_28 * shape_x;
    const double one = zenith / part_36;
    const double part_37 = 0.00166 * x[1] + (-0.02903);
    const double part_38 = part_37 * x[1] + 0.11693000000000001;
    const double part_39 = (-0.0037499999999999999) * x[1] + 0.063769999999999993;
    const double part_40 = part_38 * x[0] + (part_39 * x[1] + (-0.21196000000000001));
    const double part_41 = 0.0020899999999999998 * x[1] + (-0.03202);
    const double part_42 = part_40 * x[0] + (part_41 * x[1] + 0.060519999999999997);
    const double x_zenith = part_42 * x[0] + (0.0039399999999999999 * x[1] + 0.25885999999999998);
    const double part_43 = one * x_zenith;
    const double part_44 = 0.0099299999999999996 * x[1] + 0.73440000000000005;
    const double part_45 = (-0.0079000000000000008) * x[1] + 0.2102;
    const double part_46 = (-0.0441) * x[1] + (-1.6536999999999999);
    const double y_3 = part_46 * x[0] * 0.25;
    const double y2_3 = y_3 * y_3;
    const double part_47 = 0.041223317699999998 + 0.0076543250999999996 * y_3 + y2_3 *
        0.00084900787100000003;
    const double part_48 = 0.49997509099999998 + 0.16651516699999999 * y_3 + y2_3 * part_47;
    const double halo_3 = 0.99999998400000001 + 0.99999845399999998 * y_3 + y2_3 * part_48;
    const double halo2_3 = halo_3 * halo_3;
    const double halo4_3 = halo2_3 * halo2_3;
    const double part_49 = (-0.0109) * x[1] + 0.052900000000000003;
    const double part_50 = 1.0 + part_45 * halo4_3 + part_49 * cosine2;
    const double shape_z = part_44 * part_50;
    const double of_x = part_43 * shape_z;
    out[4] = 3.7389855999999999 * of_x;
    const double part_51 = one * y_zenith;
    const double of_y = part_51 * shape_x;
    const double part_52 = one * shape_z;
    const double of_s = part_52 * shape_x;
    out[8] = (-0.49853140000000001) * of_s;
    out[0] = out[4] + (-1.0386070999999999) * of_y + out[8];
    out[5] = (-1.0108219999999999) * of_x;
    out[9] = 0.041556000000000003 * of_s;
    out[1] = out[5] + 1.8344548000000001 * of_y + out[9];
    out[6] = (-1.0015818000000001) * of_x;
    out[10] = 1.0572252 * of_s;
    out[2] = out[6] + (-1.2612511) * of_y + out[10];
    const double part_53 = part_2 * -1.0;
    const double part_54 = part_53 * chi + chi * part_53;
    const double part_55 = -(part_54 * part_8 + square * -(15.0 * part_54));
    const double part_56 = part_15 * 0.25;
    const double part_57 = part_56 * y + y * part_56;
    const double part_58 = 0.99999845399999998 * part_56 + (part_57 * part_17 + y2 *
        (0.16651516699999999 * part_56 + (part_57 * part_16 + y2 * (0.0076543250999999996 * part_56
        + part_57 * 0.00084900787100000003))));
    const double part_59 = part_58 * halo + halo * part_58;
    const double part_60 = x[0] + x[0];
    const double part_61 = -(part_60 * part_19 + z * -(part_60 * 0.03125));
    const double part_62 = part_61 * cosine + cosine * part_61;
    const double part_63 = (part_23 * x[0] + part_25) * x[0] + part_27;
    const double part_64 = part_31 * 0.25;
    const double part_65 = part_64 * y_2 + y_2 * part_64;
    const double part_66 = 0.99999845399999998 * part_64 + (part_65 * part_33 + y2_2 *
        (0.16651516699999999 * part_64 + (part_65 * part_32 + y2_2 * (0.0076543250999999996 *
        part_64 + part_65 * 0.00084900787100000003))));
    const double part_67 = part_66 * halo_2 + halo_2 * part_66;
    const double part_68 = part_29 * (part_30 * (part_67 * halo2_2 + halo2_2 * part_67) + part_34 *
        part_62);
    const double part_69 = (part_1 * (part_53 * part_5 + chi * -(part_54 * part_4 + square *
        -part_54)) + part_7 * part_55) / part_36 - one * (((part_55 * shape_y + below * (part_13 *
        (part_14 * (part_59 * halo2 + halo2 * part_59) + part_18 * part_62))) * y_zenith + part_21 *
        part_63) * shape_x + part_28 * part_68) / part_36;
    const double part_70 = part_46 * 0.25;
    const double part_71 = part_70 * y_3 + y_3 * part_70;
    const double part_72 = 0.99999845399999998 * part_70 + (part_71 * part_48 + y2_3 *
        (0.16651516699999999 * part_70 + (part_71 * part_47 + y2_3 * (0.0076543250999999996 *
        part_70 + part_71 * 0.00084900787100000003))));
    const double part_73 = part_72 * halo_3 + halo_3 * part_72;
    const double part_74 = part_44 * (part_45 * (part_73 * halo2_3 + halo2_3 * part_73) + part_49 *
        part_62);
    const double part_75 = (part_69 * x_zenith + one * ((part_38 * x[0] + part_40) * x[0] +
        part_42)) * shape_z + part_43 * part_74;
    out[16] = 3.7389855999999999 * part_75;
    const double part_76 = (part_69 * y_zenith + one * part_63) * shape_x + part_51 * part_68;
    const double part_77 = (part_69 * shape_z + one * part_74) * shape_x + part_52 * part_68;
    out[20] = (-0.49853140000000001) * part_77;
    out[12] = out[16] + (-1.0386070999999999) * part_76 + out[20];
    out[17] = (-1.0108219999999999) * part_75;
    out[21] = 0.041556000000000003 * part_77;
    out[13] = out[17] + 1.8344548000000001 * part_76 + out[21];
    out[18] = (-1.0015818000000001) * part_75;
    out[22] = 1.0572252 * part_77;
    out[14] = out[18] + (-1.2612511) * part_76 + out[22];
    const double part_78 = -0.016666666666666666 * part_3;
    const double part_79 = part_78 * chi + chi * part_78;
    const double part_80 = -(part_79 * part_8 + square * -(15.0 * part_79));
    const double part_81 = (-0.35539999999999999) * part_11 + part_10 * ((-0.35539999999999999) *
        0.03125);
    const double part_82 = part_81 * up + up * part_81;
    const double part_83 = 0.1206 * x[0] * 0.25;
    const double part_84 = part_83 * y + y * part_83;
    const double part_85 = 0.99999845399999998 * part_83 + (part_84 * part_17 + y2 *
        (0.16651516699999999 * part_83 + (part_84 * part_16 + y2 * (0.0076543250999999996 * part_83
        + part_84 * 0.00084900787100000003))));
    const double part_86 = part_85 * halo + halo * part_85;
    const double part_87 = (((0.0027499999999999998 * x[1] + part_22) * x[0] +
        ((-0.0061000000000000004) * x[1] + part_24)) * x[0] + (0.0031700000000000001 * x[1] +
        part_26)) * x[0] + 0.0051599999999999997;
    const double part_88 = (-0.064100000000000004) * x[0] * 0.25;
    const double part_89 = part_88 * y_2 + y_2 * part_88;
    const double part_90 = 0.99999845399999998 * part_88 + (part_89 * part_33 + y2_2 *
        (0.16651516699999999 * part_88 + (part_89 * part_32 + y2_2 * (0.0076543250999999996 *
        part_88 + part_89 * 0.00084900787100000003))));
    const double part_91 = part_90 * halo_2 + halo_2 * part_90;
    const double part_92 = 0.0025000000000000001 * part_35 + part_29 * ((-0.00040000000000000002) *
        halo4_2 + part_30 * (part_91 * halo2_2 + halo2_2 * part_91) + (-0.0033) * cosine2);
    const double part_93 = (4045.3000000000002 * part_6 + part_1 * (part_78 * part_5 + chi *
        -(part_79 * part_4 + square * -part_79)) + (-215.5 * below + part_7 * part_80)) / part_36 -
        one * (((part_80 * shape_y + below * ((0.1787 * part_12 + part_9 * (part_82 * up2 + up2 *
        part_82)) * part_20 + part_13 * ((-0.022700000000000001) * halo4 + part_14 * (part_86 *
        halo2 + halo2 * part_86) + (-0.067000000000000004) * cosine2))) * y_zenith + part_21 *
        part_87) * shape_x + part_28 * part_92) / part_36;
    const double part_94 = (-0.0441) * x[0] * 0.25;
    const double part_95 = part_94 * y_3 + y_3 * part_94;
    const double part_96 = 0.99999845399999998 * part_94 + (part_95 * part_48 + y2_3 *
        (0.16651516699999999 * part_94 + (part_95 * part_47 + y2_3 * (0.0076543250999999996 *
        part_94 + part_95 * 0.00084900787100000003))));
    const double part_97 = part_96 * halo_3 + halo_3 * part_96;
    const double part_98 = 0.0099299999999999996 * part_50 + part_44 * ((-0.0079000000000000008) *
        halo4_3 + part_45 * (part_97 * halo2_3 + halo2_3 * part_97) + (-0.0109) * cosine2);
    const double part_99 = (part_93 * x_zenith + one * ((((0.00166 * x[1] + part_37) * x[0] +
        ((-0.0037499999999999999) * x[1] + part_39)) * x[0] + (0.0020899999999999998 * x[1] +
        part_41)) * x[0] + 0.0039399999999999999)) * shape_z + part_43 * part_98;
    out[28] = 3.7389855999999999 * part_99;
    const double part_100 = (part_93 * y_zenith + one * part_87) * shape_x + part_51 * part_92;
    const double part_101 = (part_93 * shape_z + one * part_98) * shape_x + part_52 * part_92;
    out[32] = (-0.49853140000000001) * part_101;
    out[24] = out[28] + (-1.0386070999999999) * part_100 + out[32];
    out[29] = (-1.0108219999999999) * part_99;
    out[33] = 0.041556000000000003 * part_101;
    out[25] = out[29] + 1.8344548000000001 * part_100 + out[33];
    out[30] = (-1.0015818000000001) * part_99;
    out[34] = 1.0572252 * part_101;
    out[26] = out[30] + (-1.2612511) * part_100 + out[34];
    (void)x;
}

/* The sine of the sun's zenith angle, then its slope. */
static inline void skylight_sh_4_bands_0_005pct_packed_sine_slope(const double *x, double *out)
{
    out[0] = sin(x[SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_SUN]);
    out[1] = cos(x[SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_SUN]);
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
        const float v = strange ? skylight_sh_4_bands_0_005pct_packed_finite(inputs[axis]) :
            inputs[axis];
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

/* The cosine and sine of an angle. */
static inline void
    skylight_sh_4_bands_0_005pct_packed_circle(skylight_sh_4_bands_0_005pct_packed_real angle,
    skylight_sh_4_bands_0_005pct_packed_real *cosine,
                                      skylight_sh_4_bands_0_005pct_packed_real *sine)
{
    /* By the nearest quarter turn and the rest of it: without a branch, which a processor would
     * have
       to guess. The rest in double, since the two nearly cancel. */
    float out[2];
    uint32_t bits[2], quarter, swapped;
    int quarters;
    if (!(angle > -1e5f && angle < 1e5f)) {
        *cosine = cosf(angle);
        *sine = sinf(angle);
        return;
    }
    quarters = (int)(angle * 0.636619772f + copysignf(0.5f, angle));
    skylight_sh_4_bands_0_005pct_packed_quarter((float)((double)angle - (double)quarters *
        1.5707963267948966), out);
    memcpy(bits, out, sizeof bits);
    quarter = (uint32_t)quarters;
    /* Odd quarters swap the two; each changes its sign in two of four. */
    swapped = (bits[0] ^ bits[1]) & (0u - (quarter & 1u));
    bits[0] ^= swapped ^ (((quarter + 1u) & 2u) << 30);
    bits[1] ^= swapped ^ ((quarter & 2u) << 30);
    memcpy(cosine, &bits[0], sizeof bits[0]);
    memcpy(sine, &bits[1], sizeof bits[1]);
}

/* One channel's sums, from those of its classes. */
static inline void skylight_sh_4_bands_0_005pct_packed_mix(skylight_sh_4_bands_0_005pct_packed_real
    sums[SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_CLASSES][SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_ROOM],
                                   int channel,
                                       const skylight_sh_4_bands_0_005pct_packed_real *factors,
                                   skylight_sh_4_bands_0_005pct_packed_real *mixed)
{
    int i;
    int k;
    for (i = 0; i < SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_WIDTH; ++i)
        mixed[i] = factors[SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_FACTOR(channel, 0)] * sums[0][i];
    for (k = 1; k < SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_CLASSES; ++k)
        for (i = 0; i < SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_WIDTH; ++i)
            mixed[i] += factors[SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_FACTOR(channel,
                k)] * sums[k][i];
}

/* Orders m >= 0 alone are stored: those of a light that is even in y at azimuth 0. */
#define SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_FIRST_ORDER(l) 0

/* Stores one weight of degree l and order m turned by the azimuth. */
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

/* Stores the first `bands` bands of the channels' weights, turned by the azimuth (Habel et al.
 * 2008,
   eq. 4 with nothing for m < 0). */
static inline void skylight_sh_4_bands_0_005pct_packed_store(
    skylight_sh_4_bands_0_005pct_packed_real
        sums[SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_CLASSES][SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_ROOM],
        const skylight_sh_4_bands_0_005pct_packed_real *factors,
    const skylight_sh_4_bands_0_005pct_packed_real *cosines,
        const skylight_sh_4_bands_0_005pct_packed_real *sines, int bands,
    float
        weights[SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_CHANNELS]
        [SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_WEIGHTS])
{
    int channel;
#if defined(SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_LANES) && \
    SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_BANDS > 3
    /* In fours; each overshoot is overwritten by what follows. */
    float plus[SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_BANDS],
        minus[SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_BANDS + 3] = {0};
    int m, q;
    for (m = 0; m < SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_BANDS; ++m) {
        plus[m] = cosines[m];
        minus[SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_BANDS - 1 - m] = sines[m];
    }
    for (channel = 0; channel < SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_CHANNELS; ++channel) {
        float *const w = weights[channel];
        skylight_sh_4_bands_0_005pct_packed_four v[SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_FOURS];
        for (q = 0; q < SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_FOURS; ++q) {
            int k;
            v[q] = factors[SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_FACTOR(channel,
                0)] * skylight_sh_4_bands_0_005pct_packed_load_four(sums[0] + 4 * q);
            for (k = 1; k < SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_CLASSES; ++k)
                v[q] = skylight_sh_4_bands_0_005pct_packed_add_four(
                    skylight_sh_4_bands_0_005pct_packed_spread_four(factors
                        [SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_FACTOR(channel, k)]),
                    skylight_sh_4_bands_0_005pct_packed_load_four(sums[k] + 4 * q), v[q]);
        }
#define SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_BAND(l, stores) \
    if (bands > (l)) { stores }
#define SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_NOTHING(place, count) memset(w + (place), 0, \
    sizeof(float) * (count));
#define SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_MINUS(place, q, r, a, b, c, d, order) \
    skylight_sh_4_bands_0_005pct_packed_keep(w + (place), \
                     SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_PICK(v[q], v[r], a, b, c, d) * \
                         skylight_sh_4_bands_0_005pct_packed_load_four(minus + \
                             SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_BANDS - 1 - (order)));
#define SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_PLUS(place, q, r, a, b, c, d, order) \
    skylight_sh_4_bands_0_005pct_packed_keep(w + (place), \
        SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_PICK(v[q], v[r], a, b, c, d) * \
                                      skylight_sh_4_bands_0_005pct_packed_load_four(plus + \
                                          (order)));
        SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_STORES(SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_BAND,
            SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_NOTHING, SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_MINUS,
                           SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_PLUS)
#undef SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_BAND
#undef SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_NOTHING
#undef SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_MINUS
#undef SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_PLUS
    }
#else
    static const short columns[SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_BANDS] =
        SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_COLUMNS;
    for (channel = 0; channel < SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_CHANNELS; ++channel) {
        skylight_sh_4_bands_0_005pct_packed_real v[SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_WIDTH];
        int l, m;
        skylight_sh_4_bands_0_005pct_packed_mix(sums, channel, factors, v);
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

#ifdef SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_LANES

/* Vectors that the first `count` numbers of a row take, and those that are summed at once, in
   registers. */
#define SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_VECTORS(count) (((count) + \
    SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_LANES - 1) / SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_LANES)
#define SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_BLOCKS \
    ((SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_VECTORS(SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_WIDTH) + 6) \
    / 7)
#define SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_BLOCK \
    ((SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_VECTORS(SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_WIDTH) + \
        SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_BLOCKS - 1) / \
        SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_BLOCKS)
/* What is done for each vector of a block: written out, since a compiler that keeps loops keeps
 * their
   vectors in memory. */
#define SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_EACH(DO) DO(0) DO(1) DO(2) DO(3) DO(4) DO(5) DO(6) DO(7)
#endif

/* The products of the functions of all axes, of one class in the order of its rows. */
static inline void skylight_sh_4_bands_0_005pct_packed_multiply(int class_,
    const skylight_sh_4_bands_0_005pct_packed_real *first,
                                        const skylight_sh_4_bands_0_005pct_packed_real *others,
                                            skylight_sh_4_bands_0_005pct_packed_real *products)
{
    int i;
#ifdef SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_LANES
    /* In fours: each overshoot is overwritten by the next line. */
#define SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_PRODUCT(which, place, count, other) \
    for (i = 0; i < (count) && class_ == (which); i += 4) \
        skylight_sh_4_bands_0_005pct_packed_keep(products + (place) + i, \
                         skylight_sh_4_bands_0_005pct_packed_load_four(first + i) * others[other]);
#else
#define SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_PRODUCT(which, place, count, other) \
    for (i = 0; i < (count) && class_ == (which); ++i) products[(place) + i] = first[i] * \
        others[other];
#endif
    SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_PRODUCTS(SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_PRODUCT)
#undef SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_PRODUCT
}
#ifdef SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_LANES

/* Rows whose sums run side by side, so that no sum waits for the one before. */
#define SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_SIDE (SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_BLOCK > 4 ? \
    1 : SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_BLOCK > 2 ? 2 : 4)

/* sums = sum over t of products[t] * row t: SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_BLOCK vectors of
 * each row, which stay in
   registers. */
static inline void skylight_sh_4_bands_0_005pct_packed_sum_block(const
    skylight_sh_4_bands_0_005pct_packed_real *row, int terms,
                                         const skylight_sh_4_bands_0_005pct_packed_real *products,
                                             skylight_sh_4_bands_0_005pct_packed_real *sums)
{
    skylight_sh_4_bands_0_005pct_packed_lanes total[8];
    int t;
#define SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_ZERO(k) total[k] = \
    skylight_sh_4_bands_0_005pct_packed_spread(0);
    /* Vector k of so many rows side by side. */
#define SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_ROWS(k) \
    if ((k) / SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_BLOCK < \
        SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_SIDE) \
        total[k] = skylight_sh_4_bands_0_005pct_packed_add( \
            skylight_sh_4_bands_0_005pct_packed_spread(products[t + (k) / \
                SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_BLOCK]), \
            skylight_sh_4_bands_0_005pct_packed_load(row + (k) / \
                SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_BLOCK * \
                SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_WIDTH + \
                             (k) % SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_BLOCK * \
                                 SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_LANES), \
            total[k]);
#define SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_ROW(k) \
    if ((k) < SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_BLOCK) \
        total[k] = \
            skylight_sh_4_bands_0_005pct_packed_add(skylight_sh_4_bands_0_005pct_packed_spread( \
            products[t]), \
                                   skylight_sh_4_bands_0_005pct_packed_load(row + (k) * \
                                       SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_LANES), total[k]);
#define SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_SIDES(k) \
    if ((k) >= SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_BLOCK) total[(k) % \
        SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_BLOCK] += total[k];
#define SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_SUM(k) \
    if ((k) < SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_BLOCK) memcpy(sums + (k) * \
        SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_LANES, &total[k], sizeof total[k]);
    SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_EACH(SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_ZERO)
    for (t = 0; t + SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_SIDE <= terms; t +=
        SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_SIDE) {
        SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_EACH(SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_ROWS)
        row += SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_SIDE * SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_WIDTH;
    }
    for (; t < terms; ++t) {
        SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_EACH(SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_ROW)
        row += SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_WIDTH;
    }
    SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_EACH(SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_SIDES)
    SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_EACH(SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_SUM)
#undef SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_ZERO
#undef SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_ROWS
#undef SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_ROW
#undef SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_SIDES
#undef SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_SUM
}

/* The same for one vector of each row. */
static inline void skylight_sh_4_bands_0_005pct_packed_sum_vector(const
    skylight_sh_4_bands_0_005pct_packed_real *row, int terms,
                                          const skylight_sh_4_bands_0_005pct_packed_real *products,
                                              skylight_sh_4_bands_0_005pct_packed_real *sums)
{
    skylight_sh_4_bands_0_005pct_packed_lanes total = skylight_sh_4_bands_0_005pct_packed_spread(0),
        other = skylight_sh_4_bands_0_005pct_packed_spread(0);
    int t;
    for (t = 0; t + 2 <= terms; t += 2) {
        total =
            skylight_sh_4_bands_0_005pct_packed_add(skylight_sh_4_bands_0_005pct_packed_spread(
            products[t]), skylight_sh_4_bands_0_005pct_packed_load(row), total);
        other =
            skylight_sh_4_bands_0_005pct_packed_add(skylight_sh_4_bands_0_005pct_packed_spread(
            products[t + 1]),
                                skylight_sh_4_bands_0_005pct_packed_load(row +
                                    SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_WIDTH), other);
        row += 2 * SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_WIDTH;
    }
    if (t < terms)
        total =
            skylight_sh_4_bands_0_005pct_packed_add(skylight_sh_4_bands_0_005pct_packed_spread(
            products[t]), skylight_sh_4_bands_0_005pct_packed_load(row), total);
    total += other;
    memcpy(sums, &total, sizeof total);
}

/* The first `count` numbers of the sum over t of products[t] * row t. */
static inline void skylight_sh_4_bands_0_005pct_packed_sum(const
    skylight_sh_4_bands_0_005pct_packed_real *row, int terms,
                                   const skylight_sh_4_bands_0_005pct_packed_real *products,
                                       int count,
                                   skylight_sh_4_bands_0_005pct_packed_real *sums)
{
    const int vectors = SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_VECTORS(count);
    int k = 0;
    if (vectors >= SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_BLOCK) {
        for (; k + SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_BLOCK <= vectors; k +=
            SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_BLOCK)
            skylight_sh_4_bands_0_005pct_packed_sum_block(row + k *
                SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_LANES, terms, products,
                                  sums + k * SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_LANES);
    }
    for (; k < vectors; ++k)
        skylight_sh_4_bands_0_005pct_packed_sum_vector(row + k *
            SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_LANES, terms, products,
                               sums + k * SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_LANES);
}
#else

/* The first `count` numbers of the sum over t of products[t] * row t, four rows a pass: no
   reduction, so that it vectorises. */
static inline void skylight_sh_4_bands_0_005pct_packed_sum(const
    skylight_sh_4_bands_0_005pct_packed_real *row, int terms,
                                   const skylight_sh_4_bands_0_005pct_packed_real *products,
                                       int count,
                                   skylight_sh_4_bands_0_005pct_packed_real *sums)
{
    int t, k;
    for (k = 0; k < SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_ROOM; ++k) sums[k] = 0;
    for (t = 0; t + 4 <= terms; t += 4) {
        const skylight_sh_4_bands_0_005pct_packed_real a = products[t], b = products[t + 1];
        const skylight_sh_4_bands_0_005pct_packed_real c = products[t + 2], d = products[t + 3];
        for (k = 0; k < count; ++k)
            sums[k] += (a * row[k] + b * row[k + SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_WIDTH]) +
                       (c * row[k + 2 * SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_WIDTH] + d * row[k + 3 *
                           SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_WIDTH]);
        row += 4 * SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_WIDTH;
    }
    for (; t < terms; ++t) {
        for (k = 0; k < count; ++k) sums[k] += products[t] * row[k];
        row += SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_WIDTH;
    }
}
#endif

/* The sums of one class's rows, one a term, for the first `bands` bands. */
static inline void skylight_sh_4_bands_0_005pct_packed_sum_class(const
    skylight_sh_4_bands_0_005pct_packed_real *rows, int class_,
                                         const skylight_sh_4_bands_0_005pct_packed_real *first,
                                         const skylight_sh_4_bands_0_005pct_packed_real *others,
                                             int bands,
                                         skylight_sh_4_bands_0_005pct_packed_real *sums)
{
    static const unsigned short starts[SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_CLASSES] =
        SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_STARTS;
    static const unsigned short counts[SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_CLASSES] =
        SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_COUNTS;
    static const unsigned short places[SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_CLASSES] =
        SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_PLACES;
    static const unsigned short widths[SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_BANDS] =
        SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_WIDTHS;
    const skylight_sh_4_bands_0_005pct_packed_real *const row = rows + (int)starts[class_] *
        SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_WIDTH;
    skylight_sh_4_bands_0_005pct_packed_real
        products[SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_PRODUCTS_ROOM];
    skylight_sh_4_bands_0_005pct_packed_multiply(class_, first, others, products);
    if (bands == SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_BANDS) {
        skylight_sh_4_bands_0_005pct_packed_sum(row, counts[class_], products + places[class_],
            SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_WIDTH, sums);
    } else {
        memset(sums, 0, sizeof *sums * SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_ROOM);
        skylight_sh_4_bands_0_005pct_packed_sum(row, counts[class_], products + places[class_],
            widths[bands - 1], sums);
    }
}

/* The same in double precision, all bands: what derivatives need, whose terms cancel. */
static inline void skylight_sh_4_bands_0_005pct_packed_sum_rows_double(
    const skylight_sh_4_bands_0_005pct_packed_real *rows, const double *first, const double *others,
    double
        sums[SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_CLASSES]
        [SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_WIDTH])
{
    static const unsigned char
        lengths[SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_CLASSES]
        [SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_OTHERS] = SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_LENGTHS;
    int c, i, k, other;
    for (c = 0; c < SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_CLASSES; ++c) {
        for (k = 0; k < SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_WIDTH; ++k) sums[c][k] = 0.0;
        for (other = 0; other < SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_OTHERS; ++other) {
            for (i = 0; i < (int)lengths[c][other]; ++i) {
                const double product = first[i] * others[other];
                for (k = 0; k < SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_WIDTH; ++k) sums[c][k] +=
                    product * (double)rows[k];
                rows += SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_WIDTH;
            }
        }
    }
}

/* Reads the stream: whole numbers as Rice codes, low bit of each byte first. */
typedef struct {
    const unsigned char *next;
    uint64_t held;
    int count;
} skylight_sh_4_bands_0_005pct_packed_bits;

/* Holds at least 56 bits, at most 63, so that there is a zero above them; past the stream's end
 * there
   are zeros. What stands above `count` bits is the stream's too, and is read again. */
SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_INLINE void
    skylight_sh_4_bands_0_005pct_packed_fill(skylight_sh_4_bands_0_005pct_packed_bits *b)
{
    const unsigned char *const end = skylight_sh_4_bands_0_005pct_packed_stream + sizeof
        skylight_sh_4_bands_0_005pct_packed_stream;
    const unsigned char *const p = b->next;
    if (end - p >= 8) {
        /* One load, whatever the order of a machine's bytes. */
        const uint64_t word = (uint64_t)p[0] | (uint64_t)p[1] << 8 | (uint64_t)p[2] << 16 |
                              (uint64_t)p[3] << 24 | (uint64_t)p[4] << 32 | (uint64_t)p[5] << 40 |
                              (uint64_t)p[6] << 48 | (uint64_t)p[7] << 56;
        b->held = (b->held | word << b->count) & (UINT64_MAX >> 1);
        b->next += (63 - b->count) >> 3;
        b->count |= 56;
    } else {
        for (; b->count < 56; b->count += 8)
            if (b->next < end) b->held |= (uint64_t)*b->next++ << b->count;
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

/* How many ones stand before the first zero, from the low end; what is held has a zero. */
static inline int skylight_sh_4_bands_0_005pct_packed_ones(uint64_t held)
{
#ifdef __GNUC__
    return __builtin_ctzll(~(unsigned long long)held);
#else
    int ones = 0;
    for (; held & 1; held >>= 1) ++ones;
    return ones;
#endif
}

/* The bits after a Rice code that is longer than what is held, and its number, folded. */
static inline skylight_sh_4_bands_0_005pct_packed_bits
    skylight_sh_4_bands_0_005pct_packed_long(skylight_sh_4_bands_0_005pct_packed_bits b, int low,
    unsigned *folded)
{
    unsigned high = 0;
    int ones;
    while ((ones = skylight_sh_4_bands_0_005pct_packed_ones(b.held)) >= b.count) {
        high += (unsigned)b.count;
        b.held = 0;
        b.count = 0;
        skylight_sh_4_bands_0_005pct_packed_fill(&b);
    }
    high += (unsigned)ones;
    b.held = b.held >> ones >> 1;
    b.count -= ones + 1;
    *folded = (high << low) | skylight_sh_4_bands_0_005pct_packed_fixed(&b, low);
    return b;
}

/* A Rice code of `low` low bits: ones, a zero, the low bits; then folded back: 0, 1, 2, 3 -> 0, -1,
   1, -2. */
SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_INLINE int
    skylight_sh_4_bands_0_005pct_packed_rice(skylight_sh_4_bands_0_005pct_packed_bits *b, int low)
{
    unsigned folded;
    int ones, size;
    if (b->count < 32) skylight_sh_4_bands_0_005pct_packed_fill(b);
    ones = skylight_sh_4_bands_0_005pct_packed_ones(b->held);
    size = ones + 1 + low;
    if (size <= b->count) {
        /* All of it is held: what follows waits for one shift. */
        const uint64_t rest = b->held >> ones >> 1;
        folded = ((unsigned)ones << low) | (unsigned)(rest & ((UINT64_C(1) << low) - 1));
        b->held >>= size;
        b->count -= size;
    } else {
        unsigned found;
        *b = skylight_sh_4_bands_0_005pct_packed_long(*b, low, &found);
        folded = found;
    }
    return (int)(folded >> 1) ^ -(int)(folded & 1);
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

/* The length of the next run, by that of the same class and product at the weight before. */
SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_INLINE int
    skylight_sh_4_bands_0_005pct_packed_next_length(skylight_sh_4_bands_0_005pct_packed_bits *b,
    signed char *length)
{
    const int found = *length + skylight_sh_4_bands_0_005pct_packed_rice(b, 0);
    *length = (signed char)found;
    return found;
}

/* The next number, of `size` half low bits. */
SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_INLINE int
    skylight_sh_4_bands_0_005pct_packed_next_number(skylight_sh_4_bands_0_005pct_packed_bits *b,
    int size)
{
    return skylight_sh_4_bands_0_005pct_packed_rice(b, size > 0 ? size >> 1 : 0);
}

static const signed char
    skylight_sh_4_bands_0_005pct_packed_run_profile[SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_RUNS] =
    SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_RUN_PROFILE;
static const signed char
    skylight_sh_4_bands_0_005pct_packed_class_profile[SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_CLASSES] =
    SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_CLASS_PROFILE;

/* Reads the stream once, forward: the sums of the first `bands` bands. */
static inline void skylight_sh_4_bands_0_005pct_packed_sum_stream(
    const skylight_sh_4_bands_0_005pct_packed_real *first,
        const skylight_sh_4_bands_0_005pct_packed_real *others, int bands,
    skylight_sh_4_bands_0_005pct_packed_real
        sums[SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_CLASSES][SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_ROOM])
{
    signed char
        lengths[SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_CLASSES]
        [SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_RUNS];
    int profile[32], i, l, m, c, other, column = 0;
    skylight_sh_4_bands_0_005pct_packed_bits bits = skylight_sh_4_bands_0_005pct_packed_open();
    memset(lengths, 0, sizeof lengths);
    memset(profile, 0, sizeof profile);
    memset(sums, 0, sizeof(skylight_sh_4_bands_0_005pct_packed_real) *
        SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_CLASSES * SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_ROOM);
    for (l = 0; l < bands; ++l) {
        skylight_sh_4_bands_0_005pct_packed_next_profile(&bits, profile);
        for (m = SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_FIRST_ORDER(l); m <= l; ++m, ++column) {
            for (c = 0; c < SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_CLASSES; ++c) {
                skylight_sh_4_bands_0_005pct_packed_real value = 0;
                for (other = 0; other < SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_RUNS; ++other) {
                    const int level = skylight_sh_4_bands_0_005pct_packed_run_profile[other] +
                        skylight_sh_4_bands_0_005pct_packed_class_profile[c];
                    const int length = skylight_sh_4_bands_0_005pct_packed_next_length(&bits,
                        &lengths[c][other]);
                    skylight_sh_4_bands_0_005pct_packed_real sum = 0;
                    for (i = 0; i < length; ++i) {
                        const int number = skylight_sh_4_bands_0_005pct_packed_next_number(&bits,
                            profile[i] + level);
                        sum += first[i] * (skylight_sh_4_bands_0_005pct_packed_real)number;
                    }
                    value += sum * others[other];
                }
                sums[c][column] = value * SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_STEP;
            }
        }
    }
}

/* Reads the stream once, forward, into rows: of each class one for each product of functions. */
static inline void skylight_sh_4_bands_0_005pct_packed_unpack_rows(float *rows)
{
    static const unsigned char
        sizes[SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_CLASSES]
        [SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_OTHERS] = SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_LENGTHS;
    unsigned short
        starts[SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_CLASSES]
        [SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_RUNS];
    signed char
        lengths[SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_CLASSES]
        [SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_RUNS];
    int profile[32], i, l, m, c, other, column = 0, row = 0;
    skylight_sh_4_bands_0_005pct_packed_bits bits = skylight_sh_4_bands_0_005pct_packed_open();
    memset(lengths, 0, sizeof lengths);
    memset(profile, 0, sizeof profile);
    for (c = 0; c < SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_CLASSES; ++c) {
        for (other = 0; other < SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_OTHERS; ++other) {
            if (other < SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_RUNS) starts[c][other] = (unsigned
                short)row;
            row += sizes[c][other];
        }
    }
    for (i = 0; i < SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_UNPACKED; ++i) rows[i] = 0.0f;
    for (l = 0; l < SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_BANDS; ++l) {
        skylight_sh_4_bands_0_005pct_packed_next_profile(&bits, profile);
        for (m = SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_FIRST_ORDER(l); m <= l; ++m, ++column) {
            for (c = 0; c < SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_CLASSES; ++c) {
                for (other = 0; other < SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_RUNS; ++other) {
                    const int level = skylight_sh_4_bands_0_005pct_packed_run_profile[other] +
                        skylight_sh_4_bands_0_005pct_packed_class_profile[c];
                    const int length = skylight_sh_4_bands_0_005pct_packed_next_length(&bits,
                        &lengths[c][other]);
                    float *to = rows + (int)starts[c][other] *
                        SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_WIDTH + column;
                    for (i = 0; i < length; ++i) {
                        const int number = skylight_sh_4_bands_0_005pct_packed_next_number(&bits,
                            profile[i] + level);
                        *to = (float)number * SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_STEP;
                        to += SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_WIDTH;
                    }
                }
            }
        }
    }
}

/* The sums in double precision, all bands: what derivatives need, whose terms cancel. */
static inline void skylight_sh_4_bands_0_005pct_packed_sum_stream_double(
    const double *first, const double *others,
        double
        sums[SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_CLASSES]
        [SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_WIDTH])
{
    signed char
        lengths[SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_CLASSES]
        [SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_RUNS];
    int profile[32], i, l, m, c, other, column = 0;
    skylight_sh_4_bands_0_005pct_packed_bits bits = skylight_sh_4_bands_0_005pct_packed_open();
    memset(lengths, 0, sizeof lengths);
    memset(profile, 0, sizeof profile);
    for (l = 0; l < SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_BANDS; ++l) {
        skylight_sh_4_bands_0_005pct_packed_next_profile(&bits, profile);
        for (m = SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_FIRST_ORDER(l); m <= l; ++m, ++column) {
            for (c = 0; c < SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_CLASSES; ++c) {
                double value = 0.0;
                for (other = 0; other < SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_RUNS; ++other) {
                    const int level = skylight_sh_4_bands_0_005pct_packed_run_profile[other] +
                        skylight_sh_4_bands_0_005pct_packed_class_profile[c];
                    const int length = skylight_sh_4_bands_0_005pct_packed_next_length(&bits,
                        &lengths[c][other]);
                    double sum = 0.0;
                    for (i = 0; i < length; ++i) {
                        const int number = skylight_sh_4_bands_0_005pct_packed_next_number(&bits,
                            profile[i] + level);
                        sum += first[i] * (double)number;
                    }
                    value += sum * others[other];
                }
                sums[c][column] = value * (double)SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_STEP;
            }
        }
    }
}

/* What becomes of the first `bands` bands once they are stored. */
static inline void skylight_sh_4_bands_0_005pct_packed_finish(int bands, int lights,
                                      float
                                          weights[SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_CHANNELS]
                                          [SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_WEIGHTS])
{
    (void)bands;
    (void)lights;
    (void)weights;
}

/* Evaluates the first `bands` bands (1 to SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_BANDS, clamped like
 * an input) and zeroes the
   rest; returns the status. `rows` are the table's; those of a packed table may be missing. */
static inline int skylight_sh_4_bands_0_005pct_packed_evaluate(const
    skylight_sh_4_bands_0_005pct_packed_real *rows,
                                       const float inputs[SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_AXES],
                                           float azimuth,
                                       int bands,
                                       float
                                           weights[SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_CHANNELS]
                                           [SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_WEIGHTS])
{
    skylight_sh_4_bands_0_005pct_packed_real x[SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_AXES],
        first[SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_FIRST],
        others[SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_OTHERS];
    skylight_sh_4_bands_0_005pct_packed_real cosines[SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_BANDS],
        sines[SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_BANDS];
    skylight_sh_4_bands_0_005pct_packed_real
        sums[SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_CLASSES][SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_ROOM];
    skylight_sh_4_bands_0_005pct_packed_real factors[SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_FACTORS];
    skylight_sh_4_bands_0_005pct_packed_real light = SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_EXPOSURE,
        radius = 1, cosine, sine;
    int i, all, status = skylight_sh_4_bands_0_005pct_packed_inputs(inputs, azimuth, x);
    if (status == 2) {
        memset(weights, 0, sizeof(float) * SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_CHANNELS *
            SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_WEIGHTS);
        return 2;
    }
    if (bands < 1 || bands > SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_BANDS) {
        bands = bands < 1 ? 1 : SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_BANDS;
        status = 1;
    }
    skylight_sh_4_bands_0_005pct_packed_circle((skylight_sh_4_bands_0_005pct_packed_real)azimuth,
        &cosine, &sine);
    radius = skylight_sh_4_bands_0_005pct_packed_sine(x);
    skylight_sh_4_bands_0_005pct_packed_waves(cosine, sine, radius, cosines, sines);
    skylight_sh_4_bands_0_005pct_packed_first(x, first);
    skylight_sh_4_bands_0_005pct_packed_others(x, others);
    skylight_sh_4_bands_0_005pct_packed_factors(x, factors);
    for (i = 0; i < SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_FACTORS; ++i) factors[i] *= light;
    all = bands;
    if (!rows) skylight_sh_4_bands_0_005pct_packed_sum_stream(first, others, all, sums);
    if (rows)
    {
#define SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_CLASS(k) \
    skylight_sh_4_bands_0_005pct_packed_sum_class(rows, k, first, others, all, sums[k]);
        SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_ALL_CLASSES(SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_CLASS)
#undef SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_CLASS
    }
    skylight_sh_4_bands_0_005pct_packed_store(sums, factors, cosines, sines, all, weights);
    skylight_sh_4_bands_0_005pct_packed_finish(bands, 1, weights);
    if (bands < SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_BANDS) {
        int channel;
        for (channel = 0; channel < SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_CHANNELS; ++channel)
            for (i = bands * bands; i < SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_WEIGHTS; ++i)
                weights[channel][i] = 0.0f;
    }
    return status;
}

/* One of many suns by itself. */
static inline int skylight_sh_4_bands_0_005pct_packed_evaluate_one(const
    skylight_sh_4_bands_0_005pct_packed_real *rows,
                                           const float *const
                                               inputs[SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_AXES],
                                           const float *azimuths, int sun,
                                           float
                                               weights[SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_CHANNELS]
                                               [SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_WEIGHTS])
{
    float given[SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_AXES];
    int axis;
    for (axis = 0; axis < SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_AXES; ++axis) given[axis] =
        inputs[axis][sun];
    return skylight_sh_4_bands_0_005pct_packed_evaluate(rows, given,
        azimuths ? azimuths[sun] : SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_AZIMUTH,
                                SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_BANDS, weights);
}

/* Numbers of one sun's weights. */
#define SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_NUMBERS (SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_CHANNELS \
    * SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_WEIGHTS)

/* Evaluates `count` suns from arrays, one an axis, and one of azimuths (or none, where the table
   fixes it); returns the largest status. */
static inline int skylight_sh_4_bands_0_005pct_packed_evaluate_batch(
    const skylight_sh_4_bands_0_005pct_packed_real *rows, int count,
        const float *const inputs[SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_AXES],
    const float *azimuths, float
        (*weights)[SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_CHANNELS]
        [SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_WEIGHTS])
{
    int s = 0, status, worst = 0;
    for (; s < count; ++s) {
        status = skylight_sh_4_bands_0_005pct_packed_evaluate_one(rows, inputs, azimuths, s,
            weights[s]);
        worst = status > worst ? status : worst;
    }
    return worst;
}

/* The same with the suns of each weight side by side: `weights` is [channels][weights][count]. */
static inline int skylight_sh_4_bands_0_005pct_packed_evaluate_columns(const
    skylight_sh_4_bands_0_005pct_packed_real *rows, int count,
                                               const float *const
                                                   inputs[SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_AXES],
                                               const float *azimuths, float *weights)
{
    const size_t step = count > 0 ? (size_t)count : 0;
    int s = 0, i, status, worst = 0;
    while (s < count) {
        /* Some at once, so that what is written lies together. */
        float
            some[16][SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_CHANNELS]
            [SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_WEIGHTS];
        const int now = count - s < 16 ? count - s : 16;
        int k;
        for (k = 0; k < now; ++k) {
            status = skylight_sh_4_bands_0_005pct_packed_evaluate_one(rows, inputs, azimuths, s + k,
                some[k]);
            worst = status > worst ? status : worst;
        }
        for (i = 0; i < SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_NUMBERS; ++i)
            for (k = 0; k < now; ++k)
                weights[(size_t)i * step + (size_t)(s + k)] =
                    some[k][i / SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_WEIGHTS][i %
                        SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_WEIGHTS];
        s += now;
    }
    return worst;
}

/* All products of `count` numbers and `size` functions, the functions' place fastest; returns how
   many. */
static inline int skylight_sh_4_bands_0_005pct_packed_multiply_double(double *products, int count,
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
static inline void skylight_sh_4_bands_0_005pct_packed_sum_double(
    const skylight_sh_4_bands_0_005pct_packed_real *rows,
        double
        functions[SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_AXES]
        [SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_MOST],
    double
        sums[SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_CLASSES]
        [SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_WIDTH])
{
    static const int sizes[SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_AXES] =
        SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_SIZES;
    double others[SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_OTHERS];
    int axis, count = 1;
    others[0] = 1.0;
    for (axis = 1; axis < SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_AXES; ++axis)
        count = skylight_sh_4_bands_0_005pct_packed_multiply_double(others, count, functions[axis],
            sizes[axis]);
    skylight_sh_4_bands_0_005pct_packed_sum_stream_double(functions[0], others, sums);
    (void)rows;
    (void)count;
}

/* One channel's sum in double, at a column. */
static inline double skylight_sh_4_bands_0_005pct_packed_mixed_double(double
    sums[SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_CLASSES][SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_WIDTH],
                                              int channel, int column, const double *factors)
{
    double sum = 0.0;
    int k;
    for (k = 0; k < SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_CLASSES; ++k)
        sum += factors[SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_FACTOR(channel, k)] * sums[k][column];
    return sum;
}

/* Evaluates all bands, and their derivatives after each axis by the product rule, in double until
   they are stored: exact inside the ranges, and beyond one those at its edge. */
static inline int skylight_sh_4_bands_0_005pct_packed_evaluate_gradient(
    const skylight_sh_4_bands_0_005pct_packed_real *rows,
        const float inputs[SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_AXES], float azimuth,
    float
        weights[SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_CHANNELS]
        [SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_WEIGHTS],
    float
        gradient[SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_AXES]
        [SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_CHANNELS][SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_WEIGHTS])
{
    static const short columns[SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_BANDS] =
        SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_COLUMNS;
    double x[SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_AXES],
        functions[SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_AXES]
        [SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_MOST];
    double
        slopes[SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_AXES][SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_MOST];
    double factors[1 +
        SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_AXES][SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_FACTORS];
    double
        sums[SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_CLASSES]
        [SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_WIDTH];
    double
        sloped[SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_CLASSES]
        [SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_WIDTH];
    double powers[SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_BANDS],
        power_slopes[SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_BANDS];
    skylight_sh_4_bands_0_005pct_packed_real cosines[SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_BANDS],
        sines[SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_BANDS], of_x, of_y;
    int axis, channel, i, l, m, sunk = 0;
    const int status =
        skylight_sh_4_bands_0_005pct_packed_evaluate(rows, inputs, azimuth,
            SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_BANDS, weights);
    memset(gradient, 0,
           sizeof(float) * SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_AXES *
               SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_CHANNELS *
               SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_WEIGHTS);
    if (status == 2) return 2;
    for (axis = 0; axis < SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_AXES; ++axis) {
        const double low = skylight_sh_4_bands_0_005pct_packed_slope_range[axis][0];
        const double high = skylight_sh_4_bands_0_005pct_packed_slope_range[axis][1];
        const double v = (double)skylight_sh_4_bands_0_005pct_packed_finite(inputs[axis]);
        x[axis] = v < low ? low : v > high ? high : v;
        skylight_sh_4_bands_0_005pct_packed_functions(axis, x[axis], functions[axis], slopes[axis]);
    }
    skylight_sh_4_bands_0_005pct_packed_factor_slopes(x, &factors[0][0]);
    for (axis = 0; axis < 1 + SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_AXES; ++axis)
        for (i = 0; i < SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_FACTORS; ++i)
            factors[axis][i] *= (double)SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_EXPOSURE;
    for (m = 0; m < SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_BANDS; ++m) {
        powers[m] = 1.0;
        power_slopes[m] = 0.0;
    }
    {
        double sine[2];
        skylight_sh_4_bands_0_005pct_packed_sine_slope(x, sine);
        for (m = 1; m < SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_BANDS; ++m) {
            powers[m] = powers[m - 1] * sine[0];
            power_slopes[m] = (double)m * powers[m - 1] * sine[1];
        }
    }
    skylight_sh_4_bands_0_005pct_packed_circle((skylight_sh_4_bands_0_005pct_packed_real)azimuth,
        &of_x, &of_y);
    skylight_sh_4_bands_0_005pct_packed_waves(of_x, of_y, 1, cosines, sines);
    skylight_sh_4_bands_0_005pct_packed_sum_double(rows, functions, sums);
    for (axis = 0; axis < SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_AXES; ++axis) {
        double kept[SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_MOST];
        memcpy(kept, functions[axis], sizeof kept);
        memcpy(functions[axis], slopes[axis], sizeof kept);
        skylight_sh_4_bands_0_005pct_packed_sum_double(rows, functions, sloped);
        memcpy(functions[axis], kept, sizeof kept);
        for (channel = 0; channel < SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_CHANNELS; ++channel) {
            float *const w = gradient[axis][channel];
            for (l = 0; l < SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_BANDS; ++l) {
                for (m = SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_FIRST_ORDER(l); m <= l && columns[l] >=
                    0; ++m) {
                    const int order = m < 0 ? -m : m;
                    const int column = columns[l] + m -
                        SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_FIRST_ORDER(l);
                    double value =
                        powers[order] *
                        (skylight_sh_4_bands_0_005pct_packed_mixed_double(sloped, channel, column,
                            factors[0]) +
                         skylight_sh_4_bands_0_005pct_packed_mixed_double(sums, channel, column,
                             factors[1 + axis]));
                    if (axis == SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_SUN && !sunk)
                        value += power_slopes[order] *
                                 skylight_sh_4_bands_0_005pct_packed_mixed_double(sums, channel,
                                     column, factors[0]);
                    skylight_sh_4_bands_0_005pct_packed_place((
                        skylight_sh_4_bands_0_005pct_packed_real)value, l, m, cosines, sines, w);
                }
            }
        }
        skylight_sh_4_bands_0_005pct_packed_finish(SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_BANDS, 0,
            gradient[axis]);
    }
    (void)power_slopes;
    (void)sunk;
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
    return skylight_sh_4_bands_0_005pct_packed_evaluate(NULL,
        skylight_sh_4_bands_0_005pct_packed_given, sun_azimuth,
        SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_BANDS, weights);
}

SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_API int skylight_sh_4_bands_0_005pct_packed_weights_bands(float
    sun_zenith, float sun_azimuth, float turbidity, int bands,
    float
    weights[SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_CHANNELS]
    [SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_WEIGHTS])
{
    const float skylight_sh_4_bands_0_005pct_packed_given[SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_AXES]
        = { sun_zenith, turbidity };
    return skylight_sh_4_bands_0_005pct_packed_evaluate(NULL,
        skylight_sh_4_bands_0_005pct_packed_given, sun_azimuth, bands, weights);
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
    float skylight_sh_4_bands_0_005pct_packed_memory[SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_UNPACKED];
    if (count > 1)
        skylight_sh_4_bands_0_005pct_packed_unpack_rows(skylight_sh_4_bands_0_005pct_packed_memory);
    return skylight_sh_4_bands_0_005pct_packed_evaluate_batch(count > 1 ?
        skylight_sh_4_bands_0_005pct_packed_memory : NULL, count,
        skylight_sh_4_bands_0_005pct_packed_given, sun_azimuth, weights);
}

SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_API int skylight_sh_4_bands_0_005pct_packed_weights_columns(int
    count, const float *sun_zenith, const float *sun_azimuth, const float *turbidity,
    float *weights)
{
    const float *const
        skylight_sh_4_bands_0_005pct_packed_given[SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_AXES] = {
        sun_zenith, turbidity };
    float skylight_sh_4_bands_0_005pct_packed_memory[SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_UNPACKED];
    if (count > 1)
        skylight_sh_4_bands_0_005pct_packed_unpack_rows(skylight_sh_4_bands_0_005pct_packed_memory);
    return skylight_sh_4_bands_0_005pct_packed_evaluate_columns(count > 1 ?
        skylight_sh_4_bands_0_005pct_packed_memory : NULL, count,
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
    return skylight_sh_4_bands_0_005pct_packed_evaluate_gradient(NULL,
        skylight_sh_4_bands_0_005pct_packed_given, sun_azimuth, weights, gradient);
}

SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_API void skylight_sh_4_bands_0_005pct_packed_unpack(float
    memory[SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_UNPACKED])
{
    skylight_sh_4_bands_0_005pct_packed_unpack_rows(memory);
}

SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_API int
    skylight_sh_4_bands_0_005pct_packed_unpacked_weights(const float
    memory[SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_UNPACKED], float sun_zenith, float sun_azimuth,
    float turbidity, float
    weights[SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_CHANNELS]
    [SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_WEIGHTS])
{
    const float skylight_sh_4_bands_0_005pct_packed_given[SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_AXES]
        = { sun_zenith, turbidity };
    return skylight_sh_4_bands_0_005pct_packed_evaluate(memory,
        skylight_sh_4_bands_0_005pct_packed_given, sun_azimuth,
        SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_BANDS, weights);
}

SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_API int
    skylight_sh_4_bands_0_005pct_packed_unpacked_weights_bands(const float
    memory[SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_UNPACKED], float sun_zenith, float sun_azimuth,
    float turbidity, int bands, float
    weights[SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_CHANNELS]
    [SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_WEIGHTS])
{
    const float skylight_sh_4_bands_0_005pct_packed_given[SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_AXES]
        = { sun_zenith, turbidity };
    return skylight_sh_4_bands_0_005pct_packed_evaluate(memory,
        skylight_sh_4_bands_0_005pct_packed_given, sun_azimuth, bands, weights);
}

SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_API int
    skylight_sh_4_bands_0_005pct_packed_unpacked_weights_batch(const float
    memory[SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_UNPACKED], int count, const float *sun_zenith,
    const float *sun_azimuth, const float *turbidity,
    float
    (*weights)[SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_CHANNELS]
    [SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_WEIGHTS])
{
    const float *const
        skylight_sh_4_bands_0_005pct_packed_given[SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_AXES] = {
        sun_zenith, turbidity };
    return skylight_sh_4_bands_0_005pct_packed_evaluate_batch(memory, count,
        skylight_sh_4_bands_0_005pct_packed_given, sun_azimuth, weights);
}

SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_API int
    skylight_sh_4_bands_0_005pct_packed_unpacked_weights_columns(const float
    memory[SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_UNPACKED], int count, const float *sun_zenith,
    const float *sun_azimuth, const float *turbidity, float *weights)
{
    const float *const
        skylight_sh_4_bands_0_005pct_packed_given[SKYLIGHT_SH_4_BANDS_0_005PCT_PACKED_AXES] = {
        sun_zenith, turbidity };
    return skylight_sh_4_bands_0_005pct_packed_evaluate_columns(memory, count,
        skylight_sh_4_bands_0_005pct_packed_given, sun_azimuth, weights);
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
