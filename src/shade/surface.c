/* From an intersection to a surface: layers of paint from the top down, each
 * weighted with what those above let through. Composition as measured on
 * POV-Ray 3.7: a layer weighs the product of (filter * colour + transmit), and
 * with conserve_energy of (1 - reflection), over the layers above it. */
#include "shade/surface.h"

#include <float.h>

#include "base/clones.h"
#include "scene/spots.h"
#include "shade/finish.h"

/* The normal with the last bumps that were worked out at the point. Layers
 * without their own, and what chooses textures, see it in slope and aoi until
 * there are others; those of a picked texture as if its space were the world
 * (measured). */
struct bumps {
    bool any;
    vec3 normal; /* turned to the viewer */
};

/* A texture and its space: that of a picked one is its pattern's. */
struct place {
    const struct texture *texture;
    bool located; /* `point` is known: paint that is even never asks */
    vec3 point;
    const affine *to, *from; /* world <-> the texture's space */
    double share;            /* of the surface that has this texture */
    bool picked;
    const struct uv_source *uv;
    struct bumps *last;
};

/* The surface's own coordinates, worked out when they are asked for. */
struct surface_uv {
    struct uv_source source; /* first */
    const struct intersection *at;
};

static vec3 surface_uv_point(const struct uv_source *source)
{
    const struct surface_uv *uv = (const struct surface_uv *)source;
    return world_uv(uv->at);
}

/* The areas that the point cuts from the triangle. */
static void surface_corners(const struct uv_source *source, double shares[3])
{
    const struct intersection *at = ((const struct surface_uv *)source)->at;
    shares[0] = 1;
    shares[1] = shares[2] = 0;
    if (at->leaf->object->kind != OBJECT_MESH)
        return;
    vec3 corner[3];
    for (int k = 0; k < 3; k++)
        corner[k] = leaf_corner(at->leaf, (size_t)at->part, k);
    vec3 a = vec3_sub(corner[1], corner[0]), b = vec3_sub(corner[2], corner[0]);
    vec3 p = vec3_sub(at->point, corner[0]), face = vec3_cross(a, b);
    double area = vec3_dot(face, face);
    shares[1] = fmax(0, vec3_dot(vec3_cross(p, b), face) / area);
    shares[2] = fmax(0, vec3_dot(vec3_cross(a, p), face) / area);
    shares[0] = fmax(0, 1 - shares[1] - shares[2]);
}

/* `normal` is turned to the viewer. */
static struct surface_uv surface_uv(const struct intersection *at, vec3 normal,
                                    vec3 view)
{
    return (struct surface_uv){
        { surface_uv_point, surface_corners, at->point, normal, view }, at
    };
}

/* Where a normal or an object is laid by the surface's own coordinates, its
 * bumps stand in the world as they do in the texture; where the texture is,
 * they turn with the object (measured). */
static const affine unmoved = {
    { { 1, 0, 0, 0 }, { 0, 1, 0, 0 }, { 0, 0, 1, 0 } }
};

/* Of the whole texture at the point. */
static inline struct place place_at(const struct intersection *at,
                                    const struct uv_source *uv,
                                    struct bumps *last)
{
    bool mapped = at->leaf->look->uv_mapping;
    return (struct place){
        .texture = at->texture,
        .to = mapped ? &unmoved : at->to_texture,
        .from = mapped ? &unmoved : at->from_texture,
        .share = 1,
        .uv = uv,
        .last = last,
    };
}

/* The point, which is in the texture's space but for objects with uv_mapping.
 */
static vec3 place_point(struct place *place)
{
    const struct intersection *at = ((const struct surface_uv *)place->uv)->at;
    if (!place->located)
        place->point = at->leaf->look->uv_mapping
                           ? place->uv->point(place->uv)
                           : affine_point(place->to, at->point);
    place->located = true;
    return place->point;
}

/* The surface as slope and aoi see it. */
static inline struct surface_uv place_seen(const struct place *place)
{
    struct surface_uv surface = *(const struct surface_uv *)place->uv;
    if (place->last->any)
        surface.source.normal = place->last->normal;
    return surface;
}

static inline colour layer_pigment(const struct layer *layer,
                                   struct place *place, int quality)
{
    const struct pigment *pigment = layer->pigment;
    if (quality < QUALITY_TRANSPARENCY && pigment->has_quick_colour)
        return pigment->quick_colour;
    if (pigment->kind == PIGMENT_COLOUR)
        return pigment->colour;
    struct surface_uv surface = place_seen(place);
    return pigment_seen(pigment, place_point(place), &surface.source);
}

/* Bumps live in the texture's space: the normal goes there and back. Those of
 * what a map picks are as high as in there (measured). */
static vec3 layer_bumped(const struct layer *layer, const struct place *place,
                         vec3 point, vec3 normal)
{
    vec3 there = affine_normal(place->from, normal);
    vec3 bumped =
        normal_perturbed(layer->normal, point, vec3_normalise(there),
                         place->picked ? 0 : vec3_length(there), place->uv);
    vec3 back = vec3_normalise(affine_normal(place->to, bumped));
    return vec3_finite(back) ? back : normal;
}

CLONES static void normals_there(const affine *restrict from,
                                 const struct spots *restrict normals,
                                 double *restrict lengths,
                                 struct spots *restrict there)
{
    for (int i = 0; i < normals->count; i++) {
        vec3 normal = affine_normal(from, spots_at(normals, i));
        lengths[i] = vec3_length(normal);
        spots_put(there, i, vec3_normalise(normal));
    }
}

CLONES static void normals_back(const affine *restrict to,
                                const struct spots *restrict bumped,
                                struct spots *restrict normals)
{
    for (int i = 0; i < normals->count; i++) {
        vec3 normal = spots_at(normals, i);
        vec3 back = vec3_normalise(affine_normal(to, spots_at(bumped, i)));
        bool finite = (fabs(back.x) <= DBL_MAX) & (fabs(back.y) <= DBL_MAX) &
                      (fabs(back.z) <= DBL_MAX);
        spots_put(normals, i,
                  vec3_make(finite ? back.x : normal.x,
                            finite ? back.y : normal.y,
                            finite ? back.z : normal.z));
    }
}

void layer_bump_many(const struct layer *layer, const affine *to,
                     const affine *from, bool picked,
                     const struct spots *points, struct spots *normals)
{
    struct spots there, bumped;
    double lengths[SPOTS_MAX];
    there.count = normals->count;
    normals_there(from, normals, lengths, &there);
    normals_perturbed(layer->normal, points, &there, picked ? NULL : lengths,
                      &bumped);
    normals_back(to, &bumped, normals);
}

static vec3 layer_normal(const struct layer *layer, struct place *place,
                         vec3 normal)
{
    if (!layer->normal || !normal_tilts(layer->normal))
        return normal;
    if (layer->normal->pattern.uv && !layer->normal->uv_turned)
        return normal_perturbed(layer->normal, place->uv->point(place->uv),
                                normal, 0, place->uv);
    vec3 at =
        pattern_start(&layer->normal->pattern, place_point(place), place->uv);
    return layer_bumped(layer, place, at, normal);
}

/* The same; it is what is seen from now on. */
static vec3 layer_bump(const struct layer *layer, struct place *place,
                       vec3 normal)
{
    vec3 bumped = layer_normal(layer, place, normal);
    vec3 seen = place->picked
                    ? vec3_normalise(affine_normal(place->from, bumped))
                    : bumped;
    if (normal_tilts(layer->normal) && vec3_finite(seen))
        *place->last = (struct bumps){ true, seen };
    return bumped;
}

void surface_let_pass(struct surface *surface, const struct surface_layer *top,
                      rgb through)
{
    double share = rgb_peak(through);
    if (share > surface->pane_share) {
        surface->pane = top->normal;
        surface->pane_share = share;
    }
}

/* Adds the layers of a texture that has no choice; returns what all of them
 * let pass of `weight`. */
static rgb surface_add_layers(struct surface *surface,
                              const struct surface_view *view,
                              struct place *place, rgb weight)
{
    const struct texture *texture = place->texture;
    const struct surface_layer *top = &surface->layer[surface->count];
    bool smooth = view->smooth || view->quality < QUALITY_BUMPS;
    for (size_t i = texture->count; i-- > 0;) {
        if (surface->count == TEXTURE_LAYERS)
            break;
        const struct layer *source = &texture->layers[i];
        struct surface_layer *layer = &surface->layer[surface->count++];
        /* Kept at hand: what was just stored is read back late. */
        vec3 normal = smooth || !source->normal
                          ? surface->normal
                          : layer_bump(source, place, surface->normal);
        colour pigment = layer_pigment(source, place, view->quality);
        const struct surface_paint paint = { source->finish, surface->point,
                                             surface->normal, normal, pigment };
        struct finish_mirror mirror =
            finish_mirror_seen(&paint, surface->view, view->ior);
        layer->finish = source->finish;
        layer->weight = weight;
        layer->normal = normal;
        layer->pigment = pigment;
        /* A mirror's light has no other weight: see
         * tracer/integrator/recursive.c. */
        layer->reflection = rgb_scale(mirror.colour, place->share);
        layer->reflection_weight = mirror.weight;
        weight =
            rgb_mul(weight, finish_through(source->finish, pigment, &mirror));
        if (fabs(rgb_brightness(weight)) < view->bailout)
            break;
    }
    surface_let_pass(surface, top, weight);
    return weight;
}

static rgb surface_add_choice(struct surface *surface,
                              const struct surface_view *view,
                              struct place *place, rgb weight);

/* As above, of any texture. */
static rgb surface_add(struct surface *surface, const struct surface_view *view,
                       struct place *place, rgb weight)
{
    return place->texture->choice
               ? surface_add_choice(surface, view, place, weight)
               : surface_add_layers(surface, view, place, weight);
}

/* A blend is as if each of both covered its share of the place. Only bumps ask
 * for the way into what is picked and back. */
static rgb surface_add_choice(struct surface *surface,
                              const struct surface_view *view,
                              struct place *place, rgb weight)
{
    const struct texture_choice *choice = place->texture->choice;
    struct texture_pick picks[TEXTURE_PICKS];
    struct place inner = *place;
    affine to, from;
    rgb through = rgb_grey(0);
    bool mapped = choice->pattern.uv;
    struct surface_uv seen = place_seen(place);
    int count = texture_choose(choice, place_point(place), &seen.source, picks,
                               &inner.point);
    inner.located = inner.picked = true;
    if (texture_choice_ways(choice, mapped ? &unmoved : place->to,
                            mapped ? &unmoved : place->from, &to, &from)) {
        inner.to = &to;
        inner.from = &from;
    }
    for (int i = 0; i < count; i++) {
        inner.texture = picks[i].texture;
        inner.share = place->share * picks[i].share;
        through =
            rgb_add(through, surface_add(surface, view, &inner,
                                         rgb_scale(weight, picks[i].share)));
    }
    return through;
}

static void surface_fill_layers(struct surface *surface,
                                const struct surface_view *view)
{
    struct surface_uv uv =
        surface_uv(surface->at, surface->normal, surface->view);
    struct bumps last = { .any = false };
    struct place place = place_at(surface->at, &uv.source, &last);
    surface->through = surface_add(surface, view, &place, rgb_grey(1));
}

/* At the lowest qualities a surface is the plain colour of its deepest layer
 * that still shows (measured). */
static void surface_fill_quick(struct surface *surface,
                               const struct surface_view *view)
{
    const struct intersection *at = surface->at;
    const struct texture *texture = at->texture;
    struct surface_uv uv = surface_uv(at, surface->normal, surface->view);
    struct bumps last = { .any = false };
    struct place place = place_at(at, &uv.source, &last);
    rgb weight = rgb_grey(1);
    surface->count = 1;
    for (size_t i = texture->choice ? 1 : texture->count; i-- > 0;) {
        const struct layer *source = &texture->layers[i];
        surface->layer[0] = (struct surface_layer){
            .finish = source->finish,
            .pigment = layer_pigment(source, &place, view->quality),
            .normal = surface->normal,
            .weight = rgb_grey(1),
        };
        weight =
            rgb_mul(weight, colour_transmittance(surface->layer[0].pigment));
        if (fabs(rgb_brightness(weight)) < view->bailout)
            break;
    }
}

void surface_fill(struct surface *surface, const struct intersection *at,
                  const struct surface_view *view)
{
    surface->at = at;
    surface->point = at->point;
    surface->place = NULL;
    surface->unmirrored = false;
    surface->weight = 1;
    surface->view = vec3_negate(view->direction);
    surface->inside = view->inside;
    surface->normal = vec3_against(at->normal, view->direction);
    surface->side = vec3_against(at->face, view->direction);
    surface->count = 0;
    surface->through = rgb_grey(0);
    surface->pane = surface->normal;
    surface->pane_share = 0;
    if (view->quality < QUALITY_LIT)
        surface_fill_quick(surface, view);
    else
        surface_fill_layers(surface, view);
}

rgb surface_transmittance(const struct intersection *at)
{
    return surface_passes(at, vec3_negate(at->normal));
}

rgb surface_passes(const struct intersection *at, vec3 direction)
{
    struct surface_uv uv = surface_uv(at, vec3_against(at->normal, direction),
                                      vec3_negate(vec3_normalise(direction)));
    struct bumps last = { .any = false };
    struct place place = place_at(at, &uv.source, &last);
    return texture_transmittance(at->texture, place_point(&place), place.uv);
}

vec3 surface_bumps(const struct intersection *at, vec3 direction)
{
    bool behind = vec3_dot(at->normal, direction) > 0;
    const struct texture *texture = at->texture;
    struct surface_uv uv = surface_uv(at, at->normal, at->normal);
    struct bumps last = { .any = false };
    struct place place = place_at(at, &uv.source, &last);
    return layer_normal(&texture->layers[texture->count - 1], &place,
                        behind ? vec3_negate(at->normal) : at->normal);
}

bool surface_faces(const struct surface *surface, vec3 direction)
{
    bool twice = surface->at->leaf->look->double_illuminate;
    for (int i = 0; i < surface->count; i++) {
        const struct surface_layer *layer = &surface->layer[i];
        double cosine = vec3_dot(layer->normal, direction);
        if (finish_lit_by(layer->finish, cosine, twice))
            return true;
    }
    return false;
}
