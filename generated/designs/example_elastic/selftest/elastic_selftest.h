/*
 * Self-test of the prescribed-time controller elastic, for the target. DO NOT EDIT. Made by:
 *   ptc-codegen emit --lang c --n 2 --mu "exp(a=1)" --name elastic --clock samples --measured=x1 --disturbance constant --observer-poles=-5,-6,-7 --observer-samples=200 --tau=0.5 --eps=0.0965 --u-max=100 --poles=-4,-4.5,-5 --g="2/7" --sample-time=5e-4 --delay=1 --error=1e-3,0.1 --sensor-step=7.7e-6 --x0-max=0.3,1e-6 --selftest
 * Version 0.1.0.
 *
 * 4 sets of parameters with 49 calls, 0 sets that init must refuse. The expected values were
 * computed by the generator, which runs this very program in the arithmetic of IEEE 754: the
 * operations are its own alone, so that a target has to give the same numbers.
 */
#ifndef ELASTIC_SELFTEST_H
#define ELASTIC_SELFTEST_H

#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/* The number of failed checks: 0 if the controller works on this machine. It uses no heap, output
 * or clock, and keeps no state. */
uint32_t elastic_selftest(void);

#ifdef __cplusplus
}
#endif

#endif
