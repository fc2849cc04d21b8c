/* Delta tracking and ratio tracking: see free_path.h. */
#include "shade/free_path.h"

#include "base/random.h"
#include "base/warp.h"

enum { STEPS_MAX = 1000 * 1000 };

/* Where media only glow: steps on the way. */
static const double glow_steps = 8;

struct tracking {
    const struct media_way *way;
    double length, majorant;
    uint64_t key;
};

static double tracking_random(struct tracking *tracking)
{
    tracking->key = random_mix(tracking->key);
    return random_unit(tracking->key);
}

/* No place of the way loses more than the majorant. */
static struct tracking tracking_new(const struct media_way *way, uint64_t key)
{
    rgb most = rgb_grey(0);
    bool glows = false;
    for (int i = 0; i < way->media->count; i++) {
        const struct medium *medium = way->media->at[i];
        most = rgb_add(most, rgb_mul(medium_extinction(medium),
                                     medium_density_most(medium)));
        glows |= !rgb_is_black(medium->emission);
    }
    double length = fmin(way->length, media_horizon);
    double majorant = fmax(rgb_peak(most), 0);
    if (glows)
        majorant = fmax(majorant, glow_steps / length);
    return (struct tracking){ way, length, majorant, key };
}

/* To the next place where something may happen; false past the end. */
static bool tracking_step(struct tracking *tracking, double *t)
{
    if (!(tracking->majorant > 0))
        return false;
    *t -= log(1 - tracking_random(tracking)) / tracking->majorant;
    return *t < tracking->length;
}

rgb free_path_through(const struct media_way *way, uint64_t key)
{
    struct tracking tracking = tracking_new(way, key);
    rgb through = rgb_grey(1);
    double t = 0;
    for (int i = 0; i < STEPS_MAX && tracking_step(&tracking, &t); i++) {
        vec3 point = vec3_along(way->origin, way->direction, t);
        rgb lost = rgb_grey(0);
        for (int k = 0; k < way->media->count; k++) {
            const struct medium *medium = way->media->at[k];
            lost = rgb_add(lost, rgb_mul(medium_extinction(medium),
                                         medium_density(medium, point)));
        }
        through =
            rgb_mul(through, rgb_sub(rgb_grey(1),
                                     rgb_scale(lost, 1 / tracking.majorant)));
        if (rgb_peak(through) < 1e-6 || worker_stopped(way->worker))
            break;
    }
    return through;
}

/* What the media do at a place, in a unit of length. */
struct doing {
    rgb light, lost, scattered;
};

static struct doing collision_doing(struct collision *at,
                                    const struct media_way *way, double t)
{
    struct doing doing = { rgb_grey(0), rgb_grey(0), rgb_grey(0) };
    vec3 point = vec3_along(way->origin, way->direction, t);
    at->t = t;
    at->count = 0;
    for (int k = 0; k < way->media->count; k++) {
        const struct medium *medium = way->media->at[k];
        rgb density = medium_density(medium, point);
        rgb scattered = rgb_mul(medium->scattering, density);
        doing.light = rgb_add(doing.light, rgb_mul(medium->emission, density));
        doing.lost =
            rgb_add(doing.lost, rgb_mul(medium_extinction(medium), density));
        if (medium->phase == PHASE_NONE || rgb_is_black(scattered))
            continue;
        doing.scattered = rgb_add(doing.scattered, scattered);
        at->media[at->count] = medium;
        at->shares[at->count++] = scattered;
    }
    return doing;
}

static double part_of(double part, double all)
{
    return all != 0 ? part / all : 0;
}

/* The shares of the media, which were amounts, and the chances. */
static void collision_share(struct collision *at, rgb all)
{
    double total = 0;
    for (int i = 0; i < at->count; i++) {
        rgb *share = &at->shares[i];
        *share = (rgb){ part_of(share->r, all.r), part_of(share->g, all.g),
                        part_of(share->b, all.b) };
        at->chances[i] = fabs(rgb_peak(*share));
        total += at->chances[i];
    }
    for (int i = 0; i < at->count; i++)
        at->chances[i] = part_of(at->chances[i], total);
}

void free_path(const struct media_way *way, uint64_t key, struct collision *out)
{
    struct tracking tracking = tracking_new(way, key);
    double t = 0, m = tracking.majorant;
    out->scattered = false;
    out->direction = way->direction;
    out->light = rgb_grey(0);
    out->share = rgb_grey(1);
    for (int i = 0; i < STEPS_MAX && tracking_step(&tracking, &t); i++) {
        struct doing doing = collision_doing(out, way, t);
        rgb on = rgb_mul(out->share,
                         rgb_sub(rgb_grey(1), rgb_scale(doing.lost, 1 / m)));
        rgb aside = rgb_scale(rgb_mul(out->share, doing.scattered), 1 / m);
        out->light = rgb_add(
            out->light, rgb_scale(rgb_mul(out->share, doing.light), 1 / m));
        double turn = fabs(rgb_peak(aside)), straight = fabs(rgb_peak(on));
        double chance = part_of(turn, turn + straight);
        if (turn + straight < 1e-7 || worker_stopped(way->worker)) {
            out->share = rgb_grey(0);
            return;
        }
        out->scattered = tracking_random(&tracking) < chance;
        if (out->scattered) {
            collision_share(out, doing.scattered);
            out->share = rgb_scale(aside, 1 / chance);
            return;
        }
        out->share = rgb_scale(on, 1 / (1 - chance));
    }
}

rgb collision_phase(const struct collision *collision, vec3 direction)
{
    double cosine = vec3_dot(direction, collision->direction);
    rgb sum = rgb_grey(0);
    for (int i = 0; i < collision->count; i++)
        sum = rgb_add_scaled(sum, collision->shares[i],
                             medium_phase(collision->media[i], cosine));
    return sum;
}

/* What phase functions are sampled by: some of all directions alike, the rest
 * as ((1 + cosine) / 2)^power. */
static double phase_even(const struct medium *medium, double *power)
{
    bool murky = medium->phase == PHASE_MIE_MURKY;
    *power = murky ? 32 : 8;
    if (murky)
        return 1 / (1 + 50.0 / 33);
    return medium->phase == PHASE_MIE_HAZY ? 0.5 : 1;
}

static bool phase_leans(const struct medium *medium)
{
    return medium->phase == PHASE_HENYEY_GREENSTEIN &&
           fabs(medium->eccentricity) > 1e-3;
}

/* Henyey and Greenstein's cosine for u in [0,1). */
static double leaning_cosine(double e, double u)
{
    double q = (1 - e * e) / (1 - e + 2 * e * u);
    return (1 + e * e - q * q) / (2 * e);
}

static double phase_cosine(const struct medium *medium, double u, double which)
{
    double power, even = phase_even(medium, &power);
    if (phase_leans(medium))
        return leaning_cosine(medium->eccentricity, u);
    if (which < even)
        return 2 * u - 1;
    return 2 * pow(u, 1 / (power + 1)) - 1;
}

static double phase_density(const struct medium *medium, double cosine)
{
    double power, even = phase_even(medium, &power);
    double share = 1;
    if (phase_leans(medium))
        share = medium_phase(medium, cosine);
    else if (even < 1)
        share = even + (1 - even) * (power + 1) * pow((1 + cosine) / 2, power);
    return share / (4 * WARP_PI);
}

vec3 collision_sample(const struct collision *collision, const double u[2],
                      double which)
{
    int i = 0;
    vec3 axis = collision->direction;
    for (; i + 1 < collision->count && which >= collision->chances[i]; i++)
        which -= collision->chances[i];
    which = part_of(which, collision->chances[i]);
    double cosine =
        fmin(fmax(phase_cosine(collision->media[i], u[0], which), -1), 1);
    double sine = sqrt(1 - cosine * cosine), turn = 2 * WARP_PI * u[1];
    vec3 side = vec3_normalise(vec3_cross(
        axis, fabs(axis.x) < 0.5 ? (vec3){ 1, 0, 0 } : (vec3){ 0, 1, 0 }));
    vec3 direction = vec3_scale(axis, cosine);
    direction = vec3_along(direction, side, sine * cos(turn));
    return vec3_normalise(
        vec3_along(direction, vec3_cross(axis, side), sine * sin(turn)));
}

double collision_density(const struct collision *collision, vec3 direction)
{
    double cosine = vec3_dot(direction, collision->direction), sum = 0;
    for (int i = 0; i < collision->count; i++)
        sum +=
            collision->chances[i] * phase_density(collision->media[i], cosine);
    return sum;
}
