/* Allocation that can't return NULL: see memory.h. */
#include "base/memory.h"

#include <malloc.h>
#include <stdatomic.h>
#include <stdbool.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <unistd.h>

#include "base/clock.h"

#ifndef MADV_COLLAPSE
#define MADV_COLLAPSE 25 /* of Linux 6.1; refused by older ones */
#endif

enum {
    LARGE_PAGE = 2 << 20,
    HEAD_ROOM = 64 << 10, /* whole pages, on any machine */
    LAZY_LEAST = 64 << 10,
    HEAP_STEP = 16 * LARGE_PAGE,
    HEAP_KEPT = 64 * LARGE_PAGE, /* free, for what is wanted next */
};

/* Bytes of blocks that are not the heap's. Those of the heap alone are guarded
 * by the address sanitizer. */
#ifdef __SANITIZE_ADDRESS__
static const size_t mapped_least = SIZE_MAX, lazy_end = 0;
#else
static const size_t mapped_least = 2 * LARGE_PAGE, lazy_end = 2 * LARGE_PAGE;
#endif

/* Before each block: what was mapped for it, nothing if it is the heap's. */
struct head {
    _Alignas(16) void *mapping;
    size_t size;
};

static _Noreturn void memory_exhausted(size_t size)
{
    fprintf(stderr, "glim: fatal: out of memory (%zu bytes wanted)\n", size);
    exit(1);
}

/* A virtual machine may have given free memory back to its host ("free page
 * reporting"), whole large pages of it: then a large page takes 3 ms instead of
 * 0.2 (measured), and usual ones, of what is left in small pieces, a quarter of
 * that. So the first page of each block is timed: after one that took long some
 * blocks are made of usual pages, 1, then 2, 4 and so on. Where large pages are
 * quick the usual ones of one take up to 6 ms: small pictures took .12 longer.
 */
static const double large_page_slow = 1e-3; /* seconds; usual ones take 0.8 */
static atomic_uint usual_next, usual_blocks;

enum { USUAL_MOST = 16 };

/* Whether the next block is to be of large pages. */
static bool large_pages_wanted(void)
{
    unsigned left = atomic_load(&usual_next);
    while (left > 0)
        if (atomic_compare_exchange_strong(&usual_next, &left, left - 1))
            return false;
    return true;
}

/* Returns whether it took long. */
static bool large_page_timed(double start)
{
    bool slow = clock_seconds() - start > large_page_slow;
    unsigned blocks = atomic_load(&usual_blocks);
    unsigned more = blocks ? 2 * blocks : 1;
    if (more > USUAL_MOST)
        more = USUAL_MOST;
    atomic_store(&usual_blocks, slow ? more : 0);
    if (slow)
        atomic_store(&usual_next, more);
    return slow;
}

/* Pages of the usual size are got from the system one by one, when they are
 * first touched, which mostly takes longer than to fill them. The first page
 * is touched, unless the block is `sparse`. */
static void memory_in_large_pages(uintptr_t from, uintptr_t end, bool sparse)
{
#ifdef MADV_HUGEPAGE
    from += LARGE_PAGE - 1;
    from -= from % LARGE_PAGE;
    end -= end % LARGE_PAGE;
    if (end <= from || !large_pages_wanted())
        return;
    madvise((void *)from, end - from, MADV_HUGEPAGE);
    if (sparse)
        return;
    double start = clock_seconds();
    *(volatile char *)from = 0;
    if (large_page_timed(start))
        madvise((void *)from, end - from, MADV_NOHUGEPAGE);
#else
    (void)from;
    (void)end;
    (void)sparse;
#endif
}

/* A page that was touched too early. */
static void memory_made_large(uintptr_t at)
{
    if (!large_pages_wanted())
        return;
    double start = clock_seconds();
    madvise((void *)(at - at % LARGE_PAGE), LARGE_PAGE, MADV_COLLAPSE);
    large_page_timed(start);
}

/* The same for what everybody's heap has grown by. It begins with a large page
 * and grows by so many that what is left over at its end is little. Threads
 * share it, since those of their own would not be made of large pages. Behind
 * the newest block malloc has already written what is left. */
static void heap_in_large_pages(uintptr_t newest_end)
{
#ifdef __GLIBC__
    static _Atomic uintptr_t known;
    uintptr_t end = (uintptr_t)sbrk(0);
    uintptr_t before = atomic_exchange(&known, end);
    if (before == 0) {
        /* Whoever comes first has no threads yet, which could grow it too. */
        if (sbrk((intptr_t)(LARGE_PAGE - end % LARGE_PAGE)) == (void *)end)
            atomic_store(&known, (uintptr_t)sbrk(0));
        mallopt(M_ARENA_MAX, 1);
        mallopt(M_TOP_PAD, HEAP_STEP);
        mallopt(M_MMAP_THRESHOLD, HEAP_STEP);
        mallopt(M_TRIM_THRESHOLD, HEAP_KEPT);
    } else if (end > before) {
        memory_made_large(newest_end);
        memory_in_large_pages(before, end, true);
    }
#endif
}

/* The heap may grow for it: its new pages must not be touched before they are
 * large. They come zeroed, which calloc knows: a block that nobody fills costs
 * no pages. */
static struct head *heap_block(size_t size)
{
    struct head *head = calloc(1, sizeof *head + size);
    heap_in_large_pages((uintptr_t)head + sizeof *head + size);
    return head;
}

/* Of large blocks some are never filled: their pages come when they are
 * touched, and come zeroed. The head is before the first large page, so that a
 * block nobody fills costs no more than a small one; of what is mapped to find
 * large pages the rest is given back. */
static struct head *mapped_block(size_t size, bool sparse)
{
    size_t rounded = size + LARGE_PAGE - 1;
    rounded -= rounded % LARGE_PAGE;
    size_t all = rounded + 2 * LARGE_PAGE;
    char *mapping = mmap(NULL, all, PROT_READ | PROT_WRITE,
                         MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
    if (mapping == MAP_FAILED)
        return NULL;
    size_t skipped = LARGE_PAGE - (uintptr_t)mapping % LARGE_PAGE;
    if (skipped < HEAD_ROOM)
        skipped += LARGE_PAGE;
    char *block = mapping + skipped, *from = block - HEAD_ROOM;
    char *end = block + rounded;
    if (from > mapping)
        munmap(mapping, (size_t)(from - mapping));
    if (mapping + all > end)
        munmap(end, (size_t)(mapping + all - end));
    if (!sparse)
        memory_in_large_pages((uintptr_t)block, (uintptr_t)end, false);
    struct head *head = (struct head *)block - 1;
    *head = (struct head){ from, HEAD_ROOM + rounded };
    return head;
}

/* A block of usual pages: they come when they are touched, where the heap would
 * zero them all. */
static struct head *lazy_block(size_t size)
{
    size_t all = sizeof(struct head) + size;
    void *mapping = mmap(NULL, all, PROT_READ | PROT_WRITE,
                         MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
    if (mapping == MAP_FAILED)
        return NULL;
    struct head *head = mapping;
    *head = (struct head){ mapping, all };
    return head;
}

static void *memory_got(struct head *head, size_t size)
{
    if (!head)
        memory_exhausted(size);
    return head + 1;
}

static void *memory_block(size_t size, bool sparse)
{
    struct head *head = NULL;
    if (size < mapped_least)
        head = heap_block(size);
    else if (size < SIZE_MAX - 3 * LARGE_PAGE)
        head = mapped_block(size, sparse);
    return memory_got(head, size);
}

void *memory_new(size_t size)
{
    return memory_block(size, false);
}

void *memory_new_sparse(size_t size)
{
    return memory_block(size, true);
}

void *memory_new_lazy(size_t size)
{
    bool lazy = size >= LAZY_LEAST && size < lazy_end;
    return lazy ? memory_got(lazy_block(size), size) : memory_new(size);
}

void memory_free(void *memory)
{
    if (!memory)
        return;
    struct head *head = (struct head *)memory - 1;
    if (head->mapping)
        munmap(head->mapping, head->size);
    else
        free(head);
}

void *memory_resize(void *old, size_t size)
{
    struct head *head = old ? (struct head *)old - 1 : NULL;
    if (head && head->mapping) {
        char *end = (char *)head->mapping + head->size;
        size_t there = (size_t)(end - (char *)old);
        void *memory = memory_new(size);
        memcpy(memory, old, size < there ? size : there);
        memory_free(old);
        return memory;
    }
    head = size < SIZE_MAX / 2 ? realloc(head, sizeof *head + size) : NULL;
    heap_in_large_pages((uintptr_t)head + sizeof *head + size);
    if (!head)
        memory_exhausted(size);
    head->mapping = NULL;
    return head + 1;
}

/* The number in a file, or `otherwise`: "max" stands for no limit. */
static size_t memory_read_limit(const char *path, size_t otherwise)
{
    unsigned long long bytes;
    FILE *file = fopen(path, "r");
    bool found = file && fscanf(file, "%llu", &bytes) == 1;
    if (file)
        fclose(file);
    return found && bytes < otherwise ? (size_t)bytes : otherwise;
}

size_t memory_available(void)
{
    long pages = sysconf(_SC_PHYS_PAGES), size = sysconf(_SC_PAGESIZE);
    size_t bytes =
        pages > 0 && size > 0 ? (size_t)pages * (size_t)size : SIZE_MAX;
    struct rlimit limit;
    if (getrlimit(RLIMIT_AS, &limit) == 0 && limit.rlim_cur < bytes)
        bytes = (size_t)limit.rlim_cur;
    bytes = memory_read_limit("/sys/fs/cgroup/memory.max", bytes);
    return memory_read_limit("/sys/fs/cgroup/memory/memory.limit_in_bytes",
                             bytes);
}
