/* text: the letters of a string, from a font, each an outline with a thickness;
 * a union of them. */
#include "parse/rules.h"
#include "scene/extrusion.h"
#include "scene/font.h"

enum { LETTER_SLOTS = 256 };

/* A letter of this thickness; NULL: nothing is seen of it. */
struct letter_made {
    int letter;
    double thickness;
    const struct extrusion *shape;
    bool made;
};

/* Fonts already read in this parse: a loop may name one a thousand times. Its
 * letters are made once and stand in many places; of those with one slot the
 * last. */
struct typeface {
    struct typeface *next;
    const char *name; /* it was last asked for by: where that is, is known */
    const char *path;
    const struct font *font;
    struct letter_made letters[LETTER_SLOTS];
};

/* POV-Ray has these within; here they are files like others. */
static const char *const internal_fonts[] = { "povlogo.ttf", "timrom.ttf",
                                              "cyrvetic.ttf", "crystal.ttf" };

enum { INTERNAL_FONTS = sizeof internal_fonts / sizeof *internal_fonts };

static bool font_load(struct parser *p, const char *name, struct span span,
                      struct typeface **out)
{
    const char *problem = NULL, *path;
    for (*out = p->fonts; *out; *out = (*out)->next)
        if (strcmp((*out)->name, name) == 0)
            return true;
    path = file_need(p, span, "font", name, ".ttf");
    if (!path)
        return false;
    for (*out = p->fonts; *out; *out = (*out)->next)
        if (strcmp((*out)->path, path) == 0) {
            (*out)->name = arena_copy_text(p->arena, name, strlen(name));
            return true;
        }
    const struct source *source =
        source_read(p->sources, path, span_none(), &problem);
    const struct font *font =
        source ? font_new(p->arena, source->text, source->length, &problem)
               : NULL;
    if (!font)
        return error_at(p, span, NULL, "can't read the font '%s': %s", path,
                        problem);
    *out = ARENA_NEW(p->arena, struct typeface);
    (*out)->next = p->fonts;
    (*out)->name = arena_copy_text(p->arena, name, strlen(name));
    (*out)->path = path;
    (*out)->font = font;
    p->fonts = *out;
    return true;
}

/* font = "ttf" string | "internal" float . */
static bool parse_font(struct parser *p, struct typeface **out)
{
    const char *name;
    int number;
    if (accept_keyword(p, KEYWORD_TTF)) {
        struct span span = stream_span(p);
        return parse_string(p, &name) && font_load(p, name, span, out);
    }
    if (!accept_keyword(p, KEYWORD_INTERNAL))
        return error_expected_hint(p, "'ttf' and the name of a font",
                                   "ttf \"timrom.ttf\" ...");
    struct span span = stream_span(p);
    if (!parse_integer(p, &number))
        return false;
    if (number < 0 || number >= INTERNAL_FONTS)
        return error_at(p, span, "1", "'internal' is from 0 to %d, found %d",
                        INTERNAL_FONTS - 1, number);
    return font_load(p, internal_fonts[number], span, out);
}

/* The next character of UTF-8; a byte that is none stands for itself. */
static uint32_t text_next(const char **text)
{
    const unsigned char *s = (const unsigned char *)*text;
    uint32_t first = *s++;
    int more = first >= 0xf0 ? 3 : first >= 0xe0 ? 2 : first >= 0xc0 ? 1 : 0;
    uint32_t character = more ? first & (0x3fu >> more) : first;
    for (int i = 0; i < more; i++, s++) {
        if ((*s & 0xc0) != 0x80) {
            (*text)++;
            return first;
        }
        character = character << 6 | (*s & 0x3f);
    }
    *text = (const char *)s;
    return character;
}

/* A space is a point, which counts for how long the text is (measured). */
static const struct extrusion *letter_make(struct parser *p,
                                           const struct font *font, int number,
                                           double thickness)
{
    const char *warning = NULL;
    struct letter letter = font_outline(font, number, p->scene_arena);
    struct extrusion *shape = ARENA_NEW(p->scene_arena, struct extrusion);
    shape->segments = (struct terms){ (double *)letter.segments,
                                      letter.count * SEGMENT_NUMBERS };
    shape->high = thickness;
    shape->axis = 2;
    if (letter.count > 0)
        extrusion_prepare(shape, p->scene_arena, &warning);
    return warning ? NULL : shape;
}

static const struct extrusion *letter_shape(struct parser *p,
                                            struct typeface *face, int letter,
                                            double thickness)
{
    struct letter_made *slot = &face->letters[letter % LETTER_SLOTS];
    if (!slot->made || slot->letter != letter || slot->thickness != thickness)
        *slot =
            (struct letter_made){ letter, thickness,
                                  letter_make(p, face->font, letter, thickness),
                                  true };
    return slot->shape;
}

/* A letter at its place in the line. */
static bool text_letter(struct parser *p, struct object *text,
                        const struct extrusion *shape, vec3 place)
{
    struct object *object =
        object_new(p->scene_arena, OBJECT_SHAPE, text->span);
    object->primitive = &text_primitive;
    object->shape = shape;
    affine move = affine_translation(place);
    object_move(p->scene_arena, object, &move);
    struct object_more *more = object_more(p->scene_arena, text);
    more->children[more->child_count++] = object;
    return object_adopt(p, text, object);
}

/* Each letter begins where the one before it ends; the outline of the first
 * one at 0. The offset's z has no effect in POV-Ray (measured). */
static bool text_letters(struct parser *p, struct object *text,
                         struct typeface *face, const char *string,
                         double thickness, vec3 offset)
{
    const struct font *font = face->font;
    vec3 place = { 0, 0, 0 };
    int last = -1;
    struct object_more *more = object_more(p->scene_arena, text);
    more->parts = 0;
    more->children =
        ARENA_ARRAY(p->scene_arena, const struct object *, strlen(string) + 1);
    while (*string) {
        int letter = font_letter(font, text_next(&string));
        if (last < 0) {
            place.x = -font_bearing(font, letter);
        } else {
            place.x += font_advance(font, last) +
                       font_kerning(font, last, letter) + offset.x;
            place.y += offset.y;
        }
        const struct extrusion *shape =
            letter_shape(p, face, letter, thickness);
        if (shape && !text_letter(p, text, shape, place))
            return false;
        last = letter;
    }
    return true;
}

/* Letters beyond ASCII are drawn as they are written. POV-Ray has none for them
 * unless it is told of UTF-8 (measured). */
static void warn_letters(struct parser *p, const char *string, struct span span)
{
    const char *c = string;
    while (*c && (unsigned char)*c < 128)
        c++;
    if (!*c || p->letters_told)
        return;
    p->letters_told = true;
    warning_at(p, span, "global_settings { charset utf8 }",
               "POV-Ray draws a blank or another letter for one that isn't "
               "ASCII, unless the scene says its charset");
}

/* text_arguments = font [","] string [","] float [","] vector . */
static bool parse_text_arguments(struct parser *p, struct object *text)
{
    struct typeface *face;
    const char *string;
    double thickness;
    vec3 offset;
    if (!parse_font(p, &face))
        return false;
    accept(p, TOKEN_COMMA);
    struct span span = stream_span(p);
    if (!parse_string(p, &string))
        return false;
    warn_letters(p, string, span);
    accept(p, TOKEN_COMMA);
    if (!at_expression(p))
        return error_expected_hint(p, "how thick the letters are, a number",
                                   "text { ttf \"timrom.ttf\" \"A\" 1, 0 }");
    if (!parse_float(p, &thickness))
        return false;
    accept(p, TOKEN_COMMA);
    if (stream_peek(p)->kind == TOKEN_RBRACE)
        return error_expected_hint(p, "how far apart the letters are, a vector",
                                   "text { ttf \"timrom.ttf\" \"A\" 1, 0 }");
    return parse_vector(p, &offset) &&
           text_letters(p, text, face, string, thickness, offset);
}

/* text = "text" "{" text_arguments {modifier} "}" . */
bool parse_text(struct parser *p, struct object **out)
{
    struct span open;
    stream_next(p);
    struct object *text =
        object_new(p->scene_arena, OBJECT_UNION, p->last_span);
    struct modifiers m = { .object = text, .block = "text" };
    *out = text;
    return block_begin(p, &open) &&
           block_end(p, open,
                     parse_text_arguments(p, text) && parse_modifiers(p, &m));
}
