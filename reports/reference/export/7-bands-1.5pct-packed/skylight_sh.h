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
 * Accuracy, as shipped: E_mean 1.44 %, E_max 6.13 % of the least luminance of the same sky, at azimuth 0.
 * The expansion rings: the least value it takes, over all directions and measured sets, is -12.8 % of its largest
 * in the same set; the window below tames it.
 * Memory: 1621 bytes of constants, packed into few bytes (a fast table takes more and less time).
 *
 * Provenance
 *   skylight-sh 0.1.0, config preetham 7738be1e848979ca, table 7-bands-1.5pct-packed
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
#define SKYLIGHT_SH_E_MEAN 1.441000e-02
#define SKYLIGHT_SH_E_MAX 6.126000e-02
#define SKYLIGHT_SH_SUN_ZENITH_MIN 0.0f
#define SKYLIGHT_SH_SUN_ZENITH_MAX 1.57079637f
#define SKYLIGHT_SH_TURBIDITY_MIN 2.5f
#define SKYLIGHT_SH_TURBIDITY_MAX 6.0f
#ifndef SKYLIGHT_SH_EXPOSURE
#define SKYLIGHT_SH_EXPOSURE 1
#endif

typedef float skylight_sh_real;

/* Whole numbers as Rice codes, read in one forward loop. */
static const unsigned char skylight_sh_stream[1429] = {
    167, 70, 199, 86, 49, 255, 47, 0, 7, 64, 199, 238, 224, 255, 13, 7, 209, 234, 46, 252, 159, 2, 87, 104,
    252, 184, 160, 241, 255, 165, 126, 87, 197, 37, 4, 252, 151, 248, 77, 181, 248, 127, 178, 26, 68, 13, 242, 255,
    134, 190, 11, 253, 2, 150, 184, 254, 255, 75, 222, 155, 60, 254, 143, 175, 157, 255, 183, 198, 248, 25, 239, 247,
    63, 128, 189, 207, 153, 241, 45, 85, 136, 81, 43, 148, 2, 154, 131, 123, 56, 210, 114, 61, 73, 66, 86, 157,
    32, 91, 28, 114, 221, 244, 2, 119, 104, 79, 243, 70, 144, 137, 95, 23, 131, 70, 104, 217, 243, 250, 245, 170,
    38, 32, 187, 209, 243, 251, 126, 241, 127, 248, 215, 121, 94, 120, 244, 36, 174, 199, 70, 127, 179, 40, 27, 129,
    130, 213, 2, 114, 65, 134, 95, 169, 98, 138, 192, 49, 197, 184, 130, 34, 65, 61, 67, 168, 177, 38, 109, 157,
    112, 159, 77, 9, 33, 4, 131, 113, 154, 118, 156, 150, 133, 130, 204, 192, 246, 65, 255, 125, 121, 137, 147, 234,
    8, 41, 40, 190, 183, 82, 25, 227, 122, 241, 138, 201, 77, 115, 155, 225, 213, 244, 105, 115, 74, 100, 61, 43,
    16, 40, 188, 34, 170, 19, 42, 158, 248, 125, 236, 104, 9, 101, 40, 43, 26, 25, 129, 23, 26, 213, 164, 29,
    207, 253, 217, 255, 29, 14, 177, 253, 89, 91, 126, 174, 228, 110, 63, 108, 116, 134, 176, 157, 16, 212, 118, 146,
    169, 23, 13, 162, 165, 80, 90, 97, 88, 212, 243, 217, 77, 56, 232, 134, 72, 217, 114, 8, 171, 64, 6, 118,
    64, 90, 224, 177, 92, 195, 105, 161, 197, 44, 23, 160, 230, 211, 253, 251, 211, 167, 15, 238, 221, 19, 34, 75,
    227, 65, 40, 93, 131, 33, 75, 146, 220, 81, 231, 164, 89, 20, 41, 25, 201, 203, 237, 163, 113, 168, 156, 44,
    74, 47, 113, 250, 9, 87, 160, 197, 200, 39, 200, 211, 49, 210, 166, 240, 181, 100, 27, 114, 1, 21, 244, 94,
    91, 234, 16, 209, 215, 113, 251, 131, 4, 247, 217, 238, 124, 247, 35, 243, 59, 247, 96, 98, 160, 237, 189, 253,
    77, 15, 153, 179, 132, 137, 180, 118, 24, 173, 195, 201, 116, 115, 252, 118, 104, 239, 171, 188, 71, 140, 186, 158,
    12, 253, 33, 111, 144, 214, 240, 44, 159, 196, 223, 60, 189, 103, 102, 162, 150, 182, 221, 3, 176, 138, 69, 151,
    189, 240, 145, 44, 146, 112, 113, 22, 200, 74, 93, 233, 116, 169, 202, 13, 211, 172, 63, 232, 245, 210, 193, 120,
    49, 66, 150, 166, 87, 124, 104, 101, 51, 98, 178, 225, 226, 209, 5, 255, 218, 42, 122, 252, 194, 152, 147, 198,
    22, 246, 58, 61, 97, 99, 100, 228, 165, 226, 160, 243, 150, 143, 204, 211, 217, 197, 154, 118, 10, 142, 104, 211,
    92, 235, 155, 137, 254, 20, 34, 197, 133, 29, 163, 190, 2, 152, 128, 153, 92, 179, 144, 15, 88, 3, 18, 57,
    198, 235, 213, 43, 65, 41, 17, 122, 199, 49, 99, 136, 148, 69, 30, 134, 69, 8, 140, 34, 48, 65, 200, 90,
    14, 224, 35, 164, 47, 230, 177, 121, 68, 92, 70, 85, 210, 164, 240, 159, 212, 90, 91, 9, 21, 1, 222, 17,
    185, 6, 107, 216, 76, 73, 139, 183, 15, 202, 235, 33, 70, 139, 151, 120, 252, 150, 35, 249, 183, 6, 224, 123,
    253, 133, 97, 185, 28, 190, 167, 184, 112, 252, 101, 180, 238, 107, 204, 212, 177, 50, 134, 186, 114, 229, 0, 105,
    199, 238, 127, 230, 87, 62, 253, 57, 174, 174, 252, 77, 185, 158, 210, 110, 227, 150, 190, 175, 125, 124, 89, 103,
    130, 82, 99, 101, 175, 119, 193, 58, 119, 169, 202, 34, 87, 245, 195, 139, 14, 158, 229, 154, 40, 49, 205, 213,
    32, 207, 189, 85, 205, 182, 115, 242, 106, 190, 205, 185, 193, 65, 222, 79, 178, 76, 204, 22, 107, 158, 57, 85,
    74, 67, 194, 102, 56, 239, 140, 80, 7, 83, 181, 166, 121, 241, 26, 98, 142, 111, 6, 97, 69, 161, 232, 230,
    84, 48, 145, 106, 121, 185, 37, 76, 97, 176, 132, 164, 78, 27, 204, 181, 243, 49, 221, 36, 53, 186, 120, 108,
    27, 204, 23, 155, 28, 166, 134, 148, 60, 94, 9, 127, 130, 41, 156, 146, 65, 146, 213, 146, 194, 20, 134, 176,
    140, 47, 73, 124, 142, 4, 37, 208, 172, 170, 3, 23, 153, 39, 81, 104, 49, 25, 21, 73, 104, 26, 98, 102,
    64, 202, 147, 204, 69, 238, 176, 3, 28, 9, 96, 174, 20, 32, 163, 177, 19, 114, 84, 210, 52, 138, 147, 101,
    198, 148, 212, 214, 90, 9, 21, 34, 246, 207, 249, 83, 166, 237, 171, 156, 168, 223, 135, 130, 163, 27, 127, 182,
    7, 112, 224, 123, 158, 223, 159, 115, 200, 128, 45, 246, 129, 59, 79, 125, 121, 220, 232, 209, 183, 172, 30, 241,
    247, 145, 247, 35, 188, 5, 182, 7, 57, 169, 149, 253, 173, 139, 63, 13, 151, 188, 155, 231, 158, 233, 239, 199,
    65, 157, 55, 59, 236, 13, 48, 155, 123, 63, 60, 248, 194, 167, 194, 40, 205, 137, 69, 53, 44, 237, 58, 156,
    107, 238, 107, 58, 187, 229, 185, 165, 185, 235, 161, 79, 150, 43, 83, 227, 174, 70, 135, 53, 240, 202, 143, 234,
    224, 219, 134, 199, 107, 253, 88, 142, 69, 126, 187, 122, 54, 186, 231, 160, 189, 106, 79, 240, 53, 11, 39, 60,
    173, 208, 139, 173, 243, 152, 117, 10, 75, 161, 54, 147, 117, 10, 143, 88, 204, 52, 149, 122, 205, 8, 107, 61,
    132, 13, 100, 55, 10, 120, 74, 70, 108, 102, 54, 137, 236, 90, 202, 27, 49, 165, 4, 216, 163, 201, 157, 40,
    96, 130, 233, 218, 130, 75, 203, 66, 137, 164, 34, 161, 76, 57, 213, 196, 10, 233, 195, 165, 26, 143, 64, 234,
    132, 121, 20, 28, 218, 124, 68, 155, 219, 210, 65, 113, 17, 26, 148, 62, 132, 153, 73, 10, 17, 94, 162, 6,
    177, 129, 136, 5, 12, 121, 103, 72, 136, 192, 26, 27, 13, 53, 75, 66, 12, 149, 107, 176, 200, 49, 25, 34,
    54, 9, 133, 38, 78, 2, 79, 4, 224, 104, 133, 211, 66, 116, 134, 83, 128, 178, 34, 137, 133, 34, 84, 49,
    112, 146, 101, 20, 101, 162, 32, 138, 45, 165, 18, 42, 67, 132, 183, 108, 157, 180, 28, 25, 175, 202, 126, 4,
    134, 247, 112, 222, 215, 75, 92, 188, 128, 78, 110, 61, 49, 220, 149, 247, 3, 112, 190, 225, 184, 239, 69, 24,
    186, 248, 61, 69, 27, 93, 229, 7, 23, 204, 84, 255, 84, 45, 186, 223, 95, 6, 143, 118, 191, 227, 244, 179,
    126, 210, 68, 249, 226, 124, 220, 123, 112, 114, 134, 215, 199, 249, 30, 134, 49, 110, 198, 67, 206, 204, 54, 238,
    156, 12, 87, 70, 186, 113, 216, 143, 28, 113, 199, 233, 50, 11, 68, 16, 210, 222, 81, 186, 147, 245, 23, 231,
    167, 74, 219, 48, 54, 62, 107, 178, 140, 14, 31, 31, 238, 239, 14, 180, 102, 153, 158, 251, 254, 132, 41, 207,
    193, 177, 76, 12, 151, 23, 39, 72, 47, 245, 228, 245, 52, 30, 238, 73, 39, 95, 27, 58, 214, 171, 78, 106,
    129, 92, 34, 33, 23, 31, 181, 78, 250, 180, 225, 222, 133, 83, 177, 133, 231, 220, 106, 63, 165, 237, 130, 160,
    169, 101, 99, 117, 58, 177, 176, 148, 128, 30, 176, 89, 52, 162, 12, 32, 94, 125, 128, 235, 97, 184, 148, 111,
    69, 56, 74, 34, 202, 33, 69, 213, 69, 32, 10, 75, 17, 186, 73, 70, 19, 144, 64, 222, 117, 34, 70, 74,
    9, 110, 128, 50, 67, 162, 224, 98, 170, 12, 175, 10, 19, 66, 0, 38, 150, 98, 160, 20, 156, 92, 170, 2,
    184, 44, 170, 13, 201, 68, 138, 10, 42, 149, 24, 122, 8, 40, 96, 230, 32, 17, 73, 37, 147, 131, 166, 147,
    46, 36, 48, 83, 82, 22, 23, 142, 21, 68, 64, 40, 54, 5, 158, 176, 128, 32, 192, 182, 8, 17, 202, 128,
    136, 73, 142, 130, 48, 53, 130, 113, 14, 153, 116, 34, 2
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
    static const signed char rest_profile[5] = { 4, 0, -3, -7, -13 };
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
                value *= 0.00129699707f;
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
