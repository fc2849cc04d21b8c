/*
 * Runs a command, and counts how many threads of a program that it starts run,
 * or want to, at the same time.
 *
 *   runnable NAME LIMIT COMMAND...
 *
 * Prints "MOST OVER LOOKS": the most threads at one time, how often there were
 * more than LIMIT, and how often it was looked. The exit status is the
 * command's.
 *
 * A look takes time, in which one thread ends and another begins, so each
 * thread is looked at twice: those count that were runnable both times and have
 * not waited in between (the kernel counts that, proc(5)). All of these ran, or
 * wanted to, when the first round was over: none is counted that was not there
 * together with the others.
 */
#include <dirent.h>
#include <signal.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

enum { THREADS_MOST = 4096, STATUS_SIZE = 4096, PATH_SIZE = 64 };

struct thread {
    char status[PATH_SIZE]; /* the file */
    long waits;             /* voluntary switches until the first look */
};

/* The text of a file of /proc; false if its process has ended. */
static bool text_of(const char *path, char text[STATUS_SIZE])
{
    FILE *file = fopen(path, "r");
    if (!file)
        return false;
    size_t count = fread(text, 1, STATUS_SIZE - 1, file);
    text[count] = '\0';
    fclose(file);
    return count > 0;
}

/* How often the thread has waited; -1: it is not runnable. */
static long thread_waits(const char *status)
{
    static const char waits[] = "\nvoluntary_ctxt_switches:";
    char text[STATUS_SIZE];
    if (!text_of(status, text) || !strstr(text, "\nState:\tR"))
        return -1;
    const char *at = strstr(text, waits);
    return at ? atol(at + sizeof waits - 1) : -1;
}

/* Whether it is a process of that name in our session. */
static bool process_counts(const char *id, const char *name)
{
    char path[PATH_SIZE], text[STATUS_SIZE], *end;
    int session;
    snprintf(path, sizeof path, "/proc/%.16s/stat", id);
    if (!text_of(path, text) || !strchr(text, '(') ||
        !(end = strrchr(text, ')')))
        return false;
    *end = '\0';
    return strcmp(strchr(text, '(') + 1, name) == 0 &&
           sscanf(end + 2, "%*c %*d %*d %d", &session) == 1 &&
           session == getsid(0);
}

static size_t threads_add(struct thread *threads, size_t count, const char *id)
{
    char path[PATH_SIZE];
    snprintf(path, sizeof path, "/proc/%.16s/task", id);
    DIR *tasks = opendir(path);
    struct dirent *entry;
    while (tasks && count < THREADS_MOST && (entry = readdir(tasks)) != NULL) {
        struct thread *thread = &threads[count];
        if (*entry->d_name == '.')
            continue;
        snprintf(thread->status, sizeof thread->status,
                 "/proc/%.16s/task/%.16s/status", id, entry->d_name);
        thread->waits = thread_waits(thread->status);
        count += thread->waits >= 0;
    }
    if (tasks)
        closedir(tasks);
    return count;
}

static size_t look(const char *name)
{
    static struct thread threads[THREADS_MOST];
    size_t count = 0, together = 0;
    DIR *processes = opendir("/proc");
    struct dirent *entry;
    while (processes && (entry = readdir(processes)) != NULL)
        if (*entry->d_name >= '1' && *entry->d_name <= '9' &&
            process_counts(entry->d_name, name))
            count = threads_add(threads, count, entry->d_name);
    if (processes)
        closedir(processes);
    for (size_t i = 0; i < count; i++)
        together += thread_waits(threads[i].status) == threads[i].waits;
    return together;
}

int main(int argc, char **argv)
{
    size_t most = 0, over = 0, looks = 0;
    int status;
    if (argc < 4)
        return 126;
    size_t limit = strtoul(argv[2], NULL, 10);
    setsid(); /* fails where it is not needed: at the head of a session */
    pid_t child = fork();
    if (child == 0) {
        prctl(PR_SET_PDEATHSIG, SIGTERM); /* make then ends what it began */
        execvp(argv[3], argv + 3);
        _exit(127);
    }
    setpriority(PRIO_PROCESS, 0, -20); /* where it is allowed: quicker looks */
    while (child > 0 && waitpid(child, &status, WNOHANG) == 0) {
        size_t now = look(argv[1]);
        looks++;
        over += now > limit;
        most = now > most ? now : most;
        usleep(10000);
    }
    printf("%zu %zu %zu\n", most, over, looks);
    return child > 0 && WIFEXITED(status) ? WEXITSTATUS(status) : 126;
}
