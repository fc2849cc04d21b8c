/* Colours of a picture wrapped on space: see image_map.c. */
#ifndef SCENE_IMAGE_MAP_H
#define SCENE_IMAGE_MAP_H

#include "base/rgb.h"
#include "base/vec.h"
#include "scene/material.h"

/* The colour at a point of the map's own space; outside of a map used `once`
 * clear: transmit 1. */
colour image_map_colour(const struct image_map *map, vec3 point);

/* As bumps: what to add to the unit normal for amount 1. */
vec3 image_map_tilt(const struct image_map *map, vec3 point, vec3 normal);

/* Whether no pixel lets light pass. */
bool image_map_is_opaque(const struct image_map *map);

#endif
