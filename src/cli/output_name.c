/* Names of picture files: see output_name.h. */
#include "cli/output_name.h"

#include "base/directory.h"
#include "base/text.h"

static const struct output_type types[] = {
    { 'N', ".png", "png", "PNG, 1 to 16 bits" },
    { 'E', ".exr", "openexr",
      "OpenEXR, linear light; half floats, +FE32 floats" },
    { 'H', ".hdr", "hdr", "Radiance HDR, linear light" },
    { 'J', ".jpg", "jpeg", "JPEG; Compression is its quality" },
    { 'P', ".ppm", "pnm", "PPM, 1 to 16 bits; PGM when grey" },
    { 'T', ".tga", "targa", "Targa" },
    { 'C', ".tga", "targa", "Targa, run-length coded" },
    { 'B', ".bmp", "bmp", "Windows bitmap" },
};

enum { TYPE_COUNT = sizeof types / sizeof *types };

const struct output_type *output_type_at(size_t index)
{
    return index < TYPE_COUNT ? &types[index] : NULL;
}

const struct output_type *output_type_find(char letter)
{
    const char name[] = { letter, '\0' };
    for (size_t i = 0; i < TYPE_COUNT; i++)
        if (text_equal_nocase((char[]){ types[i].letter, '\0' }, name))
            return &types[i];
    return NULL;
}

const struct output_type *output_type_meant(const char *name,
                                            const struct output_type *type)
{
    const char *extension = name + output_stem(name);
    for (size_t i = 0; i < TYPE_COUNT; i++)
        if (text_equal_nocase(extension, types[i].extension) &&
            strcmp(types[i].extension, type->extension) != 0)
            return &types[i];
    if (text_equal_nocase(extension, ".jpeg") && type->letter != 'J')
        return output_type_find('J');
    return NULL;
}

const char *output_type_lacking(const char *name)
{
    static const char *const lacking[] = { ".gif", ".tif",  ".tiff", ".webp",
                                           ".jp2", ".avif", ".jxl" };
    const char *extension = name + output_stem(name);
    for (size_t i = 0; i < sizeof lacking / sizeof *lacking; i++)
        if (text_equal_nocase(extension, lacking[i]))
            return lacking[i];
    return NULL;
}

size_t output_stem(const char *name)
{
    const char *part = text_last_part(name);
    const char *dot = strrchr(part, '.');
    if (!dot || dot == part)
        return strlen(name);
    return (size_t)(dot - name);
}

bool output_is_folder(const char *output)
{
    const char *last = text_last_part(output);
    return strcmp(last, "") == 0 || strcmp(last, ".") == 0 ||
           strcmp(last, "..") == 0;
}

bool output_is_fixed(const char *output)
{
    return strcmp(output, "-") == 0 || strcmp(output, "/dev/stdout") == 0 ||
           path_is_special(output);
}

const char *output_name(const char *output, const char *input,
                        const struct output_type *type, struct arena *arena)
{
    if (output && output_is_fixed(output))
        return output;
    if (!output || output_is_folder(output)) {
        const char *scene = output ? text_last_part(input) : input;
        const char *slash = output && *text_last_part(output) ? "/" : "";
        return arena_printf(arena, "%s%s%.*s%s", output ? output : "", slash,
                            (int)output_stem(scene), scene, type->extension);
    }
    size_t stem = output_stem(output);
    if (strcmp(output + stem, type->extension) == 0)
        return output;
    return arena_printf(arena, "%s%s", output, type->extension);
}
