/*
 * Self-test of the prescribed-time controller two_link, for the target. DO NOT EDIT. Made by:
 *   ptc-codegen emit --lang c --mu "rational(a=1/20)" --name two_link --tau=20 --eps=1 --limits=120,60 --poles=-1,-1.5 --states="q1, q2, w1, w2" --inputs=M1,M2 --inertia="[[(m1 + m2)*l1^2 + m2*l2^2 + 2*m2*l1*l2*cos(q2), m2*l2^2 + m2*l1*l2*cos(q2)], [m2*l2^2 + m2*l1*l2*cos(q2), m2*l2^2]]" --bias="-m2*l1*l2*sin(q2)*(2*w1*w2 + w2^2) + (m1 + m2)*grav*l1*cos(q1) + m2*grav*l2*cos(q1 + q2), m2*l1*l2*sin(q2)*w1^2 + m2*grav*l2*cos(q1 + q2)" --param grav=9.81 --param l1=0.6 --param l2=0.5 --param m1=2 --param m2=1.5 --selftest
 * Version 0.1.0.
 *
 * 5 sets of parameters with 60 calls, 3 sets that init must refuse. The expected u was
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
 */
#ifndef TWO_LINK_SELFTEST_H
#define TWO_LINK_SELFTEST_H

#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/* The number of failed checks: 0 if the controller works on this machine. It uses no heap, output
 * or clock, and keeps no state. */
uint32_t two_link_selftest(void);

#ifdef __cplusplus
}
#endif

#endif
