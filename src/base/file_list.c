/* Marked files: see file_list.h. */
#include "base/file_list.h"

#include <fcntl.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "base/array.h"
#include "base/hash.h"

enum { FILE_LIST_LIMIT = 10000, FILE_CHUNK = 1 << 15 };

/* Editors write a new file and rename it: then the number is another. */
struct file_mark {
    const char *path;
    bool there, plain; /* plain: a regular file */
    bool hashed, readable;
    bool stale;     /* it has changed from one round to the next */
    unsigned round; /* in which it was asked for last */
    uint64_t hash;
    off_t size;
    ino_t number;
    struct timespec changed;
};

static struct file_mark file_mark(const char *path)
{
    struct stat status;
    struct file_mark mark = { .path = path };
    mark.there = stat(path, &status) == 0;
    if (mark.there) {
        mark.plain = S_ISREG(status.st_mode);
        mark.size = status.st_size;
        mark.number = status.st_ino;
        mark.changed = status.st_mtim;
    }
    return mark;
}

size_t file_list_find(const struct file_list *list, const char *path)
{
    for (size_t i = 0; i < list->count; i++)
        if (strcmp(list->items[i].path, path) == 0)
            return i;
    return list->count;
}

static bool marks_differ(const struct file_mark *a, const struct file_mark *b)
{
    return a->there != b->there || a->size != b->size ||
           a->number != b->number || a->changed.tv_sec != b->changed.tv_sec ||
           a->changed.tv_nsec != b->changed.tv_nsec;
}

static bool mark_changed(const struct file_mark *old)
{
    const struct file_mark now = file_mark(old->path);
    return marks_differ(&now, old);
}

static void mark_renew(struct file_mark *mark, unsigned round)
{
    if (mark->round != round && mark_changed(mark)) {
        *mark = file_mark(mark->path);
        mark->stale = true;
    }
    mark->round = round;
}

/* Adds another list's mark, or if it is of the same file puts it in the place
 * of the one that is there. */
static void mark_take(struct file_list *list, const struct file_mark *other)
{
    const size_t index = file_list_find(list, other->path);
    const bool known = index < list->count;
    if (!known && list->count >= FILE_LIST_LIMIT)
        return;
    struct file_mark *mark =
        known ? &list->items[index] : ARRAY_PUSH(list->arena, list);
    const char *path =
        known ? mark->path
              : arena_copy_text(list->arena, other->path, strlen(other->path));
    if (!known || marks_differ(mark, other)) {
        *mark = *other;
        mark->path = path;
        mark->stale |= known;
    }
    mark->round = list->round;
}

void file_list_add(struct file_list *list, const char *path)
{
    if (!list)
        return;
    size_t index = file_list_find(list, path);
    if (index < list->count) {
        mark_renew(&list->items[index], list->round);
        return;
    }
    const struct file_mark mark = file_mark(path);
    mark_take(list, &mark);
}

void file_list_take(struct file_list *list, const struct file_list *other)
{
    for (size_t i = 0; list && i < other->count; i++)
        mark_take(list, &other->items[i]);
}

void file_list_next(struct file_list *list)
{
    list->round++;
}

bool file_list_asked(const struct file_list *list, size_t index)
{
    return list->items[index].round == list->round;
}

bool file_list_changed(const struct file_list *list)
{
    for (size_t i = 0; i < list->count; i++)
        if (list->items[i].stale || mark_changed(&list->items[i]))
            return true;
    return false;
}

const char *file_list_path(const struct file_list *list, size_t index)
{
    return list->items[index].path;
}

bool file_list_there(const struct file_list *list, size_t index)
{
    return list->items[index].there;
}

/* All that is in the file; never 0. */
static bool mark_read(const char *path, uint64_t *hash)
{
    int file = open(path, O_RDONLY | O_CLOEXEC);
    if (file < 0)
        return false;
    char chunk[FILE_CHUNK];
    ssize_t count;
    size_t have = 0;
    *hash = 1;
    while ((count = read(file, chunk + have, FILE_CHUNK - have)) > 0) {
        have += (size_t)count;
        if (have < FILE_CHUNK)
            continue;
        *hash = hash_bytes(*hash, chunk, have);
        have = 0;
    }
    *hash = hash_bytes(*hash, chunk, have) | 1;
    close(file);
    return count == 0;
}

bool file_list_hash(const struct file_list *list, size_t index, uint64_t *hash)
{
    struct file_mark *mark = &list->items[index];
    if (!mark->hashed) {
        mark->hashed = true;
        mark->readable = true;
        mark->hash = mark->there;
        if (mark->plain)
            mark->readable =
                mark_read(mark->path, &mark->hash) && !mark_changed(mark);
    }
    *hash = mark->hash;
    return mark->readable;
}
