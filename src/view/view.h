/* All that the window knows; what keys and the mouse do with it. */
#ifndef VIEW_VIEW_H
#define VIEW_VIEW_H

#include "view/beside.h"
#include "view/engine.h"
#include "view/follow.h"
#include "view/question.h"
#include "view/reel.h"
#include "view/script.h"
#include "view/window.h"

enum { VIEW_NOTICE = 400, VIEW_NAME = 64 };

/* What stands in the window. */
enum view_side { SIDE_GLIM, SIDE_POVRAY, SIDE_SPLIT, SIDE_HEAT };

enum view_drag { DRAG_NONE, DRAG_ORBIT, DRAG_PAN, DRAG_BOX };

struct view {
    struct window *window;
    struct canvas canvas;
    struct engine *engine;
    struct beside *beside;
    enum view_side side;
    enum beside_state beside_state; /* as shown */
    int argc;                       /* of the command line */
    char **argv;
    struct follow *follow;
    struct script *script; /* or NULL */
    struct diag diag;      /* of the window itself */
    const char *title;

    struct reel reel;
    struct wish wish;
    struct wish wished; /* before */
    struct engine_status status;
    struct camera camera; /* that is shown */
    unsigned models, answers;
    unsigned finished; /* counts pictures that were finished, or failed */
    bool busy;         /* the last one isn't yet */
    double shown;      /* clock_seconds, of something of it; 0: not yet */
    double worked;     /* clock_worked, likewise */

    SDL_Rect picture;  /* where it is in the window */
    SDL_Rect slider;   /* of time; empty: no animation */
    double pointer[2]; /* in the picture, 0..1 */
    bool cross;        /* the pointer is moved by keys, and so shown */
    enum view_drag drag;
    int down[2], last[2];          /* of the mouse */
    double corner[2];              /* of a box */
    bool box;                      /* it is shown, up to the pointer */
    bool hovers;                   /* the mouse is over the picture */
    char asked_file[FILENAME_MAX]; /* of the object that was asked for last */
    unsigned asked_line;           /* 0: none */

    char notice[VIEW_NOTICE]; /* what was said last */
    bool help, quit, dirty;
    unsigned changes; /* of the canvas, as shown */
};

/* A key: what it does. */
struct view_key {
    SDL_Keycode code;
    unsigned mods; /* KMOD_SHIFT, KMOD_CTRL, KMOD_ALT; any of a kind */
    const char *shown, *help;
    void (*press)(struct view *view, int amount);
    int amount;
};

/* Those of view_keys.c; the last has no `shown`. */
extern const struct view_key view_keys[];

void view_press(struct view *view, const SDL_Keysym *key);

/* Says something on the status line, and on standard output if `aloud`. */
__attribute__((format(printf, 3, 4))) void
view_say(struct view *view, bool aloud, const char *format, ...);

/* POV-Ray's picture of this view is asked for, or looked at another way. */
void view_compare(struct view *view);

/* Wishes for what view->wish has now. */
void view_wish(struct view *view);

/* The option that begins so becomes `value`; NULL: is left to the command line
 * again. */
void view_set(struct view *view, const char *option, const char *value);

/* Its value, or NULL: the window didn't set it. */
const char *view_get(const struct view *view, const char *option);

/* Whether there was a scene to move in; else says so. */
bool view_has_scene(struct view *view);

/* Wishes for the camera as it is now. */
void view_moved(struct view *view);

/* What is in the middle of the picture, else a point as far away as anything
 * near: what moves turn about. */
vec3 view_pivot(struct view *view);

/* Says what is under the pointer. */
void view_ask(struct view *view);

/* The box that was drawn becomes a region of the light mesh, and its text is
 * printed. */
void view_box(struct view *view);

#endif
