/* What scene texts become: objects, textures, lights, camera, settings. Each
 * expectation about order and defaults was seen in pictures by POV-Ray 3.7. */
#include "harness.h"

#include <math.h>
#include <stdio.h>

#include "parse/parse.h"
#include "scene/light.h"
#include "scene/mesh.h"
#include "scene/primitive.h"

struct reading {
    struct arena *sources;
    struct scene *scene;
    struct diag diag;
};

#define HEAD "#version 3.7; global_settings { assumed_gamma 1 }\n"

static struct reading scene_read(const char *text)
{
    struct reading r = { .sources = arena_new(0), .diag = { .out = NULL } };
    struct parse_options options = { .image_width = 4, .image_height = 3 };
    const struct source *source = source_from_text(
        r.sources, "test.pov", arena_printf(r.sources, "%s%s", HEAD, text));
    r.scene = parse_scene(source, &options, r.sources, &r.diag);
    return r;
}

static struct reading scene_good(const char *text)
{
    struct reading r = scene_read(text);
    if (!r.scene) {
        print_error("refused: %s\n", text);
        fail();
    }
    return r;
}

static void scene_end(struct reading *r)
{
    scene_free(r->scene);
    arena_free(r->sources);
}

static const struct object *object_at(const struct reading *r, size_t i)
{
    assert_true(i < r->scene->objects.count);
    return r->scene->objects.items[i];
}

static void assert_number(double value, double wanted)
{
    if (!(fabs(value - wanted) < 1e-9)) {
        print_error("%.12g instead of %.12g\n", value, wanted);
        fail();
    }
}

static void assert_vector(vec3 v, double x, double y, double z)
{
    assert_number(v.x, x);
    assert_number(v.y, y);
    assert_number(v.z, z);
}

/* Where the middle of a shape is in the scene: it was moved itself, or keeps
 * its map. */
static vec3 object_middle(const struct object *object)
{
    struct box3 box = object->primitive->bounds(object->shape);
    return affine_point(object->maps->own,
                        vec3_scale(vec3_add(box.low, box.high), 0.5));
}

static const struct layer *object_layer(const struct object *object, size_t i)
{
    assert_non_null(object->texture);
    assert_true(i < object->texture->count);
    return &object->texture->layers[i];
}

/* ---- transformations ---- */

static void transformations_apply_in_order(void **state)
{
    (void)state;
    struct reading r =
        scene_good("sphere { 0, 1 translate x rotate 90*z scale <1, 2, 1> }"
                   "sphere { 0, 1 matrix <1,0,0, 0,1,0, 0,0,1, 3,4,5> }"
                   "#declare T = transform { translate 2*x }"
                   "sphere { 0, 1 transform T transform { T } }"
                   "sphere { 0, 1 transform { inverse T translate y } }");
    assert_vector(object_middle(object_at(&r, 0)), 0, 2, 0);
    assert_vector(object_middle(object_at(&r, 1)), 3, 4, 5);
    assert_vector(object_middle(object_at(&r, 2)), 4, 0, 0);
    assert_vector(object_middle(object_at(&r, 3)), -2, -1, 0);
    scene_end(&r);
}

static void scaling_by_nothing_is_by_one(void **state)
{
    (void)state;
    struct reading r = scene_good("sphere { x + y, 1 scale 3*y }");
    const struct object *object = object_at(&r, 0);
    assert_vector(affine_point(object->maps->own, vec3_make(1, 1, 1)), 1, 3, 1);
    assert_int_equal(r.diag.warnings, 1);
    scene_end(&r);
}

static void flat_transformations_are_refused(void **state)
{
    (void)state;
    static const char *const texts[] = {
        "sphere { 0, 1 matrix <1,1,0, 1,1,0, 0,0,1, 0,0,0> }",
        "sphere { 0, 1 scale 1e-200 }",
        "sphere { 0, 1 scale 1e200 scale 1e200 }",
        "sphere { 0, 1 pigment { checker scale 1e-300 scale 1e-300 } }",
    };
    for (size_t i = 0; i < sizeof texts / sizeof *texts; i++) {
        struct reading r = scene_read(texts[i]);
        assert_null(r.scene);
        scene_end(&r);
    }
}

/* ---- textures ---- */

static void later_texture_is_painted_over(void **state)
{
    (void)state;
    struct reading r = scene_good(
        "#declare S = sphere { 0, 1 texture { pigment { rgb x } } }"
        "object { S texture { pigment { rgb y } } }"
        "sphere { 0, 1 pigment { rgb x } texture { pigment { rgb y } } }");
    for (size_t i = 0; i < 2; i++) {
        assert_int_equal(object_at(&r, i)->texture->count, 2);
        assert_number(object_layer(object_at(&r, i), 0)->pigment->colour.r, 1);
        assert_number(object_layer(object_at(&r, i), 1)->pigment->colour.g, 1);
    }
    scene_end(&r);
}

static void later_pigment_takes_the_place(void **state)
{
    (void)state;
    struct reading r = scene_good(
        "#declare T = texture { pigment { rgb x } finish { ambient .2 } }"
        "            texture { pigment { rgb y } finish { ambient .12 } }"
        "sphere { 0, 1 texture { T } pigment { rgb z } }"
        "sphere { 0, 1 texture { T finish { diffuse .3 } } }"
        "sphere { 0, 1 texture { T } }");
    const struct layer *top = object_layer(object_at(&r, 0), 1);
    assert_number(object_layer(object_at(&r, 0), 0)->pigment->colour.r, 1);
    assert_number(top->pigment->colour.b, 1);
    assert_number(top->finish->ambient.r, .12);
    top = object_layer(object_at(&r, 1), 1);
    assert_number(top->finish->ambient.r, .12);
    assert_number(top->finish->diffuse, .3);
    top = object_layer(object_at(&r, 2), 1);
    assert_number(top->finish->diffuse, .6);
    assert_number(top->pigment->colour.g, 1);
    scene_end(&r);
}

static void texture_moves_with_what_follows(void **state)
{
    (void)state;
    struct reading r = scene_good(
        "sphere { 0, 1 translate 5*x pigment { checker } translate y }"
        "sphere { 0, 1 pigment { checker } translate y pigment { scale 2 } }");
    const struct object *object = object_at(&r, 0);
    vec3 origin = vec3_make(0, 0, 0);
    assert_vector(object_middle(object), 5, 1, 0);
    assert_vector(affine_point(object->maps->texture, origin), 0, 1, 0);
    object = object_at(&r, 1);
    assert_vector(affine_point(object->maps->texture, origin), 0, 0, 0);
    affine inverse = object_layer(object, 0)->pigment->pattern.inverse;
    assert_vector(affine_point(&inverse, vec3_make(0, 2, 0)), 0, 0, 0);
    assert_vector(affine_point(&inverse, vec3_make(2, 2, 0)), 1, 0, 0);
    scene_end(&r);
}

static void default_counts_when_it_goes_into_the_scene(void **state)
{
    (void)state;
    struct reading r =
        scene_good("#declare Bare = sphere { 0, 1 }"
                   "#declare Some = sphere { 0, 1 finish { phong 1 } }"
                   "#default { pigment { rgb x } finish { ambient .09 } }"
                   "object { Bare translate x }"
                   "object { Some }"
                   "default { finish { diffuse .2 } }"
                   "sphere { 0, 1 finish { phong 1 } }");
    const struct object *bare = object_at(&r, 0);
    assert_number(object_layer(bare, 0)->pigment->colour.r, 1);
    assert_number(object_layer(bare, 0)->finish->ambient.g, .09);
    assert_true(affine_is_identity(*bare->maps->texture));
    assert_number(object_layer(object_at(&r, 1), 0)->pigment->colour.r, 0);
    const struct finish *finish = object_layer(object_at(&r, 2), 0)->finish;
    assert_number(finish->ambient.r, .09);
    assert_number(finish->diffuse, .2);
    scene_end(&r);
}

static void block_patterns_fill_up_their_list(void **state)
{
    (void)state;
    struct reading r =
        scene_good("plane { y, 0 pigment { checker rgb <1, .5, 0> } }"
                   "plane { y, 0 pigment { hexagon pigment { rgb z } pigment { "
                   "rgb 1 } } }");
    const struct blend_map *map =
        object_layer(object_at(&r, 0), 0)->pigment->map;
    assert_int_equal(map->count, 2);
    assert_number(map->entries[0].colour.g, .5);
    assert_number(map->entries[1].colour.g, 1); /* checker's own green */
    map = object_layer(object_at(&r, 1), 0)->pigment->map;
    assert_int_equal(map->count, 3);
    assert_number(map->entries[0].pigment->colour.b, 1);
    assert_non_null(map->entries[2].pigment); /* the default one (measured) */
    assert_number(rgb_peak(colour_rgb(map->entries[2].pigment->colour)), 0);
    scene_end(&r);
}

static void maps_old_and_new(void **state)
{
    (void)state;
    struct reading r =
        scene_good("#declare M = color_map { [0, 0.3 color rgb x color rgb y]"
                   "                         [0.3 1 color rgb y color rgb z] }"
                   "#declare Edge = 0.25;"
                   "plane { y, 0 pigment { gradient x color_map { M } } }"
                   "plane { y, 0 pigment { gradient x color_map {"
                   "    [Edge rgb x] [0.5 color red 1 filter .5] } } }"
                   "plane { y, 0 pigment { gradient x pigment_map {"
                   "    [0 rgb x] [1 gradient y scale 2] } } }");
    const struct blend_map *map =
        object_layer(object_at(&r, 0), 0)->pigment->map;
    assert_int_equal(map->count, 4);
    assert_number(map->entries[1].value, .3);
    assert_number(map->entries[3].value, 1);
    assert_number(map->entries[3].colour.b, 1);
    map = object_layer(object_at(&r, 1), 0)->pigment->map;
    assert_number(map->entries[0].value, .25);
    assert_number(map->entries[1].colour.filter, .5);
    map = object_layer(object_at(&r, 2), 0)->pigment->map;
    assert_string_equal(map->entries[1].pigment->pattern.kind->name,
                        "gradient");
    scene_end(&r);
}

static void finish_forms(void **state)
{
    (void)state;
    struct reading r = scene_good(
        "sphere { 0, 1 finish { diffuse albedo .5, .3 specular albedo .4"
        " roughness .1 reflection { .2, .6 fresnel metallic exponent .5 }"
        " phong -1 metallic conserve_energy } }"
        "sphere { 0, 1 finish { reflection { .6 fresnel } } }"
        "sphere { 0, 1 finish { reflection rgb <1, .5, 0> ior 1.5 } }");
    const struct finish *f = object_layer(object_at(&r, 0), 0)->finish;
    assert_true(f->diffuse_albedo && f->specular_albedo && !f->phong_albedo);
    assert_number(f->diffuse_back, .3);
    assert_number(f->reflection.minimum.r, .2);
    assert_number(f->reflection.maximum.r, .6);
    assert_number(f->reflection.metallic, 1);
    assert_number(f->metallic, 1);
    assert_number(f->phong, 0);
    assert_true(f->conserve_energy && f->reflection.fresnel);
    f = object_layer(object_at(&r, 1), 0)->finish;
    assert_number(f->reflection.minimum.r, 0);
    assert_number(f->reflection.maximum.r, .6);
    assert_number(object_at(&r, 2)->more->interior->ior, 1.5);
    scene_end(&r);
}

/* ---- objects ---- */

static void difference_turns_the_others(void **state)
{
    (void)state;
    struct reading r =
        scene_good("#declare S = sphere { 0, 1 inverse }"
                   "difference { box { -1, 1 } S sphere { 0, 1 } }");
    const struct object *object = object_at(&r, 0);
    assert_int_equal(object->kind, OBJECT_INTERSECTION);
    assert_int_equal(object->more->child_count, 3);
    assert_false(object->more->children[0]->inverse);
    assert_false(object->more->children[1]->inverse);
    assert_true(object->more->children[2]->inverse);
    assert_int_equal(object->more->parts, 3);
    assert_int_equal(object->more->depth, 2);
    scene_end(&r);
}

static void clips_and_bounds(void **state)
{
    (void)state;
    struct reading r = scene_good(
        "sphere { 0, 1 clipped_by { plane { x, 0 } plane { y, 0 } translate z }"
        " translate x clipped_by { plane { z, 0 } } }"
        "sphere { 0, 1 bounded_by { box { -1, 1 } } clipped_by { bounded_by } }"
        "sphere { 0, 1 bounded_by { box { -1, 1 } } }");
    const struct object *object = object_at(&r, 0);
    assert_int_equal(object->more->clip_count, 3);
    vec3 origin = vec3_make(0, 0, 0);
    assert_vector(affine_point(&object->more->clips[1].transform, origin), 1, 0,
                  1);
    assert_vector(affine_point(&object->more->clips[2].transform, origin), 0, 0,
                  0);
    assert_int_equal(object_at(&r, 1)->more->clip_count, 1);
    assert_int_equal(object_at(&r, 2)->more->clip_count, 0);
    scene_end(&r);
}

static void flags(void **state)
{
    (void)state;
    struct reading r = scene_good(
        "sphere { 0, 1 hollow no_shadow no_image no_reflection inverse inverse"
        " double_illuminate }"
        "cone { 0, 1, y, 0 hollow off open }");
    const struct object *object = object_at(&r, 0);
    assert_true(object->hollow && object->has_hollow && object->no_shadow);
    assert_true(object->no_image && object->no_reflection);
    assert_true(object->double_illuminate);
    assert_false(object->inverse);
    object = object_at(&r, 1);
    assert_true(object->has_hollow);
    assert_false(object->hollow);
    scene_end(&r);
}

static void meshes(void **state)
{
    (void)state;
    struct reading r = scene_good(
        "#declare T = texture { pigment { rgb x } }"
        "mesh { triangle { 0, x, y texture { T } }"
        "  smooth_triangle { 0, z, x, z, y, x texture { T } }"
        "  triangle { 0, x, 2*x } inside_vector z }"
        "mesh2 { vertex_vectors { 4, <0,0,0>, <1,0,0>, <0,1,0>, <0, 0, -1> }"
        "  normal_vectors { 4, z, y, x, <0,0,1> }"
        "  texture_list { 1, texture { T } }"
        "  face_indices { 2, <0,1,2>, 0, <0,1,3>, 0 } }"
        "triangle { 0, x, y pigment { rgb 1 } }");
    const struct mesh *mesh = object_at(&r, 0)->mesh;
    assert_int_equal(mesh->triangle_count, 2); /* one had no area */
    assert_int_equal(mesh->texture_count, 1);
    assert_true(mesh->solid);
    assert_int_equal(mesh->triangles[0].normal[0], MESH_NONE);
    assert_int_not_equal(mesh->triangles[1].normal[0], MESH_NONE);
    mesh = object_at(&r, 1)->mesh;
    assert_int_equal(mesh->triangle_count, 2);
    assert_int_equal(mesh->triangles[1].normal[2], 3);
    assert_int_equal(mesh->triangles[1].texture, 0);
    assert_vector(mesh->vertices[3], 0, 0, -1);
    assert_true(object_at(&r, 1)->patch);
    assert_int_equal(object_at(&r, 2)->mesh->triangle_count, 1);
    scene_end(&r);
}

static void nesting_has_limits(void **state)
{
    (void)state;
    static const char *const texts[] = {
        "#declare A = sphere { 0, 1 }"
        "#for (I, 1, 1000) #declare A = union { object { A } } #end",
        "#declare A = sphere { 0, 1 }"
        "#for (I, 1, 40) #declare A = union { object { A } object { A } } #end",
        "#declare P = pigment { rgb 1 }"
        "#for (I, 1, 40) #declare P = pigment { gradient x pigment_map {"
        " [0 P] [1 P] } } #end",
        "#declare T = texture { pigment { rgb 1 } }"
        "#for (I, 1, 40) #declare T = texture { T } texture { T } #end",
        "#declare A = sphere { 0, 1 }"
        "#for (I, 1, 1000) #declare A = sphere { 0, 1 clipped_by { A } } #end",
    };
    for (size_t i = 0; i < sizeof texts / sizeof *texts; i++) {
        struct reading r = scene_read(texts[i]);
        assert_null(r.scene);
        scene_end(&r);
    }
}

/* ---- lights, camera, atmosphere, settings ---- */

static const struct light *light_at(const struct reading *r, size_t i)
{
    assert_int_equal(object_at(r, i)->kind, OBJECT_LIGHT);
    return object_at(r, i)->light;
}

static void lights(void **state)
{
    (void)state;
    struct reading r = scene_good(
        "light_source { <1, 2, 3> rgb <1, .5, .25> }"
        "light_source { 0, 1 cylinder point_at 4*z translate x }"
        "light_source { 0, 1 area_light 2*x, 3*y, 4, 5 adaptive 1 jitter"
        " circular orient fade_distance 2 fade_power 2"
        " spotlight radius 10 falloff 20 tightness 3 }"
        "light_source { y 1 looks_like { sphere { 0, 1 } } translate x }"
        "light_source { y }"
        "light_source { y 1 spotlight radius 10 shadowless }"
        "light_source { y 1 shadowless spotlight radius 10 }");
    assert_vector(light_at(&r, 0)->location, 1, 2, 3);
    assert_number(light_at(&r, 0)->colour.b, .25);
    assert_int_equal(light_at(&r, 1)->kind, LIGHT_CYLINDER);
    assert_number(light_at(&r, 1)->radius, .75);
    assert_vector(light_at(&r, 1)->point_at, 1, 0, 4);
    const struct light *light = light_at(&r, 2);
    assert_true(light->area && light->circular && light->orient);
    assert_true(light->jitter && !light->shadowless);
    assert_int_equal(light->size2, 5);
    assert_number(light->falloff, 20);
    assert_vector(light_at(&r, 3)->location, 1, 1, 0);
    assert_vector(object_middle(light_at(&r, 3)->looks_like), 1, 1, 0);
    assert_number(light_at(&r, 4)->colour.r, 0); /* POV-Ray's, too */
    assert_int_equal(light_at(&r, 5)->kind, LIGHT_POINT);
    assert_true(light_at(&r, 5)->shadowless);
    assert_int_equal(light_at(&r, 6)->kind, LIGHT_SPOT);
    assert_true(!light_at(&r, 6)->shadowless);
    scene_end(&r);
}

static void cameras(void **state)
{
    (void)state;
    struct reading r = scene_good("camera { location x }"
                                  "#declare C = camera { look_at 0 translate y"
                                  " location -5*z angle 90 right 2*x }"
                                  "camera { C translate x }");
    const struct camera *camera = &r.scene->camera;
    assert_int_equal(r.diag.warnings, 1);
    assert_vector(camera->location, 1, 1, -5);
    assert_vector(camera->direction, 0, 0, 1);
    assert_vector(camera->right, 2, 0, 0);
    scene_end(&r);
}

static void atmosphere(void **state)
{
    (void)state;
    struct reading r = scene_good(
        "background { rgb <.1, .2, .3> }"
        "fog { distance 5 color rgb x }"
        "fog { distance 0 color rgb y }"
        "#declare S = sky_sphere { pigment { rgb z } }"
        "sky_sphere { S pigment { rgb x } emission .5 rotate 30*x }");
    assert_number(r.scene->background.b, .3);
    assert_int_equal(r.scene->fogs.count, 1);
    assert_number(r.scene->fogs.items[0].distance, 5);
    assert_int_equal(r.scene->sky->count, 2);
    assert_number(r.scene->sky->emission.g, .5);
    scene_end(&r);
}

static void settings(void **state)
{
    (void)state;
    struct reading r =
        scene_good("global_settings { assumed_gamma 2.2 max_trace_level 1000"
                   " ambient_light rgb <1, .5, 0> adc_bailout .1 charset utf8"
                   " noise_generator 3 number_of_waves 4 }");
    assert_int_equal(r.scene->noise.generator, NOISE_PERLIN);
    assert_int_equal(r.scene->noise.waves, 4);
    const struct settings *s = &r.scene->settings;
    assert_int_equal(s->gamma_kind, GAMMA_POWER);
    assert_number(s->assumed_gamma, 1); /* the first counts */
    assert_int_equal(s->max_trace_level, 256);
    assert_number(s->ambient_light.g, .5);
    assert_number(s->adc_bailout, .1);
    scene_end(&r);
}

/* More ambient light than stands for light from elsewhere is seen in full and
 * lights nothing; where sky and background light the scene, what has no diffuse
 * light is a lamp, unless radiosity of version 3.7 takes the place of all that.
 */
static void ambient_glows(void **state)
{
    (void)state;
    static const struct {
        const char *text;
        double emission, glow, ambient;
    } rows[] = {
        { "#version 3.7; sphere { 0, 1 finish { ambient .8 diffuse 0 } }", 0,
          .8, 0 },
        { "sphere { 0, 1 finish { ambient .4 diffuse .6 } }", 0, .4, 0 },
        { "sphere { 0, 1 finish { ambient .3 diffuse .7 } }", 0, 0, .3 },
        { "sphere { 0, 1 finish { diffuse 0 } }", 0, 0, .1 },
        { "global_settings { ambient_light 4 } sphere { 0, 1 }", 0, .4, 0 },
        { "global_settings { light_mesh { sky on } } "
          "sphere { 0, 1 finish { ambient .8 diffuse 0 } }",
          .8, 0, 0 },
        { "global_settings { light_mesh { sky } } "
          "sphere { 0, 1 finish { ambient .8 diffuse .1 } }",
          0, 0, .8 },
        { "#version 3.6; global_settings { radiosity { } } "
          "sphere { 0, 1 finish { ambient .8 diffuse 0 } }",
          .8, 0, 0 },
        { "#version 3.7; global_settings { radiosity { } } "
          "sphere { 0, 1 finish { ambient .8 diffuse 0 } }",
          0, 0, .8 },
    };
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
        struct reading r = scene_good(rows[i].text);
        const struct texture *texture = r.scene->objects.items[0]->texture;
        const struct finish *finish = texture->layers->finish;
        assert_number(finish->emission.r, rows[i].emission);
        assert_number(finish->glow.r, rows[i].glow);
        assert_number(finish->ambient.r, rows[i].ambient);
        scene_end(&r);
    }
}

/* The #version in force at the end chooses the noise, unless the scene does. */
static void versions_have_noise(void **state)
{
    (void)state;
    static const struct {
        const char *text;
        enum noise_generator generator;
    } rows[] = {
        { "", NOISE_SCALED },
        { "#version 3.1;", NOISE_CLIPPED },
        { "#version 3.1; #version 3.5;", NOISE_SCALED },
        { "global_settings { noise_generator 3 } #version 3.1;", NOISE_PERLIN },
    };
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
        struct reading r = scene_good(rows[i].text);
        assert_int_equal(r.scene->noise.generator, rows[i].generator);
        scene_end(&r);
    }
}

static void light_meshes_and_skeletons(void **state)
{
    (void)state;
    struct reading r = scene_good(
        "#declare Fine = 3; #declare quality = 8;\n"
        "#declare Thing = sphere { <1, 2, 3>, 1 }\n"
        "global_settings { #ifdef (Glim) light_mesh {"
        "  quality quality density Fine*2 radius .5 interpolation spherical"
        "  model scalar shadows sharp threshold .2 levels 3"
        "  indirect { samples 100 bounces 2 }"
        "  region { <1, 0, 1>, 0 factor 4 }"
        "  region { min_extent(Thing) max_extent(Thing) factor .5 } }"
        " skeleton { resolution 64 heuristic network } #end }");
    const struct light_mesh_settings *m = &r.scene->settings.light_mesh;
    assert_number(m->quality, 8);
    assert_number(m->density, 6);
    assert_number(m->radius, .5);
    assert_string_equal(m->interpolation, "spherical");
    assert_int_equal(m->model, MESH_MODEL_SCALAR);
    assert_int_equal(m->shadows, MESH_SHADOWS_SHARP);
    assert_number(m->threshold, .2);
    assert_int_equal(m->levels, 3);
    assert_true(m->indirect.on);
    assert_int_equal(m->indirect.samples, 100);
    assert_int_equal(m->indirect.bounces, 2);
    assert_int_equal(m->regions.count, 2);
    assert_vector(m->regions.items[0].low, 0, 0, 0);
    assert_vector(m->regions.items[0].high, 1, 0, 1);
    assert_number(m->regions.items[1].low.y, 1);
    assert_number(m->regions.items[1].factor, .5);
    assert_int_equal(r.scene->settings.skeleton.resolution, 64);
    assert_string_equal(r.scene->settings.skeleton.heuristic, "network");
    scene_end(&r);
    r = scene_good("global_settings { light_mesh { indirect {} indirect off"
                   " model directional shadows soft } }");
    assert_false(r.scene->settings.light_mesh.indirect.on);
    assert_false(r.scene->settings.radiosity);
    assert_int_equal(r.scene->settings.light_mesh.shadows, MESH_SHADOWS_SOFT);
    assert_number(r.scene->settings.light_mesh.quality, 5);
    assert_int_equal(r.scene->settings.skeleton.resolution, 0);
    scene_end(&r);
}

static void radiosity_asks_for_interreflection(void **state)
{
    (void)state;
    struct reading r = scene_good(
        "global_settings { radiosity { pretrace_start .08 count 200, 1000"
        " error_bound .5 nearest_count 10,5 normal on media off } }");
    assert_true(r.scene->settings.radiosity);
    assert_true(r.scene->settings.light_mesh.indirect.on);
    scene_end(&r);
    /* 'off' is said, the wish is only implied: in either order 'off' wins. */
    const char *const off[] = {
        "global_settings { light_mesh { indirect off } radiosity {} }",
        "global_settings { radiosity {} light_mesh { indirect off } }",
    };
    for (size_t i = 0; i < 2; i++) {
        r = scene_good(off[i]);
        assert_true(r.scene->settings.radiosity);
        assert_false(r.scene->settings.light_mesh.indirect.on);
        scene_end(&r);
    }
}

static void wrong_declarations_are_said_once(void **state)
{
    (void)state;
    struct reading r =
        scene_read("#declare C = sphere { 0, 1 pigment { gradient x slope_map "
                   "{ [0 x] } } }"
                   "#declare D = union { object { C } } object { D }");
    assert_null(r.scene);
    assert_int_equal(r.diag.errors, 1);
    scene_end(&r);
}

static void one_mistake_is_one_error(void **state)
{
    (void)state;
    static const char *const texts[] = {
        "sphere { 0, 1 pigmnt { rgb 1 } scale 2 } box { -1, 1 }",
        "spere { 0, 1 pigment { rgb 1 } } box { -1, 1 }",
        "union { sphere { 0, 1 finish { phnog 1 } } box { -1, 1 } }",
        "sphere { 0, 1 } ; box { -1, 1 }",
        "light_source { 0, 1 radius 3 } box { -1, 1 }",
        "camera { location 0 look_at 0 } box { -1, 1 }",
        "camera { angle 200 } box { -1, 1 }",
        "sphere { 0, 1 texture { NoSuch } } box { -1, 1 }",
        "mesh2 { vertex_vectors { 3, 0, x, y } face_indices { 1, <0,1,3> } }",
        "mesh2 { vertex_vectors { 1000000000, 0, x, y } }",
        "plane { y, 0 pigment { checker color_map { [0 rgb 1] } } }",
        "sphere { 0, 1 clipped_by { triangle { 0, x, y } } }",
        "text { ttf \"a.ttf\" \"text\" 1, 0 pigment { rgb 1 } } box { -1, 1 }",
    };
    for (size_t i = 0; i < sizeof texts / sizeof *texts; i++) {
        struct reading r = scene_read(texts[i]);
        if (r.scene || r.diag.errors != 1)
            print_error("%u errors: %s\n", r.diag.errors, texts[i]);
        assert_null(r.scene);
        assert_int_equal(r.diag.errors, 1);
        scene_end(&r);
    }
}

/* Whole shapes that differ in something are not the same, nor is one that has
 * no length after another such. */
static void shapes_written_again_are_kept_once(void **state)
{
    (void)state;
    struct reading r = scene_good(
        "#macro L(X) lathe { linear_spline 3, <0,0>, <X,1>, <0,2> #end\n"
        "#macro P(H) prism { 0, H, 4, <0,0>, <1,0>, <0,1>, <0,0> #end\n"
        "#macro S(X) sor { 4, <0,0>, <X,1>, <1,2>, <0,3> #end\n"
        "L(1) } L(2) } L(1) translate x } L(1) sturm }\n"
        "P(1) } P(2) } P(1) rotate 9 } P(1) open }\n"
        "S(1) } S(2) } S(1) scale 2 } S(1) open }\n"
        "L(0) } #local I = 0; #while (I < 2)\n"
        "lathe { linear_spline 2, <1,1>, <1,1> } #local I = I + 1; #end");
    for (size_t i = 0; i < 12; i += 4) {
        const void *first = object_at(&r, i)->shape;
        assert_true(object_at(&r, i + 2)->shape == first);
        assert_true(object_at(&r, i + 1)->shape != first);
        assert_true(object_at(&r, i + 3)->shape != first);
    }
    for (size_t i = 13; i < 15; i++)
        assert_true(object_at(&r, i)->kind == OBJECT_UNION);
    scene_end(&r);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(transformations_apply_in_order),
        cmocka_unit_test(scaling_by_nothing_is_by_one),
        cmocka_unit_test(flat_transformations_are_refused),
        cmocka_unit_test(later_texture_is_painted_over),
        cmocka_unit_test(later_pigment_takes_the_place),
        cmocka_unit_test(texture_moves_with_what_follows),
        cmocka_unit_test(default_counts_when_it_goes_into_the_scene),
        cmocka_unit_test(block_patterns_fill_up_their_list),
        cmocka_unit_test(maps_old_and_new),
        cmocka_unit_test(finish_forms),
        cmocka_unit_test(difference_turns_the_others),
        cmocka_unit_test(clips_and_bounds),
        cmocka_unit_test(flags),
        cmocka_unit_test(meshes),
        cmocka_unit_test(nesting_has_limits),
        cmocka_unit_test(lights),
        cmocka_unit_test(cameras),
        cmocka_unit_test(atmosphere),
        cmocka_unit_test(settings),
        cmocka_unit_test(versions_have_noise),
        cmocka_unit_test(ambient_glows),
        cmocka_unit_test(light_meshes_and_skeletons),
        cmocka_unit_test(radiosity_asks_for_interreflection),
        cmocka_unit_test(wrong_declarations_are_said_once),
        cmocka_unit_test(one_mistake_is_one_error),
        cmocka_unit_test(shapes_written_again_are_kept_once),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
