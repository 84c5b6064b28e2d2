/* Self-test of the prescribed-time controller stage6: see stage6_selftest.h. DO NOT EDIT. */
#include "stage6_selftest.h"
#include "stage6.h"

#include <math.h>
#include <stddef.h>

/* A call, and what it must give. */
typedef struct stage6_selftest_call {
    uint32_t is_armed; /* arm is called before it */
    uint32_t start;
    uint32_t k;
    double y[2]; /* what is measured */
    ptc_status status;
    double u;
    double xhat[2]; /* the estimates behind it */
} stage6_selftest_call;

/* A set of parameters that init takes, and the calls with it, one after the other. */
typedef struct stage6_selftest_session {
    stage6_params params;
    uint32_t first; /* of its calls */
    uint32_t count;
} stage6_selftest_session;

static const stage6_selftest_session stage6_selftest_sessions[6] = {
    {.params = {.samples = 60U, .u_max = (double)INFINITY, .k = {64.0, 48.0, 12.0}, .deadbeat = 0.0}, .first = 0U, .count = 48U},
    {.params = {.samples = 60U, .u_max = (double)INFINITY, .k = {64.0, 48.0, 0.0}, .deadbeat = 0.0}, .first = 48U, .count = 1U},
    {.params = {.samples = 60U, .u_max = (double)INFINITY, .k = {64.0, 48.0, 12.0}, .deadbeat = 1.7976931348623157e308}, .first = 49U, .count = 1U},
    {.params = {.samples = 60U, .u_max = (double)INFINITY, .k = {64.0, 48.0, 12.0}, .deadbeat = 0.0}, .first = 50U, .count = 2U},
    {.params = {.samples = 60U, .u_max = (double)INFINITY, .k = {64.0, 48.0, 12.0}, .deadbeat = 0.0}, .first = 52U, .count = 2U},
    {.params = {.samples = 60U, .u_max = 1.0, .k = {64.0, 48.0, 12.0}, .deadbeat = 0.0}, .first = 54U, .count = 2U},
};

static const stage6_selftest_call stage6_selftest_calls[56] = {
    {.is_armed = 0U, .start = 0U, .k = 0U, .y = {0.75, 0.25}, .status = PTC_OK, .u = -43317.7169391253, .xhat = {0.25, 0.001}},
    {.is_armed = 0U, .start = 0U, .k = 1U, .y = {0.7252083333333332, 0.2417361111111111}, .status = PTC_OK, .u = -33736.13442650668, .xhat = {0.14034002979732002, -170.1212348028338}},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {0.7008333333333333, 0.2336111111111111}, .status = PTC_OK, .u = -26201.190501762325, .xhat = {-0.10871533131026156, -293.4175710655298}},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {(double)NAN, 0.5}, .status = PTC_E_INPUT, .u = 0.0, .xhat = {-0.10871533131026156, -293.4175710655298}},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {0.5, (double)NAN}, .status = PTC_E_INPUT, .u = 0.0, .xhat = {-0.10871533131026156, -293.4175710655298}},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {(double)INFINITY, 0.5}, .status = PTC_E_INPUT, .u = 0.0, .xhat = {-0.10871533131026156, -293.4175710655298}},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {0.5, (double)INFINITY}, .status = PTC_E_INPUT, .u = 0.0, .xhat = {-0.10871533131026156, -293.4175710655298}},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {-(double)INFINITY, 0.5}, .status = PTC_E_INPUT, .u = 0.0, .xhat = {-0.10871533131026156, -293.4175710655298}},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {0.5, -(double)INFINITY}, .status = PTC_E_INPUT, .u = 0.0, .xhat = {-0.10871533131026156, -293.4175710655298}},
    {.is_armed = 0U, .start = 0U, .k = 3U, .y = {0.676875, 0.225625}, .status = PTC_OK, .u = -20824.39397115681, .xhat = {-0.3787834896542176, -375.5828587512432}},
    {.is_armed = 0U, .start = 0U, .k = 15U, .y = {0.421875, 0.140625}, .status = PTC_OK, .u = -28579.55135802369, .xhat = {-0.3040866857803399, -359.016662592297}},
    {.is_armed = 0U, .start = 0U, .k = 26U, .y = {0.2408333333333333, 0.08027777777777777}, .status = PTC_OK, .u = -92619.2145764276, .xhat = {0.08027777777777767, 135.0236290630114}},
    {.is_armed = 0U, .start = 0U, .k = 28U, .y = {0.21333333333333332, 0.07111111111111111}, .status = PTC_OK, .u = -63940.16141840372, .xhat = {0.07111111111111111, -189.82126248618854}},
    {.is_armed = 0U, .start = 0U, .k = 29U, .y = {0.20020833333333338, 0.06673611111111112}, .status = PTC_OK, .u = -72892.98620200275, .xhat = {0.06673611111111111, -130.06732283680742}},
    {.is_armed = 0U, .start = 0U, .k = 30U, .y = {0.1875, 0.0625}, .status = PTC_OK, .u = -73580.86492335291, .xhat = {0.0625, -147.90352795956107}},
    {.is_armed = 0U, .start = 0U, .k = 31U, .y = {0.17520833333333333, 0.058402777777777776}, .status = PTC_OK, .u = -76298.22465102116, .xhat = {0.0584027777777778, -149.20984095781694}},
    {.is_armed = 0U, .start = 0U, .k = 45U, .y = {0.046875, 0.015625}, .status = PTC_OK, .u = -2853850.9491624897, .xhat = {0.015625, -173.98483819093116}},
    {.is_armed = 0U, .start = 0U, .k = 56U, .y = {0.003333333333333333, 0.0011111111111111111}, .status = PTC_OK, .u = 2410744.545991542, .xhat = {0.0011111111111112848, -5714.958342769424}},
    {.is_armed = 0U, .start = 0U, .k = 58U, .y = {0.0008333333333333333, 0.0002777777777777778}, .status = PTC_OK, .u = -2261811.4518811353, .xhat = {0.0002777777777778212, 4821.072925316416}},
    {.is_armed = 0U, .start = 0U, .k = 59U, .y = {0.00020833333333333332, 6.944444444444444e-5}, .status = PTC_OK, .u = 2060336.2336688188, .xhat = {6.94444444444553e-5, -4523.726570428938}},
    {.is_armed = 0U, .start = 0U, .k = 60U, .y = {0.0, 0.0}, .status = PTC_HOLD, .u = -1888626.1123445656, .xhat = {0.0, 4120.638245115416}},
    {.is_armed = 0U, .start = 0U, .k = 61U, .y = {0.0, 0.0}, .status = PTC_HOLD, .u = 1731240.1238158518, .xhat = {0.0, -3777.251724689131}},
    {.is_armed = 0U, .start = 0U, .k = 2147483647U, .y = {0.0, 0.0}, .status = PTC_HOLD, .u = -1586970.5926645307, .xhat = {0.0, 3462.4807476317037}},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {0.0, 0.0}, .status = PTC_HOLD, .u = 1454722.5641091533, .xhat = {0.0, -3173.940685329062}},
    {.is_armed = 1U, .start = 4294967293U, .k = 4294967293U, .y = {0.75, 0.25}, .status = PTC_OK, .u = -196253.87609702515, .xhat = {-0.23771396079221485, 2658.819993971594}},
    {.is_armed = 0U, .start = 0U, .k = 4294967294U, .y = {0.7252083333333332, 0.2417361111111111}, .status = PTC_OK, .u = -157506.74040736278, .xhat = {2.732440313757275, 1796.4866965442934}},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {0.7008333333333333, 0.2336111111111111}, .status = PTC_OK, .u = -118280.87589128914, .xhat = {3.5227082160031586, 1054.553584896326}},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {(double)NAN, 0.5}, .status = PTC_E_INPUT, .u = 0.0, .xhat = {3.5227082160031586, 1054.553584896326}},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {0.5, (double)NAN}, .status = PTC_E_INPUT, .u = 0.0, .xhat = {3.5227082160031586, 1054.553584896326}},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {(double)INFINITY, 0.5}, .status = PTC_E_INPUT, .u = 0.0, .xhat = {3.5227082160031586, 1054.553584896326}},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {0.5, (double)INFINITY}, .status = PTC_E_INPUT, .u = 0.0, .xhat = {3.5227082160031586, 1054.553584896326}},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {-(double)INFINITY, 0.5}, .status = PTC_E_INPUT, .u = 0.0, .xhat = {3.5227082160031586, 1054.553584896326}},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {0.5, -(double)INFINITY}, .status = PTC_E_INPUT, .u = 0.0, .xhat = {3.5227082160031586, 1054.553584896326}},
    {.is_armed = 0U, .start = 0U, .k = 0U, .y = {0.676875, 0.225625}, .status = PTC_OK, .u = -83798.19883726696, .xhat = {3.1317151088877835, 472.58177257446647}},
    {.is_armed = 0U, .start = 0U, .k = 12U, .y = {0.421875, 0.140625}, .status = PTC_OK, .u = -54702.836165758024, .xhat = {1.3234810818624148, -128.22770506264072}},
    {.is_armed = 0U, .start = 0U, .k = 23U, .y = {0.2408333333333333, 0.08027777777777777}, .status = PTC_OK, .u = -4942.77008376734, .xhat = {0.08027777777777778, -731.0068243738347}},
    {.is_armed = 0U, .start = 0U, .k = 25U, .y = {0.21333333333333332, 0.07111111111111111}, .status = PTC_OK, .u = -82770.04688714427, .xhat = {0.07111111111111112, -14.46837350086787}},
    {.is_armed = 0U, .start = 0U, .k = 26U, .y = {0.20020833333333338, 0.06673611111111112}, .status = PTC_OK, .u = -68722.44919743878, .xhat = {0.06673611111111111, -167.72709377428856}},
    {.is_armed = 0U, .start = 0U, .k = 27U, .y = {0.1875, 0.0625}, .status = PTC_OK, .u = -74534.4076291378, .xhat = {0.0625, -139.5624539504331}},
    {.is_armed = 0U, .start = 0U, .k = 28U, .y = {0.17520833333333333, 0.058402777777777776}, .status = PTC_OK, .u = -76072.93345123512, .xhat = {0.0584027777777778, -151.1169263693867}},
    {.is_armed = 0U, .start = 0U, .k = 42U, .y = {0.046875, 0.015625}, .status = PTC_OK, .u = -2854057.4660956273, .xhat = {0.015625, -173.53425579135916}},
    {.is_armed = 0U, .start = 0U, .k = 53U, .y = {0.003333333333333333, 0.0011111111111111111}, .status = PTC_OK, .u = 2410933.8531802506, .xhat = {0.0011111111111112848, -5715.371376635699}},
    {.is_armed = 0U, .start = 0U, .k = 55U, .y = {0.0008333333333333333, 0.0002777777777777778}, .status = PTC_OK, .u = -2261984.983470785, .xhat = {0.0002777777777778212, 4821.451539693834}},
    {.is_armed = 0U, .start = 0U, .k = 56U, .y = {0.00020833333333333332, 6.944444444444444e-5}, .status = PTC_OK, .u = 2060495.3042926646, .xhat = {6.94444444444553e-5, -4524.073633608238}},
    {.is_armed = 0U, .start = 0U, .k = 57U, .y = {0.0, 0.0}, .status = PTC_HOLD, .u = -1888771.9270830909, .xhat = {0.0, 4120.956386363107}},
    {.is_armed = 0U, .start = 0U, .k = 58U, .y = {0.0, 0.0}, .status = PTC_HOLD, .u = 1731373.7873261669, .xhat = {0.0, -3777.5433541661823}},
    {.is_armed = 0U, .start = 0U, .k = 2147483644U, .y = {0.0, 0.0}, .status = PTC_HOLD, .u = -1587093.1175489863, .xhat = {0.0, 3462.748074652334}},
    {.is_armed = 0U, .start = 0U, .k = 4294967292U, .y = {0.0, 0.0}, .status = PTC_HOLD, .u = 1454834.8785865707, .xhat = {0.0, -3174.1857350979726}},
    {.is_armed = 0U, .start = 0U, .k = 0U, .y = {0.0, 0.0}, .status = PTC_OK, .u = -0.2335298811573278, .xhat = {0.0, 0.001}},
    {.is_armed = 0U, .start = 0U, .k = 0U, .y = {0.0, 0.0}, .status = PTC_OK, .u = -0.7083333333333333, .xhat = {0.0, 0.001}},
    {.is_armed = 0U, .start = 0U, .k = 21U, .y = {-0.41330936950436414, -0.9660334530411353}, .status = PTC_OK, .u = 94516.01669115612, .xhat = {-0.9660334530411353, 0.001}},
    {.is_armed = 1U, .start = 0U, .k = 9U, .y = {-6.227221554326833e301, -1.4220768841726614e302}, .status = PTC_E_RANGE, .u = 0.0, .xhat = {-0.9660334530411353, 0.001}},
    {.is_armed = 0U, .start = 0U, .k = 28U, .y = {1.274378838819341e154, -1.306709740853777e154}, .status = PTC_OK, .u = -4.860348533039707e159, .xhat = {-1.306709740853777e154, 0.001}},
    {.is_armed = 1U, .start = 0U, .k = 58U, .y = {9.894115997061516e153, 4.2963513557999444e153}, .status = PTC_OK, .u = -6.105456986780553e161, .xhat = {4.2963513557999444e153, -1.944139413215883e157}},
    {.is_armed = 0U, .start = 0U, .k = 0U, .y = {-0.7104224394383356, 0.8625194574972337}, .status = PTC_SATURATED, .u = 1.0, .xhat = {0.8625194574972337, 0.001}},
    {.is_armed = 0U, .start = 0U, .k = 1U, .y = {0.2749599792465945, -0.9024438672065972}, .status = PTC_SATURATED, .u = -1.0, .xhat = {0.1821425517892975, -33.66275631974987}},
};

/* 1 where a number is not the one that must come. */
static uint32_t stage6_selftest_differs(double value, double wanted)
{
    uint32_t failures = 1U;

    if (fabs(value - wanted) <= 0.0) {
        failures = 0U;
    }
    return failures;
}

/* The failures of one call. */
static uint32_t stage6_selftest_check(stage6 *self, const stage6_selftest_call *call)
{
    uint32_t failures = 0U;
    double u = 12345.0;
    double xhat[2] = {12345.0, 12345.0};

    if (call->is_armed != 0U) {
        if (stage6_arm(self, call->start) != PTC_OK) {
            failures++;
        }
    }
    if (stage6_step(self, call->k, call->y, &u) != call->status) {
        failures++;
    }
    failures += stage6_selftest_differs(u, call->u);
    if (stage6_estimate(self, xhat) != PTC_OK) {
        failures++;
    }
    for (uint32_t i = 0U; i < 2U; i++) {
        failures += stage6_selftest_differs(xhat[i], call->xhat[i]);
    }
    return failures;
}

/* The calls of a session, of which init has been called. */
static uint32_t stage6_selftest_calls_of(stage6 *self, const stage6_selftest_session *session)
{
    uint32_t failures = 0U;

    for (uint32_t j = 0U; j < session->count; j++) {
        failures += stage6_selftest_check(self, &stage6_selftest_calls[session->first + j]);
    }
    return failures;
}

/* Every session with its calls. */
static uint32_t stage6_selftest_run(void)
{
    uint32_t failures = 0U;

    for (uint32_t i = 0U; i < 6U; i++) {
        const stage6_selftest_session *session = &stage6_selftest_sessions[i];
        stage6 self;

        if (stage6_init(&self, &session->params) == PTC_OK) {
            failures += stage6_selftest_calls_of(&self, session);
        } else {
            failures++;
        }
    }
    return failures;
}

/* What init must refuse without a change. */
static uint32_t stage6_selftest_refuse(void)
{
    static const stage6_params refused[27] = {
        {.samples = 0U, .u_max = (double)INFINITY, .k = {64.0, 48.0, 12.0}, .deadbeat = 0.0},
        {.samples = 5U, .u_max = (double)INFINITY, .k = {64.0, 48.0, 12.0}, .deadbeat = 0.0},
        {.samples = 60U, .u_max = (double)NAN, .k = {64.0, 48.0, 12.0}, .deadbeat = 0.0},
        {.samples = 60U, .u_max = -(double)INFINITY, .k = {64.0, 48.0, 12.0}, .deadbeat = 0.0},
        {.samples = 60U, .u_max = 0.0, .k = {64.0, 48.0, 12.0}, .deadbeat = 0.0},
        {.samples = 60U, .u_max = -1.0, .k = {64.0, 48.0, 12.0}, .deadbeat = 0.0},
        {.samples = 60U, .u_max = -1.7976931348623157e308, .k = {64.0, 48.0, 12.0}, .deadbeat = 0.0},
        {.samples = 60U, .u_max = (double)INFINITY, .k = {(double)NAN, 48.0, 12.0}, .deadbeat = 0.0},
        {.samples = 60U, .u_max = (double)INFINITY, .k = {(double)INFINITY, 48.0, 12.0}, .deadbeat = 0.0},
        {.samples = 60U, .u_max = (double)INFINITY, .k = {-(double)INFINITY, 48.0, 12.0}, .deadbeat = 0.0},
        {.samples = 60U, .u_max = (double)INFINITY, .k = {1.7976931348623157e308, 48.0, 12.0}, .deadbeat = 0.0},
        {.samples = 60U, .u_max = (double)INFINITY, .k = {-1.7976931348623157e308, 48.0, 12.0}, .deadbeat = 0.0},
        {.samples = 60U, .u_max = (double)INFINITY, .k = {64.0, (double)NAN, 12.0}, .deadbeat = 0.0},
        {.samples = 60U, .u_max = (double)INFINITY, .k = {64.0, (double)INFINITY, 12.0}, .deadbeat = 0.0},
        {.samples = 60U, .u_max = (double)INFINITY, .k = {64.0, -(double)INFINITY, 12.0}, .deadbeat = 0.0},
        {.samples = 60U, .u_max = (double)INFINITY, .k = {64.0, 1.7976931348623157e308, 12.0}, .deadbeat = 0.0},
        {.samples = 60U, .u_max = (double)INFINITY, .k = {64.0, -1.7976931348623157e308, 12.0}, .deadbeat = 0.0},
        {.samples = 60U, .u_max = (double)INFINITY, .k = {64.0, 48.0, (double)NAN}, .deadbeat = 0.0},
        {.samples = 60U, .u_max = (double)INFINITY, .k = {64.0, 48.0, (double)INFINITY}, .deadbeat = 0.0},
        {.samples = 60U, .u_max = (double)INFINITY, .k = {64.0, 48.0, -(double)INFINITY}, .deadbeat = 0.0},
        {.samples = 60U, .u_max = (double)INFINITY, .k = {64.0, 48.0, 1.7976931348623157e308}, .deadbeat = 0.0},
        {.samples = 60U, .u_max = (double)INFINITY, .k = {64.0, 48.0, -1.7976931348623157e308}, .deadbeat = 0.0},
        {.samples = 60U, .u_max = (double)INFINITY, .k = {64.0, 48.0, 12.0}, .deadbeat = (double)NAN},
        {.samples = 60U, .u_max = (double)INFINITY, .k = {64.0, 48.0, 12.0}, .deadbeat = (double)INFINITY},
        {.samples = 60U, .u_max = (double)INFINITY, .k = {64.0, 48.0, 12.0}, .deadbeat = -(double)INFINITY},
        {.samples = 60U, .u_max = (double)INFINITY, .k = {64.0, 48.0, 12.0}, .deadbeat = -1.0},
        {.samples = 60U, .u_max = (double)INFINITY, .k = {64.0, 48.0, 12.0}, .deadbeat = -1.7976931348623157e308},
    };
    const stage6_selftest_session *session = &stage6_selftest_sessions[0];
    uint32_t failures = 0U;
    stage6 self;

    if (stage6_init(&self, &session->params) != PTC_OK) {
        failures++;
    }
    for (uint32_t i = 0U; i < 27U; i++) {
        if (stage6_init(&self, &refused[i]) != PTC_E_PARAM) {
            failures++;
        }
    }
    if (stage6_init(&self, NULL) != PTC_E_PARAM) {
        failures++;
    }
    if (stage6_init(NULL, &session->params) != PTC_E_PARAM) {
        failures++;
    }
    failures += stage6_selftest_calls_of(&self, session);
    return failures;
}

/* Calls that lack a pointer: each is refused, and changes nothing. */
static uint32_t stage6_selftest_pointers(void)
{
    const stage6_selftest_session *session = &stage6_selftest_sessions[0];
    const stage6_selftest_call *call = &stage6_selftest_calls[0];
    uint32_t failures = 0U;
    double u = 12345.0;
    double xhat[2];
    stage6 self;

    if (stage6_init(&self, &session->params) != PTC_OK) {
        failures++;
    }
    if (stage6_arm(NULL, call->start) != PTC_E_INPUT) {
        failures++;
    }
    if (stage6_step(NULL, call->k, call->y, &u) != PTC_E_INPUT) {
        failures++;
    }
    failures += stage6_selftest_differs(u, 0.0);
    u = 12345.0;
    if (stage6_step(&self, call->k, NULL, &u) != PTC_E_INPUT) {
        failures++;
    }
    failures += stage6_selftest_differs(u, 0.0);
    if (stage6_step(&self, call->k, call->y, NULL) != PTC_E_INPUT) {
        failures++;
    }
    if (stage6_estimate(NULL, xhat) != PTC_E_INPUT) {
        failures++;
    }
    if (stage6_estimate(&self, NULL) != PTC_E_INPUT) {
        failures++;
    }
    failures += stage6_selftest_calls_of(&self, session);
    return failures;
}

uint32_t stage6_selftest(void)
{
    uint32_t failures = stage6_selftest_run();

    failures += stage6_selftest_refuse();
    failures += stage6_selftest_pointers();
    return failures;
}
