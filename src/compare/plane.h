/* One number a pixel, and its convolution with a kernel that is a product of
 * a row and a column: what FLIP and SSIM are made of. */
#ifndef COMPARE_PLANE_H
#define COMPARE_PLANE_H

enum { KERNEL_RADIUS_LIMIT = 64 };

struct plane {
    int width, height;
    float *values; /* row by row from the top */
};

/* Weights of the offsets -radius..radius. */
struct kernel {
    int radius;
    double weights[2 * KERNEL_RADIUS_LIMIT + 1];
};

/* Zeroes; freed by plane_free. */
struct plane plane_new(int width, int height);
void plane_free(struct plane *plane);

/* The mean over the pixels that are at least `margin` from every side; over
 * all if there are none. */
double plane_mean(const struct plane *plane, int margin);

/* exp(-x^2 / (2 deviation^2)), cut at `radius`, which is at most the limit,
 * and scaled to a sum of 1. */
struct kernel kernel_gaussian(double deviation, int radius);

/* out = in convolved with row * column; beyond the border stands the border's
 * own value. `out` may be `in`. */
void plane_convolve(const struct plane *in, const struct kernel *row,
                    const struct kernel *column, struct plane *out);

#endif
