/*
 * Self-test of the prescribed-time controller stage47, for the target. DO NOT EDIT. Made by:
 *   ptc-codegen emit --lang c --n 3 --mu "exp(a=1)" --name stage47 --clock samples --A="[[0,1,0],[0,-0.5,15],[0,-15,-60]]" --B="[0,0,50]" --C="[[1,0,0],[0,0,1]]" --disturbance constant --observer-poles=-4,-5,-6,-7 --observer-samples=20 --after-observer=stationary --disturbance-walk=1/2 --eps=0.06 --poles=-3,-4,-5 --sample-time=0.01 --noise=1e-5,1e-3 --selftest
 * Version 0.1.0.
 *
 * 5 sets of parameters with 55 calls, 7 sets that init must refuse. The expected values were
 * computed by the generator, which runs this very program in the arithmetic of IEEE 754: the
 * operations are its own alone, so that a target has to give the same numbers.
 *
 * Outcomes of conditions that no input tried brings about are not exercised:
 *   PTC_FINITE_F64(x1_on): never false in 1378 calls.
 *   PTC_FINITE_F64(x3_on): never false in 1378 calls.
 *   PTC_FINITE_F64(d_on): never false in 1378 calls.
 */
#ifndef STAGE47_SELFTEST_H
#define STAGE47_SELFTEST_H

#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/* The number of failed checks: 0 if the controller works on this machine. It uses no heap, output
 * or clock, and keeps no state. */
uint32_t stage47_selftest(void);

#ifdef __cplusplus
}
#endif

#endif
