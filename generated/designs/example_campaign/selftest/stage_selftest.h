/*
 * Self-test of the prescribed-time controller stage, for the target. DO NOT EDIT. Made by:
 *   ptc-codegen emit --lang c --n 3 --mu "exp(a=1)" --name stage --poles=-4,-5,-6 --selftest
 * Version 0.1.0.
 *
 * 6 sets of parameters with 55 calls, 20 sets that init must refuse. The expected u was
 * computed from the definition of the controller with 42 or more digits; its tolerance is
 * 1e-14 of the sum of the absolute values of its terms.
 *
 * Outcomes of conditions that no input tried brings about are not exercised:
 *   PTC_FINITE_F64(hold_from): the negative of a parameter that is finite.
 *   (status == PTC_OK): arm takes every start time that init takes.
 */
#ifndef STAGE_SELFTEST_H
#define STAGE_SELFTEST_H

#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/* The number of failed checks: 0 if the controller works on this machine. It uses no heap, output
 * or clock, and keeps no state. */
uint32_t stage_selftest(void);

#ifdef __cplusplus
}
#endif

#endif
