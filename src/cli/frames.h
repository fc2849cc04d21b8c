/* The frames of an animation: numbers, clock, file names. */
#ifndef CLI_FRAMES_H
#define CLI_FRAMES_H

#include <math.h>
#include <stdbool.h>

#include "parse/parse.h"

/* A number that the user didn't say. */
#define FRAMES_UNSAID ((double)NAN)

struct frames {
    /* As said, or FRAMES_UNSAID. */
    double initial, final, step;
    double subset_start, subset_end; /* in (0,1): a share of all frames */
    double initial_clock, final_clock;
    bool cyclic;
    /* Worked out by frames_resolve. */
    bool animated;
    int first, last;      /* of the whole animation */
    int begin, end, pace; /* to render now: begin, begin + pace .. end */
    int digits;           /* of the numbers in file names */
    bool none;            /* this process has no frame to render */
};

struct frames frames_new(void);

/* Works out what is said. Returns NULL, or what is wrong with it. */
const char *frames_resolve(struct frames *frames, struct arena *arena);

/* Leaves of the frames to render the number-th of `count` rows that are about
 * as long: those beside each other know of each other's light (moments.h). */
void frames_deal(struct frames *frames, int number, int count);

/* How many frames there are to render: 1 without an animation. */
int frames_count(const struct frames *frames);

/* The number of the frame to render as the index-th. */
int frames_number(const struct frames *frames, int index);

/* What frame `number` sees: clock, frame_number and so on. Without an
 * animation the clock is what is there already. */
void frames_tell(const struct frames *frames, int number,
                 struct parse_options *parse);

/* The picture's name with the frame's number before its extension. */
const char *frames_name(const struct frames *frames, int number,
                        const char *output, struct arena *arena);

#endif
