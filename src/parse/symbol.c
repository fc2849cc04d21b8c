/* Identifiers: every word has a stack of its symbols, innermost on top, so
 * that looking one up costs one index. */
#include "parse/symbol.h"

#include "base/text.h"
#include "parse/array.h"
#include "parse/stream.h"

struct scope {
    struct scope *parent;
    struct symbol *symbols;
    unsigned long changes; /* of them, which are forgotten with them */
};

/* Freed symbols are kept for reuse: macros called a million times would
 * otherwise fill the arena. */
static struct symbol *symbol_allocate(struct parser *p)
{
    struct symbol *symbol = p->free_symbols;
    if (!symbol)
        return ARENA_NEW(p->arena, struct symbol);
    p->free_symbols = symbol->next;
    *symbol = (struct symbol){ 0 };
    return symbol;
}

static struct symbol **symbol_top(struct parser *p, const struct word *word)
{
    while (word->id >= p->symbols.count)
        *ARRAY_PUSH(p->arena, &p->symbols) = NULL;
    return &p->symbols.items[word->id];
}

bool scope_push(struct parser *p)
{
    struct scope *scope = p->free_scopes;
    if (scope)
        p->free_scopes = scope->parent;
    else
        scope = ARENA_NEW(p->arena, struct scope);
    *scope = (struct scope){ .parent = p->scope };
    p->scope = scope;
    return true;
}

/* Takes the symbol out of its word's stack, wherever it is in it. */
static void symbol_unlink(struct parser *p, struct symbol *symbol)
{
    struct symbol **link = symbol_top(p, symbol->word);
    while (*link && *link != symbol)
        link = &(*link)->shadowed;
    if (*link)
        *link = symbol->shadowed;
}

void scope_pop(struct parser *p)
{
    struct scope *scope = p->scope;
    while (scope->symbols) {
        struct symbol *symbol = scope->symbols;
        scope->symbols = symbol->next;
        symbol_unlink(p, symbol);
        symbol->next = p->free_symbols;
        p->free_symbols = symbol;
    }
    p->changes -= scope->changes;
    p->scope = scope->parent;
    scope->parent = p->free_scopes;
    p->free_scopes = scope;
}

/* Itself, or what it stands for. */
static struct symbol *symbol_meant(struct symbol *symbol)
{
    while (symbol && symbol->value.kind == VALUE_REFERENCE)
        symbol = symbol->value.symbol;
    if (symbol && symbol->element)
        symbol->value = *symbol->element;
    return symbol;
}

struct symbol *symbol_lookup(struct parser *p, const struct word *word)
{
    return word->id < p->symbols.count
               ? symbol_meant(p->symbols.items[word->id])
               : NULL;
}

const struct value *symbol_find(struct parser *p, const struct word *word)
{
    struct symbol *symbol = symbol_lookup(p, word);
    return symbol && symbol->value.kind != VALUE_NONE ? &symbol->value : NULL;
}

bool at_poison(struct parser *p)
{
    const struct token *token = stream_peek(p);
    if (token->kind != TOKEN_WORD || token->word->reserved)
        return false;
    const struct value *value = symbol_find(p, token->word);
    if (value && value->kind == VALUE_ARRAY)
        value = array_sample(value->array);
    return value && value->kind == VALUE_POISON;
}

static struct symbol *symbol_add(struct parser *p, struct scope *scope,
                                 const struct word *word)
{
    struct symbol *symbol = symbol_allocate(p);
    symbol->word = word;
    symbol->scope = scope;
    symbol->next = scope->symbols;
    scope->symbols = symbol;
    return symbol;
}

/* A global goes under the locals of the same word. */
static void symbol_link_global(struct parser *p, struct symbol *symbol)
{
    struct symbol **link = symbol_top(p, symbol->word);
    while (*link)
        link = &(*link)->shadowed;
    *link = symbol;
}

struct symbol *symbol_make_parameter(struct parser *p, const struct word *word)
{
    struct symbol **top = symbol_top(p, word);
    struct symbol *symbol = symbol_add(p, p->scope, word);
    symbol->shadowed = *top;
    *top = symbol;
    return symbol;
}

/* Whether a scope is open within `outer`. */
static bool scope_is_within(const struct parser *p, const struct scope *scope,
                            const struct scope *outer)
{
    for (const struct scope *s = p->scope; s && s != outer; s = s->parent)
        if (s == scope)
            return true;
    return false;
}

struct symbol *symbol_make_in(struct parser *p, struct scope *scope,
                              const struct word *word, bool local)
{
    struct symbol **top = symbol_top(p, word);
    while (*top && scope_is_within(p, (*top)->scope, scope))
        top = &(*top)->shadowed;
    struct symbol *found = symbol_meant(*top);
    if (!local) {
        if (found)
            return found;
        found = symbol_add(p, p->global, word);
        symbol_link_global(p, found);
        return found;
    }
    if (*top && (*top)->scope == scope)
        return found;
    struct symbol *symbol = symbol_add(p, scope, word);
    symbol->shadowed = *top;
    *top = symbol;
    return symbol;
}

void symbol_set(struct parser *p, const struct word *word, struct value value,
                bool local)
{
    symbol_give(p, symbol_make_in(p, p->scope, word, local), &value);
}

/* Surely the same, that is: not all are compared. */
static bool value_is_same(const struct value *a, const struct value *b)
{
    if (a->kind != b->kind || a->size != b->size)
        return false;
    switch (a->kind) {
    case VALUE_FLOAT:
        return a->number[0] == b->number[0];
    case VALUE_VECTOR:
    case VALUE_COLOUR:
        return memcmp(a->number, b->number, sizeof a->number) == 0;
    case VALUE_STRING:
        return strcmp(a->text, b->text) == 0;
    default:
        return false;
    }
}

void symbol_give(struct parser *p, struct symbol *symbol,
                 const struct value *value)
{
    if (!value_is_same(&symbol->value, value)) {
        p->changes++;
        symbol->scope->changes += !symbol->element;
    }
    value_copy(&symbol->value, value);
    if (symbol->element)
        value_copy(symbol->element, value);
}

/* The symbol stays in its scope's list and is freed with it. */
void symbol_undefine(struct parser *p, const struct word *word)
{
    struct symbol *symbol = symbol_lookup(p, word);
    p->changes++;
    if (symbol)
        symbol->value = (struct value){ .kind = VALUE_NONE };
}

const char *symbol_nearest(struct parser *p, const char *text)
{
    struct text_nearest nearest = text_nearest_start(text);
    for (struct scope *scope = p->scope; scope; scope = scope->parent)
        for (struct symbol *s = scope->symbols; s; s = s->next)
            if (s->value.kind != VALUE_NONE)
                text_nearest_try(&nearest, s->word->text);
    return nearest.best;
}

void symbol_warn(struct parser *p, struct symbol *symbol, struct span span)
{
    if (!symbol->deprecated)
        return;
    warning_at(p, span, NULL, "'%s' is deprecated: %s", symbol->word->text,
               symbol->deprecated);
    if (symbol->deprecated_once)
        symbol->deprecated = NULL;
}

const struct value *accept_value(struct parser *p, enum value_kind kind)
{
    const struct token *token = stream_peek(p);
    if (token->kind != TOKEN_WORD || token->word->reserved)
        return NULL;
    struct symbol *symbol = symbol_lookup(p, token->word);
    if (!symbol)
        return NULL;
    struct value *value = &symbol->value;
    bool element = value->kind == VALUE_ARRAY && kind != VALUE_ARRAY;
    if ((element ? array_kind(value->array) : value->kind) != kind)
        return NULL;
    symbol_warn(p, symbol, p->token_span);
    stream_next(p);
    if (!element)
        return value;
    if (!array_element(p, value->array, &value)) {
        p->blamed = p->last_span;
        return NULL;
    }
    if (value->kind == kind)
        return value;
    p->blamed = p->last_span;
    if (value->kind == VALUE_POISON)
        return NULL;
    if (value->kind == VALUE_NONE)
        error_at(p, p->last_span, NULL, "this element of '%s' was never set",
                 symbol->word->text);
    else
        error_at(p, p->last_span, NULL, "this element of '%s' is %s, not %s",
                 symbol->word->text, value_kind_name(value->kind),
                 value_kind_name(kind));
    return NULL;
}
