/* Self-test of the prescribed-time controller gantry_in_flight: see gantry_in_flight_selftest.h. DO NOT EDIT. */
#include "gantry_in_flight_selftest.h"
#include "gantry_in_flight.h"

#include <math.h>
#include <stddef.h>

/* A call, and what it must give. */
typedef struct gantry_in_flight_selftest_call {
    uint32_t is_armed; /* arm is called before it */
    uint32_t start;
    uint32_t k;
    double y[3][2]; /* what is measured */
    ptc_status status;
    double u[3];
    ptc_status axes[3];
} gantry_in_flight_selftest_call;

/* A set of parameters that init takes, and the calls with it, one after the other. */
typedef struct gantry_in_flight_selftest_session {
    gantry_in_flight_params params;
    uint32_t first; /* of its calls */
    uint32_t count;
} gantry_in_flight_selftest_session;

static const gantry_in_flight_selftest_session gantry_in_flight_selftest_sessions[3] = {
    {.params = {.none = (char)0}, .first = 0U, .count = 72U},
    {.params = {.none = (char)0}, .first = 72U, .count = 12U},
    {.params = {.none = (char)0}, .first = 84U, .count = 42U},
};

static const gantry_in_flight_selftest_call gantry_in_flight_selftest_calls[126] = {
    {.is_armed = 0U, .start = 0U, .k = 0U, .y = {{0.75, 0.25}, {-0.25, -0.75}, {-1.25, -1.75}}, .status = PTC_SATURATED, .u = {-319.8001332445037, 119.93504330446369, 60.0}, .axes = {PTC_OK, PTC_OK, PTC_SATURATED}},
    {.is_armed = 0U, .start = 0U, .k = 1U, .y = {{0.7490003333333333, 0.24966677777777777}, {-0.24966677777777777, -0.7490003333333333}, {-1.2483338888888889, -1.7476674444444444}}, .status = PTC_SATURATED, .u = {-319.7466933333334, 119.87503, 60.0}, .axes = {PTC_OK, PTC_OK, PTC_SATURATED}},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {{0.7480013333333334, 0.2493337777777778}, {-0.2493337777777778, -0.7480013333333334}, {-1.246668888888889, -1.7453364444444446}}, .status = PTC_SATURATED, .u = {-319.69325327996444, 119.81501667778521, 60.0}, .axes = {PTC_OK, PTC_OK, PTC_SATURATED}},
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
    {.is_armed = 0U, .start = 0U, .k = 3U, .y = {{0.747003, 0.249001}, {-0.249001, -0.747003}, {-1.245005, -1.743007}}, .status = PTC_SATURATED, .u = {-319.6398130841121, 119.75500333778372, 60.0}, .axes = {PTC_OK, PTC_OK, PTC_SATURATED}},
    {.is_armed = 0U, .start = 0U, .k = 375U, .y = {{0.421875, 0.140625}, {-0.140625, -0.421875}, {-0.703125, -0.984375}}, .status = PTC_SATURATED, .u = {-299.746891651865, 97.42839698046183, 60.0}, .axes = {PTC_OK, PTC_OK, PTC_SATURATED}},
    {.is_armed = 0U, .start = 0U, .k = 746U, .y = {{0.18950533333333336, 0.06316844444444446}, {-0.06316844444444446, -0.18950533333333336}, {-0.3158422222222223, -0.4421791111111112}}, .status = PTC_SATURATED, .u = {-279.8555055187639, 75.15532450331128, 60.0}, .axes = {PTC_OK, PTC_OK, PTC_SATURATED}},
    {.is_armed = 0U, .start = 0U, .k = 748U, .y = {{0.1885013333333333, 0.06283377777777777}, {-0.06283377777777777, -0.1885013333333333}, {-0.31416888888888883, -0.43983644444444436}}, .status = PTC_SATURATED, .u = {-279.7479946879149, 75.03521912350595, 60.0}, .axes = {PTC_OK, PTC_OK, PTC_SATURATED}},
    {.is_armed = 0U, .start = 0U, .k = 749U, .y = {{0.18800033333333338, 0.0626667777777778}, {-0.0626667777777778, -0.18800033333333338}, {-0.31333388888888897, -0.43866744444444455}}, .status = PTC_SATURATED, .u = {-279.6942375886525, 74.97516622340427, 60.0}, .axes = {PTC_OK, PTC_OK, PTC_SATURATED}},
    {.is_armed = 0U, .start = 0U, .k = 750U, .y = {{0.1875, 0.0625}, {-0.0625, -0.1875}, {-0.3125, -0.4375}}, .status = PTC_SATURATED, .u = {-279.64047936085217, 74.91511318242344, 60.0}, .axes = {PTC_OK, PTC_OK, PTC_SATURATED}},
    {.is_armed = 0U, .start = 0U, .k = 751U, .y = {{0.18700033333333335, 0.06233344444444445}, {-0.06233344444444445, -0.18700033333333335}, {-0.31166722222222226, -0.43633411111111114}}, .status = PTC_SATURATED, .u = {-279.58672, 74.85506000000001, 60.0}, .axes = {PTC_OK, PTC_OK, PTC_SATURATED}},
    {.is_armed = 0U, .start = 0U, .k = 1125U, .y = {{0.046875, 0.015625}, {-0.015625, -0.046875}, {-0.078125, -0.109375}}, .status = PTC_LATE, .u = {-211.57834497951876, 44.40063379918075, 44.838172524181616}, .axes = {PTC_LATE, PTC_LATE, PTC_LATE}},
    {.is_armed = 0U, .start = 0U, .k = 1496U, .y = {{5.333333333333334e-6, 1.7777777777777777e-6}, {-1.7777777777777777e-6, -5.333333333333334e-6}, {-8.888888888888888e-6, -1.2444444444444445e-5}}, .status = PTC_OK, .u = {-3.737971014492754, 0.4950724637681159, 0.6378357487922706}, .axes = {PTC_OK, PTC_OK, PTC_OK}},
    {.is_armed = 0U, .start = 0U, .k = 1498U, .y = {{1.3333333333333334e-6, 4.4444444444444444e-7}, {-4.4444444444444444e-7, -1.3333333333333334e-6}, {-2.222222222222222e-6, -3.111111111111111e-6}}, .status = PTC_OK, .u = {-1.1226016260162603, 0.14794425087108015, 0.19116376306620209}, .axes = {PTC_OK, PTC_OK, PTC_OK}},
    {.is_armed = 0U, .start = 0U, .k = 1499U, .y = {{3.3333333333333335e-7, 1.1111111111111111e-7}, {-1.1111111111111111e-7, -3.3333333333333335e-7}, {-5.555555555555555e-7, -7.777777777777778e-7}}, .status = PTC_OK, .u = {-0.32593792172739544, 0.04279352226720647, 0.055417004048583005}, .axes = {PTC_OK, PTC_OK, PTC_OK}},
    {.is_armed = 0U, .start = 0U, .k = 1500U, .y = {{0.0, 0.0}, {-0.0, -0.0}, {-0.0, -0.0}}, .status = PTC_OK, .u = {0.0, 0.0, 0.0}, .axes = {PTC_OK, PTC_OK, PTC_OK}},
    {.is_armed = 0U, .start = 0U, .k = 1501U, .y = {{0.0, 0.0}, {-0.0, -0.0}, {-0.0, -0.0}}, .status = PTC_OK, .u = {0.0, 0.0, 0.0}, .axes = {PTC_OK, PTC_OK, PTC_OK}},
    {.is_armed = 0U, .start = 0U, .k = 2147483647U, .y = {{0.0, 0.0}, {-0.0, -0.0}, {-0.0, -0.0}}, .status = PTC_HOLD, .u = {0.0, 0.0, 0.0}, .axes = {PTC_HOLD, PTC_HOLD, PTC_HOLD}},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {{0.0, 0.0}, {-0.0, -0.0}, {-0.0, -0.0}}, .status = PTC_HOLD, .u = {0.0, 0.0, 0.0}, .axes = {PTC_HOLD, PTC_HOLD, PTC_HOLD}},
    {.is_armed = 1U, .start = 4294967293U, .k = 4294967293U, .y = {{0.75, 0.25}, {-0.25, -0.75}, {-1.25, -1.75}}, .status = PTC_SATURATED, .u = {-319.8001332445037, 119.93504330446369, 60.0}, .axes = {PTC_OK, PTC_OK, PTC_SATURATED}},
    {.is_armed = 0U, .start = 0U, .k = 4294967294U, .y = {{0.7490003333333333, 0.24966677777777777}, {-0.24966677777777777, -0.7490003333333333}, {-1.2483338888888889, -1.7476674444444444}}, .status = PTC_SATURATED, .u = {-319.7466933333334, 119.87503, 60.0}, .axes = {PTC_OK, PTC_OK, PTC_SATURATED}},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {{0.7480013333333334, 0.2493337777777778}, {-0.2493337777777778, -0.7480013333333334}, {-1.246668888888889, -1.7453364444444446}}, .status = PTC_SATURATED, .u = {-319.69325327996444, 119.81501667778521, 60.0}, .axes = {PTC_OK, PTC_OK, PTC_SATURATED}},
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
    {.is_armed = 0U, .start = 0U, .k = 0U, .y = {{0.747003, 0.249001}, {-0.249001, -0.747003}, {-1.245005, -1.743007}}, .status = PTC_SATURATED, .u = {-319.6398130841121, 119.75500333778372, 60.0}, .axes = {PTC_OK, PTC_OK, PTC_SATURATED}},
    {.is_armed = 0U, .start = 0U, .k = 372U, .y = {{0.421875, 0.140625}, {-0.140625, -0.421875}, {-0.703125, -0.984375}}, .status = PTC_SATURATED, .u = {-299.746891651865, 97.42839698046183, 60.0}, .axes = {PTC_OK, PTC_OK, PTC_SATURATED}},
    {.is_armed = 0U, .start = 0U, .k = 743U, .y = {{0.18950533333333336, 0.06316844444444446}, {-0.06316844444444446, -0.18950533333333336}, {-0.3158422222222223, -0.4421791111111112}}, .status = PTC_SATURATED, .u = {-279.8555055187639, 75.15532450331128, 60.0}, .axes = {PTC_OK, PTC_OK, PTC_SATURATED}},
    {.is_armed = 0U, .start = 0U, .k = 745U, .y = {{0.1885013333333333, 0.06283377777777777}, {-0.06283377777777777, -0.1885013333333333}, {-0.31416888888888883, -0.43983644444444436}}, .status = PTC_SATURATED, .u = {-279.7479946879149, 75.03521912350595, 60.0}, .axes = {PTC_OK, PTC_OK, PTC_SATURATED}},
    {.is_armed = 0U, .start = 0U, .k = 746U, .y = {{0.18800033333333338, 0.0626667777777778}, {-0.0626667777777778, -0.18800033333333338}, {-0.31333388888888897, -0.43866744444444455}}, .status = PTC_SATURATED, .u = {-279.6942375886525, 74.97516622340427, 60.0}, .axes = {PTC_OK, PTC_OK, PTC_SATURATED}},
    {.is_armed = 0U, .start = 0U, .k = 747U, .y = {{0.1875, 0.0625}, {-0.0625, -0.1875}, {-0.3125, -0.4375}}, .status = PTC_SATURATED, .u = {-279.64047936085217, 74.91511318242344, 60.0}, .axes = {PTC_OK, PTC_OK, PTC_SATURATED}},
    {.is_armed = 0U, .start = 0U, .k = 748U, .y = {{0.18700033333333335, 0.06233344444444445}, {-0.06233344444444445, -0.18700033333333335}, {-0.31166722222222226, -0.43633411111111114}}, .status = PTC_SATURATED, .u = {-279.58672, 74.85506000000001, 60.0}, .axes = {PTC_OK, PTC_OK, PTC_SATURATED}},
    {.is_armed = 0U, .start = 0U, .k = 1122U, .y = {{0.046875, 0.015625}, {-0.015625, -0.046875}, {-0.078125, -0.109375}}, .status = PTC_LATE, .u = {-211.57834497951876, 44.40063379918075, 44.838172524181616}, .axes = {PTC_LATE, PTC_LATE, PTC_LATE}},
    {.is_armed = 0U, .start = 0U, .k = 1493U, .y = {{5.333333333333334e-6, 1.7777777777777777e-6}, {-1.7777777777777777e-6, -5.333333333333334e-6}, {-8.888888888888888e-6, -1.2444444444444445e-5}}, .status = PTC_OK, .u = {-3.737971014492754, 0.4950724637681159, 0.6378357487922706}, .axes = {PTC_OK, PTC_OK, PTC_OK}},
    {.is_armed = 0U, .start = 0U, .k = 1495U, .y = {{1.3333333333333334e-6, 4.4444444444444444e-7}, {-4.4444444444444444e-7, -1.3333333333333334e-6}, {-2.222222222222222e-6, -3.111111111111111e-6}}, .status = PTC_OK, .u = {-1.1226016260162603, 0.14794425087108015, 0.19116376306620209}, .axes = {PTC_OK, PTC_OK, PTC_OK}},
    {.is_armed = 0U, .start = 0U, .k = 1496U, .y = {{3.3333333333333335e-7, 1.1111111111111111e-7}, {-1.1111111111111111e-7, -3.3333333333333335e-7}, {-5.555555555555555e-7, -7.777777777777778e-7}}, .status = PTC_OK, .u = {-0.32593792172739544, 0.04279352226720647, 0.055417004048583005}, .axes = {PTC_OK, PTC_OK, PTC_OK}},
    {.is_armed = 0U, .start = 0U, .k = 1497U, .y = {{0.0, 0.0}, {-0.0, -0.0}, {-0.0, -0.0}}, .status = PTC_OK, .u = {0.0, 0.0, 0.0}, .axes = {PTC_OK, PTC_OK, PTC_OK}},
    {.is_armed = 0U, .start = 0U, .k = 1498U, .y = {{0.0, 0.0}, {-0.0, -0.0}, {-0.0, -0.0}}, .status = PTC_OK, .u = {0.0, 0.0, 0.0}, .axes = {PTC_OK, PTC_OK, PTC_OK}},
    {.is_armed = 0U, .start = 0U, .k = 2147483644U, .y = {{0.0, 0.0}, {-0.0, -0.0}, {-0.0, -0.0}}, .status = PTC_HOLD, .u = {0.0, 0.0, 0.0}, .axes = {PTC_HOLD, PTC_HOLD, PTC_HOLD}},
    {.is_armed = 0U, .start = 0U, .k = 4294967292U, .y = {{0.0, 0.0}, {-0.0, -0.0}, {-0.0, -0.0}}, .status = PTC_HOLD, .u = {0.0, 0.0, 0.0}, .axes = {PTC_HOLD, PTC_HOLD, PTC_HOLD}},
    {.is_armed = 0U, .start = 0U, .k = 3U, .y = {{0.8111764966162411, 0.7514300992031775}, {0.7811344378625003, -0.7421766469241432}, {0.8794984877586897, -0.3693844935953414}}, .status = PTC_OK, .u = {-501.2628110065405, -4.854382103585842, -16.399941107366338}, .axes = {PTC_OK, PTC_OK, PTC_OK}},
    {.is_armed = 0U, .start = 0U, .k = 5U, .y = {{0.30127749860943803, 0.6505498683401041}, {0.45995171680524205, -0.2665124626231072}, {0.3400124240851669, -0.8675016873437242}}, .status = PTC_OK, .u = {-305.7573598733098, -23.45450377582994, 16.892957170023855}, .axes = {PTC_OK, PTC_OK, PTC_OK}},
    {.is_armed = 0U, .start = 0U, .k = 7U, .y = {{0.9556294748061022, 0.34506260289243135}, {-0.8035662514816649, 0.5410809886740985}, {-0.9646680068891444, 0.3204289005727139}}, .status = PTC_LATE, .u = {-90.02311071741501, -10.640843510121401, 0.7143888885650751}, .axes = {PTC_LATE, PTC_LATE, PTC_LATE}},
    {.is_armed = 0U, .start = 0U, .k = 622U, .y = {{0.3086189130116914, -0.28508328951365913}, {0.2771269062803857, -0.5419884799999384}, {0.803803356828326, 0.6615825205792296}}, .status = PTC_OK, .u = {21.062368861074273, 23.085962749246978, -15.452886377577174}, .axes = {PTC_OK, PTC_OK, PTC_OK}},
    {.is_armed = 0U, .start = 0U, .k = 625U, .y = {{-0.29700832435185753, -0.5674679036919925}, {-0.910475470057037, -0.2779631428392062}, {-0.504546680423941, 0.8431361034848143}}, .status = PTC_OK, .u = {105.38583894865323, 39.33464056253302, -9.071624781660766}, .axes = {PTC_OK, PTC_OK, PTC_OK}},
    {.is_armed = 0U, .start = 0U, .k = 635U, .y = {{-0.37851331975676394, -0.44048482551721685}, {-0.713897748569184, -0.5686989966532972}, {0.9282039398907171, -0.5987115159898813}}, .status = PTC_OK, .u = {92.47718094676407, 50.6908784268397, 2.460507500653861}, .axes = {PTC_OK, PTC_OK, PTC_OK}},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {{0.3216378160844725, 0.5618847023595648}, {-0.6642529484983073, -0.8930353123528995}, {-0.25705509601605847, -0.8945530449012826}}, .status = PTC_SATURATED, .u = {-900.0, 400.0, 60.0}, .axes = {PTC_SATURATED, PTC_SATURATED, PTC_SATURATED}},
    {.is_armed = 1U, .start = 0U, .k = 662U, .y = {{-412.9788050858926, 553.8873213902269}, {880.4389237459071, -495.49428495294245}, {660.6332989117235, -680.4766439408766}}, .status = PTC_SATURATED, .u = {900.0, -400.0, -150.0}, .axes = {PTC_SATURATED, PTC_SATURATED, PTC_SATURATED}},
    {.is_armed = 1U, .start = 4294967290U, .k = 694U, .y = {{639.1848948772949, -382.96314302746987}, {662.3055038387788, -885.776094832828}, {-896.0643063479205, -556.8966290319422}}, .status = PTC_SATURATED, .u = {-900.0, -400.0, 60.0}, .axes = {PTC_SATURATED, PTC_SATURATED, PTC_SATURATED}},
    {.is_armed = 1U, .start = 4294967290U, .k = 1390U, .y = {{-0.9324970284726094, -0.6570265821720266}, {0.5682432004351232, 0.6235618278495301}, {0.39639603076295166, 0.8381022113576134}}, .status = PTC_SATURATED, .u = {900.0, -400.0, -150.0}, .axes = {PTC_SATURATED, PTC_SATURATED, PTC_SATURATED}},
    {.is_armed = 0U, .start = 0U, .k = 1493U, .y = {{1.5400076354453993e308, -5.191309070330346e307}, {-7.820109685766342e307, 8.750131425266113e307}, {6.91130549733665e307, -8.127599692841576e307}}, .status = PTC_E_RANGE, .u = {0.0, 0.0, 0.0}, .axes = {PTC_E_RANGE, PTC_E_RANGE, PTC_E_RANGE}},
    {.is_armed = 1U, .start = 4294967290U, .k = 1478U, .y = {{6.123470097842835e307, -1.1362938886667704e308}, {-9.03834335541031e307, -1.0190524117185873e308}, {9.234794889430957e307, -1.125580863961523e308}}, .status = PTC_E_RANGE, .u = {0.0, 0.0, 0.0}, .axes = {PTC_E_RANGE, PTC_E_RANGE, PTC_E_RANGE}},
    {.is_armed = 0U, .start = 0U, .k = 1472U, .y = {{-0.00034527937692695356, -0.0005037144257660775}, {0.00032053738963331446, -0.0002675461989197067}, {0.000758318602799588, -0.000590103801722003}}, .status = PTC_OK, .u = {624.824120194898, -210.67431174649855, -133.0150610084595}, .axes = {PTC_OK, PTC_OK, PTC_OK}},
    {.is_armed = 1U, .start = 0U, .k = 1499U, .y = {{-0.0008728538095064095, -0.00028111111809654774}, {-0.00046306828474945906, -0.0007799410244380457}, {0.000590803021094454, -0.000849427583015188}}, .status = PTC_LATE, .u = {771.3448084697624, 157.60990050526752, -50.38370951129124}, .axes = {PTC_LATE, PTC_LATE, PTC_LATE}},
    {.is_armed = 1U, .start = 0U, .k = 2147483647U, .y = {{0.47112996083167, 0.7303214034365219}, {-0.6478429215309119, 0.6464509388713282}, {-0.5663295190622306, -0.7028550881924942}}, .status = PTC_SATURATED, .u = {-900.0, 400.0, 60.0}, .axes = {PTC_SATURATED, PTC_SATURATED, PTC_SATURATED}},
    {.is_armed = 0U, .start = 0U, .k = 678U, .y = {{-0.8372807281758503, -0.6389339193194168}, {0.914304850668984, -0.34315365918444235}, {0.8602737442597256, 0.4835957480611516}}, .status = PTC_SATURATED, .u = {900.0, -289.8331313440417, -119.77168949156072}, .axes = {PTC_SATURATED, PTC_OK, PTC_OK}},
    {.is_armed = 1U, .start = 0U, .k = 1492U, .y = {{-0.45621165351822035, 0.5537829405642949}, {-0.4133111779527003, -0.8003469325490956}, {0.5044879084694965, -0.49331979991561925}}, .status = PTC_SATURATED, .u = {900.0, 400.0, -150.0}, .axes = {PTC_SATURATED, PTC_SATURATED, PTC_SATURATED}},
    {.is_armed = 1U, .start = 4294967290U, .k = 1469U, .y = {{0.6624746374995405, -0.26104081582941585}, {-0.2724308176912412, -0.77002952956296}, {0.557947837838361, -0.31184286912042336}}, .status = PTC_LATE, .u = {-40.19323421628557, 77.2490169562436, -1.3986396941363506}, .axes = {PTC_LATE, PTC_LATE, PTC_LATE}},
    {.is_armed = 1U, .start = 4294967290U, .k = 1455U, .y = {{-0.7636918946231968, -0.6408352864204856}, {-0.9834352353353737, -0.41440537717166004}, {0.34697332013200843, -0.49752213027595704}}, .status = PTC_SATURATED, .u = {900.0, 400.0, -150.0}, .axes = {PTC_SATURATED, PTC_SATURATED, PTC_SATURATED}},
    {.is_armed = 0U, .start = 0U, .k = 665U, .y = {{0.31590413175345844, 0.5124424551497744}, {0.957049309468695, 0.7962377812792139}, {-0.9057104607011919, -0.8943427370122726}}, .status = PTC_SATURATED, .u = {-627.005347872028, -400.0, 60.0}, .axes = {PTC_OK, PTC_SATURATED, PTC_SATURATED}},
    {.is_armed = 0U, .start = 0U, .k = 660U, .y = {{-0.000302366176164409, 0.000263360435069762}, {-0.0003427721411407226, -0.0005702878045569542}, {0.0009383452290751952, -0.0008485077497003317}}, .status = PTC_OK, .u = {0.19404851606611773, 0.2822899864261285, -0.0583059573279798}, .axes = {PTC_OK, PTC_OK, PTC_OK}},
    {.is_armed = 0U, .start = 0U, .k = 1451U, .y = {{0.0009594236299364039, 0.0009938822003268584}, {0.0008950297399955536, -0.00042277847358310596}, {-0.0002971276529309579, 0.0003824216969332213}}, .status = PTC_LATE, .u = {-781.6306892836686, -264.9622102476005, 23.050907425543674}, .axes = {PTC_LATE, PTC_LATE, PTC_LATE}},
    {.is_armed = 0U, .start = 0U, .k = 683U, .y = {{-0.4057334036392843, -0.7193173867786674}, {0.9769957786361778, 0.611532376043648}, {0.7610974444670916, -0.3788111750331965}}, .status = PTC_SATURATED, .u = {872.1935270499935, -400.0, -61.17058816499735}, .axes = {PTC_OK, PTC_SATURATED, PTC_OK}},
    {.is_armed = 1U, .start = 4294967290U, .k = 729U, .y = {{0.8957171350488141, -0.47625617284468136}, {-0.7031472896816179, 0.8746533544474702}, {-0.5755920692941818, -0.8388405026605518}}, .status = PTC_SATURATED, .u = {-802.0237885046464, 118.38195516249432, 60.0}, .axes = {PTC_OK, PTC_OK, PTC_SATURATED}},
    {.is_armed = 0U, .start = 0U, .k = 743U, .y = {{0.0007413871000106237, -0.0008162142090514468}, {0.0007125599064621794, -0.000516770373242224}, {0.00028790135880492427, 0.000702718073131431}}, .status = PTC_OK, .u = {-0.5173364634632298, -0.2547360209622773, -0.08944068078194954}, .axes = {PTC_OK, PTC_OK, PTC_OK}},
    {.is_armed = 0U, .start = 0U, .k = 1466U, .y = {{0.0005437318045378361, -0.000812022569758661}, {0.0005891892061659828, -0.0006602194246558233}, {0.00031137105541571906, 0.0009112059359905085}}, .status = PTC_LATE, .u = {-771.0175955418051, -315.1573938964329, -47.24923752922818}, .axes = {PTC_LATE, PTC_LATE, PTC_LATE}},
    {.is_armed = 0U, .start = 0U, .k = 1479U, .y = {{-0.0005769919496911336, 0.000802086242364283}, {0.00037135028768279707, -0.0006133594521077888}, {0.0007206277754356292, -0.0005776673251499755}}, .status = PTC_LATE, .u = {769.3071406545068, -184.87663795691205, -97.00705884998585}, .axes = {PTC_LATE, PTC_LATE, PTC_LATE}},
    {.is_armed = 1U, .start = 4294967290U, .k = 1475U, .y = {{-0.0008244289129498686, -0.0008771122923613368}, {-0.0006882842982288716, -0.0008191861556552155}, {-0.0009027643830073829, -0.0004026414679711976}}, .status = PTC_LATE, .u = {497.19271686625257, 156.12708321751393, 53.64024091921043}, .axes = {PTC_LATE, PTC_LATE, PTC_LATE}},
    {.is_armed = 0U, .start = 0U, .k = 1119U, .y = {{0.38861413846201376, 0.549674271227911}, {0.9936690453613887, 0.4237716599327091}, {-0.8639088020148598, -0.9221068447669781}}, .status = PTC_SATURATED, .u = {-900.0, -400.0, 60.0}, .axes = {PTC_SATURATED, PTC_SATURATED, PTC_SATURATED}},
    {.is_armed = 1U, .start = 4294967290U, .k = 667U, .y = {{0.7607828084613375, -0.7643424681788067}, {-0.7514722701893807, -0.9016320429840752}, {-0.9827626412529169, -0.5240597417357074}}, .status = PTC_SATURATED, .u = {-356.70883472028356, 400.0, 60.0}, .axes = {PTC_OK, PTC_SATURATED, PTC_SATURATED}},
    {.is_armed = 1U, .start = 4294967290U, .k = 1476U, .y = {{-0.00028668968240474623, 0.0005177069948528795}, {0.0007232669893254746, 0.0009750136597642752}, {-0.0004470379273494113, -0.0005872470430846355}}, .status = PTC_LATE, .u = {317.29121142265234, -317.2841693020069, 52.264542926101996}, .axes = {PTC_LATE, PTC_LATE, PTC_LATE}},
    {.is_armed = 0U, .start = 0U, .k = 1489U, .y = {{0.0008771978020783268, -0.0009423101420617873}, {-0.0005097831602113795, -0.0003049165008076914}, {0.0006261818022403017, -0.0007193036737853384}}, .status = PTC_LATE, .u = {-792.7594655151895, 178.5215879920833, -56.50665051706039}, .axes = {PTC_LATE, PTC_LATE, PTC_LATE}},
    {.is_armed = 1U, .start = 4294967290U, .k = 1369U, .y = {{-0.29020626403422434, 0.9758652174485316}, {0.4212180905731948, 0.9913129499637561}, {0.919377412657671, 0.8637860659085266}}, .status = PTC_SATURATED, .u = {900.0, -400.0, -150.0}, .axes = {PTC_SATURATED, PTC_SATURATED, PTC_SATURATED}},
    {.is_armed = 1U, .start = 4294967290U, .k = 626U, .y = {{0.2883524122323836, -0.4684051135747644}, {-0.5386877955843351, -0.5832186769602566}, {0.34120410699127546, -0.6167421342763878}}, .status = PTC_OK, .u = {-16.440876575513762, 313.6637213923841, 1.5069091077870418}, .axes = {PTC_OK, PTC_OK, PTC_OK}},
    {.is_armed = 1U, .start = 4294967290U, .k = 1487U, .y = {{-0.00035126578463676004, 0.0005191850596185499}, {-0.0008446210157774103, -0.0006775510829253857}, {-0.0008086812584231603, -0.0005322317777006862}}, .status = PTC_LATE, .u = {216.4244270653558, 205.98114883072904, 52.416300331859134}, .axes = {PTC_LATE, PTC_LATE, PTC_LATE}},
    {.is_armed = 1U, .start = 4294967290U, .k = 666U, .y = {{-0.39692241305870823, -0.31336843586328833}, {0.5349089294906528, 0.9466653777277391}, {-0.6955064639393724, 0.7116136953389924}}, .status = PTC_SATURATED, .u = {597.8434129416135, -400.0, 31.73830196986334}, .axes = {PTC_OK, PTC_SATURATED, PTC_OK}},
    {.is_armed = 1U, .start = 4294967290U, .k = 724U, .y = {{0.43462611640638493, 0.6447521348375065}, {-0.46832318699559805, 0.6589206094925413}, {0.7242935094901216, 0.47455620795468534}}, .status = PTC_SATURATED, .u = {-900.0, 59.10895377182286, -117.39590143310151}, .axes = {PTC_SATURATED, PTC_OK, PTC_OK}},
    {.is_armed = 1U, .start = 4294967290U, .k = 4294967289U, .y = {{0.0005830813106607797, 0.0009936213668845697}, {-0.0007589263814614889, -0.0005271216131697195}, {0.0005476187494481848, -0.0005293583131595471}}, .status = PTC_SATURATED, .u = {-900.0, 400.0, -150.0}, .axes = {PTC_SATURATED, PTC_SATURATED, PTC_SATURATED}},
    {.is_armed = 0U, .start = 0U, .k = 1370U, .y = {{-0.7884371440294189, 0.9638282387325322}, {-0.6433659154090021, 0.40989754452123356}, {0.7453946556976119, -0.4946903506811181}}, .status = PTC_SATURATED, .u = {900.0, 400.0, -150.0}, .axes = {PTC_SATURATED, PTC_SATURATED, PTC_SATURATED}},
    {.is_armed = 0U, .start = 0U, .k = 743U, .y = {{0.0, 7.39887815432314e153}, {-9.361501886913993e153, -0.0005045198926567742}, {-2.0, -1.7650222231876494e308}}, .status = PTC_E_RANGE, .u = {0.0, 0.0, 0.0}, .axes = {PTC_OK, PTC_OK, PTC_E_RANGE}},
    {.is_armed = 1U, .start = 4294967290U, .k = 745U, .y = {{1.7164259859726085e308, -2.0}, {1.2791671525647247e302, 0.00043104518389769695}, {0.0, -1.0}}, .status = PTC_E_RANGE, .u = {0.0, 0.0, 0.0}, .axes = {PTC_E_RANGE, PTC_E_RANGE, PTC_OK}},
    {.is_armed = 1U, .start = 4294967290U, .k = 1407U, .y = {{0.5, -0.0}, {-9.405364793374078e153, -0.0006848429497021841}, {-0.0009575467696541466, -2.0}}, .status = PTC_SATURATED, .u = {-900.0, 400.0, 60.0}, .axes = {PTC_SATURATED, PTC_SATURATED, PTC_SATURATED}},
    {.is_armed = 1U, .start = 4294967290U, .k = 1374U, .y = {{874.3690031532926, 1.0}, {0.0004965992291215297, 995.3894689502754}, {7.615809196047807e307, 748.4647812043363}}, .status = PTC_E_RANGE, .u = {0.0, 0.0, 0.0}, .axes = {PTC_OK, PTC_OK, PTC_E_RANGE}},
    {.is_armed = 1U, .start = 4294967290U, .k = 1376U, .y = {{-0.000600670289319244, -2.0}, {1.5572953728892743e302, -2.0}, {-1.0, 2.0}}, .status = PTC_E_RANGE, .u = {0.0, 0.0, 0.0}, .axes = {PTC_OK, PTC_E_RANGE, PTC_OK}},
    {.is_armed = 1U, .start = 4294967290U, .k = 4294967289U, .y = {{0.00048602850911654607, 0.0}, {2.0, 0.5}, {-2.0, -1.0}}, .status = PTC_SATURATED, .u = {-900.0, -400.0, 60.0}, .axes = {PTC_SATURATED, PTC_SATURATED, PTC_SATURATED}},
    {.is_armed = 0U, .start = 0U, .k = 655U, .y = {{0.3542098753708095, 2.0}, {1.0, 1.0}, {0.0006039361069419756, -0.0009906995264964502}}, .status = PTC_SATURATED, .u = {-900.0, -400.0, -0.0050713150213395255}, .axes = {PTC_SATURATED, PTC_SATURATED, PTC_OK}},
    {.is_armed = 1U, .start = 4294967290U, .k = 1446U, .y = {{-0.0, -0.0}, {0.0, 0.0}, {-4.9049132367296765e153, 0.5896501937566458}}, .status = PTC_SATURATED, .u = {0.0, 0.0, 60.0}, .axes = {PTC_OK, PTC_OK, PTC_SATURATED}},
    {.is_armed = 1U, .start = 4294967290U, .k = 1421U, .y = {{-2.0, 2.0}, {0.5, -0.5}, {882.2316441133622, 1.6018361408620662e308}}, .status = PTC_E_RANGE, .u = {0.0, 0.0, 0.0}, .axes = {PTC_OK, PTC_OK, PTC_E_RANGE}},
    {.is_armed = 1U, .start = 4294967290U, .k = 1455U, .y = {{2.0, -2.0}, {-0.0, -0.0}, {-2.0, -1.1594565433618075e154}}, .status = PTC_SATURATED, .u = {-900.0, 0.0, 60.0}, .axes = {PTC_SATURATED, PTC_OK, PTC_SATURATED}},
    {.is_armed = 1U, .start = 4294967290U, .k = 730U, .y = {{2.0, -2.0}, {-0.5, -2.0}, {-467.03753085242806, -0.5195408597037074}}, .status = PTC_SATURATED, .u = {-900.0, 400.0, 60.0}, .axes = {PTC_SATURATED, PTC_SATURATED, PTC_SATURATED}},
    {.is_armed = 1U, .start = 4294967290U, .k = 4294967289U, .y = {{-0.5, -0.0}, {0.5, 0.6132775503686719}, {0.0, 0.0}}, .status = PTC_SATURATED, .u = {900.0, -400.0, 0.0}, .axes = {PTC_SATURATED, PTC_SATURATED, PTC_HOLD}},
    {.is_armed = 1U, .start = 4294967290U, .k = 1479U, .y = {{-0.0, 0.32806492216023003}, {3.77399547067593e153, -0.0}, {2.0, 1.4310259693370568e308}}, .status = PTC_E_RANGE, .u = {0.0, 0.0, 0.0}, .axes = {PTC_HOLD, PTC_HOLD, PTC_E_RANGE}},
    {.is_armed = 0U, .start = 0U, .k = 1470U, .y = {{0.0, -0.0005484224202942518}, {-2.0, -0.0007428147153839237}, {2.0, -0.0007098052066699673}}, .status = PTC_LATE, .u = {0.026388267773074556, 5.439960740344586, -1.4436666721875249}, .axes = {PTC_LATE, PTC_LATE, PTC_LATE}},
    {.is_armed = 1U, .start = 4294967290U, .k = 1474U, .y = {{0.0006392021192665878, 1.0}, {6.550860981196275e153, -0.0}, {-0.0, -4.441735390443889e153}}, .status = PTC_SATURATED, .u = {-900.0, -400.0, 60.0}, .axes = {PTC_SATURATED, PTC_SATURATED, PTC_SATURATED}},
};

/* 1 where a number is not the one that must come. */
static uint32_t gantry_in_flight_selftest_differs(double value, double wanted)
{
    uint32_t failures = 1U;

    if (fabs(value - wanted) <= 0.0) {
        failures = 0U;
    }
    return failures;
}

/* The failures of one call. */
static uint32_t gantry_in_flight_selftest_check(gantry_in_flight *self, const gantry_in_flight_selftest_call *call)
{
    uint32_t failures = 0U;
    double u[3] = {12345.0, 12345.0, 12345.0};
    ptc_status axes[3] = {PTC_E_PARAM, PTC_E_PARAM, PTC_E_PARAM};

    if (call->is_armed != 0U) {
        if (gantry_in_flight_arm(self, call->start) != PTC_OK) {
            failures++;
        }
    }
    if (gantry_in_flight_step(self, call->k, call->y, u, axes) != call->status) {
        failures++;
    }
    for (uint32_t i = 0U; i < 3U; i++) {
        failures += gantry_in_flight_selftest_differs(u[i], call->u[i]);
        if (axes[i] != call->axes[i]) {
            failures++;
        }
    }
    return failures;
}

/* The calls of a session, of which init has been called. */
static uint32_t gantry_in_flight_selftest_calls_of(gantry_in_flight *self, const gantry_in_flight_selftest_session *session)
{
    uint32_t failures = 0U;

    for (uint32_t j = 0U; j < session->count; j++) {
        failures += gantry_in_flight_selftest_check(self, &gantry_in_flight_selftest_calls[session->first + j]);
    }
    return failures;
}

/* Every session with its calls. */
static uint32_t gantry_in_flight_selftest_run(void)
{
    uint32_t failures = 0U;

    for (uint32_t i = 0U; i < 3U; i++) {
        const gantry_in_flight_selftest_session *session = &gantry_in_flight_selftest_sessions[i];
        gantry_in_flight self;

        if (gantry_in_flight_init(&self, &session->params) == PTC_OK) {
            failures += gantry_in_flight_selftest_calls_of(&self, session);
        } else {
            failures++;
        }
    }
    return failures;
}

/* What init must refuse without a change. */
static uint32_t gantry_in_flight_selftest_refuse(void)
{
    const gantry_in_flight_selftest_session *session = &gantry_in_flight_selftest_sessions[0];
    uint32_t failures = 0U;
    gantry_in_flight self;

    if (gantry_in_flight_init(&self, &session->params) != PTC_OK) {
        failures++;
    }
    if (gantry_in_flight_init(NULL, &session->params) != PTC_E_PARAM) {
        failures++;
    }
    failures += gantry_in_flight_selftest_calls_of(&self, session);
    return failures;
}

/* Calls that lack a pointer: each is refused, and changes nothing. */
static uint32_t gantry_in_flight_selftest_pointers(void)
{
    const gantry_in_flight_selftest_session *session = &gantry_in_flight_selftest_sessions[0];
    const gantry_in_flight_selftest_call *call = &gantry_in_flight_selftest_calls[0];
    uint32_t failures = 0U;
    double u[3] = {12345.0, 12345.0, 12345.0};
    ptc_status axes[3] = {PTC_E_PARAM, PTC_E_PARAM, PTC_E_PARAM};
    gantry_in_flight self;

    if (gantry_in_flight_init(&self, &session->params) != PTC_OK) {
        failures++;
    }
    if (gantry_in_flight_arm(NULL, call->start) != PTC_E_INPUT) {
        failures++;
    }
    if (gantry_in_flight_step(NULL, call->k, call->y, u, axes) != PTC_E_INPUT) {
        failures++;
    }
    for (uint32_t i = 0U; i < 3U; i++) {
        failures += gantry_in_flight_selftest_differs(u[i], 0.0);
        u[i] = 12345.0;
    }
    if (gantry_in_flight_step(&self, call->k, call->y, u, NULL) != PTC_E_INPUT) {
        failures++;
    }
    for (uint32_t i = 0U; i < 3U; i++) {
        failures += gantry_in_flight_selftest_differs(u[i], 0.0);
        u[i] = 12345.0;
    }
    if (gantry_in_flight_step(&self, call->k, NULL, u, axes) != PTC_E_INPUT) {
        failures++;
    }
    for (uint32_t i = 0U; i < 3U; i++) {
        failures += gantry_in_flight_selftest_differs(u[i], 0.0);
    }
    if (gantry_in_flight_step(&self, call->k, call->y, NULL, axes) != PTC_E_INPUT) {
        failures++;
    }
    failures += gantry_in_flight_selftest_calls_of(&self, session);
    return failures;
}

uint32_t gantry_in_flight_selftest(void)
{
    uint32_t failures = gantry_in_flight_selftest_run();

    failures += gantry_in_flight_selftest_refuse();
    failures += gantry_in_flight_selftest_pointers();
    return failures;
}
