/*
 * Self-test of the prescribed-time controller too_soon, for the target. DO NOT EDIT. Made by:
 *   ptc-codegen emit --lang c --n 3 --mu "exp(a=1)" --name too_soon --clock samples --late=refuse --state-max=inf,0.5,4 --precision f32 --tau=1.5 --eps=0 --u-max=20 --poles="least-energy(weight=1)" --sample-time=0.01 --selftest
 * Version 0.1.0.
 *
 * 3 sets of parameters with 110 calls, 0 sets that init must refuse. The expected values were
 * computed by the generator, which runs this very program in the arithmetic of IEEE 754: the
 * operations are its own alone, so that a target has to give the same numbers.
 *
 * Outcomes of conditions that no input tried brings about are not exercised:
 *   b2 <= most: never false in 3803 calls.
 *   least <= b3: never false in 3803 calls.
 *   b3 <= most: never false in 3803 calls.
 *   least <= b4: never false in 3803 calls.
 *   least <= b5: never false in 3803 calls.
 *   b5 <= most: never false in 3803 calls.
 *   least <= b6: never false in 3803 calls.
 *   b6 <= most: never false in 3803 calls.
 *   -most2 <= s0_c: never false in 3803 calls.
 *   s0_c <= most2: never false in 3803 calls.
 *   -most2 <= s1: never false in 3803 calls.
 *   s1 <= most2: never false in 3803 calls.
 *   s6 <= most2: never false in 3803 calls.
 *   s7 <= most2: never false in 3803 calls.
 *   -most2 <= s9: never false in 3803 calls.
 *   -most3 <= v0_c: never false in 3803 calls.
 *   v0_c <= most3: never false in 3803 calls.
 *   -most3 <= v1: never false in 3803 calls.
 *   v1 <= most3: never false in 3803 calls.
 *   -most3 <= v2: never false in 3803 calls.
 *   v2 <= most3: never false in 3803 calls.
 *   -most3 <= v3: never false in 3803 calls.
 *   v3 <= most3: never false in 3803 calls.
 *   -most3 <= v4: never false in 3803 calls.
 *   v4 <= most3: never false in 3803 calls.
 *   -most3 <= v5: never false in 3803 calls.
 *   v5 <= most3: never false in 3803 calls.
 *   -most3 <= v6: never false in 3803 calls.
 *   v6 <= most3: never false in 3803 calls.
 *   -most3 <= v7: never false in 3803 calls.
 *   v7 <= most3: never false in 3803 calls.
 *   -most3 <= v8: never false in 3803 calls.
 *   v8 <= most3: never false in 3803 calls.
 *   fabsf((((-72.0f) * w1) - (360.0f * w2)) - (720.0f * w3)) <= most: never false in 3803 calls.
 *   fabsf(((-48.0f) * w1) - (120.0f * w2)) <= most: never false in 3803 calls.
 *   fabsf((-24.0f) * w1) <= most: never false in 3803 calls.
 *   fabsf((((-0.0168f) * w1) - (0.036f * w2)) - (0.036f * w3)) <= most2: never false in 3803
 *     calls.
 *   fabsf((((-0.006f) * w1) - (0.006f * w2)) + (4.8789098e-18f * w3)) <= most2: never false in
 *     3803 calls.
 *   fabsf(((-0.0012f) * w1) + (4.8789098e-18f * w2) + (4.8789098e-18f * w3)) <= most2: never
 *     false in 3803 calls.
 *   fabsf((1.44f * w1) + (4.8f * w2) + (7.2f * w3)) <= most3: never false in 3803 calls.
 *   fabsf(((0.72f * w1) + (1.2f * w2)) - (1.2490009e-15f * w3)) <= most3: never false in 3803
 *     calls.
 *   fabsf((0.24f * w1) + (2.9143354e-15f * w2) + (3.7470027e-15f * w3)) <= most3: never false in
 *     3803 calls.
 *   low < top: never false in 3803 calls.
 *   PTC_FINITE_F32(flat2): never false in 3803 calls.
 *   PTC_FINITE_F32(flat3): never false in 3803 calls.
 */
#ifndef TOO_SOON_SELFTEST_H
#define TOO_SOON_SELFTEST_H

#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/* The number of failed checks: 0 if the controller works on this machine. It uses no heap, output
 * or clock, and keeps no state. */
uint32_t too_soon_selftest(void);

#ifdef __cplusplus
}
#endif

#endif
