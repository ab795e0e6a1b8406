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
 * Accuracy, as shipped: E_mean 1.46 %, E_max 6.25 % of the least luminance of the same sky, at azimuth 0.
 * The expansion rings: the least value it takes, over all directions and measured sets, is -13.9 % of its largest
 * in the same set; the window below tames it.
 * Memory: 1635 bytes of constants, packed into few bytes (a fast table takes more and less time).
 *
 * Provenance
 *   config preetham, table 7-bands-1.5pct-packed
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
#define SKYLIGHT_SH_BANDS 7
#define SKYLIGHT_SH_WEIGHTS 49
#define SKYLIGHT_SH_CHANNELS 3
#define SKYLIGHT_SH_AXES 2
#define SKYLIGHT_SH_UNIT "cd/m2"
#define SKYLIGHT_SH_E_MEAN 1.458302e-02
#define SKYLIGHT_SH_E_MAX 6.253464e-02
#define SKYLIGHT_SH_SUN_ZENITH_MIN 0.0f
#define SKYLIGHT_SH_SUN_ZENITH_MAX 1.57079637f
#define SKYLIGHT_SH_TURBIDITY_MIN 2.5f
#define SKYLIGHT_SH_TURBIDITY_MAX 6.0f
#ifndef SKYLIGHT_SH_EXPOSURE
#define SKYLIGHT_SH_EXPOSURE 1
#endif

typedef float skylight_sh_real;

/* Whole numbers as Rice codes, read in one forward loop. */
static const unsigned char skylight_sh_stream[1439] = {
    167, 70, 199, 84, 49, 255, 47, 47, 231, 192, 199, 238, 240, 255, 70, 5, 169, 172, 19, 254, 79, 1, 43, 52,
    126, 32, 107, 252, 127, 163, 130, 176, 230, 18, 130, 254, 23, 255, 109, 53, 184, 248, 159, 173, 6, 73, 163, 198,
    255, 55, 54, 94, 245, 215, 176, 204, 247, 255, 95, 4, 95, 104, 224, 131, 247, 198, 255, 91, 101, 254, 144, 247,
    251, 31, 192, 222, 231, 204, 248, 152, 50, 196, 56, 86, 74, 1, 205, 193, 61, 42, 107, 187, 150, 136, 5, 173,
    60, 65, 148, 56, 18, 107, 42, 6, 46, 145, 135, 123, 45, 70, 66, 94, 25, 131, 70, 72, 246, 188, 127, 247,
    234, 73, 200, 174, 244, 56, 191, 232, 128, 211, 247, 49, 94, 122, 248, 4, 247, 143, 141, 222, 103, 233, 54, 15,
    53, 187, 5, 228, 210, 204, 191, 84, 193, 52, 2, 7, 37, 22, 42, 55, 146, 84, 55, 132, 26, 111, 212, 222,
    4, 243, 211, 41, 33, 8, 161, 32, 157, 167, 101, 199, 133, 161, 64, 51, 176, 77, 250, 107, 18, 19, 71, 218,
    1, 146, 80, 124, 111, 37, 67, 198, 213, 227, 149, 179, 155, 231, 54, 198, 219, 241, 227, 166, 41, 145, 245, 204,
    37, 80, 120, 99, 92, 71, 116, 60, 248, 75, 225, 209, 70, 202, 208, 85, 180, 96, 30, 222, 111, 94, 179, 150,
    60, 247, 15, 242, 175, 82, 152, 237, 76, 219, 254, 192, 216, 221, 229, 180, 65, 154, 197, 150, 82, 80, 219, 113,
    6, 223, 53, 200, 50, 131, 226, 10, 195, 114, 159, 209, 138, 226, 65, 55, 71, 204, 158, 83, 40, 13, 50, 40,
    7, 164, 165, 159, 203, 133, 28, 24, 90, 204, 146, 1, 122, 62, 190, 236, 71, 159, 62, 185, 239, 30, 16, 89,
    46, 143, 68, 234, 34, 12, 89, 148, 232, 146, 58, 51, 205, 34, 68, 37, 36, 127, 191, 133, 52, 14, 149, 148,
    69, 243, 75, 156, 126, 98, 22, 105, 57, 246, 9, 244, 116, 140, 180, 41, 108, 150, 44, 67, 46, 160, 130, 222,
    107, 43, 25, 34, 124, 63, 239, 98, 152, 228, 5, 228, 174, 125, 255, 67, 243, 23, 230, 193, 200, 144, 182, 247,
    117, 236, 124, 210, 160, 173, 72, 164, 205, 227, 104, 31, 142, 198, 91, 205, 111, 135, 246, 246, 26, 124, 212, 172,
    251, 211, 208, 31, 245, 18, 105, 15, 79, 243, 81, 254, 213, 143, 175, 131, 161, 106, 119, 27, 62, 3, 91, 89,
    118, 219, 43, 159, 201, 34, 9, 87, 102, 193, 172, 217, 181, 30, 32, 237, 185, 105, 154, 253, 39, 189, 102, 62,
    24, 55, 99, 132, 64, 93, 175, 249, 224, 202, 219, 136, 225, 134, 155, 103, 23, 62, 109, 21, 61, 127, 243, 20,
    39, 141, 47, 242, 141, 138, 210, 102, 104, 232, 173, 226, 160, 243, 150, 143, 232, 19, 218, 71, 27, 119, 69, 71,
    212, 105, 174, 250, 106, 138, 126, 74, 146, 227, 210, 146, 217, 94, 1, 84, 196, 76, 174, 216, 216, 39, 190, 3,
    16, 105, 134, 44, 86, 44, 37, 49, 25, 122, 199, 49, 101, 144, 148, 71, 38, 138, 77, 72, 136, 34, 48, 65,
    72, 91, 14, 0, 36, 228, 111, 14, 68, 243, 136, 184, 140, 202, 164, 73, 209, 63, 169, 181, 182, 20, 34, 2,
    236, 160, 96, 195, 85, 172, 198, 180, 120, 255, 168, 173, 163, 28, 141, 47, 241, 18, 104, 142, 85, 176, 54, 129,
    239, 11, 175, 76, 203, 34, 250, 158, 226, 194, 240, 151, 209, 250, 111, 50, 87, 201, 206, 24, 235, 210, 157, 19,
    196, 198, 221, 255, 129, 223, 57, 251, 115, 92, 46, 254, 149, 193, 30, 84, 175, 143, 109, 253, 134, 246, 121, 217,
    206, 4, 165, 194, 202, 110, 175, 196, 117, 244, 86, 117, 58, 116, 87, 63, 109, 225, 36, 204, 114, 69, 148, 152,
    231, 122, 148, 71, 95, 171, 62, 109, 39, 237, 221, 188, 73, 243, 13, 14, 242, 30, 201, 50, 77, 109, 185, 242,
    169, 99, 165, 211, 148, 177, 25, 102, 45, 35, 244, 1, 213, 174, 108, 96, 190, 70, 26, 228, 171, 1, 44, 209,
    40, 218, 57, 21, 77, 164, 92, 98, 110, 137, 41, 12, 182, 152, 209, 211, 42, 115, 213, 124, 154, 112, 154, 34,
    101, 60, 246, 38, 7, 138, 21, 39, 83, 101, 10, 31, 176, 70, 65, 4, 22, 156, 178, 1, 5, 171, 37, 133,
    83, 28, 196, 58, 194, 36, 89, 57, 18, 148, 0, 175, 234, 16, 133, 212, 211, 56, 212, 152, 140, 69, 18, 154,
    7, 200, 140, 40, 81, 54, 23, 187, 195, 14, 112, 36, 128, 114, 165, 0, 26, 141, 158, 144, 163, 154, 166, 81,
    1, 49, 153, 48, 69, 106, 107, 173, 116, 10, 17, 251, 167, 254, 81, 243, 86, 86, 78, 212, 239, 99, 193, 209,
    149, 63, 235, 15, 228, 160, 247, 60, 191, 63, 244, 152, 17, 123, 236, 147, 226, 60, 245, 237, 121, 163, 199, 190,
    101, 245, 204, 253, 62, 203, 251, 97, 222, 68, 219, 132, 156, 212, 202, 254, 226, 205, 159, 167, 91, 222, 204, 115,
    207, 220, 239, 199, 7, 118, 224, 244, 180, 119, 192, 193, 220, 23, 211, 131, 111, 252, 88, 152, 165, 57, 177, 184,
    198, 229, 221, 135, 115, 205, 253, 130, 14, 111, 57, 46, 205, 93, 143, 62, 105, 46, 205, 205, 187, 28, 29, 214,
    192, 43, 63, 171, 131, 221, 134, 199, 107, 253, 40, 199, 50, 127, 133, 122, 58, 186, 231, 160, 189, 107, 79, 240,
    53, 9, 39, 234, 153, 85, 122, 185, 117, 32, 179, 78, 97, 49, 84, 103, 178, 78, 225, 193, 197, 166, 169, 44,
    208, 12, 209, 246, 67, 216, 68, 120, 163, 132, 71, 50, 115, 243, 107, 154, 68, 214, 173, 229, 205, 152, 82, 2,
    236, 209, 228, 206, 16, 240, 68, 83, 182, 7, 23, 151, 133, 34, 73, 71, 66, 153, 98, 170, 9, 22, 210, 200,
    139, 53, 37, 2, 169, 4, 230, 84, 112, 106, 247, 145, 110, 114, 77, 9, 198, 69, 106, 210, 250, 16, 102, 38,
    41, 70, 122, 139, 27, 196, 134, 2, 22, 48, 228, 157, 33, 49, 18, 123, 108, 56, 212, 44, 73, 49, 84, 238,
    201, 34, 200, 112, 136, 217, 36, 20, 25, 57, 9, 60, 49, 144, 195, 21, 78, 11, 209, 9, 78, 1, 204, 138,
    36, 24, 138, 80, 197, 192, 73, 146, 81, 148, 9, 72, 212, 90, 41, 37, 100, 136, 8, 111, 221, 66, 105, 59,
    50, 95, 149, 253, 16, 76, 95, 194, 208, 239, 46, 179, 121, 9, 165, 220, 126, 98, 186, 43, 239, 39, 224, 124,
    163, 212, 239, 223, 230, 209, 205, 239, 73, 222, 236, 50, 63, 184, 96, 166, 250, 167, 110, 232, 252, 254, 127, 207,
    252, 180, 251, 253, 156, 126, 224, 143, 27, 105, 95, 61, 24, 247, 30, 28, 157, 229, 125, 202, 125, 17, 101, 220,
    27, 207, 57, 54, 219, 184, 116, 50, 92, 25, 232, 198, 97, 143, 44, 249, 206, 233, 54, 75, 68, 16, 210, 226,
    89, 122, 37, 235, 175, 30, 30, 43, 218, 45, 248, 242, 105, 179, 101, 120, 250, 129, 233, 254, 242, 192, 174, 89,
    198, 231, 94, 39, 21, 105, 115, 112, 44, 35, 211, 237, 197, 9, 210, 75, 61, 185, 14, 151, 179, 119, 210, 73,
    88, 135, 206, 245, 170, 163, 90, 32, 151, 72, 196, 54, 142, 125, 207, 220, 167, 29, 87, 47, 28, 203, 45, 60,
    115, 171, 253, 20, 155, 18, 3, 169, 102, 103, 119, 60, 177, 176, 148, 144, 37, 144, 50, 113, 204, 58, 128, 120,
    245, 9, 112, 1, 195, 165, 193, 86, 0, 130, 82, 204, 58, 164, 40, 187, 10, 68, 97, 41, 66, 87, 137, 224,
    132, 16, 72, 188, 79, 196, 72, 41, 193, 13, 80, 148, 113, 16, 96, 76, 151, 225, 85, 97, 14, 33, 0, 19,
    86, 120, 40, 75, 206, 110, 117, 1, 76, 42, 139, 122, 67, 156, 69, 88, 86, 82, 171, 197, 80, 208, 33, 224,
    128, 217, 19, 66, 146, 90, 38, 7, 77, 73, 199, 9, 140, 53, 145, 242, 226, 177, 134, 8, 8, 197, 230, 64,
    39, 81, 64, 18, 96, 91, 132, 24, 101, 64, 228, 132, 163, 32, 76, 141, 96, 156, 67, 38, 57, 41, 0
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
    static const signed char rest_profile[5] = { 4, 1, -3, -7, -13 };
    static const signed char channel_profile[3] = { -3, -3, -3 };
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
                value *= 0.00126428693f;
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

/* All products of the other axes' bases, `rest` of 5. */
static inline void skylight_sh_rest(skylight_sh_real x1, skylight_sh_real *rest)
{
    int r = 0, i;
    skylight_sh_real t1[8];
    int i1;
    {
        const skylight_sh_real u = skylight_sh_map_1(x1);
        skylight_sh_real *t = t1;
        const int n = 5;
        t[0] = 1;
        if (n > 1) t[1] = u;
        for (i = 2; i < n; ++i) t[i] = 2 * t[i / 2] * t[i - i / 2] - t[i & 1];
    }
    for (i1 = 0; i1 < 5; ++i1)
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
    skylight_sh_real x[SKYLIGHT_SH_AXES], t0[12], rest[5], wave_cos[SKYLIGHT_SH_BANDS], wave_sin[SKYLIGHT_SH_BANDS], scale;
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
    skylight_sh_real x[SKYLIGHT_SH_AXES], t0[12], rest[5], wave_cos[SKYLIGHT_SH_BANDS], wave_sin[SKYLIGHT_SH_BANDS], scale;
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
    static const float lower[SKYLIGHT_SH_BANDS] = { 1.7724539f, -1.53499007f, 0.0f, 0.586184025f, 0.0f, -0.367410272f, 0.0f };
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
