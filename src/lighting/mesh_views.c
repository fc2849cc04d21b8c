/* Mesh points to be shown: see mesh_views.h. */
#include "lighting/mesh_views.h"

#include "lightmesh/facet_mesh.h"
#include "lightmesh/scalar.h"
#include "shade/surface.h"

/* Who asks for the points. */
struct mesh_viewer {
    const struct direct_mesh *direct; /* NULL: the payloads are others */
    rgb (*light)(const void *payload);
    struct show *show;
};

static rgb harmonics_light(const void *payload)
{
    return harmonics_total(payload);
}

static void mesh_viewer_take(void *context, vec3 place, const void *payload)
{
    const struct mesh_viewer *viewer = context;
    struct show *show = viewer->show;
    rgb light = viewer->direct
                    ? direct_mesh_arriving(viewer->direct, place, payload)
                    : viewer->light(payload);
    *ARRAY_PUSH(show->arena, &show->points) =
        (struct show_point){ place, rgb_brightness(light) };
}

static void mesh_show(const struct point_mesh *points,
                      struct mesh_viewer *viewer)
{
    viewer->show->what = "light";
    viewer->show->logarithmic = true;
    point_mesh_each(points, mesh_viewer_take, viewer);
}

static rgb facet_light(const void *payload)
{
    return facet_light_total(payload);
}

static void mesh_viewer_pixel(void *context, vec3 place,
                              const struct facet_light *light)
{
    mesh_viewer_take(context, place, light);
}

void mesh_show_direct(const struct direct_mesh *mesh,
                      const struct pixel_mesh *pixels, struct show *show)
{
    struct mesh_viewer viewer = { .direct = mesh, .show = show };
    struct mesh_viewer facets = { .light = facet_light, .show = show };
    mesh_show(&mesh->points, &viewer);
    if (mesh->facets)
        mesh_show(&mesh->facets->points, &facets);
    if (pixels && mesh->many)
        pixel_mesh_each(pixels, mesh_viewer_pixel, &facets);
}

void mesh_show_scalar(const struct point_mesh *points, struct show *show)
{
    struct mesh_viewer viewer = { .light = scalar_held, .show = show };
    mesh_show(points, &viewer);
}

void mesh_show_indirect(const struct indirect_mesh *mesh, struct show *show)
{
    struct mesh_viewer viewer = { .light = harmonics_light, .show = show };
    if (mesh)
        mesh_show(&mesh->points, &viewer);
}
