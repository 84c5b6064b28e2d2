/*
 * Self-test of the prescribed-time controller gantry_in_flight, for the target. DO NOT EDIT. Made by:
 *   ptc-codegen emit --lang c --n 2 --axes 3 --mu "exp(a=1)" --name gantry_in_flight --clock samples --poles-end="least-energy(weight=1)" --end-samples=50 --late=extend --pace=soonest --state-max="[[inf,1.5],[inf,inf],[inf,0.4]]" --reserve=0.1 --tau=1.5 --eps=0.02 --limits="[[-900,900],[-400,400],[-150,60]]" --poles=least-energy --g="[1/120, 1/45, 1/12]" --sample-time=1e-3 --selftest
 * Version 0.1.0.
 *
 * 4 sets of parameters with 195 calls, 0 sets that init must refuse. The expected values were
 * computed by the generator, which runs this very program in the arithmetic of IEEE 754: the
 * operations are its own alone, so that a target has to give the same numbers.
 *
 * Outcomes of conditions that no input tried brings about are not exercised:
 *   -least_1 < most_1: never true in 4328 calls.
 *   -least_2 < most_2: never true in 4328 calls.
 *   -least_3 < most_3: never true in 4328 calls.
 *   m0_1 < 2.0: never true in 4328 calls.
 *   m0_2 < 2.0: never true in 4328 calls.
 *   m0_3 < 2.0: never true in 4328 calls.
 *   -least_1 < most_1: never true in 4328 calls.
 *   -least_2 < most_2: never true in 4328 calls.
 *   -least_3 < most_3: never true in 4328 calls.
 *   low < top: never false in 4328 calls.
 *   PTC_FINITE_F64(flat2_1): never false in 4328 calls.
 *   PTC_FINITE_F64(flat2_2): never false in 4328 calls.
 *   PTC_FINITE_F64(flat2_3): never false in 4328 calls.
 */
#ifndef GANTRY_IN_FLIGHT_SELFTEST_H
#define GANTRY_IN_FLIGHT_SELFTEST_H

#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/* The number of failed checks: 0 if the controller works on this machine. It uses no heap, output
 * or clock, and keeps no state. */
uint32_t gantry_in_flight_selftest(void);

#ifdef __cplusplus
}
#endif

#endif
