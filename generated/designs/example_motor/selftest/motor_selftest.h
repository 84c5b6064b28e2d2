/*
 * Self-test of the prescribed-time controller motor, for the target. DO NOT EDIT. Made by:
 *   ptc-codegen emit --lang c --n 3 --mu "exp(a=1)" --name motor --clock samples --A="[[0,1,0],[0,-0.5,1500],[0,-15,-600]]" --B="[0,0,500]" --C="[[1,0,0]]" --delay-law=predict --disturbance constant --observer-poles=-4,-5,-6,-7 --observer-samples=150 --observer-eps=0.04 --tau=0.4 --eps=0.02 --u-max=24 --poles="least-energy(weight=2)" --sample-time=1e-3 --delay=1 --sensor-step=6e-6 --selftest
 * Version 0.1.0.
 *
 * 6 sets of parameters with 54 calls, 0 sets that init must refuse. The expected values were
 * computed by the generator, which runs this very program in the arithmetic of IEEE 754: the
 * operations are its own alone, so that a target has to give the same numbers.
 *
 * Outcomes of conditions that no input tried brings about are not exercised:
 *   PTC_FINITE_F64(x3_on): never false in 915 calls.
 *   PTC_FINITE_F64(d_on): never false in 915 calls.
 */
#ifndef MOTOR_SELFTEST_H
#define MOTOR_SELFTEST_H

#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/* The number of failed checks: 0 if the controller works on this machine. It uses no heap, output
 * or clock, and keeps no state. */
uint32_t motor_selftest(void);

#ifdef __cplusplus
}
#endif

#endif
