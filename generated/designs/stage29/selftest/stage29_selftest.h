/*
 * Self-test of the prescribed-time controller stage29, for the target. DO NOT EDIT. Made by:
 *   ptc-codegen emit --lang c --n 2 --axes 3 --mu "exp(a=1)" --name stage29 --clock samples --tau=0.3 --eps=0 --limits=1,2,3 --poles="[[-4,-5],[-3+i,-3-i],[-6,-7.5]]" --g="[1/2, 2, -1]" --sample-time=0.01 --selftest
 * Version 0.1.0.
 *
 * 3 sets of parameters with 77 calls, 0 sets that init must refuse. The expected values were
 * computed by the generator, which runs this very program in the arithmetic of IEEE 754: the
 * operations are its own alone, so that a target has to give the same numbers.
 */
#ifndef STAGE29_SELFTEST_H
#define STAGE29_SELFTEST_H

#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/* The number of failed checks: 0 if the controller works on this machine. It uses no heap, output
 * or clock, and keeps no state. */
uint32_t stage29_selftest(void);

#ifdef __cplusplus
}
#endif

#endif
