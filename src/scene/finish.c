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

int finish_spreads(const struct finish *finish,
                   struct finish_spread spreads[FINISH_ITEMS])
{
    int count = 0;
    for (int i = 0; i < FINISH_ITEMS; i++) {
        const struct finish_item *item = items[i];
        const void *said = item->spread
                               ? finish_part(finish, item, (enum finish_place)i)
                               : NULL;
        if (said)
            spreads[count++] = item->spread(said);
    }
    return count;
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
