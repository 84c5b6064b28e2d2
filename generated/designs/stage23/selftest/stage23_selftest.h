/*
 * Self-test of the prescribed-time controller stage23, for the target. DO NOT EDIT. Made by:
 *   ptc-codegen emit --lang c --n 3 --mu "exp(a=1)" --name stage23 --clock samples --A="[[0,1,0],[0,-1,10],[0,-2,-50]]" --B="[0,0,100]" --C="[[1,0,0]]" --output="[1,0,0]" --observer-poles=-4,-5,-6 --observer-samples=25 --tau=0.5 --eps=0 --poles=-4,-5,-6,-7 --reference input --sample-time=0.01 --delay=1 --selftest
 * Version 0.1.0.
 *
 * 4 sets of parameters with 73 calls, 5 sets that init must refuse. The expected values were
 * computed by the generator, which runs this very program in the arithmetic of IEEE 754: the
 * operations are its own alone, so that a target has to give the same numbers.
 *
 * Outcomes of conditions that no input tried brings about are not exercised:
 *   PTC_FINITE_F64(x1_on): never false in 1384 calls.
 *   PTC_FINITE_F64(x2_on): never false in 1384 calls.
 *   PTC_FINITE_F64(x3_on): never false in 1384 calls.
 */
#ifndef STAGE23_SELFTEST_H
#define STAGE23_SELFTEST_H

#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/* The number of failed checks: 0 if the controller works on this machine. It uses no heap, output
 * or clock, and keeps no state. */
uint32_t stage23_selftest(void);

#ifdef __cplusplus
}
#endif

#endif
