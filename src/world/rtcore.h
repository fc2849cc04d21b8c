/* Embree 3 (from 3.12) or 4, whichever the Makefile has found: what they call
 * by different names has one name here. Of Embree 4 callbacks of solids must
 * also set `valid`, to -1 where they found something and else to 0; Embree 3
 * doesn't look at it. */
#ifndef WORLD_RTCORE_H
#define WORLD_RTCORE_H

#include <stdbool.h>

#if GLIM_EMBREE == 4
#include <embree4/rtcore.h>
typedef struct RTCRayQueryContext embree_context;
#else
#include <embree3/rtcore.h>
typedef struct RTCIntersectContext embree_context;
#endif

/* Those of its functions that are asked for. The library is loaded with the
 * first scene that has triangles or many solids: to load it takes longer than
 * all else that a program does before its first ray. */
#define EMBREE_FUNCTIONS(X)                                                    \
    X(NewDevice)                                                               \
    X(ReleaseDevice)                                                           \
    X(SetDeviceErrorFunction)                                                  \
    X(NewScene)                                                                \
    X(ReleaseScene)                                                            \
    X(SetSceneFlags)                                                           \
    X(SetSceneBuildQuality)                                                    \
    X(CommitScene)                                                             \
    X(NewGeometry)                                                             \
    X(ReleaseGeometry)                                                         \
    X(CommitGeometry)                                                          \
    X(AttachGeometry)                                                          \
    X(SetNewGeometryBuffer)                                                    \
    X(SetGeometryUserData)                                                     \
    X(SetGeometryUserPrimitiveCount)                                           \
    X(SetGeometryBoundsFunction)                                               \
    X(SetGeometryIntersectFunction)                                            \
    X(SetGeometryOccludedFunction)                                             \
    X(SetGeometryIntersectFilterFunction)                                      \
    X(SetGeometryOccludedFilterFunction)                                       \
    X(SetGeometryInstancedScene)                                               \
    X(SetGeometryTransform)                                                    \
    X(Intersect1)                                                              \
    X(Intersect16)                                                             \
    X(Occluded1)                                                               \
    X(Occluded16)

struct embree {
#define X(name) __typeof__(rtc##name) *name;
    EMBREE_FUNCTIONS(X)
#undef X
};

/* Not to be used before embree_load has returned NULL. */
extern struct embree embree;

/* Once is enough; any thread may. Returns why it can't be, which is valid as
 * long as the program runs, or NULL. */
const char *embree_load(void);

/* These hand `context`, whatever it is the beginning of, to the callbacks
 * and fill it in first. The nearest crossing: */
static inline void embree_nearest(RTCScene scene, embree_context *context,
                                  struct RTCRayHit *rayhit)
{
#if GLIM_EMBREE == 4
    struct RTCIntersectArguments arguments;
    rtcInitRayQueryContext(context);
    rtcInitIntersectArguments(&arguments);
    arguments.context = context;
    embree.Intersect1(scene, rayhit, &arguments);
#else
    rtcInitIntersectContext(context);
    embree.Intersect1(scene, context, rayhit);
#endif
}

/* Any crossing: */
static inline void embree_any(RTCScene scene, embree_context *context,
                              struct RTCRay *ray)
{
#if GLIM_EMBREE == 4
    struct RTCOccludedArguments arguments;
    rtcInitRayQueryContext(context);
    rtcInitOccludedArguments(&arguments);
    arguments.context = context;
    embree.Occluded1(scene, ray, &arguments);
#else
    rtcInitIntersectContext(context);
    embree.Occluded1(scene, context, ray);
#endif
}

/* The nearest crossings of those of 16 rays close together that are `valid`
 * (-1, else 0). `coherent`: on their way they meet the same things mostly. */
static inline void embree_nearest16(const int *valid, RTCScene scene,
                                    embree_context *context, bool coherent,
                                    struct RTCRayHit16 *rayhit)
{
#if GLIM_EMBREE == 4
    struct RTCIntersectArguments arguments;
    rtcInitRayQueryContext(context);
    rtcInitIntersectArguments(&arguments);
    arguments.context = context;
    arguments.flags =
        coherent ? RTC_RAY_QUERY_FLAG_COHERENT : RTC_RAY_QUERY_FLAG_INCOHERENT;
    embree.Intersect16(valid, scene, rayhit, &arguments);
#else
    rtcInitIntersectContext(context);
    context->flags = coherent ? RTC_INTERSECT_CONTEXT_FLAG_COHERENT
                              : RTC_INTERSECT_CONTEXT_FLAG_INCOHERENT;
    embree.Intersect16(valid, scene, context, rayhit);
#endif
}

/* Any crossings of such rays. Not said to be coherent: then Embree 3.13 does
 * not return from some packets among instances. */
static inline void embree_any16(const int *valid, RTCScene scene,
                                embree_context *context, struct RTCRay16 *rays)
{
#if GLIM_EMBREE == 4
    struct RTCOccludedArguments arguments;
    rtcInitRayQueryContext(context);
    rtcInitOccludedArguments(&arguments);
    arguments.context = context;
    arguments.flags = RTC_RAY_QUERY_FLAG_INCOHERENT;
    embree.Occluded16(valid, scene, rays, &arguments);
#else
    rtcInitIntersectContext(context);
    context->flags = RTC_INTERSECT_CONTEXT_FLAG_INCOHERENT;
    embree.Occluded16(valid, scene, context, rays);
#endif
}

#endif
