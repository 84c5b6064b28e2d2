/* Self-test of the prescribed-time controller stage35: see stage35_selftest.h. DO NOT EDIT. */
#include "stage35_selftest.h"
#include "stage35.h"

#include <math.h>
#include <stddef.h>

/* A call, and what it must give. */
typedef struct stage35_selftest_call {
    uint32_t is_armed; /* arm is called before it */
    uint32_t start;
    uint32_t k;
    double y[3]; /* what is measured */
    ptc_status status;
    double u[2];
    ptc_status axes[2];
} stage35_selftest_call;

/* A set of parameters that init takes, and the calls with it, one after the other. */
typedef struct stage35_selftest_session {
    stage35_params params;
    uint32_t first; /* of its calls */
    uint32_t count;
} stage35_selftest_session;

static const stage35_selftest_session stage35_selftest_sessions[2] = {
    {.params = {.none = (char)0}, .first = 0U, .count = 54U},
    {.params = {.none = (char)0}, .first = 54U, .count = 4U},
};

static const stage35_selftest_call stage35_selftest_calls[58] = {
    {.is_armed = 0U, .start = 0U, .k = 0U, .y = {0.75, 0.25, -0.25}, .status = PTC_SATURATED, .u = {-20.0, 1.9976068923109862}, .axes = {PTC_SATURATED, PTC_OK}},
    {.is_armed = 0U, .start = 0U, .k = 1U, .y = {0.7008333333333333, 0.2336111111111111, -0.2336111111111111}, .status = PTC_SATURATED, .u = {-20.0, 1.9569355058610713}, .axes = {PTC_SATURATED, PTC_OK}},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {0.6533333333333333, 0.2177777777777778, -0.2177777777777778}, .status = PTC_SATURATED, .u = {-20.0, 1.9138954982580767}, .axes = {PTC_SATURATED, PTC_OK}},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {(double)NAN, 0.5, 0.5}, .status = PTC_E_INPUT, .u = {0.0, 0.0}, .axes = {PTC_E_INPUT, PTC_E_INPUT}},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {0.5, (double)NAN, 0.5}, .status = PTC_E_INPUT, .u = {0.0, 0.0}, .axes = {PTC_E_INPUT, PTC_E_INPUT}},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {0.5, 0.5, (double)NAN}, .status = PTC_E_INPUT, .u = {0.0, 0.0}, .axes = {PTC_E_INPUT, PTC_E_INPUT}},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {(double)INFINITY, 0.5, 0.5}, .status = PTC_E_INPUT, .u = {0.0, 0.0}, .axes = {PTC_E_INPUT, PTC_E_INPUT}},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {0.5, (double)INFINITY, 0.5}, .status = PTC_E_INPUT, .u = {0.0, 0.0}, .axes = {PTC_E_INPUT, PTC_E_INPUT}},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {0.5, 0.5, (double)INFINITY}, .status = PTC_E_INPUT, .u = {0.0, 0.0}, .axes = {PTC_E_INPUT, PTC_E_INPUT}},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {-(double)INFINITY, 0.5, 0.5}, .status = PTC_E_INPUT, .u = {0.0, 0.0}, .axes = {PTC_E_INPUT, PTC_E_INPUT}},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {0.5, -(double)INFINITY, 0.5}, .status = PTC_E_INPUT, .u = {0.0, 0.0}, .axes = {PTC_E_INPUT, PTC_E_INPUT}},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {0.5, 0.5, -(double)INFINITY}, .status = PTC_E_INPUT, .u = {0.0, 0.0}, .axes = {PTC_E_INPUT, PTC_E_INPUT}},
    {.is_armed = 0U, .start = 0U, .k = 3U, .y = {0.6075, 0.2025, -0.2025}, .status = PTC_SATURATED, .u = {-20.0, 1.8684930978131589}, .axes = {PTC_SATURATED, PTC_OK}},
    {.is_armed = 0U, .start = 0U, .k = 7U, .y = {0.4408333333333334, 0.14694444444444446, -0.14694444444444446}, .status = PTC_SATURATED, .u = {-20.0, 1.6634176703888242}, .axes = {PTC_SATURATED, PTC_OK}},
    {.is_armed = 0U, .start = 0U, .k = 11U, .y = {0.3008333333333333, 0.10027777777777777, -0.10027777777777777}, .status = PTC_SATURATED, .u = {-20.0, 1.4213488412850843}, .axes = {PTC_SATURATED, PTC_OK}},
    {.is_armed = 0U, .start = 0U, .k = 13U, .y = {0.2408333333333333, 0.08027777777777777, -0.08027777777777777}, .status = PTC_SATURATED, .u = {-20.0, 1.2867983465838493}, .axes = {PTC_SATURATED, PTC_OK}},
    {.is_armed = 0U, .start = 0U, .k = 14U, .y = {0.21333333333333332, 0.07111111111111111, -0.07111111111111111}, .status = PTC_SATURATED, .u = {-20.0, 1.2162425699914285}, .axes = {PTC_SATURATED, PTC_OK}},
    {.is_armed = 0U, .start = 0U, .k = 15U, .y = {0.1875, 0.0625, -0.0625}, .status = PTC_SATURATED, .u = {-20.0, 1.143553969555265}, .axes = {PTC_SATURATED, PTC_OK}},
    {.is_armed = 0U, .start = 0U, .k = 16U, .y = {0.16333333333333333, 0.05444444444444445, -0.05444444444444445}, .status = PTC_SATURATED, .u = {-20.0, 1.0687851466826634}, .axes = {PTC_SATURATED, PTC_OK}},
    {.is_armed = 0U, .start = 0U, .k = 22U, .y = {0.05333333333333333, 0.017777777777777778, -0.017777777777777778}, .status = PTC_SATURATED, .u = {-20.0, 0.5818432445582638}, .axes = {PTC_SATURATED, PTC_OK}},
    {.is_armed = 0U, .start = 0U, .k = 26U, .y = {0.013333333333333332, 0.0044444444444444444, -0.0044444444444444444}, .status = PTC_SATURATED, .u = {-20.0, 0.23974754353429528}, .axes = {PTC_SATURATED, PTC_OK}},
    {.is_armed = 0U, .start = 0U, .k = 28U, .y = {0.003333333333333333, 0.0011111111111111111, -0.0011111111111111111}, .status = PTC_SATURATED, .u = {-20.0, 0.0858872876468223}, .axes = {PTC_SATURATED, PTC_OK}},
    {.is_armed = 0U, .start = 0U, .k = 29U, .y = {0.0008333333333333333, 0.0002777777777777778, -0.0002777777777777778}, .status = PTC_OK, .u = {-8.393792615926417, 0.027139229386989917}, .axes = {PTC_OK, PTC_OK}},
    {.is_armed = 0U, .start = 0U, .k = 30U, .y = {0.0, 0.0, -0.0}, .status = PTC_HOLD, .u = {0.0, 0.0}, .axes = {PTC_HOLD, PTC_HOLD}},
    {.is_armed = 0U, .start = 0U, .k = 31U, .y = {0.0, 0.0, -0.0}, .status = PTC_HOLD, .u = {0.0, 0.0}, .axes = {PTC_HOLD, PTC_HOLD}},
    {.is_armed = 0U, .start = 0U, .k = 2147483647U, .y = {0.0, 0.0, -0.0}, .status = PTC_HOLD, .u = {0.0, 0.0}, .axes = {PTC_HOLD, PTC_HOLD}},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {0.0, 0.0, -0.0}, .status = PTC_HOLD, .u = {0.0, 0.0}, .axes = {PTC_HOLD, PTC_HOLD}},
    {.is_armed = 1U, .start = 4294967293U, .k = 4294967293U, .y = {0.75, 0.25, -0.25}, .status = PTC_SATURATED, .u = {-20.0, 1.9976068923109862}, .axes = {PTC_SATURATED, PTC_OK}},
    {.is_armed = 0U, .start = 0U, .k = 4294967294U, .y = {0.7008333333333333, 0.2336111111111111, -0.2336111111111111}, .status = PTC_SATURATED, .u = {-20.0, 1.9569355058610713}, .axes = {PTC_SATURATED, PTC_OK}},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {0.6533333333333333, 0.2177777777777778, -0.2177777777777778}, .status = PTC_SATURATED, .u = {-20.0, 1.9138954982580767}, .axes = {PTC_SATURATED, PTC_OK}},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {(double)NAN, 0.5, 0.5}, .status = PTC_E_INPUT, .u = {0.0, 0.0}, .axes = {PTC_E_INPUT, PTC_E_INPUT}},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {0.5, (double)NAN, 0.5}, .status = PTC_E_INPUT, .u = {0.0, 0.0}, .axes = {PTC_E_INPUT, PTC_E_INPUT}},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {0.5, 0.5, (double)NAN}, .status = PTC_E_INPUT, .u = {0.0, 0.0}, .axes = {PTC_E_INPUT, PTC_E_INPUT}},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {(double)INFINITY, 0.5, 0.5}, .status = PTC_E_INPUT, .u = {0.0, 0.0}, .axes = {PTC_E_INPUT, PTC_E_INPUT}},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {0.5, (double)INFINITY, 0.5}, .status = PTC_E_INPUT, .u = {0.0, 0.0}, .axes = {PTC_E_INPUT, PTC_E_INPUT}},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {0.5, 0.5, (double)INFINITY}, .status = PTC_E_INPUT, .u = {0.0, 0.0}, .axes = {PTC_E_INPUT, PTC_E_INPUT}},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {-(double)INFINITY, 0.5, 0.5}, .status = PTC_E_INPUT, .u = {0.0, 0.0}, .axes = {PTC_E_INPUT, PTC_E_INPUT}},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {0.5, -(double)INFINITY, 0.5}, .status = PTC_E_INPUT, .u = {0.0, 0.0}, .axes = {PTC_E_INPUT, PTC_E_INPUT}},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {0.5, 0.5, -(double)INFINITY}, .status = PTC_E_INPUT, .u = {0.0, 0.0}, .axes = {PTC_E_INPUT, PTC_E_INPUT}},
    {.is_armed = 0U, .start = 0U, .k = 0U, .y = {0.6075, 0.2025, -0.2025}, .status = PTC_SATURATED, .u = {-20.0, 1.8684930978131589}, .axes = {PTC_SATURATED, PTC_OK}},
    {.is_armed = 0U, .start = 0U, .k = 4U, .y = {0.4408333333333334, 0.14694444444444446, -0.14694444444444446}, .status = PTC_SATURATED, .u = {-20.0, 1.6634176703888242}, .axes = {PTC_SATURATED, PTC_OK}},
    {.is_armed = 0U, .start = 0U, .k = 8U, .y = {0.3008333333333333, 0.10027777777777777, -0.10027777777777777}, .status = PTC_SATURATED, .u = {-20.0, 1.4213488412850843}, .axes = {PTC_SATURATED, PTC_OK}},
    {.is_armed = 0U, .start = 0U, .k = 10U, .y = {0.2408333333333333, 0.08027777777777777, -0.08027777777777777}, .status = PTC_SATURATED, .u = {-20.0, 1.2867983465838493}, .axes = {PTC_SATURATED, PTC_OK}},
    {.is_armed = 0U, .start = 0U, .k = 11U, .y = {0.21333333333333332, 0.07111111111111111, -0.07111111111111111}, .status = PTC_SATURATED, .u = {-20.0, 1.2162425699914285}, .axes = {PTC_SATURATED, PTC_OK}},
    {.is_armed = 0U, .start = 0U, .k = 12U, .y = {0.1875, 0.0625, -0.0625}, .status = PTC_SATURATED, .u = {-20.0, 1.143553969555265}, .axes = {PTC_SATURATED, PTC_OK}},
    {.is_armed = 0U, .start = 0U, .k = 13U, .y = {0.16333333333333333, 0.05444444444444445, -0.05444444444444445}, .status = PTC_SATURATED, .u = {-20.0, 1.0687851466826634}, .axes = {PTC_SATURATED, PTC_OK}},
    {.is_armed = 0U, .start = 0U, .k = 19U, .y = {0.05333333333333333, 0.017777777777777778, -0.017777777777777778}, .status = PTC_SATURATED, .u = {-20.0, 0.5818432445582638}, .axes = {PTC_SATURATED, PTC_OK}},
    {.is_armed = 0U, .start = 0U, .k = 23U, .y = {0.013333333333333332, 0.0044444444444444444, -0.0044444444444444444}, .status = PTC_SATURATED, .u = {-20.0, 0.23974754353429528}, .axes = {PTC_SATURATED, PTC_OK}},
    {.is_armed = 0U, .start = 0U, .k = 25U, .y = {0.003333333333333333, 0.0011111111111111111, -0.0011111111111111111}, .status = PTC_SATURATED, .u = {-20.0, 0.0858872876468223}, .axes = {PTC_SATURATED, PTC_OK}},
    {.is_armed = 0U, .start = 0U, .k = 26U, .y = {0.0008333333333333333, 0.0002777777777777778, -0.0002777777777777778}, .status = PTC_OK, .u = {-8.393792615926417, 0.027139229386989917}, .axes = {PTC_OK, PTC_OK}},
    {.is_armed = 0U, .start = 0U, .k = 27U, .y = {0.0, 0.0, -0.0}, .status = PTC_HOLD, .u = {0.0, 0.0}, .axes = {PTC_HOLD, PTC_HOLD}},
    {.is_armed = 0U, .start = 0U, .k = 28U, .y = {0.0, 0.0, -0.0}, .status = PTC_HOLD, .u = {0.0, 0.0}, .axes = {PTC_HOLD, PTC_HOLD}},
    {.is_armed = 0U, .start = 0U, .k = 2147483644U, .y = {0.0, 0.0, -0.0}, .status = PTC_HOLD, .u = {0.0, 0.0}, .axes = {PTC_HOLD, PTC_HOLD}},
    {.is_armed = 0U, .start = 0U, .k = 4294967292U, .y = {0.0, 0.0, -0.0}, .status = PTC_HOLD, .u = {0.0, 0.0}, .axes = {PTC_HOLD, PTC_HOLD}},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {-0.6475592481261917, -0.3752762418554133, 0.8615129375260748}, .status = PTC_SATURATED, .u = {20.0, -7.813075410397979}, .axes = {PTC_SATURATED, PTC_OK}},
    {.is_armed = 0U, .start = 0U, .k = 27U, .y = {0.8310615231814897, -0.5148635727520645, 0.5784513092179436}, .status = PTC_SATURATED, .u = {-20.0, -30.0}, .axes = {PTC_SATURATED, PTC_SATURATED}},
    {.is_armed = 0U, .start = 0U, .k = 28U, .y = {-0.29700832435185753, -0.5674679036919925, -0.910475470057037}, .status = PTC_SATURATED, .u = {20.0, 30.0}, .axes = {PTC_SATURATED, PTC_SATURATED}},
    {.is_armed = 1U, .start = 0U, .k = 16U, .y = {1.7117833149463137e308, -1.7012350692523642e308, -1.6084437871705428e308}, .status = PTC_E_RANGE, .u = {0.0, 0.0}, .axes = {PTC_E_RANGE, PTC_E_RANGE}},
};

/* 1 where a number is not the one that must come. */
static uint32_t stage35_selftest_differs(double value, double wanted)
{
    uint32_t failures = 1U;

    if (fabs(value - wanted) <= 0.0) {
        failures = 0U;
    }
    return failures;
}

/* The failures of one call. */
static uint32_t stage35_selftest_check(stage35 *self, const stage35_selftest_call *call)
{
    uint32_t failures = 0U;
    double u[2] = {12345.0, 12345.0};
    ptc_status axes[2] = {PTC_E_PARAM, PTC_E_PARAM};

    if (call->is_armed != 0U) {
        if (stage35_arm(self, call->start) != PTC_OK) {
            failures++;
        }
    }
    if (stage35_step(self, call->k, call->y, u, axes) != call->status) {
        failures++;
    }
    for (uint32_t i = 0U; i < 2U; i++) {
        failures += stage35_selftest_differs(u[i], call->u[i]);
        if (axes[i] != call->axes[i]) {
            failures++;
        }
    }
    return failures;
}

/* The calls of a session, of which init has been called. */
static uint32_t stage35_selftest_calls_of(stage35 *self, const stage35_selftest_session *session)
{
    uint32_t failures = 0U;

    for (uint32_t j = 0U; j < session->count; j++) {
        failures += stage35_selftest_check(self, &stage35_selftest_calls[session->first + j]);
    }
    return failures;
}

/* Every session with its calls. */
static uint32_t stage35_selftest_run(void)
{
    uint32_t failures = 0U;

    for (uint32_t i = 0U; i < 2U; i++) {
        const stage35_selftest_session *session = &stage35_selftest_sessions[i];
        stage35 self;

        if (stage35_init(&self, &session->params) == PTC_OK) {
            failures += stage35_selftest_calls_of(&self, session);
        } else {
            failures++;
        }
    }
    return failures;
}

/* What init must refuse without a change. */
static uint32_t stage35_selftest_refuse(void)
{
    const stage35_selftest_session *session = &stage35_selftest_sessions[0];
    uint32_t failures = 0U;
    stage35 self;

    if (stage35_init(&self, &session->params) != PTC_OK) {
        failures++;
    }
    if (stage35_init(NULL, &session->params) != PTC_E_PARAM) {
        failures++;
    }
    failures += stage35_selftest_calls_of(&self, session);
    return failures;
}

/* Calls that lack a pointer: each is refused, and changes nothing. */
static uint32_t stage35_selftest_pointers(void)
{
    const stage35_selftest_session *session = &stage35_selftest_sessions[0];
    const stage35_selftest_call *call = &stage35_selftest_calls[0];
    uint32_t failures = 0U;
    double u[2] = {12345.0, 12345.0};
    ptc_status axes[2] = {PTC_E_PARAM, PTC_E_PARAM};
    stage35 self;

    if (stage35_init(&self, &session->params) != PTC_OK) {
        failures++;
    }
    if (stage35_arm(NULL, call->start) != PTC_E_INPUT) {
        failures++;
    }
    if (stage35_step(NULL, call->k, call->y, u, axes) != PTC_E_INPUT) {
        failures++;
    }
    for (uint32_t i = 0U; i < 2U; i++) {
        failures += stage35_selftest_differs(u[i], 0.0);
        u[i] = 12345.0;
    }
    if (stage35_step(&self, call->k, call->y, u, NULL) != PTC_E_INPUT) {
        failures++;
    }
    for (uint32_t i = 0U; i < 2U; i++) {
        failures += stage35_selftest_differs(u[i], 0.0);
        u[i] = 12345.0;
    }
    if (stage35_step(&self, call->k, NULL, u, axes) != PTC_E_INPUT) {
        failures++;
    }
    for (uint32_t i = 0U; i < 2U; i++) {
        failures += stage35_selftest_differs(u[i], 0.0);
    }
    if (stage35_step(&self, call->k, call->y, NULL, axes) != PTC_E_INPUT) {
        failures++;
    }
    failures += stage35_selftest_calls_of(&self, session);
    return failures;
}

uint32_t stage35_selftest(void)
{
    uint32_t failures = stage35_selftest_run();

    failures += stage35_selftest_refuse();
    failures += stage35_selftest_pointers();
    return failures;
}
