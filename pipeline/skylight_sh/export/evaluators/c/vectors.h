#pragma once
#include "inputs.h"

/* Numbers side by side where the compiler has vector types: as many as the processor's registers
   hold, and four. */
#if SKYLIGHT_SH_IS_SINGLE
#if defined(__GNUC__) && (defined(__SSE__) || defined(__ARM_NEON) || defined(__ALTIVEC__) || \
                          defined(__wasm_simd128__) || defined(__loongarch_sx))
#if defined(__AVX512F__)
#define SKYLIGHT_SH_LANES 16
#elif defined(__AVX__)
#define SKYLIGHT_SH_LANES 8
#else
#define SKYLIGHT_SH_LANES 4
#endif
#endif
#endif
#ifdef SKYLIGHT_SH_LANES
#ifdef __FMA__
/* One operation for a product and a sum, which standard C may not choose by itself. */
#include <immintrin.h>
#endif
typedef float skylight_sh_lanes __attribute__((vector_size(4 * SKYLIGHT_SH_LANES)));
typedef float skylight_sh_four __attribute__((vector_size(16)));
typedef int skylight_sh_order __attribute__((vector_size(16)));

static inline skylight_sh_lanes skylight_sh_spread(float v)
{
    const skylight_sh_lanes zeros = {0};
    return zeros + v;
}

static inline skylight_sh_lanes skylight_sh_load(const float *from)
{
    skylight_sh_lanes v;
    memcpy(&v, from, sizeof v);
    return v;
}

/* a * b + c. */
static inline skylight_sh_lanes skylight_sh_add(skylight_sh_lanes a, skylight_sh_lanes b,
                                                skylight_sh_lanes c)
{
#if defined(__FMA__) && SKYLIGHT_SH_LANES == 16
    return _mm512_fmadd_ps(a, b, c);
#elif defined(__FMA__) && SKYLIGHT_SH_LANES == 8
    return _mm256_fmadd_ps(a, b, c);
#else
    return a * b + c;
#endif
}

static inline skylight_sh_four skylight_sh_four_of(const float *from)
{
    skylight_sh_four v;
    memcpy(&v, from, sizeof v);
    return v;
}

static inline void skylight_sh_keep(float *to, skylight_sh_four v)
{
    memcpy(to, &v, sizeof v);
}

static inline skylight_sh_four skylight_sh_product(skylight_sh_four a, skylight_sh_four b)
{
    return a * b;
}

static inline skylight_sh_four skylight_sh_scaled(skylight_sh_four a, float b)
{
    return a * b;
}

static inline skylight_sh_four skylight_sh_plus(skylight_sh_four a, skylight_sh_four b)
{
    return a + b;
}

static inline void skylight_sh_put(float *to, skylight_sh_four v)
{
    memcpy(to, &v, sizeof v);
}

static inline skylight_sh_four skylight_sh_backwards(skylight_sh_four v)
{
#if defined(__clang__)
    return __builtin_shufflevector(v, v, 3, 2, 1, 0);
#else
    const skylight_sh_order order = {3, 2, 1, 0};
    return __builtin_shuffle(v, order);
#endif
}
#else
typedef struct {
    skylight_sh_real v[4];
} skylight_sh_four;

static inline skylight_sh_four skylight_sh_four_of(const skylight_sh_real *from)
{
    skylight_sh_four v;
    memcpy(&v, from, sizeof v);
    return v;
}

static inline void skylight_sh_keep(skylight_sh_real *to, skylight_sh_four v)
{
    memcpy(to, &v, sizeof v);
}

static inline skylight_sh_four skylight_sh_product(skylight_sh_four a, skylight_sh_four b)
{
    int i;
    for (i = 0; i < 4; ++i) a.v[i] *= b.v[i];
    return a;
}

static inline skylight_sh_four skylight_sh_scaled(skylight_sh_four a, skylight_sh_real b)
{
    int i;
    for (i = 0; i < 4; ++i) a.v[i] *= b;
    return a;
}

static inline skylight_sh_four skylight_sh_plus(skylight_sh_four a, skylight_sh_four b)
{
    int i;
    for (i = 0; i < 4; ++i) a.v[i] += b.v[i];
    return a;
}

static inline void skylight_sh_put(float *to, skylight_sh_four v)
{
    int i;
    for (i = 0; i < 4; ++i) to[i] = (float)v.v[i];
}

static inline skylight_sh_four skylight_sh_backwards(skylight_sh_four v)
{
    skylight_sh_four turned;
    int i;
    for (i = 0; i < 4; ++i) turned.v[i] = v.v[3 - i];
    return turned;
}
#endif
