/*
 * Self-test of the prescribed-time controller stage31, for the target. DO NOT EDIT. Made by:
 *   ptc-codegen emit --lang c --mu "exp(a=1)" --name stage31 --clock samples --eps=0 --limits=2,3 --poles="[[-4],[-3,-4.5]]" --states="h, c, e" --inputs=q,p --outputs="h, e" --dynamics="q - 1/10*h, p - c*(1 + h), (c - e)*(1 + h)" --reference input --selftest
 * Version 0.1.0.
 *
 * 4 sets of parameters with 96 calls, 14 sets that init must refuse. The expected values were
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
 */
#ifndef STAGE31_SELFTEST_H
#define STAGE31_SELFTEST_H

#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/* The number of failed checks: 0 if the controller works on this machine. It uses no heap, output
 * or clock, and keeps no state. */
uint32_t stage31_selftest(void);

#ifdef __cplusplus
}
#endif

#endif
