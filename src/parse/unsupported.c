/* Unsupported features: reported where they are written or, when declared,
 * where they are used. */
#include "parse/unsupported.h"

#include "parse/array.h"
#include "parse/symbol.h"

bool error_unsupported(struct parser *p, struct span span, const char *feature)
{
    if (!p->declaring)
        return error_at(p, span, NULL, "glim does not support %s yet", feature);
    if (!p->unsupported) {
        struct unsupported *kept = ARENA_NEW(p->arena, struct unsupported);
        kept->feature = arena_printf(p->arena, "%s", feature);
        kept->span = span;
        p->unsupported = kept;
    }
    return false;
}

void unsupported_report(struct parser *p, struct span span,
                        const struct word *word, const struct unsupported *why)
{
    if (!why)
        return;
    if (p->declaring) {
        if (!p->unsupported)
            p->unsupported = why;
        return;
    }
    error_at(p, span, NULL, "'%s' needs %s, which glim does not support yet",
             word->text, why->feature);
    note_at(p, why->span, "it is here");
}

bool unsupported_use(struct parser *p)
{
    const struct token *token = stream_peek(p);
    if (token->kind != TOKEN_WORD || token->word->reserved)
        return false;
    const struct value *value = symbol_find(p, token->word);
    if (value && value->kind == VALUE_ARRAY)
        value = array_sample(value->array);
    if (!value || value->kind != VALUE_UNSUPPORTED)
        return false;
    unsupported_report(p, p->token_span, token->word, value->unsupported);
    return true;
}
