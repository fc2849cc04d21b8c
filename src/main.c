/* glim: scene text -> scene -> world -> picture -> file, for every frame. */
#include "base/memory.h"
#include "base/parallel.h"
#include "base/save.h"
#include "base/telling.h"
#include "cli/interrupt.h"
#include "cli/picture.h"
#include "cli/probe_file.h"
#include "cli/progress.h"
#include "cli/stats.h"
#include "cli/watch.h"
#include "lighting/missing.h"
#include "lighting/names.h"
#include "tracer/integrator.h"

enum status { DONE = 0, FAILED = 1, INTERRUPTED = 2 };

/* What all frames share. */
struct work {
    struct options options;
    const struct source *source;
    struct probe_file points;     /* of --probe */
    struct lighting_kept kept;    /* by the frame before */
    bool kept_told;               /* that a picture kept by +C is old */
    struct unfinished unfinished; /* picture, if the work was stopped */
    struct progress progress;
    const atomic_int *stop;
    struct diag diag;
};

/* Rays to pixels. */
static bool frame_pixels(struct work *work, const struct tracer *tracer,
                         const char *name, struct image *image,
                         struct stats *stats)
{
    struct render_options render = work->options.render;
    render.stop = work->stop;
    render.progress = progress_tell;
    render.passed = progress_passed;
    render.progress_context = &work->progress;
    progress_start(&work->progress);
    struct telling telling = { .out = stdout };
    if (work->options.debug_pixel)
        render.telling = &telling;
    struct image_format format = options_format(&work->options);
    struct background *loading =
        name ? background_start(image_prepare, &format) : NULL;
    bool done = render_run(tracer, &render, image, &stats->rays);
    background_join(loading);
    progress_clear(&work->progress);
    return done;
}

/* World to picture. */
static bool frame_draw(struct work *work, const struct tracer *tracer,
                       const char *name, struct stats *stats)
{
    const struct options *options = &work->options;
    struct image *image =
        image_new(options->render.width, options->render.height);
    bool done = frame_pixels(work, tracer, name, image, stats);
    stats_lap(stats, &stats->rendering);
    stats_lighting(stats, tracer);
    done =
        done && picture_show(image, options, tracer, work->stop, &work->diag);
    if (done)
        done = picture_write(image, options, &tracer->scene->settings, name,
                             &work->diag);
    else if (atomic_load(work->stop))
        picture_rescue(image, options, &tracer->scene->settings, name,
                       &stats->rays, &work->unfinished, &work->diag);
    stats_lap(stats, &stats->writing);
    image_free(image);
    if (done)
        progress_finish(&work->progress, options);
    return done;
}

/* World to a table of light. */
static bool frame_probe(struct work *work, const struct tracer *tracer,
                        const char *name, struct stats *stats)
{
    const struct probe_file *points = &work->points;
    struct render_options render = work->options.render;
    render.stop = work->stop;
    render.progress = progress_tell;
    render.progress_context = &work->progress;
    progress_start(&work->progress);
    struct probe_light *light = memory_new(points->at.count * sizeof *light);
    bool done = probe_run(tracer, &render, points->at.items, points->at.count,
                          light, &stats->rays);
    progress_clear(&work->progress);
    stats_lap(stats, &stats->rendering);
    stats_lighting(stats, tracer);
    done = done && probe_file_write(points, light, name, &work->diag);
    stats_lap(stats, &stats->writing);
    memory_free(light);
    return done;
}

/* Whether what the lighting method knows after a frame is of use. */
static bool work_keeps(const struct work *work)
{
    const struct options *options = &work->options;
    return options->lighting->keep && (options->light.light_mesh.save_file ||
                                       frames_count(&options->frames) > 1);
}

static void frame_keep(struct work *work, const struct tracer *tracer)
{
    if (!work_keeps(work))
        return;
    memory_free(work->kept.bytes);
    work->kept = tracer->lighting->keep(tracer->lighting_state);
}

/* Lights the world. */
static bool frame_light(struct work *work, const struct world *world,
                        const struct scene *scene, const char *name,
                        struct stats *stats)
{
    const struct options *options = &work->options;
    const struct lighting *lighting = options->lighting;
    const struct lighting_options light = { .threads = options->render.threads,
                                            .width = options->render.width,
                                            .height = options->render.height,
                                            .quality = options->quality,
                                            .stop = work->stop,
                                            .keep = work_keeps(work),
                                            .kept = &work->kept };
    struct tracer tracer = { .scene = scene,
                             .world = world,
                             .lighting = lighting,
                             .quality = options->quality,
                             .alpha = options->alpha };
    tracer.lighting_state = lighting->start(world, scene, &light, &work->diag);
    stats_world(stats, world);
    if (!tracer.lighting_state)
        return false;
    bool done =
        (options->probe ? frame_probe : frame_draw)(work, &tracer, name, stats);
    if (done)
        frame_keep(work, &tracer);
    lighting->finish(tracer.lighting_state);
    return done;
}

/* Scene to picture or table. */
static bool frame_render(struct work *work, const struct scene *scene,
                         const char *name, struct stats *stats)
{
    const struct options *options = &work->options;
    const struct lighting *lighting = options->lighting;
    progress_doing(&work->progress, "building it");
    struct world *world = world_new(scene, options->render.threads,
                                    integrator_for(lighting)->sample
                                        ? 0
                                        : render_camera_rays(&options->render),
                                    &work->diag);
    if (!world)
        return false;
    size_t lights;
    world_lights(world, &lights);
    if (!options->probe)
        missing_tell(scene, lights, world_leaf_count(world), &work->diag);
    bool done = frame_light(work, world, scene, name, stats);
    world_free(world);
    return done;
}

/* Text to file. */
static bool frame_make(struct work *work, const struct parse_options *parse,
                       const char *name, struct arena *sources)
{
    const struct options *options = &work->options;
    struct stats stats = stats_start();
    struct scene *scene =
        parse_scene(work->source, parse, sources, &work->diag);
    bool good = scene && names_good(&scene->settings, &work->diag);
    if (!good || options->action == ACTION_CHECK) {
        scene_free(scene);
        return good;
    }
    stats_lap(&stats, &stats.parsing);
    bool done = frame_render(work, scene, name, &stats);
    if (done && options->stats)
        stats_print(&stats);
    scene_free(scene);
    return done;
}

/* One frame of an animation, or the only picture. */
static enum status frame_run(struct work *work, int index)
{
    int number = frames_number(&work->options.frames, index);
    struct arena *arena = arena_new(0);
    const struct options *options = &work->options;
    struct parse_options parse = options->parse;
    frames_tell(&options->frames, number, &parse);
    parse.stop = work->stop;
    parse.light_said = &options->light_said;
    parse.light = &options->light;
    const char *name =
        frames_name(&options->frames, number, options->output, arena);
    progress_begin(&work->progress, options, name, index);
    bool done =
        picture_is_there(options, name, &work->kept_told, &work->diag) ||
        (picture_can_be(name, &work->diag) &&
         frame_make(work, &parse, name, arena));
    progress_end(&work->progress);
    arena_free(arena);
    if (done)
        return DONE;
    return atomic_load(work->stop) ? INTERRUPTED : FAILED;
}

/* --mesh-save, after the last frame. */
static bool work_save(struct work *work)
{
    const char *name = work->options.light.light_mesh.save_file;
    char why[256];
    if (!name || work->options.action != ACTION_RENDER)
        return true;
    if (!work->kept.bytes)
        diag_print(&work->diag, DIAG_WARNING, span_none(), NULL,
                   "nothing was rendered: the light mesh '%s' is not written",
                   name);
    else if (!save_bytes(name, work->kept.bytes, work->kept.size, why,
                         sizeof why)) {
        diag_print(&work->diag, DIAG_ERROR, span_none(), NULL,
                   "can't write the light mesh '%s': %s", name, why);
        return false;
    }
    return true;
}

static enum status work_run(struct work *work, struct arena *arena)
{
    const char *problem = NULL;
    const struct frames *frames = &work->options.frames;
    file_list_add(work->options.parse.asked, work->options.path);
    work->source =
        source_read(arena, work->options.path, span_none(), &problem);
    if (!work->source && atomic_load(work->stop)) {
        progress_interrupted(frames, 0, &work->unfinished);
        return INTERRUPTED;
    }
    if (!work->source) {
        diag_print(&work->diag, DIAG_ERROR, span_none(), NULL,
                   "can't read the scene '%s': %s", work->options.path,
                   problem);
        return FAILED;
    }
    if (work->options.probe)
        file_list_add(work->options.parse.asked, work->options.probe);
    if (work->options.probe && work->options.action == ACTION_RENDER &&
        !probe_file_read(&work->points, work->options.probe, arena,
                         &work->diag))
        return FAILED;
    if (!picture_can_be(work->options.light.light_mesh.save_file,
                        &work->diag) ||
        !picture_can_be(work->options.light.skeleton.save_file, &work->diag))
        return FAILED;
    for (int i = 0; i < frames_count(frames); i++) {
        enum status status =
            atomic_load(work->stop) ? INTERRUPTED : frame_run(work, i);
        if (status == INTERRUPTED)
            progress_interrupted(frames, i, &work->unfinished);
        if (status != DONE)
            return status;
    }
    progress_total(&work->progress, frames);
    return work_save(work) ? DONE : FAILED;
}

/* The command line, and all that it does. */
struct command {
    int argc;
    char **argv;
    enum status status;
    bool told; /* what --watch waits for */
};

/* Says once that it goes on; returns whether it does. */
static bool command_watch(struct command *command, struct work *work)
{
    struct file_list *files = work->options.parse.asked;
    if (!work->options.watch || command->status == INTERRUPTED)
        return false;
    if (!command->told && work->options.warnings)
        diag_print(&work->diag, DIAG_NOTE, span_none(), NULL,
                   "watching %zu file%s; Ctrl-C ends", files->count,
                   files->count == 1 ? "" : "s");
    command->told = true;
    return watch_wait(files, work->stop);
}

/* Returns true for once more. Wrong options are waited for only if an INI file
 * was right before. */
static bool command_once(struct command *command)
{
    struct arena *arena = arena_new(0);
    struct file_list files = { .arena = arena };
    struct work work = { .options.parse.asked = &files,
                         .diag = diag_new(),
                         .stop = interrupt_catch() };
    bool again = command->told;
    command->status = FAILED;
    if (options_parse(&work.options, command->argc, command->argv, arena,
                      &work.diag)) {
        bool answers = options_answers(&work.options);
        if (!answers)
            command->status = work_run(&work, arena);
        else if (options_answer(&work.options, &work.diag))
            command->status = DONE;
        again = !answers;
    }
    memory_free(work.kept.bytes);
    again = again && command_watch(command, &work);
    arena_free(arena);
    return again;
}

static void command_run(void *context)
{
    while (command_once(context))
        continue;
}

/* Nested scenes and mirrors that face each other need stack, so all is done on
 * one of known size. */
int main(int argc, char **argv)
{
    struct command command = { .argc = argc, .argv = argv };
    struct diag diag = diag_new();
    if (!parallel_call(command_run, &command))
        diag_print(&diag, DIAG_ERROR, span_none(), NULL,
                   "the system gives no thread with a stack of %d MiB",
                   PARALLEL_STACK >> 20);
    return (int)command.status;
}
