/* How many rays a point sends: see plan_rays.h. */
#include "lightmesh/plan_rays.h"

#include <math.h>

#include "lightmesh/tuning.h"

double plan_finer(const struct light_mesh_settings *said)
{
    double quality = said->quality > 0 ? said->quality : quality_usual;
    return pow(quality_step, quality - quality_usual);
}

/* Powers of two, so that what asks for a few more rays or less, as the next
 * picture of an animation does, has as many [flicker: twice as much at the
 * median with multiples of four]. */
int rays_within(double rays)
{
    int within = GATHER_LEAST;
    while (2 * within <= rays)
        within *= 2;
    return within;
}

/* In a chamber: of a picture that is one of many, which ask so many `times` as
 * much, less. */
static double noise_for(int times)
{
    return times > 1 ? chamber_noise_animated : chamber_noise;
}

/* How many make so much noise of what differs by so much. */
static double rays_for(double rough, double noise)
{
    return pow(rough / noise, gather_net);
}

/* As many gather rays of a point as make noise that is hardly seen, for what
 * they bring differs less where lamps give most of the light; none where that
 * changes nothing. Where a chamber would want many, few find out where to look
 * more closely (way_cells.h). What moves there changes the light of all walls:
 * in an animation noise that isn't seen in one picture is, and so many `times`
 * more are sent. */
int plan_samples(const struct light_mesh_settings *said,
                 const struct survey *survey, int times)
{
    double finer = plan_finer(said);
    double wanted = rays_for(survey->rough,
                             survey->closed ? noise_for(times) : gather_noise);
    if (said->indirect.samples > 0)
        return said->indirect.samples;
    if (survey->worth < gather_worth_none)
        return 0;
    wanted = fmin(fmax(wanted, survey->closed ? CHAMBER_LEAST : GATHER_LEAST),
                  GATHER_MOST);
    if (survey->closed && rays_within(sqrt(2) * wanted) > CHAMBER_WAYS)
        wanted = CHAMBER_WAYS;
    return rays_within(sqrt(2) * times * wanted * finer *
                       finer); /* the nearest */
}

/* As many as make noise that is hardly seen, likewise. */
static int picks_for(const struct light_mesh_settings *said, double rough,
                     int most, int times)
{
    double finer = plan_finer(said), wanted = rays_for(rough, noise_for(times));
    wanted = fmin(fmax(wanted, PICKS_LEAST), most) * times * finer * finer;
    return rays_within(sqrt(2) * fmin(wanted, VIRTUAL_PICKS_USUAL));
}

int plan_picks(const struct light_mesh_settings *said,
               const struct survey *survey, int times)
{
    return survey->lit.count > 0
               ? picks_for(said, survey->picked, VIRTUAL_PICKS, times)
               : 0;
}

int plan_glow_picks(const struct light_mesh_settings *said,
                    const struct survey *survey, int times)
{
    return survey->glows > 0 ? picks_for(said, survey->glows, GLOW_PICKS, times)
                             : 0;
}

int plan_near_rays(const struct light_mesh_settings *said, int usual)
{
    return (int)ceil(plan_finer(said) * plan_finer(said) * usual);
}

int plan_lone_rays(const struct light_mesh_settings *said,
                   const struct survey *survey, bool film)
{
    const bool few = !film && survey->worth < near_worth;
    return plan_near_rays(said, few ? NEAR_LONE_FEW : NEAR_LONE_RAYS);
}

/* Share of what the camera sees that has much close to it, as mesh points are
 * apart there. */
static double survey_crevices(const struct survey *survey,
                              const struct lattice *lattice,
                              const struct lattice_view *view)
{
    int deep = 0;
    for (int i = 0; i < survey->sights; i++) {
        const struct survey_sight *sight = &survey->sight[i];
        deep +=
            sight->half <
            near_field_reach * lattice_spacing_at(lattice, view, sight->place);
    }
    return survey->sights > 0 ? (double)deep / survey->sights : 0;
}

/* In whole packets, if there are more than one. */
struct plan_own plan_own_rays(const struct light_mesh_settings *said,
                              const struct survey *survey,
                              const struct lattice *lattice,
                              const struct lattice_view *view, bool film)
{
    const double finer = plan_finer(said) * plan_finer(said),
                 share = survey_crevices(survey, lattice, view),
                 most = own_usual *
                        (film ? 1 : fmin(survey->worth / own_worth, 1)),
                 rays = NEAR_OWN_RAYS * finer * fmin(most / share, 1),
                 worth = rays / NEAR_OWN_LEAST - 1;
    const double whole = rays > RAY_LANES ? RAY_LANES : 1;
    return worth > 0 ? (struct plan_own){ (int)(round(rays / whole) * whole),
                                          fmin(2 * worth, 1) }
                     : (struct plan_own){ 0, 0 };
}
