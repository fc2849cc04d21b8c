/* Lamps that light from all over their area (area_illumination), at several
 * surfaces side by side. */
#ifndef LIGHTING_LAMPLIGHTS_AREA_H
#define LIGHTING_LAMPLIGHTS_AREA_H

#include "lighting/lamplights.h"

/* Adds to the facets of `lanes` the light of all points of the lamp's grid, of
 * which each gets such a share; as lamplight_give of each by itself. */
void lamplights_add_area(struct lamplights *lights, const struct lamp *lamp,
                         unsigned lanes, const rgb *shares);

#endif
