/* union, merge, intersection, difference. */
#include "parse/rules.h"
#include "scene/object_probe.h"

struct csg {
    const char *name;
    struct object *object;
    struct {
        const struct object **items;
        size_t count, capacity;
    } children;
};

static enum object_kind csg_kind(enum keyword keyword)
{
    switch (keyword) {
    case KEYWORD_MERGE:
        return OBJECT_MERGE;
    case KEYWORD_INTERSECTION:
    case KEYWORD_DIFFERENCE:
        return OBJECT_INTERSECTION;
    default:
        return OBJECT_UNION;
    }
}

/* Whether a point is in an intersection asks each part for its inside. */
static void csg_check_solid(struct parser *p, const struct csg *csg,
                            const struct object *child)
{
    if (csg->object->kind == OBJECT_INTERSECTION && child->patch)
        warning_at(p, child->span, NULL,
                   "this has no inside: it can't be a part of '%s'", csg->name);
}

static bool csg_add(struct parser *p, struct csg *csg, bool difference)
{
    struct object *child;
    if (!parse_object(p, &child))
        return false;
    if (csg->object->kind == OBJECT_UNION)
        child = object_seen(p, child);
    csg_check_solid(p, csg, child);
    if (difference && csg->children.count > 0)
        child->inverse = !child->inverse;
    *ARRAY_PUSH(p->scene_arena, &csg->children) = child;
    return object_adopt(p, csg->object, child);
}

static bool csg_items(struct parser *p, struct csg *csg, bool difference)
{
    while (at_object(p))
        if (!csg_add(p, csg, difference))
            return false;
    if (!csg->children.count && stream_peek(p)->kind == TOKEN_RBRACE)
        warning_at(p, csg->object->span, NULL, "this '%s' is empty", csg->name);
    if (difference && csg->children.count == 1)
        warning_at(p, csg->object->span,
                   "difference { box {...} sphere {...} }",
                   "nothing is taken away: this 'difference' has one object");
    struct object *object = csg->object;
    struct object_more *more = object_more(p->scene_arena, object);
    more->children = csg->children.items;
    more->child_count = (unsigned)csg->children.count;
    if (more->child_count >= CHILD_PROBES_LEAST &&
        object->kind != OBJECT_INTERSECTION)
        more->probes = ARENA_NEW(p->scene_arena, struct child_probes);
    struct modifiers m = { .object = object, .block = csg->name };
    return parse_modifiers(p, &m);
}

/* csg = ( "union" | "merge" | "intersection" | "difference" )
 *       "{" {object} {modifier} "}" .
 * A difference is the intersection with the insides out of all but the first.
 */
bool parse_csg(struct parser *p, struct object **out)
{
    struct token word = stream_next(p);
    struct span open;
    struct csg csg = {
        .name = word.word->text,
        .object = object_new(p->scene_arena, csg_kind(word.word->keyword),
                             p->last_span),
    };
    object_more(p->scene_arena, csg.object)->parts = 0;
    *out = csg.object;
    return block_begin(p, &open) &&
           block_end(
               p, open,
               csg_items(p, &csg, word.word->keyword == KEYWORD_DIFFERENCE));
}
