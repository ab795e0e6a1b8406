/* Times entrants in rounds that take turns: a slice of many calls with a warm cache, or one call with a cold one.
 * Prints a line a slice: round, entrant, calls, CPU and wall seconds; entrant -1 is a fixed loop of arithmetic. What
 * reading the CPU clock takes by itself is not in a cold call. */
#if !defined(_POSIX_C_SOURCE) && !defined(__APPLE__)
#define _POSIX_C_SOURCE 200809L
#endif
#include <stdio.h>
#include <stdlib.h>
#include <time.h>

#define PREPARE(number) void prepare_##number(void);
#define CALL(number) void call_##number(int first, int calls);
#include "entrants.h"
#undef PREPARE
#undef CALL

static void prepare_all(void)
{
#define PREPARE(number) prepare_##number();
#define CALL(number)
#include "entrants.h"
#undef PREPARE
#undef CALL
}

static void (*const call_of[])(int first, int calls) = {
#define PREPARE(number)
#define CALL(number) call_##number,
#include "entrants.h"
#undef PREPARE
#undef CALL
};
#define ENTRANTS ((int)(sizeof call_of / sizeof *call_of))
#define FLUSHED ((size_t)64 << 20)
#define MOST_CALLS (1 << 24)

static double wall(void)
{
    struct timespec t;
    timespec_get(&t, TIME_UTC);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

/* Seconds that this thread has had a processor, where the system tells. */
static double cpu(void)
{
#ifdef CLOCK_THREAD_CPUTIME_ID
    struct timespec t;
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
#else
    return wall();
#endif
}

static void tick(void)
{
    static volatile float kept;
    float x = kept;
    int i;
    for (i = 0; i < 50000; ++i) x = x * 0.999f + 1.0f;
    kept = x;
}

static void slice(int round, int entrant, int calls)
{
    const double wall_start = wall(), start = cpu();
    double end;
    if (entrant < 0) tick();
    else call_of[entrant](round, calls);
    end = cpu();
    printf("%d %d %d %.9g %.9g\n", round, entrant, calls, end - start, wall() - wall_start);
}

/* How many calls take `seconds`. */
static int calls_in(int entrant, double seconds)
{
    int calls = 1;
    for (;;) {
        const double start = cpu();
        double took;
        call_of[entrant](0, calls);
        took = cpu() - start;
        if (took > 0.25 * seconds || calls >= MOST_CALLS) {
            const double fitting = seconds / took * (double)calls;
            return fitting < 1.0 ? 1 : fitting < (double)MOST_CALLS ? (int)fitting : MOST_CALLS;
        }
        calls *= 2;
    }
}

static void warm_rounds(int rounds, double seconds)
{
    static int calls[sizeof call_of / sizeof *call_of];
    int round, turn;
    for (turn = 0; turn < ENTRANTS; ++turn) calls[turn] = calls_in(turn, seconds);
    for (round = 0; round < rounds; ++round) {
        slice(round, -1, 1);
        for (turn = 0; turn < ENTRANTS; ++turn) {
            const int entrant = (round + turn) % ENTRANTS;
            /* What the others have driven out of the caches comes back first. */
            call_of[entrant](round, 1 + calls[entrant] / 8);
            slice(round, entrant, calls[entrant]);
        }
    }
}

static void cold_rounds(int rounds)
{
    unsigned char *const other = calloc(FLUSHED, 1);
    int round, turn;
    size_t i;
    if (!other) exit(1);
    for (round = 0; round < rounds; ++round) {
        slice(round, -1, 1);
        for (turn = 0; turn < ENTRANTS; ++turn) {
            const int entrant = (round + turn) % ENTRANTS;
            double start, end, wall_start, reading = 1.0;
            for (i = 0; i < FLUSHED; i += 64) other[i] = (unsigned char)(other[i] + 1);
            for (i = 0; i < 4; ++i) {
                start = cpu();
                end = cpu();
                if (end - start < reading) reading = end - start;
            }
            wall_start = wall();
            start = cpu();
            call_of[entrant](round, 1);
            end = cpu();
            printf("%d %d 1 %.9g %.9g\n", round, entrant, end - start - reading, wall() - wall_start - reading);
        }
    }
    free(other);
}

int main(int count, char **arguments)
{
    if (count != 4) return 2;
    prepare_all();
    warm_rounds(atoi(arguments[1]), 1e-6 * atoi(arguments[2]));
    printf("\n");
    cold_rounds(atoi(arguments[3]));
    return 0;
}
