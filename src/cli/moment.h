/* A frame of an animation without its picture: its scene, and the light in it.
 * Its own picture is drawn of it, and those of others may need it, too. */
#ifndef CLI_MOMENT_H
#define CLI_MOMENT_H

#include "base/file_list.h"
#include "lighting/lighting.h"
#include "parse/parse.h"
#include "scene/fingerprint.h"

struct work;

/* What was said of it, to be said when it is its turn. */
struct moment_message {
    enum diag_level level;
    struct span span;
    const char *hint, *text;
};

struct moment {
    int number;             /* of the frame */
    struct arena *arena;    /* NULL: nobody has read it */
    struct scene *scene;    /* NULL: it has errors */
    struct file_list asked; /* for files */
    struct {
        struct moment_message *items;
        size_t count, capacity;
        size_t told;
    } messages;
    struct fingerprint print;        /* by moment_print, */
    bool printed;                    /* once that has been asked */
    struct world *world;             /* until it is lit, NULL */
    const struct lighting *lighting; /* that has lit it, or tried; */
    void *state;                     /* NULL: not yet, or it can't */
};

/* What the scene of a frame is told, how it is lit, and its world (NULL after
 * an error was printed). */
struct parse_options moment_parsing(const struct work *work, int number);
struct lighting_options moment_lighting(const struct work *work);
struct world *moment_world(const struct work *work, const struct scene *scene,
                           struct diag *diag);

/* Whether what the lighting method knows after a frame is of use. */
bool moment_keeps(const struct work *work);

/* Reads the scene of a frame into *moment, which stays where it is until
 * moment_free. What there is to say goes to `diag`, or if that is NULL is kept
 * until moment_tell. */
void moment_read(struct moment *moment, const struct work *work, int number,
                 struct diag *diag);
void moment_free(struct moment *moment);

/* Tells its scene from others. All of it is read for that, the first time. */
const struct fingerprint *moment_print(struct moment *moment);

/* Says what is kept and hasn't been said. */
void moment_tell(struct moment *moment, struct diag *diag);

/* Lights it; what there is to say of its world is kept, and of its light is
 * said when the frame is drawn. */
void moment_light(struct moment *moment, const struct work *work);

#endif
