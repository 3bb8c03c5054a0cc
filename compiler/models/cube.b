/* CUBE. A cube with six colours */
#define STUDIO_ANGLE 50
#include studio.bo
#include palette.bc
#include cube.bo
transform { scale .20785 } CUBE transform_pop
