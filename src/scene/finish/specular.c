/* specular: highlights around the normal, of the halfway vector. */
#include <string.h>

#include "scene/finish.h"

/* N.H, H halfway between light and viewer. */
static inline double halfway_cosine(const struct finish_meeting *meeting)
{
    vec3 half = vec3_normalise(vec3_add(meeting->light, meeting->view));
    return vec3_dot(half, meeting->normal);
}

/* Of the exponent m. */
static double specular_amount(const struct finish *finish, double m)
{
    double albedo =
        finish->specular_albedo ? (m + 2) / (4 * (2 - exp2(-m / 2))) : 1;
    return finish->specular * albedo;
}

/* specular * (N.H)^(1/roughness). */
static double specular_highlight(const void *said,
                                 const struct finish_meeting *meeting)
{
    const struct finish *finish = said;
    double cosine = halfway_cosine(meeting);
    if (cosine <= 0 || finish->roughness <= 0)
        return 0;
    double m = 1 / finish->roughness;
    return specular_amount(finish, m) * finish_lobe(cosine, m);
}

CLONES static void halfway_cosines(const struct finish_meetings *meetings,
                                   double *restrict cosines)
{
    for (unsigned i = 0; i < RAY_LANES; i++) {
        const struct finish_meeting meeting = finish_meeting_at(meetings, i);
        cosines[i] = halfway_cosine(&meeting);
    }
}

static void specular_highlight_many(const void *said,
                                    const struct finish_meetings *meetings,
                                    double *shares)
{
    const struct finish *finish = said;
    double cosines[RAY_LANES];
    if (finish->roughness <= 0) {
        memset(shares, 0, RAY_LANES * sizeof *shares);
        return;
    }
    double m = 1 / finish->roughness;
    halfway_cosines(meetings, cosines);
    finish_lobes(cosines, m, specular_amount(finish, m), shares);
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
};
