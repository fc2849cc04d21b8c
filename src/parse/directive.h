/* The interface of the directives: what stands after '#'. One row in
 * directive/list.h each; related ones share a file. */
#ifndef PARSE_DIRECTIVE_H
#define PARSE_DIRECTIVE_H

#include "parse/stream.h"

struct directive {
    /* Called with the directive's own token taken; `at` is its span. False
     * after an error was reported. */
    bool (*run)(struct parser *p, struct span at);
    const char *help;
};

/* Runs the directive that is the next raw token of the top cursor. */
bool directive_run(struct parser *p);

bool directive_is(enum keyword keyword);

/* What it does, in a few words; NULL: there is no such directive. */
const char *directive_help(enum keyword keyword);

/* Runs this directive instead of what was written at `at` and is reported by
 * now; the cursor is behind it. What else is wrong with it is not told.
 * Returns false. */
bool directive_run_as(struct parser *p, enum keyword keyword, struct span at);

/* The innermost open block of the top cursor, or NULL. */
struct open_block *directive_block(struct parser *p);
struct open_block *directive_open(struct parser *p, enum block_kind kind,
                                  struct span at);
void directive_close(struct parser *p);

/* Around the reading of a directive's condition, whatever garbage it may be:
 * the directives in it can't close blocks outside it, and the text can't end
 * in the middle. */
struct directive_head {
    struct cursor *directive, *head;
    size_t blocks;
};
struct directive_head directive_head_begin(struct parser *p);
void directive_head_end(struct parser *p, struct directive_head outer);

/* The same for one in parentheses: back in the text it began in, where the
 * directive's block is. False after an error: it ended in a file or a macro
 * that it called. */
bool directive_condition_end(struct parser *p, struct directive_head outer);

/* Reads a directive's condition or number without running what follows it. */
bool directive_float(struct parser *p, double *out);
bool directive_string(struct parser *p, const char **out);

/* Skips to the #end of the innermost block and closes it. */
bool directive_skip_to_end(struct parser *p);

/* "F" before `(F)`, where a name stands without brackets; else NULL. */
const char *directive_bracketed_name(struct parser *p);

#endif
