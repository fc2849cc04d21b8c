/* Scene text to scene: the one function the rest of the program sees. */
#ifndef PARSE_PARSE_H
#define PARSE_PARSE_H

#include <stdatomic.h>

#include "base/file_list.h"
#include "scene/scene.h"
#include "text/diag.h"
#include "text/permit.h"

/* A value that a #declare or #local gave to a name; it is gone after the call.
 */
struct parse_declared {
    const char *name;
    struct span span;      /* of the name where it was declared */
    const char *kind;      /* "a float", "a texture": as in messages */
    const double *numbers; /* of a float, vector, colour (r g b f t) */
    int size;              /* how many; 0: something else */
    bool colour;
    const char *text; /* of a string, else NULL */
};

/* Somebody who follows the reading; it is called on the thread that reads. */
struct parse_listener {
    void *context;
    void (*declared)(void *context, const struct parse_declared *declared);
    /* The text to be read in place of the include file at `path`, in the
     * arena, or NULL: what is on disk. */
    const struct source *(*text)(void *context, struct arena *sources,
                                 const char *path, struct span included_from);
};

/* What the scene's text may ask about its surroundings. */
struct parse_options {
    const char *const *include_paths; /* searched after the current directory */
    size_t include_path_count;
    const struct permits *permits;      /* what the scene may read; NULL: all */
    const char *const *standard_paths;  /* of POV-Ray's own; NULL ends them */
    const char *const *include_headers; /* +HI files, read before the scene */
    size_t include_header_count;
    /* Declare=NAME=VALUE, in order; the value is an expression or string. */
    const struct parse_declare {
        const char *name, *value;
        struct span span; /* where it was said: INI file or nowhere */
    } * declares;
    size_t declare_count;
    double clock, clock_delta;
    bool clock_on;
    double initial_clock, final_clock;
    int initial_frame, final_frame, frame_number;
    int image_width, image_height;
    const struct light_said *light_said; /* wins over the scene's own settings,
                                          * with the values in `light`; NULL:
                                          * nothing is said */
    const struct settings *light;
    double version;          /* +MV; 0: not said */
    size_t memory_limit;     /* bytes for text, parsing and scene together;
                              * 0: 4 GiB, or half of what there is */
    unsigned round_limit;    /* rounds of one loop, 0: 10 million */
    struct file_list *asked; /* gets the names of all files that the scene
                              * asks for; or NULL */
    const struct parse_listener *listener; /* or NULL */
    const atomic_int *stop; /* set by a signal: give up quietly; or NULL */
};

/* Reads `main` into a new scene. Errors are printed to `diag`; on any error
 * returns NULL. Sources live in `sources`, which must outlive the scene.
 * Re-entrant: no state is kept between calls. */
struct scene *parse_scene(const struct source *main,
                          const struct parse_options *options,
                          struct arena *sources, struct diag *diag);

#endif
