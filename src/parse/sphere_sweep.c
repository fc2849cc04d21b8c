/* sphere_sweep{}: a ball along a curve. */
#include "scene/sphere_sweep.h"

#include "parse/rules.h"

/* sweep_type = "linear_spline" | "cubic_spline" | "b_spline" . */
static bool parse_sweep_type(struct parser *p, enum sweep_kind *kind)
{
    if (accept_keyword(p, KEYWORD_LINEAR_SPLINE))
        *kind = SWEEP_LINEAR;
    else if (accept_keyword(p, KEYWORD_CUBIC_SPLINE))
        *kind = SWEEP_CUBIC;
    else if (accept_keyword(p, KEYWORD_B_SPLINE))
        *kind = SWEEP_B_SPLINE;
    else
        return error_expected_hint(
            p, "'linear_spline', 'cubic_spline' or 'b_spline'",
            "sphere_sweep { linear_spline 2, <0, 0, 0>, 1, <1, 0, 0>, 1 }");
    return true;
}

struct sweep_ball {
    vec3 centre;
    double radius;
};

static const struct field ball_arguments[] = {
    { "centre", FIELD_VECTOR, offsetof(struct sweep_ball, centre), 0, 0,
      "where the ball is", false },
    { "radius", FIELD_FLOAT, offsetof(struct sweep_ball, radius), 0, 0,
      "how large", false },
    { .name = NULL },
};

/* sweep_ball = vector [","] float [","] . */
static bool parse_sweep_ball(struct parser *p, double ball[4])
{
    struct sweep_ball said;
    struct span start = stream_span(p);
    if (!parse_arguments(p, ball_arguments, &said))
        return false;
    accept(p, TOKEN_COMMA);
    ball[0] = said.centre.x;
    ball[1] = said.centre.y;
    ball[2] = said.centre.z;
    ball[3] = said.radius;
    for (int i = 0; i < 4; i++)
        if (!isfinite(ball[i]))
            return error_at(p, span_join(start, p->last_span), NULL,
                            "a ball's place or radius is not a finite number");
    return true;
}

/* sweep_body = sweep_type [","] float [","] {sweep_ball} . */
static bool parse_sweep_body(struct parser *p, void *shape)
{
    struct sphere_sweep *sweep = shape;
    int count;
    if (!parse_sweep_type(p, &sweep->kind))
        return false;
    accept(p, TOKEN_COMMA);
    struct span start = stream_span(p);
    if (!parse_integer(p, &count))
        return false;
    accept(p, TOKEN_COMMA);
    if (count < 0 || count > SWEEP_BALLS_LIMIT)
        return error_at(p, start, NULL,
                        "the number of balls must be from 0 to %d, found %d",
                        SWEEP_BALLS_LIMIT, count);
    struct {
        double *items;
        size_t count, capacity;
    } balls = { NULL, 0, 0 };
    for (int i = 0; i < count; i++) {
        double ball[4];
        if (!parse_sweep_ball(p, ball))
            return false;
        for (int k = 0; k < 4; k++)
            *ARRAY_PUSH(p->scene_arena, &balls) = ball[k];
    }
    sweep->balls = (struct terms){ balls.items, balls.count };
    return true;
}

/* sphere_sweep = "sphere_sweep" "{" sweep_body {modifier} "}" . */
bool parse_sphere_sweep(struct parser *p, struct object **out)
{
    return parse_shape(p, out, &sphere_sweep_primitive, parse_sweep_body);
}
