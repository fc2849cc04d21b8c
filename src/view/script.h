/* --view-script: keys, clicks, waits and pictures of the window, from a file.
 * A line each; '#' begins a comment:
 *
 *     key NAME [COUNT]          as of a keyboard: a, shift+Left, Return
 *     click X Y [BUTTON]        pixels of the window
 *     drag X Y X2 Y2 [BUTTON]
 *     wheel STEPS
 *     resize WIDTH HEIGHT
 *     append FILE TEXT          a line more, as of an editor that saves
 *     wait done | error | shown | SECONDS | file NAME
 *     change                    wait for another picture than this
 *     screenshot FILE
 *     times                     on standard output: seconds
 *     say TEXT                  on standard output
 *     quit
 */
#ifndef VIEW_SCRIPT_H
#define VIEW_SCRIPT_H

#include "text/diag.h"
#include "view/window.h"

struct script;

/* What the window is doing. */
struct script_state {
    bool idle;              /* nothing is being drawn or waited for */
    bool wrong;             /* the text is wrong */
    unsigned number;        /* counts pictures that were finished or failed */
    double first, finished; /* seconds, of the last one */
    double shown;  /* clock_seconds when the window first showed something of
                    * what was wished for last; 0: not yet */
    double worked; /* clock_worked, then */
};

/* NULL after an error was printed: a file that can't be read, or a wrong line.
 */
struct script *script_read(const char *path, struct diag *diag);
void script_free(struct script *script);

/* What the next line does, as events of SDL; called now and then, it waits as
 * the lines say. False at the end, or after an error was printed. */
bool script_step(struct script *script, struct window *window,
                 const struct script_state *state, struct diag *diag);

/* Whether it ended by an error. */
bool script_failed(const struct script *script);

#endif
