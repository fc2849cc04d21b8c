/* Rays at surfaces: see crossing.h. */
#include "tracer/crossing.h"

/* The ior by which POV-Ray's Fresnel mirrors. Where a ray leaves a body while
 * it is in others, what it entered last counts as behind the surface, and that
 * is mostly the body itself: glass under a sky that is a sphere mirrors nothing
 * on its inside (measured). */
static double crossing_mirror_ior(const struct crossing *crossing,
                                  const struct interiors *inside)
{
    const struct interior *left = crossing->at.leaf->look->interior;
    if (!crossing->leaving || inside->count < 2)
        return crossing->ior;
    return interiors_ior(inside) / interiors_ior_of(inside, left);
}

/* From one side to the other. */
static void crossing_pass(struct crossing *crossing,
                          const struct interiors *inside)
{
    interiors_copy(&crossing->beyond, inside);
    interiors_cross(&crossing->beyond, crossing->at.leaf);
    crossing->leaving = crossing->beyond.count < inside->count;
    crossing->ior = interiors_ior(&crossing->beyond) / interiors_ior(inside);
}

double crossing_plain_ior(const struct leaf *leaf,
                          const struct interiors *inside)
{
    struct crossing crossing;
    crossing.at.leaf = leaf;
    crossing_pass(&crossing, inside);
    return crossing_mirror_ior(&crossing, inside);
}

void crossing_fill_facet(struct crossing *crossing, const struct facets *facets,
                         unsigned i)
{
    const struct interiors *inside = facets->inside[i];
    crossing->at.leaf = facets->leaf[i];
    crossing->at.t = facets->faces->hit[i].t;
    crossing->at.point = lane_get(facets->point, i);
    crossing_pass(crossing, inside);
    facets_fill(facets, i, crossing_mirror_ior(crossing, inside),
                &crossing->surface);
}

void crossing_fill(struct crossing *crossing, const struct tracer *tracer,
                   vec3 direction, const struct interiors *inside,
                   double bailout, bool exact)
{
    crossing_pass(crossing, inside);
    struct surface_view view = {
        .direction = direction,
        .inside = inside,
        .ior = exact ? crossing->ior : crossing_mirror_ior(crossing, inside),
        .quality = tracer->quality,
        .bailout = bailout,
    };
    surface_fill(&crossing->surface, &crossing->at, &view);
}

static const struct interior *interiors_last(const struct interiors *list)
{
    return list->count > 0 ? list->at[list->count - 1].interior : NULL;
}

int crossing_parts(const struct crossing *crossing,
                   const struct interiors *inside)
{
    const struct interior *before = interiors_last(inside),
                          *behind = interiors_last(&crossing->beyond);
    if (inside->divided)
        return 1;
    if (behind && behind->dispersion != 1)
        return behind->dispersion_samples;
    return before && before->dispersion != 1 ? before->dispersion_samples : 1;
}

void crossing_divide(struct crossing *crossing, struct interiors *inside,
                     double place)
{
    inside->divided = crossing->beyond.divided = true;
    inside->place = crossing->beyond.place = place;
    crossing->ior = interiors_ior(&crossing->beyond) / interiors_ior(inside);
}

bool crossing_refracted(const struct crossing *crossing, vec3 direction,
                        vec3 normal, vec3 *out)
{
    double n = 1 / crossing->ior, cosine = -vec3_dot(direction, normal);
    if (cosine < 0) {
        cosine = -cosine;
        normal = vec3_negate(normal);
    }
    double left = 1 - n * n * (1 - cosine * cosine);
    if (!(left >= 0))
        return false;
    vec3 bent =
        vec3_along(vec3_scale(direction, n), normal, n * cosine - sqrt(left));
    *out = vec3_normalise(bent);
    return true;
}

int tracer_levels(const struct tracer *tracer)
{
    int levels = tracer->scene->settings.max_trace_level;
    return levels < SETTINGS_LEVELS_MAX ? levels : SETTINGS_LEVELS_MAX;
}

bool tracer_foggy(const struct tracer *tracer, const struct interiors *inside)
{
    return tracer->scene->fogs.count > 0 && tracer->quality >= QUALITY_FOG &&
           interiors_open(inside);
}

bool tracer_arched(const struct tracer *tracer, const struct interiors *inside)
{
    return tracer->scene->rainbows.count > 0 &&
           tracer->quality >= QUALITY_FOG && interiors_open(inside);
}

bool tracer_misty(const struct tracer *tracer)
{
    return tracer->scene->misty && tracer->quality >= QUALITY_FOG;
}

/* Without +UA the background's transmit darkens it and its filter does
 * nothing. With +UA both make it transparent where the camera sees it, and
 * neither matters in a mirror; before version 3.7 sky and background are not
 * seen by the camera at all (measured). */
rgb tracer_beyond(const struct tracer *tracer, const struct veil *sky,
                  bool straight, double *clear)
{
    colour c = tracer->scene->background;
    const struct settings *settings = &tracer->scene->settings;
    bool transparent = tracer->alpha && straight;
    *clear = transparent ? 1 : 0;
    if (transparent && settings->old_filter)
        return rgb_grey(0);
    if (transparent && settings->clear_background)
        c = (colour){ .transmit = 1 };
    double share = 1 - c.transmit;
    if (tracer->alpha)
        share = straight ? 1 - c.filter - c.transmit : 1;
    if (transparent)
        *clear = rgb_brightness(sky->through) *
                 rgb_brightness(colour_transmittance(c));
    rgb light = rgb_scale(colour_rgb(c), share);
    return rgb_add(sky->light, rgb_mul(sky->through, light));
}

rgb tracer_background(const struct tracer *tracer, vec3 direction,
                      bool straight, double *clear)
{
    struct veil sky = sky_veil(tracer->scene, direction);
    return tracer_beyond(tracer, &sky, straight, clear);
}

static void interiors_enter(void *context, const struct leaf *leaf)
{
    struct interiors *inside = context;
    if (interiors_find(inside, leaf->body) < 0)
        interiors_cross(inside, leaf);
}

void tracer_inside(const struct tracer *tracer, vec3 point,
                   struct interiors *inside)
{
    interiors_clear(inside);
    world_containing(tracer->world, point, interiors_enter, inside);
}

static bool tracer_is_painted(const struct tracer *tracer)
{
    return !tracer->scene->settings.subsurface.on && !tracer->photons &&
           tracer->quality >= QUALITY_BUMPS;
}

static bool tracer_is_airless(const struct tracer *tracer)
{
    const struct scene *scene = tracer->scene;
    return scene->fogs.count == 0 && scene->rainbows.count == 0 &&
           !scene->misty;
}

/* Measured: rays of mesh cameras begin inside of nothing, wherever they do. */
void tracer_ready(struct tracer *tracer)
{
    const struct camera *camera = &tracer->scene->camera;
    struct box3 origins = box3_empty();
    interiors_clear(&tracer->start);
    for (int corner = 0; corner < 4; corner++)
        origins = box3_add(origins,
                           camera_ray(camera, corner % 2, corner / 2).origin);
    bool scattered = camera->kind->lines == CAMERA_SCATTERED;
    bool one = vec3_length(vec3_sub(origins.high, origins.low)) == 0;
    tracer->ready =
        scattered || one || world_contains_alike(tracer->world, origins);
    if (tracer->ready && !scattered)
        tracer_inside(tracer, origins.low, &tracer->start);
    tracer->airless = tracer->ready && tracer_is_airless(tracer);
    tracer->painted = tracer_is_painted(tracer);
}

void tracer_enter(const struct tracer *tracer, struct worker *worker,
                  vec3 origin, struct interiors *inside)
{
    worker->counters.camera_rays++;
    if (tracer->ready)
        interiors_copy(inside, &tracer->start);
    else
        tracer_inside(tracer, origin, inside);
}

struct ray tracer_start(const struct tracer *tracer, struct worker *worker,
                        double x, double y, struct interiors *inside)
{
    struct ray ray = camera_ray(&tracer->scene->camera, x, y);
    tracer_enter(tracer, worker, ray.origin, inside);
    return ray;
}
