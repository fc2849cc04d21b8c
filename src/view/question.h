/* What is under a place of the picture. */
#ifndef VIEW_QUESTION_H
#define VIEW_QUESTION_H

#include <stdio.h>

#include "view/drawing.h"

/* What a camera's ray meets first. */
struct question_hit {
    bool met;
    struct ray ray;
    struct intersection at;
};

/* At (x, y) of the picture, 0..1 from the top left. */
struct question_hit question_meet(const struct model *model,
                                  const struct camera *camera, double x,
                                  double y);

/* A line: object and texture with their places, the point, its normal, how far
 * it is. */
void question_tell(const struct question_hit *hit, FILE *out);

/* The same of a finished drawing, and what light is there: the colour, the
 * irradiance, and who answered for it. In short in notice[size]. */
void question_answer(const struct drawing *drawing, double x, double y,
                     FILE *out, char *notice, size_t size);

/* "file:line:col" in text[size]; "nowhere" if it is. */
void question_place(struct span span, char *text, size_t size);

/* Where the object or, if `texture`, its texture is written. */
struct span question_span(const struct question_hit *hit, bool texture);

#endif
