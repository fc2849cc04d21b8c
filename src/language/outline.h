/* What a text declares and includes, told from its tokens alone: also of texts
 * that are wrong, and of branches that are not read. */
#ifndef LANGUAGE_OUTLINE_H
#define LANGUAGE_OUTLINE_H

#include "language/page.h"

enum name_kind {
    NAME_DECLARE,
    NAME_LOCAL,
    NAME_MACRO,
    NAME_PARAMETER, /* of a macro */
    NAME_LOOP,      /* of a #for */
};

struct name {
    enum name_kind kind;
    const struct word *word;
    size_t token;             /* of the name itself */
    size_t first, last;       /* from the directive to the end of it all */
    size_t seen, unseen;      /* between these tokens it is known */
    const struct word *value; /* the word behind '=', or NULL */
    const struct word **parameters; /* of a macro */
    size_t parameter_count;
};

struct outline {
    struct {
        struct name *items;
        size_t count, capacity;
    } names;
    struct {
        struct include {
            size_t token; /* of the string */
            const char *name;
        } * items;
        size_t count, capacity;
    } includes;
    struct {
        struct fold {
            size_t first, last; /* tokens */
            bool outermost;     /* a block that is in no other */
        } * items;
        size_t count, capacity;
    } folds; /* blocks and directives, the inner before the outer */
};

const struct outline *page_outline(struct library *library, struct page *page);

/* The declaration in this page that the word at token `at` means: the nearest
 * that is known there; or NULL. */
const struct name *outline_name(const struct outline *outline,
                                const struct word *word, size_t at);

/* The page and all it includes, then what includes it with all of that; each
 * once. */
struct page_list {
    struct page **items;
    size_t count, capacity;
};
void pages_below(struct library *library, struct page *page,
                 struct arena *arena, struct page_list *list);
void pages_around(struct library *library, struct page *page,
                  struct arena *arena, struct page_list *list);

/* A declaration of the word that is global, in one of the pages: the last one
 * of the first page that has any. */
const struct name *pages_name(struct library *library,
                              const struct page_list *list,
                              const struct word *word, struct page **where);

#endif
