/* Coarse to fine: see drawing.h. */
#include "view/drawing.h"

#include <string.h>

#include "base/clock.h"
#include "base/memory.h"
#include "cli/origin.h"
#include "cli/picture.h"
#include "tracer/integrator.h"
#include "render/overlay.h"
#include "tracer/photons.h"
#include "view/fly.h"

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
    if (drawing->shown.show.arena)
        show_free(&drawing->shown.show);
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

/* Pixels of a picture in which each stands for `step` of `count`. */
static int rough_part(int count, int step)
{
    return (count + step - 1) / step;
}

static void easel_share(void *easel_, double share)
{
    const struct drawing_context *context = ((struct easel *)easel_)->context;
    context->share(context->told, share);
}

/* How a picture is drawn. */
struct draft {
    const struct lighting *lighting;
    int quality;
    int step;                         /* a ray for so many pixels each way */
    const struct lighting_kept *kept; /* or NULL */
};

static struct tracer drawing_tracer(const struct drawing *drawing,
                                    const struct draft *draft,
                                    const atomic_int *stop, struct diag *diag)
{
    const struct options *options = &drawing->options;
    const struct lighting_options light = {
        .threads = options->render.threads,
        .width = rough_part(options->render.width, draft->step),
        .height = rough_part(options->render.height, draft->step),
        .quality = draft->quality,
        .stop = stop,
        .keep = draft->lighting->keep,
        .kept = draft->kept,
        .kept_use = draft->step > 1 ? KEPT_ONLY : KEPT_SAME,
    };
    struct model *model = drawing->model;
    return (struct tracer){
        .scene = model->scene,
        .world = model->world,
        .lighting = draft->lighting,
        .lighting_state =
            draft->lighting->start(model->world, model->scene, &light, diag),
        .quality = draft->quality,
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

/* A rough picture by that tracer, whose lighting is finished. */
static bool rough_draw(struct drawing *drawing, struct easel *easel,
                       const struct tracer *tracer, int step,
                       const atomic_int *stop)
{
    struct render_options render = drawing->options.render;
    if (!tracer->lighting_state)
        return false;
    easel->step = step;
    render.width = rough_part(render.width, step);
    render.height = rough_part(render.height, step);
    render.column_start /= step;
    render.row_start /= step;
    render.column_end = rough_part(render.column_end, step);
    render.row_end = rough_part(render.row_end, step);
    render.antialias = false;
    render.stop = stop;
    render.drawn = easel_put;
    render.drawn_context = easel;
    struct image *image = image_new(render.width, render.height);
    bool done = render_run(tracer, &render, image, NULL);
    image_free(image);
    tracer->lighting->finish(tracer->lighting_state);
    return done;
}

static bool drawing_rough(struct drawing *drawing, struct easel *easel,
                          const struct rough *rough, const atomic_int *stop)
{
    struct diag silent = { .out = NULL };
    const struct draft draft = { lighting_find("rays"),
                                 rough_quality(drawing, rough), rough->step,
                                 NULL };
    const struct tracer tracer = drawing_tracer(drawing, &draft, stop, &silent);
    return rough_draw(drawing, easel, &tracer, rough->step, stop);
}

/* What the drawing before knows of the light here. */
static const struct lighting_kept *
drawing_kept(const struct drawing *drawing,
             const struct drawing_context *context)
{
    const struct heritage *before = context->before;
    const struct lighting *lighting =
        lighting_for(drawing->options.lighting, drawing->model->scene);
    return before && before->lighting == lighting &&
                   before->lamp == drawing->model->lamp
               ? &before->kept
               : NULL;
}

/* Of another view of what the drawing before has lit: a rough picture by what
 * it knows. What stands there at the end must not depend on what was seen
 * before, and so has a mesh of its own. */
static void drawing_as_before(struct drawing *drawing, struct easel *easel,
                              int step)
{
    const struct drawing_context *context = easel->context;
    const struct options *options = &drawing->options;
    const struct lighting_kept *kept = drawing_kept(drawing, context);
    struct diag silent = { .out = NULL };
    if (!kept || !kept->bytes ||
        fly_same(&context->before->camera, &drawing->camera))
        return;
    const struct draft draft = { context->before->lighting, options->quality,
                                 step, kept };
    const struct tracer tracer =
        drawing_tracer(drawing, &draft, context->stop, &silent);
    rough_draw(drawing, easel, &tracer, step, context->stop);
}

/* What was shown before, as this camera sees it, until there is this drawing's
 * own. */
static void drawing_lay(struct drawing *drawing, struct easel *easel)
{
    const struct drawing_context *context = easel->context;
    const struct options *options = &drawing->options;
    const struct model *model = drawing->model;
    const struct tracer eye = { .scene = model->scene, .world = model->world };
    struct render_options render = options->render;
    struct image *image = NULL;
    struct ramp_range range;
    render.stop = context->quit;
    if (heritage_shows(context->before, options) &&
        !camera_is_bent(&drawing->camera)) {
        image = image_new(render.width, render.height);
        overlay_draw(
            &eye, &render, &context->before->shown.show,
            picture_space(options, &model->scene->settings).working_gamma,
            image, &range);
    }
    canvas_lay(context->canvas, &easel->tone, image);
    image_free(image);
}

/* One after the other, while they are quick. */
static bool drawing_coarse(struct drawing *drawing, struct easel *easel)
{
    const struct drawing_context *context = easel->context;
    double last = 0;
    int i;
    drawing_lay(drawing, easel);
    for (i = 0; i < ROUGHS; i++) {
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
    if (!atomic_load(context->stop))
        drawing_as_before(drawing, easel, roughs[i < ROUGHS ? i : i - 1].step);
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
                        context->stop, &drawing->shown, context->diag);
}

static bool drawing_light(struct drawing *drawing,
                          const struct drawing_context *context)
{
    const struct options *options = &drawing->options;
    context->stage(context->told, DRAWING_LIGHT);
    const struct draft draft = {
        lighting_for(options->lighting, drawing->model->scene),
        options->quality, 1, drawing_kept(drawing, context)
    };
    drawing->tracer =
        drawing_tracer(drawing, &draft, context->stop, context->diag);
    if (!drawing->tracer.lighting_state ||
        (!drawing->photons &&
         !photons_send(&drawing->tracer, options->render.threads, context->stop,
                       context->diag, &drawing->photons)))
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
    canvas_lay(context->canvas, &easel->tone, NULL);
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
