/* The client: see jobserver.h. Tokens are read without blocking, which must not
 * be set for make's own end of the pipe, so it is opened anew. */
#include "base/jobserver.h"

#include <errno.h>
#include <fcntl.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "base/parallel.h"

/* Written once, by whoever asks first. */
static struct {
    struct once once;
    enum jobserver state;
    int in, out; /* the pipe's ends */
} server;

static bool is_pipe(int file)
{
    struct stat status;
    return file >= 0 && fstat(file, &status) == 0 && S_ISFIFO(status.st_mode);
}

static bool server_open(int in, int out)
{
    if (!is_pipe(in) || !is_pipe(out))
        return false;
    server.in = in;
    server.out = out;
    return true;
}

/* "fifo:PATH", of make 4.4 and later */
static bool server_named(const char *path)
{
    char name[4096];
    size_t length = strcspn(path, " ");
    if (length >= sizeof name)
        return false;
    memcpy(name, path, length);
    name[length] = '\0';
    int file = open(name, O_RDWR | O_NONBLOCK | O_CLOEXEC);
    return server_open(file, file);
}

/* "R,W": files that make left open */
static bool server_numbered(const char *text)
{
    int in, out;
    char name[64];
    if (sscanf(text, "%d,%d", &in, &out) != 2 || !is_pipe(in) || !is_pipe(out))
        return false;
    snprintf(name, sizeof name, "/proc/self/fd/%d", in);
    return server_open(open(name, O_RDONLY | O_NONBLOCK | O_CLOEXEC), out);
}

/* The value of the last such option: a make within another adds its own. */
static const char *flags_value(const char *flags, const char *option)
{
    const char *value = NULL;
    for (const char *at = strstr(flags, option); at; at = strstr(at, option)) {
        at += strlen(option);
        value = at;
    }
    return value;
}

static void server_find(void)
{
    const char *flags = getenv("MAKEFLAGS");
    const char *value = flags ? flags_value(flags, "--jobserver-auth=") : NULL;
    if (flags && !value)
        value = flags_value(flags, "--jobserver-fds="); /* before make 4.2 */
    if (!value)
        return;
    bool open = strncmp(value, "fifo:", 5) == 0 ? server_named(value + 5)
                                                : server_numbered(value);
    server.state = open ? JOBSERVER_OPEN : JOBSERVER_CLOSED;
}

enum jobserver jobserver_state(void)
{
    once_only(&server.once, server_find);
    return server.state;
}

bool jobserver_take(char *token)
{
    return jobserver_state() == JOBSERVER_OPEN &&
           read(server.in, token, 1) == 1;
}

void jobserver_give(char token)
{
    while (write(server.out, &token, 1) < 0 && errno == EINTR)
        continue;
}
