/* Finishes: how a surface takes light. The light-mesh paper's kd, ks and Emiss
 * are diffuse, reflection and emission. Each item of finish { } is a file in
 * finish/ and a row in finish/list.h; its numbers are members of struct finish
 * if more than the item itself look at them. */
#ifndef SCENE_FINISH_H
#define SCENE_FINISH_H

#include "base/field.h"
#include "base/power.h"
#include "base/rgb.h"
#include "base/vec.h"
#include "scene/rays.h"

struct noise_settings;

/* The items' places in the list. */
enum finish_place {
#define X(name, role) FINISH_PLACE_##name,
#include "scene/finish/list.h"
#undef X
    FINISH_ITEMS
};

struct reflection {
    rgb minimum, maximum; /* at normal and at grazing incidence */
    double falloff;       /* 1 */
    double exponent;      /* 1 */
    double metallic;      /* 0 */
    bool fresnel;
};

/* irid: a film, thinner here and thicker there, on which light interferes. */
struct film {
    double amount; /* 0: none */
    double thickness, turbulence;
    rgb wavelength;
    const struct noise_settings *noise;
};

/* Surfaces never send on all light, whatever their finish says, or that between
 * two of them would grow without end: this is whiter than any paint. Whoever
 * writes an `ambient` has guessed by it what surfaces give each other, and
 * painted for that, often whiter than anything is: where that guess is replaced
 * by what light does, they send on no more than walls and furniture do in the
 * mean (0.5 is what lighting engineers reckon with). */
#define RETURNED_MOST  0.95
#define RETURNED_USUAL 0.5

/* POV-Ray 3.7's defaults are in finish_default. */
struct finish {
    rgb ambient, emission;
    rgb glow; /* ambient light of what is meant to glow, ambient_light and all:
               * seen whatever stands before it, and lights nothing else */
    double diffuse, diffuse_back; /* light on the viewer's / the other side */
    double returned_most; /* share of light that it sends on to other surfaces,
                           * at most */
    bool diffuse_albedo;
    double brilliance;
    double phong, phong_size;
    bool phong_albedo;
    double specular, roughness;
    bool specular_albedo;
    double metallic; /* of phong and specular */
    double crand;    /* grain */
    struct film film;
    struct reflection reflection;
    rgb translucency; /* mm between scatterings within; black: none */
    bool conserve_energy;
    bool old_filter;      /* before 3.7 a dark colour filters less: see
                           * shade/finish.c */
    double ior, caustics; /* of scenes older than 3.1: the parser gives them
                           * to the object's interior; 0: not said */
    const void *own[FINISH_ITEMS]; /* what items keep of their own; NULL: not
                                    * said */
};

/* Light that meets paint; all directions are unit. */
struct finish_meeting {
    vec3 normal; /* with its bumps */
    vec3 view;   /* to whoever looks */
    vec3 light;  /* to where the light comes from */
};

/* The same of several, side by side. */
struct finish_meetings {
    const double (*normal)[RAY_LANES], (*view)[RAY_LANES], (*light)[RAY_LANES];
};

static inline struct finish_meeting
finish_meeting_at(const struct finish_meetings *meetings, unsigned i)
{
    return (struct finish_meeting){ lane_get(meetings->normal, i),
                                    lane_get(meetings->view, i),
                                    lane_get(meetings->light, i) };
}

struct finish_item {
    const char *name;
    /* Its words and what they say, of the struct that `said` points to:
     * struct finish or, if `size` is not 0, one of its own. In a block of its
     * own `inner`. NULL: none. See scene/fields.h. */
    const struct field *fields, *inner;
    size_t size;
    const void *usual; /* its own struct where it is not said; NULL: zeroes */
    size_t amount;     /* the offset of a double: 0 while it does nothing */
    /* What share of a lamp's light the viewer gets besides the diffuse one. */
    double (*highlight)(const void *said, const struct finish_meeting *meeting);
    /* The same of several, each to the bit; NULL: one by one. */
    void (*highlight_many)(const void *said,
                           const struct finish_meetings *meetings,
                           double shares[RAY_LANES]);
    /* Multiplies all light that goes from a lamp, or a mirrored thing, to the
     * viewer; their cosines to the normal. `point` in the world. */
    rgb (*tint)(const void *said, vec3 point, double lamp, double viewer);
};

/* A row of `fields` or `inner` of struct finish. */
#define FINISH_FIELD(name, kind, member, help)                                 \
    {                                                                          \
        name, kind, offsetof(struct finish, member), 0, 0, help                \
    }

/* Item number `index` of the list, or NULL past its end. */
const struct finish_item *finish_item_at(size_t index);
const struct finish_item *finish_item_find(const char *name);

/* The row of the word, and the item it is of; NULL: no finish has it. */
const struct field *finish_field(const char *word, enum finish_place *place);

#define X(name, role) extern const struct finish_item name##_finish;
#include "scene/finish/list.h"
#undef X

/* What the finish says of the item, or NULL while that does nothing. */
static inline const void *finish_part(const struct finish *finish,
                                      const struct finish_item *item,
                                      enum finish_place place)
{
    const void *said = item->size ? finish->own[place] : finish;
    if (!said)
        return NULL;
    const double *amount = (const void *)((const char *)said + item->amount);
    return *amount != 0 ? said : NULL;
}

/* In a row's X: DO(name) if the item has that role. */
#define FINISH_HIGHLIGHT_highlight(DO, name) DO(name)
#define FINISH_HIGHLIGHT_tint(DO, name)
#define FINISH_HIGHLIGHT_plain(DO, name)
#define FINISH_TINT_highlight(DO, name)
#define FINISH_TINT_tint(DO, name) DO(name)
#define FINISH_TINT_plain(DO, name)
#define FINISH_ON(name)                                                        \
    if (finish_part(finish, &name##_finish, FINISH_PLACE_##name))              \
        return true;

/* Whether it mirrors anything, at whatever angle. */
static inline bool finish_mirrors(const struct finish *finish)
{
    const struct reflection *mirror = &finish->reflection;
    return !rgb_is_black(mirror->minimum) || !rgb_is_black(mirror->maximum);
}

/* Whether it has highlights, and tints. Asked for each lamp and layer: written
 * out item by item, and the compiler sees their structs. */
static inline bool finish_shines(const struct finish *finish)
{
#define X(name, role) FINISH_HIGHLIGHT_##role(FINISH_ON, name)
#include "scene/finish/list.h"
#undef X
    return false;
}

static inline bool finish_tints(const struct finish *finish)
{
#define X(name, role) FINISH_TINT_##role(FINISH_ON, name)
#include "scene/finish/list.h"
#undef X
    return false;
}

/* All highlights: the share of a lamp's light. */
double finish_highlight(const struct finish *finish,
                        const struct finish_meeting *meeting);

/* The same of several, those that the bits `lanes` stand for. */
void finish_highlight_many(const struct finish *finish,
                           const struct finish_meetings *meetings,
                           unsigned lanes, double shares[RAY_LANES]);

/* What tints make of white light. */
rgb finish_tint(const struct finish *finish, vec3 point, double lamp,
                double viewer);

/* cosine^size; most of the time nothing that could be seen: the logarithm of a
 * cosine c is at most c - 1, and exp(-24) 4e-11. */
static inline double finish_lobe(double cosine, double size)
{
    return size * (1 - cosine) > 24 ? 0 : power_of(cosine, size);
}

/* The same of several, times `amount`; 0 where a cosine isn't above 0. */
void finish_lobes(const double cosines[RAY_LANES], double size, double amount,
                  double lobes[RAY_LANES]);

struct finish finish_default(void);

/* Whether its ambient light is more than finishes have anyway, and than they
 * would scatter in surroundings half as bright as white: then it doesn't stand
 * for light from elsewhere, but the surface is meant to glow. */
bool finish_is_to_glow(const struct finish *finish, rgb ambient_light);

#endif
