/* Shadow rays: what part of a lamp's light gets from there to here. */
#ifndef SHADE_SHADOW_H
#define SHADE_SHADOW_H

#include "base/worker.h"
#include "world/world.h"
#include "shade/interior.h"

struct photon_flags;
struct media_dims;

/* A way that light may go. */
struct shadow_path {
    vec3 point;     /* where it arrives */
    vec3 direction; /* unit, to the lamp */
    double distance;
    int light; /* whose: what looks like it is no obstacle; or -1 */
    const struct interiors *inside; /* bodies the point is in; may be NULL */
    const struct shaft *shaft;      /* the way is in it; NULL: in none */
    double place[2];                /* where in it */
    const struct scene *fog; /* whose fogs and media weaken the light; NULL:
                              * only media in objects do */
    bool misty;              /* there are some */
    /* What the lamp says of photons: what they bring through their targets is
     * no light of this way. NULL: there are none, or they light nothing there.
     */
    const struct photon_flags *photons;
    bool smooth;   /* bumps of panes do nothing, by +Q */
    double spread; /* of the way: see world_glimpse */
    uint64_t key;  /* of random numbers: media are met without bias; 0: as
                    * POV-Ray samples them */
    struct media_dims *dims; /* that look at media later; NULL: at once */
    int number;              /* of the way in these */
};

/* The share of light that gets there, tinted by transparent objects and faded
 * by their interiors; black in full shadow. A distance that isn't positive
 * leaves room for nothing: white. */
rgb shadow_visibility(const struct world *world, struct worker *worker,
                      const struct shadow_path *path);

/* The same where nothing lets light pass by parts: whether none gets there. */
bool shadow_falls(const struct world *world, struct worker *worker, vec3 point,
                  vec3 direction, double distance, int light);

/* What gets along several ways. Bits stand for ways. */
struct shadows {
    unsigned dark;        /* nothing */
    unsigned left;        /* shadow_visibility has to say */
    unsigned tinted;      /* this share; all light along the others: */
    rgb share[RAY_LANES]; /* of those that are tinted */
};

/* The share of light that gets along way number i, which isn't left. */
static inline rgb shadows_along(const struct shadows *shadows, unsigned i)
{
    return shadows->tinted >> i & 1 ? shadows->share[i]
                                    : rgb_grey(!(shadows->dark >> i & 1));
}

/* What else there is around several ways. */
struct shadow_around {
    const struct interiors *const *inside; /* as of a path, for each */
    const struct scene *fog;               /* as of a path */
    bool misty;                            /* likewise */
    bool smooth;                           /* likewise */
    const struct photon_flags *photons;    /* likewise, */
    unsigned straight; /* but of these ways everything is light */
};

/* Shadow_visibility of the ways to one lamp that the bits `lanes` stand for,
 * which must set out at shadow_start and end at shadow_end. `around` NULL:
 * fogs, media and photons don't count, and panes are not looked through: ways
 * through them are left. Where fogs or media count directions are unit. The
 * filter of `ways` is set here. */
void shadow_falls_many(const struct world *world, struct worker *worker,
                       struct occlusions *ways, unsigned lanes,
                       const struct shadow_around *around,
                       struct shadows *shadows);

/* Shadow rays see nothing closer than this to the lamp, the surface, or the
 * filter before. */
#define SHADOW_MARGIN 1e-3

/* To what is at the ends of a short way no more than this part of it: where
 * walls are thinner than the margin light came through them at corners. POV-Ray
 * has a tenth of the margin for what shaded the pixel before (measured). */
#define SHADOW_MARGIN_PART (1.0 / 500)

/* How far from a surface point the next ray begins to see: POV-Ray's 1e-4
 * (measured), and what single precision needs far from the origin. */
static inline double surface_offset(vec3 point)
{
    double size = 0.9999e3;
    size = fabs(point.x) > size ? fabs(point.x) : size;
    size = fabs(point.y) > size ? fabs(point.y) : size;
    size = fabs(point.z) > size ? fabs(point.z) : size;
    return 1e-7 * size;
}

static inline double shadow_margin(double distance)
{
    double part = distance * SHADOW_MARGIN_PART;
    return part < SHADOW_MARGIN ? part : SHADOW_MARGIN;
}

/* How far from its point a way that is so long begins to meet anything, and
 * ends to. */
static inline double shadow_start(vec3 point, double distance)
{
    double offset = surface_offset(point), margin = shadow_margin(distance);
    return offset > margin ? offset : margin;
}

static inline double shadow_end(double distance)
{
    return distance - shadow_margin(distance);
}

/* How long the way is that ends there. */
static inline double shadow_distance(double end)
{
    double far = end + SHADOW_MARGIN, near = end / (1 - SHADOW_MARGIN_PART);
    return near < far ? near : far;
}

#endif
