/* Mesh points on flat pieces of surface (facet_mesh.h). */
#include "lightmesh/facet_mesh.h"
#include "lightmesh/knower.h"

static bool surfaces_all_lamps(struct asking *asking, struct incident *incident)
{
    const struct facet_mesh *facets = asking->knowers->direct->facets;
    incident->around = false;
    return facets && facet_mesh_light(facets, asking->worker, &asking->receiver,
                                      &incident->before);
}

const struct knower surfaces_knower = {
    .name = "surfaces",
    .help = "mesh points on this flat piece",
    .all_lamps = surfaces_all_lamps,
};
