/* Self-test of the prescribed-time controller stage: see stage_selftest.h. DO NOT EDIT. */
#include "stage_selftest.h"
#include "stage.h"

#include <math.h>
#include <stddef.h>

/* A call, and what it must give. */
typedef struct stage_selftest_call {
    double t;
    double x[3];
    double u;
    double tolerance;
    ptc_status status;
    ptc_status axis; /* of tick and axis */
    uint32_t has_axis;
} stage_selftest_call;

/* A set of parameters that init takes, and the calls with it. */
typedef struct stage_selftest_session {
    stage_params params;
    double t0; /* of arm, where it is called */
    uint32_t is_armed_again;
    uint32_t first; /* of its calls */
    uint32_t count;
} stage_selftest_session;

static const stage_selftest_session stage_selftest_sessions[6] = {
    {.params = {.tau = 2.0, .t0 = 0.3, .eps = 2e-13, .u_max = (double)INFINITY}, .t0 = 0.0, .is_armed_again = 0U, .first = 0U, .count = 30U},
    {.params = {.tau = 2.0, .t0 = 0.3, .eps = 0.125, .u_max = (double)INFINITY}, .t0 = 0.0, .is_armed_again = 0U, .first = 30U, .count = 10U},
    {.params = {.tau = 2.0, .t0 = 0.3, .eps = 0.125, .u_max = (double)INFINITY}, .t0 = 1000.1, .is_armed_again = 1U, .first = 40U, .count = 4U},
    {.params = {.tau = 2.0, .t0 = 0.3, .eps = 0.125, .u_max = 21.000000000000007}, .t0 = 0.0, .is_armed_again = 0U, .first = 44U, .count = 9U},
    {.params = {.tau = 2.0, .t0 = 0.3, .eps = 0.0002, .u_max = 1.0}, .t0 = 0.0, .is_armed_again = 0U, .first = 53U, .count = 1U},
    {.params = {.tau = 1e150, .t0 = -1e150, .eps = 1e-150, .u_max = (double)INFINITY}, .t0 = 0.0, .is_armed_again = 0U, .first = 54U, .count = 1U},
};

/* 1 where what was returned is not what must be. */
static uint32_t stage_selftest_differs(const stage_selftest_call *call, ptc_status wanted, ptc_status status, double u)
{
    uint32_t failures = 1U;

    if ((status == wanted) && (fabs(u - call->u) <= call->tolerance)) {
        failures = 0U;
    }
    return failures;
}

/* The failures of one call. */
static uint32_t stage_selftest_check(const stage *self, const stage_selftest_call *call)
{
    double u = 12345.0;
    ptc_status status = stage_step(self, call->t, call->x, &u);
    uint32_t failures = stage_selftest_differs(call, call->status, status, u);

    if (call->has_axis != 0U) {
        stage_gains gains;

        u = 0.0;
        status = stage_tick(self, call->t, &gains);
        if (status >= PTC_OK) {
            u = 12345.0;
            status = stage_axis(&gains, call->x, &u);
        }
        failures += stage_selftest_differs(call, call->axis, status, u);
    }
    return failures;
}

/* Every session with its calls. */
static uint32_t stage_selftest_run(void)
{
    static const stage_selftest_call calls[55] = {
        {.t = 0.3, .x = {0.75, -1.25, 0.5}, .u = 4.5, .tolerance = 4.397492007221627e-13, .status = PTC_OK, .axis = PTC_OK, .has_axis = 1U},
        {.t = 0.8, .x = {-0.75, 1.25, -0.5}, .u = -2.666666666666666, .tolerance = 8.272587856131335e-13, .status = PTC_OK, .axis = PTC_OK, .has_axis = 1U},
        {.t = 1.5, .x = {0.75, -1.25, 0.5}, .u = -66.09375, .tolerance = 3.642800760606764e-12, .status = PTC_OK, .axis = PTC_OK, .has_axis = 1U},
        {.t = 2.1, .x = {-0.75, 1.25, -0.5}, .u = 9405.000000000015, .tolerance = 1.4316332950932015e-10, .status = PTC_OK, .axis = PTC_OK, .has_axis = 1U},
        {.t = 2.28, .x = {0.75, -1.25, 0.5}, .u = -11062799.999999693, .tolerance = 1.1777343505536142e-7, .status = PTC_OK, .axis = PTC_OK, .has_axis = 1U},
        {.t = 2.2998, .x = {-0.75, 1.25, -0.5}, .u = 11248125029975.617, .tolerance = 0.11502571092818442, .status = PTC_OK, .axis = PTC_OK, .has_axis = 1U},
        {.t = 2.299998, .x = {0.75, -1.25, 0.5}, .u = -1.1249981249969246e19, .tolerance = 114998.27889177093, .status = PTC_OK, .axis = PTC_OK, .has_axis = 1U},
        {.t = 2.29999998, .x = {-0.75, 1.25, -0.5}, .u = 1.1249999736589444e25, .tolerance = 114998003800.31213, .status = PTC_OK, .axis = PTC_OK, .has_axis = 1U},
        {.t = 2.2999999998, .x = {0.75, -1.25, 0.5}, .u = -1.1249969103173734e31, .tolerance = 1.1499768602354531e17, .status = PTC_OK, .axis = PTC_OK, .has_axis = 1U},
        {.t = 2.299999999998, .x = {-0.75, 1.25, -0.5}, .u = 1.1251683526649099e37, .tolerance = 1.150152108903761e23, .status = PTC_OK, .axis = PTC_OK, .has_axis = 1U},
        {.t = 1.1, .x = {1.0, 0.0, 0.0}, .u = -69.44444444444446, .tolerance = 7.098642086753496e-13, .status = PTC_OK, .axis = PTC_OK, .has_axis = 1U},
        {.t = 1.1, .x = {0.0, 1.0, 0.0}, .u = -41.66666666666667, .tolerance = 6.342518585385431e-13, .status = PTC_OK, .axis = PTC_OK, .has_axis = 1U},
        {.t = 1.1, .x = {0.0, 0.0, 1.0}, .u = -10.0, .tolerance = 1.5222044604925036e-13, .status = PTC_OK, .axis = PTC_OK, .has_axis = 1U},
        {.t = 2.1999999999999997, .x = {1.0, 0.0, 0.0}, .u = -119999.99999999908, .tolerance = 1.2266453525909947e-9, .status = PTC_OK, .axis = PTC_OK, .has_axis = 1U},
        {.t = 2.1999999999999997, .x = {0.0, 1.0, 0.0}, .u = -5999.999999999969, .tolerance = 9.133226762954973e-11, .status = PTC_OK, .axis = PTC_OK, .has_axis = 1U},
        {.t = 2.1999999999999997, .x = {0.0, 0.0, 1.0}, .u = -119.99999999999969, .tolerance = 1.8266453525909993e-12, .status = PTC_OK, .axis = PTC_OK, .has_axis = 1U},
        {.t = 1.7, .x = {0.0, 0.0, 1.0}, .u = -20.0, .tolerance = 3.0444089209850066e-13, .status = PTC_OK, .axis = PTC_OK, .has_axis = 1U},
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
        {.t = 2.05, .x = {0.75, -1.25, 0.5}, .u = -4583.99999999999, .tolerance = 7.697785246897622e-11, .status = PTC_OK, .axis = PTC_OK, .has_axis = 1U},
        {.t = 2.05, .x = {-0.75, 1.25, -0.5}, .u = 4583.99999999999, .tolerance = 7.697785246897622e-11, .status = PTC_OK, .axis = PTC_OK, .has_axis = 1U},
        {.t = 2.2375, .x = {0.75, -1.25, 0.5}, .u = -41328.0, .tolerance = 5.426966594323418e-10, .status = PTC_HOLD, .axis = PTC_HOLD, .has_axis = 1U},
        {.t = 2.2375, .x = {-0.75, 1.25, -0.5}, .u = 41328.0, .tolerance = 5.426966594323418e-10, .status = PTC_HOLD, .axis = PTC_HOLD, .has_axis = 1U},
        {.t = 2.3, .x = {0.75, -1.25, 0.5}, .u = -41328.0, .tolerance = 5.426966594323418e-10, .status = PTC_HOLD, .axis = PTC_HOLD, .has_axis = 1U},
        {.t = 2.3, .x = {-0.75, 1.25, -0.5}, .u = 41328.0, .tolerance = 5.426966594323418e-10, .status = PTC_HOLD, .axis = PTC_HOLD, .has_axis = 1U},
        {.t = 2.8, .x = {0.75, -1.25, 0.5}, .u = -41328.0, .tolerance = 5.426966594323418e-10, .status = PTC_HOLD, .axis = PTC_HOLD, .has_axis = 1U},
        {.t = 2.8, .x = {-0.75, 1.25, -0.5}, .u = 41328.0, .tolerance = 5.426966594323418e-10, .status = PTC_HOLD, .axis = PTC_HOLD, .has_axis = 1U},
        {.t = 22.3, .x = {0.75, -1.25, 0.5}, .u = -41328.0, .tolerance = 5.426966594323418e-10, .status = PTC_HOLD, .axis = PTC_HOLD, .has_axis = 1U},
        {.t = 22.3, .x = {-0.75, 1.25, -0.5}, .u = 41328.0, .tolerance = 5.426966594323418e-10, .status = PTC_HOLD, .axis = PTC_HOLD, .has_axis = 1U},
        {.t = 1000.1, .x = {-0.75, 1.25, -0.5}, .u = -4.5, .tolerance = 4.397492007221627e-13, .status = PTC_OK, .axis = PTC_OK, .has_axis = 1U},
        {.t = 1001.5, .x = {-0.75, 1.25, -0.5}, .u = 218.33333333330137, .tolerance = 7.49014640540791e-12, .status = PTC_OK, .axis = PTC_OK, .has_axis = 1U},
        {.t = 1002.1, .x = {-0.75, 1.25, -0.5}, .u = 41328.0, .tolerance = 5.426966594323418e-10, .status = PTC_HOLD, .axis = PTC_HOLD, .has_axis = 1U},
        {.t = 0.3, .x = {0.75, -1.25, 0.5}, .u = 0.0, .tolerance = 0.0, .status = PTC_E_INPUT, .axis = PTC_E_INPUT, .has_axis = 1U},
        {.t = 1.3, .x = {0.1875, -0.3125, 0.125}, .u = -5.250000000000002, .tolerance = 5.299157341758566e-13, .status = PTC_OK, .axis = PTC_OK, .has_axis = 1U},
        {.t = 1.3, .x = {1.125, -1.875, 0.75}, .u = -21.000000000000007, .tolerance = 0.0, .status = PTC_SATURATED, .axis = PTC_SATURATED, .has_axis = 1U},
        {.t = 1.3, .x = {-1.125, 1.875, -0.75}, .u = 21.000000000000007, .tolerance = 0.0, .status = PTC_SATURATED, .axis = PTC_SATURATED, .has_axis = 1U},
        {.t = 2.3, .x = {9.527439024390247e-5, -0.00015879065040650412, 6.351626016260165e-5}, .u = -5.250000000000002, .tolerance = 6.894012441975889e-14, .status = PTC_HOLD, .axis = PTC_HOLD, .has_axis = 1U},
        {.t = 2.3, .x = {0.0005716463414634148, -0.0009527439024390247, 0.0003810975609756099}, .u = -21.000000000000007, .tolerance = 0.0, .status = PTC_SATURATED, .axis = PTC_SATURATED, .has_axis = 1U},
        {.t = 2.3, .x = {-0.0005716463414634148, 0.0009527439024390247, -0.0003810975609756099}, .u = 21.000000000000007, .tolerance = 0.0, .status = PTC_SATURATED, .axis = PTC_SATURATED, .has_axis = 1U},
        {.t = 3.3, .x = {9.527439024390247e-5, -0.00015879065040650412, 6.351626016260165e-5}, .u = -5.250000000000002, .tolerance = 6.894012441975889e-14, .status = PTC_HOLD, .axis = PTC_HOLD, .has_axis = 1U},
        {.t = 3.3, .x = {0.0005716463414634148, -0.0009527439024390247, 0.0003810975609756099}, .u = -21.000000000000007, .tolerance = 0.0, .status = PTC_SATURATED, .axis = PTC_SATURATED, .has_axis = 1U},
        {.t = 3.3, .x = {-0.0005716463414634148, 0.0009527439024390247, -0.0003810975609756099}, .u = 21.000000000000007, .tolerance = 0.0, .status = PTC_SATURATED, .axis = PTC_SATURATED, .has_axis = 1U},
        {.t = 2.3, .x = {1.3482698511467367e308, -1.0, -1.0}, .u = 0.0, .tolerance = 0.0, .status = PTC_E_RANGE, .axis = PTC_E_RANGE, .has_axis = 1U},
        {.t = -5e149, .x = {1.3482698511467367e308, 0.0, 0.0}, .u = 0.0, .tolerance = 0.0, .status = PTC_E_RANGE, .axis = PTC_E_RANGE, .has_axis = 0U},
    };
    uint32_t failures = 0U;

    for (uint32_t i = 0U; i < 6U; i++) {
        const stage_selftest_session *session = &stage_selftest_sessions[i];
        stage self;
        ptc_status status = stage_init(&self, &session->params);

        if ((status == PTC_OK) && (session->is_armed_again != 0U)) {
            status = stage_arm(&self, session->t0);
        }
        if (status == PTC_OK) {
            for (uint32_t j = 0U; j < session->count; j++) {
                failures += stage_selftest_check(&self, &calls[session->first + j]);
            }
        } else {
            failures++;
        }
    }
    return failures;
}

/* What init and arm must refuse without a change. */
static uint32_t stage_selftest_refuse(void)
{
    static const stage_params refused[20] = {
        {.tau = (double)NAN, .t0 = 0.3, .eps = 0.125, .u_max = (double)INFINITY},
        {.tau = (double)INFINITY, .t0 = 0.3, .eps = (double)INFINITY, .u_max = (double)INFINITY},
        {.tau = 0.0, .t0 = 0.3, .eps = 0.125, .u_max = (double)INFINITY},
        {.tau = -1.0, .t0 = 0.3, .eps = 0.125, .u_max = (double)INFINITY},
        {.tau = 7.5e-151, .t0 = 0.3, .eps = 4.6875e-152, .u_max = (double)INFINITY},
        {.tau = 1.25e150, .t0 = 0.3, .eps = 7.8125e148, .u_max = (double)INFINITY},
        {.tau = 2.0, .t0 = (double)NAN, .eps = 0.125, .u_max = (double)INFINITY},
        {.tau = 2.0, .t0 = (double)INFINITY, .eps = 0.125, .u_max = (double)INFINITY},
        {.tau = 2.0, .t0 = -(double)INFINITY, .eps = 0.125, .u_max = (double)INFINITY},
        {.tau = 2.0, .t0 = 0.3, .eps = (double)NAN, .u_max = (double)INFINITY},
        {.tau = 2.0, .t0 = 0.3, .eps = (double)INFINITY, .u_max = (double)INFINITY},
        {.tau = 2.0, .t0 = 0.3, .eps = 0.0, .u_max = (double)INFINITY},
        {.tau = 2.0, .t0 = 0.3, .eps = -1.0, .u_max = (double)INFINITY},
        {.tau = 2.0, .t0 = 0.3, .eps = 7.5e-151, .u_max = (double)INFINITY},
        {.tau = 2.0, .t0 = 0.3, .eps = 2.0, .u_max = (double)INFINITY},
        {.tau = 2.0, .t0 = 0.3, .eps = 4.0, .u_max = (double)INFINITY},
        {.tau = 2.0, .t0 = 0.3, .eps = 0.125, .u_max = (double)NAN},
        {.tau = 2.0, .t0 = 0.3, .eps = 0.125, .u_max = 0.0},
        {.tau = 2.0, .t0 = 0.3, .eps = 0.125, .u_max = -1.0},
        {.tau = 2.0, .t0 = 0.3, .eps = 0.125, .u_max = -(double)INFINITY},
    };
    static const double starts[3] = {(double)NAN, (double)INFINITY, -(double)INFINITY};
    const stage_selftest_session *session = &stage_selftest_sessions[0];
    const stage_selftest_call call = {.t = 0.3, .x = {0.75, -1.25, 0.5}, .u = 4.5, .tolerance = 4.397492007221627e-13, .status = PTC_OK, .axis = PTC_OK, .has_axis = 1U};
    uint32_t failures = 0U;
    stage self;

    if (stage_init(&self, &session->params) != PTC_OK) {
        failures++;
    }
    for (uint32_t i = 0U; i < 20U; i++) {
        if (stage_init(&self, &refused[i]) != PTC_E_PARAM) {
            failures++;
        }
    }
    for (uint32_t i = 0U; i < 3U; i++) {
        if (stage_arm(&self, starts[i]) != PTC_E_PARAM) {
            failures++;
        }
    }
    failures += stage_selftest_check(&self, &call);
    if (stage_init(&self, NULL) != PTC_E_PARAM) {
        failures++;
    }
    if (stage_init(NULL, &session->params) != PTC_E_PARAM) {
        failures++;
    }
    if (stage_arm(NULL, session->t0) != PTC_E_PARAM) {
        failures++;
    }
    /* A deadline beyond the range, which no legal parameters need to reach. */
    self.tau = 1.7976931348623157e308;
    if (stage_arm(&self, 1.7976931348623157e308) != PTC_E_PARAM) {
        failures++;
    }
    return failures;
}

/* 1 where a call without one of its pointers was not refused with u = 0. */
static uint32_t stage_selftest_refused(ptc_status status, double u)
{
    uint32_t failures = 1U;

    if ((status == PTC_E_INPUT) && (fabs(u) <= 0.0)) {
        failures = 0U;
    }
    return failures;
}

/* Calls that lack a pointer. */
static uint32_t stage_selftest_pointers(void)
{
    const stage_selftest_session *session = &stage_selftest_sessions[0];
    const stage_selftest_call call = {.t = 0.3, .x = {0.75, -1.25, 0.5}, .u = 4.5, .tolerance = 4.397492007221627e-13, .status = PTC_OK, .axis = PTC_OK, .has_axis = 1U};
    uint32_t failures = 0U;
    double u = 12345.0;
    ptc_status status;
    stage_gains gains;
    stage self;

    if (stage_init(&self, &session->params) != PTC_OK) {
        failures++;
    }
    status = stage_step(NULL, call.t, call.x, &u);
    failures += stage_selftest_refused(status, u);
    u = 12345.0;
    status = stage_step(&self, call.t, NULL, &u);
    failures += stage_selftest_refused(status, u);
    status = stage_step(&self, call.t, call.x, NULL);
    failures += stage_selftest_refused(status, 0.0);
    status = stage_tick(NULL, call.t, &gains);
    failures += stage_selftest_refused(status, 0.0);
    status = stage_tick(&self, call.t, NULL);
    failures += stage_selftest_refused(status, 0.0);
    if (stage_tick(&self, call.t, &gains) < PTC_OK) {
        failures++;
    }
    u = 12345.0;
    status = stage_axis(NULL, call.x, &u);
    failures += stage_selftest_refused(status, u);
    u = 12345.0;
    status = stage_axis(&gains, NULL, &u);
    failures += stage_selftest_refused(status, u);
    status = stage_axis(&gains, call.x, NULL);
    failures += stage_selftest_refused(status, 0.0);
    return failures;
}

uint32_t stage_selftest(void)
{
    uint32_t failures = stage_selftest_run();

    failures += stage_selftest_refuse();
    failures += stage_selftest_pointers();
    return failures;
}
