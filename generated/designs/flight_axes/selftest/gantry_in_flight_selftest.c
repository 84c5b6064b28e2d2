/* Self-test of the prescribed-time controller gantry_in_flight: see gantry_in_flight_selftest.h. DO NOT EDIT. */
#include "gantry_in_flight_selftest.h"
#include "gantry_in_flight.h"

#include <math.h>
#include <stddef.h>

/* A call, and what it must give. */
typedef struct gantry_in_flight_selftest_call {
    uint32_t is_armed; /* arm is called before it */
    uint32_t start;
    uint32_t command; /* called before it: 0 none, 1 arm_for, 2 soonest, 3 deadline */
    uint32_t samples;
    ptc_status told; /* its status */
    uint32_t found; /* its result */
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

static const gantry_in_flight_selftest_session gantry_in_flight_selftest_sessions[4] = {
    {.params = {.none = (char)0}, .first = 0U, .count = 72U},
    {.params = {.none = (char)0}, .first = 72U, .count = 12U},
    {.params = {.none = (char)0}, .first = 84U, .count = 42U},
    {.params = {.none = (char)0}, .first = 126U, .count = 69U},
};

static const gantry_in_flight_selftest_call gantry_in_flight_selftest_calls[195] = {
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
    {.command = 1U, .samples = 1024U, .told = PTC_OK, .found = 0U, .is_armed = 0U, .start = 0U, .k = 1U, .y = {{-0.00072295608960516, 0.0007510609055258779}, {-0.06050119534338519, 0.0003979917457955755}, {-0.004859096837769994, 0.026655931956754864}}, .status = PTC_OK, .u = {0.18898433916572094, 17.631950073070545, -0.9525345163797537}, .axes = {PTC_OK, PTC_OK, PTC_OK}},
    {.command = 2U, .samples = 1024U, .told = PTC_E_SOON, .found = 0U, .is_armed = 0U, .start = 0U, .k = 7U, .y = {{-0.4998608147540624, 62.2417032887435}, {0.6335301474399562, 0.030857288929399762}, {0.1353441260511874, -0.09502161936531091}}, .status = PTC_SATURATED, .u = {-900.0, -193.56728027675868, -5.918762358849254}, .axes = {PTC_SATURATED, PTC_OK, PTC_OK}},
    {.command = 3U, .samples = 1024U, .told = PTC_OK, .found = 961U, .is_armed = 0U, .start = 0U, .k = 1U, .y = {{0.04961536227317043, 0.022266740184153002}, {-0.00014753941369078172, 82.61400047645222}, {-0.00033170296285123203, -57.98340437538876}}, .status = PTC_SATURATED, .u = {-49.846347904052315, -400.0, 60.0}, .axes = {PTC_OK, PTC_SATURATED, PTC_SATURATED}},
    {.command = 2U, .samples = 2147483648U, .told = PTC_E_INPUT, .found = 0U, .is_armed = 0U, .start = 0U, .k = 7U, .y = {{-10.320080461384906, 0.0009818505872046875}, {0.18008812637274563, -45.7912050160868}, {0.0004394524576973364, (double)NAN}}, .status = PTC_E_INPUT, .u = {0.0, 0.0, 0.0}, .axes = {PTC_E_INPUT, PTC_E_INPUT, PTC_E_INPUT}},
    {.command = 1U, .samples = 0U, .told = PTC_E_PARAM, .found = 0U, .is_armed = 0U, .start = 0U, .k = 1U, .y = {{-0.0009774098921925842, 1.7976931348623157e308}, {-0.0964299023035064, 91.85619996141784}, {1.7976931348623157e308, -0.000144027558260724}}, .status = PTC_E_RANGE, .u = {0.0, 0.0, 0.0}, .axes = {PTC_E_RANGE, PTC_OK, PTC_E_RANGE}},
    {.command = 2U, .samples = 1U, .told = PTC_OK, .found = 109U, .is_armed = 0U, .start = 0U, .k = 750U, .y = {{0.00023094211044115664, 0.0016271412516393414}, {0.006319775584974297, 0.1300845554959491}, {-0.00046874365714677605, 0.07387990709527525}}, .status = PTC_OK, .u = {-8.149766027705002, -161.11889677721953, -16.986235536370526}, .axes = {PTC_OK, PTC_OK, PTC_OK}},
    {.command = 2U, .samples = 2147483648U, .told = PTC_E_INPUT, .found = 0U, .is_armed = 0U, .start = 0U, .k = 1U, .y = {{(double)INFINITY, 0.0008433661579489211}, {1.7976931348623157e308, -0.09635941836980105}, {0.0008947642094283952, 55.16583131014874}}, .status = PTC_E_INPUT, .u = {0.0, 0.0, 0.0}, .axes = {PTC_E_INPUT, PTC_E_INPUT, PTC_E_INPUT}},
    {.command = 1U, .samples = 4294967295U, .told = PTC_E_PARAM, .found = 0U, .is_armed = 0U, .start = 0U, .k = 750U, .y = {{0.016618640837405763, 44.79794729816524}, {1.7976931348623157e308, -0.0002515286423264875}, {-61.33238788016906, -0.08108936854939786}}, .status = PTC_E_RANGE, .u = {0.0, 0.0, 0.0}, .axes = {PTC_OK, PTC_E_RANGE, PTC_OK}},
    {.command = 2U, .samples = 200U, .told = PTC_E_INPUT, .found = 0U, .is_armed = 0U, .start = 0U, .k = 750U, .y = {{-0.3985675040458019, 0.00036630416994698625}, {(double)INFINITY, 0.0007073396924242697}, {-0.4407997087132647, 1.7976931348623157e308}}, .status = PTC_E_INPUT, .u = {0.0, 0.0, 0.0}, .axes = {PTC_E_INPUT, PTC_E_INPUT, PTC_E_INPUT}},
    {.command = 2U, .samples = 2147483648U, .told = PTC_OK, .found = 399U, .is_armed = 0U, .start = 0U, .k = 7U, .y = {{0.058658089598045665, 0.04707826832600903}, {-1.20256915095871e-5, -0.7979001202632059}, {-0.00012285087396080163, -0.0008926455442764465}}, .status = PTC_OK, .u = {-79.67634907489338, 162.51850893543886, 0.05981493497117748}, .axes = {PTC_OK, PTC_OK, PTC_OK}},
    {.command = 2U, .samples = 200U, .told = PTC_OK, .found = 873U, .is_armed = 0U, .start = 0U, .k = 1U, .y = {{0.0240527508822487, 0.016972903151915488}, {-0.692646216121108, 0.0003543034637704017}, {0.07506101499332196, -0.0001205062210071477}}, .status = PTC_OK, .u = {-32.021335095289345, 245.03053355397023, -7.07644533141387}, .axes = {PTC_OK, PTC_OK, PTC_OK}},
    {.command = 2U, .samples = 1U, .told = PTC_E_INPUT, .found = 0U, .is_armed = 0U, .start = 0U, .k = 2U, .y = {{-0.2950723034927403, 12.727090153186449}, {0.44763176636930213, -0.029818912049096903}, {(double)INFINITY, 0.6655806681733418}}, .status = PTC_E_INPUT, .u = {0.0, 0.0, 0.0}, .axes = {PTC_E_INPUT, PTC_E_INPUT, PTC_E_INPUT}},
    {.command = 2U, .samples = 1048576U, .told = PTC_E_RANGE, .found = 0U, .is_armed = 0U, .start = 0U, .k = 2U, .y = {{0.07091304798361937, 0.0005446431389232351}, {-0.8561833870481499, 2.8088959634012146e-5}, {-0.0009652581452700795, 1.7976931348623157e308}}, .status = PTC_E_RANGE, .u = {0.0, 0.0, 0.0}, .axes = {PTC_OK, PTC_OK, PTC_E_RANGE}},
    {.command = 2U, .samples = 1U, .told = PTC_OK, .found = 47931U, .is_armed = 0U, .start = 0U, .k = 750U, .y = {{0.00012751787251430758, 0.0012924395942781608}, {-0.07868378400453442, -95.86100168239078}, {0.7535956600122691, -0.09050206516103776}}, .status = PTC_LATE, .u = {-0.012982762301885602, 359.99986512822653, 0.06701370725073029}, .axes = {PTC_LATE, PTC_LATE, PTC_LATE}},
    {.command = 2U, .samples = 10U, .told = PTC_OK, .found = 8498U, .is_armed = 0U, .start = 0U, .k = 1U, .y = {{-0.03920650585284302, 0.2215392340130793}, {64.98145787245957, -0.5488822391012806}, {0.2654358347996699, 6.303279327843181e-5}}, .status = PTC_OK, .u = {-2.3164591728995143, -6.258658661885777, -0.009241785241154998}, .axes = {PTC_OK, PTC_OK, PTC_OK}},
    {.command = 2U, .samples = 4294967295U, .told = PTC_E_RANGE, .found = 0U, .is_armed = 0U, .start = 0U, .k = 1500U, .y = {{-34.21084345815921, 0.07033659575658535}, {0.07913051267254592, 0.0006012758118417926}, {-1.7976931348623157e308, 0.0005919383282959005}}, .status = PTC_E_RANGE, .u = {0.0, 0.0, 0.0}, .axes = {PTC_OK, PTC_OK, PTC_E_RANGE}},
    {.command = 2U, .samples = 2147483648U, .told = PTC_E_INPUT, .found = 0U, .is_armed = 0U, .start = 0U, .k = 1U, .y = {{0.050196601403898436, (double)INFINITY}, {-0.44099829046179573, 0.0008815452647200602}, {-0.07170434054458404, -0.0008494360914368484}}, .status = PTC_E_INPUT, .u = {0.0, 0.0, 0.0}, .axes = {PTC_E_INPUT, PTC_E_INPUT, PTC_E_INPUT}},
    {.command = 2U, .samples = 200U, .told = PTC_OK, .found = 417269U, .is_armed = 0U, .start = 0U, .k = 7U, .y = {{-0.0003227555440257519, 0.01588161060532478}, {0.0002265458735204362, 76.03256866708826}, {-83.44364097014294, -0.0001462124192056189}}, .status = PTC_LATE, .u = {-0.018267837949902162, -32.79859732626281, 0.034522647815626764}, .axes = {PTC_LATE, PTC_LATE, PTC_LATE}},
    {.command = 2U, .samples = 2147483648U, .told = PTC_E_RANGE, .found = 0U, .is_armed = 0U, .start = 0U, .k = 750U, .y = {{-17.297196071423016, 0.4036233296603917}, {-1.7976931348623157e308, 0.5700171185111587}, {0.00036230449289722703, 52.42808487349653}}, .status = PTC_E_RANGE, .u = {0.0, 0.0, 0.0}, .axes = {PTC_OK, PTC_E_RANGE, PTC_OK}},
    {.command = 2U, .samples = 3000U, .told = PTC_E_SOON, .found = 0U, .is_armed = 0U, .start = 0U, .k = 7U, .y = {{-9.928844387477121e-5, 0.020185214847099744}, {96.63764230813348, 0.0014715760191269301}, {65.96605372377651, -0.5704911830265875}}, .status = PTC_OK, .u = {-0.023219348644262214, -0.1504917236721234, 0.03834714602225033}, .axes = {PTC_OK, PTC_OK, PTC_OK}},
    {.command = 2U, .samples = 4294967295U, .told = PTC_E_RANGE, .found = 0U, .is_armed = 0U, .start = 0U, .k = 2U, .y = {{73.21926364253106, 1.7976931348623157e308}, {-87.20602253342358, -0.0008587209416868687}, {0.04829917489680416, -0.01091573997118871}}, .status = PTC_E_RANGE, .u = {0.0, 0.0, 0.0}, .axes = {PTC_E_RANGE, PTC_OK, PTC_OK}},
    {.command = 2U, .samples = 2147483648U, .told = PTC_E_SOON, .found = 0U, .is_armed = 0U, .start = 0U, .k = 1U, .y = {{-0.04494699878308639, 0.1434722105839854}, {0.07366907419880223, -67.13458205312051}, {-0.0004938049772170663, 0.5427688343699018}}, .status = PTC_OK, .u = {-0.16485287233567442, 28.959691766507905, -0.062435497017820404}, .axes = {PTC_OK, PTC_OK, PTC_OK}},
    {.command = 2U, .samples = 3U, .told = PTC_E_SOON, .found = 0U, .is_armed = 0U, .start = 0U, .k = 1500U, .y = {{-0.044366352355039385, 0.03159382334294312}, {0.6153417862318662, -0.0011996993457867866}, {-25.104231681114687, 0.9451421206171082}}, .status = PTC_OK, .u = {-0.03628920078785461, -0.00044170226121143603, -0.0986575617132021}, .axes = {PTC_OK, PTC_OK, PTC_OK}},
    {.command = 2U, .samples = 3000U, .told = PTC_E_SOON, .found = 0U, .is_armed = 0U, .start = 0U, .k = 750U, .y = {{38.687281104579284, 0.06781734744325518}, {0.0007358030646638352, 11.69619292947084}, {-0.1757543808203732, 0.6293221162388527}}, .status = PTC_OK, .u = {-0.2387037209805698, -5.054453775821476, -0.0724493228447661}, .axes = {PTC_OK, PTC_OK, PTC_OK}},
    {.command = 2U, .samples = 40U, .told = PTC_E_INPUT, .found = 0U, .is_armed = 0U, .start = 0U, .k = 1500U, .y = {{0.08805000536506172, 0.8003241062351409}, {-96.1082805953569, (double)NAN}, {70.37044608403737, -1.7976931348623157e308}}, .status = PTC_E_INPUT, .u = {0.0, 0.0, 0.0}, .axes = {PTC_E_INPUT, PTC_E_INPUT, PTC_E_INPUT}},
    {.command = 2U, .samples = 3U, .told = PTC_OK, .found = 874U, .is_armed = 0U, .start = 0U, .k = 750U, .y = {{0.5707546091788771, 0.049338072347890116}, {0.043663425445307796, -0.000614634283841522}, {-0.06347002618137891, -0.0009628044767255188}}, .status = PTC_OK, .u = {-0.06334180388081173, 0.00020600509005125157, 0.0001483178128272614}, .axes = {PTC_OK, PTC_OK, PTC_OK}},
    {.command = 2U, .samples = 2147483648U, .told = PTC_E_SOON, .found = 0U, .is_armed = 0U, .start = 0U, .k = 750U, .y = {{0.3510849497934645, -0.039959741148805565}, {-93.58703054078713, -0.010000797747282153}, {0.07314567379561954, 83.15650290370206}}, .status = PTC_OK, .u = {0.04746117405043633, 0.17032023735493426, -10.221713931128336}, .axes = {PTC_OK, PTC_OK, PTC_OK}},
    {.command = 2U, .samples = 40U, .told = PTC_OK, .found = 41451U, .is_armed = 0U, .start = 0U, .k = 7U, .y = {{31.377235637171587, -0.03011106947435196}, {-0.0007345153040039069, 0.0573544494615397}, {-0.41965379950598836, -0.0003438621554399597}}, .status = PTC_OK, .u = {-0.1285225710714076, -0.028145205225658713, 0.0002695946822314105}, .axes = {PTC_OK, PTC_OK, PTC_OK}},
    {.command = 2U, .samples = 0U, .told = PTC_E_SOON, .found = 0U, .is_armed = 0U, .start = 0U, .k = 2U, .y = {{-0.6363563182291607, -0.26329103641689855}, {-0.00035961040314903126, -0.0004039055906110276}, {-59.72991386648132, 0.914995134231334}}, .status = PTC_OK, .u = {0.34796092558549274, 0.00019893555416351832, -0.087774664867448}, .axes = {PTC_OK, PTC_OK, PTC_OK}},
    {.command = 2U, .samples = 40U, .told = PTC_E_SOON, .found = 0U, .is_armed = 0U, .start = 0U, .k = 750U, .y = {{0.0006404019614918742, 0.0002881760143688827}, {0.00010991661257491337, 0.0007284596099127445}, {-0.0007594837648333963, 0.7009131769540193}}, .status = PTC_OK, .u = {-0.00038133291431902383, -0.0003584384787047077, -0.09191189582212142}, .axes = {PTC_OK, PTC_OK, PTC_OK}},
    {.command = 2U, .samples = 40U, .told = PTC_E_RANGE, .found = 0U, .is_armed = 0U, .start = 0U, .k = 1500U, .y = {{0.0008876805940732116, -0.915442846727138}, {-0.0006745971552619803, 99.13488154467605}, {1.7976931348623157e308, 1.7976931348623157e308}}, .status = PTC_E_RANGE, .u = {0.0, 0.0, 0.0}, .axes = {PTC_OK, PTC_OK, PTC_E_RANGE}},
    {.command = 2U, .samples = 1U, .told = PTC_OK, .found = 29856U, .is_armed = 0U, .start = 0U, .k = 750U, .y = {{-24.31407872709832, 0.2886599178993421}, {0.04802368437731835, 0.5256495232710499}, {0.002173439254008636, 0.0738790805229235}}, .status = PTC_OK, .u = {-0.2551042419987644, -0.2758279312120363, -0.01033509864418471}, .axes = {PTC_OK, PTC_OK, PTC_OK}},
    {.command = 2U, .samples = 10U, .told = PTC_OK, .found = 329U, .is_armed = 0U, .start = 0U, .k = 1500U, .y = {{0.03127620878411193, -0.0006400561399606974}, {0.06985153418178268, -0.09552325677726779}, {0.04997335865936823, 0.08311215995803325}}, .status = PTC_OK, .u = {0.000738524623167061, 0.053378799589053706, -0.012462292342813895}, .axes = {PTC_OK, PTC_OK, PTC_OK}},
    {.command = 1U, .samples = 40U, .told = PTC_OK, .found = 0U, .is_armed = 0U, .start = 0U, .k = 1500U, .y = {{-0.0001383958612879932, -0.0003696152142407876}, {-0.0004020874974487996, -0.27678517067917463}, {-5.3189428792187685e-5, 0.0008075677072567706}}, .status = PTC_LATE, .u = {6.308384820164382, 359.47341733064536, -0.08140359332396487}, .axes = {PTC_LATE, PTC_LATE, PTC_LATE}},
    {.command = 2U, .samples = 1U, .told = PTC_OK, .found = 35479U, .is_armed = 0U, .start = 0U, .k = 7U, .y = {{32.1962700108948, -0.7607019557847146}, {-0.07737235804681189, -7.37723095099263e-5}, {-0.7428529198429739, -0.0009126124157411453}}, .status = PTC_SATURATED, .u = {-900.0, 400.0, 60.0}, .axes = {PTC_SATURATED, PTC_SATURATED, PTC_SATURATED}},
    {.command = 3U, .samples = 4294967295U, .told = PTC_OK, .found = 1640U, .is_armed = 0U, .start = 0U, .k = 7U, .y = {{0.0006512262235527036, -0.29876362521029964}, {1.7976931348623157e308, 0.019659259698074274}, {-0.06382164379842628, 65.25462868036745}}, .status = PTC_E_RANGE, .u = {0.0, 0.0, 0.0}, .axes = {PTC_HOLD, PTC_E_RANGE, PTC_HOLD}},
    {.command = 3U, .samples = 200U, .told = PTC_OK, .found = 1640U, .is_armed = 0U, .start = 0U, .k = 750U, .y = {{-0.0004302780347031845, -0.0007447706149442697}, {-6.789082421869819e-5, 0.8855706916274484}, {0.05429992271204769, 0.0009449211987779976}}, .status = PTC_SATURATED, .u = {900.0, -400.0, -150.0}, .axes = {PTC_SATURATED, PTC_SATURATED, PTC_SATURATED}},
    {.command = 2U, .samples = 200U, .told = PTC_OK, .found = 200U, .is_armed = 0U, .start = 0U, .k = 750U, .y = {{0.00012438644437877055, 0.01644860628803768}, {0.030639436148398615, 0.04818303219530249}, {0.023789307155120468, -0.013860723785396802}}, .status = PTC_SATURATED, .u = {-900.0, -400.0, -150.0}, .axes = {PTC_SATURATED, PTC_SATURATED, PTC_SATURATED}},
    {.command = 2U, .samples = 40U, .told = PTC_E_SOON, .found = 0U, .is_armed = 0U, .start = 0U, .k = 7U, .y = {{0.0005243635802373778, -0.07468919094747173}, {0.0004406546075130322, 27.605030381205765}, {5.651686133029976e-5, -3.6089840548565455}}, .status = PTC_SATURATED, .u = {809.993531566988, -400.0, 60.0}, .axes = {PTC_HOLD, PTC_SATURATED, PTC_SATURATED}},
    {.command = 2U, .samples = 1U, .told = PTC_E_RANGE, .found = 0U, .is_armed = 0U, .start = 0U, .k = 2U, .y = {{0.00014792413044026253, 0.7559876794896445}, {-0.0009202325013242349, 0.09464212602948299}, {-1.7976931348623157e308, 2.2535164363548742e-5}}, .status = PTC_E_RANGE, .u = {0.0, 0.0, 0.0}, .axes = {PTC_HOLD, PTC_HOLD, PTC_E_RANGE}},
    {.command = 2U, .samples = 3U, .told = PTC_OK, .found = 4053U, .is_armed = 0U, .start = 0U, .k = 7U, .y = {{0.0007971409131065079, -0.025422454521279603}, {0.0003382146335881751, -0.8665789629786489}, {0.7445803632624493, 0.07870900934025511}}, .status = PTC_SATURATED, .u = {-900.0, 400.0, -150.0}, .axes = {PTC_SATURATED, PTC_SATURATED, PTC_SATURATED}},
    {.command = 3U, .samples = 0U, .told = PTC_OK, .found = 1640U, .is_armed = 0U, .start = 0U, .k = 750U, .y = {{-0.000710525708788144, -0.06650939872101616}, {-0.07904437324558258, -0.04493051906695911}, {-0.032997153932404745, -0.00982292544398018}}, .status = PTC_SATURATED, .u = {900.0, 400.0, 60.0}, .axes = {PTC_SATURATED, PTC_SATURATED, PTC_SATURATED}},
    {.command = 2U, .samples = 0U, .told = PTC_OK, .found = 2445U, .is_armed = 0U, .start = 0U, .k = 1500U, .y = {{0.02095513603669983, 0.08944946950940916}, {0.06491774087359346, -0.6708274498508253}, {-0.5004961797139396, 0.015374998763596227}}, .status = PTC_LATE, .u = {-20.07807568619316, 46.440088802171275, 5.723819463106216}, .axes = {PTC_LATE, PTC_LATE, PTC_LATE}},
    {.command = 2U, .samples = 4294967295U, .told = PTC_E_RANGE, .found = 0U, .is_armed = 0U, .start = 0U, .k = 750U, .y = {{-0.0008128469956627642, -0.03735370955004025}, {-1.7976931348623157e308, 71.00557972977575}, {-65.89685369591265, 0.04374745485194414}}, .status = PTC_E_RANGE, .u = {0.0, 0.0, 0.0}, .axes = {PTC_HOLD, PTC_E_RANGE, PTC_HOLD}},
    {.command = 2U, .samples = 1048576U, .told = PTC_OK, .found = 8071U, .is_armed = 0U, .start = 0U, .k = 1500U, .y = {{-0.0002078651021850091, 0.0761087625361554}, {57.22809211565241, 0.0005431756671282136}, {0.8706979394518768, 0.3285019162817837}}, .status = PTC_LATE, .u = {-4.523636560756193, -237.1847218794747, -2.915749090278065}, .axes = {PTC_LATE, PTC_LATE, PTC_LATE}},
    {.command = 3U, .samples = 1U, .told = PTC_OK, .found = 9571U, .is_armed = 0U, .start = 0U, .k = 750U, .y = {{0.00036320137114231876, -0.0007213489863792353}, {-0.0009283203568549551, 0.0993730295529538}, {-0.0007080826722089005, 0.0006960401837256507}}, .status = PTC_SATURATED, .u = {-900.0, -134.5283222155243, 60.0}, .axes = {PTC_SATURATED, PTC_HOLD, PTC_SATURATED}},
    {.command = 1U, .samples = 1U, .told = PTC_E_PARAM, .found = 0U, .is_armed = 0U, .start = 0U, .k = 750U, .y = {{0.02007637562724196, 0.00011596381682605817}, {0.0030229818772324227, 0.02880906478754257}, {3.721822208562209e-5, 1.5834175798632444}}, .status = PTC_SATURATED, .u = {-900.0, -400.0, -150.0}, .axes = {PTC_SATURATED, PTC_SATURATED, PTC_SATURATED}},
    {.command = 2U, .samples = 10U, .told = PTC_OK, .found = 879U, .is_armed = 0U, .start = 0U, .k = 1U, .y = {{-0.587439196197002, -0.017108402203243524}, {0.0005434199974382406, -0.0002052761863124697}, {-0.0002910932270635245, -0.09727059603146349}}, .status = PTC_SATURATED, .u = {900.0, -400.0, 60.0}, .axes = {PTC_SATURATED, PTC_SATURATED, PTC_SATURATED}},
    {.command = 2U, .samples = 4294967295U, .told = PTC_OK, .found = 2716U, .is_armed = 0U, .start = 0U, .k = 7U, .y = {{0.00023968840676062553, -0.3625505366015107}, {0.09059161499408291, 0.020711628487580815}, {-0.547136341592839, 0.0008635955915697922}}, .status = PTC_SATURATED, .u = {900.0, -400.0, 60.0}, .axes = {PTC_SATURATED, PTC_SATURATED, PTC_SATURATED}},
    {.command = 2U, .samples = 10U, .told = PTC_E_RANGE, .found = 0U, .is_armed = 0U, .start = 0U, .k = 2U, .y = {{-0.0003978797932756819, 0.00016638711039809097}, {0.000913346635099356, -0.08277315507196617}, {-1.7976931348623157e308, -0.0009173315636844646}}, .status = PTC_E_RANGE, .u = {0.0, 0.0, 0.0}, .axes = {PTC_HOLD, PTC_HOLD, PTC_E_RANGE}},
    {.command = 2U, .samples = 40U, .told = PTC_OK, .found = 493U, .is_armed = 0U, .start = 0U, .k = 750U, .y = {{0.00492007729625581, 0.00014571621255027444}, {-0.0009329366214734483, 0.32043146331905614}, {0.07546985356131244, 0.24838602872439863}}, .status = PTC_SATURATED, .u = {-900.0, -400.0, -150.0}, .axes = {PTC_SATURATED, PTC_SATURATED, PTC_SATURATED}},
    {.command = 2U, .samples = 1048576U, .told = PTC_OK, .found = 169328U, .is_armed = 0U, .start = 0U, .k = 2U, .y = {{-77.96326263076023, 0.7238164394514648}, {-0.051675154939780345, -0.02630143218738137}, {-33.855247838691206, -0.0003644445400591376}}, .status = PTC_SATURATED, .u = {900.0, 400.0, 60.0}, .axes = {PTC_SATURATED, PTC_SATURATED, PTC_SATURATED}},
    {.command = 2U, .samples = 40U, .told = PTC_E_RANGE, .found = 0U, .is_armed = 0U, .start = 0U, .k = 1U, .y = {{3.378325714698294e-5, 0.31118764747821825}, {0.0004371165183555108, -0.0008415285309356857}, {-58.48099607785564, 1.7976931348623157e308}}, .status = PTC_E_RANGE, .u = {0.0, 0.0, 0.0}, .axes = {PTC_HOLD, PTC_HOLD, PTC_E_RANGE}},
    {.command = 2U, .samples = 1U, .told = PTC_OK, .found = 42U, .is_armed = 0U, .start = 0U, .k = 2U, .y = {{-9.327825464267892e-5, 0.0006066092910875145}, {4.3995711541968685e-5, -4.233237909922294e-5}, {-0.0007126481368233662, 0.0002789636826353834}}, .status = PTC_SATURATED, .u = {270.88474935977155, -50.90402520166774, 60.0}, .axes = {PTC_HOLD, PTC_HOLD, PTC_SATURATED}},
    {.command = 2U, .samples = 1048576U, .told = PTC_E_SOON, .found = 0U, .is_armed = 0U, .start = 0U, .k = 2U, .y = {{-0.002983813189021434, 0.06923616046438963}, {0.0008538443723938864, -0.10305949190897357}, {-0.019681269165766693, 0.5672821030913993}}, .status = PTC_SATURATED, .u = {900.0, 266.82112127961346, 60.0}, .axes = {PTC_SATURATED, PTC_HOLD, PTC_SATURATED}},
    {.command = 2U, .samples = 10U, .told = PTC_E_SOON, .found = 0U, .is_armed = 0U, .start = 0U, .k = 2U, .y = {{57.558623664559974, -1.9877670484961252}, {-0.0605764882077851, 72.17271549630063}, {-0.020175867275436854, -0.0037421529036842705}}, .status = PTC_SATURATED, .u = {-900.0, -400.0, 60.0}, .axes = {PTC_SATURATED, PTC_SATURATED, PTC_SATURATED}},
    {.command = 2U, .samples = 200U, .told = PTC_OK, .found = 153U, .is_armed = 0U, .start = 0U, .k = 1U, .y = {{-0.009893734759711316, 0.0008198692851723195}, {0.025304390887944006, -0.00994879764185208}, {0.0009100672164545889, 0.0002687869335763289}}, .status = PTC_SATURATED, .u = {900.0, -400.0, -150.0}, .axes = {PTC_SATURATED, PTC_SATURATED, PTC_SATURATED}},
    {.command = 2U, .samples = 3U, .told = PTC_E_SOON, .found = 0U, .is_armed = 0U, .start = 0U, .k = 1500U, .y = {{-0.0008751214861267662, -0.06853202528927115}, {0.013075840064300938, 65.4663474741126}, {-0.0006576710735691567, 0.6055958984566703}}, .status = PTC_SATURATED, .u = {4.085042016316439, -400.0, -3.600549623190355}, .axes = {PTC_OK, PTC_SATURATED, PTC_OK}},
    {.command = 2U, .samples = 10U, .told = PTC_E_RANGE, .found = 0U, .is_armed = 0U, .start = 0U, .k = 1U, .y = {{0.0005545036371517627, 0.04023470059661172}, {-0.5154244018424252, -1.7976931348623157e308}, {0.04921343205938311, 0.08366993428210548}}, .status = PTC_E_RANGE, .u = {0.0, 0.0, 0.0}, .axes = {PTC_HOLD, PTC_E_RANGE, PTC_HOLD}},
    {.command = 2U, .samples = 3000U, .told = PTC_OK, .found = 1344U, .is_armed = 0U, .start = 0U, .k = 1U, .y = {{-0.09299856765069046, 0.8108187982715451}, {-0.000937151192262883, -0.00014263955692042285}, {0.3306020460142778, -0.22974038585567058}}, .status = PTC_SATURATED, .u = {900.0, 400.0, -150.0}, .axes = {PTC_SATURATED, PTC_SATURATED, PTC_SATURATED}},
    {.command = 2U, .samples = 200U, .told = PTC_E_SOON, .found = 0U, .is_armed = 0U, .start = 0U, .k = 2U, .y = {{1.3970094289373237e-5, 0.09550895296755924}, {0.1782841464939715, 0.00022643817478101402}, {0.0004009793395386492, -9.850244724699465}}, .status = PTC_SATURATED, .u = {-900.0, -400.0, 60.0}, .axes = {PTC_SATURATED, PTC_SATURATED, PTC_SATURATED}},
    {.command = 2U, .samples = 40U, .told = PTC_E_SOON, .found = 0U, .is_armed = 0U, .start = 0U, .k = 750U, .y = {{1.3854636594591741e-5, -0.0001643332459901319}, {-0.0005406648051170863, -0.316933002541089}, {-77.3649715515684, 21.62191502760924}}, .status = PTC_SATURATED, .u = {-37.80510393255695, 400.0, 60.0}, .axes = {PTC_HOLD, PTC_SATURATED, PTC_SATURATED}},
    {.command = 1U, .samples = 10U, .told = PTC_OK, .found = 0U, .is_armed = 0U, .start = 0U, .k = 1U, .y = {{-0.000912421136388079, -0.09426923695006698}, {43.196668458072175, 0.018860170758377738}, {-0.00040233707433344934, -0.08029050848841571}}, .status = PTC_LATE, .u = {6.463935604021829, -237.52337855950938, 0.5499945598928558}, .axes = {PTC_LATE, PTC_LATE, PTC_LATE}},
    {.command = 2U, .samples = 3U, .told = PTC_E_SOON, .found = 0U, .is_armed = 0U, .start = 0U, .k = 2U, .y = {{0.0003937132058032051, 0.25026217965176945}, {23.02253850229694, 9.096321477534408}, {-23.165767537844562, -67.22730738768242}}, .status = PTC_SATURATED, .u = {-17.1329554657101, -359.81783929721473, 60.0}, .axes = {PTC_OK, PTC_OK, PTC_SATURATED}},
    {.command = 2U, .samples = 1U, .told = PTC_E_SOON, .found = 0U, .is_armed = 0U, .start = 0U, .k = 1U, .y = {{0.0005216321986125446, -0.04740921225272457}, {0.00045132115677781173, 0.9149012632583098}, {-0.1981450138377474, -0.6113392675249711}}, .status = PTC_OK, .u = {3.236448536547964, -23.479040699947383, 4.473175448181028}, .axes = {PTC_OK, PTC_OK, PTC_OK}},
    {.command = 2U, .samples = 10U, .told = PTC_E_RANGE, .found = 0U, .is_armed = 0U, .start = 0U, .k = 1500U, .y = {{68.06519670962953, -1.825746444866616}, {-1.7976931348623157e308, 0.7320284072274199}, {42.566856478700664, 99.91882271613801}}, .status = PTC_E_RANGE, .u = {0.0, 0.0, 0.0}, .axes = {PTC_OK, PTC_E_RANGE, PTC_OK}},
    {.command = 2U, .samples = 2147483648U, .told = PTC_E_SOON, .found = 0U, .is_armed = 0U, .start = 0U, .k = 1U, .y = {{-0.0009294502103835012, 0.08632144033061787}, {-0.0009052951340962794, 0.4603325743492248}, {-0.0008833062773176204, 0.6720911226714195}}, .status = PTC_OK, .u = {-5.893137338219627, -11.807265563507402, -4.5976416882869495}, .axes = {PTC_OK, PTC_OK, PTC_OK}},
    {.command = 2U, .samples = 2147483648U, .told = PTC_OK, .found = 312U, .is_armed = 0U, .start = 0U, .k = 1500U, .y = {{0.08311398068242795, -0.5553336499499066}, {0.00043712780266931994, 0.030206082645252288}, {-0.0579454544816965, 0.04925977516197331}}, .status = PTC_OK, .u = {49.30402357749762, -1.055719654071575, -0.3011914663901702}, .axes = {PTC_OK, PTC_OK, PTC_OK}},
    {.command = 2U, .samples = 0U, .told = PTC_E_RANGE, .found = 0U, .is_armed = 0U, .start = 0U, .k = 1U, .y = {{0.4507908717544242, 2.2311913569006414}, {1.7976931348623157e308, 37.23220024090106}, {1.7976931348623157e308, 0.9612840530147089}}, .status = PTC_E_RANGE, .u = {0.0, 0.0, 0.0}, .axes = {PTC_OK, PTC_E_RANGE, PTC_E_RANGE}},
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

/* The failures of what is called before a call. */
static uint32_t gantry_in_flight_selftest_command(gantry_in_flight *self, const gantry_in_flight_selftest_call *call)
{
    uint32_t failures = 0U;
    uint32_t found = 0U;
    ptc_status told = call->told;

    switch (call->command) {
    case 1U:
        told = gantry_in_flight_arm_for(self, call->k, call->samples);
        break;
    case 2U:
        told = gantry_in_flight_soonest(self, call->y, &found);
        break;
    case 3U:
        told = gantry_in_flight_deadline(self, &found);
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
    failures += gantry_in_flight_selftest_command(self, call);
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

    for (uint32_t i = 0U; i < 4U; i++) {
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
