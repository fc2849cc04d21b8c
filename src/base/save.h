/* Writing files in one step: a file is either whole or as it was before. */
#ifndef BASE_SAVE_H
#define BASE_SAVE_H

#include <stdbool.h>
#include <stddef.h>

/* Whether save_bytes could put a file at `path`: the directory is there and
 * may be written to. "-" always can. On failure false with the reason in
 * error[size]. */
bool save_possible(const char *path, char *error, size_t size);

/* Writes a new file beside `path` and renames it; what is no regular file is
 * written to, "-" is standard output. On failure returns false with the
 * reason, leaves no new file and an older one as it was. */
bool save_bytes(const char *path, const void *bytes, size_t count, char *error,
                size_t size);

/* The same of a file whose bytes are not there at once. What is no regular file
 * is kept in memory until save_finish. */
struct save;

/* NULL with the reason. Ended by save_finish. */
struct save *save_start(const char *path, char *error, size_t size);

/* More bytes; bytes in place of others that were put before. False with the
 * reason. */
bool save_put(struct save *save, const void *bytes, size_t count, char *error,
              size_t size);
bool save_patch(struct save *save, size_t at, const void *bytes, size_t count,
                char *error, size_t size);

/* With `keep` the file is put in its place, else as it was. */
bool save_finish(struct save *save, bool keep, char *error, size_t size);

#endif
