/* One frame: scene text -> scene -> world -> picture -> file. */
#ifndef CLI_FRAME_H
#define CLI_FRAME_H

#include "cli/work.h"

/* The frame with that index, from 0 on, of an animation, or the only picture.
 * Errors are printed. */
enum work_status frame_run(struct work *work, int index);

#endif
