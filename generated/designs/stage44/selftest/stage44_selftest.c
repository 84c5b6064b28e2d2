/* Self-test of the prescribed-time controller stage44: see stage44_selftest.h. DO NOT EDIT. */
#include "stage44_selftest.h"
#include "stage44.h"

#include <math.h>
#include <stddef.h>

/* A call, and what it must give. */
typedef struct stage44_selftest_call {
    uint32_t is_armed; /* arm is called before it */
    uint32_t start;
    uint32_t k;
    double y[1]; /* what is measured */
    ptc_status status;
    double u;
    double xhat[3]; /* the estimates behind it */
} stage44_selftest_call;

/* A set of parameters that init takes, and the calls with it, one after the other. */
typedef struct stage44_selftest_session {
    stage44_params params;
    uint32_t first; /* of its calls */
    uint32_t count;
} stage44_selftest_session;

static const stage44_selftest_session stage44_selftest_sessions[5] = {
    {.params = {.samples = 60U, .u_max = (double)INFINITY}, .first = 0U, .count = 42U},
    {.params = {.samples = 60U, .u_max = (double)INFINITY}, .first = 42U, .count = 4U},
    {.params = {.samples = 60U, .u_max = (double)INFINITY}, .first = 46U, .count = 1U},
    {.params = {.samples = 60U, .u_max = 1.0}, .first = 47U, .count = 2U},
    {.params = {.samples = 60U, .u_max = 1.0}, .first = 49U, .count = 2U},
};

static const stage44_selftest_call stage44_selftest_calls[51] = {
    {.is_armed = 0U, .start = 0U, .k = 0U, .y = {0.75}, .status = PTC_OK, .u = -0.39030867519914614, .xhat = {0.75, 0.0, 0.0}},
    {.is_armed = 0U, .start = 0U, .k = 1U, .y = {0.7252083333333332}, .status = PTC_OK, .u = -0.5338464232545254, .xhat = {0.75, 0.0, 0.0}},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {0.7008333333333333}, .status = PTC_OK, .u = -0.44709107434267303, .xhat = {0.7514626117474646, -0.1759741826049982, 0.5572897544302977}},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {(double)NAN}, .status = PTC_E_INPUT, .u = 0.0, .xhat = {0.7514626117474646, -0.1759741826049982, 0.5572897544302977}},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {(double)INFINITY}, .status = PTC_E_INPUT, .u = 0.0, .xhat = {0.7514626117474646, -0.1759741826049982, 0.5572897544302977}},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {-(double)INFINITY}, .status = PTC_E_INPUT, .u = 0.0, .xhat = {0.7514626117474646, -0.1759741826049982, 0.5572897544302977}},
    {.is_armed = 0U, .start = 0U, .k = 3U, .y = {0.676875}, .status = PTC_OK, .u = -0.18105942082971116, .xhat = {0.752263309892089, -0.4523585264588286, 1.3631318783805715}},
    {.is_armed = 0U, .start = 0U, .k = 15U, .y = {0.421875}, .status = PTC_OK, .u = -0.3022193151505147, .xhat = {0.7507055411121776, -0.7594789676917373, 2.2810629452167337}},
    {.is_armed = 0U, .start = 0U, .k = 26U, .y = {0.2408333333333333}, .status = PTC_OK, .u = -1.8702807012275908, .xhat = {0.6369974153293779, -0.3402409290356724, -0.19394292392866602}},
    {.is_armed = 0U, .start = 0U, .k = 28U, .y = {0.21333333333333332}, .status = PTC_OK, .u = 21.35032543802803, .xhat = {-0.3676263001292221, -67.28092808856177, -68.22749302992251}},
    {.is_armed = 0U, .start = 0U, .k = 29U, .y = {0.20020833333333338}, .status = PTC_OK, .u = -1.2836260297518223, .xhat = {0.38928612201984886, 24.139779883074066, 69.97955054464958}},
    {.is_armed = 0U, .start = 0U, .k = 30U, .y = {0.1875}, .status = PTC_OK, .u = 0.5545718150273702, .xhat = {0.19487586607571847, -0.15966018546676772, 6.99285932283584}},
    {.is_armed = 0U, .start = 0U, .k = 31U, .y = {0.17520833333333333}, .status = PTC_OK, .u = -0.26328579285930775, .xhat = {0.18094861865100204, -0.15223468886277153, 5.648945811158338}},
    {.is_armed = 0U, .start = 0U, .k = 45U, .y = {0.046875}, .status = PTC_OK, .u = -6.14633309501279, .xhat = {0.168307619823568, -0.5106480518321441, 2.003943779206293}},
    {.is_armed = 0U, .start = 0U, .k = 56U, .y = {0.003333333333333333}, .status = PTC_HOLD, .u = 432.2042073930727, .xhat = {-0.142341480451884, -20.780131760103956, -19.690807447441205}},
    {.is_armed = 0U, .start = 0U, .k = 58U, .y = {0.0008333333333333333}, .status = PTC_HOLD, .u = -513.5393822900409, .xhat = {0.006886308172339587, 1.8572774992953958, 15.332656603216412}},
    {.is_armed = 0U, .start = 0U, .k = 59U, .y = {0.00020833333333333332}, .status = PTC_HOLD, .u = -129.00422172828553, .xhat = {0.025225283221057156, 6.059593973265717, 99.33638148172938}},
    {.is_armed = 0U, .start = 0U, .k = 60U, .y = {0.0}, .status = PTC_HOLD, .u = 123.2586025608862, .xhat = {0.11660684595000312, 18.200266122680265, 6.610715227848033}},
    {.is_armed = 0U, .start = 0U, .k = 61U, .y = {0.0}, .status = PTC_HOLD, .u = 536.9119857563616, .xhat = {-0.04291638522282953, -13.613372350820766, -127.88829342533148}},
    {.is_armed = 0U, .start = 0U, .k = 2147483647U, .y = {0.0}, .status = PTC_HOLD, .u = -80.16117429334173, .xhat = {-0.15911512710016087, -22.345604442681644, -54.20660364424021}},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {0.0}, .status = PTC_HOLD, .u = -737.3378167067708, .xhat = {0.006616589157276961, 6.095104516742399, 135.93572674836116}},
    {.is_armed = 1U, .start = 4294967293U, .k = 4294967293U, .y = {0.75}, .status = PTC_OK, .u = -194.16373141824232, .xhat = {0.18354217095362022, 31.470964940128134, 139.72068198234876}},
    {.is_armed = 0U, .start = 0U, .k = 4294967294U, .y = {0.7252083333333332}, .status = PTC_OK, .u = -175.38796840293975, .xhat = {0.5232194502182114, 42.832796733693336, -115.37897294148144}},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {0.7008333333333333}, .status = PTC_OK, .u = -153.36137272721402, .xhat = {0.7940606346640895, 12.533806895099442, -231.46581428667798}},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {(double)NAN}, .status = PTC_E_INPUT, .u = 0.0, .xhat = {0.7940606346640895, 12.533806895099442, -231.46581428667798}},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {(double)INFINITY}, .status = PTC_E_INPUT, .u = 0.0, .xhat = {0.7940606346640895, 12.533806895099442, -231.46581428667798}},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {-(double)INFINITY}, .status = PTC_E_INPUT, .u = 0.0, .xhat = {0.7940606346640895, 12.533806895099442, -231.46581428667798}},
    {.is_armed = 0U, .start = 0U, .k = 0U, .y = {0.676875}, .status = PTC_OK, .u = -129.60756558392487, .xhat = {0.7591064744922748, -20.027641644944413, -193.11508192220873}},
    {.is_armed = 0U, .start = 0U, .k = 12U, .y = {0.421875}, .status = PTC_OK, .u = -85.17196114612706, .xhat = {0.42438142612663643, -47.10725561576457, -161.3937666365515}},
    {.is_armed = 0U, .start = 0U, .k = 23U, .y = {0.2408333333333333}, .status = PTC_OK, .u = -19.855364276341987, .xhat = {-0.16075252797218997, -69.05845647165363, -134.40354063664864}},
    {.is_armed = 0U, .start = 0U, .k = 25U, .y = {0.21333333333333332}, .status = PTC_OK, .u = -4.015546258172428, .xhat = {0.07102231736269937, -18.931135919586122, -34.96611121968851}},
    {.is_armed = 0U, .start = 0U, .k = 26U, .y = {0.20020833333333338}, .status = PTC_OK, .u = -3.2625596648809108, .xhat = {0.2125553632788955, -0.6185206314281788, -10.162294239486599}},
    {.is_armed = 0U, .start = 0U, .k = 27U, .y = {0.1875}, .status = PTC_OK, .u = -0.28527295627960036, .xhat = {0.16701070013335423, -4.31302568441913, -11.571836538466222}},
    {.is_armed = 0U, .start = 0U, .k = 28U, .y = {0.17520833333333333}, .status = PTC_OK, .u = 0.027331263672745187, .xhat = {0.16833116377055907, -2.205204748688327, -3.600926385640805}},
    {.is_armed = 0U, .start = 0U, .k = 42U, .y = {0.046875}, .status = PTC_OK, .u = -0.8312744903955394, .xhat = {0.16124987900021176, -1.491218429991447, -1.0998498301751338}},
    {.is_armed = 0U, .start = 0U, .k = 53U, .y = {0.003333333333333333}, .status = PTC_HOLD, .u = 430.2215784183454, .xhat = {-0.14330595722643114, -20.91877975333944, -20.118799850968628}},
    {.is_armed = 0U, .start = 0U, .k = 55U, .y = {0.0008333333333333333}, .status = PTC_HOLD, .u = -518.538082257497, .xhat = {0.0068203648577943666, 1.8872003791656136, 16.475318005468125}},
    {.is_armed = 0U, .start = 0U, .k = 56U, .y = {0.00020833333333333332}, .status = PTC_HOLD, .u = -130.218655048982, .xhat = {0.02679785435434686, 6.3305064422068895, 100.37905471206375}},
    {.is_armed = 0U, .start = 0U, .k = 57U, .y = {0.0}, .status = PTC_HOLD, .u = 130.1431137893146, .xhat = {0.11728541944951106, 18.231681352503795, 5.480987759699005}},
    {.is_armed = 0U, .start = 0U, .k = 58U, .y = {0.0}, .status = PTC_HOLD, .u = 541.3834716920821, .xhat = {-0.04482336580765043, -13.94591670720197, -129.67572971061378}},
    {.is_armed = 0U, .start = 0U, .k = 2147483644U, .y = {0.0}, .status = PTC_HOLD, .u = -87.88142397684763, .xhat = {-0.16062767377001405, -22.520351769473372, -53.51639230297}},
    {.is_armed = 0U, .start = 0U, .k = 4294967292U, .y = {0.0}, .status = PTC_HOLD, .u = -745.8577881436698, .xhat = {0.008324002760333717, 6.447873869925688, 138.64693948101456}},
    {.is_armed = 0U, .start = 0U, .k = 22U, .y = {-0.42703825838978693}, .status = PTC_OK, .u = 0.9014822090131263, .xhat = {-0.42703825838978693, 0.0, 0.0}},
    {.is_armed = 0U, .start = 0U, .k = 23U, .y = {-0.41074972873928584}, .status = PTC_OK, .u = 1.1733593502987039, .xhat = {-0.42703825838978693, 0.0, 0.0}},
    {.is_armed = 0U, .start = 0U, .k = 35U, .y = {6.680275355246632e153}, .status = PTC_OK, .u = 3.296687962411135, .xhat = {-0.40680674816304885, -0.008559427421001251, -4.228241936765482}},
    {.is_armed = 1U, .start = 0U, .k = 59U, .y = {-5.259004869633156e153}, .status = PTC_HOLD, .u = 1.6724089845066166e156, .xhat = {-5.259004869633156e153, 0.0, 0.0}},
    {.is_armed = 1U, .start = 0U, .k = 52U, .y = {5.714809034527012e307}, .status = PTC_E_RANGE, .u = 0.0, .xhat = {0.0, 0.0, 0.0}},
    {.is_armed = 0U, .start = 0U, .k = 13U, .y = {-0.9397676833753335}, .status = PTC_SATURATED, .u = 1.0, .xhat = {-0.9397676833753335, 0.0, 0.0}},
    {.is_armed = 1U, .start = 4294967290U, .k = 4294967295U, .y = {-1.1972150163783169e308}, .status = PTC_E_RANGE, .u = 0.0, .xhat = {-0.9397676833753335, 0.0, 0.0}},
    {.is_armed = 0U, .start = 0U, .k = 61U, .y = {-8.589049603666809e153}, .status = PTC_SATURATED, .u = 1.0, .xhat = {-8.589049603666809e153, 0.0, 0.0}},
    {.is_armed = 1U, .start = 0U, .k = 1U, .y = {8.058717689962579e153}, .status = PTC_SATURATED, .u = -1.0, .xhat = {8.058717689962579e153, 0.0, 0.0}},
};

/* 1 where a number is not the one that must come. */
static uint32_t stage44_selftest_differs(double value, double wanted)
{
    uint32_t failures = 1U;

    if (fabs(value - wanted) <= 0.0) {
        failures = 0U;
    }
    return failures;
}

/* The failures of one call. */
static uint32_t stage44_selftest_check(stage44 *self, const stage44_selftest_call *call)
{
    uint32_t failures = 0U;
    double u = 12345.0;
    double xhat[3] = {12345.0, 12345.0, 12345.0};

    if (call->is_armed != 0U) {
        if (stage44_arm(self, call->start) != PTC_OK) {
            failures++;
        }
    }
    if (stage44_step(self, call->k, call->y, &u) != call->status) {
        failures++;
    }
    failures += stage44_selftest_differs(u, call->u);
    if (stage44_estimate(self, xhat) != PTC_OK) {
        failures++;
    }
    for (uint32_t i = 0U; i < 3U; i++) {
        failures += stage44_selftest_differs(xhat[i], call->xhat[i]);
    }
    return failures;
}

/* The calls of a session, of which init has been called. */
static uint32_t stage44_selftest_calls_of(stage44 *self, const stage44_selftest_session *session)
{
    uint32_t failures = 0U;

    for (uint32_t j = 0U; j < session->count; j++) {
        failures += stage44_selftest_check(self, &stage44_selftest_calls[session->first + j]);
    }
    return failures;
}

/* Every session with its calls. */
static uint32_t stage44_selftest_run(void)
{
    uint32_t failures = 0U;

    for (uint32_t i = 0U; i < 5U; i++) {
        const stage44_selftest_session *session = &stage44_selftest_sessions[i];
        stage44 self;

        if (stage44_init(&self, &session->params) == PTC_OK) {
            failures += stage44_selftest_calls_of(&self, session);
        } else {
            failures++;
        }
    }
    return failures;
}

/* What init must refuse without a change. */
static uint32_t stage44_selftest_refuse(void)
{
    static const stage44_params refused[7] = {
        {.samples = 0U, .u_max = (double)INFINITY},
        {.samples = 9U, .u_max = (double)INFINITY},
        {.samples = 60U, .u_max = (double)NAN},
        {.samples = 60U, .u_max = -(double)INFINITY},
        {.samples = 60U, .u_max = 0.0},
        {.samples = 60U, .u_max = -1.0},
        {.samples = 60U, .u_max = -1.7976931348623157e308},
    };
    const stage44_selftest_session *session = &stage44_selftest_sessions[0];
    uint32_t failures = 0U;
    stage44 self;

    if (stage44_init(&self, &session->params) != PTC_OK) {
        failures++;
    }
    for (uint32_t i = 0U; i < 7U; i++) {
        if (stage44_init(&self, &refused[i]) != PTC_E_PARAM) {
            failures++;
        }
    }
    if (stage44_init(&self, NULL) != PTC_E_PARAM) {
        failures++;
    }
    if (stage44_init(NULL, &session->params) != PTC_E_PARAM) {
        failures++;
    }
    failures += stage44_selftest_calls_of(&self, session);
    return failures;
}

/* Calls that lack a pointer: each is refused, and changes nothing. */
static uint32_t stage44_selftest_pointers(void)
{
    const stage44_selftest_session *session = &stage44_selftest_sessions[0];
    const stage44_selftest_call *call = &stage44_selftest_calls[0];
    uint32_t failures = 0U;
    double u = 12345.0;
    double xhat[3];
    stage44 self;

    if (stage44_init(&self, &session->params) != PTC_OK) {
        failures++;
    }
    if (stage44_arm(NULL, call->start) != PTC_E_INPUT) {
        failures++;
    }
    if (stage44_step(NULL, call->k, call->y, &u) != PTC_E_INPUT) {
        failures++;
    }
    failures += stage44_selftest_differs(u, 0.0);
    u = 12345.0;
    if (stage44_step(&self, call->k, NULL, &u) != PTC_E_INPUT) {
        failures++;
    }
    failures += stage44_selftest_differs(u, 0.0);
    if (stage44_step(&self, call->k, call->y, NULL) != PTC_E_INPUT) {
        failures++;
    }
    if (stage44_estimate(NULL, xhat) != PTC_E_INPUT) {
        failures++;
    }
    if (stage44_estimate(&self, NULL) != PTC_E_INPUT) {
        failures++;
    }
    failures += stage44_selftest_calls_of(&self, session);
    return failures;
}

uint32_t stage44_selftest(void)
{
    uint32_t failures = stage44_selftest_run();

    failures += stage44_selftest_refuse();
    failures += stage44_selftest_pointers();
    return failures;
}
