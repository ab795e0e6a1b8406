#pragma once
#include "turn.h"

/* sums[k] = sum over t of products[t] * row[t][k] for 4 * groups terms, four rows a pass: no
   reduction, so that it vectorises. */
static inline void skylight_sh_sum(const skylight_sh_real *row, int groups,
                                   const skylight_sh_real *products, int width,
                                   skylight_sh_real *sums)
{
    int group, k;
    {
        const skylight_sh_real a = products[0], b = products[1], c = products[2], d = products[3];
        for (k = 0; k < width; ++k)
            sums[k] = (a * row[k] + b * row[k + SKYLIGHT_SH_WIDTH]) +
                      (c * row[k + 2 * SKYLIGHT_SH_WIDTH] + d * row[k + 3 * SKYLIGHT_SH_WIDTH]);
    }
    for (group = 1; group < groups; ++group) {
        const skylight_sh_real a = products[4 * group], b = products[4 * group + 1];
        const skylight_sh_real c = products[4 * group + 2], d = products[4 * group + 3];
        row += 4 * SKYLIGHT_SH_WIDTH;
        for (k = 0; k < width; ++k)
            sums[k] += (a * row[k] + b * row[k + SKYLIGHT_SH_WIDTH]) +
                       (c * row[k + 2 * SKYLIGHT_SH_WIDTH] + d * row[k + 3 * SKYLIGHT_SH_WIDTH]);
    }
}

/* Zeroes what carries nothing. */
static inline void skylight_sh_clear(float *weights, int count)
{
    int i;
    for (i = 0; i < count; ++i) weights[i] = 0.0f;
}
#if SKYLIGHT_SH_IS_MIRRORED

/* Four orders m of one degree and channel: m >= 0 forwards, m < 0 backwards (eq. 4 with nothing
   stored for m < 0). */
static inline void skylight_sh_place_four(const skylight_sh_real *sums,
                                          const skylight_sh_real *cosines,
                                          const skylight_sh_real *sines, float *plus, float *minus)
{
    float forwards[4], backwards[4];
    int k;
    for (k = 0; k < 4; ++k) backwards[k] = (float)(sums[3 - k] * sines[3 - k]);
    for (k = 0; k < 4; ++k) forwards[k] = (float)(sums[k] * cosines[k]);
    for (k = 0; k < 4; ++k) minus[k] = backwards[k];
    for (k = 0; k < 4; ++k) plus[k] = forwards[k];
}

/* Stores the first `bands` bands of the sums in the order of the weights, turned by the azimuth. */
static inline void skylight_sh_store(const skylight_sh_real *sums, const skylight_sh_real *cosines,
                                     const skylight_sh_real *sines, int bands,
                                     float weights[SKYLIGHT_SH_CHANNELS][SKYLIGHT_SH_WEIGHTS])
{
#define SKYLIGHT_SH_BAND(l, stores) \
    if (bands > (l)) { stores }
#define SKYLIGHT_SH_NOTHING(channel, l) \
    skylight_sh_clear(weights[channel] + (l) * (l), 2 * (l) + 1);
#define SKYLIGHT_SH_ZONAL(channel, l, column) \
    weights[channel][(l) * ((l) + 1)] = (float)sums[column];
#define SKYLIGHT_SH_ONE(channel, l, m, column) \
    weights[channel][(l) * ((l) + 1) - (m)] = (float)(sums[column] * sines[m]); \
    weights[channel][(l) * ((l) + 1) + (m)] = (float)(sums[column] * cosines[m]);
#define SKYLIGHT_SH_FOUR(channel, l, m, column) \
    skylight_sh_place_four(sums + (column), cosines + (m), sines + (m), \
                           weights[channel] + (l) * ((l) + 1) + (m), \
                           weights[channel] + (l) * ((l) + 1) - (m) - 3);
    SKYLIGHT_SH_STORES(SKYLIGHT_SH_BAND, SKYLIGHT_SH_NOTHING, SKYLIGHT_SH_ZONAL, SKYLIGHT_SH_ONE,
                       SKYLIGHT_SH_FOUR)
#undef SKYLIGHT_SH_BAND
#undef SKYLIGHT_SH_NOTHING
#undef SKYLIGHT_SH_ZONAL
#undef SKYLIGHT_SH_ONE
#undef SKYLIGHT_SH_FOUR
    (void)cosines;
    (void)sines;
}
#else

/* Stores the first `bands` bands of the sums in the order of the weights. */
static inline void skylight_sh_store(const skylight_sh_real *sums, const skylight_sh_real *cosines,
                                     const skylight_sh_real *sines, int bands,
                                     float weights[SKYLIGHT_SH_CHANNELS][SKYLIGHT_SH_WEIGHTS])
{
    int i;
#define SKYLIGHT_SH_BAND(l, stores) \
    if (bands > (l)) { stores }
#define SKYLIGHT_SH_NOTHING(channel, l) \
    skylight_sh_clear(weights[channel] + (l) * (l), 2 * (l) + 1);
#define SKYLIGHT_SH_DEGREE(channel, l, column) \
    for (i = 0; i < 2 * (l) + 1; ++i) weights[channel][(l) * (l) + i] = (float)sums[(column) + i];
    SKYLIGHT_SH_STORES(SKYLIGHT_SH_BAND, SKYLIGHT_SH_NOTHING, SKYLIGHT_SH_DEGREE)
#undef SKYLIGHT_SH_BAND
#undef SKYLIGHT_SH_NOTHING
#undef SKYLIGHT_SH_DEGREE
    (void)cosines;
    (void)sines;
}
#endif

/* Sums the table's terms and stores the first `bands` bands. */
static inline void skylight_sh_combine(const skylight_sh_real *first,
                                       const skylight_sh_real *others,
                                       const skylight_sh_real *cosines,
                                       const skylight_sh_real *sines, int bands,
                                       float weights[SKYLIGHT_SH_CHANNELS][SKYLIGHT_SH_WEIGHTS])
{
    static const unsigned short widths[SKYLIGHT_SH_BANDS] = SKYLIGHT_SH_WIDTHS;
    skylight_sh_real products[4 * SKYLIGHT_SH_GROUPS + 8], sums[SKYLIGHT_SH_WIDTH];
    int i;
    /* In fours: each overshoot is overwritten by the next line. */
#define SKYLIGHT_SH_PRODUCT(start, count, other) \
    for (i = 0; i < ((count) + 3) / 4 * 4; ++i) products[(start) + i] = first[i] * others[other];
    SKYLIGHT_SH_PRODUCT(0, SKYLIGHT_SH_LEADING, 0)
    SKYLIGHT_SH_PRODUCTS(SKYLIGHT_SH_PRODUCT)
#undef SKYLIGHT_SH_PRODUCT
    /* A last group of four may have rows of zeros. */
    for (i = SKYLIGHT_SH_TERMS; i < 4 * SKYLIGHT_SH_GROUPS; ++i) products[i] = 0;
    if (bands == SKYLIGHT_SH_BANDS)
        skylight_sh_sum(skylight_sh_rows, SKYLIGHT_SH_GROUPS, products, SKYLIGHT_SH_WIDTH, sums);
    else
        skylight_sh_sum(skylight_sh_rows, SKYLIGHT_SH_GROUPS, products, widths[bands - 1], sums);
    skylight_sh_store(sums, cosines, sines, bands, weights);
}

/* The same in double precision, all bands: what derivatives need, whose terms cancel. */
static inline void skylight_sh_combine_double(
    const double *first, const double *others, const skylight_sh_real *cosines,
    const skylight_sh_real *sines, float weights[SKYLIGHT_SH_CHANNELS][SKYLIGHT_SH_WEIGHTS])
{
    static const unsigned char lengths[SKYLIGHT_SH_OTHERS] = SKYLIGHT_SH_LENGTHS;
    const skylight_sh_real *row = skylight_sh_rows;
    double exact[SKYLIGHT_SH_WIDTH];
    skylight_sh_real sums[SKYLIGHT_SH_WIDTH];
    int i, k, other;
    for (k = 0; k < SKYLIGHT_SH_WIDTH; ++k) exact[k] = 0.0;
    for (other = 0; other < SKYLIGHT_SH_OTHERS; ++other) {
        for (i = 0; i < lengths[other]; ++i) {
            const double product = first[i] * others[other];
            for (k = 0; k < SKYLIGHT_SH_WIDTH; ++k) exact[k] += product * (double)row[k];
            row += SKYLIGHT_SH_WIDTH;
        }
    }
    for (k = 0; k < SKYLIGHT_SH_WIDTH; ++k) sums[k] = (skylight_sh_real)exact[k];
    skylight_sh_store(sums, cosines, sines, SKYLIGHT_SH_BANDS, weights);
}
