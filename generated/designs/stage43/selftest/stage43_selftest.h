/*
 * Self-test of the prescribed-time controller stage43, for the target. DO NOT EDIT. Made by:
 *   ptc-codegen emit --lang c --n 3 --mu "exp(a=1)" --name stage43 --clock samples --delay-law=predict --measured=x1 --disturbance constant --observer-poles=-4,-5,-6,-7 --observer-samples=20 --tau=0.4 --eps=0 --u-max=6 --poles="least-energy(weight=1)" --reference="t^2/2" --sample-time=1e-2 --delay=2.75 --selftest
 * Version 0.1.0.
 *
 * 3 sets of parameters with 47 calls, 0 sets that init must refuse. The expected values were
 * computed by the generator, which runs this very program in the arithmetic of IEEE 754: the
 * operations are its own alone, so that a target has to give the same numbers.
 *
 * Outcomes of conditions that no input tried brings about are not exercised:
 *   v < -STAGE43_U_MAX: never false in 688 calls.
 *   v < -STAGE43_U_MAX: never false in 688 calls.
 *   elapsed < STAGE43_SAMPLES: never true in 688 calls.
 *   elapsed < STAGE43_SAMPLES: never false in 688 calls.
 */
#ifndef STAGE43_SELFTEST_H
#define STAGE43_SELFTEST_H

#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/* The number of failed checks: 0 if the controller works on this machine. It uses no heap, output
 * or clock, and keeps no state. */
uint32_t stage43_selftest(void);

#ifdef __cplusplus
}
#endif

#endif
