/* Self-test of the prescribed-time controller stage31: see stage31_selftest.h. DO NOT EDIT. */
#include "stage31_selftest.h"
#include "stage31.h"

#include <math.h>
#include <stddef.h>

/* A call, and what it must give. */
typedef struct stage31_selftest_call {
    uint32_t is_armed; /* arm is called before it */
    uint32_t start;
    uint32_t k;
    double y[3]; /* what is measured */
    double r[2][3]; /* the reference and its derivatives */
    ptc_status status;
    double u[2];
    ptc_status axes[2];
} stage31_selftest_call;

/* A set of parameters that init takes, and the calls with it, one after the other. */
typedef struct stage31_selftest_session {
    stage31_params params;
    uint32_t first; /* of its calls */
    uint32_t count;
} stage31_selftest_session;

static const stage31_selftest_session stage31_selftest_sessions[4] = {
    {.params = {.samples = 60U, .h = 0.015625}, .first = 0U, .count = 90U},
    {.params = {.samples = 60U, .h = 0.015625}, .first = 90U, .count = 2U},
    {.params = {.samples = 60U, .h = 0.015625}, .first = 92U, .count = 2U},
    {.params = {.samples = 60U, .h = 0.015625}, .first = 94U, .count = 2U},
};

static const stage31_selftest_call stage31_selftest_calls[96] = {
    {.is_armed = 0U, .start = 0U, .k = 0U, .y = {0.75, 0.25, -0.25}, .r = {{-0.75, -1.25, -1.75}, {-2.25, -2.75, -3.25}}, .status = PTC_SATURATED, .u = {-2.0, -3.0}, .axes = {PTC_SATURATED, PTC_SATURATED}},
    {.is_armed = 0U, .start = 0U, .k = 1U, .y = {0.7252083333333332, 0.2417361111111111, -0.2417361111111111}, .r = {{-0.7252083333333332, -1.2086805555555555, -1.6921527777777776}, {-2.1756249999999997, -2.659097222222222, -3.1425694444444443}}, .status = PTC_SATURATED, .u = {-2.0, -3.0}, .axes = {PTC_SATURATED, PTC_SATURATED}},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {0.7008333333333333, 0.2336111111111111, -0.2336111111111111}, .r = {{-0.7008333333333333, -1.1680555555555556, -1.6352777777777776}, {-2.1025, -2.569722222222222, -3.0369444444444444}}, .status = PTC_SATURATED, .u = {-2.0, -3.0}, .axes = {PTC_SATURATED, PTC_SATURATED}},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {(double)NAN, 0.5, 0.5}, .r = {{0.5, 0.5, 0.5}, {0.5, 0.5, 0.5}}, .status = PTC_E_INPUT, .u = {0.0, 0.0}, .axes = {PTC_E_INPUT, PTC_E_INPUT}},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {0.5, (double)NAN, 0.5}, .r = {{0.5, 0.5, 0.5}, {0.5, 0.5, 0.5}}, .status = PTC_E_INPUT, .u = {0.0, 0.0}, .axes = {PTC_E_INPUT, PTC_E_INPUT}},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {0.5, 0.5, (double)NAN}, .r = {{0.5, 0.5, 0.5}, {0.5, 0.5, 0.5}}, .status = PTC_E_INPUT, .u = {0.0, 0.0}, .axes = {PTC_E_INPUT, PTC_E_INPUT}},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {0.5, 0.5, 0.5}, .r = {{(double)NAN, 0.5, 0.5}, {0.5, 0.5, 0.5}}, .status = PTC_E_INPUT, .u = {0.0, 0.0}, .axes = {PTC_E_INPUT, PTC_E_INPUT}},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {0.5, 0.5, 0.5}, .r = {{0.5, (double)NAN, 0.5}, {0.5, 0.5, 0.5}}, .status = PTC_E_INPUT, .u = {0.0, 0.0}, .axes = {PTC_E_INPUT, PTC_E_INPUT}},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {0.5, 0.5, 0.5}, .r = {{0.5, 0.5, (double)NAN}, {0.5, 0.5, 0.5}}, .status = PTC_SATURATED, .u = {0.55, 3.0}, .axes = {PTC_OK, PTC_SATURATED}},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {0.5, 0.5, 0.5}, .r = {{0.5, 0.5, 0.5}, {(double)NAN, 0.5, 0.5}}, .status = PTC_E_INPUT, .u = {0.0, 0.0}, .axes = {PTC_E_INPUT, PTC_E_INPUT}},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {0.5, 0.5, 0.5}, .r = {{0.5, 0.5, 0.5}, {0.5, (double)NAN, 0.5}}, .status = PTC_E_INPUT, .u = {0.0, 0.0}, .axes = {PTC_E_INPUT, PTC_E_INPUT}},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {0.5, 0.5, 0.5}, .r = {{0.5, 0.5, 0.5}, {0.5, 0.5, (double)NAN}}, .status = PTC_E_INPUT, .u = {0.0, 0.0}, .axes = {PTC_E_INPUT, PTC_E_INPUT}},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {(double)INFINITY, 0.5, 0.5}, .r = {{0.5, 0.5, 0.5}, {0.5, 0.5, 0.5}}, .status = PTC_E_INPUT, .u = {0.0, 0.0}, .axes = {PTC_E_INPUT, PTC_E_INPUT}},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {0.5, (double)INFINITY, 0.5}, .r = {{0.5, 0.5, 0.5}, {0.5, 0.5, 0.5}}, .status = PTC_E_INPUT, .u = {0.0, 0.0}, .axes = {PTC_E_INPUT, PTC_E_INPUT}},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {0.5, 0.5, (double)INFINITY}, .r = {{0.5, 0.5, 0.5}, {0.5, 0.5, 0.5}}, .status = PTC_E_INPUT, .u = {0.0, 0.0}, .axes = {PTC_E_INPUT, PTC_E_INPUT}},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {0.5, 0.5, 0.5}, .r = {{(double)INFINITY, 0.5, 0.5}, {0.5, 0.5, 0.5}}, .status = PTC_E_INPUT, .u = {0.0, 0.0}, .axes = {PTC_E_INPUT, PTC_E_INPUT}},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {0.5, 0.5, 0.5}, .r = {{0.5, (double)INFINITY, 0.5}, {0.5, 0.5, 0.5}}, .status = PTC_E_INPUT, .u = {0.0, 0.0}, .axes = {PTC_E_INPUT, PTC_E_INPUT}},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {0.5, 0.5, 0.5}, .r = {{0.5, 0.5, (double)INFINITY}, {0.5, 0.5, 0.5}}, .status = PTC_SATURATED, .u = {0.55, 3.0}, .axes = {PTC_OK, PTC_SATURATED}},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {0.5, 0.5, 0.5}, .r = {{0.5, 0.5, 0.5}, {(double)INFINITY, 0.5, 0.5}}, .status = PTC_E_INPUT, .u = {0.0, 0.0}, .axes = {PTC_E_INPUT, PTC_E_INPUT}},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {0.5, 0.5, 0.5}, .r = {{0.5, 0.5, 0.5}, {0.5, (double)INFINITY, 0.5}}, .status = PTC_E_INPUT, .u = {0.0, 0.0}, .axes = {PTC_E_INPUT, PTC_E_INPUT}},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {0.5, 0.5, 0.5}, .r = {{0.5, 0.5, 0.5}, {0.5, 0.5, (double)INFINITY}}, .status = PTC_E_INPUT, .u = {0.0, 0.0}, .axes = {PTC_E_INPUT, PTC_E_INPUT}},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {-(double)INFINITY, 0.5, 0.5}, .r = {{0.5, 0.5, 0.5}, {0.5, 0.5, 0.5}}, .status = PTC_E_INPUT, .u = {0.0, 0.0}, .axes = {PTC_E_INPUT, PTC_E_INPUT}},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {0.5, -(double)INFINITY, 0.5}, .r = {{0.5, 0.5, 0.5}, {0.5, 0.5, 0.5}}, .status = PTC_E_INPUT, .u = {0.0, 0.0}, .axes = {PTC_E_INPUT, PTC_E_INPUT}},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {0.5, 0.5, -(double)INFINITY}, .r = {{0.5, 0.5, 0.5}, {0.5, 0.5, 0.5}}, .status = PTC_E_INPUT, .u = {0.0, 0.0}, .axes = {PTC_E_INPUT, PTC_E_INPUT}},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {0.5, 0.5, 0.5}, .r = {{-(double)INFINITY, 0.5, 0.5}, {0.5, 0.5, 0.5}}, .status = PTC_E_INPUT, .u = {0.0, 0.0}, .axes = {PTC_E_INPUT, PTC_E_INPUT}},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {0.5, 0.5, 0.5}, .r = {{0.5, -(double)INFINITY, 0.5}, {0.5, 0.5, 0.5}}, .status = PTC_E_INPUT, .u = {0.0, 0.0}, .axes = {PTC_E_INPUT, PTC_E_INPUT}},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {0.5, 0.5, 0.5}, .r = {{0.5, 0.5, -(double)INFINITY}, {0.5, 0.5, 0.5}}, .status = PTC_SATURATED, .u = {0.55, 3.0}, .axes = {PTC_OK, PTC_SATURATED}},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {0.5, 0.5, 0.5}, .r = {{0.5, 0.5, 0.5}, {-(double)INFINITY, 0.5, 0.5}}, .status = PTC_E_INPUT, .u = {0.0, 0.0}, .axes = {PTC_E_INPUT, PTC_E_INPUT}},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {0.5, 0.5, 0.5}, .r = {{0.5, 0.5, 0.5}, {0.5, -(double)INFINITY, 0.5}}, .status = PTC_E_INPUT, .u = {0.0, 0.0}, .axes = {PTC_E_INPUT, PTC_E_INPUT}},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {0.5, 0.5, 0.5}, .r = {{0.5, 0.5, 0.5}, {0.5, 0.5, -(double)INFINITY}}, .status = PTC_E_INPUT, .u = {0.0, 0.0}, .axes = {PTC_E_INPUT, PTC_E_INPUT}},
    {.is_armed = 0U, .start = 0U, .k = 3U, .y = {0.676875, 0.225625, -0.225625}, .r = {{-0.676875, -1.128125, -1.579375}, {-2.030625, -2.481875, -2.933125}}, .status = PTC_SATURATED, .u = {-2.0, -3.0}, .axes = {PTC_SATURATED, PTC_SATURATED}},
    {.is_armed = 0U, .start = 0U, .k = 15U, .y = {0.421875, 0.140625, -0.140625}, .r = {{-0.421875, -0.703125, -0.984375}, {-1.265625, -1.546875, -1.828125}}, .status = PTC_SATURATED, .u = {-2.0, -3.0}, .axes = {PTC_SATURATED, PTC_SATURATED}},
    {.is_armed = 0U, .start = 0U, .k = 26U, .y = {0.2408333333333333, 0.08027777777777777, -0.08027777777777777}, .r = {{-0.2408333333333333, -0.40138888888888885, -0.5619444444444444}, {-0.7224999999999999, -0.8830555555555555, -1.043611111111111}}, .status = PTC_SATURATED, .u = {-2.0, -3.0}, .axes = {PTC_SATURATED, PTC_SATURATED}},
    {.is_armed = 0U, .start = 0U, .k = 28U, .y = {0.21333333333333332, 0.07111111111111111, -0.07111111111111111}, .r = {{-0.21333333333333332, -0.35555555555555557, -0.49777777777777776}, {-0.64, -0.7822222222222223, -0.9244444444444444}}, .status = PTC_SATURATED, .u = {-2.0, -3.0}, .axes = {PTC_SATURATED, PTC_SATURATED}},
    {.is_armed = 0U, .start = 0U, .k = 29U, .y = {0.20020833333333338, 0.06673611111111112, -0.06673611111111112}, .r = {{-0.20020833333333338, -0.3336805555555556, -0.46715277777777786}, {-0.6006250000000001, -0.7340972222222223, -0.8675694444444446}}, .status = PTC_SATURATED, .u = {-2.0, -3.0}, .axes = {PTC_SATURATED, PTC_SATURATED}},
    {.is_armed = 0U, .start = 0U, .k = 30U, .y = {0.1875, 0.0625, -0.0625}, .r = {{-0.1875, -0.3125, -0.4375}, {-0.5625, -0.6875, -0.8125}}, .status = PTC_SATURATED, .u = {-2.0, -3.0}, .axes = {PTC_SATURATED, PTC_SATURATED}},
    {.is_armed = 0U, .start = 0U, .k = 31U, .y = {0.17520833333333333, 0.058402777777777776, -0.058402777777777776}, .r = {{-0.17520833333333333, -0.2920138888888889, -0.4088194444444444}, {-0.525625, -0.6424305555555555, -0.7592361111111111}}, .status = PTC_SATURATED, .u = {-2.0, -3.0}, .axes = {PTC_SATURATED, PTC_SATURATED}},
    {.is_armed = 0U, .start = 0U, .k = 45U, .y = {0.046875, 0.015625, -0.015625}, .r = {{-0.046875, -0.078125, -0.109375}, {-0.140625, -0.171875, -0.203125}}, .status = PTC_SATURATED, .u = {-1.485202205882353, -3.0}, .axes = {PTC_OK, PTC_SATURATED}},
    {.is_armed = 0U, .start = 0U, .k = 56U, .y = {0.003333333333333333, 0.0011111111111111111, -0.0011111111111111111}, .r = {{-0.003333333333333333, -0.005555555555555556, -0.0077777777777777776}, {-0.01, -0.012222222222222223, -0.014444444444444444}}, .status = PTC_SATURATED, .u = {-0.28966666666666663, -3.0}, .axes = {PTC_OK, PTC_SATURATED}},
    {.is_armed = 0U, .start = 0U, .k = 58U, .y = {0.0008333333333333333, 0.0002777777777777778, -0.0002777777777777778}, .r = {{-0.0008333333333333333, -0.001388888888888889, -0.0019444444444444444}, {-0.0025, -0.0030555555555555557, -0.003611111111111111}}, .status = PTC_SATURATED, .u = {-0.1079722222222222, -3.0}, .axes = {PTC_OK, PTC_SATURATED}},
    {.is_armed = 0U, .start = 0U, .k = 59U, .y = {0.00020833333333333332, 6.944444444444444e-5, -6.944444444444444e-5}, .r = {{-0.00020833333333333332, -0.00034722222222222224, -0.0004861111111111111}, {-0.000625, -0.0007638888888888889, -0.0009027777777777777}}, .status = PTC_OK, .u = {-0.02699305555555555, -2.3624234341520527}, .axes = {PTC_OK, PTC_OK}},
    {.is_armed = 0U, .start = 0U, .k = 60U, .y = {0.0, 0.0, -0.0}, .r = {{-0.0, -0.0, -0.0}, {-0.0, -0.0, -0.0}}, .status = PTC_HOLD, .u = {0.0, 0.0}, .axes = {PTC_HOLD, PTC_HOLD}},
    {.is_armed = 0U, .start = 0U, .k = 61U, .y = {0.0, 0.0, -0.0}, .r = {{-0.0, -0.0, -0.0}, {-0.0, -0.0, -0.0}}, .status = PTC_HOLD, .u = {0.0, 0.0}, .axes = {PTC_HOLD, PTC_HOLD}},
    {.is_armed = 0U, .start = 0U, .k = 2147483647U, .y = {0.0, 0.0, -0.0}, .r = {{-0.0, -0.0, -0.0}, {-0.0, -0.0, -0.0}}, .status = PTC_HOLD, .u = {0.0, 0.0}, .axes = {PTC_HOLD, PTC_HOLD}},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {0.0, 0.0, -0.0}, .r = {{-0.0, -0.0, -0.0}, {-0.0, -0.0, -0.0}}, .status = PTC_HOLD, .u = {0.0, 0.0}, .axes = {PTC_HOLD, PTC_HOLD}},
    {.is_armed = 1U, .start = 4294967293U, .k = 4294967293U, .y = {0.75, 0.25, -0.25}, .r = {{-0.75, -1.25, -1.75}, {-2.25, -2.75, -3.25}}, .status = PTC_SATURATED, .u = {-2.0, -3.0}, .axes = {PTC_SATURATED, PTC_SATURATED}},
    {.is_armed = 0U, .start = 0U, .k = 4294967294U, .y = {0.7252083333333332, 0.2417361111111111, -0.2417361111111111}, .r = {{-0.7252083333333332, -1.2086805555555555, -1.6921527777777776}, {-2.1756249999999997, -2.659097222222222, -3.1425694444444443}}, .status = PTC_SATURATED, .u = {-2.0, -3.0}, .axes = {PTC_SATURATED, PTC_SATURATED}},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {0.7008333333333333, 0.2336111111111111, -0.2336111111111111}, .r = {{-0.7008333333333333, -1.1680555555555556, -1.6352777777777776}, {-2.1025, -2.569722222222222, -3.0369444444444444}}, .status = PTC_SATURATED, .u = {-2.0, -3.0}, .axes = {PTC_SATURATED, PTC_SATURATED}},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {(double)NAN, 0.5, 0.5}, .r = {{0.5, 0.5, 0.5}, {0.5, 0.5, 0.5}}, .status = PTC_E_INPUT, .u = {0.0, 0.0}, .axes = {PTC_E_INPUT, PTC_E_INPUT}},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {0.5, (double)NAN, 0.5}, .r = {{0.5, 0.5, 0.5}, {0.5, 0.5, 0.5}}, .status = PTC_E_INPUT, .u = {0.0, 0.0}, .axes = {PTC_E_INPUT, PTC_E_INPUT}},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {0.5, 0.5, (double)NAN}, .r = {{0.5, 0.5, 0.5}, {0.5, 0.5, 0.5}}, .status = PTC_E_INPUT, .u = {0.0, 0.0}, .axes = {PTC_E_INPUT, PTC_E_INPUT}},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {0.5, 0.5, 0.5}, .r = {{(double)NAN, 0.5, 0.5}, {0.5, 0.5, 0.5}}, .status = PTC_E_INPUT, .u = {0.0, 0.0}, .axes = {PTC_E_INPUT, PTC_E_INPUT}},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {0.5, 0.5, 0.5}, .r = {{0.5, (double)NAN, 0.5}, {0.5, 0.5, 0.5}}, .status = PTC_E_INPUT, .u = {0.0, 0.0}, .axes = {PTC_E_INPUT, PTC_E_INPUT}},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {0.5, 0.5, 0.5}, .r = {{0.5, 0.5, (double)NAN}, {0.5, 0.5, 0.5}}, .status = PTC_SATURATED, .u = {0.55, 3.0}, .axes = {PTC_OK, PTC_SATURATED}},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {0.5, 0.5, 0.5}, .r = {{0.5, 0.5, 0.5}, {(double)NAN, 0.5, 0.5}}, .status = PTC_E_INPUT, .u = {0.0, 0.0}, .axes = {PTC_E_INPUT, PTC_E_INPUT}},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {0.5, 0.5, 0.5}, .r = {{0.5, 0.5, 0.5}, {0.5, (double)NAN, 0.5}}, .status = PTC_E_INPUT, .u = {0.0, 0.0}, .axes = {PTC_E_INPUT, PTC_E_INPUT}},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {0.5, 0.5, 0.5}, .r = {{0.5, 0.5, 0.5}, {0.5, 0.5, (double)NAN}}, .status = PTC_E_INPUT, .u = {0.0, 0.0}, .axes = {PTC_E_INPUT, PTC_E_INPUT}},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {(double)INFINITY, 0.5, 0.5}, .r = {{0.5, 0.5, 0.5}, {0.5, 0.5, 0.5}}, .status = PTC_E_INPUT, .u = {0.0, 0.0}, .axes = {PTC_E_INPUT, PTC_E_INPUT}},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {0.5, (double)INFINITY, 0.5}, .r = {{0.5, 0.5, 0.5}, {0.5, 0.5, 0.5}}, .status = PTC_E_INPUT, .u = {0.0, 0.0}, .axes = {PTC_E_INPUT, PTC_E_INPUT}},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {0.5, 0.5, (double)INFINITY}, .r = {{0.5, 0.5, 0.5}, {0.5, 0.5, 0.5}}, .status = PTC_E_INPUT, .u = {0.0, 0.0}, .axes = {PTC_E_INPUT, PTC_E_INPUT}},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {0.5, 0.5, 0.5}, .r = {{(double)INFINITY, 0.5, 0.5}, {0.5, 0.5, 0.5}}, .status = PTC_E_INPUT, .u = {0.0, 0.0}, .axes = {PTC_E_INPUT, PTC_E_INPUT}},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {0.5, 0.5, 0.5}, .r = {{0.5, (double)INFINITY, 0.5}, {0.5, 0.5, 0.5}}, .status = PTC_E_INPUT, .u = {0.0, 0.0}, .axes = {PTC_E_INPUT, PTC_E_INPUT}},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {0.5, 0.5, 0.5}, .r = {{0.5, 0.5, (double)INFINITY}, {0.5, 0.5, 0.5}}, .status = PTC_SATURATED, .u = {0.55, 3.0}, .axes = {PTC_OK, PTC_SATURATED}},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {0.5, 0.5, 0.5}, .r = {{0.5, 0.5, 0.5}, {(double)INFINITY, 0.5, 0.5}}, .status = PTC_E_INPUT, .u = {0.0, 0.0}, .axes = {PTC_E_INPUT, PTC_E_INPUT}},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {0.5, 0.5, 0.5}, .r = {{0.5, 0.5, 0.5}, {0.5, (double)INFINITY, 0.5}}, .status = PTC_E_INPUT, .u = {0.0, 0.0}, .axes = {PTC_E_INPUT, PTC_E_INPUT}},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {0.5, 0.5, 0.5}, .r = {{0.5, 0.5, 0.5}, {0.5, 0.5, (double)INFINITY}}, .status = PTC_E_INPUT, .u = {0.0, 0.0}, .axes = {PTC_E_INPUT, PTC_E_INPUT}},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {-(double)INFINITY, 0.5, 0.5}, .r = {{0.5, 0.5, 0.5}, {0.5, 0.5, 0.5}}, .status = PTC_E_INPUT, .u = {0.0, 0.0}, .axes = {PTC_E_INPUT, PTC_E_INPUT}},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {0.5, -(double)INFINITY, 0.5}, .r = {{0.5, 0.5, 0.5}, {0.5, 0.5, 0.5}}, .status = PTC_E_INPUT, .u = {0.0, 0.0}, .axes = {PTC_E_INPUT, PTC_E_INPUT}},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {0.5, 0.5, -(double)INFINITY}, .r = {{0.5, 0.5, 0.5}, {0.5, 0.5, 0.5}}, .status = PTC_E_INPUT, .u = {0.0, 0.0}, .axes = {PTC_E_INPUT, PTC_E_INPUT}},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {0.5, 0.5, 0.5}, .r = {{-(double)INFINITY, 0.5, 0.5}, {0.5, 0.5, 0.5}}, .status = PTC_E_INPUT, .u = {0.0, 0.0}, .axes = {PTC_E_INPUT, PTC_E_INPUT}},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {0.5, 0.5, 0.5}, .r = {{0.5, -(double)INFINITY, 0.5}, {0.5, 0.5, 0.5}}, .status = PTC_E_INPUT, .u = {0.0, 0.0}, .axes = {PTC_E_INPUT, PTC_E_INPUT}},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {0.5, 0.5, 0.5}, .r = {{0.5, 0.5, -(double)INFINITY}, {0.5, 0.5, 0.5}}, .status = PTC_SATURATED, .u = {0.55, 3.0}, .axes = {PTC_OK, PTC_SATURATED}},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {0.5, 0.5, 0.5}, .r = {{0.5, 0.5, 0.5}, {-(double)INFINITY, 0.5, 0.5}}, .status = PTC_E_INPUT, .u = {0.0, 0.0}, .axes = {PTC_E_INPUT, PTC_E_INPUT}},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {0.5, 0.5, 0.5}, .r = {{0.5, 0.5, 0.5}, {0.5, -(double)INFINITY, 0.5}}, .status = PTC_E_INPUT, .u = {0.0, 0.0}, .axes = {PTC_E_INPUT, PTC_E_INPUT}},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {0.5, 0.5, 0.5}, .r = {{0.5, 0.5, 0.5}, {0.5, 0.5, -(double)INFINITY}}, .status = PTC_E_INPUT, .u = {0.0, 0.0}, .axes = {PTC_E_INPUT, PTC_E_INPUT}},
    {.is_armed = 0U, .start = 0U, .k = 0U, .y = {0.676875, 0.225625, -0.225625}, .r = {{-0.676875, -1.128125, -1.579375}, {-2.030625, -2.481875, -2.933125}}, .status = PTC_SATURATED, .u = {-2.0, -3.0}, .axes = {PTC_SATURATED, PTC_SATURATED}},
    {.is_armed = 0U, .start = 0U, .k = 12U, .y = {0.421875, 0.140625, -0.140625}, .r = {{-0.421875, -0.703125, -0.984375}, {-1.265625, -1.546875, -1.828125}}, .status = PTC_SATURATED, .u = {-2.0, -3.0}, .axes = {PTC_SATURATED, PTC_SATURATED}},
    {.is_armed = 0U, .start = 0U, .k = 23U, .y = {0.2408333333333333, 0.08027777777777777, -0.08027777777777777}, .r = {{-0.2408333333333333, -0.40138888888888885, -0.5619444444444444}, {-0.7224999999999999, -0.8830555555555555, -1.043611111111111}}, .status = PTC_SATURATED, .u = {-2.0, -3.0}, .axes = {PTC_SATURATED, PTC_SATURATED}},
    {.is_armed = 0U, .start = 0U, .k = 25U, .y = {0.21333333333333332, 0.07111111111111111, -0.07111111111111111}, .r = {{-0.21333333333333332, -0.35555555555555557, -0.49777777777777776}, {-0.64, -0.7822222222222223, -0.9244444444444444}}, .status = PTC_SATURATED, .u = {-2.0, -3.0}, .axes = {PTC_SATURATED, PTC_SATURATED}},
    {.is_armed = 0U, .start = 0U, .k = 26U, .y = {0.20020833333333338, 0.06673611111111112, -0.06673611111111112}, .r = {{-0.20020833333333338, -0.3336805555555556, -0.46715277777777786}, {-0.6006250000000001, -0.7340972222222223, -0.8675694444444446}}, .status = PTC_SATURATED, .u = {-2.0, -3.0}, .axes = {PTC_SATURATED, PTC_SATURATED}},
    {.is_armed = 0U, .start = 0U, .k = 27U, .y = {0.1875, 0.0625, -0.0625}, .r = {{-0.1875, -0.3125, -0.4375}, {-0.5625, -0.6875, -0.8125}}, .status = PTC_SATURATED, .u = {-2.0, -3.0}, .axes = {PTC_SATURATED, PTC_SATURATED}},
    {.is_armed = 0U, .start = 0U, .k = 28U, .y = {0.17520833333333333, 0.058402777777777776, -0.058402777777777776}, .r = {{-0.17520833333333333, -0.2920138888888889, -0.4088194444444444}, {-0.525625, -0.6424305555555555, -0.7592361111111111}}, .status = PTC_SATURATED, .u = {-2.0, -3.0}, .axes = {PTC_SATURATED, PTC_SATURATED}},
    {.is_armed = 0U, .start = 0U, .k = 42U, .y = {0.046875, 0.015625, -0.015625}, .r = {{-0.046875, -0.078125, -0.109375}, {-0.140625, -0.171875, -0.203125}}, .status = PTC_SATURATED, .u = {-1.485202205882353, -3.0}, .axes = {PTC_OK, PTC_SATURATED}},
    {.is_armed = 0U, .start = 0U, .k = 53U, .y = {0.003333333333333333, 0.0011111111111111111, -0.0011111111111111111}, .r = {{-0.003333333333333333, -0.005555555555555556, -0.0077777777777777776}, {-0.01, -0.012222222222222223, -0.014444444444444444}}, .status = PTC_SATURATED, .u = {-0.28966666666666663, -3.0}, .axes = {PTC_OK, PTC_SATURATED}},
    {.is_armed = 0U, .start = 0U, .k = 55U, .y = {0.0008333333333333333, 0.0002777777777777778, -0.0002777777777777778}, .r = {{-0.0008333333333333333, -0.001388888888888889, -0.0019444444444444444}, {-0.0025, -0.0030555555555555557, -0.003611111111111111}}, .status = PTC_SATURATED, .u = {-0.1079722222222222, -3.0}, .axes = {PTC_OK, PTC_SATURATED}},
    {.is_armed = 0U, .start = 0U, .k = 56U, .y = {0.00020833333333333332, 6.944444444444444e-5, -6.944444444444444e-5}, .r = {{-0.00020833333333333332, -0.00034722222222222224, -0.0004861111111111111}, {-0.000625, -0.0007638888888888889, -0.0009027777777777777}}, .status = PTC_OK, .u = {-0.02699305555555555, -2.3624234341520527}, .axes = {PTC_OK, PTC_OK}},
    {.is_armed = 0U, .start = 0U, .k = 57U, .y = {0.0, 0.0, -0.0}, .r = {{-0.0, -0.0, -0.0}, {-0.0, -0.0, -0.0}}, .status = PTC_HOLD, .u = {0.0, 0.0}, .axes = {PTC_HOLD, PTC_HOLD}},
    {.is_armed = 0U, .start = 0U, .k = 58U, .y = {0.0, 0.0, -0.0}, .r = {{-0.0, -0.0, -0.0}, {-0.0, -0.0, -0.0}}, .status = PTC_HOLD, .u = {0.0, 0.0}, .axes = {PTC_HOLD, PTC_HOLD}},
    {.is_armed = 0U, .start = 0U, .k = 2147483644U, .y = {0.0, 0.0, -0.0}, .r = {{-0.0, -0.0, -0.0}, {-0.0, -0.0, -0.0}}, .status = PTC_HOLD, .u = {0.0, 0.0}, .axes = {PTC_HOLD, PTC_HOLD}},
    {.is_armed = 0U, .start = 0U, .k = 4294967292U, .y = {0.0, 0.0, -0.0}, .r = {{-0.0, -0.0, -0.0}, {-0.0, -0.0, -0.0}}, .status = PTC_HOLD, .u = {0.0, 0.0}, .axes = {PTC_HOLD, PTC_HOLD}},
    {.is_armed = 0U, .start = 0U, .k = 8U, .y = {-0.46686855083014167, -0.6826225392131797, -0.40928099913520377}, .r = {{0.751648133688656, -0.8898371006688687, -0.7824424488366877}, {0.8989165008522213, -0.9786845658780664, -0.6094860515979019}}, .status = PTC_SATURATED, .u = {2.0, 3.0}, .axes = {PTC_SATURATED, PTC_SATURATED}},
    {.is_armed = 1U, .start = 4294967290U, .k = 28U, .y = {-8.00355004208609e153, -9.087213476651778e153, -7.112217461756663e153}, .r = {{1.3363439467601376e154, -5.736058256998478e153, 8.5622133058282e153}, {-1.2662206123204785e154, -1.0707071900703451e154, -1.2915942562853765e154}}, .status = PTC_E_RANGE, .u = {0.0, 0.0}, .axes = {PTC_E_RANGE, PTC_E_RANGE}},
    {.is_armed = 0U, .start = 0U, .k = 49U, .y = {1.1518547627435132e154, 1.3035549040671623e154, -8.996692610054149e153}, .r = {{8.046758924186263e153, -3.7175815944136444e153, -4.889913945941084e153}, {-1.1117923025074072e154, -1.2068975056114916e154, -6.726646161744484e153}}, .status = PTC_E_RANGE, .u = {0.0, 0.0}, .axes = {PTC_E_RANGE, PTC_E_RANGE}},
    {.is_armed = 1U, .start = 4294967290U, .k = 5U, .y = {-7.250138620919631e153, -1.2584041371342861e154, -5.563383929342001e153}, .r = {{-9.950843438574715e153, -4.1710321182085964e153, -4.760442691911076e153}, {8.39195674234168e153, -8.359192156173538e153, 4.686686721794329e153}}, .status = PTC_E_RANGE, .u = {0.0, 0.0}, .axes = {PTC_OK, PTC_E_RANGE}},
    {.is_armed = 1U, .start = 4294967290U, .k = 4294967289U, .y = {-1.0, 577.4044785366198, 0.0}, .r = {{-0.00034487045973452334, 1.1548435884023326e154, -1.0}, {0.5, -2.0, 0.5}}, .status = PTC_E_RANGE, .u = {0.0, 0.0}, .axes = {PTC_E_RANGE, PTC_E_RANGE}},
    {.is_armed = 1U, .start = 4294967290U, .k = 4294967295U, .y = {-1.307730121306099e154, -0.5546960752589499, -2.0}, .r = {{5.406673970288992e301, 374.8610318281609, 997.6378680481436}, {0.0, -0.0, -1.0}}, .status = PTC_E_RANGE, .u = {0.0, 0.0}, .axes = {PTC_E_RANGE, PTC_OK}},
};

/* 1 where a number is not the one that must come. */
static uint32_t stage31_selftest_differs(double value, double wanted)
{
    uint32_t failures = 1U;

    if (fabs(value - wanted) <= 0.0) {
        failures = 0U;
    }
    return failures;
}

/* The failures of one call. */
static uint32_t stage31_selftest_check(stage31 *self, const stage31_selftest_call *call)
{
    uint32_t failures = 0U;
    double u[2] = {12345.0, 12345.0};
    ptc_status axes[2] = {PTC_E_PARAM, PTC_E_PARAM};

    if (call->is_armed != 0U) {
        if (stage31_arm(self, call->start) != PTC_OK) {
            failures++;
        }
    }
    if (stage31_step(self, call->k, call->y, call->r, u, axes) != call->status) {
        failures++;
    }
    for (uint32_t i = 0U; i < 2U; i++) {
        failures += stage31_selftest_differs(u[i], call->u[i]);
        if (axes[i] != call->axes[i]) {
            failures++;
        }
    }
    return failures;
}

/* The calls of a session, of which init has been called. */
static uint32_t stage31_selftest_calls_of(stage31 *self, const stage31_selftest_session *session)
{
    uint32_t failures = 0U;

    for (uint32_t j = 0U; j < session->count; j++) {
        failures += stage31_selftest_check(self, &stage31_selftest_calls[session->first + j]);
    }
    return failures;
}

/* Every session with its calls. */
static uint32_t stage31_selftest_run(void)
{
    uint32_t failures = 0U;

    for (uint32_t i = 0U; i < 4U; i++) {
        const stage31_selftest_session *session = &stage31_selftest_sessions[i];
        stage31 self;

        if (stage31_init(&self, &session->params) == PTC_OK) {
            failures += stage31_selftest_calls_of(&self, session);
        } else {
            failures++;
        }
    }
    return failures;
}

/* What init must refuse without a change. */
static uint32_t stage31_selftest_refuse(void)
{
    static const stage31_params refused[14] = {
        {.samples = 0U, .h = 0.015625},
        {.samples = 1U, .h = 0.015625},
        {.samples = 60U, .h = (double)NAN},
        {.samples = 60U, .h = (double)INFINITY},
        {.samples = 60U, .h = -(double)INFINITY},
        {.samples = 60U, .h = 0.0},
        {.samples = 60U, .h = -1.0},
        {.samples = 60U, .h = 1.7976931348623157e308},
        {.samples = 60U, .h = -1.7976931348623157e308},
        {.samples = 60U, .h = 5e-324},
        {.samples = 60U, .h = 7.5e-151},
        {.samples = 60U, .h = 1e-150},
        {.samples = 60U, .h = 1e150},
        {.samples = 60U, .h = 1.25e150},
    };
    const stage31_selftest_session *session = &stage31_selftest_sessions[0];
    uint32_t failures = 0U;
    stage31 self;

    if (stage31_init(&self, &session->params) != PTC_OK) {
        failures++;
    }
    for (uint32_t i = 0U; i < 14U; i++) {
        if (stage31_init(&self, &refused[i]) != PTC_E_PARAM) {
            failures++;
        }
    }
    if (stage31_init(&self, NULL) != PTC_E_PARAM) {
        failures++;
    }
    if (stage31_init(NULL, &session->params) != PTC_E_PARAM) {
        failures++;
    }
    failures += stage31_selftest_calls_of(&self, session);
    return failures;
}

/* Calls that lack a pointer: each is refused, and changes nothing. */
static uint32_t stage31_selftest_pointers(void)
{
    const stage31_selftest_session *session = &stage31_selftest_sessions[0];
    const stage31_selftest_call *call = &stage31_selftest_calls[0];
    uint32_t failures = 0U;
    double u[2] = {12345.0, 12345.0};
    ptc_status axes[2] = {PTC_E_PARAM, PTC_E_PARAM};
    stage31 self;

    if (stage31_init(&self, &session->params) != PTC_OK) {
        failures++;
    }
    if (stage31_arm(NULL, call->start) != PTC_E_INPUT) {
        failures++;
    }
    if (stage31_step(NULL, call->k, call->y, call->r, u, axes) != PTC_E_INPUT) {
        failures++;
    }
    for (uint32_t i = 0U; i < 2U; i++) {
        failures += stage31_selftest_differs(u[i], 0.0);
        u[i] = 12345.0;
    }
    if (stage31_step(&self, call->k, call->y, call->r, u, NULL) != PTC_E_INPUT) {
        failures++;
    }
    for (uint32_t i = 0U; i < 2U; i++) {
        failures += stage31_selftest_differs(u[i], 0.0);
        u[i] = 12345.0;
    }
    if (stage31_step(&self, call->k, NULL, call->r, u, axes) != PTC_E_INPUT) {
        failures++;
    }
    for (uint32_t i = 0U; i < 2U; i++) {
        failures += stage31_selftest_differs(u[i], 0.0);
        u[i] = 12345.0;
    }
    if (stage31_step(&self, call->k, call->y, NULL, u, axes) != PTC_E_INPUT) {
        failures++;
    }
    for (uint32_t i = 0U; i < 2U; i++) {
        failures += stage31_selftest_differs(u[i], 0.0);
    }
    if (stage31_step(&self, call->k, call->y, call->r, NULL, axes) != PTC_E_INPUT) {
        failures++;
    }
    failures += stage31_selftest_calls_of(&self, session);
    return failures;
}

uint32_t stage31_selftest(void)
{
    uint32_t failures = stage31_selftest_run();

    failures += stage31_selftest_refuse();
    failures += stage31_selftest_pointers();
    return failures;
}
