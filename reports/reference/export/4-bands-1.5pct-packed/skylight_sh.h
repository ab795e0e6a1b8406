/* Preetham sky (published constants, srgb): spherical-harmonics weights, evaluated from
 * polynomials.
 *
 * Written by skylight-sh 0.1.0; the table and this code may be used by anyone for anything
 * (CC0-1.0).
 * C99 and C++11, no allocation, no global written, nothing static but constants: any thread may
 * call it.
 *
 * Usage
 *   float w[SKYLIGHT_SH_4_BANDS_1_5PCT_PACKED_CHANNELS][SKYLIGHT_SH_4_BANDS_1_5PCT_PACKED_WEIGHTS];
 *   int status = skylight_sh_4_bands_1_5pct_packed_weights(0.785000026f, 0.0f, 4.25f, w);
 * Compile with, for instance
 *   cc -std=c99 -O3 program.c -o program -lm
 * Included plainly, the file is all there is: its functions are static, and the table stands in
 * every unit that includes it. With SKYLIGHT_SH_4_BANDS_1_5PCT_PACKED_EXTERN defined before it, it
 * declares only; the one unit that also defines SKYLIGHT_SH_4_BANDS_1_5PCT_PACKED_IMPLEMENTATION
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
 *   Define SKYLIGHT_SH_4_BANDS_1_5PCT_PACKED_EXPOSURE before this file (where it holds the table)
 *   to multiply all weights (1 by default).
 *
 * Accuracy, as shipped: E_mean 1.45 %, E_max 3.9 % of the least luminance of the same sky, at
 * azimuth 0.
 * The expansion rings: the least value it takes, over all directions and measured sets, is -12.5 %
 * of its largest in the same set; the window below tames it.
 * Memory: 689 bytes of constants, packed into few bytes (a fast table takes more and less time).
 *
 * Provenance
 *   skylight-sh 0.1.0, config preetham 7738be1e848979ca, table 4-bands-1.5pct-packed
 */
#ifdef __cplusplus
#if __cplusplus < 201103L && !defined(_MSC_VER)
#error "skylight_sh needs C++11 or later: compile with -std=c++11."
#endif
#elif (!defined(__STDC_VERSION__) || __STDC_VERSION__ < 199901L) && !defined(_MSC_VER)
#error "skylight_sh needs C99 or later: compile with -std=c99."
#endif
#if defined(SKYLIGHT_SH_4_BANDS_1_5PCT_PACKED_IMPLEMENTATION) && \
    !defined(SKYLIGHT_SH_4_BANDS_1_5PCT_PACKED_EXTERN)
#error "Define SKYLIGHT_SH_4_BANDS_1_5PCT_PACKED_EXTERN in every unit, \
SKYLIGHT_SH_4_BANDS_1_5PCT_PACKED_IMPLEMENTATION beside it in one."
#endif
#if defined(SKYLIGHT_SH_4_BANDS_1_5PCT_PACKED_API) && \
    defined(SKYLIGHT_SH_4_BANDS_1_5PCT_PACKED_EXTERN) && \
    !defined(SKYLIGHT_SH_4_BANDS_1_5PCT_PACKED_DECLARED)
#error "Define SKYLIGHT_SH_4_BANDS_1_5PCT_PACKED_EXTERN before this file is included for the first \
time."
#endif
#if defined(SKYLIGHT_SH_4_BANDS_1_5PCT_PACKED_DECLARED) && \
    !defined(SKYLIGHT_SH_4_BANDS_1_5PCT_PACKED_EXTERN)
#error "Leave SKYLIGHT_SH_4_BANDS_1_5PCT_PACKED_EXTERN defined: this file was included with it \
before."
#endif

#ifndef SKYLIGHT_SH_4_BANDS_1_5PCT_PACKED_H
#define SKYLIGHT_SH_4_BANDS_1_5PCT_PACKED_H 0x4948e7e5

#include <math.h>
#include <stdint.h>
#include <string.h>

#ifndef SKYLIGHT_SH_4_BANDS_1_5PCT_PACKED_EXTERN
#define SKYLIGHT_SH_4_BANDS_1_5PCT_PACKED_API static inline
#else
#define SKYLIGHT_SH_4_BANDS_1_5PCT_PACKED_DECLARED
#ifdef __cplusplus
#define SKYLIGHT_SH_4_BANDS_1_5PCT_PACKED_API extern "C"
#else
#define SKYLIGHT_SH_4_BANDS_1_5PCT_PACKED_API extern
#endif
#endif
#ifndef SKYLIGHT_SH_4_BANDS_1_5PCT_PACKED_EXPOSURE
#define SKYLIGHT_SH_4_BANDS_1_5PCT_PACKED_EXPOSURE 1
#endif

#define SKYLIGHT_SH_4_BANDS_1_5PCT_PACKED_VERSION "0.1.0"
#define SKYLIGHT_SH_4_BANDS_1_5PCT_PACKED_BANDS 4
#define SKYLIGHT_SH_4_BANDS_1_5PCT_PACKED_WEIGHTS 16
#define SKYLIGHT_SH_4_BANDS_1_5PCT_PACKED_CHANNELS 3
#define SKYLIGHT_SH_4_BANDS_1_5PCT_PACKED_AXES 2
#define SKYLIGHT_SH_4_BANDS_1_5PCT_PACKED_UNIT "cd/m2"
#define SKYLIGHT_SH_4_BANDS_1_5PCT_PACKED_E_MEAN 1.451000e-02
#define SKYLIGHT_SH_4_BANDS_1_5PCT_PACKED_E_MAX 3.899000e-02
#define SKYLIGHT_SH_4_BANDS_1_5PCT_PACKED_SUN_ZENITH_MIN 0.0f
#define SKYLIGHT_SH_4_BANDS_1_5PCT_PACKED_SUN_ZENITH_MAX 1.57079637f
#define SKYLIGHT_SH_4_BANDS_1_5PCT_PACKED_TURBIDITY_MIN 2.5f
#define SKYLIGHT_SH_4_BANDS_1_5PCT_PACKED_TURBIDITY_MAX 6.0f

/* Evaluates all bands. */
SKYLIGHT_SH_4_BANDS_1_5PCT_PACKED_API int skylight_sh_4_bands_1_5pct_packed_weights(float
    sun_zenith, float sun_azimuth, float turbidity,
    float
    weights[SKYLIGHT_SH_4_BANDS_1_5PCT_PACKED_CHANNELS][SKYLIGHT_SH_4_BANDS_1_5PCT_PACKED_WEIGHTS]);
/* Evaluates the first `bands` bands (1 to SKYLIGHT_SH_4_BANDS_1_5PCT_PACKED_BANDS, clamped
   likewise) and zeroes the rest. */
SKYLIGHT_SH_4_BANDS_1_5PCT_PACKED_API int skylight_sh_4_bands_1_5pct_packed_weights_bands(float
    sun_zenith, float sun_azimuth, float turbidity, int bands,
    float
    weights[SKYLIGHT_SH_4_BANDS_1_5PCT_PACKED_CHANNELS][SKYLIGHT_SH_4_BANDS_1_5PCT_PACKED_WEIGHTS]);
/* Evaluates `count` suns from arrays; returns the largest status. No faster
   than single calls. */
SKYLIGHT_SH_4_BANDS_1_5PCT_PACKED_API int skylight_sh_4_bands_1_5pct_packed_weights_batch(int count,
    const float *sun_zenith, const float *sun_azimuth, const float *turbidity,
    float
    (*weights)[SKYLIGHT_SH_4_BANDS_1_5PCT_PACKED_CHANNELS]
    [SKYLIGHT_SH_4_BANDS_1_5PCT_PACKED_WEIGHTS]);
/* Evaluates all bands and their derivatives after each axis (sun_zenith,
   turbidity), per unit of the axis; beyond a range, those at its edge. */
SKYLIGHT_SH_4_BANDS_1_5PCT_PACKED_API int skylight_sh_4_bands_1_5pct_packed_weights_gradient(float
    sun_zenith, float sun_azimuth, float turbidity,
    float
    weights[SKYLIGHT_SH_4_BANDS_1_5PCT_PACKED_CHANNELS][SKYLIGHT_SH_4_BANDS_1_5PCT_PACKED_WEIGHTS],
    float
    gradient[SKYLIGHT_SH_4_BANDS_1_5PCT_PACKED_AXES][SKYLIGHT_SH_4_BANDS_1_5PCT_PACKED_CHANNELS]
    [SKYLIGHT_SH_4_BANDS_1_5PCT_PACKED_WEIGHTS]);
/* Unit vector of the dominant light. Returns 0, or 1 (and straight up) where there is none. */
#define skylight_sh_4_bands_1_5pct_packed_dominant(weights, direction) \
    skylight_sh_4_bands_1_5pct_packed_dominant_of(&(weights)[0][0], direction)
SKYLIGHT_SH_4_BANDS_1_5PCT_PACKED_API int skylight_sh_4_bands_1_5pct_packed_dominant_of(const float
    *weights, float direction[3]);
/* Optional: adds an even ground of this albedo below the horizon, lit by the sky (before any
 * window). */
SKYLIGHT_SH_4_BANDS_1_5PCT_PACKED_API void skylight_sh_4_bands_1_5pct_packed_ground(const float
    albedo[SKYLIGHT_SH_4_BANDS_1_5PCT_PACKED_CHANNELS],
    float
    weights[SKYLIGHT_SH_4_BANDS_1_5PCT_PACKED_CHANNELS][SKYLIGHT_SH_4_BANDS_1_5PCT_PACKED_WEIGHTS]);
/* Optional: tames the ringing of the horizon by the zonal window of the first `bands` bands. */
SKYLIGHT_SH_4_BANDS_1_5PCT_PACKED_API void skylight_sh_4_bands_1_5pct_packed_window(int bands,
    float
    weights[SKYLIGHT_SH_4_BANDS_1_5PCT_PACKED_CHANNELS][SKYLIGHT_SH_4_BANDS_1_5PCT_PACKED_WEIGHTS]);

#elif SKYLIGHT_SH_4_BANDS_1_5PCT_PACKED_H != 0x4948e7e5
#error "Another table has the prefix skylight_sh_4_bands_1_5pct_packed_4_bands_1_5pct_packed \
already: export one of them under a prefix of its own."
#endif /* SKYLIGHT_SH_4_BANDS_1_5PCT_PACKED_H */

#if (!defined(SKYLIGHT_SH_4_BANDS_1_5PCT_PACKED_EXTERN) || \
    defined(SKYLIGHT_SH_4_BANDS_1_5PCT_PACKED_IMPLEMENTATION)) && \
    !defined(SKYLIGHT_SH_4_BANDS_1_5PCT_PACKED_DEFINED)
#define SKYLIGHT_SH_4_BANDS_1_5PCT_PACKED_DEFINED

typedef float skylight_sh_4_bands_1_5pct_packed_real;

/* Functions of the first axis, in fours; products of the other axes'
   functions. */
#define SKYLIGHT_SH_4_BANDS_1_5PCT_PACKED_FIRST 8
#define SKYLIGHT_SH_4_BANDS_1_5PCT_PACKED_OTHERS 5
#define SKYLIGHT_SH_4_BANDS_1_5PCT_PACKED_SIZES { 8, 5 }
#define SKYLIGHT_SH_4_BANDS_1_5PCT_PACKED_MOST 8
#define SKYLIGHT_SH_4_BANDS_1_5PCT_PACKED_AZIMUTH 0.0f
/* The channels' luminance. */
#define SKYLIGHT_SH_4_BANDS_1_5PCT_PACKED_LUMINANCE { 0.212672845f, 0.715152144f, 0.0721749961f }
/* What an even ground reflects of the weight l = 1, m = 0, and its own
   zonal weights. */
#define SKYLIGHT_SH_4_BANDS_1_5PCT_PACKED_REFLECTED 0.651470006f
#define SKYLIGHT_SH_4_BANDS_1_5PCT_PACKED_LOWER { 1.7724539f, -1.53499007f, 0.0f, 0.586184025f }

/* Of each axis: the first and last float that counts as inside, and its
   range. */
static const float
    skylight_sh_4_bands_1_5pct_packed_inside[SKYLIGHT_SH_4_BANDS_1_5PCT_PACKED_AXES][2] = { {
    -1.57079626e-06f, 1.5707978f }, { 2.49999666f, 6.00000334f } };
static const skylight_sh_4_bands_1_5pct_packed_real
    skylight_sh_4_bands_1_5pct_packed_range[SKYLIGHT_SH_4_BANDS_1_5PCT_PACKED_AXES][2] = { { 0.0f,
    1.57079637f }, { 2.5f, 6.0f } };

/* Runs of numbers, one a product of the other axes' functions, and their
   profiles; what one step is worth. */
#define SKYLIGHT_SH_4_BANDS_1_5PCT_PACKED_RUNS 5
#define SKYLIGHT_SH_4_BANDS_1_5PCT_PACKED_RUN_PROFILE { 4, 1, -4, -9, -12 }
#define SKYLIGHT_SH_4_BANDS_1_5PCT_PACKED_CHANNEL_PROFILE { -3, -3, -2 }
#define SKYLIGHT_SH_4_BANDS_1_5PCT_PACKED_STEP 0.00204467773f

/* Whole numbers as Rice codes. */
static const unsigned char skylight_sh_4_bands_1_5pct_packed_stream[497] = {
    103, 66, 182, 144, 24, 255, 111, 226, 100, 100, 82, 154, 249, 223, 92, 89, 186, 229, 240, 63, 3,
    220, 222, 75, 49, 254, 191, 97, 40, 187, 67, 1, 242, 111, 118, 93, 157, 224, 39, 151, 57, 244,
    255, 78, 148, 93, 91, 209, 145, 94, 255, 63, 222, 23, 61, 49, 252, 46, 255, 111, 107, 250, 41,
    238, 251, 31, 136, 110, 142, 132, 46, 161, 33, 156, 55, 101, 6, 160, 226, 198, 42, 104, 44, 41,
    10, 110, 251, 198, 180, 158, 175, 37, 248, 68, 212, 198, 190, 4, 98, 86, 93, 132, 113, 72, 44,
    177, 226, 84, 226, 50, 237, 235, 229, 60, 126, 205, 236, 30, 26, 228, 62, 158, 222, 72, 241, 24,
    215, 41, 136, 192, 63, 78, 167, 133, 69, 64, 54, 12, 226, 149, 229, 74, 8, 27, 68, 180, 134, 17,
    35, 138, 252, 136, 6, 72, 98, 26, 78, 39, 96, 128, 4, 68, 39, 229, 93, 58, 96, 208, 30, 80, 7,
    62, 167, 208, 8, 53, 118, 5, 144, 39, 188, 76, 55, 32, 99, 111, 6, 187, 171, 192, 176, 90, 236,
    201, 206, 9, 118, 19, 113, 219, 76, 170, 213, 67, 140, 246, 14, 59, 174, 85, 211, 71, 88, 210,
    32, 218, 179, 238, 129, 129, 235, 30, 76, 58, 165, 173, 115, 184, 252, 177, 43, 162, 144, 96,
    161, 139, 216, 220, 40, 239, 60, 70, 45, 20, 183, 107, 2, 169, 192, 88, 8, 209, 193, 209, 251,
    20, 120, 59, 110, 0, 241, 105, 191, 175, 14, 27, 174, 62, 128, 44, 252, 224, 157, 151, 33, 135,
    27, 162, 45, 194, 146, 142, 78, 153, 197, 163, 94, 15, 162, 208, 200, 16, 175, 241, 97, 58, 120,
    67, 38, 88, 153, 98, 19, 81, 1, 165, 112, 121, 42, 96, 255, 160, 215, 216, 66, 37, 0, 215, 243,
    29, 230, 102, 236, 168, 69, 191, 51, 27, 111, 80, 212, 174, 93, 202, 45, 15, 34, 175, 195, 48,
    247, 194, 164, 30, 131, 227, 246, 222, 125, 172, 184, 247, 224, 232, 189, 56, 155, 104, 165,
    162, 195, 145, 163, 233, 230, 243, 174, 7, 51, 119, 184, 99, 34, 172, 75, 41, 47, 158, 201, 78,
    81, 152, 6, 104, 141, 229, 243, 84, 157, 5, 58, 237, 97, 233, 75, 166, 163, 167, 89, 2, 21, 106,
    142, 119, 215, 9, 114, 193, 78, 162, 227, 173, 139, 243, 197, 158, 89, 164, 56, 213, 102, 241,
    72, 10, 29, 88, 144, 67, 82, 35, 69, 19, 114, 177, 109, 166, 17, 145, 10, 75, 93, 83, 15, 246,
    9, 62, 108, 95, 69, 180, 20, 128, 134, 96, 101, 173, 202, 103, 236, 31, 252, 167, 209, 85, 40,
    30, 56, 38, 122, 12, 35, 4, 216, 108, 86, 51, 193, 24, 130, 5, 48, 231, 17, 224, 68, 229, 233,
    67, 217, 44, 36, 16, 71, 166, 44, 80, 0
};

/* What all weights share: the closed form preetham_zenith. */
static inline skylight_sh_4_bands_1_5pct_packed_real skylight_sh_4_bands_1_5pct_packed_scale(const
    skylight_sh_4_bands_1_5pct_packed_real *x)
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
static inline void skylight_sh_4_bands_1_5pct_packed_first(const
    skylight_sh_4_bands_1_5pct_packed_real *x, skylight_sh_4_bands_1_5pct_packed_real *out)
{
    out[0] = 1.0f;
    out[1] = 4.36619759f * (x[0] - 0.0f) / (5.0f - x[0]) - 1.0f;
    out[2] = 2.0f * out[1] * out[1] - 1.0f;
    out[3] = 2.0f * out[1] * out[2] - out[1];
    out[4] = 2.0f * out[2] * out[2] - 1.0f;
    out[5] = 2.0f * out[2] * out[3] - out[1];
    out[6] = 2.0f * out[3] * out[3] - 1.0f;
    out[7] = 2.0f * out[3] * out[4] - out[1];
    (void)x;
}

/* All products of the functions of turbidity (change of variable:
   reciprocal). */
static inline void skylight_sh_4_bands_1_5pct_packed_others(const
    skylight_sh_4_bands_1_5pct_packed_real *x, skylight_sh_4_bands_1_5pct_packed_real *out)
{
    out[0] = 1.0f;
    out[1] = (-4.57142878f) * (x[1] - 2.5f) / ((-2.0f) - x[1]) - 1.0f;
    out[2] = 2.0f * out[1] * out[1] - 1.0f;
    out[3] = 2.0f * out[1] * out[2] - out[1];
    out[4] = 2.0f * out[2] * out[2] - 1.0f;
    (void)x;
}

/* cos(m azimuth) and sin(m azimuth) for m < bands, by doubling. */
static inline void skylight_sh_4_bands_1_5pct_packed_waves(skylight_sh_4_bands_1_5pct_packed_real
    azimuth, skylight_sh_4_bands_1_5pct_packed_real *cosines,
    skylight_sh_4_bands_1_5pct_packed_real *sines)
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
static inline float skylight_sh_4_bands_1_5pct_packed_sinc(float share)
{
    const float x = 3.14159274f * share;
    return sinf(x) / x;
}

/* Of each axis: where its functions have slopes. */
static const double
    skylight_sh_4_bands_1_5pct_packed_slope_range[SKYLIGHT_SH_4_BANDS_1_5PCT_PACKED_AXES][2] = { {
    0.0, 1.5707963267948966 }, { 2.5, 6.0 } };

/* The functions of an axis at v, and their slopes. */
static inline void skylight_sh_4_bands_1_5pct_packed_functions(int axis, double v, double *out,
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
        slopes[0] = 0.0;
        slopes[1] = 4.366197723675814 / part_1 - part_2 * -1.0 / part_1;
        slopes[2] = 2.0 * slopes[1] * out[1] + part_3 * slopes[1];
        slopes[3] = 2.0 * slopes[1] * out[2] + part_4 * slopes[2] - slopes[1];
        slopes[4] = 2.0 * slopes[2] * out[2] + part_5 * slopes[2];
        slopes[5] = 2.0 * slopes[2] * out[3] + part_6 * slopes[3] - slopes[1];
        slopes[6] = 2.0 * slopes[3] * out[3] + part_7 * slopes[3];
        slopes[7] = 2.0 * slopes[3] * out[4] + part_8 * slopes[4] - slopes[1];
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
static inline void skylight_sh_4_bands_1_5pct_packed_scale_slopes(const double *x, double *out)
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
static inline int skylight_sh_4_bands_1_5pct_packed_kind(float v)
{
    uint32_t bits;
    memcpy(&bits, &v, sizeof bits);
    bits &= 0x7fffffffu;
    return (bits >= 0x7f800000u) + (bits > 0x7f800000u);
}

/* A number that is no NaN, finite: an infinity becomes a large number of its sign. */
static inline float skylight_sh_4_bands_1_5pct_packed_finite(float v)
{
    if (skylight_sh_4_bands_1_5pct_packed_kind(v)) {
        uint32_t bits;
        memcpy(&bits, &v, sizeof bits);
        v = bits >> 31 ? -3e38f : 3e38f;
    }
    return v;
}

/* Clamps the axes' inputs into x. Returns the status: 0; 1 where one was not inside; 2, and nothing
   in x, where one is NaN or the azimuth no finite number. */
static inline int skylight_sh_4_bands_1_5pct_packed_inputs(const float
    inputs[SKYLIGHT_SH_4_BANDS_1_5PCT_PACKED_AXES], float azimuth,
                                     skylight_sh_4_bands_1_5pct_packed_real
                                         x[SKYLIGHT_SH_4_BANDS_1_5PCT_PACKED_AXES])
{
    int axis, status = 0, strange = skylight_sh_4_bands_1_5pct_packed_kind(azimuth) ? 2 : 0;
    for (axis = 0; axis < SKYLIGHT_SH_4_BANDS_1_5PCT_PACKED_AXES; ++axis) strange |=
        skylight_sh_4_bands_1_5pct_packed_kind(inputs[axis]);
    if (strange & 2) return 2;
    for (axis = 0; axis < SKYLIGHT_SH_4_BANDS_1_5PCT_PACKED_AXES; ++axis) {
        const float v = skylight_sh_4_bands_1_5pct_packed_finite(inputs[axis]);
        const skylight_sh_4_bands_1_5pct_packed_real low =
            skylight_sh_4_bands_1_5pct_packed_range[axis][0],
            high = skylight_sh_4_bands_1_5pct_packed_range[axis][1];
        const skylight_sh_4_bands_1_5pct_packed_real at_least =
            (skylight_sh_4_bands_1_5pct_packed_real)v < low ? low :
            (skylight_sh_4_bands_1_5pct_packed_real)v;
        status |= (v < skylight_sh_4_bands_1_5pct_packed_inside[axis][0]) | (v >
            skylight_sh_4_bands_1_5pct_packed_inside[axis][1]);
        x[axis] = at_least > high ? high : at_least;
    }
    return status;
}

/* Orders m >= 0 alone are stored: those of a light that is even in y at azimuth 0. */
#define SKYLIGHT_SH_4_BANDS_1_5PCT_PACKED_FIRST_ORDER(l) 0

/* Stores the weight of degree l and order m turned by the azimuth (Habel et al. 2008, eq. 4). */
static inline void skylight_sh_4_bands_1_5pct_packed_place(skylight_sh_4_bands_1_5pct_packed_real
    value, int l, int m,
                                     const skylight_sh_4_bands_1_5pct_packed_real *cosines,
                                         const skylight_sh_4_bands_1_5pct_packed_real *sines,
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
} skylight_sh_4_bands_1_5pct_packed_bits;

static inline void skylight_sh_4_bands_1_5pct_packed_fill(skylight_sh_4_bands_1_5pct_packed_bits *b)
{
    const unsigned char *const end = skylight_sh_4_bands_1_5pct_packed_stream + sizeof
        skylight_sh_4_bands_1_5pct_packed_stream;
    while (b->count <= 56 && b->next < end) {
        b->held |= (uint64_t)*b->next++ << b->count;
        b->count += 8;
    }
}

/* `width` bits, at most 31, as a number. */
static inline unsigned
    skylight_sh_4_bands_1_5pct_packed_fixed(skylight_sh_4_bands_1_5pct_packed_bits *b, int width)
{
    unsigned value;
    if (b->count < 32) skylight_sh_4_bands_1_5pct_packed_fill(b);
    value = (unsigned)(b->held & ((UINT64_C(1) << width) - 1));
    b->held >>= width;
    b->count -= width;
    return value;
}

/* A Rice code of `low` low bits: ones, a zero, the low bits; then folded back: 0, 1, 2, 3 -> 0, -1,
   1, -2. */
static inline int skylight_sh_4_bands_1_5pct_packed_rice(skylight_sh_4_bands_1_5pct_packed_bits *b,
    int low)
{
    unsigned high = 0, folded;
    if (b->count < 32) skylight_sh_4_bands_1_5pct_packed_fill(b);
    while (b->held & 1) {
        ++high;
        b->held >>= 1;
        if (--b->count < 1) skylight_sh_4_bands_1_5pct_packed_fill(b);
    }
    b->held >>= 1;
    --b->count;
    folded = (high << low) | skylight_sh_4_bands_1_5pct_packed_fixed(b, low);
    return folded & 1 ? -(int)(folded >> 1) - 1 : (int)(folded >> 1);
}

/* The stream from its start. */
static inline skylight_sh_4_bands_1_5pct_packed_bits skylight_sh_4_bands_1_5pct_packed_open(void)
{
    skylight_sh_4_bands_1_5pct_packed_bits b;
    b.next = skylight_sh_4_bands_1_5pct_packed_stream;
    b.held = 0;
    b.count = 0;
    return b;
}

/* The next band's profile: twice the low bits that its numbers have, by their place in a run. */
static inline void
    skylight_sh_4_bands_1_5pct_packed_next_profile(skylight_sh_4_bands_1_5pct_packed_bits *b,
    int profile[32])
{
    const int used = (int)skylight_sh_4_bands_1_5pct_packed_fixed(b, 5);
    int i;
    for (i = 0; i < used; ++i) profile[i] = (int)skylight_sh_4_bands_1_5pct_packed_fixed(b, 5);
}

/* The length of the next run, by that of the same channel and product at the weight before. */
static inline int
    skylight_sh_4_bands_1_5pct_packed_next_length(skylight_sh_4_bands_1_5pct_packed_bits *b,
    signed char *length)
{
    const int found = *length + skylight_sh_4_bands_1_5pct_packed_rice(b, 0);
    *length = (signed char)found;
    return found;
}

/* The next number, of `size` half low bits. */
static inline int
    skylight_sh_4_bands_1_5pct_packed_next_number(skylight_sh_4_bands_1_5pct_packed_bits *b,
    int size)
{
    return skylight_sh_4_bands_1_5pct_packed_rice(b, size > 0 ? size >> 1 : 0);
}

static const signed char
    skylight_sh_4_bands_1_5pct_packed_run_profile[SKYLIGHT_SH_4_BANDS_1_5PCT_PACKED_RUNS] =
    SKYLIGHT_SH_4_BANDS_1_5PCT_PACKED_RUN_PROFILE;
static const signed char
    skylight_sh_4_bands_1_5pct_packed_channel_profile[SKYLIGHT_SH_4_BANDS_1_5PCT_PACKED_CHANNELS] =
    SKYLIGHT_SH_4_BANDS_1_5PCT_PACKED_CHANNEL_PROFILE;

/* Reads the stream once, forward, and stores the first `bands` bands. */
static inline void skylight_sh_4_bands_1_5pct_packed_combine(const
    skylight_sh_4_bands_1_5pct_packed_real *first,
                                       const skylight_sh_4_bands_1_5pct_packed_real *others,
                                       const skylight_sh_4_bands_1_5pct_packed_real *cosines,
                                       const skylight_sh_4_bands_1_5pct_packed_real *sines,
                                           int bands,
                                       float
                                           weights[SKYLIGHT_SH_4_BANDS_1_5PCT_PACKED_CHANNELS]
                                           [SKYLIGHT_SH_4_BANDS_1_5PCT_PACKED_WEIGHTS])
{
    signed char
        lengths[SKYLIGHT_SH_4_BANDS_1_5PCT_PACKED_CHANNELS][SKYLIGHT_SH_4_BANDS_1_5PCT_PACKED_RUNS];
    int profile[32], i, l, m, channel, other;
    skylight_sh_4_bands_1_5pct_packed_bits bits = skylight_sh_4_bands_1_5pct_packed_open();
    memset(lengths, 0, sizeof lengths);
    memset(profile, 0, sizeof profile);
    for (l = 0; l < bands; ++l) {
        skylight_sh_4_bands_1_5pct_packed_next_profile(&bits, profile);
        for (m = SKYLIGHT_SH_4_BANDS_1_5PCT_PACKED_FIRST_ORDER(l); m <= l; ++m) {
            for (channel = 0; channel < SKYLIGHT_SH_4_BANDS_1_5PCT_PACKED_CHANNELS; ++channel) {
                skylight_sh_4_bands_1_5pct_packed_real value = 0;
                for (other = 0; other < SKYLIGHT_SH_4_BANDS_1_5PCT_PACKED_RUNS; ++other) {
                    const int level = skylight_sh_4_bands_1_5pct_packed_run_profile[other] +
                                      skylight_sh_4_bands_1_5pct_packed_channel_profile[channel];
                    const int length = skylight_sh_4_bands_1_5pct_packed_next_length(&bits,
                        &lengths[channel][other]);
                    skylight_sh_4_bands_1_5pct_packed_real sum = 0;
                    for (i = 0; i < length; ++i) {
                        const int number = skylight_sh_4_bands_1_5pct_packed_next_number(&bits,
                            profile[i] + level);
                        sum += first[i] * (skylight_sh_4_bands_1_5pct_packed_real)number;
                    }
                    value += sum * others[other];
                }
                skylight_sh_4_bands_1_5pct_packed_place(value *
                    SKYLIGHT_SH_4_BANDS_1_5PCT_PACKED_STEP, l, m, cosines, sines,
                                  weights[channel]);
            }
        }
    }
}

/* The same in double precision, all bands: what derivatives need, whose terms cancel. */
static inline void skylight_sh_4_bands_1_5pct_packed_combine_double(
    const double *first, const double *others,
        const skylight_sh_4_bands_1_5pct_packed_real *cosines,
    const skylight_sh_4_bands_1_5pct_packed_real *sines,
        float
        weights[SKYLIGHT_SH_4_BANDS_1_5PCT_PACKED_CHANNELS]
        [SKYLIGHT_SH_4_BANDS_1_5PCT_PACKED_WEIGHTS])
{
    signed char
        lengths[SKYLIGHT_SH_4_BANDS_1_5PCT_PACKED_CHANNELS][SKYLIGHT_SH_4_BANDS_1_5PCT_PACKED_RUNS];
    int profile[32], i, l, m, channel, other;
    skylight_sh_4_bands_1_5pct_packed_bits bits = skylight_sh_4_bands_1_5pct_packed_open();
    memset(lengths, 0, sizeof lengths);
    memset(profile, 0, sizeof profile);
    for (l = 0; l < SKYLIGHT_SH_4_BANDS_1_5PCT_PACKED_BANDS; ++l) {
        skylight_sh_4_bands_1_5pct_packed_next_profile(&bits, profile);
        for (m = SKYLIGHT_SH_4_BANDS_1_5PCT_PACKED_FIRST_ORDER(l); m <= l; ++m) {
            for (channel = 0; channel < SKYLIGHT_SH_4_BANDS_1_5PCT_PACKED_CHANNELS; ++channel) {
                double value = 0.0;
                for (other = 0; other < SKYLIGHT_SH_4_BANDS_1_5PCT_PACKED_RUNS; ++other) {
                    const int level = skylight_sh_4_bands_1_5pct_packed_run_profile[other] +
                                      skylight_sh_4_bands_1_5pct_packed_channel_profile[channel];
                    const int length = skylight_sh_4_bands_1_5pct_packed_next_length(&bits,
                        &lengths[channel][other]);
                    double sum = 0.0;
                    for (i = 0; i < length; ++i) {
                        const int number = skylight_sh_4_bands_1_5pct_packed_next_number(&bits,
                            profile[i] + level);
                        sum += first[i] * (double)number;
                    }
                    value += sum * others[other];
                }
                skylight_sh_4_bands_1_5pct_packed_place((skylight_sh_4_bands_1_5pct_packed_real)(
                    value * (double)SKYLIGHT_SH_4_BANDS_1_5PCT_PACKED_STEP), l, m,
                                  cosines, sines, weights[channel]);
            }
        }
    }
}

/* What becomes of the first `bands` bands once they are stored; the others become 0. */
static inline void skylight_sh_4_bands_1_5pct_packed_finish(int bands, int lights,
    const skylight_sh_4_bands_1_5pct_packed_real *cosines,
                                      const skylight_sh_4_bands_1_5pct_packed_real *sines,
                                      float
                                          weights[SKYLIGHT_SH_4_BANDS_1_5PCT_PACKED_CHANNELS]
                                          [SKYLIGHT_SH_4_BANDS_1_5PCT_PACKED_WEIGHTS])
{
    if (bands < SKYLIGHT_SH_4_BANDS_1_5PCT_PACKED_BANDS) {
        int channel, i;
        for (channel = 0; channel < SKYLIGHT_SH_4_BANDS_1_5PCT_PACKED_CHANNELS; ++channel)
            for (i = bands * bands; i < SKYLIGHT_SH_4_BANDS_1_5PCT_PACKED_WEIGHTS; ++i)
                weights[channel][i] = 0.0f;
    }
    (void)lights;
    (void)cosines;
    (void)sines;
}

/* Evaluates the first `bands` bands (1 to SKYLIGHT_SH_4_BANDS_1_5PCT_PACKED_BANDS, clamped like an
 * input) and zeroes the
   rest; returns the status. */
static inline int skylight_sh_4_bands_1_5pct_packed_evaluate(const float
    inputs[SKYLIGHT_SH_4_BANDS_1_5PCT_PACKED_AXES], float azimuth,
                                       int bands,
                                       float
                                           weights[SKYLIGHT_SH_4_BANDS_1_5PCT_PACKED_CHANNELS]
                                           [SKYLIGHT_SH_4_BANDS_1_5PCT_PACKED_WEIGHTS])
{
    skylight_sh_4_bands_1_5pct_packed_real x[SKYLIGHT_SH_4_BANDS_1_5PCT_PACKED_AXES],
        first[SKYLIGHT_SH_4_BANDS_1_5PCT_PACKED_FIRST],
        others[SKYLIGHT_SH_4_BANDS_1_5PCT_PACKED_OTHERS];
    skylight_sh_4_bands_1_5pct_packed_real cosines[SKYLIGHT_SH_4_BANDS_1_5PCT_PACKED_BANDS],
        sines[SKYLIGHT_SH_4_BANDS_1_5PCT_PACKED_BANDS], scale;
    int i, status = skylight_sh_4_bands_1_5pct_packed_inputs(inputs, azimuth, x);
    if (status == 2) {
        memset(weights, 0, sizeof(float) * SKYLIGHT_SH_4_BANDS_1_5PCT_PACKED_CHANNELS *
            SKYLIGHT_SH_4_BANDS_1_5PCT_PACKED_WEIGHTS);
        return 2;
    }
    if (bands < 1 || bands > SKYLIGHT_SH_4_BANDS_1_5PCT_PACKED_BANDS) {
        bands = bands < 1 ? 1 : SKYLIGHT_SH_4_BANDS_1_5PCT_PACKED_BANDS;
        status = 1;
    }
    scale = skylight_sh_4_bands_1_5pct_packed_scale(x) *
        (skylight_sh_4_bands_1_5pct_packed_real)SKYLIGHT_SH_4_BANDS_1_5PCT_PACKED_EXPOSURE;
    skylight_sh_4_bands_1_5pct_packed_first(x, first);
    skylight_sh_4_bands_1_5pct_packed_others(x, others);
    for (i = 0; i < SKYLIGHT_SH_4_BANDS_1_5PCT_PACKED_OTHERS; ++i) others[i] *= scale;
    skylight_sh_4_bands_1_5pct_packed_waves((skylight_sh_4_bands_1_5pct_packed_real)azimuth,
        cosines, sines);
    skylight_sh_4_bands_1_5pct_packed_combine(first, others, cosines, sines, bands, weights);
    skylight_sh_4_bands_1_5pct_packed_finish(bands, 1, cosines, sines, weights);
    return status;
}

/* Evaluates `count` suns from arrays, one an axis, and one of azimuths (or none, where the table
   fixes it); returns the largest status. */
static inline int skylight_sh_4_bands_1_5pct_packed_evaluate_batch(
    int count, const float *const inputs[SKYLIGHT_SH_4_BANDS_1_5PCT_PACKED_AXES],
        const float *azimuths,
    float
        (*weights)[SKYLIGHT_SH_4_BANDS_1_5PCT_PACKED_CHANNELS]
        [SKYLIGHT_SH_4_BANDS_1_5PCT_PACKED_WEIGHTS])
{
    int s, axis, worst = 0;
    for (s = 0; s < count; ++s) {
        const float azimuth = azimuths ? azimuths[s] : SKYLIGHT_SH_4_BANDS_1_5PCT_PACKED_AZIMUTH;
        float sun[SKYLIGHT_SH_4_BANDS_1_5PCT_PACKED_AXES];
        int status;
        for (axis = 0; axis < SKYLIGHT_SH_4_BANDS_1_5PCT_PACKED_AXES; ++axis) sun[axis] =
            inputs[axis][s];
        status = skylight_sh_4_bands_1_5pct_packed_evaluate(sun, azimuth,
            SKYLIGHT_SH_4_BANDS_1_5PCT_PACKED_BANDS, weights[s]);
        worst = status > worst ? status : worst;
    }
    return worst;
}

/* All products of `count` numbers and `size` functions, the functions' place fastest; returns how
   many. */
static inline int skylight_sh_4_bands_1_5pct_packed_multiply(double *products, int count,
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
static inline int skylight_sh_4_bands_1_5pct_packed_evaluate_gradient(
    const float inputs[SKYLIGHT_SH_4_BANDS_1_5PCT_PACKED_AXES], float azimuth,
    float
        weights[SKYLIGHT_SH_4_BANDS_1_5PCT_PACKED_CHANNELS]
        [SKYLIGHT_SH_4_BANDS_1_5PCT_PACKED_WEIGHTS],
    float
        gradient[SKYLIGHT_SH_4_BANDS_1_5PCT_PACKED_AXES][SKYLIGHT_SH_4_BANDS_1_5PCT_PACKED_CHANNELS]
        [SKYLIGHT_SH_4_BANDS_1_5PCT_PACKED_WEIGHTS])
{
    static const int sizes[SKYLIGHT_SH_4_BANDS_1_5PCT_PACKED_AXES] =
        SKYLIGHT_SH_4_BANDS_1_5PCT_PACKED_SIZES;
    double x[SKYLIGHT_SH_4_BANDS_1_5PCT_PACKED_AXES],
        functions[SKYLIGHT_SH_4_BANDS_1_5PCT_PACKED_AXES][SKYLIGHT_SH_4_BANDS_1_5PCT_PACKED_MOST];
    double slopes[SKYLIGHT_SH_4_BANDS_1_5PCT_PACKED_AXES][SKYLIGHT_SH_4_BANDS_1_5PCT_PACKED_MOST],
        scale[1 + SKYLIGHT_SH_4_BANDS_1_5PCT_PACKED_AXES];
    skylight_sh_4_bands_1_5pct_packed_real cosines[SKYLIGHT_SH_4_BANDS_1_5PCT_PACKED_BANDS],
        sines[SKYLIGHT_SH_4_BANDS_1_5PCT_PACKED_BANDS];
    int axis, other, i;
    const int status = skylight_sh_4_bands_1_5pct_packed_evaluate(inputs, azimuth,
        SKYLIGHT_SH_4_BANDS_1_5PCT_PACKED_BANDS, weights);
    if (status == 2) {
        memset(gradient, 0,
               sizeof(float) * SKYLIGHT_SH_4_BANDS_1_5PCT_PACKED_AXES *
                   SKYLIGHT_SH_4_BANDS_1_5PCT_PACKED_CHANNELS *
                   SKYLIGHT_SH_4_BANDS_1_5PCT_PACKED_WEIGHTS);
        return 2;
    }
    for (axis = 0; axis < SKYLIGHT_SH_4_BANDS_1_5PCT_PACKED_AXES; ++axis) {
        const double low = skylight_sh_4_bands_1_5pct_packed_slope_range[axis][0];
        const double high = skylight_sh_4_bands_1_5pct_packed_slope_range[axis][1];
        const double v = (double)skylight_sh_4_bands_1_5pct_packed_finite(inputs[axis]);
        x[axis] = v < low ? low : v > high ? high : v;
        skylight_sh_4_bands_1_5pct_packed_functions(axis, x[axis], functions[axis], slopes[axis]);
    }
    skylight_sh_4_bands_1_5pct_packed_scale_slopes(x, scale);
    for (i = 0; i < 1 + SKYLIGHT_SH_4_BANDS_1_5PCT_PACKED_AXES; ++i) scale[i] *=
        (double)SKYLIGHT_SH_4_BANDS_1_5PCT_PACKED_EXPOSURE;
    skylight_sh_4_bands_1_5pct_packed_waves((skylight_sh_4_bands_1_5pct_packed_real)azimuth,
        cosines, sines);
    for (axis = 0; axis < SKYLIGHT_SH_4_BANDS_1_5PCT_PACKED_AXES; ++axis) {
        double first[SKYLIGHT_SH_4_BANDS_1_5PCT_PACKED_MOST],
            others[SKYLIGHT_SH_4_BANDS_1_5PCT_PACKED_OTHERS];
        int count = 1;
        others[0] = 1.0;
        for (other = 0; other < SKYLIGHT_SH_4_BANDS_1_5PCT_PACKED_AXES; ++other) {
            double one[SKYLIGHT_SH_4_BANDS_1_5PCT_PACKED_MOST];
            for (i = 0; i < sizes[other]; ++i) {
                one[i] = functions[other][i];
                if (other == axis) one[i] = scale[0] * slopes[axis][i] + scale[1 + axis] * one[i];
                if (other == 0) first[i] = one[i];
            }
            if (other) count = skylight_sh_4_bands_1_5pct_packed_multiply(others, count, one,
                sizes[other]);
        }
        skylight_sh_4_bands_1_5pct_packed_combine_double(first, others, cosines, sines,
            gradient[axis]);
        skylight_sh_4_bands_1_5pct_packed_finish(SKYLIGHT_SH_4_BANDS_1_5PCT_PACKED_BANDS, 0,
            cosines, sines, gradient[axis]);
    }
    return status;
}

SKYLIGHT_SH_4_BANDS_1_5PCT_PACKED_API int skylight_sh_4_bands_1_5pct_packed_weights(float
    sun_zenith, float sun_azimuth, float turbidity,
    float
    weights[SKYLIGHT_SH_4_BANDS_1_5PCT_PACKED_CHANNELS][SKYLIGHT_SH_4_BANDS_1_5PCT_PACKED_WEIGHTS])
{
    const float skylight_sh_4_bands_1_5pct_packed_given[SKYLIGHT_SH_4_BANDS_1_5PCT_PACKED_AXES] = {
        sun_zenith, turbidity };
    return skylight_sh_4_bands_1_5pct_packed_evaluate(skylight_sh_4_bands_1_5pct_packed_given,
        sun_azimuth, SKYLIGHT_SH_4_BANDS_1_5PCT_PACKED_BANDS, weights);
}

SKYLIGHT_SH_4_BANDS_1_5PCT_PACKED_API int skylight_sh_4_bands_1_5pct_packed_weights_bands(float
    sun_zenith, float sun_azimuth, float turbidity, int bands,
    float
    weights[SKYLIGHT_SH_4_BANDS_1_5PCT_PACKED_CHANNELS][SKYLIGHT_SH_4_BANDS_1_5PCT_PACKED_WEIGHTS])
{
    const float skylight_sh_4_bands_1_5pct_packed_given[SKYLIGHT_SH_4_BANDS_1_5PCT_PACKED_AXES] = {
        sun_zenith, turbidity };
    return skylight_sh_4_bands_1_5pct_packed_evaluate(skylight_sh_4_bands_1_5pct_packed_given,
        sun_azimuth, bands, weights);
}

SKYLIGHT_SH_4_BANDS_1_5PCT_PACKED_API int skylight_sh_4_bands_1_5pct_packed_weights_batch(int count,
    const float *sun_zenith, const float *sun_azimuth, const float *turbidity,
    float
    (*weights)[SKYLIGHT_SH_4_BANDS_1_5PCT_PACKED_CHANNELS]
    [SKYLIGHT_SH_4_BANDS_1_5PCT_PACKED_WEIGHTS])
{
    const float *const
        skylight_sh_4_bands_1_5pct_packed_given[SKYLIGHT_SH_4_BANDS_1_5PCT_PACKED_AXES] = {
        sun_zenith, turbidity };
    return skylight_sh_4_bands_1_5pct_packed_evaluate_batch(count,
        skylight_sh_4_bands_1_5pct_packed_given, sun_azimuth, weights);
}

SKYLIGHT_SH_4_BANDS_1_5PCT_PACKED_API int skylight_sh_4_bands_1_5pct_packed_weights_gradient(float
    sun_zenith, float sun_azimuth, float turbidity,
    float
    weights[SKYLIGHT_SH_4_BANDS_1_5PCT_PACKED_CHANNELS][SKYLIGHT_SH_4_BANDS_1_5PCT_PACKED_WEIGHTS],
    float
    gradient[SKYLIGHT_SH_4_BANDS_1_5PCT_PACKED_AXES][SKYLIGHT_SH_4_BANDS_1_5PCT_PACKED_CHANNELS]
    [SKYLIGHT_SH_4_BANDS_1_5PCT_PACKED_WEIGHTS])
{
    const float skylight_sh_4_bands_1_5pct_packed_given[SKYLIGHT_SH_4_BANDS_1_5PCT_PACKED_AXES] = {
        sun_zenith, turbidity };
    return
        skylight_sh_4_bands_1_5pct_packed_evaluate_gradient(skylight_sh_4_bands_1_5pct_packed_given,
        sun_azimuth, weights, gradient);
}

/* The dominant light's direction, a unit vector: where the linear part of the weights, summed over
   channels by luminance, points. Returns 0, or 1 (and straight up) where it points nowhere. */
SKYLIGHT_SH_4_BANDS_1_5PCT_PACKED_API int skylight_sh_4_bands_1_5pct_packed_dominant_of(const float
    *weights, float direction[3])
{
    static const float luminance[SKYLIGHT_SH_4_BANDS_1_5PCT_PACKED_CHANNELS] =
        SKYLIGHT_SH_4_BANDS_1_5PCT_PACKED_LUMINANCE;
    float x = 0.0f, y = 0.0f, z = 0.0f, length;
    int channel;
    for (channel = 0; channel < SKYLIGHT_SH_4_BANDS_1_5PCT_PACKED_CHANNELS; ++channel) {
        const float *const linear = weights + channel * SKYLIGHT_SH_4_BANDS_1_5PCT_PACKED_WEIGHTS +
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
SKYLIGHT_SH_4_BANDS_1_5PCT_PACKED_API void skylight_sh_4_bands_1_5pct_packed_ground(
    const float albedo[SKYLIGHT_SH_4_BANDS_1_5PCT_PACKED_CHANNELS],
    float
        weights[SKYLIGHT_SH_4_BANDS_1_5PCT_PACKED_CHANNELS]
        [SKYLIGHT_SH_4_BANDS_1_5PCT_PACKED_WEIGHTS])
{
    static const float lower[SKYLIGHT_SH_4_BANDS_1_5PCT_PACKED_BANDS] =
        SKYLIGHT_SH_4_BANDS_1_5PCT_PACKED_LOWER;
    int l, channel;
    for (channel = 0; channel < SKYLIGHT_SH_4_BANDS_1_5PCT_PACKED_CHANNELS; ++channel) {
        const float radiance = albedo[channel] * SKYLIGHT_SH_4_BANDS_1_5PCT_PACKED_REFLECTED *
            weights[channel][2];
        for (l = 0; l < SKYLIGHT_SH_4_BANDS_1_5PCT_PACKED_BANDS; ++l) weights[channel][l * (l + 1)]
            += radiance * lower[l];
    }
}

/* Tames the ringing of the horizon in the first `bands` bands by the zonal window sinc(pi l /
   bands) (Habel et al. 2008, eq. 5). */
SKYLIGHT_SH_4_BANDS_1_5PCT_PACKED_API void skylight_sh_4_bands_1_5pct_packed_window(
    int bands, float
        weights[SKYLIGHT_SH_4_BANDS_1_5PCT_PACKED_CHANNELS]
        [SKYLIGHT_SH_4_BANDS_1_5PCT_PACKED_WEIGHTS])
{
    int l, channel;
    for (l = 1; l < bands && l < SKYLIGHT_SH_4_BANDS_1_5PCT_PACKED_BANDS; ++l) {
        const float factor = skylight_sh_4_bands_1_5pct_packed_sinc((float)l / (float)bands);
        for (channel = 0; channel < SKYLIGHT_SH_4_BANDS_1_5PCT_PACKED_CHANNELS; ++channel)
            weights[channel][l * (l + 1)] *= factor;
    }
}

#endif /* SKYLIGHT_SH_4_BANDS_1_5PCT_PACKED_DEFINED */
