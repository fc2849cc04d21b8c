/* Crossings of an isosurface: a stretch of the ray is left out if the values at
 * its ends are too large for the function to reach its threshold between them,
 * by the largest gradient it is said to have; else it is halved, until it is as
 * short as the accuracy. Where several values take hardly longer than one,
 * those that the halves will most likely ask for are worked out with it. */
#include "scene/isosurface_search.h"

#include "scene/bracket.h"
#include "scene/function.h"
#include "scene/spots.h"

enum {
    SEARCH_STEPS = 200000, /* function calls for one ray */
    SEARCH_ROUNDS = 60,    /* for one crossing */
};

static double search_value(const struct search *search, double t)
{
    return isosurface_value(search->surface, ray_point(search->ray, t));
}

/* The crossing in it. */
static void search_refine(struct search *search, struct bracket in)
{
    double enough = 1e-6 * search->accuracy, t;
    for (int i = 1; i < SEARCH_ROUNDS && in.b - in.a > enough; i++) {
        if (!bracket_next(&in, i, &t))
            break;
        double at_t = search_value(search, t);
        search->left--;
        bracket_narrow(&in, t, at_t, (at_t < 0) == (in.at_a < 0));
    }
    hits_add(search->hits, 0.5 * (in.a + in.b), ISOSURFACE_FUNCTION);
}

/* The values at the middle of a stretch and at those of its halves. */
struct middles {
    double at[3];
};

static inline struct middles search_middles(const struct search *search,
                                            double a, double middle, double b)
{
    struct middles middles;
    struct spots spots = spots_of(ray_point(search->ray, middle));
    spots_add(&spots, ray_point(search->ray, 0.5 * (a + middle)));
    spots_add(&spots, ray_point(search->ray, 0.5 * (middle + b)));
    isosurface_values(search->surface, &spots, middles.at);
    return middles;
}

/* Whether it is to be halved; else its crossing, if it has one, is added. */
static inline bool search_goes_on(struct search *search, double a, double at_a,
                                  double b, double at_b)
{
    bool differ = (at_a < 0) != (at_b < 0);
    if (!differ && fabs(at_a) + fabs(at_b) > search->gradient * (b - a))
        return false;
    if (search->left <= 0 || search->hits->count >= search->wanted)
        return false;
    double middle = 0.5 * (a + b);
    if (!(b - a < search->accuracy || middle <= a || middle >= b))
        return true;
    if (differ)
        search_refine(search, (struct bracket){ a, at_a, b, at_b });
    return false;
}

static void search_stretch(struct search *search, double a, double at_a,
                           double b, double at_b);

/* A stretch of which the value at the middle is known. */
static inline void search_known(struct search *search, double a, double at_a,
                                double b, double at_b, double at_middle)
{
    double middle = 0.5 * (a + b);
    if (!search_goes_on(search, a, at_a, b, at_b))
        return;
    search->left--;
    search_stretch(search, a, at_a, middle, at_middle);
    search_stretch(search, middle, at_middle, b, at_b);
}

/* If values are worked out ahead, two steps at a time: most halves are halved
 * again. */
static void search_stretch(struct search *search, double a, double at_a,
                           double b, double at_b)
{
    double middle = 0.5 * (a + b);
    if (!search_goes_on(search, a, at_a, b, at_b))
        return;
    search->left--;
    if (search->surface->function->even) {
        struct middles middles = search_middles(search, a, middle, b);
        double at_middle = middles.at[0];
        search_known(search, a, at_a, middle, at_middle, middles.at[1]);
        search_known(search, middle, at_middle, b, at_b, middles.at[2]);
    } else {
        double at_middle = search_value(search, middle);
        search_stretch(search, a, at_a, middle, at_middle);
        search_stretch(search, middle, at_middle, b, at_b);
    }
}

void search_crossings(struct search *search, double a, double at_a, double b,
                      double at_b)
{
    search->left = SEARCH_STEPS - 2; /* that of the ends are spent */
    search_stretch(search, a, at_a, b, at_b);
}
