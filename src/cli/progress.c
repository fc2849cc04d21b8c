/* Progress: see progress.h. */
#include "cli/progress.h"

#include <stdio.h>
#include <time.h>
#include <unistd.h>

enum {
    PROGRESS_PAUSE = 200,  /* milliseconds between two lines on a terminal */
    PROGRESS_DELAY = 1000, /* before the first: short work needs none */
    PROGRESS_WIDTH = 60,
};

double progress_clock(void)
{
    struct timespec now;
    clock_gettime(CLOCK_MONOTONIC, &now);
    return (double)now.tv_sec + (double)now.tv_nsec * 1e-9;
}

void progress_start(struct progress *progress, const struct options *options,
                    const char *name)
{
    bool terminal = isatty(STDERR_FILENO);
    progress->live = terminal && options->progress != PROGRESS_NEVER;
    progress->lines = !terminal && options->progress == PROGRESS_ALWAYS;
    progress->name = name ? name : options->input;
    progress->start = progress_clock();
    atomic_init(&progress->next, progress->lines ? 1 : PROGRESS_DELAY);
}

/* Whether this thread is the one to tell; `now` is in the unit of next. */
static bool progress_take(struct progress *progress, int now, int next)
{
    int due = atomic_load(&progress->next);
    return now >= due &&
           atomic_compare_exchange_strong(&progress->next, &due, next);
}

static void progress_text(char *text, size_t size, double done, double seconds)
{
    double left = done > 0 ? seconds * (1 - done) / done : 0;
    if (done < 0.02) /* too early to tell */
        snprintf(text, size, "%3.0f %%", 100 * done);
    else if (left < 100)
        snprintf(text, size, "%3.0f %%, %.0f s left", 100 * done, left);
    else
        snprintf(text, size, "%3.0f %%, %.0f min left", 100 * done, left / 60);
}

void progress_tell(void *context, double done)
{
    struct progress *progress = context;
    if (!progress->live && !progress->lines)
        return;
    double seconds = progress_clock() - progress->start;
    char text[PROGRESS_WIDTH];
    progress_text(text, sizeof text, done, seconds);
    if (progress->live) {
        int now = seconds < 1e6 ? (int)(seconds * 1000) : 0;
        if (progress_take(progress, now, now + PROGRESS_PAUSE))
            fprintf(stderr, "\r%.40s: %-20s", progress->name, text);
    } else {
        int tenth = (int)(done * 10);
        if (progress_take(progress, tenth, tenth + 1))
            fprintf(stderr, "%s: %s\n", progress->name, text);
    }
}

void progress_clear(const struct progress *progress)
{
    if (progress->live)
        fprintf(stderr, "\r%*s\r", PROGRESS_WIDTH + 2, "");
}

void progress_finish(const struct progress *progress,
                     const struct options *options)
{
    if (!progress->live && !progress->lines)
        return;
    fprintf(stderr, "%s: %d x %d pixels in %.2f s\n", progress->name,
            options->render.width, options->render.height,
            progress_clock() - progress->start);
}

void progress_interrupted(const struct frames *frames, int index)
{
    if (frames->animated)
        fprintf(stderr, "glim: interrupted in frame %d, not written\n",
                frames_number(frames, index));
    else
        fprintf(stderr, "glim: interrupted, nothing written\n");
}
