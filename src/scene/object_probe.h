/* What a scene's text may ask about an object while the scene is still being
 * read: is a point inside, where does a ray meet it. Slow, straight from the
 * tree, but for meshes and unions of many; the renderer has its own way
 * (world/).
 */
#ifndef SCENE_OBJECT_PROBE_H
#define SCENE_OBJECT_PROBE_H

#include "scene/object.h"
#include "scene/ray.h"

struct box_tree;

/* What a mesh of many triangles has in mesh.probes. */
struct mesh_probes {
    unsigned asked;              /* how often it was to be asked */
    const struct box_tree *tree; /* of its triangles' boxes; NULL: not yet */
};

/* Triangles from which on a mesh has it. */
enum { MESH_PROBES_LEAST = 32 };

/* What a union or a merge of many objects has in more.probes. */
struct child_probes {
    unsigned asked;
    const struct box_tree *tree; /* of the children's boxes; NULL: not yet */
    bool endless;                /* a child has no box: there is none */
};

/* Children from which on it has it. */
enum { CHILD_PROBES_LEAST = 16 };

/* Before an object is asked, or `often`: before it is asked very often, by many
 * threads. Its meshes and unions get their trees, in the arena, when these pay
 * and there is room. By one thread at a time. */
void object_probe_expect(const struct object *object, bool often,
                         struct arena *arena);

/* Whether the object has an inside at all. */
bool object_is_solid(const struct object *object);

/* Whether a point of the object's parent space is inside it. */
bool object_inside(const struct object *object, vec3 point);

/* The first point where the ray, in the object's parent space, meets it: its
 * *t, and the unit normal, outward. False: nowhere. The ray's direction must
 * be unit; as in POV-Ray nothing nearer than 0.0001 counts (measured). */
bool object_trace(const struct object *object, const struct ray *ray, double *t,
                  vec3 *normal);

#endif
