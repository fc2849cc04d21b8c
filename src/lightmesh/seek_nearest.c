/* How a surface finds one mesh point near by: point_mesh_nearest of
 * point_mesh.h. */
#include "lightmesh/point_mesh.h"
#include "lightmesh/seek_sight.h"
#include "lightmesh/tuning.h"

/* The corners of a cell, roughly from near to far: those reached from the
 * nearest by steps along axes, the first of which costs least. */
static void nearest_corners(vec3 at, struct lattice_point corner[8])
{
    double t[3] = { at.x - floor(at.x), at.y - floor(at.y),
                    at.z - floor(at.z) };
    int low[3] = { (int)floor(at.x), (int)floor(at.y), (int)floor(at.z) };
    int axis[3] = { 0, 1, 2 };
    for (int i = 1; i < 3; i++)
        for (int j = i;
             j > 0 && fabs(t[axis[j]] - 0.5) < fabs(t[axis[j - 1]] - 0.5);
             j--) {
            int swap = axis[j];
            axis[j] = axis[j - 1];
            axis[j - 1] = swap;
        }
    for (int steps = 0; steps < 8; steps++)
        for (int i = 0; i < 3; i++) {
            int up = t[axis[i]] >= 0.5, step = steps >> i & 1;
            corner[steps].at[axis[i]] = low[axis[i]] + (up ^ step);
        }
}

static bool nearest_looks(const struct point_mesh *mesh, struct worker *worker,
                          const struct receiver *receiver, vec3 from,
                          rgb *through)
{
    return through ? seek_looks_through(mesh, worker, receiver, from, through)
                   : seek_looks(mesh, worker, receiver, from);
}

/* The nearest that surely sees the place, or else the nearest that does. */
const void *point_mesh_nearest(const struct point_mesh *mesh,
                               struct worker *worker,
                               const struct receiver *receiver, vec3 jitter,
                               rgb *through)
{
    double coarse;
    struct lattice_point corner[8];
    vec3 from[8];
    int unsure[8], count = 0;
    vec3 place = receiver->point, normal = receiver->side;
    if (through)
        *through = rgb_grey(1);
    int level = lattice_level(&mesh->lattice, &receiver->view, place, &coarse);
    if (coarse > 0.5)
        level++;
    double spacing = lattice_spacing(&mesh->lattice, level);
    vec3 lifted = vec3_along(place, normal, seek_lift * spacing);
    vec3 at = lattice_units(&mesh->lattice, level, lifted);
    nearest_corners(vec3_add(at, jitter), corner);
    for (int i = 0; i < 8; i++) {
        corner[i].level = level;
        from[i] = lattice_place(&mesh->lattice, &corner[i]);
        if (vec3_dot(vec3_sub(from[i], place), normal) < nearest_rise * spacing)
            continue;
        enum sight sight =
            seek_sight(mesh, worker, receiver, &corner[i], from[i]);
        if (sight == SIGHT_CLEAR)
            return point_mesh_payload(mesh, worker, &corner[i]);
        if (sight == SIGHT_UNSURE)
            unsure[count++] = i;
    }
    for (int i = 0; i < count; i++)
        if (nearest_looks(mesh, worker, receiver, from[unsure[i]], through))
            return point_mesh_payload(mesh, worker, &corner[unsure[i]]);
    return NULL;
}
