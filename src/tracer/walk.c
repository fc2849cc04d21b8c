/* Path tracing (Kajiya 1986) with the rules of the recursive tracer for what a
 * ray meets, and these beyond them:
 * - Light comes to a surface from everywhere. A scattered ray that meets
 *   something glowing counts with the balance heuristic's weight (direct.c).
 * - `ambient` is as bright as the scene is open there (shade/ambience.h), told
 *   by one more ray a surface; what scattered rays meet of sky and background,
 *   where these are no lamps, and of what only seems to glow, is dark.
 *   adc_bailout is ignored. max_trace_level holds, as the scene's own word on
 *   mirrors and glass (without it light that a surface scatters into a glass
 *   ball stays there for ever); a scattered ray begins again at 1.
 * - Mirrors, panes and the scattering surface are all followed where the camera
 *   sees them, of later ones one, chosen by weight. Light that is mirrored or
 *   bent on its way from a glowing surface (caustics) is found by scattered
 *   rays alone: exact, but slow to settle if that surface is small. Lamps are
 *   points: what photons bring of theirs is taken from the map (photons.h),
 *   with its blur; where none are sent their light goes straight through what
 *   is transparent, as POV-Ray's does.
 * - A reflection exponent is not linear: it is applied to each sample.
 * - Russian roulette (Arvo and Kirk 1990) ends paths that weigh little; with
 *   --guide those that are worth little, and splits those worth much. */
#include "tracer/walk.h"

#include "base/warp.h"
#include "shade/background.h"
#include "shade/finish.h"
#include "shade/rainbow.h"
#include "shade/shadow.h"
#include "tracer/crossing.h"
#include "tracer/direct.h"
#include "tracer/drift.h"
#include "tracer/lobes.h"
#include "tracer/photons.h"
#include "tracer/ways.h"

enum {
    VERTICES_MAX = 2000, /* of a path: for safety alone */
    SPLITS_MAX = 8,      /* where all ways are followed */
    EXPONENTS_MAX = 24,  /* mirrors with an exponent in a row */
    COPIES_MOST = 16,    /* rays that a surface scatters */
    COPIES_ALL = 64,     /* of a path, at all its surfaces */
};

/* Parts of a split path weigh at least this, or are left to roulette. */
static const double split_least = 1.0 / 32;
/* So do paths after a scattering. */
static const double path_least = 1.0 / 4;

/* Of guided paths each ray should bring at least this share of the light of all
 * pixels, or of one that is darker: there of a mean of the two, of logarithms 3
 * to 1. Rays that bring less than worth_least of that are left to roulette, but
 * for copies_least of them. Measured: tests/path/guide. */
static const double worth_share = 0.2, worth_least = 0.5, copies_least = 0.05;

/* Layers darker than this are left out. */
static const double layer_least = 1e-7;

/* What each vertex draws. */
enum {
    SLOT_WAY = 16,
    SLOT_LOBE,
    SLOT_DIRECTION,
    SLOT_ROULETTE,
    SLOT_COPY,
    SLOT_OPEN,
    SLOT_BRANCH
};

/* A surface on the path, and the numbers drawn there. */
struct meeting {
    struct crossing crossing;
    struct ways ways; /* but for scattering */
    struct lobes lobes;
    struct draws draws;
};

static void walk_gather(struct walk *walk, rgb light)
{
    walk->light = rgb_add(walk->light, rgb_mul(walk->share, light));
}

static void walk_veil(struct walk *walk, const struct veil *veil)
{
    walk_gather(walk, veil->light);
    walk->share = rgb_mul(walk->share, veil->through);
    walk->clear *= rgb_brightness(veil->through);
}

static const struct ambience *walk_ambience(const struct walk *walk)
{
    const struct light_set *set = walk->tracer->lighting_state;
    return &set->ambience;
}

/* Sky and fog are seen, but light nothing unless they are lamps. */
static bool walk_sees_sky(const struct walk *walk)
{
    return walk->split || walk_ambience(walk)->sky;
}

static void walk_rainbows(struct walk *walk, double distance)
{
    if (!walk->split || !tracer_arched(walk->tracer, &walk->inside))
        return;
    struct veil veil = rainbow_veil(walk->tracer->scene, &walk->ray, distance);
    walk_veil(walk, &veil);
}

static void walk_fog(struct walk *walk, double distance)
{
    if (!tracer_foggy(walk->tracer, &walk->inside))
        return;
    struct veil veil = fog_veil(walk->tracer->scene, &walk->ray, distance);
    if (!walk_sees_sky(walk))
        veil.light = rgb_grey(0);
    walk_veil(walk, &veil);
}

static void walk_leave(struct walk *walk, const struct crossing *crossing,
                       const struct way *way)
{
    bool bends = crossing->ior != 1 || way->kind != WAY_THROUGH;
    if (way->kind == WAY_THROUGH) {
        interiors_copy(&walk->inside, &crossing->beyond);
        walk->clear *= rgb_brightness(crossing->surface.through);
    } else {
        walk->straight = false;
        walk->clear = 0;
    }
    if (way->kind == WAY_MIRRORED)
        walk->kind = RAY_REFLECTION;
    else if (crossing->leaving)
        walk->share = rgb_mul(
            walk->share,
            interior_fade(crossing->at.leaf->look->interior, crossing->at.t));
    walk->share = rgb_mul(walk->share, way->weight);
    if (bends) {
        walk->density = 0;
        walk->level++;
    }
    walk->ray = (struct ray){ crossing->at.point, way->direction };
    walk->worker->counters.secondary_rays++;
}

/* What the surface makes of light, for direct_light. */
struct scatterer {
    const struct surface *surface;
    const struct lobes *lobes;
    bool scatters; /* rays, too */
    bool seen;     /* by the camera: highlights count */
};

static rgb scatterer_response(const void *context, vec3 direction, bool lamp,
                              bool highlights)
{
    const struct scatterer *scatterer = context;
    (void)lamp;
    return surface_response(scatterer->surface, direction,
                            highlights && scatterer->seen);
}

static double scatterer_density(const void *context, vec3 direction)
{
    const struct scatterer *scatterer = context;
    return scatterer->scatters ? lobes_density(scatterer->lobes, direction) : 0;
}

/* Whether light from other surfaces counts. */
static bool walk_scatters(const struct walk *walk)
{
    return walk->tracer->quality >= QUALITY_FOG;
}

static const struct guide *walk_guide(const struct walk *walk)
{
    const struct light_set *set = walk->tracer->lighting_state;
    return walk->tracer->guided ? set->guide : NULL;
}

/* What a ray should bring, once the path knows how bright its pixel is. */
static void walk_value(struct walk *walk, const struct meeting *meeting,
                       rgb lamps)
{
    double typical = walk->tracer->typical, light = meeting->lobes.light;
    if (walk->worth > 0 || !(light > 0))
        return;
    double pixel = walk->base * rgb_peak(walk->share) *
                   (rgb_peak(lamps) + meeting->lobes.total * light);
    pixel = fmin(pixel, typical);
    walk->worth = worth_share * sqrt(typical * sqrt(typical * pixel));
}

struct photon_asker {
    struct walk *walk;
    const struct surface *surface;
};

/* What photons bring, which no ray finds: light of lamps that was bent. */
static void walk_photon(void *context, const struct light_sample *sample)
{
    const struct photon_asker *asker = context;
    rgb response =
        surface_response(asker->surface, sample->direction, asker->walk->split);
    walk_gather(asker->walk, rgb_mul(response, sample->colour));
}

static void walk_photons(struct walk *walk, const struct meeting *meeting)
{
    const struct surface *surface = &meeting->crossing.surface;
    struct photon_asker asker = { walk, surface };
    photons_light(walk->tracer, walk->worker, surface, walk_photon, &asker);
}

static void walk_direct(struct walk *walk, struct meeting *meeting)
{
    const struct crossing *crossing = &meeting->crossing;
    struct scatterer scatterer = { &crossing->surface, &meeting->lobes,
                                   walk_scatters(walk), walk->split };
    struct receiver receiver = {
        .point = crossing->at.point,
        .inside = &walk->inside,
        .behind = &crossing->beyond,
        .normal = crossing->surface.normal,
        .response = scatterer_response,
        .density = scatterer_density,
        .context = &scatterer,
        .leaf = crossing->at.leaf,
        .straight = crossing->at.leaf->look->photons->unlit,
    };
    rgb lamps = direct_lamps(walk->tracer, walk->worker, &receiver,
                             &meeting->draws, walk->split);
    walk_photons(walk, meeting);
    lobes_guide(&meeting->lobes, walk_guide(walk), receiver.point,
                receiver.normal, rgb_peak(lamps) > 0);
    walk_value(walk, meeting, lamps);
    walk_gather(walk, lamps);
    walk_gather(walk, direct_emitters(walk->tracer, walk->worker, &receiver,
                                      &meeting->draws));
}

/* On into a direction that the surface scatters to, with `scale`. False if it
 * swallows the ray. */
static bool walk_scatter(struct walk *walk, const struct meeting *meeting,
                         const struct draws *draws, double scale)
{
    const struct crossing *crossing = &meeting->crossing;
    double u[2];
    draw_pair(draws, SLOT_DIRECTION, u);
    vec3 direction =
        lobes_sample(&meeting->lobes, draw_unit(draws, SLOT_LOBE), u);
    double density = lobes_density(&meeting->lobes, direction);
    rgb response = surface_response(&crossing->surface, direction, false);
    if (rgb_peak(response) == 0 || !(density > 0) || !isfinite(density))
        return false;
    walk->share =
        rgb_mul(walk->share, rgb_scale(response, scale / (WARP_PI * density)));
    if (vec3_dot(direction, crossing->surface.normal) < 0)
        interiors_copy(&walk->inside, &crossing->beyond);
    walk->ray = (struct ray){ crossing->at.point, direction };
    walk->kind = RAY_REFLECTION;
    walk->split = walk->straight = false;
    walk->clear = 0;
    walk->density = density;
    walk->from = crossing->at.point;
    walk->level = 1;
    walk->worker->counters.secondary_rays++;
    return true;
}

/* How many rays the light there is worth: a whole number, or, below 1, the
 * chance of one. 0: nobody knows. */
static double walk_copies(const struct walk *walk,
                          const struct meeting *meeting, double scale)
{
    double light = meeting->lobes.total * meeting->lobes.light;
    double rays =
        walk->base * rgb_peak(walk->share) * scale * light / walk->worth;
    if (!(walk->worth > 0) || !(rays > 0) || !isfinite(rays))
        return 0;
    if (rays < worth_least)
        return fmax(rays / worth_least, copies_least);
    double most = fmin(COPIES_MOST, floor(COPIES_ALL / walk->copies));
    return fmax(1, floor(fmin(rays, most)));
}

/* A ray of its own of those that the surface scatters. */
static void walk_copy(struct walk *walk, const struct meeting *meeting,
                      const struct draws *draws, double scale)
{
    struct walk copy = *walk;
    copy.base *= rgb_peak(walk->share);
    copy.draws = draws_within(draws, SLOT_COPY);
    copy.splits++;
    copy.share = rgb_grey(1);
    copy.light = rgb_grey(0);
    if (walk_scatter(&copy, meeting, draws, scale))
        walk_gather(walk, walk_follow(&copy).colour);
}

/* Adjoint-driven Russian roulette and splitting (Vorba and Krivanek 2016): as
 * many rays as the light there is worth. The copies of all samples together
 * are as evenly spread as samples are. */
static bool walk_spread(struct walk *walk, const struct meeting *meeting,
                        double scale)
{
    double copies = walk_copies(walk, meeting, scale);
    struct draws draws = meeting->draws;
    if (copies == 0)
        return walk_scatter(walk, meeting, &draws, scale);
    walk->judged = true;
    if (copies < 1 && draw_unit(&draws, SLOT_ROULETTE) >= copies)
        return false;
    int count = copies < 1 ? 1 : (int)copies;
    walk->copies *= count;
    draws.index *= (uint32_t)count;
    for (; count > 1; count--, draws.index++)
        walk_copy(walk, meeting, &draws, scale / copies);
    walk->draws = draws_within(&draws, SLOT_COPY);
    return walk_scatter(walk, meeting, &draws, scale / copies);
}

static bool walk_take(struct walk *walk, const struct meeting *meeting,
                      const struct way *way)
{
    walk->weight *= rgb_peak(way->weight);
    if (way->kind == WAY_SCATTERED)
        return walk_spread(walk, meeting, way->weight.r / meeting->lobes.total);
    walk_leave(walk, &meeting->crossing, way);
    return true;
}

/* Gathers the light that comes that way by a walk of its own. */
static void walk_branch(struct walk *walk, const struct meeting *meeting,
                        const struct way *way, int number)
{
    struct walk branch = *walk;
    branch.base *= rgb_peak(walk->share);
    struct way taken = *way;
    double exponent = way_exponent(way);
    rgb outside = rgb_grey(1);
    if (exponent != 1) {
        outside = way->weight;
        taken.weight = rgb_grey(1);
        branch.weight *= rgb_peak(outside);
    }
    branch.draws =
        draws_within(&meeting->draws, (uint64_t)(SLOT_BRANCH + number));
    branch.splits++;
    branch.share = rgb_grey(1);
    branch.clear = 1;
    branch.light = rgb_grey(0);
    if (!walk_take(&branch, meeting, &taken))
        return;
    rgb light = walk_follow(&branch).colour;
    walk_gather(walk, rgb_mul(outside, finish_exponent(light, exponent)));
}

/* All ways but the first are followed by walks of their own, those of little
 * weight only sometimes; the first is left. */
static void walk_split(struct walk *walk, const struct meeting *meeting,
                       struct ways *ways)
{
    struct draws chances = draws_within(&meeting->draws, SLOT_BRANCH);
    while (ways->count > 1) {
        struct way way = ways->at[--ways->count];
        double weight = walk->weight * rgb_peak(way.weight);
        double chance = fmin(1, weight / split_least);
        if (chance < 1 && draw_unit(&chances, (uint32_t)ways->count) >= chance)
            continue;
        way.weight = rgb_scale(way.weight, 1 / chance);
        walk_branch(walk, meeting, &way, ways->count);
    }
}

/* Onwards from the surface; false if the path ends there. */
static bool walk_on(struct walk *walk, const struct meeting *meeting)
{
    struct ways ways = meeting->ways;
    if (walk_scatters(walk))
        ways_add(&ways, WAY_SCATTERED, walk->ray.direction,
                 rgb_grey(meeting->lobes.total), NULL);
    if (ways.count == 0)
        return false;
    if (walk->split && walk->splits < SPLITS_MAX)
        walk_split(walk, meeting, &ways);
    else if (ways.count > 1)
        ways_choose(&ways, draw_unit(&meeting->draws, SLOT_WAY));
    if (way_exponent(&ways.at[0]) == 1 || walk->splits >= EXPONENTS_MAX)
        return walk_take(walk, meeting, &ways.at[0]);
    walk_branch(walk, meeting, &ways.at[0], 0);
    return false;
}

static bool walk_survives(struct walk *walk, const struct draws *draws,
                          int vertex)
{
    double chance =
        walk->split || walk->judged ? 1 : rgb_peak(walk->share) / path_least;
    walk->judged = false;
    if (vertex > 64)
        chance = fmin(chance, 0.98); /* even where nothing is lost */
    if (chance >= 1)
        return true;
    if (draw_unit(draws, SLOT_ROULETTE) >= chance)
        return false;
    walk->share = rgb_scale(walk->share, 1 / chance);
    return true;
}

/* Light that only `ambient` speaks of. */
static void walk_ambient(struct walk *walk, const struct meeting *meeting)
{
    const struct ambience *ambience = walk_ambience(walk);
    const struct surface *surface = &meeting->crossing.surface;
    if (walk->split)
        walk_gather(walk, surface_shine(surface));
    rgb share = rgb_mul(surface_ambient(surface), ambience->light);
    if (rgb_peak(share) == 0)
        return;
    double u[2];
    draw_pair(&meeting->draws, SLOT_OPEN, u);
    struct ray ray = { surface->point, warp_lobe(u, surface->normal, 1) };
    double open =
        ambience_open(ambience, walk->tracer->world, walk->worker, &ray);
    walk_gather(walk, rgb_scale(share, open));
}

/* Finishes may send back more than they get. What the camera sees of such a
 * surface is as bright as it says; from one surface to the next the light must
 * not grow (shade/finish.h, surface_returned), and a sky sends none of it on
 * (shade/ambience.h). */
static void walk_restrain(struct walk *walk, const struct meeting *meeting)
{
    if (walk->split)
        return;
    const struct surface *surface = &meeting->crossing.surface;
    double solid = 1 - fmin(surface_sky(surface), 1);
    double restraint = surface_restraint(surface);
    double total = meeting->lobes.total + ways_total(&meeting->ways);
    if (meeting->lobes.total > 0 && total * restraint > RETURNED_MOST)
        restraint = RETURNED_MOST / total;
    walk->share = rgb_scale(walk->share, solid * restraint);
}

/* What lies beyond all surfaces. */
static rgb walk_beyond(const struct walk *walk, double *clear)
{
    rgb light = tracer_background(walk->tracer, walk->ray.direction,
                                  walk->straight, clear);
    return walk_sees_sky(walk) ? light : rgb_grey(0);
}

static bool walk_shines(const struct surface *surface)
{
    for (int i = 0; i < surface->count; i++)
        if (finish_shines(surface->layer[i].finish))
            return true;
    return false;
}

/* Meets what the ray hits. False if the path ends there. */
static bool walk_meet(struct walk *walk, struct meeting *meeting)
{
    struct crossing *crossing = &meeting->crossing;
    const struct surface *surface = &crossing->surface;
    crossing_fill(crossing, walk->tracer, walk->ray.direction, &walk->inside,
                  layer_least, true);
    if (walk->tracer->quality < QUALITY_LIT) {
        walk_gather(walk, colour_rgb(surface->layer[0].pigment));
        return false;
    }
    rgb glow = surface_glow(surface);
    if (walk->density > 0 && rgb_peak(glow) > 0)
        glow = rgb_scale(glow, direct_weight(walk->tracer->lighting_state,
                                             walk->from, walk->ray.direction,
                                             walk->density, &crossing->at));
    walk_gather(walk, glow);
    walk_ambient(walk, meeting);
    const struct arrival arrival = { walk->tracer, walk->ray.direction,
                                     walk->level, walk->split };
    ways_find(&meeting->ways, &arrival, crossing);
    lobes_fill(&meeting->lobes, surface);
    walk_restrain(walk, meeting);
    if (meeting->lobes.total > 0 || (walk->split && walk_shines(surface)))
        walk_direct(walk, meeting);
    return walk_on(walk, meeting);
}

struct radiance walk_follow(struct walk *walk)
{
    const struct tracer *tracer = walk->tracer;
    struct meeting meeting;
    for (int vertex = 1; vertex <= VERTICES_MAX; vertex++) {
        if (worker_stopped(walk->worker))
            break;
        bool met = world_closest(tracer->world, &walk->ray,
                                 surface_offset(walk->ray.origin), walk->kind,
                                 &meeting.crossing.at);
        double distance = met ? meeting.crossing.at.t : (double)INFINITY;
        meeting.draws = draws_within(&walk->draws, (uint64_t)vertex);
        const struct leaf *end = met ? meeting.crossing.at.leaf : NULL;
        if (walk_drift(walk, &meeting.draws, end, &distance)) {
            if (walk_survives(walk, &meeting.draws, vertex))
                continue;
            break;
        }
        walk_fog(walk, distance);
        walk_rainbows(walk, distance);
        if (!met) {
            double clear;
            walk_gather(walk, walk_beyond(walk, &clear));
            return (struct radiance){ walk->light, 1 - walk->clear * clear };
        }
        if (!walk_meet(walk, &meeting) ||
            !walk_survives(walk, &meeting.draws, vertex))
            break;
    }
    return (struct radiance){ walk->light, 1 };
}
