/* What is done with the picture: see view.h. */
#include "view/view.h"

#include <stdarg.h>
#include <stdlib.h>
#include <string.h>

#include "base/memory.h"
#include "view/fly.h"

/* How far away the pivot is where nothing is seen, units. */
static const double far_pivot = 10;

/* Of a region that was drawn, times that of the mesh. */
static const double region_density = 2;

void view_say(struct view *view, bool aloud, const char *format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(view->notice, sizeof view->notice, format, arguments);
    va_end(arguments);
    view->dirty = true;
    if (!aloud)
        return;
    printf("%s\n", view->notice);
    fflush(stdout);
}

/* Words of the command line, and the window's that POV-Ray may know. */
static void view_begin_beside(struct view *view)
{
    int count = view->argc + view->wish.word_count;
    char **words = memory_new(((size_t)count + 1) * sizeof *words);
    memcpy(words, view->argv, (size_t)view->argc * sizeof *words);
    for (int i = 0; i < view->wish.word_count; i++)
        words[view->argc + i] = view->wish.words[i];
    const struct beside_view same = { count, words, view->wish.moved,
                                      view->camera, view->wish.frame };
    beside_start(view->beside, &same);
    memory_free(words);
}

void view_compare(struct view *view)
{
    static const char *const names[] = {
        [SIDE_GLIM] = "glim",
        [SIDE_POVRAY] = "POV-Ray",
        [SIDE_SPLIT] = "glim | POV-Ray, split at the pointer",
        [SIDE_HEAT] = "FLIP: how different they look",
    };
    enum beside_state state = view->beside_state;
    if (state == BESIDE_NONE || state == BESIDE_FAILED) {
        view_begin_beside(view);
        view->side = SIDE_POVRAY;
        view_say(view, false, "POV-Ray draws this view");
        return;
    }
    view->side = (enum view_side)((view->side + 1) % (SIDE_HEAT + 1));
    view_say(view, false, "%s", names[view->side]);
}

void view_wish(struct view *view)
{
    struct wish *last = &view->wished;
    beside_forget(view->beside);
    view->side = SIDE_GLIM;
    last->frame = view->wish.frame;
    if (memcmp(last, &view->wish, sizeof *last) != 0)
        reel_clear(&view->reel);
    *last = view->wish;
    view->busy = true;
    view->dirty = true;
    view->shown = view->status.first = 0;
    engine_wish(view->engine, &view->wish);
}

static int view_word(const struct view *view, const char *option)
{
    int i = 0;
    while (i < view->wish.word_count &&
           strncmp(view->wish.words[i], option, strlen(option)) != 0)
        i++;
    return i;
}

const char *view_get(const struct view *view, const char *option)
{
    int word = view_word(view, option);
    return word < view->wish.word_count
               ? view->wish.words[word] + strlen(option)
               : NULL;
}

void view_set(struct view *view, const char *option, const char *value)
{
    struct wish *wish = &view->wish;
    int word = view_word(view, option);
    if (!value && word < wish->word_count) {
        memmove(wish->words[word], wish->words[word + 1],
                (size_t)(wish->word_count - word - 1) * sizeof *wish->words);
        memset(wish->words[--wish->word_count], 0, sizeof *wish->words);
    } else if (value && word < WISH_WORDS) {
        memset(wish->words[word], 0, sizeof *wish->words);
        snprintf(wish->words[word], sizeof *wish->words, "%s%s", option, value);
        wish->word_count += word == wish->word_count;
    }
}

bool view_has_scene(struct view *view)
{
    if (!view->camera.kind)
        view_say(view, false, "there is no scene yet");
    return view->camera.kind;
}

void view_moved(struct view *view)
{
    if (!fly_free(&view->camera)) {
        view->camera = view->status.camera;
        view_say(view, false, "a %s is where its triangles are",
                 view->camera.kind->name);
        return;
    }
    view->wish.moved = true;
    view->wish.camera = view->camera;
    view_wish(view);
}

vec3 view_pivot(struct view *view)
{
    struct model *model = engine_model(view->engine);
    const struct camera *camera = &view->camera;
    struct question_hit hit = { .met = false };
    if (model)
        hit = question_meet(model, camera, 0.5, 0.5);
    model_leave(model);
    vec3 ahead = vec3_normalise(camera->direction);
    double away = hit.met ? hit.at.t : far_pivot;
    if (!hit.met && camera->has_look_at && !view->wish.moved)
        away = vec3_length(vec3_sub(camera->look_at, camera->location));
    return vec3_along(camera->location, ahead, away);
}

void view_ask(struct view *view)
{
    struct model *model = engine_model(view->engine);
    double x = view->pointer[0], y = view->pointer[1];
    view->asked_line = 0;
    if (!model)
        return;
    struct question_hit hit = question_meet(model, &view->camera, x, y);
    if (hit.met && question_span(&hit, false).source) {
        struct span span = question_span(&hit, false);
        view->asked_line = source_locate(span.source, span.offset).line;
        snprintf(view->asked_file, sizeof view->asked_file, "%s",
                 span.source->name);
    }
    if (view->busy) {
        char *said = NULL;
        size_t size;
        FILE *out = open_memstream(&said, &size);
        question_tell(&hit, out);
        fclose(out);
        said[strcspn(said, "\n")] = '\0';
        view_say(view, false, "%s", said);
        free(said);
    }
    model_leave(model);
    engine_do(view->engine, ENGINE_ASK, x, y);
}

/* The mesh is as dense there as what is printed says. */
static void view_region(struct view *view, const struct box3 *box)
{
    struct model_changes *changes = &view->wish.changes;
    if (changes->region_count == MODEL_REGIONS) {
        memmove(changes->regions, changes->regions + 1,
                (MODEL_REGIONS - 1) * sizeof *changes->regions);
        changes->region_count--;
    }
    changes->regions[changes->region_count++] =
        (struct mesh_region){ box->low, box->high, region_density };
    view_wish(view);
}

void view_box(struct view *view)
{
    struct model *model = engine_model(view->engine);
    struct box3 box = box3_empty();
    enum { PLACES = 17 };
    view->box = false;
    for (int i = 0; model && i < PLACES * PLACES; i++) {
        double u = (double)(i % PLACES) / (PLACES - 1);
        double v = (double)(i / PLACES) / (PLACES - 1);
        struct question_hit hit = question_meet(
            model, &view->camera,
            view->corner[0] + u * (view->pointer[0] - view->corner[0]),
            view->corner[1] + v * (view->pointer[1] - view->corner[1]));
        if (hit.met)
            box = box3_add(box, hit.at.point);
    }
    model_leave(model);
    if (box3_is_empty(box)) {
        view_say(view, false, "nothing is seen in the box");
        return;
    }
    view_region(view, &box);
    view_say(view, true,
             "region { <%.5g, %.5g, %.5g>, <%.5g, %.5g, %.5g> factor %g }",
             box.low.x, box.low.y, box.low.z, box.high.x, box.high.y,
             box.high.z, region_density);
}

void view_press(struct view *view, const SDL_Keysym *key)
{
    unsigned kinds = 0;
    const unsigned all[] = { KMOD_SHIFT, KMOD_CTRL, KMOD_ALT };
    for (int i = 0; i < 3; i++)
        if (key->mod & all[i])
            kinds |= all[i];
    for (const struct view_key *row = view_keys; row->shown; row++)
        if (row->code == key->sym && row->mods == kinds) {
            row->press(view, row->amount);
            view->dirty = true;
            return;
        }
}
