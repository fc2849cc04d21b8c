/* Embree's library, loaded when it is needed: see rtcore.h. */
#include "world/rtcore.h"

#include <dlfcn.h>
#include <stdio.h>
#include <string.h>

#include "base/library.h"
#include "base/parallel.h"

#define TEXT_OF(number) #number
#define LIBRARY(number) "libembree" TEXT_OF(number) ".so." TEXT_OF(number)

struct embree embree;

static char failure[256]; /* empty: none */

enum { EMBREE_TAKES = 160 }; /* MB, without its scene */

/* The library stays loaded. */
static void load(void)
{
    void *library = library_open(LIBRARY(GLIM_EMBREE), EMBREE_TAKES, failure,
                                 sizeof failure);
    void *function;
    if (!library)
        return;
#define X(name)                                                                \
    function = dlsym(library, "rtc" #name);                                    \
    if (!function)                                                             \
        snprintf(failure, sizeof failure, "it has no rtc" #name);              \
    memcpy(&embree.name, &function, sizeof function);
    EMBREE_FUNCTIONS(X)
#undef X
}

const char *embree_load(void)
{
    static struct once once;
    once_only(&once, load);
    return *failure ? failure : NULL;
}
