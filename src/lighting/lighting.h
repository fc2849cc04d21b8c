/* The one question the tracer asks: what light reaches this surface point?
 * Each method is one file beside this one and one row of list.h; the tracer,
 * the finishes and the tests never know which is at work. (An integrator that
 * asks none has one too, without `illuminate`: tracer/integrator.h.)
 *
 * A method answers in two parts: light from known directions (lamps), one
 * light_sample each, which diffuse reflection and highlights both use; and
 * light without a direction (ambient, interreflection), an irradiance in
 * POV-Ray's units: Lambert is diffuse * pigment * irradiance, no pi. */
#ifndef LIGHTING_LIGHTING_H
#define LIGHTING_LIGHTING_H

#include "base/memory.h"
#include "base/worker.h"
#include "shade/first_hits.h"
#include "shade/surface.h"

struct pieces_kept;

/* What a method knows after a picture, to be used in the next: frees with
 * lighting_forget. */
struct lighting_kept {
    void *bytes; /* NULL: nothing */
    size_t size;
    uint64_t family; /* the same of all that may be used in one picture */
    bool inside;     /* begun in a chamber: it knows what lights it, */
    struct pieces_kept *pieces; /* and how that was cut, or NULL */
};

static inline void lighting_forget(struct lighting_kept *kept)
{
    memory_free(kept->bytes);
    memory_free(kept->pieces);
    *kept = (struct lighting_kept){ .bytes = NULL };
}

/* When that may be used. */
enum kept_use {
    KEPT_SCENE, /* of the same scene, seen from nearly as near */
    KEPT_SAME,  /* only where the picture is the one without it */
    KEPT_ONLY,  /* as KEPT_SCENE; without it `start` gives NULL, silently */
};

/* Frames of an animation around one, and that itself, as the same method has
 * lit them: by which its light may be smoothed, lest it flickers. */
enum { MOMENTS_REACH = 2, LIGHTING_MOMENTS = 2 * MOMENTS_REACH + 1 };
struct lighting_moments {
    size_t count; /* 0: there are none */
    size_t now;   /* which is the frame itself */
    const void *state[LIGHTING_MOMENTS];
    double weight[LIGHTING_MOMENTS];
};

struct lighting_options {
    unsigned threads;
    int quality;       /* +Q, 0..11 */
    int width, height; /* of the picture, pixels; 0: any */
    unsigned long long seed;
    bool numbers;           /* light is wanted as numbers, at whatever places */
    const atomic_int *stop; /* non-zero: leave off; NULL: never */
    bool keep;              /* `keep` will be called */
    const struct lighting_kept *kept; /* by the picture before, or NULL; used
                                       * only if it is of the same scene, */
    enum kept_use kept_use;           /* and this */
    bool root;    /* the picture is one of an animation, and that is its root's:
                   * where something moves its plan counts, too */
    bool smooths; /* its light will be one of the moments of others, and */
    const struct lighting_moments *moments; /* of the picture, or NULL; outlive
                                             * the state */
};

struct facets;
struct facets_diffuse;
struct lamps;
struct show;

/* Something to see of what a method knows: --show NAME. */
struct lighting_view {
    const char *name;
    const char *help;
    /* Its points and lines, once the picture is done (lighting/show.h). */
    void (*give)(const void *state, struct show *show);
    const char *needs; /* what to type if there are none; or NULL */
};

/* Takes one light_sample. */
typedef void light_visit(void *context, const struct light_sample *sample);

/* Takes a line of --stats: what, how much, and its unit or ""; NAN: the unit
 * says all. */
typedef void lighting_row(void *context, const char *what, double amount,
                          const char *unit);

struct lighting {
    const char *name;
    const char *help;
    /* State for one picture, or NULL after an error was printed, or when it was
     * stopped. */
    void *(*start)(const struct world *world, const struct scene *scene,
                   const struct lighting_options *options, struct diag *diag);
    void (*finish)(void *state);
    /* Whether light that is asked of it is worth smoothing by moments. NULL:
     * never. */
    bool (*by_moments)(const void *state);
    /* Whether the method wants to know what the camera sees first at all places
     * of a grid (whose `at` is not there yet) before it lights any of it; then
     * `prepare` is called, with a worker for each thread, and `at` is the
     * method's, to be given back by memory_free: what it knows may be looked at
     * when all is drawn. It may leave off when they are told to stop. It may
     * lower the grid's apron. Of a picture in bands each is asked about in its
     * turn. NULL: never. */
    bool (*foresees)(void *state, struct first_hits *grid);
    void (*prepare)(void *state, const struct first_hits *hits,
                    struct worker *const *workers, unsigned threads);
    /* Light at a surface point. Must depend on the surface, and on what the
     * camera was said to see near it, alone: not on the worker or on what was
     * asked before. */
    struct diffuse_light (*illuminate)(const void *state, struct worker *worker,
                                       const struct surface *surface,
                                       light_visit *visit, void *context);
    /* The same of all facets that are set, to the bit, the sooner the closer
     * together they are: what lamps give is added to the light of each, and the
     * light without a direction put into `diffuse`. NULL: one by one. */
    void (*illuminate_many)(const void *state, struct worker *worker,
                            struct facets *facets,
                            struct facets_diffuse *diffuse);
    /* Whether surfaces may be lit in any order, those of one pixel
     * (picture_place.pixel) too; asked if there is illuminate_many. */
    bool (*in_any_order)(const void *state);
    /* The lamps, which light media as they do under `rays`. NULL where
     * illuminate is. */
    const struct lamps *(*lamps)(const void *state);
    /* What it took, for --stats; may be NULL. */
    void (*tell)(const void *state, lighting_row *row, void *context);
    /* What is known by now, for the next picture or for --mesh-save. NULL:
     * the method has nothing to keep. */
    struct lighting_kept (*keep)(const void *state);
    /* Where light comes from at any place: the sum of unit directions, each
     * times the brightness of its light. `normal` is that of the surface there,
     * or zero. NULL: the method doesn't know. */
    vec3 (*stream)(const void *state, struct worker *worker, vec3 place,
                   vec3 normal);
    /* Ends with one without a name. NULL: there is nothing to see. */
    const struct lighting_view *views;
};

/* By name, or NULL; by number, or NULL past the end. The first is the
 * default. */
const struct lighting *lighting_find(const char *name);
const struct lighting *lighting_at(size_t index);

/* What a scene is lit by when `chosen` is to light it: `paper` in place of
 * `mesh` where it says light_mesh { model scalar }. */
const struct lighting *lighting_for(const struct lighting *chosen,
                                    const struct scene *scene);

/* The method's view of that name, or NULL. */
const struct lighting_view *lighting_view(const struct lighting *lighting,
                                          const char *name);

#endif
