/*
 * Self-test of the prescribed-time observer stage17_observer, for the target. DO NOT EDIT. Made by:
 *   ptc-codegen emit --lang c --n 2 --mu "exp(a=1)" --name stage17 --what observer --clock samples --disturbance constant --observer-poles=-4,-5 --observer-samples=8 --guard none --selftest
 * Version 0.1.0.
 *
 * 4 sets of parameters with 28 calls, 12 sets that init must refuse. The expected values were
 * computed by the generator, which runs this very program in the arithmetic of IEEE 754: the
 * operations are its own alone, so that a target has to give the same numbers.
 *
 * Outcomes of conditions that no input tried brings about are not exercised:
 *   PTC_FINITE_F64(q2_1): held with each of 3012 sets of parameters that passed the tests before
 *     it.
 *   PTC_FINITE_F64(e1_2): held with each of 3012 sets of parameters that passed the tests before
 *     it.
 *   PTC_FINITE_F64(e0_2): held with each of 3012 sets of parameters that passed the tests before
 *     it.
 */
#ifndef STAGE17_OBSERVER_SELFTEST_H
#define STAGE17_OBSERVER_SELFTEST_H

#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/* The number of failed checks: 0 if the observer works on this machine. It uses no heap, output
 * or clock, and keeps no state. */
uint32_t stage17_observer_selftest(void);

#ifdef __cplusplus
}
#endif

#endif
