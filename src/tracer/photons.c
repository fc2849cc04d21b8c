/* Photons on their way: see photons.h. */
#include "tracer/photons.h"

#include "base/memory.h"
#include "base/parallel.h"
#include "base/random.h"
#include "scene/photon.h"
#include "shade/finish.h"
#include "shade/media.h"
#include "shade/shadow.h"
#include "shade/spectrum.h"
#include "tracer/crossing.h"
#include "tracer/photon_aim.h"

enum {
    SENT_MOST = 50 * 1000 * 1000,   /* photons, some minutes of a core */
    MEETINGS_MAX = 2000,            /* surfaces that one photon and its branches
                                     * meet */
    LOOKED_MOST = 8 * PHOTONS_MOST, /* places of media, some seconds */
    ROW_FIRST = 64, /* photons that a row has room for at first */
};

/* Steps by this share of a circle come near to no place soon. */
static const double golden = 0.618;

/* Where photons are kept. */
enum kept { ON_SURFACES, IN_MEDIA, KEPT_KINDS };

struct photon_list {
    struct photon *items;
    size_t count, capacity;
};

/* The photons of one row, in order. */
struct photon_row {
    const struct photon_aim *aim;
    size_t number; /* in its aim */
    uint64_t key;
    struct photon_list lists[KEPT_KINDS];
};

struct sending {
    const struct tracer *tracer;
    struct lamps lamps;
    struct photon_aims aims;
    struct photon_row *rows;
    size_t row_count;
    struct worker *workers;
    int levels;
    double bailout;
    double steps, step; /* in media: how many at most, how long; 0: none */
    atomic_size_t kept[KEPT_KINDS];
    atomic_size_t looked; /* places of media where photons could stay */
    const atomic_int *stop;
};

/* One photon, or a branch of it. */
struct flight {
    struct sending *sending;
    struct photon_row *row;
    struct worker *worker;
    struct ray ray;
    rgb share;   /* of the lamp's colour */
    rgb weight;  /* held against adc_bailout: mirrors count twice (measured) */
    double gone; /* from the lamp */
    size_t number; /* in its row */
    int level;     /* 1 until the target bends it */
    bool bent;     /* it has met its target */
    int *meetings; /* still allowed */
    double extent; /* of the lamp's cone or beam */
    struct interiors inside;
};

_Static_assert(4 * SETTINGS_LEVELS_MAX *
                       (sizeof(struct flight) + sizeof(struct crossing)) <
                   PARALLEL_STACK,
               "max_trace_level fits into the stack");

static void flight_follow(struct flight *flight);

/* ---- landing ---- */

static struct photon *list_push(struct photon_list *list)
{
    if (list->count == list->capacity) {
        list->capacity = list->capacity ? 2 * list->capacity : ROW_FIRST;
        list->items =
            memory_resize(list->items, list->capacity * sizeof *list->items);
    }
    return &list->items[list->count++];
}

static bool surface_diffuses(const struct surface *surface)
{
    for (int i = 0; i < surface->count; i++) {
        const struct finish *finish = surface->layer[i].finish;
        if (finish->diffuse != 0 || finish_shines(finish))
            return true;
    }
    return false;
}

/* So far from the lamp. */
static rgb flight_flux(const struct flight *flight, double gone)
{
    const struct lamp *lamp = flight->row->aim->lamp;
    double worth = flight->extent * lamp_fading(lamp, gone);
    if (!flight->row->aim->beam)
        worth *= gone * gone;
    return rgb_mul(flight->share, rgb_scale(lamp->light->colour, worth));
}

static void flight_keep(const struct flight *flight, enum kept kind, vec3 at,
                        rgb flux)
{
    const struct lamp *lamp = flight->row->aim->lamp;
    struct photon photon = { .lamp = (unsigned)lamp->number & 0x3fffffff };
    if (!isfinite(rgb_peak(flux)) || !vec3_finite(at))
        return;
    photon.at[0] = (float)at.x;
    photon.at[1] = (float)at.y;
    photon.at[2] = (float)at.z;
    photon.flux[0] = (float)flux.r;
    photon.flux[1] = (float)flux.g;
    photon.flux[2] = (float)flux.b;
    photon_pack(vec3_negate(flight->ray.direction), photon.from);
    *list_push(&flight->row->lists[kind]) = photon;
    atomic_fetch_add(&flight->sending->kept[kind], 1);
}

static void flight_land(const struct flight *flight,
                        const struct surface *surface)
{
    if (surface->at->leaf->look->photons->unlit || !surface_diffuses(surface))
        return;
    flight_keep(flight, ON_SURFACES, surface->point,
                flight_flux(flight, flight->gone));
}

static bool sending_full(const struct sending *sending)
{
    return atomic_load(&sending->kept[ON_SURFACES]) > PHOTONS_MOST ||
           atomic_load(&sending->kept[IN_MEDIA]) > PHOTONS_MOST ||
           atomic_load(&sending->looked) > LOOKED_MOST;
}

/* ---- surfaces ---- */

static void flight_dim(struct flight *flight, rgb through)
{
    flight->share = rgb_mul(flight->share, through);
    flight->weight = rgb_mul(flight->weight, through);
}

/* Whether so much of it is left that it goes on. */
static bool flight_counts(const struct flight *flight)
{
    return rgb_peak(flight->weight) >= flight->sending->bailout;
}

/* The way in a body to where it is met from inside: what lands there, is
 * mirrored or leaves is weaker by it, as in POV-Ray. */
static void flight_fade(struct flight *flight, const struct intersection *at)
{
    const struct interior *interior = at->leaf->look->interior;
    if (interior_dims_shadows(interior))
        flight_dim(flight, interior_fade(interior, at->t));
}

/* What a clear thing before the target leaves of it. False if that is
 * nothing. */
static bool flight_pass_clear(struct flight *flight,
                              const struct intersection *at)
{
    rgb through = at->leaf->look->opaque
                      ? rgb_grey(0)
                      : surface_passes(at, flight->ray.direction);
    flight_dim(flight, through);
    if (interiors_find(&flight->inside, at->leaf->body) >= 0)
        flight_fade(flight, at);
    interiors_cross(&flight->inside, at->leaf);
    flight->ray.origin = at->point;
    return flight_counts(flight);
}

static bool media_scatters_at(const struct media_list *media, vec3 at)
{
    for (int i = 0; i < media->count; i++)
        if (!rgb_is_black(media->at[i]->scattering) &&
            !rgb_is_black(medium_density(media->at[i], at)))
            return true;
    return false;
}

/* What stays in media on the way to the next surface. As POV-Ray's photons do
 * (measured), it stays where media that a container holds scatter, and lights
 * those of the scene as well, which alone have none; it grows with the distance
 * from the lamp, against that where the stretch begins; media dim them no
 * sooner than at its end. */
static void flight_stay(const struct flight *flight, double distance)
{
    const struct sending *sending = flight->sending;
    struct media_list held;
    media_find(&held, NULL, &flight->inside);
    if (held.count == 0)
        return;
    double steps = ceil(distance / sending->step), step = sending->step;
    if (steps > sending->steps) {
        steps = sending->steps;
        step = isfinite(distance) ? distance / steps : step;
    }
    atomic_fetch_add(&flight->sending->looked, (size_t)steps);
    uint64_t key = random_key(random_key(flight->row->key, flight->number),
                              (uint64_t)*flight->meetings);
    double first = random_unit(key);
    for (int i = 0; i < (int)steps && !sending_full(sending); i++) {
        double length = fmin(step, distance - i * step);
        double t = i * step + first * length, gone = flight->gone + t;
        double worth = length * gone / fmax(flight->gone, step);
        vec3 at = ray_point(&flight->ray, t);
        if (media_scatters_at(&held, at))
            flight_keep(flight, IN_MEDIA, at,
                        rgb_scale(flight_flux(flight, gone), worth));
    }
}

/* Through media to the next surface. */
static void flight_drift(struct flight *flight, double distance)
{
    const struct sending *sending = flight->sending;
    const struct lamp *lamp = flight->row->aim->lamp;
    struct media_list media;
    media_find(&media, &sending->tracer->scene->media, &flight->inside);
    if (media.count == 0)
        return;
    if (flight->bent && sending->steps >= 1 && !lamp->light->no_media)
        flight_stay(flight, distance);
    struct media_way way = { .media = &media,
                             .origin = flight->ray.origin,
                             .direction = flight->ray.direction,
                             .length = distance,
                             .worker = flight->worker,
                             .inside = &flight->inside };
    flight_dim(flight, media_veil(&way).through);
}

static void flight_mirror(const struct flight *flight,
                          const struct crossing *crossing,
                          const struct surface_layer *layer)
{
    struct flight branch = *flight;
    flight_dim(&branch, rgb_mul(layer->weight, layer->reflection));
    branch.weight = rgb_mul(branch.weight, layer->reflection);
    if (!flight_counts(&branch))
        return;
    branch.ray.origin = crossing->at.point;
    branch.ray.direction = surface_mirrored(
        crossing->surface.normal, flight->ray.direction, layer->normal);
    branch.level++;
    flight_follow(&branch);
}

static void flight_mirrors(const struct flight *flight,
                           const struct crossing *crossing)
{
    const struct surface *surface = &crossing->surface;
    for (int i = 0; i < surface->count; i++)
        if (!rgb_is_black(surface->layer[i].reflection))
            flight_mirror(flight, crossing, &surface->layer[i]);
}

/* Where glass divides light each photon is of one colour, another than its
 * neighbours are. */
static rgb flight_divide(struct flight *flight, struct crossing *crossing)
{
    int parts = crossing_parts(crossing, &flight->inside);
    if (parts <= 1)
        return rgb_grey(1);
    size_t stride = (size_t)(golden * parts) + 1;
    int number =
        (int)((flight->number + stride * flight->row->number) % (size_t)parts);
    crossing_divide(crossing, &flight->inside, spectrum_place(number, parts));
    return rgb_scale(spectrum_part(number, parts), parts);
}

/* On behind the surface, or back from it in total reflection: then the mirror
 * has no part in it. */
static bool flight_pass(struct flight *flight, struct crossing *crossing,
                        bool mirrors)
{
    const struct surface *surface = &crossing->surface;
    vec3 normal = surface->pane, direction = flight->ray.direction;
    rgb part = rgb_grey(1);
    bool inward = false;
    if (crossing->ior != 1) {
        part = flight_divide(flight, crossing);
        inward = !crossing_refracted(crossing, direction, normal, &direction);
    }
    if (mirrors && !inward)
        flight_mirrors(flight, crossing);
    flight->share = rgb_mul(flight->share, part);
    if (inward) {
        flight->ray.direction = surface_mirrored(crossing->surface.normal,
                                                 flight->ray.direction, normal);
    } else {
        flight->ray.direction = direction;
        flight_dim(flight, surface->through);
        interiors_copy(&flight->inside, &crossing->beyond);
    }
    flight->ray.origin = crossing->at.point;
    flight->level += crossing->ior != 1;
    return flight_counts(flight);
}

/* False if it ends there. */
static bool flight_meet(struct flight *flight, struct crossing *crossing,
                        bool land)
{
    const struct photon_flags *lamp = &flight->row->aim->lamp->light->photons;
    const struct photon_flags *object = crossing->at.leaf->look->photons;
    crossing_fill(crossing, flight->sending->tracer, flight->ray.direction,
                  &flight->inside, flight->sending->bailout, false);
    if (crossing->leaving)
        flight_fade(flight, &crossing->at);
    if (land)
        flight_land(flight, &crossing->surface);
    if (flight->level >= flight->sending->levels)
        return false;
    bool mirrors = photon_happens(lamp->reflection, object->reflection);
    if (photon_happens(lamp->refraction, object->refraction) &&
        rgb_peak(crossing->surface.through) != 0)
        return flight_pass(flight, crossing, mirrors);
    if (mirrors)
        flight_mirrors(flight, crossing);
    return false;
}

/* False if the photon is not for what it meets. */
static bool flight_aims(struct flight *flight, const struct leaf *leaf)
{
    if (leaf->look->target == flight->row->aim->target)
        flight->bent = true;
    return flight->bent || leaf->look->target == 0;
}

static void flight_follow(struct flight *flight)
{
    const struct world *world = flight->sending->tracer->world;
    struct crossing crossing;
    while (--*flight->meetings >= 0 && !worker_stopped(flight->worker)) {
        bool land = flight->bent;
        if (!world_closest(world, &flight->ray,
                           surface_offset(flight->ray.origin), RAY_PHOTON,
                           &crossing.at)) {
            flight_drift(flight, (double)INFINITY);
            return;
        }
        const struct leaf *leaf = crossing.at.leaf;
        flight_drift(flight, crossing.at.t);
        flight->gone += crossing.at.t;
        if (leaf->look->no_image) {
            flight->ray.origin = crossing.at.point;
            continue;
        }
        if (!flight_aims(flight, leaf))
            return;
        if (flight->bent ? !flight_meet(flight, &crossing, land)
                         : !flight_pass_clear(flight, &crossing.at))
            return;
    }
}

/* ---- rows ---- */

/* What of its brightness the lamp sends into that direction. */
static double start_share(const struct lamp *lamp, const struct ray *ray)
{
    struct lamp_view view;
    vec3 point = vec3_add(ray->origin, ray->direction);
    if (!lamp_look(lamp, ray->origin, point, &view))
        return 0;
    double fading = lamp_fading(lamp, view.distance);
    return fading > 0 ? view.attenuation / fading : 0;
}

/* `inside`: what all of them start in; NULL: each has a start of its own. */
static void row_send(struct sending *sending, struct photon_row *row,
                     struct worker *worker, const struct interiors *inside,
                     size_t place)
{
    int meetings = MEETINGS_MAX;
    struct photon_start start;
    if (!photon_aim_start(row->aim, &sending->lamps, row->number, place,
                          random_key(row->key, place), &start))
        return;
    double share = start_share(row->aim->lamp, &start.ray);
    if (share == 0)
        return;
    struct flight flight = { .sending = sending,
                             .row = row,
                             .worker = worker,
                             .number = place,
                             .ray = start.ray,
                             .share = rgb_grey(share),
                             .weight = rgb_grey(1),
                             .level = 1,
                             .meetings = &meetings,
                             .extent = start.extent };
    if (inside)
        interiors_copy(&flight.inside, inside);
    else
        tracer_inside(sending->tracer, start.ray.origin, &flight.inside);
    flight_follow(&flight);
}

static void send_row(void *context, size_t item, unsigned thread)
{
    struct sending *sending = context;
    struct photon_row *row = &sending->rows[item];
    struct worker *worker = &sending->workers[thread];
    const struct light *light = row->aim->lamp->light;
    bool alike = !row->aim->beam && !light->photons.area;
    struct interiors inside;
    tracer_inside(sending->tracer, light->location, &inside);
    for (size_t i = 0; i < row->aim->side && !worker_stopped(worker); i++) {
        if (sending_full(sending))
            return;
        row_send(sending, row, worker, alike ? &inside : NULL, i);
        arena_reset(worker->scratch);
    }
}

static void sending_rows(struct sending *sending)
{
    const struct photon_aims *aims = &sending->aims;
    for (size_t i = 0; i < aims->count; i++)
        sending->row_count += aims->items[i].side;
    sending->rows = memory_new(sending->row_count * sizeof *sending->rows);
    struct photon_row *row = sending->rows;
    for (size_t i = 0; i < aims->count; i++)
        for (size_t k = 0; k < aims->items[i].side; k++, row++)
            *row = (struct photon_row){
                .aim = &aims->items[i],
                .number = k,
                .key = random_key(random_key(0, i), k),
            };
}

static bool sending_run(struct sending *sending, unsigned threads)
{
    sending->workers = memory_new(threads * sizeof *sending->workers);
    for (unsigned i = 0; i < threads; i++)
        sending->workers[i] = (struct worker){ .number = i,
                                               .stop = sending->stop,
                                               .scratch = arena_new(0) };
    sending_rows(sending);
    bool done = parallel_run(threads, sending->row_count, sending->stop,
                             send_row, sending) &&
                !(sending->stop && atomic_load(sending->stop));
    for (unsigned i = 0; i < threads; i++)
        arena_free(sending->workers[i].scratch);
    memory_free(sending->workers);
    return done;
}

/* All rows' photons, one after the other. */
static struct photon *sending_join(struct sending *sending, enum kept kind)
{
    size_t kept = atomic_load(&sending->kept[kind]), count = 0;
    struct photon *all = kept ? memory_new(kept * sizeof *all) : NULL;
    for (size_t i = 0; i < sending->row_count; i++) {
        struct photon_list *list = &sending->rows[i].lists[kind];
        if (list->count)
            memcpy(&all[count], list->items, list->count * sizeof *all);
        count += list->count;
        memory_free(list->items);
        list->items = NULL;
    }
    return all;
}

static bool sending_fits(const struct sending *sending, struct diag *diag)
{
    const struct photon_aims *aims = &sending->aims;
    double spacing = aims->spacing * sqrt(aims->photons / SENT_MOST) * 1.01;
    if (aims->many) {
        diag_print(diag, DIAG_ERROR, span_none(), NULL,
                   "lamps send photons to targets in more than %d pairs, which "
                   "is glim's limit: type photons { refraction off reflection "
                   "off } in some of the lamps",
                   PHOTON_AIMS_MOST);
        return false;
    }
    if (aims->photons <= SENT_MOST)
        return true;
    diag_print(diag, DIAG_ERROR, span_none(), NULL,
               "a photon every %.3g units makes %.3g of them; glim's limit is "
               "%d: type photons { spacing %.3g } or more",
               aims->spacing, aims->photons, SENT_MOST, spacing);
    return false;
}

static bool sending_kept(const struct sending *sending, struct diag *diag)
{
    if (!sending_full(sending))
        return true;
    diag_print(diag, DIAG_ERROR, span_none(), NULL,
               "more than %d photons land%s, which is glim's limit: type "
               "photons { spacing %.3g } or more",
               PHOTONS_MOST,
               atomic_load(&sending->kept[ON_SURFACES]) > PHOTONS_MOST
                   ? ""
                   : " in media",
               sending->aims.spacing * 1.5);
    return false;
}

static void sending_end(struct sending *sending)
{
    for (size_t i = 0; i < sending->row_count; i++)
        for (int k = 0; k < KEPT_KINDS; k++)
            memory_free(sending->rows[i].lists[k].items);
    memory_free(sending->rows);
    memory_free(sending->aims.items);
    lamps_free(&sending->lamps);
}

static struct photon_map *sending_maps(struct sending *sending,
                                       const struct photon_settings *said,
                                       unsigned threads)
{
    struct photon_gather gather = { (unsigned)said->gather[0],
                                    (unsigned)said->gather[1], said->radius,
                                    said->radius_share };
    struct photon_map *map = photon_map_new(
        sending_join(sending, ON_SURFACES),
        atomic_load(&sending->kept[ON_SURFACES]), &gather, threads);
    size_t within = atomic_load(&sending->kept[IN_MEDIA]);
    gather.radius = said->media_radius;
    gather.share = said->media_radius_share;
    if (within > 0)
        photon_map_add_within(map,
                              photon_map_new(sending_join(sending, IN_MEDIA),
                                             within, &gather, threads));
    return map;
}

bool photons_send(const struct tracer *tracer, unsigned threads,
                  const atomic_int *stop, struct diag *diag,
                  struct photon_map **map)
{
    const struct settings *settings = &tracer->scene->settings;
    const struct photon_settings *said = &settings->photons;
    struct sending sending = {
        .tracer = tracer,
        .levels = said->max_trace_level > 0 ? said->max_trace_level
                                            : settings->max_trace_level,
        .bailout =
            said->adc_bailout > 0 ? said->adc_bailout : settings->adc_bailout,
        .stop = stop,
    };
    *map = NULL;
    if (!said->on || tracer->quality < QUALITY_PHOTONS)
        return true;
    if (sending.levels > SETTINGS_LEVELS_MAX)
        sending.levels = SETTINGS_LEVELS_MAX;
    threads = threads ? threads : 1;
    sending.lamps = lamps_new(tracer->world, tracer->scene, tracer->quality, 0);
    sending.aims = photon_aims_new(&sending.lamps);
    sending.steps = said->steps;
    sending.step = said->step * sending.aims.spacing;
    bool done = sending_fits(&sending, diag) &&
                sending_run(&sending, threads) && sending_kept(&sending, diag);
    if (done)
        *map = sending_maps(&sending, said, threads);
    sending_end(&sending);
    return done;
}
