/* The picture on display: see canvas.h. */
#include "view/canvas.h"

#include <math.h>

#include "base/memory.h"
#include "base/rgb.h"

enum { LEVELS = 255 };

void canvas_start(struct canvas *canvas)
{
    *canvas = (struct canvas){ .lock = SDL_CreateMutex() };
}

void canvas_end(struct canvas *canvas)
{
    memory_free(canvas->pixels);
    memory_free(canvas->layer);
    SDL_DestroyMutex(canvas->lock);
}

void canvas_resize(struct canvas *canvas, int width, int height)
{
    if (canvas->width == width && canvas->height == height)
        return;
    size_t size = (size_t)width * (size_t)height * sizeof *canvas->pixels;
    unsigned *pixels = memory_new(size);
    SDL_LockMutex(canvas->lock);
    for (int y = 0; canvas->pixels && y < height; y++) {
        size_t from = (size_t)y * (size_t)canvas->height / (size_t)height;
        for (int x = 0; x < width; x++)
            pixels[(size_t)y * (size_t)width + (size_t)x] =
                canvas
                    ->pixels[from * (size_t)canvas->width +
                             (size_t)x * (size_t)canvas->width / (size_t)width];
    }
    memory_free(canvas->pixels);
    memory_free(canvas->layer);
    canvas->layer = NULL;
    canvas->pixels = pixels;
    canvas->width = width;
    canvas->height = height;
    canvas->changes++;
    SDL_UnlockMutex(canvas->lock);
}

void canvas_tone(struct canvas_tone *tone, const struct output_space *space)
{
    tone->gamma = space->working_gamma;
    tone->keep = space->keep_numbers;
    tone->grey = space->grey;
    tone_table_fill(&tone->table, 1, 0, LEVELS);
}

/* Light, or what is no number, in 0..1. */
static double tone_light(const struct canvas_tone *tone, float value)
{
    double v = (double)value;
    if (!tone->keep && tone->gamma != 1)
        v = tone_decode(v, tone->gamma);
    return v > 0 ? (v < 1 ? v : 1) : 0;
}

static unsigned tone_number(const struct canvas_tone *tone, double light)
{
    return tone_table_level(&tone->table, (float)light);
}

static unsigned tone_colour(const struct canvas_tone *tone, const float *pixel)
{
    double c[3];
    if (tone->keep && !tone->grey)
        return tone_level(pixel[0], LEVELS) << 16 |
               tone_level(pixel[1], LEVELS) << 8 | tone_level(pixel[2], LEVELS);
    for (int i = 0; i < 3; i++)
        c[i] = tone_light(tone, pixel[i]);
    if (tone->grey)
        c[0] = c[1] = c[2] = grey_of(c[0], c[1], c[2]);
    return tone_number(tone, c[0]) << 16 | tone_number(tone, c[1]) << 8 |
           tone_number(tone, c[2]);
}

static void canvas_fill(struct canvas *canvas, int left, int top, int step,
                        unsigned tint)
{
    int right = left + step < canvas->width ? left + step : canvas->width;
    int bottom = top + step < canvas->height ? top + step : canvas->height;
    for (int y = top; y < bottom; y++)
        for (int x = left; x < right; x++)
            canvas->pixels[(size_t)y * (size_t)canvas->width + (size_t)x] =
                tint;
}

void canvas_put(struct canvas *canvas, const struct canvas_tone *tone,
                const struct render_part *part, int step)
{
    const struct area *area = &part->area;
    size_t count = area_pixels(*area);
    size_t wide = (size_t)(area->right - area->left);
    unsigned *colours = memory_new(count * sizeof *colours);
    for (size_t i = 0; i < count; i++)
        colours[i] = tone_colour(tone, part->pixels + 4 * i);
    SDL_LockMutex(canvas->lock);
    for (size_t i = 0; i < count; i++)
        canvas_fill(canvas, (area->left + (int)(i % wide)) * step,
                    (area->top + (int)(i / wide)) * step, step, colours[i]);
    canvas->changes++;
    SDL_UnlockMutex(canvas->lock);
    memory_free(colours);
}

/* A colour that was multiplied by its opacity. */
static unsigned tone_layer(const struct canvas_tone *tone, const float *pixel)
{
    float ink[3], opacity = fminf(pixel[3], 1);
    if (!(opacity > 0))
        return 0;
    for (int i = 0; i < 3; i++)
        ink[i] = pixel[i] / opacity;
    return (unsigned)(opacity * LEVELS + 0.5f) << 24 | tone_colour(tone, ink);
}

void canvas_lay(struct canvas *canvas, const struct canvas_tone *tone,
                const struct image *image)
{
    size_t count = image ? (size_t)image->width * (size_t)image->height : 0;
    unsigned *layer = image ? memory_new(count * sizeof *layer) : NULL;
    for (size_t i = 0; i < count; i++)
        layer[i] = tone_layer(tone, image->pixels + 4 * i);
    SDL_LockMutex(canvas->lock);
    canvas->changes += layer || canvas->layer;
    memory_free(canvas->layer);
    canvas->layer = layer;
    SDL_UnlockMutex(canvas->lock);
}
