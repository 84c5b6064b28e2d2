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

static const stage_selftest_session stage_selftest_sessions[4] = {
    {.params = {.none = (char)0}, .first = 0U, .count = 42U},
    {.params = {.none = (char)0}, .first = 42U, .count = 1U},
    {.params = {.none = (char)0}, .first = 43U, .count = 2U},
    {.params = {.none = (char)0}, .first = 45U, .count = 2U},
};

static const stage_selftest_call stage_selftest_calls[47] = {
    {.is_armed = 0U, .start = 0U, .k = 0U, .y = {0.75}, .status = PTC_SATURATED, .u = -6.0, .xhat = {0.75, 0.0}, .d = 0.0},
    {.is_armed = 0U, .start = 0U, .k = 1U, .y = {0.7481261718750001}, .status = PTC_SATURATED, .u = -6.0, .xhat = {0.7498887115858045, -0.0017033497552366565}, .d = -0.008690559975697227},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {0.7462546875}, .status = PTC_SATURATED, .u = -6.0, .xhat = {0.7496683252269476, -0.009042595985564249}, .d = -0.025785188302246603},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {(double)NAN}, .status = PTC_E_INPUT, .u = 0.0, .xhat = {0.7496683252269476, -0.009042595985564249}, .d = -0.025785188302246603},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {(double)INFINITY}, .status = PTC_E_INPUT, .u = 0.0, .xhat = {0.7496683252269476, -0.009042595985564249}, .d = -0.025785188302246603},
    {.is_armed = 0U, .start = 0U, .k = 2U, .y = {-(double)INFINITY}, .status = PTC_E_INPUT, .u = 0.0, .xhat = {0.7496683252269476, -0.009042595985564249}, .d = -0.025785188302246603},
    {.is_armed = 0U, .start = 0U, .k = 3U, .y = {0.744385546875}, .status = PTC_SATURATED, .u = -6.0, .xhat = {0.7493410519046292, -0.017949689142669003}, .d = -0.05099087403198849},
    {.is_armed = 0U, .start = 0U, .k = 100U, .y = {0.57421875}, .status = PTC_OK, .u = -1.1832967717711478, .xhat = {0.7289412092209236, -0.6522221437710192}, .d = -6.548294592715791},
    {.is_armed = 0U, .start = 0U, .k = 196U, .y = {0.42751875}, .status = PTC_SATURATED, .u = 6.0, .xhat = {0.6201275532541749, -12.661597722413468}, .d = -451.0301482561963},
    {.is_armed = 0U, .start = 0U, .k = 198U, .y = {0.42469218749999993}, .status = PTC_SATURATED, .u = 6.0, .xhat = {0.5416428965058018, -20.250002144332072}, .d = -720.9163998080467},
    {.is_armed = 0U, .start = 0U, .k = 199U, .y = {0.423282421875}, .status = PTC_SATURATED, .u = 6.0, .xhat = {0.48595917907984093, -24.631857180300603}, .d = -865.5550702807566},
    {.is_armed = 0U, .start = 0U, .k = 200U, .y = {0.421875}, .status = PTC_SATURATED, .u = 6.0, .xhat = {0.446956549066805, -26.767667335675878}, .d = -923.4355681272297},
    {.is_armed = 0U, .start = 0U, .k = 201U, .y = {0.4204699218750001}, .status = PTC_SATURATED, .u = 6.0, .xhat = {0.4200941053233314, -27.355874785695185}, .d = -922.5682991618404},
    {.is_armed = 0U, .start = 0U, .k = 500U, .y = {0.10546875}, .status = PTC_SATURATED, .u = 6.0, .xhat = {0.2892387722180412, -39.41720631820923}, .d = -1346.6529658188585},
    {.is_armed = 0U, .start = 0U, .k = 796U, .y = {1.8750000000000002e-5}, .status = PTC_SATURATED, .u = 6.0, .xhat = {0.15970481455727095, -50.260645138349204}, .d = -1715.15926864333},
    {.is_armed = 0U, .start = 0U, .k = 798U, .y = {4.6875000000000004e-6}, .status = PTC_SATURATED, .u = 6.0, .xhat = {0.06972423962390123, -55.74414905234424}, .d = -1876.05054277541},
    {.is_armed = 0U, .start = 0U, .k = 799U, .y = {1.1718750000000001e-6}, .status = PTC_SATURATED, .u = 6.0, .xhat = {0.008553999003237148, -57.523756335261595}, .d = -1895.787836148265},
    {.is_armed = 0U, .start = 0U, .k = 800U, .y = {0.0}, .status = PTC_SATURATED, .u = 6.0, .xhat = {-0.031763346105400346, -56.80451409689576}, .d = -1822.487806674264},
    {.is_armed = 0U, .start = 0U, .k = 801U, .y = {0.0}, .status = PTC_SATURATED, .u = 6.0, .xhat = {-0.057106090137542094, -54.45735727482662}, .d = -1690.7045217414745},
    {.is_armed = 0U, .start = 0U, .k = 2147483647U, .y = {0.0}, .status = PTC_SATURATED, .u = 6.0, .xhat = {-0.07180419717348144, -51.106539798768125}, .d = -1525.0025282642096},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {0.0}, .status = PTC_SATURATED, .u = 6.0, .xhat = {-0.07903556280435414, -47.19468462236528}, .d = -1342.6127679464691},
    {.is_armed = 1U, .start = 4294967293U, .k = 4294967293U, .y = {0.75}, .status = PTC_SATURATED, .u = 6.0, .xhat = {-0.07486554104394366, -47.296791643626875}, .d = -1338.607853442056},
    {.is_armed = 0U, .start = 0U, .k = 4294967294U, .y = {0.7481261718750001}, .status = PTC_SATURATED, .u = 6.0, .xhat = {-0.07089290112657042, -47.39368226600707}, .d = -1334.5695135785465},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {0.7462546875}, .status = PTC_SATURATED, .u = 6.0, .xhat = {-0.0671017681285496, -47.485144289296954}, .d = -1330.4964316002774},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {(double)NAN}, .status = PTC_E_INPUT, .u = 0.0, .xhat = {-0.0671017681285496, -47.485144289296954}, .d = -1330.4964316002774},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {(double)INFINITY}, .status = PTC_E_INPUT, .u = 0.0, .xhat = {-0.0671017681285496, -47.485144289296954}, .d = -1330.4964316002774},
    {.is_armed = 0U, .start = 0U, .k = 4294967295U, .y = {-(double)INFINITY}, .status = PTC_E_INPUT, .u = 0.0, .xhat = {-0.0671017681285496, -47.485144289296954}, .d = -1330.4964316002774},
    {.is_armed = 0U, .start = 0U, .k = 0U, .y = {0.744385546875}, .status = PTC_SATURATED, .u = 6.0, .xhat = {-0.06347685987146916, -47.57097415284535}, .d = -1326.3873194481205},
    {.is_armed = 0U, .start = 0U, .k = 97U, .y = {0.57421875}, .status = PTC_SATURATED, .u = 6.0, .xhat = {-0.03167967407005755, -45.9831970717964}, .d = -1300.94365662323},
    {.is_armed = 0U, .start = 0U, .k = 193U, .y = {0.42751875}, .status = PTC_SATURATED, .u = 6.0, .xhat = {0.10372700136176673, -26.671776196957868}, .d = -553.7319289965378},
    {.is_armed = 0U, .start = 0U, .k = 195U, .y = {0.42469218749999993}, .status = PTC_SATURATED, .u = 6.0, .xhat = {0.2019506103875302, -13.158417165435008}, .d = -39.712904890838445},
    {.is_armed = 0U, .start = 0U, .k = 196U, .y = {0.423282421875}, .status = PTC_SATURATED, .u = -6.0, .xhat = {0.27310906907981336, -3.823937376585219}, .d = 306.84098617497693},
    {.is_armed = 0U, .start = 0U, .k = 197U, .y = {0.421875}, .status = PTC_SATURATED, .u = -6.0, .xhat = {0.324224130857901, 2.469023588949393}, .d = 532.1891457336669},
    {.is_armed = 0U, .start = 0U, .k = 198U, .y = {0.4204699218750001}, .status = PTC_SATURATED, .u = -6.0, .xhat = {0.3605281571655863, 6.554649384666082}, .d = 670.5162950630834},
    {.is_armed = 0U, .start = 0U, .k = 497U, .y = {0.10546875}, .status = PTC_SATURATED, .u = -6.0, .xhat = {0.2731466960968089, -3.4499656241443146}, .d = 283.567188685832},
    {.is_armed = 0U, .start = 0U, .k = 793U, .y = {1.8750000000000002e-5}, .status = PTC_SATURATED, .u = -6.0, .xhat = {0.1727781853347592, -14.029162571775935}, .d = -115.1084313174585},
    {.is_armed = 0U, .start = 0U, .k = 795U, .y = {4.6875000000000004e-6}, .status = PTC_SATURATED, .u = 6.0, .xhat = {0.10163776903775401, -20.442424298724553}, .d = -349.6463117891986},
    {.is_armed = 0U, .start = 0U, .k = 796U, .y = {1.1718750000000001e-6}, .status = PTC_SATURATED, .u = 6.0, .xhat = {0.051921522279661556, -23.914559057438574}, .d = -469.4625050307253},
    {.is_armed = 0U, .start = 0U, .k = 797U, .y = {0.0}, .status = PTC_SATURATED, .u = 6.0, .xhat = {0.01783656080626103, -25.334889003336347}, .d = -510.62379919902},
    {.is_armed = 0U, .start = 0U, .k = 798U, .y = {0.0}, .status = PTC_SATURATED, .u = 6.0, .xhat = {-0.004909604418317316, -25.365398748020024}, .d = -499.293942849057},
    {.is_armed = 0U, .start = 0U, .k = 2147483644U, .y = {0.0}, .status = PTC_SATURATED, .u = 6.0, .xhat = {-0.019493233903845553, -24.479682956423375}, .d = -454.3095569171057},
    {.is_armed = 0U, .start = 0U, .k = 4294967292U, .y = {0.0}, .status = PTC_SATURATED, .u = 6.0, .xhat = {-0.028255694282272748, -23.01800888908804}, .d = -389.10410857339934},
    {.is_armed = 0U, .start = 0U, .k = 94U, .y = {6.260933143287877e301}, .status = PTC_E_RANGE, .u = 0.0, .xhat = {0.0, 0.0}, .d = 0.0},
    {.is_armed = 0U, .start = 0U, .k = 108U, .y = {7.1200186866681e153}, .status = PTC_SATURATED, .u = -6.0, .xhat = {7.1200186866681e153, 0.0}, .d = 0.0},
    {.is_armed = 1U, .start = 4294967290U, .k = 703U, .y = {8.967500654424333e153}, .status = PTC_SATURATED, .u = -6.0, .xhat = {8.967500654424333e153, 0.0}, .d = 0.0},
    {.is_armed = 0U, .start = 0U, .k = 700U, .y = {0.0}, .status = PTC_OK, .u = -0.0, .xhat = {0.0, 0.0}, .d = 0.0},
    {.is_armed = 1U, .start = 0U, .k = 792U, .y = {-0.0}, .status = PTC_HOLD, .u = -0.0, .xhat = {0.0, 0.0}, .d = 0.0},
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

    for (uint32_t i = 0U; i < 4U; i++) {
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
