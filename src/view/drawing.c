/* Coarse to fine: see drawing.h. */
#include "view/drawing.h"

#include <string.h>

#include "base/clock.h"
#include "base/memory.h"
#include "cli/origin.h"
#include "cli/picture.h"
#include "tracer/integrator.h"
#include "tracer/photons.h"

/* Rough pictures: one ray for so many pixels each way, by shadow rays or, at
 * first, without shadows. */
static const struct rough {
    int step, quality;
} roughs[] = { { 8, QUALITY_SHADOWS - 1 }, { 4, 11 }, { 2, 11 } };

enum {
    ROUGHS = sizeof roughs / sizeof *roughs,
    ROUGH_LAMPS = 100, /* under more all is as bright as its colour */
};

/* A finer one is not begun if it would take longer, seconds. */
static const double rough_limit = 0.4;

struct drawing *drawing_new(int argc, char **argv, struct diag *diag)
{
    struct drawing *drawing = memory_new(sizeof *drawing);
    drawing->begun = clock_seconds();
    drawing->arena = arena_new(0);
    drawing->files.arena = drawing->arena;
    drawing->options.parse.asked = &drawing->files;
    char **words = ARENA_ARRAY(drawing->arena, char *, (size_t)argc + 1);
    for (int i = 0; i < argc; i++)
        words[i] = arena_copy_text(drawing->arena, argv[i], strlen(argv[i]));
    if (!options_parse(&drawing->options, argc, words, drawing->arena, diag)) {
        drawing_free(drawing);
        return NULL;
    }
    drawing->first_file = drawing->files.count;
    return drawing;
}

void drawing_free(struct drawing *drawing)
{
    if (!drawing)
        return;
    if (drawing->tracer.lighting_state)
        drawing->tracer.lighting->finish(drawing->tracer.lighting_state);
    photon_map_free(drawing->photons);
    image_free(drawing->image);
    model_leave(drawing->model);
    arena_free(drawing->arena);
    memory_free(drawing);
}

/* Where parts of a picture go. */
struct easel {
    const struct drawing *drawing;
    const struct drawing_context *context;
    struct canvas_tone tone;
    int step;
};

static void easel_put(void *easel_, const struct render_part *part)
{
    struct easel *easel = easel_;
    canvas_put(easel->context->canvas, &easel->tone, part, easel->step);
}

static void easel_share(void *easel_, double share)
{
    const struct drawing_context *context = ((struct easel *)easel_)->context;
    context->share(context->told, share);
}

static struct tracer drawing_tracer(const struct drawing *drawing,
                                    const struct lighting *lighting,
                                    int quality, const atomic_int *stop,
                                    struct diag *diag)
{
    const struct options *options = &drawing->options;
    const struct lighting_options light = { .threads = options->render.threads,
                                            .width = options->render.width,
                                            .height = options->render.height,
                                            .quality = quality,
                                            .stop = stop };
    struct model *model = drawing->model;
    return (struct tracer){
        .scene = model->scene,
        .world = model->world,
        .lighting = lighting,
        .lighting_state =
            lighting->start(model->world, model->scene, &light, diag),
        .quality = quality,
        .alpha = options->alpha,
    };
}

/* Radiosity needs a mesh, for which there is no time. */
static int rough_quality(const struct drawing *drawing,
                         const struct rough *rough)
{
    size_t lamps;
    int most = drawing->options.quality;
    world_lights(drawing->model->world, &lamps);
    if (drawing->model->scene->settings.radiosity && most >= QUALITY_FOG)
        most = QUALITY_FOG - 1;
    if (lamps > ROUGH_LAMPS && most >= QUALITY_LIT)
        most = QUALITY_LIT - 1;
    return rough->quality < most ? rough->quality : most;
}

/* A rough picture. */
static bool drawing_rough(struct drawing *drawing, struct easel *easel,
                          const struct rough *rough, const atomic_int *stop)
{
    const struct options *options = &drawing->options;
    int quality = rough_quality(drawing, rough);
    struct diag silent = { .out = NULL };
    struct tracer tracer =
        drawing_tracer(drawing, lighting_find("rays"), quality, stop, &silent);
    if (!tracer.lighting_state)
        return false;
    struct render_options render = options->render;
    int step = rough->step;
    easel->step = step;
    render.width = (render.width + step - 1) / step;
    render.height = (render.height + step - 1) / step;
    render.column_start /= step;
    render.row_start /= step;
    render.column_end = (render.column_end + step - 1) / step;
    render.row_end = (render.row_end + step - 1) / step;
    render.antialias = false;
    render.stop = stop;
    render.drawn = easel_put;
    render.drawn_context = easel;
    struct image *image = image_new(render.width, render.height);
    bool done = render_run(&tracer, &render, image, NULL);
    image_free(image);
    tracer.lighting->finish(tracer.lighting_state);
    return done;
}

/* One after the other, while they are quick. */
static bool drawing_coarse(struct drawing *drawing, struct easel *easel)
{
    const struct drawing_context *context = easel->context;
    double last = 0;
    for (int i = 0; i < ROUGHS; i++) {
        double start = clock_seconds();
        if (i > 0 && (last > rough_limit / 4 || atomic_load(context->stop)))
            break;
        if (!drawing_rough(drawing, easel, &roughs[i],
                           i ? context->stop : context->quit))
            return false;
        last = clock_seconds() - start;
        if (i > 0)
            continue;
        drawing->first = clock_seconds() - drawing->begun;
        context->seen(context->told);
    }
    return !atomic_load(context->stop);
}

/* The picture itself, as glim draws it. */
static bool drawing_pixels(struct drawing *drawing, struct easel *easel,
                           struct image *image)
{
    const struct drawing_context *context = easel->context;
    struct render_options render = drawing->options.render;
    render.stop = context->stop;
    render.drawn = easel_put;
    render.drawn_context = easel;
    render.progress = easel_share;
    render.progress_context = easel;
    easel->step = 1;
    return render_run(&drawing->tracer, &render, image, &drawing->stats.rays) &&
           picture_show(image, &drawing->options, &drawing->tracer,
                        context->stop, context->diag);
}

static bool drawing_light(struct drawing *drawing,
                          const struct drawing_context *context)
{
    const struct options *options = &drawing->options;
    context->stage(context->told, DRAWING_LIGHT);
    drawing->tracer = drawing_tracer(
        drawing, lighting_for(options->lighting, drawing->model->scene),
        options->quality, context->stop, context->diag);
    if (!drawing->tracer.lighting_state ||
        !photons_send(&drawing->tracer, options->render.threads, context->stop,
                      context->diag, &drawing->photons))
        return false;
    drawing->tracer.photons = drawing->photons;
    return true;
}

static bool drawing_fine(struct drawing *drawing, struct easel *easel)
{
    const struct drawing_context *context = easel->context;
    const struct render_options *render = &drawing->options.render;
    if (!drawing_light(drawing, context))
        return false;
    context->stage(context->told, DRAWING_PIXELS);
    struct image *image = image_new(render->width, render->height);
    if (!drawing_pixels(drawing, easel, image)) {
        image_free(image);
        return false;
    }
    const struct render_part all = { { 0, 0, image->width, image->height },
                                     image->pixels };
    easel_put(easel, &all);
    drawing->image = image;
    drawing->finished = clock_seconds() - drawing->begun;
    stats_lighting(&drawing->stats, &drawing->tracer);
    return true;
}

bool drawing_run(struct drawing *drawing, const struct drawing_context *context)
{
    const struct options *options = &drawing->options;
    struct easel *easel = memory_new(sizeof *easel);
    struct output_space space =
        picture_space(options, &drawing->model->scene->settings);
    easel->drawing = drawing;
    easel->context = context;
    drawing->model->scene->camera = drawing->camera;
    context->stage(context->told, DRAWING_BUILD);
    bool done = model_build(drawing->model, options, context->diag);
    if (done) {
        canvas_tone(&easel->tone, &space);
        canvas_resize(context->canvas, options->render.width,
                      options->render.height);
        context->stage(context->told, DRAWING_COARSE);
        done = drawing_coarse(drawing, easel) && drawing_fine(drawing, easel);
    }
    memory_free(easel);
    return done;
}

/* As glim's, of a picture that is the file's own view. */
static void drawing_origin(const struct drawing *drawing, struct writer *origin)
{
    const struct options *options = &drawing->options;
    origin_settings(origin, options, drawing->frame, drawing->model->source);
    origin_files(origin, options->parse.asked, drawing->first_file);
    writer_add(origin, "", 1);
}

bool drawing_save(const struct drawing *drawing, const char *name, bool own,
                  struct diag *diag)
{
    const struct image *image = drawing->image;
    struct image *copy = image_new(image->width, image->height);
    size_t pixels = (size_t)image->width * (size_t)image->height;
    struct writer origin = writer_new();
    memcpy(copy->pixels, image->pixels, pixels * 4 * sizeof *copy->pixels);
    if (!own)
        drawing_origin(drawing, &origin);
    const struct picture_file file = { &drawing->options,
                                       &drawing->model->scene->settings, name,
                                       own ? NULL : origin.items };
    bool done = picture_write(copy, &file, diag);
    writer_free(&origin);
    image_free(copy);
    return done;
}
