/* POV-Ray and glim on one scene: see scene.h. Both get the same words and
 * write 16-bit files, so that no difference is lost. */
#include "compare/scene.h"

#include <errno.h>
#include <stdlib.h>
#include <unistd.h>

#include "base/array.h"
#include "base/scratch.h"
#include "cli/output_name.h"
#include "compare/program.h"

/* How much of what a failed program said is shown. */
enum { LOG_LINES = 20 };

struct scene_job {
    struct scene_pictures *pictures;
    const char *scene;
    const atomic_int *stop;
    struct arena *arena;
    struct diag *diag;
};

struct scene_program {
    const char *title, *file;
    const struct words *words; /* the user's */
    bool quotes;               /* names stand in quotes */
};

const char *scene_strip_name(const char *scene, struct arena *arena)
{
    return arena_printf(arena, "%.*s-compare.png", (int)output_stem(scene),
                        scene);
}

__attribute__((format(printf, 2, 3))) static bool
scene_fail(const struct scene_job *job, const char *format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    diag_vprint(job->diag, DIAG_ERROR, span_none(), NULL, format, arguments);
    va_end(arguments);
    return false;
}

static bool scene_make_directory(const struct scene_job *job)
{
    const char *tried;
    job->pictures->directory = scratch_make("glim-compare", job->arena, &tried);
    return job->pictures->directory ||
           scene_fail(job, "can't make a directory '%s': %s", tried,
                      strerror(errno));
}

void scene_clean(struct scene_pictures *pictures)
{
    scratch_remove(pictures->directory);
    pictures->directory = NULL;
}

/* ---- one program ------------------------------------------------------- */

static void words_add(struct arena *arena, struct words *words,
                      const char *word)
{
    *ARRAY_PUSH(arena, words) = arena_copy_text(arena, word, strlen(word));
}

/* +I, +O or +L and a name. */
static char *scene_named(const struct scene_job *job, bool quoted,
                         const char *letters, const char *name)
{
    return quoted ? program_povray_name(letters, name, job->arena)
                  : arena_printf(job->arena, "%s%s", letters, name);
}

/* Size and library first, so that the user's own win; the file last, so that
 * it is ours. */
static char *const *scene_words(const struct scene_job *job,
                                const struct scene_program *program,
                                const char *picture)
{
    static const char *const last[] = { "+FN16", "-D", "-P", "-V" };
    struct arena *arena = job->arena;
    struct words words = { NULL, 0, 0 };
    bool quoted = program->quotes;
    words_add(arena, &words, program->file);
    words_add(arena, &words, "+W640");
    words_add(arena, &words, "+H480");
    const char *slash = strrchr(job->scene, '/');
    if (slash) {
        size_t length = slash == job->scene ? 1 : (size_t)(slash - job->scene);
        const char *folder = arena_copy_text(arena, job->scene, length);
        *ARRAY_PUSH(arena, &words) = scene_named(job, quoted, "+L", folder);
    }
    for (size_t i = 0; i < program->words->count; i++)
        *ARRAY_PUSH(arena, &words) = program->words->items[i];
    *ARRAY_PUSH(arena, &words) = scene_named(job, quoted, "+I", job->scene);
    *ARRAY_PUSH(arena, &words) = scene_named(job, quoted, "+O", picture);
    for (size_t i = 0; i < sizeof last / sizeof *last; i++)
        words_add(arena, &words, last[i]);
    *ARRAY_PUSH(arena, &words) = NULL;
    return words.items;
}

/* The last lines of what it said. */
static void scene_show_log(const struct scene_job *job, const char *log)
{
    const char *problem;
    const struct source *source =
        source_read(job->arena, log, span_none(), &problem);
    if (!source || !job->diag->out)
        return;
    size_t start = source->length;
    for (int lines = 0; start > 0; start--)
        if (source->text[start - 1] == '\n' && lines++ == LOG_LINES)
            break;
    fprintf(job->diag->out, "%s", source->text + start);
}

static bool scene_run(const struct scene_job *job,
                      const struct scene_program *program, int which)
{
    struct scene_pictures *pictures = job->pictures;
    static const char *const names[] = { "povray", "glim" };
    const char *picture = arena_printf(job->arena, "%s/%s.png",
                                       pictures->directory, names[which]);
    const char *log = arena_printf(job->arena, "%s/%s.log", pictures->directory,
                                   names[which]);
    pictures->paths[which] = picture;
    char *const *words = scene_words(job, program, picture);
    enum program_end end =
        program_run(words, log, job->stop, &pictures->times[which]);
    if (end == PROGRAM_STOPPED)
        return scene_fail(job, "interrupted, nothing written");
    if (end == PROGRAM_FAILED) {
        scene_show_log(job, log);
        return scene_fail(job, "%s does not draw '%s'; it ran as %s",
                          program->title, job->scene, program->file);
    }
    if (access(picture, R_OK) == 0)
        return true;
    return scene_fail(job,
                      "%s wrote no picture of its own of '%s'; of an animation "
                      "choose one clock: type +K0.5",
                      program->title, job->scene);
}

bool scene_draw(struct scene_pictures *pictures, const struct choices *choices,
                const atomic_int *stop, struct arena *arena, struct diag *diag)
{
    *pictures = (struct scene_pictures){ .directory = NULL };
    struct scene_job job = { pictures, choices->names[0], stop, arena, diag };
    struct scene_program programs[] = {
        { "POV-Ray", program_find("POVRAY", "povray", false, arena),
          &choices->povray, true },
        { "glim", program_find("GLIM", "glim", true, arena), &choices->glim,
          false },
    };
    if (access(job.scene, R_OK) != 0)
        return scene_fail(&job, "can't read the scene '%s': %s", job.scene,
                          strerror(errno));
    if (!programs[0].file)
        return scene_fail(&job,
                          "POV-Ray is not there: install it (sudo apt install "
                          "povray), or set POVRAY to the program");
    if (!programs[1].file)
        return scene_fail(&job, "glim is not there: set GLIM to the program");
    if (!scene_make_directory(&job))
        return false;
    for (int i = 0; i < 2; i++)
        if (!scene_run(&job, &programs[i], i))
            return false;
    return true;
}
