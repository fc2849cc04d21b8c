/* PNG files by libpng itself. OpenImageIO goes through libpng too, but loading
 * it (250 libraries, 150,000 relocations) takes longer than many a picture: a
 * 16x12 image is written ten times sooner this way. All other formats go
 * through OpenImageIO (file.cpp). */
#include "image/png.h"

#include <errno.h>
#include <math.h>
#include <png.h>
#include <stdio.h>
#include <string.h>
#include <zlib.h>

#include "base/memory.h"
#include "image/tone.h"

/* Whom libpng's errors are told. */
struct png_trouble {
    char *error;
    size_t size;
};

struct png_job {
    const struct image_bands *bands;
    const struct codec_sink *sink;
    int channels; /* 1 Y, 2 YA, 3 RGB, 4 RGBA */
    int bits;     /* as asked for, 1..16 */
    int depth;    /* as stored: 8 or 16 */
    unsigned char *row;
    struct png_trouble trouble;
};

static void png_report(png_structp png, png_const_charp message)
{
    struct png_trouble *trouble = png_get_error_ptr(png);
    snprintf(trouble->error, trouble->size, "%s", message);
    png_longjmp(png, 1);
}

static void png_ignore(png_structp png, png_const_charp message)
{
    (void)png;
    (void)message;
}

static void png_append(png_structp png, png_bytep bytes, size_t count)
{
    struct png_job *job = png_get_io_ptr(png);
    if (!job->sink->put(job->sink->context, bytes, count, job->trouble.error,
                        job->trouble.size))
        png_longjmp(png, 1);
}

static void png_flush_nothing(png_structp png)
{
    (void)png;
}

/* As below, of the usual kinds, RGB and RGBA. */
static inline void png_fill_bytes(const struct png_job *job,
                                  const float *restrict pixel, int channels)
{
    unsigned char *restrict out = job->row;
    for (int x = 0; x < job->bands->width; x++, pixel += 4, out += channels)
        for (int c = 0; c < channels; c++)
            out[c] = (unsigned char)tone_level(pixel[c], 255);
}

static void png_fill_row(const struct png_job *job, const float *pixel)
{
    unsigned char *out = job->row;
    if (job->channels >= 3 && job->bits == 8) {
        if (job->channels == 3)
            png_fill_bytes(job, pixel, 3);
        else
            png_fill_bytes(job, pixel, 4);
        return;
    }
    for (int x = 0; x < job->bands->width; x++, pixel += 4) {
        for (int c = 0; c < job->channels; c++) {
            float v = pixel[job->channels < 3 && c == 1 ? 3 : c];
            if (job->depth == 16) {
                unsigned level = tone_spread(v, job->bits, 65535);
                *out++ = (unsigned char)(level >> 8);
                *out++ = (unsigned char)(level & 255);
            } else
                *out++ = (unsigned char)tone_spread(v, job->bits, 255);
        }
    }
}

/* libpng wants a text that it might change, though it doesn't. */
static char *png_note(const char *note)
{
    char *copy = note ? memory_new(strlen(note) + 1) : NULL;
    if (note)
        strcpy(copy, note);
    return copy;
}

static void png_describe(png_structp png, png_infop info,
                         const struct png_job *job,
                         const struct image_format *format)
{
    static const int types[] = { 0, PNG_COLOR_TYPE_GRAY,
                                 PNG_COLOR_TYPE_GRAY_ALPHA, PNG_COLOR_TYPE_RGB,
                                 PNG_COLOR_TYPE_RGB_ALPHA };
    char key[] = "Software", text[] = "glim " GLIM_VERSION;
    char note_key[] = "glim", *note = png_note(format->note);
    const png_text texts[] = {
        { .compression = PNG_TEXT_COMPRESSION_NONE, .key = key, .text = text },
        { .compression = PNG_TEXT_COMPRESSION_NONE,
          .key = note_key,
          .text = note }
    };
    png_set_IHDR(png, info, (png_uint_32)job->bands->width,
                 (png_uint_32)job->bands->height, job->depth,
                 types[job->channels], PNG_INTERLACE_NONE,
                 PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
    if (format->gamma == 0)
        png_set_sRGB_gAMA_and_cHRM(png, info, PNG_sRGB_INTENT_PERCEPTUAL);
    else
        png_set_gAMA(png, info, 1 / format->gamma);
    png_set_text(png, info, texts, note ? 2 : 1);
    memory_free(note);
}

static void png_write_rows_of(png_structp png, const struct png_job *job)
{
    const struct image *image = NULL;
    for (int y = 0, top = 0; y < job->bands->height; y++) {
        if (!image || y >= top + image->height)
            image = job->bands->at(job->bands->context, y, &top);
        if (!image)
            png_error(png, "what was drawn can't be read back");
        png_fill_row(job, image_pixel(image, 0, y - top));
        png_write_row(png, job->row);
    }
}

/* libpng leaves by longjmp; nothing here is changed after setjmp but through
 * pointers. */
static bool png_write(struct png_job *job, const struct image_format *format)
{
    png_structp png = png_create_write_struct(
        PNG_LIBPNG_VER_STRING, &job->trouble, png_report, png_ignore);
    png_infop info = png ? png_create_info_struct(png) : NULL;
    if (!info) {
        snprintf(job->trouble.error, job->trouble.size, "libpng can't start");
        png_destroy_write_struct(&png, NULL);
        return false;
    }
    if (setjmp(png_jmpbuf(png))) {
        png_destroy_write_struct(&png, &info);
        return false;
    }
    png_set_write_fn(png, job, png_append, png_flush_nothing);
    png_set_user_limits(png, PNG_UINT_31_MAX, PNG_UINT_31_MAX);
    /* Of level 6's time a third, files 5 to 10 % larger (measured); bytes have
     * runs rather than repetitions: a sixth, files as large as those. */
    png_set_compression_level(png, 3);
    if (job->depth == 8) {
        png_set_compression_strategy(png, Z_RLE);
        png_set_filter(png, PNG_FILTER_TYPE_BASE, PNG_FILTER_PAETH);
    }
    png_describe(png, info, job, format);
    png_write_info(png, info);
    png_write_rows_of(png, job);
    png_write_end(png, info);
    png_destroy_write_struct(&png, &info);
    return true;
}

bool png_encode(const struct image_bands *bands,
                const struct image_format *format,
                const struct codec_sink *sink, char *error, size_t size)
{
    struct png_job job = {
        .bands = bands,
        .sink = sink,
        .channels = (format->grey ? 1 : 3) + (format->alpha ? 1 : 0),
        .bits = format->bits,
        .depth = format->bits > 8 ? 16 : 8,
        .trouble = { error, size },
    };
    job.row = memory_new((size_t)bands->width * 8);
    bool done = png_write(&job, format);
    memory_free(job.row);
    return done;
}

/* ---- reading ---- */

struct png_reader {
    struct codec_target *target;
    struct png_trouble trouble;
    FILE *file;
    float *pixels;       /* the target's, all or one row */
    unsigned char *rows; /* all of an interlaced picture, or one row */
    int width, height;
    int channels; /* 1 Y, 2 YA, 3 RGB, 4 RGBA */
    int depth;    /* 8 or 16 */
};

/* What glim can do without is spread: palettes, fewer bits, a colour that is
 * transparent. */
static bool png_begin(png_structp png, png_infop info, struct png_reader *r)
{
    double gamma = 0;
    int intent;
    png_init_io(png, r->file);
    png_set_user_limits(png, PNG_UINT_31_MAX, PNG_UINT_31_MAX);
    png_read_info(png, info);
    r->target->palette =
        png_get_color_type(png, info) == PNG_COLOR_TYPE_PALETTE;
    r->target->indexed = r->target->numbers && r->target->palette;
    if (r->target->indexed)
        png_set_packing(png);
    else
        png_set_expand(png);
    int passes = png_set_interlace_handling(png);
    png_read_update_info(png, info);
    r->width = (int)png_get_image_width(png, info);
    r->height = (int)png_get_image_height(png, info);
    r->channels = png_get_channels(png, info);
    r->depth = png_get_bit_depth(png, info);
    r->target->channels = r->channels;
    r->target->bits = r->depth;
    r->target->has_alpha = r->channels % 2 == 0;
    r->target->linear = r->target->plain = false;
    r->target->srgb = png_get_sRGB(png, info, &intent) != 0;
    r->target->gamma = 0;
    if (!r->target->srgb && png_get_gAMA(png, info, &gamma) && gamma > 0)
        /* Files say 0.45455 and mean 2.2. */
        r->target->gamma = round(100 / gamma) / 100;
    r->pixels = r->target->allocate(r->target->context, r->width, r->height,
                                    r->trouble.error, r->trouble.size);
    if (!r->pixels)
        return false;
    size_t size = png_get_rowbytes(png, info);
    r->rows = memory_new(passes > 1 ? size * (size_t)r->height : size);
    for (int pass = 1; pass < passes; pass++)
        for (int y = 0; y < r->height; y++)
            png_read_row(png, r->rows + size * (size_t)y, NULL);
    return true;
}

/* One row of the file as RGBA. */
static void png_take_row(const struct png_reader *r, const unsigned char *row,
                         float *out)
{
    bool grey = r->channels < 3;
    for (int x = 0; x < r->width; x++, out += 4) {
        float in[4] = { 0 };
        for (int c = 0; c < r->channels; c++, row += r->depth / 8)
            in[c] = r->depth == 16
                        ? (float)(row[0] << 8 | row[1]) * (1.0f / 65535)
                        : (float)row[0] * (1.0f / 255);
        out[3] = r->target->has_alpha ? in[r->channels - 1] : 1;
        for (int c = 0; c < 3; c++)
            out[c] = in[grey ? 0 : c];
    }
}

/* As png_write about setjmp. */
static bool png_read(struct png_reader *r)
{
    png_structp png = png_create_read_struct(PNG_LIBPNG_VER_STRING, &r->trouble,
                                             png_report, png_ignore);
    png_infop info = png ? png_create_info_struct(png) : NULL;
    if (!info) {
        snprintf(r->trouble.error, r->trouble.size, "libpng can't start");
        png_destroy_read_struct(&png, NULL, NULL);
        return false;
    }
    if (setjmp(png_jmpbuf(png))) {
        png_destroy_read_struct(&png, &info, NULL);
        return false;
    }
    bool begun = png_begin(png, info, r);
    bool whole = png_get_interlace_type(png, info) != PNG_INTERLACE_NONE;
    size_t line = 4 * (size_t)r->width;
    size_t size = whole ? png_get_rowbytes(png, info) : 0;
    for (int y = 0; begun && y < r->height; y++) {
        unsigned char *row = r->rows + size * (size_t)y;
        png_read_row(png, row, NULL);
        png_take_row(r, row,
                     r->pixels + (r->target->take ? 0 : line * (size_t)y));
        if (r->target->take)
            r->target->take(r->target->context, y);
    }
    if (begun)
        png_read_end(png, NULL);
    png_destroy_read_struct(&png, &info, NULL);
    return begun;
}

bool png_decode(const char *path, struct codec_target *target, char *error,
                size_t size)
{
    struct png_reader reader = {
        .target = target,
        .trouble = { error, size },
        .file = fopen(path, "rb"),
    };
    if (!reader.file) {
        snprintf(error, size, "%s", strerror(errno));
        return false;
    }
    bool done = png_read(&reader);
    memory_free(reader.rows);
    fclose(reader.file);
    return done;
}
