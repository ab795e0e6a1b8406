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
 * Accuracy, as shipped: E_mean 0.0944 %, E_max 0.41 % of the least luminance of the same sky, at azimuth 0.
 * The expansion rings: the least value it takes, over all directions and measured sets, is -12.7 % of its largest
 * in the same set; the window below tames it.
 * Memory: 3253 bytes of constants, packed into few bytes (a fast table takes more and less time).
 *
 * Provenance
 *   skylight-sh 0.1.0, config preetham 7738be1e848979ca, table 7-bands-0.1pct-packed
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
#define SKYLIGHT_SH_E_MEAN 9.436000e-04
#define SKYLIGHT_SH_E_MAX 4.100000e-03
#define SKYLIGHT_SH_SUN_ZENITH_MIN 0.0f
#define SKYLIGHT_SH_SUN_ZENITH_MAX 1.57079637f
#define SKYLIGHT_SH_TURBIDITY_MIN 2.5f
#define SKYLIGHT_SH_TURBIDITY_MAX 6.0f
#ifndef SKYLIGHT_SH_EXPOSURE
#define SKYLIGHT_SH_EXPOSURE 1
#endif

typedef float skylight_sh_real;

/* Whole numbers as Rice codes, read in one forward loop. */
static const unsigned char skylight_sh_stream[3059] = {
    105, 91, 42, 165, 50, 100, 252, 255, 11, 193, 61, 2, 209, 31, 235, 11, 36, 10, 227, 255, 255, 230, 123, 248,
    184, 222, 219, 76, 81, 238, 230, 255, 159, 53, 224, 94, 173, 56, 230, 109, 255, 35, 127, 114, 39, 242, 195, 166,
    126, 41, 227, 255, 191, 17, 58, 26, 55, 139, 247, 10, 12, 200, 130, 254, 127, 3, 16, 95, 165, 222, 37, 237,
    67, 244, 255, 207, 126, 149, 231, 64, 235, 188, 255, 161, 4, 16, 200, 63, 94, 67, 94, 208, 255, 255, 102, 39,
    125, 207, 97, 23, 162, 23, 40, 188, 134, 100, 249, 255, 127, 65, 200, 23, 182, 153, 249, 156, 46, 131, 255, 249,
    220, 255, 127, 139, 207, 49, 56, 77, 222, 166, 127, 158, 251, 255, 105, 136, 93, 251, 253, 161, 251, 127, 0, 226,
    247, 188, 127, 200, 146, 178, 165, 18, 50, 36, 68, 99, 192, 13, 171, 52, 160, 205, 34, 60, 199, 99, 189, 14,
    238, 187, 247, 169, 106, 197, 216, 37, 162, 149, 87, 204, 239, 172, 24, 227, 107, 90, 42, 117, 154, 210, 89, 169,
    55, 108, 118, 198, 117, 147, 136, 156, 158, 141, 255, 198, 167, 102, 50, 101, 32, 53, 199, 12, 83, 97, 82, 226,
    225, 133, 28, 175, 134, 124, 58, 201, 27, 165, 77, 18, 39, 82, 188, 48, 26, 160, 167, 198, 95, 176, 231, 195,
    201, 127, 25, 1, 135, 174, 55, 244, 225, 62, 34, 194, 171, 158, 227, 83, 241, 132, 254, 111, 255, 232, 129, 88,
    123, 253, 28, 180, 44, 106, 239, 1, 209, 125, 215, 230, 54, 144, 6, 88, 134, 250, 220, 248, 230, 25, 203, 152,
    189, 132, 9, 192, 249, 245, 20, 237, 30, 251, 105, 191, 96, 129, 185, 22, 73, 90, 201, 48, 245, 198, 77, 15,
    154, 72, 192, 135, 201, 67, 235, 98, 78, 134, 182, 100, 49, 158, 177, 195, 0, 116, 207, 99, 202, 194, 162, 33,
    232, 132, 139, 71, 164, 22, 244, 8, 76, 115, 0, 141, 12, 174, 137, 129, 233, 102, 212, 255, 221, 143, 62, 210,
    51, 17, 167, 229, 92, 75, 63, 14, 9, 82, 93, 230, 159, 47, 0, 136, 243, 39, 89, 75, 37, 100, 200, 12,
    59, 169, 175, 37, 128, 126, 64, 138, 172, 97, 26, 15, 172, 47, 145, 192, 207, 187, 100, 57, 142, 164, 133, 85,
    177, 34, 191, 140, 119, 149, 50, 68, 35, 66, 206, 64, 197, 155, 197, 152, 54, 74, 138, 196, 2, 24, 255, 179,
    227, 221, 156, 231, 148, 22, 140, 70, 229, 109, 174, 125, 122, 3, 161, 223, 27, 242, 22, 195, 36, 54, 37, 178,
    91, 151, 168, 5, 155, 114, 209, 152, 73, 169, 127, 102, 123, 131, 242, 134, 24, 21, 157, 202, 95, 102, 171, 63,
    147, 162, 180, 100, 227, 219, 237, 55, 30, 8, 21, 243, 107, 99, 184, 244, 211, 194, 51, 221, 249, 201, 11, 112,
    194, 112, 234, 6, 186, 253, 64, 157, 214, 127, 9, 198, 17, 217, 190, 70, 102, 139, 109, 174, 62, 18, 239, 107,
    104, 214, 44, 44, 71, 191, 132, 7, 17, 73, 212, 171, 237, 16, 32, 177, 7, 173, 122, 126, 101, 205, 75, 122,
    190, 30, 219, 211, 22, 68, 227, 137, 26, 43, 156, 17, 193, 120, 193, 66, 164, 105, 7, 242, 226, 202, 39, 58,
    211, 180, 28, 127, 66, 138, 35, 128, 90, 58, 1, 197, 94, 246, 143, 236, 182, 22, 56, 61, 160, 13, 138, 71,
    31, 111, 38, 42, 115, 55, 255, 252, 5, 136, 121, 226, 128, 233, 252, 167, 120, 173, 47, 214, 232, 112, 214, 84,
    139, 240, 253, 170, 61, 113, 174, 117, 198, 21, 35, 178, 52, 112, 116, 192, 20, 141, 136, 142, 145, 213, 4, 162,
    49, 246, 37, 218, 36, 8, 130, 29, 101, 117, 11, 92, 194, 70, 181, 128, 82, 195, 230, 149, 60, 12, 4, 154,
    71, 149, 81, 185, 40, 85, 95, 228, 124, 65, 65, 166, 197, 66, 250, 227, 74, 88, 11, 24, 128, 139, 216, 177,
    51, 219, 171, 52, 217, 74, 201, 131, 134, 66, 153, 37, 61, 250, 132, 64, 217, 58, 37, 116, 202, 16, 176, 239,
    223, 94, 241, 140, 66, 169, 189, 34, 172, 96, 14, 119, 111, 127, 183, 60, 106, 71, 240, 86, 188, 9, 11, 98,
    70, 158, 128, 132, 15, 191, 34, 122, 204, 110, 23, 102, 181, 111, 152, 46, 3, 102, 221, 112, 90, 57, 190, 64,
    143, 143, 78, 59, 125, 232, 249, 92, 96, 6, 219, 113, 98, 115, 222, 177, 111, 208, 148, 95, 155, 107, 101, 116,
    91, 212, 180, 77, 169, 50, 242, 49, 26, 97, 247, 4, 156, 9, 100, 73, 71, 228, 247, 146, 80, 141, 164, 48,
    82, 245, 203, 195, 200, 230, 254, 173, 53, 231, 72, 251, 60, 95, 249, 185, 120, 100, 215, 246, 207, 15, 66, 34,
    131, 181, 122, 92, 60, 159, 62, 164, 85, 7, 181, 229, 121, 253, 189, 79, 31, 165, 201, 86, 126, 206, 44, 21,
    232, 206, 4, 171, 87, 217, 79, 44, 63, 74, 64, 173, 31, 222, 226, 158, 37, 66, 53, 24, 38, 27, 129, 186,
    185, 32, 15, 104, 135, 198, 7, 94, 1, 81, 204, 121, 33, 17, 171, 234, 200, 124, 141, 1, 211, 196, 95, 123,
    240, 117, 118, 166, 211, 103, 95, 82, 196, 236, 50, 159, 30, 46, 112, 128, 43, 230, 120, 242, 107, 63, 221, 9,
    233, 201, 183, 7, 164, 237, 251, 244, 192, 135, 187, 145, 127, 139, 160, 61, 108, 40, 25, 211, 47, 94, 29, 149,
    110, 53, 46, 38, 27, 186, 161, 122, 251, 42, 57, 138, 175, 199, 228, 222, 44, 51, 66, 101, 26, 136, 130, 162,
    60, 2, 177, 57, 65, 224, 180, 80, 89, 55, 240, 34, 109, 88, 144, 29, 19, 237, 71, 27, 188, 85, 205, 22,
    82, 218, 108, 240, 37, 148, 211, 136, 64, 157, 19, 99, 248, 51, 149, 220, 223, 69, 34, 194, 52, 84, 134, 153,
    194, 0, 113, 193, 16, 27, 31, 157, 179, 231, 75, 69, 228, 62, 24, 197, 38, 124, 220, 64, 72, 217, 226, 81,
    7, 64, 72, 79, 211, 107, 49, 235, 107, 161, 72, 82, 32, 149, 55, 41, 98, 126, 137, 192, 17, 182, 242, 228,
    135, 139, 230, 168, 72, 24, 184, 62, 10, 79, 2, 24, 133, 236, 44, 60, 24, 90, 80, 84, 177, 130, 160, 10,
    34, 64, 42, 170, 245, 50, 199, 136, 154, 17, 12, 49, 17, 35, 56, 8, 21, 245, 4, 85, 131, 32, 94, 138,
    30, 153, 145, 72, 137, 59, 108, 177, 152, 203, 35, 35, 148, 164, 100, 108, 110, 43, 166, 163, 64, 210, 66, 126,
    44, 58, 103, 124, 78, 33, 34, 130, 51, 48, 139, 13, 134, 229, 177, 199, 49, 147, 253, 96, 95, 223, 143, 163,
    171, 245, 206, 39, 132, 235, 242, 134, 148, 228, 162, 85, 44, 56, 41, 36, 220, 205, 66, 131, 133, 142, 107, 245,
    176, 129, 83, 161, 148, 226, 251, 238, 188, 80, 67, 238, 114, 159, 115, 234, 229, 236, 241, 82, 46, 196, 157, 91,
    120, 22, 30, 245, 148, 221, 155, 98, 37, 194, 218, 51, 191, 117, 205, 90, 101, 14, 163, 11, 178, 182, 189, 90,
    199, 4, 68, 201, 144, 151, 236, 143, 238, 179, 197, 253, 42, 188, 135, 187, 237, 208, 207, 126, 86, 78, 92, 111,
    253, 123, 59, 35, 236, 237, 224, 23, 1, 18, 123, 156, 181, 191, 240, 35, 60, 227, 22, 239, 183, 75, 187, 159,
    200, 245, 246, 254, 0, 239, 132, 0, 117, 202, 162, 168, 227, 219, 219, 12, 134, 175, 139, 108, 47, 124, 149, 195,
    174, 243, 126, 247, 170, 59, 186, 96, 49, 64, 151, 90, 251, 51, 190, 162, 235, 39, 23, 23, 249, 212, 50, 247,
    14, 230, 247, 94, 184, 193, 54, 104, 34, 133, 156, 218, 36, 1, 243, 132, 191, 149, 222, 14, 174, 106, 113, 49,
    237, 248, 130, 7, 191, 104, 172, 209, 247, 249, 20, 131, 179, 200, 124, 219, 131, 169, 23, 255, 218, 13, 30, 237,
    103, 221, 155, 4, 28, 249, 219, 126, 184, 25, 196, 236, 224, 213, 234, 166, 189, 73, 243, 98, 127, 99, 28, 252,
    130, 98, 206, 147, 130, 83, 43, 6, 250, 26, 11, 139, 32, 140, 106, 132, 133, 56, 32, 179, 95, 189, 37, 82,
    154, 75, 240, 171, 27, 64, 134, 165, 147, 97, 215, 12, 41, 114, 79, 127, 18, 173, 84, 153, 42, 23, 1, 176,
    107, 37, 93, 48, 38, 67, 216, 49, 142, 36, 103, 113, 157, 194, 166, 161, 210, 18, 62, 6, 190, 102, 221, 169,
    156, 161, 246, 194, 0, 110, 203, 5, 81, 101, 126, 33, 37, 205, 154, 211, 81, 121, 41, 188, 16, 16, 46, 65,
    54, 174, 35, 208, 210, 182, 146, 131, 215, 16, 202, 134, 152, 48, 211, 240, 135, 19, 162, 202, 209, 20, 144, 31,
    187, 73, 51, 4, 5, 94, 25, 21, 234, 104, 9, 110, 32, 149, 174, 79, 245, 174, 20, 43, 161, 40, 7, 193,
    152, 57, 7, 16, 74, 141, 5, 201, 137, 1, 197, 162, 13, 7, 11, 129, 152, 69, 82, 42, 0, 21, 136, 129,
    155, 116, 211, 33, 176, 219, 194, 172, 27, 3, 93, 67, 234, 143, 69, 243, 17, 201, 29, 138, 200, 80, 108, 64,
    0, 11, 74, 70, 180, 243, 79, 131, 23, 158, 158, 29, 12, 77, 80, 65, 12, 84, 88, 118, 202, 121, 54, 163,
    122, 125, 216, 97, 12, 98, 130, 68, 90, 1, 64, 69, 121, 155, 190, 61, 26, 221, 208, 72, 4, 1, 209, 147,
    136, 214, 240, 141, 2, 154, 145, 57, 180, 100, 92, 36, 239, 88, 71, 21, 123, 44, 69, 155, 102, 158, 172, 96,
    161, 182, 22, 226, 16, 228, 20, 129, 53, 163, 140, 175, 177, 100, 8, 216, 127, 50, 249, 177, 56, 32, 215, 106,
    135, 142, 72, 182, 33, 180, 125, 30, 83, 56, 181, 107, 43, 243, 224, 222, 230, 152, 138, 168, 38, 130, 105, 195,
    254, 249, 127, 88, 4, 254, 34, 101, 255, 96, 49, 131, 166, 200, 186, 242, 252, 128, 202, 248, 7, 250, 204, 125,
    247, 167, 223, 151, 246, 89, 155, 246, 81, 107, 237, 172, 159, 6, 223, 133, 124, 255, 233, 233, 22, 216, 177, 188,
    31, 209, 222, 118, 72, 179, 203, 16, 57, 34, 229, 109, 65, 224, 253, 157, 190, 178, 167, 33, 211, 245, 210, 90,
    7, 243, 158, 124, 90, 205, 169, 153, 183, 193, 209, 253, 63, 135, 183, 237, 220, 249, 125, 77, 44, 67, 240, 112,
    60, 6, 2, 239, 29, 211, 112, 132, 26, 21, 156, 199, 175, 104, 184, 135, 242, 101, 113, 207, 238, 122, 150, 100,
    86, 167, 119, 64, 150, 96, 38, 44, 169, 106, 24, 178, 232, 107, 26, 102, 224, 107, 66, 112, 246, 98, 145, 164,
    241, 247, 131, 116, 142, 87, 142, 29, 189, 140, 89, 172, 193, 55, 181, 62, 163, 110, 185, 169, 25, 250, 97, 91,
    25, 178, 207, 77, 76, 227, 41, 120, 225, 163, 138, 114, 159, 154, 12, 197, 75, 180, 113, 102, 173, 135, 56, 222,
    62, 228, 109, 130, 7, 46, 183, 244, 199, 138, 237, 121, 238, 213, 199, 116, 155, 151, 151, 34, 210, 126, 244, 119,
    150, 193, 15, 2, 64, 239, 132, 55, 161, 194, 188, 123, 165, 141, 31, 19, 228, 27, 211, 147, 29, 232, 40, 76,
    15, 19, 250, 250, 75, 34, 164, 16, 106, 89, 95, 23, 186, 29, 154, 232, 236, 63, 15, 190, 70, 41, 67, 83,
    122, 114, 50, 27, 103, 225, 21, 9, 158, 69, 221, 105, 28, 150, 90, 109, 153, 20, 83, 28, 38, 46, 27, 67,
    59, 134, 140, 108, 87, 17, 65, 82, 15, 68, 163, 17, 98, 107, 181, 57, 160, 34, 151, 219, 145, 212, 68, 214,
    43, 160, 231, 221, 62, 45, 203, 12, 64, 23, 3, 33, 89, 139, 235, 153, 123, 243, 36, 170, 26, 144, 216, 18,
    66, 225, 74, 16, 77, 87, 209, 207, 194, 169, 41, 18, 36, 50, 68, 253, 57, 69, 12, 128, 166, 234, 86, 21,
    234, 194, 174, 180, 15, 25, 152, 140, 4, 83, 36, 22, 250, 46, 47, 149, 25, 115, 198, 137, 250, 60, 59, 41,
    73, 20, 12, 97, 45, 71, 204, 25, 120, 73, 171, 200, 101, 24, 228, 70, 34, 79, 153, 68, 200, 201, 217, 225,
    162, 173, 151, 40, 174, 109, 53, 79, 150, 75, 1, 51, 140, 71, 9, 112, 134, 151, 80, 207, 224, 5, 223, 199,
    196, 138, 213, 72, 234, 109, 33, 64, 132, 46, 35, 73, 57, 151, 103, 57, 122, 44, 129, 233, 40, 140, 4, 127,
    245, 232, 156, 68, 196, 110, 30, 24, 78, 52, 116, 91, 160, 6, 232, 36, 244, 232, 141, 196, 219, 158, 25, 64,
    18, 29, 113, 36, 21, 125, 212, 115, 136, 51, 212, 38, 2, 147, 75, 44, 81, 168, 1, 202, 44, 33, 57, 119,
    115, 12, 106, 213, 6, 108, 12, 149, 99, 32, 174, 12, 124, 128, 248, 90, 86, 46, 84, 4, 18, 158, 25, 217,
    83, 42, 128, 101, 92, 78, 78, 14, 138, 80, 88, 0, 19, 194, 230, 112, 23, 135, 79, 229, 162, 132, 99, 200,
    13, 131, 210, 16, 208, 177, 36, 197, 178, 135, 71, 37, 164, 48, 130, 32, 0, 48, 96, 209, 34, 107, 49, 67,
    145, 128, 74, 72, 43, 175, 216, 80, 165, 178, 202, 16, 231, 228, 226, 162, 121, 22, 5, 68, 70, 17, 48, 25,
    225, 123, 141, 165, 67, 4, 216, 122, 92, 157, 54, 93, 129, 196, 204, 127, 117, 109, 182, 189, 159, 171, 129, 169,
    190, 87, 138, 7, 188, 103, 79, 125, 111, 168, 247, 227, 94, 53, 200, 57, 245, 208, 251, 25, 94, 62, 52, 46,
    117, 23, 35, 28, 179, 189, 138, 40, 191, 188, 31, 152, 137, 71, 184, 46, 218, 180, 203, 201, 248, 238, 191, 65,
    173, 156, 111, 236, 143, 177, 191, 15, 233, 53, 209, 253, 126, 38, 126, 99, 141, 144, 241, 189, 226, 232, 79, 163,
    90, 202, 92, 97, 252, 9, 179, 143, 17, 109, 96, 200, 175, 56, 226, 215, 236, 247, 215, 156, 69, 254, 177, 157,
    219, 49, 95, 123, 127, 106, 191, 106, 116, 250, 29, 116, 217, 143, 223, 31, 172, 195, 210, 248, 139, 124, 26, 147,
    222, 198, 13, 181, 39, 115, 82, 199, 22, 249, 2, 79, 59, 244, 53, 127, 90, 72, 68, 159, 138, 246, 58, 220,
    31, 255, 225, 218, 33, 194, 158, 97, 39, 117, 140, 187, 114, 217, 78, 104, 138, 139, 3, 67, 143, 69, 139, 3,
    207, 112, 153, 163, 216, 183, 135, 185, 25, 245, 215, 35, 39, 47, 183, 39, 237, 241, 195, 123, 205, 218, 149, 120,
    153, 13, 92, 112, 107, 69, 79, 16, 232, 171, 66, 121, 209, 135, 91, 27, 195, 131, 246, 102, 171, 23, 63, 212,
    93, 120, 240, 229, 212, 243, 223, 84, 127, 250, 45, 125, 188, 188, 207, 205, 82, 76, 66, 61, 224, 143, 196, 188,
    47, 198, 86, 143, 66, 173, 198, 42, 90, 117, 186, 79, 176, 199, 69, 143, 179, 203, 72, 201, 108, 180, 3, 65,
    71, 86, 32, 12, 210, 18, 120, 228, 50, 48, 67, 222, 245, 237, 156, 10, 210, 158, 178, 189, 90, 237, 83, 245,
    40, 59, 91, 46, 159, 82, 103, 173, 221, 29, 24, 94, 53, 21, 202, 102, 90, 101, 86, 212, 130, 140, 154, 193,
    82, 150, 151, 179, 111, 47, 66, 133, 162, 203, 110, 98, 162, 96, 160, 215, 244, 220, 145, 207, 111, 251, 206, 244,
    201, 5, 62, 85, 9, 179, 65, 31, 19, 182, 96, 174, 251, 93, 57, 129, 225, 219, 77, 131, 100, 199, 73, 221,
    242, 174, 114, 170, 128, 55, 184, 39, 186, 129, 232, 112, 77, 139, 200, 223, 210, 51, 142, 21, 208, 198, 109, 242,
    224, 167, 99, 49, 146, 225, 162, 199, 178, 193, 177, 78, 16, 180, 102, 118, 80, 93, 200, 17, 249, 245, 198, 148,
    87, 85, 39, 20, 9, 241, 131, 143, 205, 55, 33, 244, 173, 5, 195, 32, 93, 243, 168, 230, 223, 80, 23, 25,
    84, 130, 187, 228, 148, 87, 68, 220, 141, 198, 41, 120, 205, 242, 58, 16, 248, 145, 56, 218, 237, 70, 3, 16,
    92, 132, 189, 44, 160, 9, 138, 205, 117, 141, 210, 2, 250, 44, 153, 80, 17, 68, 84, 192, 153, 16, 49, 200,
    203, 87, 131, 135, 200, 129, 233, 4, 33, 181, 104, 40, 23, 116, 0, 117, 218, 9, 118, 126, 193, 33, 166, 39,
    50, 204, 36, 161, 35, 26, 131, 140, 201, 193, 97, 223, 153, 83, 40, 238, 2, 4, 16, 3, 3, 61, 45, 48,
    44, 53, 9, 155, 6, 16, 109, 24, 85, 3, 0, 66, 112, 161, 157, 228, 85, 171, 52, 6, 176, 49, 100, 197,
    151, 79, 253, 126, 128, 124, 205, 210, 180, 82, 158, 86, 28, 240, 33, 67, 66, 89, 22, 81, 101, 43, 26, 47,
    116, 45, 100, 72, 104, 68, 200, 59, 32, 82, 84, 131, 117, 149, 228, 131, 154, 39, 34, 164, 4, 148, 68, 36,
    207, 122, 10, 31, 68, 61, 58, 140, 164, 147, 72, 124, 121, 24, 252, 158, 128, 205, 207, 23, 20, 240, 53, 13,
    33, 180, 66, 32, 13, 167, 0, 98, 29, 145, 19, 0, 20, 4, 91, 192, 142, 222, 22, 60, 202, 72, 50, 29,
    4, 18, 70, 66, 132, 112, 201, 144, 81, 12, 104, 110, 23, 17, 160, 220, 120, 147, 68, 160, 66, 25, 42, 177,
    26, 196, 17, 39, 1, 65, 8, 45, 232, 96, 41, 237, 184, 64, 6, 194, 99, 228, 142, 62, 68, 240, 76, 54,
    21, 192, 84, 52, 52, 210, 145, 128, 71, 200, 4
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
    static const signed char rest_profile[7] = { 7, 3, -1, -7, -11, -16, -18 };
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
                value *= 7.62939453e-05f;
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
    t[10] = 2.0f * t[5] * t[5] - 1.0f;
    t[11] = 2.0f * t[5] * t[6] - t[1];
    (void)u;
}

/* All products of the other axes' bases, `rest` of 7. */
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
        t[6] = 2.0f * t[3] * t[3] - 1.0f;
        (void)u;
    }
    for (i1 = 0; i1 < 7; ++i1)
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
