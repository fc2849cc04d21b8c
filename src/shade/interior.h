/* What a ray is inside of, and what the matter there does to it. */
#ifndef SHADE_INTERIOR_H
#define SHADE_INTERIOR_H

#include <string.h>

#include "base/rgb.h"
#include "world/solid.h"

enum { INTERIORS_MAX = 64 }; /* deeper nesting is not noticed */

struct interior_entry {
    const struct interior *interior; /* may be NULL */
    unsigned body;
    bool hollow;
};

/* The bodies a ray is inside of, the last entered last. */
struct interiors {
    int count;
    bool divided; /* the ray is of one colour, at: */
    double place; /* in the spectrum (shade/spectrum.h) */
    struct interior_entry at[INTERIORS_MAX];
};

/* The body's place in the list, or -1 when the ray is not inside it. */
int interiors_find(const struct interiors *list, unsigned body);

/* Crossing a surface of the body: in when it was out, out when it was in. */
void interiors_cross(struct interiors *list, const struct leaf *leaf);

/* Copies the part in use only, which is mostly nothing. */
static inline void interiors_copy(struct interiors *to,
                                  const struct interiors *from)
{
    to->count = from->count;
    to->divided = from->divided;
    to->place = from->place;
    if (from->count > 0)
        memcpy(to->at, from->at, (size_t)from->count * sizeof from->at[0]);
}

/* A list without bodies, for white light. */
void interiors_clear(struct interiors *list);

/* Refractive index of one body's interior, which may be NULL, for the light of
 * this ray. */
double interiors_ior_of(const struct interiors *list,
                        const struct interior *interior);

/* Refractive index of the body entered last, 1 in the open. */
static inline double interiors_ior(const struct interiors *list)
{
    return list->count == 0
               ? 1
               : interiors_ior_of(list, list->at[list->count - 1].interior);
}

/* Fog reaches the ray: all it is inside of is hollow. */
bool interiors_open(const struct interiors *list);

/* The share of light left after `distance` inside; white without a
 * fade_distance. */
rgb interior_fade(const struct interior *interior, double distance);

/* Whether light on its way from a lamp is dimmed too: that needs a fade_power
 * above 0, while what the eye sees is dimmed by any (measured). */
bool interior_dims_shadows(const struct interior *interior);

#endif
