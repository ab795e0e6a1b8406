#pragma once
#include "rows.h"

/* Reads the stream: whole numbers as Rice codes, low bit of each byte first. */
typedef struct {
    const unsigned char *next;
    uint64_t held;
    int count;
} skylight_sh_bits;

/* Holds at least 56 bits, at most 63, so that there is a zero above them; past the stream's end there
   are zeros. What stands above `count` bits is the stream's too, and is read again. */
SKYLIGHT_SH_INLINE void skylight_sh_fill(skylight_sh_bits *b)
{
    const unsigned char *const end = skylight_sh_stream + sizeof skylight_sh_stream;
    const unsigned char *const p = b->next;
    if (end - p >= 8) {
        /* One load, whatever the order of a machine's bytes. */
        const uint64_t word = (uint64_t)p[0] | (uint64_t)p[1] << 8 | (uint64_t)p[2] << 16 |
                              (uint64_t)p[3] << 24 | (uint64_t)p[4] << 32 | (uint64_t)p[5] << 40 |
                              (uint64_t)p[6] << 48 | (uint64_t)p[7] << 56;
        b->held = (b->held | word << b->count) & (UINT64_MAX >> 1);
        b->next += (63 - b->count) >> 3;
        b->count |= 56;
    } else {
        for (; b->count < 56; b->count += 8)
            if (b->next < end) b->held |= (uint64_t)*b->next++ << b->count;
    }
}

/* `width` bits, at most 31, as a number. */
static inline unsigned skylight_sh_fixed(skylight_sh_bits *b, int width)
{
    unsigned value;
    if (b->count < 32) skylight_sh_fill(b);
    value = (unsigned)(b->held & ((UINT64_C(1) << width) - 1));
    b->held >>= width;
    b->count -= width;
    return value;
}

/* How many ones stand before the first zero, from the low end; what is held has a zero. */
static inline int skylight_sh_ones(uint64_t held)
{
#ifdef __GNUC__
    return __builtin_ctzll(~(unsigned long long)held);
#else
    int ones = 0;
    for (; held & 1; held >>= 1) ++ones;
    return ones;
#endif
}

/* The bits after a Rice code that is longer than what is held, and its number, folded. */
static inline skylight_sh_bits skylight_sh_long(skylight_sh_bits b, int low, unsigned *folded)
{
    unsigned high = 0;
    int ones;
    while ((ones = skylight_sh_ones(b.held)) >= b.count) {
        high += (unsigned)b.count;
        b.held = 0;
        b.count = 0;
        skylight_sh_fill(&b);
    }
    high += (unsigned)ones;
    b.held = b.held >> ones >> 1;
    b.count -= ones + 1;
    *folded = (high << low) | skylight_sh_fixed(&b, low);
    return b;
}

/* A Rice code of `low` low bits: ones, a zero, the low bits; then folded back: 0, 1, 2, 3 -> 0, -1,
   1, -2. */
SKYLIGHT_SH_INLINE int skylight_sh_rice(skylight_sh_bits *b, int low)
{
    unsigned folded;
    int ones, size;
    if (b->count < 32) skylight_sh_fill(b);
    ones = skylight_sh_ones(b->held);
    size = ones + 1 + low;
    if (size <= b->count) {
        /* All of it is held: what follows waits for one shift. */
        const uint64_t rest = b->held >> ones >> 1;
        folded = ((unsigned)ones << low) | (unsigned)(rest & ((UINT64_C(1) << low) - 1));
        b->held >>= size;
        b->count -= size;
    } else {
        unsigned found;
        *b = skylight_sh_long(*b, low, &found);
        folded = found;
    }
    return (int)(folded >> 1) ^ -(int)(folded & 1);
}

/* The stream from its start. */
static inline skylight_sh_bits skylight_sh_open(void)
{
    skylight_sh_bits b;
    b.next = skylight_sh_stream;
    b.held = 0;
    b.count = 0;
    return b;
}

/* The next band's profile: twice the low bits that its numbers have, by their place in a run. */
static inline void skylight_sh_next_profile(skylight_sh_bits *b, int profile[32])
{
    const int used = (int)skylight_sh_fixed(b, 5);
    int i;
    for (i = 0; i < used; ++i) profile[i] = (int)skylight_sh_fixed(b, 5);
}

/* The length of the next run, by that of the same class and product at the weight before. */
SKYLIGHT_SH_INLINE int skylight_sh_next_length(skylight_sh_bits *b, signed char *length)
{
    const int found = *length + skylight_sh_rice(b, 0);
    *length = (signed char)found;
    return found;
}

/* The next number, of `size` half low bits. */
SKYLIGHT_SH_INLINE int skylight_sh_next_number(skylight_sh_bits *b, int size)
{
    return skylight_sh_rice(b, size > 0 ? size >> 1 : 0);
}

static const signed char skylight_sh_run_profile[SKYLIGHT_SH_RUNS] = SKYLIGHT_SH_RUN_PROFILE;
static const signed char skylight_sh_class_profile[SKYLIGHT_SH_CLASSES] = SKYLIGHT_SH_CLASS_PROFILE;

/* Reads the stream once, forward: the sums of the first `bands` bands. */
static inline void skylight_sh_sum_stream(
    const skylight_sh_real *first, const skylight_sh_real *others, int bands,
    skylight_sh_real sums[SKYLIGHT_SH_CLASSES][SKYLIGHT_SH_ROOM])
{
    signed char lengths[SKYLIGHT_SH_CLASSES][SKYLIGHT_SH_RUNS];
    int profile[32], i, l, m, c, other, column = 0;
    skylight_sh_bits bits = skylight_sh_open();
    memset(lengths, 0, sizeof lengths);
    memset(profile, 0, sizeof profile);
    memset(sums, 0, sizeof(skylight_sh_real) * SKYLIGHT_SH_CLASSES * SKYLIGHT_SH_ROOM);
    for (l = 0; l < bands; ++l) {
        skylight_sh_next_profile(&bits, profile);
        for (m = SKYLIGHT_SH_FIRST_ORDER(l); m <= l; ++m, ++column) {
            for (c = 0; c < SKYLIGHT_SH_CLASSES; ++c) {
                skylight_sh_real value = 0;
                for (other = 0; other < SKYLIGHT_SH_RUNS; ++other) {
                    const int level = skylight_sh_run_profile[other] + skylight_sh_class_profile[c];
                    const int length = skylight_sh_next_length(&bits, &lengths[c][other]);
                    skylight_sh_real sum = 0;
                    for (i = 0; i < length; ++i) {
                        const int number = skylight_sh_next_number(&bits, profile[i] + level);
                        sum += first[i] * (skylight_sh_real)number;
                    }
                    value += sum * others[other];
                }
                sums[c][column] = value * SKYLIGHT_SH_STEP;
            }
        }
    }
}

/* Reads the stream once, forward, into rows: of each class one for each product of functions. */
static inline void skylight_sh_unpack_rows(float *rows)
{
    static const unsigned char sizes[SKYLIGHT_SH_CLASSES][SKYLIGHT_SH_OTHERS] = SKYLIGHT_SH_LENGTHS;
    unsigned short starts[SKYLIGHT_SH_CLASSES][SKYLIGHT_SH_RUNS];
    signed char lengths[SKYLIGHT_SH_CLASSES][SKYLIGHT_SH_RUNS];
    int profile[32], i, l, m, c, other, column = 0, row = 0;
    skylight_sh_bits bits = skylight_sh_open();
    memset(lengths, 0, sizeof lengths);
    memset(profile, 0, sizeof profile);
    for (c = 0; c < SKYLIGHT_SH_CLASSES; ++c) {
        for (other = 0; other < SKYLIGHT_SH_OTHERS; ++other) {
            if (other < SKYLIGHT_SH_RUNS) starts[c][other] = (unsigned short)row;
            row += sizes[c][other];
        }
    }
    for (i = 0; i < SKYLIGHT_SH_UNPACKED; ++i) rows[i] = 0.0f;
    for (l = 0; l < SKYLIGHT_SH_BANDS; ++l) {
        skylight_sh_next_profile(&bits, profile);
        for (m = SKYLIGHT_SH_FIRST_ORDER(l); m <= l; ++m, ++column) {
            for (c = 0; c < SKYLIGHT_SH_CLASSES; ++c) {
                for (other = 0; other < SKYLIGHT_SH_RUNS; ++other) {
                    const int level = skylight_sh_run_profile[other] + skylight_sh_class_profile[c];
                    const int length = skylight_sh_next_length(&bits, &lengths[c][other]);
                    float *to = rows + (int)starts[c][other] * SKYLIGHT_SH_WIDTH + column;
                    for (i = 0; i < length; ++i) {
                        const int number = skylight_sh_next_number(&bits, profile[i] + level);
                        *to = (float)number * SKYLIGHT_SH_STEP;
                        to += SKYLIGHT_SH_WIDTH;
                    }
                }
            }
        }
    }
}

/* The sums in double precision, all bands: what derivatives need, whose terms cancel. */
static inline void skylight_sh_sum_stream_double(
    const double *first, const double *others, double sums[SKYLIGHT_SH_CLASSES][SKYLIGHT_SH_WIDTH])
{
    signed char lengths[SKYLIGHT_SH_CLASSES][SKYLIGHT_SH_RUNS];
    int profile[32], i, l, m, c, other, column = 0;
    skylight_sh_bits bits = skylight_sh_open();
    memset(lengths, 0, sizeof lengths);
    memset(profile, 0, sizeof profile);
    for (l = 0; l < SKYLIGHT_SH_BANDS; ++l) {
        skylight_sh_next_profile(&bits, profile);
        for (m = SKYLIGHT_SH_FIRST_ORDER(l); m <= l; ++m, ++column) {
            for (c = 0; c < SKYLIGHT_SH_CLASSES; ++c) {
                double value = 0.0;
                for (other = 0; other < SKYLIGHT_SH_RUNS; ++other) {
                    const int level = skylight_sh_run_profile[other] + skylight_sh_class_profile[c];
                    const int length = skylight_sh_next_length(&bits, &lengths[c][other]);
                    double sum = 0.0;
                    for (i = 0; i < length; ++i) {
                        const int number = skylight_sh_next_number(&bits, profile[i] + level);
                        sum += first[i] * (double)number;
                    }
                    value += sum * others[other];
                }
                sums[c][column] = value * (double)SKYLIGHT_SH_STEP;
            }
        }
    }
}
