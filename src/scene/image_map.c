/* Image maps: where on a picture a point of space falls, and the colour there.
 * All conventions were measured with POV-Ray 3.7 on pictures of 4 x 4 pixels:
 * u runs right and v up, both from 0 to 1 over the picture; pixel i has its
 * centre at i + 1/2. */
#include "scene/image_map.h"

#include "image/image.h"

/* A place on the picture; `valid` is false outside a map used once. */
struct place {
    double u, v;
    bool valid;
};

/* Measured: a place that is short of the edge of a pixel by less than that, in
 * pixels, is in the next one. So the sides of a box, on which rounding decides
 * which side of the picture's edge a point is, have one colour. */
static const double edge_share = 1e-10;

static double fraction(double x)
{
    double t = x - floor(x);
    return t < 1 ? t : 0; /* also for a tiny negative x, and NaN */
}

/* Longitude, 0 at +x and growing towards +z. */
static double longitude(vec3 point)
{
    return fraction(atan2(point.z, point.x) / (2 * M_PI));
}

static struct place place_planar(const struct image_map *map, vec3 p)
{
    bool inside = p.x >= 0 && p.x <= 1 && p.y >= 0 && p.y <= 1;
    return (struct place){ fraction(p.x), fraction(p.y), inside || !map->once };
}

/* A sphere's latitude from pole to pole. */
static struct place place_spherical(const struct image_map *map, vec3 p)
{
    double radius = sqrt(p.x * p.x + p.z * p.z);
    double v = 0.5 + atan2(p.y, radius) / M_PI;
    bool inside = radius > 0 || p.y < 0;
    return (struct place){ longitude(p), fmin(v, 0x1.fffffffffffffp-1),
                           inside || !map->once };
}

static struct place place_cylindrical(const struct image_map *map, vec3 p)
{
    bool inside = p.y >= 0 && p.y <= 1;
    return (struct place){ longitude(p), fraction(p.y), inside || !map->once };
}

/* Around a torus of major radius 1; the seam is inside. */
static struct place place_torus(vec3 p)
{
    double radius = sqrt(p.x * p.x + p.z * p.z);
    double v = 0.5 + atan2(p.y, radius - 1) / (2 * M_PI);
    return (struct place){ longitude(p), fraction(v), true };
}

static struct place image_place(const struct image_map *map, vec3 point)
{
    if (!vec3_finite(point))
        return (struct place){ 0, 0, false };
    switch (map->projection) {
    case IMAGE_PLANAR:
        break;
    case IMAGE_SPHERICAL:
        return place_spherical(map, point);
    case IMAGE_CYLINDRICAL:
        return place_cylindrical(map, point);
    case IMAGE_TORUS:
        return place_torus(point);
    }
    return place_planar(map, point);
}

/* Beyond the edges: another period, or, used once, the edge itself. */
static int image_wrap(const struct image_map *map, int i, int count)
{
    if (i >= 0 && i < count)
        return i;
    if (map->once)
        return i < 0 ? 0 : count - 1;
    return ((i % count) + count) % count;
}

/* Puts in what the pixel's own entry of the palette says. */
static colour texel_clear(const struct image_map *map, int x, int y, colour c)
{
    const struct image *numbers = map->numbers;
    int entry = (int)image_pixel(numbers, x, numbers->height - 1 - y)[0];
    if (entry < 0 || entry >= PALETTE_ENTRIES)
        return c;
    const struct entry_clear *clear = &map->clear[entry];
    c.filter = isnan(clear->filter) ? c.filter : clear->filter;
    c.transmit = isnan(clear->transmit) ? c.transmit : clear->transmit;
    return c;
}

/* Whether neighbours are mixed premultiplied (measured: as the file is). */
static bool image_mixes(const struct image_map *map)
{
    return map->image->multiplied && !map->no_alpha && !map->clear;
}

/* The pixel in column x, row y from the bottom, as a pigment; premultiplied if
 * so are mixed. */
static colour image_texel(const struct image_map *map, int x, int y)
{
    const struct image *image = map->image;
    x = image_wrap(map, x, image->width);
    y = image_wrap(map, y, image->height);
    const float *p = image_pixel(image, x, image->height - 1 - y);
    double alpha = (double)p[3];
    bool divide = image->multiplied && !image_mixes(map);
    double scale = divide && alpha > 0 && alpha < 1 ? 1 / alpha : 1;
    colour c = { (double)p[0] * scale, (double)p[1] * scale,
                 (double)p[2] * scale, map->filter_all,
                 map->transmit_all + (map->no_alpha ? 0 : 1 - alpha) };
    return map->clear ? texel_clear(map, x, y, c) : c;
}

static colour colour_add_scaled(colour sum, colour c, double weight)
{
    return (colour){ sum.r + weight * c.r, sum.g + weight * c.g,
                     sum.b + weight * c.b, sum.filter + weight * c.filter,
                     sum.transmit + weight * c.transmit };
}

/* A mean of the four pixels around (x, y), in pixels: by area, or by the
 * square of the distance to their centres. */
static colour image_blend(const struct image_map *map, double x, double y)
{
    int left = (int)floor(x - 0.5), low = (int)floor(y - 0.5);
    double s = x - 0.5 - left, t = y - 0.5 - low;
    colour sum = { 0 };
    double total = 0;
    for (int j = 0; j < 2; j++) {
        for (int i = 0; i < 2; i++) {
            double dx = i ? 1 - s : s, dy = j ? 1 - t : t;
            double weight = (1 - dx) * (1 - dy);
            colour c = image_texel(map, left + i, low + j);
            if (map->interpolation == IMAGE_NORMALISED_DISTANCE) {
                double square = dx * dx + dy * dy;
                if (square == 0)
                    return c;
                weight = 1 / square;
            }
            sum = colour_add_scaled(sum, c, weight);
            total += weight;
        }
    }
    return colour_add_scaled((colour){ 0 }, sum, 1 / total);
}

/* Catmull and Rom's spline: the weight of a pixel that far away. */
static double image_cubic(double distance)
{
    double d = fabs(distance);
    if (d >= 2)
        return 0;
    return d < 1 ? 1 + d * d * (1.5 * d - 2.5)
                 : 2 + d * (-4 + d * (2.5 - 0.5 * d));
}

/* Of the 16 pixels around (x, y), in pixels. */
static colour image_bicubic(const struct image_map *map, double x, double y)
{
    int left = (int)floor(x - 0.5) - 1, low = (int)floor(y - 0.5) - 1;
    colour sum = { 0 };
    for (int j = low; j < low + 4; j++) {
        double row = image_cubic(y - 0.5 - j);
        for (int i = left; i < left + 4; i++)
            sum = colour_add_scaled(sum, image_texel(map, i, j),
                                    row * image_cubic(x - 0.5 - i));
    }
    return sum;
}

static colour image_sample(const struct image_map *map, double x, double y)
{
    switch (map->interpolation) {
    case IMAGE_NEAREST:
        return image_texel(map, (int)x, (int)y);
    case IMAGE_BICUBIC:
        return image_bicubic(map, x, y);
    case IMAGE_BILINEAR:
    case IMAGE_NORMALISED_DISTANCE:
        break;
    }
    return image_blend(map, x, y);
}

/* At (x, y), in pixels: on the picture. `transmit all` leaves premultiplied
 * colours as strong as they are (measured). */
static colour image_at(const struct image_map *map, double x, double y)
{
    colour c = image_sample(map, x, y);
    double alpha = 1 - c.transmit;
    if (!image_mixes(map) || !(alpha > 0))
        return c;
    return (colour){ c.r / alpha, c.g / alpha, c.b / alpha, c.filter,
                     c.transmit };
}

/* Into pixels, which are from 0 up to their number. What is beyond the edge is
 * in another period, unless it is at a pole: not on a map used once (measured).
 */
static bool image_along(const struct image_map *map, int pixels, bool poles,
                        double *share)
{
    double at = *share * pixels, next = at + edge_share;
    bool beyond = next >= pixels;
    if (beyond && poles)
        *share = at;
    else
        *share = beyond ? next - pixels : next;
    return !beyond || poles || !map->once;
}

colour image_map_colour(const struct image_map *map, vec3 point)
{
    const struct image *image = map->image;
    struct place place = image_place(map, point);
    bool poles = map->projection == IMAGE_SPHERICAL;
    if (!place.valid || !image || image->width < 1 || image->height < 1 ||
        !image_along(map, image->width, false, &place.u) ||
        !image_along(map, image->height, poles, &place.v))
        return (colour){ 1, 1, 1, 0, 1 };
    return image_at(map, place.u, place.v);
}

static double image_grey(const struct image_map *map, double x, double y)
{
    const struct image *image = map->image;
    x -= image->width * floor(x / image->width);
    y -= image->height * floor(y / image->height);
    colour c = image_at(map, x, y);
    return grey_of(c.r, c.g, c.b);
}

/* Measured: from the heights at the pixel and at those left and right of the
 * one below, whatever the size of a pixel is; as if the picture stood upright
 * on the surface there. */
vec3 image_map_tilt(const struct image_map *map, vec3 point, vec3 normal)
{
    const struct image *image = map->image;
    struct place place = image_place(map, point);
    if (!place.valid || !image || image->width < 1 || image->height < 1)
        return vec3_make(0, 0, 0);
    double x = place.u * image->width, y = place.v * image->height;
    double here = image_grey(map, x, y);
    double left = image_grey(map, x - 1, y - 1);
    double right = image_grey(map, x + 1, y - 1);
    vec3 across = vec3_cross(normal, vec3_make(0, 1, 0));
    double length = vec3_length(across);
    across =
        length > 1e-6 ? vec3_scale(across, 1 / length) : vec3_make(1, 0, 0);
    vec3 tilt = vec3_scale(across, (left - right) / 2);
    return vec3_along(tilt, vec3_cross(across, normal),
                      (left + right) / 2 - here);
}

bool image_map_is_opaque(const struct image_map *map)
{
    const struct image *image = map->image;
    if (map->once || map->filter_all != 0 || map->transmit_all != 0 ||
        map->clear || !image)
        return false;
    size_t count = (size_t)image->width * (size_t)image->height;
    for (size_t i = 0; i < count; i++)
        if (image->pixels[4 * i + 3] < 1)
            return false;
    return true;
}
