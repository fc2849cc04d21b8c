/* What the camera sees at places of the picture: see tracer.h. Where the
 * lighting method can, rays that are close together are lit together as far as
 * what they meet first; from there each goes its own way. */
#include <string.h>

#include "base/draw.h"
#include "base/random.h"
#include "scene/lens.h"
#include "shade/facets.h"
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
        if (camera->bokeh)
            lens_shaped_point(camera->bokeh, i, key, lens);
        else
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
    struct rays_span span = { { 0 }, { 0 } };
    for (unsigned i = 0; i < count; i++) {
        span.near[i] = surface_offset(rays_origin(rays, (int)i));
        span.far[i] = (double)INFINITY;
    }
    world_closest_many(tracer->world, rays, &span, count, RAY_CAMERA, hits);
}

/* One of several rays that are followed together as far as what they meet
 * first. */
struct sight {
    struct path path;
    struct crossing crossing;
};

/* Sights of places, as what they meet is worked out side by side. Bits stand
 * for places. */
struct sights {
    const struct tracer *tracer;
    struct worker *worker;
    const struct tracer_met *met;
    struct world_faces faces;
    struct facets facets;
    struct sight at[WORLD_RAYS];
    unsigned plain; /* end at a leaf that is: its light is all there is */
    unsigned lit;   /* the others that meet a surface to be lit */
};

/* Whether there is a picture. */
static unsigned places_seen(const struct camera *camera,
                            const struct tracer_met *met)
{
    unsigned seen = (1u << met->count) - 1;
    for (unsigned i = 0; camera->kind->sees && i < met->count; i++)
        if (!camera_sees(camera, met->places[i].at[0], met->places[i].at[1]))
            seen &= ~(1u << i);
    return seen;
}

static void sight_describe(struct sights *sights, unsigned i)
{
    const struct tracer_met *met = sights->met;
    const struct ray ray = rays_at(met->rays, (int)i);
    world_describe_face(&ray, met->hits[i].leaf, &sights->faces, i,
                        &sights->at[i].crossing.at);
}

/* That of a plain leaf, which was painted without. */
static const struct surface *sights_surface(void *context, unsigned i)
{
    struct sights *sights = context;
    const struct tracer *tracer = sights->tracer;
    struct crossing *crossing = &sights->at[i].crossing;
    sight_describe(sights, i);
    crossing_fill(crossing, tracer, rays_direction(sights->met->rays, (int)i),
                  &tracer->start, tracer->scene->settings.adc_bailout, false);
    crossing->surface.place = &sights->met->places[i];
    return &crossing->surface;
}

/* What is met, and which leaves are plain. Returns which meet any. */
static unsigned sights_meet(struct sights *sights, unsigned seen)
{
    const struct tracer_met *met = sights->met;
    unsigned meet = 0;
    sights->plain = sights->lit = 0;
    for (unsigned i = 0; i < met->count; i++) {
        const struct leaf *leaf = met->hits[i].leaf;
        meet |= (unsigned)(leaf != NULL) << i;
        sights->plain |= (unsigned)(leaf && leaf->plain) << i;
    }
    meet &= seen;
    if (!sights->tracer->airless)
        sights->plain = 0;
    sights->plain &= seen;
    if (!meet)
        return 0;
    world_face_many(met->rays, met->hits, meet, &sights->faces);
    facets_start(&sights->facets, met->rays, &sights->faces);
    sights->facets.places = met->places;
    sights->facets.tell = sights_surface;
    sights->facets.context = sights;
    return meet;
}

/* From the camera to what it meets first, of those whose leaves are not plain;
 * some end there. */
static void sights_arrive(struct sights *sights, unsigned seen, unsigned meet,
                          struct radiance *out)
{
    const struct tracer_met *met = sights->met;
    for (unsigned each = seen & ~sights->plain; each; each &= each - 1) {
        unsigned i = (unsigned)__builtin_ctz(each);
        struct sight *sight = &sights->at[i];
        bool meets = meet >> i & 1;
        sight->path.ray = rays_at(met->rays, (int)i);
        path_start(&sight->path, sights->tracer, sights->worker,
                   &met->places[i]);
        if (meets)
            sight_describe(sights, i);
        if (path_arrive(&sight->path, &sight->crossing, meets)) {
            sights->lit |= 1u << i;
            facets_set(&sights->facets, i, &sight->crossing.surface,
                       path_within(&sight->path, &sight->crossing));
        } else {
            out[i] = path_seen(&sight->path);
        }
    }
}

static struct radiance sight_go_on(struct sight *sight, rgb light,
                                   const struct diffuse_light *diffuse)
{
    struct path *path = &sight->path;
    struct crossing *crossing = &sight->crossing;
    light = path_shade(path, crossing, light, diffuse);
    if (path_leave(path, crossing, light))
        path_go_on(path, crossing, path_meet(path, &crossing->at));
    return path_seen(path);
}

static void sights_light(struct sights *sights, struct radiance *out)
{
    const struct tracer *tracer = sights->tracer;
    struct facets *facets = &sights->facets;
    struct diffuse_light diffuse[RAY_LANES];
    tracer->lighting->illuminate_many(tracer->lighting_state, sights->worker,
                                      facets, diffuse);
    for (unsigned lit = sights->lit; lit; lit &= lit - 1) {
        unsigned i = (unsigned)__builtin_ctz(lit);
        out[i] =
            sight_go_on(&sights->at[i], facets_light(facets, i), &diffuse[i]);
    }
    if (sights->plain)
        facets_glow(facets, sights->plain, diffuse);
    for (unsigned plain = sights->plain; plain; plain &= plain - 1) {
        unsigned i = (unsigned)__builtin_ctz(plain);
        out[i] = (struct radiance){ facets_light(facets, i), 1 };
    }
}

static void see_together(const struct tracer *tracer, struct worker *worker,
                         const struct tracer_met *met, struct radiance *out)
{
    struct sights sights;
    sights.tracer = tracer;
    sights.worker = worker;
    sights.met = met;
    unsigned seen = places_seen(&tracer->scene->camera, met);
    unsigned meet = sights_meet(&sights, seen);
    memset(out, 0, met->count * sizeof *out);
    if (sights.plain)
        facets_paint(&sights.facets, met->hits, sights.plain);
    for (unsigned plain = sights.plain; plain; plain &= plain - 1)
        worker->counters.camera_rays++;
    sights_arrive(&sights, seen, meet, out);
    if (sights.plain | sights.lit)
        sights_light(&sights, out);
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
