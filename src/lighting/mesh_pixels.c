/* Mesh points of the picture: see mesh_pixels.h. */
#include "lighting/mesh_pixels.h"

#include "base/memory.h"
#include "lightmesh/stagger.h"
#include "shade/surface.h"

/* Larger pictures, and more points or lamps, take too much memory: 100 MB
 * for what is seen first, and 40 MB for a bit for each point and lamp. */
static const double most_places = 2.5e6, most_pairs = 3.2e8;

/* What shares of area lights may take, in bytes. */
static const double most_shares = 64e6;

/* With those of small surfaces there are about so many times the points. */
static const double points_share = 1.5;

/* Of lamps / lamps_apart pixels one is a point, of more lamps not so much
 * fewer: then points take about as long whatever their number. */
static const double lamps_apart = 14;

/* Measured, in seconds: what a lamp takes for each triangle and each point; a
 * ray; what points in space take for each pixel, more of more lamps up to
 * more_most. The first may be so many times as long, for it leaves a third of
 * the error. */
static const double lamp_triangle = 26e-9, lamp_point = 15e-9, ray = 0.3e-6;
static const double space_pixel = 0.8e-6, exact_worth = 3;
static const double more_lamps = 100, more_most = 4;

/* Shadow rays begin so far above a surface, and of what is nearer than part of
 * a pixel no shadow is seen. */
static const double usual_detail = 1e-3, pixel_detail = 0.1;

/* Of few lamps, which surfaces else ask by rays: it is to be so much quicker.
 */
static const double rays_share = 0.25;

/* Of pairs of points and lamps those that a ray may have to decide: half of the
 * lamps are behind the surface, and lines are longer than ways. */
static const double asked_most = 0.3;

static double lamps_more(const struct mesh_pixels *pixels)
{
    double lamps = (double)pixels->lamps->count;
    return fmin(fmax(lamps / more_lamps, 1), more_most);
}

static int pixels_apart(const struct mesh_pixels *pixels)
{
    double lamps = (double)pixels->lamps->count;
    double apart = lamps / (lamps_apart * lamps_more(pixels));
    if (pixels->each)
        return 1;
    return stagger_apart(apart / (pixels->finer * pixels->finer));
}

struct mesh_pixels mesh_pixels_new(const struct lamps *lamps,
                                   const struct scene *scene, double finer,
                                   double pixel)
{
    return (struct mesh_pixels){
        .off = lamps->quality < QUALITY_SHADOWS,
        .soft = lamps->quality >= QUALITY_AREA_LIGHTS,
        .finer = finer,
        .detail = fmax(usual_detail, pixel * pixel_detail),
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
    double each = pixels->each ? 1 : points_share / pixels_apart(pixels);
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
    double rays = asked_most * (1 - exp(-casters->doubt)) * points;
    return (double)pixels->lamps->count *
           (triangles * lamp_triangle + points * lamp_point + rays * ray);
}

/* Seconds that it may take before points in space are better. */
static double pixels_worth(const struct mesh_pixels *pixels,
                           const struct first_hits *grid)
{
    if (pixels->each)
        return pixels_places(grid) * (double)pixels->lamps->count * ray *
               rays_share;
    return exact_worth * pixels_places(grid) * space_pixel *
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
    return count > 0 && pixels_places(grid) <= most_places &&
           penumbras_bytes(pixels_places(grid), count) <= most_shares;
}

/* Whether lamps that are points are to look at them. */
static bool pixels_sharp(struct mesh_pixels *pixels,
                         const struct first_hits *grid)
{
    const struct world *world = pixels->lamps->world;
    double lamps = (double)pixels->lamps->count;
    double worth = pixels_worth(pixels, grid);
    if (pixels->off || pixels_places(grid) > most_places ||
        pixels_points(pixels, grid) * lamps > most_pairs ||
        (double)world_triangle_count(world) * lamps * lamp_triangle > worth)
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
