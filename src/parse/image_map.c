/* Images as pigments: the file is read at once and brought into the scene's
 * working space, so that a missing one is reported where it is named. */
#include "parse/rules.h"
#include "parse/tables.h"

#include "base/text.h"

#include "image/file.h"
#include "image/tone.h"

/* Whether the file's colours are premultiplied by its alpha. */
enum image_multiplied { BY_KIND, MULTIPLIED, NOT_MULTIPLIED };

/* Images already read in this parse: a loop may name one a thousand times. */
struct image_cache {
    struct image_cache *next;
    const char *path;
    enum gamma_kind space;
    double assumed_gamma, file_gamma;
    enum image_multiplied multiplied;
    bool bumps, numbers;
    struct image *image;
};

/* What is said in an image_map about the file. */
struct image_request {
    const char *name, *type; /* NULL: not said */
    struct span span;
    double gamma; /* of the file's numbers; 0: sRGB, -1: not said */
    enum image_multiplied multiplied;
    bool numbers;      /* of a palette's entries, not their colours */
    double *bump_size; /* of a bump_map, where numbers are no light; NULL */
    bool pattern;      /* it is an image_pattern's */
    struct image_map *map;
};

const struct field image_fields[] = {
    { .name = "map_type" },      { .name = "once" },
    { .name = "interpolate" },   { .name = "filter" },
    { .name = "transmit" },      { .name = "gamma" },
    { .name = "premultiplied" }, { .name = NULL },
};

const struct field image_pattern_fields[] = {
    { .name = "map_type" },      { .name = "once" },
    { .name = "interpolate" },   { .name = "gamma" },
    { .name = "premultiplied" }, { .name = "use_colour" },
    { .name = "use_alpha" },     { .name = NULL },
};

const struct field bump_fields[] = {
    { .name = "bump_size" }, { .name = "use_colour" },  { .name = "use_index" },
    { .name = "map_type" },  { .name = "interpolate" }, { .name = "once" },
    { .name = "gamma" },     { .name = NULL },
};

/* How a file's numbers become the scene's (measured; tests/povray.md, section
 * 5.9). */
struct image_decoding {
    bool plain;      /* not at all */
    bool index;      /* they count a palette's entries */
    bool multiplied; /* light times alpha: in a file that is so */
    bool linear;     /* they are light */
    bool whole; /* decoded with alpha in them, as by POV-Ray: light files whose
                 * gamma is said */
    double gamma;                /* light is their power; 0: sRGB */
    const struct image *numbers; /* of no colour, but decoded as is said */
    double working; /* the scene counts light^(1/working); 0: in sRGB */
};

/* Whether the file's numbers are the scene's as they are: before version 3.7
 * all that don't tell their gamma; without assumed_gamma all. */
static bool image_is_plain(const struct parser *p, const struct image *image)
{
    bool old = !p->version_said || p->version < 3.7;
    bool untold = !image->linear && !(image->gamma > 0) && !image->srgb;
    return settings_gamma(p) == GAMMA_NONE || image->plain || (old && untold);
}

/* Whether its numbers are no light. */
static bool image_is_numbers(const struct image_request *request)
{
    return request->bump_size || request->pattern;
}

static struct image_decoding image_decoding(const struct parser *p,
                                            const struct image *image,
                                            const struct image_request *request)
{
    double said = request->gamma;
    enum gamma_kind space = settings_gamma(p);
    bool numbers = image_is_numbers(request);
    return (struct image_decoding){
        .index = image->indexed,
        .plain = said < 0 && (numbers || image_is_plain(p, image)),
        .multiplied = image->multiplied && !numbers &&
                      request->multiplied != NOT_MULTIPLIED,
        .linear = image->linear && said < 0,
        .whole = image->linear && said >= 0,
        .gamma = said >= 0 ? said : image->gamma,
        .numbers = numbers ? image : NULL,
        .working = space == GAMMA_SRGB ? 0 : p->scene->settings.assumed_gamma,
    };
}

static double light_of(double gamma, double value)
{
    return gamma > 0 ? pow(fmax(value, 0), gamma) : tone_srgb_decode(value);
}

double image_number(const struct image *image, double gamma, double value)
{
    const double rounding = 1e-6;
    double light = light_of(gamma, value);
    bool bytes = image->png && image->channels == 1 && image->bits == 8;
    return bytes ? floor(light * 255 + rounding) / 255 : light;
}

static double image_decode(const struct image_decoding *how, double value)
{
    if (how->index)
        return value * 255;
    if (how->plain)
        return value;
    if (how->numbers)
        return image_number(how->numbers, how->gamma, value);
    double light = how->linear ? value : light_of(how->gamma, value);
    return how->working == 1   ? light
           : how->working == 0 ? tone_srgb_encode(light)
                               : pow(fmax(light, 0), 1 / how->working);
}

/* Neighbours are often alike: a number is not decoded twice in a row. */
static void image_convert(const struct image_decoding *how, struct image *image)
{
    float last = 0, decoded = (float)image_decode(how, 0);
    size_t count = (size_t)image->width * (size_t)image->height;
    for (size_t i = 0; i < count; i++) {
        float *pixel = image->pixels + 4 * i;
        bool divide = how->multiplied && !how->whole && pixel[3] > 0;
        float alpha = divide ? pixel[3] : 1;
        for (int k = 0; k < 3; k++) {
            float value = pixel[k] / alpha;
            if (value != last)
                decoded = (float)image_decode(how, (double)value);
            last = value;
            pixel[k] = decoded * alpha;
        }
    }
}

/* The image with its pixels in the scene's arena; NULL if that is full. */
static struct image *image_keep(struct parser *p, const struct image *image)
{
    size_t count = (size_t)image->width * (size_t)image->height * 4;
    size_t limit = arena_limit(p->scene_arena);
    size_t used = arena_used(p->scene_arena);
    if (limit && (used > limit || count * sizeof(float) > limit - used))
        return NULL;
    struct image *kept = ARENA_NEW(p->scene_arena, struct image);
    *kept = *image;
    kept->pixels = ARENA_ARRAY(p->scene_arena, float, count);
    memcpy(kept->pixels, image->pixels, count * sizeof(float));
    return kept;
}

static struct image *image_load(struct parser *p, const char *path,
                                const struct image_request *request)
{
    char problem[256] = "";
    struct image *image =
        image_read_raw(path, request->numbers, problem, sizeof problem);
    if (!image) {
        error_at(p, request->span, NULL, "can't read the image '%s': %s", path,
                 problem);
        return NULL;
    }
    struct image *kept = image_keep(p, image);
    image_free(image);
    if (!kept) {
        error_at(p, request->span, NULL,
                 "with the image '%s' the scene needs more memory than the "
                 "limit of %zu MiB",
                 path, arena_limit(p->scene_arena) >> 20);
        return NULL;
    }
    struct image_decoding how = image_decoding(p, kept, request);
    image_convert(&how, kept);
    /* What is said to be premultiplied, if the file is not, is taken for it
     * once its numbers are light. */
    bool said = request->multiplied == MULTIPLIED && kept->has_alpha;
    kept->multiplied = how.multiplied || (said && !image_is_numbers(request));
    return kept;
}

static struct image *image_find(struct parser *p, const char *path,
                                const struct image_request *request)
{
    enum gamma_kind space = settings_gamma(p);
    double assumed = p->scene->settings.assumed_gamma;
    for (struct image_cache *c = p->images; c; c = c->next)
        if (strcmp(c->path, path) == 0 && c->space == space &&
            c->assumed_gamma == assumed && c->file_gamma == request->gamma &&
            c->multiplied == request->multiplied &&
            c->bumps == image_is_numbers(request) &&
            c->numbers == request->numbers)
            return c->image;
    struct image *image = image_load(p, path, request);
    if (!image)
        return NULL;
    struct image_cache *cache = ARENA_NEW(p->arena, struct image_cache);
    *cache = (struct image_cache){
        .next = p->images,
        .path = path,
        .space = space,
        .assumed_gamma = assumed,
        .file_gamma = request->gamma,
        .multiplied = request->multiplied,
        .bumps = image_is_numbers(request),
        .numbers = request->numbers,
        .image = image,
    };
    p->images = cache;
    return image;
}

static bool image_open(struct parser *p, const struct image_request *request)
{
    const char *path =
        file_checked(p, request->span, "image", request->name,
                     image_file(p, request->name, request->type));
    if (!path)
        return false;
    request->map->image = image_find(p, path, request);
    request->map->no_alpha &=
        request->map->image && request->map->image->palette;
    if (!request->map->image || !request->map->clear)
        return request->map->image != NULL;
    struct image_request numbers = *request;
    numbers.numbers = true;
    request->map->numbers = image_find(p, path, &numbers);
    return request->map->numbers &&
           (request->map->numbers->indexed ||
            error_at(p, request->span, NULL,
                     "the image '%s' has no palette; say 'filter all' or "
                     "'transmit all'",
                     request->name));
}

static bool image_type_unknown(struct parser *p, const struct field *types)
{
    const char *word = stream_peek(p)->word->text, *list = types->name;
    struct text_nearest nearest = text_nearest_start(word);
    for (const struct field *type = types; type->name; type++) {
        text_nearest_try(&nearest, type->name);
        if (type > types)
            list = arena_printf(p->arena, "%s%s%s", list,
                                type[1].name ? ", " : " and ", type->name);
    }
    return error_at(p, stream_span(p), nearest.best,
                    "there is no image format '%s'; there are %s", word, list);
}

/* What a file's name may lack, by its type. */
static const struct image_ending {
    const char *type, *ending;
} image_endings[] = {
    { "gif", ".gif" },   { "gif", ".GIF" },   { "tga", ".tga" },
    { "tga", ".TGA" },   { "iff", ".iff" },   { "iff", ".IFF" },
    { "ppm", ".ppm" },   { "ppm", ".PPM" },   { "pgm", ".pgm" },
    { "pgm", ".PGM" },   { "png", ".png" },   { "png", ".PNG" },
    { "jpeg", ".jpg" },  { "jpeg", ".JPG" },  { "jpeg", ".jpeg" },
    { "jpeg", ".JPEG" }, { "tiff", ".tif" },  { "tiff", ".TIF" },
    { "tiff", ".tiff" }, { "tiff", ".TIFF" }, { "exr", ".exr" },
    { "exr", ".EXR" },   { "hdr", ".hdr" },   { "hdr", ".HDR" },
    { "bmp", ".bmp" },   { "bmp", ".BMP" },   { "pot", ".pot" },
    { "pot", ".POT" },
};

const char *image_file(struct parser *p, const char *name, const char *type)
{
    const char *path = file_locate(p, name, NULL);
    size_t count = sizeof image_endings / sizeof *image_endings;
    for (size_t i = 0; !path && i < count; i++)
        if (!type || strcmp(image_endings[i].type, type) == 0)
            path = file_locate(p, name, image_endings[i].ending);
    return path;
}

/* image_type = "gif" | "tga" | "iff" | "ppm" | "pgm" | "png" | "jpeg" | "tiff"
 *            | "sys" | "exr" | "hdr" | "bmp" .
 * The file itself tells its type better. */
bool parse_image_type(struct parser *p, const char **found)
{
    static const struct field types[] = {
        { .name = "gif" },  { .name = "tga" },  { .name = "iff" },
        { .name = "ppm" },  { .name = "pgm" },  { .name = "png" },
        { .name = "jpeg" }, { .name = "tiff" }, { .name = "sys" },
        { .name = "exr" },  { .name = "hdr" },  { .name = "bmp" },
        { .name = NULL },
    };
    size_t left;
    *found = NULL;
    for (const struct field *type = types; type->name; type++)
        if (accept_word(p, type->name)) {
            *found = type->name;
            return true;
        }
    bool wrong = stream_peek(p)->kind == TOKEN_WORD && !at_expression(p) &&
                 stream_raw(p, &left)->kind == TOKEN_STRING;
    return !wrong || image_type_unknown(p, types);
}

/* map_type = "map_type" float . */
static bool parse_map_type(struct parser *p, struct image_map *map)
{
    int type;
    stream_next(p);
    struct span span = stream_span(p);
    if (!parse_integer(p, &type))
        return false;
    if (type != IMAGE_PLANAR && type != IMAGE_SPHERICAL &&
        type != IMAGE_CYLINDRICAL && type != IMAGE_TORUS)
        return error_at(p, span, NULL,
                        "map_type is 0 (flat), 1 (sphere), 2 (cylinder) or "
                        "5 (torus)");
    map->projection = (enum image_projection)type;
    return true;
}

/* interpolation = "interpolate" float . */
static bool parse_interpolation(struct parser *p, struct image_map *map)
{
    int kind;
    stream_next(p);
    struct span span = stream_span(p);
    if (!parse_integer(p, &kind))
        return false;
    if (kind != IMAGE_NEAREST && kind != IMAGE_BILINEAR &&
        kind != IMAGE_BICUBIC && kind != IMAGE_NORMALISED_DISTANCE)
        return error_at(p, span, "2",
                        "interpolate is 0 (none), 2 (bilinear), 3 (bicubic) or "
                        "4 (normalised distance)");
    map->interpolation = (enum image_interpolation)kind;
    return true;
}

static struct entry_clear *entry_clear(struct parser *p, struct image_map *map,
                                       int entry)
{
    if (!map->clear) {
        map->clear =
            ARENA_ARRAY(p->scene_arena, struct entry_clear, PALETTE_ENTRIES);
        for (int i = 0; i < PALETTE_ENTRIES; i++)
            map->clear[i] = (struct entry_clear){ (double)NAN, (double)NAN };
    }
    return &map->clear[entry];
}

/* What entries have is forgotten (measured), and the palette's own alpha. */
static bool parse_filter_all(struct parser *p, struct image_map *map,
                             bool filter)
{
    for (int i = 0; map->clear && i < PALETTE_ENTRIES; i++)
        *(filter ? &map->clear[i].filter : &map->clear[i].transmit) =
            (double)NAN;
    map->no_alpha |= !filter;
    return parse_float(p, filter ? &map->filter_all : &map->transmit_all);
}

/* image_filter = ( "filter" | "transmit" ) ( "all" | float [","] ) float .
 * Of all pixels, or of those with this entry of the palette. */
static bool parse_image_filter(struct parser *p, struct image_map *map)
{
    bool filter = stream_next(p).word->keyword == KEYWORD_FILTER;
    int entry;
    if (accept_keyword(p, KEYWORD_ALL))
        return parse_filter_all(p, map, filter);
    struct span span = stream_span(p);
    if (!parse_integer(p, &entry))
        return false;
    accept(p, TOKEN_COMMA);
    if (entry < 0 || entry >= PALETTE_ENTRIES)
        return error_at(p, span, NULL,
                        "a palette has entries 0 to %d, found %d",
                        PALETTE_ENTRIES - 1, entry);
    struct entry_clear *clear = entry_clear(p, map, entry);
    return parse_float(p, filter ? &clear->filter : &clear->transmit);
}

/* image_gamma = "gamma" ( "srgb" | float ) . */
bool parse_image_gamma(struct parser *p, double *gamma)
{
    stream_next(p);
    *gamma = 0;
    if (accept_keyword(p, KEYWORD_SRGB))
        return true;
    struct span span = stream_span(p);
    if (!parse_float(p, gamma))
        return false;
    return *gamma > 0 || error_at(p, span, "2.2", "gamma must be above 0");
}

/* bump_item = "bump_size" float | "use_colour" | "use_index" . */
static bool parse_bump_item(struct parser *p, struct image_request *request)
{
    if (accept_keyword(p, KEYWORD_USE_COLOUR))
        return true;
    if (accept_keyword(p, KEYWORD_USE_INDEX))
        return request->numbers = true;
    stream_next(p);
    return parse_float(p, request->bump_size);
}

/* pattern_item_of_image = "use_colour" | "use_alpha" . */
static bool parse_pattern_item_of_image(struct parser *p, struct image_map *map)
{
    map->use_alpha = stream_next(p).word->keyword == KEYWORD_USE_ALPHA;
    return true;
}

/* image_multiplied = "premultiplied" [bool] . */
static bool parse_multiplied(struct parser *p, struct image_request *request)
{
    bool on;
    stream_next(p);
    if (!parse_bool(p, &on))
        return false;
    request->multiplied = on ? MULTIPLIED : NOT_MULTIPLIED;
    return true;
}

/* What may stand in this block. */
static bool image_unknown(struct parser *p, const struct image_request *request)
{
    if (request->pattern)
        return error_unknown_item(p, "image_pattern", image_pattern_fields);
    return error_unknown_item(p, request->bump_size ? "bump_map" : "image_map",
                              request->bump_size ? bump_fields : image_fields);
}

/* image_item = map_type | "once" | interpolation | image_filter
 *            | image_gamma | image_multiplied | bump_item
 *            | pattern_item_of_image . */
static bool parse_image_item(struct parser *p, struct image_request *request)
{
    switch (stream_keyword(p)) {
    case KEYWORD_MAP_TYPE:
        return parse_map_type(p, request->map);
    case KEYWORD_ONCE:
        stream_next(p);
        request->map->once = true;
        return true;
    case KEYWORD_INTERPOLATE:
        return parse_interpolation(p, request->map);
    case KEYWORD_FILTER:
    case KEYWORD_TRANSMIT:
        return parse_image_filter(p, request->map);
    case KEYWORD_GAMMA:
        return parse_image_gamma(p, &request->gamma);
    case KEYWORD_PREMULTIPLIED:
        return parse_multiplied(p, request);
    case KEYWORD_BUMP_SIZE:
    case KEYWORD_USE_COLOUR:
    case KEYWORD_USE_INDEX:
    case KEYWORD_USE_ALPHA:
        if (request->pattern)
            return parse_pattern_item_of_image(p, request->map);
        if (request->bump_size)
            return parse_bump_item(p, request);
        if (stream_keyword(p) == KEYWORD_USE_INDEX ||
            stream_keyword(p) == KEYWORD_USE_COLOUR) {
            stream_next(p); /* without effect, as in POV-Ray */
            return true;
        }
        /* fallthrough */
    default:
        return image_unknown(p, request);
    }
}

/* The vector of old scenes has no effect (measured).
 * image_source = [vector [","]] ( [image_type] string | function_image ) . */
static bool parse_image_source(struct parser *p, struct image_request *request)
{
    vec3 ignored;
    if (stream_peek(p)->kind == TOKEN_LESS && !parse_vector(p, &ignored))
        return false;
    accept(p, TOKEN_COMMA);
    if (stream_keyword(p) == KEYWORD_FUNCTION)
        return parse_image_of_function(p, &request->map->image);
    if (!parse_image_type(p, &request->type))
        return false;
    request->span = stream_span(p);
    if (!parse_string(p, &request->name))
        return false;
    request->span = span_join(request->span, p->last_span);
    return true;
}

static bool image_items(struct parser *p, struct image_request *request)
{
    if (!parse_image_source(p, request))
        return false;
    while (stream_peek(p)->kind != TOKEN_RBRACE) {
        accept(p, TOKEN_COMMA);
        if (!parse_image_item(p, request))
            return false;
    }
    return request->map->image || image_open(p, request);
}

bool parse_material_image(struct parser *p, const struct image_map **out)
{
    struct image_map *map = ARENA_NEW(p->scene_arena, struct image_map);
    struct image_request request = {
        .gamma = -1, .map = map, .pattern = true, .numbers = true
    };
    *out = map;
    if (!parse_image_source(p, &request))
        return false;
    for (;;) {
        accept(p, TOKEN_COMMA);
        if (at_body_end(p) || stream_keyword(p) == KEYWORD_TEXTURE)
            break;
        if (!parse_image_item(p, &request))
            return false;
    }
    return request.map->image || image_open(p, &request);
}

/* image_map = "image_map" "{" image_source {[","] image_item} "}" . */
bool parse_image_map(struct parser *p, const struct image_map **out)
{
    struct image_map *map = ARENA_NEW(p->scene_arena, struct image_map);
    struct image_request request = { .gamma = -1, .map = map };
    struct span open;
    *out = map;
    stream_next(p);
    return block_begin(p, &open) &&
           block_end(p, open, image_items(p, &request));
}

/* bump_map = "bump_map" "{" image_source {[","] image_item} "}" . */
bool parse_bump_map(struct parser *p, const struct image_map **out,
                    double *bump_size)
{
    struct image_map *map = ARENA_NEW(p->scene_arena, struct image_map);
    struct image_request request = { .gamma = -1,
                                     .map = map,
                                     .bump_size = bump_size };
    struct span open;
    *out = map;
    stream_next(p);
    return block_begin(p, &open) &&
           block_end(p, open, image_items(p, &request));
}

/* image_pattern = "image_pattern" "{" image_source {[","] image_item} "}" . */
bool parse_image_pattern(struct parser *p, const struct image_map **out)
{
    struct image_map *map = ARENA_NEW(p->scene_arena, struct image_map);
    struct image_request request = { .gamma = -1, .map = map, .pattern = true };
    struct span open;
    *out = map;
    stream_next(p);
    return block_begin(p, &open) &&
           block_end(p, open, image_items(p, &request));
}
