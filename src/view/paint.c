/* Drawing the window: see paint.h. */
#include "view/paint.h"

#include <math.h>
#include <stdlib.h>

enum {
    TEXT = 0xd8dde4,
    QUIET = 0x8a94a2,
    WRONG = 0xff9a8a,
    MARK = 0xffd75f,
    STATUS = 0x1b2027,
    BAR = 0x4a90d9,
    DIM = 150,
    EDGE = 8,
    SLIDER = 12,
};

/* The picture as large as fits, but no larger than it is unless it is less than
 * half of that. */
static void paint_place(struct view *view, SDL_Rect all)
{
    int width = view->canvas.width, height = view->canvas.height;
    int high = all.h - PAINT_STATUS > 1 ? all.h - PAINT_STATUS : 1;
    if (width < 1 || height < 1) {
        view->picture = (SDL_Rect){ 0, 0, 0, 0 };
        return;
    }
    double scale = fmin((double)all.w / width, (double)high / height);
    if (scale > 1)
        scale = floor(scale);
    view->picture.w = (int)(width * scale + 0.5);
    view->picture.h = (int)(height * scale + 0.5);
    if (view->picture.w < 1)
        view->picture.w = 1;
    if (view->picture.h < 1)
        view->picture.h = 1;
    view->picture.x = (all.w - view->picture.w) / 2;
    view->picture.y = (high - view->picture.h) / 2;
}

static void paint_stage(const struct view *view, char *text, size_t size)
{
    static const char *const names[] = {
        [ENGINE_READING] = "reading",  [ENGINE_BUILDING] = "building",
        [ENGINE_ROUGH] = "first look", [ENGINE_LIGHTING] = "lighting",
        [ENGINE_DRAWING] = "drawing",  [ENGINE_DONE] = "done",
        [ENGINE_WRONG] = "wrong",
    };
    const struct engine_status *status = &view->status;
    int length = snprintf(text, size, "%s", names[status->stage]);
    if (status->stage == ENGINE_DRAWING)
        length += snprintf(text + length, size - (size_t)length, " %.0f %%",
                           100 * status->share);
    if (status->stage == ENGINE_DONE)
        length += snprintf(text + length, size - (size_t)length, " in %.2f s",
                           status->finished);
    if (view->wish.changes.lamp)
        length += snprintf(text + length, size - (size_t)length, " | lamp %d",
                           view->wish.changes.lamp);
    if (status->lighting)
        length +=
            snprintf(text + length, size - (size_t)length, " | %s | %d x %d",
                     status->lighting, status->width, status->height);
    if (status->frames > 1)
        length +=
            snprintf(text + length, size - (size_t)length, " | frame %d of %d",
                     view->wish.frame + 1, status->frames);
    if (status->stage == ENGINE_DONE)
        snprintf(text + length, size - (size_t)length, "%s", status->light);
}

/* Frames: where this one is, and which have been drawn. */
static void paint_slider(struct view *view, SDL_Rect all)
{
    int frames = view->status.frames;
    view->slider = (SDL_Rect){ 0, 0, 0, 0 };
    if (frames < 2)
        return;
    SDL_Rect slider = { EDGE, all.h - PAINT_STATUS - SLIDER - 2,
                        all.w - 2 * EDGE, SLIDER };
    int now = view->reel.playing ? view->reel.shown : view->wish.frame;
    view->slider = slider;
    window_fill(view->window, &slider, STATUS, 200);
    for (int i = 0; i < frames; i++) {
        int left = slider.x + i * slider.w / frames;
        int right = slider.x + (i + 1) * slider.w / frames;
        const SDL_Rect cell = { left, slider.y + 3,
                                right - left > 1 ? right - left - 1 : 1,
                                slider.h - 6 };
        if (i == now || reel_has(&view->reel, i))
            window_fill(view->window, &cell, i == now ? MARK : BAR, 255);
    }
}

/* How many lines of the window the text takes. */
static int paint_lines(const struct window *window, const char *text, int width)
{
    int lines = 1;
    for (text += window_fit(window, text, width); *text; lines++)
        text += window_fit(window, text, width);
    return lines;
}

/* What it does and what was said last. In a narrow window that may take more
 * lines, over the picture. */
static void paint_status(struct view *view, SDL_Rect all)
{
    char text[VIEW_NOTICE];
    struct window *window = view->window;
    const char *notice = view->notice[0] ? view->notice : "? lists the keys";
    int line = window_line(window), width = all.w - 2 * EDGE;
    int more = line * (paint_lines(window, notice, width) - 1);
    int y = all.h - PAINT_STATUS - more;
    SDL_Rect strip = { 0, y, all.w, PAINT_STATUS + more };
    SDL_Rect bar = { 0, y, (int)(all.w * view->status.share), 2 };
    window_fill(window, &strip, STATUS, 255);
    if (view->status.stage == ENGINE_DRAWING)
        window_fill(window, &bar, BAR, 255);
    paint_stage(view, text, sizeof text);
    bool wrong = view->status.stage == ENGINE_WRONG;
    y += 4;
    window_text(window, EDGE, y, all.w - EDGE, wrong ? WRONG : QUIET, text);
    while (*notice) {
        size_t length = window_fit(window, notice, width);
        snprintf(text, sizeof text, "%.*s", (int)length, notice);
        window_text(window, EDGE, y += line, all.w - EDGE, TEXT, text);
        notice += length;
    }
}

/* What is wrong, over the picture, which is old. */
static void paint_message(struct view *view, SDL_Rect all)
{
    SDL_Rect picture = { 0, 0, all.w, all.h - PAINT_STATUS };
    const char *text = view->status.text;
    if (!view->status.wrong)
        return;
    window_fill(view->window, &picture, 0, DIM);
    window_box(view->window, 2 * EDGE, 2 * EDGE, WRONG,
               text[0] ? text : "nothing was drawn");
}

static void paint_help(struct view *view)
{
    char text[4096] = "";
    size_t length = 0;
    if (!view->help)
        return;
    for (const struct view_key *key = view_keys; key->shown; key++)
        if (key->help && length < sizeof text)
            length += (size_t)snprintf(text + length, sizeof text - length,
                                       "%-26s %s\n", key->shown, key->help);
    window_box(view->window, 2 * EDGE, 2 * EDGE, TEXT, text);
}

static void paint_pointer(struct view *view)
{
    const SDL_Rect *area = &view->picture;
    int x = area->x + (int)(view->pointer[0] * area->w);
    int y = area->y + (int)(view->pointer[1] * area->h);
    if (view->cross) {
        const SDL_Rect across = { x - EDGE, y, 2 * EDGE + 1, 1 };
        const SDL_Rect down = { x, y - EDGE, 1, 2 * EDGE + 1 };
        window_fill(view->window, &across, MARK, 255);
        window_fill(view->window, &down, MARK, 255);
    }
    if (view->box) {
        int u = area->x + (int)(view->corner[0] * area->w);
        int v = area->y + (int)(view->corner[1] * area->h);
        const SDL_Rect box = { u < x ? u : x, v < y ? v : y, abs(u - x) + 1,
                               abs(v - y) + 1 };
        window_frame(view->window, &box, MARK);
    }
}

/* The value of what is shown over the picture next to the pointer. */
static void paint_value(struct view *view)
{
    const SDL_Rect *area = &view->picture;
    const int size[2] = { area->w, area->h };
    char text[VIEW_NOTICE];
    bool asked = (view->hovers || view->cross) && view->status.shown;
    if (!asked || view->side != SIDE_GLIM || view->reel.playing ||
        !engine_value(view->engine, &view->camera, view->pointer, size, text,
                      sizeof text))
        return;
    int x = area->x + (int)(view->pointer[0] * area->w) + 2 * EDGE;
    int y = area->y + (int)(view->pointer[1] * area->h) + 2 * EDGE;
    window_label(view->window, x, y, MARK, text);
}

/* glim's picture, POV-Ray's, both, or their differences. */
static void paint_picture(struct view *view)
{
    struct window *window = view->window;
    const SDL_Rect *area = &view->picture;
    enum view_side side = view->side;
    bool drawn = view->beside_state >= BESIDE_DRAWN &&
                 view->beside_state != BESIDE_FAILED;
    struct canvas *other = beside_picture(view->beside);
    if (view->reel.playing && view->reel.screen.pixels)
        window_picture(window, &view->reel.screen, area);
    else if (side == SIDE_HEAT && view->beside_state == BESIDE_DONE)
        window_picture(window, beside_heat(view->beside), area);
    else if (side == SIDE_POVRAY && drawn)
        window_picture(window, other, area);
    else
        window_picture(window, &view->canvas, area);
    if (side != SIDE_SPLIT || !drawn)
        return;
    int left = area->x + (int)(view->pointer[0] * area->w);
    const SDL_Rect line = { left, area->y, 1, area->h };
    window_picture_from(window, other, area, left);
    window_fill(window, &line, MARK, 255);
}

bool paint_window(struct view *view)
{
    struct window *window = view->window;
    if (!window_begin(window))
        return false;
    SDL_Rect all = window_area(window);
    SDL_LockMutex(view->canvas.lock);
    paint_place(view, all);
    SDL_UnlockMutex(view->canvas.lock);
    paint_picture(view);
    paint_pointer(view);
    paint_value(view);
    paint_message(view, all);
    paint_help(view);
    paint_slider(view, all);
    paint_status(view, all);
    window_show(window);
    return true;
}
