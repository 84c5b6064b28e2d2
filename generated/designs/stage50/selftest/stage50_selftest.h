/*
 * Self-test of the prescribed-time controller stage50, for the target. DO NOT EDIT. Made by:
 *   ptc-codegen emit --lang c --n 2 --mu "exp(a=1)" --name stage50 --clock samples --A="[[-1,1],[3,-2]]" --B="[1,2]" --output="[-2,1]" --tau=0.2 --eps=0 --poles="least-energy(weight=1)" --reference input --sample-time=0.01 --selftest
 * Version 0.1.0.
 *
 * 3 sets of parameters with 69 calls, 5 sets that init must refuse. The expected values were
 * computed by the generator, which runs this very program in the arithmetic of IEEE 754: the
 * operations are its own alone, so that a target has to give the same numbers.
 */
#ifndef STAGE50_SELFTEST_H
#define STAGE50_SELFTEST_H

#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/* The number of failed checks: 0 if the controller works on this machine. It uses no heap, output
 * or clock, and keeps no state. */
uint32_t stage50_selftest(void);

#ifdef __cplusplus
}
#endif

#endif
