/*
 * Self-test of the prescribed-time controller stage42, for the target. DO NOT EDIT. Made by:
 *   ptc-codegen emit --lang c --n 2 --mu "exp(a=2)" --name stage42 --clock samples --measured=x1 --observer-poles=-4,-5 --measurement-max=1.5 --eps=0 --after zero --selftest
 * Version 0.1.0.
 *
 * 5 sets of parameters with 47 calls, 34 sets that init must refuse. The expected values were
 * computed by the generator, which runs this very program in the arithmetic of IEEE 754: the
 * operations are its own alone, so that a target has to give the same numbers.
 *
 * Outcomes of conditions that no input tried brings about are not exercised:
 *   PTC_FINITE_F64(gamma1): held with each of 3048 sets of parameters that passed the tests
 *     before it.
 *   PTC_FINITE_F64(q2_1): held with each of 3048 sets of parameters that passed the tests before
 *     it.
 *   PTC_FINITE_F64(e1_2): held with each of 3048 sets of parameters that passed the tests before
 *     it.
 *   PTC_FINITE_F64(e0_2): held with each of 3048 sets of parameters that passed the tests before
 *     it.
 *   PTC_FINITE_F64(deadbeat): held with each of 3048 sets of parameters that passed the tests
 *     before it.
 *   PTC_FINITE_F64(w1_2): held with each of 3048 sets of parameters that passed the tests before
 *     it.
 *   PTC_FINITE_F64(b_1): held with each of 3048 sets of parameters that passed the tests before
 *     it.
 *   PTC_FINITE_F64(b_2): held with each of 3048 sets of parameters that passed the tests before
 *     it.
 *   size <= 1e150: never false in 2702 calls.
 *   PTC_FINITE_F64(v): never false in 2702 calls.
 */
#ifndef STAGE42_SELFTEST_H
#define STAGE42_SELFTEST_H

#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/* The number of failed checks: 0 if the controller works on this machine. It uses no heap, output
 * or clock, and keeps no state. */
uint32_t stage42_selftest(void);

#ifdef __cplusplus
}
#endif

#endif
