/* Few lamps, each known by itself: see mesh_few.h. */
#include "lighting/mesh_few.h"

/* What is known of one side of a surface under few lamps. */
struct mesh_half {
    bool known;
    struct mesh_blend blend;
    struct direct_verdict verdict;
};

/* A surface under few lamps. The points in front of it and those behind it,
 * looked for when a lamp on that side asks. */
struct mesh_question {
    struct lamplight light; /* first: its address is ours */
    const struct direct_mesh *direct;
    struct lattice_view view;
    enum plan_lamps way;
    struct mesh_half half[2];
};

static const struct mesh_half *mesh_half(struct mesh_question *question,
                                         int side)
{
    struct mesh_half *half = &question->half[side];
    const struct surface *surface = question->light.surface;
    vec3 normal = side ? vec3_negate(surface->side) : surface->side;
    if (half->known)
        return half;
    half->known = true;
    const struct receiver receiver = { .point = surface->point,
                                       .side = normal,
                                       .normal = normal,
                                       .view = question->view,
                                       .weight = 1 };
    point_mesh_blend(&question->direct->points, question->light.worker,
                     &receiver, &half->blend);
    direct_mesh_judge(question->direct, &half->blend, &half->verdict);
    return half;
}

static rgb mesh_share(struct lamplight *light, const struct lamp *lamp,
                      const struct lamp_view *view)
{
    struct mesh_question *question = (struct mesh_question *)light;
    int number = lamp->number;
    if (lamp->light->shadowless)
        return rgb_grey(1);
    const struct mesh_half *half = mesh_half(
        question, vec3_dot(view->direction, light->surface->side) < 0);
    const struct direct_verdict *verdict = &half->verdict;
    bool lit = few_has(verdict->lit, number);
    bool certain = (lit || few_has(verdict->dark, number)) &&
                   direct_mesh_agrees(&half->blend);
    if (question->way == PLAN_SETTLED && !certain &&
        !few_has(verdict->faint, number))
        return lamplight_trace_fine(light, lamp, view);
    return lit ? rgb_grey(1)
               : direct_mesh_share(question->direct, &half->blend, number);
}

/* A surface that asks lamps itself, what points of the picture know left out.
 */
struct mesh_asker {
    struct lamplight light; /* first: its address is ours */
    const struct mesh_pixels *pixels;
};

/* What the picture's points know of a lamp before what is seen first. */
static bool pixels_share(const struct mesh_pixels *pixels,
                         const struct surface *surface, const struct lamp *lamp,
                         rgb *share)
{
    bool shines;
    const struct receiver receiver = { .at = surface->at,
                                       .pixel = surface->place };
    if (pixels->penumbras && surface->inside->count == 0 &&
        penumbras_share(pixels->penumbras, &receiver, lamp, share))
        return true;
    if (!pixels->mesh ||
        !pixel_mesh_sees(pixels->mesh, surface->place, lamp, &shines))
        return false;
    *share = rgb_grey(shines ? 1 : 0);
    return true;
}

static rgb mesh_asker_share(struct lamplight *light, const struct lamp *lamp,
                            const struct lamp_view *view)
{
    const struct mesh_asker *asker = (const struct mesh_asker *)light;
    const struct surface *surface = light->surface;
    rgb share;
    if (surface->place && vec3_dot(view->direction, surface->side) > 0 &&
        pixels_share(asker->pixels, surface, lamp, &share))
        return share;
    return lamplight_trace_fine(light, lamp, view);
}

/* Lamps that the side seen can't see give nothing, unless the other side
 * counts too. NULL: they may. */
static const uint64_t *mesh_hidden(struct mesh_question *question)
{
    const struct surface *surface = question->light.surface;
    if (surface->at->leaf->double_illuminate)
        return NULL;
    for (int i = 0; i < surface->count; i++)
        if (surface->layer[i].finish->diffuse_back != 0)
            return NULL;
    const struct mesh_half *half = mesh_half(question, 0);
    return question->way == PLAN_SETTLED && !direct_mesh_agrees(&half->blend)
               ? NULL
               : half->verdict.dark;
}

/* Whether the surface asks the lamp itself. */
static bool mesh_asked(const struct mesh_question *question,
                       const struct lamp *lamp)
{
    return question->way == PLAN_EACH ||
           (question->way == PLAN_BLENDED &&
            lamps_soft(question->light.lamps, lamp));
}

void mesh_few_give(const struct direct_mesh *mesh, struct lattice_view view,
                   enum plan_lamps way, const struct mesh_pixels *pixels,
                   const struct lamplight *light)
{
    const struct lamps *lamps = light->lamps;
    struct mesh_asker asker = { *light, pixels };
    struct mesh_question question;
    const uint64_t *hidden = NULL;
    bool looked = false;
    asker.light.share = mesh_asker_share;
    question.light = *light;
    question.light.share = mesh_share;
    question.direct = mesh;
    question.view = view;
    question.way = way;
    question.half[0].known = question.half[1].known = false;
    for (size_t i = 0; i < lamps->count; i++) {
        const struct lamp *lamp = &lamps->items[i];
        if (mesh_asked(&question, lamp)) {
            lamplight_give(&asker.light, lamp);
            continue;
        }
        if (!looked)
            hidden = mesh_hidden(&question);
        looked = true;
        if (!hidden || !few_has(hidden, (int)i))
            lamplight_give(&question.light, lamp);
    }
}
