/* One input for the whole reading half of glim: source text, tokens,
 * directives, expressions, scene. libFuzzer calls it (make fuzz); replay.c
 * calls it for each file of the corpus (make test).
 *
 * A scene may ask for loops that take for ever, in which only a signal stops
 * glim: here that is a timer of processor time. Messages are written, to
 * nowhere, so that their printing is tried as well. */
#include <signal.h>
#include <stdint.h>
#include <sys/time.h>

#include "parse/parse.h"

enum { SECONDS = 2 };

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);

static atomic_int stop;

static void timer_end(int number)
{
    (void)number;
    atomic_store(&stop, 1);
}

static void timer_start(void)
{
    struct itimerval timer = { .it_value = { .tv_sec = SECONDS } };
    atomic_store(&stop, 0);
    signal(SIGVTALRM, timer_end);
    setitimer(ITIMER_VIRTUAL, &timer, NULL);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    char words[1024];
    struct arena *sources = arena_new(0);
    struct source source = {
        .name = "fuzz.pov",
        .text = arena_copy_text(sources, (const char *)data, size),
        .length = size,
    };
    struct diag diag = { .out = fmemopen(words, sizeof words, "w") };
    struct parse_options options = {
        .image_width = 160,
        .image_height = 120,
        .memory_limit = (size_t)64 << 20,
        .round_limit = 2000,
        .stop = &stop,
    };
    timer_start();
    scene_free(parse_scene(&source, &options, sources, &diag));
    arena_free(sources);
    if (diag.out)
        fclose(diag.out);
    return 0;
}
