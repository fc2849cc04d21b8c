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

/* The same for 0 to 1, in two instructions. */
static inline double share_of_1(double value)
{
    value = value > 0 ? value : 0;
    return value < 1 ? value : 1;
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

static void output_pixel(float *pixel, const struct output_space *space)
{
    double alpha = output_clamp((double)pixel[3], 0, 1);
    double c[3] = { (double)pixel[0], (double)pixel[1], (double)pixel[2] };
    double gamma = space_gamma(space);
    /* POV-Ray undoes the premultiplication in the working space, yet decodes
     * premultiplied numbers for float files. */
    bool straight = space->alpha && !space->linear_file && alpha > 0;
    double most = space->half ? largest_half : largest_float;
    for (int i = 0; straight && i < 3; i++)
        c[i] /= alpha;
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

/* As output_pixel, where each channel has a level of its own. */
static void output_levels(float *pixel, const struct conversion *conversion)
{
    const struct tone_table *table = conversion->table;
    double alpha = share_of_1((double)pixel[3]);
    double whole = conversion->space->alpha && alpha > 0 ? alpha : 1;
    for (int i = 0; i < 3; i++) {
        double v = share_of_1((double)pixel[i] / whole);
        pixel[i] = table->number[tone_table_level(table, v)];
    }
    pixel[3] = (float)alpha;
}

static void output_row(void *context, size_t row, unsigned thread)
{
    const struct conversion *conversion = context;
    const struct image *image = conversion->image;
    (void)thread;
    for (int x = 0; x < image->width; x++) {
        float *pixel = image_pixel(image, x, (int)row);
        if (conversion->table)
            output_levels(pixel, conversion);
        else
            output_pixel(pixel, conversion->space);
    }
}

void output_convert(struct image *image, const struct output_space *space,
                    unsigned threads)
{
    struct conversion conversion = { image, space, NULL };
    struct tone_table table;
    size_t pixels = (size_t)image->width * (size_t)image->height;
    if (space->bits > 0 && space->bits <= 8 && !space->linear_file &&
        !space->grey && pixels >= TABLE_WORTH) {
        tone_table_fill(&table, space_gamma(space), space_file(space),
                        (1u << space->bits) - 1);
        conversion.table = &table;
    }
    parallel_run(threads, (size_t)image->height, NULL, output_row, &conversion);
}
