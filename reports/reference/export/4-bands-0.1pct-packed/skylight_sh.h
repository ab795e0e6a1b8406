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
 * Accuracy, as shipped: E_mean 0.0978 %, E_max 0.263 % of the least luminance of the same sky, at azimuth 0.
 * The expansion rings: the least value it takes, over all directions and measured sets, is -13.3 % of its largest
 * in the same set; the window below tames it.
 * Memory: 1255 bytes of constants, packed into few bytes (a fast table takes more and less time).
 *
 * Provenance
 *   config preetham, table 4-bands-0.1pct-packed
 *   selection e20f28358e8eeec4c668aa59ee2e88df7566b063480189f3dc5b4345e257eb1d
 *   python 3.11.7, numpy 2.4.6, scipy 1.17.1, h5py 3.16.0, dask 2026.8.0
 *   x86_64: AVX512_ICL X86_V2 X86_V3 X86_V4
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
#define SKYLIGHT_SH_E_MEAN 9.778279e-04
#define SKYLIGHT_SH_E_MAX 2.634882e-03
#define SKYLIGHT_SH_SUN_ZENITH_MIN 0.0f
#define SKYLIGHT_SH_SUN_ZENITH_MAX 1.57079637f
#define SKYLIGHT_SH_TURBIDITY_MIN 2.5f
#define SKYLIGHT_SH_TURBIDITY_MAX 6.0f
#ifndef SKYLIGHT_SH_EXPOSURE
#define SKYLIGHT_SH_EXPOSURE 1
#endif

typedef float skylight_sh_real;

/* Whole numbers as Rice codes, read in one forward loop. */
static const unsigned char skylight_sh_stream[1058] = {
    73, 219, 25, 95, 42, 37, 252, 255, 155, 195, 159, 211, 202, 172, 146, 206, 70, 18, 254, 255, 139, 50, 115, 206,
    54, 237, 98, 60, 183, 252, 255, 84, 1, 182, 123, 91, 254, 254, 23, 113, 186, 151, 223, 104, 236, 198, 255, 59,
    145, 172, 47, 169, 65, 141, 80, 132, 254, 127, 233, 211, 133, 200, 175, 236, 100, 64, 253, 191, 154, 145, 75, 78,
    117, 245, 63, 118, 128, 128, 94, 184, 150, 255, 255, 27, 235, 227, 98, 208, 117, 205, 37, 3, 119, 151, 147, 241,
    255, 63, 46, 104, 101, 60, 44, 14, 239, 37, 201, 207, 105, 255, 255, 117, 230, 105, 27, 57, 230, 206, 159, 166,
    255, 63, 9, 89, 245, 47, 63, 174, 255, 1, 84, 223, 223, 63, 66, 9, 91, 26, 223, 58, 33, 244, 116, 167,
    81, 84, 5, 94, 189, 129, 85, 103, 152, 70, 171, 99, 191, 193, 27, 78, 165, 8, 214, 169, 29, 91, 10, 158,
    218, 120, 26, 235, 217, 135, 193, 55, 191, 50, 21, 61, 117, 56, 213, 33, 251, 198, 140, 138, 136, 237, 161, 118,
    138, 20, 159, 193, 251, 104, 176, 131, 141, 39, 132, 92, 211, 109, 16, 208, 29, 182, 109, 88, 80, 86, 125, 135,
    197, 211, 7, 230, 150, 208, 99, 214, 221, 125, 50, 230, 201, 182, 245, 92, 167, 207, 184, 230, 87, 63, 120, 99,
    188, 190, 255, 250, 104, 28, 236, 148, 109, 249, 175, 156, 138, 132, 84, 74, 21, 76, 151, 140, 167, 60, 177, 117,
    64, 144, 69, 246, 66, 208, 5, 158, 208, 85, 158, 93, 38, 112, 61, 24, 185, 100, 16, 131, 143, 195, 71, 111,
    89, 177, 226, 34, 134, 44, 216, 12, 246, 52, 35, 192, 213, 199, 139, 177, 18, 21, 57, 152, 15, 90, 123, 69,
    77, 228, 0, 246, 18, 178, 226, 4, 212, 101, 60, 52, 95, 113, 246, 72, 166, 56, 12, 214, 180, 11, 62, 14,
    7, 78, 92, 196, 231, 62, 32, 42, 89, 75, 165, 91, 167, 132, 53, 221, 239, 36, 120, 120, 58, 20, 100, 241,
    182, 228, 187, 61, 224, 56, 38, 133, 122, 41, 169, 138, 162, 142, 251, 164, 206, 110, 27, 77, 200, 64, 118, 227,
    16, 151, 165, 65, 36, 114, 247, 64, 2, 230, 233, 161, 181, 51, 151, 194, 5, 82, 129, 172, 153, 20, 40, 75,
    121, 95, 9, 91, 155, 197, 176, 160, 109, 45, 63, 21, 97, 252, 150, 139, 79, 66, 59, 13, 107, 118, 101, 193,
    9, 21, 140, 199, 151, 180, 99, 19, 33, 200, 200, 28, 237, 190, 103, 52, 163, 159, 247, 113, 232, 253, 113, 184,
    28, 236, 94, 160, 73, 31, 131, 150, 171, 129, 53, 142, 108, 104, 176, 195, 185, 123, 76, 18, 201, 20, 53, 1,
    237, 74, 207, 168, 214, 49, 187, 57, 29, 74, 29, 174, 200, 201, 137, 187, 56, 50, 49, 152, 248, 170, 59, 128,
    26, 59, 121, 61, 163, 56, 91, 79, 141, 137, 136, 132, 21, 67, 105, 83, 94, 98, 167, 153, 230, 178, 208, 190,
    152, 34, 148, 4, 192, 9, 147, 166, 174, 181, 63, 181, 93, 91, 249, 57, 181, 158, 219, 249, 227, 206, 67, 68,
    182, 207, 207, 7, 200, 125, 12, 75, 167, 155, 37, 163, 206, 177, 114, 51, 70, 248, 16, 44, 122, 139, 179, 69,
    138, 63, 183, 58, 217, 72, 18, 11, 11, 15, 78, 2, 158, 159, 22, 159, 58, 202, 139, 131, 16, 94, 248, 136,
    22, 105, 137, 99, 183, 218, 172, 42, 87, 74, 175, 19, 16, 102, 178, 13, 166, 228, 135, 202, 2, 33, 203, 46,
    84, 93, 6, 153, 225, 59, 96, 133, 141, 0, 118, 162, 217, 116, 213, 40, 36, 172, 77, 114, 6, 2, 121, 13,
    159, 255, 40, 75, 37, 124, 44, 149, 17, 246, 170, 235, 55, 230, 19, 116, 244, 175, 13, 17, 85, 174, 49, 190,
    80, 206, 226, 216, 174, 199, 138, 217, 199, 109, 4, 63, 64, 183, 216, 251, 186, 70, 244, 94, 123, 9, 244, 54,
    253, 16, 27, 140, 107, 15, 67, 215, 24, 126, 44, 171, 249, 34, 179, 90, 44, 234, 13, 247, 1, 223, 177, 54,
    32, 222, 87, 206, 87, 101, 238, 143, 149, 186, 43, 161, 147, 119, 110, 220, 42, 250, 161, 149, 83, 74, 216, 114,
    5, 210, 32, 8, 169, 91, 47, 199, 27, 149, 24, 95, 86, 159, 236, 182, 217, 222, 247, 88, 118, 182, 119, 175,
    29, 178, 70, 239, 27, 239, 153, 31, 104, 168, 91, 5, 74, 60, 92, 51, 215, 238, 233, 121, 44, 193, 115, 34,
    145, 146, 54, 105, 174, 233, 149, 217, 81, 145, 170, 173, 250, 94, 255, 65, 21, 184, 219, 140, 139, 1, 102, 89,
    193, 83, 107, 218, 115, 164, 60, 231, 125, 204, 87, 137, 185, 34, 122, 124, 5, 142, 168, 86, 73, 187, 172, 28,
    241, 254, 119, 158, 59, 42, 195, 152, 98, 80, 129, 57, 107, 13, 227, 232, 91, 15, 251, 67, 56, 251, 123, 1,
    115, 123, 199, 143, 206, 239, 67, 190, 31, 209, 123, 54, 132, 56, 143, 220, 204, 235, 49, 127, 41, 19, 181, 128,
    145, 85, 203, 108, 125, 68, 87, 137, 156, 226, 34, 73, 136, 136, 97, 9, 52, 203, 61, 39, 140, 171, 183, 43,
    199, 161, 174, 38, 129, 47, 60, 52, 147, 100, 192, 42, 51, 86, 237, 70, 167, 199, 202, 24, 179, 72, 44, 143,
    4, 55, 165, 117, 219, 150, 58, 230, 198, 117, 81, 132, 81, 0, 41, 65, 1, 249, 50, 202, 197, 14, 43, 211,
    77, 158, 16, 82, 157, 13, 197, 0, 221, 138, 79, 255, 41, 161, 26, 234, 61, 186, 245, 2, 217, 33, 142, 250,
    144, 46, 114, 59, 152, 112, 105, 126, 204, 144, 172, 98, 184, 4, 138, 72, 123, 64, 23, 250, 170, 128, 161, 150,
    48, 136, 48, 130, 128, 6, 168, 25, 69, 86, 187, 36, 197, 181, 114, 4, 34, 147, 162, 105, 224, 141, 85, 91,
    149, 104, 152, 110, 155, 116, 240, 14, 190, 32, 137, 196, 214, 28, 50, 72, 78, 14, 170, 85, 166, 32, 144, 43,
    48, 0
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
    static const signed char rest_profile[6] = { 6, 4, -1, -7, -13, -17 };
    static const signed char channel_profile[3] = { -4, -4, -2 };
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
                value *= 9.50511167e-05f;
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
    static const skylight_sh_real k[3] = { 0.0f, 4.36619759f, 5.0f };
    return k[1] * (v - k[0]) / (k[2] - v) - 1;
}

/* turbidity in the fit's variable: reciprocal. */
static inline skylight_sh_real skylight_sh_map_1(skylight_sh_real v)
{
    static const skylight_sh_real k[3] = { 2.5f, -4.57142878f, -2.0f };
    return k[1] * (v - k[0]) / (k[2] - v) - 1;
}

/* What all weights share: the closed form preetham_zenith. */
static inline skylight_sh_real skylight_sh_scale(skylight_sh_real sun_zenith, skylight_sh_real turbidity)
{
    static const skylight_sh_real k[10] = { 0.1787f, -1.46300006f, -0.355399996f, 0.42750001f, -0.0227000006f, 5.32509995f, 0.1206f, -2.57710004f, -0.0670000017f, 0.370299995f };
    const float a = k[0] * turbidity + k[1], b = k[2] * turbidity + k[3], c = k[4] * turbidity + k[5];
    const float d = k[6] * turbidity + k[7], e = k[8] * turbidity + k[9];
    const float chi = (0.44444444444444444f - turbidity * 0.0083333333333333333f) * (3.1415926535897932f - 2.0f * sun_zenith);
    const float square = chi * chi;
    const float tan_above = chi * (105.0f - 10.0f * square), tan_below = 105.0f - square * (45.0f - square);
    const float y = d * sun_zenith, z = sun_zenith * sun_zenith;
    const float cosine = 1.0f - z * (0.5f - z * (0.041666666666666667f - z * 0.0013888888888888889f));
    float up = 1.0f + b * (0.25f + b * 0.03125f), halo = 1.0f + y * (0.125f + y * 0.0078125f);
    up = up * up;
    up = up * up;
    halo = halo * halo;
    halo = halo * halo;
    halo = halo * halo;
    return 1000.0f * ((4.0453f * turbidity - 4.9710f) * tan_above + (2.4192f - 0.2155f * turbidity) * tan_below)
        / (tan_below * (1.0f + a * up) * (1.0f + c * halo + e * (cosine * cosine)));
}




/* sun_zenith in the fit's variable: reciprocal, in double for the gradient. */
static inline double skylight_sh_wide_map_0(double v)
{
    static const double k[3] = { 0.0, 4.366197723675814, 5.0 };
    return k[1] * (v - k[0]) / (k[2] - v) - 1;
}

/* turbidity in the fit's variable: reciprocal, in double for the gradient. */
static inline double skylight_sh_wide_map_1(double v)
{
    static const double k[3] = { 2.5, -4.5714285714285712, -2.0 };
    return k[1] * (v - k[0]) / (k[2] - v) - 1;
}

/* What all weights share: the closed form preetham_zenith. */
static inline double skylight_sh_wide_scale(double sun_zenith, double turbidity)
{
    static const double k[10] = { 0.1787, -1.4630000000000001, -0.35539999999999999, 0.42749999999999999, -0.022700000000000001, 5.3250999999999999, 0.1206, -2.5771000000000002, -0.067000000000000004, 0.37030000000000002 };
    const double a = k[0] * turbidity + k[1], b = k[2] * turbidity + k[3], c = k[4] * turbidity + k[5];
    const double d = k[6] * turbidity + k[7], e = k[8] * turbidity + k[9];
    const double chi = (0.44444444444444444 - turbidity * 0.0083333333333333333) * (3.1415926535897932 - 2.0 * sun_zenith);
    const double square = chi * chi;
    const double tan_above = chi * (105.0 - 10.0 * square), tan_below = 105.0 - square * (45.0 - square);
    const double y = d * sun_zenith, z = sun_zenith * sun_zenith;
    const double cosine = 1.0 - z * (0.5 - z * (0.041666666666666667 - z * 0.0013888888888888889));
    double up = 1.0 + b * (0.25 + b * 0.03125), halo = 1.0 + y * (0.125 + y * 0.0078125);
    up = up * up;
    up = up * up;
    halo = halo * halo;
    halo = halo * halo;
    halo = halo * halo;
    return 1000.0 * ((4.0453 * turbidity - 4.9710) * tan_above + (2.4192 - 0.2155 * turbidity) * tan_below)
        / (tan_below * (1.0 + a * up) * (1.0 + c * halo + e * (cosine * cosine)));
}

/* The basis of the first axis, `t` of 12, zero where the table has no term. */
static inline void skylight_sh_first(skylight_sh_real x, skylight_sh_real *t)
{
    const skylight_sh_real u = skylight_sh_map_0(x);
    const int n = 10;
    int i;
    for (i = 0; i < 12; ++i) t[i] = 0;
    t[0] = 1;
    if (n > 1) t[1] = u;
    for (i = 2; i < n; ++i) t[i] = 2 * t[i / 2] * t[i - i / 2] - t[i & 1];
}

/* All products of the other axes' bases, `rest` of 6. */
static inline void skylight_sh_rest(skylight_sh_real x1, skylight_sh_real *rest)
{
    int r = 0, i;
    skylight_sh_real t1[8];
    int i1;
    {
        const skylight_sh_real u = skylight_sh_map_1(x1);
        skylight_sh_real *t = t1;
        const int n = 6;
        t[0] = 1;
        if (n > 1) t[1] = u;
        for (i = 2; i < n; ++i) t[i] = 2 * t[i / 2] * t[i - i / 2] - t[i & 1];
    }
    for (i1 = 0; i1 < 6; ++i1)
        rest[r++] = t1[i1];
    (void)i;
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
    /* Slopes of the map and of the logarithm of the scale, by central differences in double: right to 1e-8. */
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
