/* Fork, exec and wait: see program.h. */
#include "compare/program.h"

#include <errno.h>
#include <fcntl.h>
#include <limits.h>
#include <signal.h>
#include <stdlib.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/time.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

/* ---- finding ----------------------------------------------------------- */

static bool program_is(const char *path)
{
    struct stat status;
    return stat(path, &status) == 0 && S_ISREG(status.st_mode) &&
           access(path, X_OK) == 0;
}

static const char *program_along_path(const char *name, struct arena *arena)
{
    if (strchr(name, '/'))
        return program_is(name) ? name : NULL;
    const char *path = getenv("PATH");
    while (path && *path) {
        int length = (int)strcspn(path, ":");
        const char *file = arena_printf(arena, "%.*s%s%s", length, path,
                                        length ? "/" : "./", name);
        if (program_is(file))
            return file;
        path += length + (path[length] == ':');
    }
    return NULL;
}

/* `name` where this program is. */
static const char *program_beside(const char *name, struct arena *arena)
{
    char self[PATH_MAX];
    ssize_t length = readlink("/proc/self/exe", self, sizeof self - 1);
    if (length <= 0)
        return NULL;
    self[length] = '\0';
    int directory = (int)(strrchr(self, '/') - self);
    const char *file = arena_printf(arena, "%.*s/%s", directory, self, name);
    return program_is(file) ? file : NULL;
}

const char *program_find(const char *variable, const char *name, bool beside,
                         struct arena *arena)
{
    const char *said = getenv(variable);
    if (said && *said)
        return program_along_path(said, arena);
    const char *file = beside ? program_beside(name, arena) : NULL;
    return file ? file : program_along_path(name, arena);
}

char *program_povray_name(const char *letters, const char *name,
                          struct arena *arena)
{
    const char *quote = strchr(name, '"') ? "'" : "\"";
    return arena_printf(arena, "%s%s%s%s", letters, quote, name, quote);
}

/* ---- running ----------------------------------------------------------- */

static double seconds(struct timeval time)
{
    return (double)time.tv_sec + (double)time.tv_usec * 1e-6;
}

static double now(void)
{
    struct timespec time;
    clock_gettime(CLOCK_MONOTONIC, &time);
    return (double)time.tv_sec + (double)time.tv_nsec * 1e-9;
}

/* In the child: never returns. */
static void program_become(char *const *words, const char *log)
{
    int in = open("/dev/null", O_RDONLY);
    int out = open(log, O_WRONLY | O_CREAT | O_TRUNC, 0600);
    if (in >= 0 && out >= 0) {
        dup2(in, STDIN_FILENO);
        dup2(out, STDOUT_FILENO);
        dup2(out, STDERR_FILENO);
        execv(words[0], words);
        dprintf(STDERR_FILENO, "can't start it: %s\n", strerror(errno));
    }
    _exit(127);
}

/* Waits in short naps: a signal that arrives just before a wait without end
 * would not be seen. */
static enum program_end program_wait(pid_t child, const atomic_int *stop,
                                     struct rusage *usage)
{
    const struct timespec nap = { .tv_nsec = 5000000 };
    bool killed = false;
    for (;;) {
        int status = 0;
        pid_t ended = wait4(child, &status, killed ? 0 : WNOHANG, usage);
        if (ended < 0 && errno != EINTR)
            return PROGRAM_FAILED;
        if (ended == child && killed)
            return PROGRAM_STOPPED;
        if (ended == child)
            return WIFEXITED(status) && WEXITSTATUS(status) == 0
                       ? PROGRAM_DONE
                       : PROGRAM_FAILED;
        if (!killed && atomic_load(stop)) {
            kill(child, SIGKILL);
            killed = true;
        }
        if (!killed)
            nanosleep(&nap, NULL);
    }
}

enum program_end program_run(char *const *words, const char *log,
                             const atomic_int *stop, struct times *times)
{
    double start = now();
    struct rusage usage = { .ru_maxrss = 0 };
    pid_t child = fork();
    if (child < 0)
        return PROGRAM_FAILED;
    if (child == 0)
        program_become(words, log);
    enum program_end end = program_wait(child, stop, &usage);
    times->processor = seconds(usage.ru_utime) + seconds(usage.ru_stime);
    times->wall = now() - start;
    /* A signal to the whole group ends the child first. */
    return atomic_load(stop) ? PROGRAM_STOPPED : end;
}
