/*
 * Self-test of the prescribed-time controller duration_latched, for the target. DO NOT EDIT. Made by:
 *   ptc-codegen emit --lang c --n 2 --kappa="dt/(c*tau*(tau - dt)) + dt" --name duration_latched --in-flight --pi0="-6*xi1 - 5*xi2 + xi1_0/8" --param "c=[0.5,2]" --allow=growth --selftest
 * Version 0.1.0.
 *
 * 7 sets of parameters with 62 calls, 25 sets that init must refuse. The expected u was
 * computed from the definition of the controller with 42 or more digits; its tolerance is
 * 2e-12 of the sum of the absolute values of its terms.
 *
 * Outcomes of conditions that no input tried brings about are not exercised:
 *   PTC_FINITE_F64(hold_from): the negative of a parameter that is finite.
 *   PTC_FINITE_F64(deadline): in arm_for: a legal tau is less than the last place of the
 *     greatest start.
 *   PTC_FINITE_F64(f44): in arm_for: none of 3000 sets of parameters, drawn up to the ends of
 *     the range, fails it.
 *   PTC_FINITE_F64(f44): none of 3000 sets of parameters, drawn up to the ends of the range,
 *     fails it.
 */
#ifndef DURATION_LATCHED_SELFTEST_H
#define DURATION_LATCHED_SELFTEST_H

#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/* The number of failed checks: 0 if the controller works on this machine. It uses no heap, output
 * or clock, and keeps no state. */
uint32_t duration_latched_selftest(void);

#ifdef __cplusplus
}
#endif

#endif
