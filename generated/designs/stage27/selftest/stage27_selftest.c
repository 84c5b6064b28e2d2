/* Self-test of the prescribed-time controller stage27: see stage27_selftest.h. DO NOT EDIT. */
#include "stage27_selftest.h"
#include "stage27.h"

#include <math.h>
#include <stddef.h>

/* A call, and what it must give. */
typedef struct stage27_selftest_call {
    uint32_t is_armed; /* arm is called before it */
    uint32_t start;
    uint32_t k;
    double y[6]; /* what is measured */
    ptc_status status;
    double u[4];
    ptc_status axes[4];
} stage27_selftest_call;

/* A set of parameters that init takes, and the calls with it, one after the other. */
typedef struct stage27_selftest_session {
    stage27_params params;
    uint32_t first; /* of its calls */
    uint32_t count;
} stage27_selftest_session;

static const stage27_selftest_session stage27_selftest_sessions[4] = {
    {.params = {.samples = 60U, .h = 0.015625}, .first = 0U, .count = 72U},
    {.params = {.samples = 60U, .h = 0.015625}, .first = 72U, .count = 1U},
    {.params = {.samples = 60U, .h = 0.015625}, .first = 73U, .count = 1U},
    {.params = {.samples = 60U, .h = 0.015625}, .first = 74U, .count = 3U},
};

static const stage27_selftest_call stage27_selftest_calls[77] = {
    {.is_armed = 0U, .start = 0U, .k = 0U, .y = {0.75, 0.25, -0.25, -0.75, -1.25, -1.75}, .status = PTC_OK, .u = {1.3123857719828405, -7.078819464238418, -17.94441362562511, 31.455545851115968}, .axes = {PTC_OK, PTC_OK, PTC_OK, PTC_OK}},
    {.is_armed = 0U, .start = 0U, .k = 1U, .y = {0.7252083333333332, 0.2417361111111111, -0.2417361111111111, -0.7252083333333332, -1.2086805555555555, -1.6921527777777776}, .status = PTC_OK, .u = {1.1480062806112632, -6.632035734495353, -17.02360911260481, 31.095854783269335}, .axes = {PTC_OK, PTC_OK, PTC_OK, PTC_OK}},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {0.7008333333333333, 0.2336111111111111, -0.2336111111111111, -0.7008333333333333, -1.1680555555555556, -1.6352777777777776}, .status = PTC_OK, .u = {0.9966736471180732, -6.2154100059370245, -16.143331516731983, 30.752857359544144}, .axes = {PTC_OK, PTC_OK, PTC_OK, PTC_OK}},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {(double)NAN, 0.5, 0.5, 0.5, 0.5, 0.5}, .status = PTC_E_INPUT, .u = {0.0, 0.0, 0.0, 0.0}, .axes = {PTC_E_INPUT, PTC_E_INPUT, PTC_E_INPUT, PTC_E_INPUT}},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {0.5, (double)NAN, 0.5, 0.5, 0.5, 0.5}, .status = PTC_E_INPUT, .u = {0.0, 0.0, 0.0, 0.0}, .axes = {PTC_E_INPUT, PTC_E_INPUT, PTC_E_INPUT, PTC_E_INPUT}},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {0.5, 0.5, (double)NAN, 0.5, 0.5, 0.5}, .status = PTC_E_INPUT, .u = {0.0, 0.0, 0.0, 0.0}, .axes = {PTC_E_INPUT, PTC_E_INPUT, PTC_E_INPUT, PTC_E_INPUT}},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {0.5, 0.5, 0.5, (double)NAN, 0.5, 0.5}, .status = PTC_E_INPUT, .u = {0.0, 0.0, 0.0, 0.0}, .axes = {PTC_E_INPUT, PTC_E_INPUT, PTC_E_INPUT, PTC_E_INPUT}},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {0.5, 0.5, 0.5, 0.5, (double)NAN, 0.5}, .status = PTC_E_INPUT, .u = {0.0, 0.0, 0.0, 0.0}, .axes = {PTC_E_INPUT, PTC_E_INPUT, PTC_E_INPUT, PTC_E_INPUT}},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {0.5, 0.5, 0.5, 0.5, 0.5, (double)NAN}, .status = PTC_E_INPUT, .u = {0.0, 0.0, 0.0, 0.0}, .axes = {PTC_E_INPUT, PTC_E_INPUT, PTC_E_INPUT, PTC_E_INPUT}},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {(double)INFINITY, 0.5, 0.5, 0.5, 0.5, 0.5}, .status = PTC_E_INPUT, .u = {0.0, 0.0, 0.0, 0.0}, .axes = {PTC_E_INPUT, PTC_E_INPUT, PTC_E_INPUT, PTC_E_INPUT}},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {0.5, (double)INFINITY, 0.5, 0.5, 0.5, 0.5}, .status = PTC_E_INPUT, .u = {0.0, 0.0, 0.0, 0.0}, .axes = {PTC_E_INPUT, PTC_E_INPUT, PTC_E_INPUT, PTC_E_INPUT}},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {0.5, 0.5, (double)INFINITY, 0.5, 0.5, 0.5}, .status = PTC_E_INPUT, .u = {0.0, 0.0, 0.0, 0.0}, .axes = {PTC_E_INPUT, PTC_E_INPUT, PTC_E_INPUT, PTC_E_INPUT}},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {0.5, 0.5, 0.5, (double)INFINITY, 0.5, 0.5}, .status = PTC_E_INPUT, .u = {0.0, 0.0, 0.0, 0.0}, .axes = {PTC_E_INPUT, PTC_E_INPUT, PTC_E_INPUT, PTC_E_INPUT}},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {0.5, 0.5, 0.5, 0.5, (double)INFINITY, 0.5}, .status = PTC_E_INPUT, .u = {0.0, 0.0, 0.0, 0.0}, .axes = {PTC_E_INPUT, PTC_E_INPUT, PTC_E_INPUT, PTC_E_INPUT}},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {0.5, 0.5, 0.5, 0.5, 0.5, (double)INFINITY}, .status = PTC_E_INPUT, .u = {0.0, 0.0, 0.0, 0.0}, .axes = {PTC_E_INPUT, PTC_E_INPUT, PTC_E_INPUT, PTC_E_INPUT}},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {-(double)INFINITY, 0.5, 0.5, 0.5, 0.5, 0.5}, .status = PTC_E_INPUT, .u = {0.0, 0.0, 0.0, 0.0}, .axes = {PTC_E_INPUT, PTC_E_INPUT, PTC_E_INPUT, PTC_E_INPUT}},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {0.5, -(double)INFINITY, 0.5, 0.5, 0.5, 0.5}, .status = PTC_E_INPUT, .u = {0.0, 0.0, 0.0, 0.0}, .axes = {PTC_E_INPUT, PTC_E_INPUT, PTC_E_INPUT, PTC_E_INPUT}},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {0.5, 0.5, -(double)INFINITY, 0.5, 0.5, 0.5}, .status = PTC_E_INPUT, .u = {0.0, 0.0, 0.0, 0.0}, .axes = {PTC_E_INPUT, PTC_E_INPUT, PTC_E_INPUT, PTC_E_INPUT}},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {0.5, 0.5, 0.5, -(double)INFINITY, 0.5, 0.5}, .status = PTC_E_INPUT, .u = {0.0, 0.0, 0.0, 0.0}, .axes = {PTC_E_INPUT, PTC_E_INPUT, PTC_E_INPUT, PTC_E_INPUT}},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {0.5, 0.5, 0.5, 0.5, -(double)INFINITY, 0.5}, .status = PTC_E_INPUT, .u = {0.0, 0.0, 0.0, 0.0}, .axes = {PTC_E_INPUT, PTC_E_INPUT, PTC_E_INPUT, PTC_E_INPUT}},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {0.5, 0.5, 0.5, 0.5, 0.5, -(double)INFINITY}, .status = PTC_E_INPUT, .u = {0.0, 0.0, 0.0, 0.0}, .axes = {PTC_E_INPUT, PTC_E_INPUT, PTC_E_INPUT, PTC_E_INPUT}},
    {.is_armed = 0U, .start = 0U, .k = 3U, .y = {0.676875, 0.225625, -0.225625, -0.676875, -1.128125, -1.579375}, .status = PTC_OK, .u = {0.8576412588275595, -5.827101918628426, -15.301196274938551, 30.425377609063684}, .axes = {PTC_OK, PTC_OK, PTC_OK, PTC_OK}},
    {.is_armed = 0U, .start = 0U, .k = 15U, .y = {0.421875, 0.140625, -0.140625, -0.421875, -0.703125, -0.984375}, .status = PTC_OK, .u = {-0.06092844413608489, -2.8674167435698656, -7.548362675849537, 27.40519932255244}, .axes = {PTC_OK, PTC_OK, PTC_OK, PTC_OK}},
    {.is_armed = 0U, .start = 0U, .k = 26U, .y = {0.2408333333333333, 0.08027777777777777, -0.08027777777777777, -0.2408333333333333, -0.40138888888888885, -0.5619444444444444}, .status = PTC_OK, .u = {-0.09617570549106791, -1.9479123599332837, -3.210311158071493, 25.69205718356204}, .axes = {PTC_OK, PTC_OK, PTC_OK, PTC_OK}},
    {.is_armed = 0U, .start = 0U, .k = 28U, .y = {0.21333333333333332, 0.07111111111111111, -0.07111111111111111, -0.21333333333333332, -0.35555555555555557, -0.49777777777777776}, .status = PTC_OK, .u = {-0.051245155767689704, -1.893237854054361, -2.6381677573572846, 25.48297050239722}, .axes = {PTC_OK, PTC_OK, PTC_OK, PTC_OK}},
    {.is_armed = 0U, .start = 0U, .k = 29U, .y = {0.20020833333333338, 0.06673611111111112, -0.06673611111111112, -0.20020833333333338, -0.3336805555555556, -0.46715277777777786}, .status = PTC_OK, .u = {-0.024307228563825126, -1.8756743877875535, -2.3742951518817947, 25.392664173464393}, .axes = {PTC_OK, PTC_OK, PTC_OK, PTC_OK}},
    {.is_armed = 0U, .start = 0U, .k = 30U, .y = {0.1875, 0.0625, -0.0625, -0.1875, -0.3125, -0.4375}, .status = PTC_OK, .u = {0.005398801999109881, -1.864156761250347, -2.1247825626371357, 25.31277711567392}, .axes = {PTC_OK, PTC_OK, PTC_OK, PTC_OK}},
    {.is_armed = 0U, .start = 0U, .k = 31U, .y = {0.17520833333333333, 0.058402777777777776, -0.058402777777777776, -0.17520833333333333, -0.2920138888888889, -0.4088194444444444}, .status = PTC_OK, .u = {0.037730990892963036, -1.858371971238905, -1.8893164733008265, 25.244179541573146}, .axes = {PTC_OK, PTC_OK, PTC_OK, PTC_OK}},
    {.is_armed = 0U, .start = 0U, .k = 45U, .y = {0.046875, 0.015625, -0.015625, -0.046875, -0.078125, -0.109375}, .status = PTC_OK, .u = {0.7475293068139263, -2.3307717148583573, 0.08588068462663223, 26.786182299393747}, .axes = {PTC_OK, PTC_OK, PTC_OK, PTC_OK}},
    {.is_armed = 0U, .start = 0U, .k = 56U, .y = {0.003333333333333333, 0.0011111111111111111, -0.0011111111111111111, -0.003333333333333333, -0.005555555555555556, -0.0077777777777777776}, .status = PTC_OK, .u = {0.6636063784431999, -1.4796056396455972, 0.12674676314573569, 11.7570821673904}, .axes = {PTC_OK, PTC_OK, PTC_OK, PTC_OK}},
    {.is_armed = 0U, .start = 0U, .k = 58U, .y = {0.0008333333333333333, 0.0002777777777777778, -0.0002777777777777778, -0.0008333333333333333, -0.001388888888888889, -0.0019444444444444444}, .status = PTC_OK, .u = {0.1584550532777713, -0.37024414655979054, 0.050885831805517756, 2.9378351667120204}, .axes = {PTC_OK, PTC_OK, PTC_OK, PTC_OK}},
    {.is_armed = 0U, .start = 0U, .k = 59U, .y = {0.00020833333333333332, 6.944444444444444e-5, -6.944444444444444e-5, -0.00020833333333333332, -0.00034722222222222224, -0.0004861111111111111}, .status = PTC_OK, .u = {0.039625635960580975, -0.09258464884836891, 0.01318038300602711, 0.7343699044032043}, .axes = {PTC_OK, PTC_OK, PTC_OK, PTC_OK}},
    {.is_armed = 0U, .start = 0U, .k = 60U, .y = {0.0, 0.0, -0.0, -0.0, -0.0, -0.0}, .status = PTC_HOLD, .u = {-0.0, 0.0, 0.0, 0.0}, .axes = {PTC_HOLD, PTC_HOLD, PTC_HOLD, PTC_HOLD}},
    {.is_armed = 0U, .start = 0U, .k = 61U, .y = {0.0, 0.0, -0.0, -0.0, -0.0, -0.0}, .status = PTC_HOLD, .u = {-0.0, 0.0, 0.0, 0.0}, .axes = {PTC_HOLD, PTC_HOLD, PTC_HOLD, PTC_HOLD}},
    {.is_armed = 0U, .start = 0U, .k = 2147483647U, .y = {0.0, 0.0, -0.0, -0.0, -0.0, -0.0}, .status = PTC_HOLD, .u = {-0.0, 0.0, 0.0, 0.0}, .axes = {PTC_HOLD, PTC_HOLD, PTC_HOLD, PTC_HOLD}},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {0.0, 0.0, -0.0, -0.0, -0.0, -0.0}, .status = PTC_HOLD, .u = {-0.0, 0.0, 0.0, 0.0}, .axes = {PTC_HOLD, PTC_HOLD, PTC_HOLD, PTC_HOLD}},
    {.is_armed = 1U, .start = 4294967293U, .k = 4294967293U, .y = {0.75, 0.25, -0.25, -0.75, -1.25, -1.75}, .status = PTC_OK, .u = {1.3123857719828405, -7.078819464238418, -17.94441362562511, 31.455545851115968}, .axes = {PTC_OK, PTC_OK, PTC_OK, PTC_OK}},
    {.is_armed = 0U, .start = 0U, .k = 4294967294U, .y = {0.7252083333333332, 0.2417361111111111, -0.2417361111111111, -0.7252083333333332, -1.2086805555555555, -1.6921527777777776}, .status = PTC_OK, .u = {1.1480062806112632, -6.632035734495353, -17.02360911260481, 31.095854783269335}, .axes = {PTC_OK, PTC_OK, PTC_OK, PTC_OK}},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {0.7008333333333333, 0.2336111111111111, -0.2336111111111111, -0.7008333333333333, -1.1680555555555556, -1.6352777777777776}, .status = PTC_OK, .u = {0.9966736471180732, -6.2154100059370245, -16.143331516731983, 30.752857359544144}, .axes = {PTC_OK, PTC_OK, PTC_OK, PTC_OK}},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {(double)NAN, 0.5, 0.5, 0.5, 0.5, 0.5}, .status = PTC_E_INPUT, .u = {0.0, 0.0, 0.0, 0.0}, .axes = {PTC_E_INPUT, PTC_E_INPUT, PTC_E_INPUT, PTC_E_INPUT}},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {0.5, (double)NAN, 0.5, 0.5, 0.5, 0.5}, .status = PTC_E_INPUT, .u = {0.0, 0.0, 0.0, 0.0}, .axes = {PTC_E_INPUT, PTC_E_INPUT, PTC_E_INPUT, PTC_E_INPUT}},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {0.5, 0.5, (double)NAN, 0.5, 0.5, 0.5}, .status = PTC_E_INPUT, .u = {0.0, 0.0, 0.0, 0.0}, .axes = {PTC_E_INPUT, PTC_E_INPUT, PTC_E_INPUT, PTC_E_INPUT}},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {0.5, 0.5, 0.5, (double)NAN, 0.5, 0.5}, .status = PTC_E_INPUT, .u = {0.0, 0.0, 0.0, 0.0}, .axes = {PTC_E_INPUT, PTC_E_INPUT, PTC_E_INPUT, PTC_E_INPUT}},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {0.5, 0.5, 0.5, 0.5, (double)NAN, 0.5}, .status = PTC_E_INPUT, .u = {0.0, 0.0, 0.0, 0.0}, .axes = {PTC_E_INPUT, PTC_E_INPUT, PTC_E_INPUT, PTC_E_INPUT}},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {0.5, 0.5, 0.5, 0.5, 0.5, (double)NAN}, .status = PTC_E_INPUT, .u = {0.0, 0.0, 0.0, 0.0}, .axes = {PTC_E_INPUT, PTC_E_INPUT, PTC_E_INPUT, PTC_E_INPUT}},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {(double)INFINITY, 0.5, 0.5, 0.5, 0.5, 0.5}, .status = PTC_E_INPUT, .u = {0.0, 0.0, 0.0, 0.0}, .axes = {PTC_E_INPUT, PTC_E_INPUT, PTC_E_INPUT, PTC_E_INPUT}},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {0.5, (double)INFINITY, 0.5, 0.5, 0.5, 0.5}, .status = PTC_E_INPUT, .u = {0.0, 0.0, 0.0, 0.0}, .axes = {PTC_E_INPUT, PTC_E_INPUT, PTC_E_INPUT, PTC_E_INPUT}},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {0.5, 0.5, (double)INFINITY, 0.5, 0.5, 0.5}, .status = PTC_E_INPUT, .u = {0.0, 0.0, 0.0, 0.0}, .axes = {PTC_E_INPUT, PTC_E_INPUT, PTC_E_INPUT, PTC_E_INPUT}},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {0.5, 0.5, 0.5, (double)INFINITY, 0.5, 0.5}, .status = PTC_E_INPUT, .u = {0.0, 0.0, 0.0, 0.0}, .axes = {PTC_E_INPUT, PTC_E_INPUT, PTC_E_INPUT, PTC_E_INPUT}},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {0.5, 0.5, 0.5, 0.5, (double)INFINITY, 0.5}, .status = PTC_E_INPUT, .u = {0.0, 0.0, 0.0, 0.0}, .axes = {PTC_E_INPUT, PTC_E_INPUT, PTC_E_INPUT, PTC_E_INPUT}},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {0.5, 0.5, 0.5, 0.5, 0.5, (double)INFINITY}, .status = PTC_E_INPUT, .u = {0.0, 0.0, 0.0, 0.0}, .axes = {PTC_E_INPUT, PTC_E_INPUT, PTC_E_INPUT, PTC_E_INPUT}},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {-(double)INFINITY, 0.5, 0.5, 0.5, 0.5, 0.5}, .status = PTC_E_INPUT, .u = {0.0, 0.0, 0.0, 0.0}, .axes = {PTC_E_INPUT, PTC_E_INPUT, PTC_E_INPUT, PTC_E_INPUT}},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {0.5, -(double)INFINITY, 0.5, 0.5, 0.5, 0.5}, .status = PTC_E_INPUT, .u = {0.0, 0.0, 0.0, 0.0}, .axes = {PTC_E_INPUT, PTC_E_INPUT, PTC_E_INPUT, PTC_E_INPUT}},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {0.5, 0.5, -(double)INFINITY, 0.5, 0.5, 0.5}, .status = PTC_E_INPUT, .u = {0.0, 0.0, 0.0, 0.0}, .axes = {PTC_E_INPUT, PTC_E_INPUT, PTC_E_INPUT, PTC_E_INPUT}},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {0.5, 0.5, 0.5, -(double)INFINITY, 0.5, 0.5}, .status = PTC_E_INPUT, .u = {0.0, 0.0, 0.0, 0.0}, .axes = {PTC_E_INPUT, PTC_E_INPUT, PTC_E_INPUT, PTC_E_INPUT}},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {0.5, 0.5, 0.5, 0.5, -(double)INFINITY, 0.5}, .status = PTC_E_INPUT, .u = {0.0, 0.0, 0.0, 0.0}, .axes = {PTC_E_INPUT, PTC_E_INPUT, PTC_E_INPUT, PTC_E_INPUT}},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {0.5, 0.5, 0.5, 0.5, 0.5, -(double)INFINITY}, .status = PTC_E_INPUT, .u = {0.0, 0.0, 0.0, 0.0}, .axes = {PTC_E_INPUT, PTC_E_INPUT, PTC_E_INPUT, PTC_E_INPUT}},
    {.is_armed = 0U, .start = 0U, .k = 0U, .y = {0.676875, 0.225625, -0.225625, -0.676875, -1.128125, -1.579375}, .status = PTC_OK, .u = {0.8576412588275595, -5.827101918628426, -15.301196274938551, 30.425377609063684}, .axes = {PTC_OK, PTC_OK, PTC_OK, PTC_OK}},
    {.is_armed = 0U, .start = 0U, .k = 12U, .y = {0.421875, 0.140625, -0.140625, -0.421875, -0.703125, -0.984375}, .status = PTC_OK, .u = {-0.06092844413608489, -2.8674167435698656, -7.548362675849537, 27.40519932255244}, .axes = {PTC_OK, PTC_OK, PTC_OK, PTC_OK}},
    {.is_armed = 0U, .start = 0U, .k = 23U, .y = {0.2408333333333333, 0.08027777777777777, -0.08027777777777777, -0.2408333333333333, -0.40138888888888885, -0.5619444444444444}, .status = PTC_OK, .u = {-0.09617570549106791, -1.9479123599332837, -3.210311158071493, 25.69205718356204}, .axes = {PTC_OK, PTC_OK, PTC_OK, PTC_OK}},
    {.is_armed = 0U, .start = 0U, .k = 25U, .y = {0.21333333333333332, 0.07111111111111111, -0.07111111111111111, -0.21333333333333332, -0.35555555555555557, -0.49777777777777776}, .status = PTC_OK, .u = {-0.051245155767689704, -1.893237854054361, -2.6381677573572846, 25.48297050239722}, .axes = {PTC_OK, PTC_OK, PTC_OK, PTC_OK}},
    {.is_armed = 0U, .start = 0U, .k = 26U, .y = {0.20020833333333338, 0.06673611111111112, -0.06673611111111112, -0.20020833333333338, -0.3336805555555556, -0.46715277777777786}, .status = PTC_OK, .u = {-0.024307228563825126, -1.8756743877875535, -2.3742951518817947, 25.392664173464393}, .axes = {PTC_OK, PTC_OK, PTC_OK, PTC_OK}},
    {.is_armed = 0U, .start = 0U, .k = 27U, .y = {0.1875, 0.0625, -0.0625, -0.1875, -0.3125, -0.4375}, .status = PTC_OK, .u = {0.005398801999109881, -1.864156761250347, -2.1247825626371357, 25.31277711567392}, .axes = {PTC_OK, PTC_OK, PTC_OK, PTC_OK}},
    {.is_armed = 0U, .start = 0U, .k = 28U, .y = {0.17520833333333333, 0.058402777777777776, -0.058402777777777776, -0.17520833333333333, -0.2920138888888889, -0.4088194444444444}, .status = PTC_OK, .u = {0.037730990892963036, -1.858371971238905, -1.8893164733008265, 25.244179541573146}, .axes = {PTC_OK, PTC_OK, PTC_OK, PTC_OK}},
    {.is_armed = 0U, .start = 0U, .k = 42U, .y = {0.046875, 0.015625, -0.015625, -0.046875, -0.078125, -0.109375}, .status = PTC_OK, .u = {0.7475293068139263, -2.3307717148583573, 0.08588068462663223, 26.786182299393747}, .axes = {PTC_OK, PTC_OK, PTC_OK, PTC_OK}},
    {.is_armed = 0U, .start = 0U, .k = 53U, .y = {0.003333333333333333, 0.0011111111111111111, -0.0011111111111111111, -0.003333333333333333, -0.005555555555555556, -0.0077777777777777776}, .status = PTC_OK, .u = {0.6636063784431999, -1.4796056396455972, 0.12674676314573569, 11.7570821673904}, .axes = {PTC_OK, PTC_OK, PTC_OK, PTC_OK}},
    {.is_armed = 0U, .start = 0U, .k = 55U, .y = {0.0008333333333333333, 0.0002777777777777778, -0.0002777777777777778, -0.0008333333333333333, -0.001388888888888889, -0.0019444444444444444}, .status = PTC_OK, .u = {0.1584550532777713, -0.37024414655979054, 0.050885831805517756, 2.9378351667120204}, .axes = {PTC_OK, PTC_OK, PTC_OK, PTC_OK}},
    {.is_armed = 0U, .start = 0U, .k = 56U, .y = {0.00020833333333333332, 6.944444444444444e-5, -6.944444444444444e-5, -0.00020833333333333332, -0.00034722222222222224, -0.0004861111111111111}, .status = PTC_OK, .u = {0.039625635960580975, -0.09258464884836891, 0.01318038300602711, 0.7343699044032043}, .axes = {PTC_OK, PTC_OK, PTC_OK, PTC_OK}},
    {.is_armed = 0U, .start = 0U, .k = 57U, .y = {0.0, 0.0, -0.0, -0.0, -0.0, -0.0}, .status = PTC_HOLD, .u = {-0.0, 0.0, 0.0, 0.0}, .axes = {PTC_HOLD, PTC_HOLD, PTC_HOLD, PTC_HOLD}},
    {.is_armed = 0U, .start = 0U, .k = 58U, .y = {0.0, 0.0, -0.0, -0.0, -0.0, -0.0}, .status = PTC_HOLD, .u = {-0.0, 0.0, 0.0, 0.0}, .axes = {PTC_HOLD, PTC_HOLD, PTC_HOLD, PTC_HOLD}},
    {.is_armed = 0U, .start = 0U, .k = 2147483644U, .y = {0.0, 0.0, -0.0, -0.0, -0.0, -0.0}, .status = PTC_HOLD, .u = {-0.0, 0.0, 0.0, 0.0}, .axes = {PTC_HOLD, PTC_HOLD, PTC_HOLD, PTC_HOLD}},
    {.is_armed = 0U, .start = 0U, .k = 4294967292U, .y = {0.0, 0.0, -0.0, -0.0, -0.0, -0.0}, .status = PTC_HOLD, .u = {-0.0, 0.0, 0.0, 0.0}, .axes = {PTC_HOLD, PTC_HOLD, PTC_HOLD, PTC_HOLD}},
    {.is_armed = 0U, .start = 0U, .k = 51U, .y = {-1.7269588609032224e302, 9.098934390782067e301, -1.7240562510776733e302, 8.115640100197089e301, 1.5939539123118515e302, 1.442488906375499e302}, .status = PTC_E_RANGE, .u = {0.0, 0.0, 0.0, 0.0}, .axes = {PTC_E_RANGE, PTC_E_RANGE, PTC_E_RANGE, PTC_E_RANGE}},
    {.is_armed = 1U, .start = 4294967290U, .k = 4294967292U, .y = {-7.425309881539387e153, -4.382754834759846e153, -7.305299673621535e153, -1.1341694314726557e154, -1.276710945202874e154, -9.753410010864432e153}, .status = PTC_E_RANGE, .u = {0.0, 0.0, 0.0, 0.0}, .axes = {PTC_E_RANGE, PTC_E_RANGE, PTC_OK, PTC_OK}},
    {.is_armed = 1U, .start = 0U, .k = 30U, .y = {2.0, 2.0, -1.0, -0.0, 0.5, -490.4453263614289}, .status = PTC_E_RANGE, .u = {0.0, 0.0, 0.0, 0.0}, .axes = {PTC_E_RANGE, PTC_E_RANGE, PTC_E_RANGE, PTC_E_RANGE}},
    {.is_armed = 1U, .start = 4294967290U, .k = 31U, .y = {2.0, -0.0, -9.319145173521692e307, 1.5082777522019303e308, -0.5, 2.0}, .status = PTC_E_RANGE, .u = {0.0, 0.0, 0.0, 0.0}, .axes = {PTC_E_RANGE, PTC_E_RANGE, PTC_E_RANGE, PTC_E_RANGE}},
    {.is_armed = 0U, .start = 0U, .k = 30U, .y = {2.0, 351.82016824374074, -0.0, -9.405370013412233e153, -1.0, 1.1308525303036392e302}, .status = PTC_E_RANGE, .u = {0.0, 0.0, 0.0, 0.0}, .axes = {PTC_E_RANGE, PTC_OK, PTC_OK, PTC_OK}},
};

/* 1 where a number is not the one that must come. */
static uint32_t stage27_selftest_differs(double value, double wanted)
{
    uint32_t failures = 1U;

    if (fabs(value - wanted) <= 0.0) {
        failures = 0U;
    }
    return failures;
}

/* The failures of one call. */
static uint32_t stage27_selftest_check(stage27 *self, const stage27_selftest_call *call)
{
    uint32_t failures = 0U;
    double u[4] = {12345.0, 12345.0, 12345.0, 12345.0};
    ptc_status axes[4] = {PTC_E_PARAM, PTC_E_PARAM, PTC_E_PARAM, PTC_E_PARAM};

    if (call->is_armed != 0U) {
        if (stage27_arm(self, call->start) != PTC_OK) {
            failures++;
        }
    }
    if (stage27_step(self, call->k, call->y, u, axes) != call->status) {
        failures++;
    }
    for (uint32_t i = 0U; i < 4U; i++) {
        failures += stage27_selftest_differs(u[i], call->u[i]);
        if (axes[i] != call->axes[i]) {
            failures++;
        }
    }
    return failures;
}

/* The calls of a session, of which init has been called. */
static uint32_t stage27_selftest_calls_of(stage27 *self, const stage27_selftest_session *session)
{
    uint32_t failures = 0U;

    for (uint32_t j = 0U; j < session->count; j++) {
        failures += stage27_selftest_check(self, &stage27_selftest_calls[session->first + j]);
    }
    return failures;
}

/* Every session with its calls. */
static uint32_t stage27_selftest_run(void)
{
    uint32_t failures = 0U;

    for (uint32_t i = 0U; i < 4U; i++) {
        const stage27_selftest_session *session = &stage27_selftest_sessions[i];
        stage27 self;

        if (stage27_init(&self, &session->params) == PTC_OK) {
            failures += stage27_selftest_calls_of(&self, session);
        } else {
            failures++;
        }
    }
    return failures;
}

/* What init must refuse without a change. */
static uint32_t stage27_selftest_refuse(void)
{
    static const stage27_params refused[14] = {
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
    const stage27_selftest_session *session = &stage27_selftest_sessions[0];
    uint32_t failures = 0U;
    stage27 self;

    if (stage27_init(&self, &session->params) != PTC_OK) {
        failures++;
    }
    for (uint32_t i = 0U; i < 14U; i++) {
        if (stage27_init(&self, &refused[i]) != PTC_E_PARAM) {
            failures++;
        }
    }
    if (stage27_init(&self, NULL) != PTC_E_PARAM) {
        failures++;
    }
    if (stage27_init(NULL, &session->params) != PTC_E_PARAM) {
        failures++;
    }
    failures += stage27_selftest_calls_of(&self, session);
    return failures;
}

/* Calls that lack a pointer: each is refused, and changes nothing. */
static uint32_t stage27_selftest_pointers(void)
{
    const stage27_selftest_session *session = &stage27_selftest_sessions[0];
    const stage27_selftest_call *call = &stage27_selftest_calls[0];
    uint32_t failures = 0U;
    double u[4] = {12345.0, 12345.0, 12345.0, 12345.0};
    ptc_status axes[4] = {PTC_E_PARAM, PTC_E_PARAM, PTC_E_PARAM, PTC_E_PARAM};
    stage27 self;

    if (stage27_init(&self, &session->params) != PTC_OK) {
        failures++;
    }
    if (stage27_arm(NULL, call->start) != PTC_E_INPUT) {
        failures++;
    }
    if (stage27_step(NULL, call->k, call->y, u, axes) != PTC_E_INPUT) {
        failures++;
    }
    for (uint32_t i = 0U; i < 4U; i++) {
        failures += stage27_selftest_differs(u[i], 0.0);
        u[i] = 12345.0;
    }
    if (stage27_step(&self, call->k, call->y, u, NULL) != PTC_E_INPUT) {
        failures++;
    }
    for (uint32_t i = 0U; i < 4U; i++) {
        failures += stage27_selftest_differs(u[i], 0.0);
        u[i] = 12345.0;
    }
    if (stage27_step(&self, call->k, NULL, u, axes) != PTC_E_INPUT) {
        failures++;
    }
    for (uint32_t i = 0U; i < 4U; i++) {
        failures += stage27_selftest_differs(u[i], 0.0);
    }
    if (stage27_step(&self, call->k, call->y, NULL, axes) != PTC_E_INPUT) {
        failures++;
    }
    failures += stage27_selftest_calls_of(&self, session);
    return failures;
}

uint32_t stage27_selftest(void)
{
    uint32_t failures = stage27_selftest_run();

    failures += stage27_selftest_refuse();
    failures += stage27_selftest_pointers();
    return failures;
}
