/* One row for each primitive: X(name) stands for name_primitive, defined in
 * scene/primitive/name.c. */
X(box)
X(cone)
X(cubic)
X(cylinder)
X(disc)
X(plane)
X(poly)
X(polygon)
X(quadric)
X(quartic)
X(sphere)
X(torus)
