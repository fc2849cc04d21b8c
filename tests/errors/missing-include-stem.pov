// The nearest by what is before the extension, which ior.inc is not.
#ifdef (Never) #include "never.inc" #end
#include "col.inc"
