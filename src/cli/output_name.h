/* What picture files are called: POV-Ray's rules (measured on 3.7). */
#ifndef CLI_OUTPUT_NAME_H
#define CLI_OUTPUT_NAME_H

#include <stdbool.h>
#include <stddef.h>

#include "base/arena.h"

/* A +F letter and what it means. */
struct output_type {
    char letter;
    const char *extension; /* with its dot */
    const char *format;    /* OIIO's name */
    const char *help;
};

/* By letter, either case, or NULL; by number, or NULL past the end. */
const struct output_type *output_type_find(char letter);
const struct output_type *output_type_at(size_t index);

/* The type other than `type` whose extension ends `name`, or NULL. */
const struct output_type *output_type_meant(const char *name,
                                            const struct output_type *type);

/* The picture extension that ends `name` and that glim does not write, or
 * NULL. */
const char *output_type_lacking(const char *name);

/* Length of the name without its extension: "dir.d/a.b.png" -> 9. A dot that
 * begins the last part is no extension. */
size_t output_stem(const char *name);

/* Whether +O names a folder for the picture: "dir/", ".", "dir/..". */
bool output_is_folder(const char *output);

/* Whether that is no file that gets an extension or a frame's number: standard
 * output, a device, a pipe. */
bool output_is_fixed(const char *output);

/* The picture's name: `output` is what +O says or NULL, `input` the scene as
 * typed. A missing extension is added to what is not fixed. Without +O the
 * picture lies beside the scene. */
const char *output_name(const char *output, const char *input,
                        const struct output_type *type, struct arena *arena);

#endif
