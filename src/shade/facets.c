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

/* The normals turned to the viewer, and nothing lit. */
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
    }
    for (int k = 0; k < 3; k++)
        for (int i = 0; i < RAY_LANES; i++)
            facets->light[k][i] = 0;
}

/* Number `k`, to be painted: the normals are without bumps so far. */
static struct facet_layer *layer_at(struct facets *facets, unsigned k)
{
    for (; facets->depth <= k; facets->depth++) {
        struct facet_layer *layer = &facets->layer[facets->depth];
        layer->lanes = layer->shining = layer->uneven = layer->tinted =
            layer->begins = 0;
        memcpy(layer->normal, facets->normal, sizeof layer->normal);
        memset(layer->front, 0, sizeof layer->front);
        memset(layer->back, 0, sizeof layer->back);
    }
    return &facets->layer[k];
}

void facets_start(struct facets *facets, const struct rays *rays,
                  const struct world_faces *faces)
{
    facets->faces = faces;
    facets->all = facets->layered = facets->blended = facets->depth = 0;
    memcpy(facets->point, faces->point, sizeof facets->point);
    memset(facets->twice, 0, sizeof facets->twice);
    memset(facets->many, 0, sizeof facets->many);
    look_back(rays, faces, facets);
    layer_at(facets, 0);
}

static void set_finish(struct facet_layer *layer, unsigned lanes,
                       const struct finish *finish, bool twice)
{
    lane_flag front = flag(finish_lit_by(finish, 1, twice));
    lane_flag back = flag(finish_lit_by(finish, -1, twice));
    layer->lanes |= lanes;
    layer->shining |= finish_shines(finish) ? lanes : 0;
    layer->uneven |= finish_is_uneven(finish) ? lanes : 0;
    layer->tinted |= finish_tints(finish) ? lanes : 0;
    for (; lanes; lanes &= lanes - 1) {
        unsigned i = (unsigned)__builtin_ctz(lanes);
        layer->finish[i] = finish;
        layer->front[i] = front;
        layer->back[i] = back;
        layer->diffuse[i] = finish->diffuse;
        layer->diffuse_back[i] = finish->diffuse_back;
    }
}

static void set_paint(struct facet_layer *layer, unsigned i,
                      const struct surface_layer *from, bool twice)
{
    set_finish(layer, 1u << i, from->finish, twice);
    layer->opacity[i] = layer_opacity(from);
    lane_put(layer->normal, i, from->normal);
    lane_put(layer->pigment, i, vec3_of(colour_rgb(from->pigment)));
    lane_put(layer->weight, i, vec3_of(from->weight));
}

void facets_set(struct facets *facets, unsigned i,
                const struct surface *surface, rgb light)
{
    bool twice = surface->at->leaf->look->double_illuminate;
    bool layered = surface->count != 1;
    facets->all |= 1u << i;
    facets->surface[i] = surface;
    facets->leaf[i] = surface->at->leaf;
    facets->inside[i] = surface->inside;
    facets->worth[i] = surface->weight;
    facets->place[i] = surface->place;
    facets->layered |= (unsigned)layered << i;
    facets->many[i] = flag(layered);
    facets->twice[i] = flag(twice);
    lane_put(facets->light, i, vec3_of(light));
    for (int k = 0; k < surface->count; k++)
        set_paint(layer_at(facets, (unsigned)k), i, &surface->layer[k], twice);
}

/* Some of those of a leaf, and where they are in its texture. */
struct painted {
    unsigned lane[SPOTS_MAX];
    struct spots points;
};

/* A layer of them, and what it is painted with. `at`: where they are in its
 * space; NULL: by the coat. */
struct coating {
    struct facet_layer *to;
    const struct layer *from;
    const struct world_coat *coat;
    const struct lane_points *at;
};

static void paint_pigment(const struct coating *coating, unsigned i, colour c)
{
    struct facet_layer *to = coating->to;
    lane_put(to->pigment, i, vec3_of(colour_rgb(c)));
    to->clear[0][i] = c.filter;
    to->clear[1][i] = c.transmit;
    to->opacity[i] = finish_opacity(coating->from->finish, c);
}

static vec3 facet_uv(const struct facets *facets, unsigned i)
{
    return world_face_uv(facets->leaf[i], facets->faces, i);
}

static void paint_pigments(const struct facets *facets,
                           const struct coating *coating,
                           const struct painted *painted)
{
    const struct pigment *pigment = coating->from->pigment;
    colour colours[SPOTS_MAX];
    struct spots uv = { .count = 0 };
    for (int i = 0; pigment->pattern.uv && i < painted->points.count; i++)
        spots_add(&uv, facet_uv(facets, painted->lane[i]));
    pigment_colours(pigment, pigment->pattern.uv ? &uv : &painted->points,
                    colours);
    for (int i = 0; i < painted->points.count; i++)
        paint_pigment(coating, painted->lane[i], colours[i]);
}

static void paint_bumps(const struct coating *coating,
                        const struct painted *painted)
{
    const struct world_coat *coat = coating->coat;
    double(*normals)[RAY_LANES] = coating->to->normal;
    struct spots bumped;
    bumped.count = 0;
    for (int k = 0; k < painted->points.count; k++)
        spots_add(&bumped, lane_get(normals, painted->lane[k]));
    layer_bump_many(coating->from, coat->to_texture, coat->from_texture,
                    coating->at != NULL, &painted->points, &bumped);
    for (int k = 0; k < painted->points.count; k++)
        lane_put(normals, painted->lane[k], spots_at(&bumped, k));
}

/* Where number i is in the texture's space. */
static vec3 coat_point(const struct facets *facets,
                       const struct world_coat *coat, unsigned i)
{
    return facets->leaf[i]->look->uv_mapping
               ? facet_uv(facets, i)
               : affine_point(coat->to_texture, lane_get(facets->point, i));
}

/* As many of the lanes as are painted at a time, which are taken from them.
 * `at` as of a coating. */
static void painted_take(struct painted *painted, const struct facets *facets,
                         const struct world_coat *coat,
                         const struct lane_points *at, unsigned *lanes)
{
    struct spots *points = &painted->points;
    points->count = 0;
    for (; *lanes && points->count < SPOTS_MAX; *lanes &= *lanes - 1) {
        unsigned i = (unsigned)__builtin_ctz(*lanes);
        painted->lane[points->count] = i;
        spots_add(points,
                  at ? lane_get(at->at, i) : coat_point(facets, coat, i));
    }
}

/* The pigments, and the normals' bumps. */
static void paint_points(const struct facets *facets,
                         const struct coating *coating, unsigned lanes)
{
    const struct pigment *pigment = coating->from->pigment;
    const struct normal *normal = coating->from->normal;
    bool bumpy = normal && normal_tilts(normal);
    bool even = pigment->kind == PIGMENT_COLOUR;
    for (unsigned each = lanes; even && each; each &= each - 1)
        paint_pigment(coating, (unsigned)__builtin_ctz(each), pigment->colour);
    while (lanes && (bumpy || !even)) {
        struct painted painted; /* no more of it than is needed */
        painted_take(&painted, facets, coating->coat, coating->at, &lanes);
        if (!even)
            paint_pigments(facets, coating, &painted);
        if (bumpy)
            paint_bumps(coating, &painted);
    }
}

static colour pigment_at(const struct facet_layer *layer, unsigned i)
{
    return (colour){ layer->pigment[0][i], layer->pigment[1][i],
                     layer->pigment[2][i], layer->clear[0][i],
                     layer->clear[1][i] };
}

static rgb weight_at(const struct facet_layer *layer, unsigned i)
{
    return (rgb){ layer->weight[0][i], layer->weight[1][i],
                  layer->weight[2][i] };
}

/* What the layer, whose mirror takes nothing of it, lets through to the next
 * one. Returns where that can be seen. */
static unsigned weigh_next(struct facets *facets, unsigned k, unsigned lanes)
{
    const struct facet_layer *layer = &facets->layer[k];
    struct facet_layer *next = layer_at(facets, k + 1);
    unsigned seen = 0;
    for (; lanes; lanes &= lanes - 1) {
        unsigned i = (unsigned)__builtin_ctz(lanes);
        rgb through = colour_transmittance(pigment_at(layer, i));
        rgb weight = rgb_mul(weight_at(layer, i), through);
        bool is_seen = !(fabs(rgb_brightness(weight)) < facets->bailout);
        lane_put(next->weight, i, vec3_of(weight));
        seen |= (unsigned)is_seen << i;
    }
    return seen;
}

/* A texture without a choice, from layer `first` on, whose weight is known. */
struct painting {
    const struct texture *texture;
    const struct world_coat *coat;
    const struct lane_points *at; /* as of a coating */
    bool twice;
    unsigned first;
};

static void paint_layers(struct facets *facets, const struct painting *painting,
                         unsigned lanes)
{
    const struct texture *texture = painting->texture;
    unsigned k = painting->first;
    for (size_t left = texture->count; left > 0 && lanes; left--, k++) {
        const struct layer *from = &texture->layers[left - 1];
        const struct coating coating = { layer_at(facets, k), from,
                                         painting->coat, painting->at };
        set_finish(coating.to, lanes, from->finish, painting->twice);
        paint_points(facets, &coating, lanes);
        facets->layered |= k > 0 ? lanes : 0;
        lanes = left > 1 ? weigh_next(facets, k, lanes) : 0;
    }
}

/* How many layers of it can be seen. */
static unsigned facet_depth(const struct facets *facets, unsigned i)
{
    unsigned k = 0;
    while (k < facets->depth && facets->layer[k].lanes >> i & 1)
        k++;
    return k;
}

/* What a choice picks for each of some: one texture or the blend of two, and
 * where the facet is in their space. */
struct lane_picks {
    unsigned lanes[2]; /* those that have a first and a second one */
    struct texture_pick pick[RAY_LANES][2];
    struct lane_points at;
};

static void picks_find(const struct facets *facets,
                       const struct world_coat *coat, unsigned lanes,
                       struct lane_picks *picks)
{
    picks->lanes[0] = lanes;
    picks->lanes[1] = 0;
    while (lanes) {
        struct painted painted; /* no more of it than is needed */
        struct spots located;
        struct texture_pick pick[SPOTS_MAX][2];
        int counts[SPOTS_MAX];
        painted_take(&painted, facets, coat, NULL, &lanes);
        texture_choose_all(coat->texture->choice, &painted.points, &located,
                           pick, counts);
        for (int k = 0; k < painted.points.count; k++) {
            unsigned i = painted.lane[k];
            memcpy(picks->pick[i], pick[k], sizeof pick[k]);
            lane_put(picks->at.at, i, spots_at(&located, k));
            picks->lanes[1] |= (unsigned)(counts[k] > 1) << i;
        }
    }
}

/* A choice: both that are blended are as layers, each of its share. */
static void paint_choice(struct facets *facets, const struct world_coat *coat,
                         bool twice, unsigned lanes)
{
    struct lane_picks picks;
    affine to, from;
    struct world_coat inner = *coat;
    picks_find(facets, coat, lanes, &picks);
    facets->blended |= lanes;
    if (texture_choice_ways(coat->texture->choice, coat->to_texture,
                            coat->from_texture, &to, &from)) {
        inner.to_texture = &to;
        inner.from_texture = &from;
    }
    for (int n = 0; n < 2; n++)
        for (unsigned left = picks.lanes[n], same; left; left &= ~same) {
            unsigned one = (unsigned)__builtin_ctz(left);
            const struct painting painting = { picks.pick[one][n].texture,
                                               &inner, &picks.at, twice,
                                               facet_depth(facets, one) };
            struct facet_layer *first = layer_at(facets, painting.first);
            same = 0;
            for (unsigned each = left; each; each &= each - 1) {
                unsigned i = (unsigned)__builtin_ctz(each);
                const struct texture_pick *pick = &picks.pick[i][n];
                if (pick->texture != painting.texture ||
                    facet_depth(facets, i) != painting.first)
                    continue;
                lane_put(first->weight, i, vec3_of(rgb_grey(pick->share)));
                first->share[i] = pick->share;
                same |= 1u << i;
            }
            first->begins |= same;
            paint_layers(facets, &painting, same);
        }
}

/* Those of one leaf and one texture. */
static void paint_coat(struct facets *facets, const struct world_coat *coat,
                       bool twice, unsigned lanes)
{
    const struct painting painting = { coat->texture, coat, NULL, twice, 0 };
    if (coat->texture->choice) {
        paint_choice(facets, coat, twice, lanes);
        return;
    }
    for (unsigned each = lanes; each; each &= each - 1)
        lane_put(facets->layer[0].weight, (unsigned)__builtin_ctz(each),
                 vec3_make(1, 1, 1));
    paint_layers(facets, &painting, lanes);
}

static struct world_coat coat_of(const struct facets *facets,
                                 const struct leaf *leaf, unsigned i)
{
    if (leaf->look->coated)
        return world_face_coat(leaf, facets->faces, i,
                               vec3_negate(lane_get(facets->view, i)));
    return (struct world_coat){ leaf->look->texture, leaf->look->to_texture,
                                leaf->look->from_texture };
}

/* Those of one leaf. */
static void paint_leaf(struct facets *facets, const struct leaf *leaf,
                       unsigned lanes)
{
    for (unsigned each = lanes; each; each &= each - 1) {
        unsigned i = (unsigned)__builtin_ctz(each);
        facets->leaf[i] = leaf;
        facets->surface[i] = NULL;
        facets->twice[i] = flag(leaf->look->double_illuminate);
    }
    while (lanes) {
        struct world_coat coat =
            coat_of(facets, leaf, (unsigned)__builtin_ctz(lanes));
        unsigned same = lanes;
        for (unsigned each = leaf->look->coated ? lanes : 0; each;
             each &= each - 1) {
            unsigned i = (unsigned)__builtin_ctz(each);
            struct world_coat other = coat_of(facets, leaf, i);
            if (other.texture != coat.texture ||
                other.to_texture != coat.to_texture)
                same &= ~(1u << i);
        }
        paint_coat(facets, &coat, leaf->look->double_illuminate, same);
        lanes &= ~same;
    }
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
    for (unsigned each = facets->layered; each; each &= each - 1)
        facets->many[__builtin_ctz(each)] = flag(true);
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

bool facets_face(const struct facets *facets, unsigned i, vec3 way)
{
    unsigned depth = facet_depth(facets, i);
    for (unsigned k = 0; k < depth; k++) {
        const struct facet_layer *layer = &facets->layer[k];
        double cosine = vec3_dot(lane_get(layer->normal, i), way);
        if (cosine > 0 || facets->twice[i] ? layer->front[i]
                                           : cosine < 0 && layer->back[i])
            return true;
    }
    return false;
}

rgb facets_albedo(const struct facets *facets, unsigned i)
{
    rgb sum = rgb_grey(0);
    unsigned depth = facet_depth(facets, i);
    if (facets->surface[i])
        return surface_albedo(facets->surface[i]);
    for (unsigned k = 0; k < depth; k++) {
        const struct facet_layer *layer = &facets->layer[k];
        rgb albedo = rgb_scale(colour_rgb(pigment_at(layer, i)),
                               layer->diffuse[i] * layer->opacity[i]);
        sum = rgb_add(sum, rgb_mul(weight_at(layer, i), albedo));
    }
    return albedo_bounded(sum, RETURNED_MOST);
}

rgb facets_ambient(const struct facets *facets, unsigned i)
{
    rgb sum = rgb_grey(0);
    unsigned depth = facet_depth(facets, i);
    if (facets->surface[i])
        return surface_ambient(facets->surface[i]);
    for (unsigned k = 0; k < depth; k++) {
        const struct facet_layer *layer = &facets->layer[k];
        rgb share = rgb_mul(layer->finish[i]->ambient,
                            colour_rgb(pigment_at(layer, i)));
        share = rgb_scale(share, layer->opacity[i]);
        sum = rgb_add(sum, rgb_mul(weight_at(layer, i), share));
    }
    return sum;
}

static struct surface_paint paint_at(const struct facets *facets,
                                     const struct facet_layer *layer,
                                     unsigned i)
{
    return (struct surface_paint){
        .finish = layer->finish[i],
        .point = lane_get(facets->point, i),
        .normal = lane_get(facets->normal, i),
        .bumped = lane_get(layer->normal, i),
        .pigment = pigment_at(layer, i),
    };
}

struct surface_paint facets_paint_of(const struct facets *facets, unsigned i)
{
    return paint_at(facets, &facets->layer[0], i);
}

/* Of the surface, that the texture which begins with layer `top` has. */
static double texture_share(const struct facets *facets, unsigned i,
                            unsigned top)
{
    return facets->blended >> i & 1 ? facets->layer[top].share[i] : 1;
}

/* Returns what it lets through of what gets to it. */
static rgb fill_layer(const struct facets *facets, unsigned i, double ior,
                      const struct facet_layer *layer, struct surface_layer *to)
{
    struct surface_paint paint = paint_at(facets, layer, i);
    struct finish_mirror mirror =
        finish_mirror_seen(&paint, lane_get(facets->view, i), ior);
    to->finish = paint.finish;
    to->pigment = paint.pigment;
    to->normal = paint.bumped;
    to->weight = weight_at(layer, i);
    to->reflection = mirror.colour;
    to->reflection_weight = mirror.weight;
    return finish_through(paint.finish, paint.pigment, &mirror);
}

/* Whether a texture ends with layer `k`. */
static bool facet_ends(const struct facets *facets, unsigned i, unsigned k,
                       unsigned depth)
{
    return k + 1 == depth ||
           (facets->blended >> i & 1 && facets->layer[k + 1].begins >> i & 1);
}

void facets_fill(const struct facets *facets, unsigned i, double ior,
                 struct surface *surface)
{
    unsigned depth = facet_depth(facets, i);
    surface->point = lane_get(facets->point, i);
    surface->view = lane_get(facets->view, i);
    surface->normal = lane_get(facets->normal, i);
    surface->count = (int)depth;
    surface->through = rgb_grey(0);
    surface->pane = surface->normal;
    surface->pane_share = 0;
    unsigned top = 0;
    for (unsigned k = 0; k < depth; k++) {
        struct surface_layer *to = &surface->layer[k];
        rgb through = fill_layer(facets, i, ior, &facets->layer[k], to);
        to->reflection =
            rgb_scale(to->reflection, texture_share(facets, i, top));
        if (!facet_ends(facets, i, k, depth))
            continue;
        through = rgb_mul(to->weight, through);
        surface->through = rgb_add(surface->through, through);
        surface_let_pass(surface, &surface->layer[top], through);
        top = k + 1;
    }
}

rgb facets_light(const struct facets *facets, unsigned i)
{
    return (rgb){ facets->light[0][i], facets->light[1][i],
                  facets->light[2][i] };
}
