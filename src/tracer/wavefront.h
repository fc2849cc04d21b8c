/* Rays of the recursive tracer that are followed together, in packets: those
 * of the camera, then what they sent on, and so on (a wavefront, as van
 * Antwerpen 2011 has it, but of the rays of a few pixels at a time, the latest
 * first, so that few wait at any time). The light of each is the same to the
 * bit as if it were followed by itself. */
#ifndef TRACER_WAVEFRONT_H
#define TRACER_WAVEFRONT_H

#include "base/clones.h"
#include "tracer/branch.h"

enum { WAVEFRONT_USUAL = 4 * WORLD_RAYS }; /* rays at any time */

/* Rays that wait, the first one to be followed first. */
struct path_list {
    struct path *first;
    unsigned count;
};

struct wavefront {
    const struct tracer *tracer;
    struct worker *worker;           /* in whose scratch memory all else is */
    unsigned lanes;                  /* rays at a time */
    struct path_list open, mirrored; /* the latter: those of RAY_REFLECTION */
    struct path_list born; /* at the surface at hand, the last first */
    struct path *idle;     /* to be used again */
    struct due *idle_dues;
    unsigned used; /* of these, before any of the scratch memory, which is
                    * cleared each time: */
    struct path usual[WAVEFRONT_USUAL];
};

/* With `together` in packets; otherwise one by one in the order of a recursion:
 * mirrors before what goes through, each to its end. */
void wavefront_start(struct wavefront *wavefront, const struct tracer *tracer,
                     struct worker *worker, bool together);

/* A camera's ray, of which only the list's and the dues' members are set; what
 * is seen goes to `seen` when it has ended. */
struct path *wavefront_root(struct wavefront *wavefront, struct radiance *seen);

/* A ray whose light, times the tint and what is the share of `path` now, is to
 * be gathered by it. To be set: its ray, kind, level, weight and inside. It is
 * followed once `path` has left the surface. */
struct path *wavefront_branch(struct path *path, rgb tint);

/* Light that is known but stands behind some that isn't. */
struct due *wavefront_due(struct path *path);

/* Adds light, of which the ray's share counts. Part of its callers: light that
 * was just made would be copied on its way to a function. */
INLINED void path_gather(struct path *path, rgb light)
{
    light = rgb_mul(path->share, light);
    if (path->dues)
        wavefront_due(path)->light = light;
    else
        path->light = rgb_add(path->light, light);
}

/* The ray has left a surface and goes on, or hasn't met anything yet. */
void wavefront_push(struct path *path);

/* It ends, and what branched off at the last surface begins. */
void wavefront_end(struct path *path);

/* From the surface that the ray has arrived at, by itself; or ends. */
void wavefront_leave(struct path *path, const struct crossing *crossing,
                     rgb light);

/* One whose first surface is known or not, and may be none, of a wavefront that
 * goes one by one. */
void wavefront_go_on(struct path *path, struct crossing *crossing, bool met);

/* What the camera sees at places, of what its rays meet first; all are followed
 * to their ends. */
void wavefront_see(struct wavefront *wavefront, const struct tracer_met *met,
                   struct radiance *out);

/* Follows all that wait to their ends, or until the worker is told to stop. */
void wavefront_run(struct wavefront *wavefront);

#endif
