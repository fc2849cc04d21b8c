/* Directories among paths. */
#ifndef BASE_DIRECTORY_H
#define BASE_DIRECTORY_H

#include <stdbool.h>
#include <sys/stat.h>

/* False also where there is nothing, or nothing that may be looked at. */
static inline bool path_is_directory(const char *path)
{
    struct stat status;
    return stat(path, &status) == 0 && S_ISDIR(status.st_mode);
}

#endif
