/* Self-test of the prescribed-time controller motor_late: see motor_late_selftest.h. DO NOT EDIT. */
#include "motor_late_selftest.h"
#include "motor_late.h"

#include <math.h>
#include <stddef.h>

/* A call, and what it must give. */
typedef struct motor_late_selftest_call {
    uint32_t is_armed; /* arm is called before it */
    uint32_t start;
    uint32_t command; /* called before it: 0 none, 1 arm_for, 2 soonest, 3 deadline */
    uint32_t samples;
    ptc_status told; /* its status */
    uint32_t found; /* its result */
    uint32_t k;
    double y[2]; /* what is measured */
    ptc_status status;
    double u;
} motor_late_selftest_call;

/* A set of parameters that init takes, and the calls with it, one after the other. */
typedef struct motor_late_selftest_session {
    motor_late_params params;
    uint32_t first; /* of its calls */
    uint32_t count;
} motor_late_selftest_session;

static const motor_late_selftest_session motor_late_selftest_sessions[5] = {
    {.params = {.none = (char)0}, .first = 0U, .count = 48U},
    {.params = {.none = (char)0}, .first = 48U, .count = 4U},
    {.params = {.none = (char)0}, .first = 52U, .count = 1U},
    {.params = {.none = (char)0}, .first = 53U, .count = 4U},
    {.params = {.none = (char)0}, .first = 57U, .count = 10U},
};

static const motor_late_selftest_call motor_late_selftest_calls[67] = {
    {.is_armed = 0U, .start = 0U, .k = 0U, .y = {0.75, 0.25}, .status = PTC_LATE, .u = -0.34699694755108546},
    {.is_armed = 0U, .start = 0U, .k = 1U, .y = {0.676875, 0.225625}, .status = PTC_OK, .u = -0.3217496137715149},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {0.6075, 0.2025}, .status = PTC_OK, .u = -0.29723996153789106},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {(double)NAN, 0.5}, .status = PTC_E_INPUT, .u = 0.0},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {0.5, (double)NAN}, .status = PTC_E_INPUT, .u = 0.0},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {(double)INFINITY, 0.5}, .status = PTC_E_INPUT, .u = 0.0},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {0.5, (double)INFINITY}, .status = PTC_E_INPUT, .u = 0.0},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {-(double)INFINITY, 0.5}, .status = PTC_E_INPUT, .u = 0.0},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {0.5, -(double)INFINITY}, .status = PTC_E_INPUT, .u = 0.0},
    {.is_armed = 0U, .start = 0U, .k = 3U, .y = {0.5418749999999999, 0.18062499999999998}, .status = PTC_OK, .u = -0.27268346721609804},
    {.is_armed = 0U, .start = 0U, .k = 5U, .y = {0.421875, 0.140625}, .status = PTC_OK, .u = -0.2252625464972315},
    {.is_armed = 0U, .start = 0U, .k = 6U, .y = {0.36749999999999994, 0.12249999999999998}, .status = PTC_OK, .u = -0.20247618794555503},
    {.is_armed = 0U, .start = 0U, .k = 8U, .y = {0.27, 0.09}, .status = PTC_OK, .u = -0.15844443542219022},
    {.is_armed = 0U, .start = 0U, .k = 9U, .y = {0.22687500000000005, 0.07562500000000001}, .status = PTC_OK, .u = -0.13741975826122324},
    {.is_armed = 0U, .start = 0U, .k = 10U, .y = {0.1875, 0.0625}, .status = PTC_OK, .u = -0.11751520143613522},
    {.is_armed = 0U, .start = 0U, .k = 11U, .y = {0.151875, 0.050625}, .status = PTC_OK, .u = -0.09838288732522435},
    {.is_armed = 0U, .start = 0U, .k = 15U, .y = {0.046875, 0.015625}, .status = PTC_OK, .u = -0.035056329011210086},
    {.is_armed = 0U, .start = 0U, .k = 16U, .y = {0.030000000000000006, 0.010000000000000002}, .status = PTC_OK, .u = -0.02333399423547574},
    {.is_armed = 0U, .start = 0U, .k = 18U, .y = {0.0075000000000000015, 0.0025000000000000005}, .status = PTC_OK, .u = -0.006313026945320635},
    {.is_armed = 0U, .start = 0U, .k = 19U, .y = {0.0018750000000000004, 0.0006250000000000001}, .status = PTC_OK, .u = -0.0016420173536742541},
    {.is_armed = 0U, .start = 0U, .k = 20U, .y = {0.0, 0.0}, .status = PTC_OK, .u = -0.0},
    {.is_armed = 0U, .start = 0U, .k = 21U, .y = {0.0, 0.0}, .status = PTC_OK, .u = -0.0},
    {.is_armed = 0U, .start = 0U, .k = 2147483647U, .y = {0.0, 0.0}, .status = PTC_HOLD, .u = -0.0},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {0.0, 0.0}, .status = PTC_HOLD, .u = -0.0},
    {.is_armed = 1U, .start = 4294967293U, .k = 4294967293U, .y = {0.75, 0.25}, .status = PTC_LATE, .u = -0.34699694755108546},
    {.is_armed = 0U, .start = 0U, .k = 4294967294U, .y = {0.676875, 0.225625}, .status = PTC_OK, .u = -0.3217496137715149},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {0.6075, 0.2025}, .status = PTC_OK, .u = -0.29723996153789106},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {(double)NAN, 0.5}, .status = PTC_E_INPUT, .u = 0.0},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {0.5, (double)NAN}, .status = PTC_E_INPUT, .u = 0.0},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {(double)INFINITY, 0.5}, .status = PTC_E_INPUT, .u = 0.0},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {0.5, (double)INFINITY}, .status = PTC_E_INPUT, .u = 0.0},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {-(double)INFINITY, 0.5}, .status = PTC_E_INPUT, .u = 0.0},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {0.5, -(double)INFINITY}, .status = PTC_E_INPUT, .u = 0.0},
    {.is_armed = 0U, .start = 0U, .k = 0U, .y = {0.5418749999999999, 0.18062499999999998}, .status = PTC_OK, .u = -0.27268346721609804},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {0.421875, 0.140625}, .status = PTC_OK, .u = -0.2252625464972315},
    {.is_armed = 0U, .start = 0U, .k = 3U, .y = {0.36749999999999994, 0.12249999999999998}, .status = PTC_OK, .u = -0.20247618794555503},
    {.is_armed = 0U, .start = 0U, .k = 5U, .y = {0.27, 0.09}, .status = PTC_OK, .u = -0.15844443542219022},
    {.is_armed = 0U, .start = 0U, .k = 6U, .y = {0.22687500000000005, 0.07562500000000001}, .status = PTC_OK, .u = -0.13741975826122324},
    {.is_armed = 0U, .start = 0U, .k = 7U, .y = {0.1875, 0.0625}, .status = PTC_OK, .u = -0.11751520143613522},
    {.is_armed = 0U, .start = 0U, .k = 8U, .y = {0.151875, 0.050625}, .status = PTC_OK, .u = -0.09838288732522435},
    {.is_armed = 0U, .start = 0U, .k = 12U, .y = {0.046875, 0.015625}, .status = PTC_OK, .u = -0.035056329011210086},
    {.is_armed = 0U, .start = 0U, .k = 13U, .y = {0.030000000000000006, 0.010000000000000002}, .status = PTC_OK, .u = -0.02333399423547574},
    {.is_armed = 0U, .start = 0U, .k = 15U, .y = {0.0075000000000000015, 0.0025000000000000005}, .status = PTC_OK, .u = -0.006313026945320635},
    {.is_armed = 0U, .start = 0U, .k = 16U, .y = {0.0018750000000000004, 0.0006250000000000001}, .status = PTC_OK, .u = -0.0016420173536742541},
    {.is_armed = 0U, .start = 0U, .k = 17U, .y = {0.0, 0.0}, .status = PTC_OK, .u = -0.0},
    {.is_armed = 0U, .start = 0U, .k = 18U, .y = {0.0, 0.0}, .status = PTC_OK, .u = -0.0},
    {.is_armed = 0U, .start = 0U, .k = 2147483644U, .y = {0.0, 0.0}, .status = PTC_HOLD, .u = -0.0},
    {.is_armed = 0U, .start = 0U, .k = 4294967292U, .y = {0.0, 0.0}, .status = PTC_HOLD, .u = -0.0},
    {.is_armed = 0U, .start = 0U, .k = 0U, .y = {0.8093363179470259, 0.5832694127918291}, .status = PTC_LATE, .u = -0.3347347198391317},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {-0.8035662514816649, 0.5410809886740985}, .status = PTC_SATURATED, .u = 10.0},
    {.is_armed = 1U, .start = 4294967290U, .k = 2U, .y = {-7.392223229539965e301, -1.5911377185444424e302}, .status = PTC_SATURATED, .u = 10.0},
    {.is_armed = 1U, .start = 4294967290U, .k = 4U, .y = {6.676187814095494e301, 1.511549547054382e302}, .status = PTC_SATURATED, .u = -10.0},
    {.is_armed = 0U, .start = 0U, .k = 16U, .y = {-1.0106924722705522e308, 1.6512261333402054e308}, .status = PTC_E_RANGE, .u = 0.0},
    {.is_armed = 1U, .start = 0U, .k = 6U, .y = {0.8330369115588935, -0.8226425935285533}, .status = PTC_LATE, .u = -0.30534213164856217},
    {.is_armed = 1U, .start = 0U, .k = 0U, .y = {0.9550415503539369, 0.5227698888195139}, .status = PTC_INFEASIBLE, .u = -3.7411206171272955},
    {.is_armed = 1U, .start = 0U, .k = 5U, .y = {0.8917642199364082, 0.7871160860148623}, .status = PTC_LATE, .u = -0.3165486350970999},
    {.is_armed = 0U, .start = 0U, .k = 0U, .y = {-0.7654176821558322, 0.4023375384664444}, .status = PTC_OK, .u = 0.1998367921512748},
    {.command = 1U, .samples = 1024U, .told = PTC_E_PARAM, .found = 0U, .is_armed = 0U, .start = 0U, .k = 10U, .y = {0.9758428052952026, 0.01766229882585071}, .status = PTC_LATE, .u = -0.29715141331575534},
    {.command = 2U, .samples = 1024U, .told = PTC_E_SOON, .found = 0U, .is_armed = 0U, .start = 0U, .k = 2U, .y = {4.306048669435136, -48.16701145698572}, .status = PTC_INFEASIBLE, .u = 1.4514297166277559},
    {.command = 3U, .samples = 1024U, .told = PTC_OK, .found = 88U, .is_armed = 0U, .start = 0U, .k = 10U, .y = {0.09758228113736639, 0.0007302985706005156}, .status = PTC_OK, .u = -0.029654070079073766},
    {.command = 2U, .samples = 3000U, .told = PTC_OK, .found = 8U, .is_armed = 0U, .start = 0U, .k = 7U, .y = {0.0958659692571954, -0.5487527492606439}, .status = PTC_OK, .u = 0.002934312778164593},
    {.command = 1U, .samples = 40U, .told = PTC_OK, .found = 0U, .is_armed = 0U, .start = 0U, .k = 7U, .y = {33.098142602768334, -0.0005429828361812283}, .status = PTC_SATURATED, .u = -10.0},
    {.command = 2U, .samples = 200U, .told = PTC_E_INPUT, .found = 0U, .is_armed = 0U, .start = 0U, .k = 10U, .y = {(double)INFINITY, 0.028260436922771737}, .status = PTC_E_INPUT, .u = 0.0},
    {.command = 1U, .samples = 1U, .told = PTC_E_PARAM, .found = 0U, .is_armed = 0U, .start = 0U, .k = 2U, .y = {-49.739536806697714, -0.8620427533554169}, .status = PTC_SATURATED, .u = 10.0},
    {.command = 2U, .samples = 0U, .told = PTC_E_SOON, .found = 0U, .is_armed = 0U, .start = 0U, .k = 1U, .y = {-0.058909454171353674, 1.9117759468292306}, .status = PTC_HOLD, .u = 8.008120878427547},
    {.command = 2U, .samples = 40U, .told = PTC_E_INPUT, .found = 0U, .is_armed = 0U, .start = 0U, .k = 2U, .y = {-0.0009042697498454278, (double)INFINITY}, .status = PTC_E_INPUT, .u = 0.0},
    {.command = 1U, .samples = 1048576U, .told = PTC_E_PARAM, .found = 0U, .is_armed = 0U, .start = 0U, .k = 2U, .y = {-0.02615851306217092, -0.25236927100350415}, .status = PTC_HOLD, .u = 7.640481716693952},
};

/* 1 where a number is not the one that must come. */
static uint32_t motor_late_selftest_differs(double value, double wanted)
{
    uint32_t failures = 1U;

    if (fabs(value - wanted) <= 0.0) {
        failures = 0U;
    }
    return failures;
}

/* The failures of what is called before a call. */
static uint32_t motor_late_selftest_command(motor_late *self, const motor_late_selftest_call *call)
{
    uint32_t failures = 0U;
    uint32_t found = 0U;
    ptc_status told = call->told;

    switch (call->command) {
    case 1U:
        told = motor_late_arm_for(self, call->k, call->samples);
        break;
    case 2U:
        told = motor_late_soonest(self, call->y, &found);
        break;
    case 3U:
        told = motor_late_deadline(self, &found);
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
static uint32_t motor_late_selftest_check(motor_late *self, const motor_late_selftest_call *call)
{
    uint32_t failures = 0U;
    double u = 12345.0;

    if (call->is_armed != 0U) {
        if (motor_late_arm(self, call->start) != PTC_OK) {
            failures++;
        }
    }
    failures += motor_late_selftest_command(self, call);
    if (motor_late_step(self, call->k, call->y, &u) != call->status) {
        failures++;
    }
    failures += motor_late_selftest_differs(u, call->u);
    return failures;
}

/* The calls of a session, of which init has been called. */
static uint32_t motor_late_selftest_calls_of(motor_late *self, const motor_late_selftest_session *session)
{
    uint32_t failures = 0U;

    for (uint32_t j = 0U; j < session->count; j++) {
        failures += motor_late_selftest_check(self, &motor_late_selftest_calls[session->first + j]);
    }
    return failures;
}

/* Every session with its calls. */
static uint32_t motor_late_selftest_run(void)
{
    uint32_t failures = 0U;

    for (uint32_t i = 0U; i < 5U; i++) {
        const motor_late_selftest_session *session = &motor_late_selftest_sessions[i];
        motor_late self;

        if (motor_late_init(&self, &session->params) == PTC_OK) {
            failures += motor_late_selftest_calls_of(&self, session);
        } else {
            failures++;
        }
    }
    return failures;
}

/* What init must refuse without a change. */
static uint32_t motor_late_selftest_refuse(void)
{
    const motor_late_selftest_session *session = &motor_late_selftest_sessions[0];
    uint32_t failures = 0U;
    motor_late self;

    if (motor_late_init(&self, &session->params) != PTC_OK) {
        failures++;
    }
    if (motor_late_init(NULL, &session->params) != PTC_E_PARAM) {
        failures++;
    }
    failures += motor_late_selftest_calls_of(&self, session);
    return failures;
}

/* Calls that lack a pointer: each is refused, and changes nothing. */
static uint32_t motor_late_selftest_pointers(void)
{
    const motor_late_selftest_session *session = &motor_late_selftest_sessions[0];
    const motor_late_selftest_call *call = &motor_late_selftest_calls[0];
    uint32_t failures = 0U;
    double u = 12345.0;
    motor_late self;

    if (motor_late_init(&self, &session->params) != PTC_OK) {
        failures++;
    }
    if (motor_late_arm(NULL, call->start) != PTC_E_INPUT) {
        failures++;
    }
    if (motor_late_step(NULL, call->k, call->y, &u) != PTC_E_INPUT) {
        failures++;
    }
    failures += motor_late_selftest_differs(u, 0.0);
    u = 12345.0;
    if (motor_late_step(&self, call->k, NULL, &u) != PTC_E_INPUT) {
        failures++;
    }
    failures += motor_late_selftest_differs(u, 0.0);
    if (motor_late_step(&self, call->k, call->y, NULL) != PTC_E_INPUT) {
        failures++;
    }
    failures += motor_late_selftest_calls_of(&self, session);
    return failures;
}

uint32_t motor_late_selftest(void)
{
    uint32_t failures = motor_late_selftest_run();

    failures += motor_late_selftest_refuse();
    failures += motor_late_selftest_pointers();
    return failures;
}
