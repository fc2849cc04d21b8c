/* bicubic_patch{}: a surface over 4 x 4 points, as a mesh. */
#include "parse/mesh_builder.h"
#include "parse/rules.h"
#include "parse/tables.h"

enum {
    PATCH_STEPS_LIMIT = 10, /* halvings: 2^20 squares */
    PATCH_SIDE = 4,
};

struct bicubic {
    int type, u_steps, v_steps;
    double flatness;
    double uv[4][2]; /* of the corners, by turns */
    vec3 points[PATCH_SIDE][PATCH_SIDE];
    const affine *transform; /* its own: flatness is measured after it */
    vec3 pinched; /* the normal where a side is drawn together to a point */
};

const struct field bicubic_fields[] = {
    { "type", FIELD_INTEGER, offsetof(struct bicubic, type), 0, 0,
      "0 or 1: how POV-Ray stores it" },
    { "flatness", FIELD_FLOAT, offsetof(struct bicubic, flatness), 0, 0,
      "a part that is so flat is not halved; 0: all are" },
    { "u_steps", FIELD_INTEGER, offsetof(struct bicubic, u_steps), 0, 0,
      "halvings along a row" },
    { "v_steps", FIELD_INTEGER, offsetof(struct bicubic, v_steps), 0, 0,
      "halvings along a row" },
    { NULL },
};

/* The curve of four points and its slope at t (Bernstein's polynomials). */
static vec3 bezier_point(const vec3 p[PATCH_SIDE], double t, vec3 *slope)
{
    vec3 a = vec3_mix(p[0], p[1], t), b = vec3_mix(p[1], p[2], t);
    vec3 c = vec3_mix(p[2], p[3], t);
    vec3 d = vec3_mix(a, b, t), e = vec3_mix(b, c, t);
    *slope = vec3_scale(vec3_sub(e, d), 3);
    return vec3_mix(d, e, t);
}

static void bicubic_vertex(struct parser *p, struct mesh_builder *b,
                           const struct bicubic *patch, double u, double v)
{
    vec3 row[PATCH_SIDE], slopes[PATCH_SIDE], along, across;
    for (int i = 0; i < PATCH_SIDE; i++)
        row[i] = bezier_point(patch->points[i], v, &slopes[i]);
    vec3 point = bezier_point(row, u, &along);
    vec3 unused, slope = bezier_point(slopes, u, &unused);
    across = slope;
    double *uv = *ARRAY_PUSH(p->scene_arena, &b->uvs);
    for (int k = 0; k < 2; k++)
        uv[k] = (1 - u) * ((1 - v) * patch->uv[0][k] + v * patch->uv[1][k]) +
                u * (v * patch->uv[2][k] + (1 - v) * patch->uv[3][k]);
    vec3 normal = vec3_cross(along, across);
    if (!(vec3_length(normal) > 0))
        normal = patch->pinched;
    *ARRAY_PUSH(p->scene_arena, &b->vertices) = point;
    *ARRAY_PUSH(p->scene_arena, &b->normals) = normal;
}

/* Where a side is drawn together to a point every other one is none. */
static void bicubic_triangle(struct parser *p, struct mesh_builder *b,
                             const uint32_t corners[3])
{
    const vec3 *at = b->vertices.items;
    if (mesh_degenerate(at[corners[0]], at[corners[1]], at[corners[2]]))
        return;
    struct mesh_triangle t = { .texture = MESH_NONE };
    memcpy(t.vertex, corners, sizeof t.vertex);
    memcpy(t.normal, corners, sizeof t.normal);
    *ARRAY_PUSH(p->scene_arena, &b->triangles) = t;
    mesh_add_uv_face(p, b, t.vertex);
}

static void bicubic_build(struct parser *p, struct mesh_builder *b,
                          const struct bicubic *patch)
{
    uint32_t rows = 1U << patch->u_steps, columns = 1U << patch->v_steps;
    for (uint32_t i = 0; i <= rows; i++)
        for (uint32_t j = 0; j <= columns; j++)
            bicubic_vertex(p, b, patch, (double)i / rows, (double)j / columns);
    for (uint32_t i = 0; i < rows; i++) {
        for (uint32_t j = 0; j < columns; j++) {
            uint32_t a = i * (columns + 1) + j, c = a + columns + 1;
            const uint32_t corners[2][3] = { { a, c, c + 1 },
                                             { a, c + 1, a + 1 } };
            for (int k = 0; k < 2; k++)
                bicubic_triangle(p, b, corners[k]);
        }
    }
}

/* ---- halved no further than flatness asks (measured) ---- */

/* A part of the patch: its control points and its place. */
struct patch_part {
    vec3 points[PATCH_SIDE][PATCH_SIDE];
    double from[2], to[2]; /* of u, by rows, and v */
    int depth;
};

/* The halves of a curve (de Casteljau). */
static void curve_halves(const vec3 p[PATCH_SIDE], vec3 low[PATCH_SIDE],
                         vec3 high[PATCH_SIDE])
{
    vec3 a = vec3_mix(p[0], p[1], 0.5), b = vec3_mix(p[1], p[2], 0.5);
    vec3 c = vec3_mix(p[2], p[3], 0.5);
    vec3 d = vec3_mix(a, b, 0.5), e = vec3_mix(b, c, 0.5);
    vec3 middle = vec3_mix(d, e, 0.5);
    const vec3 first[PATCH_SIDE] = { p[0], a, d, middle };
    const vec3 second[PATCH_SIDE] = { middle, e, c, p[3] };
    memcpy(low, first, sizeof first);
    memcpy(high, second, sizeof second);
}

static void part_halves(const struct patch_part *part, int axis,
                        struct patch_part halves[2])
{
    halves[0] = halves[1] = *part;
    halves[0].to[axis] = halves[1].from[axis] =
        0.5 * (part->from[axis] + part->to[axis]);
    for (int i = 0; i < PATCH_SIDE; i++) {
        vec3 curve[PATCH_SIDE], low[PATCH_SIDE], high[PATCH_SIDE];
        for (int j = 0; j < PATCH_SIDE; j++)
            curve[j] = axis == 0 ? part->points[j][i] : part->points[i][j];
        curve_halves(curve, low, high);
        for (int j = 0; j < PATCH_SIDE; j++) {
            *(axis == 0 ? &halves[0].points[j][i] : &halves[0].points[i][j]) =
                low[j];
            *(axis == 0 ? &halves[1].points[j][i] : &halves[1].points[i][j]) =
                high[j];
        }
    }
}

/* Whether all its points are so near to the plane of three corners; of others
 * if one of its sides is drawn together to a point. */
static bool part_is_flat(const struct patch_part *part,
                         const struct bicubic *patch)
{
    vec3 side[PATCH_SIDE][PATCH_SIDE]; /* from the first corner */
    for (int i = 0; i < PATCH_SIDE; i++)
        for (int j = 0; j < PATCH_SIDE; j++)
            side[i][j] = affine_direction(
                patch->transform,
                vec3_sub(part->points[i][j], part->points[0][0]));
    vec3 across = side[PATCH_SIDE - 1][PATCH_SIDE - 1];
    vec3 n = vec3_cross(side[PATCH_SIDE - 1][0], across);
    if (!(vec3_length(n) > 0))
        n = vec3_cross(across, side[0][PATCH_SIDE - 1]);
    double length = vec3_length(n);
    if (!(length > 0))
        return false;
    for (int i = 0; i < PATCH_SIDE; i++)
        for (int j = 0; j < PATCH_SIDE; j++)
            if (fabs(vec3_dot(side[i][j], n)) > patch->flatness * length)
                return false;
    return true;
}

static void part_emit(struct parser *p, struct mesh_builder *b,
                      const struct bicubic *patch,
                      const struct patch_part *part)
{
    uint32_t first = (uint32_t)b->vertices.count;
    bicubic_vertex(p, b, patch, part->from[0], part->from[1]);
    bicubic_vertex(p, b, patch, part->to[0], part->from[1]);
    bicubic_vertex(p, b, patch, part->to[0], part->to[1]);
    bicubic_vertex(p, b, patch, part->from[0], part->to[1]);
    for (uint32_t k = 1; k <= 2; k++) {
        const uint32_t corners[3] = { first, first + k, first + k + 1 };
        bicubic_triangle(p, b, corners);
    }
}

static void part_build(struct parser *p, struct mesh_builder *b,
                       const struct bicubic *patch,
                       const struct patch_part *part)
{
    struct patch_part halves[2], quarters[2];
    bool rows = part->depth < patch->u_steps;
    bool columns = part->depth < patch->v_steps;
    if ((!rows && !columns) || part_is_flat(part, patch)) {
        part_emit(p, b, patch, part);
        return;
    }
    part_halves(part, rows ? 0 : 1, halves);
    for (int i = 0; i < 2; i++) {
        halves[i].depth++;
        if (!rows || !columns) {
            part_build(p, b, patch, &halves[i]);
            continue;
        }
        part_halves(&halves[i], 1, quarters);
        part_build(p, b, patch, &quarters[0]);
        part_build(p, b, patch, &quarters[1]);
    }
}

/* x, once the patch is where it will be; other normals are those of turned
 * points, which point to the other side if it is mirrored (measured). */
static vec3 patch_pinched(const affine *transform)
{
    vec3 x = affine_normal(transform, vec3_make(1, 0, 0));
    return affine_determinant(*transform) < 0 ? vec3_negate(x) : x;
}

/* Without flatness all parts are as small, and share their corners. */
static void bicubic_surface(struct parser *p, struct mesh_builder *b,
                            const struct bicubic *patch)
{
    struct patch_part whole = { .to = { 1, 1 } };
    if (!(patch->flatness > 0)) {
        bicubic_build(p, b, patch);
        return;
    }
    memcpy(whole.points, patch->points, sizeof whole.points);
    part_build(p, b, patch, &whole);
}

/* patch_uv = "uv_vectors" vector [","] vector [","] vector [","] vector . */
static bool parse_patch_uv(struct parser *p, struct bicubic *patch)
{
    stream_next(p);
    for (int i = 0; i < 4; i++) {
        double uv[5];
        if (!parse_components(p, uv, 2))
            return false;
        memcpy(patch->uv[i], uv, sizeof patch->uv[i]);
        accept(p, TOKEN_COMMA);
    }
    return true;
}

/* patch_points = vector {[","] vector} .
 * Four rows of four. */
static bool parse_patch_points(struct parser *p, struct bicubic *patch)
{
    for (int i = 0; i < PATCH_SIDE * PATCH_SIDE; i++) {
        accept(p, TOKEN_COMMA);
        if (stream_peek(p)->kind == TOKEN_RBRACE)
            return error_at(p, stream_span(p), NULL,
                            "a bicubic_patch has %d points, here are %d",
                            PATCH_SIDE * PATCH_SIDE, i);
        if (!parse_vector(p, &patch->points[i / PATCH_SIDE][i % PATCH_SIDE]))
            return false;
    }
    return true;
}

/* patch_setting = "type" float | "flatness" float | "u_steps" float
 *               | "v_steps" float . */
static bool parse_patch_settings(struct parser *p, struct bicubic *patch)
{
    const struct field *field;
    struct span span = stream_span(p);
    while ((field = accept_field(p, bicubic_fields)) != NULL) {
        if (!parse_field(p, field, patch))
            return false;
        accept(p, TOKEN_COMMA);
    }
    if (patch->u_steps >= 0 && patch->u_steps <= PATCH_STEPS_LIMIT &&
        patch->v_steps >= 0 && patch->v_steps <= PATCH_STEPS_LIMIT)
        return true;
    return error_at(p, span_join(span, p->last_span), NULL,
                    "u_steps and v_steps are 0 to %d", PATCH_STEPS_LIMIT);
}

/* bicubic_patch = "bicubic_patch" "{" {patch_setting [","]} [patch_uv]
 *                 patch_points {modifier} "}" . */
bool parse_bicubic_patch(struct parser *p, struct object **out)
{
    struct bicubic patch = { .u_steps = 3,
                             .v_steps = 3,
                             .uv = { { 0, 0 }, { 1, 0 }, { 1, 1 }, { 0, 1 } } };
    struct mesh_builder builder = { .vertices = { .count = 0 } };
    struct mesh *mesh = ARENA_NEW(p->scene_arena, struct mesh);
    struct span open;
    stream_next(p);
    *out = object_new(p->scene_arena, OBJECT_MESH, p->last_span);
    (*out)->mesh = mesh;
    struct modifiers m = { .object = *out, .block = "bicubic_patch" };
    if (!block_begin(p, &open))
        return false;
    bool ok = parse_patch_settings(p, &patch) &&
              (stream_keyword(p) != KEYWORD_UV_VECTORS ||
               parse_patch_uv(p, &patch)) &&
              parse_patch_points(p, &patch) && parse_modifiers(p, &m);
    if (!block_end(p, open, ok))
        return false;
    patch.transform = (*out)->maps->own;
    patch.pinched = patch_pinched((*out)->maps->own);
    bicubic_surface(p, &builder, &patch);
    mesh->mapped = mesh->turned = true;
    mesh_take(p, mesh, &builder);
    mesh_end(p, *out, mesh);
    return true;
}
