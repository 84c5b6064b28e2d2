/*
 * Self-test of the prescribed-time controller stage19, for the target. DO NOT EDIT. Made by:
 *   ptc-codegen emit --lang c --n 3 --mu "exp(a=1)" --name stage19 --clock samples --precision f32 --guard none --eps=0 --u-max=inf --states="q, w, i" --input=V --output="q" --dynamics="w, i/(1 + q^2) - w/4, 50*(V - 2*i - w)" --after zero --selftest
 * Version 0.1.0.
 *
 * 4 sets of parameters with 39 calls, 36 sets that init must refuse. The expected values were
 * computed by the generator, which runs this very program in the arithmetic of IEEE 754: the
 * operations are its own alone, so that a target has to give the same numbers.
 *
 * Outcomes of conditions that no input tried brings about are not exercised:
 *   PTC_FINITE_F32(deadbeat): held with each of 3048 sets of parameters that passed the tests
 *     before it.
 *   PTC_FINITE_F32(w1_2): held with each of 3048 sets of parameters that passed the tests before
 *     it.
 *   PTC_FINITE_F32(w1_3): held with each of 3048 sets of parameters that passed the tests before
 *     it.
 *   PTC_FINITE_F32(w2_3): held with each of 3048 sets of parameters that passed the tests before
 *     it.
 *   PTC_FINITE_F32(b_1): held with each of 3048 sets of parameters that passed the tests before
 *     it.
 *   PTC_FINITE_F32(b_2): held with each of 3048 sets of parameters that passed the tests before
 *     it.
 *   PTC_FINITE_F32(b_3): held with each of 3048 sets of parameters that passed the tests before
 *     it.
 */
#ifndef STAGE19_SELFTEST_H
#define STAGE19_SELFTEST_H

#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/* The number of failed checks: 0 if the controller works on this machine. It uses no heap, output
 * or clock, and keeps no state. */
uint32_t stage19_selftest(void);

#ifdef __cplusplus
}
#endif

#endif
