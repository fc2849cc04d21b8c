/* #debug #warning #error: the scene speaks to its user. */
#include "parse/directive.h"

/* debug_directive = "#debug" string . */
static bool debug_run(struct parser *p, struct span at)
{
    const char *text;
    if (!directive_string(p, &text))
        return false;
    diag_print(p->diag, DIAG_MESSAGE, at, NULL, "%s", text);
    return true;
}

/* warning_directive = "#warning" string . */
static bool warning_run(struct parser *p, struct span at)
{
    const char *text;
    if (!directive_string(p, &text))
        return false;
    warning_at(p, at, NULL, "%s", text);
    return true;
}

/* error_directive = "#error" string . */
static bool error_run(struct parser *p, struct span at)
{
    const char *text;
    if (directive_string(p, &text))
        error_at(p, at, NULL, "stopped by '#error': %s", text);
    stream_abort(p);
    return false;
}

const struct directive debug_directive = { debug_run, "print a text" };
const struct directive warning_directive = { warning_run, "print a warning" };
const struct directive error_directive = { error_run,
                                           "print an error and stop" };
