/* See heritage.h. */
#include "view/heritage.h"

#include <string.h>

#include "base/memory.h"
#include "tracer/tracer.h"

static const double reach = 12; /* pixels */

struct heritage *heritage_new(const struct tracer *tracer,
                              const struct options *options, int lamp,
                              struct picture_shown *shown)
{
    struct heritage *heritage = memory_new(sizeof *heritage);
    const struct lighting *lighting = tracer->lighting;
    atomic_init(&heritage->users, 1);
    heritage->lighting = lighting;
    heritage->lamp = lamp;
    heritage->camera = tracer->scene->camera;
    heritage->shown = *shown;
    shown->show.arena = NULL;
    if (lighting->keep)
        heritage->kept = lighting->keep(tracer->lighting_state);
    if (options->show && heritage->shown.show.arena)
        snprintf(heritage->view, sizeof heritage->view, "%s", options->show);
    return heritage;
}

struct heritage *heritage_use(struct heritage *heritage)
{
    if (heritage)
        atomic_fetch_add(&heritage->users, 1);
    return heritage;
}

void heritage_leave(struct heritage *heritage)
{
    if (!heritage || atomic_fetch_sub(&heritage->users, 1) > 1)
        return;
    lighting_forget(&heritage->kept);
    if (heritage->shown.show.arena)
        show_free(&heritage->shown.show);
    memory_free(heritage);
}

bool heritage_shows(const struct heritage *heritage,
                    const struct options *options)
{
    return heritage && heritage->view[0] && options->show &&
           strcmp(heritage->view, options->show) == 0;
}

/* Who is looked for, and who is next so far. */
struct search {
    const struct camera *camera;
    const int *size;
    double x, y;  /* pixels */
    double least; /* squared distance of the next one, */
    double depth;
    double number; /* its number, */
    vec3 at;       /* and place */
    bool found;
};

/* A place in pixels; false: behind the camera. */
static bool search_place(const struct search *search, vec3 at, double place[2],
                         double *depth)
{
    vec3 view = camera_view(search->camera, at);
    *depth = view.z;
    if (!(view.z > 0))
        return false;
    camera_place(search->camera, view, &place[0], &place[1]);
    place[0] *= search->size[0];
    place[1] *= search->size[1];
    return true;
}

/* Of what is equally near to the pointer that which is nearer to the eye. */
static void search_take(struct search *search, double squared, double depth,
                        double number, vec3 at)
{
    if (!(squared < search->least ||
          (squared == search->least && depth < search->depth)))
        return;
    search->least = squared;
    search->depth = depth;
    search->number = number;
    search->at = at;
    search->found = true;
}

static void search_point(struct search *search, const struct show_point *point)
{
    double place[2], depth;
    if (!search_place(search, point->at, place, &depth))
        return;
    double x = place[0] - search->x, y = place[1] - search->y;
    search_take(search, x * x + y * y, depth, point->number, point->at);
}

/* Where the line is next to the pointer, as the picture has it. */
static void search_line(struct search *search, const struct show_line *line)
{
    double from[2], to[2], near, far;
    if (!search_place(search, line->from, from, &near) ||
        !search_place(search, line->to, to, &far))
        return;
    double x = to[0] - from[0], y = to[1] - from[1];
    double squared = x * x + y * y;
    double share =
        squared > 0
            ? ((search->x - from[0]) * x + (search->y - from[1]) * y) / squared
            : 0;
    share = fmin(fmax(share, 0), 1);
    x = from[0] + share * x - search->x;
    y = from[1] + share * y - search->y;
    search_take(search, x * x + y * y, near + share * (far - near),
                line->from_number +
                    share * (line->to_number - line->from_number),
                vec3_mix(line->from, line->to, share));
}

bool heritage_value(const struct heritage *heritage,
                    const struct camera *camera, const double at[2],
                    const int size[2], char *text, size_t text_size)
{
    const struct show *show = &heritage->shown.show;
    struct search search = { .camera = camera,
                             .size = size,
                             .x = at[0] * size[0],
                             .y = at[1] * size[1],
                             .least = reach * reach };
    if (!heritage->view[0] || camera_is_bent(camera))
        return false;
    for (size_t i = 0; i < show->points.count; i++)
        search_point(&search, &show->points.items[i]);
    for (size_t i = 0; i < show->lines.count; i++)
        search_line(&search, &show->lines.items[i]);
    if (search.found)
        snprintf(text, text_size, "%s %.4g at <%.4g, %.4g, %.4g>", show->what,
                 search.number, search.at.x, search.at.y, search.at.z);
    return search.found;
}
