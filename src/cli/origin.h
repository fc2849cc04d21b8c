/* The origin of a picture: a text of all that decides it, which the picture
 * carries (image/note.h) and part files begin with. Lines "name value": the
 * program, the scene, every setting that counts, and after them every file that
 * was read ("file HASH PATH") or looked for in vain ("none PATH"). What changes
 * no pixel, as the number of threads or the picture's name, is not in it. So
 * whether a picture is current can be told without its scene being read. */
#ifndef CLI_ORIGIN_H
#define CLI_ORIGIN_H

#include "base/writer.h"
#include "cli/options.h"

/* A line that the origin of what was not finished begins with. */
#define ORIGIN_UNFINISHED "unfinished"

/* The first part of it: the settings. `number` is the frame's; `scene` the
 * main text, which has no file if it comes from standard input. */
void origin_settings(struct writer *text, const struct options *options,
                     int number, const struct source *scene);

/* The second: of the files from the list's `first` on those that were asked for
 * in this round. */
void origin_files(struct writer *text, const struct file_list *files,
                  size_t first);

/* What differs between two first parts, in why[size], as "it was drawn with
 * width 640, not 800"; the second parts, if there are any, are not looked at.
 * Returns whether nothing does. */
bool origin_same_settings(const char *made, const char *now, char *why,
                          size_t size);

/* Whether the files of an origin are as they were. They are added to `seen`,
 * which keeps their hashes. If not, why[size] is "'room.inc' has changed". */
bool origin_same_files(const char *made, struct file_list *seen, char *why,
                       size_t size);

/* Calls `take` for each file of an origin, there or not. */
void origin_each_file(const char *made,
                      void (*take)(void *context, const char *path, bool there),
                      void *context);

/* The value of a line "name value" in text[size]; false if there is none. */
bool origin_value(const char *made, const char *name, char *text, size_t size);

#endif
