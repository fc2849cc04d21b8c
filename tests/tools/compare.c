/*
 * Compares the look of two pictures, or a picture with given values; whether
 * two pictures are the same is glim-compare's question.
 *
 *   compare noise  REFERENCE PICTURE   the same look: another noise, jitter
 *   compare values PICTURE VALUES      lines "pixel x y r g b tolerance"
 *
 * Prints one line of figures; exit status 0 alike, 1 not alike, 2 trouble.
 * Pictures are compared as written (8-bit files in 8-bit steps, encoded);
 * values are compared as stored, so linear for an EXR file.
 *
 * noise: the picture is cut into 4 x 3 regions. In each region and channel
 *   four figures are compared: the mean, the spread (standard deviation),
 *   and the grain along rows and along columns (mean absolute step to the
 *   next pixel; a pattern of the wrong scale, or stretched, has the right
 *   mean and spread but another grain). How close is said in figures_agree.
 */
#include <math.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "image/file.h"
#include "image/image.h"

enum { ALIKE, NOT_ALIKE, TROUBLE };
enum { COLUMNS = 4, ROWS = 3, COLOURS = 3 };

static const double STEP = 1.0 / 255;

static double value(const struct image *picture, int x, int y, int channel)
{
    return (double)image_pixel(picture, x, y)[channel];
}

static struct image *read_picture(const char *path)
{
    char error[512];
    struct image *picture = image_read(path, error, sizeof error);

    if (picture == NULL)
        printf("cannot read %s: %s\n", path, error);
    return picture;
}

struct region {
    int x0, x1, y0, y1;
};

struct figures {
    double mean, spread, row_grain, column_grain;
};

/* The mean absolute step from a pixel to the one dx and dy further. */
static double region_grain(const struct image *picture, struct region region,
                           int channel, int dx, int dy)
{
    int width = region.x1 - dx - region.x0, height = region.y1 - dy - region.y0;
    double steps = 0;

    for (int y = region.y0; y < region.y1 - dy; y++)
        for (int x = region.x0; x < region.x1 - dx; x++)
            steps += fabs(value(picture, x + dx, y + dy, channel) -
                          value(picture, x, y, channel));
    return steps / (width * height);
}

static struct figures region_figures(const struct image *picture,
                                     struct region region, int channel)
{
    int pixels = (region.x1 - region.x0) * (region.y1 - region.y0);
    double sum = 0, squares = 0;

    for (int y = region.y0; y < region.y1; y++) {
        for (int x = region.x0; x < region.x1; x++) {
            double v = value(picture, x, y, channel);

            sum += v;
            squares += v * v;
        }
    }
    double mean = sum / pixels;

    return (struct figures){
        .mean = mean,
        .spread = sqrt(fmax(0, squares / pixels - mean * mean)),
        .row_grain = region_grain(picture, region, channel, 1, 0),
        .column_grain = region_grain(picture, region, channel, 0, 1),
    };
}

/* At most floor steps apart, and a share of the larger one more. */
static bool within(double a, double b, double floor, double share)
{
    return fabs(a - b) <= floor * STEP + share * fmax(fabs(a), fabs(b));
}

/*
 * The tolerances come from POV-Ray itself: the noise scenes of tests/render
 * drawn with every pattern moved elsewhere, 5 times, differed from the first
 * picture in a region's mean by up to 10, in its spread by up to 6, in its
 * grain by up to 4 steps, and all of them pass. Half the turbulence or bumps
 * of 0.7 times the height do not pass, nor, for most patterns, a scale 1.4
 * times too large or too small.
 */
static bool figures_agree(struct figures a, struct figures b)
{
    return within(a.mean, b.mean, 12, 0) &&
           within(a.spread, b.spread, 5, 0.10) &&
           within(a.row_grain, b.row_grain, 3, 0.08) &&
           within(a.column_grain, b.column_grain, 3, 0.08);
}

static int compare_noise(const struct image *a, const struct image *b)
{
    int wrong = 0;
    struct figures largest = { 0, 0, 0, 0 };

    for (int i = 0; i < COLUMNS * ROWS * COLOURS; i++) {
        int channel = i % COLOURS;
        int column = i / COLOURS % COLUMNS, row = i / COLOURS / COLUMNS;
        struct region region = {
            a->width * column / COLUMNS,
            a->width * (column + 1) / COLUMNS,
            a->height * row / ROWS,
            a->height * (row + 1) / ROWS,
        };
        struct figures p = region_figures(a, region, channel);
        struct figures q = region_figures(b, region, channel);

        largest.mean = fmax(largest.mean, fabs(p.mean - q.mean));
        largest.spread = fmax(largest.spread, fabs(p.spread - q.spread));
        largest.row_grain = fmax(largest.row_grain,
                                 fmax(fabs(p.row_grain - q.row_grain),
                                      fabs(p.column_grain - q.column_grain)));
        if (!figures_agree(p, q))
            wrong++;
    }
    printf("%d of %d regions differ; mean by up to %.1f/255, spread %.1f/255,"
           " grain %.1f/255\n",
           wrong, COLUMNS * ROWS * COLOURS, largest.mean / STEP,
           largest.spread / STEP, largest.row_grain / STEP);
    return wrong == 0 ? ALIKE : NOT_ALIKE;
}

static bool same_size(const struct image *a, const struct image *b)
{
    if (a->width == b->width && a->height == b->height)
        return true;
    printf("%d x %d against %d x %d pixels\n", a->width, a->height, b->width,
           b->height);
    return false;
}

static int compare_pictures(const char *a_path, const char *b_path)
{
    struct image *a = read_picture(a_path), *b = read_picture(b_path);
    int result = TROUBLE;

    if (a != NULL && b != NULL) {
        result = NOT_ALIKE;
        if (same_size(a, b))
            result = compare_noise(a, b);
    }
    image_free(a);
    image_free(b);
    return result;
}

struct expected {
    int x, y;
    double colour[COLOURS], tolerance;
};

/* Prints a line and returns false if the pixel is not as expected. */
static bool check_pixel(const struct image *picture,
                        const struct expected *expected)
{
    const double *wanted = expected->colour;
    int x = expected->x, y = expected->y;

    if (x < 0 || x >= picture->width || y < 0 || y >= picture->height) {
        printf("pixel %d %d is outside the picture\n", x, y);
        return false;
    }
    for (int c = 0; c < COLOURS; c++) {
        double found = value(picture, x, y, c);

        /* So written that a NaN fails. */
        if (fabs(found - wanted[c]) <= expected->tolerance)
            continue;
        printf("pixel %d %d: %.5g %.5g %.5g, expected %.5g %.5g %.5g "
               "within %.2g\n",
               x, y, value(picture, x, y, 0), value(picture, x, y, 1),
               value(picture, x, y, 2), wanted[0], wanted[1], wanted[2],
               expected->tolerance);
        return false;
    }
    return true;
}

static bool parse_expected(const char *line, struct expected *e)
{
    char rest;

    return sscanf(line, "pixel %d %d %lf %lf %lf %lf %c", &e->x, &e->y,
                  &e->colour[0], &e->colour[1], &e->colour[2], &e->tolerance,
                  &rest) == 6;
}

/* Checks the picture against every line of the file. */
static int check_values(const struct image *picture, FILE *values,
                        const char *path)
{
    char line[256];
    int right = 0, wrong = 0;

    while (fgets(line, sizeof line, values) != NULL) {
        struct expected expected;

        if (line[0] == '#' || line[0] == '\n')
            continue;
        if (!parse_expected(line, &expected)) {
            printf("%s: not understood: %s", path, line);
            return TROUBLE;
        }
        if (check_pixel(picture, &expected))
            right++;
        else
            wrong++;
    }
    printf("%d pixels right, %d wrong\n", right, wrong);
    return wrong == 0 && right > 0 ? ALIKE : NOT_ALIKE;
}

static int compare_values(const char *picture_path, const char *values_path)
{
    struct image *picture = read_picture(picture_path);
    FILE *values = fopen(values_path, "r");
    int result = TROUBLE;

    if (values == NULL)
        printf("cannot open %s\n", values_path);
    else if (picture != NULL)
        result = check_values(picture, values, values_path);
    if (values != NULL)
        fclose(values);
    image_free(picture);
    return result;
}

int main(int argc, char **argv)
{
    if (argc == 4 && strcmp(argv[1], "noise") == 0)
        return compare_pictures(argv[2], argv[3]);
    if (argc == 4 && strcmp(argv[1], "values") == 0)
        return compare_values(argv[2], argv[3]);
    fprintf(stderr, "usage: compare noise REFERENCE PICTURE\n"
                    "       compare values PICTURE VALUES\n");
    return TROUBLE;
}
