/* Self-test of the prescribed-time controller duration: see duration_selftest.h. DO NOT EDIT. */
#include "duration_selftest.h"
#include "duration.h"

#include <math.h>
#include <stddef.h>

/* A call, and what it must give. */
typedef struct duration_selftest_call {
    float t;
    float x[3];
    float u;
    float tolerance;
    ptc_status status;
    ptc_status axis; /* of tick and axis */
    uint32_t has_axis;
} duration_selftest_call;

/* A set of parameters that init takes, and the calls with it. */
typedef struct duration_selftest_session {
    duration_params params;
    float t0; /* of arm, where it is called */
    uint32_t is_armed_again;
    float tau; /* of arm_for, where that is called */
    uint32_t is_armed_for;
    uint32_t first; /* of its calls */
    uint32_t count;
} duration_selftest_session;

static const duration_selftest_session duration_selftest_sessions[7] = {
    {.params = {.tau = 2.0f, .t0 = 0.3f, .eps = 2e-7f, .a = 0.75f}, .tau = 0.0f, .is_armed_for = 0U, .t0 = 0.0f, .is_armed_again = 0U, .first = 0U, .count = 26U},
    {.params = {.tau = 2.0f, .t0 = 0.3f, .eps = 0.125f, .a = 0.75f}, .tau = 0.0f, .is_armed_for = 0U, .t0 = 0.0f, .is_armed_again = 0U, .first = 26U, .count = 10U},
    {.params = {.tau = 2.0f, .t0 = 0.3f, .eps = 0.125f, .a = 0.75f}, .tau = 0.0f, .is_armed_for = 0U, .t0 = 1000.1f, .is_armed_again = 1U, .first = 36U, .count = 4U},
    {.params = {.tau = 2.0f, .t0 = 0.3f, .eps = 0.125f, .a = 0.75f}, .tau = 0.875f, .is_armed_for = 1U, .t0 = -3.7f, .is_armed_again = 0U, .first = 40U, .count = 8U},
    {.params = {.tau = 2.0f, .t0 = 0.3f, .eps = 0.125f, .a = 0.75f}, .tau = 3.3125f, .is_armed_for = 1U, .t0 = 0.2f, .is_armed_again = 1U, .first = 48U, .count = 8U},
    {.params = {.tau = 2.0f, .t0 = 0.3f, .eps = 0.125f, .a = 0.75f}, .tau = 0.0f, .is_armed_for = 0U, .t0 = 0.0f, .is_armed_again = 0U, .first = 56U, .count = 9U},
    {.params = {.tau = 2.0f, .t0 = 0.3f, .eps = 0.0002f, .a = 0.75f}, .tau = 0.0f, .is_armed_for = 0U, .t0 = 0.0f, .is_armed_again = 0U, .first = 65U, .count = 1U},
};

/* 1 where what was returned is not what must be. */
static uint32_t duration_selftest_differs(const duration_selftest_call *call, ptc_status wanted, ptc_status status, float u)
{
    uint32_t failures = 1U;

    if ((status == wanted) && (fabsf(u - call->u) <= call->tolerance)) {
        failures = 0U;
    }
    return failures;
}

/* The failures of one call. */
static uint32_t duration_selftest_check(const duration *self, const duration_selftest_call *call)
{
    float u = 12345.0f;
    ptc_status status = duration_step(self, call->t, call->x, &u);
    uint32_t failures = duration_selftest_differs(call, call->status, status, u);

    if (call->has_axis != 0U) {
        duration_gains gains;

        u = 0.0f;
        status = duration_tick(self, call->t, &gains);
        if (status >= PTC_OK) {
            u = 12345.0f;
            status = duration_axis(&gains, call->x, &u);
        }
        failures += duration_selftest_differs(call, call->axis, status, u);
    }
    return failures;
}

/* Every session with its calls. */
static uint32_t duration_selftest_run(void)
{
    static const duration_selftest_call calls[66] = {
        {.t = 0.3f, .x = {0.75f, -1.25f, 0.5f}, .u = -11.312762f, .tolerance = 0.00042972455f, .status = PTC_OK, .axis = PTC_OK, .has_axis = 1U},
        {.t = 0.8f, .x = {-0.73656946f, 1.2276157f, -0.4910463f}, .u = 50.000008f, .tolerance = 0.0006567475f, .status = PTC_OK, .axis = PTC_OK, .has_axis = 1U},
        {.t = 1.5f, .x = {0.02093186f, -0.034886435f, 0.013954574f}, .u = -50.0f, .tolerance = 0.0002019992f, .status = PTC_OK, .axis = PTC_OK, .has_axis = 1U},
        {.t = 2.1f, .x = {-5.4418624e-6f, 9.06977e-6f, -3.6279082e-6f}, .u = 50.0f, .tolerance = 0.00011088225f, .status = PTC_OK, .axis = PTC_OK, .has_axis = 1U},
        {.t = 2.28f, .x = {5.450357e-12f, -9.083929e-12f, 3.6335715e-12f}, .u = -50.0f, .tolerance = 0.00010600891f, .status = PTC_OK, .axis = PTC_OK, .has_axis = 1U},
        {.t = 2.2998f, .x = {-5.4655123e-24f, 9.109187e-24f, -3.6436748e-24f}, .u = 50.0f, .tolerance = 0.000105960484f, .status = PTC_OK, .axis = PTC_OK, .has_axis = 1U},
        {.t = 1.1f, .x = {0.10172993f, 0.0f, 0.0f}, .u = -50.0f, .tolerance = 0.00010596047f, .status = PTC_OK, .axis = PTC_OK, .has_axis = 1U},
        {.t = 1.1f, .x = {0.0f, 0.30719212f, 0.0f}, .u = -50.0f, .tolerance = 0.00013961594f, .status = PTC_OK, .axis = PTC_OK, .has_axis = 1U},
        {.t = 1.1f, .x = {0.0f, 0.0f, 1.0f}, .u = -20.575882f, .tolerance = 5.7299607e-5f, .status = PTC_OK, .axis = PTC_OK, .has_axis = 1U},
        {.t = 2.2f, .x = {8.463729e-8f, 0.0f, 0.0f}, .u = -50.0f, .tolerance = 0.00010596047f, .status = PTC_OK, .axis = PTC_OK, .has_axis = 1U},
        {.t = 2.2f, .x = {0.0f, 2.3910192e-5f, 0.0f}, .u = -50.0f, .tolerance = 0.00011083141f, .status = PTC_OK, .axis = PTC_OK, .has_axis = 1U},
        {.t = 2.2f, .x = {0.0f, 0.0f, 0.02006544f}, .u = -50.0f, .tolerance = 0.000110766276f, .status = PTC_OK, .axis = PTC_OK, .has_axis = 1U},
        {.t = 1.7f, .x = {0.0f, 0.0f, 0.7466704f}, .u = -50.0f, .tolerance = 0.00013358306f, .status = PTC_OK, .axis = PTC_OK, .has_axis = 1U},
        {.t = (float)NAN, .x = {0.07605935f, -0.12676558f, 0.050706234f}, .u = 0.0f, .tolerance = 0.0f, .status = PTC_E_INPUT, .axis = PTC_E_INPUT, .has_axis = 1U},
        {.t = (float)INFINITY, .x = {0.07605935f, -0.12676558f, 0.050706234f}, .u = 0.0f, .tolerance = 0.0f, .status = PTC_E_INPUT, .axis = PTC_E_INPUT, .has_axis = 1U},
        {.t = -(float)INFINITY, .x = {0.07605935f, -0.12676558f, 0.050706234f}, .u = 0.0f, .tolerance = 0.0f, .status = PTC_E_INPUT, .axis = PTC_E_INPUT, .has_axis = 1U},
        {.t = 1.3f, .x = {(float)NAN, -0.12676558f, 0.050706234f}, .u = 0.0f, .tolerance = 0.0f, .status = PTC_E_INPUT, .axis = PTC_E_INPUT, .has_axis = 1U},
        {.t = 1.3f, .x = {0.07605935f, (float)NAN, 0.050706234f}, .u = 0.0f, .tolerance = 0.0f, .status = PTC_E_INPUT, .axis = PTC_E_INPUT, .has_axis = 1U},
        {.t = 1.3f, .x = {0.07605935f, -0.12676558f, (float)NAN}, .u = 0.0f, .tolerance = 0.0f, .status = PTC_E_INPUT, .axis = PTC_E_INPUT, .has_axis = 1U},
        {.t = 1.3f, .x = {(float)INFINITY, -0.12676558f, 0.050706234f}, .u = 0.0f, .tolerance = 0.0f, .status = PTC_E_INPUT, .axis = PTC_E_INPUT, .has_axis = 1U},
        {.t = 1.3f, .x = {0.07605935f, (float)INFINITY, 0.050706234f}, .u = 0.0f, .tolerance = 0.0f, .status = PTC_E_INPUT, .axis = PTC_E_INPUT, .has_axis = 1U},
        {.t = 1.3f, .x = {0.07605935f, -0.12676558f, (float)INFINITY}, .u = 0.0f, .tolerance = 0.0f, .status = PTC_E_INPUT, .axis = PTC_E_INPUT, .has_axis = 1U},
        {.t = 1.3f, .x = {-(float)INFINITY, -0.12676558f, 0.050706234f}, .u = 0.0f, .tolerance = 0.0f, .status = PTC_E_INPUT, .axis = PTC_E_INPUT, .has_axis = 1U},
        {.t = 1.3f, .x = {0.07605935f, -(float)INFINITY, 0.050706234f}, .u = 0.0f, .tolerance = 0.0f, .status = PTC_E_INPUT, .axis = PTC_E_INPUT, .has_axis = 1U},
        {.t = 1.3f, .x = {0.07605935f, -0.12676558f, -(float)INFINITY}, .u = 0.0f, .tolerance = 0.0f, .status = PTC_E_INPUT, .axis = PTC_E_INPUT, .has_axis = 1U},
        {.t = -0.7f, .x = {0.07605935f, -0.12676558f, 0.050706234f}, .u = 0.0f, .tolerance = 0.0f, .status = PTC_E_INPUT, .axis = PTC_E_INPUT, .has_axis = 1U},
        {.t = 2.05f, .x = {2.073257e-5f, -3.4554283e-5f, 1.3821713e-5f}, .u = -50.000004f, .tolerance = 0.00011371751f, .status = PTC_OK, .axis = PTC_OK, .has_axis = 1U},
        {.t = 2.05f, .x = {-2.073257e-5f, 3.4554283e-5f, -1.3821713e-5f}, .u = 50.000004f, .tolerance = 0.00011371751f, .status = PTC_OK, .axis = PTC_OK, .has_axis = 1U},
        {.t = 2.2375f, .x = {3.2471755e-7f, -5.411959e-7f, 2.1647837e-7f}, .u = -50.0f, .tolerance = 0.00010786459f, .status = PTC_HOLD, .axis = PTC_HOLD, .has_axis = 1U},
        {.t = 2.2375f, .x = {-3.2471755e-7f, 5.411959e-7f, -2.1647837e-7f}, .u = 50.0f, .tolerance = 0.00010786459f, .status = PTC_HOLD, .axis = PTC_HOLD, .has_axis = 1U},
        {.t = 2.3f, .x = {3.2471755e-7f, -5.411959e-7f, 2.1647837e-7f}, .u = -50.0f, .tolerance = 0.00010786459f, .status = PTC_HOLD, .axis = PTC_HOLD, .has_axis = 1U},
        {.t = 2.3f, .x = {-3.2471755e-7f, 5.411959e-7f, -2.1647837e-7f}, .u = 50.0f, .tolerance = 0.00010786459f, .status = PTC_HOLD, .axis = PTC_HOLD, .has_axis = 1U},
        {.t = 2.8f, .x = {3.2471755e-7f, -5.411959e-7f, 2.1647837e-7f}, .u = -50.0f, .tolerance = 0.00010786459f, .status = PTC_HOLD, .axis = PTC_HOLD, .has_axis = 1U},
        {.t = 2.8f, .x = {-3.2471755e-7f, 5.411959e-7f, -2.1647837e-7f}, .u = 50.0f, .tolerance = 0.00010786459f, .status = PTC_HOLD, .axis = PTC_HOLD, .has_axis = 1U},
        {.t = 22.3f, .x = {3.2471755e-7f, -5.411959e-7f, 2.1647837e-7f}, .u = -50.0f, .tolerance = 0.00010786459f, .status = PTC_HOLD, .axis = PTC_HOLD, .has_axis = 1U},
        {.t = 22.3f, .x = {-3.2471755e-7f, 5.411959e-7f, -2.1647837e-7f}, .u = 50.0f, .tolerance = 0.00010786459f, .status = PTC_HOLD, .axis = PTC_HOLD, .has_axis = 1U},
        {.t = 1000.1f, .x = {-0.75f, 1.25f, -0.5f}, .u = 11.312762f, .tolerance = 0.00042972455f, .status = PTC_OK, .axis = PTC_OK, .has_axis = 1U},
        {.t = 1001.5f, .x = {-0.0038541127f, 0.006423521f, -0.0025694084f}, .u = 50.0f, .tolerance = 0.000155481f, .status = PTC_OK, .axis = PTC_OK, .has_axis = 1U},
        {.t = 1002.1f, .x = {-3.2471755e-7f, 5.411959e-7f, -2.1647837e-7f}, .u = 50.0f, .tolerance = 0.00010786459f, .status = PTC_HOLD, .axis = PTC_HOLD, .has_axis = 1U},
        {.t = 0.3f, .x = {0.75f, -1.25f, 0.5f}, .u = 0.0f, .tolerance = 0.0f, .status = PTC_E_INPUT, .axis = PTC_E_INPUT, .has_axis = 1U},
        {.t = -3.7f, .x = {0.051350612f, -0.08558436f, 0.03423374f}, .u = -49.999996f, .tolerance = 0.00025110052f, .status = PTC_OK, .axis = PTC_OK, .has_axis = 1U},
        {.t = -3.7f, .x = {-0.051350612f, 0.08558436f, -0.03423374f}, .u = 49.999996f, .tolerance = 0.00025110052f, .status = PTC_OK, .axis = PTC_OK, .has_axis = 1U},
        {.t = -3.3500001f, .x = {0.011152275f, -0.018587124f, 0.0074348496f}, .u = -50.000004f, .tolerance = 0.00018005533f, .status = PTC_OK, .axis = PTC_OK, .has_axis = 1U},
        {.t = -3.3500001f, .x = {-0.011152275f, 0.018587124f, -0.0074348496f}, .u = 50.000004f, .tolerance = 0.00018005533f, .status = PTC_OK, .axis = PTC_OK, .has_axis = 1U},
        {.t = -3.04375f, .x = {0.00010110825f, -0.00016851375f, 6.74055e-5f}, .u = -50.0f, .tolerance = 0.00011936418f, .status = PTC_OK, .axis = PTC_OK, .has_axis = 1U},
        {.t = -3.04375f, .x = {-0.00010110825f, 0.00016851375f, -6.74055e-5f}, .u = 50.0f, .tolerance = 0.00011936418f, .status = PTC_OK, .axis = PTC_OK, .has_axis = 1U},
        {.t = -2.825f, .x = {3.7633863e-6f, -6.2723107e-6f, 2.5089244e-6f}, .u = -50.0f, .tolerance = 0.00011030857f, .status = PTC_HOLD, .axis = PTC_HOLD, .has_axis = 1U},
        {.t = -2.825f, .x = {-3.7633863e-6f, 6.2723107e-6f, -2.5089244e-6f}, .u = 50.0f, .tolerance = 0.00011030857f, .status = PTC_HOLD, .axis = PTC_HOLD, .has_axis = 1U},
        {.t = 0.2f, .x = {0.75f, -1.25f, 0.5f}, .u = 8.925733f, .tolerance = 0.00013112587f, .status = PTC_OK, .axis = PTC_OK, .has_axis = 1U},
        {.t = 0.2f, .x = {-0.75f, 1.25f, -0.5f}, .u = -8.925733f, .tolerance = 0.00013112587f, .status = PTC_OK, .axis = PTC_OK, .has_axis = 1U},
        {.t = 1.525f, .x = {0.75f, -1.25f, 0.5f}, .u = -13.177677f, .tolerance = 0.00037865705f, .status = PTC_OK, .axis = PTC_OK, .has_axis = 1U},
        {.t = 1.525f, .x = {-0.75f, 1.25f, -0.5f}, .u = 13.177677f, .tolerance = 0.00037865705f, .status = PTC_OK, .axis = PTC_OK, .has_axis = 1U},
        {.t = 2.684375f, .x = {0.00655167f, -0.01091945f, 0.00436778f}, .u = -50.0f, .tolerance = 0.00016665187f, .status = PTC_OK, .axis = PTC_OK, .has_axis = 1U},
        {.t = 2.684375f, .x = {-0.00655167f, 0.01091945f, -0.00436778f}, .u = 50.0f, .tolerance = 0.00016665187f, .status = PTC_OK, .axis = PTC_OK, .has_axis = 1U},
        {.t = 3.5125f, .x = {7.165354e-8f, -1.1942255e-7f, 4.7769024e-8f}, .u = -50.000004f, .tolerance = 0.00010710804f, .status = PTC_HOLD, .axis = PTC_HOLD, .has_axis = 1U},
        {.t = 3.5125f, .x = {-7.165354e-8f, 1.1942255e-7f, -4.7769024e-8f}, .u = 50.000004f, .tolerance = 0.00010710804f, .status = PTC_HOLD, .axis = PTC_HOLD, .has_axis = 1U},
        {.t = 1.3f, .x = {0.038029674f, -0.06338279f, 0.025353117f}, .u = -25.0f, .tolerance = 0.00013637998f, .status = PTC_OK, .axis = PTC_OK, .has_axis = 1U},
        {.t = 1.3f, .x = {0.22817805f, -0.38029677f, 0.1521187f}, .u = -100.0f, .tolerance = 0.0f, .status = PTC_SATURATED, .axis = PTC_SATURATED, .has_axis = 1U},
        {.t = 1.3f, .x = {-0.22817805f, 0.38029677f, -0.1521187f}, .u = 100.0f, .tolerance = 0.0f, .status = PTC_SATURATED, .axis = PTC_SATURATED, .has_axis = 1U},
        {.t = 2.3f, .x = {1.6235877e-7f, -2.7059795e-7f, 1.08239185e-7f}, .u = -25.0f, .tolerance = 5.3932294e-5f, .status = PTC_HOLD, .axis = PTC_HOLD, .has_axis = 1U},
        {.t = 2.3f, .x = {9.741526e-7f, -1.6235878e-6f, 6.494351e-7f}, .u = -100.0f, .tolerance = 0.0f, .status = PTC_SATURATED, .axis = PTC_SATURATED, .has_axis = 1U},
        {.t = 2.3f, .x = {-9.741526e-7f, 1.6235878e-6f, -6.494351e-7f}, .u = 100.0f, .tolerance = 0.0f, .status = PTC_SATURATED, .axis = PTC_SATURATED, .has_axis = 1U},
        {.t = 3.3f, .x = {1.6235877e-7f, -2.7059795e-7f, 1.08239185e-7f}, .u = -25.0f, .tolerance = 5.3932294e-5f, .status = PTC_HOLD, .axis = PTC_HOLD, .has_axis = 1U},
        {.t = 3.3f, .x = {9.741526e-7f, -1.6235878e-6f, 6.494351e-7f}, .u = -100.0f, .tolerance = 0.0f, .status = PTC_SATURATED, .axis = PTC_SATURATED, .has_axis = 1U},
        {.t = 3.3f, .x = {-9.741526e-7f, 1.6235878e-6f, -6.494351e-7f}, .u = 100.0f, .tolerance = 0.0f, .status = PTC_SATURATED, .axis = PTC_SATURATED, .has_axis = 1U},
        {.t = 2.3f, .x = {2.5521175e38f, -1.0f, -1.0f}, .u = 0.0f, .tolerance = 0.0f, .status = PTC_E_RANGE, .axis = PTC_E_RANGE, .has_axis = 1U},
    };
    uint32_t failures = 0U;

    for (uint32_t i = 0U; i < 7U; i++) {
        const duration_selftest_session *session = &duration_selftest_sessions[i];
        duration self;
        ptc_status status = duration_init(&self, &session->params);

        if ((status == PTC_OK) && (session->is_armed_for != 0U)) {
            status = duration_arm_for(&self, session->t0, session->tau);
        }
        if ((status == PTC_OK) && (session->is_armed_again != 0U)) {
            status = duration_arm(&self, session->t0);
        }
        if (status == PTC_OK) {
            for (uint32_t j = 0U; j < session->count; j++) {
                failures += duration_selftest_check(&self, &calls[session->first + j]);
            }
        } else {
            failures++;
        }
    }
    return failures;
}

/* What init and arm must refuse without a change. */
static uint32_t duration_selftest_refuse(void)
{
    static const duration_params refused[27] = {
        {.tau = (float)NAN, .t0 = 0.3f, .eps = 0.125f, .a = 0.75f},
        {.tau = (float)INFINITY, .t0 = 0.3f, .eps = (float)INFINITY, .a = 0.75f},
        {.tau = 0.0f, .t0 = 0.3f, .eps = 0.125f, .a = 0.75f},
        {.tau = -1.0f, .t0 = 0.3f, .eps = 0.125f, .a = 0.75f},
        {.tau = 7.5e-19f, .t0 = 0.3f, .eps = 4.6875e-20f, .a = 0.75f},
        {.tau = 1.25e18f, .t0 = 0.3f, .eps = 7.8125e16f, .a = 0.75f},
        {.tau = 2.0f, .t0 = (float)NAN, .eps = 0.125f, .a = 0.75f},
        {.tau = 2.0f, .t0 = (float)INFINITY, .eps = 0.125f, .a = 0.75f},
        {.tau = 2.0f, .t0 = -(float)INFINITY, .eps = 0.125f, .a = 0.75f},
        {.tau = 2.0f, .t0 = 0.3f, .eps = (float)NAN, .a = 0.75f},
        {.tau = 2.0f, .t0 = 0.3f, .eps = (float)INFINITY, .a = 0.75f},
        {.tau = 2.0f, .t0 = 0.3f, .eps = 0.0f, .a = 0.75f},
        {.tau = 2.0f, .t0 = 0.3f, .eps = -1.0f, .a = 0.75f},
        {.tau = 2.0f, .t0 = 0.3f, .eps = 7.5e-19f, .a = 0.75f},
        {.tau = 2.0f, .t0 = 0.3f, .eps = 2.0f, .a = 0.75f},
        {.tau = 2.0f, .t0 = 0.3f, .eps = 4.0f, .a = 0.75f},
        {.tau = 2.0f, .t0 = 0.3f, .eps = 0.125f, .a = (float)NAN},
        {.tau = 2.0f, .t0 = 0.3f, .eps = 0.125f, .a = (float)INFINITY},
        {.tau = 2.0f, .t0 = 0.3f, .eps = 0.125f, .a = 0.0f},
        {.tau = 2.0f, .t0 = 0.3f, .eps = 0.125f, .a = -1.0f},
        {.tau = 2.0f, .t0 = 0.3f, .eps = 0.125f, .a = 7.5e-19f},
        {.tau = 2.0f, .t0 = 0.3f, .eps = 0.125f, .a = 1.25e18f},
        {.tau = 2.0f, .t0 = 0.3f, .eps = 0.125f, .a = 1e-18f},
        {.tau = 2.0f, .t0 = 0.3f, .eps = 0.125f, .a = 1e18f},
        {.tau = 1.6e-17f, .t0 = 0.3f, .eps = 1e-18f, .a = 0.75f},
        {.tau = 1.6e-17f, .t0 = -4943766400000.0f, .eps = 1e-18f, .a = 2.7066957e-5f},
        {.tau = 1e18f, .t0 = -3.906163e-34f, .eps = 3.5730773e-5f, .a = 2.169914e-9f},
    };
    static const float durations[7] = {(float)NAN, (float)INFINITY, 0.0f, -1.0f, 7.5e-19f, 1.25e18f, 2e-7f};
    static const float starts[3] = {(float)NAN, (float)INFINITY, -(float)INFINITY};
    const duration_selftest_session *session = &duration_selftest_sessions[0];
    const duration_selftest_call call = {.t = 0.3f, .x = {0.75f, -1.25f, 0.5f}, .u = -11.312762f, .tolerance = 0.00042972455f, .status = PTC_OK, .axis = PTC_OK, .has_axis = 1U};
    uint32_t failures = 0U;
    duration self;

    if (duration_init(&self, &session->params) != PTC_OK) {
        failures++;
    }
    for (uint32_t i = 0U; i < 27U; i++) {
        if (duration_init(&self, &refused[i]) != PTC_E_PARAM) {
            failures++;
        }
    }
    for (uint32_t i = 0U; i < 3U; i++) {
        if (duration_arm(&self, starts[i]) != PTC_E_PARAM) {
            failures++;
        }
        if (duration_arm_for(&self, starts[i], session->params.tau) != PTC_E_PARAM) {
            failures++;
        }
    }
    for (uint32_t i = 0U; i < 7U; i++) {
        if (duration_arm_for(&self, session->t0, durations[i]) != PTC_E_PARAM) {
            failures++;
        }
    }
    failures += duration_selftest_check(&self, &call);
    if (duration_init(&self, NULL) != PTC_E_PARAM) {
        failures++;
    }
    if (duration_init(NULL, &session->params) != PTC_E_PARAM) {
        failures++;
    }
    if (duration_arm(NULL, session->t0) != PTC_E_PARAM) {
        failures++;
    }
    if (duration_arm_for(NULL, session->t0, session->params.tau) != PTC_E_PARAM) {
        failures++;
    }
    /* A deadline beyond the range, which no legal parameters need to reach. */
    self.tau = 3.4028235e38f;
    if (duration_arm(&self, 3.4028235e38f) != PTC_E_PARAM) {
        failures++;
    }
    return failures;
}

/* 1 where a call without one of its pointers was not refused with u = 0. */
static uint32_t duration_selftest_refused(ptc_status status, float u)
{
    uint32_t failures = 1U;

    if ((status == PTC_E_INPUT) && (fabsf(u) <= 0.0f)) {
        failures = 0U;
    }
    return failures;
}

/* Calls that lack a pointer. */
static uint32_t duration_selftest_pointers(void)
{
    const duration_selftest_session *session = &duration_selftest_sessions[0];
    const duration_selftest_call call = {.t = 0.3f, .x = {0.75f, -1.25f, 0.5f}, .u = -11.312762f, .tolerance = 0.00042972455f, .status = PTC_OK, .axis = PTC_OK, .has_axis = 1U};
    uint32_t failures = 0U;
    float u = 12345.0f;
    ptc_status status;
    duration_gains gains;
    duration self;

    if (duration_init(&self, &session->params) != PTC_OK) {
        failures++;
    }
    status = duration_step(NULL, call.t, call.x, &u);
    failures += duration_selftest_refused(status, u);
    u = 12345.0f;
    status = duration_step(&self, call.t, NULL, &u);
    failures += duration_selftest_refused(status, u);
    status = duration_step(&self, call.t, call.x, NULL);
    failures += duration_selftest_refused(status, 0.0f);
    status = duration_tick(NULL, call.t, &gains);
    failures += duration_selftest_refused(status, 0.0f);
    status = duration_tick(&self, call.t, NULL);
    failures += duration_selftest_refused(status, 0.0f);
    if (duration_tick(&self, call.t, &gains) < PTC_OK) {
        failures++;
    }
    u = 12345.0f;
    status = duration_axis(NULL, call.x, &u);
    failures += duration_selftest_refused(status, u);
    u = 12345.0f;
    status = duration_axis(&gains, NULL, &u);
    failures += duration_selftest_refused(status, u);
    status = duration_axis(&gains, call.x, NULL);
    failures += duration_selftest_refused(status, 0.0f);
    return failures;
}

uint32_t duration_selftest(void)
{
    uint32_t failures = duration_selftest_run();

    failures += duration_selftest_refuse();
    failures += duration_selftest_pointers();
    return failures;
}
