#pragma once
#include "evaluate.h"

/* One of many suns by itself. */
static inline int skylight_sh_evaluate_one(const skylight_sh_real *rows,
                                           const float *const inputs[SKYLIGHT_SH_AXES],
                                           const float *azimuths, int sun,
                                           float weights[SKYLIGHT_SH_CHANNELS][SKYLIGHT_SH_WEIGHTS])
{
    float given[SKYLIGHT_SH_AXES];
    int axis;
    for (axis = 0; axis < SKYLIGHT_SH_AXES; ++axis) given[axis] = inputs[axis][sun];
    return skylight_sh_evaluate(rows, given, azimuths ? azimuths[sun] : SKYLIGHT_SH_AZIMUTH,
                                SKYLIGHT_SH_BANDS, weights);
}
#if SKYLIGHT_SH_HAS_WIDE
#ifdef SKYLIGHT_SH_LANES
/* Suns that are evaluated side by side, and the vectors that they take. */
#define SKYLIGHT_SH_SUNS 16
#define SKYLIGHT_SH_GROUPS (SKYLIGHT_SH_SUNS / SKYLIGHT_SH_LANES)

/* Cosines and sines of angles side by side, as skylight_sh_circle has them. */
static inline void skylight_sh_circle_suns(const float *angles, float *cosines, float *sines)
{
    float rest[SKYLIGHT_SH_LANES];
    uint32_t bits[2][SKYLIGHT_SH_LANES], quarter[SKYLIGHT_SH_LANES];
    skylight_sh_lanes out[2];
    int s, far = 0;
    for (s = 0; s < SKYLIGHT_SH_LANES; ++s) far |= !(angles[s] > -1e5f && angles[s] < 1e5f);
    if (far) {
        for (s = 0; s < SKYLIGHT_SH_LANES; ++s) skylight_sh_circle(angles[s], cosines + s, sines + s);
        return;
    }
    for (s = 0; s < SKYLIGHT_SH_LANES; ++s) {
        const int quarters = (int)(angles[s] * 0.636619772f + copysignf(0.5f, angles[s]));
        rest[s] = (float)((double)angles[s] - (double)quarters * 1.5707963267948966);
        quarter[s] = (uint32_t)quarters;
    }
    skylight_sh_quarter_suns(skylight_sh_load(rest), out);
    memcpy(bits, out, sizeof bits);
    for (s = 0; s < SKYLIGHT_SH_LANES; ++s) {
        const uint32_t swapped = (bits[0][s] ^ bits[1][s]) & (0u - (quarter[s] & 1u));
        bits[0][s] ^= swapped ^ (((quarter[s] + 1u) & 2u) << 30);
        bits[1][s] ^= swapped ^ ((quarter[s] & 2u) << 30);
    }
    memcpy(cosines, bits[0], sizeof bits[0]);
    memcpy(sines, bits[1], sizeof bits[1]);
}

/* Reads SKYLIGHT_SH_SUNS suns from `start` on: clamped inputs, azimuths, what light each leaves.
   Returns the largest status; a sun of status 2 has no light. */
static inline int skylight_sh_inputs_suns(const float *const inputs[SKYLIGHT_SH_AXES],
                                          const float *azimuths, int start,
                                          float x[SKYLIGHT_SH_AXES][SKYLIGHT_SH_SUNS],
                                          float *azimuth, float *light)
{
    int axis, s, status = 0, strange = 0;
    for (s = 0; s < SKYLIGHT_SH_SUNS; ++s) {
        azimuth[s] = azimuths ? azimuths[start + s] : SKYLIGHT_SH_AZIMUTH;
        light[s] = SKYLIGHT_SH_EXPOSURE;
        strange |= skylight_sh_kind(azimuth[s]);
    }
    for (axis = 0; axis < SKYLIGHT_SH_AXES; ++axis) {
        const float low = skylight_sh_range[axis][0], high = skylight_sh_range[axis][1];
        for (s = 0; s < SKYLIGHT_SH_SUNS; ++s) {
            const float v = inputs[axis][start + s], at_least = v < low ? low : v;
            strange |= skylight_sh_kind(v);
            status |= (v < skylight_sh_inside[axis][0]) | (v > skylight_sh_inside[axis][1]);
            x[axis][s] = at_least > high ? high : at_least;
        }
    }
    if (strange) {
        for (s = 0; s < SKYLIGHT_SH_SUNS; ++s) {
            float given[SKYLIGHT_SH_AXES], clamped[SKYLIGHT_SH_AXES];
            int found;
            for (axis = 0; axis < SKYLIGHT_SH_AXES; ++axis) given[axis] = inputs[axis][start + s];
            found = skylight_sh_inputs(given, azimuth[s], clamped);
            if (found == 2) light[s] = azimuth[s] = 0.0f;
            for (axis = 0; axis < SKYLIGHT_SH_AXES; ++axis)
                x[axis][s] = found == 2 ? skylight_sh_range[axis][0] : clamped[axis];
            status = found > status ? found : status;
        }
    }
#if SKYLIGHT_SH_HAS_TWILIGHT
    for (s = 0; s < SKYLIGHT_SH_SUNS; ++s)
        light[s] *= skylight_sh_twilight(inputs[SKYLIGHT_SH_SUN][start + s]);
#endif
    return status;
}

/* The sums of suns side by side: of each class and number of a row, over the products of the other
   axes' functions, each times a polynomial in powers of u. */
static inline void skylight_sh_sum_suns(
    const skylight_sh_real *rows, const skylight_sh_lanes u[SKYLIGHT_SH_GROUPS],
    skylight_sh_lanes others[SKYLIGHT_SH_GROUPS][SKYLIGHT_SH_OTHERS],
    skylight_sh_lanes sums[SKYLIGHT_SH_CLASSES][SKYLIGHT_SH_WIDTH][SKYLIGHT_SH_GROUPS])
{
    int i, t;
    for (i = 0; i < SKYLIGHT_SH_WIDTH; ++i) {
#define SKYLIGHT_SH_CLASS(which, polynomials) \
    { \
        const int which_class = (which); \
        skylight_sh_lanes total[SKYLIGHT_SH_GROUPS]; \
        polynomials SKYLIGHT_SH_EACH(SKYLIGHT_SH_SUM) \
    }
#define SKYLIGHT_SH_SUM(g) \
    if ((g) < SKYLIGHT_SH_GROUPS) sums[which_class][i][g] = total[g];
#define SKYLIGHT_SH_NOTHING SKYLIGHT_SH_EACH(SKYLIGHT_SH_ZERO)
#define SKYLIGHT_SH_ZERO(g) \
    if ((g) < SKYLIGHT_SH_GROUPS) total[g] = skylight_sh_spread(0);
#define SKYLIGHT_SH_POLYNOMIAL(begin, count, other) \
    { \
        const float *term = rows + ((begin) + (count) - 1) * SKYLIGHT_SH_WIDTH + i; \
        skylight_sh_lanes sum[SKYLIGHT_SH_GROUPS], number = skylight_sh_spread(*term); \
        SKYLIGHT_SH_EACH(SKYLIGHT_SH_LAST) \
        for (t = 1; t < (count); ++t) { \
            term -= SKYLIGHT_SH_WIDTH; \
            number = skylight_sh_spread(*term); \
            SKYLIGHT_SH_EACH(SKYLIGHT_SH_STEP_DOWN) \
        } \
        { \
            const int which_other = (other); \
            SKYLIGHT_SH_EACH(SKYLIGHT_SH_TOTAL) \
        } \
    }
#define SKYLIGHT_SH_LAST(g) \
    if ((g) < SKYLIGHT_SH_GROUPS) sum[g] = number;
#define SKYLIGHT_SH_STEP_DOWN(g) \
    if ((g) < SKYLIGHT_SH_GROUPS) { \
        skylight_sh_lanes v = skylight_sh_add(sum[g], u[g], number); \
        SKYLIGHT_SH_IN_ORDER(v) \
        sum[g] = v; \
    }
#define SKYLIGHT_SH_TOTAL(g) \
    if ((g) < SKYLIGHT_SH_GROUPS) total[g] = skylight_sh_add(sum[g], others[g][which_other], total[g]);
        SKYLIGHT_SH_POLYNOMIALS(SKYLIGHT_SH_CLASS, SKYLIGHT_SH_NOTHING, SKYLIGHT_SH_POLYNOMIAL)
#undef SKYLIGHT_SH_CLASS
#undef SKYLIGHT_SH_NOTHING
#undef SKYLIGHT_SH_POLYNOMIAL
#undef SKYLIGHT_SH_SUM
#undef SKYLIGHT_SH_ZERO
#undef SKYLIGHT_SH_LAST
#undef SKYLIGHT_SH_STEP_DOWN
#undef SKYLIGHT_SH_TOTAL
    }
}

/* Whether all suns share the other axes: a day in one weather. */
static inline int skylight_sh_share(const float *const inputs[SKYLIGHT_SH_AXES], int count)
{
    int axis, s, differ = 0;
    for (axis = 1; axis < SKYLIGHT_SH_AXES; ++axis)
        for (s = 1; s < count && !differ; ++s)
            differ = memcmp(inputs[axis] + s, inputs[axis], sizeof(float)) != 0;
    return !differ;
}

/* Sums the rows over the other axes' functions at the first sun once for all: of each class a row for
   each power of u. */
static inline void skylight_sh_sum_shared(const skylight_sh_real *rows,
                                          const float *const inputs[SKYLIGHT_SH_AXES],
                                          float shared[SKYLIGHT_SH_SHARED][SKYLIGHT_SH_WIDTH])
{
    static const unsigned short before[SKYLIGHT_SH_CLASSES] = SKYLIGHT_SH_BEFORE;
    float given[SKYLIGHT_SH_AXES], x[SKYLIGHT_SH_AXES], others[SKYLIGHT_SH_OTHERS];
    int axis, i, t;
    for (axis = 0; axis < SKYLIGHT_SH_AXES; ++axis) given[axis] = inputs[axis][0];
    for (t = 0; t < SKYLIGHT_SH_SHARED; ++t)
        for (i = 0; i < SKYLIGHT_SH_WIDTH; ++i) shared[t][i] = 0.0f;
    /* The first axis is another matter: it is inside. */
    given[0] = skylight_sh_range[0][0];
    if (skylight_sh_inputs(given, 0.0f, x) == 2) return;
    skylight_sh_others(x, others);
#define SKYLIGHT_SH_CLASS(which, polynomials) \
    { \
        const int place = before[which]; \
        (void)place; \
        polynomials \
    }
#define SKYLIGHT_SH_NOTHING
#define SKYLIGHT_SH_POLYNOMIAL(begin, count, other) \
    for (t = 0; t < (count); ++t) \
        for (i = 0; i < SKYLIGHT_SH_WIDTH; ++i) \
            shared[place + t][i] += others[other] * rows[((begin) + t) * SKYLIGHT_SH_WIDTH + i];
    SKYLIGHT_SH_POLYNOMIALS(SKYLIGHT_SH_CLASS, SKYLIGHT_SH_NOTHING, SKYLIGHT_SH_POLYNOMIAL)
#undef SKYLIGHT_SH_CLASS
#undef SKYLIGHT_SH_NOTHING
#undef SKYLIGHT_SH_POLYNOMIAL
}

/* The sums of suns side by side that share the other axes: polynomials in powers of u alone. */
static inline void skylight_sh_sum_sharing(
    float shared[SKYLIGHT_SH_SHARED][SKYLIGHT_SH_WIDTH], const skylight_sh_lanes u[SKYLIGHT_SH_GROUPS],
    skylight_sh_lanes sums[SKYLIGHT_SH_CLASSES][SKYLIGHT_SH_WIDTH][SKYLIGHT_SH_GROUPS])
{
    static const unsigned char longest[SKYLIGHT_SH_CLASSES] = SKYLIGHT_SH_LONGEST;
    int c, i, t, row = 0;
    for (c = 0; c < SKYLIGHT_SH_CLASSES; ++c) {
        const int last = row + longest[c] - 1;
        for (i = 0; i < SKYLIGHT_SH_WIDTH; ++i) {
            skylight_sh_lanes sum[SKYLIGHT_SH_GROUPS];
            skylight_sh_lanes number = skylight_sh_spread(last < row ? 0.0f : shared[last][i]);
#define SKYLIGHT_SH_LAST(g) \
    if ((g) < SKYLIGHT_SH_GROUPS) sum[g] = number;
#define SKYLIGHT_SH_STEP_DOWN(g) \
    if ((g) < SKYLIGHT_SH_GROUPS) sum[g] = skylight_sh_add(sum[g], u[g], number);
#define SKYLIGHT_SH_SUM(g) \
    if ((g) < SKYLIGHT_SH_GROUPS) sums[c][i][g] = sum[g];
            SKYLIGHT_SH_EACH(SKYLIGHT_SH_LAST)
            for (t = last - 1; t >= row; --t) {
                number = skylight_sh_spread(shared[t][i]);
                SKYLIGHT_SH_EACH(SKYLIGHT_SH_STEP_DOWN)
            }
            SKYLIGHT_SH_EACH(SKYLIGHT_SH_SUM)
#undef SKYLIGHT_SH_LAST
#undef SKYLIGHT_SH_STEP_DOWN
#undef SKYLIGHT_SH_SUM
        }
        row = last + 1;
    }
}

/* The weights of SKYLIGHT_SH_SUNS suns from `start` on, a row a weight, rows `step` apart; returns the
   largest status. `shared` are the sums over the other axes where all suns share them, or nothing. */
static inline int skylight_sh_evaluate_suns(const skylight_sh_real *rows,
                                            const float *const inputs[SKYLIGHT_SH_AXES],
                                            const float *azimuths, int start,
                                            float (*shared)[SKYLIGHT_SH_WIDTH], float *out,
                                            size_t step)
{
    static const short columns[SKYLIGHT_SH_BANDS] = SKYLIGHT_SH_COLUMNS;
    float given[SKYLIGHT_SH_AXES][SKYLIGHT_SH_SUNS], azimuth[SKYLIGHT_SH_SUNS];
    float light[SKYLIGHT_SH_SUNS], cosine[SKYLIGHT_SH_SUNS], sine[SKYLIGHT_SH_SUNS];
    skylight_sh_lanes u[SKYLIGHT_SH_GROUPS], others[SKYLIGHT_SH_GROUPS][SKYLIGHT_SH_OTHERS];
    skylight_sh_lanes factors[SKYLIGHT_SH_GROUPS][SKYLIGHT_SH_FACTORS];
    skylight_sh_lanes cosines[SKYLIGHT_SH_GROUPS][SKYLIGHT_SH_BANDS];
    skylight_sh_lanes sines[SKYLIGHT_SH_GROUPS][SKYLIGHT_SH_BANDS];
    skylight_sh_lanes sums[SKYLIGHT_SH_CLASSES][SKYLIGHT_SH_WIDTH][SKYLIGHT_SH_GROUPS];
    const int status = skylight_sh_inputs_suns(inputs, azimuths, start, given, azimuth, light);
    int g, i, k, l, m, channel;
    for (g = 0; g < SKYLIGHT_SH_GROUPS; ++g) {
        const int at = g * SKYLIGHT_SH_LANES;
        skylight_sh_lanes x[SKYLIGHT_SH_AXES], first[SKYLIGHT_SH_FIRST];
        skylight_sh_lanes radius = skylight_sh_spread(1);
        for (i = 0; i < SKYLIGHT_SH_AXES; ++i) x[i] = skylight_sh_load(given[i] + at);
        skylight_sh_circle_suns(azimuth + at, cosine + at, sine + at);
#if SKYLIGHT_SH_HAS_PARITY
        radius = skylight_sh_sine_suns(x);
#endif
        skylight_sh_waves_suns(skylight_sh_load(cosine + at), skylight_sh_load(sine + at), radius,
                               cosines[g], sines[g]);
        skylight_sh_first_suns(x, first);
        u[g] = first[1];
        skylight_sh_others_suns(x, others[g]);
        skylight_sh_factors_suns(x, factors[g]);
        for (i = 0; i < SKYLIGHT_SH_FACTORS; ++i) factors[g][i] *= skylight_sh_load(light + at);
    }
    if (shared)
        skylight_sh_sum_sharing(shared, u, sums);
    else
        skylight_sh_sum_suns(rows, u, others, sums);
    for (channel = 0; channel < SKYLIGHT_SH_CHANNELS; ++channel) {
        for (l = 0; l < SKYLIGHT_SH_BANDS; ++l) {
            float *const w = out + (size_t)(channel * SKYLIGHT_SH_WEIGHTS + l * (l + 1)) * step;
            for (m = 0; m <= l; ++m) {
                for (g = 0; g < SKYLIGHT_SH_GROUPS; ++g) {
                    skylight_sh_lanes v = skylight_sh_spread(0), turned;
                    if (columns[l] >= 0) {
#if SKYLIGHT_SH_IS_MIXED
                        for (k = 0; k < SKYLIGHT_SH_CLASSES; ++k)
                            v = skylight_sh_add(factors[g][SKYLIGHT_SH_FACTOR(channel, k)],
                                                sums[k][columns[l] + m][g], v);
#else
                        v = factors[g][0] * sums[channel][columns[l] + m][g];
#endif
                    }
                    turned = v * sines[g][m];
                    memcpy(w - (size_t)m * step + g * SKYLIGHT_SH_LANES, &turned, sizeof turned);
                    turned = v * cosines[g][m];
                    memcpy(w + (size_t)m * step + g * SKYLIGHT_SH_LANES, &turned, sizeof turned);
                }
            }
        }
    }
    (void)k;
    return status;
}

/* Four rows of four numbers to columns, `step` apart. */
static inline void skylight_sh_transpose(const float *from, size_t step, float *to, size_t between)
{
    const skylight_sh_four a = skylight_sh_load_four(from), b = skylight_sh_load_four(from + step);
    const skylight_sh_four c = skylight_sh_load_four(from + 2 * step);
    const skylight_sh_four d = skylight_sh_load_four(from + 3 * step);
    const skylight_sh_four ab = SKYLIGHT_SH_PICK(a, b, 0, 4, 1, 5);
    const skylight_sh_four cd = SKYLIGHT_SH_PICK(c, d, 0, 4, 1, 5);
    const skylight_sh_four ab_2 = SKYLIGHT_SH_PICK(a, b, 2, 6, 3, 7);
    const skylight_sh_four cd_2 = SKYLIGHT_SH_PICK(c, d, 2, 6, 3, 7);
    skylight_sh_keep(to, SKYLIGHT_SH_PICK(ab, cd, 0, 1, 4, 5));
    skylight_sh_keep(to + between, SKYLIGHT_SH_PICK(ab, cd, 2, 3, 6, 7));
    skylight_sh_keep(to + 2 * between, SKYLIGHT_SH_PICK(ab_2, cd_2, 0, 1, 4, 5));
    skylight_sh_keep(to + 3 * between, SKYLIGHT_SH_PICK(ab_2, cd_2, 2, 3, 6, 7));
}
#endif
#endif

/* Numbers of one sun's weights. */
#define SKYLIGHT_SH_NUMBERS (SKYLIGHT_SH_CHANNELS * SKYLIGHT_SH_WEIGHTS)

/* Evaluates `count` suns from arrays, one an axis, and one of azimuths (or none, where the table
   fixes it); returns the largest status. */
static inline int skylight_sh_evaluate_batch(
    const skylight_sh_real *rows, int count, const float *const inputs[SKYLIGHT_SH_AXES],
    const float *azimuths, float (*weights)[SKYLIGHT_SH_CHANNELS][SKYLIGHT_SH_WEIGHTS])
{
    int s = 0, status, worst = 0;
#if SKYLIGHT_SH_HAS_WIDE
#ifdef SKYLIGHT_SH_SUNS
    float shared[SKYLIGHT_SH_SHARED][SKYLIGHT_SH_WIDTH];
    const int share = count >= SKYLIGHT_SH_SUNS && skylight_sh_share(inputs, count);
    if (share) skylight_sh_sum_shared(rows, inputs, shared);
    for (; s + SKYLIGHT_SH_SUNS <= count; s += SKYLIGHT_SH_SUNS) {
        float out[SKYLIGHT_SH_NUMBERS * SKYLIGHT_SH_SUNS];
        int i, k;
        status = skylight_sh_evaluate_suns(rows, inputs, azimuths, s, share ? shared : 0, out,
                                           SKYLIGHT_SH_SUNS);
        worst = status > worst ? status : worst;
        /* In fours; the last may overlap those before. */
        for (i = 0; i < SKYLIGHT_SH_NUMBERS; i += 4) {
            const int at = i + 4 > SKYLIGHT_SH_NUMBERS ? SKYLIGHT_SH_NUMBERS - 4 : i;
            for (k = 0; k < SKYLIGHT_SH_SUNS; k += 4)
                skylight_sh_transpose(out + at * SKYLIGHT_SH_SUNS + k, SKYLIGHT_SH_SUNS,
                                      &weights[s + k][0][0] + at, SKYLIGHT_SH_NUMBERS);
        }
    }
#endif
#endif
    for (; s < count; ++s) {
        status = skylight_sh_evaluate_one(rows, inputs, azimuths, s, weights[s]);
        worst = status > worst ? status : worst;
    }
    return worst;
}

/* The same with the suns of each weight side by side: `weights` is [channels][weights][count]. */
static inline int skylight_sh_evaluate_columns(const skylight_sh_real *rows, int count,
                                               const float *const inputs[SKYLIGHT_SH_AXES],
                                               const float *azimuths, float *weights)
{
    const size_t step = count > 0 ? (size_t)count : 0;
    int s = 0, i, status, worst = 0;
#if SKYLIGHT_SH_HAS_WIDE
#ifdef SKYLIGHT_SH_SUNS
    float shared[SKYLIGHT_SH_SHARED][SKYLIGHT_SH_WIDTH];
    const int share = count >= SKYLIGHT_SH_SUNS && skylight_sh_share(inputs, count);
    if (share) skylight_sh_sum_shared(rows, inputs, shared);
#if SKYLIGHT_SH_LANES == 8
    /* Four times as many at once: rows far apart cost time for each visit, not for what is stored. */
    for (; s + 4 * SKYLIGHT_SH_SUNS <= count; s += 4 * SKYLIGHT_SH_SUNS) {
        float out[SKYLIGHT_SH_NUMBERS][4 * SKYLIGHT_SH_SUNS];
        for (i = 0; i < 4; ++i) {
            status = skylight_sh_evaluate_suns(rows, inputs, azimuths, s + i * SKYLIGHT_SH_SUNS,
                                               share ? shared : 0, out[0] + i * SKYLIGHT_SH_SUNS, 4 * SKYLIGHT_SH_SUNS);
            worst = status > worst ? status : worst;
        }
        for (i = 0; i < SKYLIGHT_SH_NUMBERS; ++i)
            memcpy(weights + (size_t)i * step + (size_t)s, out[i], sizeof out[i]);
    }
#endif
    for (; s + SKYLIGHT_SH_SUNS <= count; s += SKYLIGHT_SH_SUNS) {
        status = skylight_sh_evaluate_suns(rows, inputs, azimuths, s, share ? shared : 0, weights + s, step);
        worst = status > worst ? status : worst;
    }
#endif
#endif
    while (s < count) {
        /* Some at once, so that what is written lies together. */
        float some[16][SKYLIGHT_SH_CHANNELS][SKYLIGHT_SH_WEIGHTS];
        const int now = count - s < 16 ? count - s : 16;
        int k;
        for (k = 0; k < now; ++k) {
            status = skylight_sh_evaluate_one(rows, inputs, azimuths, s + k, some[k]);
            worst = status > worst ? status : worst;
        }
        for (i = 0; i < SKYLIGHT_SH_NUMBERS; ++i)
            for (k = 0; k < now; ++k)
                weights[(size_t)i * step + (size_t)(s + k)] =
                    some[k][i / SKYLIGHT_SH_WEIGHTS][i % SKYLIGHT_SH_WEIGHTS];
        s += now;
    }
    return worst;
}
