/*
 * Self-test of the prescribed-time observer drift_observer, for the target. DO NOT EDIT. Made by:
 *   ptc-codegen emit --lang c --n 3 --mu "exp(a=1)" --name drift --what observer --clock samples --measured=x1,x2 --disturbance ramp --observer-poles=-4,-5,-6,-7 --observer-samples=60 --selftest
 * Version 0.1.0.
 *
 * 4 sets of parameters with 51 calls, 14 sets that init must refuse. The expected values were
 * computed by the generator, which runs this very program in the arithmetic of IEEE 754: the
 * operations are its own alone, so that a target has to give the same numbers.
 *
 * Outcomes of conditions that no input tried brings about are not exercised:
 *   PTC_FINITE_F64(phi1_3): held with each of 3012 sets of parameters that passed the tests
 *     before it.
 *   PTC_FINITE_F64(q2_1): held with each of 3012 sets of parameters that passed the tests before
 *     it.
 *   PTC_FINITE_F64(q2_2): held with each of 3012 sets of parameters that passed the tests before
 *     it.
 *   PTC_FINITE_F64(q2_3): held with each of 3012 sets of parameters that passed the tests before
 *     it.
 *   PTC_FINITE_F64(q3_1): held with each of 3012 sets of parameters that passed the tests before
 *     it.
 *   PTC_FINITE_F64(q3_2): held with each of 3012 sets of parameters that passed the tests before
 *     it.
 *   PTC_FINITE_F64(e3_2): held with each of 3012 sets of parameters that passed the tests before
 *     it.
 *   PTC_FINITE_F64(e3_3): held with each of 3012 sets of parameters that passed the tests before
 *     it.
 *   PTC_FINITE_F64(e3_4): held with each of 3012 sets of parameters that passed the tests before
 *     it.
 *   PTC_FINITE_F64(e2_2): held with each of 3012 sets of parameters that passed the tests before
 *     it.
 *   PTC_FINITE_F64(e2_4): held with each of 3012 sets of parameters that passed the tests before
 *     it.
 *   PTC_FINITE_F64(e1_2): held with each of 3012 sets of parameters that passed the tests before
 *     it.
 *   PTC_FINITE_F64(e1_3): held with each of 3012 sets of parameters that passed the tests before
 *     it.
 *   PTC_FINITE_F64(e1_4): held with each of 3012 sets of parameters that passed the tests before
 *     it.
 *   PTC_FINITE_F64(e0_2): held with each of 3012 sets of parameters that passed the tests before
 *     it.
 *   PTC_FINITE_F64(e0_3): held with each of 3012 sets of parameters that passed the tests before
 *     it.
 *   PTC_FINITE_F64(e0_4): held with each of 3012 sets of parameters that passed the tests before
 *     it.
 *   PTC_FINITE_F64(d): never false in 700 calls.
 *   PTC_FINITE_F64(d_rate): never false in 700 calls.
 */
#ifndef DRIFT_OBSERVER_SELFTEST_H
#define DRIFT_OBSERVER_SELFTEST_H

#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/* The number of failed checks: 0 if the observer works on this machine. It uses no heap, output
 * or clock, and keeps no state. */
uint32_t drift_observer_selftest(void);

#ifdef __cplusplus
}
#endif

#endif
