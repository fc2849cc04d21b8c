/* How many rays a mesh point sends. */
#ifndef LIGHTMESH_PLAN_RAYS_H
#define LIGHTMESH_PLAN_RAYS_H

#include "lightmesh/lattice.h"
#include "lightmesh/survey.h"
#include "scene/scene.h"

/* How much finer a mesh is than at the usual quality: a factor. */
double plan_finer(const struct light_mesh_settings *said);

/* The most that a net has without being more than so many. */
int rays_within(double rays);

/* To what surfaces send, `times` as many as one picture needs; 0: there are to
 * be none. */
int plan_samples(const struct light_mesh_settings *said,
                 const struct survey *survey, int times);

/* And to virtual lights, likewise. */
int plan_picks(const struct light_mesh_settings *said,
               const struct survey *survey, int times);

/* And to what glows, where the survey has looked: at least; else 0. */
int plan_glow_picks(const struct light_mesh_settings *said,
                    const struct survey *survey, int times);

/* Short rays of a place (near_field.h), of which the usual quality has so many.
 */
int plan_near_rays(const struct light_mesh_settings *said, int usual);

/* The same where only a pixel sees it: fewer where surfaces give little light.
 * In a `film` it is always as many: noise would change when that does. */
int plan_lone_rays(const struct light_mesh_settings *said,
                   const struct survey *survey, bool film);

/* To all around a place in a crevice (near_own.h): the more places are in one,
 * and the less light comes from surfaces, the fewer, since they would be a
 * third of the picture's time. So few that they tell little count for less, 0
 * to 1. */
struct plan_own {
    int rays;
    double worth;
};

struct plan_own plan_own_rays(const struct light_mesh_settings *said,
                              const struct survey *survey,
                              const struct lattice *lattice,
                              const struct lattice_view *view, bool film);

#endif
