/* What the camera sees at places of the picture: see tracer.h. Where the
 * lighting method can, rays that are close together are followed and lit
 * together. */
#include <string.h>

#include "base/draw.h"
#include "base/random.h"
#include "scene/lens.h"
#include "shade/shadow.h"
#include "tracer/wavefront.h"

/* Rays through a lens, before it is asked whether they agree: in POV-Ray as
 * many (measured: with least numbers of 4 to 7 it draws the same picture). Of
 * fewer too often none meets a small light, whose blurred disc has holes. */
enum { BLUR_LEAST = 7 };

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

/* How many of its deviations a mean may be away, with the confidence asked for.
 * The logistic distribution stands for the normal one. */
static double blur_width(const struct camera *camera)
{
    double sure = fmin(fmax(camera->confidence, 0), 0.999999);
    return log((1 + sure) / (1 - sure)) / 1.702;
}

/* Whether the mean's variance is small enough. */
static bool blur_settled(const struct blur *blur, const struct camera *camera,
                         double width)
{
    double n = blur->count;
    if (n < BLUR_LEAST || n < camera->blur_samples[0])
        return false;
    rgb mean = rgb_scale(blur->sum, 1 / n);
    rgb spread = rgb_sub(rgb_scale(blur->squares, 1 / n), rgb_mul(mean, mean));
    return rgb_peak(spread) * width * width <= n * camera->variance;
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

/* The rays through a camera's lens. */
struct lens {
    const struct tracer *tracer;
    struct worker *worker;
    const struct camera *camera;
    double width; /* blur_width */
    int most;     /* rays of a pixel */
    bool disc;    /* a round one: lens_disc_points */
};

static struct lens lens_of(const struct tracer *tracer, struct worker *worker)
{
    const struct camera *camera = &tracer->scene->camera;
    int most = (int)camera->blur_samples[1];
    return (struct lens){ tracer, worker,
                          camera, blur_width(camera),
                          most,   !camera->bokeh && lens_is_disc(most) };
}

/* A place of the picture, while its rays are added up. */
struct lens_pixel {
    const struct lens *lens;
    struct picture_place place; /* of its middle */
    double begin[2];
    uint64_t key;
    struct draw_slot slot;
    struct blur blur;
    bool settled;
};

/* Its rays are all of one pixel, of which nothing is known before. */
static void lens_start(struct lens_pixel *pixel, const struct lens *lens,
                       const struct picture_place *place)
{
    uint64_t bits[2];
    memcpy(bits, place->at, sizeof bits);
    *pixel = (struct lens_pixel){ .lens = lens,
                                  .place = *place,
                                  .key = random_key(bits[0], bits[1]) };
    pixel->place.pixel = worker_pixel(lens->worker);
    pixel->place.around = NULL;
    pixel->settled = !camera_sees(lens->camera, place->at[0], place->at[1]);
    pixel->slot = draw_slot_of(pixel->key, 0);
    lens_begin(pixel->key, pixel->begin);
}

/* Where in its pixel a ray is, of a number in [0,1): each is of another place,
 * whatever antialiasing does beside it (measured). */
static double lens_spread(const struct lens *lens, int axis, double drawn)
{
    double pixels = lens->camera->pixels[axis];
    return pixels > 0 ? (drawn - 0.5) / pixels : 0;
}

/* Where one of its rays goes through a lens. */
static void lens_choose(const struct lens_pixel *pixel, int number,
                        double point[2])
{
    const struct lens *lens = pixel->lens;
    if (lens->camera->bokeh)
        lens_shaped_point(lens->camera->bokeh, number, pixel->key, point);
    else
        lens_point(lens->most, number, pixel->key, point);
}

static struct radiance lens_see_one(const struct lens_pixel *pixel)
{
    const struct lens *lens = pixel->lens;
    int number = pixel->blur.count;
    double at[2], point[2];
    draw_pair(&(struct draws){ pixel->key, (uint32_t)number }, 0, at);
    for (int i = 0; i < 2; i++)
        at[i] = pixel->place.at[i] + lens_spread(lens, i, at[i]);
    lens_choose(pixel, number, point);
    return tracer_ray(lens->tracer, lens->worker,
                      camera_lens_ray(lens->camera, at[0], at[1], point),
                      &pixel->place);
}

static bool lens_is_done(const struct lens_pixel *pixel)
{
    return pixel->settled || pixel->blur.count >= pixel->lens->most ||
           worker_stopped(pixel->lens->worker);
}

static void lens_add(struct lens_pixel *pixel, struct radiance seen)
{
    const struct lens *lens = pixel->lens;
    if (pixel->settled)
        return;
    blur_add(&pixel->blur, seen);
    pixel->settled = blur_settled(&pixel->blur, lens->camera, lens->width);
}

/* Rays that are followed together, of several pixels. */
struct lens_packet {
    struct lens_pixel *pixels[RAY_LANES];
    struct draw_lanes draws; /* index: the ray's number */
    unsigned count;
};

/* Where they go through the picture. */
static void packet_places(const struct lens_packet *packet,
                          struct camera_places *places)
{
    _Static_assert((int)DRAW_LANES == (int)RAY_LANES, "a packet");
    draw_pairs(&packet->draws, places->x, places->y);
    for (unsigned i = 0; i < packet->count; i++) {
        const struct lens_pixel *pixel = packet->pixels[i];
        places->x[i] =
            pixel->place.at[0] + lens_spread(pixel->lens, 0, places->x[i]);
        places->y[i] =
            pixel->place.at[1] + lens_spread(pixel->lens, 1, places->y[i]);
    }
}

/* And through the lens. */
static void packet_points(const struct lens_packet *packet,
                          struct camera_places *points)
{
    LANE_LINES double number[RAY_LANES] = { 0 };
    memset(points, 0, sizeof *points);
    for (unsigned i = 0; i < packet->count; i++) {
        const struct lens_pixel *pixel = packet->pixels[i];
        double at[2] = { pixel->begin[0], pixel->begin[1] };
        number[i] = packet->draws.index[i];
        if (!pixel->lens->disc)
            lens_choose(pixel, (int)packet->draws.index[i], at);
        points->x[i] = at[0];
        points->y[i] = at[1];
    }
    if (packet->pixels[0]->lens->disc)
        lens_disc_points(number, points->x, points->y);
}

/* The last ray goes on in the lanes beyond. */
static void places_fill(struct camera_places *places, unsigned count)
{
    for (unsigned i = count; i < RAY_LANES; i++) {
        places->x[i] = places->x[i - 1];
        places->y[i] = places->y[i - 1];
    }
}

/* Adds what they see to their pixels, in their order. */
static void packet_see(struct lens_packet *packet)
{
    struct rays rays;
    struct camera_places places, points;
    struct world_hit hits[WORLD_RAYS];
    struct radiance seen[WORLD_RAYS];
    struct wavefront wavefront;
    struct picture_place of[WORLD_RAYS];
    struct tracer_met met = { of, &rays, hits, packet->count };
    if (!packet->count)
        return;
    const struct lens *lens = packet->pixels[0]->lens;
    for (unsigned i = 0; i < packet->count; i++)
        of[i] = packet->pixels[i]->place;
    packet_places(packet, &places);
    packet_points(packet, &points);
    places_fill(&places, packet->count);
    places_fill(&points, packet->count);
    camera_lens_rays(lens->camera, &places, &points, packet->count, &rays);
    tracer_meet_many(lens->tracer, &rays, packet->count, hits);
    wavefront_start(&wavefront, lens->tracer, lens->worker, true);
    wavefront_see(&wavefront, &met, seen);
    arena_reset(lens->worker->scratch);
    for (unsigned i = 0; i < packet->count; i++)
        lens_add(packet->pixels[i], seen[i]);
    packet->count = 0;
}

static void packet_take(struct lens_packet *packet, struct lens_pixel *pixel,
                        int number)
{
    unsigned lane = packet->count++;
    packet->pixels[lane] = pixel;
    packet->draws.order[lane] = pixel->slot.order;
    packet->draws.first[lane] = pixel->slot.first;
    packet->draws.second[lane] = pixel->slot.second;
    packet->draws.index[lane] = (uint32_t)number;
    if (packet->count == WORLD_RAYS)
        packet_see(packet);
}

/* So many more of a pixel are followed before it is looked at: few, while few
 * may be enough. */
static int lens_batch(const struct lens_pixel *pixel)
{
    const struct lens *lens = pixel->lens;
    int count = pixel->blur.count, left = lens->most - count;
    int least = (int)fmax(BLUR_LEAST, lens->camera->blur_samples[0]);
    int more = count < least ? least - count : (count / 2 + 3) & ~3;
    more = more < left ? more : left;
    return more < WORLD_RAYS ? more : WORLD_RAYS;
}

/* The next few rays of a pixel. */
static void lens_go_on(struct lens_pixel *pixel, struct lens_packet *packet)
{
    int first = pixel->blur.count, some = lens_batch(pixel);
    for (int i = 0; i < some && !pixel->settled; i++)
        packet_take(packet, pixel, first + i);
}

/* Pixels close together, whose rays fill each other's packets. */
static void tracer_blurred_many(const struct tracer *tracer,
                                struct worker *worker,
                                const struct picture_place *places,
                                unsigned count, struct radiance *out)
{
    const struct lens lens = lens_of(tracer, worker);
    struct lens_pixel pixels[WORLD_RAYS];
    struct lens_packet packet = { .count = 0 };
    for (unsigned i = 0; i < count; i++)
        lens_start(&pixels[i], &lens, &places[i]);
    for (bool more = true; more;) {
        more = false;
        for (unsigned i = 0; i < count; i++)
            if (!lens_is_done(&pixels[i])) {
                lens_go_on(&pixels[i], &packet);
                more = true;
            }
        packet_see(&packet);
    }
    for (unsigned i = 0; i < count; i++)
        out[i] = blur_mean(&pixels[i].blur);
}

/* Ray by ray. */
static struct radiance tracer_blurred(const struct tracer *tracer,
                                      struct worker *worker,
                                      const struct picture_place *place)
{
    const struct lens lens = lens_of(tracer, worker);
    struct lens_pixel pixel;
    lens_start(&pixel, &lens, place);
    while (!lens_is_done(&pixel)) {
        lens_add(&pixel, lens_see_one(&pixel));
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

bool tracer_is_single(const struct tracer *tracer)
{
    const struct camera *camera = &tracer->scene->camera;
    return camera->rays <= 1 && !camera_blurs(camera);
}

void tracer_see_many(const struct tracer *tracer, struct worker *worker,
                     const struct tracer_met *met, struct radiance *out)
{
    bool blurs = camera_blurs(&tracer->scene->camera);
    bool single = tracer_is_single(tracer);
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
