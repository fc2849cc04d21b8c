/* scene/font: letters of a font that is installed with POV-Ray's includes, and
 * that nothing in a broken one is believed. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>
#include <math.h>

#include "base/random.h"
#include "scene/font.h"
#include "text/source.h"

#define FONTS "/usr/share/povray-3.7/include/"

static const struct source *font_source(struct arena *arena, const char *name)
{
    const char *problem;
    const struct source *source = source_read(
        arena, arena_printf(arena, FONTS "%s", name), span_none(), &problem);
    assert_non_null(source);
    return source;
}

static const struct font *font_good(struct arena *arena, const char *name)
{
    const char *problem;
    const struct source *source = font_source(arena, name);
    const struct font *font =
        font_new(arena, source->text, source->length, &problem);
    assert_non_null(font);
    return font;
}

static void letters_have_outlines_and_widths(void **state)
{
    (void)state;
    struct arena *arena = arena_new(0);
    const struct font *font = font_good(arena, "cyrvetic.ttf");
    int letter = font_letter(font, 'I');
    struct letter drawn = font_outline(font, letter, arena);
    struct outline outline = outline_new(arena, drawn.segments, drawn.count);
    assert_int_equal(drawn.count, 4);
    assert_true(fabs(font_bearing(font, letter) - outline.low[0]) < 1e-9);
    assert_true(fabs(outline.high[1] - 0.728) < 1e-9);
    assert_true(outline_covers(&outline, 0.12, 0.5));
    assert_false(outline_covers(&outline, 0.3, 0.5));
    assert_true(fabs(font_advance(font, letter) - 0.263) < 1e-9);
    assert_int_equal(font_outline(font, font_letter(font, ' '), arena).count,
                     0);
    font = font_good(arena, "timrom.ttf");
    assert_true(font_kerning(font, font_letter(font, 'V'),
                             font_letter(font, 'A')) < -0.1);
    assert_true(font_kerning(font, font_letter(font, 'A'),
                             font_letter(font, 'A')) == 0);
    arena_free(arena);
}

/* A ring: what an even number of outlines surround is outside. */
static void holes_are_outside_and_normals_point_out(void **state)
{
    (void)state;
    struct arena *arena = arena_new(0);
    const struct font *font = font_good(arena, "crystal.ttf");
    struct letter drawn = font_outline(font, font_letter(font, 'O'), arena);
    struct outline outline = outline_new(arena, drawn.segments, drawn.count);
    double middle[2] = { 0.5 * (outline.low[0] + outline.high[0]),
                         0.5 * (outline.low[1] + outline.high[1]) };
    assert_false(outline_covers(&outline, middle[0], middle[1]));
    assert_true(outline.count > 8);
    for (size_t i = 0; i < outline.count; i++) {
        const struct piece *piece = &outline.pieces[i];
        double p[2], t[2];
        segment_point(&piece->curve, 0.3, p);
        segment_tangent(&piece->curve, 0.3, t);
        double step = 1e-4 * piece->outward / hypot(t[0], t[1]);
        assert_false(
            outline_covers(&outline, p[0] + step * t[1], p[1] - step * t[0]));
        assert_true(
            outline_covers(&outline, p[0] - step * t[1], p[1] + step * t[0]));
    }
    arena_free(arena);
}

static void read_all(const char *bytes, size_t size)
{
    struct arena *arena = arena_new(0);
    const char *problem = NULL;
    const struct font *font = font_new(arena, bytes, size, &problem);
    if (!font)
        assert_non_null(problem);
    for (int c = 32; font && c < 300; c += 3) {
        int letter = font_letter(font, (uint32_t)c);
        struct letter drawn = font_outline(font, letter, arena);
        outline_new(arena, drawn.segments, drawn.count);
        assert_true(isfinite(font_advance(font, letter)));
        assert_true(isfinite(font_kerning(font, letter, 3)));
    }
    arena_free(arena);
}

static void broken_fonts_are_survived(void **state)
{
    (void)state;
    struct arena *arena = arena_new(0);
    const struct source *source = font_source(arena, "crystal.ttf");
    size_t size = source->length;
    char *bytes = arena_alloc(arena, size);
    for (size_t cut = 0; cut < size; cut += 1 + cut)
        read_all(source->text, cut);
    for (uint64_t round = 0; round < 100; round++) {
        memcpy(bytes, source->text, size);
        for (uint64_t i = 0; i < 1 + round / 2; i++) {
            uint64_t dice = random_key(round, i);
            size_t most = round % 2 ? size : 400;
            bytes[dice % most] = (char)(dice >> 40);
        }
        read_all(bytes, size);
    }
    arena_free(arena);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(letters_have_outlines_and_widths),
        cmocka_unit_test(holes_are_outside_and_normals_point_out),
        cmocka_unit_test(broken_fonts_are_survived),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
