/* specular: highlights around the normal, of the halfway vector. */
#include "scene/finish.h"

/* specular * (N.H)^(1/roughness), H halfway between light and viewer. */
static double specular_highlight(const void *said,
                                 const struct finish_meeting *meeting)
{
    const struct finish *finish = said;
    vec3 half = vec3_normalise(vec3_add(meeting->light, meeting->view));
    double cosine = vec3_dot(half, meeting->normal);
    if (cosine <= 0 || finish->roughness <= 0)
        return 0;
    double m = 1 / finish->roughness;
    double albedo =
        finish->specular_albedo ? (m + 2) / (4 * (2 - exp2(-m / 2))) : 1;
    return finish->specular * albedo * finish_lobe(cosine, m);
}

CLONES static void halfway_cosines(const struct finish_meetings *meetings,
                                   double *restrict cosines)
{
    const double(*restrict n)[RAY_LANES] = meetings->normal;
    const double(*restrict v)[RAY_LANES] = meetings->view;
    const double(*restrict l)[RAY_LANES] = meetings->light;
    for (int i = 0; i < RAY_LANES; i++) {
        vec3 normal = { n[0][i], n[1][i], n[2][i] };
        vec3 view = { v[0][i], v[1][i], v[2][i] };
        vec3 light = { l[0][i], l[1][i], l[2][i] };
        vec3 half = vec3_normalise(vec3_add(light, view));
        cosines[i] = vec3_dot(half, normal);
    }
}

static void specular_highlight_many(const void *said,
                                    const struct finish_meetings *meetings,
                                    double *shares)
{
    const struct finish *finish = said;
    double cosines[RAY_LANES], m = 1 / finish->roughness;
    double albedo =
        finish->specular_albedo ? (m + 2) / (4 * (2 - exp2(-m / 2))) : 1;
    double amount = finish->specular * albedo;
    if (finish->roughness <= 0) {
        for (int i = 0; i < RAY_LANES; i++)
            shares[i] = 0;
        return;
    }
    halfway_cosines(meetings, cosines);
    finish_lobes(cosines, m, shares);
    for (int i = 0; i < RAY_LANES; i++)
        shares[i] = amount * shares[i];
}

static struct finish_spread specular_spread(const void *said)
{
    const struct finish *finish = said;
    double m = 1 / finish->roughness;
    if (!(finish->roughness > 0))
        return (struct finish_spread){ .share = 0 };
    return (struct finish_spread){
        .halfway = true,
        .power = m,
        .amount = finish->specular,
        .share = finish->specular_albedo ? 2 : 8 / (m + 1),
    };
}

static const struct field fields[] = {
    FINISH_FIELD("specular", FIELD_FLOAT, specular,
                 "highlights: how bright, 0"),
    FINISH_FIELD("roughness", FIELD_FLOAT, roughness,
                 "1 / exponent of specular, 0.05"),
    FINISH_FIELD("specular albedo", FIELD_FLAG, specular_albedo, NULL),
    { NULL },
};

const struct finish_item specular_finish = {
    .name = "specular",
    .fields = fields,
    .amount = offsetof(struct finish, specular),
    .highlight = specular_highlight,
    .highlight_many = specular_highlight_many,
    .spread = specular_spread,
};
