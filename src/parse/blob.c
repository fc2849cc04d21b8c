/* blob: its parts, then what all of it is. */
#include "parse/rules.h"
#include "scene/blob.h"

struct blob_builder {
    struct blob_part *items;
    size_t count, capacity;
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
    return true;
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
        bool found;
        enum keyword keyword = stream_keyword(p);
        if (keyword == KEYWORD_TEXTURE || keyword == KEYWORD_PIGMENT ||
            keyword == KEYWORD_NORMAL || keyword == KEYWORD_FINISH)
            return error_unsupported(p, span, "a texture of a part of a blob");
        if (!parse_transformation(p, &step, &found))
            return false;
        if (!found)
            return error_unknown_item(p, block, NULL);
        if (!blob_part_move(&b->items[b->count - 1], &step))
            return error_at(p, span, NULL, "this leaves nothing of the part");
    }
    return true;
}

/* blob_part = ( "sphere" "{" vector [","] float
 *             | "cylinder" "{" vector [","] vector [","] float )
 *             [","] ["strength"] float {transformation} "}" . */
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
        ok = parse_float(p, &n.strength) && blob_push(p, b, &n) &&
             blob_part_items(p, b, word.word->text);
    }
    return block_end(p, open, ok);
}

/* blob_body = {"threshold" float} {blob_component | blob_part} . */
static bool parse_blob_body(struct parser *p, void *shape)
{
    struct blob *blob = shape;
    struct blob_builder b = { .count = 0 };
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
    return b.count || error_at(p, stream_span(p), "sphere { 0, 1, 1 }",
                               "a blob needs at least one part");
}

/* blob = "blob" "{" blob_body {modifier} "}" . */
bool parse_blob(struct parser *p, struct object **out)
{
    return parse_shape(p, out, &blob_primitive, parse_blob_body);
}
