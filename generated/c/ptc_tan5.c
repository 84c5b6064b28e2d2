/* Prescribed-time controller ptc_tan5: see ptc_tan5.h. DO NOT EDIT. */
#include "ptc_tan5.h"

#include <float.h>
#include <math.h>
#include <stddef.h>

/* What this file requires of its compiler. */
#if defined(__SDCC) || (defined(DBL_MANT_DIG) && (DBL_MANT_DIG != 53))
#error "double is not IEEE 754 binary64 here: emit with --precision f32, or make double 64 bits wide"
#endif
#if defined(FLT_EVAL_METHOD) && !defined(PTC_ALLOW_EXCESS_PRECISION)
#if (FLT_EVAL_METHOD == 2)
#error "double is computed with more digits than it has: on x86 compile with -msse2 -mfpmath=sse, or define PTC_ALLOW_EXCESS_PRECISION"
#endif
#endif
#if !defined(PTC_ALLOW_FAST_MATH)
#if defined(__FAST_MATH__) || defined(_M_FP_FAST)
#error "the guards need NaN and infinity: compile without -ffast-math, -Ofast and -ffinite-math-only, or define PTC_ALLOW_FAST_MATH"
#elif defined(__FINITE_MATH_ONLY__)
#if __FINITE_MATH_ONLY__ > 0
#error "the guards need NaN and infinity: compile without -ffast-math, -Ofast and -ffinite-math-only, or define PTC_ALLOW_FAST_MATH"
#endif
#endif
#endif

#if !defined(PTC_FINITE_F64)
#if defined(isfinite) && !defined(__MINGW32__)
#define PTC_FINITE_F64(x) (isfinite(x) != 0)
#else
#define PTC_FINITE_F64(x) (fabs(x) <= DBL_MAX)
#endif
#endif

ptc_status ptc_tan5_init(ptc_tan5 *self, const ptc_tan5_params *params)
{
    ptc_status status = PTC_E_PARAM;
    struct ptc_tan5 built;

    if ((self != NULL) && (params != NULL)) {
        const double tau = params->tau;
        const double t0 = params->t0;
        const double eps = params->eps;
        const double u_max = params->u_max;
        const double a = params->a;
        const double k1 = params->k[0];
        const double k2 = params->k[1];
        const double k3 = params->k[2];
        const double k4 = params->k[3];
        const double k5 = params->k[4];
        if (PTC_FINITE_F64(tau)
            && (1e-150 <= tau)
            && (tau <= 1e150)
            && PTC_FINITE_F64(t0)
            && (eps >= 1e-150)
            && (u_max > 0.0)
            && PTC_FINITE_F64(a)
            && (1e-150 <= a)
            && (a <= 1e150)
            && PTC_FINITE_F64(k1)
            && PTC_FINITE_F64(k2)
            && PTC_FINITE_F64(k3)
            && PTC_FINITE_F64(k4)
            && PTC_FINITE_F64(k5)
            && (eps < tau)) {
            const double v1 = a * a;
            const double v2 = v1 * v1;
            const double v3 = a * v2;
            const double K1 = k1 / v3;
            const double K2 = k2 / v2;
            const double v4 = a * v1;
            const double K3 = k3 / v4;
            const double K4 = k4 / v1;
            const double K5 = k5 / a;
            const double c1_5 = -K1;
            const double angle_rate = 1.5707963267948966 / tau;
            const double inv_angle_rate = 0.6366197723675814 * tau;
            const double hold_from = -eps;
            const double inv_tau = 1.0 / tau;
            const double s1 = (-(6.088068189625153 * K2)) + (12.176136379250305 * K4);
            const double v5 = s1 - 146.11363655100365;
            const double v6 = tau * tau;
            const double v7 = v6 * v6;
            const double c2_0 = v5 / v7;
            const double v8 = (7.751569170074955 * K3) - (93.01883004089946 * K5);
            const double v9 = tau * v6;
            const double c2_1 = v8 / v9;
            const double s2 = (-(9.869604401089358 * K2)) - (4.934802200544679 * K4);
            const double c2_2 = (s2 + 592.1762640653615) / v6;
            const double c2_3 = (9.42477796076938 * K3) / tau;
            const double c2_4 = ((-(6.0 * K2)) - (10.0 * K4)) - 120.0;
            const double v10 = (3.819718634205488 * K3) + (15.278874536821952 * K5);
            const double c2_5 = v10 * tau;
            const double v11 = 2.4317084074161066 * K4;
            const double v12 = (-(1.6211389382774044 * K2)) - v11;
            const double c2_6 = v12 * v6;
            const double c2_7 = 0.5160245509311918 * K3 * v9;
            const double c2_8 = (-(0.16425571607494938 * K2)) * v7;
            const double v13 = (-(3.8757845850374775 * K3)) + (31.00627668029982 * K5);
            const double c3_0 = v13 / v9;
            const double c3_1 = ((14.804406601634039 * K4) - 394.78417604357435) / v6;
            const double v14 = (-(4.71238898038469 * K3)) - (43.982297150257104 * K5);
            const double c3_2 = v14 / tau;
            const double c3_3 = (12.0 * K4) + 240.0;
            const double v15 = (-(1.909859317102744 * K3)) - (22.91831180523293 * K5);
            const double c3_4 = v15 * tau;
            const double c3_5 = v11 * v6;
            const double c3_6 = (-(0.2580122754655959 * K3)) * v9;
            const double c4_0 = ((-(2.4674011002723395 * K4)) + 49.34802200544679) / v6;
            const double c4_1 = (18.84955592153876 * K5) / tau;
            const double c4_2 = (-(2.0 * K4)) - 120.0;
            const double c4_3 = 7.639437268410976 * K5 * tau;
            const double c4_4 = (-(0.4052847345693511 * K4)) * v6;
            const double c5_0 = (-(1.5707963267948966 * K5)) / tau;
            const double c5_2 = (-(0.6366197723675814 * K5)) * tau;
            const double size_K1 = (fabs(k1) <= 0.0) ? 1e-200 : fabs(K1);
            const double size_K2 = (fabs(k2) <= 0.0) ? 1e-200 : fabs(K2);
            const double size_K3 = (fabs(k3) <= 0.0) ? 1e-200 : fabs(K3);
            const double size_K4 = (fabs(k4) <= 0.0) ? 1e-200 : fabs(K4);
            const double size_K5 = (fabs(k5) <= 0.0) ? 1e-200 : fabs(K5);
            const double size_c2_0 = (fabs(v5) <= 0.0) ? 1e-200 : fabs(c2_0);
            const double size_c2_1 = (fabs(v8) <= 0.0) ? 1e-200 : fabs(c2_1);
            const double size_c2_3 = (fabs(k3) <= 0.0) ? 1e-200 : fabs(c2_3);
            const double size_c2_5 = (fabs(v10) <= 0.0) ? 1e-200 : fabs(c2_5);
            const double size_c2_6 = (fabs(v12) <= 0.0) ? 1e-200 : fabs(c2_6);
            const double size_c2_7 = (fabs(k3) <= 0.0) ? 1e-200 : fabs(c2_7);
            const double size_c2_8 = (fabs(k2) <= 0.0) ? 1e-200 : fabs(c2_8);
            const double size_c3_0 = (fabs(v13) <= 0.0) ? 1e-200 : fabs(c3_0);
            const double size_c3_2 = (fabs(v14) <= 0.0) ? 1e-200 : fabs(c3_2);
            const double size_c3_4 = (fabs(v15) <= 0.0) ? 1e-200 : fabs(c3_4);
            const double size_c3_5 = (fabs(k4) <= 0.0) ? 1e-200 : fabs(c3_5);
            const double size_c3_6 = (fabs(k3) <= 0.0) ? 1e-200 : fabs(c3_6);
            const double size_c4_1 = (fabs(k5) <= 0.0) ? 1e-200 : fabs(c4_1);
            const double size_c4_3 = (fabs(k5) <= 0.0) ? 1e-200 : fabs(c4_3);
            const double size_c4_4 = (fabs(k4) <= 0.0) ? 1e-200 : fabs(c4_4);
            const double size_c5_0 = (fabs(k5) <= 0.0) ? 1e-200 : fabs(c5_0);
            const double size_c5_2 = (fabs(k5) <= 0.0) ? 1e-200 : fabs(c5_2);
            if ((v2 >= 1e-200)
                && (v3 >= 1e-200)
                && (size_K1 >= 1e-200)
                && (size_K2 >= 1e-200)
                && (v4 >= 1e-200)
                && (size_K3 >= 1e-200)
                && (size_K4 >= 1e-200)
                && (size_K5 >= 1e-200)
                && (v7 >= 1e-200)
                && (size_c2_0 >= 1e-200)
                && (v9 >= 1e-200)
                && (size_c2_1 >= 1e-200)
                && (size_c2_3 >= 1e-200)
                && (size_c2_5 >= 1e-200)
                && (size_c2_6 >= 1e-200)
                && (size_c2_7 >= 1e-200)
                && (size_c2_8 >= 1e-200)
                && (size_c3_0 >= 1e-200)
                && (size_c3_2 >= 1e-200)
                && (size_c3_4 >= 1e-200)
                && (size_c3_5 >= 1e-200)
                && (size_c3_6 >= 1e-200)
                && (size_c4_1 >= 1e-200)
                && (size_c4_3 >= 1e-200)
                && (size_c4_4 >= 1e-200)
                && (size_c5_0 >= 1e-200)
                && (size_c5_2 >= 1e-200)
                && PTC_FINITE_F64(c1_5)
                && PTC_FINITE_F64(angle_rate)
                && PTC_FINITE_F64(inv_angle_rate)
                && PTC_FINITE_F64(hold_from)
                && PTC_FINITE_F64(inv_tau)
                && PTC_FINITE_F64(c2_0)
                && PTC_FINITE_F64(c2_1)
                && PTC_FINITE_F64(c2_2)
                && PTC_FINITE_F64(c2_3)
                && PTC_FINITE_F64(c2_4)
                && PTC_FINITE_F64(c2_5)
                && PTC_FINITE_F64(c2_6)
                && PTC_FINITE_F64(c2_7)
                && PTC_FINITE_F64(c2_8)
                && PTC_FINITE_F64(c3_0)
                && PTC_FINITE_F64(c3_1)
                && PTC_FINITE_F64(c3_2)
                && PTC_FINITE_F64(c3_3)
                && PTC_FINITE_F64(c3_4)
                && PTC_FINITE_F64(c3_5)
                && PTC_FINITE_F64(c3_6)
                && PTC_FINITE_F64(c4_0)
                && PTC_FINITE_F64(c4_1)
                && PTC_FINITE_F64(c4_2)
                && PTC_FINITE_F64(c4_3)
                && PTC_FINITE_F64(c4_4)
                && PTC_FINITE_F64(c5_0)
                && PTC_FINITE_F64(c5_2)) {
                built.c1_5 = c1_5;
                built.tau = tau;
                built.angle_rate = angle_rate;
                built.inv_angle_rate = inv_angle_rate;
                built.eps = eps;
                built.hold_from = hold_from;
                built.inv_tau = inv_tau;
                built.c2_0 = c2_0;
                built.c2_1 = c2_1;
                built.c2_2 = c2_2;
                built.c2_3 = c2_3;
                built.c2_4 = c2_4;
                built.c2_5 = c2_5;
                built.c2_6 = c2_6;
                built.c2_7 = c2_7;
                built.c2_8 = c2_8;
                built.c3_0 = c3_0;
                built.c3_1 = c3_1;
                built.c3_2 = c3_2;
                built.c3_3 = c3_3;
                built.c3_4 = c3_4;
                built.c3_5 = c3_5;
                built.c3_6 = c3_6;
                built.c4_0 = c4_0;
                built.c4_1 = c4_1;
                built.c4_2 = c4_2;
                built.c4_3 = c4_3;
                built.c4_4 = c4_4;
                built.c5_0 = c5_0;
                built.c5_2 = c5_2;
                built.u_max = u_max;
                built.t0 = 0.0;
                built.deadline = 0.0;
                built.correction = 0.0;
                status = ptc_tan5_arm(&built, t0);
                if (status == PTC_OK) {
                    *self = built;
                }
            }
        }
    }
    return status;
}

ptc_status ptc_tan5_arm(ptc_tan5 *self, double t0)
{
    ptc_status status = PTC_E_PARAM;

    if (self != NULL) {
        if (PTC_FINITE_F64(t0)) {
            const double deadline = t0 + self->tau;
            const double v1 = deadline - t0;
            const double correction = (t0 - (deadline - v1)) + (self->tau - v1);
            if (PTC_FINITE_F64(deadline)) {
                self->t0 = t0;
                self->deadline = deadline;
                self->correction = correction;
                status = PTC_OK;
            }
        }
    }
    return status;
}

ptc_status ptc_tan5_step(const ptc_tan5 *self, double t, const double x[5], double *u)
{
    ptc_status status = PTC_E_INPUT;

    if (u != NULL) {
        *u = 0.0;
    }
    if ((self != NULL) && (x != NULL) && (u != NULL)) {
        if (t >= self->t0) {
            const double past = (t - self->deadline) - self->correction;
            const double late = (past < self->hold_from) ? past : self->hold_from;
            const double v1 = late * self->inv_tau;
            const double inv_T_squared = 1.0 / (late * late);
            const double v2 = v1 * v1;
            const double s1 = (((-1.4910885650059303e-8) * v2) + 5.2188099741561376e-8) * v2;
            const double s2 = ((s1 - 1.6867939433688022e-7) * v2) + 8.247582914168544e-8;
            const double s3 = ((s2 * v2) - 6.748341805449633e-7) * v2;
            const double s4 = ((s3 - 1.7709607183780777e-6) * v2) - 7.696335899623563e-6;
            const double s5 = ((s4 * v2) - 3.049467456647586e-5) * v2;
            const double s6 = ((s5 - 0.00012208352032846455) * v2) - 0.0004884004503196425;
            const double s7 = ((s6 * v2) - 0.001955067633906801) * v2;
            const double s8 = ((s7 - 0.007844354338480027) * v2) - 0.031791970687246554;
            const double s9 = (((s8 * v2) - 0.13529040421388916) * v2) - 0.8224670334241132;
            const double th_cot_th = (s9 * v2) + 1.0;
            const double cot_rate_squared = inv_T_squared * (th_cot_th * th_cot_th);
            const double slope = self->angle_rate + (self->inv_angle_rate * cot_rate_squared);
            const double v3 = slope * slope;
            const double row1 = self->c1_5 * slope * v3 * v3;
            const double T = -late;
            const double cot_rate = T * inv_T_squared * th_cot_th;
            const double s10 = (self->c2_8 * cot_rate_squared) + self->c2_6;
            const double s11 = ((s10 * cot_rate_squared) + self->c2_4) * cot_rate_squared;
            const double s12 = (self->c2_7 * cot_rate_squared) + self->c2_5;
            const double s13 = ((s12 * cot_rate_squared) + self->c2_3) * cot_rate_squared;
            const double s14 = ((s11 + self->c2_2) * cot_rate_squared) + self->c2_0;
            const double row2 = s14 + ((s13 + self->c2_1) * cot_rate);
            const double s15 = (self->c3_6 * cot_rate_squared) + self->c3_4;
            const double s16 = ((s15 * cot_rate_squared) + self->c3_2) * cot_rate_squared;
            const double s17 = (self->c3_5 * cot_rate_squared) + self->c3_3;
            const double s18 = ((s17 * cot_rate_squared) + self->c3_1) * cot_rate;
            const double row3 = s16 + self->c3_0 + s18;
            const double s19 = (self->c4_4 * cot_rate_squared) + self->c4_2;
            const double s20 = ((self->c4_3 * cot_rate_squared) + self->c4_1) * cot_rate;
            const double row4 = (s19 * cot_rate_squared) + self->c4_0 + s20;
            const double s21 = (self->c5_2 * cot_rate_squared) + self->c5_0;
            const double row5 = s21 + (20.0 * cot_rate);
            const double s22 = (row1 * x[0]) + (row2 * x[1]) + (row3 * x[2]) + (row4 * x[3]);
            const double v = s22 + (row5 * x[4]);
            *u = v;
            if (PTC_FINITE_F64(v) && (fabs(v) <= self->u_max) && (late < self->hold_from)) {
                status = PTC_OK;
            } else if (PTC_FINITE_F64(t)
                && PTC_FINITE_F64(x[0])
                && PTC_FINITE_F64(x[1])
                && PTC_FINITE_F64(x[2])
                && PTC_FINITE_F64(x[3])
                && PTC_FINITE_F64(x[4])) {
                if (PTC_FINITE_F64(v)) {
                    if (v > self->u_max) {
                        *u = self->u_max;
                        status = PTC_SATURATED;
                    } else if (v < -self->u_max) {
                        *u = -self->u_max;
                        status = PTC_SATURATED;
                    } else {
                        status = PTC_HOLD;
                    }
                } else {
                    *u = 0.0;
                    status = PTC_E_RANGE;
                }
            } else {
                *u = 0.0;
                status = PTC_E_INPUT;
            }
        }
    }
    return status;
}

ptc_status ptc_tan5_tick(const ptc_tan5 *self, double t, ptc_tan5_gains *gains)
{
    ptc_status status = PTC_E_INPUT;

    if ((self != NULL) && (gains != NULL)) {
        if (PTC_FINITE_F64(t) && (t >= self->t0)) {
            const double past = (t - self->deadline) - self->correction;
            const double late = (past < self->hold_from) ? past : self->hold_from;
            const double v1 = late * self->inv_tau;
            const double inv_T_squared = 1.0 / (late * late);
            const double v2 = v1 * v1;
            const double s1 = (((-1.4910885650059303e-8) * v2) + 5.2188099741561376e-8) * v2;
            const double s2 = ((s1 - 1.6867939433688022e-7) * v2) + 8.247582914168544e-8;
            const double s3 = ((s2 * v2) - 6.748341805449633e-7) * v2;
            const double s4 = ((s3 - 1.7709607183780777e-6) * v2) - 7.696335899623563e-6;
            const double s5 = ((s4 * v2) - 3.049467456647586e-5) * v2;
            const double s6 = ((s5 - 0.00012208352032846455) * v2) - 0.0004884004503196425;
            const double s7 = ((s6 * v2) - 0.001955067633906801) * v2;
            const double s8 = ((s7 - 0.007844354338480027) * v2) - 0.031791970687246554;
            const double s9 = (((s8 * v2) - 0.13529040421388916) * v2) - 0.8224670334241132;
            const double th_cot_th = (s9 * v2) + 1.0;
            const double cot_rate_squared = inv_T_squared * (th_cot_th * th_cot_th);
            const double slope = self->angle_rate + (self->inv_angle_rate * cot_rate_squared);
            const double v3 = slope * slope;
            const double row1 = self->c1_5 * slope * v3 * v3;
            const double T = -late;
            const double cot_rate = T * inv_T_squared * th_cot_th;
            const double s10 = (self->c2_8 * cot_rate_squared) + self->c2_6;
            const double s11 = ((s10 * cot_rate_squared) + self->c2_4) * cot_rate_squared;
            const double s12 = (self->c2_7 * cot_rate_squared) + self->c2_5;
            const double s13 = ((s12 * cot_rate_squared) + self->c2_3) * cot_rate_squared;
            const double s14 = ((s11 + self->c2_2) * cot_rate_squared) + self->c2_0;
            const double row2 = s14 + ((s13 + self->c2_1) * cot_rate);
            const double s15 = (self->c3_6 * cot_rate_squared) + self->c3_4;
            const double s16 = ((s15 * cot_rate_squared) + self->c3_2) * cot_rate_squared;
            const double s17 = (self->c3_5 * cot_rate_squared) + self->c3_3;
            const double s18 = ((s17 * cot_rate_squared) + self->c3_1) * cot_rate;
            const double row3 = s16 + self->c3_0 + s18;
            const double s19 = (self->c4_4 * cot_rate_squared) + self->c4_2;
            const double s20 = ((self->c4_3 * cot_rate_squared) + self->c4_1) * cot_rate;
            const double row4 = (s19 * cot_rate_squared) + self->c4_0 + s20;
            const double s21 = (self->c5_2 * cot_rate_squared) + self->c5_0;
            const double row5 = s21 + (20.0 * cot_rate);
            gains->gain[0] = row1;
            gains->gain[1] = row2;
            gains->gain[2] = row3;
            gains->gain[3] = row4;
            gains->gain[4] = row5;
            gains->u_max = self->u_max;
            if (late < self->hold_from) {
                status = PTC_OK;
            } else {
                status = PTC_HOLD;
            }
            gains->status = status;
        }
    }
    return status;
}

ptc_status ptc_tan5_axis(const ptc_tan5_gains *gains, const double x[5], double *u)
{
    ptc_status status = PTC_E_INPUT;

    if (u != NULL) {
        *u = 0.0;
    }
    if ((gains != NULL) && (x != NULL) && (u != NULL)) {
        const double s1 = (gains->gain[0] * x[0]) + (gains->gain[1] * x[1]);
        const double s2 = s1 + (gains->gain[2] * x[2]) + (gains->gain[3] * x[3]);
        const double v = s2 + (gains->gain[4] * x[4]);
        *u = v;
        if (PTC_FINITE_F64(v) && (fabs(v) <= gains->u_max)) {
            status = gains->status;
        } else if (PTC_FINITE_F64(x[0])
            && PTC_FINITE_F64(x[1])
            && PTC_FINITE_F64(x[2])
            && PTC_FINITE_F64(x[3])
            && PTC_FINITE_F64(x[4])) {
            if (PTC_FINITE_F64(v)) {
                if (v > gains->u_max) {
                    *u = gains->u_max;
                    status = PTC_SATURATED;
                } else {
                    *u = -gains->u_max;
                    status = PTC_SATURATED;
                }
            } else {
                *u = 0.0;
                status = PTC_E_RANGE;
            }
        } else {
            *u = 0.0;
            status = PTC_E_INPUT;
        }
    }
    return status;
}
