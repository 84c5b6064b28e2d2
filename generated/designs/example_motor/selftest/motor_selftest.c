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
    {.is_armed = 0U, .start = 0U, .k = 0U, .y = {0.75}, .status = PTC_OK, .u = -4.307798238294346e-5, .xhat = {0.75, 0.0, 0.0}, .d = 0.0},
    {.is_armed = 0U, .start = 0U, .k = 1U, .y = {0.7462546875}, .status = PTC_OK, .u = -0.000105045507610568, .xhat = {0.75, 0.0, 0.0}, .d = 0.0},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {0.74251875}, .status = PTC_OK, .u = -0.12684697984706797, .xhat = {0.751352761388499, -0.7600292412227837, 0.28332982114593797}, .d = -3.374670658297988e-7},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {(double)NAN}, .status = PTC_E_INPUT, .u = 0.0, .xhat = {0.751352761388499, -0.7600292412227837, 0.28332982114593797}, .d = -3.374670658297988e-7},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {(double)INFINITY}, .status = PTC_E_INPUT, .u = 0.0, .xhat = {0.751352761388499, -0.7600292412227837, 0.28332982114593797}, .d = -3.374670658297988e-7},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {-(double)INFINITY}, .status = PTC_E_INPUT, .u = 0.0, .xhat = {0.751352761388499, -0.7600292412227837, 0.28332982114593797}, .d = -3.374670658297988e-7},
    {.is_armed = 0U, .start = 0U, .k = 3U, .y = {0.7387921875000001}, .status = PTC_OK, .u = -0.551655718342461, .xhat = {0.7539550478451174, -2.2235464409586387, 0.8288924831797847}, .d = -1.1554035047965072e-6},
    {.is_armed = 0U, .start = 0U, .k = 75U, .y = {0.4951171875}, .status = PTC_OK, .u = -1.4675536005554952, .xhat = {0.7576929994514194, -4.374957296559654, 1.568801090087726}, .d = -2.5983225305528503e-6},
    {.is_armed = 0U, .start = 0U, .k = 146U, .y = {0.30241875}, .status = PTC_OK, .u = -8.60054739454917, .xhat = {0.8212638858323845, -42.3316519841517, 15.454298612355746}, .d = -0.00038645392814353293},
    {.is_armed = 0U, .start = 0U, .k = 148U, .y = {0.297675}, .status = PTC_OK, .u = -22.01011115512911, .xhat = {0.8240629886153807, -66.32767403216198, 23.535001083759855}, .d = -0.010474088474823649},
    {.is_armed = 0U, .start = 0U, .k = 149U, .y = {0.2953171874999999}, .status = PTC_SATURATED, .u = -24.0, .xhat = {0.8076950867633895, -83.82147725079166, 25.723838528264466}, .d = -0.020708374762185892},
    {.is_armed = 0U, .start = 0U, .k = 150U, .y = {0.29296875}, .status = PTC_SATURATED, .u = -24.0, .xhat = {0.7728368001429863, -101.72167972558226, 21.666404444373626}, .d = -0.030670270211533464},
    {.is_armed = 0U, .start = 0U, .k = 151U, .y = {0.29062968750000007}, .status = PTC_SATURATED, .u = -24.0, .xhat = {0.7151844473578309, -122.03504258292787, 17.96722050173653}, .d = -0.040000093671677145},
    {.is_armed = 0U, .start = 0U, .k = 275U, .y = {0.0732421875}, .status = PTC_SATURATED, .u = -24.0, .xhat = {0.6312066273389284, -141.90363954749694, 14.56462952562227}, .d = -0.04825448976547207},
    {.is_armed = 0U, .start = 0U, .k = 396U, .y = {7.500000000000001e-5}, .status = PTC_HOLD, .u = -10.64227246105577, .xhat = {0.5344712532467958, -176.02720837402165, 16.863234129579574}, .d = -0.059102700475028615},
    {.is_armed = 0U, .start = 0U, .k = 398U, .y = {1.8750000000000002e-5}, .status = PTC_HOLD, .u = 1.1826318286153388, .xhat = {0.4035367092613996, -205.3611379891045, 17.79405437455853}, .d = -0.06949268726216565},
    {.is_armed = 0U, .start = 0U, .k = 399U, .y = {4.6875000000000004e-6}, .status = PTC_HOLD, .u = 10.795998956407871, .xhat = {0.23641590984228816, -218.81009625596562, 19.781550546577016}, .d = -0.07733807584718297},
    {.is_armed = 0U, .start = 0U, .k = 400U, .y = {0.0}, .status = PTC_HOLD, .u = 17.93841671420598, .xhat = {0.046942452932432585, -212.93075463434204, 20.524734920271143}, .d = -0.08193449556671441},
    {.is_armed = 0U, .start = 0U, .k = 401U, .y = {0.0}, .status = PTC_HOLD, .u = 22.62533727201284, .xhat = {-0.1481651743180305, -188.21257028784325, 18.893070271583937}, .d = -0.08284717312154474},
    {.is_armed = 0U, .start = 0U, .k = 2147483647U, .y = {0.0}, .status = PTC_SATURATED, .u = 24.0, .xhat = {-0.33225711487373183, -147.8222079874862, 14.67456719039783}, .d = -0.07996647514859835},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {0.0}, .status = PTC_SATURATED, .u = 24.0, .xhat = {-0.4908265827485459, -96.45499013177525, 8.285263250584388}, .d = -0.07350657388152104},
    {.is_armed = 1U, .start = 4294967293U, .k = 4294967293U, .y = {0.75}, .status = PTC_SATURATED, .u = 24.0, .xhat = {-0.6128861904635091, -39.71331916823232, 0.10831200782265782}, .d = -0.06396368940478825},
    {.is_armed = 0U, .start = 0U, .k = 4294967294U, .y = {0.7462546875}, .status = PTC_SATURATED, .u = 24.0, .xhat = {-1.1430400099204094, 245.2855275747761, -93.82979240089013}, .d = -0.06384416281655593},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {0.74251875}, .status = PTC_SATURATED, .u = 24.0, .xhat = {-1.6364796783985915, 528.2627406957931, -187.50269817042812}, .d = -0.0636739300955143},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {(double)NAN}, .status = PTC_E_INPUT, .u = 0.0, .xhat = {-1.6364796783985915, 528.2627406957931, -187.50269817042812}, .d = -0.0636739300955143},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {(double)INFINITY}, .status = PTC_E_INPUT, .u = 0.0, .xhat = {-1.6364796783985915, 528.2627406957931, -187.50269817042812}, .d = -0.0636739300955143},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {-(double)INFINITY}, .status = PTC_E_INPUT, .u = 0.0, .xhat = {-1.6364796783985915, 528.2627406957931, -187.50269817042812}, .d = -0.0636739300955143},
    {.is_armed = 0U, .start = 0U, .k = 0U, .y = {0.7387921875000001}, .status = PTC_SATURATED, .u = 24.0, .xhat = {-2.081047849630716, 801.6891024991112, -278.0838809143211}, .d = -0.06345365989013907},
    {.is_armed = 0U, .start = 0U, .k = 72U, .y = {0.4951171875}, .status = PTC_SATURATED, .u = 24.0, .xhat = {-2.466032738273064, 1058.8622058996725, -363.0559377497276}, .d = -0.06318531996307013},
    {.is_armed = 0U, .start = 0U, .k = 143U, .y = {0.30241875}, .status = PTC_SATURATED, .u = 24.0, .xhat = {-2.3887493755675266, 1094.515977150703, -365.90266236379205}, .d = -0.0588564597012622},
    {.is_armed = 0U, .start = 0U, .k = 145U, .y = {0.297675}, .status = PTC_SATURATED, .u = 24.0, .xhat = {-1.7064369103628863, 894.4517057369624, -280.43309574589676}, .d = -0.006533485696993038},
    {.is_armed = 0U, .start = 0U, .k = 146U, .y = {0.2953171874999999}, .status = PTC_SATURATED, .u = 24.0, .xhat = {-1.12348047695973, 737.6685580063862, -211.7210912968926}, .d = 0.03243141374252075},
    {.is_armed = 0U, .start = 0U, .k = 147U, .y = {0.29296875}, .status = PTC_SATURATED, .u = 24.0, .xhat = {-0.6140982891697466, 613.0148074810161, -155.55917835034344}, .d = 0.06001635450098379},
    {.is_armed = 0U, .start = 0U, .k = 148U, .y = {0.29062968750000007}, .status = PTC_SATURATED, .u = 24.0, .xhat = {-0.15908654272184455, 511.93295781216256, -108.71682917768916}, .d = 0.07765198441934847},
    {.is_armed = 0U, .start = 0U, .k = 272U, .y = {0.0732421875}, .status = PTC_SATURATED, .u = 24.0, .xhat = {0.2555471035595741, 428.049735878115, -68.78470914106181}, .d = 0.08639558181842708},
    {.is_armed = 0U, .start = 0U, .k = 393U, .y = {7.500000000000001e-5}, .status = PTC_HOLD, .u = -7.36598643064442, .xhat = {0.6546414116870127, 339.5209447146531, -27.656657856397562}, .d = 0.08285112270670808},
    {.is_armed = 0U, .start = 0U, .k = 395U, .y = {1.8750000000000002e-5}, .status = PTC_SATURATED, .u = -24.0, .xhat = {1.023350808953064, 260.4542431467682, 9.471992544439495}, .d = 0.07012473039498852},
    {.is_armed = 0U, .start = 0U, .k = 396U, .y = {4.6875000000000004e-6}, .status = PTC_SATURATED, .u = -24.0, .xhat = {1.3581388593385946, 184.79788697563313, 29.535957131914376}, .d = 0.05022862052000818},
    {.is_armed = 0U, .start = 0U, .k = 397U, .y = {0.0}, .status = PTC_SATURATED, .u = -24.0, .xhat = {1.6511076476797066, 100.60773014037635, 44.843862409955136}, .d = 0.02382312831300064},
    {.is_armed = 0U, .start = 0U, .k = 398U, .y = {0.0}, .status = PTC_SATURATED, .u = -24.0, .xhat = {1.8897402426694294, 11.099780930253953, 62.67306830697029}, .d = -0.008278493918266225},
    {.is_armed = 0U, .start = 0U, .k = 2147483644U, .y = {0.0}, .status = PTC_SATURATED, .u = -24.0, .xhat = {2.066570824006348, -76.51569645707576, 80.32772955711332}, .d = -0.045019724855356866},
    {.is_armed = 0U, .start = 0U, .k = 4294967292U, .y = {0.0}, .status = PTC_SATURATED, .u = -24.0, .xhat = {2.179138869560751, -157.5331454653113, 96.04899019076484}, .d = -0.0851989802780044},
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
