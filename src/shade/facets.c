/* Surfaces side by side: see facets.h. */
#include "shade/facets.h"

#include <string.h>

#include "shade/finish.h"

static lane_flag flag(bool is)
{
    return is ? -1 : 0;
}

static void put(double to[3][RAY_LANES], unsigned i, double x, double y,
                double z)
{
    to[0][i] = x;
    to[1][i] = y;
    to[2][i] = z;
}

static vec3 get(const double (*from)[RAY_LANES], unsigned i)
{
    return (vec3){ from[0][i], from[1][i], from[2][i] };
}

/* The normals turned to the viewer, and nothing before the paint or lit. */
CLONES static void look_back(const struct rays *restrict rays,
                             const struct world_faces *restrict faces,
                             struct facets *restrict facets)
{
    for (int i = 0; i < RAY_LANES; i++) {
        vec3 direction = rays_direction(rays, i);
        vec3 n = { faces->normal[0][i], faces->normal[1][i],
                   faces->normal[2][i] };
        bool away = vec3_dot(n, direction) > 0;
        facets->normal[0][i] = away ? -n.x : n.x;
        facets->normal[1][i] = away ? -n.y : n.y;
        facets->normal[2][i] = away ? -n.z : n.z;
        facets->view[0][i] = -direction.x;
        facets->view[1][i] = -direction.y;
        facets->view[2][i] = -direction.z;
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
    facets->all = facets->layered = facets->matt = facets->shining = 0;
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
}

static void set_paint(struct facets *facets, unsigned i,
                      const struct surface_layer *layer)
{
    rgb weight = layer->weight;
    colour pigment = layer->pigment;
    set_finish(facets, i, layer->finish);
    facets->opacity[i] = layer_opacity(layer);
    put(facets->pigment, i, pigment.r, pigment.g, pigment.b);
    put(facets->weight, i, weight.r, weight.g, weight.b);
}

/* One of several layers may face any lamp. */
void facets_set(struct facets *facets, unsigned i,
                const struct surface *surface, rgb light)
{
    const struct surface_layer *layer = &surface->layer[0];
    const struct finish *finish = layer->finish;
    bool layered = surface->count != 1;
    vec3 normal = layered ? surface->normal : layer->normal;
    bool matt = !layered && finish->brilliance == 1 && !(finish->crand > 0) &&
                !finish_tints(finish);
    facets->all |= 1u << i;
    facets->surface[i] = surface;
    facets->leaf[i] = surface->at->leaf;
    facets->inside[i] = surface->inside;
    facets->layered |= (unsigned)layered << i;
    set_faces(facets, i, finish, layered);
    put(facets->normal, i, normal.x, normal.y, normal.z);
    put(facets->light, i, light.r, light.g, light.b);
    facets->matt |= (unsigned)matt << i;
    if (matt)
        set_paint(facets, i, layer);
}

/* The pigment, and the normal's bumps. */
static void paint_point(struct facets *facets, unsigned i,
                        const struct leaf *leaf, const struct layer *layer)
{
    const struct pigment *pigment = layer->pigment;
    bool bumpy = layer->normal && normal_tilts(layer->normal);
    colour c = pigment->colour;
    vec3 point = { 0, 0, 0 };
    if (bumpy || pigment->kind != PIGMENT_COLOUR)
        point = affine_point(leaf->to_texture, get(facets->point, i));
    if (pigment->kind != PIGMENT_COLOUR)
        c = pigment_colour(pigment, point);
    put(facets->pigment, i, c.r, c.g, c.b);
    if (!bumpy)
        return;
    vec3 normal = layer_bumped(layer, leaf->to_texture, leaf->from_texture,
                               point, get(facets->normal, i), NULL);
    put(facets->normal, i, normal.x, normal.y, normal.z);
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
}

void facets_paint(struct facets *facets, const struct world_hit *hits,
                  unsigned lanes)
{
    const struct leaf *last = NULL;
    unsigned before = 0;
    facets->all |= lanes;
    facets->matt |= lanes;
    for (; lanes; lanes &= lanes - 1) {
        unsigned i = (unsigned)__builtin_ctz(lanes);
        const struct leaf *leaf = hits[i].leaf;
        const struct layer *layer = &leaf->texture->layers[0];
        facets->surface[i] = NULL;
        if (leaf == last) {
            paint_as(facets, i, before);
        } else {
            facets->leaf[i] = leaf;
            set_faces(facets, i, layer->finish, false);
            set_finish(facets, i, layer->finish);
        }
        paint_point(facets, i, leaf, layer);
        last = leaf;
        before = i;
    }
}

const struct surface *facets_surface(struct facets *facets, unsigned i)
{
    if (!facets->surface[i])
        facets->surface[i] = facets->tell(facets->context, i);
    return facets->surface[i];
}

rgb facets_light(const struct facets *facets, unsigned i)
{
    return (rgb){ facets->light[0][i], facets->light[1][i],
                  facets->light[2][i] };
}

/* What white paint of these finishes makes of light without a direction. */
struct glows {
    double given[3][RAY_LANES], own[3][RAY_LANES];
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

void facets_glow(struct facets *facets, unsigned lanes, rgb ambient,
                 rgb irradiance)
{
    const struct finish *last = NULL;
    struct glows glows = { { { 0 } }, { { 0 } } };
    rgb given = rgb_grey(0), own = rgb_grey(0);
    for (; lanes; lanes &= lanes - 1) {
        unsigned i = (unsigned)__builtin_ctz(lanes);
        const struct finish *finish = facets->finish[i];
        if (finish != last) {
            given = finish_given(finish, ambient, irradiance);
            own = finish->glow;
        }
        last = finish;
        put(glows.given, i, given.r, given.g, given.b);
        put(glows.own, i, own.r, own.g, own.b);
    }
    add_glows(facets, &glows);
}

/* What the layers make of white light. */
struct shares {
    double cosine[RAY_LANES], of[3][RAY_LANES];
};

CLONES static void diffuse_shares(const struct facets *restrict facets,
                                  const double (*restrict direction)[RAY_LANES],
                                  struct shares *restrict shares)
{
    for (int i = 0; i < RAY_LANES; i++) {
        vec3 normal = { facets->normal[0][i], facets->normal[1][i],
                        facets->normal[2][i] };
        vec3 light = { direction[0][i], direction[1][i], direction[2][i] };
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

/* Of one finish. */
static void highlight_same(const struct facets *facets,
                           const struct finish *finish,
                           const struct facets_lit *lit, unsigned lanes,
                           struct shares *shares)
{
    double highlights[RAY_LANES];
    const struct finish_meetings meetings = {
        (const double(*)[RAY_LANES])facets->normal,
        (const double(*)[RAY_LANES])facets->view, lit->direction
    };
    finish_highlight_many(finish, &meetings, lanes, highlights);
    for (; lanes; lanes &= lanes - 1) {
        unsigned i = (unsigned)__builtin_ctz(lanes);
        vec3 pigment = get(facets->pigment, i);
        rgb share = finish_highlights_tinted(
            finish, highlights[i], rgb_make(pigment.x, pigment.y, pigment.z),
            shares->cosine[i]);
        shares->of[0][i] += share.r;
        shares->of[1][i] += share.g;
        shares->of[2][i] += share.b;
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
    put(facets->light, i, light.r, light.g, light.b);
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
    unsigned matt = lanes & facets->matt;
    struct shares shares;
    lane_flag is_lit[RAY_LANES];
    add_each(facets, lit, lanes & ~matt);
    if (!matt)
        return;
    for (unsigned i = 0; i < RAY_LANES; i++)
        is_lit[i] = -(lane_flag)(matt >> i & 1);
    diffuse_shares(facets, lit->direction, &shares);
    if (lit->highlights)
        highlight_shares(facets, lit, matt & facets->shining, &shares);
    add_shares(facets, &shares, lit, is_lit);
}
