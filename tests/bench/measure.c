/* measure COMMAND...: runs it quietly and prints "CPU WALL MEMORY": seconds of
 * processor (user + system), seconds passed, megabytes at most. Ends with the
 * command's status. A fresh machine may lack GNU time, hence this. */
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

int main(int argc, char **argv)
{
    int status = 0;
    struct rusage usage;
    double start = now();
    pid_t child = argc > 1 ? fork() : -1;
    if (child == 0) {
        int nothing = open("/dev/null", O_RDWR);
        for (int stream = 0; stream < 3; stream++)
            dup2(nothing, stream);
        execvp(argv[1], argv + 1);
        _exit(127);
    }
    if (child < 0 || wait4(child, &status, 0, &usage) != child)
        return 126;
    printf("%.4f %.4f %.0f\n",
           seconds(usage.ru_utime) + seconds(usage.ru_stime), now() - start,
           (double)usage.ru_maxrss / 1024);
    return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}
