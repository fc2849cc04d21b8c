/* Roots of polynomials: see polynomial.h. */
#include "scene/polynomial.h"

#include <math.h>
#include <stdint.h>
#include <string.h>

#include "base/clones.h"

enum {
    BERNSTEIN_DEPTH = 10,
};

int quadratic_roots(double a, double b, double c, double roots[2])
{
    if (a == 0) {
        if (b == 0)
            return 0;
        roots[0] = -c / (2 * b);
        return 1;
    }
    double discriminant = b * b - a * c;
    if (!(discriminant > 0))
        return 0;
    double q = -(b + copysign(sqrt(discriminant), b));
    double first = q / a, second = c / q;
    roots[0] = first < second ? first : second;
    roots[1] = first < second ? second : first;
    return 2;
}

static double value_at(const double *c, int degree, double t)
{
    double value = c[degree];
    for (int i = degree - 1; i >= 0; i--)
        value = value * t + c[i];
    return value;
}

/* The value, the derivative, and half the second one. */
static inline double value_and_slope(const double *c, int degree, double t,
                                     double *slope, double *bend)
{
    double value = c[degree], derivative = 0, half = 0;
    for (int i = degree - 1; i >= 0; i--) {
        half = half * t + derivative;
        derivative = derivative * t + value;
        value = value * t + c[i];
    }
    *slope = derivative;
    *bend = half;
    return value;
}

/* The root between low and high, at which the values f and g have different
 * signs. Halley's steps are taken as long as they stay in the bracket and
 * shrink twofold, else the bracket is halved: never more than some 100 rounds.
 * When a step shrank k-fold, the next one will k^2-fold at least: it is not
 * taken if it would be nothing. */
INLINED double root_near(const double *c, int degree, double low, double high,
                         double f, double g)
{
    double part = f / (f - g), some = part > 0.05 ? part : 0.05;
    double t = low + (high - low) * (some < 0.95 ? some : 0.95);
    double step = high - low, last = step;
    bool low_negative = f < 0, was_good = false;
    for (int round = 0; round < 200; round++) {
        double slope, bend;
        double value = value_and_slope(c, degree, t, &slope, &bend);
        if (value == 0)
            return t;
        if ((value < 0) == low_negative)
            low = t;
        else
            high = t;
        double next = t - value * slope / (slope * slope - value * bend);
        bool good = next > low && next < high && fabs(next - t) < last / 2;
        if (!good)
            next = low + (high - low) / 2;
        last = step;
        step = fabs(next - t);
        double shrunk = step / last;
        if (next <= low || next >= high || step <= 1e-16 * fabs(next) ||
            (good && was_good && shrunk < 0.01 &&
             step * shrunk * shrunk <= 1e-17 * fabs(next)))
            return next;
        was_good = good;
        t = next;
    }
    return t;
}

/* The degrees that shapes have are compiled for themselves: the loops over the
 * coefficients are then none. */
static double root_between(const double *c, int degree, double low, double high,
                           double f, double g)
{
    switch (degree) {
    case 3:
        return root_near(c, 3, low, high, f, g);
    case 4:
        return root_near(c, 4, low, high, f, g);
    case 6:
        return root_near(c, 6, low, high, f, g);
    default:
        return root_near(c, degree, low, high, f, g);
    }
}

/* c's roots between the first and the last of these places, between which it is
 * monotonic. */
static int roots_between(const double *c, int degree, const double *turns,
                         int turn_count, double *roots)
{
    int count = 0;
    double left = turns[0], f = value_at(c, degree, left);
    for (int i = 1; i < turn_count; i++) {
        double right = turns[i];
        double g = value_at(c, degree, right);
        if ((f < 0) != (g < 0))
            roots[count++] = root_between(c, degree, left, right, f, g);
        left = right;
        f = g;
    }
    return count;
}

/* The k-th derivative divided by k!. */
static void derive(const double *c, int degree, int k, double *out)
{
    double binomial = 1;
    for (int i = k; i <= degree; i++) {
        out[i - k] = c[i] * binomial;
        binomial = binomial * (i + 1) / (i + 1 - k);
    }
}

static int quadratic_roots_between(const double *c, double low, double high,
                                   double *roots)
{
    double both[2];
    int found = quadratic_roots(c[2], c[1] / 2, c[0], both), count = 0;
    for (int i = 0; i < found; i++)
        if (both[i] > low && both[i] < high)
            roots[count++] = both[i];
    return count;
}

/* The way from all turns of the derivatives: see polynomial.h. */
static int roots_by_turns(const double *c, int degree, double low, double high,
                          double *roots)
{
    double buffers[2][POLYNOMIAL_DEGREE_MAX + 2]; /* with `low` and `high` */
    double derivative[POLYNOMIAL_DEGREE_MAX + 1];
    double *turns = buffers[0], *found = buffers[1];
    int count = 0, first = 1;
    turns[0] = found[0] = low;
    if (degree >= 2) {
        derive(c, degree, degree - 2, derivative);
        count = quadratic_roots_between(derivative, low, high, found + 1);
        first = 3;
    }
    for (int d = first; d <= degree; d++) {
        double *swap = turns;
        turns = found;
        found = swap;
        turns[count + 1] = high;
        derive(c, degree, degree - d, derivative);
        count = roots_between(derivative, d, turns, count + 2, found + 1);
    }
    for (int i = 0; i < count; i++)
        roots[i] = found[i + 1];
    return count;
}

INLINED void bernstein_of(const double *c, int degree, double low, double high,
                          double *b)
{
    double scale = 1;
    for (int i = 0; i <= degree; i++)
        b[i] = c[i];
    for (int i = 0; i < degree; i++)
        for (int k = degree - 1; k >= i; k--)
            b[k] += low * b[k + 1];
    for (int i = 0; i <= degree; i++) {
        b[i] *= scale;
        /* (high - low)^i / binomial(degree, i) */
        scale *= (high - low) * (i + 1) / (degree - i);
    }
    for (int k = 1; k <= degree; k++)
        for (int i = degree; i >= k; i--)
            b[i] += b[i - 1];
}

/* The polynomial's Bernstein coefficients over [low, high]. */
static void to_bernstein(const double *c, int degree, double low, double high,
                         double *b)
{
    switch (degree) {
    case 3:
        bernstein_of(c, 3, low, high, b);
        break;
    case 4:
        bernstein_of(c, 4, low, high, b);
        break;
    case 6:
        bernstein_of(c, 6, low, high, b);
        break;
    default:
        bernstein_of(c, degree, low, high, b);
    }
}

/* A polynomial c, and Bernstein coefficients of a piece of it. */
struct piece {
    const double *c;
    int degree;
    double low, high;
    double b[BERNSTEIN_DEGREE + 1];
};

static int sign_changes(const struct piece *piece)
{
    int changes = 0;
    for (int i = 0; i < piece->degree; i++)
        changes += (piece->b[i] < 0) != (piece->b[i + 1] < 0);
    return changes;
}

/* Cuts `right` in the middle (de Casteljau); the left half into *left. */
static void piece_cut(struct piece *right, struct piece *left)
{
    int n = right->degree;
    double middle = right->low + (right->high - right->low) / 2;
    left->c = right->c;
    left->degree = n;
    left->low = right->low;
    left->high = right->low = middle;
    for (int i = 0; i <= n; i++) {
        left->b[i] = right->b[0];
        for (int k = 0; k < n - i; k++)
            right->b[k] = (right->b[k] + right->b[k + 1]) / 2;
    }
}

static bool search_take(const struct root_search *search, double root)
{
    return root > search->least && search->visit(search->context, root);
}

static bool search_turns(const struct root_search *search, const double *c,
                         int degree, double low, double high)
{
    double roots[POLYNOMIAL_DEGREE_MAX];
    int count = roots_by_turns(c, degree, low, high, roots);
    for (int i = 0; i < count; i++)
        if (search_take(search, roots[i]))
            return true;
    return false;
}

/* Descartes: no sign change is no root and one is one, else the piece is
 * halved (Lane and Riesenfeld 1981); where that doesn't help, roots are all
 * but double, and the derivatives decide. Returns true when the search is over.
 */
static bool search_piece(const struct root_search *search, struct piece *piece,
                         int depth)
{
    int changes = sign_changes(piece);
    if (changes == 0 || piece->high <= search->least)
        return false;
    if (changes == 1)
        return search_take(search,
                           root_between(piece->c, piece->degree, piece->low,
                                        piece->high, piece->b[0],
                                        piece->b[piece->degree]));
    if (depth == BERNSTEIN_DEPTH)
        return search_turns(search, piece->c, piece->degree, piece->low,
                            piece->high);
    struct piece left;
    piece_cut(piece, &left);
    return search_piece(search, &left, depth + 1) ||
           search_piece(search, piece, depth + 1);
}

/* c without leading zeros; 0: it has no roots that could be told. */
static int polynomial_degree(const double *c, int degree)
{
    while (degree > 0 && c[degree] == 0)
        degree--;
    for (int i = 0; i <= degree; i++)
        if (!isfinite(c[i]))
            return 0;
    return degree;
}

static void search_quadratic(const struct root_search *search, const double *c,
                             int degree, double low, double high)
{
    double roots[2];
    int count = quadratic_roots(degree == 2 ? c[2] : 0, c[1] / 2, c[0], roots);
    for (int i = 0; i < count; i++)
        if (roots[i] >= low && roots[i] <= high &&
            search_take(search, roots[i]))
            return;
}

void polynomial_visit(const double *c, int degree, double low, double high,
                      const struct root_search *search)
{
    degree = polynomial_degree(c, degree);
    if (degree == 0 || !(low < high))
        return;
    if (degree <= 2) {
        search_quadratic(search, c, degree, low, high);
    } else if (degree <= BERNSTEIN_DEGREE &&
               high - low < POLYNOMIAL_BERNSTEIN_WIDTH) {
        struct piece piece = { .c = c, degree, low, high };
        to_bernstein(c, degree, low, high, piece.b);
        search_piece(search, &piece, 0);
    } else {
        search_turns(search, c, degree, low, high);
    }
}

struct root_list {
    double *roots;
    int count, limit;
};

static bool list_take(void *context, double root)
{
    struct root_list *list = context;
    list->roots[list->count++] = root;
    return list->count == list->limit;
}

int polynomial_roots(const double *c, int degree, double low, double high,
                     double *roots, int limit)
{
    struct root_list list = { roots, 0, limit };
    const struct root_search search = { -HUGE_VAL, list_take, &list };
    if (limit > 0)
        polynomial_visit(c, degree, low, high, &search);
    return list.count;
}

/* As search_piece, but one sign change is enough to know: no root is worked
 * out. */
static bool piece_crosses(struct piece *piece, int depth)
{
    double roots[POLYNOMIAL_DEGREE_MAX];
    int changes = sign_changes(piece);
    if (changes < 2)
        return changes;
    if (depth == BERNSTEIN_DEPTH)
        return roots_by_turns(piece->c, piece->degree, piece->low, piece->high,
                              roots) > 0;
    struct piece left;
    piece_cut(piece, &left);
    return piece_crosses(&left, depth + 1) || piece_crosses(piece, depth + 1);
}

bool polynomial_crosses(const double *c, int degree, double low, double high)
{
    struct piece piece;
    double root;
    degree = polynomial_degree(c, degree);
    if (degree == 0 || !(low < high))
        return false;
    if (degree <= 2 || degree > BERNSTEIN_DEGREE ||
        !(high - low < POLYNOMIAL_BERNSTEIN_WIDTH))
        return polynomial_roots(c, degree, low, high, &root, 1) > 0;
    piece = (struct piece){ .c = c, degree, low, high };
    to_bernstein(c, degree, low, high, piece.b);
    return piece_crosses(&piece, 0);
}

INLINED int bernstein_roots(const double *b, int degree, double *roots)
{
    struct piece piece = { .degree = degree, .high = 1 };
    struct root_list list = { roots, 0, 2 * BERNSTEIN_DEGREE };
    const struct root_search search = { -HUGE_VAL, list_take, &list };
    double c[BERNSTEIN_DEGREE + 1], binomial = 1;
    for (int i = 0; i <= degree; i++)
        piece.b[i] = c[i] = b[i];
    if (sign_changes(&piece) == 0)
        return 0;
    /* Differences are the coefficients of 1, t, t^2 ... */
    for (int k = 1; k <= degree; k++)
        for (int i = degree; i >= k; i--)
            c[i] -= c[i - 1];
    for (int k = 1; k <= degree; k++) {
        binomial = binomial * (degree + 1 - k) / k;
        c[k] *= binomial;
    }
    piece.c = c;
    search_piece(&search, &piece, 0);
    return list.count;
}

int polynomial_bernstein_roots(const double *b, int degree, double *roots)
{
    return degree == 3 ? bernstein_roots(b, 3, roots)
                       : bernstein_roots(b, degree, roots);
}

/* As ilogb of what is neither 0 nor infinite, without a call. */
static inline int power_of_2(double value)
{
    uint64_t bits;
    memcpy(&bits, &value, sizeof bits);
    int power = (int)(bits >> 52 & 0x7ff);
    return power > 0 ? power - 1023 : ilogb(value);
}

double polynomial_bound(const double *c, int degree)
{
    if (degree < 1)
        return 0;
    if (c[degree] == 0)
        return HUGE_VAL;
    int lead = power_of_2(c[degree]), most = -1000;
    for (int k = 1; k <= degree; k++) {
        if (c[degree - k] == 0)
            continue;
        if (!isfinite(c[degree - k]) || !isfinite(c[degree]))
            return HUGE_VAL;
        /* |c[n-k] / c[n]|^(1/k) < 2^power */
        int ratio = power_of_2(c[degree - k]) - lead + 1;
        int power = ratio > 0 ? (ratio + k - 1) / k : ratio / k;
        most = power > most ? power : most;
    }
    return most < -900 ? 0x1p-900 : most > 1000 ? HUGE_VAL : ldexp(2, most);
}
