#define C .2 .1 .8
surface { diffuse C * .5 }
#ifdef X
#else
sphere { center 1 -2 (3 - 1) radius .1 }
#endif
