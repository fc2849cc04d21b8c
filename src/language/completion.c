/* Completion: what may stand at a place. */
#include <ctype.h>
#include <dirent.h>
#include <strings.h>
#include <sys/stat.h>

#include "language/context.h"
#include "language/describe.h"
#include "language/manual.h"
#include "parse/words.h"
#include "scene/pattern.h"
#include "scene/primitive.h"

enum {
    ITEM_LIMIT = 1000, /* more are not told at once */
    /* The protocol's kinds. */
    KIND_FUNCTION = 3,
    KIND_VARIABLE = 6,
    KIND_CLASS = 7,
    KIND_KEYWORD = 14,
    KIND_COLOUR = 16,
    KIND_FILE = 17,
    KIND_FOLDER = 19,
    KIND_CONSTANT = 21,
};

struct completion {
    struct request *request;
    const struct context *context;
    const char *prefix;
    size_t length;
    json_t *items, *range, *seen;
    bool more;
};

/* `order` sorts: what fits best comes first. */
static void completion_add(struct completion *c, const char *label, int kind,
                           const char *detail, int order)
{
    char sort[2] = { (char)('0' + order), '\0' };
    if (strncasecmp(label, c->prefix, c->length) != 0 ||
        json_object_get(c->seen, label))
        return;
    if (json_array_size(c->items) >= ITEM_LIMIT) {
        c->more = true;
        return;
    }
    json_t *item =
        json_pack("{s:s,s:i,s:o,s:{s:O,s:s}}", "label", label, "kind", kind,
                  "sortText", json_sprintf("%s%s", sort, label), "textEdit",
                  "range", c->range, "newText", label);
    if (!item)
        return; /* a file's name that is no UTF-8 */
    if (detail)
        json_object_set_new(item, "detail", json_words(detail, strlen(detail)));
    if (c->context->block)
        json_object_set_new(item, "data", json_string(c->context->block));
    json_array_append_new(c->items, item);
    json_object_set_new(c->seen, label, json_true());
}

/* ---- names ---- */

/* Whether a name that was declared may stand where `identifier` (TEXTURE ...)
 * may: all may whose kind is not known. */
static bool name_fits(struct completion *c, const struct name *name,
                      const char *identifier)
{
    const struct meaning *meaning =
        roots_meaning(c->request->server, name->word->text);
    const char *kind = meaning ? strchr(meaning->kind, ' ') : NULL;
    if (kind)
        return strcasecmp(kind + 1, identifier) == 0;
    if (!name->value || !name->value->reserved)
        return true;
    const char *value = name->value->text;
    bool object = primitive_find(value) || strcmp(value, "union") == 0 ||
                  strcmp(value, "difference") == 0 ||
                  strcmp(value, "intersection") == 0 ||
                  strcmp(value, "merge") == 0;
    return strcasecmp(value, identifier) == 0 ||
           (object && strcmp(identifier, "OBJECT") == 0);
}

/* Numbers, vectors, colours, strings, and what may give them. */
static bool name_is_value(struct completion *c, const struct name *name)
{
    const struct meaning *meaning =
        roots_meaning(c->request->server, name->word->text);
    if (meaning)
        return meaning->size > 0 || meaning->text ||
               strcmp(meaning->kind, "an array") == 0 ||
               strcmp(meaning->kind, "a function") == 0 ||
               strcmp(meaning->kind, "a spline") == 0;
    static const char *const things[] = {
        "texture",  "pigment",    "normal", "finish",       "interior",
        "material", "object",     "camera", "transform",    "union",
        "merge",    "difference", "media",  "intersection", NULL
    };
    for (size_t i = 0; name->value && things[i]; i++)
        if (strcmp(name->value->text, things[i]) == 0)
            return false;
    return !name->value || !primitive_find(name->value->text);
}

static void completion_name(struct completion *c, const struct name *name,
                            int order)
{
    struct request *request = c->request;
    if (strncasecmp(name->word->text, c->prefix, c->length) != 0)
        return;
    bool macro = name->kind == NAME_MACRO;
    completion_add(c, name->word->text, macro ? KIND_FUNCTION : KIND_VARIABLE,
                   macro
                       ? describe_macro(request->arena, name)
                       : describe_value(request->server, request->arena, name),
                   order);
}

/* `items` NULL: a value is wanted. */
static void completion_names(struct completion *c,
                             const struct grammar_items *items)
{
    struct library *library = &c->request->server->library;
    struct page_list list = { 0 };
    pages_around(library, c->request->page, c->request->arena, &list);
    for (size_t p = 0; p < list.count; p++) {
        const struct outline *outline = page_outline(library, list.items[p]);
        bool here = list.items[p] == c->request->page;
        for (size_t i = 0; i < outline->names.count; i++) {
            const struct name *name = &outline->names.items[i];
            bool inner = name->kind == NAME_PARAMETER ||
                         name->kind == NAME_LOCAL || name->kind == NAME_LOOP;
            bool known = !inner || (here && name->seen <= c->context->token &&
                                    c->context->token <= name->unseen);
            bool fits =
                name->kind >= NAME_MACRO || (!items && name_is_value(c, name));
            for (size_t k = 0; items && !fits && k < items->count; k++)
                fits = items->items[k].identifier &&
                       name_fits(c, name, items->items[k].word);
            if (known && (fits || c->context->declaring))
                completion_name(c, name, here ? 1 : 3);
        }
    }
}

/* ---- words ---- */

static const struct grammar_item *item_named(const struct grammar_items *items,
                                             const char *word)
{
    for (size_t i = 0; i < items->count; i++)
        if (!items->items[i].after && strcmp(items->items[i].word, word) == 0)
            return &items->items[i];
    return NULL;
}

static void completion_values(struct completion *c)
{
    static const char *const constants[] = { "pi",
                                             "true",
                                             "false",
                                             "yes",
                                             "no",
                                             "on",
                                             "off",
                                             "x",
                                             "y",
                                             "z",
                                             "u",
                                             "v",
                                             "t",
                                             "clock",
                                             "clock_on",
                                             "now",
                                             "version",
                                             "image_width",
                                             "image_height",
                                             "frame_number",
                                             "input_file_name",
                                             "rgb",
                                             "rgbf",
                                             "rgbt",
                                             "rgbft",
                                             "srgb",
                                             "srgbf",
                                             "srgbt",
                                             "srgbft",
                                             "color",
                                             "colour",
                                             NULL };
    completion_names(c, NULL);
    for (size_t i = 0; constants[i]; i++)
        completion_add(c, constants[i], KIND_CONSTANT, NULL, 4);
    for (size_t i = 0; parse_function_at(i); i++) {
        const char *word = parse_function_at(i), *help = NULL;
        const char *call = strncasecmp(word, c->prefix, c->length) == 0
                               ? manual_function(c->request->arena, word, &help)
                               : NULL;
        completion_add(c, word, KIND_FUNCTION, call, 4);
    }
}

/* "fade_distance float: where light is half ..." */
static const char *item_detail(struct completion *c,
                               const struct grammar_item *item)
{
    const char *help = parse_field_help(c->context->block, item->word);
    bool told = help && *help;
    return arena_printf(c->request->arena, "%s%s%s", item->rule,
                        told ? ": " : "", told ? help : "");
}

static void completion_words(struct completion *c,
                             const struct grammar_items *items,
                             const char *after)
{
    for (size_t i = 0; i < items->count; i++) {
        const struct grammar_item *item = &items->items[i];
        bool here = after ? item->after && strcmp(item->after, after) == 0
                          : !item->after;
        if (here && !item->identifier)
            completion_add(c, item->word,
                           pattern_find(item->word) ? KIND_CLASS : KIND_KEYWORD,
                           item_detail(c, item), 2);
    }
}

static void completion_items(struct completion *c)
{
    const struct context *context = c->context;
    struct server *server = c->request->server;
    struct arena *arena = c->request->arena;
    struct grammar_items items = { 0 };
    if (context->block && *context->block)
        grammar_block(server->grammar, arena, context->block, &items);
    if (items.count == 0 || (context->in_macro && !context->block))
        grammar_production(server->grammar, arena,
                           context->in_macro || context->block ? "thing"
                                                               : "scene_item",
                           &items);
    const char *before = context->keyword && context->keyword->keyword
                             ? keyword_spelling(context->keyword->keyword)
                         : context->keyword ? context->keyword->text
                                            : NULL;
    if (before)
        completion_words(c, &items, before);
    const struct grammar_item *item =
        before ? item_named(&items, before) : NULL;
    if (item && item->value) {
        completion_values(c);
        return;
    }
    completion_words(c, &items, NULL);
    completion_names(c, &items);
    if (items.values)
        completion_values(c);
}

static void completion_declared(struct completion *c)
{
    struct grammar_items items = { 0 };
    grammar_production(c->request->server->grammar, c->request->arena, "thing",
                       &items);
    completion_words(c, &items, NULL);
    completion_add(c, "function", KIND_KEYWORD, NULL, 2);
    completion_add(c, "array", KIND_KEYWORD, NULL, 2);
    completion_add(c, "spline", KIND_KEYWORD, NULL, 2);
    completion_values(c);
}

static void completion_directives(struct completion *c)
{
    const char *help, *word;
    for (size_t i = 0; (word = parse_directive_word(i, &help)) != NULL; i++)
        completion_add(c, word, KIND_KEYWORD, help, 1);
}

/* ---- files ---- */

static bool file_has_kind(const char *name, enum file_kind kind)
{
    static const char *const endings[][14] = {
        [FILE_INCLUDE] = { "inc", "pov", "mac", NULL },
        [FILE_IMAGE] = { "png", "jpg", "jpeg", "gif", "tga", "bmp", "ppm",
                         "pgm", "tif", "tiff", "exr", "hdr", "iff", NULL },
        [FILE_FONT] = { "ttf", "ttc", "otf", NULL },
    };
    const char *dot = strrchr(name, '.');
    for (size_t i = 0; dot && endings[kind][i]; i++)
        if (strcasecmp(dot + 1, endings[kind][i]) == 0)
            return true;
    return false;
}

static void completion_folder(struct completion *c, const char *folder,
                              int order)
{
    const struct permits *permits = &c->request->server->library.permits;
    DIR *directory =
        permits_denier_of(permits, folder) ? NULL : opendir(folder);
    struct dirent *entry;
    struct stat status;
    while (directory && (entry = readdir(directory)) != NULL) {
        const char *path =
            arena_printf(c->request->arena, "%s/%s", folder, entry->d_name);
        if (entry->d_name[0] == '.' || stat(path, &status) != 0)
            continue;
        if (S_ISDIR(status.st_mode))
            completion_add(
                c, arena_printf(c->request->arena, "%s/", entry->d_name),
                KIND_FOLDER, NULL, order + 1);
        else if (file_has_kind(entry->d_name, c->context->file))
            completion_add(c, entry->d_name, KIND_FILE, folder, order);
    }
    if (directory)
        closedir(directory);
}

/* `written`: what of the name stands before the place. */
static void completion_files(struct completion *c, const char *written)
{
    const struct library *library = &c->request->server->library;
    struct arena *arena = c->request->arena;
    const char *slash = strrchr(written, '/');
    const char *folder =
        arena_copy_text(arena, written, slash ? (size_t)(slash - written) : 0);
    const char *path = c->request->page->path;
    const char *own = strrchr(path, '/');
    if (*written == '/') {
        completion_folder(c, *folder ? folder : "/", 1);
        return;
    }
    completion_folder(c,
                      arena_printf(arena, "%.*s/%s",
                                   own ? (int)(own - path) : 1,
                                   own ? path : ".", folder),
                      1);
    for (size_t i = 0; i < library->folder_count; i++)
        completion_folder(
            c, arena_printf(arena, "%s/%s", library->folders[i], folder), 3);
}

json_t *completion_answer(struct request *request)
{
    struct page *page = request->page;
    struct context context =
        context_at(&request->server->library, page, request->offset);
    size_t start = context.prefix;
    const char *written = arena_copy_text(request->arena, page->text + start,
                                          request->offset - start);
    const char *slash =
        context.kind == CONTEXT_FILE ? strrchr(written, '/') : NULL;
    if (slash)
        start += (size_t)(slash - written) + 1;
    struct completion c = {
        .request = request,
        .context = &context,
        .prefix = slash ? slash + 1 : written,
        .length = request->offset - start,
        .items = json_array(),
        .seen = json_object(),
        .range = json_range(page_range(page, start, request->offset)),
    };
    if (context.kind == CONTEXT_FILE)
        completion_files(&c, written);
    else if (context.kind == CONTEXT_DIRECTIVE)
        completion_directives(&c);
    else if (context.kind == CONTEXT_VALUE && context.declaring &&
             !context.call.name)
        completion_declared(&c);
    else if (context.kind == CONTEXT_VALUE)
        completion_values(&c);
    else if (context.kind == CONTEXT_ITEM)
        completion_items(&c);
    json_decref(c.range);
    json_decref(c.seen);
    return json_pack("{s:b,s:o}", "isIncomplete", c.more, "items", c.items);
}

json_t *completion_resolve(struct request *request)
{
    json_t *item = json_deep_copy(request->params);
    const char *label = json_text(item, "label");
    if (!label)
        return item;
    struct library *library = &request->server->library;
    const struct word *word = word_intern(library->words, label, strlen(label));
    if (word->reserved)
        json_object_set_new(
            item, "documentation",
            json_markdown(describe_keyword(request->server, request->arena,
                                           word, json_text(item, "data"))));
    return item;
}
