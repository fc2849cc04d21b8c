/* What media make of a stretch of a ray. */
#ifndef SHADE_MEDIA_H
#define SHADE_MEDIA_H

#include "base/worker.h"
#include "scene/medium.h"
#include "scene/scene.h"
#include "shade/background.h"
#include "shade/interior.h"

struct lamp;
struct lamps;
struct photon_map;
struct media_beams;

/* All that fill one place. */
struct media_list {
    int count;
    const struct medium *at[MEDIA_MAX];
    bool scatters;
    bool dark; /* they only absorb */
};

/* Fills the list with what a ray inside of these goes through: nothing if not
 * all of them are hollow. `everywhere`: media of the scene; NULL: without. */
void media_find(struct media_list *list, const struct media *everywhere,
                const struct interiors *inside);

/* A stretch of a ray. */
struct media_way {
    const struct media_list *media;
    vec3 origin, direction;    /* unit */
    double length;             /* may be infinite */
    const struct leaf *end;    /* what it ends at; NULL: nothing */
    const struct lamps *lamps; /* that light it; NULL: none, and it doesn't
                                * glow: shadow rays */
    const struct media_beams *beams;  /* of the lamps; NULL: all of them may
                                       * light all of the way */
    const struct photon_map *photons; /* within the media; NULL: none */
    struct worker *worker;
    const struct interiors *inside;
};

/* The light that they add on the way, and the share of what is behind that
 * they let pass. Its value depends on the way alone. */
struct veil media_veil(const struct media_way *way);

/* How rays are infinite. */
extern const double media_horizon;

/* One lit part of the way: from and to, in units of the way. */
struct media_part {
    double from, to;
    bool lit;
};

enum { MEDIA_PARTS_MAX = 129 };

/* Which lamps light the way, in their order, and from where to where. */
enum { MEDIA_BEAMS_MAX = 64 };

struct media_beams {
    int count; /* -1: there are more, and any may light any of it */
    struct media_beam {
        const struct lamp *lamp;
        double from, to; /* in units of the way */
    } at[MEDIA_BEAMS_MAX];
};

/* Cuts the way into parts that spots and cylinder lights do and don't light, in
 * order; returns how many, at least one. Fills in the beams. */
int media_parts(const struct media_way *way, struct media_beams *beams,
                struct media_part parts[MEDIA_PARTS_MAX]);

#endif
