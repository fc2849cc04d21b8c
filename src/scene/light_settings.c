/* The words of light_mesh {} and skeleton {} with their ranges: one table for
 * the parser, for options and for the words of errors. */
#include "scene/light_settings.h"

#include "scene/scene.h"

#define AT(member) offsetof(struct settings, member)
#define NUMBER(name, member, low, high, help)                                  \
    {                                                                          \
        name, FIELD_FLOAT, AT(member), low, high, help                         \
    }
#define COUNT(name, member, low, high, help)                                   \
    {                                                                          \
        name, FIELD_INTEGER, AT(member), low, high, help                       \
    }

static const char *const model_choices[] = {
    [MESH_MODEL_DIRECTIONAL] = "directional",
    [MESH_MODEL_SCALAR] = "scalar",
    NULL,
};

static const char *const shadows_choices[] = {
    [MESH_SHADOWS_AUTO] = "auto",
    [MESH_SHADOWS_SOFT] = "soft",
    [MESH_SHADOWS_SHARP] = "sharp",
    NULL,
};

static const char *const guide_choices[] = {
    [PATH_GUIDE_OFF] = "off",
    [PATH_GUIDE_SKELETON] = "skeleton",
    NULL,
};

/* mesh_value = "quality" float | "density" float | "radius" float
 *            | "interpolation" name | "model" ( "directional" | "scalar" )
 *            | "shadows" ( "auto" | "soft" | "sharp" )
 *            | "threshold" float | "levels" float | "sky" [bool] . */
const struct field light_mesh_fields[] = {
    NUMBER("quality", light_mesh.quality, 1, 10, "the knob to turn first, 5"),
    NUMBER("density", light_mesh.density, 1e-6, 1e6,
           "mesh points for one unit of length"),
    NUMBER("radius", light_mesh.radius, 1e-6, 1e6,
           "how far a mesh point is heard, in units"),
    { "interpolation", FIELD_NAME, AT(light_mesh.interpolation), 0, 0,
      "how a point is lit by the mesh points around it" },
    { "model", FIELD_CHOICE, AT(light_mesh.model), 0, 0,
      "what a mesh point holds, directional", false, model_choices },
    { "shadows", FIELD_CHOICE, AT(light_mesh.shadows), 0, 0,
      "soft, sharp where lights are points, or auto: sharp under few", false,
      shadows_choices },
    NUMBER("threshold", light_mesh.threshold, 1e-4, 1,
           "new points where neighbours differ by more, 0.2"),
    COUNT("levels", light_mesh.levels, 1, 6,
          "how often the distance of points is halved for that, 2"),
    { "sky", FIELD_BOOL, AT(light_mesh.sky), 0, 0,
      "sky and background light the scene, in place of 'ambient' (off)" },
    { NULL },
};

/* indirect_value = "samples" float | "bounces" float
 *                | "skeleton" [bool] . */
const struct field indirect_fields[] = {
    COUNT("samples", light_mesh.indirect.samples, 1, 1000000,
          "rays that gather light at a mesh point"),
    COUNT("bounces", light_mesh.indirect.bounces, 1, 20,
          "from surface to surface"),
    { "skeleton", FIELD_BOOL, AT(light_mesh.indirect.skeleton), 0, 0,
      "the skeleton's light ends the last bounce (on)" },
    { NULL },
};

/* skeleton_value = "resolution" float | "heuristic" name . */
const struct field skeleton_fields[] = {
    COUNT("resolution", skeleton.resolution, 8, 2048,
          "voxels along the scene's longest side, 128; ends of bounces 48"),
    { "heuristic", FIELD_NAME, AT(skeleton.heuristic), 0, 0,
      "how light is estimated along the skeleton" },
    { NULL },
};

const struct field light_option_fields[] = {
    { "indirect", FIELD_BOOL, AT(light_mesh.indirect.on) },
    { "save", FIELD_NAME, AT(light_mesh.save_file) },
    { "guide", FIELD_CHOICE, AT(skeleton.guide), 0, 0, NULL, false,
      guide_choices },
    { "load", FIELD_NAME, AT(light_mesh.load_file) },
    { "only", FIELD_FLAG, AT(light_mesh.only) },
    { "skeleton_save", FIELD_NAME, AT(skeleton.save_file) },
    { NULL },
};

void light_said_add(struct light_said *said, const struct field *field,
                    struct span place)
{
    size_t i = 0;
    while (i < said->count && said->fields[i] != field)
        i++;
    if (i == LIGHT_SAID_LIMIT)
        return;
    said->fields[i] = field;
    said->places[i] = place;
    said->count += i == said->count;
}

void light_place(struct settings *settings, const struct field *field,
                 struct span place)
{
    if (field->offset == AT(light_mesh.interpolation))
        settings->light_mesh.interpolation_place = place;
    else if (field->offset == AT(skeleton.heuristic))
        settings->skeleton.heuristic_place = place;
}

void light_said_apply(const struct light_said *said,
                      const struct settings *values, struct settings *settings)
{
    for (size_t i = 0; i < said->count; i++) {
        field_copy(said->fields[i], settings, values);
        light_place(settings, said->fields[i], said->places[i]);
    }
}
