/* Photons: what lamps send to targets and these send on, kept where it lands on
 * other things (Jensen 2001, chapter 5). As POV-Ray does it (measured):
 * - A photon carries the light of a cone around its way, and is worth what the
 *   lamp would give at its distance along the whole way.
 * - On its way to its target it passes only what is clear, straight on.
 * - From there each surface mirrors and refracts it, if the lamp or the object
 *   says so and neither forbids it; else it ends.
 * - It is kept wherever it lands after its first target, but on what says
 *   `collect off`. What is no_shadow or no_image it does not see. */
#ifndef TRACER_PHOTONS_H
#define TRACER_PHOTONS_H

#include "shade/photon_map.h"
#include "text/diag.h"
#include "tracer/tracer.h"

/* Sends all photons of the scene; the tracer must not use any yet. *map: what
 * is kept, photon_map_free; NULL if the scene sends none. False if it was
 * stopped, or after an error was printed. */
bool photons_send(const struct tracer *tracer, unsigned threads,
                  const atomic_int *stop, struct diag *diag,
                  struct photon_map **map);

/* The light that they bring to a surface, as if from lamps. */
void photons_light(const struct tracer *tracer, struct worker *worker,
                   const struct surface *surface, light_visit *visit,
                   void *context);

#endif
