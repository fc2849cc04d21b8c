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
    { "\xc2\xa0", "a blank", TOKEN_END }, /* no-break space */
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
