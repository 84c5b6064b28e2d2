/*
 * Self-test of the prescribed-time controller stage25, for the target. DO NOT EDIT. Made by:
 *   ptc-codegen emit --lang c --mu "exp(a=1)" --name stage25 --clock samples --tau=0.3 --eps=0.04 --limits=2,3 --poles="[[-4],[-3,-4.5]]" --states="h, c, e" --inputs=q,p --outputs="h, e" --dynamics="q - 1/10*h, p - c*(1 + h), (c - e)*(1 + h)" --sample-time=0.01 --selftest
 * Version 0.1.0.
 *
 * 3 sets of parameters with 60 calls, 0 sets that init must refuse. The expected values were
 * computed by the generator, which runs this very program in the arithmetic of IEEE 754: the
 * operations are its own alone, so that a target has to give the same numbers.
 *
 * Outcomes of conditions that no input tried brings about are not exercised:
 *   m0_2 < 2.0: never true in 1084 calls.
 */
#ifndef STAGE25_SELFTEST_H
#define STAGE25_SELFTEST_H

#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/* The number of failed checks: 0 if the controller works on this machine. It uses no heap, output
 * or clock, and keeps no state. */
uint32_t stage25_selftest(void);

#ifdef __cplusplus
}
#endif

#endif
