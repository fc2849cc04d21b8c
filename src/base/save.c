/* Writing files so that one is either whole or not there: see save.h. */
#include "base/save.h"

#include <errno.h>
#include <fcntl.h>
#include <limits.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "base/memory.h"

/* What a name stands for once symbolic links are followed, so that a link
 * keeps its place and the file it names is the one replaced. */
static bool save_resolve(const char *path, char target[PATH_MAX], char *error,
                         size_t size)
{
    if (realpath(path, target))
        return true;
    if (strlen(path) >= PATH_MAX) {
        snprintf(error, size, "%s", strerror(ENAMETOOLONG));
        return false;
    }
    strcpy(target, path);
    return true;
}

/* Devices and pipes (/dev/null, /dev/stdout) are written to, not replaced. */
static bool save_is_special(const char *path)
{
    struct stat status;
    return stat(path, &status) == 0 && !S_ISREG(status.st_mode);
}

bool save_possible(const char *path, char *error, size_t size)
{
    if (strcmp(path, "-") == 0)
        return true;
    struct stat status;
    if (stat(path, &status) == 0 && S_ISDIR(status.st_mode)) {
        snprintf(error, size, "it is a directory");
        return false;
    }
    char target[PATH_MAX];
    if (!save_resolve(path, target, error, size))
        return false;
    /* Renaming could replace a file that is write-protected, but shouldn't. */
    if (access(target, W_OK) != 0 && errno != ENOENT && errno != ENOTDIR) {
        snprintf(error, size, "%s", strerror(errno));
        return false;
    }
    if (!save_is_special(target)) {
        char *slash = strrchr(target, '/');
        if (slash)
            slash[slash == target] = '\0';
        else
            strcpy(target, ".");
    }
    if (access(target, W_OK) == 0)
        return true;
    if (errno == ENOENT)
        snprintf(error, size, "there is no directory '%s'", target);
    else
        snprintf(error, size, "%s: %s", target, strerror(errno));
    return false;
}

static bool save_put_all(int file, const void *bytes, size_t count)
{
    const char *next = bytes;
    while (count > 0) {
        ssize_t written = write(file, next, count);
        if (written < 0 && errno != EINTR)
            return false;
        if (written > 0) {
            next += written;
            count -= (size_t)written;
        }
    }
    return true;
}

/* A new file called `name` with the permissions of `target`, if that exists.
 * A file of that name can only be left over from a process that was killed. */
static int save_create(const char *name, const char *target)
{
    unlink(name);
    int file = open(name, O_WRONLY | O_CREAT | O_EXCL, 0666);
    struct stat status;
    if (file >= 0 && stat(target, &status) == 0)
        fchmod(file, status.st_mode & 07777);
    return file;
}

/* A new file beside it, then renamed. */
static bool save_put_new(const char *target, const void *bytes, size_t count,
                         char *error, size_t size)
{
    size_t length = strlen(target) + 40;
    char *name = memory_new(length);
    snprintf(name, length, "%s.%ld.tmp", target, (long)getpid());
    int file = save_create(name, target);
    bool done = file >= 0 && save_put_all(file, bytes, count);
    int reason = errno;
    if (file >= 0 && close(file) != 0 && done) {
        done = false;
        reason = errno;
    }
    if (done && rename(name, target) != 0) {
        done = false;
        reason = errno;
    }
    if (!done) {
        snprintf(error, size, "%s", strerror(reason));
        if (file >= 0)
            unlink(name);
    }
    memory_free(name);
    return done;
}

static bool save_put_device(const char *target, const void *bytes, size_t count,
                            char *error, size_t size)
{
    bool standard = strcmp(target, "-") == 0;
    int file = standard ? STDOUT_FILENO : open(target, O_WRONLY);
    bool done = file >= 0 && save_put_all(file, bytes, count);
    int reason = errno;
    if (file >= 0 && !standard && close(file) != 0 && done) {
        done = false;
        reason = errno;
    }
    if (!done)
        snprintf(error, size, "%s", strerror(reason));
    return done;
}

bool save_bytes(const char *path, const void *bytes, size_t count, char *error,
                size_t size)
{
    char target[PATH_MAX];
    if (strcmp(path, "-") == 0)
        return save_put_device(path, bytes, count, error, size);
    if (!save_resolve(path, target, error, size))
        return false;
    return (save_is_special(target) ? save_put_device : save_put_new)(
        target, bytes, count, error, size);
}
