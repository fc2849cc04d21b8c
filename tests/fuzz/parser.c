/* One input for the whole reading half of glim: source text, tokens,
 * directives, expressions, scene. libFuzzer calls it (make fuzz); replay.c
 * calls it for each file of the corpus (make test). */
#include <stdint.h>
#include <stdlib.h>

#include "base/memory.h"
#include "parse/parse.h"

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    struct arena *sources = arena_new(0);
    char *text = arena_copy_text(sources, (const char *)data, size);
    struct source *source = ARENA_NEW(sources, struct source);
    source->name = "fuzz.pov";
    source->text = text;
    source->length = size;
    struct diag diag = { .out = NULL };
    struct parse_options options = {
        .image_width = 160,
        .image_height = 120,
        .memory_limit = (size_t)64 << 20,
        .round_limit = 2000,
    };
    struct scene *scene = parse_scene(source, &options, sources, &diag);
    scene_free(scene);
    arena_free(sources);
    return 0;
}
