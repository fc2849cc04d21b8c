/* The stream field: the light at all nodes of the skeleton, for pictures of it
 * and for files. */
#ifndef SKELETON_FIELD_H
#define SKELETON_FIELD_H

#include "skeleton/skeleton.h"

/* Of each node, what reaches a surface that faces the light there; to be freed
 * with memory_free. NULL if it was stopped. The same for any number of threads.
 */
struct skeleton_light *skeleton_field(const struct skeleton *skeleton);

#endif
