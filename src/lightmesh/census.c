/* Mesh points counted before they are made: see census.h.
 *
 * Of C points that are asked for alike n rays find C (1 - exp(-a n)): how many
 * a quarter of the rays found and how many all of them tells C and a, and with
 * these what as many rays as pixels would find. */
#include "lightmesh/census.h"

#include "base/memory.h"
#include "base/warp.h"
#include "lightmesh/facet_mesh.h"
#include "lightmesh/gather_lamps.h"
#include "lightmesh/gather_paint.h"
#include "lightmesh/table.h"
#include "lightmesh/tuning.h"
#include "scene/material.h"
#include "shade/finish.h"
#include "shade/shadow.h"

enum { TALLIES = 2 + BOUNCES_MAX, GATHERED = 2 };

/* Which points were asked for, by mesh: in space, on surfaces, of each bounce.
 */
struct tally {
    const struct census *census;
    struct distinct *wanted; /* TALLIES of them */
    bool seen; /* by what is seen alone, and not by what that gathers */
};

static struct receiver receiver_at(const struct ray *ray,
                                   const struct intersection *at,
                                   struct lattice_view view)
{
    vec3 side = vec3_against(at->face, ray->direction);
    return (struct receiver){ .point = at->point,
                              .side = side,
                              .smooth = side,
                              .normal = side,
                              .from = ray->origin,
                              .at = at,
                              .view = view,
                              .weight = 1 };
}

/* What gather rays that leave a place ask for, bounce by bounce. */
static void tally_gather(struct tally *tally, const struct receiver *from,
                         const struct indirect_mesh *mesh, int bounce,
                         uint64_t key)
{
    const struct census *census = tally->census;
    const struct world *world = mesh->points.world;
    struct draws draws = { key, (uint32_t)bounce };
    struct intersection at;
    double u[2];
    bool lamps = gather_lamps_asks(census->direct);
    if (!mesh->next && !lamps) /* they ask no point */
        return;
    draw_pair(&draws, GATHER_DIRECTION, u);
    struct ray ray = { from->point, warp_lobe(u, from->side, 1) };
    if (!world_closest(world, &ray, surface_offset(ray.origin), RAY_GATHER,
                       &at))
        return;
    struct receiver receiver = receiver_at(&ray, &at, mesh->gather.view);
    if (mesh->next) {
        point_mesh_want(&mesh->next->points, &receiver,
                        &tally->wanted[2 + bounce]);
        tally_gather(tally, &receiver, mesh->next, bounce + 1, key);
    }
    receiver.view.coarser = HIT_LEVELS;
    if (lamps)
        point_mesh_want(&census->direct->points, &receiver, &tally->wanted[0]);
}

/* One place more, of which so much is seen in a mirror, a level coarser, or
 * through glass (who asks there: lighting/mesh_diffuse.c). Returns whether
 * there is one. */
static bool tally_met(struct tally *tally, const struct ray *ray, double share,
                      int coarser, struct intersection *at)
{
    const struct census *census = tally->census;
    const struct indirect_mesh *mesh = census->indirect;
    if (!world_closest(mesh->points.world, ray, surface_offset(ray->origin),
                       RAY_GATHER, at))
        return false;
    struct receiver receiver = receiver_at(ray, at, census->indirect_view);
    receiver.view.coarser += coarser;
    receiver.weight = share;
    point_mesh_want(&mesh->points, &receiver, &tally->wanted[2]);
    return true;
}

static void tally_mirrors(struct tally *tally, const struct ray *ray,
                          const struct surface *surface)
{
    for (int i = 0; i < surface->count; i++) {
        const struct surface_layer *layer = &surface->layer[i];
        double share = rgb_peak(rgb_mul(layer->weight, layer->reflection));
        struct intersection at;
        struct ray mirrored = {
            surface->point,
            surface_mirrored(surface->normal, ray->direction, layer->normal)
        };
        if (share >= gather_least)
            tally_met(tally, &mirrored, share, 1, &at);
    }
}

/* What is seen in mirrors, and straight through what isn't opaque. */
static void tally_beyond(struct tally *tally, const struct ray *ray,
                         struct intersection *at)
{
    const struct gather *gather = &tally->census->indirect->gather;
    struct ray way = *ray;
    double share = 1;
    for (int i = 0; i < CENSUS_PANES && (texture_mirrors(at->texture) ||
                                         !texture_is_opaque(at->texture));
         i++) {
        struct surface surface;
        gather_surface(gather, &way, at, &surface);
        if (i == 0)
            tally_mirrors(tally, &way, &surface);
        share *= rgb_peak(surface_passed(&surface));
        way.origin = at->point;
        if (share < gather_least || !tally_met(tally, &way, share, 0, at))
            return;
    }
}

static void tally_ray(struct tally *tally, double x, double y, uint64_t key)
{
    const struct census *census = tally->census;
    const struct world *world = census->direct->points.world;
    struct ray ray = camera_ray(&census->scene->camera, x, y);
    struct intersection at;
    if (!world_closest(world, &ray, surface_offset(ray.origin), RAY_SIGHT, &at))
        return;
    struct receiver receiver = receiver_at(&ray, &at, census->direct_view);
    bool known =
        census->surfaces &&
        facet_mesh_want(census->direct->facets, &receiver, &tally->wanted[1]);
    if (census->space && !known)
        point_mesh_want(&census->direct->points, &receiver, &tally->wanted[0]);
    if (!census->indirect)
        return;
    receiver.view = census->indirect_view;
    point_mesh_want(&census->indirect->points, &receiver, &tally->wanted[2]);
    if (tally->seen) {
        tally_beyond(tally, &ray, &at);
        return;
    }
    for (uint64_t i = 0; i < GATHERED; i++)
        tally_gather(tally, &receiver, census->indirect, 1, GATHERED * key + i);
}

/* How many points there is room for in a mesh; what stands around them has
 * twice as much. */
static double tally_room(const struct census *census, int number)
{
    const struct indirect_mesh *mesh = census->indirect;
    if (number == 0)
        return (double)table_capacity(census->direct->points.table);
    if (number == 1)
        return census->direct->facets
                   ? (double)table_capacity(
                         census->direct->facets->points.table)
                   : HUGE_VAL;
    for (int i = 2; mesh && i < number; i++)
        mesh = mesh->next;
    return mesh ? (double)table_capacity(mesh->points.table) : HUGE_VAL;
}

/* `few` rays' finds to those of four times as many, `count`, as a power of the
 * number of rays: 1 where each ray finds as much as the first. */
static double tally_exponent(double few, double count)
{
    return few > 0 ? log(count / few) / log(4) : 1;
}

/* What `more` times as many rays find, where a quarter of them found `few`.
 * Far from that many it is only sure that each finds no more than the last. */
static double tally_all(double few, double count, double more)
{
    double low = 1e-9, high = 10;
    if (!(few > 0) || more > census_far)
        return count * pow(more, fmin(tally_exponent(few, count), 1));
    for (int i = 0; i < 60; i++) { /* x = a n / 4 */
        double x = (low + high) / 2;
        bool less = (1 - exp(-4 * x)) / (1 - exp(-x)) < count / few;
        *(less ? &high : &low) = x;
    }
    return few / (1 - exp(-low)) * (1 - exp(-4 * low * more));
}

/* The same where some points are asked for by many rays and others by few, as
 * on a plane to the horizon. With exponent e the last four times as many rays
 * found 4^e times as many: the next are taken to find 4^(e e) times as many,
 * those after them 4^(e e e) times. */
static double tally_uneven(double few, double count, double more)
{
    double e = tally_exponent(few, count);
    double rounds = log(more) / log(4);
    if (!(e > 0))
        return count;
    double sum = e < 1 ? e * e * (1 - pow(e, rounds)) / (1 - e) : rounds;
    return count * pow(4, sum);
}

static double tally_crowding(const struct tally *tally, double rays,
                             const double few[TALLIES])
{
    const struct census *census = tally->census;
    double most = 0, more = fmax(census->pixels / rays, 1);
    for (int i = 0; i < TALLIES; i++) {
        double count = distinct_count(&tally->wanted[i]);
        most =
            fmax(most, tally_all(few[i], count, more) / tally_room(census, i));
    }
    return most;
}

static bool census_stopped(const struct tally *tally)
{
    const atomic_int *stop = tally->census->stop;
    return stop && atomic_load(stop);
}

/* The tally of edge times edge rays; few: of a quarter of them. */
static void census_take(struct tally *tally, int edge, double few[TALLIES])
{
    /* Places with even numbers, and then all others. */
    for (int all = 0; all < 2; all++) {
        for (int i = 0; i < edge * edge && !census_stopped(tally); i++) {
            int column = i % edge, row = i / edge;
            if ((column % 2 == 0 && row % 2 == 0) == !all)
                tally_ray(tally, (column + 0.5) / edge, (row + 0.5) / edge,
                          (uint64_t)i);
        }
        for (int i = 0; !all && i < TALLIES; i++)
            few[i] = distinct_count(&tally->wanted[i]);
    }
}

static double census_by(const struct census *census, int edge)
{
    struct tally tally = { census, memory_new(TALLIES * sizeof *tally.wanted),
                           .seen = false };
    double few[TALLIES];
    census_take(&tally, edge, few);
    double crowding = tally_crowding(&tally, (double)edge * edge, few);
    memory_free(tally.wanted);
    return crowding;
}

double census_gathered(const struct census *census)
{
    struct tally tally = { census, memory_new(TALLIES * sizeof *tally.wanted),
                           .seen = true };
    double few[TALLIES], rays = CENSUS_SEEN_EDGE * CENSUS_SEEN_EDGE;
    census_take(&tally, CENSUS_SEEN_EDGE, few);
    double count = distinct_count(&tally.wanted[2]);
    memory_free(tally.wanted);
    double more = fmin(fmax(census->pixels / rays, 1), census_far);
    return tally_uneven(few[2], count, more);
}

/* By more and more rays, until they are sure. */
double census_crowding(const struct census *census)
{
    double crowding = census_by(census, CENSUS_EDGE);
    for (int edge = 2 * CENSUS_EDGE;
         edge <= CENSUS_FINE_EDGE && crowding >= census_sure; edge *= 2)
        crowding = census_by(census, edge);
    return crowding;
}
