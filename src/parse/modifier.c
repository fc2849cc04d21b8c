/* What may follow in an object's block: where it is, what it is made of, how
 * it is cut and seen. */
#include "parse/expression.h"
#include "parse/rules.h"

static const struct field modifier_names[] = {
    { .name = "translate" },
    { .name = "rotate" },
    { .name = "scale" },
    { .name = "matrix" },
    { .name = "transform" },
    { .name = "texture" },
    { .name = "interior_texture" },
    { .name = "pigment" },
    { .name = "normal" },
    { .name = "finish" },
    { .name = "interior" },
    { .name = "material" },
    { .name = "clipped_by" },
    { .name = "bounded_by" },
    { .name = "inverse" },
    { .name = "hollow" },
    { .name = "no_shadow" },
    { .name = "no_image" },
    { .name = "no_reflection" },
    { .name = "double_illuminate" },
    { .name = "uv_mapping" },
    { .name = NULL },
};

/* These stand where the block's next words are written. */
static void object_paint(struct parser *p, struct object *object,
                         const struct texture *texture)
{
    struct object_maps maps = *object->maps;
    maps.texture = &affine_unmoved;
    object->texture = texture;
    object_place(p->scene_arena, object, maps);
}

static void object_paint_inside(struct parser *p, struct object *object,
                                const struct texture *texture)
{
    struct object_maps maps = *object->maps;
    maps.inner = &affine_unmoved;
    object_more(p->scene_arena, object)->inner = texture;
    object_place(p->scene_arena, object, maps);
}

static void object_fill(struct parser *p, struct object *object,
                        const struct interior *interior)
{
    struct object_maps maps = *object->maps;
    maps.interior = &affine_unmoved;
    object_more(p->scene_arena, object)->interior = interior;
    object_place(p->scene_arena, object, maps);
}

/* The object's texture, moved to there. */
static const struct texture *object_texture_here(struct parser *p,
                                                 struct object *object)
{
    const struct texture *texture = object->texture;
    if (!texture)
        texture = texture_from_defaults(p);
    else if (!affine_is_identity(*object->maps->texture))
        texture = texture_moved(p->scene_arena, texture, object->maps->texture);
    object_paint(p, object, texture);
    return texture;
}

/* A second texture is painted over the first. */
static void object_set_texture(struct parser *p, struct object *object,
                               const struct texture *texture)
{
    if (object->texture)
        texture = texture_stack(p, object_texture_here(p, object), texture);
    object_paint(p, object, texture);
}

static bool modifier_material(struct parser *p, struct object *object)
{
    struct material material = { NULL };
    if (!parse_material(p, &material))
        return false;
    if (material.texture)
        object_set_texture(p, object, material.texture);
    if (material.interior)
        object_fill(p, object, material.interior);
    if (material.interior_texture)
        object_paint_inside(p, object, material.interior_texture);
    return true;
}

/* Layers are in the space the last one is written in. */
static bool object_interior_texture(struct parser *p, struct object *object)
{
    const struct texture *inner = object->more->inner;
    if (inner && !affine_is_identity(*object->maps->inner))
        inner = texture_moved(p->scene_arena, inner, object->maps->inner);
    if (!parse_interior_texture(p, &inner))
        return false;
    object_paint_inside(p, object, inner);
    return true;
}

static bool object_interior(struct parser *p, struct object *object)
{
    const struct interior *interior = object->more->interior;
    if (!parse_interior(p, &interior))
        return false;
    object_fill(p, object, interior);
    return true;
}

/* covering = texture | interior_texture | texture_part | interior | material .
 */
static enum taken parse_covering(struct parser *p, struct object *object)
{
    const struct texture *texture;
    switch (stream_keyword(p)) {
    case KEYWORD_TEXTURE:
        if (!parse_texture(p, &texture))
            return WRONG;
        object_set_texture(p, object, texture);
        return TAKEN;
    case KEYWORD_PIGMENT:
    case KEYWORD_NORMAL:
    case KEYWORD_FINISH:
        texture = object_texture_here(p, object);
        if (!parse_texture_part(p, &texture))
            return WRONG;
        object->texture = texture;
        return TAKEN;
    case KEYWORD_INTERIOR_TEXTURE:
        return object_interior_texture(p, object);
    case KEYWORD_INTERIOR:
        return object_interior(p, object);
    case KEYWORD_MATERIAL:
        return modifier_material(p, object);
    default:
        return NOT_MINE;
    }
}

static void clip_list_move(struct clip_list *list, const affine *transform)
{
    for (size_t i = 0; i < list->count; i++)
        list->items[i].transform =
            affine_compose(*transform, list->items[i].transform);
}

static bool clip_add(struct parser *p, struct clip_list *list)
{
    struct object *object;
    if (!parse_object(p, &object))
        return false;
    if (object->patch)
        return error_at(p, object->span, NULL,
                        "this has no inside: it can't clip or bound");
    *ARRAY_PUSH(p->scene_arena, list) =
        (struct clip){ .object = object, .transform = affine_identity() };
    return true;
}

/* clip_body = object {object} {transformation} . */
static bool parse_clip_body(struct parser *p, struct clip_list *list,
                            const char *block)
{
    do
        if (!clip_add(p, list))
            return false;
    while (at_object(p));
    while (stream_peek(p)->kind != TOKEN_RBRACE) {
        affine step = affine_identity();
        enum taken taken = parse_transformation(p, &step);
        if (taken == NOT_MINE)
            return error_unknown_item(p, block, NULL);
        if (taken == WRONG)
            return false;
        clip_list_move(list, &step);
    }
    return true;
}

/* Adds to the `count` clips or bounds at `items`, of the object's own, which
 * may be shared with a declared object. */
static bool object_add_list(struct parser *p, struct object *object,
                            const struct clip_list *list,
                            const struct clip **items, unsigned *count)
{
    struct clip *all =
        ARENA_ARRAY(p->scene_arena, struct clip, *count + list->count);
    if (*count)
        memcpy(all, *items, *count * sizeof *all);
    for (size_t i = 0; i < list->count; i++) {
        all[*count + i] = list->items[i];
        if (!object_adopt(p, object, list->items[i].object))
            return false;
    }
    *items = all;
    *count += (unsigned)list->count;
    return true;
}

/* clipped_by = "clipped_by" "{" ( "bounded_by" | clip_body ) "}" . */
static bool parse_clipped_by(struct parser *p, struct modifiers *m)
{
    struct clip_list list = { .count = 0 };
    struct span open;
    stream_next(p);
    if (!block_begin(p, &open))
        return false;
    bool bounds = accept_keyword(p, KEYWORD_BOUNDED_BY);
    bool ok = bounds || parse_clip_body(p, &list, "clipped_by");
    struct object_more *more = object_more(p->scene_arena, m->object);
    return block_end(p, open, ok) &&
           object_add_list(p, m->object, bounds ? &m->bounds : &list,
                           &more->clips, &more->clip_count);
}

/* bounded_by = "bounded_by" "{" ( "clipped_by" | clip_body ) "}" .
 * Meant for POV-Ray's speed, but a bound too small cuts a picture. */
static bool parse_bounded_by(struct parser *p, struct modifiers *m)
{
    struct clip_list list = { .count = 0 };
    struct span open;
    stream_next(p);
    if (!block_begin(p, &open))
        return false;
    bool ok = accept_keyword(p, KEYWORD_CLIPPED_BY) ||
              parse_clip_body(p, &list, "bounded_by");
    for (size_t i = 0; i < list.count; i++)
        *ARRAY_PUSH(p->scene_arena, &m->bounds) = list.items[i];
    struct object_more *more = object_more(p->scene_arena, m->object);
    return block_end(p, open, ok) &&
           object_add_list(p, m->object, &list, &more->bounds,
                           &more->bound_count);
}

/* flag = "inverse" | "hollow" [bool] | "double_illuminate" [bool]
 *      | "no_shadow" | "no_image" | "no_reflection" | "uv_mapping" . */
static enum taken parse_flag(struct parser *p, struct object *object)
{
    bool on = false;
    if (accept_keyword(p, KEYWORD_INVERSE)) {
        object->inverse = !object->inverse;
    } else if (accept_keyword(p, KEYWORD_HOLLOW)) {
        bool ok = parse_bool(p, &on);
        object->has_hollow = true;
        object->hollow = on;
        return ok;
    } else if (accept_keyword(p, KEYWORD_DOUBLE_ILLUMINATE)) {
        bool ok = parse_bool(p, &on);
        object->double_illuminate = on;
        return ok;
    } else if (accept_keyword(p, KEYWORD_NO_SHADOW)) {
        object->no_shadow = true;
    } else if (accept_keyword(p, KEYWORD_NO_IMAGE)) {
        object->no_image = true;
    } else if (accept_keyword(p, KEYWORD_UV_MAPPING)) {
        object->uv_mapping = true;
    } else if (accept_keyword(p, KEYWORD_NO_REFLECTION)) {
        object->no_reflection = true;
    } else {
        return NOT_MINE;
    }
    return TAKEN;
}

static bool modifier_skip_block(struct parser *p)
{
    struct span open;
    stream_next(p);
    return block_begin(p, &open) && block_end(p, open, skip_block(p));
}

/* modifier_without_effect = "sturm" [bool] | "hierarchy" [bool]
 *                         | "split_union" [bool] | "no_radiosity"
 *                         | "radiosity" "{" {name [float]} "}"
 *                         | colour .
 * The picture is the same without them. */
static enum taken parse_modifier_without_effect(struct parser *p)
{
    bool ignored;
    colour no_colour;
    switch (stream_keyword(p)) {
    case KEYWORD_STURM:
    case KEYWORD_HIERARCHY:
    case KEYWORD_SPLIT_UNION:
        stream_next(p);
        return parse_bool(p, &ignored);
    case KEYWORD_NO_RADIOSITY:
        stream_next(p);
        return TAKEN;
    case KEYWORD_RADIOSITY:
        return modifier_skip_block(p);
    default:
        if (!colour_begins(stream_keyword(p)))
            return NOT_MINE;
        warning_at(p, stream_span(p),
                   arena_printf(p->arena, "pigment { %s ... }",
                                stream_peek(p)->word->text),
                   "a colour belongs into a pigment; this one is ignored");
        return parse_colour(p, &no_colour);
    }
}

static enum taken parse_steps(struct parser *p, struct object_step *step)
{
    bool alike = true, some = false;
    enum taken taken = TAKEN;
    step->all = step->alike = affine_identity();
    for (;;) {
        taken = parse_transformation_alike(p, &step->all, &alike);
        if (taken != TAKEN)
            return taken == NOT_MINE && some ? TAKEN : taken;
        some = true;
        if (alike)
            step->alike = step->all;
    }
}

/* Together: each for itself would cost the object a matrix. */
enum taken parse_moves(struct parser *p, struct modifiers *m)
{
    struct object_step step;
    affine inverse;
    struct span span = stream_span(p);
    bool moved = m->object->maps->own != &affine_unmoved;
    enum taken taken = parse_steps(p, &step);
    if (taken != TAKEN)
        return taken;
    object_move_step(p->scene_arena, m->object, &step);
    clip_list_move(&m->bounds, &step.all);
    return !moved || affine_inverse(*m->object->maps->own, &inverse) ||
           error_at(p, span_join(span, p->last_span), NULL,
                    "all transformations together leave nothing of this "
                    "object: their numbers are too large or too small");
}

static bool at_no_triangle(struct parser *p)
{
    return stream_keyword(p) != KEYWORD_TRIANGLE &&
           stream_keyword(p) != KEYWORD_SMOOTH_TRIANGLE && at_object(p);
}

static bool modifier_unknown(struct parser *p, const struct modifiers *m)
{
    if (strcmp(m->block, "mesh") == 0 && at_no_triangle(p))
        return error_at(p, stream_span(p), "union { mesh { ... } ... }",
                        "a mesh holds triangles only; other objects are put "
                        "together with it in a 'union'");
    if (m->object->kind != OBJECT_SHAPE && at_object(p)) {
        bool one = strcmp(m->block, "object") == 0;
        error_at(p, stream_span(p), one ? "union { ... }" : NULL,
                 one ? "'%s' is of one object, and this is another"
                     : "the objects of '%s' come before its modifiers",
                 m->block);
        note_unclosed(p);
        return false;
    }
    if (stream_keyword(p) == KEYWORD_CONTAINED_BY &&
        strcmp(m->block, "isosurface") == 0)
        return error_at(p, stream_span(p), NULL,
                        "'contained_by' comes before what moves and colours "
                        "the isosurface");
    return error_unknown_item(p, m->block, modifier_names);
}

/* What is said twice is said together. */
static bool modifier_photons(struct parser *p, struct object *object)
{
    struct photon_flags *flags = ARENA_NEW(p->scene_arena, struct photon_flags);
    struct object_more *more = object_more(p->scene_arena, object);
    *flags = more->photons ? *more->photons : photon_flags_default;
    more->photons = flags;
    return parse_photon_flags(p, flags);
}

/* modifier = transformation | covering | clipped_by | bounded_by | flag
 *          | "cutaway_textures" | PRIMITIVE_ITEM | photon_flags |
 * modifier_without_effect . PRIMITIVE_ITEM is what the primitive's table has,
 * like "open". */
static bool parse_modifier(struct parser *p, struct modifiers *m)
{
    enum taken taken = parse_moves(p, m);
    if (taken == NOT_MINE)
        taken = parse_covering(p, m->object);
    if (taken != NOT_MINE)
        return taken;
    const struct field *field = accept_field(p, m->items);
    if (field)
        return parse_field(p, field, m->shape);
    taken = parse_flag(p, m->object);
    if (taken != NOT_MINE)
        return taken;
    if (stream_keyword(p) == KEYWORD_CLIPPED_BY)
        return parse_clipped_by(p, m);
    if (stream_keyword(p) == KEYWORD_BOUNDED_BY)
        return parse_bounded_by(p, m);
    if (stream_keyword(p) == KEYWORD_PHOTONS)
        return modifier_photons(p, m->object);
    if (accept_keyword(p, KEYWORD_CUTAWAY_TEXTURES))
        return m->cutaway = true;
    taken = parse_modifier_without_effect(p);
    return taken != NOT_MINE ? taken : modifier_unknown(p, m);
}

/* Old scenes say the interior's ior in the finish. */
static void object_old_ior(struct parser *p, struct object *object)
{
    double ior = 0, caustics = 0;
    for (size_t i = 0; object->texture && i < object->texture->count; i++) {
        const struct finish *finish = object->texture->layers[i].finish;
        ior = finish->ior > 0 ? finish->ior : ior;
        caustics = finish->caustics > 0 ? finish->caustics : caustics;
    }
    if ((ior == 0 && caustics == 0) || object->more->interior)
        return;
    struct interior *interior = ARENA_NEW(p->scene_arena, struct interior);
    *interior = interior_default();
    interior->ior = ior > 0 ? ior : interior->ior;
    interior->caustics = caustics / 45; /* broader than there (measured) */
    object_more(p->scene_arena, object)->interior = interior;
}

/* What an inside has a texture for has one outside, too: before or after it. */
static bool inside_has_outside(struct parser *p, const struct modifiers *m)
{
    return !m->inner.source || m->object->texture ||
           error_at(p, m->inner, "texture { ... }",
                    "with an 'interior_texture' there must be a texture for "
                    "the outside");
}

bool parse_modifiers(struct parser *p, struct modifiers *m)
{
    while (stream_peek(p)->kind != TOKEN_RBRACE) {
        struct span at = stream_span(p);
        bool had = m->object->more->inner;
        if (!parse_modifier(p, m))
            return false;
        if (!had && m->object->more->inner)
            m->inner = at;
    }
    if (!inside_has_outside(p, m))
        return false;
    object_old_ior(p, m->object);
    return !m->cutaway || cutaway_textures(p, m->object);
}

void object_link(struct parser *p, struct object *object)
{
    if (!object->texture)
        object_paint(p, object, texture_from_defaults(p));
}
