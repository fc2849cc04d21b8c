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
#include "shade/media_places.h"

const double media_horizon = 2e10;

/* Less light than this comes through: the rest is not looked at. */
static const double media_dark = 1e-7;

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

/* ---- an interval ---- */

/* The way so far, and the interval that is next. */
struct march {
    const struct media_way *way;
    const struct medium *how;
    struct veil veil;
    double from, length;
    bool lit, even; /* even: of no densities, the same all along */
    bool keyed;
    uint64_t key; /* of random numbers, once they are needed */
};

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

static double march_random(struct march *march)
{
    if (!march->keyed)
        march->key = way_key(march->way);
    march->keyed = true;
    march->key = random_mix(march->key);
    return random_unit(march->key);
}

/* At this share of the interval there is a place to look at. */
static void march_place(const struct march *march, struct spots *places,
                        double share)
{
    double t = march->from + share * march->length;
    spots_add(places, vec3_along(march->way->origin, march->way->direction, t));
}

static struct media_sample march_sample(const struct march *march, double share)
{
    struct places one;
    one.at.count = 0;
    march_place(march, &one.at, share);
    media_samples(march->way, march->lit, &one);
    return one.sample[0];
}

static bool sample_differs(const struct march *march, struct media_sample a,
                           struct media_sample b)
{
    rgb d = rgb_sub(a.light, b.light);
    return fabs(d.r) + fabs(d.g) + fabs(d.b) >= march->how->threshold;
}

/* Between places of the interval: what is at both ends and in the middle. */
struct piece {
    double from, to;
    struct media_sample a, m, b;
    int half[2]; /* that are looked at by themselves; 0: it isn't */
    int levels;  /* that it may be divided into, itself included */
};

/* So many pieces in a row are looked at together, their halves after them. */
enum { PIECES = (SPOTS_MAX - 1) / 2, PIECES_DEEP = 3 };

struct pieces {
    int count;
    struct piece at[PIECES * ((1 << PIECES_DEEP) - 1)];
};

static double piece_middle(const struct piece *piece)
{
    return (piece->from + piece->to) / 2;
}

static void piece_half(const struct piece *piece, int which, struct piece *half)
{
    double middle = piece_middle(piece);
    half->from = which == 0 ? piece->from : middle;
    half->to = which == 0 ? middle : piece->to;
    half->a = which == 0 ? piece->a : piece->m;
    half->b = which == 0 ? piece->m : piece->b;
    half->half[0] = half->half[1] = 0;
    half->levels = piece->levels - 1;
}

static bool piece_divides(const struct march *march, const struct piece *piece,
                          int which)
{
    return piece->levels > 1 &&
           sample_differs(march, which == 0 ? piece->a : piece->m,
                          which == 0 ? piece->m : piece->b);
}

/* The middles of the pieces from `first` on. */
static void pieces_look(const struct march *march, struct pieces *pieces,
                        int first)
{
    while (first < pieces->count) {
        struct places places;
        places.at.count = 0;
        int some = pieces->count - first;
        some = some < SPOTS_MAX ? some : SPOTS_MAX;
        for (int i = 0; i < some; i++)
            march_place(march, &places.at,
                        piece_middle(&pieces->at[first + i]));
        media_samples(march->way, march->lit, &places);
        for (int i = 0; i < some; i++)
            pieces->at[first + i].m = places.sample[i];
        first += some;
    }
}

/* Halves of those whose middles are known, level by level. */
static void pieces_divide(const struct march *march, struct pieces *pieces)
{
    int first = 0;
    for (int deep = 1; deep < PIECES_DEEP; deep++) {
        int end = pieces->count;
        for (int i = first; i < end; i++)
            for (int k = 0; k < 2; k++)
                if (piece_divides(march, &pieces->at[i], k)) {
                    pieces->at[i].half[k] = pieces->count;
                    piece_half(&pieces->at[i], k, &pieces->at[pieces->count++]);
                }
        first = end;
        pieces_look(march, pieces, first);
    }
}

/* The mean of a piece that is divided further one by one. */
static struct media_sample piece_mean(const struct march *march,
                                      const struct piece *piece)
{
    struct media_sample half[2] = {
        sample_mix(piece->a, 2.0 / 3, piece->m, 1.0 / 3),
        sample_mix(piece->m, 1.0 / 3, piece->b, 2.0 / 3)
    };
    for (int k = 0; k < 2; k++)
        if (piece_divides(march, piece, k)) {
            struct piece next;
            piece_half(piece, k, &next);
            next.m = march_sample(march, piece_middle(&next));
            half[k] = piece_mean(march, &next);
        }
    return sample_mix(half[0], 0.5, half[1], 0.5);
}

/* Of one of those that were looked at `deep` levels deep. */
static struct media_sample pieces_mean(const struct march *march,
                                       const struct pieces *pieces, int number,
                                       int deep)
{
    const struct piece *piece = &pieces->at[number];
    if (deep == PIECES_DEEP)
        return piece_mean(march, piece);
    struct media_sample half[2] = {
        sample_mix(piece->a, 2.0 / 3, piece->m, 1.0 / 3),
        sample_mix(piece->m, 1.0 / 3, piece->b, 2.0 / 3)
    };
    for (int k = 0; k < 2; k++)
        if (piece->half[k])
            half[k] = pieces_mean(march, pieces, piece->half[k], deep + 1);
    return sample_mix(half[0], 0.5, half[1], 0.5);
}

static void veil_add(struct veil *veil, rgb light)
{
    veil->light = rgb_add(veil->light, rgb_mul(veil->through, light));
}

static rgb depth_through(rgb depth, double length)
{
    if (depth.r == depth.g && depth.g == depth.b)
        return rgb_grey(exp(-depth.r * length));
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

/* All places are known from the start but those between two that differ:
 * `count` pieces between the shares at `ends`, of which `first` is known. */
static void pieces_begin(const struct march *march, struct pieces *pieces,
                         const double *ends, int count,
                         const struct media_sample *first)
{
    struct places places;
    places.at.count = 0;
    for (int i = first ? 1 : 0; i <= count; i++)
        march_place(march, &places.at, ends[i]);
    for (int i = 0; i < count; i++)
        march_place(march, &places.at, (ends[i] + ends[i + 1]) / 2);
    media_samples(march->way, march->lit, &places);
    const struct media_sample *b = places.sample + (first ? 0 : 1);
    const struct media_sample *m = b + count;
    pieces->count = count;
    for (int i = 0; i < count; i++) {
        struct piece *piece = &pieces->at[i];
        piece->from = ends[i];
        piece->to = ends[i + 1];
        piece->a = i > 0 ? b[i - 1] : first ? *first : places.sample[0];
        piece->m = m[i];
        piece->b = b[i];
        piece->half[0] = piece->half[1] = 0;
        piece->levels = march->how->levels;
    }
}

/* Dims the way by the first of the pieces, each `length` long; false: nothing
 * comes through any more. */
static bool pieces_dim(struct march *march, const struct pieces *pieces,
                       int count, double length)
{
    for (int i = 0; i < count; i++) {
        struct media_sample mean = pieces_mean(march, pieces, i, 1);
        veil_add(&march->veil, rgb_scale(mean.light, length));
        march->veil.through =
            rgb_mul(march->veil.through, depth_through(mean.depth, length));
        if (rgb_peak(march->veil.through) < media_dark)
            return false;
    }
    return true;
}

/* Measured: all places are moved together, forwards more than back. */
static double refining_moved(struct march *march)
{
    return march->how->jitter > 0
               ? march->how->jitter * (1.476 * march_random(march) - 0.29)
               : 0;
}

static void march_refining(struct march *march)
{
    int count = refining_count(march);
    double length = march->length / (count - 1);
    double moved = refining_moved(march);
    struct pieces pieces;
    struct media_sample last, *known = NULL;
    double ends[PIECES + 1] = { fmax(moved, 0) / count };
    for (int from = 1, some; from < count; from += some) {
        some = count - from < PIECES ? count - from : PIECES;
        for (int i = 0; i < some; i++)
            ends[i + 1] = fmin((from + i + moved) / count, 1);
        pieces_begin(march, &pieces, ends, some, known);
        pieces_divide(march, &pieces);
        if (!pieces_dim(march, &pieces, some, length))
            return;
        last = pieces.at[some - 1].b;
        known = &last;
        ends[0] = ends[some];
    }
}

/* Sums of samples and of their squares. */
struct tally {
    int count;
    struct media_sample sum;
    rgb squares;
};

static void tally_add(struct tally *tally, const struct march *march,
                      double share, struct media_sample sample)
{
    if (!rgb_is_black(sample.light))
        sample.light = rgb_mul(
            sample.light, depth_through(sample.depth, share * march->length));
    tally->sum = sample_mix(tally->sum, 1, sample, 1);
    tally->squares =
        rgb_add(tally->squares, rgb_mul(sample.light, sample.light));
    tally->count++;
}

static void tally_add_all(struct tally *tally, const struct march *march,
                          const double *shares, int count)
{
    struct places places;
    places.at.count = 0;
    for (int i = 0; i < count; i++)
        march_place(march, &places.at, shares[i]);
    media_samples(march->way, march->lit, &places);
    for (int i = 0; i < count; i++)
        tally_add(tally, march, shares[i], places.sample[i]);
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

/* Of the sample number `i` of those that are always taken. */
static double march_share(struct march *march, int i)
{
    const struct medium *how = march->how;
    bool row = how->method == 2;
    double moved = row ? 0.5 : march_random(march);
    if (row && how->jitter > 0)
        moved += how->jitter * (march_random(march) - 0.5);
    double share = row ? (i + moved) / how->samples : moved;
    return fmin(fmax(share, 0), 1);
}

static void march_averaging(struct march *march)
{
    const struct medium *how = march->how;
    struct tally tally = { .count = 0 };
    double shares[SPOTS_MAX];
    for (int from = 0, some; from < how->samples; from += some) {
        some = how->samples - from;
        some = some < SPOTS_MAX ? some : SPOTS_MAX;
        for (int i = 0; i < some; i++)
            shares[i] = march_share(march, from + i);
        tally_add_all(&tally, march, shares, some);
    }
    while (tally.count < how->samples_most && !tally_settled(&tally, how)) {
        double share = march_random(march);
        tally_add_all(&tally, march, &share, 1);
    }
    struct media_sample mean =
        sample_mix(tally.sum, 1.0 / tally.count, tally.sum, 0);
    veil_add(&march->veil, rgb_scale(mean.light, march->length));
    march->veil.through =
        rgb_mul(march->veil.through, depth_through(mean.depth, march->length));
}

/* ---- a shadow ray ---- */

/* Where there is no light no two places differ in it, and none are looked at
 * but those that always are. What comes through is one exponential, of the sum
 * of what is at all of them. */
struct dimming {
    struct march *march;
    struct spots at;
    double weight[SPOTS_MAX];
    rgb sum;
};

static void dimming_look(struct dimming *dimming)
{
    rgb depths[SPOTS_MAX];
    media_depths(dimming->march->way, &dimming->at, depths);
    for (int i = 0; i < dimming->at.count; i++)
        dimming->sum =
            rgb_add_scaled(dimming->sum, depths[i], dimming->weight[i]);
    dimming->at.count = 0;
}

static void dimming_place(struct dimming *dimming, double share, double weight)
{
    if (dimming->at.count == SPOTS_MAX)
        dimming_look(dimming);
    dimming->weight[dimming->at.count] = weight;
    march_place(dimming->march, &dimming->at, share);
}

/* An interval of method 3: pieces' means are sums of their ends and middles. */
static void dimming_refining(struct dimming *dimming)
{
    struct march *march = dimming->march;
    int count = refining_count(march);
    double moved = refining_moved(march), from = fmax(moved, 0) / count;
    double weight = march->length / (3 * (count - 1));
    dimming_place(dimming, from, weight);
    for (int i = 1; i < count; i++) {
        double to = fmin((i + moved) / count, 1);
        dimming_place(dimming, (from + to) / 2, weight);
        dimming_place(dimming, to, i < count - 1 ? 2 * weight : weight);
        from = to;
    }
}

static void dimming_averaging(struct dimming *dimming)
{
    struct march *march = dimming->march;
    int count = march->how->samples;
    for (int i = 0; i < count; i++)
        dimming_place(dimming, march_share(march, i), march->length / count);
}

static bool march_dims(const struct march *march)
{
    const struct media_way *way = march->way;
    return !way->lamps && !way->photons &&
           (march->how->method == 3 ? march->how->threshold > 0
                                    : march->how->variance >= 0);
}

static void march_dim(struct march *march, double from, int intervals)
{
    struct dimming dimming; /* no more of it than is needed */
    dimming.march = march;
    dimming.at.count = 0;
    dimming.sum = rgb_grey(0);
    for (int i = 0; i < intervals; i++) {
        march->from = from + i * march->length;
        if (march->how->method == 3)
            dimming_refining(&dimming);
        else
            dimming_averaging(&dimming);
    }
    dimming_look(&dimming);
    march->veil.through =
        rgb_mul(march->veil.through, depth_through(dimming.sum, 1));
}

/* ---- the way ---- */

static void march_part(struct march *march, const struct media_part *part,
                       int intervals)
{
    march->lit = part->lit;
    march->length = (part->to - part->from) / intervals;
    if (march_dims(march)) {
        march_dim(march, part->from, intervals);
        return;
    }
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

static bool media_even(const struct media_list *media)
{
    for (int i = 0; i < media->count; i++)
        if (media->at[i]->density_count > 0)
            return false;
    return true;
}

/* What comes through media that are the same everywhere. */
static struct veil media_even_veil(const struct media_list *media,
                                   double length)
{
    rgb depth = rgb_grey(0);
    for (int i = 0; i < media->count; i++)
        depth = rgb_add(depth, medium_extinction(media->at[i]));
    return (struct veil){ rgb_grey(0), depth_through(depth, length) };
}

struct veil media_veil(const struct media_way *way)
{
    struct media_part parts[MEDIA_PARTS_MAX];
    struct media_beams beams;
    struct media_way finite = *way;
    struct march march = { .way = &finite,
                           .how = way->media->count ? way->media->at[0] : NULL,
                           .veil = { rgb_grey(0), rgb_grey(1) } };
    int intervals = 1;
    finite.length = fmin(way->length, media_horizon);
    if (way->media->count == 0 || !(finite.length > 0))
        return march.veil;
    march.even = !way->photons && media_even(way->media);
    if (march.even && march_dims(&march))
        return media_even_veil(way->media, finite.length);
    for (int i = 0; i < way->media->count; i++)
        if (way->media->at[i]->intervals > intervals)
            intervals = way->media->at[i]->intervals;
    int count = media_parts(&finite, &beams, parts);
    finite.beams = beams.count < 0 ? NULL : &beams;
    if (count == 1 && !parts[0].lit && march.even)
        intervals = 1;
    march_parts(&march, parts, count, intervals);
    return march.veil;
}
