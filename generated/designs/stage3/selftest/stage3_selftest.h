/*
 * Self-test of the prescribed-time controller stage3, for the target. DO NOT EDIT. Made by:
 *   ptc-codegen emit --lang c --n 2 --mu "exp(a=1)" --name stage3 --clock samples --measured=x1 --disturbance constant --observer-poles=-4,-5,-6 --observer-samples=20 --tau=0.04 --eps=0 --poles=-4,-5,-6 --sample-time=1e-3 --delay=1 --selftest
 * Version 0.1.0.
 *
 * 4 sets of parameters with 49 calls, 5 sets that init must refuse. The expected values were
 * computed by the generator, which runs this very program in the arithmetic of IEEE 754: the
 * operations are its own alone, so that a target has to give the same numbers.
 */
#ifndef STAGE3_SELFTEST_H
#define STAGE3_SELFTEST_H

#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/* The number of failed checks: 0 if the controller works on this machine. It uses no heap, output
 * or clock, and keeps no state. */
uint32_t stage3_selftest(void);

#ifdef __cplusplus
}
#endif

#endif
