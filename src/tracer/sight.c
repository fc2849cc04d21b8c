/* What the camera sees at places of the picture: see tracer.h. Where the
 * lighting method can, rays that are close together are lit together as far as
 * what they meet first; from there each goes its own way. */
#include <string.h>

#include "base/draw.h"
#include "base/random.h"
#include "scene/lens.h"
#include "shade/shadow.h"
#include "tracer/branch.h"

enum { BLUR_LEAST = 4 }; /* rays through a lens, for a variance */

/* Rays through the lens, and their squares. */
struct blur {
    rgb sum, squares;
    double opacity;
    int count;
};

static void blur_add(struct blur *blur, struct radiance seen)
{
    blur->sum = rgb_add(blur->sum, seen.colour);
    blur->squares = rgb_add(blur->squares, rgb_mul(seen.colour, seen.colour));
    blur->opacity += seen.opacity;
    blur->count++;
}

static struct radiance blur_mean(const struct blur *blur)
{
    double share = blur->count ? 1.0 / blur->count : 0;
    return (struct radiance){ rgb_scale(blur->sum, share),
                              blur->opacity * share };
}

/* Whether the mean's variance is, with the confidence asked for, small enough.
 * The logistic distribution stands for the normal one. */
static bool blur_settled(const struct blur *blur, const struct camera *camera)
{
    double n = blur->count;
    double sure = fmin(fmax(camera->confidence, 0), 0.999999);
    double width = log((1 + sure) / (1 - sure)) / 1.702;
    rgb mean = rgb_scale(blur->sum, 1 / n);
    rgb spread = rgb_sub(rgb_scale(blur->squares, 1 / n), rgb_mul(mean, mean));
    return n >= BLUR_LEAST && n >= camera->blur_samples[0] &&
           rgb_peak(spread) * width * width <= n * camera->variance;
}

/* Each ray is of another place of the pixel, whatever antialiasing does beside
 * it (measured). */
static void blur_spread(const struct camera *camera, struct draws draws,
                        double at[2])
{
    draw_pair(&draws, 0, at);
    for (int i = 0; i < 2; i++)
        at[i] = camera->pixels[i] > 0 ? (at[i] - 0.5) / camera->pixels[i] : 0;
}

static struct radiance tracer_blurred(const struct tracer *tracer,
                                      struct worker *worker,
                                      const struct picture_place *place)
{
    const struct camera *camera = &tracer->scene->camera;
    double x = place->at[0], y = place->at[1];
    int most = (int)camera->blur_samples[1];
    struct blur blur = { .count = 0 };
    uint64_t bits[2];
    memcpy(bits, (const double[]){ x, y }, sizeof bits);
    uint64_t key = random_key(bits[0], bits[1]);
    for (int i = 0; i < most && !worker_stopped(worker); i++) {
        struct path path;
        double lens[2], at[2];
        blur_spread(camera, (struct draws){ key, (uint32_t)i }, at);
        lens_point(most, i, key, lens);
        path.ray = camera_lens_ray(camera, x + at[0], y + at[1], lens);
        path_start(&path, tracer, worker, NULL);
        blur_add(&blur, path_follow(&path));
        arena_reset(worker->scratch);
        if (blur_settled(&blur, camera))
            break;
    }
    return blur_mean(&blur);
}

/* The mean of the pixel's rays; those that lead nowhere don't count. */
static struct radiance tracer_several(const struct tracer *tracer,
                                      struct worker *worker,
                                      const struct picture_place *place)
{
    const struct camera *camera = &tracer->scene->camera;
    struct blur blur = { .count = 0 };
    for (int i = 0; i < camera->rays && !worker_stopped(worker); i++) {
        struct path path;
        if (!camera_pixel_ray(camera, place->at[0], place->at[1], i, &path.ray))
            continue;
        path_start(&path, tracer, worker, NULL);
        blur_add(&blur, path_follow(&path));
        arena_reset(worker->scratch);
    }
    return blur_mean(&blur);
}

struct radiance tracer_camera(const struct tracer *tracer,
                              struct worker *worker,
                              const struct picture_place *place)
{
    struct path path;
    const struct camera *camera = &tracer->scene->camera;
    if (!camera_sees(camera, place->at[0], place->at[1]))
        return (struct radiance){ rgb_grey(0), 0 };
    if (camera_blurs(camera))
        return tracer_blurred(tracer, worker, place);
    if (camera->rays > 1)
        return tracer_several(tracer, worker, place);
    path.ray = camera_ray(camera, place->at[0], place->at[1]);
    path_start(&path, tracer, worker, place);
    return path_follow(&path);
}

void tracer_rays(const struct tracer *tracer,
                 const struct picture_place *places, unsigned count,
                 struct rays *rays)
{
    struct camera_places at;
    for (unsigned i = 0; i < RAY_LANES; i++) {
        const double *place = places[i < count ? i : count - 1].at;
        at.x[i] = place[0];
        at.y[i] = place[1];
    }
    camera_rays(&tracer->scene->camera, &at, count, rays);
}

void tracer_meet_many(const struct tracer *tracer, const struct rays *rays,
                      unsigned count, struct world_hit *hits)
{
    double offsets[RAY_LANES] = { 0 };
    for (unsigned i = 0; i < count; i++)
        offsets[i] = surface_offset(rays_origin(rays, (int)i));
    world_closest_many(tracer->world, rays, offsets, count, RAY_CAMERA, hits);
}

/* One of several rays that are followed together as far as what they meet
 * first. */
struct sight {
    struct path path;
    struct crossing crossing;
};

/* Sights of places, and those of them that are to be lit. */
struct sights {
    const struct tracer *tracer;
    struct worker *worker;
    struct sight at[WORLD_RAYS];
    unsigned lit[WORLD_RAYS], count;
};

/* Bit by bit whether there is a picture. */
static unsigned places_seen(const struct camera *camera,
                            const struct tracer_met *met)
{
    unsigned seen = (1u << met->count) - 1;
    for (unsigned i = 0; camera->kind->sees && i < met->count; i++)
        if (!camera_sees(camera, met->places[i].at[0], met->places[i].at[1]))
            seen &= ~(1u << i);
    return seen;
}

static void sights_describe(struct sights *sights, const struct tracer_met *met,
                            unsigned seen)
{
    struct intersection *at[WORLD_RAYS];
    for (unsigned i = 0; i < met->count; i++) {
        at[i] = &sights->at[i].crossing.at;
        if (!met->hits[i].leaf)
            seen &= ~(1u << i);
    }
    if (seen)
        world_describe_many(met->rays, met->hits, seen, at);
}

/* From the camera to what it meets first, and which of them end there. */
static void sights_arrive(struct sights *sights, const struct tracer_met *met,
                          struct radiance *out)
{
    unsigned seen = places_seen(&sights->tracer->scene->camera, met);
    sights_describe(sights, met, seen);
    sights->count = 0;
    for (unsigned i = 0; i < met->count; i++) {
        struct sight *sight = &sights->at[i];
        out[i] = (struct radiance){ rgb_grey(0), 0 };
        if (!(seen >> i & 1))
            continue;
        sight->path.ray = rays_at(met->rays, (int)i);
        path_start(&sight->path, sights->tracer, sights->worker,
                   &met->places[i]);
        if (path_arrive(&sight->path, &sight->crossing, met->hits[i].leaf))
            sights->lit[sights->count++] = i;
        else
            out[i] = path_seen(&sight->path);
    }
}

static void sights_light(struct sights *sights, struct light_asker *askers)
{
    const struct tracer *tracer = sights->tracer;
    for (unsigned k = 0; k < sights->count; k++) {
        struct sight *sight = &sights->at[sights->lit[k]];
        askers[k].light = path_within(&sight->path, &sight->crossing);
        askers[k].surface = &sight->crossing.surface;
    }
    tracer->lighting->illuminate_many(tracer->lighting_state, sights->worker,
                                      askers, sights->count);
}

static struct radiance sight_go_on(struct sight *sight,
                                   const struct light_asker *asker)
{
    struct path *path = &sight->path;
    struct crossing *crossing = &sight->crossing;
    rgb light = path_shade(path, crossing, asker->light, &asker->diffuse);
    if (path_leave(path, crossing, light))
        path_go_on(path, crossing, path_meet(path, &crossing->at));
    return path_seen(path);
}

static void see_together(const struct tracer *tracer, struct worker *worker,
                         const struct tracer_met *met, struct radiance *out)
{
    struct sights sights;
    struct light_asker askers[WORLD_RAYS];
    sights.tracer = tracer;
    sights.worker = worker;
    sights_arrive(&sights, met, out);
    if (sights.count > 0)
        sights_light(&sights, askers);
    for (unsigned k = 0; k < sights.count; k++) {
        unsigned i = sights.lit[k];
        out[i] = sight_go_on(&sights.at[i], &askers[k]);
    }
    arena_reset(worker->scratch);
}

static struct radiance see_one(const struct tracer *tracer,
                               struct worker *worker,
                               const struct tracer_met *met, unsigned i)
{
    const struct camera *camera = &tracer->scene->camera;
    const struct picture_place *place = &met->places[i];
    const struct world_hit *hit = &met->hits[i];
    struct path path;
    struct crossing crossing;
    if (!camera_sees(camera, place->at[0], place->at[1]))
        return (struct radiance){ rgb_grey(0), 0 };
    path.ray = rays_at(met->rays, (int)i);
    path_start(&path, tracer, worker, place);
    if (hit->leaf)
        world_describe(&path.ray, hit, &crossing.at);
    struct radiance seen = path_go_on(&path, &crossing, hit->leaf);
    arena_reset(worker->scratch);
    return seen;
}

/* Whether rays can be lit together, and nobody wants to hear of them one by
 * one. */
static bool tracer_may_mix(const struct tracer *tracer,
                           const struct worker *worker)
{
    const struct lighting *lighting = tracer->lighting;
    return !worker->telling && lighting->illuminate_many &&
           lighting->in_any_order(tracer->lighting_state);
}

void tracer_see_many(const struct tracer *tracer, struct worker *worker,
                     const struct tracer_met *met, struct radiance *out)
{
    const struct camera *camera = &tracer->scene->camera;
    bool single = camera->rays <= 1 && !camera_blurs(camera);
    if (single && tracer_may_mix(tracer, worker)) {
        see_together(tracer, worker, met, out);
        return;
    }
    for (unsigned i = 0; i < met->count; i++)
        out[i] = single ? see_one(tracer, worker, met, i)
                        : tracer_camera(tracer, worker, &met->places[i]);
}
