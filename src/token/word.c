/* Interned words in an open-addressing hash table. */
#include "token/word.h"

#include <string.h>

#include "base/array.h"
#include "base/text.h"
#include "scene/finish.h"
#include "scene/pattern.h"
#include "scene/primitive.h"

struct word_table {
    struct arena *arena;
    const struct word **slots; /* a power of two of them, NULL: free */
    size_t slot_count;
    struct {
        const struct word **items;
        size_t count, capacity;
    } words; /* by id */
};

static const char *const keyword_spellings[] = { [KEYWORD_NONE] = "",
#define X(name, spelling) [KEYWORD_##name] = spelling,
                                                 KEYWORDS(X)
#undef X
};

const char *keyword_spelling(enum keyword keyword)
{
    return keyword < KEYWORDS_TOTAL ? keyword_spellings[keyword] : "";
}

static const struct word **word_slot(const struct word_table *words,
                                     const char *text, size_t length)
{
    size_t mask = words->slot_count - 1;
    size_t i = (size_t)text_hash(text, length) & mask;
    while (words->slots[i] && (words->slots[i]->length != length ||
                               memcmp(words->slots[i]->text, text, length)))
        i = (i + 1) & mask;
    return &words->slots[i];
}

static void word_table_grow(struct word_table *words)
{
    words->slot_count = words->slot_count ? words->slot_count * 2 : 2048;
    words->slots =
        ARENA_ARRAY(words->arena, const struct word *, words->slot_count);
    for (size_t i = 0; i < words->words.count; i++) {
        const struct word *word = words->words.items[i];
        *word_slot(words, word->text, word->length) = word;
    }
}

static struct word *word_add(struct word_table *words, const char *text,
                             size_t length)
{
    if (words->words.count * 2 >= words->slot_count)
        word_table_grow(words);
    struct word *word = ARENA_NEW(words->arena, struct word);
    word->text = arena_copy_text(words->arena, text, length);
    word->length = (unsigned short)length;
    word->id = (unsigned)words->words.count;
    *ARRAY_PUSH(words->arena, &words->words) = word;
    *word_slot(words, text, length) = word;
    return word;
}

/* A pattern called as a keyword ("object") is the keyword. */
static void word_reserve(struct word_table *words, const char *text,
                         enum keyword keyword)
{
    if (*word_slot(words, text, strlen(text)))
        return;
    struct word *word = word_add(words, text, strlen(text));
    word->keyword = (unsigned short)keyword;
    word->reserved = true;
}

/* Those that are words: see scene/fields.h. */
static void word_reserve_fields(struct word_table *words,
                                const struct field *field)
{
    for (; field && field->name; field++)
        if (!strchr(field->name, ' '))
            word_reserve(words, field->name, KEYWORD_NONE);
}

struct word_table *word_table_new(struct arena *arena)
{
    struct word_table *words = ARENA_NEW(arena, struct word_table);
    words->arena = arena;
    word_table_grow(words);
#define X(name, spelling) word_reserve(words, spelling, KEYWORD_##name);
    KEYWORDS(X)
    KEYWORD_ALIASES(X)
#undef X
    for (size_t i = 0; primitive_at(i); i++)
        word_reserve(words, primitive_at(i)->name, KEYWORD_NONE);
    for (size_t i = 0; pattern_at(i); i++)
        word_reserve(words, pattern_at(i)->name, KEYWORD_NONE);
    for (size_t i = 0; finish_item_at(i); i++)
        word_reserve_fields(words, finish_item_at(i)->fields);
    return words;
}

const struct word *word_intern(struct word_table *words, const char *text,
                               size_t length)
{
    const struct word *known = *word_slot(words, text, length);
    return known ? known : word_add(words, text, length);
}

unsigned word_count(const struct word_table *words)
{
    return (unsigned)words->words.count;
}

void word_table_visit(const struct word_table *words,
                      void (*visit)(void *context, const struct word *word),
                      void *context)
{
    for (size_t i = 0; i < words->words.count; i++)
        if (words->words.items[i]->reserved)
            visit(context, words->words.items[i]);
}
