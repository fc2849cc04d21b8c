/* Pictures made of functions, piece by piece: see function_picture.h. */
#include "parse/function_picture.h"

#include "base/clones.h"
#include "scene/function_field.h"

struct function_picture function_picture_new(const struct function *function,
                                             int width, int height)
{
    double steps = (double)width * height * function->work;
    bool slow = steps > FUNCTION_PICTURE_STEPS;
    return (struct function_picture){ function, width, height,
                                      slow ? 0 : FUNCTION_PICTURE_STEPS };
}

/* What the last number of a row or column is divided by to be 1. Where there is
 * one alone it is 0. */
static double last_of(int count)
{
    return count > 1 ? count - 1 : HUGE_VAL;
}

CLONES static void piece_places(const struct function_picture *picture, int x,
                                int y, struct spots *spots)
{
    const int left = picture->width - x;
    const double last = last_of(picture->width);
    const double down = y / last_of(picture->height);
    for (int i = 0; i < SPOTS_MAX; i++)
        spots_put(spots, i, vec3_make((x + i) / last, down, 0));
    spots->count = left < SPOTS_MAX ? left : SPOTS_MAX;
}

/* No function that is worked out at several points at once takes more steps
 * than were counted before. */
bool function_picture_piece(struct function_picture *picture, int x, int y,
                            struct function_piece *piece)
{
    const struct function *function = picture->function;
    struct spots spots;
    if (picture->steps_left == 0)
        return false;
    piece_places(picture, x, y, &spots);
    piece->count = spots.count;
    if (function->values) {
        function_values_all(function->values, &spots, piece->parts);
    } else if (function->together) {
        function_values_at(function, &spots, piece->values);
    } else {
        for (int i = 0; i < spots.count && picture->steps_left > 0; i++) {
            const double arguments[] = { spots.x[i], spots.y[i], spots.z[i] };
            piece->values[i] =
                function_evaluate(function, arguments, &picture->steps_left);
        }
    }
    return picture->steps_left > 0;
}
