/* Where the rays of one place of the picture go through the camera's lens. */
#ifndef SCENE_LENS_H
#define SCENE_LENS_H

#include <stdint.h>

/* Point i of `count`, from the lens's middle, of a lens of aperture 1, whose
 * radius is 1/4. The key moves it a little within its cell. */
void lens_point(int count, int i, uint64_t key, double point[2]);

/* Uniform on the disc, for u in [0,1)^2. */
void lens_sample(const double u[2], double point[2]);

#endif
