/* Rays through media: see media.h. As POV-Ray 3.7 does it (measured with
 * densities that tell where they are looked up):
 * - The first of several media says how all are sampled, but for the number of
 *   intervals, which is the largest.
 * - Method 3 looks at s/2 + 2 places of each interval, for `samples s`: at 0,
 *   1/n, ... (n-1)/n of it. Each pair of neighbours stands for an equal piece;
 *   between them it looks at the middle, and between two of these three that
 *   differ by aa_threshold or more again, aa_level times at most. A piece's
 *   mean is (a + m + b) / 3; the light of a piece is dimmed by all pieces
 *   before it, not by itself.
 * - Methods 1 and 2 look at places at random, or in the middles of equal
 *   pieces, and go on at random until `variance` is met; light is dimmed up to
 *   its place.
 * - What nothing lights and has no densities is one interval.
 * - All that is scattered spreads by the mean of the phase functions, of media
 *   that scatter nothing too.
 * - Where photons are sent, their targets shadow media, whether photons stay
 *   in these or not.
 * - Shadow rays are sampled the same way. */
#include "shade/media.h"

#include <string.h>

#include "base/random.h"
#include "shade/lamps.h"
#include "shade/photon_map.h"
#include "shade/surface.h"

const double media_horizon = 2e10;

/* Less light than this comes through: the rest is not looked at. */
static const double media_dark = 1e-7;

/* At one place: light that is added, and what is lost, in a unit of length. */
struct media_sample {
    rgb light, depth;
};

static struct media_sample sample_mix(struct media_sample a, double share,
                                      struct media_sample b, double rest)
{
    return (struct media_sample){
        rgb_add(rgb_scale(a.light, share), rgb_scale(b.light, rest)),
        rgb_add(rgb_scale(a.depth, share), rgb_scale(b.depth, rest))
    };
}

void media_find(struct media_list *list, const struct media *everywhere,
                const struct interiors *inside)
{
    list->count = 0;
    list->scatters = false;
    if (!interiors_open(inside))
        return;
    for (int i = -1; i < inside->count; i++) {
        const struct interior *interior = i < 0 ? NULL : inside->at[i].interior;
        const struct media *media = i < 0      ? everywhere
                                    : interior ? &interior->media
                                               : NULL;
        for (size_t k = 0; media && k < media->count; k++) {
            if (list->count == MEDIA_MAX)
                return;
            list->at[list->count++] = media->items[k];
            list->scatters |= media->items[k]->phase != PHASE_NONE;
        }
    }
}

/* ---- one place ---- */

/* The mean of the media's phase functions. */
static double way_phase(const struct media_way *way, vec3 from)
{
    double phase = 0, cosine = vec3_dot(from, way->direction);
    for (int i = 0; i < way->media->count; i++)
        phase += medium_phase(way->media->at[i], cosine) / way->media->count;
    return phase;
}

/* The light of one lamp that is scattered to the viewer there. */
static rgb sample_lamp(const struct media_way *way, const struct lamp *lamp,
                       vec3 point, rgb scattered)
{
    const struct light *light = lamp->light;
    struct lamp_target target = { .point = point, .inside = way->inside };
    if (light->shadowless || light->no_media ||
        !lamp_look(lamp, light->location, point, &target.view))
        return rgb_grey(0);
    double phase = way_phase(way, target.view.direction);
    rgb arriving = lamps_share(way->lamps, lamp, way->worker, &target);
    arriving = rgb_mul(rgb_mul(arriving, light->colour), scattered);
    return rgb_scale(arriving, phase * target.view.attenuation);
}

/* What photons bring there. */
struct gathering {
    const struct media_way *way;
    rgb light;
};

static void gather_photon(void *context, const struct photon *photon,
                          rgb irradiance)
{
    struct gathering *gathering = context;
    double phase = way_phase(gathering->way, photon_unpack(photon->from));
    gathering->light = rgb_add_scaled(gathering->light, irradiance, phase);
}

static rgb sample_photons(const struct media_way *way, vec3 point)
{
    struct gathering gathering = { way, rgb_grey(0) };
    photon_map_visit_within(way->photons, way->worker, point, gather_photon,
                            &gathering);
    return gathering.light;
}

static struct media_sample media_sample(const struct media_way *way, double t,
                                        bool lit)
{
    struct media_sample sample = { rgb_grey(0), rgb_grey(0) };
    rgb scattered = rgb_grey(0);
    vec3 point = vec3_along(way->origin, way->direction, t);
    if (worker_stopped(way->worker))
        return sample;
    for (int i = 0; i < way->media->count; i++) {
        const struct medium *medium = way->media->at[i];
        rgb density = medium_density(medium, point);
        scattered = rgb_add(scattered, rgb_mul(medium->scattering, density));
        sample.depth =
            rgb_add(sample.depth, rgb_mul(medium_extinction(medium), density));
        if (way->lamps)
            sample.light =
                rgb_add(sample.light, rgb_mul(medium->emission, density));
    }
    if (way->photons && !rgb_is_black(scattered))
        sample.light = rgb_add(sample.light,
                               rgb_mul(scattered, sample_photons(way, point)));
    lit = lit && !rgb_is_black(scattered);
    for (size_t i = 0; lit && i < way->lamps->count; i++)
        sample.light =
            rgb_add(sample.light,
                    sample_lamp(way, &way->lamps->items[i], point, scattered));
    return sample;
}

/* ---- an interval ---- */

/* The way so far, and the interval that is next. */
struct march {
    const struct media_way *way;
    const struct medium *how;
    struct veil veil;
    double from, length;
    bool lit, even; /* even: of no densities, the same all along */
    uint64_t key;   /* of random numbers */
};

static double march_random(struct march *march)
{
    march->key = random_mix(march->key);
    return random_unit(march->key);
}

/* At this share of the interval. */
static struct media_sample march_sample(const struct march *march, double share)
{
    return media_sample(march->way, march->from + share * march->length,
                        march->lit);
}

/* Between places of the interval, of which the values are known. */
struct piece {
    double from, to;
    struct media_sample a, b;
};

static bool sample_differs(const struct march *march, struct media_sample a,
                           struct media_sample b)
{
    rgb d = rgb_sub(a.light, b.light);
    return fabs(d.r) + fabs(d.g) + fabs(d.b) >= march->how->threshold;
}

/* The mean of the piece; at most aa_level levels. */
static struct media_sample piece_mean(const struct march *march,
                                      const struct piece *piece, int level)
{
    double middle = (piece->from + piece->to) / 2;
    struct media_sample m = march_sample(march, middle);
    struct media_sample left = sample_mix(piece->a, 2.0 / 3, m, 1.0 / 3);
    struct media_sample right = sample_mix(m, 1.0 / 3, piece->b, 2.0 / 3);
    if (level > 1 && sample_differs(march, piece->a, m)) {
        struct piece half = { piece->from, middle, piece->a, m };
        left = piece_mean(march, &half, level - 1);
    }
    if (level > 1 && sample_differs(march, m, piece->b)) {
        struct piece half = { middle, piece->to, m, piece->b };
        right = piece_mean(march, &half, level - 1);
    }
    return sample_mix(left, 0.5, right, 0.5);
}

static void veil_add(struct veil *veil, rgb light)
{
    veil->light = rgb_add(veil->light, rgb_mul(veil->through, light));
}

static rgb depth_through(rgb depth, double length)
{
    return (rgb){ exp(-depth.r * length), exp(-depth.g * length),
                  exp(-depth.b * length) };
}

/* Of places that are looked at. */
static int refining_count(const struct march *march)
{
    int count = march->how->samples / 2 + 2;
    return count < 3 ? 3 : count;
}

/* Where all places are alike one tells what the others would. False if they
 * have to be asked. */
static bool march_alike(struct march *march)
{
    if (march->lit || !march->even)
        return false;
    struct media_sample sample = march_sample(march, 0);
    int count = march->how->method == 3 ? refining_count(march) - 1 : 1;
    if (march->how->method != 3 && !rgb_is_black(sample.light))
        return false;
    double length = march->length / count;
    rgb through = depth_through(sample.depth, length);
    for (int i = 0; i < count; i++) {
        veil_add(&march->veil, rgb_scale(sample.light, length));
        march->veil.through = rgb_mul(march->veil.through, through);
    }
    return true;
}

static void march_refining(struct march *march)
{
    int count = refining_count(march);
    double length = march->length / (count - 1);
    /* Measured: all are moved together, forwards more than back. */
    double moved =
        march->how->jitter > 0
            ? march->how->jitter * (1.476 * march_random(march) - 0.29)
            : 0;
    struct piece piece = { .from = fmax(moved, 0) / count };
    piece.a = march_sample(march, piece.from);
    for (int i = 1; i < count; i++) {
        piece.to = fmin((i + moved) / count, 1);
        piece.b = march_sample(march, piece.to);
        struct media_sample mean =
            piece_mean(march, &piece, march->how->levels);
        veil_add(&march->veil, rgb_scale(mean.light, length));
        march->veil.through =
            rgb_mul(march->veil.through, depth_through(mean.depth, length));
        if (rgb_peak(march->veil.through) < media_dark)
            return;
        piece.from = piece.to;
        piece.a = piece.b;
    }
}

/* Sums of samples and of their squares. */
struct tally {
    int count;
    struct media_sample sum;
    rgb squares;
};

static void tally_add(struct tally *tally, const struct march *march,
                      double share)
{
    struct media_sample sample = march_sample(march, share);
    rgb dimmed = depth_through(sample.depth, share * march->length);
    sample.light = rgb_mul(sample.light, dimmed);
    tally->sum = sample_mix(tally->sum, 1, sample, 1);
    tally->squares =
        rgb_add(tally->squares, rgb_mul(sample.light, sample.light));
    tally->count++;
}

/* What share of a normal distribution is within z of its middle, turned round:
 * by the logistic distribution, to a few per cent. */
static double confidence_width(double confidence)
{
    return log((1 + confidence) / (1 - confidence)) / 1.702;
}

static bool tally_settled(const struct tally *tally, const struct medium *how)
{
    double n = tally->count, width = confidence_width(how->confidence);
    rgb mean = rgb_scale(tally->sum.light, 1 / n);
    rgb spread = rgb_sub(rgb_scale(tally->squares, 1 / n), rgb_mul(mean, mean));
    return rgb_peak(spread) * width * width <= n * how->variance;
}

static void march_averaging(struct march *march)
{
    const struct medium *how = march->how;
    struct tally tally = { .count = 0 };
    bool row = how->method == 2;
    for (int i = 0; i < how->samples; i++) {
        double moved = row ? 0.5 : march_random(march);
        if (row && how->jitter > 0)
            moved += how->jitter * (march_random(march) - 0.5);
        double share = row ? (i + moved) / how->samples : moved;
        tally_add(&tally, march, fmin(fmax(share, 0), 1));
    }
    while (tally.count < how->samples_most && !tally_settled(&tally, how))
        tally_add(&tally, march, march_random(march));
    struct media_sample mean =
        sample_mix(tally.sum, 1.0 / tally.count, tally.sum, 0);
    veil_add(&march->veil, rgb_scale(mean.light, march->length));
    march->veil.through =
        rgb_mul(march->veil.through, depth_through(mean.depth, march->length));
}

/* ---- the way ---- */

static void march_part(struct march *march, const struct media_part *part,
                       int intervals)
{
    march->lit = part->lit;
    march->length = (part->to - part->from) / intervals;
    for (int i = 0; i < intervals; i++) {
        march->from = part->from + i * march->length;
        if (march_alike(march))
            ;
        else if (march->how->method == 3)
            march_refining(march);
        else
            march_averaging(march);
        if (rgb_peak(march->veil.through) < media_dark)
            return;
    }
}

/* Of the intervals there are more than parts, so many go to all lit ones. */
static int parts_extra(int spare, int lit, int count, double ratio)
{
    if (spare <= 0 || lit == 0)
        return 0;
    return lit == count ? spare : (int)floor(spare * ratio + 0.5);
}

static void march_parts(struct march *march, const struct media_part *parts,
                        int count, int intervals)
{
    int lit = 0, dark, seen[2] = { 0, 0 };
    for (int i = 0; i < count; i++)
        lit += parts[i].lit;
    dark = count - lit;
    int spare = intervals > count ? intervals - count : 0;
    int extra = parts_extra(spare, lit, count, march->how->ratio);
    for (int i = 0; i < count; i++) {
        bool on = parts[i].lit;
        int all = on ? extra : spare - extra, of = on ? lit : dark;
        int own = all / of + (seen[on]++ < all % of);
        march_part(march, &parts[i], 1 + own);
        if (rgb_peak(march->veil.through) < media_dark)
            return;
    }
}

static uint64_t way_key(const struct media_way *way)
{
    uint64_t bits[6];
    memcpy(bits, &way->origin, sizeof way->origin);
    memcpy(bits + 3, &way->direction, sizeof way->direction);
    uint64_t key = 0;
    for (int i = 0; i < 6; i++)
        key = random_key(key, bits[i]);
    return key;
}

static bool media_even(const struct media_list *media)
{
    for (int i = 0; i < media->count; i++)
        if (media->at[i]->density_count > 0)
            return false;
    return true;
}

struct veil media_veil(const struct media_way *way)
{
    struct media_part parts[MEDIA_PARTS_MAX];
    struct media_way finite = *way;
    struct march march = { .way = &finite,
                           .how = way->media->count ? way->media->at[0] : NULL,
                           .veil = { rgb_grey(0), rgb_grey(1) } };
    int intervals = 1;
    finite.length = fmin(way->length, media_horizon);
    if (way->media->count == 0 || !(finite.length > 0))
        return march.veil;
    march.key = way_key(way);
    march.even = !way->photons && media_even(way->media);
    for (int i = 0; i < way->media->count; i++)
        if (way->media->at[i]->intervals > intervals)
            intervals = way->media->at[i]->intervals;
    int count = media_parts(&finite, parts);
    if (count == 1 && !parts[0].lit && march.even)
        intervals = 1;
    march_parts(&march, parts, count, intervals);
    return march.veil;
}
