/* Media on the way of a path: free paths without bias, and single lamps asked
 * where light is scattered. A lamp's light is scattered as brightly as under
 * POV-Ray, whose lamps give media pi / (pi / 4) times what they would if their
 * light were that of a surface which lights a wall as brightly. Media of the
 * scene have no end: lamps, which don't fade, would fill them with light
 * without bounds, so a path has their light of one scattering there alone. */
#include "tracer/drift.h"

#include "base/warp.h"
#include "shade/free_path.h"
#include "tracer/crossing.h"
#include "tracer/direct.h"

enum { SLOT_TRACKING = 1 << 24, SLOT_TURN, SLOT_MEDIUM };

static rgb drift_response(const void *context, vec3 direction, bool lamp,
                          bool highlights)
{
    rgb phase = collision_phase(context, direction);
    (void)highlights;
    return lamp ? phase : rgb_scale(phase, 0.25);
}

static double drift_density(const void *context, vec3 direction)
{
    return collision_density(context, direction);
}

static uint64_t drift_key(const struct draws *draws)
{
    return random_key(random_key(draws->key, draws->index), SLOT_TRACKING);
}

/* The light that comes to the place of the collision, and its new way. */
static bool drift_turn(struct walk *walk, const struct draws *draws,
                       const struct leaf *end,
                       const struct collision *collision)
{
    double u[2];
    struct receiver receiver = {
        .point =
            vec3_along(walk->ray.origin, walk->ray.direction, collision->t),
        .inside = &walk->inside,
        .behind = &walk->inside,
        .response = drift_response,
        .density = drift_density,
        .context = collision,
        .leaf = end,
        .in_media = true,
        .straight = true,
    };
    rgb light = walk->endless ? rgb_grey(0)
                              : direct_lamps(walk->tracer, walk->worker,
                                             &receiver, draws, walk->split);
    light = rgb_add(
        light, direct_emitters(walk->tracer, walk->worker, &receiver, draws));
    walk->light = rgb_add(walk->light, rgb_mul(walk->share, light));
    draw_pair(draws, SLOT_TURN, u);
    vec3 direction =
        collision_sample(collision, u, draw_unit(draws, SLOT_MEDIUM));
    double density = collision_density(collision, direction);
    rgb response = drift_response(collision, direction, false, true);
    if (!(density > 0) || !isfinite(density))
        return false;
    walk->share =
        rgb_mul(walk->share, rgb_scale(response, 1 / (WARP_PI * density)));
    walk->ray = (struct ray){ receiver.point, direction };
    walk->kind = RAY_REFLECTION;
    walk->endless = walk->tracer->scene->media.count > 0;
    walk->split = walk->straight = false;
    walk->clear = 0;
    walk->density = density;
    walk->from = receiver.point;
    walk->level = 1;
    walk->worker->counters.secondary_rays++;
    return true;
}

static struct media_way drift_way(const struct media_list *media,
                                  struct worker *worker, const struct ray *ray,
                                  double distance,
                                  const struct interiors *inside)
{
    return (struct media_way){ .media = media,
                               .origin = ray->origin,
                               .direction = ray->direction,
                               .length = distance,
                               .worker = worker,
                               .inside = inside };
}

bool walk_drift(struct walk *walk, const struct draws *draws,
                const struct leaf *end, double *distance)
{
    struct media_list media;
    struct collision collision;
    if (!tracer_misty(walk->tracer))
        return false;
    media_find(&media, &walk->tracer->scene->media, &walk->inside);
    if (media.count == 0)
        return false;
    struct media_way way =
        drift_way(&media, walk->worker, &walk->ray, *distance, &walk->inside);
    free_path(&way, drift_key(draws), &collision);
    walk->light = rgb_add(walk->light, rgb_mul(walk->share, collision.light));
    walk->share = rgb_mul(walk->share, collision.share);
    if (!collision.scattered)
        return false;
    *distance = collision.t;
    if (!drift_turn(walk, draws, end, &collision))
        walk->share = rgb_grey(0);
    return true;
}

rgb drift_through(const struct tracer *tracer, struct worker *worker,
                  const struct ray *ray, double distance,
                  const struct interiors *inside, uint64_t key)
{
    struct media_list media;
    if (!tracer_misty(tracer))
        return rgb_grey(1);
    media_find(&media, &tracer->scene->media, inside);
    struct media_way way = drift_way(&media, worker, ray, distance, inside);
    return media.count ? free_path_through(&way, key) : rgb_grey(1);
}
