/* mesh{}, triangle{} and smooth_triangle{}: triangles written one by one.
 * A lone triangle is a mesh of one. */
#include "parse/mesh_builder.h"
#include "parse/rules.h"
#include "parse/stream.h"
#include "parse/symbol.h"
#include "scene/object_probe.h"
#include "token/triangles.h"

/* How many of the last textures a triangle's is compared with, so that a
 * texture used by many triangles is kept once. */
enum { MESH_TEXTURE_SEARCH = 16 };

const struct field mesh_fields[] = {
    { "inside_vector", FIELD_VECTOR, offsetof(struct mesh, inside_vector), 0, 0,
      "makes the mesh solid: counts crossings in this direction" },
    { NULL },
};

static bool mesh_check_room(struct parser *p, size_t count)
{
    return count < MESH_NONE - 3 ||
           error_at(p, p->last_span, NULL, "a mesh has too many triangles");
}

static bool triangle_short(struct parser *p, int corners, bool smooth)
{
    return error_at(
        p, stream_span(p),
        smooth ? "smooth_triangle { <corner>, <normal>, <corner>, <normal>, "
                 "<corner>, <normal> }"
               : "triangle { <corner>, <corner>, <corner> }",
        "a %s has three corners%s, here %s",
        smooth ? "smooth_triangle" : "triangle",
        smooth ? ", each with its normal" : "",
        corners == 1 ? "is one" : "are two");
}

/* triangle_points = vector [","] vector [","] vector
 *                 | vector [","] vector [","] vector [","]
 *                   vector [","] vector [","] vector .
 * The second form is the smooth triangle's: point, normal, point, normal ... */
static bool parse_triangle_points(struct parser *p, struct mesh_builder *b,
                                  bool smooth)
{
    struct mesh_triangle triangle = {
        .normal = { MESH_NONE, MESH_NONE, MESH_NONE }, .texture = MESH_NONE
    };
    for (int i = 0; i < 3; i++) {
        vec3 v;
        if (i > 0)
            accept(p, TOKEN_COMMA);
        if (i > 0 && stream_peek(p)->kind == TOKEN_RBRACE)
            return triangle_short(p, i, smooth);
        if (!parse_vector(p, &v))
            return false;
        triangle.vertex[i] = (uint32_t)b->vertices.count;
        *ARRAY_PUSH(p->scene_arena, &b->vertices) = v;
        if (!smooth)
            continue;
        accept(p, TOKEN_COMMA);
        if (!parse_vector(p, &v))
            return false;
        triangle.normal[i] = (uint32_t)b->normals.count;
        *ARRAY_PUSH(p->scene_arena, &b->normals) = v;
    }
    *ARRAY_PUSH(p->scene_arena, &b->triangles) = triangle;
    return mesh_check_room(p, b->vertices.count);
}

static uint32_t mesh_texture_index(struct parser *p, struct mesh_builder *b,
                                   const struct texture *texture)
{
    size_t count = b->textures.count;
    size_t first =
        count > MESH_TEXTURE_SEARCH ? count - MESH_TEXTURE_SEARCH : 0;
    for (size_t i = first; i < count; i++)
        if (b->textures.items[i] == texture)
            return (uint32_t)i;
    *ARRAY_PUSH(p->scene_arena, &b->textures) = texture;
    return (uint32_t)count;
}

/* What has been left out until now has none. */
static void mesh_pad_uv_faces(struct parser *p, struct mesh_builder *b,
                              size_t count)
{
    while (b->uv_faces.count < count) {
        uint32_t(*face)[3] = ARRAY_PUSH(p->scene_arena, &b->uv_faces);
        (*face)[0] = MESH_NONE;
    }
}

void mesh_add_uv_face(struct parser *p, struct mesh_builder *b,
                      const uint32_t corners[3])
{
    mesh_pad_uv_faces(p, b, b->triangles.count);
    memcpy(b->uv_faces.items[b->triangles.count - 1], corners,
           sizeof *b->uv_faces.items);
}

/* The coordinates of a triangle's corners, or of a single triangle's, which
 * POV-Ray reads and does not use. */
static bool mesh_read_uv(struct parser *p, struct mesh_builder *b)
{
    uint32_t first = (uint32_t)b->uvs.count;
    double uv[5];
    stream_next(p);
    for (int i = 0; i < 3; i++) {
        if (i > 0)
            accept(p, TOKEN_COMMA);
        if (!parse_components(p, uv, 2))
            return false;
        memcpy(*ARRAY_PUSH(p->scene_arena, &b->uvs), uv, sizeof *b->uvs.items);
    }
    mesh_add_uv_face(p, b, (uint32_t[]){ first, first + 1, first + 2 });
    return true;
}

uint32_t mesh_corner_textures(struct parser *p, struct mesh_builder *b,
                              const struct texture *const corners[3])
{
    size_t count = b->textures.count;
    if (corners[0] == corners[1] && corners[0] == corners[2])
        return mesh_texture_index(p, b, corners[0]);
    for (size_t i = count; i-- > 0 && i + MESH_TEXTURE_SEARCH >= count;) {
        const struct texture_choice *choice = b->textures.items[i]->choice;
        if (choice && choice->rule == pick_by_corners &&
            choice->entries[0].texture == corners[0] &&
            choice->entries[1].texture == corners[1] &&
            choice->entries[2].texture == corners[2])
            return (uint32_t)i;
    }
    const struct texture *all =
        texture_by_rule(p, pick_by_corners, NULL, corners, 3);
    return all ? mesh_texture_index(p, b, all) : MESH_NONE;
}

/* corner_texture = texture | TEXTURE . */
static bool parse_corner_texture(struct parser *p, const struct texture **out)
{
    const struct value *value = accept_value(p, VALUE_TEXTURE);
    if (value)
        *out = value->texture;
    else if (stream_keyword(p) != KEYWORD_TEXTURE)
        return error_expected(p, "a texture for each corner");
    return (value || parse_texture(p, out)) && (accept(p, TOKEN_COMMA), true);
}

/* corner_textures = "texture_list"
 *                   "{" corner_texture [","] corner_texture [","]
 *                   corner_texture [","] "}" . */
static bool parse_corner_textures(struct parser *p, struct mesh_builder *b)
{
    const struct texture *corners[3];
    struct span open;
    stream_next(p);
    if (!block_begin(p, &open))
        return false;
    bool ok = true;
    for (int i = 0; i < 3 && ok; i++)
        ok = parse_corner_texture(p, &corners[i]);
    if (!block_end(p, open, ok))
        return false;
    uint32_t index = mesh_corner_textures(p, b, corners);
    b->triangles.items[b->triangles.count - 1].texture = index;
    return index != MESH_NONE;
}

/* mesh_triangle_item = texture | corner_textures
 *                    | "uv_vectors" vector [","] vector [","] vector . */
static bool parse_mesh_triangle_item(struct parser *p, struct mesh_builder *b)
{
    const struct texture *texture;
    if (stream_keyword(p) == KEYWORD_UV_VECTORS)
        return mesh_read_uv(p, b);
    if (stream_keyword(p) == KEYWORD_TEXTURE_LIST)
        return parse_corner_textures(p, b);
    if (stream_keyword(p) != KEYWORD_TEXTURE)
        return error_unknown_item(p, "triangle", NULL);
    if (!parse_texture(p, &texture))
        return false;
    b->triangles.items[b->triangles.count - 1].texture =
        mesh_texture_index(p, b, texture);
    return true;
}

static bool mesh_triangle_body(struct parser *p, struct mesh_builder *b,
                               bool smooth)
{
    if (!parse_triangle_points(p, b, smooth))
        return false;
    while (stream_peek(p)->kind != TOKEN_RBRACE)
        if (!parse_mesh_triangle_item(p, b))
            return false;
    return true;
}

/* mesh_triangle = ( "triangle" | "smooth_triangle" )
 *                 "{" triangle_points {mesh_triangle_item} "}" . */
static bool parse_mesh_triangle(struct parser *p, struct mesh_builder *b)
{
    struct span open;
    bool smooth = stream_next(p).word->keyword == KEYWORD_SMOOTH_TRIANGLE;
    return block_begin(p, &open) &&
           block_end(p, open, mesh_triangle_body(p, b, smooth));
}

/* The texture of triangle i of the run: most often a name that stands for one;
 * anything else is read as if it stood alone. */
static bool run_texture(struct parser *p, const struct triangle_run *run,
                        size_t i, struct span span,
                        const struct texture **texture)
{
    const struct triangle_paint *paint = &run->paints[i];
    const struct symbol *symbol = symbol_lookup(p, paint->texture);
    if (symbol && symbol->value.kind == VALUE_TEXTURE && !symbol->deprecated) {
        *texture = symbol->value.texture;
        return true;
    }
    const struct token_list *list =
        lexer_run_part(p->arena, p->words, span.source,
                       span.offset + paint->start, span.offset + paint->end);
    if (!stream_push_range(p, list, 0, list->count - 1, NULL, span_none()))
        return false;
    bool ok = parse_texture(p, texture);
    stream_pop_range(p);
    return ok;
}

/* Room for a run's share of a list, which still grows by doubling. */
#define RUN_RESERVE(p, list, more)                                             \
    ((list)->count + (more) > (list)->capacity                                 \
         ? (void)ARRAY_RESERVE((p)->scene_arena, (list),                       \
                               (list)->count * 2 + (more))                     \
         : (void)0)

static void run_add_points(struct parser *p, struct mesh_builder *b,
                           const struct triangle_run *run)
{
    const double(*from)[3] = (const double(*)[3])run->vectors;
    size_t count = 3 * run->count;
    RUN_RESERVE(p, &b->vertices, count);
    if (run->smooth)
        RUN_RESERVE(p, &b->normals, count);
    for (size_t i = 0; i < count; i++, from++) {
        *ARRAY_PUSH(p->scene_arena, &b->vertices) =
            vec3_make((*from)[0], (*from)[1], (*from)[2]);
        if (!run->smooth)
            continue;
        from++;
        *ARRAY_PUSH(p->scene_arena, &b->normals) =
            vec3_make((*from)[0], (*from)[1], (*from)[2]);
    }
}

/* Triangles that the lexer cut at once. */
static bool mesh_take_run(struct parser *p, struct mesh_builder *b)
{
    const struct triangle_run *run = stream_next(p).triangles;
    struct span span = p->last_span;
    uint32_t vertex = (uint32_t)b->vertices.count;
    uint32_t normal = (uint32_t)b->normals.count;
    if (!mesh_check_room(p, b->vertices.count + 3 * run->count))
        return false;
    run_add_points(p, b, run);
    RUN_RESERVE(p, &b->triangles, run->count);
    for (size_t i = 0; i < run->count; i++) {
        struct mesh_triangle triangle = {
            .normal = { MESH_NONE, MESH_NONE, MESH_NONE }, .texture = MESH_NONE
        };
        const struct texture *texture;
        for (uint32_t k = 0; k < 3; k++) {
            triangle.vertex[k] = vertex++;
            if (run->smooth)
                triangle.normal[k] = normal++;
        }
        if (run->paints[i].texture) {
            if (!run_texture(p, run, i, span, &texture))
                return false;
            triangle.texture = mesh_texture_index(p, b, texture);
        }
        *ARRAY_PUSH(p->scene_arena, &b->triangles) = triangle;
    }
    return true;
}

static struct object *mesh_object(struct parser *p, struct span span,
                                  struct mesh **mesh)
{
    struct object *object = object_new(p->scene_arena, OBJECT_MESH, span);
    *mesh = ARENA_NEW(p->scene_arena, struct mesh);
    object->mesh = *mesh;
    object->patch = true;
    return object;
}

void mesh_end(struct parser *p, struct object *object, struct mesh *mesh)
{
    mesh->solid = vec3_length(mesh->inside_vector) > 0;
    object->patch = !mesh->solid;
    size_t removed = mesh_prepare(mesh);
    if (mesh->triangle_count >= MESH_PROBES_LEAST)
        mesh->probes = ARENA_NEW(p->scene_arena, struct mesh_probes);
    if (removed)
        warning_at(p, object->span, NULL, "%zu degenerate triangle%s left out",
                   removed, removed > 1 ? "s" : "");
}

void mesh_take(struct parser *p, struct mesh *mesh, struct mesh_builder *b)
{
    if (b->uv_faces.count)
        mesh_pad_uv_faces(p, b, b->triangles.count);
    mesh->uvs = b->uvs.items;
    mesh->uv_faces = b->uv_faces.items;
    mesh->vertices = b->vertices.items;
    mesh->vertex_count = b->vertices.count;
    mesh->normals = b->normals.items;
    mesh->normal_count = b->normals.count;
    mesh->triangles = b->triangles.items;
    mesh->triangle_count = b->triangles.count;
    mesh->textures = b->textures.items;
    mesh->texture_count = b->textures.count;
}

static void mesh_build(struct parser *p, struct object *object,
                       struct mesh *mesh, struct mesh_builder *b)
{
    mesh_take(p, mesh, b);
    mesh_end(p, object, mesh);
}

/* A triangle with a texture in its own block is a mesh's; a lone triangle's
 * textures are the object's. */
static bool triangle_read(struct parser *p, struct object **out,
                          const char *block, bool smooth)
{
    struct mesh_builder builder = { .vertices = { .count = 0 } };
    struct mesh *mesh;
    struct span open;
    stream_next(p);
    *out = mesh_object(p, p->last_span, &mesh);
    struct modifiers m = { .object = *out, .block = block };
    if (!block_begin(p, &open))
        return false;
    bool ok = parse_triangle_points(p, &builder, smooth);
    while (ok && stream_keyword(p) == KEYWORD_UV_VECTORS)
        ok = mesh_read_uv(p, &builder);
    ok = ok && parse_modifiers(p, &m);
    if (!block_end(p, open, ok))
        return false;
    builder.uv_faces.count = 0;
    builder.uv_faces.items = NULL;
    const affine *moved = (*out)->maps->own;
    mesh->lone = true;
    mesh->turned = moved && moved != &affine_unmoved;
    mesh_build(p, *out, mesh, &builder);
    return true;
}

/* triangle = "triangle" "{" triangle_points {modifier} "}" . */
bool parse_triangle(struct parser *p, struct object **out)
{
    return triangle_read(p, out, "triangle", false);
}

/* smooth_triangle = "smooth_triangle" "{" triangle_points {modifier} "}" . */
bool parse_smooth_triangle(struct parser *p, struct object **out)
{
    return triangle_read(p, out, "smooth_triangle", true);
}

static bool at_mesh_triangle(struct parser *p)
{
    enum keyword keyword = stream_keyword(p);
    return keyword == KEYWORD_TRIANGLE || keyword == KEYWORD_SMOOTH_TRIANGLE ||
           stream_peek(p)->kind == TOKEN_TRIANGLES;
}

/* mesh = "mesh" "{" {mesh_triangle} {"inside_vector" vector | modifier} "}" .
 */
bool parse_mesh(struct parser *p, struct object **out)
{
    struct mesh_builder builder = { .vertices = { .count = 0 } };
    struct mesh *mesh;
    struct span open;
    bool ok = true;
    stream_next(p);
    *out = mesh_object(p, p->last_span, &mesh);
    struct modifiers m = {
        .object = *out, .block = "mesh", .items = mesh_fields, .shape = mesh
    };
    if (!block_begin(p, &open))
        return false;
    while (ok && at_mesh_triangle(p))
        ok = stream_peek(p)->kind == TOKEN_TRIANGLES
                 ? mesh_take_run(p, &builder)
                 : parse_mesh_triangle(p, &builder);
    struct span behind = stream_span(p);
    ok = ok && parse_modifiers(p, &m);
    if (!block_end(p, open, ok))
        return false;
    if (builder.triangles.count == 0)
        return error_at(p, behind, "triangle { <0, 0, 0>, ... }",
                        "a mesh has at least one triangle");
    mesh->mapped = true;
    mesh_build(p, *out, mesh, &builder);
    return true;
}
