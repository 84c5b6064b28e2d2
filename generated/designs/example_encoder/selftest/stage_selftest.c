/* Self-test of the prescribed-time controller stage: see stage_selftest.h. DO NOT EDIT. */
#include "stage_selftest.h"
#include "stage.h"

#include <math.h>
#include <stddef.h>

/* A call, and what it must give. */
typedef struct stage_selftest_call {
    uint32_t is_armed; /* arm is called before it */
    uint32_t start;
    uint32_t k;
    double y[1]; /* what is measured */
    ptc_status status;
    double u;
    double xhat[2]; /* the estimates behind it */
    double d;
} stage_selftest_call;

/* A set of parameters that init takes, and the calls with it, one after the other. */
typedef struct stage_selftest_session {
    stage_params params;
    uint32_t first; /* of its calls */
    uint32_t count;
} stage_selftest_session;

static const stage_selftest_session stage_selftest_sessions[4] = {
    {.params = {.none = (char)0}, .first = 0U, .count = 42U},
    {.params = {.none = (char)0}, .first = 42U, .count = 1U},
    {.params = {.none = (char)0}, .first = 43U, .count = 2U},
    {.params = {.none = (char)0}, .first = 45U, .count = 2U},
};

static const stage_selftest_call stage_selftest_calls[47] = {
    {.is_armed = 0U, .start = 0U, .k = 0U, .y = {0.75}, .status = PTC_OK, .u = -0.13134299083751297, .xhat = {0.75, 0.0}, .d = 0.0},
    {.is_armed = 0U, .start = 0U, .k = 1U, .y = {0.7481261718750001}, .status = PTC_OK, .u = -0.2614384724493952, .xhat = {0.7498887115858045, -0.0017033497552366567}, .d = -0.008690559975697227},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {0.7462546875}, .status = PTC_OK, .u = -0.39003839071582797, .xhat = {0.7496701646865449, -0.005131954230765392}, .d = -0.025794399847423356},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {(double)NAN}, .status = PTC_E_INPUT, .u = 0.0, .xhat = {0.7496701646865449, -0.005131954230765392}, .d = -0.025794399847423356},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {(double)INFINITY}, .status = PTC_E_INPUT, .u = 0.0, .xhat = {0.7496701646865449, -0.005131954230765392}, .d = -0.025794399847423356},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {-(double)INFINITY}, .status = PTC_E_INPUT, .u = 0.0, .xhat = {0.7496701646865449, -0.005131954230765392}, .d = -0.025794399847423356},
    {.is_armed = 0U, .start = 0U, .k = 3U, .y = {0.744385546875}, .status = PTC_OK, .u = -0.5169052085344149, .xhat = {0.7493482551980913, -0.010220453778643508}, .d = -0.051036724416221826},
    {.is_armed = 0U, .start = 0U, .k = 100U, .y = {0.57421875}, .status = PTC_OK, .u = -0.5460767763141039, .xhat = {0.7289560561059364, -0.6408134411010239}, .d = -6.548963912515455},
    {.is_armed = 0U, .start = 0U, .k = 196U, .y = {0.42751875}, .status = PTC_SATURATED, .u = 6.0, .xhat = {0.6201455374816093, -12.647654625138404}, .d = -451.07231963930604},
    {.is_armed = 0U, .start = 0U, .k = 198U, .y = {0.42469218749999993}, .status = PTC_SATURATED, .u = 6.0, .xhat = {0.5416634695976841, -20.23694420986093}, .d = -721.0060475570385},
    {.is_armed = 0U, .start = 0U, .k = 199U, .y = {0.423282421875}, .status = PTC_SATURATED, .u = 6.0, .xhat = {0.4859806970536841, -24.62019974628876}, .d = -865.6943748924634},
    {.is_armed = 0U, .start = 0U, .k = 200U, .y = {0.421875}, .status = PTC_SATURATED, .u = 6.0, .xhat = {0.4469777646652679, -26.75742466638632}, .d = -923.6238318123125},
    {.is_armed = 0U, .start = 0U, .k = 201U, .y = {0.4204699218750001}, .status = PTC_SATURATED, .u = 6.0, .xhat = {0.42011421082438954, -27.34701035290264}, .d = -922.8029601570573},
    {.is_armed = 0U, .start = 0U, .k = 500U, .y = {0.10546875}, .status = PTC_SATURATED, .u = 6.0, .xhat = {0.2892572743005903, -39.409651148146686}, .d = -1346.9303239276503},
    {.is_armed = 0U, .start = 0U, .k = 796U, .y = {1.8750000000000002e-5}, .status = PTC_SATURATED, .u = 6.0, .xhat = {0.159721442261646, -50.254310907580496}, .d = -1715.4749983776026},
    {.is_armed = 0U, .start = 0U, .k = 798U, .y = {4.6875000000000004e-6}, .status = PTC_SATURATED, .u = 6.0, .xhat = {0.06973887691427991, -55.73893732385018}, .d = -1876.4000508720947},
    {.is_armed = 0U, .start = 0U, .k = 799U, .y = {1.1718750000000001e-6}, .status = PTC_SATURATED, .u = 6.0, .xhat = {0.008566635589949462, -57.51956496872202}, .d = -1896.166505598901},
    {.is_armed = 0U, .start = 0U, .k = 800U, .y = {0.0}, .status = PTC_SATURATED, .u = 6.0, .xhat = {-0.03175265041617267, -56.80124160037002}, .d = -1822.8911584846564},
    {.is_armed = 0U, .start = 0U, .k = 801U, .y = {0.0}, .status = PTC_SATURATED, .u = 6.0, .xhat = {-0.05709723109532785, -54.45490566598424}, .d = -1691.1283174954383},
    {.is_armed = 0U, .start = 0U, .k = 2147483647U, .y = {0.0}, .status = PTC_SATURATED, .u = 6.0, .xhat = {-0.07179704436483764, -51.10481639542849}, .d = -1525.442830499659},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {0.0}, .status = PTC_SATURATED, .u = 6.0, .xhat = {-0.07902997251965312, -47.19360307158834}, .d = -1343.0659708389212},
    {.is_armed = 1U, .start = 4294967293U, .k = 4294967293U, .y = {0.75}, .status = PTC_SATURATED, .u = 6.0, .xhat = {-0.07485940564384458, -47.296018096504746}, .d = -1339.0610861233058},
    {.is_armed = 0U, .start = 0U, .k = 4294967294U, .y = {0.7481261718750001}, .status = PTC_SATURATED, .u = 6.0, .xhat = {-0.07088654461314281, -47.39321701705351}, .d = -1335.0227776018767},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {0.7462546875}, .status = PTC_SATURATED, .u = 6.0, .xhat = {-0.06709549560181398, -47.48498734154614}, .d = -1330.9497270348238},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {(double)NAN}, .status = PTC_E_INPUT, .u = 0.0, .xhat = {-0.06709549560181398, -47.48498734154614}, .d = -1330.9497270348238},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {(double)INFINITY}, .status = PTC_E_INPUT, .u = 0.0, .xhat = {-0.06709549560181398, -47.48498734154614}, .d = -1330.9497270348238},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {-(double)INFINITY}, .status = PTC_E_INPUT, .u = 0.0, .xhat = {-0.06709549560181398, -47.48498734154614}, .d = -1330.9497270348238},
    {.is_armed = 0U, .start = 0U, .k = 0U, .y = {0.744385546875}, .status = PTC_SATURATED, .u = 6.0, .xhat = {-0.0634709581009607, -47.571125225692555}, .d = -1326.8406449014383},
    {.is_armed = 0U, .start = 0U, .k = 97U, .y = {0.57421875}, .status = PTC_SATURATED, .u = 6.0, .xhat = {-0.03167472620795747, -45.98367051597797}, .d = -1301.3971898535117},
    {.is_armed = 0U, .start = 0U, .k = 193U, .y = {0.42751875}, .status = PTC_SATURATED, .u = 6.0, .xhat = {0.10372976993921872, -26.6727245002983}, .d = -554.1918512517088},
    {.is_armed = 0U, .start = 0U, .k = 195U, .y = {0.42469218749999993}, .status = PTC_SATURATED, .u = 6.0, .xhat = {0.2019516779031465, -13.159738598046776}, .d = -40.17529064358553},
    {.is_armed = 0U, .start = 0U, .k = 196U, .y = {0.423282421875}, .status = PTC_OK, .u = 1.7796286936580827, .xhat = {0.27310880776983615, -3.8255507847438306}, .d = 306.37920344525406},
    {.is_armed = 0U, .start = 0U, .k = 197U, .y = {0.421875}, .status = PTC_SATURATED, .u = -6.0, .xhat = {0.3242228317251788, 2.4671832715995565}, .d = 531.7303610025338},
    {.is_armed = 0U, .start = 0U, .k = 198U, .y = {0.4204699218750001}, .status = PTC_SATURATED, .u = -6.0, .xhat = {0.36052770942205103, 6.557717527824358}, .d = 670.0585435862624},
    {.is_armed = 0U, .start = 0U, .k = 497U, .y = {0.10546875}, .status = PTC_SATURATED, .u = -6.0, .xhat = {0.2731482764714575, -3.447301118134587}, .d = 283.10579019059134},
    {.is_armed = 0U, .start = 0U, .k = 793U, .y = {1.8750000000000002e-5}, .status = PTC_SATURATED, .u = 6.0, .xhat = {0.17278080523895029, -14.026968904947248}, .d = -115.57587574544772},
    {.is_armed = 0U, .start = 0U, .k = 795U, .y = {4.6875000000000004e-6}, .status = PTC_SATURATED, .u = 6.0, .xhat = {0.10164075183729766, -20.44072811287071}, .d = -350.12063960075},
    {.is_armed = 0U, .start = 0U, .k = 796U, .y = {1.1718750000000001e-6}, .status = PTC_SATURATED, .u = 6.0, .xhat = {0.05192697899836357, -23.905519085675653}, .d = -469.94942527005054},
    {.is_armed = 0U, .start = 0U, .k = 797U, .y = {0.0}, .status = PTC_SATURATED, .u = 6.0, .xhat = {0.017845740460859082, -25.326745608160493}, .d = -511.1319032566484},
    {.is_armed = 0U, .start = 0U, .k = 798U, .y = {0.0}, .status = PTC_SATURATED, .u = 6.0, .xhat = {-0.004898619301922686, -25.35827854613487}, .d = -499.82739717528835},
    {.is_armed = 0U, .start = 0U, .k = 2147483644U, .y = {0.0}, .status = PTC_SATURATED, .u = 6.0, .xhat = {-0.01948175323871139, -24.473633724506374}, .d = -454.86950508595436},
    {.is_armed = 0U, .start = 0U, .k = 4294967292U, .y = {0.0}, .status = PTC_SATURATED, .u = 6.0, .xhat = {-0.028244587768991962, -23.01302497716238}, .d = -389.68968715751134},
    {.is_armed = 0U, .start = 0U, .k = 94U, .y = {6.260933143287877e301}, .status = PTC_E_RANGE, .u = 0.0, .xhat = {0.0, 0.0}, .d = 0.0},
    {.is_armed = 0U, .start = 0U, .k = 108U, .y = {7.1200186866681e153}, .status = PTC_SATURATED, .u = -6.0, .xhat = {7.1200186866681e153, 0.0}, .d = 0.0},
    {.is_armed = 1U, .start = 4294967290U, .k = 703U, .y = {8.967500654424333e153}, .status = PTC_SATURATED, .u = -6.0, .xhat = {8.967500654424333e153, 0.0}, .d = 0.0},
    {.is_armed = 0U, .start = 0U, .k = 700U, .y = {0.0}, .status = PTC_OK, .u = 0.0, .xhat = {0.0, 0.0}, .d = 0.0},
    {.is_armed = 1U, .start = 0U, .k = 792U, .y = {-0.0}, .status = PTC_HOLD, .u = 0.0, .xhat = {0.0, 0.0}, .d = 0.0},
};

/* 1 where a number is not the one that must come. */
static uint32_t stage_selftest_differs(double value, double wanted)
{
    uint32_t failures = 1U;

    if (fabs(value - wanted) <= 0.0) {
        failures = 0U;
    }
    return failures;
}

/* The failures of one call. */
static uint32_t stage_selftest_check(stage *self, const stage_selftest_call *call)
{
    uint32_t failures = 0U;
    double u = 12345.0;
    double xhat[2] = {12345.0, 12345.0};
    double d = 12345.0;

    if (call->is_armed != 0U) {
        if (stage_arm(self, call->start) != PTC_OK) {
            failures++;
        }
    }
    if (stage_step(self, call->k, call->y, &u) != call->status) {
        failures++;
    }
    failures += stage_selftest_differs(u, call->u);
    if (stage_estimate(self, xhat) != PTC_OK) {
        failures++;
    }
    for (uint32_t i = 0U; i < 2U; i++) {
        failures += stage_selftest_differs(xhat[i], call->xhat[i]);
    }
    if (stage_disturbance(self, &d) != PTC_OK) {
        failures++;
    }
    failures += stage_selftest_differs(d, call->d);
    return failures;
}

/* The calls of a session, of which init has been called. */
static uint32_t stage_selftest_calls_of(stage *self, const stage_selftest_session *session)
{
    uint32_t failures = 0U;

    for (uint32_t j = 0U; j < session->count; j++) {
        failures += stage_selftest_check(self, &stage_selftest_calls[session->first + j]);
    }
    return failures;
}

/* Every session with its calls. */
static uint32_t stage_selftest_run(void)
{
    uint32_t failures = 0U;

    for (uint32_t i = 0U; i < 4U; i++) {
        const stage_selftest_session *session = &stage_selftest_sessions[i];
        stage self;

        if (stage_init(&self, &session->params) == PTC_OK) {
            failures += stage_selftest_calls_of(&self, session);
        } else {
            failures++;
        }
    }
    return failures;
}

/* What init must refuse without a change. */
static uint32_t stage_selftest_refuse(void)
{
    const stage_selftest_session *session = &stage_selftest_sessions[0];
    uint32_t failures = 0U;
    stage self;

    if (stage_init(&self, &session->params) != PTC_OK) {
        failures++;
    }
    if (stage_init(NULL, &session->params) != PTC_E_PARAM) {
        failures++;
    }
    failures += stage_selftest_calls_of(&self, session);
    return failures;
}

/* Calls that lack a pointer: each is refused, and changes nothing. */
static uint32_t stage_selftest_pointers(void)
{
    const stage_selftest_session *session = &stage_selftest_sessions[0];
    const stage_selftest_call *call = &stage_selftest_calls[0];
    uint32_t failures = 0U;
    double u = 12345.0;
    double xhat[2];
    double d;
    stage self;

    if (stage_init(&self, &session->params) != PTC_OK) {
        failures++;
    }
    if (stage_arm(NULL, call->start) != PTC_E_INPUT) {
        failures++;
    }
    if (stage_step(NULL, call->k, call->y, &u) != PTC_E_INPUT) {
        failures++;
    }
    failures += stage_selftest_differs(u, 0.0);
    u = 12345.0;
    if (stage_step(&self, call->k, NULL, &u) != PTC_E_INPUT) {
        failures++;
    }
    failures += stage_selftest_differs(u, 0.0);
    if (stage_step(&self, call->k, call->y, NULL) != PTC_E_INPUT) {
        failures++;
    }
    if (stage_estimate(NULL, xhat) != PTC_E_INPUT) {
        failures++;
    }
    if (stage_estimate(&self, NULL) != PTC_E_INPUT) {
        failures++;
    }
    if (stage_disturbance(NULL, &d) != PTC_E_INPUT) {
        failures++;
    }
    if (stage_disturbance(&self, NULL) != PTC_E_INPUT) {
        failures++;
    }
    failures += stage_selftest_calls_of(&self, session);
    return failures;
}

uint32_t stage_selftest(void)
{
    uint32_t failures = stage_selftest_run();

    failures += stage_selftest_refuse();
    failures += stage_selftest_pointers();
    return failures;
}
