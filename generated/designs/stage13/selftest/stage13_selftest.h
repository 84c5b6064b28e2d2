/*
 * Self-test of the prescribed-time controller stage13, for the target. DO NOT EDIT. Made by:
 *   ptc-codegen emit --lang c --n 2 --mu "exp(a=1)" --name stage13 --clock samples --A="[[0,1],[49,-0.1]]" --B="[0.1,-1.3]" --C="[[1,0.5],[0.2,-1]]" --precision f32 --eps=0 --after zero --sample-time=0.01 --selftest
 * Version 0.1.0.
 *
 * 5 sets of parameters with 53 calls, 22 sets that init must refuse. The expected values were
 * computed by the generator, which runs this very program in the arithmetic of IEEE 754: the
 * operations are its own alone, so that a target has to give the same numbers.
 *
 * Outcomes of conditions that no input tried brings about are not exercised:
 *   PTC_FINITE_F32(deadbeat): held with each of 3036 sets of parameters that passed the tests
 *     before it.
 *   PTC_FINITE_F32(w1_2): held with each of 3036 sets of parameters that passed the tests before
 *     it.
 *   PTC_FINITE_F32(w2_2): held with each of 3036 sets of parameters that passed the tests before
 *     it.
 */
#ifndef STAGE13_SELFTEST_H
#define STAGE13_SELFTEST_H

#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/* The number of failed checks: 0 if the controller works on this machine. It uses no heap, output
 * or clock, and keeps no state. */
uint32_t stage13_selftest(void);

#ifdef __cplusplus
}
#endif

#endif
