/* The manual: see manual.h. It is mdoc(7); what of it glim.5 uses is read. */
#include "language/manual.h"

#include <ctype.h>
#include <stdbool.h>
#include <stdio.h>

#include "base/writer.h"

static const char manual_source[] =
#include "manual.inc"
    ;

/* ---- mdoc to Markdown ---- */

struct mdoc {
    struct writer text;
    bool code, tight; /* in a `code`; nothing between it and the next */
};

static void mdoc_code(struct mdoc *m, bool code)
{
    if (m->code != code)
        writer_add(&m->text, "`", 1);
    m->code = code;
}

static void mdoc_blank(struct mdoc *m)
{
    bool begun =
        m->text.count > 0 && !strchr(" \n", m->text.items[m->text.count - 1]);
    if (begun && !m->tight)
        writer_add(&m->text, " ", 1);
    m->tight = false;
}

/* Text with roff's escapes. */
static void mdoc_plain(struct mdoc *m, const char *from, size_t length)
{
    static const struct {
        const char *escape, *meaning;
    } escapes[] = {
        { "\\(em", "\xe2\x80\x94" },
        { "\\(dq", "\"" },
        { "\\(S2", "\xc2\xb2" },
        { "\\(mu", "\xc3\x97" },
        { "\\(->", "\xe2\x86\x92" },
        { "\\&", "" },
        { "\\e", "\\" },
        { "\\-", "-" },
        { "\\(co", "\xc2\xa9" },
        { "\\ ", " " },
    };
    for (size_t i = 0; i < length;) {
        size_t taken = 0;
        for (size_t e = 0;
             from[i] == '\\' && e < sizeof escapes / sizeof *escapes; e++) {
            size_t size = strlen(escapes[e].escape);
            if (size <= length - i &&
                memcmp(from + i, escapes[e].escape, size) == 0) {
                writer_add(&m->text, escapes[e].meaning,
                           strlen(escapes[e].meaning));
                taken = size;
                break;
            }
        }
        if (!taken) {
            writer_add(&m->text, from + i, 1);
            taken = 1;
        }
        i += taken;
    }
}

static bool word_is(const char *word, size_t length, const char *what)
{
    return strlen(what) == length && memcmp(word, what, length) == 0;
}

static bool word_is_any(const char *word, size_t length,
                        const char *const *list)
{
    for (; *list; list++)
        if (word_is(word, length, *list))
            return true;
    return false;
}

static const char *const code_macros[] = { "Ic", "Li", "Ql", "Pa", "Ar",
                                           "Cm", "Fn", "Dl", "Fl", NULL };
static const char *const text_macros[] = { "Em", "Sx", "No", "Nm",  "Xr",
                                           "It", "Op", "Pq", "Brq", NULL };

/* One word of a macro's line. */
static void mdoc_word(struct mdoc *m, const char *word, size_t length,
                      bool *code)
{
    static const struct {
        const char *macro, *sign;
        bool opens;
    } signs[] = {
        { "Oo", "[", true },
        { "Oc", "]", false },
        { "Qo", "\"", true },
        { "Qc", "\"", false },
    };
    for (size_t i = 0; i < sizeof signs / sizeof *signs; i++) {
        if (!word_is(word, length, signs[i].macro))
            continue;
        mdoc_code(m, false);
        m->tight |= !signs[i].opens;
        mdoc_blank(m);
        writer_add(&m->text, signs[i].sign, 1);
        m->tight = signs[i].opens;
        return;
    }
    if (word_is(word, length, "Ns")) {
        mdoc_code(m, false);
        m->tight = true;
        return;
    }
    if (word_is_any(word, length, code_macros) ||
        word_is_any(word, length, text_macros)) {
        mdoc_code(m, false);
        *code = word_is_any(word, length, code_macros);
        return;
    }
    bool closing = length == 1 && strchr(".,;:)]", *word);
    bool opening = length == 1 && strchr("([", *word);
    bool marked = *code && !closing && !opening;
    if (!marked)
        mdoc_code(m, false);
    m->tight |= closing;
    mdoc_blank(m);
    mdoc_code(m, marked);
    mdoc_plain(m, word, length);
    m->tight = opening;
}

static void mdoc_line(struct mdoc *m, const char *line, size_t length)
{
    bool macro = length > 0 && *line == '.';
    if (!macro) {
        mdoc_blank(m);
        mdoc_plain(m, line, length);
        return;
    }
    bool code = false;
    for (size_t i = 1; i < length;) {
        size_t end = i;
        while (end < length && line[end] != ' ')
            end++;
        if (end > i)
            mdoc_word(m, line + i, end - i, &code);
        i = end + 1;
    }
    mdoc_code(m, false);
}

/* ---- the page in units: a paragraph, or an item of a list ---- */

struct unit {
    const char *head; /* the ".It" line, or NULL */
    bool literal;     /* lines as they stand */
    const char *start, *end;
    char section[64];
};

static const char *line_end(const char *line)
{
    const char *end = strchr(line, '\n');
    return end ? end : line + strlen(line);
}

static bool line_is(const char *line, const char *macro)
{
    size_t length = strlen(macro);
    return strncmp(line, macro, length) == 0 &&
           (line[length] == '\n' || line[length] == ' ' || !line[length]);
}

static const char *line_next(const char *line)
{
    const char *end = line_end(line);
    return end + (*end == '\n');
}

/* What stands in a ".Bd -literal". */
static void unit_literal(const char *line, struct unit *unit)
{
    unit->literal = true;
    unit->start = line;
    while (*line && !line_is(line, ".Ed"))
        line = line_next(line);
    unit->end = line;
}

static void unit_text(const char *line, struct unit *unit)
{
    static const char *const ends[] = { ".Sh", ".Ss", ".It", ".El",
                                        ".Pp", ".Bl", ".Bd", NULL };
    unit->start = line;
    for (; *line; line = line_next(line))
        for (size_t i = 0; ends[i]; i++)
            if (line_is(line, ends[i])) {
                unit->end = line;
                return;
            }
    unit->end = line;
}

/* The next unit from *at on; false at the end. */
static bool unit_next(const char **at, struct unit *unit)
{
    const char *line = *at;
    unit->head = NULL;
    unit->literal = false;
    for (; *line; line = line_next(line)) {
        if (line_is(line, ".Sh") || line_is(line, ".Ss"))
            snprintf(unit->section, sizeof unit->section, "%.*s",
                     (int)(line_end(line + 4) - line - 4), line + 4);
        else if (line_is(line, ".It")) {
            unit->head = line;
            unit_text(line_next(line), unit);
            *at = unit->end;
            return true;
        } else if (line_is(line, ".Bd")) {
            unit_literal(line_next(line), unit);
            *at = unit->end;
            return true;
        } else if (!line_is(line, ".Bl") && !line_is(line, ".El") &&
                   !line_is(line, ".Pp") && !line_is(line, ".Ed") &&
                   strncmp(line, ".\\\"", 3) != 0) {
            unit_text(line, unit);
            *at = unit->end;
            return true;
        }
    }
    return false;
}

/* How much a macro's line is about the word: 3, it begins with it or with a
 * list that has it; 2, it is in it; 0, it isn't. */
static int line_rank(const char *line, const char *word)
{
    bool marked = false, first = true;
    const char *end = line_end(line);
    for (const char *at = line + 1; at < end;) {
        size_t length = strcspn(at, " \n");
        if (word_is(at, length, "Ic") || word_is(at, length, "Li")) {
            marked = true;
        } else if (isupper((unsigned char)*at) && length == 2 &&
                   islower((unsigned char)at[1])) {
            marked = false;
            first &= word_is(at, length, "It");
        } else if (marked && (isalpha((unsigned char)*at) || *at == '#')) {
            bool sign = *at == '#';
            if (word_is(at + sign, length - sign, word))
                return first ? 3 : 2;
        } else if (!word_is(at, length, ",")) {
            first = false;
        }
        at += length + 1;
    }
    return 0;
}

static int unit_rank(const struct unit *unit, const char *word)
{
    size_t length = strlen(word);
    if (unit->literal)
        return strncmp(unit->start, word, length) == 0 &&
                       unit->start[length] == ' '
                   ? 7
                   : 0;
    int rank = unit->head ? line_rank(unit->head, word) * 2 : 0;
    for (const char *line = unit->start; line < unit->end && !rank;
         line = line_end(line) + 1)
        if (*line == '.' && line_rank(line, word))
            rank = 1;
    return rank;
}

/* The unit, or of a long one the sentences that have the word. */
static void unit_write(struct mdoc *m, const struct unit *unit,
                       const char *word, int rank)
{
    if (unit->literal) {
        writer_add(&m->text, "```\n", 4);
        writer_add(&m->text, unit->start, (size_t)(unit->end - unit->start));
        writer_add(&m->text, "```", 3);
        return;
    }
    if (unit->head) {
        mdoc_line(m, unit->head, (size_t)(line_end(unit->head) - unit->head));
        writer_add(&m->text, "\n\n", 2);
    }
    const char *sentence = unit->start;
    bool has = false;
    for (const char *line = unit->start; line < unit->end;) {
        const char *end = line_end(line);
        has |= rank > 2 || (*line == '.' && line_rank(line, word));
        bool stops = end > line && end[-1] == '.';
        line = end + 1;
        if (!stops && line < unit->end)
            continue;
        for (; has && sentence < line; sentence = line_end(sentence) + 1)
            mdoc_line(m, sentence, (size_t)(line_end(sentence) - sentence));
        sentence = line;
        has = false;
    }
}

/* A word has several meanings: those of the block it stands in come first. */
static bool section_fits(const char *section, const char *block)
{
    static const struct {
        const char *block, *section;
    } fits[] = {
        { "light_source", "LIGHTS" },
        { "camera", "CAMERA" },
        { "pigment", "Patterns" },
        { "normal", "Patterns" },
        { "global_settings", "global_settings" },
        { "media", "media" },
        { "interior", "Interior" },
        { "finish", "Finish" },
        { "reflection", "Finish" },
        { "photons", "Photons" },
        { "light_mesh", "light_mesh" },
        { "indirect", "light_mesh" },
        { "skeleton", "skeleton" },
        { "texture", "Patterns" },
        { "warp", "Patterns" },
        { "scattering", "media" },
        { "radiosity", "light_mesh" },
    };
    for (size_t i = 0; block && i < sizeof fits / sizeof *fits; i++)
        if (strcmp(fits[i].block, block) == 0)
            return strcmp(fits[i].section, section) == 0;
    return false;
}

const char *manual_text(struct arena *arena, const char *word,
                        const char *block)
{
    struct unit unit = { 0 }, best = { 0 };
    const char *at = manual_source;
    int best_rank = 0;
    while (unit_next(&at, &unit)) {
        int rank = unit_rank(&unit, word);
        if (rank)
            rank = rank * 2 + 5 * section_fits(unit.section, block);
        if (rank <= best_rank || strcmp(unit.section, "SEE ALSO") == 0)
            continue;
        best = unit;
        best_rank = rank;
    }
    if (!best_rank)
        return NULL;
    struct mdoc m = { .text = writer_new() };
    unit_write(&m, &best, word, unit_rank(&best, word));
    const char *text =
        arena_printf(arena, "%.*s\n\n*glim(5), %s*", (int)m.text.count,
                     m.text.items, best.section);
    writer_free(&m.text);
    return text;
}

const char *manual_function(struct arena *arena, const char *word,
                            const char **help)
{
    struct unit unit = { 0 };
    const char *at = manual_source;
    while (unit_next(&at, &unit)) {
        if (strcmp(unit.section, "Functions") != 0 || !unit.head ||
            line_rank(unit.head, word) == 0)
            continue;
        struct mdoc m = { .text = writer_new() };
        for (const char *line = unit.start; line < unit.end;
             line = line_end(line) + 1)
            mdoc_line(&m, line, (size_t)(line_end(line) - line));
        *help = arena_copy_text(arena, m.text.items, m.text.count);
        m.text.count = 0;
        mdoc_line(&m, unit.head, (size_t)(line_end(unit.head) - unit.head));
        char *call = arena_copy_text(arena, m.text.items, m.text.count);
        writer_free(&m.text);
        char *to = call;
        for (char *from = call; *from; from++)
            if (*from != '`')
                *to++ = *from;
        *to = '\0';
        char *begin = strstr(call, word);
        char *close = begin ? strchr(begin, ')') : NULL;
        if (close && begin[strlen(word)] == '(') {
            close[1] = '\0';
            return begin;
        }
        return arena_printf(arena, "%s(...)", word);
    }
    return NULL;
}
