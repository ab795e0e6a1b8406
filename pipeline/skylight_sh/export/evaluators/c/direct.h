#pragma once
#include "direct_example.h"
#include "inputs.h"

/* The Preetham sky summed over nodes about the sun: rings of one angle to it, with the same shares
   of the turn about it on each. Loops run over rings side by side, which makes vectors of them. */
#define SKYLIGHT_SH_PAIRS (SKYLIGHT_SH_BANDS * (SKYLIGHT_SH_BANDS + 1) / 2)
#define SKYLIGHT_SH_HALF_PI 1.57079633f
#if defined(__GNUC__) && __GNUC__ >= 8 && !defined(__clang__)
/* Or gcc unrolls these loops before it looks for vectors. */
#define SKYLIGHT_SH_EACH _Pragma("GCC unroll 1") for (i = 0; i < SKYLIGHT_SH_SIDE; ++i)
#else
#define SKYLIGHT_SH_EACH for (i = 0; i < SKYLIGHT_SH_SIDE; ++i)
#endif

/* exp(x) for -87 <= x <= 0, to 2e-7 of 1: a power of 2 and a polynomial. */
static inline float skylight_sh_exp(float x)
{
    const float power = x * 1.44269504f;
    const int32_t whole = (int32_t)(power - 0.5f);
    const float rest = power - (float)whole;
    const int32_t bits = (whole + 127) * (1 << 23);
    float scale, sum = 0.0013276472f;
    memcpy(&scale, &bits, sizeof scale);
    sum = sum * rest + 0.0096755415f;
    sum = sum * rest + 0.0555071328f;
    sum = sum * rest + 0.240221197f;
    sum = sum * rest + 0.693146967f;
    return scale * (sum * rest + 1.0f);
}

/* sin(x) for |x| <= pi / 2, to 2e-7. */
static inline float skylight_sh_sin(float x)
{
    const float square = x * x;
    float sum = 2.60190307e-06f;
    sum = sum * square - 0.000198074187f;
    sum = sum * square + 0.00833302514f;
    sum = sum * square - 0.166666567f;
    return x * (sum * square + 1.0f);
}

/* acos(1 - part) over the root of `part`, 0 <= part <= 1, to 2e-7. */
static inline float skylight_sh_arc(float part)
{
    float sum = 0.00125345693f;
    sum = sum * part - 0.00213557984f;
    sum = sum * part + 0.0035359872f;
    sum = sum * part + 0.00134552264f;
    sum = sum * part + 0.00826283129f;
    sum = sum * part + 0.0264669128f;
    sum = sum * part + 0.117853631f;
    return sum * part + 1.41421354f;
}

/* A sky but for the direction: A..E of the Perez function for Y, x and y; the least height over the
   horizon to divide by; the channels by sums of X, Y and S = Y / y without the zenith's factors. */
typedef struct {
    float a[3], b[3], c[3], d[3], e[3], least;
    double mix[SKYLIGHT_SH_CHANNELS][3];
} skylight_sh_sky;

/* The model of Preetham et al. 1999, appendix A.2, in cd/m2. In double precision: for low
   turbidities the luminance's divisor is a small difference, and the channels are differences. */
static inline skylight_sh_sky skylight_sh_model(double theta, double tau)
{
    const double pi = 3.14159265358979324, chi = (4.0 / 9.0 - tau / 120.0) * (pi - 2.0 * theta);
    const double cosine = cos(theta);
    double zenith[3] = { 0.0, 0.0, 0.0 }, factor[3];
    skylight_sh_sky sky;
    int i, k;
    zenith[0] = 1000.0 * ((4.0453 * tau - 4.9710) * tan(chi) - 0.2155 * tau + 2.4192);
    for (k = 0; k < 2; ++k) {
        for (i = 0; i < 3; ++i) {
            const double *const p = skylight_sh_zenith[k][i];
            zenith[1 + k] *= tau;
            zenith[1 + k] += ((p[0] * theta + p[1]) * theta + p[2]) * theta + p[3];
        }
    }
    sky.least = 0.0f;
    for (k = 0; k < 3; ++k) {
        double v[5];
        for (i = 0; i < 5; ++i)
            v[i] = skylight_sh_perez[i][k][0] * tau + skylight_sh_perez[i][k][1];
        zenith[k] /= 1.0 + v[0] * exp(v[1]);
        zenith[k] /= 1.0 + v[2] * exp(v[3] * theta) + v[4] * cosine * cosine;
        sky.a[k] = (float)v[0];
        sky.b[k] = (float)v[1];
        sky.c[k] = (float)v[2];
        sky.d[k] = (float)v[3];
        sky.e[k] = (float)v[4];
        /* B is negative. Any lower, and all three exp(B / height) are below 1e-7. */
        if (sky.least < sky.b[k] / -87.0f) sky.least = sky.b[k] / -87.0f;
    }
    factor[2] = zenith[0] / zenith[2];
    factor[1] = zenith[0];
    factor[0] = factor[2] * zenith[1];
    for (i = 0; i < SKYLIGHT_SH_CHANNELS; ++i)
        for (k = 0; k < 3; ++k)
            sky.mix[i][k] = skylight_sh_mix[i][k] * factor[k] * (double)SKYLIGHT_SH_EXPOSURE;
    return sky;
}

/* Rings side by side: their angle to the sun, with its cosine and sine; the turn about the sun that
   ends on the horizon, or pi; height = level + rise cos(turn); the ring's solid angle. */
typedef struct {
    float angle[SKYLIGHT_SH_SIDE], cosine[SKYLIGHT_SH_SIDE], sine[SKYLIGHT_SH_SIDE];
    float end[SKYLIGHT_SH_SIDE], level[SKYLIGHT_SH_SIDE], rise[SKYLIGHT_SH_SIDE];
    float weight[SKYLIGHT_SH_SIDE];
} skylight_sh_rings;

/* Places the rings from `first` on about a sun at theta. First come circles, up to pi / 2 - theta
   from it, then arcs at pi / 2 + h, h = theta sin u, which the horizon cuts off. */
static inline void skylight_sh_place(int first, float theta, float cosine_theta, float sine_theta,
                                     skylight_sh_rings *rings)
{
    const float half_pi = SKYLIGHT_SH_HALF_PI, reach = half_pi > theta ? half_pi - theta : 0.0f;
    float part[SKYLIGHT_SH_SIDE], beyond[SKYLIGHT_SH_SIDE];
    int i;
    /* Choices by factors of 0 and 1, since branches hinder vectors. */
    SKYLIGHT_SH_EACH
    {
        const float circle = (float)(first + i < SKYLIGHT_SH_CIRCLES), arc = 1.0f - circle;
        const float size = circle * reach + arc * theta;
        const float h = size * skylight_sh_ring[first + i];
        const float deep = fabsf(h), sine = skylight_sh_sin(h);
        const float cosine = skylight_sh_sin(half_pi - deep);
        /* tan h / tan theta, the cosine of the turn that ends on the horizon, by its distance from
           1 or -1: that has the digits which the quotient loses. */
        const float left = skylight_sh_sin(theta * skylight_sh_ring_rest[first + i]);
        const float sum = theta + deep, other = 2.0f * half_pi - sum;
        const float right = skylight_sh_sin(sum < other ? sum : other);
        part[i] = arc * 2.0f * left / (left + right);
        beyond[i] = (float)(arc * h <= 0.0f);
        rings->angle[i] = arc * half_pi + h;
        rings->cosine[i] = circle * cosine - arc * sine;
        rings->sine[i] = circle * sine + arc * cosine;
        rings->level[i] = cosine_theta * rings->cosine[i];
        rings->rise[i] = sine_theta * rings->sine[i];
        rings->weight[i] = size * skylight_sh_ring_weight[first + i] * rings->sine[i];
    }
    SKYLIGHT_SH_EACH rings->end[i] = sqrtf(part[i]);
    SKYLIGHT_SH_EACH
    {
        const float end = rings->end[i] * skylight_sh_arc(part[i]);
        rings->end[i] = beyond[i] * 2.0f * (half_pi - end) + end;
        rings->weight[i] *= rings->end[i];
    }
}

/* Sums X, Y and S over the turns of each ring, against the waves cos(m turn). */
static inline void skylight_sh_sum_turns(const skylight_sh_sky *light,
                                         const skylight_sh_rings *places,
                                         float sums[SKYLIGHT_SH_BANDS][3][SKYLIGHT_SH_SIDE])
{
    /* Own copies, which nothing else points to. */
    const skylight_sh_sky sky = *light;
    const skylight_sh_rings ring = *places;
    float factor[3][SKYLIGHT_SH_SIDE], sum[SKYLIGHT_SH_BANDS][3][SKYLIGHT_SH_SIDE];
    int i, j, k, m;
    for (k = 0; k < 3; ++k) {
        SKYLIGHT_SH_EACH
        {
            const float glow = sky.c[k] * skylight_sh_exp(sky.d[k] * ring.angle[i]);
            factor[k][i] = 1.0f + glow + sky.e[k] * ring.cosine[i] * ring.cosine[i];
        }
    }
    SKYLIGHT_SH_EACH
    {
        const float luminance = factor[0][i] * ring.weight[i], all = luminance / factor[2][i];
        factor[2][i] = all;
        factor[0][i] = all * factor[1][i];
        factor[1][i] = luminance;
    }
    memset(sum, 0, sizeof sum);
    for (j = 0; j < SKYLIGHT_SH_TURNS; ++j) {
        const float turn = skylight_sh_turn_at[j], weight = skylight_sh_turn_weight[j];
        SKYLIGHT_SH_EACH
        {
            const float cosine = skylight_sh_sin(SKYLIGHT_SH_HALF_PI - turn * ring.end[i]);
            const float height = ring.level[i] + ring.rise[i] * cosine;
            const float secant = 1.0f / (height < sky.least ? sky.least : height);
            const float of_light = 1.0f + sky.a[0] * skylight_sh_exp(sky.b[0] * secant);
            const float of_x = 1.0f + sky.a[1] * skylight_sh_exp(sky.b[1] * secant);
            const float of_y = 1.0f + sky.a[2] * skylight_sh_exp(sky.b[2] * secant);
            const float luminance = weight * of_light, all = luminance / of_y, red = all * of_x;
            float now = 1.0f, ahead = cosine, next;
#define SKYLIGHT_SH_ORDER(m) \
    sum[m][0][i] += red * now; \
    sum[m][1][i] += luminance * now; \
    sum[m][2][i] += all * now; \
    next = 2.0f * cosine * ahead - now; \
    now = ahead; \
    ahead = next;
            SKYLIGHT_SH_ORDERS(SKYLIGHT_SH_ORDER)
#undef SKYLIGHT_SH_ORDER
        }
    }
    for (m = 0; m < SKYLIGHT_SH_BANDS; ++m)
        for (k = 0; k < 3; ++k) SKYLIGHT_SH_EACH sums[m][k][i] = sum[m][k][i] * factor[k][i];
}

/* Adds rings to the weights in the sun's own frame, by Legendre factors of their angles. */
static inline void skylight_sh_sum_rings(const skylight_sh_rings *rings,
                                         float sums[SKYLIGHT_SH_BANDS][3][SKYLIGHT_SH_SIDE],
                                         float total[SKYLIGHT_SH_PAIRS][3][SKYLIGHT_SH_SIDE])
{
    const float *factor = skylight_sh_legendre;
    float start[SKYLIGHT_SH_SIDE], before[SKYLIGHT_SH_SIDE], now[SKYLIGHT_SH_SIDE];
    int i, k, l, m;
    for (m = 0; m < SKYLIGHT_SH_BANDS; ++m) {
        const float diagonal = *factor++;
        SKYLIGHT_SH_EACH
        {
            start[i] = m ? start[i] * diagonal * rings->sine[i] : diagonal;
            before[i] = 0.0f;
            now[i] = start[i];
        }
        for (l = m; l < SKYLIGHT_SH_BANDS; ++l) {
            float(*const of)[SKYLIGHT_SH_SIDE] = total[l * (l + 1) / 2 + m];
            const float ahead = *factor++, behind = *factor++;
            for (k = 0; k < 3; ++k) SKYLIGHT_SH_EACH of[k][i] += sums[m][k][i] * now[i];
            SKYLIGHT_SH_EACH
            {
                const float next = ahead * rings->cosine[i] * now[i] - behind * before[i];
                before[i] = now[i];
                now[i] = next;
            }
        }
    }
}

/* Turns weights of orders m >= 0 about y, by the waves of the angle: eigenvectors of the turn's
   generator, frequency by frequency. */
static inline void skylight_sh_turn_down(const float *cosines, const float *sines,
                                         float weights[SKYLIGHT_SH_PAIRS][4])
{
    const float *vector = skylight_sh_vectors;
    int k, l, m, n;
    for (l = 1; l < SKYLIGHT_SH_BANDS; ++l) {
        float(*const of)[4] = weights + l * (l + 1) / 2;
        float out[SKYLIGHT_SH_BANDS][4];
        memset(out, 0, sizeof out);
        for (n = l; n >= 0; n -= 2, vector += l + 1) {
            float part[2][4];
            memset(part, 0, sizeof part);
            for (m = 0; m <= l; ++m)
                for (k = 0; k < 4; ++k) part[m & 1][k] += vector[m] * of[m][k];
            for (k = 0; k < 4; ++k) {
                const float even = part[0][k], odd = part[1][k];
                part[0][k] = even * cosines[n] - odd * sines[n];
                part[1][k] = even * sines[n] + odd * cosines[n];
            }
            for (m = 0; m <= l; ++m)
                for (k = 0; k < 4; ++k) out[m][k] += vector[m] * part[m & 1][k];
        }
        memcpy(of, out, sizeof *of * (size_t)(l + 1));
    }
}

/* Sums the sky and turns it to its azimuth; returns the status. */
SKYLIGHT_SH_API int skylight_sh_weights(float sun_zenith, float sun_azimuth, float turbidity,
                                        float weights[SKYLIGHT_SH_CHANNELS][SKYLIGHT_SH_WEIGHTS])
{
    const float given[SKYLIGHT_SH_AXES] = { sun_zenith, turbidity };
    const double horizon = 1.57079632679489662;
    float x[SKYLIGHT_SH_AXES], cosines[SKYLIGHT_SH_BANDS], sines[SKYLIGHT_SH_BANDS], theta;
    float total[SKYLIGHT_SH_PAIRS][3][SKYLIGHT_SH_SIDE], of[SKYLIGHT_SH_PAIRS][4];
    skylight_sh_sky sky;
    int channel, first, i, k, l, m, status = skylight_sh_inputs(given, sun_azimuth, x);
    if (status == 2) {
        memset(weights, 0, sizeof(float) * SKYLIGHT_SH_CHANNELS * SKYLIGHT_SH_WEIGHTS);
        return 2;
    }
    /* As float32 pi / 2 is below the horizon. */
    sky = skylight_sh_model((double)x[0] > horizon ? horizon : (double)x[0], (double)x[1]);
    /* About the zenith itself arcs are nothing, and their ends 0 / 0. */
    theta = x[0] < 1e-9f ? 1e-9f : x[0];
    memset(total, 0, sizeof total);
    for (first = 0; first < SKYLIGHT_SH_RINGS; first += SKYLIGHT_SH_SIDE) {
        float sums[SKYLIGHT_SH_BANDS][3][SKYLIGHT_SH_SIDE];
        skylight_sh_rings rings;
        skylight_sh_place(first, theta, cosf(theta), sinf(theta), &rings);
        skylight_sh_sum_turns(&sky, &rings, sums);
        skylight_sh_sum_rings(&rings, sums, total);
    }
    for (l = 0; l < SKYLIGHT_SH_PAIRS; ++l) {
        for (k = 0; k < 3; ++k)
            for (i = 0, of[l][k] = 0.0f; i < SKYLIGHT_SH_SIDE; ++i) of[l][k] += total[l][k][i];
        of[l][3] = 0.0f;
    }
    skylight_sh_circle(theta, cosines, sines);
    skylight_sh_turn_down(cosines, sines, of);
    skylight_sh_circle(sun_azimuth, cosines, sines);
    for (channel = 0; channel < SKYLIGHT_SH_CHANNELS; ++channel) {
        const double *const mix = sky.mix[channel];
        for (l = 0; l < SKYLIGHT_SH_BANDS; ++l) {
            for (m = 0; m <= l; ++m) {
                const float *const w = of[l * (l + 1) / 2 + m];
                const double x_y = mix[0] * (double)w[0] + mix[1] * (double)w[1];
                const float sum = (float)(x_y + mix[2] * (double)w[2]);
                weights[channel][l * (l + 1) - m] = sum * sines[m];
                weights[channel][l * (l + 1) + m] = sum * cosines[m];
            }
        }
    }
    return status;
}
