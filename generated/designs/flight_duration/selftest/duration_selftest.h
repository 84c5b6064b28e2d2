/*
 * Self-test of the prescribed-time controller duration, for the target. DO NOT EDIT. Made by:
 *   ptc-codegen emit --lang c --n 3 --mu tan --name duration --in-flight --precision f32 --u-max=100 --poles=-4,-5,-6 --selftest
 * Version 0.1.0.
 *
 * 7 sets of parameters with 66 calls, 27 sets that init must refuse. The expected u was
 * computed from the definition of the controller with 42 or more digits; its tolerance is
 * 2e-6 of the sum of the absolute values of its terms.
 *
 * Outcomes of conditions that no input tried brings about are not exercised:
 *   PTC_FINITE_F32(c1_3): among 3000 sets of parameters, drawn up to the ends of the range, what
 *     fails it fails one of the 2 before it.
 *   PTC_FINITE_F32(hold_from): the negative of a parameter that is finite.
 *   PTC_FINITE_F32(f69): among 3000 sets of parameters, drawn up to the ends of the range, what
 *     fails it fails one of the 4 before it.
 *   PTC_FINITE_F32(f73): among 3000 sets of parameters, drawn up to the ends of the range, what
 *     fails it fails one of the 5 before it.
 *   PTC_FINITE_F32(c2_2): among 3000 sets of parameters, drawn up to the ends of the range, what
 *     fails it fails one of the 6 before it.
 *   PTC_FINITE_F32(f81): among 3000 sets of parameters, drawn up to the ends of the range, what
 *     fails it fails one of the 7 before it.
 *   PTC_FINITE_F32(f85): among 3000 sets of parameters, drawn up to the ends of the range, what
 *     fails it fails one of the 8 before it.
 *   PTC_FINITE_F32(f99): among 3000 sets of parameters, drawn up to the ends of the range, what
 *     fails it fails one of the 9 before it.
 *   PTC_FINITE_F32(f103): among 3000 sets of parameters, drawn up to the ends of the range, what
 *     fails it fails one of the 10 before it.
 *   PTC_FINITE_F32(angle_rate): among 3000 sets of parameters, drawn up to the ends of the
 *     range, what fails it fails one of the 12 before it.
 *   PTC_FINITE_F32(inv_angle_rate): among 3000 sets of parameters, drawn up to the ends of the
 *     range, what fails it fails one of the 13 before it.
 *   PTC_FINITE_F32(inv_tau): among 3000 sets of parameters, drawn up to the ends of the range,
 *     what fails it fails one of the 14 before it.
 *   PTC_FINITE_F32(c2_1): among 3000 sets of parameters, drawn up to the ends of the range, what
 *     fails it fails one of the 16 before it.
 *   PTC_FINITE_F32(c2_3): among 3000 sets of parameters, drawn up to the ends of the range, what
 *     fails it fails one of the 17 before it.
 *   PTC_FINITE_F32(c3_0): among 3000 sets of parameters, drawn up to the ends of the range, what
 *     fails it fails one of the 19 before it.
 *   PTC_FINITE_F32(c3_2): among 3000 sets of parameters, drawn up to the ends of the range, what
 *     fails it fails one of the 20 before it.
 *   PTC_FINITE_F32(deadline): in arm_for: a legal tau is less than the last place of the
 *     greatest start.
 */
#ifndef DURATION_SELFTEST_H
#define DURATION_SELFTEST_H

#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/* The number of failed checks: 0 if the controller works on this machine. It uses no heap, output
 * or clock, and keeps no state. */
uint32_t duration_selftest(void);

#ifdef __cplusplus
}
#endif

#endif
