/* flicker PREFIX FOLDER FRAMES: how much still places flicker. PREFIX01.ppm ...
 * are pictures of 16 bits, FOLDER/1.places ... lines "NUMBER X Y": where a
 * place is seen in each, from 0 to 1. Prints the median and the 95th percentile
 * of the second difference of a place's brightness over three frames, per cent
 * of its mean; and the 95th percentile of what of that is no flicker but light
 * that does change: the bend of the parabola through seven frames (Savitzky and
 * Golay, Smoothing and Differentiation of Data by Simplified Least Squares
 * Procedures, 1964), which has 9 % of what differs by chance. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

enum { PLACES = 4096, FRAMES = 99 };

struct picture {
    int width, height;
    unsigned char *bytes; /* two of each channel, the higher first */
};

static float brightness[FRAMES + 1][PLACES]; /* negative: not seen */

static FILE *file_open(const char *path)
{
    FILE *file = fopen(path, "rb");
    if (!file) {
        perror(path);
        exit(1);
    }
    return file;
}

static struct picture picture_read(const char *path)
{
    struct picture picture;
    FILE *file = file_open(path);
    int most, good = fscanf(file, "P6 %d %d %d", &picture.width,
                            &picture.height, &most) == 3 &&
                     most == 65535;
    fgetc(file);
    size_t size = (size_t)picture.width * (size_t)picture.height * 6;
    picture.bytes = good ? malloc(size) : NULL;
    if (!picture.bytes || fread(picture.bytes, 1, size, file) != size) {
        fprintf(stderr, "flicker: %s is not such a picture\n", path);
        exit(1);
    }
    fclose(file);
    return picture;
}

static double pixel(const struct picture *picture, int x, int y)
{
    const unsigned char *at =
        picture->bytes + 6 * ((size_t)y * (size_t)picture->width + (size_t)x);
    double sum = 0;
    for (int i = 0; i < 6; i += 2)
        sum += at[i] * 256 + at[i + 1];
    return sum;
}

/* Between the middles of pixels. */
static double picture_at(const struct picture *picture, double x, double y)
{
    int i = (int)x, j = (int)y;
    double across = x - i, down = y - j;
    return (1 - down) * ((1 - across) * pixel(picture, i, j) +
                         across * pixel(picture, i + 1, j)) +
           down * ((1 - across) * pixel(picture, i, j + 1) +
                   across * pixel(picture, i + 1, j + 1));
}

static void frame_read(const char *prefix, const char *folder, int frame)
{
    char path[4096];
    int number;
    double x, y;
    snprintf(path, sizeof path, "%s%02d.ppm", prefix, frame);
    struct picture picture = picture_read(path);
    snprintf(path, sizeof path, "%s/%d.places", folder, frame);
    FILE *file = file_open(path);
    for (int i = 0; i < PLACES; i++)
        brightness[frame][i] = -1;
    while (fscanf(file, "%d %lf %lf", &number, &x, &y) == 3)
        if (number >= 0 && number < PLACES)
            brightness[frame][number] = (float)picture_at(
                &picture, x * picture.width - 0.5, y * picture.height - 0.5);
    fclose(file);
    free(picture.bytes);
}

static int order(const void *a, const void *b)
{
    double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

static double all[FRAMES * PLACES];

/* Of so many of all[]. */
static double percentile(size_t found, double share)
{
    qsort(all, found, sizeof *all, order);
    return all[(size_t)((double)found * share)];
}

/* How much the brightness of place i bends around a frame, by these weights of
 * 2 * reach + 1 frames: per cent of its mean; below 0: it isn't seen in all. */
static double bend(int frame, int i, const double *weights, int reach)
{
    double sum = 0, mean = 0;
    for (int k = -reach; k <= reach; k++) {
        double here = (double)brightness[frame + k][i];
        if (!(here > 0))
            return -1;
        sum += weights[k + reach] * here;
        mean += here / (2 * reach + 1);
    }
    return 100 * fabs(sum) / mean;
}

/* Into all[]; returns how many. */
static size_t bends(int frames, const double *weights, int reach)
{
    size_t found = 0;
    for (int frame = 1 + reach; frame <= frames - reach; frame++)
        for (int i = 0; i < PLACES; i++) {
            double here = bend(frame, i, weights, reach);
            if (here >= 0)
                all[found++] = here;
        }
    return found;
}

int main(int count, char **arguments)
{
    static const double second[] = { 1, -2, 1 },
                        smooth[] = { 5. / 42,  0, -3. / 42, -4. / 42,
                                     -3. / 42, 0, 5. / 42 };
    int frames = count == 4 ? atoi(arguments[3]) : 0;
    if (frames < 7 || frames > FRAMES) {
        fprintf(stderr, "usage: flicker PREFIX FOLDER FRAMES\n");
        return 2;
    }
    for (int frame = 1; frame <= frames; frame++)
        frame_read(arguments[1], arguments[2], frame);
    size_t found = bends(frames, second, 1);
    if (found == 0) {
        fprintf(stderr, "flicker: no place is seen in three frames\n");
        return 1;
    }
    double median = percentile(found, 0.5), most = percentile(found, 0.95);
    found = bends(frames, smooth, 3);
    printf("%.4f %.4f %.4f\n", median, most,
           found > 0 ? percentile(found, 0.95) : 0);
    return 0;
}
