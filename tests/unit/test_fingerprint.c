/* What a field of a table says, the fingerprint knows: scenes that differ in
 * one alone have different ones, unless the table says why light doesn't depend
 * on it. So of the words of whole blocks: no light mesh is taken for that of
 * another scene. */
#include "harness.h"

#include "parse/parse.h"
#include "parse/tables.h"
#include "scene/fingerprint.h"
#include "scene/finish.h"
#include "scene/primitive.h"

#include <stdio.h>
#include <string.h>

static struct fingerprint fingerprint_of(const char *text)
{
    struct parse_options options = { .image_width = 16, .image_height = 12 };
    struct arena *arena = arena_new(0);
    struct diag diag = diag_new();
    struct scene *scene = parse_scene(source_from_text(arena, "test.pov", text),
                                      &options, arena, &diag);
    if (!scene)
        fail_msg("not read: %s", text);
    struct fingerprint found = scene_fingerprint(scene, true);
    scene_free(scene);
    arena_free(arena);
    return found;
}

/* The first or the second of two values that the field may have. */
static void field_value(const struct field *field, int which, char *out,
                        size_t size)
{
    bool bounded = field->maximum > field->minimum;
    double most = field->maximum < 1e6 ? field->maximum : 1;
    double low = bounded ? field->minimum : 0, high = bounded ? most : 1;
    switch (field->kind) {
    case FIELD_FLOAT:
        snprintf(out, size, "%s %g", field->name,
                 low + (high - low) * (which ? 0.6 : 0.3));
        return;
    case FIELD_INTEGER:
        snprintf(out, size, "%s %g", field->name,
                 (bounded ? field->minimum : 2) + which);
        return;
    case FIELD_BOOL:
        snprintf(out, size, "%s %s", field->name, which ? "on" : "off");
        return;
    case FIELD_FLAG:
        snprintf(out, size, "%s", which ? field->name : "");
        return;
    case FIELD_VECTOR:
        snprintf(out, size, "%s %s", field->name,
                 which ? "<.1, 0, .3>" : "<.3, .2, .1>");
        return;
    case FIELD_RGB:
        snprintf(out, size, "%s rgb %s", field->name,
                 which ? "<.1, 0, .3>" : "<.3, .2, .1>");
        return;
    default:
        fail_msg("%s: a kind that this test does not know", field->name);
    }
}

/* `block` has a %s where the field is to stand. */
static void check_field(const struct field *field, const char *block)
{
    char value[100], scene[2][600], inside[400];
    struct fingerprint found[2];
    for (int i = 0; i < 2; i++) {
        field_value(field, i, value, sizeof value);
        const char *at = strstr(block, "%s");
        snprintf(inside, sizeof inside, "%.*s%s%s", (int)(at - block), block,
                 value, at + 2);
        snprintf(scene[i], sizeof scene[i],
                 "#version 3.7; global_settings { assumed_gamma 1 } %s",
                 inside);
        found[i] = fingerprint_of(scene[i]);
    }
    bool same = memcmp(&found[0], &found[1], sizeof found[0]) == 0;
    if (same != (field->dark != NULL))
        fail_msg("'%s': %s", field->name,
                 same ? "not in the fingerprint, and it isn't said why"
                      : "in the fingerprint, which the table denies");
}

static void check_table(const struct field *table, const char *block)
{
    for (; table && table->name; table++)
        if (!strchr(table->name, ' '))
            check_field(table, block);
}

static void test_lamps(void **state)
{
    (void)state;
    check_table(lamp_kind_fields, "light_source { 1, 1 %s }");
    check_table(directed_fields, "light_source { 1, 1 spotlight %s }");
    check_table(lamp_fields, "light_source { 1, 1 area_light x, y, 2, 2 %s }");
}

static void test_insides(void **state)
{
    (void)state;
    check_table(interior_fields,
                "sphere { 0, 1 pigment { rgbt 1 } interior { %s } }");
    check_table(scattering_fields,
                "sphere { 0, 1 pigment { rgbt 1 } hollow interior { media { "
                "scattering { 5, .5 %s } } } }");
    check_table(medium_fields,
                "sphere { 0, 1 pigment { rgbt 1 } hollow interior { media { "
                "%s } } }");
    check_table(medium_fields, "media { scattering { 1, .5 } %s }");
}

static void test_surroundings(void **state)
{
    (void)state;
    check_table(fog_fields, "fog { distance 5 rgb 1 fog_type 2 fog_offset 2 "
                            "fog_alt 2 %s }");
    check_table(fog_turbulence_fields,
                "fog { distance 5 rgb 1 turbulence .5 %s }");
    check_table(sky_fields, "sky_sphere { pigment { rgb 1 } %s }");
}

static void test_textures(void **state)
{
    (void)state;
    check_table(normal_fields, "sphere { 0, 1 normal { bumps %s } }");
    check_table(pattern_fields,
                "sphere { 0, 1 pigment { wood turbulence .1 %s } }");
    check_table(turbulence_fields,
                "sphere { 0, 1 pigment { wood warp { turbulence .1 %s } } }");
    check_table(repeat_fields,
                "sphere { 0, 1 pigment { wood warp { repeat x %s } } }");
    check_table(hole_fields, "sphere { 0, 1 pigment { wood warp { black_hole "
                             "0, 1 %s } } }");
    check_table(laid_fields,
                "sphere { 0, 1 pigment { wood warp { toroidal %s } } }");
}

static void test_finishes(void **state)
{
    const struct finish_item *item;
    char block[100];
    (void)state;
    for (size_t i = 0; (item = finish_item_at(i)) != NULL; i++) {
        if (strcmp(item->name, "irid") != 0)
            check_table(item->fields, "sphere { 0, 1 finish { %s } }");
        bool bare = strcmp(item->name, "subsurface") == 0; /* no amount */
        snprintf(block, sizeof block,
                 "sphere { 0, 1 finish { %s { %s %%s } } }", item->name,
                 bare ? "" : ".1");
        check_table(item->inner, block);
    }
}

/* Where things are doesn't count, nor how large they are. */
static void test_kinds(void **state)
{
    const char *own = "sphere { 0, 1 pigment { rgb x } finish { diffuse 1 } }";
    const struct fingerprint is = fingerprint_of(own);
    const struct {
        const char *text;
        bool same;
    } other[] = {
        { "sphere { y, 2 pigment { rgb x } finish { diffuse 1 } "
          "rotate 20 * y }",
          true },
        { "box { 0, 1 pigment { rgb x } finish { diffuse 1 } }", false },
        { "sphere { 0, 1 pigment { rgb y } finish { diffuse 1 } }", false },
        { "sphere { 0, 1 pigment { rgb x } finish { diffuse .5 } }", false },
        { "sphere { 0, 1 pigment { rgb x } finish { diffuse 1 } } "
          "sphere { 5, 1 }",
          false },
    };
    (void)state;
    assert_int_equal(is.size, 1);
    for (size_t i = 0; i < sizeof other / sizeof *other; i++) {
        const struct fingerprint found = fingerprint_of(other[i].text);
        assert_int_equal(found.kinds == is.kinds, other[i].same);
        assert_false(fingerprint_same(&found, &is));
    }
}

/* Triangles of a mesh that is there twice count once. */
static void test_size(void **state)
{
    const struct fingerprint found = fingerprint_of(
        "#version 3.7; global_settings { assumed_gamma 1 } #declare M = mesh { "
        "triangle { 0, x, y } triangle { 0, x, z } } "
        "object { M } object { M translate x }");
    (void)state;
    assert_int_equal(found.size, 4);
}

/* Single numbers, vectors, or both, in the order of the table. */
static void test_numbers(void **state)
{
    struct thing {
        double one;
        bool truth;
        vec3 place;
        int whole;
    } said = { 1.5, true, { 2, 3, 4 }, 7 };
    const struct field table[] = {
        { "one", FIELD_FLOAT, offsetof(struct thing, one) },
        { "place", FIELD_VECTOR, offsetof(struct thing, place) },
        { "truth", FIELD_FLAG, offsetof(struct thing, truth) },
        { "whole", FIELD_INTEGER, offsetof(struct thing, whole) },
        { "dark", FIELD_INTEGER, offsetof(struct thing, whole), .dark = "so" },
        { NULL },
    };
    double out[8];
    (void)state;
    assert_int_equal(field_numbers(table, &said, FIELDS_NARROW, out), 3);
    assert_true(out[0] == 1.5 && out[1] == 1 && out[2] == 7);
    assert_int_equal(field_numbers(table, &said, FIELDS_WIDE, out), 3);
    assert_true(out[0] == 2 && out[1] == 3 && out[2] == 4);
    assert_int_equal(field_numbers(table, &said, FIELDS_BOTH, out), 6);
    assert_true(out[0] == 1.5 && out[1] == 2 && out[4] == 1 && out[5] == 7);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_lamps),        cmocka_unit_test(test_insides),
        cmocka_unit_test(test_surroundings), cmocka_unit_test(test_textures),
        cmocka_unit_test(test_finishes),     cmocka_unit_test(test_numbers),
        cmocka_unit_test(test_kinds),        cmocka_unit_test(test_size),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
