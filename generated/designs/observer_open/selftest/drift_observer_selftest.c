/* Self-test of the prescribed-time observer drift_observer: see drift_observer_selftest.h. DO NOT EDIT. */
#include "drift_observer_selftest.h"
#include "drift_observer.h"

#include <math.h>
#include <stddef.h>

/* A call, and what it must give. */
typedef struct drift_observer_selftest_call {
    uint32_t is_armed; /* arm is called before it */
    uint32_t start;
    uint32_t k;
    double y[2]; /* what is measured */
    double applied; /* the input of the tick before */
    ptc_status status;
    double xhat[2]; /* the estimates behind it */
    double d;
} drift_observer_selftest_call;

/* A set of parameters that init takes, and the calls with it, one after the other. */
typedef struct drift_observer_selftest_session {
    drift_observer_params params;
    uint32_t first; /* of its calls */
    uint32_t count;
} drift_observer_selftest_session;

static const drift_observer_selftest_session drift_observer_selftest_sessions[4] = {
    {.params = {.h = 0.015625}, .first = 0U, .count = 42U},
    {.params = {.h = 0.015625}, .first = 42U, .count = 5U},
    {.params = {.h = 0.015625}, .first = 47U, .count = 2U},
    {.params = {.h = 0.015625}, .first = 49U, .count = 2U},
};

static const drift_observer_selftest_call drift_observer_selftest_calls[51] = {
    {.is_armed = 0U, .start = 0U, .k = 0U, .y = {0.75, 0.25}, .applied = -0.1875, .status = PTC_OK, .xhat = {0.25, -0.0029296875}, .d = 0.0},
    {.is_armed = 0U, .start = 0U, .k = 1U, .y = {0.7252083333333332, 0.2417361111111111}, .applied = -0.1813020833333333, .status = PTC_OK, .xhat = {0.24787788343916795, -0.016413949826539126}, .d = -0.01637503417094024},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {0.7008333333333333, 0.2336111111111111}, .applied = -0.17520833333333333, .status = PTC_OK, .xhat = {0.2440369620240564, -0.038210993980219}, .d = -0.0458859648092873},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {(double)NAN, 0.5}, .applied = 0.5, .status = PTC_E_INPUT, .xhat = {0.2440369620240564, -0.038210993980219}, .d = -0.0458859648092873},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {0.5, (double)NAN}, .applied = 0.5, .status = PTC_E_INPUT, .xhat = {0.2440369620240564, -0.038210993980219}, .d = -0.0458859648092873},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {0.5, 0.5}, .applied = (double)NAN, .status = PTC_E_INPUT, .xhat = {0.2440369620240564, -0.038210993980219}, .d = -0.0458859648092873},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {(double)INFINITY, 0.5}, .applied = 0.5, .status = PTC_E_INPUT, .xhat = {0.2440369620240564, -0.038210993980219}, .d = -0.0458859648092873},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {0.5, (double)INFINITY}, .applied = 0.5, .status = PTC_E_INPUT, .xhat = {0.2440369620240564, -0.038210993980219}, .d = -0.0458859648092873},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {0.5, 0.5}, .applied = (double)INFINITY, .status = PTC_E_INPUT, .xhat = {0.2440369620240564, -0.038210993980219}, .d = -0.0458859648092873},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {-(double)INFINITY, 0.5}, .applied = 0.5, .status = PTC_E_INPUT, .xhat = {0.2440369620240564, -0.038210993980219}, .d = -0.0458859648092873},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {0.5, -(double)INFINITY}, .applied = 0.5, .status = PTC_E_INPUT, .xhat = {0.2440369620240564, -0.038210993980219}, .d = -0.0458859648092873},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {0.5, 0.5}, .applied = -(double)INFINITY, .status = PTC_E_INPUT, .xhat = {0.2440369620240564, -0.038210993980219}, .d = -0.0458859648092873},
    {.is_armed = 0U, .start = 0U, .k = 3U, .y = {0.676875, 0.225625}, .applied = -0.16921875, .status = PTC_OK, .xhat = {0.2388119094422121, -0.06632496137866903}, .d = -0.08556852791510013},
    {.is_armed = 0U, .start = 0U, .k = 30U, .y = {0.1875, 0.0625}, .applied = -0.046875, .status = PTC_OK, .xhat = {0.15810766310969365, -0.9311132651404023}, .d = -2.862587380305241},
    {.is_armed = 0U, .start = 0U, .k = 56U, .y = {0.003333333333333333, 0.0011111111111111111}, .applied = -0.0008333333333333333, .status = PTC_OK, .xhat = {0.0011111111111111183, -17.64881023827531}, .d = -1166.9501479226226},
    {.is_armed = 0U, .start = 0U, .k = 58U, .y = {0.0008333333333333333, 0.0002777777777777778}, .applied = -0.00020833333333333332, .status = PTC_OK, .xhat = {0.0002777777777777657, 11.321694908597891}, .d = 1864.1832027076973},
    {.is_armed = 0U, .start = 0U, .k = 59U, .y = {0.00020833333333333332, 6.944444444444444e-5}, .applied = -5.208333333333333e-5, .status = PTC_OK, .xhat = {6.94444444444553e-5, -3.3114834223456313}, .d = -634.5248040695278},
    {.is_armed = 0U, .start = 0U, .k = 60U, .y = {0.0, 0.0}, .applied = -0.0, .status = PTC_HOLD, .xhat = {0.0, -0.010370709454573301}, .d = -1.4223003472220626},
    {.is_armed = 0U, .start = 0U, .k = 61U, .y = {0.0, 0.0}, .applied = -0.0, .status = PTC_HOLD, .xhat = {0.0, 0.000740605107062392}, .d = -2.6041666312259792e-5},
    {.is_armed = 0U, .start = 0U, .k = 2147483647U, .y = {0.0, 0.0}, .applied = -0.0, .status = PTC_HOLD, .xhat = {0.0, -0.001481481481482205}, .d = -0.2844444444445834},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {0.0, 0.0}, .applied = -0.0, .status = PTC_HOLD, .xhat = {0.0, 0.0}, .d = 0.0},
    {.is_armed = 1U, .start = 4294967293U, .k = 4294967293U, .y = {0.75, 0.25}, .applied = -0.1875, .status = PTC_OK, .xhat = {0.061681059396983096, 0.3113614592852599}, .d = 0.474627923549376},
    {.is_armed = 0U, .start = 0U, .k = 4294967294U, .y = {0.7252083333333332, 0.2417361111111111}, .applied = -0.1813020833333333, .status = PTC_OK, .xhat = {0.11048192167268112, 0.5435896997156077}, .d = 0.8266745645482421},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {0.7008333333333333, 0.2336111111111111}, .applied = -0.17520833333333333, .status = PTC_OK, .xhat = {0.14822108545632307, 0.7077981299798104}, .d = 1.0714479525614464},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {(double)NAN, 0.5}, .applied = 0.5, .status = PTC_E_INPUT, .xhat = {0.14822108545632307, 0.7077981299798104}, .d = 1.0714479525614464},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {0.5, (double)NAN}, .applied = 0.5, .status = PTC_E_INPUT, .xhat = {0.14822108545632307, 0.7077981299798104}, .d = 1.0714479525614464},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {0.5, 0.5}, .applied = (double)NAN, .status = PTC_E_INPUT, .xhat = {0.14822108545632307, 0.7077981299798104}, .d = 1.0714479525614464},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {(double)INFINITY, 0.5}, .applied = 0.5, .status = PTC_E_INPUT, .xhat = {0.14822108545632307, 0.7077981299798104}, .d = 1.0714479525614464},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {0.5, (double)INFINITY}, .applied = 0.5, .status = PTC_E_INPUT, .xhat = {0.14822108545632307, 0.7077981299798104}, .d = 1.0714479525614464},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {0.5, 0.5}, .applied = (double)INFINITY, .status = PTC_E_INPUT, .xhat = {0.14822108545632307, 0.7077981299798104}, .d = 1.0714479525614464},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {-(double)INFINITY, 0.5}, .applied = 0.5, .status = PTC_E_INPUT, .xhat = {0.14822108545632307, 0.7077981299798104}, .d = 1.0714479525614464},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {0.5, -(double)INFINITY}, .applied = 0.5, .status = PTC_E_INPUT, .xhat = {0.14822108545632307, 0.7077981299798104}, .d = 1.0714479525614464},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {0.5, 0.5}, .applied = -(double)INFINITY, .status = PTC_E_INPUT, .xhat = {0.14822108545632307, 0.7077981299798104}, .d = 1.0714479525614464},
    {.is_armed = 0U, .start = 0U, .k = 0U, .y = {0.676875, 0.225625}, .applied = -0.16921875, .status = PTC_OK, .xhat = {0.17652487350583226, 0.8140918846760228}, .d = 1.2232069554727016},
    {.is_armed = 0U, .start = 0U, .k = 27U, .y = {0.1875, 0.0625}, .applied = -0.046875, .status = PTC_OK, .xhat = {0.13172053313248058, 0.20790328041668005}, .d = -0.7816177555518244},
    {.is_armed = 0U, .start = 0U, .k = 53U, .y = {0.003333333333333333, 0.0011111111111111111}, .applied = -0.0008333333333333333, .status = PTC_OK, .xhat = {0.0011111111111111183, -15.499151403641589}, .d = -1096.5721689737848},
    {.is_armed = 0U, .start = 0U, .k = 55U, .y = {0.0008333333333333333, 0.0002777777777777778}, .applied = -0.00020833333333333332, .status = PTC_OK, .xhat = {0.0002777777777777657, 9.725720225012743}, .d = 1611.796905652683},
    {.is_armed = 0U, .start = 0U, .k = 56U, .y = {0.00020833333333333332, 6.944444444444444e-5}, .applied = -5.208333333333333e-5, .status = PTC_OK, .xhat = {6.94444444444553e-5, -2.748557982831734}, .d = -526.4431196828618},
    {.is_armed = 0U, .start = 0U, .k = 57U, .y = {0.0, 0.0}, .applied = -0.0, .status = PTC_HOLD, .xhat = {0.0, -0.010370709454585736}, .d = -1.422300347224109},
    {.is_armed = 0U, .start = 0U, .k = 58U, .y = {0.0, 0.0}, .applied = -0.0, .status = PTC_HOLD, .xhat = {0.0, 0.0007406051070659447}, .d = -2.6041665630138766e-5},
    {.is_armed = 0U, .start = 0U, .k = 2147483644U, .y = {0.0, 0.0}, .applied = -0.0, .status = PTC_HOLD, .xhat = {0.0, -0.001481481481482205}, .d = -0.2844444444445834},
    {.is_armed = 0U, .start = 0U, .k = 4294967292U, .y = {0.0, 0.0}, .applied = -0.0, .status = PTC_HOLD, .xhat = {0.0, 0.0}, .d = 0.0},
    {.is_armed = 0U, .start = 0U, .k = 50U, .y = {-0.3814789307950591, -0.45168144407485183}, .applied = 0.25, .status = PTC_OK, .xhat = {-0.45168144407485183, 0.00390625}, .d = 0.0},
    {.is_armed = 0U, .start = 0U, .k = 51U, .y = {-0.45833058752302536, 0.7949141837927387}, .applied = 0.25, .status = PTC_OK, .xhat = {0.7949141837927387, 65.01069167731731}, .d = -1134.5957092768112},
    {.is_armed = 0U, .start = 0U, .k = 52U, .y = {-0.2937548085611472, -0.3184672302583091}, .applied = 0.25, .status = PTC_OK, .xhat = {-0.3184672302583089, -90.51884421058247}, .d = 1134.5957092768112},
    {.is_armed = 1U, .start = 0U, .k = 20U, .y = {1.6609504755056282e302, -1.6826022174671476e302}, .applied = 0.5, .status = PTC_OK, .xhat = {-5.980887737654042e301, -4.71072159788563e302}, .d = -1.1010209516148745e303},
    {.is_armed = 1U, .start = 4294967290U, .k = 40U, .y = {-1.6289170468515274e302, -5.023417769909703e301}, .applied = 1.797693134862316e302, .status = PTC_OK, .xhat = {-5.023417769909703e301, 2.8088955232223685e300}, .d = 0.0},
    {.is_armed = 0U, .start = 0U, .k = 44U, .y = {7.534286791159686e307, 8.098610135816677e307}, .applied = 0.5, .status = PTC_OK, .xhat = {8.098610135816677e307, 0.0078125}, .d = 0.0},
    {.is_armed = 0U, .start = 0U, .k = 48U, .y = {5.50470895039603e307, 5.65825786190865e307}, .applied = 0.0, .status = PTC_E_RANGE, .xhat = {8.098610135816677e307, 0.0078125}, .d = 0.0},
    {.is_armed = 1U, .start = 4294967290U, .k = 51U, .y = {5.139832755204136e307, -6.933478737733689e307}, .applied = 1.7976931348623157e308, .status = PTC_OK, .xhat = {-6.933478737733689e307, 2.8088955232223683e306}, .d = 0.0},
    {.is_armed = 0U, .start = 0U, .k = 47U, .y = {1.6721813411739885e308, 1.7957743733220194e308}, .applied = 1.7976931348623157e308, .status = PTC_E_RANGE, .xhat = {-6.933478737733689e307, 2.8088955232223683e306}, .d = 0.0},
};

/* 1 where a number is not the one that must come. */
static uint32_t drift_observer_selftest_differs(double value, double wanted)
{
    uint32_t failures = 1U;

    if (fabs(value - wanted) <= 0.0) {
        failures = 0U;
    }
    return failures;
}

/* The failures of one call. */
static uint32_t drift_observer_selftest_check(drift_observer *self, const drift_observer_selftest_call *call)
{
    uint32_t failures = 0U;
    double xhat[2] = {12345.0, 12345.0};
    double d = 12345.0;

    if (call->is_armed != 0U) {
        if (drift_observer_arm(self, call->start) != PTC_OK) {
            failures++;
        }
    }
    if (drift_observer_update(self, call->k, call->y, call->applied) != call->status) {
        failures++;
    }
    if (drift_observer_estimate(self, xhat) != PTC_OK) {
        failures++;
    }
    for (uint32_t i = 0U; i < 2U; i++) {
        failures += drift_observer_selftest_differs(xhat[i], call->xhat[i]);
    }
    if (drift_observer_disturbance(self, &d) != PTC_OK) {
        failures++;
    }
    failures += drift_observer_selftest_differs(d, call->d);
    return failures;
}

/* The calls of a session, of which init has been called. */
static uint32_t drift_observer_selftest_calls_of(drift_observer *self, const drift_observer_selftest_session *session)
{
    uint32_t failures = 0U;

    for (uint32_t j = 0U; j < session->count; j++) {
        failures += drift_observer_selftest_check(self, &drift_observer_selftest_calls[session->first + j]);
    }
    return failures;
}

/* Every session with its calls. */
static uint32_t drift_observer_selftest_run(void)
{
    uint32_t failures = 0U;

    for (uint32_t i = 0U; i < 4U; i++) {
        const drift_observer_selftest_session *session = &drift_observer_selftest_sessions[i];
        drift_observer self;

        if (drift_observer_init(&self, &session->params) == PTC_OK) {
            failures += drift_observer_selftest_calls_of(&self, session);
        } else {
            failures++;
        }
    }
    return failures;
}

/* What init must refuse without a change. */
static uint32_t drift_observer_selftest_refuse(void)
{
    static const drift_observer_params refused[14] = {
        {.h = (double)NAN},
        {.h = (double)INFINITY},
        {.h = -(double)INFINITY},
        {.h = 0.0},
        {.h = -1.0},
        {.h = 1.7976931348623157e308},
        {.h = -1.7976931348623157e308},
        {.h = 5e-324},
        {.h = 7.5e-151},
        {.h = 1e-150},
        {.h = 1e150},
        {.h = 1.25e150},
        {.h = 1.6614458870061815e92},
        {.h = 2.3543556066408686e-70},
    };
    const drift_observer_selftest_session *session = &drift_observer_selftest_sessions[0];
    uint32_t failures = 0U;
    drift_observer self;

    if (drift_observer_init(&self, &session->params) != PTC_OK) {
        failures++;
    }
    for (uint32_t i = 0U; i < 14U; i++) {
        if (drift_observer_init(&self, &refused[i]) != PTC_E_PARAM) {
            failures++;
        }
    }
    if (drift_observer_init(&self, NULL) != PTC_E_PARAM) {
        failures++;
    }
    if (drift_observer_init(NULL, &session->params) != PTC_E_PARAM) {
        failures++;
    }
    failures += drift_observer_selftest_calls_of(&self, session);
    return failures;
}

/* Calls that lack a pointer: each is refused, and changes nothing. */
static uint32_t drift_observer_selftest_pointers(void)
{
    const drift_observer_selftest_session *session = &drift_observer_selftest_sessions[0];
    const drift_observer_selftest_call *call = &drift_observer_selftest_calls[0];
    uint32_t failures = 0U;
    double xhat[2];
    double d;
    drift_observer self;

    if (drift_observer_init(&self, &session->params) != PTC_OK) {
        failures++;
    }
    if (drift_observer_arm(NULL, call->start) != PTC_E_INPUT) {
        failures++;
    }
    if (drift_observer_update(NULL, call->k, call->y, call->applied) != PTC_E_INPUT) {
        failures++;
    }
    if (drift_observer_update(&self, call->k, NULL, call->applied) != PTC_E_INPUT) {
        failures++;
    }
    if (drift_observer_estimate(NULL, xhat) != PTC_E_INPUT) {
        failures++;
    }
    if (drift_observer_estimate(&self, NULL) != PTC_E_INPUT) {
        failures++;
    }
    if (drift_observer_disturbance(NULL, &d) != PTC_E_INPUT) {
        failures++;
    }
    if (drift_observer_disturbance(&self, NULL) != PTC_E_INPUT) {
        failures++;
    }
    failures += drift_observer_selftest_calls_of(&self, session);
    return failures;
}

uint32_t drift_observer_selftest(void)
{
    uint32_t failures = drift_observer_selftest_run();

    failures += drift_observer_selftest_refuse();
    failures += drift_observer_selftest_pointers();
    return failures;
}
