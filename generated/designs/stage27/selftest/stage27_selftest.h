/*
 * Self-test of the prescribed-time controller stage27, for the target. DO NOT EDIT. Made by:
 *   ptc-codegen emit --lang c --mu "exp(a=0.8)" --name stage27 --clock samples --eps=0 --u-max=inf --poles="[[-4],[-3,-4],[-5],[-2.5,-6]]" --states="a, b, b1, c, d, d1" --inputs=A,B,C,D --outputs="a, b, c, d" --dynamics="A*(2 + b^2) + B - a*c, b1, B*(3 + a) + C*d - b*d1, C + D*a - c^2, d1, D*(2 - b) + A*c + a" --selftest
 * Version 0.1.0.
 *
 * 4 sets of parameters with 77 calls, 14 sets that init must refuse. The expected values were
 * computed by the generator, which runs this very program in the arithmetic of IEEE 754: the
 * operations are its own alone, so that a target has to give the same numbers.
 *
 * Outcomes of conditions that no input tried brings about are not exercised:
 *   PTC_FINITE_F64(w1_1_1): held with each of 3016 sets of parameters that passed the tests
 *     before it.
 *   PTC_FINITE_F64(w1_1_2): held with each of 3016 sets of parameters that passed the tests
 *     before it.
 *   PTC_FINITE_F64(w1_2_2): held with each of 3016 sets of parameters that passed the tests
 *     before it.
 *   PTC_FINITE_F64(w2_2_2): held with each of 3016 sets of parameters that passed the tests
 *     before it.
 *   PTC_FINITE_F64(end1_1_2): held with each of 3016 sets of parameters that passed the tests
 *     before it.
 *   PTC_FINITE_F64(end1_2_2): held with each of 3016 sets of parameters that passed the tests
 *     before it.
 *   PTC_FINITE_F64(end2_2_2): held with each of 3016 sets of parameters that passed the tests
 *     before it.
 *   PTC_FINITE_F64(w1_1_3): held with each of 3016 sets of parameters that passed the tests
 *     before it.
 *   PTC_FINITE_F64(end1_1_3): held with each of 3016 sets of parameters that passed the tests
 *     before it.
 *   PTC_FINITE_F64(w1_1_4): held with each of 3016 sets of parameters that passed the tests
 *     before it.
 *   PTC_FINITE_F64(w1_2_4): held with each of 3016 sets of parameters that passed the tests
 *     before it.
 *   PTC_FINITE_F64(w2_2_4): held with each of 3016 sets of parameters that passed the tests
 *     before it.
 *   PTC_FINITE_F64(control2): never false in 1141 calls.
 *   PTC_FINITE_F64(control3): never false in 1141 calls.
 *   PTC_FINITE_F64(control4): never false in 1141 calls.
 *   PTC_FINITE_F64(control1): never true in 1141 calls.
 */
#ifndef STAGE27_SELFTEST_H
#define STAGE27_SELFTEST_H

#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/* The number of failed checks: 0 if the controller works on this machine. It uses no heap, output
 * or clock, and keeps no state. */
uint32_t stage27_selftest(void);

#ifdef __cplusplus
}
#endif

#endif
