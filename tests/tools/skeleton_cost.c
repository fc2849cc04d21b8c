/*
 * What the skeleton costs, against Embree's occlusion rays into the same scene
 * in the same run, on one thread.
 *
 *   skeleton_cost SCENE.pov [RESOLUTION [RUNS]]
 *
 * Lines "NAME CPU MEMORY", seconds of processor and megabytes more at the most:
 *   rays      10^7 rays between places of the void (from a million)
 *   network   voxels to the network's light
 *   lamp:NAME each more lamp by that heuristic: the skeleton, and the light of
 *             all its nodes, with and without LAMPS lamps spread over the void
 * The least of RUNS (3) runs, by turns.
 */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/resource.h>
#include <time.h>

#include "base/memory.h"
#include "base/random.h"
#include "parse/parse.h"
#include "skeleton/field.h"
#include "skeleton/heuristic.h"
#include "skeleton/void.h"

enum { RAYS = 1000 * 1000, LAMPS = 16, TEXT_MOST = 1 << 20 };

static const char *const names[] = { "network", "forward", "backward" };

struct cost {
    struct diag diag;
    const char *path;
    int resolution;
    double rays, network, lamp[3];
    double memory;
};

struct setting {
    struct arena *arena;
    struct scene *scene;
    struct world *world;
    struct void_space *space;
};

static double seconds(void)
{
    struct timespec time;
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
    return (double)time.tv_sec + (double)time.tv_nsec * 1e-9;
}

/* In use now. */
static double megabytes_now(void)
{
    unsigned long all, resident = 0;
    FILE *file = fopen("/proc/self/statm", "r");
    if (!file || fscanf(file, "%lu %lu", &all, &resident) != 2)
        resident = 0;
    if (file)
        fclose(file);
    return (double)resident * 4096 / (1 << 20);
}

static double megabytes_most(void)
{
    struct rusage usage;
    getrusage(RUSAGE_SELF, &usage);
    return (double)usage.ru_maxrss / 1024;
}

static void keep_least(double *least, double value)
{
    if (!(*least > 0) || value < *least)
        *least = value;
}

/* The scene, and LAMPS more at random places of the void of `where`. */
static const char *scene_text(struct cost *cost, struct arena *arena,
                              const struct voxels *where)
{
    char *text = arena_alloc(arena, TEXT_MOST + 4096 * (LAMPS + 1));
    FILE *file = fopen(cost->path, "r");
    size_t length = file ? fread(text, 1, TEXT_MOST, file) : 0;
    if (file)
        fclose(file);
    for (uint64_t i = 0, lamps = 0; where && lamps < LAMPS; i++) {
        size_t voxel = random_key(3, i) % voxels_count(where);
        int at[3];
        if (!where->empty[voxel])
            continue;
        voxels_place(where, voxel, at);
        vec3 place = voxels_centre(where, at);
        length += (size_t)sprintf(text + length,
                                  "\nlight_source { <%.9g, %.9g, %.9g> rgb 1 "
                                  "fade_distance 0.5 fade_power 2 }",
                                  place.x, place.y, place.z);
        lamps++;
    }
    text[length] = '\0';
    return text;
}

static void setting_open(struct cost *cost, const struct voxels *where,
                         struct setting *setting)
{
    struct parse_options parse = { .image_width = 16, .image_height = 12 };
    setting->arena = arena_new(0);
    setting->scene =
        parse_scene(source_from_text(setting->arena, cost->path,
                                     scene_text(cost, setting->arena, where)),
                    &parse, setting->arena, &cost->diag);
    if (!setting->scene)
        exit(2);
    setting->world = world_new(setting->scene, 1, 0, &cost->diag);
    setting->space =
        setting->world
            ? void_new(setting->scene, setting->world,
                       (struct grid_wish){ .resolution = cost->resolution }, 1,
                       NULL, &cost->diag)
            : NULL;
    if (!setting->space)
        exit(2);
}

static void setting_close(struct setting *setting)
{
    void_free(setting->space);
    world_free(setting->world);
    scene_free(setting->scene);
    arena_free(setting->arena);
}

static struct skeleton *make(const struct setting *setting,
                             const char *heuristic)
{
    struct skeleton_options options = { .heuristic = heuristic_find(heuristic),
                                        .threads = 1 };
    return skeleton_new(setting->world, setting->scene, &setting->space->voxels,
                        &options);
}

static vec3 random_place(const struct voxels *v, uint64_t key)
{
    int at[3];
    size_t voxel = random_key(key, 0) % voxels_count(v);
    for (uint64_t i = 1; !v->empty[voxel]; i++)
        voxel = random_key(key, i) % voxels_count(v);
    voxels_place(v, voxel, at);
    return voxels_centre(v, at);
}

static bool passes(void *context, const struct ray *ray,
                   const struct world_hit *hit)
{
    (void)context;
    (void)ray;
    (void)hit;
    return false;
}

/* The rays are made before the clock starts. */
static void measure_rays(struct cost *cost, const struct setting *setting)
{
    struct ray *rays = memory_new(RAYS * sizeof *rays);
    double *lengths = memory_new(RAYS * sizeof *lengths);
    size_t blocked = 0;
    for (uint64_t i = 0; i < RAYS; i++) {
        vec3 from = random_place(&setting->space->voxels, random_key(1, i));
        vec3 to = random_place(&setting->space->voxels, random_key(2, i));
        vec3 way = vec3_sub(to, from);
        lengths[i] = vec3_length(way) + 1e-6;
        rays[i] = (struct ray){ from, vec3_scale(way, 1 / lengths[i]) };
    }
    double start = seconds();
    for (size_t i = 0; i < RAYS; i++)
        blocked += world_occluded(setting->world,
                                  &(struct occlusion){ .ray = &rays[i],
                                                       .tmin = 1e-4,
                                                       .tmax = lengths[i],
                                                       .light = -1,
                                                       .filter = passes });
    keep_least(&cost->rays, 1e7 / RAYS * (seconds() - start));
    if (blocked == 0 || blocked == RAYS)
        fprintf(stderr, "skeleton_cost: all rays alike\n");
    memory_free(rays);
    memory_free(lengths);
}

/* From the voxels on. Memory first, before anything else needs some. */
static void measure_network(struct cost *cost, const struct setting *setting)
{
    double start = seconds(), before = megabytes_now();
    struct void_space *space =
        void_new(setting->scene, setting->world,
                 (struct grid_wish){ .resolution = cost->resolution }, 1, NULL,
                 &cost->diag);
    struct setting again = *setting;
    again.space = space;
    skeleton_free(make(&again, "network"));
    keep_least(&cost->network, seconds() - start);
    if (!(cost->memory > 0))
        cost->memory = megabytes_most() - before;
    void_free(space);
}

static double skeleton_time(const struct setting *setting, const char *name)
{
    double start = seconds();
    struct skeleton *skeleton = make(setting, name);
    memory_free(skeleton_field(skeleton));
    double taken = seconds() - start;
    skeleton_free(skeleton);
    return taken;
}

int main(int argc, char **argv)
{
    struct cost cost = { .diag = diag_new(),
                         .path = argc > 1 ? argv[1] : "",
                         .resolution = argc > 2 ? atoi(argv[2]) : 128 };
    int runs = argc > 3 ? atoi(argv[3]) : 3;
    struct setting plain, lit;
    double with[3] = { 0 }, without[3] = { 0 };
    if (argc < 2 || argc > 4) {
        printf("usage: skeleton_cost SCENE.pov [RESOLUTION [RUNS]]\n");
        return 2;
    }
    setting_open(&cost, NULL, &plain);
    setting_open(&cost, &plain.space->voxels, &lit);
    for (int run = 0; run < runs; run++) {
        measure_network(&cost, &plain);
        measure_rays(&cost, &plain);
        for (int i = 0; i < 3; i++) {
            keep_least(&without[i], skeleton_time(&plain, names[i]));
            keep_least(&with[i], skeleton_time(&lit, names[i]));
        }
    }
    printf("rays %.4f 0\nnetwork %.4f %.0f\n", cost.rays, cost.network,
           cost.memory);
    for (int i = 0; i < 3; i++)
        printf("lamp:%s %.6f 0\n", names[i], (with[i] - without[i]) / LAMPS);
    setting_close(&lit);
    setting_close(&plain);
    return 0;
}
