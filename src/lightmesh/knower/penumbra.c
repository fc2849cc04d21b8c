/* Area lights at the picture's own pixels, where their penumbras are wide
 * (penumbra.h). */
#include "lightmesh/knower.h"

static bool penumbra_one_lamp(struct asking *asking, const struct lamp *lamp,
                              const struct lamp_view *view, rgb *share)
{
    const struct penumbras *penumbras = asking->knowers->penumbras;
    const struct receiver *receiver = &asking->receiver;
    return penumbras && receiver->pixel && asking->inside->count == 0 &&
           vec3_dot(view->direction, receiver->side) > 0 &&
           penumbras_share(penumbras, receiver, lamp, share);
}

const struct knower penumbra_knower = {
    .name = "penumbra",
    .help = "no shadow, or one that changes slowly over the pixels around",
    .one_lamp = penumbra_one_lamp,
};
