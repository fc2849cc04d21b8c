/* Scattering lobes: see lobes.h. The densities follow the finish's formulas:
 * Lambert and brilliance cos^b. */
#include "tracer/lobes.h"

#include "base/warp.h"
#include "shade/finish.h"

/* Lobes up to this power are as good as diffuse. */
static const double wide_most = 2;

static void lobes_add(struct lobes *lobes, vec3 axis, double power,
                      double share)
{
    if (!(share > 0) || !isfinite(share) || !(power >= 0) || !isfinite(power) ||
        lobes->count == LOBES_MAX)
        return;
    lobes->at[lobes->count++] = (struct lobe){ axis, power, share };
    lobes->total += share;
}

/* cos^b * d over cos^b (b + 1)/(2 pi), over pi: 2 d/(b + 1). */
static void lobes_add_diffuse(struct lobes *lobes,
                              const struct surface *surface,
                              const struct surface_layer *layer)
{
    const struct finish *finish = layer->finish;
    bool twice = surface->at->leaf->look->double_illuminate;
    double b = fmax(finish->brilliance, 0);
    double tone = rgb_peak(rgb_mul(layer->weight, colour_rgb(layer->pigment)));
    tone *= fabs(1 - layer->pigment.filter - layer->pigment.transmit);
    tone *= finish->diffuse_albedo ? 1 : 2 / (b + 1);
    double back = twice ? finish->diffuse : finish->diffuse_back;
    lobes_add(lobes, layer->normal, b, tone * fabs(finish->diffuse));
    lobes_add(lobes, vec3_negate(layer->normal), b, tone * fabs(back));
}

static void lobes_start(struct lobes *lobes)
{
    lobes->light = 0;
    lobes->count = 0;
    lobes->total = 0;
}

void lobes_fill(struct lobes *lobes, const struct surface *surface)
{
    lobes_start(lobes);
    for (int i = 0; i < surface->count; i++)
        lobes_add_diffuse(lobes, surface, &surface->layer[i]);
    for (int i = 0; i < lobes->count; i++)
        lobes->at[i].share /= lobes->total;
}

void lobes_fill_plate(struct lobes *lobes, vec3 normal)
{
    lobes_start(lobes);
    lobes_add(lobes, normal, 1, 1);
}

void lobes_guide(struct lobes *lobes, const struct guide *guide, vec3 point,
                 vec3 normal, bool lit)
{
    struct guide_aim aim;
    double wide = 0, sum = 0;
    if (!guide)
        return;
    guide_look(guide, point, normal, lit, &aim);
    lobes->light = aim.light;
    if (aim.count == 0)
        return;
    for (int i = 0; i < lobes->count; i++)
        if (lobes->at[i].power <= wide_most)
            wide += lobes->at[i].share;
    for (int i = 0; i < aim.count; i++)
        sum += aim.at[i].chance;
    for (int i = 0; i < lobes->count; i++)
        lobes->at[i].share *= 1 - wide * sum;
    for (int i = 0; i < aim.count && lobes->count < LOBES_MAX; i++)
        lobes->at[lobes->count++] =
            (struct lobe){ aim.at[i].axis, aim.at[i].power,
                           wide * aim.at[i].chance };
}

vec3 lobes_sample(const struct lobes *lobes, double which, const double u[2])
{
    int i = 0;
    for (; i < lobes->count - 1 && which >= lobes->at[i].share; i++)
        which -= lobes->at[i].share;
    return vec3_normalise(warp_lobe(u, lobes->at[i].axis, lobes->at[i].power));
}

double lobes_density(const struct lobes *lobes, vec3 direction)
{
    double sum = 0;
    for (int i = 0; i < lobes->count; i++)
        sum += lobes->at[i].share *
               warp_lobe_density(vec3_dot(lobes->at[i].axis, direction),
                                 lobes->at[i].power);
    return sum;
}

rgb surface_response(const struct surface *surface, vec3 direction,
                     bool highlights)
{
    struct light_sample sample = { direction, { 1, 1, 1 }, highlights };
    rgb sum = rgb_grey(0);
    surface_add_light(surface, &sample, &sum);
    return sum;
}
