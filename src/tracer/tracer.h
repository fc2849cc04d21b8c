/* The recursive ray tracer (Whitted 1980): what a camera ray sees. */
#ifndef TRACER_TRACER_H
#define TRACER_TRACER_H

#include "lighting/lighting.h"
#include "shade/interior.h"

struct photon_map;

struct tracer {
    const struct scene *scene;
    const struct world *world;
    const struct lighting *lighting;
    void *lighting_state;
    const struct photon_map *photons; /* NULL: none (tracer/photons.h) */
    int quality;                      /* +Q: see man/glim.1 */
    bool alpha; /* +UA: the background's transparency shows as opacity */
    /* By tracer_ready: what camera rays start in, if it is known for all. */
    bool ready;
    bool airless; /* that, and nothing is met on the way but surfaces */
    bool painted; /* surfaces look as their paint says: leaves that are plain
                   * need no more */
    struct interiors start;
    bool guided;    /* by path_ready: pictures' paths ask the guide */
    double typical; /* by path_ready: mean light of a pixel; 0: not known */
};

/* Finds once what all camera rays start in, if they agree; without it each is
 * looked at by itself. */
void tracer_ready(struct tracer *tracer);

/* Radiance in the working space, premultiplied by opacity. */
struct radiance {
    rgb colour;
    double opacity;
};

/* What the camera sees at a place of the picture. Black once the worker is told
 * to stop. Its value depends on the place alone. */
struct radiance tracer_camera(const struct tracer *tracer,
                              struct worker *worker,
                              const struct picture_place *place);

/* `count` of each. */
struct tracer_met {
    const struct picture_place *places; /* of each, or of the pixel whose lens
                                         * it comes through */
    const struct rays *rays;
    const struct world_hit *hits;
    unsigned count;
};

/* Whether the camera has one ray at each place: else tracer_see_many makes its
 * own, and what it is told of others isn't asked for. */
bool tracer_is_single(const struct tracer *tracer);

/* The same at up to WORLD_RAYS places, quicker where they are neighbours, in
 * parts: the camera's rays, what it meets first, and what is seen then.
 * The worker's scratch memory is reset after each. */
void tracer_rays(const struct tracer *tracer,
                 const struct picture_place *places, unsigned count,
                 struct rays *rays);
void tracer_meet_many(const struct tracer *tracer, const struct rays *rays,
                      unsigned count, struct world_hit *hits);
void tracer_see_many(const struct tracer *tracer, struct worker *worker,
                     const struct tracer_met *met, struct radiance *out);

#endif
