/* Self-test of the prescribed-time controller stage9: see stage9_selftest.h. DO NOT EDIT. */
#include "stage9_selftest.h"
#include "stage9.h"

#include <math.h>
#include <stddef.h>

/* A call, and what it must give. */
typedef struct stage9_selftest_call {
    uint32_t is_armed; /* arm is called before it */
    uint32_t start;
    uint32_t k;
    double y[1]; /* what is measured */
    ptc_status status;
    double u;
    double xhat[3]; /* the estimates behind it */
} stage9_selftest_call;

/* A set of parameters that init takes, and the calls with it, one after the other. */
typedef struct stage9_selftest_session {
    stage9_params params;
    uint32_t first; /* of its calls */
    uint32_t count;
} stage9_selftest_session;

static const stage9_selftest_session stage9_selftest_sessions[4] = {
    {.params = {.samples = 60U, .h = 0.015625, .k = {625.0, 500.0, 150.0, 20.0}, .deadbeat = 0.0}, .first = 0U, .count = 42U},
    {.params = {.samples = 60U, .h = 0.015625, .k = {625.0, 500.0, 150.0, 20.0}, .deadbeat = 0.0}, .first = 42U, .count = 1U},
    {.params = {.samples = 60U, .h = 0.015625, .k = {625.0, 500.0, 150.0, 20.0}, .deadbeat = 0.0}, .first = 43U, .count = 2U},
    {.params = {.samples = 60U, .h = 0.015625, .k = {625.0, 500.0, 150.0, 20.0}, .deadbeat = 0.0}, .first = 45U, .count = 2U},
};

static const stage9_selftest_call stage9_selftest_calls[47] = {
    {.is_armed = 0U, .start = 0U, .k = 0U, .y = {0.75}, .status = PTC_OK, .u = -10.499656505377997, .xhat = {0.75, 0.0, 0.0}},
    {.is_armed = 0U, .start = 0U, .k = 1U, .y = {0.7252083333333332}, .status = PTC_OK, .u = -18.24019918788813, .xhat = {0.7408133780332056, -0.06773946360153284, -0.1111621966794385}},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {0.7008333333333333}, .status = PTC_OK, .u = -22.8006163979338, .xhat = {0.7248676354828368, -0.1847547593125742, -0.4697736805727416}},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {(double)NAN}, .status = PTC_E_INPUT, .u = 0.0, .xhat = {0.7248676354828368, -0.1847547593125742, -0.4697736805727416}},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {(double)INFINITY}, .status = PTC_E_INPUT, .u = 0.0, .xhat = {0.7248676354828368, -0.1847547593125742, -0.4697736805727416}},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {-(double)INFINITY}, .status = PTC_E_INPUT, .u = 0.0, .xhat = {0.7248676354828368, -0.1847547593125742, -0.4697736805727416}},
    {.is_armed = 0U, .start = 0U, .k = 3U, .y = {0.676875}, .status = PTC_OK, .u = -24.05904526250637, .xhat = {0.7041434957784408, -0.3362224391039047, -1.0070450226034113}},
    {.is_armed = 0U, .start = 0U, .k = 15U, .y = {0.421875}, .status = PTC_OK, .u = 55.166342659038065, .xhat = {0.5222811603256681, -3.1588110188641725, -11.333332113068064}},
    {.is_armed = 0U, .start = 0U, .k = 26U, .y = {0.2408333333333333}, .status = PTC_SATURATED, .u = 1000.0, .xhat = {0.2408333333333333, -25.48532515798555, -956.6263290283525}},
    {.is_armed = 0U, .start = 0U, .k = 28U, .y = {0.21333333333333332}, .status = PTC_SATURATED, .u = -1000.0, .xhat = {0.44597935471653577, -13.837760646856935, 4716.36721403756}},
    {.is_armed = 0U, .start = 0U, .k = 29U, .y = {0.20020833333333338}, .status = PTC_SATURATED, .u = 1000.0, .xhat = {-0.08898085963384295, 26.92735390301705, -2318.715728781187}},
    {.is_armed = 0U, .start = 0U, .k = 30U, .y = {0.1875}, .status = PTC_SATURATED, .u = 1000.0, .xhat = {0.25404283907144565, -1.8197537778095167, -711.9629380868987}},
    {.is_armed = 0U, .start = 0U, .k = 31U, .y = {0.17520833333333333}, .status = PTC_SATURATED, .u = 1000.0, .xhat = {0.19232949134624489, -10.865400600013139, -278.9077998673428}},
    {.is_armed = 0U, .start = 0U, .k = 45U, .y = {0.046875}, .status = PTC_SATURATED, .u = -1000.0, .xhat = {0.07442698684629226, -11.952466163721267, 408.4608794327325}},
    {.is_armed = 0U, .start = 0U, .k = 56U, .y = {0.003333333333333333}, .status = PTC_SATURATED, .u = -1000.0, .xhat = {0.034435717529816806, -1.893636416201009, 1182.3916274612789}},
    {.is_armed = 0U, .start = 0U, .k = 58U, .y = {0.0008333333333333333}, .status = PTC_SATURATED, .u = 1000.0, .xhat = {-0.06966626674220625, 8.402065298891266, -552.0807648566313}},
    {.is_armed = 0U, .start = 0U, .k = 59U, .y = {0.00020833333333333332}, .status = PTC_SATURATED, .u = 1000.0, .xhat = {0.0033682530409326625, 0.014866716374895728, -490.6639129380194}},
    {.is_armed = 0U, .start = 0U, .k = 60U, .y = {0.0}, .status = PTC_SATURATED, .u = -1000.0, .xhat = {0.02656460330184935, -4.4937319477131705, 172.63141518325745}},
    {.is_armed = 0U, .start = 0U, .k = 61U, .y = {0.0}, .status = PTC_SATURATED, .u = -1000.0, .xhat = {0.010471843154576704, -0.4775136981660115, 443.5699244757931}},
    {.is_armed = 0U, .start = 0U, .k = 2147483647U, .y = {0.0}, .status = PTC_SATURATED, .u = 1000.0, .xhat = {-0.026976231564302178, 3.24819816620516, -229.76129271100024}},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {0.0}, .status = PTC_SATURATED, .u = 1000.0, .xhat = {0.0023414765642799235, -0.19629502327222825, -188.2988640961757}},
    {.is_armed = 1U, .start = 4294967293U, .k = 4294967293U, .y = {0.75}, .status = PTC_SATURATED, .u = 1000.0, .xhat = {0.2549269867367155, -1.042195615538922, -169.55414246182735}},
    {.is_armed = 0U, .start = 0U, .k = 4294967294U, .y = {0.7252083333333332}, .status = PTC_SATURATED, .u = 1000.0, .xhat = {0.4063131461560135, -2.1851263664926437, -151.65749952847378}},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {0.7008333333333333}, .status = PTC_SATURATED, .u = 1000.0, .xhat = {0.4867317700108599, -3.4172029980105485, -134.2993769921717}},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {(double)NAN}, .status = PTC_E_INPUT, .u = 0.0, .xhat = {0.4867317700108599, -3.4172029980105485, -134.2993769921717}},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {(double)INFINITY}, .status = PTC_E_INPUT, .u = 0.0, .xhat = {0.4867317700108599, -3.4172029980105485, -134.2993769921717}},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {-(double)INFINITY}, .status = PTC_E_INPUT, .u = 0.0, .xhat = {0.4867317700108599, -3.4172029980105485, -134.2993769921717}},
    {.is_armed = 0U, .start = 0U, .k = 0U, .y = {0.676875}, .status = PTC_SATURATED, .u = 1000.0, .xhat = {0.5198795065104742, -4.576581078907376, -117.22196921953906}},
    {.is_armed = 0U, .start = 0U, .k = 12U, .y = {0.421875}, .status = PTC_SATURATED, .u = 1000.0, .xhat = {0.4265246955089742, -6.415957350040571, -102.05866989359382}},
    {.is_armed = 0U, .start = 0U, .k = 23U, .y = {0.2408333333333333}, .status = PTC_SATURATED, .u = 1000.0, .xhat = {0.2408333333333333, -14.956023616863092, -387.97905068229215}},
    {.is_armed = 0U, .start = 0U, .k = 25U, .y = {0.21333333333333332}, .status = PTC_SATURATED, .u = -1000.0, .xhat = {0.3340417199701195, -7.100881784212682, 2570.631375890768}},
    {.is_armed = 0U, .start = 0U, .k = 26U, .y = {0.20020833333333338}, .status = PTC_SATURATED, .u = 1000.0, .xhat = {0.0392167649860482, 14.788267394033756, -1338.8713857192165}},
    {.is_armed = 0U, .start = 0U, .k = 27U, .y = {0.1875}, .status = PTC_SATURATED, .u = 1000.0, .xhat = {0.22629692169428328, -1.819734412410929, -408.5904853633614}},
    {.is_armed = 0U, .start = 0U, .k = 28U, .y = {0.17520833333333333}, .status = PTC_SATURATED, .u = 1000.0, .xhat = {0.18789698540042826, -6.631758768902604, -83.60406353704775}},
    {.is_armed = 0U, .start = 0U, .k = 42U, .y = {0.046875}, .status = PTC_SATURATED, .u = 1000.0, .xhat = {0.0335920402185106, -9.334054495624901, -391.8302734476451}},
    {.is_armed = 0U, .start = 0U, .k = 53U, .y = {0.003333333333333333}, .status = PTC_SATURATED, .u = -1000.0, .xhat = {0.08102424398832259, -6.45537098803133, 1517.9731196644664}},
    {.is_armed = 0U, .start = 0U, .k = 55U, .y = {0.0008333333333333333}, .status = PTC_SATURATED, .u = 1000.0, .xhat = {-0.07804122288261126, 8.370794323118036, -389.4386795052226}},
    {.is_armed = 0U, .start = 0U, .k = 56U, .y = {0.00020833333333333332}, .status = PTC_SATURATED, .u = 1000.0, .xhat = {-0.0018770720954392741, 1.9254125943463498, -455.9078499591069}},
    {.is_armed = 0U, .start = 0U, .k = 57U, .y = {0.0}, .status = PTC_SATURATED, .u = 1000.0, .xhat = {0.012795458047376827, -3.613739186207349, -128.3173966135398}},
    {.is_armed = 0U, .start = 0U, .k = 58U, .y = {0.0}, .status = PTC_SATURATED, .u = -1000.0, .xhat = {0.02801456249612537, -2.294963910522449, 570.3293175777045}},
    {.is_armed = 0U, .start = 0U, .k = 2147483644U, .y = {0.0}, .status = PTC_SATURATED, .u = 1000.0, .xhat = {-0.02978745586875481, 3.334221318414361, -140.29222550812392}},
    {.is_armed = 0U, .start = 0U, .k = 4294967292U, .y = {0.0}, .status = PTC_SATURATED, .u = 1000.0, .xhat = {-0.0021708528281848575, 0.7719875162716562, -208.84468493815453}},
    {.is_armed = 0U, .start = 0U, .k = 11U, .y = {8.789725912568524e301}, .status = PTC_E_RANGE, .u = 0.0, .xhat = {0.0, 0.0, 0.0}},
    {.is_armed = 1U, .start = 0U, .k = 60U, .y = {-5.120859724142336e153}, .status = PTC_SATURATED, .u = 1000.0, .xhat = {-5.120859724142336e153, 0.0, 0.0}},
    {.is_armed = 1U, .start = 4294967290U, .k = 1U, .y = {-5.39120140779861e153}, .status = PTC_SATURATED, .u = 1000.0, .xhat = {-5.39120140779861e153, 0.0, 0.0}},
    {.is_armed = 1U, .start = 0U, .k = 58U, .y = {0.0}, .status = PTC_OK, .u = -0.0, .xhat = {0.0, 0.0, 0.0}},
    {.is_armed = 0U, .start = 0U, .k = 60U, .y = {0.0}, .status = PTC_HOLD, .u = 0.0, .xhat = {0.0, 0.0, 0.0}},
};

/* 1 where a number is not the one that must come. */
static uint32_t stage9_selftest_differs(double value, double wanted)
{
    uint32_t failures = 1U;

    if (fabs(value - wanted) <= 0.0) {
        failures = 0U;
    }
    return failures;
}

/* The failures of one call. */
static uint32_t stage9_selftest_check(stage9 *self, const stage9_selftest_call *call)
{
    uint32_t failures = 0U;
    double u = 12345.0;
    double xhat[3] = {12345.0, 12345.0, 12345.0};

    if (call->is_armed != 0U) {
        if (stage9_arm(self, call->start) != PTC_OK) {
            failures++;
        }
    }
    if (stage9_step(self, call->k, call->y, &u) != call->status) {
        failures++;
    }
    failures += stage9_selftest_differs(u, call->u);
    if (stage9_estimate(self, xhat) != PTC_OK) {
        failures++;
    }
    for (uint32_t i = 0U; i < 3U; i++) {
        failures += stage9_selftest_differs(xhat[i], call->xhat[i]);
    }
    return failures;
}

/* The calls of a session, of which init has been called. */
static uint32_t stage9_selftest_calls_of(stage9 *self, const stage9_selftest_session *session)
{
    uint32_t failures = 0U;

    for (uint32_t j = 0U; j < session->count; j++) {
        failures += stage9_selftest_check(self, &stage9_selftest_calls[session->first + j]);
    }
    return failures;
}

/* Every session with its calls. */
static uint32_t stage9_selftest_run(void)
{
    uint32_t failures = 0U;

    for (uint32_t i = 0U; i < 4U; i++) {
        const stage9_selftest_session *session = &stage9_selftest_sessions[i];
        stage9 self;

        if (stage9_init(&self, &session->params) == PTC_OK) {
            failures += stage9_selftest_calls_of(&self, session);
        } else {
            failures++;
        }
    }
    return failures;
}

/* What init must refuse without a change. */
static uint32_t stage9_selftest_refuse(void)
{
    static const stage9_params refused[43] = {
        {.samples = 0U, .h = 0.015625, .k = {625.0, 500.0, 150.0, 20.0}, .deadbeat = 0.0},
        {.samples = 7U, .h = 0.015625, .k = {625.0, 500.0, 150.0, 20.0}, .deadbeat = 0.0},
        {.samples = 60U, .h = (double)NAN, .k = {625.0, 500.0, 150.0, 20.0}, .deadbeat = 0.0},
        {.samples = 60U, .h = (double)INFINITY, .k = {625.0, 500.0, 150.0, 20.0}, .deadbeat = 0.0},
        {.samples = 60U, .h = -(double)INFINITY, .k = {625.0, 500.0, 150.0, 20.0}, .deadbeat = 0.0},
        {.samples = 60U, .h = 0.0, .k = {625.0, 500.0, 150.0, 20.0}, .deadbeat = 0.0},
        {.samples = 60U, .h = -1.0, .k = {625.0, 500.0, 150.0, 20.0}, .deadbeat = 0.0},
        {.samples = 60U, .h = 1.7976931348623157e308, .k = {625.0, 500.0, 150.0, 20.0}, .deadbeat = 0.0},
        {.samples = 60U, .h = -1.7976931348623157e308, .k = {625.0, 500.0, 150.0, 20.0}, .deadbeat = 0.0},
        {.samples = 60U, .h = 5e-324, .k = {625.0, 500.0, 150.0, 20.0}, .deadbeat = 0.0},
        {.samples = 60U, .h = 7.5e-151, .k = {625.0, 500.0, 150.0, 20.0}, .deadbeat = 0.0},
        {.samples = 60U, .h = 1e-150, .k = {625.0, 500.0, 150.0, 20.0}, .deadbeat = 0.0},
        {.samples = 60U, .h = 1e150, .k = {625.0, 500.0, 150.0, 20.0}, .deadbeat = 0.0},
        {.samples = 60U, .h = 1.25e150, .k = {625.0, 500.0, 150.0, 20.0}, .deadbeat = 0.0},
        {.samples = 60U, .h = 0.015625, .k = {(double)NAN, 500.0, 150.0, 20.0}, .deadbeat = 0.0},
        {.samples = 60U, .h = 0.015625, .k = {(double)INFINITY, 500.0, 150.0, 20.0}, .deadbeat = 0.0},
        {.samples = 60U, .h = 0.015625, .k = {-(double)INFINITY, 500.0, 150.0, 20.0}, .deadbeat = 0.0},
        {.samples = 60U, .h = 0.015625, .k = {1.7976931348623157e308, 500.0, 150.0, 20.0}, .deadbeat = 0.0},
        {.samples = 60U, .h = 0.015625, .k = {-1.7976931348623157e308, 500.0, 150.0, 20.0}, .deadbeat = 0.0},
        {.samples = 60U, .h = 0.015625, .k = {625.0, (double)NAN, 150.0, 20.0}, .deadbeat = 0.0},
        {.samples = 60U, .h = 0.015625, .k = {625.0, (double)INFINITY, 150.0, 20.0}, .deadbeat = 0.0},
        {.samples = 60U, .h = 0.015625, .k = {625.0, -(double)INFINITY, 150.0, 20.0}, .deadbeat = 0.0},
        {.samples = 60U, .h = 0.015625, .k = {625.0, 1.7976931348623157e308, 150.0, 20.0}, .deadbeat = 0.0},
        {.samples = 60U, .h = 0.015625, .k = {625.0, -1.7976931348623157e308, 150.0, 20.0}, .deadbeat = 0.0},
        {.samples = 60U, .h = 0.015625, .k = {625.0, 500.0, (double)NAN, 20.0}, .deadbeat = 0.0},
        {.samples = 60U, .h = 0.015625, .k = {625.0, 500.0, (double)INFINITY, 20.0}, .deadbeat = 0.0},
        {.samples = 60U, .h = 0.015625, .k = {625.0, 500.0, -(double)INFINITY, 20.0}, .deadbeat = 0.0},
        {.samples = 60U, .h = 0.015625, .k = {625.0, 500.0, 1.7976931348623157e308, 20.0}, .deadbeat = 0.0},
        {.samples = 60U, .h = 0.015625, .k = {625.0, 500.0, -1.7976931348623157e308, 20.0}, .deadbeat = 0.0},
        {.samples = 60U, .h = 0.015625, .k = {625.0, 500.0, 150.0, (double)NAN}, .deadbeat = 0.0},
        {.samples = 60U, .h = 0.015625, .k = {625.0, 500.0, 150.0, (double)INFINITY}, .deadbeat = 0.0},
        {.samples = 60U, .h = 0.015625, .k = {625.0, 500.0, 150.0, -(double)INFINITY}, .deadbeat = 0.0},
        {.samples = 60U, .h = 0.015625, .k = {625.0, 500.0, 150.0, 1.7976931348623157e308}, .deadbeat = 0.0},
        {.samples = 60U, .h = 0.015625, .k = {625.0, 500.0, 150.0, -1.7976931348623157e308}, .deadbeat = 0.0},
        {.samples = 60U, .h = 0.015625, .k = {625.0, 500.0, 150.0, 20.0}, .deadbeat = (double)NAN},
        {.samples = 60U, .h = 0.015625, .k = {625.0, 500.0, 150.0, 20.0}, .deadbeat = (double)INFINITY},
        {.samples = 60U, .h = 0.015625, .k = {625.0, 500.0, 150.0, 20.0}, .deadbeat = -(double)INFINITY},
        {.samples = 60U, .h = 0.015625, .k = {625.0, 500.0, 150.0, 20.0}, .deadbeat = -1.0},
        {.samples = 60U, .h = 0.015625, .k = {625.0, 500.0, 150.0, 20.0}, .deadbeat = -1.7976931348623157e308},
        {.samples = 60U, .h = 0.015625, .k = {625.0, 500.0, -1.7976931348623157e308, -1.7976931348623157e308}, .deadbeat = 9.935072591923028e65},
        {.samples = 60U, .h = 1.1464924380127588e80, .k = {-2.8029535714093136e-9, 7.422097174225117e48, 150.0, 2.0876902900652827e-51}, .deadbeat = 1.8158891488975643e-44},
        {.samples = 60U, .h = 5.5641049190028925e31, .k = {625.0, 8.218630925214398e37, 1.7976931348623157e308, 1.630907331446008e103}, .deadbeat = 6.111259649309686e-67},
        {.samples = 60U, .h = 3.095438590212917e-68, .k = {-5.6409395781963e-170, 1.6703777624380537e-95, 2.1278007825309635e23, -1.4736676780838372e-234}, .deadbeat = 4.534046082131362e104},
    };
    const stage9_selftest_session *session = &stage9_selftest_sessions[0];
    uint32_t failures = 0U;
    stage9 self;

    if (stage9_init(&self, &session->params) != PTC_OK) {
        failures++;
    }
    for (uint32_t i = 0U; i < 43U; i++) {
        if (stage9_init(&self, &refused[i]) != PTC_E_PARAM) {
            failures++;
        }
    }
    if (stage9_init(&self, NULL) != PTC_E_PARAM) {
        failures++;
    }
    if (stage9_init(NULL, &session->params) != PTC_E_PARAM) {
        failures++;
    }
    failures += stage9_selftest_calls_of(&self, session);
    return failures;
}

/* Calls that lack a pointer: each is refused, and changes nothing. */
static uint32_t stage9_selftest_pointers(void)
{
    const stage9_selftest_session *session = &stage9_selftest_sessions[0];
    const stage9_selftest_call *call = &stage9_selftest_calls[0];
    uint32_t failures = 0U;
    double u = 12345.0;
    double xhat[3];
    stage9 self;

    if (stage9_init(&self, &session->params) != PTC_OK) {
        failures++;
    }
    if (stage9_arm(NULL, call->start) != PTC_E_INPUT) {
        failures++;
    }
    if (stage9_step(NULL, call->k, call->y, &u) != PTC_E_INPUT) {
        failures++;
    }
    failures += stage9_selftest_differs(u, 0.0);
    u = 12345.0;
    if (stage9_step(&self, call->k, NULL, &u) != PTC_E_INPUT) {
        failures++;
    }
    failures += stage9_selftest_differs(u, 0.0);
    if (stage9_step(&self, call->k, call->y, NULL) != PTC_E_INPUT) {
        failures++;
    }
    if (stage9_estimate(NULL, xhat) != PTC_E_INPUT) {
        failures++;
    }
    if (stage9_estimate(&self, NULL) != PTC_E_INPUT) {
        failures++;
    }
    failures += stage9_selftest_calls_of(&self, session);
    return failures;
}

uint32_t stage9_selftest(void)
{
    uint32_t failures = stage9_selftest_run();

    failures += stage9_selftest_refuse();
    failures += stage9_selftest_pointers();
    return failures;
}
