/* Light at surfaces side by side, layer by layer: see facets.h. */
#include "shade/facets.h"

#include "shade/finish.h"

/* What white paint of these finishes makes of light without a direction. */
struct glows {
    LANE_LINES double given[3][RAY_LANES], own[3][RAY_LANES];
};

CLONES static void add_glows(double (*restrict lights)[RAY_LANES],
                             const struct facet_layer *restrict layer,
                             const struct glows *restrict glows,
                             const lane_flag *restrict is)
{
    for (int k = 0; k < 3; k++)
        for (int i = 0; i < RAY_LANES; i++) {
            double pigment = layer->pigment[k][i], light = lights[k][i];
            double given = glows->given[k][i] * pigment * layer->opacity[i];
            double own = glows->own[k][i] * pigment * layer->opacity[i];
            double more = light + layer->weight[k][i] * (given + own);
            lights[k][i] = is[i] ? more : light;
        }
}

static void flags_of(unsigned lanes, lane_flag flags[RAY_LANES])
{
    for (unsigned i = 0; i < RAY_LANES; i++)
        flags[i] = -(lane_flag)(lanes >> i & 1);
}

/* Of one finish everywhere. */
CLONES static void add_glow(double (*restrict lights)[RAY_LANES],
                            const struct facet_layer *restrict layer,
                            const rgb *restrict given, const rgb *restrict own,
                            const lane_flag *restrict is)
{
    const double givens[3] = { given->r, given->g, given->b };
    const double owns[3] = { own->r, own->g, own->b };
    for (int k = 0; k < 3; k++)
        for (int i = 0; i < RAY_LANES; i++) {
            double pigment = layer->pigment[k][i], light = lights[k][i];
            double sent = givens[k] * pigment * layer->opacity[i] +
                          owns[k] * pigment * layer->opacity[i];
            double more = light + layer->weight[k][i] * sent;
            lights[k][i] = is[i] ? more : light;
        }
}

/* Those of `lanes` whose finish is that of the first. */
static unsigned finish_same(const struct facet_layer *layer, unsigned lanes)
{
    const struct finish *finish = layer->finish[__builtin_ctz(lanes)];
    unsigned same = 0;
    for (unsigned each = lanes; each; each &= each - 1) {
        unsigned i = (unsigned)__builtin_ctz(each);
        same |= (unsigned)(layer->finish[i] == finish) << i;
    }
    return same;
}

/* In the same light. */
static void glow_evenly(struct facets *facets, const struct facet_layer *layer,
                        unsigned lanes, const struct diffuse_light *diffuse)
{
    while (lanes) {
        const struct finish *finish = layer->finish[__builtin_ctz(lanes)];
        const unsigned same = finish_same(layer, lanes);
        const rgb given =
            finish_given(finish, diffuse->ambient, diffuse->irradiance);
        LANE_LINES lane_flag is[RAY_LANES];
        flags_of(same, is);
        add_glow(facets->light, layer, &given, &finish->glow, is);
        lanes &= ~same;
    }
}

static void glow_layer(struct facets *facets, const struct facet_layer *layer,
                       unsigned lanes, const struct diffuse_light *diffuse)
{
    struct glows glows;
    LANE_LINES lane_flag is[RAY_LANES];
    flags_of(lanes, is);
    for (; lanes; lanes &= lanes - 1) {
        unsigned i = (unsigned)__builtin_ctz(lanes);
        const struct finish *finish = layer->finish[i];
        rgb own = finish->glow, given = finish_given(finish, diffuse[i].ambient,
                                                     diffuse[i].irradiance);
        lane_put(glows.given, i, vec3_of(given));
        lane_put(glows.own, i, vec3_of(own));
    }
    add_glows(facets->light, layer, &glows, is);
}

void facets_glow(struct facets *facets, unsigned lanes,
                 const struct facets_diffuse *diffuse)
{
    for (unsigned k = 0; k < facets->depth; k++) {
        const struct facet_layer *layer = &facets->layer[k];
        if (!(lanes & layer->lanes))
            continue;
        if (diffuse->even)
            glow_evenly(facets, layer, lanes & layer->lanes, &diffuse->of[0]);
        else
            glow_layer(facets, layer, lanes & layer->lanes, diffuse->of);
    }
}

/* What a layer makes of white light. */
struct shares {
    LANE_LINES double cosine[RAY_LANES], of[3][RAY_LANES];
};

CLONES static void diffuse_shares(const struct facet_layer *restrict layer,
                                  const lane_flag *restrict twice,
                                  const double (*restrict direction)[RAY_LANES],
                                  struct shares *restrict shares)
{
    for (int i = 0; i < RAY_LANES; i++) {
        vec3 normal = lane_get(layer->normal, i);
        vec3 light = lane_get(direction, i);
        double cosine = vec3_dot(normal, light);
        lane_flag before = (cosine > 0 ? -1 : 0) | twice[i];
        double front = layer->diffuse[i], back = layer->diffuse_back[i];
        double diffuse = before ? front : back;
        diffuse = diffuse * fabs(cosine) * layer->opacity[i];
        shares->cosine[i] = cosine;
        shares->of[0][i] = layer->pigment[0][i] * diffuse;
        shares->of[1][i] = layer->pigment[1][i] * diffuse;
        shares->of[2][i] = layer->pigment[2][i] * diffuse;
    }
}

static struct finish_meeting meeting_at(const struct facets *facets,
                                        const struct facet_layer *layer,
                                        const struct facets_lit *lit,
                                        unsigned i)
{
    return (struct finish_meeting){ lane_get(layer->normal, i),
                                    lane_get(facets->view, i),
                                    lane_get(lit->direction, i) };
}

/* Those of the finishes that are no number times the cosine. */
static void uneven_shares(const struct facets *facets,
                          const struct facet_layer *layer,
                          const struct facets_lit *lit, unsigned lanes,
                          struct shares *shares)
{
    for (; lanes; lanes &= lanes - 1) {
        unsigned i = (unsigned)__builtin_ctz(lanes);
        const struct finish_meeting meeting = meeting_at(facets, layer, lit, i);
        double diffuse = finish_diffused(
            layer->finish[i], &meeting, lane_get(facets->point, i),
            facets->twice[i] != 0, layer->opacity[i]);
        lane_put(shares->of, i,
                 vec3_scale(lane_get(layer->pigment, i), diffuse));
    }
}

static void tint_shares(const struct facets *facets,
                        const struct facet_layer *layer,
                        const struct facets_lit *lit, unsigned lanes,
                        struct shares *shares)
{
    for (; lanes; lanes &= lanes - 1) {
        unsigned i = (unsigned)__builtin_ctz(lanes);
        const struct finish_meeting meeting = meeting_at(facets, layer, lit, i);
        rgb tint = finish_tint(layer->finish[i], lane_get(facets->point, i),
                               shares->cosine[i],
                               fabs(vec3_dot(meeting.view, meeting.normal)));
        lane_put(shares->of, i,
                 vec3_mul(lane_get(shares->of, i), vec3_of(tint)));
    }
}

/* Of one finish. */
static void highlight_same(const struct facets *facets,
                           const struct facet_layer *layer,
                           const struct finish *finish,
                           const struct facets_lit *lit, unsigned lanes,
                           struct shares *shares)
{
    LANE_LINES double highlights[RAY_LANES];
    const struct finish_meetings meetings = {
        (const double(*)[RAY_LANES])layer->normal,
        (const double(*)[RAY_LANES])facets->view, lit->direction
    };
    finish_highlight_many(finish, &meetings, lanes, highlights);
    for (; lanes; lanes &= lanes - 1) {
        unsigned i = (unsigned)__builtin_ctz(lanes);
        vec3 pigment = lane_get(layer->pigment, i);
        rgb share = finish_highlights_tinted(
            finish, highlights[i], rgb_make(pigment.x, pigment.y, pigment.z),
            shares->cosine[i]);
        lane_put(shares->of, i,
                 vec3_add(lane_get(shares->of, i), vec3_of(share)));
    }
}

static void highlight_shares(const struct facets *facets,
                             const struct facet_layer *layer,
                             const struct facets_lit *lit, unsigned lanes,
                             struct shares *shares)
{
    for (unsigned i = 0; i < RAY_LANES; i++)
        if (!(shares->cosine[i] > 0 || facets->twice[i]))
            lanes &= ~(1u << i);
    while (lanes) {
        const struct finish *finish = layer->finish[__builtin_ctz(lanes)];
        const unsigned same = finish_same(layer, lanes);
        highlight_same(facets, layer, finish, lit, same, shares);
        lanes &= ~same;
    }
}

CLONES static void add_shares(double (*restrict lights)[RAY_LANES],
                              const struct facet_layer *restrict layer,
                              const struct shares *restrict shares,
                              const struct facets_lit *restrict lit,
                              const lane_flag *restrict is_lit)
{
    for (int k = 0; k < 3; k++)
        for (int i = 0; i < RAY_LANES; i++) {
            double sent = shares->of[k][i] * lit->colour[k][i];
            double light = lights[k][i];
            double more = light + layer->weight[k][i] * sent;
            lights[k][i] = is_lit[i] ? more : light;
        }
}

static void add_layer(struct facets *facets, const struct facet_layer *layer,
                      const struct facets_lit *lit, unsigned lanes)
{
    struct shares shares;
    LANE_LINES lane_flag is_lit[RAY_LANES];
    flags_of(lanes, is_lit);
    diffuse_shares(layer, facets->twice, lit->direction, &shares);
    uneven_shares(facets, layer, lit, lanes & layer->uneven, &shares);
    if (lit->highlights)
        highlight_shares(facets, layer, lit, lanes & layer->shining, &shares);
    tint_shares(facets, layer, lit, lanes & layer->tinted, &shares);
    add_shares(facets->light, layer, &shares, lit, is_lit);
}

void facets_add(struct facets *facets, const struct facets_lit *lit,
                unsigned lanes)
{
    for (unsigned k = 0; k < facets->depth; k++)
        if (lanes & facets->layer[k].lanes)
            add_layer(facets, &facets->layer[k], lit,
                      lanes & facets->layer[k].lanes);
}
