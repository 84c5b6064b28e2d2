/*
 * Self-test of the prescribed-time controller stage39, for the target. DO NOT EDIT. Made by:
 *   ptc-codegen emit --lang c --n 1 --mu exp --name stage39 --clock samples --guard none --eps=0 --u-min=1/3 --selftest
 * Version 0.1.0.
 *
 * 5 sets of parameters with 42 calls, 39 sets that init must refuse. The expected values were
 * computed by the generator, which runs this very program in the arithmetic of IEEE 754: the
 * operations are its own alone, so that a target has to give the same numbers.
 *
 * Outcomes of conditions that no input tried brings about are not exercised:
 *   PTC_FINITE_F64(b_1): held with each of 3052 sets of parameters that passed the tests before
 *     it.
 *   params->h >= 1e-200: held with each of 3052 sets of parameters that passed the tests before
 *     it.
 *   1.0 / params->h >= 1e-200: held with each of 3052 sets of parameters that passed the tests
 *     before it.
 */
#ifndef STAGE39_SELFTEST_H
#define STAGE39_SELFTEST_H

#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/* The number of failed checks: 0 if the controller works on this machine. It uses no heap, output
 * or clock, and keeps no state. */
uint32_t stage39_selftest(void);

#ifdef __cplusplus
}
#endif

#endif
