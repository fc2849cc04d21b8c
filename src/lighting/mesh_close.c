/* The closing skeleton: see mesh_close.h. */
#include "lighting/mesh_close.h"

#include "lighting/mesh_survey.h"
#include "lightmesh/tuning.h"

bool mesh_close_make(struct void_skeleton *close, const struct world *world,
                     const struct scene *scene,
                     const struct lighting_options *options,
                     const struct pieces_kept *root, struct diag *diag)
{
    const struct light_mesh_settings *said = &scene->settings.light_mesh;
    struct void_skeleton_wish wish = { .resolution = CLOSE_VOXELS,
                                       .still = true,
                                       .rays = CLOSE_RAYS * mesh_times(options),
                                       .root = root };
    *close = (struct void_skeleton){ NULL, NULL };
    if (!said->indirect.on || !said->indirect.skeleton)
        return true;
    return void_skeleton_make(close, world, scene, wish, options, diag);
}

bool mesh_close_light(const void *context, struct worker *worker, vec3 place,
                      vec3 normal, vec3 from, rgb *light)
{
    return skeleton_close(context, worker, place, normal, from, light);
}

bool mesh_close_knows(const struct void_skeleton *close,
                      const struct survey *survey, struct worker *worker)
{
    int known = 0;
    for (int i = 0; close->skeleton && i < survey->hits; i++) {
        const struct bright_hit *hit = &survey->hit[i];
        rgb light;
        known +=
            mesh_close_light(close->skeleton, worker, bright_hit_place(hit),
                             hit->normal, hit->origin, &light);
    }
    return CHAMBER_KNOWN * (survey->hits - known) <= survey->hits;
}
