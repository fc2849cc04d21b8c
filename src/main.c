/* glim: scene text -> scene -> world -> picture -> file, for every frame. */
#include <sys/resource.h>

#include "base/jobserver.h"
#include "base/memory.h"
#include "base/parallel.h"
#include "base/save.h"
#include "base/telling.h"
#include "cli/depend.h"
#include "cli/interrupt.h"
#include "cli/json.h"
#include "cli/kept.h"
#include "cli/origin.h"
#include "cli/part.h"
#include "cli/picture.h"
#include "cli/probe_file.h"
#include "cli/progress.h"
#include "cli/stats.h"
#include "cli/watch.h"
#include "lighting/missing.h"
#include "lighting/names.h"
#include "scene/fingerprint.h"
#include "tracer/integrator.h"
#include "tracer/photons.h"

/* Bytes of the first thread's stack that the system takes for the command line
 * and the environment. */
enum { ARGUMENTS_MOST = 6 << 20 };

enum status { DONE = 0, FAILED = 1, INTERRUPTED = 2 };

/* What all frames share. */
struct work {
    struct options options;
    const struct source *source;
    const struct lighting *lighting; /* of this frame's scene */
    struct probe_file points;        /* of --probe */
    struct lighting_kept kept;       /* by the first frame, and those after */
    bool root_tried;                 /* to begin that frame's lighting */
    size_t first_file;               /* of options.parse.asked, for the scene */
    struct targets targets;          /* of --depend: pictures, kept or drawn */
    struct kept pictures;            /* by +C */
    struct writer origin;            /* of the frame's picture */
    struct part part;                /* of it, that is drawn */
    char left[PATH_MAX];             /* the part file that +C goes on with */
    struct unfinished unfinished;    /* picture, if the work was stopped */
    struct progress progress;
    const atomic_int *stop;
    struct diag diag;
    struct arena *arena;
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
        return part_write(&work->part, file.settings, name, file.origin);
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
    const struct picture_file file = { options, settings, name, NULL };
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
    int rows = part_has_bands(options, name) ? part_band_rows(render->width)
                                             : render->height;
    struct image *image = image_new(render->width, rows);
    bool done = frame_pixels(work, tracer, name, image, stats);
    stats_lap(stats, &stats->rendering);
    stats_lighting(stats, tracer);
    if (done)
        done = frame_write(work, tracer, name, image);
    if (!done && atomic_load(work->stop))
        frame_rescue(work, settings, name, image, stats);
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

/* Whether what the lighting method knows after a frame is of use. */
static bool work_keeps(const struct work *work)
{
    const struct options *options = &work->options;
    const struct frames *frames = &options->frames;
    return work->lighting->keep &&
           (options->light.light_mesh.save_file ||
            (frames->animated && frames->last > frames->first));
}

/* What the first frame of an animation has made others may use and add to, and
 * nothing else: so each frame is the same whichever were drawn before it. */
static void frame_keep(struct work *work, const struct tracer *tracer)
{
    if (!work_keeps(work))
        return;
    struct lighting_kept kept = tracer->lighting->keep(tracer->lighting_state);
    if (work->kept.bytes && work->kept.family != kept.family) {
        memory_free(kept.bytes);
        return;
    }
    memory_free(work->kept.bytes);
    work->kept = kept;
}

/* What the frame's scene is told. */
static struct parse_options frame_parsing(const struct work *work, int number)
{
    const struct options *options = &work->options;
    struct parse_options parse = options->parse;
    frames_tell(&options->frames, number, &parse);
    parse.stop = work->stop;
    parse.light_said = &options->light_said;
    parse.light = &options->light;
    return parse;
}

static struct lighting_options frame_lighting(const struct work *work)
{
    const struct options *options = &work->options;
    return (struct lighting_options){ .threads = options->render.threads,
                                      .width = options->render.width,
                                      .height = options->render.height,
                                      .quality = options->quality,
                                      .numbers = options->probe,
                                      .stop = work->stop,
                                      .keep = work_keeps(work),
                                      .kept = &work->kept };
}

static struct world *frame_world(struct work *work, const struct scene *scene)
{
    const struct options *options = &work->options;
    return world_new(scene, options->render.threads,
                     integrator_for(work->lighting)->sample
                         ? 0
                         : render_camera_rays(&options->render),
                     &work->diag);
}

/* Begins the lighting of the first frame, for the points of others. */
static bool root_light(struct work *work, const struct scene *scene)
{
    struct world *world = frame_world(work, scene);
    const struct lighting_options light = frame_lighting(work);
    void *state =
        world ? work->lighting->start(world, scene, &light, &work->diag) : NULL;
    if (state) {
        work->kept = work->lighting->keep(state);
        work->lighting->finish(state);
    }
    world_free(world);
    return state != NULL;
}

static bool fingerprints_same(struct fingerprint a, struct fingerprint b)
{
    return a.objects == b.objects && a.textures == b.textures &&
           a.lights == b.lights && a.surroundings == b.surroundings;
}

/* Before a frame whose animation begins with another, which this process has
 * not drawn: if both show the same things, the other's lighting is begun.
 * Returns false after an error was printed. */
static bool root_make(struct work *work, const struct scene *scene, int number)
{
    const struct options *options = &work->options;
    const struct frames *frames = &options->frames;
    if (!frames->animated || number == frames->first || work->kept.bytes ||
        work->root_tried || !work_keeps(work) ||
        options->light.light_mesh.load_file || options->probe)
        return true;
    work->root_tried = true;
    struct arena *arena = arena_new(0);
    struct parse_options parse = frame_parsing(work, frames->first);
    struct diag quiet = work->diag;
    quiet.quiet_messages = quiet.quiet_warnings = true;
    struct scene *first = parse_scene(work->source, &parse, arena, &quiet);
    bool good = first != NULL;
    if (good && fingerprints_same(scene_fingerprint(scene, true),
                                  scene_fingerprint(first, true)))
        good = root_light(work, first);
    scene_free(first);
    arena_free(arena);
    return good;
}

/* Lights the world. */
static bool frame_light(struct work *work, const struct world *world,
                        const struct scene *scene, const char *name,
                        struct stats *stats)
{
    const struct options *options = &work->options;
    const struct lighting *lighting = work->lighting;
    const struct lighting_options light = frame_lighting(work);
    struct tracer tracer = { .scene = scene,
                             .world = world,
                             .lighting = lighting,
                             .quality = options->quality,
                             .alpha = options->alpha };
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
    if (done)
        frame_keep(work, &tracer);
    photon_map_free(photons);
    lighting->finish(tracer.lighting_state);
    return done;
}

/* Scene to picture or table. */
static bool frame_render(struct work *work, const struct scene *scene,
                         const char *name, struct stats *stats)
{
    const struct options *options = &work->options;
    progress_doing(&work->progress, "building it");
    struct world *world = frame_world(work, scene);
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
static bool frame_make(struct work *work, int number, const char *name,
                       struct arena *sources)
{
    const struct parse_options parse = frame_parsing(work, number);
    const struct options *options = &work->options;
    struct stats stats = stats_start();
    struct scene *scene =
        parse_scene(work->source, &parse, sources, &work->diag);
    bool good = scene && names_good(&scene->settings, &work->diag);
    frame_note_files(work);
    if (!good || options->action == ACTION_CHECK) {
        scene_free(scene);
        return good;
    }
    stats_lap(&stats, &stats.parsing);
    work->lighting = lighting_for(options->lighting, scene);
    bool done = root_make(work, scene, number) &&
                frame_render(work, scene, name, &stats);
    if (done && options->stats)
        (stats_are_json(options) ? stats_json : stats_print)(&stats);
    scene_free(scene);
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

/* One frame of an animation, or the only picture. */
static enum status frame_run(struct work *work, int index)
{
    int number = frames_number(&work->options.frames, index);
    struct arena *arena = arena_new(0);
    const struct options *options = &work->options;
    const char *name =
        frames_name(&options->frames, number, options->output, arena);
    progress_begin(&work->progress, options, name, index);
    bool done = frame_is_there(work, name, number) ||
                (picture_can_be(name, &work->diag) &&
                 frame_make(work, number, name, arena));
    progress_end(&work->progress);
    writer_free(&work->origin);
    name = frames_name(&options->frames, number, options->named, arena);
    if (name && strcmp(name, "-") != 0)
        work_add_target(work, name);
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

/* --join without a name: of all frames' parts. */
static enum status work_join(struct work *work)
{
    const struct options *options = &work->options;
    const struct frames *frames = &options->frames;
    enum status status = DONE;
    if (!options->output || strcmp(options->output, "-") == 0) {
        diag_print(&work->diag, DIAG_ERROR, span_none(), NULL,
                   "--join wants a picture with a name");
        return FAILED;
    }
    for (int i = 0; i < frames_count(frames); i++)
        if (!part_join(frames_name(frames, frames_number(frames, i),
                                   options->output, work->arena),
                       &work->diag))
            status = FAILED;
    return status;
}

static enum status work_run(struct work *work)
{
    struct arena *arena = work->arena;
    const char *problem = NULL;
    const struct frames *frames = &work->options.frames;
    work->first_file = work->options.parse.asked->count;
    file_list_add(work->options.parse.asked, work->options.path);
    work->source =
        source_read(arena, work->options.path, span_none(), &problem);
    if (!work->source && atomic_load(work->stop)) {
        progress_interrupted(frames, 0, &work->unfinished, work->left);
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
            progress_interrupted(frames, i, &work->unfinished, work->left);
        if (status != DONE)
            return status;
    }
    progress_total(&work->progress, frames);
    return work_save(work) &&
                   depend_write(&work->options, &work->targets,
                                work->options.parse.asked, &work->diag)
               ? DONE
               : FAILED;
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
    struct file_list files = { .arena = arena }, seen = { .arena = arena };
    struct work work = { .options.parse.asked = &files,
                         .pictures = { .seen = &seen, .asked = &files },
                         .arena = arena,
                         .diag = diag_new(),
                         .stop = interrupt_catch() };
    bool again = command->told;
    command->status = FAILED;
    if (options_parse(&work.options, command->argc, command->argv, arena,
                      &work.diag)) {
        bool answers = options_answers(&work.options);
        if (!answers)
            command->status = (work.options.join ? work_join : work_run)(&work);
        else if (work.options.action == ACTION_CHECK_PICTURE
                     ? kept_check(work.options.picture, &work.diag)
                 : work.options.action == ACTION_JOIN
                     ? part_join(work.options.picture, &work.diag)
                     : options_answer(&work.options, &work.diag))
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

/* Lets this thread's stack grow as large as those of others, if the system
 * does: one that only waited for another would want to run now and then, and
 * make gave no token for it (base/jobserver.h). */
static bool stack_grows(void)
{
    struct rlimit limit;
    const rlim_t wanted = PARALLEL_STACK + ARGUMENTS_MOST;
    if (getrlimit(RLIMIT_STACK, &limit) != 0)
        return false;
    if (limit.rlim_cur != RLIM_INFINITY && limit.rlim_cur < wanted)
        limit.rlim_cur = wanted;
    return setrlimit(RLIMIT_STACK, &limit) == 0;
}

/* Nested scenes and mirrors that face each other need stack, so all is done on
 * one of known size. */
int main(int argc, char **argv)
{
    struct command command = { .argc = argc, .argv = argv };
    struct diag diag = diag_new();
    if (stack_grows()) {
        command_run(&command);
    } else if (!parallel_call(command_run, &command)) {
        diag_print(&diag, DIAG_ERROR, span_none(), NULL,
                   "the system gives no thread with a stack of %d MiB",
                   PARALLEL_STACK >> 20);
        return FAILED;
    }
    return (int)command.status;
}
