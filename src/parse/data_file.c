/* Data files: see data_file.h. */
#include "parse/data_file.h"

#include "parse/expression.h"

struct data_text {
    const char *name;
    char *items; /* no NUL at the end */
    size_t count, capacity;
    struct span opened; /* for writing, first: where the user says so */
    bool bytes;         /* others than text were written too */
    bool wanted;        /* it was read back */
};

struct data_files {
    struct data_text **items;
    size_t count, capacity;
};

static struct data_text *data_text_find(struct parser *p, const char *name)
{
    for (size_t i = 0; p->data_files && i < p->data_files->count; i++)
        if (strcmp(p->data_files->items[i]->name, name) == 0)
            return p->data_files->items[i];
    return NULL;
}

static void data_text_add(struct parser *p, struct data_text *text,
                          const char *piece, size_t length)
{
    for (size_t i = 0; i < length; i++)
        *ARRAY_PUSH(p->arena, text) = piece[i];
}

const struct source *data_file_written(struct parser *p, const char *name,
                                       struct span span, const char **problem)
{
    struct data_text *text = data_text_find(p, name);
    *problem = text && text->bytes ? "glim keeps only text of what a scene "
                                     "writes, and writes no files"
                                   : NULL;
    if (!text || *problem)
        return NULL;
    text->wanted = true;
    struct source *source = ARENA_NEW(p->sources, struct source);
    char *copy = arena_alloc(p->sources, text->count + 1);
    if (text->count > 0)
        memcpy(copy, text->items, text->count);
    copy[text->count] = '\0';
    *source = (struct source){
        .name = name, .text = copy, .length = text->count, .included_from = span
    };
    return source;
}

static const struct source *data_file_source(struct parser *p, const char *name,
                                             struct span span)
{
    const char *problem;
    const struct source *source = data_file_written(p, name, span, &problem);
    if (source)
        return source;
    if (!problem) {
        const char *path = file_need(p, span, "data file", name, NULL);
        if (!path)
            return NULL;
        source = source_read(p->sources, path, span, &problem);
    }
    if (!source)
        error_at(p, span, NULL, "can't read '%s': %s", name, problem);
    return source;
}

struct data_file *data_file_read(struct parser *p, const char *name,
                                 struct span span)
{
    const struct source *source = data_file_source(p, name, span);
    if (!source)
        return NULL;
    struct data_file *file = ARENA_NEW(p->arena, struct data_file);
    file->name = name;
    file->list = lexer_run(p->arena, p->words, source);
    return file;
}

static void data_text_start(struct parser *p, struct data_text *text,
                            struct span span)
{
    const char *problem, *path = file_find(p, text->name, NULL);
    const struct source *source =
        path ? source_read(p->arena, path, span, &problem) : NULL;
    if (source)
        data_text_add(p, text, source->text, source->length);
}

struct data_file *data_file_write(struct parser *p, const char *name,
                                  bool append, struct span span)
{
    if (!p->data_files)
        p->data_files = ARENA_NEW(p->arena, struct data_files);
    struct data_text *text = data_text_find(p, name);
    bool known = text;
    if (!known) {
        text = ARENA_NEW(p->arena, struct data_text);
        text->name = name;
        text->opened = library_user(p, span);
        *ARRAY_PUSH(p->arena, p->data_files) = text;
    }
    if (!append) {
        text->count = 0;
        text->bytes = false;
    } else if (!known) {
        data_text_start(p, text, span);
    }
    struct data_file *file = ARENA_NEW(p->arena, struct data_file);
    file->name = name;
    file->text = text;
    return file;
}

void data_files_tell(struct parser *p)
{
    for (size_t i = 0; p->data_files && i < p->data_files->count; i++) {
        const struct data_text *text = p->data_files->items[i];
        if (!text->wanted)
            warning_at(p, text->opened, NULL,
                       "glim writes no files: '%s' is not written, and nobody "
                       "reads it here",
                       text->name);
    }
}

/* ---- reading ---- */

bool data_file_ends(const struct data_file *file)
{
    return file->list->tokens[file->next].kind == TOKEN_END;
}

static bool data_file_take(struct data_file *file, enum token_kind kind)
{
    if (file->list->tokens[file->next].kind != kind)
        return false;
    file->next++;
    return true;
}

static bool data_file_expected(struct parser *p, const struct data_file *file,
                               const char *wanted)
{
    struct span span = token_span(file->list, file->next);
    if (data_file_ends(file))
        return error_at(p, span, NULL, "expected %s, found the end of the file",
                        wanted);
    return error_at(p, span, NULL,
                    "expected %s, found '%.*s'; '#read' takes no expressions",
                    wanted, (int)span.length, span.source->text + span.offset);
}

/* data_number = {"-" | "+"} number . */
static bool data_number(struct parser *p, struct data_file *file,
                        const char *wanted, double *out)
{
    double sign = 1;
    for (;;) {
        if (data_file_take(file, TOKEN_MINUS))
            sign = -sign;
        else if (!data_file_take(file, TOKEN_PLUS))
            break;
    }
    const struct token *token = &file->list->tokens[file->next];
    if (token->kind != TOKEN_NUMBER)
        return data_file_expected(p, file, wanted);
    *out = sign * token->number;
    file->next++;
    return true;
}

/* data_vector = "<" data_number {[","] data_number} ">" . */
static bool data_vector(struct parser *p, struct data_file *file,
                        struct value *value)
{
    struct span open = token_span(file->list, file->next++);
    *value = (struct value){ .kind = VALUE_VECTOR };
    while (value->size < 5 &&
           (value->size < 2 ||
            file->list->tokens[file->next].kind != TOKEN_GREATER)) {
        if (!data_number(p, file, "a number", &value->number[value->size++]))
            return false;
        data_file_take(file, TOKEN_COMMA);
    }
    if (data_file_take(file, TOKEN_GREATER))
        return true;
    data_file_expected(p, file, "'>'");
    note_at(p, open, "to match this '<'");
    return false;
}

/* data_value = (data_number | data_vector | string) ["," | ";"] . */
bool data_file_next(struct parser *p, struct data_file *file,
                    struct value *value)
{
    const struct token *token = &file->list->tokens[file->next];
    if (token->kind == TOKEN_LESS) {
        if (!data_vector(p, file, value))
            return false;
    } else if (token->kind == TOKEN_STRING) {
        *value = value_text(token->text);
        file->next++;
    } else {
        *value = value_float(0);
        if (!data_number(p, file, "a number, a vector or a string",
                         &value->number[0]))
            return false;
    }
    if (!data_file_take(file, TOKEN_COMMA))
        data_file_take(file, TOKEN_SEMICOLON);
    return true;
}

/* ---- writing ---- */

void data_file_put_bytes(struct data_file *file)
{
    file->text->bytes = true;
}

static void data_file_put_number(struct parser *p, struct data_file *file,
                                 double number)
{
    const char *text = arena_printf(p->arena, "%g", number);
    data_text_add(p, file->text, text, strlen(text));
}

void data_file_put(struct parser *p, struct data_file *file,
                   const struct value *value)
{
    struct data_text *text = file->text;
    if (value->kind == VALUE_STRING) {
        data_text_add(p, text, value->text, strlen(value->text));
        return;
    }
    int size = value_size(value);
    if (size > 1)
        data_text_add(p, text, "<", 1);
    for (int i = 0; i < size; i++) {
        if (i > 0)
            data_text_add(p, text, ",", 1);
        data_file_put_number(p, file, value->number[i]);
    }
    if (size > 1)
        data_text_add(p, text, "> ", 2);
}
