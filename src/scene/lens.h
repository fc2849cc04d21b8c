/* Where the rays of one place of the picture go through the camera's lens. */
#ifndef SCENE_LENS_H
#define SCENE_LENS_H

#include <stdbool.h>
#include <stdint.h>

struct pigment;

/* Point i of `count`, from the lens's middle, of a lens of aperture 1, whose
 * radius is 1/4. The key moves it a little within its cell. */
void lens_point(int count, int i, uint64_t key, double point[2]);

/* Whether they lie on a disc: then they are these, which RAY_LANES at a time
 * cost less. They begin at a place that the key tells. */
bool lens_is_disc(int count);
void lens_begin(uint64_t key, double begin[2]);

/* Of each: where they begin becomes point number[i], to the bit as above. */
void lens_disc_points(const double *number, double *x, double *y);

/* Point i of a square lens that lets as much light through at each place as
 * `shape` is bright there (grey, 0 to 1) in the square from 0 to 1 of x and y;
 * y points down. Where all of it is dark any point will do. */
void lens_shaped_point(const struct pigment *shape, int i, uint64_t key,
                       double point[2]);

/* Uniform on the disc, for u in [0,1)^2. */
void lens_sample(const double u[2], double point[2]);

#endif
