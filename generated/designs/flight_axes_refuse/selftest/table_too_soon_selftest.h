/*
 * Self-test of the prescribed-time controller table_too_soon, for the target. DO NOT EDIT. Made by:
 *   ptc-codegen emit --lang c --n 3 --axes 2 --mu "exp(a=1)" --name table_too_soon --clock samples --late=refuse --state-max=inf,0.5,4 --tau=1.5 --eps=0 --u-min=runtime --poles="[[-3,-4,-5],[-4,-5,-6]]" --sample-time=0.01 --selftest
 * Version 0.1.0.
 *
 * 6 sets of parameters with 164 calls, 4 sets that init must refuse. The expected values were
 * computed by the generator, which runs this very program in the arithmetic of IEEE 754: the
 * operations are its own alone, so that a target has to give the same numbers.
 *
 * Outcomes of conditions that no input tried brings about are not exercised:
 *   b0_c_1 <= most_1: never false in 6513 calls.
 *   least_1 <= b1_1: never false in 6513 calls.
 *   b1_1 <= most_1: never false in 6513 calls.
 *   least_1 <= b2_1: never false in 6513 calls.
 *   b2_1 <= most_1: never false in 6513 calls.
 *   least_1 <= b3_1: never false in 6513 calls.
 *   b3_1 <= most_1: never false in 6513 calls.
 *   least_1 <= b4_1: never false in 6513 calls.
 *   b4_1 <= most_1: never false in 6513 calls.
 *   least_1 <= b5_1: never false in 6513 calls.
 *   b5_1 <= most_1: never false in 6513 calls.
 *   least_1 <= b6_1: never false in 6513 calls.
 *   b6_1 <= most_1: never false in 6513 calls.
 *   s4_1 <= most2_1: never false in 6513 calls.
 *   -most2_1 <= s5_1: never false in 6513 calls.
 *   s8_1 <= most2_1: never false in 6513 calls.
 *   v0_c_1 <= most3_1: never false in 6513 calls.
 *   -most3_1 <= v2_1: never false in 6513 calls.
 *   v2_1 <= most3_1: never false in 6513 calls.
 *   -most3_1 <= v3_1: never false in 6513 calls.
 *   v3_1 <= most3_1: never false in 6513 calls.
 *   v4_1 <= most3_1: never false in 6513 calls.
 *   v5_1 <= most3_1: never false in 6513 calls.
 *   -most3_1 <= v6_1: never false in 6513 calls.
 *   v6_1 <= most3_1: never false in 6513 calls.
 *   -most3_1 <= v7_1: never false in 6513 calls.
 *   v7_1 <= most3_1: never false in 6513 calls.
 *   least_1 <= end51_1: never false in 6513 calls.
 *   end51_1 <= most_1: never false in 6513 calls.
 *   least_1 <= end52_1: never false in 6513 calls.
 *   end52_1 <= most_1: never false in 6513 calls.
 *   least_1 <= end53_1: never false in 6513 calls.
 *   end53_1 <= most_1: never false in 6513 calls.
 *   fabs((((-0.0027) * w1_1) - (0.006 * w2_1)) - (0.006 * w3_1)) <= most2_1: never false in 6513
 *     calls.
 *   fabs((((-0.0012) * w1_1) - (0.0011999999999999995 * w2_1)) + (8.131516293641283e-19 * w3_1)) <= most2_1:
 *     never false in 6513 calls.
 *   fabs(((-0.00029999999999999965) * w1_1) + (8.131516293641283e-19 * w2_1) + (8.131516293641283e-19 * w3_1)) <= most2_1:
 *     never false in 6513 calls.
 *   fabs((0.18 * w1_1) + (0.72 * w2_1) + (1.2 * w3_1)) <= most3_1: never false in 6513 calls.
 *   fabs(((0.11999999999999994 * w1_1) + (0.23999999999999982 * w2_1)) - (2.0816681711721685e-16 * w3_1)) <= most3_1:
 *     never false in 6513 calls.
 *   fabs((0.06000000000000016 * w1_1) + (4.579669976578771e-16 * w2_1) + (6.245004513516506e-16 * w3_1)) <= most3_1:
 *     never false in 6513 calls.
 *   b0_c_2 <= most_2: never false in 6513 calls.
 *   least_2 <= b1_2: never false in 6513 calls.
 *   b1_2 <= most_2: never false in 6513 calls.
 *   least_2 <= b2_2: never false in 6513 calls.
 *   b2_2 <= most_2: never false in 6513 calls.
 *   least_2 <= b3_2: never false in 6513 calls.
 *   b3_2 <= most_2: never false in 6513 calls.
 *   least_2 <= b4_2: never false in 6513 calls.
 *   b4_2 <= most_2: never false in 6513 calls.
 *   least_2 <= b5_2: never false in 6513 calls.
 *   b5_2 <= most_2: never false in 6513 calls.
 *   least_2 <= b6_2: never false in 6513 calls.
 *   b6_2 <= most_2: never false in 6513 calls.
 *   least_2 <= b7_2: never false in 6513 calls.
 *   b7_2 <= most_2: never false in 6513 calls.
 *   -most2_2 <= s1_2: never false in 6513 calls.
 *   s1_2 <= most2_2: never false in 6513 calls.
 *   -most2_2 <= s5_2: never false in 6513 calls.
 *   s5_2 <= most2_2: never false in 6513 calls.
 *   -most2_2 <= s6_2: never false in 6513 calls.
 *   s6_2 <= most2_2: never false in 6513 calls.
 *   -most2_2 <= s7_2: never false in 6513 calls.
 *   s7_2 <= most2_2: never false in 6513 calls.
 *   -most2_2 <= s8_2: never false in 6513 calls.
 *   s8_2 <= most2_2: never false in 6513 calls.
 *   -most2_2 <= s9_2: never false in 6513 calls.
 *   s9_2 <= most2_2: never false in 6513 calls.
 *   -most3_2 <= v0_c_2: never false in 6513 calls.
 *   v0_c_2 <= most3_2: never false in 6513 calls.
 *   -most3_2 <= v1_2: never false in 6513 calls.
 *   v1_2 <= most3_2: never false in 6513 calls.
 *   v2_2 <= most3_2: never false in 6513 calls.
 *   -most3_2 <= v3_2: never false in 6513 calls.
 *   v3_2 <= most3_2: never false in 6513 calls.
 *   -most3_2 <= v4_2: never false in 6513 calls.
 *   v4_2 <= most3_2: never false in 6513 calls.
 *   -most3_2 <= v5_2: never false in 6513 calls.
 *   v5_2 <= most3_2: never false in 6513 calls.
 *   v6_2 <= most3_2: never false in 6513 calls.
 *   -most3_2 <= v7_2: never false in 6513 calls.
 *   v7_2 <= most3_2: never false in 6513 calls.
 *   -most3_2 <= v8_2: never false in 6513 calls.
 *   v8_2 <= most3_2: never false in 6513 calls.
 *   least_2 <= end61_2: never false in 6513 calls.
 *   end61_2 <= most_2: never false in 6513 calls.
 *   least_2 <= end62_2: never false in 6513 calls.
 *   end62_2 <= most_2: never false in 6513 calls.
 *   least_2 <= end63_2: never false in 6513 calls.
 *   end63_2 <= most_2: never false in 6513 calls.
 *   fabs((((-0.016800000000000002) * w1_2) - (0.036000000000000004 * w2_2)) - (0.036000000000000004 * w3_2)) <= most2_2:
 *     never false in 6513 calls.
 *   fabs((((-0.005999999999999998) * w1_2) - (0.005999999999999997 * w2_2)) + (4.87890977618477e-18 * w3_2)) <= most2_2:
 *     never false in 6513 calls.
 *   fabs(((-0.0011999999999999977) * w1_2) + (4.87890977618477e-18 * w2_2) + (4.87890977618477e-18 * w3_2)) <= most2_2:
 *     never false in 6513 calls.
 *   fabs((1.44 * w1_2) + (4.8 * w2_2) + (7.2 * w3_2)) <= most3_2: never false in 6513 calls.
 *   fabs(((0.7199999999999996 * w1_2) + (1.199999999999999 * w2_2)) - (1.2490009027033011e-15 * w3_2)) <= most3_2:
 *     never false in 6513 calls.
 *   fabs((0.2400000000000011 * w1_2) + (2.914335439641036e-15 * w2_2) + (3.747002708109903e-15 * w3_2)) <= most3_2:
 *     never false in 6513 calls.
 *   low < top: never false in 6513 calls.
 *   PTC_FINITE_F64(flat2_1): never false in 6513 calls.
 *   PTC_FINITE_F64(flat3_1): never false in 6513 calls.
 *   PTC_FINITE_F64(flat2_2): never false in 6513 calls.
 *   PTC_FINITE_F64(flat3_2): never false in 6513 calls.
 */
#ifndef TABLE_TOO_SOON_SELFTEST_H
#define TABLE_TOO_SOON_SELFTEST_H

#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/* The number of failed checks: 0 if the controller works on this machine. It uses no heap, output
 * or clock, and keeps no state. */
uint32_t table_too_soon_selftest(void);

#ifdef __cplusplus
}
#endif

#endif
