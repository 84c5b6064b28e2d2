/* Self-test of the prescribed-time controller table: see table_selftest.h. DO NOT EDIT. */
#include "table_selftest.h"
#include "table.h"

#include <math.h>
#include <stddef.h>

/* A call, and what it must give. */
typedef struct table_selftest_call {
    double t;
    double x[2];
    double u;
    double tolerance;
    ptc_status status;
    ptc_status axis; /* of tick and axis */
    uint32_t has_axis;
} table_selftest_call;

/* A set of parameters that init takes, and the calls with it. */
typedef struct table_selftest_session {
    table_params params;
    double t0; /* of arm, where it is called */
    uint32_t is_armed_again;
    uint32_t first; /* of its calls */
    uint32_t count;
} table_selftest_session;

static const table_selftest_session table_selftest_sessions[5] = {
    {.params = {.t0 = 0.3}, .t0 = 0.0, .is_armed_again = 0U, .first = 0U, .count = 18U},
    {.params = {.t0 = 0.3}, .t0 = 0.0, .is_armed_again = 0U, .first = 18U, .count = 10U},
    {.params = {.t0 = 0.3}, .t0 = 1000.1, .is_armed_again = 1U, .first = 28U, .count = 4U},
    {.params = {.t0 = 0.3}, .t0 = 0.0, .is_armed_again = 0U, .first = 32U, .count = 9U},
    {.params = {.t0 = 0.3}, .t0 = 0.0, .is_armed_again = 0U, .first = 41U, .count = 1U},
};

/* 1 where what was returned is not what must be. */
static uint32_t table_selftest_differs(const table_selftest_call *call, ptc_status wanted, ptc_status status, double u)
{
    uint32_t failures = 1U;

    if ((status == wanted) && (fabs(u - call->u) <= call->tolerance)) {
        failures = 0U;
    }
    return failures;
}

/* The failures of one call. */
static uint32_t table_selftest_check(const table *self, const table_selftest_call *call)
{
    double u = 12345.0;
    ptc_status status = table_step(self, call->t, call->x, &u);
    uint32_t failures = table_selftest_differs(call, call->status, status, u);

    if (call->has_axis != 0U) {
        table_gains gains;

        u = 0.0;
        status = table_tick(self, call->t, &gains);
        if (status >= PTC_OK) {
            u = 12345.0;
            status = table_axis(&gains, call->x, &u);
        }
        failures += table_selftest_differs(call, call->axis, status, u);
    }
    return failures;
}

/* Every session with its calls. */
static uint32_t table_selftest_run(void)
{
    static const table_selftest_call calls[42] = {
        {.t = 0.3, .x = {0.75, -1.25}, .u = -0.1, .tolerance = 5.5222044604925045e-15, .status = PTC_OK, .axis = PTC_OK, .has_axis = 1U},
        {.t = 0.55, .x = {-0.7031249999999998, 1.1718749999999998}, .u = 0.24999999999999994, .tolerance = 8.180511151231258e-15, .status = PTC_OK, .axis = PTC_OK, .has_axis = 1U},
        {.t = 0.8999999999999999, .x = {0.13636363636363644, -0.22727272727272738}, .u = -0.25, .tolerance = 4.600965696685805e-15, .status = PTC_OK, .axis = PTC_OK, .has_axis = 1U},
        {.t = 1.2, .x = {-0.006696428571428576, 0.011160714285714295}, .u = 0.25, .tolerance = 2.957296865516973e-15, .status = PTC_OK, .axis = PTC_OK, .has_axis = 1U},
        {.t = 0.7, .x = {0.22500000000000003, 0.0}, .u = -0.25, .tolerance = 2.5555111512312582e-15, .status = PTC_OK, .axis = PTC_OK, .has_axis = 1U},
        {.t = 0.7, .x = {0.0, 0.9375}, .u = -0.25, .tolerance = 3.1805111512312583e-15, .status = PTC_OK, .axis = PTC_OK, .has_axis = 1U},
        {.t = 1.25, .x = {0.0015624999999999994, 0.0}, .u = -0.25, .tolerance = 2.5555111512312582e-15, .status = PTC_OK, .axis = PTC_OK, .has_axis = 1U},
        {.t = 1.25, .x = {0.0, 0.07812499999999999}, .u = -0.25, .tolerance = 3.1805111512312583e-15, .status = PTC_OK, .axis = PTC_OK, .has_axis = 1U},
        {.t = (double)NAN, .x = {0.23437499999999992, -0.3906249999999999}, .u = 0.0, .tolerance = 0.0, .status = PTC_E_INPUT, .axis = PTC_E_INPUT, .has_axis = 1U},
        {.t = (double)INFINITY, .x = {0.23437499999999992, -0.3906249999999999}, .u = 0.0, .tolerance = 0.0, .status = PTC_E_INPUT, .axis = PTC_E_INPUT, .has_axis = 1U},
        {.t = -(double)INFINITY, .x = {0.23437499999999992, -0.3906249999999999}, .u = 0.0, .tolerance = 0.0, .status = PTC_E_INPUT, .axis = PTC_E_INPUT, .has_axis = 1U},
        {.t = 0.8, .x = {(double)NAN, -0.3906249999999999}, .u = 0.0, .tolerance = 0.0, .status = PTC_E_INPUT, .axis = PTC_E_INPUT, .has_axis = 1U},
        {.t = 0.8, .x = {0.23437499999999992, (double)NAN}, .u = 0.0, .tolerance = 0.0, .status = PTC_E_INPUT, .axis = PTC_E_INPUT, .has_axis = 1U},
        {.t = 0.8, .x = {(double)INFINITY, -0.3906249999999999}, .u = 0.0, .tolerance = 0.0, .status = PTC_E_INPUT, .axis = PTC_E_INPUT, .has_axis = 1U},
        {.t = 0.8, .x = {0.23437499999999992, (double)INFINITY}, .u = 0.0, .tolerance = 0.0, .status = PTC_E_INPUT, .axis = PTC_E_INPUT, .has_axis = 1U},
        {.t = 0.8, .x = {-(double)INFINITY, -0.3906249999999999}, .u = 0.0, .tolerance = 0.0, .status = PTC_E_INPUT, .axis = PTC_E_INPUT, .has_axis = 1U},
        {.t = 0.8, .x = {0.23437499999999992, -(double)INFINITY}, .u = 0.0, .tolerance = 0.0, .status = PTC_E_INPUT, .axis = PTC_E_INPUT, .has_axis = 1U},
        {.t = -0.2, .x = {0.23437499999999992, -0.3906249999999999}, .u = 0.0, .tolerance = 0.0, .status = PTC_E_INPUT, .axis = PTC_E_INPUT, .has_axis = 1U},
        {.t = 1.2014, .x = {0.006503737334094472, -0.010839562223490787}, .u = -0.24999999999999997, .tolerance = 2.9512761005676355e-15, .status = PTC_OK, .axis = PTC_OK, .has_axis = 1U},
        {.t = 1.2014, .x = {-0.006503737334094472, 0.010839562223490787}, .u = 0.24999999999999997, .tolerance = 2.9512761005676355e-15, .status = PTC_OK, .axis = PTC_OK, .has_axis = 1U},
        {.t = 1.27535, .x = {0.0015706792410560416, -0.002617798735093403}, .u = -0.25, .tolerance = 2.7466688681954826e-15, .status = PTC_HOLD, .axis = PTC_HOLD, .has_axis = 1U},
        {.t = 1.27535, .x = {-0.0015706792410560416, 0.002617798735093403}, .u = 0.25, .tolerance = 2.7466688681954826e-15, .status = PTC_HOLD, .axis = PTC_HOLD, .has_axis = 1U},
        {.t = 1.3, .x = {0.0015706792410560416, -0.002617798735093403}, .u = -0.25, .tolerance = 2.7466688681954826e-15, .status = PTC_HOLD, .axis = PTC_HOLD, .has_axis = 1U},
        {.t = 1.3, .x = {-0.0015706792410560416, 0.002617798735093403}, .u = 0.25, .tolerance = 2.7466688681954826e-15, .status = PTC_HOLD, .axis = PTC_HOLD, .has_axis = 1U},
        {.t = 1.55, .x = {0.0015706792410560416, -0.002617798735093403}, .u = -0.25, .tolerance = 2.7466688681954826e-15, .status = PTC_HOLD, .axis = PTC_HOLD, .has_axis = 1U},
        {.t = 1.55, .x = {-0.0015706792410560416, 0.002617798735093403}, .u = 0.25, .tolerance = 2.7466688681954826e-15, .status = PTC_HOLD, .axis = PTC_HOLD, .has_axis = 1U},
        {.t = 11.3, .x = {0.0015706792410560416, -0.002617798735093403}, .u = -0.25, .tolerance = 2.7466688681954826e-15, .status = PTC_HOLD, .axis = PTC_HOLD, .has_axis = 1U},
        {.t = 11.3, .x = {-0.0015706792410560416, 0.002617798735093403}, .u = 0.25, .tolerance = 2.7466688681954826e-15, .status = PTC_HOLD, .axis = PTC_HOLD, .has_axis = 1U},
        {.t = 1000.1, .x = {-0.75, 1.25}, .u = 0.1, .tolerance = 5.5222044604925045e-15, .status = PTC_OK, .axis = PTC_OK, .has_axis = 1U},
        {.t = 1000.8000000000001, .x = {-0.07031249999997602, 0.11718749999996003}, .u = 0.25, .tolerance = 3.961761151230992e-15, .status = PTC_OK, .axis = PTC_OK, .has_axis = 1U},
        {.t = 1001.1, .x = {-0.0015706792410560416, 0.002617798735093403}, .u = 0.25, .tolerance = 2.7466688681954826e-15, .status = PTC_HOLD, .axis = PTC_HOLD, .has_axis = 1U},
        {.t = 0.3, .x = {0.75, -1.25}, .u = 0.0, .tolerance = 0.0, .status = PTC_E_INPUT, .axis = PTC_E_INPUT, .has_axis = 1U},
        {.t = 0.8, .x = {0.11718749999999996, -0.19531249999999994}, .u = -0.12499999999999999, .tolerance = 2.6840055756156286e-15, .status = PTC_OK, .axis = PTC_OK, .has_axis = 1U},
        {.t = 0.8, .x = {0.7031249999999998, -1.1718749999999996}, .u = -0.5, .tolerance = 0.0, .status = PTC_SATURATED, .axis = PTC_SATURATED, .has_axis = 1U},
        {.t = 0.8, .x = {-0.7031249999999998, 1.1718749999999996}, .u = 0.5, .tolerance = 0.0, .status = PTC_SATURATED, .axis = PTC_SATURATED, .has_axis = 1U},
        {.t = 1.3, .x = {0.0007853396205280208, -0.0013088993675467015}, .u = -0.125, .tolerance = 1.3733344340977413e-15, .status = PTC_HOLD, .axis = PTC_HOLD, .has_axis = 1U},
        {.t = 1.3, .x = {0.004712037723168125, -0.007853396205280208}, .u = -0.5, .tolerance = 0.0, .status = PTC_SATURATED, .axis = PTC_SATURATED, .has_axis = 1U},
        {.t = 1.3, .x = {-0.004712037723168125, 0.007853396205280208}, .u = 0.5, .tolerance = 0.0, .status = PTC_SATURATED, .axis = PTC_SATURATED, .has_axis = 1U},
        {.t = 1.8, .x = {0.0007853396205280208, -0.0013088993675467015}, .u = -0.125, .tolerance = 1.3733344340977413e-15, .status = PTC_HOLD, .axis = PTC_HOLD, .has_axis = 1U},
        {.t = 1.8, .x = {0.004712037723168125, -0.007853396205280208}, .u = -0.5, .tolerance = 0.0, .status = PTC_SATURATED, .axis = PTC_SATURATED, .has_axis = 1U},
        {.t = 1.8, .x = {-0.004712037723168125, 0.007853396205280208}, .u = 0.5, .tolerance = 0.0, .status = PTC_SATURATED, .axis = PTC_SATURATED, .has_axis = 1U},
        {.t = 0.8, .x = {-1.7976931348623157e308, 1.3482698511467367e308}, .u = 0.0, .tolerance = 0.0, .status = PTC_E_RANGE, .axis = PTC_E_RANGE, .has_axis = 1U},
    };
    uint32_t failures = 0U;

    for (uint32_t i = 0U; i < 5U; i++) {
        const table_selftest_session *session = &table_selftest_sessions[i];
        table self;
        ptc_status status = table_init(&self, &session->params);

        if ((status == PTC_OK) && (session->is_armed_again != 0U)) {
            status = table_arm(&self, session->t0);
        }
        if (status == PTC_OK) {
            for (uint32_t j = 0U; j < session->count; j++) {
                failures += table_selftest_check(&self, &calls[session->first + j]);
            }
        } else {
            failures++;
        }
    }
    return failures;
}

/* What init and arm must refuse without a change. */
static uint32_t table_selftest_refuse(void)
{
    static const table_params refused[3] = {
        {.t0 = (double)NAN},
        {.t0 = (double)INFINITY},
        {.t0 = -(double)INFINITY},
    };
    static const double starts[3] = {(double)NAN, (double)INFINITY, -(double)INFINITY};
    const table_selftest_session *session = &table_selftest_sessions[0];
    const table_selftest_call call = {.t = 0.3, .x = {0.75, -1.25}, .u = -0.1, .tolerance = 5.5222044604925045e-15, .status = PTC_OK, .axis = PTC_OK, .has_axis = 1U};
    uint32_t failures = 0U;
    table self;

    if (table_init(&self, &session->params) != PTC_OK) {
        failures++;
    }
    for (uint32_t i = 0U; i < 3U; i++) {
        if (table_init(&self, &refused[i]) != PTC_E_PARAM) {
            failures++;
        }
    }
    for (uint32_t i = 0U; i < 3U; i++) {
        if (table_arm(&self, starts[i]) != PTC_E_PARAM) {
            failures++;
        }
    }
    failures += table_selftest_check(&self, &call);
    if (table_init(&self, NULL) != PTC_E_PARAM) {
        failures++;
    }
    if (table_init(NULL, &session->params) != PTC_E_PARAM) {
        failures++;
    }
    if (table_arm(NULL, session->t0) != PTC_E_PARAM) {
        failures++;
    }
    return failures;
}

/* 1 where a call without one of its pointers was not refused with u = 0. */
static uint32_t table_selftest_refused(ptc_status status, double u)
{
    uint32_t failures = 1U;

    if ((status == PTC_E_INPUT) && (fabs(u) <= 0.0)) {
        failures = 0U;
    }
    return failures;
}

/* Calls that lack a pointer. */
static uint32_t table_selftest_pointers(void)
{
    const table_selftest_session *session = &table_selftest_sessions[0];
    const table_selftest_call call = {.t = 0.3, .x = {0.75, -1.25}, .u = -0.1, .tolerance = 5.5222044604925045e-15, .status = PTC_OK, .axis = PTC_OK, .has_axis = 1U};
    uint32_t failures = 0U;
    double u = 12345.0;
    ptc_status status;
    table_gains gains;
    table self;

    if (table_init(&self, &session->params) != PTC_OK) {
        failures++;
    }
    status = table_step(NULL, call.t, call.x, &u);
    failures += table_selftest_refused(status, u);
    u = 12345.0;
    status = table_step(&self, call.t, NULL, &u);
    failures += table_selftest_refused(status, u);
    status = table_step(&self, call.t, call.x, NULL);
    failures += table_selftest_refused(status, 0.0);
    status = table_tick(NULL, call.t, &gains);
    failures += table_selftest_refused(status, 0.0);
    status = table_tick(&self, call.t, NULL);
    failures += table_selftest_refused(status, 0.0);
    if (table_tick(&self, call.t, &gains) < PTC_OK) {
        failures++;
    }
    u = 12345.0;
    status = table_axis(NULL, call.x, &u);
    failures += table_selftest_refused(status, u);
    u = 12345.0;
    status = table_axis(&gains, NULL, &u);
    failures += table_selftest_refused(status, u);
    status = table_axis(&gains, call.x, NULL);
    failures += table_selftest_refused(status, 0.0);
    return failures;
}

uint32_t table_selftest(void)
{
    uint32_t failures = table_selftest_run();

    failures += table_selftest_refuse();
    failures += table_selftest_pointers();
    return failures;
}
