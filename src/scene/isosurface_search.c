/* Crossings of an isosurface: a stretch of the ray is left out if the values at
 * its ends are too large for the function to reach its threshold between them,
 * by the largest gradient it is said to have; else it is halved, until it is as
 * short as the accuracy.
 *
 * Each search says where it wants the next value, and those of several rays are
 * worked out together. Where there are few rays, so are those that the halves
 * of a stretch will most likely ask for. */
#include "scene/isosurface_search.h"

#include "scene/function.h"

enum {
    SEARCH_STEPS = 200000, /* function calls for one ray */
    SEARCH_ROUNDS = 60,    /* for one crossing */
};

/* How near to a crossing is near enough: of the accuracy, and of the spread. */
static const double exact_enough = 1e-6, rough_enough = 0.125;

void search_set_out(struct search *search, const struct isosurface *surface,
                    double *crossings, int wanted)
{
    double speed = vec3_length(search->ray.direction);
    search->crossings = crossings;
    search->gradient = surface->max_gradient * speed;
    search->accuracy = surface->accuracy / speed;
    search->left = SEARCH_STEPS - 2; /* that of the ends are spent */
    search->wanted = wanted;
    search->spread = 0;
    search->coarse = search->any = false;
    search->found = search->round = search->ahead = search->depth = 0;
}

void search_stretch(struct search *search, struct search_place a,
                    struct search_place b)
{
    search->here = a;
    search->ends[0] = b;
    search->depth = 1;
}

/* To the end of the first stretch. */
static inline void search_pass(struct search *search)
{
    search->here = search->ends[--search->depth];
}

/* Whether the crossing in the first stretch wants another value. */
static bool search_refines(struct search *search)
{
    struct bracket *in = &search->bracket;
    double enough = fmax(exact_enough * search->accuracy,
                         rough_enough * search->spread * in->a);
    if (search->round < SEARCH_ROUNDS && in->b - in->a > enough &&
        bracket_next(in, search->round, &search->asked))
        return true;
    bool before = search->spread > 0 && in->a > search->here.t;
    search->crossings[search->found++] = before ? in->a : 0.5 * (in->a + in->b);
    search->round = 0;
    return false;
}

static inline bool places_differ(struct search_place a, struct search_place b)
{
    return (a.value < 0) != (b.value < 0);
}

/* Whether the function may reach its threshold between them. */
static inline bool search_may_cross(const struct search *search,
                                    struct search_place a,
                                    struct search_place b)
{
    return places_differ(a, b) ||
           !(fabs(a.value) + fabs(b.value) > search->gradient * (b.t - a.t));
}

/* Whether it is short enough to be looked at no closer. */
static inline bool search_is_short(const struct search *search,
                                   struct search_place a, struct search_place b)
{
    double middle = 0.5 * (a.t + b.t), length = b.t - a.t;
    return length < search->accuracy || length < search->spread * a.t ||
           middle <= a.t || middle >= b.t;
}

/* Whether the first stretch wants a value; if not, it is passed. */
static inline bool search_wants(struct search *search)
{
    const struct search_place a = search->here,
                              b = search->ends[search->depth - 1];
    if (search_may_cross(search, a, b)) {
        bool differ = places_differ(a, b);
        search->asked = 0.5 * (a.t + b.t);
        if (!(search_is_short(search, a, b) || search->depth == SEARCH_DEPTH ||
              (differ && search->any)))
            return true;
        if (differ && (search->coarse || search->any)) {
            search->crossings[search->found++] =
                search->any ? search->asked : b.t;
        } else if (differ) {
            search->bracket = (struct bracket){ a.t, a.value, b.t, b.value };
            search->round = 1;
            if (search_refines(search))
                return true;
        }
    }
    search_pass(search);
    return false;
}

/* Takes the value that was asked for. */
static inline void search_take(struct search *search, double value)
{
    struct bracket *in = &search->bracket;
    const struct search_place at = { search->asked, value };
    search->left--;
    if (search->round) {
        bracket_narrow(in, at.t, value, (value < 0) == (in->at_a < 0));
        search->round++;
    } else {
        search->ends[search->depth++] = at;
    }
}

/* Whether the value that is asked for is known, and then it is taken. */
static inline bool search_knows(struct search *search)
{
    for (int i = 0; i < search->ahead; i++)
        if (search->known[i].t == search->asked) {
            search_take(search, search->known[i].value);
            return true;
        }
    return false;
}

/* Goes on to where a value must be worked out. False: the search is over. */
static bool search_ask(struct search *search)
{
    while (search->depth > 0 && search->left > 0 &&
           search->found < search->wanted) {
        bool asks;
        if (search->round) {
            asks = search_refines(search);
            if (!asks)
                search_pass(search);
        } else {
            asks = search_wants(search);
        }
        if (asks && !search_knows(search))
            return true;
    }
    return false;
}

/* Values that are worked out together. */
struct batch {
    int count; /* of the searches that want them */
    struct search *of[OCTET];
    struct spots spots;
};

/* Where a search would go on if the function were straight between what is
 * known of it. */
struct foresight {
    struct search_place here;
    struct search_place ends[SEARCH_AHEAD + 1]; /* the nearest last; before them
                                                 * those of the search: */
    int own, depth;
};

static inline struct search_place foresight_end(const struct foresight *on,
                                                const struct search *search)
{
    return on->own > 0 ? on->ends[on->own - 1] : search->ends[on->depth - 1];
}

static inline void foresight_pass(struct foresight *on,
                                  const struct search *search)
{
    on->here = foresight_end(on, search);
    if (on->own > 0)
        on->own--;
    else
        on->depth--;
}

/* Halves its first stretch. */
static inline void foresight_halve(struct foresight *on,
                                   struct search_place end)
{
    on->ends[on->own++] =
        (struct search_place){ 0.5 * (on->here.t + end.t),
                               0.5 * (on->here.value + end.value) };
}

/* Goes on to the stretch that will be halved next. False: that is not known. */
static bool foresight_ask(struct foresight *on, const struct search *search)
{
    while (on->depth + on->own > 0) {
        struct search_place end = foresight_end(on, search);
        if (!search_may_cross(search, on->here, end)) {
            foresight_pass(on, search);
            continue;
        }
        bool ends = search->any && places_differ(on->here, end);
        return !ends && !search_is_short(search, on->here, end);
    }
    return false;
}

/* The value it wants and, of a stretch, those that the next steps will most
 * likely want. */
static void batch_ask(struct batch *batch, struct search *search, int values)
{
    batch->of[batch->count++] = search;
    search->ahead = 0;
    spots_add(&batch->spots, ray_point(&search->ray, search->asked));
    if (search->round || values < 2)
        return;
    struct foresight on = { .here = search->here, .depth = search->depth };
    foresight_halve(&on, foresight_end(&on, search));
    while (search->ahead < values - 1 && foresight_ask(&on, search)) {
        struct search_place end = foresight_end(&on, search);
        foresight_halve(&on, end);
        double t = on.ends[on.own - 1].t;
        search->known[search->ahead++].t = t;
        spots_add(&batch->spots, ray_point(&search->ray, t));
    }
}

static void batch_answer(struct batch *batch, const struct isosurface *surface)
{
    double values[OCTET];
    const double *next = values;
    isosurface_values(surface, &batch->spots, values);
    for (int i = 0; i < batch->count; i++) {
        struct search *search = batch->of[i];
        search_take(search, *next++);
        for (int k = 0; k < search->ahead; k++)
            search->known[k].value = *next++;
    }
    batch->count = batch->spots.count = 0;
}

/* How many values for each of so many searches take as long as one. */
static inline int values_for(const struct isosurface *surface, int searches)
{
    return surface->function->even && searches < OCTET ? OCTET / searches : 1;
}

/* They wait in a ring, so that there is always a whole batch of them. */
void search_run(const struct isosurface *surface, struct search *const *all,
                int count)
{
    enum { RING = 16 };
    struct search *ring[RING];
    struct batch batch;
    int first = 0, live = count;
    batch.count = batch.spots.count = 0;
    for (int i = 0; i < count; i++)
        ring[i] = all[i];
    while (live > 0) {
        int values = values_for(surface, live), waiting = live;
        while (waiting > 0 && batch.spots.count + values <= OCTET) {
            struct search *next = ring[first % RING];
            first++;
            waiting--;
            if (search_ask(next))
                batch_ask(&batch, next, values);
            else
                live--;
        }
        for (int i = 0; i < batch.count; i++)
            ring[(first + waiting + i) % RING] = batch.of[i];
        if (batch.count > 0)
            batch_answer(&batch, surface);
    }
}
