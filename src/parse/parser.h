/* The parser's own state and the calls its files share. Outside parse/ only
 * parse.h is seen.
 *
 * Rules return false after they have reported an error; the caller passes it
 * on or skips to the end of its block. Nothing here exits or jumps. */
#ifndef PARSE_PARSER_H
#define PARSE_PARSER_H

#include "base/array.h"
#include "base/field.h"
#include "parse/parse.h"
#include "parse/value.h"
#include "token/lexer.h"

struct cursor;
struct data_files;
struct density_cache;
struct image_cache;
struct scope;
struct typeface;

/* Limits, each with its reason. */
enum {
    PARSE_CURSOR_LIMIT = 1000,   /* includes and macro calls inside each other:
                                  * endless recursion of a macro */
    PARSE_NESTING_LIMIT = 200,   /* braces, parentheses: the C stack */
    PARSE_LOOP_LIMIT = 10000000, /* rounds of one #while or #for */
    PARSE_ROUNDS_FACTOR = 3,     /* that many times more rounds of all loops and
                                  * calls of macros together */
    PARSE_ROUNDS_AFTER_ERROR = 100000, /* what a loop waits for may never come
                                        * after an error */
};

/* A #declare whose value is being read. */
struct declaring {
    const struct word *name;
    unsigned block_count; /* of the blocks it stands in */
    const struct declaring *outer;
};

struct parser {
    const struct parse_options *options;
    struct diag *diag;
    struct arena *sources;     /* texts, until exit */
    struct arena *arena;       /* this parse */
    struct arena *scene_arena; /* what the scene keeps */
    struct scene *scene;
    struct word_table *words;
    struct cursor *cursor;    /* top of the include/macro stack; stream.c */
    struct cursor *directive; /* the cursor a directive's value is read in */
    struct cursor *head; /* the one whose directive's condition is being read:
                          * it is not left, nor are its blocks, until then */
    size_t head_blocks;  /* how many of them */
    struct cursor *free_cursors;
    unsigned depth;                             /* cursors on the stack */
    struct scope *scope, *global, *free_scopes; /* symbol.c */
    struct symbol *free_symbols;
    struct {
        struct symbol **items; /* by word id: the innermost symbol */
        size_t count, capacity;
    } symbols;
    unsigned long changes; /* of symbols, arrays and random streams: a #while
                            * whose round changes none never ends */
    unsigned long rounds, rounds_after_error; /* see stream_round */
    struct token token;                /* the one looked at, if `peeked` */
    struct span token_span, last_span; /* of it; of the last one taken */
    bool peeked;
    unsigned fetched; /* tokens and directives that were looked for */
    unsigned nesting;
    struct span blocks[PARSE_NESTING_LIMIT]; /* the '{' of blocks being read */
    unsigned block_count;
    const struct field *field; /* whose value is being read, or NULL */
    unsigned field_nesting;    /* when its reading began */
    const char *shape;         /* whose arguments are being read, or NULL, */
    const char *infinite;      /* and the first that isn't finite, or NULL */
    const struct declaring *declaring; /* the #declare being read, or NULL */
    struct span blamed; /* the last token of a value that was reported and
                         * taken: what follows it is not at fault */
    struct span reported[DIAG_ERROR_LIMIT]; /* places of errors: once each */
    unsigned reported_count;
    unsigned long taken, taken_at_error; /* tokens; see error_follows */
    bool told; /* what is being read was reported: nothing more about it */
    bool spare_semicolon; /* a ';' that is next has no meaning */
    bool unclosed;  /* the innermost block lacks its '}', as was said: it ends
                     * here */
    bool silent;    /* the last error was not printed: nor are its notes */
    bool failed;    /* gave up: the stream only gives TOKEN_END from now on */
    double version; /* #version in force */
    bool version_said, noise_said; /* #version, noise_generator */
    struct {                       /* #default: what new things start from */
        const struct pigment *pigment;
        const struct normal *normal;
        const struct finish *finish;
        struct texture *texture; /* of the three, or of earlier ones */
    } defaults;
    const struct pigment *plain; /* what those of no surface start from */
    bool density; /* what is read is a pigment by the name of density */
    struct {
        struct finish **items;
        size_t count, capacity;
    } finishes; /* all: the last #version decides how they filter */
    struct {
        struct warned *items;
        size_t count, capacity;
    } warned;                   /* warnings that were given; error.c */
    struct image_cache *images; /* read for image_map; image_map.c */
    struct typeface *fonts;     /* read for text; text.c */
    bool letters_told;          /* that POV-Ray has other letters; text.c */
    struct shapes_made *shapes; /* object.c */
    struct curves_made *curves; /* of prisms and lathes; curve.c */
    struct density_cache *densities; /* read; density_file.c */
    struct data_files *data_files;   /* what the scene wrote; data_file.c */
    struct random_streams *randoms;  /* seed(), rand() */
    struct {
        const struct token_list **items;
        size_t count, capacity;
    } files; /* lexed includes, by source name: lexed once */
};

/* ---- stream.c: tokens after directives and macros have had their say ---- */

/* The next token without taking it; TOKEN_END at the end of all text. */
const struct token *stream_peek(struct parser *p);
struct token stream_next(struct parser *p);
struct span stream_span(struct parser *p); /* of the next token */

/* The keyword of the next token if it is a word, else KEYWORD_NONE. */
enum keyword stream_keyword(struct parser *p);

/* Takes the next token if it is this one. */
bool accept(struct parser *p, enum token_kind kind);
bool accept_keyword(struct parser *p, enum keyword keyword);

/* Takes the next token or reports "expected '}' to close 'sphere', found ...".
 * `open` is the span of the matching bracket for a note, or span_none(). */
bool expect(struct parser *p, enum token_kind kind, struct span open);

/* '{' after a keyword, one level deeper; its span into *open. block_end takes
 * the '}'. When `ok` is false the rest of the block is skipped instead and
 * false returned. */
bool block_begin(struct parser *p, struct span *open);
bool block_end(struct parser *p, struct span open, bool ok);

/* A keyword and a block of nothing but items. */
bool block_items(struct parser *p, bool (*item)(struct parser *p));

/* ---- error.c ---- */

/* Reports at the span with notes for the macro and include stack; returns
 * false. `hint` as in diag_print. */
__attribute__((format(printf, 4, 5))) bool error_at(struct parser *p,
                                                    struct span span,
                                                    const char *hint,
                                                    const char *format, ...);
__attribute__((format(printf, 4, 5))) void warning_at(struct parser *p,
                                                      struct span span,
                                                      const char *hint,
                                                      const char *format, ...);
__attribute__((format(printf, 3, 4))) void
note_at(struct parser *p, struct span span, const char *format, ...);

/* A note if the token before the next one is a string that goes on over lines:
 * it has most likely taken the quotes of the next string for its end. */
void note_long_string(struct parser *p);

/* "expected WANTED, found 'x'" at the next token, with "did you mean" from
 * what `where` accepts when the token is a word. */
bool error_expected(struct parser *p, const char *wanted);
bool error_expected_hint(struct parser *p, const char *wanted,
                         const char *hint);

/* "expected '{' after 'pigment', found 'T'"; what stands there instead of the
 * block is taken. `before` is what the block belongs to. */
bool error_unopened(struct parser *p, struct span before);

/* What the next word stands for is of a later version: "a dictionary needs
 * POV-Ray 3.8 ...; an array keeps values by number". The word is taken, and the
 * block behind it. */
bool error_later(struct parser *p, const char *hint, const char *what,
                 const char *instead);

/* The same of a word that an earlier version doesn't know, "" being the block
 * where a value is wanted; tells whether it is one. */
bool error_later_word(struct parser *p, const struct word *word,
                      const char *block);

/* An unknown word in a block: "unknown item 'pigmnt' in 'sphere'", the hint
 * being the nearest of the reserved words or of `fields`. */
bool error_unknown_item(struct parser *p, const char *block,
                        const struct field *fields);

/* After an error about the word in the scene: that it belongs into the object
 * before it, if so. */
void note_outside(struct parser *p, const struct word *word);

/* ---- unclosed.c ---- */

/* If the next token can't stand in the block it is in because the block lacks
 * its '}': a note at its '{', and block_end ends it before that token. */
void note_unclosed(struct parser *p);

/* "}" if the next token is, say, a 'finish' in a 'pigment'; else NULL. */
const char *unclosed_hint(struct parser *p);

/* ---- signature.c ---- */

/* "sphere { <centre>, radius ... }", or NULL: no shape, or not by a table. */
const char *primitive_signature(struct parser *p, const char *name);

/* The same, unless something else than numbers was read in the block. */
const char *primitive_hint(struct parser *p, const char *name);

/* "a number for 'radius'" if that is what is being read, else `wanted`. The
 * value itself is read `deeper` brackets than the field. */
const char *wanted_field(struct parser *p, const char *wanted, unsigned deeper);

/* The signature of the shape whose argument is being read, or NULL. */
const char *wanted_signature(struct parser *p, unsigned deeper);

/* "phong 1 ..." where the number after that word is missing; else NULL. The
 * dots say that it is no edit of what is marked. */
const char *wanted_example(struct parser *p, const char *wanted);

/* ---- library.c ---- */

/* Where an error is shown first: the place itself or, inside POV-Ray's own
 * include files, what of the user's led there. */
struct span library_user(struct parser *p, struct span span);

/* ---- expression.c: values are evaluated as they are read ---- */

/* For a '(' that is missing at `start`: the rest of a short line in
 * parentheses, up to the next directive; of `#case 1:` the number. */
const char *condition_hint(struct parser *p, struct span start);

bool parse_expression(struct parser *p, struct value *value);
bool parse_float(struct parser *p, double *out);
/* A float in which comparisons need no parentheses: #if, #while ... */
bool parse_condition(struct parser *p, double *out);
bool parse_integer(struct parser *p, int *out);
bool parse_bool(struct parser *p,
                bool *out); /* on, off, number; no value: on */
bool parse_vector(struct parser *p, vec3 *out);
/* 2 to 5 components as they are; a float is promoted to `size`. */
bool parse_components(struct parser *p, double *out, int size);
/* `rgb <..>`, `color red 1 green .5`, an identifier, or a vector. With
 * `bare_vector` false a vector needs rgb, rgbf, color ... before it. */
bool parse_colour(struct parser *p, colour *out);
bool parse_string(struct parser *p, const char **out);
/* Reads a colour, or a number alone: *is_number. */
bool parse_colour_or_number(struct parser *p, colour *out, double *number,
                            bool *is_number);
/* Whether the next token can begin an expression / one that is a number, as
 * far as can be told without reading it / a colour. */
bool at_expression(struct parser *p);
bool at_number(struct parser *p);
bool at_colour(struct parser *p);

/* ---- args.c: values by field table ---- */

/* Whether `open` or `sturm` stands before what it follows, a shape's points;
 * says so. */
bool points_flagged(struct parser *p);

bool parse_arguments(struct parser *p, const struct field *table, void *base);
/* Reads the value of one field (its name has been taken). */
bool parse_field(struct parser *p, const struct field *field, void *base);

/* ---- symbol.c ---- */

/* The value of an identifier, or NULL. */
const struct value *symbol_find(struct parser *p, const struct word *word);
/* Whether the next token is an identifier whose declaration had an error, of
 * which no more is said. */
bool at_poison(struct parser *p);
void symbol_set(struct parser *p, const struct word *word, struct value value,
                bool local);

/* If the next token is an identifier that holds a value of this kind, takes
 * it and returns the value (array elements too: Name[3]). Otherwise NULL. */
const struct value *accept_value(struct parser *p, enum value_kind kind);

/* ---- file.c ---- */

/* The path of a file: as given, in the current directory, then in each library
 * path; then all that again with `extension` (may be NULL) added if the name
 * has none. NULL: not found. */
const char *file_locate(struct parser *p, const char *name,
                        const char *extension);

/* The same for what a scene names: NULL also if it may not be read. */
const char *file_find(struct parser *p, const char *name,
                      const char *extension);

/* file_find, which reports a file that is not found or may not be read. `what`
 * it is: "image". */
const char *file_need(struct parser *p, struct span span, const char *what,
                      const char *name, const char *extension);

/* The same for a path that was found, or NULL: returns it, or NULL after an
 * error. */
const char *file_checked(struct parser *p, struct span span, const char *what,
                         const char *name, const char *path);

/* The hint for a file that was not found: one with nearly that name, or
 * "looked in ., /usr/share/...; +LDIR adds others";
 * `what` is "font", "file" ... */
const char *file_hint(struct parser *p, const char *what, const char *name);

/* The name for messages: control characters as '?'. */
const char *file_shown(struct parser *p, const char *name);

/* ---- belongs.c ---- */

/* "finish { phong ... }" for a word that belongs into another block than this
 * one, "texture { T }" for a declared texture T; or NULL. */
const char *item_belongs(struct parser *p, const struct word *word,
                         const char *block);

/* "texture { T }" for a declared texture T where another part of an object is
 * wanted, or NULL. */
const char *item_wrapped(struct parser *p, const char *wanted);

/* ---- standard.c ---- */

/* '#include "colors.inc"' if that is what declares the name, the next token, or
 * NULL; what is called, as in M(1), must be a macro or a function there. */
const char *standard_include(struct parser *p, const char *name);

/* ---- scene rules: each file has the productions it reads ---- */

/* What a small reader did: it looks at the next token and does nothing when
 * that is not its own, so that a block tries one after the other and reports
 * what is left. A rule's false and true are the first two. */
enum taken { WRONG = false, TAKEN = true, NOT_MINE };

/* Anything #declare can name that is not an expression. */
enum taken parse_thing(struct parser *p, struct value *value);

bool parse_scene_item(struct parser *p); /* scene.c */
bool at_scene_item(struct parser *p);
bool at_object(struct parser *p); /* object.c */
bool parse_object(struct parser *p, struct object **out);
bool parse_camera(struct parser *p, struct camera *out);
bool parse_texture(struct parser *p, const struct texture **out);
bool parse_pigment(struct parser *p, const struct pigment **out);
bool parse_normal(struct parser *p, const struct normal **out);
bool parse_finish(struct parser *p, const struct finish **out);
bool parse_interior(struct parser *p, const struct interior **out);
bool parse_material(struct parser *p, struct material *out);
/* translate, rotate, scale, matrix, transform{}: composed after *transform. */
enum taken parse_transformation(struct parser *p, affine *transform);

/* The same; *alike is false from the first on that is no translation, rotation
 * or scaling that is the same along all axes. */
enum taken parse_transformation_alike(struct parser *p, affine *transform,
                                      bool *alike);
bool parse_global_settings(struct parser *p);
/* The inside of #default { }: up to the '}', which is not taken. */
bool parse_defaults(struct parser *p, struct span open);
/* What #default starts from. */
void defaults_init(struct parser *p);
/* After the last line: what is left to decide. */
void settings_finish(struct parser *p);

#endif
