/*
 * Self-test of the prescribed-time controller mix_fixed, for the target. DO NOT EDIT. Made by:
 *   ptc-codegen emit --lang c --mu "exp(a=1)" --name mix_fixed --guard result --tau=1 --eps=1e-2 --limits=40,15 --poles="[[-4,-5],[-3]]" --states="p, v, h" --inputs=a,b --outputs="p, h" --dynamics="v, -v + (2 + sin(p))*a + h*b, v*h + h*a + (2 + h^2)*b" --selftest
 * Version 0.1.0.
 *
 * 6 sets of parameters with 43 calls, 3 sets that init must refuse. The expected u was
 * computed from the definition of the controller with 42 or more digits; its tolerance is
 * 1e-14 of the sum of the absolute values of its terms.
 *
 * Outcomes of conditions that no input tried brings about are not exercised:
 *   PTC_FINITE_F64(deadline): tau is fixed, and less than the last place of the greatest start.
 *   (status == PTC_OK): arm takes every start time that init takes.
 *   PTC_FINITE_F64(control1): it was never the first u that is no number, or never finite beside
 *     one, in 400 random calls, nor at the ends of the range.
 *   PTC_FINITE_F64(control2): it was never the first u that is no number, or never finite beside
 *     one, in 400 random calls, nor at the ends of the range.
 *   determinant < 0.0: g was not negative in 400 random calls, nor at the ends of the range.
 */
#ifndef MIX_FIXED_SELFTEST_H
#define MIX_FIXED_SELFTEST_H

#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/* The number of failed checks: 0 if the controller works on this machine. It uses no heap, output
 * or clock, and keeps no state. */
uint32_t mix_fixed_selftest(void);

#ifdef __cplusplus
}
#endif

#endif
