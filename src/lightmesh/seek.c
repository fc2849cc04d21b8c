/* How a surface finds the mesh points in space that light it, and how much each
 * of them counts: point_mesh_blend and its kin of point_mesh.h. */
#include <string.h>

#include "base/random.h"
#include "base/smooth.h"
#include "lightmesh/point_mesh.h"
#include "lightmesh/seek_sight.h"
#include "lightmesh/tuning.h"

/* What panes let pass of the light of points. */
struct passed {
    rgb sum; /* by their weights, */
    double weights;
};

/* A surface place that looks for its mesh points. */
struct seeker {
    const struct point_mesh *mesh;
    struct worker *worker;
    const struct receiver *receiver;
    int level, finer;      /* levels that may follow it */
    double least;          /* share of a point that isn't asked, */
    double most;           /* and of one that is known not to see the place */
    struct passed *passed; /* by panes, which hide nothing; NULL: they do */
    struct passed *panes;  /* by those around a gap (seek_panes); NULL: there
                            * is none */
    struct mesh_blend *blend;
};

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
    double hidden; /* weight of those that are known not to see the place */
    struct {
        struct lattice_point point;
        vec3 place;
        double weight;
        bool seen; /* the place sees it */
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
    double least = 0, most = 0;
    for (int i = 0; i < count; i++) {
        least += seeker->least * weights[i].weight;
        most += seeker->most * weights[i].weight;
    }
    candidates->count = 0;
    candidates->hidden = 0;
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
        if (weights[i].weight > most) {
            candidates->hidden += weight;
            continue;
        }
        candidates->at[candidates->count].point = point;
        candidates->at[candidates->count].place = from;
        candidates->at[candidates->count].seen = false;
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

/* Whether the place sees that one of them, maybe through panes. */
static bool seek_finds(struct seeker *seeker,
                       const struct candidates *candidates, int i)
{
    struct passed *passed = seeker->passed;
    vec3 place = candidates->at[i].place;
    double weight = candidates->at[i].weight;
    rgb through;
    if (!passed)
        return seek_sees(seeker->mesh, seeker->worker, seeker->receiver,
                         &candidates->at[i].point, place);
    if (!seek_looks_through(seeker->mesh, seeker->worker, seeker->receiver,
                            place, &through))
        return false;
    passed->sum = rgb_add_scaled(passed->sum, through, weight);
    passed->weights += weight;
    return true;
}

static void seek_take(struct seeker *seeker, const struct lattice_point *point,
                      double weight)
{
    struct mesh_blend *blend = seeker->blend;
    blend->at[blend->count].payload =
        point_mesh_payload(seeker->mesh, seeker->worker, point);
    blend->at[blend->count++].weight = weight;
}

static void seek_seen(struct seeker *seeker, struct candidates *candidates)
{
    for (int i = 0; i < candidates->count; i++) {
        if (!seek_finds(seeker, candidates, i))
            continue;
        candidates->at[i].seen = true;
        seek_take(seeker, &candidates->at[i].point, candidates->at[i].weight);
        if (seeker->mesh->interpolation->single)
            break;
    }
}

/* In a gap within a clear body, as below the clouds of a planet, the few points
 * that chance to be in it would each have a place of its own, with an edge
 * around it. So the fewer there are the more those before the body count, too.
 * Returns the weight of all. */
static double seek_panes(struct seeker *seeker,
                         const struct candidates *candidates, double seen,
                         double all)
{
    struct passed passed = { rgb_grey(seen), seen };
    if (!seeker->panes || !(seen > 0))
        return seen;
    const double few = fade_out(seen / all, seek_few);
    for (int i = 0; i < candidates->count && few > 0; i++) {
        const double weight = few * candidates->at[i].weight;
        rgb through;
        if (candidates->at[i].seen ||
            !seek_looks_out(seeker->mesh, seeker->worker, seeker->receiver,
                            candidates->at[i].place, &through))
            continue;
        seek_take(seeker, &candidates->at[i].point, weight);
        passed.sum = rgb_add_scaled(passed.sum, through, weight);
        passed.weights += weight;
    }
    seeker->panes->sum =
        rgb_add_scaled(seeker->panes->sum, passed.sum, 1 / passed.weights);
    seeker->panes->weights++;
    return passed.weights;
}

static rgb passed_mean(const struct passed *passed)
{
    return passed->weights > 0 ? rgb_scale(passed->sum, 1 / passed->weights)
                               : rgb_grey(1);
}

/* Adds the points of one level, whose weights sum to 1. Returns the share of
 * those that can't see the place. */
static double seek_points(struct seeker *seeker)
{
    struct mesh_blend *blend = seeker->blend;
    struct candidates candidates;
    int first = blend->count;
    double sum = 0, all;
    seek_candidates(seeker, &candidates);
    if (!seek_alike(seeker, &candidates))
        seek_seen(seeker, &candidates);
    all = candidates.hidden;
    for (int i = 0; i < candidates.count; i++)
        all += candidates.at[i].weight;
    for (int i = first; i < blend->count; i++)
        sum += blend->at[i].weight;
    const double taken = seek_panes(seeker, &candidates, sum, all);
    for (int i = first; i < blend->count; i++)
        blend->at[i].weight /= taken;
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
                                      fmax(receiver->weight, seek_worth),
                             .most = 1 };
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

/* In glass, or in a gap behind a pane, too narrow for points, there is about
 * the light that is before it, less what it keeps: few rays of its own would
 * say less. */
static void seek_behind(struct seeker seeker, int finest, double coarse)
{
    struct passed passed = { rgb_grey(0), 0 };
    seeker.passed = &passed;
    seeker.panes = NULL;
    seeker.least = seek_behind_least;
    seeker.most = 1;
    seek_levels(seeker, finest, coarse);
    seeker.blend->through = passed_mean(&passed);
}

void point_mesh_blend(const struct point_mesh *mesh, struct worker *worker,
                      const struct receiver *receiver, struct mesh_blend *blend)
{
    double coarse;
    int finest;
    struct passed panes = { rgb_grey(0), 0 };
    const bool clear = mesh->least > 0 && !world_is_opaque(mesh->world);
    struct seeker seeker = seeker_new(mesh, worker, receiver, &finest, &coarse);
    seeker.blend = blend;
    seeker.panes = clear && !mesh->interpolation->single ? &panes : NULL;
    blend->count = 0;
    blend->here = false;
    seek_levels(seeker, finest, coarse);
    blend->through = passed_mean(&panes);
    if (blend->count == 0 && clear)
        seek_behind(seeker, finest, coarse);
    if (blend->count == 0 && mesh->least > 0) {
        seeker.most = seeker.least;
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
