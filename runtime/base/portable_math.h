// Functions whose results have the same bits on every processor: those of C libraries differ
// between architectures, versions and even processors of one architecture (glibc has variants
// with fused multiply-adds and picks one at start). For all that reaches the output.
//
// Nothing but additions, multiplications, divisions, square roots, comparisons and moved bits of
// IEEE doubles, in an order that the source fixes (the whole tree is built without contraction).
// Errors are at most 4 units in the last place; special values are those of the C standard, and
// every NaN returned is the same one.
#pragma once

namespace aspect {

double portable_exp(double x);
double portable_log(double x);

// Of angles up to a million radians; NaN beyond. The error of the tangent is that of a quotient.
double portable_sin(double x_rad);
double portable_cos(double x_rad);
double portable_tan(double x_rad);

double portable_atan(double x);
double portable_atan2(double y, double x);
double portable_acos(double x);

// Rounded once: squares of floats neither overflow doubles nor lose a bit in them.
float portable_hypot(float x, float y);

}  // namespace aspect
