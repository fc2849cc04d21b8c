/*
 * How far two linear pictures are apart, as numbers for scripts.
 *
 *   figures REFERENCE PICTURE [EDGE]
 *
 * One line "rmse R relative D ratio Q": the root mean square difference, the
 * mean of |p - r| / r, and the ratio of the means, all of brightness, of
 * squares of EDGE x EDGE pixels (1). Squares darker than a hundredth of the
 * mean don't count in D.
 *
 *   figures --fireflies PICTURE
 *
 * One line "worst W": the largest ratio of a pixel to the median of its
 * neighbours (or to a hundredth of the picture's mean, if that is more).
 */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "image/file.h"
#include "image/image.h"

static struct image *read_picture(const char *path)
{
    char error[512];
    struct image *picture = image_read(path, error, sizeof error);
    if (!picture)
        printf("cannot read %s: %s\n", path, error);
    return picture;
}

static double brightness(const struct image *picture, int x, int y)
{
    const float *p = image_pixel(picture, x, y);
    return ((double)p[0] + (double)p[1] + (double)p[2]) / 3;
}

static double square_mean(const struct image *picture, int x, int y, int edge)
{
    double sum = 0;
    for (int j = 0; j < edge; j++)
        for (int i = 0; i < edge; i++)
            sum += brightness(picture, x + i, y + j);
    return sum / edge / edge;
}

static double whole_mean(const struct image *picture)
{
    double sum = 0;
    for (int y = 0; y < picture->height; y++)
        for (int x = 0; x < picture->width; x++)
            sum += brightness(picture, x, y);
    return sum / picture->width / picture->height;
}

static int compare_pictures(const struct image *r, const struct image *p,
                            int edge)
{
    double squares = 0, relative = 0, count = 0, counted = 0;
    double mean = whole_mean(r);
    if (r->width != p->width || r->height != p->height || edge < 1) {
        printf("the pictures differ in size\n");
        return 2;
    }
    for (int y = 0; y + edge <= r->height; y += edge)
        for (int x = 0; x + edge <= r->width; x += edge) {
            double a = square_mean(r, x, y, edge);
            double d = square_mean(p, x, y, edge) - a;
            squares += d * d;
            count++;
            if (a > mean / 100) {
                relative += fabs(d) / a;
                counted++;
            }
        }
    printf("rmse %.6g relative %.6g ratio %.6g\n", sqrt(squares / count),
           relative / counted, whole_mean(p) / mean);
    return 0;
}

static int order(const void *a, const void *b)
{
    double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

static double neighbours_median(const struct image *picture, int x, int y)
{
    double around[8];
    int count = 0;
    for (int j = -1; j <= 1; j++)
        for (int i = -1; i <= 1; i++)
            if (i || j)
                around[count++] = brightness(picture, x + i, y + j);
    qsort(around, 8, sizeof *around, order);
    return (around[3] + around[4]) / 2;
}

static int find_fireflies(const struct image *picture)
{
    double worst = 0, least = whole_mean(picture) / 100;
    for (int y = 1; y < picture->height - 1; y++)
        for (int x = 1; x < picture->width - 1; x++) {
            double level = fmax(neighbours_median(picture, x, y), least);
            worst = fmax(worst, brightness(picture, x, y) / level);
        }
    printf("worst %.6g\n", worst);
    return 0;
}

int main(int argc, char **argv)
{
    bool fireflies = argc == 3 && strcmp(argv[1], "--fireflies") == 0;
    if (argc < 3 || argc > 4) {
        printf("usage: figures REFERENCE PICTURE [EDGE]\n"
               "       figures --fireflies PICTURE\n");
        return 2;
    }
    struct image *a = fireflies ? NULL : read_picture(argv[1]);
    struct image *b = read_picture(argv[2]);
    if ((!fireflies && !a) || !b)
        return 2;
    int status = fireflies
                     ? find_fireflies(b)
                     : compare_pictures(a, b, argc == 4 ? atoi(argv[3]) : 1);
    image_free(a);
    image_free(b);
    return status;
}
