/* Libraries that are loaded when they are needed: see library.h. */
#include "base/library.h"

#include <dlfcn.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/mman.h>

#define RUNTIME "libstdc++.so.6"

/* Memory or threads ran out where C++ can't tell its caller. */
static void ends_in_distress(void)
{
    fputs("glim: fatal: a library gave up, as they do when memory or threads "
          "run out\n",
          stderr);
    quick_exit(1);
}

/* std::set_terminate: instead of abort(), which would leave half of a file. */
static void end_plainly(void)
{
    typedef void ending(void);
    ending *(*set)(ending *);
    void *runtime = dlopen(RUNTIME, RTLD_LAZY | RTLD_LOCAL);
    void *function =
        runtime ? dlsym(runtime, "_ZSt13set_terminatePFvvE") : NULL;
    if (!function)
        return;
    memcpy(&set, &function, sizeof set);
    set(ends_in_distress);
}

static bool has_room(size_t bytes)
{
    void *room = mmap(NULL, bytes, PROT_NONE,
                      MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0);
    if (room == MAP_FAILED)
        return false;
    munmap(room, bytes);
    return true;
}

void *library_open(const char *name, size_t mebibytes, char *error, size_t size)
{
    void *library = dlopen(name, RTLD_LAZY | RTLD_LOCAL | RTLD_NOLOAD);
    if (library)
        return library;
    if (!has_room(mebibytes << 20)) {
        snprintf(error, size,
                 "it takes %zu MB of memory, more than 'ulimit -v' leaves",
                 mebibytes);
        return NULL;
    }
    end_plainly();
    library = dlopen(name, RTLD_LAZY | RTLD_LOCAL);
    if (!library) {
        const char *why = dlerror();
        snprintf(error, size, "%s", why ? why : "not found");
    }
    return library;
}
