/* Frames without pictures: see moment.h. */
#include "cli/moment.h"

#include <string.h>

#include "base/array.h"
#include "cli/work.h"
#include "tracer/integrator.h"

bool moment_keeps(const struct work *work)
{
    const struct options *options = &work->options;
    const struct frames *frames = &options->frames;
    return work->lighting->keep &&
           (options->light.light_mesh.save_file ||
            (frames->animated && frames->last > frames->first));
}

struct parse_options moment_parsing(const struct work *work, int number)
{
    const struct options *options = &work->options;
    struct parse_options parse = options->parse;
    frames_tell(&options->frames, number, &parse);
    parse.stop = work->stop;
    parse.light_said = &options->light_said;
    parse.light = &options->light;
    return parse;
}

struct lighting_options moment_lighting(const struct work *work)
{
    const struct options *options = &work->options;
    return (struct lighting_options){ .threads = options->render.threads,
                                      .width = options->render.width,
                                      .height = options->render.height,
                                      .quality = options->quality,
                                      .numbers = options->probe,
                                      .stop = work->stop,
                                      .keep = moment_keeps(work),
                                      .kept = &work->kept,
                                      .root = options->frames.animated };
}

struct world *moment_world(const struct work *work, const struct scene *scene,
                           struct diag *diag)
{
    const struct options *options = &work->options;
    return world_new(scene, options->render.threads,
                     integrator_for(work->lighting)->sample
                         ? 0
                         : render_camera_rays(&options->render),
                     diag);
}

/* A diag_listener. */
static void moment_hear(void *context, enum diag_level level, struct span span,
                        const char *hint, const char *text)
{
    struct moment *moment = context;
    *ARRAY_PUSH(moment->arena, &moment->messages) = (struct moment_message){
        level, span,
        hint ? arena_copy_text(moment->arena, hint, strlen(hint)) : NULL,
        arena_copy_text(moment->arena, text, strlen(text))
    };
}

/* A work's diag that keeps what it hears. */
static struct diag moment_diag(struct moment *moment, const struct work *work)
{
    struct diag diag = work->diag;
    diag.listen = moment_hear;
    diag.listener = moment;
    return diag;
}

void moment_read(struct moment *moment, const struct work *work, int number,
                 struct diag *diag)
{
    struct parse_options parse = moment_parsing(work, number);
    struct diag kept = moment_diag(moment, work);
    *moment = (struct moment){ .number = number, .arena = arena_new(0) };
    moment->asked.arena = moment->arena;
    parse.asked = &moment->asked;
    moment->scene =
        parse_scene(work->source, &parse, moment->arena, diag ? diag : &kept);
}

const struct fingerprint *moment_print(struct moment *moment)
{
    if (moment->scene && !moment->printed)
        moment->print = scene_fingerprint(moment->scene, true);
    moment->printed = true;
    return &moment->print;
}

void moment_tell(struct moment *moment, struct diag *diag)
{
    for (; moment->messages.told < moment->messages.count;
         moment->messages.told++) {
        const struct moment_message *message =
            &moment->messages.items[moment->messages.told];
        diag_print(diag, message->level, message->span, message->hint, "%s",
                   message->text);
    }
}

void moment_light(struct moment *moment, const struct work *work)
{
    struct lighting_options light = moment_lighting(work);
    struct diag kept = moment_diag(moment, work), silent = work->diag;
    silent.listen = NULL;
    silent.out = NULL;
    light.smooths = work->smooths;
    moment->lighting = work->lighting;
    moment->world = moment_world(work, moment->scene, &kept);
    if (moment->world)
        moment->state = work->lighting->start(moment->world, moment->scene,
                                              &light, &silent);
}

void moment_free(struct moment *moment)
{
    if (moment->state)
        moment->lighting->finish(moment->state);
    world_free(moment->world);
    scene_free(moment->scene);
    if (moment->arena)
        arena_free(moment->arena);
    *moment = (struct moment){ .arena = NULL };
}
