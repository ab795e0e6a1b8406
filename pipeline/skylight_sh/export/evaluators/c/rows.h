#pragma once
#include "turn.h"
#ifdef SKYLIGHT_SH_LANES

/* Vectors that the first `count` numbers of a row take, and those that are summed at once, in
   registers. */
#define SKYLIGHT_SH_VECTORS(count) (((count) + SKYLIGHT_SH_LANES - 1) / SKYLIGHT_SH_LANES)
#define SKYLIGHT_SH_BLOCKS ((SKYLIGHT_SH_VECTORS(SKYLIGHT_SH_WIDTH) + 6) / 7)
#define SKYLIGHT_SH_BLOCK \
    ((SKYLIGHT_SH_VECTORS(SKYLIGHT_SH_WIDTH) + SKYLIGHT_SH_BLOCKS - 1) / SKYLIGHT_SH_BLOCKS)
/* What is done for each vector of a block: written out, since a compiler that keeps loops keeps their
   vectors in memory. */
#define SKYLIGHT_SH_EACH(DO) DO(0) DO(1) DO(2) DO(3) DO(4) DO(5) DO(6) DO(7)
#endif
#if SKYLIGHT_SH_HAS_POWERS
#ifdef SKYLIGHT_SH_LANES
/* All columns at once, as written: gcc would sum one after the other, each step waiting for the one
   before. */
#if defined(__GNUC__) && !defined(__clang__) && defined(__SSE__)
#define SKYLIGHT_SH_IN_ORDER(v) __asm__("" : "+x"(v));
#else
#define SKYLIGHT_SH_IN_ORDER(v)
#endif

/* One class's sums, for SKYLIGHT_SH_BLOCK vectors of each row: over the products of the other axes'
   functions, each times a polynomial in powers of u, by Horner's scheme. */
SKYLIGHT_SH_INLINE void skylight_sh_sum_block(const skylight_sh_real *rows, int class_,
                                              skylight_sh_real u, const skylight_sh_real *others,
                                              skylight_sh_real *sums)
{
    const skylight_sh_lanes power = skylight_sh_spread(u);
    int i;
#define SKYLIGHT_SH_CLASS(which, polynomials) \
    if (class_ == (which)) { \
        skylight_sh_lanes total[SKYLIGHT_SH_BLOCK]; \
        polynomials SKYLIGHT_SH_EACH(SKYLIGHT_SH_SUM) \
    }
#define SKYLIGHT_SH_SUM(k) \
    if ((k) < SKYLIGHT_SH_BLOCK) memcpy(sums + (k) * SKYLIGHT_SH_LANES, &total[k], sizeof total[k]);
#define SKYLIGHT_SH_NOTHING SKYLIGHT_SH_EACH(SKYLIGHT_SH_ZERO)
#define SKYLIGHT_SH_ZERO(k) \
    if ((k) < SKYLIGHT_SH_BLOCK) total[k] = skylight_sh_spread(0);
#define SKYLIGHT_SH_POLYNOMIAL(start, count, other) \
    { \
        const skylight_sh_real *term = rows + ((start) + (count) - 1) * SKYLIGHT_SH_WIDTH; \
        const skylight_sh_lanes factor = skylight_sh_spread(others[other]); \
        skylight_sh_lanes sum[SKYLIGHT_SH_BLOCK]; \
        SKYLIGHT_SH_EACH(SKYLIGHT_SH_LAST) \
        for (i = 1; i < (count); ++i) { \
            term -= SKYLIGHT_SH_WIDTH; \
            SKYLIGHT_SH_EACH(SKYLIGHT_SH_STEP_DOWN) \
        } \
        SKYLIGHT_SH_EACH(SKYLIGHT_SH_TOTAL) \
    }
#define SKYLIGHT_SH_LAST(k) \
    if ((k) < SKYLIGHT_SH_BLOCK) sum[k] = skylight_sh_load(term + (k) * SKYLIGHT_SH_LANES);
#define SKYLIGHT_SH_STEP_DOWN(k) \
    if ((k) < SKYLIGHT_SH_BLOCK) { \
        skylight_sh_lanes v = skylight_sh_load(term + (k) * SKYLIGHT_SH_LANES); \
        v = skylight_sh_add(sum[k], power, v); \
        SKYLIGHT_SH_IN_ORDER(v) \
        sum[k] = v; \
    }
#define SKYLIGHT_SH_TOTAL(k) \
    if ((k) < SKYLIGHT_SH_BLOCK) total[k] = skylight_sh_add(sum[k], factor, total[k]);
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

/* One class's sums, for one vector of each row. */
static inline void skylight_sh_sum_vector(const skylight_sh_real *row, const unsigned char *lengths,
                                          skylight_sh_real u, const skylight_sh_real *others,
                                          skylight_sh_real *sums)
{
    const skylight_sh_lanes power = skylight_sh_spread(u);
    skylight_sh_lanes total = skylight_sh_spread(0);
    int other;
    for (other = 0; other < SKYLIGHT_SH_OTHERS; ++other) {
        const int length = lengths[other];
        const skylight_sh_real *term = row + (length - 1) * SKYLIGHT_SH_WIDTH;
        skylight_sh_lanes sum;
        if (!length) continue;
        sum = skylight_sh_load(term);
        while (term != row) {
            term -= SKYLIGHT_SH_WIDTH;
            sum = skylight_sh_add(sum, power, skylight_sh_load(term));
        }
        total = skylight_sh_add(sum, skylight_sh_spread(others[other]), total);
        row += length * SKYLIGHT_SH_WIDTH;
    }
    memcpy(sums, &total, sizeof total);
}
#else

/* One class's sums, with plain numbers. */
static inline void skylight_sh_sum(const skylight_sh_real *row, const unsigned char *lengths,
                                   skylight_sh_real u, const skylight_sh_real *others, int count,
                                   skylight_sh_real *sums)
{
    int other, i, k;
    for (k = 0; k < SKYLIGHT_SH_ROOM; ++k) sums[k] = 0;
    for (other = 0; other < SKYLIGHT_SH_OTHERS; ++other) {
        skylight_sh_real product = others[other];
        for (i = 0; i < (int)lengths[other]; ++i) {
            for (k = 0; k < count; ++k) sums[k] += product * row[k];
            product *= u;
            row += SKYLIGHT_SH_WIDTH;
        }
    }
}
#endif

/* The sums of one class's rows, one a term, for the first `bands` bands. */
SKYLIGHT_SH_INLINE void skylight_sh_sum_class(const skylight_sh_real *rows, int class_,
                                              const skylight_sh_real *first,
                                              const skylight_sh_real *others, int bands,
                                              skylight_sh_real *sums)
{
    static const unsigned short starts[SKYLIGHT_SH_CLASSES] = SKYLIGHT_SH_STARTS;
    static const unsigned char lengths[SKYLIGHT_SH_CLASSES][SKYLIGHT_SH_OTHERS] = SKYLIGHT_SH_LENGTHS;
    static const unsigned short widths[SKYLIGHT_SH_BANDS] = SKYLIGHT_SH_WIDTHS;
    const skylight_sh_real *const row = rows + (int)starts[class_] * SKYLIGHT_SH_WIDTH;
#ifdef SKYLIGHT_SH_LANES
    int i;
    if (bands == SKYLIGHT_SH_BANDS) {
        for (i = 0; i < SKYLIGHT_SH_BLOCKS; ++i) {
            /* The last block may overlap the one before. */
            const int at = i + 1 < SKYLIGHT_SH_BLOCKS
                               ? i * SKYLIGHT_SH_BLOCK
                               : SKYLIGHT_SH_VECTORS(SKYLIGHT_SH_WIDTH) - SKYLIGHT_SH_BLOCK;
            skylight_sh_sum_block(rows + at * SKYLIGHT_SH_LANES, class_, first[1], others,
                                  sums + at * SKYLIGHT_SH_LANES);
        }
        return;
    }
    memset(sums, 0, sizeof *sums * SKYLIGHT_SH_ROOM);
    for (i = 0; i < SKYLIGHT_SH_VECTORS(widths[bands - 1]); ++i)
        skylight_sh_sum_vector(row + i * SKYLIGHT_SH_LANES, lengths[class_], first[1], others,
                               sums + i * SKYLIGHT_SH_LANES);
#else
    skylight_sh_sum(row, lengths[class_], first[1], others, widths[bands - 1], sums);
#endif
}
#else

/* The products of the functions of all axes, of one class in the order of its rows. */
static inline void skylight_sh_multiply(int class_, const skylight_sh_real *first,
                                        const skylight_sh_real *others, skylight_sh_real *products)
{
    int i;
#ifdef SKYLIGHT_SH_LANES
    /* In fours: each overshoot is overwritten by the next line. */
#define SKYLIGHT_SH_PRODUCT(which, place, count, other) \
    for (i = 0; i < (count) && class_ == (which); i += 4) \
        skylight_sh_keep(products + (place) + i, \
                         skylight_sh_load_four(first + i) * others[other]);
#else
#define SKYLIGHT_SH_PRODUCT(which, place, count, other) \
    for (i = 0; i < (count) && class_ == (which); ++i) products[(place) + i] = first[i] * others[other];
#endif
    SKYLIGHT_SH_PRODUCTS(SKYLIGHT_SH_PRODUCT)
#undef SKYLIGHT_SH_PRODUCT
}
#ifdef SKYLIGHT_SH_LANES

/* Rows whose sums run side by side, so that no sum waits for the one before. */
#define SKYLIGHT_SH_SIDE (SKYLIGHT_SH_BLOCK > 4 ? 1 : SKYLIGHT_SH_BLOCK > 2 ? 2 : 4)

/* sums = sum over t of products[t] * row t: SKYLIGHT_SH_BLOCK vectors of each row, which stay in
   registers. */
static inline void skylight_sh_sum_block(const skylight_sh_real *row, int terms,
                                         const skylight_sh_real *products, skylight_sh_real *sums)
{
    skylight_sh_lanes total[8];
    int t;
#define SKYLIGHT_SH_ZERO(k) total[k] = skylight_sh_spread(0);
    /* Vector k of so many rows side by side. */
#define SKYLIGHT_SH_ROWS(k) \
    if ((k) / SKYLIGHT_SH_BLOCK < SKYLIGHT_SH_SIDE) \
        total[k] = skylight_sh_add( \
            skylight_sh_spread(products[t + (k) / SKYLIGHT_SH_BLOCK]), \
            skylight_sh_load(row + (k) / SKYLIGHT_SH_BLOCK * SKYLIGHT_SH_WIDTH + \
                             (k) % SKYLIGHT_SH_BLOCK * SKYLIGHT_SH_LANES), \
            total[k]);
#define SKYLIGHT_SH_ROW(k) \
    if ((k) < SKYLIGHT_SH_BLOCK) \
        total[k] = skylight_sh_add(skylight_sh_spread(products[t]), \
                                   skylight_sh_load(row + (k) * SKYLIGHT_SH_LANES), total[k]);
#define SKYLIGHT_SH_SIDES(k) \
    if ((k) >= SKYLIGHT_SH_BLOCK) total[(k) % SKYLIGHT_SH_BLOCK] += total[k];
#define SKYLIGHT_SH_SUM(k) \
    if ((k) < SKYLIGHT_SH_BLOCK) memcpy(sums + (k) * SKYLIGHT_SH_LANES, &total[k], sizeof total[k]);
    SKYLIGHT_SH_EACH(SKYLIGHT_SH_ZERO)
    for (t = 0; t + SKYLIGHT_SH_SIDE <= terms; t += SKYLIGHT_SH_SIDE) {
        SKYLIGHT_SH_EACH(SKYLIGHT_SH_ROWS)
        row += SKYLIGHT_SH_SIDE * SKYLIGHT_SH_WIDTH;
    }
    for (; t < terms; ++t) {
        SKYLIGHT_SH_EACH(SKYLIGHT_SH_ROW)
        row += SKYLIGHT_SH_WIDTH;
    }
    SKYLIGHT_SH_EACH(SKYLIGHT_SH_SIDES)
    SKYLIGHT_SH_EACH(SKYLIGHT_SH_SUM)
#undef SKYLIGHT_SH_ZERO
#undef SKYLIGHT_SH_ROWS
#undef SKYLIGHT_SH_ROW
#undef SKYLIGHT_SH_SIDES
#undef SKYLIGHT_SH_SUM
}

/* The same for one vector of each row. */
static inline void skylight_sh_sum_vector(const skylight_sh_real *row, int terms,
                                          const skylight_sh_real *products, skylight_sh_real *sums)
{
    skylight_sh_lanes total = skylight_sh_spread(0), other = skylight_sh_spread(0);
    int t;
    for (t = 0; t + 2 <= terms; t += 2) {
        total = skylight_sh_add(skylight_sh_spread(products[t]), skylight_sh_load(row), total);
        other = skylight_sh_add(skylight_sh_spread(products[t + 1]),
                                skylight_sh_load(row + SKYLIGHT_SH_WIDTH), other);
        row += 2 * SKYLIGHT_SH_WIDTH;
    }
    if (t < terms)
        total = skylight_sh_add(skylight_sh_spread(products[t]), skylight_sh_load(row), total);
    total += other;
    memcpy(sums, &total, sizeof total);
}

/* The first `count` numbers of the sum over t of products[t] * row t. */
static inline void skylight_sh_sum(const skylight_sh_real *row, int terms,
                                   const skylight_sh_real *products, int count,
                                   skylight_sh_real *sums)
{
    const int vectors = SKYLIGHT_SH_VECTORS(count);
    int k = 0;
    if (vectors >= SKYLIGHT_SH_BLOCK) {
        for (; k + SKYLIGHT_SH_BLOCK <= vectors; k += SKYLIGHT_SH_BLOCK)
            skylight_sh_sum_block(row + k * SKYLIGHT_SH_LANES, terms, products,
                                  sums + k * SKYLIGHT_SH_LANES);
    }
    for (; k < vectors; ++k)
        skylight_sh_sum_vector(row + k * SKYLIGHT_SH_LANES, terms, products,
                               sums + k * SKYLIGHT_SH_LANES);
}
#else

/* The first `count` numbers of the sum over t of products[t] * row t, four rows a pass: no
   reduction, so that it vectorises. */
static inline void skylight_sh_sum(const skylight_sh_real *row, int terms,
                                   const skylight_sh_real *products, int count,
                                   skylight_sh_real *sums)
{
    int t, k;
    for (k = 0; k < SKYLIGHT_SH_ROOM; ++k) sums[k] = 0;
    for (t = 0; t + 4 <= terms; t += 4) {
        const skylight_sh_real a = products[t], b = products[t + 1];
        const skylight_sh_real c = products[t + 2], d = products[t + 3];
        for (k = 0; k < count; ++k)
            sums[k] += (a * row[k] + b * row[k + SKYLIGHT_SH_WIDTH]) +
                       (c * row[k + 2 * SKYLIGHT_SH_WIDTH] + d * row[k + 3 * SKYLIGHT_SH_WIDTH]);
        row += 4 * SKYLIGHT_SH_WIDTH;
    }
    for (; t < terms; ++t) {
        for (k = 0; k < count; ++k) sums[k] += products[t] * row[k];
        row += SKYLIGHT_SH_WIDTH;
    }
}
#endif

/* The sums of one class's rows, one a term, for the first `bands` bands. */
static inline void skylight_sh_sum_class(const skylight_sh_real *rows, int class_,
                                         const skylight_sh_real *first,
                                         const skylight_sh_real *others, int bands,
                                         skylight_sh_real *sums)
{
    static const unsigned short starts[SKYLIGHT_SH_CLASSES] = SKYLIGHT_SH_STARTS;
    static const unsigned short counts[SKYLIGHT_SH_CLASSES] = SKYLIGHT_SH_COUNTS;
    static const unsigned short places[SKYLIGHT_SH_CLASSES] = SKYLIGHT_SH_PLACES;
    static const unsigned short widths[SKYLIGHT_SH_BANDS] = SKYLIGHT_SH_WIDTHS;
    const skylight_sh_real *const row = rows + (int)starts[class_] * SKYLIGHT_SH_WIDTH;
    skylight_sh_real products[SKYLIGHT_SH_PRODUCTS_ROOM];
    skylight_sh_multiply(class_, first, others, products);
    if (bands == SKYLIGHT_SH_BANDS) {
        skylight_sh_sum(row, counts[class_], products + places[class_], SKYLIGHT_SH_WIDTH, sums);
    } else {
        memset(sums, 0, sizeof *sums * SKYLIGHT_SH_ROOM);
        skylight_sh_sum(row, counts[class_], products + places[class_], widths[bands - 1], sums);
    }
}
#endif

/* The same in double precision, all bands: what derivatives need, whose terms cancel. */
static inline void skylight_sh_sum_rows_double(
    const skylight_sh_real *rows, const double *first, const double *others,
    double sums[SKYLIGHT_SH_CLASSES][SKYLIGHT_SH_WIDTH])
{
    static const unsigned char lengths[SKYLIGHT_SH_CLASSES][SKYLIGHT_SH_OTHERS] = SKYLIGHT_SH_LENGTHS;
    int c, i, k, other;
    for (c = 0; c < SKYLIGHT_SH_CLASSES; ++c) {
        for (k = 0; k < SKYLIGHT_SH_WIDTH; ++k) sums[c][k] = 0.0;
        for (other = 0; other < SKYLIGHT_SH_OTHERS; ++other) {
            for (i = 0; i < (int)lengths[c][other]; ++i) {
                const double product = first[i] * others[other];
                for (k = 0; k < SKYLIGHT_SH_WIDTH; ++k) sums[c][k] += product * (double)rows[k];
                rows += SKYLIGHT_SH_WIDTH;
            }
        }
    }
}
