/* JPEG files by libjpeg itself, with its settings left alone, as OpenImageIO
 * has them: the same pixels without its 0.2 s of loading (see png.c). */
#include "image/jpeg.h"

#include <errno.h>
#include <setjmp.h>
#include <stdio.h>
#include <string.h>

#include <jpeglib.h>

#include "base/memory.h"

enum { PASSES_LIMIT = 500 };

struct jpeg_reader {
    struct jpeg_decompress_struct jpeg;
    struct jpeg_error_mgr manager;
    struct jpeg_progress_mgr progress;
    jmp_buf out;
    struct codec_target *target;
    char *error; /* where there is yet none, or the first */
    size_t size;
    float *pixels; /* the target's, all or one row */
    unsigned char *row;
};

/* A warning that comes before an error tells more: that the file is cut short
 * rather than that something is missing. */
static void jpeg_note(j_common_ptr jpeg)
{
    struct jpeg_reader *r = jpeg->client_data;
    char message[JMSG_LENGTH_MAX];
    if (*r->error)
        return;
    r->manager.format_message(jpeg, message);
    snprintf(r->error, r->size, "%s", message);
}

static void jpeg_warn(j_common_ptr jpeg, int level)
{
    if (level < 0)
        jpeg_note(jpeg);
}

static void jpeg_leave(j_common_ptr jpeg)
{
    struct jpeg_reader *r = jpeg->client_data;
    jpeg_note(jpeg);
    longjmp(r->out, 1);
}

/* Each pass goes over the whole picture, however few bytes it has: a small file
 * could have thousands. Those that are made for pictures have ten or so. */
static void jpeg_count_passes(j_common_ptr jpeg)
{
    struct jpeg_reader *r = jpeg->client_data;
    if (r->jpeg.input_scan_number <= PASSES_LIMIT)
        return;
    *r->error = '\0'; /* warnings matter less */
    snprintf(r->error, r->size, "it has more than %d passes", PASSES_LIMIT);
    longjmp(r->out, 1);
}

static void jpeg_take_row(const struct jpeg_reader *r, float *out)
{
    int channels = r->jpeg.output_components;
    const unsigned char *in = r->row;
    for (unsigned x = 0; x < r->jpeg.output_width; x++, in += channels) {
        for (int c = 0; c < 3; c++)
            *out++ = (float)in[channels == 1 ? 0 : c] * (1.0f / 255);
        *out++ = 1;
    }
}

static bool jpeg_begin(struct jpeg_reader *r)
{
    struct codec_target *target = r->target;
    jpeg_calc_output_dimensions(&r->jpeg); /* before it takes room for passes */
    target->channels = r->jpeg.output_components;
    target->bits = 8;
    r->pixels = target->allocate(target->context, (int)r->jpeg.output_width,
                                 (int)r->jpeg.output_height, r->error, r->size);
    if (!r->pixels)
        return false;
    jpeg_start_decompress(&r->jpeg);
    r->row = memory_new((size_t)r->jpeg.output_width *
                        (size_t)r->jpeg.output_components);
    return true;
}

static void jpeg_take_rows(struct jpeg_reader *r)
{
    const struct codec_target *target = r->target;
    size_t line = target->take ? 0 : 4 * (size_t)r->jpeg.output_width;
    while (r->jpeg.output_scanline < r->jpeg.output_height) {
        int y = (int)r->jpeg.output_scanline;
        jpeg_read_scanlines(&r->jpeg, &r->row, 1);
        jpeg_take_row(r, r->pixels + line * (size_t)y);
        if (target->take)
            target->take(target->context, y);
    }
}

/* Opens the file up to its header, calls `rest` and closes it. libjpeg leaves
 * by longjmp; nothing here is changed after setjmp but through pointers. */
static bool jpeg_open(struct jpeg_reader *r, const char *path,
                      bool (*rest)(struct jpeg_reader *r))
{
    FILE *file = fopen(path, "rb");
    if (!file) {
        snprintf(r->error, r->size, "%s", strerror(errno));
        return false;
    }
    r->jpeg.err = jpeg_std_error(&r->manager);
    r->jpeg.client_data = r;
    r->manager.error_exit = jpeg_leave;
    r->manager.emit_message = jpeg_warn;
    r->progress.progress_monitor = jpeg_count_passes;
    bool done = false;
    if (!setjmp(r->out)) {
        jpeg_create_decompress(&r->jpeg);
        r->jpeg.progress = &r->progress;
        jpeg_stdio_src(&r->jpeg, file);
        jpeg_read_header(&r->jpeg, TRUE);
        done = rest(r);
    }
    jpeg_destroy_decompress(&r->jpeg);
    memory_free(r->row);
    fclose(file);
    return done;
}

static bool jpeg_is_inks(struct jpeg_reader *r)
{
    return r->jpeg.out_color_space != JCS_RGB &&
           r->jpeg.out_color_space != JCS_GRAYSCALE;
}

bool jpeg_is_ours(const char *path)
{
    char unheard[1] = "";
    struct jpeg_reader reader = { .error = unheard, .size = 1 };
    return !jpeg_open(&reader, path, jpeg_is_inks);
}

/* The next marker of the file, behind what is no marker; EOF: none. */
static int jpeg_marker(FILE *file)
{
    for (int c = getc(file); c != EOF; c = getc(file)) {
        if (c != 0xff)
            continue;
        while (c == 0xff)
            c = getc(file);
        if (c != 0)
            return c;
    }
    return EOF;
}

/* Whether the marker has no length and nothing behind it. */
static bool jpeg_stands_alone(int marker)
{
    return marker == 0x01 || (marker >= 0xd0 && marker <= 0xd9);
}

bool jpeg_passes_few(const char *path, char *error, size_t size)
{
    enum { BEGINS_PASS = 0xda };
    FILE *file = fopen(path, "rb");
    int passes = 0, marker = 0;
    while (file && passes <= PASSES_LIMIT &&
           (marker = jpeg_marker(file)) != EOF) {
        passes += marker == BEGINS_PASS;
        if (jpeg_stands_alone(marker))
            continue;
        int high = getc(file), low = getc(file), length = high << 8 | low;
        if (high == EOF || low == EOF || length < 2 ||
            fseek(file, length - 2, SEEK_CUR) != 0)
            break;
    }
    if (file)
        fclose(file);
    if (passes > PASSES_LIMIT)
        snprintf(error, size, "it has more than %d passes", PASSES_LIMIT);
    return passes <= PASSES_LIMIT;
}

/* What is missing at the end of a file that is cut short is grey. */
static bool jpeg_read(struct jpeg_reader *r)
{
    bool begun = jpeg_begin(r);
    if (begun)
        jpeg_take_rows(r);
    return begun;
}

bool jpeg_decode(const char *path, struct codec_target *target, char *error,
                 size_t size)
{
    struct jpeg_reader reader = { .target = target,
                                  .error = error,
                                  .size = size };
    *error = '\0';
    return jpeg_open(&reader, path, jpeg_read);
}
