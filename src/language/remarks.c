/* Remarks: see remarks.h. The hint of a message is what to type; where that is
 * an edit of the text, it is offered as one. */
#include "language/remarks.h"

#include <ctype.h>
#include <stdio.h>

/* An edit: `text` in place of the range. */
struct fix {
    size_t start, end;
    const char *text;
};

/* Whether a hint is words of the language, not words about them. */
static bool hint_is_text(const char *hint)
{
    static const char *const prose[] = { "...",     " adds ",      "looked in",
                                         " finds ", " come with ", " permits ",
                                         "; type " };
    for (size_t i = 0; i < sizeof prose / sizeof *prose; i++)
        if (strstr(hint, prose[i]))
            return false;
    return *hint != '\0';
}

/* Behind the line of #version, or at the top. */
static size_t include_place(const struct page *page)
{
    const char *version = strstr(page->text, "#version");
    const char *end = version ? strchr(version, '\n') : NULL;
    return end ? (size_t)(end - page->text) + 1 : 0;
}

static bool hint_is_word(const char *hint)
{
    while (isalnum((unsigned char)*hint) || *hint == '_')
        hint++;
    return *hint == '\0';
}

/* The string in a piece of text that ends with it: #include "x.inc". */
static size_t string_start(const struct page *page, size_t start, size_t end)
{
    for (size_t at = start; at < end; at++)
        if (page->text[at] == '"')
            return at;
    return start;
}

/* A hint is what should stand there: in place of what is marked; or, for a ';'
 * and a '}', beside it; or an include above it all. */
static bool fix_find(struct arena *arena, const struct page *page,
                     const struct remark *remark, struct fix *fix)
{
    const char *hint = remark->hint;
    if (!hint || !hint_is_text(hint))
        return false;
    *fix = (struct fix){ page_offset(page, remark->range.start),
                         page_offset(page, remark->range.end), hint };
    bool braces = strcmp(hint, "}") == 0;
    if (strcmp(hint, ";") == 0) {
        fix->start = fix->end;
    } else if (braces) {
        fix->end = fix->start;
        fix->text = "} ";
    } else if (strncmp(hint, "#include ", 9) == 0) {
        fix->start = fix->end = include_place(page);
        fix->text = arena_printf(arena, "%s\n", hint);
    } else if (*hint == '"') {
        fix->start = string_start(page, fix->start, fix->end);
    } else if (strstr(hint, " {") || strstr(hint, "; ")) {
        return false;
    }
    bool word = isalpha((unsigned char)page->text[fix->start]) ||
                page->text[fix->start] == '_';
    return !hint_is_word(hint) || word || fix->start == fix->end;
}

static json_t *fix_json(const struct page *page, const struct fix *fix)
{
    json_t *json = json_object();
    json_object_set_new(json, "range",
                        json_range(page_range(page, fix->start, fix->end)));
    json_object_set_new(json, "newText",
                        json_words(fix->text, strlen(fix->text)));
    json_object_set_new(
        json, "old",
        json_words(page->text + fix->start, fix->end - fix->start));
    return json;
}

static json_t *remark_notes(const struct remark *remark)
{
    json_t *list = json_array();
    for (const struct remark *note = remark->notes; note; note = note->next)
        if (note->uri)
            json_array_append_new(
                list,
                json_pack("{s:{s:s,s:o},s:o}", "location", "uri", note->uri,
                          "range", json_range(note->range), "message",
                          json_words(note->text, strlen(note->text))));
    return list;
}

static json_t *remark_json(struct server *server, struct arena *arena,
                           const struct remark *remark)
{
    enum { ERROR = 1, WARNING = 2 };
    struct fix fix;
    const char *text = remark->text;
    struct page *page =
        remark->uri ? page_open(&server->library, remark->uri) : NULL;
    if (remark->hint)
        text = arena_printf(arena, "%s\n%s", text, remark->hint);
    for (const struct remark *note = remark->notes; note; note = note->next)
        if (!note->uri)
            text = arena_printf(arena, "%s\n%s", text, note->text);
    json_t *json =
        json_pack("{s:o,s:i,s:s,s:o}", "range", json_range(remark->range),
                  "severity", remark->level == DIAG_ERROR ? ERROR : WARNING,
                  "source", "glim", "message", json_words(text, strlen(text)));
    if (remark->notes)
        json_object_set_new(json, "relatedInformation", remark_notes(remark));
    if (page && fix_find(arena, page, remark, &fix))
        json_object_set_new(json, "data", fix_json(page, &fix));
    return json;
}

static void remarks_add(json_t *lists, const char *uri, json_t *remark)
{
    json_t *list = json_object_get(lists, uri);
    if (!list) {
        list = json_array();
        json_object_set_new(lists, uri, list);
    }
    json_array_append_new(list, remark);
}

json_t *remarks_json(struct server *server, const struct root *root)
{
    enum { INFORMATION = 3 };
    struct arena *arena = arena_new(0);
    json_t *lists = json_object();
    json_object_set_new(lists, root->page->uri, json_array());
    for (const struct remark *remark = root->done->remarks; remark;
         remark = remark->next)
        remarks_add(lists, remark->uri ? remark->uri : root->page->uri,
                    remark_json(server, arena, remark));
    if (root->done->late)
        remarks_add(
            lists, root->page->uri,
            json_pack("{s:o,s:i,s:s,s:s}", "range",
                      json_range((struct stretch){ { 0, 0 }, { 0, 1 } }),
                      "severity", INFORMATION, "source", "glim", "message",
                      arena_printf(arena,
                                   "reading this scene takes more than %d s: "
                                   "it was stopped, and what comes after is "
                                   "not checked",
                                   EVALUATION_SECONDS)));
    arena_free(arena);
    return lists;
}

static bool place_before(struct place a, struct place b)
{
    return a.line < b.line || (a.line == b.line && a.unit < b.unit);
}

static bool ranges_meet(struct stretch a, struct stretch b)
{
    return !place_before(a.end, b.start) && !place_before(b.end, a.start);
}

/* Whether the text is still the one that the fix is for. */
static bool fix_applies(const struct page *page, const json_t *fix)
{
    struct stretch range = json_to_range(json_object_get(fix, "range"));
    size_t start = page_offset(page, range.start);
    size_t end = page_offset(page, range.end);
    const json_t *old = json_object_get(fix, "old");
    return end - start == json_string_length(old) &&
           memcmp(page->text + start, json_string_value(old), end - start) == 0;
}

static json_t *fix_action(const struct page *page, json_t *remark,
                          const json_t *fix)
{
    json_t *edits =
        json_pack("[{s:O,s:O}]", "range", json_object_get(fix, "range"),
                  "newText", json_object_get(fix, "newText"));
    json_t *changes = json_object();
    json_object_set_new(changes, page->uri, edits);
    const char *text = json_text(fix, "newText");
    char title[100];
    bool adds = json_string_length(json_object_get(fix, "old")) == 0;
    snprintf(title, sizeof title, "%s %.*s", adds ? "Add" : "Change to",
             (int)strcspn(text, "\n"), text);
    return json_pack("{s:o,s:s,s:[O],s:b,s:{s:o}}", "title",
                     json_words(title, strlen(title)), "kind", "quickfix",
                     "diagnostics", remark, "isPreferred", 1, "edit", "changes",
                     changes);
}

json_t *fixes_answer(struct request *request)
{
    struct server *server = request->server;
    struct page *page = request->page;
    struct stretch range =
        json_to_range(json_object_get(request->params, "range"));
    json_t *actions = json_array(), *remark;
    size_t i;
    for (struct root *root = server->roots; root; root = root->next)
        json_array_foreach(json_object_get(root->remarks, page->uri), i, remark)
        {
            const json_t *fix = json_object_get(remark, "data");
            struct stretch at = json_to_range(json_object_get(remark, "range"));
            if (fix && ranges_meet(at, range) && fix_applies(page, fix))
                json_array_append_new(actions, fix_action(page, remark, fix));
        }
    return actions;
}
