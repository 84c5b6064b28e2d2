/*
 * Self-test of the prescribed-time controller masses_refuse, for the target. DO NOT EDIT. Made by:
 *   ptc-codegen emit --lang c --n 2 --mu "exp(a=1)" --name masses_refuse --clock samples --A="[[0,1],[-400,-2]]" --B="[0,40]" --C="[[1,0]]" --delay-law=predict --late=refuse --reserve=0.1 --disturbance constant --observer=stationary --disturbance-walk=0.5 --precision f32 --tau=0.2 --eps=0.04 --u-max=10 --poles="least-energy(weight=1)" --sample-time=0.01 --delay=1 --sensor-step=1e-5 --selftest
 * Version 0.1.0.
 *
 * 4 sets of parameters with 61 calls, 0 sets that init must refuse. The expected values were
 * computed by the generator, which runs this very program in the arithmetic of IEEE 754: the
 * operations are its own alone, so that a target has to give the same numbers.
 *
 * Outcomes of conditions that no input tried brings about are not exercised:
 *   to_go < 64U: never false in 3661 calls.
 *   PTC_FINITE_F32(x2_on): never false in 3661 calls.
 *   PTC_FINITE_F32(d_on): never false in 3661 calls.
 *   samples > 1U: never false in 3661 calls.
 *   tried < 81U: never false in 3661 calls.
 *   tried < 32U: never true in 3661 calls.
 *   tried < 64U: never false in 3661 calls.
 *   bounded == 11U: never true in 3661 calls.
 *   fits == 1U: never true in 3661 calls.
 *   low < top: never false in 3661 calls.
 *   PTC_FINITE_F32(q1): never false in 3661 calls.
 *   PTC_FINITE_F32(q2): never false in 3661 calls.
 */
#ifndef MASSES_REFUSE_SELFTEST_H
#define MASSES_REFUSE_SELFTEST_H

#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/* The number of failed checks: 0 if the controller works on this machine. It uses no heap, output
 * or clock, and keeps no state. */
uint32_t masses_refuse_selftest(void);

#ifdef __cplusplus
}
#endif

#endif
