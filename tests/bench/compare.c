/* compare A.png B.png: prints "SAME MEAN BRIGHTNESS SPREAD": the share of
 * pixels (in %) none of whose channels differs by more than 3, the mean
 * difference, and the mean and the standard deviation of A, all of 255. */
#include <math.h>
#include <png.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static unsigned char *picture_read(const char *path, png_image *picture)
{
    memset(picture, 0, sizeof *picture);
    picture->version = PNG_IMAGE_VERSION;
    unsigned char *bytes = NULL;
    if (png_image_begin_read_from_file(picture, path)) {
        picture->format = PNG_FORMAT_RGB;
        bytes = malloc(PNG_IMAGE_SIZE(*picture));
        if (bytes && png_image_finish_read(picture, NULL, bytes, 0, NULL))
            return bytes;
    }
    fprintf(stderr, "compare: %s: %s\n", path, picture->message);
    exit(2);
}

int main(int argc, char **argv)
{
    if (argc != 3) {
        fprintf(stderr, "usage: compare A.png B.png\n");
        return 2;
    }
    png_image first, second;
    unsigned char *a = picture_read(argv[1], &first);
    unsigned char *b = picture_read(argv[2], &second);
    if (first.width != second.width || first.height != second.height) {
        fprintf(stderr, "compare: %ux%u is not %ux%u\n", first.width,
                first.height, second.width, second.height);
        return 2;
    }
    size_t pixels = (size_t)first.width * first.height, same = 0;
    double difference = 0, sum = 0, squares = 0;
    for (size_t i = 0; i < pixels; i++) {
        int worst = 0;
        for (size_t c = 3 * i; c < 3 * i + 3; c++) {
            int d = abs(a[c] - b[c]);
            worst = d > worst ? d : worst;
            difference += d;
            sum += a[c];
            squares += (double)a[c] * a[c];
        }
        same += worst <= 3;
    }
    double count = 3.0 * (double)pixels, mean = sum / count;
    printf("%.2f %.3f %.1f %.1f\n", 100.0 * (double)same / (double)pixels,
           difference / count, mean, sqrt(squares / count - mean * mean));
    free(a);
    free(b);
    return 0;
}
