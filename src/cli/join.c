/* --join: one picture of the parts that several processes have drawn. See
 * part.h. */
#include <dirent.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/array.h"
#include "base/memory.h"
#include "base/parallel.h"
#include "cli/origin.h"
#include "cli/output_name.h"
#include "cli/part_image.h"

enum { WHY_SIZE = 600, NAMED_MOST = 20 };

static const char ending[] = ".glim-part";

struct joining {
    struct diag *diag;
    struct arena *arena;
    const char *picture;
    size_t stem; /* of the picture's name */
    struct {
        const char **items;
        size_t count, capacity;
    } names;
    struct part_file **files;
    unsigned char *known; /* a bit for each pixel */
    int width, height;
};

__attribute__((format(printf, 2, 3))) static bool
join_fail(const struct joining *joining, const char *format, ...)
{
    char text[1200];
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(text, sizeof text, format, arguments);
    va_end(arguments);
    diag_print(joining->diag, DIAG_ERROR, span_none(), NULL, "%s", text);
    return false;
}

static int name_order(const void *a, const void *b)
{
    return strcmp(*(const char *const *)a, *(const char *const *)b);
}

/* NAME.*.glim-part */
static bool name_is_part(const char *name, const char *stem, size_t length)
{
    size_t all = strlen(name), tail = sizeof ending - 1;
    return all > length + tail && strncmp(name, stem, length) == 0 &&
           name[length] == '.' && strcmp(name + all - tail, ending) == 0;
}

static void join_find(struct joining *joining)
{
    const char *slash = strrchr(joining->picture, '/');
    size_t folder = slash ? (size_t)(slash - joining->picture) + 1 : 0;
    const char *place =
        folder ? arena_copy_text(joining->arena, joining->picture, folder)
               : "./";
    DIR *directory = opendir(place);
    struct dirent *entry;
    while (directory && (entry = readdir(directory)) != NULL)
        if (name_is_part(entry->d_name, joining->picture + folder,
                         joining->stem - folder))
            *ARRAY_PUSH(joining->arena, &joining->names) = arena_printf(
                joining->arena, "%s%s", folder ? place : "", entry->d_name);
    if (directory)
        closedir(directory);
    if (joining->names.count)
        qsort(joining->names.items, joining->names.count,
              sizeof *joining->names.items, name_order);
}

static bool join_same(const struct joining *joining, size_t i)
{
    char why[WHY_SIZE] = "it was drawn of other files, or another glim's";
    const char *first = part_file_text(joining->files[0]);
    const char *this = part_file_text(joining->files[i]);
    if (strcmp(first, this) == 0 &&
        part_file_width(joining->files[i]) == joining->width &&
        part_file_height(joining->files[i]) == joining->height)
        return true;
    origin_same_settings(this, first, why, sizeof why);
    return join_fail(joining, "'%s' is not of the same picture as '%s': %s",
                     joining->names.items[i], joining->names.items[0], why);
}

static bool join_open(struct joining *joining)
{
    char why[WHY_SIZE];
    size_t count = joining->names.count;
    if (count == 0)
        return join_fail(
            joining, "there is no part of '%s': looked for %.*s.*%s",
            joining->picture, (int)joining->stem, joining->picture, ending);
    joining->files = memory_new(count * sizeof(void *));
    for (size_t i = 0; i < count; i++) {
        joining->files[i] =
            part_file_open(joining->names.items[i], why, sizeof why);
        if (!joining->files[i])
            return join_fail(joining, "can't take '%s': %s",
                             joining->names.items[i],
                             *why ? why : "it is still being drawn");
        if (i == 0) {
            joining->width = part_file_width(joining->files[0]);
            joining->height = part_file_height(joining->files[0]);
        }
        if (!join_same(joining, i))
            return false;
    }
    return true;
}

static size_t bit_of(const struct joining *joining, int x, int y)
{
    return (size_t)y * (size_t)joining->width + (size_t)x;
}

static bool join_knows(const struct joining *joining, int x, int y)
{
    size_t bit = bit_of(joining, x, y);
    return joining->known[bit / 8] >> bit % 8 & 1;
}

static void join_note(void *context, struct area area, const void *values)
{
    struct joining *joining = context;
    (void)values;
    for (int y = area.top < 0 ? 0 : area.top;
         y < area.bottom && y < joining->height; y++)
        for (int x = area.left < 0 ? 0 : area.left;
             x < area.right && x < joining->width; x++) {
            size_t bit = bit_of(joining, x, y);
            joining->known[bit / 8] |= (unsigned char)(1 << bit % 8);
        }
}

/* "3of16" in the file's name; false: it is a strip. */
static bool name_share(const struct joining *joining, size_t i,
                       struct share *share)
{
    const char *text = joining->names.items[i] + joining->stem + 1;
    int read = 0;
    return sscanf(text, "%dof%d%n", &share->number, &share->count, &read) ==
               2 &&
           strcmp(text + read, ending) == 0 && share->number >= 1 &&
           share->count >= share->number && share->count <= SHARE_LIMIT;
}

/* One of how many parts. */
struct share_state {
    bool there;
    size_t lacks; /* pixels */
};

/* Pixels that no part has; those of each part into states, of `count`, if there
 * are any. */
static size_t join_lacks(const struct joining *joining,
                         struct share_state *states, int count)
{
    size_t lacking = 0;
    for (int y = 0; y < joining->height; y++)
        for (int x = 0; x < joining->width; x++) {
            if (join_knows(joining, x, y))
                continue;
            lacking++;
            if (states)
                states[share_owner(count, joining->width, joining->height, x,
                                   y) -
                       1]
                    .lacks++;
        }
    return lacking;
}

static void join_tell_cut(const struct joining *joining,
                          const struct share_state *states, int count)
{
    for (int n = 1; n <= count; n++)
        if (states[n - 1].lacks && states[n - 1].there)
            join_fail(joining,
                      "part %d of %d is not whole, %zu pixels are missing: "
                      "draw them with --part %d/%d +C",
                      n, count, states[n - 1].lacks, n, count);
}

static void join_tell_gone(const struct joining *joining,
                           const struct share_state *states, int count)
{
    char list[400] = "";
    int missing = 0;
    for (int n = 1; n <= count; n++) {
        size_t used = strlen(list);
        if (states[n - 1].lacks && !states[n - 1].there &&
            missing++ < NAMED_MOST)
            snprintf(list + used, sizeof list - used, "%s%d",
                     missing > 1 ? ", " : "", n);
    }
    if (missing)
        join_fail(joining, "of %d parts %d %s missing: %s%s", count, missing,
                  missing > 1 ? "are" : "is", list,
                  missing > NAMED_MOST ? ", ..." : "");
}

/* Names the parts that are not there, and those that are not whole. */
static bool join_tell_missing(const struct joining *joining, size_t lacking)
{
    struct share share;
    int count = 0;
    for (size_t i = 0; i < joining->names.count && !count; i++)
        if (name_share(joining, i, &share))
            count = share.count;
    if (!count)
        return join_fail(joining, "%zu of the pixels of '%s' are in no part",
                         lacking, joining->picture);
    struct share_state *states = memory_new((size_t)count * sizeof *states);
    for (size_t i = 0; i < joining->names.count; i++)
        if (name_share(joining, i, &share) && share.count == count)
            states[share.number - 1].there = true;
    join_lacks(joining, states, count);
    join_tell_cut(joining, states, count);
    join_tell_gone(joining, states, count);
    memory_free(states);
    return false;
}

static bool join_covers(struct joining *joining)
{
    const struct area all = { 0, 0, joining->width, joining->height };
    joining->known = memory_new(area_pixels(all) / 8 + 1);
    for (size_t i = 0; i < joining->names.count; i++) {
        part_file_each(joining->files[i], PART_PIXELS, all, join_note, joining);
        part_file_each(joining->files[i], PART_LEVELS, all, join_note, joining);
    }
    size_t lacking = join_lacks(joining, NULL, 0);
    return !lacking || join_tell_missing(joining, lacking);
}

static bool join_write(struct joining *joining)
{
    struct options options = { 0 };
    struct settings settings = { 0 };
    const char *origin;
    options.render.threads = parallel_cores();
    if (!part_text_read(part_file_text(joining->files[0]), &options, &settings,
                        &origin, joining->arena))
        return join_fail(joining, "'%s' says too little of its picture",
                         joining->names.items[0]);
    const char *extension = output_type_find(options.file_type)->extension;
    if (strcmp(joining->picture + joining->stem, extension) != 0)
        return join_fail(
            joining, "the parts are of a picture called %.*s%s, not %s",
            (int)joining->stem, joining->picture, extension, joining->picture);
    const struct picture_file picture = { &options, &settings, joining->picture,
                                          origin };
    return part_image_write(joining->files, joining->names.count, &picture,
                            NULL, joining->diag);
}

bool part_join(const char *name, struct diag *diag)
{
    struct joining joining = { .diag = diag,
                               .arena = arena_new(0),
                               .picture = name,
                               .stem = output_stem(name) };
    join_find(&joining);
    bool done =
        join_open(&joining) && join_covers(&joining) && join_write(&joining);
    for (size_t i = 0; joining.files && i < joining.names.count; i++)
        part_file_close(joining.files[i]);
    memory_free(joining.files);
    memory_free(joining.known);
    arena_free(joining.arena);
    return done;
}
