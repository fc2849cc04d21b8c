/* Moving a camera, and writing it down. */
#ifndef VIEW_FLY_H
#define VIEW_FLY_H

#include <stdio.h>

#include "scene/camera.h"

/* Turns the camera about a point, degrees to the right and up; not beyond
 * straight up or down. */
void fly_orbit(struct camera *camera, vec3 pivot, double right, double up);

/* Turns it about itself, likewise. */
void fly_turn(struct camera *camera, double right, double up);

/* Moves it sideways and up, so that what is `distance` away moves by so many
 * widths and heights of the picture. */
void fly_pan(struct camera *camera, double distance, double right, double up);

/* Takes it nearer to a point, or farther: its distance times `factor` > 0. Of
 * an orthographic camera the picture is scaled. */
void fly_dolly(struct camera *camera, vec3 pivot, double factor);

/* Moves it along where it looks and to its right, units. */
void fly_walk(struct camera *camera, double ahead, double right);

/* Whether both see the same. */
bool fly_same(const struct camera *a, const struct camera *b);

/* Whether there is a place and a direction to move: not of a mesh_camera. */
bool fly_free(const struct camera *camera);

/* A camera block that draws the same view in glim and in POV-Ray. */
void fly_print(const struct camera *camera, FILE *out);

#endif
