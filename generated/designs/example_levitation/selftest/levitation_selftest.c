/* Self-test of the prescribed-time controller levitation: see levitation_selftest.h. DO NOT EDIT. */
#include "levitation_selftest.h"
#include "levitation.h"

#include <math.h>
#include <stddef.h>

/* A call, and what it must give. */
typedef struct levitation_selftest_call {
    double t;
    double x[3];
    double u;
    double tolerance;
    ptc_status status;
} levitation_selftest_call;

/* A set of parameters that init takes, and the calls with it. */
typedef struct levitation_selftest_session {
    levitation_params params;
    double t0; /* of arm, where it is called */
    uint32_t is_armed_again;
    uint32_t first; /* of its calls */
    uint32_t count;
} levitation_selftest_session;

static const levitation_selftest_session levitation_selftest_sessions[6] = {
    {.params = {.tau = 2.0, .t0 = 0.3, .u_max = (double)INFINITY, .L = 1.5, .R = 1.625, .i0 = 1.875, .z0 = 0.02}, .t0 = 0.0, .is_armed_again = 0U, .first = 0U, .count = 25U},
    {.params = {.tau = 2.0, .t0 = 0.3, .u_max = (double)INFINITY, .L = 1.5, .R = 1.625, .i0 = 1.875, .z0 = 0.02}, .t0 = 0.0, .is_armed_again = 0U, .first = 25U, .count = 10U},
    {.params = {.tau = 2.0, .t0 = 0.3, .u_max = (double)INFINITY, .L = 1.5, .R = 1.625, .i0 = 1.875, .z0 = 0.02}, .t0 = 1000.1, .is_armed_again = 1U, .first = 35U, .count = 4U},
    {.params = {.tau = 2.0, .t0 = 0.3, .u_max = 22236.927548881587, .L = 1.5, .R = 1.625, .i0 = 1.875, .z0 = 0.02}, .t0 = 0.0, .is_armed_again = 0U, .first = 39U, .count = 9U},
    {.params = {.tau = 2.0, .t0 = 0.3, .u_max = (double)INFINITY, .L = 1.5, .R = 1.625, .i0 = 1.875, .z0 = 0.02}, .t0 = 0.0, .is_armed_again = 0U, .first = 48U, .count = 1U},
    {.params = {.tau = 2.0, .t0 = 0.3, .u_max = 1.0, .L = 1.5, .R = 1.625, .i0 = 1.875, .z0 = 0.02}, .t0 = 0.0, .is_armed_again = 0U, .first = 49U, .count = 1U},
};

/* 1 where what was returned is not what must be. */
static uint32_t levitation_selftest_differs(const levitation_selftest_call *call, ptc_status wanted, ptc_status status, double u)
{
    uint32_t failures = 1U;

    if ((status == wanted) && (fabs(u - call->u) <= call->tolerance)) {
        failures = 0U;
    }
    return failures;
}

/* The failures of one call. */
static uint32_t levitation_selftest_check(const levitation *self, const levitation_selftest_call *call)
{
    double u = 12345.0;
    ptc_status status = levitation_step(self, call->t, call->x, &u);
    uint32_t failures = levitation_selftest_differs(call, call->status, status, u);
    return failures;
}

/* Every session with its calls. */
static uint32_t levitation_selftest_run(void)
{
    static const levitation_selftest_call calls[50] = {
        {.t = 0.3, .x = {0.75, -1.25, 0.5}, .u = 8599.7856488333, .tolerance = 7.330218354507935e-10, .status = PTC_OK},
        {.t = 0.8, .x = {-0.75, 1.25, -0.5}, .u = 22161.47926853999, .tolerance = 2.027310450652498e-9, .status = PTC_OK},
        {.t = 1.5, .x = {0.75, -1.25, 0.5}, .u = 34481.03908589948, .tolerance = 3.0384429792097432e-9, .status = PTC_OK},
        {.t = 2.1, .x = {-0.75, 1.25, -0.5}, .u = -2288238.928206443, .tolerance = 1.9587843730465679e-7, .status = PTC_OK},
        {.t = 2.28, .x = {0.75, -1.25, 0.5}, .u = 1856678423.1066377, .tolerance = 0.00013117107723749789, .status = PTC_OK},
        {.t = 1.1, .x = {1.0, 0.0, 0.0}, .u = 62454.84518348624, .tolerance = 4.5695741117684595e-9, .status = PTC_OK},
        {.t = 1.1, .x = {0.0, 1.0, 0.0}, .u = 146.59785932721712, .tolerance = 1.8410203213298455e-11, .status = PTC_OK},
        {.t = 1.1, .x = {0.0, 0.0, 1.0}, .u = -10.766304347826088, .tolerance = 2.17718679544759e-12, .status = PTC_OK},
        {.t = 2.1999999999999997, .x = {1.0, 0.0, 0.0}, .u = 45180722.47706387, .tolerance = 3.1748891153171184e-6, .status = PTC_OK},
        {.t = 2.1999999999999997, .x = {0.0, 1.0, 0.0}, .u = 1000.7167431192617, .tolerance = 9.426033448781237e-11, .status = PTC_OK},
        {.t = 2.1999999999999997, .x = {0.0, 0.0, 1.0}, .u = -147.07065217391266, .tolerance = 2.613021059268405e-11, .status = PTC_OK},
        {.t = 1.7, .x = {0.0, 0.0, 1.0}, .u = -23.157608695652172, .tolerance = 4.354734413378183e-12, .status = PTC_OK},
        {.t = (double)NAN, .x = {0.75, -1.25, 0.5}, .u = 0.0, .tolerance = 0.0, .status = PTC_E_INPUT},
        {.t = (double)INFINITY, .x = {0.75, -1.25, 0.5}, .u = 0.0, .tolerance = 0.0, .status = PTC_E_INPUT},
        {.t = -(double)INFINITY, .x = {0.75, -1.25, 0.5}, .u = 0.0, .tolerance = 0.0, .status = PTC_E_INPUT},
        {.t = 1.3, .x = {(double)NAN, -1.25, 0.5}, .u = 0.0, .tolerance = 0.0, .status = PTC_E_INPUT},
        {.t = 1.3, .x = {0.75, (double)NAN, 0.5}, .u = 0.0, .tolerance = 0.0, .status = PTC_E_INPUT},
        {.t = 1.3, .x = {0.75, -1.25, (double)NAN}, .u = 0.0, .tolerance = 0.0, .status = PTC_E_INPUT},
        {.t = 1.3, .x = {(double)INFINITY, -1.25, 0.5}, .u = 0.0, .tolerance = 0.0, .status = PTC_E_INPUT},
        {.t = 1.3, .x = {0.75, (double)INFINITY, 0.5}, .u = 0.0, .tolerance = 0.0, .status = PTC_E_INPUT},
        {.t = 1.3, .x = {0.75, -1.25, (double)INFINITY}, .u = 0.0, .tolerance = 0.0, .status = PTC_E_INPUT},
        {.t = 1.3, .x = {-(double)INFINITY, -1.25, 0.5}, .u = 0.0, .tolerance = 0.0, .status = PTC_E_INPUT},
        {.t = 1.3, .x = {0.75, -(double)INFINITY, 0.5}, .u = 0.0, .tolerance = 0.0, .status = PTC_E_INPUT},
        {.t = 1.3, .x = {0.75, -1.25, -(double)INFINITY}, .u = 0.0, .tolerance = 0.0, .status = PTC_E_INPUT},
        {.t = -0.7, .x = {0.75, -1.25, 0.5}, .u = 0.0, .tolerance = 0.0, .status = PTC_E_INPUT},
        {.t = 2.298, .x = {0.75, -1.25, 0.5}, .u = 1884009173925.8079, .tolerance = 0.1323776573867129, .status = PTC_OK},
        {.t = 2.298, .x = {-0.75, 1.25, -0.5}, .u = -2924850349498.6763, .tolerance = 0.2299883825858729, .status = PTC_OK},
        {.t = 2.2995, .x = {0.75, -1.25, 0.5}, .u = 15084595178003.25, .tolerance = 1.0595857397610144, .status = PTC_HOLD},
        {.t = 2.2995, .x = {-0.75, 1.25, -0.5}, .u = -23418426386740.137, .tolerance = 1.8409586982536108, .status = PTC_HOLD},
        {.t = 2.3, .x = {0.75, -1.25, 0.5}, .u = 15084595178003.25, .tolerance = 1.0595857397610144, .status = PTC_HOLD},
        {.t = 2.3, .x = {-0.75, 1.25, -0.5}, .u = -23418426386740.137, .tolerance = 1.8409586982536108, .status = PTC_HOLD},
        {.t = 2.8, .x = {0.75, -1.25, 0.5}, .u = 15084595178003.25, .tolerance = 1.0595857397610144, .status = PTC_HOLD},
        {.t = 2.8, .x = {-0.75, 1.25, -0.5}, .u = -23418426386740.137, .tolerance = 1.8409586982536108, .status = PTC_HOLD},
        {.t = 22.3, .x = {0.75, -1.25, 0.5}, .u = 15084595178003.25, .tolerance = 1.0595857397610144, .status = PTC_HOLD},
        {.t = 22.3, .x = {-0.75, 1.25, -0.5}, .u = -23418426386740.137, .tolerance = 1.8409586982536108, .status = PTC_HOLD},
        {.t = 1000.1, .x = {-0.75, 1.25, -0.5}, .u = 17271.078648231403, .tolerance = 1.5179445296589865e-9, .status = PTC_OK},
        {.t = 1001.5, .x = {-0.75, 1.25, -0.5}, .u = -3184.757282746459, .tolerance = 2.8858248820293463e-9, .status = PTC_OK},
        {.t = 1002.1, .x = {-0.75, 1.25, -0.5}, .u = -23418426386740.137, .tolerance = 1.8409586982536108, .status = PTC_HOLD},
        {.t = 0.3, .x = {0.75, -1.25, 0.5}, .u = 0.0, .tolerance = 0.0, .status = PTC_E_INPUT},
        {.t = 1.3, .x = {0.1875, -0.3125, 0.125}, .u = 1734.8399478983613, .tolerance = 1.386895423889678e-10, .status = PTC_OK},
        {.t = 1.3, .x = {1.125, -1.875, 0.75}, .u = 22236.927548881587, .tolerance = 0.0, .status = PTC_SATURATED},
        {.t = 1.3, .x = {-3.0, 5.0, -2.0}, .u = -22236.927548881587, .tolerance = 0.0, .status = PTC_SATURATED},
        {.t = 2.3, .x = {2.764027715835066e-10, -4.6067128597251103e-10, 1.8426851438900441e-10}, .u = 4.751135815799052, .tolerance = 1.2659587359705476e-9, .status = PTC_HOLD},
        {.t = 2.3, .x = {1.1056110863340264e-5, -1.8426851438900443e-5, 7.370740575560177e-6}, .u = 22236.927548881587, .tolerance = 0.0, .status = PTC_SATURATED},
        {.t = 2.3, .x = {-1.1056110863340264e-5, 1.8426851438900443e-5, -7.370740575560177e-6}, .u = -22236.927548881587, .tolerance = 0.0, .status = PTC_SATURATED},
        {.t = 3.3, .x = {2.764027715835066e-10, -4.6067128597251103e-10, 1.8426851438900441e-10}, .u = 4.751135815799052, .tolerance = 1.2659587359705476e-9, .status = PTC_HOLD},
        {.t = 3.3, .x = {1.1056110863340264e-5, -1.8426851438900443e-5, 7.370740575560177e-6}, .u = 22236.927548881587, .tolerance = 0.0, .status = PTC_SATURATED},
        {.t = 3.3, .x = {-1.1056110863340264e-5, 1.8426851438900443e-5, -7.370740575560177e-6}, .u = -22236.927548881587, .tolerance = 0.0, .status = PTC_SATURATED},
        {.t = 1.3, .x = {0.75, -1.25, 0.5}, .u = 22236.927548881587, .tolerance = 1.9766587177196684e-9, .status = PTC_OK},
        {.t = 2.3, .x = {1.3482698511467367e308, -1.0, -1.0}, .u = 0.0, .tolerance = 0.0, .status = PTC_E_RANGE},
    };
    uint32_t failures = 0U;

    for (uint32_t i = 0U; i < 6U; i++) {
        const levitation_selftest_session *session = &levitation_selftest_sessions[i];
        levitation self;
        ptc_status status = levitation_init(&self, &session->params);

        if ((status == PTC_OK) && (session->is_armed_again != 0U)) {
            status = levitation_arm(&self, session->t0);
        }
        if (status == PTC_OK) {
            for (uint32_t j = 0U; j < session->count; j++) {
                failures += levitation_selftest_check(&self, &calls[session->first + j]);
            }
        } else {
            failures++;
        }
    }
    return failures;
}

/* What init and arm must refuse without a change. */
static uint32_t levitation_selftest_refuse(void)
{
    static const levitation_params refused[33] = {
        {.tau = (double)NAN, .t0 = 0.3, .u_max = (double)INFINITY, .L = 1.5, .R = 1.625, .i0 = 1.875, .z0 = 0.02},
        {.tau = (double)INFINITY, .t0 = 0.3, .u_max = (double)INFINITY, .L = 1.5, .R = 1.625, .i0 = 1.875, .z0 = 0.02},
        {.tau = 0.0, .t0 = 0.3, .u_max = (double)INFINITY, .L = 1.5, .R = 1.625, .i0 = 1.875, .z0 = 0.02},
        {.tau = -1.0, .t0 = 0.3, .u_max = (double)INFINITY, .L = 1.5, .R = 1.625, .i0 = 1.875, .z0 = 0.02},
        {.tau = 7.5e-151, .t0 = 0.3, .u_max = (double)INFINITY, .L = 1.5, .R = 1.625, .i0 = 1.875, .z0 = 0.02},
        {.tau = 1.25e150, .t0 = 0.3, .u_max = (double)INFINITY, .L = 1.5, .R = 1.625, .i0 = 1.875, .z0 = 0.02},
        {.tau = 2.0, .t0 = (double)NAN, .u_max = (double)INFINITY, .L = 1.5, .R = 1.625, .i0 = 1.875, .z0 = 0.02},
        {.tau = 2.0, .t0 = (double)INFINITY, .u_max = (double)INFINITY, .L = 1.5, .R = 1.625, .i0 = 1.875, .z0 = 0.02},
        {.tau = 2.0, .t0 = -(double)INFINITY, .u_max = (double)INFINITY, .L = 1.5, .R = 1.625, .i0 = 1.875, .z0 = 0.02},
        {.tau = 2.0, .t0 = 0.3, .u_max = (double)NAN, .L = 1.5, .R = 1.625, .i0 = 1.875, .z0 = 0.02},
        {.tau = 2.0, .t0 = 0.3, .u_max = 0.0, .L = 1.5, .R = 1.625, .i0 = 1.875, .z0 = 0.02},
        {.tau = 2.0, .t0 = 0.3, .u_max = -1.0, .L = 1.5, .R = 1.625, .i0 = 1.875, .z0 = 0.02},
        {.tau = 2.0, .t0 = 0.3, .u_max = -(double)INFINITY, .L = 1.5, .R = 1.625, .i0 = 1.875, .z0 = 0.02},
        {.tau = 2.0, .t0 = 0.3, .u_max = (double)INFINITY, .L = (double)NAN, .R = 1.625, .i0 = 1.875, .z0 = 0.02},
        {.tau = 2.0, .t0 = 0.3, .u_max = (double)INFINITY, .L = (double)INFINITY, .R = 1.625, .i0 = 1.875, .z0 = 0.02},
        {.tau = 2.0, .t0 = 0.3, .u_max = (double)INFINITY, .L = -(double)INFINITY, .R = 1.625, .i0 = 1.875, .z0 = 0.02},
        {.tau = 2.0, .t0 = 0.3, .u_max = (double)INFINITY, .L = 1.5, .R = (double)NAN, .i0 = 1.875, .z0 = 0.02},
        {.tau = 2.0, .t0 = 0.3, .u_max = (double)INFINITY, .L = 1.5, .R = (double)INFINITY, .i0 = 1.875, .z0 = 0.02},
        {.tau = 2.0, .t0 = 0.3, .u_max = (double)INFINITY, .L = 1.5, .R = -(double)INFINITY, .i0 = 1.875, .z0 = 0.02},
        {.tau = 2.0, .t0 = 0.3, .u_max = (double)INFINITY, .L = 1.5, .R = 1.625, .i0 = (double)NAN, .z0 = 0.02},
        {.tau = 2.0, .t0 = 0.3, .u_max = (double)INFINITY, .L = 1.5, .R = 1.625, .i0 = (double)INFINITY, .z0 = 0.02},
        {.tau = 2.0, .t0 = 0.3, .u_max = (double)INFINITY, .L = 1.5, .R = 1.625, .i0 = -(double)INFINITY, .z0 = 0.02},
        {.tau = 2.0, .t0 = 0.3, .u_max = (double)INFINITY, .L = 1.5, .R = 1.625, .i0 = -0.45000000000000007, .z0 = 0.02},
        {.tau = 2.0, .t0 = 0.3, .u_max = (double)INFINITY, .L = 1.5, .R = 1.625, .i0 = 8.0, .z0 = 0.02},
        {.tau = 2.0, .t0 = 0.3, .u_max = (double)INFINITY, .L = 1.5, .R = 1.625, .i0 = 1.875, .z0 = (double)NAN},
        {.tau = 2.0, .t0 = 0.3, .u_max = (double)INFINITY, .L = 1.5, .R = 1.625, .i0 = 1.875, .z0 = (double)INFINITY},
        {.tau = 2.0, .t0 = 0.3, .u_max = (double)INFINITY, .L = 1.5, .R = 1.625, .i0 = 1.875, .z0 = -(double)INFINITY},
        {.tau = 2.0, .t0 = 0.3, .u_max = (double)INFINITY, .L = 1.5, .R = 1.625, .i0 = 1.875, .z0 = -0.49749999999999994},
        {.tau = 2.0, .t0 = 0.3, .u_max = (double)INFINITY, .L = 1.5, .R = 1.625, .i0 = 1.875, .z0 = 0.53},
        {.tau = 2.0, .t0 = 0.3, .u_max = (double)INFINITY, .L = 1e-323, .R = 1.625, .i0 = 1.875, .z0 = 0.02},
        {.tau = 2.0, .t0 = 0.3, .u_max = (double)INFINITY, .L = 6.618310616387792e-201, .R = -2.968064290019527e-258, .i0 = 5.0, .z0 = 0.02},
        {.tau = 2.0, .t0 = 0.3, .u_max = (double)INFINITY, .L = 1.5, .R = 1e-323, .i0 = 1.875, .z0 = 0.02},
        {.tau = 2.0, .t0 = 0.3, .u_max = (double)INFINITY, .L = 1.7976931348623157e308, .R = 1.625, .i0 = 1.875, .z0 = 0.02},
    };
    static const double starts[3] = {(double)NAN, (double)INFINITY, -(double)INFINITY};
    const levitation_selftest_session *session = &levitation_selftest_sessions[0];
    const levitation_selftest_call call = {.t = 0.3, .x = {0.75, -1.25, 0.5}, .u = 8599.7856488333, .tolerance = 7.330218354507935e-10, .status = PTC_OK};
    uint32_t failures = 0U;
    levitation self;

    if (levitation_init(&self, &session->params) != PTC_OK) {
        failures++;
    }
    for (uint32_t i = 0U; i < 33U; i++) {
        if (levitation_init(&self, &refused[i]) != PTC_E_PARAM) {
            failures++;
        }
    }
    for (uint32_t i = 0U; i < 3U; i++) {
        if (levitation_arm(&self, starts[i]) != PTC_E_PARAM) {
            failures++;
        }
    }
    failures += levitation_selftest_check(&self, &call);
    if (levitation_init(&self, NULL) != PTC_E_PARAM) {
        failures++;
    }
    if (levitation_init(NULL, &session->params) != PTC_E_PARAM) {
        failures++;
    }
    if (levitation_arm(NULL, session->t0) != PTC_E_PARAM) {
        failures++;
    }
    /* A deadline beyond the range, which no legal parameters need to reach. */
    self.tau = 1.7976931348623157e308;
    if (levitation_arm(&self, 1.7976931348623157e308) != PTC_E_PARAM) {
        failures++;
    }
    return failures;
}

/* 1 where a call without one of its pointers was not refused with u = 0. */
static uint32_t levitation_selftest_refused(ptc_status status, double u)
{
    uint32_t failures = 1U;

    if ((status == PTC_E_INPUT) && (fabs(u) <= 0.0)) {
        failures = 0U;
    }
    return failures;
}

/* Calls that lack a pointer. */
static uint32_t levitation_selftest_pointers(void)
{
    const levitation_selftest_session *session = &levitation_selftest_sessions[0];
    const levitation_selftest_call call = {.t = 0.3, .x = {0.75, -1.25, 0.5}, .u = 8599.7856488333, .tolerance = 7.330218354507935e-10, .status = PTC_OK};
    uint32_t failures = 0U;
    double u = 12345.0;
    ptc_status status;
    levitation self;

    if (levitation_init(&self, &session->params) != PTC_OK) {
        failures++;
    }
    status = levitation_step(NULL, call.t, call.x, &u);
    failures += levitation_selftest_refused(status, u);
    u = 12345.0;
    status = levitation_step(&self, call.t, NULL, &u);
    failures += levitation_selftest_refused(status, u);
    status = levitation_step(&self, call.t, call.x, NULL);
    failures += levitation_selftest_refused(status, 0.0);
    return failures;
}

uint32_t levitation_selftest(void)
{
    uint32_t failures = levitation_selftest_run();

    failures += levitation_selftest_refuse();
    failures += levitation_selftest_pointers();
    return failures;
}
