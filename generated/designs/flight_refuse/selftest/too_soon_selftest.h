/*
 * Self-test of the prescribed-time controller too_soon, for the target. DO NOT EDIT. Made by:
 *   ptc-codegen emit --lang c --n 3 --mu "exp(a=1)" --name too_soon --clock samples --late=refuse --state-max=inf,0.5,4 --precision f32 --tau=1.5 --eps=0 --u-max=20 --poles="least-energy(weight=1)" --sample-time=0.01 --selftest
 * Version 0.1.0.
 *
 * 2 sets of parameters with 57 calls, 0 sets that init must refuse. The expected values were
 * computed by the generator, which runs this very program in the arithmetic of IEEE 754: the
 * operations are its own alone, so that a target has to give the same numbers.
 *
 * Outcomes of conditions that no input tried brings about are not exercised:
 *   2U < samples: `arm_for` is not called.
 *   2U < samples: `arm_for` is not called.
 *   samples < 2147483649U: `arm_for` is not called.
 *   samples < 2147483649U: `arm_for` is not called.
 *   PTC_FINITE_F32(x[0]): `arm_for` is not called.
 *   PTC_FINITE_F32(x[0]): `arm_for` is not called.
 *   PTC_FINITE_F32(x[1]): `arm_for` is not called.
 *   PTC_FINITE_F32(x[1]): `arm_for` is not called.
 *   PTC_FINITE_F32(x[2]): `arm_for` is not called.
 *   PTC_FINITE_F32(x[2]): `arm_for` is not called.
 *   least <= b0_c: `arm_for` is not called.
 *   least <= b0_c: `arm_for` is not called.
 *   b0_c <= most: `arm_for` is not called.
 *   b0_c <= most: `arm_for` is not called.
 *   least <= b1: `arm_for` is not called.
 *   least <= b1: `arm_for` is not called.
 *   b1 <= most: `arm_for` is not called.
 *   b1 <= most: `arm_for` is not called.
 *   least <= b2: `arm_for` is not called.
 *   least <= b2: `arm_for` is not called.
 *   b2 <= most: `arm_for` is not called.
 *   b2 <= most: `arm_for` is not called.
 *   least <= b3: `arm_for` is not called.
 *   least <= b3: `arm_for` is not called.
 *   b3 <= most: `arm_for` is not called.
 *   b3 <= most: `arm_for` is not called.
 *   least <= b4: `arm_for` is not called.
 *   least <= b4: `arm_for` is not called.
 *   b4 <= most: `arm_for` is not called.
 *   b4 <= most: `arm_for` is not called.
 *   least <= b5: `arm_for` is not called.
 *   least <= b5: `arm_for` is not called.
 *   b5 <= most: `arm_for` is not called.
 *   b5 <= most: `arm_for` is not called.
 *   least <= b6: `arm_for` is not called.
 *   least <= b6: `arm_for` is not called.
 *   b6 <= most: `arm_for` is not called.
 *   b6 <= most: `arm_for` is not called.
 *   least <= b7: `arm_for` is not called.
 *   least <= b7: `arm_for` is not called.
 *   b7 <= most: `arm_for` is not called.
 *   b7 <= most: `arm_for` is not called.
 *   -most2 <= s0_c: `arm_for` is not called.
 *   -most2 <= s0_c: `arm_for` is not called.
 *   s0_c <= most2: `arm_for` is not called.
 *   s0_c <= most2: `arm_for` is not called.
 *   -most2 <= s1: `arm_for` is not called.
 *   -most2 <= s1: `arm_for` is not called.
 *   s1 <= most2: `arm_for` is not called.
 *   s1 <= most2: `arm_for` is not called.
 *   -most2 <= s2: `arm_for` is not called.
 *   -most2 <= s2: `arm_for` is not called.
 *   s2 <= most2: `arm_for` is not called.
 *   s2 <= most2: `arm_for` is not called.
 *   -most2 <= s3: `arm_for` is not called.
 *   -most2 <= s3: `arm_for` is not called.
 *   s3 <= most2: `arm_for` is not called.
 *   s3 <= most2: `arm_for` is not called.
 *   -most2 <= s4: `arm_for` is not called.
 *   -most2 <= s4: `arm_for` is not called.
 *   s4 <= most2: `arm_for` is not called.
 *   s4 <= most2: `arm_for` is not called.
 *   -most2 <= s5: `arm_for` is not called.
 *   -most2 <= s5: `arm_for` is not called.
 *   s5 <= most2: `arm_for` is not called.
 *   s5 <= most2: `arm_for` is not called.
 *   -most2 <= s6: `arm_for` is not called.
 *   -most2 <= s6: `arm_for` is not called.
 *   s6 <= most2: `arm_for` is not called.
 *   s6 <= most2: `arm_for` is not called.
 *   -most2 <= s7: `arm_for` is not called.
 *   -most2 <= s7: `arm_for` is not called.
 *   s7 <= most2: `arm_for` is not called.
 *   s7 <= most2: `arm_for` is not called.
 *   -most2 <= s8: `arm_for` is not called.
 *   -most2 <= s8: `arm_for` is not called.
 *   s8 <= most2: `arm_for` is not called.
 *   s8 <= most2: `arm_for` is not called.
 *   -most2 <= s9: `arm_for` is not called.
 *   -most2 <= s9: `arm_for` is not called.
 *   s9 <= most2: `arm_for` is not called.
 *   s9 <= most2: `arm_for` is not called.
 *   -most3 <= v0_c: `arm_for` is not called.
 *   -most3 <= v0_c: `arm_for` is not called.
 *   v0_c <= most3: `arm_for` is not called.
 *   v0_c <= most3: `arm_for` is not called.
 *   -most3 <= v1: `arm_for` is not called.
 *   -most3 <= v1: `arm_for` is not called.
 *   v1 <= most3: `arm_for` is not called.
 *   v1 <= most3: `arm_for` is not called.
 *   -most3 <= v2: `arm_for` is not called.
 *   -most3 <= v2: `arm_for` is not called.
 *   v2 <= most3: `arm_for` is not called.
 *   v2 <= most3: `arm_for` is not called.
 *   -most3 <= v3: `arm_for` is not called.
 *   -most3 <= v3: `arm_for` is not called.
 *   v3 <= most3: `arm_for` is not called.
 *   v3 <= most3: `arm_for` is not called.
 *   -most3 <= v4: `arm_for` is not called.
 *   -most3 <= v4: `arm_for` is not called.
 *   v4 <= most3: `arm_for` is not called.
 *   v4 <= most3: `arm_for` is not called.
 *   -most3 <= v5: `arm_for` is not called.
 *   -most3 <= v5: `arm_for` is not called.
 *   v5 <= most3: `arm_for` is not called.
 *   v5 <= most3: `arm_for` is not called.
 *   -most3 <= v6: `arm_for` is not called.
 *   -most3 <= v6: `arm_for` is not called.
 *   v6 <= most3: `arm_for` is not called.
 *   v6 <= most3: `arm_for` is not called.
 *   -most3 <= v7: `arm_for` is not called.
 *   -most3 <= v7: `arm_for` is not called.
 *   v7 <= most3: `arm_for` is not called.
 *   v7 <= most3: `arm_for` is not called.
 *   -most3 <= v8: `arm_for` is not called.
 *   -most3 <= v8: `arm_for` is not called.
 *   v8 <= most3: `arm_for` is not called.
 *   v8 <= most3: `arm_for` is not called.
 *   least <= end61: `arm_for` is not called.
 *   least <= end61: `arm_for` is not called.
 *   end61 <= most: `arm_for` is not called.
 *   end61 <= most: `arm_for` is not called.
 *   least <= end62: `arm_for` is not called.
 *   least <= end62: `arm_for` is not called.
 *   end62 <= most: `arm_for` is not called.
 *   end62 <= most: `arm_for` is not called.
 *   least <= end63: `arm_for` is not called.
 *   least <= end63: `arm_for` is not called.
 *   end63 <= most: `arm_for` is not called.
 *   end63 <= most: `arm_for` is not called.
 *   -most2 <= end64: `arm_for` is not called.
 *   -most2 <= end64: `arm_for` is not called.
 *   end64 <= most2: `arm_for` is not called.
 *   end64 <= most2: `arm_for` is not called.
 *   -most2 <= end65: `arm_for` is not called.
 *   -most2 <= end65: `arm_for` is not called.
 *   end65 <= most2: `arm_for` is not called.
 *   end65 <= most2: `arm_for` is not called.
 *   -most2 <= end66: `arm_for` is not called.
 *   -most2 <= end66: `arm_for` is not called.
 *   end66 <= most2: `arm_for` is not called.
 *   end66 <= most2: `arm_for` is not called.
 *   -most3 <= end67: `arm_for` is not called.
 *   -most3 <= end67: `arm_for` is not called.
 *   end67 <= most3: `arm_for` is not called.
 *   end67 <= most3: `arm_for` is not called.
 *   -most3 <= end68: `arm_for` is not called.
 *   -most3 <= end68: `arm_for` is not called.
 *   end68 <= most3: `arm_for` is not called.
 *   end68 <= most3: `arm_for` is not called.
 *   -most3 <= end69: `arm_for` is not called.
 *   -most3 <= end69: `arm_for` is not called.
 *   end69 <= most3: `arm_for` is not called.
 *   end69 <= most3: `arm_for` is not called.
 *   3U < tried: `arm_for` is not called.
 *   3U < tried: `arm_for` is not called.
 *   tried < 100001U: `arm_for` is not called.
 *   tried < 100001U: `arm_for` is not called.
 *   fits == 1U: `arm_for` is not called.
 *   fits == 1U: `arm_for` is not called.
 *   PTC_FINITE_F32(x[0]): `soonest` is not called.
 *   PTC_FINITE_F32(x[0]): `soonest` is not called.
 *   PTC_FINITE_F32(x[1]): `soonest` is not called.
 *   PTC_FINITE_F32(x[1]): `soonest` is not called.
 *   PTC_FINITE_F32(x[2]): `soonest` is not called.
 *   PTC_FINITE_F32(x[2]): `soonest` is not called.
 *   low < top: `soonest` is not called.
 *   low < top: `soonest` is not called.
 *   PTC_FINITE_F32(flat1): `soonest` is not called.
 *   PTC_FINITE_F32(flat1): `soonest` is not called.
 *   PTC_FINITE_F32(flat2): `soonest` is not called.
 *   PTC_FINITE_F32(flat2): `soonest` is not called.
 *   PTC_FINITE_F32(flat3): `soonest` is not called.
 *   PTC_FINITE_F32(flat3): `soonest` is not called.
 *   0U < kept: `soonest` is not called.
 *   0U < kept: `soonest` is not called.
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
