/*
 * Self-test of the prescribed-time controller motor_late, for the target. DO NOT EDIT. Made by:
 *   ptc-codegen emit --lang c --n 2 --mu "exp(a=1)" --name motor_late --clock samples --A="[[0,1],[0,-5]]" --B="[0,40]" --late=extend --state-max=inf,2 --tau=0.2 --eps=0 --u-max=10 --poles=least-energy --sample-time=0.01 --selftest
 * Version 0.1.0.
 *
 * 5 sets of parameters with 67 calls, 0 sets that init must refuse. The expected values were
 * computed by the generator, which runs this very program in the arithmetic of IEEE 754: the
 * operations are its own alone, so that a target has to give the same numbers.
 *
 * Outcomes of conditions that no input tried brings about are not exercised:
 *   low < top: never false in 3679 calls.
 *   PTC_FINITE_F64(x1): never false in 3679 calls.
 *   PTC_FINITE_F64(x2): never false in 3679 calls.
 */
#ifndef MOTOR_LATE_SELFTEST_H
#define MOTOR_LATE_SELFTEST_H

#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/* The number of failed checks: 0 if the controller works on this machine. It uses no heap, output
 * or clock, and keeps no state. */
uint32_t motor_late_selftest(void);

#ifdef __cplusplus
}
#endif

#endif
