/* Self-test of the prescribed-time controller gantry: see gantry_selftest.h. DO NOT EDIT. */
#include "gantry_selftest.h"
#include "gantry.h"

#include <math.h>
#include <stddef.h>

/* A call, and what it must give. */
typedef struct gantry_selftest_call {
    double t;
    double x[3][2];
    double u[3];
    double tolerance[3];
    ptc_status axes[3];
    ptc_status status;
} gantry_selftest_call;

/* A set of parameters that init takes, and the calls with it. */
typedef struct gantry_selftest_session {
    gantry_params params;
    double t0; /* of arm, where it is called */
    uint32_t is_armed_again;
    uint32_t first; /* of its calls */
    uint32_t count;
} gantry_selftest_session;

static const gantry_selftest_session gantry_selftest_sessions[29] = {
    {.params = {.none = (char)0}, .t0 = 0.0, .is_armed_again = 0U, .first = 0U, .count = 42U},
    {.params = {.none = (char)0}, .t0 = 0.0, .is_armed_again = 0U, .first = 42U, .count = 10U},
    {.params = {.none = (char)0}, .t0 = 1000.1, .is_armed_again = 1U, .first = 52U, .count = 4U},
    {.params = {.none = (char)0}, .t0 = 0.0, .is_armed_again = 0U, .first = 56U, .count = 15U},
    {.params = {.none = (char)0}, .t0 = 0.0, .is_armed_again = 0U, .first = 71U, .count = 1U},
    {.params = {.none = (char)0}, .t0 = 0.0, .is_armed_again = 0U, .first = 72U, .count = 1U},
    {.params = {.none = (char)0}, .t0 = 0.0, .is_armed_again = 0U, .first = 73U, .count = 1U},
    {.params = {.none = (char)0}, .t0 = 0.0, .is_armed_again = 0U, .first = 74U, .count = 1U},
    {.params = {.none = (char)0}, .t0 = 0.0, .is_armed_again = 0U, .first = 75U, .count = 1U},
    {.params = {.none = (char)0}, .t0 = 0.0, .is_armed_again = 0U, .first = 76U, .count = 1U},
    {.params = {.none = (char)0}, .t0 = 0.0, .is_armed_again = 0U, .first = 77U, .count = 1U},
    {.params = {.none = (char)0}, .t0 = 0.0, .is_armed_again = 0U, .first = 78U, .count = 1U},
    {.params = {.none = (char)0}, .t0 = 0.0, .is_armed_again = 0U, .first = 79U, .count = 1U},
    {.params = {.none = (char)0}, .t0 = 0.0, .is_armed_again = 0U, .first = 80U, .count = 1U},
    {.params = {.none = (char)0}, .t0 = 0.0, .is_armed_again = 0U, .first = 81U, .count = 1U},
    {.params = {.none = (char)0}, .t0 = 0.0, .is_armed_again = 0U, .first = 82U, .count = 1U},
    {.params = {.none = (char)0}, .t0 = 0.0, .is_armed_again = 0U, .first = 83U, .count = 1U},
    {.params = {.none = (char)0}, .t0 = 0.0, .is_armed_again = 0U, .first = 84U, .count = 1U},
    {.params = {.none = (char)0}, .t0 = 0.0, .is_armed_again = 0U, .first = 85U, .count = 1U},
    {.params = {.none = (char)0}, .t0 = 0.0, .is_armed_again = 0U, .first = 86U, .count = 1U},
    {.params = {.none = (char)0}, .t0 = 0.0, .is_armed_again = 0U, .first = 87U, .count = 1U},
    {.params = {.none = (char)0}, .t0 = 0.0, .is_armed_again = 0U, .first = 88U, .count = 1U},
    {.params = {.none = (char)0}, .t0 = 0.0, .is_armed_again = 0U, .first = 89U, .count = 1U},
    {.params = {.none = (char)0}, .t0 = 0.0, .is_armed_again = 0U, .first = 90U, .count = 1U},
    {.params = {.none = (char)0}, .t0 = 0.0, .is_armed_again = 0U, .first = 91U, .count = 1U},
    {.params = {.none = (char)0}, .t0 = 0.0, .is_armed_again = 0U, .first = 92U, .count = 1U},
    {.params = {.none = (char)0}, .t0 = 0.0, .is_armed_again = 0U, .first = 93U, .count = 1U},
    {.params = {.none = (char)0}, .t0 = 0.0, .is_armed_again = 0U, .first = 94U, .count = 1U},
    {.params = {.none = (char)0}, .t0 = 0.0, .is_armed_again = 0U, .first = 95U, .count = 1U},
};

/* The failures of what was returned for each input, and of the status of all. */
static uint32_t gantry_selftest_differs(const gantry_selftest_call *call, ptc_status status, const double u[3], const ptc_status axes[3])
{
    uint32_t failures = 0U;

    if (status != call->status) {
        failures++;
    }
    for (uint32_t i = 0U; i < 3U; i++) {
        if (!((axes[i] == call->axes[i]) && (fabs(u[i] - call->u[i]) <= call->tolerance[i]))) {
            failures++;
        }
    }
    return failures;
}

/* The failures of one call. */
static uint32_t gantry_selftest_check(const gantry *self, const gantry_selftest_call *call)
{
    double u[3] = {12345.0, 12345.0, 12345.0};
    ptc_status axes[3] = {PTC_E_PARAM, PTC_E_PARAM, PTC_E_PARAM};
    ptc_status status = gantry_step(self, call->t, call->x, u, axes);
    uint32_t failures = gantry_selftest_differs(call, status, u, axes);
    gantry_gains gains;

    /* The same by tick and axis, whatever the other axes do. */
    status = gantry_tick(self, call->t, &gains);
    for (uint32_t i = 0U; i < 3U; i++) {
        double own = 0.0;
        const ptc_status axis = (status < PTC_OK) ? status : gantry_axis(&gains, i, call->x[i], &own);

        if (!((axis == call->axes[i]) && ((call->status < PTC_OK) || (fabs(own - u[i]) <= 0.0)))) {
            failures++;
        }
    }
    return failures;
}

/* Every session with its calls. */
static uint32_t gantry_selftest_run(void)
{
    static const gantry_selftest_call calls[96] = {
        {.t = 0.0, .x = {{0.26785714285714285, -0.44642857142857145}, {0.17857142857142858, 0.5357142857142857}, {0.26785714285714285, -0.44642857142857145}}, .u = {2.3684757858670007e-14, -200.0, -17.14285714285714}, .tolerance = {6.42857142857143e-12, 4.365837492413578e-12, 1.2752350503701434e-12}, .status = PTC_OK, .axes = {PTC_OK, PTC_OK, PTC_OK}},
        {.t = 0.375, .x = {{-0.17952127659574468, 0.2992021276595745}, {-0.1196808510638298, -0.35904255319148937}, {-0.17952127659574468, 0.2992021276595745}}, .u = {85.10638297872339, 200.0, 33.191489361702125}, .tolerance = {7.465705923823408e-12, 4.331642963538199e-12, 1.5009870124187886e-12}, .status = PTC_OK, .axes = {PTC_OK, PTC_OK, PTC_OK}},
        {.t = 0.8999999999999999, .x = {{0.06976744186046513, -0.1162790697674419}, {0.04651162790697676, 0.13953488372093026}, {0.06976744186046513, -0.1162790697674419}}, .u = {-279.0697674418604, -200.0, -69.7674418604651}, .tolerance = {9.829407796723267e-12, 4.253711246566402e-12, 2.015491484064537e-12}, .status = PTC_OK, .axes = {PTC_OK, PTC_OK, PTC_OK}},
        {.t = 1.35, .x = {{-0.0036057692307692266, 0.006009615384615377}, {-0.002403846153846151, -0.007211538461538453}, {-0.0036057692307692266, 0.006009615384615377}}, .u = {346.1538461538462, 113.46153846153845, 75.0}, .tolerance = {7.865323132474052e-12, 2.3376935224818788e-12, 1.6416533453693776e-12}, .status = PTC_OK, .axes = {PTC_OK, PTC_OK, PTC_OK}},
        {.t = 0.6000000000000001, .x = {{0.15187499999999998, 0.0}, {0.0, 0.0}, {0.0, 0.0}}, .u = {-450.00000000000006, 0.0, 0.0}, .tolerance = {9.099920072216267e-12, 0.0, 0.0}, .status = PTC_OK, .axes = {PTC_OK, PTC_OK, PTC_OK}},
        {.t = 0.6000000000000001, .x = {{0.0, 0.42187499999999994}, {0.0, 0.0}, {0.0, 0.0}}, .u = {-450.0, 0.0, 0.0}, .tolerance = {1.0224920072216266e-11, 0.0, 0.0}, .status = PTC_OK, .axes = {PTC_OK, PTC_OK, PTC_OK}},
        {.t = 0.6000000000000001, .x = {{0.0, 0.0}, {0.17999999999999997, 0.0}, {0.0, 0.0}}, .u = {0.0, -200.0, 0.0}, .tolerance = {0.0, 4.044408920985007e-12, 0.0}, .status = PTC_OK, .axes = {PTC_OK, PTC_OK, PTC_OK}},
        {.t = 0.6000000000000001, .x = {{0.0, 0.0}, {0.0, 0.49999999999999994}, {0.0, 0.0}}, .u = {0.0, -200.0, 0.0}, .tolerance = {0.0, 4.544408920985007e-12, 0.0}, .status = PTC_OK, .axes = {PTC_OK, PTC_OK, PTC_OK}},
        {.t = 0.6000000000000001, .x = {{0.0, 0.0}, {0.0, 0.0}, {0.12053571428571425, 0.0}}, .u = {0.0, 0.0, -74.99999999999999}, .tolerance = {0.0, 0.0, 1.5166533453693772e-12}, .status = PTC_OK, .axes = {PTC_OK, PTC_OK, PTC_OK}},
        {.t = 0.6000000000000001, .x = {{0.0, 0.0}, {0.0, 0.0}, {0.0, 0.46874999999999994}}, .u = {0.0, 0.0, -75.0}, .tolerance = {0.0, 0.0, 1.6416533453693776e-12}, .status = PTC_OK, .axes = {PTC_OK, PTC_OK, PTC_OK}},
        {.t = 1.425, .x = {{0.0010546874999999988, 0.0}, {0.0, 0.0}, {0.0, 0.0}}, .u = {-450.0, 0.0, 0.0}, .tolerance = {9.099920072216265e-12, 0.0, 0.0}, .status = PTC_OK, .axes = {PTC_OK, PTC_OK, PTC_OK}},
        {.t = 1.425, .x = {{0.0, 0.03515624999999998}, {0.0, 0.0}, {0.0, 0.0}}, .u = {-450.0, 0.0, 0.0}, .tolerance = {1.0224920072216266e-11, 0.0, 0.0}, .status = PTC_OK, .axes = {PTC_OK, PTC_OK, PTC_OK}},
        {.t = 1.425, .x = {{0.0, 0.0}, {0.0012499999999999985, 0.0}, {0.0, 0.0}}, .u = {0.0, -200.0, 0.0}, .tolerance = {0.0, 4.044408920985007e-12, 0.0}, .status = PTC_OK, .axes = {PTC_OK, PTC_OK, PTC_OK}},
        {.t = 1.425, .x = {{0.0, 0.0}, {0.0, 0.041666666666666644}, {0.0, 0.0}}, .u = {0.0, -200.0, 0.0}, .tolerance = {0.0, 4.544408920985007e-12, 0.0}, .status = PTC_OK, .axes = {PTC_OK, PTC_OK, PTC_OK}},
        {.t = 1.425, .x = {{0.0, 0.0}, {0.0, 0.0}, {0.0008370535714285705, 0.0}}, .u = {0.0, 0.0, -75.0}, .tolerance = {0.0, 0.0, 1.5166533453693776e-12}, .status = PTC_OK, .axes = {PTC_OK, PTC_OK, PTC_OK}},
        {.t = 1.425, .x = {{0.0, 0.0}, {0.0, 0.0}, {0.0, 0.03906249999999998}}, .u = {0.0, 0.0, -75.0}, .tolerance = {0.0, 0.0, 1.6416533453693776e-12}, .status = PTC_OK, .axes = {PTC_OK, PTC_OK, PTC_OK}},
        {.t = 1.05, .x = {{0.0, 0.0}, {0.04499999999999999, 0.0}, {0.0, 0.0}}, .u = {0.0, -200.0, 0.0}, .tolerance = {0.0, 4.044408920985007e-12, 0.0}, .status = PTC_OK, .axes = {PTC_OK, PTC_OK, PTC_OK}},
        {.t = 1.05, .x = {{0.0, 0.0}, {0.0, 0.24999999999999997}, {0.0, 0.0}}, .u = {0.0, -200.0, 0.0}, .tolerance = {0.0, 4.544408920985007e-12, 0.0}, .status = PTC_OK, .axes = {PTC_OK, PTC_OK, PTC_OK}},
        {.t = 1.05, .x = {{0.0, 0.0}, {0.0, 0.0}, {0.03013392857142856, 0.0}}, .u = {0.0, 0.0, -74.99999999999999}, .tolerance = {0.0, 0.0, 1.5166533453693772e-12}, .status = PTC_OK, .axes = {PTC_OK, PTC_OK, PTC_OK}},
        {.t = 1.05, .x = {{0.0, 0.0}, {0.0, 0.0}, {0.0, 0.23437499999999997}}, .u = {0.0, 0.0, -75.0}, .tolerance = {0.0, 0.0, 1.6416533453693776e-12}, .status = PTC_OK, .axes = {PTC_OK, PTC_OK, PTC_OK}},
        {.t = (double)NAN, .x = {{0.09868421052631579, -0.1644736842105263}, {0.06578947368421052, 0.19736842105263158}, {0.09868421052631579, -0.1644736842105263}}, .u = {0.0, 0.0, 0.0}, .tolerance = {0.0, 0.0, 0.0}, .status = PTC_E_INPUT, .axes = {PTC_E_INPUT, PTC_E_INPUT, PTC_E_INPUT}},
        {.t = (double)INFINITY, .x = {{0.09868421052631579, -0.1644736842105263}, {0.06578947368421052, 0.19736842105263158}, {0.09868421052631579, -0.1644736842105263}}, .u = {0.0, 0.0, 0.0}, .tolerance = {0.0, 0.0, 0.0}, .status = PTC_E_INPUT, .axes = {PTC_E_INPUT, PTC_E_INPUT, PTC_E_INPUT}},
        {.t = -(double)INFINITY, .x = {{0.09868421052631579, -0.1644736842105263}, {0.06578947368421052, 0.19736842105263158}, {0.09868421052631579, -0.1644736842105263}}, .u = {0.0, 0.0, 0.0}, .tolerance = {0.0, 0.0, 0.0}, .status = PTC_E_INPUT, .axes = {PTC_E_INPUT, PTC_E_INPUT, PTC_E_INPUT}},
        {.t = 0.75, .x = {{(double)NAN, -0.1644736842105263}, {0.06578947368421052, 0.19736842105263158}, {0.09868421052631579, -0.1644736842105263}}, .u = {0.0, 0.0, 0.0}, .tolerance = {0.0, 0.0, 0.0}, .status = PTC_E_INPUT, .axes = {PTC_E_INPUT, PTC_OK, PTC_OK}},
        {.t = 0.75, .x = {{0.09868421052631579, (double)NAN}, {0.06578947368421052, 0.19736842105263158}, {0.09868421052631579, -0.1644736842105263}}, .u = {0.0, 0.0, 0.0}, .tolerance = {0.0, 0.0, 0.0}, .status = PTC_E_INPUT, .axes = {PTC_E_INPUT, PTC_OK, PTC_OK}},
        {.t = 0.75, .x = {{0.09868421052631579, -0.1644736842105263}, {(double)NAN, 0.19736842105263158}, {0.09868421052631579, -0.1644736842105263}}, .u = {0.0, 0.0, 0.0}, .tolerance = {0.0, 0.0, 0.0}, .status = PTC_E_INPUT, .axes = {PTC_OK, PTC_E_INPUT, PTC_OK}},
        {.t = 0.75, .x = {{0.09868421052631579, -0.1644736842105263}, {0.06578947368421052, (double)NAN}, {0.09868421052631579, -0.1644736842105263}}, .u = {0.0, 0.0, 0.0}, .tolerance = {0.0, 0.0, 0.0}, .status = PTC_E_INPUT, .axes = {PTC_OK, PTC_E_INPUT, PTC_OK}},
        {.t = 0.75, .x = {{0.09868421052631579, -0.1644736842105263}, {0.06578947368421052, 0.19736842105263158}, {(double)NAN, -0.1644736842105263}}, .u = {0.0, 0.0, 0.0}, .tolerance = {0.0, 0.0, 0.0}, .status = PTC_E_INPUT, .axes = {PTC_OK, PTC_OK, PTC_E_INPUT}},
        {.t = 0.75, .x = {{0.09868421052631579, -0.1644736842105263}, {0.06578947368421052, 0.19736842105263158}, {0.09868421052631579, (double)NAN}}, .u = {0.0, 0.0, 0.0}, .tolerance = {0.0, 0.0, 0.0}, .status = PTC_E_INPUT, .axes = {PTC_OK, PTC_OK, PTC_E_INPUT}},
        {.t = 0.75, .x = {{(double)INFINITY, -0.1644736842105263}, {0.06578947368421052, 0.19736842105263158}, {0.09868421052631579, -0.1644736842105263}}, .u = {0.0, 0.0, 0.0}, .tolerance = {0.0, 0.0, 0.0}, .status = PTC_E_INPUT, .axes = {PTC_E_INPUT, PTC_OK, PTC_OK}},
        {.t = 0.75, .x = {{0.09868421052631579, (double)INFINITY}, {0.06578947368421052, 0.19736842105263158}, {0.09868421052631579, -0.1644736842105263}}, .u = {0.0, 0.0, 0.0}, .tolerance = {0.0, 0.0, 0.0}, .status = PTC_E_INPUT, .axes = {PTC_E_INPUT, PTC_OK, PTC_OK}},
        {.t = 0.75, .x = {{0.09868421052631579, -0.1644736842105263}, {(double)INFINITY, 0.19736842105263158}, {0.09868421052631579, -0.1644736842105263}}, .u = {0.0, 0.0, 0.0}, .tolerance = {0.0, 0.0, 0.0}, .status = PTC_E_INPUT, .axes = {PTC_OK, PTC_E_INPUT, PTC_OK}},
        {.t = 0.75, .x = {{0.09868421052631579, -0.1644736842105263}, {0.06578947368421052, (double)INFINITY}, {0.09868421052631579, -0.1644736842105263}}, .u = {0.0, 0.0, 0.0}, .tolerance = {0.0, 0.0, 0.0}, .status = PTC_E_INPUT, .axes = {PTC_OK, PTC_E_INPUT, PTC_OK}},
        {.t = 0.75, .x = {{0.09868421052631579, -0.1644736842105263}, {0.06578947368421052, 0.19736842105263158}, {(double)INFINITY, -0.1644736842105263}}, .u = {0.0, 0.0, 0.0}, .tolerance = {0.0, 0.0, 0.0}, .status = PTC_E_INPUT, .axes = {PTC_OK, PTC_OK, PTC_E_INPUT}},
        {.t = 0.75, .x = {{0.09868421052631579, -0.1644736842105263}, {0.06578947368421052, 0.19736842105263158}, {0.09868421052631579, (double)INFINITY}}, .u = {0.0, 0.0, 0.0}, .tolerance = {0.0, 0.0, 0.0}, .status = PTC_E_INPUT, .axes = {PTC_OK, PTC_OK, PTC_E_INPUT}},
        {.t = 0.75, .x = {{-(double)INFINITY, -0.1644736842105263}, {0.06578947368421052, 0.19736842105263158}, {0.09868421052631579, -0.1644736842105263}}, .u = {0.0, 0.0, 0.0}, .tolerance = {0.0, 0.0, 0.0}, .status = PTC_E_INPUT, .axes = {PTC_E_INPUT, PTC_OK, PTC_OK}},
        {.t = 0.75, .x = {{0.09868421052631579, -(double)INFINITY}, {0.06578947368421052, 0.19736842105263158}, {0.09868421052631579, -0.1644736842105263}}, .u = {0.0, 0.0, 0.0}, .tolerance = {0.0, 0.0, 0.0}, .status = PTC_E_INPUT, .axes = {PTC_E_INPUT, PTC_OK, PTC_OK}},
        {.t = 0.75, .x = {{0.09868421052631579, -0.1644736842105263}, {-(double)INFINITY, 0.19736842105263158}, {0.09868421052631579, -0.1644736842105263}}, .u = {0.0, 0.0, 0.0}, .tolerance = {0.0, 0.0, 0.0}, .status = PTC_E_INPUT, .axes = {PTC_OK, PTC_E_INPUT, PTC_OK}},
        {.t = 0.75, .x = {{0.09868421052631579, -0.1644736842105263}, {0.06578947368421052, -(double)INFINITY}, {0.09868421052631579, -0.1644736842105263}}, .u = {0.0, 0.0, 0.0}, .tolerance = {0.0, 0.0, 0.0}, .status = PTC_E_INPUT, .axes = {PTC_OK, PTC_E_INPUT, PTC_OK}},
        {.t = 0.75, .x = {{0.09868421052631579, -0.1644736842105263}, {0.06578947368421052, 0.19736842105263158}, {-(double)INFINITY, -0.1644736842105263}}, .u = {0.0, 0.0, 0.0}, .tolerance = {0.0, 0.0, 0.0}, .status = PTC_E_INPUT, .axes = {PTC_OK, PTC_OK, PTC_E_INPUT}},
        {.t = 0.75, .x = {{0.09868421052631579, -0.1644736842105263}, {0.06578947368421052, 0.19736842105263158}, {0.09868421052631579, -(double)INFINITY}}, .u = {0.0, 0.0, 0.0}, .tolerance = {0.0, 0.0, 0.0}, .status = PTC_E_INPUT, .axes = {PTC_OK, PTC_OK, PTC_E_INPUT}},
        {.t = -0.75, .x = {{0.09868421052631579, -0.1644736842105263}, {0.06578947368421052, 0.19736842105263158}, {0.09868421052631579, -0.1644736842105263}}, .u = {0.0, 0.0, 0.0}, .tolerance = {0.0, 0.0, 0.0}, .status = PTC_E_INPUT, .axes = {PTC_E_INPUT, PTC_E_INPUT, PTC_E_INPUT}},
        {.t = 1.4682, .x = {{0.00015279590948651052, -0.0002546598491441842}, {0.00010186393965767368, 0.00030559181897302104}, {0.00015279590948651052, -0.0002546598491441842}}, .u = {-354.94633014215265, -94.1180736872643, -75.00000000000001}, .tolerance = {7.350717021794541e-12, 1.9119087092987546e-12, 1.5416388400023922e-12}, .status = PTC_OK, .axes = {PTC_OK, PTC_OK, PTC_OK}},
        {.t = 1.4682, .x = {{-0.00015279590948651052, 0.0002546598491441842}, {-0.00010186393965767368, -0.00030559181897302104}, {-0.00015279590948651052, 0.0002546598491441842}}, .u = {354.94633014215265, 94.1180736872643, 75.00000000000001}, .tolerance = {7.350717021794541e-12, 1.9119087092987546e-12, 1.5416388400023922e-12}, .status = PTC_OK, .axes = {PTC_OK, PTC_OK, PTC_OK}},
        {.t = 1.49205, .x = {{3.790755002159206e-5, -6.317925003598676e-5}, {2.5271700014394706e-5, 7.581510004318412e-5}, {3.790755002159206e-5, -6.317925003598676e-5}}, .u = {-356.0529725061178, -91.68346048654095, -75.0}, .tolerance = {7.285947506878089e-12, 1.8583184482498745e-12, 1.5290507831122882e-12}, .status = PTC_HOLD, .axes = {PTC_HOLD, PTC_HOLD, PTC_HOLD}},
        {.t = 1.49205, .x = {{-3.790755002159206e-5, 6.317925003598676e-5}, {-2.5271700014394706e-5, -7.581510004318412e-5}, {-3.790755002159206e-5, 6.317925003598676e-5}}, .u = {356.0529725061178, 91.68346048654095, 75.0}, .tolerance = {7.285947506878089e-12, 1.8583184482498745e-12, 1.5290507831122882e-12}, .status = PTC_HOLD, .axes = {PTC_HOLD, PTC_HOLD, PTC_HOLD}},
        {.t = 1.5, .x = {{3.790755002159206e-5, -6.317925003598676e-5}, {2.5271700014394706e-5, 7.581510004318412e-5}, {3.790755002159206e-5, -6.317925003598676e-5}}, .u = {-356.0529725061178, -91.68346048654095, -75.0}, .tolerance = {7.285947506878089e-12, 1.8583184482498745e-12, 1.5290507831122882e-12}, .status = PTC_HOLD, .axes = {PTC_HOLD, PTC_HOLD, PTC_HOLD}},
        {.t = 1.5, .x = {{-3.790755002159206e-5, 6.317925003598676e-5}, {-2.5271700014394706e-5, -7.581510004318412e-5}, {-3.790755002159206e-5, 6.317925003598676e-5}}, .u = {356.0529725061178, 91.68346048654095, 75.0}, .tolerance = {7.285947506878089e-12, 1.8583184482498745e-12, 1.5290507831122882e-12}, .status = PTC_HOLD, .axes = {PTC_HOLD, PTC_HOLD, PTC_HOLD}},
        {.t = 1.875, .x = {{3.790755002159206e-5, -6.317925003598676e-5}, {2.5271700014394706e-5, 7.581510004318412e-5}, {3.790755002159206e-5, -6.317925003598676e-5}}, .u = {-356.0529725061178, -91.68346048654095, -75.0}, .tolerance = {7.285947506878089e-12, 1.8583184482498745e-12, 1.5290507831122882e-12}, .status = PTC_HOLD, .axes = {PTC_HOLD, PTC_HOLD, PTC_HOLD}},
        {.t = 1.875, .x = {{-3.790755002159206e-5, 6.317925003598676e-5}, {-2.5271700014394706e-5, -7.581510004318412e-5}, {-3.790755002159206e-5, 6.317925003598676e-5}}, .u = {356.0529725061178, 91.68346048654095, 75.0}, .tolerance = {7.285947506878089e-12, 1.8583184482498745e-12, 1.5290507831122882e-12}, .status = PTC_HOLD, .axes = {PTC_HOLD, PTC_HOLD, PTC_HOLD}},
        {.t = 16.5, .x = {{3.790755002159206e-5, -6.317925003598676e-5}, {2.5271700014394706e-5, 7.581510004318412e-5}, {3.790755002159206e-5, -6.317925003598676e-5}}, .u = {-356.0529725061178, -91.68346048654095, -75.0}, .tolerance = {7.285947506878089e-12, 1.8583184482498745e-12, 1.5290507831122882e-12}, .status = PTC_HOLD, .axes = {PTC_HOLD, PTC_HOLD, PTC_HOLD}},
        {.t = 16.5, .x = {{-3.790755002159206e-5, 6.317925003598676e-5}, {-2.5271700014394706e-5, -7.581510004318412e-5}, {-3.790755002159206e-5, 6.317925003598676e-5}}, .u = {356.0529725061178, 91.68346048654095, 75.0}, .tolerance = {7.285947506878089e-12, 1.8583184482498745e-12, 1.5290507831122882e-12}, .status = PTC_HOLD, .axes = {PTC_HOLD, PTC_HOLD, PTC_HOLD}},
        {.t = 1000.1, .x = {{-0.26785714285714285, 0.44642857142857145}, {-0.17857142857142858, -0.5357142857142857}, {-0.26785714285714285, 0.44642857142857145}}, .u = {-2.3684757858670007e-14, 200.0, 17.14285714285714}, .tolerance = {6.42857142857143e-12, 4.365837492413578e-12, 1.2752350503701434e-12}, .status = PTC_OK, .axes = {PTC_OK, PTC_OK, PTC_OK}},
        {.t = 1001.15, .x = {{-0.03835227272728153, 0.06392045454546923}, {-0.02556818181818769, -0.07670454545456307}, {-0.03835227272728153, 0.06392045454546923}}, .u = {318.1818181818131, 175.00000000001103, 75.0}, .tolerance = {9.502468737930987e-12, 3.692266896771215e-12, 1.9598351635512527e-12}, .status = PTC_OK, .axes = {PTC_OK, PTC_OK, PTC_OK}},
        {.t = 1001.6, .x = {{-3.790755002159206e-5, 6.317925003598676e-5}, {-2.5271700014394706e-5, -7.581510004318412e-5}, {-3.790755002159206e-5, 6.317925003598676e-5}}, .u = {356.0529725061178, 91.68346048654095, 75.0}, .tolerance = {7.285947506878089e-12, 1.8583184482498745e-12, 1.5290507831122882e-12}, .status = PTC_HOLD, .axes = {PTC_HOLD, PTC_HOLD, PTC_HOLD}},
        {.t = 0.0, .x = {{0.75, -1.25}, {0.5, 1.5}, {0.75, -1.25}}, .u = {0.0, 0.0, 0.0}, .tolerance = {0.0, 0.0, 0.0}, .status = PTC_E_INPUT, .axes = {PTC_E_INPUT, PTC_E_INPUT, PTC_E_INPUT}},
        {.t = 0.75, .x = {{0.049342105263157895, -0.08223684210526315}, {0.03289473684210526, 0.09868421052631579}, {0.049342105263157895, -0.08223684210526315}}, .u = {-105.26315789473685, -100.0, -28.42105263157895}, .tolerance = {4.497057326834215e-12, 2.1406255131240825e-12, 9.168370571926065e-13}, .status = PTC_OK, .axes = {PTC_OK, PTC_OK, PTC_OK}},
        {.t = 0.75, .x = {{0.29605263157894735, -0.493421052631579}, {0.19736842105263158, 0.5921052631578947}, {0.29605263157894735, -0.493421052631579}}, .u = {-631.5789473684209, -400.0, -150.0}, .tolerance = {2.6982343961005284e-11, 0.0, 0.0}, .status = PTC_SATURATED, .axes = {PTC_OK, PTC_SATURATED, PTC_SATURATED}},
        {.t = 0.75, .x = {{-0.29605263157894735, 0.493421052631579}, {-0.19736842105263158, -0.5921052631578947}, {-0.29605263157894735, 0.493421052631579}}, .u = {631.5789473684209, 400.0, 150.0}, .tolerance = {2.6982343961005284e-11, 0.0, 0.0}, .status = PTC_SATURATED, .axes = {PTC_OK, PTC_SATURATED, PTC_SATURATED}},
        {.t = 0.75, .x = {{0.7894736842105263, -1.3157894736842104}, {0.5263157894736842, 1.5789473684210527}, {0.7894736842105263, -1.3157894736842104}}, .u = {-900.0, -400.0, -150.0}, .tolerance = {0.0, 0.0, 0.0}, .status = PTC_SATURATED, .axes = {PTC_SATURATED, PTC_SATURATED, PTC_SATURATED}},
        {.t = 0.75, .x = {{-0.7894736842105263, 1.3157894736842104}, {-0.5263157894736842, -1.5789473684210527}, {-0.7894736842105263, 1.3157894736842104}}, .u = {900.0, 400.0, 150.0}, .tolerance = {0.0, 0.0, 0.0}, .status = PTC_SATURATED, .axes = {PTC_SATURATED, PTC_SATURATED, PTC_SATURATED}},
        {.t = 1.5, .x = {{1.895377501079603e-5, -3.158962501799338e-5}, {1.2635850007197353e-5, 3.790755002159206e-5}, {1.895377501079603e-5, -3.158962501799338e-5}}, .u = {-178.0264862530589, -45.841730243270476, -37.5}, .tolerance = {3.6429737534390445e-12, 9.291592241249372e-13, 7.645253915561441e-13}, .status = PTC_HOLD, .axes = {PTC_HOLD, PTC_HOLD, PTC_HOLD}},
        {.t = 1.5, .x = {{0.00011372265006477619, -0.00018953775010796032}, {7.581510004318412e-5, 0.00022744530012955237}, {0.00011372265006477619, -0.00018953775010796032}}, .u = {-900.0, -275.0503814596229, -150.0}, .tolerance = {0.0, 5.574955344749624e-12, 0.0}, .status = PTC_SATURATED, .axes = {PTC_SATURATED, PTC_HOLD, PTC_SATURATED}},
        {.t = 1.5, .x = {{-0.00011372265006477619, 0.00018953775010796032}, {-7.581510004318412e-5, -0.00022744530012955237}, {-0.00011372265006477619, 0.00018953775010796032}}, .u = {900.0, 275.0503814596229, 150.0}, .tolerance = {0.0, 5.574955344749624e-12, 0.0}, .status = PTC_SATURATED, .axes = {PTC_SATURATED, PTC_HOLD, PTC_SATURATED}},
        {.t = 1.5, .x = {{0.0003032604001727365, -0.0005054340002878941}, {0.00020217360011515764, 0.000606520800345473}, {0.0003032604001727365, -0.0005054340002878941}}, .u = {-900.0, -400.0, -150.0}, .tolerance = {0.0, 0.0, 0.0}, .status = PTC_SATURATED, .axes = {PTC_SATURATED, PTC_SATURATED, PTC_SATURATED}},
        {.t = 1.5, .x = {{-0.0003032604001727365, 0.0005054340002878941}, {-0.00020217360011515764, -0.000606520800345473}, {-0.0003032604001727365, 0.0005054340002878941}}, .u = {900.0, 400.0, 150.0}, .tolerance = {0.0, 0.0, 0.0}, .status = PTC_SATURATED, .axes = {PTC_SATURATED, PTC_SATURATED, PTC_SATURATED}},
        {.t = 2.25, .x = {{1.895377501079603e-5, -3.158962501799338e-5}, {1.2635850007197353e-5, 3.790755002159206e-5}, {1.895377501079603e-5, -3.158962501799338e-5}}, .u = {-178.0264862530589, -45.841730243270476, -37.5}, .tolerance = {3.6429737534390445e-12, 9.291592241249372e-13, 7.645253915561441e-13}, .status = PTC_HOLD, .axes = {PTC_HOLD, PTC_HOLD, PTC_HOLD}},
        {.t = 2.25, .x = {{0.00011372265006477619, -0.00018953775010796032}, {7.581510004318412e-5, 0.00022744530012955237}, {0.00011372265006477619, -0.00018953775010796032}}, .u = {-900.0, -275.0503814596229, -150.0}, .tolerance = {0.0, 5.574955344749624e-12, 0.0}, .status = PTC_SATURATED, .axes = {PTC_SATURATED, PTC_HOLD, PTC_SATURATED}},
        {.t = 2.25, .x = {{-0.00011372265006477619, 0.00018953775010796032}, {-7.581510004318412e-5, -0.00022744530012955237}, {-0.00011372265006477619, 0.00018953775010796032}}, .u = {900.0, 275.0503814596229, 150.0}, .tolerance = {0.0, 5.574955344749624e-12, 0.0}, .status = PTC_SATURATED, .axes = {PTC_SATURATED, PTC_HOLD, PTC_SATURATED}},
        {.t = 2.25, .x = {{0.0003032604001727365, -0.0005054340002878941}, {0.00020217360011515764, 0.000606520800345473}, {0.0003032604001727365, -0.0005054340002878941}}, .u = {-900.0, -400.0, -150.0}, .tolerance = {0.0, 0.0, 0.0}, .status = PTC_SATURATED, .axes = {PTC_SATURATED, PTC_SATURATED, PTC_SATURATED}},
        {.t = 2.25, .x = {{-0.0003032604001727365, 0.0005054340002878941}, {-0.00020217360011515764, -0.000606520800345473}, {-0.0003032604001727365, 0.0005054340002878941}}, .u = {900.0, 400.0, 150.0}, .tolerance = {0.0, 0.0, 0.0}, .status = PTC_SATURATED, .axes = {PTC_SATURATED, PTC_SATURATED, PTC_SATURATED}},
        {.t = 1.47, .x = {{-1.0, 1.0}, {-1.0, -1.7976931348623157e308}, {1.3482698511467367e308, -1.0}}, .u = {0.0, 0.0, 0.0}, .tolerance = {0.0, 0.0, 0.0}, .status = PTC_E_RANGE, .axes = {PTC_SATURATED, PTC_E_RANGE, PTC_E_RANGE}},
        {.t = 0.75, .x = {{-1.7976931348623157e308, -1.0}, {1.3482698511467367e308, 1.3482698511467367e308}, {1.0, 1.3482698511467367e308}}, .u = {0.0, 0.0, 0.0}, .tolerance = {0.0, 0.0, 0.0}, .status = PTC_E_RANGE, .axes = {PTC_E_RANGE, PTC_E_RANGE, PTC_E_RANGE}},
        {.t = 1.47, .x = {{1.3482698511467367e308, -1.7976931348623157e308}, {0.0, -1.0}, {1.0, 1.0}}, .u = {0.0, 0.0, 0.0}, .tolerance = {0.0, 0.0, 0.0}, .status = PTC_E_RANGE, .axes = {PTC_E_RANGE, PTC_SATURATED, PTC_SATURATED}},
        {.t = 1.5, .x = {{1.7976931348623157e308, 1.0}, {1.0, -1.7976931348623157e308}, {1.0, -1.0}}, .u = {0.0, 0.0, 0.0}, .tolerance = {0.0, 0.0, 0.0}, .status = PTC_E_RANGE, .axes = {PTC_E_RANGE, PTC_E_RANGE, PTC_SATURATED}},
        {.t = 1.5, .x = {{1.7976931348623157e308, 1.0}, {0.0, -1.0}, {-1.7976931348623157e308, 1.3482698511467367e308}}, .u = {0.0, 0.0, 0.0}, .tolerance = {0.0, 0.0, 0.0}, .status = PTC_E_RANGE, .axes = {PTC_E_RANGE, PTC_SATURATED, PTC_E_RANGE}},
        {.t = 1.47, .x = {{-1.0, 1.0}, {0.0, -1.0}, {1.7976931348623157e308, 0.0}}, .u = {0.0, 0.0, 0.0}, .tolerance = {0.0, 0.0, 0.0}, .status = PTC_E_RANGE, .axes = {PTC_SATURATED, PTC_SATURATED, PTC_E_RANGE}},
        {.t = 1.47, .x = {{1.7976931348623157e308, -1.0}, {-1.7976931348623157e308, 1.7976931348623157e308}, {0.0, 0.0}}, .u = {0.0, 0.0, 0.0}, .tolerance = {0.0, 0.0, 0.0}, .status = PTC_E_RANGE, .axes = {PTC_E_RANGE, PTC_E_RANGE, PTC_OK}},
        {.t = 0.75, .x = {{1.7976931348623157e308, -1.0}, {-1.0, 0.0}, {0.0, 0.0}}, .u = {0.0, 0.0, 0.0}, .tolerance = {0.0, 0.0, 0.0}, .status = PTC_E_RANGE, .axes = {PTC_E_RANGE, PTC_SATURATED, PTC_OK}},
        {.t = 1.5, .x = {{-1.7976931348623157e308, 1.0}, {0.0, -1.7976931348623157e308}, {0.0, 0.0}}, .u = {0.0, 0.0, 0.0}, .tolerance = {0.0, 0.0, 0.0}, .status = PTC_E_RANGE, .axes = {PTC_E_RANGE, PTC_E_RANGE, PTC_HOLD}},
        {.t = 1.5, .x = {{0.0, 0.0}, {1.7976931348623157e308, 1.7976931348623157e308}, {-1.0, 0.0}}, .u = {0.0, 0.0, 0.0}, .tolerance = {0.0, 0.0, 0.0}, .status = PTC_E_RANGE, .axes = {PTC_HOLD, PTC_E_RANGE, PTC_SATURATED}},
        {.t = 1.5, .x = {{1.3482698511467367e308, -1.0}, {0.0, 0.0}, {-1.7976931348623157e308, -1.0}}, .u = {0.0, 0.0, 0.0}, .tolerance = {0.0, 0.0, 0.0}, .status = PTC_E_RANGE, .axes = {PTC_E_RANGE, PTC_HOLD, PTC_E_RANGE}},
        {.t = 1.5, .x = {{-1.0, 1.0}, {1.7976931348623157e308, 1.0}, {0.0, 0.0}}, .u = {0.0, 0.0, 0.0}, .tolerance = {0.0, 0.0, 0.0}, .status = PTC_E_RANGE, .axes = {PTC_SATURATED, PTC_E_RANGE, PTC_HOLD}},
        {.t = 0.75, .x = {{1.0, 0.0}, {0.0, 0.0}, {-1.7976931348623157e308, -1.0}}, .u = {0.0, 0.0, 0.0}, .tolerance = {0.0, 0.0, 0.0}, .status = PTC_E_RANGE, .axes = {PTC_SATURATED, PTC_OK, PTC_E_RANGE}},
        {.t = 0.75, .x = {{-1.0, 0.0}, {1.3482698511467367e308, 1.7976931348623157e308}, {1.0, -1.0}}, .u = {0.0, 0.0, 0.0}, .tolerance = {0.0, 0.0, 0.0}, .status = PTC_E_RANGE, .axes = {PTC_SATURATED, PTC_E_RANGE, PTC_SATURATED}},
        {.t = 0.75, .x = {{-1.0, 1.0}, {0.0, 1.7976931348623157e308}, {0.0, 0.0}}, .u = {0.0, 0.0, 0.0}, .tolerance = {0.0, 0.0, 0.0}, .status = PTC_E_RANGE, .axes = {PTC_SATURATED, PTC_E_RANGE, PTC_OK}},
        {.t = 1.5, .x = {{0.0, 0.0}, {1.7976931348623157e308, 1.7976931348623157e308}, {1.7976931348623157e308, 1.0}}, .u = {0.0, 0.0, 0.0}, .tolerance = {0.0, 0.0, 0.0}, .status = PTC_E_RANGE, .axes = {PTC_HOLD, PTC_E_RANGE, PTC_E_RANGE}},
        {.t = 1.47, .x = {{0.0, 0.0}, {-1.7976931348623157e308, 1.3482698511467367e308}, {0.0, -1.0}}, .u = {0.0, 0.0, 0.0}, .tolerance = {0.0, 0.0, 0.0}, .status = PTC_E_RANGE, .axes = {PTC_OK, PTC_E_RANGE, PTC_SATURATED}},
        {.t = 1.5, .x = {{1.0, -1.0}, {0.0, 0.0}, {-1.7976931348623157e308, 1.3482698511467367e308}}, .u = {0.0, 0.0, 0.0}, .tolerance = {0.0, 0.0, 0.0}, .status = PTC_E_RANGE, .axes = {PTC_SATURATED, PTC_HOLD, PTC_E_RANGE}},
        {.t = 1.5, .x = {{1.7976931348623157e308, 1.3482698511467367e308}, {1.0, 1.0}, {0.0, 0.0}}, .u = {0.0, 0.0, 0.0}, .tolerance = {0.0, 0.0, 0.0}, .status = PTC_E_RANGE, .axes = {PTC_E_RANGE, PTC_SATURATED, PTC_HOLD}},
        {.t = 1.5, .x = {{0.0, -1.7976931348623157e308}, {0.0, 0.0}, {-1.0, 0.0}}, .u = {0.0, 0.0, 0.0}, .tolerance = {0.0, 0.0, 0.0}, .status = PTC_E_RANGE, .axes = {PTC_E_RANGE, PTC_HOLD, PTC_SATURATED}},
        {.t = 1.47, .x = {{0.0, 0.0}, {1.3482698511467367e308, 1.0}, {1.7976931348623157e308, 1.0}}, .u = {0.0, 0.0, 0.0}, .tolerance = {0.0, 0.0, 0.0}, .status = PTC_E_RANGE, .axes = {PTC_OK, PTC_E_RANGE, PTC_E_RANGE}},
        {.t = 1.47, .x = {{0.0, 0.0}, {0.0, -1.0}, {-1.7976931348623157e308, 1.3482698511467367e308}}, .u = {0.0, 0.0, 0.0}, .tolerance = {0.0, 0.0, 0.0}, .status = PTC_E_RANGE, .axes = {PTC_OK, PTC_SATURATED, PTC_E_RANGE}},
        {.t = 1.47, .x = {{1.7976931348623157e308, 1.3482698511467367e308}, {0.0, 0.0}, {1.0, 1.0}}, .u = {0.0, 0.0, 0.0}, .tolerance = {0.0, 0.0, 0.0}, .status = PTC_E_RANGE, .axes = {PTC_E_RANGE, PTC_OK, PTC_SATURATED}},
        {.t = 1.47, .x = {{-1.0, 1.7976931348623157e308}, {0.0, 0.0}, {0.0, 0.0}}, .u = {0.0, 0.0, 0.0}, .tolerance = {0.0, 0.0, 0.0}, .status = PTC_E_RANGE, .axes = {PTC_E_RANGE, PTC_OK, PTC_OK}},
        {.t = 0.75, .x = {{1.0, 1.7976931348623157e308}, {0.0, 0.0}, {-1.0, 1.3482698511467367e308}}, .u = {0.0, 0.0, 0.0}, .tolerance = {0.0, 0.0, 0.0}, .status = PTC_E_RANGE, .axes = {PTC_E_RANGE, PTC_OK, PTC_E_RANGE}},
    };
    uint32_t failures = 0U;

    for (uint32_t i = 0U; i < 29U; i++) {
        const gantry_selftest_session *session = &gantry_selftest_sessions[i];
        gantry self;
        ptc_status status = gantry_init(&self, &session->params);

        if ((status == PTC_OK) && (session->is_armed_again != 0U)) {
            status = gantry_arm(&self, session->t0);
        }
        if (status == PTC_OK) {
            for (uint32_t j = 0U; j < session->count; j++) {
                failures += gantry_selftest_check(&self, &calls[session->first + j]);
            }
        } else {
            failures++;
        }
    }
    return failures;
}

/* What init and arm must refuse without a change. */
static uint32_t gantry_selftest_refuse(void)
{
    static const double starts[3] = {(double)NAN, (double)INFINITY, -(double)INFINITY};
    const gantry_selftest_session *session = &gantry_selftest_sessions[0];
    const gantry_selftest_call call = {.t = 0.0, .x = {{0.26785714285714285, -0.44642857142857145}, {0.17857142857142858, 0.5357142857142857}, {0.26785714285714285, -0.44642857142857145}}, .u = {2.3684757858670007e-14, -200.0, -17.14285714285714}, .tolerance = {6.42857142857143e-12, 4.365837492413578e-12, 1.2752350503701434e-12}, .status = PTC_OK, .axes = {PTC_OK, PTC_OK, PTC_OK}};
    uint32_t failures = 0U;
    gantry_gains gains;
    double own = 12345.0;
    gantry self;

    if (gantry_init(&self, &session->params) != PTC_OK) {
        failures++;
    }
    for (uint32_t i = 0U; i < 3U; i++) {
        if (gantry_arm(&self, starts[i]) != PTC_E_PARAM) {
            failures++;
        }
    }
    failures += gantry_selftest_check(&self, &call);
    if (gantry_tick(&self, call.t, &gains) < PTC_OK) {
        failures++;
    }
    /* An axis that is none. */
    if (gantry_axis(&gains, 3U, call.x[0], &own) != PTC_E_INPUT) {
        failures++;
    }
    if (!(fabs(own) <= 0.0)) {
        failures++;
    }
    if (gantry_init(NULL, &session->params) != PTC_E_PARAM) {
        failures++;
    }
    if (gantry_arm(NULL, session->t0) != PTC_E_PARAM) {
        failures++;
    }
    return failures;
}

/* 1 where a call without one of its pointers was not refused with u = 0; u is lost for the next one. */
static uint32_t gantry_selftest_refused(ptc_status status, double u[3])
{
    uint32_t failures = 0U;

    if (status != PTC_E_INPUT) {
        failures = 1U;
    }
    for (uint32_t i = 0U; i < 3U; i++) {
        if (!(fabs(u[i]) <= 0.0)) {
            failures = 1U;
        }
        u[i] = 12345.0;
    }
    return failures;
}

/* Calls that lack a pointer. */
static uint32_t gantry_selftest_pointers(void)
{
    const gantry_selftest_session *session = &gantry_selftest_sessions[0];
    const gantry_selftest_call call = {.t = 0.0, .x = {{0.26785714285714285, -0.44642857142857145}, {0.17857142857142858, 0.5357142857142857}, {0.26785714285714285, -0.44642857142857145}}, .u = {2.3684757858670007e-14, -200.0, -17.14285714285714}, .tolerance = {6.42857142857143e-12, 4.365837492413578e-12, 1.2752350503701434e-12}, .status = PTC_OK, .axes = {PTC_OK, PTC_OK, PTC_OK}};
    uint32_t failures = 0U;
    double u[3] = {12345.0, 12345.0, 12345.0};
    ptc_status axes[3];
    ptc_status status;
    gantry_gains gains;
    double own = 12345.0;
    gantry self;

    if (gantry_init(&self, &session->params) != PTC_OK) {
        failures++;
    }
    status = gantry_step(NULL, call.t, call.x, u, axes);
    failures += gantry_selftest_refused(status, u);
    status = gantry_step(&self, call.t, NULL, u, axes);
    failures += gantry_selftest_refused(status, u);
    status = gantry_step(&self, call.t, call.x, u, NULL);
    failures += gantry_selftest_refused(status, u);
    status = gantry_step(&self, call.t, call.x, NULL, axes);
    if (status != PTC_E_INPUT) {
        failures++;
    }
    if (gantry_tick(NULL, call.t, &gains) != PTC_E_INPUT) {
        failures++;
    }
    if (gantry_tick(&self, call.t, NULL) != PTC_E_INPUT) {
        failures++;
    }
    if (gantry_tick(&self, call.t, &gains) < PTC_OK) {
        failures++;
    }
    status = gantry_axis(NULL, 0U, call.x[0], &own);
    if (!((status == PTC_E_INPUT) && (fabs(own) <= 0.0))) {
        failures++;
    }
    own = 12345.0;
    status = gantry_axis(&gains, 0U, NULL, &own);
    if (!((status == PTC_E_INPUT) && (fabs(own) <= 0.0))) {
        failures++;
    }
    status = gantry_axis(&gains, 0U, call.x[0], NULL);
    if (!((status == PTC_E_INPUT))) {
        failures++;
    }
    return failures;
}

uint32_t gantry_selftest(void)
{
    uint32_t failures = gantry_selftest_run();

    failures += gantry_selftest_refuse();
    failures += gantry_selftest_pointers();
    return failures;
}
