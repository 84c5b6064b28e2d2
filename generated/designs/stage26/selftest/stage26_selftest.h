/*
 * Self-test of the prescribed-time controller stage26, for the target. DO NOT EDIT. Made by:
 *   ptc-codegen emit --lang c --mu exp --name stage26 --clock samples --precision f32 --guard none --eps=0 --states="q1, q2, w1, w2" --inputs=F1,F2 --inertia="[[m + q2^2, q2], [q2, 1]]" --bias="m*q2*w1*w2, w1^2/2 - q1" --selftest
 * Version 0.1.0.
 *
 * 7 sets of parameters with 45 calls, 49 sets that init must refuse. The expected values were
 * computed by the generator, which runs this very program in the arithmetic of IEEE 754: the
 * operations are its own alone, so that a target has to give the same numbers.
 *
 * Outcomes of conditions that no input tried brings about are not exercised:
 *   PTC_FINITE_F32(w1_2_1): held with each of 3068 sets of parameters that passed the tests
 *     before it.
 *   PTC_FINITE_F32(b_1_1): held with each of 3068 sets of parameters that passed the tests
 *     before it.
 *   PTC_FINITE_F32(b_2_1): held with each of 3068 sets of parameters that passed the tests
 *     before it.
 */
#ifndef STAGE26_SELFTEST_H
#define STAGE26_SELFTEST_H

#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/* The number of failed checks: 0 if the controller works on this machine. It uses no heap, output
 * or clock, and keeps no state. */
uint32_t stage26_selftest(void);

#ifdef __cplusplus
}
#endif

#endif
