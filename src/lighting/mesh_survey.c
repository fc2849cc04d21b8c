/* A look at indirect light: see mesh_survey.h. */
#include "lighting/mesh_survey.h"

#include "lightmesh/tuning.h"

int mesh_times(const struct lighting_options *options)
{
    return options->root ? CHAMBER_ANIMATED : 1;
}

enum plan_film mesh_film(const struct lighting_options *options)
{
    return !options->root     ? PLAN_ALONE
           : options->smooths ? PLAN_SMOOTHED
                              : PLAN_FILM;
}

void mesh_look(struct mesh_lighting *mesh, const struct scene *scene,
               const struct lighting_options *options,
               const struct survey *known)
{
    struct gather gather = {
        .lamps = &mesh->lamps,
        .emitters = mesh->emitters,
        .ambience = &mesh->ambience,
        .tone = scene->settings.light_mesh.indirect.tone,
    };
    struct worker worker = { .stop = options->stop, .scratch = arena_new(0) };
    struct survey_options look = { .rays = SURVEY_RAYS, .known = known };
    struct survey survey = { .open = 1 };
    if (options->numbers)
        survey = survey_none();
    else if (scene->settings.light_mesh.indirect.on)
        survey = survey_of(&gather, scene, &worker, &look);
    /* Where one bounce brings next to nothing more may: round two corners; and
     * what glows lights what rays meet in no other way. */
    gather.onward =
        survey.stays && (survey.worth < gather_worth_none ||
                         (!survey.closed && emitters_any(mesh->emitters)));
    if (survey.closed && !options->numbers) {
        look = (struct survey_options){ .rays = CHAMBER_RAYS,
                                        .known = known,
                                        .times = mesh_times(options) };
        survey = survey_of(&gather, scene, &worker, &look);
        /* Closer, where some of the light comes in through a window. */
        look.rays = BRIGHT_RAYS;
        if (survey.bright.count > 0) {
            virtual_lights_free(survey.lights);
            survey = survey_of(&gather, scene, &worker, &look);
        }
    } else if (gather.onward) {
        look.times = mesh_times(options);
        survey = survey_of(&gather, scene, &worker, &look);
    }
    arena_free(worker.scratch);
    mesh->virtual_lights = survey.lights;
    mesh->survey = survey;
    mesh->survey.lights = NULL;
}

void mesh_virtual_again(struct mesh_lighting *mesh,
                        const struct lighting_options *options)
{
    const struct mesh_frame *frame = &mesh->stamp.frame;
    struct worker worker = { .stop = options->stop, .scratch = arena_new(0) };
    virtual_lights_free(mesh->virtual_lights);
    mesh->virtual_lights = NULL;
    if (frame->lit.count > 0 && frame->samples > 0)
        mesh->virtual_lights = virtual_lights_new(&frame->lit, &mesh->lamps,
                                                  mesh_times(options), &worker);
    arena_free(worker.scratch);
}
