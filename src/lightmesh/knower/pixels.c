/* The picture's own pixels, where it sees a surface first: each knows every
 * lamp exactly (pixel_mesh.h). */
#include "lightmesh/knower.h"
#include "lightmesh/tuning.h"

static double pixels_cost(const struct knower_job *job)
{
    double lamp = job->triangles * time_lamp_triangle +
                  job->points * time_lamp_point + job->doubtful * time_ray;
    return job->points * time_pixel_point + job->lamps * lamp;
}

static bool pixels_one_lamp(struct asking *asking, const struct lamp *lamp,
                            const struct lamp_view *view, rgb *share)
{
    const struct pixel_mesh *mesh = asking->knowers->pixels;
    const struct receiver *receiver = &asking->receiver;
    bool shines;
    if (!mesh || !receiver->pixel ||
        !(vec3_dot(view->direction, receiver->side) > 0) ||
        !pixel_mesh_sees(mesh, receiver->pixel, lamp, &shines))
        return false;
    *share = rgb_grey(shines ? 1 : 0);
    return true;
}

static bool pixels_all_lamps(struct asking *asking, struct incident *incident)
{
    const struct pixel_mesh *mesh = asking->knowers->pixels;
    incident->around = false;
    return mesh && asking->receiver.pixel &&
           pixel_mesh_light(mesh, &asking->receiver, &incident->before);
}

const struct knower pixels_knower = {
    .name = "pixels",
    .help = "lamps looked at the picture's own points",
    .cost = pixels_cost,
    .one_lamp = pixels_one_lamp,
    .all_lamps = pixels_all_lamps,
};
