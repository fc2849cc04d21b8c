/* A tree of boxes over the parts of one shape, for shapes made of many: which
 * parts a ray, a point or a cell may meet. */
#ifndef SCENE_BOX_TREE_H
#define SCENE_BOX_TREE_H

#include "base/affine.h"
#include "base/arena.h"
#include "scene/ray.h"

struct box_tree;

/* Over items 0 to count - 1 with these boxes, in `arena`; boxes are not kept.
 */
const struct box_tree *box_tree_new(struct arena *arena,
                                    const struct box3 *boxes, size_t count);

/* Takes an item; true: enough. */
typedef bool box_tree_visit(void *context, size_t item);

/* The items whose boxes the ray meets between tmin and *tmax, near ones sooner;
 * *tmax may be made less on the way. */
void box_tree_ray(const struct box_tree *tree, const struct ray *ray,
                  double tmin, const double *tmax, box_tree_visit *visit,
                  void *context);

/* The items whose boxes meet this one; a point is a box. */
void box_tree_box(const struct box_tree *tree, struct box3 box,
                  box_tree_visit *visit, void *context);

#endif
