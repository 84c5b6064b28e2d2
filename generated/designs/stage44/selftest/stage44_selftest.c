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
    {.is_armed = 0U, .start = 0U, .k = 0U, .y = {0.75}, .status = PTC_OK, .u = -0.3903086751991462, .xhat = {0.75, 0.0, 0.0}},
    {.is_armed = 0U, .start = 0U, .k = 1U, .y = {0.7252083333333332}, .status = PTC_OK, .u = -0.5338464232545255, .xhat = {0.75, 0.0, 0.0}},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {0.7008333333333333}, .status = PTC_OK, .u = -0.4470910743426731, .xhat = {0.7514626117474646, -0.17597418260499814, 0.5572897544302977}},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {(double)NAN}, .status = PTC_E_INPUT, .u = 0.0, .xhat = {0.7514626117474646, -0.17597418260499814, 0.5572897544302977}},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {(double)INFINITY}, .status = PTC_E_INPUT, .u = 0.0, .xhat = {0.7514626117474646, -0.17597418260499814, 0.5572897544302977}},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {-(double)INFINITY}, .status = PTC_E_INPUT, .u = 0.0, .xhat = {0.7514626117474646, -0.17597418260499814, 0.5572897544302977}},
    {.is_armed = 0U, .start = 0U, .k = 3U, .y = {0.676875}, .status = PTC_OK, .u = -0.18105942082971083, .xhat = {0.752263309892089, -0.45235852645882857, 1.3631318783805721}},
    {.is_armed = 0U, .start = 0U, .k = 15U, .y = {0.421875}, .status = PTC_OK, .u = -0.3022193151505145, .xhat = {0.7507055411121776, -0.7594789676917372, 2.2810629452167346}},
    {.is_armed = 0U, .start = 0U, .k = 26U, .y = {0.2408333333333333}, .status = PTC_OK, .u = -1.870280701227592, .xhat = {0.6369974153293779, -0.340240929035671, -0.19394292392866996}},
    {.is_armed = 0U, .start = 0U, .k = 28U, .y = {0.21333333333333332}, .status = PTC_OK, .u = 21.350325438028015, .xhat = {-0.3676263001292221, -67.28092808856177, -68.22749302992253}},
    {.is_armed = 0U, .start = 0U, .k = 29U, .y = {0.20020833333333338}, .status = PTC_OK, .u = -1.2836260297518223, .xhat = {0.38928612201984886, 24.139779883074066, 69.97955054464958}},
    {.is_armed = 0U, .start = 0U, .k = 30U, .y = {0.1875}, .status = PTC_OK, .u = 0.5545718150273684, .xhat = {0.19487586607571847, -0.15966018546676786, 6.992859322835837}},
    {.is_armed = 0U, .start = 0U, .k = 31U, .y = {0.17520833333333333}, .status = PTC_OK, .u = -0.26328579285930775, .xhat = {0.180948618651002, -0.15223468886277236, 5.648945811158335}},
    {.is_armed = 0U, .start = 0U, .k = 45U, .y = {0.046875}, .status = PTC_OK, .u = -6.146333095012806, .xhat = {0.16830761982356807, -0.5106480518321405, 2.0039437792062955}},
    {.is_armed = 0U, .start = 0U, .k = 56U, .y = {0.003333333333333333}, .status = PTC_HOLD, .u = 432.20420739307286, .xhat = {-0.14234148045188408, -20.78013176010396, -19.690807447441212}},
    {.is_armed = 0U, .start = 0U, .k = 58U, .y = {0.0008333333333333333}, .status = PTC_HOLD, .u = -513.5393822900412, .xhat = {0.006886308172339697, 1.8572774992954029, 15.332656603216416}},
    {.is_armed = 0U, .start = 0U, .k = 59U, .y = {0.00020833333333333332}, .status = PTC_HOLD, .u = -129.00422172828505, .xhat = {0.025225283221057052, 6.059593973265708, 99.33638148172939}},
    {.is_armed = 0U, .start = 0U, .k = 60U, .y = {0.0}, .status = PTC_HOLD, .u = 123.25860256088586, .xhat = {0.11660684595000319, 18.200266122680276, 6.610715227848019}},
    {.is_armed = 0U, .start = 0U, .k = 61U, .y = {0.0}, .status = PTC_HOLD, .u = 536.9119857563614, .xhat = {-0.0429163852228296, -13.613372350820768, -127.88829342533145}},
    {.is_armed = 0U, .start = 0U, .k = 2147483647U, .y = {0.0}, .status = PTC_HOLD, .u = -80.16117429334182, .xhat = {-0.1591151271001607, -22.345604442681626, -54.20660364424019}},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {0.0}, .status = PTC_HOLD, .u = -737.33781670677, .xhat = {0.006616589157276871, 6.095104516742383, 135.93572674836105}},
    {.is_armed = 1U, .start = 4294967293U, .k = 4294967293U, .y = {0.75}, .status = PTC_OK, .u = -194.1637314182422, .xhat = {0.1835421709536201, 31.47096494012812, 139.7206819823487}},
    {.is_armed = 0U, .start = 0U, .k = 4294967294U, .y = {0.7252083333333332}, .status = PTC_OK, .u = -175.38796840293963, .xhat = {0.5232194502182113, 42.83279673369332, -115.37897294148131}},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {0.7008333333333333}, .status = PTC_OK, .u = -153.36137272721388, .xhat = {0.7940606346640892, 12.533806895099463, -231.46581428667776}},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {(double)NAN}, .status = PTC_E_INPUT, .u = 0.0, .xhat = {0.7940606346640892, 12.533806895099463, -231.46581428667776}},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {(double)INFINITY}, .status = PTC_E_INPUT, .u = 0.0, .xhat = {0.7940606346640892, 12.533806895099463, -231.46581428667776}},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {-(double)INFINITY}, .status = PTC_E_INPUT, .u = 0.0, .xhat = {0.7940606346640892, 12.533806895099463, -231.46581428667776}},
    {.is_armed = 0U, .start = 0U, .k = 0U, .y = {0.676875}, .status = PTC_OK, .u = -129.60756558392478, .xhat = {0.7591064744922749, -20.027641644944364, -193.11508192220856}},
    {.is_armed = 0U, .start = 0U, .k = 12U, .y = {0.421875}, .status = PTC_OK, .u = -85.17196114612699, .xhat = {0.4243814261266372, -47.10725561576451, -161.3937666365514}},
    {.is_armed = 0U, .start = 0U, .k = 23U, .y = {0.2408333333333333}, .status = PTC_OK, .u = -19.855364276341987, .xhat = {-0.16075252797218872, -69.05845647165354, -134.40354063664856}},
    {.is_armed = 0U, .start = 0U, .k = 25U, .y = {0.21333333333333332}, .status = PTC_OK, .u = -4.015546258172378, .xhat = {0.07102231736269839, -18.931135919586247, -34.96611121968868}},
    {.is_armed = 0U, .start = 0U, .k = 26U, .y = {0.20020833333333338}, .status = PTC_OK, .u = -3.2625596648809054, .xhat = {0.21255536327889568, -0.6185206314281455, -10.162294239486492}},
    {.is_armed = 0U, .start = 0U, .k = 27U, .y = {0.1875}, .status = PTC_OK, .u = -0.28527295627960214, .xhat = {0.1670107001333543, -4.3130256844191175, -11.57183653846619}},
    {.is_armed = 0U, .start = 0U, .k = 28U, .y = {0.17520833333333333}, .status = PTC_OK, .u = 0.0273312636727443, .xhat = {0.1683311637705591, -2.205204748688324, -3.600926385640793}},
    {.is_armed = 0U, .start = 0U, .k = 42U, .y = {0.046875}, .status = PTC_OK, .u = -0.8312744903955385, .xhat = {0.16124987900021176, -1.491218429991447, -1.099849830175132}},
    {.is_armed = 0U, .start = 0U, .k = 53U, .y = {0.003333333333333333}, .status = PTC_HOLD, .u = 430.22157841834536, .xhat = {-0.14330595722643114, -20.91877975333944, -20.118799850968628}},
    {.is_armed = 0U, .start = 0U, .k = 55U, .y = {0.0008333333333333333}, .status = PTC_HOLD, .u = -518.5380822574971, .xhat = {0.0068203648577943666, 1.8872003791656136, 16.475318005468125}},
    {.is_armed = 0U, .start = 0U, .k = 56U, .y = {0.00020833333333333332}, .status = PTC_HOLD, .u = -130.21865504898167, .xhat = {0.02679785435434686, 6.330506442206889, 100.37905471206373}},
    {.is_armed = 0U, .start = 0U, .k = 57U, .y = {0.0}, .status = PTC_HOLD, .u = 130.1431137893146, .xhat = {0.11728541944951101, 18.23168135250379, 5.480987759698955}},
    {.is_armed = 0U, .start = 0U, .k = 58U, .y = {0.0}, .status = PTC_HOLD, .u = 541.3834716920819, .xhat = {-0.04482336580765049, -13.945916707201974, -129.67572971061372}},
    {.is_armed = 0U, .start = 0U, .k = 2147483644U, .y = {0.0}, .status = PTC_HOLD, .u = -87.88142397684797, .xhat = {-0.16062767377001394, -22.520351769473354, -53.516392302969905}},
    {.is_armed = 0U, .start = 0U, .k = 4294967292U, .y = {0.0}, .status = PTC_HOLD, .u = -745.8577881436697, .xhat = {0.00832400276033382, 6.447873869925697, 138.64693948101456}},
    {.is_armed = 0U, .start = 0U, .k = 22U, .y = {-0.42703825838978693}, .status = PTC_OK, .u = 0.9014822090131261, .xhat = {-0.42703825838978693, 0.0, 0.0}},
    {.is_armed = 0U, .start = 0U, .k = 23U, .y = {-0.41074972873928584}, .status = PTC_OK, .u = 1.1733593502987039, .xhat = {-0.42703825838978693, 0.0, 0.0}},
    {.is_armed = 0U, .start = 0U, .k = 35U, .y = {6.680275355246632e153}, .status = PTC_OK, .u = 3.296687962411135, .xhat = {-0.40680674816304885, -0.008559427421001253, -4.228241936765482}},
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
