/* Work on all cores: one atomic counter hands out items 0..count-1. Results
 * must depend on the item alone, never on the thread that did it. */
#ifndef BASE_PARALLEL_H
#define BASE_PARALLEL_H

#include <stdatomic.h>
#include <stdbool.h>
#include <stddef.h>

enum {
    PARALLEL_STACK =
        16 << 20, /* bytes of stack, of every thread started here */
};

/* Called with the item and the number of the thread, 0..threads-1. */
typedef void parallel_task(void *context, size_t item, unsigned thread);

/* Runs task for every item on `threads` threads (at least 1; the calling
 * thread is number 0; started by make -j, on fewer: jobserver.h) and returns
 * when all are done. Once *stop is non-zero (may be NULL) no new item is begun.
 * Returns true if every item was done. */
bool parallel_run(unsigned threads, size_t count, const atomic_int *stop,
                  parallel_task *task, void *context);

/* One thing done beside others, on a thread of its own if there can be one.
 * NULL: it couldn't be started. */
struct background;
struct background *background_start(void (*task)(void *context), void *context);

/* Waits for the end of it; NULL is none. */
void background_join(struct background *background);

/* Runs the task on a thread with PARALLEL_STACK bytes of stack and waits for
 * it. False if there is none to be had: nothing is done. */
bool parallel_call(void (*task)(void *context), void *context);

/* `tick` called on a thread of its own, first after `delay` seconds and then
 * every `pause`, until ticker_stop, which doesn't wait for the next and takes
 * NULL. Never, if there can't be such a thread. */
struct ticker;
struct ticker *ticker_start(double delay, double pause,
                            void (*tick)(void *context), void *context);
void ticker_stop(struct ticker *ticker);

/* Held by one thread at a time; the others wait. Freed by lock_free. */
struct lock;
struct lock *lock_new(void);
void lock_free(struct lock *lock);
void lock_take(struct lock *lock);
void lock_give(struct lock *lock);

/* Made by whoever needs it first: a static one, zeroed, for each thing. */
struct once {
    atomic_bool done;
};

void once_make(struct once *once, void (*make)(void));

/* Calls `make` before it first returns; other threads wait for that. */
static inline void once_only(struct once *once, void (*make)(void))
{
    if (!atomic_load_explicit(&once->done, memory_order_acquire))
        once_make(once, make);
}

/* Cores this process may use (affinity respected), at least 1. */
unsigned parallel_cores(void);

#endif
