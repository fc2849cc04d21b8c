/* Pages: see page.h. */
#include "language/page.h"

#include <stdio.h>
#include <stdlib.h>
#include <sys/stat.h>
#include <unistd.h>

#include "base/memory.h"

static char *text_keep(const char *text, size_t length)
{
    char *copy = memory_new(length + 1);
    memcpy(copy, text, length);
    return copy;
}

/* Bytes of the character that begins here, at least 1. */
static size_t character_size(const char *text, size_t length)
{
    unsigned char c = (unsigned char)*text;
    size_t size = c < 0xc2 ? 1 : c < 0xe0 ? 2 : c < 0xf0 ? 3 : c < 0xf5 ? 4 : 1;
    if (size > length)
        return 1;
    for (size_t i = 1; i < size; i++)
        if (((unsigned char)text[i] & 0xc0) != 0x80)
            return 1;
    return size;
}

unsigned utf16_units(const char *text, size_t length)
{
    unsigned units = 0;
    for (size_t i = 0; i < length;) {
        size_t size = character_size(text + i, length - i);
        units += size == 4 ? 2 : 1;
        i += size;
    }
    return units;
}

static bool line_ends(const struct page *page, size_t i)
{
    char c = page->text[i];
    return c == '\n' || (c == '\r' && page->text[i + 1] != '\n');
}

/* After every change. */
static void page_measure(struct page *page)
{
    size_t count = 1;
    for (size_t i = 0; i < page->length; i++)
        count += line_ends(page, i);
    page->lines.items =
        memory_resize(page->lines.items, count * sizeof *page->lines.items);
    page->lines.items[0] = 0;
    page->lines.count = 1;
    for (size_t i = 0; i < page->length; i++)
        if (line_ends(page, i))
            page->lines.items[page->lines.count++] = i + 1;
    arena_free(page->arena);
    page->arena = NULL;
    page->tokens = NULL;
    page->outline = NULL;
}

void page_replace(struct page *page, const char *text, size_t length)
{
    page->bom = length >= 3 && memcmp(text, "\xef\xbb\xbf", 3) == 0;
    if (page->bom) {
        text += 3;
        length -= 3;
    }
    char *old = page->text;
    page->text = text_keep(text, length);
    page->length = length;
    memory_free(old);
    page_measure(page);
}

void page_edit(struct page *page, struct stretch range, const char *text,
               size_t length)
{
    size_t start = page_offset(page, range.start);
    size_t end = page_offset(page, range.end);
    if (end < start) {
        size_t other = start;
        start = end;
        end = other;
    }
    size_t rest = page->length - end;
    char *whole = memory_new(start + length + rest + 1);
    memcpy(whole, page->text, start);
    memcpy(whole + start, text, length);
    memcpy(whole + start + length, page->text + end, rest);
    memory_free(page->text);
    page->text = whole;
    page->length = start + length + rest;
    page_measure(page);
}

/* Where a line ends, its end of line left out. */
static size_t page_line_end(const struct page *page, size_t line)
{
    size_t end = line + 1 < page->lines.count ? page->lines.items[line + 1]
                                              : page->length;
    size_t start = page->lines.items[line];
    while (end > start &&
           (page->text[end - 1] == '\n' || page->text[end - 1] == '\r'))
        end--;
    return end;
}

size_t page_offset(const struct page *page, struct place place)
{
    if (place.line >= page->lines.count)
        return page->length;
    size_t at = page->lines.items[place.line];
    size_t end = page_line_end(page, place.line);
    unsigned unit = page->bom && place.line == 0 ? 1 : 0;
    while (at < end && unit < place.unit) {
        size_t size = character_size(page->text + at, end - at);
        unit += size == 4 ? 2 : 1;
        if (unit > place.unit)
            break;
        at += size;
    }
    return at;
}

struct place page_place(const struct page *page, size_t offset)
{
    size_t low = 0, high = page->lines.count;
    if (offset > page->length)
        offset = page->length;
    while (high - low > 1) {
        size_t middle = (low + high) / 2;
        if (page->lines.items[middle] <= offset)
            low = middle;
        else
            high = middle;
    }
    size_t start = page->lines.items[low];
    unsigned units = utf16_units(page->text + start, offset - start);
    return (struct place){ (unsigned)low,
                           units + (page->bom && low == 0 ? 1 : 0) };
}

struct stretch page_range(const struct page *page, size_t start, size_t end)
{
    return (struct stretch){ page_place(page, start), page_place(page, end) };
}

struct page *page_open(struct library *library, const char *uri)
{
    for (struct page *page = library->pages; page; page = page->next)
        if (page->open && strcmp(page->uri, uri) == 0)
            return page;
    return NULL;
}

/* Without links and "..", if there is such a file. */
static char *path_keep(const char *path)
{
    char *real = realpath(path, NULL);
    char *copy = text_keep(real ? real : path, strlen(real ? real : path));
    free(real);
    return copy;
}

static struct page *page_new(struct library *library, char *uri,
                             const char *path)
{
    struct page *page = memory_new(sizeof *page);
    page->uri = uri;
    page->path = path_keep(path);
    page->next = library->pages;
    library->pages = page;
    return page;
}

/* What is beside a file that the editor has opened may be read, as beside a
 * scene that glim is to draw. */
static void page_permit(struct library *library, const struct page *page)
{
    char *folder = text_keep(page->path, strlen(page->path));
    char *slash = strrchr(folder, '/');
    if (slash)
        slash[slash == folder] = '\0';
    for (size_t i = 0; slash && i < library->permits.count &&
                       permits_denier_of(&library->permits, folder);
         i++)
        permit_beside(&library->permits.items[i], library->arena, folder);
    memory_free(folder);
}

struct page *page_add(struct library *library, const char *uri,
                      const char *text, size_t length)
{
    struct page *page = page_open(library, uri);
    char *path = page ? NULL : path_of_uri(uri);
    if (!page)
        page =
            page_new(library, text_keep(uri, strlen(uri)), path ? path : uri);
    memory_free(path);
    page->open = true;
    page_permit(library, page);
    page_replace(page, text, length);
    return page;
}

void page_remove(struct library *library, struct page *page)
{
    struct page **link = &library->pages;
    while (*link != page)
        link = &(*link)->next;
    *link = page->next;
    arena_free(page->arena);
    memory_free(page->lines.items);
    memory_free(page->text);
    memory_free(page->uri);
    memory_free(page->path);
    memory_free(page);
}

static struct page *page_find(struct library *library, const char *path)
{
    struct page *found = NULL;
    char *real = path_keep(path);
    for (struct page *page = library->pages; page; page = page->next)
        if (strcmp(page->path, real) == 0 && (!found || page->open))
            found = page;
    memory_free(real);
    return found;
}

struct page *page_of_file(struct library *library, const char *path)
{
    struct stat status;
    const char *problem;
    struct page *page = page_find(library, path);
    if (page && page->open)
        return page;
    bool there = stat(path, &status) == 0 && S_ISREG(status.st_mode) &&
                 !permits_denier(&library->permits, path);
    if (there && page && page->changed.tv_sec == status.st_mtim.tv_sec &&
        page->changed.tv_nsec == status.st_mtim.tv_nsec)
        return page;
    struct arena *arena = arena_new(0);
    const struct source *source =
        there ? source_read(arena, path, span_none(), &problem) : NULL;
    if (source && !page)
        page = page_new(library, uri_of_path(path), path);
    if (source) {
        page_replace(page, source->text, source->length);
        page->changed = status.st_mtim;
    }
    arena_free(arena);
    return source ? page : NULL;
}

const struct token_list *page_tokens(struct library *library, struct page *page)
{
    if (page->tokens)
        return page->tokens;
    page->arena = arena_new(0);
    page->source = (struct source){ .name = page->path,
                                    .text = page->text,
                                    .length = page->length };
    page->tokens = lexer_run(page->arena, library->words, &page->source);
    return page->tokens;
}

size_t page_token_at(const struct token_list *tokens, size_t offset)
{
    size_t low = 0, high = tokens->count - 1;
    while (low < high) {
        size_t middle = (low + high) / 2;
        if (tokens->tokens[middle].offset < offset)
            low = middle + 1;
        else
            high = middle;
    }
    return low;
}

static int hex_digit(char c)
{
    return c >= '0' && c <= '9'   ? c - '0'
           : c >= 'a' && c <= 'f' ? c - 'a' + 10
           : c >= 'A' && c <= 'F' ? c - 'A' + 10
                                  : -1;
}

char *path_of_uri(const char *uri)
{
    static const char scheme[] = "file://";
    if (strncmp(uri, scheme, sizeof scheme - 1) != 0)
        return NULL;
    const char *from = strchr(uri + sizeof scheme - 1, '/');
    if (!from)
        return NULL;
    char *path = memory_new(strlen(from) + 1), *to = path;
    for (; *from; from++) {
        int high = *from == '%' ? hex_digit(from[1]) : -1;
        int low = high >= 0 ? hex_digit(from[2]) : -1;
        bool coded = low >= 0 && (high || low);
        *to++ = coded ? (char)(high * 16 + low) : *from;
        if (coded)
            from += 2;
    }
    return path;
}

char *uri_of_path(const char *path)
{
    char *real = realpath(path, NULL);
    const char *from = real ? real : path;
    char *uri = memory_new(3 * strlen(from) + 8), *to = uri + 7;
    memcpy(uri, "file://", 7);
    for (; *from; from++) {
        unsigned char c = (unsigned char)*from;
        bool plain = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') ||
                     (c >= '0' && c <= '9') || strchr("-._~/", c);
        to += plain ? sprintf(to, "%c", c) : sprintf(to, "%%%02X", c);
    }
    free(real);
    return uri;
}

static bool file_is_there(const char *path)
{
    struct stat status;
    return stat(path, &status) == 0 && S_ISREG(status.st_mode);
}

const char *library_find(const struct library *library, struct arena *arena,
                         const struct page *page, const char *name)
{
    static const char *const endings[] = { "", ".inc" };
    const char *slash = strrchr(page->path, '/');
    int length = slash ? (int)(slash - page->path) + 1 : 0;
    for (size_t e = 0; e < 2; e++) {
        const char *path = arena_printf(arena, "%s%s", name, endings[e]);
        const char *beside =
            arena_printf(arena, "%.*s%s", length, page->path, path);
        if (*name != '/' && file_is_there(beside))
            return beside;
        if (file_is_there(path))
            return path;
        for (size_t i = 0; *name != '/' && i < library->folder_count; i++) {
            const char *there =
                arena_printf(arena, "%s/%s", library->folders[i], path);
            if (file_is_there(there))
                return there;
        }
    }
    return NULL;
}
