/* density_file: the file of numbers it names. */
#include "scene/density_file.h"

#include "parse/rules.h"
#include "scene/samples.h"

/* Files already read in this parse: a loop may name one a thousand times. */
struct density_cache {
    struct density_cache *next;
    const char *path;
    struct density_file file;
};

/* Three sizes of two bytes, then all numbers, as wide as the file is long. */
static const char *density_decode(struct density_file *file,
                                  const unsigned char *bytes, size_t length)
{
    enum { HEADER = 6 };
    size_t count = 1;
    if (length < HEADER)
        return "it is too short";
    for (int i = 0; i < 3; i++) {
        file->size[i] = 256 * bytes[2 * i] + bytes[2 * i + 1];
        count *= (size_t)file->size[i];
    }
    if (count == 0)
        return "one of its sizes is 0";
    size_t width = (length - HEADER) / count;
    if (width < 1)
        return "it is too short for the sizes it names";
    file->width = width >= 4 ? 4 : width >= 2 ? 2 : 1;
    file->bytes = bytes + HEADER;
    return NULL;
}

static bool density_load(struct parser *p, const char *name, struct span span,
                         struct density_file *file)
{
    const char *path = file_find(p, name, ".df3"), *problem = NULL;
    if (!path)
        return error_at(p, span, file_hint(p, "file", name),
                        "can't find the file '%s'", file_shown(p, name));
    for (struct density_cache *c = p->densities; c; c = c->next)
        if (strcmp(c->path, path) == 0) {
            *file = c->file;
            return true;
        }
    const struct source *source =
        source_read(p->sources, path, span_none(), &problem);
    if (source)
        problem = density_decode(file, (const unsigned char *)source->text,
                                 source->length);
    if (problem)
        return error_at(p, span, NULL, "can't read the file '%s': %s", path,
                        problem);
    struct density_cache *cache = ARENA_NEW(p->arena, struct density_cache);
    *cache = (struct density_cache){ p->densities, path, *file };
    p->densities = cache;
    return true;
}

/* density_file = "density_file" "df3" string . */
bool parse_density_file(struct parser *p, struct density_file *file)
{
    const char *name;
    stream_next(p);
    if (!accept_keyword(p, KEYWORD_DF3))
        return error_expected(p, "'df3' and the name of a file");
    struct span span = stream_span(p);
    return parse_string(p, &name) && density_load(p, name, span, file);
}
