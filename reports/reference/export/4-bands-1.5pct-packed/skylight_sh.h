/* Preetham sky (published constants, srgb): spherical-harmonics weights, evaluated from polynomials.
 *
 * Written by skylight-sh 0.1.0; the table and this code may be used by anyone for anything (CC0-1.0).
 * C99 and C++11, header only, no allocation, no global written, nothing static but constants: any thread may call it.
 *
 * Usage
 *   float w[SKYLIGHT_SH_CHANNELS][SKYLIGHT_SH_WEIGHTS];
 *   int status = skylight_sh_weights(0.785000026f, 0.0f, 4.25f, w);
 *
 * Inputs
 *   sun_zenith: [0, 1.57079633] rad
 *   turbidity: [2.5, 6]
 *   sun_azimuth: any finite angle, rad
 * Output
 *   w[channel][l*(l+1)+m], channels red, green, blue: linear radiance, luminance-scaled cd/m2. Real orthonormal spherical
 *   harmonics without the Condon-Shortley sign, z up, m > 0 cosine, m < 0 sine; the azimuth turns from +x towards +y.
 *   Below the horizon: black. Returns 0; 1 where an input lay outside its range and was clamped; 2 (weights zeroed) where
 *   one was NaN or the azimuth infinite.
 *   The glow about the sun is in the weights, its disc is not: with a disc of your own, add no halo.
 *   Define SKYLIGHT_SH_EXPOSURE before this file to multiply all weights (1 by default).
 *
 * Accuracy, as shipped: E_mean 1.45 %, E_max 3.9 % of the least luminance of the same sky, at azimuth 0.
 * The expansion rings: the least value it takes, over all directions and measured sets, is -12.5 % of its largest
 * in the same set; the window below tames it.
 * Memory: 689 bytes of constants, packed into few bytes (a fast table takes more and less time).
 *
 * Provenance
 *   skylight-sh 0.1.0, config preetham 7738be1e848979ca, table 4-bands-1.5pct-packed
 */
#ifndef SKYLIGHT_SH_H
#define SKYLIGHT_SH_H

#include <math.h>
#include <stdint.h>
#include <string.h>

#define SKYLIGHT_SH_VERSION "0.1.0"
#define SKYLIGHT_SH_BANDS 4
#define SKYLIGHT_SH_WEIGHTS 16
#define SKYLIGHT_SH_CHANNELS 3
#define SKYLIGHT_SH_AXES 2
#define SKYLIGHT_SH_UNIT "cd/m2"
#define SKYLIGHT_SH_E_MEAN 1.451000e-02
#define SKYLIGHT_SH_E_MAX 3.899000e-02
#define SKYLIGHT_SH_SUN_ZENITH_MIN 0.0f
#define SKYLIGHT_SH_SUN_ZENITH_MAX 1.57079637f
#define SKYLIGHT_SH_TURBIDITY_MIN 2.5f
#define SKYLIGHT_SH_TURBIDITY_MAX 6.0f
#ifndef SKYLIGHT_SH_EXPOSURE
#define SKYLIGHT_SH_EXPOSURE 1
#endif

typedef float skylight_sh_real;

/* Whole numbers as Rice codes, read in one forward loop. */
static const unsigned char skylight_sh_stream[497] = {
    103, 66, 182, 144, 24, 255, 111, 226, 100, 100, 82, 154, 249, 223, 92, 89, 186, 229, 240, 63, 3, 220, 222, 75,
    49, 254, 191, 97, 40, 187, 67, 1, 242, 111, 118, 93, 157, 224, 39, 151, 57, 244, 255, 78, 148, 93, 91, 209,
    145, 94, 255, 63, 222, 23, 61, 49, 252, 46, 255, 111, 107, 250, 41, 238, 251, 31, 136, 110, 142, 132, 46, 161,
    33, 156, 55, 101, 6, 160, 226, 198, 42, 104, 44, 41, 10, 110, 251, 198, 180, 158, 175, 37, 248, 68, 212, 198,
    190, 4, 98, 86, 93, 132, 113, 72, 44, 177, 226, 84, 226, 50, 237, 235, 229, 60, 126, 205, 236, 30, 26, 228,
    62, 158, 222, 72, 241, 24, 215, 41, 136, 192, 63, 78, 167, 133, 69, 64, 54, 12, 226, 149, 229, 74, 8, 27,
    68, 180, 134, 17, 35, 138, 252, 136, 6, 72, 98, 26, 78, 39, 96, 128, 4, 68, 39, 229, 93, 58, 96, 208,
    30, 80, 7, 62, 167, 208, 8, 53, 118, 5, 144, 39, 188, 76, 55, 32, 99, 111, 6, 187, 171, 192, 176, 90,
    236, 201, 206, 9, 118, 19, 113, 219, 76, 170, 213, 67, 140, 246, 14, 59, 174, 85, 211, 71, 88, 210, 32, 218,
    179, 238, 129, 129, 235, 30, 76, 58, 165, 173, 115, 184, 252, 177, 43, 162, 144, 96, 161, 139, 216, 220, 40, 239,
    60, 70, 45, 20, 183, 107, 2, 169, 192, 88, 8, 209, 193, 209, 251, 20, 120, 59, 110, 0, 241, 105, 191, 175,
    14, 27, 174, 62, 128, 44, 252, 224, 157, 151, 33, 135, 27, 162, 45, 194, 146, 142, 78, 153, 197, 163, 94, 15,
    162, 208, 200, 16, 175, 241, 97, 58, 120, 67, 38, 88, 153, 98, 19, 81, 1, 165, 112, 121, 42, 96, 255, 160,
    215, 216, 66, 37, 0, 215, 243, 29, 230, 102, 236, 168, 69, 191, 51, 27, 111, 80, 212, 174, 93, 202, 45, 15,
    34, 175, 195, 48, 247, 194, 164, 30, 131, 227, 246, 222, 125, 172, 184, 247, 224, 232, 189, 56, 155, 104, 165, 162,
    195, 145, 163, 233, 230, 243, 174, 7, 51, 119, 184, 99, 34, 172, 75, 41, 47, 158, 201, 78, 81, 152, 6, 104,
    141, 229, 243, 84, 157, 5, 58, 237, 97, 233, 75, 166, 163, 167, 89, 2, 21, 106, 142, 119, 215, 9, 114, 193,
    78, 162, 227, 173, 139, 243, 197, 158, 89, 164, 56, 213, 102, 241, 72, 10, 29, 88, 144, 67, 82, 35, 69, 19,
    114, 177, 109, 166, 17, 145, 10, 75, 93, 83, 15, 246, 9, 62, 108, 95, 69, 180, 20, 128, 134, 96, 101, 173,
    202, 103, 236, 31, 252, 167, 209, 85, 40, 30, 56, 38, 122, 12, 35, 4, 216, 108, 86, 51, 193, 24, 130, 5,
    48, 231, 17, 224, 68, 229, 233, 67, 217, 44, 36, 16, 71, 166, 44, 80, 0
};

typedef struct { const unsigned char *next; uint64_t held; int count; } skylight_sh_bits;

static inline void skylight_sh_fill(skylight_sh_bits *b)
{
    const unsigned char *const end = skylight_sh_stream + sizeof skylight_sh_stream;
    while (b->count <= 56 && b->next < end) {
        b->held |= (uint64_t)*b->next++ << b->count;
        b->count += 8;
    }
}

/* `width` bits, at most 31, as a number. */
static inline unsigned skylight_sh_fixed(skylight_sh_bits *b, int width)
{
    unsigned value;
    if (b->count < 32) skylight_sh_fill(b);
    value = (unsigned)(b->held & ((UINT64_C(1) << width) - 1));
    b->held >>= width;
    b->count -= width;
    return value;
}

/* A Rice code of `low` low bits: ones, a zero, the low bits; then folded back: 0, 1, 2, 3 -> 0, -1, 1, -2. */
static inline int skylight_sh_rice(skylight_sh_bits *b, int low)
{
    unsigned high = 0, folded;
    if (b->count < 32) skylight_sh_fill(b);
    while (b->held & 1) {
        ++high;
        b->held >>= 1;
        if (--b->count < 1) skylight_sh_fill(b);
    }
    b->held >>= 1;
    --b->count;
    folded = (high << low) | skylight_sh_fixed(b, low);
    return folded & 1 ? -(int)(folded >> 1) - 1 : (int)(folded >> 1);
}

/* Reads the stream once, forward, and stores the first `bands` bands, turned by the azimuth. */
static inline void skylight_sh_combine(const skylight_sh_real *t0, const skylight_sh_real *rest, const skylight_sh_real *wave_cos, const skylight_sh_real *wave_sin, int bands, float weights[SKYLIGHT_SH_CHANNELS][SKYLIGHT_SH_WEIGHTS])
{
    static const signed char rest_profile[5] = { 4, 1, -4, -9, -12 };
    static const signed char channel_profile[3] = { -3, -3, -2 };
    signed char lengths[SKYLIGHT_SH_CHANNELS][5];
    int profile[32], i, l, m, channel, r;
    skylight_sh_bits bits;
    bits.next = skylight_sh_stream;
    bits.held = 0;
    bits.count = 0;
    memset(lengths, 0, sizeof lengths);
    for (i = 0; i < 32; ++i) profile[i] = 0;
    for (l = 0; l < bands; ++l) {
        const int used = (int)skylight_sh_fixed(&bits, 5);
        for (i = 0; i < used; ++i) profile[i] = (int)skylight_sh_fixed(&bits, 5);
        for (m = 0; m <= l; ++m) {
            for (channel = 0; channel < SKYLIGHT_SH_CHANNELS; ++channel) {
                skylight_sh_real value = 0;
                for (r = 0; r < 5; ++r) {
                    const int level = rest_profile[r] + channel_profile[channel];
                    const int length = lengths[channel][r] + skylight_sh_rice(&bits, 0);
                    skylight_sh_real sum = 0;
                    lengths[channel][r] = (signed char)length;
                    for (i = 0; i < length; ++i) {
                        const int size = profile[i] + level;
                        const int number = skylight_sh_rice(&bits, size > 0 ? size >> 1 : 0);
                        sum += t0[i] * (skylight_sh_real)number;
                    }
                    value += sum * rest[r];
                }
                value *= 0.00204467773f;
                weights[channel][l * (l + 1) - m] = (float)(value * wave_sin[m]);
                weights[channel][l * (l + 1) + m] = (float)(value * wave_cos[m]);
            }
        }
    }
    (void)wave_cos;
    (void)wave_sin;
}


/* 0 for a finite number, 1 for an infinity, 2 for NaN: by its bits, so that -ffast-math cannot remove the test. */
static inline int skylight_sh_kind(float v)
{
    uint32_t bits;
    memcpy(&bits, &v, sizeof bits);
    bits &= 0x7fffffffu;
    return (bits >= 0x7f800000u) + (bits > 0x7f800000u);
}

/* Clamps v to [low, high]; *status becomes 1 where v is not in [first, last]. An infinity is made finite by its sign bit. */
static inline skylight_sh_real skylight_sh_clamp(float v, float first, float last, skylight_sh_real low, skylight_sh_real high, int *status)
{
    skylight_sh_real x;
    if (skylight_sh_kind(v)) {
        uint32_t bits;
        memcpy(&bits, &v, sizeof bits);
        v = bits >> 31 ? -3e38f : 3e38f;
    }
    *status |= (v < first) | (v > last);
    x = (skylight_sh_real)v;
    x = x < low ? low : x;
    return x > high ? high : x;
}




/* sun_zenith in the fit's variable: reciprocal. */
static inline skylight_sh_real skylight_sh_map_0(skylight_sh_real v)
{
    return 4.36619759f * (v - 0.0f) / (5.0f - v) - 1.0f;
}

/* turbidity in the fit's variable: reciprocal. */
static inline skylight_sh_real skylight_sh_map_1(skylight_sh_real v)
{
    return (-4.57142878f) * (v - 2.5f) / ((-2.0f) - v) - 1.0f;
}

/* What all weights share: the closed form preetham_zenith. */
static inline skylight_sh_real skylight_sh_scale(skylight_sh_real x0, skylight_sh_real x1)
{
    const float chi = (0.444444448f - x1 * 0.00833333377f) * (3.14159274f - 2.0f * x0);
    const float square = chi * chi;
    const float tan_above = chi * (105.0f - 10.0f * square);
    const float tan_below = 105.0f - square * (45.0f - square);
    const float zenith = (4.04530001f * x1 - 4.97100019f) * tan_above + (2.41919994f - 0.215499997f * x1) * tan_below;
    const float a = 0.1787f * x1 + (-1.46300006f);
    const float b = (-0.355399996f) * x1 + 0.42750001f;
    const float up = 1.0f + b * (0.25f + b * 0.03125f);
    const float up2 = up * up;
    const float up4 = up2 * up2;
    const float c = (-0.0227000006f) * x1 + 5.32509995f;
    const float d = 0.1206f * x1 + (-2.57710004f);
    const float y = d * x0;
    const float halo = 1.0f + y * (0.125f + y * 0.0078125f);
    const float halo2 = halo * halo;
    const float halo4 = halo2 * halo2;
    const float halo8 = halo4 * halo4;
    const float e = (-0.0670000017f) * x1 + 0.370299995f;
    const float z = x0 * x0;
    const float cosine = 1.0f - z * (0.5f - z * (0.0416666679f - z * 0.00138888892f));
    return 1000.0f * zenith / (tan_below * (1.0f + a * up4) * (1.0f + c * halo8 + e * (cosine * cosine)));
}




/* sun_zenith in the fit's variable: reciprocal, in double for the gradient. */
static inline double skylight_sh_wide_map_0(double v)
{
    return 4.366197723675814 * (v - 0.0) / (5.0 - v) - 1.0;
}

/* turbidity in the fit's variable: reciprocal, in double for the gradient. */
static inline double skylight_sh_wide_map_1(double v)
{
    return (-4.5714285714285712) * (v - 2.5) / ((-2.0) - v) - 1.0;
}

/* What all weights share: the closed form preetham_zenith. */
static inline double skylight_sh_wide_scale(double x0, double x1)
{
    const double chi = (0.44444444444444442 - x1 * 0.0083333333333333332) * (3.1415926535897931 - 2.0 * x0);
    const double square = chi * chi;
    const double tan_above = chi * (105.0 - 10.0 * square);
    const double tan_below = 105.0 - square * (45.0 - square);
    const double zenith = (4.0453000000000001 * x1 - 4.9710000000000001) * tan_above + (2.4192 - 0.2155 * x1) * tan_below;
    const double a = 0.1787 * x1 + (-1.4630000000000001);
    const double b = (-0.35539999999999999) * x1 + 0.42749999999999999;
    const double up = 1.0 + b * (0.25 + b * 0.03125);
    const double up2 = up * up;
    const double up4 = up2 * up2;
    const double c = (-0.022700000000000001) * x1 + 5.3250999999999999;
    const double d = 0.1206 * x1 + (-2.5771000000000002);
    const double y = d * x0;
    const double halo = 1.0 + y * (0.125 + y * 0.0078125);
    const double halo2 = halo * halo;
    const double halo4 = halo2 * halo2;
    const double halo8 = halo4 * halo4;
    const double e = (-0.067000000000000004) * x1 + 0.37030000000000002;
    const double z = x0 * x0;
    const double cosine = 1.0 - z * (0.5 - z * (0.041666666666666664 - z * 0.0013888888888888889));
    return 1000.0 * zenith / (tan_below * (1.0 + a * up4) * (1.0 + c * halo8 + e * (cosine * cosine)));
}

/* The basis of the first axis, `t` of 8, zero where the table has no term. */
static inline void skylight_sh_first(skylight_sh_real x, skylight_sh_real *t)
{
    const skylight_sh_real u = skylight_sh_map_0(x);
    int i;
    for (i = 0; i < 8; ++i) t[i] = 0;
    t[0] = 1.0f;
    t[1] = u;
    t[2] = 2.0f * t[1] * t[1] - 1.0f;
    t[3] = 2.0f * t[1] * t[2] - t[1];
    t[4] = 2.0f * t[2] * t[2] - 1.0f;
    t[5] = 2.0f * t[2] * t[3] - t[1];
    t[6] = 2.0f * t[3] * t[3] - 1.0f;
    t[7] = 2.0f * t[3] * t[4] - t[1];
    (void)u;
}

/* All products of the other axes' bases, `rest` of 5. */
static inline void skylight_sh_rest(skylight_sh_real x1, skylight_sh_real *rest)
{
    int r = 0;
    skylight_sh_real t1[8];
    int i1;
    {
        const skylight_sh_real u = skylight_sh_map_1(x1);
        skylight_sh_real *t = t1;
        t[0] = 1.0f;
        t[1] = u;
        t[2] = 2.0f * t[1] * t[1] - 1.0f;
        t[3] = 2.0f * t[1] * t[2] - t[1];
        t[4] = 2.0f * t[2] * t[2] - 1.0f;
        (void)u;
    }
    for (i1 = 0; i1 < 5; ++i1)
        rest[r++] = t1[i1];
}

/* cos(m azimuth) and sin(m azimuth) for m < bands, by doubling: m = h + k. */
static inline void skylight_sh_waves(skylight_sh_real azimuth, skylight_sh_real *wave_cos, skylight_sh_real *wave_sin)
{
    int m;
    wave_cos[0] = 1;
    wave_sin[0] = 0;
    wave_cos[1] = cosf(azimuth);
    wave_sin[1] = sinf(azimuth);
    for (m = 2; m < SKYLIGHT_SH_BANDS; ++m) {
        const int h = m / 2, k = m - h;
        wave_cos[m] = wave_cos[h] * wave_cos[k] - wave_sin[h] * wave_sin[k];
        wave_sin[m] = wave_sin[h] * wave_cos[k] + wave_cos[h] * wave_sin[k];
    }
    (void)azimuth;
}

/* Zeroes bands that were not asked for. */
static inline void skylight_sh_finish(int bands, const skylight_sh_real *wave_cos, const skylight_sh_real *wave_sin, float weights[SKYLIGHT_SH_CHANNELS][SKYLIGHT_SH_WEIGHTS])
{
    int channel, i;
    if (bands < SKYLIGHT_SH_BANDS) {
        for (channel = 0; channel < SKYLIGHT_SH_CHANNELS; ++channel)
            for (i = bands * bands; i < SKYLIGHT_SH_WEIGHTS; ++i) weights[channel][i] = 0.0f;
    }
    (void)wave_cos;
    (void)wave_sin;
}

/* Checks and clamps the inputs into x; returns the status. */
static inline int skylight_sh_inputs(float sun_zenith, float sun_azimuth, float turbidity, skylight_sh_real x[SKYLIGHT_SH_AXES])
{
    int status = 0;
    if (skylight_sh_kind(sun_azimuth) | skylight_sh_kind(sun_zenith) | skylight_sh_kind(turbidity)) {
        if (skylight_sh_kind(sun_azimuth) != 0 || skylight_sh_kind(sun_zenith) == 2 || skylight_sh_kind(turbidity) == 2) return 2;
    }
    x[0] = skylight_sh_clamp(sun_zenith, -1.57079626e-06f, 1.5707978f, 0.0f, 1.57079637f, &status);
    x[1] = skylight_sh_clamp(turbidity, 2.49999666f, 6.00000334f, 2.5f, 6.0f, &status);
    return status;
}

/* Evaluates the first `bands` bands (1 to SKYLIGHT_SH_BANDS, clamped likewise) and zeroes the rest. */
static inline int skylight_sh_weights_bands(float sun_zenith, float sun_azimuth, float turbidity, int bands, float weights[SKYLIGHT_SH_CHANNELS][SKYLIGHT_SH_WEIGHTS])
{
    skylight_sh_real x[SKYLIGHT_SH_AXES], t0[8], rest[5], wave_cos[SKYLIGHT_SH_BANDS], wave_sin[SKYLIGHT_SH_BANDS], scale;
    int i, status = skylight_sh_inputs(sun_zenith, sun_azimuth, turbidity, x);
    if (status == 2) {
        memset(weights, 0, sizeof(float) * SKYLIGHT_SH_CHANNELS * SKYLIGHT_SH_WEIGHTS);
        return 2;
    }
    if (bands < 1) { bands = 1; status = 1; }
    if (bands > SKYLIGHT_SH_BANDS) { bands = SKYLIGHT_SH_BANDS; status = 1; }
    scale = skylight_sh_scale(x[0], x[1]) * (skylight_sh_real)SKYLIGHT_SH_EXPOSURE;
    skylight_sh_first(x[0], t0);
    skylight_sh_rest(x[1], rest);
    for (i = 0; i < 5; ++i) rest[i] *= scale;
    skylight_sh_waves((skylight_sh_real)sun_azimuth, wave_cos, wave_sin);
    skylight_sh_combine(t0, rest, wave_cos, wave_sin, bands, weights);
    skylight_sh_finish(bands, wave_cos, wave_sin, weights);
    return status;
}

/* Evaluates all bands. */
static inline int skylight_sh_weights(float sun_zenith, float sun_azimuth, float turbidity, float weights[SKYLIGHT_SH_CHANNELS][SKYLIGHT_SH_WEIGHTS])
{
    return skylight_sh_weights_bands(sun_zenith, sun_azimuth, turbidity, SKYLIGHT_SH_BANDS, weights);
}

/* Evaluates `count` suns from arrays; returns the largest status. No faster than single calls. */
static inline int skylight_sh_weights_batch(int count, const float *sun_zenith, const float *sun_azimuth, const float *turbidity, float (*weights)[SKYLIGHT_SH_CHANNELS][SKYLIGHT_SH_WEIGHTS])
{
    int s, worst = 0;
    for (s = 0; s < count; ++s) {
        const int status = skylight_sh_weights(sun_zenith[s], sun_azimuth[s], turbidity[s], weights[s]);
        worst = status > worst ? status : worst;
    }
    return worst;
}

/* Evaluates all bands and their derivatives after each axis (sun_zenith, turbidity), per unit of the axis; beyond a range, those at its edge. */
static inline int skylight_sh_weights_gradient(float sun_zenith, float sun_azimuth, float turbidity, float weights[SKYLIGHT_SH_CHANNELS][SKYLIGHT_SH_WEIGHTS], float gradient[SKYLIGHT_SH_AXES][SKYLIGHT_SH_CHANNELS][SKYLIGHT_SH_WEIGHTS])
{
    static const double low[SKYLIGHT_SH_AXES] = { 0.0, 2.5 }, high[SKYLIGHT_SH_AXES] = { 1.5707963267948966, 6.0 };
    skylight_sh_real x[SKYLIGHT_SH_AXES], t0[8], rest[5], wave_cos[SKYLIGHT_SH_BANDS], wave_sin[SKYLIGHT_SH_BANDS], scale;
    double from[SKYLIGHT_SH_AXES], slope[SKYLIGHT_SH_AXES], grown[SKYLIGHT_SH_AXES];
    int i, a, status = skylight_sh_inputs(sun_zenith, sun_azimuth, turbidity, x);
    if (status == 2) {
        memset(weights, 0, sizeof(float) * SKYLIGHT_SH_CHANNELS * SKYLIGHT_SH_WEIGHTS);
        memset(gradient, 0, sizeof(float) * SKYLIGHT_SH_AXES * SKYLIGHT_SH_CHANNELS * SKYLIGHT_SH_WEIGHTS);
        return 2;
    }
    scale = skylight_sh_scale(x[0], x[1]) * (skylight_sh_real)SKYLIGHT_SH_EXPOSURE;
    skylight_sh_waves((skylight_sh_real)sun_azimuth, wave_cos, wave_sin);
    for (a = 0; a < SKYLIGHT_SH_AXES; ++a) from[a] = (double)x[a];
    /* Slopes of the map and of the logarithm of the scale, by central differences in double. At an edge the middle stays
       h inside, which costs the slope up to 2.2e-4 of the axis's largest. */
    for (a = 0; a < SKYLIGHT_SH_AXES; ++a) {
        const double h = 1e-5 * (high[a] - low[a]), middle = from[a];
        double above[2], logarithm[2];
        from[a] = middle < low[a] + h ? low[a] + h : middle > high[a] - h ? high[a] - h : middle;
        for (i = 0; i < 2; ++i) {
            from[a] += i ? 2.0 * h : -h;
            logarithm[i] = log(fabs(skylight_sh_wide_scale(from[0], from[1])));
            above[i] = a == 0 ? skylight_sh_wide_map_0(from[a]) : skylight_sh_wide_map_1(from[a]);
        }
        slope[a] = (above[1] - above[0]) / (2.0 * h);
        grown[a] = (logarithm[1] - logarithm[0]) / (2.0 * h);
        from[a] = middle;
    }
    for (a = -1; a < SKYLIGHT_SH_AXES; ++a) {
        float(*out)[SKYLIGHT_SH_WEIGHTS] = a < 0 ? weights : gradient[a];
        skylight_sh_first(x[0], t0);
        if (a == 0) {
            /* T'(i) = 2 T(i-1) + 2 u T'(i-1) - T'(i-2). */
            skylight_sh_real d[8];
            d[0] = 0;
            d[1] = 1;
            for (i = 2; i < 8; ++i) d[i] = 2 * t0[i - 1] + 2 * t0[1] * d[i - 1] - d[i - 2];
            for (i = 0; i < 8; ++i) t0[i] = (skylight_sh_real)grown[0] * t0[i] + (skylight_sh_real)slope[0] * d[i];
        }
        if (a < 1) skylight_sh_rest(x[1], rest);
        else {
            int r = 0;
            skylight_sh_real t1[8], d1[8];
            int i1;
            t1[0] = 1;
            t1[1] = skylight_sh_map_1(x[1]);
            d1[0] = 0;
            d1[1] = 1;
            for (i = 2; i < 5; ++i) {
                t1[i] = 2 * t1[1] * t1[i - 1] - t1[i - 2];
                d1[i] = 2 * t1[i - 1] + 2 * t1[1] * d1[i - 1] - d1[i - 2];
            }
            if (a == 1)
                for (i = 0; i < 5; ++i) t1[i] = (skylight_sh_real)grown[1] * t1[i] + (skylight_sh_real)slope[1] * d1[i];
            for (i1 = 0; i1 < 5; ++i1)
                rest[r++] = t1[i1];
        }
        for (i = 0; i < 5; ++i) rest[i] *= scale;
        skylight_sh_combine(t0, rest, wave_cos, wave_sin, SKYLIGHT_SH_BANDS, out);
        skylight_sh_finish(SKYLIGHT_SH_BANDS, wave_cos, wave_sin, out);
    }
    return status;
}


/* Unit vector of the dominant light: where the linear part of the weights, summed over channels by luminance, points. Returns 0, or 1 (and straight up) where it points nowhere. */
static inline int skylight_sh_dominant(float weights[SKYLIGHT_SH_CHANNELS][SKYLIGHT_SH_WEIGHTS], float direction[3])
{
    static const float luminance[SKYLIGHT_SH_CHANNELS] = { 0.212672845f, 0.715152144f, 0.0721749961f };
    float x = 0.0f, y = 0.0f, z = 0.0f, length;
    int channel;
    for (channel = 0; channel < SKYLIGHT_SH_CHANNELS; ++channel) {
        x += luminance[channel] * weights[channel][3];
        y += luminance[channel] * weights[channel][1];
        z += luminance[channel] * weights[channel][2];
    }
    length = sqrtf(x * x + y * y + z * z);
    direction[0] = length > 0.0f ? x / length : 0.0f;
    direction[1] = length > 0.0f ? y / length : 0.0f;
    direction[2] = length > 0.0f ? z / length : 1.0f;
    return !(length > 0.0f);
}


/* Optional: an even ground of this albedo below the horizon, lit by the sky (before any window): its radiance is albedo E / pi, and E, the irradiance on it, is a multiple of the weight l = 1, m = 0. */
static inline void skylight_sh_ground(const float albedo[SKYLIGHT_SH_CHANNELS], float weights[SKYLIGHT_SH_CHANNELS][SKYLIGHT_SH_WEIGHTS])
{
    static const float lower[SKYLIGHT_SH_BANDS] = { 1.7724539f, -1.53499007f, 0.0f, 0.586184025f };
    int l, channel;
    for (channel = 0; channel < SKYLIGHT_SH_CHANNELS; ++channel) {
        const float radiance = albedo[channel] * 0.65147001587f * weights[channel][2];
        for (l = 0; l < SKYLIGHT_SH_BANDS; ++l) weights[channel][l * (l + 1)] += radiance * lower[l];
    }
}


/* Optional: tames the ringing of the horizon by the zonal window sinc(pi l / bands) (Habel et al. 2008, eq. 5). */
static inline void skylight_sh_window(int bands, float weights[SKYLIGHT_SH_CHANNELS][SKYLIGHT_SH_WEIGHTS])
{
    int l, channel;
    for (l = 1; l < bands && l < SKYLIGHT_SH_BANDS; ++l) {
        const float x = 3.14159265f * (float)l / (float)bands;
        const float factor = sinf(x) / x;
        for (channel = 0; channel < SKYLIGHT_SH_CHANNELS; ++channel) weights[channel][l * (l + 1)] *= factor;
    }
}

#endif /* SKYLIGHT_SH_H */
