/* Reading GIF files (CompuServe, "Graphics Interchange Format, Version 89a",
 * 1990): the first picture, as large as it says it is, wherever it stands on
 * the screen that the file is for (measured: POV-Ray's). */
#include "image/gif.h"

#include <errno.h>
#include <stdio.h>
#include <string.h>

#include "base/memory.h"

enum {
    CODES = 4096,       /* of LZW: 12 bits */
    ENTRIES = 256,      /* of a palette */
    HAS_PALETTE = 0x80, /* flags */
    INTERLACED = 0x40,
    EXTENSION = 0x21, /* blocks */
    PICTURE = 0x2c,
    CONTROL = 0xf9, /* of a picture: the extension that says what is clear */
};

struct gif {
    FILE *file;
    int width, height;
    bool interlaced, coloured;         /* coloured: there is a palette */
    unsigned char palette[ENTRIES][3]; /* black where the file has none */
    int clear;                         /* the entry that is; -1: none */
    /* The bits of the data, in blocks of bytes. */
    unsigned bits, bit_count, block_left;
    bool ended;
};

static int gif_byte(struct gif *gif)
{
    int byte = getc(gif->file);
    gif->ended = gif->ended || byte == EOF;
    return byte == EOF ? 0 : byte;
}

static int gif_short(struct gif *gif)
{
    int low = gif_byte(gif);
    return low | gif_byte(gif) << 8;
}

static void gif_skip(struct gif *gif, int count)
{
    while (count-- > 0 && !gif->ended)
        gif_byte(gif);
}

static void gif_palette(struct gif *gif, int flags)
{
    if (!(flags & HAS_PALETTE))
        return;
    gif->coloured = true;
    for (int i = 0; i < 2 << (flags & 7); i++)
        for (int c = 0; c < 3; c++)
            gif->palette[i][c] = (unsigned char)gif_byte(gif);
}

/* Blocks of bytes, each after its size, up to an empty one. */
static void gif_extension(struct gif *gif)
{
    bool control = gif_byte(gif) == CONTROL;
    for (int size = gif_byte(gif); size && !gif->ended; size = gif_byte(gif)) {
        if (control && size >= 4) {
            bool clear = gif_byte(gif) & 1;
            gif_skip(gif, 2);
            int entry = gif_byte(gif);
            gif->clear = clear ? entry : -1;
            size -= 4;
        }
        gif_skip(gif, size);
    }
}

/* Up to the picture's data. False: there is none. */
static bool gif_find_picture(struct gif *gif)
{
    gif_skip(gif, 10);
    int flags = gif_byte(gif);
    gif_skip(gif, 2);
    gif_palette(gif, flags);
    while (!gif->ended) {
        int kind = gif_byte(gif);
        if (kind == EXTENSION) {
            gif_extension(gif);
        } else if (kind == PICTURE) {
            gif_skip(gif, 4);
            gif->width = gif_short(gif);
            gif->height = gif_short(gif);
            flags = gif_byte(gif);
            gif->interlaced = flags & INTERLACED;
            gif_palette(gif, flags);
            return !gif->ended;
        } else {
            return false;
        }
    }
    return false;
}

/* The next code of so many bits; -1 after the last. */
static int gif_code(struct gif *gif, unsigned size)
{
    while (gif->bit_count < size) {
        if (gif->block_left == 0)
            gif->block_left = (unsigned)gif_byte(gif);
        if (gif->block_left == 0 || gif->ended)
            return -1;
        gif->bits |= (unsigned)gif_byte(gif) << gif->bit_count;
        gif->bit_count += 8;
        gif->block_left--;
    }
    int code = (int)(gif->bits & ((1U << size) - 1));
    gif->bits >>= size;
    gif->bit_count -= size;
    return code;
}

/* What codes stand for: what `before` does and one number more. */
struct gif_table {
    short before[CODES];
    unsigned char last[CODES], first[CODES];
    short length[CODES];
    int count, clear;
    unsigned size; /* of codes, in bits */
};

static void table_clear(struct gif_table *table, unsigned least)
{
    table->clear = 1 << least;
    table->count = table->clear + 2;
    table->size = least + 1;
    for (int i = 0; i < table->clear; i++) {
        table->before[i] = -1;
        table->first[i] = table->last[i] = (unsigned char)i;
        table->length[i] = 1;
    }
}

static void table_add(struct gif_table *table, int before, unsigned char last)
{
    if (table->count == CODES)
        return;
    int i = table->count++;
    table->before[i] = (short)before;
    table->last[i] = last;
    table->first[i] = table->first[before];
    table->length[i] = (short)(table->length[before] + 1);
    if (table->count == 1 << table->size && table->size < 12)
        table->size++;
}

/* Writes what the code stands for, as far as there is room; returns how much.
 */
static size_t table_write(const struct gif_table *table, int code,
                          unsigned char *out, size_t room)
{
    size_t length = (size_t)table->length[code];
    for (size_t i = length; i-- > 0; code = table->before[code])
        if (i < room)
            out[i] = table->last[code];
    return length < room ? length : room;
}

/* False: it is cut short or broken. */
static bool gif_unpack(struct gif *gif, unsigned char *out, size_t count)
{
    struct gif_table table;
    unsigned least = (unsigned)gif_byte(gif);
    size_t done = 0;
    int before = -1;
    if (least < 2 || least > 8)
        return false;
    table_clear(&table, least);
    while (done < count) {
        int code = gif_code(gif, table.size);
        if (code == table.clear) {
            table_clear(&table, least);
            before = -1;
            continue;
        }
        bool known = code >= 0 && code < table.count &&
                     (code < table.clear || code > table.clear + 1);
        bool next = code == table.count && before >= 0 && code < CODES;
        if (!known && !next)
            return false;
        if (before >= 0)
            table_add(&table, before, table.first[known ? code : before]);
        done += table_write(&table, code, out + done, count - done);
        before = code;
    }
    return true;
}

/* The row of the picture that is number `i` in the file. */
static int gif_row(const struct gif *gif, int i)
{
    static const int first[] = { 0, 4, 2, 1 }, step[] = { 8, 8, 4, 2 };
    if (!gif->interlaced)
        return i;
    for (int pass = 0; pass < 4; pass++) {
        int rows = (gif->height - first[pass] + step[pass] - 1) / step[pass];
        if (i < rows)
            return first[pass] + i * step[pass];
        i -= rows > 0 ? rows : 0;
    }
    return 0;
}

/* What an entry of the palette, or its number, is as a pixel. */
static void gif_pixel(const struct gif *gif, int number, bool indexed,
                      float pixel[4])
{
    for (int c = 0; c < 3; c++)
        pixel[c] = (float)(indexed ? number : gif->palette[number][c]) / 255;
    pixel[3] = !indexed && number == gif->clear ? 0 : 1;
}

static void gif_give(const struct gif *gif, const unsigned char *numbers,
                     const int *place, float *pixels,
                     struct codec_target *target)
{
    size_t width = (size_t)gif->width;
    for (int y = 0; y < gif->height; y++) {
        float *row = target->take ? pixels : pixels + 4 * width * (size_t)y;
        for (size_t x = 0; x < width; x++)
            gif_pixel(gif, numbers[(size_t)place[y] * width + x],
                      target->indexed, row + 4 * x);
        if (target->take)
            target->take(target->context, y);
    }
}

static void gif_describe(const struct gif *gif, struct codec_target *target)
{
    target->palette = true;
    target->indexed = target->numbers;
    target->has_alpha = !target->indexed && gif->clear >= 0;
    target->channels = target->has_alpha ? 4 : 3;
    target->bits = 8;
}

static bool gif_read(struct gif *gif, struct codec_target *target, char *error,
                     size_t size)
{
    if (!gif_find_picture(gif))
        return false;
    gif_describe(gif, target);
    if (!target->indexed && !gif->coloured) {
        snprintf(error, size, "it has no palette");
        return false;
    }
    float *pixels =
        target->allocate(target->context, gif->width, gif->height, error, size);
    if (!pixels)
        return false;
    size_t count = (size_t)gif->width * (size_t)gif->height;
    unsigned char *numbers = memory_new(count);
    int *place = memory_new((size_t)gif->height * sizeof *place);
    for (int i = 0; i < gif->height; i++)
        place[gif_row(gif, i)] = i;
    bool whole = gif_unpack(gif, numbers, count);
    if (whole)
        gif_give(gif, numbers, place, pixels, target);
    memory_free(place);
    memory_free(numbers);
    return whole;
}

bool gif_decode(const char *path, struct codec_target *target, char *error,
                size_t size)
{
    struct gif gif = { .file = fopen(path, "rb"), .clear = -1 };
    if (!gif.file) {
        snprintf(error, size, "%s", strerror(errno));
        return false;
    }
    bool done = gif_read(&gif, target, error, size);
    fclose(gif.file);
    return done;
}
