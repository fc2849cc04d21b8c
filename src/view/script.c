/* Lines to events: see script.h. */
#include "view/script.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "base/clock.h"
#include "base/memory.h"
#include "base/text.h"

enum { WORDS = 6, WORD = 256, STEPS = 8 };

/* Seconds; no wait is longer. */
static const double wait_limit = 300;

struct script {
    struct arena *arena;
    const struct source *source;
    size_t next;      /* where the next line begins */
    struct span span; /* of the line at work */
    char words[WORDS][WORD];
    int count;       /* of words */
    bool waiting;    /* the line at work is not done */
    double since;    /* waited */
    double did;      /* clock_seconds, of the last key or change of a file, */
    double worked;   /* and clock_worked */
    unsigned number; /* of the picture when it began to wait */
    bool failed;
};

struct script *script_read(const char *path, struct diag *diag)
{
    struct script *script = memory_new(sizeof *script);
    const char *problem = NULL;
    script->arena = arena_new(0);
    script->source = source_read(script->arena, path, span_none(), &problem);
    if (script->source)
        return script;
    diag_print(diag, DIAG_ERROR, span_none(), NULL,
               "can't read the script '%s': %s", path, problem);
    script_free(script);
    return NULL;
}

void script_free(struct script *script)
{
    if (!script)
        return;
    arena_free(script->arena);
    memory_free(script);
}

/* The next line that says something, in words; the last word has all the rest.
 * False at the end. */
static bool script_line(struct script *script)
{
    const char *text = script->source->text;
    script->count = 0;
    while (script->count == 0 && text[script->next]) {
        size_t end = script->next + strcspn(text + script->next, "\n");
        size_t at = script->next + strspn(text + script->next, " \t");
        script->span =
            (struct span){ script->source, (uint32_t)at, (uint32_t)(end - at) };
        while (at < end && text[at] != '#' && script->count < WORDS) {
            size_t length = strcspn(text + at, " \t\r\n");
            bool rest =
                (strcmp(script->words[0], "say") == 0 && script->count == 1) ||
                (strcmp(script->words[0], "append") == 0 && script->count == 2);
            if (rest)
                length = end - at;
            snprintf(script->words[script->count++], WORD, "%.*s", (int)length,
                     text + at);
            at += length;
            at += strspn(text + at, " \t\r");
        }
        script->next = end + (text[end] == '\n');
    }
    for (int i = script->count; i < WORDS; i++)
        script->words[i][0] = '\0';
    return script->count > 0;
}

static bool script_fail(struct script *script, struct diag *diag,
                        const char *what)
{
    diag_print(diag, DIAG_ERROR, script->span, NULL, "%s", what);
    script->failed = true;
    return false;
}

static double script_number(const struct script *script, int word)
{
    return strtod(script->words[word], NULL);
}

/* "shift+ctrl+Left" */
static bool script_key(struct script *script, struct diag *diag)
{
    static const struct {
        const char *name;
        SDL_Keymod mod;
    } mods[] = { { "shift+", KMOD_LSHIFT },
                 { "ctrl+", KMOD_LCTRL },
                 { "alt+", KMOD_LALT } };
    const char *name = script->words[1];
    unsigned mod = 0;
    for (size_t i = 0; i < 3; i++)
        if (strncmp(name, mods[i].name, strlen(mods[i].name)) == 0) {
            mod |= (unsigned)mods[i].mod;
            name += strlen(mods[i].name);
            i = (size_t)-1;
        }
    SDL_Keycode code = SDL_GetKeyFromName(name);
    if (strcmp(name, "?") == 0)
        code = SDLK_QUESTION;
    if (code == SDLK_UNKNOWN)
        return script_fail(script, diag,
                           "there is no such key: type a letter, Return, "
                           "Left, shift+Left, F1");
    int count = script->count > 2 ? (int)script_number(script, 2) : 1;
    for (int i = 0; i < count && i < 10000; i++) {
        SDL_Event event = { .type = SDL_KEYDOWN };
        event.key.keysym.sym = code;
        event.key.keysym.mod = (Uint16)mod;
        SDL_PushEvent(&event);
    }
    return true;
}

static void script_button(Uint32 type, double x, double y, int button)
{
    SDL_Event event = { .type = type };
    event.button.button = (Uint8)button;
    event.button.x = (int)x;
    event.button.y = (int)y;
    SDL_PushEvent(&event);
}

static void script_motion(double x, double y, int button)
{
    SDL_Event event = { .type = SDL_MOUSEMOTION };
    event.motion.x = (int)x;
    event.motion.y = (int)y;
    event.motion.state = button ? SDL_BUTTON(button) : 0;
    SDL_PushEvent(&event);
}

static int script_which(const struct script *script, int word)
{
    return script->count > word ? (int)script_number(script, word)
                                : SDL_BUTTON_LEFT;
}

static void script_click(const struct script *script)
{
    double x = script_number(script, 1), y = script_number(script, 2);
    int button = script_which(script, 3);
    script_motion(x, y, 0);
    script_button(SDL_MOUSEBUTTONDOWN, x, y, button);
    script_button(SDL_MOUSEBUTTONUP, x, y, button);
}

static void script_drag(const struct script *script)
{
    double x = script_number(script, 1), y = script_number(script, 2);
    double u = script_number(script, 3), v = script_number(script, 4);
    int button = script_which(script, 5);
    script_motion(x, y, 0);
    script_button(SDL_MOUSEBUTTONDOWN, x, y, button);
    for (int i = 1; i <= STEPS; i++)
        script_motion(x + (u - x) * i / STEPS, y + (v - y) * i / STEPS, button);
    script_button(SDL_MOUSEBUTTONUP, u, v, button);
}

static void script_wheel(const struct script *script)
{
    SDL_Event event = { .type = SDL_MOUSEWHEEL };
    event.wheel.y = (int)script_number(script, 1);
    SDL_PushEvent(&event);
}

static void script_quit(void)
{
    SDL_Event event = { .type = SDL_QUIT };
    SDL_PushEvent(&event);
}

/* Whether what is waited for is there. */
static bool script_waited(struct script *script,
                          const struct script_state *state, struct diag *diag)
{
    const char *what = script->words[1];
    bool change = strcmp(script->words[0], "change") == 0;
    double waited = clock_seconds() - script->since;
    if (waited > wait_limit) {
        script_fail(script, diag, "waited for 300 s in vain");
        return true;
    }
    if (change)
        return state->idle && state->number != script->number;
    if (strcmp(what, "done") == 0)
        return state->idle && !state->wrong;
    if (strcmp(what, "error") == 0)
        return state->idle && state->wrong;
    if (strcmp(what, "shown") == 0)
        return state->shown > script->did;
    if (strcmp(what, "file") == 0)
        return access(script->words[2], F_OK) == 0;
    return waited >= script_number(script, 1);
}

static void script_did(struct script *script)
{
    script->did = clock_seconds();
    script->worked = clock_worked();
}

static bool script_append(struct script *script, struct diag *diag)
{
    FILE *file = fopen(script->words[1], "a");
    if (!file)
        return script_fail(script, diag, "there is no such file to append to");
    fprintf(file, "%s\n", script->words[2]);
    script_did(script);
    fclose(file);
    return true;
}

/* One line; false if it ends all. */
static bool script_do(struct script *script, struct window *window,
                      const struct script_state *state, struct diag *diag)
{
    const char *word = script->words[0];
    if (strcmp(word, "key") == 0 || strcmp(word, "drag") == 0)
        script_did(script);
    if (strcmp(word, "key") == 0)
        return script_key(script, diag);
    if (strcmp(word, "click") == 0)
        script_click(script);
    else if (strcmp(word, "drag") == 0)
        script_drag(script);
    else if (strcmp(word, "wheel") == 0)
        script_wheel(script);
    else if (strcmp(word, "resize") == 0)
        window_resize(window, (int)script_number(script, 1),
                      (int)script_number(script, 2));
    else if (strcmp(word, "wait") == 0 || strcmp(word, "change") == 0) {
        script->waiting = true;
        script->since = clock_seconds();
        script->number = state->number;
    } else if (strcmp(word, "screenshot") == 0) {
        script->failed = !window_save(window, script->words[1], diag);
        return !script->failed;
    } else if (strcmp(word, "append") == 0) {
        return script_append(script, diag);
    } else if (strcmp(word, "say") == 0) {
        puts(script->words[1]);
        fflush(stdout);
    } else if (strcmp(word, "times") == 0) {
        printf("first %.3f finished %.3f shown %.3f worked %.3f\n",
               state->first, state->finished,
               fmax(0, state->shown - script->did),
               fmax(0, state->worked - script->worked));
        fflush(stdout);
    } else if (strcmp(word, "quit") == 0)
        script_quit();
    else
        return script_fail(script, diag,
                           "a script has lines 'key', 'click', 'drag', "
                           "'wheel', 'resize', 'wait', 'change', "
                           "'append', 'screenshot', 'times', 'say' and "
                           "'quit'");
    return true;
}

bool script_step(struct script *script, struct window *window,
                 const struct script_state *state, struct diag *diag)
{
    if (script->failed)
        return false;
    if (script->waiting && !script_waited(script, state, diag))
        return true;
    script->waiting = false;
    return !script->failed && script_line(script) &&
           script_do(script, window, state, diag);
}

bool script_failed(const struct script *script)
{
    return script->failed;
}
