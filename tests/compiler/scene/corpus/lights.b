light { type point position 1 2 3 falloff 2 at 0 0 0 min_angle 10 max_angle 20 color .1 .2 .3 }
light { type directional direction 0 0 -1 no_shadows }
transform { scale .5 } light { type spherical center 0 0 1 radius .1 samples 16 falloff 1 } transform_pop
light { type directional direction 0 0 -1 position 1 2 3 }
