/* Cubical complexes: see complex.h. */
#include "skeleton/complex.h"

#include "base/memory.h"

/* The faces of a cube by the lattice point they belong to: those at the far end
 * of an axis are points along it. */
static void complex_fill(struct complex *complex, const struct voxels *voxels)
{
    uint8_t faces[8] = { 0 };
    size_t lattice[8];
    for (cell corner = 0; corner < 8; corner++)
        for (cell axes = 0; axes < 8; axes++)
            faces[corner] |= (uint8_t)(axes & corner ? 0 : 1u << axes);
    for (cell corner = 0; corner < 8; corner++)
        lattice[corner] = ((corner & 1) * complex->stride[0] +
                           (corner >> 1 & 1) * complex->stride[1] +
                           (corner >> 2) * complex->stride[2]) /
                          8;
    for (int z = 0; z < voxels->size[2]; z++)
        for (int y = 0; y < voxels->size[1]; y++) {
            size_t row = voxels_index(voxels, 0, y, z);
            uint8_t *at = complex->cells + 1 +
                          (size_t)(y + 1) * complex->stride[1] / 8 +
                          (size_t)(z + 1) * complex->stride[2] / 8;
            for (int x = 0; x < voxels->size[0]; x++, at++)
                for (int k = 0; k < 8 && voxels->empty[row + (size_t)x]; k++)
                    at[lattice[k]] |= faces[k];
        }
}

struct complex *complex_new(const struct voxels *voxels)
{
    struct complex *complex = memory_new(sizeof *complex);
    for (int axis = 0; axis < 3; axis++)
        complex->size[axis] = voxels->size[axis] + 2;
    complex->stride[0] = 8;
    complex->stride[1] = 8 * (cell)complex->size[0];
    complex->stride[2] = complex->stride[1] * (cell)complex->size[1];
    complex->count = (size_t)complex->size[0] * (size_t)complex->size[1] *
                     (size_t)complex->size[2];
    complex->cells = memory_new(complex->count);
    complex_fill(complex, voxels);
    return complex;
}

void complex_free(struct complex *complex)
{
    if (!complex)
        return;
    memory_free(complex->cells);
    memory_free(complex);
}

int cell_closure(const struct complex *complex, cell c,
                 cell closure[CLOSURE_MAX])
{
    int count = 1;
    closure[0] = c;
    for (int axis = 0; axis < 3; axis++) {
        int before = count;
        if (!(c >> axis & 1))
            continue;
        for (int i = 0; i < before; i++) {
            closure[count++] = cell_low_face(closure[i], axis);
            closure[count++] = cell_high_face(complex, closure[i], axis);
        }
    }
    return count;
}

struct complex_counts complex_count(const struct complex *complex)
{
    struct complex_counts counts = { { 0, 0, 0, 0 } };
    for (size_t i = 0; i < complex->count; i++)
        for (cell axes = 0; complex->cells[i] && axes < 8; axes++)
            counts.of[cell_dimension(axes)] += complex->cells[i] >> axes & 1;
    return counts;
}

long complex_euler(const struct complex *complex)
{
    struct complex_counts counts = complex_count(complex);
    return counts.of[0] - counts.of[1] + counts.of[2] - counts.of[3];
}

void complex_place(const struct complex *complex, cell c, int place[3])
{
    for (int axis = 2; axis >= 0; axis--) {
        place[axis] = (int)(c / complex->stride[axis]) - 1;
        c %= complex->stride[axis];
    }
}
