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

/* Whether something moves, but no lamp, as the first frame, the last and the
 * one between them have it: whichever of them are drawn. */
static bool animation_moves(const struct work *work)
{
    const struct frames *frames = &work->options.frames;
    const int number[] = { frames->first,
                           frames->first + (frames->last - frames->first) / 2,
                           frames->last };
    struct fingerprint print[3];
    for (int i = 0; i < 3; i++) {
        struct moment moment;
        moment_read(&moment, work, number[i], NULL);
        print[i] = moment.print;
        moment_free(&moment);
    }
    return prints_serve(&print[0], &print[1]) &&
           prints_serve(&print[0], &print[2]) &&
           (!fingerprint_same(&print[0], &print[1]) ||
            !fingerprint_same(&print[0], &print[2]));
}

/* Whether so many frames are drawn in a row in which something moves that most
 * are used by all around them. */
static bool moments_wanted(const struct work *work)
{
    const struct options *options = &work->options;
    const struct frames *frames = &options->frames;
    if (!work->lighting->by_moments || options->probe || !frames->animated ||
        abs(frames->pace) != 1 || frames_count(frames) < MOMENTS_ROW ||
        options->light.light_mesh.load_file ||
        options->light.light_mesh.save_file)
        return false;
    return animation_moves(work);
}

/* Begins the lighting of frame `number`, for the points of others; `moves`:
 * also where it shows something else than `now`. Returns whether it shows
 * the same. */
static bool root_try(struct work *work, const struct moment *now, int number,
                     bool moves)
{
    struct moment root;
    moment_read(&root, work, number, NULL);
    bool same = root.scene && fingerprint_same(&now->print, &root.print);
    if (same || (root.scene && moves))
        moment_light(&root, work);
    if (root.state)
        work->kept = work->lighting->keep(root.state);
    moment_free(&root);
    return same;
}

/* The root is the last frame. Where only the camera moves it is so only if it
 * is in a chamber, from outside of which nobody would look for what lights it,
 * and else the first. */
void moments_root(struct work *work, const struct moment *now)
{
    const struct options *options = &work->options;
    const struct frames *frames = &options->frames;
    if (!frames->animated || frames->last <= frames->first ||
        work->kept.bytes || work->root_tried || !moment_keeps(work) ||
        options->light.light_mesh.load_file || options->probe)
        return;
    work->root_tried = true;
    work->smooths = moments_wanted(work);
    if (!root_try(work, now, frames->last, true) || work->kept.inside)
        return;
    struct lighting_kept last = work->kept;
    work->kept = (struct lighting_kept){ .bytes = NULL };
    if (work->number == frames->first ||
        root_try(work, now, frames->first, false))
        lighting_forget(&last);
    else
        work->kept = last;
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
static int moments_serving(struct work *work, const struct moment *now,
                           struct moment *serving[LIGHTING_MOMENTS])
{
    const struct frames *frames = &work->options.frames;
    int count = 0, others = 0;
    for (int i = now->number - MOMENTS_REACH; i <= now->number + MOMENTS_REACH;
         i++) {
        if (i < frames->first || i > frames->last)
            continue;
        struct moment *at = moment_at(work, i, NULL);
        if (!at->scene || !prints_serve(&at->print, &now->print))
            continue;
        others += !fingerprint_same(&at->print, &now->print);
        serving[count++] = at;
    }
    return others > 0 ? count : 0;
}

void moments_around(struct work *work, struct moment *now,
                    struct lighting_moments *found)
{
    struct moment *serving[LIGHTING_MOMENTS];
    found->count = 0;
    if (!work->smooths || now->print.size > MOMENTS_SIZE)
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
