/* phong: highlights around the mirrored view. */
#include "scene/finish.h"

/* R.L, R the mirrored view direction. */
static inline double mirrored_cosine(const struct finish_meeting *meeting)
{
    double along = 2 * vec3_dot(meeting->view, meeting->normal);
    vec3 mirrored = vec3_sub(vec3_scale(meeting->normal, along), meeting->view);
    return vec3_dot(mirrored, meeting->light);
}

static double phong_amount(const struct finish *finish)
{
    double albedo = finish->phong_albedo ? (finish->phong_size + 1) / 2 : 1;
    return finish->phong * albedo;
}

/* phong * (R.L)^size. */
static double phong_highlight(const void *said,
                              const struct finish_meeting *meeting)
{
    const struct finish *finish = said;
    double cosine = mirrored_cosine(meeting);
    if (cosine <= 0)
        return 0;
    return phong_amount(finish) * finish_lobe(cosine, finish->phong_size);
}

CLONES static void mirrored_cosines(const struct finish_meetings *meetings,
                                    double *restrict cosines)
{
    for (unsigned i = 0; i < RAY_LANES; i++) {
        const struct finish_meeting meeting = finish_meeting_at(meetings, i);
        cosines[i] = mirrored_cosine(&meeting);
    }
}

static void phong_highlight_many(const void *said,
                                 const struct finish_meetings *meetings,
                                 double *shares)
{
    const struct finish *finish = said;
    double cosines[RAY_LANES];
    mirrored_cosines(meetings, cosines);
    finish_lobes(cosines, finish->phong_size, phong_amount(finish), shares);
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
};
