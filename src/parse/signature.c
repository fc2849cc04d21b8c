/* What is being read, for the words of errors: the field a value is for, and
 * how the values of a shape are written. */
#include <ctype.h>
#include <string.h>

#include "parse/expression.h"
#include "parse/parser.h"
#include "parse/stream.h"
#include "scene/primitive.h"

enum { SIGNATURE_LIMIT = 8 }; /* arguments that are told */

static bool field_is_vector(const struct field *field)
{
    return field->kind == FIELD_VECTOR || field->kind == FIELD_VECTOR2 ||
           field->kind == FIELD_VECTOR5 || field->kind == FIELD_TERMS;
}

const char *primitive_signature(struct parser *p, const char *name)
{
    const struct primitive *primitive = primitive_find(name);
    const struct field *field = primitive ? primitive->arguments : NULL;
    if (!field || !field->name)
        return NULL;
    const char *text = arena_printf(p->arena, "%s {", name);
    for (int i = 0; field[i].name && i < SIGNATURE_LIMIT; i++) {
        bool points =
            field[i].kind == FIELD_POINTS || field[i].kind == FIELD_POINTS2;
        if (i == 0 && points)
            return arena_printf(p->arena, "%s 4, <point>, <point> ... }", text);
        if (field[i].optional || points)
            return arena_printf(p->arena, "%s ... }", text);
        bool vector = field_is_vector(&field[i]);
        text =
            arena_printf(p->arena, "%s%s%s%s%s", text, i ? ", " : " ",
                         vector ? "<" : "", field[i].name, vector ? ">" : "");
    }
    return arena_printf(p->arena, "%s ... }", text);
}

const char *primitive_hint(struct parser *p, const char *name)
{
    struct span at = p->token_span;
    if (p->block_count == 0)
        return NULL;
    struct span open = p->blocks[p->block_count - 1];
    for (size_t i = open.offset; i < at.offset; i++)
        if (at.source != open.source ||
            (isalpha((unsigned char)at.source->text[i]) &&
             !strchr("xyz", at.source->text[i])))
            return NULL;
    return primitive_signature(p, name);
}

const char *wanted_field(struct parser *p, const char *wanted, unsigned deeper)
{
    bool value = strcmp(wanted, "a number") == 0 ||
                 strcmp(wanted, "a vector") == 0 ||
                 strcmp(wanted, "a colour") == 0;
    if (!p->field || !value || p->nesting > p->field_nesting + deeper)
        return wanted;
    return arena_printf(p->arena, "%s for '%s'", wanted, p->field->name);
}

const char *wanted_signature(struct parser *p, unsigned deeper)
{
    bool argument =
        p->field && p->shape && p->nesting <= p->field_nesting + deeper;
    return argument ? primitive_signature(p, p->shape) : NULL;
}

const char *wanted_example(struct parser *p, const char *wanted)
{
    static const struct {
        const char *wanted, *value;
    } examples[] = {
        { "a number", "1" },
        { "a vector", "<0, 1, 0>" },
        { "a colour", "rgb 1" },
    };
    struct span last = p->last_span;
    const char *text = last.source ? last.source->text + last.offset : "";
    enum token_kind next = stream_peek(p)->kind;
    if (!isalpha((unsigned char)*text) || next == TOKEN_EQUAL ||
        next == TOKEN_COLON || next == TOKEN_COMMA)
        return NULL;
    const struct word *word = word_intern(p->words, text, last.length);
    if (!word->reserved || constant_is(p, word->keyword))
        return NULL;
    for (size_t i = 0; i < sizeof examples / sizeof *examples; i++)
        if (strncmp(wanted, examples[i].wanted, strlen(examples[i].wanted)) ==
            0)
            return arena_printf(p->arena, "%.*s %s ...", (int)last.length, text,
                                examples[i].value);
    return NULL;
}
