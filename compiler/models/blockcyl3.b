/* BLOCKCYL3. BLOCKCYL2 from nearer: scaled up, with a wider
   lens, so that it appears a bit smaller (thesis 4.1.2) */
#define STUDIO_ANGLE 75
#include studio.bo
#include blockcyl2.bc
#include blockcyl.bo
transform { scale .18 } BLOCKCYL_CENTRED transform_pop
