/* Pictures in memory: see image.h. */
#include "image/image.h"

#include "base/memory.h"

struct image *image_new(int width, int height)
{
    struct image *image = memory_new(sizeof *image);
    image->width = width;
    image->height = height;
    image->pixels =
        memory_new((size_t)width * (size_t)height * 4 * sizeof(float));
    return image;
}

void image_free(struct image *image)
{
    if (!image)
        return;
    memory_free(image->pixels);
    memory_free(image);
}
