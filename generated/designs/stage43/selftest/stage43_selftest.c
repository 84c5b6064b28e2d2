/* Self-test of the prescribed-time controller stage43: see stage43_selftest.h. DO NOT EDIT. */
#include "stage43_selftest.h"
#include "stage43.h"

#include <math.h>
#include <stddef.h>

/* A call, and what it must give. */
typedef struct stage43_selftest_call {
    uint32_t is_armed; /* arm is called before it */
    uint32_t start;
    uint32_t k;
    double y[1]; /* what is measured */
    ptc_status status;
    double u;
    double xhat[3]; /* the estimates behind it */
    double d;
} stage43_selftest_call;

/* A set of parameters that init takes, and the calls with it, one after the other. */
typedef struct stage43_selftest_session {
    stage43_params params;
    uint32_t first; /* of its calls */
    uint32_t count;
} stage43_selftest_session;

static const stage43_selftest_session stage43_selftest_sessions[3] = {
    {.params = {.none = (char)0}, .first = 0U, .count = 42U},
    {.params = {.none = (char)0}, .first = 42U, .count = 3U},
    {.params = {.none = (char)0}, .first = 45U, .count = 2U},
};

static const stage43_selftest_call stage43_selftest_calls[47] = {
    {.is_armed = 0U, .start = 0U, .k = 0U, .y = {0.75}, .status = PTC_SATURATED, .u = -6.0, .xhat = {0.75, 0.0, 0.0}, .d = 0.0},
    {.is_armed = 0U, .start = 0U, .k = 1U, .y = {0.7129687499999999}, .status = PTC_SATURATED, .u = -6.0, .xhat = {0.7260099409829721, -0.6896385610165131, -5.9234713622291135}, .d = -9.553986068111474},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {0.676875}, .status = PTC_SATURATED, .u = -6.0, .xhat = {0.690594846491228, -1.6153506084451332, -13.968572626418995}, .d = -23.260126418988655},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {(double)NAN}, .status = PTC_E_INPUT, .u = 0.0, .xhat = {0.690594846491228, -1.6153506084451332, -13.968572626418995}, .d = -23.260126418988655},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {(double)INFINITY}, .status = PTC_E_INPUT, .u = 0.0, .xhat = {0.690594846491228, -1.6153506084451332, -13.968572626418995}, .d = -23.260126418988655},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {-(double)INFINITY}, .status = PTC_E_INPUT, .u = 0.0, .xhat = {0.690594846491228, -1.6153506084451332, -13.968572626418995}, .d = -23.260126418988655},
    {.is_armed = 0U, .start = 0U, .k = 3U, .y = {0.6417187500000001}, .status = PTC_SATURATED, .u = 6.0, .xhat = {0.6513382847335482, -2.4932672907778772, -21.481277046015755}, .d = -36.714021151223605},
    {.is_armed = 0U, .start = 0U, .k = 10U, .y = {0.421875}, .status = PTC_SATURATED, .u = 6.0, .xhat = {0.421875, -12.430577368637334, -564.4402278440435}, .d = 13526.581243511666},
    {.is_armed = 0U, .start = 0U, .k = 16U, .y = {0.27}, .status = PTC_SATURATED, .u = 6.0, .xhat = {0.27, -17.692402191826194, -461.2473179824551}, .d = 11925.936114835251},
    {.is_armed = 0U, .start = 0U, .k = 18U, .y = {0.22687500000000005}, .status = PTC_SATURATED, .u = -6.0, .xhat = {0.22687500000000005, 6.68485403460269, 2755.476054130807}, .d = 166800.63666308075},
    {.is_armed = 0U, .start = 0U, .k = 19U, .y = {0.20671875}, .status = PTC_SATURATED, .u = 6.0, .xhat = {0.20671875, -3.726331770833326, -628.0515624999989}, .d = -85779.06249999997},
    {.is_armed = 0U, .start = 0U, .k = 20U, .y = {0.1875}, .status = PTC_SATURATED, .u = 6.0, .xhat = {0.1875, -2.6093468750000053, -210.92906250000124}, .d = -22036.40625000011},
    {.is_armed = 0U, .start = 0U, .k = 21U, .y = {0.16921875}, .status = PTC_SATURATED, .u = 6.0, .xhat = {0.16921875, -1.7812817708333357, 9.34562499999987}, .d = -5.96875},
    {.is_armed = 0U, .start = 0U, .k = 30U, .y = {0.046875}, .status = PTC_SATURATED, .u = 6.0, .xhat = {0.046875, -20.93769895833334, -2090.6690625}, .d = -105002.21875000001},
    {.is_armed = 0U, .start = 0U, .k = 36U, .y = {0.0075000000000000015}, .status = PTC_SATURATED, .u = -6.0, .xhat = {0.007500000000000007, 6.445515104166695, 2700.0650000000023}, .d = 187032.59375000012},
    {.is_armed = 0U, .start = 0U, .k = 38U, .y = {0.0018750000000000004}, .status = PTC_SATURATED, .u = 6.0, .xhat = {0.0018749999999999878, -0.5155968750000142, -154.67906250000487}, .d = -49223.90625000035},
    {.is_armed = 0U, .start = 0U, .k = 39U, .y = {0.0004687500000000001}, .status = PTC_SATURATED, .u = 6.0, .xhat = {0.0004687500000000004, -0.9140624999999964, -253.1249999999992}, .d = -29537.24999999989},
    {.is_armed = 0U, .start = 0U, .k = 40U, .y = {0.0}, .status = PTC_SATURATED, .u = 6.0, .xhat = {0.0, -0.10940677083333306, -23.46687499999996}, .d = -3287.218749999982},
    {.is_armed = 0U, .start = 0U, .k = 41U, .y = {0.0}, .status = PTC_SATURATED, .u = 6.0, .xhat = {0.0, 0.007613541666666723, -0.04406249999993861}, .d = -470.96874999999},
    {.is_armed = 0U, .start = 0U, .k = 2147483647U, .y = {0.0}, .status = PTC_SATURATED, .u = 6.0, .xhat = {0.0, -0.015422395833333135, -4.6224999999999445}, .d = -467.4062499999953},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {0.0}, .status = PTC_SATURATED, .u = 6.0, .xhat = {0.0, 2.8124999999976086e-5, 0.008437499999992326}, .d = -5.156250000000796},
    {.is_armed = 1U, .start = 4294967293U, .k = 4294967293U, .y = {0.75}, .status = PTC_SATURATED, .u = -6.0, .xhat = {0.4682665708204334, 12.660099165376677, 102.1839427244582}, .d = 149.64233746129952},
    {.is_armed = 0U, .start = 0U, .k = 4294967294U, .y = {0.7129687499999999}, .status = PTC_SATURATED, .u = -6.0, .xhat = {0.6731858144349845, 15.793504518188854, 121.81027089783281}, .d = 178.78734520123757},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {0.676875}, .status = PTC_SATURATED, .u = -6.0, .xhat = {0.7293349798116615, 13.70956148843309, 93.26175245098037}, .d = 126.37977296181546},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {(double)NAN}, .status = PTC_E_INPUT, .u = 0.0, .xhat = {0.7293349798116615, 13.70956148843309, 93.26175245098037}, .d = 126.37977296181546},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {(double)INFINITY}, .status = PTC_E_INPUT, .u = 0.0, .xhat = {0.7293349798116615, 13.70956148843309, 93.26175245098037}, .d = 126.37977296181546},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {-(double)INFINITY}, .status = PTC_E_INPUT, .u = 0.0, .xhat = {0.7293349798116615, 13.70956148843309, 93.26175245098037}, .d = 126.37977296181546},
    {.is_armed = 0U, .start = 0U, .k = 0U, .y = {0.6417187500000001}, .status = PTC_SATURATED, .u = -6.0, .xhat = {0.7106342245883552, 9.368453625788582, 42.50749944254016}, .d = 29.99449381726295},
    {.is_armed = 0U, .start = 0U, .k = 7U, .y = {0.421875}, .status = PTC_SATURATED, .u = 6.0, .xhat = {0.421875, -8.579321433682768, -982.7809153544099}, .d = 25668.203487195333},
    {.is_armed = 0U, .start = 0U, .k = 13U, .y = {0.27}, .status = PTC_SATURATED, .u = 6.0, .xhat = {0.27, -21.014312278030907, -1150.5543566821448}, .d = 4448.429677210923},
    {.is_armed = 0U, .start = 0U, .k = 15U, .y = {0.22687500000000005}, .status = PTC_SATURATED, .u = -6.0, .xhat = {0.22687500000000005, 8.733262178180851, 3369.978653454255}, .d = 228253.86534542547},
    {.is_armed = 0U, .start = 0U, .k = 16U, .y = {0.20671875}, .status = PTC_SATURATED, .u = 6.0, .xhat = {0.20671875, -3.7265307291666687, -628.0956249999999}, .d = -85775.28125000003},
    {.is_armed = 0U, .start = 0U, .k = 17U, .y = {0.1875}, .status = PTC_SATURATED, .u = 6.0, .xhat = {0.1875, -2.6091442708333368, -210.86406250000027}, .d = -22029.06250000003},
    {.is_armed = 0U, .start = 0U, .k = 18U, .y = {0.16921875}, .status = PTC_SATURATED, .u = 6.0, .xhat = {0.16921875, -1.7812536458333348, 9.354062500000055}, .d = -5.124999999992724},
    {.is_armed = 0U, .start = 0U, .k = 27U, .y = {0.046875}, .status = PTC_SATURATED, .u = 6.0, .xhat = {0.046875, -20.937698958333332, -2090.6690624999997}, .d = -105002.21874999997},
    {.is_armed = 0U, .start = 0U, .k = 33U, .y = {0.0075000000000000015}, .status = PTC_SATURATED, .u = -6.0, .xhat = {0.007500000000000007, 6.445515104166681, 2700.0649999999996}, .d = 187032.59374999997},
    {.is_armed = 0U, .start = 0U, .k = 35U, .y = {0.0018750000000000004}, .status = PTC_SATURATED, .u = 6.0, .xhat = {0.0018749999999999878, -0.5155968750000142, -154.67906250000306}, .d = -49223.906250000175},
    {.is_armed = 0U, .start = 0U, .k = 36U, .y = {0.0004687500000000001}, .status = PTC_SATURATED, .u = 6.0, .xhat = {0.0004687500000000004, -0.914062499999992, -253.12499999999812}, .d = -29537.249999999836},
    {.is_armed = 0U, .start = 0U, .k = 37U, .y = {0.0}, .status = PTC_SATURATED, .u = 6.0, .xhat = {0.0, -0.10940677083333572, -23.46687500000064}, .d = -3287.2187500000364},
    {.is_armed = 0U, .start = 0U, .k = 38U, .y = {0.0}, .status = PTC_SATURATED, .u = 6.0, .xhat = {0.0, 0.007613541666667389, -0.04406249999976097}, .d = -470.9687499999741},
    {.is_armed = 0U, .start = 0U, .k = 2147483644U, .y = {0.0}, .status = PTC_SATURATED, .u = 6.0, .xhat = {0.0, -0.015422395833333227, -4.622499999999972}, .d = -467.40624999999756},
    {.is_armed = 0U, .start = 0U, .k = 4294967292U, .y = {0.0}, .status = PTC_SATURATED, .u = 6.0, .xhat = {0.0, 2.8124999999976086e-5, 0.008437499999995879}, .d = -5.156250000000455},
    {.is_armed = 0U, .start = 0U, .k = 11U, .y = {-0.3423316652035391}, .status = PTC_SATURATED, .u = 6.0, .xhat = {-0.3423316652035391, 0.0, 0.0}, .d = 0.0},
    {.is_armed = 0U, .start = 0U, .k = 12U, .y = {-0.28592588713318096}, .status = PTC_SATURATED, .u = 6.0, .xhat = {-0.28592588713318096, 6.580674108208449, 0.0}, .d = -56405.77807035812},
    {.is_armed = 0U, .start = 0U, .k = 40U, .y = {5.760328347710473e301}, .status = PTC_E_RANGE, .u = 0.0, .xhat = {-0.28592588713318096, 6.580674108208449, 0.0}, .d = -56405.77807035812},
    {.is_armed = 1U, .start = 4294967290U, .k = 4U, .y = {-8.768438085157633e153}, .status = PTC_SATURATED, .u = 6.0, .xhat = {-8.768438085157633e153, 0.0, 0.0}, .d = 0.0},
    {.is_armed = 1U, .start = 0U, .k = 9U, .y = {-1.1090517773559043e154}, .status = PTC_SATURATED, .u = 6.0, .xhat = {-1.1090517773559043e154, 0.0, 0.0}, .d = 0.0},
};

/* 1 where a number is not the one that must come. */
static uint32_t stage43_selftest_differs(double value, double wanted)
{
    uint32_t failures = 1U;

    if (fabs(value - wanted) <= 0.0) {
        failures = 0U;
    }
    return failures;
}

/* The failures of one call. */
static uint32_t stage43_selftest_check(stage43 *self, const stage43_selftest_call *call)
{
    uint32_t failures = 0U;
    double u = 12345.0;
    double xhat[3] = {12345.0, 12345.0, 12345.0};
    double d = 12345.0;

    if (call->is_armed != 0U) {
        if (stage43_arm(self, call->start) != PTC_OK) {
            failures++;
        }
    }
    if (stage43_step(self, call->k, call->y, &u) != call->status) {
        failures++;
    }
    failures += stage43_selftest_differs(u, call->u);
    if (stage43_estimate(self, xhat) != PTC_OK) {
        failures++;
    }
    for (uint32_t i = 0U; i < 3U; i++) {
        failures += stage43_selftest_differs(xhat[i], call->xhat[i]);
    }
    if (stage43_disturbance(self, &d) != PTC_OK) {
        failures++;
    }
    failures += stage43_selftest_differs(d, call->d);
    return failures;
}

/* The calls of a session, of which init has been called. */
static uint32_t stage43_selftest_calls_of(stage43 *self, const stage43_selftest_session *session)
{
    uint32_t failures = 0U;

    for (uint32_t j = 0U; j < session->count; j++) {
        failures += stage43_selftest_check(self, &stage43_selftest_calls[session->first + j]);
    }
    return failures;
}

/* Every session with its calls. */
static uint32_t stage43_selftest_run(void)
{
    uint32_t failures = 0U;

    for (uint32_t i = 0U; i < 3U; i++) {
        const stage43_selftest_session *session = &stage43_selftest_sessions[i];
        stage43 self;

        if (stage43_init(&self, &session->params) == PTC_OK) {
            failures += stage43_selftest_calls_of(&self, session);
        } else {
            failures++;
        }
    }
    return failures;
}

/* What init must refuse without a change. */
static uint32_t stage43_selftest_refuse(void)
{
    const stage43_selftest_session *session = &stage43_selftest_sessions[0];
    uint32_t failures = 0U;
    stage43 self;

    if (stage43_init(&self, &session->params) != PTC_OK) {
        failures++;
    }
    if (stage43_init(NULL, &session->params) != PTC_E_PARAM) {
        failures++;
    }
    failures += stage43_selftest_calls_of(&self, session);
    return failures;
}

/* Calls that lack a pointer: each is refused, and changes nothing. */
static uint32_t stage43_selftest_pointers(void)
{
    const stage43_selftest_session *session = &stage43_selftest_sessions[0];
    const stage43_selftest_call *call = &stage43_selftest_calls[0];
    uint32_t failures = 0U;
    double u = 12345.0;
    double xhat[3];
    double d;
    stage43 self;

    if (stage43_init(&self, &session->params) != PTC_OK) {
        failures++;
    }
    if (stage43_arm(NULL, call->start) != PTC_E_INPUT) {
        failures++;
    }
    if (stage43_step(NULL, call->k, call->y, &u) != PTC_E_INPUT) {
        failures++;
    }
    failures += stage43_selftest_differs(u, 0.0);
    u = 12345.0;
    if (stage43_step(&self, call->k, NULL, &u) != PTC_E_INPUT) {
        failures++;
    }
    failures += stage43_selftest_differs(u, 0.0);
    if (stage43_step(&self, call->k, call->y, NULL) != PTC_E_INPUT) {
        failures++;
    }
    if (stage43_estimate(NULL, xhat) != PTC_E_INPUT) {
        failures++;
    }
    if (stage43_estimate(&self, NULL) != PTC_E_INPUT) {
        failures++;
    }
    if (stage43_disturbance(NULL, &d) != PTC_E_INPUT) {
        failures++;
    }
    if (stage43_disturbance(&self, NULL) != PTC_E_INPUT) {
        failures++;
    }
    failures += stage43_selftest_calls_of(&self, session);
    return failures;
}

uint32_t stage43_selftest(void)
{
    uint32_t failures = stage43_selftest_run();

    failures += stage43_selftest_refuse();
    failures += stage43_selftest_pointers();
    return failures;
}
