#pragma once
#include "turn.h"

/* Reads the stream: whole numbers as Rice codes, low bit of each byte first. */
typedef struct {
    const unsigned char *next;
    uint64_t held;
    int count;
} skylight_sh_bits;

static inline void skylight_sh_fill(skylight_sh_bits *b)
{
    const unsigned char *const end = skylight_sh_stream + sizeof skylight_sh_stream;
    while (b->count <= 56 && b->next < end) {
        b->held |= (uint64_t)*b->next++ << b->count;
        b->count += 8;
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

/* A Rice code of `low` low bits: ones, a zero, the low bits; then folded back: 0, 1, 2, 3 -> 0, -1,
   1, -2. */
static inline int skylight_sh_rice(skylight_sh_bits *b, int low)
{
    unsigned high = 0, folded;
    if (b->count < 32) skylight_sh_fill(b);
    while (b->held & 1) {
        ++high;
        b->held >>= 1;
        if (--b->count < 1) skylight_sh_fill(b);
    }
    b->held >>= 1;
    --b->count;
    folded = (high << low) | skylight_sh_fixed(b, low);
    return folded & 1 ? -(int)(folded >> 1) - 1 : (int)(folded >> 1);
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

/* The length of the next run, by that of the same channel and product at the weight before. */
static inline int skylight_sh_next_length(skylight_sh_bits *b, signed char *length)
{
    const int found = *length + skylight_sh_rice(b, 0);
    *length = (signed char)found;
    return found;
}

/* The next number, of `size` half low bits. */
static inline int skylight_sh_next_number(skylight_sh_bits *b, int size)
{
    return skylight_sh_rice(b, size > 0 ? size >> 1 : 0);
}

static const signed char skylight_sh_run_profile[SKYLIGHT_SH_RUNS] = SKYLIGHT_SH_RUN_PROFILE;
static const signed char skylight_sh_channel_profile[SKYLIGHT_SH_CHANNELS] =
    SKYLIGHT_SH_CHANNEL_PROFILE;

/* Reads the stream once, forward, and stores the first `bands` bands. */
static inline void skylight_sh_combine(const skylight_sh_real *first,
                                       const skylight_sh_real *others,
                                       const skylight_sh_real *cosines,
                                       const skylight_sh_real *sines, int bands,
                                       float weights[SKYLIGHT_SH_CHANNELS][SKYLIGHT_SH_WEIGHTS])
{
    signed char lengths[SKYLIGHT_SH_CHANNELS][SKYLIGHT_SH_RUNS];
    int profile[32], i, l, m, channel, other;
    skylight_sh_bits bits = skylight_sh_open();
    memset(lengths, 0, sizeof lengths);
    memset(profile, 0, sizeof profile);
    for (l = 0; l < bands; ++l) {
        skylight_sh_next_profile(&bits, profile);
        for (m = SKYLIGHT_SH_FIRST_ORDER(l); m <= l; ++m) {
            for (channel = 0; channel < SKYLIGHT_SH_CHANNELS; ++channel) {
                skylight_sh_real value = 0;
                for (other = 0; other < SKYLIGHT_SH_RUNS; ++other) {
                    const int level = skylight_sh_run_profile[other] +
                                      skylight_sh_channel_profile[channel];
                    const int length = skylight_sh_next_length(&bits, &lengths[channel][other]);
                    skylight_sh_real sum = 0;
                    for (i = 0; i < length; ++i) {
                        const int number = skylight_sh_next_number(&bits, profile[i] + level);
                        sum += first[i] * (skylight_sh_real)number;
                    }
                    value += sum * others[other];
                }
                skylight_sh_place(value * SKYLIGHT_SH_STEP, l, m, cosines, sines,
                                  weights[channel]);
            }
        }
    }
}

/* The same in double precision, all bands: what derivatives need, whose terms cancel. */
static inline void skylight_sh_combine_double(
    const double *first, const double *others, const skylight_sh_real *cosines,
    const skylight_sh_real *sines, float weights[SKYLIGHT_SH_CHANNELS][SKYLIGHT_SH_WEIGHTS])
{
    signed char lengths[SKYLIGHT_SH_CHANNELS][SKYLIGHT_SH_RUNS];
    int profile[32], i, l, m, channel, other;
    skylight_sh_bits bits = skylight_sh_open();
    memset(lengths, 0, sizeof lengths);
    memset(profile, 0, sizeof profile);
    for (l = 0; l < SKYLIGHT_SH_BANDS; ++l) {
        skylight_sh_next_profile(&bits, profile);
        for (m = SKYLIGHT_SH_FIRST_ORDER(l); m <= l; ++m) {
            for (channel = 0; channel < SKYLIGHT_SH_CHANNELS; ++channel) {
                double value = 0.0;
                for (other = 0; other < SKYLIGHT_SH_RUNS; ++other) {
                    const int level = skylight_sh_run_profile[other] +
                                      skylight_sh_channel_profile[channel];
                    const int length = skylight_sh_next_length(&bits, &lengths[channel][other]);
                    double sum = 0.0;
                    for (i = 0; i < length; ++i) {
                        const int number = skylight_sh_next_number(&bits, profile[i] + level);
                        sum += first[i] * (double)number;
                    }
                    value += sum * others[other];
                }
                skylight_sh_place((skylight_sh_real)(value * (double)SKYLIGHT_SH_STEP), l, m,
                                  cosines, sines, weights[channel]);
            }
        }
    }
}
