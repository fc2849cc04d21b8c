/* Interiors: how light is bent and dimmed inside a solid. */
#include "parse/rules.h"
#include "parse/tables.h"

/* old_interior_value = "refraction" float .
 * Changes nothing. */
static bool parse_old_interior_value(struct parser *p)
{
    double ignored;
    warning_at(p, stream_span(p), "ior 1.5",
               "'refraction' has no effect any more; 'ior' bends light");
    stream_next(p);
    return parse_float(p, &ignored);
}

/* interior_value = "ior" float | "fade_distance" float | "fade_power" float
 *                | "fade_colour" colour | "caustics" float
 *                | "dispersion" float | "dispersion_samples" float .
 * interior_item = interior_value | media | old_interior_value . */
static bool parse_interior_item(struct parser *p, struct interior *interior)
{
    const struct field *field = accept_field(p, interior_fields);
    if (field)
        return parse_field(p, field, interior);
    if (stream_keyword(p) == KEYWORD_MEDIA)
        return parse_media(p, &interior->media);
    if (stream_keyword(p) == KEYWORD_REFRACTION)
        return parse_old_interior_value(p);
    return error_unknown_thing(p, "interior", interior_fields, "an interior");
}

static bool interior_items(struct parser *p, const struct interior **out)
{
    const struct value *value = accept_value(p, VALUE_INTERIOR);
    const struct interior *declared = value ? value->interior : NULL;
    *out = declared;
    if (declared && stream_peek(p)->kind == TOKEN_RBRACE)
        return true;
    struct interior *interior = ARENA_NEW(p->scene_arena, struct interior);
    *interior = declared ? *declared : interior_default();
    *out = interior;
    while (stream_peek(p)->kind != TOKEN_RBRACE)
        if (!parse_interior_item(p, interior))
            return false;
    return true;
}

/* interior = "interior" "{" [INTERIOR] {interior_item} "}" . */
bool parse_interior(struct parser *p, const struct interior **out)
{
    struct span open;
    stream_next(p);
    return block_begin(p, &open) && block_end(p, open, interior_items(p, out));
}
