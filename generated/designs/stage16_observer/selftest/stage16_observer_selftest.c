/* Self-test of the prescribed-time observer stage16_observer: see stage16_observer_selftest.h. DO NOT EDIT. */
#include "stage16_observer_selftest.h"
#include "stage16_observer.h"

#include <math.h>
#include <stddef.h>

/* A call, and what it must give. */
typedef struct stage16_observer_selftest_call {
    uint32_t is_armed; /* arm is called before it */
    uint32_t start;
    uint32_t k;
    double y[2]; /* what is measured */
    double applied; /* the input of the tick before */
    ptc_status status;
    double xhat[3]; /* the estimates behind it */
    double d;
} stage16_observer_selftest_call;

/* A set of parameters that init takes, and the calls with it, one after the other. */
typedef struct stage16_observer_selftest_session {
    stage16_observer_params params;
    uint32_t first; /* of its calls */
    uint32_t count;
} stage16_observer_selftest_session;

static const stage16_observer_selftest_session stage16_observer_selftest_sessions[4] = {
    {.params = {.none = (char)0}, .first = 0U, .count = 42U},
    {.params = {.none = (char)0}, .first = 42U, .count = 3U},
    {.params = {.none = (char)0}, .first = 45U, .count = 2U},
    {.params = {.none = (char)0}, .first = 47U, .count = 2U},
};

static const stage16_observer_selftest_call stage16_observer_selftest_calls[49] = {
    {.is_armed = 0U, .start = 0U, .k = 0U, .y = {0.75, 0.25}, .applied = -0.1875, .status = PTC_OK, .xhat = {0.75, 0.0, 0.25}, .d = 0.0},
    {.is_armed = 0U, .start = 0U, .k = 1U, .y = {0.676875, 0.225625}, .applied = -0.16921875, .status = PTC_OK, .xhat = {0.7501344261711317, 0.22285046353529728, 0.06506653678467897}, .d = 0.0},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {0.6075, 0.2025}, .applied = -0.151875, .status = PTC_OK, .xhat = {0.719800495020264, -2.055852972646272, -0.004836718229721579}, .d = -0.039636670924004025},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {(double)NAN, 0.5}, .applied = 0.5, .status = PTC_E_INPUT, .xhat = {0.719800495020264, -2.055852972646272, -0.004836718229721579}, .d = -0.039636670924004025},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {0.5, (double)NAN}, .applied = 0.5, .status = PTC_E_INPUT, .xhat = {0.719800495020264, -2.055852972646272, -0.004836718229721579}, .d = -0.039636670924004025},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {0.5, 0.5}, .applied = (double)NAN, .status = PTC_E_INPUT, .xhat = {0.719800495020264, -2.055852972646272, -0.004836718229721579}, .d = -0.039636670924004025},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {(double)INFINITY, 0.5}, .applied = 0.5, .status = PTC_E_INPUT, .xhat = {0.719800495020264, -2.055852972646272, -0.004836718229721579}, .d = -0.039636670924004025},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {0.5, (double)INFINITY}, .applied = 0.5, .status = PTC_E_INPUT, .xhat = {0.719800495020264, -2.055852972646272, -0.004836718229721579}, .d = -0.039636670924004025},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {0.5, 0.5}, .applied = (double)INFINITY, .status = PTC_E_INPUT, .xhat = {0.719800495020264, -2.055852972646272, -0.004836718229721579}, .d = -0.039636670924004025},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {-(double)INFINITY, 0.5}, .applied = 0.5, .status = PTC_E_INPUT, .xhat = {0.719800495020264, -2.055852972646272, -0.004836718229721579}, .d = -0.039636670924004025},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {0.5, -(double)INFINITY}, .applied = 0.5, .status = PTC_E_INPUT, .xhat = {0.719800495020264, -2.055852972646272, -0.004836718229721579}, .d = -0.039636670924004025},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {0.5, 0.5}, .applied = -(double)INFINITY, .status = PTC_E_INPUT, .xhat = {0.719800495020264, -2.055852972646272, -0.004836718229721579}, .d = -0.039636670924004025},
    {.is_armed = 0U, .start = 0U, .k = 3U, .y = {0.5418749999999999, 0.18062499999999998}, .applied = -0.13546874999999997, .status = PTC_OK, .xhat = {0.6681718440766353, -6.1414449008701375, -0.010715532658140473}, .d = -0.11766275211562618},
    {.is_armed = 0U, .start = 0U, .k = 10U, .y = {0.1875, 0.0625}, .applied = -0.046875, .status = PTC_OK, .xhat = {0.602923016040534, -11.39699456921053, 0.013168703930955039}, .d = -0.22866083278820584},
    {.is_armed = 0U, .start = 0U, .k = 16U, .y = {0.030000000000000006, 0.010000000000000002}, .applied = -0.0075000000000000015, .status = PTC_OK, .xhat = {0.259484293521835, -66.4959706914156, 0.06572384265711104}, .d = -1.8465559712817277},
    {.is_armed = 0U, .start = 0U, .k = 18U, .y = {0.0075000000000000015, 0.0025000000000000005}, .applied = -0.0018750000000000004, .status = PTC_OK, .xhat = {-0.26587357115040594, -295.7965496064178, 0.0014592187844730022}, .d = -8.87918997370716},
    {.is_armed = 0U, .start = 0U, .k = 19U, .y = {0.0018750000000000004, 0.0006250000000000001}, .applied = -0.0004687500000000001, .status = PTC_OK, .xhat = {-0.014984000120151603, -22.477661236881133, 0.000322155295168131}, .d = -0.6754176692704326},
    {.is_armed = 0U, .start = 0U, .k = 20U, .y = {0.0, 0.0}, .applied = -0.0, .status = PTC_HOLD, .xhat = {-0.003746000030038024, -5.619415309220382, 8.053882379209233e-5}, .d = -0.1688544173176111},
    {.is_armed = 0U, .start = 0U, .k = 21U, .y = {0.0, 0.0}, .applied = -0.0, .status = PTC_HOLD, .xhat = {-0.008719781772483996, -5.587891415563903, -3.366361148956498e-5}, .d = -0.16798317039554023},
    {.is_armed = 0U, .start = 0U, .k = 2147483647U, .y = {0.0, 0.0}, .applied = -0.0, .status = PTC_HOLD, .xhat = {-0.012806451138288407, -5.518120444537453, -0.00012495096036476547}, .d = -0.1659487862669661},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {0.0, 0.0}, .applied = -0.0, .status = PTC_HOLD, .xhat = {-0.01612037464133207, -5.4169455696348, -0.000196866183664816}, .d = -0.1629587923412359},
    {.is_armed = 1U, .start = 4294967293U, .k = 4294967293U, .y = {0.75, 0.25}, .applied = -0.1875, .status = PTC_OK, .xhat = {-0.01876308608742649, -5.290326758404026, -0.0002524610364005174}, .d = -0.15919394473907195},
    {.is_armed = 0U, .start = 0U, .k = 4294967294U, .y = {0.676875, 0.225625}, .applied = -0.16921875, .status = PTC_OK, .xhat = {0.28340978518502175, 19.183866063804167, -0.03322843651053019}, .d = 0.6216609727991373},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {0.6075, 0.2025}, .applied = -0.151875, .status = PTC_OK, .xhat = {0.46840143204478085, 33.24431610127478, -0.0194878714004686}, .d = 1.0962445845692126},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {(double)NAN, 0.5}, .applied = 0.5, .status = PTC_E_INPUT, .xhat = {0.46840143204478085, 33.24431610127478, -0.0194878714004686}, .d = 1.0962445845692126},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {0.5, (double)NAN}, .applied = 0.5, .status = PTC_E_INPUT, .xhat = {0.46840143204478085, 33.24431610127478, -0.0194878714004686}, .d = 1.0962445845692126},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {0.5, 0.5}, .applied = (double)NAN, .status = PTC_E_INPUT, .xhat = {0.46840143204478085, 33.24431610127478, -0.0194878714004686}, .d = 1.0962445845692126},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {(double)INFINITY, 0.5}, .applied = 0.5, .status = PTC_E_INPUT, .xhat = {0.46840143204478085, 33.24431610127478, -0.0194878714004686}, .d = 1.0962445845692126},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {0.5, (double)INFINITY}, .applied = 0.5, .status = PTC_E_INPUT, .xhat = {0.46840143204478085, 33.24431610127478, -0.0194878714004686}, .d = 1.0962445845692126},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {0.5, 0.5}, .applied = (double)INFINITY, .status = PTC_E_INPUT, .xhat = {0.46840143204478085, 33.24431610127478, -0.0194878714004686}, .d = 1.0962445845692126},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {-(double)INFINITY, 0.5}, .applied = 0.5, .status = PTC_E_INPUT, .xhat = {0.46840143204478085, 33.24431610127478, -0.0194878714004686}, .d = 1.0962445845692126},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {0.5, -(double)INFINITY}, .applied = 0.5, .status = PTC_E_INPUT, .xhat = {0.46840143204478085, 33.24431610127478, -0.0194878714004686}, .d = 1.0962445845692126},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {0.5, 0.5}, .applied = -(double)INFINITY, .status = PTC_E_INPUT, .xhat = {0.46840143204478085, 33.24431610127478, -0.0194878714004686}, .d = 1.0962445845692126},
    {.is_armed = 0U, .start = 0U, .k = 0U, .y = {0.5418749999999999, 0.18062499999999998}, .applied = -0.13546874999999997, .status = PTC_OK, .xhat = {0.5636919408723254, 38.9789757016245, 0.01458590005587123}, .d = 1.3177968522717733},
    {.is_armed = 0U, .start = 0U, .k = 7U, .y = {0.1875, 0.0625}, .applied = -0.046875, .status = PTC_OK, .xhat = {0.5926551557853735, 38.298969370225, 0.052231839791371026}, .d = 1.3376519920342353},
    {.is_armed = 0U, .start = 0U, .k = 13U, .y = {0.030000000000000006, 0.010000000000000002}, .applied = -0.0075000000000000015, .status = PTC_OK, .xhat = {0.3070851586416438, -15.47075113185989, 0.08674215429198345}, .d = -0.27382068365651524},
    {.is_armed = 0U, .start = 0U, .k = 15U, .y = {0.0075000000000000015, 0.0025000000000000005}, .applied = -0.0018750000000000004, .status = PTC_OK, .xhat = {-0.2624509510653524, -292.37758529200613, -0.0037491993302491665}, .d = -8.790373110648934},
    {.is_armed = 0U, .start = 0U, .k = 16U, .y = {0.0018750000000000004, 0.0006250000000000001}, .applied = -0.0004687500000000001, .status = PTC_OK, .xhat = {-0.014984000120151887, -22.47766123688115, 0.00032215529516781225}, .d = -0.6754176692704352},
    {.is_armed = 0U, .start = 0U, .k = 17U, .y = {0.0, 0.0}, .applied = -0.0, .status = PTC_HOLD, .xhat = {-0.00374600003003776, -5.6194153092201145, 8.053882379163859e-5}, .d = -0.16885441731760437},
    {.is_armed = 0U, .start = 0U, .k = 18U, .y = {0.0, 0.0}, .applied = -0.0, .status = PTC_HOLD, .xhat = {-0.008719781772483509, -5.58789141556364, -3.366361149041989e-5}, .d = -0.1679831703955335},
    {.is_armed = 0U, .start = 0U, .k = 2147483644U, .y = {0.0, 0.0}, .applied = -0.0, .status = PTC_HOLD, .xhat = {-0.012806451138287742, -5.5181204445371925, -0.0001249509603658785}, .d = -0.1659487862669595},
    {.is_armed = 0U, .start = 0U, .k = 4294967292U, .y = {0.0, 0.0}, .applied = -0.0, .status = PTC_HOLD, .xhat = {-0.01612037464133126, -5.416945569634544, -0.00019686618366616363}, .d = -0.16295879234122942},
    {.is_armed = 0U, .start = 0U, .k = 12U, .y = {0.9345176227593099, -0.34868870628381476}, .applied = 0.25, .status = PTC_OK, .xhat = {0.9345176227593099, 0.0, -0.34868870628381476}, .d = 0.0},
    {.is_armed = 1U, .start = 4294967290U, .k = 4294967291U, .y = {-1.307336388687966e302, 6.987964186393432e301}, .applied = 0.0, .status = PTC_OK, .xhat = {0.9343288855425633, -0.3143851300136227, -0.09506584858381648}, .d = 0.0},
    {.is_armed = 1U, .start = 4294967290U, .k = 4294967292U, .y = {-1.2079432732140247e302, 1.4474159757076022e302}, .applied = 1.797693134862316e302, .status = PTC_OK, .xhat = {-1.2079432732140247e302, 0.0, 1.4474159757076022e302}, .d = 0.0},
    {.is_armed = 0U, .start = 0U, .k = 16U, .y = {4.532244146086889e307, -1.4232089975984815e308}, .applied = 1.7976931348623157e308, .status = PTC_OK, .xhat = {4.532244146086889e307, 0.0, -1.4232089975984815e308}, .d = 0.0},
    {.is_armed = 0U, .start = 0U, .k = 0U, .y = {1.0398779474332157e308, -5.339298256842942e307}, .applied = 0.5, .status = PTC_E_RANGE, .xhat = {4.532244146086889e307, 0.0, -1.4232089975984815e308}, .d = 0.0},
    {.is_armed = 1U, .start = 4294967290U, .k = 4294967294U, .y = {1.7042583729633567e308, -1.0131148354307286e308}, .applied = 0.5, .status = PTC_OK, .xhat = {1.7042583729633567e308, 0.0, -1.0131148354307286e308}, .d = 0.0},
    {.is_armed = 0U, .start = 0U, .k = 7U, .y = {8.034846972429222e307, 9.633521266728811e307}, .applied = 0.0, .status = PTC_E_RANGE, .xhat = {1.7042583729633567e308, 0.0, -1.0131148354307286e308}, .d = 0.0},
};

/* 1 where a number is not the one that must come. */
static uint32_t stage16_observer_selftest_differs(double value, double wanted)
{
    uint32_t failures = 1U;

    if (fabs(value - wanted) <= 0.0) {
        failures = 0U;
    }
    return failures;
}

/* The failures of one call. */
static uint32_t stage16_observer_selftest_check(stage16_observer *self, const stage16_observer_selftest_call *call)
{
    uint32_t failures = 0U;
    double xhat[3] = {12345.0, 12345.0, 12345.0};
    double d = 12345.0;

    if (call->is_armed != 0U) {
        if (stage16_observer_arm(self, call->start) != PTC_OK) {
            failures++;
        }
    }
    if (stage16_observer_update(self, call->k, call->y, call->applied) != call->status) {
        failures++;
    }
    if (stage16_observer_estimate(self, xhat) != PTC_OK) {
        failures++;
    }
    for (uint32_t i = 0U; i < 3U; i++) {
        failures += stage16_observer_selftest_differs(xhat[i], call->xhat[i]);
    }
    if (stage16_observer_disturbance(self, &d) != PTC_OK) {
        failures++;
    }
    failures += stage16_observer_selftest_differs(d, call->d);
    return failures;
}

/* The calls of a session, of which init has been called. */
static uint32_t stage16_observer_selftest_calls_of(stage16_observer *self, const stage16_observer_selftest_session *session)
{
    uint32_t failures = 0U;

    for (uint32_t j = 0U; j < session->count; j++) {
        failures += stage16_observer_selftest_check(self, &stage16_observer_selftest_calls[session->first + j]);
    }
    return failures;
}

/* Every session with its calls. */
static uint32_t stage16_observer_selftest_run(void)
{
    uint32_t failures = 0U;

    for (uint32_t i = 0U; i < 4U; i++) {
        const stage16_observer_selftest_session *session = &stage16_observer_selftest_sessions[i];
        stage16_observer self;

        if (stage16_observer_init(&self, &session->params) == PTC_OK) {
            failures += stage16_observer_selftest_calls_of(&self, session);
        } else {
            failures++;
        }
    }
    return failures;
}

/* What init must refuse without a change. */
static uint32_t stage16_observer_selftest_refuse(void)
{
    const stage16_observer_selftest_session *session = &stage16_observer_selftest_sessions[0];
    uint32_t failures = 0U;
    stage16_observer self;

    if (stage16_observer_init(&self, &session->params) != PTC_OK) {
        failures++;
    }
    if (stage16_observer_init(NULL, &session->params) != PTC_E_PARAM) {
        failures++;
    }
    failures += stage16_observer_selftest_calls_of(&self, session);
    return failures;
}

/* Calls that lack a pointer: each is refused, and changes nothing. */
static uint32_t stage16_observer_selftest_pointers(void)
{
    const stage16_observer_selftest_session *session = &stage16_observer_selftest_sessions[0];
    const stage16_observer_selftest_call *call = &stage16_observer_selftest_calls[0];
    uint32_t failures = 0U;
    double xhat[3];
    double d;
    stage16_observer self;

    if (stage16_observer_init(&self, &session->params) != PTC_OK) {
        failures++;
    }
    if (stage16_observer_arm(NULL, call->start) != PTC_E_INPUT) {
        failures++;
    }
    if (stage16_observer_update(NULL, call->k, call->y, call->applied) != PTC_E_INPUT) {
        failures++;
    }
    if (stage16_observer_update(&self, call->k, NULL, call->applied) != PTC_E_INPUT) {
        failures++;
    }
    if (stage16_observer_estimate(NULL, xhat) != PTC_E_INPUT) {
        failures++;
    }
    if (stage16_observer_estimate(&self, NULL) != PTC_E_INPUT) {
        failures++;
    }
    if (stage16_observer_disturbance(NULL, &d) != PTC_E_INPUT) {
        failures++;
    }
    if (stage16_observer_disturbance(&self, NULL) != PTC_E_INPUT) {
        failures++;
    }
    failures += stage16_observer_selftest_calls_of(&self, session);
    return failures;
}

uint32_t stage16_observer_selftest(void)
{
    uint32_t failures = stage16_observer_selftest_run();

    failures += stage16_observer_selftest_refuse();
    failures += stage16_observer_selftest_pointers();
    return failures;
}
