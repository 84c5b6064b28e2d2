/*
 * Self-test of the prescribed-time controller shaken, for the target. DO NOT EDIT. Made by:
 *   ptc-codegen emit --lang c --n 2 --mu "exp(a=1)" --name shaken --clock samples --delay-law=predict --measured=x1 --disturbance="sine(omega=60)" --observer-poles=-4,-5,-6,-7 --observer-samples=200 --observer-eps=0.03 --tau=0.6 --eps=0.01 --u-max=8 --poles="least-energy(weight=1)" --g="2" --sample-time=1e-3 --delay=1.75 --sensor-step=1e-6,0 --selftest
 * Version 0.1.0.
 *
 * 4 sets of parameters with 48 calls, 0 sets that init must refuse. The expected values were
 * computed by the generator, which runs this very program in the arithmetic of IEEE 754: the
 * operations are its own alone, so that a target has to give the same numbers.
 */
#ifndef SHAKEN_SELFTEST_H
#define SHAKEN_SELFTEST_H

#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/* The number of failed checks: 0 if the controller works on this machine. It uses no heap, output
 * or clock, and keeps no state. */
uint32_t shaken_selftest(void);

#ifdef __cplusplus
}
#endif

#endif
