/* Field tables of blocks, each in the file that reads the block, and those of
 * scene/fields.h. */
#ifndef PARSE_TABLES_H
#define PARSE_TABLES_H

#include "scene/fields.h"

extern const struct field turbulence_fields[];
extern const struct field repeat_fields[];
extern const struct field hole_fields[];
extern const struct field laid_fields[];
extern const struct field setting_fields[];
extern const struct field pattern_fields[];
extern const struct field photon_fields[];
extern const struct field bicubic_fields[];
extern const struct field radiosity_used[];
extern const struct field camera_fields[];
extern const struct field blur_fields[];
extern const struct field rainbow_fields[];
extern const struct field sky_fields[];
extern const struct field image_fields[];
extern const struct field image_pattern_fields[];
extern const struct field bump_fields[];

#endif
