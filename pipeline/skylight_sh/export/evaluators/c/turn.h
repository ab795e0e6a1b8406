#pragma once
#include "vectors.h"

/* Four sums of one channel, from those of its classes. */
static inline skylight_sh_four skylight_sh_mixed(const skylight_sh_four *classes, int channel,
                                                 const skylight_sh_real *factors)
{
#if SKYLIGHT_SH_IS_MIXED
    skylight_sh_four sum =
        skylight_sh_scaled(classes[0], factors[channel * SKYLIGHT_SH_CLASSES]);
    int k;
    for (k = 1; k < SKYLIGHT_SH_CLASSES; ++k)
        sum = skylight_sh_plus(
            sum, skylight_sh_scaled(classes[k], factors[channel * SKYLIGHT_SH_CLASSES + k]));
    return sum;
#else
    (void)factors;
    return classes[channel];
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
    skylight_sh_four one[SKYLIGHT_SH_CLASSES];
#if SKYLIGHT_SH_WIDTH > 4
    skylight_sh_four two[SKYLIGHT_SH_CLASSES];
#endif
    int channel, k;
#ifdef SKYLIGHT_SH_FOURS
    static const unsigned short fours[SKYLIGHT_SH_FOURS_COUNT][3] = SKYLIGHT_SH_FOURS;
    static const unsigned short counts[SKYLIGHT_SH_BANDS] = SKYLIGHT_SH_FOURS_COUNTS;
    const int count = counts[bands - 1];
#endif
    for (k = 0; k < SKYLIGHT_SH_CLASSES; ++k) {
        one[k] = skylight_sh_four_of(sums[k]);
#if SKYLIGHT_SH_WIDTH > 4
        two[k] = skylight_sh_four_of(sums[k] + 4);
#endif
    }
    for (channel = 0; channel < SKYLIGHT_SH_CHANNELS; ++channel) {
        const skylight_sh_four lower = skylight_sh_mixed(one, channel, factors);
        float *const w = weights[channel];
        skylight_sh_real v[8];
        memcpy(v, &lower, sizeof lower);
#if SKYLIGHT_SH_WIDTH > 4
        {
            const skylight_sh_four upper = skylight_sh_mixed(two, channel, factors);
            memcpy(v + 4, &upper, sizeof upper);
        }
#endif
#define SKYLIGHT_SH_BAND(l, stores) \
    if (bands > (l)) { stores }
#define SKYLIGHT_SH_ONE(l, m, column) \
    w[(l) * ((l) + 1) - (m)] = (float)(v[column] * sines[m]); \
    w[(l) * ((l) + 1) + (m)] = (float)(v[column] * cosines[m]);
        SKYLIGHT_SH_LOW(SKYLIGHT_SH_BAND, SKYLIGHT_SH_ONE)
#undef SKYLIGHT_SH_BAND
#undef SKYLIGHT_SH_ONE
    }
#ifdef SKYLIGHT_SH_FOURS
    {
        int i;
        for (i = 0; i < count; ++i) {
            const int order = fours[i][0], column = fours[i][1], centre = fours[i][2];
            const skylight_sh_four cosine = skylight_sh_four_of(cosines + order);
            const skylight_sh_four sine = skylight_sh_four_of(sines + order);
            for (k = 0; k < SKYLIGHT_SH_CLASSES; ++k) one[k] = skylight_sh_four_of(sums[k] + column);
            for (channel = 0; channel < SKYLIGHT_SH_CHANNELS; ++channel) {
                const skylight_sh_four v = skylight_sh_mixed(one, channel, factors);
                float *const w = weights[channel] + centre;
                skylight_sh_put(w - order - 3,
                                skylight_sh_backwards(skylight_sh_product(v, sine)));
                skylight_sh_put(w + order, skylight_sh_product(v, cosine));
            }
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
    skylight_sh_four one[SKYLIGHT_SH_CLASSES];
    float v[SKYLIGHT_SH_ROOM];
    int channel, i, k;
    for (channel = 0; channel < SKYLIGHT_SH_CHANNELS; ++channel) {
        for (i = 0; i < SKYLIGHT_SH_WIDTH; i += 4) {
            for (k = 0; k < SKYLIGHT_SH_CLASSES; ++k) one[k] = skylight_sh_four_of(sums[k] + i);
            skylight_sh_put(v + i, skylight_sh_mixed(one, channel, factors));
        }
#define SKYLIGHT_SH_DEGREE(l, column) \
    for (i = 0; i < 2 * (l) + 1 && (l) < bands; ++i) weights[channel][(l) * (l) + i] = v[(column) + i];
        SKYLIGHT_SH_DEGREES(SKYLIGHT_SH_DEGREE)
#undef SKYLIGHT_SH_DEGREE
    }
    skylight_sh_turn_all(bands, cosines, sines, weights);
}
#endif
