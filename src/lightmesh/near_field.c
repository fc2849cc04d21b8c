/* Short rays: see near_field.h. */
#include "lightmesh/near_field.h"

#include "base/memory.h"
#include "base/smooth.h"
#include "base/warp.h"
#include "lightmesh/gather_rays.h"
#include "lightmesh/indirect.h"
#include "lightmesh/near_glow.h"
#include "lightmesh/near_own.h"
#include "lightmesh/tuning.h"
#include "scene/primitive.h"

/* Numbers of its own, apart from those of mesh points. */
static const uint64_t near_key = 0x6e656172;

double near_field_reach_at(const struct indirect_mesh *mesh,
                           const struct receiver *receiver)
{
    return near_field_reach * lattice_spacing_at(&mesh->points.lattice,
                                                 &receiver->view,
                                                 receiver->point);
}

/* What the points around say of a way, as brightness: no less than nothing. */
struct along {
    double light, open;
};

/* A place that looks around. */
struct nearby {
    const struct indirect_mesh *mesh;
    struct gather gather; /* of its rays: no virtual light brings what is so
                           * near */
    struct worker *worker;
    const struct receiver *receiver;
    double reach; /* of its rays: near_field_reach_at */
    const struct near_ways *ways;
    bool dear;                    /* rays to what they meet are */
    struct along all, hidden;     /* sums of what the points say */
    struct indirect_light met;    /* what comes from what was met, */
    struct indirect_share shares; /* and what the side gets of it */
};

static struct along light_along(const struct indirect_light *light, vec3 way)
{
    double basis[HARMONICS];
    struct along along = { 0, 0 };
    harmonics_basis(way, basis);
    for (int i = 0; i < HARMONICS; i++) {
        const struct harmonics *h = &light->light;
        rgb part = { (double)h->r[i], (double)h->g[i], (double)h->b[i] };
        along.light += rgb_brightness(part) * basis[i];
        along.open += (double)light->open[i] * basis[i];
    }
    return (struct along){ fmax(along.light, 0), fmax(along.open, 0) };
}

struct draws near_draws(const struct gather *gather, unsigned number)
{
    return (struct draws){ gather->lamps->seed ^ near_key, number };
}

/* With the rays before they are spread evenly as well, for which so few draws
 * are not enough: multiples of independent irrational numbers (Roberts, as
 * draw_further). */
struct onwards near_onwards_new(const struct gather *gather, int rays)
{
    const struct draws draws = near_draws(gather, 0);
    struct onwards onwards = onwards_new(draws.key, (uint32_t)rays);
    for (int i = 0; i < rays; i++) {
        double u[2] = { 0, 0 };
        draw_further(i + 1, &u[0], &u[1]);
        onwards_set(&onwards, (uint32_t)i, fmod((i + 1) * sqrt(2), 1),
                    warp_lambert(u));
    }
    return onwards;
}

/* A Fermat spiral on the disc below the hemisphere (Vogel 1979): a draw of so
 * few leaves gaps, where what is close is missed by all places alike [truth:
 * ten of these are as good as twelve drawn in nets]. Each packet of them goes
 * all along it. */
struct near_ways near_ways_new(int count)
{
    const double golden = WARP_PI * (3 - sqrt(5));
    const int packets = (count + RAY_LANES - 1) / RAY_LANES;
    struct near_ways ways = { 0,
                              memory_new((size_t)count * sizeof *ways.ways) };
    for (int packet = 0; packet < packets; packet++)
        for (int i = packet; i < count; i += packets) {
            double square = (i + 0.5) / count, radius = sqrt(square);
            ways.ways[ways.count++] =
                vec3_make(radius * cos(i * golden), radius * sin(i * golden),
                          sqrt(1 - square));
        }
    return ways;
}

void near_ways_free(struct near_ways *ways)
{
    memory_free(ways->ways);
}

/* Numbers from `first` on. */
static void nearby_trace(const struct nearby *nearby, int first,
                         struct gather_rays *sent)
{
    const struct receiver *receiver = nearby->receiver;
    const struct gather *gather = &nearby->mesh->gather;
    sent->count = 0;
    for (int i = first; i < nearby->ways->count && sent->count < RAY_LANES;
         i++) {
        const struct draws draws = near_draws(gather, (unsigned)i);
        gather_rays_add(sent, &draws, receiver->point,
                        warp_turned(nearby->ways->ways[i], receiver->side));
    }
    gather_rays_meet(gather, nearby->worker, nearby->reach, sent);
}

bool near_is_dear(const struct leaf *leaf)
{
    return leaf->object->kind == OBJECT_SHAPE &&
           leaf->object->primitive->first_roughly;
}

/* How near that is: what comes into reach does so by and by. */
double near_field_closeness(double distance, double reach)
{
    return fade_out(distance / reach, near_field_whole);
}

/* One of them. Returns how much of it counts as met: of what glows as much as
 * isn't left to mesh points. */
static double nearby_meet(struct nearby *nearby, struct gather_rays *sent,
                          unsigned i)
{
    vec3 way = rays_at(&sent->rays, (int)i).direction;
    double density = vec3_dot(way, nearby->receiver->side) / WARP_PI;
    double count = nearby->ways->count;
    if (!(density > 0) || !sent->found[i].at.leaf)
        return 0;
    const struct gathered_ray *found =
        gather_rays_follow(&nearby->gather, nearby->worker, sent, i);
    double close = near_field_closeness(found->at.t, nearby->reach);
    rgb light = rgb_sub(found->light, found->glow);
    if (rgb_peak(found->glow) > 0)
        close *= near_glow_share(nearby->mesh->near_glow, found->at.leaf,
                                 found->at.t);
    light = rgb_scale(light, close);
    double open = close * found->open;
    indirect_light_add(&nearby->met, way, light, open, density * count);
    nearby->shares.light =
        rgb_add_scaled(nearby->shares.light, light, 1 / count);
    nearby->shares.open += open / count;
    return close;
}

static void nearby_add(struct nearby *nearby, struct gather_rays *sent,
                       const struct indirect_light *light)
{
    for (unsigned i = 0; i < sent->count; i++) {
        struct along along =
            light_along(light, rays_at(&sent->rays, (int)i).direction);
        double hidden = nearby_meet(nearby, sent, i);
        nearby->all.light += along.light;
        nearby->all.open += along.open;
        nearby->hidden.light += hidden * along.light;
        nearby->hidden.open += hidden * along.open;
    }
}

/* How many of them. */
static unsigned nearby_met(const struct gather_rays *sent)
{
    unsigned met = 0;
    for (unsigned i = 0; i < sent->count; i++)
        met += sent->found[i].at.leaf != NULL;
    return met;
}

/* Shapes that functions tell are full of crevices, too. */
static bool nearby_is_dear(const struct gather_rays *sent)
{
    bool dear = false;
    for (unsigned i = 0; i < sent->count && !dear; i++) {
        const struct leaf *leaf = sent->found[i].at.leaf;
        dear = leaf && near_is_dear(leaf);
    }
    return dear;
}

/* A packet from number `first` on. Where a few rays all meet something they
 * don't tell whether any light gets in, which would be seen as steps and as
 * black spots under balls: there as many are sent as from a corner; of more
 * places of a pixel the first has told. Returns how many meet something. */
static unsigned nearby_send(struct nearby *nearby, int first,
                            struct gather_rays *sent)
{
    const struct near_ways *most = &nearby->mesh->near;
    nearby_trace(nearby, first, sent);
    unsigned met = nearby_met(sent);
    if (first > 0 || nearby->ways->count >= most->count || met < sent->count ||
        nearby->ways == &nearby->mesh->near_more)
        return met;
    nearby->ways = most;
    nearby_trace(nearby, first, sent);
    return nearby_met(sent);
}

/* Returns what share of them meets something. */
static double nearby_look_around(struct nearby *nearby,
                                 const struct indirect_light *light)
{
    unsigned any = 0, all = 0;
    for (int first = 0; first < nearby->ways->count; first += RAY_LANES) {
        struct gather_rays sent;
        unsigned met = nearby_send(nearby, first, &sent);
        any += met;
        all += sent.count;
        nearby->dear |= nearby_is_dear(&sent);
        if (any > 0 || first + RAY_LANES < nearby->ways->count)
            nearby_add(nearby, &sent, light);
    }
    return (double)any / all;
}

static double share_left(double hidden, double all)
{
    return all > 0 ? 1 - hidden / all : 1;
}

/* How far the place is in a crevice, 0 to 1: there many of them do. A picture
 * that has many of these has few rays, for the deepest. Edges of chambers,
 * where half of them do, are no crevices: the few rays of a place miss a patch
 * of sun on the floor, and leave dark dashes along them [gallery with a
 * skylight]. */
static double share_deep(const struct indirect_mesh *mesh, double met)
{
    const double open = mesh->near_own.count > RAY_LANES ? near_shallow
                                                         : near_full,
                 from = mesh->gather.close ? near_edge : open;
    return mesh->own_worth *
           fmin(fmax((met - from) / (near_deep - near_shallow), 0), 1);
}

/* There the place gathers itself, for so much of what is known; what glows
 * near by isn't in it. Less gets into a crevice than around it: more is the
 * chance of few rays, seen as beads along the edges of rooms [truth]. */
static void nearby_own(const struct nearby *nearby, double deep,
                       struct indirect_share *share,
                       struct indirect_light *light)
{
    struct indirect_light own;
    struct indirect_share gets = near_own_gather(
        nearby->mesh, nearby->worker, nearby->receiver, light, deep, &own);
    const double known = rgb_brightness(share->light),
                 brought = rgb_brightness(gets.light),
                 part = brought > known ? fmax(known, 0) / brought : 1;
    gets.light = rgb_scale(gets.light, part);
    indirect_light_dim(&own, part, 1);
    indirect_share_mix(share, &gets, deep);
    indirect_light_scale(light, (float)(1 - deep));
    indirect_light_mix(light, &own, (float)deep);
}

struct near_share near_field_share(const struct indirect_mesh *mesh,
                                   struct worker *worker,
                                   const struct receiver *receiver,
                                   const struct near_ways *ways,
                                   const struct indirect_light *glow,
                                   struct indirect_light *light)
{
    struct indirect_light here;
    struct nearby nearby = {
        .mesh = mesh,
        .gather = mesh->gather,
        .worker = worker,
        .receiver = receiver,
        .reach = near_field_reach_at(mesh, receiver),
        .ways = ways,
    };
    nearby.gather.indirect = mesh;
    nearby.gather.here = light;
    if (glow) {
        here = *light;
        indirect_light_mix(&here, glow, 1);
        nearby.gather.here = &here;
    }
    nearby.gather.virtual_lights = NULL;
    nearby.gather.onwards = &mesh->near_onwards;
    const double met = nearby_look_around(&nearby, light);
    if (met > 0)
        indirect_light_dim(light,
                           share_left(nearby.hidden.light, nearby.all.light),
                           share_left(nearby.hidden.open, nearby.all.open));
    struct indirect_share share = indirect_light_share(light, receiver->side);
    share.light = rgb_add(share.light, nearby.shares.light);
    share.open = fmin(share.open + nearby.shares.open, 1);
    if (met > 0)
        indirect_light_mix(light, &nearby.met, 1);
    /* A far side is seen through what it is of: short rays are enough, and
     * those of a screen all meet its other wall. Mirrors have what they show
     * asked for itself by each pixel [a wet street: .6 of the time]. */
    const double deep = share_deep(mesh, met);
    if (deep > 0 && !nearby.dear && receiver->at_first && !receiver->far_side)
        nearby_own(&nearby, deep, &share, light);
    return (struct near_share){ share, met };
}
