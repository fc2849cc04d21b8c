/* Formatting: the indentation of lines, and nothing else. A line is as deep as
 * there are lines before it that opened what is still open. */
#include <ctype.h>

#include "base/writer.h"
#include "language/server.h"

enum { OPEN_LIMIT = 1000 };

struct format {
    const struct page *page;
    struct {
        size_t line;
        bool directive;
    } open[OPEN_LIMIT];
    size_t depth, beyond;
    size_t at, line;
    unsigned comment; /* depth of comments in slashes and stars */
    bool string;
};

static void format_open(struct format *f, bool directive)
{
    if (f->depth == OPEN_LIMIT) {
        f->beyond++;
        return;
    }
    f->open[f->depth].line = f->line;
    f->open[f->depth++].directive = directive;
}

/* The innermost of its kind; what is open inside it stays so. */
static void format_close(struct format *f, bool directive)
{
    size_t i = f->depth;
    if (f->beyond > 0) {
        f->beyond--;
        return;
    }
    while (i > 0 && f->open[i - 1].directive != directive)
        i--;
    if (i == 0)
        return;
    memmove(&f->open[i - 1], &f->open[i], (f->depth - i) * sizeof *f->open);
    f->depth--;
}

/* The word behind a '#' at `at`, its length in *length. */
static const char *format_directive(const char *at, size_t *length)
{
    at++;
    at += strspn(at, " \t");
    *length = 0;
    while (isalnum((unsigned char)at[*length]) || at[*length] == '_')
        ++*length;
    return at;
}

static bool word_is_any(const char *word, size_t length,
                        const char *const *list)
{
    for (; *list; list++)
        if (strlen(*list) == length && memcmp(word, *list, length) == 0)
            return true;
    return false;
}

static const char *const openers[] = { "if",  "ifdef", "ifndef", "while",
                                       "for", "macro", "switch", NULL };
static const char *const enders[] = { "end", NULL };
static const char *const others[] = { "else", "elseif", NULL };

/* What was opened in the other branch is not open in this one. */
static void format_else(struct format *f)
{
    size_t i = f->depth;
    while (i > 0 && !f->open[i - 1].directive)
        i--;
    if (i > 0)
        f->depth = i;
}

/* One character, or what belongs together, of what is no comment. */
static void format_code(struct format *f)
{
    const char *at = f->page->text + f->at;
    size_t length;
    if (*at == '{' || *at == '(' || *at == '[')
        format_open(f, false);
    else if (*at == '}' || *at == ')' || *at == ']')
        format_close(f, false);
    else if (*at == '"')
        f->string = true;
    else if (*at == '#') {
        const char *word = format_directive(at, &length);
        if (word_is_any(word, length, openers))
            format_open(f, true);
        else if (word_is_any(word, length, enders))
            format_close(f, true);
        else if (word_is_any(word, length, others))
            format_else(f);
        f->at = (size_t)(word + length - f->page->text);
        return;
    }
    f->at++;
}

static void format_step(struct format *f, size_t end)
{
    const char *at = f->page->text + f->at;
    if (f->string) {
        bool escape = *at == '\\' && f->at + 1 < end;
        f->string = *at != '"';
        f->at += escape ? 2 : 1;
    } else if (at[0] == '/' && at[1] == '*') {
        f->comment++;
        f->at += 2;
    } else if (f->comment) {
        bool closes = at[0] == '*' && at[1] == '/';
        f->comment -= closes;
        f->at += closes ? 2 : 1;
    } else if (at[0] == '/' && at[1] == '/') {
        f->at = end;
    } else {
        format_code(f);
    }
}

/* How deep the line is that begins with `text`: what it closes first counts
 * no more. */
static size_t format_level(const struct format *f, const char *text)
{
    size_t level = 0, depth = f->depth, length = 0;
    const char *word = *text == '#' ? format_directive(text, &length) : text;
    if (word_is_any(word, length, enders) || word_is_any(word, length, others))
        while (depth > 0 && !f->open[--depth].directive)
            continue;
    else
        for (; depth > 0 && (*text == '}' || *text == ')' || *text == ']');
             text += 1 + strspn(text + 1, " \t"))
            depth--;
    for (size_t i = 0; i < depth; i++)
        level += i == 0 || f->open[i].line != f->open[i - 1].line;
    return level;
}

static void format_line(struct format *f, struct arena *arena, size_t tab,
                        bool spaces, json_t *edits)
{
    const struct page *page = f->page;
    size_t start = page->lines.items[f->line];
    size_t first = start + strspn(page->text + start, " \t");
    bool blank = strchr("\r\n", page->text[first]) != NULL;
    size_t level = blank ? 0 : format_level(f, page->text + first);
    size_t width = spaces ? level * tab : level;
    char *wanted = arena_alloc(arena, width + 1);
    memset(wanted, spaces ? ' ' : '\t', width);
    bool same = first - start == width &&
                memcmp(page->text + start, wanted, width) == 0;
    if (!same)
        json_array_append_new(
            edits, json_pack("{s:o,s:s}", "range",
                             json_range(page_range(page, start, first)),
                             "newText", wanted));
}

json_t *format_answer(struct request *request)
{
    const struct page *page = request->page;
    const json_t *options = json_object_get(request->params, "options");
    json_int_t tab = json_integer_value(json_object_get(options, "tabSize"));
    bool spaces = !json_is_false(json_object_get(options, "insertSpaces"));
    size_t width = tab >= 1 && tab <= 16 ? (size_t)tab : 2;
    struct format *f = ARENA_NEW(request->arena, struct format);
    json_t *edits = json_array();
    f->page = page;
    for (f->line = 0; f->line < page->lines.count; f->line++) {
        bool last = f->line + 1 == page->lines.count;
        size_t end = last ? page->length : page->lines.items[f->line + 1];
        if (!f->comment && !f->string)
            format_line(f, request->arena, width, spaces, edits);
        while (f->at < end)
            format_step(f, end);
    }
    return edits;
}
