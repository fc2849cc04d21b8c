/* What a light mesh was made of and with, to tell whether it is still true. */
#ifndef LIGHTMESH_MESH_STAMP_H
#define LIGHTMESH_MESH_STAMP_H

#include "lightmesh/bright.h"
#include "lightmesh/indirect_light.h"
#include "scene/fingerprint.h"

/* To be changed with whatever changes what mesh points hold or where they are:
 * meshes of another glim are then refused. */
enum { MESH_VERSION = 20 };

enum { MESH_SETTINGS_SIZE = 1024 };

/* Where mesh points are, as the first picture's camera had it; later ones keep
 * to it, or they could use no point of the first. */
struct mesh_frame {
    double spacing; /* of mesh points, > 0 */
    double wanted;  /* the same, had there been memory enough for it */
    double near;    /* struct lattice */
    vec3 eye;
    vec3 centre; /* of what is seen */
    double size;
    /* Of the indirect mesh: */
    double gather;  /* spacing */
    int samples;    /* gather rays of a point; 0: it does nothing here */
    int asked;      /* the same, had there been time enough */
    int picks;      /* virtual lights that it asks, */
    int glow_picks; /* and places of what glows, at least */
    int edged;      /* up to so many ways are looked at more closely where two
                     * differ (way_cells.h) */
    bool closed;    /* the skeleton ends the bounces, */
    struct indirect_share around; /* or this does */
    struct bright lit;            /* whose light virtual lights bring */
    struct bright bright;         /* where some of the rays go */
};

/* All of it as numbers, for files and hashes. */
enum {
    FRAME_OWN_NUMBERS = 25,
    FRAME_DISC_NUMBERS = 8,
    MESH_FRAME_NUMBERS =
        FRAME_OWN_NUMBERS + 2 * FRAME_DISC_NUMBERS * BRIGHT_MOST
};
void mesh_frame_put(const struct mesh_frame *frame,
                    double numbers[MESH_FRAME_NUMBERS]);

/* Back again, of whatever numbers. */
void mesh_frame_take(struct mesh_frame *frame,
                     const double numbers[MESH_FRAME_NUMBERS]);

/* Whether they are such as a mesh can have. */
bool mesh_frame_possible(const struct mesh_frame *frame);

struct mesh_stamp {
    struct mesh_frame frame;
    struct fingerprint scene;
    char settings[MESH_SETTINGS_SIZE]; /* lines "name value" */
};

/* The settings that count and the scene, in which nothing but the camera may
 * change; the frame is the caller's. `shadows`: what the points hold is for;
 * `indirect`: light of surfaces, too. */
struct mesh_stamp mesh_stamp_new(const struct scene *scene,
                                 enum mesh_shadows shadows, bool indirect,
                                 int quality, unsigned long long seed);

/* A hash of all of it: meshes with the same may share points. */
uint64_t mesh_stamp_family(const struct mesh_stamp *stamp);

/* Whether the settings are the same: of scenes that may differ in what moves.
 */
bool mesh_stamp_alike(const struct mesh_stamp *a, const struct mesh_stamp *b);

/* Whether a mesh that was made with `made` is that of `now`. If not, what has
 * changed in text[size]: "the lights have changed". */
bool mesh_stamp_same(const struct mesh_stamp *made,
                     const struct mesh_stamp *now, char *text, size_t size);

#endif
