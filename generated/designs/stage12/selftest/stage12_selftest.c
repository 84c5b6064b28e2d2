/* Self-test of the prescribed-time controller stage12: see stage12_selftest.h. DO NOT EDIT. */
#include "stage12_selftest.h"
#include "stage12.h"

#include <math.h>
#include <stddef.h>

/* A call, and what it must give. */
typedef struct stage12_selftest_call {
    uint32_t is_armed; /* arm is called before it */
    uint32_t start;
    uint32_t k;
    double y[2]; /* what is measured */
    ptc_status status;
    double u;
    double xhat[3]; /* the estimates behind it */
    double d;
} stage12_selftest_call;

/* A set of parameters that init takes, and the calls with it, one after the other. */
typedef struct stage12_selftest_session {
    stage12_params params;
    uint32_t first; /* of its calls */
    uint32_t count;
} stage12_selftest_session;

static const stage12_selftest_session stage12_selftest_sessions[6] = {
    {.params = {.samples = 60U, .u_max = (double)INFINITY, .k = {625.0, 500.0, 150.0, 20.0}, .deadbeat = 0.0}, .first = 0U, .count = 48U},
    {.params = {.samples = 60U, .u_max = (double)INFINITY, .k = {625.0, 500.0, 150.0, 0.0}, .deadbeat = 0.0}, .first = 48U, .count = 1U},
    {.params = {.samples = 60U, .u_max = (double)INFINITY, .k = {625.0, 500.0, 150.0, 20.0}, .deadbeat = 1.7976931348623157e308}, .first = 49U, .count = 1U},
    {.params = {.samples = 60U, .u_max = (double)INFINITY, .k = {625.0, 500.0, 150.0, 20.0}, .deadbeat = 0.0}, .first = 50U, .count = 3U},
    {.params = {.samples = 60U, .u_max = (double)INFINITY, .k = {625.0, 500.0, 150.0, 20.0}, .deadbeat = 0.0}, .first = 53U, .count = 1U},
    {.params = {.samples = 60U, .u_max = 1.0, .k = {625.0, 500.0, 150.0, 20.0}, .deadbeat = 0.0}, .first = 54U, .count = 3U},
};

static const stage12_selftest_call stage12_selftest_calls[57] = {
    {.is_armed = 0U, .start = 0U, .k = 0U, .y = {0.75, 0.25}, .status = PTC_OK, .u = -0.14699615752289702, .xhat = {0.75, 0.0, 0.25}, .d = 0.0},
    {.is_armed = 0U, .start = 0U, .k = 1U, .y = {0.7252083333333332, 0.2417361111111111}, .status = PTC_OK, .u = -0.29886562624342694, .xhat = {0.7501547067911507, 0.28086551021682454, 0.13530225268777896}, .d = 0.0},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {0.7008333333333333, 0.2336111111111111}, .status = PTC_OK, .u = -0.448521456841301, .xhat = {0.743786601756977, 0.1731735070678129, 0.009090463752227294}, .d = -0.0005961975456877776},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {(double)NAN, 0.5}, .status = PTC_E_INPUT, .u = 0.0, .xhat = {0.743786601756977, 0.1731735070678129, 0.009090463752227294}, .d = -0.0005961975456877776},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {0.5, (double)NAN}, .status = PTC_E_INPUT, .u = 0.0, .xhat = {0.743786601756977, 0.1731735070678129, 0.009090463752227294}, .d = -0.0005961975456877776},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {(double)INFINITY, 0.5}, .status = PTC_E_INPUT, .u = 0.0, .xhat = {0.743786601756977, 0.1731735070678129, 0.009090463752227294}, .d = -0.0005961975456877776},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {0.5, (double)INFINITY}, .status = PTC_E_INPUT, .u = 0.0, .xhat = {0.743786601756977, 0.1731735070678129, 0.009090463752227294}, .d = -0.0005961975456877776},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {-(double)INFINITY, 0.5}, .status = PTC_E_INPUT, .u = 0.0, .xhat = {0.743786601756977, 0.1731735070678129, 0.009090463752227294}, .d = -0.0005961975456877776},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {0.5, -(double)INFINITY}, .status = PTC_E_INPUT, .u = 0.0, .xhat = {0.743786601756977, 0.1731735070678129, 0.009090463752227294}, .d = -0.0005961975456877776},
    {.is_armed = 0U, .start = 0U, .k = 3U, .y = {0.676875, 0.225625}, .status = PTC_OK, .u = -0.590076749369296, .xhat = {0.7320052628559073, -0.2596488636946541, -0.11831177851816872}, .d = 0.0026579698800983202},
    {.is_armed = 0U, .start = 0U, .k = 15U, .y = {0.421875, 0.140625}, .status = PTC_OK, .u = -0.818141124472004, .xhat = {0.7158136958475353, -0.9570439513270891, -0.23656737182004678}, .d = 0.013497348311637583},
    {.is_armed = 0U, .start = 0U, .k = 26U, .y = {0.2408333333333333, 0.08027777777777777}, .status = PTC_OK, .u = -1.0098837254407833, .xhat = {0.5585746073496016, -17.46102962792689, -0.2097152205011136}, .d = -0.34700235221325937},
    {.is_armed = 0U, .start = 0U, .k = 28U, .y = {0.21333333333333332, 0.07111111111111111}, .status = PTC_OK, .u = 6.751117079622722, .xhat = {-0.09398694988177571, -334.67160541532525, 0.08867668630002407}, .d = -9.107355088426257},
    {.is_armed = 0U, .start = 0U, .k = 29U, .y = {0.20020833333333338, 0.06673611111111112}, .status = PTC_OK, .u = 6.931579225328901, .xhat = {0.18593332224055792, -27.38174748793248, -0.007099972377781039}, .d = 0.06528319353764306},
    {.is_armed = 0U, .start = 0U, .k = 30U, .y = {0.1875, 0.0625}, .status = PTC_OK, .u = 5.884285336693606, .xhat = {0.18802952396900374, -10.565441288433885, 2.9703315194091844}, .d = 0.689994745413031},
    {.is_armed = 0U, .start = 0U, .k = 31U, .y = {0.17520833333333333, 0.058402777777777776}, .status = PTC_OK, .u = 4.208706108157332, .xhat = {0.17587906505160142, -8.505470683396423, 5.336777810580468}, .d = 0.6066083994739744},
    {.is_armed = 0U, .start = 0U, .k = 45U, .y = {0.046875, 0.015625}, .status = PTC_OK, .u = -312.29429801963, .xhat = {0.1636806765194186, -7.20248923710696, 6.786773108484411}, .d = 0.45531096904962676},
    {.is_armed = 0U, .start = 0U, .k = 56U, .y = {0.003333333333333333, 0.0011111111111111111}, .status = PTC_OK, .u = 546.2611744891447, .xhat = {0.1313520231115575, -7.659208420380996, 7.2597686363298415}, .d = 0.23418723567926203},
    {.is_armed = 0U, .start = 0U, .k = 58U, .y = {0.0008333333333333333, 0.0002777777777777778}, .status = PTC_OK, .u = -192.41649292532998, .xhat = {0.061971304419069596, -106.29120077850388, -110.99434884042613}, .d = -0.0035106772604684977},
    {.is_armed = 0U, .start = 0U, .k = 59U, .y = {0.00020833333333333332, 6.944444444444444e-5}, .status = PTC_OK, .u = -906.3338384545658, .xhat = {0.09599849151502984, 81.15144565487557, 116.90580917441338}, .d = 3.160452898173803},
    {.is_armed = 0U, .start = 0U, .k = 60U, .y = {0.0, 0.0}, .status = PTC_HOLD, .u = 2057.3085317142436, .xhat = {0.04367542422735041, 2.2580372413099994, 21.8403766198915}, .d = -0.20936456860849173},
    {.is_armed = 0U, .start = 0U, .k = 61U, .y = {0.0, 0.0}, .status = PTC_HOLD, .u = -1428.129782847827, .xhat = {-0.07762185355045383, -282.1099026756879, -322.11307122861115}, .d = -0.8449269711821082},
    {.is_armed = 0U, .start = 0U, .k = 2147483647U, .y = {0.0, 0.0}, .status = PTC_HOLD, .u = -2274.3684536316896, .xhat = {0.14222288823823062, 409.35646334820143, 515.4762939797964}, .d = 8.396561519801127},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {0.0, 0.0}, .status = PTC_HOLD, .u = 7318.200530513017, .xhat = {-0.052249437013612676, -117.94109943993755, -123.50153464221205}, .d = -6.396755221103318},
    {.is_armed = 1U, .start = 4294967293U, .k = 4294967293U, .y = {0.75, 0.25}, .status = PTC_OK, .u = 9245.9562178357, .xhat = {-0.3058121943532424, -802.2199647299019, -951.9572145514927}, .d = -2.848227260150427},
    {.is_armed = 0U, .start = 0U, .k = 4294967294U, .y = {0.7252083333333332, 0.2417361111111111}, .status = PTC_OK, .u = 10615.526676695135, .xhat = {0.7511180446247285, 1781.2959036570821, 2169.2530289880365}, .d = 84.95923199847292},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {0.7008333333333333, 0.2336111111111111}, .status = PTC_OK, .u = 11400.608406920346, .xhat = {1.7428010611062918, 3950.06166404989, 4767.01164919506}, .d = -128.28740636238683},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {(double)NAN, 0.5}, .status = PTC_E_INPUT, .u = 0.0, .xhat = {1.7428010611062918, 3950.06166404989, 4767.01164919506}, .d = -128.28740636238683},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {0.5, (double)NAN}, .status = PTC_E_INPUT, .u = 0.0, .xhat = {1.7428010611062918, 3950.06166404989, 4767.01164919506}, .d = -128.28740636238683},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {(double)INFINITY, 0.5}, .status = PTC_E_INPUT, .u = 0.0, .xhat = {1.7428010611062918, 3950.06166404989, 4767.01164919506}, .d = -128.28740636238683},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {0.5, (double)INFINITY}, .status = PTC_E_INPUT, .u = 0.0, .xhat = {1.7428010611062918, 3950.06166404989, 4767.01164919506}, .d = -128.28740636238683},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {-(double)INFINITY, 0.5}, .status = PTC_E_INPUT, .u = 0.0, .xhat = {1.7428010611062918, 3950.06166404989, 4767.01164919506}, .d = -128.28740636238683},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {0.5, -(double)INFINITY}, .status = PTC_E_INPUT, .u = 0.0, .xhat = {1.7428010611062918, 3950.06166404989, 4767.01164919506}, .d = -128.28740636238683},
    {.is_armed = 0U, .start = 0U, .k = 0U, .y = {0.676875, 0.225625}, .status = PTC_OK, .u = 11636.08410421428, .xhat = {2.5920433492839914, 5545.590030546338, 6652.279071782359}, .d = -632.1174320894895},
    {.is_armed = 0U, .start = 0U, .k = 12U, .y = {0.421875, 0.140625}, .status = PTC_OK, .u = 10957.626848684666, .xhat = {3.240261566970205, 6484.421130500079, 7728.90911564955}, .d = -1389.5345763112177},
    {.is_armed = 0U, .start = 0U, .k = 23U, .y = {0.2408333333333333, 0.08027777777777777}, .status = PTC_OK, .u = 9790.094740185563, .xhat = {2.945872079539903, 4704.47512687021, 5382.9582746051965}, .d = -4332.313396416387},
    {.is_armed = 0U, .start = 0U, .k = 25U, .y = {0.21333333333333332, 0.07111111111111111}, .status = PTC_OK, .u = 10618.06060617965, .xhat = {-1.4896762991984431, -3290.434749532157, -2903.962330452321}, .d = -18736.868370969605},
    {.is_armed = 0U, .start = 0U, .k = 26U, .y = {0.20020833333333338, 0.06673611111111112}, .status = PTC_OK, .u = 10731.436532515556, .xhat = {0.059669928141120154, -388.5727118655918, -437.28169358007017}, .d = -10958.3797066156},
    {.is_armed = 0U, .start = 0U, .k = 27U, .y = {0.1875, 0.0625}, .status = PTC_OK, .u = 10611.759549273505, .xhat = {0.2767455944151427, 243.21708427080512, 310.21126961944583}, .d = -9790.414629165589},
    {.is_armed = 0U, .start = 0U, .k = 28U, .y = {0.17520833333333333, 0.058402777777777776}, .status = PTC_OK, .u = 10413.950105214517, .xhat = {0.35025099652814606, 481.4990980742864, 598.2400857630764}, .d = -9799.316242394174},
    {.is_armed = 0U, .start = 0U, .k = 42U, .y = {0.046875, 0.015625}, .status = PTC_OK, .u = -928.1310388182665, .xhat = {0.39541155469215916, 630.671539070614, 778.1217510640395}, .d = -9816.48539912445},
    {.is_armed = 0U, .start = 0U, .k = 53U, .y = {0.003333333333333333, 0.0011111111111111111}, .status = PTC_OK, .u = 27193.592511440882, .xhat = {0.38797729635170786, 681.5437822000422, 840.0193445122245}, .d = -9838.846971420455},
    {.is_armed = 0U, .start = 0U, .k = 55U, .y = {0.0008333333333333333, 0.0002777777777777778}, .status = PTC_OK, .u = 4763.3281808443335, .xhat = {-0.8551677175481937, -2794.6471964423317, -3367.978317788806}, .d = -9862.989755433393},
    {.is_armed = 0U, .start = 0U, .k = 56U, .y = {0.00020833333333333332, 6.944444444444444e-5}, .status = PTC_OK, .u = -21773.11258557609, .xhat = {1.1544528203419402, 3143.3386752787046, 3825.3973340616503}, .d = -9766.351422483518},
    {.is_armed = 0U, .start = 0U, .k = 57U, .y = {0.0, 0.0}, .status = PTC_HOLD, .u = 76605.20266163014, .xhat = {0.3978224961932997, 940.3924775306771, 1154.8880907642592}, .d = -9876.157033241187},
    {.is_armed = 0U, .start = 0U, .k = 58U, .y = {0.0, 0.0}, .status = PTC_HOLD, .u = -32535.10509617524, .xhat = {-3.107564102480912, -9050.34459446152, -10940.971657824835}, .d = -9909.318875582241},
    {.is_armed = 0U, .start = 0U, .k = 2147483644U, .y = {0.0, 0.0}, .status = PTC_HOLD, .u = -72070.9741087309, .xhat = {4.629571125970418, 13458.559858594124, 16321.18949496453}, .d = -9595.310363639966},
    {.is_armed = 0U, .start = 0U, .k = 4294967292U, .y = {0.0, 0.0}, .status = PTC_HOLD, .u = 250921.0564704017, .xhat = {-0.7487943983655323, -2369.693028865784, -2858.965896126072}, .d = -10063.73098758789},
    {.is_armed = 0U, .start = 0U, .k = 0U, .y = {0.0, 0.0}, .status = PTC_OK, .u = 0.0, .xhat = {0.0, 0.0, 0.0}, .d = 0.0},
    {.is_armed = 0U, .start = 0U, .k = 0U, .y = {0.0, 0.0}, .status = PTC_OK, .u = -0.0, .xhat = {0.0, 0.0, 0.0}, .d = 0.0},
    {.is_armed = 0U, .start = 0U, .k = 22U, .y = {-0.25521958213887375, -0.3118448293798519}, .status = PTC_OK, .u = 0.23255630658235749, .xhat = {-0.25521958213887375, 0.0, -0.3118448293798519}, .d = 0.0},
    {.is_armed = 0U, .start = 0U, .k = 53U, .y = {7.69667584940382e153, -9.650715777189601e153}, .status = PTC_OK, .u = 456.18669356508894, .xhat = {-0.25541256019043496, -0.3503458284490028, -0.16877323161652016}, .d = 0.0},
    {.is_armed = 1U, .start = 0U, .k = 51U, .y = {9.94450903404861e153, 5.18359445648785e153}, .status = PTC_OK, .u = -1.770513891195623e157, .xhat = {9.94450903404861e153, 0.0, 5.18359445648785e153}, .d = 0.0},
    {.is_armed = 1U, .start = 0U, .k = 28U, .y = {-1.7824469226013917e308, -1.1909659812386371e308}, .status = PTC_E_RANGE, .u = 0.0, .xhat = {0.0, 0.0, 0.0}, .d = 0.0},
    {.is_armed = 0U, .start = 0U, .k = 31U, .y = {-0.6021979331681786, 0.5081729849404194}, .status = PTC_SATURATED, .u = 1.0, .xhat = {-0.6021979331681786, 0.0, 0.5081729849404194}, .d = 0.0},
    {.is_armed = 1U, .start = 0U, .k = 48U, .y = {8.66572763576271e301, 5.242845272058633e301}, .status = PTC_SATURATED, .u = 1.0, .xhat = {-0.6018834619207801, 0.5709130587747904, 0.27502779847004605}, .d = 0.0},
    {.is_armed = 1U, .start = 4294967290U, .k = 4U, .y = {-5.87032678324089e301, 4.716259431692308e301}, .status = PTC_SATURATED, .u = -1.0, .xhat = {-5.87032678324089e301, 0.0, 4.716259431692308e301}, .d = 0.0},
};

/* 1 where a number is not the one that must come. */
static uint32_t stage12_selftest_differs(double value, double wanted)
{
    uint32_t failures = 1U;

    if (fabs(value - wanted) <= 0.0) {
        failures = 0U;
    }
    return failures;
}

/* The failures of one call. */
static uint32_t stage12_selftest_check(stage12 *self, const stage12_selftest_call *call)
{
    uint32_t failures = 0U;
    double u = 12345.0;
    double xhat[3] = {12345.0, 12345.0, 12345.0};
    double d = 12345.0;

    if (call->is_armed != 0U) {
        if (stage12_arm(self, call->start) != PTC_OK) {
            failures++;
        }
    }
    if (stage12_step(self, call->k, call->y, &u) != call->status) {
        failures++;
    }
    failures += stage12_selftest_differs(u, call->u);
    if (stage12_estimate(self, xhat) != PTC_OK) {
        failures++;
    }
    for (uint32_t i = 0U; i < 3U; i++) {
        failures += stage12_selftest_differs(xhat[i], call->xhat[i]);
    }
    if (stage12_disturbance(self, &d) != PTC_OK) {
        failures++;
    }
    failures += stage12_selftest_differs(d, call->d);
    return failures;
}

/* The calls of a session, of which init has been called. */
static uint32_t stage12_selftest_calls_of(stage12 *self, const stage12_selftest_session *session)
{
    uint32_t failures = 0U;

    for (uint32_t j = 0U; j < session->count; j++) {
        failures += stage12_selftest_check(self, &stage12_selftest_calls[session->first + j]);
    }
    return failures;
}

/* Every session with its calls. */
static uint32_t stage12_selftest_run(void)
{
    uint32_t failures = 0U;

    for (uint32_t i = 0U; i < 6U; i++) {
        const stage12_selftest_session *session = &stage12_selftest_sessions[i];
        stage12 self;

        if (stage12_init(&self, &session->params) == PTC_OK) {
            failures += stage12_selftest_calls_of(&self, session);
        } else {
            failures++;
        }
    }
    return failures;
}

/* What init must refuse without a change. */
static uint32_t stage12_selftest_refuse(void)
{
    static const stage12_params refused[34] = {
        {.samples = 0U, .u_max = (double)INFINITY, .k = {625.0, 500.0, 150.0, 20.0}, .deadbeat = 0.0},
        {.samples = 7U, .u_max = (double)INFINITY, .k = {625.0, 500.0, 150.0, 20.0}, .deadbeat = 0.0},
        {.samples = 60U, .u_max = (double)NAN, .k = {625.0, 500.0, 150.0, 20.0}, .deadbeat = 0.0},
        {.samples = 60U, .u_max = -(double)INFINITY, .k = {625.0, 500.0, 150.0, 20.0}, .deadbeat = 0.0},
        {.samples = 60U, .u_max = 0.0, .k = {625.0, 500.0, 150.0, 20.0}, .deadbeat = 0.0},
        {.samples = 60U, .u_max = -1.0, .k = {625.0, 500.0, 150.0, 20.0}, .deadbeat = 0.0},
        {.samples = 60U, .u_max = -1.7976931348623157e308, .k = {625.0, 500.0, 150.0, 20.0}, .deadbeat = 0.0},
        {.samples = 60U, .u_max = (double)INFINITY, .k = {(double)NAN, 500.0, 150.0, 20.0}, .deadbeat = 0.0},
        {.samples = 60U, .u_max = (double)INFINITY, .k = {(double)INFINITY, 500.0, 150.0, 20.0}, .deadbeat = 0.0},
        {.samples = 60U, .u_max = (double)INFINITY, .k = {-(double)INFINITY, 500.0, 150.0, 20.0}, .deadbeat = 0.0},
        {.samples = 60U, .u_max = (double)INFINITY, .k = {1.7976931348623157e308, 500.0, 150.0, 20.0}, .deadbeat = 0.0},
        {.samples = 60U, .u_max = (double)INFINITY, .k = {-1.7976931348623157e308, 500.0, 150.0, 20.0}, .deadbeat = 0.0},
        {.samples = 60U, .u_max = (double)INFINITY, .k = {625.0, (double)NAN, 150.0, 20.0}, .deadbeat = 0.0},
        {.samples = 60U, .u_max = (double)INFINITY, .k = {625.0, (double)INFINITY, 150.0, 20.0}, .deadbeat = 0.0},
        {.samples = 60U, .u_max = (double)INFINITY, .k = {625.0, -(double)INFINITY, 150.0, 20.0}, .deadbeat = 0.0},
        {.samples = 60U, .u_max = (double)INFINITY, .k = {625.0, 1.7976931348623157e308, 150.0, 20.0}, .deadbeat = 0.0},
        {.samples = 60U, .u_max = (double)INFINITY, .k = {625.0, -1.7976931348623157e308, 150.0, 20.0}, .deadbeat = 0.0},
        {.samples = 60U, .u_max = (double)INFINITY, .k = {625.0, 500.0, (double)NAN, 20.0}, .deadbeat = 0.0},
        {.samples = 60U, .u_max = (double)INFINITY, .k = {625.0, 500.0, (double)INFINITY, 20.0}, .deadbeat = 0.0},
        {.samples = 60U, .u_max = (double)INFINITY, .k = {625.0, 500.0, -(double)INFINITY, 20.0}, .deadbeat = 0.0},
        {.samples = 60U, .u_max = (double)INFINITY, .k = {625.0, 500.0, 1.7976931348623157e308, 20.0}, .deadbeat = 0.0},
        {.samples = 60U, .u_max = (double)INFINITY, .k = {625.0, 500.0, -1.7976931348623157e308, 20.0}, .deadbeat = 0.0},
        {.samples = 60U, .u_max = (double)INFINITY, .k = {625.0, 500.0, 150.0, (double)NAN}, .deadbeat = 0.0},
        {.samples = 60U, .u_max = (double)INFINITY, .k = {625.0, 500.0, 150.0, (double)INFINITY}, .deadbeat = 0.0},
        {.samples = 60U, .u_max = (double)INFINITY, .k = {625.0, 500.0, 150.0, -(double)INFINITY}, .deadbeat = 0.0},
        {.samples = 60U, .u_max = (double)INFINITY, .k = {625.0, 500.0, 150.0, 1.7976931348623157e308}, .deadbeat = 0.0},
        {.samples = 60U, .u_max = (double)INFINITY, .k = {625.0, 500.0, 150.0, -1.7976931348623157e308}, .deadbeat = 0.0},
        {.samples = 60U, .u_max = (double)INFINITY, .k = {625.0, 500.0, 150.0, 20.0}, .deadbeat = (double)NAN},
        {.samples = 60U, .u_max = (double)INFINITY, .k = {625.0, 500.0, 150.0, 20.0}, .deadbeat = (double)INFINITY},
        {.samples = 60U, .u_max = (double)INFINITY, .k = {625.0, 500.0, 150.0, 20.0}, .deadbeat = -(double)INFINITY},
        {.samples = 60U, .u_max = (double)INFINITY, .k = {625.0, 500.0, 150.0, 20.0}, .deadbeat = -1.0},
        {.samples = 60U, .u_max = (double)INFINITY, .k = {625.0, 500.0, 150.0, 20.0}, .deadbeat = -1.7976931348623157e308},
        {.samples = 60U, .u_max = (double)INFINITY, .k = {625.0, 500.0, -1.7976931348623157e308, -1.7976931348623157e308}, .deadbeat = 9.935072591923028e65},
        {.samples = 60U, .u_max = 1.076937913942005e-59, .k = {-2.5011955664535713e216, -1.7976931348623157e308, -1.7976931348623157e308, -1.632570747006875e53}, .deadbeat = 6.583430486096094e36},
    };
    const stage12_selftest_session *session = &stage12_selftest_sessions[0];
    uint32_t failures = 0U;
    stage12 self;

    if (stage12_init(&self, &session->params) != PTC_OK) {
        failures++;
    }
    for (uint32_t i = 0U; i < 34U; i++) {
        if (stage12_init(&self, &refused[i]) != PTC_E_PARAM) {
            failures++;
        }
    }
    if (stage12_init(&self, NULL) != PTC_E_PARAM) {
        failures++;
    }
    if (stage12_init(NULL, &session->params) != PTC_E_PARAM) {
        failures++;
    }
    failures += stage12_selftest_calls_of(&self, session);
    return failures;
}

/* Calls that lack a pointer: each is refused, and changes nothing. */
static uint32_t stage12_selftest_pointers(void)
{
    const stage12_selftest_session *session = &stage12_selftest_sessions[0];
    const stage12_selftest_call *call = &stage12_selftest_calls[0];
    uint32_t failures = 0U;
    double u = 12345.0;
    double xhat[3];
    double d;
    stage12 self;

    if (stage12_init(&self, &session->params) != PTC_OK) {
        failures++;
    }
    if (stage12_arm(NULL, call->start) != PTC_E_INPUT) {
        failures++;
    }
    if (stage12_step(NULL, call->k, call->y, &u) != PTC_E_INPUT) {
        failures++;
    }
    failures += stage12_selftest_differs(u, 0.0);
    u = 12345.0;
    if (stage12_step(&self, call->k, NULL, &u) != PTC_E_INPUT) {
        failures++;
    }
    failures += stage12_selftest_differs(u, 0.0);
    if (stage12_step(&self, call->k, call->y, NULL) != PTC_E_INPUT) {
        failures++;
    }
    if (stage12_estimate(NULL, xhat) != PTC_E_INPUT) {
        failures++;
    }
    if (stage12_estimate(&self, NULL) != PTC_E_INPUT) {
        failures++;
    }
    if (stage12_disturbance(NULL, &d) != PTC_E_INPUT) {
        failures++;
    }
    if (stage12_disturbance(&self, NULL) != PTC_E_INPUT) {
        failures++;
    }
    failures += stage12_selftest_calls_of(&self, session);
    return failures;
}

uint32_t stage12_selftest(void)
{
    uint32_t failures = stage12_selftest_run();

    failures += stage12_selftest_refuse();
    failures += stage12_selftest_pointers();
    return failures;
}
