/* contained_by{}: the box or ball that a shape is in. */
#include "scene/container.h"

#include "parse/rules.h"

static bool container_items(struct parser *p, struct container *container,
                            bool ball)
{
    if (!parse_vector(p, ball ? &container->centre : &container->low))
        return false;
    accept(p, TOKEN_COMMA);
    container->ball = ball;
    return ball ? parse_float(p, &container->radius)
                : parse_vector(p, &container->high);
}

static bool container_body(struct parser *p, struct container *container)
{
    struct span open;
    bool ball = at_word(p, "sphere");
    if (!ball && !at_word(p, "box"))
        return error_expected_hint(p, "'box' or 'sphere'", "box { -1, 1 }");
    stream_next(p);
    return block_begin(p, &open) &&
           block_end(p, open, container_items(p, container, ball));
}

/* contained_by = "contained_by" "{" ( "box" "{" vector [","] vector "}"
 *              | "sphere" "{" vector [","] float "}" ) "}" . */
bool parse_contained_by(struct parser *p, struct container *container)
{
    struct span open;
    stream_next(p);
    return block_begin(p, &open) &&
           block_end(p, open, container_body(p, container));
}
