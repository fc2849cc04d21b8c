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

__attribute__((format(printf, 2, 3))) static void
diag_putf(struct diag_text *text, const char *format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    char small[512];
    int length = vsnprintf(small, sizeof small, format, arguments);
    va_end(arguments);
    if (length >= (int)sizeof small)
        length = (int)sizeof small - 1;
    diag_put(text, small, (size_t)length);
}

/* Tabs advance to multiples of 8, other control bytes and broken UTF-8 print
 * as '?': one column each, so the carets stay under what they mark. */
static unsigned diag_put_source(struct diag_text *text, const char *line,
                                size_t length, unsigned column)
{
    for (size_t i = 0; i < length; i++) {
        unsigned char c = (unsigned char)line[i];
        if (c == '\t') {
            unsigned stop = (column / 8 + 1) * 8;
            for (; column < stop; column++)
                diag_put(text, " ", 1);
            continue;
        }
        if (c < 32 || c == 127)
            diag_put(text, "?", 1);
        else
            diag_put(text, line + i, 1);
        if ((c & 0xc0) != 0x80)
            column++;
    }
    return column;
}

static unsigned diag_width(const char *line, size_t length, unsigned column)
{
    for (size_t i = 0; i < length; i++) {
        unsigned char c = (unsigned char)line[i];
        if (c == '\t')
            column = (column / 8 + 1) * 8;
        else if ((c & 0xc0) != 0x80)
            column++;
    }
    return column;
}

/* Long lines (generated meshes) are cut to a window around the span. */
enum { DIAG_WINDOW = 160 };

static void diag_put_excerpt(struct diag_text *text, struct span span,
                             struct source_place place, const char *hint)
{
    const char *source = span.source->text;
    size_t start = place.line_start, end = place.line_end;
    if (span.offset - start > DIAG_WINDOW / 2 && end - start > DIAG_WINDOW) {
        start = span.offset - DIAG_WINDOW / 2;
        while (((unsigned char)source[start] & 0xc0) == 0x80)
            start++;
    }
    if (end - start > DIAG_WINDOW) {
        end = start + DIAG_WINDOW;
        while (((unsigned char)source[end] & 0xc0) == 0x80)
            end--;
    }
    diag_putf(text, "%5u | ", place.line);
    diag_put_source(text, source + start, end - start, 0);
    unsigned caret = diag_width(source + start, span.offset - start, 0);
    size_t length = span.length;
    if (span.offset + length > end)
        length = end > span.offset ? end - span.offset : 0;
    unsigned stop = diag_width(source + span.offset, length, caret);
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
        diag->warnings++;
        diag->muted = diag->quiet_warnings;
    } else if (level == DIAG_MESSAGE)
        return diag->out && !diag->quiet_messages;
    return diag->out && !diag->muted;
}

struct diag diag_new(void)
{
    return (struct diag){ .out = stderr };
}

void diag_vprint(struct diag *diag, enum diag_level level, struct span span,
                 const char *hint, const char *format, va_list arguments)
{
    if (!diag_admit(diag, level))
        return;
    char message[1024];
    vsnprintf(message, sizeof message, format, arguments);
    if (level == DIAG_MESSAGE) {
        fputs(message, diag->out);
        return;
    }
    struct diag_text text = { .arena = arena_new(0) };
    if (!span.source) {
        diag_putf(&text, "glim: %s", diag_words[level]);
        diag_put(&text, message, strlen(message));
        if (hint)
            diag_putf(&text, " (%s)", hint);
        diag_put(&text, "\n", 1);
    } else {
        struct source_place place = source_locate(span.source, span.offset);
        if (span.offset > span.source->length)
            span.offset = (uint32_t)span.source->length;
        diag_putf(&text, "%s:%u:%u: %s", span.source->name, place.line,
                  place.column, diag_words[level]);
        diag_put(&text, message, strlen(message));
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

void diag_include_trace(struct diag *diag, struct span span)
{
    while (span.source && span.source->included_from.source) {
        span = span.source->included_from;
        diag_print(diag, DIAG_NOTE, span, NULL, "included from here");
    }
}
