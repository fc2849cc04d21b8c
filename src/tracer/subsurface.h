/* Light that comes out of a surface elsewhere than it went in: finish
 * { subsurface }, in scenes whose global_settings { subsurface } turn it on.
 * Elsewhere, and for light that goes on to other surfaces, such a finish is a
 * diffuse one that sends back as much. */
#ifndef TRACER_SUBSURFACE_H
#define TRACER_SUBSURFACE_H

#include "tracer/crossing.h"
#include "tracer/tracer.h"

/* Whether there may be any: where light goes in, in such a scene. */
static inline bool subsurface_happens(const struct tracer *tracer,
                                      const struct crossing *crossing)
{
    return tracer->scene->settings.subsurface.on && !crossing->leaving &&
           tracer->quality >= QUALITY_FOG;
}

/* Takes the diffuse light of those layers of the surface that light goes
 * through, and leaves them without: to be called before the surface is lit, if
 * it happens. */
rgb subsurface_light(const struct tracer *tracer, struct worker *worker,
                     enum ray_kind kind, struct crossing *crossing);

#endif
