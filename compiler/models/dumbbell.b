/* DUMBBELL. A solid of revolution, every surface with a colour of its own */
#define STUDIO_ANGLE 50
#include studio.bo
#include palette.bc
#include dumbbell.bo
transform { scale .17483 } DUMBBELL transform_pop
