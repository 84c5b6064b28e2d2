/*
 * Self-test of the prescribed-time observer stage41_observer, for the target. DO NOT EDIT. Made by:
 *   ptc-codegen emit --lang c --n 3 --mu "exp(a=1)" --name stage41 --what observer --clock samples --A="[[0,1,0],[0,-0.5,15],[0,-15,-60]]" --B="[0,0,50]" --C="[[1,0,0],[0,0,1]]" --observer-poles=-4,-5,-6 --observer-samples=20 --innovation-max=1,0.75 --coast=1 --precision f32 --sample-time=0.01 --selftest
 * Version 0.1.0.
 *
 * 2 sets of parameters with 56 calls, 0 sets that init must refuse. The expected values were
 * computed by the generator, which runs this very program in the arithmetic of IEEE 754: the
 * operations are its own alone, so that a target has to give the same numbers.
 *
 * Outcomes of conditions that no input tried brings about are not exercised:
 *   PTC_FINITE_F32(x1): never false in 681 calls.
 *   PTC_FINITE_F32(x1_on): never false in 681 calls.
 *   PTC_FINITE_F32(x2): never false in 681 calls.
 *   PTC_FINITE_F32(x2_on): never false in 681 calls.
 *   PTC_FINITE_F32(x3): never false in 681 calls.
 *   PTC_FINITE_F32(x3_on): never false in 681 calls.
 */
#ifndef STAGE41_OBSERVER_SELFTEST_H
#define STAGE41_OBSERVER_SELFTEST_H

#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/* The number of failed checks: 0 if the observer works on this machine. It uses no heap, output
 * or clock, and keeps no state. */
uint32_t stage41_observer_selftest(void);

#ifdef __cplusplus
}
#endif

#endif
