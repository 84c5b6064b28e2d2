/*
 * Self-test of the prescribed-time controller stage40, for the target. DO NOT EDIT. Made by:
 *   ptc-codegen emit --lang c --n 2 --mu "exp(a=1)" --name stage40 --clock samples --measured=x1 --disturbance constant --observer-poles=-4,-5,-6 --observer-samples=20 --innovation-max=0.5 --measurement-max=1.5 --coast=2 --tau=0.04 --eps=0 --u-max=6 --poles=-4,-5,-6 --reference input --sample-time=1e-3 --delay=1 --selftest
 * Version 0.1.0.
 *
 * 3 sets of parameters with 75 calls, 0 sets that init must refuse. The expected values were
 * computed by the generator, which runs this very program in the arithmetic of IEEE 754: the
 * operations are its own alone, so that a target has to give the same numbers.
 *
 * Outcomes of conditions that no input tried brings about are not exercised:
 *   size <= 1e150: never false in 708 calls.
 */
#ifndef STAGE40_SELFTEST_H
#define STAGE40_SELFTEST_H

#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/* The number of failed checks: 0 if the controller works on this machine. It uses no heap, output
 * or clock, and keeps no state. */
uint32_t stage40_selftest(void);

#ifdef __cplusplus
}
#endif

#endif
