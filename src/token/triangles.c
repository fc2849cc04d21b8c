/* Triangles written plainly: see triangles.h. */
#include "token/triangles.h"

#include "base/array.h"

static bool is_word_character(char c)
{
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_' ||
           (c >= '0' && c <= '9');
}

/* The word at `at`, which may be of no length; its end. */
static const char *word_end(const char *at)
{
    if (*at >= '0' && *at <= '9')
        return at;
    while (is_word_character(*at))
        at++;
    return at;
}

/* Takes the word if it is this one, and the space after it. */
static bool take_word(const char **at, const char *word)
{
    size_t length = strlen(word);
    if (strncmp(*at, word, length) != 0 || is_word_character((*at)[length]))
        return false;
    *at = numbers_skip_space(*at + length);
    return true;
}

/* [texture { X }], X no longer than any word may be. */
static bool take_paint(const char **at, const char *text,
                       struct word_table *words, struct triangle_paint *paint)
{
    const char *start = *at;
    *paint = (struct triangle_paint){ NULL, 0, 0 };
    if (!take_word(at, "texture"))
        return true;
    if (!numbers_take(at, '{'))
        return false;
    const char *name = *at, *end = word_end(name);
    if (end == name || end - name > 200)
        return false;
    *at = numbers_skip_space(end);
    if (**at != '}')
        return false;
    paint->texture = word_intern(words, name, (size_t)(end - name));
    paint->start = (uint32_t)(start - text);
    paint->end = (uint32_t)(*at + 1 - text);
    return numbers_take(at, '}');
}

/* One of the run that begins at `text`. */
struct triangle {
    bool smooth;
    double vectors[6][3];
    struct triangle_paint paint;
};

static int triangle_vectors(bool smooth)
{
    return smooth ? 6 : 3;
}

static bool take_triangle(const char **at, const char *text,
                          struct word_table *words, struct triangle *triangle)
{
    const char *word = triangle->smooth ? "smooth_triangle" : "triangle";
    if (!take_word(at, word) || !numbers_take(at, '{'))
        return false;
    for (int i = 0; i < triangle_vectors(triangle->smooth); i++) {
        if (i > 0)
            numbers_take(at, ',');
        if (!numbers_take_vector(at, triangle->vectors[i]))
            return false;
    }
    return take_paint(at, text, words, &triangle->paint) && **at == '}';
}

static const struct triangle_run *
run_new(struct arena *arena, const struct triangle_bench *bench, bool smooth)
{
    struct triangle_run *run = ARENA_NEW(arena, struct triangle_run);
    size_t vectors = bench->vectors.count * sizeof *run->vectors;
    size_t paints = bench->paints.count * sizeof *run->paints;
    run->smooth = smooth;
    run->count = bench->paints.count;
    run->vectors = arena_alloc(arena, vectors);
    run->paints = arena_alloc(arena, paints);
    memcpy(run->vectors, bench->vectors.items, vectors);
    memcpy(run->paints, bench->paints.items, paints);
    return run;
}

const struct triangle_run *triangles_cut(struct arena *arena,
                                         struct word_table *words,
                                         struct triangle_bench *bench,
                                         const char *text, size_t *length)
{
    struct triangle triangle = { .smooth = *text == 's' };
    const char *at = text;
    bench->vectors.count = bench->paints.count = 0;
    while (bench->paints.count < TRIANGLES_MOST &&
           take_triangle(&at, text, words, &triangle)) {
        *length = (size_t)(++at - text);
        at = numbers_skip_space(at);
        for (int i = 0; i < triangle_vectors(triangle.smooth); i++)
            memcpy(*ARRAY_PUSH(arena, &bench->vectors), triangle.vectors[i],
                   sizeof *triangle.vectors);
        *ARRAY_PUSH(arena, &bench->paints) = triangle.paint;
    }
    return bench->paints.count ? run_new(arena, bench, triangle.smooth) : NULL;
}
