/* Writing files so that one is either whole or not there: see save.h. */
#include "base/save.h"

#include <errno.h>
#include <fcntl.h>
#include <limits.h>
#include <stdatomic.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "base/directory.h"
#include "base/memory.h"

enum { SAVE_BUFFER = 1 << 18 }; /* bytes */

enum { LINKS_MOST = 40 }; /* behind each other; what Linux follows */

/* Puts in place of a link's path that of what it names. */
static bool save_follow(char target[PATH_MAX], const char *named)
{
    char *slash = strrchr(target, '/');
    size_t folder = named[0] != '/' && slash ? (size_t)(slash + 1 - target) : 0;
    if (folder + strlen(named) >= PATH_MAX) {
        errno = ENAMETOOLONG;
        return false;
    }
    strcpy(target + folder, named);
    return true;
}

/* What a name stands for once symbolic links are followed, so that a link
 * keeps its place and the file it names is the one replaced, or made. Of a pipe
 * (/dev/stdout) the link tells no path. */
static bool save_resolve(const char *path, char target[PATH_MAX], char *error,
                         size_t size)
{
    char named[PATH_MAX];
    ssize_t length;
    target[0] = '\0';
    bool good = save_follow(target, path);
    if (good && path_is_special(target))
        return true;
    for (int i = 0; good; i++) {
        length = readlink(target, named, sizeof named - 1);
        if (length < 0)
            return true; /* no link; whether it is there is asked elsewhere */
        named[length] = '\0';
        errno = ELOOP;
        good = i < LINKS_MOST && save_follow(target, named);
    }
    snprintf(error, size, "%s", strerror(errno));
    return false;
}

bool save_possible(const char *path, char *error, size_t size)
{
    if (strcmp(path, "-") == 0)
        return true;
    if (path_is_directory(path)) {
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
    if (!path_is_special(target)) {
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

struct save {
    char target[PATH_MAX];
    char *name; /* of the new file */
    int file;
    bool special;
    char *bytes; /* not yet written */
    size_t count, capacity;
};

/* ---- new files that are not finished ---- */

enum { UNFINISHED_MOST = 64 }; /* at once; of more nothing is known */

/* Their names. Who takes one out of here has it to himself. */
static _Atomic(char *) unfinished[UNFINISHED_MOST];

/* At the end of a program that ran out of memory: see memory.h, library.h. */
static void unfinished_remove(void)
{
    for (int i = 0; i < UNFINISHED_MOST; i++) {
        const char *name = atomic_exchange(&unfinished[i], NULL);
        if (name)
            unlink(name);
    }
}

static void unfinished_add(char *name)
{
    static atomic_flag registered = ATOMIC_FLAG_INIT;
    if (!atomic_flag_test_and_set(&registered)) {
        atexit(unfinished_remove);
        at_quick_exit(unfinished_remove);
    }
    for (int i = 0; i < UNFINISHED_MOST; i++) {
        char *none = NULL;
        if (atomic_compare_exchange_strong(&unfinished[i], &none, name))
            return;
    }
}

/* Once the file is finished; false: the name may be in use. */
static bool unfinished_drop(char *name)
{
    for (int i = 0; i < UNFINISHED_MOST; i++) {
        char *same = name;
        if (atomic_compare_exchange_strong(&unfinished[i], &same, NULL))
            return true;
    }
    return false;
}

static bool save_fail(char *error, size_t size)
{
    snprintf(error, size, "%s", strerror(errno));
    return false;
}

/* A new file beside the target. */
static bool save_start_new(struct save *save, char *error, size_t size)
{
    size_t length = strlen(save->target) + 40;
    save->name = memory_new(length);
    snprintf(save->name, length, "%s.%ld.tmp", save->target, (long)getpid());
    save->file = save_create(save->name, save->target);
    if (save->file < 0)
        return save_fail(error, size);
    unfinished_add(save->name);
    return true;
}

static void save_free(struct save *save)
{
    if (save->name && (save->file < 0 || unfinished_drop(save->name)))
        memory_free(save->name);
    memory_free(save->bytes);
    memory_free(save);
}

struct save *save_start(const char *path, char *error, size_t size)
{
    struct save *save = memory_new(sizeof *save);
    bool standard = strcmp(path, "-") == 0, good = true;
    if (standard)
        strcpy(save->target, path);
    else
        good = save_resolve(path, save->target, error, size);
    save->special = standard || (good && path_is_special(save->target));
    if (good && !save->special)
        good = save_start_new(save, error, size);
    if (good)
        return save;
    save_free(save);
    return NULL;
}

/* Many small writes are slow. */
static bool save_flush(struct save *save, char *error, size_t size)
{
    bool done = save_put_all(save->file, save->bytes, save->count);
    save->count = 0;
    return done || save_fail(error, size);
}

bool save_put(struct save *save, const void *bytes, size_t count, char *error,
              size_t size)
{
    if (count > save->capacity - save->count) {
        save->capacity = 2 * save->capacity + count;
        save->bytes = memory_resize(save->bytes, save->capacity);
    }
    memcpy(save->bytes + save->count, bytes, count);
    save->count += count;
    return save->special || save->count < SAVE_BUFFER ||
           save_flush(save, error, size);
}

bool save_patch(struct save *save, size_t at, const void *bytes, size_t count,
                char *error, size_t size)
{
    if (save->special) {
        memcpy(save->bytes + at, bytes, count);
        return true;
    }
    if (!save_flush(save, error, size))
        return false;
    const char *next = bytes;
    while (count > 0) {
        ssize_t written = pwrite(save->file, next, count, (off_t)at);
        if (written < 0 && errno != EINTR)
            return save_fail(error, size);
        if (written > 0) {
            next += written;
            at += (size_t)written;
            count -= (size_t)written;
        }
    }
    return true;
}

bool save_finish(struct save *save, bool keep, char *error, size_t size)
{
    bool done = true;
    if (save->special) {
        done = !keep || save_put_device(save->target, save->bytes, save->count,
                                        error, size);
    } else {
        done = !keep || save_flush(save, error, size);
        if (close(save->file) != 0 && done && keep)
            done = save_fail(error, size);
        if (done && keep && rename(save->name, save->target) != 0)
            done = save_fail(error, size);
        if (!done || !keep)
            unlink(save->name);
    }
    save_free(save);
    return done;
}

bool save_bytes(const char *path, const void *bytes, size_t count, char *error,
                size_t size)
{
    struct save *save = save_start(path, error, size);
    if (!save)
        return false;
    bool put = save_put(save, bytes, count, error, size);
    char more[1];
    return save_finish(save, put, put ? error : more,
                       put ? size : sizeof more) &&
           put;
}
