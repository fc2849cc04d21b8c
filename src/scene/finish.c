/* The finish and the list of its items: see finish.h. */
#include "scene/finish.h"

#include "base/listing.h"

static const struct finish_item *const items[] = {
#define X(name, role) &name##_finish,
#include "scene/finish/list.h"
#undef X
};

LISTING(finish_item, finish_item, items);

const struct field *finish_field(const char *word, enum finish_place *place)
{
    for (int i = 0; i < FINISH_ITEMS; i++) {
        const struct field *field = field_find(items[i]->fields, word);
        *place = (enum finish_place)i;
        if (field)
            return field;
    }
    return NULL;
}

double finish_highlight(const struct finish *finish,
                        const struct finish_meeting *meeting)
{
    double share = 0;
    const void *said;
#define ADD(name)                                                              \
    said = finish_part(finish, &name##_finish, FINISH_PLACE_##name);           \
    if (said)                                                                  \
        share += name##_finish.highlight(said, meeting);
#define X(name, role) FINISH_HIGHLIGHT_##role(ADD, name)
#include "scene/finish/list.h"
#undef X
    return share;
}

/* An item's, as it says, added to what others give. */
static void add_highlights(const struct finish_item *item, const void *said,
                           const struct finish_meetings *meetings,
                           unsigned lanes, double shares[RAY_LANES])
{
    LANE_LINES double more[RAY_LANES];
    if (item->highlight_many) {
        item->highlight_many(said, meetings, more);
        for (int i = 0; i < RAY_LANES; i++)
            shares[i] += more[i];
        return;
    }
    for (; lanes; lanes &= lanes - 1) {
        unsigned i = (unsigned)__builtin_ctz(lanes);
        const struct finish_meeting meeting = finish_meeting_at(meetings, i);
        shares[i] += item->highlight(said, &meeting);
    }
}

void finish_highlight_many(const struct finish *finish,
                           const struct finish_meetings *meetings,
                           unsigned lanes, double shares[RAY_LANES])
{
    const void *said;
    for (int i = 0; i < RAY_LANES; i++)
        shares[i] = 0;
#define ADD_MANY(name)                                                         \
    said = finish_part(finish, &name##_finish, FINISH_PLACE_##name);           \
    if (said)                                                                  \
        add_highlights(&name##_finish, said, meetings, lanes, shares);
#define X(name, role) FINISH_HIGHLIGHT_##role(ADD_MANY, name)
#include "scene/finish/list.h"
#undef X
}

CLONES static void lobes_whole(const double *restrict cosines, double size,
                               double amount, double *restrict lobes)
{
    LANE_LINES double power[RAY_LANES];
    for (int i = 0; i < RAY_LANES; i++) {
        lobes[i] = 1;
        power[i] = cosines[i];
    }
    for (unsigned left = (unsigned)size; left; left >>= 1) {
        if (left & 1)
            for (int i = 0; i < RAY_LANES; i++)
                lobes[i] *= power[i];
        for (int i = 0; i < RAY_LANES; i++)
            power[i] *= power[i];
    }
    for (int i = 0; i < RAY_LANES; i++) {
        bool none = !(cosines[i] > 0) | (size * (1 - cosines[i]) > 24);
        lobes[i] = none ? 0 : amount * lobes[i];
    }
}

void finish_lobes(const double cosines[RAY_LANES], double size, double amount,
                  double lobes[RAY_LANES])
{
    if (power_is_whole(size)) {
        lobes_whole(cosines, size, amount, lobes);
        return;
    }
    for (int i = 0; i < RAY_LANES; i++)
        lobes[i] = cosines[i] > 0 ? amount * finish_lobe(cosines[i], size) : 0;
}

rgb finish_tint(const struct finish *finish, vec3 point, double lamp,
                double viewer)
{
    rgb tint = rgb_grey(1);
    const void *said;
#define MULTIPLY(name)                                                         \
    said = finish_part(finish, &name##_finish, FINISH_PLACE_##name);           \
    if (said)                                                                  \
        tint = rgb_mul(tint, name##_finish.tint(said, point, lamp, viewer));
#define X(name, role) FINISH_TINT_##role(MULTIPLY, name)
#include "scene/finish/list.h"
#undef X
    return tint;
}

struct finish finish_default(void)
{
    return (struct finish){
        .ambient = { 0.1, 0.1, 0.1 },
        .diffuse = 0.6,
        .returned_most = RETURNED_MOST,
        .brilliance = 1,
        .phong_size = 40,
        .roughness = 0.05,
        .reflection = { .falloff = 1, .exponent = 1 },
    };
}

bool finish_is_to_glow(const struct finish *finish, rgb ambient_light)
{
    double ambient = rgb_peak(rgb_mul(finish->ambient, ambient_light));
    return ambient > rgb_peak(finish_default().ambient) &&
           ambient > 0.5 * finish->diffuse;
}
