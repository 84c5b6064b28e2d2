/*
 * Self-test of the prescribed-time observer stage16_observer, for the target. DO NOT EDIT. Made by:
 *   ptc-codegen emit --lang c --n 3 --mu "exp(a=1)" --name stage16 --what observer --clock samples --A="[[0,1,0],[0,-0.5,1500],[0,-15,-600]]" --B="[0,0,500]" --C="[[1,0,0],[0,0,1]]" --disturbance constant --observer-poles=-4,-5,-6,-7 --observer-samples=20 --after-observer=-90+20i,-90-20i,-100,-120 --sample-time=1e-3 --delay=1 --selftest
 * Version 0.1.0.
 *
 * 4 sets of parameters with 49 calls, 0 sets that init must refuse. The expected values were
 * computed by the generator, which runs this very program in the arithmetic of IEEE 754: the
 * operations are its own alone, so that a target has to give the same numbers.
 *
 * Outcomes of conditions that no input tried brings about are not exercised:
 *   PTC_FINITE_F64(x1): never false in 673 calls.
 *   PTC_FINITE_F64(x2): never false in 673 calls.
 *   PTC_FINITE_F64(x3): never false in 673 calls.
 *   PTC_FINITE_F64(x3_on): never false in 673 calls.
 *   PTC_FINITE_F64(d): never false in 673 calls.
 *   PTC_FINITE_F64(d_on): never false in 673 calls.
 */
#ifndef STAGE16_OBSERVER_SELFTEST_H
#define STAGE16_OBSERVER_SELFTEST_H

#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/* The number of failed checks: 0 if the observer works on this machine. It uses no heap, output
 * or clock, and keeps no state. */
uint32_t stage16_observer_selftest(void);

#ifdef __cplusplus
}
#endif

#endif
