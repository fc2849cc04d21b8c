/* What a gather ray sees: see gather_paint.h. */
#include "lightmesh/gather_paint.h"

#include "base/warp.h"
#include "lightmesh/gather.h"
#include "lightmesh/tuning.h"
#include "scene/material.h"
#include "scene/pattern.h"
#include "scene/spots.h"
#include "shade/finish.h"

enum { PLACES = 6 };

/* Of the unit disc: along a Fermat spiral, each for as large a part. */
static const double places[PLACES][2] = {
    { 0.2887, 0.0000 }, { -0.3687, 0.3377 },  { 0.0564, -0.6430 },
    { 0.4647, 0.6061 }, { -0.8528, -0.1508 }, { 0.8078, -0.5139 },
};

/* Whether what is seen is a block pattern by the point alone. */
static const struct pigment *paint_blocks(const struct surface *surface)
{
    const struct leaf *leaf = surface->at->leaf;
    if (!leaf->look->spatial || leaf->look->texture->choice)
        return NULL;
    const struct pigment *pigment = leaf->look->texture->layers[0].pigment;
    const struct pattern_kind *kind = pigment->pattern.kind;
    bool blocks = pigment->kind == PIGMENT_PATTERN && kind && kind->blocks > 0;
    return blocks && !pigment->pattern.turbulent ? pigment : NULL;
}

void gather_paint(struct surface *surface, double radius)
{
    const struct pigment *pigment = paint_blocks(surface);
    if (!pigment)
        return;
    struct surface_layer *layer = &surface->layer[0];
    struct spots points; /* no more of it than is needed */
    colour colours[PLACES];
    rgb sum = rgb_grey(0);
    vec3 across, down;
    points.count = 0;
    warp_frame(surface->side, &across, &down);
    for (int i = 0; i < PLACES; i++) {
        vec3 point = vec3_along(surface->point, across, radius * places[i][0]);
        point = vec3_along(point, down, radius * places[i][1]);
        spots_add(&points, affine_point(surface->at->to_texture, point));
    }
    pigment_colours(pigment, &points, colours);
    for (int i = 0; i < PLACES; i++)
        sum = rgb_add(sum, colour_rgb(colours[i]));
    sum = rgb_scale(sum, 1.0 / PLACES);
    layer->pigment.r = sum.r;
    layer->pigment.g = sum.g;
    layer->pigment.b = sum.b;
}

static double surface_ior(const struct intersection *at)
{
    const struct interior *interior = at->leaf->look->interior;
    return interior ? interior->ior : 1;
}

void gather_surface(const struct gather *gather, const struct ray *ray,
                    const struct intersection *at, struct surface *surface)
{
    struct surface_view view = {
        .direction = ray->direction,
        .ior = surface_ior(at),
        .quality = gather->lamps->quality,
        .bailout = gather_least,
        .smooth = true,
    };
    surface_fill(surface, at, &view);
}

rgb gather_albedo(const struct surface *surface, double sky)
{
    double most = RETURNED_MOST / (1 + surface_behind(surface));
    return rgb_scale(albedo_bounded(surface_returned(surface), most),
                     1 - fmin(sky, 1));
}
