/* Few lamps, each known by itself: see mesh_few.h. */
#include "lighting/mesh_few.h"

/* Mesh points whose visible shares of an area light differ by less are in one
 * penumbra, and may be interpolated. */
static const double wide_penumbra = 0.04;

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
    enum mesh_few_way way;
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
    point_mesh_blend(&question->direct->points, question->light.worker,
                     surface->point, normal, &half->blend);
    direct_mesh_judge(question->direct, &half->blend, &half->verdict);
    return half;
}

/* Whether points that differ about a lamp call for shadow rays. Of a lamp with
 * a size not where its penumbra is wide. */
static bool mesh_disputes(const struct mesh_question *question,
                          const struct mesh_half *half, const struct lamp *lamp)
{
    bool sharp = question->way == MESH_FEW_SETTLED;
    if (sharp || !lamps_soft(question->light.lamps, lamp))
        return sharp;
    return direct_mesh_spread(question->direct, &half->blend, lamp->number) >
           wide_penumbra;
}

static rgb mesh_share(struct lamplight *light, const struct lamp *lamp,
                      const struct lamp_view *view)
{
    struct mesh_question *question = (struct mesh_question *)light;
    const struct surface *surface = light->surface;
    struct lamp_target target = { surface->point, surface->inside, *view,
                                  surface->at };
    int number = lamp->number;
    rgb share;
    if (lamp->light->shadowless)
        return rgb_grey(1);
    if (lamps_soft(light->lamps, lamp) &&
        lamps_share_soon(light->lamps, lamp, light->worker, &target, &share))
        return share;
    const struct mesh_half *half =
        mesh_half(question, vec3_dot(view->direction, surface->side) < 0);
    const struct direct_verdict *verdict = &half->verdict;
    bool lit = few_has(verdict->lit, number);
    bool certain = (lit || few_has(verdict->dark, number)) &&
                   direct_mesh_agrees(&half->blend);
    if (!certain && !few_has(verdict->faint, number) &&
        mesh_disputes(question, half, lamp))
        return lamps_share_fine(light->lamps, lamp, light->worker, &target);
    return lit ? rgb_grey(1)
               : direct_mesh_share(question->direct, &half->blend, number);
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
    return question->way == MESH_FEW_SETTLED &&
                   !direct_mesh_agrees(&half->blend)
               ? NULL
               : half->verdict.dark;
}

/* Lamps of a size have wide penumbras, in which mesh points save many rays
 * where much stands between. */
static bool mesh_asked(const struct mesh_question *question,
                       const struct lamp *lamp)
{
    return question->way == MESH_FEW_ASKED &&
           !lamps_soft(question->light.lamps, lamp);
}

void mesh_few_give(const struct direct_mesh *mesh, enum mesh_few_way way,
                   const struct lamplight *light)
{
    const struct lamps *lamps = light->lamps;
    struct lamplight asked = *light;
    struct mesh_question question;
    const uint64_t *hidden = NULL;
    bool looked = false;
    asked.share = lamplight_trace;
    question.light = *light;
    question.light.share = mesh_share;
    question.direct = mesh;
    question.way = way;
    question.half[0].known = question.half[1].known = false;
    for (size_t i = 0; i < lamps->count; i++) {
        const struct lamp *lamp = &lamps->items[i];
        if (mesh_asked(&question, lamp)) {
            lamplight_give(&asked, lamp);
            continue;
        }
        bool soft = lamps_soft(lamps, lamp);
        if (!soft && !looked) {
            hidden = mesh_hidden(&question);
            looked = true;
        }
        if (soft || !hidden || !few_has(hidden, (int)i))
            lamplight_give(&question.light, lamp);
    }
}
