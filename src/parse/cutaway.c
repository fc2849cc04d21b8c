/* cutaway_textures: a part of a CSG object that has no texture is seen with
 * those of the parts that it cuts. */
#include "scene/cutaway.h"

#include "parse/rules.h"
#include "scene/object.h"

enum { CUTAWAY_LIMIT = 64 }; /* parts with textures */

struct cutaway_builder {
    struct cutaway cutaway;
    const struct texture *textures[CUTAWAY_LIMIT + 1];
};

static void cutaway_add(struct parser *p, struct cutaway_builder *b,
                        const struct object *part,
                        const struct texture *texture, const affine *outward)
{
    struct object *moved = object_copy(p->scene_arena, part);
    if (b->cutaway.count == CUTAWAY_LIMIT)
        return;
    object_move(p->scene_arena, moved, outward);
    b->cutaway.objects[b->cutaway.count++] = moved;
    b->textures[b->cutaway.count] = texture;
}

/* All below the node, whose children's space `outward` leads from to the CSG
 * object's own; `texture`, there, is what they have if they have none of their
 * own. What is taken away gives nothing. */
static void cutaway_gather(struct parser *p, struct cutaway_builder *b,
                           const struct object *node,
                           const struct texture *texture, const affine *outward)
{
    for (size_t i = 0; i < node->child_count; i++) {
        const struct object *child = node->children[i];
        const struct texture *own = texture;
        if (child->inverse)
            continue;
        if (child->texture) {
            affine to = affine_compose(*outward, *child->texture_transform);
            own = texture_moved(p->scene_arena, child->texture, &to);
        }
        affine both = affine_compose(*outward, *child->transform);
        if (child->child_count > 0 && (!own || child->kind == OBJECT_UNION))
            cutaway_gather(p, b, child, own, &both);
        else if (own)
            cutaway_add(p, b, child, own, outward);
    }
}

bool cutaway_textures(struct parser *p, struct object *object)
{
    struct cutaway_builder *b =
        ARENA_NEW(p->scene_arena, struct cutaway_builder);
    affine unmoved = affine_identity();
    if (object->texture || object->child_count == 0)
        return true;
    b->cutaway.objects =
        ARENA_ARRAY(p->scene_arena, const struct object *, CUTAWAY_LIMIT);
    b->textures[0] = texture_from_defaults(p);
    cutaway_gather(p, b, object, NULL, &unmoved);
    if (b->cutaway.count == 0)
        return true;
    object->texture = texture_by_rule(p, pick_by_insides, &b->cutaway,
                                      b->textures, b->cutaway.count + 1);
    object->texture_transform = object->transform;
    return object->texture != NULL;
}
