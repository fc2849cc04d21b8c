/* POV-Ray beside glim: see beside.h. It gets what the options came to, not
 * their words, of which it doesn't know all. */
#include "view/beside.h"

#include <stdlib.h>
#include <string.h>

#include "base/memory.h"
#include "base/parallel.h"
#include "base/save.h"
#include "base/scratch.h"
#include "compare/flip.h"
#include "compare/heat.h"
#include "compare/figures.h"
#include "compare/program.h"
#include "image/file.h"
#include "view/fly.h"

enum { WORDS_LIMIT = 400, THRESHOLD_STEPS = 255 };

struct beside {
    struct canvas picture, heat;
    struct background *thread;
    atomic_int stop;
    atomic_int state;       /* enum beside_state */
    char text[BESIDE_TEXT]; /* the thread's until it has ended */
    struct arena *arena;    /* of what follows */
    struct beside_view view;
    struct image *drawn; /* by POV-Ray */
    struct image *glim;  /* to compare with */
    double seconds;
};

struct beside *beside_new(void)
{
    struct beside *beside = memory_new(sizeof *beside);
    canvas_start(&beside->picture);
    canvas_start(&beside->heat);
    return beside;
}

static void beside_end(struct beside *beside)
{
    atomic_store(&beside->stop, 1);
    background_join(beside->thread);
    beside->thread = NULL;
    image_free(beside->drawn);
    image_free(beside->glim);
    beside->drawn = beside->glim = NULL;
    if (beside->arena)
        arena_free(beside->arena);
    beside->arena = NULL;
    atomic_store(&beside->stop, 0);
    atomic_store(&beside->state, BESIDE_NONE);
}

void beside_free(struct beside *beside)
{
    beside_end(beside);
    canvas_end(&beside->picture);
    canvas_end(&beside->heat);
    memory_free(beside);
}

void beside_forget(struct beside *beside)
{
    beside_end(beside);
}

/* ---- POV-Ray ---- */

struct beside_words {
    struct arena *arena;
    char **items;
    size_t count, capacity;
};

static void words_name(struct beside_words *words, const char *letters,
                       const char *name)
{
    *ARRAY_PUSH(words->arena, words) =
        program_povray_name(letters, name, words->arena);
}

__attribute__((format(printf, 2, 3))) static void
words_add(struct beside_words *words, const char *format, ...)
{
    char text[FILENAME_MAX];
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(text, sizeof text, format, arguments);
    va_end(arguments);
    *ARRAY_PUSH(words->arena, words) =
        arena_copy_text(words->arena, text, strlen(text));
}

static void words_options(struct beside_words *words,
                          const struct options *options, int frame)
{
    const struct render_options *render = &options->render;
    struct parse_options parse = options->parse;
    frames_tell(&options->frames, frames_number(&options->frames, frame),
                &parse);
    words_add(words, "+W%d", render->width);
    words_add(words, "+H%d", render->height);
    words_add(words, "+Q%d", options->quality);
    if (render->antialias) {
        words_add(words, "+A%g", render->threshold);
        words_add(words, "+AM%d", render->method);
        words_add(words, "+R%d", render->depth);
        words_add(words, render->jitter > 0 ? "+J%g" : "-J", render->jitter);
    }
    if (parse.clock_on || !isnan(options->clock))
        words_add(words, "+K%.12g", parse.clock);
    for (size_t i = 0; i < parse.declare_count; i++)
        words_add(words, "Declare=%s=%s", parse.declares[i].name,
                  parse.declares[i].value);
    for (size_t i = 0; i < parse.include_path_count; i++)
        words_name(words, "+L", parse.include_paths[i]);
}

/* The scene itself, or with another camera after its own, which wins. NULL: it
 * can't be written. */
static const char *beside_scene(const struct beside *beside,
                                const struct options *options,
                                const char *directory, struct arena *arena)
{
    const char *problem;
    const struct source *source =
        source_read(arena, options->path, span_none(), &problem);
    char why[256], *block = NULL;
    size_t size;
    if (!beside->view.moved || !source)
        return options->path;
    const char *path = arena_printf(arena, "%s/scene.pov", directory);
    FILE *out = open_memstream(&block, &size);
    fwrite(source->text, 1, source->length, out);
    fputs("\n", out);
    fly_print(&beside->view.camera, out);
    fclose(out);
    bool written = save_bytes(path, block, size, why, sizeof why);
    free(block);
    return written ? path : NULL;
}

static struct image *beside_povray(struct beside *beside,
                                   const struct options *options,
                                   const char *directory, struct arena *arena)
{
    struct beside_words words = { .arena = arena };
    const char *program = program_find("POVRAY", "povray", false, arena);
    const char *scene = beside_scene(beside, options, directory, arena);
    const char *picture = arena_printf(arena, "%s/povray.png", directory);
    struct times times = { 0, 0 };
    char why[256] = "it does not draw this scene";
    const char *slash = strrchr(options->path, '/');
    if (!program || !scene) {
        snprintf(beside->text, sizeof beside->text, "%s",
                 scene ? "POV-Ray is not there: install povray, or set POVRAY"
                       : "POV-Ray's scene can't be written");
        return NULL;
    }
    words_add(&words, "%s", program);
    words_options(&words, options, beside->view.frame);
    words_name(&words, "+L",
               arena_printf(arena, "%.*s",
                            slash ? (int)(slash - options->path) + 1 : 1,
                            slash ? options->path : "."));
    words_name(&words, "+I", scene);
    words_name(&words, "+O", picture);
    static const char *const last[] = { "+FN8", "-D", "-P", "-V", "-GA" };
    for (size_t i = 0; i < sizeof last / sizeof *last; i++)
        words_add(&words, "%s", last[i]);
    *ARRAY_PUSH(arena, &words) = NULL;
    struct image *image = NULL;
    if (program_run(words.items, arena_printf(arena, "%s/log", directory),
                    &beside->stop, &times) == PROGRAM_DONE)
        image = image_read(picture, why, sizeof why);
    if (image && (image->width != options->render.width ||
                  image->height != options->render.height)) {
        snprintf(why, sizeof why, "its picture is of another size");
        image_free(image);
        image = NULL;
    }
    beside->seconds = times.wall;
    if (!image)
        snprintf(beside->text, sizeof beside->text, "POV-Ray: %s", why);
    return image;
}

/* A picture of display numbers, onto a canvas. */
static void beside_show(struct canvas *canvas, const struct image *image)
{
    struct canvas_tone *tone = memory_new(sizeof *tone);
    const struct output_space numbers = { .keep_numbers = true };
    const struct render_part all = { { 0, 0, image->width, image->height },
                                     image->pixels };
    canvas_tone(tone, &numbers);
    canvas_resize(canvas, image->width, image->height);
    canvas_put(canvas, tone, &all, 1);
    memory_free(tone);
}

static void beside_draw(void *context)
{
    struct beside *beside = context;
    struct diag silent = { .out = NULL };
    struct drawing *drawing =
        drawing_new(beside->view.argc, beside->view.argv, &silent);
    const char *directory =
        drawing ? scratch_make("glim-view", drawing->arena, NULL) : NULL;
    if (directory)
        beside->drawn =
            beside_povray(beside, &drawing->options, directory, drawing->arena);
    else
        snprintf(beside->text, sizeof beside->text,
                 "POV-Ray: no directory can be made for its picture");
    scratch_remove(directory);
    drawing_free(drawing);
    if (beside->drawn)
        beside_show(&beside->picture, beside->drawn);
    atomic_store(&beside->state, beside->drawn ? BESIDE_DRAWN : BESIDE_FAILED);
}

void beside_start(struct beside *beside, const struct beside_view *view)
{
    beside_end(beside);
    beside->arena = arena_new(0);
    beside->view = *view;
    beside->view.argv =
        ARENA_ARRAY(beside->arena, char *, (size_t)view->argc + 1);
    for (int i = 0; i < view->argc; i++)
        beside->view.argv[i] = arena_copy_text(beside->arena, view->argv[i],
                                               strlen(view->argv[i]));
    snprintf(beside->text, sizeof beside->text, "POV-Ray draws");
    atomic_store(&beside->state, BESIDE_DRAWING);
    beside->thread = background_start(beside_draw, beside);
    if (!beside->thread)
        atomic_store(&beside->state, BESIDE_FAILED);
}

/* ---- comparing ---- */

static void beside_compare(void *context)
{
    struct beside *beside = context;
    struct pair pair = pair_new(beside->drawn, beside->glim, SPACE_DISPLAY);
    beside->drawn = beside->glim = NULL; /* the pair's now */
    struct plane flip = flip_map(&pair, FLIP_PIXELS_PER_DEGREE);
    struct figures figures = figures_find(&pair, 3.5 / THRESHOLD_STEPS);
    struct image *heat = heat_picture(&flip, 1);
    beside_show(&beside->heat, heat);
    snprintf(
        beside->text, sizeof beside->text,
        "POV-Ray %.2f s | FLIP %.4f | mean difference %.4f, largest %.3f | "
        "%.2f %% of the pixels differ",
        beside->seconds, plane_mean(&flip, 0), figures.mean, figures.largest,
        100 * figures.over);
    image_free(heat);
    plane_free(&flip);
    pair_free(&pair);
    atomic_store(&beside->state, BESIDE_DONE);
}

static struct image *canvas_image(struct canvas *canvas)
{
    SDL_LockMutex(canvas->lock);
    struct image *image = image_new(canvas->width, canvas->height);
    size_t count = (size_t)canvas->width * (size_t)canvas->height;
    for (size_t i = 0; i < count; i++) {
        for (int k = 0; k < 3; k++)
            image->pixels[4 * i + (size_t)k] =
                (float)(canvas->pixels[i] >> (16 - 8 * k) & 255) / 255;
        image->pixels[4 * i + 3] = 1;
    }
    SDL_UnlockMutex(canvas->lock);
    image->bits = 8;
    image->channels = 3;
    return image;
}

enum beside_state beside_look(struct beside *beside, struct canvas *canvas,
                              bool finished)
{
    enum beside_state state = (enum beside_state)atomic_load(&beside->state);
    if (state != BESIDE_DRAWN || !finished)
        return state;
    background_join(beside->thread);
    if (canvas->width != beside->drawn->width ||
        canvas->height != beside->drawn->height) {
        beside->thread = NULL;
        return state;
    }
    beside->glim = canvas_image(canvas);
    atomic_store(&beside->state, BESIDE_COMPARING);
    beside->thread = background_start(beside_compare, beside);
    return BESIDE_COMPARING;
}

struct canvas *beside_picture(struct beside *beside)
{
    return &beside->picture;
}

struct canvas *beside_heat(struct beside *beside)
{
    return &beside->heat;
}

const char *beside_text(const struct beside *beside)
{
    return beside->text;
}
