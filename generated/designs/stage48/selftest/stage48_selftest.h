/*
 * Self-test of the prescribed-time controller stage48, for the target. DO NOT EDIT. Made by:
 *   ptc-codegen emit --lang c --n 3 --mu "exp(a=1)" --name stage48 --clock samples --A="[[0,1,0],[0,-0.5,1500],[0,-15,-600]]" --B="[0,0,500]" --C="[[1,0,0]]" --delay-law=predict --disturbance constant --observer-poles=-4,-5,-6,-7 --observer-samples=50 --tau=0.1 --eps=0.006 --u-max=24 --poles=least-energy --sample-time=1e-3 --delay=1.5 --selftest
 * Version 0.1.0.
 *
 * 5 sets of parameters with 51 calls, 0 sets that init must refuse. The expected values were
 * computed by the generator, which runs this very program in the arithmetic of IEEE 754: the
 * operations are its own alone, so that a target has to give the same numbers.
 *
 * Outcomes of conditions that no input tried brings about are not exercised:
 *   PTC_FINITE_F64(x3_on): never false in 744 calls.
 *   PTC_FINITE_F64(d_on): never false in 744 calls.
 */
#ifndef STAGE48_SELFTEST_H
#define STAGE48_SELFTEST_H

#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/* The number of failed checks: 0 if the controller works on this machine. It uses no heap, output
 * or clock, and keeps no state. */
uint32_t stage48_selftest(void);

#ifdef __cplusplus
}
#endif

#endif
