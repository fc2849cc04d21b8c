/* cutaway_textures: a part of a CSG object that has no texture is seen with
 * those of the parts that it cuts. */
#include "scene/cutaway.h"
#include "scene/object_probe.h"

#include "parse/rules.h"
#include "scene/object.h"

enum { CUTAWAY_LIMIT = 1000 }; /* parts with textures: a point asks them all */

struct cutaway_builder {
    struct {
        const struct object **items;
        size_t count, capacity;
    } objects;
    struct {
        const struct texture **items; /* the first: where no object is */
        size_t count, capacity;
    } textures;
};

static bool cutaway_add(struct parser *p, struct cutaway_builder *b,
                        const struct object *part,
                        const struct texture *texture, const affine *outward)
{
    if (b->objects.count == CUTAWAY_LIMIT)
        return error_at(p, p->last_span, NULL,
                        "'cutaway_textures' looks at most at %d parts that "
                        "have textures",
                        CUTAWAY_LIMIT);
    struct object *moved = object_copy(p->scene_arena, part);
    object_move(p->scene_arena, moved, outward);
    *ARRAY_PUSH(p->scene_arena, &b->objects) = moved;
    *ARRAY_PUSH(p->scene_arena, &b->textures) = texture;
    return true;
}

/* All below the node, whose children's space `outward` leads from to the CSG
 * object's own; `texture`, there, is what they have if they have none of their
 * own. What is taken away gives nothing. */
static bool cutaway_gather(struct parser *p, struct cutaway_builder *b,
                           const struct object *node,
                           const struct texture *texture, const affine *outward)
{
    bool ok = true;
    for (size_t i = 0; ok && i < node->more->child_count; i++) {
        const struct object *child = node->more->children[i];
        const struct texture *own = texture;
        if (child->inverse)
            continue;
        if (child->texture) {
            affine to = affine_compose(*outward, *child->maps->texture);
            own = texture_moved(p->scene_arena, child->texture, &to);
        }
        affine both = affine_compose(*outward, *child->maps->own);
        if (child->more->child_count > 0 &&
            (!own || child->kind == OBJECT_UNION))
            ok = cutaway_gather(p, b, child, own, &both);
        else if (own)
            ok = cutaway_add(p, b, child, own, outward);
    }
    return ok;
}

bool cutaway_textures(struct parser *p, struct object *object)
{
    struct cutaway_builder b = { .objects = { NULL, 0, 0 } };
    affine unmoved = affine_identity();
    if (object->texture || object->more->child_count == 0)
        return true;
    *ARRAY_PUSH(p->scene_arena, &b.textures) = texture_from_defaults(p);
    if (!cutaway_gather(p, &b, object, NULL, &unmoved))
        return false;
    if (b.objects.count == 0)
        return true;
    object_probe_expect(object, true, p->scene_arena);
    struct cutaway *cutaway = ARENA_NEW(p->scene_arena, struct cutaway);
    *cutaway = (struct cutaway){ b.objects.items, b.objects.count };
    object->texture = texture_by_rule(p, pick_by_insides, cutaway,
                                      b.textures.items, b.textures.count);
    struct object_maps maps = *object->maps;
    maps.texture = maps.own;
    object_place(p->scene_arena, object, maps);
    return object->texture != NULL;
}
