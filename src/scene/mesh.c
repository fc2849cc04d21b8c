/* Triangle meshes: see mesh.h. */
#include "scene/mesh.h"

bool mesh_degenerate(vec3 a, vec3 b, vec3 c)
{
    vec3 face = vec3_cross(vec3_sub(b, a), vec3_sub(c, a));
    double square = vec3_dot(face, face);
    return !(square > 0) || !isfinite(square);
}

static bool triangle_valid(const struct mesh *mesh,
                           const struct mesh_triangle *triangle)
{
    const uint32_t *v = triangle->vertex;
    for (int i = 0; i < 3; i++)
        if (v[i] >= mesh->vertex_count)
            return false;
    return !mesh_degenerate(mesh->vertices[v[0]], mesh->vertices[v[1]],
                            mesh->vertices[v[2]]);
}

/* Three equal normals don't smooth anything: POV-Ray then takes the face's
 * own. Nor does a normal of no length. */
static void triangle_flatten(const struct mesh *mesh,
                             struct mesh_triangle *triangle)
{
    const uint32_t *n = triangle->normal;
    vec3 normal[3];
    bool usable = true;
    for (int i = 0; i < 3 && usable; i++) {
        usable = n[i] < mesh->normal_count;
        if (usable)
            normal[i] = mesh->normals[n[i]];
        usable = usable && vec3_dot(normal[i], normal[i]) > 0;
    }
    if (usable)
        for (int i = 1; i < 3; i++)
            if (vec3_length(vec3_sub(normal[i], normal[0])) > 1e-9)
                return;
    triangle->normal[0] = MESH_NONE;
}

struct box3 mesh_triangle_box(const struct mesh *mesh, size_t triangle)
{
    struct box3 box = box3_empty();
    for (int k = 0; k < 3; k++)
        box =
            box3_add(box, mesh->vertices[mesh->triangles[triangle].vertex[k]]);
    return box;
}

struct box3 mesh_told(const struct mesh *mesh, const affine *place)
{
    struct box3 box = box3_empty();
    if (!mesh->lone)
        return affine_box(place, mesh->bounds);
    for (size_t i = 0; i < mesh->vertex_count; i++)
        box = box3_add(box, affine_point(place, mesh->vertices[i]));
    return box;
}

static struct box3 mesh_find_bounds(const struct mesh *mesh)
{
    struct box3 box = box3_empty();
    vec3 *low = &box.low, *high = &box.high;
    for (size_t i = 0; i < 3 * mesh->triangle_count; i++) {
        vec3 p = mesh->vertices[mesh->triangles[i / 3].vertex[i % 3]];
        /* Plain comparisons: fmin is a call each time. */
        *low =
            vec3_make(p.x < low->x ? p.x : low->x, p.y < low->y ? p.y : low->y,
                      p.z < low->z ? p.z : low->z);
        *high = vec3_make(p.x > high->x ? p.x : high->x,
                          p.y > high->y ? p.y : high->y,
                          p.z > high->z ? p.z : high->z);
    }
    return box;
}

size_t mesh_prepare(struct mesh *mesh)
{
    size_t kept = 0, given = mesh->triangle_count;
    for (size_t i = 0; i < mesh->normal_count; i++)
        mesh->normals[i] = vec3_normalise(mesh->normals[i]);
    for (size_t i = 0; i < given; i++) {
        struct mesh_triangle triangle = mesh->triangles[i];
        if (!triangle_valid(mesh, &triangle))
            continue;
        if (triangle.normal[0] != MESH_NONE)
            triangle_flatten(mesh, &triangle);
        if (mesh->uv_faces)
            memmove(mesh->uv_faces[kept], mesh->uv_faces[i],
                    sizeof *mesh->uv_faces);
        mesh->triangles[kept++] = triangle;
    }
    mesh->triangle_count = kept;
    mesh->bounds = mesh_find_bounds(mesh);
    return given - kept;
}

static bool vertex_before(vec3 a, vec3 b)
{
    return a.x != b.x ? a.x < b.x : a.y != b.y ? a.y < b.y : a.z < b.z;
}

/* On which side of the edge a-b (seen from the ray's origin) the ray passes.
 * Swapping a and b changes the sign and not a bit else, and a ray exactly
 * through the edge is on one side of it, so that of two triangles that share an
 * edge one is hit. */
static double edge_side(vec3 a, vec3 b, vec3 direction, bool *positive)
{
    double side = vec3_dot(direction, vec3_cross(a, b));
    *positive = side > 0 || (side == 0 && vertex_before(a, b));
    return side;
}

bool mesh_intersect(const struct mesh *mesh, size_t index,
                    const struct ray *ray, struct hit *hit)
{
    const uint32_t *vertex = mesh->triangles[index].vertex;
    vec3 a = vec3_sub(mesh->vertices[vertex[0]], ray->origin);
    vec3 b = vec3_sub(mesh->vertices[vertex[1]], ray->origin);
    vec3 c = vec3_sub(mesh->vertices[vertex[2]], ray->origin);
    bool positive[3];
    double side[3] = { edge_side(b, c, ray->direction, &positive[0]),
                       edge_side(c, a, ray->direction, &positive[1]),
                       edge_side(a, b, ray->direction, &positive[2]) };
    if (positive[0] != positive[1] || positive[1] != positive[2])
        return false;
    vec3 normal = vec3_cross(vec3_sub(b, a), vec3_sub(c, a));
    double slope = vec3_dot(normal, ray->direction);
    double sum = side[0] + side[1] + side[2];
    if (slope == 0 || sum == 0)
        return false;
    *hit = (struct hit){ vec3_dot(normal, a) / slope, (int)index, side[1] / sum,
                         side[2] / sum };
    return true;
}

double mesh_distance(const struct mesh *mesh, size_t index,
                     const struct ray *ray)
{
    const uint32_t *vertex = mesh->triangles[index].vertex;
    vec3 a = vec3_sub(mesh->vertices[vertex[0]], ray->origin);
    vec3 normal = mesh_face(mesh, index);
    return vec3_dot(normal, a) / vec3_dot(normal, ray->direction);
}

void mesh_refine(const struct mesh *mesh, size_t index, const struct ray *ray,
                 struct hit *hit)
{
    const uint32_t *vertex = mesh->triangles[index].vertex;
    vec3 a = vec3_sub(mesh->vertices[vertex[0]], ray->origin);
    vec3 ab = vec3_sub(mesh->vertices[vertex[1]], mesh->vertices[vertex[0]]);
    vec3 ac = vec3_sub(mesh->vertices[vertex[2]], mesh->vertices[vertex[0]]);
    vec3 normal = vec3_cross(ab, ac);
    double t = vec3_dot(normal, a) / vec3_dot(normal, ray->direction);
    vec3 p = vec3_sub(vec3_scale(ray->direction, t), a);
    double area = vec3_dot(normal, normal);
    *hit =
        (struct hit){ t, (int)index, vec3_dot(vec3_cross(p, ac), normal) / area,
                      vec3_dot(vec3_cross(ab, p), normal) / area };
}

void mesh_uv(const struct mesh *mesh, size_t index, vec3 point, double uv[2])
{
    const uint32_t *p = mesh->triangles[index].vertex;
    const uint32_t *corner = mesh->uv_faces ? mesh->uv_faces[index] : NULL;
    uv[0] = uv[1] = 0;
    if (!corner || corner[0] == MESH_NONE)
        return;
    vec3 a = mesh->vertices[p[0]];
    vec3 ab = vec3_sub(mesh->vertices[p[1]], a);
    vec3 ac = vec3_sub(mesh->vertices[p[2]], a);
    vec3 normal = vec3_cross(ab, ac), to = vec3_sub(point, a);
    double area = vec3_dot(normal, normal);
    double s = vec3_dot(vec3_cross(to, ac), normal) / area;
    double t = vec3_dot(vec3_cross(ab, to), normal) / area;
    for (int k = 0; k < 2; k++)
        uv[k] = (1 - s - t) * mesh->uvs[corner[0]][k] +
                s * mesh->uvs[corner[1]][k] + t * mesh->uvs[corner[2]][k];
}

vec3 mesh_face(const struct mesh *mesh, size_t index)
{
    const uint32_t *p = mesh->triangles[index].vertex;
    vec3 a = mesh->vertices[p[0]];
    return vec3_cross(vec3_sub(mesh->vertices[p[1]], a),
                      vec3_sub(mesh->vertices[p[2]], a));
}

vec3 mesh_normal(const struct mesh *mesh, size_t index, double u, double v)
{
    const struct mesh_triangle *triangle = &mesh->triangles[index];
    const uint32_t *n = triangle->normal;
    if (n[0] == MESH_NONE)
        return mesh_face(mesh, index);
    vec3 normal = vec3_scale(mesh->normals[n[0]], 1 - u - v);
    normal = vec3_along(normal, mesh->normals[n[1]], u);
    normal = vec3_along(normal, mesh->normals[n[2]], v);
    return normal;
}
