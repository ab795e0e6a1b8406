#pragma once
#include "example.h"
#if SKYLIGHT_SH_IS_MIRRORED

/* Orders m >= 0 alone are stored: those of a light that is even in y at azimuth 0. */
#define SKYLIGHT_SH_FIRST_ORDER(l) 0

/* Stores the weight of degree l and order m turned by the azimuth (Habel et al. 2008, eq. 4). */
static inline void skylight_sh_place(skylight_sh_real value, int l, int m,
                                     const skylight_sh_real *cosines, const skylight_sh_real *sines,
                                     float *weights)
{
    weights[l * (l + 1) - m] = (float)(value * sines[m]);
    weights[l * (l + 1) + m] = (float)(value * cosines[m]);
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
#endif
