/* Mesh points of the picture: see mesh_pixels.h. */
#include "lighting/mesh_pixels.h"

#include "base/memory.h"
#include "lightmesh/stagger.h"
#include "lightmesh/tuning.h"
#include "shade/surface.h"

static double lamps_more(const struct mesh_pixels *pixels)
{
    double lamps = (double)pixels->lamps->count;
    return fmin(fmax(lamps / pixel_lamps_more, 1), pixel_more_most);
}

static int pixels_apart(const struct mesh_pixels *pixels)
{
    double lamps = (double)pixels->lamps->count;
    double apart = lamps / (pixel_lamps_apart * lamps_more(pixels));
    if (pixels->each)
        return 1;
    return stagger_apart(apart / (pixels->plan->finer * pixels->plan->finer));
}

struct mesh_pixels mesh_pixels_new(const struct lamps *lamps,
                                   const struct scene *scene,
                                   const struct plan *plan, double pixel)
{
    return (struct mesh_pixels){
        .off = !plan->pixels,
        .each = plan->lamps == PLAN_EACH,
        .soft = plan->penumbras,
        .plan = plan,
        .detail = fmax(pixel_detail_least, pixel * pixel_detail),
        .lamps = lamps,
        .scene = scene,
    };
}

static void pixels_forget(struct mesh_pixels *pixels)
{
    pixel_mesh_free(pixels->mesh);
    penumbras_free(pixels->penumbras);
    memory_free(pixels->hits);
    pixels->mesh = NULL;
    pixels->penumbras = NULL;
    pixels->hits = NULL;
}

void mesh_pixels_free(struct mesh_pixels *pixels)
{
    pixels_forget(pixels);
    casters_free(&pixels->casters);
    memory_free(pixels->takes);
}

/* Takes the world apart, and asks which lamps can look at it: all of them, or
 * at least one if each is known. */
static bool pixels_start(struct mesh_pixels *pixels)
{
    const struct lamps *lamps = pixels->lamps;
    size_t taken = 0;
    if (!casters_new(&pixels->casters, lamps->world))
        return false;
    pixels->takes = memory_new(lamps->count * sizeof *pixels->takes);
    for (size_t i = 0; i < lamps->count; i++) {
        pixels->takes[i] = lamp_sights_take(lamps, &lamps->items[i],
                                            &pixels->casters, pixels->detail);
        taken += pixels->takes[i];
    }
    return taken > 0 && (pixels->each || taken == lamps->count);
}

/* All figures are of the whole picture, though not all of it may be wanted. */
static double pixels_places(const struct first_hits *grid)
{
    return (double)grid->width * (double)grid->height;
}

static double pixels_points(const struct mesh_pixels *pixels,
                            const struct first_hits *grid)
{
    double each = pixels->each ? 1 : pixel_points / pixels_apart(pixels);
    return each * pixels_places(grid);
}

/* What there is to do, if so many triangles throw shadows. */
static struct knower_job pixels_job(const struct mesh_pixels *pixels,
                                    const struct first_hits *grid,
                                    double triangles, double doubt)
{
    double points = pixels_points(pixels, grid);
    return (struct knower_job){
        .pixels = pixels_places(grid),
        .lamps = (double)pixels->lamps->count,
        .triangles = triangles,
        .points = points,
        .doubtful = pixel_rays_most * (1 - exp(-doubt)) * points,
        .finer = pixels->plan->finer,
    };
}

/* Whether there are area lights to be asked. */
static bool pixels_soft(const struct mesh_pixels *pixels,
                        const struct first_hits *grid)
{
    const struct lamps *lamps = pixels->lamps;
    size_t count = 0;
    for (size_t i = 0; pixels->soft && i < lamps->count; i++)
        count += penumbra_takes(lamps, &lamps->items[i]);
    return count > 0 && pixels_places(grid) <= pixels_most &&
           penumbras_bytes(pixels_places(grid), count) <= penumbra_bytes_most;
}

/* Whether lamps that are points are to look at them. Taking the world apart is
 * work in itself, not begun if its triangles alone are too many. */
static bool pixels_sharp(struct mesh_pixels *pixels,
                         const struct first_hits *grid)
{
    const struct world *world = pixels->lamps->world;
    const struct casters *casters = &pixels->casters;
    double lamps = (double)pixels->lamps->count;
    struct knower_job least = { 0 };
    if (pixels->off || pixels_places(grid) > pixels_most ||
        pixels_points(pixels, grid) * lamps > pixel_pairs_most)
        return false;
    least = pixels_job(pixels, grid, (double)world_triangle_count(world), 0);
    least.points = 0;
    least.doubtful = 0;
    if (!knower_pixels_pay(pixels->plan, &least) || pixels->takes ||
        !pixels_start(pixels))
        return false;
    const struct knower_job job =
        pixels_job(pixels, grid,
                   (double)(casters->certain.count + casters->doubtful.count),
                   casters->doubt);
    return knower_pixels_pay(pixels->plan, &job);
}

bool mesh_pixels_wanted(struct mesh_pixels *pixels, struct first_hits *grid)
{
    pixels_forget(pixels);
    if (camera_blurs(&pixels->scene->camera)) /* its pixels see many places */
        return false;
    pixels->soft = pixels_soft(pixels, grid);
    pixels->off = !pixels_sharp(pixels, grid);
    if (!pixels->soft && pixels->each) /* a pixel asks no other */
        grid->apron = 0;
    return pixels->soft || !pixels->off;
}

void mesh_pixels_make(struct mesh_pixels *pixels, const struct first_hits *hits,
                      struct worker *const *workers, unsigned threads)
{
    struct pixel_mesh_options options = {
        .casters = &pixels->casters,
        .lamps = pixels->lamps,
        .takes = pixels->takes,
        .camera = &pixels->scene->camera,
        .apart = pixels_apart(pixels),
        .each = pixels->each,
    };
    pixels->hits = hits->at;
    if (!pixels->off)
        pixels->mesh = pixel_mesh_new(&options, hits, workers, threads);
    if (pixels->soft)
        pixels->penumbras = penumbras_new(pixels->lamps, &pixels->scene->camera,
                                          hits, workers, threads);
}
