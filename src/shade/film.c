/* Interference: see film.h. */
#include "shade/film.h"

#include "scene/noise.h"

/* Measured: 1 + amount cos(2 pi d (lamp + viewer) / wavelength), and the
 * thickness d varies by turbulence * (2 noise - 1), the noise that of the world
 * with 5 octaves. */
static double film_depth(const struct film *film, vec3 point)
{
    const struct turbulence noise = { { 1, 1, 1 }, 5, 0.5, 2 };
    if (film->turbulence == 0 || !film->noise)
        return film->thickness;
    double wave = noise_turbulence(film->noise->generator, point, &noise);
    return film->thickness * (1 + film->turbulence * (2 * wave - 1));
}

static double film_wave(const struct film *film, double way, double wavelength)
{
    const double turn = 2 * 3.14159265358979323846;
    double phase = wavelength != 0 ? turn * way / wavelength : 0;
    return isfinite(phase) ? 1 + film->amount * cos(phase) : 1;
}

rgb film_tint(const struct film *film, vec3 point, double lamp, double viewer)
{
    double way = film_depth(film, point) * (lamp + viewer);
    return (rgb){ film_wave(film, way, film->wavelength.r),
                  film_wave(film, way, film->wavelength.g),
                  film_wave(film, way, film->wavelength.b) };
}
