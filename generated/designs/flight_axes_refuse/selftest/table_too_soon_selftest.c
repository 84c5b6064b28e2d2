/* Self-test of the prescribed-time controller table_too_soon: see table_too_soon_selftest.h. DO NOT EDIT. */
#include "table_too_soon_selftest.h"
#include "table_too_soon.h"

#include <math.h>
#include <stddef.h>

/* A call, and what it must give. */
typedef struct table_too_soon_selftest_call {
    uint32_t is_armed; /* arm is called before it */
    uint32_t start;
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

static const table_too_soon_selftest_session table_too_soon_selftest_sessions[5] = {
    {.params = {.u_max = (double)INFINITY, .u_min = -(double)INFINITY}, .first = 0U, .count = 72U},
    {.params = {.u_max = (double)INFINITY, .u_min = -(double)INFINITY}, .first = 72U, .count = 1U},
    {.params = {.u_max = (double)INFINITY, .u_min = -(double)INFINITY}, .first = 73U, .count = 2U},
    {.params = {.u_max = 1.0, .u_min = -(double)INFINITY}, .first = 75U, .count = 2U},
    {.params = {.u_max = (double)INFINITY, .u_min = -0.5}, .first = 77U, .count = 1U},
};

static const table_too_soon_selftest_call table_too_soon_selftest_calls[78] = {
    {.is_armed = 0U, .start = 0U, .k = 0U, .y = {{0.75, 0.25, -0.25}, {-0.75, -1.25, -1.75}}, .status = PTC_OK, .u = {-15.520419426048566, 71.55921593686853}, .axes = {PTC_OK, PTC_OK}},
    {.is_armed = 0U, .start = 0U, .k = 1U, .y = {{0.7400333333333332, 0.24667777777777775, -0.24667777777777775}, {-0.7400333333333332, -1.2333888888888886, -1.7267444444444442}}, .status = PTC_OK, .u = {-15.6159309296051, 71.62402628609787}, .axes = {PTC_OK, PTC_OK}},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {{0.7301333333333334, 0.2433777777777778, -0.2433777777777778}, {-0.7301333333333334, -1.2168888888888891, -1.7036444444444445}}, .status = PTC_OK, .u = {-15.712574695500876, 71.6908859093326}, .axes = {PTC_OK, PTC_OK}},
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
    {.is_armed = 0U, .start = 0U, .k = 71U, .y = {{0.2080333333333333, 0.06934444444444443, -0.06934444444444443}, {-0.2080333333333333, -0.34672222222222215, -0.485411111111111}}, .status = PTC_OK, .u = {-27.480919410150893, 85.3623116112951}, .axes = {PTC_OK, PTC_OK}},
    {.is_armed = 0U, .start = 0U, .k = 73U, .y = {{0.19763333333333333, 0.06587777777777777, -0.06587777777777777}, {-0.19763333333333333, -0.32938888888888884, -0.4611444444444444}}, .status = PTC_OK, .u = {-28.10676331638357, 86.25423843268779}, .axes = {PTC_OK, PTC_OK}},
    {.is_armed = 0U, .start = 0U, .k = 74U, .y = {{0.1925333333333334, 0.06417777777777779, -0.06417777777777779}, {-0.1925333333333334, -0.32088888888888895, -0.44924444444444456}}, .status = PTC_OK, .u = {-28.431176231176245, 86.71979040181574}, .axes = {PTC_OK, PTC_OK}},
    {.is_armed = 0U, .start = 0U, .k = 75U, .y = {{0.1875, 0.0625, -0.0625}, {-0.1875, -0.3125, -0.4375}}, .status = PTC_OK, .u = {-28.76364205969469, 87.19903999509263}, .axes = {PTC_OK, PTC_OK}},
    {.is_armed = 0U, .start = 0U, .k = 76U, .y = {{0.18253333333333335, 0.06084444444444445, -0.06084444444444445}, {-0.18253333333333335, -0.3042222222222223, -0.42591111111111113}}, .status = PTC_OK, .u = {-29.10447407407408, 87.69249570390625}, .axes = {PTC_OK, PTC_OK}},
    {.is_armed = 0U, .start = 0U, .k = 112U, .y = {{0.04813333333333335, 0.016044444444444448, -0.016044444444444448}, {-0.04813333333333335, -0.08022222222222224, -0.11231111111111114}}, .status = PTC_OK, .u = {-52.09193732193734, 122.90280244597322}, .axes = {PTC_OK, PTC_OK}},
    {.is_armed = 0U, .start = 0U, .k = 146U, .y = {{0.0005333333333333335, 0.0001777777777777778, -0.0001777777777777778}, {-0.0005333333333333335, -0.000888888888888889, -0.0012444444444444447}}, .status = PTC_OK, .u = {-268.9508148148148, 317.6582433862435}, .axes = {PTC_OK, PTC_OK}},
    {.is_armed = 0U, .start = 0U, .k = 148U, .y = {{0.00013333333333333337, 4.444444444444445e-5, -4.444444444444445e-5}, {-0.00013333333333333337, -0.00022222222222222226, -0.0003111111111111112}}, .status = PTC_OK, .u = {-134.2140740740741, 137.83481481481485}, .axes = {PTC_OK, PTC_OK}},
    {.is_armed = 0U, .start = 0U, .k = 149U, .y = {{3.333333333333334e-5, 1.1111111111111113e-5, -1.1111111111111113e-5}, {-3.333333333333334e-5, -5.5555555555555565e-5, -7.77777777777778e-5}}, .status = PTC_OK, .u = {-33.55351851851852, 34.45870370370371}, .axes = {PTC_OK, PTC_OK}},
    {.is_armed = 0U, .start = 0U, .k = 150U, .y = {{0.0, 0.0, -0.0}, {-0.0, -0.0, -0.0}}, .status = PTC_HOLD, .u = {0.0, 0.0}, .axes = {PTC_HOLD, PTC_HOLD}},
    {.is_armed = 0U, .start = 0U, .k = 151U, .y = {{0.0, 0.0, -0.0}, {-0.0, -0.0, -0.0}}, .status = PTC_HOLD, .u = {0.0, 0.0}, .axes = {PTC_HOLD, PTC_HOLD}},
    {.is_armed = 0U, .start = 0U, .k = 2147483647U, .y = {{0.0, 0.0, -0.0}, {-0.0, -0.0, -0.0}}, .status = PTC_HOLD, .u = {0.0, 0.0}, .axes = {PTC_HOLD, PTC_HOLD}},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {{0.0, 0.0, -0.0}, {-0.0, -0.0, -0.0}}, .status = PTC_HOLD, .u = {0.0, 0.0}, .axes = {PTC_HOLD, PTC_HOLD}},
    {.is_armed = 1U, .start = 4294967293U, .k = 4294967293U, .y = {{0.75, 0.25, -0.25}, {-0.75, -1.25, -1.75}}, .status = PTC_OK, .u = {-15.520419426048566, 71.55921593686853}, .axes = {PTC_OK, PTC_OK}},
    {.is_armed = 0U, .start = 0U, .k = 4294967294U, .y = {{0.7400333333333332, 0.24667777777777775, -0.24667777777777775}, {-0.7400333333333332, -1.2333888888888886, -1.7267444444444442}}, .status = PTC_OK, .u = {-15.6159309296051, 71.62402628609787}, .axes = {PTC_OK, PTC_OK}},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {{0.7301333333333334, 0.2433777777777778, -0.2433777777777778}, {-0.7301333333333334, -1.2168888888888891, -1.7036444444444445}}, .status = PTC_OK, .u = {-15.712574695500876, 71.6908859093326}, .axes = {PTC_OK, PTC_OK}},
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
    {.is_armed = 0U, .start = 0U, .k = 68U, .y = {{0.2080333333333333, 0.06934444444444443, -0.06934444444444443}, {-0.2080333333333333, -0.34672222222222215, -0.485411111111111}}, .status = PTC_OK, .u = {-27.480919410150893, 85.3623116112951}, .axes = {PTC_OK, PTC_OK}},
    {.is_armed = 0U, .start = 0U, .k = 70U, .y = {{0.19763333333333333, 0.06587777777777777, -0.06587777777777777}, {-0.19763333333333333, -0.32938888888888884, -0.4611444444444444}}, .status = PTC_OK, .u = {-28.10676331638357, 86.25423843268779}, .axes = {PTC_OK, PTC_OK}},
    {.is_armed = 0U, .start = 0U, .k = 71U, .y = {{0.1925333333333334, 0.06417777777777779, -0.06417777777777779}, {-0.1925333333333334, -0.32088888888888895, -0.44924444444444456}}, .status = PTC_OK, .u = {-28.431176231176245, 86.71979040181574}, .axes = {PTC_OK, PTC_OK}},
    {.is_armed = 0U, .start = 0U, .k = 72U, .y = {{0.1875, 0.0625, -0.0625}, {-0.1875, -0.3125, -0.4375}}, .status = PTC_OK, .u = {-28.76364205969469, 87.19903999509263}, .axes = {PTC_OK, PTC_OK}},
    {.is_armed = 0U, .start = 0U, .k = 73U, .y = {{0.18253333333333335, 0.06084444444444445, -0.06084444444444445}, {-0.18253333333333335, -0.3042222222222223, -0.42591111111111113}}, .status = PTC_OK, .u = {-29.10447407407408, 87.69249570390625}, .axes = {PTC_OK, PTC_OK}},
    {.is_armed = 0U, .start = 0U, .k = 109U, .y = {{0.04813333333333335, 0.016044444444444448, -0.016044444444444448}, {-0.04813333333333335, -0.08022222222222224, -0.11231111111111114}}, .status = PTC_OK, .u = {-52.09193732193734, 122.90280244597322}, .axes = {PTC_OK, PTC_OK}},
    {.is_armed = 0U, .start = 0U, .k = 143U, .y = {{0.0005333333333333335, 0.0001777777777777778, -0.0001777777777777778}, {-0.0005333333333333335, -0.000888888888888889, -0.0012444444444444447}}, .status = PTC_OK, .u = {-268.9508148148148, 317.6582433862435}, .axes = {PTC_OK, PTC_OK}},
    {.is_armed = 0U, .start = 0U, .k = 145U, .y = {{0.00013333333333333337, 4.444444444444445e-5, -4.444444444444445e-5}, {-0.00013333333333333337, -0.00022222222222222226, -0.0003111111111111112}}, .status = PTC_OK, .u = {-134.2140740740741, 137.83481481481485}, .axes = {PTC_OK, PTC_OK}},
    {.is_armed = 0U, .start = 0U, .k = 146U, .y = {{3.333333333333334e-5, 1.1111111111111113e-5, -1.1111111111111113e-5}, {-3.333333333333334e-5, -5.5555555555555565e-5, -7.77777777777778e-5}}, .status = PTC_OK, .u = {-33.55351851851852, 34.45870370370371}, .axes = {PTC_OK, PTC_OK}},
    {.is_armed = 0U, .start = 0U, .k = 147U, .y = {{0.0, 0.0, -0.0}, {-0.0, -0.0, -0.0}}, .status = PTC_HOLD, .u = {0.0, 0.0}, .axes = {PTC_HOLD, PTC_HOLD}},
    {.is_armed = 0U, .start = 0U, .k = 148U, .y = {{0.0, 0.0, -0.0}, {-0.0, -0.0, -0.0}}, .status = PTC_HOLD, .u = {0.0, 0.0}, .axes = {PTC_HOLD, PTC_HOLD}},
    {.is_armed = 0U, .start = 0U, .k = 2147483644U, .y = {{0.0, 0.0, -0.0}, {-0.0, -0.0, -0.0}}, .status = PTC_HOLD, .u = {0.0, 0.0}, .axes = {PTC_HOLD, PTC_HOLD}},
    {.is_armed = 0U, .start = 0U, .k = 4294967292U, .y = {{0.0, 0.0, -0.0}, {-0.0, -0.0, -0.0}}, .status = PTC_HOLD, .u = {0.0, 0.0}, .axes = {PTC_HOLD, PTC_HOLD}},
    {.is_armed = 0U, .start = 0U, .k = 62U, .y = {{-1.3707302382681494e302, -1.5889774145275112e302, 5.541243690600241e301}, {6.080970471873253e301, 1.262180306843296e302, -1.3922022247799523e302}}, .status = PTC_E_RANGE, .u = {0.0, 0.0}, .axes = {PTC_E_RANGE, PTC_E_RANGE}},
    {.is_armed = 1U, .start = 0U, .k = 47U, .y = {{0.0008546934607866015, -0.0008332559146693069, 935.7205552142666}, {2.0, -1.0, 9.629828438364187e307}}, .status = PTC_E_RANGE, .u = {0.0, 0.0}, .axes = {PTC_OK, PTC_E_RANGE}},
    {.is_armed = 1U, .start = 4294967290U, .k = 1U, .y = {{1.7196768243142753e308, 2.0, 0.5}, {-910.779194033578, 1.0, -0.5}}, .status = PTC_E_RANGE, .u = {0.0, 0.0}, .axes = {PTC_E_RANGE, PTC_OK}},
    {.is_armed = 0U, .start = 0U, .k = 0U, .y = {{0.7328956206719082, -0.6892276204512043, -0.5970377039101031}, {0.5140225585873944, -0.2625251943873232, -0.497291960420174}}, .status = PTC_SATURATED, .u = {1.0, -6.904482119874257}, .axes = {PTC_SATURATED, PTC_OK}},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {{-0.824771727329228, 0.8252152727910428, 0.5767073982363133}, {-0.5137307962057012, 0.5394415430673598, -0.6690152114204218}}, .status = PTC_SATURATED, .u = {-1.8217859786214752, 1.0}, .axes = {PTC_OK, PTC_SATURATED}},
    {.is_armed = 0U, .start = 0U, .k = 0U, .y = {{0.5459016528875701, -0.7242755258082414, 0.8860184074680449}, {0.5356949912435297, 0.6684231700748845, -0.39224647016158853}}, .status = PTC_SATURATED, .u = {-0.5, -0.5}, .axes = {PTC_SATURATED, PTC_SATURATED}},
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

    for (uint32_t i = 0U; i < 5U; i++) {
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
