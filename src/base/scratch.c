/* mkdtemp, and away with it: see scratch.h. */
#include "base/scratch.h"

#include <dirent.h>
#include <stdlib.h>
#include <unistd.h>

const char *scratch_make(const char *name, struct arena *arena,
                         const char **tried)
{
    const char *base = getenv("TMPDIR");
    char *path = arena_printf(arena, "%s/%s-XXXXXX",
                              base && *base ? base : "/tmp", name);
    if (tried)
        *tried = path;
    return mkdtemp(path);
}

void scratch_remove(const char *path)
{
    DIR *directory = path ? opendir(path) : NULL;
    if (!directory)
        return;
    for (struct dirent *entry = readdir(directory); entry;
         entry = readdir(directory))
        unlinkat(dirfd(directory), entry->d_name, 0);
    closedir(directory);
    rmdir(path);
}
