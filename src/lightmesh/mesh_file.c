/* See mesh_file.h for how the bytes are laid out. */
#include "lightmesh/mesh_file.h"

#include <stdio.h>
#include <string.h>

#include "base/hash.h"
#include "base/memory.h"
#include "lightmesh/point_mesh.h"
#include "lightmesh/table.h"

static const char file_mark[16] = "glim light mesh\n";

enum {
    BYTE_ORDER_MARK = 0x01020304,
    TABLES = 2, /* of a mesh */
    HEAD_SIZE = 16 + 4 + 4 + 8 + MESH_FRAME_NUMBERS * 8 + 4 * 8 +
                MESH_SETTINGS_SIZE + 8,
    TABLE_SIZE = 8 + 8,
    HASH_SIZE = 8,
    SIZE_AT = 24,
};

static struct table *mesh_table(const struct point_mesh *mesh, size_t number)
{
    return number == 0 ? mesh->around : mesh->table;
}

static void put(char **to, const void *from, size_t size)
{
    memcpy(*to, from, size);
    *to += size;
}

static void put_number(char **to, uint64_t number)
{
    put(to, &number, sizeof number);
}

static void take(const char **from, void *to, size_t size)
{
    memcpy(to, *from, size);
    *from += size;
}

static uint64_t take_number(const char **from)
{
    uint64_t number;
    take(from, &number, sizeof number);
    return number;
}

static void put_head(char **to, const struct mesh_stamp *stamp, size_t size,
                     size_t tables)
{
    const uint32_t words[2] = { MESH_VERSION, BYTE_ORDER_MARK };
    double frame[MESH_FRAME_NUMBERS];
    mesh_frame_put(&stamp->frame, frame);
    put(to, file_mark, sizeof file_mark);
    put(to, words, sizeof words);
    put_number(to, size);
    put(to, frame, sizeof frame);
    put_number(to, stamp->scene.objects);
    put_number(to, stamp->scene.textures);
    put_number(to, stamp->scene.lights);
    put_number(to, stamp->scene.surroundings);
    put(to, stamp->settings, sizeof stamp->settings);
    put_number(to, tables);
}

static void put_table(char **to, const struct table *table)
{
    size_t size = table_record_size(table);
    struct table_entry *entries =
        memory_new(table_count(table) * sizeof *entries);
    size_t count = table_entries(table, entries);
    put_number(to, size);
    put_number(to, count);
    for (size_t i = 0; i < count; i++) {
        put_number(to, entries[i].key);
        put(to, entries[i].record, size);
    }
    memory_free(entries);
}

void *mesh_file_pack(const struct mesh_stamp *stamp,
                     const struct point_mesh *const *meshes, size_t count,
                     size_t *size)
{
    size_t most = HEAD_SIZE + HASH_SIZE;
    for (size_t i = 0; i < TABLES * count; i++) {
        const struct table *table = mesh_table(meshes[i / TABLES], i % TABLES);
        most +=
            TABLE_SIZE + table_count(table) * (8 + table_record_size(table));
    }
    char *bytes = memory_new(most), *to = bytes + HEAD_SIZE;
    for (size_t i = 0; i < TABLES * count; i++)
        put_table(&to, mesh_table(meshes[i / TABLES], i % TABLES));
    *size = (size_t)(to - bytes) + HASH_SIZE;
    char *head = bytes;
    put_head(&head, stamp, *size, TABLES * count);
    put_number(&to, hash_bytes(0, bytes, *size - HASH_SIZE));
    return bytes;
}

/* What is wrong before anything else is looked at, or NULL. */
static const char *file_problem(const char *bytes, size_t size, char *text,
                                size_t text_size)
{
    const char *from = bytes + sizeof file_mark;
    uint32_t words[2];
    if (size < sizeof file_mark ||
        memcmp(bytes, file_mark, sizeof file_mark) != 0)
        return "it is no light mesh";
    if (size < HEAD_SIZE + HASH_SIZE)
        return "it is cut off";
    take(&from, words, sizeof words);
    if (words[1] != BYTE_ORDER_MARK)
        return "it is damaged, or of a machine with another order of bytes";
    if (words[0] != MESH_VERSION) {
        snprintf(text, text_size,
                 "it is of version %u, which this glim, of version %d, "
                 "can't use",
                 (unsigned)words[0], MESH_VERSION);
        return text;
    }
    uint64_t wanted = take_number(&from);
    if (wanted != size) {
        snprintf(text, text_size, "it is %s: %zu bytes, not %llu",
                 wanted > size ? "cut off" : "damaged", size,
                 (unsigned long long)wanted);
        return text;
    }
    from = bytes + size - HASH_SIZE;
    if (take_number(&from) != hash_bytes(0, bytes, size - HASH_SIZE))
        return "it is damaged";
    return NULL;
}

static void take_stamp(const char **from, struct mesh_stamp *stamp)
{
    double frame[MESH_FRAME_NUMBERS];
    take(from, frame, sizeof frame);
    mesh_frame_take(&stamp->frame, frame);
    stamp->scene.objects = take_number(from);
    stamp->scene.textures = take_number(from);
    stamp->scene.lights = take_number(from);
    stamp->scene.surroundings = take_number(from);
    take(from, stamp->settings, sizeof stamp->settings);
}

/* Whether numbers are such as a glim writes: a right hash is no proof. */
static bool stamp_possible(const struct mesh_stamp *stamp)
{
    const char *settings = stamp->settings;
    if (!mesh_frame_possible(&stamp->frame) ||
        !memchr(settings, 0, MESH_SETTINGS_SIZE))
        return false;
    for (; *settings; settings++)
        if (*settings != '\n' && (*settings < ' ' || *settings > '~'))
            return false;
    return true;
}

/* Goes over one table; false if it can't be one. */
static bool table_possible(const char **from, const char *end)
{
    uint64_t before = 0;
    if (end - *from < TABLE_SIZE)
        return false;
    uint64_t size = take_number(from), count = take_number(from);
    uint64_t left = (uint64_t)(end - *from);
    if (count > 0 && (size > left || count > left / (8 + size)))
        return false;
    for (uint64_t i = 0; i < count; i++, *from += size) {
        uint64_t key = take_number(from);
        if (key <= before)
            return false;
        before = key;
    }
    return true;
}

bool mesh_file_open(struct mesh_file *file, const void *bytes, size_t size,
                    char *problem, size_t problem_size)
{
    char text[100];
    const char *found = file_problem(bytes, size, text, sizeof text);
    if (found) {
        snprintf(problem, problem_size, "%s", found);
        return false;
    }
    const char *from = (const char *)bytes + SIZE_AT + 8;
    take_stamp(&from, &file->stamp);
    uint64_t tables = take_number(&from);
    file->tables = from;
    file->end = (const char *)bytes + size - HASH_SIZE;
    file->count = (size_t)(tables / TABLES);
    bool possible = stamp_possible(&file->stamp) && tables % TABLES == 0;
    for (uint64_t i = 0; possible && i < tables; i++)
        possible = table_possible(&from, file->end);
    if (!possible || from != file->end)
        snprintf(problem, problem_size, "it is damaged");
    return possible && from == file->end;
}

static bool take_table(const char **from, struct table *table, double full,
                       struct map *map)
{
    uint64_t size = take_number(from), count = take_number(from);
    if (size != table_record_size(table))
        return false;
    if (map && count > 0 &&
        table_share(table, map, *from, (size_t)count, lattice_hash)) {
        *from += count * (8 + size);
        return true;
    }
    bool fill = (double)count <= full * (double)table_capacity(table);
    for (uint64_t i = 0; i < count; i++, *from += size) {
        uint64_t key = take_number(from);
        if (fill)
            table_insert(table, key, lattice_hash(key), *from);
    }
    return true;
}

bool mesh_file_fill(const struct mesh_file *file,
                    const struct point_mesh *const *meshes, size_t count,
                    double full, struct map *map)
{
    const char *from = file->tables;
    if (count != file->count)
        return false;
    for (size_t i = 0; i < TABLES * count; i++)
        if (!take_table(&from, mesh_table(meshes[i / TABLES], i % TABLES), full,
                        map))
            return false;
    return true;
}
