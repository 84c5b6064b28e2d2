/*
 * Self-test of the prescribed-time controller levitation, for the target. DO NOT EDIT. Made by:
 *   ptc-codegen emit --lang c --n 3 --mu "exp(a=1)" --name levitation --eps=1e-3 --poles=-4,-5,-6 --states="z, v, i" --input=u --output="z" --dynamics="v, grav*(1 - ((1 + i/i0)/(1 + z/z0))^2), (u - R*i)/L" --param grav=9.81 --param "i0=[0.1,5]" --param "z0=[5e-3,2e-2]" --x-max=2e-3,1,0.05 --selftest
 * Version 0.1.0.
 *
 * 6 sets of parameters with 50 calls, 33 sets that init must refuse. The expected u was
 * computed from the definition of the controller with 42 or more digits; its tolerance is
 * 1e-14 of the sum of the absolute values of its terms.
 *
 * Outcomes of conditions that no input tried brings about are not exercised:
 *   PTC_FINITE_F64(f49): among 3000 sets of parameters, drawn up to the ends of the range, what
 *     fails it fails one of the 4 before it.
 *   PTC_FINITE_F64(f53): the negative of a parameter that is finite.
 *   PTC_FINITE_F64(f56): among 3000 sets of parameters, drawn up to the ends of the range, what
 *     fails it fails one of the 6 before it.
 *   PTC_FINITE_F64(f61): among 3000 sets of parameters, drawn up to the ends of the range, what
 *     fails it fails one of the 7 before it.
 *   (status == PTC_OK): arm takes every start time that init takes.
 *   (fabs(p_L) <= 0.0): it holds with none of the parameters tried.
 *   (fabs(p_L) <= 0.0): it holds with none of the parameters tried.
 *   (fabs(p_R) <= 0.0): it holds with none of the parameters tried.
 *   numerator > 0.0: g was not 0 in 400 random calls, nor at the ends of the range.
 */
#ifndef LEVITATION_SELFTEST_H
#define LEVITATION_SELFTEST_H

#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/* The number of failed checks: 0 if the controller works on this machine. It uses no heap, output
 * or clock, and keeps no state. */
uint32_t levitation_selftest(void);

#ifdef __cplusplus
}
#endif

#endif
