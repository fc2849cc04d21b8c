/* Textures: a pigment, a normal and a finish; layers of them. Those that a
 * pattern picks are in texture_choice.c. */
#include "parse/rules.h"

static const struct field texture_names[] = {
    { .name = "pigment" },
    { .name = "normal" },
    { .name = "finish" },
    { .name = NULL },
};

static bool layer_is_default(const struct parser *p, const struct layer *layer)
{
    return layer->pigment == p->defaults.pigment &&
           layer->normal == p->defaults.normal &&
           layer->finish == p->defaults.finish;
}

/* One for all: a scene can have millions of objects that say nothing. */
const struct texture *texture_from_defaults(struct parser *p)
{
    struct texture *texture = p->defaults.texture;
    if (texture && layer_is_default(p, texture->layers))
        return texture;
    texture = ARENA_NEW(p->scene_arena, struct texture);
    texture->layers = ARENA_NEW(p->scene_arena, struct layer);
    texture->layers[0] = (struct layer){
        .pigment = p->defaults.pigment,
        .normal = p->defaults.normal,
        .finish = p->defaults.finish,
    };
    texture->count = 1;
    p->defaults.texture = texture;
    return texture;
}

struct texture *texture_copy(struct parser *p, const struct texture *texture)
{
    struct texture *copy = ARENA_NEW(p->scene_arena, struct texture);
    copy->count = texture->count;
    copy->layers = ARENA_ARRAY(p->scene_arena, struct layer, texture->count);
    memcpy(copy->layers, texture->layers,
           texture->count * sizeof *texture->layers);
    copy->choice = texture->choice;
    copy->span = texture->span;
    return copy;
}

struct texture *texture_top(struct parser *p, const struct texture *texture,
                            struct layer **top)
{
    struct texture *copy = texture_copy(p, texture);
    *top = &copy->layers[copy->count - 1];
    return copy;
}

const struct texture *texture_stack(struct parser *p,
                                    const struct texture *bottom,
                                    const struct texture *top)
{
    struct texture *both = ARENA_NEW(p->scene_arena, struct texture);
    both->count = bottom->count + top->count;
    both->span = top->span;
    if (bottom->choice || top->choice) {
        error_at(p, p->last_span, NULL,
                 "a texture picked by a pattern can't be a layer of others");
        return bottom;
    }
    if (both->count > TEXTURE_LAYERS) {
        error_at(p, p->last_span, NULL, "a texture has at most %d layers",
                 TEXTURE_LAYERS);
        return bottom;
    }
    if (p->version <= 3.1)
        top = texture_veiled(p, top);
    both->layers = ARENA_ARRAY(p->scene_arena, struct layer, both->count);
    memcpy(both->layers, bottom->layers,
           bottom->count * sizeof *bottom->layers);
    memcpy(both->layers + bottom->count, top->layers,
           top->count * sizeof *top->layers);
    return both;
}

/* The declared pigment, normal or finish that is next goes into the topmost
 * layer. */
static bool accept_texture_value(struct parser *p, const struct texture **in)
{
    const struct value *pigment = accept_value(p, VALUE_PIGMENT);
    const struct value *normal = pigment ? NULL : accept_value(p, VALUE_NORMAL);
    const struct value *finish =
        pigment || normal ? NULL : accept_value(p, VALUE_FINISH);
    if (!pigment && !normal && !finish)
        return false;
    struct layer *layer;
    *in = texture_top(p, *in, &layer);
    if (pigment)
        layer->pigment = pigment->pigment;
    else if (normal)
        layer->normal = normal->normal;
    else
        layer->finish = finish->finish;
    return true;
}

/* texture_start = [TEXTURE] {PIGMENT | NORMAL | FINISH} . */
static void parse_texture_start(struct parser *p, const struct texture **out)
{
    const struct value *value = accept_value(p, VALUE_TEXTURE);
    bool choice = value && value->texture->choice;
    if (value) {
        *out = value->texture;
    } else {
        struct texture *texture = texture_copy(p, texture_from_defaults(p));
        texture->span = p->last_span;
        *out = texture;
    }
    while (!choice && accept_texture_value(p, out))
        ;
}

/* A surface's own normal: nothing else will begin with it. */
static bool parse_surface_normal(struct parser *p, const struct normal **in)
{
    if (!parse_normal_block(p, in))
        return false;
    if (!normal_tilts(*in))
        warning_at(p, p->last_span, "bumps 0.5",
                   "a normal without a pattern changes nothing");
    return true;
}

/* texture_part = pigment | normal | finish .
 * Of layers, only the topmost is changed. */
enum taken parse_texture_part(struct parser *p, const struct texture **in)
{
    enum keyword keyword = stream_keyword(p);
    if (keyword != KEYWORD_PIGMENT && keyword != KEYWORD_NORMAL &&
        keyword != KEYWORD_FINISH)
        return NOT_MINE;
    struct layer *top;
    struct texture *texture = texture_top(p, *in, &top);
    if (keyword == KEYWORD_PIGMENT || !texture->span.source)
        texture->span = stream_span(p);
    *in = texture;
    return keyword == KEYWORD_PIGMENT  ? parse_pigment_block(p, &top->pigment)
           : keyword == KEYWORD_NORMAL ? parse_surface_normal(p, &top->normal)
                                       : parse_finish_block(p, &top->finish);
}

/* All bumps of the texture's own layers are as high however they are scaled. */
static const struct texture *texture_levelled(struct parser *p,
                                              const struct texture *texture)
{
    struct texture *level = texture_copy(p, texture);
    for (size_t i = 0; i < level->count; i++) {
        struct layer *layer = &level->layers[i];
        if (!layer->normal)
            continue;
        struct normal *normal = ARENA_NEW(p->scene_arena, struct normal);
        *normal = *layer->normal;
        normal->level = true;
        layer->normal = normal;
    }
    return level;
}

/* texture_item = texture_part | bare_item | "no_bump_scale"
 *              | transformation . */
static bool parse_texture_item(struct parser *p, const struct texture **in)
{
    affine step = affine_identity();
    struct span span = stream_span(p);
    enum taken taken = parse_texture_part(p, in);
    if (taken == NOT_MINE)
        taken = parse_bare_item(p, in);
    if (taken == WRONG)
        return false;
    if (taken == TAKEN)
        return !(*in)->choice ||
               error_at(p, span, NULL,
                        "what a pattern picks can't be changed here, only in "
                        "its map");
    if (accept_keyword(p, KEYWORD_NO_BUMP_SCALE)) {
        *in = texture_levelled(p, *in);
        return true;
    }
    taken = parse_transformation(p, &step);
    if (taken == NOT_MINE)
        return error_unknown_thing(p, "texture", texture_names, "a texture");
    if (taken == TAKEN)
        *in = texture_moved(p->scene_arena, *in, &step);
    return taken;
}

static bool texture_content(struct parser *p, const struct texture **in)
{
    enum taken taken = at_bare_item(p) ? NOT_MINE : parse_texture_choice(p, in);
    if (taken == NOT_MINE)
        taken = parse_material_map(p, in);
    if (taken != NOT_MINE)
        return taken;
    parse_texture_start(p, in);
    while (!at_body_end(p))
        if (!parse_texture_item(p, in))
            return false;
    return true;
}

/* texture_body = ["uv_mapping"]
 *                ( texture_choice | texture_by_picture
 *                | texture_start {texture_item} ) . */
bool parse_texture_body(struct parser *p, const struct texture **in)
{
    bool mapped = accept_keyword(p, KEYWORD_UV_MAPPING);
    if (!texture_content(p, in))
        return false;
    if (mapped)
        *in = texture_mapped(p->scene_arena, *in);
    return true;
}

/* texture = "texture" "{" texture_body "}" . */
bool parse_texture(struct parser *p, const struct texture **out)
{
    struct span open;
    stream_next(p);
    return block_begin(p, &open) &&
           block_end(p, open, parse_texture_body(p, out));
}
