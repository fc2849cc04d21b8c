/* Reading a scene as glim does, beside the editor's questions: on a thread of
 * its own, which ends early when it is told to. */
#ifndef LANGUAGE_EVALUATION_H
#define LANGUAGE_EVALUATION_H

#include <stdatomic.h>

#include "language/page.h"
#include "text/diag.h"

enum { EVALUATION_SECONDS = 4 }; /* then it is stopped, and says so */

struct remark {
    enum diag_level level;
    const char *uri; /* NULL: nowhere */
    struct stretch range;
    const char *text, *hint; /* hint: NULL, none */
    struct remark *notes;    /* that follow it; a list */
    struct remark *next;
};

/* A name's value, the last it was given at this place. */
struct meaning {
    const char *name, *kind;
    const struct source *source;
    size_t offset;
    double numbers[5];
    int size; /* of numbers; 0: something else */
    bool colour;
    const char *text; /* of a string */
    struct meaning *next;
};

struct evaluation {
    struct evaluation *next; /* of those that nobody wants any more */
    atomic_int stop, over;
    bool late; /* stopped since it took too long */
    struct remark *remarks;
    struct arena *arena; /* of all that is told */
    struct evaluation_work *work;
};

/* Begins to read `page` with the texts that are open now. A byte is written to
 * `wake` when it is over. NULL: the system gives no thread. */
struct evaluation *evaluation_start(struct library *library, struct page *page,
                                    int wake);

/* Ends it, if need be, and frees it; NULL is none. */
void evaluation_free(struct evaluation *evaluation);

/* Waits for the end of one that is over. */
void evaluation_finish(struct evaluation *evaluation);

/* What a name means at its end; or NULL. NULL is no evaluation. */
const struct meaning *evaluation_meaning(const struct evaluation *evaluation,
                                         const char *name);

#endif
