/* replay FILE...: what the fuzzer found before must stay harmless. */
#include <stdint.h>
#include <stdio.h>

#include "base/arena.h"
#include "text/source.h"

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);

int main(int argc, char **argv)
{
    for (int i = 1; i < argc; i++) {
        struct arena *arena = arena_new(0);
        const char *problem;
        const struct source *source =
            source_read(arena, argv[i], span_none(), &problem);
        if (source)
            LLVMFuzzerTestOneInput((const uint8_t *)source->text,
                                   source->length);
        else
            printf("%s: %s\n", argv[i], problem);
        arena_free(arena);
    }
    return 0;
}
