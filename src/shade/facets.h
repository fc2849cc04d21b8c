/* Surfaces side by side, as light of lamps meets them: what finish.h has of one
 * surface at a time, the same to the bit. Bits stand for surfaces. */
#ifndef SHADE_FACETS_H
#define SHADE_FACETS_H

#include "scene/rays.h"
#include "shade/surface.h"

/* A colour as lane_put takes it. */
static inline vec3 vec3_of(rgb c)
{
    return (vec3){ c.r, c.g, c.b };
}

/* Tells the surface of number i, for what isn't done side by side. */
typedef const struct surface *facet_surface(void *context, unsigned i);

/* A layer of their paint. */
struct facet_layer {
    unsigned lanes;   /* that have it; of them */
    unsigned shining; /* those with highlights, */
    unsigned uneven;  /* finish_is_uneven, */
    unsigned tinted;  /* or finish_tints */
    unsigned begins;  /* those of which a picked texture begins here */
    const struct finish *finish[RAY_LANES];
    LANE_LINES double normal[3][RAY_LANES]; /* with its bumps */
    /* Whether light from its front and its back does anything to it. */
    lane_flag front[RAY_LANES], back[RAY_LANES];
    double diffuse[RAY_LANES], diffuse_back[RAY_LANES], opacity[RAY_LANES];
    double pigment[3][RAY_LANES], weight[3][RAY_LANES];
    double clear[2][RAY_LANES]; /* of plain ones: filter and transmit */
    double share[RAY_LANES];    /* of the surface, that the picked texture has
                                 * which begins here */
};

struct facets {
    unsigned all;     /* that are set */
    unsigned layered; /* of other than one layer */
    unsigned blended; /* plain ones of a choice */
    facet_surface *tell;
    void *context;
    double bailout;                               /* as of a surface_view */
    const struct world_faces *faces;              /* that they are */
    const struct picture_place *place[RAY_LANES]; /* as a surface's, */
    bool unmirrored[RAY_LANES];                   /* likewise */
    const struct surface *surface[RAY_LANES];     /* NULL: not told yet */
    const struct leaf *leaf[RAY_LANES];
    const struct interiors *inside[RAY_LANES]; /* of the viewer's ray */
    double worth[RAY_LANES];                   /* as a surface's weight */
    LANE_LINES double point[3][RAY_LANES];
    double view[3][RAY_LANES];   /* unit, to the viewer */
    double normal[3][RAY_LANES]; /* unit, turned to the viewer, without bumps */
    lane_flag twice[RAY_LANES];  /* both of their sides are the front */
    lane_flag many[RAY_LANES];   /* those that are layered */
    double light[3][RAY_LANES];  /* the sum of what they send to the viewer */
    unsigned depth;              /* how many layers are in use */
    struct facet_layer layer[TEXTURE_LAYERS]; /* the top one first */
};

/* At the faces that the rays meet, which must stay, none of them set. */
void facets_start(struct facets *facets, const struct rays *rays,
                  const struct world_faces *faces);

/* Number i, which is so and has so much light. */
void facets_set(struct facets *facets, unsigned i,
                const struct surface *surface, rgb light);

/* Those whose leaves are plain; without light, and `inside` and `worth` are to
 * be set. Their surfaces are told when they are asked for. */
void facets_paint(struct facets *facets, const struct world_hit *hits,
                  unsigned lanes);

const struct surface *facets_surface(struct facets *facets, unsigned i);

/* Whether light from there does anything to it, as surface_faces. */
bool facets_face(const struct facets *facets, unsigned i, vec3 way);

/* As a surface has them: `side`, and what it makes of irradiance and of ambient
 * light 1 (surface_albedo, surface_ambient). */
vec3 facets_side(const struct facets *facets, unsigned i);
rgb facets_albedo(const struct facets *facets, unsigned i);
rgb facets_ambient(const struct facets *facets, unsigned i);

/* What is known of the top layer of a plain one. */
struct surface_paint facets_paint_of(const struct facets *facets, unsigned i);

/* Of the surface of a plain one what decides how a ray goes on; the rest isn't
 * set. `ior` as of a surface_view. */
void facets_fill(const struct facets *facets, unsigned i, double ior,
                 struct surface *surface);

rgb facets_light(const struct facets *facets, unsigned i);

/* Light without a direction at each of them. */
struct facets_diffuse {
    bool even; /* it is the first one's everywhere; the others aren't set */
    struct diffuse_light of[RAY_LANES];
};

static inline const struct diffuse_light *
facets_diffuse_at(const struct facets_diffuse *diffuse, unsigned i)
{
    return &diffuse->of[diffuse->even ? 0 : i];
}

/* Adds what plain ones send without lamps, as finish_glow and finish_shine. */
void facets_glow(struct facets *facets, unsigned lanes,
                 const struct facets_diffuse *diffuse);

/* A lamp's light as it arrives at them. */
struct facets_lit {
    const double (*direction)[RAY_LANES]; /* to the lamp, unit */
    LANE_LINES double colour[3][RAY_LANES];
    bool highlights;
};

/* Adds the light that `lanes` send on, as surface_add_light. */
void facets_add(struct facets *facets, const struct facets_lit *lit,
                unsigned lanes);

#endif
