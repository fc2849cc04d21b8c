/* From a scene to its void: see void.h. */
#include "skeleton/void.h"

#include "base/draw.h"
#include "base/memory.h"
#include "base/warp.h"
#include "skeleton/flood.h"
#include "skeleton/grid.h"
#include "skeleton/matter.h"
#include "skeleton/voxelise.h"

enum {
    NOTES = 5,      /* lights that a warning names */
    GLANCES = 1000, /* voxels from which lights are looked for; and of these */
    GLANCED = 32,
};

/* A black sky lights nothing; without any lamp that is what was meant. */
static bool sky_counts(const struct scene *scene,
                       const struct void_space *space)
{
    return space->light_count == 0 || scene->sky ||
           !settings_sky(&scene->settings) ||
           rgb_peak(colour_rgb(scene->background)) > 0;
}

static bool part_is_lit(const struct void_part *part, bool sky)
{
    return part->lights > 0 || part->emitter || (part->sky && sky);
}

/* Lights that matter holds light nothing. */
static void warn_of_lights(const struct void_space *space,
                           const struct light *lights, struct diag *diag)
{
    for (size_t i = 0; i < space->light_count; i++)
        if (!space->lights[i].outside && space->lights[i].voxel == VOXEL_NONE)
            diag_print(diag, DIAG_WARNING, lights[i].span, NULL,
                       "this light is inside of matter: its light gets to no "
                       "voxel of the void");
}

static void note_lights(const struct void_space *space,
                        const struct light *lights, struct diag *diag)
{
    size_t named = 0;
    for (size_t i = 0; i < space->light_count && named < NOTES; i++) {
        size_t voxel = space->lights[i].voxel;
        if (voxel == VOXEL_NONE)
            continue;
        size_t volume = space->parts[space->label[voxel] - 1].volume;
        diag_print(diag, DIAG_NOTE, lights[i].span, NULL,
                   "this light is shut in, in %zu voxels of void", volume);
        named++;
    }
}

struct void_matter {
    const struct world *world;
    const uint8_t *leaf_marks;
};

static bool voxel_is_shone_at(const struct void_space *space,
                              const struct light *lights,
                              const struct void_matter *matter, size_t voxel)
{
    int at[3];
    voxels_place(&space->voxels, voxel, at);
    vec3 centre = voxels_centre(&space->voxels, at);
    for (size_t i = 0; i < space->light_count && i < GLANCED; i++)
        if (!matter_hides(matter->world, matter->leaf_marks, centre,
                          lights[i].location))
            return true;
    return false;
}

/* Whether a ray from there leaves the scene: what is outside looks in. */
static bool voxel_looks_out(const struct void_space *space,
                            const struct void_matter *matter, size_t voxel)
{
    const struct voxels *v = &space->voxels;
    const struct draws draws = { 0, (uint32_t)voxel };
    double u[2], far = v->edge * (v->size[0] + v->size[1] + v->size[2]);
    int at[3];
    voxels_place(v, voxel, at);
    draw_pair(&draws, 0, u);
    vec3 centre = voxels_centre(v, at);
    vec3 beyond = vec3_along(centre, warp_sphere(u), far);
    return !matter_hides(matter->world, matter->leaf_marks, centre, beyond);
}

/* Whether lamps or the sky light what is outside. */
static bool outside_is_lit(const struct void_space *space, bool sky)
{
    for (size_t i = 0; i < space->light_count; i++)
        if (space->lights[i].outside)
            return true;
    for (size_t i = 0; i < space->part_count; i++)
        if (space->parts[i].sky && part_is_lit(&space->parts[i], sky))
            return true;
    return false;
}

/* Whether light gets into the camera's part by ways that are narrower than
 * voxels: a lamp shines in through slits, or what it shines on outside, as
 * between the slats of a blind. */
static bool camera_is_shone_at(const struct void_space *space,
                               const struct light *lights,
                               const struct void_matter *matter, bool sky)
{
    size_t count = voxels_count(&space->voxels), volume = 0, seen = 0;
    bool outside = outside_is_lit(space, sky);
    for (size_t i = 0; i < space->part_count; i++)
        volume += space->parts[i].camera ? space->parts[i].volume : 0;
    for (size_t i = 0; i < count; i++) {
        uint32_t label = space->label[i];
        if (label && space->parts[label - 1].camera &&
            seen++ % (1 + volume / GLANCES) == 0 &&
            (voxel_is_shone_at(space, lights, matter, i) ||
             (outside && voxel_looks_out(space, matter, i))))
            return true;
    }
    return false;
}

/* Whether any light gets to the camera, which is also told if none does. */
static void look_for_light(struct void_space *space, const struct scene *scene,
                           const struct light *lights,
                           const struct void_matter *matter, struct diag *diag)
{
    bool found = false, sky = sky_counts(scene, space);
    if (scene->camera.mesh) /* it looks from anywhere */
        return;
    for (size_t i = 0; i < space->part_count; i++) {
        const struct void_part *part = &space->parts[i];
        if (part->camera && part_is_lit(part, sky))
            return;
        found |= part->camera;
    }
    if (camera_is_shone_at(space, lights, matter, sky))
        return;
    space->dark = found;
    diag_print(diag, DIAG_WARNING, span_none(), NULL,
               found ? "no light gets into the part of the void that the "
                       "camera is in: put a light_source there"
                     : "the camera is inside of matter");
    note_lights(space, lights, diag);
}

struct void_space *void_new(const struct scene *scene,
                            const struct world *world, struct grid_wish wish,
                            unsigned threads, const atomic_int *stop,
                            struct diag *diag)
{
    struct void_space *space = memory_new(sizeof *space);
    struct voxels *v = &space->voxels;
    if (!grid_place(v, world, &scene->camera, wish, diag)) {
        void_free(space);
        return NULL;
    }
    size_t count = voxels_count(v);
    struct arena *arena = arena_new(0);
    const uint8_t *leaf_marks = matter_marks(world, voxels_box(v), arena);
    uint8_t *marks = memory_new(count);
    voxelise(world, v, leaf_marks, threads, stop, marks);
    v->empty = memory_new(count);
    for (size_t i = 0; i < count; i++)
        v->empty[i] = marks[i] == 0;
    struct flood flood = { .space = space,
                           .world = world,
                           .leaf_marks = leaf_marks,
                           .voxel_marks = marks,
                           .stop = stop };
    flood_space(&flood, &scene->camera);
    memory_free(marks);
    if (stop && atomic_load(stop)) {
        arena_free(arena);
        void_free(space);
        return NULL;
    }
    const struct void_matter matter = { world, leaf_marks };
    const struct light *lights = world_lights(world, &count);
    warn_of_lights(space, lights, diag);
    look_for_light(space, scene, lights, &matter, diag);
    arena_free(arena);
    return space;
}

void void_free(struct void_space *space)
{
    if (!space)
        return;
    memory_free(space->voxels.empty);
    memory_free(space->label);
    memory_free(space->parts);
    memory_free(space->lights);
    memory_free(space);
}

size_t void_facing(const struct void_space *space, vec3 point, vec3 normal)
{
    static const double steps[] = { 0.5, 1, 1.5, 2, 3 };
    const struct voxels *v = &space->voxels;
    for (int i = 0; i < 5; i++) {
        vec3 p = vec3_along(point, normal, steps[i] * v->edge);
        size_t index = voxels_empty_at(v, p);
        if (index != VOXEL_NONE)
            return index;
        if (i == 2) {
            index = voxels_empty_beside(v, point, normal);
            if (index != VOXEL_NONE)
                return index;
        }
    }
    return VOXEL_NONE;
}
