/* Patterns of pigments and normals: which one, its arguments, and the
 * modifiers that place and fold it. The patterns themselves are tables in
 * scene/pattern/. */
#include "parse/rules.h"
#include "parse/tables.h"

#include "parse/user_function.h"
#include "scene/density_file.h"
#include "scene/function.h"
#include "scene/object_probe.h"
#include "scene/orbit.h"
#include "scene/pavement.h"
#include "scene/penrose.h"
#include "scene/samples.h"
#include "scene/tiling.h"

#define TURBULENCE(name, kind, member, low, high, help)                        \
    {                                                                          \
        name, kind, offsetof(struct pattern, turbulence.member), low, high,    \
            help                                                               \
    }
#define PATTERN(name, kind, member, low, high, help)                           \
    {                                                                          \
        name, kind, offsetof(struct pattern, member), low, high, help          \
    }

const struct field pattern_fields[] = {
    TURBULENCE("turbulence", FIELD_VECTOR, amount, 0, 0,
               "how far the point looked up walks at random"),
    TURBULENCE("octaves", FIELD_INTEGER, octaves, 0, 0,
               "steps of the walk, 1 to 10, 6"),
    TURBULENCE("omega", FIELD_FLOAT, omega, 0, 0,
               "each step is so much shorter, 0.5"),
    TURBULENCE("lambda", FIELD_FLOAT, lambda, 0, 0,
               "and turns so much faster, 2"),
    PATTERN("frequency", FIELD_FLOAT, frequency, 0, 0, "repetitions, 1"),
    PATTERN("phase", FIELD_FLOAT, phase, 0, 0, "shift of the map, 0"),
    { NULL },
};

const char *pattern_name(const struct pattern *pattern)
{
    return pattern->kind ? pattern->kind->name : "pigment";
}

/* Another pattern in the place of the one there was: its settings are new, but
 * it stays where the old one was, and its wave, too, is the old one's unless it
 * comes with one (measured). */
static void pattern_become(struct parser *p, struct pattern *pattern,
                           const struct pattern_kind *kind)
{
    struct pattern fresh = pattern_new(p->scene_arena, kind);
    pattern_lay(&fresh, pattern->inverse);
    fresh.warps = pattern->warps;
    fresh.frequency = kind->still || kind->blocks ? 0 : pattern->frequency;
    fresh.phase = pattern->phase;
    fresh.exponent = pattern->exponent;
    if (kind->wave == WAVE_RAMP)
        fresh.wave = pattern->wave;
    fresh.turbulent = pattern->turbulent;
    fresh.uv = pattern->uv;
    fresh.turbulence = pattern->turbulence;
    fresh.noise = &p->scene->noise;
    fresh.generator = pattern->generator;
    *pattern = fresh;
}

/* Samples are many looks at what it is made of: a loop may not make many. */
static bool pattern_sampled(struct parser *p, struct pattern *pattern)
{
    enum { SAMPLES_COST = 1000 }; /* in rounds of a loop */
    if (!stream_round(p, SAMPLES_COST, p->last_span))
        return false;
    pattern_take_samples(p->scene_arena, pattern);
    return true;
}

/* function_pattern = "function" "{" ( field_body | body_operation ) "}" . */
static bool parse_function_pattern(struct parser *p, struct pattern *pattern)
{
    struct value value;
    struct span span = stream_span(p);
    if (!parse_function(p, &value))
        return false;
    const struct function *function = value.function;
    if (function->parameter_count != 3 || function->values)
        return error_at(p, span_join(span, p->last_span), NULL,
                        "a pattern needs a function of x, y and z that gives "
                        "a number");
    struct made_pattern *made = pattern->parameters;
    made->function = function;
    return pattern_sampled(p, pattern);
}

/* pigment_pattern = "pigment_pattern" "{" pigment_body "}" . */
static bool parse_pigment_pattern(struct parser *p, struct pattern *pattern)
{
    struct made_pattern *made = pattern->parameters;
    return parse_plain_pigment(p, &made->pigment) &&
           pattern_sampled(p, pattern);
}

/* object_pattern = "object" "{" object {transformation} block_list "}" .
 * In normals and textures there is their own kind of list instead. It is read
 * by whoever calls, and then parse_pattern_end. */
static bool parse_object_pattern(struct parser *p, struct pattern *pattern)
{
    struct made_pattern *made = pattern->parameters;
    struct object *object;
    stream_next(p);
    if (!block_begin(p, &made->open))
        return false;
    struct span span = stream_span(p);
    if (!parse_object(p, &object) ||
        parse_moves(p, &(struct modifiers){ .object = object }) == WRONG)
        return block_end(p, made->open, false);
    made->object = object;
    if (!object_is_solid(object))
        return error_at(
                   p, span_join(span, p->last_span), NULL,
                   "the 'object' pattern needs an object with an inside") &&
               block_end(p, made->open, false);
    object_probe_expect(object, true, p->scene_arena);
    accept(p, TOKEN_COMMA);
    return pattern_sampled(p, pattern) || block_end(p, made->open, false);
}

bool parse_pattern_end(struct parser *p, const struct pattern *pattern, bool ok)
{
    if (pattern->kind != pattern_find("object"))
        return ok;
    const struct made_pattern *made = pattern->parameters;
    return block_end(p, made->open, ok);
}

static bool image_pattern_read(struct parser *p, struct pattern *pattern)
{
    struct made_pattern *made = pattern->parameters;
    return parse_image_pattern(p, &made->image) && pattern_sampled(p, pattern);
}

static double density_sample(const void *pattern, vec3 point)
{
    return ((const struct pattern *)pattern)->kind->value(pattern, point);
}

static bool density_file_read(struct parser *p, struct pattern *pattern)
{
    struct density_file *file = pattern->parameters;
    if (!parse_density_file(p, file))
        return false;
    file->samples = samples_take(p->scene_arena, density_sample, pattern);
    return true;
}

static bool parse_tiling(struct parser *p, struct pattern *pattern)
{
    double (*const penrose[])(double x, double z) = { penrose_pentagons,
                                                      penrose_kites,
                                                      penrose_rhombs };
    struct tiling_use *use = pattern->parameters;
    stream_next(p);
    if (!parse_arguments(p, pattern->kind->arguments, use))
        return false;
    if (use->number > TILING_COUNT)
        use->penrose = penrose[use->number - TILING_COUNT - 1];
    else
        use->tiling = tiling_make(p->scene_arena, use->number);
    return true;
}

/* The tiles are known when all that is said of them side by side is. */
static bool parse_pavement(struct parser *p, struct pattern *pattern)
{
    struct pavement *pavement = pattern->parameters;
    struct span span = p->last_span;
    const struct field *field;
    while ((field = accept_field(p, pattern->kind->items))) {
        if (!parse_field(p, field, pavement))
            return false;
    }
    pavement->edges = pavement_find(pavement);
    if (pavement->edges)
        return true;
    span = span_join(span, p->last_span);
    int count = pavement_patterns(pavement->sides, pavement->tiles);
    if (count > 0)
        return error_at(p, span, NULL,
                        "there are patterns 1 to %d of %d tiles with %d sides, "
                        "found %d",
                        count, pavement->tiles, pavement->sides,
                        pavement->pattern);
    if (pavement->sides == 5)
        return error_at(p, span, NULL, "number_of_sides is 3, 4 or 6");
    return error_at(p, span, NULL,
                    "hexagons have number_of_tiles 1 to 5, found %d",
                    pavement->tiles);
}

/* magnet = "magnet" float ( "mandel" | "julia" vector [","] ) float . */
static bool parse_magnet(struct parser *p, struct pattern *pattern)
{
    struct orbit *orbit = pattern->parameters;
    stream_next(p);
    struct span span = stream_span(p);
    if (!parse_integer(p, &orbit->magnet))
        return false;
    if (orbit->magnet != 1 && orbit->magnet != 2)
        return error_at(p, span_join(span, p->last_span), "1",
                        "there are magnet 1 and 2, found %d", orbit->magnet);
    orbit->julia = accept_word(p, "julia");
    if (!orbit->julia && !accept_word(p, "mandel"))
        return error_expected(p, "'mandel' or 'julia'");
    const struct pattern_kind *kind =
        pattern_find(orbit->julia ? "julia" : "mandel");
    return parse_arguments(p, kind->arguments, orbit);
}

/* pattern = PATTERN arguments | function_pattern | pigment_pattern
 *         | object_pattern | magnet | slope | image_pattern
 *         | density_file .
 * The name of a pattern and what its table in scene/pattern/ says. */
enum taken parse_normal_pattern(struct parser *p, struct pattern *pattern)
{
    const struct token *token = stream_peek(p);
    if (token->kind != TOKEN_WORD)
        return NOT_MINE;
    const struct pattern_kind *kind = pattern_find(token->word->text);
    if (!kind)
        return NOT_MINE;
    pattern_become(p, pattern, kind);
    switch (token->word->keyword) {
    case KEYWORD_FUNCTION:
        return parse_function_pattern(p, pattern);
    case KEYWORD_OBJECT:
        return parse_object_pattern(p, pattern);
    case KEYWORD_PIGMENT_PATTERN:
        return parse_pigment_pattern(p, pattern);
    case KEYWORD_MAGNET:
        return parse_magnet(p, pattern);
    case KEYWORD_PAVEMENT:
        stream_next(p);
        return parse_pavement(p, pattern);
    case KEYWORD_TILING:
        return parse_tiling(p, pattern);
    case KEYWORD_SLOPE:
        return parse_slope(p, pattern->parameters);
    case KEYWORD_DENSITY_FILE:
        return density_file_read(p, pattern);
    case KEYWORD_IMAGE_PATTERN:
        return image_pattern_read(p, pattern);
    default:
        stream_next(p);
    }
    return !kind->arguments ||
           parse_arguments(p, kind->arguments, pattern->parameters);
}

/* facets has normals and no values: POV-Ray refuses it here, too. */
enum taken parse_pattern(struct parser *p, struct pattern *pattern)
{
    if (stream_keyword(p) != KEYWORD_FACETS)
        return parse_normal_pattern(p, pattern);
    error_at(p, stream_span(p), "crackle",
             "'facets' is of normals alone: normal { facets size 0.5 }");
    return WRONG;
}

/* noise_generator = "noise_generator" float . */
bool parse_noise_generator(struct parser *p, int *generator)
{
    stream_next(p);
    struct span span = stream_span(p);
    if (!parse_integer(p, generator))
        return false;
    return (*generator >= 1 && *generator <= 3) ||
           error_at(p, span, "2", "noise_generator is 1, 2 or 3");
}

/* wave = "ramp_wave" | "triangle_wave" | "sine_wave" | "scallop_wave"
 *      | "cubic_wave" | "poly_wave" [float] . */
static enum taken parse_wave(struct parser *p, struct pattern *pattern)
{
    static const struct {
        enum keyword keyword;
        enum wave wave;
    } waves[] = {
        { KEYWORD_RAMP_WAVE, WAVE_RAMP },
        { KEYWORD_TRIANGLE_WAVE, WAVE_TRIANGLE },
        { KEYWORD_SINE_WAVE, WAVE_SINE },
        { KEYWORD_SCALLOP_WAVE, WAVE_SCALLOP },
        { KEYWORD_CUBIC_WAVE, WAVE_CUBIC },
        { KEYWORD_POLY_WAVE, WAVE_POLY },
    };
    for (size_t i = 0; i < sizeof waves / sizeof *waves; i++) {
        if (!accept_keyword(p, waves[i].keyword))
            continue;
        pattern->wave = waves[i].wave;
        if (pattern->wave == WAVE_POLY && at_expression(p))
            return parse_float(p, &pattern->exponent);
        return TAKEN;
    }
    return NOT_MINE;
}

/* A pattern's own settings live in memory that other pigments may share. */
static bool pattern_own_item(struct parser *p, struct pattern *pattern,
                             const struct field *field)
{
    size_t size = pattern->kind->size;
    void *parameters = arena_alloc(p->scene_arena, size);
    memcpy(parameters, pattern->parameters, size);
    pattern->parameters = parameters;
    if (!parse_field(p, field, parameters))
        return false;
    return pattern->kind != pattern_find("pavement") ||
           parse_pavement(p, pattern);
}

/* pattern_item = transformation | wave | warp | noise_generator
 *              | "turbulence" vector | "octaves" float | "omega" float
 *              | "lambda" float | "frequency" float | "phase" float
 *              | PATTERN_ITEM .
 * The last are the pattern's own: brick_size, agate_turb ... */
enum taken parse_pattern_item(struct parser *p, struct pattern *pattern)
{
    affine step = affine_identity();
    enum taken taken = parse_transformation(p, &step);
    if (taken == TAKEN)
        pattern_transform(pattern, &step);
    if (taken != NOT_MINE)
        return taken;
    if (stream_keyword(p) == KEYWORD_WARP)
        return parse_warp(p, pattern);
    if (stream_keyword(p) == KEYWORD_NOISE_GENERATOR)
        return parse_noise_generator(p, &pattern->generator);
    const struct field *field = accept_field(p, pattern_fields);
    if (field) {
        pattern->turbulent |= strcmp(field->name, "turbulence") == 0;
        if (!parse_field(p, field, pattern))
            return WRONG;
        int octaves = pattern->turbulence.octaves;
        pattern->turbulence.octaves = octaves < 1    ? 1
                                      : octaves > 10 ? 10
                                                     : octaves;
        return TAKEN;
    }
    if (pattern->kind)
        field = accept_field(p, pattern->kind->items);
    if (field)
        return pattern_own_item(p, pattern, field);
    return parse_wave(p, pattern);
}
