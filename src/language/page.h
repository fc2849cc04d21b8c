/* A text that is open in the editor, or a file beside it: its lines, and its
 * tokens when they are asked for. Positions are the protocol's: lines and
 * UTF-16 units from 0; whatever lies outside is moved inside. */
#ifndef LANGUAGE_PAGE_H
#define LANGUAGE_PAGE_H

#include <jansson.h>
#include <time.h>

#include "text/permit.h"
#include "token/lexer.h"

struct place {
    unsigned line, unit;
};

struct stretch {
    struct place start, end;
};

struct outline; /* outline.h */

struct page {
    struct page *next;
    char *uri, *path;
    bool open;               /* in the editor, else a copy of what is on disk */
    struct timespec changed; /* of the file, if it is not open */
    char *text;              /* NUL after it; begins behind a BOM */
    size_t length;
    bool bom; /* the editor counts it as the first line's first unit */
    struct {
        size_t *items;
        size_t count;
    } lines;             /* where each begins */
    struct arena *arena; /* of all below; NULL: not cut yet */
    struct source source;
    const struct token_list *tokens;
    struct outline *outline;
};

/* All texts of the session, and the words they are made of. */
struct library {
    struct page *pages;
    struct arena *arena;
    struct word_table *words;
    const char *const *folders; /* to search for files */
    size_t folder_count;
    struct permits permits; /* what may be read; of the files that the editor
                             * opens also what is beside them */
    const char *const *standard; /* those of them that are POV-Ray's; a NULL
                                  * ends them */
};

/* The page of a URI that is open, or NULL. */
struct page *page_open(struct library *library, const char *uri);

/* The page of a file: the open one, else as it is on disk now. NULL: there is
 * no such file. */
struct page *page_of_file(struct library *library, const char *path);

/* Opens a page with this text. */
struct page *page_add(struct library *library, const char *uri,
                      const char *text, size_t length);
void page_remove(struct library *library, struct page *page);

/* Another text, or another between two places (which may be in any order). */
void page_replace(struct page *page, const char *text, size_t length);
void page_edit(struct page *page, struct stretch range, const char *text,
               size_t length);

size_t page_offset(const struct page *page, struct place place);
struct place page_place(const struct page *page, size_t offset);
struct stretch page_range(const struct page *page, size_t start, size_t end);

/* Cuts the text into tokens if it changed since. */
const struct token_list *page_tokens(struct library *library,
                                     struct page *page);

/* The first token that begins at `offset` or behind it. */
size_t page_token_at(const struct token_list *tokens, size_t offset);

/* Units of UTF-16 in so many bytes; broken UTF-8 counts as one each byte. */
unsigned utf16_units(const char *text, size_t length);

/* A file's path, allocated as malloc does, or NULL; and the reverse. */
char *path_of_uri(const char *uri);
char *uri_of_path(const char *path);

/* The path of a file that `page` names, in the arena, or NULL. */
const char *library_find(const struct library *library, struct arena *arena,
                         const struct page *page, const char *name);

#endif
