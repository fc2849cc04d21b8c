/* The thread that reads and draws what is wished for, while the window answers.
 * The window wishes; a newer wish ends the work on the older one. */
#ifndef VIEW_ENGINE_H
#define VIEW_ENGINE_H

#include "view/canvas.h"
#include "view/model.h"

enum {
    WISH_WORDS = 48,
    WISH_WORD = 96,
    ENGINE_TEXT = 8192,
    ENGINE_NOTICE = 400
};

/* What is to be seen. */
struct wish {
    unsigned read;                     /* another number: read the text again */
    char words[WISH_WORDS][WISH_WORD]; /* options beyond the command line's */
    int word_count;
    bool moved;           /* the camera is not the file's but: */
    struct camera camera; /* this */
    int frame;            /* index of an animation's */
    struct model_changes changes;
};

enum engine_stage {
    ENGINE_READING,
    ENGINE_BUILDING,
    ENGINE_ROUGH,
    ENGINE_LIGHTING,
    ENGINE_DRAWING,
    ENGINE_DONE,
    ENGINE_WRONG, /* nothing could be drawn: `text` says why */
};

/* What is known of the wish at work; a copy. */
struct engine_status {
    unsigned number; /* of the wish: engine_wish counts them */
    enum engine_stage stage;
    double share;           /* of the drawing, 0..1 */
    double first, finished; /* seconds until something, all was seen; 0 */
    bool wrong;             /* the text or the options: the picture is old */
    unsigned texts;         /* counts what there was to say */
    char text[ENGINE_TEXT]; /* messages of the last reading */
    struct camera camera;   /* the file's */
    unsigned models;        /* counts scenes that were read */
    int lamps;              /* of the scene */
    bool shown;             /* something that engine_value can tell */
    int width, height;
    const char *lighting;
    double density;  /* of its mesh, points for a unit of length; 0: none */
    char light[160]; /* of its figures, to be shown */
    int frames, frame_number;
    char output[FILENAME_MAX];
    bool asked;                 /* something that is not done yet */
    unsigned answers;           /* counts what follows */
    char answer[ENGINE_TEXT];   /* to a question, or of a saved picture; */
    char notice[ENGINE_NOTICE]; /* the same in short */
};

/* Things to do once the picture is finished. */
enum engine_job { ENGINE_SAVE = 1, ENGINE_ASK = 2 };

struct engine;

/* Starts on what the words say. NULL if the system gives no thread. */
struct engine *engine_start(int argc, char **argv, struct canvas *canvas);

/* Leaves off, and waits for that. */
void engine_end(struct engine *engine);

/* Returns the wish's number. */
unsigned engine_wish(struct engine *engine, const struct wish *wish);

/* `x` and `y` from the top left, 0..1: of ENGINE_ASK. */
void engine_do(struct engine *engine, enum engine_job job, double x, double y);

void engine_look(struct engine *engine, struct engine_status *status);

/* The number of what is shown over the picture (--show) at (x, y), 0..1, as
 * heritage_value. */
bool engine_value(struct engine *engine, const struct camera *camera,
                  const double at[2], const int size[2], char *text,
                  size_t text_size);

/* The scene that is drawn, or NULL; left with model_leave. */
struct model *engine_model(struct engine *engine);

/* Files that were read since the last call, in a list with an arena of its own
 * that is the caller's; false: there are no new ones. */
bool engine_files(struct engine *engine, struct file_list *files);

#endif
