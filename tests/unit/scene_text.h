/* Reads a scene from a string and keeps what it prints: for tests of the
 * parser that look at values by way of #debug. */
#ifndef TESTS_UNIT_SCENE_TEXT_H
#define TESTS_UNIT_SCENE_TEXT_H

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "parse/parse.h"

enum { SCENE_TEXT_LIMIT = 1 << 16 };

/* All that was printed, for free(); *ok: whether the scene was read. */
static inline char *scene_text_run(const char *text, bool *ok)
{
    static const char *const paths[] = { "/usr/share/povray-3.7/include" };
    struct parse_options options = { .image_width = 16,
                                     .image_height = 12,
                                     .include_paths = paths,
                                     .include_path_count = 1 };
    struct arena *arena = arena_new(0);
    struct diag diag = diag_new();
    char *printed = calloc(1, SCENE_TEXT_LIMIT);
    diag.out = fmemopen(printed, SCENE_TEXT_LIMIT - 1, "w");
    struct scene *scene = parse_scene(source_from_text(arena, "test.pov", text),
                                      &options, arena, &diag);
    *ok = scene != NULL;
    if (scene)
        scene_free(scene);
    fclose(diag.out);
    arena_free(arena);
    return printed;
}

/* What is printed between the marks «"<<"» and «">>"», for free(); NULL if
 * the scene was refused. */
static inline char *scene_text_marked(const char *declarations,
                                      const char *expression)
{
    char *text, *result = NULL;
    size_t size = strlen(declarations) + strlen(expression) + 200;
    bool ok;
    text = malloc(size);
    snprintf(text, size,
             "#version 3.7; global_settings { assumed_gamma 1 } %s\n"
             "#debug concat(\"\\n<<\", %s, \">>\\n\")\n",
             declarations, expression);
    char *printed = scene_text_run(text, &ok);
    char *start = strstr(printed, "\n<<");
    char *end = start ? strstr(start, ">>\n") : NULL;
    if (ok && end) {
        *end = 0;
        result = strdup(start + 3);
    } else {
        fprintf(stderr, "%s", printed);
    }
    free(printed);
    free(text);
    return result;
}

#endif
