/* One row for each interpolation: X(name) stands for name_interpolation,
 * defined in interpolation/name.c. The first is the default. */
X(trilinear)
X(nearest)
X(spherical)
X(mean)
X(smooth)
