/* +C and --check-picture: see kept.h. */
#include "cli/kept.h"

#include <errno.h>
#include <stdio.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "cli/build.h"
#include "cli/origin.h"
#include "image/note.h"

enum { WHY_SIZE = 600 };

static bool file_is_newer(const char *name, const char *than)
{
    struct stat a, b;
    if (stat(name, &a) != 0 || stat(than, &b) != 0)
        return false;
    return a.st_mtim.tv_sec != b.st_mtim.tv_sec
               ? a.st_mtim.tv_sec > b.st_mtim.tv_sec
               : a.st_mtim.tv_nsec > b.st_mtim.tv_nsec;
}

/* One warning is enough for all frames. */
static void kept_tell_newer(struct kept *kept, const struct options *options,
                            const char *name, struct diag *diag)
{
    if (!kept->told && file_is_newer(options->path, name)) {
        diag_print(diag, DIAG_WARNING, span_none(), NULL,
                   "'%s' is kept, though '%s' has changed since; without +C "
                   "it is rendered again",
                   name, options->path);
        kept->told = true;
    }
}

static void kept_add(void *context, const char *path, bool there)
{
    (void)there;
    file_list_add(context, path);
}

static bool kept_carries_origin(const struct options *options)
{
    return options->file_type == 'N' || options->file_type == 'E';
}

/* Whether it is current; else the reason. */
static bool kept_current(struct kept *kept, const char *name,
                         const char *settings, char *why, size_t size)
{
    struct arena *arena = arena_new(0);
    const char *made = image_note_read(arena, name);
    bool current = false;
    if (!made)
        snprintf(why, size, "it does not say what it was drawn of");
    else
        current = origin_same_settings(made, settings, why, size) &&
                  origin_same_files(made, kept->seen, why, size);
    if (current)
        origin_each_file(made, kept_add, kept->asked);
    arena_free(arena);
    return current;
}

static bool kept_right(struct kept *kept, const struct options *options,
                       const char *name, const char *settings,
                       char why[WHY_SIZE], struct diag *diag)
{
    int width, height;
    if (!image_probe(name, &width, &height, why, WHY_SIZE))
        return false;
    if (width != options->render.width || height != options->render.height) {
        snprintf(why, WHY_SIZE, "it has %d x %d pixels", width, height);
        return false;
    }
    if (kept_carries_origin(options))
        return kept_current(kept, name, settings, why, WHY_SIZE);
    kept_tell_newer(kept, options, name, diag);
    return true;
}

bool kept_picture(struct kept *kept, const struct options *options,
                  const char *name, const char *settings, struct diag *diag)
{
    char why[WHY_SIZE];
    if (!name || strcmp(name, "-") == 0 || access(name, F_OK) != 0)
        return false;
    if (kept_right(kept, options, name, settings, why, diag))
        return true;
    diag_print(diag, DIAG_WARNING, span_none(), NULL,
               "'%s' is rendered again: %s", name, why);
    return false;
}

static bool check_told(const char *name, const char *made)
{
    char scene[300], frame[64], why[WHY_SIZE];
    struct arena *arena = arena_new(0);
    struct file_list seen = { .arena = arena };
    int width, height;
    bool whole = image_probe(name, &width, &height, why, sizeof why);
    if (!origin_value(made, "scene", scene, sizeof scene))
        snprintf(scene, sizeof scene, "?");
    bool framed = origin_value(made, "frame", frame, sizeof frame);
    printf("%s: of %s%s%s: ", name, strcmp(scene, "-") ? scene : "a text",
           framed ? ", frame " : "", framed ? frame : "");
    bool current = false;
    if (!whole)
        printf("not whole: %s\n", why);
    else if (origin_value(made, ORIGIN_UNFINISHED, why, sizeof why))
        printf("not whole: the work on it was ended\n");
    else if (!origin_value(made, "glim", frame, sizeof frame) ||
             strcmp(frame, GLIM_VERSION) != 0)
        printf("%d x %d, whole, not current: glim %s drew it, and this is "
               "glim %s\n",
               width, height, frame, GLIM_VERSION);
    else if (!origin_value(made, "build", frame, sizeof frame) ||
             strcmp(frame, build_id) != 0)
        printf("%d x %d, whole, not current: another build of glim %s drew "
               "it\n",
               width, height, GLIM_VERSION);
    else if (!origin_same_files(made, &seen, why, sizeof why))
        printf("%d x %d, whole, not current: %s\n", width, height, why);
    else
        current = true;
    if (current)
        printf("%d x %d, whole, current\n", width, height);
    arena_free(arena);
    return current;
}

bool kept_check(const char *name, struct diag *diag)
{
    struct arena *arena = arena_new(0);
    const char *made = image_note_read(arena, name);
    bool good = false;
    if (made)
        good = check_told(name, made);
    else if (access(name, R_OK) != 0)
        diag_print(diag, DIAG_ERROR, span_none(), NULL, "can't read '%s': %s",
                   name, strerror(errno));
    else
        diag_print(diag, DIAG_ERROR, span_none(), NULL,
                   "'%s' does not say what it is of: only PNG and OpenEXR "
                   "files that glim wrote do",
                   name);
    arena_free(arena);
    return good;
}
