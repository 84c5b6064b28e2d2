/*
 * Self-test of the prescribed-time controller table_too_soon, for the target. DO NOT EDIT. Made by:
 *   ptc-codegen emit --lang c --n 3 --axes 2 --mu "exp(a=1)" --name table_too_soon --clock samples --late=refuse --state-max=inf,0.5,4 --tau=1.5 --eps=0 --u-min=runtime --poles="[[-3,-4,-5],[-4,-5,-6]]" --sample-time=0.01 --selftest
 * Version 0.1.0.
 *
 * 5 sets of parameters with 78 calls, 4 sets that init must refuse. The expected values were
 * computed by the generator, which runs this very program in the arithmetic of IEEE 754: the
 * operations are its own alone, so that a target has to give the same numbers.
 *
 * Outcomes of conditions that no input tried brings about are not exercised:
 *   arm_for: a function that is not called here.
 *   soonest: a function that is not called here.
 *   deadline: a function that is not called here.
 */
#ifndef TABLE_TOO_SOON_SELFTEST_H
#define TABLE_TOO_SOON_SELFTEST_H

#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/* The number of failed checks: 0 if the controller works on this machine. It uses no heap, output
 * or clock, and keeps no state. */
uint32_t table_too_soon_selftest(void);

#ifdef __cplusplus
}
#endif

#endif
