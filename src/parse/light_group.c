/* Light groups: lamps that light nothing but the objects they are grouped
 * with. */
#include "parse/rules.h"

struct members {
    const struct object **items;
    size_t count, capacity;
};

static const struct field group_names[] = {
    { .name = "light_source" }, { .name = "global_lights" },
    { .name = "translate" },    { .name = "rotate" },
    { .name = "scale" },        { .name = NULL },
};

/* light_group_item = object | "global_lights" [bool] | transformation .
 * Transformations move all members, those after them too. */
static bool parse_light_group_item(struct parser *p, struct object *group,
                                   struct members *members)
{
    affine step = affine_identity();
    struct object *member;
    bool on;
    if (accept_keyword(p, KEYWORD_GLOBAL_LIGHTS)) {
        bool ok = parse_bool(p, &on);
        group->no_global_lights = !on;
        return ok;
    }
    if (at_object(p)) {
        if (!parse_object(p, &member))
            return false;
        *ARRAY_PUSH(p->scene_arena, members) = member;
        return object_adopt(p, group, member);
    }
    enum taken taken = parse_transformation(p, &step);
    if (taken == NOT_MINE)
        return error_unknown_thing(p, "light_group", group_names,
                                   "an object or a light group");
    if (taken == TAKEN)
        object_move(p->scene_arena, group, &step);
    return taken;
}

static bool light_group_items(struct parser *p, struct object *group)
{
    struct members members = { NULL, 0, 0 };
    const struct value *value = accept_value(p, VALUE_LIGHT_GROUP);
    group->no_global_lights = true;
    if (value)
        *group = *value->object;
    for (size_t i = 0; i < group->more->child_count; i++)
        *ARRAY_PUSH(p->scene_arena, &members) = group->more->children[i];
    while (stream_peek(p)->kind != TOKEN_RBRACE)
        if (!parse_light_group_item(p, group, &members))
            return false;
    struct object_more *more = object_more(p->scene_arena, group);
    more->children = members.items;
    more->child_count = (unsigned)members.count;
    return true;
}

/* light_group = "light_group" "{" ( LIGHT_GROUP {light_group_item}
 *             | {light_group_item} ) "}" . */
bool parse_light_group(struct parser *p, const struct object **out)
{
    struct span open;
    stream_next(p);
    struct object *group =
        object_new(p->scene_arena, OBJECT_UNION, p->last_span);
    *out = group;
    return block_begin(p, &open) &&
           block_end(p, open, light_group_items(p, group));
}

/* In a union, whose parts keep their group. */
bool parse_light_group_part(struct parser *p, struct object **out)
{
    const struct object *group;
    if (!parse_light_group(p, &group))
        return false;
    *out = object_copy(p->scene_arena, group);
    object_more(p->scene_arena, *out)->light_group = ++p->scene->light_groups;
    return true;
}
