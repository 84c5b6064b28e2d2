/*
 * Self-test of the prescribed-time controller wound, for the target. DO NOT EDIT. Made by:
 *   ptc-codegen emit --lang c --n 2 --mu "exp(a=1)" --name wound --clock samples --A="[[0,1],[0,-5]]" --B="[0,40]" --C="[[1,0]]" --disturbance ramp --observer=stationary --disturbance-walk=5 --tau=0.3 --eps=0.01 --u-max=10 --poles=least-energy --sample-time=0.001 --sensor-step=1e-5 --selftest
 * Version 0.1.0.
 *
 * 4 sets of parameters with 47 calls, 0 sets that init must refuse. The expected values were
 * computed by the generator, which runs this very program in the arithmetic of IEEE 754: the
 * operations are its own alone, so that a target has to give the same numbers.
 *
 * Outcomes of conditions that no input tried brings about are not exercised:
 *   PTC_FINITE_F64(x1_on): never false in 920 calls.
 *   PTC_FINITE_F64(d_on): never false in 920 calls.
 *   PTC_FINITE_F64(d_rate_on): never false in 920 calls.
 */
#ifndef WOUND_SELFTEST_H
#define WOUND_SELFTEST_H

#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/* The number of failed checks: 0 if the controller works on this machine. It uses no heap, output
 * or clock, and keeps no state. */
uint32_t wound_selftest(void);

#ifdef __cplusplus
}
#endif

#endif
