#pragma once
#include "batch.h"

/* All products of `count` numbers and `size` functions, the functions' place fastest; returns how
   many. */
static inline int skylight_sh_multiply_double(double *products, int count, const double *functions,
                                              int size)
{
    int i, k;
    for (k = count - 1; k >= 0; --k) {
        const double product = products[k];
        for (i = size - 1; i >= 0; --i) products[k * size + i] = product * functions[i];
    }
    return count * size;
}

/* The sums of all terms in double, of the axes' functions. */
static inline void skylight_sh_sum_double(
    const skylight_sh_real *rows, double functions[SKYLIGHT_SH_AXES][SKYLIGHT_SH_MOST],
    double sums[SKYLIGHT_SH_CLASSES][SKYLIGHT_SH_WIDTH])
{
    static const int sizes[SKYLIGHT_SH_AXES] = SKYLIGHT_SH_SIZES;
    double others[SKYLIGHT_SH_OTHERS];
    int axis, count = 1;
    others[0] = 1.0;
    for (axis = 1; axis < SKYLIGHT_SH_AXES; ++axis)
        count = skylight_sh_multiply_double(others, count, functions[axis], sizes[axis]);
#if SKYLIGHT_SH_HAS_ROWS
    skylight_sh_sum_rows_double(rows, functions[0], others, sums);
#else
    skylight_sh_sum_stream_double(functions[0], others, sums);
    (void)rows;
#endif
    (void)count;
}

/* One channel's sum in double, at a column. */
static inline double skylight_sh_mixed_double(double sums[SKYLIGHT_SH_CLASSES][SKYLIGHT_SH_WIDTH],
                                              int channel, int column, const double *factors)
{
#if SKYLIGHT_SH_IS_MIXED
    double sum = 0.0;
    int k;
    for (k = 0; k < SKYLIGHT_SH_CLASSES; ++k)
        sum += factors[SKYLIGHT_SH_FACTOR(channel, k)] * sums[k][column];
    return sum;
#else
    return factors[0] * sums[channel][column];
#endif
}

/* Evaluates all bands, and their derivatives after each axis by the product rule, in double until
   they are stored: exact inside the ranges, and beyond one those at its edge. */
static inline int skylight_sh_evaluate_gradient(
    const skylight_sh_real *rows, const float inputs[SKYLIGHT_SH_AXES], float azimuth,
    float weights[SKYLIGHT_SH_CHANNELS][SKYLIGHT_SH_WEIGHTS],
    float gradient[SKYLIGHT_SH_AXES][SKYLIGHT_SH_CHANNELS][SKYLIGHT_SH_WEIGHTS])
{
    static const short columns[SKYLIGHT_SH_BANDS] = SKYLIGHT_SH_COLUMNS;
    double x[SKYLIGHT_SH_AXES], functions[SKYLIGHT_SH_AXES][SKYLIGHT_SH_MOST];
    double slopes[SKYLIGHT_SH_AXES][SKYLIGHT_SH_MOST];
    double factors[1 + SKYLIGHT_SH_AXES][SKYLIGHT_SH_FACTORS];
    double sums[SKYLIGHT_SH_CLASSES][SKYLIGHT_SH_WIDTH];
    double sloped[SKYLIGHT_SH_CLASSES][SKYLIGHT_SH_WIDTH];
    double powers[SKYLIGHT_SH_BANDS], power_slopes[SKYLIGHT_SH_BANDS];
    skylight_sh_real cosines[SKYLIGHT_SH_BANDS], sines[SKYLIGHT_SH_BANDS], of_x, of_y;
    int axis, channel, i, l, m, sunk = 0;
    const int status =
        skylight_sh_evaluate(rows, inputs, azimuth, SKYLIGHT_SH_BANDS, weights);
    memset(gradient, 0,
           sizeof(float) * SKYLIGHT_SH_AXES * SKYLIGHT_SH_CHANNELS * SKYLIGHT_SH_WEIGHTS);
    if (status == 2) return 2;
    for (axis = 0; axis < SKYLIGHT_SH_AXES; ++axis) {
        const double low = skylight_sh_slope_range[axis][0];
        const double high = skylight_sh_slope_range[axis][1];
        const double v = (double)skylight_sh_finite(inputs[axis]);
        x[axis] = v < low ? low : v > high ? high : v;
        skylight_sh_functions(axis, x[axis], functions[axis], slopes[axis]);
    }
    skylight_sh_factor_slopes(x, &factors[0][0]);
    for (axis = 0; axis < 1 + SKYLIGHT_SH_AXES; ++axis)
        for (i = 0; i < SKYLIGHT_SH_FACTORS; ++i)
            factors[axis][i] *= (double)SKYLIGHT_SH_EXPOSURE;
    for (m = 0; m < SKYLIGHT_SH_BANDS; ++m) {
        powers[m] = 1.0;
        power_slopes[m] = 0.0;
    }
#if SKYLIGHT_SH_HAS_PARITY
    {
        double sine[2];
        skylight_sh_sine_slope(x, sine);
        for (m = 1; m < SKYLIGHT_SH_BANDS; ++m) {
            powers[m] = powers[m - 1] * sine[0];
            power_slopes[m] = (double)m * powers[m - 1] * sine[1];
        }
    }
#endif
#if SKYLIGHT_SH_HAS_TWILIGHT
    sunk = (skylight_sh_real)skylight_sh_finite(inputs[SKYLIGHT_SH_SUN]) > SKYLIGHT_SH_HORIZON;
    if (sunk) {
        /* Below the horizon the light of a sun on it fades, and nothing else hangs on its height. */
        const double depth = ((double)skylight_sh_finite(inputs[SKYLIGHT_SH_SUN]) -
                              skylight_sh_slope_range[SKYLIGHT_SH_SUN][1]) /
                             SKYLIGHT_SH_DEPTH;
        double fade[2];
        skylight_sh_fade_slope(depth < 0.0 ? 0.0 : depth > 1.0 ? 1.0 : depth, fade);
        for (i = 0; i < SKYLIGHT_SH_FACTORS; ++i) {
            factors[1 + SKYLIGHT_SH_SUN][i] = factors[0][i] * fade[1] / SKYLIGHT_SH_DEPTH;
            for (axis = 0; axis < 1 + SKYLIGHT_SH_AXES; ++axis)
                if (axis != 1 + SKYLIGHT_SH_SUN) factors[axis][i] *= fade[0];
        }
        for (i = 0; i < SKYLIGHT_SH_MOST; ++i) slopes[SKYLIGHT_SH_SUN][i] = 0.0;
    }
#endif
    skylight_sh_circle((skylight_sh_real)azimuth, &of_x, &of_y);
    skylight_sh_waves(of_x, of_y, 1, cosines, sines);
    skylight_sh_sum_double(rows, functions, sums);
    for (axis = 0; axis < SKYLIGHT_SH_AXES; ++axis) {
        double kept[SKYLIGHT_SH_MOST];
        memcpy(kept, functions[axis], sizeof kept);
        memcpy(functions[axis], slopes[axis], sizeof kept);
        skylight_sh_sum_double(rows, functions, sloped);
        memcpy(functions[axis], kept, sizeof kept);
        for (channel = 0; channel < SKYLIGHT_SH_CHANNELS; ++channel) {
            float *const w = gradient[axis][channel];
            for (l = 0; l < SKYLIGHT_SH_BANDS; ++l) {
                for (m = SKYLIGHT_SH_FIRST_ORDER(l); m <= l && columns[l] >= 0; ++m) {
                    const int order = m < 0 ? -m : m;
                    const int column = columns[l] + m - SKYLIGHT_SH_FIRST_ORDER(l);
                    double value =
                        powers[order] *
                        (skylight_sh_mixed_double(sloped, channel, column, factors[0]) +
                         skylight_sh_mixed_double(sums, channel, column, factors[1 + axis]));
#if SKYLIGHT_SH_HAS_PARITY
                    if (axis == SKYLIGHT_SH_SUN && !sunk)
                        value += power_slopes[order] *
                                 skylight_sh_mixed_double(sums, channel, column, factors[0]);
#endif
                    skylight_sh_place((skylight_sh_real)value, l, m, cosines, sines, w);
                }
            }
        }
#if !SKYLIGHT_SH_IS_MIRRORED
        skylight_sh_turn_all(SKYLIGHT_SH_BANDS, cosines, sines, gradient[axis]);
#endif
        skylight_sh_finish(SKYLIGHT_SH_BANDS, 0, gradient[axis]);
    }
    (void)power_slopes;
    (void)sunk;
    return status;
}
