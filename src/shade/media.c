/* Rays through media: see media.h. As POV-Ray 3.7 does it (measured with
 * densities that tell where they are looked up):
 * - The first of several media says how all are sampled, but for the number of
 *   intervals, which is the largest.
 * - Method 3 looks at s/2 + 2 places of each interval, for `samples s`: at 0,
 *   1/n, ... (n-1)/n of it. Each pair of neighbours stands for an equal piece;
 *   between them it looks at the middle, and between two of these three that
 *   differ by aa_threshold or more again, aa_level times at most. It is the
 *   light of the whole interval that is compared: per unit, times its length.
 *   A piece's mean is (a + m + b) / 3; the light of a piece is dimmed by all
 *   pieces before it, not by itself.
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

#include "shade/media_dims.h"
#include "shade/media_march.h"
#include "shade/media_places.h"

const double media_horizon = 2e10;

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
    list->dark = true;
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
            list->dark &= medium_is_dark(media->items[k]);
        }
    }
}

/* ---- an interval ---- */

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
    return (fabs(d.r) + fabs(d.g) + fabs(d.b)) * march->length >=
           march->how->threshold;
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

/* Where all places are alike one tells what the others would. False if they
 * have to be asked. */
static bool march_alike(struct march *march)
{
    if (march->lit || !march->even)
        return false;
    struct media_sample sample = march_sample(march, 0);
    int count = march->how->method == 3 ? march_pieces(march) - 1 : 1;
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
        if (rgb_peak(march->veil.through) < MEDIA_DARK)
            return false;
    }
    return true;
}

static void march_refining(struct march *march)
{
    int count = march_pieces(march);
    double length = march->length / (count - 1);
    double moved = march_moved(march);
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
        if (rgb_peak(march->veil.through) < MEDIA_DARK)
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
        if (rgb_peak(march->veil.through) < MEDIA_DARK)
            return;
    }
}

/* Of a way on which no light is added. */
static struct veil veil_dims(const struct media_way *way)
{
    struct media_dims dims; /* no more of it than is needed */
    media_dims_begin(&dims, way->worker, 1);
    media_dims_add(&dims, way, 0);
    media_dims_look(&dims);
    return (struct veil){ rgb_grey(0), media_dims_through(&dims, 0) };
}

struct veil media_veil(const struct media_way *way)
{
    struct media_part parts[MEDIA_PARTS_MAX];
    struct media_beams beams;
    struct media_way finite = *way;
    finite.length = fmin(way->length, media_horizon);
    if (way->media->count == 0 || !(finite.length > 0))
        return (struct veil){ rgb_grey(0), rgb_grey(1) };
    struct march march = march_begin(&finite);
    if (march_dims(&march))
        return veil_dims(&finite);
    int intervals = march_intervals(&march);
    int count = media_parts(&finite, &beams, parts);
    finite.beams = beams.count < 0 ? NULL : &beams;
    if (count == 1 && !parts[0].lit && march.even)
        intervals = 1;
    march_parts(&march, parts, count, intervals);
    return march.veil;
}
