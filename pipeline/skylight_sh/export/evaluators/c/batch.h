#pragma once
#include "evaluate.h"

/* One of many suns by itself. */
static inline int skylight_sh_evaluate_one(const skylight_sh_real *rows,
                                           const float *const inputs[SKYLIGHT_SH_AXES],
                                           const float *azimuths, int sun,
                                           float weights[SKYLIGHT_SH_CHANNELS][SKYLIGHT_SH_WEIGHTS])
{
    float given[SKYLIGHT_SH_AXES];
    int axis;
    for (axis = 0; axis < SKYLIGHT_SH_AXES; ++axis) given[axis] = inputs[axis][sun];
    return skylight_sh_evaluate(rows, given, azimuths ? azimuths[sun] : SKYLIGHT_SH_AZIMUTH,
                                SKYLIGHT_SH_BANDS, weights);
}
#if SKYLIGHT_SH_HAS_WIDE
#if defined(SKYLIGHT_SH_LANES) && SKYLIGHT_SH_LANES > 4
/* As many suns side by side as a vector has numbers. */
#define SKYLIGHT_SH_SUNS SKYLIGHT_SH_LANES

/* The weights of SKYLIGHT_SH_SUNS suns from `start` on, a row a weight; returns the largest status. */
static inline int skylight_sh_evaluate_suns(
    const skylight_sh_real *rows, const float *const inputs[SKYLIGHT_SH_AXES],
    const float *azimuths, int start,
    float out[SKYLIGHT_SH_CHANNELS * SKYLIGHT_SH_WEIGHTS][SKYLIGHT_SH_SUNS])
{
    static const short columns[SKYLIGHT_SH_BANDS] = SKYLIGHT_SH_COLUMNS;
    float x[SKYLIGHT_SH_SUNS][SKYLIGHT_SH_AXES], light[SKYLIGHT_SH_SUNS], u[SKYLIGHT_SH_SUNS];
    float others[SKYLIGHT_SH_OTHERS][SKYLIGHT_SH_SUNS];
    float factors[SKYLIGHT_SH_FACTORS][SKYLIGHT_SH_SUNS];
    float cosines[SKYLIGHT_SH_BANDS][SKYLIGHT_SH_SUNS], sines[SKYLIGHT_SH_BANDS][SKYLIGHT_SH_SUNS];
    skylight_sh_lanes sums[SKYLIGHT_SH_CLASSES][SKYLIGHT_SH_WIDTH];
    int s, i, k, l, m, channel, worst = 0;
    for (s = 0; s < SKYLIGHT_SH_SUNS; ++s) {
        float given[SKYLIGHT_SH_AXES], plus[SKYLIGHT_SH_BANDS], minus[SKYLIGHT_SH_BANDS];
        float azimuth = azimuths ? azimuths[start + s] : SKYLIGHT_SH_AZIMUTH, radius = 1.0f;
        int status;
        for (i = 0; i < SKYLIGHT_SH_AXES; ++i) given[i] = inputs[i][start + s];
        status = skylight_sh_inputs(given, azimuth, x[s]);
        worst = status > worst ? status : worst;
        light[s] = SKYLIGHT_SH_EXPOSURE;
        if (status == 2) {
            light[s] = azimuth = 0.0f;
            for (i = 0; i < SKYLIGHT_SH_AXES; ++i) x[s][i] = skylight_sh_range[i][0];
        }
#if SKYLIGHT_SH_HAS_TWILIGHT
        if (status != 2) light[s] *= skylight_sh_twilight(given[SKYLIGHT_SH_SUN]);
#endif
#if SKYLIGHT_SH_HAS_PARITY
        radius = skylight_sh_sine(x[s]);
#endif
        skylight_sh_waves(azimuth, radius, plus, minus);
        for (m = 0; m < SKYLIGHT_SH_BANDS; ++m) {
            cosines[m][s] = plus[m];
            sines[m][s] = minus[m];
        }
    }
    for (s = 0; s < SKYLIGHT_SH_SUNS; ++s) {
        float first[SKYLIGHT_SH_FIRST], products[SKYLIGHT_SH_OTHERS];
        skylight_sh_first(x[s], first);
        skylight_sh_others(x[s], products);
        u[s] = first[1];
        for (i = 0; i < SKYLIGHT_SH_OTHERS; ++i) others[i][s] = products[i];
    }
    for (s = 0; s < SKYLIGHT_SH_SUNS; ++s) {
#if SKYLIGHT_SH_IS_MIXED
        float early[SKYLIGHT_SH_EARLY], found[SKYLIGHT_SH_FACTORS];
        skylight_sh_begin_factors(x[s], early);
        skylight_sh_end_factors(x[s], early, found);
        for (i = 0; i < SKYLIGHT_SH_FACTORS; ++i) factors[i][s] = found[i] * light[s];
#else
        factors[0][s] = skylight_sh_scale(x[s]) * light[s];
#endif
    }
    for (i = 0; i < SKYLIGHT_SH_WIDTH; ++i) {
        const skylight_sh_lanes power = skylight_sh_load(u);
        int t;
#define SKYLIGHT_SH_CLASS(which, polynomials) \
    { \
        skylight_sh_lanes total; \
        polynomials sums[which][i] = total; \
    }
#define SKYLIGHT_SH_NOTHING total = skylight_sh_spread(0);
#define SKYLIGHT_SH_POLYNOMIAL(begin, count, other) \
    { \
        const float *term = rows + ((begin) + (count) - 1) * SKYLIGHT_SH_WIDTH + i; \
        skylight_sh_lanes sum = skylight_sh_spread(*term); \
        for (t = 1; t < (count); ++t) { \
            term -= SKYLIGHT_SH_WIDTH; \
            sum = skylight_sh_add(sum, power, skylight_sh_spread(*term)); \
        } \
        total = skylight_sh_add(sum, skylight_sh_load(others[other]), total); \
    }
        SKYLIGHT_SH_POLYNOMIALS(SKYLIGHT_SH_CLASS, SKYLIGHT_SH_NOTHING, SKYLIGHT_SH_POLYNOMIAL)
#undef SKYLIGHT_SH_CLASS
#undef SKYLIGHT_SH_NOTHING
#undef SKYLIGHT_SH_POLYNOMIAL
    }
    for (channel = 0; channel < SKYLIGHT_SH_CHANNELS; ++channel) {
        for (l = 0; l < SKYLIGHT_SH_BANDS; ++l) {
            float(*const w)[SKYLIGHT_SH_SUNS] = out + channel * SKYLIGHT_SH_WEIGHTS + l * (l + 1);
            for (m = 0; m <= l; ++m) {
                skylight_sh_lanes v = skylight_sh_spread(0);
                if (columns[l] >= 0) {
#if SKYLIGHT_SH_IS_MIXED
                    for (k = 0; k < SKYLIGHT_SH_CLASSES; ++k)
                        v = skylight_sh_add(
                            skylight_sh_load(factors[channel * SKYLIGHT_SH_CLASSES + k]),
                            sums[k][columns[l] + m], v);
#else
                    v = skylight_sh_load(factors[0]) * sums[channel][columns[l] + m];
#endif
                }
                {
                    const skylight_sh_lanes plus = v * skylight_sh_load(cosines[m]);
                    const skylight_sh_lanes minus = v * skylight_sh_load(sines[m]);
                    memcpy(w[-m], &minus, sizeof minus);
                    memcpy(w[m], &plus, sizeof plus);
                }
            }
        }
    }
    (void)k;
    return worst;
}
#endif
#endif

/* Evaluates `count` suns from arrays, one an axis, and one of azimuths (or none, where the table
   fixes it); returns the largest status. */
static inline int skylight_sh_evaluate_batch(
    const skylight_sh_real *rows, int count, const float *const inputs[SKYLIGHT_SH_AXES],
    const float *azimuths, float (*weights)[SKYLIGHT_SH_CHANNELS][SKYLIGHT_SH_WEIGHTS])
{
    int s, status, worst = 0;
    for (s = 0; s < count; ++s) {
        status = skylight_sh_evaluate_one(rows, inputs, azimuths, s, weights[s]);
        worst = status > worst ? status : worst;
    }
    return worst;
}

/* The same with the suns of each weight side by side: `weights` is [channels][weights][count]. */
static inline int skylight_sh_evaluate_columns(const skylight_sh_real *rows, int count,
                                               const float *const inputs[SKYLIGHT_SH_AXES],
                                               const float *azimuths, float *weights)
{
    const size_t step = count > 0 ? (size_t)count : 0;
    int s = 0, i, status, worst = 0;
#if SKYLIGHT_SH_HAS_WIDE
#ifdef SKYLIGHT_SH_SUNS
    for (; s + SKYLIGHT_SH_SUNS <= count; s += SKYLIGHT_SH_SUNS) {
        float out[SKYLIGHT_SH_CHANNELS * SKYLIGHT_SH_WEIGHTS][SKYLIGHT_SH_SUNS];
        status = skylight_sh_evaluate_suns(rows, inputs, azimuths, s, out);
        worst = status > worst ? status : worst;
        for (i = 0; i < SKYLIGHT_SH_CHANNELS * SKYLIGHT_SH_WEIGHTS; ++i)
            memcpy(weights + (size_t)i * step + (size_t)s, out[i], sizeof out[i]);
    }
#endif
#endif
    while (s < count) {
        /* Some at once, so that what is written lies together. */
        float some[16][SKYLIGHT_SH_CHANNELS][SKYLIGHT_SH_WEIGHTS];
        const int now = count - s < 16 ? count - s : 16;
        int k;
        for (k = 0; k < now; ++k) {
            status = skylight_sh_evaluate_one(rows, inputs, azimuths, s + k, some[k]);
            worst = status > worst ? status : worst;
        }
        for (i = 0; i < SKYLIGHT_SH_CHANNELS * SKYLIGHT_SH_WEIGHTS; ++i)
            for (k = 0; k < now; ++k)
                weights[(size_t)i * step + (size_t)(s + k)] =
                    some[k][i / SKYLIGHT_SH_WEIGHTS][i % SKYLIGHT_SH_WEIGHTS];
        s += now;
    }
    return worst;
}
