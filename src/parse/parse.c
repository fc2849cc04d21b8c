/* The parse as a whole: what is declared before the first line, the files in
 * order, and the verdict. */
#include "parse/parse.h"

#include <stdlib.h>

#include "base/memory.h"
#include "base/text.h"
#include "parse/data_file.h"
#include "parse/rules.h"
#include "parse/stream.h"
#include "parse/symbol.h"

static void parse_predeclare_value(struct parser *p, const char *name,
                                   struct value value)
{
    symbol_set(p, word_intern(p->words, name, strlen(name)), value, false);
}

static void parse_predeclare(struct parser *p, const char *name, double number)
{
    parse_predeclare_value(
        p, name, (struct value){ .kind = VALUE_FLOAT, .number = { number } });
}

/* The name of the scene's file, without where that is. */
static void parse_predeclare_file(struct parser *p, const struct source *main)
{
    parse_predeclare_value(
        p, "input_file_name",
        (struct value){ .kind = VALUE_STRING,
                        .text = text_last_part(main->name) });
}

/* What POV-Ray declares too before the first line: the scene may declare it
 * anew (measured). */
static void parse_predeclare_frame(struct parser *p)
{
    const struct parse_options *o = p->options;
    parse_predeclare(p, "clock_delta", o->clock_delta);
    parse_predeclare(p, "initial_clock", o->initial_clock);
    parse_predeclare(p, "final_clock", o->final_clock);
    parse_predeclare(p, "initial_frame", o->initial_frame);
    parse_predeclare(p, "final_frame", o->final_frame);
    parse_predeclare(p, "frame_number", o->frame_number);
    parse_predeclare(p, "image_width", o->image_width);
    parse_predeclare(p, "image_height", o->image_height);
}

static bool name_is_word(const char *name)
{
    size_t letters = strspn(name, "abcdefghijklmnopqrstuvwxyz"
                                  "ABCDEFGHIJKLMNOPQRSTUVWXYZ_0123456789");
    return *name && !name[letters] && !(*name >= '0' && *name <= '9');
}

/* Declare=NAME=VALUE: the value is read as an expression of the language; of
 * several for one name the first counts, as in POV-Ray. */
static bool parse_declare(struct parser *p, const struct parse_declare *declare)
{
    const struct word *word =
        word_intern(p->words, declare->name, strlen(declare->name));
    if (!name_is_word(declare->name) || word->reserved)
        return error_at(
            p, declare->span, NULL, "'Declare=%s': %s", declare->name,
            word->reserved ? "this is a reserved word" : "this is not a name");
    if (symbol_find(p, word))
        return true;
    const struct source *text = source_from_text(
        p->sources, arena_printf(p->arena, "Declare=%s", declare->name),
        declare->value);
    const struct token_list *list = lexer_run(p->arena, p->words, text);
    struct value value = { .kind = VALUE_NONE };
    if (!stream_push_range(p, list, 0, list->count - 1, word, span_none()))
        return false;
    bool ok = parse_expression(p, &value);
    if (ok && stream_peek(p)->kind != TOKEN_END)
        ok = error_expected(p, "the end of the value");
    stream_pop_range(p);
    if (ok)
        symbol_set(p, word, value, false);
    return ok;
}

static void parse_items(struct parser *p)
{
    while (stream_peek(p)->kind != TOKEN_END && !p->failed)
        parse_scene_item(p);
}

/* Headers named by +HI are read as if #included before the first line. */
static bool parse_headers(struct parser *p)
{
    const struct parse_options *options = p->options;
    for (size_t i = options->include_header_count; i > 0; i--) {
        const char *name = options->include_headers[i - 1], *problem = NULL;
        const char *path = file_locate(p, name, ".inc");
        if (!path)
            return error_at(p, span_none(),
                            file_hint(p, "include header", name),
                            "can't find the include header '%s'", name);
        const struct source *source =
            source_read(p->sources, path, span_none(), &problem);
        if (!source)
            return error_at(p, span_none(), NULL, "can't read '%s': %s", path,
                            problem);
        if (!stream_push_file(p, lexer_run(p->arena, p->words, source)))
            return false;
    }
    return true;
}

/* Half of what there is, since the picture and the world need some as well;
 * and what can be filled in a few seconds. */
static size_t parse_memory_limit(const struct parse_options *options)
{
    if (options->memory_limit)
        return options->memory_limit;
    size_t half = memory_available() / 2, most = (size_t)4 << 30;
    return half < most ? half : most;
}

static void parse_run(struct parser *p, const struct source *main)
{
    scope_push(p);
    p->global = p->scope;
    parse_predeclare(p, "Glim", GLIM_VERSION_NUMBER);
    parse_predeclare_frame(p);
    parse_predeclare_file(p, main);
    defaults_init(p);
    for (size_t i = 0; i < p->options->declare_count; i++)
        parse_declare(p, &p->options->declares[i]);
    if (!stream_push_file(p, lexer_run(p->arena, p->words, main)))
        return;
    if (parse_headers(p))
        parse_items(p);
    if (p->options->light_said)
        light_said_apply(p->options->light_said, p->options->light,
                         &p->scene->settings);
    if (p->diag->errors == 0) {
        data_files_tell(p);
        settings_finish(p);
    }
}

struct scene *parse_scene(const struct source *main,
                          const struct parse_options *options,
                          struct arena *sources, struct diag *diag)
{
    unsigned errors = diag->errors;
    size_t limit = parse_memory_limit(options);
    struct parser p = {
        .options = options,
        .diag = diag,
        .sources = sources,
        .arena = arena_new(limit),
        .scene = scene_new(limit),
        .version = options->version > 0 ? options->version : 3.7,
        .version_said = options->version > 0,
    };
    p.scene_arena = p.scene->arena;
    p.words = word_table_new(p.arena);
    settings_follow_version(&p);
    parse_run(&p, main);
    bool stopped = options->stop && *options->stop;
    p.scene->version = p.version;
    arena_free(p.arena);
    if (diag->errors == errors && !stopped)
        return p.scene;
    scene_free(p.scene);
    return NULL;
}
