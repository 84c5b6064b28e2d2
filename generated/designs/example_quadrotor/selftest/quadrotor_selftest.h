/*
 * Self-test of the prescribed-time controller quadrotor, for the target. DO NOT EDIT. Made by:
 *   ptc-codegen emit --lang c --n 2 --axes 4 --mu "exp(a=1)" --name quadrotor --tau=2 --t0=0 --eps=0.02 --limits=8,0.4,0.4,0.1 --poles="[[-4,-5],[-6,-7],[-6,-7],[-4,-5]]" --g="[1/m, 1/Ix, 1/Iy, 1/Iz]" --reference input --param Ix=0.012 --param Iy=0.013 --param Iz=0.022 --param m=1.2 --sample-time=1e-3 --selftest
 * Version 0.1.0.
 *
 * 35 sets of parameters with 192 calls, 0 sets that init must refuse. The expected u was
 * computed from the definition of the controller with 42 or more digits; its tolerance is
 * 1e-14 of the sum of the absolute values of its terms.
 *
 * Outcomes of conditions that no input tried brings about are not exercised:
 *   PTC_FINITE_F64(deadline): tau is fixed, and less than the last place of the greatest start.
 *   (status == PTC_OK): arm takes every start time that init takes.
 *   g < 0.0: g was not negative in 400 random calls, nor at the ends of the range.
 *   g > 0.0: g was not 0 in 400 random calls, nor at the ends of the range.
 */
#ifndef QUADROTOR_SELFTEST_H
#define QUADROTOR_SELFTEST_H

#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/* The number of failed checks: 0 if the controller works on this machine. It uses no heap, output
 * or clock, and keeps no state. */
uint32_t quadrotor_selftest(void);

#ifdef __cplusplus
}
#endif

#endif
