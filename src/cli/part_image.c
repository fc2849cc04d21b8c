/* Pictures out of part files: see part_image.h. */
#include "cli/part_image.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/memory.h"
#include "base/writer.h"
#include "cli/origin.h"
#include "cli/output_name.h"
#include "cli/picture.h"
#include "image/tone.h"

/* After the origin, which ends with its files: the working space. */
static const char space_line[] = "\nspace ";

char *part_text(const struct settings *settings, const char *origin)
{
    size_t length = strlen(origin), room = length + 64;
    char *text = memory_new(room);
    length -= length > 0 && origin[length - 1] == '\n';
    snprintf(text, room, "%.*s%s%d %.17g\n", (int)length, origin, space_line,
             (int)settings->gamma_kind, settings->assumed_gamma);
    return text;
}

static double text_value(const char *text, const char *name)
{
    char value[64];
    return origin_value(text, name, value, sizeof value) ? strtod(value, NULL)
                                                         : 0;
}

/* The +F letter of a format's name, and how Targa is packed. */
static char text_letter(const char *text)
{
    char type[32];
    bool packed = text_value(text, "packed") != 0;
    if (!origin_value(text, "type", type, sizeof type))
        return '\0';
    for (size_t i = 0; output_type_at(i); i++)
        if (strcmp(output_type_at(i)->format, type) == 0)
            return packed ? 'C' : output_type_at(i)->letter;
    return '\0';
}

bool part_text_read(const char *text, struct options *options,
                    struct settings *settings, const char **origin,
                    struct arena *arena)
{
    int kind;
    const char *space = strstr(text, space_line);
    for (const char *more = space; more; more = strstr(more + 1, space_line))
        space = more;
    options->file_type = text_letter(text);
    if (!space || !options->file_type ||
        sscanf(space + sizeof space_line - 1, "%d %lf", &kind,
               &settings->assumed_gamma) != 2)
        return false;
    double bits = text_value(text, "bits");
    if (kind < GAMMA_NONE || kind > GAMMA_SRGB || !(bits >= 0 && bits <= 32))
        return false;
    settings->gamma_kind = kind;
    options->bits = (int)bits;
    options->grey = text_value(text, "grey") != 0;
    options->alpha = text_value(text, "alpha") != 0;
    options->compression = (int)text_value(text, "compression");
    options->file_gamma = text_value(text, "gamma");
    *origin = arena_copy_text(arena, text, (size_t)(space - text) + 1);
    return true;
}

struct reading {
    struct part_file *const *files;
    size_t count;
    const struct options *options;
    const struct output_space *space;
    const struct tone_table *levels; /* NULL: the space has none */
    struct image *band;
    int top;
};

/* Where a row of a tile goes; NULL: not into the band. */
static float *reading_row(const struct reading *reading, struct area area,
                          int y)
{
    const struct image *band = reading->band;
    bool there = y >= reading->top && y < reading->top + band->height &&
                 area.left >= 0 && area.right <= band->width;
    return there ? image_pixel(band, area.left, y - reading->top) : NULL;
}

static void reading_take(void *context, struct area area, const void *values)
{
    const float *from = values;
    size_t wide = (size_t)(area.right - area.left) * 4;
    for (int y = area.top; y < area.bottom; y++, from += wide) {
        float *to = reading_row(context, area, y);
        if (to)
            memcpy(to, from, wide * sizeof *from);
    }
}

static void reading_take_levels(void *context, struct area area,
                                const void *values)
{
    const struct reading *reading = context;
    const unsigned char *from = values;
    size_t wide = (size_t)(area.right - area.left);
    for (int y = area.top; y < area.bottom; y++, from += wide * OUTPUT_LEVELS) {
        float *to = reading_row(reading, area, y);
        if (to)
            output_levels_numbers(reading->levels, from, wide, to);
    }
}

/* image_bands.at */
static const struct image *reading_at(void *context, int y, int *top)
{
    struct reading *reading = context;
    struct image *band = reading->band;
    const struct area all = { 0, y, band->width, y + band->height };
    reading->top = *top = y;
    memset(band->pixels, 0,
           (size_t)band->width * (size_t)band->height * 4 * sizeof(float));
    for (size_t i = 0; i < reading->count; i++)
        if (reading->levels)
            part_file_each(reading->files[i], PART_LEVELS, all,
                           reading_take_levels, reading);
        else
            part_file_each(reading->files[i], PART_PIXELS, all, reading_take,
                           reading);
    if (!reading->levels)
        output_convert(band, reading->space, reading->options->render.threads);
    return band;
}

bool part_image_write(struct part_file *const *files, size_t count,
                      const struct picture_file *picture, struct image *band,
                      struct diag *diag)
{
    const char *name = picture->name;
    struct image_format format;
    struct output_space space;
    struct tone_table levels;
    int width = part_file_width(files[0]), height = part_file_height(files[0]);
    int rows = part_band_rows(&picture->options->render, width);
    char why[256];
    picture_describe(picture->options, picture->settings, &format, &space);
    format.note = picture->origin;
    bool bands = image_has_bands(&format);
    struct reading reading = { .files = files,
                               .count = count,
                               .options = picture->options,
                               .space = &space };
    if (output_has_levels(&space)) {
        output_levels_fill(&space, &levels);
        reading.levels = &levels;
    }
    reading.band =
        band ? band : image_new(width, bands && rows < height ? rows : height);
    const struct image_bands source = { width, height, reading_at, &reading };
    bool done;
    if (bands) {
        done = image_write_bands(&source, name, &format, why, sizeof why);
    } else {
        int top;
        done = image_write(reading_at(&reading, 0, &top), name, &format, why,
                           sizeof why);
    }
    if (!band)
        image_free(reading.band);
    if (!done)
        diag_print(diag, DIAG_ERROR, span_none(), NULL, "can't write '%s': %s",
                   name, why);
    return done;
}

bool part_write(struct part *part, const struct settings *settings,
                const char *name, const char *origin, struct image *band)
{
    const struct picture_file picture = { part->options, settings, name,
                                          origin };
    return part_image_write(&part->keeper.file, 1, &picture, band, part->diag);
}
