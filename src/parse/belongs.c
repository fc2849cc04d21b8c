/* Which block an item belongs into that stands in another, for errors. */
#include "parse/expression.h"
#include "parse/stream.h"
#include "scene/finish.h"
#include "scene/pattern.h"

struct owner {
    const char *block;
    const char *const *items;
};

static const char *const camera_items[] = { "angle", "location", "look_at",
                                            "orthographic", NULL };
static const char *const interior_items[] = { "fade_color", "fade_distance",
                                              "fade_power", "ior", NULL };
static const char *const light_items[] = { "area_light", "looks_like",
                                           "point_at",   "shadowless",
                                           "spotlight",  NULL };
static const char *const normal_items[] = {
    "bump_map", "bump_size", "normal_map", "slope_map", "bumps",
    "dents",    "ripples",   "waves",      "wrinkles",  NULL
};
static const char *const settings_items[] = { "adc_bailout",
                                              "ambient_light",
                                              "assumed_gamma",
                                              "max_trace_level",
                                              "photons",
                                              "radiosity",
                                              NULL };
static const char *const texture_items[] = { "material_map", "texture_map",
                                             NULL };

static const struct owner owners[] = {
    { "camera", camera_items },      { "interior", interior_items },
    { "light_source", light_items }, { "global_settings", settings_items },
    { "normal", normal_items },      { "texture", texture_items },
};

static const char *owner_of(const struct word *word)
{
    for (size_t i = 0; i < sizeof owners / sizeof *owners; i++)
        for (const char *const *item = owners[i].items; *item; item++)
            if (strcmp(*item, word->text) == 0)
                return owners[i].block;
    enum finish_place place;
    if (finish_item_find(word->text) || finish_field(word->text, &place))
        return "finish";
    enum keyword keyword = word->keyword;
    bool colours = keyword == KEYWORD_COLOUR_MAP ||
                   keyword == KEYWORD_PIGMENT_MAP ||
                   keyword == KEYWORD_IMAGE_MAP || colour_begins(keyword);
    bool pattern = pattern_find(word->text) && keyword != KEYWORD_OBJECT;
    return colours || pattern ? "pigment" : NULL;
}

static bool is_texture_part(enum keyword keyword)
{
    return keyword == KEYWORD_PIGMENT || keyword == KEYWORD_NORMAL ||
           keyword == KEYWORD_FINISH;
}

/* What a declared thing stands in; NULL: nothing in particular. */
static const char *block_of(enum value_kind kind)
{
    switch (kind) {
    case VALUE_OBJECT:
        return "object";
    case VALUE_TEXTURE:
        return "texture";
    case VALUE_COLOUR:
    case VALUE_PIGMENT:
        return "pigment";
    case VALUE_NORMAL:
        return "normal";
    case VALUE_FINISH:
        return "finish";
    case VALUE_INTERIOR:
        return "interior";
    case VALUE_MATERIAL:
        return "material";
    case VALUE_TRANSFORM:
        return "transform";
    default:
        return NULL;
    }
}

/* Behind `checker` and its like stand colours or blocks. */
static bool behind_list_pattern(const struct parser *p)
{
    struct span last = p->last_span;
    const struct pattern_kind *kind;
    for (size_t i = 0; last.source && (kind = pattern_at(i)); i++)
        if (kind->blocks && strlen(kind->name) == last.length &&
            memcmp(last.source->text + last.offset, kind->name, last.length) ==
                0)
            return true;
    return false;
}

const char *item_belongs(struct parser *p, const struct word *word,
                         const char *block)
{
    const struct value *value = word->reserved ? NULL : symbol_find(p, word);
    const char *owner = value ? block_of(value->kind) : NULL;
    if (word->reserved)
        owner = owner_of(word);
    if (is_texture_part(word->keyword) && strcmp(block, "material") == 0)
        owner = "texture";
    bool within = owner && strcmp(owner, block) == 0;
    if (!owner || (within && !(value && behind_list_pattern(p))))
        return NULL;
    return arena_printf(p->arena, "%s { %s%s }", owner, word->text,
                        value ? "" : " ...");
}

const char *item_wrapped(struct parser *p, const char *wanted)
{
    static const char *const parts[] = { "a texture", "a material",  "a finish",
                                         "a normal",  "an interior", "a colour",
                                         "a pigment" };
    const struct token *token = stream_peek(p);
    const struct value *value =
        token->kind == TOKEN_WORD && !token->word->reserved
            ? symbol_find(p, token->word)
            : NULL;
    const char *block = value ? block_of(value->kind) : NULL;
    for (size_t i = 0; block && i < sizeof parts / sizeof *parts; i++)
        if (strncmp(wanted, parts[i], strlen(parts[i])) == 0)
            return arena_printf(p->arena, "%s { %s }", block,
                                token->word->text);
    return NULL;
}
