/* Shadow rays with coloured filters: see shadow.h. Measured on POV-Ray 3.7:
 * every surface on the way filters once; a segment that ends where the ray
 * leaves a body fades by that body's interior; reflection and Fresnel don't
 * weaken the light. */
#include "shade/shadow.h"

#include "shade/interior.h"
#include "shade/surface.h"

enum { CROSSINGS_MAX = 128 }; /* fading is exact up to here */

/* Shadow rays see nothing closer than this to the lamp, nor to the surface
 * (POV-Ray's, measured). */
static const double shadow_margin = 1e-3;

struct shadow_ray {
    rgb share;
    bool fades;
    int count;
    struct {
        double t;
        const struct leaf *leaf;
    } at[CROSSINGS_MAX];
};

double surface_offset(vec3 point)
{
    double size = 0.9999e3;
    size = fabs(point.x) > size ? fabs(point.x) : size;
    size = fabs(point.y) > size ? fabs(point.y) : size;
    size = fabs(point.z) > size ? fabs(point.z) : size;
    return 1e-7 * size;
}

/* Notes the crossing in order of t, for fading. */
static void shadow_note(struct shadow_ray *shadow,
                        const struct intersection *at)
{
    int i = shadow->count;
    if (i == CROSSINGS_MAX)
        return;
    for (; i > 0 && shadow->at[i - 1].t > at->t; i--)
        shadow->at[i] = shadow->at[i - 1];
    shadow->at[i].t = at->t;
    shadow->at[i].leaf = at->leaf;
    shadow->count++;
}

static bool shadow_filter(void *context, const struct intersection *at)
{
    struct shadow_ray *shadow = context;
    shadow->share = rgb_mul(shadow->share, surface_transmittance(at));
    shadow->fades = shadow->fades || interior_dims_shadows(at->leaf->interior);
    shadow_note(shadow, at);
    return rgb_peak(shadow->share) < 1e-9;
}

static void shadow_fade(struct shadow_ray *shadow,
                        const struct interiors *around)
{
    struct interiors inside;
    double from = 0;
    inside.count = 0;
    if (around)
        interiors_copy(&inside, around);
    for (int i = 0; i < shadow->count; i++) {
        const struct leaf *leaf = shadow->at[i].leaf;
        double to = shadow->at[i].t;
        if (interior_dims_shadows(leaf->interior) &&
            interiors_find(&inside, leaf->body) >= 0)
            shadow->share = rgb_mul(shadow->share,
                                    interior_fade(leaf->interior, to - from));
        interiors_cross(&inside, leaf);
        from = to;
    }
}

rgb shadow_visibility(const struct world *world, struct worker *worker,
                      const struct shadow_path *path)
{
    double from = fmax(shadow_margin, surface_offset(path->point));
    double to = path->distance - shadow_margin;
    struct ray ray = { path->point, path->direction };
    struct shadow_ray shadow;
    if (!(to > from))
        return rgb_grey(1);
    shadow.share = rgb_grey(1);
    shadow.fades = false;
    shadow.count = 0;
    worker->counters.shadow_rays++;
    if (world_occluded(world, &ray, from, to, path->light, shadow_filter,
                       &shadow))
        return rgb_grey(0);
    if (shadow.fades)
        shadow_fade(&shadow, path->inside);
    return shadow.share;
}
