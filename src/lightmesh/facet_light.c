/* Lamps asked by flat pieces of surface: see facet_light.h. */
#include "lightmesh/facet_light.h"

#include "base/memory.h"
#include "base/random.h"
#include "lightmesh/light_tree.h"

/* Of more lamps than this a site considers clusters only. */
enum { ALL_LAMPS = 1024, CLUSTERS = PICKS_MAX };

/* How often the lamps that are asked for certain are counted again. */
enum { CERTAIN_ROUNDS = 4 };

/* Cosine of the angle up to which a normal is the true one. */
static const double untilted = 1 - 1e-9;

/* The lamps in the order of their tree, in which those near each other are
 * neighbours: then the rays of a site, so many lamps apart, go everywhere. */
struct facet_lamps {
    const struct lamps *lamps;
    const struct light_tree *tree;
    size_t count;
    const struct lamp **items;
    double *x, *y, *z, *strength;
    uint32_t *place; /* by number: where in these arrays */
    bool plain;      /* all of them shine alike everywhere */
};

/* A lamp, or one that stands for a cluster, before the surface. */
struct facet_pick {
    const struct lamp *lamp;
    double weight; /* how many of it there seem to be */
    double amount; /* of light that it could give */
};

static bool lamp_plain(const struct lamp *lamp)
{
    return lamp->light->kind == LIGHT_POINT && !lamp->fades &&
           !lamp_is_parallel(lamp);
}

static void lamps_take(struct facet_lamps *own, size_t i,
                       const struct lamp *lamp)
{
    rgb c = lamp->light->colour;
    own->items[i] = lamp;
    own->x[i] = lamp->light->location.x;
    own->y[i] = lamp->light->location.y;
    own->z[i] = lamp->light->location.z;
    own->strength[i] = (fabs(c.r) + fabs(c.g) + fabs(c.b)) / 3;
    own->place[lamp->number] = (uint32_t)i;
    own->plain = own->plain && lamp_plain(lamp);
}

struct facet_lamps *facet_lamps_new(const struct lamps *lamps,
                                    const struct light_tree *tree)
{
    struct facet_lamps *own = memory_new(sizeof *own);
    size_t count = light_tree_count(tree), bytes = count * sizeof(double);
    *own = (struct facet_lamps){
        .lamps = lamps,
        .tree = tree,
        .count = count,
        .items = memory_new(count * sizeof *own->items),
        .x = memory_new(bytes),
        .y = memory_new(bytes),
        .z = memory_new(bytes),
        .strength = memory_new(bytes),
        .place = memory_new(lamps->count * sizeof *own->place),
        .plain = true,
    };
    for (size_t i = 0; i < count; i++)
        lamps_take(own, i, light_tree_lamp(tree, i));
    return own;
}

void facet_lamps_free(struct facet_lamps *lamps)
{
    if (!lamps)
        return;
    memory_free(lamps->items);
    memory_free(lamps->x);
    memory_free(lamps->y);
    memory_free(lamps->z);
    memory_free(lamps->strength);
    memory_free(lamps->place);
    memory_free(lamps);
}

/* The light that lamps would give if nothing stood between; not above 0: none.
 * Without branches, of lamps that shine alike everywhere. */
static void plain_amounts(const struct facet_lamps *lamps,
                          const struct facet_site *site, size_t first,
                          size_t count, double amount[])
{
    vec3 p = site->place, n = site->normal;
    const double *x = lamps->x + first, *y = lamps->y + first;
    const double *z = lamps->z + first, *strength = lamps->strength + first;
    for (size_t i = 0; i < count; i++) {
        double a = x[i] - p.x, b = y[i] - p.y, c = z[i] - p.z;
        double rise = a * n.x + b * n.y + c * n.z;
        amount[i] = strength[i] * rise / sqrt(a * a + b * b + c * c);
    }
}

static double lamp_amount(const struct facet_lamps *lamps,
                          const struct facet_site *site, size_t i)
{
    const struct lamp *lamp = lamps->items[i];
    struct lamp_view view;
    if (!lamp_look(lamp, lamp->light->location, site->place, &view))
        return 0;
    return lamps->strength[i] * view.attenuation *
           vec3_dot(view.direction, site->normal);
}

static void picks_add(struct facet_pick picks[], int *count,
                      const struct lamp *lamp, double weight, double amount)
{
    picks[*count] = (struct facet_pick){ lamp, weight, amount };
    *count += amount > 0 && amount < HUGE_VAL;
}

/* At most ALL_LAMPS, and room for one more. */
static int picks_find(const struct facet_lamps *lamps,
                      const struct facet_site *site, struct facet_pick picks[])
{
    double amount[ALL_LAMPS];
    int count = 0;
    if (lamps->count <= ALL_LAMPS) {
        plain_amounts(lamps, site, 0, lamps->count, amount);
        for (size_t i = 0; !lamps->plain && i < lamps->count; i++)
            if (!lamp_plain(lamps->items[i]))
                amount[i] = lamp_amount(lamps, site, i);
        for (size_t i = 0; i < lamps->count; i++)
            picks_add(picks, &count, lamps->items[i], 1, amount[i]);
        return count;
    }
    struct light_pick clusters[CLUSTERS];
    int found = light_tree_pick(lamps->tree, site->place, site->dither,
                                CLUSTERS, clusters);
    for (int i = 0; i < found; i++) {
        const struct lamp *lamp = clusters[i].lamp;
        double weight = clusters[i].weight;
        picks_add(picks, &count, lamp, weight,
                  weight *
                      lamp_amount(lamps, site, lamps->place[lamp->number]));
    }
    return count;
}

/* The amount of light for each ray: lamps that could give as much are asked
 * for certain, of the others as many as are left over. */
static double picks_step(const struct facet_pick picks[], int count, int budget)
{
    double step = 0;
    int before = -1;
    for (int round = 0; count > budget && round < CERTAIN_ROUNDS; round++) {
        double rest = 0;
        int certain = 0;
        for (int i = 0; i < count; i++)
            if (step > 0 && picks[i].amount >= step)
                certain++;
            else
                rest += picks[i].amount;
        if (certain >= budget || certain == before)
            break;
        before = certain;
        step = rest / (budget - certain);
    }
    return step;
}

/* Where ray `number` of a site begins: a sequence that fills the plane evenly
 * (Roberts 2018), begun at random. */
static vec3 site_place(const struct facet_site *site, int number)
{
    double a = random_unit(site->key) + number * 0.7548776662466927;
    double b = random_unit(site->key + 1) + number * 0.5698402909980532;
    a -= floor(a);
    b -= floor(b);
    if (a + b > 1) {
        a = 1 - a;
        b = 1 - b;
    }
    vec3 place = vec3_along(site->place, site->edge[0], a - 1 / 3.0);
    return vec3_along(place, site->edge[1], b - 1 / 3.0);
}

static void light_add(float sum[4], vec3 direction, double light)
{
    sum[0] += (float)(direction.x * light);
    sum[1] += (float)(direction.y * light);
    sum[2] += (float)(direction.z * light);
    sum[3] += (float)light;
}

static void pick_ask(const struct facet_lamps *lamps, struct worker *worker,
                     const struct facet_site *site,
                     const struct facet_pick *pick, int number, double weight,
                     struct facet_light *light)
{
    const struct lamp *lamp = pick->lamp;
    uint64_t key = random_key(site->key, (uint64_t)lamp->number);
    const double u[2] = { random_unit(key), random_unit(key + 1) };
    struct lamp_target target = { .point = site_place(site, number) };
    vec3 location = lamps_location(lamps->lamps, lamp, target.point, u);
    if (!lamp_look(lamp, location, target.point, &target.view) ||
        vec3_dot(target.view.direction, site->normal) <= 0)
        return;
    rgb share = lamps_share_point(lamps->lamps, lamp, worker, &target);
    if (rgb_peak(share) <= 0)
        return;
    rgb c = rgb_scale(rgb_mul(lamp->light->colour, share),
                      target.view.attenuation * weight);
    light_add(light->r, target.view.direction, c.r);
    light_add(light->g, target.view.direction, c.g);
    light_add(light->b, target.view.direction, c.b);
}

void facet_lamps_ask(const struct facet_lamps *lamps, struct worker *worker,
                     const struct facet_site *site, struct facet_light *light)
{
    struct facet_pick picks[ALL_LAMPS + 1];
    int count = picks_find(lamps, site, picks);
    double step = picks_step(picks, count, site->budget), at = site->dither;
    for (int i = 0; i < count; i++) {
        double weight = picks[i].weight;
        if (picks[i].amount < step) {
            at += picks[i].amount / step;
            if (at < 1)
                continue;
            at -= 1;
            weight *= step / picks[i].amount;
        }
        pick_ask(lamps, worker, site, &picks[i], i, weight, light);
    }
}

void facet_light_mix(struct facet_light *sum, const struct facet_light *from,
                     double weight)
{
    for (int i = 0; i < 4; i++) {
        sum->r[i] += (float)weight * from->r[i];
        sum->g[i] += (float)weight * from->g[i];
        sum->b[i] += (float)weight * from->b[i];
    }
}

rgb facet_light_total(const struct facet_light *light)
{
    return rgb_make((double)light->r[3], (double)light->g[3],
                    (double)light->b[3]);
}

double facet_light_amount(const struct facet_light *light)
{
    return (double)(light->r[3] + light->g[3] + light->b[3]);
}

/* A directed part and one from all of the hemisphere, whose vector is half as
 * long as its sum: so much light on a surface tilted from `side`. */
static double light_tilted(const float light[4], vec3 side, vec3 normal,
                           double brilliance)
{
    vec3 vector = { (double)light[0], (double)light[1], (double)light[2] };
    double total = (double)light[3], length = vec3_length(vector);
    double around = fmin(fmax(2 * (total - length), 0), total);
    double cosine = length > 0 ? fmax(vec3_dot(vector, normal) / length, 0) : 0;
    double directed = brilliance == 1 ? cosine : pow(cosine, brilliance);
    return (total - around) * directed +
           around / (brilliance + 1) * (1 + vec3_dot(side, normal)) / 2;
}

static double light_on(const float light[4], vec3 side, vec3 normal,
                       double brilliance)
{
    vec3 vector = { (double)light[0], (double)light[1], (double)light[2] };
    double exact = fmax(vec3_dot(vector, side), 0);
    if (brilliance != 1)
        return light_tilted(light, side, normal, brilliance);
    if (vec3_dot(side, normal) > untilted)
        return exact;
    double straight = light_tilted(light, side, side, 1);
    if (!(straight > 0))
        return 0;
    return exact * light_tilted(light, side, normal, 1) / straight;
}

rgb facet_light_irradiance(const struct facet_light *light, vec3 side,
                           vec3 normal, double brilliance)
{
    return rgb_make(light_on(light->r, side, normal, brilliance),
                    light_on(light->g, side, normal, brilliance),
                    light_on(light->b, side, normal, brilliance));
}

vec3 facet_light_direction(const struct facet_light *light, rgb *from_there)
{
    vec3 r = { (double)light->r[0], (double)light->r[1], (double)light->r[2] };
    vec3 g = { (double)light->g[0], (double)light->g[1], (double)light->g[2] };
    vec3 b = { (double)light->b[0], (double)light->b[1], (double)light->b[2] };
    vec3 direction = vec3_normalise(vec3_add(r, vec3_add(g, b)));
    *from_there = rgb_make(fmax(vec3_dot(r, direction), 0),
                           fmax(vec3_dot(g, direction), 0),
                           fmax(vec3_dot(b, direction), 0));
    return direction;
}
