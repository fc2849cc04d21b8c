/* The poster's forward heuristic: light spreads along the skeleton from the
 * lamp. What arrives is its share at the narrowest place on the way, the area
 * of the smallest ball of void over that of the first (A8: the running minimum;
 * dividing the flux at every fork fails where there are many), over the square
 * of the whole way's length: B = I (r_min / r_0)^2 / d^2. */
#include "skeleton/heuristic.h"
#include "skeleton/stream.h"

static struct skeleton_light forward_answer(const struct skeleton *skeleton,
                                            struct worker *worker,
                                            const struct skeleton_point *point)
{
    return stream_gather(skeleton, worker, point, stream_forward);
}

const struct heuristic forward_heuristic = {
    .name = "forward",
    .help = "by the length of the way from the lamp and its narrowest place",
    .answer = forward_answer,
};
