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

/* What is in both; a side is negative unless they meet. */
static inline struct area area_both(struct area a, struct area b)
{
    return (struct area){
        a.left > b.left ? a.left : b.left,
        a.top > b.top ? a.top : b.top,
        a.right < b.right ? a.right : b.right,
        a.bottom < b.bottom ? a.bottom : b.bottom,
    };
}

static inline bool area_is_empty(struct area area)
{
    return area.left >= area.right || area.top >= area.bottom;
}

#endif
