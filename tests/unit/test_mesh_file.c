/* Light meshes as bytes: what comes back is what was kept, and bytes that
 * anybody has changed do no harm. */
#include <unistd.h>

#include "harness.h"

#include "base/map.h"
#include "base/save.h"

#include "base/hash.h"
#include "base/memory.h"
#include "base/random.h"
#include "lightmesh/mesh_file.h"
#include "lightmesh/point_mesh.h"
#include "lightmesh/table.h"
#include "scene_world.h"

enum { POINTS = 40, PAYLOAD = 16 };

static const char scene_text[] = "light_source { <1, 5, -2> rgb 1 }\n"
                                 "plane { y, 0 pigment { rgb 1 } }\n"
                                 "sphere { <0, 1, 0>, 1 pigment { rgb 1 } }\n";

static struct point_mesh mesh_empty(void)
{
    struct point_mesh mesh = { .payload_size = PAYLOAD };
    point_mesh_start(&mesh, 100000);
    return mesh;
}

static struct mesh_stamp stamp_of(const char *text)
{
    struct scene_world *all = scene_world_new(text);
    struct mesh_stamp stamp =
        mesh_stamp_new(all->scene, MESH_SHADOWS_SOFT, true, 9, 7);
    stamp.frame = (struct mesh_frame){ .spacing = 0.5,
                                       .wanted = 0.4,
                                       .near = 3,
                                       .size = 4,
                                       .gather = 0.7,
                                       .samples = 32,
                                       .asked = 64,
                                       .closed = true,
                                       .around = { { 1, 2, 3 }, 0.5 },
                                       .bright = { 1, 0.25 } };
    stamp.frame.bright.at[0].centre = vec3_make(4, 5, 6);
    stamp.frame.bright.at[0].worth = 7;
    scene_world_free(all);
    return stamp;
}

static void *mesh_packed(uint64_t first, uint64_t step, size_t *size)
{
    struct point_mesh mesh = mesh_empty();
    const struct point_mesh *meshes[] = { &mesh };
    struct mesh_stamp stamp = stamp_of(scene_text);
    for (uint64_t i = 0; i < POINTS; i++) {
        uint64_t key = 1 + (first + i * step) % POINTS;
        char record[PAYLOAD] = { (char)key };
        table_insert(mesh.table, key, random_mix(key), record);
    }
    void *bytes = mesh_file_pack(&stamp, meshes, 1, size);
    point_mesh_free(&mesh);
    return bytes;
}

/* In whatever order points were found. */
static void test_order(void **state)
{
    size_t size[2];
    (void)state;
    void *a = mesh_packed(0, 1, &size[0]), *b = mesh_packed(5, 7, &size[1]);
    assert_int_equal(size[0], size[1]);
    assert_memory_equal(a, b, size[0]);
    memory_free(a);
    memory_free(b);
}

static void test_back(void **state)
{
    struct point_mesh mesh = mesh_empty();
    const struct point_mesh *meshes[] = { &mesh, &mesh };
    struct mesh_stamp stamp = stamp_of(scene_text);
    struct mesh_file file;
    char text[200];
    size_t size;
    (void)state;
    void *bytes = mesh_packed(0, 1, &size);
    assert_true(mesh_file_open(&file, bytes, size, text, sizeof text));
    assert_true(file.stamp.frame.spacing == 0.5);
    assert_true(file.stamp.frame.gather == 0.7);
    assert_true(file.stamp.frame.samples == 32 && file.stamp.frame.closed);
    assert_true(file.stamp.frame.around.light.b == 3 &&
                file.stamp.frame.around.open == 0.5);
    assert_true(file.stamp.frame.wanted == 0.4 && file.stamp.frame.asked == 64);
    assert_true(file.stamp.frame.bright.count == 1 &&
                file.stamp.frame.bright.radius == 0.25 &&
                file.stamp.frame.bright.at[0].centre.z == 6 &&
                file.stamp.frame.bright.at[0].worth == 7);
    assert_true(mesh_stamp_same(&file.stamp, &stamp, text, sizeof text));
    assert_false(mesh_file_fill(&file, meshes, 2, 1, NULL));
    assert_true(mesh_file_fill(&file, meshes, 1, 1e-9, NULL));
    assert_int_equal(table_count(mesh.table), 0);
    assert_true(mesh_file_fill(&file, meshes, 1, 1, NULL));
    assert_int_equal(table_count(mesh.table), POINTS);
    for (uint64_t key = 1; key <= POINTS; key++) {
        void *record;
        assert_int_equal(
            table_find(mesh.table, key, lattice_hash(key), &record),
            TABLE_READY);
        assert_int_equal(*(char *)record, (char)key);
    }
    point_mesh_free(&mesh);
    memory_free(bytes);
}

/* A file's points stay in it; others are added beside them, and all are packed
 * again. */
static void test_shared(void **state)
{
    static const char name[] = "/tmp/glim-shared.mesh";
    struct point_mesh mesh = mesh_empty();
    const struct point_mesh *meshes[] = { &mesh };
    struct mesh_file file;
    char text[200], own[PAYLOAD] = { 77 };
    size_t size, again;
    void *record;
    (void)state;
    void *bytes = mesh_packed(0, 1, &size);
    assert_true(save_bytes(name, bytes, size, text, sizeof text));
    struct map *map = map_open(name);
    assert_int_equal(map_size(map), size);
    assert_true(mesh_file_open(&file, map_bytes(map), size, text, sizeof text));
    assert_true(mesh_file_fill(&file, meshes, 1, 1, map));
    map_release(map);
    unlink(name);
    assert_int_equal(table_count(mesh.table), POINTS);
    for (uint64_t key = 1; key <= POINTS; key++) {
        assert_int_equal(
            table_find(mesh.table, key, lattice_hash(key), &record),
            TABLE_READY);
        assert_int_equal(*(char *)record, (char)key);
        assert_in_range((uintptr_t)record, (uintptr_t)file.tables,
                        (uintptr_t)file.end);
    }
    void *packed = mesh_file_pack(&file.stamp, meshes, 1, &again);
    assert_int_equal(again, size);
    assert_memory_equal(packed, bytes, size);
    table_insert(mesh.table, POINTS + 1, lattice_hash(POINTS + 1), own);
    assert_int_equal(table_count(mesh.table), POINTS + 1);
    uint64_t key;
    assert_int_equal(*(const char *)table_at(mesh.table, POINTS, &key), 77);
    assert_int_equal(key, POINTS + 1);
    memory_free(packed);
    memory_free(bytes);
    point_mesh_free(&mesh);
    assert_null(map_open(name));
}

/* Changed bytes are found; with a right hash they may pass for a mesh, but
 * are read without harm. */
static void test_changed(void **state)
{
    size_t size, opened = 0;
    (void)state;
    char *whole = mesh_packed(0, 1, &size);
    for (uint64_t i = 0; i < 1000; i++) {
        struct point_mesh mesh = mesh_empty();
        const struct point_mesh *meshes[] = { &mesh };
        struct mesh_file file;
        char text[200], *bytes = memory_new(size);
        memcpy(bytes, whole, size);
        /* Numbers rather than the text of settings. */
        size_t at = i % 4 ? random_mix(i) % size : 24 + random_mix(i) % 160;
        bytes[at] ^= (char)(1 << random_mix(i + 5000) % 8);
        assert_false(mesh_file_open(&file, bytes, size, text, sizeof text));
        size_t cut = i % 2 ? size : size - 8 * (random_mix(i + 9000) % 20);
        uint64_t number = cut;
        if (i % 3)
            memcpy(bytes + 24, &number, sizeof number);
        number = hash_bytes(0, bytes, cut - 8);
        memcpy(bytes + cut - 8, &number, sizeof number);
        if (mesh_file_open(&file, bytes, cut, text, sizeof text))
            opened += mesh_file_fill(&file, meshes, 1, 1, NULL);
        memory_free(bytes);
        point_mesh_free(&mesh);
    }
    assert_true(opened > 100 && opened < 1000);
    memory_free(whole);
}

/* The bytes of counts, the largest of numbers. */
static void test_counts(void **state)
{
    size_t size;
    (void)state;
    char *whole = mesh_packed(0, 1, &size), *bytes = memory_new(size);
    const uint64_t large[] = { UINT64_MAX, UINT64_MAX / 8, 1ull << 61,
                               1 << 20 };
    for (size_t at = 16; at + 16 <= size; at += 8)
        for (size_t i = 0; i < sizeof large / sizeof *large; i++) {
            struct mesh_file file;
            char text[200];
            memcpy(bytes, whole, size);
            memcpy(bytes + at, &large[i], 8);
            uint64_t hash = hash_bytes(0, bytes, size - 8);
            memcpy(bytes + size - 8, &hash, 8);
            mesh_file_open(&file, bytes, size, text, sizeof text);
        }
    memory_free(bytes);
    memory_free(whole);
}

static bool same_as(const char *text, const char *wanted)
{
    struct mesh_stamp made = stamp_of(scene_text), now = stamp_of(text);
    char found[200] = "";
    bool same = mesh_stamp_same(&made, &now, found, sizeof found);
    assert_string_equal(found, wanted);
    return same;
}

static void test_stamp(void **state)
{
    (void)state;
    assert_true(same_as(scene_text, ""));
    assert_true(same_as("// the camera alone moves\n"
                        "camera { location <9, 1, 2> look_at y }\n"
                        "light_source { <1, 5, -2> rgb 1 }\n"
                        "plane { y, 0 pigment { rgb 1 } }\n"
                        "sphere { y, 1 pigment { rgb 1 } }\n",
                        ""));
    assert_false(same_as("light_source { <1, 5, -2> rgb 1 }\n"
                         "plane { y, 0 pigment { rgb 1 } }\n"
                         "sphere { <0, 1, 0>, 1.1 pigment { rgb 1 } }\n",
                         "the objects have changed"));
    assert_false(same_as("light_source { <1, 5, -2> rgb 1 translate x }\n"
                         "plane { y, 0 pigment { rgb 1 } }\n"
                         "sphere { <0, 1, 0>, 1 pigment { rgb 1 } }\n",
                         "the lights have changed"));
    assert_false(same_as("light_source { <1, 5, -2> rgb 1 }\n"
                         "plane { y, 0 pigment { checker rgb 1 rgb 0 } }\n"
                         "sphere { <0, 1, 0>, 1 pigment { rgb 1 } }\n",
                         "the textures have changed"));
    assert_false(same_as("light_source { <1, 5, -2> rgb 1 }\n"
                         "plane { y, 0 pigment { rgb 1 } }\n"
                         "sphere { <0, 1, 0>, 1 pigment { rgb 1 } }\n"
                         "background { rgb 0.1 }",
                         "the background, the sky or the fog has changed"));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_order),   cmocka_unit_test(test_back),
        cmocka_unit_test(test_changed), cmocka_unit_test(test_counts),
        cmocka_unit_test(test_stamp),   cmocka_unit_test(test_shared),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
