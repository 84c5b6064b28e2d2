/*
 * Self-test of the prescribed-time controller stage20, for the target. DO NOT EDIT. Made by:
 *   ptc-codegen emit --lang c --n 2 --mu "exp(a=1)" --name stage20 --clock samples --measured=x1 --disturbance constant --observer-poles=-4,-5,-6 --eps=0 --f="1/4" --g="1/2" --reference input --delay=1.25 --selftest
 * Version 0.1.0.
 *
 * 6 sets of parameters with 69 calls, 45 sets that init must refuse. The expected values were
 * computed by the generator, which runs this very program in the arithmetic of IEEE 754: the
 * operations are its own alone, so that a target has to give the same numbers.
 *
 * Outcomes of conditions that no input tried brings about are not exercised:
 *   PTC_FINITE_F64(phi1_3): held with each of 3064 sets of parameters that passed the tests
 *     before it.
 *   PTC_FINITE_F64(gamma1): held with each of 3064 sets of parameters that passed the tests
 *     before it.
 *   PTC_FINITE_F64(late_gamma1): held with each of 3064 sets of parameters that passed the tests
 *     before it.
 *   PTC_FINITE_F64(phi2_3): held with each of 3064 sets of parameters that passed the tests
 *     before it.
 *   PTC_FINITE_F64(gamma2): held with each of 3064 sets of parameters that passed the tests
 *     before it.
 *   PTC_FINITE_F64(late_gamma2): held with each of 3064 sets of parameters that passed the tests
 *     before it.
 *   PTC_FINITE_F64(q2_1): held with each of 3064 sets of parameters that passed the tests before
 *     it.
 *   PTC_FINITE_F64(q2_2): held with each of 3064 sets of parameters that passed the tests before
 *     it.
 *   PTC_FINITE_F64(q3_1): held with each of 3064 sets of parameters that passed the tests before
 *     it.
 *   PTC_FINITE_F64(e2_2): held with each of 3064 sets of parameters that passed the tests before
 *     it.
 *   PTC_FINITE_F64(e2_3): held with each of 3064 sets of parameters that passed the tests before
 *     it.
 *   PTC_FINITE_F64(e1_2): held with each of 3064 sets of parameters that passed the tests before
 *     it.
 *   PTC_FINITE_F64(e1_3): held with each of 3064 sets of parameters that passed the tests before
 *     it.
 *   PTC_FINITE_F64(e0_2): held with each of 3064 sets of parameters that passed the tests before
 *     it.
 *   PTC_FINITE_F64(e0_3): held with each of 3064 sets of parameters that passed the tests before
 *     it.
 *   PTC_FINITE_F64(deadbeat): held with each of 3064 sets of parameters that passed the tests
 *     before it.
 *   PTC_FINITE_F64(w1_2): held with each of 3064 sets of parameters that passed the tests before
 *     it.
 *   PTC_FINITE_F64(w1_4): held with each of 3064 sets of parameters that passed the tests before
 *     it.
 *   PTC_FINITE_F64(w2_4): held with each of 3064 sets of parameters that passed the tests before
 *     it.
 *   PTC_FINITE_F64(w4_3): held with each of 3064 sets of parameters that passed the tests before
 *     it.
 *   PTC_FINITE_F64(w4_4): held with each of 3064 sets of parameters that passed the tests before
 *     it.
 *   PTC_FINITE_F64(b_1): held with each of 3064 sets of parameters that passed the tests before
 *     it.
 *   PTC_FINITE_F64(b_2): held with each of 3064 sets of parameters that passed the tests before
 *     it.
 */
#ifndef STAGE20_SELFTEST_H
#define STAGE20_SELFTEST_H

#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/* The number of failed checks: 0 if the controller works on this machine. It uses no heap, output
 * or clock, and keeps no state. */
uint32_t stage20_selftest(void);

#ifdef __cplusplus
}
#endif

#endif
