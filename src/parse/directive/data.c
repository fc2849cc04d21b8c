/* #fopen #fclose #read #write: data files. They are read as includes are, and
 * never written: a scene may come from a stranger. */
#include "base/text.h"
#include "parse/array.h"
#include "parse/data_file.h"
#include "parse/directive.h"
#include "parse/expression.h"
#include "parse/symbol.h"

/* In rounds of a loop: a file is looked for in several places. */
enum { FOPEN_COST = 20 };

/* The next word, which is a name. */
static const struct word *data_name(struct parser *p, const char *wanted)
{
    const struct token *token = stream_peek(p);
    if (token->kind == TOKEN_WORD && !token->word->reserved)
        return stream_next(p).word;
    error_expected_hint(p, wanted, directive_bracketed_name(p));
    return NULL;
}

static const char *fopen_mode_meant(struct parser *p)
{
    const struct token *token = stream_peek(p);
    if (token->kind != TOKEN_WORD)
        return "read";
    struct text_nearest nearest = text_nearest_start(token->word->text);
    text_nearest_try(&nearest, "read");
    text_nearest_try(&nearest, "write");
    text_nearest_try(&nearest, "append");
    return nearest.best ? nearest.best : "read";
}

static bool fopen_mode(struct parser *p, enum keyword *mode)
{
    *mode = stream_keyword(p);
    if (*mode != KEYWORD_READ && *mode != KEYWORD_WRITE &&
        *mode != KEYWORD_APPEND)
        return error_expected_hint(p, "'read', 'write' or 'append'",
                                   fopen_mode_meant(p));
    stream_next(p);
    return true;
}

/* fopen_directive = "#fopen" name string ("read" | "write" | "append") . */
static bool fopen_read(struct parser *p, struct span at)
{
    const struct word *name = data_name(p, "a name for the file");
    struct span where = p->last_span;
    const char *path;
    enum keyword mode;
    if (!name || !parse_string(p, &path) || !fopen_mode(p, &mode))
        return false;
    const struct value *old = symbol_find(p, name);
    if (old && old->kind == VALUE_FILE)
        return error_at(p, where, NULL, "'%s' is open: '#fclose %s' first",
                        name->text, name->text);
    if (old)
        return error_at(p, where, NULL,
                        "'%s' is %s by now; name the file otherwise",
                        name->text, value_kind_name(old->kind));
    struct span span = span_join(at, p->last_span);
    if (!stream_round(p, FOPEN_COST, span))
        return false;
    struct data_file *file =
        mode == KEYWORD_READ
            ? data_file_read(p, path, span)
            : data_file_write(p, path, mode == KEYWORD_APPEND, span);
    if (!file) {
        stream_abort(p);
        return false;
    }
    symbol_set(p, name, (struct value){ .kind = VALUE_FILE, .file = file },
               false);
    return true;
}

static bool fopen_run(struct parser *p, struct span at)
{
    struct directive_head outer = directive_head_begin(p);
    bool ok = fopen_read(p, at);
    directive_head_end(p, outer);
    return ok;
}

/* Closing what is not open is no error, as in POV-Ray: the end of the file
 * closes it too.
 * fclose_directive = "#fclose" name . */
static bool fclose_run(struct parser *p, struct span at)
{
    (void)at;
    struct directive_head outer = directive_head_begin(p);
    const struct word *name = data_name(p, "the name of an open file");
    const struct value *value = name ? symbol_find(p, name) : NULL;
    bool ok = name && (!value || value->kind == VALUE_FILE);
    if (ok)
        symbol_undefine(p, name);
    else if (name)
        error_at(p, p->last_span, NULL, "'%s' is %s, not an open file",
                 name->text, value_kind_name(value->kind));
    directive_head_end(p, outer);
    return ok;
}

/* The rest of what is in the brackets, and the ')'. */
static void data_skip(struct parser *p)
{
    for (int depth = 1; depth > 0;) {
        enum token_kind kind = stream_peek_infix(p)->kind;
        if (kind == TOKEN_END)
            return;
        depth += (kind == TOKEN_LPAREN) - (kind == TOKEN_RPAREN);
        stream_next(p);
    }
}

/* "(" and the name of a file that is open for this. */
static struct data_file *data_open_file(struct parser *p, bool reading,
                                        const struct word **name)
{
    if (!expect(p, TOKEN_LPAREN, span_none()) ||
        !(*name = data_name(p, "the name of an open file")))
        return NULL;
    const struct value *value = symbol_find(p, *name);
    if (!value || value->kind != VALUE_FILE) {
        error_at(p, p->last_span,
                 arena_printf(p->arena, "#fopen %s \"FILE\" %s", (*name)->text,
                              reading ? "read" : "write"),
                 "'%s' is not an open file", (*name)->text);
        data_skip(p);
        return NULL;
    }
    if (reading == (value->file->list != NULL))
        return value->file;
    error_at(p, p->last_span, NULL, "'%s' is open for %s", (*name)->text,
             reading ? "writing" : "reading");
    return NULL;
}

/* A variable to be read into: one that has a value of another kind than files
 * do is a mistake. */
static bool read_variable(struct parser *p, const struct word **name,
                          struct value **element)
{
    *element = NULL;
    *name = data_name(p, "a name for what is read");
    if (!*name)
        return false;
    struct span span = p->last_span;
    const struct value *old = symbol_find(p, *name);
    enum value_kind kind = old ? old->kind : VALUE_NONE;
    if (kind == VALUE_ARRAY) {
        if (stream_peek(p)->kind != TOKEN_LBRACKET)
            return error_at(p, span,
                            arena_printf(p->arena, "%s[0]", (*name)->text),
                            "'%s' is an array: name an element", (*name)->text);
        if (!array_element(p, old->array, element))
            return false;
        kind = (*element)->kind;
    }
    if (kind == VALUE_NONE || kind == VALUE_POISON || kind == VALUE_FLOAT ||
        kind == VALUE_VECTOR || kind == VALUE_COLOUR || kind == VALUE_STRING)
        return true;
    return error_at(p, span, NULL, "'%s' is %s by now; name another",
                    (*name)->text, value_kind_name(kind));
}

/* At the end of the file variables keep what they have, and the file is
 * closed, which `#while (defined(F))` asks for. */
static bool read_list(struct parser *p, struct span open)
{
    const struct word *handle, *name;
    struct data_file *file = data_open_file(p, true, &handle);
    if (!file)
        return false;
    accept(p, TOKEN_COMMA);
    while (stream_peek(p)->kind != TOKEN_RPAREN) {
        struct value value, *element;
        if (!read_variable(p, &name, &element))
            return false;
        bool more = !data_file_ends(file);
        if (more && !data_file_next(p, file, &value)) {
            stream_abort(p);
            return false;
        }
        if (more && element)
            *element = value;
        else if (more)
            symbol_set(p, name, value, false);
        p->changes++;
        accept(p, TOKEN_COMMA);
    }
    if (data_file_ends(file))
        symbol_undefine(p, handle);
    return expect(p, TOKEN_RPAREN, open);
}

/* What stands in parentheses after #read and #write. */
static bool data_list(struct parser *p,
                      bool (*list)(struct parser *p, struct span open))
{
    struct directive_head outer = directive_head_begin(p);
    struct span open = stream_span(p);
    bool ok = list(p, open);
    bool closed = p->last_span.source && /* it was skipped */
                  p->last_span.source->text[p->last_span.offset] == ')';
    if (!ok && !closed && at_scene_item(p))
        note_at(p, open, "the ')' to this '(' may be missing");
    return directive_condition_end(p, outer) && ok;
}

/* read_directive = "#read" "(" name {[","] name [subscripts]} ")" . */
static bool read_run(struct parser *p, struct span at)
{
    (void)at;
    return data_list(p, read_list);
}

/* "uint16be" and its kin: what follows is written as bytes. */
static bool write_format(struct parser *p)
{
    static const char *const formats[] = { "sint8",    "uint8",    "sint16be",
                                           "sint16le", "uint16be", "uint16le",
                                           "sint32be", "sint32le" };
    const struct token *token = stream_peek(p);
    if (token->kind != TOKEN_WORD || symbol_find(p, token->word))
        return false;
    for (size_t i = 0; i < sizeof formats / sizeof *formats; i++) {
        if (strcmp(token->word->text, formats[i]) != 0)
            continue;
        stream_next(p);
        return true;
    }
    return false;
}

static bool write_list(struct parser *p, struct span open)
{
    const struct word *handle;
    struct data_file *file = data_open_file(p, false, &handle);
    if (!file)
        return false;
    accept(p, TOKEN_COMMA);
    while (stream_peek(p)->kind != TOKEN_RPAREN) {
        struct value value;
        bool bytes = write_format(p);
        if (!parse_expression(p, &value))
            return false;
        if (bytes)
            data_file_put_bytes(file);
        else
            data_file_put(p, file, &value);
        accept(p, TOKEN_COMMA);
    }
    return expect(p, TOKEN_RPAREN, open);
}

/* write_directive = "#write" "(" name {[","] [word] value} ")" . */
static bool write_run(struct parser *p, struct span at)
{
    (void)at;
    return data_list(p, write_list);
}

const struct directive fopen_directive = { fopen_run, "open a data file" };
const struct directive fclose_directive = { fclose_run, "close a data file" };
const struct directive read_directive = { read_run,
                                          "read values from a data file" };
const struct directive write_directive = {
    write_run, "write values, which are kept while the scene is read"
};
