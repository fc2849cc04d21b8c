/* All frames: see work.h. */
#include "cli/work.h"

#include "base/save.h"
#include "cli/frame.h"

/* --mesh-save, after the last frame. */
static bool work_save(struct work *work)
{
    const char *name = work->options.light.light_mesh.save_file;
    const struct lighting_kept *kept =
        work->last.bytes ? &work->last : &work->kept;
    char why[256];
    if (!name || work->options.action != ACTION_RENDER)
        return true;
    if (!kept->bytes)
        diag_print(&work->diag, DIAG_WARNING, span_none(), NULL,
                   "nothing was rendered: the light mesh '%s' is not written",
                   name);
    else if (!save_bytes(name, kept->bytes, kept->size, why, sizeof why)) {
        diag_print(&work->diag, DIAG_ERROR, span_none(), NULL,
                   "can't write the light mesh '%s': %s", name, why);
        return false;
    }
    return true;
}

enum work_status work_join(struct work *work)
{
    const struct options *options = &work->options;
    const struct frames *frames = &options->frames;
    enum work_status status = WORK_DONE;
    if (!options->output || strcmp(options->output, "-") == 0) {
        diag_print(&work->diag, DIAG_ERROR, span_none(), NULL,
                   "--join wants a picture with a name");
        return WORK_FAILED;
    }
    for (int i = 0; i < frames_count(frames); i++)
        if (!part_join(frames_name(frames, frames_number(frames, i),
                                   options->output, work->arena),
                       &work->diag))
            status = WORK_FAILED;
    return status;
}

enum work_status work_run(struct work *work)
{
    struct arena *arena = work->arena;
    const char *problem = NULL;
    const struct frames *frames = &work->options.frames;
    work->first_file = work->options.parse.asked->count;
    file_list_add(work->options.parse.asked, work->options.path);
    work->source =
        source_read(arena, work->options.path, span_none(), &problem);
    if (!work->source && atomic_load(work->stop)) {
        progress_interrupted(frames, 0, &work->unfinished, work->left);
        return WORK_INTERRUPTED;
    }
    if (!work->source) {
        diag_print(&work->diag, DIAG_ERROR, span_none(), NULL,
                   "can't read the scene '%s': %s", work->options.path,
                   problem);
        return WORK_FAILED;
    }
    if (work->options.probe)
        file_list_add(work->options.parse.asked, work->options.probe);
    if (work->options.probe && work->options.action == ACTION_RENDER &&
        !probe_file_read(&work->points, work->options.probe, arena,
                         &work->diag))
        return WORK_FAILED;
    if (!depend_can_be(&work->options, arena, &work->diag) ||
        !picture_can_be(work->options.light.light_mesh.save_file,
                        &work->diag) ||
        !picture_can_be(work->options.light.skeleton.save_file, &work->diag))
        return WORK_FAILED;
    for (int i = 0; i < frames_count(frames); i++) {
        enum work_status status =
            atomic_load(work->stop) ? WORK_INTERRUPTED : frame_run(work, i);
        if (status == WORK_INTERRUPTED)
            progress_interrupted(frames, i, &work->unfinished, work->left);
        if (status != WORK_DONE)
            return status;
    }
    progress_total(&work->progress, frames);
    return work_save(work) &&
                   depend_write(&work->options, &work->targets,
                                work->options.parse.asked, &work->diag)
               ? WORK_DONE
               : WORK_FAILED;
}
