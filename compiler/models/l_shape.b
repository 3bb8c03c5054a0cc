/* L_SHAPE. Some faces are alike, as on the real object */
#define STUDIO_ANGLE 50
#include studio.bo
#include rl.bc
#include rl.bo
transform { scale .2432 } RL_N transform_pop
