/* A source cut into tokens, once; loops and macros walk over the array. */
#ifndef TOKEN_TOKEN_H
#define TOKEN_TOKEN_H

#include "text/source.h"

/* Punctuation, X(name, spelling). Two-character operators first. */
#define TOKEN_PUNCTUATION(X)                                                   \
    X(LESS_EQUAL, "<=")                                                        \
    X(GREATER_EQUAL, ">=")                                                     \
    X(NOT_EQUAL, "!=")                                                         \
    X(LBRACE, "{")                                                             \
    X(RBRACE, "}")                                                             \
    X(LPAREN, "(")                                                             \
    X(RPAREN, ")")                                                             \
    X(LBRACKET, "[")                                                           \
    X(RBRACKET, "]")                                                           \
    X(LESS, "<")                                                               \
    X(GREATER, ">")                                                            \
    X(EQUAL, "=")                                                              \
    X(PLUS, "+")                                                               \
    X(MINUS, "-")                                                              \
    X(STAR, "*")                                                               \
    X(SLASH, "/")                                                              \
    X(AND, "&")                                                                \
    X(OR, "|")                                                                 \
    X(NOT, "!")                                                                \
    X(COMMA, ",")                                                              \
    X(SEMICOLON, ";")                                                          \
    X(DOT, ".")                                                                \
    X(COLON, ":")                                                              \
    X(QUESTION, "?")                                                           \
    X(OTHER, "") /* @ $ % \ ^ ~ ` ': legal in skipped text only */

enum token_kind {
    TOKEN_END, /* of the source; its span is empty */
    TOKEN_NUMBER,
    TOKEN_STRING,
    TOKEN_WORD,
    TOKEN_DIRECTIVE, /* '#' and the word after it */
    TOKEN_BAD,       /* an error kept until somebody reads the token */
    TOKEN_NUMBERS,   /* a long list of vectors with its braces: numbers.h */
    TOKEN_TRIANGLES, /* of a mesh, one after the other: triangles.h */
#define X(name, spelling) TOKEN_##name,
    TOKEN_PUNCTUATION(X)
#undef X
};

/* A word, interned: equal words are one pointer. */
struct word {
    const char *text;
    unsigned short length;
    unsigned short keyword; /* enum keyword, KEYWORD_NONE for the others */
    unsigned id;            /* 0, 1, 2 ... in order of first appearance */
    bool reserved;          /* can't be declared: keywords, shapes, patterns */
};

struct token {
    uint32_t offset; /* into the source */
    uint16_t kind;
    uint16_t length; /* 65535 also stands for longer */
    union {
        double number;
        const struct word *word; /* TOKEN_WORD, TOKEN_DIRECTIVE */
        const struct number_list *numbers;
        const struct triangle_run *triangles;
        const char *text; /* TOKEN_STRING: escapes resolved.
                           * TOKEN_BAD: what is wrong */
    };
};

/* All tokens of a source; the last is TOKEN_END. */
struct token_list {
    const struct source *source;
    struct token *tokens;
    size_t count;
};

struct span token_span(const struct token_list *list, size_t index);

/* How a token kind is called in messages: "'{'", "a number". */
const char *token_kind_name(enum token_kind kind);

#endif
