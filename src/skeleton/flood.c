/* Flood fill from seeds: see flood.h. Surfaces are supercovers, so the void's
 * parts connected over faces and over corners are the same across each. */
#include "skeleton/flood.h"

#include "base/memory.h"
#include "skeleton/matter.h"

enum {
    SEED_REACH = 3,  /* voxels that a seed in matter looks around */
    EYES = 8,        /* places along a side of an orthographic camera */
    BORDER_STEPS = 8 /* places along a border where what is outside looks in */
};

/* The label of voids that nothing lights: inside of glowing bodies. */
static const uint32_t dark = UINT32_MAX;

static const int faces[6][3] = { { -1, 0, 0 }, { 1, 0, 0 },  { 0, -1, 0 },
                                 { 0, 1, 0 },  { 0, 0, -1 }, { 0, 0, 1 } };

/* A search for leaves that have one of the marks. */
struct search {
    const uint8_t *marks;
    uint8_t wanted;
    bool found;
};

static void front_add(struct front *front, size_t voxel)
{
    if (front->count == front->capacity) {
        front->capacity = 2 * front->capacity + 1024;
        front->voxels = memory_resize(front->voxels,
                                      front->capacity * sizeof *front->voxels);
    }
    front->voxels[front->count++] = (uint32_t)voxel;
}

static bool is_free(const struct flood *flood, size_t voxel)
{
    return flood->space->voxels.empty[voxel] && !flood->space->label[voxel];
}

/* Labels the free neighbours of a voxel. */
static void spread_from(struct flood *flood, size_t voxel, uint32_t label,
                        struct void_part *part, struct front *reached)
{
    const struct voxels *v = &flood->space->voxels;
    int at[3];
    voxels_place(v, voxel, at);
    for (int i = 0; i < 6; i++) {
        int next[3] = { at[0] + faces[i][0], at[1] + faces[i][1],
                        at[2] + faces[i][2] };
        if (!voxels_holds(v, next)) {
            part->sky = true;
            continue;
        }
        size_t index = voxels_index(v, next[0], next[1], next[2]);
        if (!is_free(flood, index))
            continue;
        flood->space->label[index] = label;
        front_add(reached, index);
    }
}

/* Labels all that is connected, as a wave from the seed. */
static void spread(struct flood *flood, size_t seed, uint32_t label,
                   struct void_part *part)
{
    struct front *last = &flood->front[0], *now = &flood->front[1];
    flood->space->label[seed] = label;
    last->count = 0;
    front_add(last, seed);
    while (last->count > 0 && !(flood->stop && atomic_load(flood->stop))) {
        now->count = 0;
        part->volume += last->count;
        for (size_t i = 0; i < last->count; i++)
            spread_from(flood, last->voxels[i], label, part, now);
        struct front *swap = last;
        last = now;
        now = swap;
    }
}

/* The part that an empty voxel is in; a new one if it was not reached yet. */
static struct void_part *part_of(struct flood *flood, size_t voxel)
{
    struct void_space *space = flood->space;
    uint32_t label = space->label[voxel];
    if (label)
        return &space->parts[label - 1];
    if (space->part_count == flood->part_capacity) {
        flood->part_capacity = 2 * flood->part_capacity + 16;
        space->parts = memory_resize(space->parts, flood->part_capacity *
                                                       sizeof *space->parts);
    }
    struct void_part *part = &space->parts[space->part_count++];
    *part = (struct void_part){ 0 };
    spread(flood, voxel, (uint32_t)space->part_count, part);
    return part;
}

/* The nearest empty voxel not farther than SEED_REACH from the point, one that
 * the point sees if there is any. */
static size_t nearest_empty(const struct flood *flood, vec3 point,
                            const int *around, bool seen)
{
    const struct voxels *v = &flood->space->voxels;
    size_t best = VOXEL_NONE;
    double least = HUGE_VAL;
    int at[3], r = SEED_REACH;
    for (at[2] = around[2] - r; at[2] <= around[2] + r; at[2]++)
        for (at[1] = around[1] - r; at[1] <= around[1] + r; at[1]++)
            for (at[0] = around[0] - r; at[0] <= around[0] + r; at[0]++) {
                if (!voxels_holds(v, at))
                    continue;
                size_t index = voxels_index(v, at[0], at[1], at[2]);
                vec3 centre = voxels_centre(v, at);
                vec3 d = vec3_sub(centre, point);
                double distance = vec3_dot(d, d);
                if (!v->empty[index] || distance >= least ||
                    (seen && matter_hides(flood->world, flood->leaf_marks,
                                          point, centre)))
                    continue;
                least = distance;
                best = index;
            }
    return best;
}

/* The voxel of a point inside of the grid, or VOXEL_NONE. */
static size_t seed_voxel(const struct flood *flood, vec3 point)
{
    const struct voxels *v = &flood->space->voxels;
    int at[3];
    if (!voxels_find(v, point, at))
        return VOXEL_NONE;
    size_t index = voxels_index(v, at[0], at[1], at[2]);
    if (v->empty[index])
        return index;
    index = nearest_empty(flood, point, at, true);
    return index == VOXEL_NONE ? nearest_empty(flood, point, at, false) : index;
}

/* What a visitor from outside does to each part it sees into. */
typedef void part_visit(struct void_part *part);

static void add_light(struct void_part *part)
{
    part->lights++;
}

static void add_camera(struct void_part *part)
{
    part->camera = true;
}

struct outsider {
    vec3 place;
    part_visit *visit;
    uint8_t *seen; /* parts already visited, by number; grows with them */
    size_t seen_count;
};

static void look_into(struct flood *flood, struct outsider *outsider,
                      const int *at)
{
    const struct voxels *v = &flood->space->voxels;
    size_t index = voxels_index(v, at[0], at[1], at[2]);
    uint32_t label = flood->space->label[index];
    if (!v->empty[index] || label == dark ||
        (label && label <= outsider->seen_count && outsider->seen[label - 1]))
        return;
    if (matter_hides(flood->world, flood->leaf_marks, outsider->place,
                     voxels_centre(v, at)))
        return;
    outsider->visit(part_of(flood, index));
    label = flood->space->label[index];
    if (flood->space->part_count > outsider->seen_count) {
        size_t count = flood->space->part_count;
        outsider->seen = memory_resize(outsider->seen, count);
        for (size_t i = outsider->seen_count; i < count; i++)
            outsider->seen[i] = 0;
        outsider->seen_count = count;
    }
    outsider->seen[label - 1] = 1;
}

/* Looks into the grid from a place outside, at points spread over the border.
 */
static void look_in(struct flood *flood, vec3 place, part_visit *visit)
{
    const struct voxels *v = &flood->space->voxels;
    struct outsider outsider = { place, visit, NULL, 0 };
    for (int face = 0; face < 6; face++) {
        int axis = face / 2, at[3];
        int a = (axis + 1) % 3, b = (axis + 2) % 3;
        at[axis] = face % 2 ? v->size[axis] - 1 : 0;
        for (int i = 0; i < BORDER_STEPS; i++)
            for (int j = 0; j < BORDER_STEPS; j++) {
                at[a] = (2 * i + 1) * v->size[a] / (2 * BORDER_STEPS);
                at[b] = (2 * j + 1) * v->size[b] / (2 * BORDER_STEPS);
                look_into(flood, &outsider, at);
            }
    }
    memory_free(outsider.seen);
}

static bool is_outside(const struct flood *flood, vec3 point)
{
    int at[3];
    return !voxels_find(&flood->space->voxels, point, at);
}

static void flood_from_lights(struct flood *flood)
{
    struct void_space *space = flood->space;
    const struct light *lights =
        world_lights(flood->world, &space->light_count);
    space->lights = memory_new(space->light_count * sizeof *space->lights);
    for (size_t i = 0; i < space->light_count; i++) {
        struct void_light *light = &space->lights[i];
        light->outside = is_outside(flood, lights[i].location);
        light->voxel = seed_voxel(flood, lights[i].location);
        if (light->outside)
            look_in(flood, lights[i].location, add_light);
        else if (light->voxel != VOXEL_NONE)
            part_of(flood, light->voxel)->lights++;
    }
}

static void note_leaf(void *context, const struct leaf *leaf)
{
    struct search *search = context;
    search->found |= (search->marks[leaf->number] & search->wanted) != 0;
}

static bool is_inside(const struct flood *flood, vec3 point, uint8_t wanted)
{
    struct search search = { flood->leaf_marks, wanted, false };
    world_containing(flood->world, point, note_leaf, &search);
    return search.found;
}

/* The void beside a voxel of an emitter, unless that is the emitter's own
 * inside. */
static void flood_beside(struct flood *flood, const int *at)
{
    const struct voxels *v = &flood->space->voxels;
    for (int i = 0; i < 6; i++) {
        int next[3] = { at[0] + faces[i][0], at[1] + faces[i][1],
                        at[2] + faces[i][2] };
        if (!voxels_holds(v, next))
            continue;
        size_t index = voxels_index(v, next[0], next[1], next[2]);
        struct void_part ignored = { 0 };
        if (!v->empty[index] || flood->space->label[index] == dark)
            continue;
        if (is_free(flood, index) &&
            is_inside(flood, voxels_centre(v, next), MATTER_EMITTER))
            spread(flood, index, dark, &ignored);
        else
            part_of(flood, index)->emitter = true;
    }
}

static void flood_from_emitters(struct flood *flood)
{
    const struct voxels *v = &flood->space->voxels;
    size_t count = voxels_count(v);
    for (size_t i = 0; i < count; i++) {
        int at[3];
        if (!(flood->voxel_marks[i] & MATTER_EMITTER))
            continue;
        voxels_place(v, i, at);
        flood_beside(flood, at);
    }
}

/* A glowing body around the camera is a room that it lights, not the dark. */
static void flood_around(struct flood *flood, vec3 eye)
{
    const struct voxels *v = &flood->space->voxels;
    size_t voxel = seed_voxel(flood, eye);
    int at[3];
    if (voxel == VOXEL_NONE || !is_free(flood, voxel))
        return;
    voxels_place(v, voxel, at);
    if (is_inside(flood, voxels_centre(v, at), MATTER_EMITTER))
        part_of(flood, voxel);
}

/* The camera, or one of the places that an orthographic one looks from: these
 * may lie within walls and behind them, so only what is `lit` counts at first.
 */
static void flood_from_eye(struct flood *flood, vec3 eye, bool lit)
{
    struct void_space *space = flood->space;
    size_t voxel = seed_voxel(flood, eye);
    if (is_outside(flood, eye))
        look_in(flood, eye, add_camera);
    if (voxel == VOXEL_NONE || space->label[voxel] == dark ||
        (lit && is_free(flood, voxel)))
        return;
    part_of(flood, voxel)->camera = true;
    if (space->camera == VOXEL_NONE)
        space->camera = voxel;
}

static bool has_camera(const struct void_space *space)
{
    for (size_t i = 0; i < space->part_count; i++)
        if (space->parts[i].camera)
            return true;
    return false;
}

static void flood_from_camera(struct flood *flood, const struct camera *camera)
{
    flood->space->camera = VOXEL_NONE;
    flood_from_eye(flood, camera->location, true);
    for (int i = 0; i < EYES && camera->kind->lines == CAMERA_PARALLEL; i++)
        for (int j = 0; j < EYES; j++) {
            struct ray ray =
                camera_ray(camera, (i + 0.5) / EYES, (j + 0.5) / EYES);
            if (!is_outside(flood, ray.origin))
                flood_from_eye(flood, ray.origin, true);
        }
    if (!has_camera(flood->space))
        flood_from_eye(flood, camera->location, false);
}

void flood_space(struct flood *flood, const struct camera *camera)
{
    struct void_space *space = flood->space;
    size_t count = voxels_count(&space->voxels);
    space->label = memory_new(count * sizeof *space->label);
    flood_from_lights(flood);
    flood_around(flood, camera->location);
    flood_from_emitters(flood);
    flood_from_camera(flood, camera);
    for (size_t i = 0; i < count; i++) {
        if (space->label[i] == dark)
            space->label[i] = 0;
        space->voxels.empty[i] = space->label[i] != 0;
    }
    for (int i = 0; i < 2; i++)
        memory_free(flood->front[i].voxels);
}
