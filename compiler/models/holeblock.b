/* HOLEBLOCK. A block with a hole through it */
#define STUDIO_ANGLE 50
#include studio.bo
#include palette.bc
#include holeblock.bo
transform { scale .17462 } HOLEBLOCK transform_pop
