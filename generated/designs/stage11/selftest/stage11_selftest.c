/* Self-test of the prescribed-time controller stage11: see stage11_selftest.h. DO NOT EDIT. */
#include "stage11_selftest.h"
#include "stage11.h"

#include <math.h>
#include <stddef.h>

/* A call, and what it must give. */
typedef struct stage11_selftest_call {
    uint32_t is_armed; /* arm is called before it */
    uint32_t start;
    uint32_t k;
    float y[1]; /* what is measured */
    ptc_status status;
    float u;
    float xhat[4]; /* the estimates behind it */
    float d;
} stage11_selftest_call;

/* A set of parameters that init takes, and the calls with it, one after the other. */
typedef struct stage11_selftest_session {
    stage11_params params;
    uint32_t first; /* of its calls */
    uint32_t count;
} stage11_selftest_session;

static const stage11_selftest_session stage11_selftest_sessions[6] = {
    {.params = {.samples = 60U, .u_max = (float)INFINITY, .k = {625.0f, 500.0f, 150.0f, 20.0f}, .deadbeat = 0.0f}, .first = 0U, .count = 42U},
    {.params = {.samples = 60U, .u_max = (float)INFINITY, .k = {625.0f, 500.0f, 150.0f, 0.0f}, .deadbeat = 0.0f}, .first = 42U, .count = 1U},
    {.params = {.samples = 60U, .u_max = (float)INFINITY, .k = {625.0f, 500.0f, 150.0f, 20.0f}, .deadbeat = 3.4028235e38f}, .first = 43U, .count = 1U},
    {.params = {.samples = 60U, .u_max = (float)INFINITY, .k = {625.0f, 500.0f, 150.0f, 20.0f}, .deadbeat = 0.0f}, .first = 44U, .count = 5U},
    {.params = {.samples = 60U, .u_max = (float)INFINITY, .k = {625.0f, 500.0f, 150.0f, 20.0f}, .deadbeat = 0.0f}, .first = 49U, .count = 2U},
    {.params = {.samples = 60U, .u_max = 1.0f, .k = {625.0f, 500.0f, 150.0f, 20.0f}, .deadbeat = 0.0f}, .first = 51U, .count = 2U},
};

static const stage11_selftest_call stage11_selftest_calls[53] = {
    {.is_armed = 0U, .start = 0U, .k = 0U, .y = {0.75f}, .status = PTC_OK, .u = -4005.301f, .xhat = {0.75f, 0.0f, 0.0f, 0.0f}, .d = 0.0f},
    {.is_armed = 0U, .start = 0U, .k = 1U, .y = {0.72520834f}, .status = PTC_OK, .u = -1723.5654f, .xhat = {0.73629916f, -0.3272728f, -2.8096275f, -45.271736f}, .d = 0.0f},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {0.7008333f}, .status = PTC_OK, .u = 1016.27124f, .xhat = {0.7146918f, -0.8093058f, -7.1046376f, -70.332634f}, .d = 0.0f},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {(float)NAN}, .status = PTC_E_INPUT, .u = 0.0f, .xhat = {0.7146918f, -0.8093058f, -7.1046376f, -70.332634f}, .d = 0.0f},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {(float)INFINITY}, .status = PTC_E_INPUT, .u = 0.0f, .xhat = {0.7146918f, -0.8093058f, -7.1046376f, -70.332634f}, .d = 0.0f},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {-(float)INFINITY}, .status = PTC_E_INPUT, .u = 0.0f, .xhat = {0.7146918f, -0.8093058f, -7.1046376f, -70.332634f}, .d = 0.0f},
    {.is_armed = 0U, .start = 0U, .k = 3U, .y = {0.676875f}, .status = PTC_OK, .u = 3478.8975f, .xhat = {0.68911135f, -1.3268453f, -11.604531f, -68.5338f}, .d = 0.0f},
    {.is_armed = 0U, .start = 0U, .k = 15U, .y = {0.421875f}, .status = PTC_OK, .u = 183925.38f, .xhat = {0.46085614f, -12.753371f, -216.30304f, -961.86816f}, .d = 0.0f},
    {.is_armed = 0U, .start = 0U, .k = 26U, .y = {0.24083333f}, .status = PTC_OK, .u = 18990768.0f, .xhat = {0.24083333f, -31.931816f, -2596.442f, -203098.31f}, .d = -8159028.0f},
    {.is_armed = 0U, .start = 0U, .k = 28U, .y = {0.21333334f}, .status = PTC_OK, .u = -90780640.0f, .xhat = {0.21333332f, 27.707626f, 9067.649f, 1032660.94f}, .d = 36938644.0f},
    {.is_armed = 0U, .start = 0U, .k = 29U, .y = {0.20020834f}, .status = PTC_OK, .u = 139945550.0f, .xhat = {0.2002083f, -25.052277f, -9351.252f, -1738908.5f}, .d = -52387332.0f},
    {.is_armed = 0U, .start = 0U, .k = 30U, .y = {0.1875f}, .status = PTC_OK, .u = -120427730.0f, .xhat = {0.1875f, 8.814606f, 5600.0234f, 1533455.3f}, .d = 43483924.0f},
    {.is_armed = 0U, .start = 0U, .k = 31U, .y = {0.17520833f}, .status = PTC_OK, .u = 52934870.0f, .xhat = {0.17520833f, 2.8396835f, -527.96875f, -745870.0f}, .d = -16911568.0f},
    {.is_armed = 0U, .start = 0U, .k = 45U, .y = {0.046875f}, .status = PTC_OK, .u = 399198600.0f, .xhat = {0.046875f, -38.11082f, -6798.8716f, -438211.44f}, .d = -19014544.0f},
    {.is_armed = 0U, .start = 0U, .k = 56U, .y = {0.0033333334f}, .status = PTC_OK, .u = -1928529800.0f, .xhat = {0.0033333302f, 58.715416f, 25098.828f, 4843967.0f}, .d = 40198988.0f},
    {.is_armed = 0U, .start = 0U, .k = 58U, .y = {0.00083333335f}, .status = PTC_OK, .u = 6616562000.0f, .xhat = {0.00083339214f, -151.38617f, -75277.33f, -18702138.0f}, .d = -146312900.0f},
    {.is_armed = 0U, .start = 0U, .k = 59U, .y = {0.00020833334f}, .status = PTC_OK, .u = -20673135000.0f, .xhat = {0.00020837784f, 426.23108f, 227410.9f, 60245824.0f}, .d = 423505920.0f},
    {.is_armed = 0U, .start = 0U, .k = 60U, .y = {0.0f}, .status = PTC_HOLD, .u = 63035670000.0f, .xhat = {0.0f, -1253.2834f, -685349.0f, -185342180.0f}, .d = -1300163000.0f},
    {.is_armed = 0U, .start = 0U, .k = 61U, .y = {0.0f}, .status = PTC_HOLD, .u = -190512450000.0f, .xhat = {0.0f, 3741.9346f, 2063723.6f, 561931650.0f}, .d = 3896588300.0f},
    {.is_armed = 0U, .start = 0U, .k = 2147483647U, .y = {0.0f}, .status = PTC_HOLD, .u = 574256900000.0f, .xhat = {0.0f, -11231.932f, -6212458.0f, -1695487500.0f}, .d = -11753831000.0f},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {0.0f}, .status = PTC_HOLD, .u = -1729248400000.0f, .xhat = {0.0f, 33775.29f, 18699612.0f, 5107411000.0f}, .d = 35360880000.0f},
    {.is_armed = 1U, .start = 4294967293U, .k = 4294967293U, .y = {0.75f}, .status = PTC_OK, .u = 242432490000.0f, .xhat = {655.02893f, 176323.88f, -15055132.0f, -11831722000.0f}, .d = 35360880000.0f},
    {.is_armed = 0U, .start = 0U, .k = 4294967294U, .y = {0.72520834f}, .status = PTC_OK, .u = 212785900000.0f, .xhat = {-84.91477f, -516992.66f, -119462536.0f, -9053748000.0f}, .d = 35360880000.0f},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {0.7008333f}, .status = PTC_OK, .u = 183654150000.0f, .xhat = {-5463.3335f, -1944978.4f, -196111740.0f, -6569195000.0f}, .d = 35360880000.0f},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {(float)NAN}, .status = PTC_E_INPUT, .u = 0.0f, .xhat = {-5463.3335f, -1944978.4f, -196111740.0f, -6569195000.0f}, .d = 35360880000.0f},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {(float)INFINITY}, .status = PTC_E_INPUT, .u = 0.0f, .xhat = {-5463.3335f, -1944978.4f, -196111740.0f, -6569195000.0f}, .d = 35360880000.0f},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {-(float)INFINITY}, .status = PTC_E_INPUT, .u = 0.0f, .xhat = {-5463.3335f, -1944978.4f, -196111740.0f, -6569195000.0f}, .d = 35360880000.0f},
    {.is_armed = 0U, .start = 0U, .k = 0U, .y = {0.676875f}, .status = PTC_OK, .u = 154027980000.0f, .xhat = {-14888.992f, -3658815.5f, -246171300.0f, -4368867300.0f}, .d = 35360880000.0f},
    {.is_armed = 0U, .start = 0U, .k = 12U, .y = {0.421875f}, .status = PTC_OK, .u = 161269480000.0f, .xhat = {-9912.703f, -3431811.8f, -228464590.0f, -2238951700.0f}, .d = 35360880000.0f},
    {.is_armed = 0U, .start = 0U, .k = 23U, .y = {0.24083333f}, .status = PTC_OK, .u = -12573433000000.0f, .xhat = {0.2421875f, 5859683.5f, 1390721800.0f, 139591160000.0f}, .d = 5629913600000.0f},
    {.is_armed = 0U, .start = 0U, .k = 25U, .y = {0.21333334f}, .status = PTC_OK, .u = 24140540000000.0f, .xhat = {0.21875f, -5349332.0f, -1891937800.0f, -301106500000.0f}, .d = -9220585000000.0f},
    {.is_armed = 0U, .start = 0U, .k = 26U, .y = {0.20020834f}, .status = PTC_OK, .u = -26157582000000.0f, .xhat = {0.203125f, 3174700.0f, 1444685000.0f, 328237900000.0f}, .d = 9985211000000.0f},
    {.is_armed = 0U, .start = 0U, .k = 27U, .y = {0.1875f}, .status = PTC_OK, .u = 15600291000000.0f, .xhat = {0.1875f, -318012.0f, -513402880.0f, -213358560000.0f}, .d = -5209699000000.0f},
    {.is_armed = 0U, .start = 0U, .k = 28U, .y = {0.17520833f}, .status = PTC_OK, .u = -2251668800000.0f, .xhat = {0.17578125f, -1871412.0f, -375107700.0f, 40748860000.0f}, .d = 798361100000.0f},
    {.is_armed = 0U, .start = 0U, .k = 42U, .y = {0.046875f}, .status = PTC_OK, .u = -57844780000000.0f, .xhat = {0.046875f, 2690120.0f, 872149200.0f, 104424390000.0f}, .d = 3926705600000.0f},
    {.is_armed = 0U, .start = 0U, .k = 53U, .y = {0.0033333334f}, .status = PTC_OK, .u = 220660890000000.0f, .xhat = {0.00390625f, -5988283.0f, -2688378400.0f, -598373560000.0f}, .d = -2617983600000.0f},
    {.is_armed = 0U, .start = 0U, .k = 55U, .y = {0.00083333335f}, .status = PTC_OK, .u = -730700700000000.0f, .xhat = {0.0f, 15878796.0f, 8156099000.0f, 2090004300000.0f}, .d = 17699963000000.0f},
    {.is_armed = 0U, .start = 0U, .k = 56U, .y = {0.00020833334f}, .status = PTC_OK, .u = 2247823000000000.0f, .xhat = {0.0f, -45610790.0f, -24614322000.0f, -6584611000000.0f}, .d = -44084362000000.0f},
    {.is_armed = 0U, .start = 0U, .k = 57U, .y = {0.0f}, .status = PTC_HOLD, .u = -6834176700000000.0f, .xhat = {0.0f, 135062370.0f, 74152490000.0f, 20117862000000.0f}, .d = 142519080000000.0f},
    {.is_armed = 0U, .start = 0U, .k = 58U, .y = {0.0f}, .status = PTC_HOLD, .u = 2.0620492e16f, .xhat = {0.0f, -404261250.0f, -223256940000.0f, -60856298000000.0f}, .d = -419784330000000.0f},
    {.is_armed = 0U, .start = 0U, .k = 2147483644U, .y = {0.0f}, .status = PTC_HOLD, .u = -6.213552e16f, .xhat = {0.0f, 1214475000.0f, 672042600000.0f, 183478820000000.0f}, .d = 1273337000000000.0f},
    {.is_armed = 0U, .start = 0U, .k = 4294967292U, .y = {0.0f}, .status = PTC_HOLD, .u = 1.8707228e17f, .xhat = {0.0f, -3653074000.0f, -2022829000000.0f, -552561640000000.0f}, .d = -3823407800000000.0f},
    {.is_armed = 0U, .start = 0U, .k = 0U, .y = {0.0f}, .status = PTC_OK, .u = 0.0f, .xhat = {0.0f, 0.0f, 0.0f, 0.0f}, .d = 0.0f},
    {.is_armed = 0U, .start = 0U, .k = 0U, .y = {0.0f}, .status = PTC_OK, .u = -0.0f, .xhat = {0.0f, 0.0f, 0.0f, 0.0f}, .d = 0.0f},
    {.is_armed = 0U, .start = 0U, .k = 18U, .y = {-0.6046181f}, .status = PTC_OK, .u = 14067.061f, .xhat = {-0.6046181f, 0.0f, 0.0f, 0.0f}, .d = 0.0f},
    {.is_armed = 0U, .start = 0U, .k = 19U, .y = {0.63910973f}, .status = PTC_OK, .u = 31476506.0f, .xhat = {0.63910973f, 98.620705f, -1758.0953f, 866977.2f}, .d = -60301670.0f},
    {.is_armed = 0U, .start = 0U, .k = 20U, .y = {0.7499843f}, .status = PTC_OK, .u = 148096000.0f, .xhat = {0.7499843f, 22.482468f, 6492.544f, 885363.3f}, .d = -182956770.0f},
    {.is_armed = 0U, .start = 0U, .k = 21U, .y = {0.93389285f}, .status = PTC_OK, .u = 37636028.0f, .xhat = {0.93389285f, 56.618904f, 11756.551f, 1367720.1f}, .d = -94320560.0f},
    {.is_armed = 0U, .start = 0U, .k = 11U, .y = {1.6637926e32f}, .status = PTC_E_RANGE, .u = 0.0f, .xhat = {0.93389285f, 56.618904f, 11756.551f, 1367720.1f}, .d = -94320560.0f},
    {.is_armed = 1U, .start = 0U, .k = 60U, .y = {-7.0453863e18f}, .status = PTC_HOLD, .u = 7.045386e26f, .xhat = {-7.0453863e18f, 0.0f, 0.0f, 0.0f}, .d = 0.0f},
    {.is_armed = 1U, .start = 4294967290U, .k = 1U, .y = {-7.417328e18f}, .status = PTC_OK, .u = -1.9720224e26f, .xhat = {-7.417328e18f, 1.1742311e20f, 3.522693e22f, 7.0453863e24f}, .d = 0.0f},
    {.is_armed = 0U, .start = 0U, .k = 0U, .y = {0.9413883f}, .status = PTC_SATURATED, .u = -1.0f, .xhat = {0.9413883f, 0.0f, 0.0f, 0.0f}, .d = 0.0f},
    {.is_armed = 0U, .start = 0U, .k = 1U, .y = {0.4992295f}, .status = PTC_SATURATED, .u = 1.0f, .xhat = {0.69704765f, -5.8253913f, -46.541126f, -93.092155f}, .d = 0.0f},
};

/* 1 where a number is not the one that must come. */
static uint32_t stage11_selftest_differs(float value, float wanted)
{
    uint32_t failures = 1U;

    if (fabsf(value - wanted) <= 0.0f) {
        failures = 0U;
    }
    return failures;
}

/* The failures of one call. */
static uint32_t stage11_selftest_check(stage11 *self, const stage11_selftest_call *call)
{
    uint32_t failures = 0U;
    float u = 12345.0f;
    float xhat[4] = {12345.0f, 12345.0f, 12345.0f, 12345.0f};
    float d = 12345.0f;

    if (call->is_armed != 0U) {
        if (stage11_arm(self, call->start) != PTC_OK) {
            failures++;
        }
    }
    if (stage11_step(self, call->k, call->y, &u) != call->status) {
        failures++;
    }
    failures += stage11_selftest_differs(u, call->u);
    if (stage11_estimate(self, xhat) != PTC_OK) {
        failures++;
    }
    for (uint32_t i = 0U; i < 4U; i++) {
        failures += stage11_selftest_differs(xhat[i], call->xhat[i]);
    }
    if (stage11_disturbance(self, &d) != PTC_OK) {
        failures++;
    }
    failures += stage11_selftest_differs(d, call->d);
    return failures;
}

/* The calls of a session, of which init has been called. */
static uint32_t stage11_selftest_calls_of(stage11 *self, const stage11_selftest_session *session)
{
    uint32_t failures = 0U;

    for (uint32_t j = 0U; j < session->count; j++) {
        failures += stage11_selftest_check(self, &stage11_selftest_calls[session->first + j]);
    }
    return failures;
}

/* Every session with its calls. */
static uint32_t stage11_selftest_run(void)
{
    uint32_t failures = 0U;

    for (uint32_t i = 0U; i < 6U; i++) {
        const stage11_selftest_session *session = &stage11_selftest_sessions[i];
        stage11 self;

        if (stage11_init(&self, &session->params) == PTC_OK) {
            failures += stage11_selftest_calls_of(&self, session);
        } else {
            failures++;
        }
    }
    return failures;
}

/* What init must refuse without a change. */
static uint32_t stage11_selftest_refuse(void)
{
    static const stage11_params refused[33] = {
        {.samples = 0U, .u_max = (float)INFINITY, .k = {625.0f, 500.0f, 150.0f, 20.0f}, .deadbeat = 0.0f},
        {.samples = 9U, .u_max = (float)INFINITY, .k = {625.0f, 500.0f, 150.0f, 20.0f}, .deadbeat = 0.0f},
        {.samples = 60U, .u_max = (float)NAN, .k = {625.0f, 500.0f, 150.0f, 20.0f}, .deadbeat = 0.0f},
        {.samples = 60U, .u_max = -(float)INFINITY, .k = {625.0f, 500.0f, 150.0f, 20.0f}, .deadbeat = 0.0f},
        {.samples = 60U, .u_max = 0.0f, .k = {625.0f, 500.0f, 150.0f, 20.0f}, .deadbeat = 0.0f},
        {.samples = 60U, .u_max = -1.0f, .k = {625.0f, 500.0f, 150.0f, 20.0f}, .deadbeat = 0.0f},
        {.samples = 60U, .u_max = -3.4028235e38f, .k = {625.0f, 500.0f, 150.0f, 20.0f}, .deadbeat = 0.0f},
        {.samples = 60U, .u_max = (float)INFINITY, .k = {(float)NAN, 500.0f, 150.0f, 20.0f}, .deadbeat = 0.0f},
        {.samples = 60U, .u_max = (float)INFINITY, .k = {(float)INFINITY, 500.0f, 150.0f, 20.0f}, .deadbeat = 0.0f},
        {.samples = 60U, .u_max = (float)INFINITY, .k = {-(float)INFINITY, 500.0f, 150.0f, 20.0f}, .deadbeat = 0.0f},
        {.samples = 60U, .u_max = (float)INFINITY, .k = {3.4028235e38f, 500.0f, 150.0f, 20.0f}, .deadbeat = 0.0f},
        {.samples = 60U, .u_max = (float)INFINITY, .k = {-3.4028235e38f, 500.0f, 150.0f, 20.0f}, .deadbeat = 0.0f},
        {.samples = 60U, .u_max = (float)INFINITY, .k = {625.0f, (float)NAN, 150.0f, 20.0f}, .deadbeat = 0.0f},
        {.samples = 60U, .u_max = (float)INFINITY, .k = {625.0f, (float)INFINITY, 150.0f, 20.0f}, .deadbeat = 0.0f},
        {.samples = 60U, .u_max = (float)INFINITY, .k = {625.0f, -(float)INFINITY, 150.0f, 20.0f}, .deadbeat = 0.0f},
        {.samples = 60U, .u_max = (float)INFINITY, .k = {625.0f, 3.4028235e38f, 150.0f, 20.0f}, .deadbeat = 0.0f},
        {.samples = 60U, .u_max = (float)INFINITY, .k = {625.0f, -3.4028235e38f, 150.0f, 20.0f}, .deadbeat = 0.0f},
        {.samples = 60U, .u_max = (float)INFINITY, .k = {625.0f, 500.0f, (float)NAN, 20.0f}, .deadbeat = 0.0f},
        {.samples = 60U, .u_max = (float)INFINITY, .k = {625.0f, 500.0f, (float)INFINITY, 20.0f}, .deadbeat = 0.0f},
        {.samples = 60U, .u_max = (float)INFINITY, .k = {625.0f, 500.0f, -(float)INFINITY, 20.0f}, .deadbeat = 0.0f},
        {.samples = 60U, .u_max = (float)INFINITY, .k = {625.0f, 500.0f, 3.4028235e38f, 20.0f}, .deadbeat = 0.0f},
        {.samples = 60U, .u_max = (float)INFINITY, .k = {625.0f, 500.0f, -3.4028235e38f, 20.0f}, .deadbeat = 0.0f},
        {.samples = 60U, .u_max = (float)INFINITY, .k = {625.0f, 500.0f, 150.0f, (float)NAN}, .deadbeat = 0.0f},
        {.samples = 60U, .u_max = (float)INFINITY, .k = {625.0f, 500.0f, 150.0f, (float)INFINITY}, .deadbeat = 0.0f},
        {.samples = 60U, .u_max = (float)INFINITY, .k = {625.0f, 500.0f, 150.0f, -(float)INFINITY}, .deadbeat = 0.0f},
        {.samples = 60U, .u_max = (float)INFINITY, .k = {625.0f, 500.0f, 150.0f, 3.4028235e38f}, .deadbeat = 0.0f},
        {.samples = 60U, .u_max = (float)INFINITY, .k = {625.0f, 500.0f, 150.0f, -3.4028235e38f}, .deadbeat = 0.0f},
        {.samples = 60U, .u_max = (float)INFINITY, .k = {625.0f, 500.0f, 150.0f, 20.0f}, .deadbeat = (float)NAN},
        {.samples = 60U, .u_max = (float)INFINITY, .k = {625.0f, 500.0f, 150.0f, 20.0f}, .deadbeat = (float)INFINITY},
        {.samples = 60U, .u_max = (float)INFINITY, .k = {625.0f, 500.0f, 150.0f, 20.0f}, .deadbeat = -(float)INFINITY},
        {.samples = 60U, .u_max = (float)INFINITY, .k = {625.0f, 500.0f, 150.0f, 20.0f}, .deadbeat = -1.0f},
        {.samples = 60U, .u_max = (float)INFINITY, .k = {625.0f, 500.0f, 150.0f, 20.0f}, .deadbeat = -3.4028235e38f},
        {.samples = 60U, .u_max = (float)INFINITY, .k = {625.0f, 500.0f, -3.4028235e38f, -3.4028235e38f}, .deadbeat = 177683200.0f},
    };
    const stage11_selftest_session *session = &stage11_selftest_sessions[0];
    uint32_t failures = 0U;
    stage11 self;

    if (stage11_init(&self, &session->params) != PTC_OK) {
        failures++;
    }
    for (uint32_t i = 0U; i < 33U; i++) {
        if (stage11_init(&self, &refused[i]) != PTC_E_PARAM) {
            failures++;
        }
    }
    if (stage11_init(&self, NULL) != PTC_E_PARAM) {
        failures++;
    }
    if (stage11_init(NULL, &session->params) != PTC_E_PARAM) {
        failures++;
    }
    failures += stage11_selftest_calls_of(&self, session);
    return failures;
}

/* Calls that lack a pointer: each is refused, and changes nothing. */
static uint32_t stage11_selftest_pointers(void)
{
    const stage11_selftest_session *session = &stage11_selftest_sessions[0];
    const stage11_selftest_call *call = &stage11_selftest_calls[0];
    uint32_t failures = 0U;
    float u = 12345.0f;
    float xhat[4];
    float d;
    stage11 self;

    if (stage11_init(&self, &session->params) != PTC_OK) {
        failures++;
    }
    if (stage11_arm(NULL, call->start) != PTC_E_INPUT) {
        failures++;
    }
    if (stage11_step(NULL, call->k, call->y, &u) != PTC_E_INPUT) {
        failures++;
    }
    failures += stage11_selftest_differs(u, 0.0f);
    u = 12345.0f;
    if (stage11_step(&self, call->k, NULL, &u) != PTC_E_INPUT) {
        failures++;
    }
    failures += stage11_selftest_differs(u, 0.0f);
    if (stage11_step(&self, call->k, call->y, NULL) != PTC_E_INPUT) {
        failures++;
    }
    if (stage11_estimate(NULL, xhat) != PTC_E_INPUT) {
        failures++;
    }
    if (stage11_estimate(&self, NULL) != PTC_E_INPUT) {
        failures++;
    }
    if (stage11_disturbance(NULL, &d) != PTC_E_INPUT) {
        failures++;
    }
    if (stage11_disturbance(&self, NULL) != PTC_E_INPUT) {
        failures++;
    }
    failures += stage11_selftest_calls_of(&self, session);
    return failures;
}

uint32_t stage11_selftest(void)
{
    uint32_t failures = stage11_selftest_run();

    failures += stage11_selftest_refuse();
    failures += stage11_selftest_pointers();
    return failures;
}
