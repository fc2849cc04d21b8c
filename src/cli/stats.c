/* --stats: see stats.h. */
#include "cli/stats.h"

#include <math.h>
#include <stdio.h>

#include "base/clock.h"

struct stats stats_start(void)
{
    return (struct stats){ .lap = clock_seconds() };
}

void stats_lap(struct stats *stats, double *lap)
{
    double now = clock_seconds();
    *lap = now - stats->lap;
    stats->lap = now;
}

void stats_world(struct stats *stats, const struct world *world)
{
    stats->leaves = world_leaf_count(world);
    stats->triangles = world_triangle_count(world);
    world_lights(world, &stats->lights);
    stats_lap(stats, &stats->building);
}

static void stats_count(const char *what, unsigned long long count)
{
    fprintf(stderr, "%-16s %12llu\n", what, count);
}

static void stats_row(void *context, const char *what, double amount,
                      const char *unit)
{
    struct stats *stats = context;
    if (stats->row_count == STATS_ROWS)
        return;
    snprintf(stats->rows[stats->row_count].what, STATS_NAME, "%s", what);
    stats->rows[stats->row_count].amount = amount;
    stats->rows[stats->row_count++].unit = unit;
}

void stats_lighting(struct stats *stats, const struct tracer *tracer)
{
    stats->row_count = 0;
    if (tracer->lighting->tell)
        tracer->lighting->tell(tracer->lighting_state, stats_row, stats);
}

void stats_keeper(struct stats *stats, const struct keeper *keeper)
{
    double worked = 1e-9 * (double)atomic_load(&keeper->nanoseconds);
    if (worked > 0)
        stats_row(stats, "part file", worked, "s of all threads");
}

static void stats_time(const char *what, double seconds)
{
    fprintf(stderr, "%-16s %12.3f s\n", what, seconds);
}

static void stats_amount(const char *what, double amount, const char *unit)
{
    if (isnan(amount))
        fprintf(stderr, "%-16s %s\n", what, unit);
    else
        fprintf(stderr, "%-16s %12.*f%s%s\n", what, unit[0] ? 3 : 0, amount,
                unit[0] ? " " : "", unit);
}

void stats_print(const struct stats *stats)
{
    stats_count("shapes", stats->leaves);
    stats_count("triangles", stats->triangles);
    stats_count("lights", stats->lights);
    stats_count("camera rays", stats->rays.camera_rays);
    stats_count("secondary rays", stats->rays.secondary_rays);
    stats_count("shadow rays", stats->rays.shadow_rays);
    if (stats->rays.samples) {
        stats_count("samples", (unsigned long long)stats->rays.samples);
        fprintf(stderr, "%-16s %12.4f %%\n", "estimated error",
                100 * stats->rays.error);
    }
    for (int i = 0; i < stats->row_count; i++)
        stats_amount(stats->rows[i].what, stats->rows[i].amount,
                     stats->rows[i].unit);
    stats_time("parsing", stats->parsing);
    stats_time("building", stats->building);
    stats_time("rendering", stats->rendering);
    stats_time("writing", stats->writing);
}
