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
 * Accuracy, as shipped: E_mean 1.46 %, E_max 3.91 % of the least radiance (per-set), at azimuth 0.
 * Memory: 681 bytes of constants, packed into few bytes (a fast table takes more and less time).
 *
 * Provenance
 *   config preetham, table 4-bands-1.5pct-packed
 *   selection 51c23129d5fd5611f42bd97426a3d94ed0a299f15ab08a767174d51d46439254
 *   python 3.11.7, numpy 2.4.6, scipy 1.17.1, h5py 3.16.0, dask 2026.8.0
 *   x86_64: AVX512_ICL X86_V2 X86_V3 X86_V4
 */
#ifndef SKYLIGHT_SH_H
#define SKYLIGHT_SH_H

#include <math.h>
#include <stdint.h>
#include <string.h>

#define SKYLIGHT_SH_BANDS 4
#define SKYLIGHT_SH_WEIGHTS 16
#define SKYLIGHT_SH_CHANNELS 3

typedef float skylight_sh_real;

/* Whole numbers as Rice codes, read in one forward loop. */
static const unsigned char skylight_sh_stream[486] = {
    38, 58, 149, 208, 248, 127, 211, 44, 48, 147, 83, 193, 255, 141, 28, 166, 93, 6, 255, 51, 192, 237, 121, 41,
    254, 77, 93, 235, 53, 138, 127, 83, 45, 45, 37, 63, 189, 204, 241, 255, 59, 212, 214, 115, 95, 7, 191, 252,
    47, 3, 107, 31, 59, 176, 253, 127, 203, 7, 158, 163, 247, 63, 16, 221, 14, 116, 236, 24, 17, 28, 91, 109,
    6, 164, 162, 145, 59, 58, 75, 164, 224, 186, 15, 115, 143, 238, 102, 132, 50, 106, 135, 178, 15, 98, 86, 109,
    130, 57, 164, 214, 223, 116, 44, 82, 223, 89, 92, 56, 235, 147, 47, 137, 43, 6, 39, 185, 227, 195, 155, 168,
    15, 120, 179, 10, 136, 37, 145, 170, 216, 66, 2, 40, 10, 67, 246, 194, 93, 15, 97, 80, 194, 149, 204, 200,
    52, 195, 131, 24, 56, 169, 233, 60, 159, 1, 99, 36, 32, 58, 43, 111, 18, 2, 163, 246, 191, 227, 26, 67,
    102, 128, 250, 187, 34, 206, 83, 190, 104, 55, 65, 115, 159, 225, 238, 42, 28, 214, 142, 62, 92, 238, 68, 87,
    32, 121, 205, 76, 172, 213, 145, 176, 107, 161, 30, 217, 211, 232, 195, 109, 108, 16, 109, 92, 253, 204, 188, 123,
    56, 135, 200, 238, 16, 228, 70, 137, 222, 147, 133, 12, 100, 199, 217, 64, 105, 95, 97, 148, 170, 104, 228, 190,
    25, 84, 7, 230, 158, 80, 241, 216, 197, 44, 186, 105, 240, 0, 230, 243, 165, 223, 43, 177, 241, 234, 3, 104,
    3, 153, 134, 248, 5, 72, 144, 115, 196, 77, 74, 58, 186, 18, 204, 202, 127, 33, 137, 66, 99, 67, 65, 83,
    164, 0, 30, 55, 209, 206, 24, 57, 19, 23, 82, 12, 139, 232, 2, 246, 239, 180, 197, 146, 33, 193, 5, 126,
    187, 116, 49, 91, 178, 239, 87, 211, 242, 21, 202, 182, 187, 91, 187, 119, 98, 246, 69, 24, 230, 46, 30, 245,
    220, 228, 92, 181, 119, 159, 253, 47, 144, 35, 124, 21, 199, 134, 219, 171, 240, 225, 168, 195, 177, 214, 121, 215,
    225, 230, 78, 93, 7, 195, 186, 160, 126, 215, 169, 212, 28, 161, 117, 136, 54, 42, 57, 86, 245, 88, 168, 228,
    31, 23, 47, 25, 99, 167, 44, 122, 248, 62, 69, 238, 18, 189, 160, 38, 177, 224, 172, 204, 233, 205, 230, 68,
    170, 19, 54, 84, 207, 164, 228, 145, 14, 59, 36, 29, 43, 167, 176, 253, 116, 67, 141, 137, 56, 97, 242, 170,
    26, 89, 98, 224, 21, 175, 8, 75, 3, 208, 16, 96, 89, 169, 211, 16, 251, 73, 98, 48, 159, 22, 197, 35,
    7, 77, 30, 153, 17, 248, 70, 212, 114, 19, 142, 33, 88, 0, 231, 28, 3, 84, 88, 170, 132, 40, 84, 22,
    22, 10, 71, 166, 12, 82
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
    skylight_sh_real x0, t0[8];
    skylight_sh_real x1, t1[4];
    skylight_sh_real rest[4];

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
        const int n = 7;
        for (i = 0; i < 8; ++i) t[i] = 0;
        t[0] = 1;
        if (n > 1) t[1] = u;
        for (i = 2; i < n; ++i) t[i] = 2 * t[i / 2] * t[i - i / 2] - t[i & 1];
    }
    {
        const skylight_sh_real u = skylight_sh_map_1(x1);
        skylight_sh_real *t = t1;
        const int n = 4;
        for (i = 0; i < 4; ++i) t[i] = 0;
        t[0] = 1;
        if (n > 1) t[1] = u;
        for (i = 2; i < n; ++i) t[i] = 2 * t[i / 2] * t[i - i / 2] - t[i & 1];
    }
    {
        int r = 0;
        int i1;
        for (i1 = 0; i1 < 4; ++i1)
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
        static const signed char rest_profile[4] = { 4, 1, -4, -9 };
        static const signed char channel_profile[3] = { -1, -1, 0 };
        signed char lengths[SKYLIGHT_SH_CHANNELS][4];
        int profile[32], l, r;
        skylight_sh_bits bits;
        bits.next = skylight_sh_stream;
        bits.held = 0;
        bits.count = 0;
        memset(lengths, 0, sizeof lengths);
        for (i = 0; i < 32; ++i) profile[i] = 0;
        for (i = 0; i < 4; ++i) rest[i] *= 0.00189133582f;
        for (l = 0; l < bands; ++l) {
            const int used = (int)skylight_sh_fixed(&bits, 5);
            for (i = 0; i < used; ++i) profile[i] = (int)skylight_sh_fixed(&bits, 5);
            for (m = 0; m <= l; ++m) {
                for (channel = 0; channel < SKYLIGHT_SH_CHANNELS; ++channel) {
                    skylight_sh_real value = 0;
                    for (r = 0; r < 4; ++r) {
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
