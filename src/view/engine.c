/* Wishes come true: see engine.h. */
#include "view/engine.h"

#include <stdlib.h>
#include <string.h>

#include "base/memory.h"
#include "base/parallel.h"
#include "view/drawing.h"
#include "view/question.h"

struct engine {
    SDL_mutex *lock; /* of all up to `stop` */
    SDL_cond *wished;
    struct wish wish;
    unsigned number; /* of it */
    unsigned jobs;   /* enum engine_job */
    double at[2];    /* of a question */
    struct engine_status status;
    struct file_list files;    /* not yet taken; arena NULL: none */
    struct model *model;       /* for engine_model */
    struct heritage *heritage; /* only the thread changes it */
    atomic_int stop, quit;

    /* Of the thread alone: */
    int argc;
    char **argv;
    struct canvas *canvas;
    struct background *thread;
    unsigned done; /* number of the wish that was worked on */
    struct wish at_work;
    unsigned read;           /* of the last reading, */
    bool tried;              /* if there was one */
    struct drawing *drawing; /* what is seen, or NULL */
    char *said;              /* what was printed last */
    FILE *said_file;
    size_t said_size;
    char last[ENGINE_TEXT];
};

static void engine_set(struct engine *engine, enum engine_stage stage)
{
    SDL_LockMutex(engine->lock);
    engine->status.stage = stage;
    engine->status.share = 0;
    SDL_UnlockMutex(engine->lock);
}

static void engine_stage(void *told, enum drawing_stage stage)
{
    static const enum engine_stage stages[] = {
        [DRAWING_BUILD] = ENGINE_BUILDING,
        [DRAWING_COARSE] = ENGINE_ROUGH,
        [DRAWING_LIGHT] = ENGINE_LIGHTING,
        [DRAWING_PIXELS] = ENGINE_DRAWING,
    };
    engine_set(told, stages[stage]);
}

static void engine_share(void *told, double share)
{
    struct engine *engine = told;
    SDL_LockMutex(engine->lock);
    if (share > engine->status.share)
        engine->status.share = share;
    SDL_UnlockMutex(engine->lock);
}

/* The scene can be seen: from now on it is asked. */
static void engine_seen(void *told)
{
    struct engine *engine = told;
    struct drawing *drawing = engine->drawing;
    SDL_LockMutex(engine->lock);
    struct model *before = engine->model;
    size_t lamps;
    world_lights(drawing->model->world, &lamps);
    engine->model = model_use(drawing->model);
    if (engine->number == engine->done) /* else it is an old wish's */
        engine->status.first = drawing->first;
    engine->status.lamps = (int)lamps;
    SDL_UnlockMutex(engine->lock);
    model_leave(before);
}

/* Messages are kept for the window, and printed once. */
static struct diag engine_listen(struct engine *engine)
{
    struct diag diag = diag_new();
    engine->said = NULL;
    engine->said_file = open_memstream(&engine->said, &engine->said_size);
    diag.out = engine->said_file;
    diag.program = "glim-view";
    return diag;
}

static void engine_heard(struct engine *engine, bool again)
{
    if (engine->said_file)
        fclose(engine->said_file);
    const char *said = engine->said ? engine->said : "";
    bool same = strncmp(engine->last, said, ENGINE_TEXT - 1) == 0;
    if (said[0] && (again || !same)) {
        fputs(said, stderr);
        fflush(stderr);
    }
    snprintf(engine->last, sizeof engine->last, "%s", said);
    SDL_LockMutex(engine->lock);
    if (!same)
        engine->status.texts++;
    snprintf(engine->status.text, sizeof engine->status.text, "%s", said);
    SDL_UnlockMutex(engine->lock);
    free(engine->said);
    engine->said = NULL;
    engine->said_file = NULL;
}

/* The command line and what the window added, before a "--". */
static struct drawing *engine_options(struct engine *engine, struct diag *diag)
{
    struct wish *wish = &engine->at_work;
    int count = engine->argc + wish->word_count, used = 0, before = 0;
    char **words = memory_new(((size_t)count + 1) * sizeof *words);
    while (before < engine->argc && strcmp(engine->argv[before], "--") != 0)
        words[used++] = engine->argv[before++];
    for (int i = 0; i < wish->word_count; i++)
        words[used++] = wish->words[i];
    while (before < engine->argc)
        words[used++] = engine->argv[before++];
    struct drawing *drawing = drawing_new(count, words, diag);
    memory_free(words);
    return drawing;
}

/* Tells what was read, to be watched. */
static void engine_files_read(struct engine *engine,
                              const struct file_list *read)
{
    struct file_list files = { .arena = arena_new(0) };
    file_list_take(&files, read);
    SDL_LockMutex(engine->lock);
    struct arena *before = engine->files.arena;
    engine->files = files;
    SDL_UnlockMutex(engine->lock);
    if (before)
        arena_free(before);
}

/* Whether the text must be read for this wish: it has changed, or options may
 * have changed what it says. */
static bool engine_must_read(const struct engine *engine,
                             const struct wish *before)
{
    const struct wish *wish = &engine->at_work;
    return !engine->drawing || engine->read != wish->read ||
           wish->frame != before->frame ||
           wish->word_count != before->word_count ||
           memcmp(wish->words, before->words, sizeof wish->words) != 0 ||
           memcmp(&wish->changes, &before->changes, sizeof wish->changes) != 0;
}

static void engine_describe(struct engine *engine,
                            const struct drawing *drawing)
{
    const struct options *options = &drawing->options;
    struct engine_status *status = &engine->status;
    SDL_LockMutex(engine->lock);
    status->width = options->render.width;
    status->height = options->render.height;
    status->frames = frames_count(&options->frames);
    status->frame_number = drawing->frame;
    status->lighting = options->lighting->name;
    snprintf(status->output, sizeof status->output, "%s",
             options->output ? options->output : "");
    SDL_UnlockMutex(engine->lock);
}

/* The drawing of the wish, its scene read. NULL if something is wrong, or
 * another is wished for. */
static struct drawing *engine_read(struct engine *engine, bool read,
                                   struct diag *diag)
{
    const struct wish *wish = &engine->at_work;
    struct drawing *drawing = engine_options(engine, diag);
    if (!drawing)
        return NULL;
    const struct frames *frames = &drawing->options.frames;
    int index = wish->frame < frames_count(frames) ? wish->frame : 0;
    drawing->frame = frames_number(frames, index);
    drawing->model = read ? model_read(&drawing->options, drawing->frame,
                                       &wish->changes, &engine->stop, diag)
                          : model_use(engine->drawing->model);
    if (!read) {
        drawing->files.count = 0;
        drawing->first_file = engine->drawing->first_file;
        file_list_take(&drawing->files, &engine->drawing->files);
    }
    if (!drawing->model && !atomic_load(&engine->stop) &&
        drawing->files.count > 0)
        engine_files_read(engine, &drawing->files);
    if (!drawing->model) {
        drawing_free(drawing);
        return NULL;
    }
    return drawing;
}

static void engine_adopt(struct engine *engine, struct drawing *drawing,
                         bool read)
{
    const struct wish *wish = &engine->at_work;
    if (!read && engine->drawing) {
        drawing->photons = engine->drawing->photons;
        engine->drawing->photons = NULL;
    }
    drawing_free(engine->drawing);
    engine->drawing = drawing;
    drawing->camera = wish->moved ? wish->camera : drawing->model->camera;
    engine_describe(engine, drawing);
    SDL_LockMutex(engine->lock);
    engine->status.wrong = engine->status.wrong && !read;
    engine->status.camera = drawing->model->camera;
    engine->status.models += read;
    engine->status.first = engine->status.finished = 0;
    engine->status.shown = heritage_shows(engine->heritage, &drawing->options);
    SDL_UnlockMutex(engine->lock);
    if (read)
        engine_files_read(engine, &drawing->files);
}

static void engine_failed(struct engine *engine)
{
    SDL_LockMutex(engine->lock);
    if (!atomic_load(&engine->stop)) {
        engine->status.stage = ENGINE_WRONG;
        engine->status.wrong = true;
    }
    SDL_UnlockMutex(engine->lock);
}

static void engine_light_row(void *context, const char *what, double amount,
                             const char *unit)
{
    struct engine_status *status = context;
    size_t have = strlen(status->light);
    if (strcmp(what, "mesh density") == 0)
        status->density = amount;
    bool points = strstr(what, "points") && !isnan(amount) && amount > 0;
    if (points && have < sizeof status->light)
        snprintf(status->light + have, sizeof status->light - have,
                 ", %.0f %s%s%s", amount, what, unit[0] ? " " : "", unit);
}

static void engine_finished(struct engine *engine)
{
    struct drawing *drawing = engine->drawing;
    const struct tracer *tracer = &drawing->tracer;
    struct heritage *before = engine->heritage;
    struct heritage *heritage = heritage_new(
        tracer, &drawing->options, drawing->model->lamp, &drawing->shown);
    SDL_LockMutex(engine->lock);
    engine->heritage = heritage;
    engine->status.shown = heritage_shows(heritage, &drawing->options);
    engine->status.finished = drawing->finished;
    engine->status.light[0] = '\0';
    engine->status.density = 0;
    if (tracer->lighting->tell)
        tracer->lighting->tell(tracer->lighting_state, engine_light_row,
                               &engine->status);
    engine->status.stage = ENGINE_DONE;
    SDL_UnlockMutex(engine->lock);
    heritage_leave(before);
}

static void engine_fulfil(struct engine *engine, const struct wish *before)
{
    struct diag diag = engine_listen(engine);
    bool again = engine->tried && engine->read != engine->at_work.read;
    bool read = engine_must_read(engine, before);
    engine_set(engine, ENGINE_READING);
    struct drawing *drawing = engine_read(engine, read, &diag);
    bool done = false;
    if (drawing || !atomic_load(&engine->stop)) {
        engine->tried = true;
        engine->read = engine->at_work.read;
    }
    if (drawing) {
        const struct drawing_context context = {
            .canvas = engine->canvas,
            .stop = &engine->stop,
            .quit = &engine->quit,
            .before = engine->heritage,
            .diag = &diag,
            .told = engine,
            .stage = engine_stage,
            .share = engine_share,
            .seen = engine_seen,
        };
        engine_adopt(engine, drawing, read);
        done = drawing_run(drawing, &context);
    }
    bool stopped = atomic_load(&engine->stop);
    if (!stopped || diag.errors > 0)
        engine_heard(engine, again);
    else {
        fclose(engine->said_file);
        free(engine->said);
    }
    if (done)
        engine_finished(engine);
    else if (!stopped)
        engine_failed(engine);
}

/* Whether the picture is no longer that of the file. */
static bool engine_own(const struct wish *wish)
{
    return wish->moved || wish->changes.lamp || wish->changes.region_count;
}

/* Saves, answers; the drawing is finished. */
static void engine_serve(struct engine *engine, unsigned jobs,
                         const double at[2])
{
    char *said = NULL;
    size_t size;
    const struct drawing *drawing = engine->drawing;
    const struct options *options = &drawing->options;
    struct arena *arena = arena_new(0);
    FILE *out = open_memstream(&said, &size);
    struct diag diag = { .out = out, .program = "glim-view" };
    char notice[ENGINE_NOTICE] = "";
    if (jobs & ENGINE_ASK)
        question_answer(drawing, at[0], at[1], out, notice, sizeof notice);
    const char *name =
        frames_name(&options->frames, drawing->frame, options->output, arena);
    if (jobs & ENGINE_SAVE && !name)
        fputs("nothing is saved: no picture file by the options\n", out);
    else if (jobs & ENGINE_SAVE &&
             drawing_save(drawing, name, engine_own(&engine->at_work), &diag))
        fprintf(out, "saved %s\n", name);
    fclose(out);
    SDL_LockMutex(engine->lock);
    engine->status.answers++;
    engine->status.asked = engine->jobs != 0;
    snprintf(engine->status.answer, sizeof engine->status.answer, "%s", said);
    snprintf(engine->status.notice, sizeof engine->status.notice, "%.*s",
             (int)strcspn(notice[0] ? notice : said, "\n"),
             notice[0] ? notice : said);
    SDL_UnlockMutex(engine->lock);
    free(said);
    arena_free(arena);
}

/* Called and returns with the lock held: one wish, or the jobs. */
static void engine_turn(struct engine *engine)
{
    if (engine->number != engine->done) {
        struct wish *before = memory_new(sizeof *before);
        *before = engine->at_work;
        engine->at_work = engine->wish;
        engine->done = engine->status.number = engine->number;
        atomic_store(&engine->stop, 0);
        SDL_UnlockMutex(engine->lock);
        engine_fulfil(engine, before);
        memory_free(before);
        SDL_LockMutex(engine->lock);
        return;
    }
    unsigned jobs = engine->jobs;
    double at[2] = { engine->at[0], engine->at[1] };
    engine->jobs = 0;
    SDL_UnlockMutex(engine->lock);
    engine_serve(engine, jobs, at);
    SDL_LockMutex(engine->lock);
}

static bool engine_idle(const struct engine *engine)
{
    bool jobs = engine->jobs && engine->drawing && engine->drawing->image;
    return engine->number == engine->done && !jobs;
}

static void engine_work(void *context)
{
    struct engine *engine = context;
    SDL_LockMutex(engine->lock);
    for (;;) {
        while (!atomic_load(&engine->quit) && engine_idle(engine))
            SDL_CondWait(engine->wished, engine->lock);
        if (atomic_load(&engine->quit))
            break;
        engine_turn(engine);
    }
    SDL_UnlockMutex(engine->lock);
}

struct engine *engine_start(int argc, char **argv, struct canvas *canvas)
{
    struct engine *engine = memory_new(sizeof *engine);
    engine->lock = SDL_CreateMutex();
    engine->wished = SDL_CreateCond();
    engine->argc = argc;
    engine->argv = argv;
    engine->canvas = canvas;
    engine->number = 1;
    engine->status.number = 1;
    engine->thread = background_start(engine_work, engine);
    if (engine->thread)
        return engine;
    engine_end(engine);
    return NULL;
}

void engine_end(struct engine *engine)
{
    SDL_LockMutex(engine->lock);
    atomic_store(&engine->quit, 1);
    atomic_store(&engine->stop, 1);
    SDL_CondSignal(engine->wished);
    SDL_UnlockMutex(engine->lock);
    background_join(engine->thread);
    drawing_free(engine->drawing);
    model_leave(engine->model);
    heritage_leave(engine->heritage);
    if (engine->files.arena)
        arena_free(engine->files.arena);
    SDL_DestroyCond(engine->wished);
    SDL_DestroyMutex(engine->lock);
    memory_free(engine);
}

unsigned engine_wish(struct engine *engine, const struct wish *wish)
{
    SDL_LockMutex(engine->lock);
    engine->wish = *wish;
    unsigned number = ++engine->number;
    engine->status.number = number;
    engine->status.stage = ENGINE_READING;
    engine->status.first = 0;
    atomic_store(&engine->stop, 1);
    SDL_CondSignal(engine->wished);
    SDL_UnlockMutex(engine->lock);
    return number;
}

void engine_do(struct engine *engine, enum engine_job job, double x, double y)
{
    SDL_LockMutex(engine->lock);
    engine->jobs |= (unsigned)job;
    engine->status.asked = true;
    if (job == ENGINE_ASK) {
        engine->at[0] = x;
        engine->at[1] = y;
    }
    SDL_CondSignal(engine->wished);
    SDL_UnlockMutex(engine->lock);
}

void engine_look(struct engine *engine, struct engine_status *status)
{
    SDL_LockMutex(engine->lock);
    *status = engine->status;
    SDL_UnlockMutex(engine->lock);
}

struct model *engine_model(struct engine *engine)
{
    SDL_LockMutex(engine->lock);
    struct model *model = model_use(engine->model);
    SDL_UnlockMutex(engine->lock);
    return model;
}

bool engine_value(struct engine *engine, const struct camera *camera,
                  const double at[2], const int size[2], char *text,
                  size_t text_size)
{
    SDL_LockMutex(engine->lock);
    struct heritage *heritage = heritage_use(engine->heritage);
    SDL_UnlockMutex(engine->lock);
    bool found =
        heritage && heritage_value(heritage, camera, at, size, text, text_size);
    heritage_leave(heritage);
    return found;
}

bool engine_files(struct engine *engine, struct file_list *files)
{
    SDL_LockMutex(engine->lock);
    *files = engine->files;
    engine->files = (struct file_list){ .arena = NULL };
    SDL_UnlockMutex(engine->lock);
    return files->arena;
}
