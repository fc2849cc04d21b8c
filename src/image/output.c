/* Working space to file numbers: see output.h. */
#include "image/output.h"

#include "base/parallel.h"
#include "base/rgb.h"
#include "image/tone.h"

enum { TABLE_WORTH = 30000 }; /* pixels; a table costs 20,000 powers */

/* The largest half and, nearly, the largest float: what is beyond would become
 * infinite in the file. */
static const double largest_half = 65504, largest_float = 1e38;

static double output_clamp(double value, double low, double high)
{
    if (!(value > low)) /* NaN too */
        return value <= low ? low : 0;
    return value < high ? value : high;
}

/* Of linear light before clipping (measured). */
static void output_grey(double c[3])
{
    c[0] = c[1] = c[2] = grey_of(c[0], c[1], c[2]);
}

struct conversion {
    struct image *image;
    const struct output_space *space;
    const struct tone_table
        *table; /* of levels of the working space, or NULL */
};

/* The curves of the two sides. Numbers that are kept are decoded and encoded by
 * the same one, between which they are clipped. */
static double space_gamma(const struct output_space *space)
{
    return space->keep_numbers ? 0 : space->working_gamma;
}

static double space_file(const struct output_space *space)
{
    return space->keep_numbers ? 0 : space->file_gamma;
}

/* Undoes the premultiplication: POV-Ray does in the working space. */
static void pixel_straighten(float *pixel, double alpha)
{
    for (int i = 0; i < 3; i++)
        pixel[i] = (float)((double)pixel[i] / alpha);
}

static void output_pixel(float *pixel, const struct output_space *space)
{
    double alpha = output_clamp((double)pixel[3], 0, 1);
    double gamma = space_gamma(space);
    double most = space->half ? largest_half : largest_float;
    /* POV-Ray decodes premultiplied numbers for float files. */
    if (space->alpha && !space->linear_file && alpha > 0)
        pixel_straighten(pixel, alpha);
    double c[3] = { (double)pixel[0], (double)pixel[1], (double)pixel[2] };
    for (int i = 0; gamma != 1 && i < 3; i++)
        c[i] = tone_decode(c[i], gamma);
    if (space->grey)
        output_grey(c);
    for (int i = 0; i < 3; i++) {
        if (space->linear_file)
            c[i] = output_clamp(c[i], space->no_negative ? 0 : -most, most);
        else
            c[i] = tone_encode(output_clamp(c[i], 0, 1), space_file(space));
        pixel[i] = (float)c[i];
    }
    pixel[3] = (float)alpha;
}

enum { RUN = 64 }; /* pixels at once */

/* As output_pixel, where each channel has a level of its own. */
static void output_by_table(float *pixels, size_t count,
                            const struct conversion *conversion)
{
    const struct tone_table *table = conversion->table;
    int32_t levels[4 * RUN];
    for (size_t p = 0; p < count; p++) {
        double alpha = output_clamp((double)pixels[4 * p + 3], 0, 1);
        if (conversion->space->alpha && alpha > 0)
            pixel_straighten(pixels + 4 * p, alpha);
    }
    tone_table_levels(table, pixels, 4 * count, levels);
    for (size_t i = 0; i < 4 * count; i++)
        pixels[i] = i % 4 < 3 ? table->number[levels[i]]
                              : (float)output_clamp((double)pixels[i], 0, 1);
}

static void output_row(void *context, size_t row, unsigned thread)
{
    const struct conversion *conversion = context;
    const struct image *image = conversion->image;
    size_t wide = (size_t)image->width;
    float *pixels = image_pixel(image, 0, (int)row);
    (void)thread;
    if (!conversion->table)
        for (size_t x = 0; x < wide; x++)
            output_pixel(pixels + 4 * x, conversion->space);
    for (size_t x = 0; conversion->table && x < wide; x += RUN)
        output_by_table(pixels + 4 * x, wide - x < RUN ? wide - x : RUN,
                        conversion);
}

static bool output_is_table(const struct output_space *space)
{
    return space->bits > 0 && space->bits <= 8 && !space->linear_file &&
           !space->grey;
}

void output_levels_fill(const struct output_space *space,
                        struct tone_table *table)
{
    tone_table_fill(table, space_gamma(space), space_file(space),
                    (1u << space->bits) - 1);
}

void output_convert(struct image *image, const struct output_space *space,
                    unsigned threads)
{
    struct conversion conversion = { image, space, NULL };
    struct tone_table table;
    size_t pixels = (size_t)image->width * (size_t)image->height;
    if (output_is_table(space) && pixels >= TABLE_WORTH) {
        output_levels_fill(space, &table);
        conversion.table = &table;
    }
    parallel_run(threads, (size_t)image->height, NULL, output_row, &conversion);
}

bool output_has_levels(const struct output_space *space)
{
    return output_is_table(space) && !space->alpha;
}

void output_levels_of(const struct tone_table *table, const float *pixels,
                      size_t count, unsigned char *levels)
{
    int32_t found[4 * RUN];
    for (size_t from = 0; from < count; from += RUN) {
        size_t run = count - from < RUN ? count - from : RUN;
        tone_table_levels(table, pixels + 4 * from, 4 * run, found);
        for (size_t p = 0; p < run; p++, levels += OUTPUT_LEVELS)
            for (int i = 0; i < OUTPUT_LEVELS; i++)
                levels[i] = (unsigned char)found[4 * p + (size_t)i];
    }
}

void output_levels_working(const struct tone_table *table,
                           const unsigned char *levels, size_t count,
                           float *pixels)
{
    for (size_t p = 0; p < count; p++, pixels += 4, levels += OUTPUT_LEVELS) {
        for (int i = 0; i < OUTPUT_LEVELS; i++)
            pixels[i] =
                table->begin[levels[i] < table->top ? levels[i] : table->top];
        pixels[3] = 1;
    }
}

void output_levels_numbers(const struct tone_table *table,
                           const unsigned char *levels, size_t count,
                           float *pixels)
{
    for (size_t p = 0; p < count; p++, pixels += 4, levels += OUTPUT_LEVELS) {
        for (int i = 0; i < OUTPUT_LEVELS; i++)
            pixels[i] =
                table->number[levels[i] < table->top ? levels[i] : table->top];
        pixels[3] = 1;
    }
}
