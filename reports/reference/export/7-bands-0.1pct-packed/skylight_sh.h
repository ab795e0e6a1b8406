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
 * Accuracy, as shipped: E_mean 0.0999 %, E_max 0.447 % of the least luminance of the same sky, at azimuth 0.
 * The expansion rings: the least value it takes, over all directions and measured sets, is -13.8 % of its largest
 * in the same set; the window below tames it.
 * Memory: 3241 bytes of constants, packed into few bytes (a fast table takes more and less time).
 *
 * Provenance
 *   config preetham, table 7-bands-0.1pct-packed
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
#define SKYLIGHT_SH_E_MEAN 9.988810e-04
#define SKYLIGHT_SH_E_MAX 4.473470e-03
#define SKYLIGHT_SH_SUN_ZENITH_MIN 0.0f
#define SKYLIGHT_SH_SUN_ZENITH_MAX 1.57079637f
#define SKYLIGHT_SH_TURBIDITY_MIN 2.5f
#define SKYLIGHT_SH_TURBIDITY_MAX 6.0f
#ifndef SKYLIGHT_SH_EXPOSURE
#define SKYLIGHT_SH_EXPOSURE 1
#endif

typedef float skylight_sh_real;

/* Whole numbers as Rice codes, read in one forward loop. */
static const unsigned char skylight_sh_stream[3043] = {
    105, 99, 42, 165, 50, 102, 252, 255, 59, 208, 51, 142, 224, 61, 162, 215, 71, 18, 70, 255, 255, 155, 115, 33,
    163, 85, 94, 98, 128, 114, 59, 255, 255, 156, 129, 181, 173, 122, 83, 94, 237, 127, 220, 99, 87, 38, 191, 24,
    236, 55, 51, 254, 255, 123, 62, 135, 34, 235, 234, 86, 129, 1, 89, 144, 255, 223, 116, 192, 242, 43, 93, 198,
    62, 64, 255, 255, 76, 215, 183, 20, 104, 157, 247, 63, 142, 4, 4, 242, 143, 183, 200, 27, 250, 255, 223, 184,
    146, 23, 229, 95, 75, 220, 146, 122, 175, 144, 150, 255, 255, 151, 45, 92, 155, 204, 195, 231, 176, 253, 250, 199,
    184, 255, 255, 86, 151, 196, 59, 65, 220, 150, 127, 156, 253, 255, 89, 128, 222, 250, 237, 153, 251, 127, 0, 210,
    191, 79, 255, 136, 146, 244, 165, 18, 50, 36, 70, 211, 152, 229, 169, 51, 64, 205, 33, 58, 199, 243, 45, 213,
    174, 184, 244, 137, 90, 69, 168, 5, 207, 109, 23, 76, 175, 172, 16, 105, 91, 18, 10, 213, 168, 83, 32, 111,
    169, 148, 12, 229, 30, 1, 57, 61, 14, 190, 145, 49, 51, 146, 42, 144, 74, 67, 134, 82, 33, 82, 226, 225,
    9, 57, 94, 141, 248, 192, 128, 55, 10, 87, 192, 100, 72, 238, 174, 52, 208, 184, 212, 247, 215, 25, 112, 188,
    175, 63, 224, 204, 181, 95, 157, 224, 115, 1, 188, 231, 177, 62, 130, 199, 215, 127, 249, 167, 30, 134, 237, 127,
    255, 223, 45, 172, 89, 70, 220, 99, 147, 139, 168, 192, 101, 0, 229, 89, 208, 153, 255, 191, 83, 190, 18, 70,
    47, 97, 2, 109, 244, 118, 138, 118, 15, 61, 219, 47, 24, 48, 122, 28, 137, 29, 147, 203, 107, 48, 59, 88,
    34, 1, 31, 245, 38, 212, 11, 56, 18, 216, 142, 69, 117, 194, 28, 3, 160, 107, 30, 18, 26, 22, 45, 226,
    132, 87, 231, 159, 190, 254, 166, 93, 128, 1, 246, 19, 69, 35, 6, 142, 155, 72, 249, 23, 63, 249, 200, 201,
    136, 56, 33, 227, 86, 250, 113, 64, 32, 205, 93, 254, 185, 0, 32, 247, 159, 116, 45, 149, 144, 37, 67, 236,
    132, 94, 191, 83, 251, 244, 115, 88, 195, 52, 134, 142, 183, 127, 196, 167, 220, 176, 76, 71, 206, 228, 212, 175,
    33, 222, 217, 38, 165, 76, 28, 17, 114, 6, 41, 222, 175, 229, 175, 105, 209, 31, 22, 192, 120, 96, 127, 179,
    102, 56, 161, 221, 162, 88, 105, 51, 206, 54, 181, 129, 208, 37, 51, 222, 226, 97, 18, 27, 157, 120, 153, 60,
    3, 143, 173, 101, 42, 17, 73, 213, 63, 203, 188, 202, 88, 67, 140, 122, 142, 228, 47, 177, 45, 31, 65, 79,
    86, 178, 233, 237, 246, 187, 78, 131, 138, 249, 181, 177, 184, 238, 191, 22, 30, 103, 78, 50, 94, 63, 19, 133,
    81, 55, 208, 237, 208, 51, 134, 127, 169, 231, 144, 215, 174, 35, 147, 5, 108, 168, 54, 18, 251, 201, 24, 85,
    157, 229, 232, 183, 113, 80, 159, 32, 189, 88, 6, 61, 133, 37, 96, 213, 12, 18, 45, 47, 225, 145, 122, 236,
    38, 43, 6, 140, 39, 233, 171, 112, 140, 144, 139, 23, 44, 66, 26, 5, 224, 45, 191, 63, 29, 132, 33, 90,
    76, 63, 144, 206, 0, 160, 131, 134, 189, 211, 155, 254, 129, 117, 139, 0, 211, 35, 105, 223, 59, 250, 120, 51,
    81, 153, 171, 249, 231, 47, 64, 238, 139, 179, 154, 195, 148, 78, 181, 157, 64, 131, 163, 89, 161, 37, 168, 23,
    170, 239, 184, 57, 93, 233, 38, 152, 144, 101, 129, 208, 120, 83, 68, 68, 199, 196, 104, 32, 208, 3, 155, 17,
    106, 16, 4, 97, 14, 91, 85, 138, 91, 188, 134, 102, 126, 157, 73, 227, 58, 78, 6, 4, 154, 71, 149, 81,
    180, 152, 116, 209, 179, 252, 100, 128, 149, 88, 228, 61, 142, 68, 180, 92, 1, 184, 133, 157, 60, 167, 173, 202,
    17, 173, 18, 157, 52, 20, 201, 44, 241, 83, 31, 16, 148, 181, 84, 62, 167, 12, 1, 251, 82, 233, 197, 199,
    44, 147, 205, 47, 5, 21, 204, 225, 174, 224, 47, 133, 103, 105, 238, 175, 131, 155, 64, 8, 243, 209, 36, 4,
    124, 236, 251, 162, 231, 112, 171, 49, 59, 251, 246, 100, 205, 62, 160, 70, 209, 27, 166, 11, 244, 248, 200, 180,
    170, 231, 27, 207, 234, 19, 216, 138, 99, 154, 238, 126, 117, 115, 166, 252, 206, 88, 43, 163, 91, 162, 150, 189,
    41, 172, 13, 31, 97, 243, 234, 85, 200, 37, 191, 44, 113, 116, 93, 46, 116, 82, 67, 138, 113, 154, 95, 30,
    230, 147, 248, 101, 91, 62, 229, 172, 243, 124, 219, 80, 122, 226, 189, 253, 106, 150, 35, 93, 181, 237, 91, 24,
    159, 33, 152, 91, 99, 218, 82, 187, 233, 94, 153, 207, 205, 100, 37, 63, 230, 149, 10, 114, 101, 0, 214, 234,
    250, 137, 197, 71, 137, 156, 181, 183, 43, 216, 35, 65, 103, 121, 89, 178, 1, 231, 154, 187, 240, 72, 22, 232,
    59, 247, 236, 231, 48, 226, 109, 68, 172, 170, 51, 227, 53, 6, 76, 83, 68, 234, 181, 151, 208, 231, 113, 107,
    246, 52, 99, 220, 22, 229, 244, 160, 166, 67, 123, 55, 142, 231, 190, 245, 83, 25, 62, 39, 182, 56, 17, 182,
    239, 83, 3, 203, 238, 158, 252, 27, 66, 119, 108, 12, 24, 157, 239, 77, 141, 116, 160, 102, 84, 76, 54, 78,
    211, 243, 150, 213, 113, 8, 93, 141, 201, 187, 87, 100, 132, 202, 52, 16, 5, 69, 121, 0, 98, 193, 125, 80,
    180, 16, 185, 246, 140, 53, 218, 176, 128, 57, 37, 10, 15, 54, 117, 167, 26, 45, 162, 176, 185, 216, 59, 40,
    167, 17, 129, 58, 103, 194, 66, 74, 236, 184, 110, 107, 100, 94, 43, 40, 12, 217, 48, 64, 90, 96, 16, 23,
    157, 194, 217, 243, 86, 13, 181, 38, 66, 241, 26, 61, 181, 32, 36, 169, 141, 121, 7, 32, 138, 56, 115, 101,
    27, 171, 101, 157, 28, 41, 176, 124, 9, 13, 229, 251, 195, 141, 176, 149, 38, 61, 88, 52, 199, 68, 194, 192,
    245, 81, 248, 17, 159, 40, 99, 65, 209, 33, 104, 65, 33, 197, 10, 114, 42, 8, 0, 169, 242, 44, 151, 56,
    68, 212, 17, 12, 49, 17, 33, 0, 200, 134, 170, 128, 158, 233, 135, 219, 160, 105, 54, 34, 36, 208, 33, 22,
    203, 91, 30, 25, 157, 28, 193, 138, 86, 181, 98, 138, 2, 145, 44, 242, 99, 81, 42, 37, 116, 10, 21, 17,
    118, 56, 37, 176, 103, 122, 89, 44, 109, 192, 96, 61, 88, 206, 87, 224, 79, 72, 234, 101, 231, 103, 219, 194,
    38, 236, 192, 162, 85, 44, 56, 88, 132, 238, 102, 185, 64, 58, 159, 181, 125, 176, 112, 211, 128, 148, 226, 251,
    94, 188, 51, 31, 168, 201, 93, 14, 169, 151, 124, 207, 21, 241, 101, 216, 177, 222, 179, 240, 232, 78, 217, 189,
    41, 219, 5, 54, 151, 103, 111, 181, 172, 209, 164, 49, 171, 48, 180, 106, 137, 30, 8, 16, 12, 71, 188, 99,
    127, 116, 159, 35, 173, 111, 192, 51, 170, 218, 230, 250, 217, 51, 101, 66, 235, 173, 127, 255, 58, 38, 236, 186,
    254, 21, 155, 191, 79, 164, 190, 55, 125, 128, 103, 220, 158, 253, 194, 56, 255, 240, 47, 182, 244, 115, 172, 249,
    240, 233, 186, 146, 168, 199, 119, 183, 179, 164, 175, 43, 108, 163, 123, 161, 130, 237, 193, 189, 106, 173, 29, 235,
    91, 12, 206, 13, 238, 251, 88, 47, 231, 250, 124, 215, 226, 158, 216, 117, 231, 92, 126, 239, 94, 61, 108, 131,
    38, 70, 168, 232, 10, 152, 39, 71, 245, 229, 171, 236, 51, 205, 54, 150, 198, 118, 91, 102, 226, 59, 10, 53,
    248, 58, 159, 98, 16, 163, 203, 162, 99, 66, 47, 254, 181, 74, 62, 169, 98, 221, 155, 2, 71, 206, 182, 217,
    221, 240, 121, 58, 103, 133, 170, 105, 111, 176, 180, 248, 178, 18, 156, 121, 187, 159, 211, 132, 136, 177, 122, 129,
    190, 66, 135, 34, 136, 158, 138, 222, 253, 22, 133, 105, 239, 220, 18, 41, 77, 33, 241, 247, 69, 63, 193, 202,
    193, 80, 171, 69, 116, 92, 75, 125, 18, 173, 84, 163, 121, 142, 129, 192, 102, 36, 27, 62, 16, 163, 183, 89,
    206, 160, 115, 44, 71, 80, 191, 72, 209, 162, 123, 8, 124, 205, 106, 51, 49, 190, 116, 95, 30, 183, 229, 2,
    145, 165, 188, 130, 74, 51, 226, 120, 179, 155, 202, 141, 126, 188, 29, 200, 102, 51, 244, 55, 211, 84, 108, 238,
    22, 200, 88, 48, 5, 102, 10, 254, 112, 66, 170, 28, 197, 249, 76, 184, 123, 186, 32, 32, 232, 186, 168, 32,
    231, 170, 90, 3, 153, 116, 125, 168, 116, 159, 153, 1, 61, 57, 8, 198, 230, 28, 82, 14, 38, 110, 63, 23,
    166, 146, 202, 46, 14, 139, 63, 188, 194, 17, 146, 0, 10, 16, 3, 55, 227, 162, 38, 192, 42, 3, 70, 221,
    24, 72, 89, 74, 253, 177, 152, 61, 227, 152, 163, 119, 228, 132, 6, 4, 176, 128, 132, 195, 185, 124, 26, 58,
    240, 236, 228, 96, 52, 65, 5, 41, 152, 176, 92, 20, 223, 68, 38, 119, 123, 208, 97, 12, 98, 130, 67, 78,
    1, 144, 162, 188, 77, 222, 29, 13, 55, 52, 18, 65, 32, 122, 18, 135, 104, 96, 35, 125, 37, 2, 199, 213,
    229, 38, 29, 229, 32, 197, 29, 21, 69, 155, 70, 154, 164, 160, 50, 217, 52, 142, 99, 16, 229, 32, 176, 168,
    148, 240, 53, 150, 12, 9, 251, 167, 243, 159, 94, 195, 239, 27, 179, 186, 159, 203, 117, 33, 180, 125, 210, 34,
    56, 169, 95, 181, 202, 67, 123, 139, 99, 42, 158, 150, 9, 166, 13, 239, 159, 254, 135, 5, 112, 191, 72, 217,
    31, 189, 135, 204, 156, 120, 29, 27, 254, 169, 170, 212, 7, 250, 164, 125, 211, 231, 189, 171, 245, 73, 139, 242,
    209, 173, 180, 176, 252, 81, 248, 42, 140, 222, 127, 118, 184, 37, 59, 46, 191, 159, 120, 222, 87, 48, 123, 85,
    9, 57, 150, 190, 101, 115, 240, 110, 231, 154, 158, 248, 52, 87, 203, 234, 204, 199, 253, 212, 177, 118, 156, 25,
    121, 25, 28, 109, 63, 5, 222, 149, 99, 231, 247, 117, 102, 25, 105, 231, 224, 116, 31, 238, 127, 137, 26, 211,
    111, 169, 224, 20, 126, 39, 51, 253, 73, 190, 33, 237, 201, 85, 207, 130, 76, 170, 236, 229, 101, 137, 196, 128,
    43, 85, 13, 163, 21, 115, 141, 186, 113, 255, 55, 193, 63, 246, 53, 145, 100, 240, 151, 193, 243, 241, 239, 26,
    58, 121, 23, 35, 212, 216, 107, 46, 61, 161, 110, 57, 102, 132, 107, 218, 108, 72, 54, 119, 108, 232, 14, 252,
    173, 78, 233, 20, 219, 154, 105, 28, 106, 174, 137, 179, 170, 60, 194, 241, 242, 33, 15, 254, 89, 22, 91, 249,
    67, 197, 246, 60, 247, 244, 56, 220, 142, 203, 75, 49, 105, 193, 249, 235, 68, 218, 31, 239, 112, 126, 19, 220,
    129, 10, 147, 238, 21, 86, 253, 179, 49, 190, 45, 61, 216, 97, 14, 194, 172, 49, 161, 175, 223, 19, 73, 33,
    84, 160, 94, 244, 150, 253, 68, 128, 251, 214, 105, 210, 53, 202, 22, 154, 186, 167, 150, 217, 55, 202, 174, 224,
    127, 16, 245, 11, 198, 89, 233, 105, 125, 48, 166, 56, 204, 89, 182, 130, 114, 30, 35, 211, 246, 159, 63, 104,
    13, 81, 24, 240, 219, 84, 107, 14, 168, 196, 221, 114, 228, 36, 15, 234, 126, 230, 113, 183, 79, 37, 57, 2,
    208, 197, 64, 70, 118, 222, 222, 5, 254, 249, 121, 22, 227, 137, 45, 25, 20, 238, 129, 112, 178, 134, 122, 22,
    82, 83, 4, 72, 50, 196, 63, 167, 136, 1, 202, 212, 218, 38, 98, 252, 124, 11, 149, 9, 2, 147, 141, 76,
    42, 164, 98, 111, 242, 82, 153, 47, 102, 152, 88, 231, 217, 73, 73, 82, 32, 132, 176, 24, 233, 72, 212, 3,
    214, 78, 147, 44, 232, 163, 16, 77, 42, 137, 80, 115, 179, 179, 69, 155, 85, 145, 172, 182, 205, 60, 89, 46,
    5, 48, 195, 120, 20, 236, 134, 115, 231, 172, 21, 219, 224, 58, 38, 43, 77, 179, 104, 118, 3, 252, 4, 91,
    38, 71, 57, 23, 183, 28, 61, 22, 200, 58, 74, 27, 225, 222, 52, 21, 78, 33, 160, 154, 6, 131, 9, 134,
    107, 11, 102, 130, 77, 66, 139, 218, 196, 180, 236, 153, 1, 36, 233, 136, 27, 113, 216, 62, 134, 179, 141, 208,
    218, 19, 164, 22, 171, 120, 226, 12, 208, 101, 9, 201, 153, 19, 11, 1, 109, 218, 128, 141, 65, 202, 49, 16,
    71, 230, 56, 62, 74, 218, 19, 22, 21, 65, 66, 51, 31, 121, 133, 4, 168, 140, 74, 201, 201, 97, 1, 133,
    49, 72, 8, 144, 35, 92, 27, 53, 50, 203, 136, 99, 164, 134, 63, 103, 8, 112, 40, 71, 37, 89, 131, 11,
    17, 82, 34, 8, 2, 118, 193, 138, 15, 133, 37, 134, 33, 129, 74, 36, 21, 169, 160, 97, 10, 101, 149, 33,
    204, 137, 10, 23, 77, 179, 40, 32, 196, 24, 2, 38, 37, 132, 206, 49, 117, 202, 0, 219, 125, 107, 209, 165,
    109, 159, 212, 212, 183, 214, 158, 181, 247, 3, 52, 48, 209, 215, 25, 114, 250, 91, 246, 228, 223, 237, 229, 126,
    218, 87, 3, 124, 199, 216, 67, 247, 126, 134, 151, 8, 213, 138, 220, 29, 152, 202, 68, 47, 225, 57, 237, 239,
    103, 99, 226, 236, 247, 36, 207, 186, 154, 76, 253, 254, 205, 102, 229, 248, 102, 125, 100, 127, 207, 241, 53, 233,
    126, 63, 19, 191, 39, 147, 133, 35, 187, 206, 153, 143, 225, 82, 148, 177, 194, 242, 124, 41, 194, 104, 244, 11,
    226, 53, 68, 249, 53, 251, 155, 37, 1, 159, 177, 210, 158, 210, 125, 127, 104, 126, 133, 225, 185, 223, 31, 111,
    217, 79, 200, 159, 126, 211, 81, 242, 191, 174, 35, 152, 242, 42, 62, 212, 158, 197, 241, 156, 87, 228, 191, 248,
    81, 71, 190, 228, 169, 144, 128, 58, 117, 82, 235, 176, 63, 253, 121, 239, 17, 97, 207, 161, 83, 55, 186, 29,
    249, 165, 158, 202, 8, 183, 14, 134, 30, 139, 254, 102, 29, 224, 215, 156, 195, 190, 60, 68, 39, 212, 95, 78,
    252, 193, 221, 246, 164, 61, 62, 190, 214, 167, 118, 165, 100, 100, 3, 23, 102, 125, 33, 167, 22, 231, 61, 161,
    184, 172, 7, 77, 29, 192, 124, 74, 163, 153, 27, 63, 212, 221, 240, 216, 86, 67, 158, 222, 171, 206, 222, 210,
    201, 101, 57, 157, 101, 121, 137, 238, 76, 159, 254, 209, 126, 21, 203, 60, 5, 245, 42, 86, 207, 130, 163, 61,
    248, 75, 110, 121, 152, 93, 66, 72, 98, 161, 60, 224, 21, 57, 135, 180, 74, 212, 49, 203, 132, 12, 244, 245,
    174, 229, 64, 140, 203, 33, 213, 27, 149, 62, 207, 150, 174, 147, 229, 50, 202, 156, 180, 117, 245, 193, 236, 170,
    169, 80, 246, 164, 41, 211, 97, 225, 241, 57, 113, 55, 209, 219, 9, 125, 107, 17, 26, 134, 38, 245, 194, 24,
    5, 131, 217, 166, 103, 129, 167, 43, 219, 56, 28, 220, 195, 167, 58, 48, 27, 224, 232, 216, 10, 185, 183, 151,
    227, 164, 77, 124, 39, 254, 185, 206, 73, 220, 210, 46, 113, 158, 233, 235, 221, 19, 173, 64, 112, 184, 166, 35,
    178, 165, 71, 28, 235, 155, 93, 218, 222, 25, 31, 203, 66, 28, 163, 11, 143, 229, 130, 99, 149, 24, 228, 94,
    54, 175, 74, 200, 1, 241, 237, 205, 148, 87, 85, 39, 12, 66, 248, 144, 176, 242, 51, 65, 126, 29, 24, 99,
    108, 205, 128, 102, 175, 28, 147, 50, 40, 1, 206, 158, 67, 11, 48, 173, 176, 16, 6, 203, 44, 175, 6, 2,
    252, 200, 27, 77, 118, 111, 1, 56, 44, 130, 165, 44, 129, 201, 8, 205, 61, 141, 142, 2, 212, 89, 82, 66,
    69, 16, 169, 0, 103, 66, 4, 32, 25, 95, 2, 28, 6, 205, 165, 17, 36, 209, 98, 97, 220, 206, 33, 199,
    105, 39, 232, 233, 5, 103, 152, 181, 200, 48, 147, 132, 71, 12, 38, 76, 123, 185, 9, 93, 89, 35, 40, 238,
    0, 130, 7, 3, 1, 118, 86, 60, 216, 107, 248, 154, 228, 19, 202, 80, 164, 93, 0, 128, 128, 184, 108, 206,
    235, 130, 181, 152, 2, 105, 12, 89, 201, 101, 211, 189, 29, 31, 175, 89, 154, 214, 137, 195, 202, 1, 31, 50,
    36, 10, 174, 64, 170, 88, 189, 112, 177, 181, 144, 161, 208, 136, 80, 119, 136, 160, 168, 6, 171, 234, 136, 231,
    172, 39, 34, 164, 4, 58, 210, 168, 93, 138, 146, 71, 104, 167, 195, 72, 50, 105, 4, 143, 38, 132, 159, 7,
    100, 229, 167, 19, 195, 211, 53, 138, 66, 200, 20, 1, 193, 151, 244, 124, 117, 163, 24, 0, 76, 16, 100, 233,
    42, 90, 91, 120, 144, 145, 100, 54, 8, 36, 70, 34, 132, 112, 81, 144, 72, 12, 8, 238, 150, 8, 79, 110,
    172, 57, 34, 64, 81, 134, 202, 107, 6, 121, 228, 228, 35, 66, 96, 129, 131, 161, 206, 97, 1, 6, 226, 49,
    50, 71, 30, 66, 232, 144, 108, 84, 0, 166, 98, 65, 35, 57, 18, 160, 35, 68, 12
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
    static const signed char rest_profile[7] = { 6, 3, -1, -7, -12, -18, -18 };
    static const signed char channel_profile[3] = { -4, -4, -3 };
    signed char lengths[SKYLIGHT_SH_CHANNELS][7];
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
                for (r = 0; r < 7; ++r) {
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
                value *= 7.84019139e-05f;
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

/* All products of the other axes' bases, `rest` of 7. */
static inline void skylight_sh_rest(skylight_sh_real x1, skylight_sh_real *rest)
{
    int r = 0, i;
    skylight_sh_real t1[8];
    int i1;
    {
        const skylight_sh_real u = skylight_sh_map_1(x1);
        skylight_sh_real *t = t1;
        const int n = 7;
        t[0] = 1;
        if (n > 1) t[1] = u;
        for (i = 2; i < n; ++i) t[i] = 2 * t[i / 2] * t[i - i / 2] - t[i & 1];
    }
    for (i1 = 0; i1 < 7; ++i1)
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
    skylight_sh_real x[SKYLIGHT_SH_AXES], t0[12], rest[7], wave_cos[SKYLIGHT_SH_BANDS], wave_sin[SKYLIGHT_SH_BANDS], scale;
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
    for (i = 0; i < 7; ++i) rest[i] *= scale;
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
    skylight_sh_real x[SKYLIGHT_SH_AXES], t0[12], rest[7], wave_cos[SKYLIGHT_SH_BANDS], wave_sin[SKYLIGHT_SH_BANDS], scale;
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
            for (i = 2; i < 7; ++i) {
                t1[i] = 2 * t1[1] * t1[i - 1] - t1[i - 2];
                d1[i] = 2 * t1[i - 1] + 2 * t1[1] * d1[i - 1] - d1[i - 2];
            }
            if (a == 1)
                for (i = 0; i < 7; ++i) t1[i] = (skylight_sh_real)grown[1] * t1[i] + (skylight_sh_real)slope[1] * d1[i];
            for (i1 = 0; i1 < 7; ++i1)
                rest[r++] = t1[i1];
        }
        for (i = 0; i < 7; ++i) rest[i] *= scale;
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
