/* See mesh_known.h. */
#include "lighting/mesh_known.h"

#include <errno.h>
#include <string.h>

#include "base/map.h"
#include "lightmesh/tuning.h"

/* What a camera in a chamber asked for, one outside takes, which doesn't know
 * what lights that. */
static bool frame_from_inside(const struct mesh_frame *made,
                              const struct mesh_frame *now)
{
    return made->closed && !now->closed;
}

static bool kept_find(struct mesh_known *known, const struct mesh_stamp *wanted,
                      const struct lighting_kept *kept)
{
    char text[200];
    if (!kept || !kept->bytes ||
        !mesh_file_open(&known->file, kept->bytes, kept->size, text,
                        sizeof text) ||
        !mesh_stamp_same(&known->file.stamp, wanted, text, sizeof text))
        return false;
    const struct mesh_frame *made = &known->file.stamp.frame,
                            *now = &wanted->frame;
    known->levels = plan_levels(made, now);
    return fabs(known->levels.direct) <= KEPT_LEVELS &&
           (frame_from_inside(made, now) ||
            now->asked <= kept_rays * made->asked);
}

static bool file_find(struct mesh_known *known, const struct mesh_stamp *wanted,
                      struct diag *diag)
{
    char text[300];
    known->map = map_open(known->name);
    if (!known->map) {
        diag_print(diag, DIAG_ERROR, span_none(), NULL,
                   "can't read the light mesh '%s': %s", known->name,
                   errno == EISDIR   ? "it is a directory"
                   : errno == EINVAL ? "it is empty, or not a regular file"
                                     : strerror(errno));
        return false;
    }
    if (!mesh_file_open(&known->file, map_bytes(known->map),
                        map_size(known->map), text, sizeof text)) {
        diag_print(diag, DIAG_ERROR, span_none(), NULL,
                   "can't use the light mesh '%s': %s; make one with "
                   "--mesh-save FILE",
                   known->name, text);
        return false;
    }
    if (mesh_stamp_same(&known->file.stamp, wanted, text, sizeof text))
        return true;
    diag_print(diag, DIAG_ERROR, span_none(), NULL,
               "the light mesh '%s' is stale: %s; make it again with "
               "--mesh-save FILE",
               known->name, text);
    return false;
}

bool mesh_known_find(struct mesh_known *known, const struct mesh_stamp *wanted,
                     const struct lighting_options *options, const char *file,
                     struct diag *diag)
{
    *known = (struct mesh_known){ 0 };
    if (options->kept_use != KEPT_SAME)
        known->found = kept_find(known, wanted, options->kept);
    if (options->kept_use == KEPT_ONLY)
        return known->found;
    if (known->found || !file)
        return true;
    known->name = file;
    known->found = file_find(known, wanted, diag);
    return known->found;
}

bool mesh_known_root(const struct mesh_stamp *wanted,
                     const struct lighting_options *options,
                     struct mesh_frame *root)
{
    char text[200];
    struct mesh_file file;
    const struct lighting_kept *kept = options->kept;
    if (!options->root || !kept || !kept->bytes ||
        !mesh_file_open(&file, kept->bytes, kept->size, text, sizeof text) ||
        !mesh_stamp_alike(&file.stamp, wanted) ||
        mesh_stamp_same(&file.stamp, wanted, text, sizeof text))
        return false;
    *root = file.stamp.frame;
    return true;
}

bool mesh_known_same(struct mesh_known *known, const struct mesh_stamp *made,
                     const struct lighting_options *options)
{
    if (options->kept_use == KEPT_SAME && !known->found)
        known->found =
            kept_find(known, made, options->kept) &&
            mesh_stamp_family(&known->file.stamp) == mesh_stamp_family(made);
    return known->found;
}

bool mesh_known_fill(const struct mesh_known *known,
                     const struct point_mesh *const *meshes, size_t count,
                     struct diag *diag)
{
    if (!known->found ||
        mesh_file_fill(&known->file, meshes, count, known->name ? 1 : kept_full,
                       known->map))
        return true;
    diag_print(diag, DIAG_ERROR, span_none(), NULL,
               "can't use the light mesh '%s': its points hold something else; "
               "make it again with --mesh-save FILE",
               known->name ? known->name : "of the picture before");
    return false;
}

void mesh_known_end(struct mesh_known *known)
{
    map_release(known->map);
}
