/* Journals of tiles: see part_file.h. Tiles are gathered, since a page of the
 * file costs the kernel several times as much when it is written alone. Who
 * fills the room writes it while others fill the next; a process that is killed
 * may so leave a hole, which reads as zeros and is passed over. */
#include "image/part_file.h"

#include <errno.h>
#include <fcntl.h>
#include <poll.h>
#include <stdatomic.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include "base/array.h"
#include "base/hash.h"
#include "base/memory.h"
#include "base/parallel.h"
#include "image/image.h"
#include "image/output.h"
#include "image/part_values.h"

enum {
    PART_VERSION = 5,
    ORDER = 0x01020304,
    MARK = 0x454c4954,
    TEXT_LIMIT = 8 << 20,
    SIDE_LIMIT = 4097,      /* of a tile; rows of tallies are longer */
    PIXELS_LIMIT = 1 << 20, /* of one with a longer side */
    WINDOW = 8 << 10,     /* bytes; what isn't a mark after all is read again */
    GATHERED = 128 << 10, /* bytes that are written at once */
    OPAQUE = 1 << 16,     /* in a record's kind: the fourth float is always 1 */
    LOCK_TRIES = 20,
    LOCK_PAUSE = 50, /* ms */
};

static const char magic[16] = "glim part file\n";

struct part_head {
    char magic[16];
    uint32_t version, order;
    int32_t width, height;
    uint32_t length, checksum;
};

struct part_record {
    uint32_t mark, kind;
    int32_t left, top, right, bottom;
    uint32_t values, checksum;
};

_Static_assert(sizeof(struct part_head) == 40 &&
                   sizeof(struct part_record) == 32,
               "no padding");

/* A tile that is in the file. */
struct part_tile {
    enum part_kind kind;
    struct area area;
    off_t at; /* of its record */
};

/* What waits to be written, all at one place. */
struct part_room {
    char *bytes; /* NULL: none yet */
    size_t used, size;
    off_t at;
};

struct part_file {
    int handle;
    char *text;
    int width, height;
    bool damaged;
    struct lock *lock; /* of the next five */
    struct part_room room, spare;
    int writing; /* rooms that are on their way to the file */
    off_t end;   /* where the next tile goes */
    struct {
        struct part_tile *items; /* the oldest first */
        size_t count, capacity;
    } tiles;
    struct arena *arena; /* theirs alone, so that they grow where they are */
    atomic_int problem;  /* errno of the first failure; 0: none */
};

static bool part_has_floats(enum part_kind kind)
{
    return kind == PART_FIRST || kind == PART_PIXELS;
}

/* Bytes of a pixel, as they are given and taken. */
static size_t part_unit(enum part_kind kind)
{
    static const size_t units[PART_KINDS] = {
        [PART_FIRST] = PART_RGBA,
        [PART_PIXELS] = PART_RGBA,
        [PART_LEVELS] = OUTPUT_LEVELS,
        [PART_TALLIES] = PART_TALLY,
    };
    return units[kind];
}

static enum part_kind record_kind(const struct part_record *record)
{
    return record->kind & ~(uint32_t)OPAQUE;
}

/* Bytes of a pixel in the file. */
static size_t record_unit(const struct part_record *record)
{
    return record->kind & OPAQUE ? PART_RGB : part_unit(record->kind);
}

static uint32_t checksum(uint64_t hash, const void *bytes, size_t count)
{
    return (uint32_t)hash_bytes(hash, bytes, count);
}

static uint32_t head_checksum(const struct part_head *head, const char *text)
{
    struct part_head bare = *head;
    bare.checksum = 0;
    return checksum(checksum(0, &bare, sizeof bare), text, head->length);
}

static uint32_t record_checksum(const struct part_record *record)
{
    return checksum(0, record, offsetof(struct part_record, checksum));
}

/* All bytes, or false. */
static bool read_at(int handle, void *to, size_t count, off_t at)
{
    char *next = to;
    while (count > 0) {
        ssize_t got = pread(handle, next, count, at);
        if (got == 0 || (got < 0 && errno != EINTR))
            return false;
        if (got > 0) {
            next += got;
            count -= (size_t)got;
            at += got;
        }
    }
    return true;
}

/* The same. */
static bool write_at(int handle, const void *from, size_t count, off_t at)
{
    const char *next = from;
    while (count > 0) {
        ssize_t put = pwrite(handle, next, count, at);
        if (put < 0 && errno != EINTR)
            return false;
        if (put > 0) {
            next += put;
            count -= (size_t)put;
            at += put;
        }
    }
    return true;
}

static void tile_add(struct part_file *file, enum part_kind kind,
                     struct area area, off_t at)
{
    *ARRAY_PUSH(file->arena, &file->tiles) =
        (struct part_tile){ .kind = kind, .area = area, .at = at };
}

/* A process that was killed may hold it for a moment yet. */
static bool part_lock(int handle)
{
    for (int i = 0; i < LOCK_TRIES; i++) {
        if (flock(handle, LOCK_EX | LOCK_NB) == 0)
            return true;
        poll(NULL, 0, LOCK_PAUSE);
    }
    return false;
}

/* Open and locked, or -1 with the reason. */
static int part_handle(const char *path, int flags, char *error, size_t size)
{
    int handle = open(path, O_RDWR | O_CLOEXEC | flags, 0666);
    struct stat status;
    if (handle < 0) {
        snprintf(error, size, "%s", strerror(errno));
        return -1;
    }
    bool plain = fstat(handle, &status) == 0 && S_ISREG(status.st_mode);
    if (plain && part_lock(handle))
        return handle;
    if (plain)
        *error = '\0';
    else
        snprintf(error, size, "it is not a regular file");
    close(handle);
    return -1;
}

/* A file that was cut goes to the disk whole when it is closed (ext4), for
 * nothing where it is then removed; so a new one isn't cut. */
static bool part_emptied(int handle)
{
    struct stat status;
    return fstat(handle, &status) == 0 &&
           (status.st_size == 0 || ftruncate(handle, 0) == 0);
}

static struct part_file *part_new(int handle, int width, int height,
                                  size_t length)
{
    struct part_file *file = memory_new(sizeof *file);
    file->handle = handle;
    file->width = width;
    file->height = height;
    file->text = memory_new(length + 1);
    file->lock = lock_new();
    file->arena = arena_new(0);
    return file;
}

struct part_file *part_file_create(const char *path, const char *text,
                                   int width, int height, char *error,
                                   size_t size)
{
    size_t length = strlen(text);
    struct part_head head = { .version = PART_VERSION,
                              .order = ORDER,
                              .width = width,
                              .height = height,
                              .length = (uint32_t)length };
    int handle = part_handle(path, O_CREAT, error, size);
    if (handle < 0)
        return NULL;
    memcpy(head.magic, magic, sizeof magic);
    head.checksum = head_checksum(&head, text);
    bool done = length <= TEXT_LIMIT && part_emptied(handle) &&
                write_at(handle, &head, sizeof head, 0) &&
                write_at(handle, text, length, sizeof head);
    if (!done) {
        snprintf(error, size, "%s", strerror(errno));
        close(handle);
        unlink(path);
        return NULL;
    }
    struct part_file *file = part_new(handle, width, height, length);
    memcpy(file->text, text, length);
    file->end = (off_t)(sizeof head + length);
    return file;
}

/* Whether a record can be one of this file, whose values end before `end`. */
static bool record_possible(const struct part_file *file,
                            const struct part_record *r, off_t at, off_t end)
{
    if (r->mark != MARK || record_kind(r) >= PART_KINDS ||
        (r->kind & OPAQUE && !part_has_floats(record_kind(r))) ||
        r->checksum != record_checksum(r) || r->left < -1 || r->top < -1 ||
        r->right <= r->left || r->bottom <= r->top ||
        r->right > file->width + 1 || r->bottom > file->height + 1)
        return false;
    long long wide = (long long)r->right - r->left;
    long long high = (long long)r->bottom - r->top;
    if ((wide > SIDE_LIMIT || high > SIDE_LIMIT) && wide * high > PIXELS_LIMIT)
        return false;
    long long bytes = wide * high * (long long)record_unit(r);
    return bytes <= end - at - (long long)sizeof *r;
}

static struct area record_area(const struct part_record *record)
{
    return (struct area){ record->left, record->top, record->right,
                          record->bottom };
}

/* The values of a record, if they are whole; freed with memory_free. */
static void *record_values(const struct part_file *file,
                           const struct part_record *record, off_t at)
{
    size_t pixels = area_pixels(record_area(record));
    size_t count = pixels * record_unit(record);
    void *values = memory_new(pixels * part_unit(record_kind(record)));
    if (!read_at(file->handle, values, count, at + (off_t)sizeof *record) ||
        checksum(0, values, count) != record->values) {
        memory_free(values);
        return NULL;
    }
    if (record->kind & OPAQUE)
        values_unpack(values, pixels);
    return values;
}

/* Where the next mark is, from `at` on; `end` if there is none. */
static off_t mark_after(const struct part_file *file, off_t at, off_t end)
{
    static const uint32_t mark = MARK;
    char *window = memory_new(WINDOW);
    off_t found = end;
    while (found == end && end - at >= (off_t)sizeof mark) {
        size_t count = end - at < WINDOW ? (size_t)(end - at) : WINDOW;
        if (!read_at(file->handle, window, count, at))
            break;
        for (size_t i = 0; found == end && i + sizeof mark <= count; i++)
            if (memcmp(window + i, &mark, sizeof mark) == 0)
                found = at + (off_t)i;
        at += (off_t)(count - sizeof mark + 1);
    }
    memory_free(window);
    return found;
}

/* Finds all tiles that are whole. What comes after the last is cut off, or new
 * tiles would stand behind it for nothing. */
static void part_look(struct part_file *file, off_t at, off_t end)
{
    struct part_record record;
    off_t good = at;
    while (end - at > (off_t)sizeof record) {
        void *values = NULL;
        if (read_at(file->handle, &record, sizeof record, at) &&
            record_possible(file, &record, at, end))
            values = record_values(file, &record, at);
        if (!values) {
            file->damaged = true;
            at = mark_after(file, at + 1, end);
            continue;
        }
        memory_free(values);
        struct area area = record_area(&record);
        tile_add(file, record_kind(&record), area, at);
        at += (off_t)(sizeof record + area_pixels(area) * record_unit(&record));
        good = at;
    }
    file->damaged |= good < end;
    file->end = good;
}

static bool head_right(const struct part_head *head, char *error, size_t size)
{
    const char *problem = NULL;
    if (memcmp(head->magic, magic, sizeof magic) != 0)
        problem = "it is no part file, or damaged";
    else if (head->order != ORDER)
        problem = "it is damaged, or of a machine with another order of bytes";
    else if (head->version != PART_VERSION)
        problem = "it is of another version of glim";
    else if (head->length > TEXT_LIMIT || head->width < 1 || head->height < 1 ||
             head->width > IMAGE_SIDE_LIMIT || head->height > IMAGE_SIDE_LIMIT)
        problem = "it is damaged";
    if (problem)
        snprintf(error, size, "%s", problem);
    return !problem;
}

struct part_file *part_file_open(const char *path, char *error, size_t size)
{
    struct part_head head;
    struct stat status;
    int handle = part_handle(path, 0, error, size);
    if (handle < 0)
        return NULL;
    struct part_file *file = NULL;
    if (!read_at(handle, &head, sizeof head, 0) || fstat(handle, &status) != 0)
        snprintf(error, size, "it is cut off");
    else if (head_right(&head, error, size))
        file = part_new(handle, head.width, head.height, head.length);
    if (file && (!read_at(handle, file->text, head.length, sizeof head) ||
                 head.checksum != head_checksum(&head, file->text) ||
                 strlen(file->text) != head.length)) {
        snprintf(error, size, "it is damaged");
        part_file_close(file);
        return NULL;
    }
    if (file)
        part_look(file, (off_t)(sizeof head + head.length), status.st_size);
    else
        close(handle);
    return file;
}

void part_file_close(struct part_file *file)
{
    if (!file)
        return;
    part_file_flush(file);
    close(file->handle);
    lock_free(file->lock);
    memory_free(file->spare.bytes);
    arena_free(file->arena);
    memory_free(file->text);
    memory_free(file);
}

const char *part_file_text(const struct part_file *file)
{
    return file->text;
}

int part_file_width(const struct part_file *file)
{
    return file->width;
}

int part_file_height(const struct part_file *file)
{
    return file->height;
}

bool part_file_was_damaged(const struct part_file *file)
{
    return file->damaged;
}

/* The first failure is the one that is told. */
static void part_write(struct part_file *file, const char *bytes, size_t count,
                       off_t at)
{
    int none = 0;
    if (!write_at(file->handle, bytes, count, at))
        atomic_compare_exchange_strong(&file->problem, &none, errno);
}

static void room_write(struct part_file *file, struct part_room room)
{
    part_write(file, room.bytes, room.used, room.at);
    lock_take(file->lock);
    memory_free(file->spare.bytes);
    file->spare = room;
    file->writing--;
    lock_give(file->lock);
}

/* Takes away what waits; the lock is held. */
static struct part_room room_taken(struct part_file *file)
{
    struct part_room room = file->room;
    file->room = (struct part_room){ .bytes = NULL };
    file->writing += room.bytes != NULL;
    return room;
}

/* Room for `count` bytes more, where they are to be put; the lock is held. */
static char *room_for(struct part_file *file, size_t count)
{
    struct part_room *room = &file->room;
    if (!room->bytes) {
        *room = file->spare;
        file->spare = (struct part_room){ .bytes = NULL };
        if (room->size < count) {
            room->size = count > GATHERED ? count : GATHERED;
            room->bytes = memory_resize(room->bytes, room->size);
        }
        room->used = 0;
        room->at = file->end;
    }
    char *to = room->bytes + room->used;
    room->used += count;
    file->end += (off_t)count;
    return to;
}

/* As they stand in the file: the values after their record. */
static void record_copy(char *to, const struct part_record *record,
                        const void *values, size_t count)
{
    memcpy(to, record, sizeof *record);
    memcpy(to + sizeof *record, values, count);
}

/* A tile's record and values, one after the other, at *place; returns what is
 * full. */
static struct part_room tile_put(struct part_file *file,
                                 const struct part_record *record,
                                 const void *values, size_t count, off_t *place)
{
    struct part_room full = { .bytes = NULL };
    lock_take(file->lock);
    if (file->room.used + sizeof *record + count > file->room.size)
        full = room_taken(file);
    *place = file->end;
    tile_add(file, record_kind(record), record_area(record), file->end);
    record_copy(room_for(file, sizeof *record + count), record, values, count);
    lock_give(file->lock);
    return full;
}

static struct part_record record_of(uint32_t kind, struct area area,
                                    const void *values)
{
    struct part_record record = { .mark = MARK,
                                  .kind = kind,
                                  .left = area.left,
                                  .top = area.top,
                                  .right = area.right,
                                  .bottom = area.bottom };
    record.values =
        checksum(0, values, area_pixels(area) * record_unit(&record));
    record.checksum = record_checksum(&record);
    return record;
}

long long part_file_put(struct part_file *file, enum part_kind kind,
                        struct area area, const void *values)
{
    size_t pixels = area_pixels(area);
    uint32_t stored = kind;
    float *packed = NULL;
    off_t place;
    if (atomic_load(&file->problem))
        return 0;
    if (part_has_floats(kind) && values_opaque(values, pixels)) {
        stored |= OPAQUE;
        values = packed = values_packed(values, pixels);
    }
    const struct part_record record = record_of(stored, area, values);
    struct part_room full =
        tile_put(file, &record, values, pixels * record_unit(&record), &place);
    memory_free(packed);
    if (full.bytes)
        room_write(file, full);
    return place;
}

/* Whether what stands there has been written. */
static bool place_written(struct part_file *file, off_t place)
{
    lock_take(file->lock);
    bool written =
        file->writing == 0 && (!file->room.bytes || place < file->room.at);
    lock_give(file->lock);
    return written;
}

long long part_file_replace(struct part_file *file, struct area area,
                            const void *values, long long place)
{
    if (atomic_load(&file->problem))
        return 0;
    if (!place_written(file, (off_t)place))
        return part_file_put(file, PART_TALLIES, area, values);
    const struct part_record record = record_of(PART_TALLIES, area, values);
    size_t count = area_pixels(area) * PART_TALLY;
    char *bytes = memory_resize(NULL, sizeof record + count);
    record_copy(bytes, &record, values, count);
    part_write(file, bytes, sizeof record + count, (off_t)place);
    memory_free(bytes);
    return place;
}

const char *part_file_problem(const struct part_file *file)
{
    int problem = atomic_load(&file->problem);
    return problem ? strerror(problem) : NULL;
}

void part_file_flush(struct part_file *file)
{
    lock_take(file->lock);
    struct part_room room = room_taken(file);
    lock_give(file->lock);
    if (room.bytes)
        room_write(file, room);
}

void part_file_sync(struct part_file *file)
{
    part_file_flush(file);
    fdatasync(file->handle);
}

void part_file_each(struct part_file *file, enum part_kind kind,
                    struct area within, part_take *take, void *context)
{
    struct part_record record;
    part_file_flush(file);
    for (size_t i = 0; i < file->tiles.count; i++) {
        const struct part_tile *tile = &file->tiles.items[i];
        if (tile->kind != kind || !area_meet(tile->area, within))
            continue;
        void *values = NULL;
        if (read_at(file->handle, &record, sizeof record, tile->at) &&
            record.checksum == record_checksum(&record) &&
            record_kind(&record) == kind &&
            area_pixels(record_area(&record)) == area_pixels(tile->area))
            values = record_values(file, &record, tile->at);
        if (values)
            take(context, tile->area, values);
        memory_free(values);
    }
}
