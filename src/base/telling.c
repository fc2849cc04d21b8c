/* Lines of --debug-pixel: see telling.h. */
#include "base/telling.h"

#include <stdarg.h>

static void telling_line(struct telling *telling, const char *format,
                         va_list arguments)
{
    if (!telling->out)
        return;
    fprintf(telling->out, "%*s", 2 * telling->depth, "");
    vfprintf(telling->out, format, arguments);
    fputc('\n', telling->out);
}

void telling_say(struct telling *telling, const char *format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    telling_line(telling, format, arguments);
    va_end(arguments);
}

void telling_answer(struct telling *telling, const char *name,
                    const char *format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    telling_line(telling, format, arguments);
    va_end(arguments);
    if (!telling->answer)
        telling->answer = name;
}
