/* Light that comes straight from what shines: next-event estimation (Kajiya
 * 1986; Shirley, Wang and Zimmerman 1996 for area lights), with balance
 * heuristic weights (Veach and Guibas 1995) for what glows, because rays that a
 * surface scatters find that too. Lamps have no surface and are found here
 * alone. */
#ifndef TRACER_DIRECT_H
#define TRACER_DIRECT_H

#include "base/draw.h"
#include "tracer/light_set.h"
#include "tracer/tracer.h"

/* Who asks for light: a surface or a probe. */
struct receiver {
    vec3 point;
    const struct interiors *inside, *behind; /* on the normal's side, and on
                                              * the other */
    vec3 normal; /* tells the sides apart; zero: there is only `inside` */
    /* What it makes of white light from a direction; `lamp`: a lamp's, not
     * radiance; `highlights`: with those, which no shadowless lamp and nothing
     * that glows makes. */
    rgb (*response)(const void *context, vec3 direction, bool lamp,
                    bool highlights);
    /* The density of the rays it scatters there; 0: it scatters none. */
    double (*density)(const void *context, vec3 direction);
    const void *context;
    const struct leaf *leaf; /* what it is on, or, in media, what ends its
                              * ray; NULL: any lamp lights it, or any of no
                              * light_group */
    bool straight;           /* photons bring nothing to it */
    bool in_media;           /* that lamps may say they don't light */
};

/* The bodies that light to this direction goes through. */
const struct interiors *receiver_inside(const struct receiver *receiver,
                                        vec3 direction);

/* Unbiased estimates of it: of lamps, without a look at receiver->density
 * (`every`: all are asked if they are few, and not one of them chosen), and of
 * what glows. */
rgb direct_lamps(const struct tracer *tracer, struct worker *worker,
                 const struct receiver *receiver, const struct draws *draws,
                 bool every);
rgb direct_emitters(const struct tracer *tracer, struct worker *worker,
                    const struct receiver *receiver, const struct draws *draws);

/* The weight of a ray of `density` that `from` scattered and that met something
 * glowing at `at`. */
double direct_weight(const struct light_set *set, vec3 from, vec3 direction,
                     double density, const struct intersection *at);

#endif
