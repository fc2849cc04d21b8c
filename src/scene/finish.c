/* The finish and the list of its items: see finish.h. */
#include "scene/finish.h"

#include "base/listing.h"

#define X(name, role) extern const struct finish_item name##_finish;
#include "scene/finish/list.h"
#undef X

static const struct finish_item *const items[] = {
#define X(name, role) &name##_finish,
#include "scene/finish/list.h"
#undef X
};

LISTING(finish_item, finish_item, items);

/* Those of one role: what is asked for each lamp should not ask the others. */
struct finish_part {
    const struct finish_item *item;
    enum finish_place place;
};

#define PART(name) { &name##_finish, FINISH_PLACE_##name },
#define NO_PART(name)

static const struct finish_part highlights[] = {
#define HIGHLIGHTS_highlight PART
#define HIGHLIGHTS_tint      NO_PART
#define HIGHLIGHTS_plain     NO_PART
#define X(name, role)        HIGHLIGHTS_##role(name)
#include "scene/finish/list.h"
#undef X
};

static const struct finish_part tints[] = {
#define TINTS_highlight NO_PART
#define TINTS_tint      PART
#define TINTS_plain     NO_PART
#define X(name, role)   TINTS_##role(name)
#include "scene/finish/list.h"
#undef X
};

enum {
    HIGHLIGHTS = sizeof highlights / sizeof *highlights,
    TINTS = sizeof tints / sizeof *tints,
};

/* What the finish says of it, or NULL while it does nothing. */
static const void *part_said(const struct finish_part *part,
                             const struct finish *finish)
{
    const struct finish_item *item = part->item;
    const void *said = item->size ? finish->own[part->place] : finish;
    if (!said)
        return NULL;
    const double *amount = (const void *)((const char *)said + item->amount);
    return *amount != 0 ? said : NULL;
}

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

bool finish_shines(const struct finish *finish)
{
    for (int i = 0; i < HIGHLIGHTS; i++)
        if (part_said(&highlights[i], finish))
            return true;
    return false;
}

double finish_highlight(const struct finish *finish,
                        const struct finish_meeting *meeting)
{
    double share = 0;
    for (int i = 0; i < HIGHLIGHTS; i++) {
        const void *said = part_said(&highlights[i], finish);
        if (said)
            share += highlights[i].item->highlight(said, meeting);
    }
    return share;
}

int finish_spreads(const struct finish *finish,
                   struct finish_spread spreads[FINISH_ITEMS])
{
    int count = 0;
    for (int i = 0; i < HIGHLIGHTS; i++) {
        const void *said = part_said(&highlights[i], finish);
        if (said && highlights[i].item->spread)
            spreads[count++] = highlights[i].item->spread(said);
    }
    return count;
}

bool finish_tints(const struct finish *finish)
{
    for (int i = 0; i < TINTS; i++)
        if (part_said(&tints[i], finish))
            return true;
    return false;
}

rgb finish_tint(const struct finish *finish, vec3 point, double lamp,
                double viewer)
{
    rgb tint = rgb_grey(1);
    for (int i = 0; i < TINTS; i++) {
        const void *said = part_said(&tints[i], finish);
        if (said)
            tint =
                rgb_mul(tint, tints[i].item->tint(said, point, lamp, viewer));
    }
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
