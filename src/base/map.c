/* Shared memory of files: see map.h. */
#include "base/map.h"

#include <errno.h>
#include <fcntl.h>
#include <stdatomic.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

#include "base/memory.h"

struct map {
    void *bytes;
    size_t size;
    atomic_int holders;
};

struct map *map_open(const char *path)
{
    int file = open(path, O_RDONLY | O_CLOEXEC | O_NONBLOCK);
    struct stat status;
    struct map *map = NULL;
    if (file < 0 || fstat(file, &status) != 0)
        return NULL;
    void *bytes = MAP_FAILED;
    errno = S_ISDIR(status.st_mode) ? EISDIR : EINVAL;
    if (S_ISREG(status.st_mode) && status.st_size > 0)
        bytes =
            mmap(NULL, (size_t)status.st_size, PROT_READ, MAP_SHARED, file, 0);
    int reason = errno;
    close(file);
    errno = reason;
    if (bytes == MAP_FAILED)
        return NULL;
    map = memory_new(sizeof *map);
    map->bytes = bytes;
    map->size = (size_t)status.st_size;
    atomic_store(&map->holders, 1);
    return map;
}

void map_hold(struct map *map)
{
    atomic_fetch_add(&map->holders, 1);
}

void map_release(struct map *map)
{
    if (!map || atomic_fetch_sub(&map->holders, 1) > 1)
        return;
    munmap(map->bytes, map->size);
    memory_free(map);
}

const void *map_bytes(const struct map *map)
{
    return map->bytes;
}

size_t map_size(const struct map *map)
{
    return map->size;
}
