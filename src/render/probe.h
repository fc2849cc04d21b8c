/* The light that reaches points in space, without a picture, by any lighting
 * method: --probe. */
#ifndef RENDER_PROBE_H
#define RENDER_PROBE_H

#include "render/render.h"

/* Where light is asked for. */
struct probe_point {
    vec3 place;
    vec3 normal;   /* any length but 0; of no meaning unless `directed` */
    bool directed; /* irradiance of a surface; else the scalar light field */
};

/* What reaches a point. */
struct probe_light {
    rgb colour;
    bool streams; /* the lighting method knows where light comes from: */
    vec3 stream;  /* lighting.h */
};

/* What reaches `count` points, into `light`, in POV-Ray's units: a white
 * surface that reflects everything (diffuse 1, ambient 0) is as bright as its
 * irradiance, so a lamp gives colour * cosine, and surroundings of radiance 1
 * give 1. The scalar light field counts light from all sides without its
 * cosine: a lamp gives its colour, surroundings of radiance 1 give 4.
 *
 * Only `threads`, `stop`, `progress` and `samples` of the options count. The
 * same bits for any number of threads. Returns false if stopped. */
bool probe_run(const struct tracer *tracer,
               const struct render_options *options,
               const struct probe_point *points, size_t count,
               struct probe_light *light, struct render_stats *stats);

#endif
