/*
 * Self-test of the prescribed-time controller table_too_soon, for the target. DO NOT EDIT. Made by:
 *   ptc-codegen emit --lang c --n 3 --axes 2 --mu "exp(a=1)" --name table_too_soon --clock samples --late=refuse --state-max=inf,0.5,4 --tau=1.5 --eps=0 --u-min=runtime --poles="[[-3,-4,-5],[-4,-5,-6]]" --sample-time=0.01 --selftest
 * Version 0.1.0.
 *
 * 6 sets of parameters with 166 calls, 4 sets that init must refuse. The expected values were
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
 *   -most2_1 <= end54_1: never false in 6513 calls.
 *   end54_1 <= most2_1: never false in 6513 calls.
 *   -most2_1 <= end55_1: never false in 6513 calls.
 *   end55_1 <= most2_1: never false in 6513 calls.
 *   -most2_1 <= end56_1: never false in 6513 calls.
 *   end56_1 <= most2_1: never false in 6513 calls.
 *   -most3_1 <= end57_1: never false in 6513 calls.
 *   end57_1 <= most3_1: never false in 6513 calls.
 *   -most3_1 <= end58_1: never false in 6513 calls.
 *   end58_1 <= most3_1: never false in 6513 calls.
 *   -most3_1 <= end59_1: never false in 6513 calls.
 *   end59_1 <= most3_1: never false in 6513 calls.
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
 *   -most2_2 <= end64_2: never false in 6513 calls.
 *   end64_2 <= most2_2: never false in 6513 calls.
 *   -most2_2 <= end65_2: never false in 6513 calls.
 *   end65_2 <= most2_2: never false in 6513 calls.
 *   -most2_2 <= end66_2: never false in 6513 calls.
 *   end66_2 <= most2_2: never false in 6513 calls.
 *   -most3_2 <= end67_2: never false in 6513 calls.
 *   end67_2 <= most3_2: never false in 6513 calls.
 *   -most3_2 <= end68_2: never false in 6513 calls.
 *   end68_2 <= most3_2: never false in 6513 calls.
 *   -most3_2 <= end69_2: never false in 6513 calls.
 *   end69_2 <= most3_2: never false in 6513 calls.
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
