/* Objects: everything that can be seen or shines. */
#include "parse/rules.h"

#include "base/hash.h"
#include "parse/array.h"

/* Trees are walked by recursion, and every use of a declared object is a
 * thing of its own to the ray tracer. */
enum {
    OBJECT_DEPTH_LIMIT = 200,
    OBJECT_PARTS_LIMIT = 1 << 24,
};

typedef bool object_rule(struct parser *p, struct object **out);
static object_rule parse_object_use;

static object_rule *object_keyword_rule(enum keyword keyword)
{
    switch (keyword) {
    case KEYWORD_OBJECT:
        return parse_object_use;
    case KEYWORD_UNION:
    case KEYWORD_MERGE:
    case KEYWORD_INTERSECTION:
    case KEYWORD_DIFFERENCE:
    case KEYWORD_COMPOSITE:
        return parse_csg;
    case KEYWORD_HEIGHT_FIELD:
        return parse_height_field;
    case KEYWORD_BICUBIC_PATCH:
        return parse_bicubic_patch;
    case KEYWORD_ISOSURFACE:
        return parse_isosurface;
    case KEYWORD_LIGHT_SOURCE:
        return parse_light_source;
    case KEYWORD_LIGHT_GROUP:
        return parse_light_group_part;
    case KEYWORD_MESH:
        return parse_mesh;
    case KEYWORD_MESH2:
        return parse_mesh2;
    case KEYWORD_TRIANGLE:
        return parse_triangle;
    case KEYWORD_SMOOTH_TRIANGLE:
        return parse_smooth_triangle;
    case KEYWORD_BLOB:
        return parse_blob;
    case KEYWORD_LATHE:
        return parse_lathe;
    case KEYWORD_POLYNOMIAL:
        return parse_polynomial;
    case KEYWORD_JULIA_FRACTAL:
        return parse_julia_fractal;
    case KEYWORD_PARAMETRIC:
        return parse_parametric;
    case KEYWORD_PRISM:
        return parse_prism;
    case KEYWORD_SPHERE_SWEEP:
        return parse_sphere_sweep;
    case KEYWORD_TEXT:
        return parse_text;
    default:
        return NULL;
    }
}

/* The primitive the next word names, or NULL. */
static const struct primitive *object_primitive(struct parser *p)
{
    const struct token *token = stream_peek(p);
    if (token->kind != TOKEN_WORD || !token->word->reserved)
        return NULL;
    return primitive_find(token->word->text);
}

static bool word_is_object(struct parser *p, const struct token *token)
{
    if (token->kind != TOKEN_WORD || token->word->reserved)
        return false;
    const struct value *value = symbol_find(p, token->word);
    return value && (value->kind == VALUE_OBJECT ||
                     (value->kind == VALUE_ARRAY &&
                      array_kind(value->array) == VALUE_OBJECT));
}

static bool at_object_identifier(struct parser *p)
{
    return word_is_object(p, stream_peek(p));
}

bool at_object(struct parser *p)
{
    enum keyword keyword = stream_keyword(p);
    return object_keyword_rule(keyword) || object_primitive(p) ||
           at_object_identifier(p);
}

struct object *object_empty(struct parser *p, struct span span)
{
    struct object *object = object_new(p->scene_arena, OBJECT_UNION, span);
    object_more(p->scene_arena, object)->parts = 0;
    return object;
}

struct object *object_seen(struct parser *p, struct object *object)
{
    const struct primitive *primitive = object->primitive;
    bool unseen = object->kind == OBJECT_SHAPE && primitive->unseen &&
                  primitive->unseen(object->shape);
    if (!unseen)
        return object;
    warning_at(p, object->span, NULL,
               "a '%s' with a negative radius shows in intersections and "
               "differences alone",
               primitive->name);
    return object_empty(p, object->span);
}

bool object_adopt(struct parser *p, struct object *object,
                  const struct object *child)
{
    struct object_more *more = object_more(p->scene_arena, object);
    if (child->more->depth >= more->depth)
        more->depth = child->more->depth + 1;
    more->parts += child->more->parts;
    object->patch = object->patch || child->patch;
    if (more->depth > OBJECT_DEPTH_LIMIT)
        return error_at(p, child->span, NULL,
                        "objects are nested more than %d deep",
                        OBJECT_DEPTH_LIMIT);
    return more->parts <= OBJECT_PARTS_LIMIT ||
           error_at(p, child->span, NULL,
                    "an object is made of more than %d others",
                    OBJECT_PARTS_LIMIT);
}

enum { SHAPE_SLOTS = 256 };

/* Shapes made last, by what their fields say. */
struct shapes_made {
    struct shape_made {
        const struct primitive *primitive;
        uint64_t said[2]; /* two hashes */
        const void *shape;
    } slots[SHAPE_SLOTS];
};

static struct shape_made shape_said(const struct primitive *primitive,
                                    const void *shape)
{
    struct shape_made said = { primitive, { 0, 1 }, shape };
    for (int i = 0; i < 2; i++) {
        said.said[i] = hash_fields(said.said[i], primitive->arguments, shape);
        said.said[i] = hash_fields(said.said[i], primitive->items, shape);
    }
    return said;
}

/* Where such a shape is, if it was made not long ago, or is to be. */
static struct shape_made *shape_slot(struct parser *p,
                                     const struct shape_made *said)
{
    if (!p->shapes)
        p->shapes = ARENA_NEW(p->arena, struct shapes_made);
    return &p->shapes->slots[said->said[0] % SHAPE_SLOTS];
}

static void object_leave_out(struct parser *p, struct object **out,
                             const char *why)
{
    const struct span span = (*out)->span;
    warning_at(p, span, NULL, "'%s' left out: %s", (*out)->primitive->name,
               why);
    *out = object_empty(p, span);
}

static void object_remark(struct parser *p, const struct object *object,
                          const struct primitive *primitive)
{
    const char *remark =
        primitive->remark ? primitive->remark(object->shape) : NULL;
    if (remark)
        warning_at(p, object->span, NULL, "'%s': %s", primitive->name, remark);
}

/* A shape that POV-Ray only warns about is left out of the picture, or isn't.
 */
static bool object_prepare(struct parser *p, struct object **out,
                           const struct primitive *primitive, void *shape)
{
    struct span span = (*out)->span;
    const char *warning = NULL;
    const char *problem =
        primitive->prepare ? primitive->prepare(shape, p->scene_arena, &warning)
                           : NULL;
    if (problem)
        return error_at(p, span, NULL, "impossible '%s': %s", primitive->name,
                        problem);
    if (warning) {
        object_leave_out(p, out, warning);
        return true;
    }
    object_remark(p, *out, primitive);
    object_settle(p->scene_arena, *out);
    return true;
}

/* What is alike to a shape that was made not long ago is that shape. */
static bool object_prepare_once(struct parser *p, struct object **out,
                                const struct primitive *primitive, void *shape)
{
    const struct shape_made said = shape_said(primitive, shape);
    struct shape_made *slot = shape_slot(p, &said);
    if (slot->primitive == primitive &&
        memcmp(slot->said, said.said, sizeof said.said) == 0) {
        (*out)->shape = slot->shape;
        return true;
    }
    if (!object_prepare(p, out, primitive, shape))
        return false;
    if ((*out)->shape == shape)
        *slot = said;
    return true;
}

bool parse_shape(struct parser *p, struct object **out,
                 const struct primitive *primitive, shape_rule *rule)
{
    struct span open;
    stream_next(p);
    struct object *object =
        object_new(p->scene_arena, OBJECT_SHAPE, p->last_span);
    void *shape = arena_alloc(p->scene_arena, primitive->size);
    struct modifiers m = { .object = object,
                           .block = primitive->name,
                           .items = primitive->items,
                           .shape = shape };
    object->primitive = primitive;
    object->shape = shape;
    object->patch = !primitive->solid;
    *out = object;
    if (!block_begin(p, &open))
        return false;
    const char *outer = p->shape;
    p->shape = rule ? NULL : primitive->name;
    p->infinite = NULL;
    bool ok =
        rule ? rule(p, shape) : parse_arguments(p, primitive->arguments, shape);
    p->shape = outer;
    const char *infinite = p->infinite;
    ok = ok && parse_modifiers(p, &m);
    if (!block_end(p, open, ok))
        return false;
    if (infinite) { /* it is nowhere, as in POV-Ray */
        object_leave_out(p, out,
                         arena_printf(p->arena,
                                      "its '%s' is not a finite number",
                                      infinite));
        return true;
    }
    return (primitive->alike ? object_prepare_once
                             : object_prepare)(p, out, primitive, shape);
}

/* primitive = PRIMITIVE "{" arguments {modifier} "}" .
 * Names and arguments are in the tables of scene/primitive/. */
static bool parse_primitive(struct parser *p, struct object **out,
                            const struct primitive *primitive)
{
    return parse_shape(p, out, primitive, NULL);
}

/* A declared object in the block of its own kind: sphere { Ball scale 2 }. */
static bool at_object_in_own_block(struct parser *p, object_rule *rule)
{
    size_t left;
    if (rule == parse_object_use || rule == parse_csg ||
        rule == parse_light_source)
        return false;
    stream_peek(p);
    const struct token *after = stream_raw(p, &left);
    return left > 1 && after[0].kind == TOKEN_LBRACE &&
           word_is_object(p, &after[1]);
}

/* object_use = ( "object" | PRIMITIVE ) "{" object {modifier} "}" .
 * Any keyword of a shape may stand before a declared object. */
static bool parse_object_use(struct parser *p, struct object **out)
{
    struct span open;
    stream_next(p);
    if (!block_begin(p, &open))
        return false;
    bool ok = parse_object(p, out);
    if (ok) {
        struct modifiers m = { .object = *out, .block = "object" };
        ok = parse_modifiers(p, &m);
    }
    return block_end(p, open, ok);
}

/* Whether a declared object stands before such a token. */
static bool at_object_before(struct parser *p, enum token_kind kind)
{
    size_t left;
    bool named = at_object_identifier(p);
    const struct token *after = stream_raw(p, &left);
    return named && left > 0 && after->kind == kind;
}

/* `Ball { translate x }` */
static bool object_reshaped(struct parser *p)
{
    struct span open;
    const char *name = stream_peek(p)->word->text;
    error_at(p, stream_span(p),
             arena_printf(p->arena, "object { %s ... }", name),
             "a declared object is moved and coloured in 'object { }'");
    stream_next(p);
    return block_begin(p, &open) && block_end(p, open, false);
}

/* `Ball()` */
static bool object_called(struct parser *p)
{
    const char *name = stream_peek(p)->word->text;
    return error_at(p, stream_span(p), name,
                    "'%s' is an object and no macro: it stands without '()'",
                    name);
}

/* object = primitive | csg | object_use | mesh | mesh2 | triangle
 *        | smooth_triangle | blob | prism | lathe | text | height_field
 *        | isosurface | sphere_sweep | polynomial | bicubic_patch
 *        | parametric | julia_fractal | light_source | light_group | OBJECT .
 */
bool parse_object(struct parser *p, struct object **out)
{
    enum keyword keyword = stream_keyword(p);
    object_rule *rule = object_keyword_rule(keyword);
    const struct primitive *primitive = object_primitive(p);
    if ((rule || primitive) && at_object_in_own_block(p, rule))
        return parse_object_use(p, out);
    if (rule)
        return rule(p, out);
    if (primitive)
        return parse_primitive(p, out, primitive);
    if (at_object_before(p, TOKEN_LBRACE))
        return object_reshaped(p);
    if (at_object_before(p, TOKEN_LPAREN))
        return object_called(p);
    const struct value *value = accept_value(p, VALUE_OBJECT);
    if (!value)
        return error_expected(p, "an object");
    *out = object_copy(p->scene_arena, value->object);
    return true;
}
