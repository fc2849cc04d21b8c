/* The printer of messages: see diag.h. A message is built whole and written
 * by one call, so that threads and pipes can't tear it. */
#include "text/diag.h"

#include <string.h>

#include "base/array.h"

struct diag_text {
    char *items;
    size_t count, capacity;
    struct arena *arena;
};

static void diag_put(struct diag_text *text, const char *piece, size_t length)
{
    for (size_t i = 0; i < length; i++)
        *ARRAY_PUSH(text->arena, text) = piece[i];
}

static void diag_vputf(struct diag_text *text, const char *format,
                       va_list arguments)
{
    va_list again;
    va_copy(again, arguments);
    int length = vsnprintf(NULL, 0, format, arguments);
    char *piece = arena_alloc(text->arena, (size_t)length + 1);
    vsnprintf(piece, (size_t)length + 1, format, again);
    va_end(again);
    diag_put(text, piece, (size_t)length);
}

__attribute__((format(printf, 2, 3))) static void
diag_putf(struct diag_text *text, const char *format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    diag_vputf(text, format, arguments);
    va_end(arguments);
}

/* Bytes of the character that begins here, 0 if it is broken UTF-8. */
static size_t diag_character(const char *text, size_t length)
{
    unsigned char c = (unsigned char)*text;
    size_t size = c < 0x80 ? 1 : c < 0xc2 ? 0 : c < 0xe0 ? 2 : c < 0xf0 ? 3 : 4;
    if (c > 0xf4 || size > length)
        return 0;
    for (size_t i = 1; i < size; i++)
        if (((unsigned char)text[i] & 0xc0) != 0x80)
            return 0;
    return size;
}

/* Tabs advance to multiples of 8, other control bytes and broken UTF-8 print
 * as '?': one column each, so the carets stay under what they mark. Returns
 * the column after the text; with `text` NULL nothing is printed. */
static unsigned diag_put_source(struct diag_text *text, const char *line,
                                size_t length, unsigned column)
{
    for (size_t i = 0; i < length;) {
        size_t size = diag_character(line + i, length - i);
        bool tab = line[i] == '\t';
        bool shown = size > 1 || (size && line[i] >= 32 && line[i] != 127);
        unsigned stop = tab ? (column / 8 + 1) * 8 : column + 1;
        for (; text && tab && column < stop; column++)
            diag_put(text, " ", 1);
        if (text && !tab)
            diag_put(text, shown ? line + i : "?", shown ? size : 1);
        column = stop;
        i += size ? size : 1;
    }
    return column;
}

/* Long lines (generated meshes) are cut to a window around the span, whose ends
 * are no middles of characters, or, in what is no text, are where they are. */
enum { DIAG_WINDOW = 160 };

static void diag_put_excerpt(struct diag_text *text, struct span span,
                             struct source_place place, const char *hint)
{
    const char *source = span.source->text;
    size_t start = place.line_start, end = place.line_end;
    if (span.offset - start > DIAG_WINDOW / 2 && end - start > DIAG_WINDOW) {
        start = span.offset - DIAG_WINDOW / 2;
        while (start < span.offset &&
               ((unsigned char)source[start] & 0xc0) == 0x80)
            start++;
    }
    if (end - start > DIAG_WINDOW) {
        end = start + DIAG_WINDOW;
        while (end > span.offset && ((unsigned char)source[end] & 0xc0) == 0x80)
            end--;
    }
    diag_putf(text, "%5u | ", place.line);
    diag_put_source(text, source + start, end - start, 0);
    unsigned caret =
        diag_put_source(NULL, source + start, span.offset - start, 0);
    size_t length = span.length;
    if (span.offset + length > end)
        length = end > span.offset ? end - span.offset : 0;
    unsigned stop = diag_put_source(NULL, source + span.offset, length, caret);
    diag_putf(text, "\n      | %*s^", (int)caret, "");
    for (unsigned i = caret + 1; i < stop; i++)
        diag_put(text, "~", 1);
    if (hint)
        diag_putf(text, "\n      | %*s%s", (int)caret, "", hint);
    diag_put(text, "\n", 1);
}

static const char *const diag_words[] = {
    [DIAG_ERROR] = "error: ",
    [DIAG_WARNING] = "warning: ",
    [DIAG_NOTE] = "note: ",
    [DIAG_MESSAGE] = "",
};

/* Counts the message; returns whether it is to be printed. */
static bool diag_admit(struct diag *diag, enum diag_level level)
{
    if (level == DIAG_ERROR)
        diag->muted = ++diag->errors > DIAG_ERROR_LIMIT;
    else if (level == DIAG_WARNING) {
        bool enough = ++diag->warnings == DIAG_WARNING_LIMIT + 1;
        if (enough && diag->out && !diag->quiet_warnings)
            fprintf(diag->out,
                    "glim: note: %d warnings are enough; no more of them are "
                    "printed\n",
                    DIAG_WARNING_LIMIT);
        diag->muted =
            diag->quiet_warnings || diag->warnings > DIAG_WARNING_LIMIT;
    } else if (level == DIAG_MESSAGE)
        return (diag->out || diag->listen) && !diag->quiet_messages;
    return (diag->out || diag->listen) && !diag->muted;
}

static void diag_tell(struct diag *diag, enum diag_level level,
                      struct span span, const char *hint, const char *format,
                      va_list arguments)
{
    struct diag_text text = { .arena = arena_new(0) };
    diag_vputf(&text, format, arguments);
    diag_put(&text, "", 1);
    diag->listen(diag->listener, level, span, hint, text.items);
    arena_free(text.arena);
}

struct diag diag_new(void)
{
    return (struct diag){ .out = stderr };
}

/* What the scene says, as it says it. */
static void diag_say(struct diag *diag, const char *format, va_list arguments)
{
    struct diag_text text = { .arena = arena_new(0) };
    diag_vputf(&text, format, arguments);
    if (text.count > 0) {
        fwrite(text.items, 1, text.count, diag->out);
        diag->open = text.items[text.count - 1] != '\n';
    }
    arena_free(text.arena);
}

void diag_vprint(struct diag *diag, enum diag_level level, struct span span,
                 const char *hint, const char *format, va_list arguments)
{
    if (!diag_admit(diag, level))
        return;
    if (diag->listen) {
        diag_tell(diag, level, span, hint, format, arguments);
        return;
    }
    if (level == DIAG_MESSAGE) {
        diag_say(diag, format, arguments);
        return;
    }
    struct diag_text text = { .arena = arena_new(0) };
    if (diag->open)
        diag_put(&text, "\n", 1);
    diag->open = false;
    if (!span.source) {
        diag_putf(&text, "%s: %s", diag->program ? diag->program : "glim",
                  diag_words[level]);
        diag_vputf(&text, format, arguments);
        if (hint)
            diag_putf(&text, " (%s)", hint);
        diag_put(&text, "\n", 1);
    } else {
        struct source_place place = source_locate(span.source, span.offset);
        if (span.offset > span.source->length)
            span.offset = (uint32_t)span.source->length;
        diag_putf(&text, "%s:%u:%u: %s", span.source->name, place.line,
                  place.column, diag_words[level]);
        diag_vputf(&text, format, arguments);
        diag_put(&text, "\n", 1);
        diag_put_excerpt(&text, span, place, hint);
    }
    fwrite(text.items, 1, text.count, diag->out);
    arena_free(text.arena);
}

void diag_print(struct diag *diag, enum diag_level level, struct span span,
                const char *hint, const char *format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    diag_vprint(diag, level, span, hint, format, arguments);
    va_end(arguments);
}
