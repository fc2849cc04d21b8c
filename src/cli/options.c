/* Arguments to options: see options.h. The token level is here, the meaning
 * of each option in option_set.c. */
#include "cli/option.h"

#include <stdarg.h>
#include <sys/stat.h>

#include "base/jobserver.h"
#include "base/parallel.h"
#include "base/text.h"
#include "cli/output_name.h"
#include "lighting/lighting.h"
#include "skeleton/export.h"

static void option_report(struct option_reader *reader,
                          const struct setting *setting, enum diag_level level,
                          const char *hint, const char *format,
                          va_list arguments)
{
    char message[512];
    vsnprintf(message, sizeof message, format, arguments);
    struct span span =
        setting->value_span.source ? setting->value_span : setting->span;
    if (span.source || !setting->shown)
        diag_print(reader->diag, level, span, hint, "%s", message);
    else
        diag_print(reader->diag, level, span, hint, "'%s': %s", setting->shown,
                   message);
}

bool option_fail(struct option_reader *reader, const struct setting *setting,
                 const char *format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    option_report(reader, setting, DIAG_ERROR, NULL, format, arguments);
    va_end(arguments);
    return false;
}

void option_warn(struct option_reader *reader, const struct setting *setting,
                 const char *format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    option_report(reader, setting, DIAG_WARNING, NULL, format, arguments);
    va_end(arguments);
}

/* Applies a setting by its key or word. */
static bool option_apply(struct option_reader *reader,
                         const struct option *option,
                         const struct setting *setting)
{
    if (option->of && !setting->span.source)
        *ARRAY_PUSH(reader->arena, &reader->typed) =
            (struct option_typed){ option, setting->shown };
    return option->set(reader, option, setting);
}

static bool option_read_word(struct option_reader *reader,
                             struct setting setting)
{
    const char *word = setting.shown + 2;
    size_t length = strcspn(word, "=");
    const struct option *option =
        option_find_word(arena_copy_text(reader->arena, word, length));
    if (!option)
        return option_unknown(reader, &setting, setting.shown);
    if (word[length] == '=')
        setting.value = word + length + 1;
    if (!option->argument && setting.value)
        return option_fail(reader, &setting, "--%s takes no value",
                           option->word);
    setting.by_key = true;
    return option_apply(reader, option, &setting);
}

/* Without quotes around all of it, as POV-Ray reads what a script or a shell
 * other than sh has left: +O"my pic.png". */
static const char *option_unquoted(struct arena *arena, const char *text)
{
    size_t length = strlen(text);
    bool quoted =
        length > 1 && strchr("\"'", text[0]) && text[length - 1] == text[0];
    return quoted ? arena_copy_text(arena, text + 1, length - 2) : text;
}

static bool option_read_letters(struct option_reader *reader,
                                struct setting setting)
{
    static const char *const help[] = { "h", "?", "help" };
    const char *letters = setting.shown + 1;
    for (size_t i = 0; i < sizeof help / sizeof *help; i++)
        if (text_equal_nocase(letters, help[i]))
            return set_action(reader, option_find_word("help"), &setting);
    const struct option *option = option_find_letters(letters);
    if (!option)
        return option_unknown(reader, &setting, setting.shown);
    setting.value =
        option_unquoted(reader->arena, letters + strlen(option->letters));
    setting.on = setting.shown[0] == '+';
    if (option_is_word(reader->arena, letters))
        return option_unknown(reader, &setting, setting.shown);
    if (setting.value[0] == '=')
        return option_fail(reader, &setting, "no '=' stands here: type %c%s%s",
                           setting.shown[0], option->letters,
                           setting.value + 1);
    return option->set(reader, option, &setting);
}

static bool option_read_key(struct option_reader *reader,
                            struct setting setting, size_t equals)
{
    size_t length = equals;
    while (length && strchr(" \t", setting.shown[length - 1]))
        length--;
    const char *key = arena_copy_text(reader->arena, setting.shown, length);
    const struct option *option = option_find_key(key);
    if (!option)
        return option_unknown(reader, &setting,
                              setting.span.source ? key : setting.shown);
    setting.by_key = true;
    return option_apply(reader, option, &setting);
}

static bool option_is_scene(const char *name)
{
    size_t length = strlen(name);
    if (strcmp(name, "-") == 0)
        return true;
    return length > 4 && !strchr("+-", name[0]) && !strchr(name, '=') &&
           text_equal_nocase(name + length - 4, ".pov");
}

bool option_read(struct option_reader *reader, const struct setting *token)
{
    const char *text = option_unquoted(reader->arena, token->shown);
    if (option_is_scene(text)) {
        if (reader->scene && strcmp(reader->scene, text) != 0)
            diag_print(reader->diag, DIAG_WARNING, token->span, NULL,
                       "'%s' is not rendered: of several scenes the last "
                       "counts",
                       reader->scene);
        if (!token->span.source)
            reader->scene = text;
        reader->options->input = text;
        return true;
    }
    if (strncmp(text, "--", 2) == 0)
        return option_read_word(reader, *token);
    if (text[0] == '+' || text[0] == '-')
        return option_read_letters(reader, *token);
    size_t equals = strcspn(text, "=");
    if (text[equals] == '=') {
        struct setting setting = *token;
        if (!setting.value)
            setting.value = option_unquoted(reader->arena, text + equals + 1);
        return option_read_key(reader, setting, equals);
    }
    return ini_read(reader, text, token);
}

static bool option_is_file(const char *path)
{
    struct stat status;
    return stat(path, &status) == 0 && !S_ISDIR(status.st_mode);
}

const char *option_search(const struct option_reader *reader, const char *name,
                          const char *const *extensions)
{
    for (size_t i = 0; i <= reader->library.count; i++) {
        const char *directory = i ? reader->library.items[i - 1] : NULL;
        if (directory && name[0] == '/')
            break;
        for (const char *const *e = extensions; *e; e++) {
            const char *path = arena_printf(reader->arena, "%s%s%s%s",
                                            directory ? directory : "",
                                            directory ? "/" : "", name, *e);
            if (option_is_file(path))
                return path;
        }
    }
    return NULL;
}

static bool options_find_input(struct option_reader *reader)
{
    static const char *const extensions[] = { "", ".pov", ".POV", NULL };
    struct options *options = reader->options;
    if (!options->input) {
        diag_print(reader->diag, DIAG_ERROR, span_none(), NULL,
                   "no scene given: type glim scene.pov, or glim --help");
        return false;
    }
    options->path = options->input;
    if (strcmp(options->input, "-") == 0 && options->watch) {
        diag_print(reader->diag, DIAG_ERROR, span_none(), NULL,
                   "--watch needs a file: standard input can't be read again");
        return false;
    }
    if (strcmp(options->input, "-") == 0)
        return true;
    options->path = option_search(reader, options->input, extensions);
    if (options->path)
        return true;
    /* --watch waits for it: an editor may have put it away for a moment. */
    for (size_t i = 0; extensions[i]; i++)
        file_list_add(
            options->parse.asked,
            arena_printf(reader->arena, "%s%s", options->input, extensions[i]));
    return option_scene_missing(reader, options->input);
}

/* A table of light goes to standard output, or where +O says. */
static bool options_name_table(struct option_reader *reader)
{
    static const struct output_type text = { .extension = ".txt" };
    struct options *options = reader->options;
    const char *said = reader->output ? reader->output : "-";
    options->continue_trace = false;
    options->output = said;
    if (strcmp(options->input, "-") == 0 && strcmp(options->probe, "-") == 0) {
        diag_print(reader->diag, DIAG_ERROR, span_none(), NULL,
                   "the scene and the points can't both come from standard "
                   "input");
        return false;
    }
    if (output_is_folder(said))
        options->output =
            output_name(said, options->input, &text, reader->arena);
    options->named = options->output;
    return true;
}

static bool options_name_output(struct option_reader *reader)
{
    struct options *options = reader->options;
    const struct output_type *type = output_type_find(options->file_type);
    if (options->probe)
        return options_name_table(reader);
    bool writes = options->to_file && options->action == ACTION_RENDER;
    if (!writes && !options->depend.file && !options->depend.on)
        return true;
    /* <(...) of a shell is /dev/fd/63. */
    bool nameless = strcmp(options->input, "-") == 0 ||
                    strcmp(options->input, "/dev/stdin") == 0 ||
                    strncmp(options->input, "/dev/fd/", 8) == 0;
    const char *said = reader->output;
    if (nameless && (!said || output_is_folder(said))) {
        diag_print(reader->diag, DIAG_ERROR, span_none(), NULL,
                   "a scene from standard input or a pipe has no name: type "
                   "+Oname for "
                   "the picture, or +O- for standard output");
        return false;
    }
    options->named = output_name(said, options->input, type, reader->arena);
    if (!writes)
        return true;
    options->output = options->named;
    const struct output_type *meant =
        said ? output_type_meant(said, type) : NULL;
    if (meant)
        diag_print(reader->diag, DIAG_WARNING, span_none(), NULL,
                   "the picture is called '%s', as POV-Ray would; for "
                   "'%.*s%s' add +F%c",
                   options->output, (int)output_stem(said), said,
                   meant->extension, meant->letter);
    else if (said && output_type_lacking(said))
        diag_print(reader->diag, DIAG_WARNING, span_none(), NULL,
                   "the picture is called '%s': glim does not write %s, but "
                   "what --list formats shows",
                   options->output, output_type_lacking(said));
    return true;
}

/* `said` counted from 1, below 1 a share; see section 2.2 of
 * tests/povray.md. Returns the 0-based, end exclusive bounds. */
static bool options_range(struct option_reader *reader, const char *what,
                          const double said[2], int size, int *start, int *end)
{
    *start = 0;
    *end = size;
    if (said[0] > 0)
        *start = said[0] < 1 ? (int)(said[0] * size) : (int)said[0] - 1;
    if (!isnan(said[1]))
        *end = said[1] <= 1 ? (int)(said[1] * size) : (int)said[1];
    if (*start < *end && *end <= size)
        return true;
    if (*end > size || *start >= size)
        diag_print(reader->diag, DIAG_ERROR, span_none(), NULL,
                   "%s_%s must not be beyond %d, the picture's last",
                   *end > size ? "End" : "Start", what, size);
    else
        diag_print(reader->diag, DIAG_ERROR, span_none(), NULL,
                   "End_%s %d is before Start_%s %d", what, *end, what,
                   *start + 1);
    return false;
}

/* One pixel, straight through its middle, by one thread. */
static bool options_resolve_pixel(struct option_reader *reader)
{
    struct options *options = reader->options;
    struct render_options *render = &options->render;
    int column, row, read = 0;
    const char *said = options->debug_pixel;
    if (!said)
        return true;
    if (sscanf(said, "%d,%d%n", &column, &row, &read) != 2 || said[read] ||
        column < 1 || row < 1 || column > render->width ||
        row > render->height || options->probe) {
        diag_print(reader->diag, DIAG_ERROR, span_none(), NULL,
                   "--debug-pixel wants a pixel of the picture and no --probe, "
                   "not '%s': type --debug-pixel %d,%d",
                   said, (render->width + 1) / 2, (render->height + 1) / 2);
        return false;
    }
    render->column_start = column - 1;
    render->column_end = column;
    render->row_start = row - 1;
    render->row_end = row;
    render->antialias = false;
    options->to_file = false;
    options->threads = 1;
    return true;
}

/* Whether there are such files, and glim's half that writes them. */
static bool options_check_file_type(struct option_reader *reader)
{
    const struct options *options = reader->options;
    struct image_format format = options_format(options);
    bool exr = options->file_type == 'E';
    char why[512];
    if (options->bits <= 16 || (exr && options->bits == 32)) {
        if (!options->to_file || image_can_write(&format, why, sizeof why))
            return true;
        diag_print(reader->diag, DIAG_ERROR, span_none(), NULL,
                   "can't write %s files: %s",
                   output_type_find(options->file_type)->format, why);
        return false;
    }
    diag_print(reader->diag, DIAG_ERROR, span_none(), NULL,
               exr ? "OpenEXR files have 16 or 32 bits, not %d: type +FE32"
                   : "%d bits are too many: PNG and PPM files have 1 to 16; "
                     "floats are written by +FE32",
               options->bits);
    return false;
}

static bool options_resolve_picture(struct option_reader *reader)
{
    struct options *options = reader->options;
    struct render_options *render = &options->render;
    if (!options_range(reader, "Column", options->columns, render->width,
                       &render->column_start, &render->column_end) ||
        !options_range(reader, "Row", options->rows, render->height,
                       &render->row_start, &render->row_end) ||
        !options_resolve_pixel(reader))
        return false;
    if (!options_check_file_type(reader))
        return false;
    bool target = render->target_error > 0 || render->target_time > 0;
    render->samples = options->samples ? options->samples : target ? 65536 : 64;
    if (!options->jitter)
        render->jitter = 0;
    render->threads = (unsigned)options->threads;
    return true;
}

/* What is always searched last: Debian's include files. */
static void options_add_standard_library(struct option_reader *reader)
{
    static const char *const standard[] = {
        OPTION_POVRAY_FOLDER "/include",
        OPTION_POVRAY_FOLDER,
        OPTION_POVRAY_FOLDER "/ini",
        NULL,
    };
    for (const char *const *path = standard; *path; path++)
        option_add_library(reader, *path);
    reader->options->parse.standard_paths = standard;
}

static void options_resolve_scene(struct option_reader *reader)
{
    struct options *options = reader->options;
    struct parse_options *parse = &options->parse;
    parse->include_paths = reader->library.items;
    parse->include_path_count = reader->library.count;
    parse->include_headers = reader->headers.items;
    parse->include_header_count = reader->headers.count;
    parse->declares = reader->declares.items;
    parse->declare_count = reader->declares.count;
    parse->image_width = options->render.width;
    parse->image_height = options->render.height;
    parse->clock_on = !isnan(options->clock);
    parse->clock = parse->clock_on ? options->clock : 0;
}

/* Warns of what was typed for another lighting than the one that is used. */
static void options_tell_unused(struct option_reader *reader)
{
    const char *used = reader->options->lighting->name;
    for (size_t i = 0; i < reader->typed.count; i++) {
        const char *of = reader->typed.items[i].option->of;
        const char *found = strstr(of, used);
        size_t length = found ? strlen(used) : strcspn(of, " ");
        if (found && (found[length] == '\0' || found[length] == ' '))
            continue;
        diag_print(reader->diag, DIAG_WARNING, span_none(), NULL,
                   "--lighting %s does not use '%s': type --lighting %.*s",
                   used, reader->typed.items[i].shown, (int)length, of);
    }
}

static bool options_resolve_mesh(struct option_reader *reader)
{
    const struct options *options = reader->options;
    const struct light_mesh_settings *mesh = &options->light.light_mesh;
    if (mesh->only)
        reader->options->to_file = false;
    if (mesh->only && !mesh->save_file)
        diag_print(reader->diag, DIAG_ERROR, span_none(), NULL,
                   "--mesh-only would keep nothing: add --mesh-save FILE");
    else if (mesh->save_file && !options->lighting->keep)
        diag_print(reader->diag, DIAG_ERROR, span_none(), NULL,
                   "--lighting %s makes no light mesh for --mesh-save: add "
                   "--lighting mesh",
                   options->lighting->name);
    else
        return true;
    return false;
}

/* `found` is a lighting that has the view. */
static bool options_resolve_show(struct option_reader *reader,
                                 const struct lighting *found)
{
    const struct options *options = reader->options;
    struct text_nearest nearest = text_nearest_start(options->show);
    for (size_t i = 0; lighting_at(i); i++)
        for (const struct lighting_view *view = lighting_at(i)->views;
             view && view->name; view++)
            text_nearest_try(&nearest, view->name);
    if (!found)
        diag_print(reader->diag, DIAG_ERROR, span_none(), NULL,
                   "there is no '%s' to show: type %s", options->show,
                   nearest.best ? nearest.best : "skeleton");
    else if (options->probe || options->light.light_mesh.only)
        diag_print(reader->diag, DIAG_ERROR, span_none(), NULL,
                   "--show draws over a picture, and %s makes none",
                   options->probe ? "--probe" : "--mesh-only");
    else if (!lighting_view(options->lighting, options->show))
        diag_print(reader->diag, DIAG_ERROR, span_none(), NULL,
                   "--lighting %s has no '%s' to show: type --lighting %s",
                   options->lighting->name, options->show, found->name);
    else
        return true;
    return false;
}

/* What is asked of the lighting names one, unless one was named. */
static bool options_resolve_lighting(struct option_reader *reader)
{
    struct options *options = reader->options;
    const char *save = options->light.skeleton.save_file;
    const char *wanted = options->show ? options->show : "skeleton";
    const struct lighting *found = NULL;
    bool keeps = options->light.light_mesh.save_file ||
                 options->light.light_mesh.load_file;
    for (size_t i = 0; (options->show || save) && lighting_at(i); i++)
        if (!found && lighting_view(lighting_at(i), wanted))
            found = lighting_at(i);
    for (size_t i = 0; keeps && lighting_at(i); i++)
        if (!found && lighting_at(i)->keep)
            found = lighting_at(i);
    if (!options->lighting)
        options->lighting = found ? found : lighting_at(0);
    if (save && !skeleton_can_save(save))
        diag_print(reader->diag, DIAG_ERROR, span_none(), NULL,
                   "can't write the skeleton '%s': its name must end in .ply, "
                   ".obj or .csv",
                   save);
    else if (save && !lighting_view(options->lighting, "skeleton"))
        diag_print(reader->diag, DIAG_ERROR, span_none(), NULL,
                   "--lighting %s has no skeleton to save: type --lighting "
                   "skeleton",
                   options->lighting->name);
    else
        return !options->show || options_resolve_show(reader, found);
    return false;
}

/* POV-Ray draws them too; more often it is Final_Frame that was forgotten. */
static void options_tell_subset(struct option_reader *reader,
                                const struct frames *frames)
{
    int end = frames->begin > frames->end ? frames->begin : frames->end;
    if (end > frames->last)
        diag_print(reader->diag, DIAG_WARNING, span_none(),
                   arena_printf(reader->arena, "+KFF%d", end),
                   "Final_Frame is %d, and the subset goes on to frame %d: it "
                   "is drawn, with a clock beyond Final_Clock",
                   frames->last, end);
}

static bool options_resolve(struct option_reader *reader)
{
    struct options *options = reader->options;
    options_add_standard_library(reader);
    reader->diag->quiet_messages = !options->messages;
    reader->diag->quiet_warnings =
        !options->warnings || options->warning_level == 0;
    if (options->action == ACTION_LANGUAGE_SERVER)
        return permits_resolve(reader);
    if (options_answers(options))
        return true;
    if (!options_find_input(reader) || !options_resolve_picture(reader) ||
        !options_resolve_lighting(reader) || !options_resolve_mesh(reader) ||
        !options_name_output(reader))
        return false;
    if (options->action == ACTION_RENDER)
        options_tell_unused(reader);
    options_resolve_scene(reader);
    if (!permits_resolve(reader) || !part_resolve(reader) ||
        !large_resolve(reader))
        return false;
    const char *problem = frames_resolve(&options->frames, reader->arena);
    if (problem)
        diag_print(reader->diag, DIAG_ERROR, span_none(), NULL, "%s", problem);
    if (!problem && options->frames.animated)
        options_tell_subset(reader, &options->frames);
    return !problem && frames_said_resolve(reader);
}

static struct options options_default(void)
{
    unsigned cores = parallel_cores();
    if (cores > OPTIONS_THREAD_LIMIT)
        cores = OPTIONS_THREAD_LIMIT;
    if (jobserver_state() == JOBSERVER_CLOSED)
        cores = 1;
    return (struct options){
        .file_type = 'N',
        .compression = 85,
        .to_file = true,
        .messages = true,
        .warnings = true,
        .warning_level = 10,
        .quality = 9,
        .threads = (int)cores,
        .clock = FRAMES_UNSAID,
        .frames = frames_new(),
        .jitter = true,
        .columns = { FRAMES_UNSAID, FRAMES_UNSAID },
        .rows = { FRAMES_UNSAID, FRAMES_UNSAID },
        .render = { .width = 800,
                    .height = 600,
                    .method = 1,
                    .threshold = 0.3,
                    .depth = 3,
                    .jitter = 1,
                    .antialias_gamma = 2.5,
                    .tile = 32 },
    };
}

bool options_parse(struct options *options, int argc, char **argv,
                   struct arena *arena, struct diag *diag)
{
    struct file_list *asked = options->parse.asked;
    *options = options_default();
    options->parse.asked = asked;
    struct option_reader reader = { .options = options,
                                    .arena = arena,
                                    .diag = diag };
    bool started = ini_startup(&reader);
    bool read = arguments_read(&reader, argc, argv);
    return started && read && options_resolve(&reader);
}

struct image_format options_format(const struct options *options)
{
    const struct output_type *type = output_type_find(options->file_type);
    bool grey_png = options->grey && options->file_type == 'N';
    return (struct image_format){
        .type = type->format,
        .bits = options->bits ? options->bits
                : grey_png    ? 16
                              : 8,
        .grey = options->grey,
        .alpha = options->alpha,
        .packed = options->file_type == 'C',
        .quality = options->compression > 1 ? options->compression : 85,
        .gamma = options->file_gamma,
    };
}
