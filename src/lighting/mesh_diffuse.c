/* The indirect mesh asked for one surface: see mesh_diffuse.h. */
#include "lighting/mesh_diffuse.h"

#include "base/telling.h"
#include "lightmesh/tuning.h"
#include "shade/finish.h"

/* Who asks. */
struct asker {
    struct receiver receiver; /* of no weight and view yet, and not at first */
    double weight;            /* in the picture */
    rgb albedo, ambient;      /* of irradiance, and of ambient light 1 */
    bool scatters;            /* whether irradiance does anything to it */
    double behind;            /* how much that of the other side does of it */
};

/* Whether it is where the camera looks, behind panes that hardly bend light: it
 * is seen as closely as what is before them, by pixels side by side. */
static bool receiver_is_straight(const struct mesh_indirect *known,
                                 const struct receiver *receiver)
{
    vec3 seen = vec3_sub(receiver->from, receiver->point),
         eye = vec3_sub(known->view.eye, receiver->point);
    return receiver->unmirrored &&
           vec3_dot(seen, eye) >=
               beyond_straight * vec3_length(seen) * vec3_length(eye);
}

/* What it asks of the mesh is put into its receiver. */
static struct indirect_share asker_share(const struct mesh_indirect *known,
                                         struct worker *worker,
                                         struct receiver *receiver)
{
    bool beyond = known->pixels && !receiver->pixel;
    bool little = known->worth * receiver->weight < mended_worth;
    bool straight = !beyond || receiver_is_straight(known, receiver);
    struct indirect_share share;
    if (known->pixels && straight && !(beyond && little) &&
        indirect_pixels_light(known->pixels, worker, receiver, &share))
        return share;
    receiver->view.coarser += !straight || receiver->far_side;
    return beyond && little && !receiver->far_side
               ? indirect_mesh_beyond(known->mesh, worker, receiver)
               : indirect_mesh_light(known->mesh, worker, receiver);
}

static struct diffuse_light mesh_answer_side(const struct mesh_indirect *known,
                                             struct worker *worker,
                                             struct asker *asker)
{
    const struct ambience *ambience = known->ambience;
    rgb ambient = rgb_mul(asker->ambient, ambience->light);
    double most = fmax(rgb_peak(asker->albedo), rgb_peak(ambient));
    struct indirect_share share = { rgb_grey(0), 0 };
    struct receiver *receiver = &asker->receiver;
    receiver->view = known->view;
    receiver->at_first = receiver->pixel != NULL;
    receiver->weight = asker->weight * most;
    unsigned long long rays = worker->counters.shadow_rays;
    if (asker->scatters || rgb_peak(ambient) > 0)
        share = asker_share(known, worker, receiver);
    if (worker->telling)
        telling_say(worker->telling,
                    "indirect: %.4g %.4g %.4g, %.3g of the ambient light, by "
                    "%s, %llu rays",
                    share.light.r, share.light.g, share.light.b, share.open,
                    indirect_mesh_source(known->mesh, receiver),
                    worker->counters.shadow_rays - rays);
    if (ambience->everywhere)
        share.open = 1;
    return (struct diffuse_light){ rgb_scale(ambience->light, share.open),
                                   share.light };
}

/* And light that comes through it, as through a leaf or a lamp's shade. Of that
 * side no single point answers, for what differs between points is seen at
 * once. */
static struct diffuse_light mesh_answer(const struct mesh_indirect *known,
                                        struct worker *worker,
                                        struct asker *asker)
{
    struct diffuse_light light = mesh_answer_side(known, worker, asker);
    if (!(asker->behind > 0) || !asker->scatters)
        return light;
    struct asker other = *asker;
    struct receiver *receiver = &other.receiver;
    receiver->side = vec3_negate(receiver->side);
    receiver->smooth = vec3_negate(receiver->smooth);
    receiver->normal = vec3_negate(receiver->normal);
    receiver->from = vec3_opposite(receiver->from, receiver->point);
    receiver->far_side = true;
    other.albedo = rgb_scale(asker->albedo, asker->behind);
    rgb through = mesh_answer_side(known, worker, &other).irradiance;
    light.irradiance = rgb_add_scaled(light.irradiance, through, asker->behind);
    return light;
}

struct diffuse_light mesh_diffuse(const struct mesh_indirect *known,
                                  struct worker *worker,
                                  const struct surface *surface)
{
    const struct surface_layer *layer = &surface->layer[0];
    struct asker asker = {
        .receiver = {
            .point = surface->point,
            .side = surface->side,
            .smooth = surface->normal,
            .normal = known->smooth ? surface->normal : layer->normal,
            .from = vec3_along(surface->point, surface->view, surface->at->t),
            .pixel = surface->place,
            .unmirrored = surface->unmirrored,
        },
        .weight = surface->weight,
        .albedo = surface_albedo(surface),
        .ambient = surface_ambient(surface),
        .scatters = layer->finish->diffuse != 0,
        .behind = surface_behind(surface),
    };
    return mesh_answer(known, worker, &asker);
}

struct diffuse_light mesh_diffuse_facet(const struct mesh_indirect *known,
                                        struct worker *worker,
                                        const struct facets *facets, unsigned i)
{
    vec3 point = lane_get(facets->point, i);
    struct asker asker = {
        .receiver = {
            .point = point,
            .side = facets_side(facets, i),
            .smooth = lane_get(facets->normal, i),
            .normal = lane_get(facets->layer[0].normal, i),
            .from = vec3_along(point, lane_get(facets->view, i),
                               facets->faces->hit[i].t),
            .pixel = facets->place[i],
            .unmirrored = facets->unmirrored[i],
        },
        .weight = facets->worth[i],
        .albedo = facets_albedo(facets, i),
        .ambient = facets_ambient(facets, i),
        .scatters = facets->layer[0].diffuse[i] != 0,
        .behind = finish_behind(facets->layer[0].diffuse[i],
                                facets->layer[0].diffuse_back[i],
                                facets->twice[i]),
    };
    return mesh_answer(known, worker, &asker);
}
