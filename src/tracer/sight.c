/* What the camera sees at places of the picture: see tracer.h. Where the
 * lighting method can, rays that are close together are followed and lit
 * together. */
#include <string.h>

#include "base/draw.h"
#include "base/random.h"
#include "scene/lens.h"
#include "shade/shadow.h"
#include "tracer/wavefront.h"

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
    if (n < BLUR_LEAST || n < camera->blur_samples[0])
        return false;
    double sure = fmin(fmax(camera->confidence, 0), 0.999999);
    double width = log((1 + sure) / (1 - sure)) / 1.702;
    rgb mean = rgb_scale(blur->sum, 1 / n);
    rgb spread = rgb_sub(rgb_scale(blur->squares, 1 / n), rgb_mul(mean, mean));
    return rgb_peak(spread) * width * width <= n * camera->variance;
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

/* What one ray of the camera sees. */
static struct radiance tracer_ray(const struct tracer *tracer,
                                  struct worker *worker, struct ray ray,
                                  const struct picture_place *place)
{
    struct radiance seen = { rgb_grey(0), 0 };
    struct wavefront wavefront;
    wavefront_start(&wavefront, tracer, worker, false);
    struct path *path = wavefront_root(&wavefront, &seen);
    path->ray = ray;
    path_start(path, place);
    wavefront_push(path);
    wavefront_run(&wavefront);
    return seen;
}

void tracer_meet_many(const struct tracer *tracer, const struct rays *rays,
                      unsigned count, struct world_hit *hits)
{
    struct rays_span span = { { 0 }, { 0 } };
    for (unsigned i = 0; i < count; i++) {
        span.near[i] = surface_offset(rays_origin(rays, (int)i));
        span.far[i] = (double)INFINITY;
    }
    world_closest_many(tracer->world, rays, &span, count, RAY_CAMERA, hits);
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

/* A place of the picture, while rays through the lens are added up. */
struct lens_pixel {
    const struct tracer *tracer;
    struct worker *worker;
    const struct picture_place *place;
    uint64_t key;
    int most;
    struct blur blur;
    bool settled;
};

static void lens_start(struct lens_pixel *pixel, const struct tracer *tracer,
                       struct worker *worker, const struct picture_place *place)
{
    const struct camera *camera = &tracer->scene->camera;
    uint64_t bits[2];
    memcpy(bits, place->at, sizeof bits);
    *pixel = (struct lens_pixel){ .tracer = tracer,
                                  .worker = worker,
                                  .place = place,
                                  .key = random_key(bits[0], bits[1]),
                                  .most = (int)camera->blur_samples[1],
                                  .settled = !camera_sees(camera, place->at[0],
                                                          place->at[1]) };
}

/* Where one of its rays goes through the picture and through the lens. */
static void lens_choose(const struct lens_pixel *pixel, int number,
                        double at[2], double lens[2])
{
    const struct camera *camera = &pixel->tracer->scene->camera;
    blur_spread(camera, (struct draws){ pixel->key, (uint32_t)number }, at);
    for (int i = 0; i < 2; i++)
        at[i] += pixel->place->at[i];
    if (camera->bokeh)
        lens_shaped_point(camera->bokeh, number, pixel->key, lens);
    else
        lens_point(pixel->most, number, pixel->key, lens);
}

static struct radiance lens_see_one(const struct lens_pixel *pixel, int number)
{
    double at[2], lens[2];
    lens_choose(pixel, number, at, lens);
    return tracer_ray(
        pixel->tracer, pixel->worker,
        camera_lens_ray(&pixel->tracer->scene->camera, at[0], at[1], lens),
        NULL);
}

static bool lens_is_done(const struct lens_pixel *pixel)
{
    return pixel->settled || pixel->blur.count >= pixel->most ||
           worker_stopped(pixel->worker);
}

static void lens_add(struct lens_pixel *pixel, struct radiance seen)
{
    if (pixel->settled)
        return;
    blur_add(&pixel->blur, seen);
    pixel->settled = blur_settled(&pixel->blur, &pixel->tracer->scene->camera);
}

/* Rays that are followed together, of several pixels. */
struct lens_packet {
    struct camera_places places, lenses;
    struct lens_pixel *pixels[WORLD_RAYS];
    unsigned count;
};

/* Adds what they see to their pixels, in their order. */
static void lens_see(struct lens_packet *packet)
{
    struct rays rays;
    struct world_hit hits[WORLD_RAYS];
    struct radiance seen[WORLD_RAYS];
    struct wavefront wavefront;
    struct tracer_met met = { NULL, &rays, hits, packet->count };
    if (!packet->count)
        return;
    const struct lens_pixel *any = packet->pixels[0];
    for (unsigned i = packet->count; i < RAY_LANES; i++) {
        packet->places.x[i] = packet->places.x[i - 1];
        packet->places.y[i] = packet->places.y[i - 1];
        packet->lenses.x[i] = packet->lenses.x[i - 1];
        packet->lenses.y[i] = packet->lenses.y[i - 1];
    }
    camera_lens_rays(&any->tracer->scene->camera, &packet->places,
                     &packet->lenses, packet->count, &rays);
    tracer_meet_many(any->tracer, &rays, packet->count, hits);
    wavefront_start(&wavefront, any->tracer, any->worker, true);
    wavefront_see(&wavefront, &met, seen);
    arena_reset(any->worker->scratch);
    for (unsigned i = 0; i < packet->count; i++)
        lens_add(packet->pixels[i], seen[i]);
    packet->count = 0;
}

/* So many more of a pixel are followed before it is looked at: few, while few
 * may be enough. */
static int lens_batch(const struct lens_pixel *pixel)
{
    const struct camera *camera = &pixel->tracer->scene->camera;
    int count = pixel->blur.count, left = pixel->most - count;
    int least = (int)fmax(BLUR_LEAST, camera->blur_samples[0]);
    int more = count < least ? least - count : (count / 2 + 3) & ~3;
    more = more < left ? more : left;
    return more < WORLD_RAYS ? more : WORLD_RAYS;
}

/* The next few rays of a pixel. */
static void lens_go_on(struct lens_pixel *pixel, struct lens_packet *packet)
{
    int first = pixel->blur.count, some = lens_batch(pixel);
    for (int i = 0; i < some && !pixel->settled; i++) {
        double at[2], lens[2];
        unsigned lane = packet->count++;
        lens_choose(pixel, first + i, at, lens);
        packet->places.x[lane] = at[0];
        packet->places.y[lane] = at[1];
        packet->lenses.x[lane] = lens[0];
        packet->lenses.y[lane] = lens[1];
        packet->pixels[lane] = pixel;
        if (packet->count == WORLD_RAYS)
            lens_see(packet);
    }
}

/* Pixels close together, whose rays fill each other's packets. */
static void tracer_blurred_many(const struct tracer *tracer,
                                struct worker *worker,
                                const struct picture_place *places,
                                unsigned count, struct radiance *out)
{
    struct lens_pixel pixels[WORLD_RAYS];
    struct lens_packet packet = { .count = 0 };
    for (unsigned i = 0; i < count; i++)
        lens_start(&pixels[i], tracer, worker, &places[i]);
    for (bool more = true; more;) {
        more = false;
        for (unsigned i = 0; i < count; i++)
            if (!lens_is_done(&pixels[i])) {
                lens_go_on(&pixels[i], &packet);
                more = true;
            }
        lens_see(&packet);
    }
    for (unsigned i = 0; i < count; i++)
        out[i] = blur_mean(&pixels[i].blur);
}

/* Ray by ray. */
static struct radiance tracer_blurred(const struct tracer *tracer,
                                      struct worker *worker,
                                      const struct picture_place *place)
{
    struct lens_pixel pixel;
    lens_start(&pixel, tracer, worker, place);
    while (!lens_is_done(&pixel)) {
        lens_add(&pixel, lens_see_one(&pixel, pixel.blur.count));
        arena_reset(worker->scratch);
    }
    return blur_mean(&pixel.blur);
}

/* The mean of the pixel's rays; those that lead nowhere don't count. */
static struct radiance tracer_several(const struct tracer *tracer,
                                      struct worker *worker,
                                      const struct picture_place *place)
{
    const struct camera *camera = &tracer->scene->camera;
    struct blur blur = { .count = 0 };
    for (int i = 0; i < camera->rays && !worker_stopped(worker); i++) {
        struct ray ray;
        if (!camera_pixel_ray(camera, place->at[0], place->at[1], i, &ray))
            continue;
        blur_add(&blur, tracer_ray(tracer, worker, ray, NULL));
        arena_reset(worker->scratch);
    }
    return blur_mean(&blur);
}

struct radiance tracer_camera(const struct tracer *tracer,
                              struct worker *worker,
                              const struct picture_place *place)
{
    const struct camera *camera = &tracer->scene->camera;
    if (!camera_sees(camera, place->at[0], place->at[1]))
        return (struct radiance){ rgb_grey(0), 0 };
    if (camera_blurs(camera))
        return tracer_blurred(tracer, worker, place);
    if (camera->rays > 1)
        return tracer_several(tracer, worker, place);
    return tracer_ray(tracer, worker,
                      camera_ray(camera, place->at[0], place->at[1]), place);
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

/* Without the ways to what is met first. */
static struct radiance see_one(const struct tracer *tracer,
                               struct worker *worker,
                               const struct tracer_met *met, unsigned i)
{
    const struct picture_place *place = &met->places[i];
    const struct world_hit *hit = &met->hits[i];
    struct radiance seen = { rgb_grey(0), 0 };
    struct wavefront wavefront;
    struct crossing crossing;
    if (!camera_sees(&tracer->scene->camera, place->at[0], place->at[1]))
        return seen;
    wavefront_start(&wavefront, tracer, worker, false);
    struct path *path = wavefront_root(&wavefront, &seen);
    path->ray = rays_at(met->rays, (int)i);
    path_start(path, place);
    if (hit->leaf)
        world_describe(&path->ray, hit, &crossing.at);
    wavefront_go_on(path, &crossing, hit->leaf);
    wavefront_run(&wavefront);
    arena_reset(worker->scratch);
    return seen;
}

void tracer_see_many(const struct tracer *tracer, struct worker *worker,
                     const struct tracer_met *met, struct radiance *out)
{
    const struct camera *camera = &tracer->scene->camera;
    bool blurs = camera_blurs(camera), single = camera->rays <= 1 && !blurs;
    bool mixed = tracer_may_mix(tracer, worker);
    if (blurs && mixed) {
        tracer_blurred_many(tracer, worker, met->places, met->count, out);
        return;
    }
    if (single && mixed) {
        struct wavefront wavefront;
        wavefront_start(&wavefront, tracer, worker, true);
        wavefront_see(&wavefront, met, out);
        arena_reset(worker->scratch);
        return;
    }
    for (unsigned i = 0; i < met->count; i++)
        out[i] = single ? see_one(tracer, worker, met, i)
                        : tracer_camera(tracer, worker, &met->places[i]);
}
