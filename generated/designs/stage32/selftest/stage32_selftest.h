/*
 * Self-test of the prescribed-time controller stage32, for the target. DO NOT EDIT. Made by:
 *   ptc-codegen emit --lang c --mu exp --name stage32 --clock samples --tau=0.3 --eps=0.04 --states="q1, q2, w1, w2" --inputs=F1,F2 --inertia="[[m + q2^2, q2], [q2, 1]]" --bias="m*q2*w1*w2, w1^2/2 - q1" --reference="size*dt^2/(1 + t^2), 0" --sample-time=0.01 --selftest
 * Version 0.1.0.
 *
 * 4 sets of parameters with 66 calls, 38 sets that init must refuse. The expected values were
 * computed by the generator, which runs this very program in the arithmetic of IEEE 754: the
 * operations are its own alone, so that a target has to give the same numbers.
 *
 * Outcomes of conditions that no input tried brings about are not exercised:
 *   PTC_FINITE_F64(w1_2_1): held with each of 3060 sets of parameters that passed the tests
 *     before it.
 */
#ifndef STAGE32_SELFTEST_H
#define STAGE32_SELFTEST_H

#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/* The number of failed checks: 0 if the controller works on this machine. It uses no heap, output
 * or clock, and keeps no state. */
uint32_t stage32_selftest(void);

#ifdef __cplusplus
}
#endif

#endif
