/* Points and lines drawn over a picture that is done: --show. */
#ifndef RENDER_OVERLAY_H
#define RENDER_OVERLAY_H

#include "image/ramp.h"
#include "lighting/show.h"
#include "render/render.h"

/* Draws what `show` has as the tracer's camera sees it: smooth thin lines and
 * dots, their colours by their numbers (RAMP_SPECTRUM); what is behind
 * something else is fainter. `working_gamma` is that of the image: 0 for sRGB,
 * as colours are defined. Of the options the part of the picture, `threads`
 * and `stop` count. The same for any number of threads. Returns false if
 * stopped; else *range has the numbers at the ends of the colours. */
bool overlay_draw(const struct tracer *tracer,
                  const struct render_options *options, const struct show *show,
                  double working_gamma, struct image *image,
                  struct ramp_range *range);

#endif
