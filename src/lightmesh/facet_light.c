/* Lamps asked by flat pieces of surface: see facet_light.h. */
#include "lightmesh/facet_light.h"

#include "base/draw.h"
#include "base/memory.h"
#include "base/random.h"
#include "lightmesh/light_tree.h"
#include "lightmesh/tuning.h"

/* Cosine of the angle up to which a normal is the true one. */
static const double untilted = 1 - 1e-9;

/* The lamps in the order of their tree, in which those near each other are
 * neighbours: then the rays of a site, so many lamps apart, go everywhere. */
struct facet_lamps {
    const struct lamps *lamps;
    const struct light_tree *tree;
    size_t count;
    const struct lamp **items;
    float *x, *y, *z, *strength;
    uint32_t *place; /* by number: where in these arrays */
    bool plain;      /* all of them shine alike everywhere */
};

/* Lamps before the surface, or those that stand for clusters: how much light
 * each could give, how many of it there seem to be, its place in the order.
 * Loops over them are without branches, which chance would decide. */
struct facet_picks {
    int count;
    float amount[SURFACE_LAMPS + 1];
    float weight[SURFACE_LAMPS + 1];
    uint32_t place[SURFACE_LAMPS + 1];
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
    own->x[i] = (float)lamp->light->location.x;
    own->y[i] = (float)lamp->light->location.y;
    own->z[i] = (float)lamp->light->location.z;
    own->strength[i] = (float)((fabs(c.r) + fabs(c.g) + fabs(c.b)) / 3);
    own->place[lamp->number] = (uint32_t)i;
    own->plain = own->plain && lamp_plain(lamp);
}

struct facet_lamps *facet_lamps_new(const struct lamps *lamps,
                                    const struct light_tree *tree)
{
    struct facet_lamps *own = memory_new(sizeof *own);
    size_t count = light_tree_count(tree), bytes = count * sizeof(float);
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
 * Of lamps that shine alike everywhere. */
static void plain_amounts(const struct facet_lamps *lamps,
                          const struct facet_site *site, float amount[])
{
    float px = (float)site->place.x, nx = (float)site->normal.x;
    float py = (float)site->place.y, ny = (float)site->normal.y;
    float pz = (float)site->place.z, nz = (float)site->normal.z;
    const float *x = lamps->x, *y = lamps->y, *z = lamps->z;
    for (size_t i = 0; i < lamps->count; i++) {
        float a = x[i] - px, b = y[i] - py, c = z[i] - pz;
        float rise = a * nx + b * ny + c * nz;
        amount[i] = lamps->strength[i] * rise / sqrtf(a * a + b * b + c * c);
    }
}

static float lamp_amount(const struct facet_lamps *lamps,
                         const struct facet_site *site, size_t i)
{
    const struct lamp *lamp = lamps->items[i];
    struct lamp_view view;
    if (!lamp_look(lamp, lamp->light->location, site->place, &view))
        return 0;
    return lamps->strength[i] *
           (float)(view.attenuation * vec3_dot(view.direction, site->normal));
}

static void picks_add(struct facet_picks *picks, size_t place, float weight,
                      float amount)
{
    picks->amount[picks->count] = amount;
    picks->weight[picks->count] = weight;
    picks->place[picks->count] = (uint32_t)place;
    picks->count += amount > 0 && amount < HUGE_VALF;
}

static void picks_find(const struct facet_lamps *lamps,
                       const struct facet_site *site, struct facet_picks *picks)
{
    float amount[SURFACE_LAMPS];
    picks->count = 0;
    if (lamps->count <= SURFACE_LAMPS) {
        plain_amounts(lamps, site, amount);
        for (size_t i = 0; !lamps->plain && i < lamps->count; i++)
            if (!lamp_plain(lamps->items[i]))
                amount[i] = lamp_amount(lamps, site, i);
        for (size_t i = 0; i < lamps->count; i++)
            picks_add(picks, i, 1, amount[i]);
        return;
    }
    struct light_pick clusters[PICKS_MAX];
    int found = light_tree_pick(lamps->tree, site->place, site->dither,
                                PICKS_MAX, clusters);
    for (int i = 0; i < found; i++) {
        float weight = (float)clusters[i].weight;
        size_t place = lamps->place[clusters[i].lamp->number];
        picks_add(picks, place, weight,
                  weight * lamp_amount(lamps, site, place));
    }
}

/* How many amounts are at least `step`, and the sum of the others, in several
 * sums that don't wait for each other. */
static int picks_count(const struct facet_picks *picks, float step, float *rest)
{
    enum { SUMS = 4 };
    float sum[SUMS] = { 0 };
    int certain[SUMS] = { 0 }, i = 0;
    for (; i + SUMS <= picks->count; i += SUMS)
        for (int k = 0; k < SUMS; k++) {
            bool enough = picks->amount[i + k] >= step;
            certain[k] += enough;
            sum[k] += enough ? 0 : picks->amount[i + k];
        }
    for (; i < picks->count; i++) {
        bool enough = picks->amount[i] >= step;
        certain[0] += enough;
        sum[0] += enough ? 0 : picks->amount[i];
    }
    *rest = sum[0] + sum[1] + (sum[2] + sum[3]);
    return certain[0] + certain[1] + certain[2] + certain[3];
}

/* The amount of light for each ray: lamps that could give as much are asked
 * for certain, of the others as many as are left over. 0: all are asked. */
static float picks_step(const struct facet_picks *picks, int budget)
{
    float step = HUGE_VALF;
    int before = -1;
    if (picks->count <= budget)
        return 0;
    for (int round = 0; round < CERTAIN_ROUNDS; round++) {
        float rest;
        int certain = picks_count(picks, step, &rest);
        if (certain >= budget || certain == before)
            break;
        before = certain;
        step = rest / (float)(budget - certain);
    }
    return step;
}

/* Keeps those that are asked: of amounts below `step` one in so many, which
 * then stands for all of them. */
static void picks_draw(struct facet_picks *picks, float step, double dither)
{
    float at = (float)dither, each = step > 0 ? 1 / step : 0;
    int count = picks->count;
    picks->count = 0;
    for (int i = 0; i < count; i++) {
        float amount = picks->amount[i], stands_for = step / amount;
        int certain = amount >= step;
        at += (float)(1 - certain) * amount * each;
        int drawn = at >= 1;
        at -= (float)drawn;
        picks->weight[picks->count] =
            picks->weight[i] * (stands_for > 1 ? stands_for : 1);
        picks->place[picks->count] = picks->place[i];
        picks->count += certain | drawn;
    }
}

/* Where the rays of a site begin: evenly spread, the first at random. */
struct facet_start {
    const struct facet_site *site;
    double a, b;
};

static vec3 start_place(const struct facet_start *start, int number)
{
    double a = start->a, b = start->b;
    draw_further(number, &a, &b);
    if (a + b > 1) {
        a = 1 - a;
        b = 1 - b;
    }
    const struct facet_site *site = start->site;
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

/* The lamp's location, or a point of an area light. */
static vec3 site_sees(const struct lamps *lamps, const struct facet_site *site,
                      const struct lamp *lamp, vec3 place)
{
    if (!lamps_soft(lamps, lamp))
        return lamp->light->location;
    uint64_t key = random_key(site->key, (uint64_t)lamp->number);
    const double u[2] = { random_unit(key), random_unit(key + 1) };
    return lamps_location(lamps, lamp, place, u);
}

/* A lamp that was drawn, and from where it is asked. */
struct facet_question {
    const struct lamp *lamp;
    vec3 place;
    double weight;
};

static void lamp_ask(const struct facet_lamps *lamps, struct worker *worker,
                     const struct facet_site *site,
                     const struct facet_question *asked,
                     struct facet_light *light)
{
    const struct lamp *lamp = asked->lamp;
    struct lamp_target target = { .point = asked->place };
    vec3 location = site_sees(lamps->lamps, site, lamp, asked->place);
    if (!lamp_look(lamp, location, target.point, &target.view) ||
        vec3_dot(target.view.direction, site->normal) <= 0)
        return;
    rgb share = lamps_share_point(lamps->lamps, lamp, worker, &target);
    if (rgb_peak(share) <= 0)
        return;
    rgb c = rgb_scale(rgb_mul(lamp->light->colour, share),
                      target.view.attenuation * asked->weight);
    light_add(light->r, target.view.direction, c.r);
    light_add(light->g, target.view.direction, c.g);
    light_add(light->b, target.view.direction, c.b);
}

void facet_lamps_ask(const struct facet_lamps *lamps, struct worker *worker,
                     const struct facet_site *site, struct facet_light *light)
{
    struct facet_picks picks;
    struct facet_start start = { site, random_unit(site->key),
                                 random_unit(site->key + 1) };
    picks_find(lamps, site, &picks);
    picks_draw(&picks, picks_step(&picks, site->budget), site->dither);
    for (int i = 0; i < picks.count; i++) {
        const struct facet_question asked = { lamps->items[picks.place[i]],
                                              start_place(&start, i),
                                              (double)picks.weight[i] };
        lamp_ask(lamps, worker, site, &asked, light);
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
