/* lighting/ and tracer/: what a camera ray sees, against numbers that POV-Ray
 * 3.7 gives for the same lines (16-bit PNG, File_Gamma=1). */
#include <math.h>

#include "pixel.h"

struct row {
    const char *name;
    const char *scene;
    double r, g, b; /* POV-Ray's */
};

#define SKY   "background { rgb <.8, .6, .4> }"
#define WHITE "background { rgb 1 }"
#define LAMP  "light_source { -20*z rgb 1 }"
#define FLAT  "finish { ambient 0 diffuse 0 }"
#define CLEAR "texture { pigment { rgbt 1 } " FLAT " }"
#define HALF  "texture { pigment { rgbt <1, 1, 1, .5> } " FLAT " }"
#define WALL  "plane { -z, 0 pigment { rgb 1 } finish { ambient 0 diffuse 1 } }"
#define GLOW  "finish { ambient .2 diffuse .5 emission .1 }"
#define MIRROR(m)                                                              \
    "plane { -z, 0 pigment { rgb <.3, .5, .7> } "                              \
    "finish { ambient 0 diffuse 0 reflection { " m " } } }"
#define SLAB(from, to, inside)                                                 \
    "box { <-9, -9, " #from ">, <9, 9, " #to "> " CLEAR " interior { " inside  \
    " } }"
#define FADE "fade_distance 3.1 fade_power 1.7"
#define RAMP                                                                   \
    "camera { orthographic location <-4, 0, -10> direction <.5, 0, 1>"         \
    " right x*.0002 up y*.0002 } plane { -z, -5 pigment { gradient x "         \
    "color_map { [0 rgb 0] [1 rgb 1] } scale 10 translate -5*x } "             \
    "finish { emission 1 ambient 0 diffuse 0 } } "

static const struct row surface_rows[] = {
    { "opaque",
      SKY LAMP "plane { -z, 0 pigment { rgb <.3, .5, .7> } " GLOW " }", 0.23999,
      0.40000, 0.56001 },
    { "filter",
      SKY LAMP "plane { -z, 0 pigment { rgbf <.3, .5, .7, .4> } " GLOW " }",
      0.23999, 0.36001, 0.44800 },
    { "filter and transmit",
      SKY LAMP "plane { -z, 0 pigment { rgbft <.3, .5, .7, .3, .4> } " GLOW
               " }",
      0.46400, 0.45000, 0.41199 },
    { "more than opaque",
      SKY LAMP "plane { -z, 0 pigment { rgbft <.3, .5, .7, -.2, .4> } " GLOW
               " }",
      0.46400, 0.50001, 0.55200 },
    { "two layers",
      SKY LAMP
      "plane { -z, 0 texture { pigment { rgbft <.9, .2, .1, .2, .3> } " GLOW
      " } texture { pigment { rgbft <.3, .5, .7, .4, .1> } " GLOW " } }",
      0.28368, 0.28521, 0.34385 },
    { "highlight below",
      SKY LAMP
      "plane { -z, 0 texture { pigment { rgb 1 } finish { ambient 0 diffuse 0 "
      "specular .5 } } texture { pigment { rgbft <.3, .5, .7, .4, .1> } " FLAT
      " } }",
      0.11000, 0.15000, 0.19001 },
    { "mirror below",
      SKY
      "plane { -z, 0 texture { pigment { rgb 1 } finish { ambient 0 diffuse 0 "
      "reflection .5 } } texture { pigment { rgbft <.3, .5, .7, .4, .1> } " FLAT
      " } }",
      0.40000, 0.30001, 0.20000 },
    { "conserve_energy",
      SKY LAMP
      "plane { -z, 0 pigment { rgbft <.3, .5, .7, .3, .4> } finish { ambient "
      ".2 diffuse .5 reflection rgb <.5, .2, .9> conserve_energy } }",
      0.65901, 0.48901, 0.53140 },
    { "conserve_energy twice",
      SKY "plane { -z, 0 texture { pigment { rgbft <.9, .2, .1, .2, .3> } "
          "finish { ambient 0 diffuse 0 emission 1 reflection .5 "
          "conserve_energy } } texture { pigment { rgbft <.3, .5, .7, .4, .1> "
          "} finish { ambient 0 diffuse 0 reflection .3 conserve_energy } } }",
      0.73887, 0.52242, 0.35032 },
    { "metallic mirror", SKY MIRROR(".5 metallic .5"), 0.26000, 0.22499,
      0.17000 },
    { "exponent", SKY MIRROR(".5 exponent 2"), 0.44721, 0.38730, 0.31623 },
    { "fresnel without interior", SKY MIRROR("1 fresnel"), 0.00000, 0.00000,
      0.00000 },
    { "ambient_light",
      "global_settings { ambient_light <.5, 1, 2> } plane { -z, 0 pigment { "
      "rgb .5 } finish { ambient .4 diffuse 0 emission .1 } }",
      0.15000, 0.25000, 0.45000 },
    { "shadowless",
      "light_source { -20*z rgb 1 shadowless } plane { -z, 0 pigment { rgb .5 "
      "} finish { ambient 0 diffuse .6 specular .4 } } disc { -5*z, z, 1 "
      "no_image }",
      0.30001, 0.30001, 0.30001 },
};

static const struct row ray_rows[] = {
    { "weighs enough",
      "global_settings { adc_bailout .1 }" SKY MIRROR("rgb <.02, .02, .15>"),
      0.01601, 0.01199, 0.06000 },
    { "weighs too little",
      "global_settings { adc_bailout .1 }" SKY MIRROR(".0999"), 0.00000,
      0.00000, 0.00000 },
    { "weight before the tint",
      "global_settings { adc_bailout .1 }" SKY MIRROR(".15 metallic"), 0.03600,
      0.04500, 0.04199 },
    { "blue filter is dark",
      "global_settings { adc_bailout .1 }" WHITE
      "plane { -z, 0 pigment { rgbf <0, 0, 1, .8> } " FLAT " }",
      0.00000, 0.00000, 0.00000 },
    { "red filter is brighter",
      "global_settings { adc_bailout .1 }" WHITE
      "plane { -z, 0 pigment { rgbf <1, 0, 0, .34> } " FLAT " }",
      0.34000, 0.00000, 0.00000 },
    { "hidden layer",
      "global_settings { adc_bailout .1 }"
      "plane { -z, 0 texture { pigment { rgb 1 } finish { emission 1 } } "
      "texture { pigment { rgbf <1, 0, 0, .32> } " FLAT " } }",
      0.00000, 0.00000, 0.00000 },
    { "level 1 stops at glass",
      "global_settings { max_trace_level 1 }" WHITE "disc { 0, z, 1 " HALF " }",
      0.00000, 0.00000, 0.00000 },
    { "panes are never too many",
      "global_settings { max_trace_level 2 }" WHITE "disc { 0, z, 1 " HALF
      " } disc { z, z, 1 " HALF " } disc { 2*z, z, 1 " HALF " }",
      0.12500, 0.12500, 0.12500 },
    { "level 2 stops refraction",
      "global_settings { max_trace_level 2 }" WHITE SLAB(0, 1, "ior 1.5"),
      0.00000, 0.00000, 0.00000 },
    { "level 3 leaves the slab",
      "global_settings { max_trace_level 3 }" WHITE SLAB(0, 1, "ior 1.5"),
      1.00000, 1.00000, 1.00000 },
    { "mirror and inner mirror",
      WHITE "box { <-1, -1, -3>, <1, 1, 3> texture { pigment { rgbt 1 } finish "
            "{ ambient 0 diffuse 0 reflection .5 } } interior { fade_distance "
            "3 fade_power 2 } }",
      0.87500, 0.87500, 0.87500 },
    { "refraction", RAMP SLAB(-2, 2, "ior 1.5"), 0.77494, 0.77494, 0.77494 },
    { "nested", RAMP SLAB(-3, 3, "ior 1.5") SLAB(-2, 2, "ior 1.2"), 0.77311,
      0.77311, 0.77311 },
    { "overlapping", RAMP SLAB(-3, 1, "ior 1.5") SLAB(-1, 3, "ior 1.2"),
      0.77311, 0.77311, 0.77311 },
    { "no interior in glass",
      RAMP SLAB(-3, 3, "ior 1.5") "box { <-9, -9, -2>, <9, 9, 2> " CLEAR " }",
      0.81247, 0.81247, 0.81247 },
    { "camera inside", RAMP SLAB(-12, 2, "ior 1.5"), 0.97136, 0.97136,
      0.97136 },
    { "camera in two", RAMP SLAB(-12, 2, "ior 1.5") SLAB(-13, 3, "ior 1.2"),
      0.87720, 0.87720, 0.87720 },
    { "camera behind a disc",
      RAMP "disc { 0, z, 9 " CLEAR " interior { ior 1.5 } }", 0.75618, 0.75618,
      0.75618 },
    { "total reflection",
      "camera { orthographic location <-10, 0, -10> direction <1.7320508, 0, "
      "1> right x*.0002 up y*.0002 } sky_sphere { pigment { gradient z "
      "color_map { [0 rgb <.1, .2, .3>] [1 rgb <.8, .6, .4>] } scale 2 "
      "translate -z } } plane { z, 0 pigment { rgbft <1, .5, .2, .4, .3> } "
      "finish { ambient 0 diffuse 0 reflection .3 } interior { ior 1.5 } }",
      0.27500, 0.30001, 0.32500 },
    { "no_image",
      SKY "disc { 5*z, z, 1 no_image pigment { rgb 1 } } disc { 0, z, 1 " CLEAR
          " }",
      0.80000, 0.60000, 0.40000 },
    { "no_reflection", SKY "disc { -15*z, z, 1 no_reflection } " MIRROR("1"),
      0.80000, 0.60000, 0.40000 },
};

static const struct row fade_rows[] = {
    { "leaving fades", WHITE SLAB(0, 1, FADE), 0.87251, 0.87251, 0.87251 },
    { "nested",
      WHITE SLAB(0, 4, FADE) SLAB(.5, 1.2, "fade_distance 2.3 fade_power 1.3"),
      0.44778, 0.44778, 0.44778 },
    { "overlapping",
      WHITE SLAB(0, 4, FADE) SLAB(3, 6, "fade_distance 2.3 fade_power 1.3"),
      0.47578, 0.47578, 0.47578 },
    { "camera inside", WHITE SLAB(-20, 4, FADE), 0.07155, 0.07155, 0.07155 },
    { "ending inside",
      WHITE SLAB(
          0, 3, FADE) "disc { z, z, 1 pigment { rgb 1 } finish { ambient 1 } }",
      1.00000, 1.00000, 1.00000 },
    { "own light does not fade",
      SKY "box { <-1, -1, 0>, <1, 1, 2> texture { pigment { rgbt <1, 1, 1, .5> "
          "} finish { ambient 0 diffuse 0 emission .5 } } interior { "
          "fade_distance 2 fade_power 2 } }",
      0.47500, 0.45000, 0.42499 },
    { "one body of two parts",
      WHITE "union { box { <-1, -1, 0>, <1, 1, 2> } box { <-1, -1, 1>, <1, 1, "
            "5> } " CLEAR " interior { fade_distance 3.1 fade_power 1.7 } }",
      0.44842, 0.44842, 0.44842 },
    { "a difference",
      WHITE "difference { box { <-1, -1, 0>, <1, 1, 5> } box { <-2, -2, 1>, "
            "<2, 2, 3> } " CLEAR
            " interior { fade_distance 3.1 fade_power 1.7 } }",
      0.59165, 0.59165, 0.59165 },
};

static const struct row shadow_rows[] = {
    { "opaque", LAMP WALL "disc { -z, z, 1 no_image }", 0.00000, 0.00000,
      0.00000 },
    { "both sides filter",
      LAMP WALL
      "box { <-1, -1, -3>, <1, 1, -2> texture { pigment { rgbf <.5, .6, .7, "
      ".8> } } texture { pigment { rgbft <.9, .8, .7, .5, .2> } } no_image }",
      0.06760, 0.08295, 0.09487 },
    { "fade",
      LAMP WALL "box { <-1, -1, -3>, <1, 1, -2> " CLEAR
                " interior { fade_distance 2 fade_power 1000 fade_color rgb "
                "<.5, .2, 1> } no_image }",
      0.77881, 0.67031, 1.00000 },
    { "fade of nested bodies",
      LAMP WALL "box { <-1, -1, -9>, <1, 1, -1> " CLEAR
                " interior { fade_distance 3.1 fade_power 1.7 } no_image } box "
                "{ <-1, -1, -3>, <1, 1, -2.3> " CLEAR
                " interior { fade_distance 2.3 fade_power 1.3 } no_image }",
      0.20241, 0.20241, 0.20241 },
    { "unseen body around",
      LAMP WALL "box { <-1, -1, -3>, <1, 1, 1> " CLEAR
                " interior { fade_distance 3.1 fade_power 1.7 } no_image }",
      1.00000, 1.00000, 1.00000 },
    { "seen body around", LAMP WALL SLAB(-3, 1, FADE), 0.51394, 0.51394,
      0.51394 },
    { "too near the surface", LAMP WALL "disc { -.0009*z, z, 1 no_image }",
      1.00000, 1.00000, 1.00000 },
    { "not too near", LAMP WALL "disc { -.0011*z, z, 1 no_image }", 0.00000,
      0.00000, 0.00000 },
    { "too near the lamp", LAMP WALL "disc { -19.9991*z, z, 1 no_image }",
      1.00000, 1.00000, 1.00000 },
    { "no_shadow", LAMP WALL "disc { -z, z, 1 no_shadow no_image }", 1.00000,
      1.00000, 1.00000 },
    { "looks_like",
      "light_source { -20*z rgb 1 looks_like { sphere { 0, 3 } } }" WALL,
      1.00000, 1.00000, 1.00000 },
    { "behind a parallel light",
      "light_source { -5*z rgb 1 parallel point_at 0 }" WALL
      "disc { -8*z, z, 1 }",
      0.00000, 0.00000, 0.00000 },
    { "penumbra",
      "light_source { -10*z rgb 1 area_light 4*x, 4*y, 5, 5 }" WALL
      "box { <-.6, -9, -5.1>, <9, 9, -5> pigment { rgb 0 } no_image }",
      0.12500, 0.12500, 0.12500 },
    { "parallel penumbra",
      "light_source { <20, 0, -10> rgb 1 area_light 4*x, 4*y, 5, 5 parallel "
      "point_at <20, 0, 0> }" WALL
      "box { <-.2, -9, -5.1>, <9, 9, -5> pigment { rgb 0 } no_image }",
      0.37501, 0.37501, 0.37501 },
    { "area_illumination",
      "light_source { <6, 3, -5> rgb .5 area_light 4*x, 4*y, 3, 3 "
      "area_illumination on fade_distance 5 fade_power 2 }" WALL,
      0.16170, 0.16170, 0.16170 },
    { "oriented",
      "light_source { <6, 3, -5> rgb .5 area_light 4*x, 4*y, 3, 3 circular "
      "orient area_illumination on }" WALL,
      0.29168, 0.29168, 0.29168 },
};

static const struct row air_rows[] = {
    { "background transmits", "background { rgbt <.8, .6, .4, .3> }", 0.56001,
      0.42000, 0.28000 },
    { "background filters nothing", "background { rgbf <.8, .6, .4, .3> }",
      0.80000, 0.60000, 0.40000 },
    { "sky in layers",
      SKY "sky_sphere { pigment { rgbft <.2, .3, .4, .3, .2> } pigment { rgbft "
          "<.5, .9, .2, .1, .6> } emission <.5, .7, 2> }",
      0.24269, 0.38151, 0.44736 },
    { "fog",
      SKY "fog { distance 10 rgb <.5, .6, .7> } disc { 0, z, 1 pigment { rgb "
          "<.3, .5, .7> } finish { ambient 1 diffuse 0 } }",
      0.42643, 0.56321, 0.70001 },
    { "fog filters",
      SKY "fog { distance 10 rgbf <.5, .6, .7, .3> } disc { 0, z, 1 pigment { "
          "rgb <.3, .5, .7> } finish { ambient 1 diffuse 0 } }",
      0.40987, 0.54115, 0.67683 },
    { "fog keeps transmit", SKY "fog { distance 10 rgbt <.5, .6, .7, .3> }",
      0.59001, 0.60000, 0.60999 },
    { "two fogs",
      SKY "fog { distance 10 rgb <.5, .6, .7> } fog { distance 7 rgbt <.5, .1, "
          ".2, .2> } disc { 0, z, 1 pigment { rgb <.3, .5, .7> } finish { "
          "ambient 1 diffuse 0 } }",
      0.72268, 0.49938, 0.65628 },
    { "fog not in bodies",
      SKY "fog { distance 10 rgb <.5, .6, .7> } box { <-1, -1, -20>, <1, 1, "
          "5> " CLEAR
          " } disc { 10*z, z, 1 pigment { rgb 1 } finish { ambient 1 } }",
      0.80327, 0.84262, 0.88196 },
    { "fog in hollow bodies",
      SKY "fog { distance 10 rgb <.5, .6, .7> } box { <-1, -1, -20>, <1, 1, 5> "
          "hollow " CLEAR
          " } disc { 10*z, z, 1 pigment { rgb 1 } finish { ambient 1 } }",
      0.56767, 0.65414, 0.74060 },
    { "fog between parts of a body",
      "fog { distance 10 rgb <.5, .6, .7> } disc { 10*z, z, 1 pigment { rgb 1 "
      "} finish { ambient 1 } } union { box { <-1, -1, 0>, <1, 1, 2> } box { "
      "<-1, -1, 1>, <1, 1, 5> } " CLEAR " }",
      0.60095, 0.68077, 0.76057 },
    { "fog in a mirror",
      SKY "fog { distance 10 rgb <.5, .6, .7> }" MIRROR(".5"), 0.40803, 0.48963,
      0.57124 },
};

static void rows_check(const struct row *rows, size_t count)
{
    for (size_t i = 0; i < count; i++) {
        const struct row *row = &rows[i];
        rgb seen =
            pixel_see(row->scene, (struct pixel_options){ 9, false }).colour;
        double off = fmax(fabs(seen.r - row->r),
                          fmax(fabs(seen.g - row->g), fabs(seen.b - row->b)));
        if (!(off < 4e-5))
            fail_msg("%s: <%.5f, %.5f, %.5f>, not <%.5f, %.5f, %.5f>",
                     row->name, seen.r, seen.g, seen.b, row->r, row->g, row->b);
    }
}

#define ROWS_TEST(name)                                                        \
    static void test_##name(void **state)                                      \
    {                                                                          \
        (void)state;                                                           \
        rows_check(name##_rows, sizeof name##_rows / sizeof *name##_rows);     \
    }
ROWS_TEST(surface)
ROWS_TEST(ray)
ROWS_TEST(fade)
ROWS_TEST(shadow)
ROWS_TEST(air)

/* Opacity with +UA. */
static void test_alpha(void **state)
{
    static const struct {
        const char *scene;
        double r, opacity; /* premultiplied */
    } rows[] = {
        { "", 0, 0 },
        { SKY, 0.8, 1 },
        { "background { rgbft <.8, .6, .4, .3, .2> }", 0.4, 0.60902 },
        { "background { rgbt <.8, .6, .4, 1> }" MIRROR(".5"), 0.4, 1 },
        { "disc { 0, z, 1 pigment { rgbf <.3, .5, .7, .4> } "
          "finish { ambient 1 } }",
          0.18, 0.81463 },
        { "sphere { 0, 1 pigment { rgbt <1, 1, 1, .8> } finish { ambient 1 } "
          "interior { ior 1.5 } }",
          0.36, 0.36 },
        { "sky_sphere { pigment { rgbf <.2, .3, .4, .3> } }", 0.14, 0.9155 },
        { "background { rgbt <.8, .6, .4, 1> } "
          "fog { distance 10 rgbft <.5, .6, .7, .3, .2> }",
          0.4, 0.8251 },
        { "global_settings { max_trace_level 1 } disc { 0, z, 1 " HALF " }", 0,
          1 },
    };
    (void)state;
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
        struct radiance seen =
            pixel_see(rows[i].scene, (struct pixel_options){ 9, true });
        if (!(fabs(seen.colour.r - rows[i].r) < 4e-5 &&
              fabs(seen.opacity - rows[i].opacity) < 4e-5))
            fail_msg("row %zu: %.5f %.5f, not %.5f %.5f", i, seen.colour.r,
                     seen.opacity, rows[i].r, rows[i].opacity);
    }
}

/* The same surface at every +Q. */
static void test_quality(void **state)
{
    static const char *const scene =
        SKY LAMP "plane { -z, 0 pigment { rgbft <.3, .5, .7, .3, .4> "
                 "quick_color rgbft <.2, .4, .6, .1, .2> } finish { ambient .2 "
                 "diffuse .5 emission .1 specular .1 reflection .05 } } "
                 "disc { -15*z, z, 1 no_reflection }";
    static const double wanted[] = { 0.2,   0.2,   0.212, 0.212, 0.042,
                                     0.042, 0.419, 0.419, 0.459, 0.459 };
    (void)state;
    for (int q = 0; q <= 11; q++) {
        int last = q < 9 ? q : 9;
        rgb seen = pixel_see(scene, (struct pixel_options){ q, false }).colour;
        if (!(fabs(seen.r - wanted[last]) < 4e-5))
            fail_msg("+Q%d: %.5f, not %.5f", q, seen.r, wanted[last]);
    }
}

/* A white wall lit from every side at once is as bright as its albedo: a
 * sphere of albedo 0.5 around a lamp. */
static void test_closed_form(void **state)
{
    (void)state;
    rgb seen = pixel_see("camera { location 0 } light_source { 0 rgb 1 } "
                         "sphere { 0, 1 pigment { rgb .5 } "
                         "finish { ambient 0 diffuse 1 } }",
                         (struct pixel_options){ 9, false })
                   .colour;
    if (!(fabs(seen.g - 0.5) < 1e-12))
        fail_msg("%.15f, not 0.5", seen.g);
}

/* Rays that are followed together see to the bit what each sees alone. */
static void expect_together_as_alone(const char *scene)
{
    struct pixel_tracer pixel;
    pixel_start(&pixel, scene, (struct pixel_options){ .quality = 9 });
    tracer_ready(&pixel.tracer);
    for (int block = 0; block < 64; block++) {
        struct picture_place places[WORLD_RAYS] = { 0 };
        struct rays rays;
        struct world_hit hits[WORLD_RAYS];
        struct radiance seen[WORLD_RAYS];
        unsigned count = block == 5 ? 3 : block == 6 ? 9 : WORLD_RAYS;
        for (unsigned i = 0; i < count; i++) {
            places[i].at[0] = (block % 8 * 4 + i % 4) / 32.0;
            places[i].at[1] = (block / 8 * 4 + i / 4) / 32.0;
        }
        tracer_rays(&pixel.tracer, places, count, &rays);
        const struct tracer_met met = { places, &rays, hits, count };
        tracer_meet_many(&pixel.tracer, &rays, count, hits);
        tracer_see_many(&pixel.tracer, &pixel.worker, &met, seen);
        for (unsigned i = 0; i < count; i++) {
            struct radiance alone =
                tracer_camera(&pixel.tracer, &pixel.worker, &places[i]);
            assert_memory_equal(&alone, &seen[i], sizeof alone);
        }
    }
    pixel_end(&pixel);
}

static void rays_lit_together_are_as_alone(void **state)
{
    static const char *const lamps[] = {
        "light_source { <-6, 8, -9> rgb .7 }"
        "light_source { <7, 3, -9> rgb .4 fade_distance 9 fade_power 2 }",
        "light_source { <-2, 6, -5> rgb .9 spotlight point_at <-1, -1, 0> "
        "radius 10 falloff 20 tightness 3 }"
        "light_source { <0, 6, -5> rgb .8 cylinder point_at -y radius 1 "
        "falloff 2 }"
        "light_source { <3, 9, -2> rgb .4 parallel point_at 0 }",
        "light_source { <3, 9, -2> rgb .4 area_light x, z, 3, 3 }"
        "light_source { <-3, 5, -2> rgb .4 area_light x, z, 3, 3 "
        "area_illumination }"
        "light_source { <-3, 5, 4> rgb .4 shadowless }"
        "light_source { <1, 3, 0> rgb .4 looks_like { sphere { 0, .2 } } }",
        "light_group { light_source { <-6, 8, -9> rgb .7 } "
        "sphere { <1.3, 0, -2>, .3 } global_lights off }"
        "light_source { <2, 4, -6> rgb .5 }",
        "light_source { <-6, 8, -9> rgb .7 media_attenuation on }"
        "light_source { <7, 3, -9> rgb .4 media_interaction off }",
    };
    static const char *const things[] = {
        "",
        "sphere { <.2, .6, -.5>, .5 pigment { rgb .7 } normal { bumps .5 } "
        "finish { phong .6 crand .1 } }"
        "box { <-1.5, -1, -1>, <-.7, .6, 0> texture { pigment { rgb .6 } } "
        "texture { pigment { rgbt <.9, .2, .1, .5> } "
        "finish { specular .5 metallic } } finish { reflection .3 } }"
        "mesh { triangle { <1, -1, 0>, <2, -1, 0>, <1.5, 1, 0> } "
        "pigment { rgb 1 } double_illuminate finish { diffuse .4, .2 } }",
        "sphere { <.2, .6, -.5>, .5 pigment { rgbf .8 } "
        "interior { ior 1.4 } finish { reflection .1 } }"
        "fog { distance 20 rgb .5 }",
        "sphere { <.2, .6, -.5>, .5 pigment { rgbf .8 } "
        "interior { ior 1.2 fade_distance 1 fade_power 2 caustics .2 } }"
        "difference { box { <-1.5, -1, -1>, <-.7, .6, 0> } "
        "sphere { <-1.5, .6, -1>, .4 } pigment { rgbt .5 } }"
        "mesh { triangle { <1, -1, 0>, <2, -1, 0>, <1.5, 1, 0> } "
        "pigment { rgbt <.3, .2, .1, .6> } }"
        "cylinder { <0, -1, -2>, <0, 0, -2.5>, .2 pigment { rgb .8 } }",
        "sphere { 0, .5 pigment { marble turbulence 1 scale .3 } "
        "normal { granite .4 scale .5 } finish { phong .6 metallic "
        "specular .3 emission .1 } scale <1, 2, 1> rotate 20 "
        "translate <.2, .6, -.5> }"
        "box { <-1.5, -1, -1>, <-.7, .6, 0> pigment { slope y } inverse }"
        "mesh { smooth_triangle { <1, -1, 0>, <-1, 0, -3>, <2, -1, 0>, "
        "<1, 0, -3>, <1.5, 1, 0>, <0, 1, -3> } pigment { gradient y } }",
        /* Rays that branch off again and again, and wait for each other. */
        "box { <-3, -1, 1>, <3, 3, 1.1> pigment { rgb .2 } "
        "finish { reflection { .2, .9 exponent 1.5 } } }"
        "plane { z, -8 pigment { rgb .1 } finish { reflection .7 } }"
        "box { <-1.5, -1, -1>, <-.7, .6, 0> texture { pigment { rgb .6 } "
        "finish { reflection .4 } } texture { pigment { rgbt <.9, .2, .1, .5> "
        "} "
        "normal { bumps .3 } finish { reflection .3 metallic } } }"
        "sphere { <.2, .6, -.5>, .5 pigment { rgbf .9 } finish { reflection "
        "{ 0, 1 fresnel } conserve_energy } interior { ior 1.6 dispersion 1.1 "
        "dispersion_samples 5 fade_distance 1 fade_power 1001 } }"
        "cylinder { <1.2, -1, -1>, <1.2, 1, -1>, .3 open pigment { rgbf .8 } "
        "no_reflection }",
        /* One layer, painted side by side, that lets light pass by parts and
         * mirrors. */
        "sphere { <.2, .6, -.5>, .5 pigment { bozo color_map { "
        "[0 rgb <.9, .3, .2>] [1 rgbft <.3, .8, .9, .7, .3>] } scale .2 } "
        "normal { bumps .6 scale .2 } finish { phong .7 metallic reflection "
        "{ .1, .8 fresnel metallic .6 } conserve_energy } "
        "interior { ior 1.5 } }"
        "box { <-1.5, -1, -1>, <-.7, .6, 0> pigment { rgbt <.9, .6, .4, .4> } "
        "normal { wrinkles .8 scale .3 } finish { ambient .2 emission .1 "
        "reflection { .3 metallic } } }"
        "mesh { triangle { <1, -1, 0>, <2, -1, 0>, <1.5, 1, 0> } "
        "pigment { checker rgbf .8 rgb .4 scale .2 } }",
        /* Finishes that are no number times the cosine, in air that is full of
         * things. */
        "sphere { <.2, .6, -.5>, .5 pigment { rgb <.9, .5, .2> } "
        "finish { brilliance 2.5 diffuse albedo .7 phong .4 reflection .2 "
        "irid { .4 thickness .3 turbulence .4 } } }"
        "box { <-1.5, -1, -1>, <-.7, .6, 0> pigment { rgb .8 } "
        "normal { dents .6 } finish { brilliance .5 crand .2 } }"
        "mesh { triangle { <1, -1, 0>, <2, -1, 0>, <1.5, 1, 0> } "
        "pigment { rgbt <1, .4, .6, .3> } finish { crand .3 specular .6 } "
        "double_illuminate }"
        "fog { distance 30 rgb <.3, .4, .5> fog_type 2 fog_offset -.5 "
        "fog_alt .4 turbulence .5 turb_depth .3 }"
        "rainbow { angle 40 width 15 distance 3 direction <1, -.5, -1> "
        "color_map { [0 rgbt 1] [.5 rgbt <1, .2, .3, .6>] [1 rgbt 1] } }"
        "media { scattering { 1, .02 } samples 5 }",
        /* Several layers, of which some end early, and leaves that have not
         * the same paint all over. */
        "sphere { <.2, .6, -.5>, .5 texture { pigment { rgb <.9, .5, .2> } "
        "normal { granite .3 } finish { phong .4 reflection .2 } } "
        "texture { pigment { bozo color_map { [.3 rgb <.2, .5, .3>] "
        "[.6 rgbft <.3, .8, .9, .6, .3>] [.9 rgbt <1, 1, 1, .999>] } "
        "scale .1 } normal { bumps .5 scale .1 } finish { brilliance 2 "
        "specular .3 } } texture { pigment { rgbf <.9, .9, .5, .7> } "
        "finish { crand .1 diffuse .3, .2 } } interior_texture { pigment { "
        "rgb <.2, .3, .9> } } }"
        "difference { box { <-1.5, -1, -1>, <-.7, .6, 0> } "
        "sphere { <-1.5, .6, -1>, .6 } texture { pigment { rgbt .5 } "
        "finish { reflection .1 conserve_energy } } texture { pigment { "
        "checker rgbt .8 rgb .4 scale .2 } } interior_texture { pigment { "
        "rgb <.9, .2, .1> } finish { reflection .3 } } rotate y * 20 }"
        "mesh2 { vertex_vectors { 4, <1, -1, 0>, <2, -1, 0>, <1.5, 1, 0>, "
        "<2.5, 1, -.5> } texture_list { 2, texture { pigment { rgb <.9, .9, "
        ".1> } normal { dents .4 scale .1 } } texture { pigment { checker rgb "
        "1 rgbt .6 scale .2 } } } face_indices { 2, <0, 1, 2>, 0, <1, 2, 3>, 1 "
        "} pigment { rgb .5 } }",
        /* Pigments of pigments: of space alone, and of the surface. */
        "sphere { <.2, .6, -.5>, .5 pigment { pigment_pattern { marble "
        "turbulence .4 pigment_map { [0 bozo scale .1] [1 checker rgb 1 rgb "
        ".2 scale .1] } } color_map { [0 rgb x] [1 rgbt <1, 1, 1, .4>] } "
        "scale .6 } normal { pigment_pattern { granite } .4 } }"
        "box { <-1.5, -1, -1>, <-.7, .6, 0> pigment { pigment_pattern { "
        "slope { <1, 1, -1> } } color_map { [0 rgb x] [1 rgb z] } } rotate 20 "
        "}",
    };
    (void)state;
    for (size_t i = 0; i < sizeof lamps / sizeof *lamps; i++)
        for (size_t k = 0; k < sizeof things / sizeof *things; k++) {
            char scene[4096];
            snprintf(scene, sizeof scene,
                     "camera { location <0, 2, -7> look_at 0 angle 45 }"
                     "plane { y, -1 pigment { checker rgb .8 rgb .3 } }"
                     "sphere { <-.4, -.4, -1>, .6 pigment { rgb .9 } }"
                     "%s%s",
                     lamps[i], things[k]);
            expect_together_as_alone(scene);
        }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_surface),
        cmocka_unit_test(test_ray),
        cmocka_unit_test(test_fade),
        cmocka_unit_test(test_shadow),
        cmocka_unit_test(test_air),
        cmocka_unit_test(test_alpha),
        cmocka_unit_test(test_quality),
        cmocka_unit_test(test_closed_form),
        cmocka_unit_test(rays_lit_together_are_as_alone),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
