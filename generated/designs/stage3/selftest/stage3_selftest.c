/* Self-test of the prescribed-time controller stage3: see stage3_selftest.h. DO NOT EDIT. */
#include "stage3_selftest.h"
#include "stage3.h"

#include <math.h>
#include <stddef.h>

/* A call, and what it must give. */
typedef struct stage3_selftest_call {
    uint32_t is_armed; /* arm is called before it */
    uint32_t start;
    uint32_t k;
    double y[1]; /* what is measured */
    ptc_status status;
    double u;
    double xhat[2]; /* the estimates behind it */
    double d;
} stage3_selftest_call;

/* A set of parameters that init takes, and the calls with it, one after the other. */
typedef struct stage3_selftest_session {
    stage3_params params;
    uint32_t first; /* of its calls */
    uint32_t count;
} stage3_selftest_session;

static const stage3_selftest_session stage3_selftest_sessions[4] = {
    {.params = {.u_max = (double)INFINITY}, .first = 0U, .count = 42U},
    {.params = {.u_max = (double)INFINITY}, .first = 42U, .count = 3U},
    {.params = {.u_max = (double)INFINITY}, .first = 45U, .count = 2U},
    {.params = {.u_max = 1.0}, .first = 47U, .count = 2U},
};

static const stage3_selftest_call stage3_selftest_calls[49] = {
    {.is_armed = 0U, .start = 0U, .k = 0U, .y = {0.75}, .status = PTC_OK, .u = -1518.2186234817814, .xhat = {0.75, 0.0}, .d = 0.0},
    {.is_armed = 0U, .start = 0U, .k = 1U, .y = {0.7129687499999999}, .status = PTC_OK, .u = -2422.03022327676, .xhat = {0.7303570046439628, -3.6687306501548056}, .d = -152.86377708978358},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {0.676875}, .status = PTC_OK, .u = -2669.0996113403235, .xhat = {0.6987229102167183, -10.741768873541323}, .d = -392.950702548226},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {(double)NAN}, .status = PTC_E_INPUT, .u = 0.0, .xhat = {0.6987229102167183, -10.741768873541323}, .d = -392.950702548226},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {(double)INFINITY}, .status = PTC_E_INPUT, .u = 0.0, .xhat = {0.6987229102167183, -10.741768873541323}, .d = -392.950702548226},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {-(double)INFINITY}, .status = PTC_E_INPUT, .u = 0.0, .xhat = {0.6987229102167183, -10.741768873541323}, .d = -392.950702548226},
    {.is_armed = 0U, .start = 0U, .k = 3U, .y = {0.6417187500000001}, .status = PTC_OK, .u = -2344.3023653594696, .xhat = {0.6605841936055231, -19.097649319869564}, .d = -656.8030606674287},
    {.is_armed = 0U, .start = 0U, .k = 10U, .y = {0.421875}, .status = PTC_OK, .u = 6848.6924091647115, .xhat = {0.45819976549160824, -98.7055595242547}, .d = -7921.756158989082},
    {.is_armed = 0U, .start = 0U, .k = 16U, .y = {0.27}, .status = PTC_OK, .u = 77544.08745698568, .xhat = {0.27, -235.51338310637217}, .d = -92282.93286416837},
    {.is_armed = 0U, .start = 0U, .k = 18U, .y = {0.22687500000000005}, .status = PTC_OK, .u = -61946.51288492617, .xhat = {0.22687500000000005, 31.71063143943519}, .d = 142822.57046970568},
    {.is_armed = 0U, .start = 0U, .k = 19U, .y = {0.20671875}, .status = PTC_OK, .u = -15140.859791144081, .xhat = {0.20671875, 9.001973761955128}, .d = -19227.63993307526},
    {.is_armed = 0U, .start = 0U, .k = 20U, .y = {0.1875}, .status = PTC_OK, .u = 5174.872923674253, .xhat = {0.1875, -53.62265008547797}, .d = -6861.287286029708},
    {.is_armed = 0U, .start = 0U, .k = 21U, .y = {0.16921875}, .status = PTC_OK, .u = -28704.51193105169, .xhat = {0.16921875, -6.111086726554461}, .d = 39481.18633803516},
    {.is_armed = 0U, .start = 0U, .k = 30U, .y = {0.046875}, .status = PTC_OK, .u = 282131.065930895, .xhat = {0.046875, -169.2960668212954}, .d = -99079.50656626507},
    {.is_armed = 0U, .start = 0U, .k = 36U, .y = {0.0075000000000000015}, .status = PTC_OK, .u = -840061.6623386522, .xhat = {0.007500000000000007, -6.360471213681535}, .d = 94733.56950368869},
    {.is_armed = 0U, .start = 0U, .k = 38U, .y = {0.0018750000000000004}, .status = PTC_OK, .u = 1734740.9195133527, .xhat = {0.0018749999999999878, 88.95889446548665}, .d = -92963.27699992163},
    {.is_armed = 0U, .start = 0U, .k = 39U, .y = {0.0004687500000000001}, .status = PTC_OK, .u = -3619890.090969874, .xhat = {0.00046875000000001776, -279.84505706738685}, .d = 283184.04820387857},
    {.is_armed = 0U, .start = 0U, .k = 40U, .y = {0.0}, .status = PTC_HOLD, .u = 6969734.954044295, .xhat = {0.0, 643.7006454630016}, .d = -446402.12858735013},
    {.is_armed = 0U, .start = 0U, .k = 41U, .y = {0.0}, .status = PTC_HOLD, .u = -13422541.47122135, .xhat = {0.0, -1338.4233776208075}, .d = 943043.3357282601},
    {.is_armed = 0U, .start = 0U, .k = 2147483647U, .y = {0.0}, .status = PTC_HOLD, .u = 25251334.58392047, .xhat = {0.0, 2647.4062612535427}, .d = -1674922.4315372095},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {0.0}, .status = PTC_HOLD, .u = -47436706.1778155, .xhat = {0.0, -5098.069106316411}, .d = 3226403.258588528},
    {.is_armed = 1U, .start = 4294967293U, .k = 4294967293U, .y = {0.75}, .status = PTC_OK, .u = -34369369.10279271, .xhat = {4.871796400320464, 22628.912963277075}, .d = 3196961.855729096},
    {.is_armed = 0U, .start = 0U, .k = 4294967294U, .y = {0.7129687499999999}, .status = PTC_OK, .u = -23341698.750701886, .xhat = {2.904795525967206, -22073.28272252988}, .d = 3177693.048907406},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {0.676875}, .status = PTC_OK, .u = -14477660.572362311, .xhat = {-15.132680001661686, -49356.00286941091}, .d = 3351424.4225520403},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {(double)NAN}, .status = PTC_E_INPUT, .u = 0.0, .xhat = {-15.132680001661686, -49356.00286941091}, .d = 3351424.4225520403},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {(double)INFINITY}, .status = PTC_E_INPUT, .u = 0.0, .xhat = {-15.132680001661686, -49356.00286941091}, .d = 3351424.4225520403},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {-(double)INFINITY}, .status = PTC_E_INPUT, .u = 0.0, .xhat = {-15.132680001661686, -49356.00286941091}, .d = 3351424.4225520403},
    {.is_armed = 0U, .start = 0U, .k = 0U, .y = {0.6417187500000001}, .status = PTC_OK, .u = -7951802.324054183, .xhat = {-30.95519903316498, -60066.06358292489}, .d = 3793339.35658232},
    {.is_armed = 0U, .start = 0U, .k = 7U, .y = {0.421875}, .status = PTC_OK, .u = -4840900.292269142, .xhat = {-15.70900803732998, -36875.53042031192}, .d = 7019515.964048315},
    {.is_armed = 0U, .start = 0U, .k = 13U, .y = {0.27}, .status = PTC_OK, .u = -39908321.99934349, .xhat = {0.2700000000000031, 42173.205676149475}, .d = 60340197.60169315},
    {.is_armed = 0U, .start = 0U, .k = 15U, .y = {0.22687500000000005}, .status = PTC_OK, .u = -9198560.825709809, .xhat = {0.22687500000000682, -7276.466010718752}, .d = -9625781.72916834},
    {.is_armed = 0U, .start = 0U, .k = 16U, .y = {0.20671875}, .status = PTC_OK, .u = -16218263.78324917, .xhat = {0.20671875000000028, -8775.52730176859}, .d = 22397579.89580632},
    {.is_armed = 0U, .start = 0U, .k = 17U, .y = {0.1875}, .status = PTC_OK, .u = -23055411.725353107, .xhat = {0.1875, 7658.690293408425}, .d = 24554378.912526656},
    {.is_armed = 0U, .start = 0U, .k = 18U, .y = {0.16921875}, .status = PTC_OK, .u = -15426500.619092193, .xhat = {0.16921875000000064, -1772.7382393848402}, .d = 12709349.804479487},
    {.is_armed = 0U, .start = 0U, .k = 27U, .y = {0.046875}, .status = PTC_OK, .u = -20180978.58276112, .xhat = {0.046875, -1883.661985525987}, .d = 19532775.25430114},
    {.is_armed = 0U, .start = 0U, .k = 33U, .y = {0.0075000000000000015}, .status = PTC_OK, .u = -22390660.480058797, .xhat = {0.007500000000000007, 1909.3371515652327}, .d = 19323924.92222265},
    {.is_armed = 0U, .start = 0U, .k = 35U, .y = {0.0018750000000000004}, .status = PTC_OK, .u = -5789599.115369288, .xhat = {0.001875000000000071, -1177.3694909172305}, .d = 17837489.600926653},
    {.is_armed = 0U, .start = 0U, .k = 36U, .y = {0.0004687500000000001}, .status = PTC_OK, .u = -50912091.99018024, .xhat = {0.00046875000000001776, -551.71734932442}, .d = 21290038.281409957},
    {.is_armed = 0U, .start = 0U, .k = 37U, .y = {0.0}, .status = PTC_HOLD, .u = 49175318.73428741, .xhat = {0.0, 4150.26534117238}, .d = 14091067.297714043},
    {.is_armed = 0U, .start = 0U, .k = 38U, .y = {0.0}, .status = PTC_HOLD, .u = -155203608.26764223, .xhat = {0.0, -11280.388843702745}, .d = 28351314.302774757},
    {.is_armed = 0U, .start = 0U, .k = 2147483644U, .y = {0.0}, .status = PTC_HOLD, .u = 245247424.94865295, .xhat = {0.0, 25021.852681116914}, .d = 868386.6279464178},
    {.is_armed = 0U, .start = 0U, .k = 4294967292U, .y = {0.0}, .status = PTC_HOLD, .u = -521800454.821132, .xhat = {0.0, -51094.73175048243}, .d = 53014144.766677395},
    {.is_armed = 0U, .start = 0U, .k = 12U, .y = {-0.6436469406731915}, .status = PTC_OK, .u = 3929.468502278336, .xhat = {-0.6436469406731915, 0.0}, .d = 0.0},
    {.is_armed = 0U, .start = 0U, .k = 13U, .y = {0.2610565074889896}, .status = PTC_OK, .u = 55402.15108189016, .xhat = {0.2610565074889897, 775.4600984247267}, .d = -258486.69947490894},
    {.is_armed = 0U, .start = 0U, .k = 40U, .y = {1.4463899282428682e302}, .status = PTC_E_RANGE, .u = 0.0, .xhat = {0.2610565074889897, 775.4600984247267}, .d = -258486.69947490894},
    {.is_armed = 1U, .start = 4294967290U, .k = 33U, .y = {4.377355581021666e153}, .status = PTC_OK, .u = -4.377355581021666e159, .xhat = {4.377355581021666e153, 0.0}, .d = 0.0},
    {.is_armed = 1U, .start = 0U, .k = 30U, .y = {-6.056058047674721e153}, .status = PTC_OK, .u = 3.1980207984566205e159, .xhat = {-6.056058047674721e153, 0.0}, .d = 0.0},
    {.is_armed = 0U, .start = 0U, .k = 0U, .y = {-0.5918653123115474}, .status = PTC_SATURATED, .u = 1.0, .xhat = {-0.5918653123115474, 0.0}, .d = 0.0},
    {.is_armed = 0U, .start = 0U, .k = 1U, .y = {0.9637360253933878}, .status = PTC_SATURATED, .u = -1.0, .xhat = {0.2332937047992233, 154.11530280668086}, .d = 6421.47095027837},
};

/* 1 where a number is not the one that must come. */
static uint32_t stage3_selftest_differs(double value, double wanted)
{
    uint32_t failures = 1U;

    if (fabs(value - wanted) <= 0.0) {
        failures = 0U;
    }
    return failures;
}

/* The failures of one call. */
static uint32_t stage3_selftest_check(stage3 *self, const stage3_selftest_call *call)
{
    uint32_t failures = 0U;
    double u = 12345.0;
    double xhat[2] = {12345.0, 12345.0};
    double d = 12345.0;

    if (call->is_armed != 0U) {
        if (stage3_arm(self, call->start) != PTC_OK) {
            failures++;
        }
    }
    if (stage3_step(self, call->k, call->y, &u) != call->status) {
        failures++;
    }
    failures += stage3_selftest_differs(u, call->u);
    if (stage3_estimate(self, xhat) != PTC_OK) {
        failures++;
    }
    for (uint32_t i = 0U; i < 2U; i++) {
        failures += stage3_selftest_differs(xhat[i], call->xhat[i]);
    }
    if (stage3_disturbance(self, &d) != PTC_OK) {
        failures++;
    }
    failures += stage3_selftest_differs(d, call->d);
    return failures;
}

/* The calls of a session, of which init has been called. */
static uint32_t stage3_selftest_calls_of(stage3 *self, const stage3_selftest_session *session)
{
    uint32_t failures = 0U;

    for (uint32_t j = 0U; j < session->count; j++) {
        failures += stage3_selftest_check(self, &stage3_selftest_calls[session->first + j]);
    }
    return failures;
}

/* Every session with its calls. */
static uint32_t stage3_selftest_run(void)
{
    uint32_t failures = 0U;

    for (uint32_t i = 0U; i < 4U; i++) {
        const stage3_selftest_session *session = &stage3_selftest_sessions[i];
        stage3 self;

        if (stage3_init(&self, &session->params) == PTC_OK) {
            failures += stage3_selftest_calls_of(&self, session);
        } else {
            failures++;
        }
    }
    return failures;
}

/* What init must refuse without a change. */
static uint32_t stage3_selftest_refuse(void)
{
    static const stage3_params refused[5] = {
        {.u_max = (double)NAN},
        {.u_max = -(double)INFINITY},
        {.u_max = 0.0},
        {.u_max = -1.0},
        {.u_max = -1.7976931348623157e308},
    };
    const stage3_selftest_session *session = &stage3_selftest_sessions[0];
    uint32_t failures = 0U;
    stage3 self;

    if (stage3_init(&self, &session->params) != PTC_OK) {
        failures++;
    }
    for (uint32_t i = 0U; i < 5U; i++) {
        if (stage3_init(&self, &refused[i]) != PTC_E_PARAM) {
            failures++;
        }
    }
    if (stage3_init(&self, NULL) != PTC_E_PARAM) {
        failures++;
    }
    if (stage3_init(NULL, &session->params) != PTC_E_PARAM) {
        failures++;
    }
    failures += stage3_selftest_calls_of(&self, session);
    return failures;
}

/* Calls that lack a pointer: each is refused, and changes nothing. */
static uint32_t stage3_selftest_pointers(void)
{
    const stage3_selftest_session *session = &stage3_selftest_sessions[0];
    const stage3_selftest_call *call = &stage3_selftest_calls[0];
    uint32_t failures = 0U;
    double u = 12345.0;
    double xhat[2];
    double d;
    stage3 self;

    if (stage3_init(&self, &session->params) != PTC_OK) {
        failures++;
    }
    if (stage3_arm(NULL, call->start) != PTC_E_INPUT) {
        failures++;
    }
    if (stage3_step(NULL, call->k, call->y, &u) != PTC_E_INPUT) {
        failures++;
    }
    failures += stage3_selftest_differs(u, 0.0);
    u = 12345.0;
    if (stage3_step(&self, call->k, NULL, &u) != PTC_E_INPUT) {
        failures++;
    }
    failures += stage3_selftest_differs(u, 0.0);
    if (stage3_step(&self, call->k, call->y, NULL) != PTC_E_INPUT) {
        failures++;
    }
    if (stage3_estimate(NULL, xhat) != PTC_E_INPUT) {
        failures++;
    }
    if (stage3_estimate(&self, NULL) != PTC_E_INPUT) {
        failures++;
    }
    if (stage3_disturbance(NULL, &d) != PTC_E_INPUT) {
        failures++;
    }
    if (stage3_disturbance(&self, NULL) != PTC_E_INPUT) {
        failures++;
    }
    failures += stage3_selftest_calls_of(&self, session);
    return failures;
}

uint32_t stage3_selftest(void)
{
    uint32_t failures = stage3_selftest_run();

    failures += stage3_selftest_refuse();
    failures += stage3_selftest_pointers();
    return failures;
}
