/* mesh2{}: triangles as lists of points and of indices. Programs write them
 * by the million, so lists of plain numbers are read straight from the tokens.
 */
#include "base/text.h"
#include "parse/mesh_builder.h"
#include "parse/rules.h"
#include "token/numbers.h"

struct mesh2 {
    struct mesh *mesh;
    struct mesh_builder lists;
    size_t list_textures;            /* of the texture_list */
    size_t normal_faces;             /* normal_indices read */
    const struct number_list *plain; /* the list being read, if cut as one */
    size_t plain_next;
};

static bool plain_count(struct parser *p, const struct number_list *list,
                        size_t *count)
{
    *count = list->count;
    return list->said == (double)list->count ||
           error_at(p, p->last_span, arena_printf(p->arena, "%zu", list->count),
                    "the list should have %s items, here are %zu",
                    NUMBER_TEXT(list->said), list->count);
}

/* list_count = float [","] .
 * How many items follow. Nothing is allocated on its word. */
static bool parse_list_count(struct parser *p, const struct mesh2 *m,
                             size_t *count)
{
    double number;
    struct span span = stream_span(p);
    if (m->plain)
        return plain_count(p, m->plain, count);
    if (stream_peek(p)->kind == TOKEN_LESS)
        return error_expected_hint(p, "how many follow", "3, <0, 0, 0> ...");
    if (!parse_float(p, &number))
        return false;
    accept(p, TOKEN_COMMA);
    if (!(number >= 0 && number < MESH_NONE - 1))
        return error_at(p, span, NULL, "this can't be the length of a list");
    *count = (size_t)number;
    return true;
}

/* How many vectors the text has room for, at most: what a list may reserve
 * whatever length it claims. */
static size_t list_room(struct parser *p, const struct mesh2 *m, size_t count)
{
    enum { TOKENS_PER_VECTOR = 5 };
    size_t left;
    if (m->plain)
        return count;
    stream_raw(p, &left);
    return count < left / TOKENS_PER_VECTOR ? count : left / TOKENS_PER_VECTOR;
}

static bool list_too_short(struct parser *p, const struct mesh2 *m, size_t want,
                           size_t have)
{
    if (m->plain || stream_peek(p)->kind != TOKEN_RBRACE)
        return false;
    error_at(p, stream_span(p), NULL,
             "the list should have %zu items, here are %zu", want, have);
    return true;
}

static bool list_vector(struct parser *p, struct mesh2 *m, double *v, int size)
{
    if (m->plain) {
        memcpy(v, m->plain->vectors[m->plain_next++], 3 * sizeof *v);
        return true;
    }
    if (!parse_components(p, v, size))
        return false;
    accept(p, TOKEN_COMMA);
    return true;
}

static bool list_points(struct parser *p, struct mesh2 *m,
                        struct vec3_list *list)
{
    size_t count = 0;
    double v[5];
    if (!parse_list_count(p, m, &count))
        return false;
    ARRAY_RESERVE(p->scene_arena, list, list_room(p, m, count));
    for (size_t i = 0; i < count; i++) {
        if (list_too_short(p, m, count, i) || !list_vector(p, m, v, 3))
            return false;
        *ARRAY_PUSH(p->scene_arena, list) = vec3_make(v[0], v[1], v[2]);
    }
    return true;
}

/* vertex_vectors = "vertex_vectors" "{" list_count {vector [","]} "}" . */
static bool parse_vertex_vectors(struct parser *p, struct mesh2 *m)
{
    return list_points(p, m, &m->lists.vertices);
}

/* normal_vectors = "normal_vectors" "{" list_count {vector [","]} "}" . */
static bool parse_normal_vectors(struct parser *p, struct mesh2 *m)
{
    return list_points(p, m, &m->lists.normals);
}

/* uv_vectors = "uv_vectors" "{" list_count {vector [","]} "}" . */
static bool parse_uv_vectors(struct parser *p, struct mesh2 *m)
{
    size_t count = 0;
    double v[5];
    if (!parse_list_count(p, m, &count))
        return false;
    for (size_t i = 0; i < count; i++) {
        if (list_too_short(p, m, count, i) || !list_vector(p, m, v, 2))
            return false;
        memcpy(*ARRAY_PUSH(p->scene_arena, &m->lists.uvs), v,
               sizeof *m->lists.uvs.items);
    }
    return true;
}

/* texture_list = "texture_list" "{" list_count {texture [","]} "}" . */
static bool parse_texture_list(struct parser *p, struct mesh2 *m)
{
    size_t count = 0;
    if (!parse_list_count(p, m, &count))
        return false;
    for (size_t i = 0; i < count; i++) {
        if (list_too_short(p, m, count, i))
            return false;
        if (stream_keyword(p) != KEYWORD_TEXTURE)
            return error_expected(p, "'texture'");
        const struct texture **texture =
            ARRAY_PUSH(p->scene_arena, &m->lists.textures);
        if (!parse_texture(p, texture))
            return false;
        accept(p, TOKEN_COMMA);
    }
    m->list_textures = m->lists.textures.count;
    return true;
}

/* Three numbers below `count`, which is how many `things` there are. */
static bool list_indices(struct parser *p, struct mesh2 *m, uint32_t *out,
                         size_t count, const char *things)
{
    double v[5];
    struct span span = m->plain ? p->last_span : stream_span(p);
    if (!list_vector(p, m, v, 3))
        return false;
    for (int i = 0; i < 3; i++) {
        bool known = v[i] >= 0 && v[i] < (double)count;
        const char *which =
            v[i] == (double)count && count > 0 ? " and numbered from 0" : "";
        if (!known && m->plain)
            return error_at(p, span, NULL,
                            "item %zu names number %s of the %s, which are "
                            "%zu%s",
                            m->plain_next, NUMBER_TEXT(v[i]), things, count,
                            which);
        if (!known)
            return error_at(p, span, NULL,
                            "this names number %s of the %s, which are %zu%s",
                            NUMBER_TEXT(v[i]), things, count, which);
        out[i] = (uint32_t)v[i];
    }
    return true;
}

/* face_textures = float [[","] float [","] float] .
 * One texture for the face, or one for each corner. */
static bool parse_face_textures(struct parser *p, struct mesh2 *m,
                                uint32_t *out)
{
    const struct texture *corners[3];
    int count = 0;
    while (count < 3 && (count == 0 || at_number(p))) {
        double index;
        struct span span = stream_span(p);
        if (!parse_float(p, &index))
            return false;
        accept(p, TOKEN_COMMA);
        if (!(index >= 0 && index < (double)m->list_textures))
            return error_at(p, span, NULL,
                            "this names number %s of the texture_list, which "
                            "has %zu",
                            NUMBER_TEXT(index), m->list_textures);
        corners[count++] = m->lists.textures.items[(size_t)index];
        *out = (uint32_t)index;
    }
    if (count == 1 || (corners[0] == corners[1] && count == 2))
        return true;
    if (count == 2)
        corners[2] = corners[1];
    *out = mesh_corner_textures(p, &m->lists, corners);
    return *out != MESH_NONE;
}

/* face_indices = "face_indices"
 *                "{" list_count {vector [","] [face_textures]} "}" . */
static bool parse_face_indices(struct parser *p, struct mesh2 *m)
{
    size_t count = 0;
    if (!parse_list_count(p, m, &count))
        return false;
    ARRAY_RESERVE(p->scene_arena, &m->lists.triangles, list_room(p, m, count));
    for (size_t i = 0; i < count; i++) {
        struct mesh_triangle t = {
            .normal = { MESH_NONE, MESH_NONE, MESH_NONE }, .texture = MESH_NONE
        };
        if (list_too_short(p, m, count, i) ||
            !list_indices(p, m, t.vertex, m->lists.vertices.count,
                          "vertex_vectors"))
            return false;
        if (!m->plain && at_number(p) && !parse_face_textures(p, m, &t.texture))
            return false;
        *ARRAY_PUSH(p->scene_arena, &m->lists.triangles) = t;
    }
    return true;
}

/* The count of a list that has a row for each face, or fewer; `name` is its
 * keyword. */
static bool parse_face_count(struct parser *p, struct mesh2 *m,
                             const char *name, size_t *count)
{
    struct span span = stream_span(p);
    if (!parse_list_count(p, m, count))
        return false;
    return *count <= m->lists.triangles.count ||
           error_at(p, span, NULL,
                    "%zu %s for %zu faces (face_indices come first)", *count,
                    name, m->lists.triangles.count);
}

/* normal_indices = "normal_indices" "{" list_count {vector [","]} "}" . */
static bool parse_normal_indices(struct parser *p, struct mesh2 *m)
{
    size_t count = 0;
    if (!parse_face_count(p, m, "normal_indices", &count))
        return false;
    for (size_t i = 0; i < count; i++)
        if (list_too_short(p, m, count, i) ||
            !list_indices(p, m, m->lists.triangles.items[i].normal,
                          m->lists.normals.count, "normal_vectors"))
            return false;
    m->normal_faces = count;
    return true;
}

/* uv_indices = "uv_indices" "{" list_count {vector [","]} "}" . */
static bool parse_uv_indices(struct parser *p, struct mesh2 *m)
{
    size_t count = 0;
    uint32_t corners[3];
    if (!parse_face_count(p, m, "uv_indices", &count))
        return false;
    for (size_t i = 0; i < count; i++) {
        if (list_too_short(p, m, count, i) ||
            !list_indices(p, m, corners, m->lists.uvs.count, "uv_vectors"))
            return false;
        memcpy(*ARRAY_PUSH(p->scene_arena, &m->lists.uv_faces), corners,
               sizeof corners);
    }
    return true;
}

typedef bool mesh2_rule(struct parser *p, struct mesh2 *m);

static mesh2_rule *mesh2_keyword_rule(enum keyword keyword)
{
    switch (keyword) {
    case KEYWORD_VERTEX_VECTORS:
        return parse_vertex_vectors;
    case KEYWORD_NORMAL_VECTORS:
        return parse_normal_vectors;
    case KEYWORD_UV_VECTORS:
        return parse_uv_vectors;
    case KEYWORD_TEXTURE_LIST:
        return parse_texture_list;
    case KEYWORD_FACE_INDICES:
        return parse_face_indices;
    case KEYWORD_NORMAL_INDICES:
        return parse_normal_indices;
    case KEYWORD_UV_INDICES:
        return parse_uv_indices;
    default:
        return NULL;
    }
}

/* mesh2_list = vertex_vectors | normal_vectors | uv_vectors | texture_list
 *            | face_indices | normal_indices | uv_indices . */
static enum taken parse_mesh2_list(struct parser *p, struct mesh2 *m)
{
    mesh2_rule *rule = mesh2_keyword_rule(stream_keyword(p));
    struct span open;
    if (!rule)
        return NOT_MINE;
    stream_next(p);
    m->plain = NULL;
    if (stream_peek(p)->kind == TOKEN_NUMBERS) {
        m->plain = stream_next(p).numbers;
        m->plain_next = 0;
        return rule(p, m);
    }
    if (!block_begin(p, &open))
        return WRONG;
    bool ok = rule(p, m);
    if (ok && stream_peek(p)->kind != TOKEN_RBRACE) {
        error_expected(p, "'}' after as many items as are announced");
        note_at(p, open, "to match this '{'");
        ok = false;
    }
    return block_end(p, open, ok);
}

/* Without normal_indices, faces use their vertices' numbers if there are as
 * many normals as vertices; without uv_indices likewise. */
static void mesh2_finish(struct parser *p, struct mesh2 *m)
{
    struct mesh_builder *b = &m->lists;
    bool same = !m->normal_faces && b->normals.count == b->vertices.count;
    for (size_t i = 0; same && i < b->triangles.count; i++)
        memcpy(b->triangles.items[i].normal, b->triangles.items[i].vertex,
               sizeof b->triangles.items[i].normal);
    bool mapped = !b->uv_faces.count && b->uvs.count == b->vertices.count;
    for (size_t i = 0; mapped && i < b->triangles.count; i++)
        memcpy(*ARRAY_PUSH(p->scene_arena, &b->uv_faces),
               b->triangles.items[i].vertex, sizeof *b->uv_faces.items);
    m->mesh->mapped = true;
    mesh_take(p, m->mesh, b);
}

static bool mesh2_body(struct parser *p, struct mesh2 *m,
                       struct modifiers *modifiers)
{
    enum taken taken;
    do
        taken = parse_mesh2_list(p, m);
    while (taken == TAKEN);
    if (taken == WRONG || !parse_modifiers(p, modifiers))
        return false;
    if (m->lists.vertices.count == 0)
        return error_expected_hint(p, "'vertex_vectors', the corners",
                                   "vertex_vectors { 3, <0, 0, 0>, ... }");
    return m->lists.triangles.count > 0 ||
           error_expected_hint(
               p, "'face_indices', which three corners make a triangle",
               "face_indices { 1, <0, 1, 2> } ...");
}

/* mesh2 = "mesh2" "{" {mesh2_list} {"inside_vector" vector | modifier} "}" . */
bool parse_mesh2(struct parser *p, struct object **out)
{
    struct mesh2 mesh2 = { .mesh = ARENA_NEW(p->scene_arena, struct mesh) };
    struct span open;
    stream_next(p);
    *out = object_new(p->scene_arena, OBJECT_MESH, p->last_span);
    (*out)->mesh = mesh2.mesh;
    (*out)->patch = true;
    struct modifiers m = { .object = *out,
                           .block = "mesh2",
                           .items = mesh_fields,
                           .shape = mesh2.mesh };
    if (!block_begin(p, &open) ||
        !block_end(p, open, mesh2_body(p, &mesh2, &m)))
        return false;
    mesh2_finish(p, &mesh2);
    mesh_end(p, *out, mesh2.mesh);
    return true;
}
