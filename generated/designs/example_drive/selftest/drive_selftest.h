/*
 * Self-test of the prescribed-time controller drive, for the target. DO NOT EDIT. Made by:
 *   ptc-codegen emit --lang c --n 3 --mu "exp(a=1)" --name drive --tau=0.4 --u-max=24 --poles=-4,-5,-6 --states="q, w, i" --input=V --output="q" --dynamics="w, (k*i - b*w)/J, (V - R*i - k*w)/L" --param J=2e-5 --param L=2e-3 --param R=1.2 --param b=1e-5 --param k=0.03 --selftest
 * Version 0.1.0.
 *
 * 5 sets of parameters with 54 calls, 10 sets that init must refuse. The expected u was
 * computed from the definition of the controller with 42 or more digits; its tolerance is
 * 1e-14 of the sum of the absolute values of its terms.
 *
 * Outcomes of conditions that no input tried brings about are not exercised:
 *   PTC_FINITE_F64(hold_from): the negative of a parameter that is finite.
 *   PTC_FINITE_F64(deadline): tau is fixed, and less than the last place of the greatest start.
 *   (status == PTC_OK): arm takes every start time that init takes.
 */
#ifndef DRIVE_SELFTEST_H
#define DRIVE_SELFTEST_H

#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/* The number of failed checks: 0 if the controller works on this machine. It uses no heap, output
 * or clock, and keeps no state. */
uint32_t drive_selftest(void);

#ifdef __cplusplus
}
#endif

#endif
