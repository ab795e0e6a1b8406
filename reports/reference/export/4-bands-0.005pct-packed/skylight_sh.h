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
 * Accuracy, as shipped: E_mean 0.0049 %, E_max 0.0138 % of the least luminance of the same sky, at azimuth 0.
 * The expansion rings: the least value it takes, over all directions and measured sets, is -13.3 % of its largest
 * in the same set; the window below tames it.
 * Memory: 2247 bytes of constants, packed into few bytes (a fast table takes more and less time).
 *
 * Provenance
 *   config preetham, table 4-bands-0.005pct-packed
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
#define SKYLIGHT_SH_E_MEAN 4.895533e-05
#define SKYLIGHT_SH_E_MAX 1.376313e-04
#define SKYLIGHT_SH_SUN_ZENITH_MIN 0.0f
#define SKYLIGHT_SH_SUN_ZENITH_MAX 1.57079637f
#define SKYLIGHT_SH_TURBIDITY_MIN 2.5f
#define SKYLIGHT_SH_TURBIDITY_MAX 6.0f
#ifndef SKYLIGHT_SH_EXPOSURE
#define SKYLIGHT_SH_EXPOSURE 1
#endif

typedef float skylight_sh_real;

/* Whole numbers as Rice codes, read in one forward loop. */
static const unsigned char skylight_sh_stream[2048] = {
    235, 127, 174, 177, 132, 76, 17, 240, 255, 255, 251, 131, 226, 158, 20, 17, 5, 162, 210, 5, 161, 40, 203, 64,
    163, 244, 164, 252, 255, 191, 255, 100, 143, 188, 76, 181, 135, 13, 178, 136, 212, 42, 197, 109, 49, 255, 255, 63,
    43, 7, 168, 107, 146, 116, 62, 130, 22, 52, 141, 160, 255, 255, 61, 28, 194, 187, 75, 90, 156, 64, 122, 190,
    255, 127, 159, 60, 212, 34, 12, 140, 126, 255, 7, 179, 253, 247, 103, 238, 242, 255, 255, 247, 255, 63, 63, 131,
    214, 12, 107, 5, 8, 94, 120, 6, 98, 59, 129, 131, 128, 252, 255, 191, 127, 208, 229, 123, 9, 40, 128, 49,
    188, 20, 233, 40, 0, 128, 252, 255, 187, 20, 99, 235, 229, 22, 130, 119, 64, 206, 167, 255, 127, 83, 14, 4,
    120, 40, 204, 243, 236, 127, 15, 80, 150, 28, 218, 255, 254, 249, 114, 60, 253, 62, 123, 155, 255, 255, 247, 1,
    54, 186, 45, 83, 22, 90, 100, 147, 17, 236, 185, 253, 56, 197, 51, 120, 245, 255, 255, 206, 189, 106, 151, 91,
    121, 197, 102, 235, 237, 188, 248, 48, 137, 169, 203, 135, 255, 255, 247, 62, 228, 64, 206, 8, 59, 33, 43, 194,
    143, 4, 245, 6, 157, 255, 255, 41, 7, 152, 183, 210, 173, 61, 90, 246, 238, 254, 249, 255, 71, 0, 75, 141,
    23, 124, 224, 127, 237, 239, 255, 69, 181, 242, 235, 143, 191, 255, 1, 104, 135, 253, 207, 53, 166, 144, 41, 34,
    64, 63, 195, 33, 106, 111, 121, 56, 0, 232, 100, 37, 6, 84, 136, 193, 132, 254, 83, 52, 90, 191, 247, 33,
    200, 127, 97, 143, 128, 173, 74, 50, 205, 32, 99, 89, 123, 190, 226, 145, 141, 77, 18, 70, 154, 57, 21, 134,
    229, 163, 98, 34, 241, 185, 251, 124, 153, 234, 3, 54, 222, 127, 154, 174, 161, 63, 162, 162, 255, 63, 177, 206,
    155, 49, 117, 115, 35, 236, 107, 78, 120, 36, 147, 1, 195, 250, 31, 139, 237, 162, 183, 28, 206, 248, 170, 32,
    145, 164, 66, 161, 221, 196, 160, 109, 112, 84, 29, 158, 18, 37, 68, 24, 72, 66, 33, 62, 166, 36, 206, 99,
    88, 19, 161, 249, 39, 139, 56, 245, 89, 102, 159, 1, 124, 203, 59, 175, 130, 47, 126, 73, 94, 124, 147, 135,
    56, 7, 136, 13, 249, 248, 46, 110, 179, 35, 79, 198, 12, 143, 5, 24, 80, 76, 182, 77, 233, 97, 95, 44,
    50, 209, 33, 216, 75, 140, 26, 242, 100, 122, 92, 205, 166, 181, 211, 188, 217, 18, 55, 243, 236, 189, 247, 254,
    105, 240, 176, 21, 125, 233, 15, 253, 186, 255, 146, 182, 186, 111, 63, 255, 131, 160, 157, 119, 140, 81, 6, 196,
    232, 34, 251, 14, 123, 213, 1, 93, 163, 192, 67, 10, 25, 39, 71, 28, 18, 102, 219, 186, 76, 3, 167, 89,
    222, 174, 20, 76, 36, 5, 117, 7, 10, 29, 16, 39, 68, 250, 102, 225, 22, 250, 115, 64, 192, 126, 36, 232,
    33, 245, 230, 8, 92, 99, 226, 80, 135, 7, 69, 101, 214, 19, 26, 31, 161, 245, 251, 118, 0, 65, 0, 41,
    60, 193, 81, 5, 36, 236, 57, 25, 238, 37, 235, 1, 22, 252, 150, 204, 176, 193, 234, 7, 120, 53, 231, 49,
    6, 20, 65, 62, 50, 14, 160, 24, 71, 216, 75, 21, 31, 245, 184, 112, 156, 44, 113, 113, 206, 185, 228, 88,
    0, 144, 87, 46, 197, 4, 165, 25, 89, 111, 0, 10, 149, 28, 5, 211, 1, 149, 179, 54, 96, 229, 147, 124,
    38, 36, 238, 16, 3, 20, 207, 218, 70, 150, 110, 74, 66, 34, 217, 186, 9, 59, 89, 19, 175, 250, 19, 144,
    80, 147, 182, 90, 70, 255, 148, 111, 174, 147, 7, 11, 94, 214, 64, 248, 251, 14, 0, 108, 73, 0, 98, 191,
    111, 125, 41, 100, 138, 0, 160, 236, 60, 223, 42, 90, 2, 130, 49, 187, 138, 181, 117, 184, 234, 73, 209, 106,
    100, 168, 111, 201, 155, 130, 136, 26, 86, 86, 227, 227, 29, 97, 118, 46, 78, 246, 86, 77, 157, 114, 42, 74,
    33, 227, 254, 173, 70, 79, 234, 133, 9, 214, 245, 131, 1, 26, 185, 125, 164, 42, 43, 140, 154, 197, 127, 45,
    216, 163, 5, 102, 38, 109, 123, 201, 133, 4, 79, 148, 239, 99, 145, 125, 225, 71, 184, 61, 7, 219, 91, 51,
    28, 179, 65, 119, 10, 207, 120, 187, 91, 21, 120, 38, 82, 120, 155, 92, 116, 19, 214, 131, 104, 140, 94, 246,
    113, 142, 245, 43, 156, 237, 203, 16, 59, 35, 75, 246, 25, 133, 96, 54, 165, 90, 33, 113, 153, 180, 80, 173,
    25, 61, 219, 190, 151, 204, 148, 118, 168, 26, 26, 174, 40, 15, 224, 75, 242, 15, 187, 70, 203, 97, 95, 125,
    229, 96, 244, 22, 188, 53, 74, 227, 182, 107, 223, 193, 75, 144, 155, 211, 175, 245, 127, 112, 3, 151, 112, 229,
    174, 127, 242, 101, 222, 61, 30, 120, 249, 243, 125, 201, 223, 192, 20, 206, 142, 233, 59, 67, 68, 19, 1, 178,
    150, 7, 100, 133, 29, 139, 241, 60, 131, 191, 196, 23, 255, 136, 229, 214, 43, 63, 35, 161, 166, 195, 96, 224,
    16, 39, 204, 124, 82, 170, 63, 134, 239, 37, 205, 112, 155, 170, 132, 7, 6, 238, 55, 192, 73, 75, 90, 130,
    110, 254, 188, 151, 163, 199, 93, 53, 187, 243, 255, 158, 134, 201, 35, 241, 72, 131, 1, 219, 153, 97, 116, 170,
    220, 164, 87, 231, 15, 250, 101, 228, 38, 140, 39, 161, 104, 208, 64, 141, 7, 198, 34, 173, 17, 115, 152, 43,
    28, 228, 49, 246, 237, 12, 83, 222, 143, 46, 4, 2, 76, 104, 100, 32, 228, 51, 6, 43, 25, 23, 84, 151,
    160, 29, 21, 91, 62, 117, 195, 112, 36, 164, 6, 153, 152, 7, 160, 33, 44, 53, 179, 129, 238, 208, 15, 152,
    231, 150, 252, 84, 89, 7, 50, 245, 8, 177, 164, 168, 243, 212, 76, 251, 77, 241, 79, 249, 10, 102, 121, 41,
    245, 224, 199, 252, 75, 254, 196, 129, 165, 167, 224, 48, 252, 239, 191, 8, 209, 124, 126, 2, 244, 47, 239, 193,
    135, 109, 215, 176, 110, 227, 33, 33, 71, 121, 160, 99, 51, 226, 76, 113, 147, 166, 3, 44, 36, 182, 13, 210,
    56, 134, 165, 247, 162, 201, 203, 211, 210, 12, 137, 48, 182, 49, 48, 210, 220, 40, 23, 4, 61, 102, 125, 116,
    78, 113, 17, 23, 132, 20, 5, 136, 72, 155, 115, 223, 83, 152, 93, 219, 84, 50, 155, 67, 51, 9, 41, 144,
    14, 70, 247, 161, 250, 42, 204, 193, 187, 196, 217, 152, 218, 140, 26, 21, 137, 146, 56, 48, 103, 99, 193, 74,
    224, 115, 76, 15, 140, 224, 211, 52, 231, 167, 24, 215, 66, 25, 39, 182, 68, 88, 104, 44, 198, 143, 86, 125,
    91, 46, 133, 65, 38, 144, 166, 140, 28, 115, 42, 229, 62, 196, 251, 9, 34, 135, 223, 101, 0, 37, 152, 151,
    147, 122, 235, 164, 161, 115, 187, 2, 90, 160, 211, 191, 96, 204, 160, 44, 102, 156, 66, 41, 95, 205, 198, 27,
    88, 253, 117, 54, 23, 58, 30, 7, 166, 107, 1, 192, 236, 15, 235, 125, 231, 91, 165, 83, 134, 128, 251, 42,
    152, 95, 1, 225, 180, 104, 177, 249, 91, 71, 92, 139, 106, 46, 51, 228, 94, 215, 241, 157, 133, 15, 209, 158,
    217, 188, 137, 114, 47, 44, 28, 117, 32, 16, 153, 111, 185, 42, 10, 194, 81, 0, 163, 176, 61, 253, 94, 154,
    89, 3, 111, 84, 199, 96, 223, 175, 50, 103, 38, 219, 251, 219, 122, 204, 237, 118, 211, 255, 205, 151, 126, 119,
    180, 79, 145, 158, 65, 254, 10, 39, 88, 34, 177, 136, 16, 9, 60, 117, 193, 198, 1, 19, 42, 116, 175, 25,
    58, 224, 46, 152, 212, 78, 56, 231, 253, 91, 111, 107, 142, 169, 155, 58, 19, 243, 59, 61, 153, 149, 123, 205,
    40, 150, 51, 223, 112, 90, 169, 99, 207, 235, 169, 202, 209, 210, 231, 153, 97, 61, 203, 72, 24, 222, 5, 55,
    116, 105, 156, 208, 187, 82, 210, 211, 33, 44, 165, 164, 89, 41, 175, 2, 133, 209, 205, 227, 155, 126, 20, 235,
    155, 252, 206, 28, 220, 119, 88, 233, 244, 210, 169, 200, 152, 179, 183, 190, 234, 71, 56, 236, 3, 147, 187, 51,
    247, 233, 111, 54, 136, 111, 244, 134, 183, 67, 15, 66, 227, 185, 127, 67, 204, 83, 224, 181, 90, 221, 29, 149,
    31, 103, 72, 191, 21, 142, 76, 149, 236, 65, 106, 51, 16, 138, 49, 223, 202, 252, 84, 222, 89, 214, 53, 124,
    121, 141, 101, 14, 24, 183, 48, 119, 241, 70, 131, 155, 122, 186, 239, 174, 240, 61, 136, 197, 49, 205, 211, 143,
    7, 147, 16, 84, 34, 175, 249, 26, 132, 248, 93, 135, 191, 183, 230, 159, 189, 22, 172, 87, 158, 180, 83, 235,
    226, 186, 169, 171, 182, 157, 251, 85, 15, 18, 215, 152, 74, 125, 66, 53, 213, 104, 205, 68, 94, 50, 37, 95,
    199, 80, 36, 175, 172, 203, 90, 176, 50, 255, 221, 35, 248, 139, 251, 72, 89, 129, 21, 32, 138, 24, 50, 230,
    186, 223, 21, 13, 55, 144, 167, 56, 181, 62, 20, 78, 98, 87, 209, 196, 11, 94, 169, 133, 176, 7, 32, 215,
    93, 139, 19, 200, 116, 187, 130, 101, 159, 89, 245, 160, 104, 215, 1, 231, 101, 133, 3, 113, 183, 116, 205, 217,
    227, 42, 42, 170, 101, 124, 183, 51, 34, 95, 249, 244, 243, 5, 196, 103, 175, 31, 210, 235, 127, 33, 160, 156,
    63, 55, 0, 223, 81, 87, 172, 100, 88, 131, 150, 225, 247, 56, 30, 227, 165, 102, 155, 127, 30, 92, 124, 17,
    183, 199, 57, 115, 137, 176, 14, 36, 65, 80, 245, 129, 0, 38, 109, 82, 168, 203, 77, 137, 202, 251, 32, 4,
    87, 64, 29, 85, 130, 225, 176, 8, 5, 153, 104, 4, 166, 167, 113, 26, 4, 249, 109, 247, 133, 199, 231, 33,
    221, 198, 117, 152, 229, 48, 16, 63, 138, 98, 13, 4, 0, 231, 255, 78, 182, 53, 174, 202, 173, 138, 42, 193,
    225, 146, 235, 27, 135, 41, 15, 57, 214, 241, 16, 133, 116, 75, 148, 183, 159, 218, 76, 81, 228, 41, 37, 66,
    133, 103, 55, 49, 78, 133, 67, 58, 78, 36, 225, 201, 143, 130, 77, 52, 123, 35, 206, 0, 171, 24, 146, 65,
    86, 201, 136, 116, 120, 176, 79, 225, 38, 23, 171, 216, 72, 99, 163, 42, 182, 216, 117, 160, 135, 84, 181, 125,
    196, 17, 62, 169, 213, 57, 231, 9, 229, 251, 63, 163, 16, 80, 170, 17, 239, 45, 0, 76, 188, 104, 135, 243,
    181, 55, 103, 107, 186, 183, 173, 0, 39, 89, 16, 210, 24, 79, 105, 76, 105, 53, 21, 133, 126, 20, 147, 195,
    68, 51, 97, 36, 204, 83, 57, 34, 16, 227, 156, 70, 162, 4, 152, 148, 6, 39, 195, 0, 10, 88, 217, 128,
    53, 131, 198, 19, 33, 44, 66, 54, 126, 221, 36, 136, 157, 52, 75, 225, 8, 40, 115, 200, 134, 17, 72, 224,
    8, 45, 238, 5, 127, 213, 22, 132, 13, 138, 116, 103, 129, 72, 126, 92, 43, 35, 118, 252, 120, 169, 157, 151,
    37, 42, 128, 65, 226, 102, 36, 7, 226, 84, 27, 60, 33, 98, 204, 25, 31, 70, 180, 147, 104, 110, 84, 141,
    67, 42, 162, 100, 58, 169, 32, 21, 164, 232, 154, 184, 158, 144, 126, 240, 96, 248, 226, 245, 102, 75, 10, 220,
    210, 76, 43, 221, 132, 244, 178, 156, 217, 53, 35, 205, 43, 157, 241, 4, 36, 78, 121, 198, 72, 99, 86, 119,
    22, 34, 14, 130, 129, 1, 32, 2
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
    static const signed char rest_profile[8] = { 10, 7, 3, -3, -9, -15, -19, -20 };
    static const signed char channel_profile[3] = { -7, -8, -5 };
    signed char lengths[SKYLIGHT_SH_CHANNELS][8];
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
                for (r = 0; r < 8; ++r) {
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
                value *= 4.47258662e-06f;
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
    const int n = 12;
    int i;
    for (i = 0; i < 12; ++i) t[i] = 0;
    t[0] = 1;
    if (n > 1) t[1] = u;
    for (i = 2; i < n; ++i) t[i] = 2 * t[i / 2] * t[i - i / 2] - t[i & 1];
}

/* All products of the other axes' bases, `rest` of 8. */
static inline void skylight_sh_rest(skylight_sh_real x1, skylight_sh_real *rest)
{
    int r = 0, i;
    skylight_sh_real t1[8];
    int i1;
    {
        const skylight_sh_real u = skylight_sh_map_1(x1);
        skylight_sh_real *t = t1;
        const int n = 8;
        t[0] = 1;
        if (n > 1) t[1] = u;
        for (i = 2; i < n; ++i) t[i] = 2 * t[i / 2] * t[i - i / 2] - t[i & 1];
    }
    for (i1 = 0; i1 < 8; ++i1)
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
    skylight_sh_real x[SKYLIGHT_SH_AXES], t0[12], rest[8], wave_cos[SKYLIGHT_SH_BANDS], wave_sin[SKYLIGHT_SH_BANDS], scale;
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
    for (i = 0; i < 8; ++i) rest[i] *= scale;
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
    skylight_sh_real x[SKYLIGHT_SH_AXES], t0[12], rest[8], wave_cos[SKYLIGHT_SH_BANDS], wave_sin[SKYLIGHT_SH_BANDS], scale;
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
            for (i = 2; i < 12; ++i) d[i] = 2 * t0[i - 1] + 2 * t0[1] * d[i - 1] - d[i - 2];
            for (i = 0; i < 12; ++i) t0[i] = (skylight_sh_real)grown[0] * t0[i] + (skylight_sh_real)slope[0] * d[i];
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
            for (i = 2; i < 8; ++i) {
                t1[i] = 2 * t1[1] * t1[i - 1] - t1[i - 2];
                d1[i] = 2 * t1[i - 1] + 2 * t1[1] * d1[i - 1] - d1[i - 2];
            }
            if (a == 1)
                for (i = 0; i < 8; ++i) t1[i] = (skylight_sh_real)grown[1] * t1[i] + (skylight_sh_real)slope[1] * d1[i];
            for (i1 = 0; i1 < 8; ++i1)
                rest[r++] = t1[i1];
        }
        for (i = 0; i < 8; ++i) rest[i] *= scale;
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
