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
 * Accuracy, as shipped: E_mean 0.0951 %, E_max 0.272 % of the least luminance of the same sky, at azimuth 0.
 * The expansion rings: the least value it takes, over all directions and measured sets, is -12.5 % of its largest
 * in the same set; the window below tames it.
 * Memory: 1257 bytes of constants, packed into few bytes (a fast table takes more and less time).
 *
 * Provenance
 *   skylight-sh 0.1.0, config preetham 7738be1e848979ca, table 4-bands-0.1pct-packed
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
#define SKYLIGHT_SH_E_MEAN 9.511000e-04
#define SKYLIGHT_SH_E_MAX 2.717000e-03
#define SKYLIGHT_SH_SUN_ZENITH_MIN 0.0f
#define SKYLIGHT_SH_SUN_ZENITH_MAX 1.57079637f
#define SKYLIGHT_SH_TURBIDITY_MIN 2.5f
#define SKYLIGHT_SH_TURBIDITY_MAX 6.0f
#ifndef SKYLIGHT_SH_EXPOSURE
#define SKYLIGHT_SH_EXPOSURE 1
#endif

typedef float skylight_sh_real;

/* Whole numbers as Rice codes, read in one forward loop. */
static const unsigned char skylight_sh_stream[1064] = {
    105, 95, 58, 161, 42, 99, 252, 255, 27, 71, 155, 47, 154, 139, 108, 117, 225, 135, 248, 255, 95, 44, 148, 104,
    214, 66, 249, 129, 92, 55, 255, 79, 19, 64, 251, 54, 133, 175, 255, 37, 155, 108, 69, 191, 193, 216, 151, 251,
    255, 157, 47, 81, 41, 216, 171, 63, 72, 64, 202, 255, 47, 0, 184, 53, 104, 133, 170, 139, 168, 255, 215, 22,
    78, 161, 153, 170, 254, 71, 13, 16, 208, 191, 108, 177, 151, 253, 255, 47, 20, 251, 210, 124, 203, 40, 17, 177,
    209, 208, 57, 254, 255, 15, 26, 217, 110, 6, 121, 196, 46, 223, 125, 154, 245, 255, 175, 134, 206, 204, 64, 17,
    151, 125, 124, 247, 255, 147, 144, 211, 253, 226, 131, 254, 31, 64, 245, 253, 245, 143, 168, 148, 45, 149, 144, 157,
    16, 122, 218, 197, 244, 105, 2, 158, 148, 193, 82, 14, 132, 234, 168, 104, 90, 195, 250, 110, 207, 33, 234, 27,
    20, 142, 116, 187, 204, 137, 222, 57, 219, 241, 185, 169, 77, 159, 44, 97, 85, 26, 24, 213, 137, 227, 119, 4,
    39, 97, 122, 51, 45, 7, 38, 56, 131, 246, 177, 216, 155, 221, 56, 184, 247, 50, 152, 123, 39, 50, 148, 22,
    128, 130, 146, 188, 47, 64, 249, 55, 228, 219, 231, 78, 173, 27, 112, 156, 7, 6, 182, 237, 144, 211, 99, 76,
    237, 253, 71, 195, 176, 127, 255, 133, 100, 246, 228, 72, 99, 185, 245, 169, 9, 120, 97, 41, 205, 232, 191, 251,
    142, 130, 132, 150, 224, 128, 148, 214, 202, 208, 109, 89, 195, 182, 138, 163, 203, 164, 85, 195, 247, 213, 25, 22,
    224, 112, 224, 199, 76, 185, 191, 157, 105, 2, 234, 210, 243, 213, 209, 80, 0, 85, 247, 112, 25, 230, 81, 49,
    95, 217, 157, 117, 9, 48, 242, 20, 192, 78, 64, 78, 148, 192, 84, 89, 183, 187, 249, 228, 145, 45, 105, 24,
    156, 101, 15, 252, 231, 96, 224, 188, 58, 61, 119, 0, 228, 95, 186, 150, 74, 199, 208, 8, 171, 96, 47, 97,
    49, 54, 186, 27, 145, 208, 44, 81, 94, 187, 65, 155, 197, 162, 82, 152, 52, 225, 239, 33, 158, 183, 236, 158,
    81, 112, 2, 111, 232, 225, 190, 41, 28, 228, 99, 221, 32, 128, 29, 91, 47, 191, 68, 129, 191, 52, 19, 76,
    84, 244, 234, 69, 33, 239, 213, 168, 149, 89, 164, 165, 26, 251, 201, 217, 1, 133, 247, 214, 89, 74, 176, 35,
    136, 203, 136, 40, 140, 168, 61, 149, 126, 207, 86, 37, 224, 118, 124, 204, 193, 110, 189, 119, 34, 163, 31, 247,
    97, 232, 253, 197, 17, 92, 24, 121, 165, 99, 55, 121, 41, 172, 204, 107, 19, 226, 171, 17, 226, 76, 117, 157,
    9, 66, 200, 95, 193, 105, 87, 52, 111, 218, 230, 232, 102, 82, 143, 234, 175, 109, 89, 7, 217, 153, 116, 233,
    18, 225, 23, 108, 184, 150, 133, 188, 70, 73, 156, 163, 163, 197, 25, 145, 200, 42, 195, 80, 228, 143, 137, 88,
    111, 37, 40, 228, 141, 107, 15, 144, 33, 1, 24, 126, 94, 182, 91, 247, 3, 111, 37, 4, 231, 48, 218, 109,
    166, 231, 223, 52, 60, 100, 247, 120, 190, 128, 236, 152, 151, 13, 186, 212, 191, 115, 113, 82, 161, 1, 194, 195,
    171, 186, 157, 141, 76, 148, 77, 169, 71, 48, 144, 4, 161, 172, 240, 160, 36, 179, 1, 96, 3, 105, 148, 124,
    48, 144, 128, 21, 6, 146, 159, 212, 24, 185, 84, 93, 51, 121, 34, 106, 77, 32, 152, 201, 54, 216, 144, 236,
    241, 236, 174, 21, 73, 36, 110, 143, 204, 133, 217, 192, 41, 0, 0, 187, 208, 71, 122, 250, 147, 10, 212, 26,
    57, 226, 112, 180, 130, 231, 63, 202, 82, 26, 31, 75, 101, 128, 93, 209, 255, 146, 146, 73, 71, 246, 54, 248,
    72, 229, 150, 243, 95, 196, 99, 51, 153, 171, 176, 41, 68, 44, 183, 28, 16, 182, 121, 239, 105, 27, 211, 94,
    102, 237, 74, 251, 237, 43, 241, 199, 252, 30, 83, 192, 141, 67, 206, 203, 51, 38, 92, 118, 57, 129, 122, 179,
    123, 138, 222, 43, 167, 210, 189, 122, 90, 233, 180, 235, 163, 213, 96, 11, 146, 20, 56, 1, 110, 1, 241, 188,
    194, 185, 9, 248, 254, 80, 71, 71, 24, 28, 85, 185, 30, 47, 246, 153, 237, 195, 125, 72, 189, 222, 222, 27,
    206, 163, 39, 189, 219, 255, 218, 33, 147, 0, 186, 228, 182, 243, 159, 22, 152, 123, 224, 94, 140, 109, 203, 21,
    121, 16, 30, 183, 233, 156, 65, 32, 204, 173, 144, 187, 90, 21, 247, 124, 69, 154, 150, 200, 110, 252, 131, 160,
    110, 153, 1, 151, 210, 66, 173, 209, 97, 244, 219, 153, 139, 221, 144, 201, 191, 65, 70, 171, 161, 193, 61, 195,
    36, 1, 157, 114, 84, 238, 159, 146, 158, 151, 27, 57, 240, 101, 10, 45, 84, 87, 140, 74, 194, 156, 186, 215,
    99, 57, 247, 144, 223, 4, 76, 245, 55, 114, 50, 117, 61, 185, 33, 170, 89, 238, 61, 97, 119, 220, 170, 207,
    214, 201, 67, 45, 247, 103, 109, 19, 85, 207, 228, 86, 72, 102, 11, 80, 18, 30, 141, 10, 64, 179, 252, 46,
    151, 215, 216, 62, 76, 90, 218, 12, 2, 86, 56, 58, 135, 48, 215, 154, 73, 45, 238, 144, 56, 116, 133, 51,
    137, 96, 119, 39, 141, 185, 164, 106, 93, 132, 52, 38, 192, 112, 73, 194, 10, 2, 52, 4, 2, 196, 93, 44,
    13, 205, 205, 105, 135, 97, 66, 110, 69, 231, 21, 131, 115, 54, 62, 29, 64, 74, 104, 6, 87, 81, 90, 87,
    117, 212, 16, 71, 241, 156, 90, 91, 7, 98, 210, 57, 57, 90, 68, 168, 178, 113, 1, 40, 137, 91, 7, 93,
    73, 171, 61, 22, 98, 9, 163, 135, 15, 210, 25, 0, 102, 124, 54, 75, 80, 102, 117, 137, 64, 68, 146, 162,
    95, 152, 140, 5, 179, 38, 189, 20, 197, 150, 152, 134, 107, 176, 2, 33, 144, 38, 49, 243, 212, 49, 3, 144,
    217, 145, 51, 8, 227, 20, 204, 7
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
    static const signed char rest_profile[6] = { 7, 4, -1, -7, -13, -18 };
    static const signed char channel_profile[3] = { -5, -5, -3 };
    signed char lengths[SKYLIGHT_SH_CHANNELS][6];
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
                for (r = 0; r < 6; ++r) {
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
                value *= 0.000104904175f;
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

/* The basis of the first axis, `t` of 12, zero where the table has no term. */
static inline void skylight_sh_first(skylight_sh_real x, skylight_sh_real *t)
{
    const skylight_sh_real u = skylight_sh_map_0(x);
    int i;
    for (i = 0; i < 12; ++i) t[i] = 0;
    t[0] = 1.0f;
    t[1] = u;
    t[2] = 2.0f * t[1] * t[1] - 1.0f;
    t[3] = 2.0f * t[1] * t[2] - t[1];
    t[4] = 2.0f * t[2] * t[2] - 1.0f;
    t[5] = 2.0f * t[2] * t[3] - t[1];
    t[6] = 2.0f * t[3] * t[3] - 1.0f;
    t[7] = 2.0f * t[3] * t[4] - t[1];
    t[8] = 2.0f * t[4] * t[4] - 1.0f;
    t[9] = 2.0f * t[4] * t[5] - t[1];
    (void)u;
}

/* All products of the other axes' bases, `rest` of 6. */
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
        t[5] = 2.0f * t[2] * t[3] - t[1];
        (void)u;
    }
    for (i1 = 0; i1 < 6; ++i1)
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
    skylight_sh_real x[SKYLIGHT_SH_AXES], t0[12], rest[6], wave_cos[SKYLIGHT_SH_BANDS], wave_sin[SKYLIGHT_SH_BANDS], scale;
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
    for (i = 0; i < 6; ++i) rest[i] *= scale;
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
    skylight_sh_real x[SKYLIGHT_SH_AXES], t0[12], rest[6], wave_cos[SKYLIGHT_SH_BANDS], wave_sin[SKYLIGHT_SH_BANDS], scale;
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
            skylight_sh_real d[12];
            d[0] = 0;
            d[1] = 1;
            for (i = 2; i < 10; ++i) d[i] = 2 * t0[i - 1] + 2 * t0[1] * d[i - 1] - d[i - 2];
            for (i = 0; i < 10; ++i) t0[i] = (skylight_sh_real)grown[0] * t0[i] + (skylight_sh_real)slope[0] * d[i];
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
            for (i = 2; i < 6; ++i) {
                t1[i] = 2 * t1[1] * t1[i - 1] - t1[i - 2];
                d1[i] = 2 * t1[i - 1] + 2 * t1[1] * d1[i - 1] - d1[i - 2];
            }
            if (a == 1)
                for (i = 0; i < 6; ++i) t1[i] = (skylight_sh_real)grown[1] * t1[i] + (skylight_sh_real)slope[1] * d1[i];
            for (i1 = 0; i1 < 6; ++i1)
                rest[r++] = t1[i1];
        }
        for (i = 0; i < 6; ++i) rest[i] *= scale;
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
