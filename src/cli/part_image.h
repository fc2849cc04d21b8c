/* Pictures out of part files. */
#ifndef CLI_PART_IMAGE_H
#define CLI_PART_IMAGE_H

#include "cli/part.h"
#include "cli/picture.h"

/* The text of a part file's head: the origin, and what is to be known besides
 * to write the picture. Freed with memory_free. */
char *part_text(const struct settings *settings, const char *origin);

/* Writes the picture that several files have the pixels of. `band`: of its
 * width, to work in, if the format has bands; NULL: one of its own. */
bool part_image_write(struct part_file *const *files, size_t count,
                      const struct picture_file *picture, struct image *band,
                      struct diag *diag);

/* What the text of a part file says of the picture's file, as far as writing it
 * goes; *origin gets the part of the text that the picture carries, in the
 * arena. False if it says too little. */
bool part_text_read(const char *text, struct options *options,
                    struct settings *settings, const char **origin,
                    struct arena *arena);

#endif
