/* Progress: see progress.h. */
#include "cli/progress.h"

#include <math.h>
#include <stdio.h>
#include <string.h>
#include <unistd.h>

#include "base/clock.h"
#include "cli/json.h"
#include "base/parallel.h"

enum {
    PROGRESS_PAUSE = 200,  /* milliseconds between two lines on a terminal */
    PROGRESS_DELAY = 1000, /* before the first: short work needs none */
    PROGRESS_WIDTH = 80,
};

/* Messages begin at the left and overwrite it. */
static void progress_tick(void *context)
{
    struct progress *progress = context;
    fprintf(stderr, "\r%.30s: %s, %.0f s \r",
            progress->frame[0] ? progress->frame : progress->name,
            atomic_load(&progress->doing), clock_seconds() - progress->begun);
}

void progress_begin(struct progress *progress, const struct options *options,
                    const char *name, int index)
{
    bool terminal = isatty(STDERR_FILENO);
    int count = frames_count(&options->frames);
    progress->json =
        options->progress_form && strcmp(options->progress_form, "json") == 0;
    progress->live =
        terminal && options->progress != PROGRESS_NEVER && !progress->json;
    progress->lines =
        !terminal && options->progress == PROGRESS_ALWAYS && !progress->json;
    progress->name = name ? name : options->input;
    progress->frame[0] = '\0';
    if (options->frames.animated)
        snprintf(progress->frame, sizeof progress->frame, "frame %d of %d",
                 index + 1, count);
    progress->begun = clock_seconds();
    if (index == 0)
        progress->all = progress->begun;
    atomic_store(&progress->doing, "reading the scene");
    if (progress->live)
        progress->ticker =
            ticker_start(PROGRESS_DELAY / 1000.0, PROGRESS_PAUSE / 1000.0,
                         progress_tick, progress);
}

void progress_doing(struct progress *progress, const char *doing)
{
    atomic_store(&progress->doing, doing);
}

void progress_end(struct progress *progress)
{
    if (!progress->ticker)
        return;
    ticker_stop(progress->ticker);
    progress->ticker = NULL;
    if (clock_seconds() - progress->begun > PROGRESS_DELAY / 1000.0)
        progress_clear(progress);
}

void progress_start(struct progress *progress, const struct tracer *tracer)
{
    progress_end(progress);
    progress->tracer = tracer;
    progress->start = clock_seconds();
    atomic_init(&progress->samples, 0);
    atomic_init(&progress->error, -1);
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

/* ", 64 samples, error 1.2 %" */
static void progress_add_samples(const struct progress *progress, char *text,
                                 size_t size)
{
    size_t length = strlen(text);
    int samples = atomic_load(&progress->samples);
    int error = atomic_load(&progress->error);
    if (samples > 0 && error >= 0)
        snprintf(text + length, size - length, ", %d samples, error %.2f %%",
                 samples, error / 100.0);
    else if (samples > 0)
        snprintf(text + length, size - length, ", %d samples", samples);
}

void progress_passed(void *context, int samples, double error)
{
    struct progress *progress = context;
    atomic_store(&progress->samples, samples);
    atomic_store(&progress->error, error < 1e5 ? (int)(error * 1e4) : -1);
}

void progress_tell(void *context, double done)
{
    struct progress *progress = context;
    double seconds = clock_seconds() - progress->start;
    if (progress->json) {
        int now = seconds < 1e6 ? (int)(seconds * 1000) : 0;
        if (progress_take(progress, now, now + 1000))
            progress_json(progress, "drawing", done, seconds);
        return;
    }
    if (!progress->live && !progress->lines)
        return;
    char text[PROGRESS_WIDTH];
    progress_text(text, sizeof text, done, seconds);
    progress_add_samples(progress, text, sizeof text);
    if (progress->live) {
        int now = seconds < 1e6 ? (int)(seconds * 1000) : 0;
        if (progress_take(progress, now, now + PROGRESS_PAUSE))
            fprintf(stderr, "\r%.30s: %-48s",
                    progress->frame[0] ? progress->frame : progress->name,
                    text);
    } else {
        int tenth = (int)(done * 10);
        if (progress_take(progress, tenth, tenth + 1))
            fprintf(stderr, "%s%s%s: %s\n", progress->frame,
                    progress->frame[0] ? ", " : "", progress->name, text);
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
    if (progress->json)
        progress_json(progress, "done", 1, clock_seconds() - progress->start);
    if (!progress->live && !progress->lines)
        return;
    fprintf(stderr, "%s%s%s: %d x %d pixels in %.2f s\n", progress->frame,
            progress->frame[0] ? ", " : "", progress->name,
            options->render.width, options->render.height,
            clock_seconds() - progress->begun);
}

void progress_total(const struct progress *progress,
                    const struct frames *frames)
{
    int count = frames_count(frames);
    if (count > 1 && (progress->live || progress->lines))
        fprintf(stderr, "%d frames in %.2f s\n", count,
                clock_seconds() - progress->all);
}

void progress_left(const char *part)
{
    fprintf(stderr, "glim: +C goes on with what '%s' has\n", part);
}

void progress_interrupted(const struct frames *frames, int index,
                          const struct unfinished *unfinished, const char *part)
{
    char where[64] = "";
    if (*part)
        progress_left(part);
    if (frames->animated)
        snprintf(where, sizeof where, " in frame %d",
                 frames_number(frames, index));
    if (unfinished->name[0] && unfinished->share >= 1)
        fprintf(stderr,
                "glim: interrupted%s; '%s' has all pixels, some of them still "
                "rough\n",
                where, unfinished->name);
    else if (unfinished->name[0])
        fprintf(stderr,
                "glim: interrupted%s; '%s' has what was drawn, %.0f %% of the "
                "pixels\n",
                where, unfinished->name, floor(100 * unfinished->share));
    else if (frames->animated)
        fprintf(stderr, "glim: interrupted%s, not written\n", where);
    else
        fprintf(stderr, "glim: interrupted, nothing written\n");
}
