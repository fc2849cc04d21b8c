/* Text to tokens, in one pass. Grammar: grammar/lexical.ebnf. */
#include "token/lexer.h"

#include "base/array.h"
#include "token/bulk.h"
#include "token/lookalike.h"

/* A longer word is an error in POV-Ray too, even in skipped text. */
enum { LEXER_WORD_LIMIT = 200 };

/* So many tokens wait on the stack: by then it is known how many there will be,
 * and memory that is new costs more than cutting them. */
enum { LEXER_FIRST = 4096 };

struct lexer {
    struct arena *arena;
    struct word_table *words;
    const char *text;
    size_t length, at; /* text[length] is NUL */
    struct {
        struct token *items;
        size_t count, capacity;
    } tokens;
    struct bulk bulk;
};

static bool is_digit(char c)
{
    return c >= '0' && c <= '9';
}

static bool is_word_start(char c)
{
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_';
}

static bool is_space(char c)
{
    return c == ' ' || (c >= '\t' && c <= '\r');
}

/* Control characters and what is not ASCII. */
static bool is_foreign(char c)
{
    return ((unsigned char)c < 32 && !is_space(c)) || (unsigned char)c > 126;
}

/* Room for as many tokens as the text so far foretells: meshes have tens of
 * millions, and moving them costs more than cutting them. */
static void lexer_reserve(struct lexer *lexer, size_t at)
{
    size_t count = lexer->tokens.count;
    double foretold =
        at ? (double)count / (double)at * (double)lexer->length * 1.05 : 0;
    size_t wanted = foretold < (double)lexer->length ? (size_t)foretold : 0;
    if (wanted < 2 * count)
        wanted = 2 * count;
    ARRAY_RESERVE(lexer->arena, &lexer->tokens, wanted + 64);
}

static struct token *lexer_push(struct lexer *lexer, enum token_kind kind,
                                size_t start, size_t end)
{
    if (lexer->tokens.count == lexer->tokens.capacity)
        lexer_reserve(lexer, start);
    struct token *token = ARRAY_PUSH(lexer->arena, &lexer->tokens);
    size_t length = end - start;
    *token =
        (struct token){ .offset = (uint32_t)start,
                        .kind = (uint16_t)kind,
                        .length = (uint16_t)(length > 65535 ? 65535 : length) };
    return token;
}

static void lexer_push_bad(struct lexer *lexer, size_t start, size_t end,
                           const char *problem)
{
    lexer_push(lexer, TOKEN_BAD, start, end)->text = problem;
}

/* comment = "//" {character} end_of_line
 *         | "/" "*" {character | comment} "*" "/" . */
static void lexer_skip_comment(struct lexer *lexer)
{
    const char *text = lexer->text;
    size_t start = lexer->at;
    if (text[start + 1] == '/') {
        while (lexer->at < lexer->length && text[lexer->at] != '\n' &&
               text[lexer->at] != '\r')
            lexer->at++;
        return;
    }
    unsigned depth = 0;
    do {
        if (lexer->at >= lexer->length) {
            lexer_push_bad(lexer, start, start + 2,
                           "this comment is not closed; type '*/'");
            return;
        }
        const char *here = text + lexer->at;
        bool opens = here[0] == '/' && here[1] == '*';
        bool closes = here[0] == '*' && here[1] == '/';
        if (opens)
            depth++;
        if (closes)
            depth--;
        lexer->at += opens || closes ? 2 : 1;
    } while (depth > 0);
}

static void lexer_number(struct lexer *lexer)
{
    const char *start = lexer->text + lexer->at, *end;
    double value = number_read(start, &end);
    bool second_point =
        *end == '.' && memchr(start, '.', (size_t)(end - start));
    while (second_point && (is_digit(*end) || *end == '.'))
        end++;
    size_t begin = lexer->at;
    lexer->at += (size_t)(end - start);
    if (second_point)
        lexer_push_bad(lexer, begin, lexer->at,
                       "this number has a second decimal point");
    else
        lexer_push(lexer, TOKEN_NUMBER, begin, lexer->at)->number = value;
}

static size_t lexer_word_end(const struct lexer *lexer, size_t at)
{
    while (is_word_start(lexer->text[at]) || is_digit(lexer->text[at]))
        at++;
    return at;
}

/* What is cut as one token, if that stands here. */
static bool lexer_bulk(struct lexer *lexer)
{
    size_t start = lexer->at, length;
    struct token bulk;
    if (!bulk_cut(&lexer->bulk, lexer->tokens.items, lexer->tokens.count,
                  lexer->text + start, &bulk, &length))
        return false;
    lexer->at = start + length;
    struct token *token = lexer_push(lexer, bulk.kind, start, lexer->at);
    bulk.offset = token->offset;
    bulk.length = token->length;
    *token = bulk;
    return true;
}

/* word = (letter | "_") {letter | digit | "_"} . */
static void lexer_word(struct lexer *lexer, enum token_kind kind, size_t start)
{
    size_t end = lexer_word_end(lexer, lexer->at), begin = lexer->at;
    lexer->at = end;
    if (end - begin > LEXER_WORD_LIMIT) {
        lexer_push_bad(lexer, start, end,
                       "this word is too long (limit: 200 characters)");
        return;
    }
    const struct word *word =
        word_intern(lexer->words, lexer->text + begin, end - begin);
    lexer_push(lexer, kind, start, end)->word = word;
}

/* A '#' that no word follows is skipped, as POV-Ray does.
 * directive = "#" {blank} word . */
static void lexer_directive(struct lexer *lexer)
{
    size_t start = lexer->at++;
    while (lexer->text[lexer->at] == ' ' || lexer->text[lexer->at] == '\t')
        lexer->at++;
    if (is_word_start(lexer->text[lexer->at]))
        lexer_word(lexer, TOKEN_DIRECTIVE, start);
}

static size_t lexer_put_utf8(char *out, unsigned code)
{
    if (code < 0x80) {
        out[0] = (char)code;
        return 1;
    }
    if (code < 0x800) {
        out[0] = (char)(0xc0 | code >> 6);
        out[1] = (char)(0x80 | (code & 63));
        return 2;
    }
    out[0] = (char)(0xe0 | code >> 12);
    out[1] = (char)(0x80 | (code >> 6 & 63));
    out[2] = (char)(0x80 | (code & 63));
    return 3;
}

static bool lexer_hex4(const char *text, unsigned *code)
{
    *code = 0;
    for (int i = 0; i < 4; i++) {
        char c = text[i];
        unsigned digit = is_digit(c)            ? (unsigned)(c - '0')
                         : c >= 'a' && c <= 'f' ? (unsigned)(c - 'a') + 10
                         : c >= 'A' && c <= 'F' ? (unsigned)(c - 'A') + 10
                                                : 99;
        if (digit > 15)
            return false;
        *code = *code * 16 + digit;
    }
    return true;
}

/* escape = "\" ("n" | "t" | "r" | "a" | "b" | "f" | "v" | "\" | "'" | '"'
 *        | "u" hex hex hex hex) .
 * Unknown escapes keep their backslash: Windows paths. Returns how many bytes
 * of the text were read. */
static size_t lexer_escape(const char *text, char *out, size_t *out_length)
{
    static const char letters[] = "ntrabfv\\'\"";
    static const char meanings[] = "\n\t\r\a\b\f\v\\'\"";
    const char *found = text[1] ? strchr(letters, text[1]) : NULL;
    unsigned code;
    if (found) {
        out[(*out_length)++] = meanings[found - letters];
        return 2;
    }
    if (text[1] == 'u' && lexer_hex4(text + 2, &code)) {
        *out_length += lexer_put_utf8(out + *out_length, code);
        return 6;
    }
    out[(*out_length)++] = '\\';
    return 1;
}

/* string = '"' {character | escape} '"' . */
static void lexer_string(struct lexer *lexer)
{
    size_t start = lexer->at, end = start + 1;
    const char *text = lexer->text;
    while (end < lexer->length && text[end] != '"')
        end += text[end] == '\\' && end + 1 < lexer->length ? 2 : 1;
    if (end >= lexer->length) {
        lexer_push_bad(lexer, start, start + 1,
                       "this string is not closed; type '\"' at its end");
        lexer->at = lexer->length;
        return;
    }
    char *value = arena_alloc(lexer->arena, end - start);
    size_t length = 0;
    for (size_t i = start + 1; i < end;) {
        if (text[i] == '\\')
            i += lexer_escape(text + i, value, &length);
        else
            value[length++] = text[i++];
    }
    lexer_push(lexer, TOKEN_STRING, start, end + 1)->text = value;
    lexer->at = end + 1;
}

static enum token_kind lexer_two_characters(const char *here)
{
    if (here[1] != '=')
        return TOKEN_OTHER;
    return *here == '<'   ? TOKEN_LESS_EQUAL
           : *here == '>' ? TOKEN_GREATER_EQUAL
           : *here == '!' ? TOKEN_NOT_EQUAL
                          : TOKEN_OTHER;
}

static void lexer_punctuation(struct lexer *lexer)
{
    static const unsigned char single[256] = {
        ['{'] = TOKEN_LBRACE, ['}'] = TOKEN_RBRACE,   ['('] = TOKEN_LPAREN,
        [')'] = TOKEN_RPAREN, ['['] = TOKEN_LBRACKET, [']'] = TOKEN_RBRACKET,
        ['<'] = TOKEN_LESS,   ['>'] = TOKEN_GREATER,  ['='] = TOKEN_EQUAL,
        ['+'] = TOKEN_PLUS,   ['-'] = TOKEN_MINUS,    ['*'] = TOKEN_STAR,
        ['/'] = TOKEN_SLASH,  ['&'] = TOKEN_AND,      ['|'] = TOKEN_OR,
        ['!'] = TOKEN_NOT,    [','] = TOKEN_COMMA,    [';'] = TOKEN_SEMICOLON,
        ['.'] = TOKEN_DOT,    [':'] = TOKEN_COLON,    ['?'] = TOKEN_QUESTION,
    };
    const char *here = lexer->text + lexer->at;
    enum token_kind pair = lexer_two_characters(here);
    enum token_kind kind =
        pair != TOKEN_OTHER ? pair : single[(unsigned char)*here];
    if (kind) {
        size_t length = pair != TOKEN_OTHER ? 2 : 1;
        lexer_push(lexer, kind, lexer->at, lexer->at + length);
        lexer->at += length;
        return;
    }
    lexer_push(lexer, TOKEN_OTHER, lexer->at, lexer->at + 1);
    lexer->at++;
}

/* What only looks right is an error, and then what it looks like. */
static bool lexer_lookalike(struct lexer *lexer)
{
    size_t start = lexer->at, open, close;
    const char *text = lexer->text + start;
    const struct lookalike *alike = lookalike_find(text);
    size_t length = lookalike_string(text, &open, &close);
    if (!alike || (alike->kind == TOKEN_STRING && length == 0))
        return false;
    if (length == 0)
        length = strlen(alike->bytes);
    lexer->at += length;
    lexer_push_bad(lexer, start, lexer->at,
                   alike->kind == TOKEN_STRING
                       ? "a string stands in straight double quotes"
                       : "this character only looks like the one meant");
    if (alike->kind == TOKEN_STRING)
        lexer_push(lexer, TOKEN_STRING, start, lexer->at)->text =
            arena_copy_text(lexer->arena, text + open, length - open - close);
    else if (alike->kind != TOKEN_END)
        lexer_push(lexer, alike->kind, start, lexer->at);
    return true;
}

/* A run of foreign characters is one error. After a NUL byte nothing is read:
 * this is no text, or UTF-16. */
static void lexer_foreign(struct lexer *lexer)
{
    size_t start = lexer->at;
    if (lexer_lookalike(lexer))
        return;
    while (lexer->at < lexer->length && lexer->text[lexer->at] &&
           is_foreign(lexer->text[lexer->at]))
        lexer->at++;
    if (lexer->text[lexer->at] || lexer->at == lexer->length) {
        lexer_push_bad(lexer, start, lexer->at,
                       "this character is only allowed in strings and "
                       "comments");
        return;
    }
    lexer_push_bad(lexer, start, lexer->at + 1,
                   "a NUL byte: this is not a text in ASCII or UTF-8");
    lexer->at = lexer->length;
}

static void lexer_token(struct lexer *lexer)
{
    const char *here = lexer->text + lexer->at;
    if (lexer_bulk(lexer))
        return;
    if (is_word_start(*here))
        lexer_word(lexer, TOKEN_WORD, lexer->at);
    else if (is_digit(*here) || (*here == '.' && is_digit(here[1])))
        lexer_number(lexer);
    else if (*here == '"')
        lexer_string(lexer);
    else if (*here == '#')
        lexer_directive(lexer);
    else if (*here == '/' && (here[1] == '/' || here[1] == '*'))
        lexer_skip_comment(lexer);
    else if (is_foreign(*here))
        lexer_foreign(lexer);
    else
        lexer_punctuation(lexer);
}

/* All of them, in the arena; `first` is where they began. */
static struct token *lexer_tokens(struct lexer *lexer,
                                  const struct token *first)
{
    if (lexer->tokens.items != first) {
        ARRAY_FIT(lexer->arena, &lexer->tokens);
        return lexer->tokens.items;
    }
    struct token *tokens =
        ARENA_ARRAY(lexer->arena, struct token, lexer->tokens.count);
    memcpy(tokens, first, lexer->tokens.count * sizeof *tokens);
    return tokens;
}

const struct token_list *lexer_run_part(struct arena *arena,
                                        struct word_table *words,
                                        const struct source *source,
                                        size_t start, size_t end)
{
    struct token first[LEXER_FIRST];
    struct lexer lexer = { .arena = arena,
                           .tokens = { first, 0, LEXER_FIRST },
                           .words = words,
                           .bulk = { arena, words, source->text + end },
                           .text = source->text,
                           .length = end,
                           .at = start };
    while (lexer.at < lexer.length && !arena_over_limit(arena)) {
        if (is_space(lexer.text[lexer.at]))
            lexer.at++;
        else
            lexer_token(&lexer);
    }
    lexer_push(&lexer, TOKEN_END, lexer.length, lexer.length);
    struct token_list *list = ARENA_NEW(arena, struct token_list);
    list->source = source;
    list->tokens = lexer_tokens(&lexer, first);
    list->count = lexer.tokens.count;
    return list;
}

/* Where a source ends: before the Ctrl-Z that DOS editors put behind a text, as
 * often as it stands there. */
static size_t source_end(const struct source *source)
{
    const char dos_end = 0x1a;
    size_t end = source->length, ctrl_z = 0;
    for (; end > 0; end--) {
        char c = source->text[end - 1];
        if (c != dos_end && !is_space(c))
            break;
        ctrl_z += c == dos_end;
    }
    return ctrl_z ? end : source->length;
}

const struct token_list *lexer_run(struct arena *arena,
                                   struct word_table *words,
                                   const struct source *source)
{
    return lexer_run_part(arena, words, source, 0, source_end(source));
}
