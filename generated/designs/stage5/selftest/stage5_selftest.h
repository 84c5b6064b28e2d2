/*
 * Self-test of the prescribed-time controller stage5, for the target. DO NOT EDIT. Made by:
 *   ptc-codegen emit --lang c --n 4 --mu exp --name stage5 --clock samples --guard none --eps=0.01 --delay=2 --selftest
 * Version 0.1.0.
 *
 * 3 sets of parameters with 39 calls, 68 sets that init must refuse. The expected values were
 * computed by the generator, which runs this very program in the arithmetic of IEEE 754: the
 * operations are its own alone, so that a target has to give the same numbers.
 *
 * Outcomes of conditions that no input tried brings about are not exercised:
 *   PTC_FINITE_F64(hold): held with each of 3092 sets of parameters that passed the tests before
 *     it.
 *   PTC_FINITE_F64(w1_3): held with each of 3092 sets of parameters that passed the tests before
 *     it.
 *   PTC_FINITE_F64(w1_4): held with each of 3092 sets of parameters that passed the tests before
 *     it.
 *   PTC_FINITE_F64(w2_3): held with each of 3092 sets of parameters that passed the tests before
 *     it.
 *   PTC_FINITE_F64(w2_4): held with each of 3092 sets of parameters that passed the tests before
 *     it.
 *   PTC_FINITE_F64(w3_4): held with each of 3092 sets of parameters that passed the tests before
 *     it.
 *   PTC_FINITE_F64(w4_4): held with each of 3092 sets of parameters that passed the tests before
 *     it.
 *   PTC_FINITE_F64(w5_6): held with each of 3092 sets of parameters that passed the tests before
 *     it.
 *   PTC_FINITE_F64(w6_5): held with each of 3092 sets of parameters that passed the tests before
 *     it.
 *   PTC_FINITE_F64(w6_6): held with each of 3092 sets of parameters that passed the tests before
 *     it.
 *   PTC_FINITE_F64(b_1): held with each of 3092 sets of parameters that passed the tests before
 *     it.
 *   PTC_FINITE_F64(b_2): held with each of 3092 sets of parameters that passed the tests before
 *     it.
 *   PTC_FINITE_F64(b_3): held with each of 3092 sets of parameters that passed the tests before
 *     it.
 *   PTC_FINITE_F64(b_4): held with each of 3092 sets of parameters that passed the tests before
 *     it.
 */
#ifndef STAGE5_SELFTEST_H
#define STAGE5_SELFTEST_H

#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/* The number of failed checks: 0 if the controller works on this machine. It uses no heap, output
 * or clock, and keeps no state. */
uint32_t stage5_selftest(void);

#ifdef __cplusplus
}
#endif

#endif
