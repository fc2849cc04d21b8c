/* glim-view: a window that follows a scene. The loop of its events. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/clock.h"
#include "cli/interrupt.h"
#include "view/drawing.h"
#include "view/fly.h"
#include "view/paint.h"
#include "view/view.h"

enum { TICK = 15 /* ms */ };

static bool view_in_picture(struct view *view, int x, int y)
{
    const SDL_Rect *area = &view->picture;
    view->pointer[0] = (x + 0.5 - area->x) / (area->w ? area->w : 1);
    view->pointer[1] = (y + 0.5 - area->y) / (area->h ? area->h : 1);
    bool in = view->pointer[0] >= 0 && view->pointer[0] < 1 &&
              view->pointer[1] >= 0 && view->pointer[1] < 1;
    for (int i = 0; i < 2; i++)
        view->pointer[i] = fmin(1, fmax(0, view->pointer[i]));
    return in;
}

/* A click on the slider: that frame. */
static bool view_slide(struct view *view, int x, int y)
{
    const SDL_Rect *slider = &view->slider;
    if (x < slider->x || x >= slider->x + slider->w || y < slider->y ||
        y >= slider->y + slider->h)
        return false;
    view->wish.frame = (x - slider->x) * view->status.frames / slider->w;
    view->reel.playing = false;
    view_wish(view);
    return true;
}

static void view_mouse_down(struct view *view,
                            const SDL_MouseButtonEvent *event)
{
    bool shift = SDL_GetModState() & KMOD_SHIFT;
    if (view_slide(view, event->x, event->y))
        return;
    if (!view_in_picture(view, event->x, event->y))
        return;
    view->down[0] = view->last[0] = event->x;
    view->down[1] = view->last[1] = event->y;
    view->drag = event->button == SDL_BUTTON_RIGHT             ? DRAG_BOX
                 : event->button == SDL_BUTTON_MIDDLE || shift ? DRAG_PAN
                                                               : DRAG_ORBIT;
    if (view->drag == DRAG_BOX) {
        view->box = true;
        memcpy(view->corner, view->pointer, sizeof view->corner);
    }
}

static void view_mouse_move(struct view *view,
                            const SDL_MouseMotionEvent *event)
{
    double across = (double)(event->x - view->last[0]) / view->picture.w;
    double down = (double)(event->y - view->last[1]) / view->picture.h;
    view->hovers = view_in_picture(view, event->x, event->y);
    view->cross = view->box;
    view->dirty = view->dirty || view->box || view->side == SIDE_SPLIT ||
                  view->status.shown;
    if (view->drag == DRAG_NONE || view->drag == DRAG_BOX ||
        !view_has_scene(view) || (across == 0 && down == 0))
        return;
    view->last[0] = event->x;
    view->last[1] = event->y;
    vec3 pivot = view_pivot(view);
    double away = vec3_length(vec3_sub(pivot, view->camera.location));
    if (view->drag == DRAG_PAN)
        fly_pan(&view->camera, away, -across, down);
    else
        fly_orbit(&view->camera, pivot, -180 * across, 180 * down);
    view_moved(view);
}

static void view_mouse_up(struct view *view, const SDL_MouseButtonEvent *event)
{
    bool still = event->x == view->down[0] && event->y == view->down[1];
    enum view_drag drag = view->drag;
    view->drag = DRAG_NONE;
    if (drag == DRAG_BOX && still)
        view->box = false;
    else if (drag == DRAG_BOX)
        view_box(view);
    else if (drag != DRAG_NONE && still)
        view_ask(view);
    view->dirty = true;
}

static void view_wheel(struct view *view, int steps)
{
    if (!view_has_scene(view))
        return;
    fly_dolly(&view->camera, view_pivot(view), pow(0.9, steps));
    view_moved(view);
}

static void view_event(struct view *view, const SDL_Event *event)
{
    switch (event->type) {
    case SDL_QUIT:
        view->quit = true;
        break;
    case SDL_KEYDOWN:
        view_press(view, &event->key.keysym);
        break;
    case SDL_MOUSEBUTTONDOWN:
        view_mouse_down(view, &event->button);
        break;
    case SDL_MOUSEMOTION:
        if (view->picture.w > 0 && view->picture.h > 0)
            view_mouse_move(view, &event->motion);
        break;
    case SDL_MOUSEBUTTONUP:
        view_mouse_up(view, &event->button);
        break;
    case SDL_MOUSEWHEEL:
        view_wheel(view, event->wheel.y);
        break;
    case SDL_WINDOWEVENT:
        view->dirty = true;
        break;
    default:
        break;
    }
}

/* The text has been read: its camera counts, unless it is as before and was
 * left. */
static void view_read(struct view *view, const struct camera *before)
{
    const struct camera *now = &view->status.camera;
    bool first = view->models == 0;
    view->models = view->status.models;
    if (!first && view->wish.moved && fly_same(before, now))
        return;
    view->camera = *now;
    if (!view->wish.moved)
        return;
    view->wish.moved = false;
    view_wish(view);
}

/* What the engine did meanwhile. */
static void view_look(struct view *view)
{
    struct engine_status *status = &view->status;
    struct camera before = status->camera;
    enum engine_stage stage = status->stage;
    double share = status->share;
    engine_look(view->engine, status);
    view->dirty = view->dirty || stage != status->stage ||
                  fabs(share - status->share) > 0.005;
    if (status->models != view->models)
        view_read(view, &before);
    if (view->busy &&
        (status->stage == ENGINE_DONE || status->stage == ENGINE_WRONG)) {
        view->busy = false;
        view->finished++;
        if (status->stage == ENGINE_DONE && status->frames > 1)
            reel_keep(&view->reel, view->wish.frame, status->frames,
                      &view->canvas);
    }
    if (status->answers != view->answers) {
        view->answers = status->answers;
        fputs(status->answer, stdout);
        fflush(stdout);
        view_say(view, false, "%s", status->notice);
    }
    SDL_LockMutex(view->canvas.lock);
    view->dirty = view->dirty || view->changes != view->canvas.changes;
    view->changes = view->canvas.changes;
    SDL_UnlockMutex(view->canvas.lock);
}

static void view_look_beside(struct view *view)
{
    enum beside_state state =
        beside_look(view->beside, &view->canvas, !view->busy);
    if (state == view->beside_state)
        return;
    view->beside_state = state;
    view->dirty = true;
    if (state == BESIDE_DONE || state == BESIDE_FAILED)
        view_say(view, true, "%s", beside_text(view->beside));
}

/* While frames are played the missing ones are drawn. */
static void view_play(struct view *view)
{
    struct reel *reel = &view->reel;
    view->dirty = reel_play(reel) || view->dirty;
    if (!reel->playing || view->busy)
        return;
    int missing = reel_next(reel, view->wish.frame, false);
    if (view->status.stage == ENGINE_WRONG || missing == view->wish.frame ||
        reel->bytes + 8 * (size_t)reel->width * (size_t)reel->height >
            REEL_LIMIT)
        return;
    view->wish.frame = missing;
    view_wish(view);
}

static void view_follow(struct view *view)
{
    struct file_list files;
    if (engine_files(view->engine, &files))
        follow_files(view->follow, files);
    if (!follow_changed(view->follow))
        return;
    view->wish.read++;
    view_wish(view);
}

static bool view_script(struct view *view)
{
    const struct script_state state = {
        .idle = !view->busy && !view->status.asked &&
                (view->beside_state == BESIDE_NONE ||
                 view->beside_state >= BESIDE_DONE),
        .wrong = view->status.stage == ENGINE_WRONG,
        .number = view->finished,
        .first = view->status.first,
        .finished = view->status.finished,
        .shown = view->shown,
        .worked = view->worked,
    };
    if (!view->script)
        return true;
    return script_step(view->script, view->window, &state, &view->diag);
}

static void view_painted(struct view *view)
{
    view->dirty = false;
    if (view->shown > 0 || view->status.first == 0)
        return;
    view->shown = clock_seconds();
    view->worked = clock_worked();
}

static void view_loop(struct view *view, const atomic_int *stop)
{
    SDL_Event event;
    while (!view->quit && !atomic_load(stop)) {
        if (SDL_WaitEventTimeout(&event, TICK))
            do
                view_event(view, &event);
            while (SDL_PollEvent(&event));
        view_follow(view);
        view_look(view);
        view_look_beside(view);
        view_play(view);
        if (view->dirty && paint_window(view))
            view_painted(view);
        if (!view_script(view)) {
            view->quit = view->quit || script_failed(view->script);
            script_free(view->script);
            view->script = NULL;
        }
    }
}

/* Takes "--view-script FILE" away; returns FILE or NULL. */
static const char *take_script(int *argc, char **argv)
{
    const char *found = NULL;
    int kept = 0;
    for (int i = 0; i < *argc; i++) {
        if (strcmp(argv[i], "--view-script") == 0 && i + 1 < *argc)
            found = argv[++i];
        else if (strncmp(argv[i], "--view-script=", 14) == 0)
            found = argv[i] + 14;
        else
            argv[kept++] = argv[i];
    }
    argv[ *argc = kept] = NULL;
    return found;
}

/* Whether the options are right and ask for a picture; their size. Prints what
 * --help and --version ask for. */
static bool options_good(int argc, char **argv, int size[2], bool *answered,
                         struct diag *diag)
{
    struct drawing *drawing = drawing_new(argc, argv, diag);
    if (!drawing)
        return false;
    const struct options *options = &drawing->options;
    bool good = true;
    size[0] = options->render.width;
    size[1] = options->render.height;
    *answered = options_answers(options);
    if (*answered)
        good = options_answer(options, diag);
    else if (strcmp(options->input, "-") == 0 || options->probe ||
             options->debug_pixel || options->light.light_mesh.only) {
        diag_print(diag, DIAG_ERROR, span_none(), NULL,
                   "a window needs a scene file and a picture: leave out "
                   "--probe, --debug-pixel, --mesh-only and '-'");
        good = false;
    }
    drawing_free(drawing);
    return good;
}

/* Everything from the window's opening to its closing. */
static int view_run(struct view *view, int argc, char **argv, const int size[2])
{
    const atomic_int *stop = interrupt_catch();
    int width = size[0] > PAINT_WIDTH ? size[0] : PAINT_WIDTH;
    int height = size[1] > PAINT_HEIGHT ? size[1] : PAINT_HEIGHT;
    view->window =
        window_open(view->title, width, height + PAINT_STATUS, &view->diag);
    if (!view->window)
        return EXIT_FAILURE;
    canvas_start(&view->canvas);
    view->follow = follow_new();
    view->beside = beside_new();
    reel_start(&view->reel);
    view->argc = argc;
    view->argv = argv;
    view->engine = engine_start(argc, argv, &view->canvas);
    view->busy = view->dirty = true;
    if (view->engine)
        view_loop(view, stop);
    else
        diag_print(&view->diag, DIAG_ERROR, span_none(), NULL,
                   "the system gives no thread");
    bool good = view->engine && view->diag.errors == 0;
    if (view->engine)
        engine_end(view->engine);
    beside_free(view->beside);
    reel_end(&view->reel);
    follow_free(view->follow);
    canvas_end(&view->canvas);
    window_close(view->window);
    return good ? EXIT_SUCCESS : EXIT_FAILURE;
}

int main(int argc, char **argv)
{
    static struct view view;
    int size[2], status = EXIT_FAILURE;
    bool answered;
    view.diag = diag_new();
    view.diag.program = "glim-view";
    const char *path = take_script(&argc, argv);
    if (path && !(view.script = script_read(path, &view.diag)))
        return EXIT_FAILURE;
    view.title = "glim-view";
    if (options_good(argc, argv, size, &answered, &view.diag))
        status = answered ? EXIT_SUCCESS : view_run(&view, argc, argv, size);
    script_free(view.script);
    return status;
}
