/*
 * Self-test of the prescribed-time controller stage46, for the target. DO NOT EDIT. Made by:
 *   ptc-codegen emit --lang c --n 2 --mu "exp(a=1)" --name stage46 --clock samples --delay-law=predict --measured=x1 --disturbance constant --observer=stationary --disturbance-walk=1 --tau=0.04 --eps=0 --u-max=6 --poles=least-energy --sample-time=1e-3 --delay=1 --sensor-step=1e-6,0 --selftest
 * Version 0.1.0.
 *
 * 3 sets of parameters with 47 calls, 0 sets that init must refuse. The expected values were
 * computed by the generator, which runs this very program in the arithmetic of IEEE 754: the
 * operations are its own alone, so that a target has to give the same numbers.
 */
#ifndef STAGE46_SELFTEST_H
#define STAGE46_SELFTEST_H

#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/* The number of failed checks: 0 if the controller works on this machine. It uses no heap, output
 * or clock, and keeps no state. */
uint32_t stage46_selftest(void);

#ifdef __cplusplus
}
#endif

#endif
