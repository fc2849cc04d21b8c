/* A scene, its lamps, workers, and what the camera sees first: for what lights
 * the picture's own points. */
#ifndef TESTS_STAGE_H
#define TESTS_STAGE_H

#include <string.h>

#include "harness.h"

#include "scene/camera.h"
#include "scene_world.h"
#include "shade/first_hits.h"
#include "shade/lamps.h"
#include "lightmesh/receiver.h"

enum { WIDTH = 96, HEIGHT = 72, THREADS = 3 };

/* What the camera sees of a scene, or of a part of it. */
struct stage {
    struct scene_world *all;
    struct lamps lamps;
    struct worker workers[THREADS], *pointers[THREADS];
    struct first_hits hits;
};

static inline void stage_look(struct stage *stage, int left, int top,
                              int columns, int rows)
{
    struct first_hits *hits = &stage->hits;
    *hits = (struct first_hits){
        WIDTH, HEIGHT, left, top, columns, rows, 0.5, NULL,
    };
    hits->at = calloc((size_t)columns * (size_t)rows, sizeof *hits->at);
    for (int y = top; y < top + rows; y++)
        for (int x = left; x < left + columns; x++) {
            double place[2];
            struct rays_span span = { { 0 }, { (double)INFINITY } };
            first_hits_place(hits, x, y, place);
            struct ray ray =
                camera_ray(&stage->all->scene->camera, place[0], place[1]);
            struct rays rays;
            rays_set(&rays, 0, ray.origin, ray.direction);
            world_closest_many(stage->all->world, &rays, &span, 1, RAY_CAMERA,
                               first_hits_at(hits, x, y));
        }
}

static inline void stage_start(struct stage *stage, const char *text)
{
    memset(stage, 0, sizeof *stage);
    stage->all = scene_world_new(text);
    stage->lamps = lamps_new(stage->all->world, stage->all->scene, 9, 0);
    for (int i = 0; i < THREADS; i++) {
        stage->workers[i] = (struct worker){ .scratch = arena_new(0) };
        stage->pointers[i] = &stage->workers[i];
    }
    stage_look(stage, 0, 0, WIDTH, HEIGHT);
}

static inline void stage_end(struct stage *stage)
{
    for (int i = 0; i < THREADS; i++)
        arena_free(stage->workers[i].scratch);
    free(stage->hits.at);
    lamps_free(&stage->lamps);
    scene_world_free(stage->all);
}

/* What is seen at a pixel, which asks for light. */
struct stage_seen {
    struct picture_place place;
    struct intersection at;
    struct receiver receiver; /* points to both */
};

/* False: nothing. */
static inline bool stage_meet(const struct stage *stage, int x, int y,
                              struct stage_seen *seen)
{
    const struct world_hit *hit = first_hits_at(&stage->hits, x, y);
    double *place = seen->place.at;
    first_hits_place(&stage->hits, x, y, place);
    seen->place.grid[0] = x;
    seen->place.grid[1] = y;
    struct ray ray = camera_ray(&stage->all->scene->camera, place[0], place[1]);
    if (!hit->leaf)
        return false;
    world_describe(&ray, hit, &seen->at);
    bool away = vec3_dot(seen->at.face, ray.direction) > 0;
    vec3 side = away ? vec3_negate(seen->at.face) : seen->at.face;
    seen->receiver = (struct receiver){ .point = seen->at.point,
                                        .side = side,
                                        .normal = side,
                                        .at = &seen->at,
                                        .pixel = &seen->place,
                                        .weight = 1 };
    return true;
}

#endif
