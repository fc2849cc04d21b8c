/* One row for each lighting method: X(name) stands for name_lighting, defined
 * in lighting/name.c. The first is the default. */
X(rays)
X(path)
X(mesh)
X(skeleton)
