/*
 * Self-test of the prescribed-time controller table, for the target. DO NOT EDIT. Made by:
 *   ptc-codegen emit --lang c --n 2 --mu "exp(a=1)" --name table --tau=1 --eps=4.93e-2 --u-max=0.5 --poles=-4,-5 --g="50" --sample-time=5e-3 --error=1e-3,1e-2 --x0-max=1,0.5 --selftest
 * Version 0.1.0.
 *
 * 5 sets of parameters with 42 calls, 3 sets that init must refuse. The expected u was
 * computed from the definition of the controller with 42 or more digits; its tolerance is
 * 1e-14 of the sum of the absolute values of its terms.
 *
 * Outcomes of conditions that no input tried brings about are not exercised:
 *   PTC_FINITE_F64(deadline): tau is fixed, and less than the last place of the greatest start.
 *   (status == PTC_OK): arm takes every start time that init takes.
 */
#ifndef TABLE_SELFTEST_H
#define TABLE_SELFTEST_H

#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/* The number of failed checks: 0 if the controller works on this machine. It uses no heap, output
 * or clock, and keeps no state. */
uint32_t table_selftest(void);

#ifdef __cplusplus
}
#endif

#endif
