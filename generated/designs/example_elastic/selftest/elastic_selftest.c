/* Self-test of the prescribed-time controller elastic: see elastic_selftest.h. DO NOT EDIT. */
#include "elastic_selftest.h"
#include "elastic.h"

#include <math.h>
#include <stddef.h>

/* A call, and what it must give. */
typedef struct elastic_selftest_call {
    uint32_t is_armed; /* arm is called before it */
    uint32_t start;
    uint32_t k;
    double y[1]; /* what is measured */
    ptc_status status;
    double u;
    double xhat[2]; /* the estimates behind it */
    double d;
} elastic_selftest_call;

/* A set of parameters that init takes, and the calls with it, one after the other. */
typedef struct elastic_selftest_session {
    elastic_params params;
    uint32_t first; /* of its calls */
    uint32_t count;
} elastic_selftest_session;

static const elastic_selftest_session elastic_selftest_sessions[4] = {
    {.params = {.none = (char)0}, .first = 0U, .count = 42U},
    {.params = {.none = (char)0}, .first = 42U, .count = 4U},
    {.params = {.none = (char)0}, .first = 46U, .count = 1U},
    {.params = {.none = (char)0}, .first = 47U, .count = 2U},
};

static const elastic_selftest_call elastic_selftest_calls[49] = {
    {.is_armed = 0U, .start = 0U, .k = 0U, .y = {0.75}, .status = PTC_OK, .u = -0.9478416292043547, .xhat = {0.75, 0.0}, .d = 0.0},
    {.is_armed = 0U, .start = 0U, .k = 1U, .y = {0.74850075}, .status = PTC_OK, .u = -1.8851752929431391, .xhat = {0.7498892626231063, -0.004531245289669245}, .d = -0.1622440768679525},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {0.747003}, .status = PTC_OK, .u = -2.8088302178513636, .xhat = {0.7496728892782093, -0.013494278284655211}, .d = -0.47911371830152294},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {(double)NAN}, .status = PTC_E_INPUT, .u = 0.0, .xhat = {0.7496728892782093, -0.013494278284655211}, .d = -0.47911371830152294},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {(double)INFINITY}, .status = PTC_E_INPUT, .u = 0.0, .xhat = {0.7496728892782093, -0.013494278284655211}, .d = -0.47911371830152294},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {-(double)INFINITY}, .status = PTC_E_INPUT, .u = 0.0, .xhat = {0.7496728892782093, -0.013494278284655211}, .d = -0.47911371830152294},
    {.is_armed = 0U, .start = 0U, .k = 3U, .y = {0.74550675}, .status = PTC_OK, .u = -3.715817204536232, .xhat = {0.7493557892353575, -0.026659071127628275}, .d = -0.9431409063612997},
    {.is_armed = 0U, .start = 0U, .k = 100U, .y = {0.6075}, .status = PTC_OK, .u = -2.7742714756423226, .xhat = {0.7289168553610371, -1.7201801542170632}, .d = -123.75034930534399},
    {.is_armed = 0U, .start = 0U, .k = 196U, .y = {0.4848120000000001}, .status = PTC_SATURATED, .u = 100.0, .xhat = {0.4848120000000001, -731.459028369092}, .d = -3405486.731241049},
    {.is_armed = 0U, .start = 0U, .k = 198U, .y = {0.4824030000000001}, .status = PTC_SATURATED, .u = -100.0, .xhat = {0.4824030000000001, 236.8778889876703}, .d = 3383745.2200988582},
    {.is_armed = 0U, .start = 0U, .k = 199U, .y = {0.48120075000000007}, .status = PTC_SATURATED, .u = -100.0, .xhat = {0.48120075000000007, -1.1940794903042615}, .d = 16845.88713573804},
    {.is_armed = 0U, .start = 0U, .k = 200U, .y = {0.4800000000000001}, .status = PTC_SATURATED, .u = -100.0, .xhat = {0.480595663706048, 0.9735099306903797}, .d = 16772.73545253918},
    {.is_armed = 0U, .start = 0U, .k = 201U, .y = {0.4788007500000001}, .status = PTC_SATURATED, .u = -100.0, .xhat = {0.48022680252184424, 2.8174322771996403}, .d = 16597.606195470602},
    {.is_armed = 0U, .start = 0U, .k = 600U, .y = {0.12000000000000002}, .status = PTC_SATURATED, .u = 100.0, .xhat = {0.2995374693587611, -62.5460403677921}, .d = -5450.854953850925},
    {.is_armed = 0U, .start = 0U, .k = 996U, .y = {1.2e-5}, .status = PTC_SATURATED, .u = 100.0, .xhat = {0.13287364911512892, -113.45350133069036}, .d = -21767.197827638684},
    {.is_armed = 0U, .start = 0U, .k = 998U, .y = {3e-6}, .status = PTC_SATURATED, .u = 100.0, .xhat = {0.03736033902163957, -130.6397414282647}, .d = -26354.941216261086},
    {.is_armed = 0U, .start = 0U, .k = 999U, .y = {7.5e-7}, .status = PTC_SATURATED, .u = 100.0, .xhat = {-0.014322585785883652, -128.9877855725038}, .d = -24595.93506711748},
    {.is_armed = 0U, .start = 0U, .k = 1000U, .y = {0.0}, .status = PTC_SATURATED, .u = 100.0, .xhat = {-0.039499182639737285, -117.58839036334402}, .d = -19745.158251711146},
    {.is_armed = 0U, .start = 0U, .k = 1001U, .y = {0.0}, .status = PTC_SATURATED, .u = 100.0, .xhat = {-0.04906708230537788, -101.8870824269735}, .d = -13719.376214208598},
    {.is_armed = 0U, .start = 0U, .k = 2147483647U, .y = {0.0}, .status = PTC_SATURATED, .u = 100.0, .xhat = {-0.049811571298235366, -85.0441324616238}, .d = -7602.1657038989915},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {0.0}, .status = PTC_SATURATED, .u = 100.0, .xhat = {-0.04589817047872103, -68.80340260717449}, .d = -1965.5482766876376},
    {.is_armed = 1U, .start = 4294967293U, .k = 4294967293U, .y = {0.75}, .status = PTC_SATURATED, .u = 100.0, .xhat = {-0.019334497643583477, -66.58525872028206}, .d = -1877.0365439398786},
    {.is_armed = 0U, .start = 0U, .k = 4294967294U, .y = {0.74850075}, .status = PTC_SATURATED, .u = 100.0, .xhat = {0.006486881254921084, -64.41764734866413}, .d = -1790.3341595651198},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {0.747003}, .status = PTC_SATURATED, .u = 100.0, .xhat = {0.031579377569619954, -62.29988311512061}, .d = -1705.4257595940671},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {(double)NAN}, .status = PTC_E_INPUT, .u = 0.0, .xhat = {0.031579377569619954, -62.29988311512061}, .d = -1705.4257595940671},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {(double)INFINITY}, .status = PTC_E_INPUT, .u = 0.0, .xhat = {0.031579377569619954, -62.29988311512061}, .d = -1705.4257595940671},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {-(double)INFINITY}, .status = PTC_E_INPUT, .u = 0.0, .xhat = {0.031579377569619954, -62.29988311512061}, .d = -1705.4257595940671},
    {.is_armed = 0U, .start = 0U, .k = 0U, .y = {0.74550675}, .status = PTC_SATURATED, .u = 100.0, .xhat = {0.055956297709710126, -60.23128234374978}, .d = -1622.2958828023884},
    {.is_armed = 0U, .start = 0U, .k = 97U, .y = {0.6075}, .status = PTC_SATURATED, .u = 100.0, .xhat = {0.10955378273401956, -53.50560251895241}, .d = -1118.6476480212066},
    {.is_armed = 0U, .start = 0U, .k = 193U, .y = {0.4848120000000001}, .status = PTC_SATURATED, .u = -100.0, .xhat = {0.4848120000000001, 1152.4910727842741}, .d = 5627544.935532384},
    {.is_armed = 0U, .start = 0U, .k = 195U, .y = {0.4824030000000001}, .status = PTC_SATURATED, .u = 100.0, .xhat = {0.48240300000000014, -382.4852172659796}, .d = -5287441.041723723},
    {.is_armed = 0U, .start = 0U, .k = 196U, .y = {0.48120075000000007}, .status = PTC_SATURATED, .u = -100.0, .xhat = {0.48120075000000007, -1.2048928571434772}, .d = 16894.499999994412},
    {.is_armed = 0U, .start = 0U, .k = 197U, .y = {0.4800000000000001}, .status = PTC_SATURATED, .u = -100.0, .xhat = {0.48059738478260855, 0.9975635093154471}, .d = 16821.13695651618},
    {.is_armed = 0U, .start = 0U, .k = 198U, .y = {0.4788007500000001}, .status = PTC_SATURATED, .u = -100.0, .xhat = {0.4802344734782604, 2.845506925463935}, .d = 16645.065652168425},
    {.is_armed = 0U, .start = 0U, .k = 597U, .y = {0.12000000000000002}, .status = PTC_SATURATED, .u = 100.0, .xhat = {0.2995490692360241, -62.51556118944338}, .d = -5404.820043483651},
    {.is_armed = 0U, .start = 0U, .k = 993U, .y = {1.2e-5}, .status = PTC_SATURATED, .u = 100.0, .xhat = {0.1328877670587081, -113.42177092581966}, .d = -21722.89669981622},
    {.is_armed = 0U, .start = 0U, .k = 995U, .y = {3e-6}, .status = PTC_SATURATED, .u = 100.0, .xhat = {0.03737598444565358, -130.60758363499355}, .d = -26312.561456299994},
    {.is_armed = 0U, .start = 0U, .k = 996U, .y = {7.5e-7}, .status = PTC_SATURATED, .u = 100.0, .xhat = {-0.014306111356667964, -128.95578756689974}, .d = -24555.578482674104},
    {.is_armed = 0U, .start = 0U, .k = 997U, .y = {0.0}, .status = PTC_SATURATED, .u = 100.0, .xhat = {-0.03948237272582003, -117.55696771295617}, .d = -19706.866042661117},
    {.is_armed = 0U, .start = 0U, .k = 998U, .y = {0.0}, .status = PTC_SATURATED, .u = 100.0, .xhat = {-0.04905028523906195, -101.8565251965473}, .d = -13683.146802776317},
    {.is_armed = 0U, .start = 0U, .k = 2147483644U, .y = {0.0}, .status = PTC_SATURATED, .u = 100.0, .xhat = {-0.049795031588865175, -85.01463826329928}, .d = -7567.967484845506},
    {.is_armed = 0U, .start = 0U, .k = 4294967292U, .y = {0.0}, .status = PTC_SATURATED, .u = 100.0, .xhat = {-0.04588205773185648, -68.7751005640306}, .d = -1933.328816021026},
    {.is_armed = 0U, .start = 0U, .k = 191U, .y = {-0.31871824754472255}, .status = PTC_OK, .u = 0.7612793627406796, .xhat = {-0.31871824754472255, 0.0}, .d = 0.0},
    {.is_armed = 0U, .start = 0U, .k = 192U, .y = {-0.869791367560407}, .status = PTC_SATURATED, .u = -100.0, .xhat = {-0.869791367560407, -1033.2621000294082}, .d = 964377.9600274478},
    {.is_armed = 0U, .start = 0U, .k = 935U, .y = {1.0898439580646755e154}, .status = PTC_SATURATED, .u = -100.0, .xhat = {5.496604310239233e153, 2.0375343563817848e156}, .d = 6.633832788219764e158},
    {.is_armed = 1U, .start = 4294967290U, .k = 150U, .y = {-7.92185154305487e153}, .status = PTC_SATURATED, .u = 100.0, .xhat = {-7.92185154305487e153, -0.014285714285714287}, .d = 0.0},
    {.is_armed = 0U, .start = 0U, .k = 185U, .y = {6.247079102547632e307}, .status = PTC_E_RANGE, .u = 0.0, .xhat = {0.0, 0.0}, .d = 0.0},
    {.is_armed = 0U, .start = 0U, .k = 126U, .y = {-0.0}, .status = PTC_OK, .u = 0.0, .xhat = {0.0, 0.0}, .d = 0.0},
    {.is_armed = 1U, .start = 4294967290U, .k = 897U, .y = {0.0}, .status = PTC_HOLD, .u = 0.0, .xhat = {0.0, 0.0}, .d = 0.0},
};

/* 1 where a number is not the one that must come. */
static uint32_t elastic_selftest_differs(double value, double wanted)
{
    uint32_t failures = 1U;

    if (fabs(value - wanted) <= 0.0) {
        failures = 0U;
    }
    return failures;
}

/* The failures of one call. */
static uint32_t elastic_selftest_check(elastic *self, const elastic_selftest_call *call)
{
    uint32_t failures = 0U;
    double u = 12345.0;
    double xhat[2] = {12345.0, 12345.0};
    double d = 12345.0;

    if (call->is_armed != 0U) {
        if (elastic_arm(self, call->start) != PTC_OK) {
            failures++;
        }
    }
    if (elastic_step(self, call->k, call->y, &u) != call->status) {
        failures++;
    }
    failures += elastic_selftest_differs(u, call->u);
    if (elastic_estimate(self, xhat) != PTC_OK) {
        failures++;
    }
    for (uint32_t i = 0U; i < 2U; i++) {
        failures += elastic_selftest_differs(xhat[i], call->xhat[i]);
    }
    if (elastic_disturbance(self, &d) != PTC_OK) {
        failures++;
    }
    failures += elastic_selftest_differs(d, call->d);
    return failures;
}

/* The calls of a session, of which init has been called. */
static uint32_t elastic_selftest_calls_of(elastic *self, const elastic_selftest_session *session)
{
    uint32_t failures = 0U;

    for (uint32_t j = 0U; j < session->count; j++) {
        failures += elastic_selftest_check(self, &elastic_selftest_calls[session->first + j]);
    }
    return failures;
}

/* Every session with its calls. */
static uint32_t elastic_selftest_run(void)
{
    uint32_t failures = 0U;

    for (uint32_t i = 0U; i < 4U; i++) {
        const elastic_selftest_session *session = &elastic_selftest_sessions[i];
        elastic self;

        if (elastic_init(&self, &session->params) == PTC_OK) {
            failures += elastic_selftest_calls_of(&self, session);
        } else {
            failures++;
        }
    }
    return failures;
}

/* What init must refuse without a change. */
static uint32_t elastic_selftest_refuse(void)
{
    const elastic_selftest_session *session = &elastic_selftest_sessions[0];
    uint32_t failures = 0U;
    elastic self;

    if (elastic_init(&self, &session->params) != PTC_OK) {
        failures++;
    }
    if (elastic_init(NULL, &session->params) != PTC_E_PARAM) {
        failures++;
    }
    failures += elastic_selftest_calls_of(&self, session);
    return failures;
}

/* Calls that lack a pointer: each is refused, and changes nothing. */
static uint32_t elastic_selftest_pointers(void)
{
    const elastic_selftest_session *session = &elastic_selftest_sessions[0];
    const elastic_selftest_call *call = &elastic_selftest_calls[0];
    uint32_t failures = 0U;
    double u = 12345.0;
    double xhat[2];
    double d;
    elastic self;

    if (elastic_init(&self, &session->params) != PTC_OK) {
        failures++;
    }
    if (elastic_arm(NULL, call->start) != PTC_E_INPUT) {
        failures++;
    }
    if (elastic_step(NULL, call->k, call->y, &u) != PTC_E_INPUT) {
        failures++;
    }
    failures += elastic_selftest_differs(u, 0.0);
    u = 12345.0;
    if (elastic_step(&self, call->k, NULL, &u) != PTC_E_INPUT) {
        failures++;
    }
    failures += elastic_selftest_differs(u, 0.0);
    if (elastic_step(&self, call->k, call->y, NULL) != PTC_E_INPUT) {
        failures++;
    }
    if (elastic_estimate(NULL, xhat) != PTC_E_INPUT) {
        failures++;
    }
    if (elastic_estimate(&self, NULL) != PTC_E_INPUT) {
        failures++;
    }
    if (elastic_disturbance(NULL, &d) != PTC_E_INPUT) {
        failures++;
    }
    if (elastic_disturbance(&self, NULL) != PTC_E_INPUT) {
        failures++;
    }
    failures += elastic_selftest_calls_of(&self, session);
    return failures;
}

uint32_t elastic_selftest(void)
{
    uint32_t failures = elastic_selftest_run();

    failures += elastic_selftest_refuse();
    failures += elastic_selftest_pointers();
    return failures;
}
