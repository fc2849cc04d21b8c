/* Files that a picture was made of: which of them change (inotify). */
#ifndef VIEW_FOLLOW_H
#define VIEW_FOLLOW_H

#include "base/file_list.h"

struct follow;

/* Follows nothing yet. */
struct follow *follow_new(void);
void follow_free(struct follow *follow);

/* From now on these, whose arena it takes over. */
void follow_files(struct follow *follow, struct file_list files);

/* Whether one of them is not as it was when it was marked; then it follows them
 * as they are now. Told by the kernel as soon as a file was written and closed,
 * or renamed; what it doesn't tell, as of a network's files, is found out in
 * half a second. Quick: to be called often. */
bool follow_changed(struct follow *follow);

#endif
