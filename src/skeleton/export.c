/* Files of the skeleton: see export.h. PLY is that of Greg Turk (1994); OBJ has
 * colours after the coordinates, as many programs read them. */
#include "skeleton/export.h"

#include "base/memory.h"
#include "base/text.h"
#include "base/writer.h"
#include "image/ramp.h"
#include "shade/surface.h"
#include "skeleton/field.h"

struct export
{
    struct writer text;
    const struct skeleton *skeleton;
    const struct skeleton_light *light;
    struct ramp_range range; /* of brightness */
};

/* What a line says of a node, beside its place and radius. */
struct node_words {
    rgb light;
    vec3 direction;  /* unit, or zero */
    float colour[3]; /* on the ramp */
};

static struct node_words export_node(const struct export *out, size_t i)
{
    const struct skeleton_light *light = &out->light[i];
    struct node_words words = { .light = light->arriving };
    if (vec3_length(light->stream) > 0)
        words.direction = vec3_normalise(light->stream);
    ramp_colour(RAMP_SPECTRUM,
                ramp_range_place(&out->range, rgb_brightness(light->arriving)),
                words.colour);
    return words;
}

/* Each edge once, by the numbers of its nodes plus `base`. */
static size_t export_edges(struct export *out, const char *format,
                           unsigned base)
{
    const struct graph *graph = out->skeleton->graph;
    size_t count = 0;
    for (uint32_t i = 0; i < graph->count; i++)
        for (uint32_t k = graph->first[i]; k < graph->first[i + 1]; k++) {
            uint32_t other = graph->neighbours[k];
            if (other <= i)
                continue;
            count++;
            if (format)
                writer_print(&out->text, format, i + base, other + base);
        }
    return count;
}

static void export_ply(struct export *out)
{
    const struct graph *graph = out->skeleton->graph;
    static const char *const properties[] = {
        "float x",
        "float y",
        "float z",
        "float radius",
        "uchar red",
        "uchar green",
        "uchar blue",
        "float irradiance",
        "float irradiance_red",
        "float irradiance_green",
        "float irradiance_blue",
        "float nx",
        "float ny",
        "float nz",
    };
    writer_print(&out->text,
                 "ply\nformat ascii 1.0\ncomment skeleton of the void by glim; "
                 "nx ny nz: where light comes from\nelement vertex %zu\n",
                 graph->count);
    for (size_t i = 0; i < sizeof properties / sizeof *properties; i++)
        writer_print(&out->text, "property %s\n", properties[i]);
    writer_print(&out->text,
                 "element edge %zu\nproperty int vertex1\nproperty int "
                 "vertex2\nend_header\n",
                 export_edges(out, NULL, 0));
    for (size_t i = 0; i < graph->count; i++) {
        vec3 at = graph->nodes[i].position;
        struct node_words n = export_node(out, i);
        writer_print(&out->text,
                     "%.7g %.7g %.7g %.7g %.0f %.0f %.0f %.7g %.7g %.7g %.7g "
                     "%.5f %.5f %.5f\n",
                     at.x, at.y, at.z, graph->nodes[i].radius,
                     255 * (double)n.colour[0], 255 * (double)n.colour[1],
                     255 * (double)n.colour[2], rgb_brightness(n.light),
                     n.light.r, n.light.g, n.light.b, n.direction.x,
                     n.direction.y, n.direction.z);
    }
    export_edges(out, "%u %u\n", 0);
}

static void export_obj(struct export *out)
{
    const struct graph *graph = out->skeleton->graph;
    writer_print(&out->text, "# skeleton of the void by glim\n");
    for (size_t i = 0; i < graph->count; i++) {
        vec3 at = graph->nodes[i].position;
        struct node_words n = export_node(out, i);
        writer_print(&out->text, "v %.7g %.7g %.7g %.4f %.4f %.4f\n", at.x,
                     at.y, at.z, (double)n.colour[0], (double)n.colour[1],
                     (double)n.colour[2]);
    }
    export_edges(out, "l %u %u\n", 1);
}

static void export_csv(struct export *out)
{
    const struct graph *graph = out->skeleton->graph;
    writer_print(&out->text, "x,y,z,radius,red,green,blue,nx,ny,nz,part\n");
    for (size_t i = 0; i < graph->count; i++) {
        vec3 at = graph->nodes[i].position;
        struct node_words n = export_node(out, i);
        writer_print(&out->text,
                     "%.7g,%.7g,%.7g,%.7g,%.7g,%.7g,%.7g,%.5f,%.5f,%.5f,%u\n",
                     at.x, at.y, at.z, graph->nodes[i].radius, n.light.r,
                     n.light.g, n.light.b, n.direction.x, n.direction.y,
                     n.direction.z, graph->part[i]);
    }
}

typedef void export_write(struct export *out);

/* The format of a name's end, or NULL. */
static export_write *export_find(const char *path)
{
    static const struct {
        const char *end;
        export_write *write;
    } formats[] = {
        { ".ply", export_ply },
        { ".obj", export_obj },
        { ".csv", export_csv },
    };
    size_t length = strlen(path);
    for (size_t i = 0; length > 4 && i < sizeof formats / sizeof *formats; i++)
        if (text_equal_nocase(path + length - 4, formats[i].end))
            return formats[i].write;
    return NULL;
}

bool skeleton_can_save(const char *path)
{
    return export_find(path);
}

bool skeleton_save(const struct skeleton *skeleton, const char *path,
                   struct diag *diag)
{
    char why[256] = "its name must end in .ply, .obj or .csv";
    export_write *write = export_find(path);
    bool done = false;
    if (write) {
        struct skeleton_light *light = skeleton_field(skeleton);
        if (!light)
            return false;
        struct export out = { .text = writer_new(),
                              .skeleton = skeleton,
                              .light = light,
                              .range = { .logarithmic = true } };
        for (size_t i = 0; i < skeleton->graph->count; i++)
            ramp_range_add(&out.range, rgb_brightness(light[i].arriving));
        write(&out);
        done = writer_save(&out.text, path, why, sizeof why);
        writer_free(&out.text);
        memory_free(light);
    }
    if (!done)
        diag_print(diag, DIAG_ERROR, span_none(), NULL,
                   "can't write the skeleton '%s': %s", path, why);
    return done;
}
