/* All lamps of a scene, and what part of each one's light gets to a point:
 * shadow rays, for area lights a grid of them. What every lighting method that
 * casts shadow rays shares. */
#ifndef SHADE_LAMPS_H
#define SHADE_LAMPS_H

#include "base/worker.h"
#include "world/world.h"
#include "shade/interior.h"
#include "shade/lamp.h"
#include "shade/shadow.h"

struct lamps {
    const struct world *world;
    const struct scene *scene;
    struct lamp *items;
    size_t count;
    size_t soft;   /* how many of them are (lamps_soft) */
    int quality;   /* +Q */
    bool photons;  /* they bring the light that is bent on its way */
    uint64_t seed; /* of the jitter of area lights */
    bool foggy;    /* fogs or media between objects weaken light, if the lamp
                    * says so */
    bool misty;    /* media do */
    bool clear;    /* there are shadows, and but for fogs surfaces alone cast
                    * them */
    bool plain;    /* and these are opaque */
    bool shadows;  /* there are some */
    bool smooth;   /* bumps are left out */
};

/* Frees with lamps_free. World and scene must outlive it. */
struct lamps lamps_new(const struct world *world, const struct scene *scene,
                       int quality, uint64_t seed);
void lamps_free(struct lamps *lamps);

/* Whether the quality asks for the lamp's true, soft shadow. */
bool lamps_soft(const struct lamps *lamps, const struct lamp *lamp);

/* Whether fogs and media between objects weaken its light. */
static inline bool lamps_dim(const struct lamps *lamps, const struct lamp *lamp)
{
    return lamps->foggy && lamp->light->media_attenuation;
}

/* Whether on the way from any of its places only surfaces take something of its
 * light. */
static inline bool lamps_clear_ways(const struct lamps *lamps,
                                    const struct lamp *lamp)
{
    const struct light *light = lamp->light;
    return lamps->clear && !light->shadowless && !light->pane &&
           !lamps_dim(lamps, lamp);
}

/* Whether one ray tells what of its light gets to a point, of which only
 * surfaces on the way take something; and whether all or nothing does. */
static inline bool lamps_clear(const struct lamps *lamps,
                               const struct lamp *lamp)
{
    return !lamp->light->area && lamps_clear_ways(lamps, lamp);
}

/* Whether shadow_falls_many, with these around, tells for several ways to a
 * lamp at once what gets along them; and whether one of them tells what of its
 * light gets to a point. */
static inline bool lamps_ways_together(const struct lamps *lamps,
                                       const struct lamp *lamp)
{
    return lamps->shadows && !lamp->light->shadowless && !lamp->light->pane;
}

static inline bool lamps_together(const struct lamps *lamps,
                                  const struct lamp *lamp)
{
    return !lamp->light->area && lamps_ways_together(lamps, lamp);
}

static inline struct shadow_around
lamps_around(const struct lamps *lamps, const struct lamp *lamp,
             const struct interiors *const *inside)
{
    return (struct shadow_around){
        .inside = inside,
        .fog = lamps_dim(lamps, lamp) ? lamps->scene : NULL,
        .misty = lamps->misty,
        .smooth = lamps->smooth,
        .photons = lamps->photons ? &lamp->light->photons : NULL,
    };
}

static inline bool lamps_plain(const struct lamps *lamps,
                               const struct lamp *lamp)
{
    return lamps->plain && lamps_clear(lamps, lamp);
}

/* Where the lamp's light comes from: its location, or of an area light a point
 * as of area_anywhere, drawn by two numbers in [0,1). */
vec3 lamps_location(const struct lamps *lamps, const struct lamp *lamp,
                    vec3 point, const double u[2]);

/* A point that looks at a lamp. */
struct lamp_target {
    vec3 point;
    const struct interiors *inside; /* bodies the point is in; may be NULL */
    struct lamp_view view;          /* of the lamp's centre, by lamp_look */
    const struct leaf *leaf;        /* what it is on; NULL: in the open */
    vec3 face;     /* the unit, true, outward normal there, if it is */
    double spread; /* of ways to the lamp: see world_glimpse */
};

/* The share of the lamp's light that is not in shadow, tinted by filters:
 * white without shadows. Black once the worker is told to stop. */
rgb lamps_share(const struct lamps *lamps, const struct lamp *lamp,
                struct worker *worker, const struct lamp_target *target);

/* The same of one that is plain. */
static inline rgb lamps_share_plain(const struct lamps *lamps,
                                    const struct lamp *lamp,
                                    struct worker *worker, vec3 point,
                                    const struct lamp_view *view)
{
    bool dark = shadow_falls(lamps->world, worker, point, view->direction,
                             view->distance, lamp->number);
    return rgb_grey(dark ? 0 : 1);
}

/* The same, nearer the true share of an area light where there are few. */
rgb lamps_share_fine(const struct lamps *lamps, const struct lamp *lamp,
                     struct worker *worker, const struct lamp_target *target);

/* The piece of a surface around a target: within `radius` of it, with normals
 * that differ from its own by `bend` at most. */
struct lamp_piece {
    struct lamp_target middle;
    double radius, bend;
};

/* Whether nothing can cast a shadow of the lamp there: what is white by
 * lamps_share in all of it. The lamp must be soft. False where that isn't to be
 * told in a moment. */
bool lamps_open(const struct lamps *lamps, const struct lamp *lamp,
                const struct lamp_piece *piece);

/* How wide the lamp's penumbras are at least, in units of the world, on the
 * piece; HUGE_VAL: nothing casts a shadow there, and
 * the share is white. Widths below `enough` aren't told apart. The lamp must be
 * soft. */
double lamps_blur(const struct lamps *lamps, const struct lamp *lamp,
                  const struct lamp_piece *piece, double enough);

/* The share of one shadow ray to where target->view looks: a point of the
 * lamp. */
rgb lamps_share_point(const struct lamps *lamps, const struct lamp *lamp,
                      struct worker *worker, const struct lamp_target *target);

#endif
