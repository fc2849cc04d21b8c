/* Flat cells: see corner_cell.h. */
#include "lightmesh/corner_cell.h"

#include "lightmesh/tuning.h"

/* Of a cell's step: what is no higher is on one plane, but for rounding. */
static const double cell_thickness = 1e-6;

/* Normals that are the same but for rounding. */
static bool sides_agree(vec3 a, vec3 b)
{
    return vec3_dot(a, b) > 1 - 1e-9;
}

static bool on_plane(const struct corner_cell *cell, vec3 point, vec3 side)
{
    vec3 between = vec3_sub(point, cell->plane.point);
    return sides_agree(side, cell->plane.side) &&
           fabs(vec3_dot(between, cell->plane.side)) <= cell->thick;
}

/* The plane that the first corner is on which there is. Returns whether there
 * is one. */
static bool cell_plane(const struct corner_store *store, struct worker *worker,
                       struct corner_cell *cell, const struct receiver *like)
{
    bool met = false;
    cell->thick = cell_thickness * store->grid->step[cell->name.level];
    for (int i = 0; i < GRID_CORNERS && !met; i++) {
        cell->plane = *corner_store_corner(store, worker, cell, i, like);
        met = cell->plane.met;
    }
    return met;
}

/* A cell whose corners are looked at. */
struct clipping {
    const struct corner_store *store;
    struct worker *worker;
    struct corner_cell *cell;
    const struct receiver *like;
    vec3 along[2]; /* from corner to corner on its plane */
    bool has[GRID_CORNERS], hidden[GRID_CORNERS]; /* from the camera alone */
    int count;                                    /* of those it has */
};

/* How far it is clear from a corner along so much of a way, a little above the
 * surface: a share of it. */
static double clipping_clear(const struct clipping *clipping, vec3 from,
                             vec3 along)
{
    double length = vec3_length(along);
    double lift = indirect_pixels_lift * length;
    struct intersection at;
    struct ray ray = { vec3_along(from, clipping->cell->plane.side, lift),
                       vec3_scale(along, 1 / length) };
    struct glimpse glimpse = { 0, length, gather_spread };
    clipping->worker->counters.shadow_rays++;
    return world_glimpse(clipping->store->mesh->points.world, &ray, glimpse,
                         RAY_GATHER, &at)
               ? at.t / length
               : 1;
}

/* From a corner to the one beside it along an axis, and what that way is
 * called: 1 to 4. */
static vec3 clipping_way(const struct clipping *clipping, int from, int axis,
                         int *way)
{
    bool low = from >> axis & 1;
    *way = 1 + 2 * axis + low;
    return vec3_scale(clipping->along[axis], low ? -1 : 1);
}

/* Puts another place there instead of a corner, so far from corner `from`. */
static void clipping_move(const struct clipping *clipping, int corner, int way,
                          int from, vec3 along)
{
    struct cell_place *place = &clipping->cell->place[corner];
    place->way = way;
    place->corner = clipping->cell->place[from].corner;
    place->corner.point = vec3_add(place->corner.point, along);
    place->corner.from = vec3_add(place->corner.from, along);
}

/* Finds what stands for the one that is missing beside corner `from` along an
 * axis. Where its line met another surface, as that of a ball which lies here,
 * light falls off towards that, and what is said beside doesn't do. */
static bool clipping_beside(struct clipping *clipping, int from, int axis)
{
    struct corner_cell *cell = clipping->cell;
    int missing = from ^ (1 << axis), row = from >> (1 - axis) & 1, way;
    bool low = from >> axis & 1;
    vec3 along = clipping_way(clipping, from, axis, &way);
    double clear =
        clipping_clear(clipping, cell->place[from].corner.point, along);
    if (clear >= 1 && !clipping->hidden[missing]) {
        cell->place[missing].like = from;
        return !(cell->place[missing].corner.reach > 0);
    }
    double far = clear < 1 ? clear - clip_before : 1;
    if (far < clip_least)
        return false;
    clipping_move(clipping, missing, way, from, vec3_scale(along, far));
    cell->end[axis][row][low ? 0 : 1] = low ? 1 - far : far;
    return true;
}

/* Where the other row ends: where the one does that is known. */
static void clipping_square(struct clipping *clipping, int from)
{
    for (int axis = 0; axis < 2; axis++) {
        const int row = from >> (1 - axis) & 1;
        double(*end)[2] = clipping->cell->end[axis];
        end[!row][0] = end[row][0];
        end[!row][1] = end[row][1];
    }
}

/* The same of the one across from the only one there is. */
static bool clipping_across(struct clipping *clipping, int from)
{
    struct cell_place *place = clipping->cell->place;
    const int beside = from ^ 1, below = from ^ 2, across = from ^ 3;
    bool bare = place[beside].like >= 0, open = place[below].like >= 0;
    clipping_square(clipping, from);
    if (bare || open) {
        place[across].like = bare && open ? from : bare ? below : beside;
        return true;
    }
    vec3 along = vec3_sub(place[below].corner.point, place[from].corner.point);
    clipping_move(clipping, across, 5 + from, beside, along);
    return clipping_clear(clipping, place[beside].corner.point, along) >= 1;
}

/* One that is missing alone: what is hidden from the camera serves. */
static bool clipping_alone(struct clipping *clipping, int missing)
{
    const struct cell_place *place = clipping->cell->place;
    if (!clipping->hidden[missing])
        return false;
    for (int axis = 0; axis < 2; axis++) {
        int from = missing ^ (1 << axis), way;
        vec3 along = clipping_way(clipping, from, axis, &way);
        if (clipping_clear(clipping, place[from].corner.point, along) < 1)
            return false;
        clipping_move(clipping, missing, way, from, along);
    }
    return true;
}

/* Square of the longest way through it. */
static double clipping_diagonal2(const struct clipping *clipping)
{
    const vec3 *along = clipping->along;
    double fold = 2 * fabs(vec3_dot(along[0], along[1]));
    return vec3_dot(along[0], along[0]) + vec3_dot(along[1], along[1]) + fold;
}

static bool clipping_sides(struct clipping *clipping)
{
    const bool *has = clipping->has;
    for (int i = 0; i < GRID_CORNERS; i++)
        for (int axis = 0; axis < 2; axis++)
            if (has[i] && !has[i ^ (1 << axis)] &&
                !clipping_beside(clipping, i, axis))
                return false;
    return true;
}

/* The first that is there, or isn't. */
static int clipping_first(const struct clipping *clipping, bool has)
{
    int i = 0;
    while (i < GRID_CORNERS && clipping->has[i] != has)
        i++;
    return i;
}

/* What stands for the corners that are missing. Returns false where that can't
 * be said. */
static bool cell_clip(struct clipping *clipping)
{
    struct corner_cell *cell = clipping->cell;
    const bool *has = clipping->has;
    for (int axis = 0; axis < 2; axis++)
        clipping->along[axis] =
            grid_cell_along(&cell->name, cell->plane.side, axis,
                            clipping->store->grid->step[cell->name.level]);
    cell->reaches = clipping_diagonal2(clipping) <= cell->reach2;
    cell->clipped = clipping->count < GRID_CORNERS;
    if (!cell->clipped)
        return true;
    switch (clipping->count) {
    case 1:
        return clipping_sides(clipping) &&
               clipping_across(clipping, clipping_first(clipping, true));
    case 2:
        return has[0] != has[3] && clipping_sides(clipping);
    default:
        return clipping_alone(clipping, clipping_first(clipping, false));
    }
}

/* Puts the grid's own corner there, if it is on the plane. Returns false if the
 * surface bends. */
static bool clipping_own(struct clipping *clipping, int i)
{
    struct corner_cell *cell = clipping->cell;
    struct cell_place *place = &cell->place[i];
    const struct corner *corner = corner_store_corner(
        clipping->store, clipping->worker, cell, i, clipping->like);
    const struct receiver plane =
        corner_receiver(&cell->plane, clipping->like, cell->coarser);
    bool on = corner->reach > 0 && on_plane(cell, corner->point, corner->side);
    *place = (struct cell_place){ .like = -1, .corner = *corner };
    clipping->has[i] = on && corner->met;
    clipping->hidden[i] = on && !corner->met;
    clipping->count += clipping->has[i];
    return clipping->has[i] || !corner_serves(corner, &plane);
}

/* Whether the others are on it, or what stands for them. Says the same whoever
 * asks first. */
static bool cell_flat(const struct corner_store *store, struct worker *worker,
                      struct corner_cell *cell, const struct receiver *like)
{
    struct clipping clipping = {
        .store = store, .worker = worker, .cell = cell, .like = like
    };
    cell->reach2 = HUGE_VAL;
    for (int i = 0; i < GRID_CORNERS; i++) {
        cell->end[0][i % 2][i / 2] = cell->end[1][i % 2][i / 2] = i / 2;
        if (!clipping_own(&clipping, i))
            return false;
        double reach = cell->place[i].corner.reach;
        if (clipping.has[i])
            cell->reach2 = fmin(cell->reach2, reach * reach);
    }
    return cell_clip(&clipping);
}

/* What is not on the plane of the first corner needs no others. */
static bool cell_bends(const struct corner_store *store, struct worker *worker,
                       struct corner_cell *cell,
                       const struct receiver *receiver)
{
    if (cell->flat == 0 && !cell_plane(store, worker, cell, receiver))
        cell->flat = -1;
    if (cell->flat < 0 || !on_plane(cell, receiver->point, receiver->side))
        return true;
    if (cell->flat == 0)
        cell->flat = cell_flat(store, worker, cell, receiver) ? 1 : -1;
    return cell->flat < 0;
}

static double mixed(const double ends[2], double share)
{
    return ends[0] + (ends[1] - ends[0]) * share;
}

/* Where a place is between the ends, which may be a little beyond. */
static bool clipped_place(const struct corner_cell *cell, int axis, double at,
                          double across, double *place)
{
    const double low[2] = { cell->end[axis][0][0], cell->end[axis][1][0] },
                 high[2] = { cell->end[axis][0][1], cell->end[axis][1][1] };
    double from = mixed(low, across), to = mixed(high, across);
    *place = fmin(fmax((at - from) / (to - from), 0), 1);
    return at > from - 2 * clip_before && at < to + 2 * clip_before;
}

static bool clipped_weights(const struct corner_cell *cell,
                            double weight[GRID_CORNERS])
{
    double x = weight[1] + weight[3], y = weight[2] + weight[3], place[2];
    if (!clipped_place(cell, 0, x, y, &place[0]) ||
        !clipped_place(cell, 1, y, x, &place[1]))
        return false;
    for (int i = 0; i < GRID_CORNERS; i++)
        weight[i] = (i & 1 ? place[0] : 1 - place[0]) *
                    (i & 2 ? place[1] : 1 - place[1]);
    return true;
}

static bool cell_is_far(const struct corner_cell *cell, vec3 point)
{
    for (int i = 0; i < GRID_CORNERS; i++) {
        if (cell->place[i].like >= 0)
            continue;
        vec3 between = vec3_sub(point, cell->place[i].corner.point);
        if (vec3_dot(between, between) > cell->reach2)
            return true;
    }
    return false;
}

enum corner_hold corner_cell_holds(const struct corner_store *store,
                                   struct worker *worker,
                                   struct corner_cell *cell,
                                   const struct receiver *receiver,
                                   double weight[GRID_CORNERS])
{
    if (cell_bends(store, worker, cell, receiver))
        return CELL_BENT;
    if (!cell->reaches && cell_is_far(cell, receiver->point))
        return CELL_FAR;
    if (!cell->clipped)
        return CELL_HOLDS;
    return clipped_weights(cell, weight) ? CELL_CLIPPED : CELL_BENT;
}

double shares_differ(const struct indirect_share *const *shares, int count)
{
    double least = HUGE_VAL, most = 0;
    for (int i = 0; i < count; i++) {
        double amount = rgb_brightness(shares[i]->light) +
                        indirect_pixels_open * shares[i]->open;
        least = fmin(least, amount);
        most = fmax(most, amount);
    }
    return (most - least) / (most + indirect_pixels_dim);
}

double shares_evenness(double differ)
{
    double beyond = differ / indirect_pixels_same - 1;
    return fmin(fmax(1 - beyond / indirect_pixels_fade, 0), 1);
}

void corner_cell_ask(const struct corner_store *store, struct worker *worker,
                     struct corner_cell *cell, const struct receiver *like)
{
    const struct indirect_share *shares[GRID_CORNERS];
    if (cell->told)
        return;
    for (int i = 0; i < GRID_CORNERS; i++) {
        int other = cell->flat > 0 ? cell->place[i].like : -1;
        if (other < 0)
            cell->share[i] = corner_store_share(store, worker, cell, i, like);
        shares[i] = &cell->share[other < 0 ? i : other];
    }
    for (int i = 0; i < GRID_CORNERS; i++)
        cell->share[i] = *shares[i];
    cell->differ = shares_differ(shares, GRID_CORNERS);
    cell->told = true;
}

/* What stands for a corner; NULL: another. */
static const struct corner *cell_corner(const struct corner_store *store,
                                        struct worker *worker,
                                        struct corner_cell *cell, int i,
                                        const struct receiver *like)
{
    if (cell->flat <= 0)
        return corner_store_corner(store, worker, cell, i, like);
    return cell->place[i].like < 0 ? &cell->place[i].corner : NULL;
}

static bool cell_clear(const struct corner_store *store, struct worker *worker,
                       struct corner_cell *cell, const struct receiver *like)
{
    for (int i = 0; i < GRID_CORNERS; i++) {
        const struct corner *corner = cell_corner(store, worker, cell, i, like);
        if (!corner)
            continue;
        if (!corner->met)
            return false;
        for (int j = 0; j < i; j++) {
            const struct corner *from =
                cell_corner(store, worker, cell, j, like);
            if (!from)
                continue;
            const struct receiver other =
                corner_receiver(from, like, cell->coarser);
            if (!corner_sees(corner, store->mesh, worker, &other))
                return false;
        }
    }
    return true;
}

bool corner_cell_clear(const struct corner_store *store, struct worker *worker,
                       struct corner_cell *cell, const struct receiver *like)
{
    if (cell->clear == 0)
        cell->clear = cell_clear(store, worker, cell, like) ? 1 : -1;
    return cell->clear > 0;
}

bool corner_cell_whole(const struct corner_store *store, struct worker *worker,
                       struct corner_cell *cell, const struct receiver *like)
{
    return cell->differ <= indirect_pixels_even ||
           corner_cell_clear(store, worker, cell, like);
}
