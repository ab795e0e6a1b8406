#pragma once
#include "inputs.h"
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

/* What becomes of the first `bands` bands once they are stored; the others become 0. */
static inline void skylight_sh_finish(int bands, int lights, const skylight_sh_real *cosines,
                                      const skylight_sh_real *sines,
                                      float weights[SKYLIGHT_SH_CHANNELS][SKYLIGHT_SH_WEIGHTS])
{
#if SKYLIGHT_SH_HAS_SURROUNDINGS
#if !SKYLIGHT_SH_IS_MIRRORED
    skylight_sh_turn_all(SKYLIGHT_SH_BANDS, cosines, sines, weights);
#endif
    skylight_sh_surround(bands, lights, weights);
#else
#if !SKYLIGHT_SH_IS_MIRRORED
    skylight_sh_turn_all(bands, cosines, sines, weights);
#endif
    if (bands < SKYLIGHT_SH_BANDS) {
        int channel, i;
        for (channel = 0; channel < SKYLIGHT_SH_CHANNELS; ++channel)
            for (i = bands * bands; i < SKYLIGHT_SH_WEIGHTS; ++i) weights[channel][i] = 0.0f;
    }
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
    (void)lights;
    (void)cosines;
    (void)sines;
}

/* Evaluates the first `bands` bands (1 to SKYLIGHT_SH_BANDS, clamped like an input) and zeroes the
   rest; returns the status. */
static inline int skylight_sh_evaluate(const float inputs[SKYLIGHT_SH_AXES], float azimuth,
                                       int bands,
                                       float weights[SKYLIGHT_SH_CHANNELS][SKYLIGHT_SH_WEIGHTS])
{
    skylight_sh_real x[SKYLIGHT_SH_AXES], first[SKYLIGHT_SH_FIRST], others[SKYLIGHT_SH_OTHERS];
    skylight_sh_real cosines[SKYLIGHT_SH_BANDS], sines[SKYLIGHT_SH_BANDS], scale;
    int i, status = skylight_sh_inputs(inputs, azimuth, x);
    if (status == 2) {
        memset(weights, 0, sizeof(float) * SKYLIGHT_SH_CHANNELS * SKYLIGHT_SH_WEIGHTS);
        return 2;
    }
    if (bands < 1 || bands > SKYLIGHT_SH_BANDS) {
        bands = bands < 1 ? 1 : SKYLIGHT_SH_BANDS;
        status = 1;
    }
    scale = skylight_sh_scale(x) * (skylight_sh_real)SKYLIGHT_SH_EXPOSURE;
#if SKYLIGHT_SH_HAS_TWILIGHT
    scale *= skylight_sh_twilight(inputs[SKYLIGHT_SH_SUN]);
#endif
    skylight_sh_first(x, first);
    skylight_sh_others(x, others);
    for (i = 0; i < SKYLIGHT_SH_OTHERS; ++i) others[i] *= scale;
    skylight_sh_waves((skylight_sh_real)azimuth, cosines, sines);
#if SKYLIGHT_SH_HAS_SURROUNDINGS
    /* All bands: what surrounds the sky carries light from one to another. */
    skylight_sh_combine(first, others, cosines, sines, SKYLIGHT_SH_BANDS, weights);
#else
    skylight_sh_combine(first, others, cosines, sines, bands, weights);
#endif
    skylight_sh_finish(bands, 1, cosines, sines, weights);
    return status;
}

/* Evaluates `count` suns from arrays, one an axis, and one of azimuths (or none, where the table
   fixes it); returns the largest status. */
static inline int skylight_sh_evaluate_batch(
    int count, const float *const inputs[SKYLIGHT_SH_AXES], const float *azimuths,
    float (*weights)[SKYLIGHT_SH_CHANNELS][SKYLIGHT_SH_WEIGHTS])
{
    int s, axis, worst = 0;
#if SKYLIGHT_SH_HAS_ROWS
    /* The rows summed over the other axes once, for all suns in a row that share them. */
    skylight_sh_real line[SKYLIGHT_SH_FIRST * SKYLIGHT_SH_WIDTH], shared[SKYLIGHT_SH_AXES];
    int ready = 0;
#endif
    for (s = 0; s < count; ++s) {
        const float azimuth = azimuths ? azimuths[s] : SKYLIGHT_SH_AZIMUTH;
        float sun[SKYLIGHT_SH_AXES];
        int status;
#if SKYLIGHT_SH_HAS_ROWS
        skylight_sh_real x[SKYLIGHT_SH_AXES], first[SKYLIGHT_SH_FIRST], sums[SKYLIGHT_SH_WIDTH];
        skylight_sh_real cosines[SKYLIGHT_SH_BANDS], sines[SKYLIGHT_SH_BANDS], scale;
        int i;
#endif
        for (axis = 0; axis < SKYLIGHT_SH_AXES; ++axis) sun[axis] = inputs[axis][s];
#if SKYLIGHT_SH_HAS_ROWS
        status = skylight_sh_inputs(sun, azimuth, x);
        worst = status > worst ? status : worst;
        if (status == 2) {
            memset(weights[s], 0, sizeof weights[s]);
            continue;
        }
        ready = ready && !memcmp(x + 1, shared + 1, sizeof *x * (SKYLIGHT_SH_AXES - 1));
        if (!ready) {
            skylight_sh_real others[SKYLIGHT_SH_OTHERS];
            skylight_sh_others(x, others);
            for (i = 0; i < SKYLIGHT_SH_LEADING * SKYLIGHT_SH_WIDTH; ++i)
                line[i] = others[0] * skylight_sh_rows[i];
            for (; i < SKYLIGHT_SH_FIRST * SKYLIGHT_SH_WIDTH; ++i) line[i] = 0;
#define SKYLIGHT_SH_PRODUCT(start, count, other) \
    for (i = 0; i < (count) * SKYLIGHT_SH_WIDTH; ++i) \
        line[i] += others[other] * skylight_sh_rows[(start) * SKYLIGHT_SH_WIDTH + i];
            SKYLIGHT_SH_PRODUCTS(SKYLIGHT_SH_PRODUCT)
#undef SKYLIGHT_SH_PRODUCT
            memcpy(shared, x, sizeof shared);
            ready = 1;
        }
        scale = skylight_sh_scale(x) * (skylight_sh_real)SKYLIGHT_SH_EXPOSURE;
#if SKYLIGHT_SH_HAS_TWILIGHT
        scale *= skylight_sh_twilight(sun[SKYLIGHT_SH_SUN]);
#endif
        skylight_sh_first(x, first);
        for (i = 0; i < SKYLIGHT_SH_FIRST; ++i) first[i] *= scale;
        skylight_sh_waves((skylight_sh_real)azimuth, cosines, sines);
        skylight_sh_sum(line, SKYLIGHT_SH_FIRST / 4, first, SKYLIGHT_SH_WIDTH, sums);
        skylight_sh_store(sums, cosines, sines, SKYLIGHT_SH_BANDS, weights[s]);
        skylight_sh_finish(SKYLIGHT_SH_BANDS, 1, cosines, sines, weights[s]);
#else
        status = skylight_sh_evaluate(sun, azimuth, SKYLIGHT_SH_BANDS, weights[s]);
        worst = status > worst ? status : worst;
#endif
    }
    return worst;
}
