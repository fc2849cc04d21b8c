/* slope: the pattern's vectors and ranges. */
#include "scene/slope.h"

#include "parse/rules.h"

/* slope_range = [","] float "," float . */
static bool parse_slope_range(struct parser *p, double range[2])
{
    if (!accept(p, TOKEN_COMMA) && !at_number(p))
        return true;
    return parse_float(p, &range[0]) && expect(p, TOKEN_COMMA, span_none()) &&
           parse_float(p, &range[1]);
}

static bool slope_body(struct parser *p, struct slope *slope)
{
    slope->point_at = accept_keyword(p, KEYWORD_POINT_AT);
    if (!parse_vector(p, &slope->direction) ||
        !parse_slope_range(p, slope->slopes))
        return false;
    struct span span = stream_span(p);
    if (!accept_keyword(p, KEYWORD_ALTITUDE))
        return true;
    if (slope->point_at)
        return error_at(p, span, NULL,
                        "'altitude' can't be used with 'point_at'");
    return parse_vector(p, &slope->altitude) &&
           parse_slope_range(p, slope->altitudes);
}

/* slope = "slope" ( vector | "{" ["point_at"] vector [slope_range]
 *         ["altitude" vector [slope_range]] "}" ) . */
bool parse_slope(struct parser *p, struct slope *slope)
{
    struct span open;
    stream_next(p);
    if (stream_peek(p)->kind != TOKEN_LBRACE)
        return parse_vector(p, &slope->direction);
    return block_begin(p, &open) && block_end(p, open, slope_body(p, slope));
}
