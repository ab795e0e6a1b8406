#pragma once
#include "example.h"

/* 0 for a finite number, 1 for an infinity, 2 for NaN: by its bits, so that -ffast-math cannot
   remove the test. */
static inline int skylight_sh_kind(float v)
{
    uint32_t bits;
    memcpy(&bits, &v, sizeof bits);
    bits &= 0x7fffffffu;
    return (bits >= 0x7f800000u) + (bits > 0x7f800000u);
}

/* A number that is no NaN, finite: an infinity becomes a large number of its sign. */
static inline float skylight_sh_finite(float v)
{
    if (skylight_sh_kind(v)) {
        uint32_t bits;
        memcpy(&bits, &v, sizeof bits);
        v = bits >> 31 ? -3e38f : 3e38f;
    }
    return v;
}

/* Clamps the axes' inputs into x. Returns the status: 0; 1 where one was not inside; 2, and nothing
   in x, where one is NaN or the azimuth no finite number. */
static inline int skylight_sh_inputs(const float inputs[SKYLIGHT_SH_AXES], float azimuth,
                                     skylight_sh_real x[SKYLIGHT_SH_AXES])
{
    int axis, status = 0, strange = skylight_sh_kind(azimuth) ? 2 : 0;
    for (axis = 0; axis < SKYLIGHT_SH_AXES; ++axis) strange |= skylight_sh_kind(inputs[axis]);
    if (strange & 2) return 2;
    for (axis = 0; axis < SKYLIGHT_SH_AXES; ++axis) {
        const float v = strange ? skylight_sh_finite(inputs[axis]) : inputs[axis];
        const skylight_sh_real low = skylight_sh_range[axis][0], high = skylight_sh_range[axis][1];
        const skylight_sh_real at_least = (skylight_sh_real)v < low ? low : (skylight_sh_real)v;
        status |= (v < skylight_sh_inside[axis][0]) | (v > skylight_sh_inside[axis][1]);
        x[axis] = at_least > high ? high : at_least;
    }
    return status;
}
#if SKYLIGHT_SH_HAS_TWILIGHT

/* The share of the horizon's light that a sun below it leaves; 1 above the horizon. */
static inline skylight_sh_real skylight_sh_twilight(float sun)
{
    const skylight_sh_real v = (skylight_sh_real)skylight_sh_finite(sun);
    /* The horizon in two parts, since the first may exceed it. */
    const skylight_sh_real sunk = (v - SKYLIGHT_SH_HORIZON) - SKYLIGHT_SH_HORIZON_REST;
    const skylight_sh_real depth = sunk / (skylight_sh_real)SKYLIGHT_SH_DEPTH;
    return skylight_sh_fade(depth < 0 ? 0 : depth > 1 ? 1 : depth);
}
#endif
