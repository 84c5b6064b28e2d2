/*
 * Self-test of the prescribed-time controller stage45, for the target. DO NOT EDIT. Made by:
 *   ptc-codegen emit --lang c --n 2 --mu exp --name stage45 --clock samples --delay-law=predict --precision f32 --guard none --eps=0 --delay=5 --selftest
 * Version 0.1.0.
 *
 * 5 sets of parameters with 41 calls, 47 sets that init must refuse. The expected values were
 * computed by the generator, which runs this very program in the arithmetic of IEEE 754: the
 * operations are its own alone, so that a target has to give the same numbers.
 *
 * Outcomes of conditions that no input tried brings about are not exercised:
 *   PTC_FINITE_F32(w1_4): held with each of 3060 sets of parameters that passed the tests before
 *     it.
 *   PTC_FINITE_F32(w1_5): held with each of 3060 sets of parameters that passed the tests before
 *     it.
 *   PTC_FINITE_F32(w1_6): held with each of 3060 sets of parameters that passed the tests before
 *     it.
 *   PTC_FINITE_F32(w1_7): held with each of 3060 sets of parameters that passed the tests before
 *     it.
 *   PTC_FINITE_F32(w2_3): held with each of 3060 sets of parameters that passed the tests before
 *     it.
 *   PTC_FINITE_F32(b_1): held with each of 3060 sets of parameters that passed the tests before
 *     it.
 *   PTC_FINITE_F32(b_2): held with each of 3060 sets of parameters that passed the tests before
 *     it.
 */
#ifndef STAGE45_SELFTEST_H
#define STAGE45_SELFTEST_H

#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/* The number of failed checks: 0 if the controller works on this machine. It uses no heap, output
 * or clock, and keeps no state. */
uint32_t stage45_selftest(void);

#ifdef __cplusplus
}
#endif

#endif
