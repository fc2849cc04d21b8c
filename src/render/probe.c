/* Light at points: see probe.h. A method that lights surfaces is asked about a
 * small white one at the point. */
#include "render/probe.h"

#include "base/memory.h"
#include "base/parallel.h"
#include "render/workers.h"
#include "scene/photon.h"
#include "shade/shadow.h"
#include "tracer/crossing.h"
#include "tracer/integrator.h"

enum { PROBE_CHUNK = 16 }; /* points a thread takes at a time */

/* What all the small white surfaces share. */
struct plate {
    struct object object;
    struct pigment pigment;
    struct finish finish;
    struct layer layer;
    struct texture texture;
    struct leaf_look looks[2];
    struct leaf one_sided, two_sided;
};

struct probing {
    const struct tracer *tracer;
    const struct render_options *options;
    const struct probe_point *points;
    size_t count;
    struct probe_light *light;
    struct plate plate;
    struct worker *workers;
    atomic_size_t done;
};

static void plate_init(struct plate *plate)
{
    plate->pigment = (struct pigment){ .colour = { .r = 1, .g = 1, .b = 1 } };
    plate->finish = finish_default();
    plate->finish.ambient = rgb_grey(0);
    plate->finish.diffuse = 1;
    plate->layer = (struct layer){ &plate->pigment, NULL, &plate->finish };
    plate->texture = (struct texture){ &plate->layer, 1 };
    plate->looks[0] = (struct leaf_look){
        .photons = &photon_flags_default,
        .texture = &plate->texture,
        .to_texture = &affine_unmoved,
        .from_texture = &affine_unmoved,
        .opaque = true,
        .looks_like = -1,
    };
    plate->looks[1] = plate->looks[0];
    plate->looks[1].double_illuminate = true;
    plate->one_sided = (struct leaf){ .object = &plate->object,
                                      .pose = &pose_unmoved,
                                      .look = &plate->looks[0] };
    plate->two_sided = plate->one_sided;
    plate->two_sided.look = &plate->looks[1];
}

/* One question: a surface with all that it points to. */
struct probe_question {
    struct interiors inside;
    struct intersection at;
    struct surface surface;
    rgb light; /* of lamps, gathered */
};

/* A point lies on a surface, or a hair beside it: what it is inside of is seen
 * a little above. */
static void question_init(struct probe_question *q, const struct probing *all,
                          const struct leaf *leaf, vec3 place, vec3 normal)
{
    vec3 above = vec3_along(place, normal, surface_offset(place));
    tracer_inside(all->tracer, above, &q->inside);
    q->at = (struct intersection){ .t = 0,
                                   .point = place,
                                   .normal = normal,
                                   .face = normal,
                                   .leaf = leaf, /* none of the world */
                                   .part = -1,
                                   .texture = leaf->look->texture,
                                   .to_texture = leaf->look->to_texture,
                                   .from_texture = leaf->look->from_texture };
    q->surface.at = &q->at;
    q->surface.place = NULL;
    q->surface.unmirrored = false;
    q->surface.point = place;
    q->surface.view = normal;
    q->surface.inside = &q->inside;
    q->surface.normal = normal;
    q->surface.side = normal;
    q->surface.weight = 1;
    q->surface.count = 1;
    q->surface.layer[0] = (struct surface_layer){
        .finish = leaf->look->texture->layers[0].finish,
        .pigment = { .r = 1, .g = 1, .b = 1 },
        .normal = normal,
        .weight = rgb_grey(1),
    };
    q->surface.through = rgb_grey(0);
    q->light = rgb_grey(0);
}

static void question_cosine(void *context, const struct light_sample *sample)
{
    struct probe_question *q = context;
    double cosine = vec3_dot(sample->direction, q->surface.normal);
    if (cosine > 0 && !sample->diffused)
        q->light = rgb_add(q->light, rgb_scale(sample->colour, cosine));
}

static void question_plain(void *context, const struct light_sample *sample)
{
    struct probe_question *q = context;
    if (!sample->diffused)
        q->light = rgb_add(q->light, sample->colour);
}

static void question_nothing(void *context, const struct light_sample *sample)
{
    (void)context;
    (void)sample;
}

/* Light without a direction, for a surface of this normal. */
static rgb probe_ask(const struct probing *all, struct worker *worker,
                     struct probe_question *q, light_visit *visit)
{
    const struct tracer *tracer = all->tracer;
    return tracer->lighting
        ->illuminate(tracer->lighting_state, worker, &q->surface, visit, q)
        .irradiance;
}

static rgb probe_irradiance(const struct probing *all, struct worker *worker,
                            const struct probe_point *point)
{
    struct probe_question q;
    question_init(&q, all, &all->plate.one_sided, point->place,
                  vec3_normalise(point->normal));
    rgb diffuse = probe_ask(all, worker, &q, question_cosine);
    return rgb_add(q.light, diffuse);
}

/* Lamps as they are; for the rest, four times the mean irradiance over all
 * normals, of which six stand for all: exact for light that changes as slowly
 * with direction as what has no direction in it does. */
static rgb probe_field(const struct probing *all, struct worker *worker,
                       const struct probe_point *point)
{
    static const vec3 normals[] = { { 1, 0, 0 },  { -1, 0, 0 }, { 0, 1, 0 },
                                    { 0, -1, 0 }, { 0, 0, 1 },  { 0, 0, -1 } };
    const size_t count = sizeof normals / sizeof *normals;
    struct probe_question q;
    question_init(&q, all, &all->plate.two_sided, point->place, normals[2]);
    probe_ask(all, worker, &q, question_plain);
    rgb lamps = q.light, mean = rgb_grey(0);
    for (size_t i = 0; i < count; i++) {
        question_init(&q, all, &all->plate.one_sided, point->place, normals[i]);
        rgb diffuse = probe_ask(all, worker, &q, question_nothing);
        mean = rgb_add(mean, rgb_scale(diffuse, 1.0 / (double)count));
    }
    return rgb_add(lamps, rgb_scale(mean, 4));
}

/* By whole paths. */
static rgb probe_paths(const struct probing *all, struct worker *worker,
                       const struct probe_point *point)
{
    vec3 normal = vec3_normalise(point->normal);
    return integrator_for(all->tracer->lighting)
        ->irradiance(
            all->tracer, worker, point->place, point->directed ? &normal : NULL,
            (unsigned)all->options->samples, (uint64_t)all->options->seed)
        .mean;
}

static struct probe_light probe_point(const struct probing *all,
                                      struct worker *worker,
                                      const struct probe_point *point)
{
    const struct lighting *lighting = all->tracer->lighting;
    struct probe_light light = { .streams = lighting->stream };
    if (!lighting->illuminate)
        light.colour = probe_paths(all, worker, point);
    else if (point->directed)
        light.colour = probe_irradiance(all, worker, point);
    else
        light.colour = probe_field(all, worker, point);
    if (lighting->stream) {
        vec3 normal = vec3_make(0, 0, 0);
        if (point->directed)
            normal = vec3_normalise(point->normal);
        light.stream = lighting->stream(all->tracer->lighting_state, worker,
                                        point->place, normal);
    }
    return light;
}

static void probe_chunk(void *context, size_t item, unsigned thread)
{
    struct probing *all = context;
    struct worker *worker = &all->workers[thread];
    size_t end = (item + 1) * PROBE_CHUNK;
    if (end > all->count)
        end = all->count;
    for (size_t i = item * PROBE_CHUNK; i < end; i++) {
        if (worker_stopped(worker))
            return;
        all->light[i] = probe_point(all, worker, &all->points[i]);
        arena_reset(worker->scratch);
    }
    size_t done = atomic_fetch_add(&all->done, end - item * PROBE_CHUNK) + end -
                  item * PROBE_CHUNK;
    if (all->options->progress)
        all->options->progress(all->options->progress_context,
                               (double)done / (double)all->count);
}

bool probe_run(const struct tracer *tracer,
               const struct render_options *options,
               const struct probe_point *points, size_t count,
               struct probe_light *light, struct render_stats *stats)
{
    unsigned threads = options->threads ? options->threads : 1;
    struct probing *all = memory_new(sizeof *all);
    all->tracer = tracer;
    all->options = options;
    all->points = points;
    all->count = count;
    all->light = light;
    all->workers = memory_new(threads * sizeof *all->workers);
    for (unsigned i = 0; i < threads; i++)
        worker_start(&all->workers[i], i, options->stop);
    plate_init(&all->plate);
    bool done = parallel_run(threads, (count + PROBE_CHUNK - 1) / PROBE_CHUNK,
                             options->stop, probe_chunk, all);
    done = done && !(options->stop && atomic_load(options->stop));
    if (stats)
        *stats = (struct render_stats){ 0 };
    for (unsigned i = 0; i < threads; i++)
        worker_end(&all->workers[i], stats);
    memory_free(all->workers);
    memory_free(all);
    return done;
}
