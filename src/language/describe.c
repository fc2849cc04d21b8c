/* Descriptions: see describe.h. */
#include "language/describe.h"

#include "base/text.h"
#include "base/writer.h"
#include "language/manual.h"
#include "scene/pattern.h"
#include "scene/primitive.h"

/* Its other spelling is as good. */
static const char *word_spelling(const struct word *word)
{
    return word->keyword ? keyword_spelling(word->keyword) : word->text;
}

/* The arguments and items of a shape or a pattern, from its tables. */
static void describe_fields(struct writer *text, const struct field *field)
{
    for (; field && field->name; field++) {
        writer_print(text, "\n- `%s`: ", field->name);
        writer_add(text, field->help, strlen(field->help));
    }
}

static bool describe_tables(struct writer *text, const char *word)
{
    const struct primitive *primitive = primitive_find(word);
    const struct pattern_kind *pattern = pattern_find(word);
    if (primitive) {
        writer_print(text, "%s", primitive->help);
        describe_fields(text, primitive->arguments);
        describe_fields(text, primitive->items);
    } else if (pattern) {
        writer_print(text, "pattern: %s", pattern->help);
        describe_fields(text, pattern->arguments);
        describe_fields(text, pattern->items);
    }
    return primitive || pattern;
}

const char *describe_keyword(struct server *server, struct arena *arena,
                             const struct word *word, const char *block)
{
    const char *spelling = word_spelling(word);
    const char *manual = manual_text(arena, word->text, block);
    if (!manual)
        manual = manual_text(arena, spelling, block);
    struct writer text = writer_new();
    const char *usage = grammar_usage(server->grammar, arena, spelling);
    bool table = describe_tables(&text, spelling);
    const char *lines =
        arena_copy_text(arena, text.items ? text.items : "", text.count);
    writer_free(&text);
    if (!manual && !table && !usage)
        return arena_printf(arena,
                            "`%s`: a word of POV-Ray's language that glim "
                            "does not support",
                            word->text);
    return arena_printf(arena, "**%s**\n\n%s%s%s%s%s%s", word->text, lines,
                        table && manual ? "\n\n" : "", manual ? manual : "",
                        usage ? "\n\n```\n" : "", usage ? usage : "",
                        usage ? "```" : "");
}

const char *describe_macro(struct arena *arena, const struct name *macro)
{
    const char *text = arena_printf(arena, "%s(", macro->word->text);
    for (size_t i = 0; i < macro->parameter_count; i++)
        text = arena_printf(arena, "%s%s%s", text, i ? ", " : "",
                            macro->parameters[i]->text);
    return arena_printf(arena, "%s)", text);
}

static const char *describe_numbers(struct arena *arena,
                                    const struct meaning *meaning)
{
    if (meaning->size == 1)
        return arena_printf(arena, "%s", NUMBER_TEXT(meaning->numbers[0]));
    bool filter = meaning->colour && meaning->numbers[3] != 0;
    bool transmit = meaning->colour && meaning->numbers[4] != 0;
    int size = !meaning->colour ? meaning->size : transmit ? 5 : filter ? 4 : 3;
    const char *text = arena_printf(arena, "%s<",
                                    !meaning->colour ? ""
                                    : transmit       ? "rgbft "
                                    : filter         ? "rgbf "
                                                     : "rgb ");
    for (int i = 0; i < size; i++)
        text = arena_printf(arena, "%s%s%s", text, i ? ", " : "",
                            NUMBER_TEXT(meaning->numbers[i]));
    return arena_printf(arena, "%s>", text);
}

const char *describe_value(struct server *server, struct arena *arena,
                           const struct name *name)
{
    static const char *const kinds[] = { [NAME_DECLARE] = "declared",
                                         [NAME_LOCAL] = "local",
                                         [NAME_MACRO] = "a macro",
                                         [NAME_PARAMETER] =
                                             "a macro's parameter",
                                         [NAME_LOOP] = "counts a #for" };
    const struct meaning *meaning =
        name->kind == NAME_DECLARE || name->kind == NAME_LOCAL
            ? roots_meaning(server, name->word->text)
            : NULL;
    if (meaning && meaning->size)
        return arena_printf(arena, "%s, %s", meaning->kind,
                            describe_numbers(arena, meaning));
    if (meaning && meaning->text)
        return arena_printf(arena, "%s, \"%s\"", meaning->kind, meaning->text);
    if (meaning)
        return meaning->kind;
    if (name->value && name->value->reserved && name->kind < NAME_MACRO)
        return arena_printf(arena, "%s, %s ...", kinds[name->kind],
                            name->value->text);
    return kinds[name->kind];
}

/* Where the line before the one at `at` begins; `at` itself in the first. */
static size_t line_before(const char *text, size_t at)
{
    if (at == 0)
        return 0;
    at--;
    while (at > 0 && text[at - 1] != '\n')
        at--;
    return at;
}

static bool line_is_comment(const char *line)
{
    line += strspn(line, " \t");
    return line[0] == '/' && line[1] == '/';
}

/* A comment in slashes and stars that ends right above `end`, or NULL. */
static const char *comment_block(struct arena *arena, const char *text,
                                 size_t end)
{
    while (end > 0 && strchr(" \t\r\n", text[end - 1]))
        end--;
    if (end < 4 || text[end - 1] != '/' || text[end - 2] != '*')
        return NULL;
    size_t start = end - 3;
    while (start > 0 && !(text[start - 1] == '/' && text[start] == '*'))
        start--;
    return start == 0 ? NULL
                      : arena_copy_text(arena, text + start + 1,
                                        end - 2 - (start + 1));
}

const char *describe_comment(struct arena *arena, struct page *page,
                             const struct name *name)
{
    enum { LINES = 40 };
    size_t end = page->tokens->tokens[name->first].offset;
    while (end > 0 && page->text[end - 1] != '\n')
        end--;
    size_t start = end;
    for (int i = 0; i < LINES && start > 0; i++) {
        size_t before = line_before(page->text, start);
        if (!line_is_comment(page->text + before))
            break;
        start = before;
    }
    if (start == end)
        return comment_block(arena, page->text, end);
    struct writer text = writer_new();
    while (start < end) {
        const char *line = page->text + start;
        size_t length = strcspn(line, "\n") + 1;
        line += strspn(line, " \t/");
        size_t shown = strcspn(line, "\r\n");
        writer_add(&text, line, shown);
        writer_add(&text, "  \n", 3);
        start += length;
    }
    const char *comment = arena_copy_text(arena, text.items, text.count);
    writer_free(&text);
    return comment;
}

const struct name *describe_find(struct server *server, struct arena *arena,
                                 struct page *page, const struct word *word,
                                 size_t token, struct page **where)
{
    struct page_list list = { 0 };
    const struct name *name =
        outline_name(page_outline(&server->library, page), word, token);
    *where = page;
    if (name)
        return name;
    pages_around(&server->library, page, arena, &list);
    return pages_name(&server->library, &list, word, where);
}
