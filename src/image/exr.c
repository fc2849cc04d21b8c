/* OpenEXR files of scan lines, 16 to a block, each block compressed by zlib
 * (openexr.com, "OpenEXR File Layout"). OpenImageIO could write them, but is
 * loaded for longer than a picture takes to write, and puts the date in. */
#include "image/exr.h"

#include <errno.h>
#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>
#include <zlib.h>

#include "base/array.h"
#include "base/memory.h"

enum {
    BLOCK = 16, /* rows, as ZIP has them */
    ZIP = 3,    /* compression */
    HALF = 1,
    FLOAT = 2,
    LEVEL = 3, /* of zlib: half of the time of level 6, files 2 % larger */
};

struct exr_job {
    const struct image_bands *bands;
    const struct image *band; /* the last one that was given, */
    int top;                  /* and where in the picture it is */
    struct arena *arena;
    struct {
        unsigned char *items;
        size_t count, capacity;
    } file;
    int channels;     /* of the file, in its order, that of the alphabet: */
    int source[4];    /* where each is in an RGBA pixel */
    const char *name; /* and the letters of all */
    int type;         /* HALF or FLOAT */
    size_t row;       /* bytes */
    size_t written;   /* to the sink */
};

static void exr_put(struct exr_job *job, const void *bytes, size_t count)
{
    if (count > job->file.capacity - job->file.count)
        ARRAY_RESERVE(job->arena, &job->file, 2 * job->file.count + count);
    memcpy(job->file.items + job->file.count, bytes, count);
    job->file.count += count;
}

/* Numbers have their lowest byte first. */
static void exr_number_at(unsigned char *at, uint64_t number, int size)
{
    for (int i = 0; i < size; i++)
        at[i] = (unsigned char)(number >> 8 * i);
}

static void exr_put_number(struct exr_job *job, uint64_t number, int size)
{
    unsigned char bytes[8];
    exr_number_at(bytes, number, size);
    exr_put(job, bytes, (size_t)size);
}

static uint32_t exr_bits(float value)
{
    uint32_t bits;
    memcpy(&bits, &value, sizeof bits);
    return bits;
}

/* The nearest half float, of two the even one. */
static uint16_t exr_half(float value)
{
    uint32_t bits = exr_bits(value);
    uint32_t sign = bits >> 16 & 0x8000, size = bits & 0x7fffffff;
    if (size > 0x7f800000) /* not a number */
        size = 0x7e00;
    else if (size >= 0x477ff000) /* 65520: infinite */
        size = 0x7c00;
    else if (size < 0x38800000) /* 2^-14: steps of 2^-24 from here down */
        size = (uint32_t)lrintf(fabsf(value) * 16777216.0f);
    else
        size = (size - 0x38000000 + 0xfff + (size >> 13 & 1)) >> 13;
    return (uint16_t)(sign | size);
}

static void exr_attribute(struct exr_job *job, const char *name,
                          const char *type, size_t size)
{
    exr_put(job, name, strlen(name) + 1);
    exr_put(job, type, strlen(type) + 1);
    exr_put_number(job, size, 4);
}

static void exr_put_channels(struct exr_job *job)
{
    exr_attribute(job, "channels", "chlist", 18 * (size_t)job->channels + 1);
    for (int c = 0; c < job->channels; c++) {
        char name[2] = { job->name[c], '\0' };
        exr_put(job, name, sizeof name);
        exr_put_number(job, (uint64_t)job->type, 4);
        exr_put_number(job, 0, 4); /* light, not as it is perceived */
        exr_put_number(job, 1, 4); /* all pixels of a row, and all rows */
        exr_put_number(job, 1, 4);
    }
    exr_put_number(job, 0, 1);
}

static void exr_put_box(struct exr_job *job, const char *name)
{
    exr_attribute(job, name, "box2i", 16);
    exr_put_number(job, 0, 8);
    exr_put_number(job, (uint64_t)job->bands->width - 1, 4);
    exr_put_number(job, (uint64_t)job->bands->height - 1, 4);
}

static void exr_put_text(struct exr_job *job, const char *name,
                         const char *text)
{
    exr_attribute(job, name, "string", strlen(text));
    exr_put(job, text, strlen(text));
}

static void exr_put_header(struct exr_job *job, const char *note)
{
    static const char software[] = "glim " GLIM_VERSION;
    exr_put_number(job, 20000630, 4); /* the format's mark, and version 2 */
    exr_put_number(job, 2, 4);
    exr_put_channels(job);
    exr_attribute(job, "compression", "compression", 1);
    exr_put_number(job, ZIP, 1);
    exr_put_box(job, "dataWindow");
    exr_put_box(job, "displayWindow");
    exr_attribute(job, "lineOrder", "lineOrder", 1);
    exr_put_number(job, 0, 1); /* the top row first */
    exr_attribute(job, "pixelAspectRatio", "float", 4);
    exr_put_number(job, exr_bits(1), 4);
    exr_attribute(job, "screenWindowCenter", "v2f", 8);
    exr_put_number(job, 0, 8);
    exr_attribute(job, "screenWindowWidth", "float", 4);
    exr_put_number(job, exr_bits(1), 4);
    exr_put_text(job, "software", software);
    if (note)
        exr_put_text(job, "glim", note);
    exr_put_number(job, 0, 1);
}

/* The first pixel of a row, or NULL. */
static const float *exr_row(struct exr_job *job, int y)
{
    if (!job->band || y >= job->top + job->band->height)
        job->band = job->bands->at(job->bands->context, y, &job->top);
    return job->band ? image_pixel(job->band, 0, y - job->top) : NULL;
}

static void exr_fill_row(const struct exr_job *job, const float *row,
                         unsigned char *out)
{
    for (int c = 0; c < job->channels; c++) {
        const float *in = row + job->source[c];
        for (int x = 0; x < job->bands->width; x++, in += 4) {
            bool half = job->type == HALF;
            exr_number_at(out, half ? exr_half(*in) : exr_bits(*in),
                          half ? 2 : 4);
            out += half ? 2 : 4;
        }
    }
}

/* What ZIP does before zlib: bytes at even places, then those at odd ones, and
 * of each the difference from the one before. */
static void exr_predict(const unsigned char *raw, size_t count,
                        unsigned char *out)
{
    unsigned char before = 128;
    for (size_t i = 0; i < count; i++) {
        size_t half = (count + 1) / 2;
        unsigned char byte = raw[i < half ? 2 * i : 2 * (i - half) + 1];
        out[i] = (unsigned char)(byte - before + 128);
        before = byte;
    }
    out[0] = raw[0];
}

/* Rows from y on, after what job->file has. */
static const char *exr_put_block(struct exr_job *job, int y)
{
    int rows = job->bands->height - y < BLOCK ? job->bands->height - y : BLOCK;
    size_t count = job->row * (size_t)rows;
    uLongf packed = compressBound(count);
    unsigned char *raw = memory_new(2 * count + packed);
    unsigned char *changed = raw + count, *small = changed + count;
    const char *problem = NULL;
    for (int i = 0; i < rows && !problem; i++) {
        const float *row = exr_row(job, y + i);
        if (row)
            exr_fill_row(job, row, raw + job->row * (size_t)i);
        else
            problem = "what was drawn can't be read back";
    }
    exr_predict(raw, count, changed);
    if (!problem && compress2(small, &packed, changed, count, LEVEL) != Z_OK)
        problem = strerror(ENOMEM);
    exr_put_number(job, (uint64_t)y, 4);
    bool pays = packed < count;
    exr_put_number(job, pays ? packed : count, 4);
    exr_put(job, pays ? small : raw, pays ? packed : count);
    memory_free(raw);
    return problem;
}

static void exr_choose(struct exr_job *job, const struct image_format *format)
{
    static const int colours[] = { 3, 2, 1, 0 }, grey[] = { 3, 0 };
    bool alpha = format->alpha;
    job->channels = (format->grey ? 1 : 3) + (alpha ? 1 : 0);
    job->name = (format->grey ? "AY" : "ABGR") + (alpha ? 0 : 1);
    for (int c = 0; c < job->channels; c++)
        job->source[c] = (format->grey ? grey : colours)[c + (alpha ? 0 : 1)];
    job->type = format->bits > 16 ? FLOAT : HALF;
    job->row = (size_t)job->bands->width * (size_t)job->channels *
               (job->type == FLOAT ? 4 : 2);
}

/* What job->file has goes to the sink. */
static bool exr_flush(struct exr_job *job, const struct codec_sink *sink,
                      char *error, size_t size)
{
    bool done =
        sink->put(sink->context, job->file.items, job->file.count, error, size);
    job->written += job->file.count;
    job->file.count = 0;
    return done;
}

/* The blocks, and then where they are, which stands before them. */
static bool exr_put_blocks(struct exr_job *job, const struct codec_sink *sink,
                           char *error, size_t size)
{
    size_t count = ((size_t)job->bands->height + BLOCK - 1) / BLOCK;
    size_t table = job->written;
    unsigned char *places = memory_new(8 * count);
    bool done = sink->put(sink->context, places, 8 * count, error, size);
    job->written += 8 * count;
    for (size_t i = 0; done && i < count; i++) {
        exr_number_at(places + 8 * i, job->written, 8);
        const char *problem = exr_put_block(job, (int)i * BLOCK);
        if (problem)
            snprintf(error, size, "%s", problem);
        done = !problem && exr_flush(job, sink, error, size);
    }
    done = done &&
           sink->patch(sink->context, table, places, 8 * count, error, size);
    memory_free(places);
    return done;
}

bool exr_encode(const struct image_bands *bands,
                const struct image_format *format,
                const struct codec_sink *sink, char *error, size_t size)
{
    struct exr_job job = { .bands = bands, .arena = arena_new(0) };
    exr_choose(&job, format);
    exr_put_header(&job, format->note);
    bool done = exr_flush(&job, sink, error, size) &&
                exr_put_blocks(&job, sink, error, size);
    arena_free(job.arena);
    return done;
}
