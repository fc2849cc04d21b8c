/* One frame's file: see picture.h. */
#include "cli/picture.h"

#include <string.h>
#include <unistd.h>

#include "base/save.h"
#include "base/writer.h"
#include "cli/origin.h"
#include "image/note.h"
#include "render/overlay.h"

bool picture_can_be(const char *name, struct diag *diag)
{
    char why[256];
    if (!name || save_possible(name, why, sizeof why))
        return true;
    diag_print(diag, DIAG_ERROR, span_none(), NULL, "can't write '%s': %s",
               name, why);
    return false;
}

struct output_space picture_space(const struct options *options,
                                  const struct settings *settings)
{
    bool linear = options->file_type == 'E' || options->file_type == 'H';
    bool keeps_alpha = strchr("NETCB", options->file_type) != NULL;
    return (struct output_space){
        .working_gamma =
            settings->gamma_kind == GAMMA_POWER ? settings->assumed_gamma : 0,
        .keep_numbers = settings->gamma_kind == GAMMA_NONE,
        .linear_file = linear,
        .no_negative = options->file_type == 'H',
        .half = options->file_type == 'E' && options->bits <= 16,
        .file_gamma = options->file_gamma,
        .alpha = options->alpha && keeps_alpha,
        .grey = options->grey,
    };
}

bool picture_show(struct image *image, const struct options *options,
                  const struct tracer *tracer, const atomic_int *stop,
                  struct picture_shown *shown, struct diag *diag)
{
    if (shown)
        *shown = (struct picture_shown){ .show = { .arena = NULL } };
    if (!options->show)
        return true;
    if (camera_is_bent(&tracer->scene->camera)) {
        diag_print(diag, DIAG_WARNING, span_none(), NULL,
                   "--show draws nothing: this kind of camera bends lines");
        return true;
    }
    struct show show = show_new();
    struct ramp_range range;
    struct render_options render = options->render;
    struct output_space space =
        picture_space(options, &tracer->scene->settings);
    render.stop = stop;
    const struct lighting_view *view =
        lighting_view(tracer->lighting, options->show);
    view->give(tracer->lighting_state, &show);
    bool done = overlay_draw(tracer, &render, &show, space.working_gamma, image,
                             &range);
    if (done && !range.known)
        diag_print(diag, DIAG_MESSAGE, span_none(), NULL,
                   "%s: there is nothing to show%s%s\n", options->show,
                   view->needs ? ": add " : "", view->needs ? view->needs : "");
    else if (done)
        diag_print(diag, DIAG_MESSAGE, span_none(), NULL,
                   "%s: %s from %.3g (blue) to %.3g (red)\n", options->show,
                   show.what, range.low, range.high);
    if (done && shown)
        *shown = (struct picture_shown){ show, range };
    else
        show_free(&show);
    return done;
}

void picture_describe(const struct options *options,
                      const struct settings *settings,
                      struct image_format *format, struct output_space *space)
{
    *space = picture_space(options, settings);
    *format = options_format(options);
    if (space->keep_numbers) /* POV-Ray then heeds no File_Gamma (measured) */
        format->gamma = 0;
    if (options->file_type == 'N')
        space->bits = format->bits;
}

bool picture_write(struct image *image, const struct picture_file *file,
                   struct diag *diag)
{
    const char *name = file->name;
    if (!name)
        return true;
    struct output_space space;
    struct image_format format;
    picture_describe(file->options, file->settings, &format, &space);
    format.note = file->origin;
    output_convert(image, &space, file->options->render.threads);
    char why[256];
    if (image_write(image, name, &format, why, sizeof why))
        return true;
    diag_print(diag, DIAG_ERROR, span_none(), NULL, "can't write %s%s%s: %s",
               strcmp(name, "-") ? "'" : "standard output",
               strcmp(name, "-") ? name : "", strcmp(name, "-") ? "'" : "",
               why);
    return false;
}

/* "dir/a.png" to "dir/a-unfinished.png" */
static void unfinished_name(const char *name, char *out, size_t size)
{
    const char *slash = strrchr(name, '/');
    const char *dot = strrchr(slash ? slash : name, '.');
    int length = dot ? (int)(dot - name) : (int)strlen(name);
    snprintf(out, size, "%.*s-unfinished%s", length, name, dot ? dot : "");
}

void picture_rescue(struct image *image, const struct picture_file *file,
                    const struct render_stats *drawn,
                    struct unfinished *unfinished, struct diag *diag)
{
    if (!file->name || strcmp(file->name, "-") == 0 || !(drawn->share > 0))
        return;
    struct writer origin = writer_new();
    writer_print(&origin, ORIGIN_UNFINISHED " yes\n%s", file->origin);
    const struct picture_file beside = { file->options, file->settings,
                                         unfinished->name, origin.items };
    unfinished_name(file->name, unfinished->name, sizeof unfinished->name);
    unfinished->share = drawn->share;
    if (!picture_write(image, &beside, diag))
        unfinished->name[0] = '\0';
    writer_free(&origin);
}

void picture_forget_unfinished(const char *name)
{
    char beside[FILENAME_MAX], is[8];
    if (!name || strcmp(name, "-") == 0)
        return;
    unfinished_name(name, beside, sizeof beside);
    struct arena *arena = arena_new(0);
    const char *origin = image_note_read(arena, beside);
    if (origin && origin_value(origin, ORIGIN_UNFINISHED, is, sizeof is))
        unlink(beside);
    arena_free(arena);
}
