/* H. W. Jensen, S. R. Marschner, M. Levoy and P. Hanrahan, "A Practical Model
 * for Subsurface Light Transport" (SIGGRAPH 2001): a dipole for light that is
 * scattered often, equation (4), and single scattering, (6); H. W. Jensen and
 * J. Buhler, "A Rapid Hierarchical Rendering Technique for Translucent
 * Materials" (SIGGRAPH 2002), equation (15): what albedo within makes a surface
 * reflect so much.
 *
 * Measured on POV-Ray 3.7, on flat bodies: pigment times diffuse is what is
 * reflected, the translucency is the mean way between scatterings in mm, both
 * Fresnel factors are exact and not made up for, the mean one within A is that
 * from outside; the mean is of those ways that lead out of the body (of an
 * infinite plane half of all: it sends back twice as much); single scattering
 * is isotropic, dimmed once more on its way out and divided by pi. */
#include "tracer/subsurface.h"

#include <string.h>

#include "base/draw.h"
#include "base/warp.h"
#include "lighting/lighting.h"
#include "shade/finish.h"
#include "shade/lamps.h"

enum {
    COLOURS = 3,
    SOLVER_STEPS = 30,
    LEAVES_MOST = 16, /* other things in the body that are looked through */
};

static const double pi = 3.14159265358979323846;
static const double reflected_most = 0.999; /* of light that goes in */
static const double upward_share = 0.75;    /* of looks for where it went in */
static const double depth_most = 0.5;       /* of the body's thickness there */

/* What the body does to one colour. Lengths in units of the world. */
struct scattering {
    double albedo;     /* at each meeting */
    double extinction; /* meetings for one unit of length */
    double transport;  /* of the diffuse light's fading, per unit */
    double depth;      /* of the source, and of its image above */
    double height;
};

/* A point that is looked at. */
struct seen_body {
    const struct tracer *tracer;
    struct worker *worker;
    enum ray_kind kind;
    const struct surface *surface;
    vec3 normal, across[2]; /* unit, outward */
    double ior;
    double thickness; /* below the point; 0: not yet known */
    struct scattering colours[COLOURS];
};

/* Diffuse reflectance of light from outside, mean of all directions (Egan's fit
 * for the inverse of the index). */
static double mean_reflectance(double ior)
{
    double f = -0.4399 + ior * (0.7099 + ior * (-0.3319 + ior * 0.0636));
    return fmin(fmax(f, 0), 0.99);
}

static double reflected_by(double albedo, double a)
{
    double s = sqrt(3 * (1 - albedo));
    return albedo / 2 * (1 + exp(-4. / 3 * a * s)) * exp(-s);
}

/* The albedo that makes a body reflect so much. */
static double albedo_for(double reflected, double a)
{
    double low = 0, high = 1;
    for (int i = 0; i < SOLVER_STEPS; i++) {
        double middle = (low + high) / 2;
        if (reflected_by(middle, a) < reflected)
            low = middle;
        else
            high = middle;
    }
    return (low + high) / 2;
}

static struct scattering scattering_of(double reflected, double length,
                                       double ior)
{
    double f = mean_reflectance(ior), a = (1 + f) / (1 - f);
    struct scattering s;
    s.albedo = albedo_for(fmin(fmax(reflected, 0), reflected_most), a);
    s.albedo = fmax(s.albedo, 1e-6);
    s.extinction = 1 / (length * s.albedo);
    s.transport = s.extinction * sqrt(3 * (1 - s.albedo));
    s.depth = 1 / s.extinction;
    s.height = s.depth * (1 + 4. / 3 * a);
    return s;
}

/* The dipole: of light that goes in at a distance, for one unit of area. */
static double dipole(const struct scattering *s, double distance)
{
    double sum = 0;
    for (int i = 0; i < 2; i++) {
        double z = i ? s->height : s->depth;
        double d = sqrt(distance * distance + z * z);
        sum +=
            z * (1 + s->transport * d) * exp(-s->transport * d) / (d * d * d);
    }
    return s->albedo / (4 * pi) * sum;
}

static double colour_at(rgb c, int i)
{
    return i == 0 ? c.r : i == 1 ? c.g : c.b;
}

static rgb colours_of(const double c[COLOURS])
{
    return (rgb){ c[0], c[1], c[2] };
}

/* Where a ray from within, and `from` on, leaves the body. Where all that is
 * met is other things, the body ends at the last: it stands on it. */
static bool body_exit(const struct seen_body *body, const struct ray *ray,
                      double from, struct intersection *out)
{
    const struct leaf *leaf = body->surface->at->leaf;
    struct intersection next;
    int met = 0;
    for (; met < LEAVES_MOST; met++) {
        if (!world_closest(body->tracer->world, ray, from, body->kind, &next))
            break;
        *out = next;
        if (out->leaf->body == leaf->body)
            return vec3_dot(out->normal, ray->direction) > 0;
        from = out->t + surface_offset(out->point);
    }
    if (met > 0 && vec3_dot(out->normal, ray->direction) < 0) {
        out->normal = vec3_scale(out->normal, -1);
        out->face = vec3_scale(out->face, -1);
    }
    return met > 0;
}

struct entering {
    vec3 normal;
    double ior;
    rgb light;
};

static double entering_share(double cosine, double ior)
{
    return cosine > 0 ? cosine * (1 - finish_fresnel(cosine, ior)) : 0;
}

static void enter_sample(void *context, const struct light_sample *sample)
{
    struct entering *entering = context;
    double cosine = vec3_dot(entering->normal, sample->direction);
    if (!sample->diffused)
        entering->light = rgb_add_scaled(entering->light, sample->colour,
                                         entering_share(cosine, entering->ior));
}

/* The light that goes in at a point of the body. */
static rgb light_entering(const struct seen_body *body,
                          const struct intersection *at)
{
    static const struct finish white = { .diffuse = 1, .brilliance = 1 };
    struct surface surface;
    struct entering entering = { at->normal, body->ior, rgb_grey(0) };
    surface.at = at;
    surface.point = at->point;
    surface.place = NULL;
    surface.unmirrored = false;
    surface.weight = body->surface->weight / 8; /* one of many */
    surface.view = surface.normal = at->normal;
    surface.side = at->face;
    surface.inside = body->surface->inside;
    surface.count = 1;
    surface.through = rgb_grey(0);
    memset(&surface.layer[0], 0, sizeof surface.layer[0]);
    surface.layer[0].finish = &white;
    surface.layer[0].pigment = (colour){ 1, 1, 1, 0, 0 };
    surface.layer[0].normal = at->normal;
    surface.layer[0].weight = rgb_grey(1);
    struct diffuse_light diffuse = body->tracer->lighting->illuminate(
        body->tracer->lighting_state, body->worker, &surface, enter_sample,
        &entering);
    return rgb_add_scaled(entering.light, diffuse.irradiance,
                          1 - mean_reflectance(body->ior));
}

/* How likely the way from a depth below the point is taken, for one unit of
 * area where it ends. */
static double way_density(const struct seen_body *body, double depth,
                          const struct intersection *at)
{
    vec3 from = vec3_along(body->surface->point, body->normal, -depth);
    vec3 way = vec3_sub(at->point, from);
    double length = vec3_length(way);
    if (!(length > 0))
        return 0;
    double cosine = fabs(vec3_dot(way, at->normal)) / length;
    double share =
        vec3_dot(way, body->normal) > 0 ? upward_share : 1 - upward_share;
    return share / (2 * pi) * cosine / (length * length);
}

static double look_depth(const struct seen_body *body, int i)
{
    return fmin(body->colours[i].depth, depth_most * body->thickness);
}

static vec3 look_direction(const struct seen_body *body, const double u[2])
{
    bool up = u[0] < upward_share;
    double rise =
        up ? u[0] / upward_share : -(u[0] - upward_share) / (1 - upward_share);
    double flat = sqrt(fmax(0, 1 - rise * rise)), turn = 2 * pi * u[1];
    vec3 way = vec3_scale(body->normal, rise);
    way = vec3_along(way, body->across[0], flat * cos(turn));
    return vec3_along(way, body->across[1], flat * sin(turn));
}

/* One look, from below the point where the source is, for a place that light
 * went in at: from there all that matter are likely as they matter. If there is
 * none adds to *missed what part of all ways it stands for. */
static rgb scattered_often(const struct seen_body *body,
                           const struct draws *draws, double *missed)
{
    double u[2], density = 0, weights[COLOURS];
    struct intersection at;
    draw_pair(draws, 0, u);
    double depth = look_depth(body, (int)(draws->index % COLOURS));
    struct ray ray = { vec3_along(body->surface->point, body->normal, -depth),
                       look_direction(body, u) };
    if (!body_exit(body, &ray, 0, &at)) {
        *missed +=
            0.5 / (u[0] < upward_share ? upward_share : 1 - upward_share);
        return rgb_grey(0);
    }
    for (int i = 0; i < COLOURS; i++)
        density += way_density(body, look_depth(body, i), &at) / COLOURS;
    double distance = vec3_length(vec3_sub(at.point, body->surface->point));
    double most = 0;
    for (int i = 0; i < COLOURS; i++) {
        weights[i] =
            density > 0 ? dipole(&body->colours[i], distance) / density : 0;
        most = fmax(most, weights[i]);
    }
    if (!(most > 1e-4))
        return rgb_grey(0);
    return rgb_mul(colours_of(weights), light_entering(body, &at));
}

/* What of one lamp's light comes through the surface to a point within and is
 * scattered there, towards the viewer. */
static rgb lamp_within(const struct seen_body *body, const struct lamp *lamp,
                       vec3 place, double cosine, double way)
{
    const struct lamps *lamps =
        body->tracer->lighting->lamps(body->tracer->lighting_state);
    struct lamp_target target = { .inside = body->surface->inside };
    struct intersection at;
    double shares[COLOURS];
    if (!lamp_is_for(lamp, body->surface->at->leaf) ||
        !lamp_look(lamp, lamp->light->location, place, &target.view))
        return rgb_grey(0);
    struct ray ray = { place, target.view.direction };
    if (!body_exit(body, &ray, 0, &at) || at.t > target.view.distance)
        return rgb_grey(0);
    target.point = at.point;
    target.leaf = at.leaf;
    target.face = at.face;
    if (!lamp_look(lamp, lamp->light->location, at.point, &target.view))
        return rgb_grey(0);
    double outside = vec3_dot(at.normal, target.view.direction);
    double share = entering_share(outside, body->ior);
    double within =
        sqrt(1 - (1 - outside * outside) / fmax(body->ior * body->ior, 1));
    double most = 0;
    for (int i = 0; i < COLOURS; i++) {
        const struct scattering *s = &body->colours[i];
        double straight = at.t * fabs(outside) / fmax(within, 1e-6);
        shares[i] = s->albedo / 4 * share / (1 + cosine / fmax(within, 1e-6)) *
                    exp(-s->extinction * (2 * way + straight)) * s->extinction;
        most = fmax(most, shares[i]);
    }
    if (!(most > 0))
        return rgb_grey(0);
    rgb light = rgb_scale(lamp->light->colour, target.view.attenuation);
    light = rgb_mul(light, lamps_share(lamps, lamp, body->worker, &target));
    return rgb_mul(light, colours_of(shares));
}

/* Of a point on the viewer's way on, within the body. `inward` is that way, at
 * `cosine` from the normal. */
static rgb scattered_once(const struct seen_body *body,
                          const struct draws *draws, vec3 inward, double cosine)
{
    const struct lamps *lamps =
        body->tracer->lighting->lamps(body->tracer->lighting_state);
    double u[2], density = 0;
    rgb sum = rgb_grey(0);
    draw_pair(draws, 1, u);
    double usual = 2 * body->colours[draws->index % COLOURS].extinction;
    double way = -log(1 - u[0]) / usual;
    for (int i = 0; i < COLOURS; i++) {
        double rate = 2 * body->colours[i].extinction;
        density += rate * exp(-rate * way) / COLOURS;
    }
    if (!(density > 0))
        return sum;
    vec3 place = vec3_along(body->surface->point, inward, way);
    for (size_t i = 0; i < lamps->count; i++)
        sum = rgb_add(sum,
                      lamp_within(body, &lamps->items[i], place, cosine, way));
    return rgb_scale(sum, 1 / density);
}

/* The bits of where it is. */
static uint64_t place_key(vec3 place)
{
    uint64_t bits[COLOURS];
    memcpy(bits, (const double[]){ place.x, place.y, place.z }, sizeof bits);
    return random_key(random_key(bits[0], bits[1]), bits[2]);
}

static rgb body_light(const struct seen_body *body)
{
    const struct subsurface_settings *said =
        &body->tracer->scene->settings.subsurface;
    const struct surface *surface = body->surface;
    double cosine = fmin(vec3_dot(surface->view, body->normal), 1);
    struct draws draws = { place_key(surface->point), 0 };
    rgb often = rgb_grey(0), once = rgb_grey(0);
    double missed = 0;
    const int *counts = said->samples;
    if (!(cosine > 0))
        return often;
    for (int i = 0; i < counts[0]; i++) {
        draws.index = (uint32_t)i;
        often = rgb_add(often, scattered_often(body, &draws, &missed));
    }
    double bent = 1 / body->ior;
    double within = sqrt(fmax(0, 1 - bent * bent * (1 - cosine * cosine)));
    vec3 inward = vec3_along(vec3_scale(surface->view, -bent), body->normal,
                             bent * cosine - within);
    for (int i = 0; i < counts[1]; i++) {
        draws.index = (uint32_t)i;
        once = rgb_add(once, scattered_once(body, &draws, inward, within));
    }
    rgb light = rgb_scale(often, 1. / fmax(counts[0] - missed, 1));
    light = rgb_add_scaled(light, once, 1. / fmax(counts[1], 1));
    return rgb_scale(light, 1 - finish_fresnel(cosine, body->ior));
}

/* The three colours of a layer; false: light goes nowhere in it. */
static bool body_fill(struct seen_body *body, const struct surface_layer *layer)
{
    const struct settings *settings = &body->tracer->scene->settings;
    const struct finish *finish = layer->finish;
    rgb reflected = rgb_scale(colour_rgb(layer->pigment), finish->diffuse);
    double most = rgb_peak(finish->translucency);
    for (int i = 0; i < COLOURS; i++) {
        double length = fmax(colour_at(finish->translucency, i), most * 1e-3) /
                        settings->subsurface.mm_per_unit;
        if (!(length > 0) || !isfinite(length))
            return false;
        body->colours[i] =
            scattering_of(colour_at(reflected, i), length, body->ior);
    }
    return true;
}

/* How far it is through the body, straight down. */
static double body_thickness(const struct seen_body *body)
{
    struct intersection at;
    struct ray down = { body->surface->point, vec3_scale(body->normal, -1) };
    double from = surface_offset(down.origin);
    return body_exit(body, &down, from, &at) ? at.t : HUGE_VAL;
}

rgb subsurface_light(const struct tracer *tracer, struct worker *worker,
                     enum ray_kind kind, struct crossing *crossing)
{
    struct surface *surface = &crossing->surface;
    rgb light = rgb_grey(0);
    struct seen_body body = { .tracer = tracer,
                              .worker = worker,
                              .kind = kind,
                              .surface = surface,
                              .normal = surface->normal,
                              .ior = fmax(crossing->ior, 1) };
    for (int i = 0; i < surface->count; i++) {
        struct surface_layer *layer = &surface->layer[i];
        if (rgb_peak(layer->finish->translucency) <= 0 ||
            !body_fill(&body, layer))
            continue;
        if (body.thickness == 0) {
            warp_frame(body.normal, &body.across[0], &body.across[1]);
            body.thickness = body_thickness(&body);
        }
        light = rgb_add(light, rgb_mul(layer->weight, body_light(&body)));
        struct finish *skin = ARENA_NEW(worker->scratch, struct finish);
        *skin = *layer->finish;
        skin->diffuse = skin->diffuse_back = 0;
        layer->finish = skin;
    }
    return light;
}
