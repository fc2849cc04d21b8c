/* Meshes counted: see mesh_report.h. */
#include "lighting/mesh_report.h"

#include <stdio.h>

#include "lightmesh/facet_mesh.h"
#include "lightmesh/obstacles.h"
#include "lightmesh/table.h"

void mesh_report_add(struct mesh_report *report, const char *name,
                     const struct point_mesh *points,
                     const struct lattice_view *view)
{
    struct mesh_reported *of = &report->of[report->count++];
    snprintf(of->name, sizeof of->name, "%s", name);
    of->points = points;
    of->view = *view;
}

void mesh_report_tell(const struct mesh_report *report, lighting_row *row,
                      void *context)
{
    double bytes = 0, seconds = 0, around = 0;
    row(context, "mesh density", 1 / report->spacing, "per unit");
    row(context, "mesh possible", pow(report->size / report->spacing, 3), "");
    for (size_t i = 0; i < report->count; i++) {
        const struct mesh_reported *of = &report->of[i];
        const struct point_mesh *mesh = of->points;
        const struct {
            const char *what;
            double amount;
        } rows[] = {
            { "points", (double)table_count(mesh->table) },
            { "refined", (double)point_mesh_refined(mesh, &of->view) },
            { "alone", (double)atomic_load(&mesh->work->lone) },
            { "rays", (double)atomic_load(&mesh->work->rays) },
        };
        for (size_t k = 0; k < sizeof rows / sizeof *rows; k++) {
            char name[40];
            snprintf(name, sizeof name, "%s %s", of->name, rows[k].what);
            row(context, name, rows[k].amount, "");
        }
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
