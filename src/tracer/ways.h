/* The ways on which light may have come to where a path meets a surface: what a
 * mirror, glass, a pane or the surface's own scattering sends to the path. */
#ifndef TRACER_WAYS_H
#define TRACER_WAYS_H

#include "tracer/crossing.h"
#include "tracer/tracer.h"

enum { WAYS_MAX = TEXTURE_LAYERS + 2 };

enum way_kind { WAY_SCATTERED, WAY_MIRRORED, WAY_THROUGH, WAY_TURNED };

struct way {
    enum way_kind kind;
    const struct surface_layer *layer; /* mirrored */
    vec3 direction;                    /* mirrored, through, turned */
    rgb weight; /* scattered: about, by which it is chosen */
};

struct ways {
    int count;
    struct way at[WAYS_MAX];
};

/* How the path came there. */
struct arrival {
    const struct tracer *tracer;
    vec3 direction;
    int level;  /* as of max_trace_level, from 1 */
    bool split; /* the camera sees it, by mirrors and glass alone */
};

/* All ways but scattering. Total reflection takes the place of the rest. */
void ways_find(struct ways *ways, const struct arrival *arrival,
               const struct crossing *crossing);

/* One more, unless nothing comes that way; `layer` of a mirror. */
void ways_add(struct ways *ways, enum way_kind kind, vec3 direction, rgb weight,
              const struct surface_layer *layer);

/* The share of light that comes by all of them, largest of the colours. */
double ways_total(const struct ways *ways);

/* One way is left, chosen by weight and a number in [0,1). */
void ways_choose(struct ways *ways, double which);

/* Of a mirror's reflection; 1 elsewhere. */
double way_exponent(const struct way *way);

#endif
