/* Which lamps a point sees: see lamps.h. */
#include "shade/lamps.h"

#include "base/memory.h"
#include "shade/area.h"
#include "shade/shadow.h"
#include "shade/surface.h"

/* The steps that the grid of an area light leaves in its penumbra are not seen
 * beside those of several others. */
enum {
    SOFT_THOROUGHLY = 1, /* so few are looked at closely wherever they may be
                          * hidden, */
    SOFT_FINELY = 4      /* and so few where they half are; each of more as its
                          * author has it */
};

struct lamps lamps_new(const struct world *world, const struct scene *scene,
                       int quality, uint64_t seed)
{
    struct lamps lamps = {
        .world = world,
        .scene = scene,
        .quality = quality,
        .photons = scene->settings.photons.on && quality >= QUALITY_PHOTONS,
        .seed = seed,
    };
    const struct light *lights = world_lights(world, &lamps.count);
    bool air = quality >= QUALITY_FOG;
    lamps.foggy = air && (scene->fogs.count > 0 || scene->media.count > 0);
    lamps.misty = air && scene->murky;
    lamps.clear = quality >= QUALITY_SHADOWS && !lamps.misty;
    lamps.shadows = quality >= QUALITY_SHADOWS;
    lamps.smooth = quality < QUALITY_BUMPS;
    lamps.plain = lamps.clear && world_is_opaque(world);
    lamps.items = memory_new(lamps.count * sizeof *lamps.items);
    for (size_t i = 0; i < lamps.count; i++) {
        lamps.items[i] = lamp_new(&lights[i], (int)i);
        lamps.soft += lamps_soft(&lamps, &lamps.items[i]);
    }
    return lamps;
}

void lamps_free(struct lamps *lamps)
{
    memory_free(lamps->items);
}

bool lamps_soft(const struct lamps *lamps, const struct lamp *lamp)
{
    return lamp->light->area && lamps->quality >= QUALITY_AREA_LIGHTS;
}

vec3 lamps_location(const struct lamps *lamps, const struct lamp *lamp,
                    vec3 point, const double u[2])
{
    return lamps_soft(lamps, lamp) ? area_anywhere(lamp, point, u)
                                   : lamp->light->location;
}

/* One point looking at one lamp. */
struct lamp_question {
    const struct lamps *lamps;
    const struct lamp *lamp;
    struct worker *worker;
    const struct lamp_target *target;
    const struct shaft *shaft; /* to all of it, or NULL */
    bool clear;                /* where nothing is in it all light comes */
    bool plain;                /* and none where something is */
    bool together;             /* several ways are asked for at once */
};

static struct lamp_question lamp_question(const struct lamps *lamps,
                                          const struct lamp *lamp,
                                          struct worker *worker,
                                          const struct lamp_target *target)
{
    return (struct lamp_question){
        .lamps = lamps, .lamp = lamp, .worker = worker, .target = target
    };
}

/* Whether photons bring nothing there: bent light goes straight. */
static bool target_is_straight(const struct lamp_target *target)
{
    return target->leaf && target->leaf->look->photons->unlit;
}

static struct shadow_path lamp_path(const struct lamps *lamps,
                                    const struct lamp *lamp,
                                    const struct lamp_target *target)
{
    return (struct shadow_path){
        .point = target->point,
        .direction = target->view.direction,
        .distance = target->view.distance,
        .light = lamp->number,
        .inside = target->inside,
        .fog = lamps_dim(lamps, lamp) ? lamps->scene : NULL,
        .misty = lamps->misty,
        .smooth = lamps->smooth,
        .spread = target->spread,
        .photons = lamps->photons && !target_is_straight(target)
                       ? &lamp->light->photons
                       : NULL,
    };
}

/* `place` is one in the question's shaft. */
static rgb lamp_trace(const struct lamp_question *q, vec3 direction,
                      double distance, const double place[2])
{
    struct shadow_path path = lamp_path(q->lamps, q->lamp, q->target);
    path.direction = direction;
    path.distance = distance;
    path.shaft = q->shaft;
    path.place[0] = place[0];
    path.place[1] = place[1];
    return shadow_visibility(q->lamps->world, q->worker, &path);
}

/* The rays to places of the lamp: as long as the way there, or unit. */
struct lamp_ways {
    vec3 point;
    vec3 from;  /* what is subtracted from a place, */
    vec3 shift; /* and added, if it is */
    bool shifted, unit;
};

/* Parallel light comes from the grid moved to stand over the point. */
static struct lamp_ways lamp_ways(const struct lamp_question *q)
{
    const struct lamp_view *view = &q->target->view;
    bool parallel = lamp_is_parallel(q->lamp);
    return (struct lamp_ways){
        .point = q->target->point,
        .from = parallel ? q->lamp->light->location : q->target->point,
        .shift = vec3_scale(view->direction, view->distance),
        .shifted = parallel,
        .unit = !q->plain,
    };
}

static inline vec3 lamp_offset(const struct lamp_ways *ways, vec3 location)
{
    vec3 offset = vec3_sub(location, ways->from);
    return ways->shifted ? vec3_add(offset, ways->shift) : offset;
}

/* One of them, which is `offset` from the point. */
static inline vec3 lamp_way(const struct lamp_ways *ways, vec3 offset,
                            double *near, double *far)
{
    double length = vec3_length(offset), part = 1 / length;
    double start = shadow_start(ways->point, length);
    *near = ways->unit ? start : start * part;
    *far = ways->unit ? shadow_end(length) : 1 - shadow_margin(length) * part;
    return vec3_scale(offset, ways->unit && length > 0 ? part : 1);
}

CLONES static void ways_to(const struct lamp_ways *restrict from,
                           const double (*restrict places)[RAY_LANES],
                           struct occlusions *restrict ways)
{
    const struct lamp_ways lamp = *from;
    for (unsigned i = 0; i < RAY_LANES; i++) {
        vec3 offset = lamp_offset(&lamp, lane_get(places, i));
        double near, far;
        vec3 way = lamp_way(&lamp, offset, &near, &far);
        lane_put(ways->rays.origin, i, lamp.point);
        lane_put(ways->rays.direction, i, way);
        ways->span.near[i] = near;
        ways->span.far[i] = far;
    }
}

/* What comes from that place. */
static rgb lamp_see_one(const struct lamp_question *q,
                        const struct area_points *points, unsigned i)
{
    const struct lamp_ways ways = lamp_ways(q);
    vec3 location = lane_get((const double(*)[RAY_LANES])points->location, i);
    vec3 offset = lamp_offset(&ways, location);
    const double place[2] = { points->place[0][i], points->place[1][i] };
    if (worker_stopped(q->worker))
        return rgb_grey(0);
    if (q->plain) {
        double near, far;
        vec3 way = lamp_way(&ways, offset, &near, &far);
        const struct ray ray = { ways.point, way };
        q->worker->counters.shadow_rays++;
        return rgb_grey(!shaft_hides(q->shaft, place, &ray, near, far));
    }
    return lamp_trace(q, vec3_normalise(offset), vec3_length(offset), place);
}

/* From which of `lanes` nothing comes, where opaque shapes stand in the way. */
static unsigned lamp_dark(const struct lamp_question *q,
                          const struct occlusions *ways, unsigned lanes)
{
    q->worker->counters.shadow_rays += (unsigned)__builtin_popcount(lanes);
    return shaft_hides_many(q->shaft, ways->place, &ways->rays, &ways->span,
                            lanes);
}

/* What comes from several together, as far as that can be said. */
static void lamp_fall(const struct lamp_question *q, struct occlusions *ways,
                      unsigned lanes, struct shadows *shadows)
{
    const struct interiors *inside[RAY_LANES];
    struct shadow_around around = lamps_around(q->lamps, q->lamp, inside);
    around.straight = target_is_straight(q->target) ? ~0u : 0;
    for (int i = 0; i < RAY_LANES; i++)
        inside[i] = q->target->inside;
    ways->light = q->lamp->number;
    shadow_falls_many(q->lamps->world, q->worker, ways, lanes, &around,
                      shadows);
}

/* From those that are not clear. */
static void lamp_see_shaded(const struct lamp_question *q,
                            const struct area_points *points, unsigned lanes,
                            rgb *seen)
{
    const struct lamp_ways from = lamp_ways(q);
    struct shadows shadows;
    struct occlusions ways;
    bool together = q->together && lanes & (lanes - 1);
    shadows.dark = shadows.tinted = 0;
    shadows.left = together ? 0 : lanes;
    ways.shaft = q->shaft;
    ways.place = (const double(*)[RAY_LANES])points->place;
    if (together)
        ways_to(&from, (const double(*)[RAY_LANES])points->location, &ways);
    if (together && q->plain)
        shadows.dark = lamp_dark(q, &ways, lanes);
    else if (together)
        lamp_fall(q, &ways, lanes, &shadows);
    for (; lanes; lanes &= lanes - 1) {
        unsigned i = (unsigned)__builtin_ctz(lanes);
        seen[i] = shadows.left >> i & 1 ? lamp_see_one(q, points, i)
                                        : shadows_along(&shadows, i);
    }
}

/* To which of them something may be on the way. */
static unsigned lamp_shaded(const struct lamp_question *q,
                            const struct area_points *points)
{
    const double place[2] = { points->place[0][0], points->place[1][0] };
    if (points->count == 1)
        return !shaft_clear(q->shaft, place);
    return shaft_shaded_many(q->shaft,
                             (const double(*)[RAY_LANES])points->place);
}

static void lamp_see(void *context, const struct area_points *points, rgb *seen)
{
    const struct lamp_question *q = context;
    unsigned lanes = (1u << points->count) - 1;
    bool stopped = worker_stopped(q->worker);
    for (int i = 0; i < points->count; i++)
        seen[i] = rgb_grey(stopped ? 0 : 1);
    if (q->clear)
        lanes &= lamp_shaded(q, points);
    if (lanes && !stopped)
        lamp_see_shaded(q, points, lanes, seen);
}

static bool lamp_casts(const struct lamps *lamps, const struct lamp *lamp)
{
    return !lamp->light->shadowless && lamps->quality >= QUALITY_SHADOWS;
}

rgb lamps_share_point(const struct lamps *lamps, const struct lamp *lamp,
                      struct worker *worker, const struct lamp_target *target)
{
    if (!lamp_casts(lamps, lamp))
        return rgb_grey(1);
    struct shadow_path path = lamp_path(lamps, lamp, target);
    return shadow_visibility(lamps->world, worker, &path);
}

/* To all places of a lamp with a size. */
static struct shaft_rays lamp_rays(const struct lamp_question *q,
                                   const struct area_grid *grid)
{
    vec3 point = q->target->point;
    const struct lamp_ways ways = lamp_ways(q);
    vec3 offset = lamp_offset(&ways, q->lamp->light->location);
    struct shaft_rays rays = { .from = point,
                               .middle = vec3_add(point, offset) };
    area_grid_hull(grid, rays.half);
    double nearest = vec3_length(offset) - vec3_length(rays.half[0]) -
                     vec3_length(rays.half[1]);
    rays.tmin = shadow_start(point, fmax(nearest, 0));
    rays.leaf = q->target->leaf;
    rays.normal = q->target->face;
    return rays;
}

/* What stands between. */
static void lamp_shaft(struct lamp_question *q, const struct area_grid *grid,
                       struct shaft *shaft)
{
    struct shaft_rays rays = lamp_rays(q, grid);
    world_shaft(q->lamps->world, &rays, shaft);
    q->shaft = shaft;
    q->together = lamps_ways_together(q->lamps, q->lamp);
    q->clear = !shaft->crowded && lamps_clear_ways(q->lamps, q->lamp);
    q->plain = q->clear && shaft->plain;
}

static rgb lamp_share(struct lamp_question *q, const struct area_grid *grid,
                      bool fine)
{
    rgb arriving =
        rgb_scale(q->lamp->light->colour, q->target->view.attenuation);
    if (q->clear && q->shaft->count == 0)
        return rgb_grey(1);
    if (!fine)
        return area_visibility(grid, arriving, lamp_see, q);
    bool thorough = !q->shaft->crowded && q->lamps->soft <= SOFT_THOROUGHLY;
    return area_outline(grid, arriving, thorough, lamp_see, q);
}

static rgb lamps_share_grid(struct lamp_question *q, bool fine)
{
    struct area_grid grid =
        area_grid_new(q->lamp, q->target->point, q->lamps->seed);
    struct shaft shaft;
    if (fine)
        area_grid_refine(&grid);
    lamp_shaft(q, &grid, &shaft);
    return lamp_share(q, &grid, fine);
}

rgb lamps_share(const struct lamps *lamps, const struct lamp *lamp,
                struct worker *worker, const struct lamp_target *target)
{
    if (!lamp_casts(lamps, lamp) || !lamps_soft(lamps, lamp))
        return lamps_share_point(lamps, lamp, worker, target);
    struct lamp_question q = lamp_question(lamps, lamp, worker, target);
    return lamps_share_grid(&q, false);
}

rgb lamps_share_fine(const struct lamps *lamps, const struct lamp *lamp,
                     struct worker *worker, const struct lamp_target *target)
{
    if (!lamp_casts(lamps, lamp) || !lamps_soft(lamps, lamp))
        return lamps_share_point(lamps, lamp, worker, target);
    struct lamp_question q = lamp_question(lamps, lamp, worker, target);
    return lamps_share_grid(&q, lamps->soft <= SOFT_FINELY);
}

/* A light that turns to each point turns by so little within the piece. */
static void hull_widen(vec3 half[2], const struct light *light, double radius,
                       double distance)
{
    double wider = light->orient ? 1 + 2 * radius / distance : 1;
    for (int k = 0; k < 2; k++)
        half[k] = vec3_scale(half[k], wider);
}

static struct shaft_rays piece_rays(const struct lamps *lamps,
                                    const struct lamp *lamp,
                                    const struct lamp_piece *piece,
                                    const struct area_grid *grid)
{
    const struct lamp_target *target = &piece->middle;
    struct lamp_question q = lamp_question(lamps, lamp, NULL, target);
    struct shaft_rays rays = lamp_rays(&q, grid);
    hull_widen(rays.half, lamp->light, piece->radius, target->view.distance);
    rays.radius = piece->radius;
    rays.bend = piece->bend;
    return rays;
}

bool lamps_open(const struct lamps *lamps, const struct lamp *lamp,
                const struct lamp_piece *piece)
{
    const struct lamp_target *target = &piece->middle;
    if (!lamps_clear_ways(lamps, lamp) || lamp_is_parallel(lamp) ||
        lamp->light->orient || !(target->view.distance > 0))
        return false;
    struct area_grid grid = area_grid_new(lamp, target->point, lamps->seed);
    struct shaft_rays rays = piece_rays(lamps, lamp, piece, &grid);
    return world_blur(lamps->world, &rays, HUGE_VAL) == HUGE_VAL;
}

double lamps_blur(const struct lamps *lamps, const struct lamp *lamp,
                  const struct lamp_piece *piece, double enough)
{
    const struct lamp_target *target = &piece->middle;
    struct area_grid grid = area_grid_new(lamp, target->point, lamps->seed);
    if (!(target->view.distance > 0))
        return 0;
    area_grid_refine(&grid);
    struct shaft_rays rays = piece_rays(lamps, lamp, piece, &grid);
    return world_blur(lamps->world, &rays, enough);
}
