transform { translate 0 -2.85 0 rotate 10 20 30 scale 0.35088 }
polygon { points 3 vertex 0 0 0 vertex 1 0 0 vertex 0 1 0 }
ring { center 0 0 0 normal 0 0 1 min_radius .1 max_radius .2 }
cone { base 0 0 0 base_radius .2 apex 0 0 1 apex_radius 0 }
cylinder { base 0 0 0 apex 0 0 1 radius .2 }
transform_pop
