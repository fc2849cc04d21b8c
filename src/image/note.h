/* The text that a picture carries of its origin: tEXt "glim" of a PNG, the
 * string attribute "glim" of an OpenEXR file. Other kinds have none. */
#ifndef IMAGE_NOTE_H
#define IMAGE_NOTE_H

#include "base/arena.h"

/* The note of the file at `path`, in the arena; NULL: it has none, or is no
 * such file. Only the file's head is looked at, and nothing in it is trusted.
 */
const char *image_note_read(struct arena *arena, const char *path);

#endif
