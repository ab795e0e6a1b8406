/* Preetham sky (published constants, srgb): spherical-harmonics weights, evaluated from
 * polynomials.
 *
 * Written by skylight-sh 0.1.0; the table and this code may be used by anyone for anything
 * (CC0-1.0).
 * C99 and C++11, no allocation, no global written, nothing static but constants: any thread may
 * call it.
 *
 * Usage
 *   float w[SKYLIGHT_SH_7_BANDS_1_5PCT_CHANNELS][SKYLIGHT_SH_7_BANDS_1_5PCT_WEIGHTS];
 *   int status = skylight_sh_7_bands_1_5pct_weights(0.785000026f, 0.0f, 4.25f, w);
 * Compile with, for instance
 *   cc -std=c99 -O3 program.c -o program -lm
 * Included plainly, the file is all there is: its functions are static, and the table stands in
 * every unit that includes it. With SKYLIGHT_SH_7_BANDS_1_5PCT_EXTERN defined before it, it
 * declares only; the one unit that also defines SKYLIGHT_SH_7_BANDS_1_5PCT_IMPLEMENTATION holds
 * functions and table, for C and C++.
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
 *   Define SKYLIGHT_SH_7_BANDS_1_5PCT_EXPOSURE before this file (where it holds the table) to
 *   multiply all weights (1 by default).
 *
 * Accuracy, as shipped: E_mean 1.42 %, E_max 5.85 % of the least luminance of the same sky, at
 * azimuth 0.
 * The expansion rings: the least value it takes, over all directions and measured sets, is -12.8 %
 * of its largest in the same set; the window below tames it.
 * Memory: 4295 bytes of constants, laid out for speed.
 *
 * Provenance
 *   skylight-sh 0.1.0, config preetham 08540d17388f71b0, table 7-bands-1.5pct
 */
#ifdef __cplusplus
#if __cplusplus < 201103L && !defined(_MSC_VER)
#error "skylight_sh needs C++11 or later: compile with -std=c++11."
#endif
#elif (!defined(__STDC_VERSION__) || __STDC_VERSION__ < 199901L) && !defined(_MSC_VER)
#error "skylight_sh needs C99 or later: compile with -std=c99."
#endif
#if defined(SKYLIGHT_SH_7_BANDS_1_5PCT_IMPLEMENTATION) && \
    !defined(SKYLIGHT_SH_7_BANDS_1_5PCT_EXTERN)
#error "Define SKYLIGHT_SH_7_BANDS_1_5PCT_EXTERN in every unit, \
SKYLIGHT_SH_7_BANDS_1_5PCT_IMPLEMENTATION beside it in one."
#endif
#if defined(SKYLIGHT_SH_7_BANDS_1_5PCT_API) && defined(SKYLIGHT_SH_7_BANDS_1_5PCT_EXTERN) && \
    !defined(SKYLIGHT_SH_7_BANDS_1_5PCT_DECLARED)
#error "Define SKYLIGHT_SH_7_BANDS_1_5PCT_EXTERN before this file is included for the first time."
#endif
#if defined(SKYLIGHT_SH_7_BANDS_1_5PCT_DECLARED) && !defined(SKYLIGHT_SH_7_BANDS_1_5PCT_EXTERN)
#error "Leave SKYLIGHT_SH_7_BANDS_1_5PCT_EXTERN defined: this file was included with it before."
#endif

#ifndef SKYLIGHT_SH_7_BANDS_1_5PCT_H
#define SKYLIGHT_SH_7_BANDS_1_5PCT_H 0x9795aac4

#include <math.h>
#include <stdint.h>
#include <string.h>

#ifndef SKYLIGHT_SH_7_BANDS_1_5PCT_EXTERN
#define SKYLIGHT_SH_7_BANDS_1_5PCT_API static inline
#else
#define SKYLIGHT_SH_7_BANDS_1_5PCT_DECLARED
#ifdef __cplusplus
#define SKYLIGHT_SH_7_BANDS_1_5PCT_API extern "C"
#else
#define SKYLIGHT_SH_7_BANDS_1_5PCT_API extern
#endif
#endif
#ifndef SKYLIGHT_SH_7_BANDS_1_5PCT_EXPOSURE
#define SKYLIGHT_SH_7_BANDS_1_5PCT_EXPOSURE 1
#endif

#define SKYLIGHT_SH_7_BANDS_1_5PCT_VERSION "0.1.0"
#define SKYLIGHT_SH_7_BANDS_1_5PCT_BANDS 7
#define SKYLIGHT_SH_7_BANDS_1_5PCT_WEIGHTS 49
#define SKYLIGHT_SH_7_BANDS_1_5PCT_CHANNELS 3
#define SKYLIGHT_SH_7_BANDS_1_5PCT_AXES 2
#define SKYLIGHT_SH_7_BANDS_1_5PCT_UNIT "cd/m2"
#define SKYLIGHT_SH_7_BANDS_1_5PCT_E_MEAN 1.417000e-02
#define SKYLIGHT_SH_7_BANDS_1_5PCT_E_MAX 5.854000e-02
#define SKYLIGHT_SH_7_BANDS_1_5PCT_SUN_ZENITH_MIN 0.0f
#define SKYLIGHT_SH_7_BANDS_1_5PCT_SUN_ZENITH_MAX 1.57079637f
#define SKYLIGHT_SH_7_BANDS_1_5PCT_TURBIDITY_MIN 2.5f
#define SKYLIGHT_SH_7_BANDS_1_5PCT_TURBIDITY_MAX 6.0f

/* Evaluates all bands. */
SKYLIGHT_SH_7_BANDS_1_5PCT_API int skylight_sh_7_bands_1_5pct_weights(float sun_zenith,
    float sun_azimuth, float turbidity,
    float weights[SKYLIGHT_SH_7_BANDS_1_5PCT_CHANNELS][SKYLIGHT_SH_7_BANDS_1_5PCT_WEIGHTS]);
/* Evaluates the first `bands` bands (1 to SKYLIGHT_SH_7_BANDS_1_5PCT_BANDS, clamped
   likewise) and zeroes the rest. */
SKYLIGHT_SH_7_BANDS_1_5PCT_API int skylight_sh_7_bands_1_5pct_weights_bands(float sun_zenith,
    float sun_azimuth, float turbidity, int bands,
    float weights[SKYLIGHT_SH_7_BANDS_1_5PCT_CHANNELS][SKYLIGHT_SH_7_BANDS_1_5PCT_WEIGHTS]);
/* Evaluates `count` suns from arrays; returns the largest status. */
SKYLIGHT_SH_7_BANDS_1_5PCT_API int skylight_sh_7_bands_1_5pct_weights_batch(int count,
    const float *sun_zenith, const float *sun_azimuth, const float *turbidity,
    float (*weights)[SKYLIGHT_SH_7_BANDS_1_5PCT_CHANNELS][SKYLIGHT_SH_7_BANDS_1_5PCT_WEIGHTS]);
/* The same with the suns of each weight side by side:
   [SKYLIGHT_SH_7_BANDS_1_5PCT_CHANNELS][SKYLIGHT_SH_7_BANDS_1_5PCT_WEIGHTS][count]. */
SKYLIGHT_SH_7_BANDS_1_5PCT_API int skylight_sh_7_bands_1_5pct_weights_columns(int count,
    const float *sun_zenith, const float *sun_azimuth, const float *turbidity, float *weights);
/* Evaluates all bands and their derivatives after each axis (sun_zenith,
   turbidity), per unit of the axis; beyond a range, those at its edge. */
SKYLIGHT_SH_7_BANDS_1_5PCT_API int skylight_sh_7_bands_1_5pct_weights_gradient(float sun_zenith,
    float sun_azimuth, float turbidity,
    float weights[SKYLIGHT_SH_7_BANDS_1_5PCT_CHANNELS][SKYLIGHT_SH_7_BANDS_1_5PCT_WEIGHTS],
    float
    gradient[SKYLIGHT_SH_7_BANDS_1_5PCT_AXES][SKYLIGHT_SH_7_BANDS_1_5PCT_CHANNELS]
    [SKYLIGHT_SH_7_BANDS_1_5PCT_WEIGHTS]);
/* Unit vector of the dominant light. Returns 0, or 1 (and straight up) where there is none. */
#define skylight_sh_7_bands_1_5pct_dominant(weights, direction) \
    skylight_sh_7_bands_1_5pct_dominant_of(&(weights)[0][0], direction)
SKYLIGHT_SH_7_BANDS_1_5PCT_API int skylight_sh_7_bands_1_5pct_dominant_of(const float *weights,
    float direction[3]);
/* Optional: adds an even ground of this albedo below the horizon, lit by the sky (before any
 * window). */
SKYLIGHT_SH_7_BANDS_1_5PCT_API void skylight_sh_7_bands_1_5pct_ground(const float
    albedo[SKYLIGHT_SH_7_BANDS_1_5PCT_CHANNELS],
    float weights[SKYLIGHT_SH_7_BANDS_1_5PCT_CHANNELS][SKYLIGHT_SH_7_BANDS_1_5PCT_WEIGHTS]);
/* Optional: tames the ringing of the horizon by the zonal window of the first `bands` bands. */
SKYLIGHT_SH_7_BANDS_1_5PCT_API void skylight_sh_7_bands_1_5pct_window(int bands,
    float weights[SKYLIGHT_SH_7_BANDS_1_5PCT_CHANNELS][SKYLIGHT_SH_7_BANDS_1_5PCT_WEIGHTS]);

#elif SKYLIGHT_SH_7_BANDS_1_5PCT_H != 0x9795aac4
#error "Another table has the prefix skylight_sh_7_bands_1_5pct_7_bands_1_5pct already: export one \
of them under a prefix of its own."
#endif /* SKYLIGHT_SH_7_BANDS_1_5PCT_H */

#if (!defined(SKYLIGHT_SH_7_BANDS_1_5PCT_EXTERN) || \
    defined(SKYLIGHT_SH_7_BANDS_1_5PCT_IMPLEMENTATION)) && \
    !defined(SKYLIGHT_SH_7_BANDS_1_5PCT_DEFINED)
#define SKYLIGHT_SH_7_BANDS_1_5PCT_DEFINED

/* Numbers side by side where the compiler has vector types: as many as the processor's registers
   hold, and four. */
#if defined(__GNUC__) && (defined(__SSE__) || defined(__ARM_NEON) || defined(__ALTIVEC__) || \
                          defined(__wasm_simd128__) || defined(__loongarch_sx))
#if defined(__AVX512F__)
#define SKYLIGHT_SH_7_BANDS_1_5PCT_LANES 16
#elif defined(__AVX__)
#define SKYLIGHT_SH_7_BANDS_1_5PCT_LANES 8
#else
#define SKYLIGHT_SH_7_BANDS_1_5PCT_LANES 4
#endif
#endif
/* What is worth its place in every caller; what lies at the start of a cache line. */
#ifdef __GNUC__
#define SKYLIGHT_SH_7_BANDS_1_5PCT_INLINE static inline __attribute__((always_inline))
#define SKYLIGHT_SH_7_BANDS_1_5PCT_ALIGNED __attribute__((aligned(64)))
#else
#define SKYLIGHT_SH_7_BANDS_1_5PCT_INLINE static inline
#define SKYLIGHT_SH_7_BANDS_1_5PCT_ALIGNED
#endif
#ifdef SKYLIGHT_SH_7_BANDS_1_5PCT_LANES
#ifdef __FMA__
/* One operation for a product and a sum, which standard C may not choose by itself. */
#include <immintrin.h>
#endif
typedef float skylight_sh_7_bands_1_5pct_lanes __attribute__((vector_size(4 *
    SKYLIGHT_SH_7_BANDS_1_5PCT_LANES)));
typedef float skylight_sh_7_bands_1_5pct_four __attribute__((vector_size(16)));
typedef int skylight_sh_7_bands_1_5pct_order __attribute__((vector_size(16)));

/* The same number in all places: v - 0 is v, which 0 + v need not be. */
static inline skylight_sh_7_bands_1_5pct_lanes skylight_sh_7_bands_1_5pct_spread(float v)
{
    const skylight_sh_7_bands_1_5pct_lanes zeros = {0};
    return v - zeros;
}

static inline skylight_sh_7_bands_1_5pct_lanes skylight_sh_7_bands_1_5pct_load(const float *from)
{
    skylight_sh_7_bands_1_5pct_lanes v;
    memcpy(&v, from, sizeof v);
    return v;
}

/* a * b + c. */
static inline skylight_sh_7_bands_1_5pct_lanes
    skylight_sh_7_bands_1_5pct_add(skylight_sh_7_bands_1_5pct_lanes a,
    skylight_sh_7_bands_1_5pct_lanes b,
                                                skylight_sh_7_bands_1_5pct_lanes c)
{
#if defined(__FMA__) && SKYLIGHT_SH_7_BANDS_1_5PCT_LANES == 16
    return _mm512_fmadd_ps(a, b, c);
#elif defined(__FMA__) && SKYLIGHT_SH_7_BANDS_1_5PCT_LANES == 8
    return _mm256_fmadd_ps(a, b, c);
#else
    return a * b + c;
#endif
}

static inline skylight_sh_7_bands_1_5pct_four skylight_sh_7_bands_1_5pct_spread_four(float v)
{
    const skylight_sh_7_bands_1_5pct_four zeros = {0};
    return v - zeros;
}

static inline skylight_sh_7_bands_1_5pct_four skylight_sh_7_bands_1_5pct_load_four(const float
    *from)
{
    skylight_sh_7_bands_1_5pct_four v;
    memcpy(&v, from, sizeof v);
    return v;
}

static inline skylight_sh_7_bands_1_5pct_four
    skylight_sh_7_bands_1_5pct_add_four(skylight_sh_7_bands_1_5pct_four a,
    skylight_sh_7_bands_1_5pct_four b,
                                                    skylight_sh_7_bands_1_5pct_four c)
{
#ifdef __FMA__
    return _mm_fmadd_ps(a, b, c);
#else
    return a * b + c;
#endif
}

/* Numbers side by side; where there are fewer than four, the last again. */
static inline skylight_sh_7_bands_1_5pct_four skylight_sh_7_bands_1_5pct_quadruple(float a, float b,
    float c, float d)
{
    const skylight_sh_7_bands_1_5pct_four v = {a, b, c, d};
    return v;
}

static inline skylight_sh_7_bands_1_5pct_four skylight_sh_7_bands_1_5pct_triple(float a, float b,
    float c)
{
    return skylight_sh_7_bands_1_5pct_quadruple(a, b, c, c);
}

static inline skylight_sh_7_bands_1_5pct_four skylight_sh_7_bands_1_5pct_pair(float a, float b)
{
    return skylight_sh_7_bands_1_5pct_quadruple(a, b, b, b);
}

static inline void skylight_sh_7_bands_1_5pct_keep(float *to, skylight_sh_7_bands_1_5pct_four v)
{
    memcpy(to, &v, sizeof v);
}

/* Four of the eight numbers of two vectors. */
#ifdef __clang__
#define SKYLIGHT_SH_7_BANDS_1_5PCT_PICK(v, w, a, b, c, d) __builtin_shufflevector(v, w, a, b, c, d)
#else
#define SKYLIGHT_SH_7_BANDS_1_5PCT_PICK(v, w, a, b, c, d) skylight_sh_7_bands_1_5pct_pick(v, w, a, \
    b, c, d)
static inline skylight_sh_7_bands_1_5pct_four
    skylight_sh_7_bands_1_5pct_pick(skylight_sh_7_bands_1_5pct_four v,
    skylight_sh_7_bands_1_5pct_four w, int a,
                                                int b, int c, int d)
{
    const skylight_sh_7_bands_1_5pct_order order = {a, b, c, d};
    return __builtin_shuffle(v, w, order);
}
#endif
#endif

typedef float skylight_sh_7_bands_1_5pct_real;

/* Functions of the first axis, in fours; products of the other axes'
   functions. */
#define SKYLIGHT_SH_7_BANDS_1_5PCT_FIRST 8
#define SKYLIGHT_SH_7_BANDS_1_5PCT_OTHERS 4
#define SKYLIGHT_SH_7_BANDS_1_5PCT_SIZES { 6, 4 }
#define SKYLIGHT_SH_7_BANDS_1_5PCT_MOST 8
#define SKYLIGHT_SH_7_BANDS_1_5PCT_AZIMUTH 0.0f
/* The axis of the sun's zenith angle. */
#define SKYLIGHT_SH_7_BANDS_1_5PCT_SUN 0
/* The channels' luminance. */
#define SKYLIGHT_SH_7_BANDS_1_5PCT_LUMINANCE { 0.212672845f, 0.715152144f, 0.0721749961f }
/* What an even ground reflects of the weight l = 1, m = 0, and its own
   zonal weights. */
#define SKYLIGHT_SH_7_BANDS_1_5PCT_REFLECTED 0.651470006f
#define SKYLIGHT_SH_7_BANDS_1_5PCT_LOWER { 1.7724539f, -1.53499007f, 0.0f, 0.586184025f, 0.0f, \
    -0.367410272f, 0.0f }

/* Of each axis: the first and last float that counts as inside, and its
   range. */
static const float skylight_sh_7_bands_1_5pct_inside[SKYLIGHT_SH_7_BANDS_1_5PCT_AXES][2] = { {
    -1.57079626e-06f, 1.5707978f }, { 2.49999666f, 6.00000334f } };
static const skylight_sh_7_bands_1_5pct_real
    skylight_sh_7_bands_1_5pct_range[SKYLIGHT_SH_7_BANDS_1_5PCT_AXES][2] = { { 0.0f, 1.57079637f },
    { 2.5f, 6.0f } };

/* Classes; a row's numbers, one a sum, and those of the first 1, 2, ..
   bands; room for a class's sums. */
#define SKYLIGHT_SH_7_BANDS_1_5PCT_CLASSES 3
#define SKYLIGHT_SH_7_BANDS_1_5PCT_ALL_CLASSES(CLASS) CLASS(0) CLASS(1) CLASS(2)
/* What multiplies the sum of a class for a channel; the channels side by
   side, in fours. */
#define SKYLIGHT_SH_7_BANDS_1_5PCT_FACTORS 12
#define SKYLIGHT_SH_7_BANDS_1_5PCT_FACTOR(channel, class_) ((class_) * 4 + (channel))
#define SKYLIGHT_SH_7_BANDS_1_5PCT_WIDTH 28
#define SKYLIGHT_SH_7_BANDS_1_5PCT_WIDTHS { 1, 3, 6, 10, 15, 21, 28 }
#define SKYLIGHT_SH_7_BANDS_1_5PCT_ROOM 32
/* All rows; of each class the first row, how many, and the place of its
   first product. */
#define SKYLIGHT_SH_7_BANDS_1_5PCT_TERMS 35
#define SKYLIGHT_SH_7_BANDS_1_5PCT_STARTS { 0, 16, 25 }
#define SKYLIGHT_SH_7_BANDS_1_5PCT_COUNTS { 16, 9, 10 }
#define SKYLIGHT_SH_7_BANDS_1_5PCT_PLACES { 0, 16, 28 }
#define SKYLIGHT_SH_7_BANDS_1_5PCT_PRODUCTS_ROOM 44
/* Of each class and product of the other axes' functions: how many
   functions of the first axis it has. */
#define SKYLIGHT_SH_7_BANDS_1_5PCT_LENGTHS { { 6, 5, 4, 1 }, { 3, 4, 2, 0 }, { 5, 3, 1, 1 } }
/* The same: of each that has any, class, place of the first product, how
   many, the other axes' product. */
#define SKYLIGHT_SH_7_BANDS_1_5PCT_PRODUCTS(PRODUCT) \
    PRODUCT(0, 0, 6, 0) \
    PRODUCT(0, 6, 5, 1) \
    PRODUCT(0, 11, 4, 2) \
    PRODUCT(0, 15, 1, 3) \
    PRODUCT(1, 16, 3, 0) \
    PRODUCT(1, 19, 4, 1) \
    PRODUCT(1, 23, 2, 2) \
    PRODUCT(2, 28, 5, 0) \
    PRODUCT(2, 33, 3, 1) \
    PRODUCT(2, 36, 1, 2) \
    PRODUCT(2, 37, 1, 3)
/* The same: of each class the first row of each polynomial, its rows, the
   other axes' product. */
#define SKYLIGHT_SH_7_BANDS_1_5PCT_POLYNOMIALS(CLASS, NOTHING, POLYNOMIAL) \
    CLASS(0, NOTHING POLYNOMIAL(0, 6, 0) POLYNOMIAL(6, 5, 1) POLYNOMIAL(11, 4, 2) POLYNOMIAL(15, \
        1, 3)) \
    CLASS(1, NOTHING POLYNOMIAL(16, 3, 0) POLYNOMIAL(19, 4, 1) POLYNOMIAL(23, 2, 2)) \
    CLASS(2, NOTHING POLYNOMIAL(25, 5, 0) POLYNOMIAL(30, 3, 1) POLYNOMIAL(33, 1, 2) POLYNOMIAL(34, \
        1, 3))
/* Of each class the longest polynomial's rows, and how many those of the
   classes before have. */
#define SKYLIGHT_SH_7_BANDS_1_5PCT_LONGEST { 6, 4, 5 }
#define SKYLIGHT_SH_7_BANDS_1_5PCT_BEFORE { 0, 6, 10 }
#define SKYLIGHT_SH_7_BANDS_1_5PCT_SHARED 15
/* Where sums go: of each degree, the first column, or -1 where it carries
   nothing. */
#define SKYLIGHT_SH_7_BANDS_1_5PCT_COLUMNS { 0, 1, 3, 6, 10, 15, 21 }
/* The same for vectors of four: places, two vectors of sums and the numbers
   of both, order. */
#define SKYLIGHT_SH_7_BANDS_1_5PCT_FOURS 7
#define SKYLIGHT_SH_7_BANDS_1_5PCT_STORES(BAND, NOTHING, MINUS, PLUS) \
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

/* Of each class, a row a term (functions of the other axes, then of the
   first): its number for every sum. */
SKYLIGHT_SH_7_BANDS_1_5PCT_ALIGNED
static const skylight_sh_7_bands_1_5pct_real skylight_sh_7_bands_1_5pct_rows[984] = {
    2.71098971f, 2.21466804f, 1.31146753f, -0.313032746f, 1.19300616f, 0.829793096f, -1.20815349f,
    0.110356927f, 0.798030257f, 0.464666963f, -0.108621955f, -0.509916902f, 0.158271194f,
    0.491477728f, 0.28851831f, 0.643706918f, -0.209847808f, -0.274748206f, 0.16825366f,
    0.332843304f, 0.188798666f, 0.0972919464f, 0.187082529f, -0.159585834f, -0.111799717f,
    0.155728936f, 0.237040997f, 0.12929523f, -0.215881109f, -0.540693641f, -0.263712525f,
    -0.666102886f, -0.702026129f, -0.12532866f, -0.245262742f, -0.876780868f, -0.484076142f,
    -0.0632287264f, 0.345878124f, -0.411806583f, -0.71454668f, -0.347851515f, -0.0304287672f,
    0.437494159f, 0.290731192f, -0.443466425f, -0.581750631f, -0.254352808f, -0.0133959055f,
    0.0395425558f, 0.49849844f, 0.114664435f, -0.437773943f, -0.475585341f, -0.190463543f,
    -0.00500154495f, -0.13366127f, 0.0432426929f, -0.150174379f, 0.4235816f, 0.0345387459f,
    -0.110798836f, 0.552830935f, 0.484195948f, 0.0120873451f, -0.0768156052f, 0.238363743f,
    0.762534857f, 0.382457733f, -0.00119066238f, -0.0518467426f, -0.232405186f, 0.509887457f,
    0.706820011f, 0.29867959f, -0.00870370865f, -0.0341322422f, -0.434898376f, -0.109360933f,
    0.606292963f, 0.64046216f, 0.233785391f, -0.0120222569f, -0.0221889019f, -0.0137734413f,
    0.0301098824f, -0.0272426605f, 0.0124750137f, 0.0451116562f, -0.030456543f, -0.200723648f,
    0.0270943642f, 0.0380144119f, -0.0295891762f, -0.436326504f, -0.27630043f, 0.0316705704f,
    0.0300474167f, -0.0261387825f, -0.363581181f, -0.661642075f, -0.248060226f, 0.0332145691f,
    0.0231165886f, -0.0210943222f, 0.049580574f, -0.65373373f, -0.660630703f, -0.217212677f,
    0.032186985f, 0.017578125f, -0.0155892372f, 0.0082950592f, 0.00424003601f, 0.00519943237f,
    -0.0152130127f, 0.00964164734f, -7.72476196e-05f, -0.00478076935f, -0.0121612549f,
    0.0130434036f, -0.00603580475f, 0.106129646f, -0.0111408234f, -0.00459003448f, 0.0141363144f,
    -0.0113067627f, 0.291320801f, 0.140997887f, -0.0159101486f, 0.0028181076f, 0.0138053894f,
    -0.015627861f, 0.392437935f, 0.450790405f, 0.131988525f, -0.0188045502f, 0.0102348328f,
    0.0120210648f, -0.0189304352f, 0.00517845154f, -0.00110816956f, 0.00649642944f, -0.00890731812f,
    -0.0034160614f, 0.00556755066f, 0.00181770325f, -0.0132026672f, -0.00393867493f, 0.00592422485f,
    0.0121212006f, 0.00696563721f, -0.0134963989f, -0.00307273865f, 0.00626564026f, -0.0428733826f,
    0.0284633636f, 0.00690460205f, -0.0142669678f, -0.00201797485f, 0.00642585754f, -0.192518234f,
    -0.0565032959f, 0.0275707245f, 0.00566291809f, -0.0156135559f, -0.000457763672f, 0.00636482239f,
    0.592511058f, 0.679308295f, 0.25313127f, 0.3031528f, 0.294839263f, 0.0672557354f,
    -0.0670778751f, 0.143300056f, 0.116174698f, 0.0437504053f, -0.157585144f, -0.0181055069f,
    0.105683208f, 0.0694816113f, 0.0201789141f, -0.0450314283f, -0.0619169474f, 0.0348471403f,
    0.0602591038f, 0.0376796722f, 0.0109322071f, 0.0537576675f, -0.0260683298f, -0.033059597f,
    0.0227696896f, 0.0393618345f, 0.0231574774f, 0.0068666935f, -0.176290989f, -0.223384261f,
    -0.120780826f, -0.14539361f, -0.19446981f, -0.0887461901f, -0.0414719582f, -0.187174559f,
    -0.142977953f, -0.0561175346f, 0.029741168f, -0.105363488f, -0.141109347f, -0.0953916311f,
    -0.0387797356f, 0.0610477924f, 0.000656366348f, -0.089053154f, -0.103435278f, -0.0684144497f,
    -0.0285515785f, 0.0592731237f, 0.0718107224f, -0.0162688494f, -0.0769246817f, -0.0794582367f,
    -0.0519288778f, -0.0223383904f, 0.0139670372f, 0.0555036068f, 0.019220829f, 0.108425617f,
    0.0783307552f, 0.0166642666f, 0.116161823f, 0.147537708f, 0.0632276535f, 0.0134527683f,
    0.0537362099f, 0.162775993f, 0.119318008f, 0.0505926609f, 0.0106127262f, -0.0400974751f,
    0.101030111f, 0.140990257f, 0.097681284f, 0.0409853458f, 0.00862240791f, -0.10225153f,
    0.00657224655f, 0.107297421f, 0.122926235f, 0.0815911293f, 0.0338687897f, 0.0070104599f,
    0.00920200348f, -0.00374126434f, 0.0136089325f, -0.0419764519f, -0.00318241119f, 0.0104355812f,
    -0.0845856667f, -0.0546503067f, -0.00213956833f, 0.00801992416f, -0.107104301f, -0.118083477f,
    -0.0455331802f, -0.000980377197f, 0.00590133667f, -0.099006176f, -0.161109447f, -0.108059406f,
    -0.0370965004f, -0.000294685364f, 0.00482797623f, -0.0694508553f, -0.163925171f, -0.163048744f,
    -0.0968322754f, -0.0304245949f, 0.000655651093f, 0.00449323654f, 7.34329224e-05f,
    -0.00368976593f, -0.00378513336f, -0.00226783752f, -0.00789546967f, -0.00306129456f,
    0.0197153091f, 0.000923156738f, -0.00742340088f, -0.00191783905f, 0.0609617233f, 0.0349626541f,
    0.000946998596f, -0.00677967072f, -0.000853538513f, 0.099697113f, 0.0844945908f, 0.0347795486f,
    -0.000417709351f, -0.00606822968f, -0.000393867493f, 0.113799095f, 0.120688438f, 0.0847158432f,
    0.0314884186f, -0.00152873993f, -0.00567436218f, -0.000500679016f, -0.12560463f, -0.118259668f,
    -0.0698988438f, 0.00220274925f, -0.084975481f, -0.0768651962f, 0.0902662277f, -0.0359315872f,
    -0.0875127316f, -0.0407679081f, 0.0673892498f, 0.0283427238f, -0.0346131325f, -0.0517838001f,
    -0.0278031826f, -0.0115811825f, 0.0460729599f, 0.0225734711f, -0.028195858f, -0.0373625755f,
    -0.0191347599f, -0.0438349247f, 0.0126814842f, 0.0328726768f, 0.00598526001f, -0.0236904621f,
    -0.027276516f, -0.0135929585f, 0.0177342892f, 0.0366373062f, 0.0579631329f, 0.0422980785f,
    0.0925912857f, 0.0311226845f, 0.0172576904f, 0.0822279453f, 0.0612113476f, 0.0225994587f,
    -0.0242359638f, 0.0315489769f, 0.0688662529f, 0.0488889217f, 0.015630722f, -0.0447525978f,
    -0.0209872723f, 0.0418076515f, 0.0613479614f, 0.0376465321f, 0.0109009743f, -0.0302398205f,
    -0.0378286839f, 0.000430345535f, 0.045879364f, 0.0527243614f, 0.0290811062f, 0.00754618645f,
    0.00929641724f, -0.00533485413f, 0.0145745277f, -0.037463665f, -0.0016207695f, 0.012799263f,
    -0.0542368889f, -0.0447330475f, -0.00117635727f, 0.0107707977f, -0.0393586159f, -0.078851223f,
    -0.0421380997f, -0.000551223755f, 0.00902748108f, -0.00934314728f, -0.0709414482f,
    -0.0814318657f, -0.0378789902f, 0.000327110291f, 0.00780439377f, 0.00739431381f, -0.0278224945f,
    -0.0843772888f, -0.0801076889f, -0.0328292847f, 0.00119161606f, 0.00697517395f, -0.00765037537f,
    -0.0082988739f, -0.0111856461f, 0.00266265869f, -0.013874054f, -0.00941944122f, 0.0232362747f,
    0.00282669067f, -0.0119514465f, -0.00790691376f, 0.0421695709f, 0.0355920792f, 0.00421047211f,
    -0.0104598999f, -0.00660991669f, 0.0452318192f, 0.0588750839f, 0.037147522f, 0.00432395935f,
    -0.00926589966f, -0.00550079346f, 0.0307245255f, 0.0495672226f, 0.0616092682f, 0.0368041992f,
    0.00370407104f, -0.00818157196f, -0.00480365753f, 0.0295939445f, 0.0113501549f, 0.0168156624f,
    -0.031414032f, 0.00899600983f, 0.00612354279f, -0.0350761414f, -0.0114479065f, 0.00391387939f,
    0.0040602684f, 0.00209140778f, -0.0164890289f, -0.00404691696f, 0.00326824188f, 0.00229167938f,
    0.0262308121f, -0.00147151947f, -0.0081319809f, -0.00114870071f, 0.0021982193f, 0.001516819f,
    0.0104651451f, 0.0108084679f, -0.00320959091f, -0.00402164459f, -3.38554382e-05f,
    0.00159597397f, 0.00097990036f, 0.00585234165f, -0.00371134281f, 0.0439990759f, -0.0111581087f,
    0.0337982178f, 0.024789691f, 0.00326323509f, -0.00282990932f, 0.0171635151f, 0.0072696209f,
    0.0155775547f, -0.0115425587f, -0.00371110439f, 0.00374734402f, 0.00158107281f, 0.000752568245f,
    0.00660908222f, -0.0067025423f, -0.0027012825f, -0.000829100609f, -0.000860095024f,
    -0.017599225f, 0.00992262363f, 0.00553679466f, -0.00193846226f, -0.00302112103f,
    -0.00273442268f, -0.00164914131f, -0.00335133076f, -0.0157488585f, -0.00665330887f,
    -0.0247396231f, -0.0172561407f, -0.000229597092f, -0.013672471f, -0.0202898979f,
    -0.00555849075f, 0.00110757351f, 0.0042181015f, -0.00891697407f, -0.00847744942f,
    -0.00060236454f, 0.00159084797f, 0.00589442253f, 0.00340116024f, -0.00346684456f,
    -0.00136697292f, 0.00213778019f, 0.00161266327f, -0.00409173965f, 0.00196778774f,
    0.00255930424f, 0.00105261803f, 0.00286734104f, 0.00330615044f, 0.00138664246f, -0.00175595284f,
    0.00468587875f, -0.00118160248f, 0.0136554241f, 0.00374412537f, -0.000296592712f, 0.0128262043f,
    0.00895524025f, 0.0022649765f, 0.000413417816f, 0.00405812263f, 0.00690746307f, 0.00390911102f,
    0.00109577179f, 0.000572919846f, -0.00094461441f, 0.000867128372f, 0.00142908096f,
    0.000326871872f, 0.000194787979f, 0.000776529312f, 0.000996112823f, -0.000380039215f,
    -0.00180840492f, -0.0020236969f, -0.00167870522f, -0.000235080719f, 0.000712394714f,
    -0.00472998619f, -0.016156435f, 0.0257812738f, -0.0219156742f, 0.0220319033f, 0.0255557299f,
    -0.00750541687f, 0.000555276871f, 0.0217400789f, 0.0124371052f, 0.0115351677f, -0.00869512558f,
    0.000367164612f, 0.0113092661f, 0.00768578053f, 0.0100752115f, -0.000110268593f, -0.0098772049f,
    0.00122475624f, 0.00745463371f, 0.00482571125f, -0.00645148754f, 0.0058119297f, -0.00188469887f,
    -0.00500917435f, 0.00139474869f, 0.00501692295f, 0.00309860706f, 0.00106871128f,
    -0.00937604904f, -0.00677585602f, -0.0206010342f, -0.0185132027f, -7.68899918e-05f,
    -0.0135421753f, -0.0227719545f, -0.00848460197f, 0.00143134594f, 0.00435066223f,
    -0.00972080231f, -0.0146195889f, -0.00477409363f, 0.00239956379f, 0.0101413727f, 0.00798547268f,
    -0.00756525993f, -0.0104652643f, -0.0021944046f, 0.00294041634f, 0.000284671783f, 0.0101188421f,
    0.00558364391f, -0.00641703606f, -0.00770521164f, -0.00050842762f, 0.00324392319f,
    -0.00271058083f, 0.00173449516f, -0.00540065765f, 0.0100390911f, -0.00243830681f,
    -0.00562953949f, 0.0120749474f, 0.00659608841f, -0.00421285629f, -0.00547122955f,
    0.00621938705f, 0.0125126839f, 0.00401139259f, -0.00518727303f, -0.00529694557f,
    0.000116825104f, 0.0101494789f, 0.0121982098f, 0.00239276886f, -0.00575780869f, -0.00510787964f,
    -0.000739336014f, 0.00338387489f, 0.0134601593f, 0.0123934746f, 0.00152683258f, -0.00600194931f,
    -0.00489139557f, 0.000263214111f, 0.00256633759f, 0.00126647949f, 0.00427484512f,
    0.00433349609f, 0.00135087967f, 0.0010061264f, 0.00420856476f, 0.00435972214f, 0.00125169754f,
    -0.00518941879f, -0.00311851501f, 0.00345659256f, 0.00406599045f, 0.00123071671f,
    -0.00729703903f, -0.0117373466f, -0.00501203537f, 0.00279712677f, 0.00384473801f, 0.0012140274f,
    -0.00255393982f, -0.0109424591f, -0.0144152641f, -0.0060915947f, 0.00225257874f, 0.00360822678f,
    0.00117683411f, -0.00230312347f, -0.00651168823f, 0.0068962574f, -0.00941944122f, 0.0057823658f,
    0.00864124298f, -0.00580024719f, -0.000121831894f, 0.0080871582f, 0.0047852993f, 0.00197339058f,
    -0.00245094299f, 0.0012614727f, 0.00468993187f, 0.00298380852f, 0.00553441048f, 0.000450849533f,
    -0.00285506248f, 0.0010638237f, 0.00317406654f, 0.00202393532f, 0.00181627274f, 0.0024433136f,
    -0.00083065033f, -0.00145101547f, 0.00105166435f, 0.00224328041f, 0.00134754181f,
    -0.00146269798f, -0.00204205513f, -0.00538539886f, -0.0019698143f, -0.00753331184f,
    -0.00284385681f, -0.00179672241f, -0.00574803352f, -0.00388145447f, -0.00180387497f,
    -0.0012242794f, -0.0021276474f, -0.00285053253f, -0.0025703907f, -0.00122857094f,
    -4.8160553e-05f, 0.000589370728f, -0.000982046127f, -0.00201249123f, -0.00180220604f,
    -0.000799417496f, 0.000859022141f, 0.00147485733f, 0.000324010849f, -0.000741481781f,
    -0.00145554543f, -0.00122570992f, -0.000508785248f, 0.281668067f, 0.345369339f, -0.00572001934f,
    0.182568192f, 0.0407261848f, -0.0397013426f, -0.0197923183f, 0.0827316046f, -0.0132759809f,
    -0.040843606f, -0.0968484879f, 0.0509787798f, 0.0372512341f, -0.0307725668f, -0.0332297087f,
    -0.0352892876f, -0.0194755793f, 0.0408533812f, 0.00822913647f, -0.0309960842f, -0.0252044201f,
    0.0400775671f, -0.0387741327f, -0.000985145569f, 0.0255613327f, -0.00393819809f, -0.0269719362f,
    -0.0189138651f, -0.0697994232f, -0.0629547834f, -0.0643641949f, -0.0155775547f, -0.0455853939f,
    -0.0374586582f, -0.0125522614f, 0.00602889061f, -0.011412859f, -0.0243618488f, -0.038421154f,
    0.00311017036f, 0.0319336653f, 0.00160372257f, -0.0175441504f, -0.0266031027f, -0.0405271053f,
    0.0233542919f, 0.0402264595f, 0.00568962097f, -0.013228178f, 0.0164796114f, -0.0423288345f,
    -0.0254061222f, 0.034620285f, 0.0408115387f, 0.00650990009f, -0.0102347136f, 0.0212807655f,
    0.0284442902f, 0.0249865055f, 0.0166158676f, 0.0331895351f, 0.0178575516f, -0.000905990601f,
    0.0101788044f, 0.0256659985f, 0.0118660927f, -0.00139093399f, -0.0244441032f, 0.00294494629f,
    0.0202012062f, 0.00724411011f, 0.0175626278f, -0.0242404938f, -0.0361354351f, 0.000293016434f,
    0.0160372257f, 0.00395083427f, 0.027692318f, 0.0182099342f, -0.0408535004f, -0.0405342579f,
    -0.000287532806f, 0.0128679276f, 0.00159883499f, 0.0112938881f, -0.00173330307f, 0.0153923035f,
    -0.0211110115f, -0.00207996368f, 0.0141205788f, -0.0121793747f, -0.025592804f, -0.000778675079f,
    0.0123362541f, 0.0133805275f, -0.0134019852f, -0.0220842361f, 0.000544548035f, 0.0105853081f,
    0.0174841881f, 0.0240273476f, -0.0121269226f, -0.0187306404f, 0.00180673599f, 0.00885486603f,
    -0.00281906128f, 0.0360898972f, 0.0264635086f, -0.011598587f, -0.0158734322f, 0.00301074982f,
    0.00728845596f, 0.00137996674f, -0.00205135345f, 0.00225162506f, -0.0021572113f,
    -0.00385093689f, 0.00267505646f, 0.00716590881f, -0.002784729f, -0.00452899933f, 0.00319194794f,
    0.0110034943f, 0.0112314224f, -0.0030374527f, -0.00490856171f, 0.00361156464f, -0.00302886963f,
    0.0130958557f, 0.0121116638f, -0.00349617004f, -0.00511360168f, 0.00394248962f, -0.0185232162f,
    -0.0126848221f, 0.0123958588f, 0.0124511719f, -0.00386619568f, -0.00530433655f, 0.00418567657f,
    0.0330786705f, 0.0698199272f, 0.00346398354f, 0.0906457901f, 0.0120235682f, -0.00203430653f,
    0.0646808147f, 0.022213459f, -0.00410425663f, -0.00525963306f, 0.00370311737f, 0.0234953165f,
    -3.81469727e-06f, -0.00793075562f, -0.00445151329f, -0.0369312763f, 0.0104211569f,
    0.00909566879f, -0.00436985493f, -0.00763177872f, -0.00376212597f, -0.0241527557f,
    -0.00657629967f, 0.0113360882f, 0.00301456451f, -0.00607204437f, -0.00662493706f,
    -0.00299596786f, -0.0163520575f, -0.0269688368f, -0.00549912453f, -0.0271254778f,
    -0.0108840466f, 0.00292634964f, -0.0171610117f, -0.0123921633f, 0.00267910957f, 0.00500023365f,
    -0.00621521473f, -0.00910747051f, 0.00154709816f, 0.00750410557f, 0.00556862354f,
    -0.00260055065f, -0.005854249f, 0.00139176846f, 0.00808918476f, 0.00885033607f, 0.00533938408f,
    -0.00276100636f, -0.00558364391f, 0.000122666359f, 0.00712990761f, 0.00994873047f,
    0.00861656666f, 0.00496006012f, 0.00960564613f, 0.0118482113f, 0.00770831108f, 0.00753760338f,
    0.00777244568f, 0.00369691849f, 0.00384545326f, 0.00126957893f, 0.0022354126f, 0.00139307976f,
    0.00463628769f, -0.0035841465f, -0.00359153748f, -0.000757217407f, 3.81469727e-05f,
    0.00716018677f, -0.000939369202f, -0.00767540932f, -0.00567746162f, -0.00216627121f,
    -0.000720977783f, 0.00619697571f, 0.00550293922f, -0.00490856171f, -0.00878810883f,
    -0.00604748726f, -0.00277376175f, -0.00119161606f, -0.0312645435f, -0.0386152267f,
    0.00372242928f, -0.0182499886f, -0.000293970108f, 0.00704264641f, 0.0101408958f,
    -0.00566482544f, 0.0031042099f, 0.00460338593f, 0.0218126774f, -0.00302433968f, -0.00507378578f,
    0.00284433365f, 0.00321602821f, 0.00906157494f, 0.00455474854f, -0.00552248955f,
    -0.00199723244f, 0.00230979919f, 0.00232100487f, -0.00930643082f, 0.0059094429f, 0.00177073479f,
    -0.00321865082f, -0.000923871994f, 0.00181889534f, 0.00165581703f, 0.0043053627f,
    0.00150442123f, 0.0016579628f, -0.00548458099f, 0.00106048584f, 0.00146436691f, -0.00700807571f,
    -0.000960350037f, 0.00123357773f, 0.000699996948f, -0.00119924545f, -0.00181674957f,
    -0.000330448151f, 0.000719070435f, 0.000406265259f, 0.00434446335f, -0.000633239746f,
    -0.00141716003f, 2.81333923e-05f, 0.000544071198f, 0.0002784729f, 0.0032544136f,
    0.000626564026f, -0.00097322464f, -0.00065612793f, 0.000205993652f, 0.000453472137f,
    0.000180721283f, 0.0f, 0.0f, 0.0f, 0.0f
};

/* What all weights share: the closed form preetham_classes. */
#ifdef SKYLIGHT_SH_7_BANDS_1_5PCT_LANES
/* Equal formulas of different numbers side by side. */
static inline void skylight_sh_7_bands_1_5pct_factors(const skylight_sh_7_bands_1_5pct_real *x,
    skylight_sh_7_bands_1_5pct_real *out)
{
    const float chi = (0.888888896f - x[1] * 0.0166666675f) * (1.57079637f - x[0]);
    const float square = chi * chi;
    const float below = 945.0f - square * (420.0f - 15.0f * square);
    const float zenith = (4045.30005f * x[1] - 4971.0f) * (chi * (945.0f - square * (105.0f -
        square))) + (2419.19995f - 215.5f * x[1]) * below;
    const float part_1 = (-0.355399996f) * x[1] + 0.42750001f;
    const float up = 1.0f + part_1 * (0.25f + part_1 * 0.03125f);
    const float up2 = up * up;
    const skylight_sh_7_bands_1_5pct_four y = (skylight_sh_7_bands_1_5pct_triple(0.1206f,
        (-0.0640999973f), (-0.0441000015f)) * x[1] +
        skylight_sh_7_bands_1_5pct_triple((-2.57710004f), (-0.898899972f),
        (-1.65369999f))) * x[0] * 0.25f;
    const skylight_sh_7_bands_1_5pct_four y2 = y * y;
    const skylight_sh_7_bands_1_5pct_four halo = 1.0f + 0.99999845f * y + y2 * (0.499975085f +
        0.166515172f * y + y2 * (0.0412233174f + 0.00765432511f * y + y2 * 0.000849007862f));
    const skylight_sh_7_bands_1_5pct_four halo2 = halo * halo;
    const skylight_sh_7_bands_1_5pct_four halo4 = halo2 * halo2;
    const float z = x[0] * x[0];
    const float cosine = 1.0f - z * (0.5f - z * 0.03125f);
    const float cosine2 = cosine * cosine;
    const skylight_sh_7_bands_1_5pct_four part_2 = 1.0f +
        (skylight_sh_7_bands_1_5pct_triple((-0.0227000006f), (-0.00039999999f),
        (-0.00789999962f)) * x[1] + skylight_sh_7_bands_1_5pct_triple(5.32509995f, 0.212500006f,
        0.210199997f)) * halo4 + (skylight_sh_7_bands_1_5pct_triple((-0.0670000017f),
        (-0.00329999998f), (-0.0109000001f)) * x[1] +
        skylight_sh_7_bands_1_5pct_triple(0.370299995f, 0.0452000014f, 0.0529000014f)) * cosine2;
    const float shape_y = (1.0f + (0.1787f * x[1] + (-1.46300006f)) * (up2 * up2)) * part_2[0];
    const skylight_sh_7_bands_1_5pct_four y_zenith =
        ((((skylight_sh_7_bands_1_5pct_pair(0.00274999999f,
        0.00165999995f) * x[1] + skylight_sh_7_bands_1_5pct_pair((-0.0421399996f),
        (-0.0290300008f))) * x[1] + skylight_sh_7_bands_1_5pct_pair(0.153459996f,
        0.11693f)) * x[0] + ((skylight_sh_7_bands_1_5pct_pair((-0.00609999988f),
        (-0.00374999992f)) * x[1] + skylight_sh_7_bands_1_5pct_pair(0.0896999985f,
        0.0637700036f)) * x[1] + skylight_sh_7_bands_1_5pct_pair((-0.267560005f),
        (-0.211960003f)))) * x[0] + ((skylight_sh_7_bands_1_5pct_pair(0.00316999992f,
        0.00209000008f) * x[1] + skylight_sh_7_bands_1_5pct_pair((-0.0415299982f),
        (-0.0320199989f))) * x[1] + skylight_sh_7_bands_1_5pct_pair(0.0666999966f,
        0.0605200008f))) * x[0] + (skylight_sh_7_bands_1_5pct_pair(0.00516000018f,
        0.0039400002f) * x[1] + skylight_sh_7_bands_1_5pct_pair(0.266880006f, 0.258859992f));
    const float part_3 = y_zenith[0];
    const float shape_x = (0.00249999994f * x[1] + 0.733200014f) * part_2[1];
    const float one = zenith / (below * shape_y * part_3 * shape_x);
    const float shape_z = (0.00992999971f * x[1] + 0.734399974f) * part_2[2];
    const float of_x = one * y_zenith[1] * shape_z;
    const skylight_sh_7_bands_1_5pct_four part_4 = skylight_sh_7_bands_1_5pct_triple(3.73898554f,
        (-1.01082206f), (-1.00158179f)) * of_x;
    skylight_sh_7_bands_1_5pct_keep(out + 4, part_4);
    const float of_y = one * part_3 * shape_x;
    const float of_s = one * shape_z * shape_x;
    const skylight_sh_7_bands_1_5pct_four part_5 =
        skylight_sh_7_bands_1_5pct_triple((-0.498531401f), 0.0415560007f, 1.05722523f) * of_s;
    skylight_sh_7_bands_1_5pct_keep(out + 8, part_5);
    const skylight_sh_7_bands_1_5pct_four part_6 = part_4 +
        skylight_sh_7_bands_1_5pct_triple((-1.03860712f), 1.83445477f,
        (-1.26125109f)) * of_y + part_5;
    skylight_sh_7_bands_1_5pct_keep(out + 0, part_6);
    (void)x;
}

#else
static inline void skylight_sh_7_bands_1_5pct_factors(const skylight_sh_7_bands_1_5pct_real *x,
    skylight_sh_7_bands_1_5pct_real *out)
{
    const float chi = (0.888888896f - x[1] * 0.0166666675f) * (1.57079637f - x[0]);
    const float square = chi * chi;
    const float below = 945.0f - square * (420.0f - 15.0f * square);
    const float zenith = (4045.30005f * x[1] - 4971.0f) * (chi * (945.0f - square * (105.0f -
        square))) + (2419.19995f - 215.5f * x[1]) * below;
    const float part_1 = (-0.355399996f) * x[1] + 0.42750001f;
    const float up = 1.0f + part_1 * (0.25f + part_1 * 0.03125f);
    const float up2 = up * up;
    const float y = (0.1206f * x[1] + (-2.57710004f)) * x[0] * 0.25f;
    const float y2 = y * y;
    const float halo = 1.0f + 0.99999845f * y + y2 * (0.499975085f + 0.166515172f * y + y2 *
        (0.0412233174f + 0.00765432511f * y + y2 * 0.000849007862f));
    const float halo2 = halo * halo;
    const float halo4 = halo2 * halo2;
    const float z = x[0] * x[0];
    const float cosine = 1.0f - z * (0.5f - z * 0.03125f);
    const float cosine2 = cosine * cosine;
    const float shape_y = (1.0f + (0.1787f * x[1] + (-1.46300006f)) * (up2 * up2)) * (1.0f +
        ((-0.0227000006f) * x[1] + 5.32509995f) * halo4 + ((-0.0670000017f) * x[1] + 0.370299995f) *
        cosine2);
    const float y_zenith = ((((0.00274999999f * x[1] + (-0.0421399996f)) * x[1] + 0.153459996f) *
        x[0] + (((-0.00609999988f) * x[1] + 0.0896999985f) * x[1] + (-0.267560005f))) * x[0] +
        ((0.00316999992f * x[1] + (-0.0415299982f)) * x[1] + 0.0666999966f)) * x[0] +
        (0.00516000018f * x[1] + 0.266880006f);
    const float y_2 = ((-0.0640999973f) * x[1] + (-0.898899972f)) * x[0] * 0.25f;
    const float y2_2 = y_2 * y_2;
    const float halo_2 = 1.0f + 0.99999845f * y_2 + y2_2 * (0.499975085f + 0.166515172f * y_2 + y2_2
        * (0.0412233174f + 0.00765432511f * y_2 + y2_2 * 0.000849007862f));
    const float halo2_2 = halo_2 * halo_2;
    const float halo4_2 = halo2_2 * halo2_2;
    const float shape_x = (0.00249999994f * x[1] + 0.733200014f) * (1.0f + ((-0.00039999999f) * x[1]
        + 0.212500006f) * halo4_2 + ((-0.00329999998f) * x[1] + 0.0452000014f) * cosine2);
    const float one = zenith / (below * shape_y * y_zenith * shape_x);
    const float x_zenith = ((((0.00165999995f * x[1] + (-0.0290300008f)) * x[1] + 0.11693f) * x[0] +
        (((-0.00374999992f) * x[1] + 0.0637700036f) * x[1] + (-0.211960003f))) * x[0] +
        ((0.00209000008f * x[1] + (-0.0320199989f)) * x[1] + 0.0605200008f)) * x[0] + (0.0039400002f
        * x[1] + 0.258859992f);
    const float y_3 = ((-0.0441000015f) * x[1] + (-1.65369999f)) * x[0] * 0.25f;
    const float y2_3 = y_3 * y_3;
    const float halo_3 = 1.0f + 0.99999845f * y_3 + y2_3 * (0.499975085f + 0.166515172f * y_3 + y2_3
        * (0.0412233174f + 0.00765432511f * y_3 + y2_3 * 0.000849007862f));
    const float halo2_3 = halo_3 * halo_3;
    const float halo4_3 = halo2_3 * halo2_3;
    const float shape_z = (0.00992999971f * x[1] + 0.734399974f) * (1.0f + ((-0.00789999962f) * x[1]
        + 0.210199997f) * halo4_3 + ((-0.0109000001f) * x[1] + 0.0529000014f) * cosine2);
    const float of_x = one * x_zenith * shape_z;
    out[4] = 3.73898554f * of_x;
    const float of_y = one * y_zenith * shape_x;
    const float of_s = one * shape_z * shape_x;
    out[8] = (-0.498531401f) * of_s;
    out[0] = out[4] + (-1.03860712f) * of_y + out[8];
    out[5] = (-1.01082206f) * of_x;
    out[9] = 0.0415560007f * of_s;
    out[1] = out[5] + 1.83445477f * of_y + out[9];
    out[6] = (-1.00158179f) * of_x;
    out[10] = 1.05722523f * of_s;
    out[2] = out[6] + (-1.26125109f) * of_y + out[10];
    out[3] = 0;
    out[7] = 0;
    out[11] = 0;
    (void)x;
}

#endif /* SKYLIGHT_SH_7_BANDS_1_5PCT_LANES */

/* The functions of sun_zenith (change of variable: even); 0 where there is
   none. */
static inline void skylight_sh_7_bands_1_5pct_first(const skylight_sh_7_bands_1_5pct_real *x,
    skylight_sh_7_bands_1_5pct_real *out)
{
    out[0] = 1.0f;
    out[1] = (-13.3479729f) * (x[0] * x[0] - 0.0f) / ((-14.0f) - x[0] * x[0]) - 1.0f;
    out[2] = out[1] * out[1];
    out[3] = out[1] * out[2];
    out[4] = out[1] * out[3];
    out[5] = out[1] * out[4];
    out[6] = 0;
    out[7] = 0;
    (void)x;
}

/* All products of the functions of turbidity (change of variable:
   reciprocal). */
static inline void skylight_sh_7_bands_1_5pct_others(const skylight_sh_7_bands_1_5pct_real *x,
    skylight_sh_7_bands_1_5pct_real *out)
{
    out[0] = 1.0f;
    out[1] = (-4.85714293f) * (x[1] - 2.5f) / ((-2.5f) - x[1]) - 1.0f;
    out[2] = out[1] * out[1];
    out[3] = out[1] * out[2];
    (void)x;
}

/* cos(m azimuth) and sin(m azimuth), m < bands, each times the m-th power
   of `radius`, by doubling. */
static inline void skylight_sh_7_bands_1_5pct_waves(skylight_sh_7_bands_1_5pct_real cosine,
    skylight_sh_7_bands_1_5pct_real sine, skylight_sh_7_bands_1_5pct_real radius,
    skylight_sh_7_bands_1_5pct_real *cosines, skylight_sh_7_bands_1_5pct_real *sines)
{
    cosines[0] = 1.0f;
    cosines[1] = radius * cosine;
    sines[1] = radius * sine;
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
static inline skylight_sh_7_bands_1_5pct_real skylight_sh_7_bands_1_5pct_sine(const
    skylight_sh_7_bands_1_5pct_real *x)
{
    const float part_1 = x[SKYLIGHT_SH_7_BANDS_1_5PCT_SUN] * x[SKYLIGHT_SH_7_BANDS_1_5PCT_SUN];
    return x[SKYLIGHT_SH_7_BANDS_1_5PCT_SUN] + x[SKYLIGHT_SH_7_BANDS_1_5PCT_SUN] * (part_1 *
        ((-0.166666597f) + part_1 * (0.00833306555f + part_1 * ((-0.000198095426f) + part_1 *
        2.60563934e-06f))));
}

/* Cosine and sine of an angle of at most an eighth of a turn. */
static inline void skylight_sh_7_bands_1_5pct_quarter(skylight_sh_7_bands_1_5pct_real angle,
    skylight_sh_7_bands_1_5pct_real *out)
{
    const float part_1 = angle * angle;
    out[0] = 1.0f - 0.5f * part_1 + part_1 * part_1 * (0.0416666456f + part_1 * ((-0.00138873665f) +
        part_1 * 2.44383464e-05f));
    out[1] = angle + angle * (part_1 * ((-0.166666552f) + part_1 * (0.0083321603f + part_1 *
        (-0.00019515281f))));
}

#ifdef SKYLIGHT_SH_7_BANDS_1_5PCT_LANES
/* The same for suns side by side. */
static inline void skylight_sh_7_bands_1_5pct_factors_suns(const skylight_sh_7_bands_1_5pct_lanes
    *x, skylight_sh_7_bands_1_5pct_lanes *out)
{
    const skylight_sh_7_bands_1_5pct_lanes chi = (0.888888896f - x[1] * 0.0166666675f) *
        (1.57079637f - x[0]);
    const skylight_sh_7_bands_1_5pct_lanes square = chi * chi;
    const skylight_sh_7_bands_1_5pct_lanes below = 945.0f - square * (420.0f - 15.0f * square);
    const skylight_sh_7_bands_1_5pct_lanes zenith = (4045.30005f * x[1] - 4971.0f) * (chi * (945.0f
        - square * (105.0f - square))) + (2419.19995f - 215.5f * x[1]) * below;
    const skylight_sh_7_bands_1_5pct_lanes part_1 = (-0.355399996f) * x[1] + 0.42750001f;
    const skylight_sh_7_bands_1_5pct_lanes up = 1.0f + part_1 * (0.25f + part_1 * 0.03125f);
    const skylight_sh_7_bands_1_5pct_lanes up2 = up * up;
    const skylight_sh_7_bands_1_5pct_lanes y = (0.1206f * x[1] + (-2.57710004f)) * x[0] * 0.25f;
    const skylight_sh_7_bands_1_5pct_lanes y2 = y * y;
    const skylight_sh_7_bands_1_5pct_lanes halo = 1.0f + 0.99999845f * y + y2 * (0.499975085f +
        0.166515172f * y + y2 * (0.0412233174f + 0.00765432511f * y + y2 * 0.000849007862f));
    const skylight_sh_7_bands_1_5pct_lanes halo2 = halo * halo;
    const skylight_sh_7_bands_1_5pct_lanes halo4 = halo2 * halo2;
    const skylight_sh_7_bands_1_5pct_lanes z = x[0] * x[0];
    const skylight_sh_7_bands_1_5pct_lanes cosine = 1.0f - z * (0.5f - z * 0.03125f);
    const skylight_sh_7_bands_1_5pct_lanes cosine2 = cosine * cosine;
    const skylight_sh_7_bands_1_5pct_lanes shape_y = (1.0f + (0.1787f * x[1] + (-1.46300006f)) *
        (up2 * up2)) * (1.0f + ((-0.0227000006f) * x[1] + 5.32509995f) * halo4 + ((-0.0670000017f) *
        x[1] + 0.370299995f) * cosine2);
    const skylight_sh_7_bands_1_5pct_lanes y_zenith = ((((0.00274999999f * x[1] + (-0.0421399996f))
        * x[1] + 0.153459996f) * x[0] + (((-0.00609999988f) * x[1] + 0.0896999985f) * x[1] +
        (-0.267560005f))) * x[0] + ((0.00316999992f * x[1] + (-0.0415299982f)) * x[1] +
        0.0666999966f)) * x[0] + (0.00516000018f * x[1] + 0.266880006f);
    const skylight_sh_7_bands_1_5pct_lanes y_2 = ((-0.0640999973f) * x[1] + (-0.898899972f)) * x[0]
        * 0.25f;
    const skylight_sh_7_bands_1_5pct_lanes y2_2 = y_2 * y_2;
    const skylight_sh_7_bands_1_5pct_lanes halo_2 = 1.0f + 0.99999845f * y_2 + y2_2 * (0.499975085f
        + 0.166515172f * y_2 + y2_2 * (0.0412233174f + 0.00765432511f * y_2 + y2_2 *
        0.000849007862f));
    const skylight_sh_7_bands_1_5pct_lanes halo2_2 = halo_2 * halo_2;
    const skylight_sh_7_bands_1_5pct_lanes halo4_2 = halo2_2 * halo2_2;
    const skylight_sh_7_bands_1_5pct_lanes shape_x = (0.00249999994f * x[1] + 0.733200014f) * (1.0f
        + ((-0.00039999999f) * x[1] + 0.212500006f) * halo4_2 + ((-0.00329999998f) * x[1] +
        0.0452000014f) * cosine2);
    const skylight_sh_7_bands_1_5pct_lanes one = zenith / (below * shape_y * y_zenith * shape_x);
    const skylight_sh_7_bands_1_5pct_lanes x_zenith = ((((0.00165999995f * x[1] + (-0.0290300008f))
        * x[1] + 0.11693f) * x[0] + (((-0.00374999992f) * x[1] + 0.0637700036f) * x[1] +
        (-0.211960003f))) * x[0] + ((0.00209000008f * x[1] + (-0.0320199989f)) * x[1] +
        0.0605200008f)) * x[0] + (0.0039400002f * x[1] + 0.258859992f);
    const skylight_sh_7_bands_1_5pct_lanes y_3 = ((-0.0441000015f) * x[1] + (-1.65369999f)) * x[0] *
        0.25f;
    const skylight_sh_7_bands_1_5pct_lanes y2_3 = y_3 * y_3;
    const skylight_sh_7_bands_1_5pct_lanes halo_3 = 1.0f + 0.99999845f * y_3 + y2_3 * (0.499975085f
        + 0.166515172f * y_3 + y2_3 * (0.0412233174f + 0.00765432511f * y_3 + y2_3 *
        0.000849007862f));
    const skylight_sh_7_bands_1_5pct_lanes halo2_3 = halo_3 * halo_3;
    const skylight_sh_7_bands_1_5pct_lanes halo4_3 = halo2_3 * halo2_3;
    const skylight_sh_7_bands_1_5pct_lanes shape_z = (0.00992999971f * x[1] + 0.734399974f) * (1.0f
        + ((-0.00789999962f) * x[1] + 0.210199997f) * halo4_3 + ((-0.0109000001f) * x[1] +
        0.0529000014f) * cosine2);
    const skylight_sh_7_bands_1_5pct_lanes of_x = one * x_zenith * shape_z;
    const skylight_sh_7_bands_1_5pct_lanes part_2 = 3.73898554f * of_x;
    out[4] = part_2;
    const skylight_sh_7_bands_1_5pct_lanes of_y = one * y_zenith * shape_x;
    const skylight_sh_7_bands_1_5pct_lanes of_s = one * shape_z * shape_x;
    const skylight_sh_7_bands_1_5pct_lanes part_3 = (-0.498531401f) * of_s;
    out[8] = part_3;
    const skylight_sh_7_bands_1_5pct_lanes part_4 = part_2 + (-1.03860712f) * of_y + part_3;
    out[0] = part_4;
    const skylight_sh_7_bands_1_5pct_lanes part_5 = (-1.01082206f) * of_x;
    out[5] = part_5;
    const skylight_sh_7_bands_1_5pct_lanes part_6 = 0.0415560007f * of_s;
    out[9] = part_6;
    const skylight_sh_7_bands_1_5pct_lanes part_7 = part_5 + 1.83445477f * of_y + part_6;
    out[1] = part_7;
    const skylight_sh_7_bands_1_5pct_lanes part_8 = (-1.00158179f) * of_x;
    out[6] = part_8;
    const skylight_sh_7_bands_1_5pct_lanes part_9 = 1.05722523f * of_s;
    out[10] = part_9;
    const skylight_sh_7_bands_1_5pct_lanes part_10 = part_8 + (-1.26125109f) * of_y + part_9;
    out[2] = part_10;
    out[3] = skylight_sh_7_bands_1_5pct_spread(0);
    out[7] = skylight_sh_7_bands_1_5pct_spread(0);
    out[11] = skylight_sh_7_bands_1_5pct_spread(0);
    (void)x;
}

/* The functions of sun_zenith (change of variable: even); 0 where there is
   none. */
static inline void skylight_sh_7_bands_1_5pct_first_suns(const skylight_sh_7_bands_1_5pct_lanes *x,
    skylight_sh_7_bands_1_5pct_lanes *out)
{
    out[0] = skylight_sh_7_bands_1_5pct_spread(1.0f);
    const skylight_sh_7_bands_1_5pct_lanes part_1 = (-13.3479729f) * (x[0] * x[0] - 0.0f) /
        ((-14.0f) - x[0] * x[0]) - 1.0f;
    out[1] = part_1;
    const skylight_sh_7_bands_1_5pct_lanes part_2 = part_1 * part_1;
    out[2] = part_2;
    const skylight_sh_7_bands_1_5pct_lanes part_3 = part_1 * part_2;
    out[3] = part_3;
    const skylight_sh_7_bands_1_5pct_lanes part_4 = part_1 * part_3;
    out[4] = part_4;
    const skylight_sh_7_bands_1_5pct_lanes part_5 = part_1 * part_4;
    out[5] = part_5;
    out[6] = skylight_sh_7_bands_1_5pct_spread(0);
    out[7] = skylight_sh_7_bands_1_5pct_spread(0);
    (void)x;
}

/* All products of the functions of turbidity (change of variable:
   reciprocal). */
static inline void skylight_sh_7_bands_1_5pct_others_suns(const skylight_sh_7_bands_1_5pct_lanes *x,
    skylight_sh_7_bands_1_5pct_lanes *out)
{
    out[0] = skylight_sh_7_bands_1_5pct_spread(1.0f);
    const skylight_sh_7_bands_1_5pct_lanes part_1 = (-4.85714293f) * (x[1] - 2.5f) / ((-2.5f) -
        x[1]) - 1.0f;
    out[1] = part_1;
    const skylight_sh_7_bands_1_5pct_lanes part_2 = part_1 * part_1;
    out[2] = part_2;
    const skylight_sh_7_bands_1_5pct_lanes part_3 = part_1 * part_2;
    out[3] = part_3;
    (void)x;
}

/* cos(m azimuth) and sin(m azimuth), m < bands, each times the m-th power
   of `radius`, by doubling. */
static inline void skylight_sh_7_bands_1_5pct_waves_suns(skylight_sh_7_bands_1_5pct_lanes cosine,
    skylight_sh_7_bands_1_5pct_lanes sine, skylight_sh_7_bands_1_5pct_lanes radius,
    skylight_sh_7_bands_1_5pct_lanes *cosines, skylight_sh_7_bands_1_5pct_lanes *sines)
{
    cosines[0] = skylight_sh_7_bands_1_5pct_spread(1.0f);
    const skylight_sh_7_bands_1_5pct_lanes part_1 = radius * cosine;
    cosines[1] = part_1;
    const skylight_sh_7_bands_1_5pct_lanes part_2 = radius * sine;
    sines[1] = part_2;
    const skylight_sh_7_bands_1_5pct_lanes part_3 = part_1 * part_1 - part_2 * part_2;
    cosines[2] = part_3;
    const skylight_sh_7_bands_1_5pct_lanes part_4 = part_2 * part_1 + part_1 * part_2;
    sines[2] = part_4;
    const skylight_sh_7_bands_1_5pct_lanes part_5 = part_1 * part_3 - part_2 * part_4;
    cosines[3] = part_5;
    const skylight_sh_7_bands_1_5pct_lanes part_6 = part_3 * part_3 - part_4 * part_4;
    cosines[4] = part_6;
    const skylight_sh_7_bands_1_5pct_lanes part_7 = part_2 * part_3 + part_1 * part_4;
    sines[3] = part_7;
    const skylight_sh_7_bands_1_5pct_lanes part_8 = part_3 * part_5 - part_4 * part_7;
    cosines[5] = part_8;
    const skylight_sh_7_bands_1_5pct_lanes part_9 = part_5 * part_5 - part_7 * part_7;
    cosines[6] = part_9;
    sines[0] = skylight_sh_7_bands_1_5pct_spread(0.0f);
    const skylight_sh_7_bands_1_5pct_lanes part_10 = part_4 * part_3 + part_3 * part_4;
    sines[4] = part_10;
    const skylight_sh_7_bands_1_5pct_lanes part_11 = part_4 * part_5 + part_3 * part_7;
    sines[5] = part_11;
    const skylight_sh_7_bands_1_5pct_lanes part_12 = part_7 * part_5 + part_5 * part_7;
    sines[6] = part_12;
}

/* The sine of the sun's zenith angle, whose powers the sums of order m
   lack. */
static inline skylight_sh_7_bands_1_5pct_lanes skylight_sh_7_bands_1_5pct_sine_suns(const
    skylight_sh_7_bands_1_5pct_lanes *x)
{
    const skylight_sh_7_bands_1_5pct_lanes part_1 = x[SKYLIGHT_SH_7_BANDS_1_5PCT_SUN] *
        x[SKYLIGHT_SH_7_BANDS_1_5PCT_SUN];
    return x[SKYLIGHT_SH_7_BANDS_1_5PCT_SUN] + x[SKYLIGHT_SH_7_BANDS_1_5PCT_SUN] * (part_1 *
        ((-0.166666597f) + part_1 * (0.00833306555f + part_1 * ((-0.000198095426f) + part_1 *
        2.60563934e-06f))));
}

static inline void skylight_sh_7_bands_1_5pct_quarter_suns(skylight_sh_7_bands_1_5pct_lanes angle,
    skylight_sh_7_bands_1_5pct_lanes *out)
{
    const skylight_sh_7_bands_1_5pct_lanes part_1 = angle * angle;
    const skylight_sh_7_bands_1_5pct_lanes part_2 = 1.0f - 0.5f * part_1 + part_1 * part_1 *
        (0.0416666456f + part_1 * ((-0.00138873665f) + part_1 * 2.44383464e-05f));
    out[0] = part_2;
    const skylight_sh_7_bands_1_5pct_lanes part_3 = angle + angle * (part_1 * ((-0.166666552f) +
        part_1 * (0.0083321603f + part_1 * (-0.00019515281f))));
    out[1] = part_3;
}

#endif /* SKYLIGHT_SH_7_BANDS_1_5PCT_LANES */

/* The zonal window's factor for the degree `share` * bands (Habel et al.
   2008, eq. 5). */
static inline float skylight_sh_7_bands_1_5pct_sinc(float share)
{
    const float x = 3.14159274f * share;
    return sinf(x) / x;
}

/* Of each axis: where its functions have slopes. */
static const double skylight_sh_7_bands_1_5pct_slope_range[SKYLIGHT_SH_7_BANDS_1_5PCT_AXES][2] = { {
    0.0, 1.5707963267948966 }, { 2.5, 6.0 } };

/* The functions of an axis at v, and their slopes. */
static inline void skylight_sh_7_bands_1_5pct_functions(int axis, double v, double *out,
    double *slopes)
{
    if (axis == 0) {
        out[0] = 1.0;
        const double part_1 = (-14.0) - v * v;
        const double part_2 = (-13.347972567941833) * (v * v - 0.0) / part_1;
        out[1] = part_2 - 1.0;
        out[2] = out[1] * out[1];
        out[3] = out[1] * out[2];
        out[4] = out[1] * out[3];
        out[5] = out[1] * out[4];
        slopes[0] = 0.0;
        slopes[1] = (-13.347972567941833) * (v + v) / part_1 - part_2 * -(v + v) / part_1;
        slopes[2] = slopes[1] * out[1] + out[1] * slopes[1];
        slopes[3] = slopes[1] * out[2] + out[1] * slopes[2];
        slopes[4] = slopes[1] * out[3] + out[1] * slopes[3];
        slopes[5] = slopes[1] * out[4] + out[1] * slopes[4];
    }
    if (axis == 1) {
        out[0] = 1.0;
        const double part_1 = (-2.5) - v;
        const double part_2 = (-4.8571428571428568) * (v - 2.5) / part_1;
        out[1] = part_2 - 1.0;
        out[2] = out[1] * out[1];
        out[3] = out[1] * out[2];
        slopes[0] = 0.0;
        slopes[1] = (-4.8571428571428568) / part_1 - part_2 * -1.0 / part_1;
        slopes[2] = slopes[1] * out[1] + out[1] * slopes[1];
        slopes[3] = slopes[1] * out[2] + out[1] * slopes[2];
    }
    (void)v;
}

/* The factors, then their slopes after each axis. */
static inline void skylight_sh_7_bands_1_5pct_factor_slopes(const double *x, double *out)
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
static inline void skylight_sh_7_bands_1_5pct_sine_slope(const double *x, double *out)
{
    out[0] = sin(x[SKYLIGHT_SH_7_BANDS_1_5PCT_SUN]);
    out[1] = cos(x[SKYLIGHT_SH_7_BANDS_1_5PCT_SUN]);
}

/* 0 for a finite number, 1 for an infinity, 2 for NaN: by its bits, so that -ffast-math cannot
   remove the test. */
static inline int skylight_sh_7_bands_1_5pct_kind(float v)
{
    uint32_t bits;
    memcpy(&bits, &v, sizeof bits);
    bits &= 0x7fffffffu;
    return (bits >= 0x7f800000u) + (bits > 0x7f800000u);
}

/* A number that is no NaN, finite: an infinity becomes a large number of its sign. */
static inline float skylight_sh_7_bands_1_5pct_finite(float v)
{
    if (skylight_sh_7_bands_1_5pct_kind(v)) {
        uint32_t bits;
        memcpy(&bits, &v, sizeof bits);
        v = bits >> 31 ? -3e38f : 3e38f;
    }
    return v;
}

/* Clamps the axes' inputs into x. Returns the status: 0; 1 where one was not inside; 2, and nothing
   in x, where one is NaN or the azimuth no finite number. */
static inline int skylight_sh_7_bands_1_5pct_inputs(const float
    inputs[SKYLIGHT_SH_7_BANDS_1_5PCT_AXES], float azimuth,
                                     skylight_sh_7_bands_1_5pct_real
                                         x[SKYLIGHT_SH_7_BANDS_1_5PCT_AXES])
{
    int axis, status = 0, strange = skylight_sh_7_bands_1_5pct_kind(azimuth) ? 2 : 0;
    for (axis = 0; axis < SKYLIGHT_SH_7_BANDS_1_5PCT_AXES; ++axis) strange |=
        skylight_sh_7_bands_1_5pct_kind(inputs[axis]);
    if (strange & 2) return 2;
    for (axis = 0; axis < SKYLIGHT_SH_7_BANDS_1_5PCT_AXES; ++axis) {
        const float v = strange ? skylight_sh_7_bands_1_5pct_finite(inputs[axis]) : inputs[axis];
        const skylight_sh_7_bands_1_5pct_real low = skylight_sh_7_bands_1_5pct_range[axis][0],
            high = skylight_sh_7_bands_1_5pct_range[axis][1];
        const skylight_sh_7_bands_1_5pct_real at_least = (skylight_sh_7_bands_1_5pct_real)v < low ?
            low : (skylight_sh_7_bands_1_5pct_real)v;
        status |= (v < skylight_sh_7_bands_1_5pct_inside[axis][0]) | (v >
            skylight_sh_7_bands_1_5pct_inside[axis][1]);
        x[axis] = at_least > high ? high : at_least;
    }
    return status;
}

/* The cosine and sine of an angle. */
static inline void skylight_sh_7_bands_1_5pct_circle(skylight_sh_7_bands_1_5pct_real angle,
    skylight_sh_7_bands_1_5pct_real *cosine,
                                      skylight_sh_7_bands_1_5pct_real *sine)
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
    skylight_sh_7_bands_1_5pct_quarter((float)((double)angle - (double)quarters *
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
static inline void skylight_sh_7_bands_1_5pct_mix(skylight_sh_7_bands_1_5pct_real
    sums[SKYLIGHT_SH_7_BANDS_1_5PCT_CLASSES][SKYLIGHT_SH_7_BANDS_1_5PCT_ROOM],
                                   int channel, const skylight_sh_7_bands_1_5pct_real *factors,
                                   skylight_sh_7_bands_1_5pct_real *mixed)
{
    int i;
    int k;
    for (i = 0; i < SKYLIGHT_SH_7_BANDS_1_5PCT_WIDTH; ++i)
        mixed[i] = factors[SKYLIGHT_SH_7_BANDS_1_5PCT_FACTOR(channel, 0)] * sums[0][i];
    for (k = 1; k < SKYLIGHT_SH_7_BANDS_1_5PCT_CLASSES; ++k)
        for (i = 0; i < SKYLIGHT_SH_7_BANDS_1_5PCT_WIDTH; ++i)
            mixed[i] += factors[SKYLIGHT_SH_7_BANDS_1_5PCT_FACTOR(channel, k)] * sums[k][i];
}

/* Orders m >= 0 alone are stored: those of a light that is even in y at azimuth 0. */
#define SKYLIGHT_SH_7_BANDS_1_5PCT_FIRST_ORDER(l) 0

/* Stores one weight of degree l and order m turned by the azimuth. */
static inline void skylight_sh_7_bands_1_5pct_place(skylight_sh_7_bands_1_5pct_real value, int l,
    int m,
                                     const skylight_sh_7_bands_1_5pct_real *cosines,
                                         const skylight_sh_7_bands_1_5pct_real *sines,
                                     float *weights)
{
    weights[l * (l + 1) - m] = (float)(value * sines[m]);
    weights[l * (l + 1) + m] = (float)(value * cosines[m]);
}

/* Stores the first `bands` bands of the channels' weights, turned by the azimuth (Habel et al.
 * 2008,
   eq. 4 with nothing for m < 0). */
static inline void skylight_sh_7_bands_1_5pct_store(
    skylight_sh_7_bands_1_5pct_real
        sums[SKYLIGHT_SH_7_BANDS_1_5PCT_CLASSES][SKYLIGHT_SH_7_BANDS_1_5PCT_ROOM],
        const skylight_sh_7_bands_1_5pct_real *factors,
    const skylight_sh_7_bands_1_5pct_real *cosines, const skylight_sh_7_bands_1_5pct_real *sines,
        int bands,
    float weights[SKYLIGHT_SH_7_BANDS_1_5PCT_CHANNELS][SKYLIGHT_SH_7_BANDS_1_5PCT_WEIGHTS])
{
    int channel;
#if defined(SKYLIGHT_SH_7_BANDS_1_5PCT_LANES) && SKYLIGHT_SH_7_BANDS_1_5PCT_BANDS > 3
    /* In fours; each overshoot is overwritten by what follows. */
    float plus[SKYLIGHT_SH_7_BANDS_1_5PCT_BANDS], minus[SKYLIGHT_SH_7_BANDS_1_5PCT_BANDS + 3] = {0};
    int m, q;
    for (m = 0; m < SKYLIGHT_SH_7_BANDS_1_5PCT_BANDS; ++m) {
        plus[m] = cosines[m];
        minus[SKYLIGHT_SH_7_BANDS_1_5PCT_BANDS - 1 - m] = sines[m];
    }
    for (channel = 0; channel < SKYLIGHT_SH_7_BANDS_1_5PCT_CHANNELS; ++channel) {
        float *const w = weights[channel];
        skylight_sh_7_bands_1_5pct_four v[SKYLIGHT_SH_7_BANDS_1_5PCT_FOURS];
        for (q = 0; q < SKYLIGHT_SH_7_BANDS_1_5PCT_FOURS; ++q) {
            int k;
            v[q] = factors[SKYLIGHT_SH_7_BANDS_1_5PCT_FACTOR(channel,
                0)] * skylight_sh_7_bands_1_5pct_load_four(sums[0] + 4 * q);
            for (k = 1; k < SKYLIGHT_SH_7_BANDS_1_5PCT_CLASSES; ++k)
                v[q] = skylight_sh_7_bands_1_5pct_add_four(
                    skylight_sh_7_bands_1_5pct_spread_four(factors
                        [SKYLIGHT_SH_7_BANDS_1_5PCT_FACTOR(channel, k)]),
                    skylight_sh_7_bands_1_5pct_load_four(sums[k] + 4 * q), v[q]);
        }
#define SKYLIGHT_SH_7_BANDS_1_5PCT_BAND(l, stores) \
    if (bands > (l)) { stores }
#define SKYLIGHT_SH_7_BANDS_1_5PCT_NOTHING(place, count) memset(w + (place), 0, sizeof(float) * \
    (count));
#define SKYLIGHT_SH_7_BANDS_1_5PCT_MINUS(place, q, r, a, b, c, d, order) \
    skylight_sh_7_bands_1_5pct_keep(w + (place), \
                     SKYLIGHT_SH_7_BANDS_1_5PCT_PICK(v[q], v[r], a, b, c, d) * \
                         skylight_sh_7_bands_1_5pct_load_four(minus + \
                             SKYLIGHT_SH_7_BANDS_1_5PCT_BANDS - 1 - (order)));
#define SKYLIGHT_SH_7_BANDS_1_5PCT_PLUS(place, q, r, a, b, c, d, order) \
    skylight_sh_7_bands_1_5pct_keep(w + (place), SKYLIGHT_SH_7_BANDS_1_5PCT_PICK(v[q], v[r], a, b, \
        c, d) * \
                                      skylight_sh_7_bands_1_5pct_load_four(plus + (order)));
        SKYLIGHT_SH_7_BANDS_1_5PCT_STORES(SKYLIGHT_SH_7_BANDS_1_5PCT_BAND,
            SKYLIGHT_SH_7_BANDS_1_5PCT_NOTHING, SKYLIGHT_SH_7_BANDS_1_5PCT_MINUS,
                           SKYLIGHT_SH_7_BANDS_1_5PCT_PLUS)
#undef SKYLIGHT_SH_7_BANDS_1_5PCT_BAND
#undef SKYLIGHT_SH_7_BANDS_1_5PCT_NOTHING
#undef SKYLIGHT_SH_7_BANDS_1_5PCT_MINUS
#undef SKYLIGHT_SH_7_BANDS_1_5PCT_PLUS
    }
#else
    static const short columns[SKYLIGHT_SH_7_BANDS_1_5PCT_BANDS] =
        SKYLIGHT_SH_7_BANDS_1_5PCT_COLUMNS;
    for (channel = 0; channel < SKYLIGHT_SH_7_BANDS_1_5PCT_CHANNELS; ++channel) {
        skylight_sh_7_bands_1_5pct_real v[SKYLIGHT_SH_7_BANDS_1_5PCT_WIDTH];
        int l, m;
        skylight_sh_7_bands_1_5pct_mix(sums, channel, factors, v);
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

#ifdef SKYLIGHT_SH_7_BANDS_1_5PCT_LANES

/* Vectors that the first `count` numbers of a row take, and those that are summed at once, in
   registers. */
#define SKYLIGHT_SH_7_BANDS_1_5PCT_VECTORS(count) (((count) + SKYLIGHT_SH_7_BANDS_1_5PCT_LANES - \
    1) / SKYLIGHT_SH_7_BANDS_1_5PCT_LANES)
#define SKYLIGHT_SH_7_BANDS_1_5PCT_BLOCKS \
    ((SKYLIGHT_SH_7_BANDS_1_5PCT_VECTORS(SKYLIGHT_SH_7_BANDS_1_5PCT_WIDTH) + 6) / 7)
#define SKYLIGHT_SH_7_BANDS_1_5PCT_BLOCK \
    ((SKYLIGHT_SH_7_BANDS_1_5PCT_VECTORS(SKYLIGHT_SH_7_BANDS_1_5PCT_WIDTH) + \
        SKYLIGHT_SH_7_BANDS_1_5PCT_BLOCKS - 1) / SKYLIGHT_SH_7_BANDS_1_5PCT_BLOCKS)
/* What is done for each vector of a block: written out, since a compiler that keeps loops keeps
 * their
   vectors in memory. */
#define SKYLIGHT_SH_7_BANDS_1_5PCT_EACH(DO) DO(0) DO(1) DO(2) DO(3) DO(4) DO(5) DO(6) DO(7)
#endif
#ifdef SKYLIGHT_SH_7_BANDS_1_5PCT_LANES
/* All columns at once, as written: gcc would sum one after the other, each step waiting for the one
   before. */
#if defined(__GNUC__) && !defined(__clang__) && defined(__SSE__)
#define SKYLIGHT_SH_7_BANDS_1_5PCT_IN_ORDER(v) __asm__("" : "+x"(v));
#else
#define SKYLIGHT_SH_7_BANDS_1_5PCT_IN_ORDER(v)
#endif

/* One class's sums, for SKYLIGHT_SH_7_BANDS_1_5PCT_BLOCK vectors of each row: over the products of
 * the other axes'
   functions, each times a polynomial in powers of u, by Horner's scheme. */
SKYLIGHT_SH_7_BANDS_1_5PCT_INLINE void skylight_sh_7_bands_1_5pct_sum_block(const
    skylight_sh_7_bands_1_5pct_real *rows, int class_,
                                              skylight_sh_7_bands_1_5pct_real u,
                                                  const skylight_sh_7_bands_1_5pct_real *others,
                                              skylight_sh_7_bands_1_5pct_real *sums)
{
    const skylight_sh_7_bands_1_5pct_lanes power = skylight_sh_7_bands_1_5pct_spread(u);
    int i;
#define SKYLIGHT_SH_7_BANDS_1_5PCT_CLASS(which, polynomials) \
    if (class_ == (which)) { \
        skylight_sh_7_bands_1_5pct_lanes total[SKYLIGHT_SH_7_BANDS_1_5PCT_BLOCK]; \
        polynomials SKYLIGHT_SH_7_BANDS_1_5PCT_EACH(SKYLIGHT_SH_7_BANDS_1_5PCT_SUM) \
    }
#define SKYLIGHT_SH_7_BANDS_1_5PCT_SUM(k) \
    if ((k) < SKYLIGHT_SH_7_BANDS_1_5PCT_BLOCK) memcpy(sums + (k) * \
        SKYLIGHT_SH_7_BANDS_1_5PCT_LANES, &total[k], sizeof total[k]);
#define SKYLIGHT_SH_7_BANDS_1_5PCT_NOTHING \
    SKYLIGHT_SH_7_BANDS_1_5PCT_EACH(SKYLIGHT_SH_7_BANDS_1_5PCT_ZERO)
#define SKYLIGHT_SH_7_BANDS_1_5PCT_ZERO(k) \
    if ((k) < SKYLIGHT_SH_7_BANDS_1_5PCT_BLOCK) total[k] = skylight_sh_7_bands_1_5pct_spread(0);
#define SKYLIGHT_SH_7_BANDS_1_5PCT_POLYNOMIAL(start, count, other) \
    { \
        const skylight_sh_7_bands_1_5pct_real *term = rows + ((start) + (count) - 1) * \
            SKYLIGHT_SH_7_BANDS_1_5PCT_WIDTH; \
        const skylight_sh_7_bands_1_5pct_lanes factor = \
            skylight_sh_7_bands_1_5pct_spread(others[other]); \
        skylight_sh_7_bands_1_5pct_lanes sum[SKYLIGHT_SH_7_BANDS_1_5PCT_BLOCK]; \
        SKYLIGHT_SH_7_BANDS_1_5PCT_EACH(SKYLIGHT_SH_7_BANDS_1_5PCT_LAST) \
        for (i = 1; i < (count); ++i) { \
            term -= SKYLIGHT_SH_7_BANDS_1_5PCT_WIDTH; \
            SKYLIGHT_SH_7_BANDS_1_5PCT_EACH(SKYLIGHT_SH_7_BANDS_1_5PCT_STEP_DOWN) \
        } \
        SKYLIGHT_SH_7_BANDS_1_5PCT_EACH(SKYLIGHT_SH_7_BANDS_1_5PCT_TOTAL) \
    }
#define SKYLIGHT_SH_7_BANDS_1_5PCT_LAST(k) \
    if ((k) < SKYLIGHT_SH_7_BANDS_1_5PCT_BLOCK) sum[k] = skylight_sh_7_bands_1_5pct_load(term + \
        (k) * SKYLIGHT_SH_7_BANDS_1_5PCT_LANES);
#define SKYLIGHT_SH_7_BANDS_1_5PCT_STEP_DOWN(k) \
    if ((k) < SKYLIGHT_SH_7_BANDS_1_5PCT_BLOCK) { \
        skylight_sh_7_bands_1_5pct_lanes v = skylight_sh_7_bands_1_5pct_load(term + (k) * \
            SKYLIGHT_SH_7_BANDS_1_5PCT_LANES); \
        v = skylight_sh_7_bands_1_5pct_add(sum[k], power, v); \
        SKYLIGHT_SH_7_BANDS_1_5PCT_IN_ORDER(v) \
        sum[k] = v; \
    }
#define SKYLIGHT_SH_7_BANDS_1_5PCT_TOTAL(k) \
    if ((k) < SKYLIGHT_SH_7_BANDS_1_5PCT_BLOCK) total[k] = skylight_sh_7_bands_1_5pct_add(sum[k], \
        factor, total[k]);
    SKYLIGHT_SH_7_BANDS_1_5PCT_POLYNOMIALS(SKYLIGHT_SH_7_BANDS_1_5PCT_CLASS,
        SKYLIGHT_SH_7_BANDS_1_5PCT_NOTHING, SKYLIGHT_SH_7_BANDS_1_5PCT_POLYNOMIAL)
#undef SKYLIGHT_SH_7_BANDS_1_5PCT_CLASS
#undef SKYLIGHT_SH_7_BANDS_1_5PCT_NOTHING
#undef SKYLIGHT_SH_7_BANDS_1_5PCT_POLYNOMIAL
#undef SKYLIGHT_SH_7_BANDS_1_5PCT_SUM
#undef SKYLIGHT_SH_7_BANDS_1_5PCT_ZERO
#undef SKYLIGHT_SH_7_BANDS_1_5PCT_LAST
#undef SKYLIGHT_SH_7_BANDS_1_5PCT_STEP_DOWN
#undef SKYLIGHT_SH_7_BANDS_1_5PCT_TOTAL
}

/* One class's sums, for one vector of each row. */
static inline void skylight_sh_7_bands_1_5pct_sum_vector(const skylight_sh_7_bands_1_5pct_real *row,
    const unsigned char *lengths,
                                          skylight_sh_7_bands_1_5pct_real u,
                                              const skylight_sh_7_bands_1_5pct_real *others,
                                          skylight_sh_7_bands_1_5pct_real *sums)
{
    const skylight_sh_7_bands_1_5pct_lanes power = skylight_sh_7_bands_1_5pct_spread(u);
    skylight_sh_7_bands_1_5pct_lanes total = skylight_sh_7_bands_1_5pct_spread(0);
    int other;
    for (other = 0; other < SKYLIGHT_SH_7_BANDS_1_5PCT_OTHERS; ++other) {
        const int length = lengths[other];
        const skylight_sh_7_bands_1_5pct_real *term = row + (length - 1) *
            SKYLIGHT_SH_7_BANDS_1_5PCT_WIDTH;
        skylight_sh_7_bands_1_5pct_lanes sum;
        if (!length) continue;
        sum = skylight_sh_7_bands_1_5pct_load(term);
        while (term != row) {
            term -= SKYLIGHT_SH_7_BANDS_1_5PCT_WIDTH;
            sum = skylight_sh_7_bands_1_5pct_add(sum, power, skylight_sh_7_bands_1_5pct_load(term));
        }
        total = skylight_sh_7_bands_1_5pct_add(sum,
            skylight_sh_7_bands_1_5pct_spread(others[other]), total);
        row += length * SKYLIGHT_SH_7_BANDS_1_5PCT_WIDTH;
    }
    memcpy(sums, &total, sizeof total);
}
#else

/* One class's sums, with plain numbers. */
static inline void skylight_sh_7_bands_1_5pct_sum(const skylight_sh_7_bands_1_5pct_real *row,
    const unsigned char *lengths,
                                   skylight_sh_7_bands_1_5pct_real u,
                                       const skylight_sh_7_bands_1_5pct_real *others, int count,
                                   skylight_sh_7_bands_1_5pct_real *sums)
{
    int other, i, k;
    for (k = 0; k < SKYLIGHT_SH_7_BANDS_1_5PCT_ROOM; ++k) sums[k] = 0;
    for (other = 0; other < SKYLIGHT_SH_7_BANDS_1_5PCT_OTHERS; ++other) {
        skylight_sh_7_bands_1_5pct_real product = others[other];
        for (i = 0; i < (int)lengths[other]; ++i) {
            for (k = 0; k < count; ++k) sums[k] += product * row[k];
            product *= u;
            row += SKYLIGHT_SH_7_BANDS_1_5PCT_WIDTH;
        }
    }
}
#endif

/* The sums of one class's rows, one a term, for the first `bands` bands. */
SKYLIGHT_SH_7_BANDS_1_5PCT_INLINE void skylight_sh_7_bands_1_5pct_sum_class(const
    skylight_sh_7_bands_1_5pct_real *rows, int class_,
                                              const skylight_sh_7_bands_1_5pct_real *first,
                                              const skylight_sh_7_bands_1_5pct_real *others,
                                                  int bands,
                                              skylight_sh_7_bands_1_5pct_real *sums)
{
    static const unsigned short starts[SKYLIGHT_SH_7_BANDS_1_5PCT_CLASSES] =
        SKYLIGHT_SH_7_BANDS_1_5PCT_STARTS;
    static const unsigned char
        lengths[SKYLIGHT_SH_7_BANDS_1_5PCT_CLASSES][SKYLIGHT_SH_7_BANDS_1_5PCT_OTHERS] =
        SKYLIGHT_SH_7_BANDS_1_5PCT_LENGTHS;
    static const unsigned short widths[SKYLIGHT_SH_7_BANDS_1_5PCT_BANDS] =
        SKYLIGHT_SH_7_BANDS_1_5PCT_WIDTHS;
    const skylight_sh_7_bands_1_5pct_real *const row = rows + (int)starts[class_] *
        SKYLIGHT_SH_7_BANDS_1_5PCT_WIDTH;
#ifdef SKYLIGHT_SH_7_BANDS_1_5PCT_LANES
    int i;
    if (bands == SKYLIGHT_SH_7_BANDS_1_5PCT_BANDS) {
        for (i = 0; i < SKYLIGHT_SH_7_BANDS_1_5PCT_BLOCKS; ++i) {
            /* The last block may overlap the one before. */
            const int at = i + 1 < SKYLIGHT_SH_7_BANDS_1_5PCT_BLOCKS
                               ? i * SKYLIGHT_SH_7_BANDS_1_5PCT_BLOCK
                               : SKYLIGHT_SH_7_BANDS_1_5PCT_VECTORS(
                                   SKYLIGHT_SH_7_BANDS_1_5PCT_WIDTH) -
                                   SKYLIGHT_SH_7_BANDS_1_5PCT_BLOCK;
            skylight_sh_7_bands_1_5pct_sum_block(rows + at * SKYLIGHT_SH_7_BANDS_1_5PCT_LANES,
                class_, first[1], others,
                                  sums + at * SKYLIGHT_SH_7_BANDS_1_5PCT_LANES);
        }
        return;
    }
    memset(sums, 0, sizeof *sums * SKYLIGHT_SH_7_BANDS_1_5PCT_ROOM);
    for (i = 0; i < SKYLIGHT_SH_7_BANDS_1_5PCT_VECTORS(widths[bands - 1]); ++i)
        skylight_sh_7_bands_1_5pct_sum_vector(row + i * SKYLIGHT_SH_7_BANDS_1_5PCT_LANES,
            lengths[class_], first[1], others,
                               sums + i * SKYLIGHT_SH_7_BANDS_1_5PCT_LANES);
#else
    skylight_sh_7_bands_1_5pct_sum(row, lengths[class_], first[1], others, widths[bands - 1], sums);
#endif
}

/* The same in double precision, all bands: what derivatives need, whose terms cancel. */
static inline void skylight_sh_7_bands_1_5pct_sum_rows_double(
    const skylight_sh_7_bands_1_5pct_real *rows, const double *first, const double *others,
    double sums[SKYLIGHT_SH_7_BANDS_1_5PCT_CLASSES][SKYLIGHT_SH_7_BANDS_1_5PCT_WIDTH])
{
    static const unsigned char
        lengths[SKYLIGHT_SH_7_BANDS_1_5PCT_CLASSES][SKYLIGHT_SH_7_BANDS_1_5PCT_OTHERS] =
        SKYLIGHT_SH_7_BANDS_1_5PCT_LENGTHS;
    int c, i, k, other;
    for (c = 0; c < SKYLIGHT_SH_7_BANDS_1_5PCT_CLASSES; ++c) {
        for (k = 0; k < SKYLIGHT_SH_7_BANDS_1_5PCT_WIDTH; ++k) sums[c][k] = 0.0;
        for (other = 0; other < SKYLIGHT_SH_7_BANDS_1_5PCT_OTHERS; ++other) {
            for (i = 0; i < (int)lengths[c][other]; ++i) {
                const double product = first[i] * others[other];
                for (k = 0; k < SKYLIGHT_SH_7_BANDS_1_5PCT_WIDTH; ++k) sums[c][k] += product *
                    (double)rows[k];
                rows += SKYLIGHT_SH_7_BANDS_1_5PCT_WIDTH;
            }
        }
    }
}

/* What becomes of the first `bands` bands once they are stored. */
static inline void skylight_sh_7_bands_1_5pct_finish(int bands, int lights,
                                      float
                                          weights[SKYLIGHT_SH_7_BANDS_1_5PCT_CHANNELS]
                                          [SKYLIGHT_SH_7_BANDS_1_5PCT_WEIGHTS])
{
    (void)bands;
    (void)lights;
    (void)weights;
}

/* Evaluates the first `bands` bands (1 to SKYLIGHT_SH_7_BANDS_1_5PCT_BANDS, clamped like an input)
 * and zeroes the
   rest; returns the status. `rows` are the table's; those of a packed table may be missing. */
static inline int skylight_sh_7_bands_1_5pct_evaluate(const skylight_sh_7_bands_1_5pct_real *rows,
                                       const float inputs[SKYLIGHT_SH_7_BANDS_1_5PCT_AXES],
                                           float azimuth,
                                       int bands,
                                       float
                                           weights[SKYLIGHT_SH_7_BANDS_1_5PCT_CHANNELS]
                                           [SKYLIGHT_SH_7_BANDS_1_5PCT_WEIGHTS])
{
    skylight_sh_7_bands_1_5pct_real x[SKYLIGHT_SH_7_BANDS_1_5PCT_AXES],
        first[SKYLIGHT_SH_7_BANDS_1_5PCT_FIRST], others[SKYLIGHT_SH_7_BANDS_1_5PCT_OTHERS];
    skylight_sh_7_bands_1_5pct_real cosines[SKYLIGHT_SH_7_BANDS_1_5PCT_BANDS],
        sines[SKYLIGHT_SH_7_BANDS_1_5PCT_BANDS];
    skylight_sh_7_bands_1_5pct_real
        sums[SKYLIGHT_SH_7_BANDS_1_5PCT_CLASSES][SKYLIGHT_SH_7_BANDS_1_5PCT_ROOM];
    skylight_sh_7_bands_1_5pct_real factors[SKYLIGHT_SH_7_BANDS_1_5PCT_FACTORS];
    skylight_sh_7_bands_1_5pct_real light = SKYLIGHT_SH_7_BANDS_1_5PCT_EXPOSURE, radius = 1, cosine,
        sine;
    int i, all, status = skylight_sh_7_bands_1_5pct_inputs(inputs, azimuth, x);
    if (status == 2) {
        memset(weights, 0, sizeof(float) * SKYLIGHT_SH_7_BANDS_1_5PCT_CHANNELS *
            SKYLIGHT_SH_7_BANDS_1_5PCT_WEIGHTS);
        return 2;
    }
    if (bands < 1 || bands > SKYLIGHT_SH_7_BANDS_1_5PCT_BANDS) {
        bands = bands < 1 ? 1 : SKYLIGHT_SH_7_BANDS_1_5PCT_BANDS;
        status = 1;
    }
    skylight_sh_7_bands_1_5pct_circle((skylight_sh_7_bands_1_5pct_real)azimuth, &cosine, &sine);
    radius = skylight_sh_7_bands_1_5pct_sine(x);
    skylight_sh_7_bands_1_5pct_waves(cosine, sine, radius, cosines, sines);
    skylight_sh_7_bands_1_5pct_first(x, first);
    skylight_sh_7_bands_1_5pct_others(x, others);
    skylight_sh_7_bands_1_5pct_factors(x, factors);
    for (i = 0; i < SKYLIGHT_SH_7_BANDS_1_5PCT_FACTORS; ++i) factors[i] *= light;
    all = bands;
    {
#define SKYLIGHT_SH_7_BANDS_1_5PCT_CLASS(k) skylight_sh_7_bands_1_5pct_sum_class(rows, k, first, \
    others, all, sums[k]);
        SKYLIGHT_SH_7_BANDS_1_5PCT_ALL_CLASSES(SKYLIGHT_SH_7_BANDS_1_5PCT_CLASS)
#undef SKYLIGHT_SH_7_BANDS_1_5PCT_CLASS
    }
    skylight_sh_7_bands_1_5pct_store(sums, factors, cosines, sines, all, weights);
    skylight_sh_7_bands_1_5pct_finish(bands, 1, weights);
    if (bands < SKYLIGHT_SH_7_BANDS_1_5PCT_BANDS) {
        int channel;
        for (channel = 0; channel < SKYLIGHT_SH_7_BANDS_1_5PCT_CHANNELS; ++channel)
            for (i = bands * bands; i < SKYLIGHT_SH_7_BANDS_1_5PCT_WEIGHTS; ++i) weights[channel][i]
                = 0.0f;
    }
    return status;
}

/* One of many suns by itself. */
static inline int skylight_sh_7_bands_1_5pct_evaluate_one(const skylight_sh_7_bands_1_5pct_real
    *rows,
                                           const float *const
                                               inputs[SKYLIGHT_SH_7_BANDS_1_5PCT_AXES],
                                           const float *azimuths, int sun,
                                           float
                                               weights[SKYLIGHT_SH_7_BANDS_1_5PCT_CHANNELS]
                                               [SKYLIGHT_SH_7_BANDS_1_5PCT_WEIGHTS])
{
    float given[SKYLIGHT_SH_7_BANDS_1_5PCT_AXES];
    int axis;
    for (axis = 0; axis < SKYLIGHT_SH_7_BANDS_1_5PCT_AXES; ++axis) given[axis] = inputs[axis][sun];
    return skylight_sh_7_bands_1_5pct_evaluate(rows, given,
        azimuths ? azimuths[sun] : SKYLIGHT_SH_7_BANDS_1_5PCT_AZIMUTH,
                                SKYLIGHT_SH_7_BANDS_1_5PCT_BANDS, weights);
}
#ifdef SKYLIGHT_SH_7_BANDS_1_5PCT_LANES
/* Suns that are evaluated side by side, and the vectors that they take. */
#define SKYLIGHT_SH_7_BANDS_1_5PCT_SUNS 16
#define SKYLIGHT_SH_7_BANDS_1_5PCT_GROUPS (SKYLIGHT_SH_7_BANDS_1_5PCT_SUNS / \
    SKYLIGHT_SH_7_BANDS_1_5PCT_LANES)

/* Cosines and sines of angles side by side, as skylight_sh_7_bands_1_5pct_circle has them. */
static inline void skylight_sh_7_bands_1_5pct_circle_suns(const float *angles, float *cosines,
    float *sines)
{
    float rest[SKYLIGHT_SH_7_BANDS_1_5PCT_LANES];
    uint32_t bits[2][SKYLIGHT_SH_7_BANDS_1_5PCT_LANES], quarter[SKYLIGHT_SH_7_BANDS_1_5PCT_LANES];
    skylight_sh_7_bands_1_5pct_lanes out[2];
    int s, far = 0;
    for (s = 0; s < SKYLIGHT_SH_7_BANDS_1_5PCT_LANES; ++s) far |= !(angles[s] > -1e5f && angles[s] <
        1e5f);
    if (far) {
        for (s = 0; s < SKYLIGHT_SH_7_BANDS_1_5PCT_LANES; ++s)
            skylight_sh_7_bands_1_5pct_circle(angles[s], cosines + s, sines + s);
        return;
    }
    for (s = 0; s < SKYLIGHT_SH_7_BANDS_1_5PCT_LANES; ++s) {
        const int quarters = (int)(angles[s] * 0.636619772f + copysignf(0.5f, angles[s]));
        rest[s] = (float)((double)angles[s] - (double)quarters * 1.5707963267948966);
        quarter[s] = (uint32_t)quarters;
    }
    skylight_sh_7_bands_1_5pct_quarter_suns(skylight_sh_7_bands_1_5pct_load(rest), out);
    memcpy(bits, out, sizeof bits);
    for (s = 0; s < SKYLIGHT_SH_7_BANDS_1_5PCT_LANES; ++s) {
        const uint32_t swapped = (bits[0][s] ^ bits[1][s]) & (0u - (quarter[s] & 1u));
        bits[0][s] ^= swapped ^ (((quarter[s] + 1u) & 2u) << 30);
        bits[1][s] ^= swapped ^ ((quarter[s] & 2u) << 30);
    }
    memcpy(cosines, bits[0], sizeof bits[0]);
    memcpy(sines, bits[1], sizeof bits[1]);
}

/* Reads SKYLIGHT_SH_7_BANDS_1_5PCT_SUNS suns from `start` on: clamped inputs, azimuths, what light
 * each leaves.
   Returns the largest status; a sun of status 2 has no light. */
static inline int skylight_sh_7_bands_1_5pct_inputs_suns(const float *const
    inputs[SKYLIGHT_SH_7_BANDS_1_5PCT_AXES],
                                          const float *azimuths, int start,
                                          float
                                              x[SKYLIGHT_SH_7_BANDS_1_5PCT_AXES]
                                              [SKYLIGHT_SH_7_BANDS_1_5PCT_SUNS],
                                          float *azimuth, float *light)
{
    int axis, s, status = 0, strange = 0;
    for (s = 0; s < SKYLIGHT_SH_7_BANDS_1_5PCT_SUNS; ++s) {
        azimuth[s] = azimuths ? azimuths[start + s] : SKYLIGHT_SH_7_BANDS_1_5PCT_AZIMUTH;
        light[s] = SKYLIGHT_SH_7_BANDS_1_5PCT_EXPOSURE;
        strange |= skylight_sh_7_bands_1_5pct_kind(azimuth[s]);
    }
    for (axis = 0; axis < SKYLIGHT_SH_7_BANDS_1_5PCT_AXES; ++axis) {
        const float low = skylight_sh_7_bands_1_5pct_range[axis][0],
            high = skylight_sh_7_bands_1_5pct_range[axis][1];
        for (s = 0; s < SKYLIGHT_SH_7_BANDS_1_5PCT_SUNS; ++s) {
            const float v = inputs[axis][start + s], at_least = v < low ? low : v;
            strange |= skylight_sh_7_bands_1_5pct_kind(v);
            status |= (v < skylight_sh_7_bands_1_5pct_inside[axis][0]) | (v >
                skylight_sh_7_bands_1_5pct_inside[axis][1]);
            x[axis][s] = at_least > high ? high : at_least;
        }
    }
    if (strange) {
        for (s = 0; s < SKYLIGHT_SH_7_BANDS_1_5PCT_SUNS; ++s) {
            float given[SKYLIGHT_SH_7_BANDS_1_5PCT_AXES], clamped[SKYLIGHT_SH_7_BANDS_1_5PCT_AXES];
            int found;
            for (axis = 0; axis < SKYLIGHT_SH_7_BANDS_1_5PCT_AXES; ++axis) given[axis] =
                inputs[axis][start + s];
            found = skylight_sh_7_bands_1_5pct_inputs(given, azimuth[s], clamped);
            if (found == 2) light[s] = azimuth[s] = 0.0f;
            for (axis = 0; axis < SKYLIGHT_SH_7_BANDS_1_5PCT_AXES; ++axis)
                x[axis][s] = found == 2 ? skylight_sh_7_bands_1_5pct_range[axis][0] : clamped[axis];
            status = found > status ? found : status;
        }
    }
    return status;
}

/* The sums of suns side by side: of each class and number of a row, over the products of the other
   axes' functions, each times a polynomial in powers of u. */
static inline void skylight_sh_7_bands_1_5pct_sum_suns(
    const skylight_sh_7_bands_1_5pct_real *rows,
        const skylight_sh_7_bands_1_5pct_lanes u[SKYLIGHT_SH_7_BANDS_1_5PCT_GROUPS],
    skylight_sh_7_bands_1_5pct_lanes
        others[SKYLIGHT_SH_7_BANDS_1_5PCT_GROUPS][SKYLIGHT_SH_7_BANDS_1_5PCT_OTHERS],
    skylight_sh_7_bands_1_5pct_lanes
        sums[SKYLIGHT_SH_7_BANDS_1_5PCT_CLASSES][SKYLIGHT_SH_7_BANDS_1_5PCT_WIDTH]
        [SKYLIGHT_SH_7_BANDS_1_5PCT_GROUPS])
{
    int i, t;
    for (i = 0; i < SKYLIGHT_SH_7_BANDS_1_5PCT_WIDTH; ++i) {
#define SKYLIGHT_SH_7_BANDS_1_5PCT_CLASS(which, polynomials) \
    { \
        const int which_class = (which); \
        skylight_sh_7_bands_1_5pct_lanes total[SKYLIGHT_SH_7_BANDS_1_5PCT_GROUPS]; \
        polynomials SKYLIGHT_SH_7_BANDS_1_5PCT_EACH(SKYLIGHT_SH_7_BANDS_1_5PCT_SUM) \
    }
#define SKYLIGHT_SH_7_BANDS_1_5PCT_SUM(g) \
    if ((g) < SKYLIGHT_SH_7_BANDS_1_5PCT_GROUPS) sums[which_class][i][g] = total[g];
#define SKYLIGHT_SH_7_BANDS_1_5PCT_NOTHING \
    SKYLIGHT_SH_7_BANDS_1_5PCT_EACH(SKYLIGHT_SH_7_BANDS_1_5PCT_ZERO)
#define SKYLIGHT_SH_7_BANDS_1_5PCT_ZERO(g) \
    if ((g) < SKYLIGHT_SH_7_BANDS_1_5PCT_GROUPS) total[g] = skylight_sh_7_bands_1_5pct_spread(0);
#define SKYLIGHT_SH_7_BANDS_1_5PCT_POLYNOMIAL(begin, count, other) \
    { \
        const float *term = rows + ((begin) + (count) - 1) * SKYLIGHT_SH_7_BANDS_1_5PCT_WIDTH + i; \
        skylight_sh_7_bands_1_5pct_lanes sum[SKYLIGHT_SH_7_BANDS_1_5PCT_GROUPS], number = \
            skylight_sh_7_bands_1_5pct_spread(*term); \
        SKYLIGHT_SH_7_BANDS_1_5PCT_EACH(SKYLIGHT_SH_7_BANDS_1_5PCT_LAST) \
        for (t = 1; t < (count); ++t) { \
            term -= SKYLIGHT_SH_7_BANDS_1_5PCT_WIDTH; \
            number = skylight_sh_7_bands_1_5pct_spread(*term); \
            SKYLIGHT_SH_7_BANDS_1_5PCT_EACH(SKYLIGHT_SH_7_BANDS_1_5PCT_STEP_DOWN) \
        } \
        { \
            const int which_other = (other); \
            SKYLIGHT_SH_7_BANDS_1_5PCT_EACH(SKYLIGHT_SH_7_BANDS_1_5PCT_TOTAL) \
        } \
    }
#define SKYLIGHT_SH_7_BANDS_1_5PCT_LAST(g) \
    if ((g) < SKYLIGHT_SH_7_BANDS_1_5PCT_GROUPS) sum[g] = number;
#define SKYLIGHT_SH_7_BANDS_1_5PCT_STEP_DOWN(g) \
    if ((g) < SKYLIGHT_SH_7_BANDS_1_5PCT_GROUPS) { \
        skylight_sh_7_bands_1_5pct_lanes v = skylight_sh_7_bands_1_5pct_add(sum[g], u[g], number); \
        SKYLIGHT_SH_7_BANDS_1_5PCT_IN_ORDER(v) \
        sum[g] = v; \
    }
#define SKYLIGHT_SH_7_BANDS_1_5PCT_TOTAL(g) \
    if ((g) < SKYLIGHT_SH_7_BANDS_1_5PCT_GROUPS) total[g] = skylight_sh_7_bands_1_5pct_add(sum[g], \
        others[g][which_other], total[g]);
        SKYLIGHT_SH_7_BANDS_1_5PCT_POLYNOMIALS(SKYLIGHT_SH_7_BANDS_1_5PCT_CLASS,
            SKYLIGHT_SH_7_BANDS_1_5PCT_NOTHING, SKYLIGHT_SH_7_BANDS_1_5PCT_POLYNOMIAL)
#undef SKYLIGHT_SH_7_BANDS_1_5PCT_CLASS
#undef SKYLIGHT_SH_7_BANDS_1_5PCT_NOTHING
#undef SKYLIGHT_SH_7_BANDS_1_5PCT_POLYNOMIAL
#undef SKYLIGHT_SH_7_BANDS_1_5PCT_SUM
#undef SKYLIGHT_SH_7_BANDS_1_5PCT_ZERO
#undef SKYLIGHT_SH_7_BANDS_1_5PCT_LAST
#undef SKYLIGHT_SH_7_BANDS_1_5PCT_STEP_DOWN
#undef SKYLIGHT_SH_7_BANDS_1_5PCT_TOTAL
    }
}

/* Whether all suns share the other axes: a day in one weather. */
static inline int skylight_sh_7_bands_1_5pct_share(const float *const
    inputs[SKYLIGHT_SH_7_BANDS_1_5PCT_AXES], int count)
{
    int axis, s, differ = 0;
    for (axis = 1; axis < SKYLIGHT_SH_7_BANDS_1_5PCT_AXES; ++axis)
        for (s = 1; s < count && !differ; ++s)
            differ = memcmp(inputs[axis] + s, inputs[axis], sizeof(float)) != 0;
    return !differ;
}

/* Sums the rows over the other axes' functions at the first sun once for all: of each class a row
 * for
   each power of u. */
static inline void skylight_sh_7_bands_1_5pct_sum_shared(const skylight_sh_7_bands_1_5pct_real
    *rows,
                                          const float *const
                                              inputs[SKYLIGHT_SH_7_BANDS_1_5PCT_AXES],
                                          float
                                              shared[SKYLIGHT_SH_7_BANDS_1_5PCT_SHARED]
                                              [SKYLIGHT_SH_7_BANDS_1_5PCT_WIDTH])
{
    static const unsigned short before[SKYLIGHT_SH_7_BANDS_1_5PCT_CLASSES] =
        SKYLIGHT_SH_7_BANDS_1_5PCT_BEFORE;
    float given[SKYLIGHT_SH_7_BANDS_1_5PCT_AXES], x[SKYLIGHT_SH_7_BANDS_1_5PCT_AXES],
        others[SKYLIGHT_SH_7_BANDS_1_5PCT_OTHERS];
    int axis, i, t;
    for (axis = 0; axis < SKYLIGHT_SH_7_BANDS_1_5PCT_AXES; ++axis) given[axis] = inputs[axis][0];
    for (t = 0; t < SKYLIGHT_SH_7_BANDS_1_5PCT_SHARED; ++t)
        for (i = 0; i < SKYLIGHT_SH_7_BANDS_1_5PCT_WIDTH; ++i) shared[t][i] = 0.0f;
    /* The first axis is another matter: it is inside. */
    given[0] = skylight_sh_7_bands_1_5pct_range[0][0];
    if (skylight_sh_7_bands_1_5pct_inputs(given, 0.0f, x) == 2) return;
    skylight_sh_7_bands_1_5pct_others(x, others);
#define SKYLIGHT_SH_7_BANDS_1_5PCT_CLASS(which, polynomials) \
    { \
        const int place = before[which]; \
        (void)place; \
        polynomials \
    }
#define SKYLIGHT_SH_7_BANDS_1_5PCT_NOTHING
#define SKYLIGHT_SH_7_BANDS_1_5PCT_POLYNOMIAL(begin, count, other) \
    for (t = 0; t < (count); ++t) \
        for (i = 0; i < SKYLIGHT_SH_7_BANDS_1_5PCT_WIDTH; ++i) \
            shared[place + t][i] += others[other] * rows[((begin) + t) * \
                SKYLIGHT_SH_7_BANDS_1_5PCT_WIDTH + i];
    SKYLIGHT_SH_7_BANDS_1_5PCT_POLYNOMIALS(SKYLIGHT_SH_7_BANDS_1_5PCT_CLASS,
        SKYLIGHT_SH_7_BANDS_1_5PCT_NOTHING, SKYLIGHT_SH_7_BANDS_1_5PCT_POLYNOMIAL)
#undef SKYLIGHT_SH_7_BANDS_1_5PCT_CLASS
#undef SKYLIGHT_SH_7_BANDS_1_5PCT_NOTHING
#undef SKYLIGHT_SH_7_BANDS_1_5PCT_POLYNOMIAL
}

/* The sums of suns side by side that share the other axes: polynomials in powers of u alone. */
static inline void skylight_sh_7_bands_1_5pct_sum_sharing(
    float shared[SKYLIGHT_SH_7_BANDS_1_5PCT_SHARED][SKYLIGHT_SH_7_BANDS_1_5PCT_WIDTH],
        const skylight_sh_7_bands_1_5pct_lanes u[SKYLIGHT_SH_7_BANDS_1_5PCT_GROUPS],
    skylight_sh_7_bands_1_5pct_lanes
        sums[SKYLIGHT_SH_7_BANDS_1_5PCT_CLASSES][SKYLIGHT_SH_7_BANDS_1_5PCT_WIDTH]
        [SKYLIGHT_SH_7_BANDS_1_5PCT_GROUPS])
{
    static const unsigned char longest[SKYLIGHT_SH_7_BANDS_1_5PCT_CLASSES] =
        SKYLIGHT_SH_7_BANDS_1_5PCT_LONGEST;
    int c, i, t, row = 0;
    for (c = 0; c < SKYLIGHT_SH_7_BANDS_1_5PCT_CLASSES; ++c) {
        const int last = row + longest[c] - 1;
        for (i = 0; i < SKYLIGHT_SH_7_BANDS_1_5PCT_WIDTH; ++i) {
            skylight_sh_7_bands_1_5pct_lanes sum[SKYLIGHT_SH_7_BANDS_1_5PCT_GROUPS];
            skylight_sh_7_bands_1_5pct_lanes number = skylight_sh_7_bands_1_5pct_spread(last < row ?
                0.0f : shared[last][i]);
#define SKYLIGHT_SH_7_BANDS_1_5PCT_LAST(g) \
    if ((g) < SKYLIGHT_SH_7_BANDS_1_5PCT_GROUPS) sum[g] = number;
#define SKYLIGHT_SH_7_BANDS_1_5PCT_STEP_DOWN(g) \
    if ((g) < SKYLIGHT_SH_7_BANDS_1_5PCT_GROUPS) sum[g] = skylight_sh_7_bands_1_5pct_add(sum[g], \
        u[g], number);
#define SKYLIGHT_SH_7_BANDS_1_5PCT_SUM(g) \
    if ((g) < SKYLIGHT_SH_7_BANDS_1_5PCT_GROUPS) sums[c][i][g] = sum[g];
            SKYLIGHT_SH_7_BANDS_1_5PCT_EACH(SKYLIGHT_SH_7_BANDS_1_5PCT_LAST)
            for (t = last - 1; t >= row; --t) {
                number = skylight_sh_7_bands_1_5pct_spread(shared[t][i]);
                SKYLIGHT_SH_7_BANDS_1_5PCT_EACH(SKYLIGHT_SH_7_BANDS_1_5PCT_STEP_DOWN)
            }
            SKYLIGHT_SH_7_BANDS_1_5PCT_EACH(SKYLIGHT_SH_7_BANDS_1_5PCT_SUM)
#undef SKYLIGHT_SH_7_BANDS_1_5PCT_LAST
#undef SKYLIGHT_SH_7_BANDS_1_5PCT_STEP_DOWN
#undef SKYLIGHT_SH_7_BANDS_1_5PCT_SUM
        }
        row = last + 1;
    }
}

/* The weights of SKYLIGHT_SH_7_BANDS_1_5PCT_SUNS suns from `start` on, a row a weight, rows `step`
 * apart; returns the
   largest status. `shared` are the sums over the other axes where all suns share them,
       or nothing. */
static inline int skylight_sh_7_bands_1_5pct_evaluate_suns(const skylight_sh_7_bands_1_5pct_real
    *rows,
                                            const float *const
                                                inputs[SKYLIGHT_SH_7_BANDS_1_5PCT_AXES],
                                            const float *azimuths, int start,
                                            float (*shared)[SKYLIGHT_SH_7_BANDS_1_5PCT_WIDTH],
                                                float *out,
                                            size_t step)
{
    static const short columns[SKYLIGHT_SH_7_BANDS_1_5PCT_BANDS] =
        SKYLIGHT_SH_7_BANDS_1_5PCT_COLUMNS;
    float given[SKYLIGHT_SH_7_BANDS_1_5PCT_AXES][SKYLIGHT_SH_7_BANDS_1_5PCT_SUNS],
        azimuth[SKYLIGHT_SH_7_BANDS_1_5PCT_SUNS];
    float light[SKYLIGHT_SH_7_BANDS_1_5PCT_SUNS], cosine[SKYLIGHT_SH_7_BANDS_1_5PCT_SUNS],
        sine[SKYLIGHT_SH_7_BANDS_1_5PCT_SUNS];
    skylight_sh_7_bands_1_5pct_lanes u[SKYLIGHT_SH_7_BANDS_1_5PCT_GROUPS],
        others[SKYLIGHT_SH_7_BANDS_1_5PCT_GROUPS][SKYLIGHT_SH_7_BANDS_1_5PCT_OTHERS];
    skylight_sh_7_bands_1_5pct_lanes
        factors[SKYLIGHT_SH_7_BANDS_1_5PCT_GROUPS][SKYLIGHT_SH_7_BANDS_1_5PCT_FACTORS];
    skylight_sh_7_bands_1_5pct_lanes
        cosines[SKYLIGHT_SH_7_BANDS_1_5PCT_GROUPS][SKYLIGHT_SH_7_BANDS_1_5PCT_BANDS];
    skylight_sh_7_bands_1_5pct_lanes
        sines[SKYLIGHT_SH_7_BANDS_1_5PCT_GROUPS][SKYLIGHT_SH_7_BANDS_1_5PCT_BANDS];
    skylight_sh_7_bands_1_5pct_lanes
        sums[SKYLIGHT_SH_7_BANDS_1_5PCT_CLASSES][SKYLIGHT_SH_7_BANDS_1_5PCT_WIDTH]
        [SKYLIGHT_SH_7_BANDS_1_5PCT_GROUPS];
    const int status = skylight_sh_7_bands_1_5pct_inputs_suns(inputs, azimuths, start, given,
        azimuth, light);
    int g, i, k, l, m, channel;
    for (g = 0; g < SKYLIGHT_SH_7_BANDS_1_5PCT_GROUPS; ++g) {
        const int at = g * SKYLIGHT_SH_7_BANDS_1_5PCT_LANES;
        skylight_sh_7_bands_1_5pct_lanes x[SKYLIGHT_SH_7_BANDS_1_5PCT_AXES],
            first[SKYLIGHT_SH_7_BANDS_1_5PCT_FIRST];
        skylight_sh_7_bands_1_5pct_lanes radius = skylight_sh_7_bands_1_5pct_spread(1);
        for (i = 0; i < SKYLIGHT_SH_7_BANDS_1_5PCT_AXES; ++i) x[i] =
            skylight_sh_7_bands_1_5pct_load(given[i] + at);
        skylight_sh_7_bands_1_5pct_circle_suns(azimuth + at, cosine + at, sine + at);
        radius = skylight_sh_7_bands_1_5pct_sine_suns(x);
        skylight_sh_7_bands_1_5pct_waves_suns(skylight_sh_7_bands_1_5pct_load(cosine + at),
            skylight_sh_7_bands_1_5pct_load(sine + at), radius,
                               cosines[g], sines[g]);
        skylight_sh_7_bands_1_5pct_first_suns(x, first);
        u[g] = first[1];
        skylight_sh_7_bands_1_5pct_others_suns(x, others[g]);
        skylight_sh_7_bands_1_5pct_factors_suns(x, factors[g]);
        for (i = 0; i < SKYLIGHT_SH_7_BANDS_1_5PCT_FACTORS; ++i) factors[g][i] *=
            skylight_sh_7_bands_1_5pct_load(light + at);
    }
    if (shared)
        skylight_sh_7_bands_1_5pct_sum_sharing(shared, u, sums);
    else
        skylight_sh_7_bands_1_5pct_sum_suns(rows, u, others, sums);
    for (channel = 0; channel < SKYLIGHT_SH_7_BANDS_1_5PCT_CHANNELS; ++channel) {
        for (l = 0; l < SKYLIGHT_SH_7_BANDS_1_5PCT_BANDS; ++l) {
            float *const w = out + (size_t)(channel * SKYLIGHT_SH_7_BANDS_1_5PCT_WEIGHTS + l * (l +
                1)) * step;
            for (m = 0; m <= l; ++m) {
                for (g = 0; g < SKYLIGHT_SH_7_BANDS_1_5PCT_GROUPS; ++g) {
                    skylight_sh_7_bands_1_5pct_lanes v = skylight_sh_7_bands_1_5pct_spread(0),
                        turned;
                    if (columns[l] >= 0) {
                        for (k = 0; k < SKYLIGHT_SH_7_BANDS_1_5PCT_CLASSES; ++k)
                            v = skylight_sh_7_bands_1_5pct_add(factors[g]
                                [SKYLIGHT_SH_7_BANDS_1_5PCT_FACTOR(channel, k)],
                                                sums[k][columns[l] + m][g], v);
                    }
                    turned = v * sines[g][m];
                    memcpy(w - (size_t)m * step + g * SKYLIGHT_SH_7_BANDS_1_5PCT_LANES, &turned,
                        sizeof turned);
                    turned = v * cosines[g][m];
                    memcpy(w + (size_t)m * step + g * SKYLIGHT_SH_7_BANDS_1_5PCT_LANES, &turned,
                        sizeof turned);
                }
            }
        }
    }
    (void)k;
    return status;
}

/* Four rows of four numbers to columns, `step` apart. */
static inline void skylight_sh_7_bands_1_5pct_transpose(const float *from, size_t step, float *to,
    size_t between)
{
    const skylight_sh_7_bands_1_5pct_four a = skylight_sh_7_bands_1_5pct_load_four(from),
        b = skylight_sh_7_bands_1_5pct_load_four(from + step);
    const skylight_sh_7_bands_1_5pct_four c = skylight_sh_7_bands_1_5pct_load_four(from + 2 * step);
    const skylight_sh_7_bands_1_5pct_four d = skylight_sh_7_bands_1_5pct_load_four(from + 3 * step);
    const skylight_sh_7_bands_1_5pct_four ab = SKYLIGHT_SH_7_BANDS_1_5PCT_PICK(a, b, 0, 4, 1, 5);
    const skylight_sh_7_bands_1_5pct_four cd = SKYLIGHT_SH_7_BANDS_1_5PCT_PICK(c, d, 0, 4, 1, 5);
    const skylight_sh_7_bands_1_5pct_four ab_2 = SKYLIGHT_SH_7_BANDS_1_5PCT_PICK(a, b, 2, 6, 3, 7);
    const skylight_sh_7_bands_1_5pct_four cd_2 = SKYLIGHT_SH_7_BANDS_1_5PCT_PICK(c, d, 2, 6, 3, 7);
    skylight_sh_7_bands_1_5pct_keep(to, SKYLIGHT_SH_7_BANDS_1_5PCT_PICK(ab, cd, 0, 1, 4, 5));
    skylight_sh_7_bands_1_5pct_keep(to + between, SKYLIGHT_SH_7_BANDS_1_5PCT_PICK(ab, cd, 2, 3, 6,
        7));
    skylight_sh_7_bands_1_5pct_keep(to + 2 * between, SKYLIGHT_SH_7_BANDS_1_5PCT_PICK(ab_2, cd_2, 0,
        1, 4, 5));
    skylight_sh_7_bands_1_5pct_keep(to + 3 * between, SKYLIGHT_SH_7_BANDS_1_5PCT_PICK(ab_2, cd_2, 2,
        3, 6, 7));
}
#endif

/* Numbers of one sun's weights. */
#define SKYLIGHT_SH_7_BANDS_1_5PCT_NUMBERS (SKYLIGHT_SH_7_BANDS_1_5PCT_CHANNELS * \
    SKYLIGHT_SH_7_BANDS_1_5PCT_WEIGHTS)

/* Evaluates `count` suns from arrays, one an axis, and one of azimuths (or none, where the table
   fixes it); returns the largest status. */
static inline int skylight_sh_7_bands_1_5pct_evaluate_batch(
    const skylight_sh_7_bands_1_5pct_real *rows, int count,
        const float *const inputs[SKYLIGHT_SH_7_BANDS_1_5PCT_AXES],
    const float *azimuths, float
        (*weights)[SKYLIGHT_SH_7_BANDS_1_5PCT_CHANNELS][SKYLIGHT_SH_7_BANDS_1_5PCT_WEIGHTS])
{
    int s = 0, status, worst = 0;
#ifdef SKYLIGHT_SH_7_BANDS_1_5PCT_SUNS
    float shared[SKYLIGHT_SH_7_BANDS_1_5PCT_SHARED][SKYLIGHT_SH_7_BANDS_1_5PCT_WIDTH];
    const int share = count >= SKYLIGHT_SH_7_BANDS_1_5PCT_SUNS &&
        skylight_sh_7_bands_1_5pct_share(inputs, count);
    if (share) skylight_sh_7_bands_1_5pct_sum_shared(rows, inputs, shared);
    for (; s + SKYLIGHT_SH_7_BANDS_1_5PCT_SUNS <= count; s += SKYLIGHT_SH_7_BANDS_1_5PCT_SUNS) {
        float out[SKYLIGHT_SH_7_BANDS_1_5PCT_NUMBERS * SKYLIGHT_SH_7_BANDS_1_5PCT_SUNS];
        int i, k;
        status = skylight_sh_7_bands_1_5pct_evaluate_suns(rows, inputs, azimuths, s,
            share ? shared : 0, out,
                                           SKYLIGHT_SH_7_BANDS_1_5PCT_SUNS);
        worst = status > worst ? status : worst;
        /* In fours; the last may overlap those before. */
        for (i = 0; i < SKYLIGHT_SH_7_BANDS_1_5PCT_NUMBERS; i += 4) {
            const int at = i + 4 > SKYLIGHT_SH_7_BANDS_1_5PCT_NUMBERS ?
                SKYLIGHT_SH_7_BANDS_1_5PCT_NUMBERS - 4 : i;
            for (k = 0; k < SKYLIGHT_SH_7_BANDS_1_5PCT_SUNS; k += 4)
                skylight_sh_7_bands_1_5pct_transpose(out + at * SKYLIGHT_SH_7_BANDS_1_5PCT_SUNS + k,
                    SKYLIGHT_SH_7_BANDS_1_5PCT_SUNS,
                                      &weights[s + k][0][0] + at,
                                          SKYLIGHT_SH_7_BANDS_1_5PCT_NUMBERS);
        }
    }
#endif
    for (; s < count; ++s) {
        status = skylight_sh_7_bands_1_5pct_evaluate_one(rows, inputs, azimuths, s, weights[s]);
        worst = status > worst ? status : worst;
    }
    return worst;
}

/* The same with the suns of each weight side by side: `weights` is [channels][weights][count]. */
static inline int skylight_sh_7_bands_1_5pct_evaluate_columns(const skylight_sh_7_bands_1_5pct_real
    *rows, int count,
                                               const float *const
                                                   inputs[SKYLIGHT_SH_7_BANDS_1_5PCT_AXES],
                                               const float *azimuths, float *weights)
{
    const size_t step = count > 0 ? (size_t)count : 0;
    int s = 0, i, status, worst = 0;
#ifdef SKYLIGHT_SH_7_BANDS_1_5PCT_SUNS
    float shared[SKYLIGHT_SH_7_BANDS_1_5PCT_SHARED][SKYLIGHT_SH_7_BANDS_1_5PCT_WIDTH];
    const int share = count >= SKYLIGHT_SH_7_BANDS_1_5PCT_SUNS &&
        skylight_sh_7_bands_1_5pct_share(inputs, count);
    if (share) skylight_sh_7_bands_1_5pct_sum_shared(rows, inputs, shared);
#if SKYLIGHT_SH_7_BANDS_1_5PCT_LANES == 8
    /* Four times as many at once: rows far apart cost time for each visit, not for what is stored.
     * */
    for (; s + 4 * SKYLIGHT_SH_7_BANDS_1_5PCT_SUNS <= count; s += 4 *
        SKYLIGHT_SH_7_BANDS_1_5PCT_SUNS) {
        float out[SKYLIGHT_SH_7_BANDS_1_5PCT_NUMBERS][4 * SKYLIGHT_SH_7_BANDS_1_5PCT_SUNS];
        for (i = 0; i < 4; ++i) {
            status = skylight_sh_7_bands_1_5pct_evaluate_suns(rows, inputs, azimuths,
                s + i * SKYLIGHT_SH_7_BANDS_1_5PCT_SUNS,
                                               share ? shared : 0,
                                                   out[0] + i * SKYLIGHT_SH_7_BANDS_1_5PCT_SUNS,
                                                   4 * SKYLIGHT_SH_7_BANDS_1_5PCT_SUNS);
            worst = status > worst ? status : worst;
        }
        for (i = 0; i < SKYLIGHT_SH_7_BANDS_1_5PCT_NUMBERS; ++i)
            memcpy(weights + (size_t)i * step + (size_t)s, out[i], sizeof out[i]);
    }
#endif
    for (; s + SKYLIGHT_SH_7_BANDS_1_5PCT_SUNS <= count; s += SKYLIGHT_SH_7_BANDS_1_5PCT_SUNS) {
        status = skylight_sh_7_bands_1_5pct_evaluate_suns(rows, inputs, azimuths, s,
            share ? shared : 0, weights + s, step);
        worst = status > worst ? status : worst;
    }
#endif
    while (s < count) {
        /* Some at once, so that what is written lies together. */
        float some[16][SKYLIGHT_SH_7_BANDS_1_5PCT_CHANNELS][SKYLIGHT_SH_7_BANDS_1_5PCT_WEIGHTS];
        const int now = count - s < 16 ? count - s : 16;
        int k;
        for (k = 0; k < now; ++k) {
            status = skylight_sh_7_bands_1_5pct_evaluate_one(rows, inputs, azimuths, s + k,
                some[k]);
            worst = status > worst ? status : worst;
        }
        for (i = 0; i < SKYLIGHT_SH_7_BANDS_1_5PCT_NUMBERS; ++i)
            for (k = 0; k < now; ++k)
                weights[(size_t)i * step + (size_t)(s + k)] =
                    some[k][i / SKYLIGHT_SH_7_BANDS_1_5PCT_WEIGHTS][i %
                        SKYLIGHT_SH_7_BANDS_1_5PCT_WEIGHTS];
        s += now;
    }
    return worst;
}

/* All products of `count` numbers and `size` functions, the functions' place fastest; returns how
   many. */
static inline int skylight_sh_7_bands_1_5pct_multiply_double(double *products, int count,
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
static inline void skylight_sh_7_bands_1_5pct_sum_double(
    const skylight_sh_7_bands_1_5pct_real *rows,
        double functions[SKYLIGHT_SH_7_BANDS_1_5PCT_AXES][SKYLIGHT_SH_7_BANDS_1_5PCT_MOST],
    double sums[SKYLIGHT_SH_7_BANDS_1_5PCT_CLASSES][SKYLIGHT_SH_7_BANDS_1_5PCT_WIDTH])
{
    static const int sizes[SKYLIGHT_SH_7_BANDS_1_5PCT_AXES] = SKYLIGHT_SH_7_BANDS_1_5PCT_SIZES;
    double others[SKYLIGHT_SH_7_BANDS_1_5PCT_OTHERS];
    int axis, count = 1;
    others[0] = 1.0;
    for (axis = 1; axis < SKYLIGHT_SH_7_BANDS_1_5PCT_AXES; ++axis)
        count = skylight_sh_7_bands_1_5pct_multiply_double(others, count, functions[axis],
            sizes[axis]);
    skylight_sh_7_bands_1_5pct_sum_rows_double(rows, functions[0], others, sums);
    (void)count;
}

/* One channel's sum in double, at a column. */
static inline double skylight_sh_7_bands_1_5pct_mixed_double(double
    sums[SKYLIGHT_SH_7_BANDS_1_5PCT_CLASSES][SKYLIGHT_SH_7_BANDS_1_5PCT_WIDTH],
                                              int channel, int column, const double *factors)
{
    double sum = 0.0;
    int k;
    for (k = 0; k < SKYLIGHT_SH_7_BANDS_1_5PCT_CLASSES; ++k)
        sum += factors[SKYLIGHT_SH_7_BANDS_1_5PCT_FACTOR(channel, k)] * sums[k][column];
    return sum;
}

/* Evaluates all bands, and their derivatives after each axis by the product rule, in double until
   they are stored: exact inside the ranges, and beyond one those at its edge. */
static inline int skylight_sh_7_bands_1_5pct_evaluate_gradient(
    const skylight_sh_7_bands_1_5pct_real *rows,
        const float inputs[SKYLIGHT_SH_7_BANDS_1_5PCT_AXES], float azimuth,
    float weights[SKYLIGHT_SH_7_BANDS_1_5PCT_CHANNELS][SKYLIGHT_SH_7_BANDS_1_5PCT_WEIGHTS],
    float
        gradient[SKYLIGHT_SH_7_BANDS_1_5PCT_AXES][SKYLIGHT_SH_7_BANDS_1_5PCT_CHANNELS]
        [SKYLIGHT_SH_7_BANDS_1_5PCT_WEIGHTS])
{
    static const short columns[SKYLIGHT_SH_7_BANDS_1_5PCT_BANDS] =
        SKYLIGHT_SH_7_BANDS_1_5PCT_COLUMNS;
    double x[SKYLIGHT_SH_7_BANDS_1_5PCT_AXES],
        functions[SKYLIGHT_SH_7_BANDS_1_5PCT_AXES][SKYLIGHT_SH_7_BANDS_1_5PCT_MOST];
    double slopes[SKYLIGHT_SH_7_BANDS_1_5PCT_AXES][SKYLIGHT_SH_7_BANDS_1_5PCT_MOST];
    double factors[1 + SKYLIGHT_SH_7_BANDS_1_5PCT_AXES][SKYLIGHT_SH_7_BANDS_1_5PCT_FACTORS];
    double sums[SKYLIGHT_SH_7_BANDS_1_5PCT_CLASSES][SKYLIGHT_SH_7_BANDS_1_5PCT_WIDTH];
    double sloped[SKYLIGHT_SH_7_BANDS_1_5PCT_CLASSES][SKYLIGHT_SH_7_BANDS_1_5PCT_WIDTH];
    double powers[SKYLIGHT_SH_7_BANDS_1_5PCT_BANDS], power_slopes[SKYLIGHT_SH_7_BANDS_1_5PCT_BANDS];
    skylight_sh_7_bands_1_5pct_real cosines[SKYLIGHT_SH_7_BANDS_1_5PCT_BANDS],
        sines[SKYLIGHT_SH_7_BANDS_1_5PCT_BANDS], of_x, of_y;
    int axis, channel, i, l, m, sunk = 0;
    const int status =
        skylight_sh_7_bands_1_5pct_evaluate(rows, inputs, azimuth, SKYLIGHT_SH_7_BANDS_1_5PCT_BANDS,
            weights);
    memset(gradient, 0,
           sizeof(float) * SKYLIGHT_SH_7_BANDS_1_5PCT_AXES * SKYLIGHT_SH_7_BANDS_1_5PCT_CHANNELS *
               SKYLIGHT_SH_7_BANDS_1_5PCT_WEIGHTS);
    if (status == 2) return 2;
    for (axis = 0; axis < SKYLIGHT_SH_7_BANDS_1_5PCT_AXES; ++axis) {
        const double low = skylight_sh_7_bands_1_5pct_slope_range[axis][0];
        const double high = skylight_sh_7_bands_1_5pct_slope_range[axis][1];
        const double v = (double)skylight_sh_7_bands_1_5pct_finite(inputs[axis]);
        x[axis] = v < low ? low : v > high ? high : v;
        skylight_sh_7_bands_1_5pct_functions(axis, x[axis], functions[axis], slopes[axis]);
    }
    skylight_sh_7_bands_1_5pct_factor_slopes(x, &factors[0][0]);
    for (axis = 0; axis < 1 + SKYLIGHT_SH_7_BANDS_1_5PCT_AXES; ++axis)
        for (i = 0; i < SKYLIGHT_SH_7_BANDS_1_5PCT_FACTORS; ++i)
            factors[axis][i] *= (double)SKYLIGHT_SH_7_BANDS_1_5PCT_EXPOSURE;
    for (m = 0; m < SKYLIGHT_SH_7_BANDS_1_5PCT_BANDS; ++m) {
        powers[m] = 1.0;
        power_slopes[m] = 0.0;
    }
    {
        double sine[2];
        skylight_sh_7_bands_1_5pct_sine_slope(x, sine);
        for (m = 1; m < SKYLIGHT_SH_7_BANDS_1_5PCT_BANDS; ++m) {
            powers[m] = powers[m - 1] * sine[0];
            power_slopes[m] = (double)m * powers[m - 1] * sine[1];
        }
    }
    skylight_sh_7_bands_1_5pct_circle((skylight_sh_7_bands_1_5pct_real)azimuth, &of_x, &of_y);
    skylight_sh_7_bands_1_5pct_waves(of_x, of_y, 1, cosines, sines);
    skylight_sh_7_bands_1_5pct_sum_double(rows, functions, sums);
    for (axis = 0; axis < SKYLIGHT_SH_7_BANDS_1_5PCT_AXES; ++axis) {
        double kept[SKYLIGHT_SH_7_BANDS_1_5PCT_MOST];
        memcpy(kept, functions[axis], sizeof kept);
        memcpy(functions[axis], slopes[axis], sizeof kept);
        skylight_sh_7_bands_1_5pct_sum_double(rows, functions, sloped);
        memcpy(functions[axis], kept, sizeof kept);
        for (channel = 0; channel < SKYLIGHT_SH_7_BANDS_1_5PCT_CHANNELS; ++channel) {
            float *const w = gradient[axis][channel];
            for (l = 0; l < SKYLIGHT_SH_7_BANDS_1_5PCT_BANDS; ++l) {
                for (m = SKYLIGHT_SH_7_BANDS_1_5PCT_FIRST_ORDER(l); m <= l && columns[l] >= 0; ++m)
                    {
                    const int order = m < 0 ? -m : m;
                    const int column = columns[l] + m - SKYLIGHT_SH_7_BANDS_1_5PCT_FIRST_ORDER(l);
                    double value =
                        powers[order] *
                        (skylight_sh_7_bands_1_5pct_mixed_double(sloped, channel, column,
                            factors[0]) +
                         skylight_sh_7_bands_1_5pct_mixed_double(sums, channel, column,
                             factors[1 + axis]));
                    if (axis == SKYLIGHT_SH_7_BANDS_1_5PCT_SUN && !sunk)
                        value += power_slopes[order] *
                                 skylight_sh_7_bands_1_5pct_mixed_double(sums, channel, column,
                                     factors[0]);
                    skylight_sh_7_bands_1_5pct_place((skylight_sh_7_bands_1_5pct_real)value, l, m,
                        cosines, sines, w);
                }
            }
        }
        skylight_sh_7_bands_1_5pct_finish(SKYLIGHT_SH_7_BANDS_1_5PCT_BANDS, 0, gradient[axis]);
    }
    (void)power_slopes;
    (void)sunk;
    return status;
}

SKYLIGHT_SH_7_BANDS_1_5PCT_API int skylight_sh_7_bands_1_5pct_weights(float sun_zenith,
    float sun_azimuth, float turbidity,
    float weights[SKYLIGHT_SH_7_BANDS_1_5PCT_CHANNELS][SKYLIGHT_SH_7_BANDS_1_5PCT_WEIGHTS])
{
    const float skylight_sh_7_bands_1_5pct_given[SKYLIGHT_SH_7_BANDS_1_5PCT_AXES] = { sun_zenith,
        turbidity };
    return skylight_sh_7_bands_1_5pct_evaluate(skylight_sh_7_bands_1_5pct_rows,
        skylight_sh_7_bands_1_5pct_given, sun_azimuth, SKYLIGHT_SH_7_BANDS_1_5PCT_BANDS, weights);
}

SKYLIGHT_SH_7_BANDS_1_5PCT_API int skylight_sh_7_bands_1_5pct_weights_bands(float sun_zenith,
    float sun_azimuth, float turbidity, int bands,
    float weights[SKYLIGHT_SH_7_BANDS_1_5PCT_CHANNELS][SKYLIGHT_SH_7_BANDS_1_5PCT_WEIGHTS])
{
    const float skylight_sh_7_bands_1_5pct_given[SKYLIGHT_SH_7_BANDS_1_5PCT_AXES] = { sun_zenith,
        turbidity };
    return skylight_sh_7_bands_1_5pct_evaluate(skylight_sh_7_bands_1_5pct_rows,
        skylight_sh_7_bands_1_5pct_given, sun_azimuth, bands, weights);
}

SKYLIGHT_SH_7_BANDS_1_5PCT_API int skylight_sh_7_bands_1_5pct_weights_batch(int count,
    const float *sun_zenith, const float *sun_azimuth, const float *turbidity,
    float (*weights)[SKYLIGHT_SH_7_BANDS_1_5PCT_CHANNELS][SKYLIGHT_SH_7_BANDS_1_5PCT_WEIGHTS])
{
    const float *const skylight_sh_7_bands_1_5pct_given[SKYLIGHT_SH_7_BANDS_1_5PCT_AXES] = {
        sun_zenith, turbidity };
    return skylight_sh_7_bands_1_5pct_evaluate_batch(skylight_sh_7_bands_1_5pct_rows, count,
        skylight_sh_7_bands_1_5pct_given, sun_azimuth, weights);
}

SKYLIGHT_SH_7_BANDS_1_5PCT_API int skylight_sh_7_bands_1_5pct_weights_columns(int count,
    const float *sun_zenith, const float *sun_azimuth, const float *turbidity, float *weights)
{
    const float *const skylight_sh_7_bands_1_5pct_given[SKYLIGHT_SH_7_BANDS_1_5PCT_AXES] = {
        sun_zenith, turbidity };
    return skylight_sh_7_bands_1_5pct_evaluate_columns(skylight_sh_7_bands_1_5pct_rows, count,
        skylight_sh_7_bands_1_5pct_given, sun_azimuth, weights);
}

SKYLIGHT_SH_7_BANDS_1_5PCT_API int skylight_sh_7_bands_1_5pct_weights_gradient(float sun_zenith,
    float sun_azimuth, float turbidity,
    float weights[SKYLIGHT_SH_7_BANDS_1_5PCT_CHANNELS][SKYLIGHT_SH_7_BANDS_1_5PCT_WEIGHTS],
    float
    gradient[SKYLIGHT_SH_7_BANDS_1_5PCT_AXES][SKYLIGHT_SH_7_BANDS_1_5PCT_CHANNELS]
    [SKYLIGHT_SH_7_BANDS_1_5PCT_WEIGHTS])
{
    const float skylight_sh_7_bands_1_5pct_given[SKYLIGHT_SH_7_BANDS_1_5PCT_AXES] = { sun_zenith,
        turbidity };
    return skylight_sh_7_bands_1_5pct_evaluate_gradient(skylight_sh_7_bands_1_5pct_rows,
        skylight_sh_7_bands_1_5pct_given, sun_azimuth, weights, gradient);
}

/* The dominant light's direction, a unit vector: where the linear part of the weights, summed over
   channels by luminance, points. Returns 0, or 1 (and straight up) where it points nowhere. */
SKYLIGHT_SH_7_BANDS_1_5PCT_API int skylight_sh_7_bands_1_5pct_dominant_of(const float *weights,
    float direction[3])
{
    static const float luminance[SKYLIGHT_SH_7_BANDS_1_5PCT_CHANNELS] =
        SKYLIGHT_SH_7_BANDS_1_5PCT_LUMINANCE;
    float x = 0.0f, y = 0.0f, z = 0.0f, length;
    int channel;
    for (channel = 0; channel < SKYLIGHT_SH_7_BANDS_1_5PCT_CHANNELS; ++channel) {
        const float *const linear = weights + channel * SKYLIGHT_SH_7_BANDS_1_5PCT_WEIGHTS + 1;
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
SKYLIGHT_SH_7_BANDS_1_5PCT_API void skylight_sh_7_bands_1_5pct_ground(
    const float albedo[SKYLIGHT_SH_7_BANDS_1_5PCT_CHANNELS],
    float weights[SKYLIGHT_SH_7_BANDS_1_5PCT_CHANNELS][SKYLIGHT_SH_7_BANDS_1_5PCT_WEIGHTS])
{
    static const float lower[SKYLIGHT_SH_7_BANDS_1_5PCT_BANDS] = SKYLIGHT_SH_7_BANDS_1_5PCT_LOWER;
    int l, channel;
    for (channel = 0; channel < SKYLIGHT_SH_7_BANDS_1_5PCT_CHANNELS; ++channel) {
        const float radiance = albedo[channel] * SKYLIGHT_SH_7_BANDS_1_5PCT_REFLECTED *
            weights[channel][2];
        for (l = 0; l < SKYLIGHT_SH_7_BANDS_1_5PCT_BANDS; ++l) weights[channel][l * (l + 1)] +=
            radiance * lower[l];
    }
}

/* Tames the ringing of the horizon in the first `bands` bands by the zonal window sinc(pi l /
   bands) (Habel et al. 2008, eq. 5). */
SKYLIGHT_SH_7_BANDS_1_5PCT_API void skylight_sh_7_bands_1_5pct_window(
    int bands, float
        weights[SKYLIGHT_SH_7_BANDS_1_5PCT_CHANNELS][SKYLIGHT_SH_7_BANDS_1_5PCT_WEIGHTS])
{
    int l, channel;
    for (l = 1; l < bands && l < SKYLIGHT_SH_7_BANDS_1_5PCT_BANDS; ++l) {
        const float factor = skylight_sh_7_bands_1_5pct_sinc((float)l / (float)bands);
        for (channel = 0; channel < SKYLIGHT_SH_7_BANDS_1_5PCT_CHANNELS; ++channel)
            weights[channel][l * (l + 1)] *= factor;
    }
}

#endif /* SKYLIGHT_SH_7_BANDS_1_5PCT_DEFINED */
