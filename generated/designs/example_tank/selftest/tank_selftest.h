/*
 * Self-test of the prescribed-time controller tank, for the target. DO NOT EDIT. Made by:
 *   ptc-codegen emit --lang c --mu "exp(a=1)" --name tank --tau=30 --eps=0.5 --limits=2,50 --poles="[[-4],[-3,-4]]" --states="h, c, e" --inputs=q,p --outputs="h, e" --dynamics="q - 1/10*h, p - c*(1 + h), (c - e)*(1 + h)" --selftest
 * Version 0.1.0.
 *
 * 7 sets of parameters with 56 calls, 3 sets that init must refuse. The expected u was
 * computed from the definition of the controller with 42 or more digits; its tolerance is
 * 1e-14 of the sum of the absolute values of its terms.
 *
 * Outcomes of conditions that no input tried brings about are not exercised:
 *   PTC_FINITE_F64(deadline): tau is fixed, and less than the last place of the greatest start.
 *   (status == PTC_OK): arm takes every start time that init takes.
 *   PTC_FINITE_F64(control2): it was never the first u that is no number, or never finite beside
 *     one, in 400 random calls, nor at the ends of the range.
 */
#ifndef TANK_SELFTEST_H
#define TANK_SELFTEST_H

#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/* The number of failed checks: 0 if the controller works on this machine. It uses no heap, output
 * or clock, and keeps no state. */
uint32_t tank_selftest(void);

#ifdef __cplusplus
}
#endif

#endif
