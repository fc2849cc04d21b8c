/* mesh_camera: a ray from each triangle. Everything was measured with POV-Ray
 * 3.7: rays begin at the middle and go to the side on which corners turn left,
 * location.z away; where direction.z is below 0 they look back. The first line
 * of the picture counts twice, or of CAMERA_UV by half. */
#include "scene/box_tree.h"
#include "scene/camera.h"
#include "scene/camera_mesh.h"
#include "scene/mesh.h"

/* A place on a triangle: barycentric for its corners 1 and 2. */
struct mesh_place {
    const struct camera_mesh_part *part;
    size_t triangle;
    double u, v;
};

static struct ray place_ray(const struct camera *camera,
                            const struct mesh_place *place)
{
    const struct mesh *mesh = place->part->mesh;
    const struct mesh_triangle *t = &mesh->triangles[place->triangle];
    const affine *to = &place->part->transform;
    vec3 at[3];
    for (int k = 0; k < 3; k++)
        at[k] = affine_point(to, mesh->vertices[t->vertex[k]]);
    vec3 sides[2] = { vec3_sub(at[1], at[0]), vec3_sub(at[2], at[0]) };
    vec3 out = vec3_normalise(vec3_cross(sides[1], sides[0]));
    affine back;
    if (camera->mesh->smooth && t->normal[0] != MESH_NONE &&
        affine_inverse(*to, &back))
        out = vec3_normalise(affine_normal(
            &back, mesh_normal(mesh, place->triangle, place->u, place->v)));
    vec3 origin =
        vec3_along(vec3_along(at[0], sides[0], place->u), sides[1], place->v);
    return (struct ray){ vec3_along(origin, out, camera->location.z),
                         camera->direction.z < 0 ? vec3_negate(out) : out };
}

static bool place_number(const struct camera_mesh_part *part, size_t number,
                         struct mesh_place *place)
{
    *place = (struct mesh_place){ part, number, 1 / 3.0, 1 / 3.0 };
    return number < part->mesh->triangle_count;
}

static bool place_in_sum(const struct camera_mesh *mesh, size_t number,
                         struct mesh_place *place)
{
    for (int i = 0; i < mesh->count; i++) {
        if (place_number(&mesh->parts[i], number, place))
            return true;
        number -= mesh->parts[i].mesh->triangle_count;
    }
    return false;
}

/* ---- by the triangles' own coordinates ---- */

struct uv_search {
    const struct mesh *mesh;
    vec3 at;
    size_t triangle;
    double u, v;
    bool found;
};

/* The triangle that was written first. */
static bool uv_visit(void *context, size_t item)
{
    struct uv_search *search = context;
    const struct mesh *mesh = search->mesh;
    const uint32_t *face = mesh->uv_faces[item];
    const double *a = mesh->uvs[face[0]], *b = mesh->uvs[face[1]];
    const double *c = mesh->uvs[face[2]];
    double bx = b[0] - a[0], by = b[1] - a[1], cx = c[0] - a[0];
    double cy = c[1] - a[1], x = search->at.x - a[0], y = search->at.y - a[1];
    double area = bx * cy - by * cx;
    double u = (x * cy - y * cx) / area, v = (bx * y - by * x) / area;
    if (!(u >= 0 && v >= 0 && u + v <= 1) ||
        (search->found && item > search->triangle))
        return false;
    search->triangle = item;
    search->u = u;
    search->v = v;
    search->found = true;
    return false;
}

static bool place_by_uv(const struct camera_mesh *mesh, double u, double v,
                        struct mesh_place *place)
{
    struct uv_search search = { .mesh = mesh->parts[0].mesh,
                                .at = { u, v, 0 } };
    if (mesh->tree)
        box_tree_box(mesh->tree, (struct box3){ search.at, search.at },
                     uv_visit, &search);
    *place = (struct mesh_place){ &mesh->parts[0], search.triangle, search.u,
                                  search.v };
    return search.found;
}

/* ---- of a pixel ---- */

static bool mesh_place(const struct camera *camera, double x, double y, int ray,
                       struct mesh_place *place)
{
    const struct camera_mesh *mesh = camera->mesh;
    int width = camera->pixels[0], height = camera->pixels[1];
    int column = (int)floor((x + 0.5) * width);
    int row = (int)floor((0.5 - y) * height);
    if (column < 0 || row < 0 || column >= width || row >= height)
        return false;
    if (mesh->distribution == CAMERA_UV)
        return place_by_uv(mesh, (double)column / width,
                           1 - (row > 0 ? row : 0.5) / height, place);
    row -= row > 0;
    size_t number = (size_t)row * (size_t)width + (size_t)column;
    if (mesh->distribution == CAMERA_SUM)
        return place_in_sum(mesh, number, place);
    int part = ray;
    if (mesh->distribution == CAMERA_ROW) {
        int share = width / mesh->count > 0 ? width / mesh->count : 1;
        part = column / share;
        part = part < mesh->count ? part : mesh->count - 1;
        number = (size_t)row * (size_t)share + (size_t)column;
    }
    return place_number(&mesh->parts[part], number, place);
}

static bool mesh_sees(const struct camera *camera, double x, double y)
{
    struct mesh_place place;
    for (int i = 0; i < camera->rays; i++)
        if (mesh_place(camera, x, y, i, &place))
            return true;
    return false;
}

static bool mesh_pixel_ray(const struct camera *camera, double x, double y,
                           int i, struct ray *ray)
{
    struct mesh_place place;
    if (!mesh_place(camera, x, y, i, &place))
        return false;
    *ray = place_ray(camera, &place);
    return true;
}

/* The first of the pixel's; of one that has none, one that nobody follows. */
static struct ray mesh_ray(const struct camera *camera, double x, double y)
{
    struct ray ray = { camera->location, { 0, 0, 1 } };
    for (int i = 0; i < camera->rays; i++)
        if (mesh_pixel_ray(camera, x, y, i, &ray))
            break;
    return ray;
}

const struct camera_kind mesh_camera = {
    .name = "mesh_camera",
    .help = "a ray from each triangle of a mesh",
    .lines = CAMERA_SCATTERED,
    .sees = mesh_sees,
    .ray = mesh_ray,
    .pixel_ray = mesh_pixel_ray,
};
