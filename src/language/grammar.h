/* What may stand in a block, told by grammar/ itself, which is a part of the
 * program: the same text that tests/tools/check-grammar holds the parser to. */
#ifndef LANGUAGE_GRAMMAR_H
#define LANGUAGE_GRAMMAR_H

#include <stdbool.h>
#include <stddef.h>

#include "base/arena.h"

struct grammar;

/* Kept in the arena. */
struct grammar *grammar_new(struct arena *arena);

struct grammar_item {
    const char *word;
    bool identifier;   /* `word` is TEXTURE, OBJECT ...: declared as such */
    const char *after; /* only right behind this word; NULL: anywhere */
    const char *rule;  /* "fade_distance float" */
    const char *value; /* what follows: "float", "vector" ...; or NULL */
};

struct grammar_items {
    struct grammar_item *items;
    size_t count, capacity;
    bool values; /* numbers, vectors, colours may stand there by themselves */
};

/* What may stand in the braces behind `block`; NULL: outside of all braces.
 * Nothing, if there is no such block. */
void grammar_block(struct grammar *grammar, struct arena *arena,
                   const char *block, struct grammar_items *items);

/* What a production with this name begins with. */
void grammar_production(struct grammar *grammar, struct arena *arena,
                        const char *name, struct grammar_items *items);

/* How a word is used, one line for each place that has it: "in finish:
 * diffuse [albedo] float"; NULL: the grammar doesn't have it. */
const char *grammar_usage(struct grammar *grammar, struct arena *arena,
                          const char *word);

#endif
