/*
 * Self-test of the prescribed-time controller late_stage, for the target. DO NOT EDIT. Made by:
 *   ptc-codegen emit --lang c --n 2 --mu "exp(a=1)" --name late_stage --clock samples --delay-law=predict --poles-end="least-energy(weight=1)" --end-samples=50 --late=extend --reserve=0.1 --measured=x1 --disturbance constant --observer-poles=-4,-5,-6 --observer-samples=200 --observer-eps=0.03 --tau=0.8 --eps=0.02 --u-max=6 --poles=least-energy --g="2/3" --sample-time=1e-3 --delay=1 --sensor-step=1e-6,0 --selftest
 * Version 0.1.0.
 *
 * 5 sets of parameters with 80 calls, 0 sets that init must refuse. The expected values were
 * computed by the generator, which runs this very program in the arithmetic of IEEE 754: the
 * operations are its own alone, so that a target has to give the same numbers.
 *
 * Outcomes of conditions that no input tried brings about are not exercised:
 *   elapsed < 2147483648U: never false in 3915 calls.
 *   m0 < 2.0: never true in 3915 calls.
 *   low < top: never false in 3915 calls.
 *   PTC_FINITE_F64(flat1): never false in 3915 calls.
 *   PTC_FINITE_F64(flat2): never false in 3915 calls.
 *   PTC_FINITE_F64(n2): never false in 3915 calls.
 */
#ifndef LATE_STAGE_SELFTEST_H
#define LATE_STAGE_SELFTEST_H

#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/* The number of failed checks: 0 if the controller works on this machine. It uses no heap, output
 * or clock, and keeps no state. */
uint32_t late_stage_selftest(void);

#ifdef __cplusplus
}
#endif

#endif
