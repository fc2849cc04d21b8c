/* Other languages' words and statements: see mistaken.h. */
#include "parse/mistaken.h"

#include <ctype.h>

#include "base/text.h"
#include "parse/array.h"
#include "parse/directive.h"
#include "parse/expression.h"
#include "parse/symbol.h"
#include "token/lookalike.h"

/* What stands in a certain block comes first, what may in any (NULL) last. */
struct synonym {
    const char *words, *block, *meant;
};

static const struct synonym synonyms[] = {
    { "position origin eye", "camera", "location" },
    { "width", "camera", "right 4*x" },
    { "height", "camera", "up 3*y" },
    { "isometric", "camera", "orthographic" },
    { "samples", "camera", "blur_samples" },
    { "focal_blur", "camera", "aperture 0.4 blur_samples 50" },
    { "target", "camera", "look_at" },
    { "position", "", "<1, 2, 3>" },
    { "size len", "", "dimension_size(A, 1)" },
    { "return", "", "function(x) { x*x }" },
    { "macro", "", "#macro NAME(A) ... #end" },
    { "exists", "", "file_exists(\"NAME\")" },
    { "and", "", "&" },
    { "or", "", "|" },
    { "not", "", "!" },
    { "f_noise", "", "f_noise3d(x, y, z)" },
    { "sqr", "", "pow(x, 2)" },
    { "catmull_rom_spline catmull_rom", "", "cubic_spline" },
    { "vec2", "", "<1, 2> ..." },
    { "vec3 vector vector3 float3", "", "<1, 2, 3> ..." },
    { "vec4", "", "<1, 2, 3, 4> ..." },
    { "halo", "the scene", "media { ... }" },
    { "atmosphere", "the scene", "media { scattering { 1, rgb 0.1 } }" },
    { "version", "the scene", "#version 3.7;" },
    { "floor ground", "the scene", "plane { y, 0 }" },
    { "sky", "the scene", "sky_sphere { pigment { ... } }" },
    { "settings", "the scene", "global_settings" },
    { "fog_height height", "fog", "fog_alt" },
    { "density dist", "fog", "distance" },
    { "type", "fog", "fog_type" },
    { "center centre align", "text", "translate -0.5*x" },
    { "ambient", "global_settings", "ambient_light" },
    { "gamma", "global_settings", "assumed_gamma" },
    { "samples", "radiosity", "count" },
    { "distance_maximum", "radiosity", "maximum_reuse 0.2" },
    { "circle", "light_source", "circular" },
    { "target look_at", "light_source", "point_at" },
    { "shadows", "light_source", "shadowless" },
    { "spot spot_light", "light_source", "spotlight" },
    { "directional", "light_source", "parallel" },
    { "brightness", "light_source", "rgb 2" },
    { "vertices points", "mesh2", "vertex_vectors" },
    { "faces triangles", "mesh2", "face_indices" },
    { "normals", "mesh2", "normal_vectors" },
    { "uvs", "mesh2", "uv_vectors" },
    { "box sphere cylinder cone torus plane blob union difference intersection "
      "merge",
      "object", "union { ... }" },
    { "vertex_vectors texture_list face_indices", "mesh", "mesh2 { ... }" },
    { "texture_map", "texture", "gradient y texture_map { ... }" },
    { "sqrt", "julia_fractal", "sqr" },
    { "fov field_of_view zoom", NULL, "angle" },
    { "checkerboard checkered checkers", NULL, "checker" },
    { "stripes", NULL, "gradient x" },
    { "visible invisible hidden", NULL, "no_image" },
    { "clip_by clip", NULL, "clipped_by" },
    { "halo", NULL, "interior { media { ... } }" },
    { "shadows cast_shadow cast_shadows castshadow", NULL, "no_shadow" },
    { "media", NULL, "interior { media ... }" },
    { "container", NULL, "contained_by" },
    { "aspect aspect_ratio", NULL, "right x*image_width/image_height" },
    { "antialias antialiasing", NULL, "+A on the command line" },
    { "resolution", NULL, "+W320 +H240 on the command line" },
    { "light lamp point_light pointlight", NULL, "light_source" },
    { "intensity", NULL, "rgb 2" },
    { "cube cuboid", NULL, "box" },
    { "ball", NULL, "sphere" },
    { "ellipsoid", NULL, "sphere { 0, 1 scale <2, 1, 1> }" },
    { "circle", NULL, "disc" },
    { "donut", NULL, "torus" },
    { "tube", NULL, "cylinder" },
    { "group", NULL, "union" },
    { "subtract", NULL, "difference" },
    { "intersect", NULL, "intersection" },
    { "move position translation", NULL, "translate" },
    { "turn rotation", NULL, "rotate" },
    { "size resize", NULL, "scale" },
    { "shininess", NULL, "phong 1 phong_size 40" },
    { "shiny", NULL, "phong 1" },
    { "glossy", NULL, "specular 0.5" },
    { "reflect mirror", NULL, "reflection" },
    { "transparent transparency opacity", NULL, "transmit" },
    { "refract index_of_refraction", NULL, "ior" },
    { "bump", NULL, "bumps" },
    { "noise perlin", NULL, "bozo" },
    { "bilinear", NULL, "2" },
    { "bicubic", NULL, "3" },
    { "random", NULL, "rand(STREAM)" },
    { "eof feof", NULL, "defined(HANDLE)" },
    { "normalize", NULL, "vnormalize(V)" },
    { "length", NULL, "vlength(V)" },
    { "dot", NULL, "vdot(V, W)" },
    { "cross", NULL, "vcross(V, W)" },
    { "ramp", NULL, "gradient y" },
    { "gradient_map", NULL, "color_map" },
    { "rgba", NULL, "rgbt" },
    { "hsv hsl", NULL, "CHSV2RGB(<120, 1, 1>)" },
    { "background_color background_colour", NULL, "background { ... }" },
};

const char *mistaken_word(const struct word *word, const char *block)
{
    for (size_t i = 0; i < sizeof synonyms / sizeof *synonyms; i++)
        if (text_among(word->text, synonyms[i].words) &&
            (!synonyms[i].block || strcmp(block, synonyms[i].block) == 0))
            return synonyms[i].meant;
    return NULL;
}

/* `[1, 2]` and `{1, 2}` as an array. */
static const char *mistaken_list(struct parser *p)
{
    enum { LONGEST = 60 };
    const char *text = p->token_span.source->text + p->token_span.offset;
    size_t length = strcspn(text + 1, "[]{}<>()\"\r\n");
    int count = 1;
    if (!strchr("]}", text[1 + length]) || length == 0 || length > LONGEST)
        return "array[3] {1, 2, 3}";
    for (size_t i = 1; i <= length; i++)
        count += text[i] == ',';
    return arena_printf(p->arena, "array[%d] {%.*s}", count, (int)length,
                        text + 1);
}

/* `2**3`, a list, `if (A) B else C`, and `size(A)`, a word that means something
 * else here. */
const char *mistaken_value(struct parser *p, const char *wanted)
{
    const struct token *token = stream_peek(p);
    struct span last = p->last_span;
    if (token->kind == TOKEN_STAR && last.source &&
        last.source->text[last.offset] == '*')
        return "pow(x, 2)";
    bool value = strcmp(wanted, "a value") == 0;
    if (value && (token->kind == TOKEN_LBRACKET || token->kind == TOKEN_LBRACE))
        return mistaken_list(p);
    if (value && token->kind == TOKEN_WORD &&
        token->word->keyword == KEYWORD_IF)
        return "(A > B ? C : D) ...";
    return strncmp(wanted, "a ", 2) == 0 && token->kind == TOKEN_WORD &&
                   token->word->reserved
               ? mistaken_word(token->word, "")
               : NULL;
}

static const char elseif_words[] = "elif elsif";

static const struct {
    const char *words;
    enum keyword meant;
} directive_words[] = {
    { "define set let var const", KEYWORD_DECLARE },
    { "import require", KEYWORD_INCLUDE },
    { elseif_words, KEYWORD_ELSEIF },
    { "endif endwhile endfor endmacro endswitch fi done", KEYWORD_END },
    { "print echo", KEYWORD_DEBUG },
    { "unset", KEYWORD_UNDEF },
    { "until", KEYWORD_WHILE },
    { "foreach", KEYWORD_FOR },
    { "function def sub", KEYWORD_MACRO },
};

bool mistaken_degrees(struct parser *p)
{
    size_t left;
    const struct token *token = stream_peek(p), *next = stream_raw(p, &left);
    bool called = left > 0 && next->kind == TOKEN_LPAREN;
    if (called || token->kind != TOKEN_WORD ||
        !text_among(token->word->text, "deg degs degree degrees"))
        return false;
    error_at(p, p->token_span, NULL,
             "angles are in degrees anyhow, without '%s'; about the y axis: "
             "rotate 30*y",
             token->word->text);
    return true;
}

bool mistaken_named(struct parser *p)
{
    enum { LONGEST = 40 };
    size_t left;
    const struct token *token = stream_peek(p), *next = stream_raw(p, &left);
    if (token->kind != TOKEN_WORD || left < 2 ||
        (next[0].kind != TOKEN_EQUAL && next[0].kind != TOKEN_COLON) ||
        next[1].kind == TOKEN_EQUAL)
        return false;
    struct span at = p->token_span;
    const char *text = at.source->text + at.offset;
    size_t value = next[1].offset - at.offset, end = strcspn(text, "(),\r\n");
    bool shown = value < end && end - value < LONGEST && text[end] != '(';
    at.length = (uint32_t)(shown ? end : value);
    error_at(
        p, at,
        shown ? arena_printf(p->arena, "%.*s", (int)(end - value), text + value)
              : NULL,
        "arguments have no names; which is which is told by their order");
    return true;
}

bool mistaken_elseif(const struct token *token)
{
    return token->kind == TOKEN_DIRECTIVE &&
           text_among(token->word->text, elseif_words);
}

enum keyword mistaken_directive_word(const struct word *word)
{
    size_t count = sizeof directive_words / sizeof *directive_words;
    for (size_t i = 0; i < count; i++)
        if (text_among(word->text, directive_words[i].words))
            return directive_words[i].meant;
    struct text_nearest nearest = text_nearest_start(word->text);
    enum keyword meant = KEYWORD_NONE;
    for (enum keyword i = 1; i < KEYWORDS_TOTAL; i++) {
        const char *before = nearest.best;
        if (directive_is(i))
            text_nearest_try(&nearest, keyword_spelling(i));
        if (nearest.best != before)
            meant = i;
    }
    return meant;
}

const char *mistaken_character(struct parser *p, struct span span)
{
    size_t open, close;
    const char *text = span.source->text + span.offset;
    size_t length = lookalike_string(text, &open, &close);
    if (length > 0)
        return arena_printf(p->arena, "\"%.*s\"", (int)(length - open - close),
                            text + open);
    const struct lookalike *alike = lookalike_find(text);
    return alike ? alike->meant : NULL;
}

/* ---- directives without '#' ---- */

const char mistaken_fillers[] = "then do begin";

/* Words that nothing but a directive is called. */
static bool directive_stands_bare(enum keyword keyword)
{
    return keyword == KEYWORD_IF || keyword == KEYWORD_IFDEF ||
           keyword == KEYWORD_IFNDEF || keyword == KEYWORD_ELSE ||
           keyword == KEYWORD_ELSEIF || keyword == KEYWORD_END ||
           keyword == KEYWORD_WHILE || keyword == KEYWORD_FOR ||
           keyword == KEYWORD_SWITCH || keyword == KEYWORD_CASE ||
           keyword == KEYWORD_BREAK || keyword == KEYWORD_MACRO ||
           keyword == KEYWORD_LOCAL || keyword == KEYWORD_UNDEF ||
           keyword == KEYWORD_DEBUG;
}

/* Whether the next token, which is peeked, stands right behind an #else. */
static bool mistaken_after_else(struct parser *p)
{
    struct cursor *cursor = p->cursor;
    if (cursor->index < 2)
        return false;
    const struct token *before = &cursor->list->tokens[cursor->index - 2];
    return before->kind == TOKEN_DIRECTIVE &&
           before->word->keyword == KEYWORD_ELSE;
}

static size_t mistaken_line_end(const struct source *source, size_t at)
{
    return at + strcspn(source->text + at, "\r\n");
}

/* What follows the one string of `#debug "a" x` in its line. */
static bool mistaken_after_message(struct parser *p)
{
    stream_peek(p);
    const struct cursor *cursor = p->cursor;
    if (cursor->index < 3 || cursor->list->source != p->token_span.source)
        return false;
    const struct token *before = &cursor->list->tokens[cursor->index - 3];
    if (before[0].kind != TOKEN_DIRECTIVE || before[1].kind != TOKEN_STRING ||
        (before[0].word->keyword != KEYWORD_DEBUG &&
         before[0].word->keyword != KEYWORD_WARNING) ||
        p->token_span.offset >
            mistaken_line_end(p->token_span.source, before[1].offset))
        return false;
    error_at(p, p->token_span, "concat(\"a = \", str(a, 0, 3))",
             "'#%s' takes one string; concat() joins several",
             before[0].word->text);
    mistaken_skip_line(p, p->token_span);
    stream_next(p);
    return true;
}

/* `#if (A) then`, `#while (A) do`, `#for (...) begin`, also with a '#'. */
static bool mistaken_filler(struct parser *p)
{
    const struct token *token = stream_peek(p);
    const struct cursor *cursor = p->cursor;
    if (token->kind != TOKEN_WORD || cursor->index < 2 ||
        cursor->list->tokens[cursor->index - 2].kind != TOKEN_RPAREN ||
        !text_among(token->word->text, mistaken_fillers))
        return false;
    error_at(p, p->token_span, NULL,
             "no '%s' stands behind the condition of a directive, only an "
             "'#end' behind all that belongs to it",
             token->word->text);
    stream_next(p);
    return true;
}

static bool mistaken_bare(struct parser *p)
{
    const struct token *token = stream_peek(p);
    if (token->kind != TOKEN_WORD ||
        !directive_stands_bare(token->word->keyword))
        return false;
    const struct word *word = token->word;
    struct span at = p->token_span;
    bool chained = word->keyword == KEYWORD_IF && mistaken_after_else(p);
    if (chained)
        error_at(p, at, "#elseif", "'#else' takes no condition");
    else
        error_at(p, at, arena_printf(p->arena, "#%s", word->text),
                 "'%s' is a directive and wants a '#' before it", word->text);
    stream_next(p);
    if (!chained)
        directive_run_as(p, word->keyword, at);
    else if (stream_peek(p)->kind == TOKEN_LPAREN)
        skip_brackets(p);
    return true;
}

/* ---- declarations without #declare ---- */

/* Whether a type and a name follow: `var NAME`. */
static bool mistaken_typed(struct parser *p)
{
    size_t left;
    const struct token *token = stream_peek(p), *raw = stream_raw(p, &left);
    return token->kind == TOKEN_WORD && left > 1 && raw[0].kind == TOKEN_WORD &&
           !raw[0].word->reserved &&
           text_among(token->word->text, "var let const int float double real "
                                         "number define set def auto");
}

/* Whether a declaration follows: NAME = or, `typed`, `var NAME =`. */
static bool mistaken_is_declaration(struct parser *p, bool typed)
{
    size_t left;
    const struct token *token = stream_peek(p);
    if (token->kind != TOKEN_WORD ||
        (token->word->reserved &&
         (!typed || token->word->keyword != KEYWORD_INT)))
        return false;
    const struct token *raw = stream_raw(p, &left);
    size_t i = array_subscripts_end(raw, left, typed);
    return i < left && raw[i].kind == TOKEN_EQUAL;
}

static bool mistaken_declaration(struct parser *p)
{
    bool typed = mistaken_typed(p);
    if (!mistaken_is_declaration(p, typed))
        return false;
    struct span at = p->token_span, name = at;
    if (typed) {
        stream_next(p);
        name = stream_span(p);
    }
    const char *text = name.source->text + name.offset;
    int length = (int)strcspn(text, ";\r\n");
    size_t hash = *text == '#' ? 1 + strspn(text + 1, " \t") : 0;
    text += hash;
    length -= (int)hash;
    error_at(p, at,
             length < 60
                 ? arena_printf(p->arena, "#declare %.*s;", length, text)
                 : "#declare",
             "a name gets its value by '#declare'");
    directive_run_as(p, KEYWORD_DECLARE, at);
    return true;
}

bool mistaken_statement(struct parser *p)
{
    return mistaken_after_message(p) || mistaken_filler(p) ||
           mistaken_bare(p) || mistaken_declaration(p);
}

void mistaken_skip_line(struct parser *p, struct span at)
{
    struct cursor *cursor = p->cursor;
    size_t end = mistaken_line_end(at.source, at.offset);
    while (cursor->index < cursor->end &&
           cursor->list->tokens[cursor->index].offset < end)
        cursor->index++;
}

void mistaken_define(struct parser *p, struct span at)
{
    struct cursor *cursor = p->cursor;
    const struct token *token = &cursor->list->tokens[cursor->index];
    if (token->kind == TOKEN_WORD && !token->word->reserved)
        symbol_set(p, token->word, (struct value){ .kind = VALUE_POISON },
                   false);
    mistaken_skip_line(p, at);
}

const char *mistaken_capital(struct parser *p, const char *text)
{
    return arena_printf(p->arena, "%c%s", toupper((unsigned char)*text),
                        text + 1);
}

const struct word *mistaken_case(struct parser *p, const char *text,
                                 size_t length)
{
    char *small = arena_copy_text(p->arena, text, length);
    for (char *c = small; *c; c++)
        *c = (char)tolower((unsigned char)*c);
    return word_intern(p->words, small, length);
}
