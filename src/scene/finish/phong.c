/* phong: highlights around the mirrored view. */
#include "scene/finish.h"

/* phong * (R.L)^size, R the mirrored view direction. */
static double phong_highlight(const void *said,
                              const struct finish_meeting *meeting)
{
    const struct finish *finish = said;
    double along = 2 * vec3_dot(meeting->view, meeting->normal);
    vec3 mirrored = vec3_sub(vec3_scale(meeting->normal, along), meeting->view);
    double cosine = vec3_dot(mirrored, meeting->light);
    if (cosine <= 0)
        return 0;
    double albedo = finish->phong_albedo ? (finish->phong_size + 1) / 2 : 1;
    return finish->phong * albedo * finish_lobe(cosine, finish->phong_size);
}

CLONES static void mirrored_cosines(const struct finish_meetings *meetings,
                                    double *restrict cosines)
{
    const double(*restrict n)[RAY_LANES] = meetings->normal;
    const double(*restrict v)[RAY_LANES] = meetings->view;
    const double(*restrict l)[RAY_LANES] = meetings->light;
    for (int i = 0; i < RAY_LANES; i++) {
        vec3 normal = { n[0][i], n[1][i], n[2][i] };
        vec3 view = { v[0][i], v[1][i], v[2][i] };
        vec3 light = { l[0][i], l[1][i], l[2][i] };
        double along = 2 * vec3_dot(view, normal);
        vec3 mirrored = vec3_sub(vec3_scale(normal, along), view);
        cosines[i] = vec3_dot(mirrored, light);
    }
}

static void phong_highlight_many(const void *said,
                                 const struct finish_meetings *meetings,
                                 double *shares)
{
    const struct finish *finish = said;
    double cosines[RAY_LANES];
    double albedo = finish->phong_albedo ? (finish->phong_size + 1) / 2 : 1;
    double amount = finish->phong * albedo;
    mirrored_cosines(meetings, cosines);
    finish_lobes(cosines, finish->phong_size, shares);
    for (int i = 0; i < RAY_LANES; i++)
        shares[i] = amount * shares[i];
}

static struct finish_spread phong_spread(const void *said)
{
    const struct finish *finish = said;
    double m = fmax(finish->phong_size, 0);
    return (struct finish_spread){
        .power = m,
        .amount = finish->phong,
        .share = finish->phong_albedo ? 1 : 2 / (m + 1),
    };
}

static const struct field fields[] = {
    FINISH_FIELD("phong", FIELD_FLOAT, phong, "highlights: how bright, 0"),
    FINISH_FIELD("phong_size", FIELD_FLOAT, phong_size,
                 "exponent of phong, 40"),
    FINISH_FIELD("phong albedo", FIELD_FLAG, phong_albedo, NULL),
    { NULL },
};

const struct finish_item phong_finish = {
    .name = "phong",
    .fields = fields,
    .amount = offsetof(struct finish, phong),
    .highlight = phong_highlight,
    .highlight_many = phong_highlight_many,
    .spread = phong_spread,
};
