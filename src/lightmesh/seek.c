/* How a surface finds the mesh points in space that light it, and how much each
 * of them counts: point_mesh_blend and its kin of point_mesh.h. */
#include <string.h>

#include "base/random.h"
#include "base/smooth.h"
#include "lightmesh/obstacles.h"
#include "lightmesh/point_mesh.h"
#include "lightmesh/tuning.h"
#include "shade/shadow.h"

/* A surface place that looks for its mesh points. */
struct seeker {
    const struct point_mesh *mesh;
    struct worker *worker;
    const struct receiver *receiver;
    int level, finer; /* levels that may follow it */
    double least;     /* share of a point that isn't asked */
    struct mesh_blend *blend;
};

static bool seeker_sees(const struct seeker *seeker,
                        const struct lattice_point *point, vec3 from)
{
    const struct obstacles *around =
        point_mesh_around(seeker->mesh, seeker->worker, point);
    vec3 offset = vec3_sub(seeker->receiver->point, from);
    enum sight sight = obstacles_sight(around, offset, seeker->receiver->side);
    if (sight != SIGHT_UNSURE)
        return sight == SIGHT_CLEAR;
    double length = vec3_length(offset);
    struct ray ray = { seeker->receiver->point,
                       vec3_scale(offset, -1 / length) };
    seeker->worker->counters.shadow_rays++;
    return !world_occluded(
        seeker->mesh->world,
        &(struct occlusion){ .ray = &ray,
                             .tmin = surface_offset(seeker->receiver->point),
                             .tmax = length,
                             .light = -1,
                             .spread = gather_spread });
}

/* 0 behind the surface, 1 well before it. */
static double seeker_rise(const struct seeker *seeker, vec3 from,
                          double spacing)
{
    double rise = vec3_dot(vec3_sub(from, seeker->receiver->point),
                           seeker->receiver->side);
    return smooth_step(rise / (seek_rise * spacing));
}

/* Mesh points of one level that are before the surface. */
struct candidates {
    int count;
    struct {
        struct lattice_point point;
        vec3 place;
        double weight;
    } at[INTERPOLATION_POINTS];
};

static void seek_candidates(const struct seeker *seeker,
                            struct candidates *candidates)
{
    const struct point_mesh *mesh = seeker->mesh;
    struct mesh_weight weights[INTERPOLATION_POINTS];
    double spacing = lattice_spacing(&mesh->lattice, seeker->level);
    vec3 lifted = vec3_along(seeker->receiver->point, seeker->receiver->side,
                             seek_lift * spacing);
    vec3 at = lattice_units(&mesh->lattice, seeker->level, lifted);
    int count = mesh->interpolation->weights(at, seeker->receiver->side,
                                             mesh->radius, weights);
    double least = 0;
    for (int i = 0; i < count; i++)
        least += seeker->least * weights[i].weight;
    candidates->count = 0;
    for (int i = 0; i < count; i++) {
        struct lattice_point point;
        if (weights[i].weight <= least)
            continue;
        point.level = seeker->level;
        memcpy(point.at, weights[i].at, sizeof point.at);
        vec3 from = lattice_place(&mesh->lattice, &point);
        double weight =
            (weights[i].weight - least) * seeker_rise(seeker, from, spacing);
        if (weight <= 0)
            continue;
        candidates->at[candidates->count].point = point;
        candidates->at[candidates->count].place = from;
        candidates->at[candidates->count++].weight = weight;
    }
}

/* Adds all candidates if they know about the same: then it doesn't matter
 * which of them see the place. Returns false, having added none, if not. */
static bool seek_alike(struct seeker *seeker,
                       const struct candidates *candidates)
{
    const struct point_mesh *mesh = seeker->mesh;
    struct mesh_blend *blend = seeker->blend;
    double least = HUGE_VAL, most = 0;
    if (!mesh->amount || mesh->interpolation->single)
        return false;
    for (int i = 0; i < candidates->count; i++) {
        const void *payload =
            point_mesh_payload(mesh, seeker->worker, &candidates->at[i].point);
        double amount = mesh->amount(payload);
        least = fmin(least, amount);
        most = fmax(most, amount);
        if (most > alike_amounts * least)
            return false;
        blend->at[blend->count + i].payload = payload;
        blend->at[blend->count + i].weight = candidates->at[i].weight;
    }
    blend->count += candidates->count;
    return true;
}

static void seek_seen(struct seeker *seeker,
                      const struct candidates *candidates)
{
    const struct point_mesh *mesh = seeker->mesh;
    struct mesh_blend *blend = seeker->blend;
    for (int i = 0; i < candidates->count; i++) {
        const struct lattice_point *point = &candidates->at[i].point;
        if (!seeker_sees(seeker, point, candidates->at[i].place))
            continue;
        blend->at[blend->count].payload =
            point_mesh_payload(mesh, seeker->worker, point);
        blend->at[blend->count++].weight = candidates->at[i].weight;
        if (mesh->interpolation->single)
            break;
    }
}

/* Adds the points of one level, whose weights sum to 1. Returns the share of
 * those that can't see the place. */
static double seek_points(struct seeker *seeker)
{
    struct mesh_blend *blend = seeker->blend;
    struct candidates candidates;
    int first = blend->count;
    double sum = 0, all = 0;
    seek_candidates(seeker, &candidates);
    if (!seek_alike(seeker, &candidates))
        seek_seen(seeker, &candidates);
    for (int i = 0; i < candidates.count; i++)
        all += candidates.at[i].weight;
    for (int i = first; i < blend->count; i++)
        sum += blend->at[i].weight;
    for (int i = first; i < blend->count; i++)
        blend->at[i].weight /= sum;
    return all > 0 ? 1 - sum / all : 0;
}

/* The share of the next finer level where this one gave the points from number
 * `first` of the blend on: all if there are none. */
static double seek_finer(const struct seeker *seeker, int first, double hidden)
{
    const struct point_mesh *mesh = seeker->mesh;
    const struct mesh_blend *blend = seeker->blend;
    struct refine_views views;
    if (seeker->finer == 0 || seeker->level == 0 ||
        blend->count > BLEND_POINTS - 2 * INTERPOLATION_POINTS)
        return 0;
    if (blend->count == first)
        return 1;
    views.count = blend->count - first;
    views.hidden = mesh->interpolation->single ? 0 : hidden;
    for (int i = 0; i < views.count; i++) {
        const void *payload = blend->at[first + i].payload;
        views.at[i].weight = blend->at[first + i].weight;
        views.at[i].light = mesh->light(mesh->context, seeker->receiver->point,
                                        seeker->receiver->side, payload);
    }
    return refine_share(&mesh->refinement, refine_difference(&views));
}

/* Gives the points first..middle-1 of a blend one share, those after them the
 * other; points of no share are left out. */
static void blend_share(struct mesh_blend *blend, int first, int middle,
                        double before, double after)
{
    int count = first;
    for (int i = first; i < blend->count; i++) {
        double share = i < middle ? before : after;
        if (share <= 0)
            continue;
        blend->at[count].payload = blend->at[i].payload;
        blend->at[count++].weight = blend->at[i].weight * share;
    }
    blend->count = count;
}

/* Adds the points of one level and, where those differ, of finer ones: their
 * weights sum to `share`. */
static void seek_level(struct seeker seeker, double share)
{
    struct mesh_blend *blend = seeker.blend;
    int first = blend->count;
    double hidden = seek_points(&seeker);
    double finer = seek_finer(&seeker, first, hidden);
    int middle = blend->count;
    if (finer > 0) {
        seeker.level--;
        seeker.finer--;
        seek_level(seeker, 1);
    }
    if (blend->count == middle)
        finer = 0;
    blend_share(blend, first, middle, share * (1 - finer), share * finer);
}

/* The place as a mesh point of its own. */
static void seek_here(struct seeker *seeker)
{
    const struct point_mesh *mesh = seeker->mesh;
    struct mesh_site site = { .place = seeker->receiver->point,
                              .dither = 0.5,
                              .lone = true,
                              .normal = seeker->receiver->side,
                              .worth = seeker->receiver->weight };
    double place[3] = { site.place.x, site.place.y, site.place.z };
    for (int i = 0; i < 3; i++) {
        uint64_t bits;
        memcpy(&bits, &place[i], sizeof bits);
        site.key = random_key(site.key, bits);
    }
    void *payload = arena_alloc(seeker->worker->scratch, mesh->payload_size);
    point_mesh_fill(mesh, seeker->worker, &site, payload);
    atomic_fetch_add_explicit(&mesh->work->lone, 1, memory_order_relaxed);
    seeker->blend->count = 1;
    seeker->blend->here = true;
    seeker->blend->at[0].payload = payload;
    seeker->blend->at[0].weight = 1;
}

int point_mesh_worth(double weight)
{
    int levels = 0;
    for (double fine = worth_fine;
         weight < fine && levels < POINT_MESH_WORTHS - 1; fine /= worth_step)
        levels++;
    return levels;
}

double point_mesh_typical_worth(int levels)
{
    return levels == 0 ? 1 : 0.5 * worth_fine / pow(worth_step, levels - 1);
}

/* The seeker at its level; *finest is what its view asks for, *coarse the share
 * of the next. */
static struct seeker seeker_new(const struct point_mesh *mesh,
                                struct worker *worker,
                                const struct receiver *receiver, int *finest,
                                double *coarse)
{
    struct seeker seeker = { .mesh = mesh,
                             .worker = worker,
                             .receiver = receiver,
                             .finer = mesh->refinement.levels,
                             .least = mesh->least /
                                      fmax(receiver->weight, seek_worth) };
    seeker.level =
        lattice_level(&mesh->lattice, &receiver->view, receiver->point, coarse);
    *finest = seeker.level - receiver->view.coarser;
    seeker.level += point_mesh_worth(receiver->weight);
    if (seeker.level > LATTICE_LEVELS - 2)
        seeker.level = LATTICE_LEVELS - 2;
    return seeker;
}

/* Adds the points of the seeker's level or else of finer ones, and of the next
 * coarser one by its share. */
static void seek_levels(struct seeker seeker, int finest, double coarse)
{
    struct mesh_blend *blend = seeker.blend;
    seek_level(seeker, 1);
    while (blend->count == 0 && seeker.level > finest) {
        seeker.level--;
        seek_level(seeker, 1);
    }
    if (coarse > 0) {
        int fine = blend->count;
        seeker.level++;
        seek_level(seeker, 1);
        if (blend->count == fine)
            coarse = 0;
        blend_share(blend, 0, fine, 1 - coarse, fine ? coarse : 1);
    }
}

void point_mesh_blend(const struct point_mesh *mesh, struct worker *worker,
                      const struct receiver *receiver, struct mesh_blend *blend)
{
    double coarse;
    int finest;
    struct seeker seeker = seeker_new(mesh, worker, receiver, &finest, &coarse);
    seeker.blend = blend;
    blend->count = 0;
    blend->here = false;
    seek_levels(seeker, finest, coarse);
    if (blend->count == 0 && mesh->least > 0) {
        seeker.least = 0;
        seek_levels(seeker, finest, coarse);
    }
    if (blend->count == 0)
        seek_here(&seeker);
}

void point_mesh_want(const struct point_mesh *mesh,
                     const struct receiver *receiver, struct distinct *wanted)
{
    double coarse;
    int finest;
    struct candidates candidates;
    struct seeker seeker = seeker_new(mesh, NULL, receiver, &finest, &coarse);
    for (int more = 0; more <= (coarse > 0); more++, seeker.level++) {
        seek_candidates(&seeker, &candidates);
        for (int i = 0; i < candidates.count; i++) {
            struct lattice_point point =
                point_mesh_shared(mesh, &candidates.at[i].point);
            distinct_add(wanted, lattice_key(&point));
        }
    }
}

/* The corners of a cell, roughly from near to far: those reached from the
 * nearest by steps along axes, the first of which costs least. */
static void nearest_corners(vec3 at, struct lattice_point corner[8])
{
    double t[3] = { at.x - floor(at.x), at.y - floor(at.y),
                    at.z - floor(at.z) };
    int low[3] = { (int)floor(at.x), (int)floor(at.y), (int)floor(at.z) };
    int axis[3] = { 0, 1, 2 };
    for (int i = 1; i < 3; i++)
        for (int j = i;
             j > 0 && fabs(t[axis[j]] - 0.5) < fabs(t[axis[j - 1]] - 0.5);
             j--) {
            int swap = axis[j];
            axis[j] = axis[j - 1];
            axis[j - 1] = swap;
        }
    for (int steps = 0; steps < 8; steps++)
        for (int i = 0; i < 3; i++) {
            int up = t[axis[i]] >= 0.5, step = steps >> i & 1;
            corner[steps].at[axis[i]] = low[axis[i]] + (up ^ step);
        }
}

const void *point_mesh_nearest(const struct point_mesh *mesh,
                               struct worker *worker,
                               const struct receiver *receiver, vec3 jitter)
{
    double coarse;
    struct lattice_point corner[8];
    struct seeker seeker = { .mesh = mesh,
                             .worker = worker,
                             .receiver = receiver };
    vec3 place = receiver->point, normal = receiver->side;
    seeker.level =
        lattice_level(&mesh->lattice, &receiver->view, place, &coarse);
    if (coarse > 0.5)
        seeker.level++;
    double spacing = lattice_spacing(&mesh->lattice, seeker.level);
    vec3 lifted = vec3_along(place, normal, seek_lift * spacing);
    vec3 at = lattice_units(&mesh->lattice, seeker.level, lifted);
    nearest_corners(vec3_add(at, jitter), corner);
    for (int traced = 0; traced < 2; traced++)
        for (int i = 0; i < 8; i++) {
            corner[i].level = seeker.level;
            vec3 from = lattice_place(&mesh->lattice, &corner[i]);
            vec3 offset = vec3_sub(place, from);
            if (-vec3_dot(offset, normal) < nearest_rise * spacing)
                continue;
            if (traced ? seeker_sees(&seeker, &corner[i], from)
                       : obstacles_sight(
                             point_mesh_around(mesh, worker, &corner[i]),
                             offset, normal) == SIGHT_CLEAR)
                return point_mesh_payload(mesh, worker, &corner[i]);
        }
    return NULL;
}
