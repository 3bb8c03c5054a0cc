/* Everything that a surface can be, in one picture: a checkered floor, a wall with a picture, a
   mirror, a tinted glass ball, a shining ball, a matte drum with smooth lids, soft and hard light. */
studio {
  at 0 0 -.05  up 0 0 1  angle 50  resolution 320 240
  ambient .25 .25 .25  background .35 .5 .7
  antialias adaptive  threshold 12  depth 8  haze .05
}
#define FLOOR -.2
transform { scale .5 }
light { type spherical  position .5 -.4 .9  radius .06  samples 49  color .55 .55 .5 }
light { type directional  direction -1 -.6 -1.5  color .25 .25 .3 }
light { position .2 .3 .6  at 0 0 FLOOR  min_angle 30  max_angle 30  falloff 2  color .03 .03 .015 }

surface { diffuse .9 .9 .9  texture { checker 1 1 1 .2 .25 .3  scale .1  translate 0 0 FLOOR } }
polygon { points 4 vertex -.4 -.4 FLOOR vertex .4 -.4 FLOOR vertex .4 .4 FLOOR vertex -.4 .4 FLOOR }
surface { diffuse 1 1 1  texture { map "tiles.png"  scale .5 } }
polygon { points 4 vertex -.4 .4 FLOOR vertex -.4 -.4 FLOOR vertex -.4 -.4 .15 vertex -.4 .4 .15 }
surface { diffuse .05 .05 .05  specular .8 .8 .8 }
polygon { points 4 vertex -.38 .38 (FLOOR) vertex .1 .38 (FLOOR) vertex .1 .38 .12 vertex -.38 .38 .12 }
surface { diffuse 0 0 0  ambient 0 0 0  transparent .6 .9 .7  ior 1.5 }
sphere { center .1 -.08 (FLOOR + .101) radius .1 }
surface { diffuse .8 .2 .15  shine 40 .6 .6 .6  specular .1 .1 .1 }
sphere { center -.12 .12 (FLOOR + .12) radius .12 }
surface { diffuse .2 .35 .8 }
cylinder { base .2 .2 FLOOR apex .2 .2 -.05 radius .08 }
#define SLOPE .6
#define CORNER_A vertex .28 .2 -.05 normal SLOPE 0 1
#define CORNER_B vertex .2 .28 -.05 normal 0 SLOPE 1
#define CORNER_C vertex .12 .2 -.05 normal -SLOPE 0 1
#define CORNER_D vertex .2 .12 -.05 normal 0 -SLOPE 1
#define TIP vertex .2 .2 .02 normal 0 0 1
patch { CORNER_A CORNER_B TIP }
patch { CORNER_B CORNER_C TIP }
patch { CORNER_C CORNER_D TIP }
patch { CORNER_D CORNER_A TIP }
transform_pop
