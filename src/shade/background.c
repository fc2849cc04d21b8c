/* Fog and sky: see background.h. Measured on POV-Ray 3.7. */
#include "shade/background.h"

#include "base/lesser.h"
#include "scene/noise.h"
#include "scene/rays.h"

_Static_assert((int)SPOTS_MAX >= (int)RAY_LANES, "all rays of a packet");

/* How long a ray is that hits nothing (measured). */
static const double fog_horizon = 2e10;

/* The integral of the density of ground fog, 1 below and 1 / (1 + h^2) above
 * the height 0 (measured). */
static double fog_integral(double height)
{
    return height > 0 ? atan(height) : height;
}

/* Ways through fog: rays and how far they go. */
struct fog_ways {
    const struct scene *scene;
    int count;
    struct ray ray[SPOTS_MAX];
    double distance[SPOTS_MAX];
};

/* How much of the fog noise at the middle of each way leaves: the more, the
 * longer the way, also of ground fog that is above most of it (measured). */
static void fog_left(const struct fog_ways *ways, const struct fog *fog,
                     double *left)
{
    const double unseen = 38; /* 1 less exp(-38) is 1 */
    double depth[SPOTS_MAX], noise[SPOTS_MAX];
    int number[SPOTS_MAX];
    struct spots middles = { .count = 0 };
    for (int i = 0; i < ways->count; i++) {
        const struct ray *ray = &ways->ray[i];
        double way = lesser(ways->distance[i], fog_horizon);
        left[i] = 1;
        depth[i] = way / fog->distance;
        if (!fog->turbulent || depth[i] > unseen)
            continue;
        number[middles.count] = i;
        vec3 middle = vec3_along(ray->origin, ray->direction, way / 2);
        spots_add(&middles, vec3_mul(fog->turbulence.amount, middle));
    }
    if (middles.count == 0)
        return;
    noise_turbulences(ways->scene->noise.generator, &middles, &fog->turbulence,
                      noise);
    for (int k = 0; k < middles.count; k++) {
        int i = number[k];
        left[i] =
            1 - exp(-depth[i]) * lesser(1, noise[k] * fog->turbulent_share);
    }
}

/* How much fog a ray meets without turbulence: the mean density times the way,
 * in the distances that leave 1/e. */
static double fog_depth(const struct fog *fog, const struct ray *ray,
                        double distance)
{
    if (!fog->ground)
        return distance / fog->distance;
    double way = lesser(distance, fog_horizon);
    double start =
        (vec3_dot(ray->origin, fog->up) - fog->offset) / fog->altitude;
    double rise = vec3_dot(ray->direction, fog->up) * way / fog->altitude;
    double middle = greater(start + rise / 2, 0);
    double density = 1 / (1 + middle * middle);
    if (fabs(rise) > 1e-4)
        density = (fog_integral(start + rise) - fog_integral(start)) / rise;
    double depth = density * way / fog->distance;
    return depth > 0 ? depth : 0;
}

/* Constant fog: T = exp(-d / distance), but at least `transmit`; the light
 * behind is tinted by `filter`. Several fogs add up: each weakens what is
 * behind, none weakens another's light. */
static void fog_ways_veils(const struct fog_ways *ways, struct veil *veils)
{
    const struct scene *scene = ways->scene;
    double left[SPOTS_MAX];
    for (int i = 0; i < ways->count; i++)
        veils[i] = (struct veil){ rgb_grey(0), rgb_grey(1) };
    for (size_t k = 0; k < scene->fogs.count; k++) {
        const struct fog *fog = &scene->fogs.items[k];
        rgb tone = colour_rgb(fog->colour);
        rgb tint = rgb_mix(rgb_grey(1), tone, fog->colour.filter);
        fog_left(ways, fog, left);
        for (int i = 0; i < ways->count; i++) {
            struct veil *veil = &veils[i];
            double depth = fog_depth(fog, &ways->ray[i], ways->distance[i]);
            double clear = greater(exp(-depth * left[i]), fog->colour.transmit);
            veil->light = rgb_add_scaled(veil->light, tone, 1 - clear);
            veil->through = rgb_mul(veil->through, rgb_scale(tint, clear));
        }
    }
}

struct veil fog_veil(const struct scene *scene, const struct ray *ray,
                     double distance)
{
    struct fog_ways ways; /* no more of it than is needed */
    struct veil veil;
    ways.scene = scene;
    ways.count = 1;
    ways.ray[0] = *ray;
    ways.distance[0] = distance;
    fog_ways_veils(&ways, &veil);
    return veil;
}

void fog_veils(const struct scene *scene, const struct rays *rays,
               unsigned lanes, const double *distances, struct veil *veils)
{
    struct fog_ways ways; /* no more of it than is needed */
    struct veil found[SPOTS_MAX];
    ways.scene = scene;
    ways.count = 0;
    for (unsigned each = lanes; each; each &= each - 1) {
        unsigned i = (unsigned)__builtin_ctz(each);
        ways.ray[ways.count] = rays_at(rays, (int)i);
        ways.distance[ways.count++] = distances[i];
    }
    fog_ways_veils(&ways, found);
    for (int k = 0; lanes; lanes &= lanes - 1)
        veils[__builtin_ctz(lanes)] = found[k++];
}

/* The pigments of a sky so far. */
struct sky_sum {
    rgb light;
    rgb through; /* to the next */
    rgb tint;    /* the product of their colours */
    double filter, transmit;
};

static const struct veil sky_none = { { 0, 0, 0 }, { 1, 1, 1 } };

static void sky_start(struct sky_sum *sum)
{
    sum->light = rgb_grey(0);
    sum->through = sum->tint = rgb_grey(1);
    sum->filter = sum->transmit = 1;
}

/* The next pigment, of which that colour is seen. */
static void sky_add(struct sky_sum *sum, const struct scene *scene, colour c)
{
    rgb own = rgb_mul(colour_rgb(c), scene->sky->emission);
    own = rgb_scale(own, 1 - c.filter - c.transmit);
    sum->light = rgb_add(sum->light, rgb_mul(sum->through, own));
    sum->tint = rgb_mul(sum->tint, colour_rgb(c));
    sum->filter *= c.filter;
    sum->transmit *= c.transmit;
    sum->through = scene->settings.old_filter
                       ? rgb_grey(sum->filter + sum->transmit)
                       : rgb_mul(sum->through, colour_transmittance(c));
}

static struct veil sky_end(const struct sky_sum *sum, const struct scene *scene)
{
    rgb through =
        scene->settings.old_filter
            ? rgb_add_scaled(rgb_grey(sum->transmit), sum->tint, sum->filter)
            : sum->through;
    return (struct veil){ sum->light, through };
}

static bool sky_is_there(const struct scene *scene)
{
    return scene->sky && scene->sky->count > 0;
}

/* Pigments from the top down; `emission` brightens each, not what is seen
 * through it. In scenes before version 3.7 filters colour only the background,
 * and only where all of them are on the way (measured). */
struct veil sky_veil(const struct scene *scene, vec3 direction)
{
    struct sky_sum sum;
    if (!sky_is_there(scene))
        return sky_none;
    sky_start(&sum);
    for (size_t i = scene->sky->count; i-- > 0;)
        sky_add(&sum, scene,
                pigment_colour(scene->sky->pigments[i], direction));
    return sky_end(&sum, scene);
}

void sky_veils(const struct scene *scene, const struct spots *directions,
               struct veil *veils)
{
    const int count = directions->count;
    struct sky_sum sums[SPOTS_MAX];
    colour colours[SPOTS_MAX];
    if (!sky_is_there(scene)) {
        for (int k = 0; k < count; k++)
            veils[k] = sky_none;
        return;
    }
    for (int k = 0; k < count; k++)
        sky_start(&sums[k]);
    for (size_t i = scene->sky->count; i-- > 0;) {
        pigment_colours(scene->sky->pigments[i], directions, colours);
        for (int k = 0; k < count; k++)
            sky_add(&sums[k], scene, colours[k]);
    }
    for (int k = 0; k < count; k++)
        veils[k] = sky_end(&sums[k], scene);
}

rgb background_light(const struct scene *scene, vec3 direction)
{
    colour c = scene->background;
    struct veil sky = sky_veil(scene, direction);
    rgb light = rgb_scale(colour_rgb(c), 1 - c.transmit);
    return rgb_add(sky.light, rgb_mul(sky.through, light));
}
