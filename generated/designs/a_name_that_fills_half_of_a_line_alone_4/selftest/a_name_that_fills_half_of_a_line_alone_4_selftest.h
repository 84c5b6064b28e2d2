/*
 * Self-test of the prescribed-time controller a_name_that_fills_half_of_a_line_alone_4, for the target. DO NOT EDIT. Made by:
 *   ptc-codegen emit --lang c --n 2 --mu "exp(a=2)" --name a_name_that_fills_half_of_a_line_alone_4 --clock samples --measured=x1 --disturbance constant --observer-poles=-4,-5,-6 --precision f32 --eps=0 --after zero --selftest
 * Version 0.1.0.
 *
 * 6 sets of parameters with 51 calls, 34 sets that init must refuse. The expected values were
 * computed by the generator, which runs this very program in the arithmetic of IEEE 754: the
 * operations are its own alone, so that a target has to give the same numbers.
 *
 * Outcomes of conditions that no input tried brings about are not exercised:
 *   PTC_FINITE_F32(phi1_3): held with each of 3048 sets of parameters that passed the tests
 *     before it.
 *   PTC_FINITE_F32(q2_1): held with each of 3048 sets of parameters that passed the tests before
 *     it.
 *   PTC_FINITE_F32(q2_2): held with each of 3048 sets of parameters that passed the tests before
 *     it.
 *   PTC_FINITE_F32(e2_2): held with each of 3048 sets of parameters that passed the tests before
 *     it.
 *   PTC_FINITE_F32(e2_3): held with each of 3048 sets of parameters that passed the tests before
 *     it.
 *   PTC_FINITE_F32(e1_2): held with each of 3048 sets of parameters that passed the tests before
 *     it.
 *   PTC_FINITE_F32(e1_3): held with each of 3048 sets of parameters that passed the tests before
 *     it.
 *   PTC_FINITE_F32(e0_2): held with each of 3048 sets of parameters that passed the tests before
 *     it.
 *   PTC_FINITE_F32(e0_3): held with each of 3048 sets of parameters that passed the tests before
 *     it.
 *   PTC_FINITE_F32(deadbeat): held with each of 3048 sets of parameters that passed the tests
 *     before it.
 *   PTC_FINITE_F32(w1_2): held with each of 3048 sets of parameters that passed the tests before
 *     it.
 *   PTC_FINITE_F32(b_1): held with each of 3048 sets of parameters that passed the tests before
 *     it.
 *   PTC_FINITE_F32(b_2): held with each of 3048 sets of parameters that passed the tests before
 *     it.
 */
#ifndef A_NAME_THAT_FILLS_HALF_OF_A_LINE_ALONE_4_SELFTEST_H
#define A_NAME_THAT_FILLS_HALF_OF_A_LINE_ALONE_4_SELFTEST_H

#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/* The number of failed checks: 0 if the controller works on this machine. It uses no heap, output
 * or clock, and keeps no state. */
uint32_t a_name_that_fills_half_of_a_line_alone_4_selftest(void);

#ifdef __cplusplus
}
#endif

#endif
