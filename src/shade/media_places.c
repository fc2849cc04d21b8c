/* What media are at places of a ray's way: see media_places.h. */
#include "shade/media_places.h"

#include "shade/lamps.h"
#include "shade/photon_map.h"

/* The mean of the media's phase functions. */
static double way_phase(const struct media_way *way, vec3 from)
{
    double phase = 0, cosine = vec3_dot(from, way->direction);
    for (int i = 0; i < way->media->count; i++)
        phase += medium_phase(way->media->at[i], cosine) / way->media->count;
    return phase;
}

/* Places looking at a lamp, and their ways to it. */
struct media_sights {
    const struct media_way *way;
    const struct lamp *lamp;
    unsigned lit; /* if nothing is between */
    struct lamp_view view[RAY_LANES];
    struct occlusions ways;
    const struct interiors *inside[RAY_LANES];
};

static void sights_add(struct media_sights *sights, unsigned i, vec3 point)
{
    const struct lamp *lamp = sights->lamp;
    struct lamp_view *view = &sights->view[i];
    sights->inside[i] = sights->way->inside;
    rays_set(&sights->ways.rays, (int)i, point, vec3_make(0, 0, 0));
    sights->ways.span.near[i] = sights->ways.span.far[i] = 0;
    if (!lamp_look(lamp, lamp->light->location, point, view))
        return;
    rays_set(&sights->ways.rays, (int)i, point, view->direction);
    sights->ways.span.near[i] = shadow_start(point, view->distance);
    sights->ways.span.far[i] = shadow_end(view->distance);
    sights->lit |= 1u << i;
}

/* The share of the lamp's light that gets to a place by itself. */
static rgb sights_share(const struct media_sights *sights, unsigned i)
{
    const struct media_way *way = sights->way;
    const struct lamp_target target = {
        .point = rays_origin(&sights->ways.rays, (int)i),
        .inside = way->inside,
        .view = sights->view[i],
    };
    return lamps_share(way->lamps, sights->lamp, way->worker, &target);
}

/* To all of them: together, if that is quicker. */
static void sights_look(struct media_sights *sights, rgb shares[RAY_LANES])
{
    const struct lamps *lamps = sights->way->lamps;
    const struct shadow_around around =
        lamps_around(lamps, sights->lamp, sights->inside);
    struct shadows found = { .left = sights->lit };
    if (sights->lit & (sights->lit - 1) &&
        lamps_together(lamps, sights->lamp)) {
        sights->ways.light = sights->lamp->number;
        sights->ways.shaft = NULL;
        shadow_falls_many(lamps->world, sights->way->worker, &sights->ways,
                          sights->lit, &around, &found);
    }
    for (unsigned each = sights->lit; each; each &= each - 1) {
        unsigned i = (unsigned)__builtin_ctz(each);
        shares[i] = found.left >> i & 1 ? sights_share(sights, i)
                                        : shadows_along(&found, i);
    }
}

/* What is scattered to the viewer at them. */
static void sights_scatter(const struct media_sights *sights,
                           const rgb shares[RAY_LANES], struct places *places)
{
    for (unsigned each = sights->lit; each; each &= each - 1) {
        int i = __builtin_ctz(each);
        const struct lamp_view *view = &sights->view[i];
        double phase = way_phase(sights->way, view->direction);
        rgb arriving = rgb_mul(shares[i], sights->lamp->light->colour);
        rgb *light = &places->sample[i].light;
        arriving = rgb_mul(arriving, places->scattered[i]);
        *light =
            rgb_add(*light, rgb_scale(arriving, phase * view->attenuation));
    }
}

_Static_assert((int)SPOTS_MAX <= (int)RAY_LANES, "each place has a lane");

/* A lamp's light at the places that are in its beam. */
static void places_lamp(const struct media_way *way, struct places *places,
                        const struct media_beam *beam)
{
    struct media_sights sights = { .way = way, .lamp = beam->lamp };
    rgb shares[RAY_LANES];
    for (int i = 0; i < places->count; i++) {
        vec3 point = spots_at(&places->at, i);
        double t = vec3_dot(vec3_sub(point, way->origin), way->direction);
        if (t >= beam->from && t <= beam->to &&
            !rgb_is_black(places->scattered[i]))
            sights_add(&sights, (unsigned)i, point);
    }
    sights_look(&sights, shares);
    sights_scatter(&sights, shares, places);
}

/* That of all lamps. */
static void places_lamps(const struct media_way *way, struct places *places)
{
    const struct media_beams *beams = way->beams;
    for (int i = 0; beams && i < beams->count; i++)
        places_lamp(way, places, &beams->at[i]);
    for (size_t i = 0; !beams && i < way->lamps->count; i++) {
        const struct lamp *lamp = &way->lamps->items[i];
        const struct media_beam everywhere = { lamp, -HUGE_VAL, HUGE_VAL };
        if (lamp_is_for_media(lamp, way->end))
            places_lamp(way, places, &everywhere);
    }
}

/* What photons bring there. */
struct gathering {
    const struct media_way *way;
    rgb light;
};

static void gather_photon(void *context, const struct photon *photon,
                          rgb irradiance)
{
    struct gathering *gathering = context;
    double phase = way_phase(gathering->way, photon_unpack(photon->from));
    gathering->light = rgb_add_scaled(gathering->light, irradiance, phase);
}

static rgb sample_photons(const struct media_way *way, vec3 point)
{
    struct gathering gathering = { way, rgb_grey(0) };
    photon_map_visit_within(way->photons, way->worker, point, gather_photon,
                            &gathering);
    return gathering.light;
}

/* What one of the media is there. */
static void places_add(struct places *places, const struct medium *medium,
                       bool glows)
{
    rgb densities[SPOTS_MAX], extinction = medium_extinction(medium);
    medium_densities(medium, &places->at, densities);
    for (int i = 0; i < places->count; i++) {
        struct media_sample *sample = &places->sample[i];
        places->scattered[i] = rgb_add(
            places->scattered[i], rgb_mul(medium->scattering, densities[i]));
        sample->depth =
            rgb_add(sample->depth, rgb_mul(extinction, densities[i]));
        if (glows)
            sample->light =
                rgb_add(sample->light, rgb_mul(medium->emission, densities[i]));
    }
}

/* What photons bring to them. */
static void places_photons(const struct media_way *way, struct places *places)
{
    for (int i = 0; i < places->count; i++) {
        rgb *light = &places->sample[i].light, scattered = places->scattered[i];
        if (!rgb_is_black(scattered))
            *light = rgb_add(
                *light, rgb_mul(scattered,
                                sample_photons(way, spots_at(&places->at, i))));
    }
}

void media_depths(const struct media_list *list, struct worker *worker,
                  const struct spots *spots, rgb *depths)
{
    rgb densities[SPOTS_MAX];
    int media = worker_stopped(worker) ? 0 : list->count;
    for (int i = 0; i < spots->count; i++)
        depths[i] = rgb_grey(0);
    for (int k = 0; k < media; k++) {
        const struct medium *medium = list->at[k];
        rgb extinction = medium_extinction(medium);
        if (rgb_is_black(extinction))
            continue;
        medium_densities(medium, spots, densities);
        for (int i = 0; i < spots->count; i++)
            depths[i] = rgb_add(depths[i], rgb_mul(extinction, densities[i]));
    }
}

void media_samples(const struct media_way *way, bool lit, struct places *places)
{
    places->count = places->at.count;
    for (int i = 0; i < places->count; i++) {
        places->sample[i] = (struct media_sample){ rgb_grey(0), rgb_grey(0) };
        places->scattered[i] = rgb_grey(0);
    }
    if (worker_stopped(way->worker))
        return;
    for (int i = 0; i < way->media->count; i++)
        places_add(places, way->media->at[i], way->lamps);
    if (way->photons)
        places_photons(way, places);
    if (lit)
        places_lamps(way, places);
}
