/* One row for each knower, in the order in which they are asked: X(name) stands
 * for name_knower, defined in lightmesh/knower/name.c. */
X(pixels)
X(penumbra)
X(surfaces)
X(space)
X(rays)
