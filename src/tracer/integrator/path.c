/* Where paths begin: at the camera, and at points that are probed. */
#include "tracer/path.h"

#include <string.h>

#include "base/warp.h"
#include "scene/lens.h"
#include "shade/shadow.h"
#include "tracer/crossing.h"
#include "tracer/direct.h"
#include "tracer/lobes.h"
#include "tracer/walk.h"

enum {
    TYPICAL_EDGE = 16,   /* of the grid of path_ready */
    TYPICAL_SAMPLES = 4, /* at each of its places */
    SLOT_START = 1 << 20,
    SLOT_LOBE,
    SLOT_LENS,
}; /* of draws; the rest belongs to direct.c */

/* Paths are guided where that leaves less than this of the variance times the
 * rays. Guided rays take longer, and samples that are split are less evenly
 * spread: what is 0.6 here (blocks) takes 1.4 times the time for the same error
 * by tests/path/guide, what is 0.25 (rooms) half of it, 0.17 (maze) 0.4. */
static const double guide_most = 0.4;

/* Of a pixel that has several rays, those that there are take turns. False: it
 * has one. */
static bool path_other_ray(const struct camera *camera, double x, double y,
                           uint32_t turn, struct ray *ray)
{
    uint32_t count = 0, wanted;
    if (camera->rays <= 1)
        return false;
    for (int i = 0; i < camera->rays; i++)
        count += camera_pixel_ray(camera, x, y, i, ray);
    wanted = count > 0 ? turn % count : 0;
    for (int i = 0; i < camera->rays; i++)
        if (camera_pixel_ray(camera, x, y, i, ray) && wanted-- == 0)
            return true;
    return false;
}

struct radiance path_camera(const struct tracer *tracer, struct worker *worker,
                            double x, double y, const struct draws *draws)
{
    struct walk walk = { .tracer = tracer,
                         .worker = worker,
                         .draws = *draws,
                         .kind = RAY_CAMERA,
                         .level = 1,
                         .weight = 1,
                         .straight = true,
                         .split = true,
                         .base = 1,
                         .copies = 1,
                         .share = { 1, 1, 1 },
                         .clear = 1 };
    if (!camera_sees(&tracer->scene->camera, x, y))
        return (struct radiance){ rgb_grey(0), 0 };
    walk.ray = tracer_start(tracer, worker, x, y, &walk.inside);
    if (camera_blurs(&tracer->scene->camera)) {
        double u[2], lens[2];
        draw_pair(draws, SLOT_LENS, u);
        lens_sample(u, lens);
        walk.ray = camera_lens_ray(&tracer->scene->camera, x, y, lens);
    }
    if (path_other_ray(&tracer->scene->camera, x, y, draws->index, &walk.ray))
        tracer_enter(tracer, worker, walk.ray.origin, &walk.inside);
    return walk_follow(&walk);
}

/* What a few samples of the picture tell: the mean light of a pixel; the
 * variance of one sample, the mean over all pixels; and the rays it takes. */
struct trial {
    double light, variance, rays;
};

static double worker_rays(const struct worker *worker)
{
    return (double)worker->counters.camera_rays +
           (double)worker->counters.secondary_rays +
           (double)worker->counters.shadow_rays;
}

static void trial_place(const struct tracer *tracer, struct worker *worker,
                        int place, struct trial *trial)
{
    const struct light_set *set = tracer->lighting_state;
    double x = (place % TYPICAL_EDGE + 0.5) / TYPICAL_EDGE;
    double y = (place / TYPICAL_EDGE + 0.5) / TYPICAL_EDGE;
    double sum = 0, squares = 0, n = TYPICAL_SAMPLES;
    for (uint32_t i = 0; i < TYPICAL_SAMPLES; i++) {
        struct draws draws = { random_key(set->seed, (uint64_t)place), i };
        double seen =
            rgb_peak(path_camera(tracer, worker, x, y, &draws).colour);
        arena_reset(worker->scratch);
        if (!isfinite(seen))
            continue;
        sum += fabs(seen);
        squares += seen * seen;
    }
    trial->light += sum / n;
    trial->variance += fmax(0, squares / n - sum / n * (sum / n));
}

static struct trial path_try(const struct tracer *tracer, struct worker *worker)
{
    struct trial trial = { .rays = -worker_rays(worker) };
    enum { PLACES = TYPICAL_EDGE * TYPICAL_EDGE };
    for (int place = 0; place < PLACES; place++)
        trial_place(tracer, worker, place, &trial);
    trial.light /= PLACES;
    trial.variance /= PLACES;
    trial.rays += worker_rays(worker);
    return trial;
}

void path_ready(struct tracer *tracer, struct worker *worker)
{
    const struct light_set *set = tracer->lighting_state;
    tracer->typical = 0;
    tracer->guided = false;
    if (!set->guide)
        return;
    struct trial plain = path_try(tracer, worker);
    tracer->typical = plain.light;
    tracer->guided = true;
    struct trial guided = path_try(tracer, worker);
    tracer->guided = guided.variance * guided.rays <
                     guide_most * plain.variance * plain.rays;
}

/* Irradiance: light counts by its cosine. */
static rgb plate_response(const void *context, vec3 direction, bool lamp,
                          bool highlights)
{
    const struct lobes *lobes = context;
    (void)lamp;
    (void)highlights;
    return rgb_grey(fmax(vec3_dot(lobes->at[0].axis, direction), 0));
}

static double plate_density(const void *context, vec3 direction)
{
    return lobes_density(context, direction);
}

/* The light field: light counts alike from everywhere. */
static rgb speck_response(const void *context, vec3 direction, bool lamp,
                          bool highlights)
{
    (void)context;
    (void)direction;
    (void)lamp;
    (void)highlights;
    return rgb_grey(1);
}

static double speck_density(const void *context, vec3 direction)
{
    (void)context;
    (void)direction;
    return 1 / (4 * WARP_PI);
}

/* Who asks, and the lobes of a plate: they change from sample to sample. */
struct probe {
    struct receiver receiver;
    struct interiors inside;
    const vec3 *normal; /* NULL: a speck */
    struct lobes lobes;
};

static vec3 probe_direction(const struct probe *probe,
                            const struct draws *draws)
{
    double u[2];
    draw_pair(draws, SLOT_START, u);
    return probe->normal
               ? lobes_sample(&probe->lobes, draw_unit(draws, SLOT_LOBE), u)
               : warp_sphere(u);
}

/* One sample. */
static rgb probe_sample(const struct tracer *tracer, struct worker *worker,
                        struct probe *probe, const struct draws *draws)
{
    const struct receiver *receiver = &probe->receiver;
    const struct light_set *set = tracer->lighting_state;
    rgb light = direct_lamps(tracer, worker, receiver, draws, true);
    if (probe->normal) {
        lobes_fill_plate(&probe->lobes, *probe->normal);
        if (rgb_peak(light) == 0)
            lobes_guide(&probe->lobes, set->guide, receiver->point,
                        *probe->normal, false);
    }
    light = rgb_add(light, direct_emitters(tracer, worker, receiver, draws));
    vec3 direction = probe_direction(probe, draws);
    rgb share = receiver->response(receiver->context, direction, false, true);
    struct walk walk = { .tracer = tracer,
                         .worker = worker,
                         .draws = draws_within(draws, SLOT_START),
                         .ray = { receiver->point, direction },
                         .kind = RAY_REFLECTION,
                         .level = 1,
                         .weight = 1,
                         .density =
                             receiver->density(receiver->context, direction),
                         .from = receiver->point,
                         .base = 1,
                         .copies = 1,
                         .share = { 1, 1, 1 } };
    interiors_copy(&walk.inside, receiver->inside);
    if (walk.density > 0 && rgb_peak(share) > 0) {
        share = rgb_scale(share, 1 / (WARP_PI * walk.density));
        light = rgb_add(light, rgb_mul(share, walk_follow(&walk).colour));
    }
    arena_reset(worker->scratch);
    return light;
}

static uint64_t key_of(vec3 point, uint64_t seed)
{
    uint64_t bits[3];
    memcpy(bits, &point, sizeof bits);
    return random_key(random_key(random_key(seed, bits[0]), bits[1]), bits[2]);
}

/* Of one colour, from the sums of n values and their squares. */
static double standard_error(double sum, double squares, double n)
{
    double variance = squares / n - sum / n * (sum / n);
    return n > 1 && variance > 0 ? sqrt(variance / (n - 1)) : 0;
}

struct path_light path_irradiance(const struct tracer *tracer,
                                  struct worker *worker, vec3 point,
                                  const vec3 *normal, unsigned samples,
                                  uint64_t seed)
{
    struct probe probe = { .normal = normal };
    probe.receiver = (struct receiver){
        .point = point,
        .inside = &probe.inside,
        .behind = &probe.inside,
        .response = normal ? plate_response : speck_response,
        .density = normal ? plate_density : speck_density,
        .context = &probe.lobes,
        .straight = true,
    };
    rgb sum = rgb_grey(0), squares = rgb_grey(0);
    double n = samples ? samples : 1;
    /* A point lies on a surface, or a hair beside it. */
    vec3 above =
        normal ? vec3_along(point, *normal, surface_offset(point)) : point;
    tracer_inside(tracer, above, &probe.inside);
    for (unsigned i = 0; i < (unsigned)n && !worker_stopped(worker); i++) {
        struct draws draws = { key_of(point, seed), i };
        rgb light = probe_sample(tracer, worker, &probe, &draws);
        sum = rgb_add(sum, light);
        squares = rgb_add(squares, rgb_mul(light, light));
    }
    return (struct path_light){
        rgb_scale(sum, 1 / n),
        { standard_error(sum.r, squares.r, n),
          standard_error(sum.g, squares.g, n),
          standard_error(sum.b, squares.b, n) },
    };
}

const struct integrator path_integrator = {
    .name = "path",
    .own = &path_lighting,
    .ready = path_ready,
    .sample = path_camera,
    .irradiance = path_irradiance,
};
