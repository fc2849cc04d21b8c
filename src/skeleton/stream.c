/* The stream of light along the skeleton: see stream.h. The poster is read as
 * in src/README.md: visibility by rays against the true
 * geometry (A7), lengths at the point and not at its node (A5), the lamp's own
 * law of attenuation (A15). */
#include "skeleton/stream.h"

#include "base/memory.h"
#include "base/random.h"
#include "shade/shadow.h"
#include "shade/surface.h"

enum { LAMPS_ASKED = 128 }; /* of many, at a point */

/* Whatever lets some light pass is no obstacle. */
static bool stream_passes(void *context, const struct ray *ray,
                          const struct world_hit *hit)
{
    (void)context;
    (void)ray;
    (void)hit;
    return false;
}

bool stream_sees(const struct skeleton *skeleton, vec3 from, vec3 to)
{
    vec3 way = vec3_sub(to, from);
    double length = vec3_length(way), margin = 1e-3 * skeleton->voxels->edge;
    struct ray ray = { from, vec3_normalise(way) };
    if (!(length > 2 * margin))
        return true;
    return !world_occluded(skeleton->world,
                           &(struct occlusion){ .ray = &ray,
                                                .tmin = margin,
                                                .tmax = length - margin,
                                                .light = -1,
                                                .filter = stream_passes });
}

/* What the lamp gives to a surface that faces it, if the point sees it. */
static rgb stream_direct(const struct skeleton *skeleton, struct worker *worker,
                         const struct skeleton_lamp *lamp,
                         const struct skeleton_point *point,
                         struct lamp_view *view)
{
    const struct light *light = lamp->lamp->light;
    bool there = lamp_look(lamp->lamp, light->location, point->position, view);
    rgb lit = rgb_scale(light->colour, view->attenuation);
    struct shadow_path path = { .point = point->position,
                                .direction = view->direction,
                                .distance = view->distance,
                                .light = lamp->lamp->number };
    if (!there)
        return rgb_grey(0);
    if (light->shadowless)
        return lit;
    return rgb_mul(lit, shadow_visibility(skeleton->world, worker, &path));
}

uint32_t stream_source(const struct paths *paths, uint32_t node)
{
    while (paths->parent[node] != GRAPH_NONE)
        node = paths->parent[node];
    return node;
}

vec3 stream_start(const struct skeleton *skeleton,
                  const struct skeleton_lamp *lamp, uint32_t source)
{
    return lamp->within ? lamp->lamp->light->location
                        : skeleton->graph->nodes[source].position;
}

/* How much of a lamp's sphere of directions is lit. */
static double lamp_share(const struct lamp *lamp)
{
    double cosine = (lamp->cosine_radius + lamp->cosine_falloff) / 2;
    return lamp->light->kind == LIGHT_SPOT ? (1 - cosine) / 2 : 1;
}

/* What a lamp gives at the end of a way. A lamp that fades does so by the
 * length of the way. One that doesn't, and one that shines in from outside, has
 * its full light in the ball of void where the way begins; beyond it 1/d^2. */
static rgb stream_law(const struct skeleton *skeleton,
                      const struct skeleton_lamp *lamp,
                      const struct stream_way *way)
{
    const struct graph_node *node = &skeleton->graph->nodes[way->source];
    const struct light *light = lamp->lamp->light;
    double share = lamp_share(lamp->lamp) * way->share;
    double length = fmax(way->length, skeleton->voxels->edge);
    double ratio = node->radius / fmax(length, node->radius);
    struct lamp_view view;
    if (lamp->within && lamp->lamp->fades)
        return rgb_scale(light->colour,
                         share * lamp_fading(lamp->lamp, length));
    if (!lamp->within) {
        lamp_look(lamp->lamp, light->location, node->position, &view);
        share = view.attenuation * way->share;
    }
    return rgb_scale(light->colour, share * ratio * ratio);
}

static void stream_add(struct skeleton_light *light, rgb arriving,
                       vec3 direction)
{
    light->arriving = rgb_add(light->arriving, arriving);
    light->stream =
        vec3_along(light->stream, direction, rgb_brightness(arriving));
}

/* What comes to a facing surface by the way from a lamp that isn't seen, and
 * the way; black where no way leads. */
static rgb stream_hidden(const struct skeleton *skeleton,
                         const struct skeleton_lamp *lamp,
                         const struct skeleton_point *point,
                         stream_follow *follow, struct stream_way *way)
{
    *way = (struct stream_way){ 0 };
    if (!lamp->paths || isinf(lamp->paths->distance[point->node]))
        return rgb_grey(0);
    *way = follow(skeleton, lamp, point);
    return stream_law(skeleton, lamp, way);
}

/* A gathering at a point. */
struct gathering {
    const struct skeleton *skeleton;
    struct worker *worker;
    const struct skeleton_point *point;
    stream_follow *follow;
    struct skeleton_light light;
};

/* One lamp, so many times. Light that comes round corners is spread wide: a
 * surface gets (1 + n.d) / 2 of it (A2). */
static void gather_lamp(struct gathering *gathering, size_t number,
                        double times)
{
    const struct skeleton_lamp *lamp = &gathering->skeleton->lamps[number];
    const struct skeleton_point *point = gathering->point;
    struct lamp_view view;
    struct stream_way way;
    rgb direct = stream_direct(gathering->skeleton, gathering->worker, lamp,
                               point, &view);
    if (rgb_peak(direct) > 0) {
        stream_add(&gathering->light, rgb_scale(direct, times), view.direction);
        return;
    }
    if (!gathering->follow)
        return;
    rgb arriving = rgb_scale(stream_hidden(gathering->skeleton, lamp, point,
                                           gathering->follow, &way),
                             times);
    double wrap = (1 + vec3_dot(point->normal, way.direction)) / 2;
    stream_add(&gathering->light, arriving, way.direction);
    gathering->light.indirect =
        rgb_add_scaled(gathering->light.indirect, arriving, wrap);
}

/* About what each lamp gives at its distance, wherever it looks; returns the
 * sum. */
static double lamps_weigh(const struct skeleton *skeleton, vec3 position,
                          float *weights)
{
    float x = (float)position.x, y = (float)position.y, z = (float)position.z;
    double total = 0;
    for (size_t i = 0; i < skeleton->lamp_count; i++) {
        const struct lamp_gist *lamp = &skeleton->gists[i];
        float dx = lamp->x - x, dy = lamp->y - y, dz = lamp->z - z;
        float squares = dx * dx + dy * dy + dz * dz;
        weights[i] = lamp->brightness / (1 + squares * lamp->fading);
    }
    for (size_t i = 0; i < skeleton->lamp_count; i++)
        total += (double)weights[i];
    return total;
}

/* Some lamps for all, chosen in proportion to their weights, each as often as
 * makes up for it. */
static void gather_some(struct gathering *gathering)
{
    const struct skeleton *skeleton = gathering->skeleton;
    const struct skeleton_point *point = gathering->point;
    float *weights = memory_new(skeleton->lamp_count * sizeof *weights);
    double total = lamps_weigh(skeleton, point->position, weights), before = 0;
    double step = total / LAMPS_ASKED;
    double next = step * random_unit(random_key(skeleton->seed, point->node));
    for (size_t i = 0; i < skeleton->lamp_count && total > 0; i++) {
        double weight = (double)weights[i];
        int draws = 0;
        for (; next < before + weight; next += step)
            draws++;
        if (draws > 0)
            gather_lamp(gathering, i, draws * step / weight);
        before += weight;
    }
    memory_free(weights);
}

struct skeleton_light stream_gather(const struct skeleton *skeleton,
                                    struct worker *worker,
                                    const struct skeleton_point *point,
                                    stream_follow *follow)
{
    struct gathering gathering = { skeleton, worker, point, follow, { { 0 } } };
    if (skeleton->lamp_count > LAMPS_ASKED)
        gather_some(&gathering);
    else
        for (size_t i = 0; i < skeleton->lamp_count; i++)
            gather_lamp(&gathering, i, 1);
    return gathering.light;
}

/* Towards the way ahead, as far as the ball of void is wide. */
static vec3 forward_direction(const struct skeleton *skeleton,
                              const struct skeleton_lamp *lamp,
                              const struct skeleton_point *point)
{
    const struct graph_node *nodes = skeleton->graph->nodes;
    const struct paths *paths = lamp->paths;
    uint32_t ahead = point->node;
    double radius = nodes[ahead].radius;
    while (paths->parent[ahead] != GRAPH_NONE &&
           (double)(paths->distance[point->node] - paths->distance[ahead]) <
               radius)
        ahead = paths->parent[ahead];
    vec3 to = nodes[ahead].position, from = nodes[point->node].position;
    if (paths->parent[ahead] == GRAPH_NONE) {
        to = stream_start(skeleton, lamp, ahead);
        from = point->position;
    }
    return vec3_normalise(vec3_sub(to, from));
}

struct stream_way stream_forward(const struct skeleton *skeleton,
                                 const struct skeleton_lamp *lamp,
                                 const struct skeleton_point *point)
{
    const struct graph_node *nodes = skeleton->graph->nodes;
    const struct paths *paths = lamp->paths;
    uint32_t source = stream_source(paths, point->node);
    vec3 start = stream_start(skeleton, lamp, source);
    double narrow = (double)paths->narrow[point->node];
    double first = vec3_length(vec3_sub(start, nodes[source].position));
    double last =
        vec3_length(vec3_sub(point->position, nodes[point->node].position));
    return (struct stream_way){
        .length = first + (double)paths->distance[point->node] + last,
        .share = narrow * narrow,
        .source = source,
        .direction = forward_direction(skeleton, lamp, point),
    };
}
