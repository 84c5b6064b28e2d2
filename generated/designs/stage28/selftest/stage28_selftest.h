/*
 * Self-test of the prescribed-time controller stage28, for the target. DO NOT EDIT. Made by:
 *   ptc-codegen emit --lang c --mu "exp(a=1)" --name stage28 --clock samples --deadbeat=9 --eps=0 --gains="[[3],[4.5]]" --states="a, b" --inputs=A,B --outputs="a, b" --dynamics="A*(b - 1), A + B - k*a" --selftest
 * Version 0.1.0.
 *
 * 5 sets of parameters with 54 calls, 20 sets that init must refuse. The expected values were
 * computed by the generator, which runs this very program in the arithmetic of IEEE 754: the
 * operations are its own alone, so that a target has to give the same numbers.
 *
 * Outcomes of conditions that no input tried brings about are not exercised:
 *   PTC_FINITE_F64(w1_1_1): held with each of 3032 sets of parameters that passed the tests
 *     before it.
 *   PTC_FINITE_F64(b_1_1): held with each of 3032 sets of parameters that passed the tests
 *     before it.
 *   PTC_FINITE_F64(w1_1_2): held with each of 3032 sets of parameters that passed the tests
 *     before it.
 *   PTC_FINITE_F64(c1): held with each of 3032 sets of parameters that passed the tests before
 *     it.
 *   params->h >= 1e-200: held with each of 3032 sets of parameters that passed the tests before
 *     it.
 *   1.0 / params->h >= 1e-200: held with each of 3032 sets of parameters that passed the tests
 *     before it.
 *   PTC_FINITE_F64(control2): never true in 2175 calls.
 */
#ifndef STAGE28_SELFTEST_H
#define STAGE28_SELFTEST_H

#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/* The number of failed checks: 0 if the controller works on this machine. It uses no heap, output
 * or clock, and keeps no state. */
uint32_t stage28_selftest(void);

#ifdef __cplusplus
}
#endif

#endif
