/* What frames do for each other: see moments.h. */
#include "cli/moments.h"

#include <stdlib.h>

enum {
    MOMENTS_ROW = 2 * LIGHTING_MOMENTS, /* frames: each lights few for itself */
    MOMENTS_SIZE = 300 * 1000           /* fingerprint: memory is for five */
};

/* Frames with other lamps, or another sky, have another light; with other
 * things they are no animation of these. */
static bool prints_serve(const struct fingerprint *a,
                         const struct fingerprint *b)
{
    return a->kinds == b->kinds && a->lights == b->lights &&
           a->surroundings == b->surroundings;
}

/* That of frame `number`, which may be one of two that are read. */
static struct fingerprint print_of(const struct work *work, int number,
                                   struct moment *now, struct moment *last)
{
    struct moment other, *at = number == now->number    ? now
                               : number == last->number ? last
                                                        : NULL;
    if (at)
        return *moment_print(at);
    moment_read(&other, work, number, NULL);
    const struct fingerprint print = *moment_print(&other);
    moment_free(&other);
    return print;
}

/* Whether something moves, but no lamp, as the first frame, the last and the
 * one between them have it: whichever of them are drawn. */
static bool animation_moves(const struct work *work, struct moment *now,
                            struct moment *last)
{
    const struct frames *frames = &work->options.frames;
    const int middle = frames->first + (frames->last - frames->first) / 2;
    const struct fingerprint a = print_of(work, frames->first, now, last),
                             b = print_of(work, middle, now, last),
                             c = *moment_print(last);
    return prints_serve(&a, &b) && prints_serve(&a, &c) &&
           (!fingerprint_same(&a, &b) || !fingerprint_same(&a, &c));
}

/* Whether so many frames are drawn in a row in which something moves that most
 * are used by all around them. */
static bool moments_wanted(const struct work *work, struct moment *now,
                           struct moment *last)
{
    const struct options *options = &work->options;
    const struct frames *frames = &options->frames;
    return work->lighting->by_moments && abs(frames->pace) == 1 &&
           frames_count(frames) >= MOMENTS_ROW &&
           !options->light.light_mesh.save_file &&
           animation_moves(work, now, last);
}

/* Begins the lighting of a frame, for the points of others. */
static void root_light(struct work *work, struct moment *root)
{
    moment_light(root, work);
    if (root->state)
        work->kept = work->lighting->keep(root->state);
}

/* Whether both frames could be read, and show the same. */
static bool moments_same(struct moment *a, struct moment *b)
{
    return a->scene && b->scene &&
           fingerprint_same(moment_print(a), moment_print(b));
}

/* Likewise of the first frame, if it shows the same as `now`. Returns whether
 * it does. */
static bool root_first(struct work *work, struct moment *now)
{
    struct moment first;
    moment_read(&first, work, work->options.frames.first, NULL);
    bool same = moments_same(now, &first);
    if (same)
        root_light(work, &first);
    moment_free(&first);
    return same;
}

/* The root is the last frame. Where only the camera moves it is so only if it
 * is in a chamber, from outside of which nobody would look for what lights it,
 * and else the first. */
void moments_root(struct work *work, struct moment *now)
{
    const struct options *options = &work->options;
    const struct frames *frames = &options->frames;
    struct moment last;
    if (!frames->animated || frames->last <= frames->first ||
        work->kept.bytes || work->root_tried || !moment_keeps(work) ||
        options->light.light_mesh.load_file || options->probe)
        return;
    work->root_tried = true;
    moment_read(&last, work, frames->last, NULL);
    const bool same = moments_same(now, &last);
    work->smooths = moments_wanted(work, now, &last);
    if (last.scene)
        root_light(work, &last);
    moment_free(&last);
    if (!same || work->kept.inside)
        return;
    struct lighting_kept kept = work->kept;
    work->kept = (struct lighting_kept){ .bytes = NULL };
    if (work->number == frames->first || root_first(work, now))
        lighting_forget(&kept);
    else
        work->kept = kept;
}

/* Where a frame is kept, with those around it. */
static struct moment *moment_place(struct work *work, int number)
{
    int place = number % LIGHTING_MOMENTS;
    return &work->around[place < 0 ? place + LIGHTING_MOMENTS : place];
}

/* The frame of that number, read, unless that has been done. */
static struct moment *moment_at(struct work *work, int number,
                                struct diag *diag)
{
    struct moment *at = moment_place(work, number);
    if (at->arena && at->number == number)
        return at;
    moment_free(at);
    moment_read(at, work, number, diag);
    return at;
}

/* Files may have changed since it was read. */
struct moment *moments_now(struct work *work)
{
    struct moment *now = moment_place(work, work->number);
    if (now->arena && file_list_changed(&now->asked))
        moment_free(now);
    now = moment_at(work, work->number, &work->diag);
    moment_tell(now, &work->diag);
    file_list_take(work->options.parse.asked, &now->asked);
    return now;
}

static bool moment_is_lit(struct moment *moment, const struct work *work)
{
    if (!moment->world)
        moment_light(moment, work);
    return moment->state && moment->lighting == work->lighting;
}

/* The frames around that serve, in their order, itself among them; none if
 * nothing moves in any. Returns how many. */
static int moments_serving(struct work *work, struct moment *now,
                           struct moment *serving[LIGHTING_MOMENTS])
{
    const struct frames *frames = &work->options.frames;
    int count = 0, others = 0;
    for (int i = now->number - MOMENTS_REACH; i <= now->number + MOMENTS_REACH;
         i++) {
        if (i < frames->first || i > frames->last)
            continue;
        struct moment *at = moment_at(work, i, NULL);
        if (!at->scene || !prints_serve(moment_print(at), moment_print(now)))
            continue;
        others += !moments_same(at, now);
        serving[count++] = at;
    }
    return others > 0 ? count : 0;
}

void moments_around(struct work *work, struct moment *now,
                    struct lighting_moments *found)
{
    struct moment *serving[LIGHTING_MOMENTS];
    found->count = 0;
    if (!work->smooths || moment_print(now)->size > MOMENTS_SIZE)
        return;
    int count = moments_serving(work, now, serving);
    if (count == 0 || !work->lighting->by_moments ||
        !moment_is_lit(now, work) || !work->lighting->by_moments(now->state))
        return;
    for (int i = 0; i < count; i++) {
        if (!moment_is_lit(serving[i], work))
            continue;
        if (serving[i] == now)
            found->now = found->count;
        found->weight[found->count] =
            MOMENTS_REACH + 1 - abs(serving[i]->number - now->number);
        found->state[found->count++] = serving[i]->state;
    }
}

void moments_pass(struct work *work)
{
    const int pace = work->options.frames.pace;
    for (int i = 0; i < LIGHTING_MOMENTS; i++) {
        struct moment *at = &work->around[i];
        if (!work->smooths || at->print.size > MOMENTS_SIZE ||
            (work->number - at->number) * pace >= MOMENTS_REACH)
            moment_free(at);
    }
}

void moments_forget(struct work *work)
{
    for (int i = 0; i < LIGHTING_MOMENTS; i++)
        moment_free(&work->around[i]);
}
