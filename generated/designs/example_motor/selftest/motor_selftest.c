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

static const motor_selftest_session motor_selftest_sessions[6] = {
    {.params = {.none = (char)0}, .first = 0U, .count = 42U},
    {.params = {.none = (char)0}, .first = 42U, .count = 4U},
    {.params = {.none = (char)0}, .first = 46U, .count = 2U},
    {.params = {.none = (char)0}, .first = 48U, .count = 2U},
    {.params = {.none = (char)0}, .first = 50U, .count = 2U},
    {.params = {.none = (char)0}, .first = 52U, .count = 2U},
};

static const motor_selftest_call motor_selftest_calls[54] = {
    {.is_armed = 0U, .start = 0U, .k = 0U, .y = {0.75}, .status = PTC_OK, .u = -0.1725314469490965, .xhat = {0.75, 0.0, 0.0}, .d = 0.0},
    {.is_armed = 0U, .start = 0U, .k = 1U, .y = {0.7462546875}, .status = PTC_OK, .u = -0.17168458723235727, .xhat = {0.75, 0.0, 0.0}, .d = 0.0},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {0.74251875}, .status = PTC_OK, .u = -0.1708353383034287, .xhat = {0.7513341044761326, -0.8133994853701138, 0.2187173193894837}, .d = -3.3746706582979886e-7},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {(double)NAN}, .status = PTC_E_INPUT, .u = 0.0, .xhat = {0.7513341044761326, -0.8133994853701138, 0.2187173193894837}, .d = -3.3746706582979886e-7},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {(double)INFINITY}, .status = PTC_E_INPUT, .u = 0.0, .xhat = {0.7513341044761326, -0.8133994853701138, 0.2187173193894837}, .d = -3.3746706582979886e-7},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {-(double)INFINITY}, .status = PTC_E_INPUT, .u = 0.0, .xhat = {0.7513341044761326, -0.8133994853701138, 0.2187173193894837}, .d = -3.3746706582979886e-7},
    {.is_armed = 0U, .start = 0U, .k = 3U, .y = {0.7387921875000001}, .status = PTC_OK, .u = -0.16998300966631605, .xhat = {0.7538179394691632, -2.398294677331472, 0.728842369746718}, .d = -1.1536760711548656e-6},
    {.is_armed = 0U, .start = 0U, .k = 75U, .y = {0.4951171875}, .status = PTC_OK, .u = -0.2079570000846104, .xhat = {0.7572657600949928, -4.646293318814498, 1.4898056543560092}, .d = -2.583547671837581e-6},
    {.is_armed = 0U, .start = 0U, .k = 146U, .y = {0.30241875}, .status = PTC_OK, .u = -0.2677716810533032, .xhat = {0.8204496092296476, -42.50656849424967, 15.533544310555381}, .d = -0.0003858145785355899},
    {.is_armed = 0U, .start = 0U, .k = 148U, .y = {0.297675}, .status = PTC_OK, .u = -0.23828205705536415, .xhat = {0.8232038520414203, -65.9572688946124, 24.027761839388848}, .d = -0.010457617571210397},
    {.is_armed = 0U, .start = 0U, .k = 149U, .y = {0.2953171874999999}, .status = PTC_OK, .u = -0.20722203098295974, .xhat = {0.8083523846548474, -80.2544005964037, 29.082504274669628}, .d = -0.02067520011561494},
    {.is_armed = 0U, .start = 0U, .k = 150U, .y = {0.29296875}, .status = PTC_OK, .u = -0.17692159526027607, .xhat = {0.781527131971849, -87.73199190239517, 31.618915768799035}, .d = -0.030649875064006463},
    {.is_armed = 0U, .start = 0U, .k = 151U, .y = {0.29062968750000007}, .status = PTC_OK, .u = -0.14805021069099075, .xhat = {0.7471438833818007, -90.33115302813648, 32.364345463162834}, .d = -0.04014866009962739},
    {.is_armed = 0U, .start = 0U, .k = 275U, .y = {0.0732421875}, .status = PTC_OK, .u = -0.3843855144886287, .xhat = {0.7084367757017476, -89.50915940627281, 31.863213077380692}, .d = -0.04902442678873607},
    {.is_armed = 0U, .start = 0U, .k = 396U, .y = {7.500000000000001e-5}, .status = PTC_HOLD, .u = -15.735109630108784, .xhat = {0.6824932469290228, -103.48121356079243, 36.84043949326162}, .d = -0.06137418287063218},
    {.is_armed = 0U, .start = 0U, .k = 398U, .y = {1.8750000000000002e-5}, .status = PTC_HOLD, .u = -8.222555003431268, .xhat = {0.6489178369965101, -115.56248384769948, 40.985553637926124}, .d = -0.07464208384451737},
    {.is_armed = 0U, .start = 0U, .k = 399U, .y = {4.6875000000000004e-6}, .status = PTC_HOLD, .u = -2.8984492029112565, .xhat = {0.6019081990192907, -124.95324642266206, 36.62455234726498}, .d = -0.08725828932709098},
    {.is_armed = 0U, .start = 0U, .k = 400U, .y = {0.0}, .status = PTC_HOLD, .u = 0.7009656606622483, .xhat = {0.5404305618728961, -133.08851065938717, 35.798369481563455}, .d = -0.09896078442098658},
    {.is_armed = 0U, .start = 0U, .k = 401U, .y = {0.0}, .status = PTC_HOLD, .u = 2.954682801609151, .xhat = {0.46669412983597364, -135.53327094136907, 35.62633680948054}, .d = -0.10946809311394493},
    {.is_armed = 0U, .start = 0U, .k = 2147483647U, .y = {0.0}, .status = PTC_HOLD, .u = 4.177534478804375, .xhat = {0.38574698143107583, -131.16494327223697, 34.73846091344658}, .d = -0.1185417829333809},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {0.0}, .status = PTC_HOLD, .u = 4.636054218709784, .xhat = {0.3032955626819496, -120.69609586942005, 32.671199830856615}, .d = -0.12604165969317535},
    {.is_armed = 1U, .start = 4294967293U, .k = 4294967293U, .y = {0.75}, .status = PTC_OK, .u = 0.24018842652983666, .xhat = {0.22447475794225993, -105.71007475895051, 29.467344811851078}, .d = -0.13193847665197136},
    {.is_armed = 0U, .start = 0U, .k = 4294967294U, .y = {0.7462546875}, .status = PTC_OK, .u = 0.23940539297141045, .xhat = {-0.052333749490122844, 36.665223279199495, -21.00970120727942}, .d = -0.13189238752167373},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {0.74251875}, .status = PTC_OK, .u = 0.23848310050737379, .xhat = {-0.31722774897023226, 174.78973137082522, -72.15799428190171}, .d = -0.13182043163104065},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {(double)NAN}, .status = PTC_E_INPUT, .u = 0.0, .xhat = {-0.31722774897023226, 174.78973137082522, -72.15799428190171}, .d = -0.13182043163104065},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {(double)INFINITY}, .status = PTC_E_INPUT, .u = 0.0, .xhat = {-0.31722774897023226, 174.78973137082522, -72.15799428190171}, .d = -0.13182043163104065},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {-(double)INFINITY}, .status = PTC_E_INPUT, .u = 0.0, .xhat = {-0.31722774897023226, 174.78973137082522, -72.15799428190171}, .d = -0.13182043163104065},
    {.is_armed = 0U, .start = 0U, .k = 0U, .y = {0.7387921875000001}, .status = PTC_OK, .u = 0.237421509760456, .xhat = {-0.5696904761253926, 306.6862870533026, -120.99698692879568}, .d = -0.1317223102635831},
    {.is_armed = 0U, .start = 0U, .k = 72U, .y = {0.4951171875}, .status = PTC_OK, .u = 0.26023951491027986, .xhat = {-0.8096385590024882, 432.29113486199753, -167.50253924808135}, .d = -0.13159779322080592},
    {.is_armed = 0U, .start = 0U, .k = 143U, .y = {0.30241875}, .status = PTC_OK, .u = 0.2896159693078937, .xhat = {-0.8155253746074804, 436.6446173123892, -168.8278759823888}, .d = -0.12969039054144796},
    {.is_armed = 0U, .start = 0U, .k = 145U, .y = {0.297675}, .status = PTC_OK, .u = 0.22741179159485303, .xhat = {-0.5615270136654364, 331.7699759266954, -129.07649436247777}, .d = -0.10795478776942602},
    {.is_armed = 0U, .start = 0U, .k = 146U, .y = {0.2953171874999999}, .status = PTC_OK, .u = 0.1789336795453067, .xhat = {-0.36968967937344976, 251.9911635631232, -98.76266363827813}, .d = -0.0912497725017709},
    {.is_armed = 0U, .start = 0U, .k = 147U, .y = {0.29296875}, .status = PTC_OK, .u = 0.14133871552700022, .xhat = {-0.22528199303679125, 191.57029326119766, -75.7712438047733}, .d = -0.07832039188169454},
    {.is_armed = 0U, .start = 0U, .k = 148U, .y = {0.29062968750000007}, .status = PTC_OK, .u = 0.11199645741002451, .xhat = {-0.11679686031829428, 145.87246064527153, -58.35043728629158}, .d = -0.06824431380318774},
    {.is_armed = 0U, .start = 0U, .k = 272U, .y = {0.0732421875}, .status = PTC_OK, .u = 0.12395778668060409, .xhat = {-0.03547298223059065, 111.35921149695717, -45.16268909427873}, .d = -0.06032293257560273},
    {.is_armed = 0U, .start = 0U, .k = 393U, .y = {7.500000000000001e-5}, .status = PTC_HOLD, .u = -3.0700298351368556, .xhat = {0.040100002983206234, 68.2049861538205, -28.868567825926874}, .d = -0.058209240403924},
    {.is_armed = 0U, .start = 0U, .k = 395U, .y = {1.8750000000000002e-5}, .status = PTC_HOLD, .u = -1.6623943469295586, .xhat = {0.09295368897037232, 31.93811336065173, -15.189497697584256}, .d = -0.05898742559819515},
    {.is_armed = 0U, .start = 0U, .k = 396U, .y = {4.6875000000000004e-6}, .status = PTC_HOLD, .u = -0.5035131325240095, .xhat = {0.12141477991765567, 6.191890165484658, -7.020886717969712}, .d = -0.060794310998493084},
    {.is_armed = 0U, .start = 0U, .k = 397U, .y = {0.0}, .status = PTC_HOLD, .u = 0.3778548127103596, .xhat = {0.13137922199159233, -11.958026607324427, -0.9474127798876045}, .d = -0.0631548239107383},
    {.is_armed = 0U, .start = 0U, .k = 398U, .y = {0.0}, .status = PTC_HOLD, .u = 0.9886371621720742, .xhat = {0.12782429451113045, -23.54315502235881, 3.2696593032957093}, .d = -0.06570916139402636},
    {.is_armed = 0U, .start = 0U, .k = 2147483644U, .y = {0.0}, .status = PTC_HOLD, .u = 1.3570980198104574, .xhat = {0.1151856490594671, -29.722239728764613, 5.906871568822815}, .d = -0.06819438228204111},
    {.is_armed = 0U, .start = 0U, .k = 4294967292U, .y = {0.0}, .status = PTC_HOLD, .u = 1.5234260686237902, .xhat = {0.09722063259530526, -31.68338860857025, 7.260073691845077}, .d = -0.07043387659833635},
    {.is_armed = 0U, .start = 0U, .k = 336U, .y = {0.9185250259448045}, .status = PTC_OK, .u = -3.0457467206955005, .xhat = {0.9185250259448045, 0.0, 0.0}, .d = 0.0},
    {.is_armed = 0U, .start = 0U, .k = 377U, .y = {0.3576535412264044}, .status = PTC_SATURATED, .u = -24.0, .xhat = {0.9185250259448045, 0.0, 0.0}, .d = 0.0},
    {.is_armed = 0U, .start = 0U, .k = 58U, .y = {7.1200186866681e153}, .status = PTC_OK, .u = 0.017461085340888957, .xhat = {0.9566554707713395, -45.60732953221951, 15.33924949932114}, .d = -0.010904730862352928},
    {.is_armed = 1U, .start = 4294967290U, .k = 303U, .y = {8.967500654424333e153}, .status = PTC_SATURATED, .u = -24.0, .xhat = {8.967500654424333e153, 0.0, 0.0}, .d = 0.0},
    {.is_armed = 1U, .start = 0U, .k = 371U, .y = {8.683947567741874e153}, .status = PTC_SATURATED, .u = -24.0, .xhat = {8.683947567741874e153, 0.0, 0.0}, .d = 0.0},
    {.is_armed = 1U, .start = 4294967290U, .k = 36U, .y = {-4.494321321464012e153}, .status = PTC_SATURATED, .u = 24.0, .xhat = {-4.494321321464012e153, 0.0, 0.0}, .d = 0.0},
    {.is_armed = 0U, .start = 0U, .k = 35U, .y = {-1.4229188221943165e308}, .status = PTC_SATURATED, .u = 24.0, .xhat = {-1.4229188221943165e308, 0.0, 0.0}, .d = 0.0},
    {.is_armed = 1U, .start = 4294967290U, .k = 317U, .y = {-9.273672332518532e307}, .status = PTC_E_RANGE, .u = 0.0, .xhat = {0.0, 0.0, 0.0}, .d = 0.0},
    {.is_armed = 0U, .start = 0U, .k = 318U, .y = {4.671654536877187e307}, .status = PTC_SATURATED, .u = -24.0, .xhat = {4.671654536877187e307, 0.0, 0.0}, .d = 0.0},
    {.is_armed = 0U, .start = 0U, .k = 52U, .y = {-1.594198950009431e308}, .status = PTC_E_RANGE, .u = 0.0, .xhat = {4.671654536877187e307, 0.0, 0.0}, .d = 0.0},
    {.is_armed = 0U, .start = 0U, .k = 45U, .y = {-1.5001312656481674e308}, .status = PTC_SATURATED, .u = 24.0, .xhat = {-1.5001312656481674e308, 0.0, 0.0}, .d = 0.0},
    {.is_armed = 0U, .start = 0U, .k = 106U, .y = {-1.3632050320359267e308}, .status = PTC_E_RANGE, .u = 0.0, .xhat = {-1.5001312656481674e308, 0.0, 0.0}, .d = 0.0},
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

    for (uint32_t i = 0U; i < 6U; i++) {
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
