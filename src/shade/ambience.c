/* Ambient light from outside: see ambience.h. */
#include "shade/ambience.h"

#include "scene/mesh.h"
#include "shade/background.h"
#include "shade/finish.h"
#include "shade/shadow.h"

enum {
    PANES_MAX = 64,  /* that a ray passes */
    MIRRORS_MAX = 3, /* on one way */
};

/* Through less than this nothing is seen. */
static const double least = 0.02;

/* A walk over all textures. */
struct tally {
    double ambient, diffuse; /* sums: what is hardly diffuse says little of what
                              * surfaces have instead of each other's light */
    bool glows;
};

static void tally_texture(struct tally *tally, const struct texture *texture)
{
    for (size_t i = 0; texture && i < texture->count; i++) {
        const struct finish *finish = texture->layers[i].finish;
        double ambient = rgb_peak(finish->ambient);
        tally->glows |= rgb_peak(finish->emission) > 0;
        if (finish->diffuse <= 0)
            continue;
        tally->ambient += fmin(ambient, finish->diffuse);
        tally->diffuse += finish->diffuse;
    }
}

static void tally_leaf(void *context, const struct leaf *leaf)
{
    struct tally *tally = context;
    tally_texture(tally, leaf->look->texture);
    if (leaf->object->kind != OBJECT_MESH)
        return;
    const struct mesh *mesh = leaf->object->mesh;
    for (size_t i = 0; i < mesh->texture_count; i++)
        tally_texture(tally, mesh->textures[i]);
}

static void tally_solid(void *context, const struct solid *solid)
{
    if (solid->leaf)
        tally_leaf(context, solid->leaf);
    for (size_t i = 0; i < solid->child_count; i++)
        tally_solid(context, solid->children[i]);
}

/* Whether a lamp is on; it may take light away. */
static bool lamps_shine(const struct world *world)
{
    size_t count;
    const struct light *lights = world_lights(world, &count);
    for (size_t i = 0; i < count; i++) {
        rgb light = lights[i].colour;
        if (fabs(light.r) + fabs(light.g) + fabs(light.b) > 0)
            return true;
    }
    return false;
}

struct ambience ambience_new(const struct world *world,
                             const struct scene *scene)
{
    struct ambience ambience = { .scene = scene,
                                 .sky = settings_sky(&scene->settings) };
    struct tally tally = { 0 };
    if (ambience.sky) {
        ambience.everywhere = settings_keep_ambient(&scene->settings);
        if (ambience.everywhere)
            ambience.light = scene->settings.ambient_light;
        return ambience;
    }
    world_visit(world, tally_solid, tally_leaf, &tally);
    ambience.everywhere = !tally.glows && !lamps_shine(world);
    ambience.light = scene->settings.ambient_light;
    ambience.share = tally.diffuse > 0 ? tally.ambient / tally.diffuse : 0;
    return ambience;
}

rgb ambience_beyond(const struct ambience *ambience, vec3 direction)
{
    return ambience->sky ? background_light(ambience->scene, direction)
                         : rgb_scale(ambience->light, ambience->share);
}

double surface_sky(const struct surface *surface)
{
    double sum = 0;
    for (int i = 0; i < surface->count; i++) {
        const struct surface_layer *layer = &surface->layer[i];
        double glow = fmin(rgb_peak(layer->finish->glow), 1);
        sum += glow * rgb_brightness(layer->weight) *
               (1 - rgb_brightness(colour_transmittance(layer->pigment)));
    }
    return sum;
}

rgb surface_ambient(const struct surface *surface)
{
    rgb sum = rgb_grey(0);
    for (int i = 0; i < surface->count; i++) {
        const struct surface_layer *layer = &surface->layer[i];
        rgb share = finish_ambient(layer);
        sum = rgb_add(sum, rgb_mul(layer->weight, share));
    }
    return sum;
}

/* What is left of a ray that looks for openings. */
struct look_out {
    const struct ambience *ambience;
    const struct world *world;
    struct worker *worker;
    struct ray ray;
    double left; /* share of it */
    int mirrors; /* on its way */
};

static double look_out(struct look_out *look);

/* What mirrors there show. */
static double look_mirrored(const struct look_out *look,
                            const struct surface *surface)
{
    double open = 0;
    for (int i = 0; i < surface->count && look->mirrors < MIRRORS_MAX; i++) {
        const struct surface_layer *layer = &surface->layer[i];
        struct look_out next = *look;
        next.left *= rgb_brightness(rgb_mul(layer->weight, layer->reflection));
        if (next.left < least)
            continue;
        next.mirrors++;
        next.ray.origin = surface->point;
        next.ray.direction = surface_mirrored(
            surface->normal, look->ray.direction, layer->normal);
        open += look_out(&next);
    }
    return open;
}

static double look_out(struct look_out *look)
{
    const struct ambience *ambience = look->ambience;
    double open = 0;
    for (int i = 0; i < PANES_MAX && look->left >= least; i++) {
        struct intersection at;
        struct surface surface;
        look->worker->counters.shadow_rays++;
        if (!world_closest(look->world, &look->ray,
                           surface_offset(look->ray.origin), RAY_REFLECTION,
                           &at))
            return open + look->left;
        if (ambience->scene->fogs.count > 0) {
            rgb clear = fog_veil(ambience->scene, &look->ray, at.t).through;
            open += look->left * (1 - rgb_brightness(clear));
            look->left *= rgb_brightness(clear);
        }
        struct surface_view view = { .direction = look->ray.direction,
                                     .ior = 1,
                                     .quality = QUALITY_FOG,
                                     .bailout = least,
                                     .smooth = true };
        surface_fill(&surface, &at, &view);
        open += look->left * surface_sky(&surface);
        open += look_mirrored(look, &surface);
        look->left *= rgb_brightness(surface_passed(&surface));
        look->ray.origin = at.point;
    }
    return open;
}

double ambience_open(const struct ambience *ambience, const struct world *world,
                     struct worker *worker, const struct ray *ray)
{
    struct look_out look = { ambience, world, worker, *ray, 1, 0 };
    return ambience->everywhere ? 1 : fmin(look_out(&look), 1);
}
