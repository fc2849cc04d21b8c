/* Evaluations: see evaluation.h. */
#include "language/evaluation.h"

#include <stdlib.h>
#include <unistd.h>

#include "base/array.h"
#include "base/memory.h"
#include "base/parallel.h"
#include "base/text.h"
#include "parse/parse.h"

enum { MEANINGS = 4096, MEMORY = 1 << 30, TEXT_SHOWN = 200 };

/* A text that is open. */
struct unsaved {
    const char *uri, *path;
    const struct source *source;
    bool bom;
};

struct evaluation_work {
    struct evaluation *evaluation;
    struct arena *sources;
    struct background *thread;
    int wake;
    const struct source *main;
    const char **folders;
    size_t folder_count;
    const char *const *standard;
    struct permits permits;
    struct {
        struct unsaved *items;
        size_t count, capacity;
    } unsaved;
    struct remark **next, **next_note;
    struct meaning *meanings[MEANINGS];
};

static const struct unsaved *work_unsaved(const struct evaluation_work *work,
                                          const char *path)
{
    char *real = realpath(path, NULL);
    const struct unsaved *found = NULL;
    for (size_t i = 0; i < work->unsaved.count && !found; i++)
        if (strcmp(work->unsaved.items[i].path, real ? real : path) == 0)
            found = &work->unsaved.items[i];
    free(real);
    return found;
}

static const struct source *work_text(void *context, struct arena *sources,
                                      const char *path,
                                      struct span included_from)
{
    const struct unsaved *unsaved = work_unsaved(context, path);
    if (!unsaved)
        return NULL;
    struct source *source = ARENA_NEW(sources, struct source);
    *source = *unsaved->source;
    source->name = arena_copy_text(sources, path, strlen(path));
    source->included_from = included_from;
    return source;
}

static struct place work_place(struct span span, size_t offset, bool bom)
{
    struct source_place at = source_locate(span.source, offset);
    const char *line = span.source->text + at.line_start;
    if (offset > span.source->length)
        offset = span.source->length;
    return (struct place){ at.line - 1,
                           utf16_units(line, offset - at.line_start) +
                               (bom && at.line == 1) };
}

static void work_locate(struct evaluation_work *work, struct remark *remark,
                        struct span span)
{
    struct arena *arena = work->evaluation->arena;
    if (!span.source)
        return;
    const struct unsaved *unsaved = work_unsaved(work, span.source->name);
    bool bom = unsaved && unsaved->bom;
    if (unsaved) {
        remark->uri = unsaved->uri;
    } else {
        char *uri = uri_of_path(span.source->name);
        remark->uri = arena_copy_text(arena, uri, strlen(uri));
        memory_free(uri);
    }
    size_t length = span.length ? span.length : 1;
    remark->range =
        (struct stretch){ work_place(span, span.offset, bom),
                          work_place(span, span.offset + length, bom) };
}

static void work_hear(void *context, enum diag_level level, struct span span,
                      const char *hint, const char *text)
{
    struct evaluation_work *work = context;
    struct arena *arena = work->evaluation->arena;
    if (level == DIAG_MESSAGE || (level == DIAG_NOTE && !work->next_note))
        return;
    struct remark *remark = ARENA_NEW(arena, struct remark);
    remark->level = level;
    remark->text = arena_copy_text(arena, text, strlen(text));
    if (hint)
        remark->hint = arena_copy_text(arena, hint, strlen(hint));
    work_locate(work, remark, span);
    if (level == DIAG_NOTE) {
        *work->next_note = remark;
        work->next_note = &remark->next;
    } else {
        *work->next = remark;
        work->next = &remark->next;
        work->next_note = &remark->notes;
    }
}

static struct meaning **work_slot(struct evaluation_work *work,
                                  const char *name)
{
    return &work->meanings[text_hash(name, strlen(name)) % MEANINGS];
}

static struct meaning *work_meaning(struct evaluation_work *work,
                                    const struct parse_declared *declared)
{
    struct arena *arena = work->evaluation->arena;
    struct meaning **slot = work_slot(work, declared->name), *meaning = *slot;
    for (; meaning; meaning = meaning->next)
        if (meaning->source == declared->span.source &&
            meaning->offset == declared->span.offset)
            return meaning;
    meaning = ARENA_NEW(arena, struct meaning);
    meaning->name =
        arena_copy_text(arena, declared->name, strlen(declared->name));
    meaning->source = declared->span.source;
    meaning->offset = declared->span.offset;
    meaning->next = *slot;
    *slot = meaning;
    return meaning;
}

static void work_declared(void *context, const struct parse_declared *declared)
{
    struct evaluation_work *work = context;
    struct meaning *meaning = work_meaning(work, declared);
    meaning->kind = declared->kind;
    meaning->size = declared->size;
    meaning->colour = declared->colour;
    for (int i = 0; i < declared->size; i++)
        meaning->numbers[i] = declared->numbers[i];
    bool same = meaning->text && declared->text &&
                strncmp(meaning->text, declared->text, TEXT_SHOWN) == 0;
    if (declared->text && !same && arena_used(work->evaluation->arena) < MEMORY)
        meaning->text = arena_copy_text(work->evaluation->arena, declared->text,
                                        strnlen(declared->text, TEXT_SHOWN));
}

static void work_expire(void *context)
{
    struct evaluation *evaluation = context;
    evaluation->late = true;
    atomic_store(&evaluation->stop, 1);
}

static void work_run(void *context)
{
    struct evaluation_work *work = context;
    struct evaluation *evaluation = work->evaluation;
    const struct parse_listener listener = { work, work_declared, work_text };
    const struct parse_options options = {
        .include_paths = work->folders,
        .include_path_count = work->folder_count,
        .standard_paths = work->standard,
        .permits = &work->permits,
        .image_width = 160,
        .image_height = 120,
        .memory_limit = MEMORY,
        .listener = &listener,
        .stop = &evaluation->stop,
    };
    struct diag diag = { .listen = work_hear, .listener = work };
    struct ticker *ticker = ticker_start(EVALUATION_SECONDS, EVALUATION_SECONDS,
                                         work_expire, evaluation);
    scene_free(parse_scene(work->main, &options, work->sources, &diag));
    ticker_stop(ticker);
    atomic_store(&evaluation->over, 1);
    if (write(work->wake, "", 1) < 0)
        return; /* the pipe is full of wakes */
}

/* The folder of a path with its '/' left out; "." if there is none. */
static const char *folder_of(struct arena *arena, const char *path)
{
    const char *slash = strrchr(path, '/');
    return slash ? arena_copy_text(arena, path,
                                   slash > path ? (size_t)(slash - path) : 1)
                 : ".";
}

/* A copy: files that are opened meanwhile add to the lists. */
static void work_permit(struct evaluation_work *work,
                        const struct permits *permits)
{
    struct arena *arena = work->sources;
    for (size_t i = 0; i < permits->count; i++) {
        const struct permit_list *list = &permits->items[i];
        struct permit_list *copy =
            permits_begin(&work->permits, arena, list->where);
        for (size_t k = 0; k < list->count; k++)
            *ARRAY_PUSH(arena, copy) = list->items[k];
    }
}

static void work_take(struct evaluation_work *work, struct library *library,
                      const struct page *main)
{
    struct arena *arena = work->sources;
    for (struct page *page = library->pages; page; page = page->next) {
        if (!page->open)
            continue;
        struct source *source = ARENA_NEW(arena, struct source);
        source->name = arena_copy_text(arena, page->path, strlen(page->path));
        source->text = arena_copy_text(arena, page->text, page->length);
        source->length = page->length;
        *ARRAY_PUSH(arena, &work->unsaved) =
            (struct unsaved){ arena_copy_text(work->evaluation->arena,
                                              page->uri, strlen(page->uri)),
                              source->name, source, page->bom };
        if (page == main)
            work->main = source;
    }
    work->folder_count = library->folder_count + 1;
    work->folders = ARENA_ARRAY(arena, const char *, work->folder_count + 1);
    work->standard = library->standard;
    work_permit(work, &library->permits);
    work->folders[0] = folder_of(arena, main->path);
    for (size_t i = 0; i < library->folder_count; i++)
        work->folders[i + 1] = library->folders[i];
}

struct evaluation *evaluation_start(struct library *library, struct page *page,
                                    int wake)
{
    struct evaluation *evaluation = memory_new(sizeof *evaluation);
    struct evaluation_work *work = memory_new(sizeof *work);
    evaluation->arena = arena_new(0);
    evaluation->work = work;
    *work = (struct evaluation_work){ .evaluation = evaluation,
                                      .sources = arena_new(0),
                                      .wake = wake,
                                      .next = &evaluation->remarks };
    work_take(work, library, page);
    work->thread = background_start(work_run, work);
    if (work->thread)
        return evaluation;
    evaluation_free(evaluation);
    return NULL;
}

void evaluation_finish(struct evaluation *evaluation)
{
    background_join(evaluation->work->thread);
    evaluation->work->thread = NULL;
}

void evaluation_free(struct evaluation *evaluation)
{
    if (!evaluation)
        return;
    atomic_store(&evaluation->stop, 1);
    evaluation_finish(evaluation);
    arena_free(evaluation->work->sources);
    memory_free(evaluation->work);
    arena_free(evaluation->arena);
    memory_free(evaluation);
}

const struct meaning *evaluation_meaning(const struct evaluation *evaluation,
                                         const char *name)
{
    if (!evaluation)
        return NULL;
    for (const struct meaning *m = *work_slot(evaluation->work, name); m;
         m = m->next)
        if (strcmp(m->name, name) == 0)
            return m;
    return NULL;
}
