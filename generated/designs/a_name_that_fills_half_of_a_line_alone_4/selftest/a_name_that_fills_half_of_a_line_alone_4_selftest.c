/* Self-test of the prescribed-time controller a_name_that_fills_half_of_a_line_alone_4: see a_name_that_fills_half_of_a_line_alone_4_selftest.h. DO NOT EDIT. */
#include "a_name_that_fills_half_of_a_line_alone_4_selftest.h"
#include "a_name_that_fills_half_of_a_line_alone_4.h"

#include <math.h>
#include <stddef.h>

/* A call, and what it must give. */
typedef struct a_name_that_fills_half_of_a_line_alone_4_selftest_call {
    uint32_t is_armed; /* arm is called before it */
    uint32_t start;
    uint32_t k;
    float y[1]; /* what is measured */
    ptc_status status;
    float u;
    float xhat[2]; /* the estimates behind it */
    float d;
} a_name_that_fills_half_of_a_line_alone_4_selftest_call;

/* A set of parameters that init takes, and the calls with it, one after the other. */
typedef struct a_name_that_fills_half_of_a_line_alone_4_selftest_session {
    a_name_that_fills_half_of_a_line_alone_4_params params;
    uint32_t first; /* of its calls */
    uint32_t count;
} a_name_that_fills_half_of_a_line_alone_4_selftest_session;

static const a_name_that_fills_half_of_a_line_alone_4_selftest_session a_name_that_fills_half_of_a_line_alone_4_selftest_sessions[6] = {
    {.params = {.samples = 60U, .h = 0.015625f, .u_max = (float)INFINITY, .k = {9.0f, 6.0f}, .deadbeat = 0.0f}, .first = 0U, .count = 42U},
    {.params = {.samples = 60U, .h = 0.015625f, .u_max = (float)INFINITY, .k = {9.0f, 0.0f}, .deadbeat = 0.0f}, .first = 42U, .count = 1U},
    {.params = {.samples = 60U, .h = 0.015625f, .u_max = (float)INFINITY, .k = {9.0f, 6.0f}, .deadbeat = 3.4028235e38f}, .first = 43U, .count = 1U},
    {.params = {.samples = 60U, .h = 0.015625f, .u_max = (float)INFINITY, .k = {9.0f, 6.0f}, .deadbeat = 0.0f}, .first = 44U, .count = 4U},
    {.params = {.samples = 60U, .h = 0.015625f, .u_max = (float)INFINITY, .k = {9.0f, 6.0f}, .deadbeat = 0.0f}, .first = 48U, .count = 1U},
    {.params = {.samples = 60U, .h = 0.015625f, .u_max = 1.0f, .k = {9.0f, 6.0f}, .deadbeat = 0.0f}, .first = 49U, .count = 2U},
};

static const a_name_that_fills_half_of_a_line_alone_4_selftest_call a_name_that_fills_half_of_a_line_alone_4_selftest_calls[51] = {
    {.is_armed = 0U, .start = 0U, .k = 0U, .y = {0.75f}, .status = PTC_OK, .u = -1.9525424f, .xhat = {0.75f, 0.0f}, .d = 0.0f},
    {.is_armed = 0U, .start = 0U, .k = 1U, .y = {0.72520834f}, .status = PTC_OK, .u = -1.9298353f, .xhat = {0.7460424f, -0.036314182f}, .d = 0.0f},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {0.7008333f}, .status = PTC_OK, .u = -1.8851764f, .xhat = {0.7382789f, -0.07774559f}, .d = 0.0f},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {(float)NAN}, .status = PTC_E_INPUT, .u = 0.0f, .xhat = {0.7382789f, -0.07774559f}, .d = 0.0f},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {(float)INFINITY}, .status = PTC_E_INPUT, .u = 0.0f, .xhat = {0.7382789f, -0.07774559f}, .d = 0.0f},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {-(float)INFINITY}, .status = PTC_E_INPUT, .u = 0.0f, .xhat = {0.7382789f, -0.07774559f}, .d = 0.0f},
    {.is_armed = 0U, .start = 0U, .k = 3U, .y = {0.676875f}, .status = PTC_OK, .u = -1.8195602f, .xhat = {0.72709703f, -0.12360051f}, .d = 0.0f},
    {.is_armed = 0U, .start = 0U, .k = 15U, .y = {0.421875f}, .status = PTC_OK, .u = -1.7384892f, .xhat = {0.63835263f, -0.42912257f}, .d = 0.0f},
    {.is_armed = 0U, .start = 0U, .k = 26U, .y = {0.24083333f}, .status = PTC_OK, .u = 1742.7081f, .xhat = {0.24083334f, -37.954082f}, .d = -1599.906f},
    {.is_armed = 0U, .start = 0U, .k = 28U, .y = {0.21333334f}, .status = PTC_OK, .u = -715.62964f, .xhat = {0.21333337f, 16.894867f}, .d = 645.1145f},
    {.is_armed = 0U, .start = 0U, .k = 29U, .y = {0.20020834f}, .status = PTC_OK, .u = 494.4962f, .xhat = {0.20020834f, -9.982883f}, .d = -454.65942f},
    {.is_armed = 0U, .start = 0U, .k = 30U, .y = {0.1875f}, .status = PTC_OK, .u = -131.26779f, .xhat = {0.1875f, 3.9270535f}, .d = 112.27338f},
    {.is_armed = 0U, .start = 0U, .k = 31U, .y = {0.17520833f}, .status = PTC_OK, .u = 192.34325f, .xhat = {0.17520833f, -3.2177243f}, .d = -179.90753f},
    {.is_armed = 0U, .start = 0U, .k = 45U, .y = {0.046875f}, .status = PTC_OK, .u = 597.61774f, .xhat = {0.046875f, -10.66256f}, .d = -505.84436f},
    {.is_armed = 0U, .start = 0U, .k = 56U, .y = {0.0033333334f}, .status = PTC_OK, .u = -110.91724f, .xhat = {0.0033333302f, 1.5097685f}, .d = -47.67386f},
    {.is_armed = 0U, .start = 0U, .k = 58U, .y = {0.00083333335f}, .status = PTC_OK, .u = 226.81067f, .xhat = {0.00083333347f, -1.6143804f}, .d = -75.243484f},
    {.is_armed = 0U, .start = 0U, .k = 59U, .y = {0.00020833334f}, .status = PTC_OK, .u = -79.154526f, .xhat = {0.00020833313f, 1.3392494f}, .d = -50.26674f},
    {.is_armed = 0U, .start = 0U, .k = 60U, .y = {0.0f}, .status = PTC_AFTER, .u = 0.0f, .xhat = {0.0f, -1.1951765f}, .d = -72.1214f},
    {.is_armed = 0U, .start = 0U, .k = 61U, .y = {0.0f}, .status = PTC_AFTER, .u = 0.0f, .xhat = {0.0f, 0.31586385f}, .d = 40.430595f},
    {.is_armed = 0U, .start = 0U, .k = 2147483647U, .y = {0.0f}, .status = PTC_AFTER, .u = 0.0f, .xhat = {0.0f, 1.1920929e-7f}, .d = 1.1444092e-5f},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {0.0f}, .status = PTC_AFTER, .u = 0.0f, .xhat = {0.0f, -1.4901161e-8f}, .d = -1.9073486e-6f},
    {.is_armed = 1U, .start = 4294967293U, .k = 4294967293U, .y = {0.75f}, .status = PTC_OK, .u = -0.6418683f, .xhat = {0.109913796f, 0.16551721f}, .d = -1.9073486e-6f},
    {.is_armed = 0U, .start = 0U, .k = 4294967294U, .y = {0.72520834f}, .status = PTC_OK, .u = -1.2093518f, .xhat = {0.20524526f, 0.3003834f}, .d = -1.9073486e-6f},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {0.7008333f}, .status = PTC_OK, .u = -1.7027011f, .xhat = {0.28676003f, 0.40619636f}, .d = -1.9073486e-6f},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {(float)NAN}, .status = PTC_E_INPUT, .u = 0.0f, .xhat = {0.28676003f, 0.40619636f}, .d = -1.9073486e-6f},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {(float)INFINITY}, .status = PTC_E_INPUT, .u = 0.0f, .xhat = {0.28676003f, 0.40619636f}, .d = -1.9073486e-6f},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {-(float)INFINITY}, .status = PTC_E_INPUT, .u = 0.0f, .xhat = {0.28676003f, 0.40619636f}, .d = -1.9073486e-6f},
    {.is_armed = 0U, .start = 0U, .k = 0U, .y = {0.676875f}, .status = PTC_OK, .u = -2.1224446f, .xhat = {0.35525408f, 0.48461068f}, .d = -1.9073486e-6f},
    {.is_armed = 0U, .start = 0U, .k = 12U, .y = {0.421875f}, .status = PTC_OK, .u = -3.2191122f, .xhat = {0.37951216f, 0.50567186f}, .d = -1.9073486e-6f},
    {.is_armed = 0U, .start = 0U, .k = 23U, .y = {0.24083333f}, .status = PTC_OK, .u = 648.60095f, .xhat = {0.24083333f, -13.578582f}, .d = -598.78204f},
    {.is_armed = 0U, .start = 0U, .k = 25U, .y = {0.21333334f}, .status = PTC_OK, .u = -152.30055f, .xhat = {0.21333334f, 4.343897f}, .d = 132.69781f},
    {.is_armed = 0U, .start = 0U, .k = 26U, .y = {0.20020834f}, .status = PTC_OK, .u = 201.98427f, .xhat = {0.20020834f, -3.508521f}, .d = -189.2702f},
    {.is_armed = 0U, .start = 0U, .k = 27U, .y = {0.1875f}, .status = PTC_OK, .u = 18.620052f, .xhat = {0.1875f, 0.58392406f}, .d = -23.135254f},
    {.is_armed = 0U, .start = 0U, .k = 28U, .y = {0.17520833f}, .status = PTC_OK, .u = 113.2844f, .xhat = {0.17520833f, -1.4895995f}, .d = -108.59546f},
    {.is_armed = 0U, .start = 0U, .k = 42U, .y = {0.046875f}, .status = PTC_OK, .u = 640.90234f, .xhat = {0.046875f, -11.556885f}, .d = -541.2589f},
    {.is_armed = 0U, .start = 0U, .k = 53U, .y = {0.0033333334f}, .status = PTC_OK, .u = -174.68341f, .xhat = {0.0033333302f, 1.9876747f}, .d = -29.786682f},
    {.is_armed = 0U, .start = 0U, .k = 55U, .y = {0.00083333335f}, .status = PTC_OK, .u = 256.7141f, .xhat = {0.00083333347f, -2.0325484f}, .d = -65.00281f},
    {.is_armed = 0U, .start = 0U, .k = 56U, .y = {0.00020833334f}, .status = PTC_OK, .u = -131.21204f, .xhat = {0.00020833313f, 1.7051466f}, .d = -33.335358f},
    {.is_armed = 0U, .start = 0U, .k = 57U, .y = {0.0f}, .status = PTC_AFTER, .u = 0.0f, .xhat = {0.0f, -1.5153365f}, .d = -61.044373f},
    {.is_armed = 0U, .start = 0U, .k = 58U, .y = {0.0f}, .status = PTC_AFTER, .u = 0.0f, .xhat = {0.0f, 0.5192137f}, .d = 66.45935f},
    {.is_armed = 0U, .start = 0U, .k = 2147483644U, .y = {0.0f}, .status = PTC_AFTER, .u = 0.0f, .xhat = {0.0f, 0.0f}, .d = 0.0f},
    {.is_armed = 0U, .start = 0U, .k = 4294967292U, .y = {0.0f}, .status = PTC_AFTER, .u = 0.0f, .xhat = {0.0f, 0.0f}, .d = 0.0f},
    {.is_armed = 0U, .start = 0U, .k = 0U, .y = {0.0f}, .status = PTC_OK, .u = 0.0f, .xhat = {0.0f, 0.0f}, .d = 0.0f},
    {.is_armed = 0U, .start = 0U, .k = 0U, .y = {0.0f}, .status = PTC_OK, .u = -0.0f, .xhat = {0.0f, 0.0f}, .d = 0.0f},
    {.is_armed = 0U, .start = 0U, .k = 24U, .y = {-0.5711237f}, .status = PTC_OK, .u = 4.177362f, .xhat = {-0.5711237f, 0.0f}, .d = 0.0f},
    {.is_armed = 0U, .start = 0U, .k = 25U, .y = {0.90159416f}, .status = PTC_OK, .u = 6468.9f, .xhat = {0.9015942f, 42.46486f}, .d = -6633.1807f},
    {.is_armed = 1U, .start = 4294967290U, .k = 4294967289U, .y = {-1.132438e19f}, .status = PTC_AFTER, .u = 0.0f, .xhat = {-1.132438e19f, -1.0871405e21f}, .d = -4.638466e22f},
    {.is_armed = 1U, .start = 0U, .k = 56U, .y = {1.0127787e19f}, .status = PTC_OK, .u = -4.1483417e22f, .xhat = {1.0127787e19f, 0.0f}, .d = 0.0f},
    {.is_armed = 1U, .start = 4294967290U, .k = 44U, .y = {-2.818105e38f}, .status = PTC_E_RANGE, .u = 0.0f, .xhat = {0.0f, 0.0f}, .d = 0.0f},
    {.is_armed = 0U, .start = 0U, .k = 0U, .y = {0.5702025f}, .status = PTC_SATURATED, .u = -1.0f, .xhat = {0.5702025f, 0.0f}, .d = 0.0f},
    {.is_armed = 0U, .start = 0U, .k = 11U, .y = {-0.9303121f}, .status = PTC_SATURATED, .u = 1.0f, .xhat = {0.22788566f, -0.8579506f}, .d = 0.0f},
};

/* 1 where a number is not the one that must come. */
static uint32_t a_name_that_fills_half_of_a_line_alone_4_selftest_differs(float value, float wanted)
{
    uint32_t failures = 1U;

    if (fabsf(value - wanted) <= 0.0f) {
        failures = 0U;
    }
    return failures;
}

/* The failures of one call. */
static uint32_t a_name_that_fills_half_of_a_line_alone_4_selftest_check(a_name_that_fills_half_of_a_line_alone_4 *self, const a_name_that_fills_half_of_a_line_alone_4_selftest_call *call)
{
    uint32_t failures = 0U;
    float u = 12345.0f;
    float xhat[2] = {12345.0f, 12345.0f};
    float d = 12345.0f;

    if (call->is_armed != 0U) {
        if (a_name_that_fills_half_of_a_line_alone_4_arm(self, call->start) != PTC_OK) {
            failures++;
        }
    }
    if (a_name_that_fills_half_of_a_line_alone_4_step(self, call->k, call->y, &u) != call->status) {
        failures++;
    }
    failures += a_name_that_fills_half_of_a_line_alone_4_selftest_differs(u, call->u);
    if (a_name_that_fills_half_of_a_line_alone_4_estimate(self, xhat) != PTC_OK) {
        failures++;
    }
    for (uint32_t i = 0U; i < 2U; i++) {
        failures += a_name_that_fills_half_of_a_line_alone_4_selftest_differs(xhat[i], call->xhat[i]);
    }
    if (a_name_that_fills_half_of_a_line_alone_4_disturbance(self, &d) != PTC_OK) {
        failures++;
    }
    failures += a_name_that_fills_half_of_a_line_alone_4_selftest_differs(d, call->d);
    return failures;
}

/* The calls of a session, of which init has been called. */
static uint32_t a_name_that_fills_half_of_a_line_alone_4_selftest_calls_of(a_name_that_fills_half_of_a_line_alone_4 *self, const a_name_that_fills_half_of_a_line_alone_4_selftest_session *session)
{
    uint32_t failures = 0U;

    for (uint32_t j = 0U; j < session->count; j++) {
        failures += a_name_that_fills_half_of_a_line_alone_4_selftest_check(self, &a_name_that_fills_half_of_a_line_alone_4_selftest_calls[session->first + j]);
    }
    return failures;
}

/* Every session with its calls. */
static uint32_t a_name_that_fills_half_of_a_line_alone_4_selftest_run(void)
{
    uint32_t failures = 0U;

    for (uint32_t i = 0U; i < 6U; i++) {
        const a_name_that_fills_half_of_a_line_alone_4_selftest_session *session = &a_name_that_fills_half_of_a_line_alone_4_selftest_sessions[i];
        a_name_that_fills_half_of_a_line_alone_4 self;

        if (a_name_that_fills_half_of_a_line_alone_4_init(&self, &session->params) == PTC_OK) {
            failures += a_name_that_fills_half_of_a_line_alone_4_selftest_calls_of(&self, session);
        } else {
            failures++;
        }
    }
    return failures;
}

/* What init must refuse without a change. */
static uint32_t a_name_that_fills_half_of_a_line_alone_4_selftest_refuse(void)
{
    static const a_name_that_fills_half_of_a_line_alone_4_params refused[34] = {
        {.samples = 0U, .h = 0.015625f, .u_max = (float)INFINITY, .k = {9.0f, 6.0f}, .deadbeat = 0.0f},
        {.samples = 5U, .h = 0.015625f, .u_max = (float)INFINITY, .k = {9.0f, 6.0f}, .deadbeat = 0.0f},
        {.samples = 60U, .h = (float)NAN, .u_max = (float)INFINITY, .k = {9.0f, 6.0f}, .deadbeat = 0.0f},
        {.samples = 60U, .h = (float)INFINITY, .u_max = (float)INFINITY, .k = {9.0f, 6.0f}, .deadbeat = 0.0f},
        {.samples = 60U, .h = -(float)INFINITY, .u_max = (float)INFINITY, .k = {9.0f, 6.0f}, .deadbeat = 0.0f},
        {.samples = 60U, .h = 0.0f, .u_max = (float)INFINITY, .k = {9.0f, 6.0f}, .deadbeat = 0.0f},
        {.samples = 60U, .h = -1.0f, .u_max = (float)INFINITY, .k = {9.0f, 6.0f}, .deadbeat = 0.0f},
        {.samples = 60U, .h = 3.4028235e38f, .u_max = (float)INFINITY, .k = {9.0f, 6.0f}, .deadbeat = 0.0f},
        {.samples = 60U, .h = -3.4028235e38f, .u_max = (float)INFINITY, .k = {9.0f, 6.0f}, .deadbeat = 0.0f},
        {.samples = 60U, .h = 1e-45f, .u_max = (float)INFINITY, .k = {9.0f, 6.0f}, .deadbeat = 0.0f},
        {.samples = 60U, .h = 7.5e-19f, .u_max = (float)INFINITY, .k = {9.0f, 6.0f}, .deadbeat = 0.0f},
        {.samples = 60U, .h = 1e-18f, .u_max = (float)INFINITY, .k = {9.0f, 6.0f}, .deadbeat = 0.0f},
        {.samples = 60U, .h = 1e18f, .u_max = (float)INFINITY, .k = {9.0f, 6.0f}, .deadbeat = 0.0f},
        {.samples = 60U, .h = 1.25e18f, .u_max = (float)INFINITY, .k = {9.0f, 6.0f}, .deadbeat = 0.0f},
        {.samples = 60U, .h = 0.015625f, .u_max = (float)NAN, .k = {9.0f, 6.0f}, .deadbeat = 0.0f},
        {.samples = 60U, .h = 0.015625f, .u_max = -(float)INFINITY, .k = {9.0f, 6.0f}, .deadbeat = 0.0f},
        {.samples = 60U, .h = 0.015625f, .u_max = 0.0f, .k = {9.0f, 6.0f}, .deadbeat = 0.0f},
        {.samples = 60U, .h = 0.015625f, .u_max = -1.0f, .k = {9.0f, 6.0f}, .deadbeat = 0.0f},
        {.samples = 60U, .h = 0.015625f, .u_max = -3.4028235e38f, .k = {9.0f, 6.0f}, .deadbeat = 0.0f},
        {.samples = 60U, .h = 0.015625f, .u_max = (float)INFINITY, .k = {(float)NAN, 6.0f}, .deadbeat = 0.0f},
        {.samples = 60U, .h = 0.015625f, .u_max = (float)INFINITY, .k = {(float)INFINITY, 6.0f}, .deadbeat = 0.0f},
        {.samples = 60U, .h = 0.015625f, .u_max = (float)INFINITY, .k = {-(float)INFINITY, 6.0f}, .deadbeat = 0.0f},
        {.samples = 60U, .h = 0.015625f, .u_max = (float)INFINITY, .k = {3.4028235e38f, 6.0f}, .deadbeat = 0.0f},
        {.samples = 60U, .h = 0.015625f, .u_max = (float)INFINITY, .k = {-3.4028235e38f, 6.0f}, .deadbeat = 0.0f},
        {.samples = 60U, .h = 0.015625f, .u_max = (float)INFINITY, .k = {9.0f, (float)NAN}, .deadbeat = 0.0f},
        {.samples = 60U, .h = 0.015625f, .u_max = (float)INFINITY, .k = {9.0f, (float)INFINITY}, .deadbeat = 0.0f},
        {.samples = 60U, .h = 0.015625f, .u_max = (float)INFINITY, .k = {9.0f, -(float)INFINITY}, .deadbeat = 0.0f},
        {.samples = 60U, .h = 0.015625f, .u_max = (float)INFINITY, .k = {9.0f, 3.4028235e38f}, .deadbeat = 0.0f},
        {.samples = 60U, .h = 0.015625f, .u_max = (float)INFINITY, .k = {9.0f, -3.4028235e38f}, .deadbeat = 0.0f},
        {.samples = 60U, .h = 0.015625f, .u_max = (float)INFINITY, .k = {9.0f, 6.0f}, .deadbeat = (float)NAN},
        {.samples = 60U, .h = 0.015625f, .u_max = (float)INFINITY, .k = {9.0f, 6.0f}, .deadbeat = (float)INFINITY},
        {.samples = 60U, .h = 0.015625f, .u_max = (float)INFINITY, .k = {9.0f, 6.0f}, .deadbeat = -(float)INFINITY},
        {.samples = 60U, .h = 0.015625f, .u_max = (float)INFINITY, .k = {9.0f, 6.0f}, .deadbeat = -1.0f},
        {.samples = 60U, .h = 0.015625f, .u_max = (float)INFINITY, .k = {9.0f, 6.0f}, .deadbeat = -3.4028235e38f},
    };
    const a_name_that_fills_half_of_a_line_alone_4_selftest_session *session = &a_name_that_fills_half_of_a_line_alone_4_selftest_sessions[0];
    uint32_t failures = 0U;
    a_name_that_fills_half_of_a_line_alone_4 self;

    if (a_name_that_fills_half_of_a_line_alone_4_init(&self, &session->params) != PTC_OK) {
        failures++;
    }
    for (uint32_t i = 0U; i < 34U; i++) {
        if (a_name_that_fills_half_of_a_line_alone_4_init(&self, &refused[i]) != PTC_E_PARAM) {
            failures++;
        }
    }
    if (a_name_that_fills_half_of_a_line_alone_4_init(&self, NULL) != PTC_E_PARAM) {
        failures++;
    }
    if (a_name_that_fills_half_of_a_line_alone_4_init(NULL, &session->params) != PTC_E_PARAM) {
        failures++;
    }
    failures += a_name_that_fills_half_of_a_line_alone_4_selftest_calls_of(&self, session);
    return failures;
}

/* Calls that lack a pointer: each is refused, and changes nothing. */
static uint32_t a_name_that_fills_half_of_a_line_alone_4_selftest_pointers(void)
{
    const a_name_that_fills_half_of_a_line_alone_4_selftest_session *session = &a_name_that_fills_half_of_a_line_alone_4_selftest_sessions[0];
    const a_name_that_fills_half_of_a_line_alone_4_selftest_call *call = &a_name_that_fills_half_of_a_line_alone_4_selftest_calls[0];
    uint32_t failures = 0U;
    float u = 12345.0f;
    float xhat[2];
    float d;
    a_name_that_fills_half_of_a_line_alone_4 self;

    if (a_name_that_fills_half_of_a_line_alone_4_init(&self, &session->params) != PTC_OK) {
        failures++;
    }
    if (a_name_that_fills_half_of_a_line_alone_4_arm(NULL, call->start) != PTC_E_INPUT) {
        failures++;
    }
    if (a_name_that_fills_half_of_a_line_alone_4_step(NULL, call->k, call->y, &u) != PTC_E_INPUT) {
        failures++;
    }
    failures += a_name_that_fills_half_of_a_line_alone_4_selftest_differs(u, 0.0f);
    u = 12345.0f;
    if (a_name_that_fills_half_of_a_line_alone_4_step(&self, call->k, NULL, &u) != PTC_E_INPUT) {
        failures++;
    }
    failures += a_name_that_fills_half_of_a_line_alone_4_selftest_differs(u, 0.0f);
    if (a_name_that_fills_half_of_a_line_alone_4_step(&self, call->k, call->y, NULL) != PTC_E_INPUT) {
        failures++;
    }
    if (a_name_that_fills_half_of_a_line_alone_4_estimate(NULL, xhat) != PTC_E_INPUT) {
        failures++;
    }
    if (a_name_that_fills_half_of_a_line_alone_4_estimate(&self, NULL) != PTC_E_INPUT) {
        failures++;
    }
    if (a_name_that_fills_half_of_a_line_alone_4_disturbance(NULL, &d) != PTC_E_INPUT) {
        failures++;
    }
    if (a_name_that_fills_half_of_a_line_alone_4_disturbance(&self, NULL) != PTC_E_INPUT) {
        failures++;
    }
    failures += a_name_that_fills_half_of_a_line_alone_4_selftest_calls_of(&self, session);
    return failures;
}

uint32_t a_name_that_fills_half_of_a_line_alone_4_selftest(void)
{
    uint32_t failures = a_name_that_fills_half_of_a_line_alone_4_selftest_run();

    failures += a_name_that_fills_half_of_a_line_alone_4_selftest_refuse();
    failures += a_name_that_fills_half_of_a_line_alone_4_selftest_pointers();
    return failures;
}
