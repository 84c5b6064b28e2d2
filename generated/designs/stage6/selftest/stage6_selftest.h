/*
 * Self-test of the prescribed-time controller stage6, for the target. DO NOT EDIT. Made by:
 *   ptc-codegen emit --lang c --n 3 --mu "exp(a=0.7)" --name stage6 --clock samples --measured=x1,x2 --observer-poles=-4,-5.3 --eps=0 --f="1/2" --g="2" --sample-time=2e-3 --selftest
 * Version 0.1.0.
 *
 * 6 sets of parameters with 56 calls, 27 sets that init must refuse. The expected values were
 * computed by the generator, which runs this very program in the arithmetic of IEEE 754: the
 * operations are its own alone, so that a target has to give the same numbers.
 *
 * Outcomes of conditions that no input tried brings about are not exercised:
 *   PTC_FINITE_F64(w1_2): held with each of 3044 sets of parameters that passed the tests before
 *     it.
 *   PTC_FINITE_F64(w1_3): held with each of 3044 sets of parameters that passed the tests before
 *     it.
 *   PTC_FINITE_F64(w2_3): held with each of 3044 sets of parameters that passed the tests before
 *     it.
 *   PTC_FINITE_F64(w3_3): held with each of 3044 sets of parameters that passed the tests before
 *     it.
 */
#ifndef STAGE6_SELFTEST_H
#define STAGE6_SELFTEST_H

#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/* The number of failed checks: 0 if the controller works on this machine. It uses no heap, output
 * or clock, and keeps no state. */
uint32_t stage6_selftest(void);

#ifdef __cplusplus
}
#endif

#endif
