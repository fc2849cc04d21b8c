/* What indirect light is worth in a picture, and the virtual lights that bring
 * some of it. */
#ifndef LIGHTING_MESH_SURVEY_H
#define LIGHTING_MESH_SURVEY_H

#include "lighting/lighting.h"
#include "lighting/mesh_state.h"

/* How many times as much a picture of an animation asks as one by itself. */
int mesh_times(const struct lighting_options *options);

/* What it is one of. */
enum plan_film mesh_film(const struct lighting_options *options);

/* Looks at it, into mesh->survey and mesh->virtual_lights; bright places that
 * are known may be NULL (survey.h). */
void mesh_look(struct mesh_lighting *mesh, const struct scene *scene,
               const struct lighting_options *options,
               const struct survey *known);

/* Virtual lights of a frame that others have planned. */
void mesh_virtual_again(struct mesh_lighting *mesh,
                        const struct lighting_options *options);

#endif
