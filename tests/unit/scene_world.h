/* A scene from a string, made ready for rays. */
#ifndef TESTS_UNIT_SCENE_WORLD_H
#define TESTS_UNIT_SCENE_WORLD_H

#include <stdio.h>
#include <stdlib.h>

#include "world/world.h"
#include "parse/parse.h"

/* `text` without #version and global_settings; what is printed is kept. */
struct scene_world {
    struct arena *arena;
    struct scene *scene;
    struct world *world;
    struct diag diag;
    char printed[1 << 14];
};

static inline struct scene_world *scene_world_new(const char *text)
{
    static const char head[] = "#version 3.7;\n"
                               "global_settings { assumed_gamma 1 }\n";
    struct parse_options options = { .image_width = 16, .image_height = 12 };
    struct scene_world *all = calloc(1, sizeof *all);
    char *whole = malloc(sizeof head + strlen(text));
    strcat(strcpy(whole, head), text);
    all->arena = arena_new(0);
    all->diag = diag_new();
    all->diag.out = fmemopen(all->printed, sizeof all->printed - 1, "w");
    all->scene = parse_scene(source_from_text(all->arena, "test.pov", whole),
                             &options, all->arena, &all->diag);
    free(whole);
    if (all->scene)
        all->world = world_new(all->scene, 1, 0, &all->diag);
    fflush(all->diag.out);
    if (!all->world)
        fail_msg("the scene was refused: %s", all->printed);
    return all;
}

static inline void scene_world_free(struct scene_world *all)
{
    world_free(all->world);
    scene_free(all->scene);
    fclose(all->diag.out);
    arena_free(all->arena);
    free(all);
}

#endif
