/* inotify on the directories of files, since editors write new files and rename
 * them: see follow.h. */
#include "view/follow.h"

#include <string.h>
#include <sys/inotify.h>
#include <unistd.h>

#include "base/clock.h"
#include "base/memory.h"

enum { EVENTS = 4096 }; /* bytes of them read at a time */

/* Seconds until all files are looked at unasked. */
static const double follow_pause = 0.5;

struct follow {
    int events; /* of inotify; -1: none to be had */
    struct file_list files;
    double next; /* when to look unasked */
};

struct follow *follow_new(void)
{
    struct follow *follow = memory_new(sizeof *follow);
    follow->events = inotify_init1(IN_NONBLOCK | IN_CLOEXEC);
    return follow;
}

void follow_free(struct follow *follow)
{
    if (follow->events >= 0)
        close(follow->events);
    if (follow->files.arena)
        arena_free(follow->files.arena);
    memory_free(follow);
}

/* A directory that is watched already stays so. */
static void follow_directory(const struct follow *follow, const char *path)
{
    const char *slash = strrchr(path, '/');
    size_t length = slash ? (size_t)(slash - path) : 0;
    const char *directory =
        !slash   ? "."
        : length ? arena_copy_text(follow->files.arena, path, length)
                 : "/";
    inotify_add_watch(follow->events, directory,
                      IN_CLOSE_WRITE | IN_MOVED_TO | IN_MOVED_FROM | IN_DELETE |
                          IN_ATTRIB);
}

void follow_files(struct follow *follow, struct file_list files)
{
    if (follow->files.arena)
        arena_free(follow->files.arena);
    follow->files = files;
    follow->next = 0;
    for (size_t i = 0; follow->events >= 0 && i < files.count; i++)
        follow_directory(follow, file_list_path(&files, i));
}

/* Whether anything was told. */
static bool follow_told(const struct follow *follow)
{
    char events[EVENTS];
    bool told = false;
    while (follow->events >= 0 &&
           read(follow->events, events, sizeof events) > 0)
        told = true;
    return told;
}

bool follow_changed(struct follow *follow)
{
    double now = clock_seconds();
    if (!follow->files.arena || (!follow_told(follow) && now < follow->next))
        return false;
    follow->next = now + follow_pause;
    if (!file_list_changed(&follow->files))
        return false;
    struct file_list files = { .arena = arena_new(0) };
    for (size_t i = 0; i < follow->files.count; i++)
        file_list_add(&files, file_list_path(&follow->files, i));
    follow_files(follow, files);
    follow->next = now + follow_pause;
    return true;
}
