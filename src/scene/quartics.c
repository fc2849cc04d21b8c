/* See quartics.h: Descartes' rule for Bernstein coefficients, a few halvings,
 * Halley's steps. Each lane does what polynomial.c does. */
#include "scene/quartics.h"

#include "scene/polynomial.h"

enum { HALVINGS = 8 };

typedef double lanes[RAY_LANES];

/* Pieces of the polynomials, and how often their coefficients' signs change. */
struct pieces {
    lanes b[QUARTIC + 1];
    lanes low, high, changes;
};

/* Both halves of pieces. */
struct halves {
    lanes left[QUARTIC + 1], right[QUARTIC + 1];
    lanes left_changes, right_changes;
};

static inline void count_changes(const lanes *restrict b,
                                 double *restrict changes)
{
    for (int i = 0; i < RAY_LANES; i++)
        changes[i] = 0;
    for (int k = 0; k < QUARTIC; k++)
        for (int i = 0; i < RAY_LANES; i++)
            changes[i] += (b[k][i] < 0) != (b[k + 1][i] < 0) ? 1 : 0;
}

/* As bernstein_of. */
static inline void find_bernstein(lanes *restrict b, const double *restrict low,
                                  const double *restrict high)
{
    lanes scale;
    for (int i = 0; i < RAY_LANES; i++)
        scale[i] = 1;
    for (int j = 0; j < QUARTIC; j++)
        for (int k = QUARTIC - 1; k >= j; k--)
            for (int i = 0; i < RAY_LANES; i++)
                b[k][i] += low[i] * b[k + 1][i];
    for (int k = 0; k <= QUARTIC; k++)
        for (int i = 0; i < RAY_LANES; i++) {
            b[k][i] *= scale[i];
            scale[i] *= (high[i] - low[i]) * (k + 1) / (QUARTIC - k);
        }
    for (int k = 1; k <= QUARTIC; k++)
        for (int j = QUARTIC; j >= k; j--)
            for (int i = 0; i < RAY_LANES; i++)
                b[j][i] += b[j - 1][i];
}

/* `fate` is unknown of what is no number or too long. */
CLONES static void pieces_begin(const struct quartics *restrict q,
                                struct pieces *restrict pieces,
                                double *restrict fate)
{
    lanes sum = { 0 };
    for (int k = 0; k <= QUARTIC; k++)
        for (int i = 0; i < RAY_LANES; i++) {
            pieces->b[k][i] = q->c[k][i];
            sum[i] += q->c[k][i];
        }
    for (int i = 0; i < RAY_LANES; i++) {
        pieces->low[i] = q->low[i];
        pieces->high[i] = q->high[i];
    }
    find_bernstein(pieces->b, q->low, q->high);
    count_changes((const lanes *)pieces->b, pieces->changes);
    for (int i = 0; i < RAY_LANES; i++) {
        double width = q->high[i] - q->low[i];
        bool good = (sum[i] * 0 == 0) & (q->c[QUARTIC][i] != 0) &
                    (width < POLYNOMIAL_BERNSTEIN_WIDTH);
        double known = pieces->changes[i] == 0 ? (double)QUARTIC_NONE
                                               : (double)QUARTIC_ROOT;
        known = good ? known : (double)QUARTIC_UNKNOWN;
        fate[i] = width > 0 ? known : (double)QUARTIC_NONE;
    }
}

/* Cut in the middle (de Casteljau). */
static inline void pieces_cut(const struct pieces *restrict pieces,
                              struct halves *restrict halves)
{
    for (int k = 0; k <= QUARTIC; k++)
        for (int i = 0; i < RAY_LANES; i++)
            halves->right[k][i] = pieces->b[k][i];
    for (int k = 0; k <= QUARTIC; k++) {
        for (int i = 0; i < RAY_LANES; i++)
            halves->left[k][i] = halves->right[0][i];
        for (int j = 0; j < QUARTIC - k; j++)
            for (int i = 0; i < RAY_LANES; i++)
                halves->right[j][i] =
                    (halves->right[j][i] + halves->right[j + 1][i]) / 2;
    }
    count_changes((const lanes *)halves->left, halves->left_changes);
    count_changes((const lanes *)halves->right, halves->right_changes);
}

/* Goes on with a half of each, or, where `keep` is 1, all of it. */
static inline void pieces_take(struct pieces *restrict pieces,
                               const struct halves *restrict halves,
                               const double *restrict keep,
                               const double *restrict take_left)
{
    for (int k = 0; k <= QUARTIC; k++)
        for (int i = 0; i < RAY_LANES; i++) {
            double half =
                take_left[i] != 0 ? halves->left[k][i] : halves->right[k][i];
            pieces->b[k][i] = keep[i] != 0 ? pieces->b[k][i] : half;
        }
    for (int i = 0; i < RAY_LANES; i++) {
        double low = pieces->low[i], high = pieces->high[i];
        double middle = low + (high - low) / 2;
        double changes = take_left[i] != 0 ? halves->left_changes[i]
                                           : halves->right_changes[i];
        bool all = keep[i] != 0, left = take_left[i] != 0;
        pieces->low[i] = (all | left) ? low : middle;
        pieces->high[i] = (all | !left) ? high : middle;
        pieces->changes[i] = all ? pieces->changes[i] : changes;
    }
}

/* To the half with the first root, if the signs don't deceive. */
CLONES static void pieces_halve(struct pieces *restrict pieces,
                                const double *restrict least)
{
    struct halves halves;
    lanes keep, left;
    pieces_cut(pieces, &halves);
    for (int i = 0; i < RAY_LANES; i++) {
        double low = pieces->low[i], middle = low + (pieces->high[i] - low) / 2;
        bool after = (halves.left_changes[i] == 0) | (middle <= least[i]);
        keep[i] = pieces->changes[i] < 2 ? 1 : 0;
        left[i] = after ? 0 : 1;
    }
    pieces_take(pieces, &halves, keep, left);
}

/* Halley's steps of all lanes, as root_near takes them. */
struct steps {
    double low[RAY_LANES], high[RAY_LANES], t[RAY_LANES];
    double step[RAY_LANES], last[RAY_LANES];
    double below[RAY_LANES], was_good[RAY_LANES]; /* 1 or 0 */
    double done[RAY_LANES];
};

CLONES static void steps_begin(const struct pieces *restrict pieces,
                               const double *restrict fate,
                               struct steps *restrict steps)
{
    for (int i = 0; i < RAY_LANES; i++) {
        double low = pieces->low[i], high = pieces->high[i];
        double f = pieces->b[0][i], g = pieces->b[QUARTIC][i];
        double at = f / (f - g);
        at = at > 0.05 ? at : 0.05;
        at = at < 0.95 ? at : 0.95;
        steps->low[i] = low;
        steps->high[i] = high;
        steps->t[i] = low + (high - low) * at;
        steps->step[i] = steps->last[i] = high - low;
        steps->below[i] = f < 0 ? 1 : 0;
        steps->was_good[i] = 0;
        steps->done[i] = fate[i] == (double)QUARTIC_ROOT ? 0 : 1;
    }
}

static inline void lane_step(const struct quartics *q, struct steps *steps,
                             int i)
{
    double t = steps->t[i], low = steps->low[i], high = steps->high[i];
    double value = q->c[QUARTIC][i], slope = 0, bend = 0;
    for (int k = QUARTIC - 1; k >= 0; k--) {
        bend = bend * t + slope;
        slope = slope * t + value;
        value = value * t + q->c[k][i];
    }
    bool done = steps->done[i] != 0, zero = value == 0;
    bool at_low = (value < 0) == (steps->below[i] != 0);
    low = at_low ? t : low;
    high = at_low ? high : t;
    double next = t - value * slope / (slope * slope - value * bend);
    double last = steps->last[i];
    bool good = (next > low) & (next < high) & (fabs(next - t) < last / 2);
    next = good ? next : low + (high - low) / 2;
    double step = fabs(next - t), before = steps->step[i],
           shrunk = step / before;
    bool enough = (next <= low) | (next >= high) |
                  (step <= 1e-16 * fabs(next)) |
                  (good & (steps->was_good[i] != 0) & (shrunk < 0.01) &
                   (step * shrunk * shrunk <= 1e-17 * fabs(next)));
    steps->t[i] = (done | zero) ? t : next;
    steps->low[i] = low;
    steps->high[i] = high;
    steps->last[i] = before;
    steps->step[i] = step;
    steps->was_good[i] = good ? 1 : 0;
    steps->done[i] = (done | zero | enough) ? 1 : 0;
}

/* Returns how many are done. */
CLONES static double steps_take(const struct quartics *restrict q,
                                struct steps *restrict steps)
{
    double done = 0;
    for (int i = 0; i < RAY_LANES; i++)
        lane_step(q, steps, i);
    for (int i = 0; i < RAY_LANES; i++)
        done += steps->done[i];
    return done;
}

static bool any_is_cut(const struct pieces *pieces, const double *fate)
{
    bool any = false;
    for (int i = 0; i < RAY_LANES; i++)
        any |= (fate[i] == (double)QUARTIC_ROOT) & (pieces->changes[i] > 1);
    return any;
}

void quartics_first(const struct quartics *q, const double *least,
                    struct quartic_roots *out)
{
    enum { ROUNDS = 200 };
    struct pieces pieces;
    struct steps steps;
    pieces_begin(q, &pieces, out->fate);
    for (int i = 0; i < HALVINGS && any_is_cut(&pieces, out->fate); i++)
        pieces_halve(&pieces, least);
    for (int i = 0; i < RAY_LANES; i++)
        if (out->fate[i] == (double)QUARTIC_ROOT && pieces.changes[i] != 1)
            out->fate[i] = (double)QUARTIC_UNKNOWN;
    steps_begin(&pieces, out->fate, &steps);
    int round = 0;
    while (round < ROUNDS && steps_take(q, &steps) < RAY_LANES)
        round++;
    for (int i = 0; i < RAY_LANES; i++) {
        out->root[i] = steps.t[i];
        if (out->fate[i] == (double)QUARTIC_ROOT &&
            (!(steps.t[i] > least[i]) || steps.done[i] == 0))
            out->fate[i] = (double)QUARTIC_UNKNOWN;
    }
}

/* To the half that may have a root, if only one may; both: none is known, and
 * the lane is left to others. */
CLONES static void pieces_halve_any(struct pieces *restrict pieces,
                                    double *restrict fate)
{
    struct halves halves;
    lanes keep, left;
    pieces_cut(pieces, &halves);
    for (int i = 0; i < RAY_LANES; i++) {
        double a = halves.left_changes[i], b = halves.right_changes[i];
        bool all = (pieces->changes[i] < 2) | (fate[i] != (double)QUARTIC_ROOT);
        double now = a + b == 0 ? (double)QUARTIC_NONE : (double)QUARTIC_ROOT;
        now = ((a > 1) & (b > 1)) ? (double)QUARTIC_UNKNOWN : now;
        keep[i] = all ? 1 : 0;
        left[i] = (a == 1) | ((a > 1) & (b == 0)) ? 1 : 0;
        fate[i] = all ? fate[i] : now;
    }
    pieces_take(pieces, &halves, keep, left);
}

void quartics_cross(const struct quartics *q, double *fate)
{
    struct pieces pieces;
    pieces_begin(q, &pieces, fate);
    for (int i = 0; i < HALVINGS && any_is_cut(&pieces, fate); i++)
        pieces_halve_any(&pieces, fate);
    for (int i = 0; i < RAY_LANES; i++)
        if (fate[i] == (double)QUARTIC_ROOT && pieces.changes[i] > 1)
            fate[i] = (double)QUARTIC_UNKNOWN;
}
