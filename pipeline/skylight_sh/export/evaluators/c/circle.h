#pragma once
#include "inputs.h"

/* The cosine and sine of an angle. */
static inline void skylight_sh_circle(skylight_sh_real angle, skylight_sh_real *cosine,
                                      skylight_sh_real *sine)
{
#if SKYLIGHT_SH_IS_SINGLE
    /* By the nearest quarter turn and the rest of it: without a branch, which a processor would have
       to guess. The rest in double, since the two nearly cancel. */
    float out[2];
    uint32_t bits[2], quarter, swapped;
    int quarters;
    if (!(angle > -1e5f && angle < 1e5f)) {
        *cosine = cosf(angle);
        *sine = sinf(angle);
        return;
    }
    quarters = (int)(angle * 0.636619772f + copysignf(0.5f, angle));
    skylight_sh_quarter((float)((double)angle - (double)quarters * 1.5707963267948966), out);
    memcpy(bits, out, sizeof bits);
    quarter = (uint32_t)quarters;
    /* Odd quarters swap the two; each changes its sign in two of four. */
    swapped = (bits[0] ^ bits[1]) & (0u - (quarter & 1u));
    bits[0] ^= swapped ^ (((quarter + 1u) & 2u) << 30);
    bits[1] ^= swapped ^ ((quarter & 2u) << 30);
    memcpy(cosine, &bits[0], sizeof bits[0]);
    memcpy(sine, &bits[1], sizeof bits[1]);
#else
    *cosine = cos(angle);
    *sine = sin(angle);
#endif
}
