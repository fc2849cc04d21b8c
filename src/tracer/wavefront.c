/* Lists of rays that wait, and who waits for whom: see wavefront.h. */
#include "tracer/wavefront.h"

#include "shade/finish.h"

enum { SURFACES_MAX = 1000 * 1000 }; /* a ray passes straight through */

static void list_clear(struct path_list *list)
{
    list->first = NULL;
    list->count = 0;
}

void wavefront_start(struct wavefront *wavefront, const struct tracer *tracer,
                     struct worker *worker, bool together)
{
    wavefront->tracer = tracer;
    wavefront->worker = worker;
    wavefront->lanes = together ? WORLD_RAYS : 1;
    list_clear(&wavefront->open);
    list_clear(&wavefront->mirrored);
    list_clear(&wavefront->born);
    wavefront->idle = NULL;
    wavefront->idle_dues = NULL;
    wavefront->used = 0;
}

static void list_push(struct path_list *list, struct path *path)
{
    path->next = list->first;
    list->first = path;
    list->count++;
}

static struct path *list_pop(struct path_list *list)
{
    struct path *path = list->first;
    list->first = path->next;
    list->count--;
    return path;
}

static struct path *wavefront_path(struct wavefront *wavefront)
{
    struct path *path = wavefront->idle;
    if (path)
        wavefront->idle = path->next;
    else if (wavefront->used < WAVEFRONT_USUAL)
        path = &wavefront->usual[wavefront->used++];
    else
        path = ARENA_NEW(wavefront->worker->scratch, struct path);
    path->tracer = wavefront->tracer;
    path->worker = wavefront->worker;
    path->wavefront = wavefront;
    path->surfaces = 0;
    path->ended = false;
    path->place = NULL;
    path->share = rgb_grey(1);
    path->clear = 1;
    path->light = rgb_grey(0);
    path->opacity = 1;
    path->dues = path->last = path->due = NULL;
    path->seen = NULL;
    return path;
}

struct path *wavefront_root(struct wavefront *wavefront, struct radiance *seen)
{
    struct path *path = wavefront_path(wavefront);
    path->seen = seen;
    return path;
}

struct due *wavefront_due(struct path *path)
{
    struct wavefront *wavefront = path->wavefront;
    struct due *due = wavefront->idle_dues;
    if (due)
        wavefront->idle_dues = due->next;
    else
        due = ARENA_NEW(wavefront->worker->scratch, struct due);
    due->next = NULL;
    due->to = path;
    due->known = true;
    if (path->dues)
        path->last->next = due;
    else
        path->dues = due;
    path->last = due;
    return due;
}

struct path *wavefront_branch(struct path *path, rgb tint)
{
    struct wavefront *wavefront = path->wavefront;
    struct path *branch = wavefront_path(wavefront);
    struct due *due = wavefront_due(path);
    due->known = false;
    due->tint = tint;
    due->share = path->share;
    due->exponent = 1;
    branch->due = due;
    branch->straight = false;
    list_push(&wavefront->born, branch);
    return branch;
}

/* Takes the dues up to the first that isn't known. */
static void path_collect(struct path *path)
{
    struct wavefront *wavefront = path->wavefront;
    while (path->dues && path->dues->known) {
        struct due *due = path->dues;
        path->light = rgb_add(path->light, due->light);
        path->dues = due->next;
        due->next = wavefront->idle_dues;
        wavefront->idle_dues = due;
    }
}

/* A ray that has ended and has got all its light gives it to whom it is due,
 * who may have waited for that alone. */
static void path_settle(struct path *path)
{
    while (path && path->ended && !path->dues) {
        struct wavefront *wavefront = path->wavefront;
        struct due *due = path->due;
        path->next = wavefront->idle;
        wavefront->idle = path;
        if (!due) {
            *path->seen = (struct radiance){ path->light, path->opacity };
            return;
        }
        rgb light = finish_exponent(path->light, due->exponent);
        due->light = rgb_mul(due->share, rgb_mul(light, due->tint));
        due->known = true;
        path = due->to;
        path_collect(path);
    }
}

static void wavefront_open(struct wavefront *wavefront, struct path *path)
{
    bool mirrored = path->kind == RAY_REFLECTION;
    list_push(mirrored ? &wavefront->mirrored : &wavefront->open, path);
}

/* The first that was born is to be the first that is followed. */
static void wavefront_deliver(struct wavefront *wavefront)
{
    while (wavefront->born.count > 0)
        wavefront_open(wavefront, list_pop(&wavefront->born));
}

void wavefront_push(struct path *path)
{
    wavefront_open(path->wavefront, path);
    wavefront_deliver(path->wavefront);
}

void wavefront_end(struct path *path)
{
    struct wavefront *wavefront = path->wavefront;
    path->ended = true;
    path_settle(path);
    wavefront_deliver(wavefront);
}

void wavefront_leave(struct path *path, const struct crossing *crossing,
                     rgb light)
{
    if (path_leave(path, crossing, light) && ++path->surfaces < SURFACES_MAX)
        wavefront_push(path);
    else
        wavefront_end(path);
}

void wavefront_go_on(struct path *path, struct crossing *crossing, bool met)
{
    struct veil sky;
    if (!met)
        sky = sky_veil(path->tracer->scene, path->ray.direction);
    if (path_arrive(path, crossing, met ? NULL : &sky, NULL))
        wavefront_leave(path, crossing, path_light(path, crossing));
    else
        wavefront_end(path);
}
