/* Self-test of the prescribed-time controller track: see track_selftest.h. DO NOT EDIT. */
#include "track_selftest.h"
#include "track.h"

#include <math.h>
#include <stddef.h>

/* A call, and what it must give. */
typedef struct track_selftest_call {
    double t;
    double x[2];
    double u;
    double tolerance;
    ptc_status status;
} track_selftest_call;

/* A set of parameters that init takes, and the calls with it. */
typedef struct track_selftest_session {
    track_params params;
    double t0; /* of arm, where it is called */
    uint32_t is_armed_again;
    uint32_t first; /* of its calls */
    uint32_t count;
} track_selftest_session;

static const track_selftest_session track_selftest_sessions[5] = {
    {.params = {.none = (char)0}, .t0 = 0.0, .is_armed_again = 0U, .first = 0U, .count = 18U},
    {.params = {.none = (char)0}, .t0 = 0.0, .is_armed_again = 0U, .first = 18U, .count = 10U},
    {.params = {.none = (char)0}, .t0 = 1000.1, .is_armed_again = 1U, .first = 28U, .count = 4U},
    {.params = {.none = (char)0}, .t0 = 0.0, .is_armed_again = 0U, .first = 32U, .count = 7U},
    {.params = {.none = (char)0}, .t0 = 0.0, .is_armed_again = 0U, .first = 39U, .count = 1U},
};

/* 1 where what was returned is not what must be. */
static uint32_t track_selftest_differs(const track_selftest_call *call, ptc_status wanted, ptc_status status, double u)
{
    uint32_t failures = 1U;

    if ((status == wanted) && (fabs(u - call->u) <= call->tolerance)) {
        failures = 0U;
    }
    return failures;
}

/* The failures of one call. */
static uint32_t track_selftest_check(const track *self, const track_selftest_call *call)
{
    double u = 12345.0;
    ptc_status status = track_step(self, call->t, call->x, &u);
    uint32_t failures = track_selftest_differs(call, call->status, status, u);
    return failures;
}

/* Every session with its calls. */
static uint32_t track_selftest_run(void)
{
    static const track_selftest_call calls[40] = {
        {.t = 0.0, .x = {0.75, -1.25}, .u = -4.49794393011133, .tolerance = 4.5279756629651304e-13, .status = PTC_OK},
        {.t = 0.25, .x = {-0.7265644887436749, 1.2109408145727913}, .u = 25.0, .tolerance = 7.056717351349025e-13, .status = PTC_OK},
        {.t = 0.6, .x = {0.3165742343045077, -0.5276237238408461}, .u = -25.000000000000004, .tolerance = 1.1022201667852358e-12, .status = PTC_OK},
        {.t = 0.9, .x = {0.07904592066581294, -0.13174320110968823}, .u = 25.000000000000007, .tolerance = 6.3052569576479e-12, .status = PTC_OK},
        {.t = 0.4, .x = {0.4044766568421289, 0.0}, .u = -25.0, .tolerance = 4.712459247937672e-13, .status = PTC_OK},
        {.t = 0.4, .x = {0.0, 1.0}, .u = -11.29361192982259, .tolerance = 3.8113861456800135e-13, .status = PTC_OK},
        {.t = 0.95, .x = {0.08053854442608, 0.0}, .u = -24.999999999999964, .tolerance = 2.628158940958344e-11, .status = PTC_OK},
        {.t = 0.95, .x = {0.0, 3.8185938879706627}, .u = 25.00000000000002, .tolerance = 2.807274574236583e-11, .status = PTC_OK},
        {.t = (double)NAN, .x = {0.4658569711394252, -0.7764282852323754}, .u = 0.0, .tolerance = 0.0, .status = PTC_E_INPUT},
        {.t = (double)INFINITY, .x = {0.4658569711394252, -0.7764282852323754}, .u = 0.0, .tolerance = 0.0, .status = PTC_E_INPUT},
        {.t = -(double)INFINITY, .x = {0.4658569711394252, -0.7764282852323754}, .u = 0.0, .tolerance = 0.0, .status = PTC_E_INPUT},
        {.t = 0.5, .x = {(double)NAN, -0.7764282852323754}, .u = 0.0, .tolerance = 0.0, .status = PTC_E_INPUT},
        {.t = 0.5, .x = {0.4658569711394252, (double)NAN}, .u = 0.0, .tolerance = 0.0, .status = PTC_E_INPUT},
        {.t = 0.5, .x = {(double)INFINITY, -0.7764282852323754}, .u = 0.0, .tolerance = 0.0, .status = PTC_E_INPUT},
        {.t = 0.5, .x = {0.4658569711394252, (double)INFINITY}, .u = 0.0, .tolerance = 0.0, .status = PTC_E_INPUT},
        {.t = 0.5, .x = {-(double)INFINITY, -0.7764282852323754}, .u = 0.0, .tolerance = 0.0, .status = PTC_E_INPUT},
        {.t = 0.5, .x = {0.4658569711394252, -(double)INFINITY}, .u = 0.0, .tolerance = 0.0, .status = PTC_E_INPUT},
        {.t = -0.5, .x = {0.4658569711394252, -0.7764282852323754}, .u = 0.0, .tolerance = 0.0, .status = PTC_E_INPUT},
        {.t = 0.9116, .x = {0.09329278675043196, -0.15548797791738658}, .u = -25.000000000000025, .tolerance = 8.748027145038277e-12, .status = PTC_OK},
        {.t = 0.9116, .x = {0.07945288876233333, -0.13242148127055556}, .u = 24.999999999999968, .tolerance = 8.177575175641848e-12, .status = PTC_OK},
        {.t = 0.9779, .x = {0.07913412404651596, -0.13189020674419327}, .u = -25.00000000000009, .tolerance = 3.571506394449753e-11, .status = PTC_HOLD},
        {.t = 0.9779, .x = {0.07577919891943806, -0.1262986648657301}, .u = 24.99999999999995, .tolerance = 3.5180907466959407e-11, .status = PTC_HOLD},
        {.t = 1.0, .x = {0.07605453951347597, -0.12675756585579329}, .u = -24.999999999999908, .tolerance = 3.6819920546636034e-11, .status = PTC_HOLD},
        {.t = 1.0, .x = {0.07269961438639808, -0.12116602397733015}, .u = 25.00000000000014, .tolerance = 3.628576406909791e-11, .status = PTC_HOLD},
        {.t = 1.25, .x = {0.03274700634770508, -0.054578343912841804}, .u = -24.999999999999993, .tolerance = 4.638714884398232e-11, .status = PTC_HOLD},
        {.t = 1.25, .x = {0.029392081220627187, -0.04898680203437865}, .u = 24.999999999999996, .tolerance = 4.5852992366444195e-11, .status = PTC_HOLD},
        {.t = 11.0, .x = {-0.03310060348380632, 0.055167672473010534}, .u = -25.00000000000009, .tolerance = 3.362385766574302e-10, .status = PTC_HOLD},
        {.t = 11.0, .x = {-0.036455528610884226, 0.06075921435147371}, .u = 25.000000000000057, .tolerance = 3.3677273313496833e-10, .status = PTC_HOLD},
        {.t = 1000.1, .x = {-0.75, 1.25}, .u = 7.1919748221189534, .tolerance = 9.416052157274929e-11, .status = PTC_OK},
        {.t = 1000.8000000000001, .x = {-0.19618000488171583, 0.3269666748028597}, .u = 25.0, .tolerance = 6.477861721885836e-10, .status = PTC_OK},
        {.t = 1001.1, .x = {-0.1020248018372789, 0.17004133639546481}, .u = 24.99999999999998, .tolerance = 9.394188722434564e-9, .status = PTC_HOLD},
        {.t = 0.0, .x = {0.75, -1.25}, .u = 0.0, .tolerance = 0.0, .status = PTC_E_INPUT},
        {.t = 0.5, .x = {0.19641141240482793, -0.3273523540080465}, .u = -3.4443553012322154, .tolerance = 5.312300714253984e-13, .status = PTC_OK},
        {.t = 0.5, .x = {1.1784684744289675, -1.9641141240482793}, .u = -50.0, .tolerance = 0.0, .status = PTC_SATURATED},
        {.t = 0.5, .x = {-1.1784684744289675, 1.9641141240482793}, .u = 50.0, .tolerance = 0.0, .status = PTC_SATURATED},
        {.t = 1.0, .x = {0.0009310644145809918, -0.001551774024301653}, .u = 50.0, .tolerance = 0.0, .status = PTC_SATURATED},
        {.t = 1.0, .x = {0.3724257658323967, -0.6207096097206612}, .u = -50.0, .tolerance = 0.0, .status = PTC_SATURATED},
        {.t = 1.5, .x = {0.0008171106459794102, -0.0013618510766323503}, .u = -50.0, .tolerance = 0.0, .status = PTC_SATURATED},
        {.t = 1.5, .x = {-0.32684425839176406, 0.5447404306529401}, .u = 50.0, .tolerance = 0.0, .status = PTC_SATURATED},
        {.t = 0.5, .x = {-1.7976931348623157e308, 1.3482698511467367e308}, .u = 0.0, .tolerance = 0.0, .status = PTC_E_RANGE},
    };
    uint32_t failures = 0U;

    for (uint32_t i = 0U; i < 5U; i++) {
        const track_selftest_session *session = &track_selftest_sessions[i];
        track self;
        ptc_status status = track_init(&self, &session->params);

        if ((status == PTC_OK) && (session->is_armed_again != 0U)) {
            status = track_arm(&self, session->t0);
        }
        if (status == PTC_OK) {
            for (uint32_t j = 0U; j < session->count; j++) {
                failures += track_selftest_check(&self, &calls[session->first + j]);
            }
        } else {
            failures++;
        }
    }
    return failures;
}

/* What init and arm must refuse without a change. */
static uint32_t track_selftest_refuse(void)
{
    static const double starts[3] = {(double)NAN, (double)INFINITY, -(double)INFINITY};
    const track_selftest_session *session = &track_selftest_sessions[0];
    const track_selftest_call call = {.t = 0.0, .x = {0.75, -1.25}, .u = -4.49794393011133, .tolerance = 4.5279756629651304e-13, .status = PTC_OK};
    uint32_t failures = 0U;
    track self;

    if (track_init(&self, &session->params) != PTC_OK) {
        failures++;
    }
    for (uint32_t i = 0U; i < 3U; i++) {
        if (track_arm(&self, starts[i]) != PTC_E_PARAM) {
            failures++;
        }
    }
    failures += track_selftest_check(&self, &call);
    if (track_init(NULL, &session->params) != PTC_E_PARAM) {
        failures++;
    }
    if (track_arm(NULL, session->t0) != PTC_E_PARAM) {
        failures++;
    }
    return failures;
}

/* 1 where a call without one of its pointers was not refused with u = 0. */
static uint32_t track_selftest_refused(ptc_status status, double u)
{
    uint32_t failures = 1U;

    if ((status == PTC_E_INPUT) && (fabs(u) <= 0.0)) {
        failures = 0U;
    }
    return failures;
}

/* Calls that lack a pointer. */
static uint32_t track_selftest_pointers(void)
{
    const track_selftest_session *session = &track_selftest_sessions[0];
    const track_selftest_call call = {.t = 0.0, .x = {0.75, -1.25}, .u = -4.49794393011133, .tolerance = 4.5279756629651304e-13, .status = PTC_OK};
    uint32_t failures = 0U;
    double u = 12345.0;
    ptc_status status;
    track self;

    if (track_init(&self, &session->params) != PTC_OK) {
        failures++;
    }
    status = track_step(NULL, call.t, call.x, &u);
    failures += track_selftest_refused(status, u);
    u = 12345.0;
    status = track_step(&self, call.t, NULL, &u);
    failures += track_selftest_refused(status, u);
    status = track_step(&self, call.t, call.x, NULL);
    failures += track_selftest_refused(status, 0.0);
    return failures;
}

uint32_t track_selftest(void)
{
    uint32_t failures = track_selftest_run();

    failures += track_selftest_refuse();
    failures += track_selftest_pointers();
    return failures;
}
