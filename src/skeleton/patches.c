/* Walls of the void: see patches.h. What many lamps give is estimated without
 * bias: of each point some lamps are asked, chosen in proportion to what they
 * would give without shadows, and of many points some. */
#include "skeleton/patches.h"

#include "base/memory.h"
#include "base/parallel.h"
#include "base/random.h"
#include "base/warp.h"
#include "shade/area.h"
#include "shade/finish.h"
#include "shade/shadow.h"
#include "skeleton/wall.h"

enum {
    SHADOW_RAYS = 400 * 1000, /* in all, about */
    LAMP_LOOKS = 8 * 1000 * 1000,
    BEYOND_LAMPS = 8, /* asked at a point outside of the grid */
    CHUNK = 256       /* patches that a thread does at once */
};

struct patches_task {
    const struct patches_scene *from;
    const struct voxels *voxels;
    struct patches *patches;
    const struct wall_point *points;
    size_t lamps_each; /* asked at a point */
    double share;      /* of the points that are asked at all */
};

/* A point on a surface, seen from within the void. */
struct patch_point {
    struct intersection at;
    struct surface surface;
    rgb albedo, emission;
    const struct finish *finish; /* by which lamps' light counts */
};

static struct patch_light patch_light(rgb light)
{
    return (struct patch_light){ (float)light.r, (float)light.g,
                                 (float)light.b };
}

/* All layers together, for light from all around. */
static void patch_paint(struct patch_point *point)
{
    const struct surface *surface = &point->surface;
    point->albedo = point->emission = rgb_grey(0);
    for (int i = 0; i < surface->count; i++) {
        const struct surface_layer *layer = &surface->layer[i];
        rgb dark = finish_glow(layer, rgb_grey(0), rgb_grey(0));
        rgb lit = finish_glow(layer, rgb_grey(0), rgb_grey(1));
        point->emission =
            rgb_add(point->emission, rgb_mul(layer->weight, dark));
        point->albedo =
            rgb_add(point->albedo, rgb_mul(layer->weight, rgb_sub(lit, dark)));
    }
    point->albedo = rgb_scale(point->albedo, surface_restraint(surface));
    if (point->finish)
        point->albedo = rgb_scale(point->albedo, finish_around(point->finish));
}

/* The surface at point->at, met by a ray of this direction. */
static void patch_look(struct patch_point *point, vec3 direction)
{
    struct surface_view view = {
        .direction = direction, .ior = 1, .quality = QUALITY_FOG, .bailout = 0
    };
    surface_fill(&point->surface, &point->at, &view);
    point->finish = texture_finish(point->at.texture);
    patch_paint(point);
}

/* Where on an area light this point looks. */
static vec3 lamp_point(const struct lamp *lamp, vec3 point, uint64_t key)
{
    const struct light *light = lamp->light;
    if (!light->area || lamp_is_parallel(lamp))
        return light->location;
    const double u[2] = { random_unit(random_key(key, 1)),
                          random_unit(random_key(key, 2)) };
    return area_anywhere(lamp, point, u);
}

/* Without shadows: the irradiance from all around that does as much. */
static rgb lamp_gives(const struct lamp *lamp, const struct patch_point *point,
                      vec3 location, struct lamp_view *view)
{
    if (!lamp_is_for(lamp, point->at.leaf) ||
        !lamp_look(lamp, location, point->at.point, view))
        return rgb_grey(0);
    double cosine = vec3_dot(view->direction, point->surface.normal);
    double counts = cosine < 0 ? surface_behind(&point->surface) : 1;
    cosine = fabs(cosine);
    if (!(counts * cosine > 0))
        return rgb_grey(0);
    if (point->finish)
        cosine =
            finish_cosine(point->finish, cosine) / finish_around(point->finish);
    return rgb_scale(lamp->light->colour, counts * cosine * view->attenuation);
}

static rgb lamp_reaches(const struct patches_task *task,
                        const struct lamp *lamp,
                        const struct patch_point *point, uint64_t key)
{
    const struct scene *scene = task->from->ambience->scene;
    bool fog = lamp->light->media_attenuation && scene->fogs.count > 0;
    struct worker worker = { 0 };
    struct lamp_view view;
    vec3 location = lamp_point(lamp, point->at.point, key);
    rgb light = lamp_gives(lamp, point, location, &view);
    struct shadow_path path = { .point = point->at.point,
                                .direction = view.direction,
                                .distance = view.distance,
                                .light = lamp->number,
                                .fog = fog ? scene : NULL };
    if (rgb_peak(light) == 0 || lamp->light->shadowless)
        return light;
    return rgb_mul(light, shadow_visibility(task->from->world, &worker, &path));
}

static double lamp_weight(const struct lamp *lamp,
                          const struct patch_point *point)
{
    struct lamp_view view;
    return rgb_peak(lamp_gives(lamp, point, lamp->light->location, &view));
}

/* Some lamps for all: each draw divided by its probability. */
static rgb lamps_drawn(const struct patches_task *task,
                       const struct patch_point *point, uint64_t key)
{
    const struct patches_scene *from = task->from;
    double total = 0, before = 0;
    size_t draw = 0;
    rgb sum = rgb_grey(0);
    for (size_t i = 0; i < from->lamp_count; i++)
        total += lamp_weight(&from->lamps[i], point);
    double step = total / (double)task->lamps_each;
    double next = step * random_unit(key);
    for (size_t i = 0; i < from->lamp_count && total > 0; i++) {
        double weight = lamp_weight(&from->lamps[i], point);
        for (; weight > 0 && next < before + weight; next += step) {
            rgb light = lamp_reaches(task, &from->lamps[i], point,
                                     random_key(key, ++draw));
            sum = rgb_add_scaled(sum, light, step / weight);
        }
        before += weight;
    }
    return sum;
}

static rgb patch_direct(const struct patches_task *task,
                        const struct patch_point *point, uint64_t key)
{
    const struct patches_scene *from = task->from;
    rgb sum = rgb_grey(0);
    if (rgb_peak(point->albedo) == 0)
        return sum;
    if (task->lamps_each < from->lamp_count)
        return lamps_drawn(task, point, key);
    for (size_t i = 0; i < from->lamp_count; i++)
        sum = rgb_add(sum, lamp_reaches(task, &from->lamps[i], point,
                                        random_key(key, i)));
    return sum;
}

/* The true normal on the side that the void is on. */
static vec3 patch_faces(const struct wall_point *wall)
{
    return vec3_against(wall->at.face, wall->direction);
}

static void patch_fill(const struct patches_task *task, size_t number)
{
    const struct wall_point *wall = &task->points[number];
    struct wall_patch *patch = &task->patches->items[number];
    uint64_t key = random_key(task->from->seed, number);
    struct patch_point point;
    point.at = wall->at;
    patch_look(&point, wall->direction);
    patch->point = wall->at.point;
    patch->normal = patch_faces(wall);
    patch->voxel = (uint32_t)wall->voxel;
    patch->area = (float)wall->area;
    patch->albedo = patch_light(point.albedo);
    patch->emission = patch_light(point.emission);
    if (random_unit(random_key(key, 5)) < task->share)
        patch->direct = patch_light(
            rgb_scale(patch_direct(task, &point, key), 1 / task->share));
}

static void fill_task(void *context, size_t item, unsigned thread)
{
    const struct patches_task *task = context;
    size_t end = (item + 1) * CHUNK;
    (void)thread;
    end = end < task->patches->count ? end : task->patches->count;
    for (size_t i = item * CHUNK; i < end; i++)
        patch_fill(task, i);
}

/* What a surface sends that a ray of this direction meets, with so much
 * `arriving` on it besides the light of lamps. */
static rgb beyond_sends(const struct patches_scene *from,
                        const struct patch_point *point, rgb arriving,
                        uint64_t key)
{
    struct patches_task task = { .from = from, .lamps_each = BEYOND_LAMPS };
    rgb light = rgb_add(arriving, patch_direct(&task, point, key));
    return rgb_add(rgb_mul(point->albedo, light), point->emission);
}

/* What arrives there from elsewhere, by one ray: the sky may be a sphere, or
 * hidden. */
static rgb beyond_arriving(const struct patches_scene *from,
                           const struct patch_point *point, vec3 direction,
                           uint64_t key)
{
    const struct ambience *ambience = from->ambience;
    const double u[2] = { random_unit(random_key(key, 1)),
                          random_unit(random_key(key, 2)) };
    const vec3 side = vec3_against(point->at.face, direction);
    const struct ray ray = { point->at.point, warp_lobe(u, side, 1) };
    struct patch_point next;
    if (rgb_peak(point->albedo) == 0)
        return rgb_grey(0);
    if (!world_closest(from->world, &ray, surface_offset(ray.origin),
                       RAY_GATHER, &next.at))
        return ambience_beyond(ambience, ray.direction);
    patch_look(&next, ray.direction);
    return beyond_sends(from, &next,
                        ambience_beyond(ambience, next.surface.normal), key);
}

rgb patches_beyond(const struct patches_scene *from, vec3 direction,
                   const struct intersection *at, uint64_t key)
{
    struct patch_point point;
    if (!at)
        return ambience_beyond(from->ambience, direction);
    point.at = *at;
    patch_look(&point, direction);
    return beyond_sends(
        from, &point,
        beyond_arriving(from, &point, direction, random_key(key, 6)), key);
}

rgb patches_lit(const struct patches_scene *from, vec3 direction,
                const struct intersection *at, uint64_t key, rgb *albedo)
{
    const struct patches_task task = { .from = from, .lamps_each = 1 };
    struct patch_point point;
    point.at = *at;
    patch_look(&point, direction);
    *albedo = point.albedo;
    return patch_direct(&task, &point, key);
}

rgb patches_glow(vec3 direction, const struct intersection *at)
{
    struct patch_point point;
    point.at = *at;
    patch_look(&point, direction);
    return point.emission;
}

struct patches *patches_new(const struct voxels *voxels,
                            const struct patches_scene *from)
{
    struct patches *patches = memory_new(sizeof *patches);
    size_t count;
    struct wall_point *points =
        wall_points(from->world, voxels, from->threads, from->stop, &count);
    struct patches_task task = {
        .from = from, .voxels = voxels, .patches = patches, .points = points
    };
    double looks = (double)count * (double)from->lamp_count;
    task.lamps_each = SHADOW_RAYS / (count + 1) + 1;
    task.share = looks > LAMP_LOOKS ? LAMP_LOOKS / looks : 1;
    patches->count = count;
    patches->items = memory_new(count * sizeof *patches->items);
    parallel_run(from->threads, (count + CHUNK - 1) / CHUNK, from->stop,
                 fill_task, &task);
    memory_free(points);
    return patches;
}

void patches_free(struct patches *patches)
{
    if (!patches)
        return;
    memory_free(patches->items);
    memory_free(patches);
}
