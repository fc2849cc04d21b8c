/* One row for each integrator: X(name) stands for name_integrator, defined in
 * tracer/integrator/name.c. The first asks whatever lighting there is. */
X(recursive)
X(path)
