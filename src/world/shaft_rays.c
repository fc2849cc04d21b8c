/* Rays in a shaft: see shaft.h. */
#include "scene/primitive.h"
#include "world/packet.h"
#include "world/shaft.h"

bool shaft_hides(const struct shaft *shaft, const double place[2],
                 const struct ray *ray, double tmin, double tmax)
{
    for (int i = 0; i < shaft->count; i++)
        if (shaft_shades(&shaft->at[i], place) &&
            solid_crosses(shaft->at[i].solid, ray, tmin, tmax))
            return true;
    return false;
}

CLONES static void find_shaded(const struct shaft_solid *restrict solid,
                               const double (*restrict place)[RAY_LANES],
                               lane_flag *restrict shaded)
{
    for (int i = 0; i < RAY_LANES; i++) {
        bool low =
            (place[0][i] >= solid->low[0]) & (place[1][i] >= solid->low[1]);
        bool high =
            (place[0][i] <= solid->high[0]) & (place[1][i] <= solid->high[1]);
        shaded[i] = (low & high) ? -1 : 0;
    }
}

/* Which rays may meet the solid. */
static unsigned solid_shaded(const struct shaft_solid *solid,
                             const double (*place)[RAY_LANES])
{
    LANE_LINES lane_flag shaded[RAY_LANES];
    find_shaded(solid, place, shaded);
    return rays_bits(shaded);
}

unsigned shaft_shaded_many(const struct shaft *shaft,
                           const double (*place)[RAY_LANES])
{
    unsigned shaded = 0;
    if (shaft->crowded)
        return (1u << RAY_LANES) - 1;
    for (int i = 0; i < shaft->count; i++)
        shaded |= solid_shaded(&shaft->at[i], place);
    return shaded;
}

unsigned shaft_hides_many(const struct shaft *shaft,
                          const double (*place)[RAY_LANES],
                          const struct rays *rays, const struct rays_span *span,
                          unsigned lanes)
{
    unsigned hidden = 0;
    for (int i = 0; i < shaft->count && lanes & ~hidden; i++) {
        const struct shaft_solid *at = &shaft->at[i];
        unsigned asked = lanes & ~hidden & solid_shaded(at, place);
        if (asked)
            hidden |= solid_crosses_many(at->solid, rays, span, asked);
    }
    return hidden;
}

void shaft_look(const struct shaft *shaft, const double (*place)[RAY_LANES],
                struct packet *packet)
{
    for (int i = 0; i < shaft->count; i++) {
        const struct shaft_solid *at = &shaft->at[i];
        unsigned lanes = packet->open & solid_shaded(at, place);
        if (packet_look(packet, at->solid, lanes))
            return;
    }
}
