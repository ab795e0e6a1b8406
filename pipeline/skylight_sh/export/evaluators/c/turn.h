#pragma once
#include "circle.h"

/* One channel's sums, from those of its classes. */
static inline void skylight_sh_mix(skylight_sh_real sums[SKYLIGHT_SH_CLASSES][SKYLIGHT_SH_ROOM],
                                   int channel, const skylight_sh_real *factors,
                                   skylight_sh_real *mixed)
{
    int i;
#if SKYLIGHT_SH_IS_MIXED
    int k;
    for (i = 0; i < SKYLIGHT_SH_WIDTH; ++i)
        mixed[i] = factors[SKYLIGHT_SH_FACTOR(channel, 0)] * sums[0][i];
    for (k = 1; k < SKYLIGHT_SH_CLASSES; ++k)
        for (i = 0; i < SKYLIGHT_SH_WIDTH; ++i)
            mixed[i] += factors[SKYLIGHT_SH_FACTOR(channel, k)] * sums[k][i];
#else
    for (i = 0; i < SKYLIGHT_SH_WIDTH; ++i) mixed[i] = sums[channel][i];
    (void)factors;
#endif
}
#if SKYLIGHT_SH_IS_MIRRORED

/* Orders m >= 0 alone are stored: those of a light that is even in y at azimuth 0. */
#define SKYLIGHT_SH_FIRST_ORDER(l) 0

/* Stores one weight of degree l and order m turned by the azimuth. */
static inline void skylight_sh_place(skylight_sh_real value, int l, int m,
                                     const skylight_sh_real *cosines, const skylight_sh_real *sines,
                                     float *weights)
{
    weights[l * (l + 1) - m] = (float)(value * sines[m]);
    weights[l * (l + 1) + m] = (float)(value * cosines[m]);
}

/* Stores the first `bands` bands of the channels' weights, turned by the azimuth (Habel et al. 2008,
   eq. 4 with nothing for m < 0). */
static inline void skylight_sh_store(
    skylight_sh_real sums[SKYLIGHT_SH_CLASSES][SKYLIGHT_SH_ROOM], const skylight_sh_real *factors,
    const skylight_sh_real *cosines, const skylight_sh_real *sines, int bands,
    float weights[SKYLIGHT_SH_CHANNELS][SKYLIGHT_SH_WEIGHTS])
{
    int channel;
#if defined(SKYLIGHT_SH_LANES) && SKYLIGHT_SH_BANDS > 3
    /* In fours; each overshoot is overwritten by what follows. */
    float plus[SKYLIGHT_SH_BANDS], minus[SKYLIGHT_SH_BANDS + 3] = {0};
    int m, q;
    for (m = 0; m < SKYLIGHT_SH_BANDS; ++m) {
        plus[m] = cosines[m];
        minus[SKYLIGHT_SH_BANDS - 1 - m] = sines[m];
    }
    for (channel = 0; channel < SKYLIGHT_SH_CHANNELS; ++channel) {
        float *const w = weights[channel];
        skylight_sh_four v[SKYLIGHT_SH_FOURS];
        for (q = 0; q < SKYLIGHT_SH_FOURS; ++q) {
#if SKYLIGHT_SH_IS_MIXED
            int k;
            v[q] = factors[SKYLIGHT_SH_FACTOR(channel, 0)] * skylight_sh_load_four(sums[0] + 4 * q);
            for (k = 1; k < SKYLIGHT_SH_CLASSES; ++k)
                v[q] = skylight_sh_add_four(
                    skylight_sh_spread_four(factors[SKYLIGHT_SH_FACTOR(channel, k)]),
                    skylight_sh_load_four(sums[k] + 4 * q), v[q]);
#else
            v[q] = skylight_sh_load_four(sums[channel] + 4 * q);
            (void)factors;
#endif
        }
#define SKYLIGHT_SH_BAND(l, stores) \
    if (bands > (l)) { stores }
#define SKYLIGHT_SH_NOTHING(place, count) memset(w + (place), 0, sizeof(float) * (count));
#define SKYLIGHT_SH_MINUS(place, q, r, a, b, c, d, order) \
    skylight_sh_keep(w + (place), \
                     SKYLIGHT_SH_PICK(v[q], v[r], a, b, c, d) * \
                         skylight_sh_load_four(minus + SKYLIGHT_SH_BANDS - 1 - (order)));
#define SKYLIGHT_SH_PLUS(place, q, r, a, b, c, d, order) \
    skylight_sh_keep(w + (place), SKYLIGHT_SH_PICK(v[q], v[r], a, b, c, d) * \
                                      skylight_sh_load_four(plus + (order)));
        SKYLIGHT_SH_STORES(SKYLIGHT_SH_BAND, SKYLIGHT_SH_NOTHING, SKYLIGHT_SH_MINUS,
                           SKYLIGHT_SH_PLUS)
#undef SKYLIGHT_SH_BAND
#undef SKYLIGHT_SH_NOTHING
#undef SKYLIGHT_SH_MINUS
#undef SKYLIGHT_SH_PLUS
    }
#else
    static const short columns[SKYLIGHT_SH_BANDS] = SKYLIGHT_SH_COLUMNS;
    for (channel = 0; channel < SKYLIGHT_SH_CHANNELS; ++channel) {
        skylight_sh_real v[SKYLIGHT_SH_WIDTH];
        int l, m;
        skylight_sh_mix(sums, channel, factors, v);
        for (l = 0; l < bands; ++l) {
            float *const w = weights[channel] + l * (l + 1);
            const int column = columns[l];
            for (m = 1; m <= l; ++m)
                w[-m] = column < 0 ? 0.0f : (float)(v[column + m] * sines[m]);
            for (m = 0; m <= l; ++m)
                w[m] = column < 0 ? 0.0f : (float)(v[column + m] * cosines[m]);
        }
    }
#endif
    (void)cosines;
    (void)sines;
}
#else

/* All orders are stored: they are turned once they stand in their places. */
#define SKYLIGHT_SH_FIRST_ORDER(l) (-(l))

static inline void skylight_sh_place(skylight_sh_real value, int l, int m,
                                     const skylight_sh_real *cosines, const skylight_sh_real *sines,
                                     float *weights)
{
    weights[l * (l + 1) + m] = (float)value;
    (void)cosines;
    (void)sines;
}

/* Turns the first `bands` bands by the azimuth (Habel et al. 2008, eq. 4). */
static inline void skylight_sh_turn_all(int bands, const skylight_sh_real *cosines,
                                        const skylight_sh_real *sines,
                                        float weights[SKYLIGHT_SH_CHANNELS][SKYLIGHT_SH_WEIGHTS])
{
    int channel, l, m;
    for (channel = 0; channel < SKYLIGHT_SH_CHANNELS; ++channel) {
        for (l = 1; l < bands; ++l) {
            for (m = 1; m <= l; ++m) {
                float *const plus = &weights[channel][l * (l + 1) + m];
                float *const minus = &weights[channel][l * (l + 1) - m];
                skylight_sh_turn((skylight_sh_real)*plus, (skylight_sh_real)*minus, cosines[m],
                                 sines[m], plus, minus);
            }
        }
    }
}

/* Stores the first `bands` bands of the channels' weights, turned by the azimuth. */
static inline void skylight_sh_store(
    skylight_sh_real sums[SKYLIGHT_SH_CLASSES][SKYLIGHT_SH_ROOM], const skylight_sh_real *factors,
    const skylight_sh_real *cosines, const skylight_sh_real *sines, int bands,
    float weights[SKYLIGHT_SH_CHANNELS][SKYLIGHT_SH_WEIGHTS])
{
    static const short columns[SKYLIGHT_SH_BANDS] = SKYLIGHT_SH_COLUMNS;
    int channel, l, i;
    for (channel = 0; channel < SKYLIGHT_SH_CHANNELS; ++channel) {
        skylight_sh_real v[SKYLIGHT_SH_WIDTH];
        skylight_sh_mix(sums, channel, factors, v);
        for (l = 0; l < bands; ++l)
            for (i = 0; i < 2 * l + 1; ++i)
                weights[channel][l * l + i] = columns[l] < 0 ? 0.0f : (float)v[columns[l] + i];
    }
    skylight_sh_turn_all(bands, cosines, sines, weights);
}
#endif
