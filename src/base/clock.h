/* Time that only goes forward. */
#ifndef BASE_CLOCK_H
#define BASE_CLOCK_H

#include <time.h>

static inline double clock_read(clockid_t clock)
{
    struct timespec time;
    clock_gettime(clock, &time);
    return (double)time.tv_sec + (double)time.tv_nsec * 1e-9;
}

/* Seconds since some moment. */
static inline double clock_seconds(void)
{
    return clock_read(CLOCK_MONOTONIC);
}

/* Seconds that all threads of this process have worked. */
static inline double clock_worked(void)
{
    return clock_read(CLOCK_PROCESS_CPUTIME_ID);
}

/* Seconds that the calling thread has worked. */
static inline double clock_worked_here(void)
{
    return clock_read(CLOCK_THREAD_CPUTIME_ID);
}

#endif
