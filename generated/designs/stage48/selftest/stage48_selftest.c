/* Self-test of the prescribed-time controller stage48: see stage48_selftest.h. DO NOT EDIT. */
#include "stage48_selftest.h"
#include "stage48.h"

#include <math.h>
#include <stddef.h>

/* A call, and what it must give. */
typedef struct stage48_selftest_call {
    uint32_t is_armed; /* arm is called before it */
    uint32_t start;
    uint32_t k;
    double y[1]; /* what is measured */
    ptc_status status;
    double u;
    double xhat[3]; /* the estimates behind it */
    double d;
} stage48_selftest_call;

/* A set of parameters that init takes, and the calls with it, one after the other. */
typedef struct stage48_selftest_session {
    stage48_params params;
    uint32_t first; /* of its calls */
    uint32_t count;
} stage48_selftest_session;

static const stage48_selftest_session stage48_selftest_sessions[5] = {
    {.params = {.none = (char)0}, .first = 0U, .count = 42U},
    {.params = {.none = (char)0}, .first = 42U, .count = 4U},
    {.params = {.none = (char)0}, .first = 46U, .count = 2U},
    {.params = {.none = (char)0}, .first = 48U, .count = 1U},
    {.params = {.none = (char)0}, .first = 49U, .count = 2U},
};

static const stage48_selftest_call stage48_selftest_calls[51] = {
    {.is_armed = 0U, .start = 0U, .k = 0U, .y = {0.75}, .status = PTC_OK, .u = -0.4619925944461758, .xhat = {0.75, 0.0, 0.0}, .d = 0.0},
    {.is_armed = 0U, .start = 0U, .k = 1U, .y = {0.7350749999999999}, .status = PTC_OK, .u = -0.4609966559972349, .xhat = {0.75, 0.0, 0.0}, .d = 0.0},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {0.7202999999999999}, .status = PTC_OK, .u = -0.459108971810263, .xhat = {0.7521132565821532, -1.598532483532148, 0.48034386545914104}, .d = -0.00012516498237066196},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {(double)NAN}, .status = PTC_E_INPUT, .u = 0.0, .xhat = {0.7521132565821532, -1.598532483532148, 0.48034386545914104}, .d = -0.00012516498237066196},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {(double)INFINITY}, .status = PTC_E_INPUT, .u = 0.0, .xhat = {0.7521132565821532, -1.598532483532148, 0.48034386545914104}, .d = -0.00012516498237066196},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {-(double)INFINITY}, .status = PTC_E_INPUT, .u = 0.0, .xhat = {0.7521132565821532, -1.598532483532148, 0.48034386545914104}, .d = -0.00012516498237066196},
    {.is_armed = 0U, .start = 0U, .k = 3U, .y = {0.7056749999999999}, .status = PTC_OK, .u = -0.45719559367622903, .xhat = {0.7550699614302784, -4.431131828797046, 1.3116384366569882}, .d = -0.00041567438756503155},
    {.is_armed = 0U, .start = 0U, .k = 25U, .y = {0.421875}, .status = PTC_OK, .u = -0.7221943461010899, .xhat = {0.7577458834736833, -7.969676878500284, 2.4131046823855145}, .d = -0.0009077402999217964},
    {.is_armed = 0U, .start = 0U, .k = 46U, .y = {0.2187}, .status = PTC_OK, .u = -1.0717919942385772, .xhat = {0.6936698301919568, -14.463413834729979, 3.703992265019313}, .d = -0.04808493351441659},
    {.is_armed = 0U, .start = 0U, .k = 48U, .y = {0.20280000000000004}, .status = PTC_SATURATED, .u = 24.0, .xhat = {-0.9958313343627181, -1625.6895068635515, -571.3535675611356}, .d = -843.9972588278475},
    {.is_armed = 0U, .start = 0U, .k = 49U, .y = {0.195075}, .status = PTC_SATURATED, .u = -24.0, .xhat = {1.1720988775709675, 1563.4080034906106, 839.2548109608588}, .d = 1285.788382568473},
    {.is_armed = 0U, .start = 0U, .k = 50U, .y = {0.1875}, .status = PTC_SATURATED, .u = 24.0, .xhat = {-0.06156938421421679, -432.1846976374432, -255.93766604964196}, .d = -450.23450128041213},
    {.is_armed = 0U, .start = 0U, .k = 51U, .y = {0.18007499999999999}, .status = PTC_OK, .u = 7.801963907960131, .xhat = {0.18214600516114213, -4.383016423031881, -3.062075442456953}, .d = -7.676074011449771},
    {.is_armed = 0U, .start = 0U, .k = 75U, .y = {0.046875}, .status = PTC_OK, .u = 14.069484737810336, .xhat = {0.1658403421439914, -20.545071592901255, -5.61560812900499}, .d = -11.355935307419742},
    {.is_armed = 0U, .start = 0U, .k = 96U, .y = {0.0012000000000000001}, .status = PTC_SATURATED, .u = 24.0, .xhat = {-0.2770931020765724, -428.71301904246235, -145.1548855785476}, .d = -222.73926082075135},
    {.is_armed = 0U, .start = 0U, .k = 98U, .y = {0.00030000000000000003}, .status = PTC_SATURATED, .u = -24.0, .xhat = {0.1654810003793932, 292.89395326449596, 182.98761982665624}, .d = 271.74526991901143},
    {.is_armed = 0U, .start = 0U, .k = 99U, .y = {7.500000000000001e-5}, .status = PTC_HOLD, .u = 10.102965343226753, .xhat = {0.01832310751279723, 23.11508998956081, 5.581839615251888}, .d = -21.756253655420267},
    {.is_armed = 0U, .start = 0U, .k = 100U, .y = {0.0}, .status = PTC_SATURATED, .u = 24.0, .xhat = {-0.020084303936919474, -36.2863130916103, -28.78074561670804}, .d = -54.1803662655542},
    {.is_armed = 0U, .start = 0U, .k = 101U, .y = {0.0}, .status = PTC_SATURATED, .u = 24.0, .xhat = {-0.011089080320459004, -21.251313337479427, -12.854379019944433}, .d = -18.493611784842074},
    {.is_armed = 0U, .start = 0U, .k = 2147483647U, .y = {0.0}, .status = PTC_SATURATED, .u = -24.0, .xhat = {-0.0017663208209913938, 0.8135228502587566, 6.521713038516565}, .d = 1.2099979621539454},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {0.0}, .status = PTC_SATURATED, .u = -24.0, .xhat = {0.0120446045767919, 21.939952666451983, 15.095791474112161}, .d = 4.348481509847057},
    {.is_armed = 1U, .start = 4294967293U, .k = 4294967293U, .y = {0.75}, .status = PTC_OK, .u = 18.45992601764434, .xhat = {0.0030844547225257844, 2.4135874384507345, -6.3524808720024435}, .d = -17.052949562857663},
    {.is_armed = 0U, .start = 0U, .k = 4294967294U, .y = {0.7350749999999999}, .status = PTC_OK, .u = 18.42904654501456, .xhat = {-0.11385237707705444, 62.38143705810431, -48.54998444462032}, .d = -17.047186838745606},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {0.7202999999999999}, .status = PTC_OK, .u = 18.391040288600898, .xhat = {-0.20613898925102145, 86.82583647900735, -66.18235832135913}, .d = -17.04006751008994},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {(double)NAN}, .status = PTC_E_INPUT, .u = 0.0, .xhat = {-0.20613898925102145, 86.82583647900735, -66.18235832135913}, .d = -17.04006751008994},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {(double)INFINITY}, .status = PTC_E_INPUT, .u = 0.0, .xhat = {-0.20613898925102145, 86.82583647900735, -66.18235832135913}, .d = -17.04006751008994},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {-(double)INFINITY}, .status = PTC_E_INPUT, .u = 0.0, .xhat = {-0.20613898925102145, 86.82583647900735, -66.18235832135913}, .d = -17.04006751008994},
    {.is_armed = 0U, .start = 0U, .k = 0U, .y = {0.7056749999999999}, .status = PTC_OK, .u = 18.348488778520732, .xhat = {-0.285708922181005, 106.55757879578024, -71.4064260970355}, .d = -17.03160753872482},
    {.is_armed = 0U, .start = 0U, .k = 22U, .y = {0.421875}, .status = PTC_OK, .u = 18.93629285534571, .xhat = {-0.35060333937806076, 124.32578501292592, -75.97418858993107}, .d = -17.02173150643249},
    {.is_armed = 0U, .start = 0U, .k = 43U, .y = {0.2187}, .status = PTC_OK, .u = 19.54839724153701, .xhat = {-0.14115471625825485, 59.198326053877416, -47.71558199646488}, .d = -16.91322743041988},
    {.is_armed = 0U, .start = 0U, .k = 45U, .y = {0.20280000000000004}, .status = PTC_SATURATED, .u = -24.0, .xhat = {1.1592739682113489, 1229.3556441249932, 408.5090715299217}, .d = 622.4938910920246},
    {.is_armed = 0U, .start = 0U, .k = 46U, .y = {0.195075}, .status = PTC_SATURATED, .u = 24.0, .xhat = {-0.6712009803612273, -1378.127440691976, -706.7520147423146}, .d = -1077.0149282306052},
    {.is_armed = 0U, .start = 0U, .k = 47U, .y = {0.1875}, .status = PTC_SATURATED, .u = -24.0, .xhat = {0.46231038501762367, 456.6104796604977, 273.0372282432692}, .d = 462.2257803737575},
    {.is_armed = 0U, .start = 0U, .k = 48U, .y = {0.18007499999999999}, .status = PTC_SATURATED, .u = 24.0, .xhat = {0.16391161320944544, -36.05305758822853, -14.534693140671086}, .d = -26.070491664142935},
    {.is_armed = 0U, .start = 0U, .k = 72U, .y = {0.046875}, .status = PTC_OK, .u = -7.379990795211434, .xhat = {0.1751492411279953, -1.7789331138536668, 0.9142988789044413}, .d = 2.649389183257636},
    {.is_armed = 0U, .start = 0U, .k = 93U, .y = {0.0012000000000000001}, .status = PTC_SATURATED, .u = 24.0, .xhat = {-0.2806615991222236, -439.51556575025876, -151.94848758752167}, .d = -225.27443450074898},
    {.is_armed = 0U, .start = 0U, .k = 95U, .y = {0.00030000000000000003}, .status = PTC_SATURATED, .u = -24.0, .xhat = {0.16047689217340302, 287.7287492131891, 180.73358827822966}, .d = 275.55077293526756},
    {.is_armed = 0U, .start = 0U, .k = 96U, .y = {7.500000000000001e-5}, .status = PTC_SATURATED, .u = -24.0, .xhat = {0.02285155065765554, 28.850564013769244, 8.478935571941928}, .d = -9.059211181139062},
    {.is_armed = 0U, .start = 0U, .k = 97U, .y = {0.0}, .status = PTC_SATURATED, .u = 24.0, .xhat = {-0.022666145767855545, -38.82454256720633, -27.986749837319188}, .d = -49.529678755726366},
    {.is_armed = 0U, .start = 0U, .k = 98U, .y = {0.0}, .status = PTC_SATURATED, .u = 24.0, .xhat = {-0.00658332277780893, -15.551452808021384, -14.89666696895445}, .d = -9.255383884367276},
    {.is_armed = 0U, .start = 0U, .k = 2147483644U, .y = {0.0}, .status = PTC_HOLD, .u = -13.31604613809304, .xhat = {-0.010950645805034064, -15.955686511791365, -2.041204618102718}, .d = 2.4421797641831304},
    {.is_armed = 0U, .start = 0U, .k = 4294967292U, .y = {0.0}, .status = PTC_SATURATED, .u = -24.0, .xhat = {0.01341776566375557, 27.33135408991994, 22.196625374804483}, .d = 21.899812424836373},
    {.is_armed = 0U, .start = 0U, .k = 40U, .y = {0.41557978200491275}, .status = PTC_OK, .u = -0.6767684114560226, .xhat = {0.41557978200491275, 0.0, 0.0}, .d = 0.0},
    {.is_armed = 0U, .start = 0U, .k = 41U, .y = {-0.9153750930692888}, .status = PTC_OK, .u = -0.6703354897422826, .xhat = {0.41557978200491275, 0.0, 0.0}, .d = 0.0},
    {.is_armed = 0U, .start = 0U, .k = 42U, .y = {0.9556294748061022}, .status = PTC_SATURATED, .u = 24.0, .xhat = {-1.3269243203116563, -331.16554205576995, -77.81258778726352}, .d = -1051.0686465711804},
    {.is_armed = 1U, .start = 0U, .k = 75U, .y = {1.6411694637989592e308}, .status = PTC_E_RANGE, .u = 0.0, .xhat = {-1.3269243203116563, -331.16554205576995, -77.81258778726352}, .d = -1051.0686465711804},
    {.is_armed = 1U, .start = 0U, .k = 32U, .y = {-1.1836820563898388e308}, .status = PTC_SATURATED, .u = 24.0, .xhat = {-1.1836820563898388e308, 0.0, 0.0}, .d = 0.0},
    {.is_armed = 1U, .start = 0U, .k = 11U, .y = {1.747531063070313e308}, .status = PTC_SATURATED, .u = -24.0, .xhat = {1.747531063070313e308, 0.0, 0.0}, .d = 0.0},
    {.is_armed = 0U, .start = 0U, .k = 100U, .y = {-8.138362211066612e307}, .status = PTC_E_RANGE, .u = 0.0, .xhat = {0.0, 0.0, 0.0}, .d = 0.0},
    {.is_armed = 0U, .start = 0U, .k = 3U, .y = {-1.5001312656481674e308}, .status = PTC_SATURATED, .u = 24.0, .xhat = {-1.5001312656481674e308, 0.0, 0.0}, .d = 0.0},
    {.is_armed = 0U, .start = 0U, .k = 28U, .y = {-1.3632050320359267e308}, .status = PTC_E_RANGE, .u = 0.0, .xhat = {-1.5001312656481674e308, 0.0, 0.0}, .d = 0.0},
};

/* 1 where a number is not the one that must come. */
static uint32_t stage48_selftest_differs(double value, double wanted)
{
    uint32_t failures = 1U;

    if (fabs(value - wanted) <= 0.0) {
        failures = 0U;
    }
    return failures;
}

/* The failures of one call. */
static uint32_t stage48_selftest_check(stage48 *self, const stage48_selftest_call *call)
{
    uint32_t failures = 0U;
    double u = 12345.0;
    double xhat[3] = {12345.0, 12345.0, 12345.0};
    double d = 12345.0;

    if (call->is_armed != 0U) {
        if (stage48_arm(self, call->start) != PTC_OK) {
            failures++;
        }
    }
    if (stage48_step(self, call->k, call->y, &u) != call->status) {
        failures++;
    }
    failures += stage48_selftest_differs(u, call->u);
    if (stage48_estimate(self, xhat) != PTC_OK) {
        failures++;
    }
    for (uint32_t i = 0U; i < 3U; i++) {
        failures += stage48_selftest_differs(xhat[i], call->xhat[i]);
    }
    if (stage48_disturbance(self, &d) != PTC_OK) {
        failures++;
    }
    failures += stage48_selftest_differs(d, call->d);
    return failures;
}

/* The calls of a session, of which init has been called. */
static uint32_t stage48_selftest_calls_of(stage48 *self, const stage48_selftest_session *session)
{
    uint32_t failures = 0U;

    for (uint32_t j = 0U; j < session->count; j++) {
        failures += stage48_selftest_check(self, &stage48_selftest_calls[session->first + j]);
    }
    return failures;
}

/* Every session with its calls. */
static uint32_t stage48_selftest_run(void)
{
    uint32_t failures = 0U;

    for (uint32_t i = 0U; i < 5U; i++) {
        const stage48_selftest_session *session = &stage48_selftest_sessions[i];
        stage48 self;

        if (stage48_init(&self, &session->params) == PTC_OK) {
            failures += stage48_selftest_calls_of(&self, session);
        } else {
            failures++;
        }
    }
    return failures;
}

/* What init must refuse without a change. */
static uint32_t stage48_selftest_refuse(void)
{
    const stage48_selftest_session *session = &stage48_selftest_sessions[0];
    uint32_t failures = 0U;
    stage48 self;

    if (stage48_init(&self, &session->params) != PTC_OK) {
        failures++;
    }
    if (stage48_init(NULL, &session->params) != PTC_E_PARAM) {
        failures++;
    }
    failures += stage48_selftest_calls_of(&self, session);
    return failures;
}

/* Calls that lack a pointer: each is refused, and changes nothing. */
static uint32_t stage48_selftest_pointers(void)
{
    const stage48_selftest_session *session = &stage48_selftest_sessions[0];
    const stage48_selftest_call *call = &stage48_selftest_calls[0];
    uint32_t failures = 0U;
    double u = 12345.0;
    double xhat[3];
    double d;
    stage48 self;

    if (stage48_init(&self, &session->params) != PTC_OK) {
        failures++;
    }
    if (stage48_arm(NULL, call->start) != PTC_E_INPUT) {
        failures++;
    }
    if (stage48_step(NULL, call->k, call->y, &u) != PTC_E_INPUT) {
        failures++;
    }
    failures += stage48_selftest_differs(u, 0.0);
    u = 12345.0;
    if (stage48_step(&self, call->k, NULL, &u) != PTC_E_INPUT) {
        failures++;
    }
    failures += stage48_selftest_differs(u, 0.0);
    if (stage48_step(&self, call->k, call->y, NULL) != PTC_E_INPUT) {
        failures++;
    }
    if (stage48_estimate(NULL, xhat) != PTC_E_INPUT) {
        failures++;
    }
    if (stage48_estimate(&self, NULL) != PTC_E_INPUT) {
        failures++;
    }
    if (stage48_disturbance(NULL, &d) != PTC_E_INPUT) {
        failures++;
    }
    if (stage48_disturbance(&self, NULL) != PTC_E_INPUT) {
        failures++;
    }
    failures += stage48_selftest_calls_of(&self, session);
    return failures;
}

uint32_t stage48_selftest(void)
{
    uint32_t failures = stage48_selftest_run();

    failures += stage48_selftest_refuse();
    failures += stage48_selftest_pointers();
    return failures;
}
