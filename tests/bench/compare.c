/* compare A.ppm B.ppm: prints "SAME MEAN BRIGHTNESS SPREAD": the share of
 * pixels (in %) none of whose channels differs by more than 3, the mean
 * difference, and the mean and the standard deviation of A, all of 255. For
 * 8-bit P6 files, which both programs write with +FP. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

struct picture {
    int width, height;
    unsigned char *bytes;
};

static struct picture picture_read(const char *path)
{
    struct picture picture = { 0, 0, NULL };
    int top = 0;
    FILE *file = fopen(path, "rb");
    if (!file || fscanf(file, "P6 ") != 0) {
        perror(path);
        exit(2);
    }
    while (getc(file) == '#')
        while (getc(file) != '\n' && !feof(file))
            ;
    fseek(file, -1, SEEK_CUR);
    if (fscanf(file, "%d %d %d", &picture.width, &picture.height, &top) != 3 ||
        top != 255 || picture.width < 1 || picture.width > 65535 ||
        picture.height < 1 || picture.height > 65535 || getc(file) == EOF) {
        fprintf(stderr, "compare: %s is not an 8-bit P6 picture\n", path);
        exit(2);
    }
    size_t size = (size_t)picture.width * (size_t)picture.height * 3;
    picture.bytes = malloc(size);
    if (!picture.bytes || fread(picture.bytes, 1, size, file) != size) {
        fprintf(stderr, "compare: %s ends too early\n", path);
        exit(2);
    }
    fclose(file);
    return picture;
}

int main(int argc, char **argv)
{
    if (argc != 3) {
        fprintf(stderr, "usage: compare A.ppm B.ppm\n");
        return 2;
    }
    struct picture a = picture_read(argv[1]), b = picture_read(argv[2]);
    if (a.width != b.width || a.height != b.height) {
        fprintf(stderr, "compare: %dx%d is not %dx%d\n", a.width, a.height,
                b.width, b.height);
        return 2;
    }
    size_t pixels = (size_t)a.width * (size_t)a.height, same = 0;
    double difference = 0, sum = 0, squares = 0;
    for (size_t i = 0; i < pixels; i++) {
        int worst = 0;
        for (size_t c = 3 * i; c < 3 * i + 3; c++) {
            int d = abs(a.bytes[c] - b.bytes[c]);
            worst = d > worst ? d : worst;
            difference += d;
            sum += a.bytes[c];
            squares += (double)a.bytes[c] * a.bytes[c];
        }
        same += worst <= 3;
    }
    double count = 3.0 * (double)pixels, mean = sum / count;
    printf("%.2f %.3f %.1f %.1f\n", 100.0 * (double)same / (double)pixels,
           difference / count, mean, sqrt(squares / count - mean * mean));
    free(a.bytes);
    free(b.bytes);
    return 0;
}
