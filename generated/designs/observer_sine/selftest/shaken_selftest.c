/* Self-test of the prescribed-time controller shaken: see shaken_selftest.h. DO NOT EDIT. */
#include "shaken_selftest.h"
#include "shaken.h"

#include <math.h>
#include <stddef.h>

/* A call, and what it must give. */
typedef struct shaken_selftest_call {
    uint32_t is_armed; /* arm is called before it */
    uint32_t start;
    uint32_t k;
    double y[1]; /* what is measured */
    ptc_status status;
    double u;
    double xhat[2]; /* the estimates behind it */
    double d;
} shaken_selftest_call;

/* A set of parameters that init takes, and the calls with it, one after the other. */
typedef struct shaken_selftest_session {
    shaken_params params;
    uint32_t first; /* of its calls */
    uint32_t count;
} shaken_selftest_session;

static const shaken_selftest_session shaken_selftest_sessions[4] = {
    {.params = {.none = (char)0}, .first = 0U, .count = 42U},
    {.params = {.none = (char)0}, .first = 42U, .count = 2U},
    {.params = {.none = (char)0}, .first = 44U, .count = 2U},
    {.params = {.none = (char)0}, .first = 46U, .count = 2U},
};

static const shaken_selftest_call shaken_selftest_calls[48] = {
    {.is_armed = 0U, .start = 0U, .k = 0U, .y = {0.75}, .status = PTC_SATURATED, .u = -8.0, .xhat = {0.75, 0.0}, .d = 0.0},
    {.is_armed = 0U, .start = 0U, .k = 1U, .y = {0.7475020833333332}, .status = PTC_SATURATED, .u = -8.0, .xhat = {0.7498036961142516, 0.004120812250579729}, .d = 0.33793511242916846},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {0.7450083333333334}, .status = PTC_SATURATED, .u = -8.0, .xhat = {0.7494286272589751, 0.008615199489182442}, .d = 0.9820752130666309},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {(double)NAN}, .status = PTC_E_INPUT, .u = 0.0, .xhat = {0.7494286272589751, 0.008615199489182442}, .d = 0.9820752130666309},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {(double)INFINITY}, .status = PTC_E_INPUT, .u = 0.0, .xhat = {0.7494286272589751, 0.008615199489182442}, .d = 0.9820752130666309},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {-(double)INFINITY}, .status = PTC_E_INPUT, .u = 0.0, .xhat = {0.7494286272589751, 0.008615199489182442}, .d = 0.9820752130666309},
    {.is_armed = 0U, .start = 0U, .k = 3U, .y = {0.74251875}, .status = PTC_SATURATED, .u = -8.0, .xhat = {0.7488816790986687, 0.00569296568228634}, .d = 1.9009629033434698},
    {.is_armed = 0U, .start = 0U, .k = 100U, .y = {0.5208333333333334}, .status = PTC_SATURATED, .u = -8.0, .xhat = {0.7140296126905495, -0.8738513181643698}, .d = 53.35643727703216},
    {.is_armed = 0U, .start = 0U, .k = 196U, .y = {0.3400333333333333}, .status = PTC_SATURATED, .u = 8.0, .xhat = {0.5436044155197992, -28.46244368951776}, .d = -361.89328050029036},
    {.is_armed = 0U, .start = 0U, .k = 198U, .y = {0.33667500000000006}, .status = PTC_SATURATED, .u = 8.0, .xhat = {0.4338387899997358, -42.36942422240013}, .d = -515.8264129230374},
    {.is_armed = 0U, .start = 0U, .k = 199U, .y = {0.33500208333333337}, .status = PTC_SATURATED, .u = 8.0, .xhat = {0.3655330460173627, -47.49389458066976}, .d = -511.3706512959015},
    {.is_armed = 0U, .start = 0U, .k = 200U, .y = {0.3333333333333333}, .status = PTC_SATURATED, .u = 8.0, .xhat = {0.3247290195764327, -47.25582650275788}, .d = -418.64471552597246},
    {.is_armed = 0U, .start = 0U, .k = 201U, .y = {0.33166875}, .status = PTC_SATURATED, .u = 8.0, .xhat = {0.30189347192462884, -43.95379301561903}, .d = -282.8686104347031},
    {.is_armed = 0U, .start = 0U, .k = 400U, .y = {0.08333333333333333}, .status = PTC_SATURATED, .u = 8.0, .xhat = {0.17844742504522726, -57.36720653729958}, .d = -407.8531405836356},
    {.is_armed = 0U, .start = 0U, .k = 596U, .y = {3.333333333333334e-5}, .status = PTC_SATURATED, .u = 8.0, .xhat = {0.0658652756080196, -67.02779387599105}, .d = -451.7051386618017},
    {.is_armed = 0U, .start = 0U, .k = 598U, .y = {8.333333333333335e-6}, .status = PTC_SATURATED, .u = 8.0, .xhat = {-0.0008532016939175303, -67.69212966520398}, .d = -343.77598561426606},
    {.is_armed = 0U, .start = 0U, .k = 599U, .y = {2.083333333333334e-6}, .status = PTC_SATURATED, .u = 8.0, .xhat = {-0.03755568655101453, -63.14968749029754}, .d = -159.68528589940638},
    {.is_armed = 0U, .start = 0U, .k = 600U, .y = {0.0}, .status = PTC_SATURATED, .u = 8.0, .xhat = {-0.05500146615697588, -55.87425507162997}, .d = 52.8877180605913},
    {.is_armed = 0U, .start = 0U, .k = 601U, .y = {0.0}, .status = PTC_SATURATED, .u = 8.0, .xhat = {-0.06043571591774534, -47.446229334614884}, .d = 264.9798480471155},
    {.is_armed = 0U, .start = 0U, .k = 2147483647U, .y = {0.0}, .status = PTC_SATURATED, .u = 8.0, .xhat = {-0.05868926787514986, -38.8448641345869}, .d = 460.0041109620157},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {0.0}, .status = PTC_SATURATED, .u = 8.0, .xhat = {-0.05294041430892416, -30.648874934318627}, .d = 629.4296182939372},
    {.is_armed = 1U, .start = 4294967293U, .k = 4294967293U, .y = {0.75}, .status = PTC_SATURATED, .u = -8.0, .xhat = {-0.017797548346408273, -30.71546432480613}, .d = 565.0698702347614},
    {.is_armed = 0U, .start = 0U, .k = 4294967294U, .y = {0.7475020833333332}, .status = PTC_SATURATED, .u = -8.0, .xhat = {0.014586429381039663, -30.833086997284695}, .d = 505.5569503505634},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {0.7450083333333334}, .status = PTC_SATURATED, .u = -8.0, .xhat = {0.04436036521182915, -31.005736901778477}, .d = 450.63306657983867},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {(double)NAN}, .status = PTC_E_INPUT, .u = 0.0, .xhat = {0.04436036521182915, -31.005736901778477}, .d = 450.63306657983867},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {(double)INFINITY}, .status = PTC_E_INPUT, .u = 0.0, .xhat = {0.04436036521182915, -31.005736901778477}, .d = 450.63306657983867},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {-(double)INFINITY}, .status = PTC_E_INPUT, .u = 0.0, .xhat = {0.04436036521182915, -31.005736901778477}, .d = 450.63306657983867},
    {.is_armed = 0U, .start = 0U, .k = 0U, .y = {0.74251875}, .status = PTC_SATURATED, .u = -8.0, .xhat = {0.07164832291646792, -31.245583408249264}, .d = 400.0470467420956},
    {.is_armed = 0U, .start = 0U, .k = 97U, .y = {0.5208333333333334}, .status = PTC_SATURATED, .u = -8.0, .xhat = {0.11417119371175824, -28.586263884382728}, .d = 341.01385556124666},
    {.is_armed = 0U, .start = 0U, .k = 193U, .y = {0.3400333333333333}, .status = PTC_SATURATED, .u = -8.0, .xhat = {0.20141627373378157, -9.026731044854081}, .d = 669.4454645478233},
    {.is_armed = 0U, .start = 0U, .k = 195U, .y = {0.33667500000000006}, .status = PTC_SATURATED, .u = -8.0, .xhat = {0.25832767840516313, 2.963461986660805}, .d = 843.3568992325197},
    {.is_armed = 0U, .start = 0U, .k = 196U, .y = {0.33500208333333337}, .status = PTC_SATURATED, .u = -8.0, .xhat = {0.2952460249809864, 10.03481097466522}, .d = 918.9952492992434},
    {.is_armed = 0U, .start = 0U, .k = 197U, .y = {0.3333333333333333}, .status = PTC_SATURATED, .u = -8.0, .xhat = {0.31852408322919684, 13.853762515231264}, .d = 932.0206247666551},
    {.is_armed = 0U, .start = 0U, .k = 198U, .y = {0.33166875}, .status = PTC_SATURATED, .u = -8.0, .xhat = {0.3325554883398561, 15.558070666478356}, .d = 906.4952794377318},
    {.is_armed = 0U, .start = 0U, .k = 397U, .y = {0.08333333333333333}, .status = PTC_SATURATED, .u = -8.0, .xhat = {0.22826190078440017, -2.377954589245938}, .d = 583.0932699052554},
    {.is_armed = 0U, .start = 0U, .k = 593U, .y = {3.333333333333334e-5}, .status = PTC_SATURATED, .u = -8.0, .xhat = {0.12355359699857567, -18.02198756980068}, .d = 331.478817616468},
    {.is_armed = 0U, .start = 0U, .k = 595U, .y = {8.333333333333335e-6}, .status = PTC_SATURATED, .u = 8.0, .xhat = {0.05775466438335815, -25.201300355130588}, .d = 238.91480151485607},
    {.is_armed = 0U, .start = 0U, .k = 596U, .y = {2.083333333333334e-6}, .status = PTC_SATURATED, .u = 8.0, .xhat = {0.017892179011276474, -27.13519196582839}, .d = 239.04323481797718},
    {.is_armed = 0U, .start = 0U, .k = 597U, .y = {0.0}, .status = PTC_SATURATED, .u = 8.0, .xhat = {-0.004908430219023388, -25.957928584419932}, .d = 288.6832377229657},
    {.is_armed = 0U, .start = 0U, .k = 598U, .y = {0.0}, .status = PTC_SATURATED, .u = 8.0, .xhat = {-0.016669520776778537, -23.060190945230246}, .d = 360.33626461419874},
    {.is_armed = 0U, .start = 0U, .k = 2147483644U, .y = {0.0}, .status = PTC_SATURATED, .u = 8.0, .xhat = {-0.021466430123724973, -19.371598192990852}, .d = 437.0511098908015},
    {.is_armed = 0U, .start = 0U, .k = 4294967292U, .y = {0.0}, .status = PTC_SATURATED, .u = 8.0, .xhat = {-0.022030274284964547, -15.458889432008142}, .d = 508.8929062537253},
    {.is_armed = 0U, .start = 0U, .k = 7U, .y = {-0.3752762418554133}, .status = PTC_OK, .u = 6.413955184165717, .xhat = {-0.3752762418554133, 0.0}, .d = 0.0},
    {.is_armed = 0U, .start = 0U, .k = 94U, .y = {6.260933143287877e301}, .status = PTC_E_RANGE, .u = 0.0, .xhat = {-0.3752762418554133, 0.0}, .d = 0.0},
    {.is_armed = 0U, .start = 0U, .k = 108U, .y = {7.1200186866681e153}, .status = PTC_SATURATED, .u = -8.0, .xhat = {7.1200186866681e153, 0.0}, .d = 0.0},
    {.is_armed = 1U, .start = 4294967290U, .k = 503U, .y = {8.967500654424333e153}, .status = PTC_SATURATED, .u = -8.0, .xhat = {8.967500654424333e153, 0.0}, .d = 0.0},
    {.is_armed = 0U, .start = 0U, .k = 500U, .y = {0.0}, .status = PTC_OK, .u = -0.0, .xhat = {0.0, 0.0}, .d = 0.0},
    {.is_armed = 1U, .start = 0U, .k = 592U, .y = {-0.0}, .status = PTC_HOLD, .u = -0.0, .xhat = {0.0, 0.0}, .d = 0.0},
};

/* 1 where a number is not the one that must come. */
static uint32_t shaken_selftest_differs(double value, double wanted)
{
    uint32_t failures = 1U;

    if (fabs(value - wanted) <= 0.0) {
        failures = 0U;
    }
    return failures;
}

/* The failures of one call. */
static uint32_t shaken_selftest_check(shaken *self, const shaken_selftest_call *call)
{
    uint32_t failures = 0U;
    double u = 12345.0;
    double xhat[2] = {12345.0, 12345.0};
    double d = 12345.0;

    if (call->is_armed != 0U) {
        if (shaken_arm(self, call->start) != PTC_OK) {
            failures++;
        }
    }
    if (shaken_step(self, call->k, call->y, &u) != call->status) {
        failures++;
    }
    failures += shaken_selftest_differs(u, call->u);
    if (shaken_estimate(self, xhat) != PTC_OK) {
        failures++;
    }
    for (uint32_t i = 0U; i < 2U; i++) {
        failures += shaken_selftest_differs(xhat[i], call->xhat[i]);
    }
    if (shaken_disturbance(self, &d) != PTC_OK) {
        failures++;
    }
    failures += shaken_selftest_differs(d, call->d);
    return failures;
}

/* The calls of a session, of which init has been called. */
static uint32_t shaken_selftest_calls_of(shaken *self, const shaken_selftest_session *session)
{
    uint32_t failures = 0U;

    for (uint32_t j = 0U; j < session->count; j++) {
        failures += shaken_selftest_check(self, &shaken_selftest_calls[session->first + j]);
    }
    return failures;
}

/* Every session with its calls. */
static uint32_t shaken_selftest_run(void)
{
    uint32_t failures = 0U;

    for (uint32_t i = 0U; i < 4U; i++) {
        const shaken_selftest_session *session = &shaken_selftest_sessions[i];
        shaken self;

        if (shaken_init(&self, &session->params) == PTC_OK) {
            failures += shaken_selftest_calls_of(&self, session);
        } else {
            failures++;
        }
    }
    return failures;
}

/* What init must refuse without a change. */
static uint32_t shaken_selftest_refuse(void)
{
    const shaken_selftest_session *session = &shaken_selftest_sessions[0];
    uint32_t failures = 0U;
    shaken self;

    if (shaken_init(&self, &session->params) != PTC_OK) {
        failures++;
    }
    if (shaken_init(NULL, &session->params) != PTC_E_PARAM) {
        failures++;
    }
    failures += shaken_selftest_calls_of(&self, session);
    return failures;
}

/* Calls that lack a pointer: each is refused, and changes nothing. */
static uint32_t shaken_selftest_pointers(void)
{
    const shaken_selftest_session *session = &shaken_selftest_sessions[0];
    const shaken_selftest_call *call = &shaken_selftest_calls[0];
    uint32_t failures = 0U;
    double u = 12345.0;
    double xhat[2];
    double d;
    shaken self;

    if (shaken_init(&self, &session->params) != PTC_OK) {
        failures++;
    }
    if (shaken_arm(NULL, call->start) != PTC_E_INPUT) {
        failures++;
    }
    if (shaken_step(NULL, call->k, call->y, &u) != PTC_E_INPUT) {
        failures++;
    }
    failures += shaken_selftest_differs(u, 0.0);
    u = 12345.0;
    if (shaken_step(&self, call->k, NULL, &u) != PTC_E_INPUT) {
        failures++;
    }
    failures += shaken_selftest_differs(u, 0.0);
    if (shaken_step(&self, call->k, call->y, NULL) != PTC_E_INPUT) {
        failures++;
    }
    if (shaken_estimate(NULL, xhat) != PTC_E_INPUT) {
        failures++;
    }
    if (shaken_estimate(&self, NULL) != PTC_E_INPUT) {
        failures++;
    }
    if (shaken_disturbance(NULL, &d) != PTC_E_INPUT) {
        failures++;
    }
    if (shaken_disturbance(&self, NULL) != PTC_E_INPUT) {
        failures++;
    }
    failures += shaken_selftest_calls_of(&self, session);
    return failures;
}

uint32_t shaken_selftest(void)
{
    uint32_t failures = shaken_selftest_run();

    failures += shaken_selftest_refuse();
    failures += shaken_selftest_pointers();
    return failures;
}
