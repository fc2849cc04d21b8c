/* The skeleton as a file, for other programs. */
#ifndef SKELETON_EXPORT_H
#define SKELETON_EXPORT_H

#include "skeleton/skeleton.h"
#include "text/diag.h"

/* Whether skeleton_save knows a file of this name by its end. */
bool skeleton_can_save(const char *path);

/* Writes the graph with the light of its nodes, in one step: .ply and .obj
 * (ASCII), .csv (a line for each node). Returns false after an error was
 * printed, or when it was stopped. */
bool skeleton_save(const struct skeleton *skeleton, const char *path,
                   struct diag *diag);

#endif
