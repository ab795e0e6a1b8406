/* What an export writes of one sum over the sky, for direct.h as it stands. Written by
 * direct.example. */
#pragma once
#include "linkage.h"

/* Rings: circles about the sun, then arcs that end on the horizon; turns
   about it of each. */
#define SKYLIGHT_SH_CIRCLES 6
#define SKYLIGHT_SH_RINGS 16
#define SKYLIGHT_SH_SIDE 8
#define SKYLIGHT_SH_TURNS 6
#define SKYLIGHT_SH_ORDERS(ORDER) ORDER(0) ORDER(1) ORDER(2)

/* Of each ring: its angle to the sun as a share of the circles' largest, or
   the arcs' h over the sun's zenith angle; that from 1; its weight. */
static const float skylight_sh_ring[16] = {
    0.0663903952f, 0.310095847f, 0.616455615f, 0.855074823f, 0.971305251f, 0.998859882f,
    -0.999160111f, -0.9776209f, -0.875859499f, -0.629396141f, -0.231725678f, 0.231725678f,
    0.629396141f, 0.875859499f, 0.9776209f, 0.999160111f
};
static const float skylight_sh_ring_rest[16] = {
    0.0f, 0.0f, 0.0f, 0.0f, 0.0f, 0.0f, 0.00083987118f, 0.0223791171f, 0.124140501f, 0.370603859f,
    0.768274307f, 0.768274307f, 0.370603859f, 0.124140501f, 0.0223791171f, 0.00083987118f
};
static const float skylight_sh_ring_weight[16] = {
    0.331079364f, 0.599300504f, 0.579567194f, 0.356260687f, 0.122222632f, 0.0115696266f,
    0.00858260691f, 0.0987740159f, 0.332140714f, 0.657356322f, 0.903146327f, 0.903146327f,
    0.657356322f, 0.332140714f, 0.0987740159f, 0.00858260691f
};
/* Turns as shares of the ring's, and their weights. */
static const float skylight_sh_turn_at[6] = {
    0.0663903952f, 0.310095847f, 0.616455615f, 0.855074823f, 0.971305251f, 0.998859882f
};
static const float skylight_sh_turn_weight[6] = {
    0.165539682f, 0.299650252f, 0.289783597f, 0.178130344f, 0.0611113161f, 0.00578481331f
};
/* Factors of the basis, order by order: of the diagonal (half a turn about
   the sun in its sign), then for each degree those of the next one's
   recurrence (Holmes and Featherstone 2002). */
static const float skylight_sh_legendre[15] = {
    0.282094806f, 1.73205078f, 0.0f, 1.93649173f, 1.11803401f, 1.97202659f, 1.01835012f,
    -1.73205078f, 2.23606801f, 0.0f, 2.09165001f, 0.935414374f, -1.11803401f, 2.64575124f, 0.0f
};
/* Of degrees 1, 2, ..: eigenvectors of the turn about y, frequencies l, l -
   2, .. (Feng, Wang, Yang and Jin 2015). */
static const float skylight_sh_vectors[8] = {
    1.0f, 1.0f, 0.866025388f, 1.0f, -0.5f, 0.5f, 0.0f, 0.866025388f
};
/* The channels by X, Y and S = X + Y + Z. */
static const double skylight_sh_mix[3][3] = { { 3.7389856, -1.0386071, -0.4985314 },
    { -1.0108219999999999, 1.8344548, 0.041556 }, { -1.0015818, -1.2612511, 1.0572252 } };
/* The model's constants (published): A..E for Y, x and y, by slope and
   offset; zenith chromaticity x and y, by turbidity and zenith angle. */
static const double skylight_sh_perez[5][3][2] = { { { 0.1787, -1.463 }, { -0.0193, -0.2592 },
    { -0.0167, -0.2608 } }, { { -0.3554, 0.4275 }, { -0.0665, 0.0008 }, { -0.095, 0.0092 } },
    { { -0.0227, 5.3251 }, { -0.0004, 0.2125 }, { -0.0079, 0.2102 } }, { { 0.1206, -2.5771 },
    { -0.0641, -0.8989 }, { -0.0441, -1.6537 } }, { { -0.067, 0.3703 }, { -0.0033, 0.0452 },
    { -0.0109, 0.0529 } } };
static const double skylight_sh_zenith[2][3][4] = { { { 0.00166, -0.00375, 0.00209, 0.0 },
    { -0.02903, 0.06377, -0.03202, 0.00394 }, { 0.11693, -0.21196, 0.06052, 0.25886 } },
    { { 0.00275, -0.0061, 0.00317, 0.0 }, { -0.04214, 0.0897, -0.04153, 0.00516 }, { 0.15346,
    -0.26756, 0.0667, 0.26688 } } };

/* cos(m angle) and sin(m angle) for m < bands, by doubling. */
static inline void skylight_sh_circle(float angle, float *cosines, float *sines)
{
    cosines[0] = 1.0f;
    cosines[1] = cosf(angle);
    sines[1] = sinf(angle);
    cosines[2] = cosines[1] * cosines[1] - sines[1] * sines[1];
    sines[0] = 0.0f;
    sines[2] = sines[1] * cosines[1] + cosines[1] * sines[1];
    (void)angle;
}
