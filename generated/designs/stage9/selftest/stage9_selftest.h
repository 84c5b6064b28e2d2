/*
 * Self-test of the prescribed-time controller stage9, for the target. DO NOT EDIT. Made by:
 *   ptc-codegen emit --lang c --n 3 --mu "exp(a=1)" --name stage9 --clock samples --measured=x1 --observer-poles=-4,-5,-6 --observer-eps=0.05 --eps=0.02 --u-max=1e3 --delay=1 --selftest
 * Version 0.1.0.
 *
 * 4 sets of parameters with 47 calls, 43 sets that init must refuse. The expected values were
 * computed by the generator, which runs this very program in the arithmetic of IEEE 754: the
 * operations are its own alone, so that a target has to give the same numbers.
 *
 * Outcomes of conditions that no input tried brings about are not exercised:
 *   PTC_FINITE_F64(phi1_3): held with each of 3056 sets of parameters that passed the tests
 *     before it.
 *   PTC_FINITE_F64(hold_o): held with each of 3056 sets of parameters that passed the tests
 *     before it.
 *   PTC_FINITE_F64(q2_1): held with each of 3056 sets of parameters that passed the tests before
 *     it.
 *   PTC_FINITE_F64(q2_2): held with each of 3056 sets of parameters that passed the tests before
 *     it.
 *   PTC_FINITE_F64(q3_1): held with each of 3056 sets of parameters that passed the tests before
 *     it.
 *   PTC_FINITE_F64(hold): held with each of 3056 sets of parameters that passed the tests before
 *     it.
 *   PTC_FINITE_F64(w1_2): held with each of 3056 sets of parameters that passed the tests before
 *     it.
 *   PTC_FINITE_F64(w1_3): held with each of 3056 sets of parameters that passed the tests before
 *     it.
 *   PTC_FINITE_F64(w2_3): held with each of 3056 sets of parameters that passed the tests before
 *     it.
 *   PTC_FINITE_F64(w4_4): held with each of 3056 sets of parameters that passed the tests before
 *     it.
 *   PTC_FINITE_F64(b_1): held with each of 3056 sets of parameters that passed the tests before
 *     it.
 *   PTC_FINITE_F64(b_2): held with each of 3056 sets of parameters that passed the tests before
 *     it.
 *   PTC_FINITE_F64(b_3): held with each of 3056 sets of parameters that passed the tests before
 *     it.
 */
#ifndef STAGE9_SELFTEST_H
#define STAGE9_SELFTEST_H

#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/* The number of failed checks: 0 if the controller works on this machine. It uses no heap, output
 * or clock, and keeps no state. */
uint32_t stage9_selftest(void);

#ifdef __cplusplus
}
#endif

#endif
