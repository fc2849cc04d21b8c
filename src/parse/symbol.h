/* Identifiers and their scopes: one global, one for each include and macro
 * being read. Scopes are dynamic, as in POV-Ray: a macro sees its caller's
 * #local identifiers. */
#ifndef PARSE_SYMBOL_H
#define PARSE_SYMBOL_H

#include "parse/parser.h"

struct symbol {
    const struct word *word;
    struct value value;
    struct symbol *shadowed; /* the same word in an outer scope */
    struct symbol *next;     /* in the scope's list */
    struct scope *scope;
    const char *deprecated; /* message for its use, or NULL */
    bool deprecated_once;
    struct value *element; /* of an array, which this parameter stands for: it
                            * has the value, which is copied here */
};

bool scope_push(struct parser *p);
void scope_pop(struct parser *p);

/* Gives the symbol, and what it stands for, a value. */
void symbol_give(struct parser *p, struct symbol *symbol,
                 const struct value *value);

/* The innermost symbol, references followed; NULL: not declared. */
struct symbol *symbol_lookup(struct parser *p, const struct word *word);

/* A symbol in `scope` (local) or, when the word is not visible from there
 * yet, in the global one; VALUE_NONE if new. Scopes open within it don't
 * count. */
struct symbol *symbol_make_in(struct parser *p, struct scope *scope,
                              const struct word *word, bool local);
/* A macro's parameter: always new, in the innermost scope. */
struct symbol *symbol_make_parameter(struct parser *p, const struct word *word);

void symbol_undefine(struct parser *p, const struct word *word);

/* Says once or always that a deprecated identifier was used. */
void symbol_warn(struct parser *p, struct symbol *symbol, struct span span);

/* The declared identifier most like `text`, or NULL. */
const char *symbol_nearest(struct parser *p, const char *text);

#endif
