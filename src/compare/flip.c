/* LDR-FLIP after P. Andersson, J. Nilsson, T. Akenine-Moller, M. Oskarsson,
 * K. Astrom, M. Fairchild, "FLIP: A Difference Evaluator for Alternating
 * Images", Proc. ACM on Computer Graphics and Interactive Techniques 3(2),
 * 2020: the colour pipeline of section 4.1, the features of section 4.2, put
 * together as in section 4.3. Letters are the paper's. */
#include "compare/flip.h"

#include <math.h>

#include "base/vec.h"
#include "compare/opponent.h"

static const double PI = 3.14159265358979323846;

/* Section 4.1.3 and 4.1.4: q_c, p_c, p_t. Section 4.2: w, q_f. */
#define COLOUR_EXPONENT  0.7
#define COLOUR_KNEE      0.4
#define COLOUR_KNEE_TO   0.95
#define FEATURE_WIDTH    0.082
#define FEATURE_EXPONENT 0.5

/* What the colour pipeline keeps of a picture: filtered, then L*a*b*. */
struct flip_side {
    struct plane colour[3];
    struct plane edge, point;
};

/* ---- contrast sensitivity (section 4.1.1) ------------------------------ */

/* A channel's filter a1 sqrt(pi/b1) exp(-pi^2 x^2 / b1) + the same of a2, b2,
 * x in degrees: table 1. */
static const struct sensitivity {
    double a1, b1, a2, b2;
} sensitivities[3] = {
    { 1, 0.0047, 0, 0.00001 },
    { 1, 0.0053, 0, 0.00001 },
    { 34.1, 0.04, 13.5, 0.025 },
};

/* Deviation in pixels of exp(-pi^2 x^2 / b). */
static double flip_deviation(double b, double pixels_per_degree)
{
    return sqrt(b / (2 * PI * PI)) * pixels_per_degree;
}

/* The sum of a cut two-dimensional Gaussian, which kernel_gaussian makes 1. */
static double flip_weight(double a, double b, double deviation, int radius)
{
    double sum = 0;
    for (int i = -radius; i <= radius; i++)
        sum += exp(-i * i / (2 * deviation * deviation));
    return a * sqrt(PI / b) * sum * sum;
}

static void flip_blur(struct plane *plane, const struct sensitivity *s,
                      double pixels_per_degree)
{
    /* Three deviations of the widest filter, for all three channels. */
    int radius = (int)ceil(3 * flip_deviation(0.04, pixels_per_degree));
    double deviation = flip_deviation(s->b1, pixels_per_degree);
    struct kernel kernel = kernel_gaussian(deviation, radius);
    if (s->a2 == 0) {
        plane_convolve(plane, &kernel, &kernel, plane);
        return;
    }
    double deviation2 = flip_deviation(s->b2, pixels_per_degree);
    double first = flip_weight(s->a1, s->b1, deviation, radius);
    double second = flip_weight(s->a2, s->b2, deviation2, radius);
    double share = first / (first + second);
    struct plane other = plane_new(plane->width, plane->height);
    struct kernel kernel2 = kernel_gaussian(deviation2, radius);
    plane_convolve(plane, &kernel2, &kernel2, &other);
    plane_convolve(plane, &kernel, &kernel, plane);
    size_t pixels = (size_t)plane->width * (size_t)plane->height;
    for (size_t i = 0; i < pixels; i++)
        plane->values[i] = (float)(share * (double)plane->values[i] +
                                   (1 - share) * (double)other.values[i]);
    plane_free(&other);
}

/* ---- colour (sections 4.1.2 to 4.1.4) ---------------------------------- */

/* HyAB of two colours in Hunt-adjusted L*a*b*, to the power q_c. */
static double flip_distance(vec3 a, vec3 b)
{
    vec3 d = vec3_sub(a, b);
    return pow(fabs(d.x) + hypot(d.y, d.z), COLOUR_EXPONENT);
}

/* The largest distance, between pure green and pure blue. */
static double flip_distance_limit(void)
{
    return flip_distance(opponent_lab(vec3_make(0, 1, 0)),
                         opponent_lab(vec3_make(0, 0, 1)));
}

/* The lower part of the distances gets most of the range. */
static double flip_redistribute(double distance, double limit)
{
    double knee = COLOUR_KNEE * limit;
    if (distance < knee)
        return COLOUR_KNEE_TO / knee * distance;
    return COLOUR_KNEE_TO +
           (distance - knee) / (limit - knee) * (1 - COLOUR_KNEE_TO);
}

static vec3 flip_colour(const struct flip_side *side, size_t i)
{
    return vec3_make((double)side->colour[0].values[i],
                     (double)side->colour[1].values[i],
                     (double)side->colour[2].values[i]);
}

static void flip_set_colour(struct flip_side *side, size_t i, vec3 colour)
{
    side->colour[0].values[i] = (float)colour.x;
    side->colour[1].values[i] = (float)colour.y;
    side->colour[2].values[i] = (float)colour.z;
}

/* ---- features (section 4.2) -------------------------------------------- */

/* Scales the negative weights to a sum of -1, the positive ones to 1. */
static void flip_balance(struct kernel *kernel)
{
    double negative = 0, positive = 0;
    for (int i = 0; i <= 2 * kernel->radius; i++)
        *(kernel->weights[i] < 0 ? &negative : &positive) +=
            fabs(kernel->weights[i]);
    for (int i = 0; i <= 2 * kernel->radius; i++)
        kernel->weights[i] /= kernel->weights[i] < 0 ? negative : positive;
}

/* Lengths of what the kernel finds along x and along y. */
static struct plane flip_feature(const struct plane *grey,
                                 const struct kernel *across,
                                 const struct kernel *along)
{
    struct plane x = plane_new(grey->width, grey->height);
    struct plane y = plane_new(grey->width, grey->height);
    plane_convolve(grey, across, along, &x);
    plane_convolve(grey, along, across, &y);
    size_t pixels = (size_t)grey->width * (size_t)grey->height;
    for (size_t i = 0; i < pixels; i++)
        x.values[i] = hypotf(x.values[i], y.values[i]);
    plane_free(&y);
    return x;
}

/* Edges by a Gaussian's first derivative, points by its second. */
static void flip_find_features(struct flip_side *side, const struct plane *grey,
                               double pixels_per_degree)
{
    double deviation = 0.5 * FEATURE_WIDTH * pixels_per_degree;
    int radius = (int)ceil(3 * deviation);
    struct kernel along = kernel_gaussian(deviation, radius);
    struct kernel edge = along, point = along;
    for (int i = -radius; i <= radius; i++) {
        double x = i / deviation;
        edge.weights[i + radius] *= -x;
        point.weights[i + radius] *= x * x - 1;
    }
    flip_balance(&edge);
    flip_balance(&point);
    side->edge = flip_feature(grey, &edge, &along);
    side->point = flip_feature(grey, &point, &along);
}

static double flip_feature_difference(const struct flip_side *a,
                                      const struct flip_side *b, size_t i)
{
    double edge = fabs((double)a->edge.values[i] - (double)b->edge.values[i]);
    double point =
        fabs((double)a->point.values[i] - (double)b->point.values[i]);
    return pow(fmax(edge, point) / sqrt(2), FEATURE_EXPONENT);
}

/* ---- together ---------------------------------------------------------- */

static void flip_open(struct flip_side *side, const struct pair *pair,
                      int which, double pixels_per_degree)
{
    const struct image *image = pair->image[which];
    size_t pixels = (size_t)image->width * (size_t)image->height;
    for (int c = 0; c < 3; c++)
        side->colour[c] = plane_new(image->width, image->height);
    struct plane grey = plane_new(image->width, image->height);
    for (size_t i = 0; i < pixels; i++) {
        const float *pixel = image->pixels + 4 * i;
        vec3 light = vec3_make(pair_light(pair, (double)pixel[0]),
                               pair_light(pair, (double)pixel[1]),
                               pair_light(pair, (double)pixel[2]));
        vec3 colour = opponent_from_light(light);
        flip_set_colour(side, i, colour);
        grey.values[i] = (float)((colour.x + 16) / 116);
    }
    flip_find_features(side, &grey, pixels_per_degree);
    plane_free(&grey);
    for (int c = 0; c < 3; c++)
        flip_blur(&side->colour[c], &sensitivities[c], pixels_per_degree);
    for (size_t i = 0; i < pixels; i++) {
        vec3 light = opponent_to_light(flip_colour(side, i));
        flip_set_colour(side, i, opponent_lab(light));
    }
}

static void flip_close(struct flip_side *side)
{
    for (int c = 0; c < 3; c++)
        plane_free(&side->colour[c]);
    plane_free(&side->edge);
    plane_free(&side->point);
}

struct plane flip_map(const struct pair *pair, double pixels_per_degree)
{
    struct flip_side a, b;
    flip_open(&a, pair, 0, pixels_per_degree);
    flip_open(&b, pair, 1, pixels_per_degree);
    struct plane map = plane_new(pair->image[0]->width, pair->image[0]->height);
    size_t pixels = (size_t)map.width * (size_t)map.height;
    double limit = flip_distance_limit();
    for (size_t i = 0; i < pixels; i++) {
        double colour = flip_redistribute(
            flip_distance(flip_colour(&a, i), flip_colour(&b, i)), limit);
        double feature = flip_feature_difference(&a, &b, i);
        map.values[i] = (float)pow(colour, 1 - feature);
    }
    flip_close(&a);
    flip_close(&b);
    return map;
}
