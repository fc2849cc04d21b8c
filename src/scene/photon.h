/* What a scene says of photons: light that lamps send to chosen objects, which
 * mirror and refract it on to others (caustics). Words and defaults are
 * POV-Ray's. */
#ifndef SCENE_PHOTON_H
#define SCENE_PHOTON_H

#include <stdbool.h>

/* photons {} of global_settings. A number that is 0 was not said. */
struct photon_settings {
    bool on;
    double spacing;      /* between photons at their target, units */
    double count;        /* of all that are sent, if spacing was not said */
    double gather[2];    /* at a place, least and most; 20, 100 */
    double radius;       /* of a place, units; 0: by how dense they are */
    double radius_share; /* multiplies either, 1 */
    double steps; /* in a stretch of media, at most; 0: none stay there */
    double step;  /* of one, in spacings, 1 */
    double media_radius, media_radius_share; /* as the two above, in media */
    double jitter;       /* of directions, 0.4 of the spacing */
    int max_trace_level; /* 0: the scene's, as are these: */
    double adc_bailout;
};

/* Where nothing, or nothing of this, was said. */
struct photon_settings photon_settings_default(void);

enum photon_said { PHOTON_UNSAID, PHOTON_ON, PHOTON_OFF };

/* photons {} of an object or of a lamp. */
struct photon_flags {
    enum photon_said refraction, reflection;
    bool target;    /* of an object: lamps send photons there */
    double spacing; /* multiplies the distance of those, 1 */
    bool passed;    /* `pass_through`: it is no target */
    bool unlit;     /* `collect off`: they don't light it */
    bool area;      /* of a lamp: they come from all of its area */
};

/* Says what an object makes of photons that nobody gave a block. */
extern const struct photon_flags photon_flags_default;

/* Whether it happens if a lamp and an object say this: somebody asks for it and
 * nobody forbids it (measured). */
static inline bool photon_happens(enum photon_said lamp,
                                  enum photon_said object)
{
    return (lamp == PHOTON_ON || object == PHOTON_ON) && lamp != PHOTON_OFF &&
           object != PHOTON_OFF;
}

#endif
