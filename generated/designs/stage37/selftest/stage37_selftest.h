/*
 * Self-test of the prescribed-time controller stage37, for the target. DO NOT EDIT. Made by:
 *   ptc-codegen emit --lang c --n 2 --mu exp --name stage37 --clock samples --eps=0 --u-min=runtime --selftest
 * Version 0.1.0.
 *
 * 6 sets of parameters with 53 calls, 44 sets that init must refuse. The expected values were
 * computed by the generator, which runs this very program in the arithmetic of IEEE 754: the
 * operations are its own alone, so that a target has to give the same numbers.
 *
 * Outcomes of conditions that no input tried brings about are not exercised:
 *   PTC_FINITE_F64(w1_2): held with each of 3068 sets of parameters that passed the tests before
 *     it.
 *   PTC_FINITE_F64(b_1): held with each of 3068 sets of parameters that passed the tests before
 *     it.
 *   PTC_FINITE_F64(b_2): held with each of 3068 sets of parameters that passed the tests before
 *     it.
 */
#ifndef STAGE37_SELFTEST_H
#define STAGE37_SELFTEST_H

#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/* The number of failed checks: 0 if the controller works on this machine. It uses no heap, output
 * or clock, and keeps no state. */
uint32_t stage37_selftest(void);

#ifdef __cplusplus
}
#endif

#endif
