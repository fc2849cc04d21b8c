/* What global_settings says of glim's own lighting methods: light_mesh {} and
 * skeleton {}. A number that is 0 was not said: the method chooses it from the
 * size of the scene and of the picture. */
#ifndef SCENE_LIGHT_SETTINGS_H
#define SCENE_LIGHT_SETTINGS_H

#include <stdbool.h>
#include <stddef.h>

#include "base/field.h"
#include "text/source.h"

/* A part of space that wants a denser mesh. */
struct mesh_region {
    vec3 low, high; /* world */
    double factor;  /* times the density, > 0 */
};

enum mesh_model {
    MESH_MODEL_DIRECTIONAL, /* agrees with rays and path */
    MESH_MODEL_SCALAR,      /* the paper's equations (1) to (8), literally */
};

enum mesh_shadows {
    MESH_SHADOWS_AUTO,  /* sharp under few lamps, under many nearly so where it
                         * is quick, else soft */
    MESH_SHADOWS_SOFT,  /* as soft as the interpolation makes them */
    MESH_SHADOWS_SHARP, /* of points, by shadow rays: few lamps are all asked,
                         * of many those on which neighbours disagree */
};

/* What becomes of the light of surfaces at each bounce. */
struct bounce_tone {
    double brightness; /* multiplies it, 1 */
    double grey;       /* how much of its colour goes, 0 to 1 */
};

/* Values of radiosity {} that say how bright it is, not how it is found. */
struct radiosity_settings {
    struct bounce_tone tone;
    int recursion_limit; /* bounces, 2 */
    bool normal;         /* bumps count */
};

/* light_mesh {} */
struct light_mesh_settings {
    double quality;            /* 1..10, 5 if not said; turn it first */
    double density;            /* mesh points for one unit of length, > 0 */
    double radius;             /* of interpolation, units, > 0 */
    const char *interpolation; /* a name in lightmesh/interpolation/list.h */
    struct span interpolation_place; /* nowhere: on the command line */
    enum mesh_model model;
    enum mesh_shadows shadows;
    double threshold; /* adaptive: neighbours may differ by so much, 0..1 */
    int levels;       /* adaptive: how often a cell may be halved; both 0: only
                       * as indirect light needs it */
    struct {
        bool on;     /* unless said off, whatever radiosity {} says */
        int samples; /* gather rays of a mesh point */
        int bounces;
        bool skeleton; /* the skeleton's light ends the last bounce */
        /* What POV-Ray's radiosity does and a scene says there alone: */
        struct bounce_tone tone;
        bool dark; /* nothing comes after the last bounce */
    } indirect;
    struct {
        struct mesh_region *items;
        size_t count, capacity;
    } regions;
    const char *save_file, *load_file; /* or NULL; save_file never by a scene:
                                        * a scene must not write files */
    bool only; /* --mesh-only: the mesh is wanted, no picture */
    bool sky;  /* sky and background are lamps, as they are with radiosity */
};

enum path_guide {
    PATH_GUIDE_OFF,
    PATH_GUIDE_SKELETON, /* lighting/guide.h */
};

/* skeleton {} */
struct skeleton_settings {
    int resolution;        /* voxels along the longest side, 0: not said */
    const char *heuristic; /* a name in skeleton/heuristic/list.h, or NULL */
    struct span heuristic_place; /* nowhere: on the command line */
    const char *save_file;       /* or NULL; never by a scene */
    enum path_guide guide;       /* of --lighting path */
};

struct settings;

/* The words of light_mesh {}, of indirect {} in it, of skeleton {}; what only
 * the command line says. Their offsets are into struct settings. */
extern const struct field light_mesh_fields[], indirect_fields[],
    skeleton_fields[], light_option_fields[];

/* Notes where the value of a field stands, if anybody wants to know. */
void light_place(struct settings *settings, const struct field *field,
                 struct span place);

/* What options say, which wins over the scene. */
enum { LIGHT_SAID_LIMIT = 32 };

struct light_said {
    const struct field *fields[LIGHT_SAID_LIMIT]; /* each once */
    struct span places[LIGHT_SAID_LIMIT];         /* in INI files, or nowhere */
    size_t count;
};

/* Notes that the field was said, and where. */
void light_said_add(struct light_said *said, const struct field *field,
                    struct span place);

/* Puts what was said, kept in `values`, into `settings`. */
void light_said_apply(const struct light_said *said,
                      const struct settings *values, struct settings *settings);

#endif
