/* speak PROGRAM [ARGUMENT ...]: speaks the Language Server Protocol with a
 * program as standard input says, line by line, and prints what it answers, one
 * message a line:
 *   {...}    is framed and sent; has it an "id", its answer is waited for
 *   &{...}   is sent, and nothing waited for
 *   =TEXT    is sent as it is, but for \r, \n
 *   ?TEXT    waits for a message that has the text
 *   ~COUNT SEED URI   sends random edits of the text, and questions about it;
 *            waits for the answer to the last
 *   %NAME    prints "%NAME SECONDS" since the line before it of this kind
 *   .        closes the input
 * At the end "exit STATUS". Status 1 if what was waited for didn't come. */
#include <poll.h>
#include <signal.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

enum { PATIENCE = 10000 }; /* milliseconds, for one message */

struct speaker {
    int to, from;
    char *bytes;
    size_t count, capacity;
};

static void put(const struct speaker *s, const char *text, size_t length)
{
    while (length > 0) {
        ssize_t done = write(s->to, text, length);
        if (done <= 0)
            return;
        text += done;
        length -= (size_t)done;
    }
}

static void put_message(const struct speaker *s, const char *text)
{
    char header[64];
    int size = snprintf(header, sizeof header, "Content-Length: %zu\r\n\r\n",
                        strlen(text));
    put(s, header, (size_t)size);
    put(s, text, strlen(text));
}

static void put_raw(const struct speaker *s, const char *text)
{
    for (; *text; text++) {
        bool escape = *text == '\\' && (text[1] == 'r' || text[1] == 'n');
        char byte = escape ? (text[1] == 'r' ? '\r' : '\n') : *text;
        put(s, &byte, 1);
        text += escape;
    }
}

static bool more(struct speaker *s)
{
    struct pollfd file = { .fd = s->from, .events = POLLIN };
    if (s->capacity - s->count < 65536)
        s->bytes = realloc(s->bytes, s->capacity = 2 * s->capacity + 65536);
    if (poll(&file, 1, PATIENCE) <= 0)
        return false;
    ssize_t got =
        read(s->from, s->bytes + s->count, s->capacity - s->count - 1);
    s->count += got > 0 ? (size_t)got : 0;
    s->bytes[s->count] = '\0';
    return got > 0;
}

/* The next message, the caller's to free; NULL: there is none. */
static char *take(struct speaker *s)
{
    for (;;) {
        size_t length = 0;
        char *body = s->count ? strstr(s->bytes, "\r\n\r\n") : NULL;
        if (body && sscanf(s->bytes, "Content-Length: %zu", &length) == 1 &&
            s->count >= (size_t)(body + 4 - s->bytes) + length) {
            char *text = strndup(body + 4, length);
            size_t size = (size_t)(body + 4 - s->bytes) + length;
            s->count -= size;
            memmove(s->bytes, s->bytes + size, s->count + 1);
            return text;
        }
        if (!more(s))
            return NULL;
    }
}

/* Prints messages up to the one with all of `text`. */
static bool await(struct speaker *s, const char *text, bool answer)
{
    for (;;) {
        char *message = take(s);
        if (!message) {
            printf("NOTHING with %s\n", text);
            return false;
        }
        bool has = strstr(message, text) != NULL &&
                   !(answer && strstr(message, "\"method\":"));
        printf("%s\n", message);
        free(message);
        if (has)
            return true;
    }
}

/* The "id" of a request with what follows it, for which its answer is told. */
static bool await_answer(struct speaker *s, const char *request)
{
    char id[80];
    const char *at = strstr(request, "\"id\":");
    if (!at || !strstr(request, "\"method\":"))
        return true;
    size_t length = 5 + strcspn(at + 5, ",}");
    snprintf(id, sizeof id, "%.*s", (int)length, at);
    return await(s, id, true);
}

/* A range at random, often beyond the text and the wrong way round. */
static void random_range(char *text, size_t size)
{
    int line = rand() % 120 - 2, unit = rand() % 90 - 2;
    snprintf(text, size,
             "{\"start\":{\"line\":%d,\"character\":%d},\"end\":{\"line\":%d,"
             "\"character\":%d}}",
             line, unit, line + rand() % 3 - (rand() % 50 == 0) * 9,
             unit + rand() % 5);
}

static void random_edit(const struct speaker *s, const char *uri)
{
    static const char *const pieces[] = {
        "",           "{",
        "}",          "<",
        ">",          "(",
        ")",          "#",
        "#if (",      "#end\\n",
        "#else ",     "#macro M(a) ",
        "\\\"",       "/*",
        "*/",         "//",
        "\\n",        "\\r",
        "\\u00e4",    "\\ud83c\\udf88",
        "sphere {",   "rgb <1,0,0>",
        "#declare A", " = 1;\\n",
        "\\u0000",    "#include \\\"",
        "1e9",        "#while (1) ",
    };
    char range[200], message[1024];
    random_range(range, sizeof range);
    snprintf(message, sizeof message,
             "{\"jsonrpc\":\"2.0\",\"method\":\"textDocument/didChange\","
             "\"params\":{\"textDocument\":{\"uri\":\"%s\"},"
             "\"contentChanges\":[{\"range\":%s,\"text\":\"%s\"}]}}",
             uri, range,
             pieces[(size_t)rand() % (sizeof pieces / sizeof *pieces)]);
    put_message(s, message);
}

static bool random_question(struct speaker *s, const char *uri)
{
    static int id = 1000000;
    static const char *const names[] = {
        "completion", "hover",         "signatureHelp",     "definition",
        "references", "rename",        "documentSymbol",    "foldingRange",
        "codeAction", "documentColor", "colorPresentation", "formatting",
    };
    char range[200], message[1024];
    random_range(range, sizeof range);
    snprintf(message, sizeof message,
             "{\"jsonrpc\":\"2.0\",\"id\":%d,\"method\":\"textDocument/%s\","
             "\"params\":{\"textDocument\":{\"uri\":\"%s\"},\"position\":"
             "{\"line\":%d,\"character\":%d},\"newName\":\"Other\","
             "\"range\":%s}}",
             ++id, names[(size_t)rand() % (sizeof names / sizeof *names)], uri,
             rand() % 100, rand() % 60, range);
    put_message(s, message);
    return await_answer(s, message);
}

static bool speak_at_random(struct speaker *s, const char *line)
{
    char uri[400];
    int count;
    unsigned seed;
    if (sscanf(line, "%d %u %399s", &count, &seed, uri) != 3)
        return false;
    srand(seed);
    bool good = true;
    for (; good && count > 0; count--) {
        random_edit(s, uri);
        if (rand() % 2 == 0)
            good = random_question(s, uri);
    }
    if (!good)
        printf("at seed %u, %d edits before the end\n", seed, count);
    return good;
}

static void print_lap(const char *name)
{
    static struct timespec last;
    struct timespec now;
    clock_gettime(CLOCK_MONOTONIC, &now);
    double seconds = (double)(now.tv_sec - last.tv_sec) +
                     (double)(now.tv_nsec - last.tv_nsec) * 1e-9;
    printf("%%%s %.4f\n", name, seconds);
    last = now;
}

static bool speak(struct speaker *s, char *line)
{
    line[strcspn(line, "\n")] = '\0';
    switch (*line) {
    case '{':
        put_message(s, line);
        return await_answer(s, line);
    case '&':
        put_message(s, line + 1);
        return true;
    case '=':
        put_raw(s, line + 1);
        return true;
    case '%':
        print_lap(line + 1);
        return true;
    case '~':
        return speak_at_random(s, line + 1);
    case '?':
        return await(s, line + 1, false);
    default:
        return true;
    }
}

int main(int argc, char **argv)
{
    int to[2], from[2], status = 0;
    struct speaker s = { 0 };
    if (argc < 2 || pipe(to) || pipe(from))
        return 2;
    signal(SIGPIPE, SIG_IGN);
    pid_t child = fork();
    if (child == 0) {
        dup2(to[0], 0);
        dup2(from[1], 1);
        close(to[1]);
        close(from[0]);
        execv(argv[1], argv + 1);
        _exit(127);
    }
    close(to[0]);
    close(from[1]);
    s.to = to[1];
    s.from = from[0];
    char *line = NULL;
    size_t size = 0;
    bool good = true;
    while (good && getline(&line, &size, stdin) > 0 && *line != '.')
        good = speak(&s, line);
    close(s.to);
    for (char *message; good && (message = take(&s)) != NULL; free(message))
        printf("%s\n", message);
    if (!good)
        kill(child, SIGKILL);
    waitpid(child, &status, 0);
    printf("exit %d\n", WIFEXITED(status) ? WEXITSTATUS(status) : -1);
    free(line);
    free(s.bytes);
    return good ? 0 : 1;
}
