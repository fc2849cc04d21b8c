/* What one call of glim draws: the frames of an animation or one picture, and
 * what they share. */
#ifndef CLI_WORK_H
#define CLI_WORK_H

#include <limits.h>

#include "base/writer.h"
#include "cli/depend.h"
#include "cli/kept.h"
#include "cli/moment.h"
#include "cli/options.h"
#include "cli/part.h"
#include "cli/picture.h"
#include "cli/probe_file.h"
#include "cli/progress.h"
#include "lighting/lighting.h"

/* What becomes of it: the exit status. */
enum work_status { WORK_DONE = 0, WORK_FAILED = 1, WORK_INTERRUPTED = 2 };

struct work {
    struct options options;
    const struct source *source;
    int number;                      /* of the frame that is drawn, */
    const struct lighting *lighting; /* of its scene */
    struct probe_file points;        /* of --probe */
    struct lighting_kept kept;       /* by the root of all frames, and them */
    struct lighting_kept last;       /* for --mesh-save, if that is not it */
    bool root_tried;                 /* to begin that one's lighting */
    bool smooths; /* whether frames do, by the light of those around them: */
    struct moment around[LIGHTING_MOMENTS]; /* these, by number */
    size_t first_file;            /* of options.parse.asked, for the scene */
    struct targets targets;       /* of --depend: pictures, kept or drawn */
    struct kept pictures;         /* by +C */
    struct writer origin;         /* of the frame's picture */
    struct part part;             /* of it, that is drawn */
    char left[PATH_MAX];          /* the part file that +C goes on with */
    struct unfinished unfinished; /* picture, if the work was stopped */
    struct progress progress;
    const atomic_int *stop;
    struct diag diag;
    struct arena *arena;
};

/* Draws all frames; the options have been read. Errors are printed. */
enum work_status work_run(struct work *work);

/* --join without a name: of all frames' parts. */
enum work_status work_join(struct work *work);

#endif
