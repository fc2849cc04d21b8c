/* Pictures that are there already: whether they are whole, and current. */
#ifndef CLI_KEPT_H
#define CLI_KEPT_H

#include "cli/options.h"

/* What +C knows, for all frames. */
struct kept {
    struct file_list *seen;  /* files that pictures were made of, as they are */
    struct file_list *asked; /* gets those of the pictures that are kept */
    bool told;               /* once is enough */
};

/* +C: whether the file called `name` is a whole picture of the right size, and
 * drawn with these settings (cli/origin.h) of files that are as they were. If
 * there is one that isn't, says why it is rendered again. Kinds of pictures
 * that carry no origin are kept, with a warning if the scene's file is newer.
 */
bool kept_picture(struct kept *kept, const struct options *options,
                  const char *name, const char *settings, struct diag *diag);

/* --check-picture: prints to standard output what the picture is of, its size,
 * and whether it is whole and current. Returns whether it is both. */
bool kept_check(const char *name, struct diag *diag);

#endif
