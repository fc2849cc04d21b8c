/* Signals that ask the program to end: a flag that the reader of the scene and
 * the renderer look at. */
#ifndef CLI_INTERRUPT_H
#define CLI_INTERRUPT_H

#include <stdatomic.h>

/* From now on SIGINT, SIGTERM and SIGHUP set the flag, which is returned. A
 * second one ends the program at once. Reading a scene from a terminal or a
 * pipe fails when it happens. */
const atomic_int *interrupt_catch(void);

#endif
