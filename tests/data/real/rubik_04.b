/* rubik_04: the cube 2x2x2-random-04. Squares U, L, F, R, B, D, four each, row by row, in the
   colours of 2x2x2-random-04.txt. U is +y, R is +x, F is +z; README.md shows
   the unfolding. Edge 2, scaled so that a sphere of radius 0.36 holds it. */
studio {
  at 0 0 0
  up 0 1 0.05
  angle 50
  resolution 512 512
  antialias none
  threshold 1
  aspect 1
  ambient 1 1 1
}
transform { scale 0.207846 }
/* the body: dark enough to be background */
surface { diffuse 0.01 0.01 0.01 }
polygon { points 4
  vertex -1 1 -1  vertex -1 1 1
  vertex 1 1 1  vertex 1 1 -1
}
polygon { points 4
  vertex -1 1 -1  vertex -1 -1 -1
  vertex -1 -1 1  vertex -1 1 1
}
polygon { points 4
  vertex -1 1 1  vertex -1 -1 1
  vertex 1 -1 1  vertex 1 1 1
}
polygon { points 4
  vertex 1 1 1  vertex 1 -1 1
  vertex 1 -1 -1  vertex 1 1 -1
}
polygon { points 4
  vertex 1 1 -1  vertex 1 -1 -1
  vertex -1 -1 -1  vertex -1 1 -1
}
polygon { points 4
  vertex -1 -1 1  vertex -1 -1 -1
  vertex 1 -1 -1  vertex 1 -1 1
}
surface { diffuse 0.776471 0.835294 0.341176 }  /* U1 */
polygon { points 4
  vertex -0.936 1.004 -0.936  vertex -0.936 1.004 -0.068
  vertex -0.068 1.004 -0.068  vertex -0.068 1.004 -0.936
}
surface { diffuse 0.709804 0.443137 0.203922 }  /* U2 */
polygon { points 4
  vertex 0.068 1.004 -0.936  vertex 0.068 1.004 -0.068
  vertex 0.936 1.004 -0.068  vertex 0.936 1.004 -0.936
}
surface { diffuse 0.054902 0.368627 0.909804 }  /* U3 */
polygon { points 4
  vertex -0.936 1.004 0.068  vertex -0.936 1.004 0.936
  vertex -0.068 1.004 0.936  vertex -0.068 1.004 0.068
}
surface { diffuse 0.607843 0.031373 0.031373 }  /* U4 */
polygon { points 4
  vertex 0.068 1.004 0.068  vertex 0.068 1.004 0.936
  vertex 0.936 1.004 0.936  vertex 0.936 1.004 0.068
}
surface { diffuse 0.423529 0.243137 0.141176 }  /* L1 */
polygon { points 4
  vertex -1.004 0.936 -0.936  vertex -1.004 0.068 -0.936
  vertex -1.004 0.068 -0.068  vertex -1.004 0.936 -0.068
}
surface { diffuse 0.552941 0.611765 0.258824 }  /* L2 */
polygon { points 4
  vertex -1.004 0.936 0.068  vertex -1.004 0.068 0.068
  vertex -1.004 0.068 0.936  vertex -1.004 0.936 0.936
}
surface { diffuse 0.015686 0.180392 0.207843 }  /* L3 */
polygon { points 4
  vertex -1.004 -0.068 -0.936  vertex -1.004 -0.936 -0.936
  vertex -1.004 -0.936 -0.068  vertex -1.004 -0.068 -0.068
}
surface { diffuse 0.360784 0.015686 0.043137 }  /* L4 */
polygon { points 4
  vertex -1.004 -0.068 0.068  vertex -1.004 -0.936 0.068
  vertex -1.004 -0.936 0.936  vertex -1.004 -0.068 0.936
}
surface { diffuse 0.407843 0.231373 0.113725 }  /* F1 */
polygon { points 4
  vertex -0.936 0.936 1.004  vertex -0.936 0.068 1.004
  vertex -0.068 0.068 1.004  vertex -0.068 0.936 1.004
}
surface { diffuse 0.050980 0.254902 0.705882 }  /* F2 */
polygon { points 4
  vertex 0.068 0.936 1.004  vertex 0.068 0.068 1.004
  vertex 0.936 0.068 1.004  vertex 0.936 0.936 1.004
}
surface { diffuse 0.031373 0.200000 0.584314 }  /* F3 */
polygon { points 4
  vertex -0.936 -0.068 1.004  vertex -0.936 -0.936 1.004
  vertex -0.068 -0.936 1.004  vertex -0.068 -0.068 1.004
}
surface { diffuse 0.015686 0.200000 0.211765 }  /* F4 */
polygon { points 4
  vertex 0.068 -0.068 1.004  vertex 0.068 -0.936 1.004
  vertex 0.936 -0.936 1.004  vertex 0.936 -0.068 1.004
}
surface { diffuse 0.533333 0.658824 0.882353 }  /* R1 */
polygon { points 4
  vertex 1.004 0.936 0.936  vertex 1.004 0.068 0.936
  vertex 1.004 0.068 0.068  vertex 1.004 0.936 0.068
}
surface { diffuse 0.603922 0.741176 0.937255 }  /* R2 */
polygon { points 4
  vertex 1.004 0.936 -0.068  vertex 1.004 0.068 -0.068
  vertex 1.004 0.068 -0.936  vertex 1.004 0.936 -0.936
}
surface { diffuse 0.509804 0.627451 0.847059 }  /* R3 */
polygon { points 4
  vertex 1.004 -0.068 0.936  vertex 1.004 -0.936 0.936
  vertex 1.004 -0.936 0.068  vertex 1.004 -0.068 0.068
}
surface { diffuse 0.576471 0.701961 0.901961 }  /* R4 */
polygon { points 4
  vertex 1.004 -0.068 -0.068  vertex 1.004 -0.936 -0.068
  vertex 1.004 -0.936 -0.936  vertex 1.004 -0.068 -0.936
}
surface { diffuse 0.050980 0.407843 0.952941 }  /* B1 */
polygon { points 4
  vertex 0.936 0.936 -1.004  vertex 0.936 0.068 -1.004
  vertex 0.068 0.068 -1.004  vertex 0.068 0.936 -1.004
}
surface { diffuse 0.058824 0.447059 0.458824 }  /* B2 */
polygon { points 4
  vertex -0.068 0.936 -1.004  vertex -0.068 0.068 -1.004
  vertex -0.936 0.068 -1.004  vertex -0.936 0.936 -1.004
}
surface { diffuse 0.027451 0.341176 0.337255 }  /* B3 */
polygon { points 4
  vertex 0.936 -0.068 -1.004  vertex 0.936 -0.936 -1.004
  vertex 0.068 -0.936 -1.004  vertex 0.068 -0.068 -1.004
}
surface { diffuse 0.850980 0.894118 0.356863 }  /* B4 */
polygon { points 4
  vertex -0.068 -0.068 -1.004  vertex -0.068 -0.936 -1.004
  vertex -0.936 -0.936 -1.004  vertex -0.936 -0.068 -1.004
}
surface { diffuse 0.470588 0.521569 0.235294 }  /* D1 */
polygon { points 4
  vertex -0.936 -1.004 0.936  vertex -0.936 -1.004 0.068
  vertex -0.068 -1.004 0.068  vertex -0.068 -1.004 0.936
}
surface { diffuse 0.372549 0.019608 0.058824 }  /* D2 */
polygon { points 4
  vertex 0.068 -1.004 0.936  vertex 0.068 -1.004 0.068
  vertex 0.936 -1.004 0.068  vertex 0.936 -1.004 0.936
}
surface { diffuse 0.286275 0.011765 0.043137 }  /* D3 */
polygon { points 4
  vertex -0.936 -1.004 -0.068  vertex -0.936 -1.004 -0.936
  vertex -0.068 -1.004 -0.936  vertex -0.068 -1.004 -0.068
}
surface { diffuse 0.411765 0.247059 0.156863 }  /* D4 */
polygon { points 4
  vertex 0.068 -1.004 -0.068  vertex 0.068 -1.004 -0.936
  vertex 0.936 -1.004 -0.936  vertex 0.936 -1.004 -0.068
}
transform_pop
