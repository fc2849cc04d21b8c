/* What values are called. */
#include "parse/value.h"

const char *value_kind_name(enum value_kind kind)
{
    static const char *const names[] = {
        [VALUE_NONE] = "nothing",
        [VALUE_FLOAT] = "a number",
        [VALUE_VECTOR] = "a vector",
        [VALUE_COLOUR] = "a colour",
        [VALUE_STRING] = "a string",
        [VALUE_ARRAY] = "an array",
        [VALUE_MACRO] = "a macro",
        [VALUE_FUNCTION] = "a function",
        [VALUE_SPLINE] = "a spline",
        [VALUE_REFERENCE] = "a reference",
        [VALUE_OBJECT] = "an object",
        [VALUE_LIGHT_GROUP] = "a light group",
        [VALUE_TEXTURE] = "a texture",
        [VALUE_PIGMENT] = "a pigment",
        [VALUE_NORMAL] = "a normal",
        [VALUE_FINISH] = "a finish",
        [VALUE_INTERIOR] = "an interior",
        [VALUE_MATERIAL] = "a material",
        [VALUE_TRANSFORM] = "a transform",
        [VALUE_CAMERA] = "a camera",
        [VALUE_COLOUR_MAP] = "a colour_map",
        [VALUE_PIGMENT_MAP] = "a pigment_map",
        [VALUE_TEXTURE_MAP] = "a texture_map",
        [VALUE_DENSITY] = "a density",
        [VALUE_DENSITY_MAP] = "a density_map",
        [VALUE_MEDIA] = "a media",
        [VALUE_NORMAL_MAP] = "a normal_map",
        [VALUE_SLOPE_MAP] = "a slope_map",
        [VALUE_FOG] = "a fog",
        [VALUE_SKY_SPHERE] = "a sky_sphere",
        [VALUE_RAINBOW] = "a rainbow",
        [VALUE_FILE] = "an open file",
        [VALUE_POISON] = "something wrong",
    };
    return names[kind];
}
