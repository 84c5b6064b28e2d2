/*
 * Self-test of the prescribed-time controller pendulum, for the target. DO NOT EDIT. Made by:
 *   ptc-codegen emit --lang c --n 2 --mu "exp(a=1)" --name pendulum --tau=0.8 --eps=6.00e-3 --u-max=25 --poles=-3,-4 --states="q, w" --input=M --output="q" --dynamics="w, (M - drag*w)/(m*l^2) - grav/l*sin(q)" --param drag=0.02 --param grav=9.81 --param l=0.5 --param m=1 --sample-time=1e-3 --noise=1e-4,1e-3 --selftest
 * Version 0.1.0.
 *
 * 5 sets of parameters with 42 calls, 3 sets that init must refuse. The expected u was
 * computed from the definition of the controller with 42 or more digits; its tolerance is
 * 1e-14 of the sum of the absolute values of its terms.
 *
 * Outcomes of conditions that no input tried brings about are not exercised:
 *   PTC_FINITE_F64(deadline): tau is fixed, and less than the last place of the greatest start.
 *   (status == PTC_OK): arm takes every start time that init takes.
 */
#ifndef PENDULUM_SELFTEST_H
#define PENDULUM_SELFTEST_H

#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/* The number of failed checks: 0 if the controller works on this machine. It uses no heap, output
 * or clock, and keeps no state. */
uint32_t pendulum_selftest(void);

#ifdef __cplusplus
}
#endif

#endif
