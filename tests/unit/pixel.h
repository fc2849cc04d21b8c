/* The middle of a picture, straight from the text of a scene: for tests of
 * what a camera ray sees. */
#ifndef TESTS_UNIT_PIXEL_H
#define TESTS_UNIT_PIXEL_H

#include <stdio.h>
#include <string.h>

#include "harness.h"

#include "parse/parse.h"
#include "tracer/integrator.h"

struct pixel_options {
    int quality;
    bool alpha;
    const char *lighting; /* NULL: rays */
};

struct pixel_tracer {
    struct arena *arena;
    struct scene *scene;
    struct world *world;
    struct tracer tracer;
    struct worker worker;
};

/* Looks along z from (0, 0, -10) unless the scene has a camera. */
static inline void pixel_start(struct pixel_tracer *pixel,
                               const char *scene_text,
                               struct pixel_options options)
{
    static char text[8192];
    struct parse_options parse = { .image_width = 3, .image_height = 3 };
    struct diag diag = diag_new();
    pixel->arena = arena_new(0);
    snprintf(text, sizeof text,
             "#version 3.7; global_settings { assumed_gamma 1 }\n%s%s",
             strstr(scene_text, "camera")
                 ? ""
                 : "camera { orthographic location -10*z direction z"
                   " right x*.0002 up y*.0002 }\n",
             scene_text);
    pixel->scene = parse_scene(source_from_text(pixel->arena, "test.pov", text),
                               &parse, pixel->arena, &diag);
    assert_non_null(pixel->scene);
    pixel->world = world_new(pixel->scene, 1, 0, &diag);
    assert_non_null(pixel->world);
    const struct lighting *lighting =
        integrator_lighting_find(options.lighting ? options.lighting : "rays");
    struct lighting_options light = { .threads = 1,
                                      .quality = options.quality };
    pixel->tracer = (struct tracer){ .scene = pixel->scene,
                                     .world = pixel->world,
                                     .lighting = lighting,
                                     .quality = options.quality,
                                     .alpha = options.alpha };
    pixel->worker = (struct worker){ .scratch = arena_new(0) };
    pixel->tracer.lighting_state =
        lighting->start(pixel->world, pixel->scene, &light, &diag);
    tracer_ready(&pixel->tracer);
}

static inline void pixel_end(struct pixel_tracer *pixel)
{
    pixel->tracer.lighting->finish(pixel->tracer.lighting_state);
    arena_free(pixel->worker.scratch);
    world_free(pixel->world);
    scene_free(pixel->scene);
    arena_free(pixel->arena);
}

static inline struct radiance pixel_see(const char *scene_text,
                                        struct pixel_options options)
{
    const struct picture_place middle = { { 0.5, 0.5 }, { 1, 1 } };
    struct pixel_tracer pixel;
    pixel_start(&pixel, scene_text, options);
    struct radiance seen = tracer_camera(&pixel.tracer, &pixel.worker, &middle);
    pixel_end(&pixel);
    return seen;
}

#endif
