#pragma once
#if SKYLIGHT_SH_HAS_ROWS
#include "rows.h"
#else
#include "packed.h"
#endif
#if SKYLIGHT_SH_HAS_SURROUNDINGS

/* The scene's surroundings, once the sun is turned to its azimuth: a linear map, what shines of
   itself (where `lights`; not in derivatives), the ground. Stores the first `bands` bands. */
static inline void skylight_sh_surround(int bands, int lights,
                                        float weights[SKYLIGHT_SH_CHANNELS][SKYLIGHT_SH_WEIGHTS])
{
    int channel, i;
    for (channel = 0; channel < SKYLIGHT_SH_CHANNELS; ++channel) {
        skylight_sh_real out[SKYLIGHT_SH_WEIGHTS];
#if SKYLIGHT_SH_HAS_TRANSFER
        int j;
        for (i = 0; i < SKYLIGHT_SH_WEIGHTS; ++i) {
            const skylight_sh_real *const row = skylight_sh_transfer + i * SKYLIGHT_SH_WEIGHTS;
            skylight_sh_real sum = 0;
            for (j = 0; j < SKYLIGHT_SH_WEIGHTS; ++j)
                sum += row[j] * (skylight_sh_real)weights[channel][j];
            out[i] = sum;
        }
#else
        for (i = 0; i < SKYLIGHT_SH_WEIGHTS; ++i) out[i] = (skylight_sh_real)weights[channel][i];
#endif
#if SKYLIGHT_SH_HAS_LIGHTS
        if (lights) {
            const skylight_sh_real *const own = skylight_sh_own + channel * SKYLIGHT_SH_WEIGHTS;
            for (i = 0; i < SKYLIGHT_SH_WEIGHTS; ++i)
                out[i] += own[i] * (skylight_sh_real)SKYLIGHT_SH_EXPOSURE;
        }
#endif
#if SKYLIGHT_SH_HAS_GROUND
        {
            const skylight_sh_real *const below = skylight_sh_below + channel * SKYLIGHT_SH_WEIGHTS;
            const skylight_sh_real fallen = out[2];
            for (i = 0; i < SKYLIGHT_SH_WEIGHTS; ++i) out[i] += below[i] * fallen;
        }
#endif
        for (i = 0; i < SKYLIGHT_SH_WEIGHTS; ++i)
            weights[channel][i] = i < bands * bands ? (float)out[i] : 0.0f;
    }
    (void)lights;
}
#endif

/* What becomes of the first `bands` bands once they are stored. */
static inline void skylight_sh_finish(int bands, int lights,
                                      float weights[SKYLIGHT_SH_CHANNELS][SKYLIGHT_SH_WEIGHTS])
{
#if SKYLIGHT_SH_HAS_SURROUNDINGS
    skylight_sh_surround(bands, lights, weights);
#endif
#if SKYLIGHT_SH_IS_WINDOWED
    if (bands < SKYLIGHT_SH_BANDS) {
        /* The window follows the number of bands. */
        int channel, l;
        for (l = 1; l < bands; ++l) {
            const float ratio = skylight_sh_sinc((float)l / (float)bands) /
                                skylight_sh_sinc((float)l / (float)SKYLIGHT_SH_BANDS);
            for (channel = 0; channel < SKYLIGHT_SH_CHANNELS; ++channel)
                weights[channel][l * (l + 1)] *= ratio;
        }
    }
#endif
    (void)bands;
    (void)lights;
    (void)weights;
}

/* Evaluates the first `bands` bands (1 to SKYLIGHT_SH_BANDS, clamped like an input) and zeroes the
   rest; returns the status. `rows` are the table's; those of a packed table may be missing. */
static inline int skylight_sh_evaluate(const skylight_sh_real *rows,
                                       const float inputs[SKYLIGHT_SH_AXES], float azimuth,
                                       int bands,
                                       float weights[SKYLIGHT_SH_CHANNELS][SKYLIGHT_SH_WEIGHTS])
{
    skylight_sh_real x[SKYLIGHT_SH_AXES], first[SKYLIGHT_SH_FIRST], others[SKYLIGHT_SH_OTHERS];
    skylight_sh_real cosines[SKYLIGHT_SH_BANDS], sines[SKYLIGHT_SH_BANDS];
    skylight_sh_real sums[SKYLIGHT_SH_CLASSES][SKYLIGHT_SH_ROOM];
    skylight_sh_real factors[SKYLIGHT_SH_FACTORS];
    skylight_sh_real light = SKYLIGHT_SH_EXPOSURE, radius = 1, cosine, sine;
    int i, all, status = skylight_sh_inputs(inputs, azimuth, x);
    if (status == 2) {
        memset(weights, 0, sizeof(float) * SKYLIGHT_SH_CHANNELS * SKYLIGHT_SH_WEIGHTS);
        return 2;
    }
    if (bands < 1 || bands > SKYLIGHT_SH_BANDS) {
        bands = bands < 1 ? 1 : SKYLIGHT_SH_BANDS;
        status = 1;
    }
#if SKYLIGHT_SH_HAS_TWILIGHT
    light *= skylight_sh_twilight(inputs[SKYLIGHT_SH_SUN]);
#endif
    skylight_sh_circle((skylight_sh_real)azimuth, &cosine, &sine);
#if SKYLIGHT_SH_HAS_PARITY
    radius = skylight_sh_sine(x);
#endif
    skylight_sh_waves(cosine, sine, radius, cosines, sines);
    skylight_sh_first(x, first);
    skylight_sh_others(x, others);
#if SKYLIGHT_SH_IS_MIXED
    skylight_sh_factors(x, factors);
    for (i = 0; i < SKYLIGHT_SH_FACTORS; ++i) factors[i] *= light;
#else
    skylight_sh_factors(x, factors);
    light *= factors[0];
    for (i = 0; i < SKYLIGHT_SH_OTHERS; ++i) others[i] *= light;
    factors[0] = light;
#endif
#if SKYLIGHT_SH_HAS_SURROUNDINGS
    /* All bands: what surrounds the sky carries light from one to another. */
    all = SKYLIGHT_SH_BANDS;
#else
    all = bands;
#endif
#if !SKYLIGHT_SH_HAS_ROWS
    if (!rows) skylight_sh_sum_stream(first, others, all, sums);
    if (rows)
#endif
    {
#define SKYLIGHT_SH_CLASS(k) skylight_sh_sum_class(rows, k, first, others, all, sums[k]);
        SKYLIGHT_SH_ALL_CLASSES(SKYLIGHT_SH_CLASS)
#undef SKYLIGHT_SH_CLASS
    }
    skylight_sh_store(sums, factors, cosines, sines, all, weights);
    skylight_sh_finish(bands, 1, weights);
    if (bands < SKYLIGHT_SH_BANDS) {
        int channel;
        for (channel = 0; channel < SKYLIGHT_SH_CHANNELS; ++channel)
            for (i = bands * bands; i < SKYLIGHT_SH_WEIGHTS; ++i) weights[channel][i] = 0.0f;
    }
    return status;
}
