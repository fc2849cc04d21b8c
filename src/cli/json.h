/* Reports for programs: a line of JSON (RFC 8259) each, on standard error. */
#ifndef CLI_JSON_H
#define CLI_JSON_H

#include "cli/progress.h"
#include "cli/stats.h"

/* {"picture": "a.png", "frame": "frame 3 of 40", "doing": "drawing",
 * "fraction": 0.5, "seconds": 2, "seconds_left": 2, "samples": 16,
 * "points": 1200, "memory_kib": 53000}: frame only of animations, samples only
 * of whole paths, seconds_left once it can be told. Points are those of light
 * meshes. */
void progress_json(const struct progress *progress, const char *doing,
                   double done, double seconds);

/* What stats_print prints: {"shapes": 3, ..., "seconds": {"parsing": 0.01,
 * ...}}; names in small letters, with _ for what is none, and a number's unit,
 * where it has one, behind it. */
void stats_json(const struct stats *stats);

#endif
