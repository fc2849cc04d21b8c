/* glim-compare: two pictures, or a scene drawn by POV-Ray and by glim ->
 * figures, a heat map, a strip, an exit status. */
#include <errno.h>
#include <math.h>
#include <string.h>

#include "base/memory.h"
#include "cli/interrupt.h"
#include "compare/flip.h"
#include "compare/heat.h"
#include "compare/report.h"
#include "compare/scene.h"
#include "compare/ssim.h"
#include "image/file.h"

/* What a pixel takes at most, beside the pictures: FLIP's planes, or a strip.
 */
enum { WORK_BYTES = 100 };

enum status { ALIKE = 0, DIFFERENT = 1, TROUBLE = 2 };

static struct image *picture_read(const char *path, struct diag *diag)
{
    char why[512];
    struct image *image = image_read(path, why, sizeof why);
    if (!image)
        diag_print(diag, DIAG_ERROR, span_none(), NULL, "can't read '%s': %s",
                   path, why);
    return image;
}

/* Said here, since running out of memory would end with status 1. */
static bool pictures_fit(const struct image *image, struct diag *diag)
{
    double pixels = (double)image->width * image->height;
    double wanted = pixels * WORK_BYTES, there = (double)memory_available();
    if (wanted <= there)
        return true;
    diag_print(diag, DIAG_ERROR, span_none(), NULL,
               "comparing %d x %d pixels takes %.0f MiB, and there are %.0f",
               image->width, image->height, wanted / 1048576, there / 1048576);
    return false;
}

static bool pictures_match(struct image *const image[2],
                           const char *const names[2], struct diag *diag)
{
    if (image[0]->width == image[1]->width &&
        image[0]->height == image[1]->height)
        return pictures_fit(image[0], diag);
    diag_print(diag, DIAG_ERROR, span_none(), NULL,
               "'%s' has %d x %d pixels, '%s' %d x %d; only pictures of one "
               "size can be compared",
               names[0], image[0]->width, image[0]->height, names[1],
               image[1]->width, image[1]->height);
    return false;
}

/* The difference of each pixel that the heat map shows, but for FLIP: that of
 * the colour that differs most. */
static struct plane difference_map(const struct pair *pair, enum shown shown)
{
    const struct image *a = pair->image[0], *b = pair->image[1];
    struct plane map = plane_new(a->width, a->height);
    size_t pixels = (size_t)a->width * (size_t)a->height;
    for (size_t i = 0; i < 3 * pixels; i++) {
        double p = (double)a->pixels[i / 3 * 4 + i % 3];
        double q = (double)b->pixels[i / 3 * 4 + i % 3];
        double difference = p == q ? 0 : fabs(q - p);
        if (shown == SHOW_RELATIVE)
            difference /= fmax(fabs(p), FIGURES_DARK);
        if (!(difference <= (double)map.values[i / 3]))
            map.values[i / 3] =
                isnan(difference) ? HUGE_VALF : (float)difference;
    }
    return map;
}

static bool strip_write(const struct pair *pair, const struct image *heat,
                        const char *path, struct diag *diag)
{
    struct image *strip = heat_strip(pair, heat);
    if (!strip)
        diag_print(diag, DIAG_ERROR, span_none(), NULL,
                   "can't write '%s': three such pictures side by side are "
                   "too large; type --heat instead",
                   path);
    bool done = strip && heat_write(strip, path, diag);
    image_free(strip);
    return done;
}

static bool maps_write(const struct pair *pair, const struct plane *flip,
                       const struct choices *choices, struct diag *diag)
{
    if (!choices->heat && !choices->strip)
        return true;
    enum shown shown = choices_shown(choices);
    struct plane map = { .values = NULL };
    if (shown != SHOW_FLIP)
        map = difference_map(pair, shown);
    struct image *heat =
        heat_picture(shown == SHOW_FLIP ? flip : &map, choices_top(choices));
    bool done =
        !choices->strip || strip_write(pair, heat, choices->strip, diag);
    done = done && (!choices->heat || heat_write(heat, choices->heat, diag));
    image_free(heat);
    plane_free(&map);
    return done;
}

/* Everything about two pictures that are in memory; takes them over. */
static enum status pictures_compare(struct image *const image[2],
                                    const char *const names[2],
                                    const struct times *times,
                                    const struct choices *choices,
                                    struct diag *diag)
{
    struct pair pair = pair_new(image[0], image[1], choices_space(choices));
    struct plane flip = flip_map(&pair, choices->pixels_per_degree);
    struct report report = {
        .names = { names[0], names[1] },
        .pair = &pair,
        .figures = figures_find(&pair, choices->threshold),
        .flip = plane_mean(&flip, 0),
        .ssim = ssim_mean(&pair),
        .times = times,
    };
    bool written = maps_write(&pair, &flip, choices, diag);
    report_print(&report, choices);
    bool told = fflush(stdout) == 0; /* before the verdict on stderr */
    const char *why = strerror(errno);
    bool alike = report_alike(&report, choices, diag);
    plane_free(&flip);
    pair_free(&pair);
    if (!told) {
        diag_print(diag, DIAG_ERROR, span_none(), NULL,
                   "can't write standard output: %s", why);
        return TROUBLE;
    }
    return !written ? TROUBLE : alike ? ALIKE : DIFFERENT;
}

/* Reads both; false after an error was printed. */
static bool files_read(struct image *image[2], const char *const paths[2],
                       struct diag *diag)
{
    image[0] = picture_read(paths[0], diag);
    image[1] = image[0] ? picture_read(paths[1], diag) : NULL;
    return image[1];
}

static enum status files_compare(const struct choices *choices,
                                 struct diag *diag)
{
    struct image *image[2];
    if (files_read(image, choices->names, diag) &&
        pictures_match(image, choices->names, diag))
        return pictures_compare(image, choices->names, NULL, choices, diag);
    image_free(image[0]);
    image_free(image[1]);
    return TROUBLE;
}

static enum status scene_compare(struct choices *choices, struct arena *arena,
                                 struct diag *diag)
{
    static const char *const names[2] = { "POV-Ray", "glim" };
    if (!choices->strip)
        choices->strip = scene_strip_name(choices->names[0], arena);
    if (!heat_writable(choices->strip, diag))
        return TROUBLE;
    struct scene_pictures pictures;
    struct image *image[2] = { NULL, NULL };
    bool read =
        scene_draw(&pictures, choices, interrupt_catch(), arena, diag) &&
        files_read(image, pictures.paths, diag);
    scene_clean(&pictures);
    if (!read || !pictures_match(image, names, diag)) {
        image_free(image[0]);
        image_free(image[1]);
        return TROUBLE;
    }
    enum status status =
        pictures_compare(image, names, pictures.times, choices, diag);
    if (status != TROUBLE && !choices->quiet && !choices->csv)
        printf("%-24s %s\n", "the strip", choices->strip);
    return status;
}

static enum status choices_run(struct choices *choices, struct arena *arena,
                               struct diag *diag)
{
    if (choices->help)
        choices_help();
    else if (choices->version)
        printf("glim-compare %s\n", GLIM_VERSION);
    if (choices->help || choices->version)
        return ALIKE;
    if ((choices->heat && !heat_writable(choices->heat, diag)) ||
        (choices->strip && !heat_writable(choices->strip, diag)))
        return TROUBLE;
    if (choices->scene)
        return scene_compare(choices, arena, diag);
    return files_compare(choices, diag);
}

int main(int argc, char **argv)
{
    struct diag diag = diag_new();
    diag.program = "glim-compare";
    struct arena *arena = arena_new(0);
    struct choices choices;
    enum status status = TROUBLE;
    if (choices_parse(&choices, argc, argv, arena, &diag))
        status = choices_run(&choices, arena, &diag);
    arena_free(arena);
    return (int)status;
}
