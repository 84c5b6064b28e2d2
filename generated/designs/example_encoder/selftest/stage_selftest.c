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

static const stage_selftest_session stage_selftest_sessions[3] = {
    {.params = {.none = (char)0}, .first = 0U, .count = 42U},
    {.params = {.none = (char)0}, .first = 42U, .count = 1U},
    {.params = {.none = (char)0}, .first = 43U, .count = 2U},
};

static const stage_selftest_call stage_selftest_calls[45] = {
    {.is_armed = 0U, .start = 0U, .k = 0U, .y = {0.75}, .status = PTC_OK, .u = -0.2646635361871512, .xhat = {0.75, 0.0}, .d = 0.0},
    {.is_armed = 0U, .start = 0U, .k = 1U, .y = {0.7481261718750001}, .status = PTC_OK, .u = -0.5259273950713397, .xhat = {0.7498887115858045, -0.0017033497552366567}, .d = -0.008690559975697227},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {0.7462546875}, .status = PTC_OK, .u = -0.783413974907968, .xhat = {0.7496701228988316, -0.005220793788197867}, .d = -0.025794190585197968},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {(double)NAN}, .status = PTC_E_INPUT, .u = 0.0, .xhat = {0.7496701228988316, -0.005220793788197867}, .d = -0.025794190585197968},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {(double)INFINITY}, .status = PTC_E_INPUT, .u = 0.0, .xhat = {0.7496701228988316, -0.005220793788197867}, .d = -0.025794190585197968},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {-(double)INFINITY}, .status = PTC_E_INPUT, .u = 0.0, .xhat = {0.7496701228988316, -0.005220793788197867}, .d = -0.025794190585197968},
    {.is_armed = 0U, .start = 0U, .k = 3U, .y = {0.744385546875}, .status = PTC_OK, .u = -1.0367637251890198, .xhat = {0.7493480495319444, -0.01048541620148648}, .d = -0.05103546905350169},
    {.is_armed = 0U, .start = 0U, .k = 100U, .y = {0.57421875}, .status = PTC_OK, .u = -1.1724032893322418, .xhat = {0.7289555243896835, -0.6413384872109439}, .d = -6.548940328642673},
    {.is_armed = 0U, .start = 0U, .k = 196U, .y = {0.42751875}, .status = PTC_SATURATED, .u = 6.0, .xhat = {0.620144749770833, -12.648477147429501}, .d = -451.07047826133413},
    {.is_armed = 0U, .start = 0U, .k = 198U, .y = {0.42469218749999993}, .status = PTC_SATURATED, .u = 6.0, .xhat = {0.5416623051084167, -20.238110498936425}, .d = -721.001518896142},
    {.is_armed = 0U, .start = 0U, .k = 199U, .y = {0.423282421875}, .status = PTC_SATURATED, .u = 6.0, .xhat = {0.4859792054037205, -24.62127007499003}, .d = -865.6864039624202},
    {.is_armed = 0U, .start = 0U, .k = 200U, .y = {0.421875}, .status = PTC_SATURATED, .u = 6.0, .xhat = {0.4469761256907878, -26.758387560416626}, .d = -923.612078633469},
    {.is_armed = 0U, .start = 0U, .k = 201U, .y = {0.4204699218750001}, .status = PTC_SATURATED, .u = 6.0, .xhat = {0.42011254711206475, -27.34786174940476}, .d = -922.7873676420797},
    {.is_armed = 0U, .start = 0U, .k = 500U, .y = {0.10546875}, .status = PTC_SATURATED, .u = 6.0, .xhat = {0.28925566696821664, -39.410392000467844}, .d = -1346.911022184118},
    {.is_armed = 0U, .start = 0U, .k = 796U, .y = {1.8750000000000002e-5}, .status = PTC_SATURATED, .u = -6.0, .xhat = {0.15971994261828917, -50.254945452755784}, .d = -1715.4522359186315},
    {.is_armed = 0U, .start = 0U, .k = 798U, .y = {4.6875000000000004e-6}, .status = PTC_SATURATED, .u = 6.0, .xhat = {0.06973751505154122, -55.739471839528335}, .d = -1876.3741456529574},
    {.is_armed = 0U, .start = 0U, .k = 799U, .y = {1.1718750000000001e-6}, .status = PTC_SATURATED, .u = 6.0, .xhat = {0.008562865113916487, -57.52784728459356}, .d = -1896.1318992812262},
    {.is_armed = 0U, .start = 0U, .k = 800U, .y = {0.0}, .status = PTC_SATURATED, .u = 6.0, .xhat = {-0.0317603615656332, -56.80902038143519}, .d = -1822.8387572066881},
    {.is_armed = 0U, .start = 0U, .k = 801U, .y = {0.0}, .status = PTC_SATURATED, .u = 6.0, .xhat = {-0.05710713956944753, -54.46203213870741}, .d = -1691.053050507963},
    {.is_armed = 0U, .start = 0U, .k = 2147483647U, .y = {0.0}, .status = PTC_SATURATED, .u = 6.0, .xhat = {-0.071807937377252, -51.1112139716942}, .d = -1525.3424257912277},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {0.0}, .status = PTC_SATURATED, .u = 6.0, .xhat = {-0.07904102387757286, -47.199245126772915}, .d = -1342.9400629968288},
    {.is_armed = 1U, .start = 4294967293U, .k = 4294967293U, .y = {0.75}, .status = PTC_SATURATED, .u = 6.0, .xhat = {-0.0748750730119338, -47.30156122758917}, .d = -1338.9351022124888},
    {.is_armed = 0U, .start = 0U, .k = 4294967294U, .y = {0.7481261718750001}, .status = PTC_SATURATED, .u = 6.0, .xhat = {-0.07090645590029157, -47.39865691624167}, .d = -1334.896695514415},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {0.7462546875}, .status = PTC_SATURATED, .u = 6.0, .xhat = {-0.06711929415162127, -47.49031994647946}, .d = -1330.8235257702859},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {(double)NAN}, .status = PTC_E_INPUT, .u = 0.0, .xhat = {-0.06711929415162127, -47.49031994647946}, .d = -1330.8235257702859},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {(double)INFINITY}, .status = PTC_E_INPUT, .u = 0.0, .xhat = {-0.06711929415162127, -47.49031994647946}, .d = -1330.8235257702859},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {-(double)INFINITY}, .status = PTC_E_INPUT, .u = 0.0, .xhat = {-0.06711929415162127, -47.49031994647946}, .d = -1330.8235257702859},
    {.is_armed = 0U, .start = 0U, .k = 0U, .y = {0.744385546875}, .status = PTC_SATURATED, .u = 6.0, .xhat = {-0.06349830229305739, -47.576346714245474}, .d = -1326.7143045533744},
    {.is_armed = 0U, .start = 0U, .k = 97U, .y = {0.57421875}, .status = PTC_SATURATED, .u = 6.0, .xhat = {-0.03170346441006987, -45.98869071692649}, .d = -1301.269642694049},
    {.is_armed = 0U, .start = 0U, .k = 193U, .y = {0.42751875}, .status = PTC_SATURATED, .u = 6.0, .xhat = {0.10370817848427125, -26.67631435607584}, .d = -554.014477657752},
    {.is_armed = 0U, .start = 0U, .k = 195U, .y = {0.42469218749999993}, .status = PTC_SATURATED, .u = 6.0, .xhat = {0.2019355898036136, -13.162207792406164}, .d = -39.96079066609127},
    {.is_armed = 0U, .start = 0U, .k = 196U, .y = {0.423282421875}, .status = PTC_OK, .u = 0.46634751557405707, .xhat = {0.2730969695766984, -3.8271393686227135}, .d = 306.6210223299894},
    {.is_armed = 0U, .start = 0U, .k = 197U, .y = {0.421875}, .status = PTC_SATURATED, .u = -6.0, .xhat = {0.3242142849163422, 2.4662884322456997}, .d = 531.9919032922766},
    {.is_armed = 0U, .start = 0U, .k = 198U, .y = {0.4204699218750001}, .status = PTC_SATURATED, .u = -6.0, .xhat = {0.3605214385372403, 6.55651225357289}, .d = 670.3345571486453},
    {.is_armed = 0U, .start = 0U, .k = 497U, .y = {0.10546875}, .status = PTC_SATURATED, .u = -6.0, .xhat = {0.27314354770253935, -3.44802774466572}, .d = 283.3927162966314},
    {.is_armed = 0U, .start = 0U, .k = 793U, .y = {1.8750000000000002e-5}, .status = PTC_SATURATED, .u = -6.0, .xhat = {0.17277737288454725, -14.02729038532565}, .d = -115.28102882155446},
    {.is_armed = 0U, .start = 0U, .k = 795U, .y = {4.6875000000000004e-6}, .status = PTC_SATURATED, .u = -6.0, .xhat = {0.10163841084310282, -20.440707166687194}, .d = -349.82039038256096},
    {.is_armed = 0U, .start = 0U, .k = 796U, .y = {1.1718750000000001e-6}, .status = PTC_SATURATED, .u = 6.0, .xhat = {0.05192299576958516, -23.913049787553568}, .d = -469.63998398544976},
    {.is_armed = 0U, .start = 0U, .k = 797U, .y = {0.0}, .status = PTC_SATURATED, .u = 6.0, .xhat = {0.017835871486164556, -25.34145510281002}, .d = -510.79968741506025},
    {.is_armed = 0U, .start = 0U, .k = 798U, .y = {0.0}, .status = PTC_SATURATED, .u = 6.0, .xhat = {-0.004914288292045466, -25.37179026494133}, .d = -499.4590221257246},
    {.is_armed = 0U, .start = 0U, .k = 2147483644U, .y = {0.0}, .status = PTC_SATURATED, .u = 6.0, .xhat = {-0.01950036175714482, -24.485740406105606}, .d = -454.4581873015442},
    {.is_armed = 0U, .start = 0U, .k = 4294967292U, .y = {0.0}, .status = PTC_SATURATED, .u = 6.0, .xhat = {-0.02826416979969929, -23.02363733576127}, .d = -389.23318007146895},
    {.is_armed = 0U, .start = 0U, .k = 94U, .y = {6.260933143287877e301}, .status = PTC_E_RANGE, .u = 0.0, .xhat = {0.0, 0.0}, .d = 0.0},
    {.is_armed = 0U, .start = 0U, .k = 108U, .y = {7.1200186866681e153}, .status = PTC_SATURATED, .u = -6.0, .xhat = {7.1200186866681e153, 0.0}, .d = 0.0},
    {.is_armed = 1U, .start = 4294967290U, .k = 703U, .y = {8.967500654424333e153}, .status = PTC_SATURATED, .u = -6.0, .xhat = {8.967500654424333e153, 0.0}, .d = 0.0},
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

    for (uint32_t i = 0U; i < 3U; i++) {
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
