/* Self-test of the prescribed-time controller tank: see tank_selftest.h. DO NOT EDIT. */
#include "tank_selftest.h"
#include "tank.h"

#include <math.h>
#include <stddef.h>

/* A call, and what it must give. */
typedef struct tank_selftest_call {
    double t;
    double x[3];
    double u[2];
    double tolerance[2];
    ptc_status axes[2];
    ptc_status status;
} tank_selftest_call;

/* A set of parameters that init takes, and the calls with it. */
typedef struct tank_selftest_session {
    tank_params params;
    double t0; /* of arm, where it is called */
    uint32_t is_armed_again;
    uint32_t first; /* of its calls */
    uint32_t count;
} tank_selftest_session;

static const tank_selftest_session tank_selftest_sessions[7] = {
    {.params = {.t0 = 0.3}, .t0 = 0.0, .is_armed_again = 0U, .first = 0U, .count = 24U},
    {.params = {.t0 = 0.3}, .t0 = 0.0, .is_armed_again = 0U, .first = 24U, .count = 10U},
    {.params = {.t0 = 0.3}, .t0 = 1000.1, .is_armed_again = 1U, .first = 34U, .count = 4U},
    {.params = {.t0 = 0.3}, .t0 = 0.0, .is_armed_again = 0U, .first = 38U, .count = 15U},
    {.params = {.t0 = 0.3}, .t0 = 0.0, .is_armed_again = 0U, .first = 53U, .count = 1U},
    {.params = {.t0 = 0.3}, .t0 = 0.0, .is_armed_again = 0U, .first = 54U, .count = 1U},
    {.params = {.t0 = 0.3}, .t0 = 0.0, .is_armed_again = 0U, .first = 55U, .count = 1U},
};

/* The failures of what was returned for each input, and of the status of all. */
static uint32_t tank_selftest_differs(const tank_selftest_call *call, ptc_status status, const double u[2], const ptc_status axes[2])
{
    uint32_t failures = 0U;

    if (status != call->status) {
        failures++;
    }
    for (uint32_t i = 0U; i < 2U; i++) {
        if (!((axes[i] == call->axes[i]) && (fabs(u[i] - call->u[i]) <= call->tolerance[i]))) {
            failures++;
        }
    }
    return failures;
}

/* The failures of one call. */
static uint32_t tank_selftest_check(const tank *self, const tank_selftest_call *call)
{
    double u[2] = {12345.0, 12345.0};
    ptc_status axes[2] = {PTC_E_PARAM, PTC_E_PARAM};
    ptc_status status = tank_step(self, call->t, call->x, u, axes);

    return tank_selftest_differs(call, status, u, axes);
}

/* Every session with its calls. */
static uint32_t tank_selftest_run(void)
{
    static const tank_selftest_call calls[56] = {
        {.t = 0.3, .x = {0.75, -1.25, 0.5}, .u = {-0.025, -5.003809523809524}, .tolerance = {2.255551115123126e-15, 2.2152059271835822e-13}, .status = PTC_OK, .axes = {PTC_OK, PTC_OK}},
        {.t = 7.8, .x = {-0.75, 1.25, -0.5}, .u = {0.058333333333333334, -0.6025925925925926}, .tolerance = {1.026295260195396e-14, 2.34233802434153e-13}, .status = PTC_OK, .axes = {PTC_OK, PTC_OK}},
        {.t = 18.3, .x = {0.75, -1.25, 0.5}, .u = {-0.17500000000000002, -4.648809523809524}, .tolerance = {6.788857805861882e-15, 2.350917668836099e-13}, .status = PTC_OK, .axes = {PTC_OK, PTC_OK}},
        {.t = 27.3, .x = {-0.75, 1.25, -0.5}, .u = {0.9250000000000003, -7.083333333333335}, .tolerance = {1.404553912595557e-13, 1.160406149284886e-12}, .status = PTC_OK, .axes = {PTC_OK, PTC_OK}},
        {.t = 12.3, .x = {1.0, 0.0, 0.0}, .u = {-0.12222222222222223, -0.0}, .tolerance = {5.6938054517130605e-15, 0.0}, .status = PTC_OK, .axes = {PTC_OK, PTC_OK}},
        {.t = 12.3, .x = {0.0, 1.0, 0.0}, .u = {0.0, 1.6666666666666667}, .tolerance = {0.0, 8.592562989709728e-14}, .status = PTC_OK, .axes = {PTC_OK, PTC_OK}},
        {.t = 12.3, .x = {0.0, 0.0, 1.0}, .u = {-0.0, -0.7037037037037037}, .tolerance = {0.0, 4.645254990716947e-14}, .status = PTC_OK, .axes = {PTC_OK, PTC_OK}},
        {.t = 28.8, .x = {0.38961038961038946, 0.0, 0.0}, .u = {-1.0000000000000002, -0.0}, .tolerance = {3.100126538414582e-14, 0.0}, .status = PTC_OK, .axes = {PTC_OK, PTC_OK}},
        {.t = 28.8, .x = {0.0, 1.0, 0.0}, .u = {-0.0, -2.0000000000000018}, .tolerance = {0.0, 1.8711075587651683e-13}, .status = PTC_OK, .axes = {PTC_OK, PTC_OK}},
        {.t = 28.8, .x = {0.0, 0.0, 1.0}, .u = {-0.0, -2.3333333333333366}, .tolerance = {0.0, 2.138514374114919e-13}, .status = PTC_OK, .axes = {PTC_OK, PTC_OK}},
        {.t = 21.3, .x = {0.0, 0.0, 1.0}, .u = {-0.0, -0.48148148148148145}, .tolerance = {0.0, 5.4180984439408356e-14}, .status = PTC_OK, .axes = {PTC_OK, PTC_OK}},
        {.t = (double)NAN, .x = {0.75, -1.25, 0.5}, .u = {0.0, 0.0}, .tolerance = {0.0, 0.0}, .status = PTC_E_INPUT, .axes = {PTC_E_INPUT, PTC_E_INPUT}},
        {.t = (double)INFINITY, .x = {0.75, -1.25, 0.5}, .u = {0.0, 0.0}, .tolerance = {0.0, 0.0}, .status = PTC_E_INPUT, .axes = {PTC_E_INPUT, PTC_E_INPUT}},
        {.t = -(double)INFINITY, .x = {0.75, -1.25, 0.5}, .u = {0.0, 0.0}, .tolerance = {0.0, 0.0}, .status = PTC_E_INPUT, .axes = {PTC_E_INPUT, PTC_E_INPUT}},
        {.t = 15.3, .x = {(double)NAN, -1.25, 0.5}, .u = {0.0, 0.0}, .tolerance = {0.0, 0.0}, .status = PTC_E_INPUT, .axes = {PTC_E_INPUT, PTC_E_INPUT}},
        {.t = 15.3, .x = {0.75, (double)NAN, 0.5}, .u = {0.0, 0.0}, .tolerance = {0.0, 0.0}, .status = PTC_E_INPUT, .axes = {PTC_E_INPUT, PTC_E_INPUT}},
        {.t = 15.3, .x = {0.75, -1.25, (double)NAN}, .u = {0.0, 0.0}, .tolerance = {0.0, 0.0}, .status = PTC_E_INPUT, .axes = {PTC_E_INPUT, PTC_E_INPUT}},
        {.t = 15.3, .x = {(double)INFINITY, -1.25, 0.5}, .u = {0.0, 0.0}, .tolerance = {0.0, 0.0}, .status = PTC_E_INPUT, .axes = {PTC_E_INPUT, PTC_E_INPUT}},
        {.t = 15.3, .x = {0.75, (double)INFINITY, 0.5}, .u = {0.0, 0.0}, .tolerance = {0.0, 0.0}, .status = PTC_E_INPUT, .axes = {PTC_E_INPUT, PTC_E_INPUT}},
        {.t = 15.3, .x = {0.75, -1.25, (double)INFINITY}, .u = {0.0, 0.0}, .tolerance = {0.0, 0.0}, .status = PTC_E_INPUT, .axes = {PTC_E_INPUT, PTC_E_INPUT}},
        {.t = 15.3, .x = {-(double)INFINITY, -1.25, 0.5}, .u = {0.0, 0.0}, .tolerance = {0.0, 0.0}, .status = PTC_E_INPUT, .axes = {PTC_E_INPUT, PTC_E_INPUT}},
        {.t = 15.3, .x = {0.75, -(double)INFINITY, 0.5}, .u = {0.0, 0.0}, .tolerance = {0.0, 0.0}, .status = PTC_E_INPUT, .axes = {PTC_E_INPUT, PTC_E_INPUT}},
        {.t = 15.3, .x = {0.75, -1.25, -(double)INFINITY}, .u = {0.0, 0.0}, .tolerance = {0.0, 0.0}, .status = PTC_E_INPUT, .axes = {PTC_E_INPUT, PTC_E_INPUT}},
        {.t = -14.7, .x = {0.75, -1.25, 0.5}, .u = {0.0, 0.0}, .tolerance = {0.0, 0.0}, .status = PTC_E_INPUT, .axes = {PTC_E_INPUT, PTC_E_INPUT}},
        {.t = 29.3, .x = {0.2564102564102563, -0.42735042735042705, 0.17094017094017083}, .u = {-1.0000000000000002, 0.18006413610809202}, .tolerance = {3.0734865117745556e-14, 1.6256463710231042e-13}, .status = PTC_OK, .axes = {PTC_OK, PTC_OK}},
        {.t = 29.3, .x = {-0.2564102564102563, 0.42735042735042705, -0.17094017094017083}, .u = {1.0000000000000002, -0.8936951642521916}, .tolerance = {4.4527968566021413e-14, 2.2193690782587817e-13}, .status = PTC_OK, .axes = {PTC_OK, PTC_OK}},
        {.t = 30.05, .x = {0.12658227848101267, -0.21097046413502107, 0.08438818565400844}, .u = {-1.0, -0.8871141484936812}, .tolerance = {3.0475209161887067e-14, 1.6202677786606536e-13}, .status = PTC_HOLD, .axes = {PTC_HOLD, PTC_HOLD}},
        {.t = 30.05, .x = {-0.12658227848101267, 0.21097046413502107, -0.08438818565400844}, .u = {1.0, 1.1931693716246081}, .tolerance = {3.627231061116243e-14, 1.9300976824196017e-13}, .status = PTC_HOLD, .axes = {PTC_HOLD, PTC_HOLD}},
        {.t = 30.3, .x = {0.12658227848101267, -0.21097046413502107, 0.08438818565400844}, .u = {-1.0, -0.8871141484936812}, .tolerance = {3.0475209161887067e-14, 1.6202677786606536e-13}, .status = PTC_HOLD, .axes = {PTC_HOLD, PTC_HOLD}},
        {.t = 30.3, .x = {-0.12658227848101267, 0.21097046413502107, -0.08438818565400844}, .u = {1.0, 1.1931693716246081}, .tolerance = {3.627231061116243e-14, 1.9300976824196017e-13}, .status = PTC_HOLD, .axes = {PTC_HOLD, PTC_HOLD}},
        {.t = 37.8, .x = {0.12658227848101267, -0.21097046413502107, 0.08438818565400844}, .u = {-1.0, -0.8871141484936812}, .tolerance = {3.0475209161887067e-14, 1.6202677786606536e-13}, .status = PTC_HOLD, .axes = {PTC_HOLD, PTC_HOLD}},
        {.t = 37.8, .x = {-0.12658227848101267, 0.21097046413502107, -0.08438818565400844}, .u = {1.0, 1.1931693716246081}, .tolerance = {3.627231061116243e-14, 1.9300976824196017e-13}, .status = PTC_HOLD, .axes = {PTC_HOLD, PTC_HOLD}},
        {.t = 330.3, .x = {0.12658227848101267, -0.21097046413502107, 0.08438818565400844}, .u = {-1.0, -0.8871141484936812}, .tolerance = {3.0475209161887067e-14, 1.6202677786606536e-13}, .status = PTC_HOLD, .axes = {PTC_HOLD, PTC_HOLD}},
        {.t = 330.3, .x = {-0.12658227848101267, 0.21097046413502107, -0.08438818565400844}, .u = {1.0, 1.1931693716246081}, .tolerance = {3.627231061116243e-14, 1.9300976824196017e-13}, .status = PTC_HOLD, .axes = {PTC_HOLD, PTC_HOLD}},
        {.t = 1000.1, .x = {-0.75, 1.25, -0.5}, .u = {0.025, -0.2733333333333333}, .tolerance = {5.255551115123127e-15, 1.937940255253462e-13}, .status = PTC_OK, .axes = {PTC_OK, PTC_OK}},
        {.t = 1021.1, .x = {-0.75, 1.25, -0.5}, .u = {0.25833333333333336, -2.4537037037037037}, .tolerance = {4.0307361522938976e-14, 4.693781650028255e-13}, .status = PTC_OK, .axes = {PTC_OK, PTC_OK}},
        {.t = 1030.1, .x = {-0.12658227848101267, 0.21097046413502107, -0.08438818565400844}, .u = {1.0, 1.1931693716246081}, .tolerance = {3.627231061116243e-14, 1.9300976824196017e-13}, .status = PTC_HOLD, .axes = {PTC_HOLD, PTC_HOLD}},
        {.t = 0.3, .x = {0.75, -1.25, 0.5}, .u = {0.0, 0.0}, .tolerance = {0.0, 0.0}, .status = PTC_E_INPUT, .axes = {PTC_E_INPUT, PTC_E_INPUT}},
        {.t = 15.3, .x = {1.9673728390126912, -3.2789547316878185, 1.3115818926751275}, .u = {-0.32789547316878187, -22.350682438186485}, .tolerance = {1.384441729388531e-14, 1.0005418197042578e-12}, .status = PTC_OK, .axes = {PTC_OK, PTC_OK}},
        {.t = 15.3, .x = {11.804237034076147, -19.67372839012691, 7.869491356050765}, .u = {-1.9673728390126912, -50.0}, .tolerance = {8.306650376331184e-14, 0.0}, .status = PTC_SATURATED, .axes = {PTC_OK, PTC_SATURATED}},
        {.t = 15.3, .x = {31.47796542420306, -52.463275707005096, 20.98531028280204}, .u = {-2.0, -50.0}, .tolerance = {0.0, 0.0}, .status = PTC_SATURATED, .axes = {PTC_SATURATED, PTC_SATURATED}},
        {.t = 15.3, .x = {-31.47796542420306, 52.463275707005096, -20.98531028280204}, .u = {2.0, -50.0}, .tolerance = {0.0, 0.0}, .status = PTC_SATURATED, .axes = {PTC_SATURATED, PTC_SATURATED}},
        {.t = 15.3, .x = {-906.996361586016, 199.79086514748496, 401.0872210879254}, .u = {2.0, 50.0}, .tolerance = {0.0, 0.0}, .status = PTC_SATURATED, .axes = {PTC_SATURATED, PTC_SATURATED}},
        {.t = 30.3, .x = {0.06329113924050633, -0.10548523206751054, 0.04219409282700422}, .u = {-0.5, -0.4721211242602046}, .tolerance = {1.5237604580943533e-14, 8.063072574351442e-14}, .status = PTC_HOLD, .axes = {PTC_HOLD, PTC_HOLD}},
        {.t = 30.3, .x = {0.379746835443038, -0.6329113924050633, 0.25316455696202533}, .u = {-2.0, -2.2212389510620065}, .tolerance = {0.0, 4.967054478152407e-13}, .status = PTC_SATURATED, .axes = {PTC_SATURATED, PTC_HOLD}},
        {.t = 30.3, .x = {-0.379746835443038, 0.6329113924050633, -0.25316455696202533}, .u = {2.0, 5.56111821431024}, .tolerance = {0.0, 9.172247422483509e-13}, .status = PTC_SATURATED, .axes = {PTC_SATURATED, PTC_HOLD}},
        {.t = 30.3, .x = {-1.0126582278481013, 1.6877637130801686, -0.6751054852320675}, .u = {2.0, -50.0}, .tolerance = {0.0, 0.0}, .status = PTC_SATURATED, .axes = {PTC_SATURATED, PTC_SATURATED}},
        {.t = 30.3, .x = {-0.6620186662244865, 0.5229874252951987, -0.7311917572872835}, .u = {2.0, 50.0}, .tolerance = {0.0, 0.0}, .status = PTC_SATURATED, .axes = {PTC_SATURATED, PTC_SATURATED}},
        {.t = 45.3, .x = {0.06329113924050633, -0.10548523206751054, 0.04219409282700422}, .u = {-0.5, -0.4721211242602046}, .tolerance = {1.5237604580943533e-14, 8.063072574351442e-14}, .status = PTC_HOLD, .axes = {PTC_HOLD, PTC_HOLD}},
        {.t = 45.3, .x = {0.379746835443038, -0.6329113924050633, 0.25316455696202533}, .u = {-2.0, -2.2212389510620065}, .tolerance = {0.0, 4.967054478152407e-13}, .status = PTC_SATURATED, .axes = {PTC_SATURATED, PTC_HOLD}},
        {.t = 45.3, .x = {-0.379746835443038, 0.6329113924050633, -0.25316455696202533}, .u = {2.0, 5.56111821431024}, .tolerance = {0.0, 9.172247422483509e-13}, .status = PTC_SATURATED, .axes = {PTC_SATURATED, PTC_HOLD}},
        {.t = 45.3, .x = {-1.0126582278481013, 1.6877637130801686, -0.6751054852320675}, .u = {2.0, -50.0}, .tolerance = {0.0, 0.0}, .status = PTC_SATURATED, .axes = {PTC_SATURATED, PTC_SATURATED}},
        {.t = 45.3, .x = {-0.6620186662244865, 0.5229874252951987, -0.7311917572872835}, .u = {2.0, 50.0}, .tolerance = {0.0, 0.0}, .status = PTC_SATURATED, .axes = {PTC_SATURATED, PTC_SATURATED}},
        {.t = 29.7, .x = {-1.0, 1.0, -1.0}, .u = {0.0, 0.0}, .tolerance = {0.0, 0.0}, .status = PTC_E_RANGE, .axes = {PTC_E_RANGE, PTC_E_RANGE}},
        {.t = 30.3, .x = {1.0, 1.3482698511467367e308, -1.7976931348623157e308}, .u = {0.0, 0.0}, .tolerance = {0.0, 0.0}, .status = PTC_E_RANGE, .axes = {PTC_HOLD, PTC_E_RANGE}},
        {.t = 29.7, .x = {0.0, -1.0, -1.7976931348623157e308}, .u = {0.0, 0.0}, .tolerance = {0.0, 0.0}, .status = PTC_E_RANGE, .axes = {PTC_OK, PTC_E_RANGE}},
    };
    uint32_t failures = 0U;

    for (uint32_t i = 0U; i < 7U; i++) {
        const tank_selftest_session *session = &tank_selftest_sessions[i];
        tank self;
        ptc_status status = tank_init(&self, &session->params);

        if ((status == PTC_OK) && (session->is_armed_again != 0U)) {
            status = tank_arm(&self, session->t0);
        }
        if (status == PTC_OK) {
            for (uint32_t j = 0U; j < session->count; j++) {
                failures += tank_selftest_check(&self, &calls[session->first + j]);
            }
        } else {
            failures++;
        }
    }
    return failures;
}

/* What init and arm must refuse without a change. */
static uint32_t tank_selftest_refuse(void)
{
    static const tank_params refused[3] = {
        {.t0 = (double)NAN},
        {.t0 = (double)INFINITY},
        {.t0 = -(double)INFINITY},
    };
    static const double starts[3] = {(double)NAN, (double)INFINITY, -(double)INFINITY};
    const tank_selftest_session *session = &tank_selftest_sessions[0];
    const tank_selftest_call call = {.t = 0.3, .x = {0.75, -1.25, 0.5}, .u = {-0.025, -5.003809523809524}, .tolerance = {2.255551115123126e-15, 2.2152059271835822e-13}, .status = PTC_OK, .axes = {PTC_OK, PTC_OK}};
    uint32_t failures = 0U;
    tank self;

    if (tank_init(&self, &session->params) != PTC_OK) {
        failures++;
    }
    for (uint32_t i = 0U; i < 3U; i++) {
        if (tank_init(&self, &refused[i]) != PTC_E_PARAM) {
            failures++;
        }
    }
    for (uint32_t i = 0U; i < 3U; i++) {
        if (tank_arm(&self, starts[i]) != PTC_E_PARAM) {
            failures++;
        }
    }
    failures += tank_selftest_check(&self, &call);
    if (tank_init(&self, NULL) != PTC_E_PARAM) {
        failures++;
    }
    if (tank_init(NULL, &session->params) != PTC_E_PARAM) {
        failures++;
    }
    if (tank_arm(NULL, session->t0) != PTC_E_PARAM) {
        failures++;
    }
    return failures;
}

/* 1 where a call without one of its pointers was not refused with u = 0; u is lost for the next one. */
static uint32_t tank_selftest_refused(ptc_status status, double u[2])
{
    uint32_t failures = 0U;

    if (status != PTC_E_INPUT) {
        failures = 1U;
    }
    for (uint32_t i = 0U; i < 2U; i++) {
        if (!(fabs(u[i]) <= 0.0)) {
            failures = 1U;
        }
        u[i] = 12345.0;
    }
    return failures;
}

/* Calls that lack a pointer. */
static uint32_t tank_selftest_pointers(void)
{
    const tank_selftest_session *session = &tank_selftest_sessions[0];
    const tank_selftest_call call = {.t = 0.3, .x = {0.75, -1.25, 0.5}, .u = {-0.025, -5.003809523809524}, .tolerance = {2.255551115123126e-15, 2.2152059271835822e-13}, .status = PTC_OK, .axes = {PTC_OK, PTC_OK}};
    uint32_t failures = 0U;
    double u[2] = {12345.0, 12345.0};
    ptc_status axes[2];
    ptc_status status;
    tank self;

    if (tank_init(&self, &session->params) != PTC_OK) {
        failures++;
    }
    status = tank_step(NULL, call.t, call.x, u, axes);
    failures += tank_selftest_refused(status, u);
    status = tank_step(&self, call.t, NULL, u, axes);
    failures += tank_selftest_refused(status, u);
    status = tank_step(&self, call.t, call.x, u, NULL);
    failures += tank_selftest_refused(status, u);
    status = tank_step(&self, call.t, call.x, NULL, axes);
    if (status != PTC_E_INPUT) {
        failures++;
    }
    return failures;
}

uint32_t tank_selftest(void)
{
    uint32_t failures = tank_selftest_run();

    failures += tank_selftest_refuse();
    failures += tank_selftest_pointers();
    return failures;
}
