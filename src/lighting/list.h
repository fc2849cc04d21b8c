/* One row for each lighting method: X(name) stands for name_lighting, defined
 * in lighting/name.c. The first is the default. */
X(mesh)
X(rays)
X(skeleton)
X(paper)
