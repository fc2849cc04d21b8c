/* #debug #render #statistics #warning #error: the scene speaks to its user. */
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

/* POV-Ray 3.7 has these two streams no more. */
static bool debug_run_as(struct parser *p, struct span at)
{
    warning_at(p, at, "#debug", "what this prints goes where '#debug' prints");
    return debug_run(p, at);
}

/* render_directive = "#render" string . */
static bool render_run(struct parser *p, struct span at)
{
    return debug_run_as(p, at);
}

/* statistics_directive = "#statistics" string . */
static bool statistics_run(struct parser *p, struct span at)
{
    return debug_run_as(p, at);
}

/* The length of the text without the ends of lines at its end, which scenes put
 * there for POV-Ray. */
static int message_length(const char *text)
{
    size_t length = strlen(text);
    while (length > 0 && strchr("\r\n", text[length - 1]))
        length--;
    return (int)length;
}

/* warning_directive = "#warning" string . */
static bool warning_run(struct parser *p, struct span at)
{
    const char *text;
    if (!directive_string(p, &text))
        return false;
    warning_at(p, at, NULL, "%.*s", message_length(text), text);
    return true;
}

/* error_directive = "#error" string . */
static bool error_run(struct parser *p, struct span at)
{
    const char *text;
    if (directive_string(p, &text))
        error_at(p, at, NULL, "stopped by '#error': %.*s", message_length(text),
                 text);
    stream_abort(p);
    return false;
}

const struct directive debug_directive = { debug_run, "print a text" };
const struct directive render_directive = { render_run, "the same as #debug" };
const struct directive statistics_directive = { statistics_run,
                                                "the same as #debug" };
const struct directive warning_directive = { warning_run, "print a warning" };
const struct directive error_directive = { error_run,
                                           "print an error and stop" };
