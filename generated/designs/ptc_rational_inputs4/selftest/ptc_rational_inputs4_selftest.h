/*
 * Self-test of the prescribed-time controller ptc_rational_inputs4, for the target. DO NOT EDIT. Made by:
 *   ptc-codegen emit --lang c --mu rational --name ptc_rational_inputs4 --states="p, q, r, s" --inputs=a,b,c,d --outputs="p, q, r, s" --dynamics="sin(q)*b + 3*c + r*d, 2*a + p*b + m*d + p*r, r*a + (3 + q^2)*b + s*c, a - p*c + 4*d" --allow=zeros --selftest
 * Version 0.1.0.
 *
 * 11 sets of parameters with 78 calls, 35 sets that init must refuse. The expected u was
 * computed from the definition of the controller with 42 or more digits; its tolerance is
 * 1e-14 of the sum of the absolute values of its terms.
 *
 * Outcomes of conditions that no input tried brings about are not exercised:
 *   PTC_FINITE_F64(hold_from): the negative of a parameter that is finite.
 *   (status == PTC_OK): arm takes every start time that init takes.
 *   (fabs(p_m) <= 0.0): it holds with none of the parameters tried.
 *   PTC_FINITE_F64(control1): it was never the first u that is no number, or never finite beside
 *     one, in 400 random calls, nor at the ends of the range.
 *   PTC_FINITE_F64(control2): it was never the first u that is no number, or never finite beside
 *     one, in 400 random calls, nor at the ends of the range.
 *   PTC_FINITE_F64(control3): it was never the first u that is no number, or never finite beside
 *     one, in 400 random calls, nor at the ends of the range.
 *   PTC_FINITE_F64(control4): it was never the first u that is no number, or never finite beside
 *     one, in 400 random calls, nor at the ends of the range.
 *   a[(4U * k) + k] > 0.0: the matrix was not singular in 400 random calls, nor at the ends of
 *     the range.
 */
#ifndef PTC_RATIONAL_INPUTS4_SELFTEST_H
#define PTC_RATIONAL_INPUTS4_SELFTEST_H

#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/* The number of failed checks: 0 if the controller works on this machine. It uses no heap, output
 * or clock, and keeps no state. */
uint32_t ptc_rational_inputs4_selftest(void);

#ifdef __cplusplus
}
#endif

#endif
