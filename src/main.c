/* glim: the command line, once or as often as --watch says. */
#include <sys/resource.h>

#include "base/memory.h"
#include "base/parallel.h"
#include "cli/interrupt.h"
#include "cli/moments.h"
#include "cli/watch.h"
#include "cli/work.h"

/* Bytes of the first thread's stack that the system takes for the command line
 * and the environment. */
enum { ARGUMENTS_MOST = 6 << 20 };

/* The command line, and all that it does. */
struct command {
    int argc;
    char **argv;
    enum work_status status;
    bool told; /* what --watch waits for */
};

/* Says once that it goes on; returns whether it does. */
static bool command_watch(struct command *command, struct work *work)
{
    struct file_list *files = work->options.parse.asked;
    if (!work->options.watch || command->status == WORK_INTERRUPTED)
        return false;
    if (!command->told && work->options.warnings)
        diag_print(&work->diag, DIAG_NOTE, span_none(), NULL,
                   "watching %zu file%s; Ctrl-C ends", files->count,
                   files->count == 1 ? "" : "s");
    command->told = true;
    return watch_wait(files, work->stop);
}

/* Returns true for once more. Wrong options are waited for only if an INI file
 * was right before. */
static bool command_once(struct command *command)
{
    struct arena *arena = arena_new(0);
    struct file_list files = { .arena = arena }, seen = { .arena = arena };
    struct work work = { .options.parse.asked = &files,
                         .pictures = { .seen = &seen, .asked = &files },
                         .arena = arena,
                         .diag = diag_new(),
                         .stop = interrupt_catch() };
    bool again = command->told;
    command->status = WORK_FAILED;
    if (options_parse(&work.options, command->argc, command->argv, arena,
                      &work.diag)) {
        bool answers = options_answers(&work.options);
        if (!answers)
            command->status = (work.options.join ? work_join : work_run)(&work);
        else if (work.options.action == ACTION_CHECK_PICTURE
                     ? kept_check(work.options.picture, &work.diag)
                 : work.options.action == ACTION_JOIN
                     ? part_join(work.options.picture, &work.diag)
                     : options_answer(&work.options, &work.diag))
            command->status = WORK_DONE;
        again = !answers;
    }
    lighting_forget(&work.kept);
    lighting_forget(&work.last);
    moments_forget(&work);
    again = again && command_watch(command, &work);
    arena_free(arena);
    return again;
}

static void command_run(void *context)
{
    while (command_once(context))
        continue;
}

/* Lets this thread's stack grow as large as those of others, if the system
 * does: one that only waited for another would want to run now and then, and
 * make gave no token for it (base/jobserver.h). Where memory has a limit
 * nothing keeps room for it to grow. */
static bool stack_grows(void)
{
    struct rlimit limit;
    const rlim_t wanted = PARALLEL_STACK + ARGUMENTS_MOST;
    if ((getrlimit(RLIMIT_AS, &limit) == 0 &&
         limit.rlim_cur != RLIM_INFINITY) ||
        getrlimit(RLIMIT_STACK, &limit) != 0)
        return false;
    if (limit.rlim_cur != RLIM_INFINITY && limit.rlim_cur < wanted)
        limit.rlim_cur = wanted;
    return setrlimit(RLIMIT_STACK, &limit) == 0;
}

/* Nested scenes and mirrors that face each other need stack, so all is done on
 * one of known size. */
int main(int argc, char **argv)
{
    struct command command = { .argc = argc, .argv = argv };
    struct diag diag = diag_new();
    if (stack_grows()) {
        command_run(&command);
    } else if (!parallel_call(command_run, &command)) {
        diag_print(&diag, DIAG_ERROR, span_none(), NULL,
                   "the system gives no thread with a stack of %d MiB",
                   PARALLEL_STACK >> 20);
        return WORK_FAILED;
    }
    return (int)command.status;
}
