/* The words of the language: see words.h. */
#include "parse/words.h"

#include "parse/directive.h"
#include "parse/function.h"
#include "parse/tables.h"
#include "scene/finish.h"
#include "scene/light_settings.h"

const char *parse_function_at(size_t index)
{
    for (unsigned k = 1; k < KEYWORDS_TOTAL; k++)
        if (function_is((enum keyword)k) && index-- == 0)
            return keyword_spelling((enum keyword)k);
    return NULL;
}

const char *parse_directive_word(size_t index, const char **help)
{
    for (unsigned k = 1; k < KEYWORDS_TOTAL; k++) {
        *help = directive_help((enum keyword)k);
        if (*help && index-- == 0)
            return keyword_spelling((enum keyword)k);
    }
    return NULL;
}

static const struct {
    const char *block;
    const struct field *fields;
} tables[] = {
    { "image_map", image_fields },
    { "image_pattern", image_pattern_fields },
    { "image_pattern", image_fields },
    { "bump_map", bump_fields },
    { "bump_map", image_fields },
    { "warp", turbulence_fields },
    { "warp", repeat_fields },
    { "warp", hole_fields },
    { "warp", laid_fields },
    { "global_settings", setting_fields },
    { "pigment", pattern_fields },
    { "normal", normal_fields },
    { "normal", pattern_fields },
    { "texture", pattern_fields },
    { "density", pattern_fields },
    { "photons", photon_fields },
    { "bicubic_patch", bicubic_fields },
    { "radiosity", radiosity_used },
    { "interior", interior_fields },
    { "media", medium_fields },
    { "scattering", scattering_fields },
    { "light_source", lamp_fields },
    { "light_source", lamp_kind_fields },
    { "light_source", directed_fields },
    { "camera", camera_fields },
    { "camera", blur_fields },
    { "fog", fog_fields },
    { "fog", fog_turbulence_fields },
    { "rainbow", rainbow_fields },
    { "sky_sphere", sky_fields },
    { "light_mesh", light_mesh_fields },
    { "indirect", indirect_fields },
    { "skeleton", skeleton_fields },
};

/* Of finish { } and of the blocks in it. */
static const struct field *finish_word(const char *block, const char *word)
{
    enum finish_place place;
    const struct finish_item *item = finish_item_find(block);
    return strcmp(block, "finish") == 0 ? finish_field(word, &place)
           : item && item->inner        ? field_find(item->inner, word)
                                        : NULL;
}

const char *parse_field_help(const char *block, const char *word)
{
    const struct field *finish = block ? finish_word(block, word) : NULL;
    if (finish && finish->help)
        return finish->help;
    for (size_t i = 0; block && i < sizeof tables / sizeof *tables; i++) {
        const struct field *field = strcmp(tables[i].block, block) == 0
                                        ? field_find(tables[i].fields, word)
                                        : NULL;
        if (field && field->help)
            return field->help;
    }
    return NULL;
}
