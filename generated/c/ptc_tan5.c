/* Prescribed-time controller ptc_tan5: see ptc_tan5.h. DO NOT EDIT. */
#include "ptc_tan5.h"

#include <math.h>
#include <stddef.h>

/* Whether a product keeps its digits: it is well above the least normal number, or 0 with a factor. */
static int ptc_tan5_kept(double product, double factor)
{
    return ((fabs(product) >= 1e-200) || (fabs(factor) <= 0.0)) ? 1 : 0;
}

ptc_status ptc_tan5_init(ptc_tan5 *self, const ptc_tan5_params *params)
{
    ptc_status status = PTC_E_PARAM;

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

        if (isfinite(tau)
            && (tau >= 1e-150)
            && (tau <= 1e150)
            && isfinite(t0)
            && (eps >= 1e-150)
            && (u_max > 0.0)
            && isfinite(a)
            && (a >= 1e-150)
            && (a <= 1e150)
            && isfinite(k1)
            && isfinite(k2)
            && isfinite(k3)
            && isfinite(k4)
            && isfinite(k5)
            && (eps < tau)) {
            struct ptc_tan5 built;

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
            const double v5 = ((-(6.088068189625153 * K2)) + (12.176136379250305 * K4)) - 146.11363655100365;
            const double v6 = tau * tau;
            const double v7 = v6 * v6;
            const double c2_0 = v5 / v7;
            const double v8 = (7.751569170074955 * K3) - (93.01883004089946 * K5);
            const double v9 = tau * v6;
            const double c2_1 = v8 / v9;
            const double v10 = ((-(9.869604401089358 * K2)) - (4.934802200544679 * K4)) + 592.1762640653615;
            const double c2_2 = v10 / v6;
            const double c2_3 = (9.42477796076938 * K3) / tau;
            const double c2_4 = ((-(6.0 * K2)) - (10.0 * K4)) - 120.0;
            const double v11 = (3.819718634205488 * K3) + (15.278874536821952 * K5);
            const double c2_5 = v11 * tau;
            const double v12 = 2.4317084074161066 * K4;
            const double v13 = (-(1.6211389382774044 * K2)) - v12;
            const double c2_6 = v13 * v6;
            const double c2_7 = 0.5160245509311918 * K3 * v9;
            const double c2_8 = (-(0.16425571607494938 * K2)) * v7;
            const double v14 = (-(3.8757845850374775 * K3)) + (31.00627668029982 * K5);
            const double c3_0 = v14 / v9;
            const double c3_1 = ((14.804406601634039 * K4) - 394.78417604357435) / v6;
            const double v15 = (-(4.71238898038469 * K3)) - (43.982297150257104 * K5);
            const double c3_2 = v15 / tau;
            const double c3_3 = (12.0 * K4) + 240.0;
            const double v16 = (-(1.909859317102744 * K3)) - (22.91831180523293 * K5);
            const double c3_4 = v16 * tau;
            const double c3_5 = v12 * v6;
            const double c3_6 = (-(0.2580122754655959 * K3)) * v9;
            const double c4_0 = ((-(2.4674011002723395 * K4)) + 49.34802200544679) / v6;
            const double c4_1 = (18.84955592153876 * K5) / tau;
            const double c4_2 = (-(2.0 * K4)) - 120.0;
            const double c4_3 = 7.639437268410976 * K5 * tau;
            const double c4_4 = (-(0.4052847345693511 * K4)) * v6;
            const double c5_0 = (-(1.5707963267948966 * K5)) / tau;
            const double c5_2 = (-(0.6366197723675814 * K5)) * tau;
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

            if ((v2 >= 1e-200)
                && (v3 >= 1e-200)
                && (ptc_tan5_kept(K1, k1) != 0)
                && (ptc_tan5_kept(K2, k2) != 0)
                && (v4 >= 1e-200)
                && (ptc_tan5_kept(K3, k3) != 0)
                && (ptc_tan5_kept(K4, k4) != 0)
                && (ptc_tan5_kept(K5, k5) != 0)
                && (v7 >= 1e-200)
                && (ptc_tan5_kept(c2_0, v5) != 0)
                && (v9 >= 1e-200)
                && (ptc_tan5_kept(c2_1, v8) != 0)
                && (ptc_tan5_kept(c2_3, k3) != 0)
                && (ptc_tan5_kept(c2_5, v11) != 0)
                && (ptc_tan5_kept(c2_6, v13) != 0)
                && (ptc_tan5_kept(c2_7, k3) != 0)
                && (ptc_tan5_kept(c2_8, k2) != 0)
                && (ptc_tan5_kept(c3_0, v14) != 0)
                && (ptc_tan5_kept(c3_2, v15) != 0)
                && (ptc_tan5_kept(c3_4, v16) != 0)
                && (ptc_tan5_kept(c3_5, k4) != 0)
                && (ptc_tan5_kept(c3_6, k3) != 0)
                && (ptc_tan5_kept(c4_1, k5) != 0)
                && (ptc_tan5_kept(c4_3, k5) != 0)
                && (ptc_tan5_kept(c4_4, k4) != 0)
                && (ptc_tan5_kept(c5_0, k5) != 0)
                && (ptc_tan5_kept(c5_2, k5) != 0)
                && isfinite(built.c1_5)
                && isfinite(built.angle_rate)
                && isfinite(built.inv_angle_rate)
                && isfinite(built.hold_from)
                && isfinite(built.inv_tau)
                && isfinite(built.c2_0)
                && isfinite(built.c2_1)
                && isfinite(built.c2_2)
                && isfinite(built.c2_3)
                && isfinite(built.c2_4)
                && isfinite(built.c2_5)
                && isfinite(built.c2_6)
                && isfinite(built.c2_7)
                && isfinite(built.c2_8)
                && isfinite(built.c3_0)
                && isfinite(built.c3_1)
                && isfinite(built.c3_2)
                && isfinite(built.c3_3)
                && isfinite(built.c3_4)
                && isfinite(built.c3_5)
                && isfinite(built.c3_6)
                && isfinite(built.c4_0)
                && isfinite(built.c4_1)
                && isfinite(built.c4_2)
                && isfinite(built.c4_3)
                && isfinite(built.c4_4)
                && isfinite(built.c5_0)
                && isfinite(built.c5_2)) {
                status = ptc_tan5_arm(&built, t0);
            }
            if (status == PTC_OK) {
                *self = built;
            }
        }
    }
    return status;
}

ptc_status ptc_tan5_arm(ptc_tan5 *self, double t0)
{
    ptc_status status = PTC_E_PARAM;

    if ((self != NULL) && isfinite(t0)) {
        const double deadline = t0 + self->tau;
        const double v1 = deadline - t0;
        const double correction = (t0 - (deadline - v1)) + (self->tau - v1);

        if (isfinite(deadline) != 0) {
            self->t0 = t0;
            self->deadline = deadline;
            self->correction = correction;
            status = PTC_OK;
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
        const double x1 = x[0];
        const double x2 = x[1];
        const double x3 = x[2];
        const double x4 = x[3];
        const double x5 = x[4];

        if (isfinite(t)
            && (t >= self->t0)
            && isfinite(x1)
            && isfinite(x2)
            && isfinite(x3)
            && isfinite(x4)
            && isfinite(x5)) {
            const double past = (t - self->deadline) - self->correction;
            const double late = (past < self->hold_from) ? past : self->hold_from;
            const double v1 = late * self->inv_tau;
            const double inv_T_squared = 1.0 / (late * late);
            const double v2 = v1 * v1;
            const double v3 = ((((-1.4910885650059303e-8) * v2) + 5.2188099741561376e-8) * v2) - 1.6867939433688022e-7;
            const double v4 = ((((v3 * v2) + 8.247582914168544e-8) * v2) - 6.748341805449633e-7) * v2;
            const double v5 = (((v4 - 1.7709607183780777e-6) * v2) - 7.696335899623563e-6) * v2;
            const double v6 = (((v5 - 3.049467456647586e-5) * v2) - 0.00012208352032846455) * v2;
            const double v7 = (((v6 - 0.0004884004503196425) * v2) - 0.001955067633906801) * v2;
            const double v8 = ((((v7 - 0.007844354338480027) * v2) - 0.031791970687246554) * v2) - 0.13529040421388916;
            const double th_cot_th = (((v8 * v2) - 0.8224670334241132) * v2) + 1.0;
            const double cot_rate_squared = inv_T_squared * (th_cot_th * th_cot_th);
            const double slope = self->angle_rate + (self->inv_angle_rate * cot_rate_squared);
            const double v9 = slope * slope;
            const double row1 = self->c1_5 * slope * v9 * v9;
            const double T = -late;
            const double cot_rate = T * inv_T_squared * th_cot_th;
            const double v10 = ((self->c2_7 * cot_rate_squared) + self->c2_5) * cot_rate_squared;
            const double v11 = (((v10 + self->c2_3) * cot_rate_squared) + self->c2_1) * cot_rate;
            const double v12 = ((self->c2_8 * cot_rate_squared) + self->c2_6) * cot_rate_squared;
            const double v13 = (((v12 + self->c2_4) * cot_rate_squared) + self->c2_2) * cot_rate_squared;
            const double row2 = v13 + self->c2_0 + v11;
            const double v14 = ((self->c3_5 * cot_rate_squared) + self->c3_3) * cot_rate_squared;
            const double v15 = ((self->c3_6 * cot_rate_squared) + self->c3_4) * cot_rate_squared;
            const double row3 = ((v15 + self->c3_2) * cot_rate_squared) + self->c3_0 + ((v14 + self->c3_1) * cot_rate);
            const double v16 = ((self->c4_4 * cot_rate_squared) + self->c4_2) * cot_rate_squared;
            const double row4 = v16 + self->c4_0 + (((self->c4_3 * cot_rate_squared) + self->c4_1) * cot_rate);
            const double row5 = (self->c5_2 * cot_rate_squared) + self->c5_0 + (20.0 * cot_rate);
            const double v17 = (row1 * x1) + (row2 * x2) + (row3 * x3) + (row4 * x4) + (row5 * x5);
            double v = v17;

            if (v > self->u_max) {
                v = self->u_max;
                status = PTC_SATURATED;
            } else if (v < -self->u_max) {
                v = -self->u_max;
                status = PTC_SATURATED;
            } else if (isfinite(v) == 0) {
                v = 0.0;
                status = PTC_E_RANGE;
            } else if (late < self->hold_from) {
                status = PTC_OK;
            } else {
                status = PTC_HOLD;
            }
            *u = v;
        }
    }
    return status;
}

ptc_status ptc_tan5_tick(const ptc_tan5 *self, double t, ptc_tan5_gains *gains)
{
    ptc_status status = PTC_E_INPUT;

    if ((self != NULL)
        && (gains != NULL)
        && isfinite(t)
        && (t >= self->t0)) {
        const double past = (t - self->deadline) - self->correction;
        const double late = (past < self->hold_from) ? past : self->hold_from;
        const double v1 = late * self->inv_tau;
        const double inv_T_squared = 1.0 / (late * late);
        const double v2 = v1 * v1;
        const double v3 = ((((-1.4910885650059303e-8) * v2) + 5.2188099741561376e-8) * v2) - 1.6867939433688022e-7;
        const double v4 = ((((v3 * v2) + 8.247582914168544e-8) * v2) - 6.748341805449633e-7) * v2;
        const double v5 = (((v4 - 1.7709607183780777e-6) * v2) - 7.696335899623563e-6) * v2;
        const double v6 = (((v5 - 3.049467456647586e-5) * v2) - 0.00012208352032846455) * v2;
        const double v7 = (((v6 - 0.0004884004503196425) * v2) - 0.001955067633906801) * v2;
        const double v8 = ((((v7 - 0.007844354338480027) * v2) - 0.031791970687246554) * v2) - 0.13529040421388916;
        const double th_cot_th = (((v8 * v2) - 0.8224670334241132) * v2) + 1.0;
        const double cot_rate_squared = inv_T_squared * (th_cot_th * th_cot_th);
        const double slope = self->angle_rate + (self->inv_angle_rate * cot_rate_squared);
        const double v9 = slope * slope;
        const double row1 = self->c1_5 * slope * v9 * v9;
        const double T = -late;
        const double cot_rate = T * inv_T_squared * th_cot_th;
        const double v10 = ((self->c2_7 * cot_rate_squared) + self->c2_5) * cot_rate_squared;
        const double v11 = (((v10 + self->c2_3) * cot_rate_squared) + self->c2_1) * cot_rate;
        const double v12 = ((self->c2_8 * cot_rate_squared) + self->c2_6) * cot_rate_squared;
        const double v13 = (((v12 + self->c2_4) * cot_rate_squared) + self->c2_2) * cot_rate_squared;
        const double row2 = v13 + self->c2_0 + v11;
        const double v14 = ((self->c3_5 * cot_rate_squared) + self->c3_3) * cot_rate_squared;
        const double v15 = ((self->c3_6 * cot_rate_squared) + self->c3_4) * cot_rate_squared;
        const double row3 = ((v15 + self->c3_2) * cot_rate_squared) + self->c3_0 + ((v14 + self->c3_1) * cot_rate);
        const double v16 = ((self->c4_4 * cot_rate_squared) + self->c4_2) * cot_rate_squared;
        const double row4 = v16 + self->c4_0 + (((self->c4_3 * cot_rate_squared) + self->c4_1) * cot_rate);
        const double row5 = (self->c5_2 * cot_rate_squared) + self->c5_0 + (20.0 * cot_rate);
        status = (late < self->hold_from) ? PTC_OK : PTC_HOLD;
        gains->gain[0] = row1;
        gains->gain[1] = row2;
        gains->gain[2] = row3;
        gains->gain[3] = row4;
        gains->gain[4] = row5;
        gains->u_max = self->u_max;
        gains->status = status;
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
        const double x1 = x[0];
        const double x2 = x[1];
        const double x3 = x[2];
        const double x4 = x[3];
        const double x5 = x[4];

        if (isfinite(x1)
            && isfinite(x2)
            && isfinite(x3)
            && isfinite(x4)
            && isfinite(x5)) {
            const double v1 = (gains->gain[0] * x1) + (gains->gain[1] * x2) + (gains->gain[2] * x3);
            double v = v1 + (gains->gain[3] * x4) + (gains->gain[4] * x5);

            status = gains->status;
            if (v > gains->u_max) {
                v = gains->u_max;
                status = PTC_SATURATED;
            } else if (v < -gains->u_max) {
                v = -gains->u_max;
                status = PTC_SATURATED;
            } else if (isfinite(v) == 0) {
                v = 0.0;
                status = PTC_E_RANGE;
            } else {
                /* within the bound */
            }
            *u = v;
        }
    }
    return status;
}
