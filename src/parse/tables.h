/* Field tables of blocks, each in the file that reads the block. */
#ifndef PARSE_TABLES_H
#define PARSE_TABLES_H

#include "base/field.h"

extern const struct field finish_fields[];
extern const struct field reflection_fields[];
extern const struct field film_fields[];
extern const struct field turbulence_fields[];
extern const struct field repeat_fields[];
extern const struct field hole_fields[];
extern const struct field laid_fields[];
extern const struct field setting_fields[];
extern const struct field pattern_fields[];
extern const struct field photon_fields[];
extern const struct field bicubic_fields[];
extern const struct field radiosity_used[];
extern const struct field interior_fields[];
extern const struct field medium_fields[];
extern const struct field scattering_fields[];
extern const struct field lamp_fields[];
extern const struct field directed_fields[];
extern const struct field camera_fields[];
extern const struct field blur_fields[];
extern const struct field normal_fields[];
extern const struct field fog_fields[];
extern const struct field fog_turbulence_fields[];
extern const struct field rainbow_fields[];
extern const struct field sky_fields[];
extern const struct field image_fields[];
extern const struct field image_pattern_fields[];
extern const struct field bump_fields[];

#endif
