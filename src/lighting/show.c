/* Points and lines to be shown: see show.h. */
#include "lighting/show.h"

struct show show_new(void)
{
    return (struct show){ .arena = arena_new(0), .what = "" };
}

void show_free(struct show *show)
{
    arena_free(show->arena);
}
