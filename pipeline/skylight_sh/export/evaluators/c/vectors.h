#pragma once
#include "linkage.h"

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
/* What is worth its place in every caller; what lies at the start of a cache line. */
#ifdef __GNUC__
#define SKYLIGHT_SH_INLINE static inline __attribute__((always_inline))
#define SKYLIGHT_SH_ALIGNED __attribute__((aligned(64)))
#else
#define SKYLIGHT_SH_INLINE static inline
#define SKYLIGHT_SH_ALIGNED
#endif
#ifdef SKYLIGHT_SH_LANES
#ifdef __FMA__
/* One operation for a product and a sum, which standard C may not choose by itself. */
#include <immintrin.h>
#endif
typedef float skylight_sh_lanes __attribute__((vector_size(4 * SKYLIGHT_SH_LANES)));
typedef float skylight_sh_four __attribute__((vector_size(16)));
typedef int skylight_sh_order __attribute__((vector_size(16)));

/* The same number in all places: v - 0 is v, which 0 + v need not be. */
static inline skylight_sh_lanes skylight_sh_spread(float v)
{
    const skylight_sh_lanes zeros = {0};
    return v - zeros;
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

static inline skylight_sh_four skylight_sh_spread_four(float v)
{
    const skylight_sh_four zeros = {0};
    return v - zeros;
}

static inline skylight_sh_four skylight_sh_load_four(const float *from)
{
    skylight_sh_four v;
    memcpy(&v, from, sizeof v);
    return v;
}

static inline skylight_sh_four skylight_sh_add_four(skylight_sh_four a, skylight_sh_four b,
                                                    skylight_sh_four c)
{
#ifdef __FMA__
    return _mm_fmadd_ps(a, b, c);
#else
    return a * b + c;
#endif
}

/* Numbers side by side; where there are fewer than four, the last again. */
static inline skylight_sh_four skylight_sh_quadruple(float a, float b, float c, float d)
{
    const skylight_sh_four v = {a, b, c, d};
    return v;
}

static inline skylight_sh_four skylight_sh_triple(float a, float b, float c)
{
    return skylight_sh_quadruple(a, b, c, c);
}

static inline skylight_sh_four skylight_sh_pair(float a, float b)
{
    return skylight_sh_quadruple(a, b, b, b);
}

static inline void skylight_sh_keep(float *to, skylight_sh_four v)
{
    memcpy(to, &v, sizeof v);
}

/* Four of the eight numbers of two vectors. */
#ifdef __clang__
#define SKYLIGHT_SH_PICK(v, w, a, b, c, d) __builtin_shufflevector(v, w, a, b, c, d)
#else
#define SKYLIGHT_SH_PICK(v, w, a, b, c, d) skylight_sh_pick(v, w, a, b, c, d)
static inline skylight_sh_four skylight_sh_pick(skylight_sh_four v, skylight_sh_four w, int a,
                                                int b, int c, int d)
{
    const skylight_sh_order order = {a, b, c, d};
    return __builtin_shuffle(v, w, order);
}
#endif
#endif
