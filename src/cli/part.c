/* Part files around a picture's drawing: see part.h. */
#include "cli/part.h"

#include <fcntl.h>
#include <math.h>
#include <stdio.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "base/clock.h"
#include "base/jobserver.h"
#include "base/memory.h"
#include "base/parallel.h"
#include "base/writer.h"
#include "cli/origin.h"
#include "cli/output_name.h"
#include "cli/part_image.h"
#include "cli/picture.h"
#include "tracer/integrator.h"

enum { WHY_SIZE = 600 };

/* Seconds of drawing before there is a file, whatever the picture, and for each
 * pixel and thread: putting one there takes 8 ns, of which there are few
 * enough then. */
static const double begin_after = 1, begin_pixel = 5e-7;
/* Seconds between two looks whether there is something for the disk. */
static const double look_pause = 0.05;

static int digits_of(int number)
{
    return snprintf(NULL, 0, "%d", number);
}

void part_name(const struct options *options, const char *name, char *path)
{
    const struct share *share = &options->render.share;
    const struct render_options *render = &options->render;
    int stem = (int)output_stem(name);
    if (share->count == 1 && strcmp(options->part, "strip") == 0)
        snprintf(path, PATH_MAX, "%.*s.rows%d-%dcolumns%d-%d.glim-part", stem,
                 name, render->row_start + 1, render->row_end,
                 render->column_start + 1, render->column_end);
    else if (share->count)
        snprintf(path, PATH_MAX, "%.*s.%0*dof%d.glim-part", stem, name,
                 digits_of(share->count), share->number, share->count);
    else
        snprintf(path, PATH_MAX, "%.*s.glim-part", stem, name);
}

/* Only what has a name and is a file can be gone on with; and where what the
 * lighting knows is wanted afterwards all of it must have been asked here. */
static bool part_is_possible(const struct options *options, const char *name)
{
    struct stat status;
    if (!name || strcmp(name, "-") == 0 || options->show ||
        options->light.light_mesh.save_file || options->debug_pixel)
        return false;
    return stat(name, &status) != 0 || S_ISREG(status.st_mode);
}

/* What is not on the disk is lost when power fails. */
static void part_sync(void *context)
{
    struct part *part = context;
    double start = clock_worked_here();
    part_file_sync(part->keeper.file);
    keeper_count(&part->keeper, start);
}

/* keeper.settle where the ticker does it: drawing doesn't wait for the disk. */
static void part_note(void *context)
{
    struct part *part = context;
    atomic_store(&part->unsettled, true);
}

static void part_tick(void *context)
{
    struct part *part = context;
    if (atomic_exchange(&part->unsettled, false))
        part_sync(part);
}

/* The picture is on the disk before the file goes that it was made of. */
static void part_settle(const struct part *part)
{
    int file = open(part->picture, O_RDONLY | O_CLOEXEC);
    if (file < 0)
        return;
    fsync(file);
    close(file);
}

static double part_begin(const struct render_options *render)
{
    double columns = render->column_end - render->column_start;
    double rows = render->row_end - render->row_start;
    unsigned threads = render->threads ? render->threads : 1;
    double pixels = begin_pixel * columns * rows / threads;
    return pixels > begin_after ? pixels : begin_after;
}

/* What would be rounded for the picture's file needs no more room here. */
static void part_use_levels(struct part *part)
{
    if (!output_has_levels(&part->space))
        return;
    output_levels_fill(&part->space, &part->levels);
    part->keeper.levels = &part->levels;
}

static struct part_file *part_create(void *context)
{
    struct part *part = context;
    part_use_levels(part);
    const struct render_options *render = &part->options->render;
    char why[256];
    struct part_file *file = part_file_create(
        part->path, part->text, render->width, render->height, why, sizeof why);
    if (!file && *why)
        diag_print(part->diag, DIAG_WARNING, span_none(), NULL,
                   "what is drawn can't be kept in '%s': %s", part->path, why);
    return file;
}

/* Whether the file is of what is drawn now; else the reason. */
static bool part_is_ours(const struct part *part, const struct part_file *file,
                         char *why, size_t size)
{
    const char *made = part_file_text(file);
    const struct render_options *render = &part->options->render;
    if (strcmp(made, part->text) == 0 &&
        part_file_width(file) == render->width &&
        part_file_height(file) == render->height)
        return true;
    struct arena *arena = arena_new(0);
    struct file_list seen = { .arena = arena };
    if (origin_same_settings(made, part->text, why, size) &&
        origin_same_files(made, &seen, why, size))
        snprintf(why, size, "it was drawn of other files");
    arena_free(arena);
    return false;
}

/* +C: what is there, or NULL. */
static struct part_file *part_take_up(struct part *part)
{
    char why[WHY_SIZE];
    if (access(part->path, F_OK) != 0)
        return NULL;
    struct part_file *file = part_file_open(part->path, why, sizeof why);
    if (!file && !*why)
        snprintf(why, sizeof why, "another glim is using it");
    if (file && part_is_ours(part, file, why, sizeof why)) {
        part_use_levels(part);
        return file;
    }
    part_file_close(file);
    diag_print(part->diag, DIAG_WARNING, span_none(), NULL,
               "'%s' is not gone on with: %s", part->path, why);
    return NULL;
}

bool part_start(struct part *part, const struct options *options,
                const struct settings *settings, const char *name,
                const char *origin, struct diag *diag)
{
    bool shared = options->render.share.count > 0;
    *part = (struct part){ .options = options, .diag = diag };
    part->keeper.state = KEEPER_OFF;
    if (!part_is_possible(options, name))
        return true;
    part_name(options, name, part->path);
    part->text = part_text(settings, origin);
    part->picture = name;
    struct image_format format;
    picture_describe(options, settings, &format, &part->space);
    /* Under make one thread more than there are tokens is one too many. */
    if (jobserver_state() == JOBSERVER_NONE)
        part->ticker = ticker_start(begin_after, look_pause, part_tick, part);
    part->keeper.settle = part->ticker ? part_note : part_sync;
    part->keeper.create = part_create;
    part->keeper.context = part;
    part->keeper.file = options->continue_trace ? part_take_up(part) : NULL;
    bool piece = shared || part_has_bands(options, name);
    keeper_start(&part->keeper,
                 clock_seconds() + (piece ? 0 : part_begin(&options->render)));
    if (!piece || keeper_ready(&part->keeper))
        return true;
    char why[256];
    if (part_file_open(part->path, why, sizeof why) == NULL && !*why)
        diag_print(diag, DIAG_ERROR, span_none(), NULL,
                   "'%s' is being drawn by another glim", part->path);
    else
        diag_print(diag, DIAG_ERROR, span_none(), NULL,
                   "%s needs '%s', which can't be written",
                   shared ? "--part" : "so large a picture", part->path);
    return false;
}

/* Pixels that are held in memory at most, of bands for each thread too; they
 * take 16 bytes, and 1 to 17 more while they are drawn. */
static const double whole_pixels = 4e6, band_pixels = 1e6,
                    thread_pixels = 1.3e5;

bool part_has_bands(const struct options *options, const char *name)
{
    const struct render_options *render = &options->render;
    const struct image_format format = options_format(options);
    bool targets = render->target_error > 0 || render->target_time > 0;
    return (double)render->width * render->height > whole_pixels &&
           part_is_possible(options, name) && image_has_bands(&format) &&
           !(integrator_for(options->lighting)->sample && targets);
}

int part_band_rows(const struct render_options *options, int width)
{
    double pixels = fmin(band_pixels, thread_pixels * options->threads);
    int bands = (int)(pixels / width / RENDER_BAND);
    return (bands > 1 ? bands : 1) * RENDER_BAND;
}

bool part_is_left(const struct part *part)
{
    return part->keeper.file && !part->options->render.share.count;
}

void part_make_room(struct part *part)
{
    struct part_file *file = part->keeper.file;
    if (file)
        part_file_flush(file);
    if (!file || !part_file_problem(file))
        return;
    ticker_stop(part->ticker);
    part->ticker = NULL;
    unlink(part->path);
    part_file_close(file);
    part->keeper.file = NULL;
}

bool part_finish(struct part *part, bool done)
{
    ticker_stop(part->ticker);
    struct part_file *file = part->keeper.file;
    if (file)
        part_file_flush(file);
    const char *problem = file ? part_file_problem(file) : NULL;
    bool shared = part->options && part->options->render.share.count;
    if (problem)
        diag_print(part->diag, shared ? DIAG_ERROR : DIAG_WARNING, span_none(),
                   NULL, "what was drawn could not be kept in '%s': %s",
                   part->path, problem);
    if (file && done)
        part_settle(part);
    if (part->text && done && !shared)
        unlink(part->path);
    part_file_close(file);
    memory_free(part->text);
    part->keeper.file = NULL;
    part->text = NULL;
    return !(problem && shared);
}
