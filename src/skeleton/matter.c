/* Matter or void: see matter.h. A pigment may let light pass here and stop it
 * there; it counts as what it does on the mean, at points spread evenly. */
#include "skeleton/matter.h"

#include "base/random.h"
#include "scene/mesh.h"
#include "shade/surface.h"

enum { TRANSMITTANCE_SAMPLES = 64 };

static bool texture_is_void(const struct texture *texture,
                            const affine *to_texture, struct box3 box)
{
    double sum = 0;
    vec3 size = vec3_sub(box.high, box.low);
    if (texture_is_opaque(texture))
        return false;
    for (unsigned i = 0; i < TRANSMITTANCE_SAMPLES; i++) {
        vec3 r = { random_unit(random_key(i, 0)), random_unit(random_key(i, 1)),
                   random_unit(random_key(i, 2)) };
        vec3 point = vec3_add(box.low, vec3_mul(size, r));
        sum += rgb_brightness(texture_transmittance(
            texture, affine_point(to_texture, point), NULL));
    }
    return sum > 0.5 * TRANSMITTANCE_SAMPLES;
}

uint8_t matter_of_texture(const struct texture *texture,
                          const affine *to_texture, struct box3 box)
{
    if (texture_is_void(texture, to_texture, box))
        return 0;
    for (size_t i = 0; i < texture->count; i++)
        if (rgb_peak(texture->layers[i].finish->emission) > 0)
            return MATTER_WALL | MATTER_EMITTER;
    return MATTER_WALL;
}

struct marking {
    struct box3 space;
    uint8_t *marks;
};

static void mark_leaf(const struct marking *marking, const struct leaf *leaf,
                      struct box3 box)
{
    box = box3_intersection(box, marking->space);
    if (leaf->look->no_shadow || box3_is_empty(box))
        return;
    marking->marks[leaf->number] =
        matter_of_texture(leaf->look->texture, leaf->look->to_texture, box);
}

static void mark_mesh(void *context, const struct leaf *leaf)
{
    mark_leaf(context, leaf,
              affine_box(leaf->pose->outward, leaf->object->mesh->bounds));
}

static void mark_part(struct marking *marking, const struct solid *solid,
                      const struct pose *frame)
{
    struct box3 box = solid->surface;
    if (frame && solid->parent)
        box = affine_box(frame->outward, box);
    if (solid->leaf)
        mark_leaf(marking, solid->leaf, box);
    for (size_t i = 0; i < solid->child_count; i++)
        mark_part(marking, solid->children[i], frame);
}

static void mark_solid(void *context, const struct solid *solid)
{
    mark_part(context, solid, solid->more->frame);
}

const uint8_t *matter_marks(const struct world *world, struct box3 space,
                            struct arena *arena)
{
    struct marking marking = { space, ARENA_ARRAY(arena, uint8_t,
                                                  world_leaf_count(world)) };
    world_visit(world, mark_solid, mark_mesh, &marking);
    return marking.marks;
}

static bool has_mark(void *context, const struct ray *ray,
                     const struct world_hit *hit)
{
    const uint8_t *const *marks = context;
    (void)ray;
    return (*marks)[hit->leaf->number] != 0;
}

bool matter_hides(const struct world *world, const uint8_t *marks, vec3 from,
                  vec3 to)
{
    vec3 way = vec3_sub(to, from);
    double distance = vec3_length(way);
    struct ray ray = { from, vec3_normalise(way) };
    return distance > 0 &&
           world_occluded(world, &(struct occlusion){ .ray = &ray,
                                                      .tmax = distance,
                                                      .light = -1,
                                                      .filter = has_mark,
                                                      .context = &marks });
}
