/* Julia sets of squares and cubes, quickly: see julia_fate.h. Distances are by
 * J. Hart, D. Sandin and L. Kauffman, "Ray Tracing Deterministic 3-D Fractals"
 * (SIGGRAPH 1989): |z| ln |z| / (2 |z'|) is no more than the distance from the
 * set that stays for ever. That of a certain number of steps reaches farther,
 * by its own potential: ln |z| shrinks to that of its surface. */
#include "scene/julia_fate.h"

#include "scene/julia_orbit.h"

/* Of all that stays a ray goes at most so much of the radius at a time: an
 * estimate by derivatives knows nothing of what is farther. */
static const double fate_cap = 0.02;

/* The size that ends an orbit, squared: its logarithm is then the potential. */
static const double fate_far = 1e4;

/* What has become of a point after `steps` steps: its size and the length of
 * its derivative, both squared. */
struct flight {
    double size2, growth2;
    int steps;
    bool gone; /* out of the radius that a step allows, once */
};

static double flight_distance(const struct julia_fractal *f,
                              const struct flight *flight)
{
    double height = 0.5 * log(flight->size2);
    double potential = f->potentials[flight->steps];
    return height > potential ? 0.5 * (1 - potential / height) * height *
                                    sqrt(flight->size2 / flight->growth2)
                              : 0;
}

/* Whether all is known with this step: it is far away, or the last step has
 * not left, or it has, and went on for long enough. */
static bool flight_ends(const struct julia_fractal *f, struct flight *flight,
                        double size2, int steps)
{
    int last = f->iterations - 1;
    flight->size2 = size2;
    flight->steps = steps;
    flight->gone = flight->gone || size2 > f->limits[steps] * f->limits[steps];
    return size2 > fate_far || (steps >= last && !flight->gone) ||
           steps == last + JULIA_MORE;
}

static struct flight square_flight(const struct julia_fractal *f, vec3 p)
{
    double x = p.x, y = p.y, z = p.z;
    double w = f->w[0] * x + f->w[1] * y + f->w[2] * z + f->w[3];
    struct flight fl = { .growth2 = 1 };
    for (int i = 0;; i++) {
        double rest = y * y + z * z + w * w, twice = 2 * x;
        if (flight_ends(f, &fl, x * x + rest, i))
            return fl;
        fl.growth2 *= 4 * fl.size2;
        x = x * x - rest + f->c[0];
        y = twice * y + f->c[1];
        z = twice * z + f->c[2];
        w = twice * w + f->c[3];
    }
}

static struct flight cube_flight(const struct julia_fractal *f, vec3 p)
{
    double x = p.x, y = p.y, z = p.z;
    double w = f->w[0] * x + f->w[1] * y + f->w[2] * z + f->w[3];
    struct flight fl = { .growth2 = 1 };
    for (int i = 0;; i++) {
        double rest = y * y + z * z + w * w, real = x * x;
        double factor = 3 * real - rest;
        if (flight_ends(f, &fl, real + rest, i))
            return fl;
        fl.growth2 *= 9 * fl.size2 * fl.size2;
        x = x * (real - 3 * rest) + f->c[0];
        y = factor * y + f->c[1];
        z = factor * z + f->c[2];
        w = factor * w + f->c[3];
    }
}

static void fate_quaternion(const struct julia_fractal *f, vec3 point,
                            struct julia_fate *fate)
{
    struct flight fl =
        f->cube ? cube_flight(f, point) : square_flight(f, point);
    fate->gone = fl.gone;
    if (fate->gone) {
        fate->distance = flight_distance(f, &fl);
        return;
    }
    double room = f->radius - sqrt(fl.size2);
    fate->distance = fmin(0.5 * room / sqrt(fl.growth2), fate_cap * f->radius);
}

/* The two complex numbers that a hypercomplex one is: what stays does so in
 * both. */
struct twins {
    double x[2], y[2], growth2[2];
};

static double twin_distance(const struct julia_fractal *f,
                            const struct twins *twins, int i, int steps)
{
    struct flight fl = { .size2 = twins->x[i] * twins->x[i] +
                                  twins->y[i] * twins->y[i],
                         .growth2 = twins->growth2[i],
                         .steps = steps };
    return flight_distance(f, &fl);
}

static void fate_hypercomplex(const struct julia_fractal *f, vec3 p,
                              struct julia_fate *fate)
{
    double w = f->w[0] * p.x + f->w[1] * p.y + f->w[2] * p.z + f->w[3];
    struct twins t = { { p.x - w, p.x + w },
                       { p.y + p.z, p.y - p.z },
                       { 1, 1 } };
    const double cx[2] = { f->c[0] - f->c[3], f->c[0] + f->c[3] };
    const double cy[2] = { f->c[1] + f->c[2], f->c[1] - f->c[2] };
    struct flight fl = { .gone = false };
    for (int i = 0;; i++) {
        double xx[2], yy[2];
        for (int k = 0; k < 2; k++) {
            xx[k] = t.x[k] * t.x[k];
            yy[k] = t.y[k] * t.y[k];
        }
        if (flight_ends(f, &fl, (xx[0] + yy[0] + xx[1] + yy[1]) / 2, i))
            break;
        for (int k = 0; k < 2; k++) {
            t.growth2[k] *= 4 * (xx[k] + yy[k]);
            t.y[k] = 2 * t.x[k] * t.y[k] + cy[k];
            t.x[k] = xx[k] - yy[k] + cx[k];
        }
    }
    double growth = sqrt(fmax(t.growth2[0], t.growth2[1]));
    fate->gone = fl.gone;
    fate->distance = fl.gone ? fmax(twin_distance(f, &t, 0, fl.steps),
                                    twin_distance(f, &t, 1, fl.steps)) /
                                   sqrt(2)
                             : fmin(0.5 * (f->radius - sqrt(fl.size2)) / growth,
                                    fate_cap * f->radius);
}

/* By bounds that are sure. */
static void fate_sure(const struct julia_fractal *f, vec3 point,
                      struct julia_fate *fate)
{
    struct julia_orbit orbit;
    julia_orbit_follow(f, point, &orbit);
    fate->gone = orbit.gone;
    fate->distance = julia_orbit_reach(f, &orbit, f->least);
}

void julia_fate_find(const struct julia_fractal *fractal, vec3 point,
                     struct julia_fate *fate)
{
    if (!fractal->polynomial) {
        fate_sure(fractal, point, fate);
        return;
    }
    (fractal->algebra == JULIA_QUATERNION
         ? fate_quaternion
         : fate_hypercomplex)(fractal, point, fate);
    fate->distance =
        isfinite(fate->distance) ? fate->distance / fractal->stretch : 0;
}
