/* Building and asking Embree's scene: see geometry.h. */
#include "world/geometry.h"

#include "base/jobserver.h"

#include <float.h>
#include <stdio.h>
#include <string.h>

#include "scene/mesh.h"

enum {
    PARALLEL_WORTH = 50000, /* triangles and solids */
    LARGE = 200000,         /* triangles or solids */
    SPLITS_WORTH = 100,     /* rays of the camera for each triangle */
};

/* Rays come in floats: allow for their rounding at the box's distance. */
static struct box3 embree_box(struct box3 box, vec3 centre)
{
    vec3 low = vec3_sub(box.low, centre), high = vec3_sub(box.high, centre);
    double size = vec3_length(vec3_sub(high, low));
    double most = fmax(vec3_length(low), vec3_length(high));
    double pad = 1e-5 * size + 1e-6 * most;
    vec3 more = { pad, pad, pad };
    return (struct box3){ vec3_sub(low, more), vec3_add(high, more) };
}

static void solid_bounds(const struct RTCBoundsFunctionArguments *a)
{
    const struct geometry *geometry = a->geometryUserPtr;
    struct box3 box = embree_box(geometry->solids.items[a->primID]->surface,
                                 geometry->centre);
    struct RTCBounds *out = a->bounds_o;
    out->lower_x = nextafterf(triangles_float(box.low.x), -FLT_MAX);
    out->lower_y = nextafterf(triangles_float(box.low.y), -FLT_MAX);
    out->lower_z = nextafterf(triangles_float(box.low.z), -FLT_MAX);
    out->upper_x = nextafterf(triangles_float(box.high.x), FLT_MAX);
    out->upper_y = nextafterf(triangles_float(box.high.y), FLT_MAX);
    out->upper_z = nextafterf(triangles_float(box.high.z), FLT_MAX);
}

/* Embree's t for ours, not smaller. */
static inline double embree_far(double t, double shift, double doubt)
{
    return embree_number((t + shift) * (1 + 1e-6) + doubt);
}

/* The bits of those rays' numbers. */
static unsigned lanes_of(unsigned asked, const unsigned *id)
{
    unsigned lanes = 0;
    for (; asked; asked &= asked - 1)
        lanes |= 1u << id[__builtin_ctz(asked)];
    return lanes;
}

/* Of a packet. */
static void packet_intersect(const struct RTCIntersectFunctionNArguments *a,
                             struct packet *packet)
{
    const struct geometry *geometry = a->geometryUserPtr;
    float *tfar = (float *)a->rayhit + LANE_TFAR * a->N;
    const unsigned *id = (const unsigned *)a->rayhit + LANE_ID * a->N;
    unsigned *hit = (unsigned *)a->rayhit + LANE_HIT * a->N;
    unsigned asked = flags_bits(a->valid, a->N);
    double before[RAY_LANES];
    memcpy(before, packet->span.far, sizeof before);
    packet_look(packet, geometry->solids.items[a->primID], lanes_of(asked, id));
    for (; asked; asked &= asked - 1) {
        unsigned i = (unsigned)__builtin_ctz(asked);
        double now = packet->span.far[id[i]];
        a->valid[i] = now < before[id[i]] ? -1 : 0;
        if (!a->valid[i])
            continue;
        float far = (float)embree_far(now, packet->shift[id[i]], packet->doubt);
        if (far < tfar[i])
            tfar[i] = far;
        hit[LANE_GEOMETRY * a->N + i] = a->geomID;
        hit[LANE_PRIMITIVE * a->N + i] = a->primID;
    }
}

static void solid_intersect(const struct RTCIntersectFunctionNArguments *a)
{
    const struct geometry *geometry = a->geometryUserPtr;
    struct query *query = (struct query *)a->context;
    struct RTCRayHit *rayhit = (struct RTCRayHit *)a->rayhit;
    double before = query->tmax;
    if (query->packet) {
        packet_intersect(a, query->packet);
        return;
    }
    if (a->valid[0] != -1)
        return;
    query_solid(query, geometry->solids.items[a->primID]);
    a->valid[0] = query->tmax < before ? -1 : 0;
    if (!a->valid[0])
        return;
    float far = (float)embree_far(query->tmax, query->shift, query->doubt);
    if (far < rayhit->ray.tfar)
        rayhit->ray.tfar = far;
    rayhit->hit.geomID = a->geomID;
    rayhit->hit.primID = a->primID;
}

/* Rays of a packet. */
static void packet_occluded(const struct RTCOccludedFunctionNArguments *a,
                            struct packet *packet)
{
    const struct geometry *geometry = a->geometryUserPtr;
    float *tfar = (float *)a->ray + LANE_TFAR * a->N;
    const unsigned *id = (const unsigned *)a->ray + LANE_ID * a->N;
    unsigned asked = flags_bits(a->valid, a->N);
    packet_look(packet, geometry->solids.items[a->primID], lanes_of(asked, id));
    for (; asked; asked &= asked - 1) {
        unsigned i = (unsigned)__builtin_ctz(asked);
        if (packet->open >> id[i] & 1)
            a->valid[i] = 0;
        else
            tfar[i] = -HUGE_VALF;
    }
}

static void solid_occluded(const struct RTCOccludedFunctionNArguments *a)
{
    const struct geometry *geometry = a->geometryUserPtr;
    struct query *query = (struct query *)a->context;
    if (query->packet)
        packet_occluded(a, query->packet);
    else if (a->valid[0] == -1 &&
             query_solid(query, geometry->solids.items[a->primID]))
        ((struct RTCRay *)a->ray)->tfar = -HUGE_VALF;
    else
        a->valid[0] = 0;
}

/* Takes the bounded solids, and the array with them, out of flat->solids. */
static void take_bounded(struct geometry *geometry, struct flat *flat)
{
    struct solid_list others = { NULL, 0, 0 };
    size_t kept = 0;
    geometry->solids = flat->solids;
    for (size_t i = 0; i < flat->solids.count; i++) {
        struct solid *solid = flat->solids.items[i];
        if (box3_is_empty(solid->surface))
            continue;
        if (!solid_is_bounded(solid)) {
            *ARRAY_PUSH(flat->arena, &others) = solid;
            continue;
        }
        geometry->solids.items[kept++] = solid;
        geometry->bounds = box3_union(geometry->bounds, solid->surface);
    }
    geometry->solids.count = kept;
    flat->solids = others;
}

static struct box3 meshes_bounds(const struct flat *flat)
{
    struct box3 box = box3_empty();
    for (size_t i = 0; i < flat->meshes.count; i++) {
        const struct leaf *leaf = flat->meshes.items[i];
        box = box3_union(
            box, affine_box(leaf->pose->outward, leaf->object->mesh->bounds));
    }
    return box;
}

/* Embree's origin is put in the middle of the triangles, where floats are
 * finest; the solids' boxes only have to be large enough. */
static void find_place(struct geometry *geometry, const struct flat *flat)
{
    struct box3 box = meshes_bounds(flat);
    if (box3_is_empty(box))
        return;
    geometry->bounds = box3_union(geometry->bounds, box);
    vec3 limit = { solid_limit, solid_limit, solid_limit };
    box = box3_intersection(box, (struct box3){ vec3_negate(limit), limit });
    if (box3_is_empty(box))
        return;
    geometry->bounds = box3_union(geometry->bounds, box);
    geometry->centre = vec3_scale(vec3_add(box.low, box.high), 0.5);
    vec3 half = vec3_sub(box.high, geometry->centre);
    geometry->scale = fmax(half.x, fmax(half.y, half.z));
}

static struct few find_few(const struct geometry *geometry, struct arena *arena)
{
    struct box3 boxes[FEW_MOST];
    for (size_t i = 0; i < geometry->solids.count; i++)
        boxes[i] =
            embree_box(geometry->solids.items[i]->surface, geometry->centre);
    return few_new(arena, &geometry->solids, boxes);
}

static void add_solids(struct geometry *geometry)
{
    size_t count = geometry->solids.count;
    if (count == 0)
        return;
    RTCGeometry user =
        embree.NewGeometry(geometry->device, RTC_GEOMETRY_TYPE_USER);
    embree.SetGeometryUserPrimitiveCount(user, (unsigned)count);
    embree.SetGeometryUserData(user, geometry);
    embree.SetGeometryBoundsFunction(user, solid_bounds, NULL);
    embree.SetGeometryIntersectFunction(user, solid_intersect);
    embree.SetGeometryOccludedFunction(user, solid_occluded);
    embree.CommitGeometry(user);
    embree.AttachGeometry(geometry->scene, user);
    embree.ReleaseGeometry(user);
}

static void embree_error(void *context, enum RTCError code, const char *text)
{
    struct geometry *geometry = context;
    (void)code;
    if (!geometry->failed && geometry->diag)
        diag_print(geometry->diag, DIAG_ERROR, span_none(), NULL, "Embree: %s",
                   text && *text ? text : "out of memory");
    geometry->failed = true;
}

/* Spatial splits (Stich et al. 2009) cost 2.5 us for each triangle and save
 * 0.002 us of a ray among leaves (measured): they pay where very many rays meet
 * few triangles. A large mesh gets indexed triangles, a third of the memory,
 * and of what holds many solids four nodes stand together instead of eight: a
 * tenth less memory, sooner built, and as quick to trace (measured). */
static void choose_build(struct geometry *geometry, size_t triangles,
                         double camera_rays)
{
    bool large = triangles > LARGE;
    bool compact = large || geometry->solids.count > LARGE;
    bool many =
        camera_rays <= 0 || camera_rays > SPLITS_WORTH * (double)triangles;
    embree.SetSceneFlags(geometry->scene, compact ? RTC_SCENE_FLAG_COMPACT
                                                  : RTC_SCENE_FLAG_NONE);
    embree.SetSceneBuildQuality(geometry->scene,
                                many && !large ? RTC_BUILD_QUALITY_HIGH
                                               : RTC_BUILD_QUALITY_MEDIUM);
}

/* If fewer rays are to come than a large mesh has triangles, sorting these
 * along a space-filling curve (Lauterbach et al. 2009) is building enough. The
 * builder is the whole device's, and scenes of instances have no such one. */
static RTCDevice device_new(const struct flat *flat, unsigned threads,
                            double camera_rays)
{
    bool large = flat->triangle_count > LARGE;
    double rays = camera_rays * (1 + (double)flat->lights.count);
    bool hasty = large && rays > 0 && rays < (double)flat->triangle_count &&
                 !triangles_any_shared(flat);
    size_t work = flat->triangle_count + flat->containers.count;
    char configuration[64];
    /* One thread builds little scenes sooner than more could be started; and of
     * make's tokens Embree knows nothing. */
    if (work < PARALLEL_WORTH || jobserver_state() != JOBSERVER_NONE)
        threads = 1;
    snprintf(configuration, sizeof configuration, "threads=%u%s",
             threads ? threads : 1, hasty ? ",tri_builder=morton" : "");
    return embree.NewDevice(configuration);
}

static bool geometry_start(struct geometry *geometry, const struct flat *flat,
                           unsigned threads, double camera_rays)
{
    const char *failure = embree_load();
    if (failure) {
        diag_print(geometry->diag, DIAG_ERROR, span_none(), NULL,
                   "Embree can't be loaded: %s", failure);
        return false;
    }
    geometry->device = device_new(flat, threads, camera_rays);
    if (!geometry->device)
        diag_print(geometry->diag, DIAG_ERROR, span_none(), NULL,
                   "Embree can't be started on this machine");
    return geometry->device != NULL;
}

bool geometry_build(struct geometry *geometry, struct flat *flat,
                    unsigned threads, double camera_rays, struct diag *diag)
{
    geometry->bounds = box3_empty();
    geometry->diag = diag;
    take_bounded(geometry, flat);
    find_place(geometry, flat);
    if (flat->meshes.count == 0 && geometry->solids.count <= FEW_MOST) {
        geometry->few = find_few(geometry, flat->arena);
        return true;
    }
    if (!geometry_start(geometry, flat, threads, camera_rays))
        return false;
    embree.SetDeviceErrorFunction(geometry->device, embree_error, geometry);
    geometry->scene = embree.NewScene(geometry->device);
    geometry->coherent = flat->triangle_count > geometry->solids.count;
    choose_build(geometry, flat->triangle_count, camera_rays);
    add_solids(geometry);
    bool good = triangles_add(&geometry->triangles, flat, geometry->device,
                              geometry->scene, geometry->centre);
    if (good)
        embree.CommitScene(geometry->scene);
    geometry->diag = NULL;
    return good && !geometry->failed;
}

void geometry_free(struct geometry *geometry, struct flat *flat)
{
    if (!geometry->device)
        return;
    triangles_free(flat);
    embree.ReleaseScene(geometry->scene);
    embree.ReleaseDevice(geometry->device);
}

/* What a ray sets out with: begun where it enters the bounds, a little before,
 * its numbers are no larger than the scene, and what lies at its end is not
 * lost to rounding. */
struct setting_out {
    double shift; /* Embree's t minus ours */
    vec3 origin;  /* from the centre */
    bool meets;   /* the bounds */
};

static inline double geometry_margin(const struct geometry *geometry)
{
    return 1e-5 * geometry->scale;
}

/* How far Embree's t may be off. */
static inline double geometry_doubt(const struct geometry *geometry)
{
    return 10 * geometry_margin(geometry);
}

static inline struct setting_out set_out(const struct geometry *geometry,
                                         const struct ray *ray, vec3 inverse,
                                         double enter, double leave)
{
    const struct box3 *box = &geometry->bounds;
    vec3 o = ray->origin;
    slab_clip(box->low.x, box->high.x, o.x, inverse.x, &enter, &leave);
    slab_clip(box->low.y, box->high.y, o.y, inverse.y, &enter, &leave);
    slab_clip(box->low.z, box->high.z, o.z, inverse.z, &enter, &leave);
    double margin = geometry_margin(geometry), shift = margin - enter;
    return (struct setting_out){
        shift, vec3_sub(ray_point(ray, -shift), geometry->centre),
        enter <= leave + margin
    };
}

/* In floats. */
static bool embree_ray(const struct geometry *geometry, struct query *query,
                       struct RTCRay *out)
{
    struct setting_out start = set_out(
        geometry, &query->ray, query->slabs.inverse, query->tmin, query->tmax);
    vec3 d = query->ray.direction;
    if (!start.meets)
        return false;
    query->shift = start.shift;
    query->doubt = geometry_doubt(geometry);
    *out = (struct RTCRay){
        .org_x = triangles_float(start.origin.x),
        .org_y = triangles_float(start.origin.y),
        .org_z = triangles_float(start.origin.z),
        .dir_x = (float)d.x,
        .dir_y = (float)d.y,
        .dir_z = (float)d.z,
        .tfar = (float)embree_far(query->tmax, query->shift, query->doubt),
        .mask = 0xffffffff,
    };
    return true;
}

void geometry_trace_scene(const struct geometry *geometry, struct query *query)
{
    struct RTCRayHit rayhit;
    if (!embree_ray(geometry, query, &rayhit.ray))
        return;
    if (query->occlusion) {
        embree_any(geometry->scene, &query->embree, &rayhit.ray);
        return;
    }
    rayhit.hit.geomID = RTC_INVALID_GEOMETRY_ID;
    rayhit.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
    embree_nearest(geometry->scene, &query->embree, &rayhit);
}

/* A packet's rays on their way to Embree, not yet in floats. */
struct setting_outs {
    LANE_LINES double shift[RAY_LANES], origin[3][RAY_LANES], far[RAY_LANES];
    lane_flag meets[RAY_LANES];
};

CLONES static void set_out_many(const struct geometry *geometry,
                                const struct packet *restrict packet,
                                struct setting_outs *restrict starts)
{
    const struct geometry here = { .bounds = geometry->bounds,
                                   .centre = geometry->centre,
                                   .scale = geometry->scale };
    const struct rays *rays = packet->rays;
    const double doubt = geometry_doubt(&here);
    for (int i = 0; i < RAY_LANES; i++) {
        struct ray ray = rays_at(rays, i);
        vec3 inverse = lane_get(packet->inverse, (unsigned)i);
        double far = packet->span.far[i];
        struct setting_out start =
            set_out(&here, &ray, inverse, packet->span.near[i], far);
        starts->meets[i] = start.meets ? -1 : 0;
        starts->shift[i] = start.shift;
        starts->origin[0][i] = embree_number(start.origin.x);
        starts->origin[1][i] = embree_number(start.origin.y);
        starts->origin[2][i] = embree_number(start.origin.z);
        starts->far[i] = embree_far(far, start.shift, doubt);
    }
}

/* Of what is nearly 0 Embree's packets lose the sign, with which they choose
 * the near sides of boxes: the ray would miss them. */
static inline float embree_component(double d)
{
    const double least = 1e-15;
    return (float)(fabs(d) < least ? copysign(least, d) : d);
}

/* Of rays that nobody asks about. Without AVX-512 Embree takes two packets of 8
 * for one of 16, and does not know which of theirs are valid: those get
 * numbers, for it stops at what is none, and a length below 0, by which it
 * leaves them out. */
static inline float embree_lane(int valid, float number, float other)
{
    return valid ? number : other;
}

CLONES static void embree_rays(const struct rays *restrict rays,
                               const struct setting_outs *restrict starts,
                               const int *restrict valid,
                               struct RTCRay16 *restrict out)
{
    for (int i = 0; i < RAY_LANES; i++) {
        int here = valid[i];
        out->org_x[i] = embree_lane(here, (float)starts->origin[0][i], 0);
        out->org_y[i] = embree_lane(here, (float)starts->origin[1][i], 0);
        out->org_z[i] = embree_lane(here, (float)starts->origin[2][i], 0);
        out->dir_x[i] =
            embree_lane(here, embree_component(rays->direction[0][i]), 1);
        out->dir_y[i] =
            embree_lane(here, embree_component(rays->direction[1][i]), 1);
        out->dir_z[i] =
            embree_lane(here, embree_component(rays->direction[2][i]), 1);
        out->tfar[i] = embree_lane(here, (float)starts->far[i], -1);
        out->tnear[i] = out->time[i] = 0;
        out->mask[i] = 0xffffffff;
        out->id[i] = (unsigned)i;
        out->flags[i] = 0;
    }
}

static void look_scene(const struct geometry *geometry, struct packet *packet)
{
    struct RTCRayHit16 rays;
    _Alignas(64) int valid[RAY_LANES];
    struct setting_outs starts;
    set_out_many(geometry, packet, &starts);
    unsigned lanes = rays_bits(starts.meets) & packet->open;
    if (!lanes)
        return;
    packet_set_out(packet, starts.shift, geometry_doubt(geometry));
    for (unsigned i = 0; i < RAY_LANES; i++)
        valid[i] = lanes >> i & 1 ? -1 : 0;
    embree_rays(packet->rays, &starts, valid, &rays.ray);
    for (unsigned i = 0; i < RAY_LANES; i++)
        rays.hit.geomID[i] = rays.hit.instID[0][i] = RTC_INVALID_GEOMETRY_ID;
    embree_context *context = &packet->query[0].embree;
    if (!packet->occlusion) {
        embree_nearest16(valid, geometry->scene, context, geometry->coherent,
                         &rays);
        return;
    }
    embree_any16(valid, geometry->scene, context, &rays.ray);
    for (unsigned i = 0; i < RAY_LANES; i++)
        if (lanes >> i & 1 && rays.ray.tfar[i] < 0)
            packet->open &= ~(1u << i);
}

void geometry_look(const struct geometry *geometry, struct packet *packet)
{
    if (geometry->few.solids)
        few_look(&geometry->few, packet);
    else
        look_scene(geometry, packet);
}
