/* Files that were asked for and how they were then: to see later whether one
 * of them has changed, gone or come. */
#ifndef BASE_FILE_LIST_H
#define BASE_FILE_LIST_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "base/arena.h"

struct file_mark;

struct file_list {
    struct arena *arena; /* of the marks and their names */
    struct file_mark *items;
    size_t count, capacity;
    unsigned round; /* file_list_next has been called so often */
};

/* Marks the file as it is now, there or not; once for each path. To be called
 * before it is read, so that no change is missed. With `list` NULL nothing is
 * done; of more than 10,000 files the rest are not marked. */
void file_list_add(struct file_list *list, const char *path);

/* The same for all that another list has been asked for, marked as they were
 * then. */
void file_list_take(struct file_list *list, const struct file_list *other);

/* From now on files are asked for anew, as for the next frame of an animation:
 * those that have changed since are marked again. */
void file_list_next(struct file_list *list);

/* Whether the index-th was asked for since then. */
bool file_list_asked(const struct file_list *list, size_t index);

/* Whether a file is not as it was when it was first marked. */
bool file_list_changed(const struct file_list *list);

/* Of the index-th: its name as it was asked for, and whether it was there. */
const char *file_list_path(const struct file_list *list, size_t index);
bool file_list_there(const struct file_list *list, size_t index);

/* What is in it, as a hash that is worked out once; 0 if it was not there. Of a
 * file that has changed since it was marked, or can't be read, false. What is
 * no regular file is not read, and always the same. */
bool file_list_hash(const struct file_list *list, size_t index, uint64_t *hash);

/* The index of a path that is marked, or the list's count. */
size_t file_list_find(const struct file_list *list, const char *path);

#endif
