/* Height fields as meshes: see height_field.h. How squares are split and what
 * the smooth normals are was measured with POV-Ray 3.7. */
#include "scene/height_field.h"

#include "base/array.h"

/* POV-Ray's unit of height, by which its normals are made and rounded. */
static const double unit = 65536;

struct builder {
    const struct height_field *field;
    struct arena *arena;
    struct {
        vec3 *items;
        size_t count, capacity;
    } vertices, normals;
    struct {
        struct mesh_triangle *items;
        size_t count, capacity;
    } triangles;
};

static double height_at(const struct height_field *field, int x, int y)
{
    return field->heights[(size_t)y * (size_t)field->width + (size_t)x];
}

/* The mean of the unit normals of the squares around, each as if it had these
 * two slopes, where a step is 1 and heights are in units: steep places all but
 * lie flat. */
static vec3 height_normal(const struct height_field *field, int x, int y)
{
    double here = height_at(field, x, y);
    vec3 sum = { 0, 0, 0 };
    for (int i = -1; i <= 1; i += 2) {
        for (int j = -1; j <= 1; j += 2) {
            if (x + i < 0 || x + i >= field->width || y + j < 0 ||
                y + j >= field->height)
                continue;
            double along = height_at(field, x + i, y) - here;
            double across = height_at(field, x, y + j) - here;
            sum = vec3_add(sum, vec3_normalise(vec3_make(-along * i * unit, 1,
                                                         across * j * unit)));
        }
    }
    return vec3_normalise(sum);
}

/* As it is kept, in 16 bits a number, then in the field's own proportions. */
static vec3 height_normal_kept(const struct height_field *field, int x, int y)
{
    vec3 n = vec3_scale(height_normal(field, x, y), 32767);
    n = vec3_make(trunc(n.x), trunc(n.y), trunc(n.z));
    return vec3_normalise(vec3_make(n.x * (field->width - 1), n.y * unit,
                                    n.z * (field->height - 1)));
}

static void builder_points(struct builder *b)
{
    const struct height_field *field = b->field;
    size_t count = (size_t)field->width * (size_t)field->height;
    ARRAY_RESERVE(b->arena, &b->vertices, count);
    if (field->smooth)
        ARRAY_RESERVE(b->arena, &b->normals, count);
    for (int y = 0; y < field->height; y++) {
        for (int x = 0; x < field->width; x++) {
            vec3 point = { (double)x / (field->width - 1),
                           height_at(field, x, y),
                           1 - (double)y / (field->height - 1) };
            *ARRAY_PUSH(b->arena, &b->vertices) = point;
            if (field->smooth)
                *ARRAY_PUSH(b->arena, &b->normals) =
                    height_normal_kept(field, x, y);
        }
    }
}

/* The normals are those of the grid, between which every face of a smooth
 * field is blended, also where the three at its corners agree. */
static void builder_push(struct builder *b, const uint32_t corner[3],
                         uint32_t i, uint32_t j, uint32_t k)
{
    struct mesh_triangle triangle = { { i, j, k },
                                      { corner[0], corner[1], corner[2] },
                                      MESH_NONE };
    if (!b->field->smooth)
        triangle.normal[0] = MESH_NONE;
    *ARRAY_PUSH(b->arena, &b->triangles) = triangle;
}

/* The point where the line between two meets the water. */
static uint32_t builder_shore(struct builder *b, uint32_t i, uint32_t j)
{
    vec3 from = b->vertices.items[i], to = b->vertices.items[j];
    double t = (b->field->water_level - from.y) / (to.y - from.y);
    vec3 point = vec3_mix(from, to, t);
    point.y = b->field->water_level;
    *ARRAY_PUSH(b->arena, &b->vertices) = point;
    return (uint32_t)(b->vertices.count - 1);
}

/* The part of the triangle above water: nothing, a triangle or a quadrangle. */
static void builder_triangle(struct builder *b, const uint32_t corner[3])
{
    uint32_t outline[4];
    int count = 0;
    for (int i = 0; i < 3; i++) {
        uint32_t here = corner[i], next = corner[(i + 1) % 3];
        bool dry = b->vertices.items[here].y >= b->field->water_level;
        if (dry)
            outline[count++] = here;
        if (dry != (b->vertices.items[next].y >= b->field->water_level))
            outline[count++] = builder_shore(b, here, next);
    }
    for (int i = 2; i < count; i++)
        builder_push(b, corner, outline[0], outline[i - 1], outline[i]);
}

void height_field_build(struct arena *arena, const struct height_field *field,
                        struct mesh *mesh)
{
    struct builder b = { .field = field, .arena = arena };
    uint32_t width = (uint32_t)field->width;
    builder_points(&b);
    ARRAY_RESERVE(arena, &b.triangles,
                  2 * (size_t)(field->width - 1) * (size_t)(field->height - 1));
    for (uint32_t y = 0; y + 1 < (uint32_t)field->height; y++) {
        for (uint32_t x = 0; x + 1 < width; x++) {
            uint32_t i = y * width + x;
            builder_triangle(&b, (uint32_t[]){ i, i + width + 1, i + 1 });
            builder_triangle(&b, (uint32_t[]){ i, i + width, i + width + 1 });
        }
    }
    mesh->columns = field->smooth ? field->width : 0;
    mesh->rows = field->height;
    mesh->vertices = b.vertices.items;
    mesh->vertex_count = b.vertices.count;
    mesh->normals = b.normals.items;
    mesh->normal_count = b.normals.count;
    mesh->triangles = b.triangles.items;
    mesh->triangle_count = b.triangles.count;
    /* What is under it is its inside. */
    mesh->inside_vector = vec3_make(0, 1, 0);
    mesh->beyond = true;
}
