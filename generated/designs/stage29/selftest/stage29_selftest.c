/* Self-test of the prescribed-time controller stage29: see stage29_selftest.h. DO NOT EDIT. */
#include "stage29_selftest.h"
#include "stage29.h"

#include <math.h>
#include <stddef.h>

/* A call, and what it must give. */
typedef struct stage29_selftest_call {
    uint32_t is_armed; /* arm is called before it */
    uint32_t start;
    uint32_t k;
    double y[3][2]; /* what is measured */
    ptc_status status;
    double u[3];
    ptc_status axes[3];
} stage29_selftest_call;

/* A set of parameters that init takes, and the calls with it, one after the other. */
typedef struct stage29_selftest_session {
    stage29_params params;
    uint32_t first; /* of its calls */
    uint32_t count;
} stage29_selftest_session;

static const stage29_selftest_session stage29_selftest_sessions[3] = {
    {.params = {.none = (char)0}, .first = 0U, .count = 72U},
    {.params = {.none = (char)0}, .first = 72U, .count = 3U},
    {.params = {.none = (char)0}, .first = 75U, .count = 2U},
};

static const stage29_selftest_call stage29_selftest_calls[77] = {
    {.is_armed = 0U, .start = 0U, .k = 0U, .y = {{0.75, 0.25}, {-0.25, -0.75}, {-1.25, -1.75}}, .status = PTC_SATURATED, .u = {-1.0, 2.0, -3.0}, .axes = {PTC_SATURATED, PTC_SATURATED, PTC_SATURATED}},
    {.is_armed = 0U, .start = 0U, .k = 1U, .y = {{0.7008333333333333, 0.2336111111111111}, {-0.2336111111111111, -0.7008333333333333}, {-1.1680555555555556, -1.6352777777777776}}, .status = PTC_SATURATED, .u = {-1.0, 2.0, -3.0}, .axes = {PTC_SATURATED, PTC_SATURATED, PTC_SATURATED}},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {{0.6533333333333333, 0.2177777777777778}, {-0.2177777777777778, -0.6533333333333333}, {-1.088888888888889, -1.5244444444444445}}, .status = PTC_SATURATED, .u = {-1.0, 2.0, -3.0}, .axes = {PTC_SATURATED, PTC_SATURATED, PTC_SATURATED}},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {{(double)NAN, 0.5}, {0.5, 0.5}, {0.5, 0.5}}, .status = PTC_E_INPUT, .u = {0.0, 0.0, 0.0}, .axes = {PTC_E_INPUT, PTC_E_INPUT, PTC_E_INPUT}},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {{0.5, (double)NAN}, {0.5, 0.5}, {0.5, 0.5}}, .status = PTC_E_INPUT, .u = {0.0, 0.0, 0.0}, .axes = {PTC_E_INPUT, PTC_E_INPUT, PTC_E_INPUT}},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {{0.5, 0.5}, {(double)NAN, 0.5}, {0.5, 0.5}}, .status = PTC_E_INPUT, .u = {0.0, 0.0, 0.0}, .axes = {PTC_E_INPUT, PTC_E_INPUT, PTC_E_INPUT}},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {{0.5, 0.5}, {0.5, (double)NAN}, {0.5, 0.5}}, .status = PTC_E_INPUT, .u = {0.0, 0.0, 0.0}, .axes = {PTC_E_INPUT, PTC_E_INPUT, PTC_E_INPUT}},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {{0.5, 0.5}, {0.5, 0.5}, {(double)NAN, 0.5}}, .status = PTC_E_INPUT, .u = {0.0, 0.0, 0.0}, .axes = {PTC_E_INPUT, PTC_E_INPUT, PTC_E_INPUT}},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {{0.5, 0.5}, {0.5, 0.5}, {0.5, (double)NAN}}, .status = PTC_E_INPUT, .u = {0.0, 0.0, 0.0}, .axes = {PTC_E_INPUT, PTC_E_INPUT, PTC_E_INPUT}},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {{(double)INFINITY, 0.5}, {0.5, 0.5}, {0.5, 0.5}}, .status = PTC_E_INPUT, .u = {0.0, 0.0, 0.0}, .axes = {PTC_E_INPUT, PTC_E_INPUT, PTC_E_INPUT}},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {{0.5, (double)INFINITY}, {0.5, 0.5}, {0.5, 0.5}}, .status = PTC_E_INPUT, .u = {0.0, 0.0, 0.0}, .axes = {PTC_E_INPUT, PTC_E_INPUT, PTC_E_INPUT}},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {{0.5, 0.5}, {(double)INFINITY, 0.5}, {0.5, 0.5}}, .status = PTC_E_INPUT, .u = {0.0, 0.0, 0.0}, .axes = {PTC_E_INPUT, PTC_E_INPUT, PTC_E_INPUT}},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {{0.5, 0.5}, {0.5, (double)INFINITY}, {0.5, 0.5}}, .status = PTC_E_INPUT, .u = {0.0, 0.0, 0.0}, .axes = {PTC_E_INPUT, PTC_E_INPUT, PTC_E_INPUT}},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {{0.5, 0.5}, {0.5, 0.5}, {(double)INFINITY, 0.5}}, .status = PTC_E_INPUT, .u = {0.0, 0.0, 0.0}, .axes = {PTC_E_INPUT, PTC_E_INPUT, PTC_E_INPUT}},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {{0.5, 0.5}, {0.5, 0.5}, {0.5, (double)INFINITY}}, .status = PTC_E_INPUT, .u = {0.0, 0.0, 0.0}, .axes = {PTC_E_INPUT, PTC_E_INPUT, PTC_E_INPUT}},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {{-(double)INFINITY, 0.5}, {0.5, 0.5}, {0.5, 0.5}}, .status = PTC_E_INPUT, .u = {0.0, 0.0, 0.0}, .axes = {PTC_E_INPUT, PTC_E_INPUT, PTC_E_INPUT}},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {{0.5, -(double)INFINITY}, {0.5, 0.5}, {0.5, 0.5}}, .status = PTC_E_INPUT, .u = {0.0, 0.0, 0.0}, .axes = {PTC_E_INPUT, PTC_E_INPUT, PTC_E_INPUT}},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {{0.5, 0.5}, {-(double)INFINITY, 0.5}, {0.5, 0.5}}, .status = PTC_E_INPUT, .u = {0.0, 0.0, 0.0}, .axes = {PTC_E_INPUT, PTC_E_INPUT, PTC_E_INPUT}},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {{0.5, 0.5}, {0.5, -(double)INFINITY}, {0.5, 0.5}}, .status = PTC_E_INPUT, .u = {0.0, 0.0, 0.0}, .axes = {PTC_E_INPUT, PTC_E_INPUT, PTC_E_INPUT}},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {{0.5, 0.5}, {0.5, 0.5}, {-(double)INFINITY, 0.5}}, .status = PTC_E_INPUT, .u = {0.0, 0.0, 0.0}, .axes = {PTC_E_INPUT, PTC_E_INPUT, PTC_E_INPUT}},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {{0.5, 0.5}, {0.5, 0.5}, {0.5, -(double)INFINITY}}, .status = PTC_E_INPUT, .u = {0.0, 0.0, 0.0}, .axes = {PTC_E_INPUT, PTC_E_INPUT, PTC_E_INPUT}},
    {.is_armed = 0U, .start = 0U, .k = 3U, .y = {{0.6075, 0.2025}, {-0.2025, -0.6075}, {-1.0125000000000002, -1.4175}}, .status = PTC_SATURATED, .u = {-1.0, 2.0, -3.0}, .axes = {PTC_SATURATED, PTC_SATURATED, PTC_SATURATED}},
    {.is_armed = 0U, .start = 0U, .k = 7U, .y = {{0.4408333333333334, 0.14694444444444446}, {-0.14694444444444446, -0.4408333333333334}, {-0.7347222222222223, -1.0286111111111111}}, .status = PTC_SATURATED, .u = {-1.0, 2.0, -3.0}, .axes = {PTC_SATURATED, PTC_SATURATED, PTC_SATURATED}},
    {.is_armed = 0U, .start = 0U, .k = 11U, .y = {{0.3008333333333333, 0.10027777777777777}, {-0.10027777777777777, -0.3008333333333333}, {-0.5013888888888889, -0.7019444444444444}}, .status = PTC_SATURATED, .u = {-1.0, 2.0, -3.0}, .axes = {PTC_SATURATED, PTC_SATURATED, PTC_SATURATED}},
    {.is_armed = 0U, .start = 0U, .k = 13U, .y = {{0.2408333333333333, 0.08027777777777777}, {-0.08027777777777777, -0.2408333333333333}, {-0.40138888888888885, -0.5619444444444444}}, .status = PTC_SATURATED, .u = {-1.0, 2.0, -3.0}, .axes = {PTC_SATURATED, PTC_SATURATED, PTC_SATURATED}},
    {.is_armed = 0U, .start = 0U, .k = 14U, .y = {{0.21333333333333332, 0.07111111111111111}, {-0.07111111111111111, -0.21333333333333332}, {-0.35555555555555557, -0.49777777777777776}}, .status = PTC_SATURATED, .u = {-1.0, 2.0, -3.0}, .axes = {PTC_SATURATED, PTC_SATURATED, PTC_SATURATED}},
    {.is_armed = 0U, .start = 0U, .k = 15U, .y = {{0.1875, 0.0625}, {-0.0625, -0.1875}, {-0.3125, -0.4375}}, .status = PTC_SATURATED, .u = {-1.0, 2.0, -3.0}, .axes = {PTC_SATURATED, PTC_SATURATED, PTC_SATURATED}},
    {.is_armed = 0U, .start = 0U, .k = 16U, .y = {{0.16333333333333333, 0.05444444444444445}, {-0.05444444444444445, -0.16333333333333333}, {-0.27222222222222225, -0.3811111111111111}}, .status = PTC_SATURATED, .u = {-1.0, 2.0, -3.0}, .axes = {PTC_SATURATED, PTC_SATURATED, PTC_SATURATED}},
    {.is_armed = 0U, .start = 0U, .k = 22U, .y = {{0.05333333333333333, 0.017777777777777778}, {-0.017777777777777778, -0.05333333333333333}, {-0.08888888888888889, -0.12444444444444444}}, .status = PTC_SATURATED, .u = {-1.0, 2.0, -3.0}, .axes = {PTC_SATURATED, PTC_SATURATED, PTC_SATURATED}},
    {.is_armed = 0U, .start = 0U, .k = 26U, .y = {{0.013333333333333332, 0.0044444444444444444}, {-0.0044444444444444444, -0.013333333333333332}, {-0.022222222222222223, -0.03111111111111111}}, .status = PTC_SATURATED, .u = {-1.0, 2.0, -3.0}, .axes = {PTC_SATURATED, PTC_SATURATED, PTC_SATURATED}},
    {.is_armed = 0U, .start = 0U, .k = 28U, .y = {{0.003333333333333333, 0.0011111111111111111}, {-0.0011111111111111111, -0.003333333333333333}, {-0.005555555555555556, -0.0077777777777777776}}, .status = PTC_SATURATED, .u = {-1.0, 2.0, -3.0}, .axes = {PTC_SATURATED, PTC_SATURATED, PTC_SATURATED}},
    {.is_armed = 0U, .start = 0U, .k = 29U, .y = {{0.0008333333333333333, 0.0002777777777777778}, {-0.0002777777777777778, -0.0008333333333333333}, {-0.001388888888888889, -0.0019444444444444444}}, .status = PTC_SATURATED, .u = {-1.0, 1.451388888888889, -3.0}, .axes = {PTC_SATURATED, PTC_OK, PTC_SATURATED}},
    {.is_armed = 0U, .start = 0U, .k = 30U, .y = {{0.0, 0.0}, {-0.0, -0.0}, {-0.0, -0.0}}, .status = PTC_HOLD, .u = {0.0, 0.0, 0.0}, .axes = {PTC_HOLD, PTC_HOLD, PTC_HOLD}},
    {.is_armed = 0U, .start = 0U, .k = 31U, .y = {{0.0, 0.0}, {-0.0, -0.0}, {-0.0, -0.0}}, .status = PTC_HOLD, .u = {0.0, 0.0, 0.0}, .axes = {PTC_HOLD, PTC_HOLD, PTC_HOLD}},
    {.is_armed = 0U, .start = 0U, .k = 2147483647U, .y = {{0.0, 0.0}, {-0.0, -0.0}, {-0.0, -0.0}}, .status = PTC_HOLD, .u = {0.0, 0.0, 0.0}, .axes = {PTC_HOLD, PTC_HOLD, PTC_HOLD}},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {{0.0, 0.0}, {-0.0, -0.0}, {-0.0, -0.0}}, .status = PTC_HOLD, .u = {0.0, 0.0, 0.0}, .axes = {PTC_HOLD, PTC_HOLD, PTC_HOLD}},
    {.is_armed = 1U, .start = 4294967293U, .k = 4294967293U, .y = {{0.75, 0.25}, {-0.25, -0.75}, {-1.25, -1.75}}, .status = PTC_SATURATED, .u = {-1.0, 2.0, -3.0}, .axes = {PTC_SATURATED, PTC_SATURATED, PTC_SATURATED}},
    {.is_armed = 0U, .start = 0U, .k = 4294967294U, .y = {{0.7008333333333333, 0.2336111111111111}, {-0.2336111111111111, -0.7008333333333333}, {-1.1680555555555556, -1.6352777777777776}}, .status = PTC_SATURATED, .u = {-1.0, 2.0, -3.0}, .axes = {PTC_SATURATED, PTC_SATURATED, PTC_SATURATED}},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {{0.6533333333333333, 0.2177777777777778}, {-0.2177777777777778, -0.6533333333333333}, {-1.088888888888889, -1.5244444444444445}}, .status = PTC_SATURATED, .u = {-1.0, 2.0, -3.0}, .axes = {PTC_SATURATED, PTC_SATURATED, PTC_SATURATED}},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {{(double)NAN, 0.5}, {0.5, 0.5}, {0.5, 0.5}}, .status = PTC_E_INPUT, .u = {0.0, 0.0, 0.0}, .axes = {PTC_E_INPUT, PTC_E_INPUT, PTC_E_INPUT}},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {{0.5, (double)NAN}, {0.5, 0.5}, {0.5, 0.5}}, .status = PTC_E_INPUT, .u = {0.0, 0.0, 0.0}, .axes = {PTC_E_INPUT, PTC_E_INPUT, PTC_E_INPUT}},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {{0.5, 0.5}, {(double)NAN, 0.5}, {0.5, 0.5}}, .status = PTC_E_INPUT, .u = {0.0, 0.0, 0.0}, .axes = {PTC_E_INPUT, PTC_E_INPUT, PTC_E_INPUT}},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {{0.5, 0.5}, {0.5, (double)NAN}, {0.5, 0.5}}, .status = PTC_E_INPUT, .u = {0.0, 0.0, 0.0}, .axes = {PTC_E_INPUT, PTC_E_INPUT, PTC_E_INPUT}},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {{0.5, 0.5}, {0.5, 0.5}, {(double)NAN, 0.5}}, .status = PTC_E_INPUT, .u = {0.0, 0.0, 0.0}, .axes = {PTC_E_INPUT, PTC_E_INPUT, PTC_E_INPUT}},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {{0.5, 0.5}, {0.5, 0.5}, {0.5, (double)NAN}}, .status = PTC_E_INPUT, .u = {0.0, 0.0, 0.0}, .axes = {PTC_E_INPUT, PTC_E_INPUT, PTC_E_INPUT}},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {{(double)INFINITY, 0.5}, {0.5, 0.5}, {0.5, 0.5}}, .status = PTC_E_INPUT, .u = {0.0, 0.0, 0.0}, .axes = {PTC_E_INPUT, PTC_E_INPUT, PTC_E_INPUT}},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {{0.5, (double)INFINITY}, {0.5, 0.5}, {0.5, 0.5}}, .status = PTC_E_INPUT, .u = {0.0, 0.0, 0.0}, .axes = {PTC_E_INPUT, PTC_E_INPUT, PTC_E_INPUT}},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {{0.5, 0.5}, {(double)INFINITY, 0.5}, {0.5, 0.5}}, .status = PTC_E_INPUT, .u = {0.0, 0.0, 0.0}, .axes = {PTC_E_INPUT, PTC_E_INPUT, PTC_E_INPUT}},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {{0.5, 0.5}, {0.5, (double)INFINITY}, {0.5, 0.5}}, .status = PTC_E_INPUT, .u = {0.0, 0.0, 0.0}, .axes = {PTC_E_INPUT, PTC_E_INPUT, PTC_E_INPUT}},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {{0.5, 0.5}, {0.5, 0.5}, {(double)INFINITY, 0.5}}, .status = PTC_E_INPUT, .u = {0.0, 0.0, 0.0}, .axes = {PTC_E_INPUT, PTC_E_INPUT, PTC_E_INPUT}},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {{0.5, 0.5}, {0.5, 0.5}, {0.5, (double)INFINITY}}, .status = PTC_E_INPUT, .u = {0.0, 0.0, 0.0}, .axes = {PTC_E_INPUT, PTC_E_INPUT, PTC_E_INPUT}},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {{-(double)INFINITY, 0.5}, {0.5, 0.5}, {0.5, 0.5}}, .status = PTC_E_INPUT, .u = {0.0, 0.0, 0.0}, .axes = {PTC_E_INPUT, PTC_E_INPUT, PTC_E_INPUT}},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {{0.5, -(double)INFINITY}, {0.5, 0.5}, {0.5, 0.5}}, .status = PTC_E_INPUT, .u = {0.0, 0.0, 0.0}, .axes = {PTC_E_INPUT, PTC_E_INPUT, PTC_E_INPUT}},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {{0.5, 0.5}, {-(double)INFINITY, 0.5}, {0.5, 0.5}}, .status = PTC_E_INPUT, .u = {0.0, 0.0, 0.0}, .axes = {PTC_E_INPUT, PTC_E_INPUT, PTC_E_INPUT}},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {{0.5, 0.5}, {0.5, -(double)INFINITY}, {0.5, 0.5}}, .status = PTC_E_INPUT, .u = {0.0, 0.0, 0.0}, .axes = {PTC_E_INPUT, PTC_E_INPUT, PTC_E_INPUT}},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {{0.5, 0.5}, {0.5, 0.5}, {-(double)INFINITY, 0.5}}, .status = PTC_E_INPUT, .u = {0.0, 0.0, 0.0}, .axes = {PTC_E_INPUT, PTC_E_INPUT, PTC_E_INPUT}},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {{0.5, 0.5}, {0.5, 0.5}, {0.5, -(double)INFINITY}}, .status = PTC_E_INPUT, .u = {0.0, 0.0, 0.0}, .axes = {PTC_E_INPUT, PTC_E_INPUT, PTC_E_INPUT}},
    {.is_armed = 0U, .start = 0U, .k = 0U, .y = {{0.6075, 0.2025}, {-0.2025, -0.6075}, {-1.0125000000000002, -1.4175}}, .status = PTC_SATURATED, .u = {-1.0, 2.0, -3.0}, .axes = {PTC_SATURATED, PTC_SATURATED, PTC_SATURATED}},
    {.is_armed = 0U, .start = 0U, .k = 4U, .y = {{0.4408333333333334, 0.14694444444444446}, {-0.14694444444444446, -0.4408333333333334}, {-0.7347222222222223, -1.0286111111111111}}, .status = PTC_SATURATED, .u = {-1.0, 2.0, -3.0}, .axes = {PTC_SATURATED, PTC_SATURATED, PTC_SATURATED}},
    {.is_armed = 0U, .start = 0U, .k = 8U, .y = {{0.3008333333333333, 0.10027777777777777}, {-0.10027777777777777, -0.3008333333333333}, {-0.5013888888888889, -0.7019444444444444}}, .status = PTC_SATURATED, .u = {-1.0, 2.0, -3.0}, .axes = {PTC_SATURATED, PTC_SATURATED, PTC_SATURATED}},
    {.is_armed = 0U, .start = 0U, .k = 10U, .y = {{0.2408333333333333, 0.08027777777777777}, {-0.08027777777777777, -0.2408333333333333}, {-0.40138888888888885, -0.5619444444444444}}, .status = PTC_SATURATED, .u = {-1.0, 2.0, -3.0}, .axes = {PTC_SATURATED, PTC_SATURATED, PTC_SATURATED}},
    {.is_armed = 0U, .start = 0U, .k = 11U, .y = {{0.21333333333333332, 0.07111111111111111}, {-0.07111111111111111, -0.21333333333333332}, {-0.35555555555555557, -0.49777777777777776}}, .status = PTC_SATURATED, .u = {-1.0, 2.0, -3.0}, .axes = {PTC_SATURATED, PTC_SATURATED, PTC_SATURATED}},
    {.is_armed = 0U, .start = 0U, .k = 12U, .y = {{0.1875, 0.0625}, {-0.0625, -0.1875}, {-0.3125, -0.4375}}, .status = PTC_SATURATED, .u = {-1.0, 2.0, -3.0}, .axes = {PTC_SATURATED, PTC_SATURATED, PTC_SATURATED}},
    {.is_armed = 0U, .start = 0U, .k = 13U, .y = {{0.16333333333333333, 0.05444444444444445}, {-0.05444444444444445, -0.16333333333333333}, {-0.27222222222222225, -0.3811111111111111}}, .status = PTC_SATURATED, .u = {-1.0, 2.0, -3.0}, .axes = {PTC_SATURATED, PTC_SATURATED, PTC_SATURATED}},
    {.is_armed = 0U, .start = 0U, .k = 19U, .y = {{0.05333333333333333, 0.017777777777777778}, {-0.017777777777777778, -0.05333333333333333}, {-0.08888888888888889, -0.12444444444444444}}, .status = PTC_SATURATED, .u = {-1.0, 2.0, -3.0}, .axes = {PTC_SATURATED, PTC_SATURATED, PTC_SATURATED}},
    {.is_armed = 0U, .start = 0U, .k = 23U, .y = {{0.013333333333333332, 0.0044444444444444444}, {-0.0044444444444444444, -0.013333333333333332}, {-0.022222222222222223, -0.03111111111111111}}, .status = PTC_SATURATED, .u = {-1.0, 2.0, -3.0}, .axes = {PTC_SATURATED, PTC_SATURATED, PTC_SATURATED}},
    {.is_armed = 0U, .start = 0U, .k = 25U, .y = {{0.003333333333333333, 0.0011111111111111111}, {-0.0011111111111111111, -0.003333333333333333}, {-0.005555555555555556, -0.0077777777777777776}}, .status = PTC_SATURATED, .u = {-1.0, 2.0, -3.0}, .axes = {PTC_SATURATED, PTC_SATURATED, PTC_SATURATED}},
    {.is_armed = 0U, .start = 0U, .k = 26U, .y = {{0.0008333333333333333, 0.0002777777777777778}, {-0.0002777777777777778, -0.0008333333333333333}, {-0.001388888888888889, -0.0019444444444444444}}, .status = PTC_SATURATED, .u = {-1.0, 1.451388888888889, -3.0}, .axes = {PTC_SATURATED, PTC_OK, PTC_SATURATED}},
    {.is_armed = 0U, .start = 0U, .k = 27U, .y = {{0.0, 0.0}, {-0.0, -0.0}, {-0.0, -0.0}}, .status = PTC_HOLD, .u = {0.0, 0.0, 0.0}, .axes = {PTC_HOLD, PTC_HOLD, PTC_HOLD}},
    {.is_armed = 0U, .start = 0U, .k = 28U, .y = {{0.0, 0.0}, {-0.0, -0.0}, {-0.0, -0.0}}, .status = PTC_HOLD, .u = {0.0, 0.0, 0.0}, .axes = {PTC_HOLD, PTC_HOLD, PTC_HOLD}},
    {.is_armed = 0U, .start = 0U, .k = 2147483644U, .y = {{0.0, 0.0}, {-0.0, -0.0}, {-0.0, -0.0}}, .status = PTC_HOLD, .u = {0.0, 0.0, 0.0}, .axes = {PTC_HOLD, PTC_HOLD, PTC_HOLD}},
    {.is_armed = 0U, .start = 0U, .k = 4294967292U, .y = {{0.0, 0.0}, {-0.0, -0.0}, {-0.0, -0.0}}, .status = PTC_HOLD, .u = {0.0, 0.0, 0.0}, .axes = {PTC_HOLD, PTC_HOLD, PTC_HOLD}},
    {.is_armed = 0U, .start = 0U, .k = 1U, .y = {{-0.6475592481261917, -0.3752762418554133}, {0.8615129375260748, 0.9132434226548424}, {-0.3110609905025956, -0.3423316652035391}}, .status = PTC_SATURATED, .u = {1.0, -2.0, -3.0}, .axes = {PTC_SATURATED, PTC_SATURATED, PTC_SATURATED}},
    {.is_armed = 0U, .start = 0U, .k = 3U, .y = {{0.8111764966162411, 0.7514300992031775}, {0.7811344378625003, -0.7421766469241432}, {0.8794984877586897, -0.3693844935953414}}, .status = PTC_SATURATED, .u = {-1.0, -2.0, 3.0}, .axes = {PTC_SATURATED, PTC_SATURATED, PTC_SATURATED}},
    {.is_armed = 0U, .start = 0U, .k = 31U, .y = {{-1.0131732065048951e308, -6.074805637248102e307}, {-8.138362211066612e307, 1.714357615880242e308}, {-7.784328494287631e307, -1.2185197111864145e308}}, .status = PTC_E_RANGE, .u = {0.0, 0.0, 0.0}, .axes = {PTC_E_RANGE, PTC_E_RANGE, PTC_E_RANGE}},
    {.is_armed = 1U, .start = 4294967290U, .k = 20U, .y = {{1.0, -0.0}, {0.0, -1.346898789101971e308}, {0.0, -714.1590707728568}}, .status = PTC_E_RANGE, .u = {0.0, 0.0, 0.0}, .axes = {PTC_OK, PTC_E_RANGE, PTC_OK}},
    {.is_armed = 0U, .start = 0U, .k = 20U, .y = {{0.0, -4.473404851701307e153}, {0.0, -0.0}, {1.2859426044929864e308, -5.295452232405313e153}}, .status = PTC_E_RANGE, .u = {0.0, 0.0, 0.0}, .axes = {PTC_OK, PTC_OK, PTC_E_RANGE}},
};

/* 1 where a number is not the one that must come. */
static uint32_t stage29_selftest_differs(double value, double wanted)
{
    uint32_t failures = 1U;

    if (fabs(value - wanted) <= 0.0) {
        failures = 0U;
    }
    return failures;
}

/* The failures of one call. */
static uint32_t stage29_selftest_check(stage29 *self, const stage29_selftest_call *call)
{
    uint32_t failures = 0U;
    double u[3] = {12345.0, 12345.0, 12345.0};
    ptc_status axes[3] = {PTC_E_PARAM, PTC_E_PARAM, PTC_E_PARAM};

    if (call->is_armed != 0U) {
        if (stage29_arm(self, call->start) != PTC_OK) {
            failures++;
        }
    }
    if (stage29_step(self, call->k, call->y, u, axes) != call->status) {
        failures++;
    }
    for (uint32_t i = 0U; i < 3U; i++) {
        failures += stage29_selftest_differs(u[i], call->u[i]);
        if (axes[i] != call->axes[i]) {
            failures++;
        }
    }
    return failures;
}

/* The calls of a session, of which init has been called. */
static uint32_t stage29_selftest_calls_of(stage29 *self, const stage29_selftest_session *session)
{
    uint32_t failures = 0U;

    for (uint32_t j = 0U; j < session->count; j++) {
        failures += stage29_selftest_check(self, &stage29_selftest_calls[session->first + j]);
    }
    return failures;
}

/* Every session with its calls. */
static uint32_t stage29_selftest_run(void)
{
    uint32_t failures = 0U;

    for (uint32_t i = 0U; i < 3U; i++) {
        const stage29_selftest_session *session = &stage29_selftest_sessions[i];
        stage29 self;

        if (stage29_init(&self, &session->params) == PTC_OK) {
            failures += stage29_selftest_calls_of(&self, session);
        } else {
            failures++;
        }
    }
    return failures;
}

/* What init must refuse without a change. */
static uint32_t stage29_selftest_refuse(void)
{
    const stage29_selftest_session *session = &stage29_selftest_sessions[0];
    uint32_t failures = 0U;
    stage29 self;

    if (stage29_init(&self, &session->params) != PTC_OK) {
        failures++;
    }
    if (stage29_init(NULL, &session->params) != PTC_E_PARAM) {
        failures++;
    }
    failures += stage29_selftest_calls_of(&self, session);
    return failures;
}

/* Calls that lack a pointer: each is refused, and changes nothing. */
static uint32_t stage29_selftest_pointers(void)
{
    const stage29_selftest_session *session = &stage29_selftest_sessions[0];
    const stage29_selftest_call *call = &stage29_selftest_calls[0];
    uint32_t failures = 0U;
    double u[3] = {12345.0, 12345.0, 12345.0};
    ptc_status axes[3] = {PTC_E_PARAM, PTC_E_PARAM, PTC_E_PARAM};
    stage29 self;

    if (stage29_init(&self, &session->params) != PTC_OK) {
        failures++;
    }
    if (stage29_arm(NULL, call->start) != PTC_E_INPUT) {
        failures++;
    }
    if (stage29_step(NULL, call->k, call->y, u, axes) != PTC_E_INPUT) {
        failures++;
    }
    for (uint32_t i = 0U; i < 3U; i++) {
        failures += stage29_selftest_differs(u[i], 0.0);
        u[i] = 12345.0;
    }
    if (stage29_step(&self, call->k, call->y, u, NULL) != PTC_E_INPUT) {
        failures++;
    }
    for (uint32_t i = 0U; i < 3U; i++) {
        failures += stage29_selftest_differs(u[i], 0.0);
        u[i] = 12345.0;
    }
    if (stage29_step(&self, call->k, NULL, u, axes) != PTC_E_INPUT) {
        failures++;
    }
    for (uint32_t i = 0U; i < 3U; i++) {
        failures += stage29_selftest_differs(u[i], 0.0);
    }
    if (stage29_step(&self, call->k, call->y, NULL, axes) != PTC_E_INPUT) {
        failures++;
    }
    failures += stage29_selftest_calls_of(&self, session);
    return failures;
}

uint32_t stage29_selftest(void)
{
    uint32_t failures = stage29_selftest_run();

    failures += stage29_selftest_refuse();
    failures += stage29_selftest_pointers();
    return failures;
}
