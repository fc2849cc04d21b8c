/* The table of keys, and what each does. */
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "lightmesh/interpolation.h"
#include "tracer/integrator.h"
#include "view/editor.h"
#include "view/fly.h"
#include "view/view.h"

static const double turn_step = 5, pan_step = 0.05, dolly_step = 0.9,
                    walk_step = 0.05, pointer_step = 0.02, knob_step = 1.25;

static void press_quit(struct view *view, int amount)
{
    (void)amount;
    view->quit = true;
}

static void press_help(struct view *view, int amount)
{
    view->help = amount ? !view->help : false;
    view->box = false;
}

static void press_save(struct view *view, int amount)
{
    (void)amount;
    if (view->busy)
        view_say(view, false, "will be saved when it is finished");
    engine_do(view->engine, ENGINE_SAVE, 0, 0);
}

static void press_orbit_across(struct view *view, int amount)
{
    if (!view_has_scene(view))
        return;
    fly_orbit(&view->camera, view_pivot(view), turn_step * amount, 0);
    view_moved(view);
}

static void press_orbit_up(struct view *view, int amount)
{
    if (!view_has_scene(view))
        return;
    fly_orbit(&view->camera, view_pivot(view), 0, turn_step * amount);
    view_moved(view);
}

static double view_distance(struct view *view)
{
    return vec3_length(vec3_sub(view_pivot(view), view->camera.location));
}

static void press_pan_across(struct view *view, int amount)
{
    if (!view_has_scene(view))
        return;
    fly_pan(&view->camera, view_distance(view), pan_step * amount, 0);
    view_moved(view);
}

static void press_pan_up(struct view *view, int amount)
{
    if (!view_has_scene(view))
        return;
    fly_pan(&view->camera, view_distance(view), 0, pan_step * amount);
    view_moved(view);
}

static void press_dolly(struct view *view, int amount)
{
    if (!view_has_scene(view))
        return;
    fly_dolly(&view->camera, view_pivot(view), pow(dolly_step, amount));
    view_moved(view);
}

static void press_walk(struct view *view, int amount)
{
    if (!view_has_scene(view))
        return;
    fly_walk(&view->camera, view_distance(view) * walk_step * amount, 0);
    view_moved(view);
}

static void press_turn(struct view *view, int amount)
{
    if (!view_has_scene(view))
        return;
    fly_turn(&view->camera, turn_step * amount, 0);
    view_moved(view);
}

static void press_back(struct view *view, int amount)
{
    (void)amount;
    if (!view_has_scene(view))
        return;
    view->camera = view->status.camera;
    view->wish.moved = false;
    view_wish(view);
    view_say(view, false, "the file's camera");
}

static void press_camera(struct view *view, int amount)
{
    char *said = NULL;
    size_t size;
    (void)amount;
    if (!view_has_scene(view))
        return;
    if (!fly_free(&view->camera) || view->camera.normal) {
        view_say(view, false,
                 "this camera's block can only be copied from the file");
        return;
    }
    FILE *out = open_memstream(&said, &size);
    fly_print(&view->camera, out);
    fclose(out);
    fputs(said, stdout);
    fflush(stdout);
    SDL_SetClipboardText(said);
    free(said);
    view_say(view, false,
             "the camera block is on standard output and on the clipboard");
}

static void press_ask(struct view *view, int amount)
{
    (void)amount;
    view_ask(view);
}

static void press_edit(struct view *view, int amount)
{
    (void)amount;
    if (!view->asked_line)
        view_say(view, false, "click on something first, or press a");
    else if (editor_open(view->asked_file, view->asked_line))
        view_say(view, false, "editing %s, line %u", view->asked_file,
                 view->asked_line);
    else
        view_say(view, false, "no editor: set VISUAL or EDITOR");
}

static void press_pointer_across(struct view *view, int amount)
{
    view->cross = true;
    view->pointer[0] =
        fmin(1, fmax(0, view->pointer[0] + pointer_step * amount));
}

static void press_pointer_down(struct view *view, int amount)
{
    view->cross = true;
    view->pointer[1] =
        fmin(1, fmax(0, view->pointer[1] + pointer_step * amount));
}

static void press_box(struct view *view, int amount)
{
    (void)amount;
    if (view->box) {
        view_box(view);
        return;
    }
    view->box = view->cross = true;
    memcpy(view->corner, view->pointer, sizeof view->corner);
    view_say(view, false, "the box's other corner: move, then b again");
}

static void press_no_boxes(struct view *view, int amount)
{
    (void)amount;
    view->wish.changes.region_count = 0;
    view_wish(view);
    view_say(view, false, "no regions but the file's");
}

/* One lamp after the other, then all again. */
static void press_lamp(struct view *view, int amount)
{
    int count = view->status.lamps, *lamp = &view->wish.changes.lamp;
    if (count < 2) {
        view_say(view, false, "there are no two lamps");
        return;
    }
    *lamp = (*lamp + amount + count + 1) % (count + 1);
    view_wish(view);
    if (*lamp)
        view_say(view, false, "lamp %d of %d alone", *lamp, count);
    else
        view_say(view, false, "all %d lamps", count);
}

static void press_lighting(struct view *view, int amount)
{
    const struct lighting *lighting = integrator_lighting_at((size_t)amount);
    if (!lighting)
        return;
    view_set(view, "--lighting=", lighting->name);
    view_set(view, "--show=", NULL);
    view_say(view, false, "--lighting %s: %s", lighting->name, lighting->help);
    view_wish(view);
}

/* The next of some names after the one that is set. */
static const char *next_name(const char *const *names, const char *now)
{
    for (size_t i = 0; now && names[i]; i++)
        if (strcmp(names[i], now) == 0)
            return names[i + 1];
    return names[0];
}

static void press_interpolation(struct view *view, int amount)
{
    enum { MOST = 16 };
    const char *names[MOST] = { NULL };
    (void)amount;
    for (size_t i = 0; i < MOST - 1 && interpolation_at(i); i++)
        names[i] = interpolation_at(i)->name;
    const char *name =
        next_name(names, view_get(view, "--mesh-interpolation="));
    view_set(view, "--mesh-interpolation=", name);
    view_say(view, false, "--mesh-interpolation %s",
             name ? name : "as the scene says");
    view_wish(view);
}

static void press_shadows(struct view *view, int amount)
{
    static const char *const names[] = { "soft", "sharp", NULL };
    (void)amount;
    const char *name = next_name(names, view_get(view, "--mesh-shadows="));
    view_set(view, "--mesh-shadows=", name);
    view_say(view, false, "--mesh-shadows %s",
             name ? name : "as the scene says");
    view_wish(view);
}

/* A number times a factor, from what was set or else `from`. */
static void press_factor(struct view *view, const char *option, double from,
                         int amount)
{
    char text[VIEW_NAME];
    const char *now = view_get(view, option);
    double number = now ? strtod(now, NULL) : from;
    snprintf(text, sizeof text, "%.4g", number * pow(knob_step, amount));
    view_set(view, option, text);
    view_say(view, false, "%s%s", option, text);
    view_wish(view);
}

static void press_density(struct view *view, int amount)
{
    double density = view->status.density;
    press_factor(view, "--mesh-density=", density > 0 ? density : 1, amount);
}

static void press_radius(struct view *view, int amount)
{
    double density = view->status.density;
    press_factor(view, "--mesh-radius=", density > 0 ? 1 / density : 1, amount);
}

static void press_whole(struct view *view, const char *option, int from,
                        int low, int high, int amount)
{
    char text[VIEW_NAME];
    const char *now = view_get(view, option);
    int number = (now ? atoi(now) : from) + amount;
    number = number < low ? low : number > high ? high : number;
    snprintf(text, sizeof text, "%d", number);
    view_set(view, option, text);
    view_say(view, false, "%s%s", option, text);
    view_wish(view);
}

static void press_mesh_quality(struct view *view, int amount)
{
    press_whole(view, "--mesh-quality=", 5, 1, 10, amount);
}

static void press_quality(struct view *view, int amount)
{
    press_whole(view, "Quality=", 9, 0, 11, amount);
}

/* Shows the view of that name, by a lighting that has it; NULL: none. */
static void view_overlay(struct view *view, const char *name)
{
    const char *lighting =
        view->status.lighting ? view->status.lighting : lighting_at(0)->name;
    const struct lighting *now = integrator_lighting_find(lighting);
    for (size_t i = 0; name && !(now && lighting_view(now, name)); i++)
        now = lighting_at(i);
    if (name && strcmp(now->name, lighting) != 0)
        view_set(view, "--lighting=", now->name);
    view_set(view, "--show=", name);
    view_say(view, false, "--show %s", name ? name : "nothing");
    view_wish(view);
}

static void press_show(struct view *view, int amount)
{
    static const char *const names[] = { "mesh", "skeleton", "stream" };
    const char *now = view_get(view, "--show=");
    bool shown = now && strcmp(now, names[amount]) == 0;
    view_overlay(view, shown ? NULL : names[amount]);
}

/* The next view of the lighting in use. */
static void press_next_show(struct view *view, int amount)
{
    enum { MOST = 16 };
    const char *names[MOST] = { NULL };
    (void)amount;
    if (!view_has_scene(view))
        return;
    const struct lighting *now =
        integrator_lighting_find(view->status.lighting);
    for (size_t i = 0; now && now->views && i < MOST - 1; i++) {
        names[i] = now->views[i].name;
        if (!names[i])
            break;
    }
    const char *name = next_name(names, view_get(view, "--show="));
    if (name || view_get(view, "--show="))
        view_overlay(view, name);
    else
        view_say(view, false, "--lighting %s has nothing to show",
                 view->status.lighting);
}

static void press_compare(struct view *view, int amount)
{
    (void)amount;
    view_compare(view);
}

static void press_read(struct view *view, int amount)
{
    (void)amount;
    view->wish.read++;
    view_wish(view);
}

static void press_frame(struct view *view, int amount)
{
    int frames = view->status.frames;
    if (frames < 2) {
        view_say(view, false, "no animation: add +KFF10 or an INI file");
        return;
    }
    view->wish.frame = (view->wish.frame + amount + frames) % frames;
    view_wish(view);
}

static void press_play(struct view *view, int amount)
{
    struct reel *reel = &view->reel;
    (void)amount;
    if (view->status.frames < 2) {
        press_frame(view, 0);
        return;
    }
    reel->playing = !reel->playing;
    view_say(view, false,
             reel->playing ? "plays what is drawn, and draws more" : "stopped");
}

#define KEY(code, mods, shown, help, press, amount)                            \
    {                                                                          \
        SDLK_##code, mods, shown, help, press, amount                          \
    }

const struct view_key view_keys[] = {
    KEY(SLASH, KMOD_SHIFT, "?", "this list", press_help, 1),
    KEY(QUESTION, 0, "?", NULL, press_help, 1),
    KEY(QUESTION, KMOD_SHIFT, "?", NULL, press_help, 1),
    KEY(F1, 0, "F1", NULL, press_help, 1),
    KEY(ESCAPE, 0, "Esc", NULL, press_help, 0),
    KEY(q, 0, "q", "quit", press_quit, 0),
    KEY(s, 0, "s", "save the picture, where glim would", press_save, 0),
    KEY(F5, 0, "F5", "read the scene again", press_read, 0),
    KEY(a, 0, "a, click", "what is under the pointer?", press_ask, 0),
    KEY(RETURN, 0, "Enter", "edit the line of what was asked for", press_edit,
        0),
    KEY(LEFT, KMOD_ALT, "alt+arrows", "move the pointer", press_pointer_across,
        -1),
    KEY(RIGHT, KMOD_ALT, "", NULL, press_pointer_across, 1),
    KEY(UP, KMOD_ALT, "", NULL, press_pointer_down, -1),
    KEY(DOWN, KMOD_ALT, "", NULL, press_pointer_down, 1),
    KEY(LEFT, 0, "arrows, drag", "orbit about what is in the middle",
        press_orbit_across, -1),
    KEY(RIGHT, 0, "", NULL, press_orbit_across, 1),
    KEY(UP, 0, "", NULL, press_orbit_up, 1),
    KEY(DOWN, 0, "", NULL, press_orbit_up, -1),
    KEY(LEFT, KMOD_SHIFT, "shift+arrows, shift+drag", "pan", press_pan_across,
        -1),
    KEY(RIGHT, KMOD_SHIFT, "", NULL, press_pan_across, 1),
    KEY(UP, KMOD_SHIFT, "", NULL, press_pan_up, 1),
    KEY(DOWN, KMOD_SHIFT, "", NULL, press_pan_up, -1),
    KEY(EQUALS, 0, "= -, wheel", "dolly: nearer, farther", press_dolly, 1),
    KEY(PLUS, 0, "", NULL, press_dolly, 1),
    KEY(PLUS, KMOD_SHIFT, "", NULL, press_dolly, 1),
    KEY(EQUALS, KMOD_SHIFT, "", NULL, press_dolly, 1),
    KEY(MINUS, 0, "", NULL, press_dolly, -1),
    KEY(UP, KMOD_CTRL, "ctrl+arrows", "walk: ahead, back, turn", press_walk, 1),
    KEY(DOWN, KMOD_CTRL, "", NULL, press_walk, -1),
    KEY(LEFT, KMOD_CTRL, "", NULL, press_turn, -1),
    KEY(RIGHT, KMOD_CTRL, "", NULL, press_turn, 1),
    KEY(u, 0, "u", "back to the file's camera", press_back, 0),
    KEY(c, 0, "c", "print the camera block of this view", press_camera, 0),
    KEY(1, 0, "1 to 5", "lighting: in the order of --list lightings",
        press_lighting, 0),
    KEY(2, 0, "", NULL, press_lighting, 1),
    KEY(3, 0, "", NULL, press_lighting, 2),
    KEY(4, 0, "", NULL, press_lighting, 3),
    KEY(5, 0, "", NULL, press_lighting, 4),
    KEY(i, 0, "i", "interpolation of the mesh: the next", press_interpolation,
        0),
    KEY(h, 0, "h", "shadows of the mesh: soft, sharp", press_shadows, 0),
    KEY(d, 0, "d D", "density of the mesh: less, more", press_density, -1),
    KEY(d, KMOD_SHIFT, "", NULL, press_density, 1),
    KEY(r, 0, "r R", "radius of interpolation: less, more", press_radius, -1),
    KEY(r, KMOD_SHIFT, "", NULL, press_radius, 1),
    KEY(LEFTBRACKET, 0, "[ ]", "quality of the mesh: less, more",
        press_mesh_quality, -1),
    KEY(RIGHTBRACKET, 0, "", NULL, press_mesh_quality, 1),
    KEY(LEFTBRACKET, KMOD_SHIFT, "{ }", "quality of the picture (+Q)",
        press_quality, -1),
    KEY(RIGHTBRACKET, KMOD_SHIFT, "", NULL, press_quality, 1),
    KEY(m, 0, "m k t", "show the mesh, the skeleton, the stream", press_show,
        0),
    KEY(k, 0, "", NULL, press_show, 1),
    KEY(t, 0, "", NULL, press_show, 2),
    KEY(o, 0, "o", "show the next thing that this lighting has",
        press_next_show, 0),
    KEY(l, 0, "l L", "one lamp alone: the next, the last", press_lamp, 1),
    KEY(l, KMOD_SHIFT, "", NULL, press_lamp, -1),
    KEY(b, 0, "b, right drag", "a box: a region of the mesh, printed",
        press_box, 0),
    KEY(b, KMOD_SHIFT, "B", "forget those regions", press_no_boxes, 0),
    KEY(p, 0, "p", "POV-Ray's picture, both split, how they differ",
        press_compare, 0),
    KEY(COMMA, 0, ", .", "the frame before, the next", press_frame, -1),
    KEY(SPACE, 0, "space", "play the frames that are drawn, draw the others",
        press_play, 0),
    KEY(PERIOD, 0, "", NULL, press_frame, 1),
    { 0, 0, NULL, NULL, NULL, 0 },
};
