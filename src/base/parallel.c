/* Threads and the item counter: see parallel.h. The only user of pthreads. */
#define _GNU_SOURCE
#include "base/parallel.h"

#include <pthread.h>
#include <sched.h>
#include <signal.h>

#include "base/memory.h"

struct parallel_job {
    atomic_size_t next, done;
    size_t count;
    const atomic_int *stop;
    parallel_task *task;
    void *context;
};

struct parallel_thread {
    struct parallel_job *job;
    pthread_t handle;
    unsigned number;
    bool started;
};

static void *parallel_work(void *argument)
{
    struct parallel_thread *thread = argument;
    struct parallel_job *job = thread->job;
    for (;;) {
        if (job->stop && atomic_load(job->stop))
            return NULL;
        size_t item = atomic_fetch_add(&job->next, 1);
        if (item >= job->count)
            return NULL;
        job->task(job->context, item, thread->number);
        atomic_fetch_add(&job->done, 1);
    }
}

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

/* A thread that can't be started is no error: the others do its share. */
bool parallel_run(unsigned threads, size_t count, const atomic_int *stop,
                  parallel_task *task, void *context)
{
    struct parallel_job job = {
        .count = count, .stop = stop, .task = task, .context = context
    };
    if (threads < 1)
        threads = 1;
    struct parallel_thread *pool = memory_new(threads * sizeof *pool);
    for (unsigned i = 0; i < threads; i++)
        pool[i] = (struct parallel_thread){ .job = &job, .number = i };
    for (unsigned i = 1; i < threads; i++)
        pool[i].started =
            thread_start(&pool[i].handle, parallel_work, &pool[i]);
    parallel_work(&pool[0]);
    for (unsigned i = 1; i < threads; i++)
        if (pool[i].started)
            pthread_join(pool[i].handle, NULL);
    memory_free(pool);
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
