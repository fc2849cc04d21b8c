/* See quartic_rays.h. */
#include "scene/quartic_rays.h"

/* Nothing is looked for in lanes that nobody asks about. */
static void leave_out(struct lane_run run, struct quartics *quartics)
{
    for (int i = 0; i < RAY_LANES; i++)
        if (i < run.first || i >= run.end)
            quartics->high[i] = -(double)INFINITY;
}

void quartic_rays_first(struct quartic_rays *lanes,
                        const struct quartic_asked *asked, struct rays_met *met)
{
    const struct rays_span *span = asked->span;
    const struct lane_run run = asked->run;
    struct quartic_roots found;
    if (lanes) {
        leave_out(run, &lanes->quartics);
        quartics_first(&lanes->quartics, lanes->least, &found);
    }
    for (int i = run.first; i < run.end; i++) {
        double near = span->near[i], far = span->far[i];
        struct hit hit;
        met->t[i] = (double)INFINITY;
        met->part[i] = 0;
        if (!(near < far) || (lanes && found.fate[i] == (double)QUARTIC_NONE))
            continue;
        double t =
            lanes ? (found.root[i] + lanes->shift[i]) / lanes->length[i] : near;
        if (lanes && found.fate[i] == (double)QUARTIC_ROOT && t > near) {
            met->t[i] = t <= far ? t : (double)INFINITY;
            continue;
        }
        const struct ray ray = rays_at(asked->rays, i);
        if (asked->first(asked->shape, &ray, near, far, &hit))
            met->t[i] = hit.t;
    }
}

void quartic_rays_cross(struct quartic_rays *lanes,
                        const struct quartic_asked *asked, lane_flag *met)
{
    const struct rays_span *span = asked->span;
    const struct lane_run run = asked->run;
    double fate[RAY_LANES];
    for (int i = run.first; lanes && i < run.end; i++) {
        double *low = &lanes->quartics.low[i], *high = &lanes->quartics.high[i];
        *low = *low > lanes->least[i] ? *low : lanes->least[i];
        *high = *high < lanes->most[i] ? *high : lanes->most[i];
    }
    if (lanes) {
        leave_out(run, &lanes->quartics);
        quartics_cross(&lanes->quartics, fate);
    }
    for (int i = run.first; i < run.end; i++) {
        double near = span->near[i], far = span->far[i];
        const struct ray ray = rays_at(asked->rays, i);
        if (!(near < far))
            met[i] = 0;
        else if (lanes && fate[i] != (double)QUARTIC_UNKNOWN)
            met[i] = fate[i] == (double)QUARTIC_ROOT ? -1 : 0;
        else
            met[i] = asked->crosses(asked->shape, &ray, near, far) ? -1 : 0;
    }
}
