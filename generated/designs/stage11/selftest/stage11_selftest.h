/*
 * Self-test of the prescribed-time controller stage11, for the target. DO NOT EDIT. Made by:
 *   ptc-codegen emit --lang c --n 4 --mu "exp(a=1)" --name stage11 --clock samples --measured=x1 --disturbance constant --observer-poles=-4,-5,-6,-7,-8 --precision f32 --eps=0 --sample-time=0.01 --selftest
 * Version 0.1.0.
 *
 * 6 sets of parameters with 53 calls, 33 sets that init must refuse. The expected values were
 * computed by the generator, which runs this very program in the arithmetic of IEEE 754: the
 * operations are its own alone, so that a target has to give the same numbers.
 *
 * Outcomes of conditions that no input tried brings about are not exercised:
 *   PTC_FINITE_F32(deadbeat): held with each of 3052 sets of parameters that passed the tests
 *     before it.
 *   PTC_FINITE_F32(w1_2): held with each of 3052 sets of parameters that passed the tests before
 *     it.
 *   PTC_FINITE_F32(w1_3): held with each of 3052 sets of parameters that passed the tests before
 *     it.
 *   PTC_FINITE_F32(w1_4): held with each of 3052 sets of parameters that passed the tests before
 *     it.
 *   PTC_FINITE_F32(w2_3): held with each of 3052 sets of parameters that passed the tests before
 *     it.
 *   PTC_FINITE_F32(w2_4): held with each of 3052 sets of parameters that passed the tests before
 *     it.
 *   PTC_FINITE_F32(w3_4): held with each of 3052 sets of parameters that passed the tests before
 *     it.
 *   PTC_FINITE_F32(w4_4): held with each of 3052 sets of parameters that passed the tests before
 *     it.
 */
#ifndef STAGE11_SELFTEST_H
#define STAGE11_SELFTEST_H

#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/* The number of failed checks: 0 if the controller works on this machine. It uses no heap, output
 * or clock, and keeps no state. */
uint32_t stage11_selftest(void);

#ifdef __cplusplus
}
#endif

#endif
