/* Setters of what scripts and farms ask for: see option.h. */
#include "cli/option.h"

#include <stdio.h>

#include "cli/array.h"
#include "cli/part.h"

bool set_check_picture(struct option_reader *reader,
                       const struct option *option,
                       const struct setting *setting)
{
    reader->options->action = ACTION_CHECK_PICTURE;
    return set_text(reader, option, setting);
}

bool set_join(struct option_reader *reader, const struct option *option,
              const struct setting *setting)
{
    if (!setting->value) {
        reader->options->join = true;
        return true;
    }
    reader->options->action = ACTION_JOIN;
    return set_text(reader, option, setting);
}

/* "json", "text", or nothing. */
static bool form_read(struct option_reader *reader, const struct option *option,
                      const struct setting *setting)
{
    const char *value = setting->value ? setting->value : "text";
    *(const char **)((char *)reader->options + option->offset) = value;
    return strcmp(value, "json") == 0 || strcmp(value, "text") == 0 ||
           option_fail(reader, setting, "--%s is text or json, not '%s'",
                       option->word, value);
}

bool set_progress(struct option_reader *reader, const struct option *option,
                  const struct setting *setting)
{
    reader->options->progress = PROGRESS_ALWAYS;
    return form_read(reader, option, setting);
}

bool set_stats(struct option_reader *reader, const struct option *option,
               const struct setting *setting)
{
    reader->options->stats = true;
    return form_read(reader, option, setting);
}

static bool part_fail(struct option_reader *reader, const char *text)
{
    diag_print(reader->diag, DIAG_ERROR, span_none(), NULL, "%s", text);
    return false;
}

/* Whether +SR, +ER, +SC or +EC leave something out. */
static bool part_is_region(const struct render_options *render)
{
    return render->column_start > 0 || render->row_start > 0 ||
           render->column_end < render->width ||
           render->row_end < render->height;
}

/* "3/16", "array" or "array/16". */
static bool share_read(struct option_reader *reader, const char *word,
                       const char *said, struct share *share)
{
    int read = 0, count = 0;
    char problem[200];
    bool array = strncmp(said, "array", 5) == 0;
    if (array && said[5] == '/' &&
        (sscanf(said + 6, "%d%n", &count, &read) != 1 || said[6 + read]))
        count = -1;
    if (array && (!said[5] || said[5] == '/') && count >= 0 &&
        count <= SHARE_LIMIT) {
        if (array_task(count, share, problem, sizeof problem))
            return true;
        return part_fail(reader, arena_printf(reader->arena, "--%s %s: %s",
                                              word, said, problem));
    }
    if (sscanf(said, "%d/%d%n", &share->number, &share->count, &read) == 2 &&
        !said[read] && share->count >= 1 && share->count <= SHARE_LIMIT &&
        share->number >= 1 && share->number <= share->count)
        return true;
    return part_fail(
        reader, arena_printf(reader->arena,
                             "--%s wants a number and of how many, up to %d, "
                             "or array, not '%s': type --%s 1/16",
                             word, SHARE_LIMIT, said, word));
}

bool frames_said_resolve(struct option_reader *reader)
{
    struct options *options = reader->options;
    struct share share;
    if (!options->frames_said)
        return true;
    if (!share_read(reader, "frames", options->frames_said, &share))
        return false;
    if (!options->frames.animated)
        return part_fail(reader, "--frames wants an animation: type +KFF24");
    frames_deal(&options->frames, share.number, share.count);
    return true;
}

static bool part_read(struct option_reader *reader, struct share *share)
{
    const char *said = reader->options->part;
    if (strcmp(said, "strip") != 0)
        return share_read(reader, "part", said, share);
    *share = (struct share){ 1, 1 };
    return true;
}

bool part_resolve(struct option_reader *reader)
{
    struct options *options = reader->options;
    struct render_options *render = &options->render;
    struct share share;
    if (!options->part)
        return true;
    if (!part_read(reader, &share))
        return false;
    bool strip = strcmp(options->part, "strip") == 0;
    bool region = part_is_region(render);
    const char *problem = NULL;
    if (strip && !region)
        problem = "--part strip is what +SR +ER +SC +EC choose: type +SR1 "
                  "+ER100 --part strip";
    else if (!strip && region)
        problem = "--part I/N is of whole pictures: leave out +SR +ER +SC +EC, "
                  "or type --part strip";
    else if (options->probe || options->show || options->debug_pixel ||
             !options->output || strcmp(options->output, "-") == 0)
        problem = "--part wants a picture with a name, without --probe, --show "
                  "and --debug-pixel";
    else if (render->target_error > 0 || render->target_time > 0)
        problem = "a part can't tell when the whole picture is good enough: "
                  "say --samples, not --target-error or --target-time";
    if (problem)
        return part_fail(reader, problem);
    render->share = share;
    if (!strip)
        render->tile = 32; /* blocks are made of these */
    return true;
}

bool large_resolve(struct option_reader *reader)
{
    const struct options *options = reader->options;
    const struct render_options *render = &options->render;
    if ((long long)render->width * render->height <= IMAGE_PIXEL_LIMIT ||
        (options->output && part_has_bands(options, options->output)))
        return true;
    diag_print(
        reader->diag, DIAG_ERROR, span_none(), NULL,
        "%d x %d pixels are too many: glim's limit is %d in all, 16384 x "
        "16384, but for PNG, PPM and OpenEXR files, which it draws in bands",
        render->width, render->height, IMAGE_PIXEL_LIMIT);
    return false;
}
