/* Settings of glim's own lighting methods, in global_settings; POV-Ray does not
 * know them: they stand between #ifdef (Glim) and #end. */
#include "parse/rules.h"
#include "parse/tables.h"

enum { REGION_LIMIT = 1000 };

static const struct field mesh_names[] = {
    { .name = "quality" },   { .name = "density" }, { .name = "radius" },
    { .name = "model" },     { .name = "shadows" }, { .name = "interpolation" },
    { .name = "threshold" }, { .name = "levels" },  { .name = "sky" },
    { .name = "indirect" },  { .name = "region" },  { .name = "load_file" },
    { .name = NULL },
};

static const struct field factor_fields[] = {
    { "factor", FIELD_FLOAT, offsetof(struct mesh_region, factor), 1e-3, 1e3,
      "multiplies the density" },
    { NULL },
};

static enum taken light_field(struct parser *p, const struct field *table)
{
    const struct field *field = accept_field(p, table);
    if (!field)
        return NOT_MINE;
    light_place(&p->scene->settings, field, stream_span(p));
    return parse_field(p, field, &p->scene->settings);
}

static bool light_fields(struct parser *p, const char *block,
                         const struct field *table)
{
    enum taken taken = TAKEN;
    while (taken == TAKEN && stream_peek(p)->kind != TOKEN_RBRACE)
        taken = light_field(p, table);
    return taken != NOT_MINE ? taken : error_unknown_item(p, block, table);
}

/* indirect = "indirect" ( "{" {indirect_value} "}" | [bool] ) . */
static bool parse_indirect(struct parser *p)
{
    bool *on = &p->scene->settings.light_mesh.indirect.on;
    struct span open;
    stream_next(p);
    if (stream_peek(p)->kind != TOKEN_LBRACE)
        return parse_bool(p, on);
    *on = true;
    return block_begin(p, &open) &&
           block_end(p, open, light_fields(p, "indirect", indirect_fields));
}

static bool region_items(struct parser *p, struct mesh_region *region)
{
    vec3 a, b;
    if (!parse_vector(p, &a))
        return false;
    accept(p, TOKEN_COMMA);
    if (!parse_vector(p, &b))
        return false;
    region->low = vec3_make(fmin(a.x, b.x), fmin(a.y, b.y), fmin(a.z, b.z));
    region->high = vec3_make(fmax(a.x, b.x), fmax(a.y, b.y), fmax(a.z, b.z));
    const struct field *field = accept_field(p, factor_fields);
    if (field)
        return parse_field(p, field, region);
    if (stream_peek(p)->kind == TOKEN_WORD)
        return error_unknown_item(p, "region", factor_fields);
    return error_expected(p, "'factor' and how much denser the mesh is in "
                             "this region");
}

/* region = "region" "{" vector [","] vector "factor" float "}" . */
static bool parse_region(struct parser *p)
{
    struct light_mesh_settings *mesh = &p->scene->settings.light_mesh;
    struct mesh_region region;
    struct span open, span = stream_span(p);
    stream_next(p);
    if (!block_begin(p, &open) || !block_end(p, open, region_items(p, &region)))
        return false;
    if (mesh->regions.count == REGION_LIMIT)
        return error_at(p, span, NULL,
                        "more than %d regions, glim's limit, in 'light_mesh'",
                        REGION_LIMIT);
    *ARRAY_PUSH(p->scene_arena, &mesh->regions) = region;
    return true;
}

/* mesh_file = "load_file" string .
 * A scene may come from anybody and must not write: save_file is refused. */
static bool parse_mesh_file(struct parser *p)
{
    const char *name;
    bool save = at_word(p, "save_file");
    struct span word = stream_span(p);
    stream_next(p);
    struct span span = stream_span(p);
    if (save)
        return error_at(p, word, "--mesh-save FILE",
                        "a scene may not write files; ask for it on the "
                        "command line");
    if (!parse_string(p, &name))
        return false;
    const char *path = file_need(p, span, "light mesh", name, NULL);
    if (!path)
        return false;
    p->scene->settings.light_mesh.load_file =
        arena_printf(p->scene_arena, "%s", path);
    return true;
}

/* mesh_item = mesh_value | indirect | region | mesh_file . */
static bool parse_mesh_item(struct parser *p)
{
    enum taken taken = light_field(p, light_mesh_fields);
    if (taken != NOT_MINE)
        return taken;
    if (at_word(p, "indirect"))
        return parse_indirect(p);
    if (at_word(p, "region"))
        return parse_region(p);
    if (at_word(p, "load_file") || at_word(p, "save_file"))
        return parse_mesh_file(p);
    if (at_word(p, "samples") || at_word(p, "bounces"))
        return error_at(p, stream_span(p), "indirect { samples 200 bounces 3 }",
                        "this belongs into 'indirect'");
    return error_unknown_item(p, "light_mesh", mesh_names);
}

/* light_mesh = "light_mesh" "{" {mesh_item} "}" . */
bool parse_light_mesh(struct parser *p)
{
    return block_items(p, parse_mesh_item);
}

/* skeleton = "skeleton" "{" {skeleton_value} "}" . */
bool parse_skeleton(struct parser *p)
{
    struct span open;
    stream_next(p);
    return block_begin(p, &open) &&
           block_end(p, open, light_fields(p, "skeleton", skeleton_fields));
}

/* ---- radiosity ---- */

#define RADIOSITY(name, kind, member, low, high, help)                         \
    {                                                                          \
        name, kind, offsetof(struct radiosity_settings, member), low, high,    \
            help                                                               \
    }

/* radiosity_number = "brightness" float | "gray_threshold" float
 *                  | "recursion_limit" float | "normal" [bool] . */
const struct field radiosity_used[] = {
    RADIOSITY("brightness", FIELD_FLOAT, tone.brightness, 0, 1e6,
              "multiplies the light of surfaces at each bounce, 1"),
    RADIOSITY("gray_threshold", FIELD_FLOAT, tone.grey, 0, 1,
              "how much colour it loses, 0"),
    RADIOSITY("recursion_limit", FIELD_INTEGER, recursion_limit, 1, 20,
              "bounces, 2"),
    RADIOSITY("normal", FIELD_BOOL, normal, 0, 0, "bumps count"),
    { NULL },
};

static const struct field radiosity_fields[] = {
    { .name = "adc_bailout" },      { .name = "always_sample" },
    { .name = "brightness" },       { .name = "count" },
    { .name = "error_bound" },      { .name = "gray_threshold" },
    { .name = "low_error_factor" }, { .name = "max_sample" },
    { .name = "maximum_reuse" },    { .name = "media" },
    { .name = "minimum_reuse" },    { .name = "nearest_count" },
    { .name = "normal" },           { .name = "pretrace_end" },
    { .name = "pretrace_start" },   { .name = "recursion_limit" },
    { .name = "subsurface" },       { .name = NULL },
};

/* Of scenes before version 3.7. */
static bool skip_radiosity_file(struct parser *p)
{
    const char *ignored;
    warning_at(p, stream_span(p), NULL,
               "'%s' is of no use here, as in POV-Ray since 3.7",
               stream_peek(p)->word->text);
    stream_next(p);
    return parse_string(p, &ignored);
}

/* What says how POV-Ray is to find it.
 * radiosity_value = ("load_file" | "save_file") string | radiosity_number
 *                 | name [bool | float [[","] float]] . */
static bool parse_radiosity_value(struct parser *p)
{
    struct value ignored;
    if (at_word(p, "load_file") || at_word(p, "save_file"))
        return skip_radiosity_file(p);
    if (!accept_field(p, radiosity_fields))
        return error_unknown_item(p, "radiosity", radiosity_fields);
    if (!at_expression(p))
        return true;
    if (!parse_expression(p, &ignored))
        return false;
    accept(p, TOKEN_COMMA);
    return !at_expression(p) || parse_expression(p, &ignored);
}

/* radiosity = "radiosity" "{" {radiosity_value} "}" .
 * Asks for interreflection, which there is unless 'indirect off' is said,
 * before or after. What says how bright it is counts for --lighting rays; how
 * POV-Ray is to find it means nothing here. */
bool parse_radiosity(struct parser *p)
{
    struct span open, first = span_none(), span = stream_span(p);
    bool ok = true;
    stream_next(p);
    if (!block_begin(p, &open))
        return false;
    while (ok && stream_peek(p)->kind != TOKEN_RBRACE) {
        struct span value = stream_span(p);
        const struct field *field = accept_field(p, radiosity_used);
        if (!first.source && !field)
            first = value;
        ok = field ? parse_field(p, field, &p->scene->settings.radiosity_said)
                   : parse_radiosity_value(p);
    }
    if (!block_end(p, open, ok))
        return false;
    if (first.source && !p->scene->settings.radiosity)
        warning_at(p, span, "light_mesh { indirect { samples 200 bounces 3 } }",
                   "'%.*s' and what else says how POV-Ray computes radiosity "
                   "is not used; glim computes it in its own way, which is set "
                   "like this",
                   (int)first.length, first.source->text + first.offset);
    p->scene->settings.radiosity = true;
    return true;
}
