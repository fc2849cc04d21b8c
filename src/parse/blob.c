/* blob: its parts, then what all of it is. */
#include "parse/rules.h"
#include "scene/blob.h"

struct blob_builder {
    struct blob_part *items;
    size_t count, capacity;
    struct {
        const struct texture **items;
        size_t count, capacity;
    } textures; /* of parts; the first stands for the blob's */
    struct {
        unsigned *items;
        size_t count, capacity;
    } numbers;                  /* of each part's texture */
    const struct texture *said; /* of the part being read, or NULL */
};

/* What stands in a part: `radius` is of a `component`, too. */
struct blob_numbers {
    vec3 base, apex;
    double radius, strength;
};

#define NUMBER(name, kind, member, help)                                       \
    {                                                                          \
        name, kind, offsetof(struct blob_numbers, member), 0, 0, help          \
    }

static const struct field ball_arguments[] = {
    NUMBER("centre", FIELD_VECTOR, base, "the middle"),
    NUMBER("radius", FIELD_FLOAT, radius, "where the density ends"),
    { .name = NULL },
};

static const struct field cylinder_arguments[] = {
    NUMBER("base", FIELD_VECTOR, base, "one end"),
    NUMBER("apex", FIELD_VECTOR, apex, "the other"),
    NUMBER("radius", FIELD_FLOAT, radius, "where the density ends"),
    { .name = NULL },
};

static const struct field component_arguments[] = {
    NUMBER("strength", FIELD_FLOAT, strength, "the density in the middle"),
    NUMBER("radius", FIELD_FLOAT, radius, "where the density ends"),
    NUMBER("centre", FIELD_VECTOR, base, "the middle"),
    { .name = NULL },
};

static bool blob_push(struct parser *p, struct blob_builder *b,
                      const struct blob_numbers *n)
{
    struct blob_part part;
    if (b->count == BLOB_PARTS_LIMIT)
        return error_at(p, p->last_span, NULL, "a blob has at most %d parts",
                        BLOB_PARTS_LIMIT);
    if (!blob_part_make(&part, n->base, n->apex, n->radius, n->strength))
        return error_at(p, p->last_span, NULL,
                        "a part of a blob needs a radius");
    *ARRAY_PUSH(p->scene_arena, b) = part;
    *ARRAY_PUSH(p->scene_arena, &b->numbers) = 0;
    b->said = NULL;
    return true;
}

/* texture, pigment, normal or finish of a part. */
static enum taken parse_blob_texture(struct parser *p, struct blob_builder *b)
{
    if (stream_keyword(p) == KEYWORD_TEXTURE) {
        const struct texture *texture;
        if (!parse_texture(p, &texture))
            return WRONG;
        b->said = b->said ? texture_stack(p, b->said, texture) : texture;
        return TAKEN;
    }
    const struct texture *texture =
        b->said ? b->said : texture_from_defaults(p);
    enum taken taken = parse_texture_part(p, &texture);
    if (taken == TAKEN)
        b->said = texture;
    return taken;
}

static void blob_textured(struct parser *p, struct blob_builder *b)
{
    if (!b->said)
        return;
    *ARRAY_PUSH(p->scene_arena, &b->textures) = b->said;
    b->numbers.items[b->count - 1] = (unsigned)b->textures.count - 1;
    b->said = NULL;
}

/* blob_component = "component" float [","] float [","] vector . */
static bool parse_blob_component(struct parser *p, struct blob_builder *b)
{
    struct blob_numbers n;
    stream_next(p);
    if (!parse_arguments(p, component_arguments, &n))
        return false;
    n.apex = n.base;
    return blob_push(p, b, &n);
}

static bool blob_part_items(struct parser *p, struct blob_builder *b,
                            const char *block)
{
    while (stream_peek(p)->kind != TOKEN_RBRACE) {
        affine step = affine_identity();
        struct span span = stream_span(p);
        enum taken taken = parse_blob_texture(p, b);
        if (taken == TAKEN)
            continue;
        if (taken == NOT_MINE)
            taken = parse_transformation(p, &step);
        if (taken == NOT_MINE)
            return error_unknown_item(p, block, NULL);
        if (taken == WRONG)
            return false;
        if (!blob_part_move(&b->items[b->count - 1], &step))
            return error_at(p, span, NULL, "this leaves nothing of the part");
        if (b->said)
            b->said = texture_moved(p->scene_arena, b->said, &step);
    }
    blob_textured(p, b);
    return true;
}

static bool blob_part_short(struct parser *p, bool ball)
{
    return error_expected_hint(
        p, "a number for 'strength'",
        ball ? "sphere { <centre>, radius, strength }"
             : "cylinder { <base>, <apex>, radius, strength }");
}

/* blob_part = ( "sphere" "{" vector [","] float
 *             | "cylinder" "{" vector [","] vector [","] float )
 *             [","] ["strength"] float
 *             {texture | texture_part | transformation} "}" . */
static bool parse_blob_part(struct parser *p, struct blob_builder *b)
{
    struct token word = stream_next(p);
    bool ball = strcmp(word.word->text, "sphere") == 0;
    struct blob_numbers n;
    struct span open;
    if (!block_begin(p, &open))
        return false;
    bool ok =
        parse_arguments(p, ball ? ball_arguments : cylinder_arguments, &n);
    if (ball)
        n.apex = n.base;
    if (ok) {
        accept(p, TOKEN_COMMA);
        accept_word(p, "strength");
        if (!at_expression(p))
            return block_end(p, open, blob_part_short(p, ball));
        ok = parse_field(p, component_arguments, &n) && blob_push(p, b, &n) &&
             blob_part_items(p, b, word.word->text);
    }
    return block_end(p, open, ok);
}

/* blob_body = {"threshold" float} {blob_component | blob_part} . */
static bool parse_blob_body(struct parser *p, void *shape)
{
    struct blob *blob = shape;
    struct blob_builder b = { .count = 0 };
    *ARRAY_PUSH(p->scene_arena, &b.textures) = NULL;
    blob->threshold = 1;
    for (;;) {
        bool ok = true;
        if (accept_word(p, "threshold"))
            ok = parse_float(p, &blob->threshold);
        else if (at_word(p, "component"))
            ok = parse_blob_component(p, &b);
        else if (at_word(p, "sphere") || at_word(p, "cylinder"))
            ok = parse_blob_part(p, &b);
        else
            break;
        if (!ok)
            return false;
    }
    blob->parts =
        (struct terms){ (double *)(void *)b.items, b.count * BLOB_NUMBERS };
    if (b.textures.count > 1) {
        blob->textures = b.numbers.items;
        blob->part_textures = b.textures.items;
        blob->texture_count = b.textures.count;
    }
    if (at_object(p))
        return error_at(p, stream_span(p), "union { blob { ... } ... }",
                        "a blob holds spheres, cylinders and components only; "
                        "other objects are put together with it in a 'union'");
    return b.count || error_at(p, stream_span(p), "sphere { 0, 1, 1 }",
                               "a blob needs at least one part");
}

/* blob = "blob" "{" blob_body {modifier} "}" . */
bool parse_blob(struct parser *p, struct object **out)
{
    return parse_shape(p, out, &blob_primitive, parse_blob_body);
}
