/* Surfaces side by side: see facets.h. */
#include "shade/facets.h"

#include <string.h>

#include "shade/ambience.h"
#include "scene/spots.h"
#include "shade/finish.h"

static lane_flag flag(bool is)
{
    return is ? -1 : 0;
}

static vec3 vec3_of(rgb c)
{
    return (vec3){ c.r, c.g, c.b };
}

/* The normals turned to the viewer, and nothing before the paint or lit. */
CLONES static void look_back(const struct rays *restrict rays,
                             const struct world_faces *restrict faces,
                             struct facets *restrict facets)
{
    for (unsigned i = 0; i < RAY_LANES; i++) {
        vec3 direction = lane_get(rays->direction, i);
        vec3 normal = lane_get(faces->normal, i);
        bool away = vec3_dot(normal, direction) > 0;
        lane_put(facets->normal, i, away ? vec3_negate(normal) : normal);
        lane_put(facets->view, i, vec3_negate(direction));
        facets->opacity[i] = 1;
    }
    for (int k = 0; k < 3; k++)
        for (int i = 0; i < RAY_LANES; i++) {
            facets->weight[k][i] = 1;
            facets->light[k][i] = 0;
        }
}

void facets_start(struct facets *facets, const struct rays *rays,
                  const struct world_faces *faces)
{
    facets->faces = faces;
    facets->all = facets->layered = 0;
    facets->shining = facets->uneven = facets->tinted = 0;
    memcpy(facets->point, faces->point, sizeof facets->point);
    memset(facets->front, 0, sizeof facets->front);
    memset(facets->back, 0, sizeof facets->back);
    memset(facets->twice, 0, sizeof facets->twice);
    look_back(rays, faces, facets);
}

static void set_faces(struct facets *facets, unsigned i,
                      const struct finish *finish, bool layered)
{
    bool twice = layered || facets->leaf[i]->double_illuminate;
    facets->twice[i] = flag(twice);
    facets->front[i] = flag(layered || finish_lit_by(finish, 1, twice));
    facets->back[i] = flag(layered || finish_lit_by(finish, -1, twice));
}

static void set_finish(struct facets *facets, unsigned i,
                       const struct finish *finish)
{
    facets->finish[i] = finish;
    facets->diffuse[i] = finish->diffuse;
    facets->diffuse_back[i] = finish->diffuse_back;
    facets->shining |= (unsigned)finish_shines(finish) << i;
    facets->uneven |= (unsigned)finish_is_uneven(finish) << i;
    facets->tinted |= (unsigned)finish_tints(finish) << i;
}

static void set_paint(struct facets *facets, unsigned i,
                      const struct surface_layer *layer)
{
    set_finish(facets, i, layer->finish);
    facets->opacity[i] = layer_opacity(layer);
    lane_put(facets->pigment, i, vec3_of(colour_rgb(layer->pigment)));
    lane_put(facets->weight, i, vec3_of(layer->weight));
}

/* One of several layers may face any lamp. */
void facets_set(struct facets *facets, unsigned i,
                const struct surface *surface, rgb light)
{
    const struct surface_layer *layer = &surface->layer[0];
    const struct finish *finish = layer->finish;
    bool layered = surface->count != 1;
    vec3 normal = layered ? surface->normal : layer->normal;
    facets->all |= 1u << i;
    facets->surface[i] = surface;
    facets->leaf[i] = surface->at->leaf;
    facets->inside[i] = surface->inside;
    facets->worth[i] = surface->weight;
    facets->layered |= (unsigned)layered << i;
    set_faces(facets, i, finish, layered);
    lane_put(facets->normal, i, normal);
    lane_put(facets->light, i, vec3_of(light));
    if (!layered)
        set_paint(facets, i, layer);
}

/* Some of those of a leaf, and where they are in its texture. */
struct painted {
    unsigned lane[SPOTS_MAX];
    struct spots points;
};

static void paint_pigment(struct facets *facets, unsigned i, colour c)
{
    lane_put(facets->pigment, i, vec3_of(colour_rgb(c)));
    facets->clear[0][i] = c.filter;
    facets->clear[1][i] = c.transmit;
    facets->opacity[i] = finish_opacity(facets->finish[i], c);
}

static void paint_pigments(struct facets *facets, const struct painted *painted,
                           const struct pigment *pigment)
{
    colour colours[SPOTS_MAX];
    pigment_colours(pigment, &painted->points, colours);
    for (int i = 0; i < painted->points.count; i++)
        paint_pigment(facets, painted->lane[i], colours[i]);
}

static void paint_bumps(struct facets *facets, const struct painted *painted,
                        const struct leaf *leaf, const struct layer *layer)
{
    for (int k = 0; k < painted->points.count; k++) {
        unsigned i = painted->lane[k];
        vec3 normal = layer_bumped(layer, leaf->to_texture, leaf->from_texture,
                                   spots_at(&painted->points, k),
                                   lane_get(facets->normal, i), NULL);
        lane_put(facets->normal, i, normal);
    }
}

/* The pigments, and the normals' bumps. */
static void paint_points(struct facets *facets, unsigned lanes,
                         const struct leaf *leaf)
{
    const struct layer *layer = &leaf->texture->layers[0];
    const struct pigment *pigment = layer->pigment;
    bool bumpy = layer->normal && normal_tilts(layer->normal);
    bool even = pigment->kind == PIGMENT_COLOUR;
    for (unsigned each = lanes; even && each; each &= each - 1)
        paint_pigment(facets, (unsigned)__builtin_ctz(each), pigment->colour);
    while (lanes && (bumpy || !even)) {
        struct painted painted = { .points.count = 0 };
        for (; lanes && painted.points.count < SPOTS_MAX; lanes &= lanes - 1) {
            unsigned i = (unsigned)__builtin_ctz(lanes);
            painted.lane[painted.points.count] = i;
            spots_add(
                &painted.points,
                affine_point(leaf->to_texture, lane_get(facets->point, i)));
        }
        if (!even)
            paint_pigments(facets, &painted, pigment);
        if (bumpy)
            paint_bumps(facets, &painted, leaf, layer);
    }
}

/* What is the same all over a leaf: copied from another of its facets. */
static void paint_as(struct facets *facets, unsigned i, unsigned other)
{
    facets->leaf[i] = facets->leaf[other];
    facets->finish[i] = facets->finish[other];
    facets->twice[i] = facets->twice[other];
    facets->front[i] = facets->front[other];
    facets->back[i] = facets->back[other];
    facets->diffuse[i] = facets->diffuse[other];
    facets->diffuse_back[i] = facets->diffuse_back[other];
    facets->shining |= (facets->shining >> other & 1) << i;
    facets->uneven |= (facets->uneven >> other & 1) << i;
    facets->tinted |= (facets->tinted >> other & 1) << i;
}

/* Those of one leaf. */
static void paint_leaf(struct facets *facets, const struct leaf *leaf,
                       unsigned lanes)
{
    const struct finish *finish = leaf->texture->layers[0].finish;
    unsigned first = (unsigned)__builtin_ctz(lanes);
    facets->leaf[first] = leaf;
    set_faces(facets, first, finish, false);
    set_finish(facets, first, finish);
    for (unsigned each = lanes & (lanes - 1); each; each &= each - 1)
        paint_as(facets, (unsigned)__builtin_ctz(each), first);
    for (unsigned each = lanes; each; each &= each - 1)
        facets->surface[__builtin_ctz(each)] = NULL;
    paint_points(facets, lanes, leaf);
}

void facets_paint(struct facets *facets, const struct world_hit *hits,
                  unsigned lanes)
{
    facets->all |= lanes;
    while (lanes) {
        const struct leaf *leaf = hits[__builtin_ctz(lanes)].leaf;
        unsigned same = 0;
        for (unsigned each = lanes; each; each &= each - 1) {
            unsigned i = (unsigned)__builtin_ctz(each);
            same |= (unsigned)(hits[i].leaf == leaf) << i;
        }
        paint_leaf(facets, leaf, same);
        lanes &= ~same;
    }
}

const struct surface *facets_surface(struct facets *facets, unsigned i)
{
    if (!facets->surface[i])
        facets->surface[i] = facets->tell(facets->context, i);
    return facets->surface[i];
}

vec3 facets_side(const struct facets *facets, unsigned i)
{
    const struct surface *surface = facets->surface[i];
    if (surface)
        return surface->side;
    vec3 side = world_face_side(facets->leaf[i], facets->faces, i);
    return vec3_dot(side, lane_get(facets->view, i)) < 0 ? vec3_negate(side)
                                                         : side;
}

/* What is plain has one layer, which nothing hides. */
rgb facets_albedo(const struct facets *facets, unsigned i)
{
    if (facets->surface[i])
        return surface_albedo(facets->surface[i]);
    vec3 pigment = lane_get(facets->pigment, i);
    return albedo_bounded(rgb_scale(rgb_make(pigment.x, pigment.y, pigment.z),
                                    facets->diffuse[i] * facets->opacity[i]));
}

rgb facets_ambient(const struct facets *facets, unsigned i)
{
    if (facets->surface[i])
        return surface_ambient(facets->surface[i]);
    vec3 pigment = lane_get(facets->pigment, i);
    rgb share = rgb_mul(facets->finish[i]->ambient,
                        rgb_make(pigment.x, pigment.y, pigment.z));
    return rgb_scale(share, facets->opacity[i]);
}

colour facets_paint_of(const struct facets *facets, unsigned i)
{
    return (colour){ facets->pigment[0][i], facets->pigment[1][i],
                     facets->pigment[2][i], facets->clear[0][i],
                     facets->clear[1][i] };
}

rgb facets_light(const struct facets *facets, unsigned i)
{
    return (rgb){ facets->light[0][i], facets->light[1][i],
                  facets->light[2][i] };
}

/* What white paint of these finishes makes of light without a direction. */
struct glows {
    LANE_LINES double given[3][RAY_LANES], own[3][RAY_LANES];
};

CLONES static void add_glows(struct facets *restrict facets,
                             const struct glows *restrict glows)
{
    for (int k = 0; k < 3; k++)
        for (int i = 0; i < RAY_LANES; i++) {
            double pigment = facets->pigment[k][i];
            double given = glows->given[k][i] * pigment * facets->opacity[i];
            double own = glows->own[k][i] * pigment * facets->opacity[i];
            facets->light[k][i] += facets->weight[k][i] * (given + own);
        }
}

void facets_glow(struct facets *facets, unsigned lanes,
                 const struct diffuse_light diffuse[RAY_LANES])
{
    struct glows glows = { { { 0 } }, { { 0 } } };
    for (; lanes; lanes &= lanes - 1) {
        unsigned i = (unsigned)__builtin_ctz(lanes);
        const struct finish *finish = facets->finish[i];
        rgb own = finish->glow, given = finish_given(finish, diffuse[i].ambient,
                                                     diffuse[i].irradiance);
        lane_put(glows.given, i, vec3_of(given));
        lane_put(glows.own, i, vec3_of(own));
    }
    add_glows(facets, &glows);
}

/* What the layers make of white light. */
struct shares {
    LANE_LINES double cosine[RAY_LANES], of[3][RAY_LANES];
};

CLONES static void diffuse_shares(const struct facets *restrict facets,
                                  const double (*restrict direction)[RAY_LANES],
                                  struct shares *restrict shares)
{
    for (int i = 0; i < RAY_LANES; i++) {
        vec3 normal = lane_get(facets->normal, i);
        vec3 light = lane_get(direction, i);
        double cosine = vec3_dot(normal, light);
        lane_flag before = (cosine > 0 ? -1 : 0) | facets->twice[i];
        double front = facets->diffuse[i], back = facets->diffuse_back[i];
        double diffuse = before ? front : back;
        diffuse = diffuse * fabs(cosine) * facets->opacity[i];
        shares->cosine[i] = cosine;
        shares->of[0][i] = facets->pigment[0][i] * diffuse;
        shares->of[1][i] = facets->pigment[1][i] * diffuse;
        shares->of[2][i] = facets->pigment[2][i] * diffuse;
    }
}

static struct finish_meeting meeting_at(const struct facets *facets,
                                        const struct facets_lit *lit,
                                        unsigned i)
{
    return (struct finish_meeting){ lane_get(facets->normal, i),
                                    lane_get(facets->view, i),
                                    lane_get(lit->direction, i) };
}

/* Those of the finishes that are no number times the cosine. */
static void uneven_shares(const struct facets *facets,
                          const struct facets_lit *lit, unsigned lanes,
                          struct shares *shares)
{
    for (; lanes; lanes &= lanes - 1) {
        unsigned i = (unsigned)__builtin_ctz(lanes);
        const struct finish_meeting meeting = meeting_at(facets, lit, i);
        double diffuse = finish_diffused(
            facets->finish[i], &meeting, lane_get(facets->point, i),
            facets->twice[i] != 0, facets->opacity[i]);
        lane_put(shares->of, i,
                 vec3_scale(lane_get(facets->pigment, i), diffuse));
    }
}

static void tint_shares(const struct facets *facets,
                        const struct facets_lit *lit, unsigned lanes,
                        struct shares *shares)
{
    for (; lanes; lanes &= lanes - 1) {
        unsigned i = (unsigned)__builtin_ctz(lanes);
        const struct finish_meeting meeting = meeting_at(facets, lit, i);
        rgb tint = finish_tint(facets->finish[i], lane_get(facets->point, i),
                               shares->cosine[i],
                               fabs(vec3_dot(meeting.view, meeting.normal)));
        lane_put(shares->of, i,
                 vec3_mul(lane_get(shares->of, i), vec3_of(tint)));
    }
}

/* Of one finish. */
static void highlight_same(const struct facets *facets,
                           const struct finish *finish,
                           const struct facets_lit *lit, unsigned lanes,
                           struct shares *shares)
{
    LANE_LINES double highlights[RAY_LANES];
    const struct finish_meetings meetings = {
        (const double(*)[RAY_LANES])facets->normal,
        (const double(*)[RAY_LANES])facets->view, lit->direction
    };
    finish_highlight_many(finish, &meetings, lanes, highlights);
    for (; lanes; lanes &= lanes - 1) {
        unsigned i = (unsigned)__builtin_ctz(lanes);
        vec3 pigment = lane_get(facets->pigment, i);
        rgb share = finish_highlights_tinted(
            finish, highlights[i], rgb_make(pigment.x, pigment.y, pigment.z),
            shares->cosine[i]);
        lane_put(shares->of, i,
                 vec3_add(lane_get(shares->of, i), vec3_of(share)));
    }
}

static void highlight_shares(const struct facets *facets,
                             const struct facets_lit *lit, unsigned lanes,
                             struct shares *shares)
{
    for (unsigned i = 0; i < RAY_LANES; i++)
        if (!(shares->cosine[i] > 0 || facets->twice[i]))
            lanes &= ~(1u << i);
    while (lanes) {
        const struct finish *finish = facets->finish[__builtin_ctz(lanes)];
        unsigned same = 0;
        for (unsigned each = lanes; each; each &= each - 1) {
            unsigned i = (unsigned)__builtin_ctz(each);
            same |= (unsigned)(facets->finish[i] == finish) << i;
        }
        highlight_same(facets, finish, lit, same, shares);
        lanes &= ~same;
    }
}

CLONES static void add_shares(struct facets *restrict facets,
                              const struct shares *restrict shares,
                              const struct facets_lit *restrict lit,
                              const lane_flag *restrict is_lit)
{
    for (int k = 0; k < 3; k++)
        for (int i = 0; i < RAY_LANES; i++) {
            double sent = shares->of[k][i] * lit->colour[k][i];
            double light = facets->light[k][i];
            double more = light + facets->weight[k][i] * sent;
            facets->light[k][i] = is_lit[i] ? more : light;
        }
}

void facets_add_one(struct facets *facets, unsigned i,
                    const struct light_sample *sample)
{
    rgb light = facets_light(facets, i);
    surface_add_light(facets_surface(facets, i), sample, &light);
    lane_put(facets->light, i, vec3_of(light));
}

/* Those that no loop can do. */
static void add_each(struct facets *facets, const struct facets_lit *lit,
                     unsigned lanes)
{
    for (; lanes; lanes &= lanes - 1) {
        unsigned i = (unsigned)__builtin_ctz(lanes);
        const struct light_sample sample = {
            .direction = { lit->direction[0][i], lit->direction[1][i],
                           lit->direction[2][i] },
            .colour = { lit->colour[0][i], lit->colour[1][i],
                        lit->colour[2][i] },
            .highlights = lit->highlights,
        };
        facets_add_one(facets, i, &sample);
    }
}

void facets_add(struct facets *facets, const struct facets_lit *lit,
                unsigned lanes)
{
    unsigned single = lanes & ~facets->layered;
    struct shares shares;
    LANE_LINES lane_flag is_lit[RAY_LANES];
    add_each(facets, lit, lanes & facets->layered);
    if (!single)
        return;
    for (unsigned i = 0; i < RAY_LANES; i++)
        is_lit[i] = -(lane_flag)(single >> i & 1);
    diffuse_shares(facets, lit->direction, &shares);
    uneven_shares(facets, lit, single & facets->uneven, &shares);
    if (lit->highlights)
        highlight_shares(facets, lit, single & facets->shining, &shares);
    tint_shares(facets, lit, single & facets->tinted, &shares);
    add_shares(facets, &shares, lit, is_lit);
}
