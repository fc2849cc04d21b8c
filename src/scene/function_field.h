/* What functions are made of besides arithmetic: patterns, pigments, splines,
 * transformations. */
#ifndef SCENE_FUNCTION_FIELD_H
#define SCENE_FUNCTION_FIELD_H

#include "base/affine.h"
#include "base/arena.h"
#include "scene/function.h"

struct noise_settings;
struct pattern;
struct pigment;
struct spline;

/* Parts of a colour after its five numbers: how bright it is, and the height
 * that it stands for in a height_field. */
enum field_part { FIELD_GREY = 5, FIELD_HEIGHT };

/* The pattern's value, of a block pattern the block's number. */
const struct function_field *field_of_pattern(struct arena *arena,
                                              const struct pattern *pattern);
/* Solid noise by whatever the settings say when it is asked for. */
const struct function_field *field_of_noise(struct arena *arena,
                                            const struct noise_settings *noise);
/* One part of the values, 0 beyond the last. */
const struct function_field *
field_of_values(struct arena *arena, const struct function_values *values,
                int part);

/* What they are at several points. */
void function_values_all(const struct function_values *values,
                         const struct spots *spots, double (*parts)[5]);

/* Its colours. */
const struct function_values *values_of_pigment(struct arena *arena,
                                                const struct pigment *pigment);
/* Its places; x is the time. */
const struct function_values *values_of_spline(struct arena *arena,
                                               const struct spline *spline);
/* Where it takes a point. */
const struct function_values *values_of_affine(struct arena *arena,
                                               const affine *transform);

#endif
