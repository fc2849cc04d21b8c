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

/* Looks along z from (0, 0, -10) unless the scene has a camera. */
static inline struct radiance pixel_see(const char *scene_text,
                                        struct pixel_options options)
{
    static char text[8192];
    struct parse_options parse = { .image_width = 3, .image_height = 3 };
    struct arena *arena = arena_new(0);
    struct diag diag = diag_new();
    snprintf(text, sizeof text,
             "#version 3.7; global_settings { assumed_gamma 1 }\n%s%s",
             strstr(scene_text, "camera")
                 ? ""
                 : "camera { orthographic location -10*z direction z"
                   " right x*.0002 up y*.0002 }\n",
             scene_text);
    struct scene *scene = parse_scene(source_from_text(arena, "test.pov", text),
                                      &parse, arena, &diag);
    assert_non_null(scene);
    struct world *world = world_new(scene, 1, 0, &diag);
    assert_non_null(world);
    const struct lighting *lighting =
        integrator_lighting_find(options.lighting ? options.lighting : "rays");
    struct lighting_options light = { .threads = 1,
                                      .quality = options.quality };
    struct tracer tracer = { .scene = scene,
                             .world = world,
                             .lighting = lighting,
                             .quality = options.quality,
                             .alpha = options.alpha };
    struct worker worker = { .scratch = arena_new(0) };
    tracer.lighting_state = lighting->start(world, scene, &light, &diag);
    tracer_ready(&tracer);
    const struct picture_place middle = { { 0.5, 0.5 }, { 1, 1 } };
    struct radiance seen = tracer_camera(&tracer, &worker, &middle);
    lighting->finish(tracer.lighting_state);
    arena_free(worker.scratch);
    world_free(world);
    scene_free(scene);
    arena_free(arena);
    return seen;
}

#endif
