/* Self-test of the prescribed-time controller masses_refuse: see masses_refuse_selftest.h. DO NOT EDIT. */
#include "masses_refuse_selftest.h"
#include "masses_refuse.h"

#include <math.h>
#include <stddef.h>

/* A call, and what it must give. */
typedef struct masses_refuse_selftest_call {
    uint32_t is_armed; /* arm is called before it */
    uint32_t start;
    uint32_t command; /* called before it: 0 none, 1 arm_for, 2 soonest, 3 deadline, 4 assume, 5 assume_disturbance, 6 applied */
    uint32_t samples;
    float given[2];
    ptc_status told; /* its status */
    uint32_t found; /* its result */
    uint32_t k;
    float y[1]; /* what is measured */
    ptc_status status;
    float u;
    float xhat[2]; /* the estimates behind it */
    float d;
} masses_refuse_selftest_call;

/* A set of parameters that init takes, and the calls with it, one after the other. */
typedef struct masses_refuse_selftest_session {
    masses_refuse_params params;
    uint32_t first; /* of its calls */
    uint32_t count;
} masses_refuse_selftest_session;

static const masses_refuse_selftest_session masses_refuse_selftest_sessions[4] = {
    {.params = {.none = (char)0}, .first = 0U, .count = 42U},
    {.params = {.none = (char)0}, .first = 42U, .count = 2U},
    {.params = {.none = (char)0}, .first = 44U, .count = 1U},
    {.params = {.none = (char)0}, .first = 45U, .count = 16U},
};

static const masses_refuse_selftest_call masses_refuse_selftest_calls[61] = {
    {.is_armed = 0U, .start = 0U, .k = 0U, .y = {0.75f}, .status = PTC_OK, .u = 0.4134516f, .xhat = {0.75f, 0.0f}, .d = 0.0f},
    {.is_armed = 0U, .start = 0U, .k = 1U, .y = {0.676875f}, .status = PTC_OK, .u = 1.6456693f, .xhat = {0.735149f, -2.9504375f}, .d = 0.0f},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {0.6075f}, .status = PTC_SATURATED, .u = 10.0f, .xhat = {0.47449782f, -26.362404f}, .d = -26.609303f},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {(float)NAN}, .status = PTC_E_INPUT, .u = 0.0f, .xhat = {0.47449782f, -26.362404f}, .d = -26.609303f},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {(float)INFINITY}, .status = PTC_E_INPUT, .u = 0.0f, .xhat = {0.47449782f, -26.362404f}, .d = -26.609303f},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {-(float)INFINITY}, .status = PTC_E_INPUT, .u = 0.0f, .xhat = {0.47449782f, -26.362404f}, .d = -26.609303f},
    {.is_armed = 0U, .start = 0U, .k = 3U, .y = {0.541875f}, .status = PTC_SATURATED, .u = -10.0f, .xhat = {0.65371907f, 10.461918f}, .d = 34.12265f},
    {.is_armed = 0U, .start = 0U, .k = 5U, .y = {0.421875f}, .status = PTC_SATURATED, .u = 10.0f, .xhat = {0.41283074f, -15.084393f}, .d = -16.947998f},
    {.is_armed = 0U, .start = 0U, .k = 6U, .y = {0.3675f}, .status = PTC_SATURATED, .u = 10.0f, .xhat = {0.23676178f, -23.486097f}, .d = -12.818174f},
    {.is_armed = 0U, .start = 0U, .k = 8U, .y = {0.27f}, .status = PTC_SATURATED, .u = -10.0f, .xhat = {0.4843639f, 22.063715f}, .d = 46.879997f},
    {.is_armed = 0U, .start = 0U, .k = 9U, .y = {0.226875f}, .status = PTC_SATURATED, .u = 10.0f, .xhat = {0.0028530583f, -34.84685f}, .d = -51.00364f},
    {.is_armed = 0U, .start = 0U, .k = 10U, .y = {0.1875f}, .status = PTC_SATURATED, .u = -10.0f, .xhat = {0.37694454f, 22.47653f}, .d = 51.290085f},
    {.is_armed = 0U, .start = 0U, .k = 11U, .y = {0.151875f}, .status = PTC_SATURATED, .u = 10.0f, .xhat = {0.003530763f, -23.398687f}, .d = -35.214783f},
    {.is_armed = 0U, .start = 0U, .k = 15U, .y = {0.046875f}, .status = PTC_SATURATED, .u = -10.0f, .xhat = {0.2384919f, 12.670626f}, .d = 32.522713f},
    {.is_armed = 0U, .start = 0U, .k = 16U, .y = {0.03f}, .status = PTC_SATURATED, .u = 10.0f, .xhat = {-0.27390394f, -40.43116f}, .d = -54.9741f},
    {.is_armed = 0U, .start = 0U, .k = 18U, .y = {0.0075f}, .status = PTC_SATURATED, .u = -10.0f, .xhat = {0.34157696f, 45.150757f}, .d = 83.79563f},
    {.is_armed = 0U, .start = 0U, .k = 19U, .y = {0.001875f}, .status = PTC_SATURATED, .u = 10.0f, .xhat = {-0.2845793f, -40.314823f}, .d = -68.75182f},
    {.is_armed = 0U, .start = 0U, .k = 20U, .y = {0.0f}, .status = PTC_SATURATED, .u = -10.0f, .xhat = {0.23972848f, 33.656376f}, .d = 62.05001f},
    {.is_armed = 0U, .start = 0U, .k = 21U, .y = {0.0f}, .status = PTC_SATURATED, .u = 10.0f, .xhat = {-0.18773058f, -25.834707f}, .d = -47.415695f},
    {.is_armed = 0U, .start = 0U, .k = 2147483647U, .y = {0.0f}, .status = PTC_SATURATED, .u = -10.0f, .xhat = {0.1501725f, 20.34112f}, .d = 38.306534f},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {0.0f}, .status = PTC_SATURATED, .u = 10.0f, .xhat = {-0.11861674f, -15.648432f}, .d = -30.265785f},
    {.is_armed = 1U, .start = 4294967293U, .k = 4294967293U, .y = {0.75f}, .status = PTC_SATURATED, .u = -10.0f, .xhat = {0.09362883f, 11.932093f}, .d = 23.897427f},
    {.is_armed = 0U, .start = 0U, .k = 4294967294U, .y = {0.676875f}, .status = PTC_SATURATED, .u = -10.0f, .xhat = {2.7305245f, 258.69855f}, .d = 323.61206f},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {0.6075f}, .status = PTC_SATURATED, .u = 10.0f, .xhat = {-1.8372346f, -371.8665f}, .d = -614.13293f},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {(float)NAN}, .status = PTC_E_INPUT, .u = 0.0f, .xhat = {-1.8372346f, -371.8665f}, .d = -614.13293f},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {(float)INFINITY}, .status = PTC_E_INPUT, .u = 0.0f, .xhat = {-1.8372346f, -371.8665f}, .d = -614.13293f},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {-(float)INFINITY}, .status = PTC_E_INPUT, .u = 0.0f, .xhat = {-1.8372346f, -371.8665f}, .d = -614.13293f},
    {.is_armed = 0U, .start = 0U, .k = 0U, .y = {0.541875f}, .status = PTC_SATURATED, .u = -10.0f, .xhat = {2.447313f, 277.08035f}, .d = 502.1908f},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {0.421875f}, .status = PTC_SATURATED, .u = 10.0f, .xhat = {-0.98665893f, -222.07756f}, .d = -367.87738f},
    {.is_armed = 0U, .start = 0U, .k = 3U, .y = {0.3675f}, .status = PTC_SATURATED, .u = -10.0f, .xhat = {1.3672839f, 144.64699f}, .d = 275.2926f},
    {.is_armed = 0U, .start = 0U, .k = 5U, .y = {0.27f}, .status = PTC_SATURATED, .u = 10.0f, .xhat = {-0.41065606f, -111.050415f}, .d = -181.23242f},
    {.is_armed = 0U, .start = 0U, .k = 6U, .y = {0.226875f}, .status = PTC_SATURATED, .u = -10.0f, .xhat = {0.67173696f, 62.65759f}, .d = 129.57126f},
    {.is_armed = 0U, .start = 0U, .k = 7U, .y = {0.1875f}, .status = PTC_SATURATED, .u = 10.0f, .xhat = {-0.11238215f, -46.33125f}, .d = -73.56325f},
    {.is_armed = 0U, .start = 0U, .k = 8U, .y = {0.151875f}, .status = PTC_SATURATED, .u = -10.0f, .xhat = {0.39002725f, 30.099874f}, .d = 63.37004f},
    {.is_armed = 0U, .start = 0U, .k = 12U, .y = {0.046875f}, .status = PTC_SATURATED, .u = 10.0f, .xhat = {-0.06687782f, -28.760221f}, .d = -45.375916f},
    {.is_armed = 0U, .start = 0U, .k = 13U, .y = {0.03f}, .status = PTC_HOLD, .u = 4.815439f, .xhat = {-0.032715403f, -8.545919f}, .d = 6.5663147f},
    {.is_armed = 0U, .start = 0U, .k = 15U, .y = {0.0075f}, .status = PTC_SATURATED, .u = -10.0f, .xhat = {0.15119159f, 20.821407f}, .d = 35.20365f},
    {.is_armed = 0U, .start = 0U, .k = 16U, .y = {0.001875f}, .status = PTC_SATURATED, .u = 10.0f, .xhat = {-0.10507131f, -16.138166f}, .d = -30.40934f},
    {.is_armed = 0U, .start = 0U, .k = 17U, .y = {0.0f}, .status = PTC_SATURATED, .u = -10.0f, .xhat = {0.058167733f, 7.1865444f}, .d = 18.424881f},
    {.is_armed = 0U, .start = 0U, .k = 18U, .y = {0.0f}, .status = PTC_SATURATED, .u = 10.0f, .xhat = {-0.03351962f, -2.904949f}, .d = -8.135883f},
    {.is_armed = 0U, .start = 0U, .k = 2147483644U, .y = {0.0f}, .status = PTC_SATURATED, .u = -10.0f, .xhat = {0.027998492f, 2.1708295f}, .d = 7.1699686f},
    {.is_armed = 0U, .start = 0U, .k = 4294967292U, .y = {0.0f}, .status = PTC_SATURATED, .u = 10.0f, .xhat = {-0.021898441f, -1.2636454f}, .d = -5.614806f},
    {.is_armed = 0U, .start = 0U, .k = 16U, .y = {9.95417e18f}, .status = PTC_SATURATED, .u = -10.0f, .xhat = {9.95417e18f, 0.0f}, .d = 0.0f},
    {.is_armed = 1U, .start = 0U, .k = 6U, .y = {-5.997339e18f}, .status = PTC_SATURATED, .u = 10.0f, .xhat = {-5.997339e18f, 0.0f}, .d = 0.0f},
    {.is_armed = 1U, .start = 0U, .k = 21U, .y = {-2.2790595e38f}, .status = PTC_E_RANGE, .u = 0.0f, .xhat = {0.0f, 0.0f}, .d = 0.0f},
    {.command = 1U, .samples = 1024U, .told = PTC_E_PARAM, .found = 0U, .is_armed = 0U, .start = 0U, .k = 20U, .y = {-0.060327698f}, .status = PTC_HOLD, .u = 4.8187814f, .xhat = {-0.060327698f, 0.0f}, .d = 0.0f},
    {.command = 2U, .samples = 1024U, .told = PTC_OK, .found = 6U, .is_armed = 0U, .start = 0U, .k = 7U, .y = {-37.328537f}, .status = PTC_OK, .u = -1.6497154f, .xhat = {-0.059133135f, 0.23732413f}, .d = 0.0f},
    {.command = 3U, .samples = 1024U, .told = PTC_OK, .found = 20U, .is_armed = 0U, .start = 0U, .k = 20U, .y = {-0.034302898f}, .status = PTC_SATURATED, .u = 10.0f, .xhat = {-139.40248f, -13299.77f}, .d = -17018.094f},
    {.command = 4U, .samples = 1024U, .told = PTC_OK, .given = {0.36151993f, -0.06743188f}, .found = 0U, .is_armed = 0U, .start = 0U, .k = 7U, .y = {-0.041697327f}, .status = PTC_SATURATED, .u = -10.0f, .xhat = {0.36151993f, -0.06743187f}, .d = 46620.72f},
    {.command = 5U, .samples = 1024U, .told = PTC_OK, .given = {0.00086030003f}, .found = 0U, .is_armed = 0U, .start = 0U, .k = 10U, .y = {0.071741514f}, .status = PTC_SATURATED, .u = -10.0f, .xhat = {91.1808f, 18198.732f}, .d = 0.00086030003f},
    {.command = 6U, .samples = 1024U, .told = PTC_OK, .given = {0.0f}, .found = 0U, .is_armed = 0U, .start = 0U, .k = 7U, .y = {-0.012019262f}, .status = PTC_SATURATED, .u = 10.0f, .xhat = {-72.33538f, -15400.693f}, .d = -41602.555f},
    {.command = 1U, .samples = 10U, .told = PTC_E_SOON, .found = 0U, .is_armed = 0U, .start = 0U, .k = 1U, .y = {0.059317794f}, .status = PTC_SATURATED, .u = 10.0f, .xhat = {-34.315216f, -5060.832f}, .d = -8577.992f},
    {.command = 2U, .samples = 200U, .told = PTC_E_SOON, .found = 0U, .is_armed = 0U, .start = 0U, .k = 2U, .y = {0.5392484f}, .status = PTC_SATURATED, .u = -10.0f, .xhat = {28.158298f, 4172.235f}, .d = 7118.2344f},
    {.command = 1U, .samples = 40U, .told = PTC_E_SOON, .found = 0U, .is_armed = 0U, .start = 0U, .k = 2U, .y = {0.0002960724f}, .status = PTC_SATURATED, .u = 10.0f, .xhat = {-20.523525f, -3156.7717f}, .d = -5493.2783f},
    {.command = 2U, .samples = 0U, .told = PTC_E_SOON, .found = 0U, .is_armed = 0U, .start = 0U, .k = 1U, .y = {3.4028235e38f}, .status = PTC_E_RANGE, .u = 0.0f, .xhat = {-20.523525f, -3156.7717f}, .d = -5493.2783f},
    {.command = 1U, .samples = 3U, .told = PTC_E_SOON, .found = 0U, .is_armed = 0U, .start = 0U, .k = 10U, .y = {-0.0005527127f}, .status = PTC_SATURATED, .u = -10.0f, .xhat = {14.68139f, 2208.9465f}, .d = 3878.3848f},
    {.command = 1U, .samples = 1U, .told = PTC_E_PARAM, .found = 0U, .is_armed = 0U, .start = 0U, .k = 7U, .y = {-0.00015645879f}, .status = PTC_SATURATED, .u = 10.0f, .xhat = {-11.08347f, -1646.5912f}, .d = -2825.7383f},
    {.command = 4U, .samples = 200U, .told = PTC_E_INPUT, .given = {(float)NAN, 0.07614107f}, .found = 0U, .is_armed = 0U, .start = 0U, .k = 2U, .y = {-0.7038512f}, .status = PTC_SATURATED, .u = -10.0f, .xhat = {8.769307f, 1302.2826f}, .d = 2235.1655f},
    {.command = 5U, .samples = 3U, .told = PTC_E_INPUT, .given = {(float)NAN}, .found = 0U, .is_armed = 0U, .start = 0U, .k = 10U, .y = {-0.033068437f}, .status = PTC_SATURATED, .u = 10.0f, .xhat = {-9.572621f, -1281.5294f}, .d = -2090.503f},
    {.command = 4U, .samples = 2147483648U, .told = PTC_E_INPUT, .given = {0.25256634f, (float)INFINITY}, .found = 0U, .is_armed = 0U, .start = 0U, .k = 20U, .y = {-3.4028235e38f}, .status = PTC_E_RANGE, .u = 0.0f, .xhat = {-9.572621f, -1281.5294f}, .d = -2090.503f},
    {.command = 6U, .samples = 10U, .told = PTC_E_INPUT, .given = {(float)NAN}, .found = 0U, .is_armed = 0U, .start = 0U, .k = 2U, .y = {-3.4028235e38f}, .status = PTC_E_RANGE, .u = 0.0f, .xhat = {-9.572621f, -1281.5294f}, .d = -2090.503f},
};

/* 1 where a number is not the one that must come. */
static uint32_t masses_refuse_selftest_differs(float value, float wanted)
{
    uint32_t failures = 1U;

    if (fabsf(value - wanted) <= 0.0f) {
        failures = 0U;
    }
    return failures;
}

/* The failures of what is called before a call. */
static uint32_t masses_refuse_selftest_command(masses_refuse *self, const masses_refuse_selftest_call *call)
{
    uint32_t failures = 0U;
    uint32_t found = 0U;
    ptc_status told = call->told;

    switch (call->command) {
    case 1U:
        told = masses_refuse_arm_for(self, call->k, call->samples);
        break;
    case 2U:
        told = masses_refuse_soonest(self, &found);
        break;
    case 3U:
        told = masses_refuse_deadline(self, &found);
        break;
    case 4U:
        told = masses_refuse_assume(self, &call->given[0]);
        break;
    case 5U:
        told = masses_refuse_assume_disturbance(self, call->given[0]);
        break;
    case 6U:
        told = masses_refuse_applied(self, call->given[0]);
        break;
    default:
        break;
    }
    if (told != call->told) {
        failures++;
    }
    if (found != call->found) {
        failures++;
    }
    return failures;
}

/* The failures of one call. */
static uint32_t masses_refuse_selftest_check(masses_refuse *self, const masses_refuse_selftest_call *call)
{
    uint32_t failures = 0U;
    float u = 12345.0f;
    float xhat[2] = {12345.0f, 12345.0f};
    float d = 12345.0f;

    if (call->is_armed != 0U) {
        if (masses_refuse_arm(self, call->start) != PTC_OK) {
            failures++;
        }
    }
    failures += masses_refuse_selftest_command(self, call);
    if (masses_refuse_step(self, call->k, call->y, &u) != call->status) {
        failures++;
    }
    failures += masses_refuse_selftest_differs(u, call->u);
    if (masses_refuse_estimate(self, xhat) != PTC_OK) {
        failures++;
    }
    for (uint32_t i = 0U; i < 2U; i++) {
        failures += masses_refuse_selftest_differs(xhat[i], call->xhat[i]);
    }
    if (masses_refuse_disturbance(self, &d) != PTC_OK) {
        failures++;
    }
    failures += masses_refuse_selftest_differs(d, call->d);
    return failures;
}

/* The calls of a session, of which init has been called. */
static uint32_t masses_refuse_selftest_calls_of(masses_refuse *self, const masses_refuse_selftest_session *session)
{
    uint32_t failures = 0U;

    for (uint32_t j = 0U; j < session->count; j++) {
        failures += masses_refuse_selftest_check(self, &masses_refuse_selftest_calls[session->first + j]);
    }
    return failures;
}

/* Every session with its calls. */
static uint32_t masses_refuse_selftest_run(void)
{
    uint32_t failures = 0U;

    for (uint32_t i = 0U; i < 4U; i++) {
        const masses_refuse_selftest_session *session = &masses_refuse_selftest_sessions[i];
        masses_refuse self;

        if (masses_refuse_init(&self, &session->params) == PTC_OK) {
            failures += masses_refuse_selftest_calls_of(&self, session);
        } else {
            failures++;
        }
    }
    return failures;
}

/* What init must refuse without a change. */
static uint32_t masses_refuse_selftest_refuse(void)
{
    const masses_refuse_selftest_session *session = &masses_refuse_selftest_sessions[0];
    uint32_t failures = 0U;
    masses_refuse self;

    if (masses_refuse_init(&self, &session->params) != PTC_OK) {
        failures++;
    }
    if (masses_refuse_init(NULL, &session->params) != PTC_E_PARAM) {
        failures++;
    }
    failures += masses_refuse_selftest_calls_of(&self, session);
    return failures;
}

/* Calls that lack a pointer: each is refused, and changes nothing. */
static uint32_t masses_refuse_selftest_pointers(void)
{
    const masses_refuse_selftest_session *session = &masses_refuse_selftest_sessions[0];
    const masses_refuse_selftest_call *call = &masses_refuse_selftest_calls[0];
    uint32_t failures = 0U;
    float u = 12345.0f;
    float xhat[2];
    float d;
    masses_refuse self;

    if (masses_refuse_init(&self, &session->params) != PTC_OK) {
        failures++;
    }
    if (masses_refuse_arm(NULL, call->start) != PTC_E_INPUT) {
        failures++;
    }
    if (masses_refuse_step(NULL, call->k, call->y, &u) != PTC_E_INPUT) {
        failures++;
    }
    failures += masses_refuse_selftest_differs(u, 0.0f);
    u = 12345.0f;
    if (masses_refuse_step(&self, call->k, NULL, &u) != PTC_E_INPUT) {
        failures++;
    }
    failures += masses_refuse_selftest_differs(u, 0.0f);
    if (masses_refuse_step(&self, call->k, call->y, NULL) != PTC_E_INPUT) {
        failures++;
    }
    if (masses_refuse_estimate(NULL, xhat) != PTC_E_INPUT) {
        failures++;
    }
    if (masses_refuse_estimate(&self, NULL) != PTC_E_INPUT) {
        failures++;
    }
    if (masses_refuse_disturbance(NULL, &d) != PTC_E_INPUT) {
        failures++;
    }
    if (masses_refuse_disturbance(&self, NULL) != PTC_E_INPUT) {
        failures++;
    }
    failures += masses_refuse_selftest_calls_of(&self, session);
    return failures;
}

uint32_t masses_refuse_selftest(void)
{
    uint32_t failures = masses_refuse_selftest_run();

    failures += masses_refuse_selftest_refuse();
    failures += masses_refuse_selftest_pointers();
    return failures;
}
