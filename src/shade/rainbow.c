/* Rainbows: see rainbow.h. Measured on POV-Ray 3.7: colour_map runs over the
 * band; like fog it hides what is behind with distance, but leaves at least
 * what its colour transmits, and its filter counts as far as it hides; from
 * `falloff` to `arc`, both halved about `up`, it fades by s^2 (3 - 2 s); where
 * no arc was said there is no fading. */
#include "shade/rainbow.h"

#include <string.h>

#include "base/random.h"

static double degrees_between(vec3 a, vec3 b)
{
    double lengths = vec3_length(a) * vec3_length(b);
    double cosine = lengths > 0 ? vec3_dot(a, b) / lengths : 1;
    return acos(fmin(fmax(cosine, -1), 1)) * (180 / 3.14159265358979323846);
}

/* A random number that belongs to the direction. */
static double rainbow_random(vec3 direction)
{
    uint64_t bits[3];
    memcpy(bits, &direction, sizeof bits);
    return random_unit(random_key(random_key(bits[0], bits[1]), bits[2]));
}

/* The part of the vector that is perpendicular to a unit vector. */
static vec3 vec3_across(vec3 a, vec3 unit)
{
    return vec3_along(a, unit, -vec3_dot(a, unit));
}

/* How much of it there is where the ray goes round the circle. */
static double rainbow_share(const struct rainbow *rainbow, vec3 direction)
{
    double half = rainbow->arc / 2, full = rainbow->falloff / 2;
    if (!isfinite(rainbow->arc))
        return 1;
    double away = degrees_between(vec3_across(direction, rainbow->direction),
                                  vec3_across(rainbow->up, rainbow->direction));
    if (away > half)
        return 0;
    if (away <= full)
        return 1;
    double s = (half - away) / (half - full);
    return s * s * (3 - 2 * s);
}

static struct veil rainbow_look(const struct rainbow *rainbow,
                                const struct ray *ray, double distance)
{
    struct veil veil = { rgb_grey(0), rgb_grey(1) };
    double off = degrees_between(ray->direction, rainbow->direction);
    double place = (off - rainbow->angle) / rainbow->width + 0.5;
    if (rainbow->jitter != 0)
        place += (2 * rainbow_random(ray->direction) - 1) * rainbow->jitter;
    if (!(place >= 0) || place > 1)
        return veil;
    double share = rainbow_share(rainbow, ray->direction);
    if (share == 0)
        return veil;
    colour c = blend_map_colour(rainbow->map, place);
    double transmit = 1 - share * (1 - c.transmit);
    double left = fmax(exp(-distance / rainbow->distance), transmit);
    rgb tint = rgb_mix(rgb_grey(1), colour_rgb(c), c.filter * (1 - left));
    veil.light = rgb_scale(colour_rgb(c), 1 - left);
    veil.through = rgb_scale(tint, left);
    return veil;
}

struct veil rainbow_veil(const struct scene *scene, const struct ray *ray,
                         double distance)
{
    struct veil all = { rgb_grey(0), rgb_grey(1) };
    for (size_t i = 0; i < scene->rainbows.count; i++) {
        struct veil veil =
            rainbow_look(&scene->rainbows.items[i], ray, distance);
        all.light = rgb_add(all.light, veil.light);
        all.through = rgb_mul(all.through, veil.through);
    }
    return all;
}
