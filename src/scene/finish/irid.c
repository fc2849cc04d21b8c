/* irid: a thin film on which light interferes with itself. */
#include "scene/finish.h"
#include "scene/noise.h"

/* Measured: 1 + amount cos(2 pi d (lamp + viewer) / wavelength), from behind as
 * from in front, and the thickness d varies by turbulence * (2 noise - 1), the
 * noise that of the world with 5 octaves. */
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

static rgb irid_tint(const void *said, vec3 point, double lamp, double viewer)
{
    const struct film *film = &((const struct finish *)said)->film;
    if (film->amount < 0)
        return rgb_grey(1);
    double way = film_depth(film, point) * (fabs(lamp) + fabs(viewer));
    return (rgb){ film_wave(film, way, film->wavelength.r),
                  film_wave(film, way, film->wavelength.g),
                  film_wave(film, way, film->wavelength.b) };
}

static const struct field fields[] = {
    FINISH_FIELD("irid", FIELD_FLOAT, film.amount,
                 "a film in whose colours light interferes: how much, 0"),
    FINISH_FIELD("irid wavelength", FIELD_RGB, film.wavelength, NULL),
    { NULL },
};

static const struct field inner[] = {
    FINISH_FIELD("thickness", FIELD_FLOAT, film.thickness,
                 "of the film, in the unit of irid_wavelength, 0"),
    FINISH_FIELD("turbulence", FIELD_FLOAT, film.turbulence,
                 "how much the thickness varies, 0"),
    { NULL },
};

const struct finish_item irid_finish = {
    .name = "irid",
    .fields = fields,
    .inner = inner,
    .amount = offsetof(struct finish, film.amount),
    .tint = irid_tint,
};
