/* BLOCKCYL1. The original colours */
#define STUDIO_ANGLE 50
#include studio.bo
#include blockcyl1.bc
#include blockcyl.bo
transform { scale .12 } BLOCKCYL_CENTRED transform_pop
