/* Surfaces side by side: see facets.h. */
#include "shade/facets.h"

#include "shade/finish.h"

static lane_flag flag(bool is)
{
    return is ? -1 : 0;
}

static void put(double to[3][RAY_LANES], unsigned i, double x, double y,
                double z)
{
    to[0][i] = x;
    to[1][i] = y;
    to[2][i] = z;
}

static void set_faces(struct facets *facets, unsigned i,
                      const struct finish *finish, bool layered)
{
    bool twice = layered || facets->surface[i]->at->leaf->double_illuminate;
    facets->twice[i] = flag(twice);
    facets->front[i] = flag(layered || finish_lit_by(finish, 1, twice));
    facets->back[i] = flag(layered || finish_lit_by(finish, -1, twice));
}

static void set_paint(struct facets *facets, unsigned i,
                      const struct surface_layer *layer)
{
    const struct finish *finish = layer->finish;
    rgb weight = layer->weight;
    colour pigment = layer->pigment;
    facets->diffuse[i] = finish->diffuse;
    facets->diffuse_back[i] = finish->diffuse_back;
    facets->opacity[i] = layer_opacity(layer);
    put(facets->pigment, i, pigment.r, pigment.g, pigment.b);
    put(facets->weight, i, weight.r, weight.g, weight.b);
}

/* One of several layers may face any lamp. */
void facets_set(struct facets *facets, unsigned i,
                const struct surface *surface, rgb light)
{
    const struct surface_layer *layer = &surface->layer[0];
    const struct finish *finish = layer->finish;
    bool layered = surface->count != 1;
    vec3 normal = layered ? surface->normal : layer->normal;
    bool matt = !layered && finish->brilliance == 1 && !(finish->crand > 0) &&
                !finish_tints(finish);
    facets->surface[i] = surface;
    facets->layered |= (unsigned)layered << i;
    facets->matt |= (unsigned)matt << i;
    facets->shining |= (unsigned)(matt && finish_shines(finish)) << i;
    set_faces(facets, i, finish, layered);
    put(facets->normal, i, normal.x, normal.y, normal.z);
    put(facets->light, i, light.r, light.g, light.b);
    if (matt)
        set_paint(facets, i, layer);
}

void facets_clear(struct facets *facets, unsigned i)
{
    facets->surface[i] = NULL;
    facets->twice[i] = facets->front[i] = facets->back[i] = 0;
    put(facets->normal, i, 0, 0, 0);
}

rgb facets_light(const struct facets *facets, unsigned i)
{
    return (rgb){ facets->light[0][i], facets->light[1][i],
                  facets->light[2][i] };
}

/* What the layers make of white light. */
struct shares {
    double cosine[RAY_LANES], of[3][RAY_LANES];
};

CLONES static void diffuse_shares(const struct facets *restrict facets,
                                  const double (*restrict direction)[RAY_LANES],
                                  struct shares *restrict shares)
{
    for (int i = 0; i < RAY_LANES; i++) {
        vec3 normal = { facets->normal[0][i], facets->normal[1][i],
                        facets->normal[2][i] };
        vec3 light = { direction[0][i], direction[1][i], direction[2][i] };
        double cosine = vec3_dot(normal, light);
        lane_flag before = (cosine > 0 ? -1 : 0) | facets->twice[i];
        double front = facets->diffuse[i], back = facets->diffuse_back[i];
        double diffuse = before ? front : back;
        diffuse = diffuse * fabs(cosine) * facets->opacity[i];
        shares->cosine[i] = cosine;
        shares->of[0][i] = facets->pigment[0][i] * diffuse;
        shares->of[1][i] = facets->pigment[1][i] * diffuse;
        shares->of[2][i] = facets->pigment[2][i] * diffuse;
    }
}

static void highlight_shares(const struct facets *facets,
                             const struct facets_lit *lit, unsigned lanes,
                             struct shares *shares)
{
    for (; lanes; lanes &= lanes - 1) {
        unsigned i = (unsigned)__builtin_ctz(lanes);
        const struct surface *surface = facets->surface[i];
        vec3 light = { lit->direction[0][i], lit->direction[1][i],
                       lit->direction[2][i] };
        if (!(shares->cosine[i] > 0 || facets->twice[i]))
            continue;
        rgb share = finish_highlights(surface, &surface->layer[0], light,
                                      shares->cosine[i]);
        shares->of[0][i] += share.r;
        shares->of[1][i] += share.g;
        shares->of[2][i] += share.b;
    }
}

CLONES static void add_shares(struct facets *restrict facets,
                              const struct shares *restrict shares,
                              const struct facets_lit *restrict lit,
                              const lane_flag *restrict is_lit)
{
    for (int k = 0; k < 3; k++)
        for (int i = 0; i < RAY_LANES; i++) {
            double sent = shares->of[k][i] * lit->colour[k][i];
            double light = facets->light[k][i];
            double more = light + facets->weight[k][i] * sent;
            facets->light[k][i] = is_lit[i] ? more : light;
        }
}

void facets_add_one(struct facets *facets, unsigned i,
                    const struct light_sample *sample)
{
    rgb light = facets_light(facets, i);
    surface_add_light(facets->surface[i], sample, &light);
    put(facets->light, i, light.r, light.g, light.b);
}

/* Those that no loop can do. */
static void add_each(struct facets *facets, const struct facets_lit *lit,
                     unsigned lanes)
{
    for (; lanes; lanes &= lanes - 1) {
        unsigned i = (unsigned)__builtin_ctz(lanes);
        const struct light_sample sample = {
            .direction = { lit->direction[0][i], lit->direction[1][i],
                           lit->direction[2][i] },
            .colour = { lit->colour[0][i], lit->colour[1][i],
                        lit->colour[2][i] },
            .highlights = lit->highlights,
        };
        facets_add_one(facets, i, &sample);
    }
}

void facets_add(struct facets *facets, const struct facets_lit *lit,
                unsigned lanes)
{
    unsigned matt = lanes & facets->matt;
    struct shares shares;
    lane_flag is_lit[RAY_LANES];
    add_each(facets, lit, lanes & ~matt);
    if (!matt)
        return;
    for (unsigned i = 0; i < RAY_LANES; i++)
        is_lit[i] = -(lane_flag)(matt >> i & 1);
    diffuse_shares(facets, lit->direction, &shares);
    if (lit->highlights)
        highlight_shares(facets, lit, matt & facets->shining, &shares);
    add_shares(facets, &shares, lit, is_lit);
}
