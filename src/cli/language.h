/* --language-server: a program of its own, so that glim needs no JSON. */
#ifndef CLI_LANGUAGE_H
#define CLI_LANGUAGE_H

#include "cli/options.h"

/* Becomes the program glim-language-server, which stands beside glim, with the
 * folders that scenes are searched in. Returns only after an error. */
void language_server(const struct options *options, struct diag *diag);

#endif
