/* Origins as text: see origin.h. */
#include "cli/origin.h"

#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/hash.h"
#include "base/text.h"
#include "cli/build.h"
#include "tracer/integrator.h"

enum { VALUE_SIZE = 1024 };

/* A line; what would end it or begin another is escaped as in a C string. */
static void line_text(struct writer *text, const char *name, const char *value)
{
    writer_add(text, name, strlen(name));
    writer_add(text, " ", 1);
    for (; *value; value++)
        if (*value == '\n' || *value == '\r' || *value == '\\')
            writer_print(text, "\\%c",
                         *value == '\n'   ? 'n'
                         : *value == '\r' ? 'r'
                                          : '\\');
        else
            writer_add(text, value, 1);
    writer_add(text, "\n", 1);
}

static void line_number(struct writer *text, const char *name, double value)
{
    char digits[40];
    snprintf(digits, sizeof digits, "%.17g", value);
    line_text(text, name, digits);
}

static void line_hash(struct writer *text, const char *name, uint64_t hash)
{
    writer_print(text, "%s %016" PRIx64 "\n", name, hash);
}

static void origin_picture(struct writer *text, const struct options *options)
{
    const struct render_options *render = &options->render;
    const struct image_format format = options_format(options);
    line_number(text, "width", render->width);
    line_number(text, "height", render->height);
    bool part = render->share.count > 0; /* of the whole picture */
    if (!part && (render->column_end - render->column_start < render->width ||
                  render->row_end - render->row_start < render->height)) {
        line_number(text, "start-column", render->column_start + 1);
        line_number(text, "end-column", render->column_end);
        line_number(text, "start-row", render->row_start + 1);
        line_number(text, "end-row", render->row_end);
    }
    line_text(text, "type", format.type);
    line_number(text, "bits", format.bits);
    line_number(text, "grey", format.grey);
    line_number(text, "alpha", format.alpha);
    line_number(text, "gamma", format.gamma);
    if (strcmp(format.type, "jpeg") == 0)
        line_number(text, "compression", format.quality);
    if (strcmp(format.type, "targa") == 0)
        line_number(text, "packed", format.packed);
}

static void origin_sampling(struct writer *text, const struct options *options)
{
    const struct render_options *render = &options->render;
    line_number(text, "quality", options->quality);
    line_text(text, "lighting", options->lighting->name);
    if (options->show)
        line_text(text, "show", options->show);
    if (integrator_for(options->lighting)->sample) {
        line_number(text, "jitter", render->jitter);
        line_number(text, "samples", render->samples);
        line_number(text, "seed", render->seed);
        line_number(text, "target-error", render->target_error);
        line_number(text, "target-time", render->target_time);
        return;
    }
    line_number(text, "antialias", render->antialias ? render->method : 0);
    if (!render->antialias)
        return;
    line_number(text, "threshold", render->threshold);
    line_number(text, "depth", render->depth);
    line_number(text, "jitter", render->jitter);
    line_number(text, "antialias-gamma", render->antialias_gamma);
}

/* Not where results go: the files' names don't count. */
static bool field_is_output(const struct field *field)
{
    return strcmp(field->name, "save") == 0 ||
           strcmp(field->name, "skeleton_save") == 0 ||
           strcmp(field->name, "only") == 0;
}

static void origin_light(struct writer *text, const struct options *options)
{
    const struct light_said *said = &options->light_said;
    for (size_t i = 0; i < said->count; i++) {
        const struct field *field = said->fields[i];
        const void *at = (const char *)&options->light + field->offset;
        const char *word = NULL;
        if (field_is_output(field))
            continue;
        if (field->kind == FIELD_NAME)
            word = *(const char *const *)at;
        else if (field->kind == FIELD_CHOICE)
            word = field->choices[*(const int *)at];
        if (word)
            line_text(text, field->name, word);
        else if (field->kind == FIELD_FLOAT)
            line_number(text, field->name, *(const double *)at);
        else if (field->kind == FIELD_INTEGER)
            line_number(text, field->name, *(const int *)at);
        else
            line_number(text, field->name, *(const bool *)at);
    }
}

static void origin_scene(struct writer *text, const struct options *options,
                         int number)
{
    struct parse_options parse = options->parse;
    frames_tell(&options->frames, number, &parse);
    for (size_t i = 0; i < parse.declare_count; i++) {
        line_text(text, "declare", parse.declares[i].name);
        line_text(text, "value", parse.declares[i].value);
    }
    for (size_t i = 0; i < parse.include_header_count; i++)
        line_text(text, "header", parse.include_headers[i]);
    if (parse.version > 0)
        line_number(text, "version", parse.version);
    if (!parse.clock_on)
        return;
    line_number(text, "clock", parse.clock);
    if (!options->frames.animated)
        return;
    line_number(text, "frame", parse.frame_number);
    line_number(text, "initial-frame", parse.initial_frame);
    line_number(text, "final-frame", parse.final_frame);
    line_number(text, "initial-clock", parse.initial_clock);
    line_number(text, "final-clock", parse.final_clock);
    line_number(text, "clock-delta", parse.clock_delta);
}

void origin_settings(struct writer *text, const struct options *options,
                     int number, const struct source *scene)
{
    line_text(text, "glim", GLIM_VERSION);
    line_text(text, "build", build_id);
    line_text(text, "scene", options->path);
    if (strcmp(options->path, "-") == 0)
        line_hash(text, "text", hash_bytes(0, scene->text, scene->length));
    origin_picture(text, options);
    origin_sampling(text, options);
    origin_light(text, options);
    origin_scene(text, options, number);
}

static int path_order(const void *a, const void *b)
{
    return strcmp(*(const char *const *)a, *(const char *const *)b);
}

/* The paths that count, in an order that depends on them alone. */
static size_t origin_paths(struct arena *arena, const struct file_list *files,
                           size_t first, const char ***paths)
{
    size_t count = 0;
    *paths = ARENA_ARRAY(arena, const char *, files->count + 1);
    for (size_t i = first; i < files->count; i++)
        if (file_list_asked(files, i) &&
            strcmp(file_list_path(files, i), "-") != 0)
            (*paths)[count++] = file_list_path(files, i);
    qsort(*paths, count, sizeof **paths, path_order);
    return count;
}

/* One that changed while it was read has a hash that no file has. */
void origin_files(struct writer *text, const struct file_list *files,
                  size_t first)
{
    uint64_t hash;
    char name[32];
    const char **paths;
    size_t count = origin_paths(text->arena, files, first, &paths);
    for (size_t k = 0; k < count; k++) {
        size_t i = file_list_find(files, paths[k]);
        bool known = file_list_hash(files, i, &hash);
        snprintf(name, sizeof name, "file %016" PRIx64, known ? hash : 0);
        line_text(text, file_list_there(files, i) ? name : "none", paths[k]);
    }
}

/* ---- reading them ---- */

/* One line, cut in two. */
struct line {
    char name[VALUE_SIZE], value[VALUE_SIZE];
};

static void line_unescape(char *text)
{
    char *to = text;
    for (; *text; text++) {
        if (*text == '\\' && text[1]) {
            text++;
            *to++ = *text == 'n' ? '\n' : *text == 'r' ? '\r' : *text;
        } else {
            *to++ = *text;
        }
    }
    *to = '\0';
}

/* The next line of *from; false after the last. What is longer than any that
 * glim writes is cut. */
static bool line_next(const char **from, struct line *line)
{
    size_t length = strcspn(*from, "\n"), name = strcspn(*from, " \n");
    if (**from == '\0')
        return false;
    int value = name < length ? (int)(length - name - 1) : 0;
    snprintf(line->name, sizeof line->name, "%.*s", (int)name, *from);
    snprintf(line->value, sizeof line->value, "%.*s", value,
             *from + length - value);
    *from += length + ((*from)[length] != '\0');
    return true;
}

static bool line_is_file(const struct line *line)
{
    return strcmp(line->name, "file") == 0 || strcmp(line->name, "none") == 0;
}

static bool line_setting(const char **from, struct line *line)
{
    if (line_next(from, line) && !line_is_file(line))
        return true;
    line->name[0] = line->value[0] = '\0';
    return false;
}

/* A number without the digits that only keep it exact. */
static const char *value_shown(const char *value, char digits[TEXT_NUMBER_SIZE])
{
    char *end;
    double number = strtod(value, &end);
    return *value && !*end ? text_number(digits, number) : value;
}

bool origin_same_settings(const char *made, const char *now, char *why,
                          size_t size)
{
    struct line a, b;
    char digits[2][TEXT_NUMBER_SIZE];
    const char *all = now;
    for (;;) {
        bool more = line_setting(&made, &a), wanted = line_setting(&now, &b);
        if (!more && !wanted)
            return true;
        if (strcmp(a.name, b.name) == 0 && strcmp(a.value, b.value) == 0)
            continue;
        bool lacks = more && wanted && origin_value(all, a.name, NULL, 0);
        if (strcmp(b.name, "build") == 0)
            snprintf(why, size,
                     "another build of glim " GLIM_VERSION " drew it");
        else if (strcmp(a.name, b.name) != 0)
            snprintf(why, size, "it was drawn %s '%.60s'",
                     more && !lacks ? "with" : "without",
                     more && !lacks ? a.name : b.name);
        else if (strcmp(a.name, "glim") == 0)
            snprintf(why, size, "glim %.60s drew it, and this is glim %.60s",
                     a.value, b.value);
        else if (strcmp(a.name, "text") == 0)
            snprintf(why, size, "the scene has changed");
        else
            snprintf(why, size, "it was drawn with %.60s %.60s, not %.60s",
                     a.name, value_shown(a.value, digits[0]),
                     value_shown(b.value, digits[1]));
        return false;
    }
}

/* "HASH PATH" or "PATH" */
static char *line_path(struct line *line, uint64_t *hash)
{
    char *path = line->value;
    *hash = 0;
    if (strcmp(line->name, "file") == 0) {
        *hash = strtoull(path, &path, 16);
        path += *path == ' ';
    }
    line_unescape(path);
    return path;
}

bool origin_same_files(const char *made, struct file_list *seen, char *why,
                       size_t size)
{
    struct line line;
    uint64_t was, is = 0;
    while (line_next(&made, &line)) {
        if (!line_is_file(&line))
            continue;
        bool file = strcmp(line.name, "file") == 0;
        const char *path = line_path(&line, &was);
        file_list_add(seen, path);
        size_t index = file_list_find(seen, path);
        if (index == seen->count) {
            snprintf(why, size, "it was made of too many files");
            return false;
        }
        bool there = file_list_there(seen, index);
        bool known = file_list_hash(seen, index, &is);
        if (there == file && known && (!file || is == was))
            continue;
        snprintf(why, size, "'%s' %s", path,
                 !there ? "is not there any more"
                 : file ? "has changed"
                        : "is there now");
        return false;
    }
    return true;
}

void origin_each_file(const char *made,
                      void (*take)(void *context, const char *path, bool there),
                      void *context)
{
    struct line line;
    uint64_t hash;
    while (line_next(&made, &line))
        if (line_is_file(&line)) {
            bool there = strcmp(line.name, "file") == 0;
            take(context, line_path(&line, &hash), there);
        }
}

bool origin_value(const char *made, const char *name, char *text, size_t size)
{
    struct line line;
    while (line_next(&made, &line))
        if (strcmp(line.name, name) == 0) {
            line_unescape(line.value);
            snprintf(text, size, "%s", line.value);
            return true;
        }
    return false;
}
