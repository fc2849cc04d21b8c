/* Errors and warnings as the editor wants them, with what mends them. */
#ifndef LANGUAGE_REMARKS_H
#define LANGUAGE_REMARKS_H

#include "language/server.h"

/* Of the last evaluation of `root`: a list for each URI. */
json_t *remarks_json(struct server *server, const struct root *root);

#endif
