/*
 * Self-test of the prescribed-time controller stage12, for the target. DO NOT EDIT. Made by:
 *   ptc-codegen emit --lang c --n 3 --mu "exp(a=1)" --name stage12 --clock samples --A="[[0,1,0],[0,-0.5,1500],[0,-15,-600]]" --B="[0,0,500]" --C="[[1,0,0],[0,0,1]]" --disturbance constant --observer-poles=-4,-5,-6,-7 --after-observer=-90+20i,-90-20i,-100,-120 --eps=0 --sample-time=1e-3 --delay=1 --selftest
 * Version 0.1.0.
 *
 * 6 sets of parameters with 57 calls, 34 sets that init must refuse. The expected values were
 * computed by the generator, which runs this very program in the arithmetic of IEEE 754: the
 * operations are its own alone, so that a target has to give the same numbers.
 *
 * Outcomes of conditions that no input tried brings about are not exercised:
 *   PTC_FINITE_F64(deadbeat): held with each of 3052 sets of parameters that passed the tests
 *     before it.
 *   PTC_FINITE_F64(w1_2): held with each of 3052 sets of parameters that passed the tests before
 *     it.
 *   PTC_FINITE_F64(w1_3): held with each of 3052 sets of parameters that passed the tests before
 *     it.
 *   PTC_FINITE_F64(w2_3): held with each of 3052 sets of parameters that passed the tests before
 *     it.
 *   PTC_FINITE_F64(w4_2): held with each of 3052 sets of parameters that passed the tests before
 *     it.
 *   PTC_FINITE_F64(w4_3): held with each of 3052 sets of parameters that passed the tests before
 *     it.
 *   PTC_FINITE_F64(w4_4): held with each of 3052 sets of parameters that passed the tests before
 *     it.
 *   PTC_FINITE_F64(x1_on): never false in 2692 calls.
 *   PTC_FINITE_F64(x2_on): never false in 2692 calls.
 *   PTC_FINITE_F64(x3_on): never false in 2692 calls.
 *   PTC_FINITE_F64(d_on): never false in 2692 calls.
 */
#ifndef STAGE12_SELFTEST_H
#define STAGE12_SELFTEST_H

#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/* The number of failed checks: 0 if the controller works on this machine. It uses no heap, output
 * or clock, and keeps no state. */
uint32_t stage12_selftest(void);

#ifdef __cplusplus
}
#endif

#endif
