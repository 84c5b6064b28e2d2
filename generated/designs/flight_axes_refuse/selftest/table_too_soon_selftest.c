/* Self-test of the prescribed-time controller table_too_soon: see table_too_soon_selftest.h. DO NOT EDIT. */
#include "table_too_soon_selftest.h"
#include "table_too_soon.h"

#include <math.h>
#include <stddef.h>

/* A call, and what it must give. */
typedef struct table_too_soon_selftest_call {
    uint32_t is_armed; /* arm is called before it */
    uint32_t start;
    uint32_t command; /* called before it: 0 none, 1 arm_for, 2 soonest, 3 deadline */
    uint32_t samples;
    ptc_status told; /* its status */
    uint32_t found; /* its result */
    uint32_t k;
    double y[2][3]; /* what is measured */
    ptc_status status;
    double u[2];
    ptc_status axes[2];
} table_too_soon_selftest_call;

/* A set of parameters that init takes, and the calls with it, one after the other. */
typedef struct table_too_soon_selftest_session {
    table_too_soon_params params;
    uint32_t first; /* of its calls */
    uint32_t count;
} table_too_soon_selftest_session;

static const table_too_soon_selftest_session table_too_soon_selftest_sessions[6] = {
    {.params = {.u_max = (double)INFINITY, .u_min = -(double)INFINITY}, .first = 0U, .count = 72U},
    {.params = {.u_max = (double)INFINITY, .u_min = -(double)INFINITY}, .first = 72U, .count = 1U},
    {.params = {.u_max = (double)INFINITY, .u_min = -(double)INFINITY}, .first = 73U, .count = 2U},
    {.params = {.u_max = 1.0, .u_min = -(double)INFINITY}, .first = 75U, .count = 2U},
    {.params = {.u_max = (double)INFINITY, .u_min = -0.5}, .first = 77U, .count = 1U},
    {.params = {.u_max = (double)INFINITY, .u_min = -(double)INFINITY}, .first = 78U, .count = 86U},
};

static const table_too_soon_selftest_call table_too_soon_selftest_calls[164] = {
    {.is_armed = 0U, .start = 0U, .k = 0U, .y = {{0.75, 0.25, -0.25}, {-0.75, -1.25, -1.75}}, .status = PTC_OK, .u = {-15.520419426048566, 71.55921593686853}, .axes = {PTC_OK, PTC_OK}},
    {.is_armed = 0U, .start = 0U, .k = 1U, .y = {{0.7400333333333332, 0.24667777777777775, -0.24667777777777775}, {-0.7400333333333332, -1.2333888888888886, -1.7267444444444442}}, .status = PTC_OK, .u = {-15.6159309296051, 71.62402628609787}, .axes = {PTC_OK, PTC_OK}},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {{0.7301333333333334, 0.2433777777777778, -0.2433777777777778}, {-0.7301333333333334, -1.2168888888888891, -1.7036444444444445}}, .status = PTC_OK, .u = {-15.712574695500873, 71.69088590933261}, .axes = {PTC_OK, PTC_OK}},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {{(double)NAN, 0.5, 0.5}, {0.5, 0.5, 0.5}}, .status = PTC_E_INPUT, .u = {0.0, 0.0}, .axes = {PTC_E_INPUT, PTC_E_INPUT}},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {{0.5, (double)NAN, 0.5}, {0.5, 0.5, 0.5}}, .status = PTC_E_INPUT, .u = {0.0, 0.0}, .axes = {PTC_E_INPUT, PTC_E_INPUT}},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {{0.5, 0.5, (double)NAN}, {0.5, 0.5, 0.5}}, .status = PTC_E_INPUT, .u = {0.0, 0.0}, .axes = {PTC_E_INPUT, PTC_E_INPUT}},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {{0.5, 0.5, 0.5}, {(double)NAN, 0.5, 0.5}}, .status = PTC_E_INPUT, .u = {0.0, 0.0}, .axes = {PTC_E_INPUT, PTC_E_INPUT}},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {{0.5, 0.5, 0.5}, {0.5, (double)NAN, 0.5}}, .status = PTC_E_INPUT, .u = {0.0, 0.0}, .axes = {PTC_E_INPUT, PTC_E_INPUT}},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {{0.5, 0.5, 0.5}, {0.5, 0.5, (double)NAN}}, .status = PTC_E_INPUT, .u = {0.0, 0.0}, .axes = {PTC_E_INPUT, PTC_E_INPUT}},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {{(double)INFINITY, 0.5, 0.5}, {0.5, 0.5, 0.5}}, .status = PTC_E_INPUT, .u = {0.0, 0.0}, .axes = {PTC_E_INPUT, PTC_E_INPUT}},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {{0.5, (double)INFINITY, 0.5}, {0.5, 0.5, 0.5}}, .status = PTC_E_INPUT, .u = {0.0, 0.0}, .axes = {PTC_E_INPUT, PTC_E_INPUT}},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {{0.5, 0.5, (double)INFINITY}, {0.5, 0.5, 0.5}}, .status = PTC_E_INPUT, .u = {0.0, 0.0}, .axes = {PTC_E_INPUT, PTC_E_INPUT}},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {{0.5, 0.5, 0.5}, {(double)INFINITY, 0.5, 0.5}}, .status = PTC_E_INPUT, .u = {0.0, 0.0}, .axes = {PTC_E_INPUT, PTC_E_INPUT}},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {{0.5, 0.5, 0.5}, {0.5, (double)INFINITY, 0.5}}, .status = PTC_E_INPUT, .u = {0.0, 0.0}, .axes = {PTC_E_INPUT, PTC_E_INPUT}},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {{0.5, 0.5, 0.5}, {0.5, 0.5, (double)INFINITY}}, .status = PTC_E_INPUT, .u = {0.0, 0.0}, .axes = {PTC_E_INPUT, PTC_E_INPUT}},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {{-(double)INFINITY, 0.5, 0.5}, {0.5, 0.5, 0.5}}, .status = PTC_E_INPUT, .u = {0.0, 0.0}, .axes = {PTC_E_INPUT, PTC_E_INPUT}},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {{0.5, -(double)INFINITY, 0.5}, {0.5, 0.5, 0.5}}, .status = PTC_E_INPUT, .u = {0.0, 0.0}, .axes = {PTC_E_INPUT, PTC_E_INPUT}},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {{0.5, 0.5, -(double)INFINITY}, {0.5, 0.5, 0.5}}, .status = PTC_E_INPUT, .u = {0.0, 0.0}, .axes = {PTC_E_INPUT, PTC_E_INPUT}},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {{0.5, 0.5, 0.5}, {-(double)INFINITY, 0.5, 0.5}}, .status = PTC_E_INPUT, .u = {0.0, 0.0}, .axes = {PTC_E_INPUT, PTC_E_INPUT}},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {{0.5, 0.5, 0.5}, {0.5, -(double)INFINITY, 0.5}}, .status = PTC_E_INPUT, .u = {0.0, 0.0}, .axes = {PTC_E_INPUT, PTC_E_INPUT}},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {{0.5, 0.5, 0.5}, {0.5, 0.5, -(double)INFINITY}}, .status = PTC_E_INPUT, .u = {0.0, 0.0}, .axes = {PTC_E_INPUT, PTC_E_INPUT}},
    {.is_armed = 0U, .start = 0U, .k = 3U, .y = {{0.7202999999999999, 0.24009999999999998, -0.24009999999999998}, {-0.7202999999999999, -1.2005, -1.6806999999999999}}, .status = PTC_OK, .u = {-15.810373359937117, 71.7598348751436}, .axes = {PTC_OK, PTC_OK}},
    {.is_armed = 0U, .start = 0U, .k = 37U, .y = {{0.4256333333333333, 0.14187777777777777, -0.14187777777777777}, {-0.4256333333333333, -0.7093888888888888, -0.9931444444444444}}, .status = PTC_OK, .u = {-20.035831850156793, 75.72188549000354}, .axes = {PTC_OK, PTC_OK}},
    {.is_armed = 0U, .start = 0U, .k = 71U, .y = {{0.2080333333333333, 0.06934444444444443, -0.06934444444444443}, {-0.2080333333333333, -0.34672222222222215, -0.485411111111111}}, .status = PTC_OK, .u = {-27.48091941015089, 85.3623116112951}, .axes = {PTC_OK, PTC_OK}},
    {.is_armed = 0U, .start = 0U, .k = 73U, .y = {{0.19763333333333333, 0.06587777777777777, -0.06587777777777777}, {-0.19763333333333333, -0.32938888888888884, -0.4611444444444444}}, .status = PTC_OK, .u = {-28.10676331638357, 86.2542384326878}, .axes = {PTC_OK, PTC_OK}},
    {.is_armed = 0U, .start = 0U, .k = 74U, .y = {{0.1925333333333334, 0.06417777777777779, -0.06417777777777779}, {-0.1925333333333334, -0.32088888888888895, -0.44924444444444456}}, .status = PTC_OK, .u = {-28.43117623117624, 86.71979040181573}, .axes = {PTC_OK, PTC_OK}},
    {.is_armed = 0U, .start = 0U, .k = 75U, .y = {{0.1875, 0.0625, -0.0625}, {-0.1875, -0.3125, -0.4375}}, .status = PTC_OK, .u = {-28.763642059694693, 87.19903999509263}, .axes = {PTC_OK, PTC_OK}},
    {.is_armed = 0U, .start = 0U, .k = 76U, .y = {{0.18253333333333335, 0.06084444444444445, -0.06084444444444445}, {-0.18253333333333335, -0.3042222222222223, -0.42591111111111113}}, .status = PTC_OK, .u = {-29.10447407407408, 87.69249570390625}, .axes = {PTC_OK, PTC_OK}},
    {.is_armed = 0U, .start = 0U, .k = 112U, .y = {{0.04813333333333335, 0.016044444444444448, -0.016044444444444448}, {-0.04813333333333335, -0.08022222222222224, -0.11231111111111114}}, .status = PTC_OK, .u = {-52.09193732193735, 122.90280244597321}, .axes = {PTC_OK, PTC_OK}},
    {.is_armed = 0U, .start = 0U, .k = 146U, .y = {{0.0005333333333333335, 0.0001777777777777778, -0.0001777777777777778}, {-0.0005333333333333335, -0.000888888888888889, -0.0012444444444444447}}, .status = PTC_OK, .u = {-268.95081481481486, 317.6582433862435}, .axes = {PTC_OK, PTC_OK}},
    {.is_armed = 0U, .start = 0U, .k = 148U, .y = {{0.00013333333333333337, 4.444444444444445e-5, -4.444444444444445e-5}, {-0.00013333333333333337, -0.00022222222222222226, -0.0003111111111111112}}, .status = PTC_OK, .u = {-134.2140740740741, 137.83481481481485}, .axes = {PTC_OK, PTC_OK}},
    {.is_armed = 0U, .start = 0U, .k = 149U, .y = {{3.333333333333334e-5, 1.1111111111111113e-5, -1.1111111111111113e-5}, {-3.333333333333334e-5, -5.5555555555555565e-5, -7.77777777777778e-5}}, .status = PTC_OK, .u = {-33.55351851851852, 34.45870370370371}, .axes = {PTC_OK, PTC_OK}},
    {.is_armed = 0U, .start = 0U, .k = 150U, .y = {{0.0, 0.0, -0.0}, {-0.0, -0.0, -0.0}}, .status = PTC_HOLD, .u = {0.0, 0.0}, .axes = {PTC_HOLD, PTC_HOLD}},
    {.is_armed = 0U, .start = 0U, .k = 151U, .y = {{0.0, 0.0, -0.0}, {-0.0, -0.0, -0.0}}, .status = PTC_HOLD, .u = {0.0, 0.0}, .axes = {PTC_HOLD, PTC_HOLD}},
    {.is_armed = 0U, .start = 0U, .k = 2147483647U, .y = {{0.0, 0.0, -0.0}, {-0.0, -0.0, -0.0}}, .status = PTC_HOLD, .u = {0.0, 0.0}, .axes = {PTC_HOLD, PTC_HOLD}},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {{0.0, 0.0, -0.0}, {-0.0, -0.0, -0.0}}, .status = PTC_HOLD, .u = {0.0, 0.0}, .axes = {PTC_HOLD, PTC_HOLD}},
    {.is_armed = 1U, .start = 4294967293U, .k = 4294967293U, .y = {{0.75, 0.25, -0.25}, {-0.75, -1.25, -1.75}}, .status = PTC_OK, .u = {-15.520419426048566, 71.55921593686853}, .axes = {PTC_OK, PTC_OK}},
    {.is_armed = 0U, .start = 0U, .k = 4294967294U, .y = {{0.7400333333333332, 0.24667777777777775, -0.24667777777777775}, {-0.7400333333333332, -1.2333888888888886, -1.7267444444444442}}, .status = PTC_OK, .u = {-15.6159309296051, 71.62402628609787}, .axes = {PTC_OK, PTC_OK}},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {{0.7301333333333334, 0.2433777777777778, -0.2433777777777778}, {-0.7301333333333334, -1.2168888888888891, -1.7036444444444445}}, .status = PTC_OK, .u = {-15.712574695500873, 71.69088590933261}, .axes = {PTC_OK, PTC_OK}},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {{(double)NAN, 0.5, 0.5}, {0.5, 0.5, 0.5}}, .status = PTC_E_INPUT, .u = {0.0, 0.0}, .axes = {PTC_E_INPUT, PTC_E_INPUT}},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {{0.5, (double)NAN, 0.5}, {0.5, 0.5, 0.5}}, .status = PTC_E_INPUT, .u = {0.0, 0.0}, .axes = {PTC_E_INPUT, PTC_E_INPUT}},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {{0.5, 0.5, (double)NAN}, {0.5, 0.5, 0.5}}, .status = PTC_E_INPUT, .u = {0.0, 0.0}, .axes = {PTC_E_INPUT, PTC_E_INPUT}},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {{0.5, 0.5, 0.5}, {(double)NAN, 0.5, 0.5}}, .status = PTC_E_INPUT, .u = {0.0, 0.0}, .axes = {PTC_E_INPUT, PTC_E_INPUT}},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {{0.5, 0.5, 0.5}, {0.5, (double)NAN, 0.5}}, .status = PTC_E_INPUT, .u = {0.0, 0.0}, .axes = {PTC_E_INPUT, PTC_E_INPUT}},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {{0.5, 0.5, 0.5}, {0.5, 0.5, (double)NAN}}, .status = PTC_E_INPUT, .u = {0.0, 0.0}, .axes = {PTC_E_INPUT, PTC_E_INPUT}},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {{(double)INFINITY, 0.5, 0.5}, {0.5, 0.5, 0.5}}, .status = PTC_E_INPUT, .u = {0.0, 0.0}, .axes = {PTC_E_INPUT, PTC_E_INPUT}},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {{0.5, (double)INFINITY, 0.5}, {0.5, 0.5, 0.5}}, .status = PTC_E_INPUT, .u = {0.0, 0.0}, .axes = {PTC_E_INPUT, PTC_E_INPUT}},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {{0.5, 0.5, (double)INFINITY}, {0.5, 0.5, 0.5}}, .status = PTC_E_INPUT, .u = {0.0, 0.0}, .axes = {PTC_E_INPUT, PTC_E_INPUT}},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {{0.5, 0.5, 0.5}, {(double)INFINITY, 0.5, 0.5}}, .status = PTC_E_INPUT, .u = {0.0, 0.0}, .axes = {PTC_E_INPUT, PTC_E_INPUT}},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {{0.5, 0.5, 0.5}, {0.5, (double)INFINITY, 0.5}}, .status = PTC_E_INPUT, .u = {0.0, 0.0}, .axes = {PTC_E_INPUT, PTC_E_INPUT}},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {{0.5, 0.5, 0.5}, {0.5, 0.5, (double)INFINITY}}, .status = PTC_E_INPUT, .u = {0.0, 0.0}, .axes = {PTC_E_INPUT, PTC_E_INPUT}},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {{-(double)INFINITY, 0.5, 0.5}, {0.5, 0.5, 0.5}}, .status = PTC_E_INPUT, .u = {0.0, 0.0}, .axes = {PTC_E_INPUT, PTC_E_INPUT}},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {{0.5, -(double)INFINITY, 0.5}, {0.5, 0.5, 0.5}}, .status = PTC_E_INPUT, .u = {0.0, 0.0}, .axes = {PTC_E_INPUT, PTC_E_INPUT}},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {{0.5, 0.5, -(double)INFINITY}, {0.5, 0.5, 0.5}}, .status = PTC_E_INPUT, .u = {0.0, 0.0}, .axes = {PTC_E_INPUT, PTC_E_INPUT}},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {{0.5, 0.5, 0.5}, {-(double)INFINITY, 0.5, 0.5}}, .status = PTC_E_INPUT, .u = {0.0, 0.0}, .axes = {PTC_E_INPUT, PTC_E_INPUT}},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {{0.5, 0.5, 0.5}, {0.5, -(double)INFINITY, 0.5}}, .status = PTC_E_INPUT, .u = {0.0, 0.0}, .axes = {PTC_E_INPUT, PTC_E_INPUT}},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {{0.5, 0.5, 0.5}, {0.5, 0.5, -(double)INFINITY}}, .status = PTC_E_INPUT, .u = {0.0, 0.0}, .axes = {PTC_E_INPUT, PTC_E_INPUT}},
    {.is_armed = 0U, .start = 0U, .k = 0U, .y = {{0.7202999999999999, 0.24009999999999998, -0.24009999999999998}, {-0.7202999999999999, -1.2005, -1.6806999999999999}}, .status = PTC_OK, .u = {-15.810373359937117, 71.7598348751436}, .axes = {PTC_OK, PTC_OK}},
    {.is_armed = 0U, .start = 0U, .k = 34U, .y = {{0.4256333333333333, 0.14187777777777777, -0.14187777777777777}, {-0.4256333333333333, -0.7093888888888888, -0.9931444444444444}}, .status = PTC_OK, .u = {-20.035831850156793, 75.72188549000354}, .axes = {PTC_OK, PTC_OK}},
    {.is_armed = 0U, .start = 0U, .k = 68U, .y = {{0.2080333333333333, 0.06934444444444443, -0.06934444444444443}, {-0.2080333333333333, -0.34672222222222215, -0.485411111111111}}, .status = PTC_OK, .u = {-27.48091941015089, 85.3623116112951}, .axes = {PTC_OK, PTC_OK}},
    {.is_armed = 0U, .start = 0U, .k = 70U, .y = {{0.19763333333333333, 0.06587777777777777, -0.06587777777777777}, {-0.19763333333333333, -0.32938888888888884, -0.4611444444444444}}, .status = PTC_OK, .u = {-28.10676331638357, 86.2542384326878}, .axes = {PTC_OK, PTC_OK}},
    {.is_armed = 0U, .start = 0U, .k = 71U, .y = {{0.1925333333333334, 0.06417777777777779, -0.06417777777777779}, {-0.1925333333333334, -0.32088888888888895, -0.44924444444444456}}, .status = PTC_OK, .u = {-28.43117623117624, 86.71979040181573}, .axes = {PTC_OK, PTC_OK}},
    {.is_armed = 0U, .start = 0U, .k = 72U, .y = {{0.1875, 0.0625, -0.0625}, {-0.1875, -0.3125, -0.4375}}, .status = PTC_OK, .u = {-28.763642059694693, 87.19903999509263}, .axes = {PTC_OK, PTC_OK}},
    {.is_armed = 0U, .start = 0U, .k = 73U, .y = {{0.18253333333333335, 0.06084444444444445, -0.06084444444444445}, {-0.18253333333333335, -0.3042222222222223, -0.42591111111111113}}, .status = PTC_OK, .u = {-29.10447407407408, 87.69249570390625}, .axes = {PTC_OK, PTC_OK}},
    {.is_armed = 0U, .start = 0U, .k = 109U, .y = {{0.04813333333333335, 0.016044444444444448, -0.016044444444444448}, {-0.04813333333333335, -0.08022222222222224, -0.11231111111111114}}, .status = PTC_OK, .u = {-52.09193732193735, 122.90280244597321}, .axes = {PTC_OK, PTC_OK}},
    {.is_armed = 0U, .start = 0U, .k = 143U, .y = {{0.0005333333333333335, 0.0001777777777777778, -0.0001777777777777778}, {-0.0005333333333333335, -0.000888888888888889, -0.0012444444444444447}}, .status = PTC_OK, .u = {-268.95081481481486, 317.6582433862435}, .axes = {PTC_OK, PTC_OK}},
    {.is_armed = 0U, .start = 0U, .k = 145U, .y = {{0.00013333333333333337, 4.444444444444445e-5, -4.444444444444445e-5}, {-0.00013333333333333337, -0.00022222222222222226, -0.0003111111111111112}}, .status = PTC_OK, .u = {-134.2140740740741, 137.83481481481485}, .axes = {PTC_OK, PTC_OK}},
    {.is_armed = 0U, .start = 0U, .k = 146U, .y = {{3.333333333333334e-5, 1.1111111111111113e-5, -1.1111111111111113e-5}, {-3.333333333333334e-5, -5.5555555555555565e-5, -7.77777777777778e-5}}, .status = PTC_OK, .u = {-33.55351851851852, 34.45870370370371}, .axes = {PTC_OK, PTC_OK}},
    {.is_armed = 0U, .start = 0U, .k = 147U, .y = {{0.0, 0.0, -0.0}, {-0.0, -0.0, -0.0}}, .status = PTC_HOLD, .u = {0.0, 0.0}, .axes = {PTC_HOLD, PTC_HOLD}},
    {.is_armed = 0U, .start = 0U, .k = 148U, .y = {{0.0, 0.0, -0.0}, {-0.0, -0.0, -0.0}}, .status = PTC_HOLD, .u = {0.0, 0.0}, .axes = {PTC_HOLD, PTC_HOLD}},
    {.is_armed = 0U, .start = 0U, .k = 2147483644U, .y = {{0.0, 0.0, -0.0}, {-0.0, -0.0, -0.0}}, .status = PTC_HOLD, .u = {0.0, 0.0}, .axes = {PTC_HOLD, PTC_HOLD}},
    {.is_armed = 0U, .start = 0U, .k = 4294967292U, .y = {{0.0, 0.0, -0.0}, {-0.0, -0.0, -0.0}}, .status = PTC_HOLD, .u = {0.0, 0.0}, .axes = {PTC_HOLD, PTC_HOLD}},
    {.is_armed = 0U, .start = 0U, .k = 62U, .y = {{-1.3707302382681494e302, -1.5889774145275112e302, 5.541243690600241e301}, {6.080970471873253e301, 1.262180306843296e302, -1.3922022247799523e302}}, .status = PTC_E_RANGE, .u = {0.0, 0.0}, .axes = {PTC_E_RANGE, PTC_E_RANGE}},
    {.is_armed = 1U, .start = 0U, .k = 12U, .y = {{0.788882832711244, 1.560855476976445e302, -1.565394334489961e302}, {0.5, -0.5, -0.0}}, .status = PTC_E_RANGE, .u = {0.0, 0.0}, .axes = {PTC_E_RANGE, PTC_OK}},
    {.is_armed = 1U, .start = 0U, .k = 47U, .y = {{0.0008546934607866015, -0.0008332559146693069, 935.7205552142666}, {2.0, -1.0, 9.629828438364187e307}}, .status = PTC_E_RANGE, .u = {0.0, 0.0}, .axes = {PTC_OK, PTC_E_RANGE}},
    {.is_armed = 0U, .start = 0U, .k = 0U, .y = {{0.7328956206719082, -0.6892276204512043, -0.5970377039101031}, {0.5140225585873944, -0.2625251943873232, -0.497291960420174}}, .status = PTC_SATURATED, .u = {1.0, -6.904482119874255}, .axes = {PTC_SATURATED, PTC_OK}},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {{-0.824771727329228, 0.8252152727910428, 0.5767073982363133}, {-0.5137307962057012, 0.5394415430673598, -0.6690152114204218}}, .status = PTC_SATURATED, .u = {-1.8217859786214756, 1.0}, .axes = {PTC_OK, PTC_SATURATED}},
    {.is_armed = 0U, .start = 0U, .k = 0U, .y = {{0.5459016528875701, -0.7242755258082414, 0.8860184074680449}, {0.5356949912435297, 0.6684231700748845, -0.39224647016158853}}, .status = PTC_SATURATED, .u = {-0.5, -0.5}, .axes = {PTC_SATURATED, PTC_SATURATED}},
    {.command = 1U, .samples = 1024U, .told = PTC_E_SOON, .found = 0U, .is_armed = 0U, .start = 0U, .k = 2U, .y = {{-0.2423709377588914, -85.63524614485112, 6.952763773857451e-5}, {-2.4541790649449613, 0.0003573400249027035, -0.5544549696885577}}, .status = PTC_OK, .u = {1386.8622711426196, 91.64575533428562}, .axes = {PTC_OK, PTC_OK}},
    {.command = 2U, .samples = 1024U, .told = PTC_E_SOON, .found = 0U, .is_armed = 0U, .start = 0U, .k = 2U, .y = {{0.9454652136357258, 50.746242682789955, 0.040545988750068276}, {-0.0009426569333348243, 0.05415598285448495, 38.39257226683785}}, .status = PTC_OK, .u = {-836.6231296686167, -305.49514061366676}, .axes = {PTC_OK, PTC_OK}},
    {.command = 3U, .samples = 1024U, .told = PTC_OK, .found = 150U, .is_armed = 0U, .start = 0U, .k = 75U, .y = {{0.04515722914326062, -0.00016087584278706469, 0.04313739471866645}, {-28.94772956116165, 0.0005913464426004595, 66.78381085004315}}, .status = PTC_OK, .u = {-6.6675193851104, 6589.324221565044}, .axes = {PTC_OK, PTC_OK}},
    {.command = 1U, .samples = 4294967295U, .told = PTC_E_PARAM, .found = 0U, .is_armed = 0U, .start = 0U, .k = 150U, .y = {{-0.09947489222037019, 0.45288769249893424, 0.0020914448578642332}, {-0.08806125296915963, 71.34323434320098, -0.16045857811293462}}, .status = PTC_HOLD, .u = {90416.75493883422, -1338774.0164888725}, .axes = {PTC_HOLD, PTC_HOLD}},
    {.command = 1U, .samples = 2147483648U, .told = PTC_E_SOON, .found = 0U, .is_armed = 0U, .start = 0U, .k = 2U, .y = {{-98.04064947988742, -6.16574943903736e-5, -0.09707262599996967}, {-0.8797228731396176, 81.94900590200996, 73.83708758804792}}, .status = PTC_OK, .u = {1778.9373183722314, -2724.3917718355024}, .axes = {PTC_OK, PTC_OK}},
    {.command = 2U, .samples = 2147483648U, .told = PTC_E_SOON, .found = 0U, .is_armed = 0U, .start = 0U, .k = 2U, .y = {{0.020958900549832384, -0.00046932100547768284, 50.33218865320006}, {0.25514336937363624, -2.9031892310481977, 51.667251343726896}}, .status = PTC_OK, .u = {-302.3687709327526, -341.4046202759503}, .axes = {PTC_OK, PTC_OK}},
    {.command = 1U, .samples = 3000U, .told = PTC_E_SOON, .found = 0U, .is_armed = 0U, .start = 0U, .k = 7U, .y = {{-0.4277601260298982, -0.0005012297754687194, 0.0870794392991372}, {-90.71546294608368, 24.142572856702337, 0.0005180907787587548}}, .status = PTC_OK, .u = {8.06393770921321, 2886.659686789552}, .axes = {PTC_OK, PTC_OK}},
    {.command = 1U, .samples = 1048576U, .told = PTC_E_INPUT, .found = 0U, .is_armed = 0U, .start = 0U, .k = 2U, .y = {{0.6270287989889272, 55.218424069340614, (double)INFINITY}, {-0.02131305366663383, 0.3534329607059352, (double)NAN}}, .status = PTC_E_INPUT, .u = {0.0, 0.0}, .axes = {PTC_E_INPUT, PTC_E_INPUT}},
    {.command = 2U, .samples = 200U, .told = PTC_E_INPUT, .found = 0U, .is_armed = 0U, .start = 0U, .k = 2U, .y = {{0.0006534821229673356, (double)NAN, 0.03578394393568174}, {-0.00017982823364916034, 0.862458667105068, -0.00011521323895806179}}, .status = PTC_E_INPUT, .u = {0.0, 0.0}, .axes = {PTC_E_INPUT, PTC_E_INPUT}},
    {.command = 2U, .samples = 1048576U, .told = PTC_E_SOON, .found = 0U, .is_armed = 0U, .start = 0U, .k = 75U, .y = {{-0.0001756514871583017, -0.018262425553785478, 0.06509971579773181}, {-25.71715134222814, 0.00012554030190933108, 0.32917154001022797}}, .status = PTC_OK, .u = {0.39152770166925605, 6755.86637213806}, .axes = {PTC_OK, PTC_OK}},
    {.command = 2U, .samples = 1048576U, .told = PTC_E_SOON, .found = 0U, .is_armed = 0U, .start = 0U, .k = 75U, .y = {{35.09861124561922, 0.0009749911786098573, -78.58850962678696}, {-0.0004341116409400001, -0.8563948731748388, 0.03377379330191044}}, .status = PTC_OK, .u = {-3879.6271232867957, 85.15180675258812}, .axes = {PTC_OK, PTC_OK}},
    {.command = 1U, .samples = 3U, .told = PTC_E_SOON, .found = 0U, .is_armed = 0U, .start = 0U, .k = 1U, .y = {{-0.026087193576939872, 7.687081539409468e-5, -0.07174263144728044}, {0.08695320892223204, -83.87012448105871, -79.25819161098408}}, .status = PTC_OK, .u = {0.8901777618765696, 2813.120986476943}, .axes = {PTC_OK, PTC_OK}},
    {.command = 1U, .samples = 3000U, .told = PTC_E_SOON, .found = 0U, .is_armed = 0U, .start = 0U, .k = 75U, .y = {{-64.3876911177955, -0.00940673514279824, 54.81750558933199}, {0.00025366710532399004, -0.17747202748494773, 0.8009303443609084}}, .status = PTC_OK, .u = {8161.977239804994, 5.420091316577739}, .axes = {PTC_OK, PTC_OK}},
    {.command = 1U, .samples = 10U, .told = PTC_E_SOON, .found = 0U, .is_armed = 0U, .start = 0U, .k = 2U, .y = {{1.7976931348623157e308, 0.00047240732728895754, -0.043917221198584815}, {-0.7991368150746943, 0.006852250991757503, -0.7385359740594419}}, .status = PTC_E_RANGE, .u = {0.0, 0.0}, .axes = {PTC_E_RANGE, PTC_OK}},
    {.command = 1U, .samples = 1U, .told = PTC_E_PARAM, .found = 0U, .is_armed = 0U, .start = 0U, .k = 75U, .y = {{0.36758040632805833, -0.0002876202388308018, 1.7976931348623157e308}, {-0.013197633268995302, 0.00036215904496550167, 9.08560426525482}}, .status = PTC_E_RANGE, .u = {0.0, 0.0}, .axes = {PTC_E_RANGE, PTC_OK}},
    {.command = 1U, .samples = 10U, .told = PTC_E_SOON, .found = 0U, .is_armed = 0U, .start = 0U, .k = 7U, .y = {{66.36119224002704, 0.0007962139401355604, 0.15480844883210265}, {-0.02284162393560485, -0.2868053582820409, 1.7976931348623157e308}}, .status = PTC_E_RANGE, .u = {0.0, 0.0}, .axes = {PTC_OK, PTC_E_RANGE}},
    {.command = 1U, .samples = 200U, .told = PTC_E_SOON, .found = 0U, .is_armed = 0U, .start = 0U, .k = 1U, .y = {{0.8584367151321566, 0.03311640968173979, 0.00010682680351266561}, {0.04171024846867608, 0.0003503323888471641, -0.8285605164084171}}, .status = PTC_OK, .u = {-15.789943237458775, 5.056720135492392}, .axes = {PTC_OK, PTC_OK}},
    {.command = 1U, .samples = 10U, .told = PTC_E_INPUT, .found = 0U, .is_armed = 0U, .start = 0U, .k = 7U, .y = {{(double)INFINITY, (double)INFINITY, (double)INFINITY}, {0.01805931749247507, -0.5473618483462006, 0.00065456791510515}}, .status = PTC_E_INPUT, .u = {0.0, 0.0}, .axes = {PTC_E_INPUT, PTC_E_INPUT}},
    {.command = 1U, .samples = 3U, .told = PTC_E_INPUT, .found = 0U, .is_armed = 0U, .start = 0U, .k = 2U, .y = {{0.6996336673581043, -1.7976931348623157e308, -0.0006919299272028858}, {(double)NAN, -0.18635561213689855, -0.011476286115720824}}, .status = PTC_E_INPUT, .u = {0.0, 0.0}, .axes = {PTC_E_INPUT, PTC_E_INPUT}},
    {.command = 2U, .samples = 4294967295U, .told = PTC_E_RANGE, .found = 0U, .is_armed = 0U, .start = 0U, .k = 2U, .y = {{97.58183031517274, -1.7976931348623157e308, 0.02187774666275906}, {-0.0001537427856080509, 0.012534358564943138, -0.062615478533193}}, .status = PTC_E_RANGE, .u = {0.0, 0.0}, .axes = {PTC_E_RANGE, PTC_OK}},
    {.command = 2U, .samples = 0U, .told = PTC_E_SOON, .found = 0U, .is_armed = 0U, .start = 0U, .k = 7U, .y = {{-0.09994646601518989, 0.00059857080913126, 57.1245072554724}, {0.053412943750614034, 96.6346093152762, 0.00044646922600384765}}, .status = PTC_OK, .u = {-352.5716686957472, -2740.9236558634175}, .axes = {PTC_OK, PTC_OK}},
    {.command = 2U, .samples = 2147483648U, .told = PTC_E_RANGE, .found = 0U, .is_armed = 0U, .start = 0U, .k = 75U, .y = {{0.8081690321044563, 0.021179921754750808, 0.00024813055257037655}, {1.7976931348623157e308, -0.08631917281100004, 4.246511388489527}}, .status = PTC_E_RANGE, .u = {0.0, 0.0}, .axes = {PTC_OK, PTC_E_RANGE}},
    {.command = 1U, .samples = 3000U, .told = PTC_E_INPUT, .found = 0U, .is_armed = 0U, .start = 0U, .k = 75U, .y = {{0.040923446391903484, 0.03381657903833928, -0.3697286683344345}, {-0.07399661318741567, -97.28265734081467, (double)NAN}}, .status = PTC_E_INPUT, .u = {0.0, 0.0}, .axes = {PTC_E_INPUT, PTC_E_INPUT}},
    {.command = 2U, .samples = 3000U, .told = PTC_E_RANGE, .found = 0U, .is_armed = 0U, .start = 0U, .k = 150U, .y = {{-0.0008026385611271955, 0.07826607894205717, 0.0008430188066268849}, {-1.7976931348623157e308, 0.370442000963505, 0.03464854550626822}}, .status = PTC_E_RANGE, .u = {0.0, 0.0}, .axes = {PTC_HOLD, PTC_E_RANGE}},
    {.command = 2U, .samples = 2147483648U, .told = PTC_E_INPUT, .found = 0U, .is_armed = 0U, .start = 0U, .k = 75U, .y = {{(double)NAN, 0.00043169245544928626, -1.7976931348623157e308}, {0.0008809928789989769, 1.7976931348623157e308, -0.03910460717268445}}, .status = PTC_E_INPUT, .u = {0.0, 0.0}, .axes = {PTC_E_INPUT, PTC_E_INPUT}},
    {.command = 2U, .samples = 10U, .told = PTC_E_INPUT, .found = 0U, .is_armed = 0U, .start = 0U, .k = 1U, .y = {{0.009721199471434195, -81.25389366543216, -14.02737481765779}, {(double)INFINITY, 27.03241623453185, (double)INFINITY}}, .status = PTC_E_INPUT, .u = {0.0, 0.0}, .axes = {PTC_E_INPUT, PTC_E_INPUT}},
    {.command = 2U, .samples = 200U, .told = PTC_E_INPUT, .found = 0U, .is_armed = 0U, .start = 0U, .k = 75U, .y = {{0.8021172709687907, 0.7522248575462469, (double)NAN}, {-0.029370779690994088, 0.00034144094742605426, -0.0008379489408357896}}, .status = PTC_E_INPUT, .u = {0.0, 0.0}, .axes = {PTC_E_INPUT, PTC_E_INPUT}},
    {.command = 1U, .samples = 3U, .told = PTC_E_INPUT, .found = 0U, .is_armed = 0U, .start = 0U, .k = 7U, .y = {{-0.38322571224796254, (double)INFINITY, -1.0803901538673832}, {0.0001501116307226078, (double)NAN, 0.13041043662122553}}, .status = PTC_E_INPUT, .u = {0.0, 0.0}, .axes = {PTC_E_INPUT, PTC_E_INPUT}},
    {.command = 2U, .samples = 40U, .told = PTC_E_RANGE, .found = 0U, .is_armed = 0U, .start = 0U, .k = 2U, .y = {{-0.010535779744418883, 0.004771504138217919, -19.27395638086653}, {0.9229074380745106, -1.7976931348623157e308, 1.7976931348623157e308}}, .status = PTC_E_RANGE, .u = {0.0, 0.0}, .axes = {PTC_OK, PTC_E_RANGE}},
    {.command = 1U, .samples = 3000U, .told = PTC_E_SOON, .found = 0U, .is_armed = 0U, .start = 0U, .k = 150U, .y = {{-0.025111036825655964, -0.0005830731862906673, 0.0002984092604403652}, {-0.00033642949763291053, 0.0004392116857499271, -67.6153877998005}}, .status = PTC_HOLD, .u = {25122.643581017364, 12723.79969388134}, .axes = {PTC_HOLD, PTC_HOLD}},
    {.command = 1U, .samples = 10U, .told = PTC_E_SOON, .found = 0U, .is_armed = 0U, .start = 0U, .k = 75U, .y = {{-0.00019258335258086467, -0.02176093651178146, -48.3618601679509}, {0.03171601557328563, -1.7976931348623157e308, -25.38239148433561}}, .status = PTC_E_RANGE, .u = {0.0, 0.0}, .axes = {PTC_OK, PTC_E_RANGE}},
    {.command = 1U, .samples = 10U, .told = PTC_E_SOON, .found = 0U, .is_armed = 0U, .start = 0U, .k = 150U, .y = {{-0.0009001723099297567, 0.025966724325899505, -3.8848210313011226e-5}, {21.780955044726703, -25.92337620872558, 0.5585273826799311}}, .status = PTC_HOLD, .u = {380.8449455836574, -21262589.917239018}, .axes = {PTC_HOLD, PTC_HOLD}},
    {.command = 2U, .samples = 1U, .told = PTC_E_SOON, .found = 0U, .is_armed = 0U, .start = 0U, .k = 1U, .y = {{0.06879205059422207, 0.000242782778213946, 0.05093203252949004}, {-88.09821615528229, -0.5221858877979948, -0.00040629103203682824}}, .status = PTC_OK, .u = {-1.5304630008881293, 3084.3481105850674}, .axes = {PTC_OK, PTC_OK}},
    {.command = 2U, .samples = 40U, .told = PTC_E_INPUT, .found = 0U, .is_armed = 0U, .start = 0U, .k = 7U, .y = {{0.08392123566475565, -0.0009429543161116245, 0.8049924532622679}, {-42.203999081519015, 34.506465910794184, (double)NAN}}, .status = PTC_E_INPUT, .u = {0.0, 0.0}, .axes = {PTC_E_INPUT, PTC_E_INPUT}},
    {.command = 2U, .samples = 10U, .told = PTC_E_INPUT, .found = 0U, .is_armed = 0U, .start = 0U, .k = 150U, .y = {{50.840913672939145, 64.96324323827652, 50.86554447684979}, {13.47392233027367, (double)INFINITY, -0.16703016217509115}}, .status = PTC_E_INPUT, .u = {0.0, 0.0}, .axes = {PTC_E_INPUT, PTC_E_INPUT}},
    {.command = 2U, .samples = 1048576U, .told = PTC_E_SOON, .found = 0U, .is_armed = 0U, .start = 0U, .k = 2U, .y = {{0.12573973102343428, 0.6720424872503394, -0.2871816770845881}, {-0.7126622397762992, -89.07630747011292, 73.80540259194997}}, .status = PTC_OK, .u = {-11.406904267330662, 1800.3908736435208}, .axes = {PTC_OK, PTC_OK}},
    {.command = 1U, .samples = 40U, .told = PTC_E_SOON, .found = 0U, .is_armed = 0U, .start = 0U, .k = 1U, .y = {{-0.05546810531266114, 2.6655799784011115e-5, 0.026531908596776035}, {-0.052101780797317934, 1.7976931348623157e308, -0.0006027527495754139}}, .status = PTC_E_RANGE, .u = {0.0, 0.0}, .axes = {PTC_OK, PTC_E_RANGE}},
    {.command = 2U, .samples = 1048576U, .told = PTC_E_SOON, .found = 0U, .is_armed = 0U, .start = 0U, .k = 7U, .y = {{-0.02454868101677854, -0.06822464530883991, -0.0004292930285767518}, {0.8417023895549647, -0.5178854712826058, 0.6280161531425088}}, .status = PTC_OK, .u = {1.67499552777157, -23.59882478210356}, .axes = {PTC_OK, PTC_OK}},
    {.command = 2U, .samples = 3000U, .told = PTC_E_SOON, .found = 0U, .is_armed = 0U, .start = 0U, .k = 150U, .y = {{-0.0002273180704330784, 0.07474012078315972, -0.04627404587264186}, {0.22785300915969686, 0.693697167262604, -0.0009592612893479009}}, .status = PTC_HOLD, .u = {-1259.0007701534648, -241726.77664037922}, .axes = {PTC_HOLD, PTC_HOLD}},
    {.command = 2U, .samples = 0U, .told = PTC_E_SOON, .found = 0U, .is_armed = 0U, .start = 0U, .k = 75U, .y = {{-0.018244097694638528, 0.8483280656200971, -0.15731950817435503}, {60.16370671197022, 0.07226198969158129, 6.061192056727149e-5}}, .status = PTC_OK, .u = {-48.08596659171256, -15823.957566704907}, .axes = {PTC_OK, PTC_OK}},
    {.command = 2U, .samples = 0U, .told = PTC_E_SOON, .found = 0U, .is_armed = 0U, .start = 0U, .k = 150U, .y = {{-0.6636642716634422, 0.10399806486022833, -0.00010527171430201011}, {-0.07691022609970005, -0.5922273114269019, 9.126368437519883e-5}}, .status = PTC_HOLD, .u = {661584.329666052, 88754.7555965626}, .axes = {PTC_HOLD, PTC_HOLD}},
    {.command = 1U, .samples = 40U, .told = PTC_E_SOON, .found = 0U, .is_armed = 0U, .start = 0U, .k = 1U, .y = {{0.09373889117129396, 0.0008739827088581484, 0.06026699165817626}, {0.30953603137101804, -0.9121867804840029, 0.0007104720924369867}}, .status = PTC_OK, .u = {-2.039676243776286, 13.051365024359573}, .axes = {PTC_OK, PTC_OK}},
    {.command = 2U, .samples = 1048576U, .told = PTC_E_RANGE, .found = 0U, .is_armed = 0U, .start = 0U, .k = 150U, .y = {{-0.000998487813857788, -0.24805236115644802, -0.0002454040655693399}, {-38.49859273244074, 1.7976931348623157e308, -0.6494209490107807}}, .status = PTC_E_RANGE, .u = {0.0, 0.0}, .axes = {PTC_HOLD, PTC_E_RANGE}},
    {.command = 2U, .samples = 0U, .told = PTC_E_RANGE, .found = 0U, .is_armed = 0U, .start = 0U, .k = 1U, .y = {{0.13926906421292173, 0.0011085815110188247, -0.0005528694957566414}, {-0.00030856724080191377, -1.7976931348623157e308, -0.6648730165902186}}, .status = PTC_E_RANGE, .u = {0.0, 0.0}, .axes = {PTC_OK, PTC_E_RANGE}},
    {.command = 2U, .samples = 40U, .told = PTC_E_SOON, .found = 0U, .is_armed = 0U, .start = 0U, .k = 150U, .y = {{82.01744336507181, -0.6864562272956563, 0.006080434265836621}, {-0.000916753951662128, -0.0009832618161370365, 11.4467842794435}}, .status = PTC_HOLD, .u = {-82003715.35527219, -1162.1579299131065}, .axes = {PTC_HOLD, PTC_HOLD}},
    {.command = 1U, .samples = 40U, .told = PTC_E_INPUT, .found = 0U, .is_armed = 0U, .start = 0U, .k = 150U, .y = {{0.05073556011831459, 0.0006547274704380826, -0.006374457677006774}, {0.01967617133234494, (double)NAN, 0.0008425294503047079}}, .status = PTC_E_INPUT, .u = {0.0, 0.0}, .axes = {PTC_E_INPUT, PTC_E_INPUT}},
    {.command = 2U, .samples = 0U, .told = PTC_OK, .found = 473U, .is_armed = 0U, .start = 0U, .k = 1U, .y = {{-0.03848402253861119, 0.0008678839069941082, -0.045133324938019005}, {-0.870416388334422, -0.07772139612023472, 0.5884042678197412}}, .status = PTC_OK, .u = {0.939375015562146, 27.740439547463648}, .axes = {PTC_OK, PTC_OK}},
    {.command = 2U, .samples = 0U, .told = PTC_E_SOON, .found = 0U, .is_armed = 0U, .start = 0U, .k = 7U, .y = {{-74.96067750108854, 0.8645689416442341, 0.004107506415792584}, {-52.73780644260131, 0.0005831687633161106, -33.576915695679446}}, .status = PTC_OK, .u = {1491.3567934852724, 2350.975559049796}, .axes = {PTC_OK, PTC_OK}},
    {.command = 1U, .samples = 3000U, .told = PTC_OK, .found = 0U, .is_armed = 0U, .start = 0U, .k = 1U, .y = {{0.0008023436162112785, 0.08668754552487115, 0.08706691801197342}, {-0.0005650106132183101, -0.07682880192754148, 0.00245492107359675}}, .status = PTC_OK, .u = {-0.029568877376883594, 0.004135076449199766}, .axes = {PTC_OK, PTC_OK}},
    {.command = 2U, .samples = 4294967295U, .told = PTC_E_RANGE, .found = 0U, .is_armed = 0U, .start = 0U, .k = 2U, .y = {{-0.0006935810380841789, -0.08599235764203722, 0.21902922516374557}, {-1.7976931348623157e308, -0.9207035240716206, 0.0007225260541219458}}, .status = PTC_E_RANGE, .u = {0.0, 0.0}, .axes = {PTC_OK, PTC_E_RANGE}},
    {.command = 2U, .samples = 1048576U, .told = PTC_OK, .found = 380U, .is_armed = 0U, .start = 0U, .k = 7U, .y = {{-0.0009747767588109639, 0.007266586534629838, 0.5427415747233921}, {0.6653376176480938, -0.0006011065758511387, 0.00033657654877880663}}, .status = PTC_OK, .u = {-0.16332925578191296, -0.0030634917024946655}, .axes = {PTC_OK, PTC_OK}},
    {.command = 1U, .samples = 40U, .told = PTC_E_SOON, .found = 0U, .is_armed = 0U, .start = 0U, .k = 150U, .y = {{-0.08396872113001629, 0.6723909395140608, -0.023709177910933167}, {-0.27027514117012896, -0.95617530388371, -0.0939680422258499}}, .status = PTC_OK, .u = {-0.022056109027619692, 0.11135818989683212}, .axes = {PTC_OK, PTC_OK}},
    {.command = 1U, .samples = 40U, .told = PTC_E_SOON, .found = 0U, .is_armed = 0U, .start = 0U, .k = 150U, .y = {{-0.00032702075978245724, 0.08500334277944635, -0.000996009417043913}, {-0.015632117245720334, 0.9884786922909243, -0.9853804440199991}}, .status = PTC_OK, .u = {-0.003446255726365981, 0.3414849115109615}, .axes = {PTC_OK, PTC_OK}},
    {.command = 1U, .samples = 40U, .told = PTC_E_SOON, .found = 0U, .is_armed = 0U, .start = 0U, .k = 75U, .y = {{0.0005375183470063354, -0.09976076678705131, -0.0003432881548649969}, {-0.00046834564531323867, 0.3709901947334917, 0.00027310827557430707}}, .status = PTC_OK, .u = {0.0042952356562900905, -0.02606476515210082}, .axes = {PTC_OK, PTC_OK}},
    {.command = 2U, .samples = 3000U, .told = PTC_OK, .found = 63U, .is_armed = 0U, .start = 0U, .k = 1U, .y = {{0.017877295640582113, 0.011896274780927052, 0.08001947581269496}, {-0.09772541399902068, -0.07070698078837594, 0.43643530422430166}}, .status = PTC_OK, .u = {-0.024504966059734044, -0.1692312611289905}, .axes = {PTC_OK, PTC_OK}},
    {.command = 2U, .samples = 200U, .told = PTC_OK, .found = 275U, .is_armed = 0U, .start = 0U, .k = 150U, .y = {{-0.0005674270915461326, -0.06473833428637076, 0.8495875145572287}, {-0.5701785285140508, 0.2215494496619299, -0.47268994847626344}}, .status = PTC_OK, .u = {-0.26514262257706905, 0.18533445677206364}, .axes = {PTC_OK, PTC_OK}},
    {.command = 2U, .samples = 3000U, .told = PTC_E_SOON, .found = 0U, .is_armed = 0U, .start = 0U, .k = 75U, .y = {{0.00043884483349420836, 0.18839626338378057, 0.755123233928666}, {0.024184204576081947, 12.481566795201138, -0.0002349200770138311}}, .status = PTC_OK, .u = {-0.24002323464735234, -0.8732519231801621}, .axes = {PTC_OK, PTC_OK}},
    {.command = 2U, .samples = 3000U, .told = PTC_E_SOON, .found = 0U, .is_armed = 0U, .start = 0U, .k = 150U, .y = {{0.036842409973177004, 6.927553378919793e-5, -65.52586185363171}, {54.22184158751582, -0.33703902085850146, 0.6472044413348843}}, .status = PTC_OK, .u = {20.67052109008292, -0.5274303264368156}, .axes = {PTC_OK, PTC_OK}},
    {.command = 2U, .samples = 200U, .told = PTC_OK, .found = 76U, .is_armed = 0U, .start = 0U, .k = 2U, .y = {{0.04187193424952256, 0.44698010816080247, -0.0003771381700366876}, {0.0009589995483884737, 0.035444925042001474, 0.04562804238775933}}, .status = PTC_OK, .u = {-0.017855178156612896, -0.020600911234367768}, .axes = {PTC_OK, PTC_OK}},
    {.command = 1U, .samples = 1048576U, .told = PTC_E_SOON, .found = 0U, .is_armed = 0U, .start = 0U, .k = 75U, .y = {{0.00014719123070238083, -8.884121418086965e-5, 0.00014046951824802067}, {-17.0964648220181, 0.13905602298444286, -0.29003000823417757}}, .status = PTC_OK, .u = {-3.9797020801063216e-5, 0.19080394656854843}, .axes = {PTC_OK, PTC_OK}},
    {.command = 2U, .samples = 4294967295U, .told = PTC_E_SOON, .found = 0U, .is_armed = 0U, .start = 0U, .k = 1U, .y = {{-0.07474822159203678, -0.00012699696618606528, 7.460910631542705}, {0.53894975249946, 29.31221737731793, -0.8876979986620739}}, .status = PTC_OK, .u = {-2.2366110401249983, -1.598620174294639}, .axes = {PTC_OK, PTC_OK}},
    {.command = 1U, .samples = 10U, .told = PTC_E_SOON, .found = 0U, .is_armed = 0U, .start = 0U, .k = 7U, .y = {{-0.0007289707561258008, 0.015374030914077186, -0.0009098233836357872}, {-0.08488408390306962, -0.039929505068358885, 0.8122214926337206}}, .status = PTC_OK, .u = {-0.00034193946953618715, -0.32211258333486914}, .axes = {PTC_OK, PTC_OK}},
    {.command = 1U, .samples = 3000U, .told = PTC_E_SOON, .found = 0U, .is_armed = 0U, .start = 0U, .k = 7U, .y = {{0.04555296152441995, 0.28010990785653034, -0.2797140667711171}, {-0.00021913242326887563, -0.0005651980348726933, -0.02910501096378526}}, .status = PTC_OK, .u = {0.07268518369374703, 0.01169045937889831}, .axes = {PTC_OK, PTC_OK}},
    {.command = 1U, .samples = 3000U, .told = PTC_E_SOON, .found = 0U, .is_armed = 0U, .start = 0U, .k = 75U, .y = {{0.5706781811807173, -0.5601323486677592, 0.08416525934611363}, {-0.0008389352981299303, 0.512425806765916, 0.0004947413615387286}}, .status = PTC_OK, .u = {-0.0037044575256236713, -0.036048866454794326}, .axes = {PTC_OK, PTC_OK}},
    {.command = 1U, .samples = 10U, .told = PTC_E_SOON, .found = 0U, .is_armed = 0U, .start = 0U, .k = 150U, .y = {{-0.0002693646797755647, 0.0004520454908577061, 19.227142272619723}, {0.000961880671791167, -38.70992060638911, 40.22293576818128}}, .status = PTC_OK, .u = {-6.065364037058187, -14.056829848742805}, .axes = {PTC_OK, PTC_OK}},
    {.command = 2U, .samples = 3000U, .told = PTC_OK, .found = 61U, .is_armed = 0U, .start = 0U, .k = 75U, .y = {{-0.05100260403723007, -0.0776867091856921, -0.0748355114050765}, {0.08272714262397476, 0.07759333761476031, -0.0006226606114898368}}, .status = PTC_OK, .u = {0.026388411720850723, -0.0055689816969478525}, .axes = {PTC_OK, PTC_OK}},
    {.command = 1U, .samples = 10U, .told = PTC_E_SOON, .found = 0U, .is_armed = 0U, .start = 0U, .k = 150U, .y = {{0.00033597770251168966, 0.04235164859604328, 91.99539887694723}, {0.0007083919010550632, 21.44349554586935, 0.05743504297067812}}, .status = PTC_OK, .u = {-29.022506234392605, -1.6042724293679842}, .axes = {PTC_OK, PTC_OK}},
    {.command = 1U, .samples = 40U, .told = PTC_E_SOON, .found = 0U, .is_armed = 0U, .start = 0U, .k = 75U, .y = {{-0.0008612207045334194, 0.6759171744404033, 0.005531733051329368}, {-38.86753963410201, 0.0005218180087157709, -1.7976931348623157e308}}, .status = PTC_E_RANGE, .u = {0.0, 0.0}, .axes = {PTC_OK, PTC_E_RANGE}},
    {.command = 1U, .samples = 10U, .told = PTC_E_SOON, .found = 0U, .is_armed = 0U, .start = 0U, .k = 75U, .y = {{0.00035626076547181306, -0.017411729637284212, 0.38369585275747076}, {-0.000597498435374258, -0.00019834849893695817, 34.59957043767581}}, .status = PTC_OK, .u = {-0.11720867845821076, -14.172873695070797}, .axes = {PTC_OK, PTC_OK}},
    {.command = 2U, .samples = 0U, .told = PTC_E_SOON, .found = 0U, .is_armed = 0U, .start = 0U, .k = 1U, .y = {{-0.000990762474749633, 0.41673772512531504, 9.292571771628545e-5}, {0.0007527249197535299, -0.0491563737232317, 4.1394191121485235}}, .status = PTC_OK, .u = {-0.016680362417701582, -1.6505697926995333}, .axes = {PTC_OK, PTC_OK}},
    {.command = 2U, .samples = 3U, .told = PTC_E_SOON, .found = 0U, .is_armed = 0U, .start = 0U, .k = 2U, .y = {{5.345411941184963e-5, 0.39396311886387747, -0.03306869669031751}, {-86.01246106730036, 20.42811585713842, -3.7470400890145195}}, .status = PTC_OK, .u = {-0.005837839913366574, 0.5189500426928519}, .axes = {PTC_OK, PTC_OK}},
    {.command = 1U, .samples = 3000U, .told = PTC_E_SOON, .found = 0U, .is_armed = 0U, .start = 0U, .k = 75U, .y = {{0.09148146942879053, 0.0030862559454259753, -0.08745767603663435}, {0.0007262128518618485, 0.0007370143411535331, -0.33265110623842853}}, .status = PTC_OK, .u = {0.026533942699006097, 0.13620757285823748}, .axes = {PTC_OK, PTC_OK}},
    {.command = 1U, .samples = 1048576U, .told = PTC_E_SOON, .found = 0U, .is_armed = 0U, .start = 0U, .k = 2U, .y = {{41.96157445090447, 0.0009929315242199889, -0.00042180315716395866}, {0.5144015758923917, -0.0004437380563560083, 0.15991842016361635}}, .status = PTC_OK, .u = {-0.09316116324042538, -0.06616849515245475}, .axes = {PTC_OK, PTC_OK}},
    {.command = 2U, .samples = 4294967295U, .told = PTC_OK, .found = 74U, .is_armed = 0U, .start = 0U, .k = 7U, .y = {{-0.026280989802174415, 0.02300782546187241, -0.08588076007744389}, {0.00578883782507127, 0.4048390744938699, -0.0004725535234929763}}, .status = PTC_OK, .u = {0.024934139046199455, -0.02688901004002047}, .axes = {PTC_OK, PTC_OK}},
    {.command = 1U, .samples = 200U, .told = PTC_E_SOON, .found = 0U, .is_armed = 0U, .start = 0U, .k = 75U, .y = {{-0.0007557108634664016, -0.000350941067103518, -0.9540028669107086}, {0.0004360097017214169, 84.01277785325863, -13.8482902299341}}, .status = PTC_OK, .u = {0.2932551451382241, -0.2050625174977248}, .axes = {PTC_OK, PTC_OK}},
    {.command = 2U, .samples = 200U, .told = PTC_OK, .found = 12U, .is_armed = 0U, .start = 0U, .k = 1U, .y = {{0.006813905068302151, -0.0009943328000781373, 0.06255765811869274}, {0.0004907877289685748, 0.020830380255259875, -0.21342452465586215}}, .status = PTC_OK, .u = {-0.018730183598950657, 0.0838817664937712}, .axes = {PTC_OK, PTC_OK}},
    {.command = 1U, .samples = 3U, .told = PTC_E_SOON, .found = 0U, .is_armed = 0U, .start = 0U, .k = 150U, .y = {{-0.0009506195320275359, 0.03129649384938045, 0.009967075848533603}, {-0.0006009933791067006, 0.0005162955007973178, -0.0003043414363721322}}, .status = PTC_OK, .u = {-0.00452656317023314, 9.300267141076585e-5}, .axes = {PTC_OK, PTC_OK}},
    {.command = 1U, .samples = 40U, .told = PTC_E_SOON, .found = 0U, .is_armed = 0U, .start = 0U, .k = 150U, .y = {{0.0007827245427557317, 0.031032916961731938, 6.907342956226237}, {0.6761897454739945, 0.08160768587217798, 52.95660988229738}}, .status = PTC_OK, .u = {-2.1803477962871085, -22.271875367346908}, .axes = {PTC_OK, PTC_OK}},
    {.command = 2U, .samples = 40U, .told = PTC_OK, .found = 38U, .is_armed = 0U, .start = 0U, .k = 2U, .y = {{-0.00013348242763289387, 0.0008190466561284015, -0.017945277922977045}, {-0.042510590743526255, -0.0003238533150685281, 0.0007367960658877273}}, .status = PTC_OK, .u = {0.005349331618185527, -8.415720124078773e-5}, .axes = {PTC_OK, PTC_OK}},
    {.command = 2U, .samples = 3000U, .told = PTC_E_SOON, .found = 0U, .is_armed = 0U, .start = 0U, .k = 1U, .y = {{0.0005012414632111344, 0.17103139777301557, 0.09984537348501266}, {-0.6596497368265117, 0.05893378598518404, 0.8302291301732649}}, .status = PTC_OK, .u = {-0.036769949122609766, -0.33270110593775215}, .axes = {PTC_OK, PTC_OK}},
    {.command = 2U, .samples = 3000U, .told = PTC_E_SOON, .found = 0U, .is_armed = 0U, .start = 0U, .k = 2U, .y = {{-0.00058528909137749, 0.0007044739952730932, 0.0009656122781492842}, {-0.27061831466871555, -0.09300636068722733, 29.416362468358347}}, .status = PTC_OK, .u = {-0.0003164592199263608, -11.749351379515028}, .axes = {PTC_OK, PTC_OK}},
    {.command = 2U, .samples = 3U, .told = PTC_OK, .found = 7U, .is_armed = 0U, .start = 0U, .k = 7U, .y = {{0.0009833933044963135, 0.00613212674995014, 0.08840988114421944}, {-0.00013710929276791563, -0.03058974286105758, -2.287070602382779}}, .status = PTC_OK, .u = {-0.026806622432280734, 0.9176358859996173}, .axes = {PTC_OK, PTC_OK}},
    {.command = 1U, .samples = 40U, .told = PTC_E_SOON, .found = 0U, .is_armed = 0U, .start = 0U, .k = 75U, .y = {{0.0003588901012705461, 0.2941802764553709, -0.01785600428569203}, {8.56939988139136e-5, -0.0009124250237982463, -0.44012820686998877}}, .status = PTC_OK, .u = {-0.006871002494621689, 0.18035146843311795}, .axes = {PTC_OK, PTC_OK}},
    {.command = 1U, .samples = 200U, .told = PTC_E_SOON, .found = 0U, .is_armed = 0U, .start = 0U, .k = 75U, .y = {{0.7790341964012164, -0.06687815508557889, -2.55081204938854}, {-1.7976931348623157e308, 0.9270604330922576, -0.0009798674073141838}}, .status = PTC_E_RANGE, .u = {0.0, 0.0}, .axes = {PTC_OK, PTC_E_RANGE}},
    {.command = 1U, .samples = 200U, .told = PTC_E_SOON, .found = 0U, .is_armed = 0U, .start = 0U, .k = 7U, .y = {{0.6656289800869863, -0.7863780962157587, -0.0006853781035563294}, {0.07320585990486228, 0.014176023177325359, 0.757719344683417}}, .status = PTC_OK, .u = {0.030272507071619808, -0.30461444916631514}, .axes = {PTC_OK, PTC_OK}},
    {.command = 2U, .samples = 3U, .told = PTC_E_SOON, .found = 0U, .is_armed = 0U, .start = 0U, .k = 1U, .y = {{0.0006288158275973415, 0.03041828907884534, -0.09681135729188634}, {0.0004813880877690526, -0.8504544838285539, -0.06437735186197013}}, .status = PTC_OK, .u = {0.027807011725299525, 0.08232138677525243}, .axes = {PTC_OK, PTC_OK}},
};

/* 1 where a number is not the one that must come. */
static uint32_t table_too_soon_selftest_differs(double value, double wanted)
{
    uint32_t failures = 1U;

    if (fabs(value - wanted) <= 0.0) {
        failures = 0U;
    }
    return failures;
}

/* The failures of what is called before a call. */
static uint32_t table_too_soon_selftest_command(table_too_soon *self, const table_too_soon_selftest_call *call)
{
    uint32_t failures = 0U;
    uint32_t found = 0U;
    ptc_status told = call->told;

    switch (call->command) {
    case 1U:
        told = table_too_soon_arm_for(self, call->k, call->samples, call->y);
        break;
    case 2U:
        told = table_too_soon_soonest(self, call->y, &found);
        break;
    case 3U:
        told = table_too_soon_deadline(self, &found);
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
static uint32_t table_too_soon_selftest_check(table_too_soon *self, const table_too_soon_selftest_call *call)
{
    uint32_t failures = 0U;
    double u[2] = {12345.0, 12345.0};
    ptc_status axes[2] = {PTC_E_PARAM, PTC_E_PARAM};

    if (call->is_armed != 0U) {
        if (table_too_soon_arm(self, call->start) != PTC_OK) {
            failures++;
        }
    }
    failures += table_too_soon_selftest_command(self, call);
    if (table_too_soon_step(self, call->k, call->y, u, axes) != call->status) {
        failures++;
    }
    for (uint32_t i = 0U; i < 2U; i++) {
        failures += table_too_soon_selftest_differs(u[i], call->u[i]);
        if (axes[i] != call->axes[i]) {
            failures++;
        }
    }
    return failures;
}

/* The calls of a session, of which init has been called. */
static uint32_t table_too_soon_selftest_calls_of(table_too_soon *self, const table_too_soon_selftest_session *session)
{
    uint32_t failures = 0U;

    for (uint32_t j = 0U; j < session->count; j++) {
        failures += table_too_soon_selftest_check(self, &table_too_soon_selftest_calls[session->first + j]);
    }
    return failures;
}

/* Every session with its calls. */
static uint32_t table_too_soon_selftest_run(void)
{
    uint32_t failures = 0U;

    for (uint32_t i = 0U; i < 6U; i++) {
        const table_too_soon_selftest_session *session = &table_too_soon_selftest_sessions[i];
        table_too_soon self;

        if (table_too_soon_init(&self, &session->params) == PTC_OK) {
            failures += table_too_soon_selftest_calls_of(&self, session);
        } else {
            failures++;
        }
    }
    return failures;
}

/* What init must refuse without a change. */
static uint32_t table_too_soon_selftest_refuse(void)
{
    static const table_too_soon_params refused[4] = {
        {.u_max = (double)NAN, .u_min = -(double)INFINITY},
        {.u_max = -(double)INFINITY, .u_min = -(double)INFINITY},
        {.u_max = (double)INFINITY, .u_min = (double)NAN},
        {.u_max = (double)INFINITY, .u_min = (double)INFINITY},
    };
    const table_too_soon_selftest_session *session = &table_too_soon_selftest_sessions[0];
    uint32_t failures = 0U;
    table_too_soon self;

    if (table_too_soon_init(&self, &session->params) != PTC_OK) {
        failures++;
    }
    for (uint32_t i = 0U; i < 4U; i++) {
        if (table_too_soon_init(&self, &refused[i]) != PTC_E_PARAM) {
            failures++;
        }
    }
    if (table_too_soon_init(&self, NULL) != PTC_E_PARAM) {
        failures++;
    }
    if (table_too_soon_init(NULL, &session->params) != PTC_E_PARAM) {
        failures++;
    }
    failures += table_too_soon_selftest_calls_of(&self, session);
    return failures;
}

/* Calls that lack a pointer: each is refused, and changes nothing. */
static uint32_t table_too_soon_selftest_pointers(void)
{
    const table_too_soon_selftest_session *session = &table_too_soon_selftest_sessions[0];
    const table_too_soon_selftest_call *call = &table_too_soon_selftest_calls[0];
    uint32_t failures = 0U;
    double u[2] = {12345.0, 12345.0};
    ptc_status axes[2] = {PTC_E_PARAM, PTC_E_PARAM};
    table_too_soon self;

    if (table_too_soon_init(&self, &session->params) != PTC_OK) {
        failures++;
    }
    if (table_too_soon_arm(NULL, call->start) != PTC_E_INPUT) {
        failures++;
    }
    if (table_too_soon_step(NULL, call->k, call->y, u, axes) != PTC_E_INPUT) {
        failures++;
    }
    for (uint32_t i = 0U; i < 2U; i++) {
        failures += table_too_soon_selftest_differs(u[i], 0.0);
        u[i] = 12345.0;
    }
    if (table_too_soon_step(&self, call->k, call->y, u, NULL) != PTC_E_INPUT) {
        failures++;
    }
    for (uint32_t i = 0U; i < 2U; i++) {
        failures += table_too_soon_selftest_differs(u[i], 0.0);
        u[i] = 12345.0;
    }
    if (table_too_soon_step(&self, call->k, NULL, u, axes) != PTC_E_INPUT) {
        failures++;
    }
    for (uint32_t i = 0U; i < 2U; i++) {
        failures += table_too_soon_selftest_differs(u[i], 0.0);
    }
    if (table_too_soon_step(&self, call->k, call->y, NULL, axes) != PTC_E_INPUT) {
        failures++;
    }
    failures += table_too_soon_selftest_calls_of(&self, session);
    return failures;
}

uint32_t table_too_soon_selftest(void)
{
    uint32_t failures = table_too_soon_selftest_run();

    failures += table_too_soon_selftest_refuse();
    failures += table_too_soon_selftest_pointers();
    return failures;
}
