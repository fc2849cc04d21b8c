/* Where on its way through media a ray is in the cones of lights: POV-Ray
 * samples each lit stretch by itself (measured), so that the edges of beams are
 * met exactly. */
#include "shade/lamps.h"
#include "shade/media.h"

/* From the lamp, as its cone is told by. */
static bool beam_holds(const struct lamp *lamp, vec3 offset)
{
    double along = vec3_dot(offset, lamp->axis);
    double square = vec3_dot(offset, offset);
    if (along <= 0)
        return false;
    if (lamp->light->kind == LIGHT_CYLINDER)
        return square - along * along <=
               lamp->light->falloff * lamp->light->falloff;
    return along >= lamp->cosine_falloff * sqrt(square);
}

/* Where the way meets the cone or cylinder, if anywhere: along^2 s - square c
 * = f, with along and square of first and second degree. */
static int beam_roots(const struct lamp *lamp, const struct media_way *way,
                      double roots[2])
{
    bool tube = lamp->light->kind == LIGHT_CYLINDER;
    vec3 offset = vec3_sub(way->origin, lamp->light->location);
    double s = 1;
    double c = tube ? 1 : lamp->cosine_falloff * lamp->cosine_falloff;
    double f = tube ? -lamp->light->falloff * lamp->light->falloff : 0;
    double o = vec3_dot(offset, lamp->axis);
    double d = vec3_dot(way->direction, lamp->axis);
    double a = s * d * d - c * vec3_dot(way->direction, way->direction);
    double b = s * o * d - c * vec3_dot(offset, way->direction);
    double rest = s * o * o - c * vec3_dot(offset, offset) - f;
    double discriminant = b * b - a * rest;
    if (!(discriminant > 0))
        return 0;
    /* Neither is a difference of what is nearly alike; along the cone's own
     * side one is endlessly far away. */
    double sum = -b - copysign(sqrt(discriminant), b);
    double one = sum / a, other = rest / sum;
    roots[0] = fmin(one, other);
    roots[1] = fmax(one, other);
    return 2;
}

/* The stretch in the lamp's beam, which is convex; false if there is none. */
static bool beam_stretch(const struct lamp *lamp, const struct media_way *way,
                         double *from, double *to)
{
    double roots[2], cuts[4] = { 0 };
    int count = 1, found = beam_roots(lamp, way, roots);
    vec3 offset = vec3_sub(way->origin, lamp->light->location);
    bool any = false;
    for (int i = 0; i < found; i++)
        if (roots[i] > 0 && roots[i] < way->length)
            cuts[count++] = roots[i];
    cuts[count++] = way->length;
    for (int i = 0; i + 1 < count; i++) {
        double middle = (cuts[i] + cuts[i + 1]) / 2;
        if (!beam_holds(lamp, vec3_along(offset, way->direction, middle)))
            continue;
        *from = any ? *from : cuts[i];
        *to = cuts[i + 1];
        any = true;
    }
    return any;
}

static bool lamp_is_beam(const struct lamp *lamp)
{
    return lamp->light->kind == LIGHT_CYLINDER ||
           (lamp->light->kind == LIGHT_SPOT && lamp->cosine_falloff > 0);
}

/* Adds a lit stretch to those there are, in order, joined where they meet. */
static int lit_add(struct media_part *lit, int count, double from, double to)
{
    int kept = 0;
    for (int i = 0; i < count; i++) {
        if (lit[i].to < from || lit[i].from > to) {
            lit[kept++] = lit[i];
            continue;
        }
        from = fmin(from, lit[i].from);
        to = fmax(to, lit[i].to);
    }
    int at = kept++;
    for (; at > 0 && lit[at - 1].from > from; at--)
        lit[at] = lit[at - 1];
    lit[at] = (struct media_part){ from, to, true };
    return kept;
}

/* The way's own ends are none of the beam's; its edges are by so much farther
 * out as rounding may be off. */
static void beams_add(struct media_beams *beams, const struct lamp *lamp,
                      double from, double to, double length)
{
    const double margin = 1e-9;
    if (beams->count == MEDIA_BEAMS_MAX)
        beams->count = -1;
    if (beams->count < 0)
        return;
    struct media_beam *beam = &beams->at[beams->count++];
    beam->lamp = lamp;
    beam->from = from > 0 ? from - margin * (1 + from) : -HUGE_VAL;
    beam->to = to < length ? to + margin * (1 + to) : HUGE_VAL;
}

static int lit_find(const struct media_way *way, struct media_beams *beams,
                    struct media_part *lit)
{
    int count = 0;
    for (size_t i = 0; i < way->lamps->count; i++) {
        const struct lamp *lamp = &way->lamps->items[i];
        double from = 0, to = way->length;
        if (!lamp_is_for_media(lamp, way->end))
            continue;
        if (lamp_is_beam(lamp) && !beam_stretch(lamp, way, &from, &to))
            continue;
        beams_add(beams, lamp, from, to, way->length);
        /* Too many: none is told from the others. */
        if (count >= MEDIA_PARTS_MAX / 2 - 1)
            from = 0, to = way->length;
        count = lit_add(lit, count, from, to);
    }
    return count;
}

int media_parts(const struct media_way *way, struct media_beams *beams,
                struct media_part parts[MEDIA_PARTS_MAX])
{
    struct media_part lit[MEDIA_PARTS_MAX / 2];
    double from = 0;
    int count = 0, lights = 0;
    beams->count = 0;
    if (way->lamps && way->media->scatters)
        lights = lit_find(way, beams, lit);
    for (int i = 0; i < lights; i++) {
        if (lit[i].from > from)
            parts[count++] = (struct media_part){ from, lit[i].from, false };
        parts[count++] = lit[i];
        from = lit[i].to;
    }
    if (from < way->length)
        parts[count++] = (struct media_part){ from, way->length, false };
    return count;
}
