/* Self-test of the prescribed-time controller in_flight: see in_flight_selftest.h. DO NOT EDIT. */
#include "in_flight_selftest.h"
#include "in_flight.h"

#include <math.h>
#include <stddef.h>

/* A call, and what it must give. */
typedef struct in_flight_selftest_call {
    uint32_t is_armed; /* arm is called before it */
    uint32_t start;
    uint32_t command; /* called before it: 0 none, 1 arm_for, 2 deadline, 3 assume, 4 assume_disturbance, 5 applied */
    uint32_t samples;
    double given[2];
    ptc_status told; /* its status */
    uint32_t found; /* its result */
    uint32_t k;
    double y[1]; /* what is measured */
    ptc_status status;
    double u;
    double xhat[2]; /* the estimates behind it */
    double d;
} in_flight_selftest_call;

/* A set of parameters that init takes, and the calls with it, one after the other. */
typedef struct in_flight_selftest_session {
    in_flight_params params;
    uint32_t first; /* of its calls */
    uint32_t count;
} in_flight_selftest_session;

static const in_flight_selftest_session in_flight_selftest_sessions[5] = {
    {.params = {.none = (char)0}, .first = 0U, .count = 42U},
    {.params = {.none = (char)0}, .first = 42U, .count = 2U},
    {.params = {.none = (char)0}, .first = 44U, .count = 1U},
    {.params = {.none = (char)0}, .first = 45U, .count = 2U},
    {.params = {.none = (char)0}, .first = 47U, .count = 11U},
};

static const in_flight_selftest_call in_flight_selftest_calls[58] = {
    {.is_armed = 0U, .start = 0U, .k = 0U, .y = {0.75}, .status = PTC_OK, .u = -1.303269932656407, .xhat = {0.75, 0.0}, .d = 0.0},
    {.is_armed = 0U, .start = 0U, .k = 1U, .y = {0.7450083333333334}, .status = PTC_OK, .u = -1.2993489863511585, .xhat = {0.7499934890772358, -0.02603284403930748}, .d = 0.0},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {0.7400333333333332}, .status = PTC_SATURATED, .u = 10.0, .xhat = {0.7411005722392217, -5.503858507878538}, .d = -42.09496118475811},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {(double)NAN}, .status = PTC_E_INPUT, .u = 0.0, .xhat = {0.7411005722392217, -5.503858507878538}, .d = -42.09496118475811},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {(double)INFINITY}, .status = PTC_E_INPUT, .u = 0.0, .xhat = {0.7411005722392217, -5.503858507878538}, .d = -42.09496118475811},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {-(double)INFINITY}, .status = PTC_E_INPUT, .u = 0.0, .xhat = {0.7411005722392217, -5.503858507878538}, .d = -42.09496118475811},
    {.is_armed = 0U, .start = 0U, .k = 3U, .y = {0.7350749999999999}, .status = PTC_SATURATED, .u = 10.0, .xhat = {0.7329077590674385, -8.143766787754236}, .d = -51.106792033410706},
    {.is_armed = 0U, .start = 0U, .k = 75U, .y = {0.421875}, .status = PTC_SATURATED, .u = 10.0, .xhat = {0.7278070535172372, -7.384409957691614}, .d = -32.80647653258066},
    {.is_armed = 0U, .start = 0U, .k = 146U, .y = {0.19763333333333333}, .status = PTC_SATURATED, .u = 10.0, .xhat = {0.1774291475520236, -341.24564635505783}, .d = -2616.1155203339254},
    {.is_armed = 0U, .start = 0U, .k = 148U, .y = {0.1925333333333334}, .status = PTC_SATURATED, .u = 10.0, .xhat = {-0.17916915032936936, -421.5371153341619}, .d = -2445.510135081088},
    {.is_armed = 0U, .start = 0U, .k = 149U, .y = {0.19000833333333333}, .status = PTC_SATURATED, .u = -10.0, .xhat = {0.01091411934425817, -112.03682797120432}, .d = 693.1684591028315},
    {.is_armed = 0U, .start = 0U, .k = 150U, .y = {0.1875}, .status = PTC_SATURATED, .u = -10.0, .xhat = {0.23071238743919234, 111.11195107763884}, .d = 2205.450998220308},
    {.is_armed = 0U, .start = 0U, .k = 151U, .y = {0.1850083333333333}, .status = PTC_SATURATED, .u = -10.0, .xhat = {0.3087477506792939, 151.122631989484}, .d = 1840.5629454892673},
    {.is_armed = 0U, .start = 0U, .k = 225U, .y = {0.046875}, .status = PTC_SATURATED, .u = -10.0, .xhat = {0.2765973032827956, 88.72598231893171}, .d = 795.6997079517255},
    {.is_armed = 0U, .start = 0U, .k = 296U, .y = {0.00013333333333333337}, .status = PTC_SATURATED, .u = 10.0, .xhat = {-0.026612360014587215, -130.4054842958575}, .d = -1144.0895256726114},
    {.is_armed = 0U, .start = 0U, .k = 298U, .y = {3.333333333333334e-5}, .status = PTC_SATURATED, .u = 10.0, .xhat = {-0.13220355706969716, -146.29291800349043}, .d = -918.2472488857244},
    {.is_armed = 0U, .start = 0U, .k = 299U, .y = {8.333333333333335e-6}, .status = PTC_SATURATED, .u = 10.0, .xhat = {-0.06174996015720719, -37.87083390809896}, .d = 198.36917288149846},
    {.is_armed = 0U, .start = 0U, .k = 300U, .y = {0.0}, .status = PTC_SATURATED, .u = -10.0, .xhat = {0.014159691184003544, 37.8520881426865}, .d = 719.8599950089746},
    {.is_armed = 0U, .start = 0U, .k = 301U, .y = {0.0}, .status = PTC_SATURATED, .u = -10.0, .xhat = {0.04127872444332549, 50.973388450627475}, .d = 600.294693261312},
    {.is_armed = 0U, .start = 0U, .k = 2147483647U, .y = {0.0}, .status = PTC_SATURATED, .u = -10.0, .xhat = {0.030705196703832698, 29.342680292392846}, .d = 251.7346095922166},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {0.0}, .status = PTC_SATURATED, .u = -10.0, .xhat = {0.010347019674203393, 5.420880169282026}, .d = -7.541956641275647},
    {.is_armed = 1U, .start = 4294967293U, .k = 4294967293U, .y = {0.75}, .status = PTC_SATURATED, .u = 10.0, .xhat = {-0.002945852822971507, -6.568173366488932}, .d = -94.91282606622147},
    {.is_armed = 0U, .start = 0U, .k = 4294967294U, .y = {0.7450083333333334}, .status = PTC_SATURATED, .u = -10.0, .xhat = {1.3238226791800056, 809.2129534798837}, .d = 6263.008185243258},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {0.7400333333333332}, .status = PTC_SATURATED, .u = -10.0, .xhat = {1.2296665089746013, 425.06800645903127}, .d = 1375.464310330457},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {(double)NAN}, .status = PTC_E_INPUT, .u = 0.0, .xhat = {1.2296665089746013, 425.06800645903127}, .d = 1375.464310330457},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {(double)INFINITY}, .status = PTC_E_INPUT, .u = 0.0, .xhat = {1.2296665089746013, 425.06800645903127}, .d = 1375.464310330457},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {-(double)INFINITY}, .status = PTC_E_INPUT, .u = 0.0, .xhat = {1.2296665089746013, 425.06800645903127}, .d = 1375.464310330457},
    {.is_armed = 0U, .start = 0U, .k = 0U, .y = {0.7350749999999999}, .status = PTC_SATURATED, .u = 10.0, .xhat = {0.8125953167546339, -55.50514881754914}, .d = -2759.0282877391764},
    {.is_armed = 0U, .start = 0U, .k = 72U, .y = {0.421875}, .status = PTC_SATURATED, .u = 10.0, .xhat = {0.5645614871951015, -249.68956639775865}, .d = -3413.614602080075},
    {.is_armed = 0U, .start = 0U, .k = 143U, .y = {0.19763333333333333}, .status = PTC_SATURATED, .u = 10.0, .xhat = {-0.005511857284610741, -539.5544238426866}, .d = -4618.468060753643},
    {.is_armed = 0U, .start = 0U, .k = 145U, .y = {0.1925333333333334}, .status = PTC_SATURATED, .u = 10.0, .xhat = {-0.2754668393115542, -499.63107496863}, .d = -2903.097598277684},
    {.is_armed = 0U, .start = 0U, .k = 146U, .y = {0.19000833333333333}, .status = PTC_SATURATED, .u = -10.0, .xhat = {-0.0016395714884375819, -103.18504065011409}, .d = 1048.724594247201},
    {.is_armed = 0U, .start = 0U, .k = 147U, .y = {0.1875}, .status = PTC_SATURATED, .u = -10.0, .xhat = {0.25635107556595527, 147.7702535222544}, .d = 2667.011269539188},
    {.is_armed = 0U, .start = 0U, .k = 148U, .y = {0.1850083333333333}, .status = PTC_SATURATED, .u = -10.0, .xhat = {0.33470004226776817, 178.10830864307698}, .d = 2085.6285600776555},
    {.is_armed = 0U, .start = 0U, .k = 222U, .y = {0.046875}, .status = PTC_SATURATED, .u = -10.0, .xhat = {0.28833586674761086, 97.10776482639575}, .d = 821.6225789240127},
    {.is_armed = 0U, .start = 0U, .k = 293U, .y = {0.00013333333333333337}, .status = PTC_SATURATED, .u = 10.0, .xhat = {-0.02681314661105704, -133.80787822252935}, .d = -1217.2878053325012},
    {.is_armed = 0U, .start = 0U, .k = 295U, .y = {3.333333333333334e-5}, .status = PTC_SATURATED, .u = 10.0, .xhat = {-0.13690368858509497, -152.38042219345235}, .d = -989.7500741969401},
    {.is_armed = 0U, .start = 0U, .k = 296U, .y = {8.333333333333335e-6}, .status = PTC_SATURATED, .u = 10.0, .xhat = {-0.06561460942557372, -41.665149251551654}, .d = 166.55454666936396},
    {.is_armed = 0U, .start = 0U, .k = 297U, .y = {0.0}, .status = PTC_SATURATED, .u = -10.0, .xhat = {0.012728742580706574, 37.01371941142264}, .d = 720.6787045042703},
    {.is_armed = 0U, .start = 0U, .k = 298U, .y = {0.0}, .status = PTC_SATURATED, .u = -10.0, .xhat = {0.04156556861714068, 51.72936663622222}, .d = 613.1964206215654},
    {.is_armed = 0U, .start = 0U, .k = 2147483644U, .y = {0.0}, .status = PTC_SATURATED, .u = -10.0, .xhat = {0.031495032219222084, 30.297456980580282}, .d = 262.2142071368482},
    {.is_armed = 0U, .start = 0U, .k = 4294967292U, .y = {0.0}, .status = PTC_SATURATED, .u = -10.0, .xhat = {0.010897754681617772, 5.929345556622242}, .d = -3.7317786836503046},
    {.is_armed = 1U, .start = 0U, .k = 298U, .y = {0.0}, .status = PTC_HOLD, .u = -0.0, .xhat = {0.0, 0.0}, .d = 0.0},
    {.is_armed = 1U, .start = 0U, .k = 73U, .y = {1.7501158716715385e308}, .status = PTC_E_RANGE, .u = 0.0, .xhat = {0.0, 0.0}, .d = 0.0},
    {.is_armed = 1U, .start = 0U, .k = 73U, .y = {-7.025854523460211e307}, .status = PTC_E_RANGE, .u = 0.0, .xhat = {0.0, 0.0}, .d = 0.0},
    {.is_armed = 0U, .start = 0U, .k = 58U, .y = {8.821688709822372e153}, .status = PTC_SATURATED, .u = -10.0, .xhat = {8.821688709822372e153, 0.0}, .d = 0.0},
    {.is_armed = 1U, .start = 4294967290U, .k = 233U, .y = {-3.542846648315711e153}, .status = PTC_SATURATED, .u = 10.0, .xhat = {-3.542846648315711e153, 0.0}, .d = 0.0},
    {.command = 1U, .samples = 1024U, .told = PTC_E_PARAM, .found = 0U, .is_armed = 0U, .start = 0U, .k = 150U, .y = {-0.0001919322134355017}, .status = PTC_OK, .u = 0.0013033705814417518, .xhat = {-0.0001919322134355017, 0.0}, .d = 0.0},
    {.command = 2U, .samples = 1024U, .told = PTC_OK, .found = 300U, .is_armed = 0U, .start = 0U, .k = 2U, .y = {-0.3487185336351768}, .status = PTC_OK, .u = 0.00032548315442155925, .xhat = {-0.00019192570200991276, 2.603485450089028e-5}, .d = 0.0},
    {.command = 3U, .samples = 1024U, .told = PTC_OK, .given = {-0.09728666113673948, 0.0}, .found = 0U, .is_armed = 0U, .start = 0U, .k = 150U, .y = {-0.06470851784951247}, .status = PTC_SATURATED, .u = 10.0, .xhat = {-0.09728666113673948, 0.0}, .d = -2942.9800765496666},
    {.command = 4U, .samples = 1024U, .told = PTC_OK, .given = {0.060990107274426775}, .found = 0U, .is_armed = 0U, .start = 0U, .k = 2U, .y = {61.66624028512053}, .status = PTC_SATURATED, .u = 10.0, .xhat = {-0.0982224700196212, -81.76634788439812}, .d = 0.060990107274426775},
    {.command = 5U, .samples = 1024U, .told = PTC_OK, .given = {0.3670304664935049}, .found = 0U, .is_armed = 0U, .start = 0U, .k = 1U, .y = {0.03151915608260474}, .status = PTC_SATURATED, .u = -10.0, .xhat = {109.35682819818626, 67145.64113802458}, .d = 521542.9767666489},
    {.command = 1U, .samples = 10U, .told = PTC_OK, .found = 0U, .is_armed = 0U, .start = 0U, .k = 2U, .y = {-36.0886718857613}, .status = PTC_SATURATED, .u = 10.0, .xhat = {-7.13511711977719, -31373.614868489236}, .d = -401606.6452422485},
    {.command = 1U, .samples = 0U, .told = PTC_E_PARAM, .found = 0U, .is_armed = 0U, .start = 0U, .k = 2U, .y = {-0.8655921526913652}, .status = PTC_SATURATED, .u = 10.0, .xhat = {-97.79710100167239, -78755.46015085565}, .d = -646092.2394036005},
    {.command = 5U, .samples = 200U, .told = PTC_E_INPUT, .given = {(double)INFINITY}, .found = 0U, .is_armed = 0U, .start = 0U, .k = 300U, .y = {-0.09279846541452788}, .status = PTC_SATURATED, .u = -10.0, .xhat = {-17.35252192960248, 1362.4867573160025}, .d = 172403.3728084562},
    {.command = 3U, .samples = 2147483648U, .told = PTC_E_INPUT, .given = {0.2525663377995009, (double)INFINITY}, .found = 0U, .is_armed = 0U, .start = 0U, .k = 300U, .y = {-1.7976931348623157e308}, .status = PTC_E_RANGE, .u = 0.0, .xhat = {-17.35252192960248, 1362.4867573160025}, .d = 172403.3728084562},
    {.command = 4U, .samples = 200U, .told = PTC_E_INPUT, .given = {(double)NAN}, .found = 0U, .is_armed = 0U, .start = 0U, .k = 150U, .y = {0.6436213450237966}, .status = PTC_SATURATED, .u = -10.0, .xhat = {18.058324947978736, 27020.753644033328}, .d = 318145.53746867157},
    {.command = 3U, .samples = 0U, .told = PTC_E_INPUT, .given = {(double)NAN, -0.09897812293795732}, .found = 0U, .is_armed = 0U, .start = 0U, .k = 300U, .y = {0.0009561098285078244}, .status = PTC_SATURATED, .u = -10.0, .xhat = {20.47957535027425, 20624.822152766785}, .d = 171094.7110010925},
};

/* 1 where a number is not the one that must come. */
static uint32_t in_flight_selftest_differs(double value, double wanted)
{
    uint32_t failures = 1U;

    if (fabs(value - wanted) <= 0.0) {
        failures = 0U;
    }
    return failures;
}

/* The failures of what is called before a call. */
static uint32_t in_flight_selftest_command(in_flight *self, const in_flight_selftest_call *call)
{
    uint32_t failures = 0U;
    uint32_t found = 0U;
    ptc_status told = call->told;

    switch (call->command) {
    case 1U:
        told = in_flight_arm_for(self, call->k, call->samples);
        break;
    case 2U:
        told = in_flight_deadline(self, &found);
        break;
    case 3U:
        told = in_flight_assume(self, &call->given[0]);
        break;
    case 4U:
        told = in_flight_assume_disturbance(self, call->given[0]);
        break;
    case 5U:
        told = in_flight_applied(self, call->given[0]);
        break;
    default:
        break;
    }
    if (told != call->told) {
        failures++;
    }
    if (found != call->found) {
        failures++;
    }
    return failures;
}

/* The failures of one call. */
static uint32_t in_flight_selftest_check(in_flight *self, const in_flight_selftest_call *call)
{
    uint32_t failures = 0U;
    double u = 12345.0;
    double xhat[2] = {12345.0, 12345.0};
    double d = 12345.0;

    if (call->is_armed != 0U) {
        if (in_flight_arm(self, call->start) != PTC_OK) {
            failures++;
        }
    }
    failures += in_flight_selftest_command(self, call);
    if (in_flight_step(self, call->k, call->y, &u) != call->status) {
        failures++;
    }
    failures += in_flight_selftest_differs(u, call->u);
    if (in_flight_estimate(self, xhat) != PTC_OK) {
        failures++;
    }
    for (uint32_t i = 0U; i < 2U; i++) {
        failures += in_flight_selftest_differs(xhat[i], call->xhat[i]);
    }
    if (in_flight_disturbance(self, &d) != PTC_OK) {
        failures++;
    }
    failures += in_flight_selftest_differs(d, call->d);
    return failures;
}

/* The calls of a session, of which init has been called. */
static uint32_t in_flight_selftest_calls_of(in_flight *self, const in_flight_selftest_session *session)
{
    uint32_t failures = 0U;

    for (uint32_t j = 0U; j < session->count; j++) {
        failures += in_flight_selftest_check(self, &in_flight_selftest_calls[session->first + j]);
    }
    return failures;
}

/* Every session with its calls. */
static uint32_t in_flight_selftest_run(void)
{
    uint32_t failures = 0U;

    for (uint32_t i = 0U; i < 5U; i++) {
        const in_flight_selftest_session *session = &in_flight_selftest_sessions[i];
        in_flight self;

        if (in_flight_init(&self, &session->params) == PTC_OK) {
            failures += in_flight_selftest_calls_of(&self, session);
        } else {
            failures++;
        }
    }
    return failures;
}

/* What init must refuse without a change. */
static uint32_t in_flight_selftest_refuse(void)
{
    const in_flight_selftest_session *session = &in_flight_selftest_sessions[0];
    uint32_t failures = 0U;
    in_flight self;

    if (in_flight_init(&self, &session->params) != PTC_OK) {
        failures++;
    }
    if (in_flight_init(NULL, &session->params) != PTC_E_PARAM) {
        failures++;
    }
    failures += in_flight_selftest_calls_of(&self, session);
    return failures;
}

/* Calls that lack a pointer: each is refused, and changes nothing. */
static uint32_t in_flight_selftest_pointers(void)
{
    const in_flight_selftest_session *session = &in_flight_selftest_sessions[0];
    const in_flight_selftest_call *call = &in_flight_selftest_calls[0];
    uint32_t failures = 0U;
    double u = 12345.0;
    double xhat[2];
    double d;
    in_flight self;

    if (in_flight_init(&self, &session->params) != PTC_OK) {
        failures++;
    }
    if (in_flight_arm(NULL, call->start) != PTC_E_INPUT) {
        failures++;
    }
    if (in_flight_step(NULL, call->k, call->y, &u) != PTC_E_INPUT) {
        failures++;
    }
    failures += in_flight_selftest_differs(u, 0.0);
    u = 12345.0;
    if (in_flight_step(&self, call->k, NULL, &u) != PTC_E_INPUT) {
        failures++;
    }
    failures += in_flight_selftest_differs(u, 0.0);
    if (in_flight_step(&self, call->k, call->y, NULL) != PTC_E_INPUT) {
        failures++;
    }
    if (in_flight_estimate(NULL, xhat) != PTC_E_INPUT) {
        failures++;
    }
    if (in_flight_estimate(&self, NULL) != PTC_E_INPUT) {
        failures++;
    }
    if (in_flight_disturbance(NULL, &d) != PTC_E_INPUT) {
        failures++;
    }
    if (in_flight_disturbance(&self, NULL) != PTC_E_INPUT) {
        failures++;
    }
    failures += in_flight_selftest_calls_of(&self, session);
    return failures;
}

uint32_t in_flight_selftest(void)
{
    uint32_t failures = in_flight_selftest_run();

    failures += in_flight_selftest_refuse();
    failures += in_flight_selftest_pointers();
    return failures;
}
