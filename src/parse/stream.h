/* The token stream: cursors over token arrays, the stack of includes, macro
 * calls and function calls. Fetching a token runs the directives and expands
 * the macros in front of it. */
#ifndef PARSE_STREAM_H
#define PARSE_STREAM_H

#include "parse/parser.h"

enum cursor_kind {
    CURSOR_FILE,
    CURSOR_MACRO,
    CURSOR_RANGE, /* a user function's body: ends in TOKEN_END, popped by its
                   * caller */
};

/* An #if, #switch, #while or #for that is open in a cursor. */
enum block_kind { BLOCK_IF, BLOCK_SWITCH, BLOCK_WHILE, BLOCK_FOR };

struct open_block {
    enum block_kind kind;
    struct span span;      /* of the directive */
    struct span otherwise; /* of the #else that is being read, if it is_else */
    bool is_else;
    size_t condition;      /* token index to go back to */
    unsigned rounds;       /* of a loop so far */
    unsigned long changes; /* p->changes when the condition was last read */
    unsigned long asked;   /* hash of what it asked for when last looked at */
    unsigned same;         /* how often that was the same, one after another */
    const struct word *variable; /* of a #for */
    double value, last, step;    /* of a #while the value is how far it was from
                                  * its end when last looked at */
};

struct cursor {
    struct cursor *below;
    enum cursor_kind kind;
    const struct token_list *list;
    size_t index, end;        /* next token, one past the last */
    const struct word *macro; /* its name, for notes */
    struct span called_at;    /* the macro call */
    bool owns_scope;
    struct {
        struct open_block *items;
        size_t count, capacity;
    } blocks;
};

/* As stream_peek, for the place where an operator, a ';' or a further part of
 * the value may follow. While the condition or the value of a directive is
 * being read, directives and macros after it must not run yet: they show as
 * TOKEN_END here. Elsewhere the same as stream_peek. */
const struct token *stream_peek_infix(struct parser *p);

/* Reads the condition or value of a directive: between begin and end,
 * stream_peek_infix stops at what follows. end also gives back a token that
 * was looked at but not taken. */
struct cursor *stream_directive_begin(struct parser *p);
void stream_directive_end(struct parser *p, struct cursor *outer);

/* New tops of the stack. False after an error (too deep). A macro's scope is
 * the one on top when it is pushed and ends with it. */
bool stream_push_file(struct parser *p, const struct token_list *list);
bool stream_push_macro(struct parser *p, const struct token_list *list,
                       size_t first, size_t end, const struct word *name,
                       struct span called_at);
bool stream_push_range(struct parser *p, const struct token_list *list,
                       size_t first, size_t end, const struct word *name,
                       struct span called_at);
/* Back to the cursor under a range, whatever is left in it. */
void stream_pop_range(struct parser *p);

/* Back to a cursor below, whatever is left in those above; true if there were
 * none. */
bool stream_pop_to(struct parser *p, const struct cursor *cursor);

/* The tokens after the one peeked, as written, in the current cursor: for
 * fast paths. stream_skip_raw drops the peeked token and n after it. */
const struct token *stream_raw(struct parser *p, size_t *available);
void stream_skip_raw(struct parser *p, size_t n);

/* Counts a round of a loop, the call of a macro or an include at `span`, which
 * is as long as `cost` rounds. False, with the parse stopped, when there were
 * too many. */
bool stream_round(struct parser *p, unsigned cost, struct span span);
unsigned stream_round_limit(const struct parser *p); /* of one loop */

/* Whether the parse is to be given up, quietly; then it is. For work that takes
 * long without reading a token. */
bool stream_stopped(struct parser *p);

/* Much memory was taken at once: the next token asks whether it
 * is too much, as one of many does. */
void stream_ask(struct parser *p);

/* Stops the parse: from now on there is only TOKEN_END. */
void stream_abort(struct parser *p);

/* Whether the directive goes up to an #end of its own. */
bool stream_block_opens(enum keyword keyword);

/* Moves the top cursor past skipped text to the directive, one of the
 * keywords in `stops` (KEYWORD_NONE ends the list), that belongs to the block
 * whose inside it is in. Returns which, its token not taken; KEYWORD_NONE
 * after reporting that `#end` is missing for `open`. */
enum keyword stream_skip_block(struct parser *p, const enum keyword *stops,
                               struct span open);

#endif
