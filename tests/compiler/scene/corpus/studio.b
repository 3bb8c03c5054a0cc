studio { at 0 0 0 up 0 1 0.05 angle 50 resolution 512 512 antialias none threshold 1 aspect 1 ambient 1 1 1 }
light { type point position 1 2 3 color 1 1 1 no_shadows }
