/* Threads and the item counter: see parallel.h. The only user of pthreads. */
#define _GNU_SOURCE
#include "base/parallel.h"

#include <math.h>
#include <pthread.h>
#include <sched.h>
#include <signal.h>
#include <time.h>

#include "base/clock.h"
#include "base/jobserver.h"
#include "base/memory.h"

struct parallel_job {
    atomic_size_t next, done;
    size_t count;
    const atomic_int *stop;
    parallel_task *task;
    void *context;
    struct parallel_thread *pool;
    unsigned threads, started;
    bool metered; /* each thread but the first needs a token (jobserver.h) */
    double asked; /* clock_seconds(), when one was asked for last */
};

struct parallel_thread {
    struct parallel_job *job;
    pthread_t handle;
    unsigned number;
    char token;
};

/* Seconds between two times that make is asked for a token. */
static const double token_pause = 0.005;

static void *parallel_work(void *argument);

/* With a stack of known size, whatever `ulimit -s` says. */
static bool thread_start(pthread_t *handle, void *(*work)(void *argument),
                         void *argument)
{
    pthread_attr_t attributes;
    if (pthread_attr_init(&attributes) != 0)
        return false;
    bool started =
        pthread_attr_setstacksize(&attributes, PARALLEL_STACK) == 0 &&
        pthread_create(handle, &attributes, work, argument) == 0;
    pthread_attr_destroy(&attributes);
    return started;
}

/* One more thread. False if there can be none now. */
static bool parallel_add(struct parallel_job *job)
{
    struct parallel_thread *thread = &job->pool[job->started];
    if (job->started >= job->threads ||
        (job->metered && !jobserver_take(&thread->token)))
        return false;
    bool started = thread_start(&thread->handle, parallel_work, thread);
    job->started += started;
    if (!started && job->metered)
        jobserver_give(thread->token);
    return started;
}

/* By the first thread, between two items: whether others have put tokens back.
 */
static void parallel_ask(struct parallel_job *job)
{
    double now = clock_seconds();
    if (now < job->asked + token_pause)
        return;
    job->asked = now;
    while (parallel_add(job))
        continue;
}

static void parallel_items(struct parallel_thread *thread)
{
    struct parallel_job *job = thread->job;
    for (;;) {
        if (job->metered && thread->number == 0)
            parallel_ask(job);
        if (job->stop && atomic_load(job->stop))
            return;
        size_t item = atomic_fetch_add(&job->next, 1);
        if (item >= job->count)
            return;
        job->task(job->context, item, thread->number);
        atomic_fetch_add(&job->done, 1);
    }
}

static void *parallel_work(void *argument)
{
    struct parallel_thread *thread = argument;
    parallel_items(thread);
    return NULL;
}

/* A thread that can't be started is no error: the others do its share. */
bool parallel_run(unsigned threads, size_t count, const atomic_int *stop,
                  parallel_task *task, void *context)
{
    struct parallel_job job = {
        .count = count,
        .stop = stop,
        .task = task,
        .context = context,
        .threads = threads < 1 ? 1 : threads,
        .started = 1,
        .metered = threads > 1 && jobserver_state() == JOBSERVER_OPEN,
    };
    job.pool = memory_new(job.threads * sizeof *job.pool);
    for (unsigned i = 0; i < job.threads; i++)
        job.pool[i] = (struct parallel_thread){ .job = &job, .number = i };
    while (parallel_add(&job))
        continue;
    parallel_items(&job.pool[0]);
    for (unsigned i = 1; i < job.started; i++) {
        pthread_join(job.pool[i].handle, NULL);
        if (job.metered) /* now that it runs no more */
            jobserver_give(job.pool[i].token);
    }
    memory_free(job.pool);
    return atomic_load(&job.done) == count;
}

struct background {
    pthread_t handle;
    void (*task)(void *context);
    void *context;
};

static void *background_work(void *argument)
{
    struct background *background = argument;
    background->task(background->context);
    return NULL;
}

struct background *background_start(void (*task)(void *context), void *context)
{
    struct background *background = memory_new(sizeof *background);
    *background = (struct background){ .task = task, .context = context };
    if (thread_start(&background->handle, background_work, background))
        return background;
    memory_free(background);
    return NULL;
}

void background_join(struct background *background)
{
    if (!background)
        return;
    pthread_join(background->handle, NULL);
    memory_free(background);
}

bool parallel_call(void (*task)(void *context), void *context)
{
    sigset_t all, before;
    struct background *background = background_start(task, context);
    if (!background)
        return false;
    /* Signals end what the task waits for, not the waiting for the task. */
    sigfillset(&all);
    pthread_sigmask(SIG_SETMASK, &all, &before);
    background_join(background);
    pthread_sigmask(SIG_SETMASK, &before, NULL);
    return true;
}

struct ticker {
    pthread_mutex_t lock;
    pthread_cond_t stopping;
    bool stop;
    double delay, pause;
    void (*tick)(void *context);
    void *context;
    struct background *thread;
};

static struct timespec time_after(double seconds)
{
    struct timespec time;
    clock_gettime(CLOCK_MONOTONIC, &time);
    double nanoseconds = (double)time.tv_nsec + seconds * 1e9;
    time.tv_sec += (time_t)(nanoseconds / 1e9);
    time.tv_nsec = (long)fmod(nanoseconds, 1e9);
    return time;
}

static void ticker_work(void *context)
{
    struct ticker *ticker = context;
    struct timespec next = time_after(ticker->delay);
    pthread_mutex_lock(&ticker->lock);
    while (!ticker->stop)
        if (pthread_cond_timedwait(&ticker->stopping, &ticker->lock, &next)) {
            ticker->tick(ticker->context);
            next = time_after(ticker->pause);
        }
    pthread_mutex_unlock(&ticker->lock);
}

struct ticker *ticker_start(double delay, double pause,
                            void (*tick)(void *context), void *context)
{
    struct ticker *ticker = memory_new(sizeof *ticker);
    pthread_condattr_t steady;
    *ticker = (struct ticker){
        .delay = delay, .pause = pause, .tick = tick, .context = context
    };
    pthread_condattr_init(&steady);
    pthread_condattr_setclock(&steady, CLOCK_MONOTONIC);
    pthread_cond_init(&ticker->stopping, &steady);
    pthread_condattr_destroy(&steady);
    pthread_mutex_init(&ticker->lock, NULL);
    ticker->thread = background_start(ticker_work, ticker);
    return ticker;
}

void ticker_stop(struct ticker *ticker)
{
    if (!ticker)
        return;
    pthread_mutex_lock(&ticker->lock);
    ticker->stop = true;
    pthread_cond_signal(&ticker->stopping);
    pthread_mutex_unlock(&ticker->lock);
    background_join(ticker->thread);
    pthread_cond_destroy(&ticker->stopping);
    pthread_mutex_destroy(&ticker->lock);
    memory_free(ticker);
}

struct lock {
    pthread_mutex_t mutex;
};

struct lock *lock_new(void)
{
    struct lock *lock = memory_new(sizeof *lock);
    pthread_mutex_init(&lock->mutex, NULL);
    return lock;
}

void lock_free(struct lock *lock)
{
    if (!lock)
        return;
    pthread_mutex_destroy(&lock->mutex);
    memory_free(lock);
}

void lock_take(struct lock *lock)
{
    pthread_mutex_lock(&lock->mutex);
}

void lock_give(struct lock *lock)
{
    pthread_mutex_unlock(&lock->mutex);
}

void once_make(struct once *once, void (*make)(void))
{
    static pthread_mutex_t making = PTHREAD_MUTEX_INITIALIZER;
    pthread_mutex_lock(&making);
    if (!atomic_load_explicit(&once->done, memory_order_relaxed)) {
        make();
        atomic_store_explicit(&once->done, true, memory_order_release);
    }
    pthread_mutex_unlock(&making);
}

unsigned parallel_cores(void)
{
    cpu_set_t set;
    if (sched_getaffinity(0, sizeof set, &set) == 0 && CPU_COUNT(&set) > 0)
        return (unsigned)CPU_COUNT(&set);
    return 1;
}
