/* One frame: see frame.h. */
#include "cli/frame.h"

#include "base/jobserver.h"
#include "base/memory.h"
#include "base/parallel.h"
#include "base/telling.h"
#include "cli/json.h"
#include "cli/moments.h"
#include "cli/origin.h"
#include "cli/stats.h"
#include "lighting/missing.h"
#include "lighting/names.h"
#include "scene/fingerprint.h"
#include "tracer/integrator.h"
#include "tracer/photons.h"

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
    render.keeper = &work->part.keeper;
    progress_start(&work->progress, tracer);
    struct telling telling = { .out = stdout };
    if (work->options.debug_pixel)
        render.telling = &telling;
    struct image_format format = options_format(&work->options);
    struct background *loading = name && jobserver_state() == JOBSERVER_NONE
                                     ? background_start(image_prepare, &format)
                                     : NULL;
    bool done = render_run(tracer, &render, image, &stats->rays);
    background_join(loading);
    progress_clear(&work->progress);
    return done;
}

/* What was drawn becomes the picture's file; of a part there is none. */
static bool frame_write(struct work *work, const struct tracer *tracer,
                        const char *name, struct image *image)
{
    const struct options *options = &work->options;
    const struct picture_file file = { options, &tracer->scene->settings, name,
                                       work->origin.items };
    if (options->render.share.count)
        return true;
    if (part_has_bands(options, name))
        return part_write(&work->part, file.settings, name, file.origin, image);
    part_make_room(&work->part);
    return picture_show(image, options, tracer, work->stop, NULL,
                        &work->diag) &&
           picture_write(image, &file, &work->diag);
}

/* After an interruption: what there is, for the eye and for +C. */
static void frame_rescue(struct work *work, const struct settings *settings,
                         const char *name, struct image *image,
                         const struct stats *stats)
{
    const struct options *options = &work->options;
    const struct picture_file file = { options, settings, name,
                                       work->origin.items };
    if (!options->render.share.count && !part_has_bands(options, name))
        picture_rescue(image, &file, &stats->rays, &work->unfinished,
                       &work->diag);
    if (part_is_left(&work->part))
        strcpy(work->left, work->part.path);
}

/* World to picture. */
static bool frame_draw(struct work *work, const struct tracer *tracer,
                       const char *name, struct stats *stats)
{
    const struct options *options = &work->options;
    const struct render_options *render = &options->render;
    const struct settings *settings = &tracer->scene->settings;
    if (!part_start(&work->part, options, settings, name, work->origin.items,
                    &work->diag))
        return false;
    int rows = part_has_bands(options, name)
                   ? part_band_rows(render, render->width)
                   : render->height;
    struct image *image = image_new(render->width, rows);
    bool done = frame_pixels(work, tracer, name, image, stats);
    stats_lap(stats, &stats->rendering);
    stats_lighting(stats, tracer);
    stats_keeper(stats, &work->part.keeper);
    if (done)
        done = frame_write(work, tracer, name, image);
    if (!done && atomic_load(work->stop))
        frame_rescue(work, settings, name, image, stats);
    else if (!done && part_is_left(&work->part))
        progress_left(work->part.path);
    if (done && !render->share.count)
        picture_forget_unfinished(name);
    done = part_finish(&work->part, done) && done;
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
    progress_start(&work->progress, tracer);
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

/* What the root of an animation has made others may use and add to, and
 * nothing else: so each frame is the same whichever were drawn before it.
 * Another frame's is only for --mesh-save. */
static void frame_keep(struct work *work, const struct tracer *tracer)
{
    if (!moment_keeps(work))
        return;
    struct lighting_kept kept = tracer->lighting->keep(tracer->lighting_state);
    lighting_forget(&work->last);
    if (!work->kept.bytes || work->kept.family == kept.family) {
        lighting_forget(&work->kept);
        work->kept = kept;
    } else if (work->options.light.light_mesh.save_file) {
        work->last = kept;
    } else {
        lighting_forget(&kept);
    }
}

/* Lights the world. */
static bool frame_light(struct work *work, const struct world *world,
                        const struct scene *scene,
                        const struct lighting_moments *around, const char *name,
                        struct stats *stats)
{
    const struct options *options = &work->options;
    const struct lighting *lighting = work->lighting;
    struct lighting_options light = moment_lighting(work);
    struct tracer tracer = { .scene = scene,
                             .world = world,
                             .lighting = lighting,
                             .quality = options->quality,
                             .alpha = options->alpha };
    light.moments = around;
    tracer.lighting_state = lighting->start(world, scene, &light, &work->diag);
    stats_world(stats, world);
    if (!tracer.lighting_state)
        return false;
    struct photon_map *photons = NULL;
    bool done = photons_send(&tracer, options->render.threads, work->stop,
                             &work->diag, &photons);
    tracer.photons = photons;
    done = done && (options->probe ? frame_probe : frame_draw)(work, &tracer,
                                                               name, stats);
    if (done && around->count == 0)
        frame_keep(work, &tracer);
    photon_map_free(photons);
    lighting->finish(tracer.lighting_state);
    return done;
}

/* Scene to picture or table. */
static bool frame_render(struct work *work, struct moment *now,
                         const char *name, struct stats *stats)
{
    const struct options *options = &work->options;
    struct lighting_moments around;
    progress_doing(&work->progress, "building it");
    moments_around(work, now, &around);
    struct world *own =
        now->world ? NULL : moment_world(work, now->scene, &work->diag);
    const struct world *world = now->world ? now->world : own;
    moment_tell(now, &work->diag);
    if (!world)
        return false;
    size_t lights;
    world_lights(world, &lights);
    if (!options->probe)
        missing_tell(now->scene, lights, world_leaf_count(world), &work->diag);
    bool done = frame_light(work, world, now->scene, &around, name, stats);
    world_free(own);
    return done;
}

/* All that the picture is made of is known once the scene has been read. */
static void frame_note_files(struct work *work)
{
    const struct options *options = &work->options;
    const char *mesh = options->light.light_mesh.load_file;
    if (mesh)
        file_list_add(options->parse.asked, mesh);
    if (options->output)
        origin_files(&work->origin, options->parse.asked, work->first_file);
    writer_add(&work->origin, "", 1);
}

static bool stats_are_json(const struct options *options)
{
    return options->stats_form && strcmp(options->stats_form, "json") == 0;
}

/* Text to file. */
static bool frame_make(struct work *work, const char *name)
{
    const struct options *options = &work->options;
    struct stats stats = stats_start();
    struct moment *now = moments_now(work);
    bool good = now->scene && names_good(&now->scene->settings, &work->diag);
    frame_note_files(work);
    if (!good || options->action == ACTION_CHECK)
        return good;
    stats_lap(&stats, &stats.parsing);
    work->lighting = lighting_for(options->lighting, now->scene);
    moments_root(work, now);
    bool done = frame_render(work, now, name, &stats);
    if (done && options->stats)
        (stats_are_json(options) ? stats_json : stats_print)(&stats);
    return done;
}

/* Begins the origin of the frame's picture. Returns whether +C finds that the
 * picture is there. */
static bool frame_is_there(struct work *work, const char *name, int number)
{
    const struct options *options = &work->options;
    work->origin = writer_new();
    file_list_next(options->parse.asked);
    file_list_add(options->parse.asked, options->path);
    origin_settings(&work->origin, options, number, work->source);
    if (!options->continue_trace || options->render.share.count)
        return false;
    const char *settings =
        arena_copy_text(work->arena, work->origin.items, work->origin.count);
    return kept_picture(&work->pictures, options, name, settings, &work->diag);
}

/* What was written: the picture, or a part of it. */
static void work_add_target(struct work *work, const char *name)
{
    char path[PATH_MAX];
    if (work->options.render.share.count) {
        part_name(&work->options, name, path);
        name = path;
    }
    *ARRAY_PUSH(work->arena, &work->targets) =
        arena_copy_text(work->arena, name, strlen(name));
}

enum work_status frame_run(struct work *work, int index)
{
    const int number = frames_number(&work->options.frames, index);
    struct arena *arena = arena_new(0);
    const struct options *options = &work->options;
    const char *name =
        frames_name(&options->frames, number, options->output, arena);
    work->number = number;
    progress_begin(&work->progress, options, name, index);
    bool done = frame_is_there(work, name, number) ||
                (picture_can_be(name, &work->diag) && frame_make(work, name));
    moments_pass(work);
    progress_end(&work->progress);
    writer_free(&work->origin);
    name = frames_name(&options->frames, number, options->named, arena);
    if (name && strcmp(name, "-") != 0)
        work_add_target(work, name);
    arena_free(arena);
    if (done)
        return WORK_DONE;
    return atomic_load(work->stop) ? WORK_INTERRUPTED : WORK_FAILED;
}
