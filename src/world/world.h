/* The world: the scene made ready for rays. Embree finds what is bounded,
 * infinite objects are tested beside it (Embree loses bounds of 1e20).
 * Const after world_new; any number of threads may ask. */
#ifndef WORLD_WORLD_H
#define WORLD_WORLD_H

#include "world/shaft.h"
#include "world/solid.h"
#include "scene/light.h"
#include "scene/rays.h"
#include "scene/scene.h"
#include "text/diag.h"

struct world;

/* Builds on `threads` threads. `camera_rays` is about how many will be sent,
 * 0 for very many: few rays don't repay a thorough build of many triangles.
 * Returns NULL after an error was printed. The scene must outlive the world. */
struct world *world_new(const struct scene *scene, unsigned threads,
                        double camera_rays, struct diag *diag);
void world_free(struct world *world);

/* Light number `light` of world_lights alone lights from now on: the others
 * are black. Not while rays are traced. */
void world_solo(struct world *world, size_t light);

/* All lights, those in unions too, moved to where they are; file order. Several
 * that differ in their colours alone, or by next to nothing in their places,
 * are one, with the sum of these. */
const struct light *world_lights(const struct world *world, size_t *count);

/* Whether nothing in it lets any light pass. */
bool world_is_opaque(const struct world *world);

enum ray_kind {
    RAY_CAMERA,     /* sees all but no_image objects */
    RAY_REFLECTION, /* all but no_reflection objects */
    RAY_SIGHT,      /* as the camera, but for clear objects */
    RAY_GATHER,     /* as reflections, but for clear objects */
    RAY_PHOTON,     /* all but no_shadow objects */
    RAY_OBSTACLE,   /* the same but for clear objects */
};

/* Where a ray meets the scene. */
struct intersection {
    double t;
    vec3 point;
    vec3 normal; /* unit, interpolated on meshes; outward, which for a leaf
                  * turned inside out is into the shape */
    vec3 face;   /* unit, the true one of the triangle, on the normal's side */
    const struct leaf *leaf;
    int part;                      /* of a mesh: the triangle */
    const struct texture *texture; /* the leaf's, or the triangle's own */
    const affine *to_texture, *from_texture; /* world <-> its space */
};

/* The nearest crossing with t > tmin, ray.direction unit. `tmin` is a small
 * offset; crossings beyond 1e7 units don't exist (as in POV-Ray). */
bool world_closest(const struct world *world, const struct ray *ray,
                   double tmin, enum ray_kind kind, struct intersection *out);

/* The surface's own coordinates there, (u, v, 0); of surfaces that have none x
 * and y of the point. */
vec3 world_uv(const struct intersection *at);

/* The least there is to know of where a ray meets the scene. */
struct world_hit {
    const struct leaf *leaf; /* NULL: nowhere */
    struct hit hit;          /* u and v of a shape, not of a triangle */
};

enum { WORLD_RAYS = RAY_LANES };

/* The same for the first so many rays, within the span of each, which is twice
 * as quick if they begin and go close together, as those of neighbouring pixels
 * do; the others should be as one of these (rays_fill). RAY_GATHER among many
 * things go one by one. */
void world_closest_many(const struct world *world, const struct rays *rays,
                        const struct rays_span *span, unsigned count,
                        enum ray_kind kind, struct world_hit *out);

/* Everything about a hit of that ray; its leaf must not be NULL. */
void world_describe(const struct ray *ray, const struct world_hit *hit,
                    struct intersection *out);

/* Of hits side by side what an intersection says, to the bit; where there is
 * no hit, zeroes and the ray's origin. */
struct world_faces {
    LANE_LINES double point[3][RAY_LANES], normal[3][RAY_LANES];
    struct hit hit[RAY_LANES]; /* u and v of triangles, too */
};

/* Of the hits that the bits `lanes` stand for. */
void world_face_many(const struct rays *rays, const struct world_hit *hits,
                     unsigned lanes, struct world_faces *faces);

/* The unit normal of the facet that number `i` is on, which is not even
 * interpolated, to the same side as the normal. */
vec3 world_face_side(const struct leaf *leaf, const struct world_faces *faces,
                     unsigned i);

/* As world_uv, of number `i`. */
vec3 world_face_uv(const struct leaf *leaf, const struct world_faces *faces,
                   unsigned i);

/* What a leaf is painted with somewhere. */
struct world_coat {
    const struct texture *texture;
    const affine *to_texture, *from_texture; /* world <-> the texture's space */
};

/* The same, where a ray of that direction meets it. */
struct world_coat world_face_coat(const struct leaf *leaf,
                                  const struct world_faces *faces, unsigned i,
                                  vec3 direction);

/* As world_describe, of number `i` of these. */
void world_describe_face(const struct ray *ray, const struct leaf *leaf,
                         const struct world_faces *faces, unsigned i,
                         struct intersection *out);

/* The same as world_closest, for crossings up to tmax. */
bool world_within(const struct world *world, const struct ray *ray, double tmin,
                  double tmax, enum ray_kind kind, struct intersection *out);

struct glimpse {
    double tmin, tmax, spread;
};

/* As world_within, of a ray that stands for a cone of that radius at a distance
 * of 1: where that takes less time, crossings are found no more exactly, and
 * a little before they come rather than after. */
bool world_glimpse(const struct world *world, const struct ray *ray,
                   struct glimpse glimpse, enum ray_kind kind,
                   struct intersection *out);

/* Called for every crossing that may let light pass (leaf->look->opaque false),
 * in any order; returns true when the light is all blocked and no more
 * crossings are wanted. world_describe tells the rest, which few panes ask for.
 */
typedef bool world_filter(void *context, const struct ray *ray,
                          const struct world_hit *hit);

/* What world_occluded is asked. */
struct occlusion {
    const struct ray *ray; /* its direction is unit */
    double tmin, tmax;
    int light;            /* what looks like this one doesn't count; -1: none */
    world_filter *filter; /* or NULL */
    void *context;        /* of the filter */
    double spread;        /* as of a glimpse */
};

/* Whether an opaque thing lies on the ray between tmin and tmax, or the filter
 * said blocked; without one whatever lies there, unless it is clear. no_shadow
 * leaves don't count. */
bool world_occluded(const struct world *world,
                    const struct occlusion *occlusion);

/* The same of ray number `lane` of several. */
typedef bool world_lane_filter(void *context, unsigned lane,
                               const struct world_hit *hit);

/* Ways to one lamp, as above. */
struct occlusions {
    struct rays rays;
    struct rays_span span;
    int light;
    world_lane_filter *filter; /* or NULL */
    void *context;             /* of the filter */
    const struct shaft *shaft; /* they are all in it, the rays to the places
                                * of these coordinates; NULL: in none */
    const double (*place)[RAY_LANES];
};

/* Bit by bit what is so of a ray. */
struct occluded {
    unsigned dark;  /* something opaque is on the way */
    unsigned panes; /* something that may let light pass is, or may be, and the
                     * filter was not asked; no more is known */
};

/* The same of several, those of the bits `lanes`, as world_occluded_in has it
 * if they are in a shaft; of few nothing may be found
 * out, if there is anything that lets light pass. Several times as quick if
 * they begin and go close together. */
struct occluded world_occluded_many(const struct world *world,
                                    const struct occlusions *asked,
                                    unsigned lanes);

/* How far a ray to light number `light` goes until it meets what that light
 * shines through alone; tmax if it shines through nothing, negative if it
 * misses it. */
double world_pane(const struct world *world, int light, const struct ray *ray,
                  double tmin, double tmax);

/* What may stand in the way of rays that world_occluded_in is asked about.
 * Crowded if no light has an area, or there are very many things. */
void world_shaft(const struct world *world, const struct shaft_rays *rays,
                 struct shaft *shaft);

/* How wide penumbras are, at least, as shaft_blur has it. 0 if nothing is known
 * of shafts. */
double world_blur(const struct world *world, const struct shaft_rays *rays,
                  double enough);

/* The same as world_occluded, for the ray of the shaft to the place of these
 * coordinates: the sooner the less there is on the way. */
bool world_occluded_in(const struct world *world, const struct shaft *shaft,
                       const double place[2],
                       const struct occlusion *occlusion);

/* Calls visit for every leaf whose inside holds the point (CSG and clips
 * respected), in file order: the interiors a camera starts in. */
void world_containing(const struct world *world, vec3 point,
                      void (*visit)(void *context, const struct leaf *leaf),
                      void *context);

/* Whether world_containing is known to find the same for all points of the box.
 */
bool world_contains_alike(const struct world *world, struct box3 box);

/* Calls `solid` for every shape and CSG object, and `mesh` for every mesh that
 * is no part of one; always in the same order. */
void world_visit(const struct world *world,
                 void (*solid)(void *context, const struct solid *solid),
                 void (*mesh)(void *context, const struct leaf *leaf),
                 void *context);

/* How many targets of photons there are: leaf->look->target is 1 to that. */
unsigned world_targets(const struct world *world);

/* Sizes for --stats and for lighting methods. */
size_t world_leaf_count(const struct world *world);
size_t world_triangle_count(const struct world *world);
struct box3 world_bounds(const struct world *world); /* of what is bounded */

#endif
