/* Reading and building: see model.h. */
#include "view/model.h"

#include "base/memory.h"
#include "lighting/missing.h"
#include "lighting/names.h"
#include "tracer/integrator.h"

static bool model_parse(struct model *model, const struct options *options,
                        int frame, const atomic_int *stop, struct diag *diag)
{
    const char *problem = NULL;
    struct parse_options parse = options->parse;
    file_list_add(parse.asked, options->path);
    model->source =
        source_read(model->sources, options->path, span_none(), &problem);
    if (!model->source) {
        diag_print(diag, DIAG_ERROR, span_none(), NULL,
                   "can't read the scene '%s': %s", options->path, problem);
        return false;
    }
    frames_tell(&options->frames, frame, &parse);
    parse.stop = stop;
    parse.light_said = &options->light_said;
    parse.light = &options->light;
    model->scene = parse_scene(model->source, &parse, model->sources, diag);
    if (options->light.light_mesh.load_file)
        file_list_add(parse.asked, options->light.light_mesh.load_file);
    return model->scene && names_good(&model->scene->settings, diag);
}

static void model_change(struct model *model,
                         const struct model_changes *changes)
{
    struct scene *scene = model->scene;
    struct light_mesh_settings *mesh = &scene->settings.light_mesh;
    for (int i = 0; i < changes->region_count; i++)
        *ARRAY_PUSH(scene->arena, &mesh->regions) = changes->regions[i];
    model->lamp = changes->lamp;
}

struct model *model_read(const struct options *options, int frame,
                         const struct model_changes *changes,
                         const atomic_int *stop, struct diag *diag)
{
    struct model *model = memory_new(sizeof *model);
    model->sources = arena_new(0);
    atomic_init(&model->users, 1);
    if (model_parse(model, options, frame, stop, diag)) {
        model->camera = model->scene->camera;
        model_change(model, changes);
        return model;
    }
    model_leave(model);
    return NULL;
}

bool model_build(struct model *model, const struct options *options,
                 struct diag *diag)
{
    size_t lights;
    if (model->world)
        return true;
    bool samples = integrator_for(options->lighting)->sample;
    model->world =
        world_new(model->scene, options->render.threads,
                  samples ? 0 : render_camera_rays(&options->render), diag);
    if (!model->world)
        return false;
    world_lights(model->world, &lights);
    if (model->lamp > 0 && (size_t)model->lamp <= lights)
        world_solo(model->world, (size_t)model->lamp - 1);
    missing_tell(model->scene, lights, world_leaf_count(model->world), diag);
    return true;
}

struct model *model_use(struct model *model)
{
    if (model)
        atomic_fetch_add(&model->users, 1);
    return model;
}

void model_leave(struct model *model)
{
    if (!model || atomic_fetch_sub(&model->users, 1) > 1)
        return;
    world_free(model->world);
    scene_free(model->scene);
    arena_free(model->sources);
    memory_free(model);
}
