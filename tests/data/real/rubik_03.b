/* rubik_03: the cube 2x2x2-random-03. Squares U, L, F, R, B, D, four each, row by row, in the
   colours of 2x2x2-random-03.txt. U is +y, R is +x, F is +z; README.md shows
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
surface { diffuse 0.858824 0.062745 0.113725 }  /* U1 */
polygon { points 4
  vertex -0.936 1.004 -0.936  vertex -0.936 1.004 -0.068
  vertex -0.068 1.004 -0.068  vertex -0.068 1.004 -0.936
}
surface { diffuse 0.905882 0.082353 0.160784 }  /* U2 */
polygon { points 4
  vertex 0.068 1.004 -0.936  vertex 0.068 1.004 -0.068
  vertex 0.936 1.004 -0.068  vertex 0.936 1.004 -0.936
}
surface { diffuse 0.878431 0.529412 0.309804 }  /* U3 */
polygon { points 4
  vertex -0.936 1.004 0.068  vertex -0.936 1.004 0.936
  vertex -0.068 1.004 0.936  vertex -0.068 1.004 0.068
}
surface { diffuse 0.941176 0.654902 0.423529 }  /* U4 */
polygon { points 4
  vertex 0.068 1.004 0.068  vertex 0.068 1.004 0.936
  vertex 0.936 1.004 0.936  vertex 0.936 1.004 0.068
}
surface { diffuse 0.074510 0.486275 0.517647 }  /* L1 */
polygon { points 4
  vertex -1.004 0.936 -0.936  vertex -1.004 0.068 -0.936
  vertex -1.004 0.068 -0.068  vertex -1.004 0.936 -0.068
}
surface { diffuse 0.090196 0.564706 0.615686 }  /* L2 */
polygon { points 4
  vertex -1.004 0.936 0.068  vertex -1.004 0.068 0.068
  vertex -1.004 0.068 0.936  vertex -1.004 0.936 0.936
}
surface { diffuse 0.050980 0.482353 0.513725 }  /* L3 */
polygon { points 4
  vertex -1.004 -0.068 -0.936  vertex -1.004 -0.936 -0.936
  vertex -1.004 -0.936 -0.068  vertex -1.004 -0.068 -0.068
}
surface { diffuse 0.117647 0.623529 0.992157 }  /* L4 */
polygon { points 4
  vertex -1.004 -0.068 0.068  vertex -1.004 -0.936 0.068
  vertex -1.004 -0.936 0.936  vertex -1.004 -0.068 0.936
}
surface { diffuse 0.964706 0.984314 0.984314 }  /* F1 */
polygon { points 4
  vertex -0.936 0.936 1.004  vertex -0.936 0.068 1.004
  vertex -0.068 0.068 1.004  vertex -0.068 0.936 1.004
}
surface { diffuse 0.964706 0.984314 0.984314 }  /* F2 */
polygon { points 4
  vertex 0.068 0.936 1.004  vertex 0.068 0.068 1.004
  vertex 0.936 0.068 1.004  vertex 0.936 0.936 1.004
}
surface { diffuse 0.968627 0.972549 0.603922 }  /* F3 */
polygon { points 4
  vertex -0.936 -0.068 1.004  vertex -0.936 -0.936 1.004
  vertex -0.068 -0.936 1.004  vertex -0.068 -0.068 1.004
}
surface { diffuse 0.039216 0.545098 0.576471 }  /* F4 */
polygon { points 4
  vertex 0.068 -0.068 1.004  vertex 0.068 -0.936 1.004
  vertex 0.936 -0.936 1.004  vertex 0.936 -0.068 1.004
}
surface { diffuse 0.105882 0.486275 0.984314 }  /* R1 */
polygon { points 4
  vertex 1.004 0.936 0.936  vertex 1.004 0.068 0.936
  vertex 1.004 0.068 0.068  vertex 1.004 0.936 0.068
}
surface { diffuse 0.105882 0.580392 0.992157 }  /* R2 */
polygon { points 4
  vertex 1.004 0.936 -0.068  vertex 1.004 0.068 -0.068
  vertex 1.004 0.068 -0.936  vertex 1.004 0.936 -0.936
}
surface { diffuse 0.854902 0.062745 0.137255 }  /* R3 */
polygon { points 4
  vertex 1.004 -0.068 0.936  vertex 1.004 -0.936 0.936
  vertex 1.004 -0.936 0.068  vertex 1.004 -0.068 0.068
}
surface { diffuse 0.972549 0.992157 0.780392 }  /* R4 */
polygon { points 4
  vertex 1.004 -0.068 -0.068  vertex 1.004 -0.936 -0.068
  vertex 1.004 -0.936 -0.936  vertex 1.004 -0.068 -0.936
}
surface { diffuse 0.964706 0.984314 0.984314 }  /* B1 */
polygon { points 4
  vertex 0.936 0.936 -1.004  vertex 0.936 0.068 -1.004
  vertex 0.068 0.068 -1.004  vertex 0.068 0.936 -1.004
}
surface { diffuse 0.964706 0.984314 0.988235 }  /* B2 */
polygon { points 4
  vertex -0.068 0.936 -1.004  vertex -0.068 0.068 -1.004
  vertex -0.936 0.068 -1.004  vertex -0.936 0.936 -1.004
}
surface { diffuse 0.082353 0.501961 0.984314 }  /* B3 */
polygon { points 4
  vertex 0.936 -0.068 -1.004  vertex 0.936 -0.936 -1.004
  vertex 0.068 -0.936 -1.004  vertex 0.068 -0.068 -1.004
}
surface { diffuse 0.952941 0.682353 0.447059 }  /* B4 */
polygon { points 4
  vertex -0.068 -0.068 -1.004  vertex -0.068 -0.936 -1.004
  vertex -0.936 -0.936 -1.004  vertex -0.936 -0.068 -1.004
}
surface { diffuse 0.870588 0.058824 0.137255 }  /* D1 */
polygon { points 4
  vertex -0.936 -1.004 0.936  vertex -0.936 -1.004 0.068
  vertex -0.068 -1.004 0.068  vertex -0.068 -1.004 0.936
}
surface { diffuse 0.972549 0.996078 0.807843 }  /* D2 */
polygon { points 4
  vertex 0.068 -1.004 0.936  vertex 0.068 -1.004 0.068
  vertex 0.936 -1.004 0.068  vertex 0.936 -1.004 0.936
}
surface { diffuse 0.972549 0.976471 0.658824 }  /* D3 */
polygon { points 4
  vertex -0.936 -1.004 -0.068  vertex -0.936 -1.004 -0.936
  vertex -0.068 -1.004 -0.936  vertex -0.068 -1.004 -0.068
}
surface { diffuse 0.949020 0.701961 0.537255 }  /* D4 */
polygon { points 4
  vertex 0.068 -1.004 -0.068  vertex 0.068 -1.004 -0.936
  vertex 0.936 -1.004 -0.936  vertex 0.936 -1.004 -0.068
}
transform_pop
