/* Self-test of the prescribed-time controller paced: see paced_selftest.h. DO NOT EDIT. */
#include "paced_selftest.h"
#include "paced.h"

#include <math.h>
#include <stddef.h>

/* A call, and what it must give. */
typedef struct paced_selftest_call {
    uint32_t is_armed; /* arm is called before it */
    uint32_t start;
    uint32_t command; /* called before it: 0 none, 1 arm_for, 2 soonest, 3 deadline, 4 applied */
    uint32_t samples;
    double given[1];
    ptc_status told; /* its status */
    uint32_t found; /* its result */
    uint32_t k;
    double y[2]; /* what is measured */
    ptc_status status;
    double u;
} paced_selftest_call;

/* A set of parameters that init takes, and the calls with it, one after the other. */
typedef struct paced_selftest_session {
    paced_params params;
    uint32_t first; /* of its calls */
    uint32_t count;
} paced_selftest_session;

static const paced_selftest_session paced_selftest_sessions[11] = {
    {.params = {.u_max = (double)INFINITY}, .first = 0U, .count = 48U},
    {.params = {.u_max = (double)INFINITY}, .first = 48U, .count = 3U},
    {.params = {.u_max = (double)INFINITY}, .first = 51U, .count = 2U},
    {.params = {.u_max = (double)INFINITY}, .first = 53U, .count = 3U},
    {.params = {.u_max = (double)INFINITY}, .first = 56U, .count = 3U},
    {.params = {.u_max = (double)INFINITY}, .first = 59U, .count = 2U},
    {.params = {.u_max = (double)INFINITY}, .first = 61U, .count = 1U},
    {.params = {.u_max = (double)INFINITY}, .first = 62U, .count = 1U},
    {.params = {.u_max = 1.0}, .first = 63U, .count = 7U},
    {.params = {.u_max = 1.0}, .first = 70U, .count = 7U},
    {.params = {.u_max = (double)INFINITY}, .first = 77U, .count = 14U},
};

static const paced_selftest_call paced_selftest_calls[91] = {
    {.is_armed = 0U, .start = 0U, .k = 0U, .y = {0.75, 0.25}, .status = PTC_LATE, .u = -0.018206583332633752},
    {.is_armed = 0U, .start = 0U, .k = 1U, .y = {0.7350749999999999, 0.245025}, .status = PTC_OK, .u = -0.03640769202946967},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {0.7202999999999999, 0.24009999999999998}, .status = PTC_OK, .u = -0.054612759537882},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {(double)NAN, 0.5}, .status = PTC_E_INPUT, .u = 0.0},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {0.5, (double)NAN}, .status = PTC_E_INPUT, .u = 0.0},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {(double)INFINITY, 0.5}, .status = PTC_E_INPUT, .u = 0.0},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {0.5, (double)INFINITY}, .status = PTC_E_INPUT, .u = 0.0},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {-(double)INFINITY, 0.5}, .status = PTC_E_INPUT, .u = 0.0},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {0.5, -(double)INFINITY}, .status = PTC_E_INPUT, .u = 0.0},
    {.is_armed = 0U, .start = 0U, .k = 3U, .y = {0.7056749999999999, 0.235225}, .status = PTC_OK, .u = -0.07283214110888411},
    {.is_armed = 0U, .start = 0U, .k = 25U, .y = {0.421875, 0.140625}, .status = PTC_OK, .u = -0.08651408369937112},
    {.is_armed = 0U, .start = 0U, .k = 46U, .y = {0.2187, 0.0729}, .status = PTC_OK, .u = -0.09475959550790174},
    {.is_armed = 0U, .start = 0U, .k = 48U, .y = {0.20280000000000004, 0.06760000000000001}, .status = PTC_OK, .u = -0.10375789911184755},
    {.is_armed = 0U, .start = 0U, .k = 49U, .y = {0.195075, 0.065025}, .status = PTC_OK, .u = -0.11404353552371368},
    {.is_armed = 0U, .start = 0U, .k = 50U, .y = {0.1875, 0.0625}, .status = PTC_OK, .u = -0.12567883363964744},
    {.is_armed = 0U, .start = 0U, .k = 51U, .y = {0.18007499999999999, 0.060024999999999995}, .status = PTC_OK, .u = -0.13884496848477335},
    {.is_armed = 0U, .start = 0U, .k = 75U, .y = {0.046875, 0.015625}, .status = PTC_OK, .u = -0.1388096032396375},
    {.is_armed = 0U, .start = 0U, .k = 96U, .y = {0.0012000000000000001, 0.0004}, .status = PTC_OK, .u = -0.12991808372745092},
    {.is_armed = 0U, .start = 0U, .k = 98U, .y = {0.00030000000000000003, 0.0001}, .status = PTC_OK, .u = -0.12073381505485964},
    {.is_armed = 0U, .start = 0U, .k = 99U, .y = {7.500000000000001e-5, 2.5e-5}, .status = PTC_OK, .u = -0.11153458023246218},
    {.is_armed = 0U, .start = 0U, .k = 100U, .y = {0.0, 0.0}, .status = PTC_OK, .u = -0.10242971654001629},
    {.is_armed = 0U, .start = 0U, .k = 101U, .y = {0.0, 0.0}, .status = PTC_OK, .u = -0.0934577705657083},
    {.is_armed = 0U, .start = 0U, .k = 2147483647U, .y = {0.0, 0.0}, .status = PTC_AFTER, .u = 0.0},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {0.0, 0.0}, .status = PTC_AFTER, .u = 0.0},
    {.is_armed = 1U, .start = 4294967293U, .k = 4294967293U, .y = {0.75, 0.25}, .status = PTC_LATE, .u = -0.018206583332633752},
    {.is_armed = 0U, .start = 0U, .k = 4294967294U, .y = {0.7350749999999999, 0.245025}, .status = PTC_OK, .u = -0.03640769202946967},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {0.7202999999999999, 0.24009999999999998}, .status = PTC_OK, .u = -0.054612759537882},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {(double)NAN, 0.5}, .status = PTC_E_INPUT, .u = 0.0},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {0.5, (double)NAN}, .status = PTC_E_INPUT, .u = 0.0},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {(double)INFINITY, 0.5}, .status = PTC_E_INPUT, .u = 0.0},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {0.5, (double)INFINITY}, .status = PTC_E_INPUT, .u = 0.0},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {-(double)INFINITY, 0.5}, .status = PTC_E_INPUT, .u = 0.0},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {0.5, -(double)INFINITY}, .status = PTC_E_INPUT, .u = 0.0},
    {.is_armed = 0U, .start = 0U, .k = 0U, .y = {0.7056749999999999, 0.235225}, .status = PTC_OK, .u = -0.07283214110888411},
    {.is_armed = 0U, .start = 0U, .k = 22U, .y = {0.421875, 0.140625}, .status = PTC_OK, .u = -0.08651408369937112},
    {.is_armed = 0U, .start = 0U, .k = 43U, .y = {0.2187, 0.0729}, .status = PTC_OK, .u = -0.09475959550790174},
    {.is_armed = 0U, .start = 0U, .k = 45U, .y = {0.20280000000000004, 0.06760000000000001}, .status = PTC_OK, .u = -0.10375789911184755},
    {.is_armed = 0U, .start = 0U, .k = 46U, .y = {0.195075, 0.065025}, .status = PTC_OK, .u = -0.11404353552371368},
    {.is_armed = 0U, .start = 0U, .k = 47U, .y = {0.1875, 0.0625}, .status = PTC_OK, .u = -0.12567883363964744},
    {.is_armed = 0U, .start = 0U, .k = 48U, .y = {0.18007499999999999, 0.060024999999999995}, .status = PTC_OK, .u = -0.13884496848477335},
    {.is_armed = 0U, .start = 0U, .k = 72U, .y = {0.046875, 0.015625}, .status = PTC_OK, .u = -0.1388096032396375},
    {.is_armed = 0U, .start = 0U, .k = 93U, .y = {0.0012000000000000001, 0.0004}, .status = PTC_OK, .u = -0.12991808372745092},
    {.is_armed = 0U, .start = 0U, .k = 95U, .y = {0.00030000000000000003, 0.0001}, .status = PTC_OK, .u = -0.12073381505485964},
    {.is_armed = 0U, .start = 0U, .k = 96U, .y = {7.500000000000001e-5, 2.5e-5}, .status = PTC_OK, .u = -0.11153458023246218},
    {.is_armed = 0U, .start = 0U, .k = 97U, .y = {0.0, 0.0}, .status = PTC_OK, .u = -0.10242971654001629},
    {.is_armed = 0U, .start = 0U, .k = 98U, .y = {0.0, 0.0}, .status = PTC_OK, .u = -0.0934577705657083},
    {.is_armed = 0U, .start = 0U, .k = 2147483644U, .y = {0.0, 0.0}, .status = PTC_AFTER, .u = 0.0},
    {.is_armed = 0U, .start = 0U, .k = 4294967292U, .y = {0.0, 0.0}, .status = PTC_AFTER, .u = 0.0},
    {.is_armed = 0U, .start = 0U, .k = 0U, .y = {-0.6358609338834258, -0.9782225903285677}, .status = PTC_LATE, .u = 0.03574955889720914},
    {.is_armed = 0U, .start = 0U, .k = 79U, .y = {1.3115733841649354e154, 1.2173369013491698e154}, .status = PTC_SATURATED, .u = -1.0},
    {.is_armed = 1U, .start = 4294967290U, .k = 15U, .y = {-7.692634803472608e153, -3.359349343346062e153}, .status = PTC_INFEASIBLE, .u = 2.0445282943829638e154},
    {.is_armed = 1U, .start = 4294967290U, .k = 28U, .y = {8.543975239497756e153, 1.0829232609275264e154}, .status = PTC_SATURATED, .u = -1.0},
    {.is_armed = 1U, .start = 4294967290U, .k = 40U, .y = {9.621126313878496e153, -5.556314198532045e153}, .status = PTC_LATE, .u = 5.479588584577151e149},
    {.is_armed = 1U, .start = 4294967290U, .k = 94U, .y = {-0.6305577172440252, 0.8167508788204515}, .status = PTC_AFTER, .u = 0.0},
    {.is_armed = 1U, .start = 0U, .k = 32U, .y = {-0.7116943737062251, 0.8404327911476001}, .status = PTC_LATE, .u = -0.013037148210126023},
    {.is_armed = 0U, .start = 0U, .k = 24U, .y = {7.9498691008896995e301, 1.2774545483478825e302}, .status = PTC_E_RANGE, .u = 0.0},
    {.is_armed = 1U, .start = 4294967290U, .k = 93U, .y = {0.0, -0.0}, .status = PTC_OK, .u = 0.0},
    {.is_armed = 1U, .start = 4294967290U, .k = 90U, .y = {4.8189187812160184e153, 1.0791998030724952e154}, .status = PTC_SATURATED, .u = -1.0},
    {.is_armed = 1U, .start = 4294967290U, .k = 90U, .y = {-3.585175536313194e153, -6.557064644594935e153}, .status = PTC_INFEASIBLE, .u = 2.161078557514881e157},
    {.is_armed = 1U, .start = 4294967290U, .k = 78U, .y = {1.4455696947888423e302, 9.966685730714218e301}, .status = PTC_E_RANGE, .u = 0.0},
    {.is_armed = 1U, .start = 0U, .k = 97U, .y = {-4.738738634319199e301, 8.681083203645141e301}, .status = PTC_INFEASIBLE, .u = 4.521711554228071e305},
    {.is_armed = 0U, .start = 0U, .k = 97U, .y = {5.60239068182508e153, -1.0638892923200089e154}, .status = PTC_SATURATED, .u = -1.0},
    {.is_armed = 1U, .start = 0U, .k = 49U, .y = {-6.969925865008471e301, -1.2135972521739946e302}, .status = PTC_INFEASIBLE, .u = 8.213158025535846e302},
    {.is_armed = 0U, .start = 0U, .k = 0U, .y = {0.2781010062626952, 0.7299343799177456}, .status = PTC_LATE, .u = -0.01305886327790318},
    {.is_armed = 0U, .start = 0U, .k = 7U, .y = {-0.91315220119516, -0.5233251495730313}, .status = PTC_LATE, .u = 0.00010882327815662889},
    {.is_armed = 0U, .start = 0U, .k = 31U, .y = {-0.5230701678930358, -0.9136934170658975}, .status = PTC_LATE, .u = 0.010328788935367685},
    {.is_armed = 0U, .start = 0U, .k = 97U, .y = {0.938244858089696, 0.5759038786742109}, .status = PTC_OK, .u = -0.0011390490155064985},
    {.is_armed = 1U, .start = 4294967290U, .k = 43U, .y = {0.45506281846934254, 0.32537914572186616}, .status = PTC_LATE, .u = -0.02075776247094521},
    {.is_armed = 1U, .start = 4294967290U, .k = 51U, .y = {4.881887505664583e153, -6.851810052873952e153}, .status = PTC_SATURATED, .u = -1.0},
    {.is_armed = 1U, .start = 4294967290U, .k = 4294967292U, .y = {-1.1295539595849167e154, -6.689088159359278e153}, .status = PTC_SATURATED, .u = 1.0},
    {.is_armed = 1U, .start = 0U, .k = 24U, .y = {-980.7356882337248, 310.4685899838245}, .status = PTC_LATE, .u = -3.4450971057517806e-5},
    {.is_armed = 1U, .start = 4294967290U, .k = 4294967292U, .y = {474.8116851764761, 317.1103484138933}, .status = PTC_LATE, .u = -6.804572029417011e-5},
    {.is_armed = 0U, .start = 0U, .k = 11U, .y = {0.3894503629052933, 0.812550873131496}, .status = PTC_OK, .u = -6.813993996013665e-5},
    {.is_armed = 1U, .start = 4294967290U, .k = 91U, .y = {-0.5100515915771027, -0.4194034841864838}, .status = PTC_LATE, .u = 0.01688113859512657},
    {.is_armed = 1U, .start = 4294967290U, .k = 4294967290U, .y = {0.7882081229685903, -0.8260997958450387}, .status = PTC_LATE, .u = 0.02099907383745377},
    {.is_armed = 0U, .start = 0U, .k = 63U, .y = {0.37623140846405434, 0.8566536825266087}, .status = PTC_LATE, .u = 0.009719866681067299},
    {.is_armed = 1U, .start = 4294967290U, .k = 78U, .y = {0.34355909782881733, -0.8015809280840673}, .status = PTC_LATE, .u = 0.02583033405160752},
    {.command = 1U, .samples = 1024U, .told = PTC_OK, .found = 0U, .is_armed = 0U, .start = 0U, .k = 50U, .y = {7.309684141600448e-5, -0.03770801174364487}, .status = PTC_OK, .u = 0.000244376897735145},
    {.command = 2U, .samples = 1024U, .told = PTC_OK, .found = 117U, .is_armed = 0U, .start = 0U, .k = 7U, .y = {0.09527314141919903, 0.0002834403462306929}, .status = PTC_AFTER, .u = 0.0},
    {.command = 3U, .samples = 1024U, .told = PTC_OK, .found = 1010U, .is_armed = 0U, .start = 0U, .k = 50U, .y = {-15.367561916847738, 0.8853972510381078}, .status = PTC_LATE, .u = 0.008133077953323638},
    {.command = 4U, .samples = 1024U, .told = PTC_OK, .given = {-0.4971078945764067}, .found = 0U, .is_armed = 0U, .start = 0U, .k = 1U, .y = {0.020776921839198992, 0.5749530967891172}, .status = PTC_AFTER, .u = 0.0},
    {.command = 1U, .samples = 0U, .told = PTC_E_PARAM, .found = 0U, .is_armed = 0U, .start = 0U, .k = 50U, .y = {0.0006771160586541306, -0.28134760768996214}, .status = PTC_OK, .u = 0.0014519891428888515},
    {.command = 1U, .samples = 4294967295U, .told = PTC_E_PARAM, .found = 0U, .is_armed = 0U, .start = 0U, .k = 100U, .y = {-0.030280711727923106, 57.33109715488656}, .status = PTC_LATE, .u = 0.0012657874389261797},
    {.command = 2U, .samples = 2147483648U, .told = PTC_OK, .found = 2394U, .is_armed = 0U, .start = 0U, .k = 50U, .y = {-53.55952632496157, -0.009218936158192715}, .status = PTC_OK, .u = 0.0012664209566853638},
    {.command = 2U, .samples = 0U, .told = PTC_E_INPUT, .found = 0U, .is_armed = 0U, .start = 0U, .k = 7U, .y = {73.7260486031978, (double)INFINITY}, .status = PTC_E_INPUT, .u = 0.0},
    {.command = 2U, .samples = 3U, .told = PTC_E_RANGE, .found = 0U, .is_armed = 0U, .start = 0U, .k = 2U, .y = {-1.7976931348623157e308, 76.5834584543789}, .status = PTC_E_RANGE, .u = 0.0},
    {.command = 2U, .samples = 3000U, .told = PTC_E_INPUT, .found = 0U, .is_armed = 0U, .start = 0U, .k = 100U, .y = {(double)NAN, 29.330280438891542}, .status = PTC_E_INPUT, .u = 0.0},
    {.command = 4U, .samples = 0U, .told = PTC_E_INPUT, .given = {(double)NAN}, .found = 0U, .is_armed = 0U, .start = 0U, .k = 50U, .y = {0.308609153571199, 0.08052999611851286}, .status = PTC_OK, .u = 0.0012656756871531271},
    {.command = 2U, .samples = 0U, .told = PTC_OK, .found = 194U, .is_armed = 0U, .start = 0U, .k = 1U, .y = {0.00014758960357349517, -0.6304964011127101}, .status = PTC_AFTER, .u = 0.0},
    {.command = 2U, .samples = 3U, .told = PTC_OK, .found = 6U, .is_armed = 0U, .start = 0U, .k = 1U, .y = {9.50199431579759e-5, 0.005374570807579637}, .status = PTC_AFTER, .u = 0.0},
    {.command = 1U, .samples = 2147483648U, .told = PTC_OK, .found = 0U, .is_armed = 0U, .start = 0U, .k = 100U, .y = {1.7976931348623157e308, 0.04040287034143922}, .status = PTC_E_RANGE, .u = 0.0},
};

/* 1 where a number is not the one that must come. */
static uint32_t paced_selftest_differs(double value, double wanted)
{
    uint32_t failures = 1U;

    if (fabs(value - wanted) <= 0.0) {
        failures = 0U;
    }
    return failures;
}

/* The failures of what is called before a call. */
static uint32_t paced_selftest_command(paced *self, const paced_selftest_call *call)
{
    uint32_t failures = 0U;
    uint32_t found = 0U;
    ptc_status told = call->told;

    switch (call->command) {
    case 1U:
        told = paced_arm_for(self, call->k, call->samples);
        break;
    case 2U:
        told = paced_soonest(self, call->y, &found);
        break;
    case 3U:
        told = paced_deadline(self, &found);
        break;
    case 4U:
        told = paced_applied(self, call->given[0]);
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
static uint32_t paced_selftest_check(paced *self, const paced_selftest_call *call)
{
    uint32_t failures = 0U;
    double u = 12345.0;

    if (call->is_armed != 0U) {
        if (paced_arm(self, call->start) != PTC_OK) {
            failures++;
        }
    }
    failures += paced_selftest_command(self, call);
    if (paced_step(self, call->k, call->y, &u) != call->status) {
        failures++;
    }
    failures += paced_selftest_differs(u, call->u);
    return failures;
}

/* The calls of a session, of which init has been called. */
static uint32_t paced_selftest_calls_of(paced *self, const paced_selftest_session *session)
{
    uint32_t failures = 0U;

    for (uint32_t j = 0U; j < session->count; j++) {
        failures += paced_selftest_check(self, &paced_selftest_calls[session->first + j]);
    }
    return failures;
}

/* Every session with its calls. */
static uint32_t paced_selftest_run(void)
{
    uint32_t failures = 0U;

    for (uint32_t i = 0U; i < 11U; i++) {
        const paced_selftest_session *session = &paced_selftest_sessions[i];
        paced self;

        if (paced_init(&self, &session->params) == PTC_OK) {
            failures += paced_selftest_calls_of(&self, session);
        } else {
            failures++;
        }
    }
    return failures;
}

/* What init must refuse without a change. */
static uint32_t paced_selftest_refuse(void)
{
    static const paced_params refused[5] = {
        {.u_max = (double)NAN},
        {.u_max = -(double)INFINITY},
        {.u_max = -1.0},
        {.u_max = -1.7976931348623157e308},
        {.u_max = -8.67334186237168e-259},
    };
    const paced_selftest_session *session = &paced_selftest_sessions[0];
    uint32_t failures = 0U;
    paced self;

    if (paced_init(&self, &session->params) != PTC_OK) {
        failures++;
    }
    for (uint32_t i = 0U; i < 5U; i++) {
        if (paced_init(&self, &refused[i]) != PTC_E_PARAM) {
            failures++;
        }
    }
    if (paced_init(&self, NULL) != PTC_E_PARAM) {
        failures++;
    }
    if (paced_init(NULL, &session->params) != PTC_E_PARAM) {
        failures++;
    }
    failures += paced_selftest_calls_of(&self, session);
    return failures;
}

/* Calls that lack a pointer: each is refused, and changes nothing. */
static uint32_t paced_selftest_pointers(void)
{
    const paced_selftest_session *session = &paced_selftest_sessions[0];
    const paced_selftest_call *call = &paced_selftest_calls[0];
    uint32_t failures = 0U;
    double u = 12345.0;
    paced self;

    if (paced_init(&self, &session->params) != PTC_OK) {
        failures++;
    }
    if (paced_arm(NULL, call->start) != PTC_E_INPUT) {
        failures++;
    }
    if (paced_step(NULL, call->k, call->y, &u) != PTC_E_INPUT) {
        failures++;
    }
    failures += paced_selftest_differs(u, 0.0);
    u = 12345.0;
    if (paced_step(&self, call->k, NULL, &u) != PTC_E_INPUT) {
        failures++;
    }
    failures += paced_selftest_differs(u, 0.0);
    if (paced_step(&self, call->k, call->y, NULL) != PTC_E_INPUT) {
        failures++;
    }
    failures += paced_selftest_calls_of(&self, session);
    return failures;
}

uint32_t paced_selftest(void)
{
    uint32_t failures = paced_selftest_run();

    failures += paced_selftest_refuse();
    failures += paced_selftest_pointers();
    return failures;
}
