/* See emitter_box.h. */
#include "shade/emitter_box.h"

#include "base/spherical_rectangle.h"
#include "scene/primitive.h"

enum { FACES = 6 };

/* Steradians: what fills less is small or far, and its places fill about the
 * same each. */
static const double angle_least = 3e-4;

/* A box from a point. */
struct box_view {
    struct patch face[FACES];
    struct spherical_rectangle seen[FACES];
    double angle[FACES], sum; /* of those that are seen, the others' are 0 */
};

static bool patch_is_square(const struct patch *patch)
{
    double a2 = vec3_dot(patch->a, patch->a), b2 = vec3_dot(patch->b, patch->b);
    double fold = vec3_dot(patch->a, patch->b);
    return patch->kind == PATCH_PARALLELOGRAM && fold * fold <= 1e-18 * a2 * b2;
}

static int box_faces(const struct leaf *leaf, struct patch faces[FACES])
{
    _Static_assert((int)FACES >= (int)PATCHES_MAX, "room for all");
    int count = leaf->object->primitive->patches(leaf->shape, faces);
    for (int i = 0; i < count; i++)
        if (faces[i].kind == PATCH_PARALLELOGRAM)
            faces[i] = patch_moved(&faces[i], leaf->pose->outward);
    return count;
}

bool emitter_box_is(const struct leaf *leaf)
{
    struct patch faces[FACES];
    if (leaf->object->kind != OBJECT_SHAPE || leaf->look->inverse ||
        !leaf->object->primitive->patches || box_faces(leaf, faces) != FACES)
        return false;
    bool square = true;
    for (int i = 0; i < FACES; i++)
        square = square && patch_is_square(&faces[i]);
    return square;
}

static vec3 face_middle(const struct patch *face)
{
    return vec3_along(vec3_along(face->at, face->a, 0.5), face->b, 0.5);
}

static double face_angle(const struct patch *face,
                         const struct spherical_rectangle *seen, vec3 point)
{
    if (seen->angle >= angle_least)
        return seen->angle;
    vec3 offset = vec3_sub(face_middle(face), point);
    double far2 = vec3_dot(offset, offset);
    double facing = vec3_dot(vec3_cross(face->a, face->b), offset);
    return far2 > 0 ? fabs(facing) / (far2 * sqrt(far2)) : 0;
}

/* Faces lie in pairs, one before the other. */
static bool face_is_before(const struct box_view *view, int i, vec3 point)
{
    const struct patch *face = &view->face[i], *other = &view->face[i ^ 1];
    vec3 out = vec3_sub(face_middle(face), face_middle(other));
    return vec3_dot(out, vec3_sub(point, face->at)) > 0;
}

static void box_view_of(const struct leaf *leaf, vec3 point,
                        struct box_view *view)
{
    bool before[FACES], outside = false;
    box_faces(leaf, view->face);
    for (int i = 0; i < FACES; i++)
        outside |= before[i] = face_is_before(view, i, point);
    view->sum = 0;
    for (int i = 0; i < FACES; i++) {
        const struct patch *face = &view->face[i];
        view->angle[i] = 0;
        if (outside && !before[i])
            continue;
        view->seen[i] =
            spherical_rectangle_new(face->at, face->a, face->b, point);
        view->angle[i] = face_angle(face, &view->seen[i], point);
        view->sum += view->angle[i];
    }
}

bool emitter_box_pick(const struct leaf *leaf, vec3 point, double which,
                      const double u[2], struct emitter_pick *pick)
{
    struct box_view view;
    int i = 0;
    box_view_of(leaf, point, &view);
    for (which *= view.sum; i < FACES - 1 && which >= view.angle[i]; i++)
        which -= view.angle[i];
    if (!(view.angle[i] > 0))
        return false;
    const struct patch *face = &view.face[i];
    vec3 place =
        view.seen[i].angle >= angle_least
            ? spherical_rectangle_point(&view.seen[i], u)
            : vec3_along(vec3_along(face->at, face->a, u[0]), face->b, u[1]);
    vec3 offset = vec3_sub(place, point);
    pick->distance = vec3_length(offset);
    pick->direction = vec3_scale(offset, 1 / pick->distance);
    pick->density = 1 / view.sum;
    return pick->distance > 0;
}

double emitter_box_density(const struct leaf *leaf, vec3 point, vec3 met)
{
    struct box_view view;
    double least = (double)INFINITY;
    int on = 0;
    box_view_of(leaf, point, &view);
    for (int i = 0; i < FACES; i++) {
        const struct patch *face = &view.face[i];
        vec3 normal = vec3_normalise(vec3_cross(face->a, face->b));
        double off = fabs(vec3_dot(normal, vec3_sub(met, face->at)));
        on = off < least ? i : on;
        least = fmin(off, least);
    }
    return view.angle[on] > 0 ? 1 / view.sum : 0;
}
