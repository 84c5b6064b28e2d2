/*
 * Self-test of the prescribed-time controller stage36, for the target. DO NOT EDIT. Made by:
 *   ptc-codegen emit --lang c --mu exp --name stage36 --clock samples --precision f32 --eps=0 --states="q1, q2, w1, w2" --inputs=F1,F2 --inertia="[[2, 1/2], [1/2, 1]]" --bias="3*q1 - c*q2 + w1/4, c*q2" --param c=2 --sample-time=0.02 --selftest
 * Version 0.1.0.
 *
 * 5 sets of parameters with 65 calls, 34 sets that init must refuse. The expected values were
 * computed by the generator, which runs this very program in the arithmetic of IEEE 754: the
 * operations are its own alone, so that a target has to give the same numbers.
 *
 * Outcomes of conditions that no input tried brings about are not exercised:
 *   PTC_FINITE_F32(w1_2_1): held with each of 3048 sets of parameters that passed the tests
 *     before it.
 *   PTC_FINITE_F32(control2): never false in 5365 calls.
 *   PTC_FINITE_F32(control1): never true in 5365 calls.
 *   PTC_FINITE_F32(control2): never true in 5365 calls.
 */
#ifndef STAGE36_SELFTEST_H
#define STAGE36_SELFTEST_H

#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/* The number of failed checks: 0 if the controller works on this machine. It uses no heap, output
 * or clock, and keeps no state. */
uint32_t stage36_selftest(void);

#ifdef __cplusplus
}
#endif

#endif
