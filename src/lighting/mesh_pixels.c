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
    return stagger_apart(apart / (pixels->finer * pixels->finer));
}

struct mesh_pixels mesh_pixels_new(const struct lamps *lamps,
                                   const struct scene *scene,
                                   const struct plan *plan, double pixel)
{
    return (struct mesh_pixels){
        .off = !plan->pixels,
        .each = plan->lamps == PLAN_EACH,
        .soft = plan->penumbras,
        .finer = plan->finer,
        .detail = fmax(pixel_detail_least, pixel * pixel_detail),
        .lamps = lamps,
        .scene = scene,
    };
}

void mesh_pixels_free(struct mesh_pixels *pixels)
{
    pixel_mesh_free(pixels->mesh);
    penumbras_free(pixels->penumbras);
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

/* Seconds that it would take. */
static double pixels_cost(const struct mesh_pixels *pixels,
                          const struct first_hits *grid)
{
    const struct casters *casters = &pixels->casters;
    double points = pixels_points(pixels, grid);
    double triangles =
        (double)(casters->certain.count + casters->doubtful.count);
    double rays = pixel_rays_most * (1 - exp(-casters->doubt)) * points;
    return (double)pixels->lamps->count *
           (triangles * time_lamp_triangle + points * time_lamp_point +
            rays * time_ray);
}

/* Seconds that it may take before points in space are better. */
static double pixels_worth(const struct mesh_pixels *pixels,
                           const struct first_hits *grid)
{
    if (pixels->each)
        return pixels_places(grid) * (double)pixels->lamps->count * time_ray *
               pixel_rays_share;
    return pixel_worth * pixels_places(grid) * time_space_pixel *
           lamps_more(pixels) * pixels->finer;
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

/* Whether lamps that are points are to look at them. */
static bool pixels_sharp(struct mesh_pixels *pixels,
                         const struct first_hits *grid)
{
    const struct world *world = pixels->lamps->world;
    double lamps = (double)pixels->lamps->count;
    double worth = pixels_worth(pixels, grid);
    if (pixels->off || pixels_places(grid) > pixels_most ||
        pixels_points(pixels, grid) * lamps > pixel_pairs_most ||
        (double)world_triangle_count(world) * lamps * time_lamp_triangle >
            worth)
        return false;
    return !pixels->takes && pixels_start(pixels) &&
           pixels_cost(pixels, grid) <= worth;
}

bool mesh_pixels_wanted(struct mesh_pixels *pixels,
                        const struct first_hits *grid)
{
    pixels->soft = pixels_soft(pixels, grid);
    pixels->off = !pixels_sharp(pixels, grid);
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
    if (!pixels->off)
        pixels->mesh = pixel_mesh_new(&options, hits, workers, threads);
    if (pixels->soft)
        pixels->penumbras = penumbras_new(pixels->lamps, &pixels->scene->camera,
                                          hits, workers, threads);
}
