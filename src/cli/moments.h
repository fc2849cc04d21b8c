/* The frames of an animation that have a part in the light of others. */
#ifndef CLI_MOMENTS_H
#define CLI_MOMENTS_H

#include "cli/work.h"

/* Reads the frame that is drawn, and says what there is to say of it. Valid
 * until moments_pass. */
struct moment *moments_now(struct work *work);

/* Before the first frame of an animation that this process draws, `now`: lights
 * their root. All of them light what they show by one mesh, or where something
 * moves by meshes whose points are in the same places, lest light on what
 * stands still changes from frame to frame. */
void moments_root(struct work *work, struct moment *now);

/* Lights the frames around the one that is drawn where something moves, for its
 * own light to be smoothed by: valid until moments_pass. Only in a row of
 * frames, in which each is around others as well: to light five for one by
 * itself would take too long. */
void moments_around(struct work *work, struct moment *now,
                    struct lighting_moments *found);

/* Forgets what frames after the one that was drawn don't need, or all of it. */
void moments_pass(struct work *work);
void moments_forget(struct work *work);

#endif
