/* Marked files: see file_list.h. */
#include "base/file_list.h"

#include <string.h>
#include <sys/stat.h>

#include "base/array.h"

enum { FILE_LIST_LIMIT = 10000 };

/* Editors write a new file and rename it: then the number is another. */
struct file_mark {
    const char *path;
    bool there;
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
        mark.size = status.st_size;
        mark.number = status.st_ino;
        mark.changed = status.st_mtim;
    }
    return mark;
}

void file_list_add(struct file_list *list, const char *path)
{
    if (!list || list->count >= FILE_LIST_LIMIT)
        return;
    for (size_t i = 0; i < list->count; i++)
        if (strcmp(list->items[i].path, path) == 0)
            return;
    path = arena_copy_text(list->arena, path, strlen(path));
    *ARRAY_PUSH(list->arena, list) = file_mark(path);
}

bool file_list_changed(const struct file_list *list)
{
    for (size_t i = 0; i < list->count; i++) {
        const struct file_mark *old = &list->items[i];
        struct file_mark now = file_mark(old->path);
        if (now.there != old->there || now.size != old->size ||
            now.number != old->number ||
            now.changed.tv_sec != old->changed.tv_sec ||
            now.changed.tv_nsec != old->changed.tv_nsec)
            return true;
    }
    return false;
}
