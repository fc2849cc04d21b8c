/* Which glim this is, of all with the same version. */
#ifndef CLI_BUILD_H
#define CLI_BUILD_H

/* A hash of the sources, the compiler and its options, in hexadecimal: the same
 * for everybody who builds the same by the same (Makefile). Pictures and part
 * files carry it, as another may draw other bits. */
extern const char build_id[];

#endif
