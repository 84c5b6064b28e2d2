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
    {.is_armed = 0U, .start = 0U, .k = 0U, .y = {0.75}, .status = PTC_OK, .u = -10.499656505377999, .xhat = {0.75, 0.0, 0.0}},
    {.is_armed = 0U, .start = 0U, .k = 1U, .y = {0.7252083333333332}, .status = PTC_OK, .u = -18.24019918788813, .xhat = {0.7408133780332056, -0.06773946360153284, -0.1111621966794385}},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {0.7008333333333333}, .status = PTC_OK, .u = -22.8006163979338, .xhat = {0.7248676354828368, -0.18475475931257423, -0.4697736805727416}},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {(double)NAN}, .status = PTC_E_INPUT, .u = 0.0, .xhat = {0.7248676354828368, -0.18475475931257423, -0.4697736805727416}},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {(double)INFINITY}, .status = PTC_E_INPUT, .u = 0.0, .xhat = {0.7248676354828368, -0.18475475931257423, -0.4697736805727416}},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {-(double)INFINITY}, .status = PTC_E_INPUT, .u = 0.0, .xhat = {0.7248676354828368, -0.18475475931257423, -0.4697736805727416}},
    {.is_armed = 0U, .start = 0U, .k = 3U, .y = {0.676875}, .status = PTC_OK, .u = -24.059045262506366, .xhat = {0.7041434957784408, -0.33622243910390476, -1.0070450226034113}},
    {.is_armed = 0U, .start = 0U, .k = 15U, .y = {0.421875}, .status = PTC_OK, .u = 55.16634265903806, .xhat = {0.522281160325668, -3.1588110188641725, -11.333332113068064}},
    {.is_armed = 0U, .start = 0U, .k = 26U, .y = {0.2408333333333333}, .status = PTC_SATURATED, .u = 1000.0, .xhat = {0.2408333333333333, -25.48532515798554, -956.6263290283521}},
    {.is_armed = 0U, .start = 0U, .k = 28U, .y = {0.21333333333333332}, .status = PTC_SATURATED, .u = -1000.0, .xhat = {0.445979354716535, -13.837760646856932, 4716.367214037559}},
    {.is_armed = 0U, .start = 0U, .k = 29U, .y = {0.20020833333333338}, .status = PTC_SATURATED, .u = 1000.0, .xhat = {-0.08898085963384172, 26.927353903017092, -2318.7157287811797}},
    {.is_armed = 0U, .start = 0U, .k = 30U, .y = {0.1875}, .status = PTC_SATURATED, .u = 1000.0, .xhat = {0.25404283907144415, -1.819753777809514, -711.9629380869233}},
    {.is_armed = 0U, .start = 0U, .k = 31U, .y = {0.17520833333333333}, .status = PTC_SATURATED, .u = 1000.0, .xhat = {0.19232949134624694, -10.865400600013277, -278.90779986731553}},
    {.is_armed = 0U, .start = 0U, .k = 45U, .y = {0.046875}, .status = PTC_SATURATED, .u = -1000.0, .xhat = {0.07442698684629065, -11.952466163721155, 408.4608794327225}},
    {.is_armed = 0U, .start = 0U, .k = 56U, .y = {0.003333333333333333}, .status = PTC_SATURATED, .u = -1000.0, .xhat = {0.034435717529817236, -1.8936364162009953, 1182.3916274612816}},
    {.is_armed = 0U, .start = 0U, .k = 58U, .y = {0.0008333333333333333}, .status = PTC_SATURATED, .u = 1000.0, .xhat = {-0.06966626674220652, 8.402065298891271, -552.0807648566404}},
    {.is_armed = 0U, .start = 0U, .k = 59U, .y = {0.00020833333333333332}, .status = PTC_SATURATED, .u = 1000.0, .xhat = {0.0033682530409332766, 0.014866716374830002, -490.66391293801325}},
    {.is_armed = 0U, .start = 0U, .k = 60U, .y = {0.0}, .status = PTC_SATURATED, .u = -1000.0, .xhat = {0.026564603301849114, -4.49373194771316, 172.63141518325995}},
    {.is_armed = 0U, .start = 0U, .k = 61U, .y = {0.0}, .status = PTC_SATURATED, .u = -1000.0, .xhat = {0.010471843154576558, -0.4775136981659749, 443.56992447579296}},
    {.is_armed = 0U, .start = 0U, .k = 2147483647U, .y = {0.0}, .status = PTC_SATURATED, .u = 1000.0, .xhat = {-0.026976231564302296, 3.2481981662051735, -229.76129271100535}},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {0.0}, .status = PTC_SATURATED, .u = 1000.0, .xhat = {0.0023414765642801715, -0.19629502327226578, -188.29886409617455}},
    {.is_armed = 1U, .start = 4294967293U, .k = 4294967293U, .y = {0.75}, .status = PTC_SATURATED, .u = 1000.0, .xhat = {0.2549269867367153, -1.0421956155389414, -169.55414246182622}},
    {.is_armed = 0U, .start = 0U, .k = 4294967294U, .y = {0.7252083333333332}, .status = PTC_SATURATED, .u = 1000.0, .xhat = {0.4063131461560133, -2.1851263664926446, -151.65749952847264}},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {0.7008333333333333}, .status = PTC_SATURATED, .u = 1000.0, .xhat = {0.4867317700108599, -3.4172029980105307, -134.29937699217055}},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {(double)NAN}, .status = PTC_E_INPUT, .u = 0.0, .xhat = {0.4867317700108599, -3.4172029980105307, -134.29937699217055}},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {(double)INFINITY}, .status = PTC_E_INPUT, .u = 0.0, .xhat = {0.4867317700108599, -3.4172029980105307, -134.29937699217055}},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {-(double)INFINITY}, .status = PTC_E_INPUT, .u = 0.0, .xhat = {0.4867317700108599, -3.4172029980105307, -134.29937699217055}},
    {.is_armed = 0U, .start = 0U, .k = 0U, .y = {0.676875}, .status = PTC_SATURATED, .u = 1000.0, .xhat = {0.5198795065104744, -4.576581078907341, -117.22196921953793}},
    {.is_armed = 0U, .start = 0U, .k = 12U, .y = {0.421875}, .status = PTC_SATURATED, .u = 1000.0, .xhat = {0.42652469550897454, -6.415957350040528, -102.05866989359271}},
    {.is_armed = 0U, .start = 0U, .k = 23U, .y = {0.2408333333333333}, .status = PTC_SATURATED, .u = 1000.0, .xhat = {0.2408333333333333, -14.956023616863144, -387.97905068229585}},
    {.is_armed = 0U, .start = 0U, .k = 25U, .y = {0.21333333333333332}, .status = PTC_SATURATED, .u = -1000.0, .xhat = {0.33404171997011967, -7.100881784212728, 2570.631375890779}},
    {.is_armed = 0U, .start = 0U, .k = 26U, .y = {0.20020833333333338}, .status = PTC_SATURATED, .u = 1000.0, .xhat = {0.039216764986048314, 14.788267394033845, -1338.8713857192147}},
    {.is_armed = 0U, .start = 0U, .k = 27U, .y = {0.1875}, .status = PTC_SATURATED, .u = 1000.0, .xhat = {0.22629692169428234, -1.8197344124109067, -408.59048536337934}},
    {.is_armed = 0U, .start = 0U, .k = 28U, .y = {0.17520833333333333}, .status = PTC_SATURATED, .u = 1000.0, .xhat = {0.18789698540042957, -6.631758768902713, -83.60406353703331}},
    {.is_armed = 0U, .start = 0U, .k = 42U, .y = {0.046875}, .status = PTC_SATURATED, .u = 1000.0, .xhat = {0.033592040218509985, -9.334054495624859, -391.83027344764673}},
    {.is_armed = 0U, .start = 0U, .k = 53U, .y = {0.003333333333333333}, .status = PTC_SATURATED, .u = -1000.0, .xhat = {0.08102424398832245, -6.455370988031305, 1517.9731196644673}},
    {.is_armed = 0U, .start = 0U, .k = 55U, .y = {0.0008333333333333333}, .status = PTC_SATURATED, .u = 1000.0, .xhat = {-0.07804122288261123, 8.370794323118059, -389.43867950522645}},
    {.is_armed = 0U, .start = 0U, .k = 56U, .y = {0.00020833333333333332}, .status = PTC_SATURATED, .u = 1000.0, .xhat = {-0.0018770720954392282, 1.9254125943463172, -455.9078499591098}},
    {.is_armed = 0U, .start = 0U, .k = 57U, .y = {0.0}, .status = PTC_SATURATED, .u = 1000.0, .xhat = {0.012795458047377185, -3.613739186207383, -128.3173966135331}},
    {.is_armed = 0U, .start = 0U, .k = 58U, .y = {0.0}, .status = PTC_SATURATED, .u = -1000.0, .xhat = {0.028014562496124988, -2.294963910522414, 570.3293175777039}},
    {.is_armed = 0U, .start = 0U, .k = 2147483644U, .y = {0.0}, .status = PTC_SATURATED, .u = 1000.0, .xhat = {-0.029787455868754767, 3.334221318414383, -140.29222550812585}},
    {.is_armed = 0U, .start = 0U, .k = 4294967292U, .y = {0.0}, .status = PTC_SATURATED, .u = 1000.0, .xhat = {-0.0021708528281849243, 0.7719875162716399, -208.84468493815825}},
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
