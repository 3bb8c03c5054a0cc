studio { antialias adaptive threshold 0 samples 64 jitter depth 100 haze .5 aperture .1 focal_length 2 no_exp_trans caustics no_shadows project orthogonal resolution 4096 1 }
studio { antialias quick project flat 1e-9 }
studio { antialias corners project perspective samples 4097 }
