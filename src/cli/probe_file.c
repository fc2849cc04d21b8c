/* Points of --probe, and their table: see probe_file.h. */
#include "cli/probe_file.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/text.h"
#include "base/writer.h"

/* Beyond it nothing is hit (world/world.h). */
#define PLACE_LIMIT 1e7

/* One line of the file. */
struct line {
    struct probe_file *points;
    struct arena *arena;
    struct diag *diag;
    size_t next, end; /* what is left of it, comment and blanks cut off */
    double numbers[6];
    int count;
    bool bad;
};

static const char *line_text(const struct line *line)
{
    return line->points->source->text + line->next;
}

__attribute__((format(printf, 3, 4))) static void
line_fail(struct line *line, size_t length, const char *format, ...)
{
    char message[200];
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(message, sizeof message, format, arguments);
    va_end(arguments);
    struct span span = { line->points->source, (uint32_t)line->next,
                         (uint32_t)length };
    diag_print(line->diag, DIAG_ERROR, span, NULL, "%s", message);
    line->bad = true;
}

static bool line_is_blank(char c)
{
    return c == ' ' || c == '\t' || c == ',';
}

static void line_skip_blanks(struct line *line)
{
    while (line->next < line->end && line_is_blank(*line_text(line)))
        line->next++;
}

static size_t line_word(const struct line *line)
{
    size_t length = 0;
    while (line->next + length < line->end &&
           !line_is_blank(line_text(line)[length]))
        length++;
    return length;
}

/* Takes the next word if it is a number, which must be one if it looks like
 * one or if there are not three yet. */
static bool line_number(struct line *line)
{
    char word[64] = "", *end;
    line_skip_blanks(line);
    size_t length = line_word(line);
    if (length == 0)
        return false;
    bool alike = strchr("0123456789+-.", *line_text(line));
    if (!alike && line->count >= 3)
        return false;
    if (length < sizeof word)
        memcpy(word, line_text(line), length);
    double number = strtod(word, &end);
    if (!*word || *end || strspn(word, "0123456789+-.eE") != length)
        line_fail(line, length, "expected a number, found '%.*s'",
                  length > 40 ? 40 : (int)length, line_text(line));
    else if (!(fabs(number) <= PLACE_LIMIT))
        line_fail(line, length, "%s is too far: glim sees up to %s units", word,
                  NUMBER_TEXT(PLACE_LIMIT));
    if (line->bad)
        return false;
    line->numbers[line->count++] = number;
    line->next += length;
    return true;
}

static void line_check(struct line *line)
{
    const double *n = line->numbers;
    if (line->bad)
        return;
    if (line->count != 3 && line->count != 6)
        line_fail(line, 0,
                  "expected x y z, or x y z and the normal nx ny nz; found %d "
                  "number%s",
                  line->count, line->count == 1 ? "" : "s");
    else if (line->count == 6 && n[3] == 0 && n[4] == 0 && n[5] == 0)
        line_fail(line, 0,
                  "the normal is zero: leave it out for the scalar light "
                  "field");
}

static void line_keep(struct line *line)
{
    const double *n = line->numbers;
    struct probe_file *points = line->points;
    if (points->at.count == PROBE_POINTS_LIMIT) {
        line_fail(line, 0, "more than %d points, glim's limit",
                  PROBE_POINTS_LIMIT);
        return;
    }
    *ARRAY_PUSH(line->arena, &points->at) = (struct probe_point){
        .place = vec3_make(n[0], n[1], n[2]),
        .normal = vec3_make(n[3], n[4], n[5]),
        .directed = line->count == 6,
    };
    *ARRAY_PUSH(line->arena, &points->labels) =
        (struct probe_label){ (uint32_t)line->next,
                              (uint32_t)(line->end - line->next) };
}

static void line_read(struct line *line)
{
    line_skip_blanks(line);
    if (line->next == line->end)
        return;
    while (line->count < 6 && line_number(line))
        continue;
    line_check(line);
    line_skip_blanks(line);
    if (!line->bad)
        line_keep(line);
}

/* The end of the line's own text: before a comment and blanks. */
static size_t line_trim(const char *text, size_t start, size_t end)
{
    const char *comment = memchr(text + start, '#', end - start);
    if (comment)
        end = (size_t)(comment - text);
    while (end > start && line_is_blank(text[end - 1]))
        end--;
    return end;
}

static void probe_file_lines(struct probe_file *points, struct arena *arena,
                             struct diag *diag)
{
    const char *text = points->source->text;
    unsigned limit = diag->errors + DIAG_ERROR_LIMIT;
    for (size_t i = 0; i < points->source->length;) {
        size_t end = i + strcspn(text + i, "\r\n");
        struct line line = { .points = points,
                             .arena = arena,
                             .diag = diag,
                             .next = i,
                             .end = line_trim(text, i, end) };
        line_read(&line);
        if (diag->errors >= limit) {
            diag_print(diag, DIAG_NOTE, span_none(), NULL,
                       "%d errors are enough; the rest is not read",
                       DIAG_ERROR_LIMIT);
            return;
        }
        if (points->at.count == PROBE_POINTS_LIMIT && line.bad)
            return;
        i = end + 1;
    }
}

bool probe_file_read(struct probe_file *points, const char *path,
                     struct arena *arena, struct diag *diag)
{
    const char *problem = NULL;
    unsigned errors = diag->errors;
    *points = (struct probe_file){ .source = source_read(
                                       arena, path, span_none(), &problem) };
    if (!points->source)
        diag_print(diag, DIAG_ERROR, span_none(), NULL,
                   "can't read the points '%s': %s", path, problem);
    else if (memchr(points->source->text, '\0', points->source->length))
        diag_print(diag, DIAG_ERROR, span_none(), NULL,
                   "'%s' is not a text: it has a NUL byte", path);
    else
        probe_file_lines(points, arena, diag);
    if (diag->errors == errors && points->at.count == 0)
        diag_print(diag, DIAG_ERROR, span_none(), NULL,
                   "'%s' has no points: lines x y z nx ny nz", path);
    return diag->errors == errors;
}

/* ---- the table ---- */

static void table_numbers(struct writer *table, vec3 numbers, int digits)
{
    writer_print(table, "%.*g %.*g %.*g", digits, numbers.x, digits, numbers.y,
                 digits, numbers.z);
}

bool probe_file_write(const struct probe_file *points,
                      const struct probe_light *light, const char *name,
                      struct diag *diag)
{
    struct writer table = writer_new();
    char why[256];
    for (size_t i = 0; i < points->at.count; i++) {
        const struct probe_point *at = &points->at.items[i];
        struct probe_label label = points->labels.items[i];
        rgb c = light[i].colour;
        table_numbers(&table, at->place, 10);
        writer_add(&table, " ", 1);
        if (at->directed) {
            table_numbers(&table, at->normal, 10);
            writer_add(&table, " ", 1);
        }
        table_numbers(&table, vec3_make(c.r, c.g, c.b), 9);
        if (light[i].streams) {
            writer_add(&table, " ", 1);
            table_numbers(&table, light[i].stream, 9);
        }
        writer_add(&table, " ", label.length ? 1 : 0);
        writer_add(&table, points->source->text + label.offset, label.length);
        writer_add(&table, "\n", 1);
    }
    bool done = writer_save(&table, name, why, sizeof why);
    if (!done)
        diag_print(diag, DIAG_ERROR, span_none(), NULL,
                   strcmp(name, "-") == 0
                       ? "can't write standard output: %.0s%s"
                       : "can't write '%s': %s",
                   name, why);
    writer_free(&table);
    return done;
}
