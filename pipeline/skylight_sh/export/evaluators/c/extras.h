#pragma once
#include "example.h"
#if SKYLIGHT_SH_HAS_DIRECTION

/* The dominant light's direction, a unit vector: where the linear part of the weights, summed over
   channels by luminance, points. Returns 0, or 1 (and straight up) where it points nowhere. */
SKYLIGHT_SH_API int skylight_sh_dominant_of(const float *weights, float direction[3])
{
    static const float luminance[SKYLIGHT_SH_CHANNELS] = SKYLIGHT_SH_LUMINANCE;
    float x = 0.0f, y = 0.0f, z = 0.0f, length;
    int channel;
    for (channel = 0; channel < SKYLIGHT_SH_CHANNELS; ++channel) {
        const float *const linear = weights + channel * SKYLIGHT_SH_WEIGHTS + 1;
        x += luminance[channel] * linear[2];
        y += luminance[channel] * linear[0];
        z += luminance[channel] * linear[1];
    }
    length = sqrtf(x * x + y * y + z * z);
    direction[0] = length > 0.0f ? x / length : 0.0f;
    direction[1] = length > 0.0f ? y / length : 0.0f;
    direction[2] = length > 0.0f ? z / length : 1.0f;
    return !(length > 0.0f);
}
#endif
#if SKYLIGHT_SH_TAKES_GROUND

/* Adds an even ground of this albedo below the horizon, lit by the sky (before any window): its
   radiance is albedo E / pi, and E, the irradiance on it, a multiple of the weight l = 1, m = 0. */
SKYLIGHT_SH_API void skylight_sh_ground(
    const float albedo[SKYLIGHT_SH_CHANNELS],
    float weights[SKYLIGHT_SH_CHANNELS][SKYLIGHT_SH_WEIGHTS])
{
    static const float lower[SKYLIGHT_SH_BANDS] = SKYLIGHT_SH_LOWER;
    int l, channel;
    for (channel = 0; channel < SKYLIGHT_SH_CHANNELS; ++channel) {
        const float radiance = albedo[channel] * SKYLIGHT_SH_REFLECTED * weights[channel][2];
        for (l = 0; l < SKYLIGHT_SH_BANDS; ++l) weights[channel][l * (l + 1)] += radiance * lower[l];
    }
}
#endif
#if !SKYLIGHT_SH_IS_WINDOWED

/* Tames the ringing of the horizon in the first `bands` bands by the zonal window sinc(pi l /
   bands) (Habel et al. 2008, eq. 5). */
SKYLIGHT_SH_API void skylight_sh_window(
    int bands, float weights[SKYLIGHT_SH_CHANNELS][SKYLIGHT_SH_WEIGHTS])
{
    int l, channel;
    for (l = 1; l < bands && l < SKYLIGHT_SH_BANDS; ++l) {
        const float factor = skylight_sh_sinc((float)l / (float)bands);
        for (channel = 0; channel < SKYLIGHT_SH_CHANNELS; ++channel)
            weights[channel][l * (l + 1)] *= factor;
    }
}
#endif
