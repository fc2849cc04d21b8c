/* The scene's defaults and its lifetime: see scene.h. */
#include "scene/scene.h"

#include "base/memory.h"

struct scene *scene_new(size_t memory_limit)
{
    struct scene *scene = memory_new(sizeof *scene);
    scene->arena = arena_new(memory_limit);
    scene->camera = camera_default();
    scene->background.transmit = 1; /* shows with +UA only (measured) */
    scene->noise = noise_settings_default;
    scene->settings = (struct settings){
        .gamma_kind = GAMMA_NONE,
        .assumed_gamma = 1,
        .ambient_light = rgb_grey(1),
        .irid_wavelength = { 0.70, 0.52, 0.48 },
        .max_trace_level = 5,
        .adc_bailout = 1.0 / 255,
        .light_mesh = { .quality = 5,
                        .indirect = { .on = true,
                                      .skeleton = true,
                                      .tone = { .brightness = 1 } } },
        .radiosity_said = { .tone = { .brightness = 1 }, .recursion_limit = 2 },
        .photons = photon_settings_default(),
        .subsurface = { .samples = { 50, 50 }, .mm_per_unit = 10 },
    };
    return scene;
}

void scene_free(struct scene *scene)
{
    if (!scene)
        return;
    arena_free(scene->arena);
    memory_free(scene);
}
