/* What blocks of a scene say, a row for each member of the struct that they
 * fill: parse/ reads the rows whose name is a word of the language,
 * fingerprints and world/light_table.c take the numbers of all. Names with a
 * space are of what has a form of its own. */
#ifndef SCENE_FIELDS_H
#define SCENE_FIELDS_H

#include "base/field.h"

/* Of struct light; the second of those that shine into a direction. */
extern const struct field lamp_kind_fields[];
extern const struct field directed_fields[];
extern const struct field lamp_fields[];
extern const struct field lamp_photon_fields[]; /* no mesh holds those */

extern const struct field interior_fields[];
extern const struct field scattering_fields[]; /* of struct medium; and */
extern const struct field medium_fields[];
extern const struct field fog_fields[];
extern const struct field fog_turbulence_fields[]; /* of struct fog */
extern const struct field normal_fields[];

/* Nothing is read by these. */
extern const struct field pattern_said[]; /* with struct turbulence */
extern const struct field image_map_said[];
extern const struct field warp_said[];

#endif
