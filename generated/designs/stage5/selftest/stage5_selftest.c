/* Self-test of the prescribed-time controller stage5: see stage5_selftest.h. DO NOT EDIT. */
#include "stage5_selftest.h"
#include "stage5.h"

#include <math.h>
#include <stddef.h>

/* A call, and what it must give. */
typedef struct stage5_selftest_call {
    uint32_t is_armed; /* arm is called before it */
    uint32_t start;
    uint32_t k;
    double y[4]; /* what is measured */
    ptc_status status;
    double u;
} stage5_selftest_call;

/* A set of parameters that init takes, and the calls with it, one after the other. */
typedef struct stage5_selftest_session {
    stage5_params params;
    uint32_t first; /* of its calls */
    uint32_t count;
} stage5_selftest_session;

static const stage5_selftest_session stage5_selftest_sessions[3] = {
    {.params = {.samples = 60U, .h = 0.015625, .u_max = (double)INFINITY, .a = 1.0, .k = {117649.0, 100842.0, 36015.0, 6860.0, 735.0, 42.0}, .deadbeat = 0.0}, .first = 0U, .count = 36U},
    {.params = {.samples = 60U, .h = 0.015625, .u_max = (double)INFINITY, .a = 1.0, .k = {117649.0, 100842.0, 36015.0, 6860.0, 735.0, 42.0}, .deadbeat = 0.0}, .first = 36U, .count = 1U},
    {.params = {.samples = 60U, .h = 0.015625, .u_max = 1.0, .a = 1.0, .k = {117649.0, 100842.0, 36015.0, 6860.0, 735.0, 42.0}, .deadbeat = 0.0}, .first = 37U, .count = 2U},
};

static const stage5_selftest_call stage5_selftest_calls[39] = {
    {.is_armed = 0U, .start = 0U, .k = 0U, .y = {0.75, 0.25, -0.25, -0.75}, .status = PTC_OK, .u = -45.71390861550886},
    {.is_armed = 0U, .start = 0U, .k = 1U, .y = {0.7252083333333332, 0.2417361111111111, -0.2417361111111111, -0.7252083333333332}, .status = PTC_OK, .u = -117.66464755054447},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {0.7008333333333333, 0.2336111111111111, -0.2336111111111111, -0.7008333333333333}, .status = PTC_OK, .u = -199.68117454739695},
    {.is_armed = 0U, .start = 0U, .k = 3U, .y = {0.676875, 0.225625, -0.225625, -0.676875}, .status = PTC_OK, .u = -279.7259283671744},
    {.is_armed = 0U, .start = 0U, .k = 15U, .y = {0.421875, 0.140625, -0.140625, -0.421875}, .status = PTC_OK, .u = -415.6048724791089},
    {.is_armed = 0U, .start = 0U, .k = 26U, .y = {0.2408333333333333, 0.08027777777777777, -0.08027777777777777, -0.2408333333333333}, .status = PTC_OK, .u = -833.7152640560148},
    {.is_armed = 0U, .start = 0U, .k = 28U, .y = {0.21333333333333332, 0.07111111111111111, -0.07111111111111111, -0.21333333333333332}, .status = PTC_OK, .u = -1320.2420918132377},
    {.is_armed = 0U, .start = 0U, .k = 29U, .y = {0.20020833333333338, 0.06673611111111112, -0.06673611111111112, -0.20020833333333338}, .status = PTC_OK, .u = -1651.9592044127046},
    {.is_armed = 0U, .start = 0U, .k = 30U, .y = {0.1875, 0.0625, -0.0625, -0.1875}, .status = PTC_OK, .u = -1782.8159221050037},
    {.is_armed = 0U, .start = 0U, .k = 31U, .y = {0.17520833333333333, 0.058402777777777776, -0.058402777777777776, -0.17520833333333333}, .status = PTC_OK, .u = -1803.444957772157},
    {.is_armed = 0U, .start = 0U, .k = 45U, .y = {0.046875, 0.015625, -0.015625, -0.046875}, .status = PTC_OK, .u = -22230.716035306094},
    {.is_armed = 0U, .start = 0U, .k = 56U, .y = {0.003333333333333333, 0.0011111111111111111, -0.0011111111111111111, -0.003333333333333333}, .status = PTC_OK, .u = 49770.71223746447},
    {.is_armed = 0U, .start = 0U, .k = 58U, .y = {0.0008333333333333333, 0.0002777777777777778, -0.0002777777777777778, -0.0008333333333333333}, .status = PTC_OK, .u = 8927.661032832693},
    {.is_armed = 0U, .start = 0U, .k = 59U, .y = {0.00020833333333333332, 6.944444444444444e-5, -6.944444444444444e-5, -0.00020833333333333332}, .status = PTC_OK, .u = -536991.929098568},
    {.is_armed = 0U, .start = 0U, .k = 60U, .y = {0.0, 0.0, -0.0, -0.0}, .status = PTC_HOLD, .u = 2058691.1060659452},
    {.is_armed = 0U, .start = 0U, .k = 61U, .y = {0.0, 0.0, -0.0, -0.0}, .status = PTC_HOLD, .u = -2864845.1332781008},
    {.is_armed = 0U, .start = 0U, .k = 2147483647U, .y = {0.0, 0.0, -0.0, -0.0}, .status = PTC_HOLD, .u = -9127530.52754705},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {0.0, 0.0, -0.0, -0.0}, .status = PTC_HOLD, .u = 65158573.44296921},
    {.is_armed = 1U, .start = 4294967293U, .k = 4294967293U, .y = {0.75, 0.25, -0.25, -0.75}, .status = PTC_OK, .u = 104103031.82848832},
    {.is_armed = 0U, .start = 0U, .k = 4294967294U, .y = {0.7252083333333332, 0.2417361111111111, -0.2417361111111111, -0.7252083333333332}, .status = PTC_OK, .u = 115238424.75294194},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {0.7008333333333333, 0.2336111111111111, -0.2336111111111111, -0.7008333333333333}, .status = PTC_OK, .u = 106878812.06508702},
    {.is_armed = 0U, .start = 0U, .k = 0U, .y = {0.676875, 0.225625, -0.225625, -0.676875}, .status = PTC_OK, .u = 86970522.92810044},
    {.is_armed = 0U, .start = 0U, .k = 12U, .y = {0.421875, 0.140625, -0.140625, -0.421875}, .status = PTC_OK, .u = 55735570.031022504},
    {.is_armed = 0U, .start = 0U, .k = 23U, .y = {0.2408333333333333, 0.08027777777777777, -0.08027777777777777, -0.2408333333333333}, .status = PTC_OK, .u = 15593779.472793031},
    {.is_armed = 0U, .start = 0U, .k = 25U, .y = {0.21333333333333332, 0.07111111111111111, -0.07111111111111111, -0.21333333333333332}, .status = PTC_OK, .u = -12422149.569431677},
    {.is_armed = 0U, .start = 0U, .k = 26U, .y = {0.20020833333333338, 0.06673611111111112, -0.06673611111111112, -0.20020833333333338}, .status = PTC_OK, .u = -19786492.773077007},
    {.is_armed = 0U, .start = 0U, .k = 27U, .y = {0.1875, 0.0625, -0.0625, -0.1875}, .status = PTC_OK, .u = -11936094.796427239},
    {.is_armed = 0U, .start = 0U, .k = 28U, .y = {0.17520833333333333, 0.058402777777777776, -0.058402777777777776, -0.17520833333333333}, .status = PTC_OK, .u = -387032.3475145274},
    {.is_armed = 0U, .start = 0U, .k = 42U, .y = {0.046875, 0.015625, -0.015625, -0.046875}, .status = PTC_OK, .u = 21186722.354277074},
    {.is_armed = 0U, .start = 0U, .k = 53U, .y = {0.003333333333333333, 0.0011111111111111111, -0.0011111111111111111, -0.003333333333333333}, .status = PTC_OK, .u = -80933752.5434445},
    {.is_armed = 0U, .start = 0U, .k = 55U, .y = {0.0008333333333333333, 0.0002777777777777778, -0.0002777777777777778, -0.0008333333333333333}, .status = PTC_OK, .u = 111853489.9806369},
    {.is_armed = 0U, .start = 0U, .k = 56U, .y = {0.00020833333333333332, 6.944444444444444e-5, -6.944444444444444e-5, -0.00020833333333333332}, .status = PTC_OK, .u = 361919991.34930485},
    {.is_armed = 0U, .start = 0U, .k = 57U, .y = {0.0, 0.0, -0.0, -0.0}, .status = PTC_HOLD, .u = -2566214865.2035885},
    {.is_armed = 0U, .start = 0U, .k = 58U, .y = {0.0, 0.0, -0.0, -0.0}, .status = PTC_HOLD, .u = 6645659547.321305},
    {.is_armed = 0U, .start = 0U, .k = 2147483644U, .y = {0.0, 0.0, -0.0, -0.0}, .status = PTC_HOLD, .u = -920489537.2493362},
    {.is_armed = 0U, .start = 0U, .k = 4294967292U, .y = {0.0, 0.0, -0.0, -0.0}, .status = PTC_HOLD, .u = -62774637324.215706},
    {.is_armed = 0U, .start = 0U, .k = 17U, .y = {-8.157235602884216e307, 6.004507445892454e307, 1.0698021803514765e308, 5.225755026302461e307}, .status = PTC_E_RANGE, .u = 0.0},
    {.is_armed = 0U, .start = 0U, .k = 0U, .y = {0.747427168001794, 0.8484273023779708, 0.33295641872522863, -0.669418584296563}, .status = PTC_SATURATED, .u = -1.0},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {-0.7362366652816934, -0.5570395573691591, -0.6920426914866533, 0.6298517774319439}, .status = PTC_SATURATED, .u = 1.0},
};

/* 1 where a number is not the one that must come. */
static uint32_t stage5_selftest_differs(double value, double wanted)
{
    uint32_t failures = 1U;

    if (fabs(value - wanted) <= 0.0) {
        failures = 0U;
    }
    return failures;
}

/* The failures of one call. */
static uint32_t stage5_selftest_check(stage5 *self, const stage5_selftest_call *call)
{
    uint32_t failures = 0U;
    double u = 12345.0;

    if (call->is_armed != 0U) {
        if (stage5_arm(self, call->start) != PTC_OK) {
            failures++;
        }
    }
    if (stage5_step(self, call->k, call->y, &u) != call->status) {
        failures++;
    }
    failures += stage5_selftest_differs(u, call->u);
    return failures;
}

/* The calls of a session, of which init has been called. */
static uint32_t stage5_selftest_calls_of(stage5 *self, const stage5_selftest_session *session)
{
    uint32_t failures = 0U;

    for (uint32_t j = 0U; j < session->count; j++) {
        failures += stage5_selftest_check(self, &stage5_selftest_calls[session->first + j]);
    }
    return failures;
}

/* Every session with its calls. */
static uint32_t stage5_selftest_run(void)
{
    uint32_t failures = 0U;

    for (uint32_t i = 0U; i < 3U; i++) {
        const stage5_selftest_session *session = &stage5_selftest_sessions[i];
        stage5 self;

        if (stage5_init(&self, &session->params) == PTC_OK) {
            failures += stage5_selftest_calls_of(&self, session);
        } else {
            failures++;
        }
    }
    return failures;
}

/* What init must refuse without a change. */
static uint32_t stage5_selftest_refuse(void)
{
    static const stage5_params refused[68] = {
        {.samples = 0U, .h = 0.015625, .u_max = (double)INFINITY, .a = 1.0, .k = {117649.0, 100842.0, 36015.0, 6860.0, 735.0, 42.0}, .deadbeat = 0.0},
        {.samples = 5U, .h = 0.015625, .u_max = (double)INFINITY, .a = 1.0, .k = {117649.0, 100842.0, 36015.0, 6860.0, 735.0, 42.0}, .deadbeat = 0.0},
        {.samples = 60U, .h = (double)NAN, .u_max = (double)INFINITY, .a = 1.0, .k = {117649.0, 100842.0, 36015.0, 6860.0, 735.0, 42.0}, .deadbeat = 0.0},
        {.samples = 60U, .h = (double)INFINITY, .u_max = (double)INFINITY, .a = 1.0, .k = {117649.0, 100842.0, 36015.0, 6860.0, 735.0, 42.0}, .deadbeat = 0.0},
        {.samples = 60U, .h = -(double)INFINITY, .u_max = (double)INFINITY, .a = 1.0, .k = {117649.0, 100842.0, 36015.0, 6860.0, 735.0, 42.0}, .deadbeat = 0.0},
        {.samples = 60U, .h = 0.0, .u_max = (double)INFINITY, .a = 1.0, .k = {117649.0, 100842.0, 36015.0, 6860.0, 735.0, 42.0}, .deadbeat = 0.0},
        {.samples = 60U, .h = -1.0, .u_max = (double)INFINITY, .a = 1.0, .k = {117649.0, 100842.0, 36015.0, 6860.0, 735.0, 42.0}, .deadbeat = 0.0},
        {.samples = 60U, .h = 1.7976931348623157e308, .u_max = (double)INFINITY, .a = 1.0, .k = {117649.0, 100842.0, 36015.0, 6860.0, 735.0, 42.0}, .deadbeat = 0.0},
        {.samples = 60U, .h = -1.7976931348623157e308, .u_max = (double)INFINITY, .a = 1.0, .k = {117649.0, 100842.0, 36015.0, 6860.0, 735.0, 42.0}, .deadbeat = 0.0},
        {.samples = 60U, .h = 5e-324, .u_max = (double)INFINITY, .a = 1.0, .k = {117649.0, 100842.0, 36015.0, 6860.0, 735.0, 42.0}, .deadbeat = 0.0},
        {.samples = 60U, .h = 7.5e-151, .u_max = (double)INFINITY, .a = 1.0, .k = {117649.0, 100842.0, 36015.0, 6860.0, 735.0, 42.0}, .deadbeat = 0.0},
        {.samples = 60U, .h = 1e-150, .u_max = (double)INFINITY, .a = 1.0, .k = {117649.0, 100842.0, 36015.0, 6860.0, 735.0, 42.0}, .deadbeat = 0.0},
        {.samples = 60U, .h = 1e150, .u_max = (double)INFINITY, .a = 1.0, .k = {117649.0, 100842.0, 36015.0, 6860.0, 735.0, 42.0}, .deadbeat = 0.0},
        {.samples = 60U, .h = 1.25e150, .u_max = (double)INFINITY, .a = 1.0, .k = {117649.0, 100842.0, 36015.0, 6860.0, 735.0, 42.0}, .deadbeat = 0.0},
        {.samples = 60U, .h = 0.015625, .u_max = (double)NAN, .a = 1.0, .k = {117649.0, 100842.0, 36015.0, 6860.0, 735.0, 42.0}, .deadbeat = 0.0},
        {.samples = 60U, .h = 0.015625, .u_max = -(double)INFINITY, .a = 1.0, .k = {117649.0, 100842.0, 36015.0, 6860.0, 735.0, 42.0}, .deadbeat = 0.0},
        {.samples = 60U, .h = 0.015625, .u_max = 0.0, .a = 1.0, .k = {117649.0, 100842.0, 36015.0, 6860.0, 735.0, 42.0}, .deadbeat = 0.0},
        {.samples = 60U, .h = 0.015625, .u_max = -1.0, .a = 1.0, .k = {117649.0, 100842.0, 36015.0, 6860.0, 735.0, 42.0}, .deadbeat = 0.0},
        {.samples = 60U, .h = 0.015625, .u_max = -1.7976931348623157e308, .a = 1.0, .k = {117649.0, 100842.0, 36015.0, 6860.0, 735.0, 42.0}, .deadbeat = 0.0},
        {.samples = 60U, .h = 0.015625, .u_max = (double)INFINITY, .a = (double)NAN, .k = {117649.0, 100842.0, 36015.0, 6860.0, 735.0, 42.0}, .deadbeat = 0.0},
        {.samples = 60U, .h = 0.015625, .u_max = (double)INFINITY, .a = (double)INFINITY, .k = {117649.0, 100842.0, 36015.0, 6860.0, 735.0, 42.0}, .deadbeat = 0.0},
        {.samples = 60U, .h = 0.015625, .u_max = (double)INFINITY, .a = -(double)INFINITY, .k = {117649.0, 100842.0, 36015.0, 6860.0, 735.0, 42.0}, .deadbeat = 0.0},
        {.samples = 60U, .h = 0.015625, .u_max = (double)INFINITY, .a = 0.0, .k = {117649.0, 100842.0, 36015.0, 6860.0, 735.0, 42.0}, .deadbeat = 0.0},
        {.samples = 60U, .h = 0.015625, .u_max = (double)INFINITY, .a = -1.0, .k = {117649.0, 100842.0, 36015.0, 6860.0, 735.0, 42.0}, .deadbeat = 0.0},
        {.samples = 60U, .h = 0.015625, .u_max = (double)INFINITY, .a = 1.7976931348623157e308, .k = {117649.0, 100842.0, 36015.0, 6860.0, 735.0, 42.0}, .deadbeat = 0.0},
        {.samples = 60U, .h = 0.015625, .u_max = (double)INFINITY, .a = -1.7976931348623157e308, .k = {117649.0, 100842.0, 36015.0, 6860.0, 735.0, 42.0}, .deadbeat = 0.0},
        {.samples = 60U, .h = 0.015625, .u_max = (double)INFINITY, .a = 5e-324, .k = {117649.0, 100842.0, 36015.0, 6860.0, 735.0, 42.0}, .deadbeat = 0.0},
        {.samples = 60U, .h = 0.015625, .u_max = (double)INFINITY, .a = 7.5e-151, .k = {117649.0, 100842.0, 36015.0, 6860.0, 735.0, 42.0}, .deadbeat = 0.0},
        {.samples = 60U, .h = 0.015625, .u_max = (double)INFINITY, .a = 1e-150, .k = {117649.0, 100842.0, 36015.0, 6860.0, 735.0, 42.0}, .deadbeat = 0.0},
        {.samples = 60U, .h = 0.015625, .u_max = (double)INFINITY, .a = 1.25e150, .k = {117649.0, 100842.0, 36015.0, 6860.0, 735.0, 42.0}, .deadbeat = 0.0},
        {.samples = 60U, .h = 0.015625, .u_max = (double)INFINITY, .a = 1.0, .k = {(double)NAN, 100842.0, 36015.0, 6860.0, 735.0, 42.0}, .deadbeat = 0.0},
        {.samples = 60U, .h = 0.015625, .u_max = (double)INFINITY, .a = 1.0, .k = {(double)INFINITY, 100842.0, 36015.0, 6860.0, 735.0, 42.0}, .deadbeat = 0.0},
        {.samples = 60U, .h = 0.015625, .u_max = (double)INFINITY, .a = 1.0, .k = {-(double)INFINITY, 100842.0, 36015.0, 6860.0, 735.0, 42.0}, .deadbeat = 0.0},
        {.samples = 60U, .h = 0.015625, .u_max = (double)INFINITY, .a = 1.0, .k = {1.7976931348623157e308, 100842.0, 36015.0, 6860.0, 735.0, 42.0}, .deadbeat = 0.0},
        {.samples = 60U, .h = 0.015625, .u_max = (double)INFINITY, .a = 1.0, .k = {-1.7976931348623157e308, 100842.0, 36015.0, 6860.0, 735.0, 42.0}, .deadbeat = 0.0},
        {.samples = 60U, .h = 0.015625, .u_max = (double)INFINITY, .a = 1.0, .k = {117649.0, (double)NAN, 36015.0, 6860.0, 735.0, 42.0}, .deadbeat = 0.0},
        {.samples = 60U, .h = 0.015625, .u_max = (double)INFINITY, .a = 1.0, .k = {117649.0, (double)INFINITY, 36015.0, 6860.0, 735.0, 42.0}, .deadbeat = 0.0},
        {.samples = 60U, .h = 0.015625, .u_max = (double)INFINITY, .a = 1.0, .k = {117649.0, -(double)INFINITY, 36015.0, 6860.0, 735.0, 42.0}, .deadbeat = 0.0},
        {.samples = 60U, .h = 0.015625, .u_max = (double)INFINITY, .a = 1.0, .k = {117649.0, 1.7976931348623157e308, 36015.0, 6860.0, 735.0, 42.0}, .deadbeat = 0.0},
        {.samples = 60U, .h = 0.015625, .u_max = (double)INFINITY, .a = 1.0, .k = {117649.0, -1.7976931348623157e308, 36015.0, 6860.0, 735.0, 42.0}, .deadbeat = 0.0},
        {.samples = 60U, .h = 0.015625, .u_max = (double)INFINITY, .a = 1.0, .k = {117649.0, 100842.0, (double)NAN, 6860.0, 735.0, 42.0}, .deadbeat = 0.0},
        {.samples = 60U, .h = 0.015625, .u_max = (double)INFINITY, .a = 1.0, .k = {117649.0, 100842.0, (double)INFINITY, 6860.0, 735.0, 42.0}, .deadbeat = 0.0},
        {.samples = 60U, .h = 0.015625, .u_max = (double)INFINITY, .a = 1.0, .k = {117649.0, 100842.0, -(double)INFINITY, 6860.0, 735.0, 42.0}, .deadbeat = 0.0},
        {.samples = 60U, .h = 0.015625, .u_max = (double)INFINITY, .a = 1.0, .k = {117649.0, 100842.0, 1.7976931348623157e308, 6860.0, 735.0, 42.0}, .deadbeat = 0.0},
        {.samples = 60U, .h = 0.015625, .u_max = (double)INFINITY, .a = 1.0, .k = {117649.0, 100842.0, -1.7976931348623157e308, 6860.0, 735.0, 42.0}, .deadbeat = 0.0},
        {.samples = 60U, .h = 0.015625, .u_max = (double)INFINITY, .a = 1.0, .k = {117649.0, 100842.0, 36015.0, (double)NAN, 735.0, 42.0}, .deadbeat = 0.0},
        {.samples = 60U, .h = 0.015625, .u_max = (double)INFINITY, .a = 1.0, .k = {117649.0, 100842.0, 36015.0, (double)INFINITY, 735.0, 42.0}, .deadbeat = 0.0},
        {.samples = 60U, .h = 0.015625, .u_max = (double)INFINITY, .a = 1.0, .k = {117649.0, 100842.0, 36015.0, -(double)INFINITY, 735.0, 42.0}, .deadbeat = 0.0},
        {.samples = 60U, .h = 0.015625, .u_max = (double)INFINITY, .a = 1.0, .k = {117649.0, 100842.0, 36015.0, 1.7976931348623157e308, 735.0, 42.0}, .deadbeat = 0.0},
        {.samples = 60U, .h = 0.015625, .u_max = (double)INFINITY, .a = 1.0, .k = {117649.0, 100842.0, 36015.0, -1.7976931348623157e308, 735.0, 42.0}, .deadbeat = 0.0},
        {.samples = 60U, .h = 0.015625, .u_max = (double)INFINITY, .a = 1.0, .k = {117649.0, 100842.0, 36015.0, 6860.0, (double)NAN, 42.0}, .deadbeat = 0.0},
        {.samples = 60U, .h = 0.015625, .u_max = (double)INFINITY, .a = 1.0, .k = {117649.0, 100842.0, 36015.0, 6860.0, (double)INFINITY, 42.0}, .deadbeat = 0.0},
        {.samples = 60U, .h = 0.015625, .u_max = (double)INFINITY, .a = 1.0, .k = {117649.0, 100842.0, 36015.0, 6860.0, -(double)INFINITY, 42.0}, .deadbeat = 0.0},
        {.samples = 60U, .h = 0.015625, .u_max = (double)INFINITY, .a = 1.0, .k = {117649.0, 100842.0, 36015.0, 6860.0, 1.7976931348623157e308, 42.0}, .deadbeat = 0.0},
        {.samples = 60U, .h = 0.015625, .u_max = (double)INFINITY, .a = 1.0, .k = {117649.0, 100842.0, 36015.0, 6860.0, -1.7976931348623157e308, 42.0}, .deadbeat = 0.0},
        {.samples = 60U, .h = 0.015625, .u_max = (double)INFINITY, .a = 1.0, .k = {117649.0, 100842.0, 36015.0, 6860.0, 735.0, (double)NAN}, .deadbeat = 0.0},
        {.samples = 60U, .h = 0.015625, .u_max = (double)INFINITY, .a = 1.0, .k = {117649.0, 100842.0, 36015.0, 6860.0, 735.0, (double)INFINITY}, .deadbeat = 0.0},
        {.samples = 60U, .h = 0.015625, .u_max = (double)INFINITY, .a = 1.0, .k = {117649.0, 100842.0, 36015.0, 6860.0, 735.0, -(double)INFINITY}, .deadbeat = 0.0},
        {.samples = 60U, .h = 0.015625, .u_max = (double)INFINITY, .a = 1.0, .k = {117649.0, 100842.0, 36015.0, 6860.0, 735.0, 1.7976931348623157e308}, .deadbeat = 0.0},
        {.samples = 60U, .h = 0.015625, .u_max = (double)INFINITY, .a = 1.0, .k = {117649.0, 100842.0, 36015.0, 6860.0, 735.0, -1.7976931348623157e308}, .deadbeat = 0.0},
        {.samples = 60U, .h = 0.015625, .u_max = (double)INFINITY, .a = 1.0, .k = {117649.0, 100842.0, 36015.0, 6860.0, 735.0, 42.0}, .deadbeat = (double)NAN},
        {.samples = 60U, .h = 0.015625, .u_max = (double)INFINITY, .a = 1.0, .k = {117649.0, 100842.0, 36015.0, 6860.0, 735.0, 42.0}, .deadbeat = (double)INFINITY},
        {.samples = 60U, .h = 0.015625, .u_max = (double)INFINITY, .a = 1.0, .k = {117649.0, 100842.0, 36015.0, 6860.0, 735.0, 42.0}, .deadbeat = -(double)INFINITY},
        {.samples = 60U, .h = 0.015625, .u_max = (double)INFINITY, .a = 1.0, .k = {117649.0, 100842.0, 36015.0, 6860.0, 735.0, 42.0}, .deadbeat = -1.0},
        {.samples = 60U, .h = 0.015625, .u_max = (double)INFINITY, .a = 1.0, .k = {117649.0, 100842.0, 36015.0, 6860.0, 735.0, 42.0}, .deadbeat = -1.7976931348623157e308},
        {.samples = 60U, .h = 5.1160704926257875e-73, .u_max = 3.1927870032090068e-298, .a = 5.237656511534907e82, .k = {1.7976931348623157e308, -1.8480639864608064e306, 4.7063018532664577e142, -1.7976931348623157e308, 5.136413388695272e-293, -3.0858088639553135e-284}, .deadbeat = 1.7976931348623157e308},
        {.samples = 60U, .h = 1e150, .u_max = (double)INFINITY, .a = 1.0, .k = {-1.7976931348623157e308, -1.1156296291813806e-137, 1.7976931348623157e308, 5.453881758726523e-119, 5.507191159908505e239, 42.0}, .deadbeat = 0.0},
        {.samples = 60U, .h = 0.015625, .u_max = (double)INFINITY, .a = 1.0, .k = {117649.0, 100842.0, 1.0753995724152521e-283, 6860.0, -1.7976931348623157e308, -1.7976931348623157e308}, .deadbeat = 0.0},
    };
    const stage5_selftest_session *session = &stage5_selftest_sessions[0];
    uint32_t failures = 0U;
    stage5 self;

    if (stage5_init(&self, &session->params) != PTC_OK) {
        failures++;
    }
    for (uint32_t i = 0U; i < 68U; i++) {
        if (stage5_init(&self, &refused[i]) != PTC_E_PARAM) {
            failures++;
        }
    }
    if (stage5_init(&self, NULL) != PTC_E_PARAM) {
        failures++;
    }
    if (stage5_init(NULL, &session->params) != PTC_E_PARAM) {
        failures++;
    }
    failures += stage5_selftest_calls_of(&self, session);
    return failures;
}

uint32_t stage5_selftest(void)
{
    uint32_t failures = stage5_selftest_run();

    failures += stage5_selftest_refuse();
    return failures;
}
