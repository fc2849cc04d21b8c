/* Packets of a wavefront: what their rays meet, side by side as far as it goes.
 * See wavefront.h. */
#include <string.h>

#include "shade/facets.h"
#include "shade/shadow.h"
#include "tracer/wavefront.h"

enum { PACKET_LEAST = 3 }; /* rays; fewer are quicker one by one */

/* Rays as what they meet is worked out. Bits stand for rays. */
struct sights {
    struct wavefront *wavefront;
    const struct rays *rays;
    const struct world_hit *hits;
    unsigned count;
    const struct picture_place *places; /* of the camera's, if all have one */
    struct radiance *out;               /* likewise */
    struct path *path[WORLD_RAYS];      /* NULL: a camera's that is plain, came
                                         * through nothing and hasn't gone on */
    struct world_faces faces;
    struct facets facets;
    unsigned plain; /* meet a leaf that is: painted and lit without more */
    unsigned lit;   /* the others that meet a surface to be lit */
    struct crossing crossing[WORLD_RAYS];
    struct veil sky[WORLD_RAYS]; /* of those that meet nothing */
    unsigned foggy;              /* go through fog: */
    struct veil fog[WORLD_RAYS];
};

static void sight_describe(struct sights *sights, unsigned i)
{
    const struct ray ray = rays_at(sights->rays, (int)i);
    world_describe_face(&ray, sights->hits[i].leaf, &sights->faces, i,
                        &sights->crossing[i].at);
}

static const struct picture_place *sight_place(const struct sights *sights,
                                               unsigned i)
{
    return sights->places ? &sights->places[i] : NULL;
}

static const struct interiors *sight_inside(const struct sights *sights,
                                            unsigned i)
{
    const struct path *path = sights->path[i];
    return path ? &path->inside : &sights->wavefront->tracer->start;
}

static double sight_worth(const struct sights *sights, unsigned i)
{
    return sights->path[i] ? sights->path[i]->weight : 1;
}

/* That of a plain leaf, which was painted without. */
static const struct surface *sights_surface(void *context, unsigned i)
{
    struct sights *sights = context;
    const struct tracer *tracer = sights->wavefront->tracer;
    const struct path *path = sights->path[i];
    struct crossing *crossing = &sights->crossing[i];
    sight_describe(sights, i);
    crossing_fill(crossing, tracer, rays_direction(sights->rays, (int)i),
                  sight_inside(sights, i), tracer->scene->settings.adc_bailout,
                  false);
    crossing->surface.place = path ? path->place : sight_place(sights, i);
    crossing->surface.unmirrored = !path || path->straight;
    crossing->surface.weight = sight_worth(sights, i);
    return &crossing->surface;
}

static void sights_paint(struct sights *sights)
{
    if (sights->plain)
        facets_paint(&sights->facets, sights->hits, sights->plain);
    for (unsigned each = sights->plain; each; each &= each - 1) {
        unsigned i = (unsigned)__builtin_ctz(each);
        const struct path *path = sights->path[i];
        sights->facets.place[i] = path ? path->place : sight_place(sights, i);
        sights->facets.unmirrored[i] = !path || path->straight;
        sights->facets.inside[i] = sight_inside(sights, i);
        sights->facets.worth[i] = sight_worth(sights, i);
    }
}

/* A ray of the camera sets out on what is not plain. */
static struct path *sights_start(struct sights *sights, unsigned i)
{
    struct path *path = wavefront_root(sights->wavefront, &sights->out[i]);
    path->ray = rays_at(sights->rays, (int)i);
    path_start(path, sight_place(sights, i));
    return path;
}

/* All those of `seen`: to what they meet, the others to where there is no more
 * fog. */
static void sights_fog(struct sights *sights, unsigned seen, unsigned meet)
{
    const struct tracer *tracer = sights->wavefront->tracer;
    double distances[WORLD_RAYS];
    for (unsigned each = seen; each; each &= each - 1) {
        unsigned i = (unsigned)__builtin_ctz(each);
        distances[i] =
            meet >> i & 1 ? sights->faces.hit[i].t : (double)INFINITY;
        sights->foggy |= (unsigned)tracer_foggy(tracer, sight_inside(sights, i))
                         << i;
    }
    if (sights->foggy)
        fog_veils(tracer->scene, sights->rays, sights->foggy, distances,
                  sights->fog);
}

static const struct veil *sight_fog(const struct sights *sights, unsigned i)
{
    return sights->foggy >> i & 1 ? &sights->fog[i] : NULL;
}

/* To plain leaves. */
static void sights_air(struct sights *sights)
{
    for (unsigned plain = sights->plain; plain; plain &= plain - 1) {
        unsigned i = (unsigned)__builtin_ctz(plain);
        if (!sights->path[i])
            sights->path[i] = sights_start(sights, i);
        path_air(sights->path[i], sights->faces.hit[i].t, sights->hits[i].leaf,
                 sight_fog(sights, i));
    }
}

/* What is met, and which leaves are plain. Returns which meet any. */
static unsigned sights_meet(struct sights *sights, unsigned seen)
{
    const struct tracer *tracer = sights->wavefront->tracer;
    unsigned meet = 0;
    sights->plain = sights->lit = sights->foggy = 0;
    for (unsigned i = 0; i < sights->count; i++) {
        const struct leaf *leaf = sights->hits[i].leaf;
        meet |= (unsigned)(leaf != NULL) << i;
        sights->plain |= (unsigned)(leaf && leaf->look->plain) << i;
    }
    meet &= seen;
    sights->plain &= tracer->painted ? seen : 0;
    if (meet)
        world_face_many(sights->rays, sights->hits, meet, &sights->faces);
    if (tracer->scene->fogs.count > 0)
        sights_fog(sights, seen, meet);
    if (!meet)
        return 0;
    facets_start(&sights->facets, sights->rays, &sights->faces);
    sights->facets.bailout = tracer->scene->settings.adc_bailout;
    sights->facets.tell = sights_surface;
    sights->facets.context = sights;
    if (!tracer->airless)
        sights_air(sights);
    sights_paint(sights);
    return meet;
}

/* What of the sky those see that meet nothing. */
static void sights_sky(struct sights *sights, unsigned missed)
{
    struct spots directions = { .count = 0 };
    struct veil veils[SPOTS_MAX];
    for (unsigned each = missed; each; each &= each - 1)
        spots_add(&directions,
                  rays_direction(sights->rays, __builtin_ctz(each)));
    sky_veils(sights->wavefront->tracer->scene, &directions, veils);
    for (int k = 0; missed; missed &= missed - 1)
        sights->sky[__builtin_ctz(missed)] = veils[k++];
}

/* Past all surfaces. Rays of the camera with nothing on their way need not set
 * out for that; returns the others. */
static unsigned sights_miss(struct sights *sights, unsigned missed)
{
    const struct tracer *tracer = sights->wavefront->tracer;
    unsigned left = 0;
    if (missed)
        sights_sky(sights, missed);
    for (; missed; missed &= missed - 1) {
        unsigned i = (unsigned)__builtin_ctz(missed);
        double clear;
        if (sights->path[i] || !tracer->airless) {
            left |= 1u << i;
            continue;
        }
        rgb light = tracer_beyond(tracer, &sights->sky[i], true, &clear);
        sights->out[i] = (struct radiance){ light, 1 - clear };
        sights->wavefront->worker->counters.camera_rays++;
    }
    return left;
}

/* To the surfaces of leaves that are not plain; some end there. */
static void sights_arrive(struct sights *sights, unsigned seen, unsigned meet)
{
    for (unsigned each = seen & ~sights->plain; each; each &= each - 1) {
        unsigned i = (unsigned)__builtin_ctz(each);
        struct crossing *crossing = &sights->crossing[i];
        bool meets = meet >> i & 1;
        if (!sights->path[i])
            sights->path[i] = sights_start(sights, i);
        if (meets)
            sight_describe(sights, i);
        if (path_arrive(sights->path[i], crossing,
                        meets ? NULL : &sights->sky[i], sight_fog(sights, i))) {
            sights->lit |= 1u << i;
            facets_set(&sights->facets, i, &crossing->surface,
                       path_within(sights->path[i], crossing));
        } else {
            wavefront_end(sights->path[i]);
        }
    }
}

/* From a plain leaf that is not the last. */
static void sight_go_on(struct sights *sights, unsigned i, rgb light)
{
    const struct facets *facets = &sights->facets;
    struct path *path = sights->path[i];
    path_passes(path, facets->leaf[i]);
    if (facets->leaf[i]->look->opaque && !(facets->layered >> i & 1)) {
        struct surface_paint paint = facets_paint_of(facets, i);
        path_leave_plain(path, facets->leaf[i], &paint, light);
        wavefront_end(path);
    } else {
        struct crossing crossing; /* one after the other in the same place */
        crossing_fill_facet(&crossing, facets, i);
        wavefront_leave(path, &crossing, light);
    }
}

static void sights_light(struct sights *sights)
{
    const struct tracer *tracer = sights->wavefront->tracer;
    struct facets *facets = &sights->facets;
    struct facets_diffuse diffuse;
    tracer->lighting->illuminate_many(
        tracer->lighting_state, sights->wavefront->worker, facets, &diffuse);
    for (unsigned lit = sights->lit; lit; lit &= lit - 1) {
        unsigned i = (unsigned)__builtin_ctz(lit);
        struct path *path = sights->path[i];
        const struct crossing *crossing = &sights->crossing[i];
        wavefront_leave(path, crossing,
                        path_shade(path, crossing, facets_light(facets, i),
                                   facets_diffuse_at(&diffuse, i)));
    }
    if (sights->plain)
        facets_glow(facets, sights->plain, &diffuse);
    for (unsigned plain = sights->plain; plain; plain &= plain - 1) {
        unsigned i = (unsigned)__builtin_ctz(plain);
        rgb light = facets_light(facets, i);
        bool last = facets->leaf[i]->look->last;
        if (!sights->path[i] && !last)
            sights->path[i] = sights_start(sights, i);
        if (!sights->path[i]) {
            sights->out[i] = (struct radiance){ light, 1 };
        } else if (last) {
            path_gather(sights->path[i], light);
            wavefront_end(sights->path[i]);
        } else {
            sight_go_on(sights, i, light);
        }
    }
}

static void sights_see(struct sights *sights, unsigned seen)
{
    unsigned meet = sights_meet(sights, seen);
    seen = meet | sights_miss(sights, seen & ~meet);
    sights_arrive(sights, seen, meet);
    if (sights->plain | sights->lit)
        sights_light(sights);
}

/* Whether there is a picture. */
static unsigned places_seen(const struct camera *camera,
                            const struct tracer_met *met)
{
    unsigned seen = (1u << met->count) - 1;
    for (unsigned i = 0; camera->kind->sees && i < met->count; i++)
        if (met->places &&
            !camera_sees(camera, met->places[i].at[0], met->places[i].at[1]))
            seen &= ~(1u << i);
    return seen;
}

/* Of the rays that wait, up to a packet of one kind. */
static void wavefront_take(struct wavefront *wavefront, struct sights *sights)
{
    struct path_list *list = &wavefront->mirrored;
    if (list->count < wavefront->lanes && wavefront->open.count > 0)
        list = &wavefront->open;
    sights->count =
        list->count < wavefront->lanes ? list->count : wavefront->lanes;
    for (unsigned i = 0; i < sights->count; i++) {
        sights->path[i] = list->first;
        list->first = list->first->next;
    }
    list->count -= sights->count;
}

static void sights_follow(struct sights *sights)
{
    const unsigned count = sights->count;
    struct rays rays;
    struct rays_span span;
    struct world_hit hits[WORLD_RAYS];
    for (unsigned i = 0; i < count; i++) {
        const struct path *path = sights->path[i];
        rays_set(&rays, (int)i, path->ray.origin, path->ray.direction);
        span.near[i] = surface_offset(path->ray.origin);
        span.far[i] = (double)INFINITY;
    }
    rays_fill(&rays, &span, count);
    world_closest_many(sights->wavefront->tracer->world, &rays, &span, count,
                       sights->path[0]->kind, hits);
    sights->rays = &rays;
    sights->hits = hits;
    sights_see(sights, (1u << count) - 1);
}

/* Those of a packet that is too small to be one. */
static void sights_each(struct sights *sights)
{
    struct crossing *crossing = &sights->crossing[0];
    for (unsigned i = 0; i < sights->count; i++) {
        struct path *path = sights->path[i];
        bool met = path_meet(path, &crossing->at);
        wavefront_go_on(path, crossing, met);
    }
}

/* Follows all that wait. */
static void sights_run(struct sights *sights)
{
    struct wavefront *wavefront = sights->wavefront;
    sights->places = NULL;
    sights->out = NULL;
    while (wavefront->open.count + wavefront->mirrored.count > 0 &&
           !worker_stopped(wavefront->worker)) {
        wavefront_take(wavefront, sights);
        if (sights->count >= PACKET_LEAST)
            sights_follow(sights);
        else
            sights_each(sights);
    }
}

void wavefront_see(struct wavefront *wavefront, const struct tracer_met *met,
                   struct radiance *out)
{
    struct sights sights;
    unsigned seen = places_seen(&wavefront->tracer->scene->camera, met);
    sights.wavefront = wavefront;
    sights.rays = met->rays;
    sights.hits = met->hits;
    sights.count = met->count;
    sights.places = met->places;
    sights.out = out;
    memset(sights.path, 0, sizeof sights.path);
    memset(out, 0, met->count * sizeof *out);
    sights_see(&sights, seen);
    for (unsigned plain = sights.plain; plain; plain &= plain - 1)
        wavefront->worker->counters.camera_rays +=
            !sights.path[__builtin_ctz(plain)];
    sights_run(&sights);
}

void wavefront_run(struct wavefront *wavefront)
{
    struct sights sights;
    sights.wavefront = wavefront;
    sights_run(&sights);
}
