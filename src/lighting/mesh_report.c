/* Meshes counted: see mesh_report.h. */
#include "lighting/mesh_report.h"

#include <stdio.h>

#include "lightmesh/facet_mesh.h"
#include "lightmesh/obstacles.h"
#include "lightmesh/table.h"

static const struct facet_mesh *report_facets(const struct mesh_report *report)
{
    return report->direct ? report->direct->facets : NULL;
}

/* The direct mesh is number 0, then come its points on surfaces, if there are,
 * then bounce by bounce; NULL past the end. */
static const struct point_mesh *report_mesh(const struct mesh_report *report,
                                            int number)
{
    const struct indirect_mesh *bounce = report->indirect;
    const struct scalar_mesh *scalar = report->scalar;
    const struct facet_mesh *facets = report_facets(report);
    if (scalar && number == 1 && scalar->samples)
        return &scalar->indirect;
    if (scalar)
        return number == 0 ? &scalar->direct : NULL;
    if (number == 0)
        return &report->direct->points;
    if (facets && number-- == 1)
        return &facets->points;
    for (; bounce && number > 1; number--)
        bounce = bounce->next;
    return bounce ? &bounce->points : NULL;
}

static void report_name(const struct mesh_report *report, int number,
                        char name[24])
{
    int bounce = number - (report_facets(report) ? 1 : 0);
    if (number == 0)
        snprintf(name, 24, "direct");
    else if (bounce == 0)
        snprintf(name, 24, "surface");
    else
        snprintf(name, 24, "bounce %d", bounce);
}

static const struct lattice_view *number_view(const struct mesh_report *report,
                                              int number)
{
    return number == 0 ? &report->direct_view : &report->indirect_view;
}

void mesh_report_tell(const struct mesh_report *report, lighting_row *row,
                      void *context)
{
    const struct point_mesh *mesh;
    double bytes = 0, seconds = 0, around = 0;
    row(context, "mesh density", 1 / report->spacing, "per unit");
    row(context, "mesh possible", pow(report->size / report->spacing, 3), "");
    for (int i = 0; (mesh = report_mesh(report, i)); i++) {
        char kind[24], name[40];
        report_name(report, i, kind);
        snprintf(name, sizeof name, "%s points", kind);
        row(context, name, (double)table_count(mesh->table), "");
        snprintf(name, sizeof name, "%s refined", kind);
        row(context, name,
            (double)point_mesh_refined(mesh, number_view(report, i)), "");
        snprintf(name, sizeof name, "%s alone", kind);
        row(context, name, (double)atomic_load(&mesh->work->lone), "");
        snprintf(name, sizeof name, "%s rays", kind);
        row(context, name, (double)atomic_load(&mesh->work->rays), "");
        around += (double)table_count(mesh->around);
        bytes += (double)point_mesh_bytes(mesh);
        seconds += (double)atomic_load(&mesh->work->nanoseconds) * 1e-9;
    }
    if (report->pixels) {
        row(context, "pixel points", (double)pixel_mesh_count(report->pixels),
            "");
        bytes += (double)pixel_mesh_bytes(report->pixels);
    }
    if (report->penumbras) {
        row(context, "penumbra points",
            (double)penumbras_count(report->penumbras), "");
        bytes += penumbras_memory(report->penumbras);
    }
    row(context, "mesh sight rays", around * OBSTACLE_DIRECTIONS, "");
    row(context, "mesh memory", bytes * 1e-6, "MB");
    row(context, "mesh time", seconds, "s of all threads");
}
