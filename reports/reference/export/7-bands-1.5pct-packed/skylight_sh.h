/* Preetham sky (published constants, srgb): spherical-harmonics weights, evaluated from polynomials.
 *
 * Written by skylight-sh 0.1.0; the table and this code may be used by anyone for anything (CC0-1.0).
 * C99 and C++11, header only, no allocation, no global written.
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
 *   w[channel][l*(l+1)+m], channels red, green, blue, linear, luminance-scaled cd/m2. Real orthonormal
 *   spherical harmonics without the Condon-Shortley sign, z up, m > 0 cosine, m < 0 sine; the azimuth turns from +x
 *   towards +y. The lower hemisphere is black. Returns 0; 1 where an input lay outside its range and was clamped;
 *   2 (weights zeroed) where one was NaN or the azimuth infinite.
 *
 * Accuracy, as shipped: E_mean 1.47 %, E_max 6.21 % of the least radiance (per-set), at azimuth 0.
 * Memory: 1587 bytes of constants, packed into few bytes (a fast table takes more and less time).
 *
 * Provenance
 *   config preetham, table 7-bands-1.5pct-packed
 *   selection 51c23129d5fd5611f42bd97426a3d94ed0a299f15ab08a767174d51d46439254
 *   python 3.11.7, numpy 2.4.6, scipy 1.17.1, h5py 3.16.0, dask 2026.8.0
 *   x86_64: AVX512_ICL X86_V2 X86_V3 X86_V4
 */
#ifndef SKYLIGHT_SH_H
#define SKYLIGHT_SH_H

#include <math.h>
#include <stdint.h>
#include <string.h>

#define SKYLIGHT_SH_BANDS 7
#define SKYLIGHT_SH_WEIGHTS 49
#define SKYLIGHT_SH_CHANNELS 3

typedef float skylight_sh_real;

/* Whole numbers as Rice codes, read in one forward loop. */
static const unsigned char skylight_sh_stream[1391] = {
    103, 198, 198, 18, 41, 255, 239, 192, 129, 221, 70, 173, 196, 255, 78, 28, 104, 111, 51, 255, 79, 129, 245, 154,
    31, 102, 199, 255, 119, 162, 234, 233, 44, 33, 248, 191, 147, 220, 77, 75, 229, 127, 77, 22, 135, 131, 227, 255,
    123, 78, 94, 193, 187, 74, 70, 175, 255, 223, 108, 47, 253, 224, 63, 248, 189, 252, 191, 187, 71, 127, 138, 119,
    255, 3, 220, 157, 51, 227, 99, 169, 12, 163, 207, 36, 5, 48, 135, 118, 224, 190, 106, 59, 72, 66, 54, 53,
    32, 10, 29, 43, 213, 179, 66, 118, 200, 211, 185, 0, 35, 247, 235, 65, 208, 8, 161, 231, 220, 75, 208, 6,
    62, 184, 120, 34, 223, 33, 249, 231, 127, 153, 121, 201, 169, 113, 124, 31, 153, 220, 89, 32, 37, 187, 78, 177,
    128, 148, 91, 228, 93, 42, 37, 2, 6, 29, 227, 130, 127, 78, 90, 101, 64, 99, 140, 217, 152, 99, 159, 76,
    201, 32, 66, 13, 209, 28, 173, 49, 42, 9, 133, 151, 129, 235, 105, 253, 93, 86, 224, 160, 54, 64, 18, 138,
    239, 177, 84, 136, 184, 2, 188, 49, 106, 115, 84, 193, 223, 198, 30, 54, 167, 36, 210, 201, 33, 225, 218, 113,
    102, 55, 60, 216, 75, 200, 201, 18, 202, 200, 85, 180, 32, 217, 47, 40, 157, 25, 11, 158, 251, 51, 253, 117,
    10, 177, 252, 172, 45, 62, 84, 114, 183, 30, 54, 12, 121, 175, 33, 129, 148, 77, 62, 238, 130, 60, 82, 6,
    164, 30, 134, 69, 56, 146, 37, 4, 115, 46, 121, 66, 255, 17, 108, 58, 200, 11, 132, 5, 25, 202, 154, 15,
    137, 116, 167, 64, 128, 142, 143, 246, 239, 175, 50, 61, 189, 246, 1, 81, 210, 54, 104, 151, 27, 48, 44, 67,
    104, 65, 155, 147, 37, 17, 162, 50, 16, 178, 213, 46, 24, 134, 73, 201, 146, 179, 59, 28, 158, 0, 37, 89,
    134, 58, 78, 206, 198, 7, 155, 193, 151, 43, 179, 216, 63, 232, 189, 182, 210, 41, 195, 155, 189, 212, 244, 153,
    101, 228, 170, 215, 157, 158, 94, 249, 88, 98, 72, 203, 123, 149, 203, 156, 43, 100, 131, 18, 208, 194, 73, 180,
    14, 243, 225, 226, 249, 173, 144, 87, 208, 214, 179, 196, 220, 76, 248, 253, 196, 107, 157, 45, 60, 204, 211, 248,
    221, 207, 191, 247, 204, 176, 180, 155, 133, 142, 197, 26, 169, 77, 119, 159, 195, 34, 9, 86, 24, 92, 29, 174,
    113, 166, 83, 225, 166, 88, 86, 143, 107, 205, 116, 48, 109, 198, 136, 101, 39, 120, 171, 7, 21, 250, 64, 35,
    5, 119, 14, 118, 62, 109, 145, 60, 189, 121, 140, 137, 233, 36, 187, 66, 73, 212, 108, 88, 220, 190, 159, 229,
    105, 201, 41, 224, 64, 22, 112, 102, 93, 104, 68, 149, 230, 170, 46, 134, 232, 167, 208, 248, 173, 232, 24, 211,
    26, 192, 4, 76, 100, 167, 94, 158, 113, 1, 68, 110, 97, 90, 85, 58, 176, 8, 190, 92, 113, 48, 6, 17,
    64, 8, 122, 37, 4, 139, 34, 240, 0, 103, 37, 7, 200, 225, 49, 215, 226, 212, 242, 120, 176, 136, 138, 52,
    41, 250, 39, 181, 214, 86, 58, 69, 128, 29, 136, 106, 24, 253, 86, 72, 150, 46, 30, 146, 151, 185, 24, 141,
    47, 241, 208, 21, 199, 144, 175, 228, 224, 123, 241, 238, 160, 235, 135, 239, 28, 59, 167, 95, 70, 107, 220, 125,
    142, 130, 254, 16, 186, 245, 237, 97, 82, 230, 238, 63, 243, 27, 159, 123, 102, 185, 222, 151, 161, 58, 186, 91,
    166, 109, 124, 209, 250, 104, 95, 103, 130, 82, 99, 101, 151, 91, 67, 29, 183, 209, 100, 145, 123, 242, 209, 142,
    131, 71, 217, 179, 171, 57, 110, 67, 120, 218, 141, 102, 180, 157, 113, 215, 210, 101, 206, 13, 102, 120, 61, 107,
    203, 196, 107, 151, 190, 121, 35, 157, 52, 33, 108, 101, 227, 206, 0, 117, 32, 117, 106, 152, 149, 109, 33, 134,
    232, 30, 231, 21, 133, 162, 187, 148, 200, 163, 83, 88, 106, 5, 83, 18, 236, 32, 169, 211, 6, 99, 237, 62,
    6, 202, 223, 160, 8, 167, 182, 169, 112, 173, 201, 52, 53, 164, 188, 185, 252, 229, 1, 102, 104, 202, 5, 73,
    214, 74, 10, 41, 6, 95, 13, 93, 142, 120, 138, 4, 5, 208, 53, 205, 92, 36, 205, 175, 80, 33, 50, 42,
    16, 208, 52, 68, 102, 20, 36, 146, 138, 90, 97, 39, 40, 18, 224, 84, 41, 136, 11, 198, 77, 135, 81, 154,
    5, 113, 50, 19, 164, 36, 183, 216, 74, 167, 12, 177, 63, 251, 167, 206, 217, 212, 152, 155, 223, 211, 252, 96,
    239, 15, 251, 39, 112, 208, 27, 207, 239, 15, 16, 159, 189, 64, 158, 187, 243, 204, 55, 103, 141, 30, 125, 189,
    107, 228, 222, 152, 223, 103, 188, 155, 181, 1, 153, 183, 202, 126, 119, 255, 7, 225, 146, 59, 141, 53, 185, 223,
    161, 16, 103, 205, 76, 186, 12, 70, 83, 47, 71, 227, 119, 62, 21, 70, 41, 39, 20, 211, 152, 168, 139, 108,
    172, 169, 239, 224, 232, 146, 83, 97, 238, 58, 39, 197, 93, 137, 81, 215, 146, 185, 31, 183, 247, 147, 150, 220,
    150, 31, 175, 254, 169, 52, 218, 255, 46, 239, 80, 114, 139, 193, 122, 81, 206, 241, 206, 194, 1, 79, 86, 229,
    101, 206, 65, 204, 50, 132, 101, 72, 25, 201, 58, 11, 15, 46, 198, 76, 154, 45, 233, 214, 50, 135, 165, 179,
    189, 2, 158, 146, 17, 155, 55, 21, 121, 108, 217, 70, 27, 48, 37, 158, 108, 209, 228, 102, 136, 196, 210, 179,
    128, 150, 117, 206, 2, 65, 69, 130, 51, 12, 73, 156, 144, 50, 90, 168, 240, 136, 131, 14, 152, 162, 224, 192,
    238, 35, 211, 192, 138, 2, 138, 139, 76, 222, 233, 16, 206, 68, 18, 127, 110, 131, 152, 163, 54, 136, 88, 192,
    48, 175, 8, 2, 228, 85, 200, 96, 168, 73, 14, 98, 112, 170, 140, 34, 193, 72, 134, 86, 36, 20, 153, 56,
    9, 60, 17, 96, 99, 21, 70, 9, 209, 25, 74, 1, 100, 38, 9, 133, 162, 51, 49, 144, 36, 25, 68, 157,
    136, 40, 182, 82, 74, 167, 12, 17, 222, 154, 61, 206, 102, 96, 186, 41, 251, 24, 12, 175, 225, 188, 239, 106,
    103, 241, 232, 125, 216, 42, 63, 91, 149, 247, 161, 56, 94, 104, 236, 239, 47, 115, 108, 139, 223, 209, 214, 224,
    30, 157, 239, 152, 167, 234, 135, 106, 209, 253, 251, 127, 143, 252, 244, 246, 59, 78, 159, 253, 201, 241, 234, 165,
    241, 180, 119, 58, 63, 201, 219, 227, 124, 47, 162, 164, 205, 227, 228, 163, 130, 254, 250, 60, 95, 25, 168, 166,
    188, 30, 92, 242, 230, 220, 50, 11, 35, 16, 210, 206, 65, 184, 146, 213, 251, 227, 67, 99, 155, 224, 229, 185,
    202, 12, 141, 30, 157, 44, 111, 102, 90, 177, 75, 79, 117, 61, 69, 218, 28, 24, 73, 124, 176, 218, 31, 96,
    118, 165, 179, 215, 89, 142, 238, 172, 147, 174, 137, 156, 105, 53, 7, 53, 238, 122, 36, 228, 228, 220, 123, 214,
    169, 252, 182, 246, 137, 80, 237, 57, 181, 89, 15, 105, 185, 24, 72, 21, 171, 138, 147, 124, 109, 185, 128, 244,
    64, 197, 226, 72, 29, 49, 172, 118, 156, 171, 97, 148, 241, 197, 1, 147, 98, 214, 145, 162, 231, 18, 16, 132,
    165, 132, 92, 36, 162, 9, 33, 142, 117, 149, 8, 17, 191, 128, 22, 64, 101, 28, 100, 84, 76, 145, 193, 149,
    51, 16, 2, 48, 37, 235, 161, 148, 153, 218, 41, 2, 184, 40, 169, 133, 130, 28, 202, 9, 233, 84, 16, 26,
    18, 10, 152, 61, 33, 32, 168, 34, 114, 80, 148, 115, 33, 128, 88, 19, 89, 84, 48, 229, 123, 128, 80, 106,
    10, 76, 98, 244, 20, 64, 150, 0, 49, 202, 128, 88, 132, 163, 16, 68, 139, 96, 148, 67, 38, 253, 7
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


/* 0 for a finite number, 1 for an infinity, 2 for NaN: by its bits, so that -ffast-math cannot remove the test. */
static inline int skylight_sh_kind(float v)
{
    uint32_t bits;
    memcpy(&bits, &v, sizeof bits);
    bits &= 0x7fffffffu;
    return (bits >= 0x7f800000u) + (bits > 0x7f800000u);
}

/* Clamps v to [low, high]; *status becomes 1 where v lay beyond the slack. An infinity is made finite by its sign bit. */
static inline skylight_sh_real skylight_sh_clamp(float v, skylight_sh_real low, skylight_sh_real high, skylight_sh_real slack, int *status)
{
    skylight_sh_real x;
    if (skylight_sh_kind(v)) {
        uint32_t bits;
        memcpy(&bits, &v, sizeof bits);
        v = bits >> 31 ? -3e38f : 3e38f;
    }
    x = (skylight_sh_real)v;
    *status |= (x < low - slack) | (x > high + slack);
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

/* preetham_zenith: a closed form that all weights share; the fit divided by the same. */
static inline skylight_sh_real skylight_sh_prefactor(skylight_sh_real sun_zenith, skylight_sh_real turbidity)
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

/* Evaluates the first `bands` bands (1 to SKYLIGHT_SH_BANDS, clamped likewise) and zeroes the rest. */
static inline int skylight_sh_weights_bands(float sun_zenith, float sun_azimuth, float turbidity, int bands, float weights[SKYLIGHT_SH_CHANNELS][SKYLIGHT_SH_WEIGHTS])
{
    int status = 0, i, m, channel;
    skylight_sh_real scale = 1;
    skylight_sh_real wave_cos[SKYLIGHT_SH_BANDS], wave_sin[SKYLIGHT_SH_BANDS];
    skylight_sh_real x0, t0[12];
    skylight_sh_real x1, t1[8];
    skylight_sh_real rest[5];

    if (skylight_sh_kind(sun_azimuth) | skylight_sh_kind(sun_zenith) | skylight_sh_kind(turbidity)) {
        if (skylight_sh_kind(sun_azimuth) != 0 || skylight_sh_kind(sun_zenith) == 2 || skylight_sh_kind(turbidity) == 2) {
            memset(weights, 0, sizeof(float) * SKYLIGHT_SH_CHANNELS * SKYLIGHT_SH_WEIGHTS);
            return 2;
        }
    }
    if (bands < 1) { bands = 1; status = 1; }
    if (bands > SKYLIGHT_SH_BANDS) { bands = SKYLIGHT_SH_BANDS; status = 1; }
    x0 = skylight_sh_clamp(sun_zenith, 0.0f, 1.57079637f, 1.57079637e-06f, &status);
    x1 = skylight_sh_clamp(turbidity, 2.5f, 6.0f, 3.50000005e-06f, &status);
    scale = skylight_sh_prefactor(x0, x1);
    {
        const skylight_sh_real u = skylight_sh_map_0(x0);
        skylight_sh_real *t = t0;
        const int n = 10;
        for (i = 0; i < 12; ++i) t[i] = 0;
        t[0] = 1;
        if (n > 1) t[1] = u;
        for (i = 2; i < n; ++i) t[i] = 2 * t[i / 2] * t[i - i / 2] - t[i & 1];
    }
    {
        const skylight_sh_real u = skylight_sh_map_1(x1);
        skylight_sh_real *t = t1;
        const int n = 5;
        for (i = 0; i < 8; ++i) t[i] = 0;
        t[0] = 1;
        if (n > 1) t[1] = u;
        for (i = 2; i < n; ++i) t[i] = 2 * t[i / 2] * t[i - i / 2] - t[i & 1];
    }
    {
        int r = 0;
        int i1;
        for (i1 = 0; i1 < 5; ++i1)
            rest[r++] = scale * t1[i1];
    }
    /* The waves of the azimuth, by doubling: m = h + k. */
    wave_cos[0] = 1;
    wave_sin[0] = 0;
    wave_cos[1] = cosf((skylight_sh_real)sun_azimuth);
    wave_sin[1] = sinf((skylight_sh_real)sun_azimuth);
    for (m = 2; m < SKYLIGHT_SH_BANDS; ++m) {
        const int h = m / 2, k = m - h;
        wave_cos[m] = wave_cos[h] * wave_cos[k] - wave_sin[h] * wave_sin[k];
        wave_sin[m] = wave_sin[h] * wave_cos[k] + wave_cos[h] * wave_sin[k];
    }
    {
        static const signed char rest_profile[5] = { 4, 0, -4, -7, -12 };
        static const signed char channel_profile[3] = { -3, -3, -3 };
        signed char lengths[SKYLIGHT_SH_CHANNELS][5];
        int profile[32], l, r;
        skylight_sh_bits bits;
        bits.next = skylight_sh_stream;
        bits.held = 0;
        bits.count = 0;
        memset(lengths, 0, sizeof lengths);
        for (i = 0; i < 32; ++i) profile[i] = 0;
        for (i = 0; i < 5; ++i) rest[i] *= 0.00141080411f;
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
                            sum += t0[i] * (skylight_sh_real)skylight_sh_rice(&bits, size > 0 ? size >> 1 : 0);
                        }
                        value += sum * rest[r];
                    }
                    weights[channel][l * (l + 1) - m] = (float)(value * wave_sin[m]);
                    weights[channel][l * (l + 1) + m] = (float)(value * wave_cos[m]);
                }
            }
        }
    }

    for (channel = 0; channel < SKYLIGHT_SH_CHANNELS; ++channel)
        for (i = bands * bands; i < SKYLIGHT_SH_WEIGHTS; ++i) weights[channel][i] = 0.0f;
    return status;
}

/* Evaluates all bands. */
static inline int skylight_sh_weights(float sun_zenith, float sun_azimuth, float turbidity, float weights[SKYLIGHT_SH_CHANNELS][SKYLIGHT_SH_WEIGHTS])
{
    return skylight_sh_weights_bands(sun_zenith, sun_azimuth, turbidity, SKYLIGHT_SH_BANDS, weights);
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
