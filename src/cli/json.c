/* Lines of JSON: see json.h. Each is written at once, so that those of several
 * processes are not mixed. */
#include "cli/json.h"

#include <ctype.h>
#include <math.h>
#include <stdio.h>
#include <string.h>
#include <sys/resource.h>

#include "base/writer.h"

static void json_text(struct writer *line, const char *text)
{
    writer_add(line, "\"", 1);
    for (; *text; text++) {
        unsigned char c = (unsigned char)*text;
        if (c < 32 || c == 127)
            writer_print(line, "\\u%04x", c);
        else if (c == '"' || c == '\\')
            writer_print(line, "\\%c", c);
        else
            writer_add(line, text, 1);
    }
    writer_add(line, "\"", 1);
}

/* JSON has no infinity, and nothing that is no number. */
static void json_number(struct writer *line, const char *name, double number)
{
    if (isfinite(number))
        writer_print(line, ", \"%s\": %.9g", name, number);
    else
        writer_print(line, ", \"%s\": null", name);
}

static void json_end(struct writer *line)
{
    writer_add(line, "}\n", 2);
    fwrite(line->items, 1, line->count, stderr);
    writer_free(line);
}

static double memory_most(void)
{
    struct rusage usage;
    return getrusage(RUSAGE_SELF, &usage) == 0 ? (double)usage.ru_maxrss : 0;
}

/* lighting_row: adds up what is called "... points". */
static void json_points(void *context, const char *what, double amount,
                        const char *unit)
{
    double *points = context;
    const char *end = strstr(what, " points");
    (void)unit;
    if (end && !end[7])
        *points += amount;
}

static double progress_points(const struct progress *progress)
{
    const struct tracer *tracer = progress->tracer;
    double points = 0;
    if (tracer && tracer->lighting->tell)
        tracer->lighting->tell(tracer->lighting_state, json_points, &points);
    return points;
}

void progress_json(const struct progress *progress, const char *doing,
                   double done, double seconds)
{
    struct writer line = writer_new();
    int samples = atomic_load(&progress->samples);
    writer_print(&line, "{\"picture\": ");
    json_text(&line, progress->name);
    if (progress->frame[0]) {
        writer_print(&line, ", \"frame\": ");
        json_text(&line, progress->frame);
    }
    writer_print(&line, ", \"doing\": \"%s\"", doing);
    json_number(&line, "fraction", done);
    json_number(&line, "seconds", seconds);
    if (done > 0.02)
        json_number(&line, "seconds_left", seconds * (1 - done) / done);
    if (samples > 0)
        json_number(&line, "samples", samples);
    json_number(&line, "points", progress_points(progress));
    json_number(&line, "memory_kib", memory_most());
    json_end(&line);
}

/* "mesh points" and "%" to "mesh_points" and "mesh_points_percent". */
static void json_row(struct writer *line, const char *what, double amount,
                     const char *unit)
{
    char name[2 * STATS_NAME + 32];
    snprintf(name, sizeof name, "%s%s%s", what, unit[0] ? "_" : "",
             strcmp(unit, "%") == 0 ? "percent" : unit);
    for (char *c = name; *c; c++)
        *c =
            isalnum((unsigned char)*c) ? (char)tolower((unsigned char)*c) : '_';
    json_number(line, name, amount);
}

/* Where the unit says all it is the value. */
static void json_word(struct writer *line, const char *what, const char *word)
{
    char name[STATS_NAME];
    snprintf(name, sizeof name, "%s", what);
    for (char *c = name; *c; c++)
        *c =
            isalnum((unsigned char)*c) ? (char)tolower((unsigned char)*c) : '_';
    writer_print(line, ", \"%s\": ", name);
    json_text(line, word);
}

void stats_json(const struct stats *stats)
{
    struct writer line = writer_new();
    writer_print(&line, "{\"shapes\": %zu", stats->leaves);
    json_number(&line, "triangles", (double)stats->triangles);
    json_number(&line, "lights", (double)stats->lights);
    json_number(&line, "camera_rays", (double)stats->rays.camera_rays);
    json_number(&line, "secondary_rays", (double)stats->rays.secondary_rays);
    json_number(&line, "shadow_rays", (double)stats->rays.shadow_rays);
    if (stats->rays.samples) {
        json_number(&line, "samples", stats->rays.samples);
        json_number(&line, "estimated_error", stats->rays.error);
    }
    for (int i = 0; i < stats->row_count; i++)
        if (isnan(stats->rows[i].amount))
            json_word(&line, stats->rows[i].what, stats->rows[i].unit);
        else
            json_row(&line, stats->rows[i].what, stats->rows[i].amount,
                     stats->rows[i].unit);
    writer_print(&line, ", \"seconds\": {\"parsing\": %.6f", stats->parsing);
    json_number(&line, "building", stats->building);
    json_number(&line, "rendering", stats->rendering);
    json_number(&line, "writing", stats->writing);
    writer_add(&line, "}", 1);
    json_number(&line, "memory_kib", memory_most());
    json_end(&line);
}
