/* Next-event estimation: see direct.h. */
#include "tracer/direct.h"

#include "base/warp.h"
#include "shade/background.h"
#include "shade/finish.h"
#include "shade/shadow.h"
#include "tracer/crossing.h"
#include "tracer/drift.h"

enum {
    LAMPS_ALL = 8,         /* as many are asked every one */
    LAMPS_TRIED = 16,      /* of more, one of these is chosen */
    PANES_MAX = 1000,      /* light goes through */
    SLOT_LAMP = 0,         /* of draws: choosing, */
    SLOT_EMITTER,          /* the same of what glows, */
    SLOT_EMITTER_PLACE,    /* the place on it, */
    SLOT_PLACES = 1 << 16, /* and the place on each lamp */
};

/* One point asking for light. */
struct question {
    const struct tracer *tracer;
    const struct light_set *set;
    struct worker *worker;
    const struct receiver *receiver;
    const struct draws *draws;
};

const struct interiors *receiver_inside(const struct receiver *receiver,
                                        vec3 direction)
{
    bool front = vec3_dot(receiver->normal, direction) >= 0;
    return front ? receiver->inside : receiver->behind;
}

/* Of what happens on the way to a lamp. */
static uint64_t question_key(const struct question *q, int lamp)
{
    uint64_t key = random_key(q->draws->key, q->draws->index);
    return random_key(key, (uint64_t)lamp + 1) | 1;
}

/* Lamps' light goes the way that shadow rays go for POV-Ray: straight through
 * what is transparent. */
static rgb lamp_visibility(const struct question *q, const struct lamp *lamp,
                           const struct lamp_pick *pick)
{
    const struct tracer *tracer = q->tracer;
    const struct scene *scene = tracer->scene;
    bool fog = lamp->light->media_attenuation &&
               tracer->quality >= QUALITY_FOG &&
               (scene->fogs.count > 0 || scene->media.count > 0);
    struct shadow_path path = {
        .point = q->receiver->point,
        .direction = pick->towards,
        .distance = pick->distance,
        .light = lamp->number,
        .inside = q->receiver->inside,
        .fog = fog ? scene : NULL,
        .misty = tracer_misty(tracer),
        .photons = q->receiver->straight || !tracer->photons
                       ? NULL
                       : &lamp->light->photons,
        .key = question_key(q, lamp->number),
    };
    if (lamp->light->shadowless || tracer->quality < QUALITY_SHADOWS)
        return rgb_grey(1);
    return shadow_visibility(tracer->world, q->worker, &path);
}

static bool lamp_look_at(const struct question *q, size_t number,
                         struct lamp_pick *pick)
{
    const struct lamp *lamp = &q->set->lamps[number];
    double u[2] = { 0.5, 0.5 };
    const struct leaf *leaf = q->receiver->leaf;
    if (q->receiver->in_media ? !lamp_is_for_media(lamp, leaf)
                              : leaf && !lamp_is_for(lamp, leaf))
        return false;
    if (lamp->light->area && q->tracer->quality >= QUALITY_AREA_LIGHTS)
        draw_pair(q->draws, SLOT_PLACES + (uint32_t)number, u);
    return light_set_look(lamp, q->receiver->point, u, pick);
}

/* What the receiver makes of a lamp that nothing hides. */
static rgb lamp_unshadowed(const struct question *q, size_t number,
                           const struct lamp_pick *pick)
{
    const struct receiver *receiver = q->receiver;
    const struct light *light = q->set->lamps[number].light;
    rgb share = receiver->response(receiver->context, pick->view.direction,
                                   true, !light->shadowless);
    return rgb_scale(rgb_mul(share, light->colour), pick->view.attenuation);
}

static rgb lamp_light(const struct question *q, size_t number)
{
    struct lamp_pick pick;
    if (!lamp_look_at(q, number, &pick))
        return rgb_grey(0);
    rgb light = lamp_unshadowed(q, number, &pick);
    if (rgb_peak(light) == 0)
        return light;
    return rgb_mul(light, lamp_visibility(q, &q->set->lamps[number], &pick));
}

/* A lamp chosen by brightness, and by what would arrive. */
struct candidate {
    size_t number;
    struct lamp_pick pick;
    rgb light;
};

/* Resampled importance sampling (Talbot, Cline and Egbert 2005): of lamps drawn
 * by brightness one is kept in proportion to what it would give over the
 * chance to be drawn, and stands for the mean of all. */
static rgb lamp_resampled(const struct question *q, double which)
{
    struct candidate kept;
    double sum = 0, choice[2];
    draw_pair(q->draws, SLOT_LAMP, choice);
    for (int i = 0; i < LAMPS_TRIED; i++) {
        struct candidate next;
        double share, part = (i + which) / LAMPS_TRIED;
        next.number = draw_share(q->set->sums, q->set->count, part, &share);
        if (!lamp_look_at(q, next.number, &next.pick) || !(share > 0))
            continue;
        next.light = lamp_unshadowed(q, next.number, &next.pick);
        double weight = rgb_peak(next.light) / share;
        if (!(weight > 0) || !isfinite(weight))
            continue;
        sum += weight;
        /* One number decides all: what is left of it is again uniform. */
        double chance = weight / sum;
        if (choice[1] < chance) {
            kept = next;
            choice[1] /= chance;
        } else {
            choice[1] = (choice[1] - chance) / (1 - chance);
        }
    }
    if (sum == 0)
        return rgb_grey(0);
    double scale = sum / LAMPS_TRIED / rgb_peak(kept.light);
    rgb seen = lamp_visibility(q, &q->set->lamps[kept.number], &kept.pick);
    return rgb_scale(rgb_mul(kept.light, seen), scale);
}

rgb direct_lamps(const struct tracer *tracer, struct worker *worker,
                 const struct receiver *receiver, const struct draws *draws,
                 bool every)
{
    struct question question = { tracer, tracer->lighting_state, worker,
                                 receiver, draws };
    rgb sum = rgb_grey(0);
    size_t count = question.set->count;
    if (count > (every ? LAMPS_ALL : 1))
        return lamp_resampled(&question, draw_unit(draws, SLOT_LAMP));
    for (size_t i = 0; i < count; i++)
        sum = rgb_add(sum, lamp_light(&question, i));
    return sum;
}

double direct_weight(const struct light_set *set, vec3 from, vec3 direction,
                     double density, const struct intersection *at)
{
    return emitters_balance(
        density, emitters_density(set->emitters, from, direction, at));
}

/* Light on its way back from a picked place. */
struct approach {
    struct ray ray;
    struct interiors inside;
    double gone; /* from the receiver */
    rgb share;
};

/* One stretch: false if nothing is met. */
static bool approach_step(struct approach *approach, const struct question *q,
                          struct crossing *crossing)
{
    const struct tracer *tracer = q->tracer;
    q->worker->counters.shadow_rays++;
    if (!world_closest(tracer->world, &approach->ray,
                       surface_offset(approach->ray.origin), RAY_REFLECTION,
                       &crossing->at))
        return false;
    approach->gone += crossing->at.t;
    if (tracer_foggy(tracer, &approach->inside))
        approach->share = rgb_mul(
            approach->share,
            fog_veil(tracer->scene, &approach->ray, crossing->at.t).through);
    approach->share =
        rgb_mul(approach->share,
                drift_through(tracer, q->worker, &approach->ray, crossing->at.t,
                              &approach->inside, question_key(q, -2)));
    crossing_fill(crossing, tracer, approach->ray.direction, &approach->inside,
                  0, true);
    return true;
}

/* Through a pane that doesn't bend: false if the light ends there. What bends
 * is left to the rays that are scattered, which bend too. */
static bool approach_pass(struct approach *approach, const struct question *q,
                          const struct crossing *crossing)
{
    rgb through = crossing->surface.through;
    if (crossing->ior != 1 || rgb_peak(through) == 0 ||
        q->tracer->quality < QUALITY_TRANSPARENCY)
        return false;
    approach->share = rgb_mul(approach->share, through);
    if (crossing->leaving)
        approach->share = rgb_mul(
            approach->share,
            interior_fade(crossing->at.leaf->look->interior, crossing->at.t));
    interiors_copy(&approach->inside, &crossing->beyond);
    approach->ray.origin = crossing->at.point;
    return true;
}

/* Radiance that reaches the point from the picked place (from all of the leaf
 * that the direction meets, if any place counts), with its weight. */
static rgb emitter_seen(const struct question *q,
                        const struct emitter_pick *pick)
{
    const struct receiver *receiver = q->receiver;
    struct approach approach = { .ray = { receiver->point, pick->direction },
                                 .share = { 1, 1, 1 } };
    struct crossing crossing;
    rgb sum = rgb_grey(0);
    double own = receiver->density(receiver->context, pick->direction);
    interiors_copy(&approach.inside,
                   receiver_inside(receiver, pick->direction));
    for (int i = 0; i < PANES_MAX && !worker_stopped(q->worker); i++) {
        if (!approach_step(&approach, q, &crossing))
            break;
        bool anywhere = isinf(pick->distance);
        double slack = 1e-5 * (1 + approach.gone);
        bool there = anywhere || fabs(approach.gone - pick->distance) <= slack;
        if (there && crossing.at.leaf == pick->leaf) {
            double density = emitters_density(q->set->emitters, receiver->point,
                                              pick->direction, &crossing.at);
            rgb glow = rgb_mul(approach.share, surface_glow(&crossing.surface));
            if (density > 0 && isfinite(density))
                sum = rgb_add_scaled(sum, glow, density / (density + own));
        }
        if ((!anywhere && approach.gone > pick->distance - slack) ||
            !approach_pass(&approach, q, &crossing))
            break;
    }
    return sum;
}

rgb direct_emitters(const struct tracer *tracer, struct worker *worker,
                    const struct receiver *receiver, const struct draws *draws)
{
    struct question question = { tracer, tracer->lighting_state, worker,
                                 receiver, draws };
    const struct emitters *emitters = question.set->emitters;
    struct emitter_pick pick;
    double u[2];
    if (!emitters_any(emitters))
        return rgb_grey(0);
    draw_pair(draws, SLOT_EMITTER_PLACE, u);
    if (!emitters_pick(emitters, receiver->point,
                       draw_unit(draws, SLOT_EMITTER), u, &pick))
        return rgb_grey(0);
    rgb share =
        receiver->response(receiver->context, pick.direction, false, false);
    if (rgb_peak(share) == 0)
        return share;
    return rgb_scale(rgb_mul(share, emitter_seen(&question, &pick)),
                     1 / (WARP_PI * pick.density));
}
