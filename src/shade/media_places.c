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

/* The light of one lamp that is scattered to the viewer there. */
static rgb sample_lamp(const struct media_way *way, const struct lamp *lamp,
                       vec3 point, rgb scattered)
{
    const struct light *light = lamp->light;
    struct lamp_target target = { .point = point, .inside = way->inside };
    if (!lamp_look(lamp, light->location, point, &target.view))
        return rgb_grey(0);
    double phase = way_phase(way, target.view.direction);
    rgb arriving = lamps_share(way->lamps, lamp, way->worker, &target);
    arriving = rgb_mul(rgb_mul(arriving, light->colour), scattered);
    return rgb_scale(arriving, phase * target.view.attenuation);
}

/* The same of all lamps, added to what is there. */
static rgb sample_lamps(const struct media_way *way, vec3 point, rgb scattered,
                        rgb light)
{
    const struct media_beams *beams = way->beams;
    double t = vec3_dot(vec3_sub(point, way->origin), way->direction);
    for (int i = 0; beams && i < beams->count; i++)
        if (t >= beams->at[i].from && t <= beams->at[i].to)
            light = rgb_add(
                light, sample_lamp(way, beams->at[i].lamp, point, scattered));
    for (size_t i = 0; !beams && i < way->lamps->count; i++) {
        const struct lamp *lamp = &way->lamps->items[i];
        if (!lamp->light->shadowless && !lamp->light->no_media)
            light = rgb_add(light, sample_lamp(way, lamp, point, scattered));
    }
    return light;
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

/* The light that is scattered to the viewer at one of them. */
static rgb place_scatters(const struct media_way *way,
                          const struct places *places, int i, bool lit)
{
    rgb scattered = places->scattered[i], light = places->sample[i].light;
    vec3 point = spots_at(&places->at, i);
    if (rgb_is_black(scattered))
        return light;
    if (way->photons)
        light = rgb_add(light, rgb_mul(scattered, sample_photons(way, point)));
    return lit ? sample_lamps(way, point, scattered, light) : light;
}

void media_depths(const struct media_way *way, const struct spots *spots,
                  rgb *depths)
{
    rgb densities[SPOTS_MAX];
    int media = worker_stopped(way->worker) ? 0 : way->media->count;
    for (int i = 0; i < spots->count; i++)
        depths[i] = rgb_grey(0);
    for (int k = 0; k < media; k++) {
        const struct medium *medium = way->media->at[k];
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
    for (int i = 0; (lit || way->photons) && i < places->count; i++)
        places->sample[i].light = place_scatters(way, places, i, lit);
}
