/* Self-test of the prescribed-time controller stage46: see stage46_selftest.h. DO NOT EDIT. */
#include "stage46_selftest.h"
#include "stage46.h"

#include <math.h>
#include <stddef.h>

/* A call, and what it must give. */
typedef struct stage46_selftest_call {
    uint32_t is_armed; /* arm is called before it */
    uint32_t start;
    uint32_t k;
    double y[1]; /* what is measured */
    ptc_status status;
    double u;
    double xhat[2]; /* the estimates behind it */
    double d;
} stage46_selftest_call;

/* A set of parameters that init takes, and the calls with it, one after the other. */
typedef struct stage46_selftest_session {
    stage46_params params;
    uint32_t first; /* of its calls */
    uint32_t count;
} stage46_selftest_session;

static const stage46_selftest_session stage46_selftest_sessions[3] = {
    {.params = {.none = (char)0}, .first = 0U, .count = 42U},
    {.params = {.none = (char)0}, .first = 42U, .count = 1U},
    {.params = {.none = (char)0}, .first = 43U, .count = 4U},
};

static const stage46_selftest_call stage46_selftest_calls[47] = {
    {.is_armed = 0U, .start = 0U, .k = 0U, .y = {0.75}, .status = PTC_SATURATED, .u = -6.0, .xhat = {0.75, 0.0}, .d = 0.0},
    {.is_armed = 0U, .start = 0U, .k = 1U, .y = {0.7129687499999999}, .status = PTC_SATURATED, .u = 6.0, .xhat = {0.7271919025476288, -10.708925550292674}, .d = -2514.0432401517264},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {0.676875}, .status = PTC_SATURATED, .u = 6.0, .xhat = {0.6916038795063746, -24.318667332649284}, .d = -5117.477312451228},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {(double)NAN}, .status = PTC_E_INPUT, .u = 0.0, .xhat = {0.6916038795063746, -24.318667332649284}, .d = -5117.477312451228},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {(double)INFINITY}, .status = PTC_E_INPUT, .u = 0.0, .xhat = {0.6916038795063746, -24.318667332649284}, .d = -5117.477312451228},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {-(double)INFINITY}, .status = PTC_E_INPUT, .u = 0.0, .xhat = {0.6916038795063746, -24.318667332649284}, .d = -5117.477312451228},
    {.is_armed = 0U, .start = 0U, .k = 3U, .y = {0.6417187500000001}, .status = PTC_SATURATED, .u = 6.0, .xhat = {0.6505568267816564, -36.08452776765973}, .d = -6679.67016065835},
    {.is_armed = 0U, .start = 0U, .k = 10U, .y = {0.421875}, .status = PTC_SATURATED, .u = 6.0, .xhat = {0.49456713028897376, -97.48970760945207}, .d = -19528.520522998682},
    {.is_armed = 0U, .start = 0U, .k = 16U, .y = {0.27}, .status = PTC_SATURATED, .u = 6.0, .xhat = {0.31505939373836783, -150.93844043099972}, .d = -27493.08842409763},
    {.is_armed = 0U, .start = 0U, .k = 18U, .y = {0.22687500000000005}, .status = PTC_SATURATED, .u = 6.0, .xhat = {0.1974934126929721, -156.30348312952853}, .d = -22299.684169534135},
    {.is_armed = 0U, .start = 0U, .k = 19U, .y = {0.20671875}, .status = PTC_SATURATED, .u = 6.0, .xhat = {0.138860254823786, -127.50500820398801}, .d = -10305.213146788206},
    {.is_armed = 0U, .start = 0U, .k = 20U, .y = {0.1875}, .status = PTC_SATURATED, .u = 6.0, .xhat = {0.11786753181043766, -85.37639881086685}, .d = 2002.8202066354916},
    {.is_armed = 0U, .start = 0U, .k = 21U, .y = {0.16921875}, .status = PTC_SATURATED, .u = -6.0, .xhat = {0.117089484151534, -44.11830351607924}, .d = 11217.038220647888},
    {.is_armed = 0U, .start = 0U, .k = 30U, .y = {0.046875}, .status = PTC_SATURATED, .u = 6.0, .xhat = {0.05905345604505986, -42.0646937092326}, .d = 9064.40961084845},
    {.is_armed = 0U, .start = 0U, .k = 36U, .y = {0.0075000000000000015}, .status = PTC_SATURATED, .u = 6.0, .xhat = {0.012884092761050963, -37.060086400010775}, .d = 8112.732972006061},
    {.is_armed = 0U, .start = 0U, .k = 38U, .y = {0.0018750000000000004}, .status = PTC_SATURATED, .u = 6.0, .xhat = {-0.006571657019870536, -22.58167888526558}, .d = 9605.739597054582},
    {.is_armed = 0U, .start = 0U, .k = 39U, .y = {0.0004687500000000001}, .status = PTC_SATURATED, .u = -6.0, .xhat = {-0.009062789641227913, -5.793432669459339}, .d = 11290.506931372602},
    {.is_armed = 0U, .start = 0U, .k = 40U, .y = {0.0}, .status = PTC_SATURATED, .u = -6.0, .xhat = {-0.0035366439300931586, 8.165891553539375}, .d = 11915.633866874436},
    {.is_armed = 0U, .start = 0U, .k = 41U, .y = {0.0}, .status = PTC_SATURATED, .u = -6.0, .xhat = {0.00406518183335709, 17.01476027316234}, .d = 11197.084102754612},
    {.is_armed = 0U, .start = 0U, .k = 2147483647U, .y = {0.0}, .status = PTC_SATURATED, .u = -6.0, .xhat = {0.010245656856293583, 20.49166314074592}, .d = 9386.091478283804},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {0.0}, .status = PTC_SATURATED, .u = -6.0, .xhat = {0.013607124448306421, 19.62665022445067}, .d = 6980.935580348154},
    {.is_armed = 1U, .start = 4294967293U, .k = 4294967293U, .y = {0.75}, .status = PTC_SATURATED, .u = -6.0, .xhat = {0.47604023419590497, 232.8719415467658}, .d = 55405.270128328215},
    {.is_armed = 0U, .start = 0U, .k = 4294967294U, .y = {0.7129687499999999}, .status = PTC_SATURATED, .u = -6.0, .xhat = {0.7220496981329547, 281.43396535039693}, .d = 53800.14804365865},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {0.676875}, .status = PTC_SATURATED, .u = -6.0, .xhat = {0.8126512978834964, 232.99914125446324}, .d = 29800.722970787785},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {(double)NAN}, .status = PTC_E_INPUT, .u = 0.0, .xhat = {0.8126512978834964, 232.99914125446324}, .d = 29800.722970787785},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {(double)INFINITY}, .status = PTC_E_INPUT, .u = 0.0, .xhat = {0.8126512978834964, 232.99914125446324}, .d = 29800.722970787785},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {-(double)INFINITY}, .status = PTC_E_INPUT, .u = 0.0, .xhat = {0.8126512978834964, 232.99914125446324}, .d = 29800.722970787785},
    {.is_armed = 0U, .start = 0U, .k = 0U, .y = {0.6417187500000001}, .status = PTC_SATURATED, .u = -6.0, .xhat = {0.8025847612309069, 141.6742930137676}, .d = 1366.51285098882},
    {.is_armed = 0U, .start = 0U, .k = 7U, .y = {0.421875}, .status = PTC_SATURATED, .u = 6.0, .xhat = {0.6227762248542011, -8.228161520411163}, .d = -34144.20564771048},
    {.is_armed = 0U, .start = 0U, .k = 13U, .y = {0.27}, .status = PTC_SATURATED, .u = 6.0, .xhat = {0.39577749529266326, -137.07902009868212}, .d = -56376.271340941814},
    {.is_armed = 0U, .start = 0U, .k = 15U, .y = {0.22687500000000005}, .status = PTC_SATURATED, .u = 6.0, .xhat = {0.22827243211646797, -194.50144893049873}, .d = -56623.277393517885},
    {.is_armed = 0U, .start = 0U, .k = 16U, .y = {0.20671875}, .status = PTC_SATURATED, .u = 6.0, .xhat = {0.12941915690585892, -192.91815618029867}, .d = -42960.025253456864},
    {.is_armed = 0U, .start = 0U, .k = 17U, .y = {0.1875}, .status = PTC_SATURATED, .u = 6.0, .xhat = {0.08284601497816449, -157.0758857189129}, .d = -24461.690041341906},
    {.is_armed = 0U, .start = 0U, .k = 18U, .y = {0.16921875}, .status = PTC_SATURATED, .u = 6.0, .xhat = {0.07101722087626611, -107.59347653862474}, .d = -7103.872241149384},
    {.is_armed = 0U, .start = 0U, .k = 27U, .y = {0.046875}, .status = PTC_SATURATED, .u = 6.0, .xhat = {0.01345951984738225, -89.53209607659463}, .d = -1197.4487733002861},
    {.is_armed = 0U, .start = 0U, .k = 33U, .y = {0.0075000000000000015}, .status = PTC_SATURATED, .u = 6.0, .xhat = {-0.024827792859654883, -66.38323592189698}, .d = 4516.7182396514},
    {.is_armed = 0U, .start = 0U, .k = 35U, .y = {0.0018750000000000004}, .status = PTC_SATURATED, .u = 6.0, .xhat = {-0.03300940524386102, -35.59527884916948}, .d = 10682.784651184249},
    {.is_armed = 0U, .start = 0U, .k = 36U, .y = {0.0004687500000000001}, .status = PTC_SATURATED, .u = -6.0, .xhat = {-0.02400862742507979, -6.476936360240394}, .d = 15009.334974405181},
    {.is_armed = 0U, .start = 0U, .k = 37U, .y = {0.0}, .status = PTC_SATURATED, .u = -6.0, .xhat = {-0.008825468334763817, 15.183288558708558}, .d = 16569.299190066},
    {.is_armed = 0U, .start = 0U, .k = 38U, .y = {0.0}, .status = PTC_SATURATED, .u = -6.0, .xhat = {0.005622802699118416, 27.513055464901104}, .d = 15575.428874108367},
    {.is_armed = 0U, .start = 0U, .k = 2147483644U, .y = {0.0}, .status = PTC_SATURATED, .u = -6.0, .xhat = {0.015716983532594563, 31.248820461602044}, .d = 12797.340396650354},
    {.is_armed = 0U, .start = 0U, .k = 4294967292U, .y = {0.0}, .status = PTC_SATURATED, .u = -6.0, .xhat = {0.02049534886363806, 28.608760233602176}, .d = 9174.641906098726},
    {.is_armed = 0U, .start = 0U, .k = 40U, .y = {5.760328347710473e301}, .status = PTC_E_RANGE, .u = 0.0, .xhat = {0.0, 0.0}, .d = 0.0},
    {.is_armed = 1U, .start = 0U, .k = 4294967295U, .y = {0.0}, .status = PTC_HOLD, .u = -0.0, .xhat = {0.0, 0.0}, .d = 0.0},
    {.is_armed = 1U, .start = 4294967290U, .k = 10U, .y = {-0.0}, .status = PTC_OK, .u = -0.0, .xhat = {0.0, 0.0}, .d = 0.0},
    {.is_armed = 1U, .start = 4294967290U, .k = 4U, .y = {-8.768438085157633e153}, .status = PTC_SATURATED, .u = 6.0, .xhat = {-5.4006113850155765e153, -2.5357110723052496e156}, .d = -5.952872909955633e158},
    {.is_armed = 1U, .start = 4294967290U, .k = 3U, .y = {-1.1090517773559043e154}, .status = PTC_SATURATED, .u = 6.0, .xhat = {-1.1090517773559043e154, 0.0}, .d = 0.0},
};

/* 1 where a number is not the one that must come. */
static uint32_t stage46_selftest_differs(double value, double wanted)
{
    uint32_t failures = 1U;

    if (fabs(value - wanted) <= 0.0) {
        failures = 0U;
    }
    return failures;
}

/* The failures of one call. */
static uint32_t stage46_selftest_check(stage46 *self, const stage46_selftest_call *call)
{
    uint32_t failures = 0U;
    double u = 12345.0;
    double xhat[2] = {12345.0, 12345.0};
    double d = 12345.0;

    if (call->is_armed != 0U) {
        if (stage46_arm(self, call->start) != PTC_OK) {
            failures++;
        }
    }
    if (stage46_step(self, call->k, call->y, &u) != call->status) {
        failures++;
    }
    failures += stage46_selftest_differs(u, call->u);
    if (stage46_estimate(self, xhat) != PTC_OK) {
        failures++;
    }
    for (uint32_t i = 0U; i < 2U; i++) {
        failures += stage46_selftest_differs(xhat[i], call->xhat[i]);
    }
    if (stage46_disturbance(self, &d) != PTC_OK) {
        failures++;
    }
    failures += stage46_selftest_differs(d, call->d);
    return failures;
}

/* The calls of a session, of which init has been called. */
static uint32_t stage46_selftest_calls_of(stage46 *self, const stage46_selftest_session *session)
{
    uint32_t failures = 0U;

    for (uint32_t j = 0U; j < session->count; j++) {
        failures += stage46_selftest_check(self, &stage46_selftest_calls[session->first + j]);
    }
    return failures;
}

/* Every session with its calls. */
static uint32_t stage46_selftest_run(void)
{
    uint32_t failures = 0U;

    for (uint32_t i = 0U; i < 3U; i++) {
        const stage46_selftest_session *session = &stage46_selftest_sessions[i];
        stage46 self;

        if (stage46_init(&self, &session->params) == PTC_OK) {
            failures += stage46_selftest_calls_of(&self, session);
        } else {
            failures++;
        }
    }
    return failures;
}

/* What init must refuse without a change. */
static uint32_t stage46_selftest_refuse(void)
{
    const stage46_selftest_session *session = &stage46_selftest_sessions[0];
    uint32_t failures = 0U;
    stage46 self;

    if (stage46_init(&self, &session->params) != PTC_OK) {
        failures++;
    }
    if (stage46_init(NULL, &session->params) != PTC_E_PARAM) {
        failures++;
    }
    failures += stage46_selftest_calls_of(&self, session);
    return failures;
}

/* Calls that lack a pointer: each is refused, and changes nothing. */
static uint32_t stage46_selftest_pointers(void)
{
    const stage46_selftest_session *session = &stage46_selftest_sessions[0];
    const stage46_selftest_call *call = &stage46_selftest_calls[0];
    uint32_t failures = 0U;
    double u = 12345.0;
    double xhat[2];
    double d;
    stage46 self;

    if (stage46_init(&self, &session->params) != PTC_OK) {
        failures++;
    }
    if (stage46_arm(NULL, call->start) != PTC_E_INPUT) {
        failures++;
    }
    if (stage46_step(NULL, call->k, call->y, &u) != PTC_E_INPUT) {
        failures++;
    }
    failures += stage46_selftest_differs(u, 0.0);
    u = 12345.0;
    if (stage46_step(&self, call->k, NULL, &u) != PTC_E_INPUT) {
        failures++;
    }
    failures += stage46_selftest_differs(u, 0.0);
    if (stage46_step(&self, call->k, call->y, NULL) != PTC_E_INPUT) {
        failures++;
    }
    if (stage46_estimate(NULL, xhat) != PTC_E_INPUT) {
        failures++;
    }
    if (stage46_estimate(&self, NULL) != PTC_E_INPUT) {
        failures++;
    }
    if (stage46_disturbance(NULL, &d) != PTC_E_INPUT) {
        failures++;
    }
    if (stage46_disturbance(&self, NULL) != PTC_E_INPUT) {
        failures++;
    }
    failures += stage46_selftest_calls_of(&self, session);
    return failures;
}

uint32_t stage46_selftest(void)
{
    uint32_t failures = stage46_selftest_run();

    failures += stage46_selftest_refuse();
    failures += stage46_selftest_pointers();
    return failures;
}
