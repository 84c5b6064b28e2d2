/*
 * Self-test of the prescribed-time controller stage30, for the target. DO NOT EDIT. Made by:
 *   ptc-codegen emit --lang c --n 3 --axes 2 --mu exp --name stage30 --clock samples --precision f32 --eps=0.02 --g="3" --selftest
 * Version 0.1.0.
 *
 * 4 sets of parameters with 77 calls, 52 sets that init must refuse. The expected values were
 * computed by the generator, which runs this very program in the arithmetic of IEEE 754: the
 * operations are its own alone, so that a target has to give the same numbers.
 *
 * Outcomes of conditions that no input tried brings about are not exercised:
 *   PTC_FINITE_F32(hold): held with each of 3068 sets of parameters that passed the tests before
 *     it.
 *   PTC_FINITE_F32(w1_2_1): held with each of 3068 sets of parameters that passed the tests
 *     before it.
 *   PTC_FINITE_F32(w1_3_1): held with each of 3068 sets of parameters that passed the tests
 *     before it.
 *   PTC_FINITE_F32(w2_3_1): held with each of 3068 sets of parameters that passed the tests
 *     before it.
 *   PTC_FINITE_F32(b_1_1): held with each of 3068 sets of parameters that passed the tests
 *     before it.
 *   PTC_FINITE_F32(b_2_1): held with each of 3068 sets of parameters that passed the tests
 *     before it.
 *   PTC_FINITE_F32(b_3_1): held with each of 3068 sets of parameters that passed the tests
 *     before it.
 */
#ifndef STAGE30_SELFTEST_H
#define STAGE30_SELFTEST_H

#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/* The number of failed checks: 0 if the controller works on this machine. It uses no heap, output
 * or clock, and keeps no state. */
uint32_t stage30_selftest(void);

#ifdef __cplusplus
}
#endif

#endif
