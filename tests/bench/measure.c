/* measure LOG COMMAND...: runs it, what it says goes to LOG, and prints
 * "CPU WALL MEMORY": seconds of processor (user + system), seconds passed,
 * megabytes at most. Ends with the command's status. A fresh machine may lack
 * GNU time, hence this. */
#include <fcntl.h>
#include <stdio.h>
#include <sys/resource.h>
#include <sys/time.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

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

static void command_run(char **argv)
{
    int nothing = open("/dev/null", O_RDONLY);
    int log = open(argv[1], O_WRONLY | O_CREAT | O_TRUNC, 0666);
    if (log < 0) {
        perror(argv[1]);
        _exit(126);
    }
    dup2(nothing, 0);
    dup2(log, 1);
    dup2(log, 2);
    execvp(argv[2], argv + 2);
    perror(argv[2]);
    _exit(127);
}

int main(int argc, char **argv)
{
    int status = 0;
    struct rusage usage;
    double start = now();
    pid_t child = argc > 2 ? fork() : -1;
    if (child == 0)
        command_run(argv);
    if (child < 0 || wait4(child, &status, 0, &usage) != child)
        return 126;
    printf("%.4f %.4f %.0f\n",
           seconds(usage.ru_utime) + seconds(usage.ru_stime), now() - start,
           (double)usage.ru_maxrss / 1024);
    return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}
