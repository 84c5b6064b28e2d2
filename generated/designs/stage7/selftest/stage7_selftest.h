/*
 * Self-test of the prescribed-time controller stage7, for the target. DO NOT EDIT. Made by:
 *   ptc-codegen emit --lang c --n 1 --mu "exp(a=1)" --name stage7 --clock samples --disturbance constant --observer-poles=-4,-5 --precision f32 --guard none --eps=0 --gains=3 --selftest
 * Version 0.1.0.
 *
 * 4 sets of parameters with 42 calls, 17 sets that init must refuse. The expected values were
 * computed by the generator, which runs this very program in the arithmetic of IEEE 754: the
 * operations are its own alone, so that a target has to give the same numbers.
 *
 * Outcomes of conditions that no input tried brings about are not exercised:
 *   PTC_FINITE_F32(q2_1): held with each of 3024 sets of parameters that passed the tests before
 *     it.
 *   PTC_FINITE_F32(e1_2): held with each of 3024 sets of parameters that passed the tests before
 *     it.
 *   PTC_FINITE_F32(e0_2): held with each of 3024 sets of parameters that passed the tests before
 *     it.
 *   PTC_FINITE_F32(w1_1): held with each of 3024 sets of parameters that passed the tests before
 *     it.
 *   params->h >= 1e-30f: held with each of 3024 sets of parameters that passed the tests before
 *     it.
 *   1.0f / params->h >= 1e-30f: held with each of 3024 sets of parameters that passed the tests
 *     before it.
 */
#ifndef STAGE7_SELFTEST_H
#define STAGE7_SELFTEST_H

#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/* The number of failed checks: 0 if the controller works on this machine. It uses no heap, output
 * or clock, and keeps no state. */
uint32_t stage7_selftest(void);

#ifdef __cplusplus
}
#endif

#endif
