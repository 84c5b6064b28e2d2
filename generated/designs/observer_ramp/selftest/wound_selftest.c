/* Self-test of the prescribed-time controller wound: see wound_selftest.h. DO NOT EDIT. */
#include "wound_selftest.h"
#include "wound.h"

#include <math.h>
#include <stddef.h>

/* A call, and what it must give. */
typedef struct wound_selftest_call {
    uint32_t is_armed; /* arm is called before it */
    uint32_t start;
    uint32_t k;
    double y[1]; /* what is measured */
    ptc_status status;
    double u;
    double xhat[2]; /* the estimates behind it */
    double d;
} wound_selftest_call;

/* A set of parameters that init takes, and the calls with it, one after the other. */
typedef struct wound_selftest_session {
    wound_params params;
    uint32_t first; /* of its calls */
    uint32_t count;
} wound_selftest_session;

static const wound_selftest_session wound_selftest_sessions[4] = {
    {.params = {.none = (char)0}, .first = 0U, .count = 42U},
    {.params = {.none = (char)0}, .first = 42U, .count = 2U},
    {.params = {.none = (char)0}, .first = 44U, .count = 1U},
    {.params = {.none = (char)0}, .first = 45U, .count = 2U},
};

static const wound_selftest_call wound_selftest_calls[47] = {
    {.is_armed = 0U, .start = 0U, .k = 0U, .y = {0.75}, .status = PTC_OK, .u = -1.2949526947263021, .xhat = {0.75, 0.0}, .d = 0.0},
    {.is_armed = 0U, .start = 0U, .k = 1U, .y = {0.7450083333333334}, .status = PTC_OK, .u = -1.2911634509932424, .xhat = {0.7499741440572929, -0.051668828075516315}, .d = 0.0},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {0.7400333333333332}, .status = PTC_OK, .u = 1.6807098718438223, .xhat = {0.7471231021391059, -0.7971940552450609}, .d = -2.6975842186928456},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {(double)NAN}, .status = PTC_E_INPUT, .u = 0.0, .xhat = {0.7471231021391059, -0.7971940552450609}, .d = -2.6975842186928456},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {(double)INFINITY}, .status = PTC_E_INPUT, .u = 0.0, .xhat = {0.7471231021391059, -0.7971940552450609}, .d = -2.6975842186928456},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {-(double)INFINITY}, .status = PTC_E_INPUT, .u = 0.0, .xhat = {0.7471231021391059, -0.7971940552450609}, .d = -2.6975842186928456},
    {.is_armed = 0U, .start = 0U, .k = 3U, .y = {0.7350749999999999}, .status = PTC_OK, .u = 6.128298920533579, .xhat = {0.7423461379495597, -1.8291090024189478}, .d = -6.754494109763188},
    {.is_armed = 0U, .start = 0U, .k = 75U, .y = {0.421875}, .status = PTC_SATURATED, .u = 10.0, .xhat = {0.7364443748908075, -2.8715049956031806}, .d = -11.203360784931213},
    {.is_armed = 0U, .start = 0U, .k = 146U, .y = {0.19763333333333333}, .status = PTC_SATURATED, .u = 10.0, .xhat = {0.5578436400292641, -46.90081495825197}, .d = -182.8872110552596},
    {.is_armed = 0U, .start = 0U, .k = 148U, .y = {0.1925333333333334}, .status = PTC_SATURATED, .u = 10.0, .xhat = {0.30631546716008745, -104.20171196256214}, .d = -392.3840460283402},
    {.is_armed = 0U, .start = 0U, .k = 149U, .y = {0.19000833333333333}, .status = PTC_SATURATED, .u = 10.0, .xhat = {0.13099302330908535, -135.4205602755325}, .d = -482.92174957508007},
    {.is_armed = 0U, .start = 0U, .k = 150U, .y = {0.1875}, .status = PTC_SATURATED, .u = 10.0, .xhat = {0.019208937736125715, -146.03155408469286}, .d = -484.29967433118566},
    {.is_armed = 0U, .start = 0U, .k = 151U, .y = {0.1850083333333333}, .status = PTC_SATURATED, .u = 10.0, .xhat = {-0.04213343593921617, -141.31809623660902}, .d = -423.8730554224185},
    {.is_armed = 0U, .start = 0U, .k = 225U, .y = {0.046875}, .status = PTC_SATURATED, .u = 10.0, .xhat = {-0.06464934778330024, -125.85018041029353}, .d = -324.51165464322327},
    {.is_armed = 0U, .start = 0U, .k = 296U, .y = {0.00013333333333333337}, .status = PTC_SATURATED, .u = 10.0, .xhat = {-0.1342691326814705, -122.47153089086692}, .d = -278.55632117830476},
    {.is_armed = 0U, .start = 0U, .k = 298U, .y = {3.333333333333334e-5}, .status = PTC_SATURATED, .u = 10.0, .xhat = {-0.18679150344473056, -113.98537724475115}, .d = -215.5571058893715},
    {.is_armed = 0U, .start = 0U, .k = 299U, .y = {8.333333333333335e-6}, .status = PTC_SATURATED, .u = 10.0, .xhat = {-0.2002727406769419, -95.58767952426543}, .d = -118.51776403584738},
    {.is_armed = 0U, .start = 0U, .k = 300U, .y = {0.0}, .status = PTC_SATURATED, .u = 10.0, .xhat = {-0.1858969912310543, -71.37416232266416}, .d = -6.436264912701333},
    {.is_armed = 0U, .start = 0U, .k = 301U, .y = {0.0}, .status = PTC_SATURATED, .u = 10.0, .xhat = {-0.15310949340250993, -44.65485633610048}, .d = 106.12058277413445},
    {.is_armed = 0U, .start = 0U, .k = 2147483647U, .y = {0.0}, .status = PTC_SATURATED, .u = 10.0, .xhat = {-0.10968466536957285, -18.00814351348735}, .d = 208.56013798412474},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {0.0}, .status = PTC_SATURATED, .u = -10.0, .xhat = {-0.06184759041500132, 6.648366494977473}, .d = 293.7468600742344},
    {.is_armed = 1U, .start = 4294967293U, .k = 4294967293U, .y = {0.75}, .status = PTC_SATURATED, .u = -10.0, .xhat = {-0.01480380849786582, 27.185448060950197}, .d = 357.4866111357244},
    {.is_armed = 0U, .start = 0U, .k = 4294967294U, .y = {0.7450083333333334}, .status = PTC_SATURATED, .u = -10.0, .xhat = {0.4466613620259812, 148.49407940227886}, .d = 805.6539877837504},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {0.7400333333333332}, .status = PTC_SATURATED, .u = -10.0, .xhat = {0.7777457144534432, 222.49676636984563}, .d = 1032.081074890772},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {(double)NAN}, .status = PTC_E_INPUT, .u = 0.0, .xhat = {0.7777457144534432, 222.49676636984563}, .d = 1032.081074890772},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {(double)INFINITY}, .status = PTC_E_INPUT, .u = 0.0, .xhat = {0.7777457144534432, 222.49676636984563}, .d = 1032.081074890772},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {-(double)INFINITY}, .status = PTC_E_INPUT, .u = 0.0, .xhat = {0.7777457144534432, 222.49676636984563}, .d = 1032.081074890772},
    {.is_armed = 0U, .start = 0U, .k = 0U, .y = {0.7350749999999999}, .status = PTC_SATURATED, .u = -10.0, .xhat = {0.9995407102154978, 258.4272509942673}, .d = 1088.2981611759647},
    {.is_armed = 0U, .start = 0U, .k = 72U, .y = {0.421875}, .status = PTC_SATURATED, .u = -10.0, .xhat = {1.1316324060555123, 264.6882698529356}, .d = 1019.7748831412774},
    {.is_armed = 0U, .start = 0U, .k = 143U, .y = {0.19763333333333333}, .status = PTC_SATURATED, .u = -10.0, .xhat = {1.0198046388857334, 205.70961192360554}, .d = 698.4094744632152},
    {.is_armed = 0U, .start = 0U, .k = 145U, .y = {0.1925333333333334}, .status = PTC_SATURATED, .u = -10.0, .xhat = {0.7797428868275416, 117.8995663769536}, .d = 286.6018661368924},
    {.is_armed = 0U, .start = 0U, .k = 146U, .y = {0.19000833333333333}, .status = PTC_SATURATED, .u = 10.0, .xhat = {0.5748823490564615, 46.26663523799188}, .d = -31.59517364990711},
    {.is_armed = 0U, .start = 0U, .k = 147U, .y = {0.1875}, .status = PTC_SATURATED, .u = 10.0, .xhat = {0.4054691233237849, -9.10405647663365}, .d = -264.18063061783874},
    {.is_armed = 0U, .start = 0U, .k = 148U, .y = {0.1850083333333333}, .status = PTC_SATURATED, .u = 10.0, .xhat = {0.26930039372008113, -50.46202240687113}, .d = -422.0272793187079},
    {.is_armed = 0U, .start = 0U, .k = 222U, .y = {0.046875}, .status = PTC_SATURATED, .u = 10.0, .xhat = {0.16333233502233385, -79.40268453194452}, .d = -516.2776592370764},
    {.is_armed = 0U, .start = 0U, .k = 293U, .y = {0.00013333333333333337}, .status = PTC_SATURATED, .u = 10.0, .xhat = {0.00862439095869965, -116.52626436236149}, .d = -631.489905784611},
    {.is_armed = 0U, .start = 0U, .k = 295U, .y = {3.333333333333334e-5}, .status = PTC_SATURATED, .u = 10.0, .xhat = {-0.12514093390049574, -143.06325275359313}, .d = -692.8714188790476},
    {.is_armed = 0U, .start = 0U, .k = 296U, .y = {8.333333333333335e-6}, .status = PTC_SATURATED, .u = 10.0, .xhat = {-0.21194433930772266, -153.2364144531721}, .d = -681.9931608422291},
    {.is_armed = 0U, .start = 0U, .k = 297U, .y = {0.0}, .status = PTC_SATURATED, .u = 10.0, .xhat = {-0.26017254802815987, -150.68894460898454}, .d = -618.7934368064085},
    {.is_armed = 0U, .start = 0U, .k = 298U, .y = {0.0}, .status = PTC_SATURATED, .u = 10.0, .xhat = {-0.27760547208456193, -138.71577183450748}, .d = -520.6268653785651},
    {.is_armed = 0U, .start = 0U, .k = 2147483644U, .y = {0.0}, .status = PTC_SATURATED, .u = 10.0, .xhat = {-0.2713259469104244, -120.23317042236178}, .d = -402.22216030115544},
    {.is_armed = 0U, .start = 0U, .k = 4294967292U, .y = {0.0}, .status = PTC_SATURATED, .u = 10.0, .xhat = {-0.2476768114565024, -97.76691017237586}, .d = -275.7391542073427},
    {.is_armed = 1U, .start = 0U, .k = 298U, .y = {0.0}, .status = PTC_HOLD, .u = -0.0, .xhat = {0.0, 0.0}, .d = 0.0},
    {.is_armed = 1U, .start = 0U, .k = 73U, .y = {1.7501158716715385e308}, .status = PTC_E_RANGE, .u = 0.0, .xhat = {0.0, 0.0}, .d = 0.0},
    {.is_armed = 1U, .start = 0U, .k = 73U, .y = {-7.025854523460211e307}, .status = PTC_E_RANGE, .u = 0.0, .xhat = {0.0, 0.0}, .d = 0.0},
    {.is_armed = 0U, .start = 0U, .k = 58U, .y = {8.821688709822372e153}, .status = PTC_SATURATED, .u = -10.0, .xhat = {8.821688709822372e153, 0.0}, .d = 0.0},
    {.is_armed = 1U, .start = 4294967290U, .k = 233U, .y = {-3.542846648315711e153}, .status = PTC_SATURATED, .u = 10.0, .xhat = {-3.542846648315711e153, 0.0}, .d = 0.0},
};

/* 1 where a number is not the one that must come. */
static uint32_t wound_selftest_differs(double value, double wanted)
{
    uint32_t failures = 1U;

    if (fabs(value - wanted) <= 0.0) {
        failures = 0U;
    }
    return failures;
}

/* The failures of one call. */
static uint32_t wound_selftest_check(wound *self, const wound_selftest_call *call)
{
    uint32_t failures = 0U;
    double u = 12345.0;
    double xhat[2] = {12345.0, 12345.0};
    double d = 12345.0;

    if (call->is_armed != 0U) {
        if (wound_arm(self, call->start) != PTC_OK) {
            failures++;
        }
    }
    if (wound_step(self, call->k, call->y, &u) != call->status) {
        failures++;
    }
    failures += wound_selftest_differs(u, call->u);
    if (wound_estimate(self, xhat) != PTC_OK) {
        failures++;
    }
    for (uint32_t i = 0U; i < 2U; i++) {
        failures += wound_selftest_differs(xhat[i], call->xhat[i]);
    }
    if (wound_disturbance(self, &d) != PTC_OK) {
        failures++;
    }
    failures += wound_selftest_differs(d, call->d);
    return failures;
}

/* The calls of a session, of which init has been called. */
static uint32_t wound_selftest_calls_of(wound *self, const wound_selftest_session *session)
{
    uint32_t failures = 0U;

    for (uint32_t j = 0U; j < session->count; j++) {
        failures += wound_selftest_check(self, &wound_selftest_calls[session->first + j]);
    }
    return failures;
}

/* Every session with its calls. */
static uint32_t wound_selftest_run(void)
{
    uint32_t failures = 0U;

    for (uint32_t i = 0U; i < 4U; i++) {
        const wound_selftest_session *session = &wound_selftest_sessions[i];
        wound self;

        if (wound_init(&self, &session->params) == PTC_OK) {
            failures += wound_selftest_calls_of(&self, session);
        } else {
            failures++;
        }
    }
    return failures;
}

/* What init must refuse without a change. */
static uint32_t wound_selftest_refuse(void)
{
    const wound_selftest_session *session = &wound_selftest_sessions[0];
    uint32_t failures = 0U;
    wound self;

    if (wound_init(&self, &session->params) != PTC_OK) {
        failures++;
    }
    if (wound_init(NULL, &session->params) != PTC_E_PARAM) {
        failures++;
    }
    failures += wound_selftest_calls_of(&self, session);
    return failures;
}

/* Calls that lack a pointer: each is refused, and changes nothing. */
static uint32_t wound_selftest_pointers(void)
{
    const wound_selftest_session *session = &wound_selftest_sessions[0];
    const wound_selftest_call *call = &wound_selftest_calls[0];
    uint32_t failures = 0U;
    double u = 12345.0;
    double xhat[2];
    double d;
    wound self;

    if (wound_init(&self, &session->params) != PTC_OK) {
        failures++;
    }
    if (wound_arm(NULL, call->start) != PTC_E_INPUT) {
        failures++;
    }
    if (wound_step(NULL, call->k, call->y, &u) != PTC_E_INPUT) {
        failures++;
    }
    failures += wound_selftest_differs(u, 0.0);
    u = 12345.0;
    if (wound_step(&self, call->k, NULL, &u) != PTC_E_INPUT) {
        failures++;
    }
    failures += wound_selftest_differs(u, 0.0);
    if (wound_step(&self, call->k, call->y, NULL) != PTC_E_INPUT) {
        failures++;
    }
    if (wound_estimate(NULL, xhat) != PTC_E_INPUT) {
        failures++;
    }
    if (wound_estimate(&self, NULL) != PTC_E_INPUT) {
        failures++;
    }
    if (wound_disturbance(NULL, &d) != PTC_E_INPUT) {
        failures++;
    }
    if (wound_disturbance(&self, NULL) != PTC_E_INPUT) {
        failures++;
    }
    failures += wound_selftest_calls_of(&self, session);
    return failures;
}

uint32_t wound_selftest(void)
{
    uint32_t failures = wound_selftest_run();

    failures += wound_selftest_refuse();
    failures += wound_selftest_pointers();
    return failures;
}
