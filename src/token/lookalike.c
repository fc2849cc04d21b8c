/* Typographers' characters: see lookalike.h. */
#include "token/lookalike.h"

#include <string.h>

static const struct lookalike lookalikes[] = {
    { "\xe2\x80\x9c", "\"", TOKEN_STRING }, /* left, right, low double quote */
    { "\xe2\x80\x9d", "\"", TOKEN_STRING },
    { "\xe2\x80\x9e", "\"", TOKEN_STRING },
    { "\xc2\xab", "\"", TOKEN_STRING }, /* guillemets */
    { "\xc2\xbb", "\"", TOKEN_STRING },
    { "\xe2\x80\x98", "\"", TOKEN_STRING }, /* single quotes */
    { "\xe2\x80\x99", "\"", TOKEN_STRING },
    { "\xe2\x88\x92", "-", TOKEN_MINUS }, /* minus, hyphen, dashes */
    { "\xe2\x80\x90", "-", TOKEN_MINUS },
    { "\xe2\x80\x93", "-", TOKEN_MINUS },
    { "\xe2\x80\x94", "-", TOKEN_MINUS },
    { "\xc3\x97", "*", TOKEN_STAR }, /* times, middle dot */
    { "\xc2\xb7", "*", TOKEN_STAR },
    { "\xc3\xb7", "/", TOKEN_SLASH }, /* divided by */
    { "\xe2\x89\xa4", "<=", TOKEN_LESS_EQUAL },
    { "\xe2\x89\xa5", ">=", TOKEN_GREATER_EQUAL },
    { "\xe2\x89\xa0", "!=", TOKEN_NOT_EQUAL },
    { "\xc2\xa0", "a blank", TOKEN_END },     /* no-break space */
    { "\xe3\x80\x80", "a blank", TOKEN_END }, /* ideographic space */
    { "\xe2\x80\xb9", "<", TOKEN_LESS },      /* angle brackets */
    { "\xe2\x80\xba", ">", TOKEN_GREATER },
    { "\xe2\x9f\xa8", "<", TOKEN_LESS },
    { "\xe2\x9f\xa9", ">", TOKEN_GREATER },
    { "\xe3\x80\x88", "<", TOKEN_LESS },
    { "\xe3\x80\x89", ">", TOKEN_GREATER },
    { "\xef\xbc\x9c", "<", TOKEN_LESS }, /* as wide as Chinese characters */
    { "\xef\xbc\x9e", ">", TOKEN_GREATER },
    { "\xef\xbc\x88", "(", TOKEN_LPAREN },
    { "\xef\xbc\x89", ")", TOKEN_RPAREN },
    { "\xef\xbd\x9b", "{", TOKEN_LBRACE },
    { "\xef\xbd\x9d", "}", TOKEN_RBRACE },
    { "\xef\xbc\xbb", "[", TOKEN_LBRACKET },
    { "\xef\xbc\xbd", "]", TOKEN_RBRACKET },
    { "\xef\xbc\x8c", ",", TOKEN_COMMA },
    { "\xe3\x80\x81", ",", TOKEN_COMMA },
    { "\xef\xbc\x9b", ";", TOKEN_SEMICOLON },
    { "\xef\xbc\x9d", "=", TOKEN_EQUAL },
    { "\xef\xbc\x8b", "+", TOKEN_PLUS },
    { "\xef\xbc\x8d", "-", TOKEN_MINUS },
    { "\xef\xbc\x8a", "*", TOKEN_STAR },
    { "\xef\xbc\x8f", "/", TOKEN_SLASH },
    { "\xef\xbc\x82", "\"", TOKEN_STRING },
};

const struct lookalike *lookalike_find(const char *text)
{
    for (size_t i = 0; i < sizeof lookalikes / sizeof *lookalikes; i++)
        if (strncmp(text, lookalikes[i].bytes, strlen(lookalikes[i].bytes)) ==
            0)
            return &lookalikes[i];
    return NULL;
}

size_t lookalike_string(const char *text, size_t *open, size_t *close)
{
    const struct lookalike *quote = lookalike_find(text);
    if (!quote || quote->kind != TOKEN_STRING)
        return 0;
    *open = strlen(quote->bytes);
    for (size_t at = *open; text[at] && !strchr("\r\n", text[at]); at++) {
        const struct lookalike *end = lookalike_find(text + at);
        bool straight = text[at] == '"';
        if (!straight && (!end || end->kind != TOKEN_STRING))
            continue;
        *close = straight ? 1 : strlen(end->bytes);
        return at + *close;
    }
    return 0;
}
