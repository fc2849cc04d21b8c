/* Mistakes of those who come from another language or another renderer: what
 * was meant, and reading on as if it had been written, so that one mistake is
 * one error. */
#ifndef PARSE_MISTAKEN_H
#define PARSE_MISTAKEN_H

#include "parse/parser.h"

/* What to type for a word that no block knows: "angle" for fov. `block` is
 * the one it stands in, "" where a value is wanted. NULL: nothing comes to
 * mind. */
const char *mistaken_word(const struct word *word, const char *block);

/* The word in small letters. */
const struct word *mistaken_case(struct parser *p, const char *text,
                                 size_t length);

/* The word with a capital letter. */
const char *mistaken_capital(struct parser *p, const char *text);

/* What the next token was meant to be, where `wanted` was expected; or NULL. */
const char *mistaken_value(struct parser *p, const char *wanted);

/* If the next argument of a call is named, as in M(A=1): reports it. */
bool mistaken_named(struct parser *p);

/* If the next token is a unit of angles, as in `30*deg`: reports it. */
bool mistaken_degrees(struct parser *p);

/* Words that other languages want behind a condition: see text_among. */
extern const char mistaken_fillers[];

/* The directive that is meant by the word after a '#', or KEYWORD_NONE. */
enum keyword mistaken_directive_word(const struct word *word);

/* Whether it is an #elseif as others write it: where text is skipped nobody
 * else says so. */
bool mistaken_elseif(const struct token *token);

/* If the next token is a directive without its '#', or a declaration without
 * #declare: reports it, runs it and returns true. */
bool mistaken_statement(struct parser *p);

/* After an unknown directive like `#define A 1` was reported: declares the name
 * as something whose uses are not reported, and drops the rest of the line. */
void mistaken_define(struct parser *p, struct span at);

/* Drops the rest of the line of `at`, up to which was read. */
void mistaken_skip_line(struct parser *p, struct span at);

/* "srgb <255, 128, 0>/255" for ff8000, and for f80 likewise; else NULL. */
const char *mistaken_shade(struct parser *p, const char *digits);

/* If the next token touches the number before it, and is meant to be a part of
 * it, as in 0xff, 1.0f and 1_000, or its factor, as in 2x: reports it, takes it
 * and returns true. */
bool mistaken_number(struct parser *p);

/* The same of a comma behind the last token of a value, as in 1,5 and in a
 * vector without its brackets; it is not taken. */
bool mistaken_comma(struct parser *p, struct span last);

/* What to type for characters that only look right, or NULL. */
const char *mistaken_character(struct parser *p, struct span span);

#endif
