/* X(name, role): name.c has the finish item, name_finish. Roles: `highlight`
 * and `tint` are items with that function, `plain` are all others. The order is
 * that of fingerprints (scene/fields.c): new ones come last. */
X(ambient, plain)
X(emission, plain)
X(diffuse, plain)
X(brilliance, plain)
X(phong, highlight)
X(specular, highlight)
X(metallic, plain)
X(crand, plain)
X(conserve_energy, plain)
X(old_interior, plain)
X(reflection, plain)
X(old_filter, plain)
X(irid, tint)
X(subsurface, plain)
