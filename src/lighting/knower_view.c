/* Asks again what was asked for the picture: see knower_view.h. */
#include "lighting/knower_view.h"

#include <stdio.h>

#include "shade/interior.h"

enum { VIEW_STEP = 3 }; /* pixels from one place to the next */

static const char *view_words(struct arena *arena)
{
    enum { SIZE = 200 };
    char *text = arena_alloc(arena, SIZE);
    int length = snprintf(text, SIZE, "who knows the lamps,");
    for (int i = 0; knower_at((size_t)i) && length < SIZE; i++)
        length += snprintf(text + length, (size_t)(SIZE - length), " %d %s,", i,
                           knower_at((size_t)i)->name);
    return text;
}

/* The last that was needed for all lamps. */
static int view_ask(const struct mesh_lamps *lamps, struct worker *worker,
                    const struct receiver *receiver,
                    const struct interiors *inside)
{
    const struct lamps *all = lamps->knowers->lamps;
    int last = -1;
    struct asking asking;
    struct incident incident;
    asking_start(&asking, lamps->knowers, worker, receiver, inside);
    if (lamps->knowers->direct->many) {
        asking_all_lamps(&asking, &incident);
        return asking.answered;
    }
    for (size_t i = 0; i < all->count; i++) {
        const struct lamp *lamp = &all->items[i];
        struct lamp_view view;
        if (asking_rules_out(&asking, lamp) ||
            !lamp_look(lamp, lamp->light->location, receiver->point, &view))
            continue;
        asking_one_lamp(&asking, lamp, &view);
        last = asking.answered > last ? asking.answered : last;
    }
    return last;
}

static void view_pixel(const struct mesh_lamps *lamps, struct worker *worker,
                       const struct picture_place *place, struct show *show)
{
    const struct lamps *all = lamps->knowers->lamps;
    const struct camera *camera = &all->scene->camera;
    struct interiors inside = { .count = 0 };
    struct intersection at;
    if (!camera_sees(camera, place->at[0], place->at[1]))
        return;
    struct ray ray = camera_ray(camera, place->at[0], place->at[1]);
    if (!world_closest(all->world, &ray, 0, RAY_CAMERA, &at))
        return;
    vec3 side = vec3_against(at.face, ray.direction);
    struct receiver receiver = { .point = at.point,
                                 .side = side,
                                 .smooth = side,
                                 .normal = side,
                                 .from = ray.origin,
                                 .at = &at,
                                 .pixel = place,
                                 .view = lamps->view,
                                 .weight = 1 };
    int knower = view_ask(lamps, worker, &receiver, &inside);
    if (knower >= 0)
        *ARRAY_PUSH(show->arena, &show->points) =
            (struct show_point){ at.point, knower };
}

void knower_view_give(const struct mesh_lamps *lamps, int width, int height,
                      struct show *show)
{
    struct worker worker = { .scratch = arena_new(0) };
    show->what = view_words(show->arena);
    for (int y = 0; y < height; y += VIEW_STEP)
        for (int x = 0; x < width; x += VIEW_STEP) {
            struct picture_place place = {
                { (x + 0.5) / width, (y + 0.5) / height }, { x, y }
            };
            view_pixel(lamps, &worker, &place, show);
            arena_reset(worker.scratch);
        }
    arena_free(worker.scratch);
}
