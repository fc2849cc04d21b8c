/* Files that were asked for and how they were then: to see later whether one
 * of them has changed, gone or come. */
#ifndef BASE_FILE_LIST_H
#define BASE_FILE_LIST_H

#include <stdbool.h>
#include <stddef.h>

#include "base/arena.h"

struct file_mark;

struct file_list {
    struct arena *arena; /* of the marks and their names */
    struct file_mark *items;
    size_t count, capacity;
};

/* Marks the file as it is now, there or not; once for each path. To be called
 * before it is read, so that no change is missed. With `list` NULL nothing is
 * done; of more than 10,000 files the rest are not marked. */
void file_list_add(struct file_list *list, const char *path);

/* Whether a file is not as it was when it was marked. */
bool file_list_changed(const struct file_list *list);

#endif
