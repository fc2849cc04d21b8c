/* The scene file as a sequence of items, and what #declare can name besides
 * numbers and strings. */
#include "parse/expression.h"
#include "parse/macro.h"
#include "parse/mistaken.h"
#include "parse/rules.h"

/* ---- what can be declared ---- */

/* The next layer of a declared texture. Directives must not run before the
 * name has its value. */
static bool at_next_layer(struct parser *p)
{
    const struct token *token = stream_peek_infix(p);
    return token->kind == TOKEN_WORD && token->word->keyword == KEYWORD_TEXTURE;
}

/* After a wrong layer the others are read all the same: they belong to it. */
static bool thing_texture(struct parser *p, struct value *value)
{
    const struct texture *texture = NULL, *top = NULL;
    bool ok = parse_texture(p, &texture);
    while (at_next_layer(p)) {
        ok = parse_texture(p, &top) && ok;
        if (ok)
            texture = texture_stack(p, texture, top);
    }
    value->kind = VALUE_TEXTURE;
    value->texture = texture;
    return ok;
}

static bool thing_object(struct parser *p, struct value *value)
{
    struct object *object;
    if (!parse_object(p, &object))
        return false;
    value->kind = VALUE_OBJECT;
    value->object = object;
    return true;
}

static bool thing_transform(struct parser *p, struct value *value)
{
    affine *transform = ARENA_NEW(p->arena, affine);
    *transform = affine_identity();
    value->kind = VALUE_TRANSFORM;
    value->transform = transform;
    return parse_transformation(p, transform);
}

static bool thing_camera(struct parser *p, struct value *value)
{
    struct camera *camera = ARENA_NEW(p->arena, struct camera);
    value->kind = VALUE_CAMERA;
    value->camera = camera;
    return parse_camera(p, camera);
}

static bool thing_material(struct parser *p, struct value *value)
{
    struct material *material = ARENA_NEW(p->arena, struct material);
    value->kind = VALUE_MATERIAL;
    value->material = material;
    return parse_material(p, material);
}

static bool thing_fog(struct parser *p, struct value *value)
{
    struct fog *fog = ARENA_NEW(p->arena, struct fog);
    value->kind = VALUE_FOG;
    value->fog = fog;
    return parse_fog(p, fog);
}

static bool thing_rainbow(struct parser *p, struct value *value)
{
    struct rainbow *rainbow = ARENA_NEW(p->arena, struct rainbow);
    value->kind = VALUE_RAINBOW;
    value->rainbow = rainbow;
    return parse_rainbow(p, rainbow);
}

static bool thing_light_group(struct parser *p, struct value *value)
{
    value->kind = VALUE_LIGHT_GROUP;
    return parse_light_group(p, &value->object);
}

/* thing = texture {texture} | pigment | normal | finish | interior | material
 *       | transform | camera | fog | rainbow | sky_sphere | colour_map
 *       | pigment_map | texture_map | density | density_map | media
 *       | light_group | object . */
enum taken parse_thing(struct parser *p, struct value *value)
{
    enum keyword keyword = stream_keyword(p);
    switch (keyword) {
    case KEYWORD_TEXTURE:
        return thing_texture(p, value);
    case KEYWORD_PIGMENT:
        value->kind = VALUE_PIGMENT;
        return parse_pigment(p, &value->pigment);
    case KEYWORD_NORMAL:
        value->kind = VALUE_NORMAL;
        return parse_normal(p, &value->normal);
    case KEYWORD_FINISH:
        value->kind = VALUE_FINISH;
        return parse_finish(p, &value->finish);
    case KEYWORD_INTERIOR:
        value->kind = VALUE_INTERIOR;
        return parse_interior(p, &value->interior);
    case KEYWORD_MATERIAL:
        return thing_material(p, value);
    case KEYWORD_TRANSFORM:
        return thing_transform(p, value);
    case KEYWORD_CAMERA:
        return thing_camera(p, value);
    case KEYWORD_FOG:
        return thing_fog(p, value);
    case KEYWORD_RAINBOW:
        return thing_rainbow(p, value);
    case KEYWORD_SKY_SPHERE:
        value->kind = VALUE_SKY_SPHERE;
        return parse_sky_sphere(p, &value->sky);
    case KEYWORD_COLOUR_MAP:
        value->kind = VALUE_COLOUR_MAP;
        return parse_colour_map(p, &value->map);
    case KEYWORD_PIGMENT_MAP:
        value->kind = VALUE_PIGMENT_MAP;
        return parse_pigment_map(p, false, &value->map);
    case KEYWORD_LIGHT_GROUP:
        return thing_light_group(p, value);
    case KEYWORD_TEXTURE_MAP:
        value->kind = VALUE_TEXTURE_MAP;
        return parse_declared_texture_map(p, &value->texture_map);
    case KEYWORD_DENSITY:
        value->kind = VALUE_DENSITY;
        return parse_density(p, &value->pigment);
    case KEYWORD_DENSITY_MAP:
        value->kind = VALUE_DENSITY_MAP;
        return parse_density_map(p, &value->map);
    case KEYWORD_MEDIA:
        value->kind = VALUE_MEDIA;
        return parse_medium(p, &value->medium);
    case KEYWORD_NORMAL_MAP:
        value->kind = VALUE_NORMAL_MAP;
        return parse_normal_map(p, false, &value->normal_map);
    case KEYWORD_SLOPE_MAP:
        value->kind = VALUE_SLOPE_MAP;
        return parse_slope_map(p, &value->slope_map);
    default:
        /* Names of declared things are parse_expression's. */
        return at_object(p) && stream_peek(p)->word->reserved
                   ? thing_object(p, value)
                   : NOT_MINE;
    }
}

/* ---- the scene ---- */

static bool scene_camera(struct parser *p)
{
    struct camera camera;
    struct span span = stream_span(p);
    if (!parse_camera(p, &camera))
        return false;
    bool library = library_user(p, span).source != span.source;
    if (p->scene->camera_said && !library) /* screen.inc says it twice itself */
        warning_at(p, span, NULL,
                   "a second camera: the one before it is not used");
    p->scene->camera_said = true;
    p->scene->camera = camera;
    return true;
}

static bool scene_sky_sphere(struct parser *p)
{
    struct span span = stream_span(p);
    bool second = p->scene->sky != NULL;
    const struct sky_sphere *sky;
    if (!parse_sky_sphere(p, &sky))
        return false;
    if (second)
        warning_at(p, span, NULL,
                   "a second sky_sphere: the one before it is not used");
    p->scene->sky = sky;
    return true;
}

/* Fog that is nowhere dense is none. */
static bool scene_fog(struct parser *p)
{
    struct fog fog;
    struct span span = stream_span(p);
    if (!parse_fog(p, &fog))
        return false;
    if (!(fog.distance > 0))
        warning_at(p, span, "distance 10", "fog without a distance is none");
    else
        *ARRAY_PUSH(p->scene_arena, &p->scene->fogs) = fog;
    return true;
}

static bool scene_object(struct parser *p)
{
    struct object *object;
    if (!parse_object(p, &object))
        return false;
    object = object_seen(p, object);
    object_link(p, object);
    *ARRAY_PUSH(p->scene_arena, &p->scene->objects) = object;
    return true;
}

/* Its members are objects of the scene, which alone know their group. */
static bool scene_light_group(struct parser *p)
{
    const struct object *group;
    if (!parse_light_group(p, &group))
        return false;
    unsigned number = ++p->scene->light_groups;
    for (size_t i = 0; i < group->more->child_count; i++) {
        struct object *member =
            object_copy(p->scene_arena, group->more->children[i]);
        object_more(p->scene_arena, member)->light_group = number;
        member->no_global_lights = group->no_global_lights;
        object_move(p->scene_arena, member, group->maps->own);
        object_link(p, member);
        *ARRAY_PUSH(p->scene_arena, &p->scene->objects) = member;
    }
    return true;
}

bool at_scene_item(struct parser *p)
{
    switch (stream_keyword(p)) {
    case KEYWORD_CAMERA:
    case KEYWORD_BACKGROUND:
    case KEYWORD_SKY_SPHERE:
    case KEYWORD_FOG:
    case KEYWORD_RAINBOW:
    case KEYWORD_LIGHT_GROUP:
    case KEYWORD_MEDIA:
    case KEYWORD_GLOBAL_SETTINGS:
    case KEYWORD_DEFAULT:
        return true;
    default:
        return at_object(p);
    }
}

/* Whether the next token is a word that begins a line behind a '}': something
 * of its own, as the call of a macro that isn't known. */
static bool at_new_line(struct parser *p)
{
    const struct token *token = stream_peek(p);
    struct span last = p->last_span, at = p->token_span;
    if (token->kind != TOKEN_WORD || token->word->reserved ||
        last.source != at.source || last.source->text[last.offset] != '}')
        return false;
    const char *text = at.source->text + at.offset;
    while (text > at.source->text && (text[-1] == ' ' || text[-1] == '\t'))
        text--;
    return text > at.source->text && text[-1] == '\n';
}

/* After an error: to where something known begins. */
static void scene_recover(struct parser *p)
{
    struct span open;
    while (stream_peek(p)->kind != TOKEN_END && !at_scene_item(p) &&
           !at_new_line(p))
        if (stream_peek(p)->kind != TOKEN_LBRACE)
            stream_next(p);
        else if (block_begin(p, &open))
            block_end(p, open, false);
}

/* What is no item of the scene, but can be declared. */
static bool at_declarable(struct parser *p)
{
    switch (stream_keyword(p)) {
    case KEYWORD_TEXTURE:
    case KEYWORD_PIGMENT:
    case KEYWORD_NORMAL:
    case KEYWORD_FINISH:
    case KEYWORD_INTERIOR:
    case KEYWORD_MATERIAL:
    case KEYWORD_TRANSFORM:
    case KEYWORD_COLOUR_MAP:
    case KEYWORD_PIGMENT_MAP:
    case KEYWORD_FUNCTION:
    case KEYWORD_ARRAY:
        return true;
    default:
        return false;
    }
}

/* Scenes older than version 3 have no global_settings.
 * scene_setting = "max_trace_level" float | "max_intersections" float . */
static bool scene_setting(struct parser *p)
{
    if (p->version >= 3)
        warning_at(p, stream_span(p),
                   arena_printf(p->arena, "global_settings { %s ... }",
                                stream_peek(p)->word->text),
                   "this belongs into 'global_settings'");
    return parse_global_setting(p);
}

/* What other languages, or a slip, leave between the objects of a scene. */
static bool scene_stray(struct parser *p)
{
    enum token_kind kind = stream_peek(p)->kind;
    struct span at = stream_span(p);
    const char *text = at.source->text + at.offset;
    if (kind == TOKEN_COMMA) {
        error_at(p, at, NULL, "no comma stands between objects");
        return true;
    }
    if (kind == TOKEN_STAR && text[1] == '/') {
        at.length = 2;
        error_at(p, at, NULL, "this '*/' ends no comment; '/*' begins one");
        stream_next(p);
        return true;
    }
    if (kind == TOKEN_MINUS && text[1] == '-') {
        at.length = 2;
        error_at(p, at, "//", "a comment begins with '//'");
        mistaken_skip_line(p, at);
        stream_next(p);
        return true;
    }
    if (kind == TOKEN_LESS && strncmp(text, "<!--", 4) == 0) {
        at.length = 4;
        error_at(p, at, "/* ...", "a comment stands between '/*' and '*/'");
        mistaken_skip_line(p, at);
        return true;
    }
    if (kind == TOKEN_AND || kind == TOKEN_OR) {
        error_at(p, at, "((a > 1) & (b > 1)) ...",
                 "the condition of a directive stands in one pair of "
                 "parentheses");
        return true;
    }
    if (kind != TOKEN_MINUS && kind != TOKEN_PLUS && kind != TOKEN_STAR)
        return false;
    error_at(p, at,
             kind == TOKEN_MINUS  ? "difference { A B }"
             : kind == TOKEN_PLUS ? "union { A B }"
                                  : "intersection { A B }",
             "objects are put together by a block, not by '%c'", *text);
    return true;
}

/* `Chair(1) { translate x }`: the next token, a '{', is behind a call, and not
 * behind the head of the macro that is being read. */
static bool scene_behind_call(struct parser *p)
{
    const struct cursor *cursor = p->cursor;
    const struct token *tokens = cursor->list->tokens;
    size_t at = cursor->index;
    int depth = 0;
    if (at < 4 || cursor->list->source != p->token_span.source ||
        tokens[at -= 2].kind != TOKEN_RPAREN)
        return false;
    for (; at > 0; at--) {
        depth += tokens[at].kind == TOKEN_RPAREN;
        depth -= tokens[at].kind == TOKEN_LPAREN;
        if (depth == 0)
            break;
    }
    return at > 1 && tokens[at - 1].kind == TOKEN_WORD &&
           (tokens[at - 2].kind != TOKEN_DIRECTIVE ||
            tokens[at - 2].word->keyword != KEYWORD_MACRO) &&
           macro_is_call(p, tokens[at - 1].word);
}

/* What was wrong when it was declared, perhaps a macro that is called. */
static bool scene_poison(struct parser *p)
{
    stream_next(p);
    return stream_peek(p)->kind == TOKEN_LPAREN && skip_brackets(p);
}

static bool scene_unknown(struct parser *p)
{
    struct span open;
    if (at_poison(p))
        return scene_poison(p);
    if (mistaken_statement(p))
        return true; /* and read on right behind it */
    if (at_word(p, "max_trace_level") || at_word(p, "max_intersections"))
        return scene_setting(p);
    enum token_kind kind = stream_peek(p)->kind;
    if (at_word(p, "light_mesh") || at_word(p, "skeleton"))
        error_at(p, stream_span(p),
                 "#ifdef (Glim) global_settings { ... } #end",
                 "this belongs into 'global_settings'");
    else if (at_declarable(p)) {
        const struct word *word = stream_peek(p)->word;
        error_at(p, stream_span(p),
                 arena_printf(p->arena, "#declare NAME = %s ...", word->text),
                 "'%s' is not allowed in the scene by itself", word->text);
        note_outside(p, word);
    } else if (kind == TOKEN_WORD)
        error_unknown_item(p, "the scene", NULL);
    else if (kind == TOKEN_SEMICOLON)
        error_at(p, stream_span(p), NULL,
                 "no ';' stands here: it ends #declare, #local and #version");
    else if (kind == TOKEN_RBRACE)
        error_at(p, stream_span(p), NULL, "this '}' closes nothing");
    else if (kind == TOKEN_LBRACE && scene_behind_call(p))
        error_at(p, stream_span(p), "object { NAME(...) ... }",
                 "what a macro makes is moved and coloured in 'object { }'");
    else if (kind == TOKEN_LBRACE)
        error_at(p, stream_span(p), NULL,
                 "no item of the scene stands before this '{'; what belongs "
                 "to a directive ends with '#end' and has no braces");
    else if (!scene_stray(p))
        error_expected(p, "an object or another item of the scene");
    if (kind != TOKEN_LBRACE)
        stream_next(p);
    else if (block_begin(p, &open))
        block_end(p, open, false);
    return false;
}

/* scene_item = camera | background | sky_sphere | fog | rainbow | media
 *            | light_group | global_settings | default_block | object
 *            | scene_setting . */
bool parse_scene_item(struct parser *p)
{
    bool ok;
    switch (stream_keyword(p)) {
    case KEYWORD_CAMERA:
        ok = scene_camera(p);
        break;
    case KEYWORD_BACKGROUND:
        ok = parse_background(p, &p->scene->background);
        break;
    case KEYWORD_SKY_SPHERE:
        ok = scene_sky_sphere(p);
        break;
    case KEYWORD_FOG:
        ok = scene_fog(p);
        break;
    case KEYWORD_RAINBOW:
        ok = parse_rainbow(p, ARRAY_PUSH(p->scene_arena, &p->scene->rainbows));
        break;
    case KEYWORD_LIGHT_GROUP:
        ok = scene_light_group(p);
        break;
    case KEYWORD_MEDIA:
        ok = parse_media(p, &p->scene->media);
        break;
    case KEYWORD_GLOBAL_SETTINGS:
        ok = parse_global_settings(p);
        break;
    case KEYWORD_DEFAULT:
        ok = parse_default_block(p);
        break;
    default:
        ok = at_object(p) ? scene_object(p) : scene_unknown(p);
    }
    if (!ok)
        scene_recover(p);
    return ok;
}
