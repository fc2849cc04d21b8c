/* The plainest files there are: a head in letters and then numbers. Of bytes
 * they are read and written with the pixels that OpenImageIO gives, without its
 * 0.3 s of loading (see png.c). It reads those that are cut short, deeper, in
 * letters, of bits or of floats. */
#include "image/pnm.h"

#include <ctype.h>
#include <errno.h>
#include <stdio.h>
#include <string.h>
#include <sys/stat.h>

#include "base/memory.h"
#include "image/tone.h"

/* ---- writing ---- */

static size_t pnm_fill_row(const struct image_format *format,
                           const float *pixels, int width, unsigned char *row)
{
    unsigned char *out = row;
    int channels = format->grey ? 1 : 3;
    bool deep = format->bits > 8;
    for (int x = 0; x < width; x++, pixels += 4)
        for (int c = 0; c < channels; c++) {
            unsigned level =
                tone_spread(pixels[c], format->bits, deep ? 65535 : 255);
            if (deep)
                *out++ = (unsigned char)(level >> 8);
            *out++ = (unsigned char)(level & 255);
        }
    return (size_t)(out - row);
}

bool pnm_encode(const struct image_bands *bands,
                const struct image_format *format,
                const struct codec_sink *sink, char *error, size_t size)
{
    const struct image *image = NULL;
    char head[64];
    int length =
        snprintf(head, sizeof head, "P%d\n%d %d\n%d\n", format->grey ? 5 : 6,
                 bands->width, bands->height, format->bits > 8 ? 65535 : 255);
    bool done = sink->put(sink->context, head, (size_t)length, error, size);
    unsigned char *row = memory_new((size_t)bands->width * 6);
    for (int y = 0, top = 0; done && y < bands->height; y++) {
        if (!image || y >= top + image->height)
            image = bands->at(bands->context, y, &top);
        if (!image) {
            snprintf(error, size, "what was drawn can't be read back");
            done = false;
            break;
        }
        size_t count = pnm_fill_row(format, image_pixel(image, 0, y - top),
                                    bands->width, row);
        done = sink->put(sink->context, row, count, error, size);
    }
    memory_free(row);
    return done;
}

/* ---- reading ---- */

struct pnm_head {
    int channels, width, height;
};

static int pnm_skip_comment(FILE *file)
{
    int c = getc(file);
    while (c != '\n' && c != EOF)
        c = getc(file);
    return c;
}

/* A number of the head, behind blanks and comments; 0: there is none. */
static int pnm_number(FILE *file)
{
    enum { LARGEST = 100000000 };
    int c = getc(file), number = 0;
    while (isspace(c) || c == '#')
        c = c == '#' ? pnm_skip_comment(file) : getc(file);
    for (; isdigit(c) && number < LARGEST; c = getc(file))
        number = 10 * number + (c - '0');
    return isspace(c) ? number : 0; /* one blank behind it */
}

/* The head of a file that pnm_decode reads, up to its first pixel. */
static bool pnm_read_head(FILE *file, struct pnm_head *head)
{
    if (getc(file) != 'P')
        return false;
    int kind = getc(file);
    *head = (struct pnm_head){ .channels = kind == '6' ? 3 : 1 };
    head->width = pnm_number(file);
    head->height = pnm_number(file);
    return (kind == '5' || kind == '6') && head->width > 0 &&
           head->height > 0 && pnm_number(file) == 255;
}

static size_t pnm_row_size(const struct pnm_head *head)
{
    return (size_t)head->width * (size_t)head->channels;
}

bool pnm_is_ours(const char *path)
{
    struct pnm_head head;
    struct stat status;
    FILE *file = fopen(path, "rb");
    bool ours =
        file && pnm_read_head(file, &head) && fstat(fileno(file), &status) == 0;
    long begin = ours ? ftell(file) : 0;
    if (file)
        fclose(file);
    return ours && begin > 0 &&
           (double)(status.st_size - begin) >=
               (double)pnm_row_size(&head) * head.height;
}

static void pnm_take_row(const struct pnm_head *head, const unsigned char *in,
                         float *out)
{
    for (int x = 0; x < head->width; x++, out += 4) {
        for (int c = 0; c < head->channels; c++)
            out[c] = (float)*in++ * (1.0f / 255);
        if (head->channels == 1)
            out[1] = out[2] = out[0];
        out[3] = 1;
    }
}

static bool pnm_read_rows(FILE *file, const struct pnm_head *head,
                          const struct codec_target *target, float *pixels)
{
    size_t count = pnm_row_size(head);
    size_t line = target->take ? 0 : 4 * (size_t)head->width;
    unsigned char *row = memory_new(count);
    int y = 0;
    for (; y < head->height && fread(row, 1, count, file) == count; y++) {
        pnm_take_row(head, row, pixels + line * (size_t)y);
        if (target->take)
            target->take(target->context, y);
    }
    memory_free(row);
    return y == head->height;
}

bool pnm_decode(const char *path, struct codec_target *target, char *error,
                size_t size)
{
    struct pnm_head head;
    FILE *file = fopen(path, "rb");
    if (!file) {
        snprintf(error, size, "%s", strerror(errno));
        return false;
    }
    bool done = pnm_read_head(file, &head);
    if (done) {
        target->plain = true;
        target->channels = head.channels;
        target->bits = 8;
        float *pixels = target->allocate(target->context, head.width,
                                         head.height, error, size);
        done = pixels && pnm_read_rows(file, &head, target, pixels);
    }
    fclose(file);
    return done;
}
