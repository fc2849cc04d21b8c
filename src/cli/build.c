/* See build.h. */
#include "cli/build.h"

const char build_id[] =
#include "build.inc"
    ;
