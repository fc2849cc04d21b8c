/* Embree's library, loaded when it is needed: see rtcore.h. */
#include "world/rtcore.h"

#include <dlfcn.h>
#include <stdio.h>
#include <string.h>

#include "base/parallel.h"

#define TEXT_OF(number) #number
#define LIBRARY(number) "libembree" TEXT_OF(number) ".so." TEXT_OF(number)

struct embree embree;

static char failure[256]; /* empty: none */

static void failed(void)
{
    const char *why = dlerror();
    snprintf(failure, sizeof failure, "%s", why ? why : "not found");
}

/* The library stays loaded. */
static void load(void)
{
    void *library = dlopen(LIBRARY(GLIM_EMBREE), RTLD_LAZY | RTLD_LOCAL);
    void *function;
    if (!library) {
        failed();
        return;
    }
#define X(name)                                                                \
    function = dlsym(library, "rtc" #name);                                    \
    if (!function)                                                             \
        failed();                                                              \
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
