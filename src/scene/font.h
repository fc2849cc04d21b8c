/* TrueType fonts (Apple's and Microsoft's "TrueType Reference Manual"): the
 * outlines of letters and how far apart they stand. Any file may be given:
 * nothing in it is believed. All lengths are in units of the font's size. */
#ifndef SCENE_FONT_H
#define SCENE_FONT_H

#include <stdint.h>

#include "scene/outline.h"

struct font;

/* The font in these bytes, which must live as long as it does. Returns NULL and
 * says why when they are none. */
const struct font *font_new(struct arena *arena, const char *bytes, size_t size,
                            const char **problem);

/* The number of the letter for a character; 0 stands for those it lacks. */
int font_letter(const struct font *font, uint32_t character);

struct letter {
    struct segment *segments;
    size_t count;
};

/* The outline of a letter, in the arena. */
struct letter font_outline(const struct font *font, int letter,
                           struct arena *arena);

/* How far from its start the letter's outline begins. */
double font_bearing(const struct font *font, int letter);
/* From the start of a letter to that of the next one. */
double font_advance(const struct font *font, int letter);
/* Added to that between these two. */
double font_kerning(const struct font *font, int left, int right);

#endif
