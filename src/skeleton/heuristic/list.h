/* One row for each heuristic: X(name) stands for name_heuristic, defined in
 * heuristic/name.c. The first is the default. */
X(network)
X(backward)
X(forward)
