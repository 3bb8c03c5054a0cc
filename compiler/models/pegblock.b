/* PEGBLOCK. The peg is like one side of the block */
#define STUDIO_ANGLE 50
#include studio.bo
#include palette.bc
#include pegblock.bo
transform { scale .11244 } PEGBLOCK transform_pop
