/* Poses and looks: see shared.h. */
#include "world/shared.h"

#include "scene/material.h"

const struct pose pose_unmoved = { &affine_unmoved, &affine_unmoved };

const struct pose *shared_pose(struct shared *shared, struct arena *arena,
                               const affine *outward, const affine *kept)
{
    affine inward;
    if (affine_is_identity(*outward))
        return &pose_unmoved;
    for (int i = 0; i < SHARED_RECENT; i++) {
        const struct pose *known = shared->poses[i];
        if (known && memcmp(known->outward, outward, sizeof *outward) == 0)
            return known;
    }
    if (!affine_inverse(*outward, &inward))
        return NULL;
    struct pose *pose = ARENA_NEW(arena, struct pose);
    pose->outward = memcmp(kept, outward, sizeof *kept) == 0
                        ? kept
                        : affine_kept(arena, outward);
    pose->inward = affine_kept(arena, &inward);
    shared->poses[shared->next_pose++ % SHARED_RECENT] = pose;
    return pose;
}

/* What all textures of a look are. */
struct judgement {
    bool mapped; /* by the surface's own coordinates */
    bool opaque, plain, spatial, mirrors;
};

static void judge_texture(struct judgement *all, const struct texture *texture)
{
    all->opaque = all->opaque && texture_is_opaque(texture);
    all->plain = all->plain && texture_is_plain(texture, all->mapped);
    all->spatial = all->spatial && texture_is_spatial(texture);
    all->mirrors = all->mirrors || texture_mirrors(texture);
}

/* Sets what is said of its textures. */
static void look_judge(struct leaf_look *look)
{
    const struct mesh *mesh = look->mesh;
    struct judgement all = { .mapped = look->uv_mapping,
                             .opaque = true,
                             .plain = true,
                             .spatial = !look->uv_mapping };
    judge_texture(&all, look->texture);
    if (look->inner)
        judge_texture(&all, look->inner->texture);
    for (size_t i = 0; mesh && i < mesh->texture_count; i++)
        if (mesh->textures[i])
            judge_texture(&all, mesh->textures[i]);
    look->opaque = all.opaque;
    look->plain = all.plain;
    look->spatial = all.plain && all.spatial;
    look->last = all.plain && all.opaque && !all.mirrors;
    look->coated = look->inner || mesh;
    look->tinted =
        !look->opaque && !look->coated && texture_is_even(look->texture);
    if (look->tinted)
        look->tint =
            texture_transmittance(look->texture, vec3_make(0, 0, 0), NULL);
    look->clear = look->tinted &&
                  rgb_is_black(rgb_sub(look->tint, rgb_grey(1))) &&
                  !all.mirrors && !texture_shines(look->texture) &&
                  (!look->interior || interior_passes(look->interior));
}

const struct leaf_look *shared_look(struct shared *shared, struct arena *arena,
                                    const struct leaf_look *look)
{
    const size_t said = offsetof(struct leaf_look, opaque);
    for (int i = 0; i < SHARED_RECENT; i++)
        if (shared->looks[i] && memcmp(shared->looks[i], look, said) == 0)
            return shared->looks[i];
    struct leaf_look *kept = ARENA_NEW(arena, struct leaf_look);
    memcpy(kept, look, said);
    look_judge(kept);
    return shared->looks[shared->next_look++ % SHARED_RECENT] = kept;
}
