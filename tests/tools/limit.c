/* limit WIDTH HEIGHT SHADOWS RUNS: what the rays of the bench's scene of 400
 * spheres take if nothing else is done: its spheres as 20,000 triangles and its
 * plane as 2, by Embree alone, one thread, in packets of 4 x 4 pixels that are
 * said to be coherent. Each pixel's ray asks for the nearest crossing; then
 * SHADOWS rays ask whether anything is between those crossings and the scene's
 * lamps. Prints the least seconds of processor time of RUNS. */
#include <math.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

#include "world/rtcore.h"

enum { BALLS = 400, AROUND = 10, RINGS = 4, LANES = 16, LAMPS = 2 };
enum { CORNERS = AROUND * (RINGS - 1) + 2, FACES = 50 };

static const double pi = 3.14159265358979323846;

static void corner(float *to, int ball, double ring, double turn)
{
    double high = cos(pi * ring / RINGS), wide = sin(pi * ring / RINGS);
    double around = 2 * pi * turn / AROUND;
    to[0] = (float)(ball % 20 - 9.5 + 0.4 * wide * cos(around));
    to[1] = (float)(ball % 7 / 9.0 - 1 + 0.4 * high);
    to[2] = (float)(ball / 20 - 5 + 0.4 * wide * sin(around));
}

static unsigned *face(unsigned *to, unsigned a, unsigned b, unsigned c)
{
    to[0] = a;
    to[1] = b;
    to[2] = c;
    return to + 3;
}

/* A pole, rings, a pole: 10 + 20 + 20 faces, the last ones at a ring lower. */
static unsigned *ball_faces(unsigned *to, unsigned first)
{
    for (unsigned i = 0; i < AROUND; i++) {
        unsigned next = (i + 1) % AROUND, ring = first + 1;
        to = face(to, first, ring + i, ring + next);
        for (unsigned r = 0; r < RINGS - 2; r++, ring += AROUND) {
            to = face(to, ring + i, ring + AROUND + i, ring + next);
            to = face(to, ring + next, ring + AROUND + i, ring + AROUND + next);
        }
    }
    return to;
}

static void add_balls(float *corners, unsigned *faces)
{
    for (int ball = 0; ball < BALLS; ball++) {
        faces = ball_faces(faces, (unsigned)(ball * CORNERS));
        corner(corners, ball, 0, 0);
        corners += 3;
        for (int at = 0; at < AROUND * (RINGS - 1); at++, corners += 3)
            corner(corners, ball, 1 + at / AROUND, at % AROUND);
        corner(corners, ball, RINGS, 0);
        corners += 3;
    }
}

static void add_plane(float *corners, unsigned *faces, unsigned first)
{
    const float far = 1e6f;
    const float plane[12] = { -far, -1.5f, -far, far, -1.5f, -far,
                              -far, -1.5f, far,  far, -1.5f, far };
    memcpy(corners, plane, sizeof plane);
    face(face(faces, first, first + 1, first + 2), first + 1, first + 3,
         first + 2);
}

static RTCScene scene_of(RTCDevice device)
{
    RTCScene scene = embree.NewScene(device);
    RTCGeometry mesh = embree.NewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE);
    float *corners = embree.SetNewGeometryBuffer(
        mesh, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, 3 * sizeof(float),
        BALLS * CORNERS + 4);
    unsigned *faces = embree.SetNewGeometryBuffer(
        mesh, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, 3 * sizeof(unsigned),
        BALLS * FACES + 2);
    add_balls(corners, faces);
    add_plane(corners + 3 * BALLS * CORNERS, faces + 3 * BALLS * FACES,
              BALLS * CORNERS);
    embree.CommitGeometry(mesh);
    embree.AttachGeometry(scene, mesh);
    embree.ReleaseGeometry(mesh);
    embree.CommitScene(scene);
    return scene;
}

struct limit {
    RTCScene scene;
    int width, height;
    long shadows; /* still to be asked */
    long lit;     /* so that nothing is left out as needless */
};

/* From <0, 3, -7> to <0, 0, 0>, 40 degrees wide. */
static void camera_ray(const struct limit *limit, int x, int y,
                       struct RTCRay16 *ray, int i)
{
    double wide = 2 * tan(20 * pi / 180), high = wide * 3 / 4;
    double u = ((x + 0.5) / limit->width - 0.5) * wide;
    double v = (0.5 - (y + 0.5) / limit->height) * high;
    double far = sqrt(58), up = 7 / far, ahead = 3 / far;
    double way[3] = { u, up * v - ahead, ahead * v + up };
    double length = sqrt(way[0] * way[0] + way[1] * way[1] + way[2] * way[2]);
    ray->org_x[i] = 0;
    ray->org_y[i] = 3;
    ray->org_z[i] = -7;
    ray->dir_x[i] = (float)(way[0] / length);
    ray->dir_y[i] = (float)(way[1] / length);
    ray->dir_z[i] = (float)(way[2] / length);
    ray->tnear[i] = ray->time[i] = 0;
    ray->tfar[i] = INFINITY;
    ray->mask[i] = ~0u;
    ray->flags[i] = ray->id[i] = 0;
}

static void ask_lamp(struct limit *limit, const struct RTCRay16 *seen,
                     const int *met, const float lamp[3])
{
    struct RTCRay16 ray = *seen;
    embree_context context;
    int asked[LANES];
    for (int i = 0; i < LANES; i++) {
        asked[i] = met[i] && limit->shadows > 0 ? -1 : 0;
        limit->shadows += asked[i];
        float t = asked[i] ? seen->tfar[i] : 0;
        ray.org_x[i] = seen->org_x[i] + t * seen->dir_x[i];
        ray.org_y[i] = seen->org_y[i] + t * seen->dir_y[i];
        ray.org_z[i] = seen->org_z[i] + t * seen->dir_z[i];
        ray.dir_x[i] = lamp[0] - ray.org_x[i];
        ray.dir_y[i] = lamp[1] - ray.org_y[i];
        ray.dir_z[i] = lamp[2] - ray.org_z[i];
        ray.tnear[i] = 1e-5f;
        ray.tfar[i] = 1;
    }
    embree_any16(asked, limit->scene, &context, &ray);
    for (int i = 0; i < LANES; i++)
        limit->lit += asked[i] && ray.tfar[i] > 0;
}

static void ask_packet(struct limit *limit, int x, int y)
{
    static const float lamps[LAMPS][3] = { { -600, 800, -900 },
                                           { 70, 30, -90 } };
    struct RTCRayHit16 packet;
    embree_context context;
    int all[LANES], met[LANES];
    for (int i = 0; i < LANES; i++) {
        camera_ray(limit, x + i % 4, y + i / 4, &packet.ray, i);
        packet.hit.geomID[i] = RTC_INVALID_GEOMETRY_ID;
        packet.hit.instID[0][i] = RTC_INVALID_GEOMETRY_ID;
        all[i] = -1;
    }
    embree_nearest16(all, limit->scene, &context, true, &packet);
    for (int i = 0; i < LANES; i++)
        met[i] = packet.hit.geomID[i] != RTC_INVALID_GEOMETRY_ID;
    for (int k = 0; k < LAMPS; k++)
        ask_lamp(limit, &packet.ray, met, lamps[k]);
}

int main(int argc, char **argv)
{
    if (argc != 5) {
        fprintf(stderr, "usage: limit WIDTH HEIGHT SHADOWS RUNS\n");
        return 2;
    }
    const char *failure = embree_load();
    if (failure) {
        fprintf(stderr, "limit: %s\n", failure);
        return 1;
    }
    RTCDevice device = embree.NewDevice("threads=1");
    struct limit limit = { scene_of(device), atoi(argv[1]), atoi(argv[2]), 0,
                           0 };
    double least = INFINITY;
    for (int run = 0; run < atoi(argv[4]); run++) {
        limit.shadows = atol(argv[3]);
        clock_t start = clock();
        for (int y = 0; y + 4 <= limit.height; y += 4)
            for (int x = 0; x + 4 <= limit.width; x += 4)
                ask_packet(&limit, x, y);
        least = fmin(least, (double)(clock() - start) / CLOCKS_PER_SEC);
    }
    printf("%.4f\n", least);
    fprintf(stderr, "lit %ld, not asked %ld\n", limit.lit, limit.shadows);
    embree.ReleaseScene(limit.scene);
    embree.ReleaseDevice(device);
    return 0;
}
