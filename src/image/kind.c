/* The kinds of picture files that are read, POV-Ray's, by how they begin:
 * scenes come from anybody, and OpenImageIO would open a hundred kinds, films
 * and shaders' among them, with libraries that few people look after. */
#include "image/kind.h"

#include <stdbool.h>
#include <string.h>

static const struct kind {
    const char *name; /* OpenImageIO's */
    const char *start;
    size_t length, at;
} kinds[] = {
    { "png", "\x89PNG\r\n\x1a\n", 8, 0 },
    { "jpeg", "\xff\xd8\xff", 3, 0 },
    { "gif", "GIF87a", 6, 0 },
    { "gif", "GIF89a", 6, 0 },
    { "bmp", "BM", 2, 0 },
    { "tiff", "II*\0", 4, 0 },
    { "tiff", "MM\0*", 4, 0 },
    { "tiff", "II+\0", 4, 0 },
    { "tiff", "MM\0+", 4, 0 },
    { "openexr", "\x76\x2f\x31\x01", 4, 0 },
    { "hdr", "#?RADIANCE", 10, 0 },
    { "hdr", "#?RGBE", 6, 0 },
    { "iff", "CIMG", 4, 8 },
    { "iff", "ILBM", 4, 8 },
    { "iff", "PBM ", 4, 8 },
};

enum { KIND_COUNT = sizeof kinds / sizeof *kinds };

static bool kind_is_pnm(const unsigned char *bytes)
{
    return bytes[0] == 'P' && bytes[1] && strchr("123456fF", bytes[1]) &&
           bytes[2] && strchr(" \t\r\n#", bytes[2]);
}

/* A Targa has no mark; its header has few numbers that make sense. */
static bool kind_is_targa(const unsigned char *bytes)
{
    unsigned palette = bytes[1], type = bytes[2], depth = bytes[16];
    bool known = type && strchr("\1\2\3\11\12\13", (int)type) && palette <= 1;
    bool sized = (bytes[12] || bytes[13]) && (bytes[14] || bytes[15]);
    return known && sized && depth && strchr("\10\17\20\30\40", (int)depth);
}

const char *kind_of_bytes(const unsigned char *bytes, size_t count)
{
    unsigned char first[KIND_BYTES] = { 0 };
    memcpy(first, bytes, count < KIND_BYTES ? count : KIND_BYTES);
    for (size_t i = 0; i < KIND_COUNT; i++)
        if (memcmp(first + kinds[i].at, kinds[i].start, kinds[i].length) == 0)
            return kinds[i].name;
    return kind_is_pnm(first) ? "pnm" : kind_is_targa(first) ? "targa" : NULL;
}
