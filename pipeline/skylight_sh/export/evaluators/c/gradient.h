#pragma once
#include "evaluate.h"

/* All products of `count` numbers and `size` functions, the functions' place fastest; returns how
   many. */
static inline int skylight_sh_multiply(double *products, int count, const double *functions,
                                       int size)
{
    int i, k;
    for (k = count - 1; k >= 0; --k) {
        const double product = products[k];
        for (i = size - 1; i >= 0; --i) products[k * size + i] = product * functions[i];
    }
    return count * size;
}

/* Evaluates all bands, and their derivatives after each axis by the product rule, in double until
   they are stored: exact inside the ranges, and beyond one those at its edge. */
static inline int skylight_sh_evaluate_gradient(
    const float inputs[SKYLIGHT_SH_AXES], float azimuth,
    float weights[SKYLIGHT_SH_CHANNELS][SKYLIGHT_SH_WEIGHTS],
    float gradient[SKYLIGHT_SH_AXES][SKYLIGHT_SH_CHANNELS][SKYLIGHT_SH_WEIGHTS])
{
    static const int sizes[SKYLIGHT_SH_AXES] = SKYLIGHT_SH_SIZES;
    double x[SKYLIGHT_SH_AXES], functions[SKYLIGHT_SH_AXES][SKYLIGHT_SH_MOST];
    double slopes[SKYLIGHT_SH_AXES][SKYLIGHT_SH_MOST], scale[1 + SKYLIGHT_SH_AXES];
    skylight_sh_real cosines[SKYLIGHT_SH_BANDS], sines[SKYLIGHT_SH_BANDS];
    int axis, other, i;
    const int status = skylight_sh_evaluate(inputs, azimuth, SKYLIGHT_SH_BANDS, weights);
    if (status == 2) {
        memset(gradient, 0,
               sizeof(float) * SKYLIGHT_SH_AXES * SKYLIGHT_SH_CHANNELS * SKYLIGHT_SH_WEIGHTS);
        return 2;
    }
    for (axis = 0; axis < SKYLIGHT_SH_AXES; ++axis) {
        const double low = skylight_sh_slope_range[axis][0];
        const double high = skylight_sh_slope_range[axis][1];
        const double v = (double)skylight_sh_finite(inputs[axis]);
        x[axis] = v < low ? low : v > high ? high : v;
        skylight_sh_functions(axis, x[axis], functions[axis], slopes[axis]);
    }
    skylight_sh_scale_slopes(x, scale);
    for (i = 0; i < 1 + SKYLIGHT_SH_AXES; ++i) scale[i] *= (double)SKYLIGHT_SH_EXPOSURE;
#if SKYLIGHT_SH_HAS_TWILIGHT
    if ((skylight_sh_real)skylight_sh_finite(inputs[SKYLIGHT_SH_SUN]) > SKYLIGHT_SH_HORIZON) {
        /* Below the horizon the light of a sun on it fades, and nothing else hangs on its height. */
        const double sunk = (double)skylight_sh_finite(inputs[SKYLIGHT_SH_SUN]) -
                            skylight_sh_slope_range[SKYLIGHT_SH_SUN][1];
        const double depth = sunk / SKYLIGHT_SH_DEPTH;
        const double horizon = scale[0];
        double fade[2];
        skylight_sh_fade_slope(depth < 0.0 ? 0.0 : depth > 1.0 ? 1.0 : depth, fade);
        for (i = 0; i < 1 + SKYLIGHT_SH_AXES; ++i) scale[i] *= fade[0];
        scale[1 + SKYLIGHT_SH_SUN] = horizon * fade[1] / SKYLIGHT_SH_DEPTH;
        for (i = 0; i < SKYLIGHT_SH_MOST; ++i) slopes[SKYLIGHT_SH_SUN][i] = 0.0;
    }
#endif
    skylight_sh_waves((skylight_sh_real)azimuth, cosines, sines);
    for (axis = 0; axis < SKYLIGHT_SH_AXES; ++axis) {
        double first[SKYLIGHT_SH_MOST], others[SKYLIGHT_SH_OTHERS];
        int count = 1;
        others[0] = 1.0;
        for (other = 0; other < SKYLIGHT_SH_AXES; ++other) {
            double one[SKYLIGHT_SH_MOST];
            for (i = 0; i < sizes[other]; ++i) {
                one[i] = functions[other][i];
                if (other == axis) one[i] = scale[0] * slopes[axis][i] + scale[1 + axis] * one[i];
                if (other == 0) first[i] = one[i];
            }
            if (other) count = skylight_sh_multiply(others, count, one, sizes[other]);
        }
        skylight_sh_combine_double(first, others, cosines, sines, gradient[axis]);
        skylight_sh_finish(SKYLIGHT_SH_BANDS, 0, cosines, sines, gradient[axis]);
    }
    return status;
}
