/* Decisions: see plan.h. */
#include "lightmesh/plan.h"

#include "base/warp.h"
#include "lightmesh/gatherer.h"
#include "lightmesh/light_tree.h"
#include "lightmesh/obstacles.h"
#include "lightmesh/plan_rays.h"
#include "lightmesh/tuning.h"
#include "shade/surface.h"

/* Gathered light differs from point to point by chance, which lamps' doesn't:
 * unless the scene says another it is evened out. */
static const char gathered_interpolation[] = "smooth";

static struct lattice frame_lattice(const struct mesh_frame *frame)
{
    return (struct lattice){ .spacing = frame->spacing, .near = frame->near };
}

/* Shadows may be as fine as pixels; what surfaces give each other is as smooth
 * as their distances are large, however large the picture is. A plane that goes
 * to the horizon is no reason to be coarse before it. */
static double frame_gather(const struct light_mesh_settings *said,
                           const struct outlook *outlook, double spacing)
{
    double size = fmin(outlook->size, gather_across * outlook->across);
    if (said->density > 0)
        return spacing;
    return fmax(spacing, size / (indirect_cells * plan_finer(said)));
}

/* What two ways of a point may differ by: see way_cells.h. */
static double frame_edge(const struct mesh_frame *frame, double finer)
{
    bool bright = frame->bright.count > 0;
    uint32_t ways = gatherer_everywhere((uint32_t)frame->samples, bright);
    return ways <= frame->edged * finer * finer ? gather_edge : 0;
}

struct mesh_frame plan_frame(const struct scene *scene,
                             const struct outlook *outlook,
                             const struct survey *survey, enum plan_film film,
                             int coarser)
{
    const struct light_mesh_settings *said = &scene->settings.light_mesh;
    const bool often = survey->closed && film != PLAN_ALONE;
    int times = often ? CHAMBER_ANIMATED : 1,
        rays = often && film == PLAN_SMOOTHED ? CHAMBER_SMOOTHED : times;
    int samples = plan_samples(said, survey, rays);
    double spacing = spacing_pixels * outlook->pixel;
    spacing = fmin(fmax(spacing, outlook->size / spacing_cells_most),
                   outlook->size / spacing_cells_least);
    spacing /= plan_finer(said);
    if (said->density > 0)
        spacing = 1 / said->density;
    return (struct mesh_frame){
        .spacing = spacing * pow(spacing_coarser, coarser),
        .wanted = spacing,
        .near = 2 * outlook->distance,
        .eye = scene->camera.location,
        .centre = outlook->centre,
        .size = outlook->size,
        .gather = frame_gather(said, outlook, spacing) *
                  pow(spacing_coarser, coarser),
        .samples = samples,
        .asked = samples,
        .picks = plan_picks(said, survey, times),
        .glow_picks = plan_glow_picks(said, survey, times),
        .edged = survey->closed ? rays * CHAMBER_WAYS : 0,
        .closed = survey->closed,
        .around = survey->around,
        .lit = survey->lit,
        .bright = survey->bright,
    };
}

/* Levels between spacings, so many of which are none. */
static double levels_between(double made, double now, double none)
{
    double levels = log2(now / made);
    return copysign(fmax(fabs(levels) - none, 0), levels);
}

struct plan_levels plan_levels(const struct mesh_frame *made,
                               const struct mesh_frame *now)
{
    double levels = levels_between(made->wanted, now->wanted, kept_levels);
    return (struct plan_levels){ levels, levels };
}

bool plan_follow(struct mesh_frame *frame, const struct mesh_frame *root,
                 struct plan_levels *levels)
{
    const struct mesh_frame own = *frame;
    const struct plan_levels asked = {
        levels_between(root->wanted, own.wanted, follow_levels),
        levels_between(root->gather, own.gather, follow_levels),
    };
    if (own.closed != root->closed ||
        (own.samples > 0) != (root->samples > 0) ||
        (own.bright.count > 0) != (root->bright.count > 0) ||
        (own.lit.count > 0) != (root->lit.count > 0) ||
        !(fabs(asked.direct) <= KEPT_LEVELS) ||
        !(fabs(asked.indirect) <= KEPT_LEVELS))
        return false;
    *frame = *root;
    frame->bright = own.bright;
    frame->lit = own.lit;
    frame->around = own.around;
    *levels = asked;
    return true;
}

/* Rays that bring much the same are fewer, so that there may be more of others:
 * a factor. */
static double plan_rough(const struct survey *survey)
{
    return fmin(fmax(survey->rough / gather_rough, gather_rough_least),
                gather_rough_most);
}

/* How far light is so rough that fewer rays are seen where most of the picture
 * is gathered: 0 to 1. Where it is smooth no eye sees the difference [POV-Ray's
 * table of colours]. */
static double survey_uneven(const struct survey *survey)
{
    return fmin(fmax((survey->rough - mostly_smooth) / mostly_rough, 0), 1);
}

/* What is gathered is so much of the picture, and seen, that it gets more rays:
 * 0 to 1. Of a film all is. */
static double plan_mostly(const struct survey *survey, double worth, bool film)
{
    double seen = film ? 1 : survey_uneven(survey);
    return seen * fmin(fmax(worth - gather_mostly, 0), 1);
}

/* The more light comes from surfaces the more of the picture depends on it: all
 * of it in a chamber, of which a small picture shows as much as a large one.
 * What is half open needs no more than what is open usually has, since its
 * bounces are ended. */
static double plan_rays(const struct light_mesh_settings *said,
                        const struct survey *survey, double pixels, bool film)
{
    double finer = plan_finer(said),
           edges = sqrt(fmax(pixels, gather_pixels) * gather_pixels);
    bool chamber = survey->open < open_enough;
    double worth = chamber ? survey->worth : survey->bounced;
    double each = gather_pixel + gather_pixel_worth * worth;
    if (each > gather_pixel_most || (survey->closed && !chamber))
        each = gather_pixel_most;
    if (!survey->closed)
        each += gather_pixel_mostly * plan_mostly(survey, worth, film);
    each *= chamber ? gather_chamber : plan_rough(survey);
    return each * edges * finer * finer;
}

/* What a gather ray costs in the open, in rays: what it meets asks lamps, may
 * send another, and is shaded. None is spared for it where what is gathered is
 * the picture, and rough [gap, POV-Ray's patio]. */
static double plan_sent(const struct survey *survey)
{
    const double more = fmax(survey->sent - 1, 0);
    const bool most =
        survey->worth > gather_most && survey_uneven(survey) > 0.5;
    return survey->closed || most ? 1 : 1 + gather_shaded * more;
}

/* What a point costs, in rays: it looks around as well. */
static double frame_rays(const struct mesh_frame *frame, double sent)
{
    return sent * frame->samples + frame->picks + OBSTACLE_DIRECTIONS;
}

/* No more rays of a point than that, but `least` if it had so many. */
static void frame_ask(struct mesh_frame *frame, double sent, double rays,
                      int least)
{
    double own = frame->picks + OBSTACLE_DIRECTIONS;
    int fewer = rays_within(fmax((rays - own) / sent, least));
    if (fewer < frame->samples)
        frame->samples = fewer;
}

bool plan_afford(struct mesh_frame *frame, const struct scene *scene,
                 const struct survey *survey, double points, double pixels,
                 bool film)
{
    const struct light_mesh_settings *said = &scene->settings.light_mesh;
    double most = plan_rays(said, survey, pixels, film);
    double sent = film ? 1 : plan_sent(survey);
    if (frame->samples == 0 || said->indirect.samples > 0 ||
        said->density > 0 || points * frame_rays(frame, sent) <= most)
        return false;
    /* Neighbours share directions: fewer rays blur less than fewer points, but
     * where light is rough noise is seen before blur is. */
    const bool rough =
        survey->rough > (film ? 1 : gather_few_rough) * survey->worth;
    frame_ask(frame, sent, most / points, rough ? 2 * GATHER_FEW : GATHER_FEW);
    double crowd = sqrt(points * frame_rays(frame, sent) / most);
    double factor = fmin(fmax(crowd, 1), gather_coarser_most);
    frame->gather *= factor;
    /* Else as many rays as there are fit exactly, but for rounding. */
    if (crowd > factor)
        frame_ask(frame, sent, most * factor * factor / points, GATHER_LEAST);
    return true;
}

enum mesh_shadows plan_held(const struct light_mesh_settings *said,
                            size_t lamps)
{
    return lamps > FEW_LAMPS && said->shadows == MESH_SHADOWS_SHARP
               ? MESH_SHADOWS_SHARP
               : MESH_SHADOWS_SOFT;
}

/* Whether it was said what the points in space are to be, or where they go or
 * come from: then they light the picture. */
static bool mesh_is_said(const struct light_mesh_settings *said)
{
    return said->shadows != MESH_SHADOWS_AUTO || said->density > 0 ||
           said->radius > 0 || said->levels > 0 || said->threshold > 0 ||
           said->regions.count > 0 || said->save_file || said->load_file;
}

/* Whether a place has to do with few lamps, all in all, `most` of them: a
 * spotlight counts by the share of a half space that it lights. */
static bool lamps_are_few(const struct lamps *lamps, double most)
{
    double felt = 0;
    for (size_t i = 0; i < lamps->count; i++) {
        const struct light *light = lamps->items[i].light;
        double edge = fmin(light->falloff, 90) * WARP_PI / 180;
        felt += light->kind == LIGHT_SPOT ? 1 - cos(edge) : 1;
    }
    return felt <= most && lamps->count <= SPOTS_MOST;
}

static enum plan_lamps plan_lamps(const struct scene *scene,
                                  const struct lamps *asked)
{
    const struct light_mesh_settings *said = &scene->settings.light_mesh;
    bool sharp = said->shadows == MESH_SHADOWS_SHARP;
    size_t lamps = asked->count;
    if (said->shadows == MESH_SHADOWS_AUTO &&
        lamps_are_few(asked, mesh_is_said(said) ? FEW_LAMPS : EACH_LAMPS))
        return PLAN_EACH;
    if (lamps > (sharp ? SHARP_LAMPS : FEW_LAMPS))
        return PLAN_SUMMED;
    if (said->shadows == MESH_SHADOWS_SOFT)
        return PLAN_BLENDED;
    return lamps > FEW_LAMPS ? PLAN_SETTLED : PLAN_EACH;
}

/* Levels are none unless they, or a threshold, are said. */
static struct refinement plan_refinement(const struct light_mesh_settings *said)
{
    int levels = said->threshold > 0 ? ADAPTIVE_LEVELS : 0;
    return (struct refinement){
        .levels = said->levels > 0 ? said->levels : levels,
        .threshold = said->threshold > 0 ? said->threshold : adaptive_threshold,
    };
}

/* Lamps that a point asks. The more lamps, the more rays a mesh saves: part of
 * that is given back to be right. */
static int plan_budget(double finer, size_t lamps)
{
    int budget = (int)(LAMP_BUDGET * finer);
    double more = fmin(fmax((double)lamps / BUDGET_LAMPS, 1), BUDGET_MOST);
    return (int)(more * budget);
}

static void plan_direct(struct plan *plan,
                        const struct light_mesh_settings *said,
                        const struct lamps *lamps,
                        const struct interpolation *interpolation)
{
    const struct mesh_frame *frame = &plan->frame;
    bool many = plan->lamps == PLAN_SUMMED;
    plan->direct = (struct direct_options){
        .lattice = frame_lattice(frame),
        .view = { .eye = frame->eye },
        .interpolation = interpolation,
        .radius = said->radius / frame->spacing,
        .refinement = plan_refinement(said),
        .many = many,
        .surfaces = many && interpolation == interpolation_at(0),
        .budget = plan_budget(plan->finer, lamps->count),
        .centre = frame->centre,
        .size = frame->size,
        .bytes = MESH_BYTES - (said->indirect.on ? INDIRECT_BYTES : 0),
    };
    lattice_set_regions(&plan->direct.lattice, said->regions.items,
                        said->regions.count);
    lattice_make_finer(&plan->direct.lattice,
                       plan->direct.refinement.levels + KEPT_LEVELS);
}

static void plan_indirect(struct plan *plan,
                          const struct light_mesh_settings *said,
                          gather_close *close, const void *close_context)
{
    const struct direct_options *direct = &plan->direct;
    const struct mesh_frame *frame = &plan->frame;
    int usual = close ? CLOSED_BOUNCES : BOUNCES;
    int bounces = said->indirect.bounces;
    if (!frame->closed)
        usual = OPEN_BOUNCES; /* the rest by further rays */
    plan->indirect = (struct indirect_options){
        .lattice = direct->lattice,
        .view = { .eye = frame->eye },
        .interpolation = said->interpolation
                             ? direct->interpolation
                             : interpolation_find(gathered_interpolation),
        .radius = direct->radius,
        .refinement = direct->refinement,
        .bounces = bounces > 0 ? (int)fmin(bounces, BOUNCES_MAX) : usual,
        .samples = frame->samples,
        .edge = frame_edge(frame, plan->finer),
        .near = plan_near_rays(said, NEAR_RAYS),
        .near_more = plan_near_rays(said, NEAR_MORE_RAYS),
        .bytes = INDIRECT_BYTES,
        .close = close,
        .close_context = close_context,
        .tone = said->indirect.tone,
    };
    if (!said->indirect.dark && !close)
        plan->indirect.around = frame->around;
    plan->indirect.closed = frame->closed;
    plan->indirect.onward = (close || !frame->closed) && !said->indirect.dark;
    plan->indirect.lattice.spacing *= frame->gather / frame->spacing;
}

struct plan plan_new(const struct scene *scene, const struct lamps *lamps,
                     const struct mesh_frame *frame,
                     const struct interpolation *interpolation,
                     gather_close *close, const void *close_context)
{
    const struct light_mesh_settings *said = &scene->settings.light_mesh;
    struct plan plan = {
        .lamps = plan_lamps(scene, lamps),
        .finer = plan_finer(said),
        .frame = *frame,
    };
    plan_direct(&plan, said, lamps, interpolation);
    bool asks = plan.lamps == PLAN_EACH ||
                (plan.direct.surfaces && !mesh_is_said(said));
    plan.pixels = asks && lamps->quality >= QUALITY_SHADOWS;
    plan.penumbras =
        plan.lamps == PLAN_EACH && lamps->quality >= QUALITY_AREA_LIGHTS;
    if (said->indirect.on && frame->samples > 0)
        plan_indirect(&plan, said, close, close_context);
    return plan;
}

void plan_tell(const struct plan *plan, plan_row *row, void *context)
{
    static const char *const lamps[] = {
        [PLAN_EACH] = "each by shadow rays",
        [PLAN_BLENDED] = "each at mesh points",
        [PLAN_SETTLED] = "by rays where mesh points differ",
        [PLAN_SUMMED] = "summed at mesh points",
    };
    const struct lattice *direct = &plan->direct.lattice;
    const struct lattice *indirect = &plan->indirect.lattice;
    row(context, "plan lamps", (double)NAN, lamps[plan->lamps]);
    if (plan->lamps == PLAN_SUMMED)
        row(context, "plan lamps asked", plan->direct.budget, "");
    if (plan->lamps != PLAN_EACH)
        row(context, "plan spacing", lattice_spacing(direct, direct->usual),
            "units");
    if (plan->indirect.bounces == 0)
        return;
    row(context, "plan bounces", plan->indirect.bounces, "");
    row(context, "plan ends in", (double)NAN,
        plan->indirect.close    ? "the skeleton's light"
        : plan->indirect.onward ? "further rays"
                                : "what is usual");
    row(context, "plan gather rays", plan->indirect.samples, "");
    if (plan->frame.picks > 0)
        row(context, "plan virtual lights", plan->frame.picks, "");
    if (plan->frame.glow_picks > 0)
        row(context, "plan rays to what glows", plan->frame.glow_picks, "");
    row(context, "plan gather step", lattice_spacing(indirect, indirect->usual),
        "units");
}
