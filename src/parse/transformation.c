/* translate, rotate, scale, matrix, transform. */
#include "parse/rules.h"

/* A factor of 0 would leave nothing of the object; POV-Ray takes 1 for it. */
static void scale_mend(struct parser *p, struct span span, vec3 *factors)
{
    double *each[] = { &factors->x, &factors->y, &factors->z };
    const char *axes = "";
    int count = 0;
    for (int i = 0; i < 3; i++) {
        if (*each[i] != 0)
            continue;
        *each[i] = 1;
        axes = arena_printf(p->arena, "%s %s %c", axes, count ? "and" : "along",
                            "xyz"[i]);
        count++;
    }
    if (count > 0)
        warning_at(p, span, NULL, "scale 0%s is taken as 1",
                   count < 3 ? axes : "");
}

/* scale = "scale" vector . */
static bool parse_scale(struct parser *p, affine *out)
{
    vec3 factors;
    stream_next(p);
    struct span first = stream_span(p);
    if (!parse_vector(p, &factors))
        return false;
    struct span span = span_join(first, p->last_span);
    scale_mend(p, span, &factors);
    *out = affine_scaling(factors);
    return true;
}

/* A row and a column of zeros would flatten space; POV-Ray puts a 1 where
 * they meet. */
static void matrix_mend(struct parser *p, struct span span, affine *matrix)
{
    for (int i = 0; i < 3; i++) {
        bool zero = true;
        for (int k = 0; k < 3; k++)
            zero = zero && matrix->m[i][k] == 0 && matrix->m[k][i] == 0;
        if (!zero)
            continue;
        warning_at(p, span, NULL, "scale 0 along %c is taken as 1", "xyz"[i]);
        matrix->m[i][i] = 1;
    }
}

/* matrix = "matrix" "<" float {[","] float} ">" .
 * Twelve numbers: the images of x, y, z and of the origin. */
static bool parse_matrix(struct parser *p, affine *out)
{
    double *images[12];
    for (int i = 0; i < 12; i++)
        images[i] = &out->m[i % 3][i / 3];
    struct span start = stream_span(p);
    stream_next(p);
    struct span open = stream_span(p);
    if (!accept(p, TOKEN_LESS))
        return error_expected_hint(p, "'<'",
                                   "<1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0>");
    for (int i = 0; i < 12; i++) {
        if (i > 0)
            accept(p, TOKEN_COMMA);
        if (stream_peek(p)->kind == TOKEN_GREATER)
            return error_at(p, stream_span(p), NULL,
                            "a matrix has 12 numbers, here are %d", i);
        if (!parse_float(p, images[i]))
            return false;
    }
    if (!expect(p, TOKEN_GREATER, open))
        return false;
    matrix_mend(p, span_join(start, p->last_span), out);
    return true;
}

static bool transform_items(struct parser *p, affine *out, bool *inverse)
{
    enum taken taken = TAKEN;
    while (taken == TAKEN && stream_peek(p)->kind != TOKEN_RBRACE) {
        const struct value *value = accept_value(p, VALUE_TRANSFORM);
        if (value)
            *out = affine_compose(*value->transform, *out);
        else if (accept_keyword(p, KEYWORD_INVERSE))
            *inverse = true;
        else
            taken = parse_transformation(p, out);
    }
    return taken != NOT_MINE ? taken : error_unknown_item(p, "transform", NULL);
}

/* transform = "transform" TRANSFORM
 *           | "transform" "{" {TRANSFORM | transformation | "inverse"} "}" .
 * "inverse" turns the whole block around, wherever it stands in it. */
static bool parse_transform(struct parser *p, affine *out)
{
    stream_next(p);
    const struct value *value = accept_value(p, VALUE_TRANSFORM);
    if (value) {
        *out = *value->transform;
        return true;
    }
    struct span open;
    bool inverse = false;
    if (!block_begin(p, &open) ||
        !block_end(p, open, transform_items(p, out, &inverse)))
        return false;
    if (inverse && !affine_inverse(*out, out))
        return error_at(p, open, NULL, "this transformation has no inverse");
    return true;
}

/* translation = "translate" vector . */
static bool parse_translation(struct parser *p, affine *out)
{
    vec3 v;
    stream_next(p);
    if (!parse_vector(p, &v))
        return false;
    *out = affine_translation(v);
    return true;
}

/* rotation = "rotate" vector .
 * Degrees about x, then y, then z, left-handed. */
static bool parse_rotation(struct parser *p, affine *out)
{
    vec3 v;
    stream_next(p);
    if (!parse_vector(p, &v))
        return false;
    *out = affine_rotation(v);
    return true;
}

/* Whether it keeps space finite and can be undone: rays are taken into an
 * object's own space by the inverse. */
static bool transformation_check(struct parser *p, struct span span,
                                 const affine *transform)
{
    affine inverse;
    for (int i = 0; i < 12; i++)
        if (!isfinite(transform->m[i / 4][i % 4]))
            return error_at(p, span, NULL, "this moves things to infinity");
    if (!affine_inverse(*transform, &inverse))
        return error_at(p, span, NULL,
                        "this transformation flattens space: it can't be "
                        "undone");
    return true;
}

/* POV-Ray doesn't look into matrices and transforms (measured). */
static bool transformation_is_alike(enum keyword keyword, const affine *one)
{
    return keyword == KEYWORD_TRANSLATE || keyword == KEYWORD_ROTATE ||
           (keyword == KEYWORD_SCALE && one->m[0][0] == one->m[1][1] &&
            one->m[0][0] == one->m[2][2]);
}

enum taken parse_transformation(struct parser *p, affine *transform)
{
    bool ignored = true;
    return parse_transformation_alike(p, transform, &ignored);
}

/* transformation = translation | rotation | scale | matrix | transform . */
enum taken parse_transformation_alike(struct parser *p, affine *transform,
                                      bool *alike)
{
    bool (*rule)(struct parser *, affine *);
    enum keyword keyword = stream_keyword(p);
    switch (keyword) {
    case KEYWORD_TRANSLATE:
        rule = parse_translation;
        break;
    case KEYWORD_ROTATE:
        rule = parse_rotation;
        break;
    case KEYWORD_SCALE:
        rule = parse_scale;
        break;
    case KEYWORD_MATRIX:
        rule = parse_matrix;
        break;
    case KEYWORD_TRANSFORM:
        rule = parse_transform;
        break;
    default:
        return NOT_MINE;
    }
    affine one = affine_identity();
    struct span span = stream_span(p);
    if (!rule(p, &one))
        return false;
    *alike = *alike && transformation_is_alike(keyword, &one);
    *transform = affine_compose(one, *transform);
    return transformation_check(p, span_join(span, p->last_span), transform);
}
