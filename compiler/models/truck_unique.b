/* TRUCK as it is, with a colour for nearly every kind of face */
#define STUDIO_ANGLE 50
#include studio.bo
#include palette.bc
#include truck_unique.bc
#include truck.bo
transform { translate 0 -4.9 0 scale .02728 } TRUCK transform_pop
