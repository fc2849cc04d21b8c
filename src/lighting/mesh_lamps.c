/* The light of lamps at a surface: see mesh_lamps.h. */
#include "lighting/mesh_lamps.h"

#include "lightmesh/direct.h"
#include "shade/finish.h"

static bool mesh_shines(const struct surface *surface)
{
    for (int i = 0; i < surface->count; i++) {
        if (finish_shines(surface->layer[i].finish))
            return true;
    }
    return false;
}

/* Highlights of many lamps are those of one, where most of the light is. */
static void mesh_shine(const struct lamplight *asked, vec3 direction, rgb light)
{
    struct light_sample sample = { .direction = direction,
                                   .colour = light,
                                   .highlights = true,
                                   .diffused = true };
    if (rgb_peak(light) > 0)
        asked->visit(asked->context, &sample);
}

/* A side of a surface that asks for light. */
static struct receiver mesh_receiver(const struct surface *surface, vec3 side,
                                     vec3 normal, struct lattice_view view)
{
    bool first = surface->place && vec3_dot(side, surface->side) > 0;
    return (struct receiver){
        .point = surface->point,
        .side = side,
        .normal = normal,
        .from = vec3_along(surface->point, surface->view, surface->at->t),
        .at = surface->at,
        .pixel = first ? surface->place : NULL,
        .view = view,
        .weight = 1,
    };
}

/* What the lamps in front of the surface, or behind it, give its first layer,
 * to be multiplied by its diffuse share. */
static rgb mesh_side(const struct mesh_lamps *mesh,
                     const struct lamplight *asked, double sign)
{
    const struct surface *surface = asked->surface;
    const struct surface_layer *layer = &surface->layer[0];
    double brilliance = layer->finish->brilliance;
    const struct receiver receiver =
        mesh_receiver(surface, vec3_scale(surface->side, sign),
                      vec3_scale(layer->normal, sign), mesh->view);
    struct asking asking;
    struct incident incident;
    asking_start(&asking, mesh->knowers, asked->worker, &receiver,
                 surface->inside);
    asking_all_lamps(&asking, &incident);
    rgb light = incident_irradiance(&incident, &receiver, brilliance);
    if (sign > 0 && mesh_shines(surface)) {
        rgb from_there;
        vec3 direction = incident_direction(&incident, &from_there);
        mesh_shine(asked, direction, from_there);
    }
    double albedo = layer->finish->diffuse_albedo ? (brilliance + 1) / 2 : 1;
    return rgb_scale(light, albedo);
}

static rgb mesh_many(const struct mesh_lamps *mesh,
                     const struct lamplight *asked)
{
    const struct surface *surface = asked->surface;
    const struct finish *finish = surface->layer[0].finish;
    double back = surface->at->leaf->look->double_illuminate
                      ? finish->diffuse
                      : finish->diffuse_back;
    rgb light = mesh_side(mesh, asked, 1);
    if (back != 0 && finish->diffuse != 0)
        light = rgb_add_scaled(light, mesh_side(mesh, asked, -1),
                               back / finish->diffuse);
    return light;
}

/* A surface whose lamps are asked one by one. */
struct mesh_asker {
    struct lamplight light; /* first: its address is ours */
    struct asking asking;
};

static rgb mesh_asker_share(struct lamplight *light, const struct lamp *lamp,
                            const struct lamp_view *view)
{
    struct mesh_asker *asker = (struct mesh_asker *)light;
    return asking_one_lamp(&asker->asking, lamp, view);
}

/* Whether what comes from behind counts too. */
static bool mesh_both_sides(const struct surface *surface)
{
    if (surface->at->leaf->look->double_illuminate)
        return true;
    for (int i = 0; i < surface->count; i++)
        if (surface->layer[i].finish->diffuse_back != 0)
            return true;
    return false;
}

/* Visits the lamps' samples. */
static void mesh_few(const struct mesh_lamps *mesh,
                     const struct lamplight *light)
{
    const struct surface *surface = light->surface;
    const struct receiver receiver =
        mesh_receiver(surface, surface->side, surface->side, mesh->view);
    bool both = mesh_both_sides(surface);
    struct mesh_asker asker;
    asker.light = *light;
    asker.light.share = mesh_asker_share;
    asking_start(&asker.asking, mesh->knowers, light->worker, &receiver,
                 surface->inside);
    for (size_t i = 0; i < light->lamps->count; i++) {
        const struct lamp *lamp = &light->lamps->items[i];
        if (both || !asking_rules_out(&asker.asking, lamp))
            lamplight_give(&asker.light, lamp);
    }
}

/* Mesh points are of all surfaces: where groups have lamps of their own, each
 * surface asks for itself. */
static void mesh_groups_give(struct lamplight *light)
{
    light->share = lamplight_trace_fine;
    for (size_t i = 0; i < light->lamps->count; i++)
        lamplight_give(light, &light->lamps->items[i]);
}

/* As one that asks nobody else. */
static rgb mesh_share(struct lamplight *light, const struct lamp *lamp,
                      const struct lamp_view *view)
{
    const struct mesh_lamps *mesh = light->knows;
    const struct surface *surface = light->surface;
    const struct receiver receiver =
        mesh_receiver(surface, surface->side, surface->side, mesh->view);
    struct asking asking;
    asking_start(&asking, mesh->knowers, light->worker, &receiver,
                 surface->inside);
    return asking_one_lamp(&asking, lamp, view);
}

/* Pixels know without being asked for the rest of the ladder. */
static struct lamplights_known mesh_foresee(const struct lamplights *lights,
                                            const struct lamp *lamp,
                                            unsigned lanes)
{
    const struct mesh_lamps *mesh = lights->knows;
    struct lamplights_known known = { 0, 0 };
    for (; lanes; lanes &= lanes - 1) {
        int i = __builtin_ctz(lanes);
        const struct facets *facets = lights->facets;
        vec3 way = rays_direction(&lights->ways.rays, i);
        bool shines;
        if (!(vec3_dot(way, facets_side(facets, (unsigned)i)) > 0) ||
            !facets->place[i] ||
            !pixel_mesh_sees(mesh->knowers->pixels, facets->place[i], lamp,
                             &shines))
            continue;
        known.lit |= (unsigned)shines << i;
        known.dark |= (unsigned)!shines << i;
    }
    return known;
}

bool mesh_lamps_may_mix(const struct mesh_lamps *mesh)
{
    return mesh->knowers->plan->lamps == PLAN_EACH;
}

void mesh_lamps_light_many(const struct mesh_lamps *mesh, struct worker *worker,
                           struct facets *facets)
{
    const struct lamps *lamps = mesh->knowers->lamps;
    bool chosen = scene_lamps_choose(lamps->scene);
    struct lamplights lights;
    lights.lamps = lamps;
    lights.worker = worker;
    lights.share = chosen ? lamplight_trace_fine : mesh_share;
    lights.traced = chosen ? lamps_share_fine : NULL;
    lights.knows = mesh;
    lights.foresee = chosen || !mesh->knowers->pixels ? NULL : mesh_foresee;
    lamplights_start(&lights, facets);
    for (size_t i = 0; i < lamps->count; i++)
        lamplights_give(&lights, &lamps->items[i]);
}

rgb mesh_lamps_light(const struct mesh_lamps *mesh, struct lamplight *light)
{
    if (scene_lamps_choose(light->lamps->scene))
        mesh_groups_give(light);
    else if (mesh->knowers->direct->many)
        return mesh_many(mesh, light);
    else
        mesh_few(mesh, light);
    return rgb_grey(0);
}
