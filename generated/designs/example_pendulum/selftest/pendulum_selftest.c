/* Self-test of the prescribed-time controller pendulum: see pendulum_selftest.h. DO NOT EDIT. */
#include "pendulum_selftest.h"
#include "pendulum.h"

#include <math.h>
#include <stddef.h>

/* A call, and what it must give. */
typedef struct pendulum_selftest_call {
    double t;
    double x[2];
    double u;
    double tolerance;
    ptc_status status;
} pendulum_selftest_call;

/* A set of parameters that init takes, and the calls with it. */
typedef struct pendulum_selftest_session {
    pendulum_params params;
    double t0; /* of arm, where it is called */
    uint32_t is_armed_again;
    uint32_t first; /* of its calls */
    uint32_t count;
} pendulum_selftest_session;

static const pendulum_selftest_session pendulum_selftest_sessions[5] = {
    {.params = {.t0 = 0.3}, .t0 = 0.0, .is_armed_again = 0U, .first = 0U, .count = 18U},
    {.params = {.t0 = 0.3}, .t0 = 0.0, .is_armed_again = 0U, .first = 18U, .count = 10U},
    {.params = {.t0 = 0.3}, .t0 = 1000.1, .is_armed_again = 1U, .first = 28U, .count = 4U},
    {.params = {.t0 = 0.3}, .t0 = 0.0, .is_armed_again = 0U, .first = 32U, .count = 9U},
    {.params = {.t0 = 0.3}, .t0 = 0.0, .is_armed_again = 0U, .first = 41U, .count = 1U},
};

/* 1 where what was returned is not what must be. */
static uint32_t pendulum_selftest_differs(const pendulum_selftest_call *call, ptc_status wanted, ptc_status status, double u)
{
    uint32_t failures = 1U;

    if ((status == wanted) && (fabs(u - call->u) <= call->tolerance)) {
        failures = 0U;
    }
    return failures;
}

/* The failures of one call. */
static uint32_t pendulum_selftest_check(const pendulum *self, const pendulum_selftest_call *call)
{
    double u = 12345.0;
    ptc_status status = pendulum_step(self, call->t, call->x, &u);
    uint32_t failures = pendulum_selftest_differs(call, call->status, status, u);
    return failures;
}

/* Every session with its calls. */
static uint32_t pendulum_selftest_run(void)
{
    static const pendulum_selftest_call calls[42] = {
        {.t = 0.3, .x = {0.75, -1.25}, .u = 2.1465631179144546, .tolerance = 1.557172762968976e-13, .status = PTC_OK},
        {.t = 0.49999999999999994, .x = {-0.75, 1.25}, .u = -0.19343811791445564, .tolerance = 1.7351276209457004e-13, .status = PTC_OK},
        {.t = 0.78, .x = {0.7327170722781566, -1.2211951204635945}, .u = -12.48547766093917, .tolerance = 4.84721779233989e-13, .status = PTC_OK},
        {.t = 1.02, .x = {-0.02886333313488724, 0.048105555224812066}, .u = 12.487115365223474, .tolerance = 2.7781745519611966e-13, .status = PTC_OK},
        {.t = 0.6200000000000001, .x = {1.0, 0.0}, .u = -8.893418152850606, .tolerance = 3.0366555399167694e-13, .status = PTC_OK},
        {.t = 0.6200000000000001, .x = {0.0, 1.0}, .u = -3.1050000000000004, .tolerance = 7.380611516495891e-14, .status = PTC_OK},
        {.t = 1.06, .x = {0.006681374296371905, 0.0}, .u = -12.494804908601978, .tolerance = 2.5365365910444613e-13, .status = PTC_OK},
        {.t = 1.06, .x = {0.0, 0.3335112059765207}, .u = -12.500000000000002, .tolerance = 2.94664565032214e-13, .status = PTC_OK},
        {.t = (double)NAN, .x = {0.75, -1.25}, .u = 0.0, .tolerance = 0.0, .status = PTC_E_INPUT},
        {.t = (double)INFINITY, .x = {0.75, -1.25}, .u = 0.0, .tolerance = 0.0, .status = PTC_E_INPUT},
        {.t = -(double)INFINITY, .x = {0.75, -1.25}, .u = 0.0, .tolerance = 0.0, .status = PTC_E_INPUT},
        {.t = 0.7, .x = {(double)NAN, -1.25}, .u = 0.0, .tolerance = 0.0, .status = PTC_E_INPUT},
        {.t = 0.7, .x = {0.75, (double)NAN}, .u = 0.0, .tolerance = 0.0, .status = PTC_E_INPUT},
        {.t = 0.7, .x = {(double)INFINITY, -1.25}, .u = 0.0, .tolerance = 0.0, .status = PTC_E_INPUT},
        {.t = 0.7, .x = {0.75, (double)INFINITY}, .u = 0.0, .tolerance = 0.0, .status = PTC_E_INPUT},
        {.t = 0.7, .x = {-(double)INFINITY, -1.25}, .u = 0.0, .tolerance = 0.0, .status = PTC_E_INPUT},
        {.t = 0.7, .x = {0.75, -(double)INFINITY}, .u = 0.0, .tolerance = 0.0, .status = PTC_E_INPUT},
        {.t = -0.10000000000000003, .x = {0.75, -1.25}, .u = 0.0, .tolerance = 0.0, .status = PTC_E_INPUT},
        {.t = 1.088, .x = {0.0006061906492869331, -0.001010317748811555}, .u = -12.499728982945415, .tolerance = 2.558062401554261e-13, .status = PTC_OK},
        {.t = 1.088, .x = {-0.0006061906492869331, 0.001010317748811555}, .u = 12.499728982945415, .tolerance = 2.558062401554261e-13, .status = PTC_OK},
        {.t = 1.097, .x = {0.00015076181376883678, -0.00025126968961472793}, .u = -12.499932597032773, .tolerance = 2.542621692465891e-13, .status = PTC_HOLD},
        {.t = 1.097, .x = {-0.00015076181376883678, 0.00025126968961472793}, .u = 12.499932597032773, .tolerance = 2.542621692465891e-13, .status = PTC_HOLD},
        {.t = 1.1, .x = {0.00015076181376883678, -0.00025126968961472793}, .u = -12.499932597032773, .tolerance = 2.542621692465891e-13, .status = PTC_HOLD},
        {.t = 1.1, .x = {-0.00015076181376883678, 0.00025126968961472793}, .u = 12.499932597032773, .tolerance = 2.542621692465891e-13, .status = PTC_HOLD},
        {.t = 1.3, .x = {0.00015076181376883678, -0.00025126968961472793}, .u = -12.499932597032773, .tolerance = 2.542621692465891e-13, .status = PTC_HOLD},
        {.t = 1.3, .x = {-0.00015076181376883678, 0.00025126968961472793}, .u = 12.499932597032773, .tolerance = 2.542621692465891e-13, .status = PTC_HOLD},
        {.t = 9.100000000000001, .x = {0.00015076181376883678, -0.00025126968961472793}, .u = -12.499932597032773, .tolerance = 2.542621692465891e-13, .status = PTC_HOLD},
        {.t = 9.100000000000001, .x = {-0.00015076181376883678, 0.00025126968961472793}, .u = 12.499932597032773, .tolerance = 2.542621692465891e-13, .status = PTC_HOLD},
        {.t = 1000.1, .x = {-0.75, 1.25}, .u = -2.1465631179144546, .tolerance = 1.557172762968976e-13, .status = PTC_OK},
        {.t = 1000.66, .x = {-0.3356418104931758, 0.5594030174886264}, .u = 12.380677972014674, .tolerance = 3.8052167527617193e-13, .status = PTC_OK},
        {.t = 1000.9, .x = {-0.00015076181376883678, 0.00025126968961472793}, .u = 12.499932597032773, .tolerance = 2.542621692465891e-13, .status = PTC_HOLD},
        {.t = 0.3, .x = {0.75, -1.25}, .u = 0.0, .tolerance = 0.0, .status = PTC_E_INPUT},
        {.t = 0.7, .x = {0.773953951311051, -1.2899232521850852}, .u = -6.271782984532144, .tolerance = 3.428077406392416e-13, .status = PTC_OK},
        {.t = 0.7, .x = {4.6437237078663065, -7.73953951311051}, .u = -25.0, .tolerance = 0.0, .status = PTC_SATURATED},
        {.t = 0.7, .x = {-4.6437237078663065, 7.73953951311051}, .u = 25.0, .tolerance = 0.0, .status = PTC_SATURATED},
        {.t = 1.1, .x = {7.538090688441839e-5, -0.00012563484480736397}, .u = -6.249966298515337, .tolerance = 1.271310846233048e-13, .status = PTC_HOLD},
        {.t = 1.1, .x = {0.00045228544130651035, -0.0007538090688441839}, .u = -25.0, .tolerance = 0.0, .status = PTC_SATURATED},
        {.t = 1.1, .x = {-0.00045228544130651035, 0.0007538090688441839}, .u = 25.0, .tolerance = 0.0, .status = PTC_SATURATED},
        {.t = 1.5000000000000002, .x = {7.538090688441839e-5, -0.00012563484480736397}, .u = -6.249966298515337, .tolerance = 1.271310846233048e-13, .status = PTC_HOLD},
        {.t = 1.5000000000000002, .x = {0.00045228544130651035, -0.0007538090688441839}, .u = -25.0, .tolerance = 0.0, .status = PTC_SATURATED},
        {.t = 1.5000000000000002, .x = {-0.00045228544130651035, 0.0007538090688441839}, .u = 25.0, .tolerance = 0.0, .status = PTC_SATURATED},
        {.t = 0.7, .x = {-1.7976931348623157e308, 1.3482698511467367e308}, .u = 0.0, .tolerance = 0.0, .status = PTC_E_RANGE},
    };
    uint32_t failures = 0U;

    for (uint32_t i = 0U; i < 5U; i++) {
        const pendulum_selftest_session *session = &pendulum_selftest_sessions[i];
        pendulum self;
        ptc_status status = pendulum_init(&self, &session->params);

        if ((status == PTC_OK) && (session->is_armed_again != 0U)) {
            status = pendulum_arm(&self, session->t0);
        }
        if (status == PTC_OK) {
            for (uint32_t j = 0U; j < session->count; j++) {
                failures += pendulum_selftest_check(&self, &calls[session->first + j]);
            }
        } else {
            failures++;
        }
    }
    return failures;
}

/* What init and arm must refuse without a change. */
static uint32_t pendulum_selftest_refuse(void)
{
    static const pendulum_params refused[3] = {
        {.t0 = (double)NAN},
        {.t0 = (double)INFINITY},
        {.t0 = -(double)INFINITY},
    };
    static const double starts[3] = {(double)NAN, (double)INFINITY, -(double)INFINITY};
    const pendulum_selftest_session *session = &pendulum_selftest_sessions[0];
    const pendulum_selftest_call call = {.t = 0.3, .x = {0.75, -1.25}, .u = 2.1465631179144546, .tolerance = 1.557172762968976e-13, .status = PTC_OK};
    uint32_t failures = 0U;
    pendulum self;

    if (pendulum_init(&self, &session->params) != PTC_OK) {
        failures++;
    }
    for (uint32_t i = 0U; i < 3U; i++) {
        if (pendulum_init(&self, &refused[i]) != PTC_E_PARAM) {
            failures++;
        }
    }
    for (uint32_t i = 0U; i < 3U; i++) {
        if (pendulum_arm(&self, starts[i]) != PTC_E_PARAM) {
            failures++;
        }
    }
    failures += pendulum_selftest_check(&self, &call);
    if (pendulum_init(&self, NULL) != PTC_E_PARAM) {
        failures++;
    }
    if (pendulum_init(NULL, &session->params) != PTC_E_PARAM) {
        failures++;
    }
    if (pendulum_arm(NULL, session->t0) != PTC_E_PARAM) {
        failures++;
    }
    return failures;
}

/* 1 where a call without one of its pointers was not refused with u = 0. */
static uint32_t pendulum_selftest_refused(ptc_status status, double u)
{
    uint32_t failures = 1U;

    if ((status == PTC_E_INPUT) && (fabs(u) <= 0.0)) {
        failures = 0U;
    }
    return failures;
}

/* Calls that lack a pointer. */
static uint32_t pendulum_selftest_pointers(void)
{
    const pendulum_selftest_session *session = &pendulum_selftest_sessions[0];
    const pendulum_selftest_call call = {.t = 0.3, .x = {0.75, -1.25}, .u = 2.1465631179144546, .tolerance = 1.557172762968976e-13, .status = PTC_OK};
    uint32_t failures = 0U;
    double u = 12345.0;
    ptc_status status;
    pendulum self;

    if (pendulum_init(&self, &session->params) != PTC_OK) {
        failures++;
    }
    status = pendulum_step(NULL, call.t, call.x, &u);
    failures += pendulum_selftest_refused(status, u);
    u = 12345.0;
    status = pendulum_step(&self, call.t, NULL, &u);
    failures += pendulum_selftest_refused(status, u);
    status = pendulum_step(&self, call.t, call.x, NULL);
    failures += pendulum_selftest_refused(status, 0.0);
    return failures;
}

uint32_t pendulum_selftest(void)
{
    uint32_t failures = pendulum_selftest_run();

    failures += pendulum_selftest_refuse();
    failures += pendulum_selftest_pointers();
    return failures;
}
