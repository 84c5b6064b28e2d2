/*
 * Self-test of the prescribed-time observer stage15_observer, for the target. DO NOT EDIT. Made by:
 *   ptc-codegen emit --lang c --n 2 --mu "exp(a=1.5)" --name stage15 --what observer --clock samples --measured=x1 --disturbance constant --observer-poles=-4,-5,-6 --observer-samples=9 --observer-eps=0.05 --precision f32 --f="-981/100" --g="1/2" --delay=1.5 --selftest
 * Version 0.1.0.
 *
 * 4 sets of parameters with 42 calls, 13 sets that init must refuse. The expected values were
 * computed by the generator, which runs this very program in the arithmetic of IEEE 754: the
 * operations are its own alone, so that a target has to give the same numbers.
 *
 * Outcomes of conditions that no input tried brings about are not exercised:
 *   PTC_FINITE_F32(phi1_3): held with each of 3012 sets of parameters that passed the tests
 *     before it.
 *   PTC_FINITE_F32(gamma1): held with each of 3012 sets of parameters that passed the tests
 *     before it.
 *   PTC_FINITE_F32(late_gamma1): held with each of 3012 sets of parameters that passed the tests
 *     before it.
 *   PTC_FINITE_F32(phi2_3): held with each of 3012 sets of parameters that passed the tests
 *     before it.
 *   PTC_FINITE_F32(gamma2): held with each of 3012 sets of parameters that passed the tests
 *     before it.
 *   PTC_FINITE_F32(hold_o): held with each of 3012 sets of parameters that passed the tests
 *     before it.
 *   PTC_FINITE_F32(q2_1): held with each of 3012 sets of parameters that passed the tests before
 *     it.
 *   PTC_FINITE_F32(q2_2): held with each of 3012 sets of parameters that passed the tests before
 *     it.
 *   PTC_FINITE_F32(q3_1): held with each of 3012 sets of parameters that passed the tests before
 *     it.
 *   PTC_FINITE_F32(d): never false in 650 calls.
 */
#ifndef STAGE15_OBSERVER_SELFTEST_H
#define STAGE15_OBSERVER_SELFTEST_H

#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/* The number of failed checks: 0 if the observer works on this machine. It uses no heap, output
 * or clock, and keeps no state. */
uint32_t stage15_observer_selftest(void);

#ifdef __cplusplus
}
#endif

#endif
