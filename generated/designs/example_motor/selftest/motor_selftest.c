/* Self-test of the prescribed-time controller motor: see motor_selftest.h. DO NOT EDIT. */
#include "motor_selftest.h"
#include "motor.h"

#include <math.h>
#include <stddef.h>

/* A call, and what it must give. */
typedef struct motor_selftest_call {
    uint32_t is_armed; /* arm is called before it */
    uint32_t start;
    uint32_t k;
    double y[1]; /* what is measured */
    ptc_status status;
    double u;
    double xhat[3]; /* the estimates behind it */
    double d;
} motor_selftest_call;

/* A set of parameters that init takes, and the calls with it, one after the other. */
typedef struct motor_selftest_session {
    motor_params params;
    uint32_t first; /* of its calls */
    uint32_t count;
} motor_selftest_session;

static const motor_selftest_session motor_selftest_sessions[3] = {
    {.params = {.none = (char)0}, .first = 0U, .count = 42U},
    {.params = {.none = (char)0}, .first = 42U, .count = 2U},
    {.params = {.none = (char)0}, .first = 44U, .count = 1U},
};

static const motor_selftest_call motor_selftest_calls[45] = {
    {.is_armed = 0U, .start = 0U, .k = 0U, .y = {0.75}, .status = PTC_OK, .u = -4.4389918906768885e-5, .xhat = {0.75, 0.0, 0.0}, .d = 0.0},
    {.is_armed = 0U, .start = 0U, .k = 1U, .y = {0.7462546875}, .status = PTC_OK, .u = -0.00010823454627897538, .xhat = {0.75, 0.0, 0.0}, .d = 0.0},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {0.74251875}, .status = PTC_OK, .u = -0.1267619091596313, .xhat = {0.7513527612465957, -0.7600296471537633, 0.2833293297069995}, .d = -3.374670658297988e-7},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {(double)NAN}, .status = PTC_E_INPUT, .u = 0.0, .xhat = {0.7513527612465957, -0.7600296471537633, 0.2833293297069995}, .d = -3.374670658297988e-7},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {(double)INFINITY}, .status = PTC_E_INPUT, .u = 0.0, .xhat = {0.7513527612465957, -0.7600296471537633, 0.2833293297069995}, .d = -3.374670658297988e-7},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {-(double)INFINITY}, .status = PTC_E_INPUT, .u = 0.0, .xhat = {0.7513527612465957, -0.7600296471537633, 0.2833293297069995}, .d = -3.374670658297988e-7},
    {.is_armed = 0U, .start = 0U, .k = 3U, .y = {0.7387921875000001}, .status = PTC_OK, .u = -0.5512293285436006, .xhat = {0.7539550465984977, -2.2235483530233022, 0.828891016470475}, .d = -1.1554034916577487e-6},
    {.is_armed = 0U, .start = 0U, .k = 75U, .y = {0.4951171875}, .status = PTC_OK, .u = -1.4659769863242724, .xhat = {0.7576930041448596, -4.3749342636876785, 1.5688320904926756}, .d = -2.5983223987840157e-6},
    {.is_armed = 0U, .start = 0U, .k = 146U, .y = {0.30241875}, .status = PTC_OK, .u = -8.585748455993658, .xhat = {0.8212639799797788, -42.33146312566176, 15.454475116728489}, .d = -0.00038645393487303324},
    {.is_armed = 0U, .start = 0U, .k = 148U, .y = {0.297675}, .status = PTC_OK, .u = -21.965227922304155, .xhat = {0.8240635571746611, -66.32680839643142, 23.535687838794807}, .d = -0.010474090312011684},
    {.is_armed = 0U, .start = 0U, .k = 149U, .y = {0.2953171874999999}, .status = PTC_SATURATED, .u = -24.0, .xhat = {0.8076985826051389, -83.8153148234635, 25.729760728117505}, .d = -0.020708387653574578},
    {.is_armed = 0U, .start = 0U, .k = 150U, .y = {0.29296875}, .status = PTC_SATURATED, .u = -24.0, .xhat = {0.7728551961290947, -101.6953151172068, 21.686455905637715}, .d = -0.030670351070744464},
    {.is_armed = 0U, .start = 0U, .k = 151U, .y = {0.29062968750000007}, .status = PTC_SATURATED, .u = -24.0, .xhat = {0.7152427856460519, -121.98787376942508, 17.978316838163984}, .d = -0.04000053219442235},
    {.is_armed = 0U, .start = 0U, .k = 275U, .y = {0.0732421875}, .status = PTC_SATURATED, .u = -24.0, .xhat = {0.631322836631681, -141.84911166170895, 14.571819036147684}, .d = -0.048256062529036},
    {.is_armed = 0U, .start = 0U, .k = 396U, .y = {7.500000000000001e-5}, .status = PTC_HOLD, .u = -3.7954096690415606, .xhat = {0.5346542174380867, -175.97439146466348, 16.8699265604544}, .d = -0.059106532635077653},
    {.is_armed = 0U, .start = 0U, .k = 398U, .y = {1.8750000000000002e-5}, .status = PTC_HOLD, .u = 11.74193403722616, .xhat = {0.40378899299643417, -205.31589048932716, 17.802457624832993}, .d = -0.06950007669926983},
    {.is_armed = 0U, .start = 0U, .k = 399U, .y = {4.6875000000000004e-6}, .status = PTC_HOLD, .u = 22.017367241808323, .xhat = {0.23747636115511514, -216.65743110159755, 22.357769892235734}, .d = -0.0773503703049674},
    {.is_armed = 0U, .start = 0U, .k = 400U, .y = {0.0}, .status = PTC_SATURATED, .u = 24.0, .xhat = {0.05295712616291313, -204.72212051824133, 25.88139257023778}, .d = -0.08196740782460828},
    {.is_armed = 0U, .start = 0U, .k = 401U, .y = {0.0}, .status = PTC_SATURATED, .u = 24.0, .xhat = {-0.12902953348268478, -171.07316471043626, 26.080056127136817}, .d = -0.08299702552453499},
    {.is_armed = 0U, .start = 0U, .k = 2147483647U, .y = {0.0}, .status = PTC_SATURATED, .u = 24.0, .xhat = {-0.28962667187042235, -122.42450597058169, 21.20449420507507}, .d = -0.08048837180570656},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {0.0}, .status = PTC_HOLD, .u = 21.8786102712763, .xhat = {-0.41577442084905064, -66.93926171130877, 13.301340787318813}, .d = -0.07485731194019804},
    {.is_armed = 1U, .start = 4294967293U, .k = 4294967293U, .y = {0.75}, .status = PTC_SATURATED, .u = 24.0, .xhat = {-0.5001710516138522, -10.828089296226825, 4.696221484989429}, .d = -0.06677362738439302},
    {.is_armed = 0U, .start = 0U, .k = 4294967294U, .y = {0.7462546875}, .status = PTC_SATURATED, .u = 24.0, .xhat = {-0.9581390459653457, 255.4696904090955, -83.92368155516532}, .d = -0.0666639860353561},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {0.74251875}, .status = PTC_SATURATED, .u = 24.0, .xhat = {-1.3685160614670446, 511.95461490967386, -168.26849017256063}, .d = -0.06651041360254809},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {(double)NAN}, .status = PTC_E_INPUT, .u = 0.0, .xhat = {-1.3685160614670446, 511.95461490967386, -168.26849017256063}, .d = -0.06651041360254809},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {(double)INFINITY}, .status = PTC_E_INPUT, .u = 0.0, .xhat = {-1.3685160614670446, 511.95461490967386, -168.26849017256063}, .d = -0.06651041360254809},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {-(double)INFINITY}, .status = PTC_E_INPUT, .u = 0.0, .xhat = {-1.3685160614670446, 511.95461490967386, -168.26849017256063}, .d = -0.06651041360254809},
    {.is_armed = 0U, .start = 0U, .k = 0U, .y = {0.7387921875000001}, .status = PTC_SATURATED, .u = 24.0, .xhat = {-1.7208419127961776, 752.8755245706063, -247.2581756174384}, .d = -0.06631495400664196},
    {.is_armed = 0U, .start = 0U, .k = 72U, .y = {0.4951171875}, .status = PTC_SATURATED, .u = 24.0, .xhat = {-2.005818127298461, 972.3418330305759, -318.6789309562404}, .d = -0.06608089178098417},
    {.is_armed = 0U, .start = 0U, .k = 143U, .y = {0.30241875}, .status = PTC_SATURATED, .u = 24.0, .xhat = {-1.8698270107164545, 989.3054801733488, -315.0399388608535}, .d = -0.062424812293973134},
    {.is_armed = 0U, .start = 0U, .k = 145U, .y = {0.297675}, .status = PTC_SATURATED, .u = 24.0, .xhat = {-1.2252991791704628, 806.0871509931555, -236.4775071639016}, .d = -0.02019097435979275},
    {.is_armed = 0U, .start = 0U, .k = 146U, .y = {0.2953171874999999}, .status = PTC_SATURATED, .u = 24.0, .xhat = {-0.6702066729795729, 661.2311302656208, -172.80697406716573}, .d = 0.009419415875155726},
    {.is_armed = 0U, .start = 0U, .k = 147U, .y = {0.29296875}, .status = PTC_SATURATED, .u = 24.0, .xhat = {-0.18183445071888021, 544.9399959967512, -120.32978096944726}, .d = 0.028191591189070973},
    {.is_armed = 0U, .start = 0U, .k = 148U, .y = {0.29062968750000007}, .status = PTC_SATURATED, .u = 24.0, .xhat = {0.25677887784691644, 449.6697271170183, -76.19622583288658}, .d = 0.03742294143149357},
    {.is_armed = 0U, .start = 0U, .k = 272U, .y = {0.0732421875}, .status = PTC_SATURATED, .u = 24.0, .xhat = {0.6580037278826802, 369.8013032626132, -38.28040537527626}, .d = 0.038081085014822554},
    {.is_armed = 0U, .start = 0U, .k = 393U, .y = {7.500000000000001e-5}, .status = PTC_SATURATED, .u = -24.0, .xhat = {1.045521929594873, 284.04811291137725, 1.314280599089777}, .d = 0.026711872298063342},
    {.is_armed = 0U, .start = 0U, .k = 395U, .y = {1.8750000000000002e-5}, .status = PTC_SATURATED, .u = -24.0, .xhat = {1.4036775949165632, 206.9266280019166, 37.23880378952811}, .d = 0.006385794562396064},
    {.is_armed = 0U, .start = 0U, .k = 396U, .y = {4.6875000000000004e-6}, .status = PTC_SATURATED, .u = -24.0, .xhat = {1.7265814872179683, 127.53497579127273, 50.08533850213689}, .d = -0.02090481004743063},
    {.is_armed = 0U, .start = 0U, .k = 397U, .y = {0.0}, .status = PTC_SATURATED, .u = -24.0, .xhat = {2.0004610063158417, 37.628443369176864, 67.40804992180588}, .d = -0.054473739520748556},
    {.is_armed = 0U, .start = 0U, .k = 398U, .y = {0.0}, .status = PTC_SATURATED, .u = -24.0, .xhat = {2.2142449912794753, -53.75845805435689, 85.82832261758514}, .d = -0.09336765634281427},
    {.is_armed = 0U, .start = 0U, .k = 2147483644U, .y = {0.0}, .status = PTC_SATURATED, .u = -24.0, .xhat = {2.3630156996000395, -140.5937546673312, 103.09130970356435}, .d = -0.1364180633453002},
    {.is_armed = 0U, .start = 0U, .k = 4294967292U, .y = {0.0}, .status = PTC_SATURATED, .u = -24.0, .xhat = {2.446134153806112, -219.04609212701723, 117.76497758700668}, .d = -0.18236094140156395},
    {.is_armed = 0U, .start = 0U, .k = 58U, .y = {7.1200186866681e153}, .status = PTC_SATURATED, .u = -24.0, .xhat = {7.1200186866681e153, 0.0, 0.0}, .d = 0.0},
    {.is_armed = 1U, .start = 4294967290U, .k = 303U, .y = {8.967500654424333e153}, .status = PTC_SATURATED, .u = -24.0, .xhat = {8.967500654424333e153, 0.0, 0.0}, .d = 0.0},
    {.is_armed = 1U, .start = 0U, .k = 88U, .y = {1.6834135823229552e302}, .status = PTC_E_RANGE, .u = 0.0, .xhat = {0.0, 0.0, 0.0}, .d = 0.0},
};

/* 1 where a number is not the one that must come. */
static uint32_t motor_selftest_differs(double value, double wanted)
{
    uint32_t failures = 1U;

    if (fabs(value - wanted) <= 0.0) {
        failures = 0U;
    }
    return failures;
}

/* The failures of one call. */
static uint32_t motor_selftest_check(motor *self, const motor_selftest_call *call)
{
    uint32_t failures = 0U;
    double u = 12345.0;
    double xhat[3] = {12345.0, 12345.0, 12345.0};
    double d = 12345.0;

    if (call->is_armed != 0U) {
        if (motor_arm(self, call->start) != PTC_OK) {
            failures++;
        }
    }
    if (motor_step(self, call->k, call->y, &u) != call->status) {
        failures++;
    }
    failures += motor_selftest_differs(u, call->u);
    if (motor_estimate(self, xhat) != PTC_OK) {
        failures++;
    }
    for (uint32_t i = 0U; i < 3U; i++) {
        failures += motor_selftest_differs(xhat[i], call->xhat[i]);
    }
    if (motor_disturbance(self, &d) != PTC_OK) {
        failures++;
    }
    failures += motor_selftest_differs(d, call->d);
    return failures;
}

/* The calls of a session, of which init has been called. */
static uint32_t motor_selftest_calls_of(motor *self, const motor_selftest_session *session)
{
    uint32_t failures = 0U;

    for (uint32_t j = 0U; j < session->count; j++) {
        failures += motor_selftest_check(self, &motor_selftest_calls[session->first + j]);
    }
    return failures;
}

/* Every session with its calls. */
static uint32_t motor_selftest_run(void)
{
    uint32_t failures = 0U;

    for (uint32_t i = 0U; i < 3U; i++) {
        const motor_selftest_session *session = &motor_selftest_sessions[i];
        motor self;

        if (motor_init(&self, &session->params) == PTC_OK) {
            failures += motor_selftest_calls_of(&self, session);
        } else {
            failures++;
        }
    }
    return failures;
}

/* What init must refuse without a change. */
static uint32_t motor_selftest_refuse(void)
{
    const motor_selftest_session *session = &motor_selftest_sessions[0];
    uint32_t failures = 0U;
    motor self;

    if (motor_init(&self, &session->params) != PTC_OK) {
        failures++;
    }
    if (motor_init(NULL, &session->params) != PTC_E_PARAM) {
        failures++;
    }
    failures += motor_selftest_calls_of(&self, session);
    return failures;
}

/* Calls that lack a pointer: each is refused, and changes nothing. */
static uint32_t motor_selftest_pointers(void)
{
    const motor_selftest_session *session = &motor_selftest_sessions[0];
    const motor_selftest_call *call = &motor_selftest_calls[0];
    uint32_t failures = 0U;
    double u = 12345.0;
    double xhat[3];
    double d;
    motor self;

    if (motor_init(&self, &session->params) != PTC_OK) {
        failures++;
    }
    if (motor_arm(NULL, call->start) != PTC_E_INPUT) {
        failures++;
    }
    if (motor_step(NULL, call->k, call->y, &u) != PTC_E_INPUT) {
        failures++;
    }
    failures += motor_selftest_differs(u, 0.0);
    u = 12345.0;
    if (motor_step(&self, call->k, NULL, &u) != PTC_E_INPUT) {
        failures++;
    }
    failures += motor_selftest_differs(u, 0.0);
    if (motor_step(&self, call->k, call->y, NULL) != PTC_E_INPUT) {
        failures++;
    }
    if (motor_estimate(NULL, xhat) != PTC_E_INPUT) {
        failures++;
    }
    if (motor_estimate(&self, NULL) != PTC_E_INPUT) {
        failures++;
    }
    if (motor_disturbance(NULL, &d) != PTC_E_INPUT) {
        failures++;
    }
    if (motor_disturbance(&self, NULL) != PTC_E_INPUT) {
        failures++;
    }
    failures += motor_selftest_calls_of(&self, session);
    return failures;
}

uint32_t motor_selftest(void)
{
    uint32_t failures = motor_selftest_run();

    failures += motor_selftest_refuse();
    failures += motor_selftest_pointers();
    return failures;
}
