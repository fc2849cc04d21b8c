/* Meshes of several moments: see mesh_moments.h. */
#include "lighting/mesh_moments.h"

#include "lighting/names.h"

_Static_assert((int)LIGHTING_MOMENTS <= (int)MOMENTS_MOST, "each has a place");

/* Whether points of one name are in one place, and know of the same. */
static bool meshes_agree(const struct mesh_lighting *a,
                         const struct mesh_lighting *b)
{
    const struct mesh_frame *x = &a->stamp.frame, *y = &b->stamp.frame;
    return b->indirect && mesh_stamp_alike(&a->stamp, &b->stamp) &&
           x->gather <= y->gather && x->gather >= y->gather &&
           x->closed == y->closed && a->ambience.sky == b->ambience.sky;
}

static void mesh_smooth(struct mesh_lighting *mesh,
                        const struct lighting_moments *moments)
{
    struct indirect_moments found = { .count = 0 };
    for (size_t i = 0; i < moments->count; i++) {
        const struct mesh_lighting *other = moments->state[i];
        if (!meshes_agree(mesh, other))
            continue;
        if (i == moments->now)
            found.now = found.count;
        found.at[found.count].mesh = other->indirect;
        found.at[found.count++].weight = moments->weight[i];
    }
    indirect_mesh_smooth(mesh->indirect, &found);
}

bool mesh_by_moments(struct mesh_lighting *mesh, const struct scene *scene,
                     const struct lighting_options *options, struct diag *diag)
{
    const struct lighting_moments *moments = options->moments;
    if (!moments || moments->count == 0)
        return false;
    const struct mesh_lighting *now = moments->state[moments->now];
    mesh->now = now;
    mesh->film = now->film;
    mesh->stamp = now->stamp;
    mesh->levels = now->levels;
    mesh->survey = now->survey;
    mesh->virtual_lights = now->virtual_lights;
    mesh->close = now->close;
    mesh->ambience.everywhere = now->ambience.everywhere;
    mesh_make(mesh, scene, names_interpolation(&scene->settings, diag));
    if (mesh->indirect)
        mesh_smooth(mesh, moments);
    return true;
}
