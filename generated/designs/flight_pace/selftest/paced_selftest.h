/*
 * Self-test of the prescribed-time controller paced, for the target. DO NOT EDIT. Made by:
 *   ptc-codegen emit --lang c --n 2 --mu "exp(a=1)" --name paced --clock samples --late=extend --pace=soonest --tau=1 --eps=0 --u-min=-1 --poles=-4,-5,-6 --after zero --sample-time=0.01 --delay=1 --selftest
 * Version 0.1.0.
 *
 * 11 sets of parameters with 91 calls, 5 sets that init must refuse. The expected values were
 * computed by the generator, which runs this very program in the arithmetic of IEEE 754: the
 * operations are its own alone, so that a target has to give the same numbers.
 *
 * Outcomes of conditions that no input tried brings about are not exercised:
 *   elapsed < self->last: never false in 4461 calls.
 *   below < 3U: never true in 4461 calls.
 *   elapsed < 2147483648U: never false in 4461 calls.
 *   ahead > 0U: never false in 4461 calls.
 *   low < top: never false in 4461 calls.
 *   PTC_FINITE_F64(flat2): never false in 4461 calls.
 *   PTC_FINITE_F64(flat3): never false in 4461 calls.
 *   kept > 0U: never false in 4461 calls.
 */
#ifndef PACED_SELFTEST_H
#define PACED_SELFTEST_H

#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/* The number of failed checks: 0 if the controller works on this machine. It uses no heap, output
 * or clock, and keeps no state. */
uint32_t paced_selftest(void);

#ifdef __cplusplus
}
#endif

#endif
