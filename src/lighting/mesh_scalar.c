/* The paper's illumination: see mesh_scalar.h. */
#include "lighting/mesh_scalar.h"

struct diffuse_light mesh_scalar_light(const struct scalar_mesh *mesh,
                                       const struct lamplight *light)
{
    const struct surface *surface = light->surface;
    rgb mean = scalar_mean(mesh, light->worker, surface);
    for (size_t i = 0; i < light->lamps->count; i++) {
        struct light_sample sample = { .highlights = false };
        rgb lamp = scalar_lamp(&light->lamps->items[i], surface->point,
                               &sample.direction);
        sample.colour = rgb_mul(mean, lamp);
        if (rgb_peak(sample.colour) > 0 &&
            surface_faces(surface, sample.direction))
            light->visit(light->context, &sample);
    }
    return (struct diffuse_light){ .irradiance = scalar_indirect_mean(
                                       mesh, light->worker, surface) };
}
