surface { diffuse 1 0 0 specular .5 .5 .5 transparent .1 .2 .3 ior 1.5 shine 20 1 1 1 fuzz .1 no_antialias no_shadow }
surface { shine 5 } surface { shine 5 * (1 + 2) -1 0 0 }
transform { rotate 1 2 3 } surface { texture { checker 1 1 1 0 0 0 scale 1 2 3 translate .1 0 0 rotate 0 0 45 } } transform_pop
sphere { center 0 0 0 radius .1 }
surface { texture { checker scale 1e-9 scale 1e-9 scale 1e9 } }
patch { vertex 0 0 0 normal 0 0 1 vertex 1 0 0 normal 0 1 1 vertex 0 1 0 normal 1 0 1 }
