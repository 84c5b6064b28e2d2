/*
 * Self-test of the prescribed-time controller stage35, for the target. DO NOT EDIT. Made by:
 *   ptc-codegen emit --lang c --mu "exp(a=1)" --name stage35 --clock samples --tau=0.3 --eps=0 --limits=20,30 --poles="[[-3,-4],[-4]]" --states="s, v, i" --inputs=F,V --outputs="s, i" --dynamics="v, 3*i - 2*s - v/2 + F, V - 4*i + s/8" --sample-time=0.01 --selftest
 * Version 0.1.0.
 *
 * 2 sets of parameters with 58 calls, 0 sets that init must refuse. The expected values were
 * computed by the generator, which runs this very program in the arithmetic of IEEE 754: the
 * operations are its own alone, so that a target has to give the same numbers.
 *
 * Outcomes of conditions that no input tried brings about are not exercised:
 *   PTC_FINITE_F64(control2): never false in 1084 calls.
 *   PTC_FINITE_F64(control1): never true in 1084 calls.
 *   PTC_FINITE_F64(control2): never true in 1084 calls.
 */
#ifndef STAGE35_SELFTEST_H
#define STAGE35_SELFTEST_H

#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/* The number of failed checks: 0 if the controller works on this machine. It uses no heap, output
 * or clock, and keeps no state. */
uint32_t stage35_selftest(void);

#ifdef __cplusplus
}
#endif

#endif
