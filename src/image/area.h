/* A part of a picture in pixels. */
#ifndef IMAGE_AREA_H
#define IMAGE_AREA_H

#include <stdbool.h>
#include <stddef.h>

/* Ends exclusive. */
struct area {
    int left, top, right, bottom;
};

static inline size_t area_pixels(struct area area)
{
    return (size_t)(area.right - area.left) * (size_t)(area.bottom - area.top);
}

static inline bool area_meet(struct area a, struct area b)
{
    return a.left < b.right && b.left < a.right && a.top < b.bottom &&
           b.top < a.bottom;
}

#endif
