/* Pictures that are not finished, as files: a journal of tiles, each with a
 * checksum, in the order in which they were done. Whatever ends the program,
 * and whatever happens to the file, those that are whole are as they were.
 *
 *     16     "glim part file\n" and a zero
 *     4 x 4  version, order of bytes, width, height
 *     4, 4   length of the text, checksum of all of the head
 *     n      the text: what the tiles are of (cli/origin.h)
 *
 *   and for each tile:
 *     4, 4   mark, kind and whether it is opaque
 *     4 x 4  left, top, right, bottom
 *     4, 4   checksum of the values, of these 28 bytes
 *     n      values, row by row; where all floats' pixels are opaque only three
 *
 * Checksums are the low half of base/hash.h's; numbers are the machine's. A
 * file is used by one process at a time. */
#ifndef IMAGE_PART_FILE_H
#define IMAGE_PART_FILE_H

#include "image/area.h"

enum part_kind {
    PART_FIRST,   /* first samples, four floats for a place of the grid */
    PART_PIXELS,  /* finished pixels, four floats */
    PART_LEVELS,  /* finished pixels, levels of the file (image/output.h) */
    PART_TALLIES, /* sums of samples (render/passes.c), PART_TALLY bytes */
    PART_KINDS,
};

enum { PART_TALLY = 56 };

struct part_file;

/* A new one in place of what is there; NULL with the reason in error[size],
 * which is empty if another process has it open. Closed by part_file_close. */
struct part_file *part_file_create(const char *path, const char *text,
                                   int width, int height, char *error,
                                   size_t size);

/* One that is there, to add to it. All of it is looked at; what is damaged is
 * passed over. NULL with the reason: it is missing, in use, or its head is
 * damaged or of another version. */
struct part_file *part_file_open(const char *path, char *error, size_t size);

void part_file_close(struct part_file *file);

const char *part_file_text(const struct part_file *file);
int part_file_width(const struct part_file *file);
int part_file_height(const struct part_file *file);

/* Whether tiles of it were damaged, when it was opened. */
bool part_file_was_damaged(const struct part_file *file);

/* Adds a tile; from any thread. It waits in memory until there are a few
 * hundred kilobytes to write, or part_file_flush or part_file_sync is called.
 * Once one could not be written no more are, and part_file_problem has the
 * reason; else that is NULL. Returns its place in the file. */
long long part_file_put(struct part_file *file, enum part_kind kind,
                        struct area area, const void *values);
const char *part_file_problem(const struct part_file *file);

/* Tallies over older ones of the same area, which were put at `place`: the file
 * grows no more. If these still wait to be written, as part_file_put. Whatever
 * ends the program may leave neither: there must be others of the area in the
 * file, and who takes them must know which are the newest. */
long long part_file_replace(struct part_file *file, struct area area,
                            const void *values, long long place);

/* Writes what waits. */
void part_file_flush(struct part_file *file);

/* And waits until it is on the disk. */
void part_file_sync(struct part_file *file);

/* Gives each tile of the kind that touches `within` to `take`, the oldest
 * first, read anew and checked again: one that can't be read is left out. Not
 * while tiles are added. */
typedef void part_take(void *context, struct area area, const void *values);
void part_file_each(struct part_file *file, enum part_kind kind,
                    struct area within, part_take *take, void *context);

#endif
