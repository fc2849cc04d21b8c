/* The grammar: see grammar.h. Wirth's notation is read into a tree, which is
 * walked for every question: it is small. */
#include "language/grammar.h"

#include <ctype.h>

#include "base/array.h"
#include "scene/pattern.h"
#include "scene/primitive.h"

enum node_kind { NODE_WORD, NODE_NAME, NODE_CHOICE, NODE_OPTION, NODE_REPEAT };

/* One thing in a row of things, of which `next` is the one behind it. */
struct node {
    enum node_kind kind;
    const char *text;       /* of a word or a name */
    struct choice *choices; /* of the others: (a | b), [a | b], {a | b} */
    struct node *next;
};

struct choice {
    struct node *first;
    struct choice *next;
};

struct production {
    const char *name;
    struct choice *choices;
    bool visited;
};

struct grammar {
    struct arena *arena;
    const char *at; /* of the text being read */
    struct {
        struct production *items;
        size_t count, capacity;
    } productions;
};

static const char grammar_text[] =
#include "grammar.inc"
    ;

static void read_blanks(struct grammar *g)
{
    for (;;) {
        while (isspace((unsigned char)*g->at))
            g->at++;
        if (g->at[0] != '(' || g->at[1] != '*')
            return;
        const char *end = strstr(g->at, "*)");
        g->at = end ? end + 2 : g->at + strlen(g->at);
    }
}

static bool read_sign(struct grammar *g, char sign)
{
    read_blanks(g);
    if (*g->at != sign)
        return false;
    g->at++;
    return true;
}

static struct choice *read_choices(struct grammar *g);

static struct node *read_node(struct grammar *g)
{
    static const char opens[] = "([{", closes[] = ")]}";
    static const enum node_kind kinds[] = { NODE_CHOICE, NODE_OPTION,
                                            NODE_REPEAT };
    read_blanks(g);
    const char *open = *g->at ? strchr(opens, *g->at) : NULL;
    struct node *node = ARENA_NEW(g->arena, struct node);
    if (open) {
        g->at++;
        node->kind = kinds[open - opens];
        node->choices = read_choices(g);
        read_sign(g, closes[open - opens]);
        return node;
    }
    const char *start = g->at;
    if (*g->at == '"' || *g->at == '\'') {
        const char *end = strchr(g->at + 1, *g->at);
        node->text =
            arena_copy_text(g->arena, start + 1, (size_t)(end - start) - 1);
        g->at = end + 1;
        return node;
    }
    while (isalnum((unsigned char)*g->at) || *g->at == '_')
        g->at++;
    if (g->at == start)
        return NULL;
    node->kind = NODE_NAME;
    node->text = arena_copy_text(g->arena, start, (size_t)(g->at - start));
    return node;
}

static struct choice *read_choices(struct grammar *g)
{
    struct choice *first = NULL, **last = &first;
    do {
        struct choice *choice = ARENA_NEW(g->arena, struct choice);
        struct node **next = &choice->first, *node;
        while ((node = read_node(g)) != NULL) {
            *next = node;
            next = &node->next;
        }
        *last = choice;
        last = &choice->next;
    } while (read_sign(g, '|'));
    return first;
}

struct grammar *grammar_new(struct arena *arena)
{
    struct grammar *g = ARENA_NEW(arena, struct grammar);
    g->arena = arena;
    g->at = grammar_text;
    for (;;) {
        struct node *name = read_node(g);
        if (!name || !read_sign(g, '='))
            return g;
        struct choice *choices = read_choices(g);
        *ARRAY_PUSH(arena, &g->productions) =
            (struct production){ name->text, choices, false };
        read_sign(g, '.');
    }
}

static struct production *grammar_find(struct grammar *g, const char *name)
{
    for (size_t i = 0; i < g->productions.count; i++)
        if (strcmp(g->productions.items[i].name, name) == 0)
            return &g->productions.items[i];
    return NULL;
}

static bool node_is(const struct node *node, const char *word)
{
    return node->kind == NODE_WORD && strcmp(node->text, word) == 0;
}

static bool node_is_word(const struct node *node)
{
    return node->kind == NODE_WORD && isalpha((unsigned char)*node->text);
}

/* Expressions: what they are made of is no item of a block. */
static bool name_is_value(const char *name)
{
    static const char *const values[] = {
        "float",          "integer",    "bool",      "vector", "components",
        "condition",      "thing_name", "operation", "colour", "string",
        "name",           "value",      "word",      "number", "expression",
        "terms",          "points",     "arguments", "array",  "token",
        "body_operation", NULL
    };
    for (const char *const *value = values; *value; value++)
        if (strcmp(*value, name) == 0)
            return true;
    return false;
}

/* ---- how a rule is written ---- */

static const char *text_choices(struct arena *arena, const struct choice *list,
                                const char *text);

static const char *text_node(struct arena *arena, const struct node *node,
                             const char *text)
{
    static const char *const opens[] = {
        [NODE_CHOICE] = "(", [NODE_OPTION] = "[", [NODE_REPEAT] = ""
    };
    static const char *const closes[] = {
        [NODE_CHOICE] = ")", [NODE_OPTION] = "]", [NODE_REPEAT] = " ..."
    };
    if (node->kind == NODE_WORD || node->kind == NODE_NAME)
        return arena_printf(arena, "%s%s", text, node->text);
    text = arena_printf(arena, "%s%s", text, opens[node->kind]);
    text = text_choices(arena, node->choices, text);
    return arena_printf(arena, "%s%s", text, closes[node->kind]);
}

/* Up to a block, whose inside is another matter. */
static const char *text_row(struct arena *arena, const struct node *node,
                            const char *text)
{
    for (const char *blank = ""; node; node = node->next, blank = " ") {
        if (node_is(node, "{"))
            return arena_printf(arena, "%s { ... }", text);
        text = text_node(arena, node, arena_printf(arena, "%s%s", text, blank));
    }
    return text;
}

static const char *text_choices(struct arena *arena, const struct choice *list,
                                const char *text)
{
    for (; list; list = list->next) {
        text = text_row(arena, list->first, text);
        if (list->next)
            text = arena_printf(arena, "%s | ", text);
    }
    return text;
}

/* ---- what may stand somewhere ---- */

struct collector {
    struct grammar *grammar;
    struct arena *arena;
    struct grammar_items *items;
    unsigned depth; /* of braces: what is in them is not collected */
};

static const char *row_value(const struct node *node)
{
    for (; node; node = node->next) {
        if (node->kind == NODE_NAME)
            return name_is_value(node->text) ? node->text : NULL;
        if (node_is_word(node) || node->kind == NODE_REPEAT)
            return NULL;
        const char *inside = node->choices && node->choices->first
                                 ? row_value(node->choices->first)
                                 : NULL;
        if (inside || node->kind != NODE_OPTION)
            return inside;
    }
    return NULL;
}

static void collect(struct collector *c, const char *word, const char *after,
                    const char *rule, const char *value)
{
    for (size_t i = 0; i < c->items->count; i++)
        if (strcmp(c->items->items[i].word, word) == 0 &&
            !c->items->items[i].after == !after)
            return;
    *ARRAY_PUSH(c->arena, c->items) = (struct grammar_item){
        .word = word,
        .identifier = isupper((unsigned char)*word) != 0,
        .after = after,
        .rule = rule,
        .value = value,
    };
}

static void collect_fields(struct collector *c, const struct field *field)
{
    for (; field && field->name; field++)
        collect(c, field->name, NULL,
                arena_printf(c->arena, "%s: %s", field->name, field->help),
                field->kind == FIELD_FLAG ? NULL : "float");
}

/* Names that stand for tables. */
static bool collect_table(struct collector *c, const char *name)
{
    bool primitives = strcmp(name, "PRIMITIVE") == 0;
    bool patterns = strcmp(name, "PATTERN") == 0;
    bool items = strcmp(name, "PATTERN_ITEM") == 0;
    for (size_t i = 0; primitives && primitive_at(i); i++)
        collect(c, primitive_at(i)->name, NULL, primitive_at(i)->help, NULL);
    for (size_t i = 0; patterns && pattern_at(i); i++)
        collect(c, pattern_at(i)->name, NULL, pattern_at(i)->help, NULL);
    for (size_t i = 0; items && pattern_at(i); i++)
        collect_fields(c, pattern_at(i)->items);
    return primitives || patterns || items;
}

static void collect_choices(struct collector *c, const struct choice *list,
                            const char *after);

/* One row from `node` on; `after` is the word before it, if it has one. */
static void collect_row(struct collector *c, const struct node *node,
                        const char *after)
{
    for (; node; node = node->next) {
        if (node_is(node, "{"))
            c->depth++;
        if (node_is(node, "}") && c->depth-- == 0) {
            c->depth = 0;
            return;
        }
        if (c->depth > 0)
            continue;
        if (node_is_word(node)) {
            collect(c, node->text, after, text_row(c->arena, node, ""),
                    row_value(node->next));
            after = node->text;
        } else if (node->choices) {
            collect_choices(c, node->choices, after);
        } else if (node->kind == NODE_NAME && name_is_value(node->text)) {
            c->items->values |= after == NULL;
        } else if (node->kind == NODE_NAME && !collect_table(c, node->text)) {
            struct production *p = grammar_find(c->grammar, node->text);
            if (!p && isupper((unsigned char)*node->text))
                collect(c, node->text, NULL, node->text, NULL);
            if (p && !p->visited) {
                p->visited = true;
                collect_choices(c, p->choices, NULL);
            }
        }
    }
}

static void collect_choices(struct collector *c, const struct choice *list,
                            const char *after)
{
    for (; list; list = list->next) {
        unsigned depth = c->depth;
        collect_row(c, list->first, after);
        c->depth = depth;
    }
}

static void grammar_forget(struct grammar *g)
{
    for (size_t i = 0; i < g->productions.count; i++)
        g->productions.items[i].visited = false;
}

/* What the braces behind `before` have in them; `rest` follows the row. */
static void search_choices(struct collector *c, const struct choice *list,
                           const char *block, bool before,
                           const struct node *rest);

static bool choices_have(const struct choice *list, const char *word)
{
    for (; list; list = list->next)
        if (list->first && node_is(list->first, word))
            return true;
    return false;
}

static bool choices_are_words(const struct choice *list)
{
    for (; list; list = list->next)
        if (!list->first || !node_is_word(list->first))
            return false;
    return true;
}

static void search_row(struct collector *c, const struct node *node,
                       const char *block, bool before, const struct node *rest)
{
    bool shape = primitive_find(block) != NULL;
    for (; node; node = node->next) {
        if (node_is(node, "{") && before) {
            c->depth = 0;
            collect_row(c, node->next, NULL);
            if (rest)
                collect_row(c, rest, NULL);
        }
        if (node_is_word(node))
            before = node_is(node, block);
        else if (node->kind == NODE_NAME &&
                 strcmp(node->text, "PRIMITIVE") == 0)
            before = shape;
        else if (node->kind == NODE_CHOICE &&
                 choices_are_words(node->choices) &&
                 !node->choices->first->next)
            before = choices_have(node->choices, block);
        if (node->choices)
            search_choices(c, node->choices, block, before, node->next);
    }
}

static void search_choices(struct collector *c, const struct choice *list,
                           const char *block, bool before,
                           const struct node *rest)
{
    for (; list; list = list->next)
        search_row(c, list->first, block, before, rest);
}

void grammar_block(struct grammar *g, struct arena *arena, const char *block,
                   struct grammar_items *items)
{
    struct collector c = { g, arena, items, 0 };
    grammar_forget(g);
    if (!block) {
        grammar_production(g, arena, "scene_item", items);
        return;
    }
    const struct primitive *primitive = primitive_find(block);
    if (primitive)
        collect_fields(&c, primitive->items);
    for (size_t i = 0; i < g->productions.count; i++)
        search_choices(&c, g->productions.items[i].choices, block, false, NULL);
}

void grammar_production(struct grammar *g, struct arena *arena,
                        const char *name, struct grammar_items *items)
{
    struct collector c = { g, arena, items, 0 };
    struct production *p = grammar_find(g, name);
    grammar_forget(g);
    if (p)
        collect_choices(&c, p->choices, NULL);
}

/* ---- where a word is used ---- */

static const char *usage_choices(struct arena *arena, const char *text,
                                 const char *name, const struct choice *list,
                                 const char *word)
{
    for (; list; list = list->next)
        for (const struct node *node = list->first; node; node = node->next) {
            bool here = node_is(node, word);
            const struct node *from =
                here && node == list->first ? node : list->first;
            if (here)
                text = arena_printf(arena, "%s%s: %s\n", text, name,
                                    text_row(arena, from, ""));
            else if (node->choices)
                text = usage_choices(arena, text, name, node->choices, word);
        }
    return text;
}

const char *grammar_usage(struct grammar *g, struct arena *arena,
                          const char *word)
{
    const char *text = "";
    for (size_t i = 0; i < g->productions.count; i++)
        text = usage_choices(arena, text, g->productions.items[i].name,
                             g->productions.items[i].choices, word);
    return *text ? text : NULL;
}
