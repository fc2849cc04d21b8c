/* SSIM after Z. Wang, A. Bovik, H. Sheikh, E. Simoncelli, "Image quality
 * assessment: from error visibility to structural similarity", IEEE
 * Transactions on Image Processing 13(4), 2004: equation 13 in an 11 x 11
 * Gaussian window of deviation 1.5, averaged over the windows that lie wholly
 * in the picture (equation 17). */
#include "compare/ssim.h"

#include "compare/plane.h"

enum { WINDOW_RADIUS = 5 };

#define C1 (0.01 * 0.01) /* (K1 L)^2 of a range L of 1 */
#define C2 (0.03 * 0.03)

/* Luma of Rec. 601 as displayed. */
static double ssim_luma(const struct pair *pair, int which, size_t i)
{
    const float *pixel = pair->image[which]->pixels + 4 * i;
    return 0.299 * pair_display(pair, (double)pixel[0]) +
           0.587 * pair_display(pair, (double)pixel[1]) +
           0.114 * pair_display(pair, (double)pixel[2]);
}

enum { MEAN_A, MEAN_B, SQUARE_A, SQUARE_B, PRODUCT, PLANE_COUNT };

/* Equation 13, of the windowed sums. */
static double ssim_index(double a, double b, double aa, double bb, double ab)
{
    double variance_a = aa - a * a, variance_b = bb - b * b;
    double covariance = ab - a * b;
    return (2 * a * b + C1) * (2 * covariance + C2) /
           ((a * a + b * b + C1) * (variance_a + variance_b + C2));
}

double ssim_mean(const struct pair *pair)
{
    int width = pair->image[0]->width, height = pair->image[0]->height;
    size_t pixels = (size_t)width * (size_t)height;
    struct plane planes[PLANE_COUNT];
    for (int i = 0; i < PLANE_COUNT; i++)
        planes[i] = plane_new(width, height);
    for (size_t i = 0; i < pixels; i++) {
        double a = ssim_luma(pair, 0, i), b = ssim_luma(pair, 1, i);
        planes[MEAN_A].values[i] = (float)a;
        planes[MEAN_B].values[i] = (float)b;
        planes[SQUARE_A].values[i] = (float)(a * a);
        planes[SQUARE_B].values[i] = (float)(b * b);
        planes[PRODUCT].values[i] = (float)(a * b);
    }
    struct kernel window = kernel_gaussian(1.5, WINDOW_RADIUS);
    for (int i = 0; i < PLANE_COUNT; i++)
        plane_convolve(&planes[i], &window, &window, &planes[i]);
    for (size_t i = 0; i < pixels; i++) {
        double sums[PLANE_COUNT];
        for (int k = 0; k < PLANE_COUNT; k++)
            sums[k] = (double)planes[k].values[i];
        planes[0].values[i] =
            (float)ssim_index(sums[MEAN_A], sums[MEAN_B], sums[SQUARE_A],
                              sums[SQUARE_B], sums[PRODUCT]);
    }
    double mean = plane_mean(&planes[0], WINDOW_RADIUS);
    for (int i = 0; i < PLANE_COUNT; i++)
        plane_free(&planes[i]);
    return mean;
}
