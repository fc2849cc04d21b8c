/* Notes in the heads of PNG and OpenEXR files: see note.h. Pixels are never
 * read. */
#include "image/note.h"

#include <stdint.h>
#include <stdio.h>
#include <string.h>

enum { NOTE_LIMIT = 8 << 20, NAME_LIMIT = 256, ITEMS_LIMIT = 1000 };

static const char key[] = "glim";

static uint32_t big(const unsigned char *b)
{
    return (uint32_t)b[0] << 24 | (uint32_t)b[1] << 16 | (uint32_t)b[2] << 8 |
           b[3];
}

static uint32_t little(const unsigned char *b)
{
    return (uint32_t)b[3] << 24 | (uint32_t)b[2] << 16 | (uint32_t)b[1] << 8 |
           b[0];
}

static char *note_take(struct arena *arena, FILE *file, size_t length)
{
    if (length > NOTE_LIMIT)
        return NULL;
    char *text = arena_alloc(arena, length + 1);
    return fread(text, 1, length, file) == length ? text : NULL;
}

/* A chunk is its length, its type, its bytes and a checksum; texts stand before
 * the pixels. */
static const char *note_of_png(struct arena *arena, FILE *file)
{
    unsigned char head[8];
    for (int i = 0; i < ITEMS_LIMIT && fread(head, 1, 8, file) == 8; i++) {
        uint32_t length = big(head);
        if (memcmp(head + 4, "IDAT", 4) == 0)
            return NULL;
        if (memcmp(head + 4, "tEXt", 4) != 0) {
            if (fseek(file, (long)length + 4, SEEK_CUR) != 0)
                return NULL;
            continue;
        }
        const char *text = note_take(arena, file, length);
        if (!text || fseek(file, 4, SEEK_CUR) != 0)
            return NULL;
        if (length >= sizeof key && memcmp(text, key, sizeof key) == 0)
            return text + sizeof key;
    }
    return NULL;
}

static bool exr_word(FILE *file, char word[NAME_LIMIT])
{
    for (int i = 0; i < NAME_LIMIT; i++) {
        int c = getc(file);
        if (c == EOF)
            return false;
        word[i] = (char)c;
        if (c == 0)
            return true;
    }
    return false;
}

/* Attributes are a name, a type, a length and so many bytes; an empty name
 * ends them. */
static const char *note_of_exr(struct arena *arena, FILE *file)
{
    char name[NAME_LIMIT], type[NAME_LIMIT];
    unsigned char size[4];
    for (int i = 0; i < ITEMS_LIMIT; i++) {
        if (!exr_word(file, name) || !*name || !exr_word(file, type) ||
            fread(size, 1, 4, file) != 4)
            return NULL;
        if (strcmp(name, key) == 0 && strcmp(type, "string") == 0)
            return note_take(arena, file, little(size));
        if (fseek(file, (long)little(size), SEEK_CUR) != 0)
            return NULL;
    }
    return NULL;
}

const char *image_note_read(struct arena *arena, const char *path)
{
    static const char png[] = "\x89PNG\r\n\x1a\n", exr[] = "\x76\x2f\x31\x01";
    char mark[8] = "";
    const char *note = NULL;
    FILE *file = fopen(path, "rb");
    if (!file)
        return NULL;
    if (fread(mark, 1, 8, file) == 8) {
        if (memcmp(mark, png, 8) == 0)
            note = note_of_png(arena, file);
        else if (memcmp(mark, exr, 4) == 0)
            note = note_of_exr(arena, file);
    }
    fclose(file);
    return note;
}
