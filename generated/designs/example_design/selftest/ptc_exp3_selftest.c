/* Self-test of the prescribed-time controller ptc_exp3: see ptc_exp3_selftest.h. DO NOT EDIT. */
#include "ptc_exp3_selftest.h"
#include "ptc_exp3.h"

#include <math.h>
#include <stddef.h>

/* A call, and what it must give. */
typedef struct ptc_exp3_selftest_call {
    double t;
    double x[3];
    double u;
    double tolerance;
    ptc_status status;
    ptc_status axis; /* of tick and axis */
    uint32_t has_axis;
} ptc_exp3_selftest_call;

/* A set of parameters that init takes, and the calls with it. */
typedef struct ptc_exp3_selftest_session {
    ptc_exp3_params params;
    double t0; /* of arm, where it is called */
    uint32_t is_armed_again;
    uint32_t first; /* of its calls */
    uint32_t count;
} ptc_exp3_selftest_session;

static const ptc_exp3_selftest_session ptc_exp3_selftest_sessions[7] = {
    {.params = {.tau = 2.0, .t0 = 0.3, .eps = 2e-13, .u_max = (double)INFINITY, .k = {3.375, 6.75, 4.5}}, .t0 = 0.0, .is_armed_again = 0U, .first = 0U, .count = 30U},
    {.params = {.tau = 2.0, .t0 = 0.3, .eps = 0.125, .u_max = (double)INFINITY, .k = {3.375, 6.75, 4.5}}, .t0 = 0.0, .is_armed_again = 0U, .first = 30U, .count = 10U},
    {.params = {.tau = 2.0, .t0 = 0.3, .eps = 0.125, .u_max = (double)INFINITY, .k = {3.375, 6.75, 4.5}}, .t0 = 1000.1, .is_armed_again = 1U, .first = 40U, .count = 4U},
    {.params = {.tau = 2.0, .t0 = 0.3, .eps = 0.125, .u_max = 0.78125, .k = {3.375, 6.75, 4.5}}, .t0 = 0.0, .is_armed_again = 0U, .first = 44U, .count = 9U},
    {.params = {.tau = 2.0, .t0 = 0.3, .eps = 0.125, .u_max = (double)INFINITY, .k = {0.0, 0.0, 0.0}}, .t0 = 0.0, .is_armed_again = 0U, .first = 53U, .count = 1U},
    {.params = {.tau = 2.0, .t0 = 0.3, .eps = 0.0002, .u_max = 1.0, .k = {3.375, 6.75, 4.5}}, .t0 = 0.0, .is_armed_again = 0U, .first = 54U, .count = 1U},
    {.params = {.tau = 1e150, .t0 = -1e150, .eps = 1e-150, .u_max = (double)INFINITY, .k = {3.375, 6.75, 4.5}}, .t0 = 0.0, .is_armed_again = 0U, .first = 55U, .count = 1U},
};

/* 1 where what was returned is not what must be. */
static uint32_t ptc_exp3_selftest_differs(const ptc_exp3_selftest_call *call, ptc_status wanted, ptc_status status, double u)
{
    uint32_t failures = 1U;

    if ((status == wanted) && (fabs(u - call->u) <= call->tolerance)) {
        failures = 0U;
    }
    return failures;
}

/* The failures of one call. */
static uint32_t ptc_exp3_selftest_check(const ptc_exp3 *self, const ptc_exp3_selftest_call *call)
{
    double u = 12345.0;
    ptc_status status = ptc_exp3_step(self, call->t, call->x, &u);
    uint32_t failures = ptc_exp3_selftest_differs(call, call->status, status, u);

    if (call->has_axis != 0U) {
        ptc_exp3_gains gains;

        u = 0.0;
        status = ptc_exp3_tick(self, call->t, &gains);
        if (status >= PTC_OK) {
            u = 12345.0;
            status = ptc_exp3_axis(&gains, call->x, &u);
        }
        failures += ptc_exp3_selftest_differs(call, call->axis, status, u);
    }
    return failures;
}

/* Every session with its calls. */
static uint32_t ptc_exp3_selftest_run(void)
{
    static const ptc_exp3_selftest_call calls[56] = {
        {.t = 0.3, .x = {0.75, -1.25, 0.5}, .u = 0.32421875, .tolerance = 6.026730352425306e-14, .status = PTC_OK, .axis = PTC_OK, .has_axis = 1U},
        {.t = 0.8, .x = {-0.75, 1.25, -0.5}, .u = -0.5555555555555556, .tolerance = 1.0067891366940281e-13, .status = PTC_OK, .axis = PTC_OK, .has_axis = 1U},
        {.t = 1.5, .x = {0.75, -1.25, 0.5}, .u = 0.46630859374999994, .tolerance = 3.356748303699724e-13, .status = PTC_OK, .axis = PTC_OK, .has_axis = 1U},
        {.t = 2.1, .x = {-0.75, 1.25, -0.5}, .u = 218.59375000000037, .tolerance = 7.228225062857841e-12, .status = PTC_OK, .axis = PTC_OK, .has_axis = 1U},
        {.t = 2.28, .x = {0.75, -1.25, 0.5}, .u = -306287.49999999144, .tolerance = 3.6167594869308798e-9, .status = PTC_OK, .axis = PTC_OK, .has_axis = 1U},
        {.t = 2.2998, .x = {-0.75, 1.25, -0.5}, .u = 316304691249.31433, .tolerance = 0.0032381245626975246, .status = PTC_OK, .axis = PTC_OK, .has_axis = 1U},
        {.t = 2.299998, .x = {0.75, -1.25, 0.5}, .u = -3.164052343744257e17, .tolerance = 3234.356856522139, .status = PTC_OK, .axis = PTC_OK, .has_axis = 1U},
        {.t = 2.29999998, .x = {-0.75, 1.25, -0.5}, .u = 3.164062377087657e23, .tolerance = 3234319159.5105147, .status = PTC_OK, .axis = PTC_OK, .has_axis = 1U},
        {.t = 2.2999999998, .x = {0.75, -1.25, 0.5}, .u = -3.1640538097793324e29, .tolerance = 3234309922438473.0, .status = PTC_OK, .axis = PTC_OK, .has_axis = 1U},
        {.t = 2.299999999998, .x = {-0.75, 1.25, -0.5}, .u = 3.164535991865176e35, .tolerance = 3.2348028063220934e21, .status = PTC_OK, .axis = PTC_OK, .has_axis = 1U},
        {.t = 1.1, .x = {1.0, 0.0, 0.0}, .u = -1.9531250000000004, .tolerance = 1.996493086899421e-14, .status = PTC_OK, .axis = PTC_OK, .has_axis = 1U},
        {.t = 1.1, .x = {0.0, 1.0, 0.0}, .u = -2.2569444444444446, .tolerance = 8.557058678194888e-14, .status = PTC_OK, .axis = PTC_OK, .has_axis = 1U},
        {.t = 1.1, .x = {0.0, 0.0, 1.0}, .u = -1.25, .tolerance = 6.277755575615631e-14, .status = PTC_OK, .axis = PTC_OK, .has_axis = 1U},
        {.t = 2.1999999999999997, .x = {1.0, 0.0, 0.0}, .u = -3374.999999999974, .tolerance = 3.449940054162172e-11, .status = PTC_OK, .axis = PTC_OK, .has_axis = 1U},
        {.t = 2.1999999999999997, .x = {0.0, 1.0, 0.0}, .u = -324.99999999999835, .tolerance = 1.2322164496600573e-11, .status = PTC_OK, .axis = PTC_OK, .has_axis = 1U},
        {.t = 2.1999999999999997, .x = {0.0, 0.0, 1.0}, .u = -14.999999999999961, .tolerance = 7.533306690738737e-13, .status = PTC_OK, .axis = PTC_OK, .has_axis = 1U},
        {.t = 1.7, .x = {0.0, 0.0, 1.0}, .u = -2.5, .tolerance = 1.255551115123126e-13, .status = PTC_OK, .axis = PTC_OK, .has_axis = 1U},
        {.t = (double)NAN, .x = {0.75, -1.25, 0.5}, .u = 0.0, .tolerance = 0.0, .status = PTC_E_INPUT, .axis = PTC_E_INPUT, .has_axis = 1U},
        {.t = (double)INFINITY, .x = {0.75, -1.25, 0.5}, .u = 0.0, .tolerance = 0.0, .status = PTC_E_INPUT, .axis = PTC_E_INPUT, .has_axis = 1U},
        {.t = -(double)INFINITY, .x = {0.75, -1.25, 0.5}, .u = 0.0, .tolerance = 0.0, .status = PTC_E_INPUT, .axis = PTC_E_INPUT, .has_axis = 1U},
        {.t = 1.3, .x = {(double)NAN, -1.25, 0.5}, .u = 0.0, .tolerance = 0.0, .status = PTC_E_INPUT, .axis = PTC_E_INPUT, .has_axis = 1U},
        {.t = 1.3, .x = {0.75, (double)NAN, 0.5}, .u = 0.0, .tolerance = 0.0, .status = PTC_E_INPUT, .axis = PTC_E_INPUT, .has_axis = 1U},
        {.t = 1.3, .x = {0.75, -1.25, (double)NAN}, .u = 0.0, .tolerance = 0.0, .status = PTC_E_INPUT, .axis = PTC_E_INPUT, .has_axis = 1U},
        {.t = 1.3, .x = {(double)INFINITY, -1.25, 0.5}, .u = 0.0, .tolerance = 0.0, .status = PTC_E_INPUT, .axis = PTC_E_INPUT, .has_axis = 1U},
        {.t = 1.3, .x = {0.75, (double)INFINITY, 0.5}, .u = 0.0, .tolerance = 0.0, .status = PTC_E_INPUT, .axis = PTC_E_INPUT, .has_axis = 1U},
        {.t = 1.3, .x = {0.75, -1.25, (double)INFINITY}, .u = 0.0, .tolerance = 0.0, .status = PTC_E_INPUT, .axis = PTC_E_INPUT, .has_axis = 1U},
        {.t = 1.3, .x = {-(double)INFINITY, -1.25, 0.5}, .u = 0.0, .tolerance = 0.0, .status = PTC_E_INPUT, .axis = PTC_E_INPUT, .has_axis = 1U},
        {.t = 1.3, .x = {0.75, -(double)INFINITY, 0.5}, .u = 0.0, .tolerance = 0.0, .status = PTC_E_INPUT, .axis = PTC_E_INPUT, .has_axis = 1U},
        {.t = 1.3, .x = {0.75, -1.25, -(double)INFINITY}, .u = 0.0, .tolerance = 0.0, .status = PTC_E_INPUT, .axis = PTC_E_INPUT, .has_axis = 1U},
        {.t = -0.7, .x = {0.75, -1.25, 0.5}, .u = 0.0, .tolerance = 0.0, .status = PTC_E_INPUT, .axis = PTC_E_INPUT, .has_axis = 1U},
        {.t = 2.05, .x = {0.75, -1.25, 0.5}, .u = -99.99999999999976, .tolerance = 4.242204460492497e-12, .status = PTC_OK, .axis = PTC_OK, .has_axis = 1U},
        {.t = 2.05, .x = {-0.75, 1.25, -0.5}, .u = 99.99999999999976, .tolerance = 4.242204460492497e-12, .status = PTC_OK, .axis = PTC_OK, .has_axis = 1U},
        {.t = 2.2375, .x = {0.75, -1.25, 0.5}, .u = -1042.0, .tolerance = 2.3291370478331885e-11, .status = PTC_HOLD, .axis = PTC_HOLD, .has_axis = 1U},
        {.t = 2.2375, .x = {-0.75, 1.25, -0.5}, .u = 1042.0, .tolerance = 2.3291370478331885e-11, .status = PTC_HOLD, .axis = PTC_HOLD, .has_axis = 1U},
        {.t = 2.3, .x = {0.75, -1.25, 0.5}, .u = -1042.0, .tolerance = 2.3291370478331885e-11, .status = PTC_HOLD, .axis = PTC_HOLD, .has_axis = 1U},
        {.t = 2.3, .x = {-0.75, 1.25, -0.5}, .u = 1042.0, .tolerance = 2.3291370478331885e-11, .status = PTC_HOLD, .axis = PTC_HOLD, .has_axis = 1U},
        {.t = 2.8, .x = {0.75, -1.25, 0.5}, .u = -1042.0, .tolerance = 2.3291370478331885e-11, .status = PTC_HOLD, .axis = PTC_HOLD, .has_axis = 1U},
        {.t = 2.8, .x = {-0.75, 1.25, -0.5}, .u = 1042.0, .tolerance = 2.3291370478331885e-11, .status = PTC_HOLD, .axis = PTC_HOLD, .has_axis = 1U},
        {.t = 22.3, .x = {0.75, -1.25, 0.5}, .u = -1042.0, .tolerance = 2.3291370478331885e-11, .status = PTC_HOLD, .axis = PTC_HOLD, .has_axis = 1U},
        {.t = 22.3, .x = {-0.75, 1.25, -0.5}, .u = 1042.0, .tolerance = 2.3291370478331885e-11, .status = PTC_HOLD, .axis = PTC_HOLD, .has_axis = 1U},
        {.t = 1000.1, .x = {-0.75, 1.25, -0.5}, .u = -0.32421875, .tolerance = 6.026730352425306e-14, .status = PTC_OK, .axis = PTC_OK, .has_axis = 1U},
        {.t = 1001.5, .x = {-0.75, 1.25, -0.5}, .u = 1.6840277777772534, .tolerance = 6.054086515047738e-13, .status = PTC_OK, .axis = PTC_OK, .has_axis = 1U},
        {.t = 1002.1, .x = {-0.75, 1.25, -0.5}, .u = 1042.0, .tolerance = 2.3291370478331885e-11, .status = PTC_HOLD, .axis = PTC_HOLD, .has_axis = 1U},
        {.t = 0.3, .x = {0.75, -1.25, 0.5}, .u = 0.0, .tolerance = 0.0, .status = PTC_E_INPUT, .axis = PTC_E_INPUT, .has_axis = 1U},
        {.t = 1.3, .x = {0.1875, -0.3125, 0.125}, .u = 0.1953125, .tolerance = 5.4027743086899435e-14, .status = PTC_OK, .axis = PTC_OK, .has_axis = 1U},
        {.t = 1.3, .x = {1.125, -1.875, 0.75}, .u = 0.78125, .tolerance = 0.0, .status = PTC_SATURATED, .axis = PTC_SATURATED, .has_axis = 1U},
        {.t = 1.3, .x = {-1.125, 1.875, -0.75}, .u = -0.78125, .tolerance = 0.0, .status = PTC_SATURATED, .axis = PTC_SATURATED, .has_axis = 1U},
        {.t = 2.3, .x = {0.00014058001439539347, -0.00023430002399232245, 9.372000959692898e-5}, .u = -0.1953125, .tolerance = 4.365734929509785e-15, .status = PTC_HOLD, .axis = PTC_HOLD, .has_axis = 1U},
        {.t = 2.3, .x = {0.0008434800863723608, -0.0014058001439539347, 0.0005623200575815739}, .u = -0.78125, .tolerance = 0.0, .status = PTC_SATURATED, .axis = PTC_SATURATED, .has_axis = 1U},
        {.t = 2.3, .x = {-0.0008434800863723608, 0.0014058001439539347, -0.0005623200575815739}, .u = 0.78125, .tolerance = 0.0, .status = PTC_SATURATED, .axis = PTC_SATURATED, .has_axis = 1U},
        {.t = 3.3, .x = {0.00014058001439539347, -0.00023430002399232245, 9.372000959692898e-5}, .u = -0.1953125, .tolerance = 4.365734929509785e-15, .status = PTC_HOLD, .axis = PTC_HOLD, .has_axis = 1U},
        {.t = 3.3, .x = {0.0008434800863723608, -0.0014058001439539347, 0.0005623200575815739}, .u = -0.78125, .tolerance = 0.0, .status = PTC_SATURATED, .axis = PTC_SATURATED, .has_axis = 1U},
        {.t = 3.3, .x = {-0.0008434800863723608, 0.0014058001439539347, -0.0005623200575815739}, .u = 0.78125, .tolerance = 0.0, .status = PTC_SATURATED, .axis = PTC_SATURATED, .has_axis = 1U},
        {.t = 1.3, .x = {0.75, -1.25, 0.5}, .u = 2.75, .tolerance = 2.811062266354384e-14, .status = PTC_OK, .axis = PTC_OK, .has_axis = 1U},
        {.t = 2.3, .x = {1.3482698511467367e308, -1.0, -1.0}, .u = 0.0, .tolerance = 0.0, .status = PTC_E_RANGE, .axis = PTC_E_RANGE, .has_axis = 1U},
        {.t = -5e149, .x = {1.3482698511467367e308, 0.0, 0.0}, .u = 0.0, .tolerance = 0.0, .status = PTC_E_RANGE, .axis = PTC_E_RANGE, .has_axis = 0U},
    };
    uint32_t failures = 0U;

    for (uint32_t i = 0U; i < 7U; i++) {
        const ptc_exp3_selftest_session *session = &ptc_exp3_selftest_sessions[i];
        ptc_exp3 self;
        ptc_status status = ptc_exp3_init(&self, &session->params);

        if ((status == PTC_OK) && (session->is_armed_again != 0U)) {
            status = ptc_exp3_arm(&self, session->t0);
        }
        if (status == PTC_OK) {
            for (uint32_t j = 0U; j < session->count; j++) {
                failures += ptc_exp3_selftest_check(&self, &calls[session->first + j]);
            }
        } else {
            failures++;
        }
    }
    return failures;
}

/* What init and arm must refuse without a change. */
static uint32_t ptc_exp3_selftest_refuse(void)
{
    static const ptc_exp3_params refused[31] = {
        {.tau = (double)NAN, .t0 = 0.3, .eps = 0.125, .u_max = (double)INFINITY, .k = {3.375, 6.75, 4.5}},
        {.tau = (double)INFINITY, .t0 = 0.3, .eps = (double)INFINITY, .u_max = (double)INFINITY, .k = {3.375, 6.75, 4.5}},
        {.tau = 0.0, .t0 = 0.3, .eps = 0.125, .u_max = (double)INFINITY, .k = {3.375, 6.75, 4.5}},
        {.tau = -1.0, .t0 = 0.3, .eps = 0.125, .u_max = (double)INFINITY, .k = {3.375, 6.75, 4.5}},
        {.tau = 7.5e-151, .t0 = 0.3, .eps = 4.6875e-152, .u_max = (double)INFINITY, .k = {3.375, 6.75, 4.5}},
        {.tau = 1.25e150, .t0 = 0.3, .eps = 7.8125e148, .u_max = (double)INFINITY, .k = {3.375, 6.75, 4.5}},
        {.tau = 2.0, .t0 = (double)NAN, .eps = 0.125, .u_max = (double)INFINITY, .k = {3.375, 6.75, 4.5}},
        {.tau = 2.0, .t0 = (double)INFINITY, .eps = 0.125, .u_max = (double)INFINITY, .k = {3.375, 6.75, 4.5}},
        {.tau = 2.0, .t0 = -(double)INFINITY, .eps = 0.125, .u_max = (double)INFINITY, .k = {3.375, 6.75, 4.5}},
        {.tau = 2.0, .t0 = 0.3, .eps = (double)NAN, .u_max = (double)INFINITY, .k = {3.375, 6.75, 4.5}},
        {.tau = 2.0, .t0 = 0.3, .eps = (double)INFINITY, .u_max = (double)INFINITY, .k = {3.375, 6.75, 4.5}},
        {.tau = 2.0, .t0 = 0.3, .eps = 0.0, .u_max = (double)INFINITY, .k = {3.375, 6.75, 4.5}},
        {.tau = 2.0, .t0 = 0.3, .eps = -1.0, .u_max = (double)INFINITY, .k = {3.375, 6.75, 4.5}},
        {.tau = 2.0, .t0 = 0.3, .eps = 7.5e-151, .u_max = (double)INFINITY, .k = {3.375, 6.75, 4.5}},
        {.tau = 2.0, .t0 = 0.3, .eps = 2.0, .u_max = (double)INFINITY, .k = {3.375, 6.75, 4.5}},
        {.tau = 2.0, .t0 = 0.3, .eps = 4.0, .u_max = (double)INFINITY, .k = {3.375, 6.75, 4.5}},
        {.tau = 2.0, .t0 = 0.3, .eps = 0.125, .u_max = (double)NAN, .k = {3.375, 6.75, 4.5}},
        {.tau = 2.0, .t0 = 0.3, .eps = 0.125, .u_max = 0.0, .k = {3.375, 6.75, 4.5}},
        {.tau = 2.0, .t0 = 0.3, .eps = 0.125, .u_max = -1.0, .k = {3.375, 6.75, 4.5}},
        {.tau = 2.0, .t0 = 0.3, .eps = 0.125, .u_max = -(double)INFINITY, .k = {3.375, 6.75, 4.5}},
        {.tau = 2.0, .t0 = 0.3, .eps = 0.125, .u_max = (double)INFINITY, .k = {(double)NAN, 6.75, 4.5}},
        {.tau = 2.0, .t0 = 0.3, .eps = 0.125, .u_max = (double)INFINITY, .k = {(double)INFINITY, 6.75, 4.5}},
        {.tau = 2.0, .t0 = 0.3, .eps = 0.125, .u_max = (double)INFINITY, .k = {-(double)INFINITY, 6.75, 4.5}},
        {.tau = 2.0, .t0 = 0.3, .eps = 0.125, .u_max = (double)INFINITY, .k = {3.375, (double)NAN, 4.5}},
        {.tau = 2.0, .t0 = 0.3, .eps = 0.125, .u_max = (double)INFINITY, .k = {3.375, (double)INFINITY, 4.5}},
        {.tau = 2.0, .t0 = 0.3, .eps = 0.125, .u_max = (double)INFINITY, .k = {3.375, -(double)INFINITY, 4.5}},
        {.tau = 2.0, .t0 = 0.3, .eps = 0.125, .u_max = (double)INFINITY, .k = {3.375, 6.75, (double)NAN}},
        {.tau = 2.0, .t0 = 0.3, .eps = 0.125, .u_max = (double)INFINITY, .k = {3.375, 6.75, (double)INFINITY}},
        {.tau = 2.0, .t0 = 0.3, .eps = 0.125, .u_max = (double)INFINITY, .k = {3.375, 6.75, -(double)INFINITY}},
        {.tau = 2.0, .t0 = 0.3, .eps = 0.125, .u_max = (double)INFINITY, .k = {1e-323, 6.75, 4.5}},
        {.tau = 3.0, .t0 = -3.0, .eps = 0.125, .u_max = (double)INFINITY, .k = {3.375, 1.7976931348623157e308, -1.7976931348623157e308}},
    };
    static const double starts[3] = {(double)NAN, (double)INFINITY, -(double)INFINITY};
    const ptc_exp3_selftest_session *session = &ptc_exp3_selftest_sessions[0];
    const ptc_exp3_selftest_call call = {.t = 0.3, .x = {0.75, -1.25, 0.5}, .u = 0.32421875, .tolerance = 6.026730352425306e-14, .status = PTC_OK, .axis = PTC_OK, .has_axis = 1U};
    uint32_t failures = 0U;
    ptc_exp3 self;

    if (ptc_exp3_init(&self, &session->params) != PTC_OK) {
        failures++;
    }
    for (uint32_t i = 0U; i < 31U; i++) {
        if (ptc_exp3_init(&self, &refused[i]) != PTC_E_PARAM) {
            failures++;
        }
    }
    for (uint32_t i = 0U; i < 3U; i++) {
        if (ptc_exp3_arm(&self, starts[i]) != PTC_E_PARAM) {
            failures++;
        }
    }
    failures += ptc_exp3_selftest_check(&self, &call);
    if (ptc_exp3_init(&self, NULL) != PTC_E_PARAM) {
        failures++;
    }
    if (ptc_exp3_init(NULL, &session->params) != PTC_E_PARAM) {
        failures++;
    }
    if (ptc_exp3_arm(NULL, session->t0) != PTC_E_PARAM) {
        failures++;
    }
    /* A deadline beyond the range, which no legal parameters need to reach. */
    self.tau = 1.7976931348623157e308;
    if (ptc_exp3_arm(&self, 1.7976931348623157e308) != PTC_E_PARAM) {
        failures++;
    }
    return failures;
}

/* 1 where a call without one of its pointers was not refused with u = 0. */
static uint32_t ptc_exp3_selftest_refused(ptc_status status, double u)
{
    uint32_t failures = 1U;

    if ((status == PTC_E_INPUT) && (fabs(u) <= 0.0)) {
        failures = 0U;
    }
    return failures;
}

/* Calls that lack a pointer. */
static uint32_t ptc_exp3_selftest_pointers(void)
{
    const ptc_exp3_selftest_session *session = &ptc_exp3_selftest_sessions[0];
    const ptc_exp3_selftest_call call = {.t = 0.3, .x = {0.75, -1.25, 0.5}, .u = 0.32421875, .tolerance = 6.026730352425306e-14, .status = PTC_OK, .axis = PTC_OK, .has_axis = 1U};
    uint32_t failures = 0U;
    double u = 12345.0;
    ptc_status status;
    ptc_exp3_gains gains;
    ptc_exp3 self;

    if (ptc_exp3_init(&self, &session->params) != PTC_OK) {
        failures++;
    }
    status = ptc_exp3_step(NULL, call.t, call.x, &u);
    failures += ptc_exp3_selftest_refused(status, u);
    u = 12345.0;
    status = ptc_exp3_step(&self, call.t, NULL, &u);
    failures += ptc_exp3_selftest_refused(status, u);
    status = ptc_exp3_step(&self, call.t, call.x, NULL);
    failures += ptc_exp3_selftest_refused(status, 0.0);
    status = ptc_exp3_tick(NULL, call.t, &gains);
    failures += ptc_exp3_selftest_refused(status, 0.0);
    status = ptc_exp3_tick(&self, call.t, NULL);
    failures += ptc_exp3_selftest_refused(status, 0.0);
    if (ptc_exp3_tick(&self, call.t, &gains) < PTC_OK) {
        failures++;
    }
    u = 12345.0;
    status = ptc_exp3_axis(NULL, call.x, &u);
    failures += ptc_exp3_selftest_refused(status, u);
    u = 12345.0;
    status = ptc_exp3_axis(&gains, NULL, &u);
    failures += ptc_exp3_selftest_refused(status, u);
    status = ptc_exp3_axis(&gains, call.x, NULL);
    failures += ptc_exp3_selftest_refused(status, 0.0);
    return failures;
}

uint32_t ptc_exp3_selftest(void)
{
    uint32_t failures = ptc_exp3_selftest_run();

    failures += ptc_exp3_selftest_refuse();
    failures += ptc_exp3_selftest_pointers();
    return failures;
}
