/* The interface of the analytic shapes: sphere, box, torus, quartic ...
 * One file in primitive/ and one row in primitive/list.h each.
 *
 * Everything is in the shape's own space, in double precision. A shape gives
 * *all* crossings of the whole line, and tells whether a point is inside;
 * CSG, clipping and shadows are made of these two (world/solid). */
#ifndef SCENE_PRIMITIVE_H
#define SCENE_PRIMITIVE_H

#include "base/affine.h"
#include "base/arena.h"
#include "base/field.h"
#include "scene/cell.h"
#include "scene/patch.h"
#include "scene/rays.h"

/* What bounded_by does to a shape that is no part of CSG (measured). */
enum primitive_bounds {
    BOUNDS_AS_BOX,   /* a ray must meet the box around it */
    BOUNDS_IGNORED,  /* as if it were not there */
    BOUNDS_AS_SHAPE, /* a ray must meet it */
};

struct primitive {
    const char *name; /* the keyword */
    const char *help; /* one line for --list and the man page */
    size_t size;      /* of the shape's own struct, zeroed before reading */
    /* Read in this order, commas optional: sphere { CENTRE, RADIUS ... */
    const struct field *arguments;
    /* Then anywhere among the object's modifiers (`open`); may be NULL. */
    const struct field *items;
    bool solid;  /* has an inside: may be a part of intersections */
    bool beyond; /* its inside reaches beyond its bounds (disc) */
    bool some;   /* intersect tells the first few crossings only */
    bool convex; /* a box whose corners are inside is inside */
    bool alike;  /* its fields say all of it, and preparing takes long: what is
                  * written again is kept once */
    enum primitive_bounds bounded;

    /* After reading: precomputes (NULL: nothing to do). Returns NULL, or why
     * the shape is impossible ("its two ends are the same point"). Sets
     * *warning instead when POV-Ray only warns; the shape is then left out of
     * the scene. */
    const char *(*prepare)(void *shape, struct arena *arena,
                           const char **warning);
    /* What is warned of, as by POV-Ray, though the shape is drawn; the callback
     * or what it returns NULL: nothing. */
    const char *(*remark)(const void *shape);
    /* Whether POV-Ray sees it in intersections and differences alone, as a
     * sphere whose radius is negative; NULL: no. */
    bool (*unseen)(const void *shape);
    /* May be infinite in some directions. */
    struct box3 (*bounds)(const void *shape);
    /* The box around it, moved by `place`, that min_extent and max_extent tell,
     * where POV-Ray's is larger (measured). NULL: around the bounds. */
    struct box3 (*told)(const void *shape, const affine *place);
    /* Instead of `told`, of what keeps its form when it is moved so: the box
     * around it, where `place` turns, shifts and scales alike along all axes.
     * NULL: it has no such form. */
    struct box3 (*ball)(const void *shape, const affine *place);
    /* Around the part of the inside that is in the box, or empty; NULL: no
     * better known than the bounds. */
    struct box3 (*within)(const void *shape, struct box3 box);
    /* The inside is all points p with normal.p <= distance; NULL: it isn't. */
    void (*half_space)(const void *shape, vec3 *normal, double *distance);
    /* `shape`, a copy, moved as POV-Ray moves it to the last bit (measured),
     * so that rays are met where they are; false: it can't be, rays must be
     * taken into its space. NULL: always so. */
    bool (*move)(void *shape, const affine *outward, const affine *inward);
    void (*intersect)(const void *shape, const struct ray *ray,
                      struct hits *hits);
    /* As intersect from t = 0 on, for trace(): with the error that POV-Ray's
     * has, since scenes place other things by what it tells. NULL: intersect.
     */
    void (*traced)(const void *shape, const struct ray *ray, struct hits *hits);
    /* Calls visit for the crossings between tmin and tmax, by increasing t,
     * until it returns true. NULL: there are no more than HITS_MAX, and
     * intersect tells them all. */
    void (*crossings)(const void *shape, const struct ray *ray, double tmin,
                      double tmax, hit_visit *visit, void *context);
    /* Whether the ray meets the surface at a t between tmin and tmax. NULL:
     * intersect says it as quickly. */
    bool (*crosses)(const void *shape, const struct ray *ray, double tmin,
                    double tmax);
    /* The same, and where it does first; NULL likewise. */
    bool (*first)(const void *shape, const struct ray *ray, double tmin,
                  double tmax, struct hit *hit);
    /* The same of a ray that is no line but a cone, of that radius where it is
     * one unit of t long: what is smaller than the cone there may be missed,
     * and t may be off by as much, to the side that the ray comes from. hit
     * NULL: only whether it meets it. NULL: it takes no less time. */
    bool (*first_roughly)(const void *shape, const struct ray *ray, double tmin,
                          double tmax, double spread, struct hit *hit);
    /* crosses and first of the run's rays side by side, each as those have it
     * to the bit; of the others nothing is said. NULL: one by one. */
    void (*crosses_many)(const void *shape, struct lane_run run,
                         const struct rays *rays, const struct rays_span *span,
                         lane_flag *met);
    void (*first_many)(const void *shape, struct lane_run run,
                       const struct rays *rays, const struct rays_span *span,
                       struct rays_met *met);
    /* The first of what intersect tells, if that is not all that first would:
     * nearer than the span's, too. NULL: first_many. */
    void (*told_many)(const void *shape, struct lane_run run,
                      const struct rays *rays, const struct rays_span *span,
                      struct rays_met *met);
    /* These look at some of the rays one by one: those whose crossings nobody
     * wants are worth leaving out. */
    bool lane_by_lane;
    /* intersect of rays side by side, to the bit, of what has at most
     * RAY_CROSSINGS; NULL: one by one. */
    void (*all_many)(const void *shape, struct lane_run run,
                     const struct rays *rays, struct rays_crossings *all);
    /* crossings of those of the run's rays that have a span, in rounds: of each
     * in its order. NULL: one by one. */
    void (*crossings_many)(const void *shape, struct lane_run run,
                           const struct rays *rays,
                           const struct rays_span *span, rays_visit *visit,
                           void *context);
    /* Outward (the side POV-Ray calls outside), any length, not zero. The point
     * by its place: what is handed on by value is copied two numbers at a time
     * and waits for each of them to be written. */
    vec3 (*normal)(const void *shape, const vec3 *point, const struct hit *hit);
    /* The same where normals depend on how the shape stands, to which
     * to_object leads; NULL: as it is. Itself NULL: they don't. */
    vec3 (*normal_placed)(const void *shape, const vec3 *point,
                          const struct hit *hit, const affine *to_object);
    /* Where normals are interpolated, that of the facet that was hit, of any
     * length; 0 elsewhere. NULL: nowhere. */
    vec3 (*face)(const void *shape, const struct hit *hit);
    /* The surface's own coordinates at one of its points, for uv_mapping; NULL:
     * it has none, and x and y of the world are taken (measured). */
    void (*uv)(const void *shape, vec3 point, double uv[2]);
    /* NULL when not solid. */
    bool (*inside)(const void *shape, vec3 point);
    /* The same of points side by side; NULL: one by one. */
    void (*inside_many)(const void *shape, struct lane_run run,
                        const struct lane_points *points, lane_flag *inside);
    /* What the cell may meet: CELL_SURFACE, CELL_BORDER (see cell.h). Leaves
     * out nothing that it meets; says a little more than is true, the less the
     * smaller the cell. NULL: searched with rays, which may miss thin parts. */
    unsigned (*meets)(const void *shape, const struct cell *cell);
    /* Parts that cover the surface, at most PATCHES_MAX; returns how many.
     * NULL: as a lamp it is found by chance alone. */
    int (*patches)(const void *shape, struct patch *patches);
};

/* The shape as the map moves it, new in `arena`, or NULL if it must keep its
 * map. */
const void *primitive_moved(struct arena *arena,
                            const struct primitive *primitive,
                            const void *shape, const affine *map);

/* The primitive whose keyword is `name`, or NULL. */
const struct primitive *primitive_find(const char *name);

/* Number `index` of the list, or NULL past its end. */
const struct primitive *primitive_at(size_t index);

#endif
