/* Light sources: formulas of sections 5.5 to 5.7 of tests/povray.md are in
 * lighting/; here is the data. */
#ifndef SCENE_LIGHT_H
#define SCENE_LIGHT_H

#include "base/affine.h"
#include "base/field.h"
#include "base/rgb.h"
#include "scene/photon.h"
#include "text/source.h"

struct object;
struct solid;

enum light_kind { LIGHT_POINT, LIGHT_SPOT, LIGHT_CYLINDER };

struct light {
    enum light_kind kind;
    bool parallel; /* any kind: direction location -> point_at */
    vec3 location;
    vec3 point_at;  /* default <0,0,1> */
    rgb colour;     /* default white */
    double radius;  /* spot: degrees from the axis, 30; cylinder: 0.75 */
    double falloff; /* 45; cylinder: 1 */
    double tightness;
    double fade_distance, fade_power; /* both > 0, else no fading */
    bool shadowless;
    bool media_attenuation; /* weakened by fog and media on its way */
    bool no_media;          /* media scatter none of it */

    struct photon_flags photons; /* what it says of those it sends */

    unsigned group; /* whose objects alone it lights; 0: all */

    bool area;
    vec3 axis1, axis2;
    int size1, size2;
    int adaptive; /* -1: all points, else subdivisions always done */
    bool circular, orient, jitter, area_illumination;

    /* What is seen of it, in the space that `location` is in; or NULL. */
    const struct object *looks_like;
    /* What its light shines through alone (projected_through), likewise. */
    const struct object *window;
    const struct solid *pane; /* the same in the world */
    struct span span;
};

struct light light_default(void);

/* The light moved: location, point_at, axes. Distances stay. */
struct light light_moved(const struct light *light, const affine *transform);

/* All that is said of it but its colour, as numbers; returns how many. What
 * means nothing is 0: where a lamp points that shines everywhere alike. */
enum { LIGHT_SAID_MOST = 48 };
size_t light_said(const struct light *light, double said[LIGHT_SAID_MOST]);

/* The tables of what light depends on, ending with NULL: scene/fields.h. */
extern const struct field *const light_tables[];

#endif
