/* --depend, -MD: which files a picture was made of, as a rule for make. */
#ifndef CLI_DEPEND_H
#define CLI_DEPEND_H

#include "cli/options.h"

/* Names of pictures, or of what is written in place of them. */
struct targets {
    const char **items;
    size_t count, capacity;
};

/* Whether there is a target, and the rule's file can be written, found out
 * before the work. Returns false after an error was printed. */
bool depend_can_be(const struct options *options, struct arena *arena,
                   struct diag *diag);

/* Writes "TARGETS: FILES" in one step: what was read, and in $(wildcard ...)
 * what was looked for and not there, which make must not want. With
 * options->depend.phony each file is a target of its own as well, so that make
 * does not stop when one is gone. Names are escaped for GNU make. Returns true
 * if there is nothing to write; false after an error was printed. */
bool depend_write(const struct options *options, const struct targets *targets,
                  const struct file_list *files, struct diag *diag);

#endif
